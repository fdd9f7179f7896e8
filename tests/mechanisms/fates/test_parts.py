"""Orbits, strips and boxes of starts one by one, with the exact solution beside them (proofs/fates.md)."""

from __future__ import annotations

from dataclasses import fields, replace
from functools import cache

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.fates.fate_piece import StartBox, blocks
from gspot_verified.mechanisms.fates.planar_flow import PlanarFlow
from gspot_verified.mechanisms.fates.prepared import _side
from gspot_verified.mechanisms.fates.reference import Reference, reference
from gspot_verified.mechanisms.fates.starts import Starts
from gspot_verified.mechanisms.fates.strip import region_of, strip
from gspot_verified.mechanisms.fates.trajectory_side import TrajectorySide
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.g_spot import place_in, prove_near
from gspot_verified.mechanisms.sweep.sweep_grid import Grid, axes_of
from gspot_verified.numbers.balls import working_bits

BITS = 53


@cache
def model() -> tuple[PlanarFlow, TrajectorySide]:
    """alpha_1 = alpha_2 = -1, beta = 3/2: b = -2 p + C p^(3/2) on every orbit, du/dp = -b/p."""
    with working_bits(BITS):
        shifted = shift(shipped_mechanism("model system"))
        plane = PlanarFlow(shifted)
        side = _side(plane, plane.of_state(prove_near(shifted, place_in(shifted, BALLS), BITS).system.point))
        assert side is not None
        return plane, side


@cache
def orbit(b: str) -> Reference:
    plane, side = model()
    with working_bits(BITS):
        found = reference(plane, 1, side, [arb("0.5"), arb(b)])
    assert found is not None
    return found


def b_of(p: arb, start: str) -> arb:
    return -2 * p + (arb(start) + 1) * (p / arb("0.5")) ** arb("1.5")


@pytest.mark.parametrize(("start", "sign"), [("-1.25", -1), ("-0.875", 1)])
def test_an_orbit_is_the_exact_solution(start: str, sign: int) -> None:
    found = orbit(start)
    with working_bits(BITS):
        assert found.sign == sign
        assert found.end.overlaps(found.start * (-found.segments[-1].end_time).exp())
        for value in ("0.4375", "0.25", "0.0625"):
            p = arb(value)
            assert found.place(p).is_finite()
            assert found.place(p).overlaps(b_of(p, start))
            assert found.place(arb(value, "0.01")).contains(b_of(p, start))
            assert found.steepness(p).overlaps(-2 + arb("1.5") * (b_of(p, start) + 2 * p) / p)
        assert not found.place(arb("0.5", "0.01")).is_finite()  # it begins at 1/2
        assert not found.place(found.end / 2).is_finite()


def test_an_orbit_on_the_distinguished_trajectory_has_no_sign() -> None:
    plane, side = model()
    with working_bits(BITS):
        assert reference(plane, 1, side, [arb("0.5"), arb(-1)]) is None
        assert reference(plane, 1, side, [arb("-0.5"), arb(-1)]) is None


def test_a_strip_holds_the_orbits_between() -> None:
    plane, side = model()
    below, above = orbit("-1.25"), orbit("-0.875")
    with working_bits(BITS):
        knots = [arb(0.49 * 0.75**k) for k in range(13)]
        found = strip(plane, below, above, side, knots)
        assert len(found.slices) == 12
        for part in found.slices:
            for start in ("-1.2", "-1", "-0.9"):
                p = (part.lower + part.upper) / 2
                assert part.box[0].contains(p)
                assert part.box[1].contains(b_of(p, start))
                c = (arb(start) + 1) / arb("0.5") ** arb("1.5")
                fall = 2 * (part.upper - part.lower)
                fall = fall - c / arb("1.5") * (part.upper ** arb("1.5") - part.lower ** arb("1.5"))
                assert part.drop.contains(fall)
            assert part.presses is not None
            assert part.opens is None


class OnAnotherSheet(Reference):
    """An orbit with the same p and places, at other points of the plane: p is no coordinate there together with it."""

    def states(self, p: arb) -> list[arb]:
        first, place = super().states(p)
        return [first + 3, place]


@pytest.mark.parametrize("which", ["below", "above"])
def test_orbits_that_do_not_lie_in_the_region_bound_nothing(which: str) -> None:
    plane, side = model()
    orbits = {"below": orbit("-1.25"), "above": orbit("-0.875")}
    with working_bits(BITS):
        found = strip(plane, orbits["below"], orbits["above"], side, [arb(0.49 * 0.75**k) for k in range(4)])
        assert region_of(plane, 1, [found]) is not None
        own = {each.name: getattr(orbits[which], each.name) for each in fields(Reference)}
        assert region_of(plane, 1, [replace(found, **{which: OnAnotherSheet(**own)})]) is None


def test_starts_on_the_contact() -> None:
    with working_bits(BITS):
        shifted = shift(shipped_mechanism("rod_with_wrist"))
        starts = Starts(shifted, {"X": 0, "X_dot": 5}, ["theta", "theta_dot"])
        found = starts.whole([fmpq(7, 10), fmpq(3)], [fmpq(8, 10), fmpq(4)])
        assert found is not None
        for theta, rate in (("0.7", "3"), ("0.8", "4"), ("0.75", "3.5")):
            th, w = arb(theta), arb(rate)
            for side, exact in zip(found, (arb(0), th.sin(), th, arb(5), th.cos() * w, w), strict=True):
                assert side.is_finite()
                assert side.overlaps(exact)


@given(st.integers(1, 40), st.integers(1, 40))
def test_blocks_cover_the_grid_and_halves_their_box(first: int, second: int) -> None:
    grid = Grid(axes_of({"p": f"0..1:{first}", "b": f"0..1:{second}"}))
    assert sum(box.cells[0] * box.cells[1] for box in blocks(grid)) == first * second
    box = blocks(grid)[-1]
    sides = (fmpq(1, first), fmpq(1, second))
    waiting, small = [box], list[StartBox]()
    while waiting:
        each = waiting.pop()
        assert tuple((high - low) / side for low, high, side in zip(each.lower, each.upper, sides, strict=True)) == (
            each.cells
        )
        (small if each.small else waiting).extend([each] if each.small else each.halves(sides))
    assert len(small) == box.cells[0] * box.cells[1]
    low, high = small[0].halves(sides)
    assert (low.lower, high.upper) == (small[0].lower, small[0].upper)


def test_slip_between_two_orbits_falls_by_what_the_solution_says_at_most() -> None:
    """u falls by 2 p - C/(3/2) p^(3/2) from p down to 0, exactly: less than that is no bound."""
    plane, side = model()
    below, above = orbit("-1.25"), orbit("-0.875")
    with working_bits(BITS):
        found = strip(plane, below, above, side, [arb(0.49 * 0.75**k) for k in range(15)])
        assert found.end is not None
        p = arb(0.49 * 0.75**14)
        for start in ("-1.25", "-1", "-0.875"):
            c = (arb(start) + 1) / arb("0.5") ** arb("1.5")
            assert found.rest >= abs(2 * p - c / arb("1.5") * p ** arb("1.5"))
        # Where the orbits are not followed nothing is known, at the begin and at the end.
        for knots in ([0.6, 0.45, 0.3], [0.4, 0.2, float(below.end.mid()) / 2]):
            short = strip(plane, below, above, side, [arb(knot) for knot in knots])
            assert short.end is None
            assert len(short.slices) == (0 if knots[0] > 0.5 else 1)


def test_p_and_the_place_must_be_coordinates() -> None:
    """With p itself as the place nothing of the other component is known."""
    plane, side = model()
    with working_bits(BITS):
        found = strip(plane, orbit("-1.25"), orbit("-0.875"), side, [arb("0.49"), arb("0.4")])
        assert region_of(plane, 1, [found]) is not None
        assert region_of(plane, 0, [found]) is None
        assert region_of(plane, 1, [replace(found, slices=())]) is None
