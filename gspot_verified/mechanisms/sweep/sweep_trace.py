"""The tubes that an examination met, as choices: with them the same pieces are proved again, without the search.

An entry is where a tube was proved (centre, slopes, widths), or None where none was found. It is no evidence:
:func:`try_tube` proves each tube again, and where it does not, the search is made.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from flint import arb, fmpq, fmpz

from gspot_verified.mechanisms.zeros.tube import Equations, OnTube, Tube, try_tube

_LONGEST = 4_000  # bits: a limit against hostile journals
_RADIUS_BITS = 30  # the length of a radius' mantissa in FLINT

Place = tuple[int, int]
"""A number m 2^e as (m, e)."""
Choice = tuple[tuple[Place, ...], tuple[tuple[Place, ...], ...], tuple[Place, ...]] | None
"""Centre, slopes row by row, radii of the widths; None: no tube was found."""


class TubeTrace:
    """``met``: the choices of the calls so far, in order; ``known``: those of an earlier examination of the cell."""

    def __init__(self, known: Sequence[Choice] = ()) -> None:
        self.met: list[Choice] = []
        self._known = list(known)

    def tube(
        self,
        equations: Equations,
        lower: tuple[fmpq, ...],
        upper: tuple[fmpq, ...],
        search: Callable[[], OnTube | None],
        is_sought: Callable[[OnTube], bool] | None = None,
    ) -> OnTube | None:
        """A proved tube over the box: by the choice that is known for this call, if that ``is_sought``, else by the
        search."""
        number = len(self.met)
        if number < len(self._known):
            choice = self._known[number]
            on = None if choice is None else _proved(equations, lower, upper, choice)
            if choice is None or (on is not None and (is_sought is None or is_sought(on))):
                self.met.append(choice)
                return on
        on = search()
        self.met.append(None if on is None else _choice(on.tube))
        return on


def read_choice(data: Any) -> Choice:
    """The choice that a journal holds.

    :raises ValueError: it is none (or TypeError).
    """
    if data is None:
        return None
    centre, slopes, radii = data
    return _places(centre), tuple(map(_places, slopes)), _places(radii)


def _choice(tube: Tube) -> Choice:
    rows = tuple(tuple(map(_place, row)) for row in tube.slopes)
    return tuple(map(_place, tube.centre)), rows, tuple(_place(side.rad()) for side in tube.within)


def _place(value: arb) -> Place:
    mantissa, exponent = value.man_exp()
    return int(mantissa), int(exponent)


def _places(data: Any) -> tuple[Place, ...]:
    places = tuple((mantissa, exponent) for mantissa, exponent in data)
    for mantissa, exponent in places:
        if type(mantissa) is not int or type(exponent) is not int:
            raise ValueError("a number must be two integers")
        if mantissa.bit_length() > _LONGEST or abs(exponent) > _LONGEST:
            raise ValueError("a number is out of range")
    return places


def _proved(equations: Equations, lower: Sequence[fmpq], upper: Sequence[fmpq], choice: Choice) -> OnTube | None:
    assert choice is not None
    centre, slopes, radii = choice
    n, k = equations.unknowns, equations.parameters
    if (len(centre), [len(row) for row in slopes], len(radii)) != (n, [k] * n, n):
        return None
    exact = [_ball(value) for value in centre], [[_ball(value) for value in row] for row in slopes]
    attempt = try_tube(equations, lower, upper, *exact, [_around_zero(*radius) for radius in radii])
    return None if attempt is None else attempt.proved


def _ball(value: Place) -> arb:
    return arb((fmpz(value[0]), fmpz(value[1])))


def _around_zero(mantissa: int, exponent: int) -> arb:
    """The ball around 0 with this radius, as it was: FLINT rounds an odd mantissa of 30 bits up, to the one above."""
    mantissa = abs(mantissa)
    if mantissa % 2 and mantissa.bit_length() == _RADIUS_BITS:
        return arb(0, arb((fmpz(mantissa - 1), fmpz(exponent))))
    return arb(0, (fmpz(mantissa), fmpz(exponent)))
