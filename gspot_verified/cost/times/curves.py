"""Time against digits, for the picture: ours at two beta, the baseline, mpmath."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from flint import fmpq

from gspot_verified.cost.times.baseline import flint_theta, mpmath_theta
from gspot_verified.cost.times.measure import Contestant, clear_caches, measure
from gspot_verified.numbers.written import Written
from gspot_verified.theta_function.theta import theta

_TAU = fmpq(7, 3)  # where the curves of time over digits are measured
_DIGITS = (10, 30, 100, 300, 1_000, 3_000, 10_000, 30_000, 100_000)  # the last two in full only
_MPMATH_DIGITS = 1_000  # beyond them mpmath takes too long


@dataclass(frozen=True, slots=True)
class TimeCurve(Written):
    """Seconds at some numbers of digits, or at another number."""

    name: str
    points: tuple[tuple[float, float], ...]


def curves(full: bool) -> tuple[TimeCurve, ...]:
    """First calls at tau = 7/3, up to 10^4 digits (10^5 when ``full``).

    A curve ends after the point that takes longer than 1 second (10 when ``full``), mpmath's at 10^3 digits: its next
    point would take minutes, for Bernoulli numbers.
    """
    half, third = fmpq(1, 2), fmpq(7, 3)
    calls: dict[str, Callable[[int], object]] = {
        "this package, β = 1/2": lambda digits: theta(_TAU, half, 0, digits),
        "this package, β = 7/3": lambda digits: theta(_TAU, third, 0, digits),
        "three FLINT 1F2, β = 1/2": lambda digits: flint_theta(_TAU, half, 0, digits),
        "mpmath hyp1f2, β = 1/2": lambda digits: mpmath_theta(_TAU, half, 0, digits),
    }
    digits, patience = (_DIGITS, 10.0) if full else (_DIGITS[:-2], 1.0)
    last = {"mpmath hyp1f2, β = 1/2": _MPMATH_DIGITS}
    return tuple(
        TimeCurve(name, curve(call, tuple(count for count in digits if count <= last.get(name, count)), patience))
        for name, call in calls.items()
    )


def curve(call: Callable[[int], object], digits: tuple[int, ...], patience: float) -> tuple[tuple[int, float], ...]:
    """The points of one curve, with empty caches before every call, up to the first above ``patience`` seconds."""
    points: list[tuple[int, float]] = []
    for count in digits:
        contestant = Contestant(partial(call, count), clear_caches, 7)
        points.append((count, measure({"it": contestant}, 0.5)["it"].median))
        if points[-1][1] > patience:
            break
    return tuple(points)
