"""Which phase follows which: certain signs only, at their borders; what is at zero where a phase begins.

Page: proofs/validated_step.md, Theorems V5 and V6; proofs/left_out_effects.md.
"""

from __future__ import annotations

from dataclasses import replace

import pytest
from flint import arb, fmpq

from gspot_verified.scenes.certified.certified_phase import CLOCK, Open
from gspot_verified.scenes.certified.certified_phases import CertifiedPhases, Following, Next
from gspot_verified.scenes.effects.catalogue import EFFECTS
from gspot_verified.scenes.effects.stick import SLIPS
from gspot_verified.scenes.equations.scaled_system import PhaseEvent
from gspot_verified.scenes.equations.terms import FLIGHT, REVERSE, SLIP, STICK
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.scene import Scene

EFFECTS_USED = ("compliant_contact", "lift_off", "tangential_motion", "stick", "belt")
START = {"p": fmpq(1, 2), "b": fmpq(-1), "u": fmpq(2), "y": fmpq(-1, 100), "v": fmpq(0), "z": fmpq(0)}
PULL, BELT = fmpq(1, 4), fmpq(1, 2)
BELT_IS_LEAST, BELT_IS_GREATEST = arb((3, -2), (1, -2)), arb((1, -2), (1, -2))


def scene(a: fmpq = PULL, effects: tuple[str, ...] = EFFECTS_USED, **start: fmpq) -> Scene:
    parameters = {"a": a, "k_plus": fmpq(-1), "k_minus": fmpq(2), "p_minus": fmpq(1), "belt_velocity": BELT}
    known = {
        name: value
        for name, value in parameters.items()
        if ("tangential_motion" in effects or name not in ("a", "k_plus"))
        and ("stick" in effects or name not in ("k_minus", "p_minus"))
        and ("belt" in effects or name != "belt_velocity")
    }
    given = {name: value for name, value in {**START, **start}.items() if name != "u" or "tangential_motion" in effects}
    return Scene("phases", effects, fmpq(1, 8), fmpq(1), known, given)


def states(force: arb | int = 1, u: arb | fmpq = BELT) -> dict[str, arb]:
    """k_2 = 1: the force is Z - Y."""
    balls = {"b": arb(-1), "Y": -arb(force), "V": arb(0), "Z": arb(0), "u": arb(u)}
    return {**balls, CLOCK: arb(3)}


def event(phases: CertifiedPhases, phase: str, name: str) -> PhaseEvent:
    (found,) = (each for each in phases[phase].system.events if each.name == name)
    return found


def test_lift_off_leads_into_flight() -> None:
    phases = CertifiedPhases(scene())
    for phase in (SLIP, STICK, REVERSE):
        found = phases.after(phase, event(phases, phase, "lift-off"), states())
        assert found == Following("lift-off", Next(FLIGHT, {"touch-down": None}))


@pytest.mark.parametrize(
    ("u", "expected"),
    [
        (BELT + fmpq(1, 10**9), Next(SLIP, {"lift-off": None})),
        (BELT - fmpq(1, 10**9), Next(REVERSE, {"lift-off": None})),
        # No force yet, so nothing holds the contact against a > 0: it rests, and slips forwards.
        (BELT, Next(SLIP, {"lift-off": None, "slip stops": None})),
    ],
)
def test_touch_down_by_the_sign_of_the_slip_velocity(u: fmpq, expected: Next) -> None:
    phases = CertifiedPhases(scene())
    found = phases.after(FLIGHT, event(phases, FLIGHT, "touch-down"), states(0, u))
    assert found == Following("touch-down", expected)


@pytest.mark.parametrize("u", [BELT_IS_LEAST, BELT_IS_GREATEST, arb(0.5, 0.25), arb("nan")])
def test_a_slip_velocity_that_may_be_zero_leaves_touch_down_open(u: arb) -> None:
    phases = CertifiedPhases(scene())
    found = phases.after(FLIGHT, event(phases, FLIGHT, "touch-down"), states(0, u))
    assert isinstance(found.phase, Open)
    assert found.phase.reason == "the direction of slip at touch-down is not certain"
    assert found.phase.time == 3


def test_touch_down_where_nothing_sticks_is_slip() -> None:
    phases = CertifiedPhases(scene(effects=EFFECTS_USED[:3]))
    found = phases.after(FLIGHT, event(phases, FLIGHT, "touch-down"), states(0, fmpq(-7)))
    assert found.phase == Next(SLIP, {"lift-off": None})
    made, stick = scene(effects=EFFECTS_USED[:3]), [EFFECTS["stick"]]
    watched = CertifiedPhases(made, stick, stick)
    assert [each.name for each in watched[SLIP].system.events] == ["lift-off", "slip stops"]
    assert watched.after(FLIGHT, event(watched, FLIGHT, "touch-down"), states(0, fmpq(1))).phase == found.phase


@pytest.mark.parametrize(
    ("force", "name", "expected"),
    [
        (arb(fmpq(1, 4) + fmpq(1, 10**9)), "stick", Next(STICK, {})),
        (arb(fmpq(1, 4) - fmpq(1, 10**9)), "slip forwards", Next(SLIP, {"slip stops": None})),
    ],
)
def test_where_slip_stops_friction_holds_or_does_not(force: arb, name: str, expected: Next) -> None:
    """lambda^+ >= 0: -k^+ lambda_N - a = lambda_N - 1/4. Where it sticks the slip velocity is that of the belt."""
    phases = CertifiedPhases(scene())
    for phase in (SLIP, REVERSE):
        now = states(force, arb(0.5, 0.25))
        assert phases.after(phase, event(phases, phase, "slip stops"), now) == Following(name, expected)
        assert (now["u"] == BELT) is (expected.phase == STICK)


@pytest.mark.parametrize("force", [arb(0.25), arb(0.25, 0.01), arb((1, -1), (1, -2)), arb("nan")])
def test_friction_at_its_bound_is_open(force: arb) -> None:
    phases = CertifiedPhases(scene())
    found = phases.after(SLIP, event(phases, SLIP, "slip stops"), states(force))
    assert isinstance(found.phase, Open)
    assert found.phase.reason == "whether friction holds the contact is not certain"


@pytest.mark.parametrize(("theta", "expected"), [(1, SLIP), (-1, REVERSE)])
def test_one_bound_that_is_passed_is_enough_for_slip(theta: int, expected: str) -> None:
    """A turning rod whose end rests, at touch-down: no friction yet, and m l θ'^2 sin θ pulls it to one side."""
    phases = CertifiedPhases(load_scene("rod"))
    now = {name: arb(0) for name in (*phases[STICK].names, CLOCK)} | {"theta": arb(theta), "theta_dot": arb(3)}
    guards = {name: phases._value(STICK, event(phases, STICK, name).function, now) for name in SLIPS.values()}
    assert [name for name, guard in guards.items() if guard < 0] == [SLIPS[expected]]
    assert [name for name, guard in guards.items() if guard > 0] == [SLIPS[{SLIP: REVERSE, REVERSE: SLIP}[expected]]]
    assert phases._resting(now, touching=False) == Next(expected, {"slip stops": None})


def test_slip_backwards_where_the_other_bound_is_passed() -> None:
    """a = -1: lambda^- >= 0 asks for 2 lambda_N >= 1, and the contact slips backwards below that."""
    phases = CertifiedPhases(scene(a=fmpq(-1)))
    found = phases.after(SLIP, event(phases, SLIP, "slip stops"), states(arb(0.25)))
    assert found == Following("slip backwards", Next(REVERSE, {"slip stops": None}))


def test_stick_follows_for_certain_without_acceleration() -> None:
    """a = 0: both parts of the force are positive while lambda_N is."""
    phases = CertifiedPhases(scene(a=fmpq(0)))
    now = states(1, arb(0.5, 0.25))
    assert phases.after(SLIP, event(phases, SLIP, "stick"), now) == Following("stick", Next(STICK, {}))
    assert now["u"] == BELT


def test_slip_that_leaves_stick_begins_without_velocity_and_acceleration() -> None:
    phases = CertifiedPhases(scene())
    found = phases.after(STICK, event(phases, STICK, "slip forwards"), states())
    assert found == Following("slip forwards", Next(SLIP, {"slip stops": 2}))


@pytest.mark.parametrize(
    ("start", "expected"),
    [
        ({}, Next(SLIP, {})),
        ({"u": fmpq(0)}, Next(REVERSE, {})),
        ({"u": BELT}, Next(STICK, {})),
        ({"u": BELT, "y": fmpq(-1, 10**6)}, Next(SLIP, {"slip stops": None})),
        ({"y": fmpq(0)}, Next(SLIP, {"lift-off": None})),
        ({"y": fmpq(0), "v": fmpq(1)}, Next(FLIGHT, {"touch-down": None})),
        ({"y": fmpq(1)}, Next(FLIGHT, {})),
    ],
)
def test_the_first_phase(start: dict[str, fmpq], expected: Next) -> None:
    made = scene(**start)
    exact = made.scaled_initial()
    balls = {name: arb(exact[name]) for name in exact} | {CLOCK: arb(0)}
    assert CertifiedPhases(made).first(balls) == expected


def test_conditions_are_followed_and_those_that_are_watched_end_a_phase() -> None:
    """Without lift-off: its condition, lambda_N > 0, has the force as its function; without being watched no event."""
    made = scene(effects=("compliant_contact", "tangential_motion", "stick", "belt"))
    left_out = [EFFECTS["lift_off"]]
    followed, watched = CertifiedPhases(made, left_out), CertifiedPhases(made, left_out, left_out)
    names = [each.name for each in followed[SLIP].system.events]
    assert names == ["slip stops"]
    assert [each.name for each in watched[SLIP].system.events] == [*names, "lift-off"]
    for phases in (followed, watched):
        ((condition, value),) = phases.conditions(SLIP, states(arb(0.25)))
        assert (condition.name, condition.left_out) == ("lift-off", "lift_off")
        assert value == fmpq(1, 4)
    assert CertifiedPhases(made).conditions(SLIP, states()) == []


def test_a_function_may_depend_on_the_clock() -> None:
    """p = p_0 + alpha_1 epsilon T with alpha_1 = -1."""
    phases = CertifiedPhases(scene())
    assert phases._value(SLIP, phases[SLIP].system.shown("p"), states()) == fmpq(1, 2) - fmpq(3, 8)


def test_an_event_without_a_phase_of_its_own_begins_with_that_phase_alone() -> None:
    """What is at zero: lift-off where y = z; the end of slip in slip alone, never an end of stick."""
    phases = CertifiedPhases(scene())
    assert phases._begins(STICK, touching=True, at_rest=True) == Next(STICK, {"lift-off": None})
    assert phases._begins(SLIP, touching=False, at_rest=False) == Next(SLIP, {})
    assert phases._begins(REVERSE, touching=True, at_rest=True, order=2).at_zero == {"lift-off": None, "slip stops": 2}
    odd = replace(event(phases, STICK, "slip forwards"), next_phase="contact")
    system = replace(phases[STICK].system, events=(odd,))
    phases._compiled[STICK] = type(phases[STICK])(system)
    assert phases._begins(STICK, touching=False, at_rest=True) == Next(STICK, {})


def test_touch_down_ends_a_flight_only() -> None:
    with pytest.raises(ValueError, match="touch-down ends a flight, not the phase slip"):
        CertifiedPhases(load_scene("rod"))._touching(SLIP, {})
