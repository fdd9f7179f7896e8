"""Every number with a name at the top of a module has its words: what it is, and why this value if there is a why."""

from __future__ import annotations

import ast
import io
import tokenize
from itertools import zip_longest

import pytest
from house.test_layout import FILES, name_of

FOLDERS = (
    "numbers", "functions", "work", "theta_function", "signs", "leading_order", "expansion", "integrator", "compliant",
    "mechanisms", "scenes", "certificates", "testing", "cost", "hard_cases", "report", "cli",
)  # fmt: skip
NUMBERS = {"fmpq", "fmpz", "arb", "math"}
"""The names from which a number may be made; a table or a text is no number."""


def is_number(value: ast.AST) -> bool:
    """Whether the expression is made of numbers alone; of a tuple each part is asked."""
    match value:
        case ast.Constant(number):
            return type(number) in (int, float)
        case ast.UnaryOp(operand=part):
            return is_number(part)
        case ast.BinOp(left=left, right=right):
            return is_number(left) and is_number(right)
        case ast.Call(func=ast.Name(name) | ast.Attribute(value=ast.Name(name)), args=[_, *_] as parts):
            return name in NUMBERS and all(map(is_number, parts))
    return False


def constants(tree: ast.Module) -> list[tuple[ast.Assign | ast.AnnAssign, ast.stmt | None]]:
    """The assignments of numbers to names, one or several on a line, each with the statement that follows it."""
    numbers = []
    for node, following in zip_longest(tree.body, tree.body[1:]):
        if isinstance(node, ast.Assign | ast.AnnAssign):
            several = isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Tuple)
            parts = node.value.elts if several and isinstance(node.value, ast.Tuple) else [node.value]
            if all(part is not None and is_number(part) for part in parts):
                numbers.append((node, following))
    return numbers


def without_words(source: str) -> list[str]:
    """The constants with no comment on their lines or right above them, and no text below."""
    tokens = tokenize.generate_tokens(io.StringIO(source).readline)
    comments = {
        token.start[0]: token.line.lstrip().startswith("#") for token in tokens if token.type == tokenize.COMMENT
    }
    bare = []
    for node, following in constants(ast.parse(source)):
        beside = any(line in comments for line in range(node.lineno, (node.end_lineno or node.lineno) + 1))
        below = isinstance(following, ast.Expr) and isinstance(following.value, ast.Constant)
        if not (beside or below or comments.get(node.lineno - 1, False)):
            bare.append(ast.unparse(node))
    return bare


@pytest.mark.parametrize("folder", FOLDERS)
def test_every_constant_has_its_words(folder: str) -> None:
    paths = [path for path in FILES if name_of(path).startswith(f"{folder}/")]
    sources = {name_of(path): path.read_text(encoding="utf-8") for path in paths}
    assert any(constants(ast.parse(source)) for source in sources.values())
    assert {name: bare for name, source in sources.items() if (bare := without_words(source))} == {}


@pytest.mark.parametrize(
    "bare",
    ["A = 64", "A: int = 64", "A = -2.0 ** 53", "A = fmpq(1, 2) / 3", "A, B = (1, fmpq(2))", "A = math.log2(10)"],
)
def test_a_number_needs_words(bare: str) -> None:
    assert without_words(f"C = 1  # of something else\n{bare}\n\nD = ''\n") == [bare]
    for told in (f"{bare}  # bits", f"# Bits.\n{bare}", f'{bare}\n"""Bits."""'):
        assert without_words(f"{told}\n") == []


@pytest.mark.parametrize(
    "other", ["A = (1, 2)", "A = 'text'", "A = True", "A = B", "A = f(1)", "A, B = 'a', 'b'", "A: int"]
)
def test_what_is_no_number_needs_none(other: str) -> None:
    assert without_words(other) == []
