"""The parser: it reads what Python reads, exactly, and a hostile text gets a clear error, soon."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.mechanisms.formula import parse_formula
from gspot_verified.mechanisms.in_sympy import sympy_formula, to_sympy
from gspot_verified.mechanisms.names import FormulaError, check_name
from gspot_verified.mechanisms.symbol import Symbol, symbol_names

NAMES = {name: Symbol(name) for name in ("x", "y", "phi")}

numbers = st.integers(0, 99).map(str) | st.decimals(0, 9, places=2).map(str)
formulas = st.recursive(
    numbers | st.sampled_from(["x", "y"]),
    lambda inner: (
        st.tuples(inner, st.sampled_from(["+", "-", "*"]), inner).map(lambda t: f"({t[0]} {t[1]} {t[2]})")
        | inner.map(lambda text: f"-{text}")
        | st.tuples(inner, st.integers(0, 2)).map(lambda t: f"({t[0]})**{t[1]}")
    ),
    max_leaves=5,
)


def value(text: str, x: Fraction, y: Fraction) -> Fraction:
    """By Python's own grammar, every number made a Fraction."""
    import re

    exact = re.sub(r"(?<![\*\w.])([0-9]+(?:\.[0-9]+)?)", lambda m: f"Fraction('{m[1]}')", text)
    found = eval(exact, {"Fraction": Fraction, "x": x, "y": y})
    assert isinstance(found, Fraction)
    return found


@given(formulas, st.fractions(-5, 5, max_denominator=9), st.fractions(-5, 5, max_denominator=9))
def test_the_value_is_that_of_pythons_grammar(text: str, x: Fraction, y: Fraction) -> None:
    found = to_sympy(parse_formula(text, NAMES))
    at = {
        sympy.Symbol("x"): sympy.Rational(x.numerator, x.denominator),
        sympy.Symbol("y"): sympy.Rational(y.numerator, y.denominator),
    }
    exact = found.subs(at)
    assert Fraction(int(exact.p), int(exact.q)) == value(text, x, y)


@pytest.mark.parametrize(
    ("text", "same"),
    [
        ("-x^2", "-(x**2)"),
        ("2^-1*x", "x/2"),
        ("x/y/2", "x/(2*y)"),
        ("x - y - 1", "(x - y) - 1"),
        ("2**3**2", "2**9"),
        ("x**(1/2)", "sqrt(x)"),
        ("x^-(3/2)", "1/(x*sqrt(x))"),
        ("tan(phi)*cos(phi)", "cos(phi)*tan(phi)"),
        (".5", "1/2"),
        ("1.", "1"),
        ("x*y - y*x", "0"),
        ("sin(x - y)", "-sin(y - x)"),
        ("cos(x - y)", "cos(y - x)"),
        ("sqrt(9/4)*x", "3*x/2"),
        ("(x*y)^2/x", "x*y^2"),
        ("(x + y)/2 + (x - y)/2", "x"),
        ("µ*φ", "μ*ϕ"),
        ("pi - 2*pi", "-pi"),
    ],
)
def test_precedence(text: str, same: str) -> None:
    names = NAMES | {letter: Symbol(letter) for letter in "μφ"}
    assert parse_formula(text, names) is parse_formula(same, names)


@pytest.mark.parametrize(
    ("text", "part"),
    [
        ("__import__('os').system('id')", "unknown name '__import__'"),
        ("().__class__.__bases__", "unexpected"),
        ("x.__class__", "unexpected"),
        ("lambda: 1", "unknown name 'lambda'"),
        ("exec", "unknown name"),
        ("open('/etc/passwd')", "unknown name"),
        ("x if y else 1", "unknown name"),
        ("[1]", "unexpected"),
        ("x = 1", "unexpected"),
        ("x;y", "unexpected"),
        ("2x", "unexpected"),
        ("x y", "unexpected"),
        ("", "ends"),
        ("   ", "ends"),
        ("x +", "ends"),
        ("(x", "is missing"),
        ("x)", "unexpected"),
        ("sin x", "sin needs"),
        ("sin", "sin needs"),
        ("sin()", "unexpected"),
        ("1e5", "unknown name|unexpected"),
        ("nan", "unknown name"),
        ("inf", "unknown name"),
        ("oo", "unknown name"),
        ("1/0", "division by zero"),
        ("1/(x - x)", "division by zero"),
        ("0**-1", "division by zero"),
        ("9**9**9**9", "exponent|nest"),
        ("9**65", "within"),
        ("x**y", "exponent"),
        ("x**0.3", "half-integer"),
        ("((x^8)^8)^2", "nest"),
        ("(9**64)**64", "nest"),
        ("(2*9**32)**4", "nest"),
        ("9" * 101, "digits"),
        ("(" * 60 + "x" + ")" * 60, "nested deeper"),
        ("sin(" * 7 + "x" + ")" * 7, "functions nested deeper"),
        ("sin(" * 60 + "x" + ")" * 60, "nested deeper"),
        ("x^" * 60 + "1", "nested deeper"),
        ("x" * 1_000_000, "at most 10000 characters"),
        ("+".join(["x"] * 6000), "at most 10000 characters"),
        ("x\x00", "unexpected"),
        ("х + 1", "unexpected"),  # a Cyrillic letter
        ("٣", "unexpected"),  # an Arabic digit
        ("x # comment", "unexpected"),
    ],
)
def test_refused(text: str, part: str) -> None:
    with pytest.raises(FormulaError, match=part):
        parse_formula(text, NAMES)


@pytest.mark.parametrize(
    "text",
    ["+".join(["x"] * 4900), "*".join(["x"] * 4900), "-" * 9000 + "x", "1/3+" * 2400 + "x", "*".join(["99**64"] * 40)],
)
def test_long_formulas_are_read(text: str) -> None:
    value = parse_formula(text, NAMES)
    assert symbol_names([value]) <= set(NAMES)


def test_numbers_do_not_grow_without_limit() -> None:
    with pytest.raises(FormulaError, match="grows beyond"):
        parse_formula("*".join(["9" * 90 + "**64"] * 80), NAMES)


@pytest.mark.parametrize("text", [b"x", 1, None, ["x"]])
def test_only_text(text: object) -> None:
    with pytest.raises(TypeError, match="must be a text"):
        parse_formula(text, NAMES)  # type: ignore[arg-type]


@pytest.mark.parametrize("name", ["", "1x", "a b", "__class__", "sin", "x" * 41, "х", "pi", "a.b", None])
def test_bad_names(name: str) -> None:
    with pytest.raises(FormulaError):
        check_name(name)


def test_the_typeset_minus_is_a_minus() -> None:
    x = sympy.Symbol("x")
    assert sympy_formula("−2*x − 1", {"x": x}) == -2 * x - 1


@pytest.mark.parametrize(("name", "same"), [("φ", "φ"), ("ϕ_dot", "φ_dot"), ("µ", "μ"), ("Ω_1", "Ω_1")])
def test_greek_names(name: str, same: str) -> None:
    assert check_name(name) == same
    assert parse_formula(f"2*{name}", {same: Symbol(same)}) is parse_formula(f"{same} + {same}", {same: Symbol(same)})


@pytest.mark.parametrize(
    ("text", "guess"), [("phy", "phi"), ("sine(x)", "sin"), ("ph_i", "phi"), ("epx(x)", "exp"), ("pie", "pi")]
)
def test_an_unknown_name_has_a_nearest_guess(text: str, guess: str) -> None:
    with pytest.raises(FormulaError, match=f"did you mean '{guess}'"):
        parse_formula(text, NAMES)
    with pytest.raises(FormulaError, match=r"known here: phi, x, y$"):
        parse_formula("wholly_different", NAMES)


def test_a_power_of_a_root_needs_no_absolute_value() -> None:
    """sqrt(x)^2 is x where sqrt(x) is defined; sqrt(x^2) is not x."""
    assert parse_formula("sqrt(x)^2", NAMES) is NAMES["x"]
    assert parse_formula("sqrt(x^2)", NAMES) is not NAMES["x"]
    assert sympy_formula("sqrt(x^2)", {"x": sympy.Integer(-3)}) == 3


def test_all_unknown_names_of_a_formula_are_listed() -> None:
    with pytest.raises(FormulaError, match=r"unknown name 'k_1' at character 2 .*; also unknown: m, c_2; known here"):
        parse_formula("-k_1*x - m*sin(phi) + 2*c_2*y*k_1 + m", NAMES)
