"""A vector field and its Jacobian matrix in three arithmetics: balls, complex balls, power series over balls.

All three run the same straight-line code. What is not finite says that nothing is known there.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from copy import copy
from typing import Any

from flint import acb, arb, arb_series

from gspot_verified.functions.box_program import logarithm, power, root, square
from gspot_verified.functions.expressions import Expression
from gspot_verified.functions.straight_line import Constants, Given, StraightLine
from gspot_verified.integrator.field.no_series import NoSeriesError
from gspot_verified.numbers.balls import nonfinite

_REAL: dict[str, Any] = {
    "one": arb(1), "zero": arb(0), "square": square, "root": root, "power": power, "logarithm": logarithm,
}  # fmt: skip

_DEGREES: dict[str, Callable[[list[int]], int]] = {
    "sum": max, "minus": max, "product": sum, "square": lambda parts: 2 * parts[0],
}  # fmt: skip


class VectorField:
    """Functions f_1, ..., f_d of a state of d components, to be evaluated with their Jacobian matrix.

    :raises TypeError: an operation, or a constant (a symbol), that has no enclosure.
    :raises ValueError: the number of functions, or a component that they use, does not fit the dimension.

    >>> from gspot_verified.numbers.balls import working_bits
    >>> from gspot_verified.functions.expressions import Sine, Variable
    >>> pendulum = VectorField([Variable(1), -Sine(Variable(0))])
    >>> with working_bits(53):
    ...     values, rows = pendulum.on_box([arb(0), arb(2)])
    >>> values, rows
    ([2.00000000000000, 0], [[0, 1.00000000000000], [-1.00000000000000, 0]])
    """

    def __init__(self, functions: Sequence[Expression]) -> None:
        self.functions = tuple(functions)
        self.dimension = len(functions)
        self._code = StraightLine()
        self._roots = [self._code.value(function) for function in functions]
        used = [int(name[1:]) for name in self._code.needed(self._roots) if name[0] == "x"]
        if not functions or max(used, default=0) >= self.dimension:
            raise ValueError(f"{self.dimension} functions of a state with component {max(used, default=0)}")
        self._rows = [[self._code.slope(name, i) for i in range(self.dimension)] for name in self._roots]
        self._constants = Constants(self._code)
        self._compiled_as: VectorField | None = None
        self._compiled: dict[str, Callable[..., Any]] = {}
        self._degrees: dict[tuple[int, ...], list[int | None]] = {}

    def at(self, given: Given) -> VectorField:
        """The same, compiled once for both, with numbers in the place of some constants that are balls."""
        if not given:
            return self
        other = copy(self)
        other._constants, other._compiled_as = Constants(self._code, given), self.first
        return other

    @property
    def given(self) -> Given:
        """Those numbers."""
        return self._constants.given

    @property
    def first(self) -> VectorField:
        """The field that was compiled: itself, or the one of which it is :meth:`at` some numbers."""
        return self._compiled_as or self

    def on_box(self, box: Sequence[arb]) -> tuple[list[arb], list[list[arb]]]:
        """Enclosures of f and of its Jacobian matrix at every point of the box."""
        values, rows = self._run("real", _REAL, box, True)
        return values, rows

    def second_derivatives(self, box: Sequence[arb]) -> list[list[list[arb]]]:
        """Enclosures of the derivatives of the Jacobian matrix: entry i, j, l is ∂²f_i/∂x_j∂x_l on the box."""
        program = self._compiled.get("second")
        if program is None:
            size = range(self.dimension)
            table = [[[e and self._code.slope(e, k) for k in size] for e in row] for row in self._rows]
            names = [name for row in table for entry in row for name in entry if name is not None]
            shown = ", ".join(
                f"[{', '.join('[' + ', '.join(name or 'zero' for name in entry) + ']' for entry in row)}]"
                for row in table
            )
            program = self._compiled["second"] = self._code.function(names, f"[{shown}]", _REAL)
        derivatives: list[list[list[arb]]] = program(box, self._constants.balls())
        return derivatives

    def on_complex_box(self, box: Sequence[acb]) -> tuple[list[acb], list[list[acb]]]:
        """The same on a complex box; where all of it is finite, f is holomorphic on a neighbourhood of the box."""
        values, rows = self._run("complex", _COMPLEX, box, True)
        return [acb(value) for value in values], [[acb(entry) for entry in row] for row in rows]

    def values_on_complex_box(self, box: Sequence[acb]) -> list[acb]:
        """f alone on a complex box; where it is finite, f is holomorphic on a neighbourhood of the box."""
        return [acb(value) for value in self._run("complex values", _COMPLEX, box, False)]

    def degrees(self, degrees: Sequence[int]) -> list[int | None]:
        """Bounds on the degrees of f along polynomials of these degrees; None where f is no polynomial."""
        known = self._degrees.get(tuple(degrees))
        if known is None:
            known = self._degrees[tuple(degrees)] = self._degrees_of_code(degrees)
        return list(known)

    def _degrees_of_code(self, degrees: Sequence[int]) -> list[int | None]:
        degree_of: dict[str, int | None] = {}
        for name in self._code.needed(self._roots):
            operation, operands = self._code.definition(name)
            parts = [degree_of[part] for part in self._code.operands(name)]
            known = [part for part in parts if part is not None]
            if operation == "variable":
                degree_of[name] = degrees[operands[0]]
            elif operation == "constant":
                degree_of[name] = 0
            elif len(known) < len(parts) or operation not in _DEGREES:
                degree_of[name] = None
            else:
                degree_of[name] = _DEGREES[operation](known)
        return [degree_of[root] for root in self._roots]

    def series(self, state: Sequence[arb_series]) -> list[arb_series]:
        """The power series of f along a curve; its terms enclose the Taylor coefficients.

        The length is the one in force (:class:`balls.series_length`).

        :raises NoSeriesError: a divisor may vanish at the start.
        """
        values = self._series("series", state, False)
        return [as_series(value, state[0].prec) for value in values]

    def series_with_jacobian(self, state: Sequence[arb_series]) -> tuple[list[arb_series], list[list[arb_series]]]:
        """The same, and the series of the entries of the Jacobian matrix."""
        values, rows = self._series("series and Jacobian", state, True)
        length = state[0].prec
        return [as_series(v, length) for v in values], [[as_series(entry, length) for entry in row] for row in rows]

    def _series(self, kind: str, state: Sequence[arb_series], jacobian: bool) -> Any:
        try:
            return self._run(kind, _SERIES, state, jacobian)
        except (ValueError, ZeroDivisionError) as error:  # what python-flint says of a divisor that may begin with 0
            raise NoSeriesError(str(error)) from error

    def _run(self, kind: str, space: dict[str, Any], state: Sequence[Any], jacobian: bool) -> Any:
        program = self._compiled.get(kind)
        if program is None:
            program = self._compiled[kind] = self._compile(space, jacobian)
        return program(state, self._constants.balls())

    def _compile(self, space: dict[str, Any], jacobian: bool) -> Callable[..., Any]:
        names = [*self._roots]
        result = f"[{', '.join(self._roots)}]"
        if jacobian:
            names += [slope for row in self._rows for slope in row if slope is not None]
            rows = ", ".join(f"[{', '.join(slope or 'zero' for slope in row)}]" for row in self._rows)
            result = f"{result}, [{rows}]"
        return self._code.function(names, result, space)


def as_series(value: Any, length: int) -> arb_series:
    """A number or a series as a series of this length.

    :raises NoSeriesError: the series is shorter.
    """
    series = value if isinstance(value, arb_series) else arb_series([value], length)
    if series.prec < length:
        raise NoSeriesError(f"a series of length {series.prec} where {length} terms are needed")
    return series


def _complex_square(value: acb) -> acb:
    return value * value


def _complex_root(value: acb) -> acb:
    """The square root where it is holomorphic: on the half plane with a positive real part."""
    return value.sqrt() if acb(value).real > 0 else acb(nonfinite())


def _complex_logarithm(value: acb) -> acb:
    """The principal logarithm, where it is holomorphic for certain: a ball across its cut would be finite, too."""
    return value.log() if acb(value).real > 0 else acb(nonfinite())


def _complex_power(value: acb, numerator: int, denominator: int) -> acb:
    """The power by the principal logarithm, on the same half plane."""
    return (acb(value).log() * numerator / denominator).exp() if acb(value).real > 0 else acb(nonfinite())


def _start(value: arb | arb_series) -> arb:
    """The constant term of a series."""
    if isinstance(value, arb):
        return value
    terms: list[arb] = value.coeffs()
    return terms[0] if terms else arb(0)


def _series_root(value: Any) -> Any:
    return value.sqrt() if _start(value) > 0 else nonfinite()


def _series_logarithm(value: Any) -> Any:
    return value.log() if _start(value) > 0 else nonfinite()


def _series_power(value: Any, numerator: int, denominator: int) -> Any:
    return (value.log() * (arb(numerator) / denominator)).exp() if _start(value) > 0 else nonfinite()


_COMPLEX: dict[str, Any] = {
    "one": acb(1), "zero": acb(0), "square": _complex_square, "root": _complex_root, "power": _complex_power,
    "logarithm": _complex_logarithm,
}  # fmt: skip
_SERIES: dict[str, Any] = {
    "one": arb(1), "zero": arb(0), "square": _complex_square, "root": _series_root, "power": _series_power,
    "logarithm": _series_logarithm,
}  # fmt: skip
