"""Rigid bodies joined in a tree that moves in a plane, and the mechanism that they are with one contact.

All joint axes are parallel to the plane's normal n (hinges) or perpendicular to it (slides), so every motion is planar:
of a body count its mass, the place of its centre in the plane, and its moment of inertia about n. What lies along n,
and products of inertia with n, the hinges carry.

With all places at zero coordinates, a point r of a body behind the joints 1, ..., k is at T_1(q_1) ... T_k(q_k) r
(product of exponentials: Murray, Li, Sastry, A Mathematical Introduction to Robotic Manipulation, Sec. 3.2), T_j the
turn by s_j q_j about the place P_j of its axis, or the shift by q_j d_j. That is a sum of vectors turned by sums φ of
angles; for two of them R(φ) a . R(ψ) b = cos(ψ - φ) a.b + sin(ψ - φ) (a_2 b_1 - a_1 b_2), which gives the mass matrix.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from gspot_verified.mechanisms.derive.impossible import refuse_impossible
from gspot_verified.mechanisms.derive.lie_derivatives import vanishes_identically
from gspot_verified.mechanisms.foreign.names import coordinate_names, once, renamed_text
from gspot_verified.mechanisms.input.given import MAX_COORDINATES, from_energies
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError, exact_rational
from gspot_verified.mechanisms.input.planar_links import PlanarJoint, PlanarLink, PlanarLinks

Vector = tuple[Any, Any]
Turned = dict[Any, Vector]
"""A sum of vectors, each turned by the angle that is its key."""

_MAX_BODIES = 200  # a limit against hostile input
_AXES = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}


@dataclass(frozen=True, eq=False)
class Joint:
    """A hinge or a slide: ``axis`` and ``anchor`` at zero coordinates, in the world; the place of the joint counts from
    ``reference``. ``stiffness`` about ``rest``, ``damping`` and ``armature`` are those along the joint."""

    name: str
    is_hinge: bool
    axis: Any
    anchor: Any
    reference: Any = 0
    damping: Any = 0
    stiffness: Any = 0
    rest: Any = 0
    armature: Any = 0


@dataclass(frozen=True, eq=False)
class Body:
    """A rigid body at zero coordinates, in the world: behind ``joints``, all from the root on.

    ``turn`` and ``origin`` are the frame in which the file gives points of it; ``inertia`` is about its centre.
    """

    name: str
    joints: tuple[Joint, ...]
    turn: Any
    origin: Any
    mass: Any
    centre: Any
    inertia: Any


@dataclass(frozen=True)
class PlanarContact:
    """Which point of which body touches, in the body's frame; the surface is at ``height`` along ``normal``, slip is
    along ``tangent``; mu and height are values of parameters."""

    body: str
    point: Sequence[Any]
    mu: Any
    height: Any
    normal: str
    tangent: str
    slip: str = "positive"


def planar_mechanism(
    name: str,
    bodies: Sequence[Body],
    contact: PlanarContact,
    gravity: Any,
    parameters: Mapping[str, Any],
    options: Mapping[str, Any],
    remarks: Sequence[str] = (),
) -> Mechanism:
    """The mechanism; ``gravity`` is a vector in the world, its coordinates are the joints by their names.

    ``parameters`` have values for the symbols in it; mu and height are among them.

    :raises MechanismError: an axis does not fit the plane; the joint is named. No body of that name.
    """
    import sympy

    parameters = {**parameters, "height": contact.height, "mu": contact.mu}

    plane = _Plane(name, contact.tangent, contact.normal)
    joints = list(dict.fromkeys(joint for body in bodies for joint in body.joints))
    if not 1 <= len(joints) <= MAX_COORDINATES or len(bodies) > _MAX_BODIES:
        raise MechanismError(
            f"{name}: between 1 and {MAX_COORDINATES} joints that move and at most {_MAX_BODIES} bodies, got "
            f"{len(joints)} and {len(bodies)}"
        )
    words = coordinate_names([joint.name for joint in joints], parameters)
    q = {joint: sympy.Symbol(words[joint.name]) for joint in joints}
    rates = [sympy.Symbol(f"{words[joint.name]}_dot") for joint in joints]
    moves = {joint: plane.move(joint, q[joint] - joint.reference) for joint in joints}
    places = {body: _place([moves[joint] for joint in body.joints], plane.of(body.centre)) for body in bodies}
    mass_matrix = _mass_matrix(bodies, list(q.values()), places, moves, plane)
    kinetic = sum(
        (mass_matrix[i, j] + (joints[i].armature if i == j else 0)) * rates[i] * rates[j] / 2
        for i in range(len(joints))
        for j in range(len(joints))
    )
    pull = plane.of(gravity)
    potential = sum(_along(pull, places[body]) * -body.mass for body in bodies)
    potential += sum(joint.stiffness * (q[joint] - joint.rest) ** 2 / 2 for joint in joints)
    losses = sum(joint.damping * rate**2 / 2 for joint, rate in zip(joints, rates, strict=True))
    touching = next((body for body in bodies if body.name == contact.body), None)
    if touching is None:
        raise MechanismError(f"{name}: no body {contact.body!r}; there are: {', '.join(body.name for body in bodies)}")
    point = plane.of(touching.origin + touching.turn * _point(name, contact.point))
    tip = _place([moves[joint] for joint in touching.joints], point)
    mechanism = from_energies(
        name,
        [str(symbol) for symbol in q.values()],
        kinetic,
        potential,
        _along((1, 0), tip),
        _along((0, 1), tip) - sympy.Symbol("height"),
        "mu",
        parameters=parameters,
        dissipation=losses,
        slip=contact.slip,
        **_named_options(options, words),
    )
    refuse_impossible(mechanism)
    links = _links(bodies, joints, plane, touching.joints, point)
    return replace(mechanism, remarks=(plane.remark(), *renamed_text(words), *remarks), bodies=links)


def _links(
    bodies: Sequence[Body], joints: Sequence[Joint], plane: _Plane, touching: Sequence[Joint], point: Vector
) -> PlanarLinks:
    """The bodies that move and have a mass in the plane, those behind the same joints as one."""
    numbers = {joint: i for i, joint in enumerate(joints)}
    groups: dict[tuple[int, ...], list[Body]] = {}
    for body in bodies:
        if body.joints and body.mass != 0:
            groups.setdefault(tuple(numbers[joint] for joint in body.joints), []).append(body)
    return PlanarLinks(
        joints=tuple(
            PlanarJoint(
                joint.is_hinge,
                _floats(plane.of(joint.anchor if joint.is_hinge else joint.axis)),
                -1 if joint.is_hinge and joint.axis.dot(plane.n) < 0 else 1,
                float(joint.reference),
                float(joint.armature),
            )
            for joint in joints
        ),
        links=tuple(_as_one(behind, group, plane) for behind, group in groups.items()),
        touching=tuple(numbers[joint] for joint in touching),
        point=_floats(point),
    )


def _as_one(joints: tuple[int, ...], bodies: Sequence[Body], plane: _Plane) -> PlanarLink:
    """Bodies that are fixed to one another; Steiner's theorem."""
    places = [plane.of(body.centre) for body in bodies]
    mass = sum(body.mass for body in bodies)
    x, y = (sum(body.mass * place[i] for body, place in zip(bodies, places, strict=True)) / mass for i in (0, 1))
    inertia = sum(
        (plane.n.T * body.inertia * plane.n)[0] + body.mass * ((place[0] - x) ** 2 + (place[1] - y) ** 2)
        for body, place in zip(bodies, places, strict=True)
    )
    return PlanarLink(joints, float(mass), float(inertia), _floats((x, y)))


def _floats(vector: Vector) -> tuple[float, float]:
    return (float(vector[0]), float(vector[1]))


def _point(name: str, values: Sequence[Any]) -> Any:
    import sympy

    if isinstance(values, str) or len(values) != 3:
        raise MechanismError(f"{name}: contact_point: three numbers are needed")
    numbers = [exact_rational(value, f"{name}: contact_point") for value in values]
    return sympy.ImmutableMatrix([sympy.Rational(int(number.p), int(number.q)) for number in numbers])


@dataclass(frozen=True)
class _Move:
    """What a joint does in the plane: a turn by ``angle`` about ``anchor``, or a shift."""

    angle: Any
    anchor: Vector
    shift: Vector


class _Plane:
    """The plane of two axes of the world; n = tangent x normal."""

    def __init__(self, name: str, tangent: str, normal: str) -> None:
        import sympy

        self._name, self._words = name, (tangent, normal)
        signed = {f"{sign}{word}": [turn * part for part in axis] for word, axis in _AXES.items()
                  for sign, turn in (("", 1), ("+", 1), ("-", -1))}  # fmt: skip
        for what, word in (("tangent", tangent), ("normal", normal)):
            if word not in signed:
                raise MechanismError(f"{name}: {what} must be x, y, z, -x, -y or -z, got {word!r:.40}")
        self._tangent, self._normal = sympy.Matrix(signed[tangent]), sympy.Matrix(signed[normal])
        self.n = self._tangent.cross(self._normal)
        if self.n.is_zero_matrix:
            raise MechanismError(f"{name}: tangent {tangent} and normal {normal} must be different axes")

    def of(self, vector: Any) -> Vector:
        """The components in the plane."""
        return (self._tangent.dot(vector), self._normal.dot(vector))

    def move(self, joint: Joint, amount: Any) -> _Move:
        """The joint in the plane.

        :raises MechanismError: it leaves the plane.
        """
        along = joint.axis.dot(self.n)
        across = joint.axis.cross(self.n) if joint.is_hinge else [along]
        if not all(vanishes_identically(part) for part in across):
            kind = "turns about" if joint.is_hinge else "slides along"
            wanted = "parallel" if joint.is_hinge else "perpendicular"
            raise MechanismError(
                f"{self._name}: joint {joint.name!r} {kind} {tuple(joint.axis)} in the world: that must be {wanted} "
                f"to the normal of the plane of {self._words[0]} and {self._words[1]}; choose normal= and tangent=, or "
                "this robot is not planar"
            )
        if joint.is_hinge:
            return _Move((1 if along > 0 else -1) * amount, self.of(joint.anchor), (0, 0))
        right, up = self.of(joint.axis)
        return _Move(0, self.of(joint.anchor), (right * amount, up * amount))

    def remark(self) -> str:
        """What a reader must know of the projection."""
        tangent, normal = self._words
        return (
            f"planar projection: the plane of {tangent} (tangential) and {normal} (normal) of the world; the surface "
            f"is {normal} = height; places and products of inertia along the hinges have no effect and are left out"
        )


def _place(moves: Sequence[_Move], point: Vector) -> Turned:
    """T_1 ... T_k r as a sum of turned vectors."""
    terms: Turned = {}
    angle: Any = 0
    last: Vector = (0, 0)
    for move in moves:
        if move.angle == 0:
            _add(terms, angle, move.shift)
        else:
            _add(terms, angle, (move.anchor[0] - last[0], move.anchor[1] - last[1]))
            angle, last = angle + move.angle, move.anchor
    _add(terms, angle, (point[0] - last[0], point[1] - last[1]))
    return terms


def _add(terms: Turned, angle: Any, vector: Vector) -> None:
    old = terms.get(angle, (0, 0))
    terms[angle] = (old[0] + vector[0], old[1] + vector[1])


def _slope(terms: Turned, q: Any) -> Turned:
    """The derivative by one coordinate: a turned vector turns, and a shift grows."""
    import sympy

    found: Turned = {}
    for angle, (right, up) in terms.items():
        turn = sympy.diff(angle, q)
        found[angle] = (sympy.diff(right, q) - turn * up, sympy.diff(up, q) + turn * right)
    return found


def _product(first: Turned, second: Turned) -> Any:
    """The scalar product of two sums of turned vectors."""
    import sympy

    terms = []
    for angle, a in first.items():
        for other, b in second.items():
            gap = other - angle
            terms.append(sympy.cos(gap) * (a[0] * b[0] + a[1] * b[1]) + sympy.sin(gap) * (a[1] * b[0] - a[0] * b[1]))
    return sympy.Add(*terms)


def _along(direction: Vector, terms: Turned) -> Any:
    """The component along a direction of the world."""
    return _product({0: direction}, terms)


def _mass_matrix(
    bodies: Sequence[Body], q: Sequence[Any], places: Mapping[Body, Turned], moves: Mapping[Joint, _Move], plane: _Plane
) -> Any:
    """M_ij = sum over bodies of m (dc/dq_i . dc/dq_j) + I_n (dφ/dq_i)(dφ/dq_j)."""
    import sympy

    M = sympy.zeros(len(q), len(q))
    for body in bodies:
        turn = sympy.Add(*(moves[joint].angle for joint in body.joints))
        slopes = [_slope(places[body], each) for each in q]
        spin = (plane.n.T * body.inertia * plane.n)[0]
        for i, first in enumerate(q):
            for j, second in enumerate(q[: i + 1]):
                M[i, j] += body.mass * _product(slopes[i], slopes[j]) + spin * turn.diff(first) * turn.diff(second)
                M[j, i] = M[i, j]
    return M


def _named_options(options: Mapping[str, Any], words: Mapping[str, str]) -> dict[str, Any]:
    """Joints may be called by their own names in the G-spot's place and in angles."""
    table = dict(words) | {f"{name}_dot": f"{word}_dot" for name, word in words.items()}
    given = {key: value for key, value in options.items() if value is not None}
    for key in ("place", "angles"):
        if key in given:
            names = once(key, ((name, table.get(name, name)) for name in given[key]))
            given[key] = dict(zip(names, given[key].values(), strict=True))
    if "fixed" in given:
        given["fixed"] = [table.get(name, name) for name in given["fixed"]]
    return given
