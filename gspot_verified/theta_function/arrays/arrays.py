"""Theta over numpy arrays of tau and beta."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any, cast

import numpy as np
from flint import arb, fmpq
from numpy.typing import ArrayLike

from gspot_verified.numbers.balls import ExactInput, bits_for_digits, exact, float_bounds
from gspot_verified.numbers.complex_numbers import ComplexInput, ExactComplex, is_complex
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.theta_function.arrays.batch import DOUBLE_DIGITS, ball_batch, float_batch
from gspot_verified.theta_function.arrays.float_balls import FloatArray, FloatBalls
from gspot_verified.theta_function.value.evaluate import evaluate
from gspot_verified.theta_function.value.routes import checked_arguments

ObjectArray = np.ndarray[Any, np.dtype[np.object_]]


def theta_array(
    tau: ExactInput | ComplexInput | np.ndarray[Any, Any],
    beta: ExactInput | np.ndarray[Any, Any],
    derivative: int = 0,
    digits: int = 15,
) -> ObjectArray:
    """Enclosures of d^k Theta/dtau^k at every entry: an object array of ``arb``.

    An array of floats, or of complex floats for tau, is taken on purpose: each entry stands for its exact binary value.
    Object arrays hold any exact input, and an ``acb`` stands where tau is complex. beta may be an array, too; the two
    are broadcast. derivative, digits and the errors are those of
    :func:`gspot_verified.theta_function.theta.theta`; the relative accuracy is 10^-digits.

    :raises TypeError: an array is masked: the mask would be lost.
    :raises ValueError: an entry is NaN, infinite, or outside the domain.

    >>> lower, upper = bounds(theta_array(np.linspace(-2.0, 2.0, 5), "1/2"))
    >>> bool((lower < upper).all())
    True
    """
    bits_for_digits(digits)
    taus, betas = _broadcast(_as_array(tau, "tau"), _as_array(beta, "beta"))
    result = np.empty(taus.size, dtype=object)
    for value, where in _by_beta(betas):
        points = taus.ravel()[where]
        enclosures: list[arb]
        if points.dtype == np.float64 and isinstance(value, fmpq):
            _check(points, value, derivative)
            if digits <= DOUBLE_DIGITS:
                middles, radii = float_batch(points, value, derivative)
                enclosures = [arb(m, r) for m, r in zip(middles.tolist(), radii.tolist(), strict=True)]
            else:
                enclosures = ball_batch(points, value, derivative, digits)
        else:
            enclosures = [evaluate(_exact_entry(entry), value, derivative, digits).value for entry in points]
        result[where] = enclosures
    return result.reshape(taus.shape)


def theta_of_floats(
    tau: ArrayLike, beta: ExactInput | Sequence[Any] | np.ndarray[Any, Any], derivative: int = 0
) -> FloatBalls:
    """d^k Theta/dtau^k at doubles, each of which stands for its exact binary value: midpoints and radii as doubles.

    The exact value lies within the radius, always; the radius is at most 10^-15 of the value, or 2^-899 where that is
    more: next to the least doubles accuracy is lost. It is infinite where Theta overflows a double. Every rounding
    error of the double arithmetic is bounded (``proofs/float_horner.md``).

    :param tau: a number, a list or an array of real numbers that doubles hold exactly. The index of a pandas Series is
        that of the result, unless ``beta`` broadcasts it to another shape.
    :param beta: one exact input, or a list or an array of them (floats: exact binary values), broadcast against
        ``tau``.
    :raises TypeError: ``tau`` has other entries than integers and floats, or an array is masked.
    :raises ValueError: an entry is NaN, infinite, outside the domain, or not a double; the shapes do not broadcast.

    >>> values = theta_of_floats([0.5, -1.25, 2], "7/3")
    >>> values.shape, bool((values.radius <= 1e-15 * abs(values.midpoint)).all())
    ((3,), True)
    """
    _without_mask(tau, "tau")
    _without_mask(beta, "beta")
    taus, betas = _broadcast(_doubles(tau), _as_array(_listed(beta), "beta"))
    points = np.ascontiguousarray(taus).reshape(-1)
    middles, radii = np.empty(0), np.empty(0)
    for value, where in _by_beta(betas):
        there = points[where]
        _check(there, value, derivative)
        if not isinstance(value, fmpq):
            raise TypeError("beta: a ball is not taken here; use theta_array")
        found = float_batch(there, value, derivative)
        if len(there) == len(points):
            middles, radii = found
            break
        if not len(middles):
            middles, radii = np.empty(taus.size), np.empty(taus.size)
        middles[where], radii[where] = found
    index = getattr(tau, "index", None) if hasattr(tau, "__array__") and np.shape(tau) == taus.shape else None
    return FloatBalls(middles.reshape(taus.shape), radii.reshape(taus.shape), index)


def _doubles(values: ArrayLike) -> FloatArray:
    """The numbers as doubles. An integer that is none of them is far above what Theta is asked at, also when rounded.

    :raises TypeError: they are neither integers nor floats.
    :raises ValueError: a float is longer than a double.
    """
    given = np.asarray(values)
    if given.dtype.kind not in "iuf":
        raise TypeError(
            f"tau: expected integers or floats, got {given.dtype}; theta takes arrays of complex and of exact numbers"
        )
    if given.dtype == np.float64:
        return given
    with np.errstate(over="ignore"):
        points = given.astype(np.float64)
    if given.dtype.kind == "f" and ((points != given) & np.isfinite(given)).any():
        raise ValueError(f"tau: an entry of {given.dtype} is not a double; theta takes it exactly")
    return points


def _broadcast(taus: np.ndarray[Any, Any], betas: np.ndarray[Any, Any]) -> tuple[np.ndarray[Any, Any], ...]:
    try:
        return tuple(np.broadcast_arrays(taus, betas))
    except ValueError:
        raise ValueError(
            f"tau has the shape {taus.shape}, beta {betas.shape}: they do not broadcast; tau[:, None] takes all pairs"
        ) from None


def _listed(values: Any) -> Any:
    """A list, a tuple or a table of pandas as an array; texts and fractions in it stay what they are."""
    if isinstance(values, np.ndarray) or not (isinstance(values, list | tuple) or hasattr(values, "__array__")):
        return values
    given = np.asarray(values)
    return given if given.dtype.kind in "iuf" else np.asarray(values, dtype=object)


def _as_array(value: ExactInput | ComplexInput | np.ndarray[Any, Any], name: str) -> np.ndarray[Any, Any]:
    if isinstance(value, np.ndarray):
        _without_mask(value, name)
        return value
    single = np.empty((), dtype=object)
    single[()] = value if name == "tau" and is_complex(value) else exact(cast("ExactInput", value), name)
    return single


def _without_mask(value: object, name: str) -> None:
    """Passes for anything but a masked array, or a list that holds one.

    :raises TypeError: it is one.
    """
    if isinstance(value, list | tuple):
        for each in value:
            if isinstance(each, np.ma.MaskedArray | list | tuple):
                _without_mask(each, name)
    if isinstance(value, np.ma.MaskedArray):
        raise TypeError(f"{name}: a masked array is not taken, its mask would be lost: pass .compressed() or .filled()")


def _by_beta(betas: np.ndarray[Any, Any]) -> Iterator[tuple[Any, Any]]:
    """Each beta as an exact value, and where it stands in the flat array."""
    if betas.size == 0:
        return
    if not any(betas.strides):  # one value, broadcast
        yield exact(_exact_entry(betas.flat[0], "beta"), "beta"), slice(None)
        return
    flat = betas.ravel()
    if flat.dtype == np.float64:
        entries, places = np.unique(flat, return_inverse=True)
        order = np.argsort(places, kind="stable")
        groups = np.split(order, np.flatnonzero(np.diff(places[order])) + 1)
        for entry, group in zip(entries, groups, strict=True):
            yield exact(_exact_entry(entry, "beta"), "beta"), group
        return
    indices: dict[Any, list[int]] = {}
    for index, entry in enumerate(flat):
        if isinstance(entry, arb):  # no hash unless it is exact
            entry = Dyadic.from_ball(entry) if entry.is_finite() else ("not finite", index)
        indices.setdefault(entry, []).append(index)
    for where in indices.values():
        yield exact(_exact_entry(flat[where[0]], "beta"), "beta"), np.array(where)


def _check(points: FloatArray, beta: Any, derivative: int) -> None:
    """The errors of one evaluation, for all points at once."""
    low, high = float(points.min(initial=0.0)), float(points.max(initial=0.0))  # NaN where an entry is
    if not (math.isfinite(low) and math.isfinite(high)):
        raise ValueError(f"tau: every entry must be finite, got {points[np.logical_not(np.isfinite(points))][0]}")
    farthest = max(-low, high)
    checked_arguments(fmpq(*farthest.as_integer_ratio()), beta, derivative)


def bounds(values: ObjectArray) -> tuple[FloatArray, FloatArray]:
    """Two float arrays (lower, upper) that enclose an array of balls, rounded outward."""
    lower = np.empty(values.shape)
    upper = np.empty(values.shape)
    for index, value in np.ndenumerate(values):
        lower[index], upper[index] = float_bounds(value)
    return lower, upper


def _exact_entry(value: Any, name: str = "tau") -> Any:
    if isinstance(value, np.floating):
        if not np.isfinite(value):
            raise ValueError(f"{name}: every entry must be finite, got {value}")
        return fmpq(*value.as_integer_ratio())  # exact for every width, longdouble included
    if isinstance(value, np.integer):
        return int(value)
    if isinstance(value, np.complexfloating) and name == "tau":
        return ExactComplex(_exact_entry(value.real), _exact_entry(value.imag))
    return value
