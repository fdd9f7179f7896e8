"""The fast solutions P_+ and Q at one time by quadrature: integrals of w(r) e^(r T) over two rays from a corner.

Proof page: ``proofs/fast_part.md``, section 2.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

from flint import acb, arb, fmpq

from gspot_verified.compliant.fast.decaying_coefficient import real_saddle
from gspot_verified.compliant.fast.fast_coefficient import saddle
from gspot_verified.numbers.balls import add_remainder, approximate, nonfinite, working_bits
from gspot_verified.theta_function.sums.quadrature import holomorphic_integral

_GUARD_BITS = 32  # bits beyond those asked for, lost on the way; any number is right

Multiplier = Callable[[acb, acb], acb]
"""A factor of w as a function of r and 1 + r, without 1/(epsilon beta)."""

MULTIPLIERS: dict[str, Multiplier] = {
    "b": lambda _r, _: acb(1),
    "force": lambda r, _: r,
    "Z": lambda r, one_plus_r: -r / one_plus_r,
    "V": lambda r, one_plus_r: -r * r * (1 + 1 / one_plus_r),
}
"""(5) of proofs/exact_solution.md: b-hat with 1, the others with 1/(epsilon beta) in front of these."""


@dataclass(frozen=True, slots=True)
class Ray:
    """The integrand of P_+ or Q on r = corner + direction rho, divided by e^height; p = -epsilon T."""

    beta: arb
    epsilon: arb
    p: arb
    corner: acb
    direction: acb
    height: arb
    decaying: bool

    def exponent(self, r: acb, analytic: bool = False) -> acb:
        """(psi(r) - p r)/epsilon, with the branch of log(1 + r) that P_+ or Q has."""
        logarithm = (-1 - r).log(analytic) if self.decaying else (1 + r).log(analytic)
        return (r * (1 - self.p - r / 2 - r * r / 3) - logarithm) / self.epsilon

    def integral(self, multiplier: Multiplier, goal: float) -> acb:
        """The integral over rho in (0, oo) times ``direction``; ``goal``: the cut tail is near e^-goal."""
        last = self._last(goal)

        def integrand(rho: acb, analytic: bool) -> acb:
            r = self.corner + self.direction * rho
            base = -r if self.decaying else r
            exponent = -(self.beta + 1) * base.log(analytic) + self.exponent(r, analytic) - self.height
            return exponent.exp() * multiplier(r, 1 + r)

        middle = holomorphic_integral(integrand, arb(0), last)
        bound = self._beyond(last)
        around = add_remainder(arb(0), bound)
        return self.direction * (middle + acb(around, around))

    def _last(self, goal: float) -> arb:
        """Where the cube has won; any number is right."""
        small, size, p = (approximate(v) for v in (self.epsilon, abs(self.corner), abs(self.p)))
        return arb(math.ceil(5 * size + 8 + 3 * math.sqrt(p) + (12 * small * goal) ** (1 / 3)))

    def _beyond(self, last: arb) -> arb:
        """rho >= R: the real part of the exponent falls at least as fast as d(R)/epsilon, and
        |multiplier| |r|^(-beta-1) <= 2 |r| <= 2 (|corner| + rho)."""
        size, cube = abs(self.corner), (self.direction**3).real
        slope = cube * last * last - (2 * size + 1) * last - (size * size + size + 2 + abs(self.p))
        rate = slope / self.epsilon - 1 / last
        rising = 2 * cube * last - 2 * size - 1
        if not (cube > 0 and slope > 0 and rate > 0 and rising > 0 and last >= size + 2):
            return nonfinite()
        r = self.corner + self.direction * last
        return 2 * (size + last) * (self.exponent(r).real - self.height).exp() / rate


def oscillating(beta: fmpq, epsilon: fmpq, p: fmpq, names: tuple[str, ...], bits: int) -> tuple[list[acb], arb]:
    """The integrals of w(r) e^(r T) times each multiplier over the contour of P_+, divided by e^height, and height.

    The contour comes from infinity e^(2 pi i/3) to a corner and goes on to +infinity; any corner with Im > 0, or on the
    positive axis, is right.
    """
    lost = max(0, math.ceil(-math.log2(approximate(epsilon))))
    with working_bits(bits + lost + _GUARD_BITS):
        corner = _corner(epsilon, p)
        left, right = acb(arb(fmpq(-1, 2)), arb(3).sqrt() / 2), _falling()
        flat = Ray(arb(beta), arb(epsilon), arb(p), corner, left, arb(0), False)
        height = flat.exponent(corner).real.mid()
        if not _admissible(corner, right):
            return [acb(nonfinite(), nonfinite()) for _ in names], height
        incoming, outgoing = (replace(flat, direction=d, height=height) for d in (left, right))
        goal = (bits + 8 + 8 * approximate(beta)) * math.log(2)
        integrals = []
        for name in names:
            multiplier, front = MULTIPLIERS[name], _front(name, beta, epsilon)
            integrals.append(front * (outgoing.integral(multiplier, goal) - incoming.integral(multiplier, goal)))
        return integrals, height


def _front(name: str, beta: fmpq, epsilon: fmpq) -> arb:
    return arb(1) if name == "b" else 1 / (arb(epsilon) * arb(beta))


def _falling() -> acb:
    """e^(-i pi/9): towards +infinity, and downwards over a saddle whose axis is near e^(-i pi/4)."""
    return acb(0, -arb.pi() / 9).exp()


def _corner(epsilon: fmpq, p: fmpq) -> acb:
    """The saddle r_+ while it is apart from 0, else a point of the positive axis; a heuristic."""
    near = 2 * (approximate(epsilon) / 2) ** (1 / 3)
    if p > 0 and math.sqrt(approximate(p) / 2) > near:
        return saddle(p)
    return acb(max(near, math.sqrt(max(0.0, -approximate(p)) / 2)))


def _admissible(corner: acb, right: acb) -> bool:
    """Neither ray meets (-infinity, 0]: the left one stays above the axis, the right one crosses it at a point > 0."""
    if corner.imag.is_zero():
        return bool(corner.real > 0)
    crossing = corner.real - corner.imag * right.real / right.imag
    return bool(corner.imag > 0 and crossing > 0)


def decaying(beta: fmpq, epsilon: fmpq, p: fmpq, names: tuple[str, ...], bits: int) -> tuple[list[arb], arb]:
    """Q with each multiplier, divided by e^height, and height: Q = -2 Im int over r = r_3 + e^(2 pi i/3) rho."""
    lost = max(0, math.ceil(-math.log2(approximate(epsilon))))
    with working_bits(bits + lost + _GUARD_BITS):
        corner = acb(real_saddle(p))
        direction = acb(arb(fmpq(-1, 2)), arb(3).sqrt() / 2)
        flat = Ray(arb(beta), arb(epsilon), arb(p), corner, direction, arb(0), True)
        height = flat.exponent(corner).real.mid()
        ray = replace(flat, height=height)
        goal = (bits + 8 + 8 * approximate(beta)) * math.log(2)
        return [-2 * ray.integral(MULTIPLIERS[n], goal).imag * _front(n, beta, epsilon) for n in names], height
