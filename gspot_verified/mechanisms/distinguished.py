"""The distinguished trajectory of a mechanism: its G-spot, then Theorem 1's expansion there."""

from __future__ import annotations

from collections.abc import Callable

from gspot_verified.balls import working_bits
from gspot_verified.expansion.trajectory import MAX_ORDER, Trajectory, expand
from gspot_verified.mechanisms.g_spot import DEFAULT_BITS, find_g_spot
from gspot_verified.mechanisms.mechanism import Mechanism
from gspot_verified.mechanisms.symbolic import symbolic_system

# In balls each order costs about one bit; three leave room for the growth of the terms.
_BITS_PER_ORDER = 3


def distinguished_trajectory(
    mechanism: Mechanism, order: int, progress: Callable[[int, int], None] | None = None
) -> Trajectory:
    """The terms of orders 0..order-1 of delta at the mechanism's G-spot, exact where that is rational, else in balls.

    With a parameter that has no value: rational functions of it.

    :raises TypeError: ``order`` is not an int.
    :raises ValueError: it is not in 1..2000.
    :raises GSpotError: a hypothesis of Theorem 1 fails; an integer beta is an ObstructedOrderError.

    >>> from gspot_verified.mechanisms.shipped import shipped_mechanism
    >>> distinguished_trajectory(shipped_mechanism("extended system"), 3).b[2].coefficients()
    [0, 0, 6]
    """
    if any(value is None for _, value in mechanism.parameters):
        return expand(symbolic_system(mechanism), order, progress)
    # A wrong order is refused by `expand`.
    orders = min(max(order, 0), MAX_ORDER) if type(order) is int else 0
    bits = DEFAULT_BITS + _BITS_PER_ORDER * orders
    system = find_g_spot(mechanism, bits).system
    with working_bits(bits):
        return expand(system, order, progress)
