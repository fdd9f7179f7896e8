"""The norms of proofs/residual.md, rule by rule: against the sums of the absolute Taylor coefficients, by mpmath."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from witnesses.expressions import BALLS, value_of

from gspot_verified.expansion.majorants import Graded, _changes, _least, graded_functions, rest_of_product
from gspot_verified.functions.expressions import (
    Constant,
    Cosine,
    Exponential,
    Expression,
    Logarithm,
    Power,
    Product,
    Sine,
    Sum,
    Variable,
    in_order,
)
from gspot_verified.numbers.balls import working_bits

x = Variable(0)
START = fmpq(6, 5)
CASES: dict[str, tuple[Expression, Callable[[Any], Any]]] = {
    "constant": (Constant(fmpq(-3)), lambda u: -3 + 0 * u),
    "sum": (Sum((x, x, Constant(fmpq(7)))), lambda u: 2 * u + 7),
    "product": (Product(x, x), lambda u: u * u),
    "sine": (Sine(x), mpmath.sin),
    "cosine": (Cosine(x), mpmath.cos),
    "exponential": (Exponential(x), mpmath.exp),
    "logarithm": (Logarithm(x), mpmath.log),
    "reciprocal": (Power(x, fmpq(-1)), lambda u: 1 / u),
    "inverse root": (Power(x, fmpq(-1, 2)), lambda u: 1 / mpmath.sqrt(u)),
    "root": (Power(x, fmpq(1, 2)), mpmath.sqrt),
    "two series": (Product(Exponential(x), Cosine(x)), lambda u: mpmath.exp(u) * mpmath.cos(u)),
    "nested": (Sine(Product(x, Exponential(x))), lambda u: mpmath.sin(u * mpmath.exp(u))),
}
# Cases in which no two terms of one order cancel, so that the bound is the sum itself.
SHARP = ("constant", "sum", "product", "sine", "cosine", "exponential", "logarithm", "reciprocal", "inverse root")


def coefficients(function: Callable[[Any], Any], count: int, start: Any = None) -> list[Any]:
    """|f_n| of f(start + d), at START when nothing is said."""
    at = mpmath.mpf(6) / 5 if start is None else start
    return [abs(c) for c in mpmath.taylor(lambda d: function(at + d), 0, count)]


def middle(value: arb) -> Any:
    mantissa, exponent = (int(part) for part in value.mid().man_exp())
    return mpmath.ldexp(mpmath.mpf(mantissa), exponent)


def starts_of(nodes: list[Expression], start: Any = START) -> dict[Expression, Any]:
    """The values at START, by the functions under test's own arithmetic of one number."""
    return {node: value_of(node, [arb(start)], arb, BALLS) for node in nodes}


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
def test_the_change_from_every_start_in_a_ball(name: str) -> None:
    """The start 6/5 +- 1/10: the bound covers each number in the ball."""
    function, independent = CASES[name]
    nodes = in_order([function])
    with working_bits(100), mpmath.workdps(30):
        bound = _changes(nodes, starts_of(nodes, arb("1.2", "0.1")), [lambda r: r], arb("0.25", "0.05"))[function]
        assert bound.is_finite()
        found = middle(bound.upper())
        for tenths in (11, 13):
            values = coefficients(independent, 15, mpmath.mpf(tenths) / 10)
            assert found >= sum(c * mpmath.mpf("0.3") ** n for n, c in enumerate(values) if n)


def test_a_small_change_of_a_power_grows_with_its_start() -> None:
    """u^(7/2) on u in 6/5 +- 1/10: the change of u by 1/100 is largest at the upper end, not at the lower one."""
    node = Power(x, fmpq(7, 2))
    nodes = in_order([node])
    with working_bits(100), mpmath.workdps(30):
        bound = _changes(nodes, starts_of(nodes, arb("1.2", "0.1")), [lambda r: r], arb("0.01"))[node]
        start = mpmath.mpf("1.3")
        assert bound.is_finite()
        assert middle(bound.upper()) >= (start + mpmath.mpf("0.01")) ** 3.5 - start**3.5


graded_norms = st.lists(st.integers(0, 50), min_size=4, max_size=4)


@given(graded_norms, graded_norms, st.integers(0, 50), st.integers(0, 50))
def test_the_orders_of_a_product_are_all_pairs(left: list[int], right: list[int], one: int, other: int) -> None:
    """The rest is what the product of the norms holds beyond the pairs of order below N: no pair lost, none twice."""
    low = sum(a * b for i, a in enumerate(left) for j, b in enumerate(right) if i + j < 4)
    f, g = (Graded(tuple(arb(c) for c in norms), arb(rest)) for norms, rest in ((left, one), (right, other)))
    assert f.total() == sum(left) + one
    assert rest_of_product(f, g) == (sum(left) + one) * (sum(right) + other) - low


def test_the_rest_of_a_sum_is_the_sum_of_the_rests() -> None:
    """e^x + sin x + e^x."""
    parts = Exponential(x), Sine(x)
    whole = Sum((*parts, parts[0]))
    nodes = in_order([whole])
    with working_bits(100):
        norms = {node: (arb(1), arb(1)) for node in nodes}
        found = graded_functions(nodes, norms, starts_of(nodes), [lambda r: r / 4])
        assert found[whole].rest.overlaps(2 * found[parts[0]].rest + found[parts[1]].rest)
        assert found[whole].rest > found[parts[0]].rest + found[parts[1]].rest


def test_the_least_bound_is_the_least_finite_one() -> None:
    bounds = [arb("nan"), arb(3), arb(0, "inf"), arb(2, 1), arb("2.5"), arb("inf")]
    for order in itertools.permutations(bounds):
        assert _least(order) == arb("2.5")
    assert not _least([arb("nan"), arb("inf")]).is_finite()
    assert not _least([]).is_finite()


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
            values = coefficients(lambda u, n=node: 0 * u + value_of(n, [u]), order - 1)
            norms[node] = tuple(arb(mpmath.nstr(c * quarter**n, 50)) for n, c in enumerate(values))
        rest = graded_functions(nodes, norms, starts_of(nodes), [lambda r: r / 4])[function].rest
        wanted = sum(c * quarter**n for n, c in enumerate(coefficients(independent, 40)) if n >= order)
        assert rest.is_finite()
        found = middle(rest)
    assert found >= wanted * (1 - mpmath.mpf(10) ** -12)
    assert found <= 2000 * wanted + mpmath.mpf(10) ** -12 or name == "nested"


@pytest.mark.parametrize("ratio", [fmpq(6, 5), fmpq(2)])
def test_no_bound_where_a_base_may_vanish(ratio: fmpq) -> None:
    nodes = in_order([CASES["reciprocal"][0]])
    assert not _changes(nodes, starts_of(nodes), [lambda r: r], arb(ratio))[nodes[-1]].is_finite()
    wide = {**starts_of(nodes), x: arb(0, 1)}
    assert not _changes(nodes, wide, [lambda r: r], arb(ratio) / 100)[nodes[-1]].is_finite()


def test_a_power_of_a_start_of_either_sign_and_of_any_size() -> None:
    """|1/(u_0 + d) - 1/u_0| <= 1/(|u_0| - |d|) - 1/|u_0|, attained."""
    nodes = in_order([CASES["reciprocal"][0]])
    for start in (fmpq(6, 5), fmpq(-6, 5), fmpq(1, 2), fmpq(-1, 2)):
        with working_bits(100):
            found = _changes(nodes, starts_of(nodes, start), [lambda r: r], arb(fmpq(1, 4)))[nodes[-1]]
            wanted = 1 / (abs(start) - fmpq(1, 4)) - 1 / abs(start)
            assert wanted <= found.upper()
            assert found.upper() < wanted + fmpq(1, 10**20)


def test_a_function_without_a_rule_is_refused() -> None:
    class Another(Expression):
        """No rule of the page is about it."""

    with pytest.raises(TypeError, match="no bound for Another"):
        _changes([Another()], {}, [], arb(1))


def test_no_bound_where_a_logarithm_may_not_exist() -> None:
    nodes = in_order([Logarithm(x)])
    with working_bits(100):
        for start, radius in ((arb(1), arb(1)), (arb(1), arb(2)), (arb(-1), arb(1) / 2), (arb(0, 1), arb(1) / 9)):
            starts = {x: start, nodes[-1]: arb(0)}
            assert not _changes(nodes, starts, [lambda r, radius=radius: r * radius], arb(1))[nodes[-1]].is_finite()
        starts = {x: arb(1), nodes[-1]: arb(0)}
        found = _changes(nodes, starts, [lambda r: r / 2], arb(1))[nodes[-1]]
        assert found.is_finite()
        assert found.overlaps(arb(2).log())


def test_a_logarithm_of_a_start_of_any_size() -> None:
    """log(u_0 + d) - log u_0 is largest in absolute value at d = -h: -log(1 - h/u_0), attained; h = 1/16."""
    nodes = in_order([Logarithm(x)])
    for start in (fmpq(1, 12), fmpq(1, 2), fmpq(1), fmpq(6, 5), fmpq(40)):
        with working_bits(100):
            found = _changes(nodes, starts_of(nodes, start), [lambda r: r], arb(fmpq(1, 16)))[nodes[-1]]
            wanted = arb(start).log() - arb(start - fmpq(1, 16)).log()
            assert found.is_finite()
            assert wanted.lower() <= found.upper()
            assert found.upper() < wanted + fmpq(1, 10**20)
