"""sign * dTheta/dtau on a half-line for every beta of a ball at once: brackets of its critical points, balls of its
values.

Proof page: ``proofs/iwc.md``, section 6.
"""

from __future__ import annotations

import math
from itertools import pairwise

from flint import arb, fmpq

from gspot_verified.leading_order.stretches import Bracket, Stretches
from gspot_verified.numbers.balls import (
    approximate,
    ball,
    bits_for_digits,
    exact,
    hull,
    nonfinite,
    sign_of,
    working_bits,
)
from gspot_verified.signs.gamma.count_law import number_of_zeros
from gspot_verified.signs.zeros.brackets import zeros_at
from gspot_verified.signs.zeros.slope_at import UndecidedError
from gspot_verified.theta_function.boxes.box import taylor_model
from gspot_verified.theta_function.boxes.box_choice import bits_for_box, degree_for_box, length_for_box, order_for_box
from gspot_verified.theta_function.boxes.parameter_series import parameter_series
from gspot_verified.theta_function.value.evaluate import evaluate

_MODEL_REACH = 32  # |tau| up to which one Taylor model serves; beyond it evaluation over the ball
_MOST_WIDENINGS = 40  # each twice as wide, against endless work
_SPARE_DIGITS = 12  # beyond those asked for, which enclosures lose


class SlopeOverBall:
    """Enclosures of dTheta/dtau and d^2Theta/dtau^2 on intervals of tau, for every beta of the ball."""

    def __init__(self, beta: arb, reach: fmpq, digits: int) -> None:
        self.beta = beta
        self.digits = digits
        self.lower, self.upper = ends(beta)
        self.series = None
        if reach <= _MODEL_REACH:
            centre, radius = (self.lower + self.upper) / 2, (self.upper - self.lower) / 2
            size, goal = approximate(self.upper), bits_for_digits(digits) + 32
            bits = bits_for_box(approximate(reach), size, goal)
            length = length_for_box(approximate(reach) + 1, size, bits)
            degree = degree_for_box(approximate(reach), size, approximate(radius), goal)
            self.series = parameter_series(centre, radius, degree, length, bits)

    def enclosure(self, lower: fmpq, upper: fmpq, derivative: int) -> arb:
        """All values on [lower, upper]: by a Taylor model, or by evaluation over the balls where none is finite."""
        enclosure = nonfinite()
        if self.series is not None:
            middle, half = approximate((lower + upper) / 2), approximate((upper - lower) / 2)
            order = order_for_box(abs(middle), half, approximate(self.upper), bits_for_digits(self.digits) + 32)
            enclosure = taylor_model(self.series, lower, upper, order, derivative).enclosure()
        if enclosure.is_finite():
            return enclosure
        place: fmpq | arb = lower
        if lower < upper:
            with working_bits(bits_for_digits(self.digits) + 128):
                place = hull([ball(lower), ball(upper)])
        return evaluate(place, self.beta, derivative=derivative, digits=self.digits).value


def ends(beta: arb) -> tuple[fmpq, fmpq]:
    """Rationals below and above every number of the ball.

    :raises ValueError: they are too long to be written out.
    """
    with working_bits(int(beta.bits()) + 256):
        lower, upper = exact(beta.lower(), "beta"), exact(beta.upper(), "beta")
    if not (isinstance(lower, fmpq) and isinstance(upper, fmpq)):
        raise ValueError("beta: an end of the ball has too large an exponent")
    return lower, upper


def stretches_over_ball(beta: arb, sign: int, start: fmpq, digits: int = 15) -> Stretches:
    """The same as :func:`gspot_verified.leading_order.stretches.stretches`, for every beta of the ball.

    The brackets are wider: each holds its critical point for every beta.

    :raises ValueError: beta is not certainly > 0, or the ball holds an integer; sign is not 1 or -1.
    :raises UndecidedError: the ball is too wide for brackets that are apart.

    >>> shape = stretches_over_ball(arb("2.5", "1e-6"), -1, fmpq(-10))
    >>> len(shape.critical), shape.whole_line
    (1, True)
    """
    lower, upper = ends(beta)
    if not lower > 0 or lower.ceil() <= upper:
        raise ValueError("beta: expected a ball of numbers > 0 that holds no integer")
    if sign not in (1, -1):
        raise ValueError(f"sign: expected 1 or -1, got {sign}")
    middle = (lower + upper) / 2
    rough = zeros_at(middle - 1, digits).brackets if lower > 1 else ()
    reach = max([abs(start), *(abs(end) + 1 for bracket in rough for end in bracket)])
    slope = SlopeOverBall(beta, reach, 2 * digits + _SPARE_DIGITS)
    brackets = _certain_brackets(slope, rough, digits)
    # The number of critical points, proofs/count_law.md: one for the whole ball, as it holds no integer.
    if len(brackets) != (number_of_zeros(middle - 1) if lower > 1 else 0):
        raise ArithmeticError("the number of brackets is not the number of zeros; please report this")
    pieces = [(max(left, start), right) for left, right in brackets if right > start]
    critical = tuple(_with_values(slope, sign, left, right) for left, right in pieces)
    decreasing = lower > 1 and sign < 0 and all(start <= left for left, _ in brackets)
    begin = _with_values(slope, sign, start, start)
    return Stretches(beta, sign, begin, critical, decreasing)


def _with_values(slope: SlopeOverBall, sign: int, lower: fmpq, upper: fmpq) -> Bracket:
    value = slope.enclosure(lower, upper, 1)
    with working_bits(int(value.bits()) + 64):
        return Bracket(lower, upper, sign * value)


def _certain_brackets(
    slope: SlopeOverBall, rough: tuple[tuple[fmpq, fmpq], ...], digits: int
) -> tuple[tuple[fmpq, fmpq], ...]:
    """Each interval widened until d^2Theta/dtau^2 has certain, opposite signs at its ends for every beta."""
    wide = slope.upper - slope.lower
    places = digits if wide == 0 else min(digits, max(1, math.floor(-math.log10(max(approximate(wide), 1e-300)))))
    brackets = tuple(_widened(slope, left, right, fmpq(1, 10**places)) for left, right in rough)
    if any(before[1] >= after[0] for before, after in pairwise(brackets)):
        raise UndecidedError("the ball of beta is too wide: two critical points cannot be kept apart")
    return brackets


def _widened(slope: SlopeOverBall, left: fmpq, right: fmpq, step: fmpq) -> tuple[fmpq, fmpq]:
    for _ in range(_MOST_WIDENINGS):
        if step > 1:
            break
        before, after = (
            sign_of(slope.enclosure(end, end, 2)) for end in (_on_grid(left - step, step), _on_grid(right + step, step))
        )
        if before and after and before == -after:
            return _on_grid(left - step, step), _on_grid(right + step, step)
        step *= 2
    raise UndecidedError("the ball of beta is too wide: a critical point has no certain bracket")


def _on_grid(value: fmpq, step: fmpq) -> fmpq:
    """The nearest multiple of the step: short numbers."""
    return fmpq(math.floor(value / step + fmpq(1, 2))) * step
