"""Parameters put in and angles counted from their references."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified import classify, classify_all, critical_friction, find_g_spots, sweep
from gspot_verified.functions.derivative import ZERO
from gspot_verified.functions.expressions import Constant, Variable, in_order
from gspot_verified.functions.rings import BALLS, RATIONALS
from gspot_verified.mechanisms.derive.to_system import NotRationalError, shift
from gspot_verified.mechanisms.formulas.formula import parse_formula
from gspot_verified.mechanisms.formulas.simplify import constant, product_of, sum_of
from gspot_verified.mechanisms.formulas.symbol import Symbol, symbol_names
from gspot_verified.mechanisms.input.given import from_fields
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.numbers.balls import working_bits


def mechanism(**parameters: Any) -> Mechanism:
    return from_fields("test", ["q", "w"], ["w", 0], [0, 0], [0, 1], 0, "q", 0, parameters,
                       angles={"q": ("3/5", "4/5")})  # fmt: skip


def prepared(text: str, **parameters: Any) -> Any:
    names = {"q": Variable(0), "w": Variable(1)} | {name: Symbol(name) for name in (*parameters, "q_ref")}
    (found,) = shift(mechanism(**parameters), free=True).prepare([parse_formula(text, names)])
    return found


@pytest.mark.parametrize(
    ("text", "same"),
    [
        ("q - q_ref", "q"),
        ("w*(q - q_ref)^2", "w*q^2"),
        ("w*q - q_ref*w", "w*q"),
        ("w*(q + w) - q_ref*w", "w*q + w^2"),
        ("sin(q - q_ref)", "sin(q)"),
        ("sin(q)", "3/5*cos(q) + 4/5*sin(q)"),
        ("cos(2*q - w)", "7/25*cos(2*q - w) - 24/25*sin(2*q - w)"),
        ("sin(w + pi/2)", "cos(w)"),
        ("cos(w + 3*pi)", "-cos(w)"),
        ("sin(5*pi/2)", "1"),
        ("tan(pi)", "0"),
        ("sin(q + pi)", "-3/5*cos(q) - 4/5*sin(q)"),
        ("sin(q + pi/2)", "4/5*cos(q) - 3/5*sin(q)"),
        ("cos(q + pi/2)", "-3/5*cos(q) - 4/5*sin(q)"),
        ("sin(pi/2 + pi + w)", "-cos(w)"),
        ("sin(pi/2 + 5*pi/2 + w)", "-sin(w)"),
    ],
)
def test_references_and_quarter_turns(text: str, same: str) -> None:
    names = {"q": Variable(0), "w": Variable(1)}
    assert sum_of(prepared(text), product_of(constant(-1), parse_formula(same, names))) is ZERO


def test_what_does_not_cancel_stays() -> None:
    assert symbol_names([prepared("sin(q/2)")]) == {"q_ref"}
    assert symbol_names([prepared("w*q")]) == {"q_ref"}
    assert symbol_names([prepared("pi*w")]) == {"pi"}


def test_parameters_are_put_in() -> None:
    assert prepared("sin(k*q)", k=2) is prepared("sin(2*q)")
    assert prepared("w/(k - 1)", k="3/2") is prepared("2*w")
    assert symbol_names([prepared("k*w", k=None)]) == {"k"}


def test_a_division_by_zero_with_these_parameters() -> None:
    with pytest.raises(MechanismError, match="with the values of the parameters: division by zero"):
        prepared("w/(k - 1)", k=1)


def test_chains_of_parameters() -> None:
    chain = {"a0": "1"} | {f"a{i}": f"a{i - 1} + 1" for i in range(1, 400)}
    assert mechanism(**chain).parameter_values()["a399"] is Constant(fmpq(400))
    towers = {"a0": "9^60"} | {f"a{i}": f"a{i - 1}^60" for i in range(1, 40)}
    with pytest.raises(MechanismError, match="parameter a2: a number grows beyond"):
        shift(mechanism(**towers))
    with pytest.raises(MechanismError, match="at most 500 parameters, got 501"):
        mechanism(**{f"a{i}": 1 for i in range(501)})


def test_pi_is_a_ball_only() -> None:
    shifted = shift(mechanism())
    function = parse_formula("2*pi", {})
    with pytest.raises(NotRationalError, match="pi stands outside a sine or cosine"):
        shifted.expressions([function], RATIONALS)
    with working_bits(100):
        (found,) = shifted.expressions([parse_formula("pi", {})], BALLS)
        assert isinstance(found, Constant)
        assert found.value.is_finite()
        assert found.value.overlaps(arb.pi())


def test_a_symbol_may_become_a_further_variable() -> None:
    """A sweep adds parameters to the state."""
    shifted = shift(mechanism(k=None), free=True)
    (found,) = shifted.expressions([Symbol("k") * Variable(0)], BALLS, {"k": Variable(2)})
    assert found is Variable(2) * Variable(0)
    with pytest.raises(MechanismError, match="k has no value"):
        shifted.expressions([Symbol("k")], BALLS)


def test_products_of_sums_with_references_do_not_grow_without_limit() -> None:
    """Multiplied out they would have 3^50 terms."""
    product = "*".join(f"(q - {k}*q_ref + w)" for k in range(2, 52))
    function = prepared(product)
    assert symbol_names([function]) == {"q_ref"}
    assert len(in_order([function])) < 5000


@pytest.mark.parametrize(
    "ask", [classify, classify_all, find_g_spots, critical_friction, lambda name: sweep(name, {"mu": "1..2"})]
)
def test_a_name_is_no_mechanism(ask: Callable[[Any], object]) -> None:
    with pytest.raises(TypeError, match=r"expected a mechanism, got 'rod'; load\('rod'\) makes one"):
        ask("rod")
    with pytest.raises(TypeError, match="expected a mechanism, got int"):
        ask(3)
