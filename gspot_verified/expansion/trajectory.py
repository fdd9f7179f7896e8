"""The distinguished trajectory of Theorem 1 up to a given order, as a frozen result: exact, or in balls.

Its value at a point: in balls, or exactly where balls of all precisions tried are wide.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar, Literal, TypeVar

from flint import arb, arb_poly, fmpq, fmpq_poly

from gspot_verified.expansion.series.legend import DELTA_FACTORS, SCALES, InTwo, in_two, latex_left_side, left_side
from gspot_verified.expansion.series.recursion import Recursion
from gspot_verified.expansion.series.spaces import SpacePolynomial
from gspot_verified.expansion.series.system import SymbolsError, System
from gspot_verified.expansion.text import (
    LATEX,
    PLAIN,
    Style,
    exact_text,
    joined,
    polynomial_text,
    times_power,
)
from gspot_verified.expansion.time_series import Table, TimeSeries
from gspot_verified.functions.rings import BALLS
from gspot_verified.numbers.balls import (
    MAX_WORKING_BITS,
    ExactInput,
    ball,
    bits_for_digits,
    checked_bits,
    exact,
    relative_bits,
    working_bits,
)
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written

_LEAST_BITS = 32  # a limit of input: ValueError beyond it
_MOST_BITS = 1_000_000  # a limit of input: ValueError beyond it


def expand_in_balls(
    system: System, order: int, bits: int, progress: Callable[[int, int], None] | None = None
) -> Trajectory:
    """The terms as balls, computed with ``bits`` working bits, whatever the numbers of the system.

    Exact coefficients of order n have about n^2 bits; balls have as many at every order, so that high orders cost a
    small part of the time. ``accuracy.certain_bits`` says what is left of the bits.

    :raises TypeError: ``order`` is not an int.
    :raises SymbolsError: the numbers of the system are symbols.
    :raises ValueError: ``order`` is not in 1..2000, or ``bits`` not in 32..10^6.

    >>> from gspot_verified.testing import extended_example
    >>> trajectory = expand_in_balls(extended_example(chi=1), 7, 100)
    >>> trajectory.p[6].coefficients()[1].contains(-96), trajectory.accuracy.certain_bits > 80
    (True, True)
    """
    order = checked_order(order)
    bits = checked_bits(bits, _LEAST_BITS, _MOST_BITS)
    trajectory = terms_of(_in_balls(system, bits), order, bits, progress)
    certain = certain_bits_of(trajectory)
    assert certain is not None
    digits = max(1, math.floor((certain - 1) / math.log2(10)))
    return replace(trajectory, accuracy=Accuracy(digits, certain, bits, 1))


def _in_balls(system: System, bits: int) -> System:
    """The same system with balls for its numbers."""
    if not all(isinstance(value, fmpq | arb | int) for value in system.point):
        raise SymbolsError("balls need numbers: put numbers in the place of the symbols")
    with working_bits(bits):
        return replace(system, ring=BALLS, point=tuple(arb(value) for value in system.point))


_COMPARED_BITS = 64  # for sizes alone
_LEAST_GAIN = 4  # certain bits that an attempt must win, or it was the last
_ROOM = 32  # bits beyond those that were missing
_MOST_TIMES_FIRST = 16  # the first precision, against endless work; then AccuracyWarning

T = TypeVar("T")


class AccuracyWarning(UserWarning):
    """A result in balls is valid, and wider than was asked."""


@dataclass(frozen=True, slots=True)
class Accuracy(NoTruthValue, Written):
    """What was asked and what was reached.

    ``certain_bits`` is that of the least accurate coefficient, see :func:`certain_bits`. ``attempts`` counts how often
    the expansion was computed.
    """

    ask: ClassVar[str] = ".reached says whether the asked accuracy was reached"
    written: ClassVar[str] = "digits reached certain_bits working_bits"

    digits: int
    certain_bits: int
    working_bits: int
    attempts: int

    @property
    def reached(self) -> bool:
        """Whether every coefficient has the asked accuracy."""
        return self.certain_bits >= bits_for_digits(self.digits)

    def __str__(self) -> str:
        bits = f"the least accurate coefficient has {max(self.certain_bits, 0)} certain bits"
        if self.reached:
            return f"accuracy of {self.digits} digits reached: {bits}"
        return f"ACCURACY NOT REACHED: {self.digits} digits were asked, {bits}"


def certain_bits(orders: Iterable[Sequence[arb]]) -> int:
    """The certain bits of the least accurate coefficient; ``orders`` has the coefficients of each order of delta.

    A coefficient that is certainly not zero counts relative to itself. One whose ball holds zero counts relative to
    the largest coefficient of its order and the orders before: it may be exactly zero.

    >>> from flint import fmpq
    >>> with working_bits(60):
    ...     certain_bits([[arb(1000)], [arb(1, fmpq(1, 1024)), arb(0, fmpq(1, 1024))]])
    9
    """
    worst, scale = MAX_WORKING_BITS, arb(0)
    with working_bits(_COMPARED_BITS):
        for coefficients in orders:
            for value in coefficients:
                if not value.is_finite():
                    return -MAX_WORKING_BITS
                scale = max(scale, value.abs_lower().lower())  # exact numbers: their order is certain
            for value in coefficients:
                holds_zero = value.contains(0) and not value.is_exact()
                worst = min(worst, relative_bits(arb(scale, value.rad()) if holds_zero else value))
    return worst


def until_accurate(
    attempt: Callable[[int], tuple[T, int | None]], digits: int, first_bits: int
) -> tuple[T, Accuracy | None]:
    """``attempt(bits)`` with more bits each time, until its result has the asked digits or more bits do not help.

    ``attempt`` gives a result and its :func:`certain_bits`, or None where the result is exact. Where the accuracy is
    not reached an :class:`AccuracyWarning` says so.
    """
    goal, bits, attempts = bits_for_digits(digits), first_bits, 1
    result, certain = attempt(bits)
    while certain is not None and certain < goal:
        following = min(bits + goal - certain + _ROOM, 4 * bits)
        if following > _MOST_TIMES_FIRST * first_bits:
            break
        better, more = attempt(following)
        attempts += 1
        if more is None or more < certain + _LEAST_GAIN:
            break
        result, certain, bits = better, more, following
    if certain is None:
        return result, None
    accuracy = Accuracy(digits, certain, bits, attempts)
    if not accuracy.reached:
        warnings.warn(str(accuracy), AccuracyWarning, stacklevel=3)
    return result, accuracy


_LOST_BITS = 10  # that a value may lack before more are used
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
            enclosure = ball(value((ball(place[0]), ball(place[1])), True))
            if relative_bits(enclosure) >= bits - _LOST_BITS:
                return enclosure
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


MAX_ORDER = 2000  # a limit of input: ValueError beyond it
_GUARD_BITS = 30  # bits beyond those asked for, lost on the way; any number is right
_BITS_PER_ORDER = 3  # of the first attempt, by trial: more follow where they are too few
_SCALARS = ("p", "b", "y", "v", "z", "lambda_n")

Terms = tuple[SpacePolynomial, ...]


@dataclass(frozen=True)
class Trajectory(Written):
    """The terms of orders 0..order-1 of delta of the scaled variables; paper, th:1.

    ``p[n]`` is p_n(s), a polynomial in the space that the theorem states; ``xi[i][n]`` is the term of component i.
    ``accuracy`` says how accurate coefficients in balls are; None where they are exact.

    :raises ValueError: a variable has another number of terms than ``order``.
    """

    scaled: ClassVar[Literal[True]] = True
    scales: ClassVar[tuple[str, ...]] = SCALES
    written: ClassVar[str] = "name=system.name order accuracy scaled scales state=rows.state contact=rows.contact"

    system: System
    order: int
    xi: tuple[Terms, ...]
    p: Terms
    b: Terms
    y: Terms
    v: Terms
    z: Terms
    lambda_n: Terms
    accuracy: Accuracy | None = None

    def __post_init__(self) -> None:
        for name, terms in self.terms().items():
            if len(terms) != self.order:
                raise ValueError(f"{self.system.name}: {name} has {len(terms)} terms, not {self.order}, the order")

    @property
    def rows(self) -> InTwo[list[list[str]]]:
        """For each variable and order the coefficients of s^0, s^1, ... as exact text."""
        rows = {
            key: [[exact_text(value) for value in term.coefficients()] for term in terms]
            for key, terms in self.terms().items()
        }
        return in_two(rows, self.system.names)

    @property
    def pulls(self) -> bool:
        """Whether the mean force, λ_N at s = 0 and delta = 0, is certainly negative, as no contact force can be."""
        value = self.lambda_n[0].at_zero()
        return isinstance(value, fmpq | arb) and bool(value < 0)

    def terms(self) -> dict[str, Terms]:
        """All terms by name: xi_1, xi_2, ..., p, b, y, v, z, lambda_n."""
        named = {f"xi_{i + 1}": terms for i, terms in enumerate(self.xi)}
        return {**named, **{name: getattr(self, name) for name in _SCALARS}}

    def in_time(self) -> TimeSeries:
        """The unscaled variables xi - xi*, p, b, y, v, z, lambda_N as polynomials in t and epsilon.

        Paper, Corollary of th:1: delta^n s^k is t^k epsilon^((n - 2 k)/3), times the scale of the variable.
        """
        tables = {name: self._table(getattr(self, name), DELTA_FACTORS[name]) for name in _SCALARS}
        components = tuple(self._table(terms, DELTA_FACTORS["xi"]) for terms in self.xi)
        return TimeSeries(order=self.order, xi=components, state=self.system.state, **tables)

    def _table(self, terms: Terms, factor: int) -> Table:
        table: Table = {}
        for n, term in enumerate(terms):
            for k, value in enumerate(term.coefficients()):
                if self.system.ring.is_zero(value):
                    continue
                power, rest = divmod(n + factor - 2 * k, 3)
                if rest or power < 0:
                    raise ArithmeticError(f"s^{k} delta^{n} has no counterpart t^{k} epsilon^m")
                table[k, power] = value
        return table

    def evaluate(self, s: ExactInput, delta: ExactInput, digits: int = 15) -> dict[str, arb]:
        """Balls around the scaled variables of the truncated expansion at (s, delta).

        This is the value of the polynomials, not of the true trajectory: the terms from delta^order on are left out.
        For rational arguments and terms it is accurate to ``digits`` digits.

        :raises SymbolsError: the numbers of the system are symbols.

        >>> from gspot_verified.testing import extended_example
        >>> value = expand_system(extended_example(chi=1), 8).evaluate(s=1, delta="1/10")
        >>> value["p"]
        [-0.989893000000000 +/- 3e-20]
        """
        place, scale = exact(s, "s"), exact(delta, "delta")
        self.system.check_numbers("values")
        bits, rational = self._bits(digits), self._is_rational
        return {name: scaled_value(terms, (place, scale), bits, rational) for name, terms in self.terms().items()}

    def evaluate_in_time(self, t: ExactInput, epsilon: ExactInput, digits: int = 15) -> dict[str, arb]:
        """Balls around the unscaled variables of the truncated expansion at (t, epsilon); xi minus xi*.

        This is the value of the polynomials of :meth:`in_time`, not of the true trajectory.
        """
        time, small = exact(t, "t"), exact(epsilon, "epsilon")
        self.system.check_numbers("values")
        bits, rational = self._bits(digits), self._is_rational
        tables = self.in_time().tables()
        return {name: value_in_time(table, (time, small), bits, rational) for name, table in tables.items()}

    def _bits(self, digits: int) -> int:
        """Working bits of a value: no fewer than the coefficients have."""
        return max(bits_for_digits(digits) + _GUARD_BITS, 0 if self.accuracy is None else self.accuracy.working_bits)

    @property
    def _is_rational(self) -> bool:
        return isinstance(self.system.ring.number(0), fmpq)

    def __str__(self) -> str:
        names = self.system.names
        lines = [f"{self.system.name}: the distinguished trajectory of Theorem 1, orders of delta below {self.order}"]
        lines += [f"  {line}" for line in SCALES]
        lines += [f"  {left_side(key, names, True)} = {self._text(rows, PLAIN)}" for key, rows in self.terms().items()]
        if self.accuracy is not None:
            lines.append(f"  {self.accuracy}")
        return "\n".join(lines)

    def to_latex(self) -> str:
        r"""An ``align*`` environment with one line for each scaled variable, as in the text."""
        names = self.system.names
        lines = [f"  {latex_left_side(key, names)} &= {self._text(rows, LATEX)}" for key, rows in self.terms().items()]
        return "\\begin{align*}\n" + " \\\\\n".join(lines) + "\n\\end{align*}"

    def _text(self, terms: Terms, style: Style) -> str:
        parts = []
        for n, term in enumerate(terms):
            if not term.is_zero():
                parts.append(times_power(polynomial_text(term.coefficients(), style), style, n))
        parts.append(style.rest.format(style.power(style.delta, self.order)))
        return joined(parts)


def expand_system(
    system: System, order: int, digits: int = 15, progress: Callable[[int, int], None] | None = None
) -> Trajectory:
    """:func:`gspot_verified.mechanisms.expand.expand` for a system: exact, or balls of the asked digits.

    The numbers of a system in balls are what they are: where they are too wide for ``digits`` the result says so.

    :raises TypeError: ``order`` or ``digits`` is not an int.
    :raises ValueError: ``order`` is not in 1..2000.
    :raises GSpotError: a hypothesis of Theorem 1 fails at the point.

    >>> from gspot_verified.testing import extended_example
    >>> trajectory = expand_system(extended_example(chi=1), 7)
    >>> print(str(trajectory).splitlines()[11])
      p/delta^2 = -s + s^2 delta^2 + 2 s^3 delta^4 + (3 s^4 - 96 s) delta^6 + O(delta^7)
    >>> trajectory.in_time().z[0, 4]
    6672/5
    """
    order = checked_order(order)
    if not isinstance(system, System):
        raise TypeError(f"system must be a System, got {type(system).__name__}")

    def attempt(bits: int) -> tuple[Trajectory, int | None]:
        trajectory = terms_of(system, order, bits, progress)
        return trajectory, certain_bits_of(trajectory)

    expansion, accuracy = until_accurate(attempt, digits, first_bits(order, digits))
    return replace(expansion, accuracy=accuracy)


def checked_order(order: int) -> int:
    """The order, if it is one.

    :raises TypeError: it is not an int.
    :raises ValueError: it is not in 1..2000.
    """
    if type(order) is not int:
        raise TypeError(f"order must be an int, got {type(order).__name__}")
    if not 1 <= order <= MAX_ORDER:
        raise ValueError(f"order must lie in 1..{MAX_ORDER}, got {order}")
    return order


def first_bits(order: int, digits: int) -> int:
    """Working bits with which ``digits`` are likely to be reached: each order costs about one bit or more."""
    return bits_for_digits(digits) + _BITS_PER_ORDER * order + 2 * _GUARD_BITS


def terms_of(system: System, order: int, bits: int, progress: Callable[[int, int], None] | None = None) -> Trajectory:
    """The recursion of Theorem 1 run once; in balls with ``bits`` working bits."""
    with working_bits(bits):
        recursion = Recursion(system)
        for n in range(order):
            recursion.advance()
            if progress is not None:
                progress(n + 1, order)
    p, b, y, v, z, force = (tuple(getattr(recursion, name)) for name in _SCALARS)
    return Trajectory(
        system=system, order=order, xi=tuple(zip(*recursion.xi, strict=True)), p=p, b=b, y=y, v=v, z=z, lambda_n=force
    )


def certain_bits_of(trajectory: Trajectory) -> int | None:
    """The certain bits of its least accurate coefficient; None where the coefficients are exact."""
    if not isinstance(trajectory.system.ring.number(0), arb):
        return None
    rows = list(trajectory.terms().values())
    return certain_bits([value for row in rows for value in row[n].coefficients()] for n in range(trajectory.order))
