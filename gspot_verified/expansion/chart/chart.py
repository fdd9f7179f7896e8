"""The state of a system as an analytic function of p, b, y, v near its G-spot: where it is one, its power series.

Proof page: ``proofs/chart.md``.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from flint import arb, arb_mat

from gspot_verified.expansion.chart.cone import Cone
from gspot_verified.expansion.chart.near import state_near
from gspot_verified.expansion.series.system import System
from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Expression
from gspot_verified.functions.krawczyk import proved_zero
from gspot_verified.functions.linear import inverse
from gspot_verified.functions.power_series import SeriesOfFunctions, Terms
from gspot_verified.functions.rings import Ring
from gspot_verified.numbers.balls import add_remainder, ball, hull
from gspot_verified.numbers.verdict import Evidence

_ROOM = (1.1, 1.3, 1.7, 2.5)  # times the linear size of a box of states: any numbers are right
_ROUNDING = arb((1, -60))  # beside that size


@dataclass(frozen=True, eq=False)
class Region:
    """``states`` holds X(q) for every q = (p, b, y, v) of the box ``place``, and X(q) is the only state of the box
    ``around`` with this q; ``inverse`` encloses the derivatives of X, the inverses of those of p, b, y, v."""

    place: tuple[arb, ...]
    around: tuple[arb, ...]
    states: tuple[arb, ...]
    inverse: arb_mat
    evidence: Evidence


@dataclass(frozen=True, eq=False)
class Chart:
    """X: the state of ``system`` at given p, b, y, v, with X(0) the G-spot; the system has four components.

    :raises ValueError: it has more.
    """

    system: System

    def __post_init__(self) -> None:
        if len(self.system.point) != len(self._conditions):
            raise ValueError(f"{self.system.name}: p, b, y, v determine a state of four components alone")

    @property
    def _conditions(self) -> tuple[Expression, ...]:
        system = self.system
        return system.p, system.b, system.y, system.v

    @cached_property
    def _program(self) -> BoxProgram:
        return BoxProgram(self._conditions, len(self._conditions))

    def slopes(self) -> list[list[Any]]:
        """The derivatives of X at 0, numbers of the system's ring.

        :raises ZeroDivisionError: those of p, b, y, v are not certainly independent.
        """
        return inverse(self.system.jacobian(), self.system.ring)

    def region(self, place: Sequence[arb], beside: Region | None = None) -> Region | None:
        """The states over a box of (p, b, y, v) that holds 0, or meets that of ``beside``; None: it is not certain that
        there is one X on it.

        :raises ValueError: the box does neither.
        """
        if not all(side.is_finite() for side in place):
            raise ValueError("the box must be finite")
        if beside is None:
            if not all(side.contains(0) for side in place):
                raise ValueError("the box must hold p = b = y = v = 0")
            known: Sequence[arb] = [ball(value) for value in self.system.point]
        else:
            common = [one.intersection(other) for one, other in zip(place, beside.place, strict=True)]
            met = self._region(common, beside.states, ())
            if met is None or not all(map(arb.contains, beside.around, met.states)):
                return None
            known = met.states
        return self._region(place, known, known)

    def _region(self, place: Sequence[arb], near: Sequence[arb], known: Sequence[arb]) -> Region | None:
        """States over the box, one for each place, in a box that holds ``known``; ``near`` is where to begin."""
        middle = state_near(self._program, near, place)
        if middle is None:
            return None
        turned = _inverse(self._program.gradients(middle)[1])
        if turned is None:
            return None
        sizes = [
            sum((abs(turned[i, j]).upper() * place[j].rad() for j in range(len(place))), _ROUNDING)
            for i in range(len(place))
        ]

        def left(state: Sequence[arb]) -> list[arb]:
            return [value - wanted for value, wanted in zip(self._program.values(state), place, strict=True)]

        for room in _ROOM:
            box = [add_remainder(one, size * arb(room)) for one, size in zip(middle, sizes, strict=True)]
            if known:
                box = [hull([side, at]) for side, at in zip(box, known, strict=True)]
            found = proved_zero(left, lambda state: self._program.gradients(state)[1], box)
            if found is None:
                continue
            states, shown = found
            slopes = _inverse(self._program.gradients(states)[1])
            if slopes is not None:
                return Region(tuple(place), tuple(box), tuple(states), slopes, shown)
        return None

    def chain(self, pieces: Sequence[Cone]) -> list[Region] | None:
        """The region of each part, from p = 0 on; each part meets the one before. None: X is not certain on all."""
        regions = list[Region]()
        for part in pieces:
            found = self.region(part.place, regions[-1] if regions else None)
            if found is None:
                return None
            regions.append(found)
        return regions

    def series(
        self,
        functions: Sequence[Expression],
        rows: Sequence[Sequence[Any]],
        start: Sequence[Any],
        slopes: Sequence[Sequence[Any]],
        terms: Terms,
        ring: Ring,
    ) -> SeriesOfFunctions:
        """The series of functions of the state along X(q(t)), ``rows`` being the terms of q = (p, b, y, v) from order 1
        on, ``start`` the state at t = 0, and ``slopes`` the derivatives of X there.

        :raises ValueError: a function is not analytic there.
        """
        series = SeriesOfFunctions([*functions, *self._conditions], terms, ring)
        series.extend(start)
        for n, row in enumerate(rows, start=1):
            series.extend([terms.zero(n)] * len(row))
            gap = [wanted - series[one][n] for wanted, one in zip(row, self._conditions, strict=True)]
            series.drop_last()
            moved = []
            for line in slopes:
                total = terms.zero(n)
                for factor, part in zip(line, gap, strict=True):
                    total = total + terms.scale(part, factor)
                moved.append(total)
            series.extend(moved)
        return series


def _inverse(rows: Sequence[Sequence[arb]]) -> arb_mat | None:
    """The inverses of all matrices within; None: one of them may be singular."""
    try:
        found = arb_mat([list(row) for row in rows]).inv()
    except ZeroDivisionError:
        return None
    return found if all(entry.is_finite() for entry in found.entries()) else None
