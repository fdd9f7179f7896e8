"""Polynomial interpolation on [-1, 1] at rational nodes near Chebyshev's: exact matrices, and bounds for its remainder.

Proof page: ``proofs/finite_epsilon_zeros.md``, section 5.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

from flint import arb, fmpq, fmpq_mat

from gspot_verified.numbers.balls import working_bits

_NODE_BITS = 12  # of a node, so that the matrices have short entries; any different nodes are right
_PIECES = 96  # of [-1, 1] on which the product is bounded: more make the bound less
_BOUND_BITS = 64  # of a bound, of which a few digits count; any number is right


@dataclass(frozen=True, slots=True)
class Nodes:
    """``places`` in [-1, 1]; ``to_powers``: from the values there to the coefficients of 1, x, x^2, ... (exact);
    ``lebesgue``: a bound on [-1, 1] of the sum of the absolute values of Lagrange's polynomials."""

    places: tuple[fmpq, ...]
    to_powers: fmpq_mat
    lebesgue: fmpq


@lru_cache(maxsize=64)
def nodes(count: int) -> Nodes:
    """``count`` >= 1 different nodes.

    >>> nodes(1).places, nodes(2).lebesgue >= 1
    ((0,), True)
    """
    scale = 2**_NODE_BITS
    exact = [math.cos(math.pi * (2 * i + 1) / (2 * count)) if 2 * i + 1 != count else 0.0 for i in range(count)]
    places = tuple(fmpq(round(place * scale), scale) for place in exact)
    if len(set(places)) != count:
        raise ValueError("expected fewer nodes: two of them coincide")
    vandermonde = fmpq_mat([[place**i for i in range(count)] for place in places])
    inverse = vandermonde.inv()
    lebesgue = fmpq(0)
    for column in range(count):
        lebesgue += sum((abs(inverse[row, column]) for row in range(count)), fmpq(0))
    return Nodes(places, inverse, lebesgue)


@lru_cache(maxsize=256)
def node_product(count: int, distance: fmpq) -> arb:
    """A bound of prod |z - x_i| over the nodes for all complex z within ``distance`` of [-1, 1].

    >>> bool(node_product(1, fmpq(0)) >= 1)
    True
    """
    places = nodes(count).places
    with working_bits(_BOUND_BITS):
        largest = arb(0)
        for piece in range(_PIECES):
            lower, upper = fmpq(2 * piece, _PIECES) - 1, fmpq(2 * piece + 2, _PIECES) - 1
            factors = (max(abs(lower - place), abs(upper - place)) + distance for place in places)
            largest = largest.max(math.prod((arb(factor) for factor in factors), start=arb(1)))
        return largest.abs_upper()


def substitution(count: int, middle: fmpq, radius: fmpq) -> fmpq_mat:
    """The coefficients of p(middle + radius s) in s from those of p(x), degree below ``count``, as a matrix."""
    return fmpq_mat(
        [
            [math.comb(i, j) * middle ** (i - j) * radius**j if i >= j else fmpq(0) for i in range(count)]
            for j in range(count)
        ]
    )
