"""Systems with affine alphas (proofs/from_state.md, section 8): the equations of the deviation, from the raw ones."""

from __future__ import annotations

import random
from dataclasses import replace

import pytest
from flint import arb, fmpq

from gspot_verified.expansion.from_state.affine_system import Affine, AffineSystem
from gspot_verified.expansion.from_state.barrier import value_of
from gspot_verified.expansion.from_state.slow_series import Contact
from gspot_verified.expansion.series.regularisation import PAPER, Regularisation
from gspot_verified.numbers.balls import working_bits

EXTENDED = AffineSystem(Affine(fmpq(-1), fmpq(0), fmpq(1)), Affine(fmpq(-1)), Affine(fmpq(-3, 2)), PAPER)
BENT = AffineSystem(
    Affine(fmpq(-4, 5), fmpq(1, 3), fmpq(-2)),
    Affine(fmpq(-7, 6), fmpq(3, 4), fmpq(1, 2)),
    Affine(fmpq(-1), fmpq(-2), fmpq(5, 3)),
    Regularisation.of(2, 3, "1/2"),
)


def test_the_numbers_of_the_extended_system() -> None:
    """With chi = 1: lambda_N = 2 - 8 p + ... on the distinguished trajectory, by Theorem 1's polynomials."""
    slopes = EXTENDED.slopes
    assert (EXTENDED.mean_force, EXTENDED.tilt, EXTENDED.beta) == (2, -8, fmpq(3, 2))
    assert (slopes.fall, slopes.force, slopes.back, slopes.turn) == (2, -4, 0, -2)


@pytest.mark.parametrize("system", [EXTENDED, BENT])
def test_the_deviation_obeys_its_equations_within_the_bounds(system: AffineSystem) -> None:
    """Rates of L, W, phi at random states, by the chain rule from those of p, b, y, v, z; e and epsilon are small
    and large alike, as nothing is left out."""
    draw = random.Random(3)
    contact, springs, slopes = Contact.of(system.regularisation), system.regularisation, system.slopes
    touched = 0
    for _ in range(300):
        epsilon = fmpq(draw.randint(1, 99), 10 ** draw.randint(2, 6))
        p = fmpq(draw.randint(1, 20), 1000)
        excess = fmpq(draw.choice((-1, 1)) * draw.randint(1, 60), 100)
        along, moving, height = (fmpq(draw.randint(-50, 50), 50) for _ in range(3))  # W/p, V, Y
        rigid = system.mean_force + system.tilt * p + excess
        b, force, e = -p * rigid, rigid + along, system.a * epsilon
        alphas = [one.value + one.by_p * p + one.by_b * b for one in (system.alpha_1, system.alpha_2, system.alpha_3)]
        z = height + force / springs.k_2
        # d/dT = epsilon d/dt
        p_rate, b_rate = epsilon * alphas[0], epsilon * (alphas[1] - alphas[2] * force)
        force_rate = springs.k_2 * ((-springs.k_1 * z - force) / springs.c - moving)
        rigid_rate = -b_rate / p + b * p_rate / p**2
        excess_rate = rigid_rate - system.tilt * p_rate
        w_rate = b_rate + p_rate * force + p * force_rate
        phi = force + contact.kappa * height + contact.lag / contact.rate * moving
        speed = moving - e * system.tilt / contact.kappa
        # (14') solved for its coefficients
        fall = -p_rate / e - 1
        beta = system.beta
        back, turn = -alphas[2] / system.a - beta, (alphas[0] - alphas[2]) / system.a - (beta - 1)
        sigma = -excess_rate * p / e - (beta - 1) * excess - (beta + back) * along
        tau = (
            (w_rate + contact.kappa * p * speed + contact.rate * p * phi) / e
            - (beta - 1 + turn) * along
            - (beta - 1) * excess
        )
        with working_bits(128):
            coefficient = abs(excess) * arb(p) ** arb(1 - beta)
            rests, root = system.rests(p, coefficient, fmpq(1)), arb(p).sqrt()
            for rest, bound, scale in (
                (fall - slopes.fall * p, rests.fall, fmpq(1)),
                (back - slopes.back * p, rests.back, fmpq(1)),
                (turn - slopes.turn * p, rests.turn, fmpq(1)),
                (sigma - slopes.force * p * excess, rests.force, excess),
                (tau - slopes.force * p * excess, rests.force, excess),
            ):
                largest = value_of(bound, arb(1), root) * abs(scale)
                assert abs(arb(rest)) <= largest * arb("1.000001") + arb("1e-30")
                touched += bool(abs(arb(rest)) > largest / 2) and rest != 0
    assert touched > 50  # the bounds are not much too large


@pytest.mark.parametrize(
    "change", [{"alpha_1": Affine(fmpq(0))}, {"alpha_3": Affine(fmpq(-2))}, {"alpha_3": Affine(fmpq(-1))}]
)
def test_what_is_beside_the_theorem_is_refused(change: dict[str, Affine]) -> None:
    with pytest.raises((ValueError, ZeroDivisionError)):
        replace(EXTENDED, **change)
