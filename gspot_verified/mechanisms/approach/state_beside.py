"""A state of slip next to a G-spot: Newton's method without any bound. It proves nothing; any start is as good."""

from __future__ import annotations

from flint import arb, arb_mat

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.mechanisms.spots.g_spot import GSpot
from gspot_verified.numbers.balls import ball

_STEPS = 30  # of Newton's method: a limit of effort
_SMALL = 1e-15  # of what is left in the conditions


def state_beside(spot: GSpot, p: arb, b: arb) -> list[arb] | None:
    """A state next to the G-spot with these p and b, on the surface, J = 0; None: not found."""
    system = spot.system
    program = BoxProgram(system.conditions, len(system.point))
    state = [ball(value).mid() for value in system.point]
    goal = [p, b, *[arb(0)] * (len(state) - 2)]
    for _ in range(_STEPS):
        values, rows = program.gradients(state)
        gap = [(value - wanted).mid() for value, wanted in zip(values, goal, strict=True)]
        if all(abs(entry) < _SMALL for entry in gap):
            return state
        try:
            step = arb_mat([[entry.mid() for entry in row] for row in rows]).solve(arb_mat([[g] for g in gap]))
        except ZeroDivisionError:
            return None
        state = [(value - step[i, 0]).mid() for i, value in enumerate(state)]
        if not all(value.is_finite() for value in state):
            return None
    return None
