"""What is kept of a run: which precisions are tried, which attempt is taken, growth, and conditions at the end.

Page: proofs/left_out_effects.md.
"""

from __future__ import annotations

import json
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.scenes.certified import certified_integration as module
from gspot_verified.scenes.certified.certified_integration import MAX_EVENTS, integrated_run
from gspot_verified.scenes.certified.certified_phase import CLOCK, CertifiedPhase, Open, PhaseEnd
from gspot_verified.scenes.certified.certified_result import Record, event_of
from gspot_verified.scenes.certified.invariant_region import ExponentialGrowth
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.run import IMPACT, OPEN, REFUTED
from gspot_verified.scenes.scene.scene import Scene

SHOWN = less(0, 1)
assert SHOWN is not None


@pytest.mark.parametrize(
    ("name", "epsilon", "digits", "bits"),
    [
        ("fig-varsim1", "1e-3", 1, [192, 320, 576]),
        ("fig-varsim1", "1e-3", 15, [192, 320, 576]),
        ("fig-varsim1", "1e-3", 16, [195, 323, 579]),
        ("fig-varsim1", "1e-3", 80, [408, 536, 792]),
        ("fig-varsim1", "1e-6", 15, [192, 320, 576]),
        ("rod", "1/999999", 15, [192, 320, 576]),
        ("rod", "1e-6", 15, [320, 576]),
        ("rod", "1e-7", 18, [330, 586]),
    ],
)
def test_the_precisions_that_are_tried(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, epsilon: str, digits: int, bits: list[int]
) -> None:
    """10/3 bits for each decimal beyond 15; a mechanism at a small epsilon does not begin with 192."""
    monkeypatch.setattr(CertifiedPhase, "run", lambda *_: Open("for the test", arb(0), budget=True))
    kept = tmp_path / "journal"
    integrated_run(load_scene(name, epsilon=epsilon), digits=digits, journal=kept)
    asked = json.loads(kept.read_text().splitlines()[0])["journal"]
    assert (asked["bits"], asked["digits"]) == (bits, digits)


LIFT = event_of("lift-off", arb("[10 +/- 1e-30]"), fmpq(1, 100))
WIDE = event_of("lift-off", arb("[10 +/- 1e-5]"), fmpq(1, 100))


def attempts(monkeypatch: pytest.MonkeyPatch, *records: Record, lost: tuple[int, ...] = ()) -> tuple[Any, list[int]]:
    """The run where each precision shows one of these; the precisions that were tried."""
    scene, tried = load_scene("fig-varsim1", epsilon="1/100", until=1), list[int]()
    every = module.Conditions.of(scene)
    unwatched = SimpleNamespace(lost={"stick"}, unknown={}, certain_until=arb(0))

    def attempt(_: Scene, __: object, bits: int, *_others: object) -> Any:
        tried.append(bits)
        number = len(tried) - 1
        return module._Attempt(records[number], unwatched if number in lost else every, None)  # type: ignore[arg-type]

    monkeypatch.setattr(module, "_attempt", attempt)
    return integrated_run(scene, bits=tuple(range(64, 64 + len(records)))), tried


def stopped(time: int, *events: Any, budget: bool = False) -> Record:
    return Record(list(events), open=Open("it is hard", arb(time), budget), shown=[SHOWN for _ in events])


def done(*events: Any) -> Record:
    return Record(list(events), shown=[SHOWN for _ in events], ended=SHOWN, multiples=[])


def test_the_attempt_that_shows_most_is_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    """More events, then further in time, whatever the order of the precisions; a later one that shows as much is it."""
    later = LIFT, event_of("touch-down", arb(20), fmpq(1, 100))
    run, tried = attempts(monkeypatch, stopped(30, *later), stopped(50, LIFT), stopped(40))
    assert ([event.name for event in run.events], tried) == (["lift-off", "touch-down"], [64, 65, 66])
    run, _ = attempts(monkeypatch, stopped(20, LIFT), stopped(30, LIFT), stopped(25, LIFT))
    assert "(t = [0.3" in run.verdict.detail
    run, _ = attempts(monkeypatch, stopped(30, WIDE), stopped(30, LIFT))
    assert run.events == (LIFT,)


def test_the_next_precision_is_tried_until_the_events_are_narrow(monkeypatch: pytest.MonkeyPatch) -> None:
    """15 decimals and 5 to spare; the budget of steps is one of all precisions; what is done beats what is open."""
    run, tried = attempts(monkeypatch, done(LIFT), stopped(90, LIFT))
    assert (run.verdict.outcome, tried) == (Outcome.PROVED, [64])
    run, tried = attempts(monkeypatch, done(WIDE), stopped(90, LIFT, LIFT))
    assert (run.verdict.outcome, run.events, tried) == (Outcome.PROVED, (WIDE,), [64, 65])
    run, tried = attempts(monkeypatch, done(WIDE), done(LIFT), done(LIFT))
    assert (run.events, tried) == ((LIFT,), [64, 65])
    run, tried = attempts(monkeypatch, stopped(90, LIFT, budget=True), done(LIFT))
    assert (run.fate, tried) == (OPEN, [64])
    run, tried = attempts(monkeypatch, done(LIFT), done(LIFT), lost=(0,))
    assert (run.verdict.outcome, tried) == (Outcome.PROVED, [64, 65])
    run, tried = attempts(monkeypatch, done(WIDE), done(LIFT), lost=(1,))  # with no condition lost
    assert (run.events, tried) == ((WIDE,), [64, 65])


@pytest.mark.parametrize(("width", "narrow"), [(1, True), ("1.0001", False)])
def test_narrow_is_five_decimals_more_than_are_asked_for(width: str | int, narrow: bool) -> None:
    unit = fmpq(1, 100) * fmpq(1, 10**20)
    event = module.RunEvent("lift-off", fmpq(0), unit * (fmpq(10001, 10000) if width != 1 else fmpq(1)))
    assert module.is_narrow(event, fmpq(1, 100), 15) is narrow


def growths(
    *found: ExponentialGrowth | None, sticks: bool = False, events: tuple[str, ...] = ("flight",)
) -> tuple[Record, list[bool]]:
    """What the observer of impacts writes, and answers, where the region shows these one after the other."""
    system = SimpleNamespace(
        events=[SimpleNamespace(next_phase=name) for name in events],
        supposed=(),
        phase="stick" if sticks else "slip",
    )

    def growth(_: Any, limited: bool) -> ExponentialGrowth | None:
        found = next(shown)
        return found if limited or found is None or found.until is None else None

    record = Record()
    observer = module._ImpactObserver.__new__(module._ImpactObserver)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(module, "InvariantRegion", lambda _: SimpleNamespace(growth=growth))
        shown = iter(found)
        observer.__init__(
            SimpleNamespace(system=system),
            arb(10),
            arb(15),
            SimpleNamespace(epsilon=fmpq(1, 10), stop_at_force=None),
            record,
        )  # type: ignore[misc]
        answers = [
            observer(SimpleNamespace(time=arb(k), end_time=arb(k + 1)), {})  # type: ignore[arg-type]
            for k in range(len(found))
        ]
    return record, answers


RATE = arb("0.5")
LIMITED, MORE, LASTING = ExponentialGrowth(RATE, 8), ExponentialGrowth(RATE, 64), ExponentialGrowth(RATE, None)
ENDS = ExponentialGrowth(RATE, None, arb(3))


def test_an_impact_begins_where_growth_is_first_shown_and_its_limit_may_fall_later() -> None:
    record, answers = growths(None, LIMITED, MORE, LASTING)
    assert answers == [False, False, False, True]
    (event,) = record.events
    assert (event.name, event.lower, event.upper) == (IMPACT, fmpq(12, 10), fmpq(12, 10))
    assert record.multiples == [None]
    assert record.for_ever
    assert len(record.shown) == 1
    first, second = record.remarks
    assert first == "λ_N grows at least like exp(0.499 t/ε) until it is 8 times as large, or slip ends"
    assert second.startswith("from t = 1.4")
    assert second.endswith("for as long as the contact slips")
    assert record.limits == [second]


def test_growth_that_is_limited_or_has_an_end_goes_on() -> None:
    record, answers = growths(LIMITED, MORE, None)
    assert (answers, record.multiples, len(record.remarks), record.for_ever) == ([False] * 3, [8], 1, False)
    record, answers = growths(ENDS, LASTING, sticks=True)  # one is enough: no second event, no second remark
    assert (answers, record.multiples, len(record.remarks), record.for_ever) == ([False] * 2, [None], 1, False)
    assert record.remarks[0].endswith("for as long as the contact sticks, which ends within 3.01 ε")
    assert record.limits == record.remarks
    record, answers = growths(LASTING, events=("flight", "stick"))
    assert (answers, record.for_ever, len(record.events)) == ([False], False, 1)


@pytest.mark.parametrize("rate", ["0", "[0.1 +/- 0.2]", "-1", "nan"])
def test_no_impact_without_a_rate_that_is_certainly_positive(rate: str) -> None:
    record, answers = growths(ExponentialGrowth(arb(rate), None))
    assert (record.events, record.remarks, record.for_ever, answers) == ([], [], False, [False])


def test_no_impact_after_the_end_of_the_time() -> None:
    """T = 15 is the end and 10 the beginning of the phase: the fifth step ends there, the sixth beyond it."""
    record, answers = growths(None, None, None, None, LASTING)
    assert ([event.upper for event in record.events], answers[-1]) == ([fmpq(15, 10)], True)
    record, answers = growths(None, None, None, None, None, LASTING)
    assert (record.events, answers[-1]) == ([], False)


def test_no_impact_in_flight() -> None:
    system = SimpleNamespace(events=[], supposed=(), phase="flight")
    scene = SimpleNamespace(epsilon=fmpq(1), stop_at_force=fmpq(9))
    observer = module._ImpactObserver(SimpleNamespace(system=system), arb(0), arb(9), scene, Record())  # type: ignore[arg-type]
    assert observer(SimpleNamespace(time=arb(0), end_time=arb(1)), {}) is False  # type: ignore[arg-type]


WITHOUT_STICK = ("compliant_contact", "lift_off", "tangential_motion")


@pytest.mark.parametrize(
    ("last", "u", "fate"),
    [
        ("19.4", "-1", REFUTED),
        ("19.6", "-1", None),  # certainly so at a time that may be after the end
        ("20.6", "-1", None),
        ("19.4", "0", None),
        ("19.4", "[0 +/- 1]", None),
    ],
)
def test_a_condition_that_fails_after_the_end_of_the_time_refutes_nothing(
    monkeypatch: pytest.MonkeyPatch, last: str, u: str, fate: str | None
) -> None:
    """T = 100 is the end. The last phase begins in a bracket around 80, so it is followed for 19.5 to 20.5."""
    durations = {"slip": "[60 +/- 0.5]", "flight": "20"}

    def ends(phase: CertifiedPhase, start: dict[str, arb], _: arb, __: object, observer: Any, *___: object) -> PhaseEnd:
        system, name = phase.system, phase.system.phase
        assert SHOWN is not None
        if name == "slip" and start[CLOCK] != 0:
            after = {**start, "u": arb(u), "b": arb(1), "Y": arb(-1), "Z": arb(1), "V": arb(1)}
            observer(SimpleNamespace(time=arb(0), end_time=arb(last)), after)
            return PhaseEnd(None, arb("[20 +/- 0.5]"), {**after, "u": arb(0, 1)}, SHOWN)
        event = next(event for event in system.events if not event.left_out)
        return PhaseEnd(event, arb(durations[name]), {**start, "Y": arb(0), "Z": arb(0)}, SHOWN)

    monkeypatch.setattr(CertifiedPhase, "run", ends)
    plain = load_scene("fig-varsim2", chi=0, epsilon="1/100", until=1)
    scene = Scene("test", WITHOUT_STICK, plain.epsilon, plain.until, {}, {**plain.start, "u": fmpq(1)})
    run = integrated_run(scene, bits=(128,))
    assert [event.name for event in run.events] == ["lift-off", "touch-down"]
    assert (run.fate == REFUTED) is (fate == REFUTED)
    assert run.verdict.outcome is (Outcome.REFUTED if fate else Outcome.PROVED)


def test_a_run_of_too_many_events_is_open(monkeypatch: pytest.MonkeyPatch) -> None:
    def ends(phase: CertifiedPhase, start: dict[str, arb], *_: object) -> PhaseEnd:
        assert SHOWN is not None
        return PhaseEnd(phase.system.events[0], arb("0.25"), {**start, "Y": arb(0), "Z": arb(0)}, SHOWN)

    monkeypatch.setattr(CertifiedPhase, "run", ends)
    run = integrated_run(load_scene("fig-varsim1", epsilon="1/100", until=1), bits=(128,))
    assert len(run.events) == MAX_EVENTS == 200
    assert run.fate == OPEN
    assert "the budget of 200 events ended (t = [0.5" in run.verdict.detail


def test_a_phase_that_stops_says_when_from_the_start_of_the_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Lift-off at T = 60, and the flight is followed for 15. A journal that could be written needs no note."""

    def ends(phase: CertifiedPhase, start: dict[str, arb], *_: object) -> PhaseEnd | Open:
        assert SHOWN is not None
        if phase.system.phase == "flight":
            return Open("it is hard", arb(15))
        return PhaseEnd(phase.system.events[0], arb(60), {**start, "Y": arb(0), "Z": arb(0)}, SHOWN)

    monkeypatch.setattr(CertifiedPhase, "run", ends)
    scene = load_scene("fig-varsim1", epsilon="1/64", until=2)
    for journal in (None, tmp_path / "journal"):
        run = integrated_run(scene, bits=(128,), journal=journal)
        assert [event.name for event in run.events] == ["lift-off"]
        assert run.verdict.detail.startswith("it is hard (t = 1.171875000 after the start)")
        assert run.notes == ()
