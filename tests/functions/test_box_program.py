"""Expressions on boxes: containment, derivatives by two routes, and no finite answer where one is undefined.

proofs/box_program.md.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import ends, holds, to_fmpq
from witnesses.expressions import mp, value_of

from gspot_verified.expansion.series.terms import NumberTerms
from gspot_verified.functions.box_program import BoxProgram, common, power, root, square
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
from gspot_verified.functions.straight_line import StraightLine
from gspot_verified.numbers.balls import working_bits

X, Y = Variable(0), Variable(1)
DIMENSION = 2
UNIT = st.integers(-8, 8).map(lambda n: Fraction(n, 8))


def number(value: int | Fraction) -> Constant:
    return Constant(to_fmpq(Fraction(value)))


def box_of(sides: list[tuple[Fraction, Fraction]]) -> list[arb]:
    """Balls around (centre, radius); dyadic, so they hold exactly these intervals and perhaps a little more."""
    return [arb(to_fmpq(centre)) + arb(0, arb(to_fmpq(radius))) for centre, radius in sides]


LEAVES = st.one_of(st.sampled_from([X, Y]), st.integers(-3, 3).map(number), UNIT.map(number))


def grown(parts: st.SearchStrategy[Expression]) -> st.SearchStrategy[Expression]:
    return st.one_of(
        st.lists(parts, min_size=1, max_size=3).map(lambda terms: Sum(tuple(terms))),
        st.builds(Product, parts, parts),
        st.builds(Power, parts, st.sampled_from([fmpq(n) for n in (0, 1, 2, 3, 5)])),
        parts.map(Sine),
        parts.map(Cosine),
        parts.map(lambda e: Exponential(Sine(e))),
        parts.map(lambda e: Logarithm(Sum((number(2), Sine(e))))),
        parts.map(lambda e: Power(Sum((number(2), Sine(e))), fmpq(-2))),
        parts.map(lambda e: Power(Sum((number(2), Cosine(e))), fmpq(-3, 2))),
        parts.map(lambda e: Power(Sum((number(3), Cosine(e))), fmpq(2, 3))),
    )


FUNCTIONS = st.recursive(LEAVES, grown, max_leaves=8)


def near(ball: arb, value: Any) -> bool:
    """Whether the finite ball, widened by the error of the reference, holds it."""
    lower, upper = ends(ball)
    exact = Fraction(int(mpmath.floor(value * 2**300)), 2**300)
    slack = (abs(exact) + 1) / 2**150
    return lower - slack <= exact <= upper + slack


@settings(deadline=None, max_examples=150)
@given(FUNCTIONS, st.tuples(UNIT, UNIT), st.tuples(UNIT, UNIT), st.tuples(UNIT, UNIT))
def test_values_and_mean_values_hold_the_function(
    function: Expression,
    centre: tuple[Fraction, Fraction],
    radii: tuple[Fraction, Fraction],
    inside: tuple[Fraction, Fraction],
) -> None:
    at = [c + abs(r) * s for c, r, s in zip(centre, radii, inside, strict=True)]
    with working_bits(53), mpmath.workprec(400):
        box = box_of([(c, abs(r)) for c, r in zip(centre, radii, strict=True)])
        program = BoxProgram([function], DIMENSION)
        value = value_of(function, [mp(to_fmpq(x)) for x in at])
        for found in (program.values(box), program.mean_values(box), program.gradients(box)[0]):
            if found[0].is_finite():  # exp(sin) of wide sides, powers of them: finite, but a product may overflow
                assert near(found[0], value)
        (point,) = program.values(box_of([(x, Fraction(0)) for x in at]))
        assert near(point, value)


@settings(deadline=None, max_examples=100)
@given(FUNCTIONS, st.tuples(UNIT, UNIT))
def test_partial_derivatives_agree_with_first_order_power_series(
    function: Expression, centre: tuple[Fraction, Fraction]
) -> None:
    with working_bits(120):
        box = box_of([(c, Fraction(0)) for c in centre])
        _, rows = BoxProgram([function], DIMENSION).gradients(box)
        series = SeriesOfFunctions([function], NumberTerms(BALLS), BALLS)
        series.extend(box)
        for j in range(DIMENSION):
            series.extend([arb(int(i == j)) for i in range(DIMENSION)])
            by_series = series[function][1]
            series.drop_last()
            assert rows[0][j].is_finite()
            assert by_series.is_finite()
            assert rows[0][j].overlaps(by_series)
            assert rows[0][j].rad() < (1 + abs(by_series)) * arb(2) ** -60


@settings(deadline=None, max_examples=60)
@given(FUNCTIONS, st.tuples(UNIT, UNIT), UNIT)
def test_partial_derivatives_on_a_box_hold_those_at_its_points(
    function: Expression, centre: tuple[Fraction, Fraction], inside: Fraction
) -> None:
    program = BoxProgram([function], DIMENSION)
    with working_bits(80):
        _, rows = program.gradients(box_of([(c, Fraction(1, 16)) for c in centre]))
        _, exact_rows = program.gradients(box_of([(c + inside / 16, Fraction(0)) for c in centre]))
        for wide, narrow in zip(rows[0], exact_rows[0], strict=True):
            if wide.is_finite():
                assert narrow.is_finite()
                assert wide.overlaps(narrow)
                assert wide.rad() >= narrow.rad()


UNDEFINED = {
    "division by a ball with zero": Power(X, fmpq(-1)),
    "an even negative power": Power(X, fmpq(-2)),
    "square root": Power(X, fmpq(1, 2)),
    "cube root": Power(X, fmpq(1, 3)),
    "power 3/2": Power(X, fmpq(3, 2)),
    "power -1/2": Power(X, fmpq(-1, 2)),
    "zero times an undefined part": Product(Constant(fmpq(0)), Power(X, fmpq(-1))),
    "an undefined part that cancels": Sum((Power(X, fmpq(-1)), -Power(X, fmpq(-1)))),
    "within a sine": Sine(Power(X, fmpq(-1))),
    "squared": Power(Power(X, fmpq(-1)), fmpq(2)),
}


@pytest.mark.parametrize("function", UNDEFINED.values(), ids=UNDEFINED)
@pytest.mark.parametrize("side", [arb(0), arb(0, 1), arb(-2, 1), arb(1, 1), arb("-1e-30", "1e-20")], ids=str)
def test_where_a_hypothesis_fails_nothing_finite_is_said(function: Expression, side: arb) -> None:
    negative_but_no_root = side < 0
    if not negative_but_no_root:
        program = BoxProgram([function, Y], DIMENSION)
        values, rows = program.gradients([side, arb(1)])
        assert not program.values([side, arb(1)])[0].is_finite()
        assert not values[0].is_finite()
        assert not rows[0][0].is_finite()
        assert not program.mean_values([side, arb(1)])[0].is_finite()
        assert values[1] == 1  # the other functions are not touched


@pytest.mark.parametrize("exponent", [fmpq(1, 2), fmpq(1, 3), fmpq(-1, 2), fmpq(-5, 3)])
def test_no_root_of_a_negative_number(exponent: fmpq) -> None:
    assert not BoxProgram([Power(X, exponent)], 1).values([arb(-3)])[0].is_finite()


def test_a_ball_that_is_not_finite_stays_so() -> None:
    function = Sum((Power(X, fmpq(2)), Sine(X), Product(X, Y)))
    for side in (arb.nan(), arb(0) + arb.pos_inf()):
        assert not BoxProgram([function], 2).values([side, arb(0)])[0].is_finite()


@given(st.integers(-40, 40), st.integers(0, 40), st.integers(-40, 40))
def test_a_square_holds_all_squares_and_hardly_more(middle: int, radius: int, part: int) -> None:
    value = square(arb(middle) + arb(0, radius))
    inside = middle + Fraction(radius * part, 40)
    assert holds(value, inside * inside)
    lower, _ = ends(value)
    if radius >= abs(middle):
        assert lower >= -Fraction(1, 1000)


def test_common_part_holds_what_both_hold() -> None:
    assert holds(common(arb(0, 1), arb(1, 1)), Fraction(1, 2))
    assert common(arb(0, 3), arb(1, 1)).overlaps(arb(1))
    assert ends(common(arb(0, 3), arb(1))) == (1, 1)
    assert ends(common(arb(1), arb(0, 3))) == (1, 1)


def test_roots_and_powers_of_positive_balls() -> None:
    assert holds(root(arb(4)), 2)
    assert holds(power(arb(8), 2, 3), 4)
    assert not root(arb.nan()).is_finite()
    assert not power(arb.nan(), 1, 3).is_finite()


def test_powers_below_one_are_powers_too() -> None:
    with working_bits(64):
        found = power(arb("0.25"), 3, 2)
        assert found.is_finite()
        assert found.contains(arb("0.125"))
        assert found.rad() < arb("1e-15")


def test_the_code_of_equal_texts_is_kept() -> None:
    x = Variable(0)
    first, second = (BoxProgram([x * x + Constant(fmpq(1, 3))], 1) for _ in range(2))
    values = [program.values([arb(2)])[0] for program in (first, second)]
    assert all(value.contains(arb(13) / 3) for value in values)
    assert first._functions["values"].__code__ is second._functions["values"].__code__
    other = BoxProgram([x * x + Constant(fmpq(1, 7))], 1)  # the same text with other constants
    assert other.values([arb(2)])[0].contains(arb(29) / 7)


def test_what_is_computed_twice_is_one_value() -> None:
    code = StraightLine()
    one, other = (Sine(Sum((X, Y))) * Cosine(Sum((Y, X))) for _ in range(2))
    assert code.value(one) == code.value(other)
    assert len(code.lines([code.value(one)])) == 5  # the sum, the pair, sine, cosine, their product


def test_a_large_graph_of_equal_but_separate_parts_is_read_in_time() -> None:
    def tower(height: int) -> Expression:
        node: Expression = X
        for _ in range(height):
            node = Sine(node) + Sine(node)
        return node

    code = StraightLine()
    assert code.value(tower(200)) == code.value(tower(200))


def test_precision_is_the_one_in_force_at_the_call() -> None:
    program = BoxProgram([Constant(fmpq(1, 3)) * X], 1)
    for bits in (30, 300, 60, 300):
        with working_bits(bits):
            (third,) = program.values([arb(1)])
        assert bits - 5 <= third.rel_accuracy_bits() <= bits + 5
        assert holds(third, Fraction(1, 3))


def test_which_components_count() -> None:
    assert BoxProgram([X * X, Sine(Y), number(3), X * Y], 3).depends == [
        frozenset({0}), frozenset({1}), frozenset(), frozenset({0, 1}),
    ]  # fmt: skip


def test_bad_input_is_named() -> None:
    with pytest.raises(ValueError, match="component 4 of a state of 2 components"):
        BoxProgram([Variable(4)], 2)
    with pytest.raises(TypeError, match="constant of type str"):
        BoxProgram([Constant("chi")], 1)
    with pytest.raises(TypeError, match="no enclosure of a Expression"):
        BoxProgram([Expression()], 1)
