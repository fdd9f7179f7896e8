"""Stick and slip (paper, eqs. lambda+ to newex6): slip ends at u = 0; then c = k^-/(k^- - k^+), 2/3 in the paper."""

from __future__ import annotations

from flint import fmpq

from gspot_verified.scenes.effects.effect import Effect
from gspot_verified.scenes.effects.terms import SLIP, STICK, Terms
from gspot_verified.scenes.scaled_system import PhaseEvent

STICKS = "stick"


def events(terms: Terms) -> tuple[PhaseEvent, ...]:
    """u = 0 in slip. With a = 0 and k^+ < 0 < k^-, c lies in (0, 1) for every force: stick lasts as contact does."""
    return (PhaseEvent(STICKS, terms.state("u"), STICK),) if terms.phase == SLIP else ()


EFFECT = Effect(
    "stick",
    "slip goes on in the same direction where u passes through 0",
    parameters={"k_minus": fmpq(2)},
    events=events,
    needs=("tangential_motion",),
    opens=(STICK,),
)
