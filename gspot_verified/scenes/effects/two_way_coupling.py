"""Two-way coupling (paper, eq. newex1): p' = alpha_1 + chi b, so that p is no longer known in advance."""

from __future__ import annotations

from flint import fmpq

from gspot_verified.expansion.derivative import plus
from gspot_verified.expansion.expressions import Expression
from gspot_verified.scenes.effects.effect import Effect
from gspot_verified.scenes.effects.terms import Terms, number, scaled


def rates(terms: Terms) -> dict[str, Expression]:
    """p' = epsilon (alpha_1 + chi b)."""
    drift = number(terms.epsilon * terms["alpha_1"])
    return {"p": plus(drift, scaled(terms.epsilon * terms["chi"], terms.state("b")))}


EFFECT = Effect(
    "two_way_coupling",
    "the normal motion does not act back: p = p_0 + alpha_1 t is known and not integrated",
    states=("p",),
    parameters={"chi": fmpq(1)},
    rates=rates,
)
