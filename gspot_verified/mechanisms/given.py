"""Make a mechanism from formulas: from a mass matrix and forces, or from its vector fields."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from gspot_verified.balls import ExactInput
from gspot_verified.mechanisms.formula import FormulaError, check_name, parse_formula
from gspot_verified.mechanisms.mechanism import (
    Fields,
    Lagrangian,
    Mechanism,
    MechanismError,
    Place,
    ReferenceAngle,
    exact_rational,
    sympy_number,
)

Formula = str | int | Any
"""A text in the language of :mod:`formula`, an int, or a sympy expression."""

MAX_COORDINATES = 6
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
    _check_symmetric(name, rows)
    motion = Lagrangian(coordinates, rows, tuple(read(f, f"force {i + 1}") for i, f in enumerate(forces)), time)
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
        import sympy

        self._name, self._state = name, state
        self._operations = 0
        for angle in angles:
            if angle not in state:
                raise MechanismError(f"{name}: angle {angle!r} is no component of the state")
        self._angles = tuple(
            ReferenceAngle(
                angle, exact_rational(pair[0], f"sine of {angle}"), exact_rational(pair[1], f"cosine of {angle}")
            )
            for angle, pair in angles.items()
        )
        words = [*state, *parameters, *(angle.name for angle in self._angles)]
        try:
            table = {check_name(word): sympy.Symbol(word) for word in words}
        except FormulaError as error:
            raise MechanismError(f"{name}: {error}") from None
        if len(table) != len(words):
            twice = next(word for word in words if words.count(word) > 1)
            raise MechanismError(f"{name}: the name {twice!r} is used twice")
        self._all = table
        self._constants = {word: symbol for word, symbol in table.items() if word not in state}
        only = {word: table[word] for word in parameters}
        self._parameters = tuple(
            (word, None if value is None else self._read(value, f"parameter {word}", only))
            for word, value in parameters.items()
        )

    def __call__(self, formula: Formula, where: str) -> Any:
        return self._read(formula, where, self._all)

    def _read(self, formula: Any, where: str, names: Mapping[str, Any]) -> Any:
        import sympy

        if isinstance(formula, sympy.Basic):
            self._count(formula)
            unknown = formula.free_symbols - set(names.values())
            if unknown or formula.has(sympy.Float, sympy.nan, sympy.oo, sympy.zoo):
                raise MechanismError(
                    f"{self._name}: {where}: not exact, or unknown symbols {sorted(map(str, unknown))}"
                )
            return formula
        try:
            found = parse_formula(formula, names) if isinstance(formula, str) else sympy_number(formula, where)
        except (TypeError, ValueError) as error:
            raise MechanismError(f"{self._name}: {where}: {error}") from None
        self._count(found)
        return found

    def _count(self, formula: Any) -> None:
        self._operations += int(formula.count_ops())
        if self._operations > MAX_OPERATIONS:
            raise MechanismError(f"{self._name}: the formulas have more than {MAX_OPERATIONS} operations")

    def mechanism(
        self, motion: Any, x: Any, y: Any, mu: Any, place: Mapping[str, Any], options: Mapping[str, Any]
    ) -> Mechanism:
        """Puts the parts together."""
        for word in (*place, *(options.get("fixed") or ())):
            if word not in self._state:
                raise MechanismError(f"{self._name}: G-spot: {word!r} is no component of the state")
        values = tuple((word, self._read(value, f"G-spot, {word}", self._constants)) for word, value in place.items())
        given = dict(options)
        if given.get("conditions") is not None:
            given["conditions"] = tuple(self(f, f"condition {i + 1}") for i, f in enumerate(given["conditions"]))
        if given.get("fixed") is not None:
            given["fixed"] = tuple(given["fixed"])
        found = Place(values, **given)
        parts = self(x, "x"), self(y, "y"), self(mu, "mu")
        return Mechanism(self._name, self._state, motion, *parts, self._parameters, self._angles, found)


def _check_symmetric(name: str, rows: tuple[tuple[Any, ...], ...]) -> None:
    import sympy

    for i, row in enumerate(rows):
        for j in range(i):
            if sympy.expand(row[j] - rows[j][i]) != 0:
                raise MechanismError(
                    f"{name}: the mass matrix is not symmetric: entry ({i + 1}, {j + 1}) is {row[j]}, "
                    f"entry ({j + 1}, {i + 1}) is {rows[j][i]}"
                )
