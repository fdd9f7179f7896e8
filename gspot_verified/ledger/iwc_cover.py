"""dTheta/dtau < 0 for 0 < beta < 1 and every real tau, by the second proof of ``proofs/signs.md``.

F = Theta(., b), b = beta - 1 in [-1, 0], is shown to be positive on three pieces that cover the line.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from flint import fmpq

from gspot_verified.balls import working_bits
from gspot_verified.dyadic import Dyadic
from gspot_verified.theta.routes import taylor

LEFT = Dyadic(-81, 0, -6)
"""The compact piece of tau, [-81/64, 0]: it reaches beyond -2^(1/3), because (81/64)^3 > 2."""

PARAMETER = Dyadic(-1, 0)
"""b from -1 to 0, both ends included."""

_GOAL_BITS = 53


@dataclass(frozen=True, slots=True)
class Cover:
    """The boxes (tau, b) on which F > 0 is certain, and those left when the budget ended."""

    positive: tuple[tuple[Dyadic, Dyadic], ...]
    remaining: tuple[tuple[Dyadic, Dyadic], ...]

    @property
    def complete(self) -> bool:
        """True when nothing remains and the boxes, which bisection keeps disjoint, have the area of the whole."""
        return not self.remaining and sum(_area(*box) for box in self.positive) == _area(LEFT, PARAMETER)


def left_piece_reaches() -> bool:
    """Whether the compact piece meets the enveloping series' range tau <= -2^(1/3), exactly."""
    lower = LEFT.endpoints()[0]
    return -(lower**3) >= 2


def cover_compact_piece(budget: int = 4_000) -> Cover:
    """Bisect [-81/64, 0] x [-1, 0] until a ball for F is positive on every box, at most ``budget`` evaluations.

    >>> cover_compact_piece().complete
    True
    """
    waiting = [(LEFT, PARAMETER)]
    positive: list[tuple[Dyadic, Dyadic]] = []
    while waiting and budget > 0:
        tau, b = waiting.pop()
        budget -= 1
        if taylor(tau.to_ball(), b.to_ball(), _GOAL_BITS) > 0:
            positive.append((tau, b))
        else:
            waiting += [(tau, half) for half in _halves(b)] if _wider(b, tau) else [(half, b) for half in _halves(tau)]
    return Cover(tuple(positive), tuple(waiting))


def right_piece_is_positive() -> bool:
    """tau >= 0: the arguments of 1/Gamma in F(0), F'(0), F''(0) are in (0, 1] or on its rim for b in (-1, 0).

    -b/3, (1-b)/3, (2-b)/3 > 0 for every b < 0, so the three values are positive; k - b > 0 keeps every Taylor
    coefficient positive. Checked as exact inequalities at the ends b = -1 and b = 0, between which they are linear.
    """
    ends = (fmpq(-1), fmpq(0))
    return all((j - b) / 3 > 0 for b in ends for j in (1, 2)) and all(-b >= 0 for b in ends)


def _area(tau: Dyadic, b: Dyadic) -> Fraction:
    (left, right), (lower, upper) = tau.endpoints(), b.endpoints()
    return (right - left) * (upper - lower)


def _halves(interval: Dyadic) -> tuple[Dyadic, Dyadic]:
    lower, upper, exponent = 2 * interval.lower, 2 * interval.upper, interval.exponent - 1
    middle = (lower + upper) // 2
    return Dyadic(lower, middle, exponent), Dyadic(middle, upper, exponent)


def _wider(first: Dyadic, second: Dyadic) -> bool:
    with working_bits(64):
        return bool(first.to_ball().rad() >= second.to_ball().rad())
