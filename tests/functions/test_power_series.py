"""Power series of functions of the state by two programs, against sympy and mpmath."""

from __future__ import annotations

from functools import partial
from typing import Any

import mpmath
import pytest
import sympy
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from witnesses.expressions import letter_number, value_of

from gspot_verified.expansion.series.terms import NumberTerms
from gspot_verified.functions.derivative import lie_derivative, partial_derivative, powers_as_products, substitute
from gspot_verified.functions.expressions import (
    Constant,
    Cosine,
    Exponential,
    Expression,
    Logarithm,
    Power,
    Product,
    Sine,
    Variable,
    in_order,
)
from gspot_verified.functions.layers import LayeredFunctions
from gspot_verified.functions.power_series import SeriesOfFunctions
from gspot_verified.functions.rings import BALLS, RATIONALS
from gspot_verified.testing import polynomials

x, y = Variable(0), Variable(1)
one = Constant(fmpq(1))
FUNCTIONS = {
    "sine": Sine(x + y * x),
    "cosine": Cosine(x - y),
    "both": Sine(x) * Cosine(x) + Sine(y),
    "exponential": Exponential(x * y - x),
    "reciprocal": Product(Sine(y), Power(one + x + y, fmpq(-1))),
    "root": Power(Constant(fmpq(4)) + x, fmpq(1, 2)) * Power(one - y * y, fmpq(-3, 2)),
    "natural": Power(x + y, fmpq(5)) + Power(x, fmpq(0)) + Power(y, fmpq(1)) + Power(Power(x, fmpq(2)), fmpq(2)),
    "nested": Exponential(Sine(Exponential(x) - one)),
    "logarithm": Logarithm(one + x * y - x) * Logarithm(Exponential(x)),
    "quotient": (x + one) / (one + Cosine(y)),
}
# x and y as series in one letter; 0 at the start.
STATE = ([0, 1, fmpq(-1, 2), 0, 3, 1, 0, 0], [0, fmpq(2), 0, 1, 0, fmpq(1, 7), 0, 2])
ORDERS = 8
to_sympy = partial(value_of, number=letter_number, program=sympy)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_against_sympy(name: str) -> None:
    function = FUNCTIONS[name]
    d = sympy.Symbol("d")
    state = [sum(letter_number(c) * d**n for n, c in enumerate(row)) for row in STATE]
    expected = sympy.series(to_sympy(function, state), d, 0, ORDERS).removeO()
    series = SeriesOfFunctions([function], NumberTerms(RATIONALS), RATIONALS)
    for n in range(ORDERS):
        series.extend([fmpq(row[n]) for row in STATE])
        assert letter_number(series[function][n]) == sympy.expand(expected).coeff(d, n), n


@pytest.mark.parametrize("name", FUNCTIONS)
def test_layers_against_sympy(name: str) -> None:
    """The other program: x = t + e/2 - t e + e^2, y = 2 t - e + t^2 e, in powers of e and t."""
    function = FUNCTIONS[name]
    t, e = sympy.symbols("t e")
    x_rows = [[0, 1, 0, 0], [fmpq(1, 2), -1, 0, 0], [1, 0, 0, 0]]
    y_rows = [[0, 2, 0, 0], [-1, 0, 1, 0], [0, 0, 0, 0]]
    values = [sum(letter_number(c) * t**k * e**m for m, row in enumerate(rows) for k, c in enumerate(row))
              for rows in (x_rows, y_rows)]  # fmt: skip
    exact = to_sympy(function, values)
    layers = LayeredFunctions([function], RATIONALS)
    for m in range(3):
        layers.open_layer()
        for k in range(4):
            state = [fmpq(x_rows[m][k]), fmpq(y_rows[m][k])]
            layers.push([fmpq(5), fmpq(7)] if (m, k) != (0, 0) else state)
            if (m, k) != (0, 0):
                layers.pop()
                layers.push(state)
    for m in range(3):
        at_zero = sympy.diff(exact, e, m).subs(e, 0) / sympy.factorial(m)
        expected = sympy.series(at_zero, t, 0, 4).removeO()
        for k in range(4):
            assert letter_number(layers[function].rows[m][k]) == sympy.expand(expected).coeff(t, k), (m, k)


def test_balls_against_mpmath() -> None:
    functions = [Sine(x) * Exponential(y), Power(x, fmpq(1, 3)), Cosine(x * y), Power(x + y, fmpq(3))]
    series = SeriesOfFunctions(functions, NumberTerms(BALLS), BALLS)
    point = [arb(fmpq(7, 5)), arb(fmpq(-1, 3))]
    series.extend(point)
    series.extend([arb(1), arb(2)])
    for _ in range(4):
        series.extend([arb(0), arb(0)])
    independent = [
        lambda d: mpmath.sin(mpmath.mpf(7) / 5 + d) * mpmath.exp(-mpmath.mpf(1) / 3 + 2 * d),
        lambda d: mpmath.cbrt(mpmath.mpf(7) / 5 + d),
        lambda d: mpmath.cos((mpmath.mpf(7) / 5 + d) * (-mpmath.mpf(1) / 3 + 2 * d)),
        lambda d: (mpmath.mpf(7) / 5 - mpmath.mpf(1) / 3 + 3 * d) ** 3,
    ]
    with mpmath.workdps(40):
        for function, expected in zip(functions, independent, strict=True):
            for found, wanted in zip(series[function], mpmath.taylor(expected, 0, 5), strict=True):
                assert found.is_finite()
                assert abs(float(found.mid()) - float(wanted)) < 1e-11


def test_the_last_order_can_be_replaced() -> None:
    function = Sine(x) * x + Power(x, fmpq(3))
    series = SeriesOfFunctions([function], NumberTerms(RATIONALS), RATIONALS)
    for value in (0, 1):
        series.extend([fmpq(value)])
    series.extend([fmpq(17)])
    series.drop_last()
    series.extend([fmpq(0)])
    series.extend([fmpq(0)])
    assert series[function] == [0, 0, 1, 1]


def test_a_function_of_a_vanishing_base() -> None:
    series = SeriesOfFunctions([Power(x, fmpq(2))], NumberTerms(RATIONALS), RATIONALS)
    for value in (0, 3, 1):
        series.extend([fmpq(value)])
    assert series[Power(x, fmpq(2))] == [0, 0, 9]
    with pytest.raises(ValueError, match="vanish"):
        SeriesOfFunctions([Power(x, fmpq(-1))], NumberTerms(RATIONALS), RATIONALS).extend([fmpq(0)])


@pytest.mark.parametrize("name", FUNCTIONS)
def test_derivatives_against_sympy(name: str) -> None:
    function = FUNCTIONS[name]
    a, b = sympy.symbols("a b")
    expected = to_sympy(function, [a, b])
    for index, letter in enumerate((a, b)):
        found = to_sympy(partial_derivative(function, index, 2), [a, b])
        assert sympy.simplify(found - sympy.diff(expected, letter)) == 0
    along = to_sympy(lie_derivative(function, (x * y, one)), [a, b])
    assert sympy.simplify(along - sympy.diff(expected, a) * a * b - sympy.diff(expected, b)) == 0
    assert to_sympy(substitute(function, [y, x * x]), [a, b]) == to_sympy(function, [b, a * a])
    assert sympy.expand(to_sympy(powers_as_products([function])[function], [a, b]) - expected) == 0


@given(polynomials([0, 1, 2], constant=True), polynomials([0, 1, 2]))
def test_the_rules_of_differentiation(f: Expression, g: Expression) -> None:
    field = (Variable(1), Constant(fmpq(2)), Variable(0) * Variable(2))
    letters = list(sympy.symbols("a b c"))

    def slope(h: Expression) -> Any:
        return to_sympy(lie_derivative(h, field), letters)

    left, right = to_sympy(f, letters), to_sympy(g, letters)
    assert sympy.expand(slope(f * g) - slope(f) * right - left * slope(g)) == 0
    assert sympy.expand(slope(f - g) - slope(f) + slope(g)) == 0


@given(st.integers(1, 200))
def test_shared_parts_are_found_once(depth: int) -> None:
    node: Expression = x
    for _ in range(depth):
        node = node * node
    assert len(in_order([node])) == depth + 1
