"""What the truncated expansion leaves in the equations: its size on |s| <= S against delta, under the proved bound.

The bound K delta^M is that of :func:`gspot_verified.expansion.residual.residual_bounds` (proofs/residual.md).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from flint import arb, fmpq

from gspot_verified.expansion.residual import ResidualBounds, residual_bounds
from gspot_verified.expansion.series.spaces import SpacePolynomial
from gspot_verified.expansion.trajectory import Trajectory
from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.numbers.balls import ball, float_bounds, working_bits
from gspot_verified.report.pictures.canvas import COLOURS, STYLES, Picture, canvas, picture, styled

_BITS = 200  # the residual is a difference of nearly equal numbers
_STEPS = 16  # from the largest delta to the smallest
_PARTS = 12  # of 0 <= s <= S, at whose ends the residual is taken
_MOST_CURVES = 4  # one for each order M: more would hide each other
_RANGES = (fmpq(1, 4), fmpq(1, 10), fmpq(1, 25), fmpq(1, 100), fmpq(1, 1000))  # largest delta, tried in turn
_SMALLEST = fmpq(1, 30)  # the smallest delta over the largest
S = fmpq(1)  # the bound holds for |s| <= S: proofs/residual.md


@dataclass(frozen=True, slots=True)
class ResidualCurve:
    """At each delta the largest residual at points of |s| <= S, and the proved bound; ``order`` is M."""

    order: int
    deltas: tuple[float, ...]
    sizes: tuple[float, ...]
    bounds: tuple[float, ...]


def residual_curves(trajectory: Trajectory) -> tuple[ResidualCurve, ...]:
    """Curves for some orders M up to that of the trajectory.

    The size is the largest over all equations at equidistant points of |s| <= S = 1: a lower estimate of the supremum,
    and points do not make the dips that a change of sign at one s makes. The bound holds for every s.

    :raises SymbolsError: the numbers of the system are symbols.
    :raises ValueError: there is no finite bound for delta <= 1/1000.
    """
    trajectory.system.check_numbers("pictures")
    top = trajectory.order
    orders = sorted({max(1, top * part // _MOST_CURVES) for part in range(1, _MOST_CURVES + 1)})
    cut = {order: truncated(trajectory, order) for order in orders}
    for largest in _RANGES:
        bounds = {order: residual_bounds(cut[order], S, largest) for order in orders}
        if all(_constant(bound).is_finite() for bound in bounds.values()):
            return tuple(_curve(cut[order], bounds[order], largest) for order in orders)
    raise ValueError(f"{trajectory.system.name}: no finite bound on the residual for delta <= {_RANGES[-1]}")


def truncated(trajectory: Trajectory, order: int) -> Trajectory:
    """Its terms of orders 0..order-1."""
    names = ("p", "b", "y", "v", "z", "lambda_n")
    terms = {name: getattr(trajectory, name)[:order] for name in names}
    return replace(trajectory, order=order, xi=tuple(rows[:order] for rows in trajectory.xi), **terms)


def _constant(bounds: ResidualBounds) -> arb:
    """The largest constant of an equation; the conditions at s = 0 are no equations."""
    largest = arb(0)
    for key, value in bounds.constants.items():
        if not key.startswith("start_"):
            largest = largest.max(value)
    return largest


def _curve(trajectory: Trajectory, bounds: ResidualBounds, largest: fmpq) -> ResidualCurve:
    deltas, sizes, limits = [], [], []
    with working_bits(_BITS):
        residual = Residual(trajectory)
        constant, ratio = _constant(bounds), arb(_SMALLEST) ** (arb(1) / _STEPS)
        delta = arb(largest)
        for _ in range(_STEPS + 1):
            size = max(residual.size(fmpq(k, _PARTS) * S, delta) for k in range(-_PARTS, _PARTS + 1))
            if size > 0:
                deltas.append(float(delta.mid()))
                sizes.append(size)
                limits.append(float_bounds(constant * delta**trajectory.order)[1])
            delta = (delta * ratio).mid()
    return ResidualCurve(trajectory.order, tuple(deltas), tuple(sizes), tuple(limits))


class Residual:
    """Eqs. specialX to specialL with the truncated polynomials put in, at points (s, delta)."""

    def __init__(self, trajectory: Trajectory) -> None:
        self._trajectory = trajectory
        system = trajectory.system
        self._dimension = len(system.point)
        functions = [*system.F, *system.G, system.alpha_1, system.alpha_2, system.alpha_3]
        self._program = BoxProgram(functions, self._dimension)

    def at(self, s: fmpq, delta: arb) -> list[arb]:
        """The residuals of xi_1, ..., p, b, y, v, z, lambda at one point, in balls."""
        path = self._trajectory
        xi = [_sum(terms, s, delta) for terms in path.xi]
        values = {name: _sum(getattr(path, name), s, delta) for name in ("p", "b", "y", "v", "z", "lambda_n")}
        slopes = {name: _sum(getattr(path, name), s, delta, slope=True) for name in ("p", "b", "y", "v", "z")}
        state = [ball(start) + delta**2 * value for start, value in zip(path.system.point, xi, strict=True)]
        functions = self._program.values(state)
        m, force = self._dimension, values["lambda_n"]
        first, second, third = functions[2 * m :]
        springs = path.system.regularisation
        residuals = [
            _sum(terms, s, delta, slope=True) - functions[i] - functions[m + i] * force
            for i, terms in enumerate(path.xi)
        ]
        return [
            *residuals,
            slopes["p"] - first,
            slopes["b"] - second + third * force,
            slopes["y"] - values["v"],
            slopes["v"] - values["b"] - values["p"] * force,
            delta * arb(springs.c) * slopes["z"] + arb(springs.k_1) * values["z"] + force,
            force - arb(springs.k_2) * (values["z"] - values["y"]),
        ]

    def size(self, s: fmpq, delta: arb) -> float:
        """The largest of them, rounded down: a lower estimate stays below the bound."""
        return max(float_bounds(abs(value))[0] for value in self.at(s, delta))


def _sum(terms: Sequence[SpacePolynomial], s: fmpq, delta: arb, slope: bool = False) -> arb:
    """The sum of terms[n](s) delta^n, or of its derivative in s."""
    total = arb(0)
    for term in reversed(terms):
        coefficients = term.coefficients()
        if slope:
            coefficients = [k * value for k, value in enumerate(coefficients)][1:]
        value: Any = arb(0)
        for coefficient in reversed(coefficients):
            value = value * s + ball(coefficient)
        total = total * delta + value
    return total


def expansion_picture(trajectory: Trajectory) -> Picture:
    """The curves as a figure with its caption.

    :raises SymbolsError: the numbers of the system are symbols.
    :raises ValueError: there is no finite bound.
    """
    curves = residual_curves(trajectory)
    return styled(lambda: _draw(trajectory, curves))()


def save_expansion(trajectory: Trajectory, path: Path) -> Path:
    """Write the picture as PNG, PDF or SVG and return its path."""
    return expansion_picture(trajectory).save(path)


def _draw(trajectory: Trajectory, curves: Sequence[ResidualCurve]) -> Picture:
    figure = canvas(4.6)
    axes = figure.add_subplot()
    for curve, colour, style in zip(curves, COLOURS, STYLES, strict=False):
        if curve.deltas:
            axes.loglog(curve.deltas, curve.sizes, color=colour, linestyle=style, label=f"M = {curve.order}")
            axes.loglog(curve.deltas, curve.bounds, color=colour, linewidth=0.9, alpha=0.8)
    axes.loglog([], [], color=COLOURS[0], linewidth=0.9, label=r"proved bound $K\,\delta^M$")
    axes.set(xlabel=r"$\delta = \varepsilon^{1/3}$", ylabel="what is left in the equations, |s| ≤ 1")
    axes.set_title(trajectory.system.name, loc="left", parse_math=False)
    axes.legend(loc="lower right")
    orders = ", ".join(str(curve.order) for curve in curves)
    return picture(
        figure,
        "expansion",
        f"The expansion of {trajectory.system.name}, M = {orders} orders of δ",
        "Thick: the largest residual over all equations, at 25 points of |s| ≤ 1 for each δ, in balls. Thin: the "
        "proved bound K δ^M, for every |s| ≤ 1. Between the points nothing is claimed by the thick lines. A residual "
        "is not the distance to the trajectory, which is not proved.",
        "Pairs of straight lines on logarithmic scales, steeper for a larger M, the bound above the residual.",
    )
