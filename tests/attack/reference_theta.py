"""Theta by other ways than the package's: its ODE's plain power series, 1F2 after Gauss's multiplication formula, and a
quadrature with a recurrence in beta. mpmath and exact rationals alone.

theta''' = tau theta' - beta theta, so the coefficients obey a_(k+3) (k+1)(k+2)(k+3) = (k - beta) a_k. For beta < 0
Theta = int_0^inf r^(-beta-1) exp(-r^3/3 + r tau) dr / Gamma(-beta); its three first coefficients, by Gauss's
formula for Gamma(-beta), have no singularity and hold for every beta.
"""

from __future__ import annotations

import math
from fractions import Fraction

import mpmath

Number = tuple[mpmath.mpf, mpmath.mpf]
"""A value and how far it may be off."""

FARTHEST_OF_SERIES = 250
_GUARD = 64


def mp(value: Fraction) -> mpmath.mpf:
    """At the precision in force."""
    return mpmath.mpf(value.numerator) / value.denominator


def first_coefficients(beta: Fraction) -> list[mpmath.mpf]:
    """Theta, Theta', Theta''/2 at tau = 0."""
    power = mp(beta)
    gammas = [mpmath.rgamma((j - power) / 3) for j in range(3)]
    found = []
    for j in range(3):
        others = gammas[(j + 1) % 3] * gammas[(j + 2) % 3]
        scale = 2 * mpmath.pi * mpmath.power(3, Fraction(j, 3) + 2 * power / 3 - mpmath.mpf(1) / 2)
        found.append(scale * others / mpmath.factorial(j))
    return found


def by_series(tau: Fraction, beta: Fraction, derivative: int = 0, digits: int = 80) -> Number:
    """The power series of the ODE at 0, with as many bits as its cancellation asks for."""
    # Next to a pole of Gamma as many bits go as beta has.
    wanted = int(digits * 3.33) + _GUARD + beta.denominator.bit_length()
    bits = wanted + 2 * int(abs(tau) ** 1.5) + int(abs(beta)).bit_length() * 8
    while True:
        with mpmath.workprec(bits):
            value, largest = _sum(tau, beta, derivative)
            off = mpmath.ldexp(largest, _GUARD // 2 - bits)
            if off <= abs(value) * mpmath.mpf(10) ** -digits or bits > 60 * wanted + 20_000:
                return value, off
        bits += wanted + max(0, int(mpmath.log(largest / abs(value), 2)) if value else 4 * wanted)


def _sum(tau: Fraction, beta: Fraction, derivative: int) -> Number:
    start, point = first_coefficients(beta), mp(tau)
    cube = point**3
    total, largest = mpmath.mpf(0), mpmath.mpf(0)
    far = 3 * (int(abs(tau) ** 1.5) + int(abs(beta)) + 2 * derivative + 50)
    for first in range(3):
        k, term = first, start[first]
        while k < derivative:
            term = term * (k * beta.denominator - beta.numerator) / (beta.denominator * (k + 1) * (k + 2) * (k + 3))
            k += 3
        # a_k k!/(k - derivative)! tau^(k - derivative)
        for j in range(derivative):
            term *= k - j
        term *= point ** (k - derivative)
        quiet = 0
        while quiet < 6:
            total += term
            largest = max(largest, abs(term))
            quiet = quiet + 1 if k > far and abs(term) <= mpmath.ldexp(largest, -mpmath.mp.prec) else 0
            if term == 0 and (point == 0 or k > beta):
                break
            low = (k + 1 - derivative) * (k + 2 - derivative) * (k + 3 - derivative)
            term = term * cube * (k * beta.denominator - beta.numerator) / (beta.denominator * low)
            k += 3
    return total, largest


def by_hypergeometric(tau: Fraction, beta: Fraction, digits: int = 80) -> Number:
    """Three 1F2 in tau^3/9, by mpmath's own summation; derivative 0."""
    with mpmath.workdps(2 * digits + 40 + int(abs(tau) ** 1.5)):
        start, point, power = first_coefficients(beta), mp(tau), mp(beta)
        third, place = mpmath.mpf(1) / 3, point**3 / 9
        lower = [(third, 2 * third), (2 * third, 4 * third), (4 * third, 5 * third)]
        parts = [
            start[j] * point**j * mpmath.hyp1f2((j - power) / 3, *lower[j], place) for j in range(3)
        ]  # fmt: skip
        largest = max(abs(part) for part in parts)
        return sum(parts, mpmath.mpf(0)), (largest + mpmath.mpf(10) ** -digits) * mpmath.mpf(10) ** (-digits - 10)


def by_quadrature(tau: Fraction, beta: Fraction, derivative: int = 0, digits: int = 30) -> Number:
    """The integral for beta < 0, and beyond by theta(beta) = -tau theta(beta-1) + (beta-1)(beta-2) theta(beta-3).

    A derivative of order k multiplies the integrand by r^k; the recurrence is differentiated k times.
    """
    with mpmath.workdps(2 * digits + 40):
        steps = max(0, math.floor(beta) + 3) if 2 * beta > -1 else 0
        low = beta - steps
        if not steps:
            value = _integral(tau, beta, digits, derivative)
            return value, abs(value) * mpmath.mpf(10) ** -(digits + 5)
        orders = range(derivative + 1)
        table = [[_integral(tau, low + j - 2, digits, k) for k in orders] for j in range(3)]
        point, largest = mp(tau), max(abs(row[-1]) for row in table)
        for j in range(1, steps + 1):
            now = mp(low + j)
            parts = [
                (-point * table[-1][k], -k * table[-1][k - 1], (now - 1) * (now - 2) * table[-3][k]) for k in orders
            ]
            largest = max(largest, *map(abs, parts[-1]))
            table = [*table[1:], [sum(each, mpmath.mpf(0)) for each in parts]]
        return table[-1][-1], largest * mpmath.mpf(10) ** -(digits + 5)


def _integral(tau: Fraction, beta: Fraction, digits: int, more: int = 0) -> mpmath.mpf:
    """In the logarithm of r, around where the integrand, times r^``more``, is largest."""
    power, point = more - mp(beta), mp(tau)

    def exponent(w: mpmath.mpf) -> mpmath.mpf:
        r = mpmath.exp(w)
        return power * w - r**3 / 3 + r * point

    # The exponent in w: power - r^3 + r tau = 0 at its top.
    r = mpmath.sqrt(abs(point)) + power + 1 if point > 0 else power / (1 + abs(point)) + mpmath.mpf(1) / 2
    low, high = mpmath.mpf(0), 2 * r + 10
    for _ in range(int(mpmath.mp.prec) + 40):
        middle = (low + high) / 2
        low, high = (middle, high) if power - middle**3 + middle * point > 0 else (low, middle)
    top = mpmath.log((low + high) / 2)
    peak, drop = exponent(top), (digits + 25) * mpmath.log(10)
    width = mpmath.mpf(1) / 64
    left, right = top - width, top + width
    while exponent(left) > peak - drop:
        left -= 2 * (top - left)
    while exponent(right) > peak - drop:
        right += (right - top) / 2 + width
    # The trapezoidal rule: the integrand and all its derivatives vanish at both ends.
    spread = mpmath.sqrt(2 / abs(_curvature(point, top)))
    return (
        mpmath.exp(peak)
        * _trapezoidal(lambda w: mpmath.exp(exponent(w) - peak), left, right, spread, digits)
        * mpmath.rgamma(-mp(beta))
    )


def _curvature(point: mpmath.mpf, w: mpmath.mpf) -> mpmath.mpf:
    r = mpmath.exp(w)
    return r * point - 3 * r**3


def _trapezoidal(function, left, right, spread, digits):
    count = max(64, int((right - left) / spread) * 4)
    step = (right - left) / count
    total = sum((function(left + k * step) for k in range(count + 1)), mpmath.mpf(0))
    before = None
    while before is None or abs(total * step - before) > abs(before) * mpmath.mpf(10) ** -(digits + 8):
        before = total * step
        if count > 200_000:
            raise ArithmeticError("the quadrature does not settle")
        total += sum((function(left + (k + mpmath.mpf(1) / 2) * step) for k in range(count)), mpmath.mpf(0))
        count, step = 2 * count, step / 2
    return total * step


def reference(tau: Fraction, beta: Fraction, derivative: int = 0, digits: int = 80) -> Number:
    """The series where it is short, else the quadrature."""
    if abs(tau) <= FARTHEST_OF_SERIES:
        return by_series(tau, beta, derivative, digits)
    return by_quadrature(tau, beta, derivative, min(digits, 30))
