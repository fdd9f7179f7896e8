"""A run by norm steps: long Taylor steps, errors in blocks of eigenvectors. This file only asks for steps.

Proof page: ``proofs/norm_step.md``. Each step is proved in ``norm_step.py``.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from flint import arb, arb_mat, arb_poly

from gspot_verified.balls import approximate
from gspot_verified.integrator.adapted_basis import adapted_basis
from gspot_verified.integrator.field import VectorField
from gspot_verified.integrator.norm_step import Basis, NormPlan, NormStep, StateSet, norm_step
from gspot_verified.integrator.taylor_curve import TaylorCurve, cauchy_plan

MAX_STEPS = 200_000
_HALVINGS = 30
_PIECES = (1, 4)
_MARGIN_BITS = 6
_LARGEST_EXPONENT = 600.0


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

    :raises ValueError: a box of another dimension, or a component that is not finite.
    """

    def __init__(
        self, field: VectorField, box: Sequence[arb], time: arb | None = None, max_steps: int = MAX_STEPS
    ) -> None:
        if len(box) != field.dimension:
            raise ValueError(f"box: expected {field.dimension} components, got {len(box)}")
        if not all(side.is_finite() for side in box):
            raise ValueError("box: every component must be finite")
        self.field, self.end, self.max_steps = field, time, max_steps
        self.time = arb(0)
        self.reason: str | None = None
        """Why the iteration ended before the time, if it did."""
        self._curve = TaylorCurve(field)
        self.set = self._of_box(box)

    def __iter__(self) -> Iterator[NormSegment]:
        for _ in range(self.max_steps):
            left = None if self.end is None else self.end - self.time
            step = self._step(left)
            if step is None:
                self.reason = "no step could be proved: the solution, or the right-hand side, may cease to exist here"
                return
            segment = NormSegment(self.time, step)
            self.set = step.end(self._curve.exact([p(arb(1)) for p in step.solution]))
            self.time = segment.end_time
            yield segment
            if step.h is left:
                return
        self.reason = f"the budget of {self.max_steps} steps ended"

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
                for pieces in _PIECES:
                    plan = self._plan(solution, h, pieces)
                    step = norm_step(self.field, solution, self.set, h, plan)
                    if step is not None:
                        return step
            except (ValueError, ZeroDivisionError, np.linalg.LinAlgError):
                continue
        return None

    def _plan(self, solution: Sequence[arb_poly], h: arb, pieces: int) -> NormPlan:
        bases, margins = [], []
        for i in range(pieces):
            middle = arb(2 * i + 1) / (2 * pieces)
            rows = self.field.on_box([p(middle).mid() for p in solution])[1]
            found = adapted_basis([[approximate(entry) for entry in row] for row in rows])
            bases.append(Basis(arb_mat([[arb(value) for value in row] for row in found.rows]), found.blocks))
            growth = 2 * max(found.rate, 0.0) * approximate(h) / pieces
            margins.append(arb((1, _MARGIN_BITS)) * arb(min(growth, _LARGEST_EXPONENT)).exp().mid())
        disc, length = cauchy_plan(self.field, solution, h)
        return NormPlan(tuple(arb(i) / pieces for i in range(pieces + 1)), tuple(bases), tuple(margins), disc, length)
