"""The Taylor series at rational tau and beta, by exact binary splitting: quasi-linear in the number of digits.

Proof page: ``proofs/splitting.md``.
"""

from __future__ import annotations

from flint import arb, fmpq, fmpz_poly

from gspot_verified.numbers.balls import add_remainder, nonfinite, working_bits
from gspot_verified.theta_function.gamma.initial_values import initial_values
from gspot_verified.theta_function.sums.binary_splitting import Block, block, split_sum


def _terms(tau: fmpq, beta: fmpq, length: int) -> Block:
    """The polynomials of a block of ``length`` = 2^n terms: one set serves the three chains k = j, j+3, j+6, ..."""
    cube = tau**3
    k = fmpz_poly([0, 1])
    numerator = (k * beta.q - beta.p) * cube.p
    denominator = (k + 1) * (k + 2) * (k + 3) * (beta.q * cube.q)
    return block(numerator, denominator, length, stride=3)


def splitting_sum(tau: fmpq, beta: fmpq, length: int, bits: int, block_length: int) -> arb:
    """An enclosure of Theta(tau, beta) from at least ``length`` Taylor terms, summed exactly up to ``bits`` bits.

    ``block_length`` (a power of two) only moves work between polynomials and integers; any choice is correct.
    Not finite when ``length`` is too small for the ratio test of ``proofs/taylor.md``. Its cost follows the sizes of
    the integers in tau and beta: use it for rationals of small height.
    """
    values = initial_values(beta, bits)
    terms = _terms(tau, beta, block_length)
    blocks = -(-length // (3 * block_length))
    beyond = 3 * block_length * blocks
    total, rest = arb(0), arb(0)
    for j in range(3):
        if values[j].is_zero():
            continue
        partial_sum, following = split_sum(terms, j, blocks, bits)
        with working_bits(bits):
            scale = values[j] * (tau**j / (1 + (j > 1)))
            total += scale * partial_sum
        with working_bits(64):
            rest += (scale * following).abs_upper()
    with working_bits(64):
        bound = _ratio_test(rest, tau, beta, beyond)
    with working_bits(bits):
        return add_remainder(total, bound)


def _ratio_test(first_omitted: arb, tau: fmpq, beta: fmpq, beyond: int) -> arb:
    size = arb(abs(tau)).abs_upper()
    ratio = (1 + arb(abs(beta)).abs_upper() / beyond) * size**3 / ((beyond + 1) * (beyond + 2))
    if not ratio < 1:  # the hypothesis of the ratio test, certain or not used
        return nonfinite()
    return first_omitted / (1 - ratio)
