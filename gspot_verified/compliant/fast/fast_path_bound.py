"""Bounds, for every epsilon up to a largest one, of the fast solutions P_+ and Q on a range of times and of their
coefficients c_+ and c_Q, each divided by its exponential.

Proof page: ``proofs/fast_part.md``, sections 4 and 5.
"""

from __future__ import annotations

from flint import acb, arb, fmpq

from gspot_verified.compliant.fast.decaying_coefficient import real_saddle
from gspot_verified.compliant.fast.fast_coefficient import saddle
from gspot_verified.compliant.fast.modulus_sum import PathPiece, modulus_sum, weakest
from gspot_verified.numbers.balls import nonfinite

NAMES = ("b", "force", "Z", "V")
"""The order of the bounds: b-hat, and lambda-hat, Z-hat, V-hat without the factor 1/(epsilon beta)."""


def oscillating_bounds(beta: arb, p: fmpq, largest: arb) -> list[arb]:
    """Bounds of e^(-Re g(r_+)/epsilon) |P_+| with each multiplier, -p/epsilon <= T <= 0, epsilon <= ``largest``."""
    top = saddle(p)
    height, small = _exponent(top, p).real, arb(p)
    turn = top.imag + top.real
    inner = (turn / 2).min(height.root(3) if height > 0 else arb(0)).min(arb(fmpq(1, 2))).mid()
    if not (inner > 0 and turn > inner):
        return [nonfinite()] * len(NAMES)
    left = acb(arb(fmpq(-1, 2)), arb(3).sqrt() / 2)
    down = acb(1, -1) / arb(2).sqrt()
    reach = 2 * abs(top) + 4 + arb(p).sqrt()
    pieces = [
        _ray(beta, top, left, reach, small, p, saddle_at_start=True),
        _ray(beta, top, down, -top.real * arb(2).sqrt(), small, p, saddle_at_start=True),
        _ray(beta, acb(0, turn), acb(0, -1), turn - inner, arb(0), fmpq(0)),
        _arc(beta, inner),
        _ray(beta, acb(inner), acb(1), reach, arb(0), fmpq(0)),
    ]
    tails = [_tail(top, left, reach, small, height, largest)]
    tails.append(_tail(acb(inner), acb(1), reach, arb(0), height, largest))
    return weakest([modulus_sum(piece, height, largest) for piece in pieces] + tails)


def decaying_bounds(beta: arb, p: fmpq, largest: arb) -> list[arb]:
    """Bounds of e^(-Re g(r_3)/epsilon) |Q| e^(|r_3|(T + p/epsilon)) with each multiplier, for T >= -p/epsilon."""
    corner = acb(real_saddle(p))
    height, left = _exponent(corner, p).real, acb(arb(fmpq(-1, 2)), arb(3).sqrt() / 2)
    reach = 2 * abs(corner) + 4 + abs(arb(p)).sqrt()
    ray = _ray(beta, corner, left, reach, arb(p), p, saddle_at_start=True)
    total = weakest([modulus_sum(ray, height, largest), _tail(corner, left, reach, arb(p), height, largest)])
    return [2 * bound for bound in total]


def _exponent(r: acb, p: fmpq | arb) -> acb:
    """E = psi(r) - p r; its real part is the same for both branches of log(1 + r)."""
    one_plus = 1 + r
    # Re log(1 + r) = Re log(-1 - r): take the branch whose cut is away.
    logarithm = one_plus.log() if one_plus.real > 0 or not one_plus.imag.contains(0) else (-one_plus).log()
    return r * (1 - p - r / 2 - r * r / 3) - logarithm


def _fronts(beta: arb, r: acb, speed: arb) -> list[arb]:
    """|r|^(-beta-1) times each multiplier, without 1/(epsilon beta)."""
    size, rest = abs(r), abs(1 + r)
    power = size ** (-beta - 1) * speed
    return [power, power * size, power * size / rest, power * size * size * abs(1 + 1 / (1 + r))]


def _ray(
    beta: arb, corner: acb, direction: acb, length: arb, p: arb, exact_p: fmpq, *, saddle_at_start: bool = False
) -> PathPiece:
    """r = corner + direction x: dE/dr = -(p + r^2 (r + 2)/(1 + r)), d^2E/dr^2 = -2 r - 1 + 1/(1 + r)^2."""

    def place(x: arb) -> acb:
        return corner + direction * x

    def slope(x: arb) -> acb:
        r = place(x)
        return -direction * (p + r * r * (1 + 1 / (1 + r)))

    def curvature(x: arb) -> acb:
        r = place(x)
        return direction * direction * (1 / (1 + r) ** 2 - 2 * r - 1)

    return PathPiece(
        length,
        lambda x: _exponent(place(x), exact_p),
        slope,
        lambda x: _fronts(beta, place(x), arb(1)),
        curvature if saddle_at_start else None,
    )


def _arc(beta: arb, radius: arb) -> PathPiece:
    """r = radius e^(i theta), theta from pi/2 down to 0; p = 0."""

    def place(x: arb) -> acb:
        return radius * acb(0, arb.pi() / 2 - x).exp()

    def slope(x: arb) -> acb:
        r = place(x)
        return acb(0, 1) * r * r * r * (1 + 1 / (1 + r))

    return PathPiece(
        arb.pi() / 2, lambda x: _exponent(place(x), fmpq(0)), slope, lambda x: _fronts(beta, place(x), radius)
    )


def _tail(corner: acb, direction: acb, reach: arb, p: arb, height: arb, largest: arb) -> list[arb]:
    """rho >= reach: as in section 2, |front| <= 2 (|corner| + rho); checked that Re E <= top there."""
    size, cube = abs(corner), (direction**3).real
    slope = cube * reach * reach - (2 * size + 1) * reach - (size * size + size + 2 + abs(p))
    rate = slope / largest - 1 / reach
    excess = _exponent(corner + direction * reach, p).real - height
    rising = 2 * cube * reach - 2 * size - 1
    if not (slope > 0 and rate > 0 and rising > 0 and reach >= size + 2 and excess <= 0):
        return [nonfinite()] * len(NAMES)
    bound = 2 * (size + reach) * (excess / largest).exp() / rate
    return [bound] * len(NAMES)
