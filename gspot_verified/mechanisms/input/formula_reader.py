"""Read the formulas of one mechanism: its names, its limits, and messages that say where."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from gspot_verified.expansion.series.regularisation import PAPER, Regularisation
from gspot_verified.functions.expressions import Expression, Variable
from gspot_verified.mechanisms.formulas.formula import parse_formula
from gspot_verified.mechanisms.formulas.names import FormulaError, check_name, nearest, normal_name
from gspot_verified.mechanisms.formulas.simplify import constant, negative
from gspot_verified.mechanisms.formulas.symbol import Symbol, count_operations
from gspot_verified.mechanisms.input.mechanism import (
    Fields,
    Mechanism,
    MechanismError,
    Place,
    ReferenceAngle,
    exact_rational,
)
from gspot_verified.numbers.balls import ExactInput

Formula = str | int | Any
"""A text in the language of :mod:`formula`, an int, or a sympy expression."""

MAX_STATE = 40
MAX_PARAMETERS = 500
MAX_OPERATIONS = 2000


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
        """Puts the parts together; ``options`` are those of :class:`Place`, and ``regularisation``."""
        x, slip_velocity, mirrored = self._tangential(contact)
        values = tuple(
            (self.component(word, "G-spot:"), self._read(value, f"G-spot, {word}", self._constants))
            for word, value in place.items()
        )
        given = dict(options)
        regularisation = self._regularisation(given.pop("regularisation", None))
        if given.get("conditions") is not None:
            given["conditions"] = tuple(self(f, f"condition {i + 1}") for i, f in enumerate(given["conditions"]))
        if given.get("fixed") is not None:
            given["fixed"] = tuple(self.component(word, "G-spot:") for word in given["fixed"])
        found = Place(values, **given)
        y, mu = self(contact.y, "y"), self(contact.mu, "mu")
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
            place=found,
            slip_velocity=slip_velocity,
            mirrored=mirrored,
            regularisation=regularisation,
        )

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
