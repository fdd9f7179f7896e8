"""Where slip from every state of a box ends: one fate for all of them, or none is certain.

Proof page: ``proofs/fates.md``, Theorem F1.
"""

from __future__ import annotations

import enum
from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb

from gspot_verified.mechanisms.fates.planar_flow import PlanarFlow
from gspot_verified.mechanisms.fates.reference import Reference
from gspot_verified.mechanisms.fates.strip import Strip
from gspot_verified.numbers.balls import hull
from gspot_verified.numbers.evidence import every, inside, less
from gspot_verified.numbers.verdict import Evidence


class Fate(enum.Enum):
    """What is certain of every state of a box."""

    BELOW = "spot, C1 < 0"
    ABOVE = "spot, C1 > 0"
    SPOT = "spot, C1 open"
    LIFT_OFF = "lift-off"
    STOPS = "slip stops"
    OPENS = "opens at once"
    PAINLEVE = "p < 0"
    NO_SLIP = "no slip"
    UNDECIDED = "undecided"


_AT_THE_SPOT = (Fate.BELOW, Fate.ABOVE, Fate.SPOT)


@dataclass(frozen=True)
class BoxFate:
    """The fate with what shows it; of an undecided one why."""

    fate: Fate
    evidence: Evidence | None = None
    why: str = ""


def _open(why: str) -> BoxFate:
    return BoxFate(Fate.UNDECIDED, why=why)


@dataclass(frozen=True)
class Frame:
    """Reference orbits in the order of their places with the strips between them, all of one plane.

    ``region``: a box of the plane on which p and the place are coordinates; ``regular`` shows it. All orbits
    are followed from p = ``first`` to ``last``.
    """

    plane: PlanarFlow
    references: tuple[Reference, ...]
    strips: tuple[Strip, ...]
    region: tuple[arb, ...]
    regular: Evidence
    first: arb
    last: arb


def box_fate(plane: PlanarFlow, frames: Sequence[Frame], states: Sequence[arb], surface: arb) -> BoxFate:
    """The fate of every state of the box on the contact; undecided: none is certain for all of them."""
    box = plane.of_state(states)
    p, b = plane.p_and_b.mean_values(box)
    slip = plane.u.mean_values(states)[0] - surface
    if (backwards := less(slip, 0)) is not None:
        return BoxFate(Fate.NO_SLIP, backwards)
    sense = plane.sense(box)
    if isinstance(sense, str):
        return _open(sense)
    for fate, signs in (
        (Fate.PAINLEVE, [less(p, 0), less(0, slip)]),
        (Fate.OPENS, [less(0, p), less(0, b), less(0, slip)]),
    ):
        if (shown := every([sense, *signs])) is not None:
            return BoxFate(fate, shown)
    if every([less(0, p), less(b, 0), less(0, slip)]) is None:
        return _open("the signs of p, b or the slip velocity differ, or may differ, at the start")
    supposed = plane.supposed(box)
    if isinstance(supposed, str):
        return _open(supposed)
    open_fates = [_open("too far away from the orbits that are known")]
    for frame in frames:
        found = _in_frame(frame, box, p, slip)
        if found.fate not in (Fate.UNDECIDED, Fate.SPOT):
            return found
        open_fates.append(found)
    return next((found for found in open_fates if found.fate is Fate.SPOT), open_fates[-1])


def _in_frame(frame: Frame, box: Sequence[arb], p: arb, slip: arb) -> BoxFate:
    """The fate of states with positive slip in contact, by comparison with the orbits of a frame."""
    within = every([frame.regular, less(p, frame.first), less(frame.last, p), *map(inside, box, frame.region)])
    if within is None:
        return _open("too far away from the orbits that are known")
    found = _between(frame, box, p)
    if found is None:
        return _open("not between two orbits that are known")
    first, last, order = found
    fates = [_in_strip(frame.strips[k], p, slip) for k in range(first, last)]
    shown = every([within, order, *(each.evidence for each in fates)])
    kinds = {each.fate for each in fates}
    if Fate.UNDECIDED in kinds or shown is None:
        return _open(next((each.why for each in fates if each.why), "no fate is certain"))
    if len(kinds) == 1:
        return BoxFate(kinds.pop(), shown)
    if kinds <= set(_AT_THE_SPOT):
        return BoxFate(Fate.SPOT, shown)
    return _open("different states of the box have different fates, or may have")


def _between(frame: Frame, box: Sequence[arb], p: arb) -> tuple[int, int, Evidence] | None:
    """The numbers of the last orbit below all states of the box, and of the first above."""
    references = frame.references
    low, high, below = -1, len(references), None
    while high - low > 1:  # the orbits do not meet: what lies above one lies above all that are lower
        middle = (low + high) // 2
        shown = less(0, _height(frame, references[middle], box, p))
        low, high, below = (low, middle, below) if shown is None else (middle, high, shown)
    first = low
    low, high, above = first, len(references), None
    while high - low > 1:
        middle = (low + high) // 2
        shown = less(_height(frame, references[middle], box, p), 0)
        low, high, above = (middle, high, above) if shown is None else (low, middle, shown)
    order = every([below, above])
    return None if order is None else (first, high, order)


def _height(frame: Frame, orbit: Reference, box: Sequence[arb], p: arb) -> arb:
    """place - place_orbit(p) on the box, on which p is as given, by the mean value form."""
    middle = [side.mid() for side in box]
    at_p = frame.plane.p_and_b.gradients(list(box))[1][0]
    steepness = orbit.steepness(p)
    height = middle[orbit.along] - orbit.place(frame.plane.p_and_b.values(middle)[0])
    for i, (own, side, centre) in enumerate(zip(at_p, box, middle, strict=True)):
        height = height + (int(i == orbit.along) - steepness * own) * (side - centre)
    return height


def _in_strip(strip: Strip, p: arb, slip: arb) -> BoxFate:
    """The fate of the states between two orbits that have these p and slip velocities, with b < 0."""
    shown: list[Evidence | None] = [strip.below.evidence, strip.above.evidence]
    may_open, may_stop = False, False
    least, most = slip.lower(), slip.upper()
    for part in strip.slices:
        if part.lower >= p.upper():
            continue  # all states begin lower
        whole = part.upper <= p.lower()
        drop = part.drop if whole else hull([arb(0), part.drop])
        slides = less(0, least - drop.upper().max(arb(0)))
        least, most = least - drop.upper(), most - drop.lower()
        shown += [part.evidence, *(each for each in (slides, part.presses) if each is not None)]
        may_stop, may_open = may_stop or slides is None, may_open or part.presses is None
        if may_stop and may_open:
            return _open("lift-off and the end of slip: which comes first, or whether, is not certain")
        stuck = less(most, 0)
        if stuck is not None and not may_open:
            return BoxFate(Fate.STOPS, every([*shown, stuck]))
        begun = less(part.lower, p)
        if part.opens is not None and begun is not None and not may_stop:
            return BoxFate(Fate.LIFT_OFF, every([*shown, part.opens, begun]))
    if may_stop or may_open:
        return _open("slip may stop" if may_stop else "it may lift off")
    slides = less(strip.rest, least)
    if strip.end is None:
        return _open("the orbits are not followed so far")
    if slides is None:
        return _open("slip may stop where p vanishes")
    fate = Fate.SPOT
    if strip.below.sign == strip.above.sign:
        fate = Fate.ABOVE if strip.above.sign > 0 else Fate.BELOW
    return BoxFate(fate, every([*shown, strip.end, slides]))
