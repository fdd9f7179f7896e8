"""Numbers and formulas of sympy and NumPy, exactly or not at all: a float becomes a rational only on purpose."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from gspot_verified.mechanisms.input.mechanism import MechanismError, exact_rational

_DOUBLE = 53  # bits of the numbers of which the shortest decimal is known


class ExactFormulas:
    """Reads formulas of one mechanism; ``rationalize`` makes of each float the shortest decimal that is this float.

    ``replaced`` are the floats that became rationals, and what they became.
    """

    def __init__(self, name: str, rationalize: bool = False) -> None:
        self._name, self._rationalize = name, rationalize
        self.replaced: dict[str, str] = {}

    def __call__(self, value: Any, where: str) -> Any:
        """The formula in sympy, without floats.

        :raises MechanismError: no formula and no number, or a float that is not to be a rational; it is named.

        >>> import sympy
        >>> ExactFormulas("rod", rationalize=True)(0.1 * sympy.Symbol("m"), "x")
        m/10
        """
        import sympy

        value = _scalar(value)
        if isinstance(value, float):
            value = sympy.Float(value)
        elif not isinstance(value, sympy.Expr):
            if hasattr(value, "tolist"):
                raise MechanismError(f"{self._name}: {where}: one formula is needed, got a {type(value).__name__}")
            number = exact_rational(value, f"{self._name}: {where}")
            return sympy.Rational(int(number.p), int(number.q))
        floats = sorted(value.atoms(sympy.Float), key=lambda number: (float(number), number._prec))
        if floats and not self._rationalize:
            shown = [repr(float(number)) for number in floats]
            raise MechanismError(
                f"{self._name}: {where}: not exact: the Float {', '.join(shown[:5])}: write Rational({shown[-1]!r}), "
                "or take all Floats as the decimals that they show with rationalize=True"
            )
        return value.xreplace({number: self._rational(number, where) for number in floats})

    def _rational(self, number: Any, where: str) -> Any:
        import sympy

        shown = repr(float(number))
        if number._prec != _DOUBLE:
            raise MechanismError(
                f"{self._name}: {where}: the Float {number} has {number._prec} bits: of {_DOUBLE} bits is known which "
                "decimal was meant; write it as a Rational"
            )
        exact = sympy.Rational(str(Fraction(shown)))
        self.replaced[shown] = str(exact)
        return exact

    def vector(self, values: Any, where: str) -> list[Any]:
        """The formulas of a list, a one-dimensional array, or a matrix of one column or one row."""
        rows = _nested(values, f"{self._name}: {where}")
        if all(isinstance(row, list) for row in rows):
            if len(rows) == 1:
                rows = rows[0]
            elif all(len(row) == 1 for row in rows):
                rows = [row[0] for row in rows]
        return [self(value, f"{where} {i + 1}") for i, value in enumerate(rows)]

    def matrix(self, values: Any, where: str) -> list[list[Any]]:
        """The rows of formulas of a matrix, a two-dimensional array, or a list of lists."""
        rows = _nested(values, f"{self._name}: {where}")
        if not all(isinstance(row, list) and len(row) == len(rows) for row in rows):
            raise MechanismError(f"{self._name}: {where}: as many columns as rows are needed")
        return [[self(e, f"{where} ({i + 1}, {j + 1})") for j, e in enumerate(row)] for i, row in enumerate(rows)]


def _scalar(value: Any) -> Any:
    """What a NumPy scalar or an array without dimensions holds."""
    return value.item() if getattr(value, "ndim", None) == 0 and hasattr(value, "item") else value


def _nested(values: Any, where: str) -> list[Any]:
    if hasattr(values, "tolist"):
        values = values.tolist()
    if isinstance(values, str) or not isinstance(values, Sequence):
        raise MechanismError(f"{where}: a matrix, an array or a list is needed, got {type(values).__name__}")
    return [list(row) if isinstance(row, Sequence) and not isinstance(row, str) else row for row in values]
