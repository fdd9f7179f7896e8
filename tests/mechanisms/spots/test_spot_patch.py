"""Patches of curves and surfaces of zeros: over every value of the parameters exactly one zero, or no patch.

Page: proofs/all_g_spots.md, section 6.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq
from samples.strategies import ends, holds

from gspot_verified.functions.expressions import Constant, Expression, Sine, Variable
from gspot_verified.mechanisms.spots import spot_patch
from gspot_verified.mechanisms.spots.spot_patch import Graph, find_patch
from gspot_verified.numbers.balls import working_bits

X, Y, Z, W = (Variable(i) for i in range(4))
ONE = Constant(fmpq(1))


def circle_holds(patch: Graph) -> None:
    """Over each end of the parameter's interval x^2 + y^2 = 1 has exactly one solution in the box."""
    ((along, side),) = patch.parameters.items()
    ((solved, box),) = patch.box.items()
    assert {along, solved} == {0, 1}
    low, high = ends(side)
    assert 0 < high - low < Fraction(1, 4)
    for value in (low, (low + high) / 2, high):
        with working_bits(100):
            root = (1 - arb(fmpq(value.numerator, value.denominator)) ** 2).sqrt()
            assert box.contains(root) != box.contains(-root)


@pytest.mark.parametrize("place", [("1.2", "0.3"), ("0.3", "-1.2"), ("-0.9", "-0.5"), ("0.1", "0.1"), ("-3", "4")])
def test_a_circle_near_any_place(place: tuple[str, str]) -> None:
    patch = find_patch([X * X + Y * Y - ONE], [0, 1], [arb(value) for value in place])
    assert patch is not None
    circle_holds(patch)


def test_the_component_that_changes_least_is_the_parameter() -> None:
    """Near (1, 0) x is no function of y's direction that one may solve y for: x is solved for, y is the parameter."""
    patch = find_patch([X * X + Y * Y - ONE], [0, 1], [arb(1), arb("0.01")])
    assert patch is not None
    assert list(patch.box) == [0]
    assert list(patch.parameters) == [1]


def test_a_curve_in_space() -> None:
    """x = sin(z), y = x^2 + z/10: two are solved for; at the ends of z the other two are known."""
    functions: list[Expression] = [X - Sine(Z), Y - X * X - Constant(fmpq(1, 10)) * Z]
    patch = find_patch(functions, [0, 1, 2], [arb(1), arb(1), arb(1)])
    assert patch is not None
    assert len(patch.parameters) == 1
    assert sorted([*patch.parameters, *patch.box]) == [0, 1, 2]
    assert 2 in patch.parameters
    for end in ends(patch.parameters[2]):
        with working_bits(100):
            z = arb(fmpq(end.numerator, end.denominator))
            assert patch.box[0].contains(z.sin())
            assert patch.box[1].contains(z.sin() ** 2 + z / 10)


def test_other_components_keep_their_balls() -> None:
    """x = y + w for every w in the ball: the patch holds the zeros of both ends of w."""
    patch = find_patch([X - Y * Y * Y - W], [0, 1], [arb(1), arb(1), arb(0), arb("0.5", "0.01")])
    assert patch is not None
    (side,) = patch.parameters.values()
    (box,) = patch.box.values()
    for w in (Fraction(49, 100), Fraction(51, 100)):
        value = sum(ends(side), Fraction(0)) / 2
        if 0 in patch.box:
            assert holds(box, value**3 + w)
        else:
            low, high = ends(box)
            assert low**3 + w < value < high**3 + w


@pytest.mark.parametrize(
    "function",
    [X * X + Y * Y, X * Y, (X - Y) * (X - Y), X * X + Y * Y + ONE, ONE + Constant(fmpq(0)) * X],
    ids=["a point", "a cross", "a double line", "nothing", "a constant"],
)
def test_no_patch_where_zeros_form_no_smooth_curve(function: Expression) -> None:
    for place in (("0.25", "0.25"), ("0.125", "0.125")):
        assert find_patch([function], [0, 1], [arb(value) for value in place]) is None


def test_dependent_functions_have_no_patch() -> None:
    plane = X + Y + Z - ONE
    assert find_patch([plane, plane * plane + plane], [0, 1, 2], [arb(1), arb(0), arb("0.1")]) is None
    assert find_patch([X - Y], [0, 1], [arb("nan"), arb(0)]) is None


def test_the_place_is_a_free_choice_and_the_proof_is_not(monkeypatch: pytest.MonkeyPatch) -> None:
    """With a wrong place, or the wrong component to solve for, nothing is proved."""
    circle: list[Expression] = [X * X + Y * Y - ONE]
    for point, solved in (({0: arb(3), 1: arb(3)}, [0]), ({0: arb(1), 1: arb(0)}, [1])):
        monkeypatch.setattr(spot_patch, "_point_near", lambda *_, found=(point, solved): found)
        assert find_patch(circle, [0, 1], [arb(1), arb(0)]) is None
    monkeypatch.setattr(spot_patch, "_point_near", lambda *_: ({0: arb("0.6"), 1: arb("0.8")}, [1]))
    patch = find_patch(circle, [0, 1], [arb(1), arb(0)])
    assert patch is not None
    assert list(patch.box) == [1]
    circle_holds(patch)
