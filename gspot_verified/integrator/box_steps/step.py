"""One validated step: where the solutions from a box are, and their derivatives with respect to the initial value.

Proof page: ``proofs/validated_step.md``, Theorems V1 to V3.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import acb, arb, arb_mat, arb_poly, arb_series

from gspot_verified.integrator.field.field import VectorField
from gspot_verified.numbers.balls import add_remainder, nonfinite, series_length
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Evidence

_UNIT_INTERVAL = arb((1, -1), (1, -1))  # exactly [0, 1]


@dataclass(frozen=True, slots=True)
class PolynomialCurve:
    """The approximation that a step is proved about: polynomials in τ = (t - t_0)/h on [0, 1], with exact coefficients.

    ``solution`` begins with the midpoint, ``flow`` (by row and column) with the identity.
    """

    solution: tuple[arb_poly, ...]
    flow: tuple[tuple[arb_poly, ...], ...]


@dataclass(frozen=True, slots=True)
class Plan:
    """Numbers that a heuristic chooses; any choice is correct.

    ``weights`` (exact, positive) define the norm max |x_i|/w_i. ``tube`` is the radius that the deviations must not
    reach, ``disc`` the radius ρ > 1 of the disc of Cauchy's estimate, ``length`` the number of terms of the series of
    f, ``flow_length`` that of the Jacobian matrix, which is needed less accurately.
    """

    weights: tuple[arb, ...]
    tube: arb
    disc: int
    length: int
    flow_length: int


@dataclass(frozen=True, slots=True)
class Step:
    """What was proved of one step, for every solution that starts within ``radius`` of the midpoint (by component).

    At τ in [0, 1] the state lies within ``tube`` of ``curve.solution``; at τ = 1 the solution from the midpoint lies
    within ``local`` of it, and the derivatives with respect to the initial value lie in ``flow``. ``evidence``: the
    hypothesis of Theorem V1, that the deviation stays below the tube's radius.
    """

    curve: PolynomialCurve
    h: arb
    tube: tuple[arb, ...]
    local: tuple[arb, ...]
    flow: arb_mat
    evidence: Evidence

    def enclosure(self, tau: arb = _UNIT_INTERVAL) -> list[arb]:
        """The states at every time of the ball ``tau`` inside [0, 1]; by the mean value form."""
        middle = tau.mid()
        box = []
        for p, r in zip(self.curve.solution, self.tube, strict=True):
            value = p(middle) if tau.is_exact() else p(middle) + p.derivative()(tau) * (tau - middle)
            box.append(add_remainder(value, r))
        return box

    def end(self) -> list[arb]:
        """The end of the solution from the midpoint."""
        one = arb(1)
        return [add_remainder(p(one), r) for p, r in zip(self.curve.solution, self.local, strict=True)]


def certified_step(
    field: VectorField, curve: PolynomialCurve, radius: Sequence[arb], h: arb, plan: Plan
) -> Step | None:
    """The step of length h > 0, or None when a hypothesis of the theorems could not be verified.

    ``radius`` bounds the distances of the initial values from the midpoint, component by component.
    """
    w = plan.weights
    if not (h > 0 and all(weight > 0 for weight in w) and plan.disc > 1 and plan.tube > 0):
        return None
    if not all(p(arb(0)) == int(i == j) for i, row in enumerate(curve.flow) for j, p in enumerate(row)):
        return None
    bounds = _cauchy_bounds(field, curve, plan)
    if bounds is None:
        return None
    values, entries = bounds
    defect = _norm(_defect(field, curve, h, values, plan), w)
    box = _tube(curve, plan)
    growth = _growth(field, box, h, plan)
    start = _norm([abs(r) for r in radius], w)
    # Theorem V1: the deviation is below growth * (start + defect) as long as it is below the tube's radius.
    reach = growth * (start + defect)
    stays = less(reach, plan.tube)
    if stays is None:
        return None
    reach = reach.upper()
    flow = _flow(field, curve, h, entries, _change(field, box, reach, plan), growth, plan)
    step = Step(
        curve, h,
        tuple((reach * weight).upper() for weight in w),
        tuple((growth * defect * weight).upper() for weight in w),
        flow, stays,
    )  # fmt: skip
    finite = all(value.is_finite() for value in (*step.enclosure(), *step.end(), *flow.entries()))
    return step if finite else None


def _norm(values: Sequence[arb], weights: Sequence[arb]) -> arb:
    """max |x_i|/w_i; not finite when a value is not."""
    total = arb(0)
    for value, weight in zip(values, weights, strict=True):
        ratio = (abs(value) / weight).upper()
        if not ratio.is_finite():
            return ratio
        total = total.max(ratio)
    return total


def _cauchy_bounds(field: VectorField, curve: PolynomialCurve, plan: Plan) -> tuple[list[arb], list[list[arb]]] | None:
    """Lemma 1: bounds on |f| and on the entries of |J| along the polynomial on the complex disc |τ| <= ρ."""
    box = []
    disc = arb(plan.disc)
    for p in curve.solution:
        start, *rest = p.coeffs() or [arb(0)]
        reach = arb_poly([0, *(abs(c) for c in rest)])(disc)
        box.append(acb(add_remainder(start, reach), add_remainder(arb(0), reach)))
    values, rows = field.on_complex_box(box)
    bounds = [value.abs_upper() for value in values]
    entries = [[entry.abs_upper() for entry in row] for row in rows]
    if not all(bound.is_finite() for bound in (*bounds, *(entry for row in entries for entry in row))):
        return None
    return bounds, entries


def _tail(plan: Plan, length: int) -> arb:
    """The sum of ρ^-k for k >= length."""
    disc = arb(plan.disc)
    return disc ** (1 - length) / (disc - 1)


def _defect(field: VectorField, curve: PolynomialCurve, h: arb, bounds: Sequence[arb], plan: Plan) -> list[arb]:
    """Lemma 2: bounds on |h f(x) - dx/dτ| for the polynomial x, on [0, 1]."""
    length = plan.length
    with series_length(length):
        series = field.series([arb_series(p.coeffs(), length) for p in curve.solution])
    defects = []
    for p, f, bound in zip(curve.solution, series, bounds, strict=True):
        rest = arb_poly(f.coeffs()) * h - p.derivative()
        total = h * bound * _tail(plan, length)
        defects.append(_size(rest) + total)
    return defects


def _size(polynomial: arb_poly) -> arb:
    """The sum of the absolute values of the coefficients."""
    return arb_poly([abs(c) for c in polynomial.coeffs()])(arb(1))


def _tube(curve: PolynomialCurve, plan: Plan) -> list[arb]:
    """A box of the states within the tube's radius of the polynomial, at all times of the step."""
    return [
        add_remainder(p(_UNIT_INTERVAL), plan.tube * weight)
        for p, weight in zip(curve.solution, plan.weights, strict=True)
    ]


def _growth(field: VectorField, box: Sequence[arb], h: arb, plan: Plan) -> arb:
    """exp(max(h μ, 0)) with the logarithmic norm μ of the Jacobian matrices on the tube."""
    values, rows = field.on_box(box)
    worst = arb(0)
    if not all(value.is_finite() for value in values):
        return nonfinite()
    for i, row in enumerate(rows):
        total = row[i]
        for j, entry in enumerate(row):
            if j != i:
                total = total + abs(entry) * plan.weights[j] / plan.weights[i]
        if not total.is_finite():
            return total
        worst = worst.max((h * total).upper())
    return worst.exp()


def _change(field: VectorField, box: Sequence[arb], reach: arb, plan: Plan) -> list[list[arb]]:
    """Bounds on |J(x) - J(polynomial)| where x is within ``reach`` of the polynomial, inside the tube."""
    table = field.second_derivatives(box)
    return [
        [sum((abs(e) * reach * w for e, w in zip(entry, plan.weights, strict=True)), arb(0)) for entry in row]
        for row in table
    ]


def _flow(
    field: VectorField,
    curve: PolynomialCurve,
    h: arb,
    bounds: list[list[arb]],
    change: list[list[arb]],
    growth: arb,
    plan: Plan,
) -> arb_mat:
    """Theorem V2: enclosures of the derivatives at τ = 1 with respect to the initial value."""
    size = field.dimension
    length = plan.flow_length
    with series_length(length):
        _, jacobian = field.series_with_jacobian([arb_series(p.coeffs(), length) for p in curve.solution])
    polynomials = [[arb_poly(entry.coeffs()) for entry in row] for row in jacobian]
    tail = _tail(plan, length)
    # What the series of J leave out, and how far J may be from it on the tube.
    loose = [[tail * bounds[i][k] + change[i][k] for k in range(size)] for i in range(size)]
    flow = arb_mat(size, size)
    for j in range(size):
        sizes = [_size(curve.flow[k][j]) for k in range(size)]
        defects = []
        for i in range(size):
            product, total = arb_poly([]), arb(0)
            for k in range(size):
                product = product + polynomials[i][k] * curve.flow[k][j]
                total = total + loose[i][k] * sizes[k]
            defects.append(_size(product * h - curve.flow[i][j].derivative()) + h * total)
        worst = growth * _norm(defects, plan.weights)
        for i in range(size):
            flow[i, j] = add_remainder(curve.flow[i][j](arb(1)), worst * plan.weights[i])
    return flow
