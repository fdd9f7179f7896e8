"""Theta at complex tau: laws, an independent witness, rectangles, and what is refused.

Pages: proofs/taylor.md, proofs/negative.md, proofs/majorant.md, proofs/identities.md.
"""

from __future__ import annotations

import pickle
from fractions import Fraction
from itertools import pairwise
from typing import Any

import mpmath
import pytest
from flint import acb, arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import ends, holds, near_integers, small_heights, to_fmpq
from witnesses.theta import complex_witness

from gspot_verified import BudgetError, PreparedTheta, Reason, beta_derivative, evaluate, theta, theta_by
from gspot_verified.numbers.balls import bits_for_digits, relative_bits, working_bits
from gspot_verified.numbers.complex_numbers import ExactComplex
from gspot_verified.theta_function.value import routes
from gspot_verified.theta_function.value.integer import polynomial_value

_PARTS = st.builds(Fraction, st.integers(-120, 120), st.integers(8, 12))
_BETAS = st.one_of(small_heights(), near_integers(12)).filter(lambda b: abs(b) <= 24)


def at(real: Fraction | fmpq | int, imaginary: Fraction | fmpq | int) -> ExactComplex:
    return ExactComplex(_rational(real), _rational(imaginary))


def _rational(value: Fraction | fmpq | int) -> fmpq:
    return value if isinstance(value, fmpq) else to_fmpq(value)


def contains(value: acb, witness: tuple[Fraction, Fraction], digits: int) -> bool:
    """True when the finite rectangle, widened by 10^-digits of the witness's size, contains the witness."""
    slack = (abs(witness[0]) + abs(witness[1])) / 10**digits
    return all(
        ends(part)[0] - slack <= number <= ends(part)[1] + slack
        for part, number in zip((value.real, value.imag), witness, strict=True)
    )


@given(_PARTS, _PARTS, _BETAS, st.integers(1, 40))
def test_contains_the_witness_with_the_asked_accuracy(
    real: Fraction, imaginary: Fraction, beta: Fraction, digits: int
) -> None:
    result = evaluate(at(real, imaginary), beta, digits=digits)
    assert result.reached
    assert relative_bits(result.value) >= bits_for_digits(digits)
    if beta.denominator < 10**60:
        assert contains(result.value, complex_witness(real, imaginary, beta, 60), 56)


@given(_PARTS, _PARTS, _BETAS)
def test_the_differential_equation(real: Fraction, imaginary: Fraction, beta: Fraction) -> None:
    tau = at(real, imaginary)
    value, first, third = (evaluate(tau, beta, derivative=k, digits=30).value for k in (0, 1, 3))
    with working_bits(200):
        residual = third - acb(*tau) * first + to_fmpq(beta) * value
        size = third.abs_upper() + value.abs_upper()
    assert residual.is_finite()
    assert residual.contains(0)
    assert residual.abs_upper() <= (size + first.abs_upper()) * 10**-25 * (1 + abs(acb(*tau)) + abs(beta.numerator))


@given(_PARTS, _PARTS, _BETAS)
def test_the_recurrence_in_beta(real: Fraction, imaginary: Fraction, beta: Fraction) -> None:
    tau, b = at(real, imaginary), to_fmpq(beta)
    now, before, far = (evaluate(tau, beta - k, digits=30).value for k in (0, 1, 3))
    with working_bits(200):
        other = -acb(*tau) * before + (b - 1) * (b - 2) * far
    assert now.is_finite()
    assert other.is_finite()
    assert now.overlaps(other)


@given(_PARTS, _PARTS, _BETAS, st.integers(0, 3))
def test_conjugate_tau_gives_the_conjugate_value(
    real: Fraction, imaginary: Fraction, beta: Fraction, derivative: int
) -> None:
    above, below = (evaluate(at(real, y), beta, derivative, digits=25).value for y in (imaginary, -imaginary))
    assert above.is_finite()
    assert above.conjugate().overlaps(below)
    assert above.abs_upper() == below.abs_upper()


@given(_PARTS, _PARTS, _BETAS, st.sampled_from([(1, 0), (0, 1), (3, -4)]))
def test_the_derivative_is_the_limit_of_difference_quotients_in_every_direction(
    real: Fraction, imaginary: Fraction, beta: Fraction, direction: tuple[int, int]
) -> None:
    """Taylor's theorem with the second derivative over a rectangle: no formula of the derivative's own."""
    x, y, step = to_fmpq(real), to_fmpq(imaginary), fmpq(1, 2**20)
    dx, dy = (part * step for part in direction)
    left, right = (evaluate(at(a, b), beta, digits=40).value for a, b in ((x, y), (x + dx, y + dy)))
    slope = evaluate(at(x, y), beta, derivative=1, digits=40).value
    with working_bits(200):
        near = acb(arb(x, 5 * step), arb(y, 5 * step))
        second = evaluate(near, beta, derivative=2).value
        h = acb(dx, dy)
        rest = (h * h / 2 * second).abs_upper()
        distance = (right - left - h * slope).abs_upper()
    assert distance.is_finite()
    assert distance <= rest * fmpq(3, 2) + arb(10) ** -35 * (1 + left.abs_upper())


@given(_PARTS, _BETAS, st.integers(0, 3), st.integers(1, 40))
def test_on_the_real_axis_the_value_is_the_real_one(
    tau: Fraction, beta: Fraction, derivative: int, digits: int
) -> None:
    real = theta(tau, beta, derivative, digits)
    found = theta(f"{tau}+0i", beta, derivative, digits)
    assert isinstance(found, acb)
    assert found.imag.is_zero()
    assert relative_bits(found) >= bits_for_digits(digits)
    assert found.real.overlaps(real)
    thin = theta(acb(to_fmpq(tau), arb(0, fmpq(1, 10**30))), beta, derivative, digits)
    assert thin.is_finite()
    assert thin.real.overlaps(real)
    assert thin.imag.contains(0)


@given(_PARTS, st.integers(1, 12), st.integers(0, 12))
def test_at_an_integer_it_is_the_polynomial(real: Fraction, height: int, n: int) -> None:
    """P_n(x + iy) by Python's fractions, from the coefficients of P_n."""
    x, y = real, Fraction(height, 7)
    degrees = [polynomial_value(fmpq(k), n) for k in range(n + 1)]
    value = _at_nodes(degrees, x, y)
    result = evaluate(at(x, y), n, digits=30)
    found = result.value
    assert (result.reached, result.route) == (True, "polynomial")
    assert holds(found.real, value[0])
    assert holds(found.imag, value[1])


def _at_nodes(values: list[fmpq], x: Fraction, y: Fraction) -> tuple[Fraction, Fraction]:
    """The polynomial through the values at 0, 1, 2, ..., at x + iy: Newton's differences, exactly."""
    rows = [Fraction(int(value.p), int(value.q)) for value in values]
    total, basis = (Fraction(0), Fraction(0)), (Fraction(1), Fraction(0))
    for k in range(len(values)):
        total = total[0] + rows[0] * basis[0], total[1] + rows[0] * basis[1]
        basis = (basis[0] * (x - k) - basis[1] * y) / (k + 1), (basis[0] * y + basis[1] * (x - k)) / (k + 1)
        rows = [right - left for left, right in pairwise(rows)]
    return total


@given(st.integers(-100, 60), st.integers(-80, 80), small_heights(), st.integers(-8, 8), st.integers(-8, 8))
def test_a_wide_rectangle_contains_the_values_inside(x: int, y: int, beta: Fraction, left: int, up: int) -> None:
    half = fmpq(1, 2)
    wide = evaluate(acb(arb(fmpq(x, 4), half), arb(fmpq(y, 4), half)), arb(to_fmpq(beta), fmpq(1, 8)))
    inside = evaluate(
        at(fmpq(x, 4) + fmpq(left, 16), fmpq(y, 4) + fmpq(up, 16)), to_fmpq(beta) + fmpq(left, 64), digits=30
    )
    assert wide.value.is_finite()
    assert inside.reached
    assert wide.value.contains(inside.value.mid())


@given(st.integers(-200, 60), st.integers(-100, 100), small_heights(), st.integers(5, 60),
       st.integers(-8, 8), st.integers(-8, 8))  # fmt: skip
def test_a_narrow_rectangle_contains_the_values_inside(
    x: int, y: int, beta: Fraction, bits: int, left: int, up: int
) -> None:
    r, a, b = fmpq(1, 2**bits), fmpq(x, 4), fmpq(y, 4)
    result = evaluate(ExactComplex(arb((x, -2), (1, -bits)), arb((y, -2), (1, -bits))), beta)
    inside = evaluate(at(a + r * left / 8, b + r * up / 8), beta, digits=40).value
    assert result.value.is_finite()
    assert inside.is_finite()
    assert result.value.contains(inside.mid())


@pytest.mark.parametrize(
    ("x", "y", "beta"), [(-3, 2, "7/3"), (-30, 9, "5/2"), (2, 7, "1/2"), (5, -6, "-3/2"), (0, 3, "9/2")]
)
@pytest.mark.parametrize("exponent", [-14, -30])
def test_a_narrow_rectangle_is_as_narrow_as_the_slope_allows(x: int, y: int, beta: str, exponent: int) -> None:
    """First order: of a square with side 2r the value has at most sqrt(2) r |slope| in each part."""
    r = arb((1, exponent))
    wide = evaluate(acb(arb(x, r), arb(y, r)), beta)
    slope = evaluate(at(x, y), beta, derivative=1).value.abs_upper()
    for part in (wide.value.real, wide.value.imag):
        assert part.rad() < slope * r * fmpq(3, 2)
    assert wide.value.rad() > slope * r
    assert (wide.reached, wide.reason) == (False, Reason.WIDE_INPUT)


@pytest.mark.parametrize("beta", ["7/3", "-1/2", "19/2"])
@pytest.mark.parametrize(("x", "y"), [(20, 3), (20, 30), (-20, 5), (40, -40), (60, 100), (0, 12)])
def test_an_acb_with_rounding_errors_keeps_most_digits(x: int, y: int, beta: str) -> None:
    """The series at 0 alone knows nothing there: over the rectangle it is wider than Theta is large."""
    with working_bits(53):
        tau = acb(arb(x), arb(y)) + acb(1, 1) / 3
    found = evaluate(tau, beta)
    assert relative_bits(found.value) >= 30
    assert found.value.contains(evaluate(at(x + Fraction(1, 3), y + Fraction(1, 3)), beta, digits=30).value.mid())


@pytest.mark.parametrize(("x", "y", "radius"), [(-30, 5, 5), (100, 200, 10), (2, 1, 20)])
def test_a_wide_rectangle_asks_for_no_more_bits_than_it_has(x: int, y: int, radius: int) -> None:
    """At 1000 digits no asymptotic series answers, and the series at 0 would be summed in vain."""
    with working_bits(4_000):
        width = arb(10) ** -radius
        tau = acb(arb(x, width), arb(y, width))
        few, many = (evaluate(tau, "7/3", digits=digits) for digits in (15, 1000))
        assert many.reason is Reason.WIDE_INPUT
        assert many.working_bits < 1_000
        assert many.value.rad() <= 2 * few.value.rad()
        assert many.value.overlaps(evaluate(at(x, y), "7/3", digits=40).value)


def test_a_ball_of_beta_is_a_wide_input_too() -> None:
    wide = evaluate("1+2i", arb(fmpq(7, 3), fmpq(1, 10**9)))
    assert (wide.reached, wide.reason) == (False, Reason.WIDE_INPUT)
    assert wide.value.contains(evaluate("1+2i", "7/3", digits=30).value.mid())
    far = evaluate("1e9+i", arb(1, fmpq(1, 10)))
    assert (far.route, far.reason) == ("majorant", Reason.WIDE_INPUT)
    assert far.value.is_finite()
    assert far.value.contains(evaluate("1e9+i", 1).value.mid())


def test_rectangles_over_zero_and_far_too_wide() -> None:
    for value in (acb(arb(0, 1), arb(0, 1)), acb(arb(0, 50), arb(0, 50)), acb(arb(0, 10**11), arb(0, 10**11))):
        found = evaluate(value, "7/3")
        assert found.value.is_finite()
        assert found.reason is Reason.WIDE_INPUT
        for x, y in ((0, 0), (1, -1), (0, 1)):
            assert found.value.contains(evaluate(at(x, y), "7/3", digits=40).value.mid())
    assert evaluate(acb(arb(0, 10**11), 1), "7/3").route == "majorant"


@pytest.mark.parametrize("beta", ["7/3", "-5/2", "1/2", "10", "-4", "41/2", "1/3"])
@pytest.mark.parametrize(("x", "y"), [(-40, 1), (-30, 30), (0, 45), (10, 60), (0, -60), (-50, 200)])
def test_the_sector_agrees_with_the_series_at_0(x: int, y: int, beta: str) -> None:
    tau, b = at(x, y), fmpq(*_pair(beta))
    asymptotic, series = (routes.COMPLEX_ROUTES[name](tau, b, 60) for name in ("negative", "taylor"))
    assert relative_bits(asymptotic) >= 30
    assert relative_bits(series) >= 30
    assert asymptotic.overlaps(series)


def _pair(text: str) -> tuple[int, int]:
    number = Fraction(text)
    return number.numerator, number.denominator


@pytest.mark.parametrize("tau", [
    "1e12i", "-1e12+1e12i", "-1e12-1e12i", "1e11+1e12i", "-1e12+1e-1000i", "-7e6i",
    "1e-1000+1e-1000i", "3+1e-1000i", "5+1e-310i", "1e-320-5i", "1e-162+1e-310i", f"1/3+{'3' * 300}/{'7' * 301}i",
])  # fmt: skip
@pytest.mark.parametrize("beta", [10**4, -(10**4), "19999/2", "1/2", 3, "-1/3"])
def test_corners_of_the_domain(tau: str, beta: Any) -> None:
    result = evaluate(tau, beta)
    finer = evaluate(tau, beta, digits=45)
    assert result.reached
    assert finer.reached
    assert result.value.overlaps(finer.value)
    assert result.value.contains(finer.value.mid())


@pytest.mark.slow
@pytest.mark.parametrize(("tau", "beta"), [("-700i", -(10**4)), ("500+800i", "7/3")])
def test_long_series(tau: str, beta: Any) -> None:
    found = evaluate(tau, beta)
    assert found.reached
    assert found.value.overlaps(evaluate(tau, beta, digits=18).value)


def test_many_digits_and_high_derivatives() -> None:
    for tau in ("3+4i", "-50+60i", "2-1i"):
        long, short = (evaluate(tau, "7/3", digits=digits) for digits in (1000, 20))
        assert long.reached
        assert short.reached
        assert short.value.contains(long.value.mid())
    high = evaluate("3+4i", "7/3", derivative=1000)
    assert high.reached
    assert high.value.overlaps(evaluate("3+4i", "7/3", derivative=1000, digits=60).value)


def test_the_right_hand_sector_ends_where_the_series_at_0_is_too_long() -> None:
    assert evaluate("300+100i", "7/3").reached
    for tau in ("1e9+i", "1e12+1e12i", "1e8-1e5i"):
        with pytest.raises(BudgetError, match="a smaller"):
            evaluate(tau, "7/3")


@pytest.mark.parametrize("n", [0, 1, 3, 100, 999, 1000])
def test_at_an_integer_tau_may_be_as_large_as_on_the_axis(n: int) -> None:
    for tau in ("1e12+1e12i", "1e12+1e-1000i", "3+4i", "-9i"):
        found = evaluate(tau, n)
        assert found.reached
        assert found.value.overlaps(evaluate(tau, n, digits=60).value)
        assert found.route == "polynomial"
    assert evaluate("3+4i", 1001).route == "taylor"
    assert evaluate("3+4i", -1).route == "taylor"


@pytest.mark.parametrize("n", [0, 4, 40])
def test_the_polynomial_agrees_with_the_series(n: int) -> None:
    for x, y in ((3, 4), (-30, 25), (20, 3)):
        polynomial, series = (routes.COMPLEX_ROUTES[name](at(x, y), fmpq(n), 80) for name in ("polynomial", "taylor"))
        assert relative_bits(polynomial) > 60
        assert relative_bits(series) > 20
        assert polynomial.overlaps(series)


def test_the_budget() -> None:
    found = evaluate("1+2i", "7/5", digits=1000, max_bits=200)
    assert (found.reached, found.reason) == (False, Reason.BUDGET)
    assert found.value.overlaps(evaluate("1+2i", "7/5", digits=80).value)


@pytest.mark.parametrize(("beta", "derivative"), [(0, 1), (1, 2), (3, 4), (2, 1000)])
def test_a_derivative_beyond_the_degree_is_zero(beta: int, derivative: int) -> None:
    found = evaluate("7/3+i", beta, derivative=derivative)
    assert found.value.is_zero()
    assert (found.reached, found.route) == (True, "polynomial")
    assert not evaluate("7/3+i", beta, derivative=beta).value.contains(0)


@pytest.mark.parametrize(
    "tau", [acb(arb("nan"), 1), acb(1, arb("inf")), mpmath.mpc("nan", 1), mpmath.mpc(1, "-inf"), "nani", "infi", "1+2"]
)
def test_what_is_no_finite_number_is_refused(tau: Any) -> None:
    for function in (theta, evaluate):
        with pytest.raises(ValueError, match=r"^tau: "):
            function(tau, "7/3")


@pytest.mark.parametrize("tau", ["1e13i", "2e12+i", acb(1, 10**13), acb(arb(0, 10**13), 1), "1+1e12000i"])
def test_what_lies_outside_the_domain_is_refused(tau: Any) -> None:
    with pytest.raises(ValueError, match=r"^tau: "):
        evaluate(tau, "7/3")


@pytest.mark.parametrize("tau", [1 + 2j, complex(float("nan"), 1), 0j])
def test_python_complex_numbers_are_refused_by_name(tau: Any) -> None:
    for function in (theta, evaluate):
        with pytest.raises(TypeError, match=r"^tau: a complex is not taken as exact"):
            function(tau, "7/3")


@pytest.mark.parametrize("tau", [(1, 2), [1, 2], {}, None])
def test_pairs_are_no_complex_numbers(tau: Any) -> None:
    with pytest.raises(TypeError, match=r"^tau: expected int"):
        theta(tau, "7/3")


@pytest.mark.parametrize("beta", ["1+2i", acb(1, 2), 1 + 2j, mpmath.mpc(1, 2)])
def test_a_complex_beta_is_refused_by_name(beta: Any) -> None:
    for tau in ("1+2i", 1):
        with pytest.raises((TypeError, ValueError), match=r"^beta: "):
            theta(tau, beta)


def test_what_is_real_refuses_complex_tau_by_name() -> None:
    refusing: tuple[Any, ...] = (
        lambda tau: theta_by("taylor", tau, "7/3"),
        lambda tau: beta_derivative(tau, "7/3"),
        PreparedTheta("7/3", digits=15, reach=3),
    )
    for tau in ("1+2i", acb(1, 2), 1 + 2j, mpmath.mpc(1, 2)):
        for function in refusing:
            with pytest.raises((TypeError, ValueError), match=r"^tau: "):
                function(tau)


def test_the_result_is_written_shown_and_kept() -> None:
    found = evaluate("1+2i", "7/3", digits=20)
    data = found.to_json()
    assert data["enclosure"]["real"].startswith("[0x")
    assert data["enclosure"]["imaginary"].startswith("[0x")
    assert (data["reached"], data["route"], data["reason"]) == (True, "taylor", None)
    assert (
        data["value"] == str(found) == "[0.15504776584001333542 +/- 4.24e-21] + [6.8130601435607594159 +/- 7.59e-21]i"
    )
    assert pickle.loads(pickle.dumps(found)).to_json() == data
    with pytest.raises(TypeError, match="reached"):
        bool(found)


def test_mpmath_numbers_and_texts_mean_the_same() -> None:
    values = [theta(tau, "7/3", digits=30) for tau in ("0.5-2i", acb(0.5, -2), mpmath.mpc(0.5, -2), "1/2+-2j")]
    for value in values[1:]:
        assert value.real.mid() == values[0].real.mid()
        assert value.imag.mid() == values[0].imag.mid()


def test_what_is_said_where_only_the_series_at_zero_could_reach() -> None:
    """Right of the imaginary axis; on its left the enveloping series does, at an integer beta the polynomial."""
    with pytest.raises(BudgetError, match=r"the real part of a complex tau is positive.*\|tau\| is about 1\.41e\+6\."):
        evaluate("1e6+1e6i", "1/2")
    assert evaluate("-1e6+1e6i", "1/2").reached
    assert evaluate("1e6+1e6i", 2).reached
