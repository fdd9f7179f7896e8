"""The real zeros of dTheta/dtau over a range of beta: how many, certified over whole intervals of beta.

Proof pages: ``proofs/certificate.md``, ``proofs/tails.md``, ``proofs/fold.md``.
The count for every beta, by another route: ``proofs/count_law.md``.
"""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Executor
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

from flint import fmpq

from gspot_verified.signs.executors import InProcessExecutor
from gspot_verified.signs.journal import Journal
from gspot_verified.signs.pieces import Column, Kind, fold_integer, number_of_zeros
from gspot_verified.signs.ranges import Range
from gspot_verified.signs.statements import ZerosStatement, cells_of
from gspot_verified.signs.subdivision import Progress, Subdivision
from gspot_verified.signs.zero_column import zero_column
from gspot_verified.verdict import NoTruthValue

MAX_BETA = 200
DEFAULT_BUDGET = 5_000


@dataclass(frozen=True, slots=True)
class ZerosResult(NoTruthValue):
    """``columns`` hold the curves as tubes of boxes; ``unfinished`` are the ranges of beta left when the budget ended.

    ``statement`` is None as long as something is left.
    """

    ask: ClassVar[str] = ".statement is None as long as a range of beta is left"

    beta: Range
    columns: tuple[Column, ...]
    unfinished: tuple[tuple[fmpq | None, fmpq], ...]
    statement: ZerosStatement | None
    examined: int

    @property
    def meetings(self) -> tuple[int, ...]:
        """The beta at which two zeros meet at tau = 0 and vanish as beta increases: those with a fold."""
        found = {
            fold_integer(column.lower, column.upper)
            for column in self.columns
            for piece in column.pieces
            if piece.kind is Kind.FOLD and column.lower is not None
        }
        return tuple(sorted(n + 1 for n in found if n is not None))

    @property
    def arrivals(self) -> tuple[int, ...]:
        """The integers m such that one zero comes in from +infinity as beta increases from m; ``proofs/tails.md``."""
        return tuple(
            int(column.lower.p)
            for column in self.columns
            if column.lower is not None and column.lower.q == 1 and column.pieces[-1].kind is Kind.RIGHT
            if column.pieces[-1].mark == 1
        )

    def __str__(self) -> str:
        if self.statement is not None:
            lines = [f"proved: {self.statement}"]
            if self.meetings:
                lines.append("  two zeros meet at τ = 0 and vanish at β = " + ", ".join(map(str, self.meetings)))
            if self.arrivals:
                lines.append("  one comes in from τ = +∞ as β increases from " + ", ".join(map(str, self.arrivals)))
            return "\n".join(lines)
        left = ", ".join(f"[{a}, {b}]" for a, b in self.unfinished[:8])
        return (
            f"undecided: the number of zeros of dΘ/dτ for β in {self.beta}; {len(self.columns)} ranges settled, "
            f"{len(self.unfinished)} left: β in {left}"
        )

    def to_json(self) -> dict[str, Any]:
        """Plain data for ``json.dumps``; the tubes of every column included."""
        return {
            "beta": str(self.beta),
            "statement": None if self.statement is None else self.statement.to_json(),
            "examined": self.examined,
            "meetings": list(self.meetings),
            "arrivals": list(self.arrivals),
            "columns": [
                {
                    "beta": [str(column.lower), str(column.upper)],
                    "zeros": number_of_zeros(column),
                    "tubes": [[str(lower), str(upper)] for lower, upper in column.tubes()],
                }
                for column in self.columns
            ],
            "unfinished": [[str(lower), str(upper)] for lower, upper in self.unfinished],
        }


def zeros_on_range(
    beta: Range | str,
    *,
    budget: int = DEFAULT_BUDGET,
    executor: Executor | None = None,
    journal: Path | None = None,
    progress: Callable[[Progress], None] | None = None,
) -> ZerosResult:
    """The number of real zeros of dTheta/dtau for every beta of the range that is not an integer, certified.

    ``budget`` counts examined ranges of beta. A ``journal`` file lets a killed run go on.

    :raises ValueError: the range is not inside (0, 200], is one integer, or is infinite.

    >>> print(zeros_on_range("2..5/2"))
    proved: for every β in (2, 5/2) that is not an integer, dΘ/dτ has exactly N real zeros, all simple: N = 2 on (2, 3)
      one comes in from τ = +∞ as β increases from 2
    """
    beta = beta if isinstance(beta, Range) else Range.parse(beta, "beta")
    if beta.lower is None or beta.upper is None or beta.lower < 0 or beta.upper > MAX_BETA:
        raise ValueError(f"beta: the range must lie inside [0, {MAX_BETA}]")
    if beta.is_point and beta.lower.q == 1:
        raise ValueError(f"beta: at the integer {beta.lower} dΘ/dτ is a polynomial; ask for a range or another value")
    kept = Journal(journal, {"kind": "zeros", "beta": str(beta)}) if journal is not None else None
    tree = Subdivision([*cells_of(beta)], budget, journal=kept)
    for step in tree.steps(_examine, executor or InProcessExecutor()):
        if progress is not None:
            progress(step)
    columns, left = tuple(tree.finished), tuple(tree.unfinished)
    statement = None if left else ZerosStatement(beta, _counts(columns))
    return ZerosResult(beta, columns, left, statement, tree.examined)


def _examine(lower: fmpq | None, upper: fmpq) -> Column | None:
    assert lower is not None
    return zero_column(lower, upper)


def _counts(columns: tuple[Column, ...]) -> tuple[tuple[int, int], ...]:
    """The number for each cell (m, m + 1), on which all columns of the cell must agree."""
    found: dict[int, int] = {}
    for column in columns:
        assert column.lower is not None
        m, count = int((column.lower).floor()), number_of_zeros(column)
        if count is None or found.setdefault(m, count) != count:
            raise ArithmeticError(f"columns over ({m}, {m + 1}) disagree on the number of zeros; please report this")
    return tuple(sorted(found.items()))
