"""Where the G-spot of a row is looked for. Heuristics only: whatever they choose, :func:`try_tube` decides."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

from flint import arb, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Variable
from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.g_spot import GSpot, symbolic_place
from gspot_verified.mechanisms.spots.parametric_system import parametric_system
from gspot_verified.mechanisms.sweep.sweep_grid import newton_origin
from gspot_verified.mechanisms.sweep.sweep_start import Origin, proved_tube
from gspot_verified.mechanisms.zeros.tube import Equations, OnTube
from gspot_verified.numbers.balls import ball, working_bits

_STEPS = 40  # of Newton's method: a limit of effort
_CONSTANT_BITS = 128  # any number is correct: this is where a search begins


@dataclass(frozen=True, slots=True)
class Start:
    """A mechanism, the parameters that have values of their own in each row, the components that keep theirs, and the
    middle of the mechanism's own G-spot."""

    mechanism: Mechanism
    parameters: tuple[str, ...]
    fixed: tuple[str, ...]
    own: tuple[fmpq, ...]


def middle_of(spot: GSpot) -> tuple[fmpq, ...]:
    """A point in the box of a G-spot."""
    middle = []
    for value in spot.system.point:
        mantissa, exponent = ball(value).mid().man_exp()
        middle.append(fmpq(mantissa) * fmpq(2) ** int(exponent))
    return tuple(middle)


def searched(equations: Equations, start: Start, values: tuple[fmpq, ...]) -> OnTube | None:
    """A proved tube over the one point: from the place that the mechanism names, with these values, or from its own
    G-spot."""
    tubes = (proved_tube(equations, values, values, origin) for origin in _origins(start, values))
    return next((on for on in tubes if on is not None), None)


def is_sought(start: Start, values: tuple[fmpq, ...], on: OnTube) -> bool:
    """Whether a tube holds the first point to which the search goes: a journal may hold a tube of another G-spot."""
    origin = next(_origins(start, values), None)
    if origin is None:
        return False
    conditions, _ = _programs(start.mechanism, start.parameters, start.fixed)
    # A tube is much narrower than what is left of the last step: one more goes into it.
    nearer = newton_origin(conditions, values, [arb(value).mid() for value in origin.centre], float("inf"), 1)
    return nearer is not None and on.tube.holds_at(values, [arb(value) for value in nearer.centre])


def _origins(start: Start, values: tuple[fmpq, ...]) -> Iterator[Origin]:
    conditions, place = _programs(start.mechanism, start.parameters, start.fixed)
    points = [[arb(value).mid() for value in start.own]]
    if place is not None:
        named = place.values([*(arb(0) for _ in start.own), *map(arb, values)])
        if all(value.is_finite() for value in named):
            points.insert(0, [value.mid() for value in named])
    for point in points:
        origin = newton_origin(conditions, values, point, float("inf"), _STEPS)
        if origin is not None:
            yield origin


@lru_cache(maxsize=4)
def _programs(
    mechanism: Mechanism, parameters: tuple[str, ...], fixed: tuple[str, ...]
) -> tuple[BoxProgram, BoxProgram | None]:
    """The conditions, and the place that the mechanism names (None: no whole one), as functions of the parameters."""
    m, k = len(mechanism.state), len(parameters)
    conditions = BoxProgram(parametric_system(mechanism, parameters, fixed).conditions, m + k)
    shifted = shift(mechanism.with_parameters(**dict.fromkeys(parameters)), free=True)
    place = symbolic_place(shifted)
    if set(place) != set(mechanism.state):
        return conditions, None
    own_variables = {name: Variable(m + j) for j, name in enumerate(parameters)}
    with working_bits(_CONSTANT_BITS):
        functions = shifted.expressions([place[word] for word in mechanism.state], BALLS, own_variables)
    return conditions, BoxProgram(functions, m + k, ())
