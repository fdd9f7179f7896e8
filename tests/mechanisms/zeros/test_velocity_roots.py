"""Quadratics in closed form: all roots, no bound, and nothing said where the balls leave the number of roots open.

proofs/all_g_spots.md, section 4.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import assume, given
from hypothesis import strategies as st
from samples.strategies import ends, holds, to_fmpq

from gspot_verified.functions.expressions import Constant, Expression, Sine, Variable
from gspot_verified.mechanisms.zeros.velocity_roots import VelocityRoots, quadratic_roots
from gspot_verified.numbers.balls import working_bits

NUMBER = st.fractions(-20, 20, max_denominator=12)
Q, V, W = Variable(0), Variable(1), Variable(2)


def c(value: int | Fraction) -> Constant:
    return Constant(to_fmpq(Fraction(value)))


@given(NUMBER, NUMBER, NUMBER)
def test_both_roots_of_a_product_of_linear_factors(a: Fraction, first: Fraction, second: Fraction) -> None:
    assume(a != 0 and abs(first - second) > Fraction(1, 10**6))
    coefficients = (a, -a * (first + second), a * first * second)
    found = quadratic_roots(*(arb(to_fmpq(value)) for value in coefficients))
    assert found.open is None
    low, high = sorted([first, second])
    assert holds(found.points[0], low)
    assert holds(found.points[1], high)
    assert ends(found.points[0])[1] < ends(found.points[1])[0]


@given(NUMBER, NUMBER)
def test_a_double_root_is_never_none(a: Fraction, root: Fraction) -> None:
    assume(a != 0)
    found = quadratic_roots(arb(to_fmpq(a)), arb(to_fmpq(-2 * a * root)), arb(to_fmpq(a * root * root)))
    assert found.open
    assert found.points == ()
    assert found.near is not None
    assert holds(found.near, root)


def test_degenerate_quadratics() -> None:
    assert holds(quadratic_roots(arb(0), arb(2), arb(3)).points[0], Fraction(-3, 2))
    assert quadratic_roots(arb(0), arb(0), arb(1)).open is None
    assert quadratic_roots(arb(0), arb(0), arb(1)).points == ()
    assert quadratic_roots(arb(0), arb(0), arb(0)).open
    assert quadratic_roots(arb(0, 1), arb(1), arb(1)).open
    assert quadratic_roots(arb(0), arb(0, 1), arb(1)).open
    assert quadratic_roots(arb(1), arb(0), arb(0, "1e-20")).open
    assert quadratic_roots(arb.nan(), arb(1), arb(1)).open
    assert quadratic_roots(arb(1), arb.nan(), arb(1)).open
    assert quadratic_roots(arb(1), arb(1), arb.nan()).open


def test_one_affine_and_one_quadratic_condition() -> None:
    # 2 v - w + q = 0 and v^2 + v w - 2 = 0 at q = 1: w = 2 v + 1, 3 v^2 + v - 2 = 0: v = 2/3, -1.
    functions: list[Expression] = [c(2) * V - W + Q, V * V + V * W - c(2)]
    closed = VelocityRoots.of(functions, 3, [1, 2])
    assert closed is not None
    found = closed.all_roots([arb(1), arb(0), arb(0)])
    assert found.open is None
    pairs = sorted((point for point in found.points), key=lambda point: float(point[0]))
    assert holds(pairs[0][0], -1)
    assert holds(pairs[0][1], -1)
    assert holds(3 * pairs[1][0], 2)
    assert holds(3 * pairs[1][1], 7)


def test_affine_conditions_alone() -> None:
    closed = VelocityRoots.of([V + W - Q, V - W], 3, [1, 2])
    assert closed is not None
    (point,) = closed.all_roots([arb(4), arb(0), arb(0)]).points
    assert holds(point[0], 2)
    assert holds(point[1], 2)
    dependent = VelocityRoots.of([V + W - Q, V + W], 3, [1, 2])
    assert dependent is not None
    assert dependent.all_roots([arb(4), arb(0), arb(0)]).open


@pytest.mark.parametrize(
    "functions",
    [[V * V - Q, W * W - V], [Sine(V) - Q, W], [V * V * V - Q, W], [V * V * W - Q, W], [V * V - Q]],
    ids=["two quadratics", "a sine", "a cube", "a product of three", "fewer conditions than unknowns"],
)
def test_other_forms_are_not_solved_so(functions: list[Expression]) -> None:
    assert VelocityRoots.of(functions, 3, [1, 2]) is None


@given(st.integers(-30, 30), st.integers(1, 30))
def test_roots_for_a_ball_of_coefficients_hold_those_of_each(inside: int, size: int) -> None:
    radius = Fraction(size, 1000)
    q = 2 + radius * Fraction(inside, 30)
    closed = VelocityRoots.of([V * V - Q], 2, [1])
    assert closed is not None
    wide = closed.all_roots([arb(2) + arb(0, arb(to_fmpq(radius))), arb(0)])
    exact = closed.all_roots([arb(fmpq(q.numerator, q.denominator)), arb(0)])
    for one, other in zip(wide.points, exact.points, strict=True):
        low, high = ends(other[0])
        assert holds(one[0], low)
        assert holds(one[0], high)


@pytest.mark.parametrize("distance", [10, 20, 30, 60])
def test_where_two_roots_are_not_told_apart_the_place_holds_both(distance: int) -> None:
    """(s - 1)(s - 1 - d) with a coefficient that is known to d only: both roots lie in the place that is named."""
    gap = Fraction(1, 2**distance)
    for slack in (gap, gap * gap, Fraction(1, 2**45)):
        blur = arb(0, arb(to_fmpq(slack)))
        found = quadratic_roots(arb(1), arb(to_fmpq(-2 - gap)), arb(to_fmpq(1 + gap)) + blur)
        if found.open is None:
            assert holds(found.points[0], 1)
            assert holds(found.points[1], 1 + gap)
        else:
            assert found.near is not None
            assert holds(found.near, 1)
            assert holds(found.near, 1 + gap)


@pytest.mark.parametrize("middle", [arb(0), arb(0, "0.01")])
@pytest.mark.parametrize("a", [1, -1])
def test_without_a_linear_term_the_roots_are_opposite(middle: arb, a: int) -> None:
    """a (s^2 - 4) with a linear coefficient that is 0, or may have either sign."""
    found = quadratic_roots(arb(a), middle, arb(-4 * a))
    assert found.open is None
    assert [holds(point, root) for point, root in zip(found.points, (-2, 2), strict=True)] == [True, True]
    assert ends(found.points[0])[1] < 0 < ends(found.points[1])[0]


@pytest.mark.parametrize(
    ("coefficients", "facts"),
    [
        ((1, -3, 2), ["0 < 1", "0 < 1", "1.00000 < 2.00000"]),
        ((-1, 3, -2), ["-1.00000 < 0", "0 < 1", "1.00000 < 2.00000"]),
        ((1, 0, 1), ["0 < 1", "-4.00000 < 0"]),
        ((0, 2, 3), ["0 = 0", "0 < 2"]),
        ((0, 0, -1), ["0 = 0", "0 = 0", "-1.00000 < 0"]),
    ],
)
def test_each_number_of_roots_has_its_comparisons(coefficients: tuple[int, ...], facts: list[str]) -> None:
    found = quadratic_roots(*map(arb, coefficients))
    assert found.open is None
    assert found.shown is not None
    assert [fact.replace(".00000", "") for fact in found.shown.facts] == [fact.replace(".00000", "") for fact in facts]


@pytest.mark.parametrize("coefficients", [(0, 0, 0), ("0 +/- 1", 1, 1), (0, "0 +/- 1", 1), ("nan", 1, 1)])
def test_an_open_form_shows_nothing(coefficients: tuple[str | int, ...]) -> None:
    found = quadratic_roots(*map(arb, coefficients))
    assert found.open
    assert found.shown is None


def test_a_regular_system_shows_its_determinant() -> None:
    """2 x - 3 = 0 and x + y = 0; beside it a quadratic function on the line of the affine one."""
    x, y = Variable(0), Variable(1)
    affine = [Constant(fmpq(2)) * x - Constant(fmpq(3)), x + y]
    closed = VelocityRoots.of(affine, 2, (0, 1))
    assert closed is not None
    shown = closed.all_roots([arb(0), arb(0)]).shown
    assert shown is not None
    assert shown.facts == ("0 != 2.00000",)
    mixed = VelocityRoots.of([affine[1], x * y + Constant(fmpq(1))], 2, (0, 1))
    assert mixed is not None
    found = mixed.all_roots([arb(0), arb(0)])
    assert len(found.points) == 2
    assert found.shown is not None
    assert found.shown.facts[0] == "0 != 1.00000"
    assert len(found.shown.facts) == 4


@pytest.mark.parametrize("sign", [1, -1])
def test_a_small_root_beside_a_large_one_is_as_narrow(sign: int) -> None:
    """s^2 - sign (10^12 + 10^-12) s + 1, with the roots sign 10^12 and sign 10^-12: a difference leaves no digit."""
    with working_bits(100):
        found = quadratic_roots(arb(1), -sign * (arb(10) ** 12 + arb(10) ** -12), arb(1))
        small, large = found.points if sign == 1 else found.points[::-1]
        for root, power in ((small, -12), (large, 12)):
            assert root.overlaps(sign * arb(10) ** power)
            assert root.rad() < abs(root) * arb(10) ** -25


def test_one_quadratic_condition_alone_needs_no_determinant() -> None:
    closed = VelocityRoots.of([V * V - Q], 2, [1])
    assert closed is not None
    found = closed.all_roots([arb(4), arb(0)])
    assert found.shown is not None
    assert found.shown.facts == ("0 < 1.00000", "0 < 16.0000", "-2.00000 < 2.00000")
