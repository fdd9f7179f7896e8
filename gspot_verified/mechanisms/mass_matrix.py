"""The mass matrix is positive definite at the G-spot: its leading minors; or A, C, A C - B^2 where none is given.

The friction coefficient must not be negative there.

Paper, Sec. 1.1: A > 0, C > 0, A C - B^2 > 0 follow from a positive definite mass matrix.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from gspot_verified.balls import ball_text
from gspot_verified.expansion.power_series import SeriesOfFunctions
from gspot_verified.expansion.rings import BALLS, Ring
from gspot_verified.expansion.terms import NumberTerms
from gspot_verified.mechanisms.lie_derivatives import minor
from gspot_verified.mechanisms.mechanism import MechanismError
from gspot_verified.mechanisms.to_system import Shifted


def check_mass_matrix(shifted: Shifted, values: Mapping[str, Any], ring: Ring) -> None:
    """Checks that the leading minors are certainly positive at the point and the friction coefficient is not negative.

    :raises MechanismError: one is not, or not certainly.

    >>> from gspot_verified.mechanisms.classify import classify
    >>> from gspot_verified.mechanisms.shipped import shipped_mechanism
    >>> classify(shipped_mechanism("falling rod", m=-1))
    Traceback (most recent call last):
    ...
    gspot_verified.mechanisms.mechanism.MechanismError: falling rod: the mass matrix is not positive definite at the \
G-spot: its leading minor of size 1 is -1
    """
    name = shifted.mechanism.name
    f = shifted.functions
    if f.mass_matrix is not None:
        sizes = range(1, len(f.mass_matrix) + 1)
        functions = [minor(f.mass_matrix, range(k), range(k)) for k in sizes]
        messages = [
            f"{name}: the mass matrix is not positive definite at the G-spot: its leading minor of size {k} is"
            for k in sizes
        ]
    else:
        functions = [f.A, f.C, f.A * f.C - f.B**2]
        messages = [
            f"{name}: no mass matrix gives these fields: at the G-spot {what} must be positive, it is"
            for what in ("A = L_GT u", "C = L_GN v", "A C - B^2")
        ]
    expressions = shifted.expressions([*functions, f.mu], ring)
    series = SeriesOfFunctions(expressions, NumberTerms(ring), ring)
    series.extend([values[word] for word in shifted.mechanism.state])
    for expression, message in zip(expressions[:-1], messages, strict=True):
        value = series[expression][0]
        if not value > 0:
            raise MechanismError(f"{message} {ball_text(value) if ring is BALLS else value}")
    friction = series[expressions[-1]][0]
    if not friction >= 0:
        shown = ball_text(friction) if ring is BALLS else friction
        raise MechanismError(f"{name}: the friction coefficient mu must not be negative at the G-spot, it is {shown}")
