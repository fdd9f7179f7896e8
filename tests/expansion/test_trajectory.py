"""The result of an expansion: text, values, refusals."""

from __future__ import annotations

import json
from dataclasses import FrozenInstanceError, replace
from fractions import Fraction
from typing import Any

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.expansion.series.spaces import SpacePolynomial
from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.functions.rings import BALLS
from gspot_verified.numbers.balls import current_bits, working_bits
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
