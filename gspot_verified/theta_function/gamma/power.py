"""Powers of a positive ball with a rational exponent: integer powers and integer roots where they are cheaper."""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.numbers.balls import Exact, current_bits

# From these bits on an integer root, if its index is small, costs less than FLINT's exp(y log x).
_ROOT_FROM_BITS = 600
_LARGEST_ROOT = 16  # index of a root that is cheap
_LARGEST_POWER = 10_000  # exponent before the root is drawn, likewise


def positive_power(base: arb, exponent: Exact) -> arb:
    """base^exponent at the current precision; not finite unless the base is certainly positive.

    >>> positive_power(arb(8), fmpq(2, 3)).overlaps(arb(4))
    True
    """
    if not base > 0:
        return arb.nan()
    if not isinstance(exponent, fmpq):
        return base**exponent
    if current_bits() < _ROOT_FROM_BITS or not 2 < exponent.q <= _LARGEST_ROOT or abs(exponent.p) > _LARGEST_POWER:
        return base ** arb(exponent)
    return (base ** int(exponent.p)).root(int(exponent.q))
