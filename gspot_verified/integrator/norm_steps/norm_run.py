"""A run by norm steps: long Taylor steps, errors in blocks of eigenvectors. This file only asks for steps.

Proof page: ``proofs/norm_step.md``. Each step is proved in ``norm_step.py``.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from flint import arb, arb_mat, arb_poly

from gspot_verified.integrator.box_steps.choice import log2_of
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.integrator.field.no_series import NoSeriesError
from gspot_verified.integrator.norm_steps.adapted_basis import AdaptedBasis, adapted_basis, pieces_along
from gspot_verified.integrator.norm_steps.chosen_step import ChosenStep, Steps
from gspot_verified.integrator.norm_steps.fast_decay import FastDecay
from gspot_verified.integrator.norm_steps.norm_step import Basis, NormPlan, NormStep, StateSet, defect_bounds, norm_step
from gspot_verified.integrator.norm_steps.slow_curve import SlowCurve, slow_curve
from gspot_verified.integrator.norm_steps.taylor_curve import TaylorCurve, cauchy_plan, rounded
from gspot_verified.numbers.balls import approximate
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Evidence

MAX_STEPS = 200_000  # where no budget is given
_HALVINGS = 30  # of a step that is not proved; then the run is open
_PIECES = (1, 4, 16)
_MARGIN_BITS, _LEAST_MARGIN_BITS = 24, 6  # of a tube beyond what is expected: of a narrow set, of a wide one
_NARROW = 2.0**-60  # radii below which there is room for a wide margin
_MOST_PIECES = 256  # of one slow step
_SLOW_TRIES = 3  # lengths of a slow step; then a resolved one
_DEPENDENCIES = (4.0, 16.0, 64.0)
_WIDE = -24.0  # log2 of a radius from which on a set may be the reason why no step is proved
_DEFECT_BITS = 12.0  # above a state's last bit: what a step's defect adds to narrower sets, however many its pieces
_GROWTH_BITS = 6.0  # that a tube may be wider than the set before it; else shorter pieces are tried
_LARGEST_EXPONENT = 600.0  # of a growth factor that doubles can hold


@dataclass(frozen=True, slots=True)
class NormSegment:
    """One proved step of a run: from ``time`` on."""

    time: arb
    step: NormStep

    @property
    def end_time(self) -> arb:
        """The time at its end."""
        return self.time + self.step.h

    def states(self, tau: arb) -> list[arb]:
        """The states at the times ``time`` + τ h, τ in a ball inside [0, 1]."""
        return self.step.enclosure(tau)


class NormRun:
    """Segments from an initial box; iterate over it. ``reason`` says why the iteration ended early, if it did.

    ``steps``: what an interrupted run has chosen, to be proved again, and who is told of each step that is proved.
    ``slow``: whether steps along a slow manifold are tried, which leave out what has decayed to rounding errors.

    ``least_order``: terms of a step's polynomials at least, which with few bits may cost less than more steps.

    :raises ValueError: a box of another dimension, or a component that is not finite.
    """

    def __init__(
        self,
        field: VectorField,
        box: Sequence[arb],
        time: arb | None = None,
        steps: Steps | None = None,
        slow: bool = True,
        least_order: int = 8,
    ) -> None:
        if len(box) != field.dimension:
            raise ValueError(f"box: expected {field.dimension} components, got {len(box)}")
        if not all(side.is_finite() for side in box):
            raise ValueError("box: every component must be finite")
        self.field, self.end = field, time
        self.steps = Steps(MAX_STEPS) if steps is None else steps
        self.time = arb(0)
        self.reason: str | None = None
        """Why the iteration ended before the time, if it did."""
        self.at_end: Evidence | None = None
        """That the last step took all the time that was left, and that this was > 0; None: the end is not reached."""
        self.budget_ended = False
        """Whether it ended because of the number of steps."""
        self._left = time
        self._curve = TaylorCurve(field, least_order)
        self._decay, self._slow = FastDecay(), slow
        self.set = self._of_box(box)

    def __iter__(self) -> Iterator[NormSegment]:
        while self.steps.left > 0:
            left = self._left = None if self.end is None else self.end - self.time
            step = self._known_step(left) or self._slow_step(left) or self._step(left)
            if step is None:
                self.reason = self._no_step()
                return
            segment = NormSegment(self.time, step)
            self.set = step.end(self._curve.exact([p(arb(1)) for p in step.solution]))
            self.time = segment.end_time
            h = None if step.h is left else step.h
            chosen = ChosenStep(step.solution, h, self._plan_in_use, self._curve.length, self._decay.state)
            self.steps.proved(chosen, self.time)
            if left is not None and step.h is left:
                self.at_end = less(0, left)
            yield segment
            if step.h is left:
                return
        self.reason, self.budget_ended = f"the budget of {self.steps.budget} steps ended", True

    def _no_step(self) -> str:
        """Why no step could be proved, as far as it is known."""
        width = max(log2_of(side.rad()) for side in self.set.enclosure())
        if width > _WIDE:
            return (
                f"no step could be proved: the set that holds the state has grown to a radius of about 2^{width:.0f}, "
                "as the bounds of errors do where something oscillates long and fast, or the solution ceases to exist"
            )
        return "no step could be proved: the solution, or the right-hand side, may cease to exist here"

    def _known_step(self, left: arb | None) -> NormStep | None:
        """A step that was chosen before, proved here; None: nothing is known, or it cannot be proved."""
        chosen = self.steps.known()
        if chosen is None or len(chosen.solution) != self.field.dimension:
            return None
        h = left if chosen.h is None else chosen.h
        if h is None:
            return None
        try:
            step = self._proved(chosen.solution, h, chosen.plan)
        except NoSeriesError:
            return None
        if step is not None:
            self._curve.length, self._decay.state = chosen.length, chosen.decay
        return step

    def _proved(
        self, solution: Sequence[arb_poly], h: arb, plan: NormPlan, defect: Sequence[arb] | None = None
    ) -> NormStep | None:
        """The step, where it can be proved and certainly does not pass the end, which may be a wide ball."""
        if not (self._left is None or h is self._left or h < self._left):
            return None
        self._plan_in_use = plan
        return norm_step(self.field, solution, self.set, h, plan, defect)

    def _of_box(self, box: Sequence[arb]) -> StateSet:
        size = len(box)
        middle = self._curve.exact(box)
        unit = arb_mat(size, size, [int(i == j) for i in range(size) for j in range(size)])
        radii = tuple(abs(side - m).upper() for side, m in zip(box, middle, strict=True))
        return StateSet(middle, Basis(unit, (1,) * size), radii)

    def _step(self, left: arb | None) -> NormStep | None:
        """The next step: as long as the series allows, in more pieces or halved until it can be proved."""
        for halving in range(_HALVINGS):
            try:
                h, solution = self._curve.advance(self.set.middle, left, halving)
                series = cauchy_plan(self.field, solution, h)
                defect = defect_bounds(self.field, solution, h, *series)
                if defect is None:  # then no pieces help
                    continue
                least = _DEFECT_BITS - self._curve.fraction_bits(self.set.middle)
                before = max(least, *(log2_of(side.rad()) for side in self.set.enclosure()))
                best: NormStep | None = None
                for pieces in _PIECES:
                    step = self._proved(solution, h, self._plan(solution, h, series, pieces), defect)
                    best = step or best
                    if step is not None and max(map(log2_of, step.tube)) < before + _GROWTH_BITS:
                        break
                if best is not None:
                    return best
            except (NoSeriesError, np.linalg.LinAlgError):
                continue
        return None

    def _slow_step(self, left: arb | None) -> NormStep | None:
        """A step along the slow manifold, where the decaying parts have died out and it is worth it."""
        bits = self._curve.fraction_bits(self.set.middle)
        for _ in range(_SLOW_TRIES if self._slow else 0):
            length = self._decay.slow_length(bits, self._curve.length)
            if left is not None:
                length = min(length, approximate(left) / 2)
            if not length > 0:
                return None
            length = rounded(length)
            try:
                curve = slow_curve(self.field, self.set.middle, length, self._curve.order, bits)
                if not self._decay.accepts(curve, bits) or curve is None:
                    continue
                step = self._along(curve, length)
            except (NoSeriesError, np.linalg.LinAlgError):
                step = None
            if step is not None:
                return step
            self._decay.failed()
        return None

    def _along(self, curve: SlowCurve, length: float) -> NormStep | None:
        """The step along a slow curve, in shorter pieces where the enclosures of J on longer ones let errors grow."""
        before = max(*(log2_of(side.rad()) for side in self.set.enclosure()), curve.start)
        for dependency in _DEPENDENCIES:
            pieces = pieces_along(curve.jacobian, length, _MOST_PIECES, dependency)
            plan = self._plan_of(arb(length), cauchy_plan(self.field, curve.solution, arb(length)), pieces)
            step = self._proved(curve.solution, arb(length), plan)
            if step is None or max(map(log2_of, step.tube)) < before + _GROWTH_BITS:
                break
        return step

    def _plan(self, solution: Sequence[arb_poly], h: arb, series: tuple[int, int], pieces: int) -> NormPlan:
        bases = []
        for i in range(pieces):
            rows = self.field.on_box([p(arb(2 * i + 1) / (2 * pieces)).mid() for p in solution])[1]
            bases.append(adapted_basis([[approximate(entry) for entry in row] for row in rows]))
        self._decay.passed(bases[-1].values, approximate(h))
        return self._plan_of(h, series, [(i / pieces, (i + 1) / pieces, basis) for i, basis in enumerate(bases)])

    def _plan_of(
        self, h: arb, series: tuple[int, int], pieces: Sequence[tuple[float, float, AdaptedBasis]]
    ) -> NormPlan:
        narrow = all(radius < _NARROW for radius in self.set.radii)
        margin = _MARGIN_BITS if narrow else _LEAST_MARGIN_BITS
        bases, margins = [], []
        for a, b, basis in pieces:
            bases.append(Basis(arb_mat([[arb(value) for value in row] for row in basis.rows]), basis.blocks))
            growth = 2 * max(basis.rate, 0.0) * approximate(h) * (b - a)
            margins.append(arb((1, margin)) * arb(min(growth, _LARGEST_EXPONENT)).exp().mid())
        ends = (arb(0), *(arb(b) for _, b, _ in pieces))
        return NormPlan(ends, tuple(bases), tuple(margins), *series)
