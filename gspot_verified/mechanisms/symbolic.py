"""The system at a G-spot with parameters left as symbols: exact rational functions instead of numbers."""

from __future__ import annotations

from gspot_verified.expansion.series.system import GSpotError, System
from gspot_verified.functions.symbols import Symbols
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.g_spot import place_in, with_conditions


def symbolic_system(mechanism: Mechanism) -> System:
    """The system over rational functions of the parameters that have no value, at the place the mechanism gives.

    Everything is generic: what does not vanish identically counts as nonzero, the signs of the alphas and the positive
    definite mass matrix are hypotheses. That p, b, y, v vanish is checked identically.

    :raises GSpotError: the place is no G-spot for all values of the parameters.
    :raises NotRationalError: something is no rational function of the parameters.

    >>> from gspot_verified.mechanisms.shipped import shipped_mechanism
    >>> system = symbolic_system(shipped_mechanism("extended system", chi=None))
    >>> from gspot_verified.expansion.series.recursion import Recursion
    >>> recursion = Recursion(system)
    >>> for _ in range(3): recursion.advance()
    >>> recursion.p[2].coefficients()
    [0, 0, chi]
    """
    free = [name for name, value in mechanism.parameters if value is None]
    if not free:
        raise GSpotError(f"{mechanism.name}: no parameter is a symbol; give one the value None")
    ring = Symbols(*free)
    shifted = shift(mechanism, free=True)
    system, _ = with_conditions(shifted, place_in(shifted, ring), ring)
    for name, value in zip("pbyv", system.values_at_point((system.p, system.b, system.y, system.v)), strict=True):
        if ring.is_nonzero(value):
            raise GSpotError(f"{mechanism.name}: not a G-spot for all parameters: {name} = {value}")
    return system
