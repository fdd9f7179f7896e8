"""The real zeros of dTheta/dtau over a range of beta: how many by a theorem, and tubes that hold one each.

How many: ``proofs/count_law.md``. Tubes, and the number once more, by columns of pieces: ``proofs/certificate.md``,
``proofs/tails.md``, ``proofs/fold.md``.
"""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Executor
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar, NamedTuple

from flint import fmpq

from gspot_verified.numbers.counted import counted
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written
from gspot_verified.signs.cover.cuts import middle_from_integers
from gspot_verified.signs.cover.journal import opened
from gspot_verified.signs.cover.pieces import Column, Kind, fold_integer, number_of_zeros
from gspot_verified.signs.cover.statements import ZerosStatement, cells_of
from gspot_verified.signs.cover.subdivision import Progress, Subdivision
from gspot_verified.signs.cover.zero_column import zero_column
from gspot_verified.signs.gamma.count_law import numbers_on
from gspot_verified.work.executors import InProcessExecutor
from gspot_verified.work.ranges import Range

MAX_BETA = 200  # columns are sought as far (signs/cover/sign.py)
DEFAULT_BUDGET = 5_000  # ranges of beta that are examined, against endless work
_SHOWN = 8  # ranges in the text, at most


class ColumnRow(NamedTuple):
    """A range of beta, its number of zeros where that is the same for all, and intervals of tau with one each."""

    beta: tuple[fmpq | None, fmpq]
    zeros: int | None
    tubes: tuple[tuple[fmpq, fmpq], ...]


@dataclass(frozen=True, slots=True)
class ZerosResult(NoTruthValue, Written):
    """``by_count_law`` is the number of zeros by the theorem. ``columns`` hold the curves as tubes of boxes;
    ``unfinished`` are the ranges of beta left when the budget ended.

    ``statement`` is what the columns prove: None as long as something is left, and above beta = 200, where no column
    is sought.
    """

    ask: ClassVar[str] = ".statement is None as long as a range of beta is left"
    written: ClassVar[str] = (
        "beta by_count_law route statement examined meetings arrivals columns=column_rows unfinished"
    )

    beta: Range
    by_count_law: ZerosStatement
    columns: tuple[Column, ...]
    unfinished: tuple[tuple[fmpq | None, fmpq], ...]
    statement: ZerosStatement | None
    examined: int

    @property
    def meetings(self) -> tuple[int, ...]:
        """The beta at which two zeros meet at tau = 0 and vanish as beta increases: those with a fold."""
        folds = {
            fold_integer(column.lower, column.upper)
            for column in self.columns
            for piece in column.pieces
            if piece.kind is Kind.FOLD and column.lower is not None
        }
        return tuple(sorted(n + 1 for n in folds if n is not None))

    @property
    def arrivals(self) -> tuple[int, ...]:
        """The integers m such that one zero comes in from +infinity as beta increases from m; ``proofs/tails.md``."""
        return tuple(
            int(column.lower.p)
            for column in self.columns
            if column.lower is not None and column.lower.q == 1 and column.pieces[-1].kind is Kind.RIGHT
            if column.pieces[-1].mark == 1
        )

    @property
    def route(self) -> str:
        """How the number of zeros is proved."""
        return "columns of pieces, and the count law" if self.statement is not None else "the count law"

    @property
    def column_rows(self) -> list[ColumnRow]:
        """Every column with its zeros and their tubes."""
        columns = self.columns
        return [ColumnRow((one.lower, one.upper), number_of_zeros(one), tuple(one.tubes())) for one in columns]

    def __str__(self) -> str:
        lines = [f"proved: {self.by_count_law}", f"  route: {self.route} (proofs/count_law.md)"]
        if self.statement is not None:
            if self.meetings:
                lines.append("  two zeros meet at τ = 0 and vanish at β = " + ", ".join(map(str, self.meetings)))
            if self.arrivals:
                lines.append("  one comes in from τ = +∞ as β increases from " + ", ".join(map(str, self.arrivals)))
        elif self.unfinished:
            left = ", ".join(f"[{a}, {b}]" for a, b in self.unfinished[:_SHOWN])
            more = f", and {len(self.unfinished) - _SHOWN} more" if len(self.unfinished) > _SHOWN else ""
            lines.append(
                f"undecided by columns: {counted(len(self.columns), 'range')} of β settled, "
                f"{len(self.unfinished)} left: β in {left}{more}"
            )
        else:
            lines.append(f"  no tubes: columns are sought for β <= {MAX_BETA}")
        return "\n".join(lines)


def zeros_on_range(
    beta: Range | str,
    *,
    budget: int = DEFAULT_BUDGET,
    executor: Executor | None = None,
    journal: str | Path | None = None,
    progress: Callable[[Progress], None] | None = None,
) -> ZerosResult:
    """The number of real zeros of dTheta/dtau for every beta of the range that is not an integer, certified.

    The count law gives the number; columns prove it again and hold the zeros in tubes, where the range ends at 200 or
    before. ``budget`` counts examined ranges of beta. A ``journal`` file lets a killed run go on;
    every column that it recalls is proved again.

    :raises ValueError: the range is not inside [0, inf), is one integer, or is unbounded; it has more than 1000 cells.

    >>> print(zeros_on_range("2..5/2"))
    proved: for every β in (2, 5/2) that is not an integer, dΘ/dτ has exactly N real zeros, all simple: N = 2 on (2, 3)
      route: columns of pieces, and the count law (proofs/count_law.md)
      one comes in from τ = +∞ as β increases from 2
    """
    beta = beta if isinstance(beta, Range) else Range.parse(beta, "beta")
    law = numbers_on(beta)
    if beta.upper is None or beta.upper > MAX_BETA:
        return ZerosResult(beta, law, (), (), None, 0)
    with opened(journal, {"kind": "zeros", "beta": str(beta)}) as kept:
        tree = Subdivision([*cells_of(beta)], budget, journal=kept, cut=middle_from_integers)
        for step in tree.steps(_examine, executor or InProcessExecutor()):
            if progress is not None:
                progress(step)
    columns, left = tuple(tree.finished), tuple(tree.unfinished)
    statement = None if left else ZerosStatement(beta, _counts(columns))
    if statement is not None and statement != law:
        raise ArithmeticError("the columns and the count law disagree on the number of zeros; please report this")
    return ZerosResult(beta, law, columns, left, statement, tree.examined)


def _examine(lower: fmpq | None, upper: fmpq, along: Column | None = None) -> Column | None:
    assert lower is not None
    return zero_column(lower, upper, along)


def _counts(columns: tuple[Column, ...]) -> tuple[tuple[int, int], ...]:
    """The number for each cell (m, m + 1), on which all columns of the cell must agree."""
    counts: dict[int, int] = {}
    for column in columns:
        assert column.lower is not None
        m, count = int((column.lower).floor()), number_of_zeros(column)
        if count is None or counts.setdefault(m, count) != count:
            raise ArithmeticError(f"columns over ({m}, {m + 1}) disagree on the number of zeros; please report this")
    return tuple(sorted(counts.items()))
