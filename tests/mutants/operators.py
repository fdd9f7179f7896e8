"""Single-point changes of a source file: which mutants it has, what each one says, and the code of one of them.

The changes are those that a slip in a bound or in a guard would make: a comparison moved by one, a sign turned, a term
or a factor dropped, a constant moved, a condition forced, one operand of ``and``/``or`` dropped, a call that only
guards or widens taken away. A multiple of 64 is a working precision as a rule, and one bit more of it harms nothing: it
becomes 2. Texts, annotations, decorators and what stands inside ``raise`` are left alone.
"""

from __future__ import annotations

import ast
import copy
import re
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from pathlib import Path
from types import CodeType

_COMPARISONS: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq, ast.NotEq: ast.Eq,
    ast.Is: ast.IsNot, ast.IsNot: ast.Is, ast.In: ast.NotIn, ast.NotIn: ast.In,
}  # fmt: skip
_OPERATORS: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.Pow: ast.Mult,
    ast.LShift: ast.RShift, ast.RShift: ast.LShift, ast.BitAnd: ast.BitOr, ast.Mod: ast.FloorDiv,
}  # fmt: skip
_NAMES = {
    "min": "max", "max": "min", "any": "all", "all": "any", "floor": "ceil", "ceil": "floor", "lower": "upper",
    "upper": "lower", "abs_lower": "abs_upper", "abs_upper": "abs_lower", "certainly_less": "certainly_at_most",
    "certainly_at_most": "certainly_less",
}  # fmt: skip
_PRECISION = 64
_UNWRAPPED = ("abs", "sorted", "add_remainder", "union")
_TOKEN = re.compile(r"\w+|\s+|[<>=!*/&|]+|.")
_ONE_QUOTE = str.maketrans({'"': "'", "\\": None})  # which quotes ast.unparse chooses hangs on Python's version
_CONTEXT = 24  # letters of the line that are kept on each side of a change
_NOT_MUTATED = {"annotation", "returns", "decorator_list", "exc", "type_params"}


@dataclass(frozen=True)
class Mutant:
    """One change of one file. ``line``: where the changed statement begins; ``everywhere``: it runs at import.

    ``change``: the scope and the change with a little of the line around it, which name it in the list of survivors.
    """

    file: str
    scope: str
    before: str
    after: str
    change: str
    line: int
    everywhere: bool
    index: int

    @property
    def key(self) -> tuple[str, str]:
        """What names it in the list of survivors: it lasts as long as what stands around the change."""
        return self.file, self.change

    @property
    def wider(self) -> set[tuple[str, str]]:
        """What names every change of its line (of a table at module level: of its name), and of its function."""
        name = re.match(r"(\w+)(: [^=]+)? = ", self.before) if self.scope == "module" else None
        line = f"{name[1]} = " if name else self.before
        return {(self.file, f"{self.scope}: {line}*")} | (
            {(self.file, f"{self.scope}: *")} - {(self.file, "module: *")}
        )

    def __str__(self) -> str:
        return f"{self.file}:{self.line} {self.scope}\n    - {self.before}\n    + {self.after}"


@dataclass
class _Site:
    owner: ast.AST
    field: str
    position: int | None
    statement: ast.stmt
    scope: tuple[str, ...]
    everywhere: bool

    def put(self, node: object) -> None:
        if self.position is None:
            setattr(self.owner, self.field, node)
        else:
            getattr(self.owner, self.field)[self.position] = node


def mutants_of(root: Path, file: str, scopes: Collection[str] | None = None) -> list[Mutant]:
    """Every mutant of the file (of these ``scopes`` alone), in the order of its text. Equal changes are numbered."""
    tree = ast.parse((root / file).read_text(encoding="utf-8"))
    found: list[Mutant] = []
    seen: dict[tuple[str, ...], int] = {}
    headers: dict[ast.stmt, str] = {}
    for index, (site, node, changed) in enumerate(_changes(tree)):
        if site.statement not in headers:
            headers[site.statement] = _header(site.statement)
        before, scope = headers[site.statement], ".".join(site.scope) or "module"
        if scopes is not None and scope not in scopes:
            continue
        _apply(site, changed)
        # A statement that is taken away is replaced in its owner; the site still holds the old one.
        after = _header(changed) if node is site.statement else _header(site.statement)  # type: ignore[arg-type]
        _apply(site, node)
        count = seen[(scope, before, after)] = seen.get((scope, before, after), 0) + 1
        if before != after:
            change = f"{scope}: {short_change(before, after)}"
            place = seen[(change,)] = seen.get((change,), 0) + 1
            change = change if place == 1 else f"{change} #{place}"
            after = after if count == 1 else f"{after}  # occurrence {count}"
            found.append(Mutant(file, scope, before, after, change, site.statement.lineno, site.everywhere, index))
    return found


def short_change(before: str, after: str) -> str:
    """What changes, between brackets, and what stands next to it.

    >>> short_change("shift = (both & -both).bit_length()", "shift = (both | -both).bit_length()")
    'shift = (both [& → |] -both).bit_length()'
    """
    old, new = (_TOKEN.findall(text.translate(_ONE_QUOTE)) for text in (before, after))
    shorter = min(len(old), len(new))
    first = next((k for k in range(shorter) if old[k] != new[k]), shorter)
    last = next((k for k in range(shorter - first) if old[-1 - k] != new[-1 - k]), shorter - first)
    middle = f"[{''.join(old[first : len(old) - last])} → {''.join(new[first : len(new) - last])}]"
    left, right = _nearest(old[:first][::-1]), _nearest(old[len(old) - last :])
    return "".join([*reversed(left), middle, *right])


def _nearest(tokens: list[str]) -> list[str]:
    """The first of the tokens, and an ellipsis where some are left out."""
    kept = [token for k, token in enumerate(tokens) if sum(map(len, tokens[:k])) < _CONTEXT]
    return kept if len(kept) == len(tokens) else [*kept, "…"]


def code_of(root: Path, mutant: Mutant) -> CodeType:
    """The compiled module with the change."""
    path = root / mutant.file
    tree = ast.parse(path.read_text(encoding="utf-8"))
    for index, (site, _, changed) in enumerate(_changes(tree)):
        if index == mutant.index:
            _apply(site, changed)
            return compile(ast.fix_missing_locations(tree), str(path), "exec")
    raise LookupError(f"{mutant.file} has no change number {mutant.index}")


def traced_code(root: Path, file: str, reporter: str) -> CodeType:
    """The compiled module, calling the built-in name ``reporter`` with the line of each statement of its functions."""
    path = root / file
    tree = ast.parse(path.read_text(encoding="utf-8"))
    for function in [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)]:
        _report_each(function, "body", reporter, ast.get_docstring(function) is not None)
    return compile(ast.fix_missing_locations(tree), str(path), "exec")


def _report_each(node: ast.AST, field: str, reporter: str, keep_first: bool = False) -> None:
    reported: list[ast.stmt] = []
    for k, statement in enumerate(getattr(node, field)):
        if not (keep_first and k == 0):
            report = ast.Expr(ast.Call(ast.Name(reporter, ast.Load()), [ast.Constant(statement.lineno)], []))
            reported.append(ast.copy_location(report, statement))
        reported.append(statement)
        if isinstance(statement, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            continue
        for part in (statement, *getattr(statement, "handlers", []), *getattr(statement, "cases", [])):
            for block in ("body", "orelse", "finalbody"):
                if isinstance(getattr(part, block, None), list):
                    _report_each(part, block, reporter)
    setattr(node, field, reported)


def _apply(site: _Site, node: ast.AST) -> None:
    site.put(node)


def _header(statement: ast.stmt) -> str:
    """The statement on one line, without the block that it opens."""
    short = copy.copy(statement)
    for field in ("body", "orelse", "finalbody", "handlers", "decorator_list"):
        if hasattr(short, field):
            setattr(short, field, [ast.Expr(ast.Constant(...))] if field == "body" else [])
    lines = ast.unparse(ast.fix_missing_locations(short)).splitlines()
    return lines[0] if isinstance(getattr(statement, "body", None), list) else " ".join(line.strip() for line in lines)


def _changes(tree: ast.Module) -> Iterator[tuple[_Site, ast.AST, ast.AST]]:
    """(site, what stands there, what the mutant has there), collected before anything is changed."""
    sites: list[tuple[_Site, ast.AST]] = []
    _collect(tree, None, (), True, sites)
    for site, node in sites:
        for changed in _alternatives(node, site.owner):
            yield site, node, ast.copy_location(changed, node)


def _collect(
    node: ast.AST,
    statement: ast.stmt | None,
    scope: tuple[str, ...],
    everywhere: bool,
    sites: list[tuple[_Site, ast.AST]],
) -> None:
    for field, value in ast.iter_fields(node):
        if field in _NOT_MUTATED or isinstance(node, ast.JoinedStr):
            continue
        function = isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
        inside = everywhere and not (function and field == "body")
        for position, child in enumerate(value) if isinstance(value, list) else [(None, value)]:
            if not isinstance(child, ast.AST):
                continue
            holder = child if isinstance(child, ast.stmt) else statement
            named = isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef)
            deeper = (*scope, child.name) if named else scope  # type: ignore[attr-defined]
            if holder is not None:
                sites.append((_Site(node, field, position, holder, deeper, inside), child))
            _collect(child, holder, deeper, inside, sites)


def _alternatives(node: ast.AST, owner: ast.AST) -> Iterator[ast.AST]:
    match node:
        case ast.Compare():
            for k, operator in enumerate(node.ops):
                if type(operator) in _COMPARISONS:
                    ops = [*node.ops[:k], _COMPARISONS[type(operator)](), *node.ops[k + 1 :]]
                    yield ast.Compare(node.left, ops, node.comparators)
        case ast.BoolOp():
            for k in range(len(node.values)):
                rest = [*node.values[:k], *node.values[k + 1 :]]
                yield rest[0] if len(rest) == 1 else ast.BoolOp(node.op, rest)
        case ast.BinOp():
            if type(node.op) in _OPERATORS:
                yield ast.BinOp(node.left, _OPERATORS[type(node.op)](), node.right)
            if isinstance(node.op, ast.Add | ast.Sub | ast.Div | ast.FloorDiv):
                yield node.left
            if isinstance(node.op, ast.Add | ast.Mult):
                yield node.right
        case ast.UnaryOp(op=ast.Not() | ast.USub()):
            yield node.operand
        case ast.Constant(value=bool(value)):
            yield ast.Constant(not value)
        case ast.Constant(value=int(value)):
            yield ast.Constant(2 if value >= _PRECISION and value % _PRECISION == 0 else value + 1)
        case ast.Constant(value=float(value)):
            yield ast.Constant(2 * value)
        case ast.IfExp():
            yield node.body
            yield node.orelse
        case ast.comprehension():
            for k in range(len(node.ifs)):
                yield ast.comprehension(node.target, node.iter, [*node.ifs[:k], *node.ifs[k + 1 :]], node.is_async)
        case ast.Call():
            yield from _other_calls(node)
        case ast.stmt():
            yield from _other_statements(node, owner)


def _other_calls(node: ast.Call) -> Iterator[ast.AST]:
    match node.func:
        case ast.Name(id=name) | ast.Attribute(attr=name) if name in _NAMES:
            function = copy.copy(node.func)
            setattr(function, "id" if isinstance(function, ast.Name) else "attr", _NAMES[name])
            yield ast.Call(function, node.args, node.keywords)
            if name in ("min", "max") and len(node.args) == 2:
                yield from node.args
    match node.func:
        case ast.Name(id=name) if name in _UNWRAPPED and node.args:
            yield node.args[0]
        case ast.Attribute(attr=name) if name in (*_UNWRAPPED, "abs_lower", "abs_upper"):
            yield node.func.value


def _other_statements(node: ast.stmt, owner: ast.AST) -> Iterator[ast.AST]:
    match node:
        case ast.If():
            yield ast.If(ast.Constant(False), node.body, node.orelse)
            if not isinstance(node.body[0], ast.Raise):
                yield ast.If(ast.Constant(True), node.body, node.orelse)
        case ast.While(test=test) if not isinstance(test, ast.Constant):
            yield ast.While(ast.Constant(False), node.body, node.orelse)
        case ast.Assert() | ast.Expr(value=ast.Call()):
            yield ast.Pass()
        case ast.Raise() if not isinstance(owner, ast.If):
            yield ast.Pass()
        case ast.AugAssign():
            if type(node.op) in _OPERATORS:
                yield ast.AugAssign(node.target, _OPERATORS[type(node.op)](), node.value)
            yield ast.Pass()
        case ast.Continue():
            yield ast.Break()
        case ast.Break():
            yield ast.Continue()
