"""Whether slip from a box of states certainly ends at a G-spot, in finite time and without losing contact.

Proof page: ``proofs/approach.md``, Theorem A1.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from flint import arb

from gspot_verified.mechanisms.approach.slip_flow import Numbers
from gspot_verified.numbers.balls import add_remainder, current_bits
from gspot_verified.numbers.evidence import every, in_interior, less
from gspot_verified.numbers.verdict import Evidence

_ROOM = arb((1, -20))  # of a radius, which has few bits: without it what hardly moves would not be seen to stay
_INFLATIONS = 4  # tries to inflate a box until nothing leaves it: any number is correct


class NumbersOnBoxes(Protocol):
    """Evaluates p, b, u, the α's, F and G on boxes of components that form a closed system."""

    def on(self, box: Sequence[arb]) -> Numbers:
        """On one box."""


@dataclass(frozen=True, slots=True)
class Capture:
    """A neighbourhood that slip never leaves before it reaches a G-spot in it.

    ``box`` holds all later states and the G-spot; ``reach`` bounds their distances, by component, from the states at
    the beginning. ``numbers`` are enclosures on ``box``, ``time`` bounds the time that is left, ``integral_of_b`` the
    integral of |b| over s; ``decay_1`` and ``decay_3`` are lower bounds on -α_1 and -α_3. ``evidence``: the
    hypotheses of Theorem A1.
    """

    box: tuple[arb, ...]
    reach: tuple[arb, ...]
    numbers: Numbers
    time: arb
    integral_of_b: arb
    decay_1: arb
    decay_3: arb
    evidence: Evidence


def capture(numbers: NumbersOnBoxes, states: Sequence[arb], least_slip: arb | None) -> Capture | None:
    """The neighbourhood of the states (with p > 0 and b < 0), or None when a hypothesis could not be verified.

    ``least_slip`` is the surface's velocity below which slip is not positive; None when nothing is asked of u.
    """
    at = numbers.on(states)
    slides = every([less(0, at.p), less(at.b, 0)])
    if slides is None:
        return None
    rounding = arb(2) ** (8 - current_bits())
    inside = at
    for _ in range(_INFLATIONS):
        bounds = _reach(at, inside)
        if bounds is None:
            return None
        # A component that does not move here may move in the neighbourhood: inflate until nothing leaves it.
        box = tuple(
            add_remainder(side, 2 * far + rounding * (1 + abs(side)) + side.rad() * _ROOM)
            for side, far in zip(states, bounds[0], strict=False)
        )
        inside = numbers.on(box)
        bounds = _reach(at, inside)
        if bounds is None:
            return None
        reach, time, integral, first, third = bounds
        stays = every(
            in_interior(add_remainder(old, far), new) for old, new, far in zip(states, box, reach, strict=False)
        )
        if stays is not None:
            break
    else:
        return None
    evidence = every([
        slides, stays, less(0, first), less(0, third), _keeps_pressing(at.force, inside),
        *([] if least_slip is None else [less(least_slip, inside.u)]),
    ])  # fmt: skip
    return (
        None
        if evidence is None
        else Capture(
            box=box,
            reach=tuple(reach),
            numbers=inside,
            time=time,
            integral_of_b=integral,
            decay_1=first,
            decay_3=third,
            evidence=evidence,
        )
    )


def _reach(at: Numbers, inside: Numbers) -> tuple[list[arb], arb, arb, arb, arb] | None:
    """Bounds on the ways of the components, the time left, the integral of |b|, and the two rates of decay."""
    first, third = (-inside.alpha_1).lower(), (-inside.alpha_3).lower()
    if not (first > 0 and third > 0):
        return None
    time = (at.p.abs_upper() / first).upper()
    integral = ((at.b.abs_upper() + inside.alpha_2.abs_upper() * time) / third).upper()
    ways = [(f.abs_upper() * time + g.abs_upper() * integral).upper() for f, g in zip(inside.F, inside.G, strict=True)]
    return ways, time, integral, first, third


def _keeps_pressing(force: arb, inside: Numbers) -> Evidence | None:
    """That λ_N stays positive: dλ/ds = -α_2 + (α_3 - α_1) λ."""
    pushed = less(inside.alpha_2, 0)
    if pushed is not None:
        return pushed
    rate = (inside.alpha_3 - inside.alpha_1).lower()
    return every([less(0, rate), less(inside.alpha_2, rate * force)])
