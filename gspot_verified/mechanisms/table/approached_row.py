"""Where slip from the state of one row of a table leads, as a line of CSV."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

from gspot_verified.mechanisms.sweep.sweep_piece import columns
from gspot_verified.mechanisms.table.row_text import OUTCOMES, Numbers, bounds, ends, line
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written


@dataclass(frozen=True, slots=True)
class ApproachedRow(NoTruthValue, Written):
    """One row of :func:`approach_table`, the first has the ``number`` 1; ``given`` are its values as they stood there.

    "settled": it is proved that slip ends by ``end``, and at a G-spot C_1 has a certain sign and ``side`` is the
    paper's at leading order. "undecided": ``reason`` says why. "refused": no mechanism has these values, or the state
    is none of positive slip in contact; ``reason`` says what is wrong. ``small_epsilon_side``: what
    :func:`mechanism_side` proves, None where it is open or not asked, ``small_epsilon_reason`` says why.
    ``digits``: how many decimal digits of C_1 are certain, 15 at most; None where there is no C_1.
    ``numbers`` enclose the time until then and, at a G-spot, alpha_1, alpha_2, alpha_3, beta and C_1, ``point`` the
    G-spot, angles included; None: not known, or not defined.
    """

    ask: ClassVar[str] = '.outcome is "settled", "undecided" or "refused"'
    written: ClassVar[str] = ""

    number: int
    given: tuple[tuple[str, str], ...]
    outcome: Annotated[str, OUTCOMES]
    end: str | None
    case: str | None
    side: str | None
    small_epsilon_side: str | None
    reason: str
    small_epsilon_reason: str
    warnings: tuple[str, ...]
    numbers: Numbers
    point: Numbers
    digits: int | None = None

    @property
    def summary(self) -> str:
        """The outcome, with the end and the side where they are known."""
        return ", ".join(word for word in (self.outcome, self.end, self.side) if word)

    def to_csv(self) -> str:
        """The row as a line of CSV, under :meth:`csv_head`: bounds are rounded outward."""
        words = [self.outcome, self.end or "", self.case or "", self.side or "", self.small_epsilon_side or ""]
        digits = "" if self.digits is None else str(self.digits)
        texts = [self.reason, self.small_epsilon_reason, "; ".join(self.warnings), digits]
        return line([*(text for _, text in self.given), *words, *texts, *bounds((*self.numbers, *self.point))])

    def csv_head(self) -> str:
        """The names of the columns, as a line of CSV: the same for all rows of one table.

        One that is taken by a value or a number before it begins with ``answer_``, ``spot_`` (a number) or ``state_``.
        """
        words = ["outcome", "end", "case", "side", "small_epsilon_side"]
        texts = ["reason", "small_epsilon_reason", "warnings", "C1_digits"]
        groups = (("", [name for name, _ in self.given]), ("answer_", [*words, *texts]))
        return line(columns(*groups, ("spot_", ends(self.numbers)), ("state_", ends(self.point))))
