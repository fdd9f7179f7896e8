"""The steps of proofs/smooth_trajectory.md, by other computations than those of the ledger."""

from __future__ import annotations

from fractions import Fraction
from math import factorial

import pytest
from flint import fmpq_mpoly
from hypothesis import given, settings
from hypothesis import strategies as st

from gspot_verified import Outcome
from gspot_verified.paper.section_4 import section_4_unique as ledger
from gspot_verified.paper.section_4.section_4_outer import ALGEBRA, field

NEGATIVE = st.fractions(min_value=-5, max_value=-1, max_denominator=7)
SMALL = st.fractions(min_value=Fraction(1, 50), max_value=1, max_denominator=50)


def outcome(identifier: str) -> Outcome:
    return ledger.ENTRIES[identifier]().verdict.outcome


def scaled_coefficients(alpha1: Fraction, alpha3: Fraction, epsilon: Fraction, number: int) -> list[Fraction]:
    """A_k of the page, by its recurrence."""
    found = [Fraction(1), Fraction(0), Fraction(0), Fraction(0)]
    for k in range(number - 4):
        drive = (alpha3 - (k + 1) * alpha1) * found[k + 1] + (alpha3 - k * alpha1) * found[k]
        found.append(-2 * found[k + 3] + epsilon * drive)
    return found


def derivative(series: list[Fraction], times: int) -> list[Fraction]:
    for _ in range(times):
        series = [k * a for k, a in enumerate(series)][1:]
    return series


@settings(max_examples=25, deadline=None)
@given(alpha1=NEGATIVE, alpha3=NEGATIVE, epsilon=SMALL)
def test_the_series_solves_the_equation_of_the_deviations(
    alpha1: Fraction, alpha3: Fraction, epsilon: Fraction
) -> None:
    number = 16
    series = [a / factorial(k) / epsilon**k for k, a in enumerate(scaled_coefficients(alpha1, alpha3, epsilon, number))]
    f = [derivative(series, j) for j in range(5)]
    for k in range(number - 4):
        before = [f[j][k - 1] if k else Fraction(0) for j in range(3)]
        value = alpha3 * f[0][k] - alpha1 * before[1] + epsilon * ((alpha3 - alpha1) * f[1][k] - alpha1 * before[2])
        assert value - 2 * epsilon**2 * f[3][k] - epsilon**3 * f[4][k] == 0


@settings(max_examples=25, deadline=None)
@given(alpha1=NEGATIVE, alpha3=NEGATIVE, epsilon=SMALL)
def test_the_coefficients_keep_their_bound(alpha1: Fraction, alpha3: Fraction, epsilon: Fraction) -> None:
    radius = 4 - alpha1 - alpha3
    for k, value in enumerate(scaled_coefficients(alpha1, alpha3, epsilon, 40)):
        assert abs(value) ** 3 <= radius ** (3 * k) * factorial(k)


@pytest.mark.parametrize("k", [0, 1, 2, 5])
def test_a_power_is_a_second_smooth_solution_when_beta_is_an_integer(k: int) -> None:
    # t^k in alpha3 f - alpha1 t f' with alpha3 = k alpha1: the hypothesis of the lemma is needed.
    order = ledger.ALGEBRA.read(ledger.PRINTED["4-unique"]["order n"])
    images = {"alpha3": ledger.ALGEBRA.read(f"{k}*alpha1"), "f0": ledger.ALGEBRA.read(f"t^{k}"),
              "f1": ledger.ALGEBRA.read(f"t^{k}").derivative("t")}  # fmt: skip
    assert ledger.ALGEBRA.substitute(order, images) == 0


@pytest.mark.parametrize("fraction", ["0*x", "x + w", "x - w", "2*x"])
def test_beta_must_lie_strictly_between_two_integers(monkeypatch: pytest.MonkeyPatch, fraction: str) -> None:
    assert ledger.differs_from_integers()
    monkeypatch.setitem(ledger.FRACTION, "numerator", fraction)
    assert not ledger.differs_from_integers()
    assert outcome("4-unique") is Outcome.UNDECIDED


def test_the_constants_of_the_page() -> None:
    assert Fraction(1, 4) <= Fraction(2, 3) ** 3  # 2^(-2/3) <= 2/3, so that 1/(1 - 2^(-2/3)) <= 3
    assert Fraction(7, 10) ** 2 <= Fraction(1, 2)  # 0.7 <= cos(π/4)


def test_the_system_in_rows_vanishes_along_its_own_field() -> None:
    """At ε = 2, with the rates of the field divided by ε; a rate that is wrong by 1 leaves a row."""
    at_two = {"epsilon": ALGEBRA.constant(2)}
    rates = {name: ALGEBRA.substitute(rate, at_two) / 2 for name, rate in field(True).items()}
    names = {name: (ALGEBRA.symbols[name], rates[name]) for name in "yvz"}

    def rows(names: dict[str, tuple[fmpq_mpoly, fmpq_mpoly]], rate: fmpq_mpoly) -> list[bool]:
        found = ledger._system((ALGEBRA.symbols["b0"], rate), names)
        return [bool(ALGEBRA.substitute(row, at_two).is_zero()) for row in found]

    assert rows(names, rates["b0"]) == [True] * 4
    assert rows(names, rates["b0"] + 1) == [False, True, True, True]
    for row, (name, (value, rate)) in enumerate(names.items(), start=1):
        assert rows({**names, name: (value, rate + 1)}, rates["b0"]) == [k != row for k in range(4)]
