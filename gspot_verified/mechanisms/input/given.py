"""Make a mechanism from formulas: from a mass matrix and forces, from its energies, or from its vector fields.

What reads them knows the names of the mechanism and its limits, and its messages say where.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from copy import copy
from dataclasses import dataclass, replace
from typing import Any

from gspot_verified.expansion.series.regularisation import PAPER, Regularisation
from gspot_verified.functions.derivative import ONE, ZERO, partial_derivative
from gspot_verified.functions.expressions import Expression, Variable
from gspot_verified.mechanisms.formulas.formula import parse_formula
from gspot_verified.mechanisms.formulas.names import FormulaError, alike, check_name, nearest, normal_name
from gspot_verified.mechanisms.formulas.rewriting import along, simplified
from gspot_verified.mechanisms.formulas.simplify import constant, minus, negative, sum_of
from gspot_verified.mechanisms.formulas.symbol import SLIP_SPEED, Symbol, count_operations, variable_indices
from gspot_verified.mechanisms.input.drawing import DrawingReader
from gspot_verified.mechanisms.input.mechanism import (
    Drawing,
    Fields,
    Lagrangian,
    Mechanism,
    MechanismError,
    Place,
    ReferenceAngle,
    exact_rational,
)
from gspot_verified.numbers.balls import ExactInput

Formula = str | int | Any
"""A text in the language of :mod:`formula`, an int, or a sympy expression."""

MAX_STATE = 40  # components; this and the next two: limits against hostile input
MAX_PARAMETERS = 500  # far more than a mechanism has
MAX_OPERATIONS = 2000  # in all formulas together


@dataclass(frozen=True)
class Contact:
    """The contact as the user gives it: x or the slip velocity, y, mu, and in which direction it slips."""

    x: Formula | None
    y: Formula
    mu: Formula
    slip_velocity: Formula | None = None
    slip: str = "positive"


class FormulaReader:
    """Reads formulas; knows the names of one mechanism."""

    def __init__(
        self,
        name: str,
        state: tuple[str, ...],
        parameters: Mapping[str, Any],
        angles: Mapping[str, tuple[ExactInput, ExactInput]],
    ) -> None:
        self._name, self._operations = name, 0
        if len(state) > MAX_STATE:
            raise MechanismError(f"{name}: at most {MAX_STATE} components of the state, got {len(state)}")
        if len(parameters) > MAX_PARAMETERS:
            raise MechanismError(f"{name}: at most {MAX_PARAMETERS} parameters, got {len(parameters)}")
        self.state = self._names(state)
        for angle in angles:
            self.component(angle, "angle")
        self._angles = tuple(
            ReferenceAngle(
                normal_name(angle),
                exact_rational(pair[0], f"sine of {angle}"),
                exact_rational(pair[1], f"cosine of {angle}"),
            )
            for angle, pair in angles.items()
        )
        words = self._names([*parameters, *(angle.name for angle in self._angles)])
        twice = next((word for word in words if word in self.state), None)
        if twice is not None:
            raise MechanismError(f"{name}: the name {twice!r} is used twice")
        if pair := alike([*self.state, *words]):
            raise MechanismError(f"{name}: the names {pair[0]!a} and {pair[1]!a} look alike: one has a Greek letter")
        self._constants: dict[str, Expression] = {word: Symbol(word) for word in words}
        self._all = {word: Variable(i) for i, word in enumerate(self.state)} | self._constants
        only = {word: self._constants[word] for word in words[: len(parameters)]}
        self._parameters = tuple(
            (word, None if value is None else self._read(value, f"parameter {word}", only))
            for word, value in zip(words, parameters.values(), strict=False)
        )

    def _names(self, words: Sequence[str]) -> tuple[str, ...]:
        try:
            checked = tuple(check_name(word) for word in words)
        except FormulaError as error:
            raise MechanismError(f"{self._name}: {error}") from None
        for i, word in enumerate(checked):
            if word in checked[:i]:
                raise MechanismError(f"{self._name}: the name {word!r} is used twice")
        return checked

    def component(self, word: str, where: str) -> str:
        """The name, if it is one of a component of the state."""
        if normal_name(word) not in self.state:
            raise MechanismError(
                f"{self._name}: {where} {word[:40]!r} is no component of the state{nearest(word, self.state)}; "
                f"it has: {', '.join(self.state)}"
            )
        return normal_name(word)

    def __call__(self, formula: Formula, where: str) -> Expression:
        """A formula of the state, the parameters and the reference angles.

        :raises MechanismError: it is none; the message says where.
        """
        return self._read(formula, where, self._all)

    def _read(self, formula: Any, where: str, names: Mapping[str, Expression]) -> Expression:
        try:
            expression = self._expression(formula, where, names)
        except (TypeError, ValueError, ZeroDivisionError) as error:
            raise MechanismError(f"{self._name}: {where}: {error}") from None
        self._operations += count_operations(expression)
        if self._operations > MAX_OPERATIONS:
            raise MechanismError(f"{self._name}: the formulas have more than {MAX_OPERATIONS} operations")
        return expression

    def _expression(self, formula: Any, where: str, names: Mapping[str, Expression]) -> Expression:
        if isinstance(formula, str):
            return parse_formula(formula, names)
        if hasattr(formula, "free_symbols"):
            from gspot_verified.mechanisms.formulas.in_sympy import from_sympy

            return from_sympy(formula, names)
        return constant(exact_rational(formula, where))

    def all(self, formulas: Sequence[Formula], what: str) -> tuple[Expression, ...]:
        """Several formulas, numbered in messages."""
        return tuple(self(formula, f"{what} {i + 1}") for i, formula in enumerate(formulas))

    def _regularisation(self, given: Mapping[str, ExactInput] | None) -> Regularisation:
        """The compliance of the contact; a constant that is missing has the paper's value 1."""
        if given is None:
            return PAPER
        if set(given) - {"k_1", "k_2", "c"}:
            raise MechanismError(f"{self._name}: regularisation: the constants are k_1, k_2, c, got {sorted(given)}")
        try:
            return Regularisation.of(**{"k_1": 1, "k_2": 1, "c": 1} | dict(given))
        except (TypeError, ValueError) as error:
            raise MechanismError(f"{self._name}: regularisation: {error}") from None

    def mechanism(self, motion: Any, contact: Contact, place: Mapping[str, Any], **options: Any) -> Mechanism:
        """Puts the parts together; ``options`` are those of :class:`Place`, ``regularisation``, and ``drawing``."""
        x, slip_velocity, mirrored = self._tangential(contact)
        values = tuple(
            (self.component(word, "G-spot:"), self._read(value, f"G-spot, {word}", self._constants))
            for word, value in place.items()
        )
        twice = next((word for i, (word, _) in enumerate(values) if word in dict(values[:i])), None)
        if twice is not None:
            raise MechanismError(f"{self._name}: G-spot: {twice} is given twice")
        given = dict(options)
        regularisation = self._regularisation(given.pop("regularisation", None))
        drawing = self._drawing(motion, contact, given.pop("drawing", None))
        if given.get("conditions") is not None:
            given["conditions"] = tuple(self(f, f"condition {i + 1}") for i, f in enumerate(given["conditions"]))
        if given.get("fixed") is not None:
            given["fixed"] = tuple(self.component(word, "G-spot:") for word in given["fixed"])
        g_spot_place = Place(values, **given)
        y, mu = self(contact.y, "y"), self._friction(contact.mu)
        if mirrored and isinstance(motion, Fields):
            motion = replace(motion, G_T=tuple(map(negative, motion.G_T)))
        return Mechanism(
            name=self._name,
            state=self.state,
            motion=motion,
            x=x,
            y=y,
            mu=mu,
            parameters=self._parameters,
            angles=self._angles,
            place=g_spot_place,
            slip_velocity=slip_velocity,
            mirrored=mirrored,
            regularisation=regularisation,
            drawing=drawing,
        )

    def _friction(self, formula: Formula) -> Expression:
        """It may depend on the slip speed, too, where the mechanism has no name like that of its own."""
        return self._read(formula, "mu", {SLIP_SPEED: Symbol(SLIP_SPEED), **self._all})

    def _drawing(self, motion: Any, contact: Contact, given: Mapping[str, Any] | None) -> Drawing | None:
        """Its operations are counted apart: a drawing makes no mechanism too large."""
        if given is None:
            return None
        own = copy(self)
        own._operations = 0
        half = len(motion.coordinates) if isinstance(motion, Lagrangian) else 0
        velocities = {i: self.state[i] for i in range(half, 2 * half)}
        point = None if contact.x is None else (contact.x, contact.y)
        return DrawingReader(self._name, own, velocities)(given, point)

    def _tangential(self, contact: Contact) -> tuple[Expression | None, Expression | None, bool]:
        """x, or the slip velocity; the other way round for negative slip."""
        if (contact.x is None) == (contact.slip_velocity is None):
            raise MechanismError(f"{self._name}: the contact needs either x or slip_velocity")
        if contact.slip not in ("positive", "negative"):
            raise MechanismError(f"{self._name}: slip must be 'positive' or 'negative', got {contact.slip!r:.40}")
        mirrored = contact.slip == "negative"
        if contact.x is not None:
            x = self(contact.x, "x")
            return negative(x) if mirrored else x, None, mirrored
        velocity = self(contact.slip_velocity, "slip_velocity")
        return None, negative(velocity) if mirrored else velocity, mirrored


MAX_COORDINATES = 12  # the inverse of the mass matrix grows fast with their number

Parameters = Mapping[str, Formula | ExactInput | None]
Angles = Mapping[str, tuple[ExactInput, ExactInput]]


def lagrangian(
    name: str,
    coordinates: Sequence[str],
    mass_matrix: Sequence[Sequence[Formula]],
    forces: Sequence[Formula],
    x: Formula | None,
    y: Formula,
    mu: Formula,
    parameters: Parameters | None = None,
    angles: Angles | None = None,
    place: Mapping[str, Formula] | None = None,
    time: str | None = None,
    constraints: Sequence[Formula] = (),
    slip_velocity: Formula | None = None,
    slip: str = "positive",
    **options: Any,
) -> Mechanism:
    """A mechanism given by M(q), f(q, q', t), the contact point x(q, t), y(q, t) and the friction coefficient.

    ``angles`` maps a coordinate to the (sine, cosine) of its reference angle. A parameter with the value None stays a
    symbol. ``constraints`` are functions of q and t that vanish along every motion; their multipliers are solved for.
    In the place of x (then None) ``slip_velocity`` may be given, linear in the velocities: a belt, a rolling contact;
    its derivatives by the velocities are the direction of the friction force. For ``slip`` "negative" the library
    mirrors: x, or the slip velocity, counts in the other direction, and ``Mechanism.notes`` says so.
    ``options``: ``search``, ``fixed``, ``conditions`` of :class:`Place`; ``regularisation``, the numbers k_1, k_2, c of
    :class:`expansion.series.regularisation.Regularisation` by name; ``drawing``, for pictures alone: ``lines``,
    ``circles``, ``points``, ``contact``, ``normal`` by name, as the table of a file has them
    (:mod:`gspot_verified.mechanisms.input.file`).

    :raises MechanismError: shapes that do not fit, a mass matrix that is not symmetric, an unknown name.

    >>> drop = lagrangian("drop", ["x", "y"], [[1, 0], [0, 1]], [0, "-g"], "x", "y", "1/2", {"g": 1})
    >>> drop.state
    ('x', 'y', 'x_dot', 'y_dot')
    """
    read, n = _coordinates(name, coordinates, time, parameters, angles)
    if len(mass_matrix) != n or any(isinstance(row, str) or len(row) != n for row in mass_matrix):
        raise MechanismError(f"{name}: the mass matrix must have {n} rows of {n} formulas")
    if len(forces) != n:
        raise MechanismError(f"{name}: {n} forces, one for each coordinate, got {len(forces)}")
    rows = tuple(
        tuple(read(entry, f"mass matrix entry ({i + 1}, {j + 1})") for j, entry in enumerate(row))
        for i, row in enumerate(mass_matrix)
    )
    right = read.all(forces, "force")
    motion = Lagrangian(read.state[:n], rows, right, _time(read, time), _constraints(name, read, constraints, n))
    return read.mechanism(motion, Contact(x, y, mu, slip_velocity, slip), place or {}, **options)


def from_energies(
    name: str,
    coordinates: Sequence[str],
    kinetic: Formula,
    potential: Formula,
    x: Formula | None,
    y: Formula,
    mu: Formula,
    parameters: Parameters | None = None,
    angles: Angles | None = None,
    place: Mapping[str, Formula] | None = None,
    time: str | None = None,
    forces: Sequence[Formula] | None = None,
    dissipation: Formula = 0,
    constraints: Sequence[Formula] = (),
    slip_velocity: Formula | None = None,
    slip: str = "positive",
    **options: Any,
) -> Mechanism:
    """A mechanism given by T(q, q', t), V(q, t), further generalised forces and Rayleigh's dissipation function.

    Lagrange's equations, d/dt (dT/dq') - d(T - V)/dq = Q - dD/dq' + contact forces, give M = d^2 T/dq'^2 and
    f = Q - dD/dq' + d(T - V)/dq - (the rate of dT/dq' at q'' = 0). The other arguments as in :func:`lagrangian`.

    :raises MechanismError: T is not quadratic in the velocities, V depends on them, or as in :func:`lagrangian`.

    >>> drop = from_energies("drop", ["x", "y"], "(x_dot^2 + y_dot^2)/2", "g*y", "x", "y", "1/2", {"g": 1})
    >>> drop == lagrangian("drop", ["x", "y"], [[1, 0], [0, 1]], [0, "-g"], "x", "y", "1/2", {"g": 1})
    True
    """
    read, n = _coordinates(name, coordinates, time, parameters, angles)
    if forces is not None and len(forces) != n:
        raise MechanismError(f"{name}: {n} forces, one for each coordinate, got {len(forces)}")
    T, V = read(kinetic, "kinetic energy"), read(potential, "potential energy")
    loss = read(dissipation, "dissipation function")
    applied = read.all(forces, "force") if forces is not None else (ZERO,) * n
    m = len(read.state)
    velocities = range(n, 2 * n)
    if variable_indices([V]) & set(velocities):
        raise MechanismError(f"{name}: the potential energy must not depend on velocities")
    glide = [*(Variable(i) for i in velocities), *[ZERO] * n, *[ONE] * (m - 2 * n)]
    momenta = _gradient(T, velocities, m)
    rows = tuple(tuple(_gradient(momentum, velocities, m)) for momentum in momenta)
    if variable_indices([entry for row in rows for entry in row]) & set(velocities):
        raise MechanismError(f"{name}: the kinetic energy must be quadratic in the velocities")
    kinetic_slopes, slopes = _gradient(T, range(n), m), _gradient(V, range(n), m)
    losses = _gradient(loss, velocities, m)
    right = tuple(
        sum_of(applied[i], negative(losses[i]), minus(kinetic_slopes[i], slopes[i]), negative(along(glide, momenta[i])))
        for i in range(n)
    )
    motion = Lagrangian(read.state[:n], rows, right, _time(read, time), _constraints(name, read, constraints, n))
    return read.mechanism(motion, Contact(x, y, mu, slip_velocity, slip), place or {}, **options)


def from_fields(
    name: str,
    state: Sequence[str],
    F: Sequence[Formula],
    G_T: Sequence[Formula],
    G_N: Sequence[Formula],
    x: Formula | None,
    y: Formula,
    mu: Formula,
    parameters: Parameters | None = None,
    angles: Angles | None = None,
    place: Mapping[str, Formula] | None = None,
    slip_velocity: Formula | None = None,
    slip: str = "positive",
    **options: Any,
) -> Mechanism:
    """A mechanism given by the vector fields F, G_T, G_N; the other arguments as in :func:`lagrangian`.

    With ``slip`` "negative" the direction of G_T is mirrored with x.

    :raises MechanismError: shapes that do not fit, or an unknown name.

    >>> from_fields("fall", ["y", "v"], ["v", -1], [0, 0], [0, 1], 0, "y", 0).state
    ('y', 'v')
    """
    for label, vector in (("F", F), ("G_T", G_T), ("G_N", G_N)):
        if isinstance(vector, str) or len(vector) != len(state):
            raise MechanismError(
                f"{name}: {label} must have {len(state)} formulas, one for each component of the state"
            )
    read = FormulaReader(name, tuple(state), parameters or {}, angles or {})
    motion = Fields(read.all(F, "F, component"), read.all(G_T, "G_T, component"), read.all(G_N, "G_N, component"))
    return read.mechanism(motion, Contact(x, y, mu, slip_velocity, slip), place or {}, **options)


def _coordinates(
    name: str, coordinates: Sequence[str], time: str | None, parameters: Parameters | None, angles: Angles | None
) -> tuple[FormulaReader, int]:
    """A reader that knows the coordinates q, the velocities and the time."""
    if not 1 <= len(coordinates) <= MAX_COORDINATES:
        raise MechanismError(f"{name}: between 1 and {MAX_COORDINATES} coordinates, got {len(coordinates)}")
    state = (*coordinates, *(f"{q}_dot" for q in coordinates), *([time] if time else []))
    return FormulaReader(name, state, parameters or {}, angles or {}), len(coordinates)


def _time(read: FormulaReader, time: str | None) -> str | None:
    return read.state[-1] if time else None


def _constraints(name: str, read: FormulaReader, formulas: Sequence[Formula], n: int) -> tuple[Expression, ...]:
    if len(formulas) >= n:
        raise MechanismError(f"{name}: {len(formulas)} constraints leave none of the {n} coordinates free")
    return read.all(formulas, "constraint")


def _gradient(function: Expression, indices: range, m: int) -> list[Expression]:
    return simplified(*(partial_derivative(function, i, m) for i in indices))
