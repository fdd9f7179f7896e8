"""Formulas from sympy and to it: the same function, and what formulas do not have is refused by name."""

from __future__ import annotations

from typing import Any

import pytest
import sympy

from gspot_verified.functions.expressions import Variable
from gspot_verified.mechanisms.formulas.in_sympy import from_sympy, sympy_formula, to_sympy
from gspot_verified.mechanisms.formulas.names import FormulaError
from gspot_verified.mechanisms.formulas.symbol import PI, Symbol

X, Y = sympy.symbols("x y")
NAMES = {"x": Variable(0), "y": Variable(1)}


@pytest.mark.parametrize(
    "function",
    [
        X + 2 * Y - sympy.Rational(1, 3), X * Y**2 / (1 + X**2), sympy.sin(X) * sympy.cos(Y), sympy.tan(X + Y),
        sympy.exp(X) * sympy.log(Y), sympy.sqrt(1 + X**2), sympy.E * X, sympy.pi * Y, sympy.pi,
    ],
)  # fmt: skip
def test_there_and_back_it_is_the_same_function(function: Any) -> None:
    back = to_sympy(from_sympy(function, NAMES), ("x", "y"))
    assert sympy.simplify(back - function) == 0


def test_pi_is_the_number_and_another_name_a_symbol() -> None:
    assert to_sympy(Symbol(PI)) == sympy.pi
    assert to_sympy(Symbol("m")) == sympy.Symbol("m")
    assert from_sympy(sympy.pi, {}) == Symbol(PI)
    assert sympy_formula("cos(pi)", {}) == -1


@pytest.mark.parametrize(
    ("value", "message"),
    [
        (X + sympy.Symbol("mass"), "unknown symbol 'mass'"),
        (X + sympy.Float("0.5"), "not exact"),
        (sympy.gamma(X), "no function of formulas"),
        (X**Y, "no function of formulas"),
        (sympy.I * X, "no function of formulas"),
    ],
)
def test_what_formulas_do_not_have_is_refused(value: Any, message: str) -> None:
    with pytest.raises(FormulaError, match=message):
        from_sympy(value, NAMES)
