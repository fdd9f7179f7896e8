"""Series at a point, carried along tau: they contain Theta and its derivatives, and the rest is the one of the page.

Witnesses: ``evaluate`` (other routes) and the re-centred models of ``box.py``. Page: proofs/carried_series.md.
"""

from __future__ import annotations

import math
import random
from fractions import Fraction
from itertools import product

import pytest
from flint import arb, arb_poly, fmpq
from samples.strategies import ends, to_fmpq, to_fraction

from gspot_verified.numbers.balls import working_bits
from gspot_verified.theta_function.boxes.box import taylor_model
from gspot_verified.theta_function.boxes.box_choice import bits_for_box, length_for_box
from gspot_verified.theta_function.boxes.carried import CarriedTheta
from gspot_verified.theta_function.boxes.carried_series import (
    ParameterRange,
    coefficients,
    enclosure,
    folded,
    initial_polynomials,
    local_series,
    range_of,
    table,
    values_at,
)
from gspot_verified.theta_function.boxes.parameter_series import parameter_series
from gspot_verified.theta_function.value.evaluate import evaluate


def truth(tau: fmpq, b: fmpq, derivative: int = 0, digits: int = 150) -> tuple[Fraction, Fraction]:
    """Both ends of an accurate enclosure of the derivative that comes from another route."""
    return ends(evaluate(tau, b, derivative, digits).value)


def covers(value: arb, inside: tuple[Fraction, Fraction], factor: Fraction = Fraction(1)) -> bool:
    """Whether a finite ball holds ``factor`` > 0 times an interval."""
    assert value.is_finite()
    lower, upper = ends(value)
    return lower <= factor * inside[0] and factor * inside[1] <= upper


def carried(centre: fmpq, radius: fmpq, reach: fmpq) -> CarriedTheta:
    return CarriedTheta(centre, radius, reach, 40)


@pytest.mark.parametrize("radius", [fmpq(0), fmpq(1, 10**30), fmpq(1, 16), fmpq(1, 2)])
@pytest.mark.parametrize("centre", [fmpq(9), fmpq(-5, 2), fmpq(31, 3), fmpq(41, 2)])
def test_values_contain_theta_and_two_derivatives(centre: fmpq, radius: fmpq) -> None:
    theta = carried(centre, radius, fmpq(12))
    for tau in (fmpq(0), fmpq(1, 2), fmpq(-1, 3), fmpq(7, 5), fmpq(-7), fmpq(12)):
        values = theta.values(tau)
        for eta, (d, value) in product((fmpq(-1), fmpq(1, 3), fmpq(1)), enumerate(values)):
            with working_bits(theta.bits):
                found = value(arb(eta))
            inside = truth(tau, centre + radius * eta, d)
            assert covers(found, inside, Fraction(1, math.factorial(d)))
            if not radius:  # and it is accurate
                assert to_fraction_of_radius(found) <= Fraction(1, 10**6) * max(abs(end) for end in inside)


def to_fraction_of_radius(value: arb) -> Fraction:
    lower, upper = ends(value)
    return (upper - lower) / 2


@pytest.mark.parametrize("derivative", [0, 1, 2])
@pytest.mark.parametrize(("centre", "radius"), [(fmpq(5, 2), fmpq(1, 8)), (fmpq(10), fmpq(1, 64)), (fmpq(22, 7), 0)])
def test_boxes_against_points_and_against_the_recentred_model(centre: fmpq, radius: fmpq, derivative: int) -> None:
    """Two routes to one box: they overlap, and both hold the values at its corners."""
    radius = fmpq(radius)
    theta = carried(centre, radius, fmpq(6))
    bits = bits_for_box(7.0, 11.0)
    series = parameter_series(centre, radius, 24 if radius else 1, length_for_box(7.0, 11.0, bits), bits)
    for lower, upper in ((fmpq(-5), fmpq(-9, 2)), (fmpq(-1, 4), fmpq(1, 3)), (fmpq(5), fmpq(11, 2))):
        middle, half = (lower + upper) / 2, (upper - lower) / 2
        with working_bits(theta.bits):
            ranges = [range_of(a) for a in local_series(theta.values(middle), theta.range_of_b, middle, half, 30)]
            found = enclosure(ranges, derivative)
            factor = arb(half) ** derivative / math.factorial(derivative)
            other = taylor_model(series, lower, upper, 30, derivative).enclosure() * factor
            assert found.is_finite()
            assert other.is_finite()
            assert found.overlaps(other)
            assert found.rad() <= 2 * other.rad()
        scale = to_fraction(half) ** derivative / math.factorial(derivative)
        for tau, eta in product((lower, middle, upper), (-1, 0, 1)):
            assert covers(found, truth(tau, centre + radius * eta, derivative), scale)


@pytest.mark.parametrize("seed", range(3))
def test_series_of_any_parameters_contain_theta(seed: int) -> None:
    """Lengths, degrees and bits that no heuristic would take: finite or not, never wrong."""
    draw = random.Random(seed)
    finite = 0
    for _ in range(40):
        centre = draw.choice([fmpq(draw.randint(-6, 12)), fmpq(draw.randint(-90, 120), 13)])
        radius = draw.choice([fmpq(0), fmpq(1, 10**30), fmpq(draw.randint(0, 8), 8)])
        degree = draw.choice([1, 2, 5, 12]) if radius else 1
        b, scale = ParameterRange(centre, radius, degree), fmpq(draw.randint(1, 12), 8)
        bits, length = draw.choice([5, 30, 200]), draw.choice([5, 6, 9, 20, 40])
        point, u = fmpq(draw.randint(-3, 3), 8), fmpq(draw.randint(-8, 8), 8)
        with working_bits(bits):
            # Twice: what the first series leaves out is carried by the second.
            start = initial_polynomials(b, bits)
            if point:
                start = values_at(
                    table(local_series(start, b, fmpq(0), fmpq(1, 2), length), degree), fmpq(1, 2), 2 * point
                )
            values = values_at(table(local_series(start, b, point, scale, length), degree), scale, u)
            eta = fmpq(draw.randint(-4, 4), 4)
            found = [value(arb(eta)) for value in values]
        for d, value in enumerate(found):
            if value.is_finite():
                finite += 1
                inside = truth(point + scale * u, centre + radius * eta, d)
                assert covers(value, inside, Fraction(1, math.factorial(d)))
    assert finite > 60


@pytest.mark.parametrize("tau", [fmpq(0), fmpq(1, 3), fmpq(5)])
@pytest.mark.parametrize(
    ("centre", "radius"), [(fmpq(9), fmpq(0)), (fmpq(31, 3), fmpq(1, 64)), (fmpq(-5, 2), fmpq(1, 2))]
)
def test_coefficients_are_the_derivatives(tau: fmpq, centre: fmpq, radius: fmpq) -> None:
    """c_k = (d/dtau)^k Theta/k! for every b of the range, k up to 60."""
    theta = CarriedTheta(centre, radius, fmpq(6), 120)
    with working_bits(theta.bits):
        found = [range_of(c) for c in coefficients(theta.values(tau), theta.range_of_b, tau, fmpq(1), 61)]
    assert len(found) == 61
    for k, eta in product((0, 1, 2, 3, 7, 30, 60), (fmpq(-1), fmpq(1, 3), fmpq(1))):
        assert covers(found[k], truth(tau, centre + radius * eta, k), Fraction(1, math.factorial(k)))


def _rest_of_the_page(a: list[Fraction], point: Fraction, s: Fraction, size: Fraction) -> Fraction | None:
    """e of section 3 by the page's own formula, or None where q > 1/2."""
    i = len(a) - 5
    b = max(Fraction(1), size + 2)
    q = abs(point) * s**2 / ((i + 2) * (i + 3)) + (i + b) * s**3 / ((i + 1) * (i + 2) * (i + 3))
    return 3 * max(map(abs, a[-3:])) if q <= Fraction(1, 2) else None


@pytest.mark.parametrize("centre", [Fraction(0), Fraction(5, 2), Fraction(-7, 3), Fraction(20)])
@pytest.mark.parametrize("point", [Fraction(0), Fraction(3), Fraction(-11, 2)])
def test_the_rest_is_the_one_of_the_page(centre: Fraction, point: Fraction) -> None:
    seen = {True: 0, False: 0}
    for length, s in product((5, 6, 8, 12, 20), (Fraction(1, 4), Fraction(1), Fraction(2), Fraction(4))):
        exact = [Fraction(1), Fraction(-2) * s, Fraction(1, 2) * s**2]
        for k in range(length - 3):
            term = point * s**2 * (k + 1) * exact[k + 1] + s**3 * (k - centre) * exact[k]
            exact.append(term / ((k + 1) * (k + 2) * (k + 3)))
        rest = _rest_of_the_page(exact, point, s, abs(centre))
        seen[rest is None] += 1
        with working_bits(200):
            start = [arb_poly([arb(1)]), arb_poly([arb(-2)]), arb_poly([arb(fmpq(1, 2))])]
            b = ParameterRange(to_fmpq(centre), fmpq(0), 1)
            last = range_of(local_series(start, b, to_fmpq(point), to_fmpq(s), length)[-1])
        assert last.is_finite() == (rest is not None)
        if rest is not None:
            lower, upper = ends(last)
            assert rest <= (upper - lower) / 2 <= rest * (1 + Fraction(1, 10**6)) + Fraction(1, 10**50)
            assert abs((upper + lower) / 2 - exact[-1]) <= Fraction(1, 10**40) * (1 + rest)
    assert min(seen.values()) > 1


def test_folding_keeps_the_values() -> None:
    draw = random.Random(5)
    for _ in range(60):
        numbers = [Fraction(draw.randint(-99, 99), 16) for _ in range(draw.randint(1, 9))]
        degree = draw.randint(1, 9)
        short = folded(arb_poly([arb(to_fmpq(value)) for value in numbers]), degree)
        assert short.length() <= max(degree, 1)
        for eta in (Fraction(-1), Fraction(-3, 8), Fraction(0), Fraction(5, 8), Fraction(1)):
            value = sum(number * eta**j for j, number in enumerate(numbers))
            lower, upper = ends(short(arb(to_fmpq(eta))))
            assert lower <= value <= upper


def test_bad_arguments() -> None:
    b = ParameterRange(fmpq(1, 2), fmpq(0), 1)
    start = [arb_poly([arb(1)])] * 3
    with pytest.raises(ValueError, match="length"):
        local_series(start, b, fmpq(0), fmpq(1), 4)
    for scale in (fmpq(0), fmpq(-1)):
        with pytest.raises(ValueError, match="scale"):
            local_series(start, b, fmpq(0), scale, 9)
    series = table(local_series(start, b, fmpq(0), fmpq(1), 9), 1)
    for u in (fmpq(-9, 8), fmpq(2)):
        with pytest.raises(ValueError, match="u must lie"):
            values_at(series, fmpq(1), u)
