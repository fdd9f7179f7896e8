"""No conclusion about a mechanism is drawn where its masses or its friction have no sense: each refuses the same ones.

Page: proofs/mechanism_hypotheses.md.
"""

from __future__ import annotations

from collections.abc import Callable

import pytest
from flint import fmpq

from gspot_verified.mechanisms.approach.mechanism_side import mechanism_side
from gspot_verified.mechanisms.expand import expand
from gspot_verified.mechanisms.fates.fates import fates
from gspot_verified.mechanisms.fates.spot_sides import spot_sides
from gspot_verified.mechanisms.input.given import from_fields, lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.iwc import iwc
from gspot_verified.mechanisms.spots.all_g_spots import find_g_spots
from gspot_verified.mechanisms.spots.classify import classify
from gspot_verified.mechanisms.spots.classify_all import classify_all
from gspot_verified.mechanisms.spots.critical_friction import critical_friction
from gspot_verified.mechanisms.sweep.sweep import sweep
from gspot_verified.mechanisms.table.classify_table import classify_table
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.scenes.certified.certified_integration import integrated_run
from gspot_verified.scenes.equations.terms import FLIGHT, SLIP
from gspot_verified.scenes.scene.scene import Scene

CONTACT = ("compliant_contact", "lift_off")


def fields(mu: str = "1/2", A: str = "9", B: str = "1", fixed: tuple[str, ...] = ("x", "u", "w")) -> Mechanism:
    """p and b as in the model system, C = p + mu B; w rises, and p, b and the alphas do not feel it. The G-spot is at
    w = k."""
    return from_fields(
        "fields", ["x", "u", "y", "v", "p", "b", "w"], ["u", 0, "v", "b", -1, -1, "1 + w^2/100"],
        [0, A, 0, B, 0, "-3/2", 0], [0, f"({B})", 0, f"p + ({mu})*({B})", 0, f"3/2 - 3/2*({mu})", 0], "x", "y", mu,
        parameters={"k": 0}, place={"x": 0, "u": 1, "y": 0, "v": 0, "p": 0, "b": 0, "w": "k"}, fixed=list(fixed),
    )  # fmt: skip


GOOD: dict[str, str] = {}
BAD = {
    "mu < 0": {"mu": "1/4 - w"},
    "A < 0": {"A": "3 - 18*w"},
    "A C < B^2": {"B": "1 + 16*w"},
    "C < 0": {"mu": "1", "B": "1/4 - w"},
}
"""What makes sense at w = 0, and does not at w = 1."""


def at_one(made: dict[str, str]) -> Mechanism:
    return fields(**made).with_parameters(k=1)  # type: ignore[arg-type]


def followed(made: dict[str, str], effects: tuple[str, ...]) -> bool:
    start = {"p": "1/2", "b": "-1", "y": "-2/100", "v": "0", "z": "-1/100", "w": "0"}
    start |= {"u": "30"} if "stick" in effects else {}
    made_scene = Scene("run", effects, fmpq(1, 10), fmpq(3, 4), {}, start, None, fields(**made))  # type: ignore[arg-type]
    return integrated_run(made_scene, bits=(128,)).verdict.outcome is Outcome.PROVED


def free_of_paradox(made: dict[str, str]) -> bool:
    """p > 0 in every state of a region without a G-spot, w from 0 to 1."""
    found = find_g_spots(fields(**made, fixed=("x", "u")), {"p": ("1/10", "1/5"), "w": (0, 1)})
    assert found.verdict.outcome is Outcome.REFUTED  # no zero of p and b: formulas alone
    return found.sign_of_p is not None


def led_to_a_side(made: dict[str, str]) -> bool:
    start = {"x": 0, "u": 30, "p": "1/2", "b": "-2", "w": 0}
    return mechanism_side(fields(**made), start).approach.verdict.outcome is Outcome.PROVED  # type: ignore[arg-type]


def swept(made: dict[str, str]) -> bool:
    return sweep(fields(**made), {"k": "0..1:1"}, budget=2).verdict.outcome is Outcome.PROVED  # type: ignore[arg-type]


def a_row(made: dict[str, str]) -> bool:
    (row,) = classify_table(fields(**made), [{"k": 1}])  # type: ignore[arg-type]
    return row.case is not None


CONCLUSIONS: dict[str, Callable[[dict[str, str]], bool]] = {
    "classify": lambda made: classify(at_one(made)).case == "III",
    "classify_table": a_row,
    "find_g_spots": lambda made: find_g_spots(at_one(made)).verdict.outcome is Outcome.PROVED,
    "classify_all": lambda made: bool(classify_all(at_one(made)).spots),
    "sign_of_p": free_of_paradox,
    "sweep": swept,
    "sides of fates": lambda made: spot_sides(at_one(made)).evidence is not None,
    "expand": lambda made: bool(expand(at_one(made), 2).b),
    "iwc": lambda made: iwc(at_one(made), c1=1).leading is not None,
    "approach, mechanism_side": led_to_a_side,
    "run, u not seen": lambda made: followed(made, CONTACT),
    "run": lambda made: followed(made, (*CONTACT, "tangential_motion", "stick")),
}


@pytest.mark.parametrize("conclusion", CONCLUSIONS)
@pytest.mark.parametrize("bad", BAD)
def test_each_conclusion_refuses_each_bad_mechanism(conclusion: str, bad: str) -> None:
    try:
        drawn = CONCLUSIONS[conclusion](BAD[bad])
    except MechanismError:
        drawn = False
    assert not drawn


@pytest.mark.parametrize("conclusion", CONCLUSIONS)
def test_each_conclusion_is_drawn_of_the_good_mechanism(conclusion: str) -> None:
    assert CONCLUSIONS[conclusion](GOOD)


@pytest.mark.parametrize("bad", BAD)
def test_a_sweep_over_states_refuses_what_its_plane_does_not_hold(bad: str) -> None:
    with pytest.raises(MechanismError, match="here something depends on w, too"):
        fates(fields(**BAD[bad]), {"x": 0, "u": 30, "b": -1, "w": 0}, {"p": "1/4..1/2:2"})  # type: ignore[arg-type]


def unfelt(mass: str) -> Mechanism:
    """A block, and beside it a mass that the contact does not feel."""
    return lagrangian("unfelt", ["X", "H", "q"], [[1, 0, 0], [0, 1, 0], [0, 0, mass]], ["-1/2", -1, 0], "X", "H", "1/4")


@pytest.mark.parametrize(("z", "why"), [("-1/100", SLIP), ("-3/100", FLIGHT)])
@pytest.mark.parametrize(("mass", "definite"), [("1/4 - q", False), ("1/4 + q^2", True)])
def test_a_run_asks_for_masses_that_the_contact_does_not_feel(mass: str, definite: bool, z: str, why: str) -> None:
    """In contact and in flight: q = t, so that the mass falls through 0 at t = 1/4, where the motion ends."""
    effects = (*CONTACT, "tangential_motion", "stick")
    start = {"X_dot": "3", "y": "-2/100", "v": "0", "z": z, "q": "0", "q_dot": "1"}
    run = integrated_run(Scene(why, effects, fmpq(1, 10), fmpq(1), {}, start, None, unfelt(mass)), bits=(128,))
    assert (run.verdict.outcome is Outcome.PROVED) is definite
    assert definite or "the leading minor 3 of the mass matrix may be negative" in run.verdict.detail


@pytest.mark.parametrize("mass", ["1/4 - q", "-1 - q^2"])
def test_critical_friction_is_that_of_definite_masses(mass: str) -> None:
    found = critical_friction(unfelt(mass))
    assert found.value is None
    assert "mass matrix is not certainly positive definite" in found.reason
