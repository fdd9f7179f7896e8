"""Models over rectangles against values at points; bounds for complex b against complex values; interpolation.

Page: proofs/finite_epsilon_zeros.md.
"""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import to_fmpq

from gspot_verified.compliant.patches.interpolation import node_product, nodes, substitution
from gspot_verified.compliant.patches.slow_majorant import ComplexNeighbourhood, epsilon_difference, slow_majorant
from gspot_verified.compliant.patches.slow_patch import SlowPatch, rational_scale
from gspot_verified.compliant.slow.slow_jet import slow_jet
from gspot_verified.numbers.balls import working_bits

PATCHES = {
    "small": (fmpq(4), fmpq(9, 2), fmpq(0), fmpq(1, 1000)),
    "large": (fmpq(39, 8), fmpq(5), fmpq(6), fmpq(7)),
    "point": (fmpq(5), fmpq(41, 8), fmpq(1, 3), fmpq(1, 3)),
}
FRACTION = st.fractions(0, 1, max_denominator=16)


@pytest.fixture(scope="module", params=PATCHES.values(), ids=PATCHES.keys())
def patch(request: pytest.FixtureRequest) -> tuple[SlowPatch, tuple[fmpq, ...]]:
    return SlowPatch(*request.param), request.param


@given(st.integers(-4, 8), FRACTION, FRACTION, FRACTION)
@settings(max_examples=15)
def test_a_model_holds_all_its_values(
    patch: tuple[SlowPatch, tuple[fmpq, ...]], half: int, first: Fraction, second: Fraction, third: Fraction
) -> None:
    model, (b_lower, b_upper, low, high) = patch
    b, epsilon = b_lower + to_fmpq(first) * (b_upper - b_lower), low + to_fmpq(second) * (high - low)
    if epsilon == 0:
        return
    tau = (half + to_fmpq(third)) / 4
    end = min(b + fmpq(1, 64), b_upper)
    values = slow_jet(tau, b, epsilon, 3, 80)
    narrow = model.signs(b, end).coefficients(tau, tau, 3)
    whole = model.signs(b_lower, b_upper).coefficients(tau, tau, 3)
    for value, near, far in zip(values, narrow, whole, strict=True):
        assert near.is_finite()
        assert far.is_finite()
        assert near.overlaps(value)
        assert far.contains(value.mid())
    # dG/db by a central difference, whose error is about G'''/6 times the squared step.
    step = fmpq(1, 2**14)
    inside = min(max(b, b_lower + step), b_upper - step)
    before, after = (slow_jet(tau, inside + side * step, epsilon, 1, 120)[0] for side in (-1, 1))
    slope = model.slopes(inside, inside).coefficients(tau, tau, 1)[0]
    assert slope.rad() < 1 + abs(values[0])
    assert abs(slope.mid() - (after - before) / (2 * step)) < (1 + abs(values[0])) * fmpq(1, 100) + slope.rad()


def complex_values(z: complex, tau: float, eta: float) -> list[mpmath.mpc]:
    """c_0, c_1, c_2 at a complex z: the same recurrence and integral, in mpmath."""

    def moment(s: mpmath.mpc) -> mpmath.mpc:
        def integrand(rho: mpmath.mpf) -> mpmath.mpc:
            x = eta * rho
            cubic = (x - x**2 / 2 - x**3 / 3 - mpmath.log1p(x)) / (2 * mpmath.mpf(eta) ** 3)
            return rho ** (-s - 1) * mpmath.exp(cubic + rho * tau)

        return mpmath.quad(integrand, [0, 0.5, 1, 2, 4, 8, 16]) * mpmath.rgamma(-s)

    steps = math.ceil(z.real) + 2
    found = [moment(mpmath.mpc(z) - steps - i) for i in range(4)]
    for i in range(steps - 1, -1, -1):
        c = mpmath.mpc(z) - i
        following = (
            -tau * found[0] + (c - 1) * (c - 2) * found[2]
            + eta * (c - 1) * (tau * found[1] + found[0] - (c - 2) * (c - 3) / 2 * found[3])
        )  # fmt: skip
        found = [following, *found[:3]]
    return [found[k] * mpmath.rf(-z, k) / mpmath.factorial(k) for k in range(3)]


@pytest.mark.parametrize("tau", [-2, 0, 3])
@pytest.mark.parametrize("eta", [0.1, 1.5])
def test_the_bound_for_complex_b(tau: int, eta: float) -> None:
    """On half of a circle around the interval: the values at conjugate places are conjugate."""
    region = ComplexNeighbourhood(
        fmpq(4), fmpq(9, 2), fmpq(2), fmpq(Fraction(eta).numerator, Fraction(eta).denominator), fmpq(tau)
    )
    bounds = [float(bound.mid()) for bound in slow_majorant(region, 3)]
    assert all(math.isfinite(bound) for bound in bounds)
    for angle in range(0, 181, 45):
        place = 4.25 + 2.2 * complex(math.cos(math.radians(angle)), math.sin(math.radians(angle)))
        with mpmath.workdps(20):
            values = complex_values(place, tau, eta)
        for value, bound in zip(values, bounds, strict=True):
            assert abs(value) < bound


def test_the_bound_needs_its_hypotheses() -> None:
    assert not slow_majorant(ComplexNeighbourhood(fmpq(1), fmpq(2), fmpq(2), fmpq(1), fmpq(0)), 1)[0].is_finite()
    assert not epsilon_difference(ComplexNeighbourhood(fmpq(4), fmpq(5), fmpq(0), fmpq(1), fmpq(0)), 2, 1)[
        0
    ].is_finite()
    assert epsilon_difference(ComplexNeighbourhood(fmpq(4), fmpq(5), fmpq(0), fmpq(1), fmpq(0)), 4, 1)[0].is_finite()


@pytest.mark.parametrize("terms", [3, 4, 6])
@pytest.mark.parametrize("tau", [-2, 1, 5])
def test_differences_in_eta_are_bounded(terms: int, tau: int) -> None:
    """A divided difference at terms + 1 points of (0, eta] is one value of the derivative over its factorial."""
    places = [fmpq(3, 10) * (i + 1) / (terms + 1) for i in range(terms + 1)]
    bounds = epsilon_difference(ComplexNeighbourhood(fmpq(9, 2), fmpq(9, 2), fmpq(0), places[-1], fmpq(tau)), terms, 3)
    table = [slow_jet(fmpq(tau), fmpq(9, 2), 2 * eta**3, 3, 200) for eta in places]
    for k, bound in enumerate(bounds):
        level = [row[k] for row in table]
        for order in range(1, terms + 1):
            level = [(b - a) / (places[i + order] - places[i]) for i, (a, b) in enumerate(pairwise(level))]
        assert level[0].is_finite()
        assert abs(level[0]) < bound


@given(st.integers(1, 18), st.lists(st.integers(-9, 9), min_size=1, max_size=18), FRACTION, FRACTION)
def test_interpolation_is_exact_for_polynomials(
    count: int, given_: list[int], middle: Fraction, radius: Fraction
) -> None:
    powers = given_[:count] + [0] * (count - len(given_))
    found = nodes(count)

    def value(x: fmpq) -> fmpq:
        return sum((c * x**i for i, c in enumerate(powers)), fmpq(0))

    back = [sum((found.to_powers[i, j] * value(x) for j, x in enumerate(found.places)), fmpq(0)) for i in range(count)]
    assert back == powers
    matrix = substitution(count, to_fmpq(middle), to_fmpq(radius))
    moved = [sum((matrix[j, i] * powers[i] for i in range(count)), fmpq(0)) for j in range(count)]
    s = fmpq(3, 7)
    assert sum((c * s**i for i, c in enumerate(moved)), fmpq(0)) == value(to_fmpq(middle) + to_fmpq(radius) * s)


@pytest.mark.parametrize("count", [1, 2, 6, 10, 18])
def test_node_bounds(count: int) -> None:
    found, distance = nodes(count), fmpq(1, 4)
    for i in range(-40, 41):
        x = fmpq(i, 40)
        assert math.prod((abs(x - place) for place in found.places), start=fmpq(1)) <= node_product(count, fmpq(0))
        z = complex(i / 40, 0.25)
        assert math.prod(abs(z - float(arb(place).mid())) for place in found.places) <= float(
            node_product(count, distance).mid()
        )
        lagrange = [sum(found.to_powers[k, j] * x**k for k in range(count)) for j in range(count)]
        assert sum(abs(value) for value in lagrange) <= found.lebesgue


@pytest.mark.parametrize(
    "epsilon",
    [fmpq(10) ** -400, fmpq(10) ** -320, fmpq(10) ** -300, fmpq(1, 10**6), fmpq(1, 7), fmpq(2), fmpq(10), fmpq(100)],
)
def test_the_cube_root_is_enclosed(epsilon: fmpq) -> None:
    low, high = rational_scale(epsilon, -1), rational_scale(epsilon, 1)
    assert low > 0
    assert 2 * low**3 <= epsilon <= 2 * high**3
    assert high / low < 1 + fmpq(1, 10**6)


@pytest.mark.parametrize("name", PATCHES)
def test_the_remainders_are_those_of_the_page(name: str) -> None:
    """Sum |L_j| prod |z - b_i| S/R^M + prod |eta - eta_j| D_N, each term where there is such a range."""
    b_lower, b_upper, low, high = PATCHES[name]
    model, k, radius = SlowPatch(b_lower, b_upper, low, high), 1, (b_upper - b_lower) / 2
    eta, least = rational_scale(high, 1), rational_scale(low, -1)
    points = {fmpq(1, 2): 14, fmpq(1, 8): 10}[b_upper - b_lower]
    in_eta = 1 if low == high else max(6, math.ceil(Fraction(int(b_upper.p), int(b_upper.q))) - 1)
    orders = model.order + 1
    for distance in (fmpq(0), fmpq(1, 32)):
        near = ComplexNeighbourhood(b_lower, b_upper, distance, eta, (k + fmpq(1, 2)) * fmpq(1, 2))
        with working_bits(120):
            weight = node_product(points, distance / radius) * (radius / 2) ** points * nodes(in_eta).lebesgue
            pages = [weight * bound for bound in slow_majorant(replace(near, distance=distance + 2), orders)]
            if low < high:
                factor = node_product(in_eta, fmpq(0)) * ((eta - least) / 2) ** in_eta
                differences = epsilon_difference(near, in_eta, orders)
                pages = [page + factor * more for page, more in zip(pages, differences, strict=True)]
            found = model._rests(k, distance)
            assert len(found) == len(pages) == orders
            assert all(page.is_finite() and page > 0 for page in pages)
            assert all(abs(rest / page - 1) < fmpq(1, 2**25) for rest, page in zip(found, pages, strict=True))


def test_the_last_row_of_the_slopes_bounds_the_slope_of_the_last_coefficient() -> None:
    """By a difference of jets at both ends of the range of b, for some b between them; and by the page, S/r."""
    b_lower, b_upper, low, high = PATCHES["large"]
    model, k = SlowPatch(b_lower, b_upper, low, high), 2
    last = model._expansion(b_lower, b_upper, True, k).tolist()[-1]
    assert all(entry.is_zero() for entry in last[1:])
    first, second = (slow_jet(fmpq(5, 4), b, fmpq(13, 2), model.order + 1, 80)[-1] for b in (b_lower, b_upper))
    assert abs((second - first) / (b_upper - b_lower)) < last[0]
    near = ComplexNeighbourhood(b_lower, b_upper, fmpq(1, 32), rational_scale(high, 1), fmpq(5, 4))
    assert abs(last[0] / (32 * slow_majorant(near, model.order + 1)[-1]) - 1) < fmpq(1, 2**25)


def test_at_one_b_there_is_no_slope() -> None:
    """The model does not change with b there: it says nothing about dG/db, which is 36.3 here."""
    model = SlowPatch(fmpq(5), fmpq(5), fmpq(1), fmpq(1))
    step = fmpq(1, 1000)
    after, before = (slow_jet(fmpq(1), b, fmpq(1), 1, 100)[0] for b in (5 + step, 5 - step))
    assert (after - before) / (2 * step) > 36
    with pytest.raises(ValueError, match="one b"):
        model.slopes(fmpq(5), fmpq(5))


def test_beyond_the_patch_nothing_is_known() -> None:
    model = SlowPatch(fmpq(4), fmpq(9, 2), fmpq(1), fmpq(1))
    for lower, upper in ((fmpq(4), fmpq(5)), (fmpq(3), fmpq(4)), (fmpq(9, 2), fmpq(4))):
        for part in (model.signs, model.slopes):
            with pytest.raises(ValueError, match="in the patch"):
                part(lower, upper)
