"""The number of real zeros of the slow solution F_(beta-1) for all (beta, epsilon) of a rectangle, certified.

Proof page: ``proofs/finite_epsilon_zeros.md``, sections 4 to 6. beta < 4 is Theorem D (a) there; nothing is computed.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from contextlib import AbstractContextManager, ExitStack
from dataclasses import dataclass
from functools import lru_cache, partial
from itertools import pairwise
from pathlib import Path
from typing import ClassVar, NamedTuple

from flint import fmpq

from gspot_verified.compliant.patches.slow_patch import SlowPatch
from gspot_verified.compliant.zeros.fold_column import fold_column, numbers_of_zeros
from gspot_verified.compliant.zeros.polynomial_zeros import number_at_integer
from gspot_verified.compliant.zeros.slow_zero_column import MAP_REACH, slow_zero_column
from gspot_verified.compliant.zeros.zero_count import SYSTEM
from gspot_verified.numbers.counted import counted
from gspot_verified.numbers.evidence import at_most, cover, every, theorem
from gspot_verified.numbers.short_text import short_text
from gspot_verified.numbers.verdict import Evidence, NoTruthValue, Reason, Verdict
from gspot_verified.numbers.written import Written
from gspot_verified.signs.cover.journal import Journal, opened
from gspot_verified.signs.cover.pieces import Column, Kind, cell_of
from gspot_verified.signs.cover.subdivision import Progress, Subdivision
from gspot_verified.work.executors import InProcessExecutor
from gspot_verified.work.ranges import Range

LEAST_BETA, THEOREM_UP_TO, MAX_BETA = fmpq(1), fmpq(4), fmpq(10)  # limits of input; between them section 4 (a)'s
MAX_EPSILON = fmpq(100)  # a limit of input: ValueError beyond it
DEFAULT_BUDGET = 5_000  # ranges of beta that are examined, against endless work
_COLUMN = fmpq(1, 8)  # of beta: the cuts to begin with, and the widest range with a fold
_LEAST_PIECE = fmpq(1, 2**7)  # of tau; a column that needs narrower ones is cut
_FIRST_ETA, _ETA_STEP = fmpq(2, 25), fmpq(1, 10)  # where epsilon is cut into rows: a heuristic


PlainStretch = tuple[fmpq, fmpq, tuple[int, ...]]  # from and to in beta, the numbers of zeros


class Stretch(NamedTuple):
    """A range of beta and the number of zeros there; or two, before and after a fold, which may lie outside of it.

    ``fold_inside``: there are two, and the fold lies in the range for every epsilon of the row.
    """

    beta: tuple[fmpq, fmpq]
    numbers: tuple[int, ...]
    fold_inside: bool


@dataclass(frozen=True, slots=True)
class Row(Written):
    """The columns over beta that hold for all epsilon of [lower, upper]; ``unfinished``: ranges of beta that are left.

    ``lower`` = 0: for all epsilon in (0, upper].
    """

    written: ClassVar[str] = "epsilon stretches=stretch_rows unfinished"

    lower: fmpq
    upper: fmpq
    columns: tuple[Column, ...]
    unfinished: tuple[tuple[fmpq | None, fmpq], ...]

    @property
    def epsilon(self) -> tuple[fmpq, fmpq]:
        """Both ends of the range of epsilon."""
        return self.lower, self.upper

    @property
    def stretch_rows(self) -> list[Stretch]:
        """:meth:`stretches` with names."""
        found = self.stretches()
        return [
            Stretch((a, b), numbers, len(numbers) == 2 and self._folds_inside(found, k))
            for k, (a, b, numbers) in enumerate(found)
        ]

    def _folds_inside(self, stretches: list[PlainStretch], k: int) -> bool:
        """Whether the first number is that at the lower end and the second one at the upper end, for every epsilon."""
        lower, upper, (first, last) = stretches[k]
        begins = any(one[1:] == (lower, (first,)) for one in stretches)
        ends = any((one[0], one[2]) == (upper, (last,)) for one in stretches)
        if lower.q == 1:
            # The tail that begins with an integer has its one zero only beyond the integer.
            [tail] = {column.pieces[-1].mark for column in self.columns if column.lower == lower}
            begins = number_at_integer(int(lower.p) - 1, self.lower, self.upper) == first - tail
        if upper.q == 1:
            ends = number_at_integer(int(upper.p) - 1, self.lower, self.upper) == last
        return begins and ends

    def ends(self) -> list[tuple[fmpq | None, fmpq]]:
        """The ranges of beta of the columns whose pieces cover the line and tell the number of zeros."""
        return [
            (column.lower, column.upper)
            for column in self.columns
            if cover(((piece.lower, piece.upper) for piece in column.pieces), (None, None)) is not None
            and numbers_of_zeros(column, self.lower, self.upper) is not None
        ]

    def stretches(self) -> list[PlainStretch]:
        """Maximal ranges of beta inside one cell with the same number; (N + 2, N): before and after one fold, which may
        lie in the range, for other epsilon outside of it."""
        found = [self._numbers(column) for column in self.columns]
        joints = [k for k, (one, two) in enumerate(pairwise(self.columns), 1) if _joined_inside(one, two)]
        for k in joints:
            if found[k - 1] == found[k][1:]:
                found[k] = found[k - 1]  # at the common end the fold is behind
        for k in reversed(joints):
            if found[k] == found[k - 1][:1]:
                found[k - 1] = found[k]  # at the common end the fold is ahead
        stretches: list[PlainStretch] = []
        for k, (column, numbers) in enumerate(zip(self.columns, found, strict=True)):
            assert column.lower is not None
            if k in joints and stretches[-1][2] == numbers:
                stretches[-1] = (stretches[-1][0], column.upper, numbers)
            else:
                stretches.append((column.lower, column.upper, numbers))
        return stretches

    def _numbers(self, column: Column) -> tuple[int, ...]:
        numbers = numbers_of_zeros(column, self.lower, self.upper)
        assert numbers is not None
        return numbers


@dataclass(frozen=True, slots=True)
class ZeroMap(NoTruthValue, Written):
    """What is certified over [beta] x [epsilon], row by row; ``rows`` cover the range of epsilon."""

    ask: ClassVar[str] = ".verdict.outcome says whether the whole rectangle is settled"
    system: ClassVar[str] = SYSTEM
    by_theorem_below: ClassVar[fmpq] = THEOREM_UP_TO
    written: ClassVar[str] = "system beta epsilon verdict by_theorem_below examined rows"

    beta: tuple[fmpq, fmpq]
    epsilon: tuple[fmpq, fmpq]
    rows: tuple[Row, ...]
    examined: int

    @property
    def verdict(self) -> Verdict:
        """Proved when no range of beta is left in any row."""
        lower, upper = self.epsilon
        span = f"at ε = {upper}" if lower == upper else f"every ε in {'(' if lower == 0 else '['}{lower}, {upper}]"
        question = (
            f"the number of real zeros of {SYSTEM} for every β in ({self.beta[0]}, {self.beta[1]}) that is not an "
            f"integer and {span}"
        )
        if any(len(numbers) == 2 for row in self.rows for _, _, numbers in row.stretches()):
            question += " (two numbers where a fold may lie)"
        left = sum(len(row.unfinished) for row in self.rows)
        if left:
            return Verdict.undecided(
                question, Reason.BUDGET, f"{counted(left, 'range')} of β left in {counted(len(self.rows), 'row')} of ε"
            )
        covered = self._covered()
        if covered is None:
            return Verdict.undecided(question, Reason.HYPOTHESIS, "the columns leave a part of the rectangle out")
        return Verdict.proved(question, covered)

    def _covered(self) -> Evidence | None:
        """The rows cover the range of epsilon, the columns of each that tell a number the range of beta from 4 on."""
        first, last = self.beta
        if last <= THEOREM_UP_TO:
            return theorem("proofs/finite_epsilon_zeros.md", at_most(last, THEOREM_UP_TO))
        beyond = (max(first, THEOREM_UP_TO), last)
        columns = (cover(row.ends(), beyond) for row in self.rows)
        return every([cover(((row.lower, row.upper) for row in self.rows), self.epsilon), *columns])

    def __str__(self) -> str:
        lines = [str(self.verdict)]
        if self.beta[0] < THEOREM_UP_TO:
            lines.append(f"  β < 4, every ε > 0, by theorem: {_law_below_4(self.beta)}")
        for row in self.rows if self.beta[1] > THEOREM_UP_TO else ():
            parts = [f"{_numbers_text(one)} on ({one.beta[0]}, {one.beta[1]})" for one in row.stretch_rows]
            parts += [f"? on ({a}, {b})" for a, b in _joined(row.unfinished)]
            begin = "(" if row.lower == 0 else "["  # at ε = 0 nothing is stated
            lines.append(f"  ε in {begin}{short_text(row.lower)}, {short_text(row.upper)}]: " + ", ".join(parts))
        folds = {one.fold_inside for row in self.rows for one in row.stretch_rows if len(one.numbers) == 2}
        if True in folds:
            lines.append(
                "  a | b on a range: at each ε there is one β_f inside of it; a zeros for β < β_f, b for β > β_f"
            )
        if False in folds:
            lines.append("  a or b on a range: a zeros for β < β_f, b for β > β_f, but β_f may lie outside of it")
        return "\n".join(lines)


def zero_map(
    beta: Range | str,
    epsilon: Range | str,
    *,
    budget: int = DEFAULT_BUDGET,
    executor: Executor | None = None,
    journal: str | Path | None = None,
    progress: Callable[[Progress], None] | None = None,
) -> ZeroMap:
    """The number of real zeros of F_(beta-1)(.; epsilon) over a range of beta and a range (or one value) of epsilon.

    ``epsilon`` = "0..10" stands for 0 < epsilon <= 10. ``budget`` counts examined ranges of beta, in all rows of
    epsilon together. ``journal``: a file for each row, this name with the row's number; a killed run goes on from them.

    :raises ValueError: beta not inside [1, 10], or epsilon not inside [0, 100].

    >>> print(zero_map("17/4..35/8", "1/10"))
    proved: the number of real zeros of λ − λ̄ on the slow manifold of the compliant model with α₁ = −1, \
C₁ ≠ 0 for every β in (17/4, 35/8) that is not an integer and at ε = 1/10
      ε in [0.1, 0.1]: 2 on (17/4, 35/8)
    """
    betas = _ends(beta, "beta", LEAST_BETA, MAX_BETA)
    epsilons = _ends(epsilon, "epsilon", fmpq(0), MAX_EPSILON)
    if betas[0] == betas[1]:
        raise ValueError("beta: expected a range, not one value")
    if epsilons[1] == 0:
        raise ValueError("epsilon: expected a number > 0")
    rows, examined = [], 0
    with ExitStack() as open_files:
        # All of them before the work: none is refused in the midst of it.
        journals = [
            open_files.enter_context(_journal_of_row(journal, number, betas, ends))
            for number, ends in enumerate(_rows(*epsilons))
        ]
        for (lower, upper), kept in zip(_rows(*epsilons), journals, strict=True):
            tree = Subdivision(_columns(*betas), budget - examined, max_depth=8, journal=kept)
            for step in tree.steps(
                partial(examine, epsilon_lower=lower, epsilon_upper=upper), executor or InProcessExecutor()
            ):
                if progress is not None:
                    progress(step)
            rows.append(Row(lower, upper, tuple(tree.finished), tuple(tree.unfinished)))
            examined += tree.examined
    return ZeroMap(betas, epsilons, tuple(rows), examined)


def least_work(beta: Range | str, epsilon: Range | str) -> tuple[int, int]:
    """How many rows of epsilon a map has, and how many ranges of beta are examined in each at least.

    :raises ValueError: beta not inside [1, 10], or epsilon not inside [0, 100].

    >>> least_work("1..7", "1/10"), least_work("1..4", "1/10"), least_work("5..6", "0..100")[0] > 10
    ((1, 24), (1, 0), True)
    """
    rows = _rows(*_ends(epsilon, "epsilon", fmpq(0), MAX_EPSILON))
    return len(rows), len(_columns(*_ends(beta, "beta", LEAST_BETA, MAX_BETA)))


def _journal_of_row(
    journal: str | Path | None, number: int, betas: tuple[fmpq, fmpq], epsilons: tuple[fmpq, fmpq]
) -> AbstractContextManager[Journal | None]:
    question = {"kind": "zeros at finite epsilon", "beta": str(betas), "epsilon": f"{epsilons[0]}..{epsilons[1]}"}
    return opened(None if journal is None else row_file(journal, number), question)


def row_file(journal: str | Path, number: int) -> Path:
    """The file of a map's journal that is for one row of epsilon; the first row has the number 0.

    >>> row_file("work", 2).name
    'work.2'
    """
    return Path(f"{journal}.{number}")


def examine(
    lower: fmpq | None, upper: fmpq, along: Column | None = None, *, epsilon_lower: fmpq, epsilon_upper: fmpq
) -> Column | None:
    """A column over beta in [lower, upper], inside one cell, for all the epsilon, or None.

    ``along``: pieces to try first. Nothing is taken from them but where to cut.
    """
    assert lower is not None
    n = cell_of(lower, upper)
    patch = _patch(n, epsilon_lower, epsilon_upper)
    column = None
    if along is None or all(piece.kind is not Kind.FOLD for piece in along.pieces):
        signs = patch.signs(lower - 1, upper - 1)
        column = slow_zero_column(signs, lower, upper, n, _LEAST_PIECE, MAP_REACH, along)
    if column is None:
        return fold_column(lower, upper, n, epsilon_lower, epsilon_upper, _LEAST_PIECE, along)
    return column


@lru_cache(maxsize=8)
def _patch(n: int, epsilon_lower: fmpq, epsilon_upper: fmpq) -> SlowPatch:
    return SlowPatch(fmpq(n), fmpq(n + 1), epsilon_lower, epsilon_upper)


def _ends(given: Range | str, name: str, least: fmpq, largest: fmpq) -> tuple[fmpq, fmpq]:
    parsed = given if isinstance(given, Range) else Range.parse(given, name)
    if parsed.lower is None or parsed.upper is None or not least <= parsed.lower <= parsed.upper <= largest:
        raise ValueError(f"{name}: the range must lie inside [{least}, {largest}]")
    return parsed.lower, parsed.upper


def _columns(lower: fmpq, upper: fmpq) -> list[tuple[fmpq | None, fmpq]]:
    """The part beyond the theorem, cut at the multiples of 1/8."""
    columns: list[tuple[fmpq | None, fmpq]] = []
    begin = max(lower, THEOREM_UP_TO)
    while begin < upper:
        end = min(upper, ((begin / _COLUMN).floor() + 1) * _COLUMN)
        columns.append((begin, end))
        begin = end
    return columns


def _rows(lower: fmpq, upper: fmpq) -> list[tuple[fmpq, fmpq]]:
    """Ranges of epsilon = 2 eta^3 whose eta are short enough for the models; each width is a free choice."""
    if lower == upper:
        return [(lower, upper)]
    cuts = []
    eta = _FIRST_ETA
    while 2 * eta**3 < upper:
        cuts.append(2 * eta**3)
        eta += _ETA_STEP
    ends = [lower, *(cut for cut in cuts if lower < cut), upper]
    return list(pairwise(ends))


def _joined_inside(one: Column, two: Column) -> bool:
    """Whether the one ends where the other begins, inside one cell."""
    return one.upper == two.lower and one.upper.q != 1


def _joined(ranges: Sequence[tuple[fmpq | None, fmpq]]) -> list[tuple[fmpq | None, fmpq]]:
    """Ranges in their order, neighbours as one."""
    joined: list[tuple[fmpq | None, fmpq]] = []
    for lower, upper in ranges:
        if joined and joined[-1][1] == lower:
            joined[-1] = (joined[-1][0], upper)
        else:
            joined.append((lower, upper))
    return joined


def _law_below_4(beta: tuple[fmpq, fmpq]) -> str:
    return ", ".join(
        f"{number} on ({max(beta[0], fmpq(m))}, {min(beta[1], fmpq(m + 1))})"
        for m, number in ((1, 1), (2, 2), (3, 1))
        if beta[0] < m + 1 and beta[1] > m
    )


def _numbers_text(stretch: Stretch) -> str:
    return (" | " if stretch.fold_inside else " or ").join(map(str, stretch.numbers))
