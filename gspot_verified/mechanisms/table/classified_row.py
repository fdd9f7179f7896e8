"""What is known of the G-spot of one row of a table, as a line of CSV."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, ClassVar

from gspot_verified.mechanisms.sweep.sweep_piece import columns
from gspot_verified.numbers.balls import float_bounds
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written

OUTCOMES = ("settled", "undecided", "refused")


@dataclass(frozen=True, slots=True)
class ClassifiedRow(NoTruthValue, Written):
    """One row of :func:`classify_table`, the first has the ``number`` 1; ``given`` are its values as they stood there.

    "settled": Case and the two signs of C_1 hold at the one G-spot in ``point``. "undecided": what is None of them is
    open, ``reason`` says why. "refused": no mechanism has these values; ``reason`` says what is wrong. ``numbers``
    enclose alpha_1, alpha_2, alpha_3, beta, the mean force and the slip velocity, ``point`` the state, angles included;
    None: not known, or not defined.
    """

    ask: ClassVar[str] = '.outcome is "settled", "undecided" or "refused"'
    written: ClassVar[str] = (
        "number given outcome case lift_off_sign_of_C1=lift_off_sign impact_sign_of_C1=impact_sign reason warnings "
        "numbers point"
    )

    number: int
    given: tuple[tuple[str, str], ...]
    outcome: Annotated[str, OUTCOMES]
    case: str | None
    lift_off_sign: int | None
    impact_sign: int | None
    reason: str
    numbers: tuple[tuple[str, Dyadic | None], ...]
    point: tuple[tuple[str, Dyadic | None], ...]

    @property
    def warnings(self) -> tuple[str, ...]:
        """What makes a motion through this G-spot impossible, or not certainly possible."""
        if self.case not in ("I", "II", "III"):
            return ()
        numbers = dict(self.numbers)
        force, slip = numbers["mean_force"], numbers["slip_velocity"]
        texts = []
        if force is None or force.sign() != 1:
            texts.append("the mean force is, or may be, tensile (negative)")
        if slip is None or slip.sign() != 1:
            texts.append("u <= 0 at the G-spot, or not certainly u > 0")
        return tuple(texts)

    def to_csv(self) -> str:
        """The row as a line of CSV, under :meth:`csv_head`: bounds are rounded outward."""
        signs = ["" if sign is None else str(sign) for sign in (self.lift_off_sign, self.impact_sign)]
        words = [self.outcome, self.case or "", *signs, self.reason, "; ".join(self.warnings)]
        bounds = [text for _, number in (*self.numbers, *self.point) for text in _bounds(number)]
        return _line([*(text for _, text in self.given), *words, *bounds])

    def csv_head(self) -> str:
        """The names of the columns, as a line of CSV: the same for all rows of one table.

        One that is taken by a parameter or a number before it begins with ``answer_``, ``spot_`` (a number) or
        ``state_``.
        """
        words = ["outcome", "case", "lift_off_sign_of_C1", "impact_sign_of_C1", "reason", "warnings"]
        groups = (("", [name for name, _ in self.given]), ("answer_", words))
        return _line(columns(*groups, ("spot_", _ends(self.numbers)), ("state_", _ends(self.point))))


def _ends(numbers: Sequence[tuple[str, Dyadic | None]]) -> list[str]:
    return [f"{name}_{end}" for name, _ in numbers for end in ("lower", "upper")]


def _bounds(number: Dyadic | None) -> tuple[str, str]:
    if number is None:
        return "", ""
    lower, upper = float_bounds(number.to_ball())
    return repr(lower), repr(upper)


def _line(fields: Sequence[str]) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerow(fields)
    return text.getvalue()
