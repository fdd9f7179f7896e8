"""Certain signs of G_b(tau; eta) and its tau-derivatives on intervals of tau, from Taylor expansions on a grid of tau.

Proof page: ``proofs/finite_epsilon_zeros.md``, sections 1 and 2.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from flint import arb, arb_mat, fmpq

from gspot_verified.numbers.balls import add_remainder, ball, sign_of, working_bits
from gspot_verified.signs.cover.tails import changes_of_sign

CELL = fmpq(1, 2)
"""The line of tau is cut at the multiples of this; each cell has one expansion, at its middle."""

Expansion = Callable[[int], arb_mat]
"""For the cell [k CELL, (k+1) CELL] the c_0, ..., c_K at its middle: row j encloses c_j, for every b and eta of a box,
by its first entry plus [-1, 1] times the others."""


class SlowSigns:
    """``order`` = K > the largest b: beyond it all derivatives have one sign and increase in size with tau."""

    def __init__(self, expansion: Expansion, order: int, bits: int) -> None:
        self._expansion, self._order, self._bits = expansion, order, bits
        self._kept: dict[int, arb_mat] = {}

    def _cell(self, k: int) -> arb_mat:
        if k not in self._kept:
            self._kept[k] = self._expansion(k)
        return self._kept[k]

    def coefficients(self, lower: fmpq, upper: fmpq, count: int) -> list[arb]:
        """Enclosures of c_j(tau), j < ``count`` <= K, for all tau in [lower, upper], which lies in one cell.

        :raises ValueError: the interval is in no cell.
        """
        middle = (lower + upper) / 2
        k = int((middle / CELL).floor())
        if lower < k * CELL or upper > (k + 1) * CELL:
            raise ValueError("the interval of tau must lie in one cell of the grid")
        here, centre = self._cell(k), (k + fmpq(1, 2)) * CELL
        with working_bits(self._bits):
            entries = here.entries()
            width = len(entries) // (self._order + 1)
            last_left_out = arb_mat(self._order, width, entries[: self._order * width])
            moved = (_shift(middle - centre, self._order) * last_left_out).entries()
            spread = add_remainder(arb(0), ball((upper - lower) / 2))
            total = _shift_ball(spread, self._order, count)
            beyond = _range(self._cell(k + 1).entries()[-width:])
            reach = ball(max(abs(lower - centre), abs(upper - centre)))
            ranges = [_range(moved[row * width : (row + 1) * width]) for row in range(self._order)]
            enclosures = []
            for j in range(count):
                inner = sum((weight * ranges[j + i] for i, weight in enumerate(total[j])), arb(0))
                rest = math.comb(self._order, j) * reach ** (self._order - j) * beyond
                enclosures.append(add_remainder(inner, rest))
            return enclosures

    def sign(self, lower: fmpq, upper: fmpq, derivative: int = 0) -> int | None:
        """The sign of the derivative on [lower, upper], or None."""
        return sign_of(self.coefficients(lower, upper, derivative + 1)[derivative])

    def changes(self, tau: fmpq, n: int) -> int | None:
        """The number of changes of sign in c_0, ..., c_n at tau, then (-1)^(n+1); None if it is not certain."""
        signs = [sign_of(value) for value in self.coefficients(tau, tau, n + 1)]
        return changes_of_sign([*signs, -1 if n % 2 == 0 else 1])

    def positive_before(self, tau: fmpq, n: int) -> bool:
        """Whether (-1)^k c_k > 0 at tau for k = 0, ..., n: then G_b > 0 on (-infinity, tau]."""
        values = self.coefficients(tau, tau, n + 1)
        return all(sign_of(value) == (-1) ** k for k, value in enumerate(values))


def _shift(step: fmpq, order: int) -> arb_mat:
    """c_j(tau + x) = sum_(k>=j) binom(k, j) x^(k-j) c_k(tau), without the remainder."""
    powers = [step**i for i in range(order)]
    return arb_mat(
        [[arb(math.comb(k, j) * powers[k - j]) if k >= j else arb(0) for k in range(order)] for j in range(order)]
    )


def _shift_ball(spread: arb, order: int, count: int) -> list[list[arb]]:
    """The same weights binom(j + i, j) x^i for x in a ball around 0."""
    powers = [arb(1)]
    for _ in range(order - 1):
        powers.append(powers[-1] * spread)
    return [[math.comb(j + i, j) * powers[i] for i in range(order - j)] for j in range(count)]


def _range(entries: Sequence[arb]) -> arb:
    """All numbers of one row: the first entry plus [-1, 1] times the others."""
    return add_remainder(entries[0], sum((abs(entry) for entry in entries[1:]), arb(0)))
