"""What mypy knows of each expression: whether it may be a ball, or a float."""

from __future__ import annotations

import ast
import sys
from collections.abc import Callable, Mapping
from pathlib import Path

from mypy import build
from mypy.config_parser import parse_config_file
from mypy.inspections import find_by_location
from mypy.modulefinder import BuildSource
from mypy.nodes import MypyFile
from mypy.options import Options
from mypy.types import AnyType, CallableType, Instance, TupleType, Type, TypeVarType, UnionType, get_proper_type

ROOT = Path(__file__).resolve().parents[2]

BALL, FLOAT, EXACT, UNKNOWN = "ball", "float", "exact", "unknown"

Kinds = Callable[[ast.expr], frozenset[str]]
"""What an expression of one file may be; several where it is one of several, or holds several."""

_BALLS = ("arb", "acb", "arb_mat", "acb_mat", "arb_poly", "acb_poly", "arb_series", "acb_series")
_BALL_NAMES = {f"flint.types.{name}.{name}" for name in _BALLS}
_KEYED = ("builtins.dict", "typing.Mapping", "typing.MutableMapping")
_FLOAT_NAMES = ("builtins.float", "builtins.complex", "numpy.")


def kinds_of_type(kind: Type, depth: int = 0) -> frozenset[str]:
    """What a value of the type may be; of a container its elements, of a function what it returns."""
    kind = get_proper_type(kind)
    if isinstance(kind, UnionType | TupleType):
        return frozenset[str]().union(*(kinds_of_type(item, depth + 1) for item in kind.items))
    if isinstance(kind, CallableType):
        return kinds_of_type(kind.ret_type, depth + 1)
    if isinstance(kind, AnyType | TypeVarType):
        return frozenset({UNKNOWN})
    if not isinstance(kind, Instance):
        return frozenset({EXACT})
    name = kind.type.fullname
    if name in _BALL_NAMES:
        return frozenset({BALL})
    if name.startswith(_FLOAT_NAMES):
        return frozenset({FLOAT})
    if name in _KEYED:
        return kinds_of_type(kind.args[0], depth + 1)
    if kind.args and depth < 8:
        return frozenset[str]().union(*(kinds_of_type(argument, depth + 1) for argument in kind.args))
    return frozenset({EXACT})


def kinds_in_files(files: Mapping[str, Path], strict: bool = True) -> dict[str, Kinds]:
    """For each module, given with its file, the function that says what its expressions may be.

    :raises ValueError: ``strict``, and mypy finds an error, so that what it knows of the rest is not to be relied on.
    """
    options = Options()
    parse_config_file(options, lambda: None, str(ROOT / "pyproject.toml"), sys.stdout, sys.stderr)
    options.incremental = False  # what comes from a cache has no types of expressions
    options.export_types = True
    options.preserve_asts = True
    found = build.build([BuildSource(str(path), module) for module, path in files.items()], options)
    if strict and found.errors:
        raise ValueError("\n".join(found.errors))

    def kinds_in(tree: MypyFile) -> Kinds:
        def kinds(node: ast.expr) -> frozenset[str]:
            if node.end_lineno is None or node.end_col_offset is None:
                return frozenset({UNKNOWN})
            same = find_by_location(tree, node.lineno, node.col_offset, node.end_lineno, node.end_col_offset)
            known = None if same is None else found.types.get(same)
            return frozenset({UNKNOWN}) if known is None else kinds_of_type(known)

        return kinds

    return {module: kinds_in(found.files[module]) for module in files}
