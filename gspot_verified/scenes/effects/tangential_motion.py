"""Tangential motion (paper, eq. udot): the slip velocity u."""

from __future__ import annotations

from flint import fmpq

from gspot_verified.expansion.expressions import Expression
from gspot_verified.scenes.effects.effect import Effect, ModelStates
from gspot_verified.scenes.effects.model_terms import ModelTerms
from gspot_verified.scenes.effects.terms import FLIGHT, REVERSE, SLIP, scaled


def rates(terms: ModelTerms) -> dict[str, Expression]:
    """u' = epsilon (a + k^+ lambda) in positive slip, epsilon (a + k^- lambda) in reverse slip, epsilon a in flight."""
    return {"u": scaled(terms.epsilon, terms.tangential_acceleration)}


EFFECT = Effect(
    "tangential_motion",
    "the slip velocity stays positive: the contact never sticks",
    model_states=ModelStates(("u",), rates, (SLIP, REVERSE, FLIGHT)),
    model_parameters={"a": fmpq(0), "k_plus": fmpq(-1)},
    sees=("u",),
)
