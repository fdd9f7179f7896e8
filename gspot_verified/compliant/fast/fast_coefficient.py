"""c_+, the coefficient of the oscillating fast solution in a state with p > 0: an integral from -1 over the saddle r_+
to infinity, by quadrature at one epsilon.

Proof page: ``proofs/first_integrals.md``, sections 4 and 5.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from flint import acb, arb, fmpq, fmpz_poly

from gspot_verified.compliant.model.kernel import Kernel, kernel
from gspot_verified.compliant.model.normal_form import Deviation
from gspot_verified.numbers.balls import add_remainder, approximate, nonfinite, working_bits
from gspot_verified.theta_function.sums.quadrature import holomorphic_integral

_GUARD_BITS = 32  # bits beyond those asked for, lost on the way; any number is right


def saddle(p: fmpq) -> acb:
    """r_+, the root of r^3 + 2 r^2 + p r + p with positive imaginary part, p > 0, at the current precision.

    >>> value = saddle(fmpq(1, 2))
    >>> bool(abs(value.real + fmpq(62, 1000)) < fmpq(1, 1000))
    True
    """
    numerator, denominator = p.p, p.q
    roots: Any = fmpz_poly([numerator, numerator, 2 * denominator, denominator]).complex_roots()
    upper_root: acb = next(root for root, _ in roots if root.imag > 0)
    return upper_root


def fast_coefficient(state: Deviation, bits: int) -> acb:
    """c_+ = -(beta/(2 pi i)) int s^(beta-1) e^((-psi(s) + p s)/epsilon) k(s) ds, from -1 over r_+ to infinity.

    Hypothesis, checked: p > 0. The absolute accuracy is near 2^-bits times the integral of the modulus.
    """
    if not state.p > 0:
        return acb(nonfinite(), nonfinite())
    lost = max(0, math.ceil(-math.log2(approximate(state.epsilon))))
    with working_bits(bits + lost + _GUARD_BITS):
        data, top = kernel(state), saddle(state.p)
        path = FastPath(data, top, bits)
        total = path.from_minus_one() + path.to_infinity()
        return total * path.height.exp() * data.beta / acb(0, -2 * arb.pi())


@dataclass(frozen=True, slots=True)
class FastPath:
    """The two pieces of the path; the integrand is divided by e^height, height = Re g(r_+)/epsilon (any number)."""

    data: Kernel
    top: acb
    bits: int

    @property
    def height(self) -> arb:
        """Near the real part of the exponent at the saddle."""
        return self.data.exponent(self.top, (1 + self.top).log()).real.mid()

    def from_minus_one(self) -> acb:
        """1 + s = (1 + r_+) e^u, u from -infinity to 0: (1 + s)^(1/epsilon) decays; a bound before ``lower``."""
        data, start, height = self.data, 1 + self.top, self.height
        log_start, lower = start.log(), self.first()

        def integrand(u: acb, analytic: bool) -> acb:
            rest = start * u.exp()
            s = rest - 1
            # On the path Im s > 0: log s = i pi + log(-s), with -s = 1 - rest near 1.
            log_s = (1 - rest).log(analytic) + acb(0, arb.pi())
            exponent = (data.beta - 1) * log_s + data.exponent(s, log_start + u) - height
            return exponent.exp() * data.polynomial(s, rest)

        middle = holomorphic_integral(integrand, lower, arb(0))
        return _widened(middle, self.before(lower))

    def first(self) -> arb:
        """Where (1 + s)^(1/epsilon) has won and |1 + s| < 1/4; any number is right."""
        start = (1 + self.top).log().real
        early = self._growth() + start / self.data.epsilon - self.height
        goal = (self.bits + 8) * math.log(2)
        return arb(min(-2.0, -approximate(self.data.epsilon * (early + goal))) - max(0.0, approximate(start)))

    def _growth(self) -> arb:
        """A bound of Re (s (p - 1 + s/2 + s^2/3))/epsilon for |s| <= 5/4."""
        return fmpq(5, 4) * (abs(self.data.p - 1) + fmpq(55, 48)) / self.data.epsilon

    def before(self, lower: arb) -> arb:
        """The piece u < lower, where |1 + s| <= 1/4, checked: 3/4 <= |s| <= 5/4, and the exponential falls like
        e^(u/epsilon)."""
        data = self.data
        radius = abs(1 + self.top) * lower.exp()
        if not radius <= fmpq(1, 4):
            return nonfinite()
        power = arb(fmpq(5, 4)) ** (data.beta - 1).max(arb(0)) * arb(fmpq(4, 3)) ** (1 - data.beta).max(arb(0))
        exponent = self.exponent_before(lower) - self.height
        return power * 4 * data.size * exponent.exp() * data.epsilon

    def exponent_before(self, lower: arb) -> arb:
        """A bound of the real part of the exponent for u <= ``lower``; it needs |1 + s| <= 1/4 there."""
        return self._growth() + ((1 + self.top).log().real + lower) / self.data.epsilon

    def to_infinity(self) -> acb:
        """s = r_+ + e^(i pi/3) rho, rho from 0 to infinity; a bound beyond ``last``."""
        data, height = self.data, self.height
        direction = _direction()

        def integrand(rho: acb, analytic: bool) -> acb:
            s = self.top + direction * rho
            rest = 1 + s
            exponent = (data.beta - 1) * s.log(analytic) + data.exponent(s, rest.log(analytic)) - height
            return exponent.exp() * data.polynomial(s, rest) / rest

        last = self.last()
        middle = holomorphic_integral(integrand, arb(0), last)
        return direction * _widened(middle, self.beyond(last))

    def last(self) -> arb:
        """Where the cube has won; any number is right."""
        small, size, p = (approximate(v) for v in (self.data.epsilon, abs(self.top), self.data.p))
        goal = (self.bits + 8 + 8 * approximate(self.data.beta)) * math.log(2)
        return arb(math.ceil(3 * size + 4 + 2 * math.sqrt(p) + (6 * small * goal) ** (1 / 3)))

    def beyond(self, last: arb) -> arb:
        """rho >= R = ``last``: -Re dE/d rho >= d > 0, E = epsilon exponent; k and |s|^(beta-1) grow like a power."""
        data, size = self.data, abs(self.top)
        s = self.top + _direction() * last
        slope = last * last - (2 * size + 1) * last - (size * size + size + 2 + abs(data.p))
        power = 3 + (data.beta - 1).max(arb(0))
        rate = slope / data.epsilon - power / last
        if not (slope > 0 and rate > 0 and last >= abs(1 + self.top) + 1 and last >= size + 1):
            return nonfinite()
        exponent = data.exponent(s, (1 + s).log()).real - self.height
        return data.size * (size + last) ** power * exponent.exp() / rate


def _direction() -> acb:
    """e^(i pi/3)."""
    return acb(arb(fmpq(1, 2)), arb(3).sqrt() / 2)


def _widened(value: acb, bound: arb) -> acb:
    """``value`` plus every complex number of modulus at most ``bound``."""
    return acb(add_remainder(value.real, bound), add_remainder(value.imag, bound))
