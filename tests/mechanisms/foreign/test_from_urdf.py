"""Robots in URDF: the mechanism that textbooks write, and what cannot be taken is named."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from mechanisms.foreign.robots import URDF, by_textbook, urdf_arm
from mechanisms.foreign.same import same

from gspot_verified import find_g_spots, from_urdf
from gspot_verified.mechanisms.input.given import from_energies
from gspot_verified.mechanisms.input.mechanism import MechanismError

ELBOW = '<origin xyz="1 0 0"/><axis xyz="0 -1 0"/>'
SHOULDER = '<axis xyz="0 -1 0"/><limit lower="-3" upper="3" effort="9" velocity="9"/>'


def changed(*changes: tuple[str, str]) -> str:
    text = URDF
    for old, new in changes:
        assert text.count(old) >= 1
        text = text.replace(old, new)
    return text


def test_the_arm_is_that_of_the_textbook(tmp_path: Path) -> None:
    found = urdf_arm()
    assert found.state == ("shoulder", "elbow", "shoulder_dot", "elbow_dot")
    assert [name for name, _ in found.parameters] == ["g", "height", "mu"]
    assert same(found, by_textbook())
    assert not same(found, by_textbook(I1="1/4"))
    file = tmp_path / "arm.urdf"
    file.write_text(URDF, encoding="utf-8")
    assert from_urdf(file, contact_link="lower", contact_point=("1.5", 0, 0), height="-3/2", mu=2) == found


def test_the_projection_is_said_aloud() -> None:
    notes = urdf_arm().notes
    assert notes[0].startswith("planar projection: the plane of x (tangential) and z (normal) of the world")
    assert notes[1:] == ("the root link base is fixed", "limits of joints are not part of the mechanism")


def test_what_lies_along_the_hinges_has_no_effect() -> None:
    aside = changed(('<origin xyz="0.75 0 0"/>', '<origin xyz="0.75 0.3 0"/>'), ('xyz="1 0 0"', 'xyz="1 -2 0"'),
                    ('ixy="0" ixz="0" iyz="0"', 'ixy="0.1" ixz="0.2" iyz="0.3"'))  # fmt: skip
    assert same(urdf_arm(aside), by_textbook())


@pytest.mark.parametrize("quarter", ["1.57", "1.5708", "1.5707", "1.5707963267948966"])
def test_a_frame_that_is_turned_by_right_angles_changes_nothing(quarter: str) -> None:
    """The elbow's frame about x: its y is the old z, so the axis is written as z there."""
    turned = changed(
        (ELBOW, f'<origin xyz="1 0 0" rpy="{quarter} 0 0"/><axis xyz="0 0 5"/>'),
        ('iyy="0.3" izz="9"', 'iyy="9" izz="0.3"'),
    )
    found = urdf_arm(turned)
    assert same(found, by_textbook())
    assert f"angles: {quarter} is pi/2" in found.notes


def test_frames_turn_one_after_the_other() -> None:
    """The first frame is turned about z, the second one back: x and the axis -y of the world are written so there."""
    turned = changed(
        (SHOULDER, '<origin rpy="0 0 1.5708"/><axis xyz="-1 0 0"/>'),
        ('<origin xyz="0.5 0 0"/>', '<origin xyz="0 -0.5 0"/>'),
        ('ixx="0" iyy="0.2" izz="9"', 'ixx="0.2" iyy="0" izz="9"'),
        (ELBOW, '<origin xyz="0 -1 0" rpy="0 0 -1.5708"/><axis xyz="0 -1 0"/>'),
    )
    assert same(urdf_arm(turned), by_textbook())


def test_an_axis_that_is_not_given_is_x() -> None:
    """The arm in the plane of y and z; the hinges about x turn y to z."""
    aside = changed((SHOULDER, ""), (ELBOW, '<origin xyz="0 1 0"/>'), ('xyz="0.5 0 0"', 'xyz="0 0.5 0"'),
                    ('xyz="0.75 0 0"', 'xyz="0 0.75 0"'), ('ixx="0" iyy="0.2"', 'ixx="0.2" iyy="0"'),
                    ('ixx="0" iyy="0.3"', 'ixx="0.3" iyy="0"'))  # fmt: skip
    assert same(urdf_arm(aside, tangent="y", contact_point=(0, "1.5", 0)), by_textbook())


def test_a_turn_in_the_plane_shifts_the_angle() -> None:
    """rpy about y is the other way round than the hinge about -y."""
    found = urdf_arm(changed((ELBOW, '<origin xyz="1 0 0" rpy="0 0.3 0"/><axis xyz="0 -1 0"/>')))
    shifted = from_energies(
        "arm", ["q1", "q2"],
        "q1_dot^2*(2*1/4 + 1/5)/2 + 3/20*(q1_dot + q2_dot)^2 + (q1_dot^2 + 9/16*(q1_dot + q2_dot)^2 "
        "+ 3/2*cos(q2 - 3/10)*q1_dot*(q1_dot + q2_dot))/2",
        "g*(2*sin(q1) + 3/4*sin(q1 + q2 - 3/10))",
        "cos(q1) + 3/2*cos(q1 + q2 - 3/10)", "sin(q1) + 3/2*sin(q1 + q2 - 3/10) + 3/2", 2, {"g": "9.81"},
    )  # fmt: skip
    assert same(found, shifted)


def test_a_slide_makes_a_polar_arm_and_a_damper_takes_energy() -> None:
    text = changed(
        ('name="elbow" type="continuous"', 'name="reach" type="prismatic"'),
        (ELBOW, '<origin xyz="1 0 0"/><axis xyz="3 0 0"/><dynamics damping="0.5"/>'),
    )
    found = urdf_arm(text, gravity="10")
    by_hand = from_energies(
        "polar", ["q", "r"],
        "(7/10 + 3/10)/2*q_dot^2 + (r_dot^2 + (7/4 + r)^2*q_dot^2)/2", "10*(2*1/2 + 7/4 + r)*sin(q)",
        "(5/2 + r)*cos(q)", "(5/2 + r)*sin(q) + 3/2", 2, dissipation="r_dot^2/4",
    )  # fmt: skip
    assert same(found, by_hand)


def test_another_link_behind_the_same_joint_counts_too() -> None:
    tool = """<link name="tool"><inertial><mass value="3"/>
      <inertia ixx="0" iyy="0" izz="0" ixy="0" ixz="0" iyz="0"/></inertial></link>
      <joint name="weld" type="fixed"><parent link="upper"/><child link="tool"/><origin xyz="0.5 0 0"/></joint>
      </robot>"""
    found = urdf_arm(changed(("</robot>", tool)))
    assert same(found, by_textbook(m1=5))


def test_gravity_across_the_plane_has_no_effect() -> None:
    flat = changed(
        ("0 -1 0", "0 0 1"), ('iyy="0.2" izz="9"', 'iyy="9" izz="0.2"'), ('iyy="0.3" izz="9"', 'iyy="9" izz="0.3"')
    )
    assert same(urdf_arm(flat, normal="y"), by_textbook(g=0))


def test_axes_of_the_plane_may_be_mirrored() -> None:
    """x seen from behind: the hinge about -y turns the other way, and x counts the other way."""
    found, plain = urdf_arm(tangent="-x"), urdf_arm()
    assert same(found.with_parameters(g=0), urdf_arm(slip="negative").with_parameters(g=0)) is True
    assert found.x != plain.x


def test_joints_have_names_that_scenes_can_use() -> None:
    found = urdf_arm(changed(('"shoulder"', '"y"'), ('"elbow"', '"mu"')), place={"y": "1/2", "mu_dot": 1}, fixed=["y"])
    assert found.state[:2] == ("q_y", "mu_")
    assert "renamed: y is q_y, mu is mu_ here" in found.notes
    assert [name for name, _ in found.place.values] == ["q_y", "mu__dot"]
    assert found.place.fixed == ("q_y",)


def test_it_can_be_asked_for_its_g_spots() -> None:
    found = find_g_spots(urdf_arm(mu="1/4"))
    assert found.verdict.outcome.name == "REFUTED"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('type="continuous"', 'type="floating"', "joint 'elbow': type 'floating': joints are revolute"),
        ('type="continuous"', 'type="planar"', "type 'planar'"),
        ('<axis xyz="0 -1 0"/>', '<axis xyz="1 0 0"/>', r"joint 'shoulder' turns about \(1, 0, 0\).*parallel"),
        ('<axis xyz="0 -1 0"/>', '<axis xyz="0 -1 0.001"/>', "this robot is not planar"),
        ('<axis xyz="0 -1 0"/>', '<axis xyz="0 0 0"/>', "the axis must not be 0"),
        ('<axis xyz="0 -1 0"/>', '<axis xyz="0 1"/>', "xyz: 3 numbers are needed, got 2"),
        (ELBOW, ELBOW + '<mimic joint="shoulder"/>', "element 'mimic' makes one joint follow another"),
        (ELBOW, ELBOW + '<dynamics friction="0.1"/>', "dry friction of a joint is not taken"),
        (ELBOW, ELBOW + '<dynamics stiffness="0.1"/>', "attribute 'stiffness' is not known"),
        ('xyz="1 0 0"', 'quat_xyzw="0 0 0 1" xyz="1 0 0"', "origin: the attribute 'quat_xyzw' is not known"),
        ('<mass value="2"/>', '<mass value="2" unit="g"/>', "attribute 'unit' is not known"),
        ('iyy="0.2" ', 'iyy="0.2" iyx="0" ', "attribute 'iyx' is not known"),
        ('<axis xyz="0 -1 0"/>', '<axis xyz="0 -1 0" frame="base"/>', "attribute 'frame' is not known"),
        ('<child link="lower"/>', '<child link="lower" joint="a"/>', "attribute 'joint' is not known"),
        ('type="continuous"', 'type="continuous" damping="1"', "joint 'elbow': the attribute 'damping' is not known"),
        (ELBOW, ELBOW + '<limit uper="1"/>', "limit: the attribute 'uper' is not known; did you mean 'upper'"),
        ('<link name="base">', '<link name="base" mass="1">', "link 'base': the attribute 'mass' is not known"),
        ("<inertial>", '<inertial mass="2">', "inertial: the attribute 'mass' is not known"),
        ("<robot ", '<robot gravity="1" ', "the attribute 'gravity' is not known"),
        ("</robot>", "<gazebo/></robot>", r"element 'gazebo' is for a simulator.*without=\('gazebo',\)"),
        ("</robot>", "<lnik/></robot>", "element 'lnik' is not known; did you mean 'link'"),
        ('<parent link="base"/>', '<parent link="bass"/>', "there is no link 'bass'"),
        ('<parent link="base"/>', "", "element 'parent' is missing"),
        ('<parent link="base"/>', '<parent link="lower"/>', "hang on one another: closed loops are not taken"),
        ('<child link="lower"/>', '<child link="upper"/>', "'upper' hangs on two joints: closed loops"),
        ('<link name="base">', '<link name="spare"/><link name="base">', "one root link is needed, found 2"),
        ('name="elbow"', 'name="shoulder"', "two joints have this name"),
        ('<link name="base">', '<link name="upper"/><link name="base">', "two links have one name"),
        ('<mass value="2"/>', "", "'mass' and 'inertia' are needed"),
        ('<mass value="2"/>', '<mass value="-2"/>', "a mass must not be negative"),
        ('<mass value="2"/>', '<mass value="nan"/>', "'nan' is no decimal number"),
        ('<mass value="2"/>', '<mass value="1e999999999"/>', "no decimal number of usual size"),
        ('<mass value="2"/>', '<mass value="0x10"/>', "'0x10' is no decimal number"),
        ('<mass value="2"/>', "<mass/>", "attribute 'value' is missing"),
        ('iyy="0.2" ', "", "attribute 'iyy' is missing"),
        ('ixz="0" ', "", "attribute 'ixz' is missing"),
        ('<?xml version="1.0"?>', '<!DOCTYPE robot [<!ENTITY a "b">]>', "a document type or entities are not read"),
        ("</robot>", "", "no XML"),
        ('<link name="base">', "<link>", "attribute 'name' is missing"),
    ],
)
def test_what_cannot_be_taken_is_named(old: str, new: str, message: str) -> None:
    with pytest.raises(MechanismError, match=message):
        urdf_arm(changed((old, new)))


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"contact_link": "hand"}, "no body 'hand'; there are: base, upper, lower"),
        ({"contact_point": (1, 0)}, "contact_point: three numbers"),
        ({"contact_point": "100"}, "contact_point: three numbers"),
        ({"contact_point": (0.5, 0, 0)}, "a float is not taken as exact"),
        ({"normal": "up"}, "normal must be x, y, z"),
        ({"normal": "x"}, "must be different axes"),
        ({"normal": "y"}, "must be parallel"),
        ({"mu": -1}, "must not be negative"),
        ({"slip": "both"}, "slip must be"),
        ({"place": {"knee": 1}}, "no component of the state"),
    ],
)
def test_bad_options_are_named(options: dict[str, Any], message: str) -> None:
    with pytest.raises(MechanismError, match=message):
        urdf_arm(**options)


def test_what_is_left_out_on_purpose_is_said() -> None:
    text = changed(("</robot>", "<gazebo/></robot>"), (ELBOW, ELBOW + '<dynamics friction="0.1"/>'))
    found = urdf_arm(text, without=("gazebo", "friction"))
    assert found.notes[-1] == "left out on purpose: friction, gazebo"
    assert same(found, by_textbook())


def test_files_that_are_none(tmp_path: Path) -> None:
    with pytest.raises(MechanismError, match="cannot be read"):
        from_urdf(tmp_path / "none.urdf", contact_link="a", mu=1)
    deep = "<robot>" + "<link name='a'>" * 80 + "</link>" * 80 + "</robot>"
    with pytest.raises(MechanismError, match="deeper than"):
        from_urdf(deep, contact_link="a", mu=1)
    with pytest.raises(MechanismError, match="the root must be <robot>, got <mujoco>"):
        from_urdf("<mujoco/>", contact_link="a", mu=1)
    binary = tmp_path / "binary.urdf"
    binary.write_bytes(b"\xff\xfe\x00")
    with pytest.raises(MechanismError, match="not UTF-8"):
        from_urdf(binary, contact_link="a", mu=1)
