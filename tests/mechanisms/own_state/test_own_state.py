"""From the user's own state to the starts near a G-spot (proofs/from_own_state.md, Theorem P)."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import cache
from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.expansion.chart.chart import Region
from gspot_verified.expansion.from_state.affine_side import AffineSide, ChartedWay
from gspot_verified.mechanisms.approach.affine_motion import with_explicit
from gspot_verified.mechanisms.approach.chart_motion import with_chart
from gspot_verified.mechanisms.approach.mechanism_side import MechanismSide, OwnSide, mechanism_side
from gspot_verified.mechanisms.approach.slip_flow import SlipFlow
from gspot_verified.mechanisms.derive.slip_hypotheses import FRICTION, SlipHypotheses
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.load import load
from gspot_verified.mechanisms.own_state import own_state as module
from gspot_verified.mechanisms.own_state.own_state import with_own_state
from gspot_verified.numbers.balls import ball, exact, working_bits
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Outcome, Verdict
from tests.witnesses.stiff_contact import StiffContact, at_rest
from tests.witnesses.stiff_oscillator import StiffOscillator

SHOWN = less(0, 1)
assert SHOWN is not None
MODEL = {"x": 0, "u": 3, "p": "1/2", "b": "-2"}
BOUND = fmpq(1, 40000)
P, FORCE = arb("0.25", "0.01"), arb("3.417", "0.02")  # slip of the model has -b/p = 2 + sqrt(8 p)
STATES = {"y": arb(0, "1e-4"), "v": arb(0, "1e-2"), "p": arb("0.25", "0.02"), "b": arb("-0.854", "0.1")}


@cache
def rigid() -> MechanismSide:
    return mechanism_side(load("model system"), MODEL)


def asked(bound: fmpq = BOUND, states: dict[str, arb] | None = None, **start: Any) -> MechanismSide:
    """A family of starts near p = 1/4, as if something had been proved of it."""
    whole = {"p": P, "b": -FORCE * P, "force": FORCE, "excess": arb("1.4", "0.1"), "within": fmpq(1, 100)} | start
    region = Region((), tuple((STATES | (states or {})).values()), (), None, SHOWN)  # type: ignore[arg-type]
    side = AffineSide(
        SimpleNamespace(**whole), bound, "lift-off", Verdict.proved("so", SHOWN), ChartedWay(None, region, (), arb(0))  # type: ignore[arg-type]
    )  # fmt: skip
    return replace(rigid(), explicit=side, reached="0.25")


def own(found: MechanismSide) -> OwnSide:
    told = with_own_state(found, load("model system"), MODEL)
    assert told.own is not None
    assert told == replace(found, own=told.own)
    return told.own


def test_what_is_proved_of_the_starts_is_proved_from_the_state() -> None:
    found = own(asked())
    assert found.side == "lift-off"
    assert found.verdict.outcome is Outcome.PROVED
    assert found.epsilon == BOUND
    assert (found.beside, found.share) == (1, fmpq(1, 2))
    text = str(found)
    assert f"for every 0 < epsilon <= {found.epsilon}" in text
    assert "each component within 1 epsilon of x = 0, u = 3" in text
    assert "<= 1/4 b^2" in text
    assert ": contact and positive slip last up to t = [0.2" in text
    assert "contact lasts until p < 0 and is lost later" in text


@pytest.mark.parametrize(
    ("changes", "why"),
    [
        ({"p": arb("0.25", "0.00001"), "b": arb("-0.8", "0.1")}, "rigid slip does not certainly come to these starts"),
        ({"p": arb("0.7", "0.01")}, "rigid slip does not certainly come to these starts"),
        ({"force": arb("3.5", "0.05")}, "not certain: -b/p = "),
        ({"b": arb("-0.86", "0.00001")}, "not certain: b = "),
        ({"within": fmpq(1, 10**9)}, "not certain: the fast part "),
        ({"excess": arb(0, 1)}, "not certain: the fast part "),
        ({"states": {"y": arb(0, "1e-30")}}, "not certain: the state is one of the chart"),
        ({"states": {"p": arb("0.3", "0.02")}}, "not certain: the state is one of the chart"),
        ({"states": {"b": arb("nan")}}, "not certain: the state is one of the chart"),
    ],
)
def test_starts_that_the_motion_does_not_certainly_come_to(
    changes: dict[str, Any], why: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "_TRIES", 1)
    found = own(asked(**changes))
    assert found.side is None
    assert found.verdict.outcome is Outcome.UNDECIDED
    assert found.verdict.detail.startswith(why)
    assert "contact and positive slip" not in str(found)


def test_a_smaller_epsilon_is_tried_where_one_is_too_large() -> None:
    """-b/p is not known well enough for the larger one."""
    found = own(asked(bound=fmpq(1, 2000)))
    assert found.side == "lift-off"
    assert found.epsilon in [fmpq(1, 2000) * fmpq(3, 4) ** n for n in range(1, 5)]


def test_the_hypotheses_are_asked_on_every_box(monkeypatch: pytest.MonkeyPatch) -> None:
    seen, checked = list[Any](), SlipHypotheses.checked

    def refused(self: SlipHypotheses, box: Any) -> Any:
        seen.append(box)
        return FRICTION if len(seen) % 7 == 0 else checked(self, box)

    monkeypatch.setattr(SlipHypotheses, "checked", refused)
    monkeypatch.setattr(module, "_TRIES", 1)
    found = own(asked())
    assert (found.side, found.verdict.detail) == (None, FRICTION)
    assert all(len(box) == 6 for box in seen)


def test_slip_is_watched_where_the_surface_is_known(monkeypatch: pytest.MonkeyPatch) -> None:
    """u falls from 3 to about 2.1 on the way."""

    def moving(velocity: str | None) -> OwnSide:
        found, surface = asked(), None if velocity is None else ball(exact(velocity, "u"))
        return own(replace(found, approach=replace(found.approach, surface_velocity=velocity, surface=surface)))

    assert "with the velocity u = 2:" in str(moving("2"))
    monkeypatch.setattr(module, "_TRIES", 1)
    for velocity in ("5/2", "3"):
        assert moving(velocity).side is None
        assert moving(velocity).verdict.detail == "slip is not certainly positive on the way"
    found = moving(None)
    assert found.side == "lift-off"
    assert ": as long as slip is positive, contact lasts up to t = " in str(found)


def test_slip_lasts_where_enough_of_it_is_left() -> None:
    """u is about 2.08 at the starts near the G-spot."""

    def losing(lost: fmpq | None, velocity: str | None = "0", side: str = "lift-off") -> str:
        found = asked()
        assert found.explicit is not None
        assert found.explicit.way is not None
        explicit = replace(found.explicit, side=side, way=replace(found.explicit.way, lost=lost))
        surface = None if velocity is None else ball(exact(velocity, "u"))
        moving = replace(found.approach, surface_velocity=velocity, surface=surface)
        told = own(replace(found, explicit=explicit, approach=moving))
        assert told.side == side
        return str(told)

    lasts = "contact and positive slip last until p < 0, and contact is lost later, in positive slip"
    alone = "contact lasts until p < 0 and is lost later"
    for lost, velocity in ((fmpq(2), "0"), (fmpq(1), "1"), (fmpq(0), "2")):
        assert lasts in losing(lost, velocity), (lost, velocity)
    for lost, velocity in ((None, "0"), (fmpq(11, 5), "0"), (fmpq(3, 2), "1"), (fmpq(1, 5), "2")):
        assert alone in losing(lost, velocity), (lost, velocity)
        assert ": contact and positive slip last up to t = " in losing(lost, velocity)
    until = "until p < 0, and after that until lambda_N exceeds the force stated there"
    assert f"contact and positive slip last {until}" in losing(fmpq(2), side="impact")
    assert f"contact lasts {until}" in losing(None, side="impact")


def test_where_the_surface_is_not_known_the_velocities_are_said_that_slip_allows() -> None:
    """u falls on the way, then by what is lost at most."""
    found = asked()
    assert found.explicit is not None
    assert found.explicit.way is not None

    def largest(lost: fmpq) -> fmpq:
        way = replace(found.explicit.way, lost=lost)  # type: ignore[union-attr, type-var]
        explicit = replace(found.explicit, way=way)  # type: ignore[type-var]
        unknown = replace(found.approach, surface_velocity=None, surface=None)
        told = str(own(replace(found, explicit=explicit, approach=unknown)))
        before, velocity, after = told.partition(": on any surface with a constant velocity below ")[2].partition(" ")
        assert after.startswith("contact and positive slip last up to t = ")
        assert "as long as slip is positive" not in told
        assert velocity == " "
        return fmpq(*map(int, Fraction(before).as_integer_ratio()))

    assert fmpq(1) < largest(fmpq(1)) < fmpq(11, 10)
    assert largest(fmpq(0)) - largest(fmpq(1)) == 1
    assert fmpq(-9, 10) > largest(fmpq(3)) > -1


def test_of_the_slip_on_the_way_and_at_its_end_the_least_counts(monkeypatch: pytest.MonkeyPatch) -> None:
    """u is 1 in one box of the way, 3 at the end; the number is rounded down."""

    def at(u: arb) -> list[arb]:
        return [arb(0), u, arb(0), arb(0), arb("0.25"), arb(-1)]

    surface, flow = SimpleNamespace(surface=None), SlipFlow.of(shift(load("model system")))

    def below(lost: fmpq, *boxes: arb) -> float | None:
        side = SimpleNamespace(way=SimpleNamespace(lost=lost))
        question: Any = module._Question(SimpleNamespace(approach=surface), side, None, flow, [])  # type: ignore[arg-type]
        told = question._with_slip(SimpleNamespace(states=at(arb(3)), boxes=[at(u) for u in boxes]), SHOWN)
        assert told.slip_lasts == (told.below is not None)
        return told.below  # type: ignore[no-any-return]

    with working_bits(60):
        least = below(fmpq(1), arb(5), arb(1, "0.25"), arb(4))
        assert least is not None
        assert 0.749999 < least <= 0.75
        least = below(fmpq(5, 2), arb(5), arb(1), arb(4))
        assert least is not None
        assert 0.499999 < least <= 0.5
        assert below(fmpq(1), arb(5), arb("nan")) is None
    monkeypatch.setattr(module, "float_bounds", lambda _: (0.12349, 0.2))
    found = asked()
    assert found.explicit is not None
    way = replace(found.explicit.way, lost=fmpq(0))  # type: ignore[type-var]
    unknown = replace(found.approach, surface_velocity=None, surface=None)
    told = own(replace(found, explicit=replace(found.explicit, way=way), approach=unknown))
    assert "with a constant velocity below 0.123 contact" in str(told)


def test_what_has_nothing_to_go_on_with_is_left_alone() -> None:
    for found in (
        rigid(),
        replace(asked(), reached=None),
        replace(asked(), explicit=replace(asked().explicit, side=None)),  # type: ignore[type-var]
        replace(asked(), explicit=replace(asked().explicit, way=None)),  # type: ignore[type-var]
    ):
        assert with_own_state(found, load("model system"), MODEL) is found


@pytest.mark.parametrize(("spot", "beside"), [(None, False), (1, True)])
def test_what_is_left_out_is_that_of_the_spot_that_was_named(
    spot: int | None, beside: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked_for, own_way = list[bool](), module.slip_state

    def noted(shifted: Any, state: Any, beside_place: bool) -> Any:
        asked_for.append(beside_place)
        return own_way(shifted, state, beside_place)

    monkeypatch.setattr(module, "slip_state", noted)
    monkeypatch.setattr(module, "_TRIES", 1)
    monkeypatch.setattr(module, "at_spot", lambda mechanism, _: mechanism)
    with_own_state(asked(), load("model system"), MODEL, spot)
    assert asked_for == [beside]


def test_the_text_says_what_is_part_of_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_TRIES", 1)
    beside = "that the compliant motion from the state comes there too is not part of it"
    assert beside in str(asked())
    proved = with_own_state(asked(), load("model system"), MODEL)
    assert beside not in str(proved)
    assert f"from the state itself (proofs/from_own_state.md): {proved.own}" in str(proved)
    undecided = with_own_state(asked(within=fmpq(1, 10**9)), load("model system"), MODEL)
    assert beside in str(undecided)
    assert "from the state itself (proofs/from_own_state.md): undecided" in str(undecided)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("speed", "side", "least"), [("-9/10", "lift-off", fmpq(3, 10**10)), ("-1/2", "impact", fmpq(2, 10**10))]
)
def test_the_oscillator_from_its_own_state(speed: str, side: str, least: fmpq) -> None:
    """Runs by hand from starts at the edge of the set, with a fast part, at epsilon_0."""
    oscillator, start = load("oscillator"), {"phi": "phi_ref + 1/10", "phi_dot": speed}
    found = with_own_state(
        with_chart(mechanism_side(oscillator, start, surface_velocity=-1), oscillator), oscillator, start
    )
    assert found.own is not None
    assert found.own.side == found.side == side, found.own
    assert found.own.epsilon > least
    epsilon = found.own.epsilon
    with working_bits(200):
        contact, e = StiffOscillator(epsilon), ball(epsilon)
        phi, phi_dot = arb("0.1"), arb(fmpq(*map(int, speed.split("/"))))
        for turn in (1, -1):
            rest = contact.at_rest(phi + turn * e, phi_dot - turn * e)
            rest[4] += turn * (rest[4] - rest[2]) * 2 / 5  # lambda is Z - Y: two fifths off
            last = contact.run(rest, lambda u: bool(u[4] - u[2] <= 0 or u[4] - u[2] > 33), tolerance="1e-9")
            assert ("lift-off" if last[4] - last[2] <= 0 else "impact") == side


@pytest.mark.slow
@pytest.mark.parametrize(("b", "side"), [("-11/20", "lift-off"), ("-3/20", "impact")])
def test_the_extended_system_from_a_state_that_is_too_far_for_its_power_series(b: str, side: str) -> None:
    """p = 1/4, where the slow manifold's polynomials say nothing; runs by hand from the edge of the set."""
    system, state = load("extended system"), {"x": 0, "u": 2, "p": "1/4", "b": b}
    found = with_explicit(mechanism_side(system, state), system, state)
    assert found.explicit is not None
    assert found.explicit.side is None
    found = with_own_state(with_chart(found, system), system, state)
    assert found.own is not None
    assert found.own.side == found.side == side, found.own
    assert found.own.epsilon > fmpq(1, 10**8)
    one, e = fmpq(1), found.own.epsilon
    contact = StiffContact([(-one, 0 * one, one), (-one, 0 * one, 0 * one), (-one * 3 / 2, 0 * one, 0 * one)], e)
    with working_bits(200):
        for turn in (1, -1):
            rest = at_rest(fmpq(1, 4) + turn * e, fmpq(*map(int, b.split("/"))) - turn * e)
            rest[4] += turn * (rest[4] - rest[2]) * 2 / 5
            last = contact.run(rest, lambda u: bool(u[4] - u[2] <= 0 or u[4] - u[2] > 21), tolerance="1e-9")
            assert ("lift-off" if last[4] - last[2] <= 0 else "impact") == side
