"""An explicit epsilon_0 for mechanisms with a chart (proofs/chart.md, section 4), beside runs of equations by hand."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.expansion.chart.chart import Chart, Region
from gspot_verified.expansion.chart.cone import Cone
from gspot_verified.expansion.from_state.affine_side import AffineSide, ChartedWay
from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.mechanisms.approach import chart_motion as module
from gspot_verified.mechanisms.approach.chart_motion import (
    _At,
    _charted,
    _checked,
    restricted,
    slowest_fall,
    with_chart,
)
from gspot_verified.mechanisms.approach.mechanism_side import MechanismSide, mechanism_side
from gspot_verified.mechanisms.derive.slip_hypotheses import FRICTION, SlipHypotheses
from gspot_verified.mechanisms.derive.slip_loss import SlipLoss
from gspot_verified.mechanisms.load import load
from gspot_verified.mechanisms.spots.g_spot import GSpot, find_g_spot
from gspot_verified.numbers.balls import ball, working_bits
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Outcome, Verdict
from tests.witnesses.stiff_contact import fate
from tests.witnesses.stiff_oscillator import StiffOscillator

SHOWN = less(0, 1)
assert SHOWN is not None


@cache
def rigid(speed: str) -> MechanismSide:
    return mechanism_side(load("oscillator"), {"phi": "phi_ref + 1/10", "phi_dot": speed}, surface_velocity=-1)


@cache
def spot() -> GSpot:
    return find_g_spot(load("oscillator"), 256)


def test_the_equations_by_hand_are_those_of_the_mechanism() -> None:
    """phi'' and y'' = b + p lambda at a state that is not on the contact."""
    system, e = spot().system, fmpq(1, 7)
    program = BoxProgram([system.F[2], system.G[2], system.p, system.b, system.y, system.v], 4)
    with working_bits(120):
        phi, speed, height, rise, force = arb("0.1"), arb("-0.7"), arb("0.3"), arb("-0.2"), arb("1.7")
        sine, cosine = (4 * phi.cos() + 3 * phi.sin()) / 5, (3 * phi.cos() - 4 * phi.sin()) / 5
        psi, slider = ball(e) ** 2 * height - 1 + cosine, ball(e) * rise - sine * speed
        F, G, p, b, y, v = program.values([phi, psi, speed, slider])
        rates = StiffOscillator(e).rates([phi, speed, height, rise, height + force])
        assert abs(y - ball(e) ** 2 * height) < arb("1e-30")
        assert abs(v - ball(e) * rise) < arb("1e-30")
        assert abs(rates[1] - F - G * force) < arb("1e-30")
        assert abs(rates[3] * ball(e) - b - p * force) < arb("1e-30")


def test_the_restricted_system_is_the_mechanism_without_other_components() -> None:
    rod = load("falling rod")
    place = find_g_spot(rod, 128)
    active = [i for i, word in enumerate(rod.state) if not word.lower().startswith("x")]
    with working_bits(128):
        system = restricted(place, active)
        whole = place.system
        box = [ball(value) + arb("0.01") * i for i, value in enumerate(whole.point)]
        names = ("p", "b", "y", "v", "alpha_1", "alpha_2", "alpha_3")
        mine = [getattr(system, name) for name in names] + list(system.F)
        theirs = [getattr(whole, name) for name in names] + [whole.F[i] for i in active]
        own = BoxProgram(mine, 4).values([box[i] for i in active])
        for one, other in zip(own, BoxProgram(theirs, len(box)).values(box), strict=True):
            assert one.overlaps(other)
            assert one.is_finite()
    assert len(system.state) == 4
    assert system.J == ()


def near_side(states: list[arb]) -> tuple[AffineSide, list[int]]:
    """A side whose starts have these states."""
    with working_bits(256):
        system = _charted(Chart(restricted(spot(), [0, 1, 2, 3])))
        cone = Cone(fmpq(0), fmpq(1, 1000), fmpq(33, 10), fmpq(1, 4), fmpq(1, 4), fmpq(1, 4))
        region = Region((), tuple(states), (), None, SHOWN)  # type: ignore[arg-type]
        numbers = {"p": arb("0.001", "1e-6"), "b": arb("-0.003", "1e-6"), "force": arb(3, "1e-4")}
        start = SimpleNamespace(manifold=SimpleNamespace(system=system), **numbers)
        proved = Verdict.proved("so", SHOWN)
        after = tuple(ball(value) for value in spot().system.point)
        side = AffineSide(start, fmpq(1), "impact", proved, ChartedWay(cone, region, after, arb(7)))  # type: ignore[arg-type]
        return side, [0, 1, 2, 3]


STATES = [arb("0.1", "0.01"), arb("0.2", "0.01"), arb("0.3", "0.01"), arb("0.4", "0.01")]
INSIDE = [arb("0.1"), arb("0.205"), arb("0.3"), arb("0.4")]


def at(state: list[arb], p: str = "0.001", b: str = "-0.003", force: str = "3") -> _At:
    return _At(arb(p), arb(b), arb(force), state)


def test_the_state_of_rigid_slip_must_be_a_start() -> None:
    side, active = near_side(STATES)
    with working_bits(256):
        assert _checked(spot().shifted, side, active, at(INSIDE)).side == "impact"
        told = _checked(spot().shifted, side, active, at(INSIDE)).verdict.statement
        assert told.endswith("; all this within a time of 7.01 from the start on")  # 7, and .001 over 2/5 or so
        for outside in (arb("0.22"), arb("0.205", "0.01"), arb("nan")):
            found = _checked(spot().shifted, side, active, at([INSIDE[0], outside, *INSIDE[2:]]))
            assert found.side is None
            assert found.verdict.outcome is Outcome.UNDECIDED
            assert found.verdict.detail == "the state of rigid slip is not certainly among the starts"
        outside_of_one = [("0.001002", "-0.003", "3"), ("0.001", "-0.0030010001", "3"), ("0.001", "-0.003", "3.0002")]
        for numbers in [*outside_of_one, ("nan", "-0.003", "3")]:
            assert _checked(spot().shifted, side, active, at(INSIDE, *numbers)).side is None


def test_how_much_slip_is_lost_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of all boxes, after p = 0 too, within the time that is told; nothing where slip depends on further components."""
    side, active = near_side(STATES)
    asked, own = list[Any](), SlipLoss.largest

    def noted(self: SlipLoss, boxes: Any, time: arb) -> arb | None:
        asked.append((boxes, time))
        return own(self, boxes[:-1], arb("0.01"))

    monkeypatch.setattr(SlipLoss, "largest", noted)
    assert side.way is not None
    with working_bits(256):
        found = _checked(spot().shifted, side, active, at(INSIDE))
        ((boxes, time),) = asked
        assert boxes[-1] == list(side.way.after)
        assert len(boxes) > 16
        assert arb("7.002") < time < arb("7.01")
        assert found.way is not None
        assert isinstance(found.way.lost, fmpq)
        lost = own(SlipLoss(spot().shifted), boxes[:-1], arb("0.01"))
        assert lost is not None
        assert lost <= ball(found.way.lost) < lost * arb("1.02")
        shown = f"{int(found.way.lost.p) / int(found.way.lost.q):g}"
        assert f"; slip stays positive if it exceeds {shown} at the start; all this within" in found.verdict.statement
        monkeypatch.setattr(SlipLoss, "largest", lambda *_: None)
        monkeypatch.setattr(SlipLoss, "components", frozenset({0}))
        unknown = _checked(spot().shifted, side, active, at(INSIDE))
        monkeypatch.setattr(SlipLoss, "largest", noted)
        monkeypatch.setattr(SlipLoss, "components", frozenset({0, 9}))
        beyond = _checked(spot().shifted, side, active, at(INSIDE))
    for found in (unknown, beyond):
        assert found.side == "impact"
        assert found.way is not None
        assert found.way.lost is None
        assert "slip" not in found.verdict.statement


def test_how_fast_p_falls_at_least() -> None:
    with working_bits(256):
        chart = Chart(restricted(spot(), [0, 1, 2, 3]))
        star = [ball(value) for value in spot().system.point]
        (at_star,) = BoxProgram([spot().system.alpha_1], 4).values(star)

        def region(width: str) -> Region:
            return Region((), (), tuple(arb(value, width) for value in star), None, SHOWN)  # type: ignore[arg-type]

        alone, both = slowest_fall(chart, [region("1e-9")]), slowest_fall(chart, [region("1e-9"), region("0.005")])
        assert alone is not None
        assert both is not None
        assert both < alone < -at_star
        assert alone > -at_star - arb("1e-6")
        assert slowest_fall(chart, [region("1e-9"), region("1")]) is None


def test_the_hypotheses_are_asked_on_the_whole_way(monkeypatch: pytest.MonkeyPatch) -> None:
    side, active = near_side(STATES)
    seen, own = list[list[arb]](), SlipHypotheses.checked

    def refused(self: SlipHypotheses, box: Any) -> Any:
        seen.append(list(box))
        return FRICTION if len(seen) == 7 else own(self, box)

    monkeypatch.setattr(SlipHypotheses, "checked", refused)
    with working_bits(256):
        found = _checked(spot().shifted, side, active, at(INSIDE))
        assert (found.side, found.verdict.detail) == (None, FRICTION)
        assert len(seen) == 7
        seen.clear()
        monkeypatch.setattr(SlipHypotheses, "checked", lambda self, box: seen.append(list(box)) or own(self, box))
        assert _checked(spot().shifted, side, active, at(INSIDE)).side == "impact"
        star = [ball(value) for value in spot().system.point]
        assert any(all(map(arb.contains, box, star)) for box in seen)
        assert len(seen) > 7
    assert side.way is not None
    beyond = [*side.way.after]
    seen.clear()
    monkeypatch.setattr(SlipHypotheses, "checked", lambda self, box: FRICTION if box[0] == 77 else own(self, box))
    late = replace(side, way=replace(side.way, after=(arb(77), *beyond[1:])))
    with working_bits(256):
        found = _checked(spot().shifted, late, active, at(INSIDE))
        assert (found.side, found.verdict.detail) == (None, FRICTION)
    monkeypatch.setattr(SlipHypotheses, "checked", own)
    wide = replace(side, way=replace(side.way, cone=replace(side.way.cone, last=fmpq(1))))  # type: ignore[union-attr, type-var]
    with working_bits(256):
        detail = _checked(spot().shifted, wide, active, at(INSIDE)).verdict.detail
        assert detail == "p, b, y, v are not certainly coordinates of the state on the way"
        monkeypatch.setattr(SlipHypotheses, "components", frozenset({0, 9}))
        more = _checked(spot().shifted, side, active, at(INSIDE)).verdict.detail
        assert more == "the hypotheses on the mechanism depend on further components"


def test_an_undecided_side_stays_so() -> None:
    side, active = near_side(STATES)
    undecided = replace(side, way=None)
    assert _checked(spot().shifted, undecided, active, at(INSIDE)) is undecided


def test_what_has_no_side_or_an_epsilon_already_is_left_alone() -> None:
    found = rigid("-9/10")
    without = replace(found, side=None)
    assert with_chart(without, load("oscillator")) is without
    five = replace(found, active=(*found.active, "more"))
    why = "the contact depends on 5 components: phi, psi, phi_dot, psi_dot, more"
    assert with_chart(five, load("oscillator")) == replace(five, not_explicit=why)
    assert f"  no explicit epsilon_0 (proofs/chart.md): {why}" in str(with_chart(five, load("oscillator")))
    known = replace(found, explicit=near_side(STATES)[0])
    assert with_chart(known, load("oscillator")) is known


def test_an_epsilon_that_is_not_known_is_asked_for_again(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of a start nearer to the G-spot."""
    side = near_side(STATES)[0]
    found = replace(rigid("-9/10"), explicit=replace(side, side=None))
    monkeypatch.setattr(module, "affine_side", lambda *_, **__: replace(side, way=None))
    assert with_chart(found, load("oscillator")).explicit == replace(side, way=None)


def test_the_start_is_a_state_of_the_path(monkeypatch: pytest.MonkeyPatch) -> None:
    """Its p and -b/p, somewhat wider, at the time that is told."""
    asked, found = list[Any](), rigid("-9/10")
    side, _ = near_side(STATES)

    def stand_in(system: Any, p: arb, b: arb, quotient: arb) -> AffineSide:
        asked.append((system, p, b, quotient))
        return replace(side, way=None)

    monkeypatch.setattr(module, "affine_side", stand_in)
    told = with_chart(found, load("oscillator"))
    ((system, p, b, force),) = asked
    path = found.approach.path
    (number,) = [i for i, value in enumerate(path.p) if p.contains(value)]
    assert arb("0.0005") < p < arb("0.00105")
    assert b.contains(path.b[number])
    assert arb("4e-4") * p.mid() < p.rad() < arb("6e-4") * p.mid()
    assert force.contains(path.force[number])
    assert arb("5e-5") * force.mid() < force.rad() < arb("7e-5") * force.mid()
    assert b.contains(-(force * p).mid())
    assert told.reached is not None
    assert arb(told.reached.strip("[]").split(" +/-")[0]).overlaps(arb(path.time[number].mid(), "1e-6"))
    assert f"  rigid slip from the state is at one of these starts after t = {told.reached}" in str(told)
    assert system.beta == fmpq(7, 3)


def test_what_is_beside_the_theorem_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuses(*_: Any, **__: Any) -> AffineSide:
        raise ValueError("beta must be above 1")

    monkeypatch.setattr(module, "affine_side", refuses)
    found = rigid("-9/10")
    assert with_chart(found, load("oscillator")) == replace(found, not_explicit="beta must be above 1")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("speed", "side", "least"), [("-9/10", "lift-off", fmpq(2, 10**10)), ("-1/2", "impact", fmpq(1, 10**10))]
)
def test_the_oscillators_starts_of_the_paper(speed: str, side: str, least: fmpq) -> None:
    """Runs by hand from the start that is named, and from the state itself, at epsilon_0 and a tenth of it."""
    found = with_chart(rigid(speed), load("oscillator"))
    explicit = found.explicit
    assert explicit is not None
    assert explicit.verdict.outcome is Outcome.PROVED, explicit
    assert explicit.side == found.side == side
    assert explicit.epsilon > least
    assert explicit.way is not None
    phi, _, phi_dot, _ = (value.mid() for value in explicit.way.starts.states)
    for factor in (1, 10):
        with working_bits(200):
            contact = StiffOscillator(explicit.epsilon / factor)
            starts = [
                contact.at_rest(phi, phi_dot),
                contact.at_rest(arb("0.1"), arb(fmpq(*map(int, speed.split("/"))))),
            ]
        for start in starts:
            assert fate(contact, start, 33)[0] == side
