"""Numbers with which the tube and the hand-over are tried. Heuristic: whatever passes the checks is right."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from flint import fmpq

from gspot_verified.expansion.chart.cone import rational_of
from gspot_verified.expansion.from_state.slow_series import Contact
from gspot_verified.expansion.true_solutions.side import REACH
from gspot_verified.numbers.balls import Exact, approximate

_K_1, _K_2 = fmpq(1), fmpq(1, 2)  # of the norm
_DAMPINGS = (fmpq(1, 5), fmpq(1, 10), fmpq(1, 25))  # theta in units of l/g, whose true value is 1/2 for small p
_ABOVE = (fmpq(1, 20), fmpq(1, 5), fmpq(3, 10), fmpq(1, 2))  # of Gamma_E over its limit (beta - 3/2)/2
_NEAR = 10**6  # of numbers that may be any near another one: multiples of 1/_NEAR
_TAU = 3.17  # where a hand-over is tried, in units of tau: the slow series is good there
_FARTHER = (1.0, 1.25, 1.5)
_LAYER = 20.0  # of p^2/e, from which on what is fast at a start near the G-spot falls
LARGEST = (*(fmpq(1, n) for n in (500, 100, 30, 10, 5, 3, 2)), fmpq(3, 4))
"""z_max, the smallest first: Gamma grows with it."""
LARGEST_DELTA = fmpq(1, 8)
"""Up to which delta ranges are followed when no epsilon is given."""


@dataclass(frozen=True)
class Plan:
    """k_1, k_2, Gamma_E, theta, K and S."""

    k_1: fmpq
    k_2: fmpq
    growth: fmpq
    damping: fmpq
    order: int
    place: fmpq

    @property
    def text(self) -> str:
        """The plan in words."""
        return f"Gamma_E = {self.growth}, theta = {self.damping}, order {self.order}, S = {self.place}"


def plans(beta: fmpq, a: fmpq, contact: Contact) -> Iterator[list[Plan]]:
    """For one S after the other, the nearest first: the likeliest first."""
    scale = approximate(a * contact.kappa) ** (1 / 3)
    for number, far in enumerate(_FARTHER):
        order = math.floor(approximate(beta) + 0.5) + 2 + number
        place = fmpq(math.ceil(8 * far * _TAU / scale), 8)
        yield [
            Plan(_K_1, _K_2, (beta - fmpq(3, 2)) / 2 + above, share * contact.lag / contact.rate, order, place)
            for share in _DAMPINGS
            for above in _ABOVE
        ]


def affine_plans(beta: fmpq, a: Exact, contact: Contact) -> Iterator[list[Plan]]:
    """From a small p, where the damping is near its value for small p: for each norm, the sharpest rate first."""
    scale = approximate(a * contact.kappa) ** (1 / 3)
    place = fmpq(math.ceil(8 * _TAU / scale), 8)
    order = math.floor(approximate(beta) + 0.5) + 2
    for k_1, k_2, share in ((fmpq(8, 5), fmpq(12, 25), fmpq(2, 5)), (_K_1, _K_2, fmpq(1, 5))):
        damping = share * contact.lag / contact.rate
        yield [Plan(k_1, k_2, (beta - fmpq(3, 2)) / 2 + above, damping, order, place) for above in _ABOVE]


def near(value: Exact) -> fmpq:
    """A rational number near it; no integer, unless the middle of the ball is one."""
    if isinstance(value, fmpq):
        return value
    rounded = fmpq(round(approximate(value) * _NEAR), _NEAR)
    return rounded if rounded.q != 1 else rational_of(value.mid())


def largest_delta(p: Exact, a: Exact) -> fmpq:
    """Up to which delta ranges are followed from a small p: far beyond, what is fast at the start is still there."""
    goal = 2 * (approximate(p) ** 2 / approximate(a) / _LAYER) ** (1 / 3)
    delta = LARGEST_DELTA
    while approximate(delta) > goal:
        delta /= 4
    return delta


def reach_for(beta: fmpq) -> float:
    """tau up to which a cone is looked for: the deviation has its last zeros later for a larger beta."""
    return REACH + max(0.0, approximate(beta) - 2.0)
