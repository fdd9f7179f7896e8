"""Rigid bodies in a plane in Drake, where that is installed: https://drake.mit.edu, MultibodyPlant in discrete steps.

Its contact of points is a spring with a damper, and its friction regularised. Of the discrete approximations SAP, and
"similar" with another damper, are convex problems whose friction pushes a contact apart that slips; "lagged" takes the
normal force in the friction from the step before; TAMSI solves the nonlinear equations. So all are other models than
that of the paper, whose side they need not take.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from typing import Any

import numpy as np

from gspot_verified.scenes.scene.scene import SceneError
from gspot_verified.scenes.simulators.engine import STIFF
from gspot_verified.scenes.simulators.planar_model import PlanarModel

SOLVERS = ("sap", "tamsi", "similar", "lagged")  # of Drake's discrete_contact_approximation
_SMOOTHED = 1e-4  # of the slip velocity at the start: below it friction is regularised
_UP, _ALONG = np.array([0.0, 0.0, 1.0]), np.array([1.0, 0.0, 0.0])


def drake_version() -> str | None:
    """That of the installed Drake, or None."""
    try:
        import pydrake  # noqa: F401

        return version("drake")
    except (ImportError, PackageNotFoundError):
        return None


@dataclass(frozen=True)
class Spring:
    """The contact in the normal direction, for a point of mass 1/C under the force -b/p of rigid slip: as in MuJoCo its
    time constant T is some steps, and it is damped critically about its place of rest.

    ``stiffness`` k = 1/(C T^2), ``relaxation`` 2 T for a damper that is linear (SAP), ``dissipation`` 2 T k/λ for one
    that grows with the force (Hunt and Crossley).
    """

    stiffness: float
    relaxation: float
    dissipation: float


def spring(model: PlanarModel, step: float) -> Spring:
    """That of the start."""
    contact, constant = model.functions.contact(model.start), STIFF * step
    k = 1 / (contact.C * constant**2)
    return Spring(k, 2 * constant, 2 * constant * k * abs(contact.p / contact.b))


class DrakeEngine:
    """The bodies in the plane of Drake's x and z, in steps of one length.

    :raises SceneError: Drake refuses them, or has no such solver.
    """

    def __init__(self, model: PlanarModel, step: float, solver: str) -> None:
        try:
            self._make(model, step, solver)
        except RuntimeError as error:
            raise SceneError(f"refused: {' '.join(str(error).split())[:80]}") from None

    def _make(self, model: PlanarModel, step: float, solver: str) -> None:
        from pydrake import all as drake

        self._drake, self._period, self._done = drake, step, 0
        builder = drake.DiagramBuilder()
        slip = abs(model.functions.contact(model.start).u)
        settings = drake.MultibodyPlantConfig(
            time_step=step,
            contact_model="point",
            discrete_contact_approximation=solver,
            stiction_tolerance=_SMOOTHED * slip,
        )
        self._plant, _ = drake.AddMultibodyPlant(settings, builder)
        self._plant.mutable_gravity_field().set_gravity_vector(np.zeros(3))
        joints = self._add_bodies(model)
        self._touch(model, spring(model, step))
        self._plant.Finalize()
        self._order = [joint.velocity_start() for joint in joints]
        self._diagram = builder.Build()
        self._simulator = drake.Simulator(self._diagram)
        self._context = self._plant.GetMyMutableContextFromRoot(self._simulator.get_mutable_context())
        self._forces = self._plant.get_applied_generalized_force_input_port()
        self._forces.FixValue(self._context, np.zeros(len(joints)))

    def _add_bodies(self, model: PlanarModel) -> list[Any]:
        """The joints in the order of the model's; all bodies have the frame of the world where they stand as given."""
        drake, plant = self._drake, self._plant
        joints: dict[int, Any] = {}
        made: list[Any] = []
        for placed in model.tree():
            body = plant.world_body() if placed.above is None else made[placed.above]
            for number in placed.joints:
                link = placed.link
                inertia = drake.SpatialInertia.Zero()
                if number == placed.joints[-1]:
                    centre = np.array([link.centre[0], 0.0, link.centre[1]])
                    own = drake.RotationalInertia(link.inertia, link.inertia, link.inertia)
                    inertia = drake.SpatialInertia.MakeFromCentralInertia(link.mass, centre, own)
                behind = plant.AddRigidBody(f"b{number}", inertia)
                joints[number] = self._joint(model, number, body, behind)
                body = behind
            made.append(body)
        self._tip = made[model.tip]
        return [joints[number] for number in range(len(model.order))]

    def _joint(self, model: PlanarModel, number: int, before: Any, behind: Any) -> Any:
        drake, plant, joint = self._drake, self._plant, model.bodies.joints[number]
        x, z = joint.place
        if joint.is_hinge:
            place = drake.RigidTransform(np.array([x, 0.0, z]))
            ends = [
                plant.AddFrame(drake.FixedOffsetFrame(f"{end}{number}", body.body_frame(), place))
                for end, body in (("before", before), ("behind", behind))
            ]
            made = plant.AddJoint(drake.RevoluteJoint(f"j{number}", *ends, np.array([0.0, -joint.turn, 0.0])))
        else:
            frames = (before.body_frame(), behind.body_frame())
            made = plant.AddJoint(drake.PrismaticJoint(f"j{number}", *frames, np.array([x, 0.0, z])))
        if joint.armature:
            motor = plant.AddJointActuator(f"m{number}", made)
            motor.set_default_rotor_inertia(joint.armature)
            motor.set_default_gear_ratio(1.0)
        return made

    def _touch(self, model: PlanarModel, contact: Spring) -> None:
        """A small sphere about the point, and the surface: Drake puts the springs of both in a row, so each is twice as
        stiff, and adds their relaxation times."""
        drake, plant, friction = self._drake, self._plant, self._drake.CoulombFriction(model.friction, model.friction)
        x, z = model.bodies.point
        self._point = np.array([x, 0.0, z])
        surface = np.array([0.0, 0.0, model.height - model.radius])
        for body, place, shape, name in (
            (plant.world_body(), surface, drake.HalfSpace(), "surface"),
            (self._tip, self._point, drake.Sphere(model.radius), "tip"),
        ):
            properties = drake.ProximityProperties()
            drake.AddContactMaterial(
                dissipation=contact.dissipation,
                point_stiffness=2 * contact.stiffness,
                friction=friction,
                properties=properties,
            )
            properties.AddProperty("material", "relaxation_time", contact.relaxation / 2)
            plant.RegisterCollisionGeometry(body, drake.RigidTransform(place), shape, name, properties)

    def directions(self, places: Sequence[float]) -> tuple[Sequence[float], Sequence[float]]:
        """M^-1 dx/dq and M^-1 dy/dq."""
        plant, context, kind = self._plant, self._context, self._drake.JacobianWrtVariable.kV
        self._set(places, [0.0] * len(places))
        world = plant.world_frame()
        moves = plant.CalcJacobianTranslationalVelocity(
            context, kind, self._tip.body_frame(), self._point.reshape(3, 1), world, world
        )
        found = np.linalg.solve(plant.CalcMassMatrix(context), moves.T)
        return (found @ _ALONG)[self._order].tolist(), (found @ _UP)[self._order].tolist()

    def begin(self, places: Sequence[float], rates: Sequence[float]) -> None:
        """From here the motion goes on."""
        self._set(places, rates)
        self._simulator.Initialize()

    def step(self, accelerations: Sequence[float]) -> tuple[Sequence[float], Sequence[float], float]:
        """Places, rates and the normal force after one step.

        :raises SceneError: Drake gives up.
        """
        plant, context = self._plant, self._context
        wanted = np.zeros(len(accelerations))
        wanted[self._order] = accelerations
        self._forces.FixValue(context, plant.CalcMassMatrix(context) @ wanted + plant.CalcBiasTerm(context))
        self._done += 1
        try:
            self._simulator.AdvanceTo(self._done * self._period)
        except RuntimeError as error:
            raise SceneError(f"gives up in step {self._done}: {' '.join(str(error).split())[:80]}") from None
        places, rates = plant.GetPositions(context), plant.GetVelocities(context)
        return places[self._order].tolist(), rates[self._order].tolist(), self._normal_force()

    def _set(self, places: Sequence[float], rates: Sequence[float]) -> None:
        for values, put in ((places, self._plant.SetPositions), (rates, self._plant.SetVelocities)):
            ordered = np.zeros(len(values))
            ordered[self._order] = values
            put(self._context, ordered)

    def _normal_force(self) -> float:
        found = self._plant.get_contact_results_output_port().Eval(self._context)
        pairs = (found.point_pair_contact_info(i) for i in range(found.num_point_pair_contacts()))
        return float(sum(abs(pair.contact_force()[2]) for pair in pairs))
