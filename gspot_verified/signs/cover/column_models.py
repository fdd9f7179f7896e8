"""Certain signs of F = Theta(., b), of its tau-derivatives and of dF/db on boxes over one range of b."""

from __future__ import annotations

from functools import lru_cache

from flint import arb, arb_poly, fmpq

from gspot_verified.numbers.balls import approximate, sign_of, working_bits
from gspot_verified.signs.cover.tails import right_changes
from gspot_verified.theta_function.boxes.box import TaylorModel, taylor_model
from gspot_verified.theta_function.boxes.box_choice import (
    bits_for_box,
    degree_for_box,
    degree_of_box,
    length_for_box,
    length_of_series,
    order_for_box,
)
from gspot_verified.theta_function.boxes.carried import CarriedTheta
from gspot_verified.theta_function.boxes.carried_series import (
    ParameterRange,
    coefficients,
    enclosure,
    folded,
    local_series,
    range_of,
)
from gspot_verified.theta_function.boxes.parameter_series import parameter_series

# Signs on boxes ask for little: fewer terms are faster, and a box that stays open is cut.
_CARRIED_BITS = 24
_GOAL_BITS = 36  # of the series on a box
_BOX_BITS = 64  # of its arithmetic
_GOAL_BITS_IN_B = 60  # of the model that dF/db is taken from, which loses more
_LEAST_DOUBLED_RADIUS = fmpq(1, 64)  # in b: a tiny radius would lose dF/db
_KEPT_BOXES = 64  # whose ranges serve F, F' and F''


class ColumnModels:
    """Series over b in [lower, upper] for |tau| <= reach, made once and shared by all boxes of a column."""

    def __init__(self, lower: fmpq, upper: fmpq, reach: fmpq) -> None:
        self.centre, self.radius = (lower + upper) / 2, (upper - lower) / 2
        self._size = approximate(max(abs(lower), abs(upper)))
        self._carried = CarriedTheta(self.centre, self.radius, reach, _CARRIED_BITS)
        self._ranges = lru_cache(_KEPT_BOXES)(self._ranges_of_coefficients)

    def _start(self, tau: fmpq) -> tuple[list[arb_poly], ParameterRange]:
        """F, F' and F''/2 at tau with the few powers of eta that a sign asks for."""
        values = self._carried.values(tau)
        degree = degree_of_box(abs(approximate(tau)), approximate(self.radius), _GOAL_BITS)
        degree = min(degree, self._carried.range_of_b.degree)
        return [folded(value, degree) for value in values], ParameterRange(self.centre, self.radius, degree)

    def _ranges_of_coefficients(self, lower: fmpq, upper: fmpq) -> list[arb]:
        """The ranges of a_0, a_1, ... on the box."""
        middle, half_width = (lower + upper) / 2, (upper - lower) / 2
        with working_bits(_BOX_BITS):
            start, b = self._start(middle)
            if not half_width:
                return [range_of(value) for value in start]
            distance, scale = abs(approximate(middle)), approximate(half_width)
            length = length_of_series(distance, scale, self._size, _GOAL_BITS)
            return [range_of(a) for a in local_series(start, b, middle, half_width, length)]

    def sign(self, lower: fmpq, upper: fmpq, derivative: int = 0) -> int | None:
        """The sign of F (or of F', F'') on [lower, upper] and the whole range of b, or None."""
        with working_bits(_BOX_BITS):
            ranges = self._ranges(lower, upper)
            return sign_of(ranges[derivative] if lower == upper else enclosure(ranges, derivative))

    def sign_at_centre(self, tau: fmpq) -> int | None:
        """The sign of F at tau and the middle of the range of b, or None."""
        return sign_of(self._carried.values(tau)[0][0])

    def fold(self, lower: fmpq, upper: fmpq) -> bool:
        """Whether the hypotheses of ``proofs/fold.md`` hold: F'' > 0, dF/db > 0, F > 0 at both ends."""
        if not self.radius:
            return False
        return (
            self.sign(lower, lower) == 1
            and self.sign(upper, upper) == 1
            and self.sign(lower, upper, 2) == 1
            and sign_of(self._doubled(lower, upper).beta_derivative().enclosure()) == 1
        )

    def _doubled(self, lower: fmpq, upper: fmpq) -> TaylorModel:
        """A model of F on [lower, upper] over twice the range of b or more: a tiny radius would lose dF/db."""
        middle, half_width = approximate((lower + upper) / 2), approximate((upper - lower) / 2)
        reach, radius = abs(middle) + half_width, max(2 * self.radius, _LEAST_DOUBLED_RADIUS)
        bits = bits_for_box(reach, self._size, _GOAL_BITS_IN_B)
        degree = degree_for_box(reach, self._size, approximate(radius), _GOAL_BITS_IN_B)
        series = parameter_series(self.centre, radius, degree, length_for_box(reach + 1, self._size, bits), bits)
        return taylor_model(series, lower, upper, order_for_box(middle, half_width, self._size, _GOAL_BITS_IN_B))

    def changes(self, tau: fmpq, n: int) -> int | None:
        """The number v of ``proofs/tails.md`` at tau, or None."""
        # All powers of eta: with those that a box asks for, the changes stay open next to an integer.
        start, b = self._carried.values(tau), self._carried.range_of_b
        with working_bits(_BOX_BITS + 2 * n):
            ranges = [range_of(c) for c in coefficients(start, b, tau, fmpq(1), max(n + 1, 3))]
        return right_changes(ranges[: n + 1], self.centre - self.radius, self.centre + self.radius, n)
