"""Compliant contact (paper, eqs. compliant1 to compl2): y, v and the deformation z of the surface."""

from __future__ import annotations

from flint import fmpq

from gspot_verified.functions.derivative import plus
from gspot_verified.functions.expressions import Expression
from gspot_verified.scenes.effects.effect import Effect, States
from gspot_verified.scenes.equations.terms import Terms, scaled


def rates(terms: Terms) -> dict[str, Expression]:
    """Y' = V, V' = dv/dt, damping Z' = -k_1 Z - lambda.

    The stiffnesses are k_1/epsilon^2 and k_2/epsilon^2, the damping damping/epsilon; 1, 1, 1 in the paper.
    """
    relaxing = plus(scaled(-terms["k_1"], terms.state("Z")), scaled(fmpq(-1), terms.force))
    return {"Y": terms.state("V"), "V": terms.acceleration, "Z": scaled(1 / terms["damping"], relaxing)}


EFFECT = Effect(
    "compliant_contact",
    "a rigid surface: the contact force is -b/p, and nothing is said of the motion once p <= 0",
    states=States(("Y", "V", "Z"), rates),
    parameters={"k_1": fmpq(1), "k_2": fmpq(1), "damping": fmpq(1)},
)
