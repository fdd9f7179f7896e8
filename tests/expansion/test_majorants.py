"""The norms of proofs/residual.md, rule by rule: against the sums of the absolute Taylor coefficients, by mpmath."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath
import pytest
from flint import arb, fmpq

from gspot_verified.balls import working_bits
from gspot_verified.expansion.expressions import (
    Constant,
    Cosine,
    Exponential,
    Expression,
    Power,
    Product,
    Sine,
    Sum,
    Variable,
    in_order,
)
from gspot_verified.expansion.majorants import _changes, graded_functions

x = Variable(0)
START = fmpq(6, 5)
CASES: dict[str, tuple[Expression, Callable[[Any], Any]]] = {
    "constant": (Constant(fmpq(-3)), lambda u: -3 + 0 * u),
    "sum": (Sum((x, x, Constant(fmpq(7)))), lambda u: 2 * u + 7),
    "product": (Product(x, x), lambda u: u * u),
    "sine": (Sine(x), mpmath.sin),
    "cosine": (Cosine(x), mpmath.cos),
    "exponential": (Exponential(x), mpmath.exp),
    "reciprocal": (Power(x, fmpq(-1)), lambda u: 1 / u),
    "inverse root": (Power(x, fmpq(-1, 2)), lambda u: 1 / mpmath.sqrt(u)),
    "root": (Power(x, fmpq(1, 2)), mpmath.sqrt),
    "nested": (Sine(Product(x, Exponential(x))), lambda u: mpmath.sin(u * mpmath.exp(u))),
}
# Cases in which no two terms of one order cancel, so that the bound is the sum itself.
SHARP = ("constant", "sum", "product", "sine", "cosine", "exponential", "reciprocal", "inverse root")


def coefficients(function: Callable[[Any], Any], count: int) -> list[Any]:
    """|f_n| of f(START + d)."""
    return [abs(c) for c in mpmath.taylor(lambda d: function(mpmath.mpf(6) / 5 + d), 0, count)]


def middle(value: arb) -> Any:
    mantissa, exponent = (int(part) for part in value.mid().man_exp())
    return mpmath.ldexp(mpmath.mpf(mantissa), exponent)


def starts_of(nodes: list[Expression]) -> dict[Expression, Any]:
    """The values at START, by the functions under test's own arithmetic of one number."""
    found: dict[Expression, Any] = {}
    for node in nodes:
        match node:
            case Constant(value):
                found[node] = arb(value)
            case Variable():
                found[node] = arb(START)
            case Sum(terms):
                found[node] = sum((found[term] for term in terms), arb(0))
            case Product(left, right):
                found[node] = found[left] * found[right]
            case Power(base, exponent):
                found[node] = found[base] ** arb(exponent)
            case Sine(argument):
                found[node] = found[argument].sin()
            case Cosine(argument):
                found[node] = found[argument].cos()
            case Exponential(argument):
                found[node] = found[argument].exp()
    return found


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("ratio", [fmpq(1, 4), fmpq(2, 3)])
def test_the_change_from_the_start(name: str, ratio: fmpq) -> None:
    function, independent = CASES[name]
    nodes = in_order([function])
    with working_bits(200), mpmath.workdps(60):
        bound = _changes(nodes, starts_of(nodes), [lambda r: r], arb(ratio))[function]
        step = mpmath.mpf(int(ratio.p)) / int(ratio.q)
        wanted = sum(c * step**n for n, c in enumerate(coefficients(independent, 40)) if n)
        assert bound.is_finite()
        found = middle(bound)
    assert found >= wanted * (1 - mpmath.mpf(10) ** -12)
    if name in SHARP:
        assert found <= wanted * (1 + mpmath.mpf(10) ** -6) + mpmath.mpf(10) ** -12


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("order", [2, 5, 9])
def test_the_rest(name: str, order: int) -> None:
    """x = START + d/4 for D = 1: the orders from N on."""
    function, independent = CASES[name]
    nodes = in_order([function])
    with working_bits(200), mpmath.workdps(60):
        quarter = mpmath.mpf(1) / 4
        norms: dict[Expression, tuple[arb, ...]] = {}
        for node in nodes:
            values = coefficients(lambda u, n=node: _value(n, u), order - 1)
            norms[node] = tuple(arb(mpmath.nstr(c * quarter**n, 50)) for n, c in enumerate(values))
        rest = graded_functions(nodes, norms, starts_of(nodes), [lambda r: r / 4])[function].rest
        wanted = sum(c * quarter**n for n, c in enumerate(coefficients(independent, 40)) if n >= order)
        assert rest.is_finite()
        found = middle(rest)
    assert found >= wanted * (1 - mpmath.mpf(10) ** -12)
    assert found <= 2000 * wanted + mpmath.mpf(10) ** -12 or name == "nested"


def _value(node: Expression, u: Any) -> Any:
    match node:
        case Constant(value):
            return mpmath.mpf(int(fmpq(value).p)) + 0 * u
        case Variable():
            return u
        case Sum(terms):
            return sum(_value(term, u) for term in terms)
        case Product(left, right):
            return _value(left, u) * _value(right, u)
        case Power(base, exponent):
            return _value(base, u) ** (mpmath.mpf(int(exponent.p)) / int(exponent.q))
        case Sine(argument):
            return mpmath.sin(_value(argument, u))
        case Cosine(argument):
            return mpmath.cos(_value(argument, u))
        case Exponential(argument):
            return mpmath.exp(_value(argument, u))
    raise TypeError(node)


@pytest.mark.parametrize("ratio", [fmpq(6, 5), fmpq(2)])
def test_no_bound_where_a_base_may_vanish(ratio: fmpq) -> None:
    nodes = in_order([CASES["reciprocal"][0]])
    assert not _changes(nodes, starts_of(nodes), [lambda r: r], arb(ratio))[nodes[-1]].is_finite()
    wide = {**starts_of(nodes), x: arb(0, 1)}
    assert not _changes(nodes, wide, [lambda r: r], arb(ratio) / 100)[nodes[-1]].is_finite()
