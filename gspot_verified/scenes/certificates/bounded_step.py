"""One step of a run as a certificate holds it: rounded polynomials, and bounds of the errors in each piece.

Theorems N1' and N2 of ``proofs/run_certificate.md``. The bounds are made a little larger than they need be: the checker
rounds in its own way.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from flint import arb, arb_mat, arb_poly

from gspot_verified.integrator.field.field import VectorField
from gspot_verified.integrator.norm_steps.chosen_step import ChosenStep
from gspot_verified.integrator.norm_steps.norm_step import (
    Basis,
    NormStep,
    block_norms,
    column,
    defect_bounds,
    growth_rates,
    lengths,
    row_norms,
)
from gspot_verified.numbers.balls import approximate, hull

_LEAST_BITS = 30  # above the checker's last bit: bounds are not smaller
_NODE_BITS = 32  # of a bound as it is written
_TUBE_BITS = 24  # relative, by which the tube is wider than the checker makes it


class NotBounded(ValueError):
    """No bounds of the errors of a step were found at this precision."""


@dataclass(frozen=True)
class BoundedStep:
    """``step``: the curve, and how far from it solutions are; ``text``: the line of the certificate."""

    step: NormStep
    text: dict[str, Any]


def grid(value: arb, bits: int) -> int:
    """The integer n with n 2^-bits next to an exact number, not above it."""
    mantissa, exponent = value.man_exp()
    shift = int(exponent) + bits
    return int(mantissa) << shift if shift >= 0 else int(mantissa) >> -shift


def pair(value: arb) -> list[int]:
    """[m, e] of an exact number m 2^e."""
    mantissa, exponent = value.man_exp()
    return [int(mantissa), int(exponent)]


def bounded_step(
    field: VectorField,
    names: Sequence[str],
    chosen: ChosenStep,
    h: arb,
    before: NormStep | None,
    start: Sequence[arb],
    bits: tuple[int, int],
) -> BoundedStep:
    """The step from ``start``: all states where a phase begins, or the exact middle at the end of ``before``.

    ``bits``: those of the coefficients, and of the checker's numbers. To be called with some more in force.

    :raises NotBounded: see there.
    """
    unit, last = bits
    coefficients = [[grid(c.mid() + arb((1, -unit - 1)), unit) for c in p.coeffs()] or [0] for p in chosen.solution]
    solution = [arb_poly([arb((c, -unit)) for c in row]) for row in coefficients]
    defect = defect_bounds(field, solution, h, chosen.plan.disc, chosen.plan.length)
    if defect is None:
        raise NotBounded("the defect of a step is not finite")
    jump = arb_mat([[x - p(arb(0))] for x, p in zip(start, solution, strict=True)])
    basis, radii = (None, []) if before is None else (before.basis, list(before.radii))
    tube, pieces = [arb(0)] * len(names), []
    order = sorted(range(len(names)), key=names.__getitem__)
    for i, ((left, right), following) in enumerate(zip(pairwise(chosen.plan.ends), chosen.plan.bases, strict=True)):
        inverse = following.S.inv()
        entered = lengths((inverse * jump).entries(), following)
        if basis is not None:
            moved = (block_norms(inverse * basis.S, following, basis) * column(radii)).entries()
            entered = [a + b for a, b in zip(entered, moved, strict=True)]
        pushes = [(right - left) * d for d in lengths(_forcing(inverse, defect), following)]
        margin = chosen.plan.margins[i] * _largest([r + d for r, d in zip(entered, pushes, strict=True)], last)
        rates = _rates(
            field, NormStep(tuple(solution), h, _reach(following, margin), following, ()), inverse, left, right
        )
        nodes = _nodes(rates, margin, entered, pushes, last)
        written = [[_rounded_up(value, last) for value in node] for node in nodes]
        bounds = [[arb((m, e)) for m, e in node] for node in written]
        limits = [_largest(column, last) for column in zip(*bounds, strict=True)]
        for j, at in enumerate((row_norms(following) * column(limits)).entries()):
            tube[j] = tube[j].max(at.upper() * (1 + arb((1, -_TUBE_BITS))))
        rows = following.S.table()
        entries = [pair(value.mid()) for k in order for value in rows[k]]
        pieces.append({"basis": entries, "blocks": list(following.blocks), "end": pair(right), "nodes": written})
        basis, radii, jump = following, bounds[-1], arb_mat(len(names), 1)
    assert basis is not None
    text = {"h": pair(h), "pieces": pieces, "unit": unit, "x": dict(zip(names, coefficients, strict=True))}
    return BoundedStep(NormStep(tuple(solution), h, tuple(tube), basis, tuple(radii)), text)


def _reach(basis: Basis, margin: arb) -> tuple[arb, ...]:
    """By component, where no block is longer than ``margin``."""
    return tuple((row_norms(basis) * column([margin] * len(basis.blocks))).entries())


def _rates(field: VectorField, step: NormStep, inverse: arb_mat, left: arb, right: arb) -> list[list[float]]:
    """The matrix of Theorem N1' on a piece, where the states lie in the tube of a step."""
    found = growth_rates(field, step.enclosure(hull((left, right))), step.basis, inverse)
    if found is None:
        raise NotBounded("the Jacobian matrix of a step is not finite")
    return [[approximate(entry) for entry in row] for row in (found * (step.h * (right - left))).table()]


def _nodes(
    rates: list[list[float]], margin: arb, entered: Sequence[arb], pushes: Sequence[arb], last: int
) -> list[list[arb]]:
    """Bounds below ``margin``, which is what the rates are taken for."""
    least = arb((1, _LEAST_BITS - last))
    scale = _largest([*entered, *pushes], last) + least
    start, push = ([approximate(value / scale) for value in values] for values in (entered, pushes))
    nodes = majorant_nodes(rates, start, push, approximate(least / scale))
    if nodes is None:
        raise NotBounded("no bounds of the errors of a step were found")
    found = [[arb(value) * scale for value in node] for node in nodes]
    if not all(value < margin for node in found for value in node):
        raise NotBounded("the errors of a step may leave the tube")
    return found


def _rounded_up(value: arb, last: int) -> list[int]:
    """[m, e] with m 2^e a little above a number > 0, e >= -last."""
    mantissa, exponent = map(int, value.upper().man_exp())
    excess = max(mantissa.bit_length() - _NODE_BITS, -last - exponent)
    return [(mantissa >> excess) + 1, exponent + excess] if excess > 0 else [mantissa, exponent]


def _forcing(inverse: arb_mat, defect: Sequence[arb]) -> list[arb]:
    return [_dot([abs(entry) for entry in row], defect) for row in inverse.table()]


def _dot(row: Sequence[arb], column: Sequence[arb]) -> arb:
    return sum((a * b for a, b in zip(row, column, strict=True)), arb(0))


def _largest(values: Sequence[arb], last: int) -> arb:
    """An upper bound of numbers >= 0, not less than the checker's last bit."""
    found = arb((1, -last))
    for value in values:
        found = found.max(value.upper())
    return found


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
    found = [nodes for count in _COUNTS if (nodes := _piecewise_nodes(rates, start, push, least, count)) is not None]
    if not found:
        return None
    best = [min(nodes[-1][i] for nodes in found) for i in range(len(start))]
    return next(
        (nodes for nodes in found if all(w <= _NEAR * b for w, b in zip(nodes[-1], best, strict=True))), found[-1]
    )


def _piecewise_nodes(
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
