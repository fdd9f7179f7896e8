"""Hard cases of the compliant model next to folds: two zeros that are about to vanish."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any

import numpy as np
from flint import arb, fmpq

from gspot_verified.compliant.zeros.fold_point import FoldPoint, fold_point
from gspot_verified.compliant.zeros.zero_count import SlowZeros, slow_zeros
from gspot_verified.hard_cases.hard_case import (
    Case,
    HardCase,
    bits_lost,
    log10,
    near,
    nearest_double,
    real_roots,
    timed,
)
from gspot_verified.numbers.balls import ball_text, working_bits

FOLD_EPSILON = fmpq(1)  # of the curve of folds that starts at beta = 6, epsilon = 0
_FOLD_DIGITS = 25  # more than beta and beta_f of any level have in common
_GRID = 600  # points in T, of a user who looks for changes of sign
_NODES = 120  # of Gauss's quadrature
_REACH = 2.4  # in y = r^(1/3): beyond it the integrand is below a double's last digit


def next_to_the_fold(k: int) -> HardCase:
    """The number of zeros at beta = 5, epsilon = 32 - 10^-k: at epsilon = 32 two of them meet."""
    epsilon = near(32, k, -1)
    zeros, seconds = timed(lambda: slow_zeros(5, epsilon))
    small = nearest_double(epsilon)
    double = float(real_roots([1.0, 0.0, 0.0, -16 / small, 6 / small]))

    def least_value(bits: int) -> arb:
        """T^4 - 16 T/epsilon + 6/epsilon at its minimum, T^3 = 4/epsilon."""
        with working_bits(bits):
            place = (4 / arb(epsilon)).root(3)
            return place**4 - 16 * place / arb(epsilon) + 6 / arb(epsilon)

    return HardCase(
        level=k,
        asked=f"the number of zeros of F_4(T; ε), ε = 32 − 10^−{k}",
        condition=log10(32 * fmpq(10) ** k),
        lost=bits_lost(least_value, 1),
        double=double,
        certified=zeros.number,
        text=_places(zeros),
        work=zeros.digits,
        seconds=seconds,
    )


def _places(zeros: SlowZeros) -> str:
    places = ", ".join(ball_text(place, 6) for place in zeros.places)
    return "undecided" if zeros.number is None else f"{zeros.number}: T = {places}"


def next_to_the_fold_curve(k: int) -> HardCase:
    """The number of zeros of F_(beta-1)(T; 1) at beta = beta_f - 10^-k; beta_f: where two of them meet."""
    beta = the_fold().lower - fmpq(1, 10**k)
    zeros, seconds = timed(lambda: slow_zeros(beta, FOLD_EPSILON))
    double = float(zeros_in_doubles(nearest_double(beta) - 1, 1.0))
    return HardCase(
        level=k,
        asked=f"the number of zeros of F_(β−1)(T; 1), β = β_f − 10^−{k}",
        condition=log10(beta * 10**k),
        double=double,
        certified=zeros.number,
        text=_places(zeros),
        work=0 if zeros.column is None else len(zeros.column.pieces),
        seconds=seconds,
    )


@lru_cache(maxsize=1)
def the_fold() -> FoldPoint:
    """The fold of epsilon = 1, which starts from beta = 6 at epsilon = 0, to 25 digits in beta."""
    fold = fold_point(FOLD_EPSILON, _FOLD_DIGITS)
    assert fold is not None
    return fold


def zeros_in_doubles(b: float, epsilon: float) -> int:
    """The sign changes of F_b(T; epsilon) on a grid of (0, 6)."""
    values = force_in_doubles(np.linspace(0.01, 6.0, _GRID), b, epsilon)
    return int(np.count_nonzero(np.sign(values[1:]) != np.sign(values[:-1])))


def force_in_doubles(times: Any, b: float, epsilon: float) -> Any:
    """F_b(T; epsilon), 4 < b < 5, by Gauss's quadrature of F_(b-5) to F_(b-8), and b F_b = (T + 1 - b) F_b' + T F_b''
    - (2 F_b''' + F_b'''')/epsilon with F_b' = -b F_(b-1)."""
    nodes, weights = np.polynomial.legendre.leggauss(_NODES)
    y, weights = (nodes + 1) * _REACH / 2, weights * _REACH / 2
    r = y**3  # so that r^(a-1) dr = 3 y^(3a-1) dy has no singularity, a > 1/3
    exponent = (r - r**2 / 2 - r**3 / 3 - np.log1p(r)) / epsilon + np.outer(times, r)
    heights = np.exp(exponent) * weights * 3
    known = [np.dot(heights, y ** (3 * a - 1)) / math.gamma(a) for a in (8 - b, 7 - b, 6 - b, 5 - b)]
    for c in (b - 4, b - 3, b - 2, b - 1, b):
        third, second, first, last = known[-4:]
        known.append(
            -(times + 1 - c) * last
            + times * (c - 1) * first
            + 2 / epsilon * (c - 1) * (c - 2) * second
            - (c - 1) * (c - 2) * (c - 3) / epsilon * third
        )
    return known[-1]


CASES: dict[str, Case] = {"fold": next_to_the_fold, "fold-curve": next_to_the_fold_curve}
