"""The linear contact of the model at every epsilon: its growing solution by the plain Taylor method, and its slow
solution by a quadrature of the defining integral with a recurrence in b.

F_b(T) = int_0^inf r^(-b-1) exp(psi(r)/epsilon + r T) dr / Gamma(-b) for b < 0, psi(r) = r - r^2/2 - r^3/3 - log(1 + r).
From (1 + r) psi' = -2 r^2 - r^3 and 0 = int d/dr[(1 + r) r^(-b) exp(...)] dr follows the recurrence used below.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import mpmath
from attack.reference_series import Series, fixed, good_step, number, series, solution, value


def force_later(
    beta: Fraction, epsilon: Fraction, state: Sequence[Fraction], p_end: Fraction, mean: Fraction
) -> Fraction:
    """lambda less its mean at p = p_end, from p, b, Y, V, Z with alpha_1 = -1, alpha_2 = mean (1 - beta) and a contact
    that may pull: the equations are linear, and from p well below 0 on its growing solution alone is left."""
    alpha_2 = mean * (1 - beta)

    def rates(states: Sequence[Series]) -> Sequence[Series]:
        p, b, Y, V, Z = states
        force = Z - Y
        return [series(-epsilon), (force * beta + alpha_2) * epsilon, V, b + p * force, -Z - force]

    now, values = Fraction(0), [fixed(x) for x in state]
    end = (state[0] - p_end) / epsilon
    while now < end:
        found = solution(rates, values)
        step = min(good_step(found, fixed(Fraction(1, 2))), fixed(end - now))
        if step <= 1:
            break
        values = [value(x, step) for x in found]
        now += number(step)
    return number(values[4] - values[2]) - mean


def slow_values(b: Fraction, epsilon: Fraction, far: Fraction, count: int) -> list[tuple[Fraction, Fraction]]:
    """(T, F_b(T)) at ``count`` equal steps to -far/4 and to far: from T = 0 by the series of
    F''''/eps + 2 F'''/eps - T F'' - (T + 1 - b) F' + b F = 0, which the recurrence and F_b' = -b F_(b-1) give."""
    begin = [fixed(Fraction(*mpmath.libmp.to_rational(x._mpf_))) for x in slow_start(b, epsilon)]
    found = []
    for way, end in ((-1, far / 4), (1, far)):

        def rates(states: Sequence[Series], way: int = way) -> Sequence[Series]:
            F, first, second, third, T = states
            fourth = (T * second + (T + (1 - b)) * first - F * b) * epsilon - third * 2
            return [x * way for x in (first, second, third, fourth, series(1))]

        values = [*begin, 0]
        for k in range(1, count + 1):
            left = fixed(end / count)
            while left > 0:
                now = solution(rates, values)
                step = min(good_step(now, left), left)
                values, left = [value(x, step) for x in now], left - step
            found.append((way * k * end / count, number(values[0])))
    return sorted(found)


def slow_force(alpha: Sequence[Fraction], c1: Fraction, epsilon: Fraction, tau: Fraction) -> float:
    """lambda on the slow manifold at tau.

    With a = -alpha_1 and T = t/epsilon the equations are those of alpha_1 = -1 with a epsilon for epsilon, and
    lambda - mean = K F_b(T), b = alpha_3/alpha_1 - 1. From b' = alpha_2 - alpha_3 lambda and the deviation
    C_1 (-t)^beta of b far back, where F_b(T) is (-T)^b, follows K = beta C_1 epsilon^b/alpha_3.
    """
    first, second, third = alpha
    beta, mean = third / first, second / (third - first)
    with mpmath.workdps(60):
        T = _mp(tau) / (mpmath.cbrt(_mp(epsilon)) * mpmath.cbrt(_mp(-first / 2)))
        value = _slow_at(beta - 1, T, -first * epsilon)
        return float(_mp(mean) + _mp(beta * c1 / third) * _mp(epsilon) ** _mp(beta - 1) * value)


def _slow_at(b: Fraction, T: mpmath.mpf, epsilon: Fraction, digits: int = 20) -> mpmath.mpf:
    """F_b(T) = M_b/Gamma(-b), M_b = int r^(-b-1) exp(...) dr; 0 = int d/dr[(1 + r) r^(-b) exp(...)] dr gives M_b."""
    low = b - max(0, int(b) + 3)  # the integrand falls off quickly on the left
    small = _mp(epsilon)
    kept = [_integral(low - j, T, small, digits) * mpmath.gamma(_mp(j - low)) for j in (3, 2, 1, 0)]
    for j in range(1, int(b - low) + 1):
        at = _mp(low + j)
        one, two, three, four = kept[-1], kept[-2], kept[-3], kept[-4]
        kept.append(((1 - at) * one + T * (one + two) - (2 * three + four) / small) / at)
    return kept[-1] * mpmath.rgamma(-_mp(b))


def slow_start(b: Fraction, epsilon: Fraction, digits: int = 45) -> list[mpmath.mpf]:
    """F_b and its three first derivatives at T = 0."""
    with mpmath.workdps(digits + 30):
        steps = max(0, int(b) + 2) if b >= -Fraction(1, 2) else 0
        low, small = b - steps, _mp(epsilon)
        values = [_integral(low - 3 + j, mpmath.mpf(0), small, digits) for j in range(4)]
        for j in range(1, steps + 1):
            c = _mp(low + j)
            one, three, four = values[-1], values[-3], values[-4]
            total = -(1 - c) * one + 2 / small * (1 - c) * (2 - c) * three
            values.append(total + (1 - c) * (2 - c) * (3 - c) * four / small)
        power, factor, found = _mp(b), mpmath.mpf(1), []
        for j in range(4):
            found.append(factor * values[-1 - j])
            factor *= j - power
        return found


def _mp(x: Fraction) -> mpmath.mpf:
    return mpmath.mpf(x.numerator) / x.denominator


def _integral(b: Fraction, T: mpmath.mpf, small: mpmath.mpf, digits: int) -> mpmath.mpf:
    """The trapezoidal rule in log r, whose ends are where the integrand is below 10^-(digits + 20) of its top."""
    power = -_mp(b)

    def exponent(w: mpmath.mpf) -> mpmath.mpf:
        r = mpmath.exp(w)
        return power * w + (r - r**2 / 2 - r**3 / 3 - mpmath.log1p(r)) / small + r * T

    drop, step = (digits + 20) * mpmath.log(10), mpmath.mpf(1) / 8
    top = max((k * step for k in range(-160, 80)), key=exponent)
    peak = exponent(top)
    left, right = top - 1, top + 1
    while exponent(left) > peak - drop:
        left -= 1
    while exponent(right) > peak - drop:
        right += mpmath.mpf(1) / 4
    count = 96
    width = (right - left) / count
    total = sum((mpmath.exp(exponent(left + k * width) - peak) for k in range(count + 1)), mpmath.mpf(0))
    before = None
    while before is None or abs(total * width - before) > abs(before) * mpmath.mpf(10) ** -(digits + 3):
        before = total * width
        total += sum(
            (mpmath.exp(exponent(left + (k + mpmath.mpf(1) / 2) * width) - peak) for k in range(count)), mpmath.mpf(0)
        )
        count, width = 2 * count, width / 2
        if count > 100_000:
            raise ArithmeticError("the quadrature does not settle")
    return total * width * mpmath.exp(peak) * mpmath.rgamma(power)
