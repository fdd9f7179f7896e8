"""Scenes with friction that depends on the slip speed: each phase against closed forms (proofs/slip_speed.md)."""

from __future__ import annotations

from typing import Any

import mpmath
import pytest
from flint import arb, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Constant
from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.numbers.balls import approximate, working_bits
from gspot_verified.scenes.certified.certified_integration import integrated_run
from gspot_verified.scenes.equations.mechanism_terms import MechanismTerms
from gspot_verified.scenes.floats.fast_part import fast_part
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.floats.whole_states import whole_states
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.scene import Scene, SceneError

EFFECTS = ("compliant_contact", "lift_off", "tangential_motion", "stick")
EPSILON = fmpq(1, 10)
LAW = "mu_s/(1 + delta*slip_speed)"  # mu_s = delta = 1/2


def block(force: str = "0", mu: str = LAW, **contact: str) -> Mechanism:
    return lagrangian(
        "block", ["X", "H"], [[1, 0], [0, 1]], [force, -1], contact.pop("x", "X"), "H", mu,
        {"mu_s": "1/2", "delta": "1/2"}, **contact,
    )  # fmt: skip


def scene(
    mechanism: Mechanism, u: str = "1", until: str = "4", effects: tuple[str, ...] = EFFECTS, **more: str
) -> Scene:
    """From rest on the springs: lambda_N = 1 all along."""
    start: dict[str, Any] = {"X_dot": u, "y": -2 * EPSILON**2, "v": fmpq(0), "z": -(EPSILON**2)}
    parameters = {name: fmpq(value) for name, value in more.items()}
    return Scene("law", effects, EPSILON, fmpq(until), parameters, start, mechanism=mechanism)


def law(speed: Any) -> Any:
    return mpmath.mpf(1) / 2 / (1 + speed / 2)


def time_to_rest(force: Any, u: Any) -> Any:
    """Of u' = force - mu(u)."""
    return mpmath.quad(lambda w: 1 / (law(w) - force), [0, u])


@pytest.mark.parametrize(
    ("force", "event"), [("0", "stick"), ("-3/10", "stick"), ("-49/100", "stick"), ("-3/5", "slip backwards")]
)
def test_a_block_stops_when_the_law_says_and_is_held_by_mu_of_0(force: str, event: str) -> None:
    time = time_to_rest(approximate(arb(fmpq(force))), 1)
    made = scene(block(force))
    certified, floats = integrated_run(made), float_run(made)
    for run in (certified, floats):
        assert [found.name for found in run.events] == [event]
        assert approximate(arb(run.events[0].lower)) == pytest.approx(float(time), rel=1e-8)
    assert certified.verdict.outcome.value == "proved"


def test_slip_backwards_has_the_speed_not_the_velocity() -> None:
    """w = -u grows by w' = 3/5 - mu(w) from the time of rest on; with mu(u) for mu(|u|) it would have a pole."""
    run = float_run(scene(block("-3/5")))
    rest = time_to_rest(mpmath.mpf("-0.6"), 1)
    grown = mpmath.quad(lambda w: 1 / (mpmath.mpf("0.6") - law(w)), [0, -run.samples.columns["u"][-1]])
    assert float(grown) == pytest.approx(4 - float(rest), rel=1e-7)


def terms_of(made: Scene, phase: str) -> MechanismTerms:
    states = made.system(phase).states
    found = made.motion.terms(phase, states, made.values())
    assert isinstance(found, MechanismTerms)
    return found


def test_the_coefficient_of_each_phase() -> None:
    made = scene(block())
    assert made.system("slip").states == ("X_dot", "Y", "V", "Z")
    assert terms_of(made, "stick").functions.mu == Constant(fmpq(1, 2))
    assert terms_of(made, "flight").functions.mu == Constant(fmpq(1, 2))
    for phase, velocity in (("slip", 3), ("reverse slip", -3)):
        program = BoxProgram([terms_of(made, phase).functions.mu], 4)
        assert program.values([arb(velocity)] * 4)[0].overlaps(arb(1) / 5)


@pytest.mark.parametrize(
    ("u", "belt", "speed"),
    [("3", "0", 3), ("-3", "0", 3), ("0", "0", 0), ("1", "2", 1), ("-1", "-3", 2), ("2", "2", 0)],
)
def test_p_at_the_start_is_that_of_the_slip_there(u: str, belt: str, speed: int) -> None:
    """B = -4/15 and C = 16/15: p is C - mu B with mu of the speed beside the belt, whichever way it slips."""
    tilted = lagrangian("tilted", ["X", "H"], [[1, "1/4"], ["1/4", 1]], [0, -1], "X", "H", "1/(2 + slip_speed)")
    made = scene(tilted, u=u, effects=(*EFFECTS, "belt"), belt_velocity=belt)
    expected = fmpq(16, 15) + fmpq(4, 15) / (2 + speed)
    with working_bits(200):
        assert abs(made.motion.painleve_parameter(made.values()) - arb(expected)) < arb(10) ** -40


def test_the_velocity_of_a_belt_counts() -> None:
    """A block at rest on a belt that moves backwards slips as one with that velocity on a surface at rest does."""
    belted = scene(block(), u="-1", effects=(*EFFECTS, "belt"), belt_velocity="-2")
    moving = scene(block(x=None, slip_velocity="X_dot + 2"), u="-1")
    for run in (integrated_run(belted), integrated_run(moving)):
        assert [found.name for found in run.events] == ["stick"]
        assert run.events[0].lower <= fmpq(5, 2) <= run.events[0].upper  # (1 + 1/4)/(1/2)


def test_a_belt_without_a_velocity_is_refused() -> None:
    with pytest.raises(
        SceneError, match="the friction of block depends on the slip speed, and the velocity of the sur"
    ):
        scene(block(), effects=("compliant_contact", "lift_off", "belt"))


def test_a_law_without_a_value_at_rest_is_refused() -> None:
    with pytest.raises(SceneError, match="block: the friction coefficient has no value at slip speed 0"):
        scene(block(mu="1/2 + 1/(100*slip_speed)")).system("stick")


def test_a_law_that_is_negative_at_the_start_is_refused() -> None:
    with pytest.raises(MechanismError, match="the friction coefficient mu must not be negative at the start"):
        scene(block(mu="1/2 - slip_speed"))


def test_a_law_that_becomes_negative_leaves_a_certified_run_undecided() -> None:
    """Pushed on with 1 the block reaches the speed at which 1 - u/2 < 0."""
    run = integrated_run(scene(block("1", mu="1 - slip_speed/2"), until="20"))
    assert run.verdict.outcome.value == "undecided"
    assert "mu may be negative" in str(run.verdict)


def test_where_slip_is_not_seen_its_velocity_is_integrated_all_the_same() -> None:
    """p of a rod depends on it through mu."""
    states = load_scene("rod").with_effects(drop=["stick", "tangential_motion"]).system("slip").states
    assert states == ("theta", "theta_dot", "Y", "V", "Z")
    states = load_scene("stribeck").with_effects(drop=["stick", "tangential_motion"]).system("slip").states
    assert states == ("theta", "X_dot", "theta_dot", "Y", "V", "Z")


def test_the_run_of_the_rod_is_certified() -> None:
    run = integrated_run(load_scene("stribeck"))
    assert [found.name for found in run.events] == ["stick", "slip backwards", "lift-off"]
    assert run.verdict.outcome.value == "proved"


def test_no_fast_part_is_said_to_be_left_at_a_g_spot() -> None:
    """Slip of the rod reaches p = 0 elsewhere; with a law that does not vary it is said."""
    assert fast_part(load_scene("stribeck")) is None
    assert fast_part(load_scene("stribeck", delta=0, mu_s="73/36")) is not None


def test_the_place_along_the_surface_follows_in_pictures() -> None:
    """X is cyclic: its rate of change has the friction of the phase."""
    made = scene(block("-3/5"))
    run = float_run(made, points=401)
    states, columns = whole_states(made, run.samples), run.samples.columns
    travelled = 0.0
    for i in range(1, len(states)):
        travelled += (columns["u"][i] + columns["u"][i - 1]) / 2 * (columns["t"][i] - columns["t"][i - 1])
    assert states[-1][0] == pytest.approx(travelled, abs=1e-6)
    with working_bits(80):
        assert states[-1][2] == pytest.approx(columns["u"][-1])
