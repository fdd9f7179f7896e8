"""Two-way coupling (paper, eq. newex1): p' = alpha_1 + chi b, so that p is no longer known in advance."""

from __future__ import annotations

from flint import fmpq

from gspot_verified.functions.derivative import plus
from gspot_verified.functions.expressions import Expression
from gspot_verified.scenes.effects.effect import Effect, ModelStates
from gspot_verified.scenes.equations.model_terms import ModelTerms
from gspot_verified.scenes.equations.terms import number, scaled


def rates(terms: ModelTerms) -> dict[str, Expression]:
    """p' = epsilon (alpha_1 + chi b)."""
    drift = number(terms.epsilon * terms["alpha_1"])
    return {"p": plus(drift, scaled(terms.epsilon * terms["chi"], terms.state("b")))}


EFFECT = Effect(
    "two_way_coupling",
    "the normal motion does not act back: p = p_0 + alpha_1 t is known and not integrated (paper, eq. modelsys1)",
    model_states=ModelStates(("p",), rates),
    model_parameters={"chi": fmpq(1)},
    not_with_mechanism="chi belongs to the model system; the equations of a mechanism say how p moves",
)
