"""One way from a mechanism or a system to its expansion, with the asked digits or a warning."""

from __future__ import annotations

from typing import Any

import pytest
from flint import arb, fmpq

import gspot_verified
from gspot_verified.expansion.trajectory import AccuracyWarning
from gspot_verified.mechanisms.expand import expand
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.g_spot import find_g_spot
from gspot_verified.numbers.balls import bits_for_digits, relative_bits, working_bits

BALLS = "frictional impact oscillator, all parameters"
"""The oscillator at the same point as "oscillator", but found in balls."""


def coefficients(trajectory: Any) -> list[Any]:
    return [value for terms in trajectory.terms().values() for term in terms for value in term.coefficients()]


def pairs(balls: Any, exact: Any) -> list[tuple[arb, fmpq]]:
    found = []
    for name, terms in exact.terms().items():
        for n, term in enumerate(terms):
            numbers, boxes = term.coefficients(), balls.terms()[name][n].coefficients()
            found += [(box, numbers[k] if k < len(numbers) else fmpq(0)) for k, box in enumerate(boxes)]
    return found


@pytest.mark.parametrize(("order", "digits"), [(8, 15), (30, 15), (12, 60)])
def test_a_mechanism_in_balls_has_the_asked_digits(order: int, digits: int) -> None:
    """The balls hold the rational coefficients of the same mechanism in its exact form, and are as narrow as asked."""
    balls = expand(shipped_mechanism(BALLS), order, digits)
    exact = expand(shipped_mechanism("oscillator"), order, digits)
    assert exact.accuracy is None
    assert balls.accuracy is not None
    assert balls.accuracy.reached
    with working_bits(2 * balls.accuracy.working_bits):
        for box, number in pairs(balls, exact):
            assert box.is_finite()
            assert (box * number.q - number.p).contains(0)
            if number != 0:
                assert relative_bits(box) >= bits_for_digits(digits) - 1


def test_the_system_of_a_g_spot_gives_as_many_digits_or_says_that_it_does_not() -> None:
    """In the working precision of the caller these balls had a relative radius of 20 % without a word."""
    system = find_g_spot(shipped_mechanism(BALLS)).system
    whole = expand(shipped_mechanism("oscillator"), 30)
    found = expand(system, 30)
    assert found.accuracy is not None
    assert found.accuracy.reached
    with working_bits(200):
        for box, number in pairs(found, whole):
            assert (box * number.q - number.p).contains(0)
            assert number == 0 or relative_bits(box) >= bits_for_digits(15) - 1
    with pytest.warns(AccuracyWarning, match="NOT REACHED: 60 digits"):
        rough = expand(system, 30, 60)
    assert rough.accuracy is not None
    assert not rough.accuracy.reached
    assert "ACCURACY NOT REACHED" in str(rough)
    assert rough.to_json()["accuracy"]["reached"] is False
    # Valid all the same.
    with working_bits(400):
        assert all((box * number.q - number.p).contains(0) for box, number in pairs(rough, whole))


def test_the_result_does_not_depend_on_the_working_precision_of_the_caller() -> None:
    system = find_g_spot(shipped_mechanism(BALLS)).system
    texts = []
    for bits in (20, 300):
        with working_bits(bits):
            texts.append(expand(system, 6).to_json())
    assert texts[0] == texts[1]


def test_values_at_a_point_keep_the_digits() -> None:
    balls, exact = expand(shipped_mechanism(BALLS), 20, 40), expand(shipped_mechanism("oscillator"), 20)
    mine, theirs = (trajectory.evaluate(1, "1/100", 40) for trajectory in (balls, exact))
    for name, value in theirs.items():
        assert mine[name].overlaps(value)
        assert value.contains(0) or relative_bits(mine[name]) > 120


def test_symbols_and_rationals_are_exact() -> None:
    for mechanism in (shipped_mechanism("extended"), shipped_mechanism("extended", chi=None)):
        assert expand(mechanism, 4).accuracy is None
        assert expand(mechanism, 4).to_json()["accuracy"] is None


@pytest.mark.parametrize(
    ("source", "order", "digits", "error", "message"),
    [
        ("oscillator", 3, 15, TypeError, "Mechanism or a System, got str"),
        (None, 3, 15, TypeError, "Mechanism or a System, got NoneType"),
        (shipped_mechanism("model"), "3", 15, TypeError, "order must be an int"),
        (shipped_mechanism("model"), 0, 15, ValueError, "order must lie in"),
        (shipped_mechanism("model"), 3, 0, ValueError, "digits must lie in"),
        (shipped_mechanism("model"), 3, 1.5, TypeError, "digits must be an int"),
    ],
)
def test_bad_input(source: Any, order: Any, digits: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        expand(source, order, digits)


def test_it_is_public() -> None:
    assert gspot_verified.expand is expand
    assert "expand" in gspot_verified.__all__


def test_a_negative_mean_force_is_known() -> None:
    for alpha_3, pulls in (("-1/2", True), ("-3/2", False)):
        assert expand(shipped_mechanism("extended", alpha_3=alpha_3), 1).pulls == pulls
    assert not expand(shipped_mechanism("extended", chi=None, alpha_3=None), 2).pulls
