"""The page on formulas lists what the parser knows, all of it and nothing else."""

from __future__ import annotations

import re
from pathlib import Path

import formula_language
import pytest
from flint import fmpq

from gspot_verified.mechanisms.formulas import formula
from gspot_verified.mechanisms.formulas.formula import parse_formula
from gspot_verified.mechanisms.formulas.names import FUNCTIONS, FormulaError
from gspot_verified.mechanisms.formulas.simplify import constant, rational_value
from gspot_verified.mechanisms.input.file import KEYS, parse_mechanism

ROOT = Path(__file__).resolve().parents[2]
TEXT = formula_language.language()


def test_every_function_of_the_parser_has_its_meaning() -> None:
    assert set(formula_language.MEANINGS) == set(FUNCTIONS)
    assert re.findall(r"^\| `(\w+)\(…\)`", TEXT, re.MULTILINE) == list(FUNCTIONS)
    x = {"x": constant(fmpq(1, 2))}
    for name in FUNCTIONS:
        parse_formula(f"{name}(x)", x)
    with pytest.raises(FormulaError, match="unknown name 'abs'"):
        parse_formula("abs(x)", x)


def test_every_limit_is_listed_with_its_value() -> None:
    limits = {name: value for name, value in vars(formula).items() if name.startswith("MAX_")}
    assert set(formula_language.LIMITS) == set(limits)
    for name, words in formula_language.LIMITS.items():
        assert f"| {words} | {limits[name]} |" in TEXT


def test_the_sample_is_a_mechanism_and_its_keys_are_those_of_files() -> None:
    assert parse_mechanism(formula_language.SAMPLE).state[:3] == ("X", "Y", "theta")
    known = {f"{table}.{key}" for table, keys in KEYS.items() for key in keys}
    assert set(formula_language.PLACES) <= known


def test_the_names_of_each_key() -> None:
    state = {"X", "Y", "theta", "X_dot", "Y_dot", "theta_dot", "t"}
    for place in formula_language.PLACES:
        names = set(formula_language.names_at(place))
        assert {"m", "mu"} <= names
        assert names >= state or not names & state
        assert (names >= state) == (place not in ("parameters.*", "g_spot.point.*"))
    assert "theta_ref" in formula_language.names_at("g_spot.point.*")


@pytest.mark.parametrize(
    ("text", "value"),
    [("3", 3), ("0.1", fmpq(1, 10)), ("2*3^2", 18), ("4**(-1/2)", fmpq(1, 2)), ("(1-2)/4", fmpq(-1, 4))],
)  # fmt: skip
def test_what_the_page_says_of_numbers_and_operators(text: str, value: object) -> None:
    assert rational_value(parse_formula(text, {})) == value


@pytest.mark.parametrize("text", ["1e-3", "2x", "x^0.3", "x^(1/3)", "_x", "X"])
def test_what_the_page_says_is_not_in_the_language(text: str) -> None:
    with pytest.raises(FormulaError):
        parse_formula(text, {"x": constant(fmpq(1, 2))})


def test_the_page_shows_the_lists() -> None:
    page = (ROOT / "docs" / "formulas.md").read_text(encoding="utf-8")
    assert "```{include} formula_language.txt\n```" in page
