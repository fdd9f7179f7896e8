"""Functions of the state on boxes of balls: values, partial derivatives, and the mean value form.

Proof page: ``proofs/box_program.md``. Compiled once from the graph to straight-line Python, then about a tenth of a
microsecond for each operation.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from copy import copy
from typing import Any

from flint import arb

from gspot_verified.functions.expressions import Expression
from gspot_verified.functions.straight_line import Constants, Given, StraightLine
from gspot_verified.numbers.balls import nonfinite

Box = Sequence[arb]
Rows = list[list[arb]]


class BoxProgram:
    """Functions f_1, ..., f_k of a state of ``dimension`` components, to be enclosed on many boxes.

    ``variables`` are the components for which partial derivatives are wanted (default: all).

    Each method encloses at every point of the box, at the working precision in force. A ball that is not finite says
    that nothing is known: a divisor, or the base of a root, may vanish or be negative somewhere on the box.

    :raises TypeError: an operation, or a constant (a symbol), that has no enclosure.
    :raises ValueError: a component of the state outside of 0, ..., dimension - 1.

    >>> from gspot_verified.numbers.balls import working_bits
    >>> from gspot_verified.functions.expressions import Sine, Variable
    >>> program = BoxProgram([Variable(0) * Variable(1), Sine(Variable(0))], 2)
    >>> with working_bits(53):
    ...     values, rows = program.gradients([arb(0), arb(2, 1)])
    >>> values[1], rows[0][0].contains(3), rows[1]
    (0, True, [1.00000000000000, 0])
    """

    def __init__(self, functions: Sequence[Expression], dimension: int, variables: Sequence[int] | None = None) -> None:
        self.dimension = dimension
        self.variables = tuple(range(dimension) if variables is None else variables)
        self._code = StraightLine()
        self._roots = [self._code.value(function) for function in functions]
        used = [int(name[1:]) for name in self._code.needed(self._roots) if name[0] == "x"]
        if used and max(used) >= dimension:
            raise ValueError(f"the functions use component {max(used)} of a state of {dimension} components")
        self._constants = Constants(self._code)
        self._functions: dict[str, Callable[..., Any]] = {}
        self._moving: list[list[int]] = []

    def at(self, given: Given) -> BoxProgram:
        """The same, compiled once for both, with numbers in the place of some constants that are balls."""
        if not given:
            return self
        other = copy(self)
        other._constants = Constants(self._code, given)
        return other

    @property
    def depends(self) -> list[frozenset[int]]:
        """For each function the components that it depends on (or may depend on: cancellations are not seen)."""
        return [self._code.depends(root) for root in self._roots]

    def values(self, box: Box) -> list[arb]:
        """Enclosures of the functions on the box."""
        values = self._functions.get("values")
        if values is None:
            values = self._functions["values"] = self._compiled(self._roots, f"[{', '.join(self._roots)}]")
        return list(values(box, self._constants.balls()))

    def gradients(self, box: Box) -> tuple[list[arb], Rows]:
        """Enclosures of the functions and, as rows, of their partial derivatives by ``variables``.

        Where a function's enclosure is finite, it is analytic on a neighbourhood of the box.
        """
        gradients = self._functions.get("gradients")
        if gradients is None:
            slopes = [[self._code.slope(root, i) for i in self.variables] for root in self._roots]
            rows = ", ".join(f"[{', '.join(slope or 'zero' for slope in row)}]" for row in slopes)
            self._moving[:] = [[i for i, slope in enumerate(row) if slope is not None] for row in slopes]
            names = [*self._roots, *(slope for row in slopes for slope in row if slope is not None)]
            gradients = self._functions["gradients"] = self._compiled(names, f"[{', '.join(self._roots)}], [{rows}]")
        values, rows_found = gradients(box, self._constants.balls())
        return values, rows_found

    def mean_values(self, box: Box) -> list[arb]:
        """Enclosures on the box, by the mean value form where it is the narrower one."""
        return self.mean_values_and_gradients(box)[0]

    def mean_values_and_gradients(self, box: Box) -> tuple[list[arb], Rows]:
        """The enclosures of :meth:`mean_values`, and the partial derivatives that they come from."""
        values, rows = self.gradients(box)
        # The other components keep their whole sides in the value at the centre.
        middle = list(box)
        for i in self.variables:
            middle[i] = box[i].mid()
        moves = [box[i] - middle[i] for i in self.variables]
        enclosures = []
        for value, centre, row, moving in zip(values, self.values(middle), rows, self._moving, strict=True):
            for i in moving:
                centre = centre + row[i] * moves[i]
            enclosures.append(common(value, centre) if value.is_finite() and centre.is_finite() else value)
        return enclosures, rows

    def _compiled(self, names: Sequence[str], result: str) -> Callable[..., Any]:
        return self._code.function(names, result, _OPERATIONS)


def common(first: arb, second: arb) -> arb:
    """A ball around what two enclosures of the same numbers have in common: the narrower where they hardly differ."""
    if first.contains(second):
        return second
    return first if second.contains(first) else first.intersection(second)


_HALF = arb(1) / 2  # exact, made once


def square(value: arb) -> arb:
    """The square: not negative, where the ball holds zero, but for the rounding."""
    if value > 0 or value < 0 or not value.is_finite():
        return value * value
    half = value.abs_upper()
    half = half * half * _HALF
    return arb(0, half) + half


def root(value: arb) -> arb:
    """The square root; not finite unless the whole ball is positive."""
    return value.sqrt() if value > 0 else nonfinite()


def logarithm(value: arb) -> arb:
    """The natural logarithm; not finite unless the whole ball is positive."""
    return value.log() if value > 0 else nonfinite()


def power(value: arb, numerator: int, denominator: int) -> arb:
    """The power with a rational exponent; not finite unless the whole ball is positive."""
    return value ** (arb(numerator) / denominator) if value > 0 else nonfinite()


_OPERATIONS = {
    "one": arb(1), "zero": arb(0), "square": square, "root": root, "power": power, "logarithm": logarithm,
}  # fmt: skip
