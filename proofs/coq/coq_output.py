"""What Coq's programs print, read line by line: a line that is not understood is a refusal.

Imports nothing beyond the standard library.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from source_rules import ELSEWHERE, LIBRARY

AXIOMS = {
    "ClassicalDedekindReals.sig_not_dec": "forall P : Prop, {~ ~ P} + {~ P}",
    "ClassicalDedekindReals.sig_forall_dec": "forall P : nat -> Prop, (forall n : nat, {P n} + {~ P n}) -> "
    "{n : nat | ~ P n} + {forall n : nat, P n}",
    "FunctionalExtensionality.functional_extensionality_dep": "forall (A : Type) (B : A -> Type) "
    "(f g : forall x : A, B x), (forall x : A, f x = g x) -> f = g",
    "Classical_Prop.classic": "forall P : Prop, P \\/ ~ P",
}
"""Those of Coq's classical reals, on which Coquelicot stands, as Coq prints them; no other may be used."""
WIDE = "Set Printing Width 10000.\n"
"""Before what is printed: an axiom on one line."""
CLOSED = "Closed under the global context"
SUMMARY = re.compile(
    r"\n?CONTEXT SUMMARY\n=+\n\n\* Theory: Set is predicative\n *\n\* Axioms:((?:\n +[\w.]+)+| <none>)\n *\n"
    r"\* Constants/Inductives relying on type-in-type: <none>\n *\n"
    r"\* Constants/Inductives relying on unsafe \(co\)fixpoints: <none>\n *\n"
    r"\* Inductives whose positivity is assumed: <none>\n\s*"
)


def axioms_printed(text: str, names: Sequence[str]) -> dict[str, list[str]]:
    """The axioms of each name, in what ``Print Assumptions`` printed for these names, one after the other.

    :raises RuntimeError: a line is not understood, or an axiom is none of the four; more or fewer answers than names.
    """
    known = {f"{name} : {what}": name for name, what in AXIOMS.items()}
    answers: list[list[str] | None] = []
    for line in text.splitlines():
        if line in (CLOSED, "Axioms:"):
            answers.append([] if line == "Axioms:" else None)
            continue
        last = answers[-1] if answers else None
        if line not in known or last is None or known[line] in last:
            raise RuntimeError(f"What Coq prints of its assumptions is not understood: {line}")
        last.append(known[line])
    if len(answers) != len(names) or [] in answers:
        raise RuntimeError(f"Coq printed the assumptions of {len(answers)} theorems, asked for {len(names)}")
    return {name: sorted(answer or []) for name, answer in zip(names, answers, strict=True)}


def kernel_accepts(summary: str) -> bool:
    """Whether coqchk's summary names no axiom but the four, and nothing that it takes on trust."""
    said = SUMMARY.fullmatch(summary)
    known = {f"Coq.{place}.{axiom}" for place in ("Logic", "Reals") for axiom in AXIOMS}
    return said is not None and set(said[1].split()) <= known | {"<none>"}


def strange_references(glob: str, read: Iterable[str], believed: dict[str, set[str]]) -> list[str]:
    """The names in a file of statements that Coq found where no reader of the statements looks.

    :param glob: what Coq noted of the file: for each name the library where it found it.
    :param read: the files that are read by who wants to know what is stated.
    :param believed: names that need not be read, by file.
    """
    strange = set()
    allowed = {f"{LIBRARY}.{file}" for file in read}
    # Newer versions note the induction principles that Coq itself makes of a definition.
    defined = re.findall(r"^(?:ind|rec) \S+ \S+ (\w+)$", glob, re.MULTILINE)
    made = {f"{name}_{sort}" for name in defined for sort in ("ind", "sind", "rec", "rect")}
    for line in glob.splitlines():
        kind, *words = line.split()
        if kind.startswith("R"):
            library, name = words[0], words[2]
            file = library.removeprefix(f"{LIBRARY}.")
            if not (
                library in allowed
                or library.partition(".")[0] in ELSEWHERE
                or (file != library and name in {"<>", *believed.get(file, ())} and file in believed)
            ):
                strange.add(f"{library}: {name}")
        elif not re.fullmatch(r"DIGEST|F[\w.]+|def|binder|ind|constr|rec|proj", kind) and not (
            kind == "scheme" and words[-1] in made
        ):
            strange.add(line)
    return sorted(strange)
