"""How large Theta and its Taylor terms are, in floats: heuristics only. No bound stands in this file."""

from __future__ import annotations

import cmath
import math

_TURNS = 32  # steps in which a saddle is followed from the positive axis to the angle of tau


def log_term(k: float, size: float, beta: float) -> float:
    """About ln of |a_k| size^k."""
    return (
        log_moment(k - beta)
        - log_moment(-beta, reciprocal=True)
        - math.lgamma(k + 1)
        + (k - beta) / 3 * math.log(3)
        + k * math.log(size)
    )


def log_moment(z: float, reciprocal: bool = False) -> float:
    """About ln of |Gamma(z/3)|, or of |Gamma(z)|, kept finite next to the poles."""
    argument = z if reciprocal else z / 3
    nearest = round(argument)
    if argument < 0.5 and abs(argument - nearest) < 0.01:
        argument = nearest + 0.01
    return math.lgamma(argument)


def largest_term(size: float, beta: float) -> float:
    """About ln of the largest |a_k| size^k."""
    peak = max(3.0, size**1.5 + abs(beta))
    points = [peak * j / 64 for j in range(1, 129)] + [0.0, 1.0, 2.0]
    return max(log_term(k, size, beta) for k in points)


def log_theta(tau: float, beta: float) -> float:
    """A rough ln |Theta|: the leading saddle for beta < 0, the larger of the two parts for beta > 0."""
    saddle = log_saddle(tau, beta)
    if beta <= 0:
        return saddle
    algebraic = log_algebraic(abs(tau), beta)
    return max(algebraic, saddle) if tau > 0 else algebraic


def log_saddle(tau: float, beta: float) -> float:
    """ln of the peak of r^(-beta) e^(r tau - r^3/3) over r, over |Gamma(-beta)|; -inf without a peak."""
    point = stationary(tau, beta)
    if point is None:
        return -math.inf
    return point * tau - point**3 / 3 - beta * math.log(point) - log_moment(-beta, reciprocal=True)


def stationary(tau: float, beta: float) -> float | None:
    """The largest r > 0 with r tau - r^3 = beta."""
    r: float = math.sqrt(max(tau, 0.0)) + max(-beta, 0.0) ** (1 / 3) + 1.0
    for _ in range(100):
        slope = tau - 3 * r * r
        if slope >= 0:
            return None
        step = (r * tau - r**3 - beta) / slope
        r -= step
        if r <= 0:
            return None
        if abs(step) < 1e-9 * r:
            return r
    return None


def angle(tau: complex) -> float:
    """The angle between tau and the positive axis; cmath.phase fails next to the least floats."""
    return math.atan2(tau.imag, tau.real)


def log_fall(size: float, turn: float, beta: float) -> float:
    """About ln |Theta(|tau|)| - ln |Theta(tau)|, at least 0, for tau of this size and angle."""
    if beta > 0:
        fall: float = 2 / 3 * size**1.5 * (1 - math.cos(1.5 * min(abs(turn), math.pi / 3)))
        # The algebraic part does not fall.
        return min(fall, max(0.0, log_theta(size, beta) - log_algebraic(size, beta))) if beta > 8 else fall
    at_size = _followed_exponent(size, beta, 0.0, 0.0)
    there = _followed_exponent(size, beta, 0.0, turn)
    if abs(turn) > math.pi / 3:
        there = max(there, _followed_exponent(size, beta, math.copysign(math.pi, turn), turn))
    return max(0.0, at_size - there)


def _followed_exponent(size: float, beta: float, start: float, end: float) -> float:
    """r tau - r^3/3 - beta ln r, its real part, at the saddle that is followed from one angle of tau to another."""
    point = complex(stationary(math.copysign(size, math.cos(start)), beta) or size)
    for k in range(_TURNS + 1):
        tau = cmath.rect(size, start + (end - start) * k / _TURNS)
        for _ in range(4):
            slope = tau - 3 * point * point
            point -= (point * tau - point**3 - beta) / slope if slope else 0
    return (point * tau - point**3 / 3 - beta * cmath.log(point)).real if point else 0.0


def log_algebraic(size: float, beta: float) -> float:
    """ln of sum_k beta!/(beta - 3k)! size^(beta - 3k) / (3^k k!), all terms of one sign."""
    count = int(beta // 3)
    points = range(0, count + 1, max(1, count // 64))
    return max(
        math.lgamma(beta + 1)
        - math.lgamma(beta - 3 * k + 1)
        - math.lgamma(k + 1)
        + (beta - 3 * k) * math.log(size)
        - k * math.log(3)
        for k in points
    )
