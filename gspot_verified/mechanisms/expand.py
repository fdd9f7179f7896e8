"""The distinguished trajectory of a mechanism: its G-spot, then Theorem 1's expansion there."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from gspot_verified.expansion.series.system import System
    from gspot_verified.expansion.trajectory import Trajectory
    from gspot_verified.mechanisms.input.mechanism import Mechanism


def expand(
    source: Mechanism | System,
    order: int,
    digits: int = 15,
    progress: Callable[[int, int], None] | None = None,
    bits: int | None = None,
    *,
    spot: int | None = None,
) -> Trajectory:
    """The terms of orders 0..order-1 of delta of the distinguished trajectory at the G-spot; paper, Theorem 1.

    Exact coefficients where the G-spot is rational, rational functions where a parameter has no value, else balls.
    Balls have the asked ``digits`` (:class:`expansion.trajectory.Accuracy`): the precision is raised, and with it the
    box of the G-spot. Where that does not help (a system whose numbers are balls already) the result is valid, its
    ``accuracy.reached`` is False, and an ``AccuracyWarning`` is given. ``progress`` is told (orders done, orders).

    ``bits`` asks for balls computed once with so many working bits, also where exact coefficients are possible: at high
    orders those are long. ``accuracy`` then says what is left of the bits.

    ``spot`` is the number of another G-spot of the mechanism, as ``classify_all`` lists them.

    :raises TypeError: ``source`` is neither a mechanism nor a system, or ``order`` or ``digits`` is not an int.
    :raises ValueError: ``order`` is not in 1..2000, or ``digits`` not in 1..10^6; there is no G-spot of that number, or
        ``source`` is a system, which has one alone.
    :raises GSpotError: a hypothesis of Theorem 1 fails; an integer beta is an ObstructedOrderError.

    >>> from gspot_verified import load
    >>> expand(load("extended system"), 3).b[2].coefficients()
    [0, 0, 6]
    >>> expand(load("genot_brogliato_rod"), 8).accuracy.reached
    True
    """
    # Imported here: this module is part of `import gspot_verified`, which stays quick.
    from gspot_verified.expansion.series.system import System
    from gspot_verified.expansion.trajectory import (
        certain_bits_of,
        checked_order,
        expand_system,
        first_bits,
        terms_of,
        until_accurate,
    )
    from gspot_verified.mechanisms.input.mechanism import Mechanism
    from gspot_verified.mechanisms.spots.chosen_spot import at_spot
    from gspot_verified.mechanisms.spots.g_spot import find_g_spot
    from gspot_verified.mechanisms.symbolic import symbolic_system

    if isinstance(source, System):
        if spot is not None:
            raise ValueError("spot: a system has one G-spot; give the mechanism")
        return (
            expand_system(source, order, digits, progress) if bits is None else _in_balls(source, order, bits, progress)
        )
    if not isinstance(source, Mechanism):
        raise TypeError(f"expected a Mechanism or a System, got {type(source).__name__}")
    order = checked_order(order)
    source = at_spot(source, spot)
    if any(value is None for _, value in source.parameters):
        named = replace(symbolic_system(source), state=source.state)
        return expand_system(named, order, digits, progress)

    if bits is not None:
        return _in_balls(replace(find_g_spot(source, bits).system, state=source.state), order, bits, progress)

    def attempt(bits: int) -> tuple[Trajectory, int | None]:
        trajectory = terms_of(replace(find_g_spot(source, bits).system, state=source.state), order, bits, progress)
        return trajectory, certain_bits_of(trajectory)

    expansion, accuracy = until_accurate(attempt, digits, first_bits(order, digits))
    return replace(expansion, accuracy=accuracy)


def _in_balls(system: System, order: int, bits: int, progress: Callable[[int, int], None] | None) -> Trajectory:
    from gspot_verified.expansion.trajectory import expand_in_balls

    return expand_in_balls(system, order, bits, progress)
