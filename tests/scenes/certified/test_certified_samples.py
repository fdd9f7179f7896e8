"""Enclosures of the exact solution and of the flight: against a float run, and where they must end."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.compliant.model.flight import ContactState
from gspot_verified.compliant.motion.run import events
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Reason, Verdict
from gspot_verified.scenes.certified import certified_samples as module
from gspot_verified.scenes.certified.certified_samples import MAX_POINTS, certified_samples, midpoint_and_radius
from gspot_verified.scenes.certified_run import exact_start
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.scene.file import load_scene, parse_scene

COLUMNS = ("t", "p", "b", "y", "v", "z", "lambda_N")


def test_in_units_other_than_1_also_where_the_bracket_of_the_lift_off_is_wide() -> None:
    """α₁ = −2. With 4 digits the lift-off has a bracket, and with it everything in flight a radius: the float run,
    whose error is some 1e-8, lies within it."""
    scene = load_scene("fig-varsim1", beta="3/2", nu=2, alpha_1=-2, epsilon="1/10", until=3)
    seen = float_run(scene, "LSODA", points=7).samples
    assert seen is not None
    places = {round(time, 9): i for i, time in enumerate(seen.columns["t"].tolist())}
    run = events(*exact_start(scene), 4)
    found = certified_samples(run, scene.until, 7)
    assert found.phases == ("slip",) * 3 + ("flight",) * 6  # two of them where the bracket ends
    assert sum(round(time, 9) in places for time in found.columns["t"].tolist()) == 7
    assert set(found.columns) == {name + end for name in COLUMNS for end in ("", "_radius")}
    for i, time in enumerate(found.columns["t"].tolist()):
        for name in COLUMNS:
            middle, radius = found.columns[name][i], found.columns[name + "_radius"][i]
            size = np.abs(found.columns[name]).max()
            if round(time, 9) in places:
                assert abs(seen.columns[name][places[round(time, 9)]] - middle) <= radius + 2e-7 * size, (name, time)
            assert 0 <= radius <= (1e-13 if found.phases[i] == "slip" else 1e-3) * size, (name, time)
    assert found.columns["b_radius"][-1] > 1e-6


TWO_FLIGHTS = """
format = 1
name = "two flights"
effects = ["compliant_contact", "lift_off"]
epsilon = "1/50"
until = "11/8"
[parameters]
alpha_1 = "-8/7"
alpha_2 = -1
beta = "31/8"
[start]
p = "649/1000"
b = 0
y = "-3/3500"
v = "1/100"
z = "-11/17500"
"""


def test_after_the_first_of_several_flights_no_sample_is_taken_from_the_first_contact() -> None:
    """Lift-off at .0383 and again at .6228, touch-down at .4513 and at 7.59: the exact solution from the start holds up
    to the first lift-off, the closed form up to the first touch-down. An uncertified run agrees."""
    scene = parse_scene(TWO_FLIGHTS)
    run = events(*exact_start(scene))
    assert [event.name for event in run.events[:4]] == ["lift-off", "touch-down"] * 2
    lift, land = (event.lower - run.start for event in run.events[:2])
    found = certified_samples(run, scene.until, 56)
    seen = float_run(scene, "LSODA", points=56).samples
    assert seen is not None
    times = found.columns["t"]
    assert times[-1] == pytest.approx(float(land.p) / float(land.q), abs=1e-12)
    assert found.phases == ("slip",) * 3 + ("flight",) * (len(times) - 3)
    assert times[2] == pytest.approx(float(lift.p) / float(lift.q), abs=1e-12)
    for name in COLUMNS[1:]:
        expected = np.interp(times, seen.columns["t"], seen.columns[name])
        shared = np.isclose(times[:, None], seen.columns["t"][None, :], rtol=0, atol=1e-12).any(axis=1)
        assert shared.sum() == 19
        size = np.abs(seen.columns[name]).max()
        assert np.abs(found.columns[name] - expected)[shared].max() <= 1e-6 * size, name
        assert abs(found.columns[name][2] - found.columns[name][3]) <= 1e-9 * size, name  # no jump at the lift-off


def values(force: str | arb, **others: arb) -> SimpleNamespace:
    state = {name: arb(1) for name in "bvyz"} | others
    return SimpleNamespace(p=fmpq(1), **state, force=arb(force))


def fake(*, known: bool = True, found: tuple[Any, ...] = ()) -> Any:
    verdict = Verdict.proved("lasts", less(0, 1)) if known else Verdict.undecided("?", Reason.BUDGET, "for the test")
    return SimpleNamespace(events=found, verdict=verdict, start=fmpq(0), model=None, state=None)


@pytest.mark.parametrize(
    ("last", "rows"),
    [
        (values("3999.99"), 3),  # up to 1000 times the first, not less
        (values("4000"), 3),
        (values("4000.01"), 2),
        (values("1e400"), 2),
        (values("nan"), 2),
        (values("4", b=arb("1e309")), 2),
        (values("4", z=arb.nan()), 2),
    ],
)
def test_they_end_where_a_force_is_1000_times_the_first_or_no_float_holds_a_value(
    monkeypatch: pytest.MonkeyPatch, last: SimpleNamespace, rows: int
) -> None:
    steps = iter([values("4"), values("5"), last])
    monkeypatch.setattr(module, "force", lambda *_: next(steps))
    found = certified_samples(fake(), fmpq(1), 3)
    assert len(found.phases) == len(found.columns["t"]) == rows
    assert all(np.isfinite(column).all() for column in found.columns.values())


def test_without_a_proof_that_the_contact_lasts_there_is_no_sample(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "force", lambda *_: values("4"))
    assert certified_samples(fake(known=False), fmpq(1), MAX_POINTS).phases == ()
    assert certified_samples(fake(), fmpq(1), 2).columns["t"].tolist() == [0.0, 1.0]
    for points in (-1, 0, 1, MAX_POINTS + 1):
        with pytest.raises(ValueError, match=r"points: expected 2\.\.100000, got"):
            certified_samples(fake(known=False), fmpq(1), points)


def test_between_the_ends_of_a_bracket_nothing_is_known(monkeypatch: pytest.MonkeyPatch) -> None:
    """Lift-off in [2, 4], touch-down in [6, 8]: at its lower end the first is not yet, at its upper end it has been;
    up to the lower end of the second the flight lasts."""
    monkeypatch.setattr(module, "force", lambda *_: values("4"))
    monkeypatch.setattr(module, "_in_flight", lambda *_: [arb(0)] * 6)
    lift = SimpleNamespace(name="lift-off", lower=fmpq(2), upper=fmpq(4))
    land = SimpleNamespace(name="touch-down", lower=fmpq(6), upper=fmpq(8))
    known = {
        time: None if (at := module._values(fake(known=False, found=(lift, land)), fmpq(time), 12)) is None else at[0]
        for time in range(9)
    }
    assert known == dict.fromkeys((0, 1, 2), "slip") | {3: None} | dict.fromkeys((4, 5, 6), "flight") | dict.fromkeys(
        (7, 8), None
    )
    assert module._values(fake(found=(lift,)), fmpq(5), 12) is None


def test_there_are_samples_where_the_brackets_of_events_end(monkeypatch: pytest.MonkeyPatch) -> None:
    """Lift-off in [2, 5/2], touch-down in [7, 8], counted from -1, the start; none is later than ``until``."""
    monkeypatch.setattr(module, "force", lambda *_: values("4"))
    monkeypatch.setattr(module, "_in_flight", lambda *_: [arb(0)] * 6)
    lift = SimpleNamespace(name="lift-off", lower=fmpq(2), upper=fmpq(5, 2))
    land = SimpleNamespace(name="touch-down", lower=fmpq(7), upper=fmpq(8))
    run = fake(found=(lift, land))
    run.start = fmpq(-1)
    found = certified_samples(run, fmpq(12), 4)
    assert found.columns["t"].tolist() == [0, 3, 3.5, 4, 8]
    assert found.phases == ("slip",) * 2 + ("flight",) * 3
    assert certified_samples(run, fmpq(13, 4), 2).columns["t"].tolist() == [0, 3]
    assert certified_samples(run, fmpq(3), 2).columns["t"].tolist() == [0, 3]


@pytest.mark.parametrize("ball", [arb("1e400"), arb("-1e400"), arb(0, arb("1e400")), arb("inf"), arb.nan()])
def test_what_no_float_holds_has_an_infinite_radius(ball: arb) -> None:
    assert midpoint_and_radius(ball)[1] == float("inf")


FLOATS = st.floats(allow_nan=False, allow_infinity=False, allow_subnormal=True)


@given(FLOATS, st.integers(0, 5), st.one_of(st.none(), FLOATS))
def test_floats_hold_a_ball_between_any_two_of_them(low: float, apart: int, other: float | None) -> None:
    """Also where the bounds of the ball are its ends, and the midpoint of neighbours is rounded to one of them."""
    high = low
    for _ in range(apart):
        high = math.nextafter(high, math.inf)
    low, high = (low, high) if other is None else sorted((low, other))
    if math.isinf(high):
        return
    with pytest.MonkeyPatch.context() as patch, working_bits(2200):
        patch.setattr(module, "float_bounds", lambda _: (low, high))
        middle, radius = midpoint_and_radius(arb(0))
        assert arb(middle) - arb(radius) <= arb(low)
        assert arb(high) <= arb(middle) + arb(radius)
        assert radius <= math.nextafter(high / 2 - low / 2, math.inf) * (1 + 1e-15) + 1e-323 + abs(middle) * 2.0**-52


def test_the_flight_of_each_lift_off_in_the_bracket_lies_in_the_enclosure() -> None:
    """One exact state, lift-off in [1, 3/2]: the values for a lift-off at either end, and between them."""
    scene = load_scene("fig-varsim1", beta="3/2", nu=2, alpha_1=-2, epsilon="1/10")
    model, _ = exact_start(scene)
    one = arb(1)
    state = ContactState(
        beta=model.beta, epsilon=model.scaled_epsilon, alpha_2=model.alpha_2 * model.sigma**3,
        p=-one / 2, b=one / 4, V=3 * one, Y=-one, force=arb(0),
    )  # fmt: skip
    ends = fmpq(1), fmpq(5, 4), fmpq(3, 2)

    def flight(lower: fmpq, upper: fmpq) -> list[arb]:
        return module._in_flight(model, SimpleNamespace(state=state, lower=lower, upper=upper), fmpq(2), 12)  # type: ignore[arg-type]

    wide = flight(ends[0], ends[-1])
    for end in ends:
        for whole, part in zip(wide, flight(end, end), strict=True):
            assert whole.is_finite()
            assert whole.contains(part)
    assert wide[0].is_exact() or wide[0].rad() < 1e-12  # p is a function of time alone
    assert all(value.rad() > 1e-3 for value in wide[1:4])
