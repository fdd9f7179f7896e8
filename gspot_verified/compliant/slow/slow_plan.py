"""Heuristic: step, strip and range of the trapezoidal rule, and from which b the recurrence begins.

Any choice is correct; a bad one gives a wide ball.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from flint import fmpq

from gspot_verified.compliant.slow.slow_integral import TrapezoidPlan

_ANGLES = tuple(math.pi / 6 * 7 / 8 * 2 ** (-k / 2) for k in range(50))
_GUARD_BITS = 24  # bits beyond those asked for, lost on the way; any number is right
_STEP_BITS = 4  # of the rule's step: few different ones share their grids
# Working bits in few sizes, so that grids are shared.
_BITS_MULTIPLE = 32
_NEWTON_STEPS = 60  # against endless work; any place is right
_LARGE_ETA = 4.0  # from which on few steps of the recurrence are taken, as they cancel; any number is right


def steps_from_below(b: float, tau: float, bits: int, eta: float = 0.0) -> int:
    """How many steps of the recurrence in b lead from the integrals, at b - n <= -1, up to b."""
    least = max(0, math.ceil(b + 2.5))
    # The further down, the fewer nodes near rho = 0. Where the peak alone counts, or eta is large, the steps cancel.
    if (tau > 0 and tau**1.5 > bits) or eta > _LARGE_ETA:
        return least
    return max(least, math.ceil(b + bits / 8))


def bits_lost(b: float, tau: float, eta: float, steps: int) -> int:
    """What the recurrence costs: a step to c sums terms tau rho (1 + eta rho)/|c| times its value, rho the peak."""
    rho = math.sqrt(2 * tau) if tau > 0 else 0.0
    size = math.log2(max(tau * rho * (1 + eta * rho), 1.0))
    return math.ceil(sum(max(0.5, size - math.log2(max(1.0, abs(b - k)))) for k in range(steps)))


def trapezoid_plan(tau: float, b: float, eta: float, count: int, bits: int) -> TrapezoidPlan:
    """A plan for I_b, ..., I_(b-count+1), b <= -1, with relative errors near 2^-bits."""
    low = peak(tau, b, eta, 0.0)
    top = log_integrand(low, tau, b, eta, 0.0)
    goal = bits * math.log(2) + 4
    angle = _best_angle(tau, b, eta, goal, top)
    step = _rounded(2 * math.pi * angle / (goal + _excess(tau, b, eta, angle, top)))
    high = peak(tau, b - count + 1, eta, 0.0)
    left = _edge(lambda u: top - log_integrand(math.exp(u), tau, b, eta, 0.0) - goal, math.log(low), -1.0)
    top_high = log_integrand(high, tau, b - count + 1, eta, 0.0)
    right = _edge(
        lambda u: top_high - log_integrand(math.exp(u), tau, b - count + 1, eta, 0.0) - goal, math.log(high), 1.0
    )
    first, last = math.floor(left / float(step)), math.ceil(right / float(step)) + 1
    size = max(abs(top), abs(tau) * math.exp(right), math.exp(3 * right) / 3, abs(b * left), 1.0)
    rising, falling = _tangents(tau, b, eta, angle, count)
    return TrapezoidPlan(
        fmpq(*float(step).as_integer_ratio()), first, last, _short(angle), _short(rising), _short(falling),
        -(-(bits + math.ceil(math.log2(size)) + _GUARD_BITS) // _BITS_MULTIPLE) * _BITS_MULTIPLE,
    )  # fmt: skip


def _best_angle(tau: float, b: float, eta: float, goal: float, top: float) -> float:
    """The angle that allows the longest step: the excess grows like its square, so the best one is near the guess."""

    def merit(k: int) -> float:
        return _ANGLES[k] / (goal + _excess(tau, b, eta, _ANGLES[k], top))

    trial = 12
    growth = max(_excess(tau, b, eta, _ANGLES[trial], top), 1e-12) / _ANGLES[trial] ** 2
    guess = 2 * math.log2(_ANGLES[0] / math.sqrt(goal / growth))
    best = min(max(round(guess), 0), len(_ANGLES) - 1)
    for direction in (-1, 1):
        while 0 <= best + direction < len(_ANGLES) and merit(best + direction) > merit(best):
            best += direction
    return _ANGLES[best]


def _excess(tau: float, b: float, eta: float, angle: float, top: float) -> float:
    """By how much the shifted integrand is larger, as a logarithm."""
    return max(0.0, log_integrand(peak(tau, b, eta, angle), tau, b, eta, angle) - top)


def log_integrand(rho: float, tau: float, b: float, eta: float, angle: float = 0.0) -> float:
    """The logarithm of the (shifted) integrand in u = log rho."""
    x = eta * rho
    if x < 1e-2:
        cubic = rho**3 * (-1 / 3 + x / 8 - x * x / 10 + x**3 / 12)
    else:
        cubic = rho**3 * (x - x * x / 2 - x**3 / 3 - math.log1p(x)) / (2 * x**3)
    return -b * math.log(rho) + rho * tau * math.cos(angle) + math.cos(3 * angle) * cubic


def peak(tau: float, b: float, eta: float, angle: float = 0.0) -> float:
    """Where the (shifted) integrand in log rho is largest, b < 0: Newton's method from the right, on a convex function.

    >>> abs(peak(0.0, -2.0, 0.0) - 2 ** (1 / 3)) < 1e-9
    True
    """
    cosine, cosine_3 = math.cos(angle), math.cos(3 * angle)
    rho: float = max(2 * math.sqrt(max(tau, 0.0) * cosine / cosine_3), (-4 * b / cosine_3) ** (1 / 3))
    if tau < 0:
        rho = min(rho, -b / (-tau * cosine))
    for _ in range(_NEWTON_STEPS):
        x = eta * rho
        cubic = cosine_3 * rho * rho * (x + 2) / (2 * (1 + x))
        slope = cubic * 3 - cosine_3 * rho * rho * x / (2 * (1 + x) ** 2) - tau * cosine
        following: float = rho - (rho * (cubic - tau * cosine) + b) / slope
        if abs(following - rho) <= 1e-10 * rho:
            return following
        rho = following
    return rho


def _edge(beyond: Callable[[float], float], start: float, direction: float) -> float:
    """Where ``beyond`` becomes positive, from ``start`` in the direction."""
    step = direction / 64
    while beyond(start + step) < 0:
        step *= 2
    near, far = 0.0, step
    for _ in range(12):
        middle = (near + far) / 2
        near, far = (middle, far) if beyond(start + middle) < 0 else (near, middle)
    return start + far


def _tangents(tau: float, b: float, eta: float, angle: float, count: int) -> tuple[float, float]:
    """Points on both sides of the maxima of the concave logarithm in rho, about one standard deviation away."""

    def place(exponent: float) -> tuple[float, float]:
        top = peak(tau, exponent + 1, eta, angle)
        return top, top / math.sqrt(-(exponent + 1) + top**3 * math.cos(3 * angle))

    low, width_low = place(b)
    high, width_high = place(b - count + 1)
    return max(low / 2, low - width_low), high + width_high


def _rounded(step: float) -> float:
    """Down to few bits, so that grids are shared between neighbouring calls."""
    mantissa, exponent = math.frexp(step)
    return math.ldexp(math.floor(mantissa * 2**_STEP_BITS) / 2**_STEP_BITS, exponent)


def _short(value: float) -> fmpq:
    mantissa, exponent = math.frexp(value)
    number = fmpq(round(mantissa * 2**16), 2**16)
    return number * fmpq(2) ** exponent
