"""All real zeros of dTheta/dtau at an integer beta, where it is a polynomial with integer coefficients.

How many there are: ``proofs/count_law.md``, section 4. Each positive one is bracketed by exact signs.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import Annotated, ClassVar

from flint import fmpq, fmpz

from gspot_verified.numbers.counted import counted
from gspot_verified.numbers.short_text import decimal_text
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written
from gspot_verified.signs.cover.witness import sign_at
from gspot_verified.signs.gamma.count_law import multiplicity_at_zero, positive_zeros
from gspot_verified.signs.zeros.brackets import MAX_DIGITS, check_parameter

_MAX_HALVINGS = 12  # of the grid, against endless work


@dataclass(frozen=True, slots=True)
class IntegerZeros(NoTruthValue, Written):
    """The zero tau = 0 with its multiplicity (0: none), and a bracket for each positive zero; these are simple."""

    ask: ClassVar[str] = ".brackets holds one interval for each positive zero, and may be empty"
    written: ClassVar[str] = "beta number multiplicity_at_zero brackets"

    beta: Annotated[int, fmpq]
    multiplicity_at_zero: int
    brackets: tuple[tuple[fmpq, fmpq], ...]

    @property
    def number(self) -> int:
        """How many different zeros there are."""
        return len(self.brackets) + bool(self.multiplicity_at_zero)

    def __str__(self) -> str:
        lines = [f"β = {self.beta}: {counted(self.number, 'real zero')} of the polynomial dΘ/dτ"]
        if self.multiplicity_at_zero:
            lines.append(f"  0, of multiplicity {self.multiplicity_at_zero}")
        return "\n".join([*lines, *(f"  {decimal_text(lower, upper)}" for lower, upper in self.brackets)])


def zeros_at_integer(beta: int, digits: int = 15) -> IntegerZeros:
    """The zeros at beta = 1, 2, 3, ..., brackets of width 10^-digits (or the zero itself, if it is such a decimal).

    :raises ValueError: beta is not in 1..200, or digits not in 1..2000.

    >>> print(zeros_at_integer(6, 10))
    β = 6: 2 real zeros of the polynomial dΘ/dτ
      0, of multiplicity 2
      2.7144176165..2.7144176166
    """
    if type(beta) is not int:
        raise ValueError(f"beta: expected an int, got {beta!r}")
    check_parameter(fmpq(beta))
    if type(digits) is not int or not 1 <= digits <= MAX_DIGITS:
        raise ValueError(f"digits must be an int and lie in 1..{MAX_DIGITS}")
    number = positive_zeros(beta)
    brackets = tuple(_refine(beta, lower, upper, digits) for lower, upper in _isolate(beta, number))
    return IntegerZeros(beta, multiplicity_at_zero(beta), brackets)


def _isolate(beta: int, number: int) -> list[tuple[fmpq, fmpq]]:
    """As many changes of sign on tau > 0 as there are positive zeros: then each holds one."""
    reach = fmpq(4 * (beta + 4))
    step = fmpq(1, 2)
    for _ in range(_MAX_HALVINGS):
        points = [step * (2 * k + 1) / 2 for k in range(int((reach / step).ceil()))]
        signs = [(point, sign) for point in points if (sign := sign_at(point, fmpq(beta)))]
        intervals = [(a, b) for (a, first), (b, second) in pairwise(signs) if first != second]
        if len(intervals) == number:
            return intervals
        step /= 2
    raise ArithmeticError("the positive zeros were not separated; please report this")


def _refine(beta: int, lower: fmpq, upper: fmpq, digits: int) -> tuple[fmpq, fmpq]:
    """The cell of the grid of ``digits`` decimals with the change of sign, by bisection on its integers."""
    scale = fmpz(10) ** digits
    before = sign_at(lower, fmpq(beta))
    low, high = (lower * scale).floor(), (upper * scale).ceil()
    while high - low > 1:
        middle = (low + high) // 2
        sign = sign_at(fmpq(middle, scale), fmpq(beta))
        if sign == 0:
            return fmpq(middle, scale), fmpq(middle, scale)
        low, high = (middle, high) if sign == before else (low, middle)
    cell = fmpq(low, scale), fmpq(high, scale)
    # The first and the last grid point lie outside (lower, upper): a cell that ends there is checked.
    if sign_at(cell[0], fmpq(beta)) != before or sign_at(cell[1], fmpq(beta)) == before:
        return lower, upper
    return cell
