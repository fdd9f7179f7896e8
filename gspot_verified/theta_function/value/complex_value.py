"""Theta at a complex tau to a given relative accuracy.

Proof pages: ``proofs/identities.md``, "Mean value form", and ``proofs/majorant.md``.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import ClassVar

from flint import acb, fmpq

from gspot_verified.numbers.balls import (
    Exact,
    add_remainder,
    ball,
    ball_text,
    certainly_less,
    exact,
    is_exact,
    shrink_to_bits,
    working_bits,
)
from gspot_verified.numbers.complex_numbers import ExactComplex, approximate_complex, complex_ball, is_point, middle
from gspot_verified.numbers.verdict import NoTruthValue, Reason
from gspot_verified.numbers.written import Written
from gspot_verified.theta_function.value import choice
from gspot_verified.theta_function.value.approach import approach, attempt, bits_of_input, majorant, no_route, tighter
from gspot_verified.theta_function.value.majorant import turned_argument, turned_bound
from gspot_verified.theta_function.value.mean_value import mean_value_form
from gspot_verified.theta_function.value.routes import COMPLEX_ROUTES, BudgetError, shifted_parameter

_BITS_OF_A_BOUND = 64  # of a bound, of which a few digits count; any number is right
_MOST_LEVELS = 64  # of mean value forms, one in another; any number is right


@dataclass(frozen=True, slots=True)
class ComplexEvaluation(NoTruthValue, Written):
    """The result of :func:`gspot_verified.theta_function.value.evaluate.evaluate` at a complex tau.

    ``value`` is a rectangle: a ball for the real part and one for the imaginary part. It contains the exact result for
    every exact input in the input balls, always. ``reached`` says whether no number in it is farther from its midpoint
    than 10^-digits times the size of the complex value: a part that is much smaller than the other one has fewer digits
    of its own. When it is not reached, ``reason`` says why.
    """

    ask: ClassVar[str] = ".reached says whether the accuracy was reached"
    written: ClassVar[str] = "value=__str__ enclosure=value digits reached route working_bits reason"

    value: acb
    digits: int
    reached: bool
    route: str
    working_bits: int
    reason: Reason | None = None

    def __str__(self) -> str:
        return ball_text(self.value, self.digits)


EnclosedComplex = tuple[acb, str, int, Reason | None]
"""An enclosure, its route, the bits that were asked of the route, and why it is wider than asked (if it is)."""


def complex_value(tau: ExactComplex, beta: Exact, derivative: int, goal: int, max_bits: int | None) -> EnclosedComplex:
    """d^k Theta/dtau^k (tau, beta), k = ``derivative``, with ``goal`` relative bits where they can be had."""
    if derivative and isinstance(beta, fmpq) and beta.q == 1 and 0 <= beta.p < derivative:
        return acb(0), "polynomial", 0, None
    shifted, factor = shifted_parameter(beta, derivative, goal)
    exact_input = is_point(tau) and is_exact(beta)
    worth = min(goal + 2, bits_of_input(*tau, shifted))
    value, route, bits, reason = approach(partial(_attempt, tau, shifted), exact_input, worth, max_bits)
    if not is_point(tau):
        value = _around_middle(value, tau, shifted, worth, max_bits)
    with working_bits(goal + 32):
        value = value * factor
    return shrink_to_bits(value, goal + 16), route, bits, reason


def _attempt(tau: ExactComplex, beta: Exact, goal: int) -> tuple[str, acb]:
    for name, route in COMPLEX_ROUTES.items():
        value = route(tau, beta, goal)
        if value.is_finite():
            return name, value
    if is_point(tau) and is_exact(beta):
        raise _none_reaches(tau, goal)
    with working_bits(goal):
        reach = majorant(complex_ball(tau), beta)
    return "majorant", acb(reach, reach)


def _none_reaches(tau: ExactComplex, goal: int) -> BudgetError:
    """Left of the imaginary axis the enveloping series reaches any size; right of it the series at 0 must."""
    with working_bits(_BITS_OF_A_BOUND):
        re, im = map(ball, tau)
        far = complex_ball(tau).abs_upper().str(3, radius=False)
    if re > 0 and im != 0:
        return BudgetError(
            f"no route reaches {goal} bits at this tau within memory and time: where the real part of a complex tau is "
            f"positive only the series at 0 does, up to a |tau| of about 1000 (more next to the real axis); here |tau| "
            f"is about {far}. Fewer digits hardly help; a smaller |tau|, a real part <= 0, or an integer beta >= 0 does"
        )
    return no_route(goal)


def _around_middle(direct: acb, tau: ExactComplex, beta: Exact, goal: int, max_bits: int | None) -> acb:
    """The common part of an enclosure over the rectangle tau and mean value forms, one in another.

    The slope in each form is bounded by the next one, that in the last over the whole rectangle, which may be far too
    wide: each form multiplies that by the size of the rectangle. Twice as many forms are tried as long as that helps.
    """
    point, radius = middle(tau)
    centers: list[acb] = []
    levels = choice.first_levels(beta, _MOST_LEVELS)
    while levels <= _MOST_LEVELS:
        with working_bits(goal + 64):
            betas = [beta - j for j in range(levels + 1)]
        try:
            for each in betas[len(centers) : levels]:
                centers.append(approach(partial(_attempt, point, each), is_exact(beta), goal, max_bits)[0])
            form = _over_rectangle(tau, betas[levels], goal)
        except BudgetError:
            return direct
        for each, center in zip(reversed(betas[:levels]), reversed(centers), strict=True):
            form = mean_value_form(each, radius, center, form, goal + 64)
        finer = tighter(direct, form)
        if not certainly_less(2 * finer.rad(), direct.rad()):
            return finer
        direct, levels = finer, 2 * levels
    return direct


def _over_rectangle(tau: ExactComplex, beta: Exact, goal: int) -> acb:
    """The common part of what a route encloses and of the majorant on a turned ray, where beta < 0."""
    direct = _attempt(tau, beta, goal)[1]
    if beta < 0:
        tangent = choice.turn(approximate_complex(tau))
        farthest = exact(turned_argument(complex_ball(tau), tangent, _BITS_OF_A_BOUND), "")
        bound = turned_bound(beta, tangent, attempt(farthest, beta, _BITS_OF_A_BOUND)[1], _BITS_OF_A_BOUND)
        return tighter(direct, add_remainder(acb(0), bound))
    return direct
