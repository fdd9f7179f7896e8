"""Runs by the integrator against the exact solution, an exact integral, closed forms and float runs; hard cases.

Pages: proofs/norm_step.md, proofs/invariant_region.md.
"""

from __future__ import annotations

import re
from dataclasses import replace
from decimal import Decimal

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.model.normal_form import compliant_model, compliant_state
from gspot_verified.compliant.side.side_rule import side_rule
from gspot_verified.integrator.norm_steps.norm_run import NormRun
from gspot_verified.integrator.norm_steps.norm_step import StateSet
from gspot_verified.integrator.norm_steps.slow_curve import slow_curve
from gspot_verified.numbers.balls import approximate, sign_of, working_bits
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.scenes.certified.certified_integration import integrated_run
from gspot_verified.scenes.certified.certified_phase import CLOCK, CertifiedPhase, Open, PhaseEnd
from gspot_verified.scenes.certified.invariant_region import InvariantRegion
from gspot_verified.scenes.certified_run import EXACT, INTEGRATOR, NotCovered, certified_run, exact_start
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.motions.contact_form import NotOfThisForm
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.numbers import scene_number
from gspot_verified.scenes.scene.run import FLIGHT_THEN_IMPACT, IMPACT, OPEN, SceneRun, agreement
from gspot_verified.scenes.scene.scene import Scene, SceneError
from gspot_verified.scenes.side import certified_side

RUNS = [
    ("1/2", "1/4"), ("3/2", "1/4"), ("3/2", "2"), ("5/2", "1/2"),
    *(pytest.param(*run, marks=pytest.mark.slow) for run in (("1/2", "4"), ("3/2", "4"), ("5/2", "2"))),
]  # fmt: skip


def names(run: SceneRun) -> list[str]:
    return [event.name for event in run.events]


@pytest.mark.parametrize(("beta", "nu"), RUNS)
def test_two_routes_overlap(beta: str, nu: str) -> None:
    """Fig. varsim1 at epsilon = 1e-3: the integrator and the exact solution name the same events, in brackets that
    have a time in common."""
    scene = load_scene("fig-varsim1", beta=beta, nu=nu, epsilon="1e-3")
    integrated, exact = certified_run(scene, route=INTEGRATOR), certified_run(scene, route=EXACT)
    assert integrated.verdict.outcome is Outcome.PROVED
    assert integrated.fate == exact.fate
    for ours, theirs in zip(integrated.events, exact.events, strict=False):
        if ours.name == IMPACT:
            break
        assert ours.name == theirs.name
        assert ours.lower <= theirs.upper
        assert theirs.lower <= ours.upper
        assert ours.upper - ours.lower < fmpq(1, 10**20)


@pytest.mark.parametrize(
    ("changed", "hypothesis"),
    [({"beta": "1"}, "beta: expected a number in"), ({"alpha_1": "0"}, "alpha_1: expected a number < 0"),
     ({"alpha_1": "1"}, "alpha_1: expected a number < 0"), ({"beta": "-1"}, "alpha_3 = beta alpha_1: expected"),
     ({"beta": "101"}, "beta: expected a number in"), ({"eps": "2e6"}, "epsilon: expected")],
    ids=str,
)  # fmt: skip
def test_hypotheses_of_the_exact_solution(changed: dict[str, str], hypothesis: str) -> None:
    """Where one fails the exact route says which, as an error of the scene; the integrator has none of them."""
    scene = load_scene("fig-varsim1", until="1/1000", **({"eps": "1e-3", "b": "-1"} | changed))
    with pytest.raises(NotCovered, match=hypothesis.replace("(", r"\(")):
        exact_start(scene)
    with pytest.raises(SceneError, match="the exact solution"):
        certified_run(scene, route=EXACT)
    with pytest.raises(SceneError, match="the exact solution"):
        certified_side(scene)
    found, integrated = certified_run(scene), certified_run(scene, route=INTEGRATOR)
    assert found.verdict == integrated.verdict
    if changed in ({"beta": "1"}, {"alpha_1": "1"}):
        assert found.verdict.outcome is Outcome.PROVED


@pytest.mark.slow
@pytest.mark.parametrize("eps", ["2e-3", "1e-4"])
def test_two_routes_overlap_at_other_epsilons(eps: str) -> None:
    scene = load_scene("fig-varsim1", epsilon=eps)
    integrated, exact = certified_run(scene, route=INTEGRATOR), certified_run(scene, route=EXACT)
    assert integrated.fate == exact.fate == FLIGHT_THEN_IMPACT
    for ours, theirs in zip(integrated.events[:2], exact.events, strict=True):
        assert ours.lower <= theirs.upper
        assert theirs.lower <= ours.upper


@pytest.mark.parametrize(
    ("chi", "nu", "expected"),
    [
        (0, "1/4", [IMPACT, "stick", "lift-off"]),
        pytest.param(0, "4", [IMPACT, "stick", "lift-off"], marks=pytest.mark.slow),
        (1, "1/4", ["lift-off"]),
        pytest.param(1, "4", ["stick", "lift-off"], marks=pytest.mark.slow),
    ],
)
def test_the_runs_of_varsim2(chi: int, nu: str, expected: list[str]) -> None:
    """Paper: lift-off occurs without a transition to stick in one out of four cases. Floats see the same times."""
    scene = load_scene("fig-varsim2", chi=chi, nu=nu)
    run = integrated_run(scene)
    assert run.verdict.outcome is Outcome.PROVED
    assert names(run) == expected
    simulated = float_run(scene)
    assert agreement(simulated, run) is True
    certain = [event for event in run.events if event.name != IMPACT]
    for ours, seen in zip(certain, simulated.events, strict=True):
        assert abs(approximate(ours.lower - seen.lower)) < 1e-8
        assert ours.upper - ours.lower < fmpq(1, 10**20)


def test_slip_is_an_exact_integral() -> None:
    """chi = 0: u' = -lambda and b' = -1 + beta lambda in the paper's time, so u = u_0 - (b - b_0 + t)/beta in slip."""
    scene = load_scene("fig-varsim2", chi=0)
    with working_bits(192):
        phase = CertifiedPhase(scene.system("slip"))
        start = {name: arb(value) for name, value in scene.scaled_initial().items()} | {CLOCK: arb(0)}
        checked = 0

        def observer(segment: object, states: object) -> bool:
            nonlocal checked
            time = segment.end_time * scene.epsilon  # type: ignore[attr-defined]
            u, b = states["u"], states["b"]  # type: ignore[index]
            value = u - start["u"] + (b - start["b"] + time) / fmpq(1, 2)
            assert value.is_finite()
            assert value.contains(0)
            assert value.rad() < 1e-25
            checked += 1
            return False

        found = phase.run(start, arb(1000), {}, observer)
        assert isinstance(found, PhaseEnd)
        assert found.event is not None
        assert found.event.name == "stick"
        assert found.states["u"].contains(0)
        assert checked > 30


def test_flight_is_the_closed_form() -> None:
    """z = 0 and b = -1/2, y = 1/100, v = 0: y(t) = 1/100 - t^2/4 - t^3/6 vanishes in the bracket."""
    start: dict[str, fmpq | str] = {"p": fmpq(1, 2), "b": fmpq(-1, 2), "y": fmpq(1, 100), "v": fmpq(0), "z": fmpq(0)}
    scene = Scene("test", ("compliant_contact", "lift_off"), fmpq(1, 1000), fmpq(1, 5), {}, start)
    event = integrated_run(scene).events[0]
    assert event.name == "touch-down"
    height = [fmpq(1, 100) - t**2 / 4 - t**3 / 6 for t in (event.lower, event.upper)]
    assert height[0] > 0 > height[1]


@pytest.mark.parametrize("name", ["oscillator", "rod", "extended"])
def test_other_scenes_against_floats(name: str) -> None:
    """Mechanisms with sines and cosines, stick and slip in both directions: the events of a float run."""
    scene = load_scene(name, epsilon="1e-3")
    run, simulated = integrated_run(scene), float_run(scene)
    assert run.verdict.outcome is Outcome.PROVED
    assert agreement(simulated, run) is True
    certain = [event for event in run.events if event.name != IMPACT]
    for ours, seen in zip(certain, simulated.events, strict=True):
        assert abs(approximate(ours.lower - seen.lower)) < 1e-7


@pytest.mark.slow
def test_an_impact_of_a_mechanism_is_a_statement() -> None:
    """The rod, and the oscillator on a moving surface: λ_N grows for as long as the contact slips, which ends in a time
    that is stated; the stick comes in that time."""
    rod = integrated_run(load_scene("rod"))
    assert names(rod)[:2] == [IMPACT, "stick"]
    assert "for as long as the contact slips, which ends within" in rod.verdict.statement
    assert "λ_N" not in rod.verdict.detail
    still = load_scene("oscillator", epsilon="1e-4", until="2/10")
    moving = replace(
        still,
        effects=(*still.effects, "tangential_motion", "stick"),
        parameters={**still.parameters, "belt_velocity": fmpq(-1)},
    )
    run = integrated_run(moving)
    assert names(run)[:4] == ["lift-off", "touch-down", IMPACT, "stick"]
    assert run.verdict.outcome is Outcome.PROVED
    stated = re.search(r"from t = (\S+) after the start on .* which ends within (\S+?) ε", run.verdict.statement)
    assert stated is not None
    since, within = (fmpq(*map(int, Decimal(text).as_integer_ratio())) for text in stated.groups())
    stick = run.events[3]
    assert since < stick.lower
    assert stick.upper < since + within * moving.epsilon


@pytest.mark.slow
def test_without_an_end_of_slip_growth_is_limited() -> None:
    """The oscillator without a moving surface: p turns positive, so λ_N is said to grow by a factor only."""
    run = integrated_run(replace(load_scene("oscillator", epsilon="1e-4", until="2/10"), stop_at_force=None))
    assert names(run) == ["lift-off", "touch-down", IMPACT, "lift-off"]
    multiple = re.search(r"until it is (\d+) times as large", run.verdict.detail)
    assert multiple is not None
    assert f"(λ_N grows {multiple[1]}-fold, or slip or stick ends)" in run.verdict.statement
    assert "for as long" not in run.verdict.detail


def test_touch_down_of_a_contact_that_did_not_slip() -> None:
    """From stick into flight with a = 0: u stays exactly 0, so at the touch-down friction holds the contact, as
    k^+ < 0 < k^-. It was undecided: u had the rounding errors of the flight."""
    scene = load_scene("fig-varsim2", chi=0, nu="1/4", u=1, epsilon="1/100")
    run = integrated_run(scene, bits=(192,))
    assert run.verdict.outcome is Outcome.PROVED
    assert names(run) == ["stick", "lift-off", "touch-down"]
    assert agreement(float_run(scene), run) is True
    with working_bits(128):
        phase = CertifiedPhase(scene.system("flight"))
        start = {name: arb(1) / 3 for name in phase.names} | {"u": arb(0)}
        found = phase.run({**start, "Y": arb(2)}, arb(1), {}, lambda *_: False)
        assert isinstance(found, PhaseEnd)
        assert found.states["u"].is_zero()
        assert not found.states["b"].is_exact()


@pytest.mark.parametrize("u", ["1/1000", "-1/1000"])
def test_touch_down_with_slip(u: str) -> None:
    """A flight with u other than 0 ends in slip in that direction, not in stick."""
    start: dict[str, fmpq | str] = {"p": fmpq(1, 2), "b": fmpq(-1), "y": fmpq(1, 10**5), "v": fmpq(0), "z": fmpq(0)}
    effects = load_scene("fig-varsim2").effects
    settings = load_scene("fig-varsim2").parameters
    scene = Scene("test", effects, fmpq(1, 1000), fmpq(1, 50), settings, {**start, "u": scene_number(u, "u")})
    run = integrated_run(scene, bits=(192,))
    assert names(run)[:2] == ["touch-down", "stick"]
    assert run.events[0].upper < run.events[1].lower


def test_on_a_canard_nothing_is_decided() -> None:
    """Exactly on the trivial solution the set of states outgrows it, and the run says so: no event, no impact."""
    run = integrated_run(load_scene("fig-varsim1", nu=1), bits=(128,))
    assert run.fate == OPEN
    assert run.verdict.outcome is Outcome.UNDECIDED
    assert "canard" in run.verdict.detail
    assert run.events == ()


@pytest.mark.parametrize("exponent", [30, 60])
@pytest.mark.parametrize("side", [1, -1])
def test_beside_a_canard(exponent: int, side: int) -> None:
    """10^-30 and 10^-60 off it, on either side: the side that the sign of K gives."""
    scene = load_scene("fig-varsim1", nu=1 + side * fmpq(1, 10**exponent), epsilon="1e-3")
    run = integrated_run(scene)
    assert run.verdict.outcome is Outcome.PROVED
    assert names(run)[0] == ("lift-off" if side == 1 else IMPACT)
    start = scene.initial()
    rule = side_rule(compliant_model("3/2", "1e-3"), compliant_state(*(start[name] for name in "pbyvz")))
    assert sign_of(rule.side) == -side


def test_simultaneous_stick_and_lift_off() -> None:
    """The slip velocity at the start such that u and lambda vanish at one time, to 15 digits, then to all digits that a
    run has: decided with more bits, and not decided with few."""
    scene = load_scene("fig-varsim2", chi=1)
    lift = integrated_run(scene, bits=(192,))
    assert names(lift) == ["lift-off"]
    with working_bits(192):
        phase = CertifiedPhase(scene.system("slip"))
        start = {name: arb(value) for name, value in scene.scaled_initial().items()} | {CLOCK: arb(0)}
        found = phase.run(start, arb(1000), {}, lambda *_: False)
        assert isinstance(found, PhaseEnd)
        left = found.states["u"]  # u acts on nothing else, so u_0 - left is the start at which both vanish
        together = fmpq(70) - fmpq(*approximate(left).as_integer_ratio())
        mantissa, exponent = (arb(70) - left).mid().man_exp()
    for offset, expected in ((fmpq(1, 1000), ["lift-off"]), (fmpq(-1, 1000), ["stick", "lift-off"])):
        assert names(integrated_run(scene.with_settings(u=together + offset))) == expected
    exactly = fmpq(int(mantissa)) * fmpq(2) ** int(exponent)
    run = integrated_run(scene.with_settings(u=exactly), bits=(128,))
    assert run.fate == OPEN
    assert "simultaneous lift-off and stick" in run.verdict.detail or "simultaneous stick and lift-off" in (
        run.verdict.detail
    )


def test_a_contact_that_never_closes() -> None:
    """Starting above the surface with v > 0 and alpha_2 > 0: no event in the whole time, which is certain."""
    start: dict[str, fmpq | str] = {"p": fmpq(1, 2), "b": fmpq(1, 2), "y": fmpq(1, 100), "v": fmpq(1), "z": fmpq(0)}
    scene = Scene("test", ("compliant_contact", "lift_off"), fmpq(1, 1000), fmpq(5), {"alpha_2": fmpq(1)}, start)
    run = integrated_run(scene)
    assert run.verdict.outcome is Outcome.PROVED
    assert run.events == ()
    assert run.fate == "no event"


def test_a_grazing_lift_off_is_undecided() -> None:
    """Contact whose force touches 0: found by bisection over the start, where few bits cannot tell."""
    effects = ("compliant_contact", "lift_off")
    base: dict[str, fmpq | str] = {"p": fmpq(1, 2), "b": fmpq(-1), "y": fmpq(-1, 10**6), "z": fmpq(-1, 2 * 10**6)}

    def first(speed: fmpq, bits: int) -> SceneRun:
        scene = Scene("test", effects, fmpq(1, 1000), fmpq(1, 50), {}, {**base, "v": speed})
        return integrated_run(scene, bits=(bits,))

    low, high = fmpq(0), fmpq(1, 50)
    assert names(first(low, 128)) == []
    assert names(first(high, 128))[0] == "lift-off"
    for _ in range(200):
        middle = (low + high) / 2
        run = first(middle, 96)
        if run.fate == OPEN and not run.events:
            break
        low, high = (low, middle) if run.events else (middle, high)
    else:
        pytest.fail("no grazing start was found")
    assert "grazing" in run.verdict.detail
    assert high - low < fmpq(1, 10**8)


@pytest.mark.parametrize(("nu", "event"), [("2", "lift-off"), pytest.param("1/2", IMPACT, marks=pytest.mark.slow)])
def test_epsilon_1e_10_near_the_g_spot(nu: str, event: str) -> None:
    """p = 1e-6 at ε = 1e-10, a factor 2 from the canard: the sides of larger ε (K is out of reach), and floats."""
    scene = load_scene("fig-varsim1", epsilon="1e-10", p="1e-6", nu=nu, until="3e-6")
    run = integrated_run(scene)
    assert run.verdict.outcome is Outcome.PROVED
    assert names(run)[0] == event
    seen = [each for each in float_run(scene).events if each.name == "lift-off"]
    assert len(seen) == (event == "lift-off")
    if seen:
        assert abs(seen[0].lower - run.events[0].lower) < fmpq(1, 10**10)


def test_a_force_of_1e30_in_an_impact() -> None:
    """The integrator follows an impact without collision to λ_N > 10^30, in narrow balls, and the growth from there on
    is for ever."""
    scene = load_scene("fig-varsim1")
    with working_bits(192):
        phase = CertifiedPhase(scene.system("slip"))
        names_of = dict.fromkeys(phase.names, arb(0))
        start = {**names_of, "b": arb(-0.1), "Y": arb(-6), "V": arb(-4), "Z": arb(-2), CLOCK: arb(700)}
        found = phase.run(start, arb(1000), {}, lambda _, at: bool(at["Z"] - at["Y"] > 1e30))
        assert isinstance(found, PhaseEnd)
        assert found.event is None
        force = found.states["Z"] - found.states["Y"]
        assert force > 1e30
        assert force.rad() < force * arb("1e-12")
        growth = InvariantRegion(phase.system).growth(found.states)
    assert growth is not None
    assert growth.until is None
    assert growth.rate > 0.1


def test_long_steps_of_a_mechanism_do_not_widen_the_set() -> None:
    """The oscillator at ε = 1e-6 on its slow manifold: enclosures of J on long pieces let errors grow by 2^30 in a step
    that shorter pieces hold; found by the growth itself."""
    scene = load_scene("oscillator", epsilon="1e-6")
    with working_bits(192):
        phase = CertifiedPhase(scene.system("slip"))
        near = {"phi": "0.0914", "phi_dot": "-0.9072", "Y": "-2.18456", "V": "0", "Z": "-1.09228"}
        run = NormRun(phase.field, [arb(near[name]).mid() for name in phase.names], arb(10**5))
        order, bits = run._curve.order, run._curve.fraction_bits(run.set.middle)
        settled = slow_curve(phase.field, run.set.middle, 1000.0, order, bits)
        assert settled is not None
        middle = run._curve.exact([p(arb(0)) for p in settled.solution])
        run.set = StateSet(middle, run.set.basis, tuple(arb((1, -140)) for _ in middle))
        curve = slow_curve(phase.field, middle, 6496.0, order, bits)
        assert curve is not None
        step = run._along(curve, 6496.0)
        assert step is not None
        assert all(radius < arb(2) ** -112 for radius in step.tube)


def test_only_a_named_reason_leaves_the_impact_out(monkeypatch: pytest.MonkeyPatch) -> None:
    """Equations of another form have no impact by these theorems; any other error is one, and was swallowed."""
    scene, place = (
        load_scene("fig-varsim1", epsilon="1/10", until="1/2"),
        "gspot_verified.scenes.certified.certified_integration",
    )

    def fails(error: ValueError) -> SceneRun:
        def region(_: object) -> InvariantRegion:
            raise error

        monkeypatch.setattr(f"{place}.InvariantRegion", region)
        return integrated_run(scene, bits=(96,))

    assert fails(NotOfThisForm("another contact")).verdict.outcome is Outcome.PROVED
    with pytest.raises(ValueError, match="a defect"):
        fails(ValueError("a defect"))


def test_what_is_refused() -> None:
    scene = load_scene("fig-varsim2")
    with pytest.raises(SceneError, match="differs in: stick, tangential_motion, two_way_coupling"):
        certified_run(scene, route=EXACT)
    with pytest.raises(SceneError, match="k_1 = k_2 = damping = 1"):
        certified_run(load_scene("fig-varsim1", k_1=2), route=EXACT)
    with pytest.raises(SceneError, match="not a mechanism"):
        certified_run(load_scene("oscillator"), route=EXACT)
    with pytest.raises(SceneError, match="route"):
        certified_run(scene, route="other")
    with pytest.raises(SceneError, match="digits"):
        integrated_run(scene, digits=0)


def test_other_stiffness_is_integrated() -> None:
    scene = load_scene("fig-varsim1", k_1=2, k_2="1/2")
    run, simulated = certified_run(scene), float_run(scene)
    assert run.verdict.outcome is Outcome.PROVED
    assert agreement(simulated, run) is True
    assert abs(approximate(run.events[0].lower - simulated.events[0].lower)) < 1e-8


def test_a_budget_says_so() -> None:
    """A phase whose field blows up before the end of the time."""
    with working_bits(96):
        phase = CertifiedPhase(load_scene("fig-varsim2").system("slip"))
        names_of = dict.fromkeys(phase.names, arb(0))
        found = phase.run({**names_of, "Y": arb(0), "Z": arb(1), "b": arb("1e200")}, arb(10), {}, lambda *_: False)
        assert isinstance(found, Open)


@pytest.mark.parametrize("until", ["1264/1000", "1260/1000"])
def test_nothing_after_the_end_of_the_time_is_listed(until: str) -> None:
    """With few bits the touch-down has a bracket, so the last phase is followed a little too long: an impact at the end
    of it was listed up to 6e-8 after the end."""
    scene = load_scene("fig-varsim1", epsilon="1e-2", until=until)
    run = integrated_run(scene, digits=1, bits=(96,))
    assert run.verdict.outcome is Outcome.PROVED
    assert names(run)[:2] == ["lift-off", "touch-down"]
    assert all(event.upper <= scene.until for event in run.events)


@pytest.mark.parametrize(
    ("first", "second", "expected"),
    [
        ("60", "40", ["lift-off", "touch-down"]),
        ("[60 +/- 0.5]", "39", ["lift-off", "touch-down"]),
        ("[60 +/- 0.5]", "[40 +/- 0.1]", None),
        ("[60 +/- 0.5]", "40.501", ["lift-off"]),
    ],
)
def test_an_event_around_the_end_of_the_time(
    monkeypatch: pytest.MonkeyPatch, first: str, second: str, expected: list[str] | None
) -> None:
    """T = 100 is the end: an event is listed where it is certainly before it, left out where it certainly is not."""
    durations = {"slip": first, "flight": second}
    shown = less(0, 1)
    assert shown is not None

    def ends(phase: CertifiedPhase, start: dict[str, arb], *_: object) -> PhaseEnd:
        system, name = phase.system, phase.system.phase
        if name == "slip" and start[CLOCK] != 0:
            return PhaseEnd(None, arb(0), {}, shown)
        return PhaseEnd(system.events[0], arb(durations[name]), {**start, "Y": arb(0), "Z": arb(0)}, shown)

    monkeypatch.setattr(CertifiedPhase, "run", ends)
    run = integrated_run(load_scene("fig-varsim1", epsilon="1/100", until=1), bits=(128,))
    assert names(run) == (expected or ["lift-off"])
    assert (run.fate == OPEN) is (expected is None)
    assert expected is not None or "whether touch-down comes before the end of the time" in run.verdict.detail


@pytest.mark.parametrize("place", ["-1/256", "-1/300"])
def test_a_start_at_the_surface_is_one_whether_or_not_binary_digits_hold_it(place: str) -> None:
    """y = z at the start, exactly: the balls of -1/300 cannot show it."""
    scene = load_scene("fig-varsim1", epsilon="1/10", until="1/10", y=place, z=place, v=0, b=-2, nu=None)
    found = integrated_run(scene)
    assert found.verdict.outcome is Outcome.PROVED
    assert found.events == ()
