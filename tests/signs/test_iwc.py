"""The force at leading order. Two routes: the certified brackets, and a scan with mpmath's 1F2 or with point values."""

from __future__ import annotations

import json
from fractions import Fraction

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import to_fmpq
from witness import theta_witness

from gspot_verified import Outcome, evaluate
from gspot_verified.balls import working_bits
from gspot_verified.signs import stretches as stretches_module
from gspot_verified.signs.contact_force import ContactForce, contact_force, rounded_down
from gspot_verified.signs.count_law import number_of_zeros
from gspot_verified.signs.iwc import PAPER_EPSILON, IwcResult, _short, iwc, lift_off
from gspot_verified.signs.side import gamma_sign
from gspot_verified.signs.stretches import NotAbove, first_crossing, minimum, narrowed, stretches

BETAS = ("3/2", "7/3", "29/10", "7/2", "9/2", "27/5", "13/2", "23/3", "101/100", "399/100")
NOT_INTEGER = st.fractions(Fraction(11, 10), 8, max_denominator=12).filter(lambda beta: beta.denominator > 1)


def slope(tau: fmpq, beta: fmpq) -> Fraction:
    """dTheta/dtau by mpmath, through -beta Theta(beta - 1)."""
    b = Fraction(int(beta.p), int(beta.q))
    return -b * theta_witness(Fraction(int(tau.p), int(tau.q)), b - 1, 25)


def lift_off_sign(beta: str) -> int:
    return -(gamma_sign(beta) or 0)


def force_by_mpmath(force: ContactForce, tau: fmpq, epsilon: fmpq) -> mpmath.mpf:
    """The printed formulas with the corrected mean force, without the package's own rearrangement."""

    def number(value: fmpq | Fraction) -> mpmath.mpf:
        fraction = value if isinstance(value, Fraction) else Fraction(int(value.p), int(value.q))
        return mpmath.mpf(fraction.numerator) / fraction.denominator

    with mpmath.workdps(40):
        a1, a2, a3, beta = (number(x) for x in (force.alpha_1, force.alpha_2, force.alpha_3, force.beta))
        kappa = mpmath.power(-a1 / 2, mpmath.mpf(1) / 3)
        front = -number(force.c1) / a3 * kappa ** (1 - beta) * number(epsilon) ** ((2 * beta - 2) / 3)
        return a2 / (a3 - a1) + front * number(slope(tau, force.beta))


@pytest.mark.parametrize("beta", BETAS)
def test_the_minimum_is_below_a_scan_and_close_to_it(beta: str) -> None:
    force = contact_force(beta)
    least = minimum(stretches(force.beta, force.direction, fmpq(-4)))
    scan = [force.direction * evaluate(fmpq(k, 50), beta, derivative=1, digits=20).value for k in range(-200, 300)]
    assert all(least.value.upper() <= value.upper() + fmpq(1, 10**9) for value in scan)
    lowest = min(scan, key=lambda value: value.mid())
    assert abs(lowest - least.value) < (1 + abs(least.value)) * fmpq(1, 100)
    assert least.value.rad() < (1 + abs(least.value)) * fmpq(1, 10**12)


@pytest.mark.parametrize("beta", [*BETAS, "25/2"])
def test_critical_points_are_as_many_as_the_theorem_says(beta: str) -> None:
    force = contact_force(beta)
    found = stretches(force.beta, 1, fmpq(-10))
    assert len(found.critical) == number_of_zeros(force.beta - 1)
    for first, second in zip(found.critical, found.critical[1:], strict=False):
        assert first.upper < second.lower
    for bracket in found.critical:
        ends = [evaluate(tau, beta, derivative=2, digits=5).value for tau in (bracket.lower, bracket.upper)]
        assert ends[0] * ends[1] < 0
        assert bracket.value.contains(
            evaluate((bracket.lower + bracket.upper) / 2, beta, derivative=1, digits=40).value
        )


@settings(max_examples=25)
@given(NOT_INTEGER, st.fractions(-6, 6, max_denominator=9), st.fractions(Fraction(1, 100), 3, max_denominator=100))
def test_the_force_is_the_printed_formula(beta: Fraction, tau: Fraction, epsilon: Fraction) -> None:
    force = contact_force(beta, alpha_1="-3/2", alpha_2="-2/7", c1="-5/3")
    value = force.value(tau, epsilon, 20)
    expected = force_by_mpmath(force, to_fmpq(tau), to_fmpq(epsilon))
    assert abs(float(value.mid()) - float(expected)) <= 1e-12 * (1 + abs(float(expected)))
    with working_bits(128):
        parts = force.direction * evaluate(tau, beta, derivative=1).value + force.level(to_fmpq(epsilon))
    assert not (parts > 0 and value < 0)
    assert not (parts < 0 and value > 0)


@settings(max_examples=12, deadline=None)
@given(NOT_INTEGER, st.lists(st.fractions(-5, 30, max_denominator=50), min_size=5, max_size=5))
def test_positive_below_epsilon_0_and_negative_above(beta: Fraction, taus: list[Fraction]) -> None:
    result = iwc(beta, tau_start=-5, digits=12)
    bound = result.epsilon_0
    assert result.verdict.outcome is Outcome.PROVED
    assert bound is not None
    assert result.minimum is not None
    place = (result.minimum.lower + result.minimum.upper) / 2
    below = bound * (1 - fmpq(1, 10**9))
    assert all(result.force.value(tau, below, 30) > 0 for tau in [place, *map(to_fmpq, taus)])
    above = bound * (1 + fmpq(1, 10**9))
    if bound < fmpq(10) ** 100:
        assert result.force.value(place, above, 30) < 0
        assert force_by_mpmath(result.force, place, above * 2) < 0
        assert iwc(beta, tau_start=-5, epsilon=above, digits=12).verdict.outcome is Outcome.REFUTED
    assert force_by_mpmath(result.force, place, bound / 2) > 0
    assert iwc(beta, tau_start=-5, epsilon=below, digits=12).verdict.outcome is Outcome.PROVED


@settings(max_examples=15, deadline=None)
@given(NOT_INTEGER, st.fractions(Fraction(1, 50), 50, max_denominator=50))
def test_scaling(beta: Fraction, factor: Fraction) -> None:
    # C_1 and alpha_2 together scale the force; eps_0^p is proportional to alpha_2/C_1.
    scale = to_fmpq(factor)
    one = iwc(beta)
    charge = one.force.c1
    both = iwc(beta, c1=charge * scale, alpha_2=-scale)
    assert both.epsilon_0 == one.epsilon_0
    less, more = iwc(beta, c1=charge * scale), iwc(beta, alpha_2=-1 / scale)
    assert less.epsilon_0 == more.epsilon_0
    if one.largest_epsilon is None or less.largest_epsilon is None:
        return
    with working_bits(128):
        power = arb(one.force.exponent)
        ratio = (less.largest_epsilon / one.largest_epsilon) ** power * arb(scale)
    assert ratio.overlaps(arb(1))
    assert abs(ratio - 1) < fmpq(1, 10**9)


def test_known_numbers() -> None:
    # beta = 3/2, C_1 = 1: g is increasing, so the start decides: eps_0 = (2 (3/2) (1/2)^(1/6) / -g(-10))^3.
    result = iwc("3/2")
    with mpmath.workdps(40):
        least = mpmath.mpf(slope(fmpq(-10), fmpq(3, 2)).numerator) / slope(fmpq(-10), fmpq(3, 2)).denominator
        expected = (3 * mpmath.mpf("0.5") ** (mpmath.mpf(1) / 6) / -least) ** 3
    assert result.epsilon_0 == fmpq(17881880065137, 10**14)
    assert 0 <= expected - mpmath.mpf("0.17881880065137") < mpmath.mpf("1e-14")
    assert not result.whole_line
    assert iwc("5/2").whole_line
    assert "every τ < -10" in str(iwc("5/2"))


@pytest.mark.parametrize("beta", BETAS)
def test_lift_off_bracket(beta: str) -> None:
    force = contact_force(beta, c1=lift_off_sign(beta))
    epsilon = fmpq(1, 10**6)
    found = lift_off(force, epsilon, fmpq(-5), 10)
    assert found.verdict.outcome is Outcome.PROVED
    lower, upper = found.lower, found.upper
    assert lower is not None
    assert upper is not None
    assert 0 < upper - lower <= fmpq(1, 10**10)
    assert force.value(lower, epsilon, 25) > 0
    assert force.value(upper, epsilon, 25) < 0
    assert force_by_mpmath(force, lower - fmpq(1, 100), epsilon) > 0
    assert force_by_mpmath(force, upper + fmpq(1, 100), epsilon) < 0
    points = [fmpq(-5) + (lower + 5) * fmpq(k, 40) for k in range(41)]
    assert all(force.value(tau, epsilon) > 0 for tau in points)
    assert found.number == 1


def test_several_zeros_before_the_last_lift_off() -> None:
    # beta = 7/2, C_1 = -1: -dTheta/dtau falls through the level, rises and falls again when eps is large.
    force = contact_force("7/2", c1=-1)
    signs: list[int] = []
    epsilon = fmpq(1, 2)
    for k in range(-300, 500):
        value = force.value(fmpq(k, 100), epsilon)
        sign = 1 if value > 0 else -1
        if not signs or signs[-1] != sign:
            signs.append(sign)
    found = lift_off(force, epsilon, fmpq(-3), 8)
    assert found.number == len(signs) - 1
    beta = fmpq(11, 2)
    force = contact_force(beta, c1=-1)
    counts = {lift_off(force, fmpq(1, k), fmpq(-2), 4).number for k in range(1, 9)}
    assert 1 in counts
    assert counts <= {1, 3, 5}


def test_growth() -> None:
    result = iwc("3/2", c1=-1, growth=True)
    assert [row.epsilon for row in result.growth] == [fmpq(10) ** -n for n in (10, 100, 1_000, 10_000)]
    ratios = [row.ratio for row in result.growth]
    assert all(ratio is not None for ratio in ratios)
    distances = [abs(ratio - 1).mid() for ratio in ratios if ratio is not None]
    assert distances == sorted(distances, reverse=True)
    assert distances[-1] < fmpq(1, 500)
    assert "ε = 1e-10000: lift-off in" in str(result)


def test_between_0_and_1() -> None:
    second = iwc("1/2", alpha_2=1)
    assert second.every_epsilon
    assert second.force.case == "Case II"
    assert "every real τ and every ε > 0" in str(second.verdict)
    first = iwc("1/2")
    bound = first.epsilon_0
    assert first.force.case == "Case I"
    assert first.force.c1 == -1
    assert bound is not None
    assert "the deviation of λ_N is > 0 for every real τ" in first.verdict.detail
    assert first.force.value(-10, bound) > 0
    assert first.force.value(-10, bound * fmpq(10001, 10000)) < 0
    assert all(first.force.value(k, bound) > 0 for k in range(-9, 20))
    assert iwc("1/2", alpha_2=0).every_epsilon
    lost = iwc("1/2", c1=1)
    assert lost.verdict.outcome is Outcome.REFUTED
    assert lost.verdict.witness == "λ_N < 0 at τ = -10"
    late = iwc("1/2", c1=1, alpha_2=1, epsilon=1)
    assert late.lift_off is not None
    assert late.lift_off.number == 1
    assert late.lift_off.ratio is None


def test_every_epsilon_where_the_slope_has_one_sign() -> None:
    result = iwc("7/2", tau_start=5)
    assert result.every_epsilon
    assert result.epsilon_0 is None
    assert iwc("7/2", tau_start=5, epsilon=10**6).verdict.outcome is Outcome.PROVED


def test_a_start_inside_the_bracket_of_a_critical_point() -> None:
    beta = fmpq(5, 2)
    lower, upper = ((b.lower, b.upper) for b in stretches(beta, -1, fmpq(-10)).critical).__next__()
    inside = stretches(beta, -1, (lower + upper) / 2)
    assert len(inside.critical) == 1
    assert not inside.whole_line
    assert minimum(inside).value.overlaps(minimum(stretches(beta, -1, fmpq(-10))).value)
    beyond = stretches(beta, -1, upper)
    assert beyond.critical == ()


def test_uncertain_levels_stay_open(monkeypatch: pytest.MonkeyPatch) -> None:
    found = stretches(fmpq(7, 2), -1, fmpq(-3))
    assert first_crossing(found, lambda _: arb(0, 1000)) is None
    assert first_crossing(found, lambda _: arb.nan()) is None
    with pytest.raises(NotAbove):
        first_crossing(found, lambda _: arb(-(10**9)))
    monkeypatch.setattr("gspot_verified.signs.iwc.first_crossing", lambda *_: None)
    result = iwc("7/2", c1=-1)
    assert result.verdict.outcome is Outcome.UNDECIDED
    assert "undecided" in str(result)
    assert stretches_module.narrowed(lambda _: None, fmpq(0), fmpq(1), 3) == (0, 1)


@given(st.fractions(-5, 5, max_denominator=30), st.integers(0, 6))
def test_narrowed_keeps_the_crossing(root: Fraction, digits: int) -> None:
    target = to_fmpq(root)
    lower, upper = narrowed(lambda tau: tau > target, fmpq(-17, 3), fmpq(19, 3), digits)
    assert lower <= target < upper
    assert upper - lower <= fmpq(1, 10**digits)


@given(st.fractions(-200, 200, max_denominator=7), st.integers(1, 40))
def test_rounded_down(logarithm: Fraction, digits: int) -> None:
    with working_bits(400):
        ball = arb(to_fmpq(logarithm))
        found = rounded_down(ball, digits)
        assert found is not None
        assert arb(found).log() <= ball
        assert arb(found).log() > ball - 20 * arb(10) ** -digits or found == fmpq(10) ** 100


def test_epsilon_next_to_the_bound_is_undecided() -> None:
    result = iwc("5/2", digits=5)
    size = result.largest_epsilon
    assert size is not None
    mantissa, exponent = size.mid().man_exp()
    middle = fmpq(mantissa) * fmpq(2) ** int(exponent)
    assert iwc("5/2", digits=5, epsilon=middle).verdict.outcome is Outcome.UNDECIDED


def test_very_small_and_very_large_bounds() -> None:
    assert iwc("1.0001").epsilon_0 == fmpq(10) ** 100
    tiny = iwc("1.0001", alpha_2="-1e-40")
    assert tiny.epsilon_0 is None
    assert tiny.verdict.outcome is Outcome.UNDECIDED
    assert iwc("1.0001", alpha_2="-1e-40", epsilon="1e-600").verdict.outcome is Outcome.REFUTED


def test_short_text_is_exact() -> None:
    for value in (fmpq(1, 10**9), fmpq(7, 80), fmpq(-12345, 1000), fmpq(10) ** 25, fmpq(2, 3), fmpq(0), fmpq(1, 5**9)):
        assert Fraction(_short(value)) == Fraction(int(value.p), int(value.q))


@pytest.mark.parametrize("result", [iwc("7/3"), iwc("7/3", c1=1, growth=True), iwc("1/2", alpha_2=1)])
def test_json(result: IwcResult) -> None:
    data = json.loads(json.dumps(result.to_json()))
    assert data["verdict"]["outcome"] == "proved"
    assert data["force"]["alpha_3"] == str(result.force.alpha_3)
    assert result.lift_off is None or data["lift_off"]["epsilon"] == str(PAPER_EPSILON)


@pytest.mark.parametrize(
    ("beta", "options", "error", "message"),
    [
        (None, {}, ValueError, "beta: give beta"),
        (2, {}, ValueError, "beta: .* not an integer"),
        (None, {"alpha_1": -1, "alpha_3": -3}, ValueError, "beta: .* not an integer"),
        ("7/3", {"alpha_1": -1, "alpha_3": -2}, ValueError, "beta: 7/3 was given, but alpha_3/alpha_1 = 2"),
        ("7/3", {"alpha_3": 1}, ValueError, "alpha_3: expected a number < 0"),
        ("7/3", {"alpha_1": 0}, ValueError, "alpha_1: expected a number < 0"),
        ("7/3", {"alpha_2": 0}, ValueError, "alpha_2: Case III"),
        ("-1/2", {}, ValueError, "beta: expected a number in"),
        (0, {}, ValueError, "beta: expected a number in"),
        ("401/2", {}, ValueError, "beta: expected a number in"),
        ("7/3", {"c1": 0}, ValueError, "c1: .* canard"),
        ("7/3", {"epsilon": 0}, ValueError, "epsilon: expected a number > 0"),
        ("7/3", {"digits": 0}, ValueError, "digits"),
        ("7/3", {"tau_start": 10**7}, ValueError, "tau_start"),
        ("7/3", {"growth": True}, ValueError, "growth"),
        ("1/2", {"growth": True, "c1": 1}, ValueError, "growth"),
        (arb(2, fmpq(1, 9)), {}, ValueError, "beta: .* a ball"),
        (2.5, {}, TypeError, "beta: a float"),
        ("7/3", {"c1": 1.5}, TypeError, "c1: a float"),
        ("7/3", {"epsilon": "nan"}, ValueError, "epsilon: expected a number"),
    ],
)
def test_bad_input(beta: object, options: dict[str, object], error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        iwc(beta, **options)  # type: ignore[arg-type]


def test_bad_epsilon_of_the_force() -> None:
    with pytest.raises(ValueError, match="epsilon"):
        contact_force("7/3").value(0, 0)
