"""Programs that may be installed, played by modules that are made here: what they are told, and what is read off."""

from __future__ import annotations

import sys
import xml.etree.ElementTree as ElementTree
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest

from gspot_verified import load
from gspot_verified.scenes.simulators.comparison import EARLY, RIGHT, WRONG, simulators
from gspot_verified.scenes.simulators.programs import installed

START = {"X": 0, "X_dot": 5, "theta": "4/5", "theta_dot": "33/10"}


class FakeMujoco(ModuleType):
    """The body slips on with the velocities that it has; its contact force vanishes at a time."""

    def __init__(self, force_until: float) -> None:
        super().__init__("mujoco")
        self.__version__ = "7.8.9"
        self.force_until = force_until
        self.applied: list[list[float]] = []
        self.model = ""
        self.MjModel = SimpleNamespace(from_xml_string=self._read)
        self.MjData = lambda _: SimpleNamespace(
            time=0.0, qpos=[0.0] * 3, qvel=[0.0] * 3, qfrc_applied=[0.0] * 3, ncon=2
        )

    def _read(self, text: str) -> float:
        self.model = text
        option = ElementTree.fromstring(text).find("option")
        assert option is not None
        return float(option.attrib["timestep"])

    def mj_step(self, step: float, data: Any) -> None:
        self.applied.append(list(data.qfrc_applied))
        data.time += step
        data.qpos[:] = [place + step * rate for place, rate in zip(data.qpos, data.qvel, strict=True)]

    def mj_contactForce(self, _: float, data: Any, number: int, wrench: Any) -> None:
        wrench[:] = [0.5 if data.time < self.force_until else 0.0, 0, 0, 0, 0, 99.0 * number]


@pytest.mark.parametrize(
    ("time", "rate", "agrees"), [(0.03, "33/10", RIGHT), (0.03, "17/5", WRONG), (0.004, "33/10", EARLY)]
)
def test_when_the_force_of_a_program_vanishes(
    monkeypatch: pytest.MonkeyPatch, time: float, rate: str, agrees: str
) -> None:
    fake = FakeMujoco(time)
    monkeypatch.setitem(sys.modules, "mujoco", fake)
    found = simulators(load("rod with a wrist"), START | {"theta_dot": rate}, epsilons=[], steps=[1e-2])
    run = found.runs[-1]
    assert (run.simulator, run.happened, run.agrees) == ("MuJoCo 7.8.9", "leaves the surface", agrees)
    assert run.time == pytest.approx(time, abs=3e-4)
    assert run.settings.startswith("dt = 2.5e-04, solref = 2.5e-03 1")
    assert [note.split(":")[0] for note in found.notes] == ["MuJoCo"]
    assert "convex friction cone" in str(found)
    assert fake.applied[0] == pytest.approx([0, -14.81, 5 * (0.8 - 0.9) + ratio(rate)])


def ratio(text: str) -> float:
    above, below = text.split("/")
    return int(above) / int(below)


def test_the_body_that_a_program_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    """In contact: the lowest point of the sphere is at height 0."""
    fake = FakeMujoco(1.0)
    monkeypatch.setitem(sys.modules, "mujoco", fake)
    simulators(load("rod with a wrist"), START, epsilons=[], steps=[1e-1])
    body = ElementTree.fromstring(fake.model).find("worldbody/body")
    assert body is not None
    sphere, inertial = body.find("geom"), body.find("inertial")
    assert sphere is not None
    assert inertial is not None
    height, arm, radius = (
        float(text.split()[-1]) for text in (body.attrib["pos"], sphere.attrib["pos"], sphere.attrib["size"])
    )
    assert height + arm - radius == pytest.approx(0, abs=1e-12)
    assert float(inertial.attrib["mass"]) == pytest.approx(1)
    assert float(inertial.attrib["diaginertia"].split()[1]) == pytest.approx(1 / 3)


def test_what_is_not_installed_or_cannot_be_told_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "mujoco", None)
    found = simulators(load("rod with a wrist"), START, epsilons=[], steps=[1e-1])
    assert found.notes == ("MuJoCo is not installed, so it was not run: pip install mujoco",)
    assert [run.simulator for run in found.runs] == ["Moreau-Jean"] * 2
    monkeypatch.setitem(sys.modules, "mujoco", FakeMujoco(1.0))
    belt = {"phi": "phi_ref + 1/10", "phi_dot": "-9/10"}
    moved = simulators(load("oscillator"), belt, surface_velocity=-4, epsilons=[], steps=[1e-1])
    assert moved.notes == ("MuJoCo: not run: the surface moves",)
    with pytest.raises(ValueError, match="programs: expected names of MuJoCo, got 'Bullet'"):
        installed(["Bullet"])
