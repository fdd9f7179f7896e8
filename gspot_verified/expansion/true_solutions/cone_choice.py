"""Candidates for the cone of growing deviations. Heuristic: any cone that ``growth.py`` accepts is right."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from flint import arb

from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.expansion.true_solutions.growth import (
    DeviationCone,
    EntryDeviation,
    needed_p,
    needed_state,
    phi_of,
    ranges_of,
)
from gspot_verified.numbers.balls import Exact, approximate, ball

_RATES = (0.95, 0.85, 0.75, 0.65, 0.55, 0.45, 0.35)
_GAPS = (1.1, 1.2, 1.35)
_ROUNDS = 3  # in which the constants of a cone are adjusted to each other


def cones(equations: DeviationEquations, entry: EntryDeviation, power: Exact, top: arb) -> Iterator[DeviationCone]:
    """Cones that hold the deviation at s_1, the fastest growth first."""
    if not (entry.Y > 0 and entry.V > 0 and entry.N > 0 and entry.q > 0):
        return
    slowest = approximate((entry.V.lower() / entry.Y.upper()).lower())
    steepest = 1.05 * approximate((entry.V / entry.Y).upper())
    low, high = 0.98 * approximate((entry.N / entry.V).lower()), 1.05 * approximate((entry.N / entry.V).upper())
    for part in _RATES:
        for gap in _GAPS:
            a = part * slowest
            if a > 0 and gap * a <= low:
                start = DeviationCone(arb(a), arb(gap * a), arb(steepest), arb(high), (), arb(0), top)
                cone = _filled(equations, entry, power, start)
                if cone is not None:
                    yield cone


def _filled(
    equations: DeviationEquations, entry: EntryDeviation, power: Exact, cone: DeviationCone
) -> DeviationCone | None:
    """The cone with A, A_p, B, C for its a and c."""
    least = entry.Y.lower()
    starts = [1.1 * approximate(value / least) + 1e-20 for value in entry.state]
    start_p = 1.1 * approximate(entry.p / least) + 1e-20
    steepest, high = cone.B, cone.C
    cone = replace(cone, A=tuple(map(arb, starts)), A_p=arb(start_p))
    for _ in range(_ROUNDS):
        ranges = ranges_of(equations, entry, power, cone)
        if ranges is None:
            return None
        phi = phi_of(equations, entry, ranges)
        needed = [1.15 * approximate(value) for value in needed_state(equations, ranges, cone, phi)]
        q_last = approximate(entry.q) + approximate(ranges.alpha_1.abs_upper()) * approximate(
            ranges.last - ball(entry.place)
        )
        largest = 1.15 * math.sqrt(max(approximate(equations.kappa) * q_last, 0.0))
        C = high.max(arb(largest))
        cone = replace(
            cone,
            A=tuple(arb(max(pair)) for pair in zip(starts, needed, strict=True)),
            A_p=arb(max(start_p, 1.15 * approximate(needed_p(equations, ranges, cone)))),
            C=C,
            B=steepest.max(arb(1.15 * approximate(C))),
        )
    return cone
