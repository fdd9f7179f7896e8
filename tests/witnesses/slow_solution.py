"""Witnesses for the slow solution that share no formula with the package: mpmath's quadrature of the definition, exact
polynomials at integer b, and the power series of the fourth-order equation in exact or high-precision arithmetic.
From the package they take only the record of a state."""

from __future__ import annotations

from fractions import Fraction

import mpmath
from flint import fmpq
from samples.strategies import to_fmpq

from gspot_verified.compliant.model.normal_form import Deviation


def defining_integral(time: Fraction, b: Fraction, epsilon: Fraction, digits: int = 30) -> mpmath.mpf:
    """F_b(T; epsilon) for b < 0 from its definition in r, by mpmath's quadrature in log r."""
    with mpmath.workdps(digits + 40):
        t, power, small = (mpmath.mpf(v.numerator) / v.denominator for v in (time, b, epsilon))

        def integrand(u: mpmath.mpf) -> mpmath.mpf:
            r = mpmath.exp(u)
            return mpmath.exp(-power * u + (r - r**2 / 2 - r**3 / 3 - mpmath.log1p(r)) / small + r * t)

        size = mpmath.cbrt(small / 2)
        end = mpmath.log(size * (8 + 3 * mpmath.sqrt(abs(t) * size)))
        start = end - (digits + 25) * mpmath.log(10) / -power - 4
        pieces = [start + (end - start) * i / 40 for i in range(41)]
        return mpmath.quad(integrand, pieces) * mpmath.rgamma(-power)


def polynomial_value(time: Fraction, n: int, epsilon: Fraction) -> Fraction:
    """F_n = (-1)^n n! [r^n] e^(psi(r)/epsilon + r T), by the exponential's recursion on exact coefficients."""
    # psi(r) = sum of (-1)^j r^j/j for j >= 4, minus (2/3) r^3.
    log = [Fraction(0), time, Fraction(0), -Fraction(2, 3) / epsilon]
    log += [Fraction((-1) ** j, j) / epsilon for j in range(4, n + 1)]
    series = [Fraction(1)]
    for k in range(1, n + 1):
        series.append(sum((j * log[j] * series[k - j] for j in range(1, k + 1)), Fraction(0)) / k)
    value = series[n]
    for k in range(1, n + 1):
        value *= -k
    return value


def continued(values: list[mpmath.mpf], time: mpmath.mpf, b: mpmath.mpf, epsilon: mpmath.mpf, step: mpmath.mpf):
    """F(T + step) from F, F', F'', F''' at T by the power series of
    F''''/eps + 2 F'''/eps - T F'' - T F' - (1 - b) F' + b F = 0."""
    taylor = [values[0], values[1], values[2] / 2, values[3] / 6]
    total = sum(c * step**k for k, c in enumerate(taylor))
    power = step**3
    for n in range(400):
        third = 2 * (n + 3) * (n + 2) * (n + 1) * taylor[n + 3] / epsilon
        second = time * (n + 2) * (n + 1) * taylor[n + 2] + n * (n + 1) * taylor[n + 1]
        first = time * (n + 1) * taylor[n + 1] + n * taylor[n]
        rest = (1 - b) * (n + 1) * taylor[n + 1] - b * taylor[n]
        following = epsilon * (second + first + rest - third) / ((n + 4) * (n + 3) * (n + 2) * (n + 1))
        taylor.append(following)
        power *= step
        total += following * power
    return total


def on_the_slow_manifold(beta: int, epsilon: Fraction, p: Fraction) -> Deviation:
    """The state of F_beta, a polynomial in T: rational, exactly on the slow manifold, with C = 1."""
    time = -p / epsilon

    def derivative(k: int) -> Fraction:
        factor = Fraction(1)
        for j in range(k):
            factor *= j - beta
        return factor * polynomial_value(time, beta - k, epsilon) if k <= beta else Fraction(0)

    b, force, first, second = derivative(0), *(derivative(k) / (epsilon * beta) for k in (1, 2, 3))
    velocity = -second - 2 * first - b - p * force
    place = -first - 2 * force - velocity
    hats = [to_fmpq(value) for value in (b, velocity, place, place + force)]
    return Deviation(fmpq(beta), to_fmpq(epsilon), to_fmpq(p), *hats)
