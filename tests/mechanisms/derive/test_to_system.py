"""Sympy to expressions: the same values and first derivatives, exact at angles with a rational sine and cosine."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
import sympy
from flint import arb, fmpq

from gspot_verified import classify, classify_all, critical_friction, find_g_spots, sweep
from gspot_verified.expansion.series.terms import NumberTerms
from gspot_verified.functions.derivative import ZERO
from gspot_verified.functions.expressions import Constant, Expression, Power, Variable, in_order
from gspot_verified.functions.power_series import SeriesOfFunctions
from gspot_verified.functions.rings import BALLS, RATIONALS
from gspot_verified.functions.symbols import Symbols
from gspot_verified.mechanisms.derive import lie_derivatives
from gspot_verified.mechanisms.derive.derivation import derive_expressions
from gspot_verified.mechanisms.derive.derived import Derived
from gspot_verified.mechanisms.derive.to_system import (
    NotRationalError,
    Preparation,
    Shifted,
    check_lagrangian_character,
    shift,
    stays,
    to_system,
)
from gspot_verified.mechanisms.formulas.formula import parse_formula
from gspot_verified.mechanisms.formulas.in_sympy import from_sympy, to_sympy
from gspot_verified.mechanisms.formulas.names import FormulaError
from gspot_verified.mechanisms.formulas.simplify import constant, exponential_of, product_of, sum_of
from gspot_verified.mechanisms.formulas.symbol import Symbol, symbol_names
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


# The Lagrangian character of fields that are given: every identity is asked for, and one that fails is named.


GOOD: dict[str, Any] = {
    "name": "fields", "state": ["x", "u", "y", "v", "w"], "F": ["u", 0, "v", "w", 1], "G_T": [0, 2, 0, "w", 0],
    "G_N": [0, "w", 0, 3, 0], "x": "x", "y": "y", "mu": 1,
}  # fmt: skip


def derived(made: Mechanism) -> Derived[Expression]:
    return derive_expressions(made, Preparation(made))


def check(**change: Any) -> None:
    made = from_fields(**GOOD | change)
    check_lagrangian_character(made, derived(made))


def test_good_fields_need_no_sympy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(lie_derivatives, "check_lagrangian_conditions", None)
    check()
    check(x=None, slip_velocity="u")


@pytest.mark.parametrize(
    ("change", "name"),
    [
        ({"G_T": [1, 2, 0, "w", 0]}, "L_GT x"),
        ({"G_N": [1, "w", 0, 3, 0]}, "L_GN x"),
        ({"G_T": [0, 2, 1, "w", 0]}, "L_GT y"),
        ({"G_N": [0, "w", 1, 3, 0]}, "L_GN y"),
        ({"G_T": [0, 2, 0, 1, 0]}, "L_GN u - L_GT v"),
        ({"G_T": [0, 2, 0, "w", 1]}, "L_G p"),
        ({"x": None, "slip_velocity": "u", "G_N": [0, "w", 1, 3, 0]}, "L_GN y"),
    ],
)
def test_each_identity_that_fails_is_named(change: dict[str, Any], name: str) -> None:
    with pytest.raises(MechanismError, match=f"fields: {name} must vanish"):
        check(**change)


def test_what_simplifies_only_in_sympy_is_accepted() -> None:
    check(G_T=[0, 2, 0, "w*(sin(w)^2 + cos(w)^2)", 0])


def test_a_mass_matrix_gives_them_without_a_check(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(lie_derivatives, "check_lagrangian_conditions", None)
    rod = shipped_mechanism("rod")
    found = derived(rod)
    check_lagrangian_character(rod, replace(found, B=Variable(0)))


def ladder(share: str) -> Mechanism:
    """A rod of length 2 with its upper end on a wall: the wall's force has the direction (1, share), as its friction
    makes it while that end slips downwards and the wall pushes; it is solved for, with the constraint."""
    X, Y, T, Xd, Yd, Td = sympy.symbols("X Y T X_dot Y_dot T_dot")
    q, rates = (X, Y, T), (Xd, Yd, Td)
    inverse = sympy.diag(1, 1, 3)
    gap, x, y = X - sympy.cos(T), X + sympy.cos(T), Y - sympy.sin(T)
    across = sympy.Matrix([gap.diff(c) for c in q])
    up = sympy.Matrix([sympy.diff(Y + sympy.sin(T), c) for c in q])
    pushed = inverse * (across + sympy.Rational(share) * up)
    bend = sum(gap.diff(c, d) * r * s for c, r in zip(q, rates, strict=True) for d, s in zip(q, rates, strict=True))

    def held(free: Any, extra: Any) -> list[Any]:
        return list(free - pushed * (across.dot(free) + extra) / across.dot(pushed))

    normal, tangent = (inverse * sympy.Matrix([g.diff(c) for c in q]) for g in (y, x))
    fields = {
        "F": [*rates, *held(sympy.Matrix([0, -1, 0]), bend)],
        "G_T": [0, 0, 0, *held(tangent, 0)],
        "G_N": [0, 0, 0, *held(normal, 0)],
    }
    return from_fields("ladder", ["X", "Y", "T", "X_dot", "Y_dot", "T_dot"], **fields, x=x, y=y, mu="1/2")


def test_friction_in_a_joint_breaks_the_symmetry_of_the_contact() -> None:
    """What the page on what is outside says: with dry friction in it the joint is no ideal constraint."""
    smooth, rough = ladder("0"), ladder("1/5")
    check_lagrangian_character(smooth, derived(smooth))
    with pytest.raises(MechanismError, match="ladder: L_GN u - L_GT v must vanish"):
        check_lagrangian_character(rough, derived(rough))


# Parameters put in and angles counted from their references.


def with_values(**parameters: Any) -> Mechanism:
    return from_fields("test", ["q", "w"], ["w", 0], [0, 0], [0, 1], 0, "q", 0, parameters,
                       angles={"q": ("3/5", "4/5")})  # fmt: skip


def free_prepared(text: str, **parameters: Any) -> Any:
    names = {"q": Variable(0), "w": Variable(1)} | {name: Symbol(name) for name in (*parameters, "q_ref")}
    (found,) = shift(with_values(**parameters), free=True).prepare([parse_formula(text, names)])
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
    assert sum_of(free_prepared(text), product_of(constant(-1), parse_formula(same, names))) is ZERO


def test_what_does_not_cancel_stays() -> None:
    assert symbol_names([free_prepared("sin(q/2)")]) == {"q_ref"}
    assert symbol_names([free_prepared("w*q")]) == {"q_ref"}
    assert symbol_names([free_prepared("pi*w")]) == {"pi"}


def test_parameters_are_put_in() -> None:
    assert free_prepared("sin(k*q)", k=2) is free_prepared("sin(2*q)")
    assert free_prepared("w/(k - 1)", k="3/2") is free_prepared("2*w")
    assert symbol_names([free_prepared("k*w", k=None)]) == {"k"}


def test_a_division_by_zero_with_these_parameters() -> None:
    with pytest.raises(MechanismError, match="with the values of the parameters: division by zero"):
        free_prepared("w/(k - 1)", k=1)


def test_chains_of_parameters() -> None:
    chain = {"a0": "1"} | {f"a{i}": f"a{i - 1} + 1" for i in range(1, 400)}
    assert with_values(**chain).parameter_values()["a399"] is Constant(fmpq(400))
    towers = {"a0": "9^60"} | {f"a{i}": f"a{i - 1}^60" for i in range(1, 40)}
    with pytest.raises(MechanismError, match="parameter a2: a number grows beyond"):
        shift(with_values(**towers))
    with pytest.raises(MechanismError, match="at most 500 parameters, got 501"):
        with_values(**{f"a{i}": 1 for i in range(501)})


def test_pi_is_a_ball_only() -> None:
    shifted = shift(with_values())
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
    shifted = shift(with_values(k=None), free=True)
    (found,) = shifted.expressions([Symbol("k") * Variable(0)], BALLS, {"k": Variable(2)})
    assert found is Variable(2) * Variable(0)
    with pytest.raises(MechanismError, match="k has no value"):
        shifted.expressions([Symbol("k")], BALLS)


def test_products_of_sums_with_references_do_not_grow_without_limit() -> None:
    """Multiplied out they would have 3^50 terms."""
    product = "*".join(f"(q - {k}*q_ref + w)" for k in range(2, 52))
    function = free_prepared(product)
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
