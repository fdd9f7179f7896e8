"""Theta over a numpy array of tau, for pictures."""

from __future__ import annotations

from typing import Any

import numpy as np
from flint import fmpq

from gspot_verified.balls import ExactInput, float_bounds
from gspot_verified.theta_function.evaluate import evaluate

ObjectArray = np.ndarray[Any, np.dtype[np.object_]]
FloatArray = np.ndarray[Any, np.dtype[np.float64]]


def theta_array(tau: np.ndarray[Any, Any], beta: ExactInput, derivative: int = 0, digits: int = 15) -> ObjectArray:
    """Enclosures of d^k Theta/dtau^k at every entry of ``tau``: an object array of ``arb``, of the same shape.

    An array of floats is taken on purpose: each entry stands for its exact binary value. Object arrays hold any exact
    input. beta, derivative, digits and the errors are those of :func:`gspot_verified.theta_function.theta.theta`.

    :raises ValueError: an entry is NaN, infinite, or outside the domain.

    >>> lower, upper = bounds(theta_array(np.linspace(-2.0, 2.0, 5), "1/2"))
    >>> bool((lower < upper).all())
    True
    """
    result = np.empty(tau.shape, dtype=object)
    for index, value in np.ndenumerate(tau):
        result[index] = evaluate(_exact_entry(value), beta, derivative, digits).value
    return result


def bounds(values: ObjectArray) -> tuple[FloatArray, FloatArray]:
    """Two float arrays (lower, upper) that enclose an array of balls, rounded outward."""
    lower = np.empty(values.shape)
    upper = np.empty(values.shape)
    for index, value in np.ndenumerate(values):
        lower[index], upper[index] = float_bounds(value)
    return lower, upper


def _exact_entry(value: Any) -> Any:
    if isinstance(value, np.floating):
        if not np.isfinite(value):
            raise ValueError(f"tau: every entry must be finite, got {value}")
        return fmpq(*value.as_integer_ratio())  # exact for every width, longdouble included
    if isinstance(value, np.integer):
        return int(value)
    return value
