"""How many terms a Taylor model takes. Heuristics only: any choice gives a correct model."""

from __future__ import annotations

import math

GOAL_BITS = 40
"""Bits of a model that shall be right, about."""
_MAX_LENGTH = 20_000  # against endless work


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


def rate(reach: float, size: float) -> float:
    """The growth rate r of the solutions at |tau| = reach, |b| = size: r^3 = reach r + size."""
    r = math.sqrt(reach) + math.pow(size, 1 / 3) + 1e-9
    for _ in range(20):
        r -= (r**3 - reach * r - size) / (3 * r * r - reach)
    return r


def carrying_bits(reach: float, size: float) -> float:
    """About how many bits balls lose on the way from 0 to |tau| = reach: the solutions grow at most like this."""
    steps = 16
    return sum(rate((i + 0.5) * reach / steps, size) for i in range(steps)) * reach / steps / math.log(2)


def bits_carried(reach: float, size: float, goal: int) -> int:
    """Working precision of series that are carried along tau."""
    return 32 * math.ceil((goal + 40 + carrying_bits(reach, size)) / 32)


def degree_carried(reach: float, size: float, radius: float, goal: int) -> int:
    """Powers of eta; see :func:`degree_for_box`."""
    if radius == 0:
        return 1
    return max(4, math.ceil((goal + carrying_bits(reach, size)) / math.log2(6 / min(radius, 3.0))))


def length_of_series(distance: float, scale: float, size: float, bits: float) -> int:
    """Powers of u of a series at |tau| = distance, until the rest is below 2^-bits; the tail lemma needs 5 and more."""
    exponent, length, height = rate(distance, size + 2) * scale, 0, 0.0
    while height > -bits or length < exponent:
        length += 1
        height += math.log2(exponent / length)
    b = size + 3
    while True:
        i = max(length, 5) - 5
        ratio = (distance * (i + 1) + (i + b) * scale) * scale**2 / ((i + 1) * (i + 2) * (i + 3))
        if length >= 5 and ratio < 0.49:
            return length
        length += 1


def degree_of_box(reach: float, radius: float, goal: int) -> int:
    """Powers of eta of a series on one box: F varies with b like a power of the distance from 0 and of the growth."""
    if radius == 0:
        return 1
    rest, degree = radius * (math.log(reach + 1) + 2), 1
    while degree * math.log2(rest) - math.lgamma(degree + 1) / math.log(2) > -goal:
        degree += 1
    return degree
