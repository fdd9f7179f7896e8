"""What leaving an effect out assumes, along the run: it holds, it fails, or the statement says that it is assumed.

Page: proofs/left_out_effects.md. The cases of ``hostile/`` were "proved" once.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from witnesses.plain_motion import Block, Start, plain_motion

from gspot_verified.mechanisms.input.given import from_fields, lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.numbers.balls import approximate
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Evidence, Outcome, Reason
from gspot_verified.scenes.certified.certified_integration import integrated_run
from gspot_verified.scenes.certified.certified_phase import Open
from gspot_verified.scenes.certified.certified_result import Record, event_of, growth_words, result_of, statement
from gspot_verified.scenes.certified.conditions import Conditions
from gspot_verified.scenes.certified.invariant_region import ExponentialGrowth
from gspot_verified.scenes.certified_run import certified_run, exact_start
from gspot_verified.scenes.effects.catalogue import EFFECTS
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.scene.assumption import ASSUMED, CHECKED, VIOLATED, Assumption, provided
from gspot_verified.scenes.scene.file import SHIPPED, load_scene
from gspot_verified.scenes.scene.run import IMPACT, NO_EVENT, OPEN, REFUTED, SceneRun, agreement
from gspot_verified.scenes.scene.scene import Scene

HOSTILE = Path(__file__).parents[1] / "hostile"
CONTACT = ("compliant_contact", "lift_off")
TANGENTIAL = (*CONTACT, "tangential_motion")
EPSILON = fmpq(1, 10)


def standing(run: SceneRun) -> dict[str, str]:
    return {each.effect: each.standing for each in run.assumptions}


def bracket(run: SceneRun, effect: str) -> tuple[fmpq, fmpq]:
    found = next(each for each in run.assumptions if each.effect == effect)
    assert found.lower is not None
    assert found.upper is not None
    return found.lower, found.upper


def block(coupling: str = "0", push: str = "-1/2", weight: str = "-1", mu: str = "1/4") -> Mechanism:
    return lagrangian("block", ["X", "H"], [[1, coupling], [coupling, 1]], [push, weight], "X", "H", mu)


def driven(push: str) -> Mechanism:
    """A block without friction, pushed along as a function of q = t."""
    mass = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    return lagrangian("driven", ["X", "H", "q"], mass, [push, -1, 0], "X", "H", 0)


def scene(mechanism: Mechanism, until: object, effects: tuple[str, ...] = TANGENTIAL, **start: str) -> Scene:
    return Scene(
        "test",
        effects,
        EPSILON,
        fmpq(str(until)) if isinstance(until, int) else fmpq(*until),
        {},
        start,
        None,
        mechanism,
    )  # type: ignore[misc]


HOSTILE_RUNS = [
    ("left_out_effect", "stick", "stick", ["impact without collision"]),
    ("g_touch", "stick", "touch-down", ["touch-down"]),
    ("c_notang_neg", "tangential_motion", None, []),
    ("pulls", "lift_off", "lift-off", []),
]


@pytest.mark.parametrize(("name", "effect", "event", "before"), HOSTILE_RUNS)
def test_an_absence_that_is_wrong_is_refuted(name: str, effect: str, event: str | None, before: list[str]) -> None:
    """At the time of the event that the scene with the effect has there (None: at the start)."""
    made = load_scene(HOSTILE / f"{name}.toml")
    run = certified_run(made)
    assert run.verdict.outcome is Outcome.REFUTED
    assert run.fate == REFUTED
    assert [each.name for each in run.events] == before
    assert standing(run)[effect] == VIOLATED
    wanted = f"effects '{effect}' and 'stick'" if effect == "tangential_motion" else f"effect '{effect}'"
    assert (run.verdict.witness or "").endswith(f"add the {wanted}")
    lower, upper = bracket(run, effect)
    if event is None:
        assert lower == upper == 0
        return
    full = certified_run(replace(made, effects=(*made.effects, effect), until=upper + EPSILON**3))
    there = next(each for each in full.events if each.name == event)
    assert there.lower <= upper
    assert lower <= there.upper
    assert upper - lower < fmpq(1, 10**18)


def test_a_float_run_agrees_with_nothing_that_is_refuted() -> None:
    made = load_scene(HOSTILE / "g_touch.toml", until="1/5")
    run, simulated = certified_run(made), float_run(made)
    assert agreement(simulated, run) is None
    assert standing(simulated) == {"stick": ASSUMED}
    assert "provided that the slip velocity is positive in contact (stick is left out)" in simulated.verdict.statement


@pytest.mark.parametrize(("effects", "checked"), [(CONTACT, "tangential_motion"), (TANGENTIAL, "stick")])
def test_an_absence_that_is_right_is_checked(effects: tuple[str, ...], checked: str) -> None:
    run = integrated_run(scene(block(), (1, 2), effects, X_dot="2"))
    assert run.verdict.outcome is Outcome.PROVED
    assert run.verdict.statement == "no change of phase until t = 1/2 after the start"
    assert standing(run) == {checked: CHECKED}
    assert "checked along the whole run" in str(run)


@pytest.mark.parametrize(
    ("start", "push", "phase"),
    [
        ({"y": "1/10", "v": "0", "z": "0", "X_dot": "1"}, "0", "flight"),
        ({"y": "-1/50", "v": "0", "z": "-1/100", "X_dot": "0"}, "0", "stick"),
        ({"X_dot": "0"}, "-1/2", "reverse slip"),
    ],
)
def test_a_run_without_events_that_is_no_slip_says_what_it_is(start: dict[str, str], push: str, phase: str) -> None:
    """The first is above the surface: "no change of phase" alone reads as contact. The last is at rest at the start,
    but friction does not hold it."""
    run = integrated_run(scene(block(push=push), (1, 16), (*TANGENTIAL, "stick"), **start))
    assert run.verdict.statement == f"{phase} from the start on, no change of phase until t = 1/16 after the start"


def test_the_force_is_followed_too() -> None:
    run = integrated_run(scene(block(), (1, 2), ("compliant_contact",), X_dot="2"))
    assert standing(run) == {"lift_off": CHECKED, "tangential_motion": CHECKED}
    assert run.verdict.outcome is Outcome.PROVED


def test_what_the_start_does_not_give_is_assumed() -> None:
    run = integrated_run(scene(block(), (1, 2), CONTACT))
    assert run.verdict.outcome is Outcome.PROVED
    assert run.verdict.statement.endswith(
        "provided that the slip velocity is positive in contact (tangential_motion is left out)"
    )
    assert standing(run) == {"tangential_motion": ASSUMED}
    assert bracket(run, "tangential_motion") == (0, 0)
    assert "the state X_dot is missing" in run.assumptions[0].why


@pytest.mark.parametrize(
    ("velocity", "expected"), [(None, ASSUMED), ("-2", CHECKED), ("-1/2", VIOLATED), ("1", VIOLATED)]
)
def test_the_velocity_of_the_surface(velocity: str | None, expected: str) -> None:
    """The block slows down from 0 at the rate 3/4 at most: it is the slip on the belt that counts."""
    made = scene(block(), 1, (*CONTACT, "belt"), X_dot="0")
    if velocity is not None:
        made = made.with_settings(belt_velocity=velocity)
    run = integrated_run(made)
    assert standing(run) == {"tangential_motion": expected}
    assert (run.verdict.outcome is Outcome.REFUTED) is (expected == VIOLATED)
    assert ("provided that" in run.verdict.statement) is (expected == ASSUMED)
    assert ("belt_velocity" in made.values()) is (velocity is not None)


def test_a_refutation_names_what_it_assumes() -> None:
    """That λ_N stays positive for 8/25 was refuted on every belt; it is true on one at whose velocity slip turns."""
    without = load_scene("oscillator", epsilon="1/100", until="8/25").with_effects(drop=("lift_off",))
    run = integrated_run(without)
    assert run.verdict.outcome is Outcome.REFUTED
    assert standing(run) == {"lift_off": VIOLATED, "tangential_motion": ASSUMED}
    assert run.verdict.statement == (
        "λ_N is positive in contact until t = 8/25 after the start, as leaving lift_off out assumes, provided that the "
        "slip velocity is positive in contact (tangential_motion is left out)"
    )
    turning = without.with_effects(add=("tangential_motion", "stick"), belt_velocity="-9/20")
    assert standing(integrated_run(turning)) == {"lift_off": CHECKED}


@pytest.mark.parametrize(
    ("push", "expected"), [("1", CHECKED), ("-1", VIOLATED), ("0", ASSUMED), ("q", CHECKED), ("-q", VIOLATED)]
)
def test_slip_that_is_zero_at_the_start(push: str, expected: str) -> None:
    """u = 0 there: its first derivative that is not 0 decides."""
    run = integrated_run(scene(driven(push), (1, 10), X_dot="0", q="0", q_dot="1"), bits=(128,))
    assert standing(run) == {"stick": expected}
    assert run.verdict.outcome is (Outcome.REFUTED if expected == VIOLATED else Outcome.PROVED)


@pytest.mark.parametrize(("first", "expected"), [("1", ASSUMED), ("1001/1000", CHECKED), ("999/1000", VIOLATED)])
def test_slip_that_only_touches_zero(first: str, expected: str) -> None:
    """u = (t - 1)² + first - 1: at first = 1 neither is certain, and the statement says so."""
    run = integrated_run(scene(driven("2*(q-1)"), 2, X_dot=first, q="0", q_dot="1"), bits=(128,))
    assert standing(run) == {"stick": expected}
    assert ("provided that" in run.verdict.statement) is (expected == ASSUMED)
    if expected == ASSUMED:
        lower, upper = bracket(run, "stick")
        assert fmpq(1, 2) < lower <= upper <= 1
    if expected == VIOLATED:
        time = 1 - 1000**-0.5
        assert approximate(bracket(run, "stick")[0]) == pytest.approx(time)


def test_what_is_lost_from_sight_and_fails_later() -> None:
    """u = (t - 1)² (2 - t) touches 0 at t = 1, which is open, and falls through it at t = 2, which is not."""
    run = integrated_run(scene(driven("2*(q-1)*(2-q) - (q-1)^2"), 3, X_dot="2", q="0", q_dot="1"), bits=(128,))
    assert run.verdict.outcome is Outcome.REFUTED
    lower, upper = bracket(run, "stick")
    assert fmpq(1, 2) < lower < 1
    assert 2 < upper < 3


def test_slip_in_flight_may_have_any_sign() -> None:
    """Thrown up, u falls through 0 in flight, and rises again before the contact closes."""
    made = scene(driven("2*(q-1)"), 3, X_dot="1/2", q="0", q_dot="1", y="3/2", v="1/2", z="0")
    run = integrated_run(made, bits=(128,))
    assert [event.name for event in run.events] == ["touch-down", "lift-off"][: len(run.events)]
    assert run.events
    assert standing(run) == {"stick": CHECKED}


def test_what_the_model_has_by_definition_is_not_assumed() -> None:
    """Paper, Sec. 2.3: no variation of the tangential velocity in the model system, the exact solution's."""
    made = load_scene("fig-varsim1")
    assert exact_start(made)[0].beta == made.values()["beta"]
    assert made.conditional() == ()
    assert certified_run(made).assumptions == ()
    assert "by definition" in made.assumes()["tangential_motion"]
    assumed = [scene.name for scene in map(load_scene, SHIPPED) if scene.conditional()]
    assert assumed == ["oscillator", "oscillator-canard"]  # on a belt whose velocity the paper does not give


def test_every_condition_is_stated_with_its_effect() -> None:
    assert {name for name, effect in EFFECTS.items() if effect.condition is not None} == {
        "lift_off",
        "tangential_motion",
        "stick",
    }


def timed(force: str) -> Mechanism:
    """s is the time, and x = r + s."""
    rates = ["w", force, "c", 0, 1]
    return from_fields("timed", ["h", "w", "r", "c", "s"], rates, [0, 0, 0, 1, 0], [0, 1, 0, 0, 0], "r + s", "h", 0)


CYCLIC = "nothing depends on where along the surface the contact is: x is cyclic"


@pytest.mark.parametrize(
    ("mechanism", "cyclic"),
    [
        (block(), True),
        (block(mu="1/4 + X^2"), False),
        (block(push="-X"), False),
        (block(push="-X", mu="0"), False),
        (lagrangian("by u", ["X", "H"], [[1, 0], [0, 1]], [0, -1], None, "H", 0, slip_velocity="X_dot - 1"), False),
        (timed("-1 - s"), True),
        (timed("-1 - r"), False),  # s moves x, too, but not freely: it is the time
    ],
    ids=["block", "mu", "spring", "no friction", "no x", "time", "time and place"],
)
def test_x_is_called_cyclic_only_where_it_is(mechanism: Mechanism, cyclic: bool) -> None:
    names = [name for name in mechanism.state if name not in ("H", "H_dot", "h", "w")]
    made = Scene("test", CONTACT, EPSILON, fmpq(1), {}, dict.fromkeys(names, "1"), None, mechanism)
    assert (made.assumes()["tangential_place"] == CYCLIC) is cyclic


def test_the_time_of_an_assumption_as_text() -> None:
    times = [("b", fmpq(1, 3), fmpq(1, 3)), ("c", fmpq(1, 8), fmpq(1, 8) + fmpq(1, 2**60))]
    found = [Assumption("a", "A", CHECKED), *(Assumption(name, "B", VIOLATED, *time) for name, *time in times)]
    assert [each.when for each in found[:2]] == ["all along", "t = 1/3"]
    assert found[2].when.startswith("t = [0.125000000000000000 +/-")
    assert [each.to_json()["time"] for each in found] == [
        None,
        {"lower": "1/3", "upper": "1/3"},
        {"lower": "1/8", "upper": str(fmpq(1, 8) + fmpq(1, 2**60))},
    ]


def test_an_assumption_has_a_time_unless_it_was_checked() -> None:
    with pytest.raises(ValueError, match="violated"):
        Assumption("stick", "u > 0", VIOLATED, fmpq(0))
    with pytest.raises(ValueError, match="violated"):
        Assumption("stick", "u > 0", VIOLATED, None, fmpq(0))
    with pytest.raises(ValueError, match="checked"):
        Assumption("stick", "u > 0", CHECKED, fmpq(0), fmpq(1))
    with pytest.raises(ValueError, match="assumed"):
        Assumption("stick", "u > 0", ASSUMED)
    two = [Assumption("a", "A", ASSUMED, fmpq(0), fmpq(0), "why"), Assumption("b", "B", CHECKED)]
    assert provided(two) == ", provided that A (a is left out)"


def test_what_is_watched_first_and_what_then() -> None:
    made = scene(block(), 1, ("compliant_contact", "tangential_motion"), X_dot="1")
    every = Conditions.of(made)
    names = [[effect.name for effect in watched] for watched in every.fewer()]
    assert names == [["lift_off", "stick"], ["lift_off"], ["stick"], []]
    assert every.lost == set()
    assert every.certain_until.is_zero()
    some = every.watching((EFFECTS["stick"],), arb(3))
    assert some.lost == {"lift_off"}
    assert some.followed == every.followed
    pulls, stops = made.system("slip", every.followed).events
    assert (pulls.left_out, stops.left_out) == ("lift_off", "stick")
    assert some.watches(stops)
    assert not some.watches(pulls)
    assert some.since(stops, arb(5)) == 5
    since = some.since(pulls, arb(5))
    assert since.contains(3)
    assert since.contains(5)
    unknown = Conditions.of(scene(block(), 1, CONTACT))
    assert unknown.followed == ()
    assert list(unknown.unknown) == ["tangential_motion"]


def is_about(assumption: Assumption, time: fmpq) -> bool:
    assert assumption.lower is not None
    assert assumption.upper is not None
    return bool(time - fmpq(1, 10**12) < assumption.lower <= time <= assumption.upper < time + fmpq(1, 10**12))


SHOWN = less(0, 1)
assert SHOWN is not None


def result(record: Record, watched: int = 1) -> SceneRun:
    """Of the block without stick, until t = 2, ε = 1/10; the condition is watched, or was lost at T = 3."""
    made = scene(block(), 2, TANGENTIAL, X_dot="2")
    every = Conditions.of(made)
    return result_of(made, every.watching(every.followed[:watched], arb(3)), record)


@pytest.mark.parametrize(("shown", "ended"), [([], SHOWN), ([SHOWN], None), ([SHOWN, SHOWN], SHOWN)])
def test_a_run_without_the_evidence_of_its_events_and_its_end_is_not_proved(
    shown: list[Evidence], ended: Evidence | None
) -> None:
    lift = event_of("lift-off", arb(10), EPSILON)
    with pytest.raises(ValueError, match="evidence"):
        result(Record([lift], shown=shown, ended=ended))


def test_each_end_of_a_run_has_its_verdict() -> None:
    lift = event_of("lift-off", arb("[10 +/- 0.5]"), EPSILON)
    assert lift.lower <= fmpq(19, 20)
    assert lift.upper >= fmpq(21, 20)
    clean = result(Record([lift], shown=[SHOWN], ended=SHOWN))
    assert clean.verdict.outcome is Outcome.PROVED
    assert clean.verdict.statement == "lift-off until t = 2 after the start, and no other change of phase"
    lost = result(Record([lift], shown=[SHOWN], ended=SHOWN), watched=0)
    assert lost.verdict.statement == clean.verdict.statement + provided(lost.assumptions)
    assert is_about(lost.assumptions[0], fmpq(3, 10))
    wrong = result(Record([lift], violated=("stick", arb(15), SHOWN)))
    assert wrong.verdict.outcome is Outcome.REFUTED
    assert wrong.assumptions[0].standing == VIOLATED
    assert is_about(wrong.assumptions[0], fmpq(3, 2))
    assert wrong.verdict.detail == "certain before it: lift-off"
    made = scene(block(), 2, ("compliant_contact",))
    two = result_of(made, Conditions.of(made), Record(violated=("lift_off", arb(15), SHOWN)))
    assert standing(two) == {"lift_off": VIOLATED, "tangential_motion": ASSUMED}
    assert two.verdict.detail == f"certain before it: {NO_EVENT}"
    assert two.verdict.statement.endswith(provided(two.assumptions))
    assert "(tangential_motion is left out)" in two.verdict.statement
    for budget, reason in ((True, Reason.BUDGET), (False, Reason.HYPOTHESIS)):
        stopped = result(Record([lift], open=Open("it is hard", arb(12), budget), seen=arb(11)))
        assert stopped.verdict.outcome is Outcome.UNDECIDED
        assert stopped.verdict.reason is reason
        assert stopped.fate == OPEN
        assert stopped.verdict.statement == "the events of the run"
        assert stopped.assumptions[0].standing == ASSUMED
        assert is_about(stopped.assumptions[0], fmpq(11, 10))
        assert stopped.verdict.detail.startswith("it is hard (t = [1.20000000")
        assert stopped.verdict.detail.endswith(" after the start); certain before it: lift-off")
    stopped = result(Record(open=Open("it is hard", arb(12))), watched=0)
    assert "provided that" in stopped.verdict.statement


def test_a_statement_says_how_far_growth_is_shown() -> None:
    assert statement(IMPACT, "", (None,)) == "impact without collision, and no other change of phase"
    assert "(λ_N grows 8-fold, or slip or stick ends)" in statement(IMPACT, "", (64, 8, None))
    impact = event_of(IMPACT, arb(1), EPSILON)
    words = "λ_N grows for as long as the contact slips"
    for_ever = result(Record([impact], multiples=[None], limits=[words], for_ever=True, shown=[SHOWN], ended=SHOWN))
    assert for_ever.verdict.statement == "impact without collision, and no other change of phase"
    ends = f"{words}, which ends within 0.3 ε"
    limited = result(Record([impact], multiples=[None], limits=[ends], shown=[SHOWN], ended=SHOWN))
    assert limited.verdict.statement.startswith(f"impact without collision ({ends})")
    both = [impact, impact]
    last = Record(both, multiples=[None, None], limits=[ends, words], for_ever=True, shown=[SHOWN, SHOWN], ended=SHOWN)
    assert f" ({ends}; then {words})" in result(last).verdict.statement
    twice = replace(last, remarks=["seen beside", ends, words])
    assert result(twice).verdict.detail == "seen beside"  # what the statement says is not said again
    several = replace(twice, multiples=[8, None])
    assert result(several).verdict.detail == f"seen beside; {ends}; {words}"


SMALL = st.fractions(min_value=-1, max_value=1, max_denominator=4)
LEFT_OUT = st.sampled_from([CONTACT, TANGENTIAL, ("compliant_contact",), ("compliant_contact", "tangential_motion")])
MARGIN = 1e-9


def judged_as_the_plain_motion(effects: tuple[str, ...], given_block: Block, start: Start) -> str:
    """The run is unconditioned "proved" only where u and λ stay positive in the plain motion, and refuted only where
    they do not."""
    lifts_off = "lift_off" in effects
    mechanism = block(str(given_block.coupling), *map(str, given_block.forces), str(given_block.mu))
    values = {"X_dot": str(start.slip), "y": str(start.height), "v": str(start.speed), "z": "0"}
    run = integrated_run(scene(mechanism, (1, 2), effects, **values), bits=(128,))
    seen = plain_motion(given_block, start, Fraction(1, 2), lifts_off)
    fails = seen.slip < -MARGIN or (not lifts_off and seen.force < -MARGIN)
    unconditioned = run.verdict.outcome is Outcome.PROVED and "provided that" not in run.verdict.statement
    assert not (fails and unconditioned), run
    if run.verdict.outcome is Outcome.REFUTED:
        assert seen.slip < MARGIN or (not lifts_off and seen.force < MARGIN), run
    return run.verdict.outcome.value


@pytest.mark.slow
@settings(max_examples=60, deadline=None)
@given(
    effects=LEFT_OUT,
    coupling=SMALL.map(lambda value: value * Fraction(3, 4)),
    push=SMALL.map(lambda value: 4 * value),
    weight=st.sampled_from([Fraction(-8), Fraction(-16)]),
    mu=SMALL.map(abs),
    slip=SMALL.map(abs),
    height=st.sampled_from([Fraction(0), Fraction(1, 20)]),
    speed=SMALL.map(lambda value: -abs(value)),
)
def test_random_blocks(
    effects: tuple[str, ...],
    coupling: Fraction,
    push: Fraction,
    weight: Fraction,
    mu: Fraction,
    slip: Fraction,
    height: Fraction,
    speed: Fraction,
) -> None:
    """b < 0, so that a start without height is in contact."""
    start = Start(slip, height if "lift_off" in effects else Fraction(0), speed)
    judged_as_the_plain_motion(effects, Block(coupling, (push, weight), mu, Fraction(1, 10)), start)


@pytest.mark.parametrize(
    ("effects", "push", "slip", "speed", "expected"),
    [
        (CONTACT, "-1/2", "1", "0", "proved"),
        (CONTACT, "-1/2", "1/8", "0", "refuted"),
        (CONTACT, "-1/2", "2", "-1", "proved"),
        (TANGENTIAL, "-2", "1/2", "0", "refuted"),
        (("compliant_contact",), "-1/2", "8", "-1", "refuted"),  # it bounces, and the surface pulls
        (("compliant_contact", "tangential_motion"), "-1/2", "2", "0", "proved"),
    ],
)
def test_some_blocks(effects: tuple[str, ...], push: str, slip: str, speed: str, expected: str) -> None:
    given_block = Block(Fraction(1, 4), (Fraction(push), Fraction(-1)), Fraction(1, 2), Fraction(1, 10))
    assert (
        judged_as_the_plain_motion(effects, given_block, Start(Fraction(slip), Fraction(0), Fraction(speed)))
        == expected
    )


@pytest.mark.parametrize(
    ("push", "violated", "other"), [(-4, "tangential_motion", "lift_off"), (4, "lift_off", "tangential_motion")]
)
def test_what_a_run_does_not_reach_is_not_checked_along_it(push: int, violated: str, other: str) -> None:
    """A block that stops at t = 1/4, and that a force lifts at t = 0.56: the run ends at what fails first."""
    mass = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    lifted = lagrangian("lifted", ["X", "H", "q"], mass, [push, "-1+2*q", 0], "X", "H", 0)
    run = integrated_run(scene(lifted, 3, CONTACT[:1], X_dot="1", q="0", q_dot="1"), bits=(128,))
    assert run.fate == REFUTED
    assert standing(run) == {violated: VIOLATED, other: ASSUMED}
    assert bracket(run, other)[1] <= bracket(run, violated)[0]
    assert "provided" not in str(run.verdict)


def test_the_condition_is_refuted_and_not_the_motion() -> None:
    """Without friction a block that turns moves on as if no effect were missing: "the motion without tangential_motion
    is that with it" was refuted, and is true."""
    run = integrated_run(scene(block(mu="0"), 4, CONTACT, X_dot="1"), bits=(128,))
    assert run.verdict.outcome is Outcome.REFUTED
    assert run.verdict.statement == (
        "the slip velocity is positive in contact until t = 4 after the start, as leaving tangential_motion out assumes"
    )


def _slider(A: str, C: str, mu: str) -> Mechanism:
    """X'' = -1/2 + A lambda_T, H'' = -1 + C lambda_N: pressed on by its weight."""
    return from_fields(
        "slider", ["X", "H", "U", "V_H"], ["U", "V_H", "-1/2", -1], [0, 0, A, 0], [0, 0, 0, C], "X", "H", mu
    )


@pytest.mark.parametrize(
    ("A", "C", "mu", "least"),
    [("1", "1", "1/4 - X", "mu"), ("1/2 - X", "1", "1/4", "A"), ("1", "1/2 - X", "1/4", "A C - B^2")],
)
def test_a_run_says_nothing_where_its_equations_have_no_sense(A: str, C: str, mu: str, least: str) -> None:
    """Friction that pushes on: mu < 0 or A < 0 from X = 1/4 or 1/2 on, which slip with the velocity 2 reaches soon. A
    force that pulls where it should push, C < 0: an impact without friction was "proved"."""
    made = scene(_slider(A, C, mu), (1, 20), (*TANGENTIAL, "stick"), X="0", U="2", y="-2/100", v="0", z="-1/100")
    assert integrated_run(made, bits=(128,)).verdict.outcome is Outcome.PROVED
    run = integrated_run(replace(made, until=fmpq(1)), bits=(128,))
    assert run.verdict.outcome is Outcome.UNDECIDED
    assert f"{least} may be negative" in run.verdict.detail


@pytest.mark.parametrize("coupling", ["1/2", "-1/2"])
def test_friction_has_no_sense_where_the_slip_velocity_is_not_seen_either(coupling: str) -> None:
    """mu = 1/4 - q falls below 0 at q = t = 1/4, on a belt of an unknown velocity. With a coupling above 0 p = C - mu B
    then falls below 0, and the force grows for ever: an impact by friction that pushes on was "proved", provided that
    slip is positive."""
    mass = [[1, coupling, 0], [coupling, 1, 0], [0, 0, 1]]
    worn = lagrangian("worn", ["X", "H", "q"], mass, [0, -1, 0], "X", "H", "1/4 - q")
    made = scene(worn, (1, 5), (*CONTACT, "belt"), q="0", q_dot="1")
    assert integrated_run(made, bits=(128,)).fate == NO_EVENT
    run = integrated_run(replace(made, until=fmpq(6)), bits=(128,))
    assert (run.verdict.outcome, run.fate) == (Outcome.UNDECIDED, OPEN)
    assert "mu may be negative" in run.verdict.detail


def test_the_words_of_growth_are_rounded_to_the_safe_side() -> None:
    """The rate down, times up: 1/3 and 2/3, and what is known of the end."""
    third = arb(1) / 3
    lasting = growth_words(ExponentialGrowth(third, None), sticks=False, since=None)
    assert lasting == "λ_N grows at least like exp(0.333 t/ε) for as long as the contact slips"
    assert (
        growth_words(ExponentialGrowth(third, None, 2 * third), False, None) == f"{lasting}, which ends within 0.667 ε"
    )
    assert growth_words(ExponentialGrowth(2 * third, 8), True, third) == (
        "from t = 0.333334 after the start on λ_N grows at least like exp(0.666 t/ε) until it is 8 times as large, "
        "or stick ends"
    )


def test_a_condition_that_fails_within_the_one_step_of_a_phase_is_seen() -> None:
    """u = 0 at the start and pushed backwards: lift-off at .03665 ends the slip in its first step, whose end no
    observer sees. It was "proved, provided that the slip velocity is positive"."""
    start = {"p": fmpq(1101, 1000), "b": fmpq(-47, 1000), "v": fmpq(3, 350), "u": fmpq(0)}
    start |= dict.fromkeys("yz", fmpq(-407, 625000))
    parameters = {"alpha_1": fmpq(-12, 7), "alpha_2": fmpq(991, 1000), "beta": fmpq(29, 8), "a": fmpq(-127, 250)}
    parameters["k_plus"] = fmpq(1, 8)
    scene = Scene("pushed back", TANGENTIAL, fmpq(1, 50), fmpq(18325366, 500000000), parameters, start)
    for until in (scene.until, fmpq(37, 1000)):
        run = integrated_run(replace(scene, until=until))
        assert run.fate == REFUTED
        assert standing(run)["stick"] == VIOLATED
        lower, upper = bracket(run, "stick")
        assert lower <= 0
        assert upper <= fmpq(37, 1000)


def test_a_condition_that_fails_from_the_start_on_and_holds_again_within_one_step_is_seen() -> None:
    """u = 0, u' = a < 0 at the start, and λ_N, which begins with 0, pushes it up again: no end of a step shows it."""
    start = {"p": fmpq(1, 4), "b": fmpq(-10, 7), "v": fmpq(-3, 400), **dict.fromkeys("yzu", fmpq(0))}
    parameters = {"alpha_1": fmpq(307, 1000), "alpha_2": fmpq(0), "beta": fmpq(21, 8)}
    parameters |= {"a": fmpq(-1, 2), "k_plus": fmpq(6, 7)}
    scene = Scene("pushed back and on", TANGENTIAL, fmpq(1, 50), fmpq(39, 100), parameters, start)
    run = integrated_run(scene)
    assert run.fate == REFUTED
    assert bracket(run, "stick") == (0, 0)
    ahead = integrated_run(replace(scene, parameters={**parameters, "a": -parameters["a"]}))
    assert ahead.fate == NO_EVENT
    assert standing(ahead)["stick"] == CHECKED


def test_a_condition_that_is_left_in_a_third_derivative_is_seen_at_the_event_that_ends_the_step() -> None:
    """u = u' = u'' = 0 > u''' at the start: no sign is asked that far, and lift-off at .00597 ends the first step."""
    start = {"p": fmpq(1, 10), "b": fmpq(-1, 10), **dict.fromkeys("yzvu", fmpq(0))}
    parameters = {"alpha_1": fmpq(-1), "alpha_2": fmpq(50), "beta": fmpq(2, 3), "a": fmpq(0), "k_plus": fmpq(-1)}
    run = integrated_run(Scene("slowed", TANGENTIAL, EPSILON, fmpq(1, 2), parameters, start))
    assert run.fate == REFUTED
    assert standing(run)["stick"] == VIOLATED
    assert fmpq(597, 100000) <= bracket(run, "stick")[1] <= fmpq(598, 100000)


def test_a_condition_that_fails_in_a_phase_of_one_step_up_to_the_end_is_seen() -> None:
    """u = 1 - t is 0 at touch-down, at t = 1, and negative after it: this phase has one step, which ends with the run.
    It was "proved, provided that the slip velocity is positive"."""
    for effects, effect in ((CONTACT, "tangential_motion"), (TANGENTIAL, "stick")):
        falling = scene(block(push="-1"), 2, effects, X_dot="1", y="1/2", v="0", z="0")
        run = integrated_run(replace(falling, epsilon=fmpq(1, 2)))
        assert run.fate == REFUTED
        assert [event.name for event in run.events] == ["touch-down"]
        assert standing(run)[effect] == VIOLATED
        lower, upper = bracket(run, effect)
        assert lower <= 1 <= upper


def test_a_wide_bracket_of_a_failure_is_written_by_its_ends() -> None:
    """As a middle and a radius it reached below 0, where nothing moves yet."""
    found = Assumption("stick", "u > 0", VIOLATED, fmpq(83, 320), fmpq(3, 4))
    assert found.when == "t = [0.259, 0.751]"
