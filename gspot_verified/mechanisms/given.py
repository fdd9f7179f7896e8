"""Make a mechanism from formulas: from a mass matrix and forces, or from its vector fields."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from gspot_verified.balls import ExactInput
from gspot_verified.expansion.expressions import Expression, Variable
from gspot_verified.mechanisms.formula import FormulaError, check_name, nearest, normal_name, parse_formula
from gspot_verified.mechanisms.mechanism import (
    Fields,
    Lagrangian,
    Mechanism,
    MechanismError,
    Place,
    ReferenceAngle,
    exact_rational,
)
from gspot_verified.mechanisms.simplify import constant, product_of, sum_of
from gspot_verified.mechanisms.symbol import Symbol, count_operations

Formula = str | int | Any
"""A text in the language of :mod:`formula`, an int, or a sympy expression."""

MAX_COORDINATES = 12
MAX_STATE = 40
MAX_PARAMETERS = 500
MAX_OPERATIONS = 2000


def lagrangian(
    name: str,
    coordinates: Sequence[str],
    mass_matrix: Sequence[Sequence[Formula]],
    forces: Sequence[Formula],
    x: Formula,
    y: Formula,
    mu: Formula,
    parameters: Mapping[str, Formula | ExactInput | None] | None = None,
    angles: Mapping[str, tuple[ExactInput, ExactInput]] | None = None,
    place: Mapping[str, Formula] | None = None,
    time: str | None = None,
    **options: Any,
) -> Mechanism:
    """A mechanism given by M(q), f(q, q', t), the contact point x(q, t), y(q, t) and the friction coefficient.

    ``angles`` maps a coordinate to the (sine, cosine) of its reference angle. A parameter with the value None stays a
    symbol. ``options``: ``search``, ``fixed``, ``conditions`` of :class:`Place`.

    :raises MechanismError: shapes that do not fit, a mass matrix that is not symmetric, an unknown name.

    >>> drop = lagrangian("drop", ["x", "y"], [[1, 0], [0, 1]], [0, "-g"], "x", "y", "1/2", {"g": 1})
    >>> drop.state
    ('x', 'y', 'x_dot', 'y_dot')
    """
    coordinates = tuple(coordinates)
    if not 1 <= len(coordinates) <= MAX_COORDINATES:
        raise MechanismError(f"{name}: between 1 and {MAX_COORDINATES} coordinates, got {len(coordinates)}")
    n = len(coordinates)
    if len(mass_matrix) != n or any(isinstance(row, str) or len(row) != n for row in mass_matrix):
        raise MechanismError(f"{name}: the mass matrix must have {n} rows of {n} formulas")
    if len(forces) != n:
        raise MechanismError(f"{name}: {n} forces, one for each coordinate, got {len(forces)}")
    state = (*coordinates, *(f"{q}_dot" for q in coordinates), *([time] if time else []))
    read = _Reader(name, state, parameters or {}, angles or {})
    rows = tuple(
        tuple(read(entry, f"mass matrix entry ({i + 1}, {j + 1})") for j, entry in enumerate(row))
        for i, row in enumerate(mass_matrix)
    )
    _check_symmetric(name, rows, read.state)
    right = tuple(read(f, f"force {i + 1}") for i, f in enumerate(forces))
    motion = Lagrangian(read.state[:n], rows, right, read.state[-1] if time else None)
    return read.mechanism(motion, x, y, mu, place or {}, options)


def from_fields(
    name: str,
    state: Sequence[str],
    F: Sequence[Formula],
    G_T: Sequence[Formula],
    G_N: Sequence[Formula],
    x: Formula,
    y: Formula,
    mu: Formula,
    parameters: Mapping[str, Formula | ExactInput | None] | None = None,
    angles: Mapping[str, tuple[ExactInput, ExactInput]] | None = None,
    place: Mapping[str, Formula] | None = None,
    **options: Any,
) -> Mechanism:
    """A mechanism given by the vector fields F, G_T, G_N; the other arguments as in :func:`lagrangian`.

    :raises MechanismError: shapes that do not fit, or an unknown name.

    >>> from_fields("fall", ["y", "v"], ["v", -1], [0, 0], [0, 1], 0, "y", 0).state
    ('y', 'v')
    """
    state = tuple(state)
    for label, vector in (("F", F), ("G_T", G_T), ("G_N", G_N)):
        if isinstance(vector, str) or len(vector) != len(state):
            raise MechanismError(
                f"{name}: {label} must have {len(state)} formulas, one for each component of the state"
            )
    read = _Reader(name, state, parameters or {}, angles or {})
    motion = Fields(
        tuple(read(f, f"F, component {i + 1}") for i, f in enumerate(F)),
        tuple(read(f, f"G_T, component {i + 1}") for i, f in enumerate(G_T)),
        tuple(read(f, f"G_N, component {i + 1}") for i, f in enumerate(G_N)),
    )
    return read.mechanism(motion, x, y, mu, place or {}, options)


class _Reader:
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
        return self._read(formula, where, self._all)

    def _read(self, formula: Any, where: str, names: Mapping[str, Expression]) -> Expression:
        try:
            found = self._expression(formula, where, names)
        except (TypeError, ValueError, ZeroDivisionError) as error:
            raise MechanismError(f"{self._name}: {where}: {error}") from None
        self._operations += count_operations(found)
        if self._operations > MAX_OPERATIONS:
            raise MechanismError(f"{self._name}: the formulas have more than {MAX_OPERATIONS} operations")
        return found

    def _expression(self, formula: Any, where: str, names: Mapping[str, Expression]) -> Expression:
        if isinstance(formula, str):
            return parse_formula(formula, names)
        if hasattr(formula, "free_symbols"):
            from gspot_verified.mechanisms.in_sympy import from_sympy

            return from_sympy(formula, names)
        return constant(exact_rational(formula, where))

    def mechanism(
        self, motion: Any, x: Any, y: Any, mu: Any, place: Mapping[str, Any], options: Mapping[str, Any]
    ) -> Mechanism:
        """Puts the parts together."""
        values = tuple(
            (self.component(word, "G-spot:"), self._read(value, f"G-spot, {word}", self._constants))
            for word, value in place.items()
        )
        given = dict(options)
        if given.get("conditions") is not None:
            given["conditions"] = tuple(self(f, f"condition {i + 1}") for i, f in enumerate(given["conditions"]))
        if given.get("fixed") is not None:
            given["fixed"] = tuple(self.component(word, "G-spot:") for word in given["fixed"])
        found = Place(values, **given)
        parts = self(x, "x"), self(y, "y"), self(mu, "mu")
        return Mechanism(self._name, self.state, motion, *parts, self._parameters, self._angles, found)


def _check_symmetric(name: str, rows: tuple[tuple[Expression, ...], ...], state: tuple[str, ...]) -> None:
    for i, row in enumerate(rows):
        for j in range(i):
            if sum_of(row[j], product_of(constant(-1), rows[j][i])) is not constant(0):
                _check_equal(name, row[j], rows[j][i], (i + 1, j + 1), state)


def _check_equal(
    name: str, below: Expression, above: Expression, place: tuple[int, int], state: tuple[str, ...]
) -> None:
    """Two entries of the mass matrix, in sympy: equal after they are multiplied out."""
    import sympy

    from gspot_verified.mechanisms.in_sympy import to_sympy

    first, second = to_sympy(below, state), to_sympy(above, state)
    if sympy.expand(first - second) != 0:
        i, j = place
        raise MechanismError(
            f"{name}: the mass matrix is not symmetric: entry ({i}, {j}) is {first}, entry ({j}, {i}) is {second}"
        )
