"""The formal proofs of ``proofs/coq/``: what a theorem states, and whether this program has them proved now."""

from __future__ import annotations

import hashlib
import os
import re
import subprocess
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import ClassVar, NamedTuple

from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written

ROOT = Path(__file__).resolve().parents[3]
COQ = ROOT / "proofs" / "coq"
"""The folder of the repository; an installed package has none."""
_KEPT = ("PATH", "HOME", "TMPDIR", "LANG", "LC_ALL")
"""What the proofs see of the environment."""
_PROVED = re.compile(r"^(\w+): (?:no axiom|[\w, ]+)$", re.MULTILINE)
_STATED = re.compile(r"^Stated in (\w+\.v), SHA-256 ([0-9a-f]{64})$", re.MULTILINE)
RUN_HERE = "run here, by proofs/coq/prove.py"
NOT_ASKED = "verify --formal runs proofs/coq/prove.py, and only what it proves then counts"


@dataclass(frozen=True, slots=True)
class ProofRun(NoTruthValue):
    """What one run of ``proofs/coq/prove.py`` by this program showed: the theorems, and the hashes of the files that
    state them as they were compiled; or why it showed none."""

    ask = ".failure is empty where the proofs passed"

    theorems: frozenset[str] = frozenset()
    failure: str = NOT_ASKED
    stated: Mapping[str, str] = field(default_factory=dict)


class Theorem(NamedTuple):
    """Its name, its statement and the file that states it; no text and no file where proofs/coq/ is not."""

    name: str
    statement: str
    file: str


@dataclass(frozen=True, slots=True)
class FormalProof(NoTruthValue, Written):
    """Theorems that are the claim of an entry: their names, texts and files, and whether they were proved here."""

    written: ClassVar[str] = "theorems run state"

    ask = ".run is True or False"

    theorems: tuple[Theorem, ...]
    run: bool
    state: str


def run_proofs(coq: Path = COQ) -> ProofRun:
    """Compile the formal proofs and look at their axioms now, by ``prove.py``: minutes.

    A record or a compiled file that lies on the disk is no evidence: who can write one can write a false one. So this
    run is the evidence, and it is that of the process that asked for it.
    """
    script = coq / "prove.py"
    if not script.is_file():
        return ProofRun(failure="proofs/coq/ is not here")
    environment = {name: os.environ[name] for name in _KEPT if name in os.environ}
    command = [sys.executable, "-IS", str(script)]
    done = subprocess.run(command, capture_output=True, text=True, check=False, env=environment)
    if done.returncode:
        said = (done.stdout + done.stderr).strip().splitlines()
        return ProofRun(failure=f"prove.py ended with {done.returncode}: {said[0] if said else 'it said nothing'}")
    return ProofRun(frozenset(_PROVED.findall(done.stdout)), "", dict(_STATED.findall(done.stdout)))


def formal_proof(names: Sequence[str], proofs: ProofRun, coq: Path = COQ) -> FormalProof:
    """The theorems of these names with their texts in the files of statements, proved in this run or not.

    A file that is no more what was compiled shows another statement than the one that was proved: then none is.

    :raises ValueError: Statement.v is there, and one of them is not stated.
    """
    if not (coq / "Statement.v").is_file():
        unread = tuple(Theorem(name, "", "") for name in names)
        return FormalProof(unread, False, "not run here: proofs/coq/ is not here")
    texts = _texts(coq)
    theorems = tuple(Theorem(name, *_statement(name, texts)) for name in names)
    missing = [name for name in names if name not in proofs.theorems]
    why = proofs.failure or (f"prove.py did not prove {', '.join(missing)}" if missing else "")
    files = dict.fromkeys(theorem.file for theorem in theorems)
    if not why and (others := [file for file in files if proofs.stated.get(file) != _digest(texts[file])]):
        why = f"{', '.join(others)} was changed after prove.py had read it"
    return FormalProof(theorems, not why, f"not run here: {why}" if why else RUN_HERE)


def stated_in(coq: Path = COQ) -> list[str]:
    """The files of statements that are there: Statement.v and those of one subject each."""
    return sorted(path.name for path in coq.glob("Statement*.v"))


def statement_of(name: str, coq: Path = COQ) -> tuple[str, str]:
    """The definition of a statement, with the comment before it, and the file where it stands.

    :raises ValueError: no file states it.
    """
    return _statement(name, _texts(coq))


def _texts(coq: Path) -> dict[str, str]:
    return {file: (coq / file).read_text(encoding="utf-8") for file in stated_in(coq)}


def _digest(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()


def _statement(name: str, texts: Mapping[str, str]) -> tuple[str, str]:
    comment = r"(?:^\(\*\*(?:(?!\*\)).)*\*\)\n)?"
    pattern = re.compile(rf"{comment}^Definition {re.escape(name)} : Prop :=.*?\.$(?=\n\n|\n?\Z)", re.M | re.S)
    for file, text in texts.items():
        if found := pattern.search(text):
            return found[0], file
    raise ValueError(f"{', '.join(texts)}: no {name} is stated")
