"""The paper's extended example system and its terms by Theorem 1's recursion, with symbols."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

from flint import fmpq

from gspot_verified.expansion.series.recursion import Recursion
from gspot_verified.expansion.series.system import System
from gspot_verified.functions.expressions import Constant, Expression, Variable
from gspot_verified.functions.symbols import Symbols

VARIABLES = ("p", "b", "y", "v", "z", "lambda_n")


def extended(ring: Symbols, chi: Any, alpha_1: Any, alpha_2: Any, alpha_3: Any) -> System:
    """Eqs. newex1 to newex6 in positive slip: state (x, u, y, v, p, b), extra conditions x = u = 0."""
    state = [Variable(i) for i in range(6)]

    def number(value: Any) -> Expression:
        return Constant(ring.number(value))

    slope = number(alpha_1) + number(chi) * state[5]
    zero = number(0)
    drift = (state[1], zero, state[3], state[5], slope, number(alpha_2))
    control = (zero, number(-1), zero, state[4], zero, -number(alpha_3))
    point = (ring.number(0),) * 6
    conditions = (state[0], state[1])
    return System(
        name="extended",
        F=drift,
        G=control,
        y=state[2],
        v=state[3],
        p=state[4],
        b=state[5],
        alpha_1=slope,
        alpha_2=number(alpha_2),
        alpha_3=number(alpha_3),
        J=conditions,
        point=point,
        ring=ring,
    )


@lru_cache
def extended_terms(orders: int, chi: bool) -> dict[str, list[list[Any]]]:
    """The coefficients of s^0, s^1, ... of the terms n < orders of p, b, y, v, z, lambda_N.

    With ``chi``: alpha = (-1, -1, -3/2) and a symbol chi. Without: chi = 0, symbols alpha1, alpha3 and
    c = alpha2/(alpha1 - alpha3). Every coefficient is a polynomial in the symbols.
    """
    if chi:
        ring = Symbols("chi")
        system = extended(ring, ring.symbol("chi"), fmpq(-1), fmpq(-1), fmpq(-3, 2))
    else:
        ring = Symbols("alpha1", "alpha3", "c")
        first, third = ring.symbol("alpha1"), ring.symbol("alpha3")
        system = extended(ring, 0, first, ring.symbol("c") * (first - third), third)
    recursion = Recursion(system)
    for _ in range(orders):
        recursion.advance()
    found: dict[str, list[list[Any]]] = {}
    for name in VARIABLES:
        found[name] = []
        for term in getattr(recursion, name):
            values = term.coefficients()
            if any(value.denominator != 1 for value in values):
                raise ValueError(f"{name}: a coefficient is no polynomial in the symbols")
            found[name].append([value.numerator for value in values])
    return found
