"""The answers to the hard cases by other routes: mpmath, exact fractions, the other method of the library."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise
from typing import Any

import mpmath
import numpy as np
from flint import arb, fmpq
from witnesses.theta import theta_witness, to_fraction
from witnesses.true_solutions import extended_motion

from gspot_verified.compliant.model.normal_form import compliant_model
from gspot_verified.compliant.motion.compliant_force import force
from gspot_verified.compliant.slow.grid import scale
from gspot_verified.expansion.trajectory import expand_in_balls
from gspot_verified.hard_cases import expansion_cases, fold_cases, theta_cases
from gspot_verified.hard_cases.hard_case import near, nearest_double
from gspot_verified.mechanisms.shipped import shipped_system
from gspot_verified.paper.numerics.paper_state import paper_state

Truth = Fraction | int | tuple[Fraction, Fraction]
"""A value, a sign or a number of things, or the ends of an interval that holds the value."""


def exact(value: fmpq) -> Fraction:
    return Fraction(int(value.p), int(value.q))


def power(k: int) -> Fraction:
    return Fraction(1, 10**k)


def integer_beta(k: int) -> Truth:
    return theta_witness(Fraction(2), 3 + power(k), 40 + k)


def negative_tau(x: int) -> Truth:
    beta = Fraction(7, 3)
    if x < 30:
        return theta_witness(Fraction(-x), beta, 40)
    # The alternating series in x^-3, whose smallest term is near number x^(3/2)/3 > 80: here 40 terms.
    terms, term = [], Fraction(1)
    for k in range(40):
        terms.append(term / Fraction(x) ** (3 * k))
        for j in range(3):
            term *= -beta + 3 * k + j
        term /= -3 * (k + 1)
    with mpmath.workdps(60):
        total = sum(mpmath.mpf(t.numerator) / t.denominator for t in terms)
        return to_fraction(total * mpmath.mpf(x) ** (mpmath.mpf(7) / 3))


def overflow(k: int) -> Truth:
    if k < 2:
        upper, lower = (theta_witness(Fraction(10**k), Fraction(b, 3), 40) for b in (7, 1))
        return upper / lower
    with mpmath.workdps(60):
        tau, (upper_series, lower_series) = mpmath.mpf(10) ** k, (_at_infinity(k, b) for b in (7, 1))
        front = mpmath.rgamma(-mpmath.mpf(7) / 3) / mpmath.rgamma(-mpmath.mpf(1) / 3)
        return to_fraction(front / tau * upper_series / lower_series)


def _at_infinity(k: int, thirds: int) -> Any:
    """Sum of g_n lambda^-n, lambda = tau^(3/2): the differential equation put into e^(2 lambda/3) lambda^a times it."""
    a, scale = -mpmath.mpf(thirds) / 9 - mpmath.mpf(1) / 2, mpmath.mpf(10) ** (mpmath.mpf(3 * k) / 2)
    known = [mpmath.mpf(0), mpmath.mpf(1)]
    for n in range(1, 31):
        first, second = a - n + 1, a - n + 2
        one = (27 * first**2 - 9 * first - 1) / 4
        two = 3 * second * (3 * second - 2) * (3 * second - 4) / 8
        known.append((one * known[-1] + two * known[-2]) / (3 * n))
    return sum(value / scale**n for n, value in enumerate(known[1:]))


def near_zero(k: int) -> Truth:
    return theta_witness(exact(theta_cases.zero_below(k)), Fraction(7, 3), 40 + k)


def side(k: int) -> Truth:
    return 1 if math.floor(2 + power(k)) % 2 else -1


def zeros_meet(k: int) -> Truth:
    """Changes of sign of dTheta/dtau at points that lie on both sides of each zero."""
    step = 2 * Fraction(10) ** -(k // 2)
    return _changes(6 - power(k), [Fraction(-2), -step, Fraction(0), step, Fraction(1), Fraction(6)], k)


def zero_far_out(k: int) -> Truth:
    """On both sides of where the growing part, e^(2 tau^(3/2)/3) 10^-k times a power, is as large as the polynomial."""
    place = float(k * 2.302585 * 1.5) ** (2 / 3)
    return _changes(3 + power(k), [Fraction(1), Fraction(round(place)), Fraction(round(place) + 5)], k)


def _changes(beta: Fraction, points: list[Fraction], k: int) -> int:
    values = [-beta * theta_witness(point, beta - 1, k + 30) for point in points]
    assert all(values)
    return sum((left > 0) != (right > 0) for left, right in pairwise(values))


def wide_range(x: int) -> Truth:
    """At some points; that it is so at all is the theorem on 0 < beta < 1."""
    for tau in (Fraction(-min(x, 20)), Fraction(0), Fraction(5)):
        for tenths in (3, 5, 7):
            assert theta_witness(tau, Fraction(tenths, 10) - 1, 20) > 0
    return -1


def certificate(k: int) -> Truth:
    assert zeros_meet(k) == 3
    return 1


def high_degree(n: int) -> Truth:
    """Theta(5, n) by its recurrence in n, in integers."""
    values = [1, -5, 25]
    for m in range(3, n + 1):
        values.append(-5 * values[m - 1] + (m - 1) * (m - 2) * values[m - 3])
    return Fraction(values[n])


def obstructed(k: int) -> Truth:
    """By the recursion in balls, with bits to spare."""
    terms = expand_in_balls(shipped_system("oscillator", beta=near(2, k)), 3, 100 + 8 * k).lambda_n[-1]
    return _ends(terms.coefficients()[-1])


def _ends(value: arb) -> tuple[Fraction, Fraction]:
    assert value.is_finite()
    lower, upper = value.lower().fmpq(), value.upper().fmpq()
    return exact(lower) - abs(exact(lower)) / 10**30, exact(upper) + abs(exact(upper)) / 10**30


def uniform(end: int) -> Truth:
    """One delta and one solution: scipy's run from the expansion stays within the constant of p."""
    found = expansion_cases.bound_until(end)
    delta, order = 0.05, expansion_cases.ORDER
    terms = found.trajectory.terms()

    def value(name: str, s: float) -> float:
        rows = (term.coefficients() for term in terms[name])
        return sum(
            delta**n * sum(float(Fraction(str(c))) * s**j for j, c in enumerate(row)) for n, row in enumerate(rows)
        )

    state = [value(name, -3.0) for name in "pbyvz"]
    [there] = extended_motion(1.0, (-1.0, -1.0, -1.5), delta, -3.0, state, [float(end)])
    distance = abs(there["p"] - value("p", float(end)))
    assert 0 < distance <= float(found.constants["p"].upper()) * delta**order
    return 1


def canard(_: int) -> Truth:
    """b lies above the canard's value, C has the sign of b-hat, and Gamma(-5/2) < 0: K < 0."""
    return 1 if mpmath.gamma(-2.5) > 0 else -1


def small_epsilon(k: int) -> Truth:
    """C = eps (b_hat/p_0) eps^a/Gamma(a) int y^(a-1) e^(-p_0 y - psi(-eps y)/eps) dy, a = beta - 1, by mpmath."""
    with mpmath.workdps(40):
        a, p, eps = mpmath.mpf(13) / 2, mpmath.mpf(1) / 2, mpmath.mpf(10) ** -k
        b_hat = -mpmath.mpf(1) / (2 * a)

        def weight(y: Any) -> Any:
            x = eps * y
            if x >= 1:
                return mpmath.mpf(0)
            if x < mpmath.mpf("0.01"):
                psi = sum(x**j / j for j in range(4, 30)) + 2 * x**3 / 3
            else:
                psi = -mpmath.log(1 - x) - x - x**2 / 2 + x**3 / 3
            return y ** (a - 1) * mpmath.exp(-p * y - psi / eps)

        end = min(1 / eps, mpmath.mpf(400))
        integral = mpmath.quad(weight, mpmath.linspace(0, end, 9))
        return to_fraction(eps * b_hat / p * eps**a * integral / mpmath.gamma(a))


def fold(k: int) -> Truth:
    """T^4 - 16 T/eps + 6/eps is convex, and 1/16 - 2/eps at T = 1/2."""
    epsilon = 32 - power(k)
    return 2 if Fraction(1, 16) - 2 / epsilon < 0 else 0


def fold_curve(k: int) -> Truth:
    """Two zeros by what the bracket of the fold certifies for every beta below it; one more, far off, in doubles."""
    fold = fold_cases.the_fold()
    beta = fold.lower - fmpq(1, 10**k)
    assert fold.range[0] < beta < fold.lower
    before, after = fold_cases.force_in_doubles(np.array([2.0, 6.0]), nearest_double(beta) - 1, 1.0)
    assert fold.tau[1] < 2 * scale(fold.epsilon)
    assert before < -1 < 1 < after or before > 1 > -1 > after
    return 3


def tiny_data(_: int) -> Truth:
    """The same state but for its size: that of K for b < 0 where Gamma(-5/2) < 0."""
    return -1 if mpmath.gamma(-2.5) > 0 else 1


def spots_meet(k: int) -> Truth:
    return _spots(Fraction(4, 3) + power(k))


def spots_gone(k: int) -> Truth:
    return _spots(Fraction(4, 3) - power(k))


def _spots(friction: Fraction) -> int:
    """Two angles for each real root of t^2 - 3 mu t + 4, t = tan theta."""
    return 4 if 9 * friction**2 > 16 else 0


def ratio(k: int) -> Truth:
    """C_1/Gamma(-beta) < 0 lifts off."""
    return -side(k)  # type: ignore[operator]


SEEN = {4: "0.6114016921", 12: "0.6788126702", 60: "0.9427147819"}
"""Where the force changes its sign, in units of time after the start."""


def run(k: int) -> Truth:
    """From the exact solution of the equations in contact, without a step in time: a change of sign of the force."""
    model = compliant_model("5/2", "1/1000")
    state = paper_state(model, near(1, k, -1))
    first, last = Fraction(SEEN[k]) - power(9), Fraction(SEEN[k]) + power(9)
    before, after = (force(model, state, str(t - Fraction(1, 2)), 8).force for t in (first, last))
    assert before > 0 > after
    return first, last


TRUTHS: dict[str, Callable[[int], Truth]] = {
    "integer-beta": integer_beta,
    "negative-tau": negative_tau,
    "overflow": overflow,
    "near-zero": near_zero,
    "side": side,
    "zeros-meet": zeros_meet,
    "zero-far-out": zero_far_out,
    "wide-range": wide_range,
    "certificate": certificate,
    "high-degree": high_degree,
    "obstructed": obstructed,
    "uniform": uniform,
    "canard": canard,
    "small-epsilon": small_epsilon,
    "fold": fold,
    "fold-curve": fold_curve,
    "tiny-data": tiny_data,
    "spots-meet": spots_meet,
    "spots-gone": spots_gone,
    "ratio": ratio,
    "run": run,
}
"""By the family's name; "high-order" has a test of its own."""
