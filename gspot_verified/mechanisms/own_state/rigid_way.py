"""Rigid slip from a state to a place near the G-spot, in parts, with the states that it passes in each.

Proof page: ``proofs/from_own_state.md``, section 3.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb

from gspot_verified.integrator.norm_steps.chosen_step import Steps
from gspot_verified.integrator.norm_steps.norm_run import NormRun
from gspot_verified.mechanisms.approach.slip_flow import SlipFlow, SlipNumbers
from gspot_verified.numbers.evidence import inside

_PARTS = 16  # of a step: a multiple of the parts that `approach` keeps, so that its states are ends of parts
_SHARES = tuple(arb((2 * k + 1, -5), (1, -5)) for k in range(_PARTS))  # [k/16, (k + 1)/16]


@dataclass(frozen=True)
class WayPart:
    """The states that are passed, those at the end, the time that it takes, and that at the end, from the start on."""

    states: tuple[arb, ...]
    last: tuple[arb, ...]
    duration: arb
    until: arb


def rigid_way(flow: SlipFlow, start: Sequence[arb], goal: arb, max_steps: int) -> list[WayPart] | None:
    """The parts of slip from every state of the box ``start`` up to a state whose p certainly lies in ``goal``.

    None: no part ends there.
    """
    numbers, parts = SlipNumbers(flow), list[WayPart]()
    for segment in NormRun(flow.desingularised(), [*start, arb(0)], steps=Steps(max_steps), slow=False):
        *_, before = segment.states(arb(0))
        for k, share in enumerate(_SHARES, start=1):
            *last, after = segment.states(arb(k) / _PARTS)
            *states, _ = segment.states(share)
            parts.append(WayPart(tuple(states), tuple(last), after - before, after))
            p = numbers.on(last).p
            if inside(p, goal) is not None:
                return parts
            if not p > goal:
                return None
            before = after
    return None
