"""No public class name stands twice in one layer: who reads it knows which class is meant."""

from __future__ import annotations

import ast
from collections.abc import Iterable
from pathlib import Path

from house.test_layout import FILES, name_of, nodes_of


def homes(classes: Iterable[tuple[str, str]]) -> dict[tuple[str, str], list[str]]:
    """(layer, class name) and the files that define it, from pairs (file, class name); private names left out."""
    found: dict[tuple[str, str], list[str]] = {}
    for file, name in classes:
        if not name.startswith("_"):
            found.setdefault((file.split("/")[0], name), []).append(file)
    return found


def twice(classes: Iterable[tuple[str, str]]) -> dict[tuple[str, str], list[str]]:
    return {place: files for place, files in homes(classes).items() if len(files) > 1}


def classes_of(path: Path) -> list[tuple[str, str]]:
    return [(name_of(path), node.name) for node in nodes_of(path) if isinstance(node, ast.ClassDef)]


def test_no_class_name_stands_twice_in_a_layer() -> None:
    classes = [pair for path in FILES for pair in classes_of(path)]
    assert ("signs/cover/pieces.py", "ColumnPiece") in classes
    assert twice(classes) == {}


def test_the_rule_itself() -> None:
    cover, zeros, force = "signs/cover/a.py", "signs/zeros/b.py", "compliant/c.py"
    assert twice([(cover, "Piece"), (zeros, "Piece"), (force, "Piece")]) == {("signs", "Piece"): [cover, zeros]}
    assert twice([(cover, "Piece"), (force, "Piece"), (cover, "_State"), (zeros, "_State")]) == {}
