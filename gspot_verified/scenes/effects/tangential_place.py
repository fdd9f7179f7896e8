"""The place x of the contact point along the surface (paper, eq. xdot).

Nothing is lost where it is left out: what the equations need of the place is integrated in any case. That nothing
depends on it is said where it is seen in the equations.
"""

from __future__ import annotations

from gspot_verified.functions.expressions import Expression
from gspot_verified.scenes.effects.effect import Effect, ModelStates
from gspot_verified.scenes.equations.model_terms import ModelTerms
from gspot_verified.scenes.equations.terms import scaled


def rates(terms: ModelTerms) -> dict[str, Expression]:
    """x' = epsilon u."""
    return {"x": scaled(terms.epsilon, terms.u)}


_CYCLIC = "nothing depends on where along the surface the contact is: x is cyclic"
_DEPENDS = "x is not shown; the equations may depend on where along the surface the contact is, and this is integrated"
EFFECT = Effect(
    "tangential_place",
    "x is not shown: it is cyclic, or what the equations need of it is integrated",
    left_out_of=lambda motion: _DEPENDS if motion.depends_on_place else _CYCLIC,
    model_states=ModelStates(("x",), rates),
    sees=("x",),
    needs=("tangential_motion",),
)
