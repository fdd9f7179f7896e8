"""Models of MuJoCo: the mechanism that textbooks write, MuJoCo's own numbers, and what cannot be taken is named."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from flint import arb, fmpq
from mechanisms.foreign.robots import MJCF, by_textbook, mjcf_arm, urdf_arm
from mechanisms.foreign.same import same

from gspot_verified import from_mjcf
from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.mechanisms.derive.to_system import Preparation
from gspot_verified.mechanisms.input.given import from_energies
from gspot_verified.mechanisms.input.mechanism import Lagrangian, Mechanism, MechanismError
from gspot_verified.numbers.balls import working_bits

HERE = Path(__file__).parent
HINGE = '<joint name="elbow" axis="0 -1 0"/>'
BODY = '<body name="lower" pos="1 0 0">'


def changed(*changes: tuple[str, str]) -> str:
    text = MJCF
    for old, new in changes:
        assert text.count(old) >= 1
        text = text.replace(old, new)
    return text


def test_the_arm_is_that_of_the_textbook_and_of_urdf() -> None:
    found = mjcf_arm()
    assert found.state == ("shoulder", "elbow", "shoulder_dot", "elbow_dot")
    assert sorted(name for name, _ in found.parameters) == ["g", "height", "mu"]
    assert same(found, by_textbook())
    assert same(found, urdf_arm())
    assert found.notes[0].startswith("planar projection")
    assert found.notes[1:] == ("limits of joints are not part of the mechanism",)


RECORD = json.loads((HERE / "walker.json").read_text("utf-8"))


@pytest.fixture(scope="module")
def walker() -> Mechanism:
    return from_mjcf(HERE / "walker.xml", contact_body="shin", contact_point=("0.02", 0, "-0.4"), mu=1)


@pytest.mark.parametrize("number", range(len(RECORD["states"])))
def test_mujoco_has_the_same_mass_matrix_forces_and_contact_point(walker: Mechanism, number: int) -> None:
    """Recorded from MuJoCo 4.0.0: mj_fullM, qfrc_passive - qfrc_bias, xpos + xmat of the tip; to 1e-12.

    The model has a slide and a hinge that count from ref, springs with springref, dampers, armatures, defaults, a
    body turned by euler and by quat, inertias about other axes, products of inertia, and two legs.
    """
    record = RECORD["states"][number]
    assert list(walker.state[:7]) == RECORD["joints"]
    motion = walker.motion
    assert isinstance(motion, Lagrangian)
    assert walker.x is not None
    entries = [entry for row in motion.mass_matrix for entry in row]
    expected = [value for row in record["mass_matrix"] for value in row] + record["forces"]
    expected += [record["tip"][0], record["tip"][2]]
    with working_bits(100):
        functions = Preparation(walker)([*entries, *motion.forces, walker.x, walker.y])
        program = BoxProgram(_with_pi(functions), 14)
        values = program.values([arb(fmpq(count, 8)) for count in record["eighths"]])
        assert len(values) == len(expected) == 49 + 7 + 2
        for value, number_there in zip(values, expected, strict=True):
            assert abs(value - arb(number_there)) < arb("1e-12") * (1 + abs(value))


def _with_pi(functions: list[Any]) -> list[Any]:
    from gspot_verified.functions.expressions import Constant
    from gspot_verified.mechanisms.formulas.rewriting import replaced
    from gspot_verified.mechanisms.formulas.symbol import PI, Symbol

    return replaced(functions, {Symbol(PI): Constant(arb.pi())})


@pytest.mark.parametrize(
    "frame", ['euler="1.5708 0 0"', 'quat="1 1 0 0"', 'quat="0.5 0.5 0 0"']
)  # the elbow's frame about x: its y is the old z
def test_a_frame_that_is_turned_by_right_angles_changes_nothing(frame: str) -> None:
    turned = changed((BODY, BODY.replace(">", f" {frame}>")), (HINGE, '<joint name="elbow" axis="0 0 3"/>'),
                     ("0 0.3 9", "0 9 0.3"))  # fmt: skip
    found = mjcf_arm(turned)
    assert same(found, by_textbook())
    assert ("angles: 1.5708 is pi/2" in found.notes) == frame.startswith("euler")


def test_a_slide_is_as_long_as_its_coordinate() -> None:
    slide = changed((HINGE, '<joint name="reach" type="slide" axis="3 0 0"/>'))
    by_hand = from_energies(
        "polar", ["q", "r"],
        "(7/10 + 3/10)/2*q_dot^2 + (r_dot^2 + (7/4 + r)^2*q_dot^2)/2", "9.81*(2*1/2 + 7/4 + r)*sin(q)",
        "(5/2 + r)*cos(q)", "(5/2 + r)*sin(q) + 3/2", 2,
    )  # fmt: skip
    assert same(mjcf_arm(slide), by_hand)


def test_angles_in_degrees_are_exact() -> None:
    turned = changed((BODY, BODY.replace(">", ' euler="0 30 0">')), ('<compiler angle="radian"/>', ""))
    shifted = from_energies(
        "arm", ["q1", "q2"],
        "q1_dot^2*(2*1/4 + 1/5)/2 + 3/20*(q1_dot + q2_dot)^2 + (q1_dot^2 + 9/16*(q1_dot + q2_dot)^2 "
        "+ 3/2*cos(q2 - pi/6)*q1_dot*(q1_dot + q2_dot))/2",
        "g*(2*sin(q1) + 3/4*sin(q1 + q2 - pi/6))",
        "cos(q1) + 3/2*cos(q1 + q2 - pi/6)", "sin(q1) + 3/2*sin(q1 + q2 - pi/6) + 3/2", 2, {"g": "9.81"},
    )  # fmt: skip
    assert same(mjcf_arm(turned), shifted)


@pytest.mark.parametrize(("sequence", "angles"), [("xyz", "90 0 90"), ("XYZ", "90 90 0")])
def test_axes_of_euler_move_or_stay(sequence: str, angles: str) -> None:
    """Both turn x to z, y to x, z to y: about x then the new z, and about x then the old y... of the file's frame."""
    import sympy

    from gspot_verified.mechanisms.foreign.rotations import about, by_euler

    quarters = [sympy.pi * int(word) / 180 for word in angles.split()]
    first, second, third = (about(letter.lower(), q) for letter, q in zip(sequence, quarters, strict=True))
    expected = first * second * third if sequence.islower() else third * second * first
    assert by_euler(quarters, sequence) == expected


def test_gravity_of_the_model() -> None:
    slanted = changed(("<worldbody>", '<option gravity="3 0 -4" timestep="0.01"/><worldbody>'))
    found = mjcf_arm(slanted)
    assert [name for name, _ in found.parameters] == ["height", "mu"]
    by_hand = from_energies(
        "arm", ["q1", "q2"],
        "q1_dot^2*(2*1/4 + 1/5)/2 + 3/20*(q1_dot + q2_dot)^2 + (q1_dot^2 + 9/16*(q1_dot + q2_dot)^2 "
        "+ 3/2*cos(q2)*q1_dot*(q1_dot + q2_dot))/2",
        "4*(2*sin(q1) + 3/4*sin(q1 + q2)) - 3*(2*cos(q1) + 3/4*cos(q1 + q2))",
        "cos(q1) + 3/2*cos(q1 + q2)", "sin(q1) + 3/2*sin(q1 + q2) + 3/2", 2,
    )  # fmt: skip
    assert same(found, by_hand)
    assert same(mjcf_arm(changed(("<worldbody>", '<option gravity="0 0 -5"/><worldbody>'))), by_textbook(g=5))


@pytest.mark.parametrize(
    ("split", "one"),
    [
        (
            '<compiler angle="radian"/><compiler autolimits="true"/>',
            '<compiler angle="radian" autolimits="true"/>',
        ),
        ('<option gravity="0 0 -5"/><option timestep="0.01"/>', '<option gravity="0 0 -5" timestep="0.01"/>'),
        ('<option gravity="0 0 -5"/><option gravity="3 0 -4"/>', '<option gravity="3 0 -4"/>'),
        (
            '<default><joint damping="3"/></default><default><geom rgba="1 1 1 1"/></default>',
            '<default><joint damping="3"/></default>',
        ),
        (
            '<default class="main"><joint damping="3" armature="1"/></default><default><joint damping="2"/></default>',
            '<default><joint damping="2" armature="1"/></default>',
        ),
    ],
)
def test_sections_that_stand_twice_are_merged(split: str, one: str) -> None:
    """MuJoCo's XML reference: repeated sections are merged; an attribute that the later one lacks stays."""
    start, turned = '<compiler angle="radian"/>', (BODY, BODY.replace(">", ' euler="0 0.5 0">'))
    keep = "" if split.startswith("<compiler") else start
    assert same(mjcf_arm(changed(turned, (start, keep + split))), mjcf_arm(changed(turned, (start, keep + one))))


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            "<worldbody>",
            '<default><default class="leg"/><default class="leg"/></default><worldbody>',
            "two default classes are called 'leg'",
        ),
        ("<worldbody>", '<compiler Angle="radian"/><worldbody>', "'Angle' is not known; did you mean 'angle'"),
        ("<worldbody>", '<option Gravity="0 0 -1"/><worldbody>', "'Gravity' is not known; did you mean 'gravity'"),
        ("<worldbody>", '<option><flag gravty="disable"/></option><worldbody>', "'gravty' is not known; did you mean"),
        ("<worldbody>", '<default damping="1"/><worldbody>', "'damping' is not known"),
        ("<worldbody>", '<default><jiont damping="1"/></default><worldbody>', "'jiont' is not known; did you mean"),
        (
            "<worldbody>",
            '<default><default class="leg"><joint dampng="1"/></default></default><worldbody>',
            "'dampng' is not known; did you mean",
        ),
        ("<worldbody>", '<worldbody euler="0 90 0">', "'euler' is not known"),
        ("<mujoco ", '<mujoco angle="radian" ', "'angle' is not known"),
        (HINGE, "<freejoint/>", "body 'lower': the element 'freejoint' moves in space"),
        (HINGE, '<joint name="elbow" type="free"/>', "type 'free': joints are hinge or slide"),
        (HINGE, '<joint name="elbow" type="ball"/>', "type 'ball'"),
        (HINGE, '<joint name="elbow"/>', r"joint 'elbow' turns about \(0, 0, 1\).*parallel"),
        (HINGE, '<joint name="elbow" axis="0 0 0"/>', "the axis must not be 0"),
        (HINGE, '<joint name="elbow" axis="0 -1 0" frictionloss="0.1"/>', "frictionloss is not taken"),
        (HINGE, '<joint name="elbow" axis="0 -1 0" springdamper="0 1"/>', "springdamper is not taken"),
        (HINGE, '<joint name="elbow" axis="0 -1 0" stiffness="1 2"/>', "stiffness: 1 numbers are needed, got 2"),
        (HINGE, '<joint name="elbow" axis="0 -1 0" stifness="1"/>', "'stifness' is not known; did you mean"),
        (HINGE, '<joint name="shoulder" axis="0 -1 0"/>', "two joints have this name"),
        (HINGE, '<joint name="elbow" axis="0 -1 0" class="leg"/>', "there is no default class 'leg'"),
        (
            '<inertial pos="0.75 0 0" mass="1" diaginertia="0 0.3 9"/>',
            '<geom size="1"/>',
            "masses that come from geoms",
        ),
        ('mass="1"', 'mass="-1"', "a mass must not be negative"),
        ('mass="1"', "", "attribute 'mass' is missing"),
        (BODY, BODY.replace(">", ' mocap="true">'), "a mocap body"),
        (BODY, BODY.replace(">", ' gravcomp="-1">'), "gravcomp is a force against gravity"),
        (BODY, BODY.replace(">", ' quat="0 0 0 0">'), "quat must not be 0"),
        (BODY, BODY.replace(">", ' quat="1 0 0 0" euler="0 0 0">'), "quat and euler: one of them"),
        (BODY, BODY.replace(">", ' zaxis="0 0 1">'), "zaxis: give the turn as quat or euler"),
        (BODY, BODY.replace("lower", "upper"), "two bodies are called 'upper'"),
        ("</mujoco>", '<actuator><motor joint="elbow"/></actuator></mujoco>', "element 'actuator' brings forces"),
        ("</mujoco>", "<equality><connect/></equality></mujoco>", "element 'equality' closes loops"),
        ("</mujoco>", "<tendon/></mujoco>", "element 'tendon' may bring springs"),
        ("</mujoco>", '<include file="a.xml"/></mujoco>', "element 'include' names another file"),
        ("</mujoco>", "<worldbody/></mujoco>", "one worldbody is needed, found 2"),
        ('angle="radian"', 'angle="grad"', "must be degree or radian"),
        ('angle="radian"', 'eulerseq="xy"', "eulerseq 'xy' must be three"),
        ('angle="radian"', 'coordinate="global"', "coordinates must be local"),
        ('angle="radian"', 'inertiafromgeom="true"', "masses that come from geoms"),
        ('angle="radian"', 'balanceinertia="true"', "balanceinertia changes inertias"),
        ('angle="radian"', 'settotalmass="3"', "settotalmass changes masses"),
        ("<worldbody>", '<option density="1"/><worldbody>', "density is a force of a fluid"),
        ("<worldbody>", '<option><flag gravity="disable"/></option><worldbody>', "gravity is switched off"),
    ],
)
def test_what_cannot_be_taken_is_named(old: str, new: str, message: str) -> None:
    with pytest.raises(MechanismError, match=message):
        mjcf_arm(changed((old, new)))


def test_what_is_left_out_on_purpose_is_said() -> None:
    text = changed(("</mujoco>", "<actuator/></mujoco>"), (HINGE, HINGE.replace("/>", ' frictionloss="1"/>')))
    found = mjcf_arm(text, without=("actuator", "frictionloss"))
    assert found.notes[-1] == "left out on purpose: actuator, frictionloss"
    assert same(found, by_textbook())


def test_names_are_made_where_the_model_has_none() -> None:
    found = mjcf_arm(changed((' name="elbow"', ""), ('name="lower" ', "")), contact_body="body2")
    assert found.state[:2] == ("shoulder", "joint2")
    assert same(found, by_textbook())
