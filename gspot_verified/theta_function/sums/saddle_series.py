"""The series of the saddle point, sum_(k<N) g_k lambda^(-k), lambda = tau^(3/2): by recurrence, or by splitting.

Proof page: ``proofs/asymptotic_coefficients.md``.
"""

from __future__ import annotations

from math import isqrt

from flint import arb, fmpq, fmpz, fmpz_poly

from gspot_verified.numbers.balls import Exact, current_bits, working_bits
from gspot_verified.theta_function.sums.matrix_splitting import MatrixBlock, Polynomials, split_matrix_sum

_BLOCK = 64  # terms with one working precision
_LEAST_BITS = 64  # of small terms
_TERMS_OF_A_LEAF = 8  # of the splitting; any power of 2 is right


def saddle_series(large: arb, beta: Exact, terms: int) -> arb:
    """An enclosure of sum_(k<N) g_k lambda^(-k), N = ``terms``, at the current precision.

    By the recurrence of :func:`theta_function.value.asymptotic_coefficients.coefficient`; lambda and beta may
    be balls.
    """
    exponent = -beta / 3 - fmpq(1, 2)
    inverse = 1 / large
    previous, current, total = arb(0), arb(1), arb(1)
    bits = current_bits()
    for start in range(1, terms, _BLOCK):
        # A term of relative size 2^-m needs m bits less; what rounding costs is in its ball.
        with working_bits(max(_LEAST_BITS, bits - _bits_below_one(abs(current) + abs(previous)))):
            part = arb(0)
            for k in range(start, min(start + _BLOCK, terms)):
                first, second = exponent - (k - 1), exponent - (k - 2)
                # For a rational beta the factors are small rationals, cheap to multiply by.
                following = current * ((27 * first * first - 9 * first - 1) / (12 * k))
                following += inverse * previous * (second * (3 * second - 2) * (3 * second - 4) / (8 * k))
                previous, current = current, following * inverse
                part += current
        total += part
    return total


def _bits_below_one(size: arb) -> int:
    """m >= 0 with |size| <= 2^-m, or 0. For heuristics only."""
    if not size.is_finite():
        return 0
    mantissa, exponent = size.abs_upper().man_exp()
    return max(0, -int(exponent) - int(mantissa).bit_length())


def split_length(terms: int) -> int:
    """The number of terms, at least ``terms``, that :func:`split_saddle_series` sums: it goes in whole blocks."""
    return -(-terms // _TERMS_OF_A_LEAF) * _TERMS_OF_A_LEAF


def split_saddle_series(tau: fmpq, beta: fmpq, terms: int) -> arb:
    """The same sum of ``split_length(terms)`` terms for rational tau > 0 and beta, by binary splitting.

    Where tau is a square lambda is rational; else two steps at a time are, and the sums over the even and the odd k
    are kept apart. Its cost follows the sizes of the integers in tau and beta: use it for rationals of small height.
    """
    bits = current_bits()
    root = _square_root(tau)
    blocks = split_length(terms) // _TERMS_OF_A_LEAF
    if root is not None:
        return split_matrix_sum(_single_steps(root**3, beta).of_length(_TERMS_OF_A_LEAF), blocks, bits)[0, 0]
    sums = split_matrix_sum(_double_steps(tau**3, beta).of_length(_TERMS_OF_A_LEAF // 2), blocks, bits)
    return sums[0, 0] + sums[1, 0] / (arb(tau) * arb(tau).sqrt())


def _square_root(value: fmpq) -> fmpq | None:
    above, below = isqrt(int(value.p)), isqrt(int(value.q))
    return fmpq(above, below) if above * above == value.p and below * below == value.q else None


def _step(k: fmpz_poly, beta: fmpq) -> tuple[Polynomials, fmpz_poly]:
    """The integer matrix and denominator D_k = 192 q^3 k of the step to the index k, without the powers of lambda.

    With w = 2q * 3m at m = a - k + 1: A_1(m) = (3 w^2 - 6 q w - 4 q^2)/(16 q^2), and with v = w + 6q, which belongs to
    m + 1: A_0(m + 1) = v (v - 4q)(v - 8q)/(64 q^3).
    """
    p, q = beta.p, beta.q
    w = 3 * q - 2 * p - 6 * q * k
    v = w + 6 * q
    denominator = 192 * q**3 * k
    return (
        (4 * q * (3 * w * w - 6 * q * w - 4 * q * q), v * (v - 4 * q) * (v - 8 * q)),
        (denominator, fmpz_poly([0])),
    ), denominator


def _single_steps(large: fmpq, beta: fmpq) -> MatrixBlock:
    """The steps j -> j + 1 divided by a rational lambda; the row takes the first component."""
    matrix, denominator = _step(fmpz_poly([1, 1]), beta)
    below = denominator * large.p
    return MatrixBlock(_scaled(matrix, large.q), below, ((below, fmpz_poly([0])),))


def _double_steps(square: fmpq, beta: fmpq) -> MatrixBlock:
    """The steps 2j -> 2j + 2 divided by lambda^2; the rows give lambda^(-2j) times g_2j and g_(2j+1)."""
    odd, odd_denominator = _step(fmpz_poly([1, 2]), beta)
    even, even_denominator = _step(fmpz_poly([2, 2]), beta)
    (a, b), (c, d) = odd
    product = tuple((row[0] * a + row[1] * c, row[0] * b + row[1] * d) for row in even)
    below = odd_denominator * even_denominator * square.p
    remaining = even_denominator * square.p
    return MatrixBlock(_scaled(product, square.q), below, ((below, fmpz_poly([0])), (a * remaining, b * remaining)))


def _scaled(matrix: Polynomials, factor: fmpz) -> Polynomials:
    return tuple((row[0] * factor, row[1] * factor) for row in matrix)
