"""The bounds of the checker of lift-off and impact, each beside another computation.

Page: proofs/from_state.md, section 11.
"""

from __future__ import annotations

import math
from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np
import pytest
from checker.test_side import LINES, check, first_range, side
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

passage, ONE = check.passage, check.side.ONE


def numbers() -> Any:
    return side.Numbers(side.BITS, check.limits.Meter(check.limits.Limits(), 10**15))


@cache
def shipped(index: int = 1) -> Any:
    """One range of the shipped certificate."""
    least = Fraction(LINES[index - 1]["delta"]) if index > 1 else Fraction(0)
    return side.read_range(numbers(), side.Statement(first_range()[0]["statement"]), LINES[index], least)


@cache
def pieces_of(index: int) -> tuple[list[Any], Any]:
    """Its pieces, and the set at their begin."""
    of = shipped(index)
    equations, handed = side.Equations(numbers(), of), side.handed_over(numbers(), of)
    length, state, found = (of.end + of.scaled) / of.pieces, handed, []
    for k in range(of.pieces):
        found.append(equations.advance(state, k * length - of.scaled, length))
        state = found[-1].after
    return found, handed


def held(value: float, interval: tuple[int, int]) -> bool:
    low, high = (float(Fraction(end, ONE)) for end in interval)
    room = 1e-7 * (1 + abs(value))
    return low - room <= value <= high + room


def motion(start: Any, epsilon: float, x: float, y: float, z: float, until: float) -> tuple[np.ndarray, np.ndarray]:
    """s and (b, Y, V, Z) of the model system from p_1, in the unit T = t/ε, up to the scaled time ``until``.

    The equations of the paper in contact, linear in (b, Y, V, Z); the start is at the corner x, y, z of the set (8).
    """
    a, kappa, g, lag = (float(v) for v in (start.a, start.kappa, start.rate, start.lag))
    k_1, k_2, damper = map(float, start.contact)
    p, b, L, mean = float(start.p), float(start.b), float(start.excess), float(start.mean)
    eta = float(start.within) * abs(L)
    force = -b / p + eta * x
    V = eta * math.sqrt(p / kappa) * y
    phi = eta * math.sqrt(p * lag) / g * z  # λ - λ̄ + κ(Y - Ȳ) + (l/g)V
    Y = (phi - force - lag / g * V) / kappa

    def field(T: float, u: np.ndarray) -> list[float]:
        now, b, Y, V, Z = p - a * epsilon * T, *u
        force = k_2 * (Z - Y)
        return [
            epsilon * (float(start.alpha[1]) - float(start.alpha[2]) * force),
            V,
            b + now * force,
            (-k_1 * Z - force) / damper,
        ]

    delta = epsilon ** (1 / 3)
    ends = np.array([-float(start.scaled), *np.linspace(-float(start.scaled), until, 9)[1:]])
    times = (p + a * ends * delta**2) / (a * epsilon)  # p = -asδ²
    found = solve_ivp(field, (0, times[-1]), [b, Y, V, Y + force / k_2], "Radau", times, rtol=1e-9, atol=1e-13)
    assert found.success
    assert mean > 0
    return ends, found.y


def deviations(start: Any, epsilon: float, s: float, u: np.ndarray) -> np.ndarray:
    """(e_b, e_y, e_v, e_λ), over δ^0: b, y, v, λ less the distinguished trajectory, in the paper's scales."""
    delta, p, mean = epsilon ** (1 / 3), -float(start.a) * s * epsilon ** (2 / 3), float(start.mean)
    b, Y, V, Z = u
    force = float(start.contact[1]) * (Z - Y)
    return np.array([(b + p * mean) / delta**2, Y + mean / float(start.kappa), V / delta, force - mean])


@pytest.mark.parametrize(("index", "share"), [(9, 1.0), (9, 0.96), (21, 1.0)])
@pytest.mark.parametrize("corner", [(0, 0, 0), (1, 1, 1), (-1, 1, -1)])
def test_the_motion_of_the_paper_lies_in_the_set_and_in_the_pieces(
    index: int, share: float, corner: tuple[int, int, int]
) -> None:
    """From a corner of the starts to s_1, for a δ of the range, by another integrator and the paper's own variables."""
    of, (pieces, handed) = shipped(index), pieces_of(index)
    start, delta = of.start, float(of.most) * share
    assert float(of.least) < delta
    ends, states = motion(start, delta**3, *corner, float(of.end))
    first = deviations(start, delta**3, ends[0], states[:, 0])
    amplitude = -first[0] / (float(start.a) * float(start.scaled))  # L(S)
    low, high = (float(value) for value in of.amplitude(numbers()))
    assert low * share ** (2 * float(start.beta) - 2) <= abs(amplitude) <= high
    e = first / amplitude
    basis = np.array([[float(Fraction(v, ONE)) for v in row] for row in handed.basis])
    u = np.linalg.solve(basis, e[:3]) - [float(Fraction(v, ONE)) for v in handed.centre]
    radii = [float(Fraction(v, ONE)) for v in handed.radii]
    assert all(abs(value) <= radius + 1e-7 for value, radius in zip(u, radii, strict=True))
    for s, state in zip(ends[1:], states.T[1:], strict=True):
        k = (s + float(of.scaled)) / float(of.end + of.scaled) * of.pieces
        piece = pieces[min(math.ceil(k - 1e-9), of.pieces) - 1]
        now = deviations(start, delta**3, s, state) / amplitude
        assert held(now[3], piece.force)
    last = deviations(start, delta**3, ends[-1], states[:, -1]) / amplitude
    assert all(held(value, end) for value, end in zip(last, pieces[-1].end, strict=False))
    f = abs(last[3] + float(start.kappa) * last[1])  # e_λ + κ e_y
    assert f <= float(Fraction(pieces[-1].fast, ONE)) + 1e-7
    assert f >= float(Fraction(pieces[-1].fast, ONE)) / 2  # and the bound is no larger than it must be


@given(st.fractions(min_value=-5, max_value=8, max_denominator=1000))
def test_the_flow_solves_the_equation_but_for_what_is_said(s: Fraction) -> None:
    """AY - Y' by exact rationals, coefficient by coefficient."""
    equations = side.Equations(numbers(), shipped())
    flow, beyond = equations.flow(s)
    A, slope = (equations.matrix(value) for value in (s, s + 1))
    for i in range(3):
        for j in range(3):
            for k in range(side.DEGREE + 2):
                left = Fraction(0)
                for m in range(3):
                    left += A[i][m] * (flow[m][j][k] if k <= side.DEGREE else 0)
                    left += (slope[i][m] - A[i][m]) * (flow[m][j][k - 1] if 1 <= k <= side.DEGREE + 1 else 0)
                left -= (k + 1) * flow[i][j][k + 1] if k < side.DEGREE else 0
                assert 0 <= left - beyond[i][j][k] <= max(k + 1, 1)


@pytest.mark.parametrize("delta", [Fraction(1, 3000), Fraction(1, 512)])
def test_the_defect_holds_for_every_delta_of_the_range(delta: Fraction) -> None:
    """A'Y - Y' at some δ and time, with A' of this δ, lies in what is computed for the range and the piece."""
    of, s, t = shipped(), Fraction(3, 2), Fraction(1, 30)
    equations = side.Equations(numbers(), of)
    flow, beyond = equations.flow(s)
    time = (0, side.units(Fraction(1, 20)))
    bound = equations.defect(
        side.on_all(numbers(), beyond, time),
        side.on_all(numbers(), flow, time),
        side.between(numbers(), s, s + Fraction(1, 20)),
    )
    at = [[sum(c * t**k for k, c in enumerate(entry)) for entry in row] for row in flow]
    change = [[sum(k * c * t ** (k - 1) for k, c in enumerate(entry) if k) for entry in row] for row in flow]
    equations.middle = delta
    A = equations.matrix(s + t)
    for i in range(3):
        for j in range(3):
            left = sum(A[i][m] * at[m][j] for m in range(3)) - change[i][j]
            assert bound[i][j][0] <= left <= bound[i][j][1]


@given(st.lists(st.floats(-0.2, 0.2), min_size=9, max_size=9), st.lists(st.floats(0, 1), min_size=9, max_size=9))
def test_the_inverse_holds_that_of_every_matrix(middles: list[float], shares: list[float]) -> None:
    E = [Fraction(value) for value in middles]
    M = [[(side.units(E[3 * i + j] + (i == j)) - 2**180, side.units(E[3 * i + j] + (i == j)) + 2**180)
          for j in range(3)] for i in range(3)]  # fmt: skip
    if max(sum(abs(E[3 * i + j]) for j in range(3)) for i in range(3)) > 0.59:
        return
    one = np.array([[float(Fraction(low + round(share * (high - low)), ONE)) for (low, high), share in
                     zip(row, shares[3 * i : 3 * i + 3], strict=True)] for i, row in enumerate(M)])  # fmt: skip
    found = side.inverse_of(M)
    for row, true in zip(found, np.linalg.inv(one), strict=True):
        assert all(held(value, entry) for value, entry in zip(true, row, strict=True))


def test_a_matrix_far_from_1_is_not_inverted() -> None:
    M = [[(2 * ONE * (i == j),) * 2 for j in range(3)] for i in range(3)]
    with pytest.raises(check.limits.Rejected, match="too long for its flow"):
        side.inverse_of(M)


@given(st.fractions(min_value=-900, max_value=900, max_denominator=10**6))
def test_a_power_of_e_is_bounded_closely(x: Fraction) -> None:
    bound = passage.exp_above(x)
    exact = float(x)
    if exact > -120:
        assert abs(math.log(bound.numerator) - math.log(bound.denominator) - exact) <= 1e-9
        assert bound >= 1 + x  # e^x is, so a bound is
    else:
        assert 0 < bound < Fraction(1, 10**50)


def test_a_large_power_of_e_is_refused() -> None:
    with pytest.raises(check.limits.Rejected, match="a power of e is too large"):
        passage.exp_above(Fraction(1000))


@given(st.lists(st.floats(-1, 1), min_size=9, max_size=9), st.lists(st.floats(-1, 1), min_size=3, max_size=3))
def test_a_turned_set_holds_the_set(entries: list[float], inside: list[float]) -> None:
    rows = np.array(entries).reshape(3, 3) + 3 * np.eye(3)
    columns = [[(side.units(Fraction(v)),) * 2 for v in row] for row in rows.tolist()]
    radii = [side.units(Fraction(1, k + 2)) for k in range(3)]
    state = side.Deviations([[ONE * (i == j) for j in range(3)] for i in range(3)], [ONE, 0, ONE // 2], radii, 0, 0)
    after = side.turned(numbers(), columns, state)
    u = np.array([1.0, 0.0, 0.5]) + np.array(inside) / [2, 3, 4]
    e = rows @ u
    basis = np.array([[float(Fraction(v, ONE)) for v in row] for row in after.basis])
    assert np.abs(basis.T @ basis - np.eye(3)).max() < 1e-9
    moved = np.linalg.solve(basis, e) - [float(Fraction(v, ONE)) for v in after.centre]
    bounds = [float(Fraction(v, ONE)) for v in after.radii]
    assert all(abs(value) <= bound + 1e-9 for value, bound in zip(moved, bounds, strict=True))


def test_the_amplitude_is_that_of_the_distinguished_deviation() -> None:
    """|L| (aSδ²/p_1)^(β-1) but for the drift of C_1, which section 10 bounds coarsely."""
    of = shipped(9)
    start = of.start
    exact = 2 * math.sqrt(float(start.a * start.scaled * of.most**2 / start.p))  # |L| = 2, β = 3/2
    low, high = map(float, of.amplitude(numbers()))
    assert exact * math.exp(-0.02) <= low < high <= exact * math.exp(0.02)
    assert high / low < 1.02


def test_what_the_deviations_feed_into_the_fast_part_is_the_formula_of_the_page() -> None:
    """(3): (l/g)δ²|e_b + κas e_y + (l/g)δas e_v|/g_-, at the largest δ, and no less than at any other."""
    of = shipped(9)
    equations, s = side.Equations(numbers(), of), Fraction(3, 2)
    e = [Fraction(2), Fraction(3, 4), Fraction(5, 8)]
    found = equations.fed([(side.units(v), side.units(v)) for v in e], (side.units(s), side.units(s)))
    lag, a, kappa = equations.lag, of.start.a, of.start.kappa
    turn = e[0] + kappa * a * s * e[1] + lag * of.most * a * s * e[2]
    exact = lag * of.most**2 * turn / equations.least_rate
    assert exact <= Fraction(found, ONE) <= exact * (1 + Fraction(1, 10**9))
    assert equations.least_rate == of.start.rate - lag * of.most**2 * a * of.scaled
