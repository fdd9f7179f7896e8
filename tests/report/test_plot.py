"""plot(): each subject has its figure; what is drawn is what was computed; the suffix is checked before the work."""

from __future__ import annotations

import math
from itertools import pairwise
from pathlib import Path

import pytest
from flint import arb, fmpq

from gspot_verified import expand, iwc, load, load_scene, plot, simulate
from gspot_verified.compliant.model.normal_form import compliant_model
from gspot_verified.compliant.motion.compliant_force import SlowMotions, contact_motion
from gspot_verified.mechanisms.spots.g_spot import find_g_spot
from gspot_verified.numbers.balls import working_bits
from gspot_verified.report import plot as module
from gspot_verified.report.figures.b_hat_figure import scaled_b_hat
from gspot_verified.report.pictures.phase_plane import RigidSlip, phase_plane
from gspot_verified.signs.zeros.zeros import zeros_on_range
from gspot_verified.theta_function.value.evaluate import evaluate


def test_every_subject(tmp_path: Path) -> None:
    subjects = (
        load("rod"),
        expand(load("extended"), 3),
        iwc("7/3"),
        iwc("7/3").leading,
        zeros_on_range("1..2"),
    )
    names = ("phase-plane", "expansion", "contact-force", "contact-force", "atlas")
    for subject, name in zip(subjects, names, strict=True):
        assert plot(subject, tmp_path / "x.svg").name == name
        assert (tmp_path / "x.svg").read_text(encoding="utf-8").startswith("<svg")
    assert plot("b-hat", beta="3/2", epsilons=["1/10"]).name == "b-hat"


def test_which_runs_are_drawn(monkeypatch: pytest.MonkeyPatch) -> None:
    """One with floats where none is given; a certified one with boxes, which one without samples gets here."""
    monkeypatch.setattr(module, "scene_picture", lambda scene, runs: (scene.name, runs))
    scene = load_scene("fig-varsim1", epsilon="1/10", until="1/10")
    certified, floats = simulate(scene), simulate(scene, floats=True, points=5)
    assert certified.samples is None
    name, drawn = plot("run", scene=scene, run=[certified, floats])  # type: ignore[misc]
    assert name == "fig-varsim1"
    assert drawn[0].samples.boxes is not None
    assert drawn[1] is floats
    assert plot("run", scene=scene, run=floats) == (name, [floats])
    assert plot("run", scene=scene)[1][0].strength == "simulated"  # type: ignore[index]


@pytest.mark.slow
def test_a_run_has_its_picture() -> None:
    scene = load_scene("fig-varsim1", epsilon="1/20", until="1/4")
    drawn = plot("run", scene=scene, run=simulate(scene))
    assert drawn.title == "The scene fig-varsim1, ε = 1/20"
    assert "the trajectory lies in them" in drawn.caption


@pytest.mark.parametrize("name", ["x.jpg", "x", "x.png.txt"])
def test_the_suffix_comes_first(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    monkeypatch.setitem(module._NAMES, "theta", None)
    with pytest.raises(ValueError, match=r"pictures are written as \.png, \.pdf, \.svg"):
        plot("theta", tmp_path / name)


def test_what_has_no_figure() -> None:
    with pytest.raises(TypeError, match="a Verdict has no figure"):
        plot(iwc("7/3").verdict)
    with pytest.raises(
        ValueError,
        match="expected one of theta, b-hat, force, side-map, threshold, mechanism, animation, run, got 'atlas'",
    ):
        plot("atlas")
    for options in ({"beta": -1}, {"beta": "5/2", "epsilons": [0]}):
        with pytest.raises(ValueError, match=r"expected a rational"):
            plot("b-hat", **options)


def test_b_hat_is_that_of_the_model_and_tends_to_theta() -> None:
    """Against the motion of the model itself: b-hat = b + (alpha_2/(alpha_3 - alpha_1)) p at C_1 = 1."""
    beta, epsilon, tau = fmpq(7, 3), fmpq(1, 100), fmpq(-1)
    scaled = scaled_b_hat(beta, epsilon, tau)
    with working_bits(100):
        kappa = (arb(1) / 2) ** (arb(1) / 3)
        time = fmpq(*float((arb(tau) / kappa * arb(epsilon) ** (arb(2) / 3)).mid()).as_integer_ratio())
    motion = contact_motion(compliant_model(beta, epsilon), SlowMotions(fmpq(1))).at(time, 15)
    with working_bits(100):
        mean = arb(fmpq(-1) / (-beta + 1)) * arb(motion.p)
        unit = kappa ** -arb(beta) * arb(epsilon) ** (2 * arb(beta) / 3)
        assert abs((motion.b + mean) / unit - scaled) < 1e-9
        gaps = [abs(scaled_b_hat(beta, e, tau) - evaluate(tau, beta).value) for e in (fmpq(1), epsilon, fmpq(1, 10**6))]
        assert gaps[2] < gaps[1] < gaps[0]
        assert gaps[2] < fmpq(1, 100)


def test_the_phase_plane_of_constant_alphas() -> None:
    """The model system: b = slope p + C p^beta exactly, so C is the same along a run."""
    plane = phase_plane(load("model"))
    beta = plane.alphas[2] / plane.alphas[0]
    assert plane.slope == pytest.approx(plane.alphas[1] / (plane.alphas[0] - plane.alphas[2]))
    for run in plane.runs:
        charges = [(b - plane.slope * p) / p**beta for p, b in run if p > 0.02 * plane.reach]
        assert len(charges) > 20
        assert max(charges) - min(charges) <= 1e-6 * max(map(abs, charges))
    for p, b in plane.distinguished:
        assert b == pytest.approx(plane.slope * p, abs=1e-9)


def test_runs_flow_into_the_g_spot_and_the_expansion_is_a_run() -> None:
    plane = phase_plane(load("oscillator"))
    for run in plane.runs:
        assert run[0][0] == pytest.approx(plane.reach)
        assert math.hypot(*run[-1]) < 0.02 * plane.reach
    p, b = plane.distinguished[1]
    assert b / p == pytest.approx(plane.slope, rel=0.2)


def test_a_start_of_one_s_own() -> None:
    """The paper's start of the oscillator, on the side that lifts off: its curve ends in the G-spot."""
    plane = phase_plane(load("oscillator"), {"phi": "phi_ref + 1/10", "phi_dot": "-9/10"})
    assert plane.own[0][0] == pytest.approx(plane.reach)
    assert math.hypot(*plane.own[-1]) < 1e-6
    assert len(plane.own) > 20
    with pytest.raises(ValueError, match="spin"):
        phase_plane(load("oscillator"), {"spin": 0})


@pytest.mark.parametrize("spot", [1, 2])
def test_in_the_window_p_falls_on_every_run(spot: int) -> None:
    """The oscillator's first G-spot: from p = 1/4 slip leads away, and p > 0.2522 is not passed on the way back."""
    plane = phase_plane(load("oscillator"), spot=spot)
    for run in (*plane.runs, plane.distinguished[::-1]):
        assert all(later[0] <= earlier[0] for earlier, later in pairwise(run))
    assert all(run[0][0] == pytest.approx(plane.reach) for run in plane.runs)
    assert 0.9 * plane.reach < plane.distinguished[-1][0] <= 1.05 * plane.reach


def test_a_g_spot_to_which_p_does_not_fall_has_no_picture() -> None:
    with pytest.raises(
        ValueError, match=r"oscillator: alpha_1 = .* must be negative at the G-spot: .* \(classify_all lists"
    ):
        phase_plane(load("oscillator"), spot=5)


def test_a_state_in_contact_has_the_p_and_b_that_were_asked() -> None:
    spot = find_g_spot(load("genot_brogliato_rod"), 80)
    with working_bits(80):
        slip = RigidSlip(spot)
        state = slip.state_at(arb("0.1"), arb("-0.2"))
        assert state is not None
        assert slip.place(state) == pytest.approx((0.1, -0.2), abs=1e-12)
