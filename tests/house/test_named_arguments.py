"""No call has eight positional arguments: nobody can tell the sixth from the seventh. Such calls name them."""

from __future__ import annotations

import ast
from collections.abc import Iterable

from house.test_layout import FILES, name_of, nodes_of

TOO_MANY = 8
# Functions that take any number of arguments of one kind, which have no names.
VARIADIC = {
    "settled": "the place of a statement, then as many checks as it has",
    "jets": "the time, then as many functions of it as there are",
}


def called(call: ast.Call) -> str:
    """The last part of the name of what is called; "" where it has none."""
    return ast.unparse(call.func).rsplit(".", 1)[-1] if isinstance(call.func, ast.Name | ast.Attribute) else ""


def long_calls(nodes: Iterable[ast.AST]) -> list[tuple[int, str]]:
    """(line, name) of every call with eight positional arguments or more."""
    return [(n.lineno, called(n)) for n in nodes if isinstance(n, ast.Call) and len(n.args) >= TOO_MANY]


def test_long_calls_name_their_arguments() -> None:
    found = [(name_of(path), line, name) for path in FILES for line, name in long_calls(nodes_of(path))]
    assert [place for place in found if place[2] not in VARIADIC] == []
    assert {name for _, _, name in found} == set(VARIADIC)


def test_the_variadic_functions_are_variadic() -> None:
    functions = [node for path in FILES for node in nodes_of(path) if isinstance(node, ast.FunctionDef)]
    assert {node.name for node in functions if node.name in VARIADIC and node.args.vararg} == set(VARIADIC)


def test_the_rule_itself() -> None:
    numbers = ", ".join("12345678")
    named = ", ".join(f"{name}=0" for name in "abcdefgh")
    short = numbers[:-3]
    for text, long in (
        (f"room.call({numbers})", [1]),
        (f"call({named})\ncall({short}, *more)", [2]),
        (f"call({short}, h=8)", []),
    ):
        assert long_calls(ast.walk(ast.parse(text))) == [(line, "call") for line in long]
