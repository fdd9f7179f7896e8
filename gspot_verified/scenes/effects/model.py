"""What moves in the model scenes (paper, eqs. modelsys1, modelsys2): b, with constant alphas; never left out."""

from __future__ import annotations

from flint import fmpq

from gspot_verified.functions.derivative import plus
from gspot_verified.functions.expressions import Expression
from gspot_verified.scenes.effects.effect import ModelStates
from gspot_verified.scenes.equations.model_terms import ModelTerms
from gspot_verified.scenes.equations.terms import number, scaled


def rates(terms: ModelTerms) -> dict[str, Expression]:
    """b' = epsilon (alpha_2 - alpha_3 lambda^+), alpha_3 = beta alpha_1."""
    pull = -terms.epsilon * terms["beta"] * terms["alpha_1"]
    return {"b": plus(number(terms.epsilon * terms["alpha_2"]), scaled(pull, terms.forward))}


MODEL = ModelStates(("b",), rates)
PARAMETERS = {"alpha_1": fmpq(-1), "alpha_2": fmpq(-1), "beta": fmpq(3, 2)}
