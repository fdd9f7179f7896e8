"""Theorem R of proofs/papers_rule.md: the sides of shipped mechanisms, and each hypothesis that must be refused."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np
import pytest
from flint import arb, fmpq
from scipy.integrate import solve_ivp
from witnesses.theorem_q import side_by_enclosures

from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.mechanisms.approach import mechanism_side as module
from gspot_verified.mechanisms.approach.approach import approach
from gspot_verified.mechanisms.approach.approach_result import Approach
from gspot_verified.mechanisms.approach.mechanism_side import (
    MechanismSide,
    active_components,
    independent,
    mechanism_side,
)
from gspot_verified.mechanisms.approach.slip_flow import SlipFlow, SlipNumbers
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.input.file import parse_mechanism
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome, Reason

MODEL = shipped_mechanism("model system")
FIVE = """
format = 1
name = "five active components"
[parameters]
alpha_3 = "-8/5"
[fields]
state = ["x", "u", "y", "v", "p", "b", "w"]
F = ["u", 0, "v", "b", "-1 + w/4", "-1 + w", "p - w/2"]
G_T = [0, "3/(2*(1 - p))", 0, "1/2", 0, "alpha_3/(2*(1 - p))", 0]
G_N = [0, "1/2", 0, "(1 + p)/2", 0, "-alpha_3/2", "1/3"]
[contact]
x = "x"
y = "y"
mu = "1 - p"
[g_spot]
fixed = ["x", "u", "w"]
[g_spot.point]
x = 0
u = 1
y = 0
v = 0
p = 0
b = 0
w = "1/10"
"""
START = {"x": 0, "u": 3, "p": "1/2", "b": "-2"}


@cache
def of_model() -> Approach:
    return approach(MODEL, START)


def with_approach(monkeypatch: pytest.MonkeyPatch, **changes: Any) -> MechanismSide:
    """The side where rigid slip was found to go another way."""
    found = replace(of_model(), **changes)
    monkeypatch.setattr(module, "followed", lambda *_, **__: found)
    return mechanism_side(MODEL, START)


def undecided(found: MechanismSide, reason: Reason, why: str) -> None:
    assert found.side is None
    text, rigid = str(found), found.approach
    assert "rests on" not in text
    assert ("the G-spot: " in text) is (rigid.end == "G-spot")
    assert ("  Case " in text) is (rigid.case in ("I", "II", "III") and rigid.beta is not None)
    assert ("  C_1 = " in text) is (rigid.coefficient is not None)
    assert found.verdict.outcome is Outcome.UNDECIDED
    assert found.verdict.reason is reason
    assert why in found.verdict.detail


def test_the_model_system_takes_the_side_of_its_own_theorem() -> None:
    """Lift-off, as in tests/expansion/from_state/test_model_side.py with an explicit epsilon_0."""
    found = mechanism_side(MODEL, START)
    assert found.verdict.outcome is Outcome.PROVED
    assert found.side == "lift-off"
    assert found.verdict.statement.endswith("contact is lost")
    assert found.active == ("y", "v", "p", "b")
    shown = str(found).splitlines()
    assert shown[0] == str(found.verdict)
    assert [line.split("=")[0] for line in shown[1:4]] == ["  the G-spot: x ", "  Case III, beta ", "  C_1 "]
    assert shown[4] == "  rests on proofs/papers_rule.md, Theorem R; epsilon_0 is not computed"
    data = found.to_json()
    assert (data["side"], data["end"]) == ("lift-off", "G-spot")


@pytest.mark.parametrize(
    ("beta", "coefficient"),
    [("3/2", 1), *(pytest.param(b, c, marks=pytest.mark.slow) for b in ("5/2", "7/2") for c in (1, -1))],
)
def test_it_is_the_side_that_theorem_q_proves_another_way(
    monkeypatch: pytest.MonkeyPatch, beta: str, coefficient: int
) -> None:
    """Theorem Q shows the side of C_1 > 0 by enclosures for a rational beta, Theorem R by the asymptotics of Theta."""
    ball = arb(fmpq(*map(int, beta.split("/")))) + arb(0, "1e-20")
    found = with_approach(monkeypatch, beta=ball, coefficient=arb(coefficient, "0.1"))
    positive = side_by_enclosures(beta)
    assert found.side == (positive if coefficient > 0 else {"impact": "lift-off", "lift-off": "impact"}[positive])


def test_beta_may_be_any_number_of_a_ball(monkeypatch: pytest.MonkeyPatch) -> None:
    for beta, side in (("1.5", "impact"), ("2.5", "lift-off"), ("3.5", "impact"), ("4.5", "lift-off")):
        assert with_approach(monkeypatch, beta=arb(beta, "0.4"), coefficient=arb(1, "0.9")).side == side
    undecided(with_approach(monkeypatch, beta=arb("4.5", "0.6")), Reason.WIDE_INPUT, "")


@pytest.mark.parametrize(
    ("changes", "reason", "why"),
    [
        ({"case": "I"}, Reason.BEYOND, "Theorem R is about Case III: Case I"),
        ({"case": None, "side_reason": "alpha_2 is open"}, Reason.BEYOND, "alpha_2 is open"),
        ({"case": "none", "side_reason": "alpha_2 = 0"}, Reason.BEYOND, "Theorem R is about Case III: alpha_2 = 0"),
        ({"coefficient": None, "side_reason": "not enclosed"}, Reason.HYPOTHESIS, "not enclosed"),
        ({"coefficient": arb(0, 1), "side_reason": "sign open"}, Reason.WIDE_INPUT, "sign open"),
        ({"coefficient": arb(0)}, Reason.WIDE_INPUT, ""),
        ({"beta": arb(2)}, Reason.WIDE_INPUT, ""),
        ({"beta": arb(2, "1e-9"), "side_reason": "an integer"}, Reason.WIDE_INPUT, "an integer"),
        ({"beta": arb("0.9", "0.05")}, Reason.WIDE_INPUT, ""),
        ({"beta": arb("nan")}, Reason.WIDE_INPUT, ""),
        ({"alphas": (arb(-1), arb(0, 1), arb(-2))}, Reason.HYPOTHESIS, "sign of an alpha"),
        ({"alphas": (arb(-1), arb(-1), arb(0))}, Reason.HYPOTHESIS, "sign of an alpha"),
        ({"alphas": None}, Reason.BEYOND, "before any G-spot"),
        ({"beta": None}, Reason.BEYOND, "before any G-spot"),
        ({"end": "slip stops", "alphas": None, "beta": None}, Reason.BEYOND, ": slip stops before any G-spot"),
    ],
)
def test_a_hypothesis_that_is_not_certain_leaves_it_undecided(
    monkeypatch: pytest.MonkeyPatch, changes: dict[str, Any], reason: Reason, why: str
) -> None:
    undecided(with_approach(monkeypatch, **changes), reason, why)


def test_slip_whose_end_is_open_leaves_it_undecided() -> None:
    """One validated step is too few."""
    found = mechanism_side(MODEL, START, max_steps=1)
    undecided(found, Reason.BUDGET, found.approach.verdict.detail)


def test_a_contact_without_damper_is_beyond_the_theorem(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "followed", lambda *_, **__: of_model())
    undamped = replace(MODEL, regularisation=Regularisation.of(1, 1, 0))
    undecided(mechanism_side(undamped, START), Reason.BEYOND, "no damper")


def test_p_b_y_v_must_be_independent(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of x, u, y, v no four have a minor that is not 0; and of three components there is none."""
    for components in ((0, 1, 2, 3), (2, 3, 4)):
        monkeypatch.setattr(module, "active_components", lambda _, c=components: c)
        undecided(with_approach(monkeypatch), Reason.HYPOTHESIS, "may be dependent")


def test_the_statement_says_what_moves_and_which_starts_it_covers(monkeypatch: pytest.MonkeyPatch) -> None:
    below = "kappa p (v/epsilon)^2 + (b + p lambda_N)^2 + (g^2/l) p (lambda_N + kappa y/epsilon^2 + (l/g) v/epsilon)^2"
    at_rest = with_approach(monkeypatch).verdict.statement
    assert f"the limsup of ({below})/b^2 below 1, kappa = 1/2, g = 2, l = 1/2" in at_rest
    assert at_rest.index("every force Lambda,") < at_rest.index("there is an epsilon_0"), "one epsilon_0 for each force"
    assert "surface" not in at_rest
    assert (
        "on a surface with the velocity u = -1:" in with_approach(monkeypatch, surface_velocity="-1").verdict.statement
    )
    words = with_approach(monkeypatch, surface_velocity=None).verdict.statement
    assert "whose constant velocity is below u on the whole way, the G-spot included" in words


@pytest.mark.parametrize(
    ("name", "components"),
    [
        ("extended system", ("y", "v", "p", "b")),
        ("frictional impact oscillator", ("phi", "psi", "phi_dot", "psi_dot")),
        ("falling rod", ("Y", "theta", "Y_dot", "theta_dot")),
        ("rod on a shaken base", ("Y", "theta", "Y_dot", "theta_dot", "t")),
    ],
)
def test_the_components_on_which_the_contact_depends(name: str, components: tuple[str, ...]) -> None:
    mechanism = shipped_mechanism(name)
    with working_bits(64):
        active = active_components(SlipFlow.of(shift(mechanism)))
    assert tuple(mechanism.state[i] for i in active) == components


def test_independence_is_a_minor_that_is_certainly_not_0() -> None:
    """The model system's components y, v, p, b are the coordinates themselves, so that minor is 1."""
    with working_bits(64):
        numbers = SlipNumbers(SlipFlow.of(shift(MODEL)))
        box = [arb(0)] * 6
        assert str(independent(numbers, (2, 3, 4, 5), box)) == "0 != 1.00000"
        assert independent(numbers, range(6), box) is not None
        assert independent(numbers, (0, 1, 2, 3), box) is None
        assert independent(numbers, (2, 3, 4), box) is None
    with working_bits(64):  # p = b = 0 with d(p, b) = 0 somewhere in a wide box of the rod: not certain
        rod = SlipNumbers(SlipFlow.of(shift(shipped_mechanism("falling rod"))))
        assert independent(rod, range(6), [arb(0, 3)] * 6) is None


@pytest.mark.slow
@pytest.mark.parametrize(("rate", "side"), [("-9/10", "lift-off"), ("-1/2", "impact")])
def test_the_two_starts_of_section_6_of_the_paper(rate: str, side: str) -> None:
    found = mechanism_side(
        shipped_mechanism("frictional impact oscillator"),
        {"phi": "phi_ref + 1/10", "phi_dot": rate},
        surface_velocity=-1,
    )
    assert found.side == side
    assert found.verdict.outcome is Outcome.PROVED


def end_in_floats(beta: float, force: float, epsilon: float) -> str:
    """What a float run of the five components does from p = 3/10, w = 1/10 and this force, 5 % off at the start."""

    def field(_: float, state: np.ndarray) -> list[float]:
        p, b, y, v, z, w = state
        pressed = z - y
        rates = (-1 + w / 4, -1 + w + beta * pressed, p - w / 2 + pressed / 3)
        return [epsilon * rates[0], epsilon * rates[1], v, b + p * pressed, -z - pressed, epsilon * rates[2]]

    def lost(_: float, state: np.ndarray) -> float:
        return float(state[4] - state[2])

    def pressed_hard(_: float, state: np.ndarray) -> float:
        return float(state[4] - state[2] - 60 * force)

    lost.terminal = pressed_hard.terminal = True  # type: ignore[attr-defined]
    start = (0.3, -0.3 * force, -2.1 * force, 0.05, -1.05 * force, 0.1)
    events = (lost, pressed_hard)
    run = solve_ivp(field, (0, 1 / epsilon), start, method="DOP853", rtol=1e-10, atol=1e-13, events=events)
    return "lift-off" if run.t_events[0].size else "impact" if run.t_events[1].size else "neither"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("alpha_3", "force", "side"),
    [("-8/5", "1", "lift-off"), ("-8/5", "1/2", "impact"), ("-13/5", "1/2", "impact"), ("-13/5", "1/4", "lift-off")],
)
def test_five_components_on_both_sides_of_the_canard(alpha_3: str, force: str, side: str) -> None:
    """The alphas depend on a fifth component, which the force drives: beside the float runs."""
    state = {"x": 0, "u": 50, "y": 0, "v": 0, "p": "3/10", "b": str(Fraction(-3, 10) * Fraction(force)), "w": "1/10"}
    found = mechanism_side(parse_mechanism(FIVE).with_parameters(alpha_3=alpha_3), state)
    assert found.active == ("y", "v", "p", "b", "w")
    assert found.verdict.outcome is Outcome.PROVED
    assert found.side == side == end_in_floats(-float(Fraction(alpha_3)), float(Fraction(force)), 1e-4)


def test_five_components_are_seen() -> None:
    with working_bits(64):
        flow = SlipFlow.of(shift(parse_mechanism(FIVE)))
        active = active_components(flow)
        assert active == (2, 3, 4, 5, 6)
        assert independent(SlipNumbers(flow), active, [arb(0)] * 7) is not None


def test_what_a_component_needs_is_active_too() -> None:
    """The rate of w holds x, whose rate is u."""
    with working_bits(64):
        active = active_components(SlipFlow.of(shift(parse_mechanism(FIVE.replace("p - w/2", "p - w/2 + x/9")))))
    assert active == tuple(range(7))
