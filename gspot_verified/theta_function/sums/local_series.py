"""The Taylor series of Theta at any centre, from three values there, with the bound on its rest.

Proof page: ``proofs/local_series.md``.
"""

from __future__ import annotations

from typing import NamedTuple

from flint import arb, arb_poly, fmpq

from gspot_verified.numbers.balls import add_remainder, nonfinite, working_bits
from gspot_verified.theta_function.sums.recurrence import continued

REACH = 1 + fmpq(1, 1024)
"""The series holds on |s| <= REACH, a little more than the panel |s| <= 1."""

_BITS_OF_A_BOUND = 64  # of a bound, of which a few digits count; any number is right


class LocalSeries(NamedTuple):
    """Theta(centre + half_width s, beta) lies in ``polynomial(s)`` for every real s with |s| <= REACH.

    The bound on what is left out is part of the ball of the constant coefficient. ``largest`` and ``ratio`` are m and q
    of the page, ``bits`` the working precision.
    """

    centre: fmpq
    half_width: fmpq
    polynomial: arb_poly
    length: int
    largest: arb
    ratio: arb
    bits: int

    def values_at(self, tau: fmpq) -> tuple[arb, arb, arb]:
        """Enclosures of Theta, Theta' and Theta'' at a point of the panel; not finite outside it."""
        s = (tau - self.centre) / self.half_width
        if not abs(s) <= REACH:
            return nonfinite(), nonfinite(), nonfinite()
        with working_bits(self.bits):
            point, slope = arb(s), self.polynomial.derivative()
            first, second = slope(point), slope.derivative()(point)
            bounds = self._rests()
            width = self.half_width
            value = self.polynomial(point)
            return value, add_remainder(first, bounds[0]) / width, add_remainder(second, bounds[1]) / (width * width)

    def _rests(self) -> tuple[arb, arb]:
        """Bounds on the rests of the first and the second derivative in s."""
        with working_bits(_BITS_OF_A_BOUND):
            last, q = self.length + 2, self.ratio
            left = 1 / (1 - q)
            first = last + 3 * q * left
            second = last * last + 6 * last * q * left + 9 * q * (1 + q) * left * left
            return 3 * self.largest * left * first, 3 * self.largest * left * second


def part_of_polynomial(polynomial: arb_poly, number: int, pieces: int, length: int, bits: int) -> arb_poly:
    """A panel's polynomial on part ``number`` of ``pieces`` equal parts of the panel, with ``length`` coefficients.

    With t from -1 to 1 on the part, s = (2 number + 1 - pieces + t)/pieces. What lies in the value of the given
    polynomial for every real s with |s| <= REACH lies in that of the part for every real t with |t| <= REACH: what is
    left out is part of the ball of the constant coefficient.

    :raises ValueError: there is no such part.
    """
    if not 0 <= number < pieces or length < 1:
        raise ValueError(f"number: expected one of {pieces} parts and a length of 1 or more, got {number} and {length}")
    with working_bits(bits):
        terms = polynomial(arb_poly([fmpq(2 * number + 1 - pieces, pieces), fmpq(1, pieces)])).coeffs()
        kept, omitted = terms[:length], terms[length:]
        if omitted:
            every = arb(0, REACH.p) / REACH.q  # every t
            kept[0] += arb_poly(omitted)(every) * add_remainder(arb(0), arb(REACH) ** length)
        return arb_poly(kept)


def local_series(
    values: tuple[arb, arb, arb], centre: fmpq, half_width: fmpq, beta: fmpq, length: int, bits: int
) -> LocalSeries:
    """The series with ``length`` = K >= 3 coefficients from enclosures of Theta, Theta', Theta'' at the centre c.

    With A_k = a_k H^k: (k+1)(k+2)(k+3) A_(k+3) = c H^2 (k+1) A_(k+1) + (k - beta) H^3 A_k. With h = REACH * H,
    m = max of |A_k| REACH^k over k = K, K+1, K+2 and q = (|c| h^2 + (1 + |beta|/K) h^3)/((K+2)(K+3)) < 1 the rest is at
    most 3 m/(1 - q). Not finite where q < 1 is not certain.
    """
    with working_bits(bits):
        square, cube = half_width * half_width, half_width**3
        linear, constant, cubed = arb(centre * square), arb(beta * cube), arb(cube)
        start = [values[0], values[1] * half_width, values[2] * (square / 2)]
        factors = [(cubed * k - constant) / ((k + 1) * (k + 2) * (k + 3)) for k in range(length)]
        terms = continued(start, factors, linear)
        with working_bits(_BITS_OF_A_BOUND):
            first, second, third = (abs(value) for value in terms[length:])
            largest = first.max(second).max(third) * arb(REACH) ** (length + 2)
            ratio = _ratio(centre, half_width, beta, length)
            rest = 3 * largest / (1 - ratio)
        terms[0] = add_remainder(terms[0], rest)
        return LocalSeries(centre, half_width, arb_poly(terms[:length]), length, largest, ratio, bits)


def _ratio(centre: fmpq, half_width: fmpq, beta: fmpq, length: int) -> arb:
    """q of the page; not finite where it is not certainly below 1."""
    reach = arb(half_width * REACH)
    ratio = (abs(arb(centre)) + (1 + abs(arb(beta)) / length) * reach) * reach * reach / ((length + 2) * (length + 3))
    return ratio if length >= 3 and ratio < 1 else nonfinite()
