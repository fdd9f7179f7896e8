"""One entry of the ledger: a statement of the paper, the checks that were run on it, and the verdict."""

from __future__ import annotations

import enum
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from gspot_verified.verdict import Outcome, Reason, Verdict


class Rung(enum.Enum):
    """What a check rests on, the strongest first: what it can settle and whom a reader must trust."""

    FORMAL = "a formal proof, checked by a proof assistant"
    EXACT = "an exact symbolic identity or a certificate that covers the whole claim"
    PAGE = "a proof page in proofs/: prose, its steps tested"
    BALLS = "balls that cover the whole stated set"
    POINTS = "points only: supports the claim, cannot prove it for all arguments"

    @property
    def settles(self) -> bool:
        """True when a check on this rung alone decides the claim."""
        return self is not Rung.POINTS


@dataclass(frozen=True, slots=True)
class Check:
    """One route to the claim: what was done and what came out.

    ``agrees`` is True when the claim holds on everything this check covers, False when it certainly fails somewhere,
    None when the check could not tell.
    """

    rung: Rung
    what: str
    agrees: bool | None
    finding: str = ""

    def to_json(self) -> dict[str, Any]:
        """Plain data for ``json.dumps``."""
        return {
            "rung": self.rung.name.lower(),
            "what": self.what,
            "agrees": self.agrees,
            "finding": self.finding,
        }


@dataclass(frozen=True, slots=True)
class Entry:
    """A statement of the paper with its verdict.

    ``label`` is the paper's label or "line N" of its source; ``source`` the printed form as LaTeX; ``statement`` the
    claim in words; ``corrected`` the form that holds when the printed one is refuted, or the condition it needs.
    """

    identifier: str
    label: str
    section: str
    source: str
    statement: str
    checks: tuple[Check, ...]
    verdict: Verdict
    corrected: str = ""
    note: str = ""

    @property
    def rung(self) -> Rung | None:
        """The strongest rung that the verdict rests on; ``None`` for an undecided entry."""
        carries = {Outcome.PROVED: True, Outcome.REFUTED: False}.get(self.verdict.outcome)
        found = {check.rung for check in self.checks if carries is not None and check.agrees is carries}
        return next((rung for rung in Rung if rung in found), None)

    def to_json(self) -> dict[str, Any]:
        """Plain data for ``json.dumps``."""
        return {
            "identifier": self.identifier,
            "label": self.label,
            "section": self.section,
            "source": self.source,
            "statement": self.statement,
            "checks": [check.to_json() for check in self.checks],
            "verdict": self.verdict.to_json(),
            "rung": self.rung.name.lower() if self.rung else None,
            "corrected": self.corrected,
            "note": self.note,
        }


def all_of(answers: Iterable[bool | None]) -> bool | None:
    """Conjunction of three-valued answers: False when one is False, True when all are True, else ``None``.

    ``None`` for no answers at all: a check that looked at nothing shows nothing.
    """
    found = list(answers)
    if not found:
        return None
    if any(answer is False for answer in found):
        return False
    return True if all(answer is True for answer in found) else None


def same_sign(first: int | None, second: int | None) -> bool | None:
    """Whether two certified signs agree; ``None`` when one of them is not certain."""
    return None if first is None or second is None else first == second


def conclude(statement: str, checks: Sequence[Check], witness: str = "") -> Verdict:
    """The verdict that two or more checks support.

    - refuted: one check fails with certainty, and a second one fails too (two derivations of the counterexample);
    - proved: every check agrees, there are at least two of them, and one on a settling rung;
    - undecided: anything else.
    """
    failures = [check for check in checks if check.agrees is False]
    if len(failures) >= 2:
        return Verdict.refuted(statement, witness or failures[0].finding, failures[1].finding)
    if failures:
        return Verdict.undecided(statement, Reason.NO_ROUTE, f"one check fails: {failures[0].finding}")
    if any(check.agrees is None for check in checks):
        open_checks = "; ".join(check.what for check in checks if check.agrees is None)
        return Verdict.undecided(statement, Reason.BUDGET, f"could not tell: {open_checks}")
    if len(checks) >= 2 and any(check.rung.settles for check in checks):
        return Verdict.proved(statement, "; ".join(check.what for check in checks))
    return Verdict.undecided(statement, Reason.NO_ROUTE, "the checks at points alone prove nothing")


def settled(
    section: str,
    identifier: str,
    label: str,
    source: str,
    statement: str,
    *checks: Check,
    corrected: str = "",
    note: str = "",
) -> Entry:
    """An entry with the verdict that its checks support."""
    return Entry(identifier, label, section, source, statement, checks, conclude(statement, checks), corrected, note)


def counts(entries: Sequence[Entry]) -> dict[str, int]:
    """How many entries have each outcome."""
    return {outcome.value: sum(e.verdict.outcome is outcome for e in entries) for outcome in Outcome}
