"""The runs of Fig. varsim2: what each step asks for and must refuse, without a simulation."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.model.normal_form import compliant_model
from gspot_verified.compliant.motion.compliant_force import force as compliant_force
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.checks.entry import Rung
from gspot_verified.paper.numerics.paper_state import paper_state
from gspot_verified.paper.section_3 import varsim2 as ledger
from gspot_verified.paper.section_3.varsim2 import IMPACT, LIFT_OFF, STICK
from gspot_verified.scenes.certified.certified_result import statement
from gspot_verified.scenes.scene.run import RunEvent

QUARTER, FOUR = fmpq(1, 4), fmpq(4)


def run(*events: tuple[str, Any], proved: bool = True, multiples: tuple[int | None, ...] = ()) -> Any:
    """A run with these events, each at one time; λ_N is seen to grow up to the least of the multiples."""
    outcome = Outcome.PROVED if proved else Outcome.UNDECIDED
    fate, span = ", ".join(name for name, _ in events), " until t = 3 after the start"
    said = statement(fate, span, multiples, ("λ_N grows at least like exp(0.5 t/ε) for as long as the contact slips",))
    return SimpleNamespace(
        events=[RunEvent(name, fmpq(time), fmpq(time)) for name, time in events],
        fate=fate,
        verdict=SimpleNamespace(outcome=outcome, statement=said),
    )


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> list[tuple[Any, ...]]:
    """The runs that are asked for; each has the events of the figure."""
    calls: list[tuple[Any, ...]] = []

    def run_of(chi: int, nu: fmpq, slip: fmpq | None = None) -> Any:
        calls.append((chi, nu) if slip is None else (chi, nu, slip))
        names = ledger.RUNS[chi, nu] if slip is None else (LIFT_OFF,)
        return run(*((name, k + 1) for k, name in enumerate(names)))

    monkeypatch.setattr(ledger, "run_of", run_of)
    monkeypatch.setattr(ledger, "slip_velocity", lambda *_: arb(1))
    monkeypatch.setattr(ledger, "sticks_by_the_exact_solution", lambda _: True)
    monkeypatch.setattr(ledger, "floats_agree", lambda *_: True)
    return calls


def test_a_run_is_that_of_the_caption(monkeypatch: pytest.MonkeyPatch) -> None:
    scenes: list[Any] = []
    monkeypatch.setattr(ledger, "load_scene", lambda name, **values: scenes.append((name, values)))
    monkeypatch.setattr(ledger, "certified_run", lambda *_: "run")
    ledger.run_of.cache_clear()
    try:
        assert [ledger.run_of(1, FOUR), ledger.run_of(0, FOUR, fmpq(200))] == ["run", "run"]
    finally:
        ledger.run_of.cache_clear()
    same = {"nu": FOUR, "beta": fmpq(1, 2), "epsilon": fmpq(1, 1000)}
    assert scenes == [("fig-varsim2", same | {"chi": 1, "u": 70}), ("fig-varsim2", same | {"chi": 0, "u": 200})]


def test_the_events_of_a_run() -> None:
    events = (IMPACT, STICK)
    assert ledger.happens(run((IMPACT, 1), (STICK, 2)), events) is True
    assert ledger.happens(run((STICK, 1), (IMPACT, 2)), events) is False
    assert ledger.happens(run((IMPACT, 1), (STICK, 2), (LIFT_OFF, 3)), events) is False
    assert ledger.happens(run((IMPACT, 1), (STICK, 2), proved=False), events) is None


def test_an_impact_begins_after_the_g_spot_and_grows_for_as_long_as_it_slips(monkeypatch: pytest.MonkeyPatch) -> None:
    def answer(time: fmpq, **others: Any) -> bool | None:
        monkeypatch.setattr(ledger, "run_of", lambda *_: run((IMPACT, time), (STICK, 1), **others))
        return ledger.grows_after_the_spot(FOUR)

    after = fmpq(51, 100)
    assert answer(after) is answer(after, multiples=(None,)) is True
    assert answer(fmpq(1, 2)) is answer(after, multiples=(8,)) is answer(after, proved=False) is None
    monkeypatch.setattr(ledger, "run_of", lambda *_: run((STICK, 1)))
    assert ledger.grows_after_the_spot(FOUR) is None


@pytest.mark.parametrize("nu", [QUARTER, FOUR])
@pytest.mark.parametrize("time", [fmpq(1, 10), fmpq(3, 10), fmpq(1, 2)])
def test_the_slip_velocity_falls_with_the_force(nu: fmpq, time: fmpq) -> None:
    """du/dt = -λ_N with χ = 0, as a difference quotient; u(0) = 70."""
    model, step = compliant_model(fmpq(1, 2), fmpq(1, 1000)), fmpq(1, 10**6)
    state = paper_state(model, nu)
    force = compliant_force(model, state, state.p / model.alpha_1 + time, 20).force
    before, after = (ledger.slip_velocity(nu, time + sign * step) for sign in (-1, 1))
    with working_bits(128):
        quotient = (after - before) / (2 * step)
        assert abs(quotient + force) < arb("1e-3") * (1 + abs(force))
    assert abs(ledger.slip_velocity(nu, fmpq(0)) - 70) < arb("1e-9")


@pytest.mark.parametrize(
    ("events", "velocity", "answer"),
    [
        ([(IMPACT, 0), (STICK, 2)], lambda time: 2 - time, True),
        ([(STICK, 2)], lambda time: time - 2, False),
        ([(STICK, 2)], lambda _: arb(1), False),
        ([(STICK, 2)], lambda _: arb(-1), False),
        ([(STICK, 2)], lambda time: arb(0, 1) if time < 2 else arb(-1), None),
        ([(STICK, 2)], lambda time: arb(1) if time < 2 else arb(0, 1), None),
        ([(STICK, 2)], lambda time: 2 + fmpq(2, 10**9) - time, False),  # later than 10^-9 after it
        ([(STICK, 2)], lambda time: 2 - fmpq(2, 10**9) - time, False),
        ([(LIFT_OFF, 2)], lambda time: 2 - time, None),
        ([(STICK, 2), (STICK, 3)], lambda time: 2 - time, None),
    ],
)
def test_a_stick_by_the_exact_solution(
    monkeypatch: pytest.MonkeyPatch, events: list[tuple[str, int]], velocity: Any, answer: bool | None
) -> None:
    monkeypatch.setattr(ledger, "run_of", lambda *_: run(*events))
    monkeypatch.setattr(ledger, "slip_velocity", lambda _, time: arb(velocity(time)))
    assert ledger.sticks_by_the_exact_solution(FOUR) is answer


@pytest.mark.parametrize(
    ("certified", "seen", "answer"),
    [
        ([(IMPACT, 1), (STICK, 2), (LIFT_OFF, 3)], [(STICK, 2), (LIFT_OFF, 3)], True),
        ([(STICK, 2), (LIFT_OFF, 3)], [(STICK, 2), (LIFT_OFF, fmpq(30000999, 10**7))], True),
        ([(STICK, 2), (LIFT_OFF, 3)], [(STICK, 2), (LIFT_OFF, fmpq(30001, 10**4))], False),
        ([(STICK, 2), (LIFT_OFF, 3)], [(STICK, 1), (LIFT_OFF, 3)], False),
        ([(STICK, 2), (LIFT_OFF, 3)], [(LIFT_OFF, 2), (STICK, 3)], False),
        ([(STICK, 2)], [(STICK, 2), (LIFT_OFF, 3)], False),
        ([(STICK, 2), (LIFT_OFF, 3)], [(STICK, 2)], False),
    ],
)
def test_a_float_run_beside_a_certified_one(
    monkeypatch: pytest.MonkeyPatch, certified: Any, seen: Any, answer: bool
) -> None:
    monkeypatch.setattr(ledger, "run_of", lambda *_: run(*certified))
    monkeypatch.setattr(ledger, "load_scene", lambda *_, **__: "scene")
    monkeypatch.setattr(ledger, "float_run", lambda *_: run(*seen))
    assert ledger.floats_agree(0, QUARTER) is answer


@pytest.mark.parametrize(
    ("claimed", "found", "answer"),
    [
        ((IMPACT, STICK, LIFT_OFF), True, True),
        ((STICK,), True, True),
        ((IMPACT, LIFT_OFF), True, False),
        ((IMPACT,), True, False),
        ((STICK,), False, False),
        ((STICK,), None, None),
        ((LIFT_OFF,), None, None),
    ],
)
def test_stick_is_claimed_and_found_first(
    monkeypatch: pytest.MonkeyPatch, claimed: tuple[str, ...], found: bool | None, answer: bool | None
) -> None:
    monkeypatch.setitem(ledger.RUNS, (0, FOUR), claimed)
    monkeypatch.setattr(ledger, "sticks_by_the_exact_solution", lambda nu: found if nu == FOUR else not found)
    assert ledger.sticks_first(FOUR) is answer


def test_what_is_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    runs = {
        (0, QUARTER): run((STICK, 1), (LIFT_OFF, 2)),
        (0, FOUR): run((IMPACT, 1)),
        (1, QUARTER): run((IMPACT, 1), (LIFT_OFF, 2)),
        (1, FOUR): run((LIFT_OFF, 1), (STICK, 2)),
    }
    monkeypatch.setattr(ledger, "run_of", lambda chi, nu: runs[chi, nu])
    assert ledger.lift_off_without_stick() == [(1, QUARTER), (1, FOUR)]
    assert ledger.all_proved() is True
    assert [ledger.as_many(count) for count in (0, 1, 2)] == [False, True, False]
    runs[1, FOUR] = run((LIFT_OFF, 1), proved=False)
    assert ledger.all_proved() is None
    assert ledger.as_many(1) is None


def test_two_times_are_close() -> None:
    near = fmpq(1, 10**9)
    assert ledger._close([fmpq(1)], [1 + near / 2]) is True
    assert ledger._close([fmpq(1)], [1 - near / 2]) is True
    assert ledger._close([fmpq(1)], [1 + near]) is False
    assert ledger._close([fmpq(1), fmpq(2)], [fmpq(1), fmpq(3)]) is False
    assert ledger._close([], []) is None
    assert ledger._close([fmpq(1)], []) is None
    assert ledger._close([fmpq(1)], [fmpq(1), fmpq(2)]) is None


def test_both_directions_of_coupling_have_their_own_second_route(asked: list[Any]) -> None:
    for (chi, nu), events in ledger.RUNS.items():
        entry = ledger.ENTRIES[ledger.identifier(chi, nu)]()
        assert set(asked) == {(chi, nu)}
        asked.clear()
        assert [check.agrees for check in entry.checks] == [True, True]
        assert ("exact solution" in entry.checks[1].what) is (chi == 0)
        assert entry.statement == (
            f"The run of Figure 9 with χ = {chi}, ν = {nu} (ε = 1/1000, β = 1/2, u(0) = 70) has up to t = 1 these "
            f"events in this order, and no other change of phase: {', '.join(events)}"
        )


def test_the_two_way_runs_are_compared_with_their_own_float_run(
    monkeypatch: pytest.MonkeyPatch, asked: list[Any]
) -> None:
    compared: list[Any] = []
    monkeypatch.setattr(ledger, "floats_agree", lambda chi, nu: compared.append((chi, nu)))
    for nu in (QUARTER, FOUR):
        assert [check.agrees for check in ledger.ENTRIES[ledger.identifier(1, nu)]().checks] == [True, None]
    assert compared == [(1, QUARTER), (1, FOUR)]
    assert asked
    slow = {nu: "not large enough" in ledger.ENTRIES[ledger.identifier(1, nu)]().note for nu in (QUARTER, FOUR)}
    assert slow == {QUARTER: False, FOUR: True}


def test_an_impact_that_is_listed_is_seen_to_grow(monkeypatch: pytest.MonkeyPatch, asked: list[Any]) -> None:
    def first_checks() -> dict[tuple[int, fmpq], bool | None]:
        return {key: ledger.ENTRIES[ledger.identifier(*key)]().checks[0].agrees for key in ledger.RUNS}

    assert set(first_checks().values()) == {True}
    monkeypatch.setattr(ledger, "grows_after_the_spot", lambda nu: None if nu == FOUR else True)
    assert first_checks() == {key: None if key == (0, FOUR) else True for key in ledger.RUNS}
    assert asked


def test_the_sentence_on_sticking_is_on_both_one_way_runs(monkeypatch: pytest.MonkeyPatch, asked: list[Any]) -> None:
    assert [check.agrees for check in ledger.ENTRIES["3-impact-to-stick"]().checks] == [True, True]
    assert set(asked) == {(0, QUARTER), (0, FOUR)}
    monkeypatch.setattr(ledger, "sticks_by_the_exact_solution", lambda nu: nu != FOUR)
    assert [check.agrees for check in ledger.ENTRIES["3-impact-to-stick"]().checks] == [True, False]


def test_the_sentence_on_fast_slip_is_on_three_runs(monkeypatch: pytest.MonkeyPatch, asked: list[Any]) -> None:
    seen: list[Any] = []
    monkeypatch.setattr(ledger, "floats_lift_off", lambda nu, slip: bool(seen.append((nu, slip)) or True))
    entry = ledger.ENTRIES["3-large-slip"]()
    assert [check.agrees for check in entry.checks] == [True, True]
    assert [check.rung for check in entry.checks] == [Rung.BALLS, Rung.POINTS]
    runs = [(QUARTER, fmpq(70)), (FOUR, fmpq(200)), (FOUR, fmpq(1000))]
    assert set(asked) == {(1, nu, slip) for nu, slip in runs}
    assert seen == runs
    assert "ν = 1/4 with u(0) = 70, ν = 4 with u(0) = 200" in entry.checks[0].what
    monkeypatch.setattr(ledger, "run_of", lambda *run_: run((LIFT_OFF, 1 if run_[-1] != 1000 else 2)))
    assert [check.agrees for check in ledger.ENTRIES["3-large-slip"]().checks] == [True, False]


@pytest.mark.parametrize(
    ("certified", "seen", "answer"),
    [
        ([(LIFT_OFF, 1)], [(LIFT_OFF, fmpq(100009, 10**5))], True),
        ([(LIFT_OFF, 1)], [(LIFT_OFF, fmpq(10001, 10**4))], False),
        ([(LIFT_OFF, 1)], [(LIFT_OFF, fmpq(1, 2))], False),
        ([(LIFT_OFF, 1)], [(STICK, 1)], False),
        ([(LIFT_OFF, 1)], [(STICK, 1), (LIFT_OFF, 1)], False),
        ([], [(LIFT_OFF, 1)], None),
    ],
)
def test_a_float_run_of_fast_slip(monkeypatch: pytest.MonkeyPatch, certified: Any, seen: Any, answer: Any) -> None:
    scenes: list[Any] = []
    monkeypatch.setattr(ledger, "run_of", lambda *_: run(*certified))
    monkeypatch.setattr(ledger, "load_scene", lambda _, **values: scenes.append(values))
    monkeypatch.setattr(ledger, "float_run", lambda *_: run(*seen))
    assert ledger.floats_lift_off(FOUR, fmpq(200)) is answer
    assert scenes == [{"chi": 1, "nu": FOUR, "u": 200, "beta": fmpq(1, 2), "epsilon": fmpq(1, 1000)}]


def test_the_caption_needs_the_drawn_events_too(monkeypatch: pytest.MonkeyPatch, asked: list[Any]) -> None:
    entry = ledger.ENTRIES["3-varsim2-caption"]()
    assert [check.agrees for check in entry.checks] == [True, True]
    assert entry.checks[0].finding == "χ = 1, ν = 1/4"
    assert set(asked) == set(ledger.RUNS)
    monkeypatch.setattr(ledger, "floats_agree", lambda chi, nu: (chi, nu) != (1, FOUR))
    assert [check.agrees for check in ledger.ENTRIES["3-varsim2-caption"]().checks] == [True, False]
    monkeypatch.setattr(ledger, "floats_agree", lambda *_: True)
    monkeypatch.setattr(ledger, "RUNS", {**ledger.RUNS, (1, FOUR): (IMPACT,)})
    assert [check.agrees for check in ledger.ENTRIES["3-varsim2-caption"]().checks] == [True, True]


def test_slip_falls_as_long_as_there_is_a_force(monkeypatch: pytest.MonkeyPatch) -> None:
    assert ledger.slip_slows_down() is True
    for wrong in ("lam", "1 - lam", "0*lam"):
        monkeypatch.setitem(ledger.SLIP, "u", wrong)
        assert ledger.slip_slows_down() is False
