"""Nodes of piecewise linear bounds of errors. Heuristic: the checker tests the inequality at all of them.

Theorem N1' of ``proofs/run_certificate.md``.
"""

from __future__ import annotations

from collections.abc import Sequence

Nodes = list[list[float]]

_COUNTS = (1, 2, 4, 8, 16, 32, 64, 128)  # of parts of one piece
_NEAR = 1.2  # of the least bound that is found: fewer nodes are taken for it
_SLACK = 2.0**-20  # relative, of all coefficients: for what the checker rounds, and the written nodes
_SLACK_OF_PART = 2.0**-28  # the same for each part, since the differences of nodes are multiplied by their number
_SWEEPS = 60  # over the components of one node
_SETTLED = 1e-12  # relative change of a sweep that ends them


def majorant_nodes(
    rates: Sequence[Sequence[float]], start: Sequence[float], push: Sequence[float], least: float
) -> Nodes | None:
    """w_0 >= start, ..., w_K with K (w_{k+1} - w_k) >= A w + push at both ends of each part; None: none was found.

    ``rates``: A, >= 0 off the diagonal; ``least``: of all components, > 0. K is small, and large where that pays.
    """
    found = [nodes for count in _COUNTS if (nodes := _nodes(rates, start, push, least, count)) is not None]
    if not found:
        return None
    best = [min(nodes[-1][i] for nodes in found) for i in range(len(start))]
    return next(
        (nodes for nodes in found if all(w <= _NEAR * b for w, b in zip(nodes[-1], best, strict=True))), found[-1]
    )


def _nodes(
    rates: Sequence[Sequence[float]], start: Sequence[float], push: Sequence[float], least: float, count: int
) -> Nodes | None:
    more = 1 + _SLACK
    size = range(len(start))
    wider = [
        [rates[i][j] * more if i != j else rates[i][i] + _SLACK * (1 + abs(rates[i][i])) for j in size] for i in size
    ]
    for i in size:
        wider[i][i] += count * _SLACK_OF_PART
    if any(wider[i][i] >= count for i in size):
        return None
    pushes = [value * more for value in push]
    nodes = [[max(value * more, least) for value in start]]
    for _ in range(count):
        following = _following(wider, nodes[-1], pushes, least, count)
        if following is None:
            return None
        nodes.append(following)
    return nodes


def _following(
    rates: Sequence[Sequence[float]], w: Sequence[float], push: Sequence[float], least: float, count: int
) -> list[float] | None:
    """The least next node, by Gauss and Seidel from below: a component that falls takes its new value in A w."""
    size = range(len(w))
    new = [least for _ in size]
    for _ in range(_SWEEPS):
        change = 0.0
        for i in size:
            driven = push[i] + sum(rates[i][j] * max(w[j], new[j]) for j in size if j != i)
            own = rates[i][i]
            value = (count * w[i] + driven) / (count - own)
            if own < 0 and value > w[i]:
                value = w[i] + (own * w[i] + driven) / count
            value = max(value, new[i])
            change = max(change, value / new[i] - 1)
            new[i] = value
        if not change < float("inf"):
            return None
        if change < _SETTLED:
            return [value * (1 + 2 * _SETTLED) for value in new]
    return None
