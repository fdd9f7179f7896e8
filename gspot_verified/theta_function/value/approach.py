"""Enclosures by the preferred route, and precision raised until enough bits are certain."""

from __future__ import annotations

import math
from collections.abc import Callable

from flint import acb, arb, fmpq

from gspot_verified.numbers.balls import (
    MAX_WORKING_BITS,
    Ball,
    Exact,
    approximate,
    ball,
    certainly_less,
    exact,
    is_exact,
    nonfinite,
    relative_bits,
    working_bits,
)
from gspot_verified.numbers.verdict import Reason
from gspot_verified.theta_function.value import choice, routes
from gspot_verified.theta_function.value.majorant import majorant_bound
from gspot_verified.theta_function.value.routes import BudgetError

# Where every route failed at a lower goal, rounding may have hidden a hypothesis: once more with this many bits.
_LEAST_SECOND_GOAL = 128
_ROOM = 64  # bits beyond those of the inputs


def approach(
    attempt: Callable[[int], tuple[str, Ball]], exact_input: bool, goal: int, max_bits: int | None
) -> tuple[Ball, str, int, Reason | None]:
    """Raise the precision until ``goal`` relative bits are certain, or the budget ends, or balls forbid more.

    ``attempt`` gives for a number of bits the route and an enclosure, always of the same number. The result: the
    enclosure, its route, the bits that were asked of the route, and why it is wider than asked (if it is).
    """
    budget = max_bits or 8 * goal + 16_384
    wanted = min(goal, budget)
    route, value = attempt(wanted)
    certain = relative_bits(value)
    while certain < goal:
        following = wanted + max(goal - certain, 16) + 8 if certain > 0 else 2 * wanted + 64
        if following > budget:
            return value, route, wanted, Reason.BUDGET
        try:
            route, finer = attempt(following)
        except BudgetError:
            return value, route, wanted, Reason.BUDGET
        wanted = following
        if not exact_input and not certainly_less(4 * finer.rad(), value.rad()):
            return tighter(finer, value), route, wanted, Reason.WIDE_INPUT
        value = tighter(finer, value)
        certain = relative_bits(value)
    return value, route, wanted, None


def bits_of_input(*values: Exact) -> int:
    """How many bits of the result are worth asking for at first: no more than the input balls have, and some.

    A heuristic: more bits than that cannot narrow the answer, but cost time, and rule out the asymptotic routes.
    """
    radii = [_exponent(value.rad()) for value in values if isinstance(value, arb) and not value.is_exact()]
    if not radii:
        return MAX_WORKING_BITS
    size = max(1.0, *(abs(approximate(value)) for value in values))
    return max(_LEAST_SECOND_GOAL, math.ceil(math.log2(size)) + _ROOM - max(radii))


def _exponent(radius: arb) -> int:
    """The binary exponent of a radius, as far as it matters here."""
    mantissa, exponent = radius.man_exp()
    return max(-MAX_WORKING_BITS, min(int(exponent), MAX_WORKING_BITS)) + int(mantissa).bit_length()


def tighter(first: Ball, second: Ball) -> Ball:
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
        if isinstance(first, arb):
            return first.intersection(second)
        return acb(first.real.intersection(second.real), first.imag.intersection(second.imag))


def attempt(tau: Exact, beta: Exact, goal: int) -> tuple[str, arb]:
    """One enclosure by the route that the heuristics prefer for ``goal`` bits; the next one when it is not finite."""
    for name in choice.preferred_routes(tau, beta, goal):
        value = routes.ROUTES[name](tau, beta, goal)
        if value.is_finite():
            return name, value
    if not (is_exact(tau) and is_exact(beta)):
        return "majorant", majorant(ball(tau), beta)
    if goal < _LEAST_SECOND_GOAL:
        return attempt(tau, beta, _LEAST_SECOND_GOAL)
    raise no_route(goal)


def no_route(goal: int) -> BudgetError:
    """The error of a request that no route can meet."""
    return BudgetError(
        f"no route reaches {goal} bits at this tau and beta within memory and time: ask for fewer digits, "
        "a smaller |tau|, or a beta of smaller denominator"
    )


def majorant(tau: arb | acb, beta: Exact) -> arb:
    """A finite ball for inputs so wide that every route gave up: it contains |Theta| and -|Theta|."""
    goal = _LEAST_SECOND_GOAL
    with working_bits(goal):
        farthest, size = (exact(value.abs_upper(), "") for value in (tau, ball(beta)))
    if not (isinstance(farthest, fmpq) and isinstance(size, fmpq)):
        return nonfinite()
    size = max(size, fmpq(1))
    return majorant_bound(beta, size, attempt(farthest, -size, goal)[1], goal)
