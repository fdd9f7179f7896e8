"""The panels of one function in doubles: made where points are asked for, and kept for the next array.

When they are made is a heuristic; each carries its own bound (``proofs/float_horner.md``, ``proofs/local_series.md``).
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from flint import arb, arb_poly, fmpq

from gspot_verified.numbers.balls import approximate
from gspot_verified.theta_function.arrays.double_double import DoubleDoublePolynomial, double_double_polynomial
from gspot_verified.theta_function.arrays.float_horner import FloatArray, FloatPolynomial, IndexArray, float_polynomial
from gspot_verified.theta_function.arrays.panels import FARTHEST, PER_FINE_CELL, layout, panel, panel_around
from gspot_verified.theta_function.sums.local_series import part_of_polynomial

FARTHEST_OF_ONE_POLYNOMIAL = 10.0
"""|tau| up to which one series at 0 loses few digits; any number is right."""

GOAL = 64
"""Bits of the series of a unit interval, from which doubles come; any number is right."""
_LONG_GOAL = 124  # the same for pairs of doubles
_NEGLIGIBLE = 58  # bits below the largest coefficient; any number is right
_LONG_NEGLIGIBLE = 112  # the same for pairs of doubles
_FIRST_PARTS = 4  # in which a unit interval is split first; any number is right
_LATER = 8  # who asks a second time will ask so many times more; any number is right
ZERO_PANEL = fmpq(1, 16)
"""Half of the width of a panel around a zero; 1 over a power of two."""
_FARTHEST_ZERO = 0.1  # from the middle of the fine panel that asks for it, in half unit intervals; any number is right
_NEWTON_STEPS = 6  # to the zero in or next to a panel; any number is right
_POINTS_OF_A_CELL = 15.0  # that cost as much in balls as the panels of a unit interval; any number is right
_POINTS_OF_A_CELL_AT_0 = 110.0  # the same where one polynomial serves all points, at tau = 0; any number is right
_POINTS_OF_A_FINE_CELL = 40_000  # from which on the short series of the fine panels pay; any number is right


class Columns(NamedTuple):
    """The panels of one unit interval: ``table[k]`` are the coefficients of s^k by panel, ``errors`` their bounds."""

    table: FloatArray
    errors: FloatArray


class ZeroPanel(NamedTuple):
    """A panel around a double next to a zero, :data:`ZERO_PANEL` to each side."""

    centre: float
    polynomial: FloatPolynomial


class ZeroPanels(NamedTuple):
    """Some of them as arrays, one entry a panel: the arguments of :func:`horner` and :func:`near_bounds`."""

    centres: FloatArray
    inverses: FloatArray
    table: FloatArray
    constants: FloatArray
    slopes: FloatArray


class KeptPanels:
    """What was made of d^k Theta/dtau^k at one beta, and how many points were asked for."""

    __slots__ = ("_asked", "_beta", "_columns", "_derivative", "_last_zeros", "_long", "_zeros", "layout")

    def __init__(self, beta: fmpq, derivative: int) -> None:
        self._beta, self._derivative, self._asked = beta, derivative, 0
        self.layout = layout(math.ceil(abs(approximate(beta))))
        self._columns: dict[tuple[int, int], Columns] = {}
        self._long: dict[tuple[int, int, int], DoubleDoublePolynomial] = {}
        self._zeros: dict[tuple[int, int], ZeroPanel] = {}
        self._last_zeros: tuple[bytes, ZeroPanels] | None = None

    def asked(self, points: int) -> float:
        """Note that so many points are asked for; how many times they will be in the end, a guess."""
        later = _LATER if self._asked else 1
        self._asked += points
        return later * self._asked / points

    def worth(self, points: FloatArray, times: float) -> tuple[IndexArray, bool]:
        """The unit intervals whose panels are kept or will pay, asked so many times; and whether the fine ones."""
        low = max(math.floor(points.min()), -FARTHEST)
        high = min(math.floor(points.max()) + 1, FARTHEST)
        farthest, cells = max(-low, high), np.arange(low, high)
        near = farthest <= FARTHEST_OF_ONE_POLYNOMIAL
        # One value of the polynomial at 0 takes the longer the farther it reaches.
        least = _POINTS_OF_A_CELL_AT_0 / (1 + farthest / 5) if near else _POINTS_OF_A_CELL
        expected = len(points) * times
        if expected >= 2 * least * len(cells):  # enough for all of them, wherever the points lie
            fine = expected >= _POINTS_OF_A_FINE_CELL * len(cells)
            return cells, fine or all((cell, PER_FINE_CELL) in self._columns for cell in range(low, high))
        inside = points[(points >= low) & (points < high)]
        counts = np.bincount(np.floor(inside).astype(np.intp) - low, minlength=len(cells))
        kept = [(cell, self.layout.counts[cell + FARTHEST]) in self._columns for cell in range(low, high)]
        new = (counts > 0) & np.logical_not(kept)
        pays = expected >= least * np.count_nonzero(new) if near else counts * times >= least
        return cells[(counts > 0) & (kept | (new & pays))], False

    def columns(self, cell: int, count: int) -> Columns:
        """The ``count`` panels in [cell, cell + 1]."""
        found = self._columns.get((cell, count))
        if found is None:
            found = self._columns[cell, count] = self._made(cell, count)
        return found

    def long_column(self, cell: int, number: int, count: int) -> DoubleDoublePolynomial:
        """Panel ``number`` of them in pairs of doubles."""
        key = (cell, number, count)
        found = self._long.get(key)
        if found is None:
            found = self._long[key] = double_double_polynomial(self._long_part(cell, number, count))
        return found

    def zero_panels(self, numbers: IndexArray) -> ZeroPanels:
        """The panels around the zeros in or next to the fine panels of these numbers, counted from -FARTHEST on."""
        key = numbers.tobytes()
        if self._last_zeros is None or self._last_zeros[0] != key:  # the next array may have points at the same zeros
            self._last_zeros = key, self._zero_panels(numbers)
        return self._last_zeros[1]

    def _zero_panels(self, numbers: IndexArray) -> ZeroPanels:
        places = [divmod(number, PER_FINE_CELL) for number in numbers.tolist()]
        found = [self.zero_panel(cell - FARTHEST, number) for cell, number in places]
        polynomials = [one.polynomial for one in found]
        table = np.zeros((max(len(one.coefficients) for one in polynomials), len(found)))
        for column, one in enumerate(polynomials):
            table[: len(one.coefficients), column] = one.coefficients
        return ZeroPanels(
            centres=np.array([one.centre for one in found]),
            inverses=np.full(len(found), 1.0) * int(ZERO_PANEL.q),
            table=table,
            constants=np.array([one.constant for one in polynomials]),
            slopes=np.array([one.slope for one in polynomials]),
        )

    def zero_panel(self, cell: int, number: int) -> ZeroPanel:
        """One around the zero in or next to a fine panel, or what Newton's method takes for it: any centre is right."""
        found = self._zeros.get((cell, number))
        if found is None:
            found = self._zeros[cell, number] = self._around_zero(cell, number)
        return found

    def _around_zero(self, cell: int, number: int) -> ZeroPanel:
        series = panel(self._beta, self._derivative, cell, 0, 1, _LONG_GOAL)
        slope = series.polynomial.derivative()
        s = start = arb(fmpq(2 * number + 1, PER_FINE_CELL) - 1)
        for _ in range(_NEWTON_STEPS):
            s = (s - series.polynomial(s) / slope(s)).mid()
        s = s if abs(s - start) < _FARTHEST_ZERO else start
        centre = approximate(cell + (1 + s) / 2)
        exact, own = fmpq(*centre.as_integer_ratio()), math.floor(centre)  # perhaps in the cell beside
        around = panel_around(self._beta, self._derivative, own, exact, ZERO_PANEL, _LONG_GOAL)
        return ZeroPanel(centre, float_polynomial(around.polynomial))

    def _made(self, cell: int, count: int) -> Columns:
        polynomials = [float_polynomial(part) for part in self._parts(cell, count)]
        table = np.zeros((max(1, *(len(polynomial.coefficients) for polynomial in polynomials)), count))
        for number, polynomial in enumerate(polynomials):
            table[: len(polynomial.coefficients), number] = polynomial.coefficients
        return Columns(table, np.array([polynomial.error for polynomial in polynomials]))

    def _parts(self, cell: int, count: int) -> list[arb_poly]:
        """The series of the unit interval, part by part: cheaper than a series from each centre."""
        series = panel(self._beta, self._derivative, cell, 0, 1, GOAL)
        first = min(count, _FIRST_PARTS)
        wide = _split(series.polynomial, first, series.bits)
        return [part for one in wide for part in _split(one, count // first, series.bits)]

    def _long_part(self, cell: int, number: int, count: int) -> arb_poly:
        series = panel(self._beta, self._derivative, cell, 0, 1, _LONG_GOAL)
        length = _needed(series.polynomial, count, _LONG_NEGLIGIBLE)
        return part_of_polynomial(series.polynomial, number, count, length, series.bits)


def _split(polynomial: arb_poly, pieces: int, bits: int) -> list[arb_poly]:
    """The polynomial part by part, without the coefficients that do not count in doubles."""
    if pieces == 1:
        return [polynomial]
    length = _needed(polynomial, pieces, _NEGLIGIBLE)
    return [part_of_polynomial(polynomial, number, pieces, length, bits) for number in range(pieces)]


def _needed(polynomial: arb_poly, pieces: int, bits: int) -> int:
    """How many coefficients of a part are not below 2^-bits of the largest one, at most: their sizes at s = 1."""
    sizes = np.abs(np.array([approximate(value) for value in polynomial.coeffs()]))
    with np.errstate(over="ignore", invalid="ignore"):
        parts = np.dot(sizes, _binomials(len(sizes))) / np.float64(pieces) ** np.arange(len(sizes))
    if not np.isfinite(parts).all():
        return len(sizes)
    return int(np.flatnonzero(parts > parts.max() * 2.0**-bits).max(initial=0)) + 1


@lru_cache(maxsize=64)
def _binomials(length: int) -> FloatArray:
    return np.array([[math.comb(k, j) for j in range(length)] for k in range(length)], dtype=np.float64)


@lru_cache(maxsize=32)
def kept_panels(p: int, q: int, derivative: int) -> KeptPanels:
    """Those of beta = p/q."""
    return KeptPanels(fmpq(p, q), derivative)
