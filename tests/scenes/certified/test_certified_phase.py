"""Which event ends a phase: close, coinciding and grazing ones, the end of the time, wide sets; against closed forms.

Page: proofs/validated_step.md, Theorems V5 and V6.
"""

from __future__ import annotations

import random
from pathlib import Path
from typing import Any

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.functions.expressions import Constant, Expression, Variable
from gspot_verified.integrator.norm_steps.chosen_step import Steps
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.scenes.certified import certified_phase as module
from gspot_verified.scenes.certified.certified_integration import integrated_run
from gspot_verified.scenes.certified.certified_phase import CLOCK, CertifiedPhase, Open, PhaseEnd
from gspot_verified.scenes.equations.scaled_system import PhaseEvent, ScaledSystem
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.run import OPEN
from gspot_verified.scenes.scene.scene import Scene

CLOSE = Path(__file__).parents[1] / "close_events.toml"
x, y = Variable(0), Variable(1)


def linear(a: fmpq, b: fmpq, c: fmpq) -> Expression:
    return Constant(a) * x + Constant(b) * y + Constant(c)


def above(level: fmpq) -> Expression:
    """cos t - level."""
    return linear(fmpq(1), fmpq(0), -level)


def ended(functions: dict[str, Expression], time: arb, x_radius: str = "0") -> PhaseEnd | Open:
    """x = cos t, y = -sin t until the first of the functions falls through 0."""
    events = tuple(PhaseEvent(name, function, "next") for name, function in functions.items())
    phase = CertifiedPhase(ScaledSystem("turning", ("x", "y"), (y, -x), events, ()))
    return phase.run({"x": arb(1, x_radius), "y": arb(0)}, time, {}, lambda *_: False)


def name_of(found: PhaseEnd | Open) -> str | None:
    assert isinstance(found, PhaseEnd), found
    return None if found.event is None else found.event.name


@pytest.mark.slow
def test_stick_and_slip_shortly_before_lift_off() -> None:
    """Stick at 1.8e-17 and slip at 1e-17 before lift-off: no float tells the times apart."""
    scene = load_scene(str(CLOSE))
    run = integrated_run(scene)
    assert run.verdict.outcome is Outcome.PROVED
    assert [event.name for event in run.events] == ["stick", "slip forwards", "lift-off"]
    for earlier, later in zip(run.events, run.events[1:], strict=False):
        assert earlier.upper < later.lower
    before = integrated_run(scene.with_settings(until=fmpq(49375, 10**5) - fmpq(1, 10**17) / 2))
    assert before.verdict.outcome is Outcome.PROVED
    assert [event.name for event in before.events] == ["stick", "slip forwards"]


def test_stick_shortly_before_lift_off_at_few_bits() -> None:
    """The same scene with few bits: lift-off is not the first event, whatever else is certain."""
    run = integrated_run(load_scene(str(CLOSE)), bits=(160,))
    assert [event.name for event in run.events][:1] in ([], ["stick"])
    assert run.fate == OPEN


@pytest.mark.parametrize("exponent", [10, 40, 52, 53, 60, 80])
@pytest.mark.parametrize("turned", [False, True])
def test_close_events_in_order(exponent: int, turned: bool) -> None:
    """cos t = 1/2 and cos t = 1/2 - 2^-k: the first is the first, in either order of the list."""
    functions = {"first": above(fmpq(1, 2)), "second": above(fmpq(1, 2) - fmpq(1, 2**exponent))}
    if turned:
        functions = dict(reversed(functions.items()))
    with working_bits(140):
        found = ended(functions, arb(3))
        assert name_of(found) == "first"
        assert found.time.is_finite()
        assert found.time.contains(arb.pi() / 3)


@pytest.mark.parametrize("exponent", [62, 64, 200, 100_000])
def test_events_closer_than_the_bits_are_undecided(exponent: int) -> None:
    functions = {"second": above(fmpq(1, 2) - fmpq(1, 2) ** exponent), "first": above(fmpq(1, 2))}
    with working_bits(64):
        found = ended(functions, arb(3))
        assert isinstance(found, Open)
        assert "simultaneous" in found.reason


def test_coinciding_events_are_undecided() -> None:
    """One function twice, and two functions with different slopes at their one zero."""
    for other in (above(fmpq(1, 2)), above(fmpq(1, 2)) * Constant(fmpq(1, 1000)), (x - y) * above(fmpq(1, 2))):
        with working_bits(128):
            found = ended({"one": above(fmpq(1, 2)), "other": other}, arb(3))
            assert isinstance(found, Open)
            assert "simultaneous" in found.reason


def test_three_events() -> None:
    """The earliest of three is found, unless two of them coincide and the third is later."""
    levels = {"third": fmpq(2, 5), "first": fmpq(1, 2), "second": fmpq(1, 2) - fmpq(1, 2**60)}
    with working_bits(128):
        assert name_of(ended({name: above(level) for name, level in levels.items()}, arb(3))) == "first"
        functions = {"later": above(fmpq(2, 5)), "one": above(fmpq(1, 2)), "two": above(fmpq(1, 2))}
        found = ended(functions, arb(3))
        assert isinstance(found, Open)
        assert "one" in found.reason or "two" in found.reason
        functions["earlier"] = above(fmpq(1, 2) + fmpq(1, 2**60))
        assert name_of(ended(functions, arb(3))) == "earlier"


@pytest.mark.parametrize("level", [fmpq(1, 2), fmpq(-1, 3), fmpq(9, 10)])
def test_the_bracket_begins_in_a_step_that_was_not_seen(level: fmpq) -> None:
    """Up to that moment of the step, before the event at arccos(level), its function is positive."""
    with working_bits(200):
        found = ended({"event": above(level)}, arb(3))
        assert isinstance(found, PhaseEnd)
        assert found.before is not None
        segment, tau = found.before
        assert 0 <= tau <= 1
        begin = segment.time + tau * (segment.end_time - segment.time)
        assert begin < arb(level).acos()
        assert found.time.contains(arb(level).acos())
        assert found.time.overlaps(begin)
        assert segment.states(tau)[0] > level


def test_a_grazing_function() -> None:
    """(cos t - 3/5)² + y-free square: it touches 0 where cos t = 3/5. Before the event at cos t = 1/2 that leaves it
    open; after the event at cos t = 7/10 it does not matter, even in the same step."""
    grazing = above(fmpq(3, 5)) * above(fmpq(3, 5))
    with working_bits(128):
        before = ended({"event": above(fmpq(1, 2)), "grazing": grazing}, arb(3))
        assert isinstance(before, Open)
        assert name_of(ended({"grazing": grazing, "event": above(fmpq(7, 10))}, arb(3))) == "event"
        lifted = grazing + Constant(fmpq(1, 2**30))  # does not reach 0
        assert name_of(ended({"event": above(fmpq(1, 2)), "grazing": lifted}, arb(3))) == "event"


@pytest.mark.parametrize("exponent", [3, 40, 60])
def test_a_function_that_falls_and_rises_again_before_the_event(exponent: int) -> None:
    """(cos t - 1/2 - 2d)(cos t - 1/2 - d) is negative for a short time before the event at cos t = 1/2, where it is
    positive again: its own first zero comes first, also where floats do not tell the times apart."""
    small = fmpq(1, 2**exponent)
    twice = above(fmpq(1, 2) + 2 * small) * above(fmpq(1, 2) + small)
    with working_bits(256):
        found = ended({"event": above(fmpq(1, 2)), "twice": twice}, arb(3))
        assert name_of(found) == "twice"
        assert found.time.contains((arb(1) / 2 + 2 * small).acos())


@pytest.mark.parametrize("exponent", [20, 60, 80])
def test_the_end_of_the_time(exponent: int) -> None:
    """An event 2^-k before the end is seen, one 2^-k after it is not, one at the end is undecided."""
    small = arb((1, -exponent))
    with working_bits(128):
        event = {"event": above(fmpq(1, 2))}
        assert name_of(ended(event, arb.pi() / 3 + small)) == "event"
        assert name_of(ended(event, arb.pi() / 3 - small)) is None
        at_end = ended(event, arb.pi() / 3)
        assert isinstance(at_end, Open)


def test_a_time_that_is_a_wide_ball() -> None:
    """pi/3 = 1.04719... lies in the ball of the time: whether the event comes before the end is open. Nothing is open
    of an event before all of the ball, or after it."""
    with working_bits(128):
        time = arb("1.047", "0.001")
        assert isinstance(ended({"event": above(fmpq(1, 2))}, time), Open)
        assert name_of(ended({"event": above(cosine("1.06"))}, time)) is None
        assert name_of(ended({"event": above(cosine("0.9"))}, time)) == "event"
        for time in (arb(0), arb(-1), arb(0, 1), arb("nan")):
            found = ended({"event": above(fmpq(1, 2))}, time)
            assert isinstance(found, Open)
            assert "the end of the time" in found.reason
            assert found.time.is_zero()


def turning(function: Expression) -> CertifiedPhase:
    """x = cos t, y = -sin t, w at rest."""
    event = PhaseEvent("event", function, "next")
    return CertifiedPhase(ScaledSystem("turning", ("x", "y", "w"), (y, -x, Constant(fmpq(0))), (event,), ()))


def followed(
    function: Expression, start: tuple[arb, arb], time: int, orders: dict[str, int | None], budget: int = 1000
) -> PhaseEnd | Open:
    states = {"x": start[0], "y": start[1], "w": arb(5)}
    return turning(function).run(states, arb(time), orders, lambda *_: False, Steps(budget))


def test_an_event_that_is_zero_at_the_start() -> None:
    """1 - cos t leaves 0 by its second derivative: seen where the first is exactly 0, believed where it is known
    beforehand, and open where the first is a ball around 0, or one that begins at 0."""
    away, slope = linear(fmpq(-1), fmpq(0), fmpq(1)), linear(fmpq(0), fmpq(1), fmpq(0))
    small = arb(0, arb((1, -40)))
    with working_bits(128):
        for y_0, order, good in ((arb(0), None, True), (small, 2, True), (small, None, False)):
            found = followed(away, (arb(1), y_0), 3, {"event": order})
            assert isinstance(found, PhaseEnd) is good
            if isinstance(found, PhaseEnd):
                assert found.event is None
                assert found.states["x"].rad() < arb((1, -36))
                assert found.states["x"].contains(arb(3).cos())
                assert found.states["y"].contains(-arb(3).sin())
                assert found.states["w"] == 5
        for x_0 in (small, arb((-1, -20), (1, -20)), arb((1, -20), (1, -20))):  # the rate of y is -x
            found = followed(slope, (x_0, arb(0)), 3, {"event": None})
            assert isinstance(found, Open)
            assert found.reason == "the phase begins where event cannot be told from the start"
            assert found.time.is_zero()


def test_why_a_phase_is_open() -> None:
    """A narrow set that grazes, and one that is wide in x and y but not in w; and the same where the budget ends."""
    grazing, none = above(fmpq(-1)), linear(fmpq(0), fmpq(0), fmpq(1))
    with working_bits(128):
        for radius, wide in (("0", False), ("0.5", True)):
            found = followed(grazing, (arb(1, radius), arb(0)), 4, {})
            assert isinstance(found, Open)
            assert ("too wide" in found.reason, "grazing" in found.reason) == (wide, not wide)
            assert not found.budget
        for radius, words in (("0", ""), ("0.00001", "; the set of states has become wide")):
            found = followed(none, (arb(1, radius), arb(0)), 4000, {}, 2)
            assert isinstance(found, Open)
            assert found.reason == f"the budget of 2 steps ended{words}"
            assert found.budget


def cosine(time: str) -> fmpq:
    """A rational near the cosine."""
    mantissa, exponent = arb(time).cos().mid().man_exp()
    return fmpq(int(mantissa)) * fmpq(2) ** int(exponent)


def first_fall(a: fmpq, b: fmpq, c: fmpq) -> arb | None:
    """The first t > 0 with a cos t - b sin t + c = 0, where a + c > 0; None: there is none."""
    size = (arb(a) ** 2 + arb(b) ** 2).sqrt()
    ratio = -arb(c) / size
    if not abs(ratio) < 1:
        return None
    phase = arb.atan2(arb(b), arb(a))  # a cos t - b sin t = size cos(t + phase)
    turn = 2 * arb.pi()
    times = [sign * ratio.acos() - phase + k * turn for sign in (1, -1) for k in (-1, 0, 1, 2)]
    least: arb | None = None
    for time in times:
        if time > 0 and (least is None or time < least):
            least = time
    return least


@given(st.integers(0, 2**32 - 1))
def test_what_is_claimed_first_is_first(seed: int) -> None:
    """Random functions, and one of them again with a small change: the event that is named has the least zero of all
    closed forms, and "no event" means that none has one."""
    chance = random.Random(seed)
    rows = []
    while len(rows) < 2:
        a, b, c = (fmpq(chance.randint(-32, 32), 32) for _ in range(3))
        if a + c > fmpq(1, 16):
            rows.append((a, b, c))
    a, b, c = rows[0]
    change = fmpq(chance.choice((-1, 1)), 2 ** chance.randint(10, 90))
    rows.append((a, b, c + change))
    chance.shuffle(rows)
    with working_bits(64):
        found = ended({str(i): linear(*row) for i, row in enumerate(rows)}, arb(3))
    with working_bits(400):
        times = [first_fall(*row) for row in rows]
        if isinstance(found, Open):
            return
        if found.event is None:
            assert all(time is None or time > 3 for time in times)
        else:
            first = times[int(found.event.name)]
            assert first is not None
            assert found.time.is_finite()
            assert found.time.contains(first)
            assert all(time is None or time is first or first < time for time in times)


def test_wide_sets_whose_brackets_overlap() -> None:
    """x_0 in 1 ± 1/10: cos t = 1/2 and cos t = 1/2 - d are ordered for each solution. They are decided where the whole
    set is, and never in the wrong order."""
    with working_bits(128):
        for gap, decided in ((fmpq(1, 100), False), (fmpq(3, 10), True)):
            found = ended({"second": above(fmpq(1, 2) - gap), "first": above(fmpq(1, 2))}, arb(3), "0.1")
            assert isinstance(found, PhaseEnd) is decided
            if decided:
                assert name_of(found) == "first"
                for start in ("0.901", "1", "1.099"):
                    time = (arb("0.5") / arb(start)).acos()
                    assert found.time.contains(time)
                    assert found.states["y"].contains(-arb(start) * time.sin())


def test_the_record_that_shows_most_is_kept(tmp_path: Path) -> None:
    """Flights that bounce: 80 bits show fewer of them than 96. What more bits have shown stays, in either order, and
    where the run goes on from a journal that holds both."""
    start: dict[str, fmpq | str] = {"p": fmpq(15, 8), "b": fmpq(-29, 16), "u": fmpq(7, 2), "y": fmpq(1, 1000),
                                    "v": fmpq(-3, 8), "z": fmpq(0)}  # fmt: skip
    effects = ("compliant_contact", "lift_off", "tangential_motion", "stick")
    parameters = {"alpha_1": fmpq(-3, 4), "alpha_2": fmpq(-5, 4), "beta": fmpq(2)}
    scene = Scene("bouncing", effects, fmpq(1, 10**6), fmpq(2), parameters, start)
    few, many = (integrated_run(scene, bits=(bits,)) for bits in (80, 96))
    assert many.fate == few.fate == OPEN
    assert 1 <= len(few.events) < len(many.events)
    assert integrated_run(scene, bits=(80, 96)) == integrated_run(scene, bits=(96, 80)) == many
    kept = tmp_path / "journal"
    assert integrated_run(scene, bits=(96, 80), journal=kept) == many
    assert integrated_run(scene, bits=(96, 80), journal=kept) == many


def test_no_phase_lasts_beyond_the_end(monkeypatch: pytest.MonkeyPatch) -> None:
    """A phase that begins at an uncertain time lasts for an uncertain time: what is left for each of its beginnings."""
    scene = load_scene("fig-varsim1", epsilon="1/20", until="1")
    run, seen = CertifiedPhase.run, []

    def spied(phase: CertifiedPhase, start: dict[str, arb], time: arb, *others: Any) -> PhaseEnd | Open:
        seen.append((start[CLOCK], time))
        return run(phase, start, time, *others)

    monkeypatch.setattr(CertifiedPhase, "run", spied)
    assert [event.name for event in integrated_run(scene, bits=(128,)).events] == ["lift-off"]
    assert len(seen) == 2
    with working_bits(256):
        for began, time in seen:
            left = arb(scene.until / scene.epsilon) - began
            assert time.contains(left.lower())
            assert time.contains(left.upper())
            assert time.lower() <= left.lower()
    assert seen[1][0].rad() > 0


def supposing(name: str, function: Expression, resting: fmpq, time: str = "1") -> PhaseEnd | Open:
    """x = cos t, y = -sin t, and a third state that stays as it is; no event, one function that must have its sign."""
    made = ScaledSystem("turning", ("x", "y", "m"), (y, -x, Constant(fmpq(0))), (), (), ((name, function),))
    return CertifiedPhase(made).run({"x": arb(1), "y": arb(0), "m": arb(resting)}, arb(time), {}, lambda *_: False)


@pytest.mark.parametrize(
    ("name", "value", "sense"),
    [
        ("mu", fmpq(1, 2), True),
        ("mu", fmpq(-1, 10**9), False),
        ("A", 0, False),
        ("A", fmpq(1, 2), True),
    ],
)
def test_friction_has_sense_for_mu_not_negative_and_a_positive(name: str, value: fmpq | int, sense: bool) -> None:
    found = supposing(name, Variable(2), fmpq(value))
    assert isinstance(found, PhaseEnd) is sense
    if isinstance(found, Open):
        assert found.reason == f"{name} may be negative, where the equations have no sense"
    assert (module._has_sense("mu", arb(0)), module._has_sense("A", arb(0))) == (True, False)


@pytest.mark.parametrize(("level", "sense"), [(fmpq(54, 100), True), (fmpq(55, 100), False)])
def test_friction_must_have_sense_all_along(level: fmpq, sense: bool) -> None:
    """cos 1 = 0.5403: what is supposed holds up to the end, or fails shortly before it."""
    found = supposing("A", above(level), fmpq(0))
    assert isinstance(found, PhaseEnd) is sense


@pytest.mark.parametrize("halvings", [2, 3])
def test_a_doubt_is_cut_as_often_as_allowed(halvings: int) -> None:
    """A function that is certain on parts of the length 2^-n and on no longer ones: n cuts, everywhere."""
    made = ScaledSystem("turning", ("x", "y"), (y, -x), (), (), (("A", x),))
    phase, seen = CertifiedPhase(made), list[arb]()

    class Certain:
        def __init__(self, length: fmpq) -> None:
            self.length = length

        def mean_values(self, box: list[arb]) -> list[arb]:
            seen.append(box[0])
            return [arb(1) if 2 * arb(box[0].rad()) < self.length * fmpq(101, 100) else arb(0, 1)]

    class Segment:
        def states(self, part: arb) -> list[arb]:
            return [part]

    for cuts, doubt in ((halvings, None), (halvings + 1, "A")):
        phase._supposed = Certain(fmpq(1, 2**cuts))  # type: ignore[assignment]
        assert phase._doubt(Segment(), arb(0), arb(1), halvings) == doubt  # type: ignore[arg-type]

    class CertainBeforeTheEnd(Certain):
        def mean_values(self, box: list[arb]) -> list[arb]:
            asked.append(box[0])
            return [arb(0, 1) if box[0].contains(1) else arb(1)]

    asked: list[arb] = []
    phase._supposed = CertainBeforeTheEnd(fmpq(1))  # type: ignore[assignment]
    assert phase._doubt(Segment(), arb(0), arb(1), halvings) == "A"  # type: ignore[arg-type]
    assert len(asked) == 2 * halvings + 1
    assert phase._doubt(Segment(), arb(0), arb(fmpq(7, 8)), halvings) is None  # type: ignore[arg-type]
    for k in range(17):
        assert any(part.contains(fmpq(k, 16)) and part.rad() < fmpq(2, 3) / 2**halvings for part in seen)


def test_an_observer_ends_a_phase_only_where_every_event_is_excluded(monkeypatch: pytest.MonkeyPatch) -> None:
    events = (PhaseEvent("falls", above(fmpq(-2)), "next"),)
    phase, asked = CertifiedPhase(ScaledSystem("turning", ("x", "y"), (y, -x), events, ())), list[str]()

    def observer(*_: object) -> bool:
        asked.append("asked")
        return True

    start = {"x": arb(1), "y": arb(0)}
    assert isinstance(phase.run(start, arb(1), {}, observer), PhaseEnd)
    assert asked == ["asked"]
    monkeypatch.setattr(module.Watch, "excluded", lambda *_: None)
    assert isinstance(phase.run(start, arb(1), {}, observer), Open)
    assert asked == ["asked"]
