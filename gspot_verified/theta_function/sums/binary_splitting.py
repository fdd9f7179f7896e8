"""Sums of a hypergeometric kind, by exact binary splitting: the quotient of neighbouring terms is N(k)/D(k).

Proof page: ``proofs/splitting.md``.
"""

from __future__ import annotations

from dataclasses import dataclass

from flint import arb, fmpz, fmpz_poly

from gspot_verified.numbers.balls import working_bits

_BITS_OF_A_BOUND = 64  # of a bound, of which a few digits count; any number is right


@dataclass(frozen=True, slots=True)
class Block:
    """``length`` consecutive terms as integer polynomials in the index k of the first one.

    The indices of neighbouring terms differ by ``stride``. numerator = prod N(k + stride i), denominator = prod
    D(k + stride i), and partial = denominator times the block's share of the sum, over i < length.
    """

    numerator: fmpz_poly
    denominator: fmpz_poly
    partial: fmpz_poly
    length: int
    stride: int

    def _doubled(self) -> Block:
        shift = fmpz_poly([self.stride * self.length, 1])
        numerator, denominator, partial = (
            polynomial(shift) for polynomial in (self.numerator, self.denominator, self.partial)
        )
        return Block(
            self.numerator * numerator,
            self.denominator * denominator,
            self.partial * denominator + self.numerator * partial,
            2 * self.length,
            self.stride,
        )


def block(numerator: fmpz_poly, denominator: fmpz_poly, length: int, stride: int = 1) -> Block:
    """The block of ``length`` = 2^n terms whose neighbours have the quotient numerator(k)/denominator(k)."""
    doubled = Block(numerator, denominator, denominator, 1, stride)
    while doubled.length < length:
        doubled = doubled._doubled()
    return doubled


_Node = tuple[fmpz, fmpz, fmpz]
_Balls = tuple[arb, arb, arb]


def _merge(left: _Node, right: _Node) -> _Node:
    return left[0] * right[0], left[1] * right[1], left[2] * right[1] + left[0] * right[2]


def _merge_balls(left: _Balls, right: _Balls) -> _Balls:
    return left[0] * right[0], left[1] * right[1], left[2] * right[1] + left[0] * right[2]


def split_sum(terms: Block, first: int, blocks: int, bits: int) -> tuple[arb, arb]:
    """Enclosures of sum_(i < n) prod_(l < i) N/D and of prod_(l < n) N/D, n = blocks * terms.length, from k = first on.

    Exact integers while they are no longer than ``bits``, balls of that precision from there on. The product, which
    only bounds what is left out, comes with 64 bits.
    """
    step = terms.stride * terms.length
    nodes: list[_Node] = []
    for k in range(first, first + blocks * step, step):
        nodes.append((terms.numerator(k), terms.denominator(k), terms.partial(k)))
    while len(nodes) > 1 and nodes[-2][1].bit_length() <= bits:
        odd = [nodes[-1]] if len(nodes) % 2 else []
        nodes = [_merge(nodes[i], nodes[i + 1]) for i in range(0, len(nodes) - 1, 2)] + odd
    with working_bits(bits):
        rounded: list[_Balls] = [(arb(p), arb(q), arb(t)) for p, q, t in nodes]
        while len(rounded) > 1:
            last = [rounded[-1]] if len(rounded) % 2 else []
            rounded = [_merge_balls(rounded[i], rounded[i + 1]) for i in range(0, len(rounded) - 1, 2)] + last
        numerator, denominator, partial = rounded[0]
        total = partial / denominator
    with working_bits(_BITS_OF_A_BOUND):
        return total, numerator / denominator
