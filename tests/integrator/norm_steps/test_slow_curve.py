"""Steps along a slow manifold: a known slow solution, what the norm step makes of it, and where there is none.

Page: proofs/norm_step.md.
"""

from __future__ import annotations

import numpy as np
import pytest
from flint import arb, fmpq

from gspot_verified.functions.expressions import Constant, Expression, Variable
from gspot_verified.integrator.box_steps.choice import supersolution
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.integrator.norm_steps.adapted_basis import pieces_along, spectral_basis
from gspot_verified.integrator.norm_steps.norm_run import NormRun
from gspot_verified.integrator.norm_steps.slow_curve import _Band, _Solver, slow_curve
from gspot_verified.numbers.balls import working_bits

x, y, z = Variable(0), Variable(1), Variable(2)
SMALL = fmpq(1, 10**5)


def number(p: int, q: int = 1) -> Constant:
    return Constant(fmpq(p, q))


def slow_and_fast(*, damping: fmpq) -> list[Expression]:
    """x' = -SMALL x; y'' + 2 damping y' + y = x: the slow solution is y = x/(1 - 2 damping SMALL + SMALL^2)."""
    small = Constant(SMALL)
    return [-(small * x), z, x - y - Constant(2 * damping) * z]


FIELD = VectorField(slow_and_fast(damping=fmpq(1, 8)))
FACTOR = 1 / (1 - SMALL / 4 + SMALL**2)


def test_the_slow_solution() -> None:
    """From a start beside it the polynomial begins on the slow solution, and its coefficients are those of exp."""
    h = 2000.0
    with working_bits(192):
        start = [arb(1), (arb(FACTOR) + arb((1, -90))).mid(), (-SMALL * FACTOR * arb(1)).mid()]
        found = slow_curve(FIELD, start, h, 40, 150)
        assert found is not None
        assert found.tail < -140
        assert -95 < found.start < -85
        value = arb(1)
        for k in range(12):
            for p, factor in zip(found.solution, (fmpq(1), FACTOR, -SMALL * FACTOR), strict=True):
                assert abs(p.coeffs()[k] - value * factor) < arb(2) ** -100
            value = -value * SMALL * int(h) / (k + 1)


@pytest.mark.parametrize("functions", [[-x], [y, -x], slow_and_fast(damping=fmpq(-1, 2))])
def test_no_slow_manifold(functions: list[Expression]) -> None:
    """Nothing slow, nothing slow, and fast directions that grow."""
    with working_bits(192):
        start = [arb(1)] * len(functions)
        assert slow_curve(VectorField(functions), start, 1000.0, 30, 150) is None


def test_a_run_along_the_slow_manifold() -> None:
    """10^6 fast units in few steps, and the closed form of all three components at the end."""
    with working_bits(192):
        run = NormRun(FIELD, [arb(1), arb(1), arb(0)], arb(10**6))
        *_, last = run
        lengths = [float(segment.step.h.mid()) for segment in NormRun(FIELD, [arb(1), arb(1), arb(0)], arb(10**6))]
        assert len(lengths) < 150
        assert max(lengths) > 10**4
        slow = (-SMALL * 10**6 * arb(1)).exp()
        for value, factor in zip(last.states(arb(1)), (fmpq(1), FACTOR, -SMALL * FACTOR), strict=True):
            assert value.is_finite()
            assert value.contains(slow * factor)  # the fast part is below exp(-10^5)
            assert value.rad() < 1e-25


def test_an_oscillation_that_does_not_die_is_kept() -> None:
    """Without damping the solution turns for ever: long steps would leave it out."""
    field = VectorField(slow_and_fast(damping=fmpq(0)))
    with working_bits(128):
        lengths = [float(segment.step.h.mid()) for segment in NormRun(field, [arb(1), arb(2), arb(0)], arb(600))]
        assert max(lengths) < 40


def test_pieces_follow_a_turning_basis() -> None:
    """An oscillator whose frequency changes: short pieces where the damping is weak, one piece without change."""
    constant = np.array([[[0.0, 1.0], [-1.0, -0.1]]])
    changing = np.concatenate([constant, [[[0.0, 0.0], [0.5, 0.0]]]])
    assert len(pieces_along(constant, 500.0, 64, 4.0)) == 1
    pieces = pieces_along(changing, 500.0, 64, 4.0)
    assert 2 <= len(pieces) <= 65
    ends = [0.0]
    for a, b, _ in pieces:
        assert a == ends[-1]
        ends.append(b)
    assert ends[-1] == 1.0


def test_a_spectral_basis_needs_a_gap() -> None:
    assert spectral_basis([[-1.0, 0.0], [0.0, -2.0]], 0.5) is None
    found = spectral_basis([[-1.0, 0.0], [0.0, -1e-6]], 0.5)
    assert found is not None
    assert list(found[1]) == [False, True]


def test_a_supersolution() -> None:
    """z >= start and Mz + push <= σz for a small σ; a driven fast block is c r/m, not larger."""
    rows = [[0.0, 0.0], [30.0, -1000.0]]
    found, pushed = supersolution(rows, [[1.0, 0.0], [0.0, 0.0]], [[0.0, 0.0], [0.0, 1.0]])
    assert found[0] >= 1
    assert 0.03 <= found[1] < 0.04
    assert 0.001 <= pushed[1] < 0.002
    for z, push in ((found, 0.0), (pushed, 1.0)):
        for j in range(2):
            assert sum(rows[j][k] * z[k] for k in range(2)) + j * push <= 0.26 * z[j]
    assert all(value > 0 for [value] in supersolution([[float("nan")]], [[1.0]], [[0.0]]))


@pytest.mark.parametrize(("below", "above"), [(0, 0), (3, 1), (1, 4), (11, 11)])
def test_a_band_is_solved_as_a_full_matrix_is(below: int, above: int) -> None:
    """With small entries on the diagonal, so that rows must be exchanged."""
    draw = np.random.default_rng(7)
    full = np.triu(np.tril(draw.normal(size=(12, 12)), above), -below)
    full[np.diag_indices(12)] *= 1e-3
    right = draw.normal(size=12)
    assert np.allclose(_Band(full, below, above).solve(right), np.linalg.solve(full, right), rtol=1e-8)


def test_corrections_solve_the_linear_equation() -> None:
    """d' - h J(tau) d = r up to the degree of d, for a J of degree 2; the slow coordinate starts where it is asked."""
    order, size, h = 9, 3, 0.5
    draw = np.random.default_rng(3)
    jacobian = np.zeros((order + 1, size, size))
    jacobian[:3] = draw.normal(size=(3, size, size))
    basis, slow = draw.normal(size=(size, size)), np.array([False, True, False])
    residuals = [[arb(float(value)) for value in row] for row in draw.normal(size=(size, order + 1))]
    gap = [arb(float(value)) for value in draw.normal(size=size)]
    for level in (0.0, 5.0):
        moves = _Solver(jacobian, basis, slow, h).moves(residuals, gap, level, order) * 2**level
        for k in range(order + 1):
            product = sum(np.dot(jacobian[j], moves[k - j]) for j in range(min(k, 2) + 1))
            slope = (k + 1) * moves[k + 1] if k < order else 0.0
            rest = np.dot(np.linalg.inv(basis), slope - h * product - [float(row[k]) for row in residuals])
            # The start of a slow coordinate stands in place of its last equation.
            assert np.abs(rest[np.logical_not(slow)] if k == order else rest).max() < 1e-9
        start = np.dot(np.linalg.inv(basis), moves[0] - [float(value) for value in gap])
        assert np.abs(start[slow]).max() < 1e-9


def test_a_singular_band_is_refused() -> None:
    with pytest.raises(np.linalg.LinAlgError):
        _Band(np.zeros((3, 3)), 1, 1)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("rate", [0.0, float("inf"), float("nan")])
def test_an_equation_without_coefficients_is_refused(rate: float) -> None:
    """A direction that is called fast and has no rate: the last equation is 0 = r. An error, no warning of numpy."""
    jacobian = np.zeros((3, 2, 2))
    jacobian[0] = np.diag([0.0, rate])
    with pytest.raises(np.linalg.LinAlgError):
        _Solver(jacobian, np.eye(2), np.array([True, False]), 1.0)
