"""Programs that may be installed, played by modules that are made here: what they are told, and what is read off."""

from __future__ import annotations

import sys
from collections.abc import Callable

import pytest
from scenes.simulators.fake_programs import FakeDrake, FakeMujoco
from scenes.simulators.test_planar_model import walker

from gspot_verified import load
from gspot_verified.mechanisms.input.planar_links import PlanarLinks
from gspot_verified.scenes.scene.scene import SceneError
from gspot_verified.scenes.simulators import drake_engine
from gspot_verified.scenes.simulators.comparison import EARLY, FAILED, MUJOCO, RIGHT, WRONG, installed, simulators
from gspot_verified.scenes.simulators.contact_floats import contact_floats
from gspot_verified.scenes.simulators.drake_engine import SOLVERS, DrakeEngine, spring
from gspot_verified.scenes.simulators.engine import follow
from gspot_verified.scenes.simulators.mujoco_engine import MujocoEngine
from gspot_verified.scenes.simulators.planar_body import planar_model
from gspot_verified.scenes.simulators.planar_model import PlanarModel

START = {"X": 0, "X_dot": 5, "theta": "4/5", "theta_dot": "33/10"}
BELT = {"phi": "phi_ref + 1/10", "phi_dot": "-9/10"}


def mujoco(monkeypatch: pytest.MonkeyPatch, force_until: float = 1.0, heavier: float = 1.0) -> FakeMujoco:
    fake = FakeMujoco(force_until, heavier)
    monkeypatch.setitem(sys.modules, "mujoco", fake)
    return fake


def drake(monkeypatch: pytest.MonkeyPatch, force_until: float = 1.0, gives_up: float = 9.0) -> FakeDrake:
    fake = FakeDrake(force_until, gives_up)
    monkeypatch.setitem(sys.modules, "pydrake", fake)
    monkeypatch.setitem(sys.modules, "pydrake.all", fake.all)
    monkeypatch.setattr(drake_engine, "version", lambda _: "4.5.6")
    return fake


@pytest.mark.parametrize(
    ("time", "rate", "agrees"), [(0.03, "33/10", RIGHT), (0.03, "17/5", WRONG), (0.004, "33/10", EARLY)]
)
def test_when_the_force_of_a_program_vanishes(
    monkeypatch: pytest.MonkeyPatch, time: float, rate: str, agrees: str
) -> None:
    fake, start = mujoco(monkeypatch, time), START | {"theta_dot": rate}
    found = simulators(load("rod with a wrist"), start, epsilons=[], steps=[1e-2], programs=[MUJOCO])
    run = found.runs[-1]
    assert (run.simulator, run.happened, run.agrees) == ("MuJoCo 7.8.9", "leaves the surface", agrees)
    assert run.time == pytest.approx(time, abs=3e-4)
    assert run.settings.startswith("dt = 2.5e-04, solref = 2.5e-03 1")
    assert [note.split(":")[0] for note in found.notes] == ["MuJoCo"]
    assert "convex friction cone" in str(found)
    assert fake.applied[0] == pytest.approx([0, -14.81, 5 * (0.9 - 0.8) - ratio(rate)])


def test_each_solver_of_drake_is_run_and_a_program_with_other_bodies_is_not(monkeypatch: pytest.MonkeyPatch) -> None:
    mujoco(monkeypatch, heavier=1.001)
    fake = drake(monkeypatch, 0.03)
    found = simulators(load("rod with a wrist"), START, epsilons=[], steps=[1e-2])
    refused, *runs = found.runs[2:]
    assert (refused.simulator, refused.time, refused.agrees) == ("MuJoCo 7.8.9", None, FAILED)
    assert refused.happened == "its mass matrix and contact point are not those of the mechanism"
    assert {(run.simulator, run.happened, run.agrees) for run in runs} == {("Drake 4.5.6", "leaves the surface", RIGHT)}
    assert [run.settings.split(",")[0] for run in runs] == [*SOLVERS]
    assert [plant.settings.discrete_contact_approximation for plant in fake.plants] == [*SOLVERS]
    assert runs[0].time == pytest.approx(0.03, abs=3e-4)
    assert [note.split(":")[0] for note in found.notes] == ["MuJoCo", "Drake"]
    assert fake.plants[0].applied[1] == pytest.approx([0, -14.81, 5 * (0.9 - 0.8) - 3.3])


def ratio(text: str) -> float:
    above, below = text.split("/")
    return int(above) / int(below)


def the_rod() -> PlanarModel:
    rod = load("rod with a wrist")
    return planar_model(rod.bodies, contact_floats(rod), (0.0, 0.717356, 0.8, 5.0, 2.3, 3.3))


@pytest.mark.parametrize("made", [the_rod, walker], ids=["rod", "walker"])
def test_the_bodies_that_mujoco_is_told(monkeypatch: pytest.MonkeyPatch, made: Callable[[], PlanarModel]) -> None:
    """In contact the lowest point of the sphere is in the surface."""
    fake, model = mujoco(monkeypatch), made()
    follow(model, MujocoEngine(model, 1e-2), step=1e-2, until=2e-2)
    assert fake.told is not None
    assert fake.height + fake.radius == pytest.approx(model.height)
    same_bodies(fake.told, model.bodies)
    assert [joint.armature for joint in fake.told.joints] == [joint.armature for joint in model.bodies.joints]


def test_the_bodies_that_drake_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    fake, model = drake(monkeypatch), the_rod()
    follow(model, DrakeEngine(model, 1e-2, "lagged"), step=1e-2, until=2e-2)
    (plant,) = fake.plants
    same_bodies(plant.told, model.bodies)
    assert plant.gravity == [0, 0, 0]
    assert plant.shapes["surface"][1][1] + plant.shapes["tip"][2] == pytest.approx(model.height)
    stiff = [material["point_stiffness"] for material in plant.materials]
    contact = spring(model, 1e-2)
    assert 1 / sum(1 / each for each in stiff) == pytest.approx(contact.stiffness)
    assert {material["dissipation"] for material in plant.materials} == {contact.dissipation}
    assert sum(properties["relaxation_time"] for properties in plant.properties) == pytest.approx(contact.relaxation)
    assert {material["friction"] for material in plant.materials} == {1.5}
    assert plant.settings.time_step == 1e-2
    assert plant.settings.stiction_tolerance == pytest.approx(1e-4 * model.functions.contact(model.start).u)


def test_the_spring_is_critically_damped_about_its_rest() -> None:
    """The point of mass 1/C on its spring has the frequency 1/T, T ten steps, and the roots of s^2 + 2 s/T + 1/T^2."""
    model, T = the_rod(), 10 * 1e-3
    contact, found = model.functions.contact(model.start), spring(the_rod(), 1e-3)
    force = -contact.b / contact.p
    assert contact.C * found.stiffness == pytest.approx(1 / T**2)
    assert contact.C * found.stiffness * found.relaxation == pytest.approx(2 / T)
    assert contact.C * force * found.dissipation == pytest.approx(2 / T)  # of k x (1 + d x') at k x = force


def same_bodies(told: PlanarLinks, bodies: PlanarLinks) -> None:
    assert (told.touching, told.point) == (bodies.touching, bodies.point)
    assert sorted(told.links, key=lambda link: link.joints) == sorted(bodies.links, key=lambda link: link.joints)
    for theirs, ours in zip(told.joints, bodies.joints, strict=True):
        assert (theirs.is_hinge, theirs.turn, theirs.place) == (ours.is_hinge, ours.turn, ours.place)


def test_a_solver_that_gives_up_says_when(monkeypatch: pytest.MonkeyPatch) -> None:
    drake(monkeypatch, gives_up=0.024)
    model = the_rod()
    with pytest.raises(SceneError, match=r"gives up in step 3: The solver failed to converge\."):
        follow(model, DrakeEngine(model, 1e-2, "sap"), step=1e-2, until=5e-2)
    with pytest.raises(SceneError, match=r"refused: There is no contact approximation euler"):
        DrakeEngine(model, 1e-2, "euler")


def test_what_is_not_installed_or_cannot_be_told_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    for module in ("mujoco", "pydrake"):
        monkeypatch.setitem(sys.modules, module, None)
    found = simulators(load("rod with a wrist"), START, epsilons=[], steps=[1e-1])
    assert found.notes == tuple(
        f"{name} is not installed, so it was not run: pip install {name.lower()}" for name in ("MuJoCo", "Drake")
    )
    assert [run.simulator for run in found.runs] == ["Moreau-Jean"] * 2
    moved = simulators(load("oscillator"), BELT, surface_velocity=-4, epsilons=[], steps=[1e-1])
    assert moved.notes == ("MuJoCo: not run: the surface moves", "Drake: not run: the surface moves")
    mujoco(monkeypatch)
    drake(monkeypatch)
    moved = simulators(load("oscillator"), BELT, surface_velocity=-4, epsilons=[], steps=[1e-1])
    assert moved.notes == ("MuJoCo: not run: the surface moves", "Drake: not run: the surface moves")
    with pytest.raises(ValueError, match="programs: expected names of MuJoCo, Drake, got 'Bullet'"):
        installed(["Bullet"])
