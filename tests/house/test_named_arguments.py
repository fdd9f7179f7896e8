"""No call has eight positional arguments: nobody can tell the sixth from the seventh. Such calls name them."""

from __future__ import annotations

import ast

from house.test_layout import FILES, name_of, tree_of

TOO_MANY = 8
# Functions that take any number of arguments of one kind, which have no names.
VARIADIC = {
    "settled": "the place of a statement, then as many checks as it has",
    "jets": "the time, then as many functions of it as there are",
}


def called(call: ast.Call) -> str:
    """The last part of the name of what is called; "" where it has none."""
    return ast.unparse(call.func).rsplit(".", 1)[-1] if isinstance(call.func, ast.Name | ast.Attribute) else ""


def long_calls(tree: ast.AST) -> list[tuple[int, str]]:
    """(line, name) of every call with eight positional arguments or more."""
    calls = [node for node in ast.walk(tree) if isinstance(node, ast.Call)]
    return [(call.lineno, called(call)) for call in calls if len(call.args) >= TOO_MANY]


def test_long_calls_name_their_arguments() -> None:
    found = [(name_of(path), line, name) for path in FILES for line, name in long_calls(tree_of(path))]
    assert [place for place in found if place[2] not in VARIADIC] == []
    assert {name for _, _, name in found} == set(VARIADIC)


def test_the_variadic_functions_are_variadic() -> None:
    functions = [node for path in FILES for node in ast.walk(tree_of(path)) if isinstance(node, ast.FunctionDef)]
    assert {node.name for node in functions if node.name in VARIADIC and node.args.vararg} == set(VARIADIC)


def test_the_rule_itself() -> None:
    numbers = ", ".join("12345678")
    named = ", ".join(f"{name}=0" for name in "abcdefgh")
    assert long_calls(ast.parse(f"room.call({numbers})")) == [(1, "call")]
    assert long_calls(ast.parse(f"call({named})\ncall({numbers[:-3]}, *more)")) == [(2, "call")]
    assert long_calls(ast.parse(f"call({numbers[:-3]}, h=8)")) == []
