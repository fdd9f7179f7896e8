"""The contact equations of the model in its normal form, carried by power series in mpmath: no formula is shared with
the package's integrals."""

from __future__ import annotations

from collections.abc import Sequence

import mpmath


def moved(
    hats: Sequence[mpmath.mpf],
    p: mpmath.mpf,
    beta: mpmath.mpf,
    epsilon: mpmath.mpf,
    duration: mpmath.mpf,
    steps: int = 40,
) -> tuple[list[mpmath.mpf], mpmath.mpf]:
    """(b, V, Y, Z) and p after the time ``duration`` in T: b' = eps beta (Z - Y), V' = b + p (Z - Y), Y' = V,
    Z' = -Z - (Z - Y), p' = -eps."""
    values = list(hats)
    step = duration / steps
    for _ in range(steps):
        values, p = _series_step(values, p, beta, epsilon, step)
    return values, p


def _series_step(values, p, beta, epsilon, step, order=40):
    b, V, Y, Z = ([value] for value in values)
    for n in range(order):
        force = [z - y for z, y in zip(Z, Y, strict=True)]
        previous = force[n - 1] if n else mpmath.mpf(0)
        following = (
            epsilon * beta * force[n],
            b[n] + p * force[n] - epsilon * previous,
            V[n],
            -Z[n] - force[n],
        )
        for series, value in zip((b, V, Y, Z), following, strict=True):
            series.append(value / (n + 1))
    return [mpmath.polyval(series[::-1], step) for series in (b, V, Y, Z)], p - epsilon * step
