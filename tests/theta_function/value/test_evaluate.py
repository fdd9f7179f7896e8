from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import holds, near_integers, small_heights, to_fmpq, to_fraction
from witnesses.theta import contains_witness, theta_witness

from gspot_verified import Evaluation, Outcome, Reason, evaluate, theta_by
from gspot_verified.numbers.balls import (
    MAX_WORKING_BITS,
    bits_for_digits,
    nonfinite,
    relative_bits,
    sign_of,
    working_bits,
)
from gspot_verified.theta_function.value import routes
from gspot_verified.theta_function.value.integer import polynomial_value

_MODERATE = st.builds(Fraction, st.integers(-240, 160), st.integers(8, 12))


_BETAS = st.one_of(small_heights(), near_integers(12)).filter(lambda b: abs(b) <= 24)


@given(_MODERATE, _BETAS, st.integers(1, 40))
def test_contains_the_witness_with_the_asked_accuracy(tau: Fraction, beta: Fraction, digits: int) -> None:
    result = evaluate(tau, beta, digits=digits)
    assert result.reached
    assert relative_bits(result.value) >= bits_for_digits(digits)
    if max(tau.denominator, beta.denominator) < 10**60:
        assert contains_witness(result.value, theta_witness(tau, beta), 58)


@given(_MODERATE, _BETAS)
def test_differential_equation(tau: Fraction, beta: Fraction) -> None:
    value, first, third = (evaluate(tau, beta, derivative=k, digits=30).value for k in (0, 1, 3))
    with working_bits(200):
        residual = third - to_fmpq(tau) * first + to_fmpq(beta) * value
        assert residual.is_finite()
        assert residual.contains(0)


@given(_MODERATE, _BETAS)
def test_three_term_recurrence(tau: Fraction, beta: Fraction) -> None:
    b = to_fmpq(beta)
    now, before, far = (evaluate(tau, beta - k, digits=30).value for k in (0, 1, 3))
    with working_bits(200):
        assert now.is_finite()
        assert now.overlaps(-to_fmpq(tau) * before + (b - 1) * (b - 2) * far)


@given(st.integers(-60, 60), _BETAS)
def test_derivative_is_the_limit_of_difference_quotients(tau: int, beta: Fraction) -> None:
    """Taylor's theorem with the second derivative enclosed over the step: no formula of the derivative's own."""
    t, h = fmpq(tau, 7), fmpq(1, 2**20)
    left, right = evaluate(t, beta, digits=40).value, evaluate(t + h, beta, digits=40).value
    slope = evaluate(t, beta, derivative=1, digits=40).value
    second = evaluate(arb(t + h / 2, h / 2), beta, derivative=2).value
    with working_bits(200):
        assert slope.is_finite()
        assert second.is_finite()
        assert ((right - left) / h).overlaps(slope + h / 2 * second)


@given(st.integers(-100, 60), small_heights(), st.integers(0, 16), st.integers(0, 16))
def test_balls_of_width_one_contain_their_points(tau: int, beta: Fraction, left: int, right: int) -> None:
    t, b = fmpq(tau, 4), to_fmpq(beta)
    wide = evaluate(arb(t, fmpq(1, 2)), arb(b, fmpq(1, 2)))
    inside = evaluate(t + fmpq(left - 8, 16), b + fmpq(right - 8, 16), digits=30)
    assert wide.value.is_finite()
    assert wide.value.overlaps(inside.value)
    assert wide.value.contains(inside.value.mid())


@given(st.integers(-200, 60), small_heights(), st.integers(5, 60), st.integers(-8, 8))
def test_narrow_balls_of_tau_keep_first_order_accuracy(tau: int, beta: Fraction, bits: int, share: int) -> None:
    t, radius = fmpq(tau, 4), fmpq(1, 2**bits)
    result = evaluate(arb(t, radius), beta)
    inside = evaluate(t + radius * share / 8, beta, digits=40).value
    assert result.value.is_finite()
    assert result.value.contains(inside.mid())


@pytest.mark.parametrize("tau", [10**12, -(10**12), 10**6, -(10**6), 12345, -12345, 700, -700])
@pytest.mark.parametrize("beta", [10**4, -(10**4), Fraction(19999, 2), Fraction(-19999, 2), Fraction(1, 2), 3])
def test_corners_of_the_domain(tau: int, beta: Fraction) -> None:
    for digits in (15, 100):
        result = evaluate(tau, beta, digits=digits)
        assert result.reached
        finer = evaluate(tau, beta, digits=digits + 40)
        assert finer.reached
        assert result.value.overlaps(finer.value)
        assert result.value.contains(finer.value.mid())


@pytest.mark.parametrize("n", [0, 1, 2, 3, 7, 30])
@pytest.mark.parametrize("gap", [Fraction(1, 10**300), Fraction(-1, 10**300), Fraction(0)])
def test_next_to_integers(n: int, gap: Fraction) -> None:
    for tau in (-300, -7, 0, 7, 100, 300):
        result = evaluate(tau, n + gap, digits=30)
        assert result.reached
        if gap == 0:
            assert holds(result.value, to_fraction(polynomial_value(fmpq(tau), n)))
        elif tau <= 7 and polynomial_value(fmpq(tau), n) != 0:
            # Where the exponential part has not yet caught up, the value is the polynomial's to 280 digits.
            exact = to_fraction(polynomial_value(fmpq(tau), n))
            lower, upper = exact - abs(exact) / 10**25, exact + abs(exact) / 10**25
            assert lower <= to_fraction(fmpq(*_fraction_parts(result.value))) <= upper


def _fraction_parts(value: arb) -> tuple[int, int]:
    mantissa, exponent = (int(part) for part in value.mid().man_exp())
    number = Fraction(mantissa) * Fraction(2) ** exponent
    return number.numerator, number.denominator


def test_exponential_part_takes_over_next_to_an_integer() -> None:
    """beta = 2 + 10^-300: the polynomial rules at tau = 90, the exponential part of the other sign at tau = 110."""
    beta = 2 + Fraction(1, 10**300)
    assert sign_of(evaluate(90, beta).value) == 1
    assert sign_of(evaluate(110, beta).value) == -1
    assert evaluate(90, beta).value.overlaps(theta_by("taylor", 90, beta, digits=400))
    assert evaluate(110, beta).value.overlaps(theta_by("taylor", 110, beta, digits=400))


def _zero_of_the_derivative(beta: Fraction, lower: Fraction, upper: Fraction, steps: int) -> tuple[Fraction, Fraction]:
    rising = sign_of(evaluate(lower, beta, derivative=1).value)
    for _ in range(steps):
        middle = (lower + upper) / 2
        sign = sign_of(evaluate(middle, beta, derivative=1, digits=5).value)
        assert sign is not None
        lower, upper = (middle, upper) if sign == rising else (lower, middle)
    return lower, upper


def test_within_1e_minus_50_of_a_zero_of_the_derivative() -> None:
    beta = Fraction(3, 2)
    lower, upper = _zero_of_the_derivative(beta, Fraction(-1), Fraction(3), 175)
    assert upper - lower < Fraction(1, 10**50)
    signs = []
    for tau in (lower, upper):
        result = evaluate(tau, beta, derivative=1, digits=30)
        assert result.reached
        assert abs(result.value) < 1e-49
        signs.append(sign_of(result.value))
    assert signs[0] == -signs[1]


def test_next_to_a_zero_the_budget_ends_and_it_says_so() -> None:
    beta = Fraction(3, 2)
    lower, _ = _zero_of_the_derivative(beta, Fraction(-1), Fraction(3), 175)
    result = evaluate(lower, beta, derivative=1, digits=15, max_bits=100)
    assert not result.reached
    assert result.reason is Reason.BUDGET
    assert result.sign.outcome is Outcome.UNDECIDED
    assert result.value.is_finite()
    assert result.value.rad() < 1e-15  # the absolute accuracy is what the ball shows


def test_a_ball_that_holds_a_zero_stays_undecided() -> None:
    result = evaluate(arb(0, 1), 1)
    assert not result.reached
    assert result.reason is Reason.WIDE_INPUT
    assert result.sign.outcome is Outcome.UNDECIDED


@pytest.mark.parametrize("exponent", [-12, -40])
@pytest.mark.parametrize(("tau", "beta"), [(-3, "7/3"), (2, "1/2"), (-20, "-1/3")])
def test_a_narrow_ball_of_tau_is_as_wide_as_the_slope_makes_it(tau: int, beta: str, exponent: int) -> None:
    radius = arb((1, exponent))
    wide = evaluate(arb(tau, radius), beta).value
    slope = abs(evaluate(tau, beta, derivative=1, digits=20).value)
    with working_bits(128):
        assert wide.rad() < slope * radius * fmpq(11, 10)
    for side in (-1, 1):
        end = tau + side * Fraction(2) ** exponent
        assert wide.contains(evaluate(end, beta, digits=40).value)


@pytest.mark.parametrize("beta", [2, Fraction(7, 3), -1])
@pytest.mark.parametrize("radius", [Fraction(1, 8), Fraction(1, 10**9)])
def test_a_ball_of_beta_with_a_rational_tau(beta: Fraction, radius: Fraction) -> None:
    result = evaluate(-1, arb(to_fmpq(Fraction(beta)), to_fmpq(radius)))
    assert (result.reached, result.reason) == (False, Reason.WIDE_INPUT)
    assert result.value.rad() < 40 * to_fmpq(radius)
    for point in (beta - radius, Fraction(beta), beta + radius):
        assert contains_witness(result.value, theta_witness(Fraction(-1), point), 40)


def test_the_number_of_digits_is_15_when_nothing_is_said() -> None:
    found = evaluate("1/3", "7/5")
    assert found.digits == 15
    assert relative_bits(found.value) < bits_for_digits(20)


@pytest.mark.parametrize("max_bits", [0, 63, MAX_WORKING_BITS + 1])
def test_budgets_out_of_range(max_bits: int) -> None:
    with pytest.raises(ValueError, match=f"max_bits must be an int in 64..{MAX_WORKING_BITS}, got {max_bits}"):
        evaluate(1, "1/2", max_bits=max_bits)


@pytest.mark.parametrize("max_bits", [64, MAX_WORKING_BITS])
def test_the_ends_of_the_budget(max_bits: int) -> None:
    assert evaluate(1, "1/2", max_bits=max_bits).reached


@pytest.mark.parametrize(
    ("missing", "tau", "given", "reached", "reason"),
    [
        (0, 1, None, True, None),
        (0, 1, Reason.BUDGET, True, None),
        (1, 1, None, False, Reason.BUDGET),
        (1, arb(1, 1), None, False, Reason.WIDE_INPUT),
        (1, None, None, False, Reason.WIDE_INPUT),
        (1, arb(1, 1), Reason.BUDGET, False, Reason.BUDGET),
        (1, 1, Reason.WIDE_INPUT, False, Reason.WIDE_INPUT),
    ],
)
def test_reached_is_what_the_ball_shows(
    monkeypatch: pytest.MonkeyPatch, missing: int, tau: Any, given: Reason | None, reached: bool, reason: Reason | None
) -> None:
    """Exactly the asked bits are enough, one less is not; a reason is there exactly when they are missing."""
    goal = bits_for_digits(15)
    value = next(v for n in range(200) if relative_bits(v := arb(1, arb((1, -n)))) == goal - missing)
    monkeypatch.setattr(
        "gspot_verified.theta_function.value.evaluate._enclose", lambda *_: (value, "taylor", 99, given)
    )
    found = evaluate(tau, "1/2") if tau is not None else evaluate(1, arb(1, 1))  # a ball of either argument
    assert (found.reached, found.reason, found.route, found.working_bits) == (reached, reason, "taylor", 99)


@pytest.mark.parametrize("reason", [Reason.BUDGET, Reason.WIDE_INPUT])
def test_an_undecided_sign_says_why(reason: Reason) -> None:
    assert Evaluation(arb(0, 1), 15, False, "taylor", 64, reason).sign.reason is reason
    assert Evaluation(arb(0, 1), 15, False, "taylor", 64).sign.reason is Reason.WIDE_INPUT


def test_exact_zeros_are_exact() -> None:
    assert evaluate(0, 1).value.is_zero()
    assert evaluate(5, 3, derivative=4).value.is_zero()
    assert evaluate(0, 1).sign.outcome is Outcome.PROVED


@pytest.mark.parametrize(("beta", "derivative"), [(0, 1), (1, 2), (3, 4), (2, 1000)])
def test_a_derivative_beyond_the_degree_is_zero_without_work(
    monkeypatch: pytest.MonkeyPatch, beta: int, derivative: int
) -> None:
    degree = evaluate("7/3", beta, derivative=beta).value
    monkeypatch.setattr(routes, "ROUTES", {})
    found = evaluate("7/3", beta, derivative=derivative)
    assert found.value.is_zero()
    assert (found.reached, found.route, found.working_bits) == (True, "polynomial", 0)
    assert not degree.contains(0)


@pytest.mark.parametrize("tau", ["-50", "-1000", "9.99", "30"])
def test_where_ordinary_1f2_is_garbage(tau: str) -> None:
    """FLINT at 53 bits knows nothing at tau = -50; here 15 digits, agreeing with a route that is not asymptotic."""
    result = evaluate(tau, "7/3")
    assert result.reached
    with working_bits(53):
        z = arb(fmpq(-50) ** 3 / 9)
        plain = z.hypgeom([arb(fmpq(-7, 9))], [arb(1) / 3, arb(2) / 3])
    assert relative_bits(plain) <= 0
    if abs(Fraction(tau)) <= 50:
        assert result.value.overlaps(theta_by("taylor", tau, "7/3", digits=40))


@pytest.mark.parametrize("digits", [1, 2, 15, 16, 100, 1000, 3000])
@pytest.mark.parametrize(("tau", "beta"), [("-7/3", "1/2"), ("7/3", "7/3"), ("-50", "7/5"), ("1/3", "-5/2")])
def test_accuracy_requests(digits: int, tau: str, beta: str) -> None:
    result = evaluate(tau, beta, digits=digits)
    assert result.reached
    assert result.value.overlaps(theta_by("taylor", tau, beta, digits=max(20, digits // 2)))


def test_a_hundred_thousand_digits() -> None:
    result = evaluate("7/3", "1/2", digits=100_000)
    assert result.reached
    assert result.route == "splitting"
    assert result.value.overlaps(theta_by("laplace", "7/3", "1/2", digits=60))
    assert result.value.overlaps(theta_by("splitting", "7/3", "1/2", digits=100_500))


@pytest.mark.parametrize("k", [0, 1, 2, 3, 5, 20, 100])
def test_derivatives_by_differentiating_the_series(k: int) -> None:
    """The shift of beta against the differentiated Taylor polynomial, which uses no shift."""
    from gspot_verified.theta_function.sums.taylor import taylor_coefficients

    tau, beta = fmpq(-5, 4), fmpq(7, 3)
    with working_bits(400):
        a = taylor_coefficients(beta, 240, 400)
        total, falling = arb(0), arb(math.factorial(k))
        for n in range(k, 240):
            total += a[n] * falling * tau ** (n - k)
            falling = falling * (n + 1) / (n + 1 - k)
    value = evaluate(tau, beta, derivative=k, digits=30).value
    assert value.is_finite()
    assert abs(value - total) <= abs(value) * 1e-25


def test_json() -> None:
    data = evaluate(-50, "7/3", digits=20).to_json()
    assert data["reached"] is True
    assert data["route"] == "negative"
    assert data["enclosure"].startswith("[0x")
    assert data["reason"] is None
    nothing = Evaluation(nonfinite(), 15, False, "majorant", 64, Reason.WIDE_INPUT).to_json()
    assert (nothing["enclosure"], nothing["reason"]) == (None, "wide_input")


@pytest.mark.parametrize(("beta", "digits", "answered"), [
    ("1000/1003", 10**6, False), ("1/1001", 310_000, False), ("1/1001", 290_000, True), ("-1/1000", 10**6, True),
])  # fmt: skip
def test_long_denominators_at_very_many_digits_are_refused_beforehand(
    monkeypatch: pytest.MonkeyPatch, beta: str, digits: int, answered: bool
) -> None:
    """1000/1003 at 10^6 digits was silent for minutes, inside one call of FLINT."""
    started: list[int] = []

    def sum_instead(_tau: Any, _beta: Any, _length: int, bits: int, *_: Any) -> arb:
        started.append(bits)
        return arb(1)

    for name in ("splitting_sum", "taylor_sum"):
        monkeypatch.setattr(routes, name, sum_instead)
    if answered:
        assert evaluate("1/2", beta, digits=digits).value == 1
        assert len(started) == 1
    else:
        with pytest.raises(routes.BudgetError, match=r"fewer digits.* a beta of smaller denominator"):
            evaluate("1/2", beta, digits=digits)
        assert started == []
