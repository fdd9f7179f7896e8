"""Hard cases of the expansions: high degrees, high orders of Theorem 1, an obstructed order, bounds past the G-spot.

Beside the first three the usual computation: the library's own recursion of Theorem 1 with doubles as its numbers.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from flint import arb, fmpq

from gspot_verified.expansion.series.system import GSpotError, System
from gspot_verified.expansion.trajectory import Trajectory, expand_in_balls, terms_of
from gspot_verified.expansion.true_solutions.bound import UniformBound, uniform_bound
from gspot_verified.hard_cases.hard_case import (
    Case,
    HardCase,
    bits_lost,
    double_text,
    log10,
    near,
    nearest_double,
    timed,
)
from gspot_verified.mechanisms.expand import expand
from gspot_verified.mechanisms.load import load
from gspot_verified.mechanisms.shipped import shipped_system
from gspot_verified.numbers.balls import ball_text, float_bounds, rounded_text, working_bits
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.theta_function.value.evaluate import evaluate
from gspot_verified.theta_function.value.integer import polynomial


class DoublePolynomial:
    """A polynomial with doubles as coefficients; zeros at its end are cut off."""

    def __init__(self, coefficients: Any) -> None:
        self._values = np.trim_zeros(np.asarray(coefficients, dtype=float), "b")

    def coeffs(self) -> list[float]:
        """The coefficients, from the constant term on."""
        return [float(value) for value in self._values]

    def length(self) -> int:
        """How many coefficients there are."""
        return len(self._values)

    def __add__(self, other: DoublePolynomial) -> DoublePolynomial:
        return DoublePolynomial(_plus(self._values, other._values))

    def __sub__(self, other: DoublePolynomial) -> DoublePolynomial:
        return DoublePolynomial(_plus(self._values, -other._values))

    def __neg__(self) -> DoublePolynomial:
        return DoublePolynomial(-self._values)

    def __mul__(self, other: DoublePolynomial | float) -> DoublePolynomial:
        if not isinstance(other, DoublePolynomial):
            return DoublePolynomial(self._values * other)
        if not (self.length() and other.length()):
            return DoublePolynomial([])
        return DoublePolynomial(np.convolve(self._values, other._values))


def _plus(left: Any, right: Any) -> Any:
    total = np.zeros(max(len(left), len(right)))
    total[: len(left)] += left
    total[: len(right)] += right
    return total


NOISE = 1e-12  # what a user takes for a rounding error of zero


class Doubles:
    """The ring of the recursion (``expansion.rings.Ring``) in double precision; nothing in it is certain."""

    def number(self, value: Any) -> float:
        """The nearest double."""
        return value if isinstance(value, float) else int(fmpq(value).p) / int(fmpq(value).q)

    def polynomial(self, coefficients: Sequence[float]) -> DoublePolynomial:
        """A polynomial."""
        return DoublePolynomial(coefficients)

    def is_zero(self, value: float) -> bool:
        """As it looks."""
        return value == 0

    def is_nonzero(self, value: float) -> bool:
        """More than what rounding leaves."""
        return abs(value) > NOISE

    def is_negative(self, value: float) -> bool:
        """As it looks."""
        return value < 0

    def sine_cosine(self, value: float) -> tuple[float, float]:
        """Both."""
        return math.sin(value), math.cos(value)

    def exponential(self, value: float) -> float:
        """Its exponential."""
        return math.exp(value)

    def logarithm(self, value: float) -> float:
        """Its logarithm."""
        return math.log(value)

    def power(self, value: float, exponent: fmpq) -> float:
        """A rational power."""
        return float(value ** (int(exponent.p) / int(exponent.q)))


TAU = fmpq(5)  # of the polynomial Theta(5, n)
_BITS = 256  # from which the bits lost at high orders are counted
_OBSTRUCTED_ORDER = 3  # the first with the divisor beta - 2
_DOUBLE_BITS = 53  # of a double's mantissa


def high_degree(n: int) -> HardCase:
    """The polynomial Theta(5, n)."""
    evaluation, seconds = timed(lambda: evaluate(TAU, n))
    coefficients = polynomial(n).coeffs()
    with np.errstate(all="ignore"):
        double = float(np.polyval([nearest_double(fmpq(c)) for c in reversed(coefficients)], float(TAU.p)))

    def horner(bits: int) -> arb:
        with working_bits(bits):
            total = arb(0)
            for value in reversed(coefficients):
                total = total * TAU + arb(value) * (1 + arb(0, arb(2) ** -bits))
            return total

    slope = evaluate(TAU, n, 1).value
    with working_bits(64):
        condition = log10(TAU * slope / evaluation.value)
    certified = evaluation.value if evaluation.reached else None
    return HardCase(
        level=n,
        asked=f"Θ(5, {n})",
        condition=condition,
        lost=bits_lost(horner),
        double=double,
        certified=certified,
        text=str(evaluation),
        work=n,
        seconds=seconds,
    )


def high_order(order: int) -> HardCase:
    """The coefficient of the extended system's force, orders below ``order``, that is worst in double precision."""
    system = shipped_system("extended", chi=1)
    exact, seconds = timed(lambda: expand(system, order))
    doubles = in_doubles(system, order)
    double, value = worst(exact, doubles)
    balls = expand_in_balls(system, order, _BITS)
    assert balls.accuracy is not None
    lost = _BITS - balls.accuracy.certain_bits
    asked = f"the force of the extended system, {order} orders"
    return HardCase(
        level=order,
        asked=asked,
        lost=lost,
        double=double,
        certified=value,
        text=_text(value),
        work=order,
        seconds=seconds,
    )


def worst(exact: Trajectory, doubles: Trajectory) -> tuple[float, fmpq]:
    """The coefficient with the largest relative error, and its exact value."""
    pairs = [
        (double, value)
        for row, other in zip(exact.lambda_n, doubles.lambda_n, strict=True)
        for value, double in zip(row.coefficients(), other.coefficients(), strict=True)
        if value != 0
    ]
    return max(pairs, key=lambda pair: abs(pair[0] / nearest_double(pair[1]) - 1))


def in_doubles(system: System, order: int) -> Trajectory:
    """The same recursion in double precision."""
    ring = Doubles()
    return terms_of(replace(system, ring=ring, point=tuple(map(ring.number, system.point))), order, _DOUBLE_BITS)


def obstructed(k: int) -> HardCase:
    """The first coefficient of the oscillator's force with the divisor beta - 2, beta = 2 + 10^-k."""
    system = shipped_system("oscillator", beta=near(2, k))
    trajectory, seconds = timed(lambda: expand(system, _OBSTRUCTED_ORDER))
    value = trajectory.lambda_n[-1].coefficients()[-1]
    double: float | None = None
    try:
        double = in_doubles(system, _OBSTRUCTED_ORDER).lambda_n[-1].coefficients()[-1]
    except GSpotError:
        text = "refused: β looks like the integer 2"
    else:
        text = double_text(double)

    def in_balls(bits: int) -> arb:
        try:
            terms = expand_in_balls(system, _OBSTRUCTED_ORDER, max(bits, 32)).lambda_n[-1]
        except GSpotError:
            return arb("nan")
        last: arb = terms.coefficients()[-1]
        return last

    asked = f"a coefficient of the oscillator’s force at order 2, β = 2 + 10^−{k}"
    work = int(value.p).bit_length() + int(value.q).bit_length()
    return HardCase(
        level=k,
        asked=asked,
        condition=log10(2 * fmpq(10) ** k),
        lost=bits_lost(in_balls),
        double=double,
        double_said=text,
        certified=value,
        text=_text(value),
        work=work,
        seconds=seconds,
    )


def _text(value: fmpq) -> str:
    with working_bits(_DOUBLE_BITS + 12):
        return f"{ball_text(arb(value), 12)} (exact)"


ORDER = 6  # of delta, of the expansion
START = fmpq(-3)  # s, before the G-spot at s = 0
DELTA = fmpq(1, 20)  # the statement is for all smaller ones


def bound_until(end: int) -> UniformBound:
    """How far the solution that starts on the expansion at s = -3 is from it, up to s = ``end``."""
    return uniform_bound(expand(load("extended"), ORDER), START, end, DELTA, within=0)


def past_the_g_spot(end: int) -> HardCase:
    """Whether that is proved for all delta up to 1/20: 1 where it is; the constant of p is shown."""
    bound, seconds = timed(lambda: bound_until(end))
    proved = bound.verdict.outcome is Outcome.PROVED
    text = f"|Δp| ≤ {rounded_text(float_bounds(bound.constants['p'])[1], 1, 4)} δ^6" if proved else "undecided"
    asked = f"the distance from the expansion up to s = {end}, 0 < δ ≤ 1/20"
    return HardCase(
        level=end,
        asked=asked,
        certified=1 if proved else None,
        text=text,
        work=len(bound.stretches),
        seconds=seconds,
    )


CASES: dict[str, Case] = {
    "high-degree": high_degree,
    "high-order": high_order,
    "obstructed": obstructed,
    "uniform": past_the_g_spot,
}
