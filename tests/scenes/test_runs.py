"""Float runs against certified runs, against closed forms, and what a float run refuses."""

from __future__ import annotations

import math

import pytest
from flint import fmpq

from gspot_verified.numbers.balls import approximate
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.scenes.certified_run import certified_run
from gspot_verified.scenes.floats.float_function import float_function
from gspot_verified.scenes.floats.float_run import METHODS, float_run
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.run import CERTIFIED, FLIGHT_THEN_IMPACT, IMPACT, SIMULATED, TRIVIAL, agreement
from gspot_verified.scenes.scene.scene import Scene, SceneError

FATE = {
    **{("1/2", nu): IMPACT for nu in ("1/4", "1/2", "1", "2", "4")},
    **{("3/2", nu): IMPACT for nu in ("1/4", "1/2")},
    **{("3/2", nu): FLIGHT_THEN_IMPACT for nu in ("2", "4")},
    **{("5/2", nu): FLIGHT_THEN_IMPACT for nu in ("1/4", "1/2")},
    **{("5/2", nu): IMPACT for nu in ("2", "4")},
}
"""The runs of fig. varsim1 off the trivial solution, as drawn."""


@pytest.mark.parametrize(
    ("beta", "nu"), [pytest.param(*run, marks=[] if run[1] in ("1/4", "4") else pytest.mark.slow) for run in FATE]
)
def test_the_runs_of_the_paper(beta: str, nu: str) -> None:
    scene = load_scene("fig-varsim1", beta=beta, nu=nu, epsilon="1e-3")
    simulated, certified = float_run(scene), certified_run(scene)
    assert simulated.fate == certified.fate == FATE[beta, nu]
    assert agreement(simulated, certified) is True
    assert (simulated.strength, certified.strength) == (SIMULATED, CERTIFIED)
    assert certified.verdict.outcome is Outcome.PROVED
    assert simulated.verdict.outcome is Outcome.UNDECIDED
    if certified.fate == FLIGHT_THEN_IMPACT:
        assert len(certified.events) == 2
        for seen, known in zip(simulated.events, certified.events, strict=False):
            assert seen.name == known.name
            assert abs(approximate(seen.lower - known.lower)) < 1e-9
            assert known.lower < known.upper < known.lower + fmpq(1, 10**15)


@pytest.mark.parametrize("beta", ["3/2", "5/2"])
def test_on_the_canard_a_float_event_is_a_contradiction(beta: str) -> None:
    """nu = 1 is the trivial solution exactly: certified; a float run leaves it by rounding, or shows no event."""
    scene = load_scene("fig-varsim1", beta=beta, nu=1)
    simulated, certified = float_run(scene), certified_run(scene)
    assert certified.fate == TRIVIAL
    assert certified.verdict.outcome is Outcome.PROVED
    assert agreement(simulated, certified) is (not simulated.events)


@pytest.mark.parametrize("method", METHODS)
def test_every_method_finds_the_lift_off(method: str) -> None:
    found = float_run(load_scene("fig-varsim1"), method)
    assert approximate(found.events[0].lower) == pytest.approx(0.5353708326627003, abs=1e-8)


def test_flight_is_the_closed_form() -> None:
    """Between lift-off and touch-down b falls at the rate 1, v and y are its integrals, z decays (proofs/flight.md)."""
    found = float_run(load_scene("fig-varsim1")).samples
    assert found is not None
    rows = [i for i, phase in enumerate(found.phases) if phase == "flight"]
    first, last = rows[0], rows[-1]
    at = {name: (column[first], column[last]) for name, column in found.columns.items()}
    time = at["t"][1] - at["t"][0]
    b, v, y, z = (at[name][0] for name in "bvyz")
    assert at["b"][1] == pytest.approx(b - time)
    assert at["v"][1] == pytest.approx(v + b * time - time**2 / 2, rel=1e-6)
    assert at["y"][1] == pytest.approx(y + v * time + b * time**2 / 2 - time**3 / 6, abs=1e-11)
    assert at["z"][1] == pytest.approx(z * math.exp(-time / 1e-3), abs=1e-15)
    assert set(found.columns["lambda_N"][rows]) == {0.0}


@pytest.mark.parametrize(
    ("chi", "nu"), [(0, "1/4"), (1, "1/4"), *(pytest.param(chi, "4", marks=pytest.mark.slow) for chi in (0, 1))]
)
def test_slip_ends_in_stick_or_in_lift_off(chi: int, nu: str) -> None:
    """Fig. varsim2: of the four runs one lifts off without a transition to stick, and in slip u = u_0 - (b - b_0 + t)
    /beta where chi plays no part in it."""
    run = float_run(load_scene("fig-varsim2", chi=chi, nu=nu))
    assert run.samples is not None
    columns = run.samples.columns
    last = max(i for i, phase in enumerate(run.samples.phases) if phase == "slip")
    moved = columns["b"][last] - columns["b"][0] + columns["t"][last]
    assert columns["u"][last] == pytest.approx(70 - moved / 0.5, abs=1e-5)
    names = [event.name for event in run.events]
    assert names[0] == "lift-off" if (chi, nu) == (1, "1/4") else names[:2] == ["stick", "lift-off"]


def test_no_coupling_gives_the_same_run() -> None:
    """chi = 0 and no stick before the impact: lift-off at the time of the model scene."""
    coupled = float_run(load_scene("fig-varsim2", chi=0, beta="3/2", nu=2, u=1000, until="3/5"))
    alone = float_run(load_scene("fig-varsim1", until="3/5"))
    assert [event.name for event in coupled.events] == [event.name for event in alone.events] == ["lift-off"]
    assert approximate(coupled.events[0].lower) == pytest.approx(approximate(alone.events[0].lower), abs=1e-8)


@pytest.mark.parametrize("name", ["fig-varsim1", "fig-varsim2"])
def test_the_jacobian_is_the_slope_of_the_rates(name: str) -> None:
    scene = load_scene(name)
    for phase in scene.phases():
        system = scene.system(phase)
        rates = float_function(system.right_hand_side)
        size = len(system.states)
        point = [0.3 - 0.2 * i for i in range(size)] + [40.0]
        slopes = float_function([entry for row in system.jacobian() for entry in row])(point)
        for j in range(size):
            up, down = list(point), list(point)
            up[j] += 1e-3
            down[j] -= 1e-3
            found = [(a - b) / 2e-3 for a, b in zip(rates(up), rates(down), strict=True)]
            assert slopes[j::size] == pytest.approx(found, abs=1e-9)


def test_what_is_refused() -> None:
    scene = load_scene("fig-varsim1")
    for words in ({"method": "RK45"}, {"tolerance": 0.0}, {"tolerance": math.nan}):
        with pytest.raises(SceneError):
            float_run(scene, **words)  # type: ignore[arg-type]
    with pytest.raises(SceneError, match="epsilon >= 1e-12"):
        float_run(scene.with_settings(epsilon="1e-13"))
    with pytest.raises(TypeError):
        bool(certified_run(scene.with_settings(nu=1)))


def test_a_start_in_flight_touches_down_at_the_time_of_the_closed_form() -> None:
    """z = 0 and b = -1/2, y = 1/100, v = 0: y(t) = 1/100 - t^2/4 - t^3/6."""
    start = {"p": fmpq(1, 2), "b": fmpq(-1, 2), "y": fmpq(1, 100), "v": fmpq(0), "z": fmpq(0)}
    scene = Scene("test", ("compliant_contact", "lift_off"), fmpq(1, 1000), fmpq(1, 5), {}, start)
    found = float_run(scene).events[0]
    time = approximate(found.lower)
    assert found.name == "touch-down"
    assert 0.01 - time**2 / 4 - time**3 / 6 == pytest.approx(0, abs=1e-11)


def test_the_stop_is_a_multiple_of_the_first_force() -> None:
    """Also with a stiff surface: the last force of the run is the stated multiple."""
    for stiffness in (1, 3):
        scene = load_scene("fig-varsim1", beta="1/2", k_2=stiffness)
        run = float_run(scene)
        assert run.samples is not None
        force = run.samples.columns["lambda_N"]
        assert run.fate == IMPACT
        assert force[-1] == pytest.approx(1000 * force[0], rel=1e-6)
