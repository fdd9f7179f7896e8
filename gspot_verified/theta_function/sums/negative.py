"""tau -> -infinity: the enveloping series.

Proof page: ``proofs/negative.md``.
"""

from __future__ import annotations

from flint import acb, arb, fmpq, fmpz, fmpz_poly

from gspot_verified.numbers.balls import Exact, add_remainder, ball, current_bits, nonfinite, working_bits
from gspot_verified.numbers.complex_numbers import ExactComplex, complex_ball
from gspot_verified.theta_function.gamma.power import positive_power
from gspot_verified.theta_function.sums.binary_splitting import block, split_sum

_BLOCK_LENGTH = 8  # terms in one leaf of the splitting; any power of 2 is right


def negative_sum(tau: Exact, beta: Exact, terms: int, bits: int) -> arb:
    """An enclosure of Theta(tau, beta) for tau < 0, from ``terms`` = N terms in x = -tau:

        sum_(k<N) (-beta)_(3k) (-1)^k / (3^k k!) x^(beta - 3k)  +-  the size of the term k = N.

    Hypotheses, checked: tau < 0 and 3N > beta, both certain; else the result is not finite. The series diverges: for
    each x there is a best accuracy, near exp(-2/3 x^(3/2)) relative.
    """
    with working_bits(bits):
        x = -ball(tau)
        center = ball(beta)
        if not (x > 0 and (beta if isinstance(beta, fmpq) else center) < 3 * terms):
            return nonfinite()
        inverse_cube = 1 / (x * x * x)
        term = arb(1)
        total = arb(1)
        for k in range(terms):
            term = term * _ratio(k, beta) * inverse_cube
            if k < terms - 1:
                total += term
        return add_remainder(total, term) * positive_power(x, beta)


def sector_sum(tau: ExactComplex, beta: Exact, terms: int, bits: int) -> acb:
    """An enclosure of Theta(tau, beta) for tau = -z, |arg z| < 2 pi/3, from ``terms`` = N terms:

        sum_(k<N) (-beta)_(3k) (-1)^k / (3^k k!) z^(beta - 3k)  +-  |(-beta)_(3N)| / (3^N N!) d^(beta - 3N),

    d = |z| where |arg z| <= pi/6, else (sqrt(3) Re z + |Im z|)/2. Hypotheses, checked: d > 0, N >= 1 and 3N > beta,
    all certain; else the result is not finite.
    """
    with working_bits(bits):
        z = -complex_ball(tau)
        d, center = _sector_distance(z), ball(beta)
        if not (d > 0 and terms >= 1 and (beta if isinstance(beta, fmpq) else center) < 3 * terms):
            return acb(nonfinite())
        inverse_cube = 1 / (z * z * z)
        term = total = acb(1)
        coefficient = arb(1)
        for k in range(terms):
            ratio = _ratio(k, beta)
            coefficient = coefficient * ratio
            term = term * ratio * inverse_cube
            if k < terms - 1:
                total += term
        return add_remainder(total * z**center, coefficient * positive_power(d, center - 3 * terms))


def _sector_distance(z: acb) -> arb:
    """d of the proof page, in a ball; of two that hold the larger one."""
    root = arb(3).sqrt()
    height = abs(z.imag)
    if root * height <= z.real:
        return abs(z)
    return (root * z.real + height) / 2


def negative_split_sum(tau: fmpq, beta: fmpq, terms: int, bits: int) -> arb:
    """The same enclosure for rational tau and beta, by binary splitting (``proofs/splitting.md``), from at least
    ``terms`` terms.

    Its cost follows the sizes of the integers in tau and beta: use it for rationals of small height. Hypotheses,
    checked: as in :func:`negative_sum`.
    """
    blocks = -(-terms // _BLOCK_LENGTH)
    x, p, q = -tau, beta.p, beta.q
    if not (x > 0 and beta < 3 * blocks * _BLOCK_LENGTH):
        return nonfinite()
    k = fmpz_poly([0, 1])
    first = 3 * q * k - p
    numerator = -(first * (first + q) * (first + 2 * q)) * x.q**3
    denominator = (3 * (k + 1)) * (q * x.p) ** 3
    total, omitted = split_sum(block(numerator, denominator, _BLOCK_LENGTH), 0, blocks, bits)
    with working_bits(bits):
        return add_remainder(total, omitted) * positive_power(arb(x), beta)


def _ratio(k: int, beta: Exact) -> Exact:
    """The quotient of the terms k + 1 and k, times x^3: -(3k - beta)(3k+1 - beta)(3k+2 - beta)/(3 (k + 1))."""
    if isinstance(beta, fmpq):
        p, q = int(beta.p), int(beta.q)
        first = 3 * k * q - p
        if q.bit_length() > current_bits():
            # A long denominator: round each exact factor once; next to an integer it keeps its relative accuracy.
            product = arb(fmpz(first)) * arb(fmpz(first + q)) * arb(fmpz(first + 2 * q))
            return -product / (arb(fmpz(q)) ** 3 * (3 * (k + 1)))
        return fmpq(-first * (first + q) * (first + 2 * q), 3 * (k + 1) * q**3)
    first_ball = 3 * k - beta
    return -first_ball * (first_ball + 1) * (first_ball + 2) / (3 * (k + 1))
