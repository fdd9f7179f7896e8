"""A state with given p, b, y, v by Newton's method. A heuristic: any state is right, it proves nothing."""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb, arb_mat

from gspot_verified.functions.box_program import BoxProgram

_STEPS = 12  # a limit of effort


def state_near(program: BoxProgram, start: Sequence[arb], goal: Sequence[arb]) -> list[arb] | None:
    """From the middles of ``start`` towards those of ``goal``; exact. None: it got lost."""
    state = [value.mid() for value in start]
    for _ in range(_STEPS):
        values, rows = program.gradients(state)
        gap = arb_mat([[(value - wanted).mid()] for value, wanted in zip(values, goal, strict=True)])
        try:
            step = arb_mat([[entry.mid() for entry in row] for row in rows]).solve(gap)
        except ZeroDivisionError:
            return None
        state = [(value - step[i, 0]).mid() for i, value in enumerate(state)]
    return state if all(value.is_finite() for value in state) else None
