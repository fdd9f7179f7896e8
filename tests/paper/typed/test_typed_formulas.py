"""The formulas that the ledger holds as typed texts are those of the paper's LaTeX: compared by a program."""

from __future__ import annotations

import ast
import json
import re
from collections.abc import Iterator, Sequence
from functools import cache
from importlib import resources
from operator import add, mul, sub, truediv
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
import sympy
from paper.bite import scaled
from paper.paper_reader import read
from paper.typed import general_system, motivating_example, premises
from paper.typed.latex_formula import Sides, formula, pieces, sides, tokens
from paper.typed.row import Row
from paper.typed.unread import DEFINITION, UNREAD, UNREAD_LINES, UNTYPED

from gspot_verified.functions.symbols import RationalFunction, Symbols
from gspot_verified.paper.checks.formulas import closed_form
from gspot_verified.paper.claims import Standing, paper_claims
from gspot_verified.paper.section_1 import section_1_rigid
from gspot_verified.paper.section_2 import lagrangian
from gspot_verified.paper.section_4 import (
    section_4_fast,
    section_4_inner,
    section_4_matching,
    section_4_outer,
    section_4_slow,
    section_4_trivial,
    section_4_unique,
)
from gspot_verified.paper.section_5 import (
    example,
    section_5_ansatz,
    section_5_matching,
    section_5_outer,
    section_5_recursion,
    section_5_right_sides,
)
from gspot_verified.paper.section_6 import oscillator

PAPER = Path(__file__).resolve().parents[4] / "shared" / "paper.tex"
REPAIRED = {r"\phi_0\right))+c_": r"\phi_0\right)+c_"}
"""Line 2538 has a closing bracket too many."""
POLYNOMIALS: tuple[ModuleType, ...] = (
    section_1_rigid, lagrangian, section_4_trivial, section_4_outer, section_4_unique, section_4_fast, section_4_slow,
    section_4_inner, section_4_matching, section_5_recursion, section_5_right_sides, example, section_5_outer,
    section_5_ansatz, section_5_matching, oscillator,
)  # fmt: skip
LAYOUT = re.compile(
    r"\s*(?:\$\$|\\(?:beq|eeq|end|right|label|\\).*|(?:[^=]*=)?\s*(?:\\left\s*\\?[\[{])?\s*(?:\\begin\{.*)?)"
)
"""A line with a name, brackets and the begin or the end of something alone."""
_FUNCTIONS = {"exp", "log", "Gamma", "sqrt"}
_OPERATIONS: dict[type, Any] = {ast.Add: add, ast.Sub: sub, ast.Mult: mul, ast.Div: truediv}
ROWS = motivating_example.ROWS + general_system.ROWS + premises.ROWS
IDS = [f"{row.entry}: {row.part}, line {row.first}" for row in ROWS]


@cache
def quoted() -> dict[int, str]:
    """The lines of the source that the data of the ledger hold."""
    text = resources.files("gspot_verified.paper").joinpath("paper_source.json").read_text(encoding="utf-8")
    found: dict[int, str] = {}
    for citation in json.loads(text)["citations"].values():
        for quotation in citation["quotations"]:
            found |= dict(enumerate(quotation["latex"].split("\n"), quotation["first"]))
    return found


def printed_text(row: Row, latex: str = "") -> str:
    """What stands at the place of a row, read with its names."""
    latex = latex or "\n".join(quoted()[line] for line in range(row.first, row.last + 1))
    for wrong, right in REPAIRED.items():
        latex = latex.replace(wrong, right)
    if row.layout == "inline":
        latex = r"\\".join(re.findall(r"\$([^$]*)\$", latex))
    if row.layout in ("matrix", "row"):
        latex = latex.replace("&", "," if row.layout == "matrix" else "=")
    if row.layout == "1F2":
        for old in (r"{}_1F_2\left(", r"\right)", ";"):
            latex = latex.replace(old, ",")
    return row.printed(Sides(sides(pieces(latex)[row.piece]), row.names))


def same(row: Row, first: str, second: str) -> bool:
    """Whether two texts are one function."""
    if row.layout == "closed form":
        one, other = closed_form(first), closed_form(second)
        return one.is_zero() if other.is_zero() else (one / other).is_one()
    try:
        ring = Symbols(*sorted(_names(first) | _names(second)), "unit")
        return rational(first, ring) == rational(second, ring)
    except NoRationalFunction:
        return bool(sympy.simplify(by_sympy(first) - by_sympy(second)) == 0)


class NoRationalFunction(ValueError):
    """A formula with another power than an integer, or with a function."""


def _names(text: str) -> set[str]:
    return set(re.findall(r"[A-Za-z_]\w*", text)) - _FUNCTIONS


def rational(text: str, ring: Symbols) -> RationalFunction:
    """A text as an exact rational function."""

    def value(node: ast.expr) -> RationalFunction:
        match node:
            case ast.Constant(value=int(number)):
                return ring.number(number)
            case ast.Name(id=name):
                return ring.symbol(name)
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return -value(operand)
            case ast.BinOp(left=left, op=ast.Pow(), right=right):
                exponent = value(right).constant()
                if exponent is not None and exponent.q == 1:
                    return value(left) ** int(exponent.p)
            case ast.BinOp(left=left, op=operation, right=right):
                return _OPERATIONS[type(operation)](value(left), value(right))
        raise NoRationalFunction(ast.unparse(node))

    return value(ast.parse(text.replace("^", "**"), mode="eval").body)


def by_sympy(text: str) -> Any:
    """A text as sympy has it; all symbols stand for positive numbers, as logarithms of some are taken."""
    symbols: dict[str, Any] = {name: sympy.Symbol(name, positive=True) for name in _names(text)}
    return sympy.sympify(text.replace("^", "**"), locals=symbols | {"Gamma": sympy.gamma})


@pytest.mark.parametrize("row", ROWS, ids=IDS)
def test_the_typed_formula_is_the_printed_one(row: Row) -> None:
    text = printed_text(row)
    assert same(row, row.text, text), text
    if not same(row, row.text, "0"):
        assert not same(row, scaled(row.text), text)


def changed(latex: str) -> Iterator[str]:
    """The lines with one other digit, or one other sign, but for labels and signs of an error term."""
    plain = re.sub(r"\\label\{[^}]*\}|[+]\s*\\mathcal", lambda found: " " * len(found[0]), latex)
    for found in re.finditer(r"[\d+-]", plain):
        new = {"+": "-", "-": "+"}.get(found[0]) or {"9": "8"}.get(found[0]) or str(int(found[0]) + 1)
        yield latex[: found.start()] + new + latex[found.end() :]


def unnoticed(rows: Sequence[Row]) -> list[str]:
    """Changes of some lines that change what a row reads, and that none of their rows notices."""
    latex = "\n".join(quoted()[line] for line in range(rows[0].first, rows[0].last + 1))
    found = []
    for wrong in changed(latex):
        answers = []
        for row in rows:
            try:
                text = printed_text(row, wrong)
                answers += [same(row, row.text, text)] if text != printed_text(row, latex) else []
            except (ValueError, IndexError, ZeroDivisionError):
                answers.append(False)
        found += [wrong] if answers and all(answers) else []
    return found


def by_lines(rows: Sequence[Row]) -> list[list[Row]]:
    """The rows that read the same lines."""
    places = dict.fromkeys((row.first, row.last) for row in rows)
    return [[row for row in rows if (row.first, row.last) == place] for place in places]


@pytest.mark.parametrize("first", [602, 1066, 1671, 2429, 2453])
def test_a_changed_sign_or_digit_of_the_paper_is_noticed(first: int) -> None:
    (rows,) = [rows for rows in by_lines(ROWS) if rows[0].first == first]
    assert unnoticed(rows) == []


@pytest.mark.slow
def test_every_changed_sign_or_digit_of_the_paper_is_noticed() -> None:
    assert [wrong for rows in by_lines(ROWS) for wrong in unnoticed(rows)] == []


def test_every_typed_polynomial_is_read_or_has_a_reason() -> None:
    typed = {(entry, part) for module in POLYNOMIALS for entry, parts in module.PRINTED.items() for part in parts}
    # The fields of the extended example stand in three entries.
    seen = {(row.entry, row.part) for row in ROWS}
    seen |= {
        (entry, row.part) for row in ROWS for entry in ("2-lagrangian", "2-quantities") if row.entry == "2-extended"
    }
    assert typed - seen - set(UNTYPED) == set()
    assert set(UNTYPED) & seen == set()


def test_every_display_is_read_or_has_a_reason() -> None:
    if not PAPER.is_file():
        pytest.skip("the paper's source is not at hand")
    displays = read(PAPER.read_text(encoding="utf-8")).displays
    compared = {d.first for d in displays if any(d.first <= row.last and row.first <= d.last for row in ROWS)}
    assert {d.first for d in displays} - compared == set(UNREAD)
    assert (len(displays), len(compared)) == (144, 109)


def test_every_line_of_a_display_that_is_compared_is_read_or_has_a_reason() -> None:
    """A system of equations is not compared where one of them is."""
    if not PAPER.is_file():
        pytest.skip("the paper's source is not at hand")
    source = PAPER.read_text(encoding="utf-8")
    lines, seen = source.splitlines(), {n for row in ROWS for n in range(row.first, row.last + 1)}
    compared = {
        n for d in read(source).displays if seen & {*range(d.first, d.last + 1)} for n in range(d.first, d.last)
    }
    assert {n for n in compared - seen if not LAYOUT.fullmatch(lines[n - 1])} == set(UNREAD_LINES)


def test_a_display_that_says_nothing_is_in_no_row_with_entries_alone() -> None:
    if not PAPER.is_file():
        pytest.skip("the paper's source is not at hand")
    displays = {d.first: d for d in read(PAPER.read_text(encoding="utf-8")).displays}
    wrong = []
    for first in (first for first, why in UNREAD.items() if why == DEFINITION):
        rows = [row for row in paper_claims() if row.first <= displays[first].last and first <= row.last]
        if rows and not any(row.without_entries is Standing.PREMISE for row in rows):
            wrong.append(first)
    assert wrong == []


@pytest.mark.parametrize(
    ("latex", "text"),
    [
        (r"2b/p", "2*b/p"),
        (r"-\left[p\,b^2+\frac{1}{2}\right]", "-(p*b^2+1/2)"),
        (r"{\frac {138\,{b}^{4}}{5}}", "138*b^4/5"),
        (r"3^{p/3-1}(p)^{-b}", "3^(p/3-1)*p^(-b)"),
        (r"k!\Gamma\left(\frac{p}{3}\right)", "fac(k)*Gamma(p/3)"),
    ],
)
def test_the_reader_of_formulas(latex: str, text: str) -> None:
    read_text, orders = formula(tokens(latex), {name: name for name in "bpk"})
    assert orders == []
    if "!" in latex:
        read_text, text = (one.replace("fac", "Gamma") for one in (read_text, text))
    assert sympy.simplify(by_sympy(read_text) - by_sympy(text)) == 0


@pytest.mark.parametrize("latex", [r"b+q", r"\alpha_1 b", r"(b", r"b)", r"\frac{b}", r"b+"])
def test_what_is_not_told_is_refused(latex: str) -> None:
    with pytest.raises(ValueError, match=r"is not in the names|is missing before|not read"):
        formula(tokens(latex), {"b": "b"})


def test_equations_sides_and_orders() -> None:
    found = pieces(
        r"\dot p&=b,\label{eq:x} \quad v=\begin{pmatrix}0\\ b^{2,3}\end{pmatrix}+\mathcal{O}\left({b}^{7}\right)."
    )
    assert [len(sides(piece)) for piece in found] == [2, 2, 1]
    assert formula(sides(found[2])[0], {"b": "b", "2,3": "2"}) == ("(((b)^((2)))+0)", ["((((b))^(7)))"])


def test_the_longest_name_is_read_first() -> None:
    names = {r"\hat{b}": "g0", r"\frac{d\hat{b}}{ds}": "g1", "s": "s", r"\alpha_1^*": "alpha1"}
    assert formula(tokens(r"\alpha_1^*s\frac{d\hat b}{ds}"), names)[0] == "((alpha1)*(s)*(g1))"
