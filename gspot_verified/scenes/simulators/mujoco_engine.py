"""Rigid bodies in a plane in MuJoCo, where that is installed: https://mujoco.readthedocs.io.

MuJoCo's contact is soft and its friction cone convex: a contact that slips is also pushed apart. So it is another model
than that of the paper, whose side it need not take.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gspot_verified.scenes.scene.scene import SceneError
from gspot_verified.scenes.simulators.engine import STIFF
from gspot_verified.scenes.simulators.planar_model import Placed, PlanarModel

_TEXT = """<mujoco>
<option timestep="{step!r}" gravity="0 0 0" cone="elliptic" iterations="200" tolerance="1e-14"/>
<default><geom condim="3" friction="{friction!r} 0 0" solref="{stiff!r} 1"/></default>
<worldbody><geom type="plane" size="50 50 1" pos="0 0 {height!r}"/>{bodies}</worldbody></mujoco>"""
_BODY = """<body>{joints}
<inertial pos="{x!r} 0 {z!r}" mass="{mass!r}" diaginertia="{inertia!r} {inertia!r} {inertia!r}"/>{inner}</body>"""
_TIP = '<geom name="tip" type="sphere" size="{radius!r}" pos="{x!r} 0 {z!r}" mass="0"/>'


def mujoco_version() -> str | None:
    """That of the installed MuJoCo, or None."""
    try:
        import mujoco
    except ImportError:
        return None
    return str(mujoco.__version__)


class MujocoEngine:
    """The bodies in the plane of MuJoCo's x and z, in steps of one length.

    :raises SceneError: MuJoCo refuses the bodies.
    """

    def __init__(self, model: PlanarModel, step: float) -> None:
        import mujoco

        self._mujoco = mujoco
        try:
            self._model = mujoco.MjModel.from_xml_string(_text(model, step))
        except ValueError as error:
            raise SceneError(f"refused: {' '.join(str(error).split())[:120]}") from None
        self._data = mujoco.MjData(self._model)
        self._order = [int(self._model.joint(f"j{number}").dofadr[0]) for number in range(len(model.order))]
        self._tip = int(self._model.geom("tip").id)

    def directions(self, places: Sequence[float]) -> tuple[Sequence[float], Sequence[float]]:
        """M^-1 dx/dq and M^-1 dy/dq."""
        self.begin(places, [0.0] * len(places))
        self._mujoco.mj_forward(self._model, self._data)
        moves = np.zeros((3, len(places)))
        middle, body = self._data.geom_xpos[self._tip], self._model.geom_bodyid[self._tip]
        self._mujoco.mj_jac(self._model, self._data, moves, None, middle, body)
        found = np.zeros((3, len(places)))
        self._mujoco.mj_solveM(self._model, self._data, found, moves)
        return found[0][self._order].tolist(), found[2][self._order].tolist()

    def begin(self, places: Sequence[float], rates: Sequence[float]) -> None:
        """From here the motion goes on."""
        self._data.qpos[self._order] = places
        self._data.qvel[self._order] = rates

    def step(self, accelerations: Sequence[float]) -> tuple[Sequence[float], Sequence[float], float]:
        """Places, rates and the normal force after one step."""
        model, data = self._model, self._data
        self._mujoco.mj_step1(model, data)
        wanted, forces = np.zeros(len(accelerations)), np.zeros(len(accelerations))
        wanted[self._order] = accelerations
        self._mujoco.mj_mulM(model, data, forces, wanted)
        data.qfrc_applied[:] = forces + data.qfrc_bias
        self._mujoco.mj_step2(model, data)
        return data.qpos[self._order].tolist(), data.qvel[self._order].tolist(), self._normal_force()

    def _normal_force(self) -> float:
        total = 0.0
        for number in range(self._data.ncon):
            wrench = np.zeros(6)
            self._mujoco.mj_contactForce(self._model, self._data, number, wrench)
            total += float(wrench[0])
        return total


def _text(model: PlanarModel, step: float) -> str:
    """The model in MJCF; all bodies have the frame of the world where they stand as they are given."""
    tree, tip = model.tree(), model.tip

    def written(number: int) -> str:
        placed = tree[number]
        inner = "".join(written(i) for i, other in enumerate(tree) if other.above == number)
        if number == tip:
            x, z = model.bodies.point
            inner += _TIP.format(radius=model.radius, x=x, z=z)
        link = placed.link
        return _BODY.format(
            joints=_joints(model, placed), x=link.centre[0], z=link.centre[1], mass=link.mass, inertia=link.inertia,
            inner=inner,
        )  # fmt: skip

    bodies = "".join(written(i) for i, placed in enumerate(tree) if placed.above is None)
    height = model.height - model.radius
    return _TEXT.format(step=step, friction=model.friction, stiff=STIFF * step, height=height, bodies=bodies)


def _joints(model: PlanarModel, placed: Placed) -> str:
    texts = []
    for number in placed.joints:
        joint = model.bodies.joints[number]
        x, z = joint.place
        kind = f'type="hinge" axis="0 {-joint.turn} 0" pos="{x!r} 0 {z!r}"' if joint.is_hinge else (
            f'type="slide" axis="{x!r} 0 {z!r}"'
        )  # fmt: skip
        texts.append(f'<joint name="j{number}" {kind} armature="{joint.armature!r}"/>')
    return "".join(texts)
