"""Certain signs of F = Theta(., b), of its tau-derivatives and of dF/db on boxes over one range of b."""

from __future__ import annotations

from functools import cached_property

from flint import fmpq

from gspot_verified.balls import approximate, sign_of
from gspot_verified.signs.tails import right_changes
from gspot_verified.theta.box import TaylorModel, taylor_model
from gspot_verified.theta.box_choice import bits_for_box, degree_for_box, length_for_box, order_for_box
from gspot_verified.theta.parameter_series import ParameterSeries, parameter_series


class ColumnModels:
    """Taylor models over b in [lower, upper] for |tau| <= reach, made once and shared by all boxes of a column."""

    def __init__(self, lower: fmpq, upper: fmpq, reach: fmpq) -> None:
        self.centre, self.radius = (lower + upper) / 2, (upper - lower) / 2
        self._size = approximate(max(abs(lower), abs(upper)))
        self._reach = approximate(reach)
        self.boxes = 0

    def _series(self, radius: fmpq) -> ParameterSeries:
        bits = bits_for_box(self._reach, self._size)
        degree = degree_for_box(self._reach, self._size, approximate(radius))
        length = length_for_box(self._reach + 1, self._size, bits)
        return parameter_series(self.centre, radius, degree, length, bits)

    @cached_property
    def _narrow(self) -> ParameterSeries:
        return self._series(self.radius)

    @cached_property
    def _wide(self) -> ParameterSeries:
        return self._series(2 * self.radius)

    def _model(self, series: ParameterSeries, lower: fmpq, upper: fmpq, derivative: int) -> TaylorModel:
        self.boxes += 1
        order = order_for_box(approximate((lower + upper) / 2), approximate((upper - lower) / 2), self._size)
        return taylor_model(series, lower, upper, order, derivative)

    def sign(self, lower: fmpq, upper: fmpq, derivative: int = 0) -> int | None:
        """The sign of F (or of F', F'') on [lower, upper] and the whole range of b, or None."""
        return sign_of(self._model(self._narrow, lower, upper, derivative).enclosure())

    def sign_at_centre(self, tau: fmpq) -> int | None:
        """The sign of F at tau and the middle of the range of b, or None."""
        return sign_of(self._model(self._narrow, tau, tau, 0).value(tau, self.centre))

    def fold(self, lower: fmpq, upper: fmpq) -> bool:
        """Whether the hypotheses of ``proofs/fold.md`` hold hold: F'' > 0, dF/db > 0, F > 0 at both ends."""
        if not self.radius:
            return False
        return (
            self.sign(lower, lower) == 1
            and self.sign(upper, upper) == 1
            and self.sign(lower, upper, 2) == 1
            and sign_of(self._model(self._wide, lower, upper, 0).beta_derivative().enclosure()) == 1
        )

    def changes(self, tau: fmpq, n: int) -> int | None:
        """The number v of ``proofs/tails.md`` at tau, or None."""
        return right_changes(self._narrow, tau, n)
