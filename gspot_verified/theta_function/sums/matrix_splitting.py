"""Sums over a recurrence of the second order with rational coefficients, by exact binary splitting of 2x2 matrices.

Proof page: ``proofs/splitting.md``, "Matrices".
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import reduce

from flint import arb, arb_mat, fmpz, fmpz_mat, fmpz_poly

from gspot_verified.numbers.balls import working_bits

Polynomials = tuple[tuple[fmpz_poly, fmpz_poly], ...]
"""The rows of a matrix with two columns whose entries are integer polynomials in the index."""


@dataclass(frozen=True, slots=True)
class MatrixBlock:
    """``length`` consecutive steps as integer polynomials in the index k of the first one.

    product = N(k + length - 1) ... N(k), denominator = prod D(k + i), and partial = denominator times the block's share
    of sum_i R(k + i)/D(k + i) N(k + i - 1)/D(k + i - 1) ... N(k)/D(k), with as many rows as R.
    """

    product: Polynomials
    denominator: fmpz_poly
    partial: Polynomials
    length: int = 1

    def _reduced(self) -> MatrixBlock:
        rows = (*self.product, *self.partial)
        common = reduce(fmpz.gcd, (entry.content() for row in rows for entry in row), self.denominator.content())
        product, partial = (
            tuple((row[0] // common, row[1] // common) for row in matrix) for matrix in (self.product, self.partial)
        )
        return MatrixBlock(product, self.denominator // common, partial, self.length)

    def _doubled(self) -> MatrixBlock:
        shift = fmpz_poly([self.length, 1])
        product, partial = (_shifted(matrix, shift) for matrix in (self.product, self.partial))
        denominator = self.denominator(shift)
        later = _times(partial, self.product)
        return MatrixBlock(
            _times(product, self.product),
            self.denominator * denominator,
            tuple(
                (first[0] * denominator + second[0], first[1] * denominator + second[1])
                for first, second in zip(self.partial, later, strict=True)
            ),
            2 * self.length,
        )

    def of_length(self, length: int) -> MatrixBlock:
        """The block of ``length`` = 2^n steps, from this one of a single step, freed of its common factor."""
        block = self._reduced()
        while block.length < length:
            block = block._doubled()
        return block


def _shifted(matrix: Polynomials, shift: fmpz_poly) -> Polynomials:
    return tuple((row[0](shift), row[1](shift)) for row in matrix)


def _times(left: Polynomials, right: Polynomials) -> Polynomials:
    (a, b), (c, d) = right
    return tuple((row[0] * a + row[1] * c, row[0] * b + row[1] * d) for row in left)


_Node = tuple[fmpz_mat, fmpz, fmpz_mat]
_Balls = tuple[arb_mat, arb, arb_mat]


def _merge(left: _Node, right: _Node) -> _Node:
    return right[0] * left[0], left[1] * right[1], left[2] * right[1] + right[2] * left[0]


def _merge_balls(left: _Balls, right: _Balls) -> _Balls:
    return right[0] * left[0], left[1] * right[1], left[2] * right[1] + right[2] * left[0]


def split_matrix_sum(steps: MatrixBlock, blocks: int, bits: int) -> arb_mat:
    """An enclosure of sum_(i < n) R(i)/D(i) N(i-1)/D(i-1) ... N(0)/D(0), n = blocks * steps.length.

    Exact integers while they are no longer than ``bits``, balls of that precision from there on.
    """
    nodes: list[_Node] = []
    for k in range(0, blocks * steps.length, steps.length):
        nodes.append((_at(steps.product, k), steps.denominator(k), _at(steps.partial, k)))
    while len(nodes) > 1 and nodes[-2][1].bit_length() <= bits:
        odd = [nodes[-1]] if len(nodes) % 2 else []
        nodes = [_merge(nodes[i], nodes[i + 1]) for i in range(0, len(nodes) - 1, 2)] + odd
    with working_bits(bits):
        rounded: list[_Balls] = [(arb_mat(p), arb(q), arb_mat(t)) for p, q, t in nodes]
        while len(rounded) > 1:
            last = [rounded[-1]] if len(rounded) % 2 else []
            rounded = [_merge_balls(rounded[i], rounded[i + 1]) for i in range(0, len(rounded) - 1, 2)] + last
        return rounded[0][2] / rounded[0][1]


def _at(matrix: Polynomials, k: int) -> fmpz_mat:
    return fmpz_mat([[row[0](k), row[1](k)] for row in matrix])
