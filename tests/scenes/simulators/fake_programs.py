"""MuJoCo and Drake, played: they read the bodies that they are told, and slip on with the velocities that they have.

Each has a contact force until a time that the test says.
"""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections.abc import Sequence
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
from scenes.simulators.planar_numbers import PlanarNumbers

from gspot_verified.mechanisms.input.planar_links import PlanarJoint, PlanarLink, PlanarLinks, Point


def in_plane(words: Sequence[float]) -> Point:
    return (float(words[0]), float(words[2]))


class FakeMujoco(ModuleType):
    """``heavier`` is a factor of the masses that it is told."""

    def __init__(self, force_until: float, heavier: float = 1.0) -> None:
        super().__init__("mujoco")
        self.__version__ = "7.8.9"
        self.force_until, self.heavier = force_until, heavier
        self.applied: list[list[float]] = []
        self.told: PlanarLinks | None = None
        self.height = self.radius = 0.0
        self.MjModel = SimpleNamespace(from_xml_string=self._read)

    def _read(self, text: str) -> Any:
        root = ElementTree.fromstring(text)
        option, world = root.find("option"), root.find("worldbody")
        assert option is not None
        assert world is not None
        assert option.attrib["gravity"] == "0 0 0"
        self.step = float(option.attrib["timestep"])
        self.height = numbers(world.findall("geom")[0], "pos")[2]
        joints: dict[str, PlanarJoint] = {}
        links: list[PlanarLink] = []
        tips: list[tuple[tuple[int, ...], Point]] = []

        def read(body: ElementTree.Element, above: tuple[int, ...]) -> None:
            for joint in body.findall("joint"):
                kind, axis = joint.attrib["type"], numbers(joint, "axis")
                place = in_plane(numbers(joint, "pos") if kind == "hinge" else axis)
                armature = float(joint.attrib["armature"])
                joints[joint.attrib["name"]] = PlanarJoint(kind == "hinge", place, -int(axis[1]) or 1, 0, armature)
                above = (*above, len(joints) - 1)
            inertial = body.find("inertial")
            assert inertial is not None
            mass, inertia = float(inertial.attrib["mass"]) * self.heavier, numbers(inertial, "diaginertia")[1]
            links.append(PlanarLink(above, mass, inertia, in_plane(numbers(inertial, "pos"))))
            for tip in body.findall("geom"):
                self.radius = float(tip.attrib["size"])
                tips.append((above, in_plane(numbers(tip, "pos"))))
            for inner in body.findall("body"):
                read(inner, above)

        for body in world.findall("body"):
            read(body, ())
        ((touching, point),) = tips
        self.told = PlanarLinks(tuple(joints.values()), tuple(links), touching, point)
        self.numbers = PlanarNumbers(self.told)
        places = {name: SimpleNamespace(dofadr=[number]) for number, name in enumerate(joints)}
        return SimpleNamespace(joint=places.__getitem__, geom=lambda _: SimpleNamespace(id=0), geom_bodyid=[1])

    def MjData(self, _: Any) -> Any:
        assert self.told is not None
        size = len(self.told.joints)
        zeros = {word: np.zeros(size) for word in ("qpos", "qvel", "qfrc_applied", "qfrc_bias")}
        return SimpleNamespace(time=0.0, ncon=2, geom_xpos=[None], **zeros)

    def mj_forward(self, _: Any, data: Any) -> None:
        self.moves, self.M = self.numbers.tip(data.qpos), self.numbers.mass_matrix(data.qpos)

    mj_step1 = mj_forward

    def mj_jac(self, _: Any, __: Any, moves: Any, *___: Any) -> None:
        moves[0], moves[2] = self.moves

    def mj_solveM(self, _: Any, __: Any, found: Any, given: Any) -> None:
        found[:] = np.linalg.solve(self.M, given.T).T

    def mj_mulM(self, _: Any, __: Any, found: Any, given: Any) -> None:
        found[:] = self.M @ given

    def mj_step2(self, _: Any, data: Any) -> None:
        self.applied.append(data.qfrc_applied.tolist())
        data.time += self.step
        data.qpos += self.step * data.qvel

    def mj_contactForce(self, _: Any, data: Any, number: int, wrench: Any) -> None:
        wrench[:] = [0.5 if data.time < self.force_until else 0.0, 0, 0, 0, 0, 99.0 * number]


def numbers(element: ElementTree.Element, word: str) -> list[float]:
    return [float(each) for each in element.attrib[word].split()]


def own_inertia(mass: float, centre: Sequence[float], inertia: float) -> tuple[float, float, Point]:
    return mass, inertia, in_plane(centre)


class FakeDrake(ModuleType):
    """The module ``pydrake`` with its ``all``."""

    def __init__(self, force_until: float, gives_up: float) -> None:
        super().__init__("pydrake")
        self.times = (force_until, gives_up)
        self.plants: list[FakePlant] = []
        same = SimpleNamespace
        self.all = SimpleNamespace(
            DiagramBuilder=lambda: same(Build=lambda: self.plants[-1]),
            MultibodyPlantConfig=same,
            AddMultibodyPlant=self._plant,
            SpatialInertia=same(
                Zero=lambda: None, MakeFromCentralInertia=lambda m, c, inertia: (m, inertia, in_plane(c))
            ),
            RotationalInertia=lambda *about: about[1],
            RigidTransform=in_plane,
            FixedOffsetFrame=lambda _, frame, place: same(body=frame.body, place=place),
            RevoluteJoint=FakeJoint,
            PrismaticJoint=FakeJoint,
            CoulombFriction=lambda _, dynamic: dynamic,
            HalfSpace=lambda: "surface",
            Sphere=lambda radius: radius,
            ProximityProperties=lambda: FakeProperties(self.plants[-1]),
            AddContactMaterial=lambda **settings: self.plants[-1].materials.append(settings),
            JacobianWrtVariable=same(kV="v"),
            Simulator=lambda plant: plant,
        )

    def _plant(self, settings: Any, _: Any) -> tuple[Any, None]:
        self.plants.append(FakePlant(settings, *self.times))
        return self.plants[-1], None


class FakeProperties:
    def __init__(self, plant: FakePlant) -> None:
        self.words: dict[str, float] = {}
        plant.properties.append(self.words)

    def AddProperty(self, group: str, word: str, value: float) -> None:
        assert group == "material"
        self.words[word] = value


class FakeJoint:
    def __init__(self, name: str, before: Any, behind: Any, axis: Any) -> None:
        self.number, self.before, self.behind = int(name[1:]), before.body, behind.body
        is_hinge = bool(axis[1])
        place = before.place if is_hinge else in_plane(axis)
        assert before.place == behind.place
        self.joint = PlanarJoint(is_hinge, place, -int(axis[1]) or 1)

    def velocity_start(self) -> int:
        return self.number


class FakePlant:
    """A plant, its diagram, its simulator, and its context."""

    def __init__(self, settings: Any, force_until: float, gives_up: float) -> None:
        self.settings, self.force_until, self.gives_up, self.time = settings, force_until, gives_up, 0.0
        if settings.discrete_contact_approximation not in ("sap", "tamsi", "similar", "lagged"):
            raise RuntimeError(f"There is no contact approximation {settings.discrete_contact_approximation}")
        self.materials: list[dict[str, Any]] = []
        self.properties: list[dict[str, float]] = []
        self.shapes: dict[str, Any] = {}
        self.joints: list[FakeJoint] = []
        self.bodies: list[Any] = []
        self.applied: list[list[float]] = []
        self.gravity: Any = None

    def mutable_gravity_field(self) -> Any:
        return SimpleNamespace(set_gravity_vector=lambda vector: setattr(self, "gravity", vector.tolist()))

    def world_body(self) -> Any:
        return self._body(None)

    def _body(self, inertia: Any) -> Any:
        body = SimpleNamespace(inertia=inertia)
        body.body_frame = lambda: SimpleNamespace(body=body, place=(0.0, 0.0))
        return body

    world_frame = world_body

    def AddRigidBody(self, _: str, inertia: Any) -> Any:
        self.bodies.append(self._body(inertia))
        return self.bodies[-1]

    def AddFrame(self, frame: Any) -> Any:
        return frame

    def AddJoint(self, joint: FakeJoint) -> FakeJoint:
        self.joints.append(joint)
        return joint

    def RegisterCollisionGeometry(self, body: Any, place: Point, shape: Any, name: str, _: Any) -> None:
        self.shapes[name] = (body, place, shape)

    def Finalize(self) -> None:
        joints = sorted(self.joints, key=lambda joint: joint.number)
        links = [(self._behind(body), body.inertia) for body in self.bodies if body.inertia is not None]
        tip, point, _ = self.shapes["tip"]
        self.told = PlanarLinks(
            tuple(each.joint for each in joints),
            tuple(PlanarLink(behind, *inertia) for behind, inertia in links),
            self._behind(tip),
            point,
        )
        self.numbers = PlanarNumbers(self.told)

    def _behind(self, body: Any) -> tuple[int, ...]:
        joint = next((each for each in self.joints if each.behind is body), None)
        return () if joint is None else (*self._behind(joint.before), joint.number)

    def get_mutable_context(self) -> FakePlant:
        return self

    def GetMyMutableContextFromRoot(self, _: Any) -> FakePlant:
        return self

    def get_applied_generalized_force_input_port(self) -> Any:
        return SimpleNamespace(FixValue=lambda _, forces: self.applied.append(forces.tolist()))

    def SetPositions(self, _: Any, places: Any) -> None:
        self.places = places

    def SetVelocities(self, _: Any, rates: Any) -> None:
        self.rates = rates

    def GetPositions(self, _: Any) -> Any:
        return self.places

    def GetVelocities(self, _: Any) -> Any:
        return self.rates

    def CalcMassMatrix(self, _: Any) -> Any:
        return self.numbers.mass_matrix(self.places)

    def CalcBiasTerm(self, _: Any) -> Any:
        return np.zeros(len(self.places))

    def CalcJacobianTranslationalVelocity(self, _: Any, __: str, ___: Any, point: Any, *____: Any) -> Any:
        along, up = self.numbers.tip(self.places)
        assert in_plane(point[:, 0]) == self.told.point
        return np.array([along, 0 * along, up])

    def Initialize(self) -> None:
        self.time = 0.0

    def AdvanceTo(self, time: float) -> None:
        if time > self.gives_up:
            raise RuntimeError("The solver\nfailed to converge.")
        self.places = self.places + (time - self.time) * self.rates
        self.time = time

    def get_contact_results_output_port(self) -> Any:
        force = [7.0, 0.0, -0.5 if self.time < self.force_until else 0.0]
        found = SimpleNamespace(
            num_point_pair_contacts=lambda: 1,
            point_pair_contact_info=lambda _: SimpleNamespace(contact_force=lambda: force),
        )
        return SimpleNamespace(Eval=lambda _: found)
