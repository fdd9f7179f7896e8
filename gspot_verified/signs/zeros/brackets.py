"""All real zeros of dTheta/dtau at one beta, in brackets of any width.

A bracket is a change of sign. That there are no others is known from their number (``proofs/count_law.md``), and shown
again by a column of pieces (``proofs/certificate.md``) for a certificate.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import ClassVar

from flint import fmpq, fmpz

from gspot_verified.numbers.balls import ExactInput, bits_for_digits, exact, working_bits
from gspot_verified.numbers.counted import counted
from gspot_verified.numbers.short_text import decimal_text
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written
from gspot_verified.signs.cover.pieces import Column, Kind, cell_of, number_of_zeros
from gspot_verified.signs.cover.statements import BracketsStatement
from gspot_verified.signs.cover.tails import left_threshold
from gspot_verified.signs.cover.zero_column import grid, reach_of_cell, zero_column
from gspot_verified.signs.gamma import count_law
from gspot_verified.signs.zeros.slope_at import SlopeAt, UndecidedError

MAX_BETA = 200  # columns are sought as far (signs/cover/sign.py)
MAX_DIGITS = 2_000  # a limit of input: ValueError beyond it
_MANY = 50  # beta from which on zeros are nearer to each other than the wider step allows
_NEAR_FOLD = fmpq(1, 64)  # in beta: two zeros are near each other there, and a column beside the integer is easier
_FIRST_DIGITS = 12  # of the first bracket; Newton's method doubles them
_MOST_STEPS = 12  # of Newton's method, against endless work
_MAX_TAIL = fmpq(10**9)  # tau up to which the last zero is looked for


@dataclass(frozen=True, slots=True)
class Brackets(NoTruthValue, Written):
    """One open interval with rational ends for each real zero of dTheta/dtau(., beta), in order and disjoint; all zeros
    are simple.

    Their number is that of ``proofs/count_law.md``; ``column``, made when it is asked for, shows it by pieces.
    """

    ask: ClassVar[str] = ".brackets holds one interval for each zero, and may be empty"
    written: ClassVar[str] = "beta number=brackets.__len__ brackets"

    beta: fmpq
    brackets: tuple[tuple[fmpq, fmpq], ...]

    @property
    def column(self) -> Column:
        """Pieces over the whole tau-axis that hold exactly as many zeros: what a certificate is made of.

        :raises UndecidedError: no certain column was found.
        """
        column = _column(self.beta)
        if number_of_zeros(column) != len(self.brackets):
            raise ArithmeticError("the number of zeros of the column is not that of the brackets; please report this")
        return column

    @property
    def statement(self) -> BracketsStatement:
        """What a certificate states."""
        return BracketsStatement(self.beta, self.brackets)

    def __str__(self) -> str:
        number = len(self.brackets)
        simple = "simple" if number == 1 else "all simple"
        lines = [f"β = {self.beta}: {counted(number, 'real zero')} of dΘ/dτ, {simple}"]
        return "\n".join([*lines, *(f"  {decimal_text(lower, upper)}" for lower, upper in self.brackets)])


def zeros_at(beta: ExactInput, digits: int = 15) -> Brackets:
    """Brackets of width at most 10^-digits for all real zeros of dTheta/dtau at one beta.

    :raises ValueError: beta is an integer (dTheta/dtau is a polynomial there), not one number, or not in (0, 200];
        digits not an int in 1..2000.
    :raises UndecidedError: the zeros were not kept apart, or a sign stayed open (not seen for beta <= 200).

    >>> print(zeros_at("5/2", 8))
    β = 5/2: 2 real zeros of dΘ/dτ, all simple
      -0.30886801..-0.30886800
      1.53171613..1.53171614
    """
    point = exact(beta, "beta")
    if not isinstance(point, fmpq):
        raise ValueError("beta: expected one exact number, got a ball")
    check_parameter(point)
    if point.q == 1:
        raise ValueError(f"beta: expected a number that is not an integer, got {point}: ask zeros_at_integer")
    if type(digits) is not int or not 1 <= digits <= MAX_DIGITS:
        raise ValueError(f"digits must be an int and lie in 1..{MAX_DIGITS}")
    slope = SlopeAt(point, _reach(point), digits)
    tubes = _changes(slope) or _tubes(slope)
    brackets = tuple(_refine(slope, lower, upper, digits) for lower, upper in sorted(tubes))
    return Brackets(point, _one_each(brackets, count_law.number_of_zeros(point)))


def _reach(beta: fmpq) -> fmpq:
    return reach_of_cell(int(beta.floor()))


def _changes(slope: SlopeAt) -> list[tuple[fmpq, fmpq]]:
    """Intervals of a grid with a change of sign when they are as many as there are zeros, else none.

    Then each holds one zero, and there are no others.
    """
    wanted = count_law.number_of_zeros(slope.beta)
    n = int(slope.beta.floor()) - 1
    start = -left_threshold(slope.beta - 1, slope.beta - 1, n)
    intervals: list[tuple[fmpq, fmpq]] = []
    points = [start, *(upper for _, upper in reversed(grid(start, _reach(slope.beta), _step(slope.beta))))]
    signs = [slope.sign(point) for point in points]
    for (left, before), (right, after) in pairwise(zip(points, signs, strict=True)):
        if before != after:
            intervals.append((left, right))
    return intervals if len(intervals) == wanted else []


def _step(beta: fmpq) -> fmpq:
    """Zeros are about 4/beta^(1/3) apart at the least. A heuristic."""
    return fmpq(1, 2) if beta < _MANY else fmpq(1, 4)


def _tubes(slope: SlopeAt) -> list[tuple[fmpq, fmpq]]:
    """Intervals that hold one zero each, from a column of pieces: for zeros near each other or far out."""
    column = _column(slope.beta)
    tubes = column.tubes()
    for piece in column.pieces:
        if piece.kind is Kind.FOLD and number_of_zeros(column) != len(tubes) + _in_tail(column):
            assert piece.lower is not None
            assert piece.upper is not None
            tubes += [(piece.lower, fmpq(0)), (fmpq(0), piece.upper)]
    if _in_tail(column):
        tubes.append(_tail_tube(slope, column))
    return tubes


def _one_each(brackets: tuple[tuple[fmpq, fmpq], ...], number: int | None) -> tuple[tuple[fmpq, fmpq], ...]:
    """The brackets, when they are disjoint and as many as there are zeros: each has a change of sign, so one zero."""
    if len(brackets) != number:
        raise ArithmeticError("the number of brackets is not the number of zeros; please report this")
    if any(before[1] > after[0] for before, after in pairwise(brackets)):
        raise UndecidedError("two brackets overlap; ask for more digits")
    return brackets


def check_parameter(beta: fmpq) -> None:
    """Zeros are sought for 0 < beta <= 200.

    :raises ValueError: another beta; the message says what is known there.
    """
    if beta < 0:
        known = "; for beta < 0 there is none (dΘ/dτ > 0)"
    else:
        known = "; at beta = 0 dΘ/dτ is 0 everywhere" if beta == 0 else ""
    if not 0 < beta <= MAX_BETA:
        raise ValueError(f"beta: the real zeros are sought for 0 < beta <= {MAX_BETA}, got {beta}{known}")


def _column(beta: fmpq) -> Column:
    """A column around beta: the single point, or, next to a fold, the range up to the fold's integer."""
    for lower, upper in _ranges(beta):
        column = zero_column(lower, upper)
        if column is not None:
            return column
    raise UndecidedError(f"no certain column of pieces was found at beta = {beta}")


def _ranges(beta: fmpq) -> list[tuple[fmpq, fmpq]]:
    integer = int((beta + fmpq(1, 2)).floor())
    nearest = fmpq(integer)
    near_fold = integer >= 3 and integer % 3 == 0 and abs(beta - nearest) < _NEAR_FOLD
    return [(min(beta, nearest), max(beta, nearest))] * near_fold + [(beta, beta)]


def _in_tail(column: Column) -> int:
    last = column.pieces[-1]
    return last.mark if last.kind is Kind.RIGHT else 0


def _tail_tube(slope: SlopeAt, column: Column) -> tuple[fmpq, fmpq]:
    """An interval that holds the one zero beyond the last piece: doubling until the sign is that at infinity."""
    lower = column.pieces[-1].lower
    assert lower is not None
    assert column.lower is not None
    # dTheta/dtau = -beta F, and F has the sign (-1)^(n+1) at infinity.
    final = 1 if cell_of(column.lower, column.upper) % 2 == 0 else -1
    upper = 2 * lower
    while slope.sign(upper) != final:
        if upper > _MAX_TAIL:
            raise UndecidedError("the last zero is too far out to be bracketed")
        lower, upper = upper, 2 * upper
    return lower, upper


def _refine(slope: SlopeAt, lower: fmpq, upper: fmpq, digits: int) -> tuple[fmpq, fmpq]:
    """A bracket of width 10^-digits inside (lower, upper), with certain opposite signs at its ends."""
    before, after = slope.sign(lower), slope.sign(upper)
    if before == after:
        raise ArithmeticError("the ends of a tube have one sign; please report this")
    first = digits if slope.is_carried else min(digits, _FIRST_DIGITS)
    cell = _cell_by_newton(slope, lower, upper, before, first)
    if cell is not None and first == digits:
        return cell
    start = min(digits, _FIRST_DIGITS)
    lower, upper = cell or _bisect(slope, lower, upper, before, start)
    if digits > start:
        lower, upper = _newton(slope, lower, upper, before, digits)
    return _on_decimal_grid(slope, lower, upper, before, digits)


def _cell_by_newton(slope: SlopeAt, lower: fmpq, upper: fmpq, before: int, digits: int) -> tuple[fmpq, fmpq] | None:
    """A cell of the grid of ``digits`` decimals inside (lower, upper) with certain opposite signs, or None.

    Newton's method from the middle, on rationals: it only says where to look.
    """
    scale, tau = 10**digits, (lower + upper) / 2
    near = fmpq(1, 100 * scale)
    for _ in range(_MOST_STEPS):
        step = slope.newton(tau, digits + 4)
        guess = exact(step.mid(), "guess") if step.is_finite() else None
        if not isinstance(guess, fmpq) or not lower < guess < upper:
            return None
        last, tau = tau, fmpq(math.floor(guess * (10**4 * scale)), 10**4 * scale)
        if abs(tau - last) <= near:
            break
    for k in dict.fromkeys((math.floor((tau - near) * scale), math.floor((tau + near) * scale))):
        cell = fmpq(k, scale), fmpq(k + 1, scale)
        if lower <= cell[0] and cell[1] <= upper and _brackets(slope, *cell, before):
            return cell
    return None


def _bisect(slope: SlopeAt, lower: fmpq, upper: fmpq, before: int, digits: int) -> tuple[fmpq, fmpq]:
    while upper - lower > fmpq(1, 10**digits):
        middle = _round((lower + upper) / 2, lower, upper)
        if slope.sign(middle) == before:
            lower = middle
        else:
            upper = middle
    return lower, upper


def _round(value: fmpq, lower: fmpq, upper: fmpq) -> fmpq:
    """A short dyadic number near value, inside (lower, upper)."""
    exponent = fmpz(1) << (4 + int((1 / (upper - lower)).ceil()).bit_length())
    rounded = fmpq(math.floor(value * exponent), exponent)
    return rounded if lower < rounded < upper else value


def _newton(slope: SlopeAt, lower: fmpq, upper: fmpq, before: int, digits: int) -> tuple[fmpq, fmpq]:
    """Newton's method on rationals with doubled digits; each new bracket is kept only if its signs are certain."""
    goal, have = digits + 2, _FIRST_DIGITS
    while have < goal:
        have = min(2 * have - 4, goal)
        middle = (lower + upper) / 2
        guess = slope.newton(middle, have).mid()
        with working_bits(bits_for_digits(2 * have) + 32):
            scaled = fmpz((guess * 10**have).floor().unique_fmpz())
        for width in (1, 10**3, 10**6):
            left, right = fmpq(scaled - width, 10**have), fmpq(scaled + width + 1, 10**have)
            if lower <= left and right <= upper and _brackets(slope, left, right, before):
                lower, upper = left, right
                break
        else:
            # Two zeros too near each other for Newton's method, next to a fold.
            lower, upper = _bisect(slope, lower, upper, before, have)
    return lower, upper


def _brackets(slope: SlopeAt, lower: fmpq, upper: fmpq, before: int) -> bool:
    return slope.sign(lower) == before and slope.sign(upper) == -before


def _on_decimal_grid(slope: SlopeAt, lower: fmpq, upper: fmpq, before: int, digits: int) -> tuple[fmpq, fmpq]:
    """The cell of the grid of ``digits`` decimals that holds the zero, or the bracket itself at a grid point."""
    scale = 10**digits
    left = math.floor(lower * scale)
    for k in range(int(left), int((upper * scale).ceil()) + 1):
        cell = fmpq(k, scale), fmpq(k + 1, scale)
        if _brackets(slope, *cell, before):
            return cell
    return lower, upper
