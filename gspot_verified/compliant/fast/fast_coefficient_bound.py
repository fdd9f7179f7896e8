"""Bounds of c_+ and c_Q for every epsilon up to a largest one, each divided by its exponential at the saddle.

Proof page: ``proofs/fast_part.md``, section 6.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from flint import acb, arb, fmpq

from gspot_verified.compliant.fast.decaying_coefficient import real_saddle
from gspot_verified.compliant.fast.fast_coefficient import saddle
from gspot_verified.compliant.fast.modulus_sum import PathPiece, modulus_sum
from gspot_verified.compliant.model.kernel import Kernel
from gspot_verified.numbers.balls import nonfinite

_STEPS = 60  # by a quarter each, against endless work; any depth is right


@dataclass(frozen=True, slots=True)
class Weight:
    """s^power k(s) in the integrals of c_+ and c_Q: ``polynomial`` is (1 + s) k(s) as a function of s and 1 + s.

    |k| <= size |s|^3 where |s| and |1 + s| are at least 1, and |polynomial| <= 2 size where |1 + s| <= 1/4."""

    power: arb
    polynomial: Callable[[acb, acb], acb]
    size: arb


def state_weight(data: Kernel) -> Weight:
    """s^(beta-1) k(s) of a state."""
    return Weight(data.beta - 1, data.polynomial, data.size)


def unit_weight(beta: arb) -> Weight:
    """s^(beta-2), k = 1: the integrals that are left for the paper's data."""
    return Weight(beta - 2, lambda _, one_plus_s: one_plus_s, arb(2))


def oscillating_coefficient_bound(weight: Weight, p: fmpq, largest: arb) -> arb:
    """A bound of e^(Re g(r_+)/epsilon) |int s^power k(s) e^((-psi(s) + p s)/epsilon) ds|, from -1 over r_+ to oo."""
    top, small = saddle(p), arb(p)
    height = _exponent(top, p).real
    start, direction = 1 + top, acb(arb(fmpq(1, 2)), arb(3).sqrt() / 2)
    reach = 3 * abs(top) + 4 + 2 * small.sqrt()

    def near(x: arb) -> tuple[acb, acb]:
        rest = start * (-x).exp()
        return rest - 1, rest

    def near_slope(x: arb) -> acb:
        s, rest = near(x)
        return -(small * rest + s * s * (1 + rest))

    def near_curvature(x: arb) -> acb:
        s, rest = near(x)
        return (3 * s * s + 4 * s + small) * rest

    first = _depth(lambda depth: _before(weight, start, small, depth, height, largest))
    inner = PathPiece(
        first,
        lambda x: start.log() - x + _polynomial(near(x)[0], p),
        near_slope,
        lambda x: [_front(weight, *near(x))],
        near_curvature,
    )

    def place(x: arb) -> acb:
        return top + direction * x

    def slope(x: arb) -> acb:
        s = place(x)
        return direction * (small + s * s * (1 + 1 / (1 + s)))

    def curvature(x: arb) -> acb:
        s = place(x)
        return direction * direction * (2 * s + 1 - 1 / (1 + s) ** 2)

    outer = PathPiece(
        reach,
        lambda x: _exponent(place(x), p),
        slope,
        lambda x: [_front(weight, place(x), 1 + place(x)) / abs(1 + place(x))],
        curvature,
    )
    total = modulus_sum(inner, height, largest)[0] + modulus_sum(outer, height, largest)[0]
    total += _before(weight, start, small, first, height, largest)
    return total + _beyond(weight, top, direction, reach, p, height, largest)


def decaying_coefficient_bound(weight: Weight, p: fmpq, largest: arb) -> arb:
    """A bound of e^(Re g(r_3)/epsilon) |int_1^oo x^power k(-x) e^(E/epsilon) dx|, E = log(x-1) + x + x^2/2 - x^3/3
    - p x."""
    corner, small = -real_saddle(p), arb(p)
    start = acb(corner - 1)
    height = _exponent(acb(-corner), p).real

    def place(x: arb, sign: int) -> tuple[acb, acb]:
        rest = -start * (sign * x).exp()
        return rest - 1, rest

    def piece(sign: int, length: arb) -> PathPiece:
        def slope(x: arb) -> acb:
            s, rest = place(x, sign)
            return sign * (small * rest + s * s * (1 + rest))

        def curvature(x: arb) -> acb:
            s, rest = place(x, sign)
            return (3 * s * s + 4 * s + small) * rest

        return PathPiece(
            length,
            lambda x: start.log() + sign * x + _polynomial(place(x, sign)[0], p),
            slope,
            lambda x: [_front(weight, *place(x, sign))],
            curvature,
        )

    first = _depth(lambda depth: _before(weight, start, small, depth, height, largest))
    reach = (2 * corner + 3 + 2 * abs(small).sqrt()).max(arb(3))
    last = (reach / start.real).log()
    total = modulus_sum(piece(-1, first), height, largest)[0] + modulus_sum(piece(1, last), height, largest)[0]
    total += _before(weight, start, small, first, height, largest)
    end = (start.real * last.exp()).lower()
    return total + _beyond(weight, acb(-1), acb(-1), end, p, height, largest)


def _polynomial(s: acb, p: fmpq) -> acb:
    """-psi(s) + p s - log(1 + s)."""
    return s * (p - 1 + s / 2 + s * s / 3)


def _exponent(s: acb, p: fmpq) -> acb:
    one_plus = 1 + s
    logarithm = one_plus.log() if one_plus.real > 0 or not one_plus.imag.contains(0) else (-one_plus).log()
    return logarithm + _polynomial(s, p)


def _front(weight: Weight, s: acb, one_plus_s: acb) -> arb:
    return abs(s) ** weight.power * abs(weight.polynomial(s, one_plus_s))


def _depth(bound: Callable[[arb], arb]) -> arb:
    """How far towards -1 the boxes go: until the rest is small; any number is right."""
    depth = arb(1)
    for _ in range(_STEPS):
        rest = bound(depth)
        if rest < arb(2) ** -40:
            break
        depth = depth * fmpq(5, 4)
    return depth.mid()


def _before(weight: Weight, start: acb, p: arb, depth: arb, height: arb, largest: arb) -> arb:
    """|1 + s| = |start| e^(-x), x >= depth, at most 1/4: |s| between 3/4 and 5/4, |(1+s) k| <= 2 size."""
    radius = abs(start) * (-depth).exp()
    growth = fmpq(5, 4) * (abs(p - 1) + fmpq(55, 48))
    excess = growth + radius.log() - height
    if not (radius <= fmpq(1, 4) and excess <= 0):
        return nonfinite()
    power = arb(fmpq(5, 4)) ** weight.power.max(arb(0)) * arb(fmpq(4, 3)) ** (-weight.power).max(arb(0))
    return power * 2 * weight.size * (excess / largest).exp() * largest


def _beyond(weight: Weight, corner: acb, direction: acb, reach: arb, p: fmpq, height: arb, largest: arb) -> arb:
    """s = corner + direction rho, rho >= reach: d(rho) as in proofs/first_integrals.md, section 4; |k| <= B |s|^3."""
    size = abs(corner)
    slope = reach * reach - (2 * size + 1) * reach - (size * size + size + 2 + abs(arb(p)))
    power = 3 + weight.power.max(arb(0))
    rate = slope / largest - power / reach
    excess = _exponent(corner + direction * reach, p).real - height
    far = reach >= abs(1 + corner) + 1 and reach >= size + 1
    if not (slope > 0 and rate > 0 and far and excess <= 0):
        return nonfinite()
    return weight.size * (size + reach) ** power * (excess / largest).exp() / rate
