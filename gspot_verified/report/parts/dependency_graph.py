"""The graph of what rests on what, as SVG: statements on the left, the proof pages that carry them to the right."""

from __future__ import annotations

import html
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

_ROW, _COLUMN, _WIDTH = 22, 300, 190  # pixels: from row to row, from column to column, and of a box
_SWEEPS = 6  # to and fro over the columns: any number is correct


@dataclass(frozen=True, slots=True)
class Node:
    """A box with a link; ``kind`` is a class of the style sheet."""

    name: str
    address: str
    kind: str


def graph_svg(nodes: Sequence[Node], arrows: Mapping[str, Sequence[str]]) -> str:
    """The nodes in columns, each to the right of a node that names it; the arrows of a node go to what it names.

    Nodes that nothing names stand in the first column if they name something, else they are left out.

    >>> made = graph_svg([Node("a", "a.html", "page"), Node("b", "b.html", "page")], {"a": ["b"]})
    >>> made.count("<rect"), made.count("<path")
    (2, 1)
    """
    by_name = {node.name: node for node in nodes}
    edges = {name: [other for other in arrows.get(name, ()) if other in by_name] for name in by_name}
    columns = _ordered(_columns(edges), edges)
    places = {
        name: (_COLUMN * number, _ROW * row) for number, column in enumerate(columns) for row, name in enumerate(column)
    }
    height = _ROW * max((len(column) for column in columns), default=0) + 4
    width = _COLUMN * len(columns)
    lines = [_curve(places[name], places[other]) for name in places for other in edges[name]]
    boxes = [_box(by_name[name], *place) for name, place in places.items()]
    return (
        f'<svg class="graph" viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img" '
        f'aria-label="What rests on what">{"".join(lines)}{"".join(boxes)}</svg>'
    )


def _columns(edges: Mapping[str, Sequence[str]]) -> list[list[str]]:
    """Column 0: what nothing names; then what is named first from the column before."""
    named = {other for others in edges.values() for other in others}
    column = [name for name, others in edges.items() if others and name not in named]
    seen = set(column)
    columns = []
    while column:
        columns.append(column)
        column = list(dict.fromkeys(other for name in column for other in edges[name] if other not in seen))
        seen |= set(column)
    return columns


def _ordered(columns: Sequence[Sequence[str]], edges: Mapping[str, Sequence[str]]) -> list[list[str]]:
    """Fewer crossings: each column in the order of the mean heights of its neighbours, to and fro."""
    neighbours: dict[str, set[str]] = {name: set(others) for name, others in edges.items()}
    for name, others in edges.items():
        for other in others:
            neighbours[other].add(name)
    ordered = [list(column) for column in columns]
    for sweep in range(_SWEEPS):
        height = {name: row / len(column) for column in ordered for row, name in enumerate(column)}
        for number in range(1, len(ordered)) if sweep % 2 == 0 else range(len(ordered) - 1, -1, -1):
            heights = {
                name: [height[other] for other in neighbours[name] if other in height] for name in ordered[number]
            }
            ordered[number].sort(key=lambda name: sum(heights[name]) / len(heights[name]))
            height |= {name: row / len(ordered[number]) for row, name in enumerate(ordered[number])}
    return ordered


def _curve(start: tuple[int, int], end: tuple[int, int]) -> str:
    (x, y), (far, other) = start, end
    left, right = x + _WIDTH, far
    if far <= x:  # to the same column or back: around the right side
        back = far + _WIDTH
        return f'<path d="M{left},{y + 11} C{left + 60},{y + 11} {back + 60},{other + 11} {back},{other + 11}"/>'
    middle = (left + right) // 2
    return f'<path d="M{left},{y + 11} C{middle},{y + 11} {middle},{other + 11} {right},{other + 11}"/>'


def _box(node: Node, x: int, y: int) -> str:
    name = html.escape(node.name)
    return (
        f'<a href="{html.escape(node.address)}"><rect class="{node.kind}" x="{x + 1}" y="{y + 2}" '
        f'width="{_WIDTH - 2}" height="{_ROW - 4}" rx="3"/><text x="{x + 8}" y="{y + 15}">{name}</text></a>'
    )
