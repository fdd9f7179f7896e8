"""Where a range of beta that is not settled is cut. Heuristics only: any choice is correct.

Next to an integer the zeros depend on the logarithm of the distance: one is far out above each integer, two are near
tau = 0 on both sides of beta = 3, 6, 9, ... So ranges there are cut in the middle of that logarithm, not in their own.
"""

from __future__ import annotations

from flint import fmpq

_LEAST_RATIO = 4  # of two distances from an integer: below it halving is as good
_LARGEST_EXPONENT = 2_000  # of a distance 2^-k: beyond it halving is as good


def middle(lower: fmpq, upper: fmpq) -> fmpq:
    """The midpoint."""
    return (lower + upper) / 2


def middle_from_integers(lower: fmpq, upper: fmpq) -> fmpq:
    """A cut inside a range of one cell [n, n + 1]: of distances from the nearer of the two integers, the middle one.

    A range [n, n + 2^-k] is cut at n + 2^-2k. Ranges whose distances differ by less than a factor 4 are halved.

    >>> middle_from_integers(fmpq(3), fmpq(49, 16)), middle_from_integers(fmpq(13, 4), fmpq(7, 2))
    (769/256, 27/8)
    """
    half = middle(lower, upper)
    below, above = lower.floor(), upper.ceil()
    if half - below <= above - half:
        distance = _middle_distance(lower - below, upper - below)
        return half if distance is None else below + distance
    distance = _middle_distance(above - upper, above - lower)
    return half if distance is None else above - distance


def _middle_distance(near: fmpq, far: fmpq) -> fmpq | None:
    """A power of 2 in the middle of two distances from an integer, or near the square of the far one if the near one is
    0; None where halving is as good."""
    k = _exponent(far)
    if near == 0:
        return fmpq(1, 2 ** (2 * k)) if 2 <= k <= _LARGEST_EXPONENT else None
    if far < _LEAST_RATIO * near:
        return None
    return fmpq(1, 2 ** ((k + _exponent(near) + 1) // 2))


def _exponent(distance: fmpq) -> int:
    """The k with 2^-k <= distance < 2^(1-k), for a distance in (0, 1]; -log2 of a power of 2."""
    return int((1 / distance).ceil() - 1).bit_length()
