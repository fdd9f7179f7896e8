"""The usual formulas in double precision: what numpy and scipy give. Nothing here is certified."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

_MOST_TERMS = 4_000  # a limit, as a user would set one
_GRID = 4_001  # points at which signs are compared


def theta_series(beta: float) -> list[float]:
    """Theta(0), Theta'(0), Theta''(0)/2 as printed (eqs. t01 to t03), by scipy's Gamma; NaN at its poles."""
    from scipy.special import gamma

    with np.errstate(all="ignore"):
        outer = gamma(-beta)
        values = [float(gamma((j - beta) / 3) / (outer * 3.0 ** ((3 - j + beta) / 3))) for j in range(3)]
    return [values[0], values[1], values[2] / 2]


def theta_double(tau: float, beta: float) -> float:
    """Theta by its power series at 0 in double precision, until the terms no longer count."""
    terms = [value * tau**j for j, value in enumerate(theta_series(beta))]
    total, cube = math.fsum(terms), tau * tau * tau
    for k in range(_MOST_TERMS):
        terms.append(terms[k] * (k - beta) * cube / ((k + 1.0) * (k + 2) * (k + 3)))
        total += terms[-1]
        if not math.isfinite(total) or (k > 3 and max(map(abs, terms[-3:])) <= abs(total) * 1e-18):
            break
    return total


def sign_changes(function: Callable[[float], float], first: float, last: float, points: int = _GRID) -> int:
    """How often the values on a uniform grid change their sign; zeros and NaN are passed over."""
    values = np.array([function(point) for point in np.linspace(first, last, points)])
    with np.errstate(invalid="ignore"):
        signs = np.sign(values)
    signs = signs[(signs == 1) | (signs == -1)]
    return int(np.count_nonzero(signs[1:] != signs[:-1]))


def double_text(value: float | None) -> str:
    """A double for a table.

    >>> double_text(0.1), double_text(float("nan")), double_text(None), double_text(3.0)
    ('0.1', 'nan', 'no answer', '3')
    """
    if value is None:
        return "no answer"
    return f"{value:.10g}"


def real_roots(coefficients: Any) -> int:
    """How many of numpy's roots of a polynomial have no imaginary part."""
    return int(np.count_nonzero(np.roots(coefficients).imag == 0))
