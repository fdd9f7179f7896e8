"""Mechanisms with affine alphas are found as such (proofs/from_state.md, section 8)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import mpmath
import pytest
from flint import arb, fmpq
from samples.model_texts import model_text

from gspot_verified import load, mechanism_side
from gspot_verified.expansion.from_state.affine_system import Affine, AffineSystem
from gspot_verified.expansion.from_state.analytic import Analytic
from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Constant, Expression, Power, Sine, Variable
from gspot_verified.mechanisms.approach.affine_motion import _fractions, affine_system_of, with_explicit
from gspot_verified.mechanisms.input.file import parse_mechanism
from gspot_verified.numbers.balls import ball, working_bits

TEXT = model_text(
    '"u", 0, "v", "b", "alpha_1 + p/5 + b", "alpha_2 - p + 2*b"',
    "alpha_3 + 3*p",
    'alpha_1 = "-1/2"\nalpha_2 = -1\nalpha_3 = "-3/4"',
)


def found_in(*changes: tuple[str, str]) -> tuple[tuple[str, str], AffineSystem] | None:
    text = TEXT
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return affine_system_of(parse_mechanism(text))


def test_each_slope_is_found() -> None:
    found = found_in()
    assert found is not None
    assert found[0] == ("p", "b")
    assert found[1].alpha_1 == Affine(fmpq(-1, 2), fmpq(1, 5), fmpq(1))
    assert found[1].alpha_2 == Affine(fmpq(-1), fmpq(-1), fmpq(2))
    assert found[1].alpha_3 == Affine(fmpq(-3, 4), fmpq(3))
    turned = found_in(('"p", "b"]', '"b", "p"]'), *SWAPPED)
    assert turned == found


SWAPPED = (
    ('"alpha_1 + p/5 + b", "alpha_2 - p + 2*b"', '"alpha_2 - p + 2*b", "alpha_1 + p/5 + b"'),
    ('0, "(alpha_3 + 3*p)/(2*(1 - p))"]', '"(alpha_3 + 3*p)/(2*(1 - p))", 0]'),
    ('0, "-(alpha_3 + 3*p)/2"]', '"-(alpha_3 + 3*p)/2", 0]'),
)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('"alpha_1 + p/5 + b"', '"alpha_1 + x"'),
        ('"alpha_2 - p + 2*b"', '"alpha_2 + u"'),
        ("3*p", "y*x"),
        ("alpha_1 + p/5", "sin(x) + alpha_1 + p/5"),
        ("alpha_1 + p/5", "sin(p + x) + alpha_1 + p/5"),
        ("alpha_1 + p/5", "alpha_1/(1 + u*p)"),
    ],
)
def test_alphas_of_another_kind_are_none(old: str, new: str) -> None:
    assert found_in((old, new)) is None


@pytest.mark.parametrize(
    ("new", "value", "text"),
    [
        ("sin(p)*b + alpha_1 + p/5", lambda p, b: mpmath.sin(p) * b + p / 5 + b - 0.5, "sin(p)"),
        ("alpha_1/(1 + p + 2*b)", lambda p, b: b - 0.5 / (1 + p + 2 * b), "^(-1)"),
        ("alpha_1 + p*b*b + x - x", lambda p, b: b - 0.5 + p * b * b, "b^(2)"),
        ("sin(p)*x/(2*x) + alpha_1", lambda p, b: mpmath.sin(p) / 2 + b - 0.5, "sin(p)"),
        ("sqrt(1 + p)*exp(b) - 3/2", lambda p, b: mpmath.sqrt(1 + p) * mpmath.exp(b) + b - 1.5, "^(1/2)"),
        ("-sqrt(4*exp(p))/4", lambda p, b: b - mpmath.exp(p / 2) / 2, "(4*exp(p))^(1/2)"),
        ("-sqrt((4*exp(p))^3)/16", lambda p, b: b - mpmath.exp(1.5 * p) / 2, "^(1/2)"),
        ("sin(p*(-3)*b) + alpha_1", lambda p, b: b - 0.5 - mpmath.sin(3 * p * b), "sin("),
    ],
)
def test_analytic_alphas_are_found(new: str, value: Callable[[float, float], float], text: str) -> None:
    """The function at a state, p and b in this order; what stands in the way cancels."""
    for changes in ((), (('"p", "b"]', '"b", "p"]'), *SWAPPED)):
        found = found_in(*changes, ("alpha_1 + p/5", new))
        assert found is not None
        assert found[0] == ("p", "b")
        alpha = found[1].alpha_1
        assert isinstance(alpha, Analytic)
        assert text in alpha.text
        assert found[1].alpha_2 == Affine(fmpq(-1), fmpq(-1), fmpq(2))
        (at,) = BoxProgram([alpha.function], 2).values([arb("0.125"), arb("-0.0625")])
        assert abs(float(at.mid()) - value(0.125, -0.0625)) < 1e-12
        names = {"p": 0.125, "b": -0.0625, "sin": mpmath.sin, "exp": mpmath.exp}
        assert abs(eval(alpha.text.replace("^", "**"), names) - value(0.125, -0.0625)) < 1e-12, alpha.text


def test_alphas_may_depend_on_y_and_v() -> None:
    """In this order: the components are x, u, y, v, p, b."""
    found = found_in(("alpha_1 + p/5", "alpha_1 + sin(v)*p + 3*y"), ("alpha_2 - p", "alpha_2 - v"))
    assert found is not None
    first, second, third = found[1].alpha_1, found[1].alpha_2, found[1].alpha_3
    assert isinstance(first, Analytic)
    assert isinstance(second, Analytic)
    assert third == Affine(fmpq(-3, 4), fmpq(3))
    assert (first.moves, second.moves, found[1].moves) == (True, True, True)
    values = BoxProgram([first.function, second.function], 4).values([arb(x) for x in ("0.5", "0.25", "0.125", "2")])
    assert abs(values[0] - (arb(2).sin() / 2 + arb("0.125"))) < arb("1e-12")
    assert values[1] == arb("-2.5")
    assert set("vy") <= set(first.text)


def test_taylor_coefficients_need_not_be_rational() -> None:
    found = found_in(("alpha_1 + p/5", "alpha_1*exp(1 + p)/4"))
    assert found is not None
    assert not found[1].is_exact
    with working_bits(128):
        assert abs(ball(found[1].beta) - 6 / arb(1).exp()) < arb("1e-35")


def test_without_taylor_coefficients_it_is_refused() -> None:
    with pytest.raises(ValueError, match="vanish"):
        found_in(("alpha_1 + p/5", "sqrt(p) - 4"))
    mechanism = parse_mechanism(TEXT.replace("alpha_1 + p/5", "sqrt(p) - 4"))
    found = mechanism_side(load("extended system"), {"x": 0, "u": 1, "p": "1/5", "b": "-1/50"})
    assert with_explicit(found, mechanism, {"p": "1/100", "b": "-1/50"}) is found


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("alpha_1", '"-1/2"', "0"),
        ("alpha_1", '"-1/2"', '"1/2"'),
        ("alpha_2", "-1", "0"),
        ("alpha_2", "-1", '"1/2"'),
        ("alpha_3", '"-3/4"', '"-1/4"'),
        ("alpha_3", '"-3/4"', '"-1/2"'),
        ("alpha_3", '"-3/4"', '"-1"'),
        ("alpha_3", '"-3/4"', '"-3/2"'),
    ],
)
def test_alphas_beside_the_theorem_are_none(name: str, old: str, new: str) -> None:
    """alpha_1, alpha_2 < 0, alpha_3 < alpha_1, and no multiple of it."""
    assert found_in((f"{name} = {old}", f"{name} = {new}")) is None


def test_a_larger_beta_is_let_through() -> None:
    found = found_in(('alpha_3 = "-3/4"', 'alpha_3 = "-5/4"'))
    assert found is not None
    assert found[1].beta == fmpq(5, 2)


def test_p_must_be_a_component_by_itself() -> None:
    twice = found_in(
        ("alpha_1 + p/5 + b", "(alpha_1 + b)/2"), ("alpha_2 - p", "alpha_2"), ("3*p", "3*q"),
        ('"p", "b"]', '"q", "b"]'), ("p = 0", "q = 0"), ("1 - p", "1 - 2*q"), ("1 + p", "1 + 2*q"),
    )  # fmt: skip
    assert twice is None


def test_rational_functions_that_are_polynomials() -> None:
    x, y, one = Variable(0), Variable(1), Constant(fmpq(1))

    def found(*functions: Expression) -> list[str] | None:
        fractions = _fractions(functions, 2)
        if fractions is None or None in fractions.polynomials:
            return None
        return [str(one) for one in fractions.polynomials]

    minus = Constant(fmpq(-1))
    over = Power(one + y, fmpq(-1))
    assert found((x * x + minus) * Power(x + minus, fmpq(-1))) == ["x0 + 1"]
    assert found(x * over + x * y * over, Power(x, fmpq(3)), Power(x, fmpq(0))) == ["x0", "x0^3", "1"]
    assert found(x * Power(one + y, fmpq(2)) * Power(one + y, fmpq(-2))) == ["x0"]
    assert found(over + y * Power(one + y, fmpq(-1)) + x) == ["x0 + 1"]
    assert found(over + Power(one + x, fmpq(-1)) * x) is None
    assert found(Power(over, fmpq(-1))) == ["x1 + 1"]
    assert found(over * x) is None
    assert found(x * over) is None
    assert found(x, over) is None
    assert found(over, x) is None
    root = Power(x, fmpq(1, 2))
    assert found(root, root * Sine(y) * Power(root, fmpq(-1)), Sine(x) * over) is None
    assert found(root, root * Sine(y) * Power(root, fmpq(-1)), root + minus * root) == ["f0", "f1", "0"]
    assert found(Constant(arb(2))) is None
    assert found(Power(x + minus * x, fmpq(-1))) is None


def test_the_extended_system_is_affine() -> None:
    """alpha_1 = -1 + chi b; its formulas hold factors 1 - p that cancel."""
    found = affine_system_of(load("extended system"))
    assert found is not None
    names, system = found
    assert names == ("p", "b")
    assert system.alpha_1 == Affine(fmpq(-1), fmpq(0), fmpq(1))
    assert system.alpha_2 == Affine(fmpq(-1))
    assert system.alpha_3 == Affine(fmpq(-3, 2))


@pytest.mark.parametrize("name", ["oscillator", "falling rod"])
def test_other_mechanisms_are_not(name: str) -> None:
    assert affine_system_of(load(name)) is None


def test_without_p_and_b_as_rational_numbers_nothing_is_added() -> None:
    """A state far away says by what it fails."""
    mechanism = load("extended system")
    state = {"x": 0, "u": 1, "p": "1/5", "b": "-1/50"}
    found = mechanism_side(mechanism, state)
    assert found.explicit is None
    assert with_explicit(found, mechanism, {"x": 0, "u": 1, "p": "1/5", "v": 0}) is found
    assert with_explicit(found, load("oscillator"), state) is found
    undecided = replace(found, side=None)
    assert with_explicit(undecided, mechanism, state) is undecided
    told = with_explicit(found, mechanism, state)
    assert told.explicit is not None
    assert told.explicit.side is None
    assert "explicit epsilon_0 (proofs/from_state.md, section 8): undecided" in str(told)
    assert told.to_json()["explicit"] is not None


_ANGLE = """
format = 1
name = "p is an angle, counted from its reference"
[fields]
state = ["x", "u", "y", "v", "phi", "b"]
F = ["u", 0, "v", "b", "-1 + b", "-1"]
G_T = [0, "3/(2*(1 - phi + phi_ref))", 0, "1/2", 0, "-3/(4*(1 - phi + phi_ref))"]
G_N = [0, "1/2", 0, "(1 + phi - phi_ref)/2", 0, "3/4"]
[angles.phi]
sine = "3/5"
cosine = "4/5"
[contact]
x = "x"
y = "y"
mu = "1 - phi + phi_ref"
[g_spot]
fixed = ["x", "u"]
[g_spot.point]
u = 1
phi = "phi_ref"
"""


def test_an_angle_is_not_taken_for_p(tmp_path: Path) -> None:
    """phi = 1/100 is p = 1/100 - phi_ref there: another state than the one that would be proved."""
    file = tmp_path / "angle.toml"
    file.write_text(_ANGLE)
    assert affine_system_of(load(file)) is None
