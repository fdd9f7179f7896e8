"""The page for a referee: the paper's claims that a formal theorem carries or contradicts, each beside the theorem.

``python docs/extensions/referee.py`` writes ``proofs/coq/referee.md``; a test compares it. The claims are those of
``paper/claims.toml``, the theorems those of ``paper/checks/formal_routes.py``, their texts and the definitions that
they use those of the files of statements.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path

from gspot_verified.paper.checks.formal_proof import COQ, stated_in, statement_of
from gspot_verified.paper.checks.formal_routes import CARRIED, CONTRADICTED
from gspot_verified.paper.claims import PaperClaim, paper_claims

PAGE = COQ / "referee.md"
LONGEST = 400
"""Lines that a referee reads."""
_DEFINITION = re.compile(
    r"(?P<text>(?:^\(\*\*(?:(?!\*\)).)*\*\)\n)?^(?:Definition|Fixpoint|Record|Inductive) (?P<name>\w+)\b.*?\.)$"
    r"(?=\n\n|\n\(\*|\n(?:Definition|Fixpoint|Record|Inductive) |\n?\Z)",
    re.MULTILINE | re.DOTALL,
)
_HEAD = """# The paper's claims beside the formal statements

Written by `docs/extensions/referee.py`. First come the claims of the paper that theorems carry or contradict, each with
the lines of the paper's source and the theorems; at the end every definition that these use, but those of Coq and
Coquelicot.

- A condition in brackets is needed, and is not in the paper's words.
- A name in brackets is an entry of the ledger: the theorems prove this entry, a part of the claim and not the whole.
- "Not as printed": the theorems contradict the claim.

`make prove` compiles the proofs and prints the axioms. [README.md](README.md) says what must be believed, and lists the
other theorems; the statements are pinned in [statements.txt](statements.txt).
"""


@cache
def definitions() -> dict[str, str]:
    """Every definition of the files of statements with the comment before it, in the order of the files."""
    found = {}
    for file in stated_in():
        for match in _DEFINITION.finditer((COQ / file).read_text(encoding="utf-8")):
            found[match["name"]] = match["text"]
    return found


def used(texts: Iterable[str]) -> list[str]:
    """The names of the definitions that texts use, and those that these use in turn, in the order of the files."""
    known, names, waiting = definitions(), set(), [*texts]
    while waiting:
        code = re.sub(r"\(\*.*?\*\)", " ", waiting.pop(), flags=re.DOTALL)
        fresh = ({*re.findall(r"[\w']+", code)} & known.keys()) - names
        names |= fresh
        waiting += [known[name] for name in fresh]
    return [name for name in known if name in names]


def groups() -> Iterator[tuple[tuple[str, ...], list[str]]]:
    """The theorems and the lines on their claims: each family of theorems once, in the order of the paper.

    :raises ValueError: theorems carry an entry that no claim of the paper has.
    """
    routes = CARRIED | {entry: names for entry, (names, _) in CONTRADICTED.items()}
    rows: dict[tuple[str, ...], list[str]] = {}
    for claim in paper_claims():
        for entry in claim.entries:
            if entry in routes:
                rows.setdefault(routes[entry], []).append(said(claim, entry))
    missing = {*routes.values()} - rows.keys()
    if missing:
        raise ValueError(f"no claim of the paper has the entries of {sorted(missing)}")
    yield from rows.items()


def said(claim: PaperClaim, entry: str) -> str:
    """The claim with its lines, its condition, and the part of it."""
    lines = f"{claim.first}" if claim.first == claim.last else f"{claim.first}–{claim.last}"
    condition = f" [{claim.why}]" if claim.why else ""
    part = f" [{entry}]" if len(claim.entries) > 1 else ""
    no = f" – **not as printed**: {CONTRADICTED[entry][1]}" if entry in CONTRADICTED else ""
    return f"- l. {lines}: {claim.words}{condition}{part}{no}"


def page() -> str:
    """The whole page."""
    pieces, stated = [_HEAD], dict[str, str]()
    for names, claims in groups():
        pieces.append(f"## {', '.join(f'`{name}`' for name in names)}\n\n" + "\n".join(claims) + "\n")
        fresh = {name: statement_of(name)[0] for name in names if name not in stated}
        pieces.append(_coq(fresh.values()) if fresh else "Stated above.\n")
        stated |= fresh
    rest = [definitions()[name] for name in used(stated.values()) if name not in stated]
    return "\n".join([*pieces, "## The definitions that they use\n", _coq(rest)])


def _coq(texts: Iterable[str]) -> str:
    return "```coq\n" + "\n\n".join(texts) + "\n```\n"


def main(path: Path = PAGE) -> None:
    """Write the page."""
    path.write_text(page(), encoding="utf-8")


if __name__ == "__main__":
    main()
