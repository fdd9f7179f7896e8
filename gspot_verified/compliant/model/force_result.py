"""The state of the contact phase at one time, in balls, and what its accuracy rests on."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from flint import arb, fmpq

from gspot_verified.compliant.model.normal_form import CompliantModel
from gspot_verified.numbers.balls import ball_text
from gspot_verified.numbers.verdict import NoTruthValue, Reason
from gspot_verified.numbers.written import Written


@dataclass(frozen=True, slots=True)
class CompliantForce(NoTruthValue, Written):
    """The contact phase at one time: the contact force and b, y, v, z in the units of the paper, in balls.

    ``time`` is measured from the G-spot: p = alpha_1 t. The numbers are those of the contact phase, and those of
    the model as long as contact has lasted. ``slow`` is the force of the slow part and the mean force together.
    ``fast_by_bound``: the fast part entered as a bound, not by quadrature. ``by_series``: the motion comes from its
    power series about the initial state; then the two parts are not known apart and are not finite.
    """

    ask: ClassVar[str] = ".reached says whether the accuracy was reached"
    written: ClassVar[str] = "model t=time p force b y v z slow fast fast_by_bound by_series digits reached reason"

    model: CompliantModel
    time: fmpq
    force: arb
    b: arb
    y: arb
    v: arb
    z: arb
    slow: arb
    fast: arb
    fast_by_bound: bool
    digits: int
    reached: bool
    reason: Reason | None = None
    by_series: bool = False

    @property
    def p(self) -> fmpq:
        """alpha_1 t."""
        return self.model.alpha_1 * self.time

    def __str__(self) -> str:
        part = "bounded by" if self.fast_by_bound else "="
        parts = f"fast part {part} {ball_text(self.fast, 5)}"
        rows = [
            f"λ_N = {ball_text(self.force, self.digits)} at t = {self.time}, p = {self.p}",
            "  by the power series about the initial state"
            if self.by_series
            else f"  slow part and mean force {ball_text(self.slow, self.digits)}, {parts}",
        ]
        rows += [f"  {name} = {ball_text(getattr(self, name), self.digits)}" for name in "byvz"]
        if self.reason is not None:
            rows.append(f"  {self.reason.value}")
        return "\n".join(rows)
