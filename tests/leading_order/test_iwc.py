"""The force at leading order. Two routes: the certified brackets, and a scan with mpmath's 1F2 or with point values.

Page: proofs/iwc.md.
"""

from __future__ import annotations

import json
from fractions import Fraction

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import to_fmpq
from witnesses.force import force_by_mpmath, slope

from gspot_verified import Outcome, theta
from gspot_verified.leading_order.contact_force import contact_force
from gspot_verified.leading_order.iwc import (
    PAPER_EPSILON,
    IwcResult,
    _exponential,
    _log_bounds,
    at_epsilon,
    leading_order_iwc,
)
from gspot_verified.leading_order.stretches import Bracket, stretches
from gspot_verified.numbers.balls import ball_text, working_bits
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.numbers.short_text import decimal_text
from gspot_verified.signs.zeros.brackets import zeros_at

NOT_INTEGER = st.fractions(Fraction(11, 10), 8, max_denominator=12).filter(lambda beta: beta.denominator > 1)


@settings(max_examples=12, deadline=None)
@given(NOT_INTEGER, st.lists(st.fractions(-5, 30, max_denominator=50), min_size=5, max_size=5))
def test_positive_below_epsilon_0_and_negative_above(beta: Fraction, taus: list[Fraction]) -> None:
    result = leading_order_iwc(beta, tau_start=-5, digits=12)
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
        assert leading_order_iwc(beta, tau_start=-5, epsilon=above, digits=12).verdict.outcome is Outcome.REFUTED
    assert force_by_mpmath(result.force, place, bound / 2) > 0
    assert leading_order_iwc(beta, tau_start=-5, epsilon=below, digits=12).verdict.outcome is Outcome.PROVED


@settings(max_examples=15, deadline=None)
@given(NOT_INTEGER, st.fractions(Fraction(1, 50), 50, max_denominator=50))
def test_scaling(beta: Fraction, factor: Fraction) -> None:
    # C_1 and alpha_2 together scale the force; eps_0^p is proportional to alpha_2/C_1.
    scale = to_fmpq(factor)
    one = leading_order_iwc(beta)
    charge = one.force.c1
    both = leading_order_iwc(beta, c1=charge * scale, alpha_2=-scale)
    assert both.epsilon_0 == one.epsilon_0
    less, more = leading_order_iwc(beta, c1=charge * scale), leading_order_iwc(beta, alpha_2=-1 / scale)
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
    result = leading_order_iwc("3/2")
    with mpmath.workdps(40):
        least = mpmath.mpf(slope(fmpq(-10), fmpq(3, 2)).numerator) / slope(fmpq(-10), fmpq(3, 2)).denominator
        expected = (3 * mpmath.mpf("0.5") ** (mpmath.mpf(1) / 6) / -least) ** 3
    assert result.epsilon_0 == fmpq(17881880065137, 10**14)
    assert 0 <= expected - mpmath.mpf("0.17881880065137") < mpmath.mpf("1e-14")
    assert not result.whole_line
    assert leading_order_iwc("5/2").whole_line
    assert "every τ < -10" in str(leading_order_iwc("5/2"))


def test_between_0_and_1() -> None:
    second = leading_order_iwc("1/2", alpha_2=1)
    assert second.every_epsilon
    assert second.force.case == "II"
    assert "every real τ and every ε > 0" in str(second.verdict)
    first = leading_order_iwc("1/2")
    bound = first.epsilon_0
    assert first.force.case == "I"
    assert first.force.c1 == -1
    assert bound is not None
    assert "the deviation of λ_N is > 0 for every real τ" in first.verdict.detail
    assert first.force.value(-10, bound) > 0
    assert first.force.value(-10, bound * fmpq(10001, 10000)) < 0
    assert all(first.force.value(k, bound) > 0 for k in range(-9, 20))
    assert leading_order_iwc("1/2", alpha_2=0).every_epsilon
    lost = leading_order_iwc("1/2", c1=1)
    assert lost.verdict.outcome is Outcome.REFUTED
    assert lost.verdict.witness == "λ_N < 0 at τ = -10"
    late = leading_order_iwc("1/2", c1=1, alpha_2=1, epsilon=1)
    assert late.lift_off is not None
    assert late.lift_off.number == 1
    assert late.lift_off.ratio is None


def test_every_epsilon_where_the_slope_has_one_sign() -> None:
    result = leading_order_iwc("7/2", tau_start=5)
    assert result.every_epsilon
    assert result.epsilon_0 is None
    assert leading_order_iwc("7/2", tau_start=5, epsilon=10**6).verdict.outcome is Outcome.PROVED


def test_epsilon_next_to_the_bound_is_undecided() -> None:
    result = leading_order_iwc("5/2", digits=5)
    size = result.largest_epsilon
    assert size is not None
    mantissa, exponent = size.mid().man_exp()
    middle = fmpq(mantissa) * fmpq(2) ** int(exponent)
    assert leading_order_iwc("5/2", digits=5, epsilon=middle).verdict.outcome is Outcome.UNDECIDED


QUARTERS = [fmpq(k, 4) for k in range(6, 24) if k % 4]


def witness_of(result: IwcResult) -> fmpq:
    """The number in "λ_N < 0 at τ = p/q"."""
    number = Fraction((result.verdict.witness or "").removeprefix("λ_N < 0 at τ = "))
    return to_fmpq(number)


@pytest.mark.parametrize("digits", [1, 2, 3])
@pytest.mark.parametrize("beta", QUARTERS, ids=str)
def test_a_start_in_the_bracket_of_a_critical_point(beta: fmpq, digits: int) -> None:
    """A witness lies in the range that was asked about, and what is proved holds at the critical points."""
    critical = [(lower + upper) / 2 for lower, upper in zeros_at(beta - 1, 30).brackets]
    for lower, upper in zeros_at(beta - 1, digits).brackets:
        for share in (fmpq(0), fmpq(1, 10), fmpq(1, 2), fmpq(7, 10), fmpq(9, 10), fmpq(1)):
            start = lower + share * (upper - lower)
            for epsilon in (fmpq(10) ** 6, fmpq(1, 5), fmpq(1, 10**4)):
                result = leading_order_iwc(beta, tau_start=start, digits=digits, epsilon=epsilon)
                places = [start, *(tau for tau in critical if tau > start)]
                forces = [result.force.value(tau, epsilon, 30) for tau in places]
                if result.verdict.outcome is Outcome.REFUTED:
                    assert witness_of(result) >= start
                    assert result.force.value(witness_of(result), epsilon, 30) < 0
                if result.verdict.outcome is Outcome.PROVED:
                    assert all(force > 0 for force in forces)
                if result.minimum is not None:
                    assert start <= result.minimum.lower <= result.minimum.upper


def test_the_witness_is_not_the_middle_of_a_bracket_that_begins_before_the_start() -> None:
    result = leading_order_iwc("5/2", tau_start="77/100", digits=1, epsilon=10**6)
    assert result.verdict.statement.endswith("λ_N > 0 for every τ in [77/100, inf) at ε = 1000000")
    assert result.verdict.outcome is Outcome.REFUTED
    assert witness_of(result) >= fmpq(77, 100)


def test_epsilon_0_itself_is_not_below_epsilon_0() -> None:
    """The statement is for eps < eps_0: at the bound itself, where log 1 = 0 is exact, nothing is proved."""
    result = leading_order_iwc("5/2")
    found = stretches(fmpq(5, 2), -1, fmpq(-10))
    assert result.largest_epsilon is not None
    assert result.largest_epsilon < fmpq(3)
    one = at_epsilon(result.force, found, fmpq(1), arb(0))
    assert one.outcome is not Outcome.PROVED
    assert at_epsilon(result.force, found, fmpq(1), arb(fmpq(1, 1024))).outcome is Outcome.PROVED


def test_it_holds_to_the_left_of_the_start_only_where_the_function_decreases_there() -> None:
    """For 7/2 λ_N < 0 far to the left; for 9/2 only a start before all critical points serves."""
    rising = leading_order_iwc("7/2")
    assert rising.epsilon_0 is not None
    assert rising.force.value(-(10**4), rising.epsilon_0) < 0
    assert not rising.whole_line
    falling = leading_order_iwc("9/2")
    assert falling.epsilon_0 is not None
    assert falling.whole_line
    assert all(falling.force.value(-(10**k), falling.epsilon_0, 30) > 0 for k in range(1, 6))
    assert not leading_order_iwc("9/2", tau_start=6).whole_line


def test_very_small_and_very_large_bounds() -> None:
    assert leading_order_iwc("1.0001").epsilon_0 == fmpq(10) ** 100
    tiny = leading_order_iwc("1.0001", alpha_2="-1e-40")
    assert tiny.epsilon_0 is None
    assert tiny.verdict.outcome is Outcome.UNDECIDED
    assert leading_order_iwc("1.0001", alpha_2="-1e-40", epsilon="1e-600").verdict.outcome is Outcome.REFUTED


@pytest.mark.parametrize(
    "result",
    [leading_order_iwc("7/3"), leading_order_iwc("7/3", c1=1, growth=True), leading_order_iwc("1/2", alpha_2=1)],
)
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
        ("7/3", {"epsilon": 0, "c1": 1}, ValueError, "epsilon: expected a number > 0"),
        ("7/3", {"epsilon": 0, "c1": -1}, ValueError, "epsilon: expected a number > 0"),
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
        leading_order_iwc(beta, **options)  # type: ignore[arg-type]


def test_for_beta_between_1_and_2_only_the_half_line_is_stated() -> None:
    """From 5 on dΘ/dτ > 0: every ε serves there, and nothing is said of the τ before."""
    late = leading_order_iwc("3/2", tau_start=5)
    assert (late.verdict.outcome, late.every_epsilon, late.whole_line) == (Outcome.PROVED, True, False)
    assert late.verdict.statement.endswith("C1 = 1: λ_N > 0 for every τ in [5, inf) and every ε > 0")
    assert late.verdict.detail == leading_order_iwc("3/2").verdict.detail == ""
    assert leading_order_iwc("3/2").force.value(-10, 10**6) < 0
    whole = leading_order_iwc("1/2", alpha_2=1).verdict
    assert whole.statement.endswith(": λ_N > 0 for every real τ and every ε > 0")
    assert "proofs/signs.md" in whole.detail
    refuted = leading_order_iwc("5/2", epsilon=2).verdict
    assert refuted.outcome is Outcome.REFUTED
    assert "for all" not in (refuted.witness or "")


@pytest.mark.parametrize(("low", "high"), [(-4, -2), (-100, -1)])
def test_the_largest_epsilon_is_enclosed_over_the_whole_ball_of_the_least_value(low: int, high: int) -> None:
    force = contact_force("5/2")
    least = arb(low).union(arb(high))
    lower, upper = _log_bounds(force, least, 15)
    at_low, at_high = (force.log_epsilon(arb(slope), 30) for slope in (low, high))
    assert lower <= at_low.upper()
    assert at_high.lower() <= upper
    assert lower > at_low - fmpq(1, 10**6)
    assert upper < at_high + fmpq(1, 10**6)
    assert not _log_bounds(force, arb(0, 1), 15)[1].is_finite()


def test_a_bound_of_epsilon_that_no_number_shows_is_left_out() -> None:
    assert _exponential(arb(-(10**9)), arb(0)) is None
    assert _exponential(arb(0), arb(10**9)) is None
    assert _exponential(arb.nan(), arb(0)) is None
    assert _exponential(arb(0), arb.nan()) is None
    size = _exponential(arb(0), arb(1))
    assert size is not None
    assert size.contains(1)
    assert size.contains(arb(1).exp())


def test_texts_of_both_sides() -> None:
    impact, flight = leading_order_iwc("5/2"), leading_order_iwc("7/3", c1=1)
    assert "the side C1/Γ(-β) > 0, λ_N → +∞" in str(impact)
    assert "the side C1/Γ(-β) < 0, λ_N → -∞" in str(flight)
    assert impact.largest_epsilon is not None
    assert f"the largest ε0 possible at leading order: {ball_text(impact.largest_epsilon, 15)}" in str(impact)
    assert impact.minimum is not None
    assert f"at τ in {decimal_text(impact.minimum.lower, impact.minimum.upper)}" in str(impact)
    assert "at τ = -10\n" in str(leading_order_iwc("3/2"))
    assert "the largest" not in str(flight)
    assert flight.lift_off is not None
    assert flight.lift_off.epsilon == fmpq(1, 1000)
    assert f"\n  {flight.lift_off}\n" in str(flight)
    assert "lift-off" not in str(impact)
    assert "None" not in str(impact) + str(flight)


def test_json_of_what_is_there_and_what_is_not() -> None:
    impact, every = leading_order_iwc("5/2"), leading_order_iwc("7/2", tau_start=5)
    assert impact.minimum is not None
    data = impact.to_json()
    assert data["minimum_at"] == [str(impact.minimum.lower), str(impact.minimum.upper)]
    assert data["epsilon_0"] == str(impact.epsilon_0)
    assert data["lift_off"] is None
    data = every.to_json()
    assert (data["every_epsilon"], data["epsilon_0"], data["largest_epsilon"]) == (True, None, None)


@pytest.mark.parametrize("digits", [40, 60, 100])
def test_many_digits_are_proved(digits: int) -> None:
    """The comparison of epsilon_0 with what bounds it has as many bits as its digits ask for."""
    found = leading_order_iwc("3/2", digits=digits)
    assert found.verdict.outcome is Outcome.PROVED
    few = leading_order_iwc("3/2", digits=20).epsilon_0
    assert found.epsilon_0 is not None
    assert few is not None
    assert 0 <= found.epsilon_0 - few < fmpq(1, 10**20)


def test_the_most_digits() -> None:
    found = leading_order_iwc("5/2", digits=100)
    assert found.epsilon_0 is not None
    assert found.epsilon_0 * 10**100 == (found.epsilon_0 * 10**100).floor()
    assert found.epsilon_0 * 10**90 != (found.epsilon_0 * 10**90).floor()
    with pytest.raises(ValueError, match=r"digits must lie in 1\.\.100"):
        leading_order_iwc("5/2", digits=101)


def test_where_the_half_line_may_start() -> None:
    for start in (10**6, -(10**6)):
        assert leading_order_iwc("5/2", tau_start=start, digits=3).start == start
    for start in (10**6 + 1, -(10**6) - 1):
        with pytest.raises(ValueError, match=r"tau_start: expected \|tau_start\| <= 1000000"):
            leading_order_iwc("5/2", tau_start=start)


def test_the_text_line_by_line() -> None:
    """Each line is there when its number is, and says it."""
    impact = leading_order_iwc("9/2", alpha_2=-2, c1="-7/3")
    lines = impact.lines()
    assert lines[0] == str(impact.verdict)
    assert lines[1] == "  Case III: β = 9/2, α1 = -1, α2 = -2, α3 = -4.5, C1 = -7/3: the side C1/Γ(-β) > 0, λ_N → +∞"
    assert (
        lines[2]
        == "  at leading order λ_N = 4/7 - (C1/α3) κ^(1-β) ε^(7/3) dΘ/dτ, κ^3 = 0.5, τ = κ t ε^(-2/3), p = α1 t"
    )
    assert [line.split(":")[0].strip() for line in lines[3:5]] == [
        "least value of sign(C1) dΘ/dτ on [-10, inf)", "the largest ε0 possible at leading order"
    ]  # fmt: skip
    assert lines[5:] == ["  it holds for every τ < -10 as well"]
    assert str(impact).splitlines()[:-1] == lines
    assert impact.epsilon_0 is not None
    above = leading_order_iwc("9/2", alpha_2=-2, c1="-7/3", epsilon=impact.epsilon_0 * 2)
    assert above.verdict.outcome is Outcome.REFUTED
    assert "it holds" not in str(above)
    assert "it holds" not in str(leading_order_iwc("9/2", tau_start=6))
    every = leading_order_iwc("1/2", alpha_2=1)
    assert every.whole_line
    assert "it holds" not in str(every)
    # The statement is about every real τ, the value is not: it is less further to the left.
    assert "every real τ" in every.verdict.statement
    assert every.minimum is not None
    assert -theta(-20, "1/2", derivative=1) < every.minimum.value
    assert "  least value of sign(C1) dΘ/dτ on [-10, inf): " in str(every)
    assert "  no Case, between I and II: β = 1/2" in str(leading_order_iwc("1/2", alpha_2=0))
    flight = leading_order_iwc("7/3", c1=1, growth=True)
    assert len(flight.growth) == 4
    assert [line.strip() for line in flight.lines()[3:7]] == [str(row) for row in (flight.lift_off, *flight.growth[:3])]
    assert "as well" not in str(flight)  # λ_N < 0 far to the left
    left = leading_order_iwc("3/2", c1=-1)
    assert left.lines()[-1] == "  λ_N > 0 for every τ < -10 as well"


def test_each_field_of_the_json() -> None:
    impact, flight = leading_order_iwc("5/2"), leading_order_iwc("7/3", c1=1, growth=True)
    assert impact.minimum is not None
    assert impact.largest_epsilon is not None
    assert flight.lift_off is not None
    assert impact.to_json() == {
        "force": impact.force.to_json(),
        "start": "-10",
        "whole_line": True,
        "verdict": impact.verdict.to_json(),
        "minimum": str(Dyadic.from_ball(impact.minimum.value)),
        "minimum_at": [str(impact.minimum.lower), str(impact.minimum.upper)],
        "every_epsilon": False,
        "epsilon_0": str(impact.epsilon_0),
        "largest_epsilon": str(Dyadic.from_ball(impact.largest_epsilon)),
        "lift_off": None,
        "growth": [],
    }
    data = flight.to_json()
    assert (data["minimum"], data["minimum_at"], data["epsilon_0"], data["largest_epsilon"]) == (None,) * 4
    assert data["lift_off"] == flight.lift_off.to_json()
    assert data["growth"] == [row.to_json() for row in flight.growth]
    assert data["every_epsilon"] is False


def test_an_epsilon_0_that_is_not_certainly_below_the_threshold_is_undecided(monkeypatch: pytest.MonkeyPatch) -> None:
    known = leading_order_iwc("3/2", c1=1)
    assert known.largest_epsilon is not None
    for epsilon_0 in (fmpq(9, 50), fmpq(1)):  # the largest is 0.1788...
        monkeypatch.setattr("gspot_verified.leading_order.iwc.rounded_down", lambda *_, given=epsilon_0: given)
        assert leading_order_iwc("3/2", c1=1).verdict.outcome is Outcome.UNDECIDED
    monkeypatch.setattr("gspot_verified.leading_order.iwc.rounded_down", lambda *_: fmpq(17, 100))
    assert leading_order_iwc("3/2", c1=1).verdict.outcome is Outcome.PROVED


def test_a_least_value_on_both_sides_of_0_is_not_at_least_0(monkeypatch: pytest.MonkeyPatch) -> None:
    """No bound for every eps then: what is certain is the lower end, and no upper bound of the largest eps."""
    monkeypatch.setattr("gspot_verified.leading_order.iwc.minimum", lambda _: Bracket(fmpq(0), fmpq(1), arb(0, 1)))
    result = leading_order_iwc("5/2")
    assert not result.every_epsilon
    assert result.largest_epsilon is None
    assert result.epsilon_0 is not None
    with working_bits(128):
        bound = result.force.log_epsilon(arb(-1), 30)
        assert arb(result.epsilon_0).log() <= bound
        assert arb(result.epsilon_0).log() > bound - fmpq(1, 10**6)


def test_below_beta_1_the_largest_epsilon_is_enclosed_too() -> None:
    """Case I: the mean force is negative, the deviation positive and least at the start."""
    first = leading_order_iwc("1/2")
    assert first.largest_epsilon is not None
    assert first.largest_epsilon.is_finite()
    assert first.epsilon_0 is not None
    assert fmpq(999999, 10**6) * first.largest_epsilon < first.epsilon_0
    assert first.epsilon_0 <= first.largest_epsilon.upper()
    below, above = first.largest_epsilon * fmpq(999, 1000), first.largest_epsilon * fmpq(1001, 1000)
    assert first.force.value(-10, to_fmpq(Fraction(float(below)))) > 0
    assert first.force.value(-10, to_fmpq(Fraction(float(above)))) < 0


def test_a_growth_table_between_1_and_2() -> None:
    assert [row.verdict.outcome for row in leading_order_iwc("3/2", c1=-1, growth=True).growth] == [Outcome.PROVED] * 4


@pytest.mark.parametrize("backwards", [False, True])
def test_no_verdict_hangs_on_the_order_of_the_places(monkeypatch: pytest.MonkeyPatch, backwards: bool) -> None:
    """The places are tried one after the other, and each is refused or is a witness by a certain comparison."""
    monkeypatch.setattr(
        "gspot_verified.leading_order.iwc.sorted",
        lambda pieces, **_: list(pieces)[:: -1 if backwards else 1],
        raising=False,
    )
    for epsilon, outcome in ((1, Outcome.REFUTED), ("1/2", Outcome.PROVED)):
        verdict = leading_order_iwc("5/2", epsilon=epsilon, digits=6).verdict
        assert verdict.outcome is outcome
        if outcome is Outcome.REFUTED:
            assert str(verdict.against).endswith("< 0")
