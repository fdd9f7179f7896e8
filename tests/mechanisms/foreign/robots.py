"""A two-link arm in URDF and in MJCF, and as textbooks write it, with the second angle counted from the first link.

Spong, Hutchinson, Vidyasagar, Robot Modeling and Control, Sec. 7.4, "planar elbow manipulator": d11 = m1 lc1^2 +
m2 (l1^2 + lc2^2 + 2 l1 lc2 cos q2) + I1 + I2, d12 = m2 (lc2^2 + l1 lc2 cos q2) + I2, d22 = m2 lc2^2 + I2,
h = -m2 l1 lc2 sin q2, C q' = (h (2 q1' q2' + q2'^2), -h q1'^2), phi_1 = (m1 lc1 + m2 l1) g cos q1 +
m2 lc2 g cos(q1 + q2), phi_2 = m2 lc2 g cos(q1 + q2).
"""

from __future__ import annotations

from typing import Any

from gspot_verified import from_mjcf, from_urdf
from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism

TIP: dict[str, Any] = {"contact_point": ("1.5", 0, 0), "height": "-3/2", "mu": 2}

URDF = """<?xml version="1.0"?>
<robot name="arm">
  <material name="grey"/>
  <link name="base"><visual><geometry><mesh filename="package://base.stl"/></geometry></visual></link>
  <link name="upper">
    <inertial><origin xyz="0.5 0 0"/><mass value="2"/>
      <inertia ixx="0" iyy="0.2" izz="9" ixy="0" ixz="0" iyz="0"/></inertial>
  </link>
  <link name="lower">
    <inertial><origin xyz="0.75 0 0"/><mass value="1"/>
      <inertia ixx="0" iyy="0.3" izz="9" ixy="0" ixz="0" iyz="0"/></inertial>
  </link>
  <joint name="shoulder" type="revolute">
    <parent link="base"/><child link="upper"/><axis xyz="0 -1 0"/><limit lower="-3" upper="3" effort="9" velocity="9"/>
  </joint>
  <joint name="elbow" type="continuous">
    <parent link="upper"/><child link="lower"/><origin xyz="1 0 0"/><axis xyz="0 -1 0"/>
  </joint>
</robot>
"""

MJCF = """<mujoco model="arm">
  <compiler angle="radian"/>
  <worldbody>
    <geom type="plane" size="1 1 1"/>
    <body name="upper">
      <joint name="shoulder" axis="0 -1 0" range="-3 3"/>
      <inertial pos="0.5 0 0" mass="2" diaginertia="0 0.2 9"/>
      <geom type="capsule" size="0.1 0.2"/>
      <body name="lower" pos="1 0 0">
        <joint name="elbow" axis="0 -1 0"/>
        <inertial pos="0.75 0 0" mass="1" diaginertia="0 0.3 9"/>
      </body>
    </body>
  </worldbody>
</mujoco>
"""


def urdf_arm(text: str = URDF, **options: Any) -> Mechanism:
    return from_urdf(text, **{"contact_link": "lower"} | TIP | options)


def mjcf_arm(text: str = MJCF, **options: Any) -> Mechanism:
    return from_mjcf(text, **{"contact_body": "lower"} | TIP | options)


def by_textbook(**values: Any) -> Mechanism:
    d12, h = "m2*(lc2^2 + l1*lc2*cos(q2)) + I2", "m2*l1*lc2*sin(q2)"
    given = {"m1": 2, "m2": 1, "l1": 1, "l2": "3/2", "lc1": "1/2", "lc2": "3/4", "I1": "1/5", "I2": "3/10", "g": "9.81"}
    return lagrangian(
        "arm",
        ["q1", "q2"],
        [["m1*lc1^2 + m2*(l1^2 + lc2^2 + 2*l1*lc2*cos(q2)) + I1 + I2", d12], [d12, "m2*lc2^2 + I2"]],
        [f"{h}*(2*q1_dot*q2_dot + q2_dot^2) - (m1*lc1 + m2*l1)*g*cos(q1) - m2*lc2*g*cos(q1 + q2)",
         f"-{h}*q1_dot^2 - m2*lc2*g*cos(q1 + q2)"],
        "l1*cos(q1) + l2*cos(q1 + q2)", "l1*sin(q1) + l2*sin(q1 + q2) + 3/2", 2, given | values,
    )  # fmt: skip
