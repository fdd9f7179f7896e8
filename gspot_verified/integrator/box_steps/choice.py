"""What the integrator chooses: order, step, weights, radii, turned coordinates. Heuristic: any choice is correct."""

from __future__ import annotations

import math
from collections.abc import Sequence

from flint import arb, arb_poly

from gspot_verified.integrator.box_steps.step import Plan, PolynomialCurve
from gspot_verified.numbers.balls import approximate, current_bits

_SMALLEST_LOG = -1e9  # stands for the logarithm of 0
_NORMAL = 1e-300  # as a double, a number above it and below its inverse has all its bits
_POWER_STEPS = 12  # of the power method for the weights
_LARGEST_GROWTH = 8.0  # e^8: of errors in one step
_LEAST_GROWTH = 1.0  # e^1: room that wide sets have too
_DISC = 4  # radius of Cauchy's disc, in steps
_ROUNDING_BITS = 12  # above the last one, for what rounding adds to a deviation
_FLOW_BITS = 24  # to which the derivatives of the flow are followed
_SLACK = 0.25  # above the largest eigenvalue, so that the matrix is certainly one with a solution
_LEAST_SHARE = 1e-30  # of the largest component: all are > 0


def order_for(bits: int) -> int:
    """Near 0.35 times the precision: the cost of a step grows with its square, its length with itself."""
    return max(12, round(0.35 * bits))


def log2_of(value: arb) -> float:
    """The binary logarithm of the midpoint's absolute value; very small for 0."""
    middle = value.mid()
    near = abs(float(middle))
    if _NORMAL < near < 1 / _NORMAL:
        return math.log2(near)
    if not middle.is_finite():
        return math.inf
    mantissa, exponent = middle.man_exp()
    if mantissa == 0:
        return _SMALLEST_LOG
    length = abs(int(mantissa)).bit_length()
    return float(int(exponent) + length) + math.log2(abs(int(mantissa)) / (1 << length))


def step_length(coefficients: Sequence[Sequence[arb]], goal_bits: float) -> float:
    """The length at which the last terms of the series are near 2^-goal_bits of the state."""
    order = len(coefficients[0]) - 1
    size = max(max(log2_of(c[0]) for c in coefficients), -goal_bits)
    logs = [
        (size - goal_bits - max(log2_of(c[k]) for c in coefficients)) / k
        for k in range(max(1, order - 3), order + 1)
        if any(not c[k].is_zero() for c in coefficients)
    ]
    return math.exp2(min([10.0, *logs]))


def flow_step_length(flow: Sequence[Sequence[Sequence[arb]]]) -> float:
    """The length at which the shorter series of the derivatives are still accurate: decaying parts too small to be seen
    in the solution may decay fast.
    """
    return step_length([[arb(1), *entry[1:]] for row in flow for entry in row], _FLOW_BITS)


def weights_for(rows: Sequence[Sequence[arb]]) -> tuple[list[float], float]:
    """Weights near those of the least logarithmic norm of a matrix (Perron's vector), and that norm."""
    size = len(rows)
    floats = [[approximate(entry) for entry in row] for row in rows]
    shift = max(1.0, *(abs(floats[i][i]) for i in range(size)))
    w = [1.0] * size
    for _ in range(_POWER_STEPS):
        new = []
        for i in range(size):
            total = (floats[i][i] + shift + 0.1) * w[i]
            total += sum(abs(floats[i][j]) * w[j] for j in range(size) if j != i)
            new.append(total)
        top = max(new)
        if not 0 < top < math.inf:
            return [1.0] * size, 1.0
        w = [max(value / top, 2.0**-20) for value in new]
    norm = max(floats[i][i] + sum(abs(floats[i][j]) * w[j] / w[i] for j in range(size) if j != i) for i in range(size))
    return w, norm


def supersolution(
    rows: Sequence[Sequence[float]], starts: Sequence[Sequence[float]], pushes: Sequence[Sequence[float]]
) -> list[list[float]]:
    """For each start and push z > 0 near the least one with z >= start and Mz + push <= σz, for a σ near the largest
    eigenvalue of M or 0.

    M has entries >= 0 off the diagonal: z = start + (σ - M)⁻¹ max(0, (M - σ) start + push).
    """
    import numpy as np

    size = len(rows)
    matrix, r = np.array(rows), np.array(starts).T
    none = [[1.0] * size for _ in starts]
    if not np.isfinite(matrix).all():
        return none
    shifted = (max(float(np.linalg.eigvals(matrix).real.max()), 0.0) + _SLACK) * np.eye(size) - matrix
    try:
        more = np.linalg.solve(shifted, np.maximum(np.array(pushes).T - np.dot(shifted, r), 0.0))
    except np.linalg.LinAlgError:
        return none
    solution = 1.001 * (r + np.maximum(more, 0.0))
    found: list[list[float]] = np.maximum(solution, _LEAST_SHARE * np.maximum(solution.max(axis=0), 1.0)).T.tolist()
    return found


def limited_by_growth(h: float, norm: float, deviations: Sequence[arb]) -> float:
    """Errors may grow by a factor e^8 at most before the flow's matrix is used, and wide ones by less."""
    room = -math.log(2) * max(log2_of(value.abs_upper()) for value in deviations) / 2
    growth = min(max(room, _LEAST_GROWTH), _LARGEST_GROWTH)
    return min(h, growth / norm) if norm > 0 else h


def scaled_curve(
    solution: Sequence[Sequence[arb]], flow: Sequence[Sequence[Sequence[arb]]], middle: Sequence[arb], h: arb
) -> PolynomialCurve:
    """The Taylor coefficients as polynomials in τ, rounded to exact ones."""

    def polynomial(values: Sequence[arb], start: arb) -> arb_poly:
        power, terms = arb(1), [start]
        for value in values[1:]:
            power = power * h
            terms.append((value * power).mid())
        return arb_poly(terms)

    size = len(middle)
    return PolynomialCurve(
        tuple(polynomial(values, start) for values, start in zip(solution, middle, strict=True)),
        tuple(tuple(polynomial(flow[i][j], arb(int(i == j))) for j in range(size)) for i in range(size)),
    )


def plan_for(
    weights: Sequence[float],
    middle: Sequence[arb],
    deviation: Sequence[arb],
    speed: Sequence[arb],
    h: arb,
    norm: float,
    order: int,
) -> Plan:
    """Radii a few times larger than what is expected of the deviations, of the radius of h, and of rounding."""
    w = tuple(arb(value) for value in weights)
    start = arb(0)
    for value, weight in zip(middle, w, strict=True):
        start = start.max(((1 + abs(value)) / weight * arb((1, _ROUNDING_BITS - current_bits()))).upper())
    for value, weight in zip(speed, w, strict=True):
        start = start.max((abs(value) * h.rad() / weight).upper())
    for value, weight in zip(deviation, w, strict=True):
        start = start.max((abs(value) / weight).upper())
    tube = (8 * arb(max(approximate(h) * norm, 0.0) + 1.0).exp() * start).upper()
    length = max(order + 4, -(-current_bits() // 2))
    return Plan(w, tube, _DISC, length, -(-length // 2) + 2)


def turned_basis(columns_matrix: Sequence[Sequence[arb]], radii: Sequence[arb]) -> list[list[arb]]:
    """Orthonormal directions: those of the longest errors first (Gram-Schmidt in floats, Lohner's order)."""
    size = len(columns_matrix)
    columns = [[columns_matrix[i][j] for i in range(size)] for j in range(size)]
    lengths = [max(log2_of(entry) for entry in column) for column in columns]
    weight = [lengths[j] + max(log2_of(radii[j]), -1e8) for j in range(size)]
    basis: list[list[float]] = []
    unit = [[float(i == j) for i in range(size)] for j in range(size)]
    scaled = [
        [approximate(entry * arb((1, -round(lengths[j])))) for entry in columns[j]]
        for j in range(size)
        if _SMALLEST_LOG < lengths[j] < math.inf
    ]
    order = sorted(
        (j for j in range(size) if _SMALLEST_LOG < lengths[j] < math.inf), key=lambda j: weight[j], reverse=True
    )
    positions = [j for j in range(size) if _SMALLEST_LOG < lengths[j] < math.inf]
    for column in [scaled[positions.index(j)] for j in order] + unit:
        rest = list(column)
        for _ in range(2):
            for known in basis:
                along = sum(a * b for a, b in zip(rest, known, strict=True))
                rest = [a - along * b for a, b in zip(rest, known, strict=True)]
        length = math.hypot(*rest)
        if length > 1e-10 * math.hypot(*column) and len(basis) < size:
            basis.append([a / length for a in rest])
    return [[arb(basis[j][i]) for j in range(size)] for i in range(size)]
