"""How many terms a Taylor model takes. Heuristics only: any choice gives a correct model."""

from __future__ import annotations

import math

GOAL_BITS = 40
"""Bits of a model that shall be right, about."""
_MAX_LENGTH = 20_000


def growth_bits(reach: float, size: float) -> float:
    """About how many bits are lost on |tau| <= reach, |b| <= size: the terms of the series against their sum."""
    return 1.5 * reach * math.sqrt(reach) + 1.5 * size


def bits_for_box(reach: float, size: float, goal: int = GOAL_BITS) -> int:
    """Working precision, in steps of 32 so that neighbours share their cached matrices."""
    return 32 * math.ceil((goal + 40 + growth_bits(reach, size)) / 32)


def degree_for_box(reach: float, size: float, radius: float, goal: int = GOAL_BITS) -> int:
    """Powers of eta: (radius/6)^degree against what the growth in tau makes of it; a series has a radius up to 3."""
    if radius == 0:
        return 1
    return max(4, math.ceil((goal + growth_bits(reach, size)) / math.log2(6 / min(radius, 3.0))))


def length_for_box(reach: float, size: float, bits: int) -> int:
    """Powers of tau: until the ratio of neighbouring terms has brought them below the working precision."""
    height, k = 0.0, 0
    while k < _MAX_LENGTH:
        ratio = (k + max(size, 1.0)) * max(reach, 0.5) ** 3 / ((k + 1) * (k + 2) * (k + 3))
        height += math.log2(max(ratio, 1e-300))
        k += 3
        if ratio < 0.25 and height < -bits:
            break
    return 8 * math.ceil((k + 3) / 8)


def order_for_box(middle: float, half_width: float, size: float, goal: int = GOAL_BITS) -> int:
    """Powers of u: the local scale of Theta is 1/sqrt|tau|, and b powers of it for a polynomial of degree b."""
    scale = half_width * (math.sqrt(abs(middle) + half_width) + 1)
    wanted = goal / 2 + growth_bits(abs(middle) + half_width, size) / 2
    order, height = 4, 0.0
    for order in range(4, 400):
        height = order * math.log2(max(scale, 1e-9)) - math.lgamma(order + 1) / math.log(2)
        if height < -wanted:
            break
    return order
