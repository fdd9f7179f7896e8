"""Friction that depends on the slip speed |u|: mu(|u|), continuous at 0, as a formula in ``slip_speed``.

The functions of Sec. 2 are derived with the slip speed held fixed, a symbol in them. F, b, alpha_2 do not depend on mu;
G, p, alpha_3 are affine in mu without its derivatives: with the slip speed in the place of the symbol they are those of
the mechanism. A rate of p is not: proof page ``proofs/slip_speed.md``.
"""

from __future__ import annotations

from collections.abc import Sequence

from gspot_verified.functions.expressions import Expression
from gspot_verified.mechanisms.derive.derived import Derived
from gspot_verified.mechanisms.formulas.rewriting import replaced
from gspot_verified.mechanisms.formulas.symbol import SLIP_SPEED, Symbol, symbol_names
from gspot_verified.mechanisms.input.mechanism import Mechanism

NOT_LAGRANGIAN = (
    "the friction coefficient depends on the slip speed, so L_G p = mu'(u) B (mu A - B) is not 0, as eq. lagrangian2 "
    "asks (where p = 0 it is mu'(u) (A C - B^2)): p' = alpha_1 + (L_G p) lambda_N takes the place of eq. gensys2, slip "
    "can reach p = 0 away from a G-spot, and what rests on that equation (G-spots, Cases, expansions, approach, sweep) "
    "is not computed; simulate and critical_friction take it"
)


def depends_on_slip_speed(mechanism: Mechanism, functions: Derived[Expression]) -> bool:
    """Whether the friction coefficient does, with the values that the parameters have."""
    own = {name for name, _ in mechanism.parameters}
    return SLIP_SPEED in symbol_names([functions.mu]) - own


def at_slip_speed(functions: Sequence[Expression], speed: Expression) -> list[Expression]:
    """The functions with ``speed`` in the place of the slip speed; an alpha is then still the one of a fixed speed.

    :raises ZeroDivisionError: one of them divides by zero then.
    """
    return replaced(functions, {Symbol(SLIP_SPEED): speed})
