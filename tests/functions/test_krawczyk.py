"""Krawczyk's test: it finds what is there, and shows nothing where its hypotheses fail.

Page: proofs/krawczyk.md.
"""

from __future__ import annotations

import pytest
from flint import arb

from gspot_verified.functions.krawczyk import krawczyk, krawczyk_operator, strictly_inside
from gspot_verified.numbers.balls import working_bits


def square(box: list[arb]) -> list[arb]:
    return [box[0] * box[0] - 2]


def slope(box: list[arb]) -> list[list[arb]]:
    return [[2 * box[0]]]


@pytest.mark.parametrize("bits", [53, 128, 500])
def test_square_root_of_two(bits: int) -> None:
    with working_bits(bits):
        found = krawczyk(square, slope, [arb("1.4", "0.05")])
        assert found is not None
        assert found[0].is_finite()
        assert found[0].contains(arb(2).sqrt())
        assert strictly_inside(found[0], arb("1.4", "0.05"))


@pytest.mark.parametrize(
    "box", [arb("1.6", "0.01"), arb("1.3", "0.05"), arb(0, 2), arb("1.4", 2), arb("nan"), arb(0, "inf")]
)
def test_nothing_is_shown(box: arb) -> None:
    """No root, the root outside, two roots, a box too wide, no information."""
    with working_bits(80):
        assert krawczyk(square, slope, [box]) is None


def test_a_double_root_is_never_shown() -> None:
    with working_bits(100):
        for radius in ("0.1", "0.001", "1e-9"):
            found = krawczyk(lambda x: [x[0] * x[0]], lambda x: [[2 * x[0]]], [arb(0, radius)])
            assert found is None


def test_two_unknowns() -> None:
    """x^2 + y^2 = 25, x y = 12 near (3, 4)."""
    with working_bits(100):
        found = krawczyk(
            lambda q: [q[0] * q[0] + q[1] * q[1] - 25, q[0] * q[1] - 12],
            lambda q: [[2 * q[0], 2 * q[1]], [q[1], q[0]]],
            [arb("3.001", "0.01"), arb("3.999", "0.01")],
        )
        assert found is not None
        assert found[0].contains(3)
        assert found[1].contains(4)


@pytest.mark.parametrize("outside", [0, 1])
def test_every_side_must_shrink(outside: int) -> None:
    """x^2 = 2 and y^2 = 2 are two equations for themselves: one box holds its root, the other none."""
    box = [arb("1.4", "0.05"), arb("1.4", "0.05")]
    with working_bits(80):

        def both(q: list[arb]) -> list[arb]:
            return [q[0] * q[0] - 2, q[1] * q[1] - 2]

        def slopes(q: list[arb]) -> list[list[arb]]:
            return [[2 * q[0], arb(0)], [arb(0), 2 * q[1]]]

        assert krawczyk(both, slopes, box) is not None
        box[outside] = arb("1.6", "0.05")
        assert krawczyk(both, slopes, box) is None


def test_a_refused_value_shows_nothing() -> None:
    def refuse(box: list[arb]) -> list[list[arb]]:
        raise ValueError(f"a base may vanish on {box}")

    with working_bits(80):
        assert krawczyk(square, refuse, [arb("1.4", "0.05")]) is None


def test_strictly_inside() -> None:
    assert strictly_inside(arb(0, 1), arb(0, 2))
    assert not strictly_inside(arb(0, 1), arb(0, 1))
    assert not strictly_inside(arb("nan"), arb(0, 1))
    assert not strictly_inside(arb(0, 1), arb("nan"))
    assert not strictly_inside(arb(0, 1), arb(0, "inf"))  # no compact box: the proof takes the widths of its sides
    assert not strictly_inside(arb(0, "inf"), arb(0, 1))


@pytest.mark.parametrize("nothing", [arb("nan"), arb(0, "inf")])
def test_the_operator_gives_finite_boxes_only(nothing: arb) -> None:
    one, box = [[arb(1)]], [arb(0, 1)]
    assert krawczyk_operator([arb(0)], one, one, box) is not None
    assert krawczyk_operator([nothing], one, one, box) is None
    assert krawczyk_operator([arb(0)], [[nothing]], one, box) is None
    assert krawczyk_operator([arb(0)], one, [[arb(0)]], box) is None
