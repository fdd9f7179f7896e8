"""Theta at a complex tau to a given relative accuracy."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import ClassVar

from flint import acb, fmpq

from gspot_verified.numbers.balls import (
    Exact,
    ball_text,
    is_exact,
    shrink_to_bits,
    working_bits,
)
from gspot_verified.numbers.complex_numbers import ExactComplex, complex_ball, is_point, middle
from gspot_verified.numbers.verdict import NoTruthValue, Reason
from gspot_verified.numbers.written import Written
from gspot_verified.theta_function.value.approach import approach, bits_of_input, majorant, no_route, tighter
from gspot_verified.theta_function.value.mean_value import mean_value_form
from gspot_verified.theta_function.value.routes import COMPLEX_ROUTES, shifted_parameter

_LEVELS = 2  # of mean value forms, one in another; any number is right


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
        value = tighter(value, _around_middle(tau, shifted, worth, max_bits))
    with working_bits(goal + 32):
        value = value * factor
    return shrink_to_bits(value, goal + 16), route, bits, reason


def _attempt(tau: ExactComplex, beta: Exact, goal: int) -> tuple[str, acb]:
    for name, route in COMPLEX_ROUTES.items():
        value = route(tau, beta, goal)
        if value.is_finite():
            return name, value
    if is_point(tau) and is_exact(beta):
        raise no_route(goal)
    with working_bits(goal):
        reach = majorant(complex_ball(tau), beta)
    return "majorant", acb(reach, reach)


def _around_middle(tau: ExactComplex, beta: Exact, goal: int, max_bits: int | None, levels: int = _LEVELS) -> acb:
    """The mean value form over the rectangle tau; its slope is enclosed by another one, down to so many ``levels``."""
    point, radius = middle(tau)
    center = approach(partial(_attempt, point, beta), is_exact(beta), goal, max_bits)[0]
    with working_bits(goal + 64):
        below = beta - 1
    slope = _attempt(tau, below, goal)[1]
    if levels > 1:
        slope = tighter(slope, _around_middle(tau, below, goal, max_bits, levels - 1))
    return mean_value_form(beta, radius, center, slope, goal + 64)
