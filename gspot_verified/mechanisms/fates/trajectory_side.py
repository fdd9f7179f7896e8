"""On which side of the distinguished trajectory all states of a set lie: the sign of C_1 of each of them.

Proof page: ``proofs/fates.md``, Theorem F2.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, arb_mat, arb_poly

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.krawczyk import proved_zero
from gspot_verified.integrator.box_steps.error_set import ErrorSet
from gspot_verified.mechanisms.approach.capture import Capture
from gspot_verified.mechanisms.approach.distinguished import FlowBounds, force_rest, taylor_in_p
from gspot_verified.mechanisms.approach.slip_flow import ClosedFlow
from gspot_verified.numbers.balls import add_remainder, hull
from gspot_verified.numbers.evidence import at_most, every, in_interior, inside, less, signed, theorem
from gspot_verified.numbers.verdict import Evidence


@dataclass(frozen=True)
class TrajectorySide:
    """The distinguished trajectory of one G-spot, lambda = ``force``(p) + ``rest`` p^(``order`` + 1) [-1, 1] for
    0 <= p <= ``last``, and a region (components, then lambda) in which Theorem A2 compares slip with it.

    ``p_and_b`` are p and b of a state. ``evidence``: what holds in the region.
    """

    p_and_b: BoxProgram
    region: tuple[arb, ...]
    last: arb
    force: arb_poly
    rest: arb
    order: int
    evidence: Evidence

    def sign(self, states: ErrorSet, neighbourhood: Capture) -> tuple[int, Evidence] | None:
        """The sign of C_1 of every state, with what shows it; None: they may lie on both sides, or are too far away.

        ``neighbourhood`` is the capture of the states.
        """
        box = [hull([side, middle]) for side, middle in zip(states.enclosure(), states.middle, strict=True)]
        values, slopes = self.p_and_b.gradients(box)
        p, b = values
        *sides, forces = self.region
        near = every([
            *(inside(own, side) for own, side in zip(neighbourhood.box, sides, strict=False)),
            less(0, p), at_most(p.upper(), self.last), inside(-b / p, forces),
        ])  # fmt: skip
        if near is None:
            return None
        # b - b_distinguished = b + p lambda_distinguished(p), by the mean value form in the coordinates of the set.
        weighted = arb_poly([0, 1]) * self.force
        steepness = weighted.derivative()(p)
        row = arb_mat([[at_b + steepness * at_p for at_p, at_b in zip(*slopes, strict=True)]])
        p_middle, b_middle = self.p_and_b.values(list(states.middle))
        moves = (row * states.C) * states.initial + (row * states.Q) * states.errors
        deviation = add_remainder(
            b_middle + weighted(p_middle) + moves[0, 0], self.rest * p.upper() ** (self.order + 2)
        )
        found = signed(deviation)
        if found is None or found[0] == 0:
            return None
        shown = theorem("proofs/fates.md, Theorem F2", self.evidence, near, found[1])
        return None if shown is None else (found[0], shown)


def trajectory_side(
    flow: ClosedFlow,
    place: Sequence[arb],
    region: Sequence[arb],
    order: int,
    last: arb,
    disc: arb,
    p_and_b: BoxProgram,
) -> TrajectorySide | None:
    """The trajectory's polynomial and the hypotheses of Theorem F2 in the region; None where one is not certain.

    ``flow`` has two components, ``p_and_b`` are p and b of them, ``place`` encloses a G-spot in the region. ``region``:
    a box of the components, then lambda; ``order``, ``last`` < ``disc`` are free choices.
    """
    field = flow.by_p()
    *sides, forces = region
    only = proved_zero(p_and_b.values, lambda box: p_and_b.gradients(box)[1], sides)
    bounds = FlowBounds.on(field, region)
    first, second, third = BoxProgram([flow.alpha_1, flow.alpha_2, flow.alpha_3], flow.dimension).values(sides)
    if only is None or bounds is None:
        return None
    goal = second / (third - first)
    sound = every([
        only[1], less(third, first), less(first, 0), in_interior(goal, forces),
        *(inside(at, side) for at, side in zip(place, sides, strict=True)),
    ])  # fmt: skip
    if sound is None:
        return None
    try:
        trajectory = taylor_in_p(field, place, order)
    except ValueError:
        return None
    rest = None if trajectory is None else force_rest(field, trajectory, last, disc, bounds)
    if trajectory is None or rest is None:
        return None
    growth = bounds.S_force * (bounds.S_state * last).exp()
    keeps = less(bounds.R_state * growth * last, bounds.exponent)
    shown = every([sound, less(0, last), less(last, disc), keeps])
    if shown is None:
        return None
    return TrajectorySide(p_and_b, tuple(region), last, trajectory.force, rest, order, shown)
