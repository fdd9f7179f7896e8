"""Single steps with errors in blocks: what is proved holds for known flows, and nothing where a hypothesis fails.

Page: proofs/norm_step.md.
"""

from __future__ import annotations

import random
from dataclasses import replace

import numpy as np
import pytest
from flint import arb, arb_mat, arb_poly, fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.functions.expressions import Constant, Expression, Power, Sine, Variable
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.integrator.norm_steps.adapted_basis import adapted_basis
from gspot_verified.integrator.norm_steps.norm_step import (
    Basis,
    NormPlan,
    NormStep,
    StateSet,
    _majorants,
    block_norms,
    norm_step,
)
from gspot_verified.numbers.balls import working_bits

x, y = Variable(0), Variable(1)
OSCILLATOR = VectorField([y, -x])
NONE = fmpq(0)
UNIT = Basis(arb_mat([[1, 0], [0, 1]]), (1, 1))
ROUND = Basis(arb_mat([[1, 0], [0, 1]]), (2,))


def circle(order: int, h: fmpq, slip: fmpq = NONE) -> list[arb_poly]:
    """cos and -sin from (1, 0), with a deliberate error ``slip`` in the last coefficient."""
    rows: list[list[fmpq]] = [[], []]
    cosine, sine = fmpq(1), fmpq(0)
    for k in range(order + 1):
        rows[0].append(cosine)
        rows[1].append(sine)
        cosine, sine = sine * h / (k + 1), -cosine * h / (k + 1)
    rows[0][-1] += slip
    return [arb_poly([arb(c).mid() for c in row]) for row in rows]


def plan(basis: Basis = ROUND, pieces: int = 1, length: int = 60) -> NormPlan:
    ends = tuple(arb(i) / pieces for i in range(pieces + 1))
    return NormPlan(ends, (basis,) * pieces, (arb(64),) * pieces, 2, length)


def point(*values: int, basis: Basis = ROUND, radius: str = "0") -> StateSet:
    return StateSet(tuple(map(arb, values)), basis, (arb(radius).mid(),) * len(basis.blocks))


def blocks_for(rows: list[list[float]]) -> Basis:
    found = adapted_basis(rows)
    return Basis(arb_mat([[arb(value) for value in row] for row in found.rows]), found.blocks)


def certain(step: NormStep | None) -> NormStep:
    assert step is not None
    return step


@pytest.mark.parametrize("basis", [UNIT, ROUND])
@pytest.mark.parametrize("pieces", [1, 3])
@pytest.mark.parametrize("slip", [fmpq(0), fmpq(1, 10**9)])
def test_the_oscillator(basis: Basis, pieces: int, slip: fmpq) -> None:
    with working_bits(128):
        h = arb((1, -1))
        step = certain(norm_step(OSCILLATOR, circle(12, fmpq(1, 2), slip), point(1, 0), h, plan(basis, pieces)))
        for k in range(9):
            tau = arb(k) / 8
            at = step.enclosure(tau)
            assert at[0].is_finite()
            assert at[0].contains((h * tau).cos())
            assert at[1].contains(-(h * tau).sin())
            assert at[0].rad() < 1e-7
        if slip != 0:
            assert step.tube[0] >= arb(slip).mid() / 2


def test_a_turning_error_does_not_grow_in_one_block() -> None:
    """M = 0 for a turning pair in one block; with two blocks |sin| + |cos| is paid."""
    with working_bits(128):
        h = arb((1, -1))
        one = certain(norm_step(OSCILLATOR, circle(30, fmpq(1, 2)), point(1, 0, radius="0.125"), h, plan(ROUND)))
        two = certain(norm_step(OSCILLATOR, circle(30, fmpq(1, 2)), point(1, 0, radius="0.125"), h, plan(UNIT)))
        assert one.radii[0] < arb("0.12501")
        assert two.radii[0] > arb("0.125") * arb("0.5").exp() * arb("0.99")


def test_the_defect_counts() -> None:
    """A polynomial that is wrong by a known amount, and one whose last coefficients are dropped."""
    with working_bits(128):
        h = arb((1, -1))
        for exponent in (3, 6, 12):
            wrong = circle(30, fmpq(1, 2), fmpq(1, 10**exponent))
            step = certain(norm_step(OSCILLATOR, wrong, point(1, 0), h, plan()))
            assert step.radii[0] >= arb(10) ** -exponent * arb("0.99")
        exact = circle(30, fmpq(1, 2))
        for k in (4, 10):
            cut = [arb_poly(p.coeffs()[:k]) for p in exact]
            step = certain(norm_step(OSCILLATOR, cut, point(1, 0), h, plan()))
            assert step.enclosure(arb(1))[0].contains(h.cos())


def test_the_polynomial_need_not_start_at_the_point() -> None:
    with working_bits(128):
        start = StateSet((arb(fmpq(1025, 1024)), arb(0)), ROUND, (arb(0),))
        step = certain(norm_step(OSCILLATOR, circle(30, fmpq(1, 2)), start, arb((1, -1)), plan()))
        assert step.enclosure(arb(1))[0].contains(arb(fmpq(1025, 1024)) * arb("0.5").cos())
        assert step.radii[0] >= arb(fmpq(1, 1024))


def test_a_tail_is_no_polynomial() -> None:
    """x' = 1/x: the series is cut, so Cauchy's estimate is added; a short one costs more."""
    field = VectorField([Power(x, fmpq(-1))])
    one = Basis(arb_mat([[1]]), (1,))
    with working_bits(128):
        curve = [arb_poly([arb(1), arb((1, -4)), arb((-1, -9))])]
        start = StateSet((arb(1),), one, (arb(0),))
        radii = []
        for length in (4, 40):
            step = certain(norm_step(field, curve, start, arb((1, -4)), plan(one, length=length)))
            assert step.enclosure(arb(1))[0].contains((1 + arb((1, -3))).sqrt())
            radii.append(step.radii[0])
        assert radii[0] > 10 * radii[1]


@pytest.mark.parametrize(
    "changed",
    [
        plan(Basis(arb_mat([[1, 1], [1, 1]]), (2,))),
        plan(Basis(arb_mat([[1, arb("nan")], [1, 1]]), (2,))),
        replace(plan(), margins=(arb(1),)),
        replace(plan(), margins=(arb("nan"),)),
        replace(plan(), margins=()),
        replace(plan(), disc=1),
        replace(plan(), ends=(arb(0), arb((1, -1)))),
        replace(plan(), ends=(arb((1, -1)), arb(1))),
        replace(plan(), ends=(arb(0), arb(1), arb((1, -1)), arb(1)), bases=(ROUND,) * 3, margins=(arb(64),) * 3),
        replace(plan(), bases=(Basis(ROUND.S, (1,)),)),
        replace(plan(), bases=()),
    ],
)
def test_hypotheses_that_fail(changed: NormPlan) -> None:
    with working_bits(100):
        start = point(1, 0, radius="0.125")
        assert norm_step(OSCILLATOR, circle(12, fmpq(1, 2)), start, arb((1, -1)), plan()) is not None
        assert norm_step(OSCILLATOR, circle(12, fmpq(1, 2)), start, arb((1, -1)), changed) is None


def test_a_set_whose_blocks_leave_a_column_out() -> None:
    with working_bits(100):
        start = replace(point(1, 0, radius="0.125"), basis=Basis(ROUND.S, (1,)))
        assert norm_step(OSCILLATOR, circle(12, fmpq(1, 2)), start, arb((1, -1)), plan()) is None


@pytest.mark.parametrize("h", ["0", "-0.5", "nan"])
def test_a_length_that_is_not_certainly_positive(h: str) -> None:
    with working_bits(100):
        assert norm_step(OSCILLATOR, circle(12, fmpq(1, 2)), point(1, 0), arb(h), plan()) is None
        assert norm_step(OSCILLATOR, circle(12, fmpq(1, 2)), point(1, 0), arb(0, 1), plan()) is None


@pytest.mark.parametrize("value", ["nan", "inf"])
def test_nothing_that_is_not_finite_passes(value: str) -> None:
    with working_bits(100):
        good = circle(12, fmpq(1, 2))
        spoiled = [good[0] + arb_poly([0, arb(value)]), good[1]]
        assert norm_step(OSCILLATOR, spoiled, point(1, 0), arb((1, -1)), plan()) is None
        assert norm_step(OSCILLATOR, good, replace(point(1, 0), radii=(arb(value),)), arb((1, -1)), plan()) is None


def test_a_set_that_reaches_a_pole() -> None:
    field = VectorField([Power(x, fmpq(-1))])
    one = Basis(arb_mat([[1]]), (1,))
    with working_bits(100):
        for radius, good in (("0.001", True), ("0.5", False), ("2", False)):
            start = StateSet((arb(1),), one, (arb(radius).mid(),))
            found = norm_step(field, [arb_poly([arb(1), arb((1, -6))])], start, arb((1, -6)), plan(one, length=30))
            assert (found is not None) is good


@given(st.integers(0, 2**32 - 1))
def test_points_stay_in_the_set(seed: int) -> None:
    """A random linear flow of dimension 3 with its adapted basis: images of the corners by the matrix exponential."""
    chance = random.Random(seed)
    size = 3
    with working_bits(90):
        rows = [[fmpq(chance.randint(-32, 32), 16) for _ in range(size)] for _ in range(size)]
        functions: list[Expression] = []
        for row in rows:
            total: Expression = Constant(fmpq(0))
            for j, entry in enumerate(row):
                total = total + Constant(entry) * Variable(j)
            functions.append(total)
        matrix = [[arb(entry) for entry in row] for row in rows]
        try:
            basis = blocks_for([[int(entry.p) / int(entry.q) for entry in row] for row in rows])
        except np.linalg.LinAlgError:
            return
        radii = tuple(arb(chance.uniform(0, 0.1)) for _ in basis.blocks)
        start = StateSet((arb(1), arb(-1), arb(2)), basis, radii)
        h = arb((1, -2))
        terms = [arb_mat([[value] for value in start.middle])]
        for k in range(1, 25):
            terms.append(arb_mat(matrix) * terms[-1] * (h / k))
        curve = [arb_poly([term[i, 0].mid() for term in terms]) for i in range(size)]
        step = norm_step(VectorField(functions), curve, start, h, plan(basis))
        assert step is not None
        end = step.end([p(arb(1)).mid() for p in curve])
        flow = (arb_mat(matrix) * h).exp()
        inverse = end.basis.S.inv()
        for _ in range(6):
            zeta = []
            for block, radius in zip(basis.blocks, radii, strict=True):
                direction = [chance.gauss(0, 1) for _ in range(block)]
                length = sum(part * part for part in direction) ** 0.5
                zeta += [radius * part / length * arb("0.999") for part in map(arb, direction)]
            state = arb_mat([[m] for m in start.middle]) + basis.S * arb_mat([[z] for z in zeta])
            image = flow * state
            for value, side in zip(image.entries(), step.enclosure(arb(1)), strict=True):
                assert side.is_finite()
                assert side.overlaps(value)
            error = (inverse * (image - arb_mat([[m] for m in end.middle]))).entries()
            starts = end.basis.starts()
            for j, radius in enumerate(end.radii):
                size_of = sum((part * part for part in error[starts[j] : starts[j + 1]]), arb(0))
                assert size_of.is_finite()
                assert not size_of > radius * radius


def test_a_defective_block_gets_a_norm_of_its_own() -> None:
    """A Jordan block: with its two eigenvectors as a basis nothing could be proved."""
    with working_bits(90):
        assert abs(adapted_basis([[-1.0, 1.0], [0.0, -1.0]]).rate + 1) < 1e-6
        basis = blocks_for([[-1.0, 1.0], [0.0, -1.0]])
        assert basis.blocks == (2,)
        field = VectorField([y - x, -y])
        curve = [arb_poly([arb(0)]), arb_poly([arb(0)])]
        start = StateSet((arb(0), arb(0)), basis, (arb(1),))
        step = certain(norm_step(field, curve, start, arb(4), plan(basis)))
        assert step.radii[0] < arb(-2).exp()


def test_a_sine_is_followed_by_its_series() -> None:
    field = VectorField([y, -Sine(x)])
    with working_bits(100):
        curve = [arb_poly([arb(1)]), arb_poly([arb(0), (-arb(1).sin() / 64).mid()])]
        step = certain(norm_step(field, curve, point(1, 0), arb((1, -6)), plan(length=20)))
        assert step.enclosure(arb(1))[1].contains(-arb(1).sin() / 64)


@pytest.mark.parametrize(("margin", "good"), [(2, False), (256, True)])
def test_every_block_stays_in_the_tube(margin: int, good: bool) -> None:
    """x' = 5 x, y' = 0: the block of x grows 148-fold, that of y, which begins far smaller, stays within any margin."""
    field = VectorField([Constant(fmpq(5)) * x, Constant(fmpq(0))])
    with working_bits(100):
        start = StateSet((arb(0), arb(0)), UNIT, (arb((1, -10)), arb((1, -40))))
        found = norm_step(field, [arb_poly([])] * 2, start, arb(1), replace(plan(UNIT), margins=(arb(margin),)))
        assert (found is not None) is good


def test_a_pole_in_the_disc_of_the_defect() -> None:
    """x' = 1/(2 - x) along x = τ/16: the pole lies in Cauchy's disc |τ| <= 64, and outside of |τ| <= 8."""
    field = VectorField([Power(Constant(fmpq(2)) - x, fmpq(-1))])
    one = Basis(arb_mat([[1]]), (1,))
    with working_bits(100):
        start = StateSet((arb(0),), one, (arb(0),))
        curve = [arb_poly([0, arb((1, -4))])]
        for disc, good in ((8, True), (64, False)):
            found = norm_step(field, curve, start, arb((1, -3)), replace(plan(one), disc=disc))
            assert (found is not None) is good


def test_a_changed_copy_of_a_step_has_its_own_states() -> None:
    h = fmpq(1, 2)
    step = certain(norm_step(OSCILLATOR, circle(12, h), point(1, 0), arb((1, -1)), plan()))
    before = step.enclosure(arb(1))
    moved = replace(step, solution=tuple(p + 1 for p in step.solution)).enclosure(arb(1))
    assert all(new.overlaps(old + 1) for new, old in zip(moved, before, strict=True))
    assert not any(new.overlaps(old) for new, old in zip(moved, before, strict=True))
    assert all(a.mid() == b.mid() for a, b in zip(step.enclosure(arb(1)), before, strict=True))


def test_the_box_of_a_set_is_as_wide_as_its_radii() -> None:
    with working_bits(64):
        for basis, reach in ((UNIT, (fmpq(1, 4), fmpq(1, 8))), (ROUND, (fmpq(1, 4), fmpq(1, 4)))):
            radii = tuple(arb(r) for r in reach[: len(basis.blocks)])
            for side, middle, r in zip(
                StateSet((arb(3), arb(5)), basis, radii).enclosure(), (3, 5), reach, strict=True
            ):
                assert side.contains(middle + arb(r))
                assert side.contains(middle - arb(r))
                assert side.rad() < arb(r) * (1 + arb((1, -20)))


def test_the_majorant_takes_the_upper_ends_of_what_it_is_given() -> None:
    """One block: n' <= a n + d from r; the bound holds for the largest a, r and d."""
    wide, unit = arb(1, "0.5"), arb(1)
    with working_bits(64):
        for rate, radius, push in ((wide, unit, arb(0)), (unit, wide, arb(0)), (unit, unit, wide), (wide, wide, wide)):
            starts = [radius, 2 * radius]
            bounds = _majorants(arb_mat([[rate]]), [[start] for start in starts], [push])
            for start, [bound] in zip(starts, bounds, strict=True):
                a, r, d = (value.upper() for value in (rate, start, push))
                assert bound.is_finite()
                assert bound >= (r * a.exp() + d * (a.exp() - 1) / a).lower()


def test_norms_of_rows_and_of_squares_are_bounds_and_not_far_above() -> None:
    """(3, 4) in one row has the norm 5, and at most (4 · 7)^(1/2) by the row sums, as the checker of a run has it."""
    A = arb_mat([[3, -4, 0], [0, 0, 2], [1, 1, 1]])
    rows, columns = Basis(arb_mat(3, 3, 1), (1, 2)), Basis(arb_mat(3, 3, 1), (2, 1))
    norms = block_norms(A, rows, columns)
    assert 5 <= norms[0, 0] <= arb(28).sqrt() + arb("1e-8")
    assert norms[0, 1] == 0
    assert arb(2).sqrt() <= norms[1, 0] + arb("1e-12")
    assert arb(5).sqrt() <= norms[1, 1] + arb("1e-12")
    assert norms[1, 1] <= arb(5).sqrt() + arb("1e-8")
