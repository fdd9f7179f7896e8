"""A validated step whose error is bounded by logarithmic norms in bases that follow the flow.

Proof page: ``proofs/norm_step.md``, Theorems N1 and N2. Any polynomials, pieces and bases are correct.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from dataclasses import field as attribute
from itertools import pairwise

from flint import acb, arb, arb_mat, arb_poly, arb_series

from gspot_verified.integrator.box_steps.choice import supersolution
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.numbers.balls import add_remainder, approximate, current_bits, nonfinite, series_length

UNIT_INTERVAL = arb((1, -1), (1, -1))  # exactly [0, 1]
_DISC = arb(0, 1)  # exactly [-1, 1]: there a polynomial's ball is about as wide as the sum of its coefficients' sizes


@dataclass(frozen=True, slots=True)
class Basis:
    """An exact regular matrix S whose columns fall into blocks of the given sizes.

    An error e = S ζ has one norm |ζ_j|₂ for each block.
    """

    S: arb_mat
    blocks: tuple[int, ...]

    def starts(self) -> list[int]:
        """The first column of each block, and the number of columns."""
        starts = [0]
        for size in self.blocks:
            starts.append(starts[-1] + size)
        return starts


@dataclass(frozen=True, slots=True)
class StateSet:
    """The states middle + S ζ with |ζ_j|₂ <= radii[j] for each block; all numbers are exact."""

    middle: tuple[arb, ...]
    basis: Basis
    radii: tuple[arb, ...]

    def enclosure(self) -> list[arb]:
        """A box of the states."""
        reach = row_norms(self.basis) * column(self.radii)
        return [add_remainder(m, r) for m, r in zip(self.middle, reach.entries(), strict=True)]


@dataclass(frozen=True, slots=True)
class NormPlan:
    """What a heuristic chooses: ends 0 = τ_0 < ... < τ_n = 1 of the pieces, and for each piece a basis and a margin.

    ``margins``: how many times larger the tube is than the errors without growth. ``disc`` ρ > 1 and ``length``: as in
    Cauchy's estimate of the defect.
    """

    ends: tuple[arb, ...]
    bases: tuple[Basis, ...]
    margins: tuple[arb, ...]
    disc: int
    length: int


@dataclass(frozen=True, slots=True)
class NormStep:
    """What was proved for every solution that starts in the given set: at τ in [0, 1] it lies within ``tube`` (by
    component) of ``solution``; at τ = 1 the error is S ζ with |ζ_j|₂ <= radii[j] in the blocks of ``basis``.
    """

    solution: tuple[arb_poly, ...]
    h: arb
    tube: tuple[arb, ...]
    basis: Basis
    radii: tuple[arb, ...]
    # Of this step alone: a changed copy begins without.
    _known: dict[tuple[object, object], list[arb]] = attribute(
        default_factory=dict, init=False, repr=False, compare=False
    )

    def enclosure(self, tau: arb = UNIT_INTERVAL) -> list[arb]:
        """The states at every time of the ball ``tau`` inside [0, 1]; by the mean value form."""
        if not tau.is_finite():
            return self._enclosure(tau)
        key = tau.mid().man_exp(), tau.rad().man_exp()  # the end of a step and all of it are asked for by many
        if key not in self._known:
            self._known[key] = self._enclosure(tau)
        return [*self._known[key]]

    def _enclosure(self, tau: arb) -> list[arb]:
        middle = tau.mid()
        box = []
        for p, r in zip(self.solution, self.tube, strict=True):
            value = p(middle) if tau.is_exact() else p(middle) + p.derivative()(tau) * (tau - middle)
            box.append(add_remainder(value, r))
        return box

    def end(self, middle: Sequence[arb]) -> StateSet:
        """The set at τ = 1 about other exact states."""
        one = arb(1)
        jump = column([p(one) - m for p, m in zip(self.solution, middle, strict=True)])
        moved = lengths((self.basis.S.inv() * jump).entries(), self.basis)
        radii = tuple((a + b).upper() for a, b in zip(self.radii, moved, strict=True))
        return StateSet(tuple(middle), self.basis, radii)


def norm_step(
    field: VectorField,
    solution: Sequence[arb_poly],
    start: StateSet,
    h: arb,
    plan: NormPlan,
    defect: Sequence[arb] | None = None,
) -> NormStep | None:
    """The step of length h > 0 along polynomials in τ, or None when a hypothesis could not be verified.

    ``defect``: what :func:`defect_bounds` gave for this field, these polynomials and this length, whatever the series.
    """
    if not (h > 0 and _fits(plan, field.dimension) and _divides(start.basis, field.dimension)):
        return None
    if defect is None:
        defect = defect_bounds(field, solution, h, plan.disc, plan.length)
    if defect is None:
        return None
    before, radii = start.basis, column(start.radii)
    jump = column([m - p(arb(0)) for m, p in zip(start.middle, solution, strict=True)])
    defects = column([add_remainder(arb(0), d) for d in defect])
    tube = [arb(0)] * field.dimension
    for i, basis in enumerate(plan.bases):
        try:
            inverse = basis.S.inv()
        except ZeroDivisionError:
            return None
        # Theorem N2: the same set in the norms of the next basis.
        radii = block_norms(inverse * before.S, basis, before) * radii
        if i == 0:
            radii = radii + column(lengths((inverse * jump).entries(), basis))
        before = basis
        piece = plan.ends[i].union(plan.ends[i + 1])
        length = plan.ends[i + 1] - plan.ends[i]
        # Theorem N1. All errors within the defects are one ball: their lengths are those of the theorem.
        pushes = lengths((inverse * defects).entries(), basis)
        rows = row_norms(basis)
        limit = (
            plan.margins[i] * _largest([r + length * d for r, d in zip(radii.entries(), pushes, strict=True)])
        ).upper()
        reach_of_limit = (rows * column([limit] * len(pushes))).entries()
        box = [add_remainder(p(piece), r) for p, r in zip(solution, reach_of_limit, strict=True)]
        rates = growth_rates(field, box, basis, inverse)
        if rates is None:
            return None
        rates = rates * (h * length)
        pushes = [length * d for d in pushes]
        reach, pushed = _majorants(rates, [radii.entries(), [arb(0)] * len(pushes)], pushes)
        if not all(value.is_finite() and value < limit for value in reach):
            return None
        radii = column([(a + b).upper() for a, b in zip((rates.exp() * radii).entries(), pushed, strict=True)])
        tube = [old.max(at.upper()) for old, at in zip(tube, (rows * column(reach)).entries(), strict=True)]
    step = NormStep(tuple(solution), h, tuple(tube), before, tuple(radii.entries()))
    finite = all(value.is_finite() for value in (*step.enclosure(), *step.radii))
    return step if finite else None


def _fits(plan: NormPlan, size: int) -> bool:
    """Whether the pieces fill [0, 1], each with a basis and a margin, and Cauchy's disc is larger than the unit one."""
    ends = plan.ends
    fill = len(ends) > 1 and ends[0] == 0 and ends[-1] == 1 and all(a < b for a, b in pairwise(ends))
    each = len(ends) - 1 == len(plan.bases) == len(plan.margins)
    return fill and each and plan.disc > 1 and all(_divides(basis, size) for basis in plan.bases)


def _divides(basis: Basis, size: int) -> bool:
    """Whether the blocks are all of so many columns."""
    return basis.S.nrows() == size == sum(basis.blocks) and all(block > 0 for block in basis.blocks)


def lengths(values: Sequence[arb], basis: Basis) -> list[arb]:
    """Bounds on the Euclidean lengths of the blocks of a vector."""
    starts = basis.starts()
    return [_length(values[a:b]) for a, b in pairwise(starts)]


def _length(values: Sequence[arb]) -> arb:
    if len(values) == 1:
        return values[0].abs_upper()
    return sum((value * value for value in map(abs, values)), arb(0)).upper().sqrt().upper()


def _largest(values: Sequence[arb]) -> arb:
    worst = arb((1, -8 * current_bits()))
    for value in values:
        worst = worst.max(value.upper())
    return worst


def column(values: Sequence[arb]) -> arb_mat:
    """A matrix of one column."""
    return arb_mat(len(values), 1, values)


def row_norms(basis: Basis) -> arb_mat:
    """For each component of e = S ζ the lengths of its row of S in the blocks."""
    return arb_mat([lengths(row, basis) for row in basis.S.table()])


def block_norms(A: arb_mat, left: Basis, right: Basis) -> arb_mat:
    """Bounds on the Euclidean norms of the blocks of a matrix."""
    return arb_mat([[_norm(block) for block in row] for row in _blocks(A, left, right)])


def _blocks(A: arb_mat, left: Basis, right: Basis) -> list[list[list[list[arb]]]]:
    table, columns = A.table(), [*pairwise(right.starts())]
    return [[[row[c:d] for row in table[a:b]] for c, d in columns] for a, b in pairwise(left.starts())]


def _norm(block: Sequence[Sequence[arb]]) -> arb:
    """A bound on the Euclidean norm: the largest row sum of |AᵀA| bounds its largest eigenvalue."""
    if len(block[0]) == 1:
        return _length([row[0] for row in block])
    if len(block) == 1:
        sizes = [value.abs_upper() for value in block[0]]
        return (_largest(sizes) * sum(sizes, arb(0))).upper().sqrt().upper()
    A = arb_mat(block)
    worst = arb(0)
    for row in (A.transpose() * A).table():
        total = sum(map(abs, row), arb(0)).upper()
        if not total.is_finite():
            return nonfinite()
        worst = worst.max(total)
    return worst.sqrt().upper()


def growth_rates(field: VectorField, box: Sequence[arb], basis: Basis, inverse: arb_mat) -> arb_mat | None:
    """The matrix of Theorem N1: logarithmic norms of the diagonal blocks of S⁻¹JS, and norms of the others."""
    values, rows = field.on_box(box)
    if not all(value.is_finite() for value in values):
        return None
    turned = inverse * arb_mat(rows) * basis.S
    rows_of_norms = [
        [_logarithmic_norm(block) if i == j else _norm(block) for j, block in enumerate(row)]
        for i, row in enumerate(_blocks(turned, basis, basis))
    ]
    return arb_mat(rows_of_norms) if all(value.is_finite() for row in rows_of_norms for value in row) else None


def _logarithmic_norm(block: Sequence[Sequence[arb]]) -> arb:
    """A bound on the largest eigenvalue of the symmetric part: Gershgorin's discs."""
    worst: arb | None = None
    for i, row in enumerate(block):
        total = row[i]
        for j in range(len(block)):
            if j != i:
                total = total + abs(row[j] + block[j][i]) / 2
        if not total.is_finite():
            return nonfinite()
        worst = total.upper() if worst is None else worst.max(total.upper())
    return nonfinite() if worst is None else worst


def _majorants(rates: arb_mat, starts: Sequence[Sequence[arb]], pushes: Sequence[arb]) -> list[list[arb]]:
    """For each start e^σ z as in :func:`_majorant`."""
    table = [[approximate(entry) for entry in row] for row in rates.table()]
    units = [_largest([*radii, *pushes]) for radii in starts]
    scaled = [[approximate(r / least) for r in radii] for radii, least in zip(starts, units, strict=True)]
    driven = [[approximate(d / least) for d in pushes] for least in units]
    proposed = supersolution(table, scaled, driven)
    return [
        _majorant(rates, radii, pushes, [least * value for value in map(arb, z)])
        for radii, least, z in zip(starts, units, proposed, strict=True)
    ]


def _majorant(rates: arb_mat, radii: Sequence[arb], pushes: Sequence[arb], proposed: Sequence[arb]) -> list[arb]:
    """e^σ z with z > 0, z >= r, rates z + d <= σ z: what n(τ) cannot exceed on the piece. Not finite without such z.

    ``proposed``: any numbers near such z.
    """
    z = [value.max(r.upper()) for value, r in zip(proposed, radii, strict=True)]
    if not all(value > 0 for value in z):
        return [nonfinite()] * len(z)
    needed = [(a + d) / value for a, d, value in zip((rates * column(z)).entries(), pushes, z, strict=True)]
    growth = arb(0)
    for value in needed:
        if not value.is_finite():
            return [nonfinite()] * len(z)
        growth = growth.max(value.upper())
    return [(growth.exp() * value).upper() for value in z]


def defect_bounds(field: VectorField, solution: Sequence[arb_poly], h: arb, disc: int, length: int) -> list[arb] | None:
    """Bounds on |h f(x) - dx/dτ| on [0, 1], by component; ``disc`` and ``length`` are those of a :class:`NormPlan`."""
    with series_length(length):
        series = field.series([arb_series(p, length) for p in solution])
    tails = _tails(field, solution, arb(disc), length)
    if tails is None:
        return None
    defects = []
    for p, f, tail in zip(solution, series, tails, strict=True):
        rest = arb_poly(f.coeffs()) * h - p.derivative()
        total = (rest(_DISC).abs_upper() + h * tail).upper()
        if not total.is_finite():
            return None
        defects.append(total)
    return defects


def _tails(field: VectorField, solution: Sequence[arb_poly], disc: arb, length: int) -> list[arb] | None:
    """What the series of f leave out: nothing when f is a polynomial of a degree below their length."""
    degrees = field.degrees([max(p.degree(), 0) for p in solution])
    if all(degree is not None and degree < length for degree in degrees):
        return [arb(0)] * field.dimension
    box = []
    for p in solution:
        start, *rest = p.coeffs() or [arb(0)]
        reach = arb_poly([0, *(abs(c) for c in rest)])(disc)
        box.append(acb(add_remainder(start, reach), add_remainder(arb(0), reach)))
    bounds = [value.abs_upper() for value in field.values_on_complex_box(box)]
    if not all(bound.is_finite() for bound in bounds):
        return None
    return [bound * disc ** (1 - length) / (disc - 1) for bound in bounds]
