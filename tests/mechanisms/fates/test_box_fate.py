"""Which fate slices allow, and how a box of states lies between orbits, with exact values beside (proofs/fates.md)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.mechanisms.fates.box_fate import Fate, Frame, _between, _height, _in_frame, _in_strip, box_fate
from gspot_verified.mechanisms.fates.reference import Reference
from gspot_verified.mechanisms.fates.strip import Slice, Strip
from gspot_verified.numbers.balls import hull, working_bits
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Evidence

from .test_parts import BITS, b_of, model, orbit

STARTS = ("-1.25", "-1.125", "-0.875")  # b at p = 1/2 of three orbits; the distinguished trajectory has -1


def sure() -> Evidence:
    found = less(arb(0), arb(1))
    assert found is not None
    return found


def a_slice(lower: float, upper: float, drop: arb | float = 0, presses: bool = True, opens: bool = False) -> Slice:
    yes = sure()
    return Slice(arb(lower), arb(upper), (), arb(drop), yes if presses else None, yes if opens else None, yes)


def a_strip(*slices: Slice, signs: tuple[int, int] = (1, 1), end: bool = True, rest: float = 0) -> Strip:
    orbits = [replace(orbit("-0.875"), sign=sign) for sign in signs]
    return Strip(*orbits, slices, sure() if end else None, arb(rest))


def between(lower: float, upper: float) -> arb:
    return hull([arb(lower), arb(upper)])


@pytest.mark.parametrize(
    ("signs", "fate"), [((-1, -1), Fate.BELOW), ((1, 1), Fate.ABOVE), ((-1, 1), Fate.SPOT), ((1, -1), Fate.SPOT)]
)
def test_the_spot_is_reached_on_the_side_of_both_orbits(signs: tuple[int, int], fate: Fate) -> None:
    found = _in_strip(a_strip(a_slice(1, 2, 0.5), signs=signs, rest=0.25), arb(2), arb(1))
    assert found.fate is fate
    assert found.evidence is not None


@pytest.mark.parametrize(
    ("strip", "p", "slip", "fate"),
    [
        # Slip that falls by 1/2 to 3/4 on the whole slice.
        (a_strip(a_slice(1, 2, between(0.5, 0.75))), 2.0, 0.8125, Fate.ABOVE),
        (a_strip(a_slice(1, 2, between(0.5, 0.75))), 2.0, 0.625, Fate.UNDECIDED),
        (a_strip(a_slice(1, 2, between(0.5, 0.75))), 2.0, 0.4375, Fate.STOPS),
        # A box of slip velocities: the largest decides that slip stops, the least that it does not.
        (a_strip(a_slice(1, 2, 0.5)), 2.0, between(0.25, 0.4375), Fate.STOPS),
        (a_strip(a_slice(1, 2, 0.5)), 2.0, between(0.25, 0.5625), Fate.UNDECIDED),
        (a_strip(a_slice(1, 2, 0.5)), 2.0, between(0.5625, 2), Fate.ABOVE),
        # In a slice in which a state begins it may fall by nothing, or by all; one that rises there may not yet.
        (a_strip(a_slice(1, 2, 0.5)), 1.5, 0.4375, Fate.UNDECIDED),
        (a_strip(a_slice(1, 2, 0.5)), 1.5, 0.5625, Fate.ABOVE),
        (a_strip(a_slice(1, 2, -1), a_slice(0.5, 1, 0.5)), 1.5, 0.4375, Fate.UNDECIDED),
        (a_strip(a_slice(1, 2, -1), a_slice(0.5, 1, 0.5)), 2.0, 0.4375, Fate.ABOVE),
        # Slices above all states do not count; one that ends at the largest p does not either.
        (a_strip(a_slice(1, 2, 9), a_slice(0.5, 1, 0.5)), 1.0, 0.5625, Fate.ABOVE),
        (a_strip(a_slice(1, 2, 9), a_slice(0.5, 1, 0.5)), between(0.75, 1.25), 0.5625, Fate.UNDECIDED),
        # Slip that may have stopped does not go on, though it would rise later.
        (a_strip(a_slice(1, 2, between(0.5, 0.75)), a_slice(0.5, 1, -4)), 2.0, 0.625, Fate.UNDECIDED),
        # Within a slice slip may stop although it rises on the whole of it later: less than its way is asked.
        (a_strip(a_slice(1, 2, between(-1, 0.5))), 2.0, 0.4375, Fate.UNDECIDED),
        # The last stretch, where p vanishes.
        (a_strip(a_slice(1, 2, 0.5), rest=0.25), 2.0, 0.8125, Fate.ABOVE),
        (a_strip(a_slice(1, 2, 0.5), rest=0.25), 2.0, 0.75, Fate.UNDECIDED),
        (a_strip(a_slice(1, 2, 0.5), end=False), 2.0, 0.8125, Fate.UNDECIDED),
    ],
)  # fmt: skip
def test_slip_goes_on_or_stops(strip: Strip, p: float | arb, slip: float | arb, fate: Fate) -> None:
    assert _in_strip(strip, arb(p), arb(slip)).fate is fate


MAY_OPEN, OPEN = {"presses": False}, {"presses": False, "opens": True}


@pytest.mark.parametrize(
    ("slices", "p", "slip", "fate"),
    [
        ([a_slice(1, 2, **MAY_OPEN), a_slice(0.5, 1, **OPEN)], 2.0, 1.0, Fate.LIFT_OFF),
        ([a_slice(1, 2, **MAY_OPEN), a_slice(0.5, 1, **MAY_OPEN)], 2.0, 1.0, Fate.UNDECIDED),
        ([a_slice(1, 2, **MAY_OPEN), a_slice(0.5, 1)], 2.0, 1.0, Fate.UNDECIDED),
        # A box that reaches below the slice that opens: a state may begin there with b < 0.
        ([a_slice(1, 2, **MAY_OPEN), a_slice(0.5, 1, **OPEN)], between(0.5, 2), 1.0, Fate.UNDECIDED),
        ([a_slice(1, 2, **MAY_OPEN), a_slice(0.5, 1, **OPEN)], between(0.53125, 2), 1.0, Fate.LIFT_OFF),
        # Slip may stop before, or in the same slice: which comes first is open.
        ([a_slice(1, 2, 1), a_slice(0.5, 1, **OPEN)], 1.5, 0.5, Fate.UNDECIDED),
        ([a_slice(1, 2), a_slice(0.5, 1, 1, **OPEN)], 2.0, 0.5, Fate.UNDECIDED),
        ([a_slice(1, 2, 1), a_slice(0.5, 1, **OPEN)], 2.0, 0.5, Fate.STOPS),
        ([a_slice(1, 2, **MAY_OPEN), a_slice(0.5, 1, 1)], 2.0, 0.5, Fate.UNDECIDED),
        # Nothing after lift-off counts.
        ([a_slice(1, 2, 0.25, **OPEN), a_slice(0.5, 1, 9)], 2.0, 0.5, Fate.LIFT_OFF),
    ],
)  # fmt: skip
def test_lift_off_only_before_slip_may_stop(slices: list[Slice], p: float | arb, slip: float, fate: Fate) -> None:
    assert _in_strip(a_strip(*slices), arb(p), arb(slip)).fate is fate


@pytest.mark.parametrize(
    ("strip", "slip", "why"),
    [
        (a_strip(a_slice(1, 2, between(0.5, 0.75))), 0.625, "slip may stop"),
        (a_strip(a_slice(1, 2, **MAY_OPEN)), 2, "it may lift off"),
        (a_strip(a_slice(1, 2, 1, **MAY_OPEN)), 0.5, "which comes first"),
        (a_strip(a_slice(1, 2), rest=1), 0.5, "slip may stop where p vanishes"),
        (a_strip(a_slice(1, 2), end=False), 0.5, "not followed so far"),
    ],
)
def test_an_open_fate_says_why(strip: Strip, slip: float, why: str) -> None:
    found = _in_strip(strip, arb(2), arb(slip))
    assert found.fate is Fate.UNDECIDED
    assert why in found.why


def test_what_is_not_shown_shows_no_fate() -> None:
    """Finite numbers first: a drop that is not finite is no bound, in whatever place it stands."""
    wild = a_strip(a_slice(1, 2, arb("nan")), a_slice(0.5, 1))
    assert _in_strip(wild, arb(2), arb(1)).fate is Fate.UNDECIDED
    assert _in_strip(a_strip(a_slice(1, 2, arb("+inf"))), arb(2), arb(1)).fate is Fate.UNDECIDED
    assert _in_strip(a_strip(a_slice(1, 2)), arb(2), arb("nan")).fate is Fate.UNDECIDED


def of_model(orbits: list[Reference], strips: tuple[Strip, ...] = ()) -> Frame:
    plane, _ = model()
    region = (between(0.0625, 0.5), between(-2, 0.25))
    return Frame(plane, tuple(orbits), strips, region, sure(), arb("0.5"), arb("0.0625"))


@given(st.integers(9, 28), st.integers(1, 3), st.integers(-64, 64), st.integers(1, 12), st.sampled_from(STARTS))
def test_the_height_holds_that_of_every_state(at: int, width: int, b: int, height: int, start: str) -> None:
    """place - place_orbit(p) exactly, at the corners and in the middle of the box."""
    with working_bits(BITS):
        p, w = between(at / 64, (at + width) / 64), between((b - height) / 64, (b + height) / 64)
        found = _height(of_model([]), orbit(start), [p, w], p)
        assert found.is_finite()
        for own in (p.lower(), p.mid(), p.upper()):
            for value in (w.lower(), w.upper()):
                assert found.overlaps(value - b_of(own, start))
        exact = abs(-2 + arb("1.5") * (b_of(p, start) + 2 * p) / p).upper() * 2 * p.rad() + 2 * w.rad()
        assert 2 * found.rad() < 2 * exact + arb("0.01")


class Sheared:
    """p = x + y/2, b = -1 of a plane with the components x, y."""

    def values(self, box: list[arb]) -> list[arb]:
        return [box[0] + box[1] / 2, arb(-1)]

    def gradients(self, box: list[arb]) -> tuple[list[arb], list[list[arb]]]:
        return self.values(box), [[arb(1), arb("0.5")], [arb(0), arb(0)]]


def test_the_height_where_p_depends_on_the_place() -> None:
    """The orbit y = -2 p: y + 2 p = 2 x + 2 y, exactly, and no narrower at the corners of the box."""
    plane: Any = SimpleNamespace(p_and_b=Sheared())
    straight: Any = SimpleNamespace(along=1, place=lambda p: -2 * p, steepness=lambda _: arb(-2))
    x, y = between(0.25, 0.5), between(1, 1.5)
    found = _height(replace(of_model([]), plane=plane), straight, [x, y], x + y / 2)
    low, high = found.lower(), found.upper()
    assert 2.49 < low <= 2.5
    assert 4 <= high < 4.01


@pytest.mark.parametrize(
    ("b", "at", "expected"),
    [
        (lambda p: (b_of(p, "-1.2"), 2.0**-12), "0.25", (0, 1)),
        (lambda p: (b_of(p, "-1"), 2.0**-12), "0.25", (1, 2)),
        (lambda p: (b_of(p, "-1.125"), 2.0**-8), "0.25", (0, 2)),  # on the orbit in the middle
        (lambda p: (b_of(p, "-1.06"), 0.0625), "0.375", (0, 2)),
        (lambda p: (b_of(p, "-1.25"), 2.0**-8), "0.25", None),  # on the lowest
        (lambda p: (b_of(p, "-0.875"), 2.0**-8), "0.25", None),  # on the highest
        (lambda p: (b_of(p, "-1.5"), 2.0**-8), "0.25", None),
        (lambda p: (b_of(p, "-0.5"), 2.0**-8), "0.25", None),
    ],
)
def test_the_neighbours_of_a_box(b: Callable[[arb], Any], at: str, expected: tuple[int, int] | None) -> None:
    with working_bits(BITS):
        p = arb(at)
        middle, radius = b(p)
        found = _between(of_model([orbit(start) for start in STARTS]), [p, middle + arb(0, radius)], p)
        assert (None if found is None else found[:2]) == expected


MANY = ("-1.25", "-1.21875", "-1.1875", "-1.15625", "-1.125", "-0.875")


@pytest.mark.parametrize("k", range(len(MANY) - 1))
def test_the_neighbours_among_many_orbits(k: int) -> None:
    with working_bits(BITS):
        p, frame = arb("0.25"), of_model([orbit(start) for start in MANY])
        lower, upper = (b_of(p, start) for start in MANY[k : k + 2])
        found = _between(frame, [p, (lower + upper) / 2 + arb(0, 2.0**-12)], p)
        assert found is not None
        assert found[:2] == (k, k + 1)


def test_a_box_in_several_strips_has_a_fate_if_they_agree() -> None:
    orbits = [orbit(start) for start in STARTS]
    reached = [a_strip(a_slice(0.0625, 0.5), signs=signs) for signs in ((-1, -1), (-1, 1))]
    stops = a_strip(a_slice(0.0625, 0.5, 9))
    with working_bits(BITS):
        p = arb("0.25", "0.001")
        box = [p, b_of(p, "-1.125") + arb(0, 0.01)]

        def fate(*strips: Strip, slip: float = 1) -> Fate:
            return _in_frame(of_model(orbits, strips), box, p, arb(slip)).fate

        assert fate(reached[0], reached[0]) is Fate.BELOW
        assert fate(*reached) is Fate.SPOT
        assert fate(reached[0], stops) is Fate.UNDECIDED
        assert fate(stops, stops) is Fate.UNDECIDED  # in part of the slice slip may not stop
        lower = a_strip(a_slice(0.125, 0.1875, 9))
        assert fate(lower, lower) is Fate.STOPS
        # Outside of the region or of the orbits' range of p nothing is said.
        frame = of_model(orbits, (reached[0], reached[0]))
        for other in (
            replace(frame, region=(frame.region[0], between(-2, -0.54))),
            replace(frame, first=arb("0.2505")),
            replace(frame, last=arb("0.2495")),
        ):
            assert _in_frame(other, box, p, arb(1)).fate is Fate.UNDECIDED


@pytest.mark.parametrize(("u", "surface", "slips"), [(2, 1, True), (2, 3, False), (-2, -3, True), (-2, -1, False)])
def test_slip_is_counted_from_the_surface(u: int, surface: int, slips: bool) -> None:
    plane, _ = model()
    with working_bits(BITS):
        states = [arb(0), arb(u), arb(0), arb(0), arb("0.5"), arb(-1)]
        assert (box_fate(plane, (), states, arb(surface)).fate is not Fate.NO_SLIP) is slips
        opened = box_fate(plane, (), [*states[:5], arb(1)], arb(surface)).fate
        assert opened is (Fate.OPENS if slips else Fate.NO_SLIP)
