"""Symbols in the graphs of formulas: their names, the components beside them, and how long a formula is."""

from __future__ import annotations

from flint import fmpq

from gspot_verified.functions.expressions import Constant, Power, Product, Sine, Sum, Variable
from gspot_verified.mechanisms.formulas.symbol import Symbol, count_operations, symbol_names, variable_indices

m, k, x, v = Symbol("m"), Symbol("k"), Variable(0), Variable(3)
FORMULA = Sum((Product(m, Sine(x)), Product(k, Sine(x)), Power(v, fmpq(2)), Constant(fmpq(1))))


def test_symbols_of_one_name_are_one() -> None:
    assert Symbol("m") is m
    assert Symbol("k") is not m
    assert m.parts() == ()


def test_names_and_components() -> None:
    assert symbol_names([FORMULA]) == {"m", "k"}
    assert variable_indices([FORMULA]) == {0, 3}
    assert symbol_names([x, v]) == variable_indices([m, k]) == set()
    assert symbol_names([m, Sine(k)]) == {"m", "k"}


def test_operations_are_counted_once() -> None:
    """Three sums, two products, one square, and one sine that stands twice."""
    assert count_operations(FORMULA) == 7
    assert count_operations(x) == count_operations(m) == 0
    assert count_operations(Sine(x)) == 1
    assert count_operations(Sum((x, v))) == 1
    assert count_operations(Sum((x, v, m))) == 2
