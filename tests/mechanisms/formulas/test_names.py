"""Names of formulas: what is one, and what is said of what is none."""

from __future__ import annotations

import pytest

from gspot_verified.mechanisms.formulas.names import FUNCTIONS, FormulaError, alike, check_name, nearest, normal_name


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("x" * 41, "at most 40 characters"),
        ("x" * 60, "^'" + "x" * 50 + "' is no name"),
        ("sin", "'sin' is a function and cannot be a name"),
        ("pi", "'pi' is a number and cannot be a name"),
    ],
)
def test_a_bad_name_is_told_why(name: str, message: str) -> None:
    with pytest.raises(FormulaError, match=message):
        check_name(name)
    assert check_name("x" * 40) == "x" * 40


@pytest.mark.parametrize(
    ("letter", "same"),
    [("\u2212", "-"), ("\u00b5", "\u03bc"), ("\u03d5", "\u03c6"), ("\u03d1", "\u03b8"), ("\u03f5", "\u03b5")],
)
def test_letters_that_look_alike_are_one(letter: str, same: str) -> None:
    assert normal_name(f"a{letter}b") == f"a{same}b"
    if same != "-":
        assert check_name(letter) == same


def test_no_function_is_a_name() -> None:
    for name in FUNCTIONS:
        with pytest.raises(FormulaError, match=f"'{name}' is a function and cannot be a name"):
            check_name(name)


def test_a_guess_is_near() -> None:
    assert nearest("thetta", ["phi", "theta", "omega"]) == "; did you mean 'theta'?"
    assert nearest("q", ["phi", "theta"]) == ""


def test_only_a_text_is_a_name() -> None:
    for other in (3, None, b"x"):
        with pytest.raises(FormulaError, match="is no name"):
            check_name(other)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "names", [("phi", "X", "\N{GREEK CAPITAL LETTER CHI}"), ("o_1", "\N{GREEK SMALL LETTER OMICRON}_1")]
)
def test_two_names_that_look_alike(names: tuple[str, ...]) -> None:
    assert alike(names) == names[-2:]
    assert alike(names[:-1]) is None
    assert alike([*names[:-1], names[0]]) is None
