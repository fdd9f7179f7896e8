"""Tangential motion (paper, eq. udot): the slip velocity u.

Where it is left out the friction is that of positive slip all along. Beside a mechanism that is an assumption: its u
must be above the velocity of the surface wherever there is contact. The paper's model system (eqs. modelsys1 to
modelsys5) is no part of a mechanism: "there is no variation of the tangential velocity" in it (Sec. 2.3), so u > 0 is
what it is about, and nothing is assumed.
"""

from __future__ import annotations

from flint import fmpq

from gspot_verified.functions.expressions import Expression
from gspot_verified.scenes.effects.effect import Condition, Effect, ModelStates
from gspot_verified.scenes.equations.model_terms import ModelTerms
from gspot_verified.scenes.equations.scaled_system import CONTACT, PhaseEvent
from gspot_verified.scenes.equations.terms import FLIGHT, REVERSE, SLIP, Terms, scaled

SLIP_STOPS = "slip stops"


def rates(terms: ModelTerms) -> dict[str, Expression]:
    """u' = epsilon (a + k^+ lambda) in positive slip, epsilon (a + k^- lambda) in reverse slip, epsilon a in flight."""
    return {"u": scaled(terms.epsilon, terms.tangential_acceleration)}


def slip_stops(terms: Terms) -> tuple[PhaseEvent, ...]:
    """Where u, less the velocity of the surface, comes down to 0 in contact: friction turns round, or holds."""
    return (PhaseEvent(SLIP_STOPS, terms.slip, CONTACT),) if terms.phase == SLIP else ()


POSITIVE_SLIP = "the slip velocity is positive in contact"
EFFECT = Effect(
    "tangential_motion",
    "the slip velocity stays positive: the contact never sticks",
    left_out_of=lambda motion: (
        "the slip velocity is constant and positive by definition of the model system (paper, Sec. 2.3)"
        if motion.is_model
        else None
    ),
    condition=Condition(POSITIVE_SLIP, slip_stops, of_model=False),
    model_states=ModelStates(("u",), rates, (SLIP, REVERSE, FLIGHT)),
    model_parameters={"a": fmpq(0), "k_plus": fmpq(-1)},
    sees=("u",),
)
