"""The polynomial of a step: its length from the decay of the coefficients, exact coefficients. Heuristic."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache

from flint import acb, arb, arb_poly, fmpz_poly

from gspot_verified.integrator.box_steps.choice import log2_of
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.integrator.norm_steps.taylor_recurrence import TaylorRecurrence, fixed
from gspot_verified.numbers.balls import approximate, current_bits

_GUARD_BITS = 32  # of the working ones that the coefficients do not use
_ORDER_PER_BIT = 0.4  # terms for each bit: by trial the quickest
_LEAST_ORDER = 8  # where nothing is asked for
_NOISE_BITS = 10  # of a coefficient that may be rounding errors alone; more where the field makes them larger
_LAST_TERMS = 8  # of a series, which no longer decay where they are rounding errors
_DECAYED_BITS = 24  # below the first terms, so that they are not the flat series of a step as long as the radius
_TAIL_BITS = 6  # above the last one, at which the last coefficients are aimed
_LARGEST_CHANGE = 2.0  # of the length, from one try to the next
_KEPT_CHANGE = 1.08  # below it the coefficients are scaled, not made again
_GUESSED_CHANGE = 1.25  # of the length, from one step to the next: for a shorter one the coefficients are scaled
_LARGEST_TRIES = 4  # lengths of one step
_FIRST_LENGTH = 0.25  # of a run, before anything is known
_STEP_BITS = 8  # of a length
_LARGEST_SUM_BITS = 3  # by which a coefficient may exceed the first two
_DISCS = (2, 3, 4, 5, 6, 8)
_KEPT_FIELDS = 8  # whose recurrences are kept


class TaylorCurve:
    """Polynomials along the solutions of one field, step after step: each length starts from the one before."""

    def __init__(self, field: VectorField, least_order: int = _LEAST_ORDER) -> None:
        self._recurrence = _recurrence(field.first).at(field.given)
        self._guess = _FIRST_LENGTH
        self._bits = current_bits() - _GUARD_BITS
        self.order = max(least_order, round(_ORDER_PER_BIT * self._bits))

    @property
    def length(self) -> float:
        """Of the last step; the next one starts from it."""
        return self._guess

    @length.setter
    def length(self, known: float) -> None:
        """Start the next step from this length."""
        self._guess = known

    def fraction_bits(self, state: Sequence[arb]) -> int:
        """How many bits after the point leave the largest component exact at the precision in force."""
        return self._bits - max(0, math.ceil(max(map(log2_of, state))))

    def exact(self, state: Sequence[arb]) -> tuple[arb, ...]:
        """Exact numbers next to the midpoints, on the grid of the recurrence."""
        bits = self.fraction_bits(state)
        unit = arb((1, -bits))
        return tuple(fixed(x, bits) * unit for x in state)

    def advance(self, middle: Sequence[arb], left: arb | None, halvings: int) -> tuple[arb, list[arb_poly]]:
        """The length and the polynomials in τ of a step; halved as often as asked, and not longer than what is left."""
        bits = self.fraction_bits(middle)
        start = [fixed(x, bits) for x in middle]
        guess = self._guess / 2 if halvings else rounded(self._guess * _GUESSED_CHANGE)
        for tries in range(_LARGEST_TRIES):
            table = self._recurrence.coefficients(start, fixed(arb(guess), bits), self.order, bits)
            change = 1.0 if halvings else self._change(table)
            if change <= _KEPT_CHANGE or tries == _LARGEST_TRIES - 1:
                break
            guess = rounded(guess * change)  # a multiple of rounding errors is no coefficient
        length = rounded(guess * min(change, _KEPT_CHANGE))
        h = arb(length)
        if left is not None and not 2 * h < left:
            h = arb(rounded(approximate(left) / 2)) if h < left else left
        wide = bits + _GUARD_BITS  # the coefficient k has k times the error of the ratio
        ratio = fixed((h / guess).mid(), wide)
        powers = [1 << wide]
        for _ in range(self.order):
            powers.append((powers[-1] * ratio) >> wide)
        self._guess = length
        unit = arb((1, -bits))
        return h, [
            arb_poly(fmpz_poly([x, *((a * b) >> wide for a, b in zip(row[1:], powers[1:], strict=True))])) * unit
            for x, row in zip(start, table, strict=True)
        ]

    def _change(self, table: list[list[int]]) -> float:
        """By how much the length may change for last terms near the rounding errors and sums that are not too large."""
        sizes = [max(map(int.bit_length, column)) for column in zip(*table, strict=True)]
        noise = _noise(sizes)
        last = max((k for k in range(self.order + 1) if sizes[k] > noise), default=0)
        tail = float(sizes[-1])
        if last < self.order - 2:
            before = max(last - 8, 0)
            slope = max((sizes[before] - sizes[last]) / max(1, last - before), 0.3)
            tail = noise - (self.order - last) * slope
        change = min(_LARGEST_CHANGE, 2 ** ((_TAIL_BITS - tail) / self.order))
        top = max(sizes[:2]) + _LARGEST_SUM_BITS
        for k in range(2, self.order + 1):
            if sizes[k] > top:
                change = min(change, 2 ** ((top - sizes[k]) / k))
        return change


@lru_cache(_KEPT_FIELDS)
def _recurrence(field: VectorField) -> TaylorRecurrence:
    """Compiled once for a field, which is known by its identity."""
    return TaylorRecurrence(field.functions)


def _noise(sizes: Sequence[int]) -> int:
    """Bits of coefficients that may be rounding errors alone; a stiff spring in the field enlarges them."""
    late, before = max(sizes[-_LAST_TERMS:]), max(sizes[-2 * _LAST_TERMS : -_LAST_TERMS], default=0)
    flat = late + 1 >= before and late + _DECAYED_BITS <= max(sizes[:2])
    return max(_NOISE_BITS, late + 1) if flat else _NOISE_BITS


def rounded(length: float) -> float:
    """A length of few bits, so that sums of lengths are exact."""
    mantissa, exponent = math.frexp(length)
    return math.ldexp(math.floor(mantissa * 2**_STEP_BITS), exponent - _STEP_BITS)


def cauchy_plan(field: VectorField, solution: Sequence[arb_poly], h: arb) -> tuple[int, int]:
    """A disc and a length of the series for which Cauchy's estimate leaves out what the last bits of the coefficients
    hide anyway."""
    degrees = field.degrees([max(p.degree(), 0) for p in solution])
    known = [degree for degree in degrees if degree is not None]
    shortest = max([p.degree() for p in solution] + known) + 1
    if len(known) == len(degrees):
        return _DISCS[0], shortest
    best: tuple[int, int] | None = None
    hidden = current_bits() - _GUARD_BITS + _TAIL_BITS
    around = arb((0, 0), (1, 0))
    starts = [p(0) for p in solution]
    sizes = [arb_poly([0, *map(abs, p.coeffs()[1:])]) for p in solution]
    for disc in _DISCS:
        reaches = [around * size(disc) for size in sizes]
        box = [acb(start + reach, reach) for start, reach in zip(starts, reaches, strict=True)]
        bounds = [abs(value) for value in field.values_on_complex_box(box)]
        if not all(bound.is_finite() for bound in bounds):
            break
        largest = max(log2_of(bound.upper()) for bound in bounds) + max(log2_of(h), 0.0)
        needed = math.ceil((largest + hidden) / math.log2(disc)) + 1
        if best is None or needed < best[1]:
            best = disc, needed
    return (best[0], max(best[1], shortest)) if best else (_DISCS[0], shortest)
