"""What a file that concludes, orders, hulls or covers may not write: README.md says why, rule by rule."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass

from rigour.types_of_expressions import BALL, FLOAT, UNKNOWN, Kinds

FLOATS, ORDER, NEGATION, ZERO, HULL, EXCEPT, ASSERT, EVIDENCE, SAYS, WRITTEN = (
    "floats", "order", "negation", "zero", "hull", "except", "assert", "evidence", "says", "written"
)  # fmt: skip
RULES = (FLOATS, ORDER, NEGATION, ZERO, HULL, EXCEPT, ASSERT, EVIDENCE, SAYS, WRITTEN)

_ORDERINGS = ("min", "max", "sorted", "sort", "nsmallest", "nlargest", "bisect", "bisect_left", "bisect_right")
_COMPARED = (ast.Lt, ast.Gt, ast.LtE, ast.GtE, ast.Eq, ast.NotEq)
_BROAD = ("BaseException", "Exception", "ValueError", "TypeError", "ArithmeticError", "RuntimeError",
          "AttributeError", "LookupError", "AssertionError")  # fmt: skip
_SAYING = ("proved", "refuted")
_OUTWARD = ("ball_text",)


@dataclass(frozen=True, slots=True)
class Finding:
    """One place that breaks a rule; ``scope`` is the function or class that it stands in, "" outside of all."""

    rule: str
    line: int
    scope: str
    text: str


def findings(tree: ast.Module, kinds: Kinds) -> Iterator[Finding]:
    """Every place of the file that breaks a rule."""
    scopes = _scopes(tree, kinds)
    ignored, claiming_nothing = _of_types(tree), _of_refusals(tree)
    for node in ast.walk(tree):
        if _writes_outward(node, kinds) and id(node) not in claiming_nothing:
            yield Finding(WRITTEN, getattr(node, "lineno", 0), scopes[id(node)].name, ast.unparse(node).splitlines()[0])
        if id(node) in ignored or not isinstance(node, ast.expr | ast.stmt | ast.ExceptHandler):
            continue
        for rule in _broken(node, kinds, scopes):
            yield Finding(rule, node.lineno, scopes[id(node)].name, ast.unparse(node).splitlines()[0])


def _broken(node: ast.AST, kinds: Kinds, scopes: dict[int, _Scope]) -> Iterator[str]:
    if _takes_a_float(node):
        yield FLOATS
    if isinstance(node, ast.Call):
        name = _called(node)
        if name in _ORDERINGS and _orders_inexactly(node, kinds):
            yield ORDER
        if name == "is_zero" and isinstance(node.func, ast.Attribute) and BALL in kinds(node.func.value):
            yield ZERO
        if name == "union" and isinstance(node.func, ast.Attribute) and BALL in kinds(node.func.value):
            yield HULL
        if name == "hull" and _names_only_ends(node):
            yield HULL
        if name == "Verdict":
            yield SAYS
    if _makes_evidence_by_hand(node):
        yield EVIDENCE
    if isinstance(node, ast.Attribute) and node.attr in _SAYING and ast.unparse(node.value) == "Verdict":
        yield SAYS
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not) and _compares_balls(node.operand, kinds):
        test = scopes[id(node)].test_of.get(id(node))
        if test is None or not _refuses(test):
            yield NEGATION
    if isinstance(node, ast.ExceptHandler) and _is_broad(node) and not isinstance(node.body[-1], ast.Raise):
        yield EXCEPT
    if isinstance(node, ast.Assert) and not _only_tells_the_type(node.test):
        yield ASSERT


def _takes_a_float(node: ast.AST) -> bool:
    """``float`` and ``complex`` as functions, ``approximate``, the midpoint of a ball."""
    if isinstance(node, ast.Name):
        return isinstance(node.ctx, ast.Load) and node.id in ("float", "complex", "approximate")
    return isinstance(node, ast.Attribute) and node.attr == "mid"


def _writes_outward(node: ast.AST, kinds: Kinds) -> bool:
    """A ball as text: ``ball_text``, ``str`` of a ball, a ball in an f-string. The text holds more than the ball."""
    if isinstance(node, ast.FormattedValue):
        return BALL in kinds(node.value)
    if isinstance(node, ast.Name):
        return isinstance(node.ctx, ast.Load) and node.id in _OUTWARD
    if not (isinstance(node, ast.Call) and _called(node) == "str"):
        return False
    if isinstance(node.func, ast.Attribute):
        return BALL in kinds(node.func.value)
    return any(BALL in kinds(argument) for argument in node.args)


def _makes_evidence_by_hand(node: ast.AST) -> bool:
    """Evidence that is made elsewhere than by a comparison of evidence.py."""
    return isinstance(node, ast.Attribute) and node.attr == "_of_facts"


def _called(node: ast.Call) -> str:
    return node.func.attr if isinstance(node.func, ast.Attribute) else ast.unparse(node.func)


def _orders_inexactly(node: ast.Call, kinds: Kinds) -> bool:
    """By a key that is a float or a ball, or balls themselves. ``x.min(y)`` of balls encloses the least and is none."""
    key = next((word.value for word in node.keywords if word.arg == "key"), None)
    if key is not None:
        return bool({BALL, FLOAT, UNKNOWN} & kinds(key))
    if isinstance(node.func, ast.Attribute) and node.func.attr in ("min", "max"):
        return False
    listed = [node.func.value] if _called(node) == "sort" and isinstance(node.func, ast.Attribute) else node.args
    return any(BALL in kinds(part.value if isinstance(part, ast.Starred) else part) for part in listed)


def _names_only_ends(node: ast.Call) -> bool:
    """A hull over the first or the last of several parts: those between them would be left out."""
    ends = [part for argument in node.args for part in ast.walk(argument) if isinstance(part, ast.Subscript)]
    return {"0", "-1"} <= {ast.unparse(part.slice) for part in ends}


def _compares_balls(node: ast.expr, kinds: Kinds) -> bool:
    """A comparison of balls, whose False may be "certainly not" or "not certain"; also inside of and, or, all, any."""
    if isinstance(node, ast.Compare):
        return any(isinstance(op, _COMPARED) for op in node.ops) and any(
            {BALL, UNKNOWN} & kinds(side) for side in (node.left, *node.comparators)
        )
    if isinstance(node, ast.BoolOp):
        return any(_compares_balls(value, kinds) for value in node.values)
    if isinstance(node, ast.UnaryOp):
        return _compares_balls(node.operand, kinds)
    if isinstance(node, ast.Call) and ast.unparse(node.func) in ("bool", "all", "any"):
        return any(_compares_balls(part, kinds) for part in node.args)
    if isinstance(node, ast.GeneratorExp | ast.ListComp):
        return _compares_balls(node.elt, kinds)
    return False


def _refuses(node: ast.If) -> bool:
    """``if not (hypothesis): raise``, or return None, or what is not finite, or undecided: nothing is concluded."""
    last = node.body[-1]
    if isinstance(last, ast.Return):
        value = last.value
        if value is None or (isinstance(value, ast.Constant) and value.value is None):
            return True
        return isinstance(value, ast.Call) and _called(value) in ("nonfinite", "undecided")
    return isinstance(last, ast.Raise)


def _is_broad(node: ast.ExceptHandler) -> bool:
    if node.type is None:
        return True
    named = node.type.elts if isinstance(node.type, ast.Tuple) else [node.type]
    return any(ast.unparse(name) in _BROAD for name in named)


def _only_tells_the_type(test: ast.expr) -> bool:
    """``x is not None`` and ``isinstance(x, T)``: what mypy cannot see; without it the next line fails."""
    if isinstance(test, ast.Call):
        return ast.unparse(test.func) == "isinstance"
    return isinstance(test, ast.Compare) and [type(op) for op in test.ops] == [ast.IsNot]


class _Scope:
    """A function or class by its dotted name, and for each negation in it the ``if`` that it is the test of."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.test_of: dict[int, ast.If] = {}


def _note_tests(statement: ast.If, test: ast.expr, scope: _Scope, kinds: Kinds) -> None:
    """Each part of the test that is enough to come into the body; beside a comparison of balls by ``and`` it is not."""
    scope.test_of[id(test)] = statement
    for part in test.values if isinstance(test, ast.BoolOp) else []:
        others = [other for other in test.values if other is not part]
        if isinstance(test.op, ast.Or) or not any(_compares_balls(other, kinds) for other in others):
            _note_tests(statement, part, scope, kinds)


def _scopes(tree: ast.Module, kinds: Kinds) -> dict[int, _Scope]:
    found: dict[int, _Scope] = {}

    def visit(node: ast.AST, scope: _Scope) -> None:
        found[id(node)] = scope
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            scope = _Scope(f"{scope.name}.{node.name}".lstrip("."))
        if isinstance(node, ast.If):
            _note_tests(node, node.test, scope, kinds)
        for child in ast.iter_child_nodes(node):
            visit(child, scope)

    visit(tree, _Scope(""))
    return found


def _of_refusals(tree: ast.Module) -> set[int]:
    """The nodes of errors that are raised and of verdicts that are undecided: they claim nothing."""
    places = [node for node in ast.walk(tree) if isinstance(node, ast.Raise)
              or (isinstance(node, ast.Call) and _called(node) == "undecided")]  # fmt: skip
    return {id(part) for place in places for part in ast.walk(place)}


def _of_types(tree: ast.Module) -> set[int]:
    """The nodes of annotations and of what ``isinstance`` asks for: names of types, not values."""
    places: list[ast.AST] = []
    for node in ast.walk(tree):
        places += [note for field in ("annotation", "returns") if (note := getattr(node, field, None)) is not None]
        if isinstance(node, ast.Call) and ast.unparse(node.func) in ("isinstance", "issubclass"):
            places += node.args[1:]
        if isinstance(node, ast.Call) and ast.unparse(node.func) == "cast":
            places += node.args[:1]
        if isinstance(node, ast.Subscript) and ast.unparse(node.value).split(".")[-1] in (
            "tuple", "list", "dict", "set", "frozenset", "Callable", "Sequence", "Iterable", "Mapping"
        ):  # fmt: skip
            places.append(node.slice)
        if (
            isinstance(node, ast.Compare)
            and isinstance(node.ops[0], ast.Is)
            and isinstance(node.comparators[0], ast.Name)
        ):
            places += node.comparators
    return {id(part) for place in places for part in ast.walk(place)}
