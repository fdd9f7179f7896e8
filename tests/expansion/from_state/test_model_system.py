"""The model system: its equations at a point, and that its distinguished trajectory is what the page says."""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.expansion.from_state.model_system import model_system
from gspot_verified.expansion.series.regularisation import PAPER
from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.numbers.balls import working_bits

FIRST, SECOND, THIRD = fmpq(-2), fmpq(-3), fmpq(-5)


def test_its_equations() -> None:
    """p' = alpha_1, b' = alpha_2 - alpha_3 lambda, y' = v, v' = b + p lambda."""
    system = model_system(FIRST, SECOND, THIRD, PAPER)
    force, state = fmpq(7), [fmpq(n, 11) for n in (13, 17, 19, 23)]
    p, b, _, v = state
    with working_bits(64):
        values = BoxProgram([*system.F, *system.G], 4).values([arb(value) for value in state])
        for k, rate in enumerate((FIRST, SECOND - THIRD * force, v, b + p * force)):
            assert (values[k] + values[4 + k] * force).contains(rate)


def test_its_distinguished_trajectory_is_exact() -> None:
    """lambda = alpha_2/(alpha_3 - alpha_1), p = alpha_1 t, b = -p lambda: nothing but the leading terms."""
    trajectory = expand_system(model_system(FIRST, SECOND, THIRD, PAPER), 8)
    leading = {"p": FIRST, "b": -FIRST, "lambda_n": fmpq(1)}  # b = -p lambda
    for name, value in leading.items():
        first, *others = trajectory.terms()[name]
        assert list(first.coefficients()) == ([value] if name == "lambda_n" else [0, value])
        assert all(not any(one.coefficients()) for one in others)
