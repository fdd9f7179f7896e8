"""Systems with affine alphas (proofs/from_state.md, section 8), as they stand."""

from __future__ import annotations

from dataclasses import replace

import pytest
from flint import arb, fmpq

from gspot_verified.expansion.from_state.affine_system import Affine, AffineSystem
from gspot_verified.expansion.from_state.slow_series import RING, H, R
from gspot_verified.expansion.series.regularisation import PAPER, Regularisation
from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Variable
from gspot_verified.numbers.balls import working_bits

EXTENDED = AffineSystem(Affine(fmpq(-1), fmpq(0), fmpq(1)), Affine(fmpq(-1)), Affine(fmpq(-3, 2)), PAPER)
BENT = AffineSystem(
    Affine(fmpq(-4, 5), fmpq(1, 3), fmpq(-2)),
    Affine(fmpq(-7, 6), fmpq(3, 4), fmpq(1, 2)),
    Affine(fmpq(-1), fmpq(-2), fmpq(5, 3)),
    Regularisation.of(2, 3, "1/2"),
)  # beta = 5/4
STEEPER = replace(BENT, alpha_3=Affine(fmpq(-28, 15), fmpq(-2), fmpq(5, 3)))  # beta = 7/3


def test_the_numbers_of_the_spot() -> None:
    assert (BENT.a, BENT.beta, BENT.mean_force) == (fmpq(4, 5), fmpq(5, 4), fmpq(35, 6))
    assert (EXTENDED.a, EXTENDED.beta, EXTENDED.mean_force) == (1, fmpq(3, 2), 2)


def test_an_affine_function_of_polynomials() -> None:
    assert BENT.alpha_1.above((R * R, H + 1, H, R)) == RING.constant(fmpq(-2)) + R * R / 3 - 2 * H
    assert BENT.alpha_1.value == fmpq(-4, 5)


def test_the_system_has_the_equations_of_the_page() -> None:
    """F + G lambda_N is (alpha_1, alpha_2 - alpha_3 lambda_N, v, b + p lambda_N)."""
    system, force, state = BENT.system(), fmpq(7), [fmpq(n, 11) for n in (13, 17, 19, 23)]
    p, b, _, v = state
    first, second, third = (
        one.value + one.by_p * p + one.by_b * b for one in (BENT.alpha_1, BENT.alpha_2, BENT.alpha_3)
    )
    with working_bits(128):
        functions = [*system.F, *system.G, system.alpha_1, system.alpha_2, system.alpha_3]
        values = BoxProgram(functions, 4).values([arb(value) for value in state])
        wanted = first, second - third * force, v, b + p * force
        assert all((values[k] + values[4 + k] * force).contains(rate) for k, rate in enumerate(wanted))
        assert all(values[8 + k].contains(value) for k, value in enumerate((first, second, third)))
        assert all(value.rad() < arb("1e-30") for value in values)
    assert system.point == (0, 0, 0, 0)
    assert system.state == ("p", "b", "y", "v")
    assert (system.y, system.v, system.p, system.b) == tuple(Variable(i) for i in (2, 3, 0, 1))
    assert system.regularisation == BENT.regularisation


def test_an_affine_function_in_words() -> None:
    assert Affine(fmpq(-1), fmpq(0), fmpq(1)).text == "-1 + (1) b"
    assert Affine(fmpq(-1, 2), fmpq(-2)).text == "-1/2 + (-2) p"
    assert Affine(fmpq(3)).text == "3"


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"alpha_1": Affine(fmpq(0))}, "alpha_1 and alpha_2 must be negative"),
        ({"alpha_1": Affine(fmpq(1, 2)), "alpha_3": Affine(fmpq(1))}, "alpha_1 and alpha_2 must be negative"),
        ({"alpha_2": Affine(fmpq(0))}, "alpha_1 and alpha_2 must be negative"),
        ({"alpha_2": Affine(fmpq(1, 2))}, "alpha_1 and alpha_2 must be negative"),
        ({"alpha_3": Affine(fmpq(-2))}, "above 1 and no integer, got 2"),
        ({"alpha_3": Affine(fmpq(-5))}, "above 1 and no integer, got 5"),
        ({"alpha_3": Affine(fmpq(-1))}, "above 1 and no integer, got 1"),
        ({"alpha_3": Affine(fmpq(-1, 2))}, "above 1 and no integer, got 1/2"),
    ],
)
def test_what_is_beside_the_theorem_is_refused(change: dict[str, Affine], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        replace(EXTENDED, **change)
