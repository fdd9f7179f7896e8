"""The routes to Theta and its derivatives as functions of (tau, beta): each chooses its plan and calls its bound.

Every route returns a valid enclosure or a ball that is not finite (its hypotheses are not met there). None of them
raises precision: :mod:`theta_function.value.evaluate` does. A derivative is a shift of beta, by Theta' = -beta
Theta(beta - 1) (``proofs/identities.md``): d^k Theta/dtau^k (tau, beta) = (-beta)(1 - beta)...(k - 1 - beta)
Theta(tau, beta - k).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from flint import acb, arb, arb_poly, fmpq

from gspot_verified.numbers.balls import (
    Exact,
    ExactInput,
    approximate,
    bits_for_digits,
    exact,
    is_exact,
    nonfinite,
    working_bits,
)
from gspot_verified.numbers.complex_numbers import ExactComplex, approximate_complex, complex_ball, is_point
from gspot_verified.theta_function.sums.finite_part import near_integers
from gspot_verified.theta_function.sums.laplace import laplace_sum
from gspot_verified.theta_function.sums.negative import negative_split_sum, negative_sum, sector_sum
from gspot_verified.theta_function.sums.positive import positive_sum
from gspot_verified.theta_function.sums.splitting import splitting_sum
from gspot_verified.theta_function.sums.taylor import complex_taylor_sum, taylor_sum
from gspot_verified.theta_function.value import choice
from gspot_verified.theta_function.value.choice import angle
from gspot_verified.theta_function.value.integer import polynomial
from gspot_verified.theta_function.value.near import one_value

MAX_TAU = 10**12  # of |tau|; a limit of input: ValueError beyond it
MAX_BETA = 10**4  # of |beta|; a limit of input: ValueError beyond it
MAX_DERIVATIVE = 1_000  # a limit of input: ValueError beyond it
_SHORT_TAU_BITS, _SHORT_BETA_BITS = MAX_TAU.bit_length(), MAX_BETA.bit_length()
MAX_HEIGHT_BITS = 50_000  # of numerator and denominator; a limit of input: ValueError beyond it

# What a route may use, so that an answer comes within minutes and a few GiB, or not at all.
_MAX_TAYLOR_BITS = 2**34
_MAX_COMPLEX_DEGREE = 1_000  # of a polynomial at complex tau; beyond it the series at 0
_MORE_BITS_OF_A_POLYNOMIAL = 16  # beyond one for each power, lost in its value; any number is right
_MAX_COMPLEX_TAYLOR_BITS = 2**33  # the same for complex tau
_MAX_WIDE_TAYLOR_BITS = 2**29  # the same where tau or beta is a ball
_BITS_OF_A_BALL = 1_000  # what a coefficient takes besides its mantissa, at most
_LONG_SERIES = 1_000  # terms; a shorter series of few bits is summed by near.py
_MAX_NEAR_INTEGERS = 16  # next to a ball of beta: each has a term of its own
MAX_SPLITTING_BITS = 2**33  # of the integers that binary splitting ends with
MAX_TERM_BITS = 2**36  # terms times bits of a series at infinity
_MAX_GENERIC_GAMMA_BITS = 400_000  # up to which FLINT's Gamma of any ball takes minutes at most
_SMALL_HEIGHT_BITS = 32  # of a rational whose Gamma is quasi-linear
_SMALL_DENOMINATOR = 1_000  # with which it is so at any number of bits
_MAX_LONG_DENOMINATOR_BITS = 1_000_000  # up to which a longer denominator takes minutes at most
_MAX_LAPLACE_BITS = 20_000  # up to which the quadrature takes minutes at most
_MAX_LAPLACE_LOSS = 4_000  # working bits beyond four times the goal
_MAX_EXACT_FACTOR_BITS = 100_000  # of an exact factor that is cheap; else a ball


class BudgetError(ValueError):
    """The request would need more memory or time than the library allows itself; raised before the work starts."""


Route = Callable[[Exact, Exact, int], arb]
ComplexRoute = Callable[[ExactComplex, Exact, int], acb]


def checked_arguments(tau: ExactInput, beta: ExactInput, derivative: int) -> tuple[Exact, Exact]:
    """Both arguments as exact values, inside the domain.

    :raises TypeError: a float, or a derivative that is not an int.
    :raises ValueError: not a number, not finite, |tau| > 10^12, |beta| > 10^4, more than 50,000 bits in a
        numerator or denominator, derivative not in 0..1000.
    """
    if isinstance(derivative, bool) or not isinstance(derivative, int):
        raise TypeError(f"derivative must be an int, got {type(derivative).__name__}")
    if not 0 <= derivative <= MAX_DERIVATIVE:
        raise ValueError(f"derivative must lie in 0..{MAX_DERIVATIVE}, got {derivative}")
    point, parameter = exact(tau, "tau"), exact(beta, "beta")
    # Short numerators need no closer look.
    if not (isinstance(point, fmpq) and point.height_bits() < _SHORT_TAU_BITS):
        _check(point, MAX_TAU, "tau")
    if not (isinstance(parameter, fmpq) and parameter.height_bits() < _SHORT_BETA_BITS):
        _check(parameter, MAX_BETA, "beta")
    return point, parameter


def _check(value: Exact, limit: int, name: str) -> None:
    if not _within(value, limit):
        raise ValueError(f"{name}: the library covers |{name}| <= {limit}")
    _check_height(value, name)


def _check_height(value: Exact, name: str) -> None:
    if isinstance(value, fmpq) and value.height_bits() > MAX_HEIGHT_BITS:
        raise ValueError(f"{name}: numerator and denominator may have at most {MAX_HEIGHT_BITS} bits")


def _within(value: Exact, limit: int) -> bool:
    if isinstance(value, fmpq):
        return bool(-limit * value.q <= value.p <= limit * value.q)
    return bool(-limit <= value <= limit)


def shifted_parameter(beta: Exact, derivative: int, goal: int) -> tuple[Exact, Exact]:
    """beta - k and the factor (-beta)(1 - beta)...(k - 1 - beta), k = derivative.

    The shift of a rational is exact; its factor too where that is cheap, else a ball of goal + 64 bits or more.
    """
    if derivative == 0:
        return beta, fmpq(1)
    with working_bits(goal + 64 + 2 * derivative.bit_length() + (0 if isinstance(beta, fmpq) else beta.bits())):
        cheap = isinstance(beta, fmpq) and (beta.height_bits() + 10) * derivative <= _MAX_EXACT_FACTOR_BITS
        factor: Exact = fmpq(1) if cheap else arb(1)
        for j in range(derivative):
            factor = factor * (j - beta)
        return beta - derivative, factor


def taylor(tau: Exact, beta: Exact, goal: int) -> arb:
    """The Taylor series at 0 in balls, planned for ``goal`` bits."""
    plan = choice.taylor_plan(_farthest(tau), approximate(beta), goal)
    limit = _MAX_TAYLOR_BITS if is_exact(tau) and is_exact(beta) else _MAX_WIDE_TAYLOR_BITS
    if plan.length * (plan.bits + _BITS_OF_A_BALL) > limit or not _gamma_is_affordable(beta, plan.bits):
        return nonfinite()
    few = goal < choice.SPLITTING_FROM_BITS and plan.length < _LONG_SERIES
    if few and isinstance(tau, fmpq) and isinstance(beta, fmpq):
        return one_value(tau, beta, plan.length, plan.bits)
    return taylor_sum(tau, beta, plan.length, plan.bits)


def splitting(tau: Exact, beta: Exact, goal: int) -> arb:
    """The Taylor series at 0 by exact binary splitting, for rational arguments, planned for ``goal`` bits."""
    if not (isinstance(tau, fmpq) and isinstance(beta, fmpq)):
        return nonfinite()
    plan = choice.taylor_plan(approximate(tau), approximate(beta), goal)
    if splitting_bits(tau, beta, plan.length) > MAX_SPLITTING_BITS or not _gamma_is_affordable(beta, plan.bits):
        return nonfinite()
    return splitting_sum(tau, beta, plan.length, plan.bits, choice.block_length(plan.bits))


def splitting_bits(tau: fmpq, beta: fmpq, length: int) -> int:
    """The length of the integers that exact binary splitting of the Taylor series ends with."""
    return length * (3 * (tau.height_bits() + length.bit_length()) + beta.height_bits())


def far_splitting_bits(tau: fmpq, beta: fmpq, terms: int) -> int:
    """The same for the two series at infinity, at most."""
    return terms * 3 * (tau.height_bits() + terms.bit_length() + beta.height_bits() + 2)


def negative(tau: Exact, beta: Exact, goal: int) -> arb:
    """The enveloping series at tau -> -infinity, planned for ``goal`` bits."""
    plan = choice.negative_plan(-approximate(tau), approximate(beta), goal)
    if plan is None:
        return nonfinite()
    if isinstance(tau, fmpq) and isinstance(beta, fmpq) and choice.prefers_splitting(tau, beta, plan.bits):
        if far_splitting_bits(tau, beta, plan.terms) > MAX_SPLITTING_BITS:
            return nonfinite()
        return negative_split_sum(tau, beta, plan.terms, plan.bits)
    if plan.terms * plan.bits > MAX_TERM_BITS:
        return nonfinite()
    return negative_sum(tau, beta, plan.terms, plan.bits)


def positive(tau: Exact, beta: Exact, goal: int) -> arb:
    """The saddle point and the algebraic part at tau -> +infinity, planned for ``goal`` bits."""
    point, parameter = approximate(tau), approximate(beta)
    plan = choice.saddle_plan(point, parameter, goal) if point > 1 else None
    if plan is None or len(near_integers(beta)) > _MAX_NEAR_INTEGERS:
        return nonfinite()
    bits = choice.saddle_bits(point, parameter, goal)
    if not _gamma_is_affordable(beta, bits):
        return nonfinite()
    if isinstance(tau, fmpq) and isinstance(beta, fmpq) and choice.prefers_splitting(tau, beta, bits):
        if far_splitting_bits(tau, beta, plan.terms) > MAX_SPLITTING_BITS:
            return nonfinite()
        return positive_sum(tau, beta, replace(plan, split=True), bits)
    if plan.terms * bits > MAX_TERM_BITS:
        return nonfinite()
    return positive_sum(tau, beta, plan, bits)


def laplace(tau: Exact, beta: Exact, goal: int) -> arb:
    """The Laplace integral by quadrature, planned for ``goal`` bits."""
    if goal > _MAX_LAPLACE_BITS:
        return nonfinite()
    point, parameter = approximate(tau), approximate(beta)
    plan = choice.laplace_plan(point, parameter, goal)
    bits = choice.laplace_bits(point, parameter, plan, goal)
    if bits > 4 * goal + _MAX_LAPLACE_LOSS:
        return nonfinite()
    return laplace_sum(tau, beta, plan, bits)


def complex_taylor(tau: ExactComplex, beta: Exact, goal: int) -> acb:
    """The Taylor series at 0 for complex tau, planned for ``goal`` bits."""
    with working_bits(64):
        far = approximate(complex_ball(tau).abs_upper())
    plan = choice.complex_taylor_plan(far, angle(approximate_complex(tau)), approximate(beta), goal)
    limit = _MAX_COMPLEX_TAYLOR_BITS if is_point(tau) and is_exact(beta) else _MAX_WIDE_TAYLOR_BITS
    if plan.length * (plan.bits + _BITS_OF_A_BALL) > limit or not _gamma_is_affordable(beta, plan.bits):
        return acb(nonfinite())
    return complex_taylor_sum(tau, beta, plan.length, plan.bits)


def complex_polynomial(tau: ExactComplex, beta: Exact, goal: int) -> acb:
    """The polynomial that Theta is at beta = 0, 1, 2, ..., at complex tau; not finite at other beta."""
    if not (isinstance(beta, fmpq) and beta.q == 1 and 0 <= beta.p <= _MAX_COMPLEX_DEGREE):
        return acb(nonfinite())
    n = int(beta.p)
    with working_bits(goal + n + _MORE_BITS_OF_A_POLYNOMIAL):
        return arb_poly(polynomial(n))(complex_ball(tau))


def sector(tau: ExactComplex, beta: Exact, goal: int) -> acb:
    """The enveloping series in the sector around the negative axis, planned for ``goal`` bits."""
    plan = choice.sector_plan(-approximate_complex(tau), approximate(beta), goal)
    if plan is None or plan.terms * plan.bits > MAX_TERM_BITS:
        return acb(nonfinite())
    return sector_sum(tau, beta, plan.terms, plan.bits)


def _gamma_is_affordable(beta: Exact, bits: int) -> bool:
    """Gamma of a rational of small height is quasi-linear; of anything else it is not, and its memory grows.

    With a long denominator it is so slow that minutes would pass within one call of FLINT.
    """
    if bits <= _MAX_GENERIC_GAMMA_BITS:
        return True
    if not isinstance(beta, fmpq) or beta.height_bits() > _SMALL_HEIGHT_BITS:
        return False
    return beta.q <= _SMALL_DENOMINATOR or bits <= _MAX_LONG_DENOMINATOR_BITS


def _farthest(tau: Exact) -> float:
    """The number of the ball that is farthest from 0, as a float."""
    if isinstance(tau, fmpq) or tau.is_exact():
        return approximate(tau)
    with working_bits(64):
        far = approximate(tau.abs_upper())
    return -far if tau < 0 else far


ROUTES: dict[str, Route] = {
    "taylor": taylor,
    "splitting": splitting,
    "negative": negative,
    "positive": positive,
    "laplace": laplace,
}

COMPLEX_ROUTES: dict[str, ComplexRoute] = {
    "polynomial": complex_polynomial,
    "negative": sector,
    "taylor": complex_taylor,
}
"""For complex tau, the quicker one first; each answers "not finite" at once where it cannot reach the goal."""


def theta_by(route: str, tau: ExactInput, beta: ExactInput, derivative: int = 0, digits: int = 15) -> arb:
    """An enclosure of d^k Theta/dtau^k by one named route, planned for ``digits``, with no second attempt.

    Returns a valid ball, possibly wide, or one that is not finite where the route's hypotheses do not hold.

    :param route: ``"taylor"``, ``"splitting"``, ``"negative"``, ``"positive"`` or ``"laplace"``.
    :raises ValueError: an unknown route, or an argument outside the domain (see :func:`checked_arguments`).

    >>> theta_by("laplace", -2, "1/2").overlaps(theta_by("taylor", -2, "1/2"))
    True
    """
    if route not in ROUTES:
        raise ValueError(f"route must be one of {', '.join(ROUTES)}, got {route!r}")
    point, parameter = checked_arguments(tau, beta, derivative)
    goal = bits_for_digits(digits)
    shifted, factor = shifted_parameter(parameter, derivative, goal)
    value = ROUTES[route](point, shifted, goal)
    with working_bits(goal + 64):
        return value * factor
