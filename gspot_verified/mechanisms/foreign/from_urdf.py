"""A mechanism from a robot in URDF (Unified Robot Description Format): https://wiki.ros.org/urdf/XML.

Of a link count <inertial>; of a joint its type, origin, axis and damping. The parser is that of the standard library.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from gspot_verified.mechanisms.foreign.names import mechanism_name
from gspot_verified.mechanisms.foreign.planar_tree import Body, Joint, PlanarContact, planar_mechanism
from gspot_verified.mechanisms.foreign.rotations import by_roll_pitch_yaw, right_angle
from gspot_verified.mechanisms.foreign.xml_element import XmlElement, xml_root
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.numbers.balls import ExactInput

_REASONS = {
    "transmission": "says how a motor drives a joint: nothing of it is taken",
    "gazebo": "is for a simulator, and may hold springs and friction: nothing of it is taken",
    "ros2_control": "says how motors are driven: nothing of it is taken",
    "mimic": "makes one joint follow another: no coupled joints are taken",
}
_MOMENTS = ("xx", "yy", "zz", "xy", "xz", "yz")
_LIMIT = ("lower", "upper", "effort", "velocity", "acceleration", "deceleration", "jerk")
_HINGES, _SLIDES = ("revolute", "continuous"), ("prismatic",)


def from_urdf(
    source: str | Path,
    *,
    contact_link: str,
    mu: ExactInput | None,
    contact_point: Sequence[ExactInput] = (0, 0, 0),
    normal: str = "z",
    tangent: str = "x",
    height: ExactInput | None = 0,
    gravity: ExactInput | None = "9.81",
    slip: str = "positive",
    name: str | None = None,
    without: Sequence[str] = (),
    angles: Mapping[str, tuple[ExactInput, ExactInput]] | None = None,
    place: Mapping[str, Any] | None = None,
    search: bool = False,
    fixed: Sequence[str] | None = None,
    regularisation: Mapping[str, ExactInput] | None = None,
) -> Mechanism:
    """The mechanism that a robot in URDF is in its plane, with one point of one link in contact.

    Carried: links in a tree, revolute, continuous and prismatic joints (all hinges parallel to the normal of the
    plane), masses and inertias, damping of joints. The root link is fixed. Meshes and limits have no effect. Refused,
    by name: floating, planar and mimic joints, closed loops, dry friction of joints, elements and attributes that are
    not known. The notes of the mechanism say how it was projected.

    :param source: a file, or a text that begins with ``<``.
    :param contact_point: in the frame of the link; y, the distance from the surface, is its place along ``normal`` less
        ``height``; x its place along ``tangent``: axes of the root link such as "z" or "-x".
    :param gravity: g, along -z of the root link. It, ``height`` and ``mu`` are the parameters g, height, mu; None
        leaves one a symbol.
    :param without: elements and properties that are left out on purpose: "gazebo", "friction".
    :param place: values of components at the G-spot, as the table "g_spot.point" of a mechanism's file; ``search``,
        ``fixed``, ``angles`` and ``regularisation`` likewise.
    :raises MechanismError: something cannot be read or taken; the message names it.

    >>> from gspot_verified import from_urdf
    >>> text = '''<robot name="arm"><link name="base"/>
    ...   <link name="bar"><inertial><origin xyz="0.5 0 0"/><mass value="2"/>
    ...     <inertia ixx="0" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial></link>
    ...   <joint name="hip" type="revolute"><parent link="base"/><child link="bar"/><axis xyz="0 -1 0"/></joint>
    ... </robot>'''
    >>> arm = from_urdf(text, contact_link="bar", contact_point=(1, 0, 0), height="-1/2", mu="1/2")
    >>> arm.state, len(arm.notes)
    (('hip', 'hip_dot'), 2)
    """
    import sympy

    root = xml_root(source, "robot", without)
    title = mechanism_name(name if name is not None else root.text("name", "robot")[:80])
    reader = _Robot(root, without)
    bodies = reader.bodies()
    contact = PlanarContact(contact_link, contact_point, mu, height, normal, tangent, slip)
    options = {"angles": angles, "place": place, "search": search, "fixed": fixed, "regularisation": regularisation}
    down = sympy.ImmutableMatrix([0, 0, -sympy.Symbol("g")])
    return planar_mechanism(title, bodies, contact, down, {"g": gravity}, options, reader.remarks())


class _Robot:
    """The links and joints of a file."""

    def __init__(self, root: XmlElement, without: Sequence[str]) -> None:
        root.only(("link", "joint"), ("material",), _REASONS)
        root.only_attributes(("name", "version"))
        self._root, self._without = root, without
        self._links = {link.text("name"): link for link in root.children("link")}
        if len(self._links) != len(list(root.children("link"))):
            raise root.refuse("two links have one name")
        self._above: dict[str, XmlElement] = {}
        self._below: dict[str, list[str]] = {}
        names: set[str] = set()
        for joint in root.children("joint"):
            child = self._end(joint, "child")
            parent = self._end(joint, "parent")
            if child in self._above:
                raise joint.refuse(f"link {child!r} hangs on two joints: closed loops are not taken")
            if joint.text("name") in names:
                raise joint.refuse("two joints have this name")
            names.add(joint.text("name"))
            self._above[child] = joint
            self._below.setdefault(parent, []).append(child)
        self._read_as: list[str] = []
        self._limited = False

    def _end(self, joint: XmlElement, tag: str) -> str:
        end = joint.one(tag)
        if end is None:
            raise joint.refuse(f"the element {tag!r} is missing")
        end.only_attributes(("link",))
        link = end.text("link")
        if link not in self._links:
            raise end.refuse(f"there is no link {link[:60]!r}")
        return link

    def bodies(self) -> list[Body]:
        """All links, the root first.

        :raises MechanismError: something cannot be taken.
        """
        import sympy

        roots = [name for name in self._links if name not in self._above]
        if len(roots) != 1:
            raise self._root.refuse(f"one root link is needed, found {len(roots)}: {', '.join(roots[:5]) or 'a loop'}")
        self._fixed = roots[0]
        made: list[Body] = []
        waiting: list[tuple[str, Any, Any, tuple[Joint, ...]]] = [
            (roots[0], sympy.ImmutableMatrix(sympy.eye(3)), sympy.ImmutableMatrix([0, 0, 0]), ())
        ]
        while waiting:
            link, turn, origin, joints = waiting.pop(0)
            made.append(self._body(link, turn, origin, joints))
            behind = []
            for child in self._below.get(link, ()):
                joint = self._above[child]
                place, own_turn = self._origin(joint)
                there, frame = origin + turn * place, turn * own_turn
                moved = self._joint(joint, frame, there)
                behind.append((child, frame, there, (*joints, moved) if moved is not None else joints))
            waiting[:0] = behind
        if len(made) != len(self._links):
            missing = sorted(set(self._links) - {body.name for body in made})
            raise self._root.refuse(
                f"the links {', '.join(missing[:5])} hang on one another: closed loops are not taken"
            )
        return made

    def _origin(self, element: XmlElement) -> tuple[Any, Any]:
        """The place and the turn of an element <origin>."""
        import sympy

        origin = element.one("origin")
        if origin is None:
            return sympy.ImmutableMatrix([0, 0, 0]), sympy.ImmutableMatrix(sympy.eye(3))
        origin.only_attributes(("xyz", "rpy"))  # URDF 1.1 has quat_xyzw
        words = origin.text("rpy", "0 0 0").split()
        angles = []
        for number, word in zip(origin.numbers("rpy", 3, "0 0 0"), words, strict=True):
            angle = right_angle(number, word)
            if angle != number and f"{word} is {angle}" not in self._read_as:
                self._read_as.append(f"{word} is {angle}")
            angles.append(angle)
        return sympy.ImmutableMatrix(origin.numbers("xyz", 3, "0 0 0")), by_roll_pitch_yaw(angles)

    def _joint(self, joint: XmlElement, frame: Any, anchor: Any) -> Joint | None:
        import sympy

        known = ("parent", "child", "origin", "axis", "limit", "dynamics")
        joint.only(known, ("calibration", "safety_controller"), _REASONS)
        joint.only_attributes(("name", "type"))
        kind = joint.text("type")
        if kind == "fixed":
            return None
        if kind not in (*_HINGES, *_SLIDES):
            raise joint.refuse(f"type {kind[:40]!r}: joints are revolute, continuous, prismatic or fixed")
        axis_element = joint.one("axis")
        if axis_element is not None:
            axis_element.only_attributes(("xyz",))
        axis = sympy.ImmutableMatrix([1, 0, 0] if axis_element is None else axis_element.numbers("xyz", 3))
        if axis.is_zero_matrix:
            raise joint.refuse("the axis must not be 0")
        limit = joint.one("limit")
        if limit is not None:
            limit.only_attributes(_LIMIT)
            self._limited = True
        dynamics = joint.one("dynamics")
        if dynamics is not None:
            dynamics.only_attributes(("damping", "friction"))
        damping = sympy.Integer(0) if dynamics is None else dynamics.number("damping", "0")
        if dynamics is not None and dynamics.number("friction", "0") != 0:
            if "friction" not in self._without:
                raise dynamics.refuse(
                    "dry friction of a joint is not taken: one contact alone has friction; without=('friction',) "
                    "leaves it out on purpose"
                )
            dynamics.left_out.add("friction")
        return Joint(joint.text("name"), kind in _HINGES, frame * axis / axis.norm(), anchor, damping=damping)

    def _body(self, link: str, turn: Any, origin: Any, joints: tuple[Joint, ...]) -> Body:
        import sympy

        element = self._links[link]
        element.only(("inertial",), ("visual", "collision"), _REASONS)
        element.only_attributes(("name",))
        inertial = element.one("inertial")
        zero = sympy.ImmutableMatrix(sympy.zeros(3, 3))
        if inertial is None:
            return Body(link, joints, turn, origin, sympy.Integer(0), origin, zero)
        inertial.only(("origin", "mass", "inertia"), (), _REASONS)
        inertial.only_attributes(())
        mass, inertia = inertial.one("mass"), inertial.one("inertia")
        if mass is None or inertia is None:
            raise inertial.refuse("the elements 'mass' and 'inertia' are needed")
        mass.only_attributes(("value",))
        inertia.only_attributes(tuple(f"i{word}" for word in _MOMENTS))
        kilograms = mass.number("value")
        if kilograms < 0:
            raise mass.refuse("a mass must not be negative")
        xx, yy, zz, xy, xz, yz = (inertia.number(f"i{word}") for word in _MOMENTS)
        place, own = self._origin(inertial)
        axes = turn * own
        local = sympy.ImmutableMatrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        return Body(link, joints, turn, origin, kilograms, origin + turn * place, axes * local * axes.T)

    def remarks(self) -> list[str]:
        """What a reader must know besides the projection."""
        texts = [f"the root link {self._fixed} is fixed"]
        if self._read_as:
            texts.append(f"angles: {', '.join(self._read_as)}")
        if self._limited:
            texts.append("limits of joints are not part of the mechanism")
        if self._root.left_out:
            texts.append(f"left out on purpose: {', '.join(sorted(self._root.left_out))}")
        return texts
