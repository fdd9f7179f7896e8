"""Balls whose midpoint and radius are doubles, one or an array of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
from flint import arb

from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import NoTruthValue

FloatArray = np.ndarray[Any, np.dtype[np.float64]]

_SMALLEST = 2.0**-900  # a midpoint above it has no rounding error: far above 2^-1022


@dataclass(frozen=True, slots=True, eq=False)
class FloatBalls(NoTruthValue):
    """Two arrays of doubles of one shape: every exact value lies within ``radius`` of ``midpoint``, always.

    A radius is infinite where doubles cannot hold the value. ``len`` and ``[]`` are those of an array; a slice, a list
    or a mask of rows takes their part of ``index`` along.

    >>> balls = FloatBalls(np.array([1.0, 2.0, 3.0]), np.array([0.0, 0.5, 0.25]))
    >>> len(balls), balls.shape, balls[1:].radius.tolist(), float(balls[1].midpoint)
    (3, (3,), [0.5, 0.25], 2.0)
    """

    ask: ClassVar[str] = ".lower and .upper enclose the values, .radius says how closely"

    midpoint: FloatArray
    radius: FloatArray
    index: Any = None
    """Of the pandas Series or frame that the values belong to, one entry a row; else None."""

    def __len__(self) -> int:
        return len(self.midpoint)

    def __getitem__(self, key: Any) -> FloatBalls:
        rows = isinstance(key, slice) or (isinstance(key, list | np.ndarray) and np.ndim(key) == 1)
        kept = self.index[key] if rows and self.index is not None else None
        return FloatBalls(np.asarray(self.midpoint[key]), np.asarray(self.radius[key]), kept)

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of both arrays."""
        return tuple(self.midpoint.shape)

    def to_numpy(self) -> FloatArray:
        """One array with a further, last axis: ``lower`` and ``upper``, which enclose the exact value."""
        return np.stack([self.lower, self.upper], axis=-1)

    @property
    def lower(self) -> FloatArray:
        """Doubles below the exact values."""
        return np.nextafter(self.midpoint - self.radius, -np.inf)

    @property
    def upper(self) -> FloatArray:
        """Doubles above the exact values."""
        return np.nextafter(self.midpoint + self.radius, np.inf)


def float_balls(values: list[arb]) -> tuple[FloatArray, FloatArray]:
    """Midpoints and radii that enclose the balls, rounded outward; a radius is infinite where doubles overflow.

    >>> middle, radius = float_balls([arb(3)])
    >>> float(middle[0]), float(radius[0])
    (3.0, 0.0)
    """
    with working_bits(53):
        rounded = [+value for value in values]
    middle = np.array([float(value) for value in rounded], dtype=np.float64)
    radius = np.array([float(value.rad()) for value in rounded], dtype=np.float64)
    # A midpoint of 53 bits is the double, unless it is so small that it was rounded.
    outward = np.nextafter(np.where(np.abs(middle) > _SMALLEST, radius, radius + _SMALLEST), np.inf)
    for index in np.flatnonzero((radius == 0) | np.logical_not(np.isfinite(middle))).tolist():
        if not (rounded[index].is_finite() and np.isfinite(middle[index])):
            middle[index], outward[index] = 0.0, np.inf
        elif rounded[index].is_exact() and (abs(middle[index]) > _SMALLEST or rounded[index].is_zero()):
            outward[index] = 0.0
    return middle, outward
