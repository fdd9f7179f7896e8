"""What lies between two neighbouring reference orbits, in slices of p: where slip from there may end.

Proof page: ``proofs/fates.md``, Theorem F1.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from flint import arb, arb_mat

from gspot_verified.functions.krawczyk import proved_zero
from gspot_verified.mechanisms.approach.capture import capture
from gspot_verified.mechanisms.fates.planar_flow import PlanarFlow
from gspot_verified.mechanisms.fates.reference import Reference
from gspot_verified.mechanisms.fates.trajectory_side import TrajectorySide
from gspot_verified.numbers.balls import add_remainder, hull
from gspot_verified.numbers.evidence import every, inside, less, signed
from gspot_verified.numbers.verdict import Evidence

_INFLATIONS = (1.25, 2, 4)  # of where the points are expected: any number is correct, Krawczyk's test decides


@dataclass(frozen=True)
class Slice:
    """The states between the orbits with p from ``lower`` to ``upper``: they lie in ``box``, and p falls there.

    ``drop``: by how much u falls at most, or rises at least (a ball), while p passes the slice. ``presses``: b < 0
    on it, or b cannot rise through 0. ``opens``: b > 0 on it.
    """

    lower: arb
    upper: arb
    box: tuple[arb, ...]
    drop: arb
    presses: Evidence | None
    opens: Evidence | None
    evidence: Evidence


@dataclass(frozen=True)
class Strip:
    """Between two orbits, from the first ``knots`` down as far as all is certain. ``end``: from the lower end of the
    last slice the G-spot is certainly reached; ``rest``: by how much u changes then at most."""

    below: Reference
    above: Reference
    slices: tuple[Slice, ...]
    end: Evidence | None
    rest: arb


def strip(plane: PlanarFlow, below: Reference, above: Reference, side: TrajectorySide, knots: Sequence[arb]) -> Strip:
    """The strip from one orbit to the next with a larger place. ``side``: that of their G-spot.

    ``knots`` fall, and both orbits are followed to the last of them.
    """
    slices: list[Slice] = []
    for upper, lower in pairwise(knots):
        found = _slice(plane, below, above, lower, upper)
        if found is None:
            return Strip(below, above, tuple(slices), None, arb(0))
        slices.append(found)
    last = _between(plane, below, above, knots[-1])
    if last is None:
        return Strip(below, above, tuple(slices), None, arb(0))
    neighbourhood = capture(plane, [*last[0], arb(0)], None)
    if neighbourhood is None:
        return Strip(below, above, tuple(slices), None, arb(0))
    supposed = plane.supposed(neighbourhood.box[:-1])
    if isinstance(supposed, str):
        return Strip(below, above, tuple(slices), None, arb(0))
    near = every(inside(own, whole) for own, whole in zip(neighbourhood.box[:-1], side.region, strict=False))
    end = every([last[1], near, neighbourhood.evidence, supposed])
    return Strip(below, above, tuple(slices), end, neighbourhood.reach[-1])


def _between(plane: PlanarFlow, below: Reference, above: Reference, p: arb) -> tuple[list[arb], Evidence] | None:
    """A box that holds, for each of these p and each place from one orbit to the other, exactly one point.

    The coordinates are p and place - slope p, in which the orbits are nearly straight; any slope is correct.
    """
    at, along = p.mid(), below.along
    middle = [hull(sides).mid() for sides in zip(below.states(at), above.states(at), strict=True)]
    slope = ((below.steepness(at) + above.steepness(at)) / 2).mid()
    heights = hull([_height(orbit, p, slope) for orbit in (below, above)])

    def gap(box: list[arb]) -> list[arb]:
        own_p = plane.p_and_b.values(box)[0]
        return [own_p - p, box[along] - slope * (own_p - at) - heights]

    def rows(box: list[arb]) -> list[list[arb]]:
        at_p = plane.p_and_b.gradients(box)[1][0]
        return [at_p, [int(i == along) - slope * own for i, own in enumerate(at_p)]]

    try:
        moves = (arb_mat(rows(middle)).inv() * arb_mat([[value] for value in gap(middle)])).entries()
    except ZeroDivisionError:
        return None
    for factor in _INFLATIONS:
        box = [add_remainder(centre, factor * move) for centre, move in zip(middle, moves, strict=True)]
        found = proved_zero(gap, rows, box)
        if found is not None:
            return found
    return None


def _height(orbit: Reference, p: arb, slope: arb) -> arb:
    """place - slope (p - its midpoint) along an orbit, by the mean value form."""
    at = p.mid()
    return orbit.place(at) + (orbit.steepness(p) - slope) * (p - at)


def _slice(plane: PlanarFlow, below: Reference, above: Reference, lower: arb, upper: arb) -> Slice | None:
    p = hull([lower, upper])
    found = _between(plane, below, above, p)
    if found is None:
        return None
    box, unique = found
    supposed = plane.supposed(box)
    rate = plane.slip_rate.mean_values(box)[0]
    evidence = None if isinstance(supposed, str) else every([unique, supposed])
    if evidence is None or not rate.is_finite():
        return None
    drop = rate * (upper / lower).log()  # u falls by the integral of p du/dp over log p
    second = plane.alphas.mean_values(box)[1]
    b = plane.p_and_b.mean_values(box)[1]
    return Slice(lower, upper, tuple(box), drop, less(b, 0) or less(second, 0), less(0, b), evidence)


def region_of(plane: PlanarFlow, along: int, strips: Sequence[Strip]) -> tuple[tuple[arb, ...], Evidence] | None:
    """A box around all strips on which p and the place are coordinates, with what shows it: that orbits which bound
    slices lie in it where these begin, too."""
    boxes = [part.box for each in strips for part in each.slices]
    if not strips[0].slices:
        return None
    sides = [hull(own) for own in zip(*boxes, strict=True)]
    region = [add_remainder(side, side.rad() / 8) for side in sides]
    regular = signed(plane.p_and_b.gradients(region)[1][0][1 - along])
    if regular is None or regular[0] == 0:
        return None
    # An orbit may have p and the place of a point of the region elsewhere: then it bounds nothing here.
    begun = [
        inside(own, side)
        for each in strips
        for part in each.slices[:1]
        for orbit in (each.below, each.above)
        for own, side in zip(orbit.states(part.upper), region, strict=True)
    ]
    shown = every([regular[1], *begun])
    return None if shown is None else (tuple(region), shown)
