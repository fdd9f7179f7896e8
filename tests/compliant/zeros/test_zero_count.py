"""The number of real zeros at one (beta, epsilon): theorems, exact polynomials nearby, seen deviations, bad input.

Page: proofs/finite_epsilon_zeros.md.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import pairwise

import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import to_fmpq

from gspot_verified.compliant.slow.force_polynomial import distinct_real_zeros, force_polynomial
from gspot_verified.compliant.slow.slow_solution import slow_value
from gspot_verified.compliant.zeros.zero_count import slow_zeros
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.signs.gamma.count_law import number_of_zeros as law


@given(
    st.fractions(Fraction(1, 20), Fraction(4), max_denominator=40).filter(lambda beta: beta != 1), st.integers(-6, 4)
)
@settings(max_examples=30)
def test_the_law_for_beta_below_4_at_every_epsilon(beta: Fraction, tens: int) -> None:
    """Theorem D (a)."""
    found = slow_zeros(to_fmpq(beta), fmpq(10) ** tens, digits=3)
    assert found.number == law(to_fmpq(beta))
    assert len(found.places) == found.number


@pytest.mark.parametrize(
    ("beta", "epsilon", "number"),
    [
        *[(beta, "10", 1) for beta in ("5.35", "5.65", "5.95")],
        *[(beta, "1", 1) for beta in ("5.8", "5.95")],
        ("5.15", "10", 3), ("5.65", "1", 3), ("5.95", "1/10", 1), ("5.9", "1/10", 3), ("5.95", "1/100", 3),
        ("4.9", "100", 0), ("4.95", "100", 0), ("6.65", "100", 0), ("6.95", "100", 0), ("6.5", "10", 2),
        ("9/2", "1e-300", 2), ("11/2", "1e-300", 3), ("13/2", "1e-3", 2),
    ],
)  # fmt: skip
def test_deviations_from_the_law(beta: str, epsilon: str, number: int) -> None:
    assert slow_zeros(beta, epsilon, digits=3).number == number


@pytest.mark.parametrize(
    ("epsilon", "beta_f"),
    [
        ("1e-6", "5.9999625"), ("1e-3", "5.9961939"), ("1e-2", "5.982103"), (".1", "5.916976"), ("1", "5.670239"),
        ("4", "5.398791"), ("100", "4.840875"), ("500", "4.682690"),
    ],
)  # fmt: skip
def test_two_zeros_vanish_at_the_fold(epsilon: str, beta_f: str) -> None:
    """One unit of the last printed decimal on either side of the fold."""
    unit = fmpq(1, 10 ** len(beta_f.split(".")[1]))
    fold = to_fmpq(Fraction(beta_f))
    before, after = (slow_zeros(fold + side * unit, epsilon, digits=12) for side in (-1, 1))
    assert before.number is not None
    assert after.number == before.number - 2


@pytest.mark.parametrize("epsilon", ["1/1000", "1/10", "1", "31", "33", "200"])
@pytest.mark.parametrize("n", [3, 4, 5, 6, 7])
def test_next_to_an_integer_the_polynomial_tells(n: int, epsilon: str) -> None:
    """Just below beta = n + 1 the zeros are those of F_n (all simple here), just above there is one more, far out."""
    polynomial = force_polynomial(n, to_fmpq(Fraction(epsilon)))
    number = distinct_real_zeros(polynomial)
    assert slow_zeros(n + 1, epsilon).number == number
    near = fmpq(1, 10**7)
    assert slow_zeros(n + 1 - near, epsilon, digits=3).number == number
    assert slow_zeros(n + 1 + near, epsilon, digits=3).number == number + 1


@pytest.mark.parametrize(("epsilon", "number", "places"), [("31", 2, None), ("32", 1, [fmpq(1, 2)]), ("33", 0, [])])
def test_the_double_zero_at_5(epsilon: str, number: int, places: list[fmpq] | None) -> None:
    found = slow_zeros(5, epsilon)
    assert found.number == number
    if places is not None:
        assert len(found.places) == len(places)
        assert all(ball.contains(place) for ball, place in zip(found.places, places, strict=True))


@pytest.mark.parametrize(
    ("beta", "epsilon"), [("5/2", "1/10"), ("5.2", "1/100"), ("13/2", "3"), ("4.001", "1/7"), (6, 1)]
)
@pytest.mark.parametrize("digits", [5, 40])
def test_places_are_changes_of_sign(beta: str, epsilon: str, digits: int) -> None:
    found = slow_zeros(beta, epsilon, digits=digits)
    assert len(found.places) == found.number
    b = to_fmpq(Fraction(beta)) - 1
    for ball in found.places:
        low, high = (slow_value(arb(end), b, epsilon).value for end in (ball.lower(), ball.upper()))
        assert low * high < 0
    assert all(first < second for first, second in pairwise(found.places))


def test_texts_and_data() -> None:
    found = slow_zeros("5.95", "1/10")
    assert found.verdict.outcome is Outcome.PROVED
    assert str(found).startswith(
        "proved: the number of real zeros T = t/ε (p = −t) of λ − λ̄ on the slow manifold of the compliant model "
        "with α₁ = −1, C₁ ≠ 0, β = 119/20, ε = 1/10: 1 (for Θ (ε → 0): 3)\n  T = [7.394"
    )
    assert str(slow_zeros("5/2", "1/10", 3)).splitlines()[0].endswith("ε = 1/10: 2 (as for Θ)")
    assert len(str(found).splitlines()) == 2
    assert str(replace(found, places=())).splitlines()[1:] == ["  one zero more, too far out to be enclosed"]
    still_open = replace(found, number=None, places=())
    assert str(still_open) == str(still_open.verdict)
    assert still_open.verdict.outcome is Outcome.UNDECIDED
    data = found.to_json()
    assert (data["number"], data["number_for_theta"], data["route"], len(data["zeros"])) == (1, 3, "pieces", 1)
    assert slow_zeros(5, 1).to_json()["route"] == "polynomial"
    with pytest.raises(TypeError, match="number"):
        bool(found)


@pytest.mark.parametrize(
    ("beta", "epsilon", "digits", "message"),
    [
        (0, 1, 15, r"beta: expected a number in \(0, 40\]"), ("-1/2", 1, 15, r"beta: expected a number in \(0, 40\]"),
        (41, 1, 15, r"beta: expected a number in \(0, 40\]"),
        (1, 1, 15, "beta: at β = 1 there is no trivial solution"), ("nan", 1, 15, "beta"),
        ("5/2", 0, 15, "epsilon"), ("5/2", -1, 15, "epsilon"), ("5/2", "1e-301", 15, "epsilon"),
        ("5/2", 10**7, 15, "epsilon"), (arb(2, 1), 1, 15, "beta: expected one exact number"),
        ("5/2", arb(2, 1), 15, "epsilon: expected one exact number"), ("5/2", 1, 0, "digits"),
        ("5/2", 1, 101, "digits"), ("5/2", 1, True, "digits"),
    ],
)  # fmt: skip
def test_refused(beta: object, epsilon: object, digits: int, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        slow_zeros(beta, epsilon, digits)  # type: ignore[arg-type]


def test_a_float_is_refused() -> None:
    with pytest.raises(TypeError, match="beta"):
        slow_zeros(2.5, 1)  # type: ignore[arg-type]


@pytest.mark.parametrize("beta", ["5/2", "3"])
def test_a_number_that_its_pieces_do_not_hold_cannot_be_proved(beta: str) -> None:
    found = slow_zeros(beta, "1/10")
    assert found.number is not None
    assert found.verdict.outcome is Outcome.PROVED
    wrong = [replace(found, number=found.number + 1)]
    if found.column is not None:
        pieces = found.column.pieces
        wrong += [replace(found, column=None), replace(found, column=replace(found.column, pieces=pieces[1:]))]
    for each in wrong:
        with pytest.raises(ValueError, match="evidence"):
            _ = each.verdict


def test_the_largest_number_of_digits() -> None:
    (place,) = slow_zeros(2, 1, digits=100).places
    assert place.rad() < arb(10) ** -99
    with pytest.raises(ValueError, match="digits must be an int"):
        slow_zeros(2, 1, digits=101)


def test_without_a_column_the_number_stays_open(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("gspot_verified.compliant.zeros.zero_count.slow_zero_column", lambda *_: None)
    found = slow_zeros("5/2", 1)
    assert (found.number, found.column, found.places) == (None, None, ())
    assert found.verdict.outcome is Outcome.UNDECIDED
