"""The state as a function of p, b, y, v (proofs/chart.md, section 1), beside a closed form and Newton's method."""

from __future__ import annotations

import random
from dataclasses import replace

import pytest
from flint import arb, arb_mat, fmpq

from gspot_verified.expansion.chart.chart import Chart
from gspot_verified.expansion.chart.cone import Cone, joined_cones, ray_of
from gspot_verified.expansion.chart.taylor_rest import covered
from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.g_spot import find_g_spot
from gspot_verified.numbers.balls import ball, working_bits
from tests.expansion.chart.folded import ONE, folded

FOLDED = Chart(folded(ONE * ONE, ONE, ONE))
Point = list[arb]


def inverted(q: Point) -> Point:
    """The closed form."""
    p, b, y, v = q
    x = (1 - (1 - 4 * p).sqrt()) / 2
    return [x, b / (1 + x), y, v]


def drawn(draw: random.Random, box: list[arb]) -> Point:
    """A point of a box."""
    return [(side.mid() + side.rad() * draw.uniform(-1, 1)).mid() for side in box]


def on(draw: random.Random, cone: Cone) -> Point:
    """A point of a cone."""
    p = ball(cone.first + (cone.last - cone.first) * fmpq(3 * draw.randrange(101) + 1, 304))
    force = ball(cone.middle) + ball(cone.beside) * draw.uniform(-1, 1)
    height, speed = (ball(one) * draw.uniform(-1, 1) for one in (cone.height, cone.speed))
    return [p, -force * p, height * p**3, speed * p**2]


WIDE = Cone(fmpq(0), fmpq(1, 10), fmpq(3), fmpq(1), fmpq(2), fmpq(1))


def test_a_region_holds_the_states_and_the_slopes_of_its_box() -> None:
    draw = random.Random(5)
    with working_bits(100):
        box = [arb("0.04", "0.05"), arb("-0.1", "0.2"), arb(0, "0.1"), arb(0, "0.1")]
        region = FOLDED.region(box)
        assert region is not None
        for _ in range(40):
            q = drawn(draw, box)
            state = inverted(q)
            assert all(side.contains(value) for side, value in zip(region.states, state, strict=True))
            x, w, _, _ = state
            slopes = arb_mat([[1 - 2 * x, 0, 0, 0], [w, 1 + x, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]).inv()
            assert all(map(arb.contains, region.inverse.entries(), slopes.mid().entries()))
        assert region.states[0].rad() < arb("0.1")


def test_a_box_must_hold_the_spot_or_meet_a_region() -> None:
    with working_bits(100):
        away = [arb("0.1", "0.01"), arb(0), arb(0), arb(0)]
        with pytest.raises(ValueError, match="must hold p = b = y = v = 0"):
            FOLDED.region(away)
        with pytest.raises(ValueError, match="must be finite"):
            FOLDED.region([arb("nan"), arb(0), arb(0), arb(0)])
        first = FOLDED.region([arb("0.05", "0.05"), arb(0), arb(0), arb(0)])
        assert first is not None
        second = FOLDED.region([arb("0.11", "0.02"), arb(0), arb(0), arb(0)], first)
        assert second is not None
        assert second.states[0].contains(inverted([arb("0.11"), arb(0), arb(0), arb(0)])[0])


def test_the_state_of_another_branch_is_not_taken() -> None:
    """x = 1 - X(p) has the same p: a region around it does not go with the G-spot at 0."""
    with working_bits(100):
        first = FOLDED.region([arb("0.05", "0.05"), arb(0), arb(0), arb(0)])
        assert first is not None
        other = replace(
            first,
            states=(1 - first.states[0], *first.states[1:]),
            around=(1 - first.around[0], *first.around[1:]),
        )
        following = [arb("0.11", "0.02"), arb(0), arb(0), arb(0)]
        found = FOLDED.region(following, other)
        assert found is None or not found.states[0].overlaps(inverted(following)[0])
        narrow = replace(first, around=(first.around[0].mid(), *first.around[1:]))
        assert FOLDED.region(following, narrow) is None


def test_regions_cover_a_cone() -> None:
    draw = random.Random(11)
    with working_bits(100):
        parts = covered(FOLDED, WIDE)
        assert parts is not None
        for _ in range(60):
            q = on(draw, WIDE)
            near = [region for part, region in parts if part.first <= q[0] <= part.last]
            holding = [one for one in near if all(map(arb.contains, one.place, (value.mid() for value in q)))]
            assert holding
            state = inverted([value.mid() for value in q])
            assert all(all(map(arb.contains, one.states, (v.mid() for v in state))) for one in holding)


@pytest.mark.parametrize(("last", "decided"), [(fmpq(23, 100), True), (fmpq(25, 100), False), (fmpq(3, 10), False)])
def test_there_is_no_chart_beyond_a_fold(last: fmpq, decided: bool) -> None:
    with working_bits(100):
        found = FOLDED.chain(replace(WIDE, last=last, beside=fmpq(0)).pieces(64))
    assert (found is not None) is decided


def test_a_spot_with_dependent_p_and_b_has_no_chart() -> None:
    system = replace(FOLDED.system, b=FOLDED.system.p)
    with working_bits(100):
        assert Chart(system).region([arb(0, "0.01")] * 4) is None
    with pytest.raises(ZeroDivisionError):
        Chart(system).slopes()


def test_only_four_components() -> None:
    system = FOLDED.system
    five = replace(
        system, F=(*system.F, ONE), G=(*system.G, ONE), J=(system.y,), point=(*system.point, fmpq(0)),
        state=(*system.state, "more"),
    )  # fmt: skip
    with pytest.raises(ValueError, match="four components alone"):
        Chart(five)


def test_the_oscillator_by_newtons_method() -> None:
    """At random p, b, y, v of a cone around the mean force."""
    system, draw = find_g_spot(shipped_mechanism("frictional impact oscillator")).system, random.Random(3)
    chart = Chart(system)
    program = BoxProgram(system.conditions, 4)
    cone = Cone(fmpq(0), fmpq(1, 400), fmpq(33, 10), fmpq(1), fmpq(1), fmpq(1))
    with working_bits(120):
        parts = covered(chart, cone)
        assert parts is not None
        for _ in range(20):
            q = on(draw, cone)
            state = [ball(value) for value in system.point]
            for _ in range(30):
                values, rows = program.gradients([one.mid() for one in state])
                step = arb_mat(rows).solve(arb_mat([[a - c] for a, c in zip(values, q, strict=True)]))
                state = [one.mid() - step[i, 0] for i, one in enumerate(state)]
            for part, region in parts:
                inside = part.first <= q[0] <= part.last and part.force.contains((-q[1] / q[0]).mid())
                if q[0] > 0 and inside:
                    assert all(map(arb.contains, region.states, (one.mid() for one in state)))


def test_parts_of_cones() -> None:
    with working_bits(100):
        slabs, pieces = WIDE.slabs(4), WIDE.pieces(4)
        assert [(one.middle, one.beside) for one in slabs] == [(fmpq(k, 4), fmpq(1, 4)) for k in (9, 11, 13, 15)]
        assert [(one.first, one.last) for one in pieces] == [(fmpq(k, 40), fmpq(k + 1, 40)) for k in range(4)]
        higher = joined_cones([WIDE, replace(WIDE, height=fmpq(7), beside=fmpq(1, 2)), replace(WIDE, speed=fmpq(5))])
        assert higher == replace(WIDE, height=fmpq(7), speed=fmpq(5))
        ray = ray_of(WIDE, arb("0.1", "0.01"), arb(2, "0.5"))
        assert ball(ray.last) >= arb("0.11")
        assert ray.force.contains(arb("2.5"))
        assert ray.force.contains(arb("1.5"))
        p = arb("0.3")
        rows = replace(WIDE, first=fmpq(3, 10), last=fmpq(3, 10)).rows(6)
        for n, (first, second, third, fourth) in enumerate(rows):
            of_p = [p, arb(1), *[arb(0)] * 4][n]
            cubic = [p**3, 3 * p**2, 3 * p, arb(1), arb(0), arb(0)][n]
            square = [p**2, 2 * p, arb(1), *[arb(0)] * 3][n]
            assert first.overlaps(of_p)
            assert all(map(second.contains, (-4 * of_p.mid(), -2 * of_p.mid())))
            assert all(map(third.contains, (2 * cubic.mid(), -2 * cubic.mid())))
            assert all(map(fourth.contains, (square.mid(), -square.mid())))
            assert third.rad() < 2 * cubic + arb("1e-6")
            assert fourth.rad() < square + arb("1e-6")
