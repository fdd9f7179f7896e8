"""The expansion of Theorem 1 at the G-spots of random bodies, whose functions are no polynomials: put into Lagrange's
equations at two small delta, what is left of each must fall as fast as the order says."""

from __future__ import annotations

from fractions import Fraction
from random import Random

import mpmath
from attack.answers import AGREED, Answer, Attack, undecided, wrong
from attack.balls_as_numbers import exactly, to_fraction
from attack.mechanisms import body, drawn_body, file_of
from attack.reference_expansion import DIGITS, Equations, Table
from flint import arb, fmpq

from gspot_verified.expansion.series.system import GSpotError
from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.mechanisms.input.file import parse_mechanism
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.spots.all_g_spots import find_g_spots

_BITS = 900
_STEPS = (mpmath.mpf(1) / 2**32, mpmath.mpf(1) / 2**33)


def attack(random: Random) -> Attack:
    """One spot of a random body."""
    values, slip = drawn_body(random)
    if random.random() < 0.7:
        values["mu"] += 1
    values["mu"] = random.choice(("{}", "{}", "{}*exp(sin(th)/9)", "{}/sqrt(1 + cos(th)^2/9)")).format(values["mu"])
    order, s = random.randint(2, 10), random.choice((-2, -1, 0.5, 1, 3))
    text = file_of(values, slip)

    def ask() -> Answer:
        try:
            spots = find_g_spots(parse_mechanism(text), bits=_BITS, budget=4000).spots
        except MechanismError as error:
            return undecided(f"{type(error).__name__}: {str(error)[:40]}")
        for spot in spots:
            try:
                found = expand_system(spot.system, order, 190)
            except GSpotError:
                continue
            series = found.in_time()
            tables = {name: _numbers(getattr(series, name)) for name in ("p", "b", "y", "v", "z", "lambda_n")}
            point = [_number(each) for each in spot.system.point]
            equations, xi = Equations(body(values)), [_numbers(table) for table in series.xi]
            coarse, fine = (equations.left(point, xi, tables, s, delta) for delta in _STEPS)
            return judged(coarse, fine, order)
        return undecided("no spot with an expansion")

    return Attack(f"expand_system at the first G-spot of '''{text}''', {order} orders, s = {s}", ask)


def _number(value: fmpq | arb) -> mpmath.mpf:
    with mpmath.workdps(DIGITS):
        if isinstance(value, fmpq):
            exact: Fraction = to_fraction(value)
            return mpmath.mpf(exact.numerator) / exact.denominator
        return +exactly(value.mid())


def _numbers(table: dict[tuple[int, int], fmpq | arb]) -> Table:
    return {key: _number(value) for key, value in table.items()}


def judged(coarse: dict[str, mpmath.mpf], fine: dict[str, mpmath.mpf], order: int) -> Answer:
    """Halving delta divides what is left by 2^order at least, where it is not rounding already."""
    for name, left in coarse.items():
        if fine[name] < mpmath.mpf(10) ** -170:
            continue
        fall = mpmath.log(left / fine[name], 2)
        if fall < order - 0.01:
            return wrong(f"equation {name}: {mpmath.nstr(left, 5)}, then {mpmath.nstr(fine[name], 5)}: "
                         f"falls by 2^{mpmath.nstr(fall, 4)}, not 2^{order}")  # fmt: skip
    return AGREED
