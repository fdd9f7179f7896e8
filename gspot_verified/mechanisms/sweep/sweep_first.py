"""The G-spot that a sweep begins with: at the mechanism's place, or one of the list of all."""

from __future__ import annotations

from dataclasses import replace

from flint import fmpq

from gspot_verified.expansion.series.system import GSpotError
from gspot_verified.functions.expressions import Constant
from gspot_verified.mechanisms.formulas.symbol import Symbol
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.all_g_spots import find_g_spots
from gspot_verified.mechanisms.spots.g_spot import GSpot, find_g_spot
from gspot_verified.numbers.balls import exact


def first_spot(mechanism: Mechanism, number: int | None) -> GSpot:
    """The G-spot at the mechanism's place; with ``number``, that one in the list of :func:`find_g_spots`, from 1.

    Where the mechanism names no place, or none is found there, and there is one G-spot in all, it is that.

    :raises GSpotError: none was found or proved there.
    :raises ValueError: there are several and none was chosen, or there is no such number.
    """
    given = dict(mechanism.place.values)
    wrong = "there is no place of a G-spot"
    if number is None and all(word in given for word in mechanism.state):
        try:
            return find_g_spot(mechanism)
        except GSpotError as error:
            wrong = str(error)
    g_spots = find_g_spots(mechanism)
    if not g_spots.spots:
        raise GSpotError(f"{wrong}\n{g_spots}")
    if number is None and (len(g_spots.spots) > 1 or not g_spots.complete):
        raise ValueError(f"{wrong}: choose one by its number, spot=1\n{g_spots}")
    return g_spots.spot(1 if number is None else number)


def with_place_of(mechanism: Mechanism, spot: GSpot) -> Mechanism:
    """The mechanism with values for all of the spot's fixed components: those that it lacks are exact at the spot.

    :raises GSpotError: such a component is not exact there.
    """
    values = dict(mechanism.place.values)
    references = {angle.coordinate: Symbol(angle.name) for angle in mechanism.angles}
    for word, value in zip(mechanism.state, spot.system.point, strict=True):
        if word in values or word not in spot.fixed:
            continue
        number = exact(value, word)
        if not isinstance(number, fmpq):
            raise GSpotError(f"{mechanism.name}: the fixed component {word} needs a value in the G-spot's place")
        values[word] = references[word] + Constant(number) if word in references else Constant(number)
    return replace(mechanism, place=replace(mechanism.place, values=tuple(values.items())))
