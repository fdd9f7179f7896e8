"""A mechanism from a model in MJCF, MuJoCo's format: https://mujoco.readthedocs.io/en/stable/XMLreference.html.

Of a body count <inertial> and its frame; of a joint its type, axis, place, damping, armature and spring. The parser is
that of the standard library.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from gspot_verified.mechanisms.foreign.names import mechanism_name
from gspot_verified.mechanisms.foreign.planar_tree import Body, Joint, PlanarContact, planar_mechanism
from gspot_verified.mechanisms.foreign.rotations import by_euler, by_quaternion, right_angle
from gspot_verified.mechanisms.foreign.xml_element import XmlElement, exact_number, xml_root
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.numbers.balls import ExactInput

_MOTOR = "brings forces of motors: nothing of it is taken"
_REASONS = {
    "actuator": _MOTOR,
    "tendon": "may bring springs: nothing of it is taken",
    "equality": "closes loops or couples joints: nothing of it is taken",
    "freejoint": "moves in space: give the body two slides and a hinge",
    "include": "names another file: put its text in its place",
    "deformable": "is no rigid body",
    "extension": "loads a plugin: nothing of it is taken",
    "plugin": "is a program: nothing of it is taken",
    "composite": "is no single rigid body",
    "flexcomp": "is no rigid body",
    "replicate": "makes copies of bodies: write them out",
    "attach": "names another model: put its text in its place",
    "frame": "moves what stands in it: put it into the elements",
}
_NO_EFFECT = ("asset", "visual", "statistic", "size", "custom", "contact", "keyframe", "sensor")
_DEFAULTED = (
    "mesh", "material", "geom", "site", "camera", "light", "pair", "equality", "tendon", "general", "motor", "position",
    "velocity", "intvelocity", "damper", "cylinder", "muscle", "adhesion", "dcmotor",
)  # fmt: skip
_REFUSED_JOINT = ("frictionloss", "springdamper")
_REFUSED_COMPILER = ("settotalmass", "boundmass", "boundinertia")
_REFUSED_OPTION = ("density", "viscosity")
_JOINT = (
    "name", "class", "type", "group", "pos", "axis", "springdamper", "solreflimit", "solimplimit", "solreffriction",
    "solimpfriction", "stiffness", "range", "limited", "actuatorfrcrange", "actuatorfrclimited", "actuatorgravcomp",
    "margin", "ref", "springref", "armature", "damping", "frictionloss", "user",
)  # fmt: skip
_TURNS = ("quat", "euler", "axisangle", "xyaxes", "zaxis")
_COMPILER = (
    "alignfree", "angle", "assetdir", "autolimits", "balanceinertia", "boundinertia", "boundmass", "conflict",
    "convexhull", "coordinate", "discardvisual", "eulerseq", "exactmeshinertia", "fitaabb", "fusestatic",
    "inertiafromgeom", "inertiagrouprange", "meshdir", "saveinertial", "settotalmass", "strippath", "texturedir",
    "usethread",
)  # fmt: skip
_OPTION = (
    "actuatorgroupdisable", "apirate", "ccd_iterations", "ccd_tolerance", "collision", "cone", "density", "gravity",
    "impratio", "integrator", "iterations", "jacobian", "ls_iterations", "ls_tolerance", "magnetic", "mpr_iterations",
    "mpr_tolerance", "noslip_iterations", "noslip_tolerance", "o_friction", "o_margin", "o_solimp", "o_solref",
    "sdf_initpoints", "sdf_iterations", "sleep_tolerance", "solver", "timestep", "tolerance", "viscosity", "wind",
)  # fmt: skip
_FLAG = (
    "actuation", "autoreset", "clampctrl", "constraint", "contact", "damper", "diagexact", "energy", "equality",
    "eulerdamp", "filterparent", "frictionloss", "fwdinv", "gravity", "invdiscrete", "ipc", "island", "limit",
    "midphase", "multiccd", "nativeccd", "override", "passive", "refsafe", "sensor", "sensornoise", "sleep",
    "speculative", "spring", "warmstart",
)  # fmt: skip


def from_mjcf(
    source: str | Path,
    *,
    contact_body: str,
    mu: ExactInput | None,
    contact_point: Sequence[ExactInput] = (0, 0, 0),
    normal: str = "z",
    tangent: str = "x",
    height: ExactInput | None = 0,
    slip: str = "positive",
    name: str | None = None,
    without: Sequence[str] = (),
    angles: Mapping[str, tuple[ExactInput, ExactInput]] | None = None,
    place: Mapping[str, Any] | None = None,
    search: bool = False,
    fixed: Sequence[str] | None = None,
    regularisation: Mapping[str, ExactInput] | None = None,
) -> Mechanism:
    """The mechanism that a model of MuJoCo is in its plane, with one point of one body in contact.

    Carried: bodies in a tree with their <inertial>, hinges and slides (all hinges parallel to the normal of the plane),
    damping, armature and springs of joints, default classes of joints, gravity. Meshes, geoms, limits and contacts of
    the model have no effect. Refused, by name: free and ball joints, bodies whose mass comes from geoms, equality
    constraints, actuators, tendons, dry friction of joints, elements that are not known. The notes of the mechanism say
    how it was projected.

    :param contact_point: in the frame of the body; y, the distance from the surface, is its place along ``normal`` less
        ``height``; x its place along ``tangent``: axes of the world such as "z" or "-x".
    :param mu: it, ``height`` and, where gravity is along an axis, g are parameters; None leaves one a symbol.
    :param without: elements and attributes that are left out on purpose: "actuator", "frictionloss".
    :param place: with ``search``, ``fixed``, ``angles`` and ``regularisation`` as in :func:`from_urdf`.
    :raises MechanismError: something cannot be read or taken; the message names it.

    >>> from gspot_verified import from_mjcf
    >>> text = '''<mujoco model="arm"><worldbody><body name="bar"><joint name="hip" axis="0 -1 0"/>
    ...   <inertial pos="0.5 0 0" mass="2" diaginertia="0 0.1 0.1"/></body></worldbody></mujoco>'''
    >>> arm = from_mjcf(text, contact_body="bar", contact_point=(1, 0, 0), height="-1/2", mu="1/2")
    >>> arm.state, len(arm.notes)
    (('hip', 'hip_dot'), 1)
    """
    root = xml_root(source, "mujoco", without)
    title = mechanism_name(name if name is not None else root.text("model", "model of MuJoCo")[:80])
    model = _Model(root, without)
    bodies = model.bodies()
    gravity, parameters = model.gravity()
    contact = PlanarContact(contact_body, contact_point, mu, height, normal, tangent, slip)
    options = {"angles": angles, "place": place, "search": search, "fixed": fixed, "regularisation": regularisation}
    return planar_mechanism(title, bodies, contact, gravity, parameters, options, model.remarks())


class _Model:
    """The bodies and joints of a file."""

    def __init__(self, root: XmlElement, without: Sequence[str]) -> None:
        self._root, self._without = root, without
        root.only(("compiler", "option", "worldbody", "default"), _NO_EFFECT, _REASONS)
        root.only_attributes(("model",))
        self._degrees, self._sequence = True, "xyz"
        for compiler in _merged(root, "compiler"):
            self._compiler(compiler)
        self._defaults: dict[str, dict[str, str]] = {"": {}}
        for default in root.children("default"):
            self._default(default, self._defaults[""], is_main=True)
        self._read_as: list[str] = []
        self._limited = False
        self._names: set[str] = set()

    def _compiler(self, compiler: XmlElement) -> None:
        compiler.only_attributes(_COMPILER)
        angle = compiler.text("angle", "degree")
        self._degrees, self._sequence = angle == "degree", compiler.text("eulerseq", "xyz")
        if angle not in ("degree", "radian"):
            raise compiler.refuse(f"angle {angle[:20]!r} must be degree or radian")
        if len(self._sequence) != 3 or set(self._sequence.lower()) - set("xyz"):
            raise compiler.refuse(f"eulerseq {self._sequence[:20]!r} must be three of x, y, z, X, Y, Z")
        if compiler.text("coordinate", "local") != "local":
            raise compiler.refuse("coordinates must be local")
        if compiler.text("inertiafromgeom", "auto") == "true":
            raise compiler.refuse("inertiafromgeom: masses that come from geoms are not taken")
        if compiler.text("balanceinertia", "false") != "false":
            raise compiler.refuse("balanceinertia changes inertias: it is not taken")
        _refuse_numbers(compiler, _REFUSED_COMPILER, "changes masses: it is not taken")

    def _default(self, element: XmlElement, above: Mapping[str, str], is_main: bool = False) -> None:
        element.only_attributes(("class",))
        element.only(("joint", "default"), _DEFAULTED, _REASONS)
        joint = element.one("joint")
        if joint is not None:
            joint.only_attributes(_JOINT)
        own = dict(above) | ({} if joint is None else joint.attributes)
        name = element.text("class", "main" if is_main else None)
        if not is_main and name in self._defaults:
            raise element.refuse(f"two default classes are called {name[:40]!r}")
        self._defaults[name] = own
        if is_main:
            self._defaults[""] = own
        for inner in element.children("default"):
            self._default(inner, own)

    def gravity(self) -> tuple[Any, dict[str, Any]]:
        """The vector, and the parameter g where it is along an axis."""
        import sympy

        gravity: list[Any] = [sympy.Integer(0), sympy.Integer(0), -sympy.Rational("9.81")]
        for option in _merged(self._root, "option"):
            option.only_attributes(_OPTION)
            _refuse_numbers(option, _REFUSED_OPTION, "is a force of a fluid: it is not taken")
            gravity = option.numbers("gravity", 3, "0 0 -9.81")
        for option in self._root.children("option"):
            option.only(("flag",), (), _REASONS)
            for flag in option.children("flag"):
                flag.only_attributes(_FLAG)
                for word in ("gravity", "spring", "damper", "passive"):
                    if flag.text(word, "enable") != "enable":
                        raise flag.refuse(f"{word} is switched off: leave it out of the model")
        parts = [part for part in gravity if part != 0]
        if len(parts) != 1:
            return sympy.ImmutableMatrix(gravity), {}
        symbol = sympy.Symbol("g")
        return sympy.ImmutableMatrix([sympy.sign(part) * symbol for part in gravity]), {"g": str(abs(parts[0]))}

    def bodies(self) -> list[Body]:
        """All bodies, each after the one that it hangs on.

        :raises MechanismError: something cannot be taken.
        """
        import sympy

        worlds = list(self._root.children("worldbody"))
        if len(worlds) != 1:
            raise self._root.refuse(f"one worldbody is needed, found {len(worlds)}")
        worlds[0].only_attributes(())
        worlds[0].only(("body",), ("geom", "site", "camera", "light"), _REASONS)
        made: list[Body] = []
        eye, zero = sympy.ImmutableMatrix(sympy.eye(3)), sympy.ImmutableMatrix([0, 0, 0])
        waiting: list[tuple[XmlElement, Any, Any, tuple[Joint, ...], str]] = [
            (body, eye, zero, (), "") for body in worlds[0].children("body")
        ]
        while waiting:
            element, turn, origin, joints, kind = waiting.pop(0)
            element.only(("body", "joint", "inertial"), ("geom", "site", "camera", "light"), _REASONS)
            element.only_attributes(("name", "pos", "childclass", "mocap", "gravcomp", "user", "sleep", *_TURNS))
            self._refuse_body(element)
            kind = element.text("childclass", kind)
            place, frame = origin + turn * _vector(element, "pos"), turn * self._turn(element)
            own = tuple(self._joint(joint, frame, place, kind) for joint in element.children("joint"))
            made.append(self._body(element, frame, place, (*joints, *own), f"body{len(made) + 1}"))
            waiting[:0] = [(body, frame, place, made[-1].joints, kind) for body in element.children("body")]
        names = [body.name for body in made]
        twice = next((name for name in names if names.count(name) > 1), None)
        if twice is not None:
            raise self._root.refuse(f"two bodies are called {twice!r}")
        return made

    def _refuse_body(self, element: XmlElement) -> None:
        if element.text("mocap", "false") != "false":
            raise element.refuse("a mocap body is moved from outside: it is not taken")
        _refuse_numbers(element, ("gravcomp",), "is a force against gravity: it is not taken")

    def _body(self, element: XmlElement, frame: Any, place: Any, joints: tuple[Joint, ...], number: str) -> Body:
        import sympy

        name, inertial = element.text("name", number), element.one("inertial")
        if inertial is None:
            if any(element.children("geom")):
                raise element.refuse("no <inertial>: masses that come from geoms are not taken")
            return Body(name, joints, frame, place, sympy.Integer(0), place, sympy.ImmutableMatrix(sympy.zeros(3, 3)))
        inertial.only_attributes(("pos", "mass", "diaginertia", "fullinertia", *_TURNS))
        if inertial.has("fullinertia"):
            xx, yy, zz, xy, xz, yz = inertial.numbers("fullinertia", 6)
        else:
            (xx, yy, zz), (xy, xz, yz) = inertial.numbers("diaginertia", 3), (0, 0, 0)
        axes = frame * self._turn(inertial)
        local = sympy.ImmutableMatrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        mass = inertial.number("mass")
        if mass < 0:
            raise inertial.refuse("a mass must not be negative")
        return Body(name, joints, frame, place, mass, place + frame * _vector(inertial, "pos"), axes * local * axes.T)

    def _joint(self, element: XmlElement, frame: Any, place: Any, kind: str) -> Joint:

        joint = self._with_defaults(element, kind)
        joint.only_attributes(_JOINT)
        name = joint.text("name", f"joint{len(self._names) + 1}")
        if name in self._names:
            raise joint.refuse("two joints have this name")
        self._names.add(name)
        what = joint.text("type", "hinge")
        if what not in ("hinge", "slide"):
            raise joint.refuse(f"type {what[:40]!r}: joints are hinge or slide")
        for word in _REFUSED_JOINT:
            if any(exact_number(number, word) != 0 for number in joint.text(word, "0").split()):
                if word not in self._without:
                    raise joint.refuse(f"{word} is not taken; without=({word!r},) leaves it out on purpose")
                joint.left_out.add(word)
        axis = _vector(joint, "axis", "0 0 1")
        if axis.is_zero_matrix:
            raise joint.refuse("the axis must not be 0")
        self._limited = self._limited or joint.has("range")
        is_hinge = what == "hinge"
        return Joint(
            name,
            is_hinge,
            frame * axis / axis.norm(),
            place + frame * _vector(joint, "pos"),
            reference=self._along(joint, "ref", is_hinge),
            damping=joint.number("damping", "0"),
            stiffness=joint.number("stiffness", "0"),
            rest=self._along(joint, "springref", is_hinge),
            armature=joint.number("armature", "0"),
        )

    def _with_defaults(self, joint: XmlElement, kind: str) -> XmlElement:
        word = joint.text("class", kind)
        if word not in self._defaults:
            raise joint.refuse(f"there is no default class {word[:40]!r}")
        return joint.with_defaults(self._defaults[word])

    def _along(self, joint: XmlElement, word: str, is_hinge: bool) -> Any:
        """A place of a joint: an angle in the file's unit, or a length."""
        return self._angles(joint, word, 1, "0")[0] if is_hinge else joint.number(word, "0")

    def _angles(self, element: XmlElement, word: str, count: int, default: str | None = None) -> list[Any]:
        import sympy

        found = []
        words = element.text(word, default).split()
        for number, shown in zip(element.numbers(word, count, default), words, strict=True):
            angle = number * sympy.pi / 180 if self._degrees else right_angle(number, shown)
            if not self._degrees and angle != number and f"{shown} is {angle}" not in self._read_as:
                self._read_as.append(f"{shown} is {angle}")
            found.append(angle)
        return found

    def _turn(self, element: XmlElement) -> Any:
        """The matrix of the frame of a body or an <inertial> in the one above."""
        import sympy

        given = [word for word in _TURNS if element.has(word)]
        if len(given) > 1:
            raise element.refuse(f"{' and '.join(given)}: one of them is needed")
        if not given:
            return sympy.ImmutableMatrix(sympy.eye(3))
        if given[0] == "quat":
            turn = by_quaternion(element.numbers("quat", 4))
            if turn is None:
                raise element.refuse("quat must not be 0")
            return turn
        if given[0] == "euler":
            return by_euler(self._angles(element, "euler", 3), self._sequence)
        raise element.refuse(f"{given[0]}: give the turn as quat or euler")

    def remarks(self) -> list[str]:
        """What a reader must know besides the projection."""
        texts = []
        if self._read_as:
            texts.append(f"angles: {', '.join(self._read_as)}")
        if self._limited:
            texts.append("limits of joints are not part of the mechanism")
        if self._root.left_out:
            texts.append(f"left out on purpose: {', '.join(sorted(self._root.left_out))}")
        return texts


def _merged(root: XmlElement, tag: str) -> list[XmlElement]:
    """The sections of this tag as one: MuJoCo merges them, a later attribute in the place of an earlier one."""
    merged: list[XmlElement] = []
    for section in root.children(tag):
        merged = [section.with_defaults(merged[0].attributes) if merged else section]
    return merged


def _vector(element: XmlElement, word: str, default: str = "0 0 0") -> Any:
    import sympy

    return sympy.ImmutableMatrix(element.numbers(word, 3, default))


def _refuse_numbers(element: XmlElement, words: Sequence[str], reason: str) -> None:
    """Attributes that must be 0; the total mass may be negative, which is MuJoCo's way to say nothing."""
    for word in words:
        number = element.number(word, "0")
        if number != 0 and not (word == "settotalmass" and number < 0):
            raise element.refuse(f"{word} {reason}")
