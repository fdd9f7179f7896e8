"""All zeros of k functions of k variables in a box: branch and prune, each zero proved unique in a box of its own.

Proof page: ``proofs/all_g_spots.md``, section 3. Where to split and how far to inflate are free choices.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

from flint import arb, arb_mat, fmpq

from gspot_verified.functions.box_program import BoxProgram, common
from gspot_verified.functions.krawczyk import krawczyk_operator, proved_zero
from gspot_verified.numbers.balls import current_bits, hull, working_bits
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.numbers.evidence import cover_by_boxes, differ, equal, every, inside, less
from gspot_verified.numbers.verdict import Evidence

Box = tuple[arb, ...]

PASSES = ((64, -26), (160, -70), (400, -180))
"""Working precision and the exponent of the least relative width, one pass after the other."""

_NEWTON_STEPS = 12  # a limit of effort
_MANY = 500  # small boxes: isolated zeros leave a few, a curve of zeros leaves ever more
_COARSE = 2.0**-6  # relative width below which a box where a function is undefined is not halved again


@dataclass
class Budget:
    """How many boxes may still be looked at."""

    boxes: int


@dataclass
class Zero:
    """One zero: ``enclosure`` holds it, and in each box of ``regions`` it is the only one.

    ``shown`` has for each of them the inclusion that proves it, and why the zero is no other one, or is this one.
    """

    enclosure: Box
    regions: list[Box]
    shown: list[Evidence | None]

    @property
    def evidence(self) -> Evidence | None:
        """That it is the only zero in each of its regions."""
        return every([equal(len(self.regions), len(self.shown)), *self.shown])


@dataclass
class Zeros:
    """Every zero in the box searched is one of ``zeros`` (which may lie just outside), or lies in a box of ``left``.

    ``settled`` says of each box that was dropped why it holds no further zero; ``halved`` of each box that was divided
    that its halves cover it.
    """

    zeros: list[Zero] = field(default_factory=list)
    left: list[Box] = field(default_factory=list)
    stopped: str = ""
    """Why the search ended before every box was small or excluded; empty when it did not."""
    settled: list[Evidence] = field(default_factory=list)
    halved: list[Evidence | None] = field(default_factory=list)

    @property
    def evidence(self) -> Evidence | None:
        """That no zero was lost, and that the ``zeros`` are different: one box, and one more with each that was
        divided, is settled or left."""
        ended = equal(len(self.settled) + len(self.left), len(self.halved) + 1)
        return every([ended, *self.settled, *self.halved, *(zero.evidence for zero in self.zeros)])


class ZeroSearch:
    """The zeros of a program's functions in its ``variables``; the other components have the values ``given``.

    ``periods`` are the periods of all functions in the variables (None: none), as balls at the precision of the call.
    With an ``objective`` only those zeros are wanted at which it is largest: others may be left out.
    """

    def __init__(
        self,
        program: BoxProgram,
        given: Sequence[arb],
        periods: Sequence[arb | None],
        objective: BoxProgram | None = None,
    ) -> None:
        self._program, self._given, self._periods = program, list(given), list(periods)
        self._objective = objective
        self._reached: arb | None = None  # a value that the objective takes at a known zero
        self._size = len(program.variables)
        self.found = Zeros()

    def run(self, box: Sequence[arb], budget: Budget) -> Zeros:
        """Search the box until nothing is left, the passes or the budget end."""
        self._scale = [float(side.rad()) or 1.0 for side in box]
        self.found.left = [tuple(box)]
        for bits, exponent in PASSES:
            with working_bits(bits):
                self._pass(budget, 2.0**exponent)
            if not self.found.left or self.found.stopped:
                break
        return self.found

    def _pass(self, budget: Budget, least: float) -> None:
        waiting, self.found.left = self.found.left, []
        while waiting:
            if budget.boxes <= 0:
                self.found.stopped = "the budget of boxes ended"
            elif len(self.found.left) >= _MANY:
                self.found.stopped = f"zeros may form a curve: more than {_MANY} small boxes could not be settled"
            if self.found.stopped:
                self.found.left += waiting
                return
            budget.boxes -= 1
            box = waiting.pop()
            rest = self._pruned(box)
            if isinstance(rest, Evidence):
                self.found.settled.append(rest)
                continue
            width = max(float(side.rad()) / scale for side, scale in zip(rest, self._scale, strict=True))
            if width < least or (width < _COARSE and self._undefined_at_middle(rest)):
                self.found.left.append(rest)
            else:
                parts = self._halves(rest)
                self.found.halved.append(covered(parts, rest))
                waiting += parts

    def state(self, box: Sequence[arb]) -> list[arb]:
        """The whole state with these sides as variables."""
        state = list(self._given)
        for i, side in zip(self._program.variables, box, strict=True):
            state[i] = side
        return state

    def _pruned(self, box: Box) -> Box | Evidence:
        """A part of the box with all of its zeros that are not known yet; or why there are none."""
        if (known := self.known(box)) is not None:
            return known
        state = self.state(box)
        if (away := _not_zero(self._program.values(state))) is not None:
            return away
        values, rows = self._program.mean_values_and_gradients(state)
        self._rows = rows
        if (away := _not_zero(values)) is not None:
            return away
        if len(rows) != self._size:
            return box
        if (below := self._below(state)) is not None:
            return below
        middle = [side.mid() for side in box]
        near = [[entry.mid() for entry in row] for row in rows]
        contracted = krawczyk_operator(self._program.values(self.state(middle)), rows, near, box)
        if contracted is None:
            return box
        sides = []
        for new, old in zip(contracted, box, strict=True):
            if (apart := differ(new, old)) is not None:
                return apart
            sides.append(common(old, new))
        rest = tuple(sides)
        if any(new.rad() >= old.rad() > 0 for new, old in zip(contracted, box, strict=True)):
            return rest
        self._prove_near(rest)
        return self.known(rest) or rest

    def _below(self, state: list[arb]) -> Evidence | None:
        """That the objective stays below a value that it takes at a known zero."""
        if self._objective is None or self._reached is None:
            return None
        return less(self._objective.mean_values(state)[0], self._reached)

    def _undefined_at_middle(self, box: Box) -> bool:
        return not all(value.is_finite() for value in self._program.values(self.state([side.mid() for side in box])))

    def known(self, box: Sequence[arb]) -> Evidence | None:
        """That the box lies in a region whose only zero is known."""
        regions = (region for zero in self.found.zeros for region in zero.regions)
        return next((shown for region in regions if (shown := self.lies_in(box, region)) is not None), None)

    def lies_in(self, box: Sequence[arb], region: Sequence[arb]) -> Evidence | None:
        """That the box, moved by whole periods, lies in the region."""
        return every(
            next(
                (shown for moved in self._copies(side, outer, period) if (shown := inside(moved, outer)) is not None),
                None,
            )
            for side, outer, period in zip(box, region, self._periods, strict=True)
        )

    def _apart(self, box: Sequence[arb], other: Sequence[arb]) -> Evidence | None:
        """That on one side no translate of the box meets the other one."""
        sides = zip(box, other, self._periods, strict=True)
        by_side = (
            every(differ(moved, outer) for moved in self._copies(side, outer, period)) for side, outer, period in sides
        )
        return next((shown for shown in by_side if shown is not None), None)

    def _copies(self, side: arb, target: arb, period: arb | None) -> list[arb]:
        """The side moved by the numbers of periods that can bring it to the target."""
        if period is None:
            return [side]
        turns = round(float((target.mid() - side.mid()) / period.mid()))
        return [side + period * k for k in (turns - 1, turns, turns + 1)]

    def _prove_near(self, box: Box) -> None:
        """Add the zero that Newton's method finds from here, if a box around it proves it and it is new."""
        point = self._newton(box, arb(2) ** -40)
        if point is None:
            return
        least = arb(2) ** (16 - current_bits())
        for factor in (2, 1 / 16, 2.0**-14):
            region = tuple(
                x + arb(0, arb(factor) * side.rad() + least * (1 + abs(x)).upper())
                for x, side in zip(point, box, strict=True)
            )
            proved = self._krawczyk(region)
            if proved is not None:
                self._add(tuple(proved[0]), region, proved[1])
                return

    def sharpened(self, zero: Zero) -> Box:
        """A narrower enclosure of a zero, at the working precision in force."""
        small = arb(2) ** (16 - current_bits())
        point = self._newton(zero.enclosure, small)
        for _ in range(8 if point is not None else 0):
            region = tuple(x + arb(0, (small * (1 + abs(x))).upper()) for x in point or ())
            proved = self._krawczyk(region)
            if proved is not None and (same := self.same(proved[0], zero)) is not None:
                zero.regions.append(region)
                zero.shown.append(every([proved[1], same]))
                return tuple(proved[0])
            small = small * 64
        return zero.enclosure

    def same(self, box: Sequence[arb], zero: Zero) -> Evidence | None:
        """That a zero in the box is this one."""
        by_region = (self.lies_in(box, region) for region in zero.regions)
        return next((shown for shown in by_region if shown is not None), None)

    def _krawczyk(self, region: Sequence[arb]) -> tuple[list[arb], Evidence] | None:
        return proved_zero(
            lambda at: self._program.values(self.state(at)),
            lambda at: self._program.gradients(self.state(at))[1],
            region,
        )

    def _newton(self, box: Box, small: arb) -> list[arb] | None:
        point = [side.mid() for side in box]
        for _ in range(_NEWTON_STEPS):
            values, rows = self._program.gradients(self.state(point))
            try:
                step = arb_mat([[x.mid() for x in row] for row in rows]).solve(arb_mat([[v.mid()] for v in values]))
            except ZeroDivisionError:
                return None
            moves = [step[i, 0].mid() for i in range(self._size)]
            if not all(move.is_finite() for move in moves):
                return None
            point = [(x - move).mid() for x, move in zip(point, moves, strict=True)]
            if any(abs(x - side.mid()) > 3 * side.rad() for x, side in zip(point, box, strict=True)):
                return None
            if all(abs(move) <= small * side.rad() for move, side in zip(moves, box, strict=True)):
                break
        return point

    def _add(self, enclosure: Box, region: Box, inclusion: Evidence) -> None:
        """Keep a proved zero: a new one, or one more region of a known one, or (when that is not certain) nothing."""
        for zero in self.found.zeros:
            if (same := self.same(enclosure, zero)) is not None:
                zero.regions.append(region)
                zero.shown.append(every([inclusion, same]))
                return
        others = [self._apart(enclosure, zero.enclosure) for zero in self.found.zeros]
        if None not in others:
            self.found.zeros.append(Zero(enclosure, [region], [every([inclusion, *others])]))
            if self._objective is not None:
                (value,) = self._objective.mean_values(self.state(enclosure))
                if value.is_finite() and (self._reached is None or value > self._reached):
                    self._reached = value.lower()

    def _halves(self, box: Box) -> list[Box]:
        return halves(box, self._split_along(box))

    def _split_along(self, box: Box) -> int:
        """The variable that moves the functions most, unless another side is wider by far."""
        widths = [float(side.rad()) / scale for side, scale in zip(box, self._scale, strict=True)]
        weights = [0.0] * self._size
        for row in self._rows:
            parts = [float(entry.abs_upper()) * float(side.rad()) for entry, side in zip(row, box, strict=True)]
            total = sum(parts)
            if 0 < total < math.inf:
                weights = [weight + part / total for weight, part in zip(weights, parts, strict=True)]
        j = weights.index(max(weights))
        widest = widths.index(max(widths))
        return widest if not weights[j] > 0 or widths[widest] > 64 * widths[j] else j


def _not_zero(values: Sequence[arb]) -> Evidence | None:
    """That one of the enclosures does not hold 0."""
    return next((shown for value in values if (shown := differ(0, value)) is not None), None)


def halves(box: Box, j: int) -> list[Box]:
    """The box divided along the variable j."""
    middle, radius = box[j].mid(), box[j].rad()
    return [(*box[:j], middle + sign * radius / 2 + arb(0, radius / 2), *box[j + 1 :]) for sign in (1, -1)]


def covered(parts: Sequence[Box], box: Box) -> Evidence | None:
    """That the parts cover the box."""
    return cover_by_boxes(map(_ends, parts), _ends(box))


def _ends(box: Box) -> tuple[list[fmpq], list[fmpq]]:
    """The exact ends of its sides."""
    pairs = [Dyadic.from_ball(side).endpoints() for side in box]
    lower, upper = ([fmpq(end.numerator, end.denominator) for end in ends] for ends in zip(*pairs, strict=True))
    return lower, upper


def clusters(boxes: Sequence[Box]) -> list[Box]:
    """Boxes that meet are joined to the smallest box around them."""
    joined: list[Box] = []
    for box in boxes:
        while (other := next((old for old in joined if _meet(old, box)), None)) is not None:
            joined.remove(other)
            box = tuple(hull([x, y]) for x, y in zip(box, other, strict=True))
        joined.append(box)
    return joined


def _meet(left: Box, right: Box) -> bool:
    return all(x.overlaps(y) for x, y in zip(left, right, strict=True))
