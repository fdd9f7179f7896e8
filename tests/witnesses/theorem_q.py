"""Theorem Q of proofs/from_state.md: the side of C_1 > 0 in Case III with m = 4 by enclosures of the model system.

A second way beside Theorem R (proofs/papers_rule.md), which uses the asymptotics of Theta. What is proved does not
depend on the p_1, delta and the force that the model system's checks are made with.
"""

from __future__ import annotations

from flint import fmpq

from gspot_verified.expansion.from_state.limit_side import OTHER
from gspot_verified.expansion.from_state.passage import ModelStart, checked_ratio, passage, trajectory_of
from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.expansion.true_solutions.bound import BITS, rational
from gspot_verified.expansion.true_solutions.equations import Residuals
from gspot_verified.numbers.balls import ball, working_bits

DELTAS = tuple(fmpq(1, 10**n) for n in (3, 5, 8))
_PLACE = fmpq(1, 100)
_FORCE = fmpq(10)


def side_by_enclosures(
    beta: str, contact: tuple[int | str, int | str, int | str] = (1, 1, 1), deltas: tuple[fmpq, ...] = DELTAS
) -> str:
    """ "lift-off" or "impact" for C_1 > 0; else why it is undecided."""
    number, springs = checked_ratio(rational(beta, "beta")), Regularisation.of(*contact)
    start = ModelStart(number, fmpq(-1), fmpq(-1), springs, _PLACE, -2 * _PLACE / (number - 1), fmpq(0))  # C_1 < 0
    found: object = "no delta"
    with working_bits(BITS):
        trajectory = trajectory_of(start)
        for delta in deltas:
            found = passage(start, Residuals(trajectory, delta), fmpq(0), delta, _FORCE)
            if isinstance(found, str):
                continue
            layer = found.tube.layer(ball(found.tube.rectangle.h))
            if found.tube.rate < fmpq(3 * found.plan.order, 2) and layer > 0:
                return OTHER["lift-off" if found.end.side < 0 else "impact"]
            found = "the order of the slow series is too low"
    return str(found)
