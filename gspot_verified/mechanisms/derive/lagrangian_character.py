"""The Lagrangian character that the paper asks of a system, proved as identities in the state.

L_GT x = L_GN x = L_GT y = L_GN y = 0 (eq. lagrangian1), L_GN u = L_GT v, and L_G p = 0 (eq. lagrangian2). With a mass
matrix they hold by the way the functions are derived (:mod:`derivation`). Fields that are given directly
are checked: a function that simplifies to the constant 0 is 0; what does not is left to sympy.
"""

from __future__ import annotations

from gspot_verified.functions.derivative import ZERO
from gspot_verified.functions.expressions import Expression
from gspot_verified.mechanisms.derive.derived import Derived
from gspot_verified.mechanisms.formulas.rewriting import along
from gspot_verified.mechanisms.formulas.simplify import minus
from gspot_verified.mechanisms.input.mechanism import Lagrangian, Mechanism


def check_lagrangian_character(mechanism: Mechanism, found: Derived[Expression]) -> None:
    """Checks eqs. lagrangian1, lagrangian2 and B = L_GN u = L_GT v as identities in the state.

    :raises MechanismError: one of them is not the zero function, or was not shown to be.
    """
    if isinstance(mechanism.motion, Lagrangian):
        return
    places = [found.y] if found.x is None else [found.x, found.y]
    checks = [along(field, function) for function in places for field in (found.G_T, found.G_N)]
    checks.append(minus(found.B, along(found.G_T, found.v)))
    checks.append(along(found.G, found.p))
    if all(check is ZERO for check in checks):
        return
    from gspot_verified.mechanisms.derive.lie_derivatives import check_lagrangian_conditions, derive

    check_lagrangian_conditions(mechanism, derive(mechanism))
