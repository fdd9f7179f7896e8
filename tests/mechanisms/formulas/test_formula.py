"""The parser: it reads what Python reads, exactly, and a hostile text gets a clear error, soon."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.mechanisms.formulas.formula import parse_formula
from gspot_verified.mechanisms.formulas.in_sympy import sympy_formula, to_sympy
from gspot_verified.mechanisms.formulas.names import FormulaError, check_name
from gspot_verified.mechanisms.formulas.symbol import Symbol, symbol_names

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


def test_at_most_ten_further_unknown_names_are_listed_and_each_once() -> None:
    letters = "abcdefghijkl"
    with pytest.raises(FormulaError, match=r"unknown name 'a' .*; also unknown: b, c, d, e, f, g, h, i, j, k; known"):
        parse_formula("x + " + " + ".join(letters) + " + b", NAMES)
    with pytest.raises(FormulaError) as caught:
        parse_formula("phi*q", NAMES)
    assert "also unknown" not in str(caught.value)


def test_all_unknown_names_of_a_formula_are_listed() -> None:
    with pytest.raises(FormulaError, match=r"unknown name 'k_1' at character 2 .*; also unknown: m, c_2; known here"):
        parse_formula("-k_1*x - m*sin(phi) + 2*c_2*y*k_1 + m", NAMES)


@pytest.mark.parametrize(
    ("inside", "beyond", "part"),
    [
        ("x" + " " * 9999, "x" + " " * 10000, "at most 10000 characters, got 10001"),
        ("(" * 49 + "x" + ")" * 49, "(" * 50 + "x" + ")" * 50, "nested deeper than 50 at character 51 of"),
        ("x^" + "1^" * 47 + "1", "x^" + "1^" * 49 + "1", r"nested deeper than 50 at character 100 of"),
        ("9" * 100, "9" * 101, "a number may have at most 100 digits at character 1 of"),
        ("x^64", "x^65", r"an exponent must be an integer or half-integer within \+-64 at character 2 of"),
        ("x^-64", "x^-65", r"within \+-64 at character 2 of"),
        ("x^(1/2)", "x^(1/3)", r"half-integer within"),
        ("(x^8)^8", "y + (x^8)^9", "powers may nest to at most 64 at character 10 of"),
        ("(x^8)^-8", "(x^8)^-9", "powers may nest to at most 64"),
        ("((x^8 + y))^8", "(x^8 + y)^9", "powers may nest to at most 64"),
        ("(y*x^8)^8", "(y*x^8)^9", "powers may nest to at most 64"),
        ("(-x^8)^8", "(-x^8)^9", "powers may nest to at most 64"),
        ("exp(x^8)^8", "exp(x^8)^9", "powers may nest to at most 64"),
        ("sqrt(x^32)^2", "sqrt(x^32)^3", "powers may nest to at most 64"),
        ("((x^8)^8)^(1/2)", "((x^8)^8)^(3/2)", "powers may nest to at most 64"),
        ("sin(" * 6 + "x" + ")" * 6, "sin(" * 7 + "x" + ")" * 7, "functions nested deeper than 6 at character 1 of"),
        ("y + " + "sin(" * 6 + "x + y" + ")" * 6, "sin(y + " + "sin(" * 6 + "x" + ")" * 6 + ")", "functions nested"),
        ("-" + "sin(" * 6 + "x" + ")" * 6, "sin(-" + "sin(" * 6 + "x" + ")" * 6 + ")", "functions nested"),
        ("2*" + "sin(" * 6 + "x" + ")" * 6, "sin(2*" + "sin(" * 6 + "x" + ")" * 6 + ")", "functions nested"),
        ("sin(" * 6 + "x" + ")" * 6 + "^2", "sin(" + "sin(" * 6 + "x" + ")" * 6 + "^2)", "functions nested"),
        ("sqrt(" * 6 + "sin(x)" + ")" * 6, "sin(sqrt(" + "sin(" * 6 + "x" + ")" * 8, "functions nested"),
    ],
)
def test_each_limit_is_where_it_is_said_to_be(inside: str, beyond: str, part: str) -> None:
    parse_formula(inside, NAMES)
    with pytest.raises(FormulaError, match=part):
        parse_formula(beyond, NAMES)


def test_depth_is_counted_after_what_has_been_closed() -> None:
    """What stands before, however deep, neither adds to the depth nor takes from it."""
    for before in ("(((x))) + ", "x^1^1^1 + ", "(x)*(x) + ", "sin((x)) + "):
        parse_formula(before + "(" * 49 + "x" + ")" * 49, NAMES)
        with pytest.raises(FormulaError, match="nested deeper than 50"):
            parse_formula(before + "(" * 50 + "x" + ")" * 50, NAMES)


def test_the_zeroth_power_does_not_forget_what_it_is_a_power_of() -> None:
    with pytest.raises(FormulaError, match="powers may nest to at most 64"):
        parse_formula("((x^8)^0)^9", NAMES)


def test_what_stands_side_by_side_is_not_nested() -> None:
    assert parse_formula("+".join(["(x)"] * 60), NAMES) is parse_formula("60*x", NAMES)
    assert parse_formula("*".join(["x^1"] * 60), NAMES) is parse_formula("x^60", NAMES)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("x + $", """unexpected '$' at character 5 of "x + $\""""),
        ("x y", """unexpected 'y' at character 3 of "x y\""""),
        ("x) ", """unexpected ')' at character 2 of "x) \""""),
        ("(x + y", """')' is missing at character 7 of "(x + y\""""),
        ("x +", """the formula ends where a number, a name or '(' must follow at character 4 of "x +\""""),
        ("x*/y", """unexpected '/' at character 3 of "x*/y\""""),
        ("x + sin y", """sin needs '(' at character 5 of "x + sin y\""""),
        ("y/(x - x)", """division by zero at character 2 of "y/(x - x)\""""),
        ("2 + 0^-1", """division by zero at character 6 of "2 + 0^-1\""""),
        ("x" + "+x" * 29 + "$", "unexpected '$' at character 60 of \"x" + "+x" * 29 + '$"'),
        ("x" + "+x" * 29 + "+$", "unexpected '$' at character 61 of \"x" + "+x" * 28 + '..."'),
        ("x" + "+x" * 30 + "$", "unexpected '$' at character 62 of \"x" + "+x" * 28 + '..."'),
        ("x " + "2" * 50, "unexpected '" + "2" * 40 + "' at character 3 of \"x " + "2" * 50 + '"'),
    ],
)
def test_the_message_says_where(text: str, message: str) -> None:
    with pytest.raises(FormulaError) as caught:
        parse_formula(text, NAMES)
    assert str(caught.value) == message


def test_what_is_known_is_listed_up_to_30_names() -> None:
    names = {f"a{k:02}": Symbol(f"a{k:02}") for k in range(31)}
    thirty = dict(list(names.items())[:30])
    for known, end in ((thirty, "a28, a29"), (names, "a28, a29, ...")):
        with pytest.raises(FormulaError) as caught:
            parse_formula("wholly", known)
        assert str(caught.value).endswith(f"; known here: {', '.join(sorted(thirty)[:-2])}, {end}")
    with pytest.raises(FormulaError) as caught:
        parse_formula("wholly_" * 7, {})
    assert str(caught.value) == f"unknown name '{('wholly_' * 7)[:40]}' at character 1 of \"{'wholly_' * 7}\""


@pytest.mark.parametrize(
    ("text", "same"),
    [
        ("x - y + phi - x", "phi - y"),
        ("+x", "x"), ("--x", "x"), ("-+-x", "x"), ("+-x", "-1*x"), ("x--y", "x + y"), ("2*-x", "-2*x"), ("x^+2", "x*x"),
        ("x/-y", "-x/y"), ("1.25", "5/4"), (".5", "1/2"), ("10.", "10"), ("log(x)", "log(+x)"), ("  x  +\ty ", "x+y"),
    ],
)  # fmt: skip
def test_signs_spaces_and_decimals(text: str, same: str) -> None:
    assert parse_formula(text, NAMES) is parse_formula(same, NAMES)


@pytest.mark.parametrize("text", ["x*y*phi", "x/y*phi/3", "x/y/phi*2", "2*x*y - x*3/phi*y - phi*phi*x"])
def test_products_of_more_than_two(text: str) -> None:
    x, y, phi = sympy.symbols("x y phi")
    expected = eval(text, {"x": x, "y": y, "phi": phi})
    assert sympy.simplify(to_sympy(parse_formula(text, NAMES)) - expected) == 0


def test_the_functions_are_sympys() -> None:
    x = sympy.Symbol("x")
    for name in ("sin", "cos", "tan", "exp", "log", "sqrt"):
        found = to_sympy(parse_formula(f"{name}(x)", NAMES))
        assert sympy.simplify(found - getattr(sympy, name)(x)) == 0
