"""A mechanism from the equations that sympy.physics.mechanics forms."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

from gspot_verified.mechanisms.derive.impossible import refuse_impossible
from gspot_verified.mechanisms.derive.lie_derivatives import vanishes_identically
from gspot_verified.mechanisms.foreign.compared import Compared, compare
from gspot_verified.mechanisms.foreign.exact_formulas import ExactFormulas
from gspot_verified.mechanisms.foreign.names import (
    coordinate_names,
    mechanism_name,
    once,
    parameter_names,
    renamed_text,
)
from gspot_verified.mechanisms.foreign.sympy_equations import SympyEquations, sympy_equations, time_symbol
from gspot_verified.mechanisms.formulas.names import nearest
from gspot_verified.mechanisms.formulas.symbol import SLIP_SPEED
from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.numbers.balls import ExactInput

CONTACT = ("x", "slip_velocity", "slip", "y", "mu")
G_SPOT = ("search", "fixed", "conditions", "point")
_TIME = "t"
_ASSUMED = ("positive", "negative", "nonnegative", "nonpositive", "nonzero", "integer", "even", "odd")


def from_sympy(
    method: Any,
    *,
    contact: Mapping[str, Any],
    parameters: Mapping[Any, Any] | None = None,
    name: str = "mechanism",
    rationalize: bool = False,
    coordinates: Sequence[Any] | None = None,
    angles: Mapping[Any, tuple[ExactInput, ExactInput]] | None = None,
    g_spot: Mapping[str, Any] | None = None,
    regularisation: Mapping[str, ExactInput] | None = None,
) -> Mechanism:
    """The mechanism whose equations of motion a LagrangesMethod or a KanesMethod has formed, with one contact.

    Carried: holonomic constraints, nonconservative forces, explicit time, generalised speeds u with q' = N(q, t) u +
    n(q, t). Refused, by name: nonholonomic constraints, dependent coordinates or speeds of a KanesMethod, functions of
    time that are no coordinates. The accelerations that are derived here are compared with those of sympy's equations
    at exact states, to 30 digits; where they differ no mechanism is made.

    :param method: a LagrangesMethod, a KanesMethod, a System, or a pair (M, f) with M q'' = f and its ``coordinates``;
        matrices of sympy, lists, or arrays of objects.
    :param contact: ``x`` and ``y``, the tangential and the normal place of the contact point (y = 0: it touches), and
        ``mu``, as formulas of the coordinates; ``slip_velocity`` in the place of x; ``slip`` "positive" or "negative".
        For scenes a symbol slip_speed may stand in mu. The keys are those of the table "contact" of a mechanism's file.
    :param parameters: a value for each symbol, or None: it stays a symbol. What sympy assumes of a symbol (positive,
        ...) is asked of each value that it gets, also later.
    :param rationalize: take each Float as the decimal that it shows (0.1 is 1/10); otherwise a Float is refused.
    :param angles: (sine, cosine) of the reference angle of a coordinate.
    :param g_spot: ``search``, ``fixed``, ``conditions``, ``point``: as the table "g_spot" of a mechanism's file.
    :param regularisation: k_1, k_2, c of the compliant contact.
    :raises MechanismError: something is not exact, is missing or cannot be taken; the message names it.

    A name that scenes have themselves (y, v, p, ...) or that formulas cannot spell is changed; ``notes`` say so.

    >>> from sympy import symbols
    >>> from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols
    >>> from gspot_verified import from_sympy
    >>> m, g = symbols("m g")
    >>> x, y = dynamicsymbols("x y")
    >>> method = LagrangesMethod(m * (x.diff() ** 2 + y.diff() ** 2) / 2 - m * g * y, [x, y])
    >>> block = from_sympy(method, contact={"x": x, "y": y, "mu": "1/2"}, parameters={m: 1, g: "9.81"})
    >>> block.state, block.notes
    (('q_x', 'q_y', 'q_x_dot', 'q_y_dot'), ('renamed: x is q_x, y is q_y here',))
    """
    formulas = ExactFormulas(mechanism_name(name), rationalize)
    given = _only(name, "contact", contact, CONTACT)
    place = _only(name, "g_spot", g_spot or {}, G_SPOT)
    equations = sympy_equations(name, method, formulas, coordinates)
    read = _Translation(name, formulas, equations)
    tangential = {word: given[word] for word in ("x", "slip_velocity") if given.get(word) is not None}
    missing = next((word for word in ("y", "mu") if word not in given), None)
    if not isinstance(place.get("search", False), bool):
        raise MechanismError(f"{name}: g_spot: search must be True or False")
    if missing is not None or len(tangential) != 1:
        raise MechanismError(f"{name}: contact: {missing or 'x, or slip_velocity,'} is needed")
    parts: dict[str, Any] = {
        "mass_matrix": read.matrix(equations.mass_matrix, "mass matrix"),
        "forces": [read(force, f"force {i + 1}") for i, force in enumerate(equations.forces)],
        "constraints": [read(formula, f"constraint {i + 1}") for i, formula in enumerate(equations.constraints)],
        "y": read(given["y"], "contact, y"),
        "mu": read(given["mu"], "contact, mu"),
        **{word: read(value, f"contact, {word}") for word, value in tangential.items()},
    }
    if place.get("conditions") is not None:
        parts["conditions"] = [read(formula, "g_spot, condition") for formula in place["conditions"]]
    values = read.parameters(parameters or {})
    made = read.named(parts)
    mechanism = lagrangian(
        name,
        read.coordinates,
        _symmetric(name, made.pop("mass_matrix")),
        parameters=values,
        x=made.pop("x", None),
        angles=read.components("angles", angles or {}),
        place={
            key: read.value(value, "g_spot") for key, value in read.components("point", place.get("point", {})).items()
        },
        fixed=None if place.get("fixed") is None else [read.component(key) for key in place["fixed"]],
        search=place.get("search", False),
        time=_TIME if read.has_time else None,
        slip=given.get("slip", "positive"),
        regularisation=regularisation,
        **made,
    )
    refuse_impossible(mechanism)
    turn = -1 if mechanism.mirrored else 1
    slip = parts["slip_velocity"] if "slip_velocity" in parts else parts["x"].diff(time_symbol())
    agreed = compare(mechanism, Compared(equations, turn * slip, parts["y"], read.words))
    remarks = [*read.remarks, *_rationalized(formulas.replaced)]
    if not agreed:
        remarks.append("the equations have no value at the states at which they are compared: not compared")
    return replace(mechanism, remarks=tuple(remarks), assumed=read.assumptions())


def _assumed(symbol: Any) -> list[str]:
    """What sympy assumes of it, also where it may be infinite (extended_positive): that is simplified with, too."""
    return [word for word in _ASSUMED if getattr(symbol, f"is_{word}") or getattr(symbol, f"is_extended_{word}", False)]


def _only(name: str, what: str, given: Mapping[str, Any], keys: Sequence[str]) -> dict[str, Any]:
    if not isinstance(given, Mapping):
        raise MechanismError(f"{name}: {what}: give a table with {', '.join(keys)}, got {type(given).__name__}")
    for key in given:
        if key not in keys:
            hint = nearest(str(key), keys)
            raise MechanismError(f"{name}: {what}: unknown key {str(key)[:40]!r}{hint}; known here: {', '.join(keys)}")
    return dict(given)


def _rationalized(replaced: Mapping[str, str]) -> list[str]:
    made = [f"{shown} is {exact}" for shown, exact in replaced.items()]
    return [f"Floats taken as decimals: {', '.join(made)}"] if made else []


def _symmetric(name: str, rows: list[list[Any]]) -> list[list[Any]]:
    """The matrix with what stands above the diagonal also below it.

    :raises MechanismError: it is not symmetric, or was not shown to be.
    """
    for i, row in enumerate(rows):
        for j in range(i):
            if row[j] != rows[j][i] and not vanishes_identically(row[j] - rows[j][i]):
                raise MechanismError(
                    f"{name}: the mass matrix is not symmetric, or not shown to be: entry ({i + 1}, {j + 1}) is "
                    f"{row[j]}, entry ({j + 1}, {i + 1}) is {rows[j][i]}"
                )
            row[j] = rows[j][i]
    return rows


class _Translation:
    """From sympy's dynamic symbols to the names of this library.

    ``words`` maps the symbols of parameters to their names here; ``remarks`` say what was renamed.
    """

    def __init__(self, name: str, formulas: ExactFormulas, equations: SympyEquations) -> None:
        self._name, self._formulas, self._equations = name, formulas, equations
        self.has_time = False
        self._symbols: set[Any] = set()
        self.words: dict[Any, str] = {}
        self._given = coordinate_names([self._name_of(q) for q in equations.coordinates])
        self.coordinates = list(self._given.values())
        self.remarks = renamed_text(self._given)
        self._places = dict(zip(equations.coordinates, self.coordinates, strict=True))
        self._velocities = {q.diff(time_symbol()): f"{word}_dot" for q, word in self._places.items()}

    def _name_of(self, coordinate: Any) -> str:
        from sympy.core.function import AppliedUndef

        if not isinstance(coordinate, AppliedUndef) or coordinate.args != (time_symbol(),):
            raise MechanismError(
                f"{self._name}: the coordinate {coordinate} is no function of time: make it with dynamicsymbols"
            )
        assumed = _assumed(coordinate)
        if assumed:
            raise MechanismError(
                f"{self._name}: the coordinate {coordinate} is assumed {assumed[0]}: formulas that were simplified "
                "under this may be wrong elsewhere; make it without the assumption"
            )
        return str(coordinate.func.__name__)

    def __call__(self, formula: Any, where: str) -> Any:
        """The formula, exact, of q, q' and t alone; its symbols are kept in mind."""
        import sympy
        from sympy.core.function import AppliedUndef

        exact = self._formulas(formula, where).xreplace(self._equations.speeds)
        exact = exact.doit() if exact.has(sympy.Derivative) else exact
        bare = self._bare(exact, {q: sympy.Dummy() for q in self._places}, {v: sympy.Dummy() for v in self._velocities})
        left = sorted(bare.atoms(AppliedUndef, sympy.Derivative), key=str)
        if left:
            raise MechanismError(
                f"{self._name}: {where}: {left[0]} is neither a coordinate nor a velocity: put its formula in its "
                "place (subs) before the equations are given"
            )
        dummies = {symbol for symbol in bare.free_symbols if isinstance(symbol, sympy.Dummy)}
        self._symbols |= bare.free_symbols - dummies - {time_symbol()}
        self.has_time = self.has_time or time_symbol() in bare.free_symbols
        return exact

    def matrix(self, matrix: Any, where: str) -> list[list[Any]]:
        """The rows."""
        n = len(self.coordinates)
        return [[self(matrix[i, j], f"{where} ({i + 1}, {j + 1})") for j in range(n)] for i in range(n)]

    @staticmethod
    def _bare(formula: Any, places: Mapping[Any, Any], velocities: Mapping[Any, Any]) -> Any:
        """Velocities first: a coordinate stands inside its own."""
        return formula.xreplace(velocities).xreplace(places)

    def parameters(self, given: Mapping[Any, Any]) -> dict[str, Any]:
        """The values by the names here.

        :raises MechanismError: a symbol without a value, two symbols of one name, or a value that is none.
        """
        import sympy

        symbols_given = {str(key): key for key in given if not isinstance(key, str)}
        spelled = [
            *((key, name) for name, key in symbols_given.items()),
            *((k, k) for k in given if isinstance(k, str)),
        ]
        once(f"{self._name}: parameters", spelled)
        values = {str(key): value if value is None else self._formulas(value, f"parameter {key}")
                  for key, value in given.items()}  # fmt: skip
        used = {symbol for value in values.values() if value is not None for symbol in value.free_symbols}
        symbols = sorted(
            self._symbols | used | {key for key in given if isinstance(key, sympy.Symbol)}, key=lambda each: each.name
        )
        others = {symbol.name for symbol in symbols if symbol != time_symbol()}
        if time_symbol() in symbols or (self.has_time and str(time_symbol()) in {*values} - others):
            raise MechanismError(
                f"{self._name}: parameters: {time_symbol()} is the time of sympy's dynamic symbols and has no value; "
                "give a parameter another name"
            )
        twice = next((a for a, b in pairwise(symbols) if a.name == b.name), None)
        if twice is not None:
            raise MechanismError(
                f"{self._name}: two different symbols are called {twice.name!r} (they differ in what sympy assumes of "
                "them): make it one symbol, or give one of them another name"
            )
        symbols = [symbol for symbol in symbols if symbol.name in values or symbol.name != SLIP_SPEED]
        missing = [symbol.name for symbol in symbols if symbol.name not in values]
        if missing:
            raise MechanismError(
                f"{self._name}: no value for {', '.join(missing[:10])}: parameters={{{missing[0]}: ...}}; None leaves "
                "it a symbol"
            )
        names = parameter_names(values, {str(i): word for i, word in enumerate(self.coordinates)})
        self.remarks += renamed_text(names)
        self.words = {symbol: names[symbol.name] for symbol in symbols}
        return {names[key]: value if value is None else self._named(value) for key, value in values.items()}

    def named(self, parts: Mapping[str, Any]) -> dict[str, Any]:
        """The formulas in symbols that have the names here."""
        return {word: self._named(part) for word, part in parts.items()}

    def _named(self, part: Any) -> Any:
        import sympy

        if isinstance(part, list):
            return [self._named(each) for each in part]
        # Dummies between: a parameter there may have the name of a velocity here.
        dummies = {velocity: sympy.Dummy() for velocity in self._velocities}
        table = {dummies[velocity]: sympy.Symbol(word) for velocity, word in self._velocities.items()}
        table |= {q: sympy.Symbol(word) for q, word in self._places.items()}
        table |= {symbol: sympy.Symbol(word) for symbol, word in self.words.items()}
        return self._bare(part, table | {time_symbol(): sympy.Symbol(_TIME)}, dummies)

    def component(self, key: Any) -> str:
        """The name here of a component of the state, given as sympy's or by a name."""
        speeds = self._equations.speeds
        table = {**self._places, **self._velocities, time_symbol(): _TIME}
        table |= {speed: table[rate] for speed, rate in speeds.items() if rate in table}
        if key in speeds and key not in table:
            raise MechanismError(
                f"{self._name}: {key} is no velocity of a coordinate: give {', '.join(table.values())}"
            )
        words = self._given | {f"{word}_dot": f"{here}_dot" for word, here in self._given.items()}
        return table.get(key) or words.get(str(key), str(key))

    def components(self, where: str, given: Mapping[Any, Any]) -> dict[str, Any]:
        """The values by the names here.

        :raises MechanismError: one is given twice.
        """
        names = once(f"{self._name}: {where}", ((key, self.component(key)) for key in given))
        return dict(zip(names, given.values(), strict=True))

    def value(self, value: Any, where: str) -> Any:
        """A formula of parameters and reference angles; a text is one in the names here."""
        return value if isinstance(value, str) else self._named(self._formulas(value, where))

    def assumptions(self) -> tuple[tuple[str, str], ...]:
        """What sympy assumes of the symbols, by their names here."""
        return tuple((word, each) for symbol, word in self.words.items() for each in _assumed(symbol))
