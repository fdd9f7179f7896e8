"""One orbit of the plane, followed from a point to the G-spot, as a function of p: states are compared with it.

Proof page: ``proofs/fates.md``, section 2.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb

from gspot_verified.integrator.box_steps.integrate import Run, Segment
from gspot_verified.mechanisms.approach.capture import capture
from gspot_verified.mechanisms.fates.planar_flow import PlanarFlow
from gspot_verified.mechanisms.fates.trajectory_side import TrajectorySide
from gspot_verified.numbers.balls import hull, nonfinite
from gspot_verified.numbers.evidence import every
from gspot_verified.numbers.verdict import Evidence

STEPS = 150  # validated steps of one orbit: a limit against endless work
_FARTHER = 4  # times than the sign of C_1 asks for: so that what lies between two orbits is near the G-spot, too
_FINE = 20  # bits: the times of a step are rounded outward to multiples of 2^-20


@dataclass(frozen=True)
class Reference:
    """An orbit from the p of its ``start`` down to p = 0, as the component ``along`` of the plane over p.

    ``sign`` is that of its C_1, ``evidence`` shows it; ``end`` is the p down to which the orbit is followed.
    """

    plane: PlanarFlow
    along: int
    start: arb
    segments: tuple[Segment, ...]
    end: arb
    sign: int
    evidence: Evidence

    def states(self, p: arb) -> list[arb]:
        """The states at every p of the ball; not finite where it may leave the range from ``end`` to ``start``."""
        time = (self.start / p).log()  # p = start e^-time
        last = self.segments[-1].end_time
        if not (time >= 0 and time <= last):
            return [nonfinite()] * self.plane.by_log_p.dimension
        boxes = []
        for segment in self.segments:
            if segment.end_time < time or segment.time > time:
                continue
            boxes.append(segment.states(_part((time - segment.time) / segment.step.h)))
        return [hull(sides) for sides in zip(*boxes, strict=True)]

    def place(self, p: arb) -> arb:
        """The component at every p of the ball."""
        return self.states(p)[self.along]

    def steepness(self, p: arb) -> arb:
        """Its derivative by p there: p = ``start`` e^-time."""
        return -self.plane.rates.values(self.states(p))[self.along] / p


def reference(plane: PlanarFlow, along: int, side: TrajectorySide, start: Sequence[arb]) -> Reference | None:
    """The orbit from an exact point; None where it does not certainly reach the G-spot on one side."""
    p = plane.p_and_b.values(list(start))[0]
    if not p > 0 or isinstance(plane.supposed(start), str):
        return None
    segments: list[Segment] = []
    shown: list[Evidence | None] = []
    for segment in Run(plane.by_log_p, list(start), max_steps=STEPS):
        segments.append(segment)
        shown.append(segment.step.evidence)
        states = segment.after.enclosure()
        end = p * (-segment.end_time).exp()
        if not end < side.last / _FARTHER:
            continue
        neighbourhood = capture(plane, [*states, arb(0)], None)
        found = None if neighbourhood is None else side.sign(segment.after, neighbourhood)
        if found is not None:
            evidence = every([*shown, found[1]])
            return None if evidence is None else Reference(plane, along, p, tuple(segments), end, found[0], evidence)
    return None


def _part(tau: arb) -> arb:
    """A ball inside [0, 1] that holds all of this one that lies there; its ends are multiples of 2^-20."""
    whole = 1 << _FINE
    lower, upper = (tau * whole).lower().floor().unique_fmpz(), (tau * whole).upper().ceil().unique_fmpz()
    low = 0 if lower is None else min(max(int(lower), 0), whole)
    high = whole if upper is None else min(max(int(upper), 0), whole)
    return arb((low + high, -_FINE - 1), (high - low, -_FINE - 1))
