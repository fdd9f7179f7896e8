"""dTheta/dbeta to a given relative accuracy: raises the precision of the series at 0 until it is met."""

from __future__ import annotations

from flint import arb

from gspot_verified.numbers.balls import (
    Exact,
    ExactInput,
    approximate,
    ball,
    bits_for_digits,
    certainly_less,
    is_exact,
    nonfinite,
    relative_bits,
    shrink_to_bits,
)
from gspot_verified.theta_function.sums.beta_series import beta_derivative_sum
from gspot_verified.theta_function.value.choice import taylor_plan
from gspot_verified.theta_function.value.routes import BudgetError, checked_arguments

_MAX_SERIES_BITS = 2**29  # of all coefficients together: seconds to a minute
_BITS_OF_A_BALL = 1_000  # what a coefficient takes besides its mantissa, at most
_MORE_BITS = 16_384  # of the budget, beyond 8 times the asked bits
_GUARD = 16  # bits beyond the goal that a result keeps


def beta_derivative(tau: ExactInput, beta: ExactInput, digits: int = 15) -> arb:
    """An enclosure of dTheta/dbeta (tau, beta) with relative accuracy 10^-digits, as an ``arb``; integer beta too.

    Contains the exact value for every exact input in the input balls, always. Next to a zero it is valid but wider than
    asked; for a ball beta much wider. One series serves every argument: |tau| up to some hundreds.

    :param tau: as in ``theta``: int, Fraction, fmpq, "decimal" or "fraction" string, or arb.
    :param beta: likewise.
    :param digits: 1..10^6.
    :raises TypeError: a float argument.
    :raises ValueError: an argument outside the domain of ``theta``.
    :raises BudgetError: |tau|, or ``digits``, is too large for this series.

    Source: the entire form of the paper's t01-t03, and its eq. btau; ``proofs/beta_series.md``.

    >>> from gspot_verified import ball_text
    >>> ball_text(beta_derivative("1/2", "7/3", digits=20), 20)
    '[2.5599332398561621329 +/- 2.89e-20]'
    """
    goal = bits_for_digits(digits)
    point, parameter = checked_arguments(tau, beta, 0)
    exact_input = is_exact(point) and is_exact(parameter)
    wanted, value = goal + 2, nonfinite()
    while wanted <= 8 * goal + _MORE_BITS and (finer := _attempt(point, parameter, wanted)) is not None:
        in_vain = value.is_finite() and not exact_input and not certainly_less(4 * finer.rad(), value.rad())
        value = finer if finer.is_finite() else value
        certain = relative_bits(value)
        if certain >= goal + 2 or in_vain:
            break
        wanted = wanted + max(goal - certain, 16) + 8 if certain > 0 else 2 * wanted + 64
    if not value.is_finite():
        raise BudgetError("no series of dTheta/dbeta in memory and time: ask for fewer digits, a smaller |tau| or ball")
    return shrink_to_bits(value, goal + _GUARD)


def _attempt(tau: Exact, beta: Exact, goal: int) -> arb | None:
    """The series planned for so many bits; None where it would be too long."""
    farthest = approximate(ball(tau).abs_upper())
    plan = taylor_plan(-farthest if tau < 0 else farthest, approximate(beta), goal)
    if plan.length * (plan.bits + _BITS_OF_A_BALL) > _MAX_SERIES_BITS:
        return None
    return beta_derivative_sum(tau, beta, plan.length, plan.bits)
