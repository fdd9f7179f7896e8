"""The place x of the contact point along the surface (paper, eq. xdot)."""

from __future__ import annotations

from gspot_verified.expansion.expressions import Expression
from gspot_verified.scenes.effects.effect import Effect, ModelStates
from gspot_verified.scenes.effects.model_terms import ModelTerms
from gspot_verified.scenes.effects.terms import scaled


def rates(terms: ModelTerms) -> dict[str, Expression]:
    """x' = epsilon u."""
    return {"x": scaled(terms.epsilon, terms.u)}


EFFECT = Effect(
    "tangential_place",
    "nothing depends on where along the surface the contact is: x is cyclic",
    model_states=ModelStates(("x",), rates),
    sees=("x",),
    needs=("tangential_motion",),
)
