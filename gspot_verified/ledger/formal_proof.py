"""The formal proofs of ``proofs/coq/``: what a theorem states, and whether ``make prove`` has run on these sources."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from gspot_verified.verdict import NoTruthValue

ROOT = Path(__file__).resolve().parents[2]
COQ = ROOT / "proofs" / "coq"
"""The folder of the repository; an installed package has none."""
STATED_IN = (
    "Statement.v",
    "StatementModels.v",
    "StatementCompliant.v",
    "StatementFlight.v",
    "StatementCertificate.v",
    "StatementChecker.v",
)
"""The files of statements: Theta, boxes, the mechanism at every epsilon, after lift-off, certificates, a checker."""
RECORD = ROOT / "build" / "coq" / "record.json"
"""What ``make prove`` leaves when every theorem is proved: the hash of each source and the axioms of each theorem."""
AXIOMS = frozenset(
    {
        "ClassicalDedekindReals.sig_not_dec",
        "ClassicalDedekindReals.sig_forall_dec",
        "FunctionalExtensionality.functional_extensionality_dep",
        "Classical_Prop.classic",
    }
)
"""Those of Coq's classical reals; a theorem that uses another one is not taken."""


@dataclass(frozen=True, slots=True)
class FormalProof(NoTruthValue):
    """Theorems that are the claim of an entry: their names, texts and files, and whether they were proved here."""

    ask = ".run is True or False"

    theorems: tuple[tuple[str, str, str], ...]
    """Of each its name, its statement and the file that states it; no text and no file where proofs/coq/ is not."""
    run: bool
    state: str

    def to_json(self) -> dict[str, Any]:
        """Plain data for ``json.dumps``."""
        theorems = [{"name": name, "statement": text, "file": file} for name, text, file in self.theorems]
        return {"theorems": theorems, "run": self.run, "state": self.state}


def formal_proof(names: Sequence[str], coq: Path = COQ, record: Path = RECORD) -> FormalProof:
    """The theorems of these names with their texts in the files of statements, proved here or not.

    They count as proved only if the record names each of them, with no other axiom than those of the classical reals,
    and holds the hash of every source as it is now.

    :raises ValueError: Statement.v is there, and one of them is not stated.
    """
    if not (coq / "Statement.v").is_file():
        return FormalProof(tuple((name, "", "") for name in names), False, "not run here: proofs/coq/ is not here")
    theorems = tuple((name, *statement_of(name, coq)) for name in names)
    why = _why_not(names, coq, record)
    return FormalProof(theorems, not why, f"not run here: {why}" if why else "run here, by make prove")


def statement_of(name: str, coq: Path = COQ) -> tuple[str, str]:
    """The definition of a statement, with the comment before it, and the file where it stands.

    :raises ValueError: no file states it.
    """
    comment = r"(?:^\(\*\*(?:(?!\*\)).)*\*\)\n)?"
    pattern = re.compile(rf"{comment}^Definition {re.escape(name)} : Prop :=.*?\.$(?=\n\n|\n?\Z)", re.M | re.S)
    for file in STATED_IN:
        if found := pattern.search((coq / file).read_text(encoding="utf-8")):
            return found[0], file
    raise ValueError(f"{', '.join(STATED_IN)}: no {name} is stated")


def _why_not(names: Sequence[str], coq: Path, record: Path) -> str:
    """Why the record does not show that the theorems are proved; empty when it does."""
    try:
        found = json.loads(record.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return "make prove was not run"
    except (OSError, ValueError):
        return "the record of make prove cannot be read"
    if not isinstance(found, Mapping) or found.get("sources") != _hashes(coq):
        return "make prove was run on other sources"
    proved = found.get("theorems")
    for name in names:
        axioms = proved.get(name) if isinstance(proved, Mapping) else None
        if not isinstance(axioms, list) or not set(map(str, axioms)) <= AXIOMS:
            return f"the record of make prove does not hold {name}"
    return ""


def _hashes(coq: Path) -> dict[str, str]:
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in coq.glob("*.v")}
