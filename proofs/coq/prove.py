#!/usr/bin/env python3
"""Compile the formal proofs, print what each theorem assumes, and leave a record of it.

    python3 proofs/coq/prove.py                 what `make prove` runs
    python3 proofs/coq/prove.py --check-kernel  also coqchk, the independent checker of the compiled proofs (minutes)

Every statement of the files Statement*.v, that is every `Definition name : Prop := ...`, must be proved in Theorems.v
under its name; its axioms must be those that assumptions.txt lists for it, no more and no fewer. The certificates that
the proofs hold as text must be the files.
The record, build/coq/record.json, holds the hash of each source. It is written last, and an old one is removed first.
Imports nothing beyond the standard library; installs nothing.

Exit code: 0 proved, 1 a proof or a list of axioms fails, 2 not run, since Coq or Coquelicot is missing.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import re
import shutil
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
BUILD = HERE.parents[1] / "build" / "coq"
RECORD = "record.json"
LIMIT = 1200
"""Seconds until a step is given up, on a loaded machine; the whole takes three to four minutes on two free cores."""
LIBRARY = "GSpot"
CERTIFICATES = {"iwc_0_1": HERE.parent / "iwc_0_1.cert", "zeros_1_2": HERE / "zeros_1_2.cert"}
"""The files whose bytes the proofs hold."""
STATED_IN = (
    "Statement",
    "StatementModels",
    "StatementCompliant",
    "StatementFlight",
    "StatementCertificate",
    "StatementChecker",
)
"""The files of statements: Theta, boxes, the mechanism at every eps, after lift-off, certificates, a checker."""
AXIOMS = {
    "ClassicalDedekindReals.sig_not_dec",
    "ClassicalDedekindReals.sig_forall_dec",
    "FunctionalExtensionality.functional_extensionality_dep",
    "Classical_Prop.classic",
}
"""Those of Coq's classical reals, on which Coquelicot stands; no other may be used."""
UNPROVED = re.compile(
    r"\b(Admitted|admit|give_up|Axioms?|Parameters?|Conjecture|Unset|bypass_check|Declare|Extraction|Primitive)\b"
)
MISSING = """The formal proofs were not run: {what} not found. They need Coq 8.16 and Coquelicot 3. On Debian or Ubuntu:
    apt-get install --no-install-recommends coq libcoq-coquelicot libcoq-mathcomp-ssreflect make
Nothing else in this project needs them."""


def sources() -> list[Path]:
    """The files of the development, in the order of _CoqProject."""
    names = re.findall(r"^(\w+\.v)$", (HERE / "_CoqProject").read_text(encoding="utf-8"), re.MULTILINE)
    return [HERE / name for name in names]


def without_comments(text: str) -> str:
    """The text with every comment taken out, nested ones too."""
    depth, kept = 0, []
    for piece in re.split(r"(\(\*|\*\))", text):
        if piece == "(*":
            depth += 1
        elif piece == "*)":
            depth -= 1
        elif depth == 0:
            kept.append(piece)
    return "".join(kept)


def statements() -> dict[str, str]:
    """The file that states each theorem, by name: the definitions of type Prop without arguments.

    :raises ValueError: two files state one name.
    """
    found: dict[str, str] = {}
    for file in STATED_IN:
        text = without_comments((HERE / f"{file}.v").read_text(encoding="utf-8"))
        for name in re.findall(r"^Definition (\w+) : Prop :=", text, re.MULTILINE):
            if name in found:
                raise ValueError(f"{found[name]}.v and {file}.v both state {name}")
            found[name] = file
    return found


def unproved() -> list[str]:
    """Where a source leaves a proof out or adds an axiom, by the words that do it."""
    found = []
    for path in sources():
        found += [
            f"{path.name}: {match[0]}"
            for match in UNPROVED.finditer(without_comments(path.read_text(encoding="utf-8")))
        ]
    listed = {path.name for path in sources()}
    return found + [f"{path.name} is not in _CoqProject" for path in HERE.glob("*.v") if path.name not in listed]


def other_texts() -> list[str]:
    """Where a text that the proofs hold as the bytes of a certificate is not that of the file of its name."""
    found, held = [], []
    for path in sources():
        text = path.read_text(encoding="utf-8")
        for name, doubled in re.findall(r'^Definition (\w+)_file : string := "((?:[^"]|"")*)"', text, re.MULTILINE):
            held.append(name)
            file = CERTIFICATES.get(name)
            if file is None or not file.is_file() or doubled.replace('""', '"').encode() != file.read_bytes():
                found.append(f"{path.name}: {name}.cert")
    return found + [f"no text of {name}.cert is held" for name in CERTIFICATES if name not in held]


def hashes() -> dict[str, str]:
    """SHA-256 of each source."""
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in sources()}


def missing() -> str:
    """What the proofs need and this machine does not have; empty when nothing is missing."""
    tools = [tool for tool in ("coqc", "coq_makefile", "make") if shutil.which(tool) is None]
    if tools:
        return ", ".join(tools)
    probe = "From Coquelicot Require Import Coquelicot.\n"
    BUILD.mkdir(parents=True, exist_ok=True)
    (BUILD / "probe.v").write_text(probe, encoding="utf-8")
    return "" if run(["coqc", "probe.v"]).returncode == 0 else "Coquelicot"


def run(command: list[str]) -> subprocess.CompletedProcess[str]:
    """The command in the build directory, its output as text."""
    return subprocess.run(command, cwd=BUILD, capture_output=True, text=True, timeout=LIMIT, check=False)


def compile_all(jobs: int) -> str:
    """Compile in the build directory; the errors, empty when there are none."""
    for path in [*sources(), HERE / "_CoqProject"]:
        target = BUILD / path.name
        if not target.exists() or target.read_bytes() != path.read_bytes():
            shutil.copyfile(path, target)
    for command in (["coq_makefile", "-f", "_CoqProject", "-o", "Makefile"], ["make", f"-j{jobs}"]):
        done = run(command)
        if done.returncode:
            return done.stdout + done.stderr
    return ""


def assumptions(stated: dict[str, str], jobs: int) -> dict[str, list[str]]:
    """The axioms of each theorem, by Coq's `Print Assumptions`; each proof is held against its statement again.

    :raises RuntimeError: a statement without a theorem of its name and type, or an answer that is not understood.
    """
    with ThreadPoolExecutor(jobs) as pool:
        parts = pool.map(assumptions_of, range(jobs), [list(stated.items())[start::jobs] for start in range(jobs)])
    return {name: axioms for part in parts for name, axioms in part.items()}


def assumptions_of(number: int, stated: list[tuple[str, str]]) -> dict[str, list[str]]:
    """One share of :func:`assumptions`, in a file of its own."""
    lines = [f"From {LIBRARY} Require {' '.join(STATED_IN)} Theorems."]
    for name, file in stated:
        lines += [f"Definition check_{name} : {file}.{name} := Theorems.{name}.",
                  f'Goal True. idtac "theorem {name}". Abort.', f"Print Assumptions check_{name}."]  # fmt: skip
    (BUILD / f"audit_{number}.v").write_text("\n".join(lines) + "\n", encoding="utf-8")
    done = run(["coqc", "-R", ".", LIBRARY, f"audit_{number}.v"])
    if done.returncode:
        raise RuntimeError(done.stdout + done.stderr)
    return axioms_printed(done.stdout)


def axioms_printed(text: str) -> dict[str, list[str]]:
    """The axioms in what Coq printed, by theorem.

    :raises RuntimeError: an answer that is not understood.
    """
    found = {}
    for part in text.split("theorem ")[1:]:
        name, _, answer = part.partition("\n")
        heading, _, body = answer.strip().partition("\n")
        if heading not in ("Axioms:", "Closed under the global context"):
            raise RuntimeError(f"{name}: {answer}")
        found[name] = sorted(re.findall(r"^([\w.']+)\s+:", body, re.MULTILINE))
    return found


def listed() -> dict[str, list[str]]:
    """What assumptions.txt lists for each theorem."""
    lines = (HERE / "assumptions.txt").read_text(encoding="utf-8").splitlines()
    rows = [line.partition(":") for line in lines if line and not line.startswith("#")]
    return {name: sorted(axioms.split()) for name, _, axioms in rows}


def differences(found: dict[str, list[str]], expected: dict[str, list[str]]) -> list[str]:
    """How the axioms found differ from the list, and which are none of the four allowed."""
    wrong = [
        f"{name} uses {', '.join(found.get(name, ['none']))}, listed {', '.join(expected.get(name, ['none']))}"
        for name in sorted({*found, *expected})
        if found.get(name) != expected.get(name)
    ]
    return wrong + [f"{name}: not an axiom of the classical reals: {axiom}"
                    for name, axioms in found.items() for axiom in axioms if axiom not in AXIOMS]  # fmt: skip


def check_kernel() -> str:
    """coqchk on everything that Theorems.v uses, the standard library too; what it says, empty when it accepts."""
    done = run(["coqchk", "-silent", "-o", "-bytecode-compiler", "yes", "-R", ".", LIBRARY, f"{LIBRARY}.Theorems"])
    text = done.stdout + done.stderr
    return text if done.returncode or not kernel_accepts(text) else ""


def kernel_accepts(summary: str) -> bool:
    """Whether coqchk's summary names no axiom but the four, and nothing that it takes on trust."""
    used = re.search(r"^\* Axioms:\n((?: +[\w.]+\n)+)", summary, re.MULTILINE)
    trusted = re.findall(r"^\* (?:Constants|Inductives).*: (.*)$", summary, re.MULTILINE)
    known = {f"Coq.{place}.{axiom}" for place in ("Logic", "Reals") for axiom in AXIOMS}
    return used is not None and set(used[1].split()) <= known and len(trusted) == 3 and set(trusted) == {"<none>"}


def state() -> str:
    """Whether the formal proofs were run on these sources, in words."""
    try:
        record = json.loads((BUILD / RECORD).read_text(encoding="utf-8"))
    except FileNotFoundError:
        return "The formal proofs were not run here; `make prove` runs them."
    if record["sources"] != hashes():
        return "The formal proofs were run on other sources than these; `make prove` runs them again."
    return f"The formal proofs: {len(record['theorems'])} theorems proved by Coq {record['coq']} from these sources."


def prove(jobs: int, kernel: bool) -> int:
    """The whole job; the exit code."""
    (BUILD / RECORD).unlink(missing_ok=True)
    if wrong := unproved():
        return failed("A proof is left out", wrong)
    if wrong := other_texts():
        return failed("A text is not that of the file", wrong)
    if what := missing():
        print(MISSING.format(what=what))
        return 2
    began = time.monotonic()
    before = hashes()
    if errors := compile_all(jobs):
        return failed("A file does not compile", [errors])
    try:
        names = statements()
        found = assumptions(names, jobs)
    except (RuntimeError, ValueError) as error:
        return failed("A statement is not proved", [str(error)])
    for name in names:
        print(f"{name}: {', '.join(axiom.split('.')[-1] for axiom in found[name]) or 'no axiom'}")
    if wrong := differences(found, listed()):
        return failed("The axioms differ from assumptions.txt", wrong)
    if kernel and (text := check_kernel()):
        return failed("coqchk does not accept the proofs", [text])
    if hashes() != before:
        return failed("A source changed while it was compiled", [])
    version = run(["coqc", "--print-version"]).stdout.split()[0]
    record = {"coq": version, "sources": before, "theorems": found, "kernel": kernel}
    (BUILD / "record.part").write_text(json.dumps(record, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    (BUILD / "record.part").replace(BUILD / RECORD)
    seconds = time.monotonic() - began
    print(f"{len(names)} theorems proved by Coq {version} in {seconds:.0f} s, on the axioms named.")
    print(f"Record: {BUILD / RECORD}")
    return 0


def failed(heading: str, details: list[str]) -> int:
    """Say why on standard error; the exit code 1."""
    print("\n".join([f"{heading}:", *details]), file=sys.stderr)
    return 1


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--jobs", type=int, default=2, help="files compiled at once (2)")
    parser.add_argument("--check-kernel", action="store_true", help="also run coqchk on the compiled proofs")
    parser.add_argument("--state", action="store_true", help="only say whether they were run on these sources")
    arguments = parser.parse_args()
    if arguments.state:
        print(state())
        sys.exit(0)
    sys.exit(prove(arguments.jobs, arguments.check_kernel))
