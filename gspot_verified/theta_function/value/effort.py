"""How long one value at very many digits will take: a rough guess in floats, for announcements only."""

from __future__ import annotations

import math
from typing import NamedTuple

from flint import fmpq

from gspot_verified.numbers.balls import Exact, approximate, bits_for_digits
from gspot_verified.theta_function.value import choice
from gspot_verified.theta_function.value.routes import (
    MAX_SPLITTING_BITS,
    MAX_TERM_BITS,
    far_splitting_bits,
    splitting_bits,
)

# Measured with FLINT 3.6 on one core of an x86-64 server, 20,000 to 100,000 digits; within a factor of about 3.
_SECONDS_OF_A_PRODUCT = 1.2e-10
_PRODUCTS_OF_A_SADDLE_TERM = 1.5  # a guess: later terms have fewer bits
_PRODUCTS_OF_A_NEGATIVE_TERM = 1.0  # a guess: all terms have all bits
# Splitting, with short integers in beta and tau and with long ones (most of it is Gamma then).
_SPLITTING = {"negative": (5e-10, 1.2e-9), "positive": (3e-9, 8e-9), "splitting": (3.5e-9, 1.4e-8)}
_SHORT_HEIGHT = {"negative": 66, "positive": 66, "splitting": 8}


class Effort(NamedTuple):
    """The route that is tried first, and about how many seconds it takes."""

    route: str
    seconds: float

    def __str__(self) -> str:
        if self.seconds < 90:
            return f"about {max(1, round(self.seconds))} s"
        return f"about {round(self.seconds / 60)} minutes"


def expected_effort(tau: Exact, beta: Exact, digits: int) -> Effort | None:
    """The work of the route that :func:`theta_function.value.evaluate.evaluate` tries first; None: no model.

    Products of numbers of n bits cost n log n; a saddle or an enveloping series has a few for each term (the saddle
    series with fewer and fewer bits), binary splitting costs n log^2 n.

    >>> print(expected_effort(fmpq(10**6), fmpq(7, 3), 10**5))
    about 1 s
    """
    goal = bits_for_digits(digits) + 2
    point, parameter = approximate(tau), approximate(beta)
    for route in choice.preferred_routes(tau, beta, goal):
        if route == "positive":
            saddle = choice.saddle_plan(point, parameter, goal)
            bits = choice.saddle_bits(point, parameter, goal)
            if saddle is not None and choice.prefers_splitting(tau, beta, bits):
                return _of_splitting(route, tau, beta, bits, saddle.terms)
            if saddle is not None and saddle.terms * bits <= MAX_TERM_BITS:
                return Effort(route, _PRODUCTS_OF_A_SADDLE_TERM * saddle.terms * _product(bits))
        elif route == "negative":
            enveloping = choice.negative_plan(-point, parameter, goal)
            if enveloping is not None and choice.prefers_splitting(tau, beta, enveloping.bits):
                return _of_splitting(route, tau, beta, enveloping.bits, enveloping.terms)
            if enveloping is not None and enveloping.terms * enveloping.bits <= MAX_TERM_BITS:
                return Effort(route, _PRODUCTS_OF_A_NEGATIVE_TERM * enveloping.terms * _product(enveloping.bits))
        elif route == "splitting" and isinstance(tau, fmpq) and isinstance(beta, fmpq):
            plan = choice.taylor_plan(point, parameter, goal)
            if splitting_bits(tau, beta, plan.length) <= MAX_SPLITTING_BITS:
                return _of_splitting(route, tau, beta, plan.bits, 0)
        else:
            return None
    return None


def _of_splitting(route: str, tau: Exact, beta: Exact, bits: int, terms: int) -> Effort | None:
    if not (isinstance(tau, fmpq) and isinstance(beta, fmpq)):
        return None
    if far_splitting_bits(tau, beta, terms) > MAX_SPLITTING_BITS:
        return None
    height = 3 * tau.height_bits() + beta.height_bits()
    rate = _SPLITTING[route][height > _SHORT_HEIGHT[route]]
    return Effort(route, rate * bits * math.log2(bits) ** 2)


def _product(bits: int) -> float:
    return _SECONDS_OF_A_PRODUCT * bits * math.log2(bits)
