"""Theta of arrays of doubles, and its derivative by beta, against difference quotients of the reference: integers and
what lies next to them, wide balls, views of arrays in any order, columns of beta broadcast against rows of tau; where
another library has changed how doubles are rounded, and numpy raises what it can."""

from __future__ import annotations

import ctypes
import ctypes.util
from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction
from random import Random
from typing import Any

import mpmath
import numpy as np
from attack import reference_theta
from attack.answers import AGREED, Answer, Attack, undecided, worst, wrong
from attack.balls_as_numbers import accurate, holds, to_fmpq
from attack.theta import rational
from flint import arb

from gspot_verified import BudgetError, beta_derivative, theta_of_floats

_STEP = Fraction(1, 10**30)
_DIGITS = 110
_LOST = Fraction(1, 10**35)
"""What the difference quotient loses, beside the reference's values: the third derivative by beta times the square of
the step, far below 10^-35 of the largest of them."""


def attack(random: Random) -> Attack:
    """One of the three."""
    return random.choice((_in_beta, _in_beta, _over_a_ball, _array, _array))(random)


def _slope(tau: Fraction, beta: Fraction) -> tuple[mpmath.mpf, mpmath.mpf]:
    """dTheta/dbeta, and how far it may be off."""
    with mpmath.workdps(2 * _DIGITS):
        above, first = reference_theta.by_series(tau, beta + _STEP, 0, _DIGITS)
        below, last = reference_theta.by_series(tau, beta - _STEP, 0, _DIGITS)
        step, size = reference_theta.mp(_STEP), 1 + abs(above) + abs(below)
        value = (above - below) / (2 * step)
        return value, (first + last) / step + (size + abs(value)) * reference_theta.mp(_LOST)


def _in_beta(random: Random) -> Attack:
    tau, beta = rational(random, random.choice((1, 5, 20, 50))), rational(random, random.choice((2, 6, 15)))
    digits = random.choice((3, 15, 25))
    return Attack(f"beta_derivative('{tau}', '{beta}', {digits})", lambda: _judged_slope(tau, beta, digits))


def _judged_slope(tau: Fraction, beta: Fraction, digits: int) -> Answer:
    try:
        found = beta_derivative(to_fmpq(tau), to_fmpq(beta), digits)
    except BudgetError as error:
        return undecided(f"BudgetError: {str(error)[:40]}")
    value, off = _slope(tau, beta)
    if not holds(found, value, off):
        return wrong(f"{found} does not hold {mpmath.nstr(value, 40)}, known up to {mpmath.nstr(off, 3)}")
    return AGREED if accurate(found, digits) else undecided("wider than was asked, next to a zero")


def _over_a_ball(random: Random) -> Attack:
    """A ball of beta or of tau, over an integer or not: it holds the value at each number in it."""
    tau, beta = rational(random, 8), rational(random, 5)
    radius, in_beta = Fraction(1, random.choice((1, 2, 64, 10**6))), random.random() < 0.5
    shares = [Fraction(random.randint(-64, 64), 64) for _ in range(2)]
    places = [(tau, beta + radius * s) if in_beta else (tau + radius * s, beta) for s in shares]
    return Attack(f"beta_derivative of a ball of radius {radius} in {'beta' if in_beta else 'tau'} at {tau}, {beta}",
                  lambda: _judged_ball(tau, beta, radius, in_beta, places))  # fmt: skip


def _judged_ball(
    tau: Fraction, beta: Fraction, radius: Fraction, in_beta: bool, places: list[tuple[Fraction, Fraction]]
) -> Answer:
    wide = arb(to_fmpq(radius))
    around = [arb(to_fmpq(number)) for number in (tau, beta)]
    around[in_beta] = around[in_beta] + arb(0, wide)
    try:
        found = beta_derivative(*around)
    except BudgetError as error:
        return undecided(f"BudgetError: {str(error)[:40]}")
    for place in places:
        value, off = _slope(*place)
        if not holds(found, value, off):
            return wrong(f"{found} does not hold {mpmath.nstr(value, 30)}, the value at {place}")
    return AGREED


def _array(random: Random) -> Attack:
    """Entries of an array in some layout; each of a few is asked of the reference."""
    size, far = random.choice((1, 2, 3, 40, 400)), random.choice((1.0, 8.0, 40.0, 200.0))
    values = [_double(random, far) for _ in range(size)]
    betas = [rational(random, 8) for _ in range(3)]
    derivative, layout = random.choice((0, 0, 1, 3)), random.choice(tuple(_LAYOUTS))
    picks = [(random.randrange(10**6), random.randrange(3)) for _ in range(3)]
    rounded = random.choice(("to nearest", *_DIRECTIONS))
    question = f"theta_of_floats of {size} doubles up to {far}, {layout}, {derivative=}, {betas=!s}, rounded {rounded}"
    return Attack(question, lambda: _judged_array(values, betas, derivative, layout, picks, rounded))


def _double(random: Random, far: float) -> float:
    return random.choice((
        random.uniform(-far, far), float(random.randint(-int(far), int(far))), random.uniform(-1e-9, 1e-9), 5e-324,
        float(np.nextafter(random.randint(-int(far), int(far)), random.choice((-1e9, 1e9)))),
    ))  # fmt: skip


def _by_columns(values: list[float]) -> np.ndarray[Any, Any]:
    return np.asfortranarray(np.array([values, values[::-1]]))


_LAYOUTS = {
    "a list": list,
    "every second one": lambda values: np.repeat(np.array(values), 2)[::2],
    "backwards": lambda values: np.array(values)[::-1],
    "by columns": _by_columns,
    "broadcast": lambda values: np.broadcast_to(np.array(values), (2, len(values))),
    "single precision": lambda values: np.array(values, dtype=np.float32),
    "integers": lambda values: np.array([round(value) for value in values]),
    "big-endian": lambda values: np.array(values, dtype=">f8"),
}


_DIRECTIONS = {"down": 0x400, "up": 0x800, "to zero": 0xC00}
"""As the C library of an x86 processor numbers them; others do not know these numbers and change nothing."""


@contextmanager
def _other_library(rounded: str) -> Iterator[None]:
    """Doubles are rounded so, from the second array on; numpy raises what it can."""
    library = ctypes.CDLL(ctypes.util.find_library("m"))
    before = library.fegetround()
    if rounded in _DIRECTIONS:
        theta_of_floats([0.25, 0.5, 0.75], "7/3")
        library.fesetround(_DIRECTIONS[rounded])
    try:
        with np.errstate(all="raise" if rounded in _DIRECTIONS else "warn"):
            yield
    finally:
        library.fesetround(before)


def _judged_array(
    values: list[float],
    betas: list[Fraction],
    derivative: int,
    layout: str,
    picks: list[tuple[int, int]],
    rounded: str,
) -> Answer:
    given = _LAYOUTS[layout](values)
    points = np.asarray(given)
    if picks[0][1]:
        column = np.empty((3,) + (1,) * points.ndim, dtype=object)
        column.ravel()[:] = [to_fmpq(beta) for beta in betas]
        with _other_library(rounded):
            found = theta_of_floats(given, column, derivative)
    else:
        betas = betas[:1]
        with _other_library(rounded):
            found = theta_of_floats(given, to_fmpq(betas[0]), derivative)
    answers = []
    for place, row in picks:
        at = np.unravel_index(place % points.size, points.shape)
        where = (row, *at) if len(betas) > 1 else at
        beta, tau = betas[row if len(betas) > 1 else 0], Fraction(float(points[at]))
        answers.append(_judged_entry(float(found.midpoint[where]), float(found.radius[where]), tau, beta, derivative))
    return worst(answers)


def _judged_entry(middle: float, radius: float, tau: Fraction, beta: Fraction, derivative: int) -> Answer:
    if radius == float("inf"):
        return undecided("it overflows")
    with mpmath.workdps(80):
        value, off = reference_theta.by_series(tau, beta, derivative, 40)
        shown = f"{middle} +/- {radius} at {tau}, {beta}; the reference: {mpmath.nstr(value, 25)}"
        if abs(mpmath.mpf(middle) - value) > mpmath.mpf(radius) + off:
            return wrong(shown)
        most = max(abs(value) * mpmath.mpf(10) ** -15, mpmath.ldexp(1, -899))
        return AGREED if mpmath.mpf(radius) <= most * (1 + mpmath.ldexp(1, -40)) else wrong(f"too wide: {shown}")
