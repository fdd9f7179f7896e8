"""The expansion of Theorem 1, put into the equations of motion in the unscaled variables by exact arithmetic on
polynomials in t and epsilon: every order that it claims must vanish, and what is left stays below the stated bound."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from random import Random

from attack.answers import AGREED, Answer, Attack, worst, wrong
from attack.balls_as_numbers import to_fmpq, to_fraction
from flint import fmpq

from gspot_verified import residual_bounds
from gspot_verified.expansion.trajectory import Trajectory, expand_system
from gspot_verified.testing import extended_example

Polynomial = dict[tuple[int, int], Fraction]
"""Coefficients of t^k epsilon^m, whose weight is 2 k + 3 m."""


def attack(random: Random) -> Attack:
    """The extended example with other numbers, in exact fractions."""
    first = -Fraction(random.randint(1, 24), random.choice((4, 7)))
    beta = Fraction(random.randint(1, 40), random.choice((6, 11))) + Fraction(1, 13)
    second = Fraction(random.choice((-1, 1)) * random.randint(1, 16), random.choice((3, 5)))
    chi, order = Fraction(random.randint(-6, 6), 4), random.randint(3, 14)
    s, delta = Fraction(random.randint(1, 6), 2), Fraction(1, random.choice((5, 20, 100)))
    text = f"expand_system(extended_example({chi}, {(first, second, first * beta)}), {order}); s = {s}, delta = {delta}"
    places = [(s * Fraction(random.randint(-8, 8), 8), delta * Fraction(random.randint(1, 8), 8)) for _ in range(6)]
    return Attack(text, lambda: _judged((first, second, first * beta), chi, order, (s, delta), places))


def _judged(
    alpha: tuple[Fraction, Fraction, Fraction],
    chi: Fraction,
    order: int,
    box: tuple[Fraction, Fraction],
    places: list[tuple[Fraction, Fraction]],
) -> Answer:
    system = extended_example(to_fmpq(chi), (to_fmpq(alpha[0]), to_fmpq(alpha[1]), to_fmpq(alpha[2])))
    found = expand_system(system, order)
    left = residuals(found, alpha, chi)
    bounds = residual_bounds(found, to_fmpq(box[0]), to_fmpq(box[1])).constants
    return worst([_vanishes(name, left[name], scale, order) for name, scale in SCALES.items()] + [
        _bounded(name, left[name], scale, order, float(bounds[name].upper()), places)
        for name, scale in SCALES.items() if name in bounds and bounds[name].is_finite()
    ])  # fmt: skip


SCALES = {"p": 0, "b": 0, "y": 4, "v": 2, "z": 6, "lambda_n": 6}
"""The weight of each equation: that of its left side, d/dt counted as -2; epsilon z' and epsilon^2 lambda as z."""


def residuals(found: Trajectory, alpha: tuple[Fraction, Fraction, Fraction], chi: Fraction) -> dict[str, Polynomial]:
    """Left side less right side of each equation."""
    series = found.in_time()
    own = {name: _fractions(getattr(series, name)) for name in ("p", "b", "y", "v", "z", "lambda_n")}
    p, b, y, v, z, force = own.values()
    one = {(0, 0): Fraction(1)}
    return {
        "p": _sum((1, _rate(p)), (-alpha[0], one), (-chi, b)),
        "b": _sum((1, _rate(b)), (-alpha[1], one), (alpha[2], force)),
        "y": _sum((1, _rate(y)), (-1, v)),
        "v": _sum((1, _rate(v)), (-1, b), (-1, _product(p, force))),
        # epsilon z' = -z - epsilon^2 lambda, epsilon^2 lambda = z - y: divided by epsilon as the first is scaled.
        "z": _sum((1, _shifted(_rate(z), 1)), (1, z), (1, _shifted(force, 2))),
        "lambda_n": _sum((1, _shifted(force, 2)), (-1, z), (1, y)),
    }


def _fractions(table: Mapping[tuple[int, int], object]) -> Polynomial:
    return {key: to_fraction(fmpq(value)) for key, value in table.items()}


def _sum(*parts: tuple[Fraction | int, Polynomial]) -> Polynomial:
    found: Polynomial = {}
    for factor, part in parts:
        for key, value in part.items():
            found[key] = found.get(key, Fraction(0)) + factor * value
    return {key: value for key, value in found.items() if value}


def _rate(part: Polynomial) -> Polynomial:
    return {(k - 1, m): k * value for (k, m), value in part.items() if k}


def _shifted(part: Polynomial, power: int) -> Polynomial:
    return {(k, m + power): value for (k, m), value in part.items()}


def _product(left: Polynomial, right: Polynomial) -> Polynomial:
    found: Polynomial = {}
    for (k, m), value in left.items():
        for (i, j), other in right.items():
            found[k + i, m + j] = found.get((k + i, m + j), Fraction(0)) + value * other
    return found


def _weight(key: tuple[int, int]) -> int:
    return 2 * key[0] + 3 * key[1]


def _vanishes(name: str, left: Polynomial, scale: int, order: int) -> Answer:
    early = {key: value for key, value in left.items() if _weight(key) < order + scale}
    return wrong(f"equation {name}: {early} is left below the order {order}") if early else AGREED


def _bounded(
    name: str, left: Polynomial, scale: int, order: int, bound: float, places: list[tuple[Fraction, Fraction]]
) -> Answer:
    """|residual| / delta^scale <= K delta^order at some places; t = delta^2 s, epsilon = delta^3."""
    for s, delta in places:
        value = sum((c * s**k * delta ** _weight((k, m)) for (k, m), c in left.items()), Fraction(0)) / delta**scale
        if abs(value) > Fraction(bound) * delta**order * (1 + Fraction(1, 10**12)):
            return wrong(
                f"equation {name} at s = {s}, delta = {delta}: {float(value)}, the bound is {bound} delta^{order}"
            )
    return AGREED
