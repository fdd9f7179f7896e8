"""The mass matrix is positive definite at the G-spot: its leading minors; or A, C, A C - B^2 where none is given.

The friction coefficient must not be negative there.

Proof page: ``proofs/mechanism_hypotheses.md``.

Paper, Sec. 1.1: A > 0, C > 0, A C - B^2 > 0 follow from a positive definite mass matrix.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from gspot_verified.expansion.series.terms import NumberTerms
from gspot_verified.functions.power_series import SeriesOfFunctions
from gspot_verified.functions.rings import BALLS, Ring
from gspot_verified.mechanisms.derive.to_system import Shifted
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.numbers.balls import ball_text
from gspot_verified.numbers.evidence import at_most, every, less
from gspot_verified.numbers.verdict import Evidence


def check_mass_matrix(
    shifted: Shifted, values: Mapping[str, Any], ring: Ring, where: str = "at the G-spot"
) -> Evidence | None:
    """That the leading minors are certainly positive at the point and the friction coefficient is not negative.

    :raises MechanismError: one is not, or not certainly.

    >>> from gspot_verified.mechanisms.spots.classify import classify
    >>> from gspot_verified.mechanisms.shipped import shipped_mechanism
    >>> classify(shipped_mechanism("falling rod", m=-1))
    Traceback (most recent call last):
    ...
    gspot_verified.mechanisms.input.mechanism.MechanismError: falling rod: the mass matrix is not positive definite \
at the G-spot: its leading minor of size 1 is -1
    """
    name = shifted.mechanism.name
    f = shifted.functions
    rows = f.inertia
    expressions = shifted.expressions([*(entry for row in rows for entry in row), f.mu], ring)
    series = SeriesOfFunctions(expressions, NumberTerms(ring), ring)
    try:
        series.extend([values[word] for word in shifted.mechanism.state])
    except ValueError as error:
        if ring is not BALLS:
            raise
        raise MechanismError(f"{name}: what gives inertia and friction has no value {where}: {error}") from None
    numbers = [series[expression][0] for expression in expressions]
    *entries, friction = numbers
    matrix = [entries[i * len(rows) : (i + 1) * len(rows)] for i in range(len(rows))]
    shown: list[Evidence | None] = []
    if f.mass_matrix is None:
        shown.append(_positive(f"{name}: no mass matrix gives these fields: {where} A = L_GT u must be positive, it is",
                        matrix[0][0], ring))  # fmt: skip
        shown.append(_positive(f"{name}: no mass matrix gives these fields: {where} C = L_GN v must be positive, it is",
                        matrix[1][1], ring))  # fmt: skip
    for size, value in enumerate(leading_minors(matrix), start=1):
        what = (
            f"{name}: no mass matrix gives these fields: {where} A C - B^2 must be positive, it is"
            if f.mass_matrix is None
            else f"{name}: the mass matrix is not positive definite {where}: its leading minor of size {size} is"
        )
        shown.append(_positive(what, value, ring))
    pushes = at_most(0, friction)
    if pushes is None:
        text = ball_text(friction) if ring is BALLS else friction
        raise MechanismError(f"{name}: the friction coefficient mu must not be negative {where}, it is {text}")
    return every([*shown, pushes])


def _positive(message: str, value: Any, ring: Ring) -> Evidence:
    shown = less(0, value)
    if shown is None:
        raise MechanismError(f"{message} {ball_text(value) if ring is BALLS else value}")
    return shown


def positive_definite(entries: Sequence[Any]) -> Evidence | None:
    """That a symmetric matrix with these entries, row by row, is: its leading minors are certainly positive.

    >>> from flint import fmpq
    >>> positive_definite([fmpq(2), fmpq(1), fmpq(1), fmpq(1)]) is None
    False
    >>> positive_definite([fmpq(2), fmpq(2), fmpq(2), fmpq(1)]) is None
    True
    """
    size = math.isqrt(len(entries))
    return every(less(0, minor) for minor in leading_minors([entries[i : i + size] for i in range(0, size**2, size)]))


def leading_minors(matrix: Sequence[Sequence[Any]]) -> Iterator[Any]:
    """The leading minors one after the other, by elimination; none may vanish but the last one asked for.

    >>> from flint import fmpq
    >>> list(leading_minors([[fmpq(2), fmpq(0)], [fmpq(0), fmpq(3)]]))
    [2, 6]
    """
    rows = [list(row) for row in matrix]
    minor: Any = None
    for k, own in enumerate(rows):
        minor = minor * own[k] if k else own[k]
        yield minor
        for row in rows[k + 1 :]:
            factor = row[k] / own[k]
            row[k + 1 :] = [value - factor * other for value, other in zip(row[k + 1 :], own[k + 1 :], strict=True)]
