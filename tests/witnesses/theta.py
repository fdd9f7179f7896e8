"""High-precision witnesses from mpmath: points that a ball must contain. They share no code with the package.

mpmath gives no bound: every witness is computed with many guard digits and compared with an allowance.
"""

from __future__ import annotations

from fractions import Fraction

import mpmath
from flint import arb
from samples.strategies import ends


def _number(value: Fraction) -> mpmath.mpf:
    return mpmath.mpf(value.numerator) / value.denominator


def theta_witness(tau: Fraction, beta: Fraction, digits: int = 60) -> Fraction:
    """Theta by three 1F2 of mpmath and the initial values as 1/Gamma products, to about ``digits`` digits."""
    return complex_witness(tau, Fraction(0), beta, digits)[0]


def complex_witness(real: Fraction, imaginary: Fraction, beta: Fraction, digits: int = 60) -> tuple[Fraction, Fraction]:
    """The same at tau = real + imaginary i: both parts, to about ``digits`` digits of the absolute value."""
    lost = int(abs(complex(real, imaginary)) ** 1.5) + int(abs(float(beta))) + 30
    with mpmath.workdps(digits + 2 * lost):
        t = mpmath.mpc(_number(real), _number(imaginary)) if imaginary else _number(real)
        b, third = _number(beta), mpmath.mpf(1) / 3
        front = 2 * mpmath.pi * mpmath.power(3, 2 * b / 3 - mpmath.mpf(1) / 2)
        gammas = [mpmath.rgamma((j - b) / 3) for j in range(3)]
        values = (
            front * gammas[1] * gammas[2],
            front * mpmath.cbrt(3) * gammas[0] * gammas[2],
            front * mpmath.cbrt(9) * gammas[0] * gammas[1],
        )
        z = t**3 / 9
        total = (
            values[0] * mpmath.hyp1f2(-b / 3, third, 2 * third, z)
            + values[1] * t * mpmath.hyp1f2((1 - b) / 3, 2 * third, 4 * third, z)
            + values[2] * t**2 / 2 * mpmath.hyp1f2((2 - b) / 3, 4 * third, 5 * third, z)
        )
        return to_fraction(mpmath.re(total)), to_fraction(mpmath.im(total))


def laplace_witness(tau: Fraction, beta: Fraction, digits: int = 30) -> Fraction:
    """Theta for beta < 0 by mpmath's quadrature of the Laplace integral in u = ln r: no series at all."""
    with mpmath.workdps(digits + 20):
        t, b = _number(tau), _number(beta)

        def integrand(u: mpmath.mpf) -> mpmath.mpf:
            r = mpmath.exp(u)
            return mpmath.exp(-b * u + r * t - r**3 / 3)

        end = mpmath.log(6 + 3 * mpmath.sqrt(abs(t)))
        start = -(digits + 20) * mpmath.log(10) / -b
        pieces = [start + (end - start) * i / 24 for i in range(25)]
        return to_fraction(mpmath.quad(integrand, pieces) * mpmath.rgamma(-b))


def to_fraction(value: mpmath.mpf) -> Fraction:
    """The exact value of an mpf."""
    sign, mantissa, exponent, _ = value._mpf_
    number = Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    return -number if sign else number


def contains_witness(value: arb, witness: Fraction, digits: int) -> bool:
    """True when the finite ball, widened by the witness's own error 10^-digits relative, contains the witness."""
    lower, upper = ends(value)
    allowance = abs(witness) / 10**digits + Fraction(1, 10 ** (3 * digits))
    return lower - allowance <= witness <= upper + allowance
