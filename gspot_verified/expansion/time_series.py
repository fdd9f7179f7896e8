"""The distinguished trajectory as a power series in (t, epsilon), from the original equations.

A second route to Theorem 1: paper, eqs. genSysXi to genSysLN with t_0 = 0, p(0) = 0 and J(xi(0)) = 0, without the inner
scale. With y = epsilon^2 Y and z = epsilon^2 Z the last two equations are Z = -lambda - epsilon Z', lambda = Z - Y (for
other springs and dampers: kappa_1 Z = -lambda - gamma epsilon Z', lambda = kappa_2 (Z - Y)), so

    Y = -2 lambda - epsilon Z',    b = epsilon^2 Y'' - p lambda,    b' = alpha_2 - alpha_3 lambda.

The coefficient of t^k epsilon^m of the last two gives (k alpha_1* - alpha_3*) lambda_(k-1,m) = known terms, as
p = alpha_1* t + higher terms. At t = 0 the synchronisation and J give xi, one linear system for each power of epsilon.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, Literal

from gspot_verified.expansion.series.legend import SCALES, InTwo, in_two, left_side, state_names
from gspot_verified.expansion.series.system import GSpotError, System
from gspot_verified.expansion.text import exact_text, shown
from gspot_verified.functions.layers import LayeredFunctions, Layers, dot, entry, product_coefficient
from gspot_verified.functions.linear import inverse
from gspot_verified.numbers.evidence import differ, equal, every
from gspot_verified.numbers.verdict import Evidence, Reason, Verdict
from gspot_verified.numbers.written import Written

Table = dict[tuple[int, int], Any]
"""The coefficient of t^k epsilon^m under the key (k, m); what is certainly zero is left out."""


@dataclass(frozen=True)
class TimeSeries(Written):
    """The unscaled variables as polynomials in (t, epsilon); ``xi`` holds xi - xi*, component by component.

    ``order`` is the number of orders of delta of the scaled variables that the coefficients stand for.
    """

    scaled: ClassVar[Literal[False]] = False
    scales: ClassVar[tuple[str, ...]] = SCALES
    written: ClassVar[str] = "order scaled scales state=rows.state contact=rows.contact"

    order: int
    xi: tuple[Table, ...]
    p: Table
    b: Table
    y: Table
    v: Table
    z: Table
    lambda_n: Table
    state: tuple[str, ...] = ()

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the components."""
        return state_names(self.state, len(self.xi))

    @property
    def rows(self) -> InTwo[list[tuple[int, int, str]]]:
        """For each variable [k, m, coefficient of t^k epsilon^m], the coefficient as text."""
        rows = {
            key: [(k, m, exact_text(value)) for (k, m), value in sorted(table.items())]
            for key, table in self.tables().items()
        }
        return in_two(rows, self.names)

    def tables(self) -> dict[str, Table]:
        """All tables by name: xi_1, xi_2, ..., p, b, y, v, z, lambda_n."""
        named = {f"xi_{i + 1}": table for i, table in enumerate(self.xi)}
        return {**named, **{name: getattr(self, name) for name in ("p", "b", "y", "v", "z", "lambda_n")}}

    def __str__(self) -> str:
        lines = [f"the distinguished trajectory of Theorem 1 in time, {self.order} orders of delta"]
        lines += [f"  {line}" for line in SCALES]
        for name, table in self.tables().items():
            terms = [
                f"({shown(value)}) t^{k} epsilon^{m}"
                for (k, m), value in sorted(table.items(), key=lambda item: item[0][::-1])
            ]
            lines.append(f"  {left_side(name, self.names, False)} = " + (" + ".join(terms) or "0"))
        return (
            "\n".join(lines).replace(" t^0", "").replace(" epsilon^0", "").replace("t^1 ", "t ").replace("^1\n", "\n")
        )


def time_series(system: System, order: int) -> TimeSeries:
    """The coefficients that Theorem 1 gives with ``order`` orders of delta.

    :raises GSpotError: a hypothesis of Theorem 1 fails at the point.

    >>> from gspot_verified.testing import extended_example
    >>> series = time_series(extended_example(chi=1), 7)
    >>> [series.z[key] for key in ((0, 2), (1, 2), (0, 3), (3, 2), (0, 4))]
    [-2, -8, 8, -368/5, 6672/5]
    """
    system.check()
    solver = _Solver(system, order - 1)
    while solver.next_layer():
        pass
    return solver.result()


class _Solver:
    """The layers found so far; ``top`` is the largest 2 k + 3 m of the coefficients of lambda."""

    def __init__(self, system: System, top: int) -> None:
        ring = system.ring
        self._system, self._top, self._ring, self._zero = system, top, ring, ring.number(0)
        functions = (*system.F, *system.G, system.alpha_1, system.alpha_2, system.alpha_3)
        self._functions = LayeredFunctions(functions, ring)
        self._conditions = LayeredFunctions(system.conditions, ring)
        self._inverse: list[list[Any]] = []
        self._xi = [Layers(ring) for _ in system.point]
        self._p, self._b, self._force = Layers(ring), Layers(ring), Layers(ring)
        self._big_y: list[list[Any]] = []
        self._big_z: list[list[Any]] = []
        self._m = -1

    def next_layer(self) -> bool:
        """Find the next power of epsilon; False when none is left."""
        m = self._m + 1
        last = (self._top + 2 - 3 * m) // 2
        if last < 0:
            return False
        self._m = m
        for series in (*self._xi, self._p, self._b, self._force):
            series.open()
        self._functions.open_layer()
        self._start_layer(m)
        system, force = self._system, self._force
        parts = (system.alpha_3, *system.G)
        middles = [self._functions[f].middle(force, m) for f in parts]
        middle_v = self._p.middle(force, m)
        for k in range(1, last + 1):
            at_point = m == 0 and k == 1
            self._functions.push(system.point if at_point else [series.rows[-1][k - 1] for series in self._xi])
            self._step(k, middle_v, middles[0])
            for series, drift, control, middle in zip(self._xi, system.F, system.G, middles[1:], strict=True):
                pushed = product_coefficient(self._functions[control], force, middle, k - 1, self._zero)
                slope = self._functions[drift].rows[-1][k - 1] + pushed
                series.rows[-1].append(slope / self._ring.number(k))
        self._recover(m)
        return True

    def _step(self, k: int, middle_v: Sequence[Any], middle_b: Sequence[Any]) -> None:
        """p_k, lambda_(k-1) and b_k of this layer."""
        system, functions, zero, m = self._system, self._functions, self._zero, self._m
        index = self._ring.number(k)
        p, force = self._p.rows, self._force.rows
        p[-1].append(functions[system.alpha_1].rows[-1][k - 1] / index)
        third = functions[system.alpha_3].rows
        alpha_1, alpha_3 = p[0][1], third[0][0]
        # All of (p lambda)_k and (alpha_3 lambda)_(k-1) except what lambda_(k-1) of this layer gives.
        force[-1].append(zero)
        in_v = entry(middle_v, k, zero) + dot(p[0], force[-1], k, zero, first=1)
        in_b = entry(middle_b, k - 1, zero) + dot(third[0], force[-1], k - 1, zero)
        if m:
            in_v += dot(p[-1], force[0], k, zero, first=1)
            in_b += dot(third[-1], force[0], k - 1, zero)
        bent = self._big_y[m - 2][k + 2] * self._ring.number((k + 1) * (k + 2)) if m >= 2 else zero
        right_v, right_b = bent - in_v, functions[system.alpha_2].rows[-1][k - 1] - in_b
        factor = index * alpha_1 - alpha_3
        if not self._ring.is_nonzero(factor):
            raise GSpotError(f"{system.name}: beta = alpha_3/alpha_1 is, or may be, the integer {k}")
        force_coefficient = (index * right_v - right_b) / factor
        force[-1][-1] = force_coefficient
        self._b.rows[-1].append(right_v - alpha_1 * force_coefficient)

    def _start_layer(self, m: int) -> None:
        """p, b and xi at t = 0."""
        zero, ring, point = self._zero, self._ring, self._system.point
        before = self._big_y[m - 2] if m >= 2 else [zero] * 3
        start_b = before[2] * ring.number(2)
        self._p.rows[-1].append(zero)
        self._b.rows[-1].append(start_b)
        self._conditions.open_layer()
        if m == 0:
            self._conditions.push(point)
            for series in self._xi:
                series.rows[-1].append(zero)
            return
        rest = self._tried([zero] * len(point))
        if m == 1:
            columns = [self._tried([ring.number(int(i == j)) for i in range(len(point))]) for j in range(len(point))]
            try:
                self._inverse = inverse([list(row) for row in zip(*columns, strict=True)], ring)
            except ZeroDivisionError:
                raise GSpotError(
                    f"{self._system.name}: the Jacobian of (p, b, y, v, J) at the G-spot is singular"
                ) from None
        wanted = [zero, start_b, before[0], before[1], *[zero] * len(self._system.J)]
        right = [w - r for w, r in zip(wanted, rest, strict=True)]
        start_xi = [sum((a * value for a, value in zip(row, right, strict=True)), zero) for row in self._inverse]
        self._conditions.push(start_xi)
        for series, value in zip(self._xi, start_xi, strict=True):
            series.rows[-1].append(value)

    def _tried(self, values: list[Any]) -> list[Any]:
        """The conditions at this power of epsilon for xi(0) = ``values`` at this power."""
        self._conditions.push(values)
        conditions = [self._conditions[condition].rows[-1][0] for condition in self._system.conditions]
        self._conditions.pop()
        return conditions

    def _recover(self, m: int) -> None:
        """Z and Y of this layer."""
        ring, force = self._ring, self._force.rows[-1]
        above = self._big_z[m - 1] if m else []
        moved = [above[k + 1] * ring.number(k + 1) if m else self._zero for k in range(len(force))]
        springs = self._system.regularisation
        first, second, damper = (ring.number(value) for value in (springs.k_1, springs.k_2, springs.c))
        self._big_z.append([(-value - damper * slope) / first for value, slope in zip(force, moved, strict=True)])
        self._big_y.append([z - value / second for z, value in zip(self._big_z[-1], force, strict=True)])

    def result(self) -> TimeSeries:
        """All tables."""
        number = self._ring.number
        speed = [[value * number(k) for k, value in enumerate(row)][1:] for row in self._big_y]
        return TimeSeries(
            order=self._top + 1,
            xi=tuple(self._table(series.rows) for series in self._xi),
            p=self._table(self._p.rows),
            b=self._table(self._b.rows),
            y=self._table(self._big_y, 2),
            v=self._table(speed, 2),
            z=self._table(self._big_z, 2),
            lambda_n=self._table(self._force.rows),
        )

    def _table(self, rows: Sequence[Sequence[Any]], raised: int = 0) -> Table:
        """The coefficients that are not zero, times epsilon^raised."""
        return {
            (k, m + raised): value
            for m, row in enumerate(rows)
            for k, value in enumerate(row)
            if not self._ring.is_zero(value)
        }


def compare_routes(first: TimeSeries, second: TimeSeries) -> Verdict:
    """Whether two routes gave the same coefficients, one by one.

    Balls that do not overlap refute it; balls that overlap leave it undecided, as two numbers in them may differ.
    """
    statement = f"both routes give the same coefficients of t^k epsilon^m ({first.order} orders of delta)"
    other_shape = differ(first.order, second.order) or differ(len(first.xi), len(second.xi))
    if other_shape is not None:
        return Verdict.refuted(statement, "the numbers of orders or of components differ", other_shape)
    same: list[Evidence | None] = [equal(first.order, second.order), equal(len(first.xi), len(second.xi))]
    compared, wide = 0, ""
    others = second.tables()
    for name, table in first.tables().items():
        other = others[name]
        for key in sorted(table.keys() | other.keys()):
            left, right = table.get(key, 0), other.get(key, 0)
            compared += 1
            same.append(equal(left, right))
            if same[-1] is not None:
                continue
            k, m = key
            where = f"{name}: the coefficient of t^{k} epsilon^{m} is {left} and {right}"
            if (apart := differ(left, right)) is not None:
                return Verdict.refuted(statement, where, apart)
            wide = wide or where
    if wide:
        return Verdict.undecided(statement, Reason.WIDE_INPUT, wide)
    return Verdict.proved(statement, every(same), f"{compared} coefficients")
