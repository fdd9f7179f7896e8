"""Rational functions of symbols against exact numbers put in their place."""

from __future__ import annotations

import random

import pytest
from flint import fmpq

from gspot_verified.expansion.series.recursion import Recursion
from gspot_verified.expansion.series.system import GSpotError
from gspot_verified.functions.symbols import RationalFunction, Symbols
from gspot_verified.mechanisms.shipped import shipped_mechanism, shipped_system
from gspot_verified.mechanisms.symbolic import symbolic_system


def value(function: RationalFunction, at: dict[str, fmpq]) -> fmpq:
    numerator, denominator = function.numerator.subs(at), function.denominator.subs(at)
    return numerator.leading_coefficient() / denominator.leading_coefficient() if not numerator.is_zero() else fmpq(0)


def test_operations_commute_with_evaluation() -> None:
    ring = Symbols("x", "y")
    x, y = ring.symbol("x"), ring.symbol("y")
    source = random.Random(1)
    for _ in range(30):
        at = {name: fmpq(source.randint(2, 30), source.randint(31, 60)) for name in ("x", "y")}
        first = (x * ring.number(source.randint(1, 5)) + y) / (y + ring.number(1))
        second = (x - y * y) / (x + ring.number(3))
        a, b = value(first, at), value(second, at)
        for made, expected in (
            (first + second, a + b),
            (first - second, a - b),
            (first * second, a * b),
            (first / second, a / b),
            (first**3, a**3),
            (first**-2, 1 / a**2),
            (-first, -a),
        ):
            assert value(made, at) == expected
        assert (first - first) == 0
        assert first / first == 1


def test_symbols_agree_with_numbers_in_the_recursion() -> None:
    names = ("chi", "alpha_1", "alpha_2", "alpha_3")
    symbolic = Recursion(symbolic_system(shipped_mechanism("extended", **dict.fromkeys(names))))
    at = dict(zip(names, (fmpq(2, 3), fmpq(-5, 4), fmpq(-1, 7), fmpq(-3)), strict=True))
    numeric = Recursion(shipped_system("extended", **at))
    for _ in range(6):
        symbolic.advance()
        numeric.advance()
    for name in ("p", "b", "y", "v", "z", "lambda_n"):
        for general, special in zip(getattr(symbolic, name), getattr(numeric, name), strict=True):
            assert [value(c, at) for c in general.coefficients()] == special.coefficients()


def test_what_symbols_cannot_do_is_said() -> None:
    ring = Symbols("x")
    x = ring.symbol("x")
    with pytest.raises(ZeroDivisionError):
        x / ring.number(0)
    with pytest.raises(ValueError, match="vanish"):
        ring.sine_cosine(x)
    with pytest.raises(ValueError, match="integer powers"):
        ring.power(x, fmpq(1, 2))
    assert ring.is_negative(ring.number(-1))
    assert not ring.is_negative(ring.number(0))


def test_without_a_symbol_there_is_no_symbolic_system() -> None:
    with pytest.raises(GSpotError, match="no parameter is a symbol; give one the value None"):
        symbolic_system(shipped_mechanism("extended"))
