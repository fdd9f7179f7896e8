"""Each bound is the number that its proof page states, and each hypothesis is refused where the page's fails.

A containment test cannot see a bound that is a little too small while the true error is far smaller. Here every bound
is computed a second time, from the page, with mpmath, and compared with the radius of the ball.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from itertools import product

import mpmath
import pytest
from flint import arb, fmpq
from mpmath import mpf
from samples.strategies import ends, to_fmpq

from gspot_verified.numbers.balls import relative_bits, working_bits
from gspot_verified.numbers.complex_numbers import ExactComplex
from gspot_verified.theta_function.gamma import gamma_ratio as gamma_ratio_module
from gspot_verified.theta_function.sums.finite_part import near_integers, series_part, weight
from gspot_verified.theta_function.sums.laplace import LaplacePlan, laplace_sum
from gspot_verified.theta_function.sums.negative import negative_sum, sector_sum
from gspot_verified.theta_function.sums.positive import SaddlePlan, _saddle_remainder, positive_sum
from gspot_verified.theta_function.sums.splitting import splitting_sum
from gspot_verified.theta_function.sums.taylor import complex_taylor_sum, taylor_polynomial, taylor_sum

_BITS = 600
_BETAS = [Fraction(1, 2), Fraction(-1, 2), Fraction(-7, 2), Fraction(7, 3)]


@pytest.fixture(autouse=True)
def _many_digits() -> Iterator[None]:
    with mpmath.workdps(60):
        yield


def _m(value: Fraction | fmpq) -> mpf:
    number = Fraction(int(value.p), int(value.q)) if isinstance(value, fmpq) else value
    return mpf(number.numerator) / number.denominator


def _radius(value: arb) -> mpf:
    assert value.is_finite()
    lower, upper = ends(value)
    return _m((upper - lower) / 2)


def _equals(value: arb, page: mpf, tolerance: str = "1e-7") -> bool:
    """The radius is the page's bound: not below it, and above by rounding only (a radius has 30 bits)."""
    return page * (1 - mpf("1e-15")) <= _radius(value) <= page * (1 + mpf(tolerance))


def _saddle_bounds(tau: Fraction, beta: Fraction, plan: SaddlePlan) -> tuple[mpf, mpf]:
    """sqrt(lambda) (E_1 + E_2 + E_3 + E_4), and K of the page."""
    t, b, n, eta, rho = _m(tau), _m(beta), plan.terms, _m(plan.disc), _m(plan.cut)
    lam = t ** mpf(1.5)
    root = mpmath.sqrt(1 - eta / 3)
    sigma = eta * root
    whole = max(0, math.ceil(-beta - 1))
    m = (1 + eta) ** whole * (1 - eta) ** (-b - 1 - whole) * (2 - root) / (1 - eta / 2)
    p = max(mpf(0), -b - 1)
    tail = mpmath.exp(-lam * sigma**2)
    e1 = m * mpmath.gamma(n + mpf(1) / 2) * (sigma**2 * lam) ** (-n) / mpmath.sqrt(lam)
    e2 = 2 * m * tail / (lam * sigma)
    e3 = mpmath.exp(p * sigma) * tail / (2 * lam * sigma - p)
    e4 = max(mpf(1), rho ** (-b - 1)) * tail
    front = mpmath.rgamma(-b) * t ** (-b / 2) / mpmath.sqrt(lam) * mpmath.exp(2 * lam / 3)
    return mpmath.sqrt(lam) * (e1 + e2 + e3 + e4), abs(front)


_PLANS = [
    SaddlePlan(1, fmpq(1, 2), fmpq(2, 5)),
    SaddlePlan(2, fmpq(1, 2), fmpq(1, 20)),
    SaddlePlan(2, fmpq(3, 5), fmpq(2, 5)),
    SaddlePlan(3, fmpq(7, 10), fmpq(3, 10)),
]


@pytest.mark.parametrize("plan", _PLANS)
@pytest.mark.parametrize("beta", _BETAS)
@pytest.mark.parametrize("tau", [Fraction(10), Fraction(14)])
def test_saddle_remainder_is_the_one_of_the_page(tau: Fraction, beta: Fraction, plan: SaddlePlan) -> None:
    with working_bits(128):
        point = arb(to_fmpq(tau))
        bound = _saddle_remainder(point * point.sqrt(), arb(to_fmpq(beta)), plan)
    page, _ = _saddle_bounds(tau, beta, plan)
    assert bound.is_finite()
    lower, upper = (_m(end) for end in ends(bound))
    assert page <= upper
    assert abs(lower / page - 1) < mpf("1e-12")
    assert abs(upper / page - 1) < mpf("1e-12")


@pytest.mark.parametrize("plan", [_PLANS[0], _PLANS[1], SaddlePlan(2, fmpq(1, 4), fmpq(3, 4))])
@pytest.mark.parametrize("beta", _BETAS)
def test_radius_of_the_saddle_sum_is_the_one_of_the_page(beta: Fraction, plan: SaddlePlan) -> None:
    """The last plan has its cut so far out that E_5 is most of the radius."""
    tau = Fraction(20)
    value = positive_sum(to_fmpq(tau), to_fmpq(beta), plan, _BITS)
    bound, front = _saddle_bounds(tau, beta, plan)
    b, rho, lam = _m(beta), _m(plan.cut), mpf(20) ** mpf(1.5)
    e5 = 2 * abs(mpmath.rgamma(-b)) * (rho * mpmath.sqrt(20)) ** (-b) * mpmath.exp(lam * (rho + rho**3 / 3))
    assert _equals(value, front * bound + e5)


def test_saddle_point_is_finite_exactly_where_its_hypotheses_hold() -> None:
    seen = {True: 0, False: 0}
    discs = [fmpq(n, 20) for n in (-10, 0, 5, 10, 14, 20, 25)]
    cuts = [fmpq(n, 20) for n in (-10, 0, 4, 6, 10, 15, 20)]
    for terms, disc, cut in product((0, 1, 2, 3, 5, 6), discs, cuts):
        for beta in (-3, -17, -33):
            plan = SaddlePlan(terms, disc, cut)
            # Compared with the squares: lambda = 27, sigma^2 = disc^2 (1 - disc/3).
            square = disc**2 * (1 - disc / 3)
            allowed = (
                0 < disc < 1
                and 0 < cut <= 1 - disc
                and terms >= 1
                and 27 * square >= 2 * terms
                and 4 * 27**2 * square > (-beta - 1) ** 2
            )
            seen[allowed] += 1
            assert positive_sum(fmpq(9), fmpq(beta), plan, 100).is_finite() == allowed, (plan, beta)
    assert min(seen.values()) > 20


@pytest.mark.parametrize("beta", [0, 1, -3])
def test_saddle_point_wants_tau_positive_at_integers_too(beta: int) -> None:
    for tau in (fmpq(0), fmpq(-20), arb(0, 1)):
        assert not positive_sum(tau, fmpq(beta), SaddlePlan(1, fmpq(1, 2), fmpq(1, 4)), 100).is_finite()


@pytest.mark.parametrize("beta", [*_BETAS, Fraction(-17, 4)])
@pytest.mark.parametrize("end", [fmpq(2), fmpq(5, 2)])
@pytest.mark.parametrize("tau", [Fraction(0), Fraction(1, 2), Fraction(-3)])
def test_radius_beyond_the_end_of_the_laplace_integral(tau: Fraction, beta: Fraction, end: fmpq) -> None:
    t, b, r = _m(tau), _m(beta), _m(end)
    s = r**2 - t - max(mpf(0), -b - 1) / r
    page = abs(mpmath.rgamma(-b)) * r ** (-b - 1) * mpmath.exp(r * t - r**3 / 3) / s
    value = laplace_sum(to_fmpq(tau), to_fmpq(beta), LaplacePlan(fmpq(1, 4), end, 120, fmpq(1)), 200)
    assert _equals(value, page)


def test_laplace_integral_is_finite_exactly_where_its_hypotheses_hold() -> None:
    for cut, end, peak in product((-1, 0, 1, 2, 3), (-3, 1, 2, 3), (-1, 0, 1)):
        for tau, beta in ((0, -5), (5, fmpq(1, 2)), (-9, -3), (0, -7), (-9, -40), (4, fmpq(1, 2))):
            plan = LaplacePlan(fmpq(cut), fmpq(end), 8, fmpq(peak))
            decay = fmpq(end) ** 2 - tau - max(fmpq(0), -beta - fmpq(1)) / end
            allowed = 0 < cut < end and peak > 0 and decay > 0
            assert laplace_sum(fmpq(tau), fmpq(beta), plan, 64).is_finite() == allowed, (plan, tau, beta)


def test_laplace_integral_at_integers_checks_its_hypotheses_too() -> None:
    for plan in (
        LaplacePlan(fmpq(2), fmpq(1), 30, fmpq(1)),
        LaplacePlan(fmpq(1), fmpq(2), 30, fmpq(1)),
        LaplacePlan(fmpq(1), fmpq(9), 30, fmpq(0)),
    ):
        assert not laplace_sum(fmpq(5), fmpq(2), plan, 100).is_finite()


@pytest.mark.parametrize("beta", [Fraction(1, 2), Fraction(-1, 2), Fraction(-7, 2), Fraction(4, 3)])
@pytest.mark.parametrize("tau", [Fraction(2), Fraction(-3)])
@pytest.mark.parametrize(("cut", "terms"), [(fmpq(1, 4), 3), (fmpq(1, 2), 5), (fmpq(3, 2), 4)])
def test_radius_of_the_finite_part(tau: Fraction, beta: Fraction, cut: fmpq, terms: int) -> None:
    b, c = _m(beta), _m(cut)
    growth = mpmath.exp(4 * c * abs(_m(tau)) + 64 * c**3 / 3)
    page = abs(mpmath.rgamma(-b)) * c ** (-b) * growth * mpf(4) ** (1 - terms) / 3
    assert _equals(series_part(to_fmpq(tau), to_fmpq(beta), cut, terms, _BITS), page)


@pytest.mark.parametrize("terms", [1, 2, 3])
def test_finite_part_is_finite_exactly_where_its_hypotheses_hold(terms: int) -> None:
    for shift in (fmpq(0), fmpq(1, 100), fmpq(-1, 100), fmpq(-1, 2), fmpq(1, 2)):
        value = series_part(fmpq(1), terms - 1 + shift, fmpq(1, 2), terms, 100)
        assert value.is_finite() == (shift <= 0)
    assert not series_part(fmpq(1), arb(terms - 1, fmpq(1, 100)), fmpq(1, 2), terms, 100).is_finite()
    for cut in (fmpq(0), fmpq(-1, 2)):
        assert not series_part(fmpq(1), fmpq(-2), cut, terms, 100).is_finite()


@pytest.mark.parametrize("beta", _BETAS)
@pytest.mark.parametrize("terms", [1, 2, 4])
@pytest.mark.parametrize("x", [2, 5])
def test_radius_of_the_enveloping_series(x: int, beta: Fraction, terms: int) -> None:
    page = (
        abs(mpmath.rf(-_m(beta), 3 * terms)) / (3**terms * mpmath.factorial(terms)) * mpf(x) ** (_m(beta) - 3 * terms)
    )
    assert _equals(negative_sum(fmpq(-x), to_fmpq(beta), terms, _BITS), page)


def test_enveloping_series_is_finite_exactly_where_its_hypotheses_hold() -> None:
    for terms, shift in product((0, 1, 2, 5), (fmpq(-1, 100), fmpq(0), fmpq(1, 100), fmpq(-1), fmpq(1))):
        beta = 3 * terms + shift
        assert negative_sum(fmpq(-7), beta, terms, 100).is_finite() == (shift < 0)
    for tau in (fmpq(0), fmpq(7), arb(-1, 1)):
        assert not negative_sum(tau, fmpq(-3), 2, 100).is_finite()
        assert not negative_sum(tau, fmpq(2), 1, 100).is_finite()


def _taylor_bound(tau: Fraction, beta: Fraction, length: int) -> tuple[mpf, mpf]:
    """The bound on the rest, and q."""
    b, x = _m(beta), abs(_m(tau))
    a = [mpf(3) ** ((j - b) / 3 - 1) * mpmath.gamma((j - b) / 3) * mpmath.rgamma(-b) for j in range(3)]
    a[2] /= 2
    for k in range(length):
        a.append((k - b) * a[k] / ((k + 1) * (k + 2) * (k + 3)))
    q = (1 + abs(b) / length) * x**3 / ((length + 1) * (length + 2))
    return sum(abs(a[length + i]) * x ** (length + i) for i in range(3)) / (1 - q), q


_TAYLOR = [*product([Fraction(2), Fraction(-3, 2), Fraction(1, 2)], _BETAS, [3, 6, 9])]


@pytest.mark.parametrize(("tau", "beta", "length"), _TAYLOR)
def test_radius_of_the_taylor_series(tau: Fraction, beta: Fraction, length: int) -> None:
    page, q = _taylor_bound(tau, beta, length)
    t, b = to_fmpq(tau), to_fmpq(beta)
    for value in (taylor_sum(t, b, length, _BITS), splitting_sum(t, b, length, _BITS, 1)):
        assert value.is_finite() == (q < 1)
        assert q >= 1 or _equals(value, page)


@pytest.mark.parametrize("length", [4, 5, 7])
def test_radius_of_the_taylor_series_at_any_length(length: int) -> None:
    page, _ = _taylor_bound(Fraction(1), Fraction(1, 2), length)
    assert _equals(taylor_sum(fmpq(1), fmpq(1, 2), length, _BITS), page)
    # The chains of the splitting are whole blocks: as many terms or more.
    page, _ = _taylor_bound(Fraction(1), Fraction(1, 2), 6 if length < 7 else 9)
    assert _equals(splitting_sum(fmpq(1), fmpq(1, 2), length, _BITS, 1), page)
    page, _ = _taylor_bound(Fraction(1), Fraction(1, 2), 12)
    assert _equals(splitting_sum(fmpq(1), fmpq(1, 2), length, _BITS, 4), page)


_ANGLES = [(3, 4), (-3, 4), (5, 0), (0, -5), (-4, -3)]


@pytest.mark.parametrize(("x", "y"), _ANGLES)
@pytest.mark.parametrize("beta", _BETAS)
@pytest.mark.parametrize("length", [3, 6, 9])
def test_radius_of_the_taylor_series_at_complex_tau(x: int, y: int, beta: Fraction, length: int) -> None:
    """The bound depends on |tau| alone, and both parts are widened by it."""
    for scale in (Fraction(1, 10), Fraction(2, 5)):
        page, q = _taylor_bound(5 * scale, beta, length)
        tau = ExactComplex(to_fmpq(x * scale), to_fmpq(y * scale))
        value = complex_taylor_sum(tau, to_fmpq(beta), length, _BITS)
        assert value.is_finite() == (q < 1)
        assert q >= 1 or (_equals(value.real, page) and _equals(value.imag, page))


def _sector_distance(x: int, y: int) -> mpf:
    """d(z) of the page at z = x + iy."""
    angle = abs(mpmath.arg(mpmath.mpc(x, y)))
    return abs(mpmath.mpc(x, y)) * mpmath.cos(max(angle - mpmath.pi / 6, 0))


@pytest.mark.parametrize("beta", _BETAS)
@pytest.mark.parametrize("terms", [1, 2, 4])
@pytest.mark.parametrize(("x", "y"), [(5, 0), (7, 4), (7, -4), (7, 5), (1, -6), (0, 6), (-2, 7), (-3, -6)])
def test_radius_of_the_enveloping_series_in_the_sector(x: int, y: int, beta: Fraction, terms: int) -> None:
    power = _sector_distance(x, y) ** (_m(beta) - 3 * terms)
    page = abs(mpmath.rf(-_m(beta), 3 * terms)) / (3**terms * mpmath.factorial(terms)) * power
    value = sector_sum(ExactComplex(fmpq(-x), fmpq(-y)), to_fmpq(beta), terms, _BITS)
    assert _equals(value.real, page)
    assert _equals(value.imag, page)


def test_the_sector_is_finite_exactly_where_its_hypotheses_hold() -> None:
    inside, outside = [(-7, 0), (0, 7), (0, -7), (100, 174), (100, -174)], [(7, 0), (0, 0), (100, 173), (100, -173)]
    for terms, shift in product((0, 1, 2, 5), (fmpq(-1, 100), fmpq(0), fmpq(1, 100), fmpq(-1), fmpq(1))):
        for x, y in inside:
            value = sector_sum(ExactComplex(fmpq(x), fmpq(y)), 3 * terms + shift, terms, 100)
            assert value.is_finite() == (shift < 0 and terms >= 1)
    for x, y in outside:
        assert not sector_sum(ExactComplex(fmpq(x), fmpq(y)), fmpq(-3), 2, 100).is_finite()
    for tau in (ExactComplex(arb(-1, 1), fmpq(0)), ExactComplex(arb(-1, 2), arb(0, 1))):
        assert not sector_sum(tau, fmpq(-3), 2, 100).is_finite()
    assert not sector_sum(ExactComplex(fmpq(-7), fmpq(1)), arb(3, fmpq(1, 100)), 1, 100).is_finite()
    assert sector_sum(ExactComplex(fmpq(-7), fmpq(1)), arb(fmpq(29, 10), fmpq(1, 100)), 1, 100).is_finite()


def test_ratio_of_the_taylor_series_exactly_one() -> None:
    # K = 3, X = 2: q = (1 + |beta|/3) 8/20 is 1 at beta = -9/2.
    assert not taylor_sum(fmpq(2), fmpq(-9, 2), 3, 200).is_finite()
    assert not splitting_sum(fmpq(2), fmpq(-9, 2), 3, 200, 1).is_finite()
    assert taylor_sum(fmpq(2), fmpq(-44, 10), 3, 200).is_finite()
    assert splitting_sum(fmpq(2), fmpq(-44, 10), 3, 200, 1).is_finite()
    assert not taylor_sum(fmpq(2), fmpq(-46, 10), 3, 200).is_finite()
    assert not splitting_sum(fmpq(2), fmpq(-46, 10), 3, 200, 1).is_finite()


@pytest.mark.parametrize("tau", [arb(0, 3), arb(1, 2), arb(-1, 2)])
def test_rest_of_the_finite_part_covers_a_ball_of_tau(tau: arb) -> None:
    """With one term the sum does not depend on tau: the radius is the bound at |tau| = 3."""
    page = abs(mpmath.rgamma(mpf(1) / 2)) * mpmath.exp(4 * 3 + mpf(64) / 3) / 3
    assert _equals(series_part(tau, fmpq(-1, 2), fmpq(1), 1, _BITS), page)


def test_rest_of_the_finite_part_covers_a_ball_of_beta() -> None:
    value = series_part(fmpq(3), arb(-2, fmpq(1, 2)), fmpq(1), 1, _BITS)
    for beta in (Fraction(-5, 2), Fraction(-2), Fraction(-3, 2)):
        page = abs(mpmath.rgamma(-_m(beta))) * mpmath.exp(4 * 3 + mpf(64) / 3) / 3
        assert page <= _radius(value)


def test_rest_of_the_taylor_series_covers_a_ball_of_beta() -> None:
    wide = taylor_polynomial(arb(0, 1), 6, 200)
    for beta in (fmpq(-1), fmpq(-1, 2), fmpq(2, 3), fmpq(1)):
        inside = taylor_polynomial(beta, 6, 200)
        pairs = zip((*wide.omitted, wide.ratio_factor), (*inside.omitted, inside.ratio_factor), strict=True)
        for outer, inner in pairs:
            assert ends(outer)[1] >= ends(inner)[0]
    # |beta| = 5 makes q > 1; the midpoint alone would not.
    assert not taylor_sum(fmpq(2), arb(0, 5), 3, 200).is_finite()
    assert taylor_sum(fmpq(2), arb(0, 4), 3, 200).is_finite()
    assert not taylor_sum(arb(0, 3), fmpq(0), 3, 200).is_finite()
    assert taylor_sum(arb(0, fmpq(5, 2)), fmpq(0), 3, 200).is_finite()


_CENTERS = [(fmpq(-12), fmpq(1, 2)), (fmpq(-12), fmpq(-5, 3)), (fmpq(12), fmpq(1, 2)), (fmpq(12), fmpq(-5, 3))]


@pytest.mark.parametrize(("tau", "beta"), _CENTERS)
def test_every_route_encloses_over_balls_of_both_arguments(tau: fmpq, beta: fmpq) -> None:
    radius = fmpq(1, 50)
    wide_tau, wide_beta = arb(tau, radius), arb(beta, radius)
    laplace = LaplacePlan(fmpq(1, 8), fmpq(12), 80, fmpq(4))
    plan = SaddlePlan(2, fmpq(1, 2), fmpq(2, 5))
    found = [taylor_sum(wide_tau, wide_beta, 150, 300), laplace_sum(wide_tau, wide_beta, laplace, 200)]
    found.append(negative_sum(wide_tau, wide_beta, 3, 200) if tau < 0 else positive_sum(wide_tau, wide_beta, plan, 200))
    for x, y in product((-1, 0, 1), repeat=2):
        inside = taylor_sum(tau + x * radius * fmpq(9, 10), beta + y * radius * fmpq(9, 10), 180, 500)
        for value in found:
            assert value.is_finite()
            assert value.contains(inside.mid())


@pytest.mark.parametrize("beta", _BETAS)
@pytest.mark.parametrize("terms", [1, 2, 4])
def test_midpoint_of_the_enveloping_series_is_the_sum_of_its_terms(beta: Fraction, terms: int) -> None:
    lower, upper = ends(negative_sum(fmpq(-5), to_fmpq(beta), terms, _BITS))
    total = sum(
        mpmath.rf(-_m(beta), 3 * k) * (-1) ** k / (3**k * mpmath.factorial(k)) * mpf(5) ** (_m(beta) - 3 * k)
        for k in range(terms)
    )
    assert abs(_m((lower + upper) / 2) / total - 1) < mpf("1e-50")


def test_weights_far_below_zero_and_at_integers() -> None:
    with working_bits(200):
        for n, beta in product(range(5), (fmpq(-9, 2), fmpq(-1, 2), fmpq(-1, 3), fmpq(0), fmpq(7, 3), fmpq(3))):
            page = mpmath.rf(-_m(beta), n) * mpmath.rgamma(n + 1 - _m(beta))
            value = weight(n, beta, 200)
            assert value.is_finite()
            assert abs(_m(sum(ends(value)) / 2) - page) <= mpf("1e-50") * (1 + abs(page))
            assert _radius(value) <= mpf("1e-50") * (1 + abs(page))


@pytest.mark.parametrize("n", range(-1, 5))
def test_integers_nearer_than_one_half_are_never_left_out(n: int) -> None:
    for shift in (fmpq(-499, 1000), fmpq(0), fmpq(499, 1000)):
        assert n < 0 or n in near_integers(n + shift)
        assert n < 0 or n in near_integers(arb(n + 2 * shift, fmpq(1, 2)))
    with pytest.raises(ValueError, match="domain"):
        near_integers(arb("nan"))


@pytest.mark.parametrize("y", [fmpq(1), fmpq(1, 2), fmpq(2, 9), fmpq(1, 60)])
@pytest.mark.parametrize("bits", [64, 500, 2000])
def test_tail_of_the_gamma_ratio_is_the_one_of_the_page(monkeypatch: pytest.MonkeyPatch, y: fmpq, bits: int) -> None:
    """The program's tail is 4 (6M + 1)/scale with scale * T(n)/Q(n) = 9 N(n)/(4 (12n+5) D(n))."""
    honest, bounds = gamma_ratio_module.add_remainder, []

    def recording(value: arb, bound: arb) -> arb:
        assert value.is_zero()
        bounds.append(bound)
        return honest(value, bound)

    monkeypatch.setattr(gamma_ratio_module, "add_remainder", recording)
    gamma_ratio_module.gamma_ratio(y, bits)
    (_, below, above), scale = gamma_ratio_module._step_polynomials(y)
    for n in (0, 1, 7):
        p = Fraction(int(y.p), int(y.q))
        d = (12 * n + 3 * p + 1) * (12 * n + 3 * p + 4) * (12 * n + 3 * p + 7) * (12 * n + 3 * p + 10)
        rows = gamma_ratio_module._NUMERATOR
        numerator = sum(c * Fraction(n) ** i * p**j for i, row in enumerate(rows) for j, c in enumerate(row))
        page = 9 * numerator / (4 * (12 * n + 5) * d)
        assert Fraction(int(scale.p), int(scale.q)) * int(above(n)) / int(below(n)) == page
    terms = 4 * ((bits + 24) // 40 + 1)  # ten bits a term, whole leaves of four
    (bound,) = bounds
    page = 4 * (6 * terms + 1) / abs(_m(scale))
    assert page * (1 - mpf("1e-15")) <= _m(ends(abs(bound))[1]) <= page * (1 + mpf("1e-12"))


def test_rest_of_the_splitting_covers_its_rounding() -> None:
    """Few bits and q next to 1: the omitted terms are wide balls, and their upper ends count."""
    for beta in (Fraction(-449, 100), Fraction(-447, 100)):
        page, _ = _taylor_bound(Fraction(2), beta, 3)
        for bits in (12, 16, 24):
            assert page <= _radius(splitting_sum(fmpq(2), to_fmpq(beta), 3, bits, 1))
            assert page <= _radius(taylor_sum(fmpq(2), to_fmpq(beta), 3, bits))


@pytest.mark.parametrize("tau", [Fraction(n, 7) for n in range(9, 19) if n % 7])
def test_ratio_exactly_one_at_rationals_that_are_rounded(tau: Fraction) -> None:
    for length in (3, 6):
        beta = -length * ((length + 1) * (length + 2) / tau**3 - 1)
        if beta < 0:
            assert not taylor_sum(to_fmpq(tau), to_fmpq(beta), length, 100).is_finite()
            assert not splitting_sum(to_fmpq(tau), to_fmpq(beta), length, 100, 1).is_finite()


@pytest.mark.parametrize("bits", [16_000, 23_000, 33_000, 47_000])
def test_gamma_ratio_where_common_factors_are_removed_twice(bits: int) -> None:
    """Blocks of 128 terms and more: their halves were divided before."""
    y = fmpq(2, 9)
    ratio = gamma_ratio_module.gamma_ratio(y, bits)
    with working_bits(bits + 100):
        assert ratio.overlaps(arb.gamma_fmpq(y + fmpq(1, 3)) / arb.gamma_fmpq(y))
    assert relative_bits(ratio) >= bits


def test_decay_just_below_zero_is_refused() -> None:
    for tau in (fmpq(4), fmpq(9, 2), fmpq(99, 20)):
        plan = LaplacePlan(fmpq(1), fmpq(2), 30, fmpq(1))
        assert not laplace_sum(tau, fmpq(1, 2), plan, 64).is_finite()
    assert not negative_sum(fmpq(1, 2), fmpq(-3), 2, 100).is_finite()
