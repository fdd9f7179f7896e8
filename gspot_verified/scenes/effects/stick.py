"""Stick and slip (paper, eqs. lambda+ to newex6): slip ends where the slip velocity vanishes; then the contact sticks
where friction can hold it, and slips the other way where it cannot."""

from __future__ import annotations

from flint import fmpq

from gspot_verified.scenes.effects.effect import Condition, Effect
from gspot_verified.scenes.effects.tangential_motion import POSITIVE_SLIP, SLIP_STOPS, slip_stops
from gspot_verified.scenes.equations.scaled_system import CONTACT, PhaseEvent
from gspot_verified.scenes.equations.terms import REVERSE, SLIP, STICK, Terms, scaled

STICKS = "stick"
SLIPS = {SLIP: "slip forwards", REVERSE: "slip backwards"}


def events(terms: Terms) -> tuple[PhaseEvent, ...]:
    """u = 0 in slip (or the velocity of the belt); in stick, the force of friction reaches its bound.

    Where friction holds the contact for every lambda_N > 0 (paper: a = 0, k^+ < 0 < k^-) stick follows for certain.
    """
    if terms.phase == STICK:
        return tuple(PhaseEvent(SLIPS[phase], function, phase) for phase, function in terms.stick_ends)
    if terms.phase not in (SLIP, REVERSE):
        return ()
    slip = terms.slip if terms.phase == SLIP else scaled(fmpq(-1), terms.slip)
    return (PhaseEvent(SLIP_STOPS, slip, CONTACT) if terms.stick_ends else PhaseEvent(STICKS, slip, STICK),)


EFFECT = Effect(
    "stick",
    "slip goes on in the same direction where the slip velocity passes through 0",
    condition=Condition(POSITIVE_SLIP, slip_stops),
    model_parameters={"k_minus": fmpq(2), "p_minus": fmpq(1)},
    events=events,
    needs=("tangential_motion",),
    opens=(STICK, REVERSE),
)
