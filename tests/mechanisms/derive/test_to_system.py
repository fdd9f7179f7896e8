"""Sympy to expressions: the same values and first derivatives, exact at angles with a rational sine and cosine."""

from __future__ import annotations

import math
from typing import Any

import pytest
import sympy
from flint import arb, fmpq

from gspot_verified.expansion.series.terms import NumberTerms
from gspot_verified.functions.expressions import Constant, Expression, Power, Variable, in_order
from gspot_verified.functions.power_series import SeriesOfFunctions
from gspot_verified.functions.rings import BALLS, RATIONALS
from gspot_verified.functions.symbols import Symbols
from gspot_verified.mechanisms.derive.to_system import NotRationalError, Shifted, shift, stays, to_system
from gspot_verified.mechanisms.formulas.in_sympy import from_sympy, to_sympy
from gspot_verified.mechanisms.formulas.names import FormulaError
from gspot_verified.mechanisms.formulas.simplify import constant, exponential_of, product_of
from gspot_verified.mechanisms.formulas.symbol import Symbol
from gspot_verified.mechanisms.input.given import from_fields
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.numbers.balls import working_bits

q, w = sympy.symbols("q w")
q_ref, w_ref = sympy.symbols("q_ref w_ref")


def mechanism() -> Mechanism:
    return from_fields("test", ["q", "w"], ["w", 0], [0, 0], [0, 1], 0, "q", 0,
                       angles={"q": ("3/5", "4/5"), "w": ("-5/13", "12/13")})  # fmt: skip


FUNCTIONS = [
    sympy.sin(q), sympy.cos(q - w), sympy.tan(2 * q + w), sympy.sin(q * 3) ** 3 * sympy.cos(w),
    1 / (2 + sympy.sin(q + w)),
    sympy.sin(sympy.sin(q) * (q - q_ref)), sympy.exp(w - w_ref) * sympy.cos(q), (q - q_ref) ** 5 + (w - w_ref) ** 2,
    sympy.sqrt(sympy.Rational(9, 4) + q - q_ref), sympy.log(1 + q - q_ref) * sympy.cos(w),
    (q - q_ref) / (1 + w - w_ref) ** 3, sympy.Integer(0),
]  # fmt: skip


def holds(ball: arb, number: fmpq) -> bool:
    """Whether the ball contains p/q: exact integers, because contains() rounds a rational first."""
    return bool(ball.is_finite() and (ball * number.q - number.p).contains(0))


def prepared(shifted: Shifted, function: Any) -> list[Expression]:
    names = {"q": Variable(0), "w": Variable(1), "q_ref": Symbol("q_ref"), "w_ref": Symbol("w_ref")}
    try:
        return shifted.prepare([from_sympy(function, names)])
    except FormulaError as error:
        raise MechanismError(str(error)) from None


def first_order(function: Any, ring: Any, point: list[Any], direction: list[Any]) -> tuple[Any, Any]:
    shifted = shift(mechanism())
    (expression,) = shifted.expressions(prepared(shifted, function), ring)
    series = SeriesOfFunctions([expression], NumberTerms(ring), ring)
    series.extend(point)
    series.extend(direction)
    return series[expression][0], series[expression][1]


@pytest.mark.parametrize("function", FUNCTIONS, ids=str)
def test_values_and_derivatives(function: Any) -> None:
    sines = {sympy.sin(q_ref): sympy.Rational(3, 5), sympy.cos(q_ref): sympy.Rational(4, 5),
             sympy.sin(w_ref): sympy.Rational(-5, 13), sympy.cos(w_ref): sympy.Rational(12, 13),
             sympy.tan(q_ref): sympy.Rational(3, 4), sympy.tan(w_ref): sympy.Rational(-5, 12)}  # fmt: skip
    slope = sympy.diff(function, q) + 2 * sympy.diff(function, w)
    wanted = [sympy.expand_trig(part.subs({q: q_ref, w: w_ref})).subs(sines) for part in (function, slope)]
    found = first_order(function, RATIONALS, [fmpq(0), fmpq(0)], [fmpq(1), fmpq(2)])
    for mine, theirs in zip(found, wanted, strict=True):
        assert sympy.Rational(int(mine.p), int(mine.q)) == sympy.nsimplify(theirs)
    with working_bits(120):
        in_balls = first_order(function, BALLS, [arb(0), arb(0)], [arb(1), arb(2)])
        for ball, number in zip(in_balls, found, strict=True):
            assert holds(ball, number)


def test_a_bare_reference_is_a_ball_only() -> None:
    with pytest.raises(NotRationalError, match="q_ref stands outside"):
        first_order(q * sympy.sin(w), RATIONALS, [fmpq(0)] * 2, [fmpq(0)] * 2)
    with working_bits(100):
        value, _ = first_order(q, BALLS, [arb(0)] * 2, [arb(0)] * 2)
        assert value.is_finite()
        assert value.contains((arb(3) / 4).atan())
        value, _ = first_order(w, BALLS, [arb(0)] * 2, [arb(0)] * 2)
        assert value.overlaps((arb(-5) / 12).atan())


@pytest.mark.parametrize("function", [sympy.gamma(q), q**w, sympy.Abs(q), sympy.Symbol("other"), sympy.I * q])
def test_functions_without_a_power_series_are_refused(function: Any) -> None:
    with pytest.raises(MechanismError):
        first_order(function, BALLS, [arb(0)] * 2, [arb(0)] * 2)


def test_parameters_need_values() -> None:
    free = from_fields("test", ["q", "w"], ["w", "k"], [0, 0], [0, 1], 0, "q", 0, {"k": None})
    with pytest.raises(MechanismError, match="without a value: k"):
        shift(free)
    assert shift(free, free=True).functions.b is Symbol("k")
    given = from_fields("test", ["q", "w"], ["w", "k"], [0, 0], [0, 1], 0, "q", 0, {"k": 2})
    assert shift(given).functions.b is Constant(fmpq(2))


@pytest.mark.parametrize("count", range(1, 10))
def test_every_factor_of_a_product_counts(count: int) -> None:
    """(q - q_ref + 2)(q - q_ref + 3)(q - q_ref + 4)...: the value and the derivative by the product rule."""
    numbers = range(2, count + 2)
    function = sympy.Mul(*(q - q_ref + k for k in numbers), evaluate=False)
    value, slope = first_order(function, RATIONALS, [fmpq(0)] * 2, [fmpq(1), fmpq(0)])
    assert value == math.prod(numbers)
    assert slope == sum(fmpq(math.prod(numbers), k) for k in numbers)


@pytest.mark.parametrize("exponent", [1, 2, 3, 4, 5, 6, 7, -1, -2, sympy.Rational(1, 2), sympy.Rational(-3, 2)])
def test_only_natural_powers_become_products(exponent: Any) -> None:
    """The bounds on residuals rest on it (proofs/residual.md): a power is the branch of a base that does not vanish."""
    shifted = shift(mechanism())
    expressions = shifted.expressions(prepared(shifted, 2 + (q - q_ref + 1) ** exponent), RATIONALS)
    powers = [node.exponent for node in in_order(expressions) if isinstance(node, Power)]
    natural = sympy.Rational(exponent).is_Integer and exponent > 0
    assert powers == ([] if natural else [fmpq(int(sympy.Rational(exponent).p), int(sympy.Rational(exponent).q))])


@pytest.mark.parametrize("name", ["extended", "model"])
def test_each_function_of_the_system_is_the_one_of_its_name(name: str) -> None:
    """At an exact point away from the G-spot, against sympy."""
    shifted = shift(shipped_mechanism(name))
    state = shifted.mechanism.state
    zero = dict.fromkeys(state, fmpq(0))
    conditions = [Variable(0) * Constant(fmpq(3)), Variable(1)]
    system = to_system(shifted, zero, RATIONALS, conditions)
    assert system.J[1] == Variable(1)
    point = {word: fmpq(k + 2, 7) for k, word in enumerate(state)}
    numbers = {sympy.Symbol(word): sympy.Rational(k + 2, 7) for k, word in enumerate(state)}
    f = shifted.functions
    pairs = [
        *zip((*system.F, *system.G), (*f.F, *f.G), strict=True),
        (system.y, f.y), (system.v, f.v), (system.p, f.p), (system.b, f.b), (system.J[0], conditions[0]),
        (system.alpha_1, f.alpha_1), (system.alpha_2, f.alpha_2), (system.alpha_3, f.alpha_3),
    ]  # fmt: skip
    series = SeriesOfFunctions([expression for expression, _ in pairs], NumberTerms(RATIONALS), RATIONALS)
    series.extend([point[word] for word in state])
    for expression, function in pairs:
        found = series[expression][0]
        assert sympy.Rational(int(found.p), int(found.q)) == to_sympy(function, state).subs(numbers)


def test_symbols_of_a_ring_and_further_variables_stand_for_parameters() -> None:
    free = from_fields("test", ["q", "w"], ["w", "k"], [0, 0], [0, 1], 0, "q", 0, {"k": None})
    shifted = shift(free, free=True)
    ring = Symbols("k")
    (symbolic,) = shifted.expressions([Symbol("k")], ring)
    assert isinstance(symbolic, Constant)
    assert symbolic.value == ring.symbol("k")
    assert shifted.expressions([Symbol("k")], BALLS, {"k": Variable(2)}) == [Variable(2)]
    for name in ("other", "k"):
        with pytest.raises(MechanismError, match=f"test: {name} has no value"):
            shifted.expressions([Symbol(name)], ring if name == "other" else BALLS)


def test_a_component_stays_at_its_value() -> None:
    def at(value: fmpq, place: fmpq) -> fmpq:
        condition = stays(1, value, RATIONALS)
        series = SeriesOfFunctions([condition], NumberTerms(RATIONALS), RATIONALS)
        series.extend([fmpq(9), place])
        found: fmpq = series[condition][0]
        return found

    assert stays(1, fmpq(0), RATIONALS) is Variable(1)
    assert at(fmpq(2, 3), fmpq(2, 3)) == 0
    assert at(fmpq(2, 3), fmpq(1)) == fmpq(1, 3)


def test_what_has_no_form_in_the_other_language_is_said() -> None:
    assert from_sympy(sympy.E * q, {"q": Variable(0)}) is product_of(exponential_of(constant(1)), Variable(0))
    with pytest.raises(TypeError, match="no sympy form of Constant"):
        to_sympy(Constant(arb(1)))
