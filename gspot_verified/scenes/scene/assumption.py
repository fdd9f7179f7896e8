"""What a run assumes of the true motion, because its scene leaves an effect out, and how that stands."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, NamedTuple

from flint import arb, fmpq

from gspot_verified.numbers.balls import ball_text, hull, working_bits
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written

CHECKED, VIOLATED, ASSUMED = "checked", "violated", "assumed"
_SHOWN_BITS, _SHOWN_DIGITS = 400, 20  # of a bracket in the text, which its digits round


class Bracket(NamedTuple):
    """Two times after the start."""

    lower: fmpq
    upper: fmpq


@dataclass(frozen=True)
class Assumption(NoTruthValue, Written):
    """``assumes``: a condition on the motion; ``effect``: what is left out and would be needed where it fails.

    ``standing``: checked along the whole run, violated for certain, or assumed. ``lower``, ``upper``: a bracket of the
    time, after the start, at which it first fails, or up to which it was seen to hold; None where it was checked.
    ``why``: why it is only assumed.
    """

    ask: ClassVar[str] = ".standing is checked, violated or assumed"
    written: ClassVar[str] = "effect assumes standing time why"

    effect: str
    assumes: str
    standing: str
    lower: fmpq | None = None
    upper: fmpq | None = None
    why: str = ""

    def __post_init__(self) -> None:
        if (self.standing == CHECKED) != (self.lower is None) or (self.lower is None) != (self.upper is None):
            raise ValueError(f"an assumption that is {self.standing}: from {self.lower} to {self.upper}")

    @property
    def time(self) -> Bracket | None:
        """The bracket."""
        return None if self.lower is None or self.upper is None else Bracket(self.lower, self.upper)

    @property
    def when(self) -> str:
        """The time as text."""
        if self.lower is None or self.upper is None:
            return "all along"
        if self.lower == self.upper:
            return f"t = {self.lower}"
        with working_bits(_SHOWN_BITS):
            return f"t = {ball_text(hull([arb(self.lower), arb(self.upper)]), _SHOWN_DIGITS)}"

    def __str__(self) -> str:
        said = {
            CHECKED: "checked along the whole run",
            VIOLATED: f"violated at {self.when} after the start",
            ASSUMED: f"assumed from {self.when} after the start on ({self.why})",
        }
        return f"without {self.effect}, {self.assumes}: {said[self.standing]}"


def provided(assumptions: Sequence[Assumption]) -> str:
    """What a statement must say of those that are only assumed; nothing where there are none.

    >>> provided([Assumption("stick", "u > 0", CHECKED)])
    ''
    >>> provided([Assumption("stick", "u > 0", ASSUMED, fmpq(0), fmpq(0), "u is not followed")])
    ', provided that u > 0 (stick is left out)'
    """
    said = [f"{each.assumes} ({each.effect} is left out)" for each in assumptions if each.standing == ASSUMED]
    return f", provided that {' and '.join(said)}" if said else ""
