"""The steps of proofs/monotone.md in the ledger: each coefficient and each term is looked at; what is said is tried."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction
from typing import Any

import mpmath
import pytest
from flint import acb, arb, fmpq

from gspot_verified.compliant.contact.least_value import least_value
from gspot_verified.compliant.contact.lower_polynomial import Term, lower_terms
from gspot_verified.compliant.contact.threshold import slow_force
from gspot_verified.compliant.slow.epsilon_series import series_coefficients
from gspot_verified.compliant.slow.profile import Profile
from gspot_verified.leading_order.contact_force import contact_force
from gspot_verified.leading_order.iwc import leading_order_iwc
from gspot_verified.numbers.balls import sign_of
from gspot_verified.paper.section_4_5 import compliant_model as ledger


@pytest.mark.parametrize(("k", "m"), [(1, 1), (2, 1), (12, 1), (12, 7), (12, 12), (7, 3)])
def test_every_coefficient_of_the_exponential_is_looked_at(monkeypatch: pytest.MonkeyPatch, k: int, m: int) -> None:
    def changed(order: int) -> list[fmpq]:
        found = list(series_coefficients(order))
        if order == k:
            found[m - 1] *= fmpq(1000003, 1000000)
        return found

    assert ledger.coefficients_of_the_exponential()
    monkeypatch.setattr(ledger, "series_coefficients", changed)
    assert not ledger.coefficients_of_the_exponential()


def without(b: fmpq, m: int) -> tuple[Term, ...]:
    return tuple(term for term in lower_terms(b) if term.order != term.power + 3 * m)


@pytest.mark.parametrize(("twice", "m"), [(9, 1), (17, 1), (17, 2), (23, 1), (23, 2)])
def test_a_power_of_the_polynomial_that_is_missing_is_noticed(
    monkeypatch: pytest.MonkeyPatch, twice: int, m: int
) -> None:
    assert ledger.orders_of_the_polynomial()
    assert without(fmpq(twice, 2), m) != lower_terms(fmpq(twice, 2))
    monkeypatch.setattr(ledger, "lower_terms", lambda b: without(b, m) if b == fmpq(twice, 2) else lower_terms(b))
    assert not ledger.orders_of_the_polynomial()


@pytest.mark.parametrize("twice", [9, 17, 23])
@pytest.mark.parametrize("more", [-1, 1])
def test_one_term_less_or_more_is_noticed(monkeypatch: pytest.MonkeyPatch, twice: int, more: int) -> None:
    """The last term must be negative: one more or one less has the other sign, or does not reach."""

    def changed(b: fmpq) -> tuple[Term, ...]:
        terms = lower_terms(b)
        if b != fmpq(twice, 2):
            return terms
        last = max((term for term in terms if term.order == term.power + 3), key=lambda term: term.power)
        if more < 0:
            return tuple(term for term in terms if term != last)
        return (*terms, Term(last.power + 1, last.order + 1, fmpq(1)))

    monkeypatch.setattr(ledger, "lower_terms", changed)
    assert not ledger.orders_of_the_polynomial()


def test_a_term_that_is_not_needed_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ledger, "lower_terms", lambda b: lower_terms(b) or lower_terms(fmpq(9, 2)))
    assert not ledger.orders_of_the_polynomial()


def test_what_is_said_of_cases_i_and_ii_is_tried(monkeypatch: pytest.MonkeyPatch) -> None:
    tried = []

    def slow_force(force: Any, tau: fmpq, epsilon: fmpq) -> arb:
        tried.append((force.beta, tau, epsilon))
        return arb(1)

    monkeypatch.setattr(ledger, "slow_force", slow_force)
    what = ledger.ENTRIES["C-cases-I-II"]().checks[1].what
    betas, taus, epsilons = (sorted({row[k] for row in tried}) for k in range(3))
    assert len(tried) == len(set(tried)) == 3 * 3 * 2
    assert "at three β" in what
    assert all(0 < beta < 1 for beta in betas)
    assert f"τ = {', '.join(map(str, taus))}, ε = {epsilons[0]} and {epsilons[1]}" in what


@pytest.mark.parametrize("last", [False, True])
def test_one_bound_that_is_not_found_leaves_the_check_open(monkeypatch: pytest.MonkeyPatch, last: bool) -> None:
    missing = ledger.BETAS[-1 if last else 0]

    def one_missing(beta: fmpq) -> Any:
        return replace(leading_order_iwc(beta), epsilon_0=None) if beta == missing else leading_order_iwc(beta)

    monkeypatch.setattr(ledger, "leading_order_iwc", one_missing)
    entry = ledger.ENTRIES["C-iwc-case-III"]()
    assert [check.agrees for check in entry.checks] == [True, None]
    assert f"β = {missing}:" not in entry.checks[1].finding


@pytest.mark.parametrize("missing", ["lower", "place"])
def test_a_threshold_without_its_number_or_its_place_leaves_the_check_open(
    monkeypatch: pytest.MonkeyPatch, missing: str
) -> None:
    honest = ledger.exact_threshold
    beta = ledger.BETAS[1]

    def threshold(force: Any, *arguments: Any) -> Any:
        found = honest(force, *arguments)
        return replace(found, **{missing: None}) if force.beta == beta else found

    monkeypatch.setattr(ledger, "exact_threshold", threshold)
    entry = ledger.ENTRIES["C-iwc-case-III"]()
    assert [check.agrees for check in entry.checks] == [True, None]
    assert f"β = {beta}:" not in entry.checks[1].finding


@pytest.mark.parametrize(("alpha_2", "sign"), [(fmpq(-1), -1), (fmpq(0), 1), (fmpq(1), 1)])
def test_in_case_i_the_force_may_vanish_where_its_deviation_does_not(alpha_2: fmpq, sign: int) -> None:
    """C-cases-I-II is about the deviation: in Case I (α_2 < 0) the mean force is negative, and early the sum is too."""
    force = contact_force(fmpq(1, 2), alpha_2=alpha_2)
    assert force.c1 < 0
    early, late = (slow_force(force, fmpq(tau), fmpq(1, 1000)) for tau in (-20, 0))
    assert sign_of(early) == sign
    assert sign_of(late) == 1
    assert sign < 0 or early > 1
    assert sign > 0 or abs(early + fmpq(80, 10**4)) < fmpq(1, 10**4)


@pytest.mark.parametrize("epsilon", [fmpq(1, 1000), fmpq(10), fmpq(1000)])
@pytest.mark.parametrize("beta", ledger.BELOW_ONE)
def test_the_tail_of_the_integral_holds_what_is_cut_off(
    monkeypatch: pytest.MonkeyPatch, beta: fmpq, epsilon: fmpq
) -> None:
    """Cut early, where the tail is a large part, the ball still meets that of a late cut."""
    late = {tau: ledger.positive_integral(beta, tau, epsilon) for tau in (fmpq(-20), fmpq(0), fmpq(1))}
    for far in (2, 3):
        monkeypatch.setattr(ledger, "_FAR", far)
        for tau, whole in late.items():
            early = ledger.positive_integral(beta, tau, epsilon)
            assert early.is_finite()
            assert whole.is_finite()
            assert early.overlaps(whole)


def test_where_the_cut_comes_before_the_fall_there_is_no_bound() -> None:
    assert not ledger.positive_integral(fmpq(1, 2), fmpq(72), fmpq(1)).is_finite()
    assert ledger.positive_integral(fmpq(1, 2), fmpq(71), fmpq(1)).is_finite()


def test_the_integrand_is_refused_where_its_logarithm_is_not_holomorphic() -> None:
    assert not ledger.weight_of(fmpq(1, 1000), fmpq(0), 2)(acb(arb(0, 40), arb(0, 40)), True).is_finite()


@pytest.mark.parametrize("beta", ledger.BELOW_ONE)
def test_the_integral_against_mpmath(beta: fmpq) -> None:
    epsilon, tau = fmpq(1, 10), fmpq(3, 2)
    with mpmath.workdps(25):
        b, small = (mpmath.mpf(int(x.p)) / int(x.q) for x in (beta, epsilon))
        time = mpmath.mpf(3) / 2 / mpmath.cbrt(small / 2)

        def integrand(x: mpmath.mpf) -> mpmath.mpf:
            r = x ** (1 / (1 - b))
            return mpmath.exp((r - r**2 / 2 - r**3 / 3 - mpmath.log1p(r)) / small + r * time)

        value = mpmath.quad(integrand, [0, 1, 2, 4, 8]) / (1 - b) * small ** (b - 1)
        ball = ledger.positive_integral(beta, tau, epsilon)
        assert abs(mpmath.mpf(str(ball.mid().str(25, radius=False))) / value - 1) < mpmath.mpf(10) ** -14
    assert ball.rel_accuracy_bits() > 40


def test_forces_that_are_not_the_factor_times_the_integral_are_refused() -> None:
    force, epsilon = contact_force(fmpq(1, 2), alpha_2=0), fmpq(1, 10)
    values = [slow_force(force, tau, epsilon) for tau in ledger.TAUS]
    check = ledger.is_the_factor_times_an_integral
    assert check(force, values, epsilon)
    assert not check(force, [-value for value in values], epsilon)
    assert not check(force, values[::-1], epsilon)
    for k in range(len(values)):
        for share in (fmpq(1, 10**7), fmpq(-1, 10**7)):
            changed = [value * (1 + share) if i == k else value for i, value in enumerate(values)]
            assert not check(force, changed, epsilon)
            near = [value * (1 + share / 100) if i == k else value for i, value in enumerate(values)]
            assert check(force, near, epsilon)
    with pytest.raises(ValueError, match="zip"):
        check(force, values[:2], epsilon)


def test_no_more_is_said_of_epsilon_0_than_was_found() -> None:
    """Rounded to the nearest four digits it was above the largest one that there is, which is below these numbers."""
    said = dict(re.findall(r"β = (\S+): ε_0 >= ([0-9.]+)", " ".join(c.finding for c in ledger._case_three().checks)))
    assert said == {"3/2": "0.1788", "5/2": "0.8948", "7/2": "0.01289"}
    for beta, most in (("3/2", "0.17882126"), ("5/2", "0.89488137"), ("7/2", "0.012899083")):
        assert Fraction(said[beta]) < Fraction(most)


def test_a_start_in_contact_is_needed_for_a_lift_off() -> None:
    """The note of C-lift-off: with C_1 = 1, β = 9/2 the force is negative at every τ for a large ε."""
    force, epsilon, start = contact_force(fmpq(9, 2), c1=fmpq(1)), fmpq(20000), fmpq(-50)
    profile = Profile.of(force, epsilon)
    assert not force.takes_impact
    # f^(4) > 0 on ℝ, so with these signs f decreases up to the start, and is larger there.
    assert profile.order == 4
    assert [sign_of(value) for value in profile.derivatives(start, range(5), 15)] == [1, -1, 1, -1, 1]
    least = least_value(profile, start)
    assert least is not None
    size = force.amplitude(15) * arb(epsilon) ** arb(force.exponent)
    assert arb(force.mean) - size * least.lower < 0
    assert slow_force(force, start, epsilon) < 0
