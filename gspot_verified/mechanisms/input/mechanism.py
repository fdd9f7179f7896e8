"""A mechanical system with one frictional contact, given symbolically: by a mass matrix and forces, or by its fields.

Paper, Sec. 2. All numbers are exact. Velocities of the coordinate ``phi`` are called ``phi_dot``. For an angle with a
rational sine and cosine at the G-spot, the reference angle ``phi_ref`` may stand in formulas (``phi - phi_ref - 1/4``).
Formulas are expressions: component i of the state is ``Variable(i)``, parameters and reference angles are symbols.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from flint import fmpq

from gspot_verified.expansion.series.regularisation import NO_DAMPER, PAPER, Regularisation
from gspot_verified.functions.derivative import ZERO
from gspot_verified.functions.expressions import Expression
from gspot_verified.mechanisms.formulas.in_sympy import to_sympy
from gspot_verified.mechanisms.formulas.names import nearest
from gspot_verified.mechanisms.formulas.rewriting import replaced
from gspot_verified.mechanisms.formulas.simplify import NoNumberError, constant, minus, rational_value
from gspot_verified.mechanisms.formulas.symbol import Symbol, symbol_names
from gspot_verified.mechanisms.input.planar_links import PlanarLinks
from gspot_verified.numbers.balls import ExactInput, exact
from gspot_verified.numbers.written import Shown


class MechanismError(ValueError):
    """The description of the mechanism is wrong; the message names the part."""


@dataclass(frozen=True)
class ReferenceAngle:
    """The angle ``<coordinate>_ref``, known by its exact sine and cosine."""

    coordinate: str
    sine: fmpq
    cosine: fmpq

    def __post_init__(self) -> None:
        if self.sine * self.sine + self.cosine * self.cosine != 1:
            raise MechanismError(
                f"angle {self.coordinate}: sine {self.sine} and cosine {self.cosine} must satisfy sine^2 + cosine^2 = 1"
            )

    @property
    def name(self) -> str:
        """How the reference angle is called in formulas."""
        return f"{self.coordinate}_ref"


@dataclass(frozen=True)
class Lagrangian:
    """M(q) q'' = f(q, q', t) + (dy/dq) λ_N + (du/dq') λ_T + the forces of the constraints; du/dq' is dx/dq if u = x'.

    ``constraints`` are functions of q and t that vanish; their multipliers are solved for (index reduction: the
    second derivatives of the constraints vanish along every motion, at the G-spot they and their rates vanish).

    :raises MechanismError: shapes that do not fit, or a mass matrix that is not symmetric.
    """

    coordinates: tuple[str, ...]
    mass_matrix: tuple[tuple[Expression, ...], ...]
    forces: tuple[Expression, ...]
    time: str | None
    constraints: tuple[Expression, ...] = ()

    def __post_init__(self) -> None:
        n, rows = len(self.coordinates), self.mass_matrix
        if {n} != {len(rows), len(self.forces), *map(len, rows)}:
            raise MechanismError(f"{n} coordinates need a mass matrix with {n} rows of {n} formulas, and {n} forces")
        for i, row in enumerate(rows):
            for j in range(i):
                if minus(row[j], rows[j][i]) is not ZERO:
                    self._check_equal(row[j], rows[j][i], (i + 1, j + 1))

    @property
    def formulas(self) -> tuple[Expression, ...]:
        """The mass matrix row by row, the forces, the constraints."""
        return (*(entry for row in self.mass_matrix for entry in row), *self.forces, *self.constraints)

    @property
    def state(self) -> tuple[str, ...]:
        """The coordinates, their velocities, and the time where it is explicit."""
        return (*self.coordinates, *(f"{q}_dot" for q in self.coordinates), *([self.time] if self.time else []))

    def _check_equal(self, below: Expression, above: Expression, place: tuple[int, int]) -> None:
        """Two entries of the mass matrix, in sympy: equal after they are multiplied out."""
        import sympy

        first, second = to_sympy(below, self.state), to_sympy(above, self.state)
        if sympy.expand(first - second) != 0:
            i, j = place
            raise MechanismError(
                f"the mass matrix is not symmetric: entry ({i}, {j}) is {first}, entry ({j}, {i}) is {second}"
            )


@dataclass(frozen=True)
class Fields:
    """dξ/dt = F + G_T λ_T + G_N λ_N; paper, eq. genTN."""

    F: tuple[Expression, ...]
    G_T: tuple[Expression, ...]
    G_N: tuple[Expression, ...]

    @property
    def formulas(self) -> tuple[Expression, ...]:
        """F, G_T, G_N."""
        return (*self.F, *self.G_T, *self.G_N)


@dataclass(frozen=True)
class Place:
    """Where the G-spot is: a value for each component of the state.

    With ``search`` they are the start of Newton's method. ``fixed`` names the m - 4 components that keep their value,
    or ``conditions`` gives m - 4 functions J of the state that vanish; otherwise components are chosen.
    """

    values: tuple[tuple[str, Expression], ...] = ()
    search: bool = False
    fixed: tuple[str, ...] | None = None
    conditions: tuple[Expression, ...] | None = None


@dataclass(frozen=True)
class Drawing:
    """How the bodies look, for pictures alone: formulas of coordinates, parameters and reference angles.

    ``lines`` go from point to point, ``circles`` have a centre and a radius, or two half axes and the angle of the
    first, ``points`` are marked. ``contact`` is the contact point in the drawing; the surface lies at the distance y
    from it, against the direction of ``normal``.
    """

    lines: tuple[tuple[tuple[Expression, ...], ...], ...]
    circles: tuple[tuple[Expression, ...], ...]
    points: tuple[tuple[Expression, ...], ...]
    contact: tuple[Expression, ...]
    normal: tuple[Expression, ...]


@dataclass(frozen=True)
class Mechanism(Shown):
    """A mechanism; make one with :func:`given.lagrangian`, :func:`given.from_energies`, :func:`given.from_fields` or
    :func:`file.read_mechanism`.

    Either ``x`` or ``slip_velocity`` is given. ``mirrored`` says that x, or the slip velocity, has the opposite sign of
    what the user gave: negative slip there is positive slip here. ``drawing``, and ``bodies`` for other programs, are
    no part of what a mechanism is: two that differ in nothing else are equal. ``remarks`` say what a reader must know
    of how it came in. ``assumed``: pairs such as (parameter, "positive"), in sympy's words, where formulas were
    simplified under that.

    :raises MechanismError: the contact has both or none of them, the state is not that of the motion, or a parameter
        has not the value that was assumed.
    """

    name: str
    state: tuple[str, ...]
    motion: Lagrangian | Fields
    x: Expression | None
    y: Expression
    mu: Expression
    parameters: tuple[tuple[str, Expression | None], ...] = ()
    angles: tuple[ReferenceAngle, ...] = ()
    place: Place = field(default_factory=Place)
    slip_velocity: Expression | None = None
    mirrored: bool = False
    regularisation: Regularisation = PAPER
    drawing: Drawing | None = field(default=None, compare=False)
    remarks: tuple[str, ...] = ()
    assumed: tuple[tuple[str, str], ...] = ()
    bodies: PlanarLinks | None = field(default=None, compare=False, repr=False)

    def __post_init__(self) -> None:
        motion, m = self.motion, len(self.state)
        if (self.x is None) == (self.slip_velocity is None):
            raise MechanismError(f"{self.name}: the contact needs either x or slip_velocity")
        if isinstance(motion, Fields):
            fits = {m} == {len(motion.F), len(motion.G_T), len(motion.G_N)}
        else:
            fits = self.state == motion.state
        if not fits:
            raise MechanismError(f"{self.name}: the state {', '.join(self.state)} is not that of the motion")
        self._check_assumed()

    @property
    def formulas(self) -> tuple[Expression, ...]:
        """x or the slip velocity, y, mu, then those of the motion: from these the functions of Sec. 2 are derived."""
        slip = (each for each in (self.x, self.slip_velocity) if each is not None)
        return (*slip, self.y, self.mu, *self.motion.formulas)

    def __str__(self) -> str:
        parameters = ", ".join(name for name, _ in self.parameters) or "none"
        first = f"{self.name}: a mechanism with the state {', '.join(self.state)}; parameters: {parameters}"
        return "\n".join([first, *(f"  note: {note}" for note in self.notes)])

    def with_parameters(self, **values: ExactInput | None) -> Mechanism:
        """The same mechanism with other values of some parameters; None makes a parameter a symbol.

        :raises MechanismError: there is no such parameter, the value is not an exact rational, or not as was assumed.
        """
        known = dict(self.parameters)
        for name, value in values.items():
            if name not in known:
                raise MechanismError(
                    f"{self.name} has no parameter {name!r}{nearest(name, known)}; it has: {', '.join(known) or 'none'}"
                )
            known[name] = None if value is None else constant(exact_rational(value, name))
        return replace(self, parameters=tuple(known.items()))

    def changed(self, **values: ExactInput | None) -> Mechanism:
        """As :meth:`with_parameters`; the name says which values are others.

        >>> from gspot_verified import load
        >>> load("rod").changed(mu=2, m=1).changed(mu="1.5").name
        'falling rod, mu = 3/2'
        """
        before, other = dict(self.parameters), self.with_parameters(**values)
        numbers = {word: rational_value(value) for word, value in other.parameters if value and value != before[word]}
        return replace(other, name=name_with(self.name, {word: str(number) for word, number in numbers.items()}))

    def _check_assumed(self) -> None:
        """What formulas were simplified under holds for the values that parameters have.

        :raises MechanismError: it does not.
        """
        if not self.assumed:
            return
        values = self.parameter_values()
        for name, word in self.assumed:
            if name not in values or symbol_names([values[name]]):
                continue
            number = to_sympy(values[name])
            if not getattr(number, f"is_{word}"):
                raise MechanismError(f"{self.name}: sympy's symbol {name} is assumed {word}; its value is {number}")

    def parameter_values(self) -> dict[str, Expression]:
        """The value of each parameter that has one, with the values that it uses put in.

        :raises MechanismError: values that use each other in a circle, that divide by zero or grow too large.
        """
        waiting = {name: value for name, value in self.parameters if value is not None}
        uses = {name: symbol_names([value]) & set(waiting) for name, value in waiting.items()}
        values: dict[str, Expression] = {}
        while waiting:
            ready = [name for name in waiting if uses[name] <= set(values)]
            if not ready:
                raise MechanismError(
                    f"{self.name}: parameters whose values use each other in a circle: {', '.join(list(waiting)[:20])}"
                )
            for name in ready:
                table: dict[Expression, Expression] = {Symbol(used): values[used] for used in uses[name]}
                try:
                    (values[name],) = replaced([waiting.pop(name)], table)
                except (ZeroDivisionError, NoNumberError) as error:
                    raise MechanismError(f"{self.name}: parameter {name}: {error}") from None
        return values

    @property
    def notes(self) -> tuple[str, ...]:
        """What a reader of results must know of how the mechanism was read."""
        texts = [*self.remarks]
        if self.mirrored:
            what = "x" if self.x is not None else "the slip velocity"
            texts.append(
                f"negative slip: mirrored, {what} counts in the opposite direction, so that u > 0 and "
                "lambda_T = -mu lambda_N; the velocity of a surface counts as u does"
            )
        if not self.regularisation.is_papers:
            r = self.regularisation
            same, end = ("Case, beta and side", "") if r.c else ("Case and beta", f"; {NO_DAMPER}")
            texts.append(
                f"compliance k_1 = {r.k_1}/epsilon^2, k_2 = {r.k_2}/epsilon^2, c = {r.c}/epsilon: {same} "
                f"are those of the paper's, with epsilon^2 times {r.compliance / 2} in the leading order{end}"
            )
        return tuple(texts)

    @property
    def symbols(self) -> tuple[Any, ...]:
        """The components of the state as symbols of sympy."""
        import sympy

        return tuple(sympy.Symbol(name) for name in self.state)


def name_with(name: str, values: Mapping[str, str]) -> str:
    """A name and the values that are others than those it stands for; of a value nothing is cut off.

    >>> name_with("rod, mu = 2", {"mu": "3/2", "m": "5"})
    'rod, mu = 3/2, m = 5'
    """
    for word, value in values.items():
        name = re.sub(rf", {re.escape(word)} = [^,]*", "", name) + f", {word} = {value}"
    return name


def exact_rational(value: ExactInput, name: str) -> fmpq:
    """The exact rational that an input is.

    :raises MechanismError: it is none; the message names it.
    """
    try:
        number = exact(value, name)
    except (TypeError, ValueError) as error:
        raise MechanismError(str(error)) from None
    if not isinstance(number, fmpq):
        raise MechanismError(f"{name}: must be a rational number")
    return number


def require_mechanism(value: object) -> None:
    """Passes for a mechanism.

    :raises TypeError: it is none: a name, say, that :func:`gspot_verified.load` takes.

    >>> require_mechanism("rod")
    Traceback (most recent call last):
    ...
    TypeError: expected a mechanism, got 'rod'; load('rod') makes one
    """
    if isinstance(value, Mechanism):
        return
    if isinstance(value, str | Path):
        shown = repr(str(value)[:60])
        raise TypeError(f"expected a mechanism, got {shown}; load({shown}) makes one")
    raise TypeError(f"expected a mechanism, got {type(value).__name__}")
