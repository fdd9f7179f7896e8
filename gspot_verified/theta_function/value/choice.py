"""Which route, how many terms, how many bits: heuristics only.

Everything here is a guess in floats. Any choice is correct, because each route bounds what it leaves out; a bad
choice costs time or accuracy, never truth. No bound stands in this file.
"""

from __future__ import annotations

import cmath
import math
from functools import lru_cache
from typing import NamedTuple

from flint import fmpq

from gspot_verified.numbers.balls import Exact, approximate
from gspot_verified.theta_function.sums.laplace import LaplacePlan
from gspot_verified.theta_function.sums.positive import SaddlePlan

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


_LN2 = math.log(2)  # nats of a bit
_SQRT_3 = math.sqrt(3)  # tangent of 60 degrees
_GUARD = 8  # bits beyond those asked for, lost on the way; any number is right
_TINY = 1e-60  # in place of tau = 0, which has no logarithm
_DISCS = (72, 80, 66, 60, 52, 44, 36, 28, 20, 14, 10, 6)  # of the saddle point, in percent
SPLITTING_FROM_BITS = 900  # by trial: from there on splitting is faster than the floating series
_TERMS_ONE_BY_ONE = 40  # beyond the turn of the terms' sizes; then they are counted by a formula
_SPLITTING_HEIGHT = 256  # bits of the integers of one term with which splitting is fast
# Work of the floating series, in terms times bits, from which another route is faster.
_QUADRATURE_FROM_WORK = 20_000_000
_QUADRATURE_BELOW_GOAL = 400  # bits up to which the quadrature is
_SPLITTING_FROM_WORK = 100_000_000  # from which on splitting is faster with fewer bits, too


class TaylorPlan(NamedTuple):
    """Terms and working bits of the series at 0."""

    length: int
    bits: int


class NegativePlan(NamedTuple):
    """Terms and working bits of the enveloping series."""

    terms: int
    bits: int


def taylor_plan(tau: float, beta: float, goal: int) -> TaylorPlan:
    """Terms and bits with which the series at 0 reaches about ``goal`` bits, for |tau| = the float given."""
    if tau == 0:
        return TaylorPlan(3, _rounded(goal + _GUARD))
    size = max(abs(tau), _TINY)
    if abs(beta) <= 8:
        peak = 2 / 3 * size**1.5 + math.log1p(size)
        value = min(peak, beta * math.log1p(size)) if tau < 0 else peak
    else:
        peak, value = largest_term(size, beta), log_theta(tau, beta)
    bits = _rounded(goal + _GUARD + max(0, math.ceil((peak - value) / _LN2)))
    return TaylorPlan(taylor_length(size, beta, (goal + 4) * _LN2 - min(value, peak)), bits)


def complex_taylor_plan(size: float, turn: float, beta: float, goal: int) -> TaylorPlan:
    """The same for complex tau of this size and angle: more bits by as much as Theta is smaller there than at |tau|."""
    fall = log_fall(size, turn, beta) if size else 0
    plan = taylor_plan(size, beta, goal + math.ceil(fall / _LN2))
    # The rectangles of the polynomial's value turn, and grow, about sqrt(length) times.
    return TaylorPlan(plan.length, plan.bits + _rounded(math.isqrt(plan.length) // 2))


def turn(tau: complex) -> fmpq:
    """tan(psi/2) of the ray e^(i psi) on which the Laplace integral at this tau is smallest in absolute values."""

    def argument(k: int) -> float:
        psi = 2 * math.atan(k / 100)
        length: float = math.cos(3 * psi) ** (1 / 3)
        return (tau.real * math.cos(psi) - tau.imag * math.sin(psi)) / length

    return fmpq(min(range(-26, 27), key=argument), 100)


def first_levels(beta: Exact, most: int) -> int:
    """So many mean value forms that the last slope has a negative beta; one where that takes more than ``most``."""
    parameter = approximate(beta)
    return 1 + max(0, math.ceil(parameter)) if parameter < most else 1


def _rounded(bits: int) -> int:
    """Up to a multiple of 16 (of 32 from 128 on), so that cached initial values and polynomials serve many tau."""
    step = 16 if bits <= 128 else 32
    return -(-bits // step) * step


def taylor_length(size: float, beta: float, drop: float) -> int:
    """Terms until they fall below e^-drop, and long enough for the ratio test; a multiple of 3."""
    scale: float = size**1.5
    # |a_k| size^k is near exp(-(2/3) k (ln(k/scale) - 1)) for k well above |beta|.
    # It has no solution below -scale: e^-drop may be far above 1, but not above the largest term.
    target = 1.5 * max(drop + abs(beta), -0.6 * scale)
    k = math.e * scale + target / 4
    for _ in range(3):
        # Newton's step for k (ln(k/scale) - 1) = target.
        slope = math.log(k / scale) if k > scale else 0.1
        k = max((target + k) / max(slope, 0.1), 1.0)
    if abs(beta) > 8:
        while log_term(k, size, beta) > -drop and k < 1e9:
            k *= 1.1
    least: float = math.sqrt(2 * scale * scale * (1 + abs(beta) / (k + 1))) + 3
    return 3 * math.ceil(max(k, least) / 3)


@lru_cache(maxsize=4096)
def negative_plan(x: float, beta: float, goal: int) -> NegativePlan | None:
    """Terms and bits with which the enveloping series reaches ``goal`` bits; ``None`` when it cannot."""
    if x <= 1 or x**1.5 * 2 / 3 < goal * _LN2 * 0.9:
        return None
    inverse = x**-3
    term, largest, k = 0.0, 0.0, 0
    settled = abs(beta) / 3 + _TERMS_ONE_BY_ONE
    while True:
        # For beta < 0 the terms alternate: the sum is near 1/largest, so twice its logarithm is lost.
        lost = 2 * largest if beta < 0 else -largest
        enough = -(goal + 3) * _LN2 - lost + largest
        if k > settled:
            terms = _enveloping_terms(k, term, enough, x, beta)
            return None if terms is None else _negative_plan(terms, x, beta, goal, lost)
        if 3 * k > beta and k >= 1 and term < enough:
            return _negative_plan(k, x, beta, goal, lost)
        # Next to an integer a factor is tiny, but a float cannot tell how tiny: count it as 1/2.
        factor = inverse / (3 * (k + 1))
        for j in range(3 * k, 3 * k + 3):
            factor *= max(abs(j - beta), 0.5)
        if 3 * k > beta and factor >= 1 and k > abs(beta) / 6:
            return None
        term += math.log(factor)
        largest = max(largest, term)
        k += 1


def _negative_plan(terms: int, x: float, beta: float, goal: int, lost: float) -> NegativePlan:
    power = math.ceil(math.log2(1 + abs(beta) * math.log(x)))
    return NegativePlan(terms, _rounded(goal + _GUARD + power + math.ceil(max(0.0, lost) / _LN2)))


def _enveloping_terms(start: int, log_start: float, enough: float, x: float, beta: float) -> int | None:
    """The least k >= start with ln |t_k| < enough, by bisection down to the smallest term: ln |t_start| is given."""

    def size(k: int) -> float:
        rise = math.lgamma(3 * k - beta) - math.lgamma(k + 1) - k * (math.log(3) + 3 * math.log(x))
        return rise - at_start + log_start

    at_start = math.lgamma(3 * start - beta) - math.lgamma(start + 1) - start * (math.log(3) + 3 * math.log(x))
    low, high = start, max(start, int(x**1.5 / 3))
    if size(high) >= enough:
        return None
    while low < high:
        middle = (low + high) // 2
        if size(middle) < enough:
            high = middle
        else:
            low = middle + 1
    return low


def sector_plan(z: complex, beta: float, goal: int) -> NegativePlan | None:
    """The same for the enveloping series in a sector, z = -tau; ``None`` when it cannot."""
    x = max(_SQRT_3 * z.real + abs(z.imag), 0.0) / 2 if _SQRT_3 * abs(z.imag) > z.real else abs(z)
    if x <= 1:
        return None
    return negative_plan(x, beta, goal + math.ceil(max(0.0, -beta) * math.log2(abs(z) / x)))


@lru_cache(maxsize=4096)
def saddle_plan(tau: float, beta: float, goal: int) -> SaddlePlan | None:
    """Terms and disc with which the saddle point bound reaches ``goal`` bits; ``None`` when it cannot."""
    large = tau**1.5
    target = (goal + 4) * _LN2 + _log_growth(large, beta)
    best: tuple[int, SaddlePlan] | None = None
    for percent in _DISCS:
        disc = percent / 100
        cut = min(1 - disc, 0.45)
        sigma = disc * math.sqrt(1 - disc / 3)
        whole = max(0, math.ceil(-(beta + 1)))
        log_norm = whole * math.log(1 + disc) - (beta + 1 + whole) * math.log(1 - disc)
        near_zero = large * (2 / 3 - cut - cut**3 / 3) + beta * math.log(cut)
        tails = large * sigma**2 - max(0.0, -(beta + 1)) * sigma - max(0.0, log_norm, -(beta + 1) * math.log(cut))
        if min(near_zero, tails - 0.5 * math.log(large)) < target:
            continue
        terms = _saddle_terms(sigma * sigma * large, log_norm + 1 + target)
        if terms is None or 2 * terms > large * sigma**2:
            continue
        if best is None or terms < best[0]:
            best = (terms, SaddlePlan(terms, fmpq(percent, 100), fmpq(min(100 - percent, 45), 100)))
    return best[1] if best else None


def _log_growth(large: float, beta: float) -> float:
    """Room for a saddle series that is itself small: its sum is near e^(beta^2/(4 lambda)) or larger than 1."""
    return max(0.0, -(beta * beta) / (4 * large)) + 1.0


def _saddle_terms(ratio: float, drop: float) -> int | None:
    """The least N with lgamma(N + 1/2) - N ln ratio < -drop."""
    if ratio < 2:
        return None
    low, high = 1, max(2, int(ratio))

    def size(n: int) -> float:
        return math.lgamma(n + 0.5) - n * math.log(ratio)

    if size(high) > -drop:
        return None
    while low < high:
        middle = (low + high) // 2
        if size(middle) <= -drop:
            high = middle
        else:
            low = middle + 1
    return low


def laplace_plan(tau: float, beta: float, goal: int) -> LaplacePlan:
    """Cut near where the integrand leaves its singularity, end where it is below 2^-goal of its largest value."""
    cut = min((1 + max(beta, 0.0)) / (1 + abs(tau)), 2.0 + math.sqrt(abs(tau)) / 2)
    peak = stationary(tau, beta) or math.sqrt(max(tau, 0.0))
    peak = max(peak, cut)

    def log_integrand(r: float) -> float:
        return r * tau - r**3 / 3 - beta * math.log(r)

    top = log_integrand(peak)
    end, step = peak, max(peak * 0.05, 0.05)
    while log_integrand(end) > top - (goal + 20) * _LN2 or end * end < tau + abs(beta) / end + 0.1:
        end += step
        step *= 1.1
    crowd = 4 * cut * abs(tau) + 22 * cut**3
    terms = math.ceil(max((goal + 20) * _LN2 / math.log(4) + crowd / math.log(4), beta + 2)) + 4
    return LaplacePlan(_short(cut), _short(end), terms, _short(peak), 5_000 + 40 * goal)


def _short(value: float) -> fmpq:
    """A nearby rational of small height."""
    scale = 1 << max(0, 12 - math.frexp(value)[1])
    return fmpq(max(1, round(value * scale)), scale)


def prefers_splitting(tau: Exact, beta: Exact, bits: int) -> bool:
    """True where exact binary splitting beats the floating series: many bits, rationals of small height."""
    height = _height(tau, beta)
    return height is not None and bits >= SPLITTING_FROM_BITS and height <= max(_SPLITTING_HEIGHT, bits // 200)


def _height(tau: Exact, beta: Exact) -> int | None:
    """Bits of the integers that one Taylor term brings in; ``None`` for balls."""
    if not (isinstance(tau, fmpq) and isinstance(beta, fmpq)):
        return None
    return tau.height_bits() * 3 + beta.height_bits()


def saddle_bits(tau: float, beta: float, goal: int) -> int:
    """Working bits of the saddle route: the exponent 2 lambda/3 and large powers lose their leading bits."""
    lost = 1.5 * math.log2(tau) + abs(beta) ** 2 / (2 * tau**1.5 * _LN2) + 2 * math.log2(abs(beta) + 2)
    return _rounded(goal + _GUARD + math.ceil(lost))


def laplace_bits(tau: float, beta: float, plan: LaplacePlan, goal: int) -> int:
    """Working bits of the Laplace route: the series and the integral may cancel for beta > 0."""
    cut = float(int(plan.cut.p) / int(plan.cut.q))
    parts = beta * -math.log(cut) + max(cut * tau, 0.0) if beta > 0 else 0.0
    lost = max(0.0, parts + log_moment(beta + 1, reciprocal=True) if beta > 0 else 0.0)
    return _rounded(goal + 2 * _GUARD + math.ceil(lost / _LN2) + math.ceil(math.log2(abs(tau) + abs(beta) + 2) * 2))


def block_length(bits: int) -> int:
    """Terms in one block of the exact binary splitting: longer blocks pay once the polynomials' set-up is small."""
    return 8 if bits < 8_000 else 16


def preferred_routes(tau: Exact, beta: Exact, goal: int) -> list[str]:
    """Route names, best first. A route answers "not finite" at once where it cannot reach the goal."""
    point, parameter = approximate(tau), approximate(beta)
    if -8 <= point <= 8 and goal < SPLITTING_FROM_BITS and -300 < parameter < 300:
        return ["taylor"]
    names = []
    if point < -8:
        names.append("negative")
    elif point > 8:
        names.append("positive")
    plan = taylor_plan(point, parameter, goal)
    work = plan.length * (plan.bits + 500)
    if work > _QUADRATURE_FROM_WORK and goal < _QUADRATURE_BELOW_GOAL and parameter < 0:
        names.append("laplace")
    height = _height(tau, beta)
    if prefers_splitting(tau, beta, goal) or (
        height is not None and work > _SPLITTING_FROM_WORK and height <= max(_SPLITTING_HEIGHT, plan.bits)
    ):
        names.append("splitting")
    return [*names, "taylor", "laplace"]
