"""Hard cases of the function Θ: next to an integer, cancellation, overflow, next to a zero."""

from __future__ import annotations

import math
from functools import lru_cache

from flint import arb, fmpq

from gspot_verified.cost.times.baseline import flint_attempt
from gspot_verified.hard_cases.hard_case import (
    Case,
    HardCase,
    bits_lost,
    log10,
    near,
    nearest_double,
    theta_double,
    timed,
)
from gspot_verified.numbers.balls import ball_text, working_bits
from gspot_verified.signs.zeros.brackets import zeros_at
from gspot_verified.theta_function.value.evaluate import evaluate

SEVEN_THIRDS = fmpq(7, 3)  # a beta without special values
TAU = fmpq(2)  # of Theta next to an integer beta
_DERIVATIVE_DIGITS = 30  # for the condition number only
_FAR = 100  # |tau| from which the bits lost are not counted: FLINT takes too long


def next_to_an_integer(k: int) -> HardCase:
    """Theta(2, 3 + 10^-k)."""
    return _value(k, f"Θ(2, 3 + 10^−{k})", TAU, near(3, k), _by_beta(TAU, near(3, k)))


def far_left(x: int) -> HardCase:
    """Theta(-x, 7/3)."""
    return _value(x, f"Θ(−{x}, 7/3)", fmpq(-x), SEVEN_THIRDS, _by_tau(fmpq(-x), SEVEN_THIRDS))


def _value(level: int, asked: str, tau: fmpq, beta: fmpq, condition: float) -> HardCase:
    evaluation, seconds = timed(lambda: evaluate(tau, beta))
    double = theta_double(nearest_double(tau), nearest_double(beta))
    lost = bits_lost(lambda bits: flint_attempt(tau, beta, bits)) if abs(tau) < _FAR else None
    certified = evaluation.value if evaluation.reached else None
    return HardCase(
        level=level,
        asked=asked,
        condition=condition,
        lost=lost,
        double=double,
        certified=certified,
        text=str(evaluation),
        work=evaluation.working_bits,
        seconds=seconds,
    )


def far_right(k: int) -> HardCase:
    """Theta(10^k, 7/3)/Theta(10^k, 1/3): both are beyond the range of doubles, their quotient is not."""
    tau, beta = fmpq(10) ** k, fmpq(1, 3)
    (upper, lower), seconds = timed(lambda: (evaluate(tau, SEVEN_THIRDS, digits=18), evaluate(tau, beta, digits=18)))
    with working_bits(128):
        quotient = upper.value / lower.value
    point = nearest_double(tau)
    above, below = theta_double(point, 7 / 3), theta_double(point, 1 / 3)
    double = above / below if below else math.nan
    text = ball_text(quotient)
    lost = None if k > 2 else bits_lost(lambda bits: flint_attempt(tau, SEVEN_THIRDS, bits))
    work = max(upper.working_bits, lower.working_bits)
    asked = f"Θ(10^{k}, 7/3)/Θ(10^{k}, 1/3)"
    return HardCase(
        level=k,
        asked=asked,
        condition=log10(_relative_slope(tau)),
        lost=lost,
        double=double,
        certified=quotient,
        text=text,
        work=work,
        seconds=seconds,
    )


def _relative_slope(tau: fmpq) -> arb:
    """tau d/dtau log of the quotient."""
    slopes = []
    for beta in (SEVEN_THIRDS, fmpq(1, 3)):
        value, slope = (evaluate(tau, beta, n, _DERIVATIVE_DIGITS).value for n in (0, 1))
        with working_bits(128):
            slopes.append(tau * slope / value)
    return slopes[0] - slopes[1]


def next_to_a_zero(k: int) -> HardCase:
    """Theta(tau_k, 7/3) where tau_k is a zero cut to k decimals."""
    tau = zero_below(k)
    return _value(k, f"Θ(τ, 7/3), τ a zero cut to {k} decimals", tau, SEVEN_THIRDS, _by_tau(tau, SEVEN_THIRDS))


@lru_cache(maxsize=8)
def zero_below(k: int) -> fmpq:
    """The last zero of Theta(., 7/3), cut to k decimals: dTheta/dtau(., 10/3) = -(10/3) Theta(., 7/3)."""
    lower, _ = zeros_at(SEVEN_THIRDS + 1, k + 2).brackets[-1]
    return fmpq((lower * 10**k).floor(), 10**k)


def _by_tau(tau: fmpq, beta: fmpq) -> float:
    """log10 of |tau Theta'/Theta|."""
    value, slope = (evaluate(tau, beta, n).value for n in (0, 1))
    with working_bits(64):
        return log10(tau * slope / value)


def _by_beta(tau: fmpq, beta: fmpq) -> float:
    """log10 of |beta d/dbeta Theta / Theta|, by a small difference."""
    step = fmpq(1, 10**10)
    above, value, below = (evaluate(tau, b, digits=_DERIVATIVE_DIGITS).value for b in (beta + step, beta, beta - step))
    with working_bits(128):
        return log10(beta * (above - below) / (2 * step * value))


CASES: dict[str, Case] = {
    "integer-beta": next_to_an_integer,
    "negative-tau": far_left,
    "overflow": far_right,
    "near-zero": next_to_a_zero,
}
