"""Certain signs of F = Theta(., b), of its tau-derivatives and of dF/db on boxes over one range of b."""

from __future__ import annotations

from flint import fmpq

from gspot_verified.balls import approximate, sign_of
from gspot_verified.signs.tails import right_changes
from gspot_verified.theta_function.box import TaylorModel, taylor_model
from gspot_verified.theta_function.box_choice import bits_for_box, degree_for_box, length_for_box, order_for_box
from gspot_verified.theta_function.parameter_series import ParameterSeries, parameter_series, shortened

_LEAST_RADIUS = 1e-300
# Signs on boxes ask for little: fewer terms are faster, and a box that stays open is cut.
_GOAL_BITS = 12
_LEAST_DOUBLED_RADIUS = fmpq(1, 64)


class ColumnModels:
    """Taylor models over b in [lower, upper] for |tau| <= reach, made once and shared by all boxes of a column."""

    def __init__(self, lower: fmpq, upper: fmpq, reach: fmpq) -> None:
        self.centre, self.radius = (lower + upper) / 2, (upper - lower) / 2
        self._size = approximate(max(abs(lower), abs(upper)))
        self._reach = approximate(reach)
        self._made: dict[tuple[bool, float], ParameterSeries] = {}

    def _series(self, reach: float, doubled: bool = False) -> ParameterSeries:
        """The series for |tau| <= reach; ``doubled``: over twice the range of b or more. Few lengths: boxes share."""
        level = self._reach
        while level / 2 >= max(reach, 1.0):
            level /= 2
        if (doubled, level) not in self._made:
            bits = bits_for_box(level, self._size, _GOAL_BITS)
            length = length_for_box(level + 1, self._size, bits)
            if level < self._reach:
                whole = self._series(self._reach, doubled)
                series = shortened(whole, length, bits) if length <= whole.length - 3 else whole
            else:
                # The derivative in b divides the remainder by the radius: a tiny one would lose it.
                radius = max(2 * self.radius, _LEAST_DOUBLED_RADIUS) if doubled else self.radius
                # A radius too small for a float still needs the powers of eta.
                small = max(approximate(radius), _LEAST_RADIUS) if radius else 0.0
                degree = degree_for_box(level, self._size, small, _GOAL_BITS)
                series = parameter_series(self.centre, radius, degree, length, bits)
            self._made[doubled, level] = series
        return self._made[doubled, level]

    def _model(self, lower: fmpq, upper: fmpq, derivative: int, doubled: bool = False) -> TaylorModel:
        middle, half_width = approximate((lower + upper) / 2), approximate((upper - lower) / 2)
        series = self._series(abs(middle) + half_width, doubled)
        return taylor_model(series, lower, upper, order_for_box(middle, half_width, self._size, _GOAL_BITS), derivative)

    def sign(self, lower: fmpq, upper: fmpq, derivative: int = 0) -> int | None:
        """The sign of F (or of F', F'') on [lower, upper] and the whole range of b, or None."""
        return sign_of(self._model(lower, upper, derivative).enclosure())

    def sign_at_centre(self, tau: fmpq) -> int | None:
        """The sign of F at tau and the middle of the range of b, or None."""
        return sign_of(self._model(tau, tau, 0).value(tau, self.centre))

    def fold(self, lower: fmpq, upper: fmpq) -> bool:
        """Whether the hypotheses of ``proofs/fold.md`` hold: F'' > 0, dF/db > 0, F > 0 at both ends."""
        if not self.radius:
            return False
        return (
            self.sign(lower, lower) == 1
            and self.sign(upper, upper) == 1
            and self.sign(lower, upper, 2) == 1
            and sign_of(self._model(lower, upper, 0, doubled=True).beta_derivative().enclosure()) == 1
        )

    def changes(self, tau: fmpq, n: int) -> int | None:
        """The number v of ``proofs/tails.md`` at tau, or None."""
        return right_changes(self._series(approximate(tau)), tau, n)
