"""Contact after the G-spot of a mechanism: the statements of its alphas."""

from __future__ import annotations

from typing import Any

import pytest

from gspot_verified import iwc
from gspot_verified.compliant.iwc import iwc as iwc_of_alphas
from gspot_verified.mechanisms.classify import classify
from gspot_verified.mechanisms.load import load

ALPHAS = {"alpha_1": "-175/408", "alpha_2": "-186037/99144", "alpha_3": "-1225/1224"}  # the oscillator's


def test_a_mechanism_is_its_alphas() -> None:
    oscillator = load("oscillator")
    expected = iwc_of_alphas(**ALPHAS, digits=6).to_json()  # type: ignore[arg-type]
    assert iwc(oscillator, digits=6).to_json() == expected
    assert iwc(classify(oscillator), digits=6).to_json() == expected


def test_numbers_as_before() -> None:
    assert iwc("7/3", digits=6).to_json() == iwc_of_alphas("7/3", digits=6).to_json()


@pytest.mark.parametrize(
    ("name", "options", "message"),
    [
        ("oscillator", {"alpha_2": -1}, "the mechanism has its own"),
        ("falling_rod_lower_friction", {}, "Cases I, II and III"),
        ("frictional impact oscillator, all parameters", {}, "the alphas are balls"),
    ],
)
def test_what_has_no_statement(name: str, options: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        iwc(load(name), **options)
