"""Tangential motion (paper, eq. udot): the slip velocity u; x is cyclic and not integrated."""

from __future__ import annotations

from flint import fmpq

from gspot_verified.expansion.derivative import plus
from gspot_verified.expansion.expressions import Expression
from gspot_verified.scenes.effects.effect import Effect
from gspot_verified.scenes.effects.terms import FLIGHT, SLIP, Terms, number, scaled


def rates(terms: Terms) -> dict[str, Expression]:
    """u' = epsilon (a + k^+ lambda) in positive slip, epsilon a in flight."""
    if terms.phase not in (SLIP, FLIGHT):
        return {}
    return {"u": plus(number(terms.epsilon * terms["a"]), scaled(terms.epsilon * terms["k_plus"], terms.force))}


EFFECT = Effect(
    "tangential_motion",
    "the slip velocity stays positive: the contact never sticks",
    states=("u",),
    parameters={"a": fmpq(0), "k_plus": fmpq(-1)},
    rates=rates,
    phases=(SLIP, FLIGHT),
)
