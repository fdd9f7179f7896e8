"""The coordinates in which deviations are followed, and first guesses of their bounds. Heuristic: any choice is right.

On a piece that begins at s_k, e = Y(s - s_k) Q u: Y is a polynomial matrix near the flow of the limit at delta = 0, Q a
regular matrix. Both are exact numbers.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, arb_mat, fmpq

from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.integrator.box_steps.choice import turned_basis
from gspot_verified.numbers.balls import approximate, ball

_DEGREE = 12  # of the flow's polynomial in s
_PIECES = 14  # in a unit of tau


@dataclass(frozen=True)
class Frame:
    """``flow[k]`` is the coefficient of (s - s_k)^k of Y; ``turned`` is Q."""

    flow: tuple[arb_mat, ...]
    turned: arb_mat

    def at(self, time: arb) -> arb_mat:
        """Y(time)."""
        return matrix_value(self.flow, time)


def matrix_value(coefficients: Sequence[arb_mat], time: arb) -> arb_mat:
    """The value of a polynomial with matrices as coefficients."""
    total = coefficients[-1]
    for matrix in reversed(coefficients[:-1]):
        total = total * time + matrix
    return total


def identity(size: int) -> arb_mat:
    """The unit matrix."""
    return arb_mat(size, size, [int(i == j) for i in range(size) for j in range(size)])


def frame_at(equations: DeviationEquations, start: fmpq, turned: arb_mat) -> Frame:
    """Taylor coefficients of the limit's flow from ``start``, rounded to exact numbers."""
    matrix, slope = equations.limit(ball(start)).mid(), equations.limit_slope().mid()
    flow = [identity(equations.size)]
    for k in range(_DEGREE):
        term = matrix * flow[k]
        if k:
            term = term + slope * flow[k - 1]
        flow.append((term * (arb(1) / (k + 1))).mid())
    return Frame(tuple(flow), turned)


def turned_frame(columns: arb_mat, radii: Sequence[arb]) -> arb_mat:
    """Orthonormal directions, those of the longest deviations first (Lohner's order)."""
    return arb_mat(turned_basis(columns.mid().table(), list(radii)))


def number_of_pieces(equations: DeviationEquations, start: fmpq, end: fmpq) -> int:
    """Some pieces for each unit of tau = (-alpha_1 kappa)^(1/3) s, in which the limit has one scale."""
    unit: float = approximate(-equations.alpha_1 * equations.kappa) ** (1 / 3)
    return max(1, math.ceil(_PIECES * unit * approximate(end - start)))


def larger(value: arb) -> arb:
    """A guess above a bound that was found."""
    return (value * arb("1.03") + arb("1e-25")).upper()
