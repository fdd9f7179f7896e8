"""How far a value is from the nearest limit of arithmetic: the products that the series needs, or memory traffic.

The limit of a sum by binary splitting of N terms to b bits is about its products alone (an estimate, no bound): three
of b bits on each of the log2 N levels of the tree (numerators, denominators, and the sums count for one each), for each
chain; Gamma, powers and what rounds the tree come on top. For arrays of doubles it is the traffic: 8 bytes in, 16 out.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import partial

import numpy as np
from flint import fmpq, fmpz

from gspot_verified.cost.times.cases import asked
from gspot_verified.cost.times.measure import Contestant, clear_caches, measure
from gspot_verified.cost.times.rows import Row, Target, seconds_text
from gspot_verified.numbers.balls import approximate, bits_for_digits
from gspot_verified.theta_function.arrays.arrays import theta_of_floats
from gspot_verified.theta_function.theta import theta
from gspot_verified.theta_function.value import choice

_PRODUCTS_OF_A_LEVEL = 3  # binary splitting of one chain: P, Q and T
_SPLITTING = Target("time / its products", 20.0)
_TRAFFIC = Target("time / memory traffic", 200.0)
_BYTES_OF_A_VALUE = 24  # one double is read, middle and radius are written


def many_digits(digits: tuple[int, ...] = (10_000, 100_000)) -> Iterator[Row]:
    """One value by each of the three series that are summed by splitting, against the products of the series."""
    for count in digits:
        for tau in (fmpq(-50), fmpq(-(10**6)), fmpq(10**6)):
            beta = fmpq(1, 2)
            number, product = products_of_the_series(tau, beta, count)
            times = measure({
                "product": Contestant(product, None, 9),
                "cold": Contestant(partial(theta, tau, beta, 0, count), clear_caches, 5),
            }, 1.0)  # fmt: skip
            limit = number * times["product"].best
            note = f"limit: {number:.0f} products of {seconds_text(times['product'].best)}"
            figure = times["cold"].best / limit
            yield Row(
                "limit", asked(tau, beta, count), _SPLITTING, figure, times["cold"].best, baseline=limit, note=note
            )


def products_of_the_series(tau: fmpq, beta: fmpq, digits: int) -> tuple[float, Callable[[], fmpz]]:
    """About how many products of that size the series needs, and a call that does one of them."""
    factor = fmpz(3) ** int(bits_for_digits(digits) / math.log2(3))
    other = factor + 2  # not a square
    return _PRODUCTS_OF_A_LEVEL * _chains_times_levels(tau, beta, digits), lambda: factor * other


def _chains_times_levels(tau: fmpq, beta: fmpq, digits: int) -> float:
    goal, point, parameter = bits_for_digits(digits), approximate(tau), approximate(beta)
    enveloping = choice.negative_plan(-point, parameter, goal) if point < 0 else None
    if enveloping is not None:
        return math.log2(enveloping.terms)
    saddle = choice.saddle_plan(point, parameter, goal) if point > 0 else None
    if saddle is not None:
        return 4 * math.log2(saddle.terms)  # matrices of two rows and columns: four entries
    return 3 * math.log2(choice.taylor_plan(point, parameter, goal).length / 3)


def memory_traffic(points: int = 1_000_000) -> Iterator[Row]:
    """An array of doubles, when its panels are there, against reading and writing the memory that it needs."""
    source = np.random.default_rng(1).uniform(-2.0, 2.0, points)
    theta_of_floats(source[:1_000], "7/3")
    times = measure({
        "copy": Contestant(source.copy, None, 9),
        "warm": Contestant(partial(theta_of_floats, source, "7/3"), None, 3),
    }, 2.0)  # fmt: skip
    limit = times["copy"].best * _BYTES_OF_A_VALUE / 16
    figure = times["warm"].best / limit
    words, note = f"{points} τ in [-2, 2] β=7/3", "limit: 8 bytes read and 16 written for each value"
    yield Row("limit", words, _TRAFFIC, figure, warm=times["warm"].best, baseline=limit, note=note)
