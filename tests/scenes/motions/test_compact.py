"""Fewer operations for the same functions: values before and after, what meets, and what is not made longer."""

from __future__ import annotations

from fractions import Fraction

from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.functions.expressions import Constant, Cosine, Expression, Power, Product, Sine, Sum, Variable
from gspot_verified.scenes.equations.scaled_system import operations
from gspot_verified.scenes.floats.float_function import float_function
from gspot_verified.scenes.motions.compact import compact

X, Y = Variable(0), Variable(1)


def number(value: int | str) -> Constant:
    return Constant(fmpq(*map(int, Fraction(value).as_integer_ratio())))


LEAVES = st.sampled_from([X, Y, number(-2), number("1/3"), number(1), number(0)])


def wholes(parts: st.SearchStrategy[Expression]) -> st.SearchStrategy[Expression]:
    return st.one_of(
        st.lists(parts, min_size=2, max_size=3).map(lambda terms: Sum(tuple(terms))),
        st.tuples(parts, parts).map(lambda pair: Product(*pair)),
        parts.map(Sine),
        parts.map(Cosine),
        # 2 + cos is never 0
        st.tuples(parts, st.sampled_from([-1, 2, "1/2"])).map(
            lambda pair: Power(Sum((number(2), Cosine(pair[0]))), number(pair[1]).value)
        ),
    )


EXPRESSIONS = st.recursive(LEAVES, wholes, max_leaves=12)


@given(st.lists(EXPRESSIONS, min_size=1, max_size=3))
def test_the_functions_stay_the_same_and_are_never_longer(roots: list[Expression]) -> None:
    found = compact(roots)
    assert operations(list(found.values())) <= operations(roots)
    for point in ([0.3, -0.7], [1.25, 0.5]):
        before, after = float_function(roots)(point), float_function([found[root] for root in roots])(point)
        assert all(abs(a - b) <= 1e-9 * (1 + abs(a)) for a, b in zip(before, after, strict=True))


def test_what_meets() -> None:
    """2 (1 - x) cancels 1 - x across the factor, as in mu G_T of the extended system; opposite sums are one."""
    one_less = Sum((number(-1) * X, number(1)))
    twice = Sum((number(-2) * X, number(2)))
    (found,) = compact([one_less * (Y * Power(twice, fmpq(-1)))]).values()
    assert found is Product(number("1/2"), Y)
    opposite = Sum((X, number(-1) * Y)), Sum((Y, number(-1) * X))
    made = compact([Sine(opposite[0]) * Cosine(opposite[1]), opposite[0], opposite[1]])
    assert made[opposite[1]] is Product(number(-1), made[opposite[0]])


def test_sums_that_vanish() -> None:
    zero = Sum((X, number(-1) * X))
    found = compact([zero * Y, Sum((zero, Y)), Sine(zero)])
    assert list(found.values()) == [number(0), Y, Sine(number(0))]


@given(st.lists(st.integers(-3, 3).filter(bool), min_size=2, max_size=5))
def test_powers_of_one_base_are_counted(exponents: list[int]) -> None:
    """A factor that comes twice in one product is cancelled once by its inverse; (2 + cos x)^k is never 0."""
    base = Sum((number(2), Cosine(X)))
    left: Expression = base
    for exponent in exponents:
        left = Product(left, Power(base, fmpq(exponent)) if exponent != 1 else base)
    for root in (left, Product(Product(left, Y), Power(base, fmpq(-1))), Product(Power(base, fmpq(-1)), left)):
        (found,) = compact([root]).values()
        for point in ([0.3, -0.7], [1.25, 0.5]):
            (before,), (after,) = float_function([root])(point), float_function([found])(point)
            assert abs(before - after) <= 1e-12 * abs(before)


def test_a_square_is_cancelled_by_its_inverse_alone() -> None:
    square = Product(X, X)
    for exponent, expected in ((-2, Y), (-1, None)):
        root = Product(Product(square, Y), Power(X, fmpq(exponent)))
        assert compact([root])[root] == (root if expected is None else expected)
