"""The coefficients of Theta at tau = 0 as polynomials in b: what they enclose, and that each error is the page's.

The witness is mpmath's 1/Gamma at complex b and the recurrence: the models hold on a disc, not only on an interval.

Page: proofs/box.md.
"""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import product

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mpc, mpf
from samples.strategies import ends, holds, to_fmpq, to_fraction

from gspot_verified.numbers.balls import current_bits, working_bits
from gspot_verified.theta_function.boxes.parameter_series import (
    ParameterSeries,
    initial_models,
    parameter_series,
    reciprocal_gamma_bound,
)
from gspot_verified.theta_function.value.integer import polynomial

_DIGITS = 60
_CENTRES = st.one_of(
    st.integers(-6, 12).map(Fraction),
    st.builds(Fraction, st.integers(-40, 60), st.integers(1, 9)),
    st.integers(-3, 6).map(lambda n: n + Fraction(1, 10**20)),
    st.sampled_from((Fraction(-50), Fraction(-151, 3), Fraction(150), Fraction(451, 3))),
)
_RADII = st.one_of(
    st.sampled_from((Fraction(0), Fraction(3), Fraction(3) - Fraction(1, 10**12), Fraction(1, 10**30))),
    st.builds(Fraction, st.integers(0, 24), st.just(8)),
)
# The edge of the disc more often than its inside.
_ETAS = st.tuples(st.sampled_from((1.0, 1.0, 0.999, 0.5, 0.0)), st.integers(0, 15))


def _m(value: Fraction | fmpq) -> mpf:
    number = to_fraction(value) if isinstance(value, fmpq) else value
    return mpf(number.numerator) / number.denominator


def _eta(choice: tuple[float, int]) -> mpc:
    # Just inside: a point that rounding puts outside the disc proves nothing.
    return mpf(choice[0]) * (1 - mpf(10) ** (5 - _DIGITS)) * mpmath.expjpi(mpf(choice[1]) / 8)


def _middle_and_radius(value: arb) -> tuple[mpf, mpf]:
    lower, upper = ends(value)
    return _m((lower + upper) / 2), _m((upper - lower) / 2)


def _polynomial_at(coefficients: list[arb], eta: mpc) -> tuple[mpc, mpf]:
    """The value for the midpoints, and how far the true one may be from it."""
    parts = [_middle_and_radius(value) for value in coefficients]
    return (
        mpmath.fsum(middle * eta**j for j, (middle, _) in enumerate(parts)),
        mpmath.fsum(radius for _, radius in parts),
    )


def coefficients_witness(b: mpc, count: int) -> list[mpc]:
    """a_0 .. a_(count-1) at complex b."""
    front = 2 * mpmath.pi * mpmath.power(3, 2 * b / 3 - mpf(1) / 2)
    gammas = [mpmath.rgamma((j - b) / 3) for j in range(3)]
    a = [
        front * gammas[1] * gammas[2],
        front * mpmath.cbrt(3) * gammas[0] * gammas[2],
        front * mpmath.cbrt(9) * gammas[0] * gammas[1] / 2,
    ]
    for k in range(count - 3):
        a.append((k - b) * a[k] / ((k + 1) * (k + 2) * (k + 3)))
    return a


def _row(series: ParameterSeries, k: int) -> tuple[list[arb], arb, arb]:
    """The polynomial of a_k, the bound on |a_k|, the error."""
    values = [series.matrix[k, j] for j in range(series.degree + 2)]
    return values[: series.degree], values[-2], values[-1]


def _upper(value: arb) -> mpf:
    return _m(ends(value)[1])


@given(
    _CENTRES, _RADII, st.sampled_from((1, 2, 3, 8, 20)), st.sampled_from((3, 4, 7, 24)),
    st.sampled_from((10, 53, 200)), _ETAS,
)  # fmt: skip
def test_every_row_models_its_coefficient(
    centre: Fraction, radius: Fraction, degree: int, length: int, bits: int, choice: tuple[float, int]
) -> None:
    series = parameter_series(to_fmpq(centre), to_fmpq(radius), degree, length, bits)
    with mpmath.workdps(_DIGITS + 40):
        eta = _eta(choice)
        truth = coefficients_witness(_m(centre) + _m(radius) * eta, length + 3)
        doubt = mpf(10) ** -_DIGITS
        for k in range(length):
            coefficients, size, error = _row(series, k)
            value, rounding = _polynomial_at(coefficients, eta)
            assert abs(truth[k] - value) <= _upper(error) + rounding + doubt * (1 + abs(value))
            assert abs(truth[k]) <= _upper(size) * (1 + doubt) + doubt
        for k, bound in enumerate(series.omitted, start=length):
            assert abs(truth[k]) <= _upper(bound) * (1 + doubt) + doubt


def _page_gamma_bound(y: Fraction, rho: Fraction, shift: int) -> mpf:
    """Section 1, with m = shift."""
    assert y + shift - rho >= Fraction(1, 2)
    g = mpmath.rgamma(_m(y + shift - rho)) if y + shift - rho >= 2 else mpf(113) / 100
    factors = mpmath.fprod(abs(_m(y + i)) + _m(rho) for i in range(shift))
    return g * mpmath.sqrt(mpmath.cosh(mpmath.pi * _m(rho))) * factors


def _page_shift(y: Fraction, rho: Fraction) -> int:
    return max(0, math.floor(rho + Fraction(1, 2) - y) + 1)


@given(
    st.builds(Fraction, st.integers(-200, 200), st.integers(1, 9)),
    st.sampled_from((Fraction(0), Fraction(1, 3), Fraction(2), Fraction(5))),
    _ETAS,
)  # fmt: skip
def test_bound_on_reciprocal_gamma(y: Fraction, rho: Fraction, choice: tuple[float, int]) -> None:
    with working_bits(100):
        bound = reciprocal_gamma_bound(to_fmpq(y), arb(to_fmpq(rho)))
    with mpmath.workdps(_DIGITS):
        page = _page_gamma_bound(y, rho, _page_shift(y, rho))
        assert page * (1 - mpf("1e-25")) <= _upper(bound) <= page * (1 + mpf("1e-25"))
        assert abs(mpmath.rgamma(_m(y) + _m(rho) * _eta(choice))) <= _upper(bound)


@pytest.mark.parametrize("y", [Fraction(-7), Fraction(-5, 2), Fraction(1, 2), Fraction(5, 2), Fraction(4), Fraction(9)])
@pytest.mark.parametrize("bits", [2, 4, 8, 30])
def test_bound_on_reciprocal_gamma_at_few_bits(y: Fraction, bits: int) -> None:
    with working_bits(bits):
        bound = reciprocal_gamma_bound(to_fmpq(y), arb(2))
    with mpmath.workdps(30):
        worst = max(abs(mpmath.rgamma(_m(y) + 2 * mpmath.expjpi(mpf(j) / 24))) for j in range(48))
        # With two bits flint gives up on cosh; a wrong bound it may not give.
        assert bound.is_finite() or bits == 2
        assert not bound.is_finite() or worst <= _upper(bound)


@pytest.mark.parametrize("y", [Fraction(-4), Fraction(-1, 3), Fraction(1), Fraction(17, 3)])
def test_bound_on_reciprocal_gamma_is_not_absurd(y: Fraction) -> None:
    """Divided by 2^12 it would be exceeded; on a point (rho = 0), divided by 2."""
    with working_bits(64):
        disc, point = reciprocal_gamma_bound(to_fmpq(y), arb(2)), reciprocal_gamma_bound(to_fmpq(y), arb(0))
    with mpmath.workdps(30):
        worst = max(abs(mpmath.rgamma(_m(y) + 2 * mpmath.expjpi(mpf(j) / 24))) for j in range(48))
        assert worst > _upper(disc) / 2**12
        # At a zero of 1/Gamma the product has a factor 0 as well.
        assert abs(mpmath.rgamma(_m(y))) >= _upper(point) / 2


_GRID = [*product((Fraction(0), Fraction(7, 2), Fraction(-7, 3), Fraction(-20), Fraction(40, 3)),
                  (Fraction(1, 8), Fraction(1), Fraction(3)), (1, 4, 12))]  # fmt: skip


@pytest.mark.parametrize(("centre", "radius", "degree"), _GRID)
def test_errors_are_those_of_the_page(centre: Fraction, radius: Fraction, degree: int) -> None:
    length, bits = 15, 200
    models = initial_models(to_fmpq(centre), to_fmpq(radius), degree, bits)
    series = parameter_series(to_fmpq(centre), to_fmpq(radius), degree, length, bits)
    with mpmath.workdps(_DIGITS):
        arguments = [(j - centre) / 3 for j in range(3)]
        bounds = [_page_gamma_bound(y, Fraction(2), _page_shift(y, Fraction(2))) for y in arguments]
        kappa = _m(radius / 6)
        errors = []
        for j, (first, second) in enumerate(((1, 2), (0, 2), (0, 1))):
            m = 2 * mpmath.pi * mpmath.power(3, _m(2 * centre / 3 - Fraction(1, 2) + Fraction(j, 3))) * 81
            page = m * bounds[first] * bounds[second] * kappa**degree / (1 - kappa)
            assert page * (1 - mpf("1e-40")) <= _upper(models[j].error) <= page * (1 + mpf("1e-40"))
            errors.append(page / 2 if j == 2 else page)
        for k in range(length):
            coefficients, size, error = _row(series, k)
            parts = [_middle_and_radius(value)[0] for value in coefficients]
            tolerance = mpf("1e-30")
            assert errors[k] * (1 - tolerance) <= _upper(error) <= errors[k] * (1 + tolerance) + tolerance
            page_size = mpmath.fsum(abs(value) for value in parts) + errors[k]
            assert page_size * (1 - tolerance) <= _upper(size) <= page_size * (1 + tolerance) + tolerance
            # P_(k+3) is (k - b) P_k/(...), its highest power cut off and put into the error.
            divisor = (k + 1) * (k + 2) * (k + 3)
            cut = _m(radius) * abs(parts[degree - 1]) / divisor
            errors.append((abs(_m(k - centre)) + _m(radius)) * errors[k] / divisor + cut)
        for bound, k in zip(series.omitted, range(length, length + 3), strict=True):
            assert _upper(bound) >= errors[k] * (1 - mpf("1e-30"))


@pytest.mark.parametrize("degree", [1, 3, 6, 12])
@pytest.mark.parametrize("radius", [Fraction(1), Fraction(3)])
@pytest.mark.parametrize("centre", [Fraction(0), Fraction(7, 2), Fraction(-7, 3)])
def test_errors_are_not_absurd(centre: Fraction, radius: Fraction, degree: int) -> None:
    """The largest error on the circle against its bound: divided by 2^30 (and 2^4 a degree) it would be exceeded."""
    series = parameter_series(to_fmpq(centre), to_fmpq(radius), degree, 6, 300)
    with mpmath.workdps(_DIGITS + 20):
        worst = mpf(0)
        for j in range(16):
            eta = mpmath.expjpi(mpf(j) / 8)
            truth = coefficients_witness(_m(centre) + _m(radius) * eta, 6)
            for k in range(6):
                coefficients, _, error = _row(series, k)
                ratio = abs(truth[k] - _polynomial_at(coefficients, eta)[0]) / _upper(error)
                worst = max(worst, ratio)
        assert mpf(2) ** (-30 - 4 * degree) < worst <= 1


def test_more_powers_of_eta_make_the_error_small() -> None:
    sizes = []
    for degree in (4, 12, 24, 36):
        series = parameter_series(fmpq(7, 2), fmpq(1, 4), degree, 12, 300)
        sizes.append(max(_upper(_row(series, k)[2]) for k in range(12)))
        assert sizes[-1] < mpf(10) ** 11 / mpf(24) ** degree
    assert sizes == sorted(sizes, reverse=True)


def test_polynomials_at_integers_are_exact() -> None:
    for n, degree in product((0, 1, 2, 5, 9), (1, 4)):
        series = parameter_series(fmpq(n), fmpq(0), degree, n + 4, 128)
        expected = [to_fraction(value) for value in polynomial(n).coeffs()] + [Fraction(0)] * (n + 4)
        for k in range(n + 4):
            coefficients, _, error = _row(series, k)
            assert error.is_zero()
            assert all(value.is_zero() for value in coefficients[1:])
            assert holds(coefficients[0], expected[k])
            assert ends(coefficients[0])[1] - ends(coefficients[0])[0] < Fraction(1, 2**90)
        # Beyond the degree of the polynomial only rounding is left.
        assert all(value < arb(2) ** -80 for value in series.omitted)


@given(_CENTRES, st.integers(-8, 8), st.integers(-8, 8))
def test_two_centres_agree_where_they_overlap(centre: Fraction, shift: int, at: int) -> None:
    """b = centre + at/16 lies in both ranges."""
    first = parameter_series(to_fmpq(centre), fmpq(1), 30, 9, 200)
    second = parameter_series(to_fmpq(centre + Fraction(shift, 16)), fmpq(1), 30, 9, 200)
    with working_bits(200):
        for k in range(9):
            found = []
            for series, eta in ((first, fmpq(at, 16)), (second, fmpq(at - shift, 16))):
                coefficients, _, error = _row(series, k)
                value = sum((c * arb(eta) ** j for j, c in enumerate(coefficients)), arb(0))
                assert value.is_finite()
                found.append(value + arb(0, error))
            assert found[0].overlaps(found[1])


@pytest.mark.parametrize(
    ("radius", "degree", "length", "bits", "match"),
    [
        (fmpq(-1, 10**30), 4, 10, 64, "radius"),
        (fmpq(3) + fmpq(1, 10**30), 4, 10, 64, "radius"),
        (fmpq(1), 0, 10, 64, "degree"),
        (fmpq(1), -3, 10, 64, "degree"),
        (fmpq(1), 4, 2, 64, "length"),
        (fmpq(1), 4, -1, 64, "length"),
        (fmpq(1), 4, 10, 1, "bits"),
    ],
)
def test_bad_input(radius: fmpq, degree: int, length: int, bits: int, match: str) -> None:
    before = current_bits()
    with pytest.raises(ValueError, match=match):
        parameter_series(fmpq(1, 2), radius, degree, length, bits)
    assert current_bits() == before


@pytest.mark.parametrize("centre", [0.5, "1/2", None])
def test_centres_that_are_not_rational_are_refused(centre: object) -> None:
    with pytest.raises(TypeError):
        parameter_series(centre, fmpq(1, 2), 4, 10, 64)  # type: ignore[arg-type]
    with pytest.raises(TypeError):
        parameter_series(fmpq(1, 2), centre, 4, 10, 64)  # type: ignore[arg-type]
