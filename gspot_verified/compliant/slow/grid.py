"""The nodes of the trapezoidal rule for the slow solution, and the part of its exponent that no T and no b enters.

Proof page: ``proofs/slow_integral.md``, sections 1 and 2.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

from flint import arb, arb_poly, fmpq

from gspot_verified.numbers.balls import Exact, add_remainder, approximate, ball, current_bits, working_bits

# Below this x = eta rho the exponent is summed: the closed form would lose 3 log2(1/x) bits and more.
_SERIES_BELOW = fmpq(1, 16)
_BLOCK = 16  # nodes that are kept together; each is made from the one before


@dataclass(frozen=True, slots=True)
class Grid:
    """Nodes rho_k = e^(k step), first <= k <= last, and e^(-rho_k^3/3 + h(rho_k; eta)) as logarithms, in balls."""

    step: fmpq
    first: int
    last: int
    nodes: tuple[arb, ...]
    exponents: tuple[arb, ...]


def grid(epsilon: Exact, step: fmpq, first: int, last: int, bits: int) -> Grid:
    """The grid at one epsilon > 0, or for all epsilon of a ball; kept for the next calls at the same one.

    Nodes are made and kept in blocks, so that grids which overlap share them.
    """
    block = _kept_block if isinstance(epsilon, fmpq) else _new_block
    nodes: list[arb] = []
    exponents: list[arb] = []
    start = first // _BLOCK
    for index in range(start, last // _BLOCK + 1):
        made = block(epsilon, step, index, bits)
        nodes += made[0]
        exponents += made[1]
    begin, end = first - start * _BLOCK, last + 1 - start * _BLOCK
    return Grid(step, first, last, tuple(nodes[begin:end]), tuple(exponents[begin:end]))


@lru_cache(maxsize=1024)
def _nodes(step: fmpq, index: int, bits: int) -> tuple[arb, ...]:
    """rho_k for the k of one block."""
    # A product of up to _BLOCK factors: each multiplication adds 2^-bits relative.
    with working_bits(bits + _BLOCK.bit_length() + 8):
        ratio, node = arb(step).exp(), (arb(step) * (_BLOCK * index)).exp()
        nodes = [node]
        for _ in range(_BLOCK - 1):
            node = node * ratio
            nodes.append(node)
        return tuple(nodes)


def _new_block(epsilon: Exact, step: fmpq, index: int, bits: int) -> tuple[tuple[arb, ...], tuple[arb, ...]]:
    nodes = _nodes(step, index, bits)
    with working_bits(bits):
        return nodes, tuple(cubic_exponent(scale(epsilon), nodes))


_kept_block = lru_cache(maxsize=1024)(_new_block)


def scale(epsilon: Exact) -> arb:
    """eta = (epsilon/2)^(1/3), epsilon > 0."""
    return (ball(epsilon) / 2).root(3)


def cubic_exponent(eta: arb, nodes: tuple[arb, ...]) -> list[arb]:
    """-rho^3/3 + h(rho; eta) = psi(eta rho)/epsilon at the nodes, rho > 0, eta > 0 (proofs/slow_integral.md, (2)).

    >>> from flint import arb
    >>> value = cubic_exponent(arb(1), (arb(1),))[0]
    >>> bool(abs(value - (fmpq(1, 6) - arb(2).log()) / 2) < fmpq(1, 10**12))
    True
    """
    bits = current_bits()
    series = _half_phi(_series_length(eta, nodes, bits), bits)
    exponents = []
    for rho in nodes:
        x = eta * rho
        cube = rho * rho * rho
        if x < _SERIES_BELOW:
            exponents.append(cube * (_half_phi_at(x, *series) - fmpq(1, 3)))
        else:
            exponents.append((x - x * x / 2 - x * x * x / 3 - x.log1p()) / (2 * eta * eta * eta))
    return exponents


def _series_length(eta: arb, nodes: tuple[arb, ...], bits: int) -> int:
    """Terms after which the largest node below the limit leaves less than 2^-bits; any number is right."""
    largest = max((approximate(eta * rho) for rho in nodes if eta * rho < _SERIES_BELOW), default=0.0)
    return 2 + math.ceil(bits / max(4.0, -math.log2(max(largest, 1e-300))))


@lru_cache(maxsize=64)
def _half_phi(length: int, bits: int) -> tuple[arb_poly, int]:
    """The terms j < length of phi(x)/2, phi(x) = sum_(j>=1) (-1)^(j+1) x^j/(j+3), and their number."""
    with working_bits(bits):
        return arb_poly([arb(0)] + [arb(fmpq((-1) ** (j + 1), 2 * (j + 3))) for j in range(1, length)]), length


def _half_phi_at(x: arb, polynomial: arb_poly, length: int) -> arb:
    """phi(x)/2 for 0 < x < 1: the terms alternate and decrease, so the rest is at most the first one left out."""
    return add_remainder(polynomial(x), x**length / (2 * (length + 3)))
