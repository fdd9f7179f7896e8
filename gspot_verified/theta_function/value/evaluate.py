"""Theta and its derivatives to a given relative accuracy: chooses a route and raises precision until it is met."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import ClassVar

from flint import arb, fmpq, fmpq_poly

from gspot_verified.numbers.balls import (
    MAX_WORKING_BITS,
    Exact,
    ExactInput,
    approximate,
    ball,
    ball_text,
    bits_for_digits,
    certainly_less,
    exact,
    is_exact,
    nonfinite,
    relative_bits,
    shrink_to_bits,
    working_bits,
)
from gspot_verified.numbers.evidence import signed
from gspot_verified.numbers.verdict import NoTruthValue, Reason, Verdict
from gspot_verified.numbers.written import Written
from gspot_verified.theta_function.value import choice, routes
from gspot_verified.theta_function.value.integer import polynomial
from gspot_verified.theta_function.value.majorant import majorant_bound
from gspot_verified.theta_function.value.mean_value import mean_value_form
from gspot_verified.theta_function.value.near import near_value
from gspot_verified.theta_function.value.routes import BudgetError, checked_arguments, shifted_parameter

_EXACT_POLYNOMIAL_BITS = 100_000  # of an integer polynomial's value that is cheap; beyond it the routes
# Where every route failed at a lower goal, rounding may have hidden a hypothesis: once more with this many bits.
_LEAST_SECOND_GOAL = 128
_ROOM = 64  # bits beyond those of the inputs
# A value with no more bits than these above the goal is handed out as it is.
_FEW_MORE_BITS = 32


@dataclass(frozen=True, slots=True)
class Evaluation(NoTruthValue, Written):
    """The result of :func:`evaluate`.

    ``value`` contains the exact result for every exact input in the input balls, always. ``reached`` says whether its
    relative radius is at most 10^-digits. When it is not, ``reason`` says why: near a zero of Theta the absolute
    accuracy is what the ball shows, and the sign is undecided.
    """

    ask: ClassVar[str] = ".sign is a Verdict, .reached says whether the accuracy was reached"
    written: ClassVar[str] = "value=__str__ enclosure=value digits reached route working_bits reason"

    value: arb
    digits: int
    reached: bool
    route: str
    working_bits: int
    reason: Reason | None = None

    @property
    def sign(self) -> Verdict:
        """The certified sign: proved, or undecided with the reason."""
        certain_sign = signed(self.value)
        if certain_sign is None:
            return Verdict.undecided("the sign", self.reason or Reason.WIDE_INPUT, f"value in {self}")
        return Verdict.proved(f"the value is {('zero', 'positive', 'negative')[certain_sign[0]]}", certain_sign[1])

    def __str__(self) -> str:
        return ball_text(self.value, self.digits)


def evaluate(
    tau: ExactInput,
    beta: ExactInput,
    derivative: int = 0,
    digits: int = 15,
    max_bits: int | None = None,
) -> Evaluation:
    """d^k Theta/dtau^k (tau, beta) with relative accuracy 10^-digits, and how it was found.

    :param tau: |tau| <= 10^12; int, Fraction, fmpq, "decimal" or "fraction" string, or arb.
    :param beta: |beta| <= 10^4, same types; integers and balls that hold integers included.
    :param derivative: k, 0..1000.
    :param digits: 1..10^6.
    :param max_bits: the budget: a route is asked for at most this many bits, the first one too (default 8 times the
        asked bits plus 16,384). Inside, a route adds what its own cancellation costs.
    :raises TypeError: a float argument.
    :raises ValueError: an argument outside its domain.
    :raises BudgetError: the request would not fit in memory; raised beforehand.

    Source: paper, Appendix A; the routes and their bounds: ``proofs/``.

    >>> evaluate(-50, "7/3", digits=30).route
    'negative'
    >>> evaluate(0, 1).value
    0
    """
    goal = bits_for_digits(digits)
    if max_bits is not None and not 64 <= max_bits <= MAX_WORKING_BITS:
        raise ValueError(f"max_bits must lie in 64..{MAX_WORKING_BITS}, got {max_bits}")
    point, parameter = checked_arguments(tau, beta, derivative)
    value, route, bits, reason = _enclose(point, parameter, derivative, goal, max_bits)
    reached = relative_bits(value) >= goal
    if reached:
        reason = None
    elif reason is None:
        reason = Reason.BUDGET if is_exact(point) and is_exact(parameter) else Reason.WIDE_INPUT
    return Evaluation(value, digits, reached, route, bits, reason)


def enclosure(tau: ExactInput, beta: ExactInput, derivative: int, digits: int) -> arb:
    """The value of :func:`evaluate` alone, in fewer steps; the same arguments and errors."""
    goal = bits_for_digits(digits)
    point, parameter = checked_arguments(tau, beta, derivative)
    return _enclose(point, parameter, derivative, goal, None)[0]


_Enclosed = tuple[arb, str, int, Reason | None]
"""An enclosure, its route, the bits that were asked of the route, and why it is wider than asked (if it is)."""


def _enclose(tau: Exact, beta: Exact, derivative: int, goal: int, max_bits: int | None) -> _Enclosed:
    if derivative and isinstance(beta, fmpq) and beta.q == 1 and 0 <= beta.p < derivative:
        return arb(0), "polynomial", 0, None
    shifted, factor = shifted_parameter(beta, derivative, goal) if derivative else (beta, fmpq(1))
    enclosed: _Enclosed | None = None
    if max_bits is None and isinstance(tau, fmpq) and isinstance(shifted, fmpq):
        near = near_value(tau, shifted, goal + 2)
        if near is not None and relative_bits(near[0]) >= goal + 2:
            enclosed = near[0], "taylor", near[1], None
    if enclosed is None:
        enclosed = _exact_polynomial(tau, shifted, goal)
    if enclosed is None:
        worth = min(goal + 2, _bits_of_input(tau, shifted))
        enclosed = _of_inputs(tau, shifted, worth, max_bits)
        if (
            worth < goal + 2 and relative_bits(enclosed[0]) >= worth
        ):  # the result depends on its inputs less than most do
            finer = _of_inputs(tau, shifted, goal + 2, max_bits)
            enclosed = (_tighter(finer[0], enclosed[0]), *finer[1:])
    value, route, bits, reason = enclosed
    if derivative:
        with working_bits(goal + 32):
            value = value * factor
    elif bits <= goal + _FEW_MORE_BITS and route == "taylor":
        return enclosed
    return shrink_to_bits(value, goal + 16), route, bits, reason


def _of_inputs(tau: Exact, beta: Exact, goal: int, max_bits: int | None) -> _Enclosed:
    enclosed = _approach(tau, beta, goal, max_bits)
    if isinstance(tau, arb) and not tau.is_exact():
        return _centred(enclosed, tau, beta, goal, max_bits)
    return enclosed


def _bits_of_input(tau: Exact, beta: Exact) -> int:
    """How many bits of the result are worth asking for at first: no more than the input balls have, and some.

    A heuristic: more bits than that cannot narrow the answer, but cost time, and rule out the asymptotic routes.
    """
    if isinstance(tau, fmpq) and isinstance(beta, fmpq):
        return MAX_WORKING_BITS
    radii = [_exponent(value.rad()) for value in (tau, beta) if isinstance(value, arb) and not value.is_exact()]
    size = max(abs(approximate(tau)), abs(approximate(beta)), 1.0)
    return max(
        _LEAST_SECOND_GOAL, min((math.ceil(math.log2(size)) + _ROOM - r for r in radii), default=MAX_WORKING_BITS)
    )


def _exponent(radius: arb) -> int:
    """The binary exponent of a radius, as far as it matters here."""
    mantissa, exponent = radius.man_exp()
    return max(-MAX_WORKING_BITS, min(int(exponent), MAX_WORKING_BITS)) + int(mantissa).bit_length()


@lru_cache(maxsize=64)
def _cached_polynomial(n: int) -> fmpq_poly:
    return polynomial(n)


def _exact_polynomial(tau: Exact, beta: Exact, goal: int) -> _Enclosed | None:
    """Theta at an integer beta and a rational tau, exactly, while its integers stay small."""
    if not (isinstance(tau, fmpq) and isinstance(beta, fmpq) and beta.q == 1 and beta.p >= 0):
        return None
    n = int(beta.p)
    if n * (tau.height_bits() + n.bit_length()) > _EXACT_POLYNOMIAL_BITS:
        return None
    with working_bits(goal + 32):
        return arb(_cached_polynomial(n)(tau)), "polynomial", goal, None


def _approach(tau: Exact, beta: Exact, goal: int, max_bits: int | None) -> _Enclosed:
    """Raise the precision until ``goal`` relative bits are certain, or the budget ends, or balls forbid more."""
    budget = max_bits or 8 * goal + 16_384
    wanted = min(goal, budget)
    route, value = _attempt(tau, beta, wanted)
    certain = relative_bits(value)
    exact_input = is_exact(tau) and is_exact(beta)
    while certain < goal:
        following = wanted + max(goal - certain, 16) + 8 if certain > 0 else 2 * wanted + 64
        if following > budget:
            return value, route, wanted, Reason.BUDGET
        try:
            route, finer = _attempt(tau, beta, following)
        except BudgetError:
            return value, route, wanted, Reason.BUDGET
        wanted = following
        if not exact_input and not certainly_less(4 * finer.rad(), value.rad()):
            return _tighter(finer, value), route, wanted, Reason.WIDE_INPUT
        value = _tighter(finer, value)
        certain = relative_bits(value)
    return value, route, wanted, None


def _tighter(first: arb, second: arb) -> arb:
    """The common part of two enclosures of the same number; one that is not finite says nothing.

    :raises ArithmeticError: they are disjoint, so one of them is wrong.
    """
    if not first.is_finite():
        return second
    if not second.is_finite():
        return first
    if not first.overlaps(second):
        raise ArithmeticError(f"two enclosures of one number are disjoint, please report it: {first} and {second}")
    with working_bits(max(64, first.bits() + 32, second.bits() + 32)):
        return first.intersection(second)


def _centred(enclosed: _Enclosed, tau: arb, beta: Exact, goal: int, max_bits: int | None) -> _Enclosed:
    """The common part with the mean value form over the ball tau."""
    center = _approach(tau.mid(), beta, goal, max_bits)[0]
    with working_bits(goal + 64):
        below = beta - 1
    form = mean_value_form(beta, tau.rad(), center, _attempt(tau, below, goal)[1], goal + 64)
    return _tighter(enclosed[0], form), *enclosed[1:]


def _majorant(tau: Exact, beta: Exact) -> arb:
    """A finite ball for inputs so wide that every route gave up."""
    goal = _LEAST_SECOND_GOAL
    with working_bits(goal):
        farthest, size = (exact(ball(value).abs_upper(), "") for value in (tau, beta))
    if not (isinstance(farthest, fmpq) and isinstance(size, fmpq)):
        return nonfinite()
    size = max(size, fmpq(1))
    return majorant_bound(beta, size, _attempt(farthest, -size, goal)[1], goal)


def _attempt(tau: Exact, beta: Exact, goal: int) -> tuple[str, arb]:
    """One enclosure by the route that the heuristics prefer for ``goal`` bits; the next one when it is not finite."""
    for name in choice.preferred_routes(tau, beta, goal):
        value = routes.ROUTES[name](tau, beta, goal)
        if value.is_finite():
            return name, value
    if not (is_exact(tau) and is_exact(beta)):
        return "majorant", _majorant(tau, beta)
    if goal < _LEAST_SECOND_GOAL:
        return _attempt(tau, beta, _LEAST_SECOND_GOAL)
    raise BudgetError(
        f"no route reaches {goal} bits at this tau and beta within memory and time: ask for fewer digits, "
        "a smaller |tau|, or a beta of smaller denominator"
    )
