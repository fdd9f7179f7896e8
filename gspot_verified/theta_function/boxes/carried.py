"""Theta over a range of b, carried along tau from 0: values at every point, from series at equally spaced points.

Heuristics only: where the series stand, their lengths and their precision. Any choice gives correct enclosures.
"""

from __future__ import annotations

from flint import fmpq

from gspot_verified.numbers.balls import approximate, working_bits
from gspot_verified.theta_function.boxes.box_choice import bits_carried, degree_carried, length_of_series
from gspot_verified.theta_function.boxes.carried_series import (
    ParameterRange,
    Polynomials,
    Table,
    initial_polynomials,
    local_series,
    table,
    values_at,
)

_STEP = fmpq(1)  # between the points at which values are kept


class CarriedTheta:
    """Theta(., b) for b = centre +- radius. Points up to |tau| = reach are expected; beyond it accuracy is lost."""

    def __init__(self, centre: fmpq, radius: fmpq, reach: fmpq, goal: int) -> None:
        size, far = approximate(abs(centre) + radius), approximate(reach)
        self.bits = bits_carried(far, size, goal)
        self.range_of_b = ParameterRange(centre, radius, degree_carried(far, size, approximate(radius), goal))
        self._size = size
        with working_bits(self.bits):
            self._values = {0: initial_polynomials(self.range_of_b, self.bits)}
        self._tables: dict[int, Table] = {}

    def values(self, tau: fmpq) -> Polynomials:
        """F, F' and F''/2 at tau."""
        index = int((tau / _STEP + fmpq(1, 2)).floor())
        with working_bits(self.bits):
            if tau == index * _STEP:
                return self._at(index)
            return values_at(self._table(index), _STEP, tau / _STEP - index)

    def _at(self, index: int) -> Polynomials:
        """The values at the point of that index, each from those before it, which is nearer to 0."""
        direction = 1 if index > 0 else -1
        known = index
        while known not in self._values:
            known -= direction
        for k in range(known, index, direction):
            self._values[k + direction] = values_at(self._table(k), _STEP, fmpq(direction))
        return self._values[index]

    def _table(self, index: int) -> Table:
        if index not in self._tables:
            point = index * _STEP
            length = length_of_series(approximate(abs(point)), 1.0, self._size, self.bits)
            series = local_series(self._at(index), self.range_of_b, point, _STEP, length)
            self._tables[index] = table(series, self.range_of_b.degree)
        return self._tables[index]
