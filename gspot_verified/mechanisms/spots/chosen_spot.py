"""A G-spot chosen by its number in the list of all."""

from __future__ import annotations

from dataclasses import replace

from flint import fmpq

from gspot_verified.expansion.series.system import GSpotError
from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.formulas.simplify import constant, sum_of
from gspot_verified.mechanisms.formulas.symbol import Symbol
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.all_g_spots import find_g_spots
from gspot_verified.mechanisms.spots.classify_all import named_spot, with_the_exact_one
from gspot_verified.mechanisms.spots.g_spot import DEFAULT_BITS, GSpot, place_in, prove_near
from gspot_verified.numbers.balls import ball, working_bits
from gspot_verified.numbers.evidence import every, inside

_MORE_BITS = 64  # than in the list: the box is narrower, and lies in that of the list


def at_spot(mechanism: Mechanism, number: int | None) -> Mechanism:
    """The mechanism with the place of this G-spot, numbered from 1 as ``classify_all`` and ``find_g_spots`` list them.

    None, and the number of a rational G-spot at the place that the mechanism names, change nothing. Else the middle of
    the G-spot's box becomes the start of Newton's method. That it leads back is proved here: to a narrower box in that
    which holds this G-spot alone.

    :raises ValueError: there is no such number; the message says how many there are.
    :raises GSpotError: the G-spot was not proved again.
    :raises MechanismError: the mechanism is not complete.

    >>> from gspot_verified import classify, load
    >>> rod = load("genot_brogliato_rod")
    >>> [classify(at_spot(rod, number)).case for number in (1, 3)]
    ['II', 'none']
    """
    if number is None:
        return mechanism
    found = find_g_spots(mechanism)
    spot = with_the_exact_one(found, named_spot(mechanism, found, DEFAULT_BITS)).spot(number)
    if spot.exact:
        return mechanism
    placed = _placed_at(mechanism, spot)
    shifted = replace(spot.shifted, mechanism=placed)
    bits = spot.bits + _MORE_BITS
    with working_bits(bits):
        again = prove_near(shifted, place_in(shifted, BALLS), bits).system.point
        same = every(inside(part, whole) for part, whole in zip(again, spot.system.point, strict=True))
    if same is None:
        raise GSpotError(f"{mechanism.name}: G-spot {number} could not be proved again from the middle of its box")
    return placed


def _placed_at(mechanism: Mechanism, spot: GSpot) -> Mechanism:
    """With the middle of the spot's box as a start; components that are fixed keep the values that they have."""
    place = mechanism.place
    given = dict(place.values)
    references = {angle.coordinate: Symbol(angle.name) for angle in mechanism.angles}
    values = []
    for word, value in zip(mechanism.state, spot.system.point, strict=True):
        if word in spot.fixed and word in given:
            values.append((word, given[word]))
            continue
        mantissa, exponent = ball(value).mid().man_exp()
        middle = constant(fmpq(mantissa) * fmpq(2) ** int(exponent))
        values.append((word, sum_of(references[word], middle) if word in references else middle))
    fixed = spot.fixed if place.conditions is None else None
    return replace(mechanism, place=replace(place, values=tuple(values), search=True, fixed=fixed))
