"""Read a mechanism from a TOML file.

For example::

    format = 1
    name = "falling rod"

    [parameters]
    m = 1
    mu = "73/36"

    [angles.theta]
    sine = "3/5"
    cosine = "4/5"

    [lagrangian]
    coordinates = ["X", "Y", "theta"]
    mass_matrix = [["m", 0, 0], [0, "m", 0], [0, 0, "m*l^2/3"]]
    forces = [0, "-m*g", 0]

    [contact]
    x = "X + l*cos(theta)"
    y = "Y - l*sin(theta)"
    mu = "mu"

    [g_spot]
    [g_spot.point]
    X = 0

The keys; one of the tables ``lagrangian``, ``energies``, ``fields`` says how it moves::

    format                   1
    name                     one line of visible text
    note                     a text for readers
    parameters.*             a formula of other parameters: the value of the parameter *
    angles.*.sine            rational; with the cosine it makes *_ref known, sine^2 + cosine^2 = 1
    angles.*.cosine          rational
    lagrangian.coordinates   names; the velocity of q is q_dot
    lagrangian.mass_matrix   rows of formulas of the coordinates (and time): M q'' = forces + contact forces
    lagrangian.forces        one formula for each coordinate, of the whole state
    lagrangian.time          a name: makes time a component of the state, for explicit forcing
    lagrangian.constraints   formulas of the coordinates (and time) that are 0; their multipliers are solved for
    energies.coordinates     names
    energies.kinetic         T, quadratic in the velocities
    energies.potential       V, of the coordinates (and time)
    energies.dissipation     optional: Rayleigh's function D, the force -dD/dq_dot
    energies.forces          optional: further forces, one for each coordinate
    energies.time            as in lagrangian
    energies.constraints     as in lagrangian
    fields.state             names of the components
    fields.F                 one formula for each component
    fields.G_T               one formula for each component: the direction of the tangential force
    fields.G_N               one formula for each component: the direction of the normal force
    contact.x                the tangential place of the contact point; its rate is the slip velocity
    contact.slip_velocity    in the place of x: a formula linear in the velocities (a belt, a rolling contact)
    contact.slip             "positive" (if missing), or "negative": x and a surface's velocity are mirrored
    contact.y                the distance of the contact point from the surface
    contact.mu               the friction coefficient, a formula of the coordinates (and time); in scenes of slip_speed
    regularisation.k_1       optional, rational > 0: the stiffness in series is k_1/epsilon^2 (1 if missing)
    regularisation.k_2       optional, rational > 0: the stiffness of the contact is k_2/epsilon^2 (1 if missing)
    regularisation.c         optional, rational >= 0: the damper beside k_1 is c/epsilon (1 if missing)
    g_spot.search            true: the values of the point start Newton's method
    g_spot.fixed             m - 4 components of the state that keep their value; two less for each constraint
    g_spot.conditions        in the place of fixed: functions of the state that vanish
    g_spot.point.*           the value of the component * of the state: a formula of parameters and reference angles
    drawing.lines            optional, for pictures alone: bodies as lines, each a list of points [x, y] by formulas
    drawing.circles          bodies as circles [x, y, radius], or ellipses [x, y, a, b, angle]: half axes, angle of a
    drawing.points           points [x, y] that are marked: a joint, the centre of mass
    drawing.contact          the contact point [x, y] in the drawing; contact.x and contact.y if missing
    drawing.normal           the direction [x, y] away from the surface, contact.y in front of it; [0, 1] if missing

Numbers are exact: integers, decimals (0.1 is 1/10), or texts such as "7/3". Formulas are read by
:mod:`gspot_verified.mechanisms.formulas.formula`: they can run no code. What cancels is left out: x/x is 1,
sqrt(x)*sqrt(x) is x, 0*log(x) is 0. At states where a formula has no value through nothing but that, every answer is
about its continuation.

What no mechanism can have is refused by ``load``: a friction coefficient below 0, a mass matrix that is not positive
definite (for any state, or at the point, unless that only starts a search), a mass below 0. A parameter counts as a
mass if it stands in the mass matrix (or in G_T, G_N) and is called m, M, mass, I, J or inertia, or so with a number or
an underscore behind, as m_2.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from gspot_verified.mechanisms.input.drawing import PARTS
from gspot_verified.mechanisms.input.given import from_energies, from_fields, lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.input.toml_table import TomlTable, formula_value, shown_value, toml_table

MAX_BYTES = 200_000  # of a file: a limit against hostile input
KEYS: dict[str, tuple[str, ...]] = {
    "": (
        "format",
        "name",
        "note",
        "parameters",
        "angles",
        "lagrangian",
        "energies",
        "fields",
        "contact",
        "regularisation",
        "g_spot",
        "drawing",
    ),
    "parameters": ("*",),
    "angles": ("*",),
    "angles.*": ("sine", "cosine"),
    "lagrangian": ("coordinates", "mass_matrix", "forces", "time", "constraints"),
    "energies": ("coordinates", "kinetic", "potential", "dissipation", "forces", "time", "constraints"),
    "fields": ("state", "F", "G_T", "G_N"),
    "contact": ("x", "slip_velocity", "slip", "y", "mu"),
    "regularisation": ("k_1", "k_2", "c"),
    "g_spot": ("search", "fixed", "conditions", "point"),
    "g_spot.point": ("*",),
    "drawing": PARTS,
}
"""The keys of each table; ``*`` stands for names that the file chooses."""

_DEPTH = 3  # lists within each other in a drawing: lines, points, two formulas
_MOTIONS = ("lagrangian", "energies", "fields")
_ROBOTS = {
    ".urdf": "from_urdf(path, contact_link=..., mu=...), in Python,",
    ".mjcf": "from_mjcf(path, contact_body=..., mu=...), in Python,",
    ".xml": "from_mjcf(path, contact_body=..., mu=...), or from_urdf where it is URDF, in Python,",
}
"""Files of robots by their suffix, and what reads them."""


def read_mechanism(path: str | Path) -> Mechanism:
    """The mechanism that a TOML file describes.

    :raises MechanismError: the file cannot be read, or a part is missing or wrong; the message names the key.
    """
    refuse_robot(Path(path))
    text = read_text(path)
    try:
        return parse_mechanism(text)
    except MechanismError as error:
        raise MechanismError(f"{path}: {error}") from None


def refuse_robot(path: Path) -> None:
    """Passes for a file of another kind: that of a robot does not say what touches.

    :raises MechanismError: it is one by its suffix; the message names the function that takes it.

    >>> refuse_robot(Path("arm.toml"))
    """
    reader = _ROBOTS.get(path.suffix.lower())
    if reader is not None:
        raise MechanismError(f"{path}: a robot; {reader} makes a mechanism of it: the file does not say what touches")


def read_text(path: str | Path, largest: int = MAX_BYTES) -> str:
    """The text of a file of at most ``largest`` bytes.

    :raises MechanismError: the file cannot be read, is too large, or no UTF-8 text.
    """
    try:
        with Path(path).open("rb") as stream:
            data = stream.read(largest + 1)
    except (OSError, ValueError) as error:  # a path with a null character is a ValueError
        why = getattr(error, "strerror", None) or error
        raise MechanismError(f"{str(path)[:200]}: cannot be read: {why}") from None
    if len(data) > largest:
        raise MechanismError(f"{path}: larger than {largest} bytes")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise MechanismError(f"{path}: not UTF-8 text") from None


def parse_mechanism(text: str) -> Mechanism:
    """The mechanism that a TOML text describes.

    :raises MechanismError: a part is missing or wrong; the message names the key.

    >>> parse_mechanism("format = 1")
    Traceback (most recent call last):
    ...
    gspot_verified.mechanisms.input.mechanism.MechanismError: key "name" is missing
    """
    if len(text) > MAX_BYTES:
        raise MechanismError(f"the text is longer than {MAX_BYTES} characters")
    return mechanism_of_table(toml_table(text))


def mechanism_of_table(top: TomlTable) -> Mechanism:
    """The mechanism that a table with the keys above describes.

    :raises MechanismError: as :func:`parse_mechanism`.
    """
    top.only(KEYS)
    name = top.text("name")
    if not name.strip() or not name.isprintable():
        raise MechanismError('key "name" must be one line of visible text')
    if top.get("format", int, "1") != 1:
        raise MechanismError('key "format" must be 1')
    if top.has("note"):
        top.text("note")
    common = {"name": name[:80], "parameters": top.table("parameters").all_formulas()}
    common |= {"angles": _angles(top.table("angles"))}
    common |= _contact(top.table("contact")) | _g_spot(top.table("g_spot"))
    common |= _regularisation(top.table("regularisation"))
    if top.has("drawing"):
        common["drawing"] = _drawing(top.table("drawing"))
    motions = [word for word in _MOTIONS if top.has(word)]
    if len(motions) != 1:
        raise MechanismError('exactly one of the tables "lagrangian", "energies" and "fields" is needed')
    read = {"lagrangian": _by_lagrangian, "energies": _by_energies, "fields": _by_fields}[motions[0]]
    return read(top.table(motions[0]), common)


def _contact(table: TomlTable) -> dict[str, Any]:
    table.only(KEYS)
    if table.has("x") and table.has("slip_velocity"):
        raise MechanismError('table "contact": x or slip_velocity, not both')
    tangential = "slip_velocity" if table.has("slip_velocity") else "x"
    contact: dict[str, Any] = {"x": None, tangential: table.formula(tangential)}
    if table.has("slip"):
        contact["slip"] = table.text("slip")
    return contact | {"y": table.formula("y"), "mu": table.formula("mu")}


def _regularisation(table: TomlTable) -> dict[str, Any]:
    table.only(KEYS)
    return {"regularisation": table.all_formulas()} if table.names() else {}


def _drawing(table: TomlTable) -> dict[str, Any]:
    table.only(KEYS)
    return {name: table.nested_formulas(name, _DEPTH) for name in table.names()}


def _g_spot(table: TomlTable) -> dict[str, Any]:
    table.only(KEYS)
    g_spot: dict[str, Any] = {"place": table.table("point").all_formulas()}
    if table.has("search"):
        g_spot["search"] = table.get("search", bool, "true or false")
    if table.has("fixed") and table.has("conditions"):
        raise MechanismError('table "g_spot": fixed or conditions, not both')
    if table.has("fixed"):
        g_spot["fixed"] = table.words("fixed")
    if table.has("conditions"):
        g_spot["conditions"] = table.formulas("conditions")
    return g_spot


def _angles(table: TomlTable) -> dict[str, tuple[Any, Any]]:
    angles = {}
    for name in table.names():
        angle = table.table(name)
        angle.only(KEYS, "angles.*")
        angles[name] = (angle.formula("sine"), angle.formula("cosine"))
    return angles


def _by_fields(table: TomlTable, common: dict[str, Any]) -> Mechanism:
    table.only(KEYS)
    return from_fields(
        state=table.words("state"),
        F=table.formulas("F"),
        G_T=table.formulas("G_T"),
        G_N=table.formulas("G_N"),
        **common,
    )


def _by_lagrangian(table: TomlTable, common: dict[str, Any]) -> Mechanism:
    table.only(KEYS)
    rows = table.get("mass_matrix", list, "a list of rows")
    for row in rows:
        if not isinstance(row, list):
            raise MechanismError(
                f'key "{table.key("mass_matrix")}" must be a list of rows, got {shown_value(row)} in it'
            )
    matrix = [[formula_value(entry, table.key("mass_matrix")) for entry in row] for row in rows]
    return lagrangian(mass_matrix=matrix, forces=table.formulas("forces"), **_coordinates(table), **common)


def _by_energies(table: TomlTable, common: dict[str, Any]) -> Mechanism:
    table.only(KEYS)
    options: dict[str, Any] = {"forces": table.formulas("forces")} if table.has("forces") else {}
    if table.has("dissipation"):
        options["dissipation"] = table.formula("dissipation")
    kinetic, potential = table.formula("kinetic"), table.formula("potential")
    return from_energies(kinetic=kinetic, potential=potential, **options, **_coordinates(table), **common)


def _coordinates(table: TomlTable) -> dict[str, Any]:
    return {
        "coordinates": table.words("coordinates"),
        "time": table.text("time") if table.has("time") else None,
        "constraints": table.formulas("constraints") if table.has("constraints") else (),
    }
