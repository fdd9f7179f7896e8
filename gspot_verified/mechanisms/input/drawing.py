"""Reads how the bodies of a mechanism look: lines, circles and points, by formulas. Pictures alone use it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from gspot_verified.functions.expressions import Expression
from gspot_verified.mechanisms.formulas.names import nearest
from gspot_verified.mechanisms.formulas.symbol import variable_indices
from gspot_verified.mechanisms.input.mechanism import Drawing, MechanismError

PARTS = ("lines", "circles", "points", "contact", "normal")
_POINT, _CIRCLE = "[x, y], two formulas", "[x, y, radius] or [x, y, a, b, angle], three or five formulas"
_LINE = '[["X", "Y"], ["X + 1", "Y"]], two points or more'
_UPWARDS = (0, 1)


class DrawingReader:
    """Reads the drawing of one mechanism.

    ``read`` makes an expression of a formula and says in its errors where that stands; ``velocities`` are the
    components of the state, and their names, on which nothing drawn may depend.
    """

    def __init__(self, name: str, read: Callable[[Any, str], Expression], velocities: Mapping[int, str]) -> None:
        self._name, self._read, self._velocities = name, read, velocities

    def __call__(self, given: Mapping[str, Any], contact: Sequence[Any] | None) -> Drawing:
        """The drawing with these parts; ``contact``: the contact point where the drawing names none.

        :raises MechanismError: a part is wrong; the message says which, and how it should be.
        """
        if not isinstance(given, Mapping):
            raise self._error(f"must be a table with some of {', '.join(PARTS)}, got {type(given).__name__}")
        unknown = next((part for part in given if part not in PARTS), None)
        if unknown is not None:
            hint = nearest(str(unknown), PARTS)
            raise self._error(f"unknown part {str(unknown)[:40]!r}{hint}; there are: {', '.join(PARTS)}")
        contact = given.get("contact", contact)
        if contact is None:
            raise self._error(
                'the contact point is missing, where the mechanism has no x: give contact = ["...", "..."]'
            )
        drawing = Drawing(
            lines=tuple(self._line(line, i) for i, line in enumerate(self._list(given, "lines"), 1)),
            circles=self._tuples(self._list(given, "circles"), "circle", (3, 5), _CIRCLE),
            points=self._tuples(self._list(given, "points"), "point", (2,), _POINT),
            contact=self._formulas(contact, "contact", (2,), _POINT),
            normal=self._formulas(given.get("normal", _UPWARDS), "normal", (2,), _POINT),
        )
        if not (drawing.lines or drawing.circles):
            raise self._error(f"nothing is drawn: give a line or a circle, as lines = [{_LINE.partition(']],')[0]}]]]")
        return drawing

    def _error(self, text: str) -> MechanismError:
        return MechanismError(f"{self._name}: drawing: {text}")

    def _list(self, given: Mapping[str, Any], part: str) -> Sequence[Any]:
        value = given.get(part, ())
        if isinstance(value, str) or not isinstance(value, Sequence):
            raise self._error(f"{part} must be a list, got {value!r:.40}")
        return value

    def _line(self, line: Any, number: int) -> tuple[tuple[Expression, ...], ...]:
        if isinstance(line, str) or not isinstance(line, Sequence) or len(line) < 2:
            raise self._error(f"line {number} must be {_LINE}; got {line!r:.40}")
        return self._tuples(line, f"line {number}, point", (2,), _POINT)

    def _tuples(
        self, entries: Sequence[Any], what: str, counts: tuple[int, ...], form: str
    ) -> tuple[tuple[Expression, ...], ...]:
        return tuple(self._formulas(entry, f"{what} {i}", counts, form) for i, entry in enumerate(entries, 1))

    def _formulas(self, entry: Any, where: str, counts: tuple[int, ...], form: str) -> tuple[Expression, ...]:
        if isinstance(entry, str) or not isinstance(entry, Sequence) or len(entry) not in counts:
            raise self._error(f"{where} must be {form}; got {entry!r:.40}")
        made = tuple(self._read(formula, f"drawing, {where}") for formula in entry)
        moving = [word for i, word in self._velocities.items() if i in variable_indices(made)]
        if moving:
            raise self._error(f"{where} depends on the velocity {moving[0]}: where bodies are the coordinates say")
        return made
