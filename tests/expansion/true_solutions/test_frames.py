"""The coordinates of a piece: laws of the choices, which may be any. Page: proofs/uniform.md, Theorem U1."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb, arb_mat, fmpq

from gspot_verified.expansion.true_solutions.frames import (
    frame_at,
    identity,
    larger,
    matrix_value,
    number_of_pieces,
    turned_frame,
)
from gspot_verified.numbers.balls import ball, working_bits

LIMIT = [[1, -2, 0], [3, 0, 1], [0, 1, -1]]  # at s = 1/4
SLOPE = [[0, 1, 0], [2, 0, 0], [0, 0, 1]]


def equations(alpha_1: str = "-2", kappa: str = "4") -> Any:
    def limit(s: arb) -> arb_mat:
        return arb_mat(LIMIT) + arb_mat(SLOPE) * (s - arb(fmpq(1, 4)))

    return SimpleNamespace(
        size=3, limit=limit, limit_slope=lambda: arb_mat(SLOPE), alpha_1=arb(alpha_1), kappa=arb(kappa)
    )


def test_the_flow_of_the_limit() -> None:
    """Y' = (A_0 + t A_0') Y and Y(0) = 1, in exact coefficients up to the power 12."""
    with working_bits(128):
        turned = arb_mat(3, 3, [1, 2, 0, 0, 1, 0, 0, 0, 3])
        frame = frame_at(equations(), fmpq(1, 4), turned)
        assert frame.turned == turned
        assert len(frame.flow) == 13
        assert frame.flow[0] == identity(3) == arb_mat(3, 3, [1, 0, 0, 0, 1, 0, 0, 0, 1])
        for k in range(12):
            rest = frame.flow[k + 1] * (k + 1) - arb_mat(LIMIT) * frame.flow[k]
            if k:
                rest = rest - arb_mat(SLOPE) * frame.flow[k - 1]
            assert all(entry.is_exact() for entry in frame.flow[k + 1].entries())
            assert all(entry.is_finite() and abs(entry) < arb(2) ** -110 for entry in rest.entries())
        time = ball(fmpq(1, 8))
        step, value = arb_mat(3, 3), frame.at(time)
        for k, matrix in enumerate(frame.flow):
            step = step + matrix * time**k
        assert all(abs(a - b) < arb(2) ** -110 for a, b in zip(value.entries(), step.entries(), strict=True))


def test_a_polynomial_with_matrices() -> None:
    matrices = [arb_mat([[1, 2]]), arb_mat([[0, 1]]), arb_mat([[3, 0]])]
    assert matrix_value(matrices, arb(2)) == arb_mat([[13, 4]])
    assert matrix_value(matrices[:1], arb(2)) == arb_mat([[1, 2]])


def test_the_longest_deviations_are_turned_to_first() -> None:
    """Columns (3, 4) and (1, 0) with one radius each: the first direction is that of the longer product."""
    columns = arb_mat([[3, arb(1, 1e-9)], [4, 0]])
    for radii, first in [([arb(1), arb(1)], (0.6, 0.8)), ([arb(1), arb(100)], (1.0, 0.0))]:
        found = turned_frame(columns, radii)
        assert (float(found[0, 0].mid()), float(found[1, 0].mid())) == pytest.approx(first)
        for entry in (found.transpose() * found - identity(2)).entries():
            assert abs(entry) < 1e-12
            assert entry.is_finite()


@pytest.mark.parametrize(
    ("start", "end", "count"),
    [("0", "1", 28), ("-1", "1", 56), ("1/2", "13/25", 1), ("1/2", "1/2", 1), ("0", "1/27", 2)],
)
def test_fourteen_pieces_for_each_unit_of_tau(start: str, end: str, count: int) -> None:
    """tau = 2 s for alpha_1 = -2, kappa = 4."""
    pair = (fmpq(*map(int, f"{text}/1".split("/")[:2])) for text in (start, end))
    assert number_of_pieces(equations(), *pair) == count


@pytest.mark.parametrize("value", [arb(0), arb(1), arb(1e-30), arb(5, 1)])
def test_a_guess_lies_above_what_was_found(value: arb) -> None:
    found = larger(value)
    assert found.is_finite()
    assert found > value
    assert found < value.upper() * arb("1.04") + arb("2e-25")
