"""The value of a truncated expansion at a point: in balls, or exactly where balls of all precisions tried are wide."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from flint import arb, arb_poly, fmpq, fmpq_poly

from gspot_verified.expansion.series.spaces import SpacePolynomial
from gspot_verified.expansion.time_series import Table
from gspot_verified.numbers.balls import ball, relative_bits, working_bits

_LOST_BITS = 10
_PRECISIONS = (1, 2, 4, 8)
"""Multiples of the bits asked for. An exact value costs more than all of them together once coefficients are long."""

Point = tuple[Any, Any]
Value = Callable[[Point, bool], Any]
"""The value at a point, exactly or, if asked, with coefficients rounded to balls at the precision in force."""


def scaled_value(terms: Sequence[SpacePolynomial], place: Point, bits: int, rational: bool) -> arb:
    """A ball around the sum of p_n(s) delta^n at (s, delta).

    ``rational``: the coefficients are; at a rational point all but the last few of ``bits`` bits are certain then.
    """
    return _ball(lambda at, rounded: _horner([_at(t, at[0], rounded) for t in terms], at[1]), place, bits, rational)


def value_in_time(table: Table, place: Point, bits: int, rational: bool) -> arb:
    """A ball around the sum of c_(k,m) t^k epsilon^m at (t, epsilon), as accurate as :func:`scaled_value`."""

    def value(at: Point, rounded: bool) -> Any:
        return _bivariate({key: ball(c) for key, c in table.items()} if rounded else table, at)

    return _ball(value, place, bits, rational)


def _ball(value: Value, place: Point, bits: int, rational: bool) -> arb:
    if not rational or any(isinstance(number, arb) for number in place):
        with working_bits(bits):
            return ball(value((ball(place[0]), ball(place[1])), True))
    for multiple in _PRECISIONS:
        with working_bits(multiple * bits):
            found = ball(value((ball(place[0]), ball(place[1])), True))
            if relative_bits(found) >= bits - _LOST_BITS:
                return found
    with working_bits(bits):
        return ball(value(place, False))


def _at(term: SpacePolynomial, s: Any, rounded: bool) -> Any:
    """Its value; a polynomial with rational coefficients is rounded as a whole."""
    if rounded and isinstance(term.cubic, fmpq_poly):
        return arb_poly(term.cubic)(s**3) * s ** (term.n % 3)
    return term(s)


def _horner(values: Sequence[Any], at: Any) -> Any:
    total = values[-1]
    for value in reversed(values[:-1]):
        total = total * at + value
    return total


def _bivariate(table: Mapping[tuple[int, int], Any], at: Point) -> Any:
    layers: dict[int, list[Any]] = {}
    for (k, m), value in table.items():
        row = layers.setdefault(m, [])
        row += [0] * (k + 1 - len(row))
        row[k] = value
    total: Any = fmpq(0)
    for m in range(max(layers, default=-1), -1, -1):
        total = total * at[1] + (_horner(layers[m], at[0]) if m in layers else 0)
    return total
