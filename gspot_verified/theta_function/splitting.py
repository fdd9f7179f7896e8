"""The Taylor series at rational tau and beta, by exact binary splitting: quasi-linear in the number of digits.

Proof page: ``proofs/splitting.md``.
"""

from __future__ import annotations

from dataclasses import dataclass

from flint import arb, fmpq, fmpz, fmpz_poly

from gspot_verified.balls import add_remainder, nonfinite, working_bits
from gspot_verified.theta_function.initial_values import initial_values


@dataclass(frozen=True, slots=True)
class _Block:
    """``length`` consecutive terms of a chain as integer polynomials in the index k of the first one.

    numerator = prod N(k + 3i), denominator = prod D(k + 3i), and partial = denominator times the block's share of the
    sum, where N(k)/D(k) is the ratio of the terms k + 3 and k of the Taylor series.
    """

    numerator: fmpz_poly
    denominator: fmpz_poly
    partial: fmpz_poly
    length: int

    def doubled(self) -> _Block:
        shift = fmpz_poly([3 * self.length, 1])
        numerator, denominator, partial = (
            polynomial(shift) for polynomial in (self.numerator, self.denominator, self.partial)
        )
        return _Block(
            self.numerator * numerator,
            self.denominator * denominator,
            self.partial * denominator + self.numerator * partial,
            2 * self.length,
        )


_Node = tuple[fmpz, fmpz, fmpz]
_Balls = tuple[arb, arb, arb]


def _block(tau: fmpq, beta: fmpq, length: int) -> _Block:
    """The polynomials of a block of ``length`` = 2^n terms: one set serves the three chains k = j, j+3, j+6, ..."""
    cube = tau**3
    k = fmpz_poly([0, 1])
    block = _Block(
        (k * beta.q - beta.p) * cube.p,
        (k + 1) * (k + 2) * (k + 3) * (beta.q * cube.q),
        (k + 1) * (k + 2) * (k + 3) * (beta.q * cube.q),
        1,
    )
    while block.length < length:
        block = block.doubled()
    return block


def _merge(left: _Node, right: _Node) -> _Node:
    return left[0] * right[0], left[1] * right[1], left[2] * right[1] + left[0] * right[2]


def _merge_balls(left: _Balls, right: _Balls) -> _Balls:
    return left[0] * right[0], left[1] * right[1], left[2] * right[1] + left[0] * right[2]


def _chain(block: _Block, first: int, blocks: int, bits: int) -> _Balls:
    """Numerator, denominator and partial sum of ``blocks`` blocks that start at the index ``first``.

    Exact integers while they are no longer than ``bits``, balls at the current precision from there on.
    """
    step = 3 * block.length
    nodes: list[_Node] = []
    for k in range(first, first + blocks * step, step):
        nodes.append((block.numerator(k), block.denominator(k), block.partial(k)))
    while len(nodes) > 1 and nodes[-2][1].bit_length() <= bits:
        odd = [nodes[-1]] if len(nodes) % 2 else []
        nodes = [_merge(nodes[i], nodes[i + 1]) for i in range(0, len(nodes) - 1, 2)] + odd
    rounded: list[_Balls] = [(arb(p), arb(q), arb(t)) for p, q, t in nodes]
    while len(rounded) > 1:
        last = [rounded[-1]] if len(rounded) % 2 else []
        rounded = [_merge_balls(rounded[i], rounded[i + 1]) for i in range(0, len(rounded) - 1, 2)] + last
    return rounded[0]


def splitting_sum(tau: fmpq, beta: fmpq, length: int, bits: int, block_length: int) -> arb:
    """An enclosure of Theta(tau, beta) from at least ``length`` Taylor terms, summed exactly up to ``bits`` bits.

    ``block_length`` (a power of two) only moves work between polynomials and integers; any choice is correct.
    Not finite when ``length`` is too small for the ratio test of ``proofs/taylor.md``. Its cost follows the sizes of
    the integers in tau and beta: use it for rationals of small height.
    """
    values = initial_values(beta, bits)
    block = _block(tau, beta, block_length)
    blocks = -(-length // (3 * block_length))
    beyond = 3 * block_length * blocks
    total, rest = arb(0), arb(0)
    for j in range(3):
        if values[j].is_zero():
            continue
        with working_bits(bits):
            numerator, denominator, partial = _chain(block, j, blocks, bits)
            scale = values[j] * (tau**j / (1 + (j > 1))) / denominator
            total += scale * partial
        with working_bits(64):
            rest += (scale * numerator).abs_upper()
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
