"""From pieces to statements about dΘ/dτ: its sign, the number of its zeros, where they lie (certificate.md).

The walk through the pieces of a column is on certificate.md, From pieces to the statement; integer β: check.md, 5.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any, NamedTuple

from limits import Limits, Meter, Rejected, require
from pieces import Column, ColumnCheck
from reading import INFINITY, Range, check_cover, entries, has, one_of, rational, read_range


class Task(NamedTuple):
    """One column and what must hold on it; it may be sent to another process."""

    rule: Callable[..., None]
    arguments: tuple[Any, ...]
    column: Column
    limits: Limits
    budget: int

    def run(self) -> tuple[str, int]:
        """The reason why the rule does not hold, or nothing; and the work that was spent."""
        check = ColumnCheck(self.column, self.limits, self.budget)
        try:
            self.rule(check, *self.arguments)
        except Rejected as reason:
            return str(reason), self.budget - check.meter.left
        return "", self.budget - check.meter.left


class Checker:
    """One certificate: its statement, its columns, and the budget of work that all of them share."""

    def __init__(self, statement: Any, columns: list[Column], limits: Limits, budget: int, workers: int = 1) -> None:
        self.statement, self.columns = statement, columns
        self.limits, self.left, self.workers = limits, budget, workers

    def on_each_column(self, rule: Callable[..., None], *arguments: Any) -> None:
        """The rule holds on each column. The answer is the same for any number of workers: they begin afresh."""
        if self.workers > 1:
            # Imported where it is used: from its text, that takes longer than a short check.
            from concurrent.futures import ProcessPoolExecutor
            from multiprocessing import get_context

            tasks = [Task(rule, arguments, column, self.limits, self.left) for column in self.columns]
            # A worker looks for compiled files where this process does: nowhere, if it was told so (check.md).
            first = f"import sys; sys.dont_write_bytecode, sys.pycache_prefix = True, {sys.pycache_prefix!r}"
            with ProcessPoolExecutor(self.workers, get_context("spawn"), exec, (first,)) as pool:
                try:
                    self.settle(pool.map(Task.run, tasks))
                finally:
                    pool.shutdown(wait=False, cancel_futures=True)
        else:
            # self.left is read when a task is made, after the task before it was settled.
            self.settle(Task(rule, arguments, column, self.limits, self.left).run() for column in self.columns)

    def settle(self, answers: Iterable[tuple[str, int]]) -> None:
        """Take the work of each column from the one budget, in the order of the columns."""
        for reason, spent in answers:
            self.left -= spent
            if self.left < 0:
                self.limits.beyond("work")
            require(not reason, reason)


def sign_holds(check: ColumnCheck, tau: Range, beta: Range, sign: int) -> None:
    """On one column: dΘ/dτ = -βF has one sign."""
    column = check.column
    check.begin(tau.start, tau.end)
    zero = has(tau, 0) and any(end % 3 in (0, 2) and has(beta, end) for end in (column.start, column.end))
    for piece in column.pieces:
        kind = piece.kind
        require(kind != "monotone" and (kind, piece.value) != ("right", 1), f"a piece {kind} gives no sign")
        require(kind != "fold" or column.start % 3 == 0, "a fold at the upper end of its column has zeros")
        require(kind not in ("fold", "hinge") or not zero, f"τ = 0 is a zero in a piece {kind} at an integer β")
        given = check.piece_sign(piece) * (-1 if beta.end > 0 else 1)
        require(given == sign, f"a piece {kind} gives dΘ/dτ the sign {given}, not {sign}")


def number_of_zeros(check: ColumnCheck, points: Sequence[Fraction] = ()) -> int:
    """On one column: the number of zeros of F for b in the open cell; all are simple."""
    column = check.column
    check.begin(-INFINITY, INFINITY, points)
    before, direction, zeros = 0, 0, 0
    for piece in column.pieces:
        require(piece.kind != "hinge", "a piece hinge does not count zeros")
        sign = check.piece_sign(piece)
        if piece.kind == "monotone":
            require(before, "a piece monotone comes first")
            require(direction in (0, piece.value), "neighbouring pieces monotone have two directions")
            direction = piece.value
            continue
        change = before not in (0, sign)
        require(direction or not change, "two neighbouring pieces give F different signs where they meet")
        require(not change or sign == direction, "a change of sign is against the direction of a piece monotone")
        zeros += 1 if change else 0
        if piece.kind == "right":
            zeros += piece.value
        if piece.kind == "fold" and column.end % 3 == 0:
            zeros += 2
        before, direction = sign, 0
    require(direction == 0, "a piece monotone comes last")
    return zeros


def zeros_hold(check: ColumnCheck, counts: dict[int, int]) -> None:
    """On one column: the number of zeros is the one that is claimed for its cell."""
    number, claimed = number_of_zeros(check), counts.get(check.column.cell + 1)
    require(number == claimed, f"{number} zeros on the column from β = {check.column.start!s:.50}, not {claimed}")


def brackets_hold(check: ColumnCheck, beta: Fraction, brackets: list[tuple[Fraction, Fraction]]) -> None:
    """On the one column: as many zeros as brackets, and a change of sign in each."""
    number = number_of_zeros(check, [end for pair in brackets for end in pair])
    require(number == len(brackets), f"there are {number} zeros, not {len(brackets)}")
    for pair in brackets:
        low, high = (check.sign((beta - 1, beta - 1, point, point), 0) for point in pair)
        require(low * high == -1, f"F does not change its sign between {pair[0]!s:.50} and {pair[1]!s:.50}")


def check_sign(checker: Checker) -> str:
    """dΘ/dτ = -βF has one sign on a range of τ and a range of β."""
    claimed, tau_text, beta_text, _ = entries(checker.statement, "the statement", "sign", "tau", "beta", "kind")
    sign, tau, beta = one_of(claimed, (-1, 0, 1), "the sign"), read_range(tau_text, "τ"), read_range(beta_text, "β")
    text = f"dΘ/dτ {'=><'[sign]} 0 {tau.text} and {beta.text}".replace("and for every", "and every")
    if tau.start == tau.end and beta.start == beta.end and beta.end in range(checker.limits.beta + 1):
        require(not checker.columns, "at one point with an integer β there is no column")
        exact_sign = sign_at_integer(checker, tau.start, int(beta.end))
        require(exact_sign == sign, f"the sign at this integer β is {exact_sign}, not {sign}")
        return text
    require(sign, "the sign 0 is possible at one point with an integer β ≥ 0 only")
    require(not has(beta, 0), "the range of β holds 0")
    check_cover(checker.columns, beta.start, beta.end, "columns")
    checker.on_each_column(sign_holds, tau, beta, sign)
    return text


def sign_at_integer(checker: Checker, tau: Fraction, beta: int) -> int:
    """The sign of dΘ/dτ = -βF at one point, by integers g_n = q^n Θ(p/q, n) (check.md, section 5)."""
    meter = Meter(checker.limits, checker.left)
    p, cube, g = tau.numerator, meter.product((tau.denominator, 3)), [0, 0, 1]  # g_n for three n, up to β - 1
    for n in range(1, beta):
        g = [g[1], g[2], meter.dot(((n - 1) * (n - 2) * cube, g[0]), (-p, g[2]))]  # identities.md, (2)
    return (g[2] < 0) - (g[2] > 0) if beta else 0


def check_zeros(checker: Checker) -> str:
    """The number of zeros for every β of a range that is not an integer."""
    beta_text, counts, _ = entries(checker.statement, "the statement", "beta", "counts", "kind")
    beta = read_range(beta_text, "β")
    require(beta.start >= 0, "a number of zeros is claimed for β < 0")
    checker.limits.keep("beta", beta.end)
    cells = list(range(math.floor(beta.start), math.ceil(beta.end)))
    pairs = isinstance(counts, list) and all(isinstance(e, list) and [*map(type, e)] == [int, int] for e in counts)
    require(pairs and cells and [m for m, _ in counts] == cells, "counts does not list the cells of the range")
    check_cover(checker.columns, beta.start, beta.end, "columns")
    checker.on_each_column(zeros_hold, dict(counts))
    numbers = ", ".join(f"N = {number} on ({m}, {m + 1})" for m, number in counts)
    where = beta.text + (" that is not an integer" if beta.start < beta.end else "")
    return f"{where}, dΘ/dτ has exactly N real zeros, all simple: {numbers}"


def check_brackets(checker: Checker) -> str:
    """One zero in each bracket, and no other: there are as many zeros as changes of sign."""
    beta_text, brackets, _ = entries(checker.statement, "the statement", "beta", "brackets", "kind")
    beta = rational(beta_text)
    require(beta > 0 and beta.denominator > 1, "β is not positive, or it is an integer")
    pairs = isinstance(brackets, list) and all(isinstance(pair, list) and len(pair) == 2 for pair in brackets)
    require(pairs and len(checker.columns) == 1, "the brackets are not a list of pairs, or there is not one column")
    intervals = [(rational(low), rational(high)) for low, high in brackets]
    order = all(low < high for low, high in intervals) and all(one[1] <= two[0] for one, two in pairwise(intervals))
    require(order, "the brackets are not in order or overlap")
    check_cover(checker.columns, beta, beta, "columns")
    checker.on_each_column(brackets_hold, beta, intervals)
    where = ", ".join(f"({low}, {high})" for low, high in brackets) or "none"
    many = f"{len(intervals)} real zeros, all simple, one in each of the intervals:"
    number = "one real zero, simple, in" if len(intervals) == 1 else many
    return f"dΘ/dτ at β = {beta} has exactly {number} {where}"


RULES = {"sign": check_sign, "zeros": check_zeros, "brackets": check_brackets}
