"""Lift-off and touch-down: the contact opens where lambda_N falls through 0 and closes where y = z again."""

from __future__ import annotations

from flint import fmpq

from gspot_verified.scenes.effects.effect import Condition, Effect
from gspot_verified.scenes.equations.scaled_system import CONTACT, PhaseEvent
from gspot_verified.scenes.equations.terms import FLIGHT, Terms, scaled

LIFT_OFF, TOUCH_DOWN = "lift-off", "touch-down"


def events(terms: Terms) -> tuple[PhaseEvent, ...]:
    """Lift-off in contact, touch-down in flight. After it the contact sticks or slips as u says."""
    if terms.phase == FLIGHT:
        return (PhaseEvent(TOUCH_DOWN, scaled(fmpq(-1), terms.closing), CONTACT),)
    return (PhaseEvent(LIFT_OFF, terms.closing, FLIGHT),)


EFFECT = Effect(
    "lift_off",
    "the contact is never lost: the surface may pull",
    condition=Condition("λ_N is positive in contact", events),
    events=events,
    needs=("compliant_contact",),
    opens=(FLIGHT,),
)
