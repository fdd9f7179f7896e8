"""Bounds of c_k = G_b^(k)/k! for complex b near a range, and of its remainders of interpolation in eta and b.

Proof page: ``proofs/finite_epsilon_zeros.md``, section 5.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.compliant.slow.epsilon_series import series_coefficients
from gspot_verified.compliant.slow.slow_integral import tangent_bound
from gspot_verified.compliant.slow.slow_plan import peak
from gspot_verified.numbers.balls import approximate, nonfinite, working_bits

_BITS = 64  # of a bound, of which a few digits count; any number is right
_LARGEST_RADIUS = fmpq(1)  # of the circle in rho: any with eta c < 1 is right, proofs/finite_epsilon_zeros.md, 5.1


@dataclass(frozen=True, slots=True)
class ComplexNeighbourhood:
    """Real b in [lower, upper] and the complex numbers within ``distance`` of it; 0 < eta <= ``eta``; one tau."""

    lower: fmpq
    upper: fmpq
    distance: fmpq
    eta: fmpq
    tau: fmpq

    def integral(self, shift: int) -> arb:
        """A bound of int_0^oo rho^(shift - x - 1) e^(-rho^3/3 + rho tau + h(rho; eta)) drho for all x = Re z; not
        finite unless shift - x >= 1."""
        ends = (self.lower - self.distance - shift, self.upper + self.distance - shift)
        if ends[1] > -1:
            return nonfinite()
        bounds = [_bound(self.tau, end, self.eta) for end in ends]
        return bounds[0].max(bounds[1])


def _bound(tau: fmpq, b: fmpq, eta: fmpq) -> arb:
    """A bound of I_b, b <= -1, by two tangents about one standard deviation from the peak."""
    place, small, exponent = approximate(tau), approximate(eta), approximate(b)
    # At b = -1 the largest value of the integrand in rho is at 0 for tau <= 0.
    top = peak(place, min(exponent + 1, -0.05), small)
    width = top / math.sqrt(max(-exponent - 1, 0.05) + top**3)
    rising, falling = max(top / 2, top - width), top + width
    if exponent > -1.05 and tau <= 0:
        return nonfinite()
    with working_bits(_BITS):
        return tangent_bound(arb(tau), arb(b), arb(eta), arb(0), _short(rising), _short(falling))


def _short(value: float) -> arb:
    return arb(fmpq(*value.as_integer_ratio()))


def slow_majorant(region: ComplexNeighbourhood, count: int) -> list[arb]:
    """Bounds of |c_k(z)|, k < ``count``, for all z of the region: a circle of radius c round 0, and the axis beyond c.

    Not finite unless Re z > -1 in the region.
    """
    least, largest = region.lower - region.distance, region.upper + region.distance
    with working_bits(_BITS):
        if least <= -1:
            return [nonfinite()] * count
        radius = _radius(region.eta)
        around = _gamma(least, largest) * (arb.pi() * region.distance).exp() * _on_circle(region, radius)
        reciprocal = _reciprocal_gamma(region)
        bounds = []
        for k in range(count):
            if k - largest >= 2:
                total = reciprocal * region.integral(k)
            else:
                # rho^(k-x-1) <= c^(k-x-p) rho^(p-1) on rho >= c when p >= k - x.
                p = max(2, math.ceil(approximate(k - least)))
                beyond = _power(radius, k - least - p, k - largest - p) * _bound(region.tau, fmpq(-p), region.eta)
                total = around * _power(radius, k - least, k - largest) + reciprocal * beyond
            bounds.append(total / math.factorial(k))
        return bounds


def _radius(eta: fmpq) -> fmpq:
    """c with eta c <= 9/10. Any such number is right."""
    return min(_LARGEST_RADIUS, fmpq(9, 10) / eta)


def _on_circle(region: ComplexNeighbourhood, radius: fmpq) -> arb:
    """A bound of |e^(-rho^3/3 + rho tau + h)| on |rho| = c: |phi(x)| <= sum |x|^j/(j + 3) <= |x|/(4 (1 - |x|))."""
    x = region.eta * radius
    phi = arb(x / (4 * (1 - x)))
    cube = arb(radius) ** 3
    return (cube / 3 + radius * abs(region.tau) + cube / 2 * phi).exp()


def _power(base: fmpq, first: fmpq, second: fmpq) -> arb:
    """The largest of base^y for y between two exponents."""
    return (arb(base) ** arb(first)).max(arb(base) ** arb(second))


def _gamma(least: fmpq, largest: fmpq) -> arb:
    """A bound of |Gamma(1 + z)| <= Gamma(1 + Re z), which is convex."""
    return arb(1 + least).gamma().max(arb(1 + largest).gamma())


def _reciprocal_gamma(region: ComplexNeighbourhood) -> arb:
    """A bound of |1/Gamma(-z)| = |Gamma(1 + z) sin(pi z)|/pi."""
    gamma = _gamma(region.lower - region.distance, region.upper + region.distance)
    return gamma * (arb.pi() * region.distance).cosh() / arb.pi()


def epsilon_difference(region: ComplexNeighbourhood, terms: int, count: int) -> list[arb]:
    """Bounds of |d^N c_k/d eta^N|/N!, N = ``terms``, k < ``count``, for all z of the region and all eta up to its own.

    Not finite unless N + 2 >= Re z.
    """
    with working_bits(_BITS):
        if region.lower - region.distance <= -1:
            return [nonfinite()] * count
        factor = _reciprocal_gamma(region)
        kept: dict[int, arb] = {}
        bounds = []
        for k in range(count):
            total = arb(0)
            for m, coefficient in enumerate(series_coefficients(terms), 1):
                power = k + terms + 3 * m
                if power not in kept:
                    kept[power] = region.integral(power)
                total += abs(coefficient) * kept[power]
            bounds.append(factor * total / math.factorial(k))
        return bounds
