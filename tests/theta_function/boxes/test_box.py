"""Taylor models on boxes: they contain Theta, at complex b too, and each remainder is the one of the page.

Witnesses: ``evaluate`` (other routes, no parameter series) and mpmath's 1F2 at complex b. Every containment is decided
after finiteness; where a model may be not finite, the tests count that enough of them are.

Page: proofs/box.md.
"""

from __future__ import annotations

import math
import random
from fractions import Fraction
from itertools import pairwise, product

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mpc, mpf
from samples.strategies import ends, to_fmpq, to_fraction

from gspot_verified.numbers.balls import approximate, current_bits, working_bits
from gspot_verified.theta_function.boxes.box import TaylorModel, omitted_terms, taylor_model
from gspot_verified.theta_function.boxes.box_choice import bits_for_box, degree_for_box, length_for_box, order_for_box
from gspot_verified.theta_function.boxes.parameter_series import ParameterSeries, parameter_series
from gspot_verified.theta_function.value.evaluate import evaluate

_BITS = 500
_SHARES = st.sampled_from([Fraction(n, 4) for n in (-4, -4, -3, -1, 0, 2, 4, 4)])


def _m(value: Fraction | fmpq) -> mpf:
    number = to_fraction(value) if isinstance(value, fmpq) else value
    return mpf(number.numerator) / number.denominator


def _middle(value: arb) -> mpf:
    lower, upper = ends(value)
    return _m((lower + upper) / 2)


def _upper(value: arb) -> mpf:
    return _m(ends(value)[1])


def truth(tau: fmpq, b: fmpq, derivative: int = 0, digits: int = 60) -> tuple[Fraction, Fraction]:
    """Both ends of an accurate enclosure that comes from another route."""
    return ends(evaluate(tau, b, derivative, digits).value)


def covers(value: arb, inside: tuple[Fraction, Fraction]) -> bool:
    lower, upper = ends(value)
    return lower <= inside[0] and inside[1] <= upper


def consistent(value: arb, inside: tuple[Fraction, Fraction]) -> bool:
    lower, upper = ends(value)
    return lower <= inside[1] and inside[0] <= upper


def good_series(centre: fmpq, radius: fmpq, reach: fmpq) -> ParameterSeries:
    """A series that the heuristics find good for |tau| <= reach."""
    size, far = approximate(abs(centre) + radius), approximate(reach)
    bits = bits_for_box(far, size)
    degree = degree_for_box(far, size, approximate(radius))
    return parameter_series(centre, radius, degree, length_for_box(far + 1, size, bits), bits)


def good_order(lower: fmpq, upper: fmpq, series: ParameterSeries) -> int:
    size = approximate(abs(series.centre) + series.radius)
    return order_for_box(approximate((lower + upper) / 2), approximate((upper - lower) / 2), size)


def theta_complex(tau: mpf, b: mpc, derivative: int = 0) -> mpc:
    """The d-th tau-derivative at complex b: (-1)^d b (b-1) .. (b-d+1) Theta(tau, b - d), by three 1F2."""
    factor = mpmath.fprod(-(b - i) for i in range(derivative))
    b = b - derivative
    third = mpf(1) / 3
    front = 2 * mpmath.pi * mpmath.power(3, 2 * b / 3 - mpf(1) / 2)
    g = [mpmath.rgamma((j - b) / 3) for j in range(3)]
    z = tau**3 / 9
    return (
        factor * front * (
            g[1] * g[2] * mpmath.hyp1f2(-b / 3, third, 2 * third, z)
            + mpmath.cbrt(3) * g[0] * g[2] * tau * mpmath.hyp1f2((1 - b) / 3, 2 * third, 4 * third, z)
            + mpmath.cbrt(9) * g[0] * g[1] * tau**2 / 2 * mpmath.hyp1f2((2 - b) / 3, 4 * third, 5 * third, z)
        )
    )  # fmt: skip


_CENTRES = st.one_of(
    st.integers(-6, 9).map(Fraction),
    st.builds(Fraction, st.integers(-40, 50), st.integers(1, 7)),
    st.integers(-3, 6).map(lambda n: n - Fraction(1, 10**20)),
)
_RADII = st.sampled_from([Fraction(0), Fraction(1, 10**30), Fraction(1, 16), Fraction(1, 2), Fraction(2), Fraction(3)])
_HALF_WIDTHS = st.sampled_from([Fraction(0), Fraction(1, 10**15), Fraction(1, 16), Fraction(1, 2), Fraction(2)])
_TAU0S = st.one_of(st.just(Fraction(0)), st.builds(Fraction, st.integers(-40, 40), st.sampled_from((5, 8))))


@given(_CENTRES, _RADII, _TAU0S, _HALF_WIDTHS, st.sampled_from((0, 1, 2)), _SHARES, _SHARES)
def test_good_models_contain_theta(
    centre: Fraction, radius: Fraction, tau0: Fraction, half: Fraction, derivative: int, u: Fraction, eta: Fraction
) -> None:
    series = good_series(to_fmpq(centre), to_fmpq(radius), to_fmpq(abs(tau0) + half + 1))
    lower, upper = to_fmpq(tau0 - half), to_fmpq(tau0 + half)
    model = taylor_model(series, lower, upper, good_order(lower, upper, series), derivative)
    assert model.remainder.is_finite()
    tau, b = to_fmpq(tau0 + half * u), to_fmpq(centre + radius * eta)
    inside = truth(tau, b, derivative, 80)
    assert covers(model.enclosure(), inside)
    assert covers(model.value(tau, b), inside)


@pytest.mark.parametrize("seed", range(4))
def test_models_of_any_parameters_contain_theta(seed: int) -> None:
    """Lengths, degrees, orders and bits that no heuristic would take: finite or not, never wrong."""
    draw = random.Random(seed)
    finite = 0
    for _ in range(40):
        centre = draw.choice([fmpq(draw.randint(-6, 12)), fmpq(draw.randint(-90, 120), 13), fmpq(-50), fmpq(451, 3)])
        radius = draw.choice([fmpq(0), fmpq(3), fmpq(1, 10**30), fmpq(draw.randint(0, 24), 8)])
        length = draw.choice([20, 90] if abs(centre) > 20 else [3, 4, 5, 9, 20, 60])
        series = parameter_series(centre, radius, draw.choice([1, 2, 5, 12]), length, draw.choice([2, 5, 30, 200]))
        half_width = draw.choice([fmpq(0), fmpq(1, 10**15), fmpq(1, 20), fmpq(1, 2), fmpq(5)])
        tau0, derivative = fmpq(draw.randint(-30, 30), draw.choice([10, 30])), draw.choice([0, 1, 2])
        order = draw.choice([derivative + 1, derivative + 2, 8, 70])
        model = taylor_model(series, tau0 - half_width, tau0 + half_width, order, derivative)
        if not model.enclosure().is_finite():
            continue
        finite += 1
        for u, eta in ((-1, 1), (1, -1), (fmpq(draw.randint(-9, 9), 9), fmpq(draw.randint(-9, 9), 9))):
            tau, b = tau0 + half_width * u, centre + radius * eta
            inside = truth(tau, b, derivative, 80)
            assert covers(model.enclosure(), inside), (series[:5], model.tau0, half_width, derivative, order)
            assert covers(model.value(tau, b), inside), (series[:5], model.tau0, half_width, derivative, order)
    assert finite >= 15


_COMPLEX = [
    *product((fmpq(3), fmpq(-7, 3), fmpq(1, 2)), (fmpq(1, 2), fmpq(3)), (fmpq(0), fmpq(-2), fmpq(3, 2)), (0, 1, 2))
]


@pytest.mark.parametrize(("centre", "radius", "tau0", "derivative"), _COMPLEX)
@pytest.mark.parametrize("order", [3, 9])
def test_the_remainder_holds_for_complex_b(centre: fmpq, radius: fmpq, tau0: fmpq, derivative: int, order: int) -> None:
    """And it is not absurd: divided by 2^(24 + 4 degree) it would be exceeded."""
    degree, half_width = 6, fmpq(1, 4)
    series = parameter_series(centre, radius, degree, 60, _BITS)
    model = taylor_model(series, tau0 - half_width, tau0 + half_width, order, derivative)
    rows = [[_middle(value) for value in row] for row in model.coefficients]
    bound, worst = _upper(model.remainder), mpf(0)
    with mpmath.workdps(60):
        for j, u in product(range(0, 16, 3), (-1, mpf(1) / 3, 1)):
            eta = mpmath.expjpi(mpf(j) / 8) * (1 - mpf(10) ** -50)
            value = theta_complex(_m(tau0) + _m(half_width) * u, _m(centre) + _m(radius) * eta, derivative)
            inside = mpmath.fsum(c * u**i * eta**k for i, row in enumerate(rows) for k, c in enumerate(row))
            worst = max(worst, abs(value - inside) / bound)
    assert mpf(2) ** -(24 + 4 * degree) < worst <= 1


def _page_omitted(series: ParameterSeries, reach: mpf, d: int) -> mpf:
    """V_d of the page, from the bounds S_K, S_(K+1), S_(K+2)."""
    k, b = series.length, max(mpf(1), abs(_m(series.centre)) + _m(series.radius))
    q = (k + b) * reach**3 / ((k + 1 - d) * (k + 2 - d) * (k + 3 - d))
    assert k > d
    assert q < 1
    terms = [
        mpmath.factorial(k + j) / mpmath.factorial(k + j - d) * _upper(series.omitted[j]) * reach ** (k + j - d)
        for j in range(3)
    ]
    return mpmath.fsum(terms) / (1 - q)


def _page_remainder(series: ParameterSeries, tau0: fmpq, s: fmpq, order: int, d: int) -> mpf:
    """W_d + E_d + V_d of the page, W_d by its definition (no difference of large numbers)."""
    t, h = abs(_m(tau0)), _m(s)
    x = t + h
    total = _page_omitted(series, x, d)
    for k in range(series.length):
        size, error = _upper(series.matrix[k, series.degree]), _upper(series.matrix[k, series.degree + 1])
        if k >= d:
            total += mpf(math.perm(k, d)) * x ** (k - d) * error
        for i in range(max(order, d), k + 1):
            total += size * mpf(math.perm(i, d)) * mpf(math.comb(k, i)) * t ** (k - i) * h ** (i - d)
    return total


_PAGES = [
    *product(
        ((fmpq(7, 2), fmpq(1, 4)), (fmpq(-2), fmpq(0)), (fmpq(1, 3), fmpq(3))),
        ((fmpq(0), fmpq(1, 2)), (fmpq(-3, 2), fmpq(1, 4)), (fmpq(2), fmpq(1, 10**6)), (fmpq(1), fmpq(2))),
        (0, 1, 2),
        (3, 7, 40),
    )
]


@pytest.mark.parametrize(("range_of_b", "box", "derivative", "order"), _PAGES)
def test_remainder_is_the_one_of_the_page(
    range_of_b: tuple[fmpq, fmpq], box: tuple[fmpq, fmpq], derivative: int, order: int
) -> None:
    series = parameter_series(*range_of_b, 5, 25, _BITS)
    model = taylor_model(series, box[0] - box[1], box[0] + box[1], order, derivative)
    with mpmath.workdps(120):
        page = _page_remainder(series, *box, order, derivative)
        assert page * (1 - mpf("1e-40")) <= _upper(model.remainder) <= page * (1 + mpf("1e-12"))


@pytest.mark.parametrize("derivative", [0, 1, 2])
@pytest.mark.parametrize("tau", [fmpq(0), fmpq(-3, 2), fmpq(2)])
def test_remainder_at_a_single_point(tau: fmpq, derivative: int) -> None:
    """No power of u is missing at u = 0: E_d and V_d alone, at |tau| + 1."""
    series = parameter_series(fmpq(1, 3), fmpq(1, 2), 5, 25, _BITS)
    found = [taylor_model(series, tau, tau, order, derivative) for order in (derivative + 1, 10, 40)]
    with mpmath.workdps(120):
        page = _page_remainder(series, tau, fmpq(1), 25, derivative)  # order = length: W_d = 0
        for model in found:
            assert (len(model.coefficients), model.half_width) == (1, 0)
            assert page * (1 - mpf("1e-40")) <= _upper(model.remainder) <= page * (1 + mpf("1e-12"))
    for b in (fmpq(-1, 6), fmpq(1, 3), fmpq(5, 6)):
        assert covers(found[0].value(tau, b), truth(tau, b, derivative))


def test_finite_exactly_where_the_ratio_is_below_one() -> None:
    # K = 5, d = 0, B = 2: q = 7 X^3/(6 7 8) = 1 at X^3 = 48; K = 3, B = 2, X = 2: q = 40/120.
    series = parameter_series(fmpq(3, 2), fmpq(1, 2), 4, 5, 200)
    seen = {True: 0, False: 0}
    for n, d in product(range(1, 60), (0, 1, 2)):
        reach = fmpq(n, 8)
        allowed = (5 + 2) * reach**3 < (6 - d) * (7 - d) * (8 - d)
        seen[allowed] += 1
        assert omitted_terms(series, arb(reach), d).is_finite() == allowed
        assert taylor_model(series, -reach / 2, reach, 4, d).remainder.is_finite() == allowed
        assert taylor_model(series, -reach, reach / 3, 4, d).enclosure().is_finite() == allowed
    assert min(seen.values()) > 40
    # Exactly one: B = 1, X = 2, (K + 1) 8 = (K+1)(K+2)(K+3) has no root; d = 1: (K + 1) X^3 = K (K+1)(K+2), K = 2.
    exact = parameter_series(fmpq(0), fmpq(0), 1, 4, 200)
    assert not omitted_terms(exact, arb(24).root(3), 1).is_finite()
    assert not omitted_terms(exact, arb(5 * 6 * 7).root(3) * fmpq(1001, 1000), 0).is_finite()
    assert omitted_terms(parameter_series(fmpq(1), fmpq(0), 1, 3, 200), arb(2), 0).is_finite()
    # |b| below 1 counts as 1.
    small = parameter_series(fmpq(0), fmpq(0), 1, 3, 200)
    assert not omitted_terms(small, arb(fmpq(311, 100)), 0).is_finite()
    assert omitted_terms(small, arb(fmpq(310, 100)), 0).is_finite()


def test_a_reach_that_is_only_perhaps_small_enough_is_refused() -> None:
    series = parameter_series(fmpq(3, 2), fmpq(1, 2), 4, 5, 200)
    assert not omitted_terms(series, arb(3, 1), 0).is_finite()
    assert omitted_terms(series, arb(3, fmpq(1, 4)), 0).is_finite()


def test_derivatives_beyond_the_length_are_not_finite() -> None:
    series = parameter_series(fmpq(1, 2), fmpq(1, 8), 4, 9, 100)
    for d in range(15):
        assert omitted_terms(series, arb(fmpq(1, 100)), d).is_finite() == (d < 9)


@pytest.mark.parametrize("tau0", [fmpq(0), fmpq(-7, 4), fmpq(5, 2)])
@pytest.mark.parametrize("centre", [fmpq(3), fmpq(-4, 3)])
def test_the_polynomial_of_a_model_satisfies_the_differential_equation(tau0: fmpq, centre: fmpq) -> None:
    """Up to the errors of the a_k, which are far below 2^-60 here, in every power of u and (below the last) of eta."""
    s, r, order, degree = fmpq(1, 4), fmpq(1, 8), 14, 24
    series = parameter_series(centre, r, degree, 120, 300)
    rows = taylor_model(series, tau0 - s, tau0 + s, order).coefficients
    with working_bits(300):
        for i, j in product(range(order - 3), range(degree)):
            lower_power = rows[i][j - 1] if j else arb(0)
            residual = (
                math.perm(i + 3, 3) * rows[i + 3][j] / arb(s) ** 3
                - arb(tau0) * (i + 1) * rows[i + 1][j] / arb(s)
                - (i - centre) * rows[i][j]
                + r * lower_power
            )
            assert residual.is_finite()
            assert abs(residual) < arb(2) ** -60


@given(_CENTRES, _TAU0S, st.sampled_from((0, 1, 2)), _SHARES, _SHARES, _SHARES)
def test_two_centres_agree_where_they_overlap(
    centre: Fraction, tau0: Fraction, derivative: int, shift: Fraction, u: Fraction, eta: Fraction
) -> None:
    """Other middles in tau and in b, another series length: the same function."""
    first = good_series(to_fmpq(centre), fmpq(1, 4), to_fmpq(abs(tau0) + 1))
    second = good_series(to_fmpq(centre + shift / 8), fmpq(1, 2), to_fmpq(abs(tau0) + 3))
    left = taylor_model(first, to_fmpq(tau0 - Fraction(1, 4)), to_fmpq(tau0 + Fraction(1, 4)), 24, derivative)
    right = taylor_model(second, to_fmpq(tau0 - Fraction(1, 3)), to_fmpq(tau0 + Fraction(3, 4)), 30, derivative)
    tau, b = to_fmpq(tau0 + u / 4), to_fmpq(centre + eta / 4)
    found = [model.value(tau, b) for model in (left, right)]
    assert all(value.is_finite() for value in found)
    assert found[0].overlaps(found[1])
    assert left.enclosure().overlaps(right.enclosure())


def test_models_of_derivatives_are_derivatives_of_models() -> None:
    s = fmpq(1, 3)
    series = parameter_series(fmpq(5, 2), fmpq(1, 4), 8, 60, 200)
    models = [taylor_model(series, fmpq(1) - s, fmpq(1) + s, 12, d) for d in range(3)]
    assert [len(model.coefficients) for model in models] == [12, 11, 10]
    with working_bits(200):
        for lower, upper in pairwise(models):
            for i, row in enumerate(upper.coefficients):
                for j, value in enumerate(row):
                    assert value.is_finite()
                    assert value.overlaps((i + 1) * lower.coefficients[i + 1][j] / arb(s))


# The derivative in b


@pytest.mark.parametrize("centre", [fmpq(3), fmpq(-7, 3), fmpq(1, 2)])
@pytest.mark.parametrize("radius", [fmpq(1, 4), fmpq(3)])
@pytest.mark.parametrize("derivative", [0, 1, 2])
def test_beta_derivative_contains_the_derivative(centre: fmpq, radius: fmpq, derivative: int) -> None:
    series = parameter_series(centre, radius, 40, 90, 300)
    model = taylor_model(series, fmpq(-3, 2), fmpq(-1), 16, derivative).beta_derivative()
    assert (model.centre, model.radius) == (centre, radius / 2)
    assert model.remainder.is_finite()
    with mpmath.workdps(50):
        for u, eta in product((-1, fmpq(1, 3), 1), (-1, fmpq(-1, 2), 0, 1)):
            tau, b = fmpq(-5, 4) + fmpq(1, 4) * u, centre + radius / 2 * eta
            step = mpf(10) ** -12
            slope = mpmath.im(theta_complex(_m(tau), mpc(_m(b), step), derivative)) / step  # error of order step^2
            lower, upper = (_m(end) for end in ends(model.value(tau, b)))
            allowance = mpf(10) ** -18 * (1 + abs(slope))
            assert lower - allowance <= slope <= upper + allowance
            assert upper - lower < 1
            lower, upper = (_m(end) for end in ends(model.enclosure()))
            assert lower - allowance <= slope <= upper + allowance


def _plain(rows: list[list[int]], remainder: int) -> TaylorModel:
    coefficients = tuple(tuple(arb(value) for value in row) for row in rows)
    return TaylorModel(fmpq(0), fmpq(1), fmpq(0), fmpq(4), coefficients, arb(remainder), 100)


def test_beta_derivative_of_a_known_polynomial() -> None:
    """f = 7 eta + 5 eta^2 + 3 eta^3 + u eta with eta = b/4; df/db = (7 + 10 eta + 9 eta^2 + u)/4, eta = new eta/2."""
    model = _plain([[11, 7, 5, 3], [13, 1, 0, 0]], 6).beta_derivative()
    assert [[to_fraction(fmpq(v.fmpq())) for v in row] for row in model.coefficients] == [
        [Fraction(7, 4), Fraction(5, 4), Fraction(9, 16)],
        [Fraction(1, 4), 0, 0],
    ]
    assert ends(model.remainder) == (3, 3)  # 2 e/r
    assert model.radius == 2
    again = model.beta_derivative()
    assert [[to_fraction(fmpq(v.fmpq())) for v in row] for row in again.coefficients] == [
        [Fraction(5, 8), Fraction(9, 32)],
        [0, 0],
    ]
    assert ends(again.remainder) == (3, 3)
    assert again.radius == 1


def test_the_remainder_of_the_beta_derivative_may_not_be_smaller() -> None:
    """f - P = e (2 eta^2 - 1) stays below e on [-1, 1] but has slope 2 e at eta = 1/2 (complex eta allow 3 e)."""
    model = _plain([[0, 0]], 1)
    slope = Fraction(2) / 4
    assert ends(model.beta_derivative().remainder)[1] >= slope


def test_beta_derivative_of_constants_and_points() -> None:
    assert _plain([[5], [3]], 0).beta_derivative().enclosure().is_zero()
    series = parameter_series(fmpq(1, 2), fmpq(0), 4, 30, 100)
    with pytest.raises(ValueError, match="radius 0"):
        taylor_model(series, fmpq(0), fmpq(1), 6).beta_derivative()


# What a model says


def test_enclosure_and_value_of_a_known_polynomial() -> None:
    model = _plain([[10, -2], [1, 3]], 4)
    for value, low, high in (
        (model.enclosure(), 10 - 2 - 1 - 3 - 4, 10 + 2 + 1 + 3 + 4),
        (model.value(fmpq(1, 2), fmpq(-4)), 10 + 2 + (1 - 3) / 2 - 4, 10 + 2 + (1 - 3) / 2 + 4),
    ):
        lower, upper = ends(value)
        assert low - Fraction(1, 2**20) < lower <= low  # a radius has 30 bits
        assert high <= upper < high + Fraction(1, 2**20)
    assert not _plain([[10]], 0).enclosure().overlaps(arb(9))
    nothing = TaylorModel(fmpq(0), fmpq(1), fmpq(0), fmpq(1), ((arb(1),),), arb.nan(), 64)
    assert not nothing.enclosure().is_finite()
    assert not nothing.value(fmpq(0), fmpq(0)).is_finite()


def test_enclosures_are_not_absurdly_wide() -> None:
    """At most 1.2 times the range of the function over the box, as sampled."""
    for centre, tau0 in product((fmpq(7, 2), fmpq(-5, 3)), (fmpq(-4), fmpq(1, 3), fmpq(4))):
        series = good_series(centre, fmpq(1, 64), fmpq(5))
        lower, upper = tau0 - fmpq(1, 64), tau0 + fmpq(1, 64)
        model = taylor_model(series, lower, upper, good_order(lower, upper, series))
        points = [truth(t, b)[0] for t in (lower, upper) for b in (centre - fmpq(1, 64), centre + fmpq(1, 64))]
        low, high = ends(model.enclosure())
        assert high - low <= Fraction(6, 5) * (max(points) - min(points))


@pytest.mark.parametrize("bound", ["remainder", "spread", "local"])
@pytest.mark.parametrize("b", [fmpq(1, 2), fmpq(-7, 3)])
def test_bounds_that_are_attained(b: fmpq, bound: str) -> None:
    """A bound smaller by 2^-20 would exclude the value; ``tests/house/test_sabotage.py`` wants this red then."""
    tiny = fmpq(1, 10**9)
    series = parameter_series(b, fmpq(0), 1, 30, _BITS)
    if bound == "remainder":
        # The first power of u that is left out is nearly all of it.
        for derivative in (0, 1):
            model = taylor_model(series, -tiny, tiny, derivative + 1, derivative)
            assert covers(model.value(tiny, b), truth(tiny, b, derivative, 100))
            assert covers(model.enclosure(), truth(tiny, b, derivative, 100))
    elif bound == "spread":
        enclosure = taylor_model(series, -tiny, tiny, 6).enclosure()
        for u in (-1, 1):
            assert covers(enclosure, truth(u * tiny, b, 0, 100))


# Bad input


def test_bad_input() -> None:
    before = current_bits()
    series = parameter_series(fmpq(1, 2), fmpq(1, 2), 4, 20, 64)
    zero, one = fmpq(0), fmpq(1)
    for lower, upper, order, derivative, match in (
        (one, zero, 6, 0, "reversed"),
        (zero, one, 6, 3, "derivative"),
        (zero, one, 6, -1, "derivative"),
        (zero, one, 0, 0, "order"),
        (zero, one, 1, 1, "order"),
        (zero, one, 2, 2, "order"),
    ):
        with pytest.raises(ValueError, match=match):
            taylor_model(series, lower, upper, order, derivative)
    model = taylor_model(series, zero, one, 6)
    outside = fmpq(1, 10**30)
    for tau, b in ((-outside, one), (one + outside, one), (one, one + outside), (one, -outside)):
        with pytest.raises(ValueError, match="box"):
            model.value(tau, b)
    assert model.value(zero, zero).is_finite()
    assert model.value(one, one).is_finite()
    assert current_bits() == before


def test_ends_that_are_floats_are_refused() -> None:
    """The middle of two floats is a rounded number, so the box would not be the one that was asked."""
    series = parameter_series(fmpq(1, 2), fmpq(1, 2), 4, 20, 64)
    for lower, upper in ((0.1, 0.3), (0.5, fmpq(1)), (fmpq(0), 0.5), (0.5, 0.5)):
        with pytest.raises(TypeError):
            taylor_model(series, lower, upper, 6)  # type: ignore[arg-type]
    assert taylor_model(series, 0, 1, 6).half_width == fmpq(1, 2)


@settings(max_examples=15)
@given(st.sampled_from((30, 64, 200)), st.sampled_from((53, 77, 300)))
def test_the_precision_outside_does_not_matter(bits: int, outside: int) -> None:
    """Matrices are cached: what the caller's precision was when they were made has no influence."""
    series = parameter_series(fmpq(7, 2), fmpq(1, 8), 5, 30, bits)
    lower, upper = fmpq(-1, 7), fmpq(outside, 300)
    with working_bits(outside):
        first = taylor_model(series, lower, upper, 8, 1)
        enclosure, value = first.enclosure(), first.value(lower, series.centre)
    second = taylor_model(series, lower, upper, 8, 1)
    assert ends(second.enclosure()) == ends(enclosure)
    assert ends(second.value(lower, series.centre)) == ends(value)
