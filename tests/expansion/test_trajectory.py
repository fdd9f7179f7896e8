"""The result of an expansion: text, values, refusals."""

from __future__ import annotations

import json
import warnings
from dataclasses import FrozenInstanceError, replace
from fractions import Fraction
from typing import Any

import pytest
from flint import arb, fmpq, fmpq_poly
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import holds, to_fraction

from gspot_verified import expand
from gspot_verified.expansion.series.spaces import SpacePolynomial
from gspot_verified.expansion.trajectory import (
    AccuracyWarning,
    certain_bits,
    expand_in_balls,
    expand_system,
    scaled_value,
    until_accurate,
    value_in_time,
)
from gspot_verified.functions.rings import BALLS, RATIONALS
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.numbers.balls import bits_for_digits, current_bits, working_bits
from gspot_verified.testing import extended_example

EXAMPLE = expand_system(extended_example(1), 7)


def test_text() -> None:
    lines = str(EXAMPLE).splitlines()
    assert lines[0] == "extended example: the distinguished trajectory of Theorem 1, orders of delta below 7"
    assert "  v/delta^4 = -16 delta^2 - 96 s delta^4 + 48 delta^5 - 2208/5 s^2 delta^6 + O(delta^7)" in lines
    assert lines[-2].startswith("  z/delta^6 = -2 - 8 s delta^2 + 8 delta^3 - 24 s^2 delta^4 + 48 s delta^5")
    assert str(expand_system(extended_example(1), 1)).splitlines()[-3] == "  v/delta^4 = O(delta)"


def test_latex() -> None:
    lines = EXAMPLE.to_latex().splitlines()
    assert (lines[0], lines[-1]) == (r"\begin{align*}", r"\end{align*}")
    assert lines[5] == (
        r"  \delta^{-2}(\xi_{5} - \xi_{5}^*) &= -s + s^{2} \delta^{2} + 2 s^{3} \delta^{4}"
        r" + (3 s^{4} - 96 s) \delta^{6} + \mathcal{O}(\delta^{7}) \\"
    )
    assert lines[-2].startswith(r"  \lambda_{n} &= 2")
    assert r"\frac{368}{5} s^{3}" in lines[-2]
    assert not lines[-2].endswith(r"\\")


def test_json_is_exact() -> None:
    data = json.loads(json.dumps(EXAMPLE.to_json()))
    assert (data["name"], data["order"]) == ("extended example", 7)
    assert data["contact"]["z"][6] == ["6672/5", "0", "0", "-368/5"]
    for name, terms in EXAMPLE.terms().items():
        assert [
            [fmpq(*map(int, text.split("/"))) for text in row] for row in {**data["state"], **data["contact"]}[name]
        ] == [term.coefficients() for term in terms]


def test_json_of_balls() -> None:
    base = extended_example("1/3")
    trajectory = expand_system(replace(base, point=(arb(0),) * 6, ring=BALLS), 4)
    text = trajectory.to_json()["contact"]["b"][2][2]
    assert isinstance(text, str)
    assert "O(delta^4)" in str(trajectory)


rational = st.fractions(-2, 2, max_denominator=50)


@given(rational, rational)
def test_values(s: Fraction, delta: Fraction) -> None:
    found = EXAMPLE.evaluate(s, delta)
    assert list(found) == ["xi_1", "xi_2", "xi_3", "xi_4", "xi_5", "xi_6", "p", "b", "y", "v", "z", "lambda_n"]
    for name, terms in EXAMPLE.terms().items():
        exact = sum(
            (Fraction(int(c.p), int(c.q)) * s**k * delta**n for n, t in enumerate(terms)
             for k, c in enumerate(t.coefficients())), Fraction(0),
        )  # fmt: skip
        with working_bits(200):
            assert (found[name] * exact.denominator).contains(exact.numerator)
        assert found[name].is_exact() or found[name].rel_accuracy_bits() >= 50


@given(st.fractions(-2, 2, max_denominator=20), st.fractions(0, 2, max_denominator=20))
def test_values_in_time_are_the_scaled_ones(s: Fraction, delta: Fraction) -> None:
    scaled = EXAMPLE.evaluate(s, delta)
    unscaled = EXAMPLE.evaluate_in_time(t=delta**2 * s, epsilon=delta**3)
    factors = {"p": 2, "b": 2, "y": 6, "v": 4, "z": 6, "lambda_n": 0, **{f"xi_{i}": 2 for i in range(1, 7)}}
    for name, power in factors.items():
        step = fmpq(delta.numerator, delta.denominator) ** power
        assert unscaled[name].is_finite()
        assert unscaled[name].overlaps(scaled[name] * step)


def test_values_at_balls() -> None:
    wide = EXAMPLE.evaluate(arb(1, fmpq(1, 100)), arb(0, fmpq(1, 10)))
    for s, delta in (("0.99", 0), ("1.01", "0.1"), (1, "-0.1")):
        for name, value in EXAMPLE.evaluate(s, delta).items():
            assert wide[name].contains(value)


def test_accuracy_is_asked_for_in_digits() -> None:
    bits = current_bits()
    assert EXAMPLE.evaluate("1/3", "1/7", digits=100)["z"].rel_accuracy_bits() >= 332
    assert current_bits() == bits


def test_progress() -> None:
    seen: list[tuple[int, int]] = []
    expand_system(extended_example(1), 3, progress=lambda done, total: seen.append((done, total)))
    assert seen == [(1, 3), (2, 3), (3, 3)]


@pytest.mark.parametrize("order", [True, 2.0, "3", None, fmpq(3)])
def test_an_order_of_another_type(order: Any) -> None:
    with pytest.raises(TypeError, match="order must be an int"):
        expand_system(extended_example(1), order)


@pytest.mark.parametrize("order", [0, -1, 2001])
def test_an_order_out_of_range(order: int) -> None:
    with pytest.raises(ValueError, match=r"order must lie in 1\.\.2000"):
        expand_system(extended_example(1), order)


def test_bad_arguments() -> None:
    with pytest.raises(TypeError, match="must be a System"):
        expand_system(None, 3)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="s: a float"):
        EXAMPLE.evaluate(0.5, 1)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="epsilon: a float"):
        EXAMPLE.evaluate_in_time(0, 0.5)  # type: ignore[arg-type]
    with pytest.raises(FrozenInstanceError):
        EXAMPLE.order = 3  # type: ignore[misc]


def test_a_term_outside_its_space_has_no_time_form() -> None:
    wrong = (SpacePolynomial.from_list(0, [1]), *EXAMPLE.b[1:])
    with pytest.raises(ArithmeticError, match="no counterpart"):
        replace(EXAMPLE, b=wrong).in_time()


def test_certain_bits_of_a_coefficient_and_of_one_that_may_be_zero() -> None:
    narrow, wide = arb((1, 0), (1, -40)), arb((1, 0), (1, -20))
    assert certain_bits([[arb(1)]]) > 10**6  # exact
    assert 39 <= certain_bits([[narrow]]) <= 41
    assert 19 <= certain_bits([[narrow, wide]]) <= 21
    assert 19 <= certain_bits([[wide], [narrow]]) <= 21
    # [+-2^-40] beside 2^10: relative to the largest coefficient so far, not to later ones.
    assert 49 <= certain_bits([[arb((1, 10))], [arb(0, fmpq(1, 2**40))]]) <= 51
    assert certain_bits([[arb(0, fmpq(1, 2**40))], [arb((1, 10))]]) <= 0
    assert certain_bits([[arb("nan")]]) < -(10**6)
    assert certain_bits([[arb("inf")], [arb(1)]]) < -(10**6)


def test_the_working_precision_of_the_caller_does_not_matter() -> None:
    with working_bits(2):
        assert 39 <= certain_bits([[arb((2**50 + 1, -50), (1, -40))]]) <= 41


def test_bits_are_raised_until_they_suffice() -> None:
    asked: list[int] = []

    def attempt(bits: int) -> tuple[str, int | None]:
        asked.append(bits)
        return f"with {bits}", bits - 300  # 300 bits are lost

    result, accuracy = until_accurate(attempt, 30, 200)
    assert accuracy is not None
    assert accuracy.reached
    assert accuracy.certain_bits >= bits_for_digits(30)
    assert (accuracy.attempts, accuracy.working_bits) == (2, asked[-1])
    assert result == f"with {asked[-1]}"


def test_where_more_bits_do_not_help_it_is_said_and_not_tried_for_ever() -> None:
    asked: list[int] = []

    def attempt(bits: int) -> tuple[int, int | None]:
        asked.append(bits)
        return bits, 3

    with pytest.warns(AccuracyWarning, match="ACCURACY NOT REACHED: 15 digits were asked, .* 3 certain bits"):
        _, accuracy = until_accurate(attempt, 15, 100)
    assert accuracy is not None
    assert not accuracy.reached
    assert accuracy.to_json()["reached"] is False
    assert len(asked) == 2


def test_the_bits_are_bounded() -> None:
    asked: list[int] = []

    def attempt(bits: int) -> tuple[int, int | None]:
        asked.append(bits)
        return bits, -(10**6) + 5 * len(asked)

    with pytest.warns(AccuracyWarning):
        until_accurate(attempt, 15, 100)
    assert max(asked) <= 16 * 100
    assert len(asked) <= 3


def test_an_exact_result_is_found_once_without_a_word() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert until_accurate(lambda bits: (bits, None), 15, 100) == (100, None)


@pytest.mark.parametrize("name", ["extended system", "oscillator"])
def test_every_exact_coefficient_is_in_its_ball(name: str) -> None:
    mechanism = shipped_mechanism(name)
    exact, balls = expand(mechanism, 30), expand(mechanism, 30, bits=150)
    assert exact.accuracy is None
    assert balls.accuracy is not None
    assert balls.accuracy.certain_bits > 60
    compared = 0
    for key, rows in exact.terms().items():
        for term, other in zip(rows, balls.terms()[key], strict=True):
            numbers, enclosures = term.coefficients(), other.coefficients()
            enclosures += [0] * (len(numbers) - len(enclosures))
            for number, enclosure in zip(numbers, enclosures, strict=False):
                compared += 1
                assert number == 0 if isinstance(enclosure, int) else holds(enclosure, to_fraction(number))
            for enclosure in enclosures[len(numbers) :]:
                assert holds(enclosure, 0)
    assert compared > 300
    value, other = exact.evaluate(1, "1/20", 12), balls.evaluate(1, "1/20", 12)
    assert all(value[key].overlaps(other[key]) for key in value)


def test_a_system_in_balls_and_bad_input() -> None:
    system = extended_example(chi=1)
    assert holds(
        expand_in_balls(system, 7, 80).p[6].coefficients()[1],
        to_fraction(expand_system(system, 7).p[6].coefficients()[1]),
    )
    for bits in (31, 10**6 + 1, 64.0, True):
        with pytest.raises(ValueError, match="bits must be"):
            expand_in_balls(system, 7, bits)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="order"):
        expand_in_balls(system, 0, 64)


# Values of truncated expansions in balls and exactly: sums that cancel, points where terms vanish, wide balls.


numbers = st.fractions(-3, 3, max_denominator=30)


def exact(number: Fraction) -> fmpq:
    return fmpq(number.numerator, number.denominator)


@given(st.lists(st.lists(numbers, max_size=4), min_size=1, max_size=5), numbers, numbers, st.integers(20, 120))
def test_against_fractions(rows: list[list[Fraction]], s: Fraction, delta: Fraction, bits: int) -> None:
    terms = [SpacePolynomial(n % 3 + 9, fmpq_poly([exact(c) for c in row])) for n, row in enumerate(rows)]
    table = {(n % 3 + 3 * k, n): exact(c) for n, row in enumerate(rows) for k, c in enumerate(row)}
    value = sum(
        (c * s ** (n % 3 + 3 * k) * delta**n for n, row in enumerate(rows) for k, c in enumerate(row)), Fraction(0)
    )
    place = exact(s), exact(delta)
    for found in (scaled_value(terms, place, bits, True), value_in_time(table, place, bits, True)):
        assert found.is_finite()
        assert holds(found, value)
        assert found.is_exact() or found.rel_accuracy_bits() >= bits - 10


def test_a_sum_that_cancels_far_below_every_precision_tried() -> None:
    """1 + s^3 - (1 + 2^-2000) at s = 1/3: 10^-600 of what is summed is left of it, and all bits are right."""
    small = fmpq(1, 2**2000)
    terms = [SpacePolynomial(3, fmpq_poly([fmpq(1), fmpq(27)])), SpacePolynomial(3, fmpq_poly([small - 2]))]
    found = scaled_value(terms, (fmpq(1, 3), fmpq(1)), 60, True)
    assert holds(found, Fraction(1, 2**2000))
    assert found.is_exact() or found.rel_accuracy_bits() >= 50


def test_a_value_of_zero_is_exact() -> None:
    terms = [SpacePolynomial(3, fmpq_poly([fmpq(1, 7), fmpq(-27, 7)]))]
    assert scaled_value(terms, (fmpq(1, 3), fmpq(5)), 60, True) == 0
    assert scaled_value([SpacePolynomial.zero(2, RATIONALS)], (fmpq(1, 3), fmpq(5)), 60, True) == 0
    assert value_in_time({}, (fmpq(1, 3), fmpq(5)), 60, True) == 0


def test_coefficients_and_places_that_are_balls() -> None:
    wide = SpacePolynomial(1, BALLS.polynomial([arb(2, fmpq(1, 8))]), BALLS)
    found = scaled_value([wide], (fmpq(1, 3), fmpq(1)), 60, False)
    assert all(holds(found, Fraction(k, 24)) for k in (15, 16, 17))
    found = value_in_time({(1, 0): fmpq(6)}, (arb(1, fmpq(1, 8)), fmpq(1)), 60, True)
    assert all(holds(found, Fraction(3 * k, 4)) for k in (7, 8, 9))


@pytest.mark.parametrize("rational", [True, False])
def test_a_place_that_is_not_finite(rational: bool) -> None:
    found = value_in_time({(1, 0): fmpq(6)}, (arb("nan"), fmpq(1)), 60, rational)
    assert not found.is_finite()


def test_as_many_terms_as_the_order_says() -> None:
    trajectory = expand(extended_example(chi=1), 6)
    for change in ({"order": 4}, {"order": 8}, {"p": trajectory.p[:5]}, {"xi": (*trajectory.xi[:5], ())}):
        with pytest.raises(ValueError, match=r"extended example: .* has \d terms, not \d, the order"):
            replace(trajectory, **change)
