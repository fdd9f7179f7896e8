"""c_Q, the coefficient of the decaying fast solution in any state of the contact phase, by quadrature at one epsilon.

Proof page: ``proofs/fast_part.md``, section 1.
"""

from __future__ import annotations

import math
from typing import Any, TypeVar

from flint import acb, arb, fmpq, fmpz_poly

from gspot_verified.compliant.model.kernel import Kernel, kernel
from gspot_verified.compliant.model.normal_form import Deviation
from gspot_verified.numbers.balls import add_remainder, approximate, nonfinite, working_bits
from gspot_verified.theta_function.sums.quadrature import holomorphic_integral

_GUARD_BITS = 32  # bits beyond those asked for, lost on the way; any number is right

Number = TypeVar("Number", arb, acb)


def real_saddle(p: fmpq) -> arb:
    """r_3, the least real root of r^3 + 2 r^2 + p r + p, at the current precision; r_3 < -1.

    >>> bool(abs(real_saddle(fmpq(1, 2)) + fmpq(1876, 1000)) < fmpq(1, 1000))
    True
    """
    numerator, denominator = p.p, p.q
    roots: Any = fmpz_poly([numerator, numerator, 2 * denominator, denominator]).complex_roots()
    # Of three real roots -1 lies between the least one and the others; of one root and a pair too.
    least_root: arb = next(root.real for root, _ in roots if root.real < -1 and root.imag.is_zero())
    return least_root


def decaying_coefficient(state: Deviation, bits: int) -> arb:
    """c_Q = -(beta/(2 pi)) int_1^oo x^(beta-1) (x-1)^(1/epsilon) e^((x + x^2/2 - x^3/3 - p x)/epsilon) k(-x) dx.

    The absolute accuracy is near 2^-bits times the integral of the modulus; any p.
    """
    lost = max(0, math.ceil(-math.log2(approximate(state.epsilon))))
    with working_bits(bits + lost + _GUARD_BITS):
        data, top = kernel(state), -real_saddle(state.p)
        height = _exponent(data, top, (top - 1).log()).mid()
        start, end = _start(data, height, bits), _end(data, top, bits)

        def integrand(u: acb, analytic: bool) -> acb:
            rest = u.exp()
            x = 1 + rest
            # Wide boxes of the quadrature may meet x = 0, at Im u = pi: the flag makes the logarithm answer NaN.
            exponent = (data.beta - 1) * x.log(analytic) + _exponent(data, x, u) - height
            return exponent.exp() * -data.polynomial(-x, -rest)

        middle = holomorphic_integral(integrand, start, end).real
        integral = add_remainder(add_remainder(middle, _before(data, start, height)), _beyond(data, end, height))
        return -integral * height.exp() * data.beta / (2 * arb.pi())


def _exponent(data: Kernel, x: Number, log_rest: Number) -> Number:
    """(log(x - 1) + x + x^2/2 - x^3/3 - p x)/epsilon."""
    return (log_rest + x * (1 - data.p + x / 2 - x * x / 3)) / data.epsilon


def _start(data: Kernel, height: arb, bits: int) -> arb:
    """Where (x - 1)^(1/epsilon) has won, x <= 5/4; any number is right."""
    goal = (bits + 8) * math.log(2)
    early = approximate(data.epsilon * height) - approximate(_growth(data))
    return arb(min(-2.0, early - approximate(data.epsilon) * goal))


def _growth(data: Kernel) -> arb:
    """A bound of x (1 - p + x/2 - x^2/3) for 1 <= x <= 5/4."""
    return fmpq(5, 4) * (abs(1 - data.p) + fmpq(5, 8))


def _before(data: Kernel, start: arb, height: arb) -> arb:
    """u < start <= log(1/4): |(x-1) k(-x)| <= 4 B, the rest falls like e^(u/epsilon)."""
    if not start.exp() <= fmpq(1, 4):
        return nonfinite()
    power = arb(fmpq(5, 4)) ** (data.beta - 1).max(arb(0))
    return power * 4 * data.size * ((_growth(data) + start) / data.epsilon - height).exp() * data.epsilon


def _end(data: Kernel, top: arb, bits: int) -> arb:
    """The logarithm of x - 1 where the cube has won; any number is right."""
    small, p = approximate(data.epsilon), approximate(data.p)
    goal = (bits + 8 + 8 * approximate(data.beta)) * math.log(2)
    return arb(math.log(4 + 3 * approximate(top) + 2 * math.sqrt(abs(p)) + (6 * small * goal) ** (1 / 3)))


def _beyond(data: Kernel, end: arb, height: arb) -> arb:
    """x >= X = 1 + e^end >= 2: the logarithmic derivative in x is at most -(X^2 - X - 2 - |p|)/epsilon + n/X."""
    x = 1 + end.exp()
    n = 3 + (data.beta - 1).max(arb(0))
    slope = x * x - x - 2 - abs(data.p)
    rate = slope / data.epsilon - n / x
    if not (x >= 2 and slope > 0 and rate > 0):
        return nonfinite()
    return data.size * x**n * (_exponent(data, x, end) - height).exp() / rate
