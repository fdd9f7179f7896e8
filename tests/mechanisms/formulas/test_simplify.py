"""Simplified expressions are the same functions, and what is equal meets."""

from __future__ import annotations

from typing import Any

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.expansion.series.terms import NumberTerms
from gspot_verified.functions.derivative import ONE, ZERO
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
)
from gspot_verified.functions.power_series import SeriesOfFunctions
from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.formulas.rewriting import replaced, simplified
from gspot_verified.mechanisms.formulas.simplify import (
    NoNumberError,
    NotRealError,
    NumberTooLargeError,
    constant,
    cosine_of,
    logarithm_of,
    power_of,
    product_of,
    sine_of,
    split,
    sum_of,
)
from gspot_verified.mechanisms.formulas.symbol import Symbol
from gspot_verified.numbers.balls import working_bits

x, y = Variable(0), Variable(1)
leaves = st.sampled_from([x, y, ONE, ZERO]) | st.fractions(-3, 3, max_denominator=4).map(
    lambda f: Constant(fmpq(f.numerator, f.denominator))
)


def larger(inner: st.SearchStrategy[Expression]) -> st.SearchStrategy[Expression]:
    bases = inner.map(lambda e: Sum((Constant(fmpq(40)), e)))  # rarely zero, so that negative powers exist
    return (
        st.lists(inner, min_size=1, max_size=4).map(lambda terms: Sum(tuple(terms)))
        | st.builds(Product, inner, inner)
        | st.builds(Power, bases, st.sampled_from([fmpq(-2), fmpq(-1), fmpq(1, 2), fmpq(-3, 2)]))
        | st.builds(Power, inner, st.sampled_from([fmpq(1), fmpq(2), fmpq(3)]))
        | st.builds(Sine, inner)
        | st.builds(Cosine, inner)
        | st.builds(Exponential, inner.map(Sine))
    )


def value(expression: Expression, at: list[arb]) -> arb | None:
    """The number, or None where it is not defined."""
    series = SeriesOfFunctions([expression], NumberTerms(BALLS), BALLS)
    try:
        series.extend(at)
    except ValueError:
        return None
    found: arb = series[expression][0]
    return found if found.is_finite() else None


@given(st.recursive(leaves, larger, max_leaves=12), st.integers(-9, 9), st.integers(-9, 9))
def test_the_same_function(expression: Expression, first: int, second: int) -> None:
    with working_bits(400):
        at = [arb(first) / 8, arb(second) / 8]
        before = value(expression, at)
        if before is None:
            return
        try:
            (simple,) = simplified(expression)
        except NoNumberError:
            return
        after = value(simple, at)
        assert after is not None
        assert after.overlaps(before)


ATOMS = (x, y, Symbol("k"), ONE)
part = st.tuples(st.integers(-3, 3), st.integers(0, len(ATOMS) - 1))


@given(st.lists(st.tuples(st.integers(-3, 3), st.lists(part, max_size=5)), max_size=4))
def test_sums_inside_of_sums_keep_every_term(groups: list[tuple[int, list[tuple[int, int]]]]) -> None:
    """Sums of variables, symbols and numbers have one form: that of the coefficients counted by hand."""
    inner = [
        product_of(constant(k), sum_of(*(product_of(constant(c), ATOMS[i]) for c, i in parts))) for k, parts in groups
    ]
    total = [sum(k * c for k, parts in groups for c, i in parts if i == j) for j in range(len(ATOMS))]
    assert sum_of(*inner) is sum_of(*(product_of(constant(c), atom) for c, atom in zip(total, ATOMS, strict=True)))
    (again,) = simplified(Sum((ONE, *inner)))
    assert again is sum_of(ONE, sum_of(*inner))


def test_a_sum_of_twelve_inside_a_sum() -> None:
    terms = [Symbol(f"k{i:02}") for i in range(12)]
    assert sum_of(sum_of(*terms), y) is Sum((y, *terms))


@pytest.mark.parametrize(
    ("made", "wanted"),
    [
        (sum_of(sum_of(x, y), sum_of(y, ONE)), Sum((x, product_of(constant(2), y), ONE))),
        (sum_of(product_of(constant(3), sum_of(x, ONE)), -x), Sum((product_of(constant(2), x), constant(3)))),
        (sum_of(x, y, -x), y),
        (sum_of(product_of(x, y), product_of(constant(-1), y, x)), ZERO),
        (product_of(x, power_of(x, fmpq(-1))), ONE),
        (product_of(sum_of(x, ONE), y, power_of(sum_of(x, ONE), fmpq(-1))), y),
        (product_of(x, x), Power(x, fmpq(2))),
        (product_of(ZERO, x), ZERO),
        (product_of(constant(2), sum_of(x, y)), sum_of(product_of(constant(2), x), product_of(constant(2), y))),
        (power_of(constant(fmpq(9, 4)), fmpq(-3, 2)), constant(fmpq(8, 27))),
        (power_of(power_of(x, fmpq(1, 2)), fmpq(4)), Power(x, fmpq(2))),
        (power_of(power_of(x, fmpq(2)), fmpq(1, 2)), Power(Power(x, fmpq(2)), fmpq(1, 2))),
        (sine_of(ZERO), ZERO),
        (cosine_of(sum_of(y, product_of(constant(-1), x))), Cosine(sum_of(x, product_of(constant(-1), y)))),
        (sum_of(), ZERO),
        (sum_of(ONE, x, constant(-1)), x),
    ],
)
def test_forms(made: Expression, wanted: Expression) -> None:
    assert made is wanted


def test_a_long_sum_inside_a_sum_stays_shared() -> None:
    long = Sum(tuple(Sine(product_of(constant(k), x)) for k in range(1, 40)))
    assert sum_of(long, y) is Sum((y, long))
    assert sum_of(long, product_of(constant(-1), long)) is ZERO


def test_split() -> None:
    assert split(product_of(constant(fmpq(-2, 3)), x)) == (fmpq(-2, 3), x)
    assert split(constant(5)) == (fmpq(5), ONE)
    assert split(Constant(arb(5)))[0] == 1


def test_divisions_by_zero_and_large_numbers() -> None:
    with pytest.raises(ZeroDivisionError):
        power_of(ZERO, fmpq(-1))
    with pytest.raises(ZeroDivisionError):
        replaced([power_of(sum_of(Symbol("k"), ONE), fmpq(-1))], {Symbol("k"): constant(-1)})
    with pytest.raises(NumberTooLargeError):
        power_of(constant(fmpq(2**400, 3)), fmpq(64))
    with pytest.raises(NumberTooLargeError):
        product_of(*[constant(2**3000)] * 7)


def test_expressions_made_alike_are_one_object_also_after_copying() -> None:
    import copy
    import pickle

    whole: Any = Product(Sum((x, Constant(fmpq(1, 2)))), Power(y, fmpq(-1)))
    assert Product(Sum((Variable(0), Constant(fmpq(1, 2)))), Power(Variable(1), fmpq(-1))) is whole
    assert copy.deepcopy(whole) is whole
    text = pickle.dumps(Sine(Symbol("k")))
    assert pickle.loads(text) is Sine(Symbol("k"))
    assert Constant(fmpq(1, 2)) is not Constant(fmpq(1, 3))
    assert Power(x, fmpq(1, 2)) is not Power(x, fmpq(1, 3))
    assert Sine(x) is not Cosine(x)


def test_balls_equal_only_themselves() -> None:
    third = arb(1) / 3
    assert Constant(third) is Constant(third)
    assert Constant(third) is not Constant(arb(1) / 3)


@pytest.mark.parametrize("number", range(1, 9))
def test_no_factor_of_a_product_is_lost(number: int) -> None:
    """However many different factors there are: each is met once."""
    waiting, met = [product_of(*map(Variable, range(number)))], set()
    while waiting:
        node = waiting.pop()
        if isinstance(node, Product):
            waiting += [node.left, node.right]
        else:
            met.add(node)
    assert met == set(map(Variable, range(number)))


def test_no_root_and_no_logarithm_of_what_has_no_real_one() -> None:
    """sqrt(-4)^2 would become -4."""
    for number, exponent in ((-4, fmpq(1, 2)), (-8, fmpq(1, 3)), (-1, fmpq(-3, 2))):
        with pytest.raises(NotRealError, match=f"a root of the negative number {number}"):
            power_of(constant(number), exponent)
    for number in (-1, 0):
        with pytest.raises(NotRealError, match=f"the logarithm of {number}"):
            logarithm_of(constant(number))


def test_only_square_roots_of_squares_are_computed() -> None:
    assert power_of(constant(fmpq(4, 9)), fmpq(3, 2)) == constant(fmpq(8, 27))
    for number, exponent in ((fmpq(4), fmpq(1, 3)), (fmpq(4, 9), fmpq(-2, 3)), (fmpq(2), fmpq(1, 2))):
        assert power_of(constant(number), exponent) == Power(constant(number), exponent)
    assert power_of(ZERO, fmpq(1, 2)) is ZERO
    with pytest.raises(ZeroDivisionError):
        power_of(ZERO, fmpq(-1, 2))


def test_the_logarithm_of_1_alone_is_0() -> None:
    assert logarithm_of(ONE) is ZERO
    assert logarithm_of(Variable(0)) == Logarithm(Variable(0))
    assert logarithm_of(constant(2)) == Logarithm(constant(2))
