"""The mechanism of the model scenes (paper, eqs. modelsys1, modelsys2): b, with constant alphas. In every scene."""

from __future__ import annotations

from flint import fmpq

from gspot_verified.expansion.derivative import plus
from gspot_verified.expansion.expressions import Expression
from gspot_verified.scenes.effects.effect import Effect
from gspot_verified.scenes.effects.terms import Terms, number, scaled


def rates(terms: Terms) -> dict[str, Expression]:
    """b' = epsilon (alpha_2 - c alpha_3 lambda), alpha_3 = beta alpha_1."""
    pull = -terms.epsilon * terms.share * terms["beta"] * terms["alpha_1"]
    return {"b": plus(number(terms.epsilon * terms["alpha_2"]), scaled(pull, terms.force))}


MECHANISM = Effect(
    "model",
    "no scene leaves it out",
    states=("b",),
    parameters={"alpha_1": fmpq(-1), "alpha_2": fmpq(-1), "beta": fmpq(3, 2)},
    rates=rates,
)
