"""Contact after the G-spot of a mechanism: the statements of its alphas."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified import iwc
from gspot_verified.compliant.contact.iwc import CONSTANT_ALPHAS
from gspot_verified.compliant.contact.iwc import compliant_iwc as iwc_of_alphas
from gspot_verified.mechanisms.load import load
from gspot_verified.mechanisms.spots.classify import classify
from gspot_verified.numbers.verdict import Outcome

ALPHAS = {"alpha_1": "-175/408", "alpha_2": "-186037/99144", "alpha_3": "-1225/1224"}  # the oscillator's


def test_a_mechanism_is_its_alphas() -> None:
    oscillator = load("oscillator")
    expected = {**iwc_of_alphas(**ALPHAS, digits=6).to_json(), "caveat": CONSTANT_ALPHAS}  # type: ignore[arg-type]
    assert iwc(oscillator, digits=6).to_json() == expected
    assert iwc(classify(oscillator), digits=6).to_json() == expected


def test_numbers_as_before() -> None:
    assert iwc("7/3", digits=6).to_json() == iwc_of_alphas("7/3", digits=6).to_json()
    whole: dict[str, Any] = {"alpha_1": -2, "alpha_3": -3, "digits": 3}
    assert iwc(**whole).to_json() == iwc_of_alphas(**whole).to_json()
    doubled = iwc("3/2", alpha_2=-2, digits=3)
    assert doubled.leading.force.alpha_2 == -2
    assert doubled.to_json() == iwc_of_alphas("3/2", alpha_2=-2, digits=3).to_json()


@pytest.mark.parametrize(
    ("name", "options", "message"),
    [
        ("oscillator", {"alpha_2": -1}, "the mechanism has its own"),
        ("falling_rod_lower_friction", {}, "Cases I, II and III"),
        ("frictional impact oscillator, all parameters", {"growth": True}, "the table needs rational alphas"),
    ],
)
def test_what_has_no_statement(name: str, options: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        iwc(load(name), **options)


IN_BALLS = "frictional impact oscillator, all parameters"


@pytest.mark.parametrize("charge", [-1, 1])
def test_balls_around_rational_alphas_contain_what_is_known_of_these(charge: int) -> None:
    wide = iwc(load(IN_BALLS), c1=charge, digits=8)
    narrow = iwc(load("oscillator"), c1=charge, digits=12)
    assert wide.leading.verdict.outcome is narrow.leading.verdict.outcome is Outcome.PROVED
    if charge < 0:
        assert wide.leading.largest_epsilon is not None
        assert narrow.leading.largest_epsilon is not None
        assert narrow.leading.epsilon_0 is not None
        assert wide.leading.epsilon_0 is not None
        assert wide.leading.largest_epsilon.overlaps(narrow.leading.largest_epsilon)
        assert 0 < narrow.leading.largest_epsilon - wide.leading.epsilon_0 < fmpq(1, 10**6)
        assert narrow.slow is not None
        assert narrow.slow.threshold is not None
        assert narrow.slow.threshold.lower is not None
        assert wide.slow is not None
        assert wide.leading.epsilon_0 < narrow.slow.threshold.lower
        assert wide.slow.verdict.statement.startswith("on the slow manifold of the compliant model, for all α1, α2, α3")
        assert f"(balls rounded outward), C1 = {charge}: λ_N > 0" in wide.slow.verdict.statement
    else:
        assert (wide.slow, wide.lift_off) == (None, None)
        assert wide.caveat is not None
        assert "one rational β" in wide.caveat
        assert wide.caveat in str(wide)
        assert wide.leading.lift_off is not None
        assert narrow.leading.lift_off is not None
        assert wide.leading.lift_off.lower is not None
        assert wide.leading.lift_off.upper is not None
        assert wide.leading.lift_off.lower <= narrow.leading.lift_off.lower  # type: ignore[operator]
        assert narrow.leading.lift_off.upper <= wide.leading.lift_off.upper  # type: ignore[operator]


def test_an_irrational_beta_above_1() -> None:
    mechanism = load(IN_BALLS, l="11/10")
    found = classify(mechanism)
    alphas = [value.mid() for value in (found.alpha_1, found.alpha_2, found.alpha_3) if isinstance(value, arb)]
    assert len(alphas) == 3
    near = iwc_of_alphas(alpha_1=alphas[0], alpha_2=alphas[1], alpha_3=alphas[2], digits=12).leading
    result = iwc(mechanism, digits=8)
    assert result.verdict.outcome is Outcome.PROVED
    assert near.largest_epsilon is not None
    assert result.leading.epsilon_0 is not None
    assert 0 < near.largest_epsilon - result.leading.epsilon_0 < fmpq(1, 10**6)


def test_one_ball_among_rationals_is_enough_for_balls() -> None:
    found = classify(load("oscillator"))
    assert isinstance(found.alpha_2, fmpq)
    result = iwc(replace(found, alpha_2=arb(found.alpha_2) + arb(0, 1e-9)), digits=6)
    assert result.leading.verdict.outcome is Outcome.PROVED
    assert "for all α1, α2, α3" in result.leading.verdict.statement
    with pytest.raises(ValueError, match="alpha_1: expected one exact number, got a ball"):
        iwc(alpha_1=arb(-1, 1e-9))


def test_the_rod_in_case_ii_holds_everywhere() -> None:
    result = iwc(load("genot_brogliato_rod"))
    assert result.leading.every_epsilon
    assert result.leading.whole_line
    for verdict in (result.leading.verdict, result.verdict):
        assert verdict.outcome is Outcome.PROVED
        assert verdict.statement.endswith("λ_N > 0 for every real τ and every ε > 0")


@pytest.mark.parametrize("charge", [1, -1])
def test_alphas_of_a_mechanism_are_constant(charge: int) -> None:
    found = iwc(load("oscillator"), c1=charge, digits=6)
    assert found.caveat == CONSTANT_ALPHAS
    assert str(found).endswith(CONSTANT_ALPHAS)
    assert iwc(found.leading.force.beta, c1=charge, digits=6).caveat is None
    wide = iwc(load(IN_BALLS), digits=6)
    assert str(wide.caveat).startswith(CONSTANT_ALPHAS)


def test_theorem_c_is_used_below_5_only() -> None:
    below, above = (iwc(alpha_3=arb(beta, 1e-9), digits=6) for beta in (-4.75, -5.25))
    assert below.slow is not None
    assert above.leading.verdict.outcome is Outcome.PROVED
    assert above.compliant is None
    assert above.to_json()["caveat"] == above.caveat


def test_one_epsilon_for_balls() -> None:
    wide = arb(-2.5, 1e-9)
    proved, refuted = iwc(alpha_3=wide, epsilon="1/2"), iwc(alpha_3=wide, epsilon=2)
    assert proved.verdict.outcome is Outcome.PROVED
    assert proved.slow is not None
    assert "at ε = 0.5" in proved.slow.verdict.statement
    assert refuted.leading.verdict.outcome is Outcome.REFUTED
    assert refuted.compliant is None


def test_balls_beside_beta_are_refused() -> None:
    with pytest.raises(ValueError, match="expected one exact number, got a ball"):
        iwc("5/2", alpha_3=arb(-2.5, 1e-9))
