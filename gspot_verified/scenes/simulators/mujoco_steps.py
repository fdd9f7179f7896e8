"""A mechanism that is one rigid body in MuJoCo, where that is installed: https://mujoco.readthedocs.io.

MuJoCo's contact is soft and its friction cone convex: a contact that slips is also pushed apart. So it is another model
than that of the paper, whose side it need not take.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from gspot_verified.scenes.simulators.planar_body import PlanarBody
from gspot_verified.scenes.simulators.simulated import Simulated

_RADIUS = 1e-4  # of the sphere that touches, over the arm at whose end its middle is
STIFF = 10  # the time constant of the contact in steps; MuJoCo asks for 2 or more
_MODEL = """<mujoco>
<option timestep="{step!r}" gravity="0 0 0" cone="elliptic" iterations="200" tolerance="1e-14"/>
<default><geom condim="3" friction="{friction!r} 0 0" solref="{stiff!r} 1"/></default>
<worldbody><geom type="plane" size="50 50 1"/><body pos="{x!r} 0 {z!r}">
<joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 0 1"/><joint type="hinge" axis="0 -1 0"/>
<inertial pos="0 0 0" mass="{mass!r}" diaginertia="{inertia!r} {inertia!r} {inertia!r}"/>
<geom type="sphere" size="{radius!r}" pos="{arm_x!r} 0 {arm_z!r}" mass="0"/></body></worldbody></mujoco>"""


def mujoco_version() -> str | None:
    """That of the installed MuJoCo, or None."""
    try:
        import mujoco
    except ImportError:
        return None
    return str(mujoco.__version__)


def mujoco_steps(body: PlanarBody, *, step: float, until: float) -> Simulated:
    """The motion from the start of the body, with the gap that it has there (0 in contact)."""
    import mujoco

    height, radius = body.functions.contact(body.start).y, _RADIUS * math.hypot(*body.arm)
    model = mujoco.MjModel.from_xml_string(
        _MODEL.format(
            step=step, stiff=STIFF * step, friction=body.friction, mass=body.mass, inertia=body.inertia,
            radius=radius, x=-body.arm[0], z=height + radius - body.arm[1], arm_x=body.arm[0], arm_z=body.arm[1],
        )
    )  # fmt: skip
    data = mujoco.MjData(model)
    data.qvel[:] = body.rates(body.start)
    times, states, forces = [0.0], [list(body.start)], [1.0]
    while times[-1] < until:
        data.qfrc_applied[:] = body.forces(states[-1])
        mujoco.mj_step(model, data)
        times.append(float(data.time))
        states.append(body.state([float(way) for way in data.qpos], [float(rate) for rate in data.qvel]))
        forces.append(_normal_force(mujoco, model, data))
    return Simulated(times, states, forces)


def _normal_force(mujoco: Any, model: Any, data: Any) -> float:
    total = 0.0
    for i in range(data.ncon):
        wrench = np.zeros(6)
        mujoco.mj_contactForce(model, data, i, wrench)
        total += float(wrench[0])
    return total
