"""How much of a start's fast oscillation is left at the G-spot: a float, not a bound.

At a fixed p > 0 the contact's fast motion is e^(rT), T = t/epsilon, with the roots of

    c r^3 + (k_1 + k_2) r^2 + k_2 c p r + k_1 k_2 p = 0:

from Y'' = p lambda, c Z' = -k_1 Z - lambda, lambda = k_2 (Z - Y) with Y = e^(rT). All of them decay; the slowest is a
pair with Re r = -c k_2^2 p/(2 (k_1 + k_2)^2) + O(p^2), -p/8 with the paper's k_1 = k_2 = c = 1. While p falls to 0 it
loses the factor e^(-E/epsilon), up to powers of epsilon, E being the integral of |Re r| over t. With a constant
alpha_1 and a small p that is c k_2^2 |alpha_1| t^2/(4 (k_1 + k_2)^2), |alpha_1| t^2/16 in the paper's case.
"""

from __future__ import annotations

from collections.abc import Sequence

from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.numbers.balls import approximate

_LEAST_STEP = 1e-9  # of the whole time


def decay_rate(p: float, regularisation: Regularisation) -> float:
    """-Re r of the root that decays slowest, for p >= 0.

    >>> from gspot_verified.expansion.series.regularisation import PAPER
    >>> round(decay_rate(0.001, PAPER) / 0.001, 4)
    0.125
    """
    import numpy as np

    k_1, k_2, c = (approximate(value) for value in (regularisation.k_1, regularisation.k_2, regularisation.c))
    roots = np.roots([c, k_1 + k_2, k_2 * c * p, k_1 * k_2 * p])
    return float(-np.max(roots.real))


def surviving_exponent(times: Sequence[float], p: Sequence[float], regularisation: Regularisation) -> float:
    """E, from p at three or more times down to about 0; the trapezoidal rule with its first correction.

    >>> from gspot_verified.expansion.series.regularisation import PAPER
    >>> round(surviving_exponent([k / 100 for k in range(51)], [0.5 - k / 100 for k in range(51)], PAPER), 5)
    0.01559
    """
    import numpy as np

    t = np.asarray(times, dtype=float)
    apart = np.concatenate([[True], np.diff(t) > _LEAST_STEP * t[-1]])  # near the G-spot times may be equal as floats
    t = t[apart]
    rates = np.array([decay_rate(max(value, 0.0), regularisation) for value in np.asarray(p, dtype=float)[apart]])
    slopes = np.gradient(rates, t, edge_order=2)
    steps = np.diff(t)
    parts = steps * (rates[:-1] + rates[1:]) / 2 + steps**2 * (slopes[:-1] - slopes[1:]) / 12
    return float(parts.sum())
