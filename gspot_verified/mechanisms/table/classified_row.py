"""What is known of the G-spot of one row of a table, as a line of CSV."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

from gspot_verified.mechanisms.sweep.sweep_piece import columns
from gspot_verified.mechanisms.table.row_text import OUTCOMES, Numbers, bounds, ends, line
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written


@dataclass(frozen=True, slots=True)
class ClassifiedRow(NoTruthValue, Written):
    """One row of :func:`classify_table`, the first has the ``number`` 1; ``given`` are its values as they stood there.

    "settled": Case and the two signs of C_1 hold at the one G-spot in ``point``; without a damper no sign has a side,
    and ``reason`` says so. "undecided": what is None of them is
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
    numbers: Numbers
    point: Numbers

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

    @property
    def summary(self) -> str:
        """The outcome, with the Case where it is known."""
        if self.case is None:
            return self.outcome
        return f"{self.outcome}, {'no Case' if self.case == 'none' else f'Case {self.case}'}"

    def to_csv(self) -> str:
        """The row as a line of CSV, under :meth:`csv_head`: bounds are rounded outward."""
        signs = ["" if sign is None else str(sign) for sign in (self.lift_off_sign, self.impact_sign)]
        words = [self.outcome, self.case or "", *signs, self.reason, "; ".join(self.warnings)]
        return line([*(text for _, text in self.given), *words, *bounds((*self.numbers, *self.point))])

    def csv_head(self) -> str:
        """The names of the columns, as a line of CSV: the same for all rows of one table.

        One that is taken by a parameter or a number before it begins with ``answer_``, ``spot_`` (a number) or
        ``state_``.
        """
        words = ["outcome", "case", "lift_off_sign_of_C1", "impact_sign_of_C1", "reason", "warnings"]
        groups = (("", [name for name, _ in self.given]), ("answer_", words))
        return line(columns(*groups, ("spot_", ends(self.numbers)), ("state_", ends(self.point))))
