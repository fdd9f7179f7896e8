"""Systems with affine alphas (proofs/from_state.md, section 8): the equations of the deviation, from the raw ones."""

from __future__ import annotations

import random
from dataclasses import replace

import mpmath
import pytest
from flint import arb, fmpq

from gspot_verified.expansion.from_state.affine_system import Affine, AffineSystem
from gspot_verified.expansion.from_state.barrier import value_of
from gspot_verified.expansion.from_state.slow_series import Contact
from gspot_verified.expansion.series.regularisation import PAPER, Regularisation
from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Variable
from gspot_verified.numbers.balls import working_bits
from tests.expansion.from_state.test_affine_tube import RATIO, SYSTEM, P, Page, start
from tests.expansion.from_state.test_barrier_numbers import agrees

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


def coefficients(
    system: AffineSystem, p: fmpq, excess: fmpq, along: fmpq, moving: fmpq, height: fmpq, epsilon: fmpq
) -> tuple[fmpq, fmpq, fmpq, fmpq, fmpq]:
    """(14') solved for w, beta_3, omega, sigma, tau at W/p, V, Y: rates of L, W, phi by the chain rule from those of p,
    b, y, v, z; nothing is left out."""
    contact, springs = Contact.of(system.regularisation), system.regularisation
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
    beta = system.beta
    back, turn = -alphas[2] / system.a - beta, (alphas[0] - alphas[2]) / system.a - (beta - 1)
    sigma = -excess_rate * p / e - (beta - 1) * excess - (beta + back) * along
    tau = (
        (w_rate + contact.kappa * p * speed + contact.rate * p * phi) / e
        - (beta - 1 + turn) * along
        - (beta - 1) * excess
    )
    return -p_rate / e - 1, back, turn, sigma, tau


@pytest.mark.parametrize("system", [EXTENDED, BENT, SYSTEM])
def test_the_deviation_obeys_its_equations_within_the_bounds(system: AffineSystem) -> None:
    """At random states; e and epsilon are small and large alike."""
    draw = random.Random(3)
    slopes = system.slopes
    touched = 0
    for _ in range(300):
        epsilon = fmpq(draw.randint(1, 99), 10 ** draw.randint(2, 6))
        p = fmpq(draw.randint(1, 20), 1000)
        excess = fmpq(draw.choice((-1, 1)) * draw.randint(1, 60), 100)
        along, moving, height = (fmpq(draw.randint(-50, 50), 50) for _ in range(3))  # W/p, V, Y
        fall, back, turn, sigma, tau = coefficients(system, p, excess, along, moving, height, epsilon)
        with working_bits(128):
            coefficient = abs(excess) * arb(p) ** arb(1 - system.beta)
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


@pytest.mark.parametrize("system", [EXTENDED, BENT, SYSTEM])
def test_the_slopes_and_the_tilt_are_limits(system: AffineSystem) -> None:
    """sigma/(p L), tau/(p L), w/p, ... for p much smaller than L, and both small; a wrong tilt would be of order p."""
    slopes, p, excess = system.slopes, fmpq(1, 10**20), fmpq(1, 10**10)
    fall, back, turn, sigma, tau = coefficients(system, p, excess, fmpq(1, 3), fmpq(2, 5), fmpq(3, 7), fmpq(1, 1000))
    for value, slope in (
        (fall / p, slopes.fall),
        (back / p, slopes.back),
        (turn / p, slopes.turn),
        (sigma / (p * excess), slopes.force),
        (tau / (p * excess), slopes.force),
    ):
        assert abs(value - slope) < fmpq(1, 10**5)


@pytest.mark.parametrize("excess", [fmpq(1, 3), fmpq(-1, 4)])
def test_the_bounds_are_those_of_the_page(excess: fmpq) -> None:
    given = start(excess=excess)
    with working_bits(192), mpmath.workdps(50):
        page = Page(given)
        found = SYSTEM.rests(P, abs(given.coefficient), RATIO)
        for terms, wanted in zip(
            (found.force, found.fall, found.back, found.turn), (page.s, page.pi, page.b_hat, page.o_hat), strict=True
        ):
            assert terms.keys() == wanted.keys()
            assert all(agrees(terms[key], value) for key, value in wanted.items())


def test_what_is_zero_has_no_monomial() -> None:
    rests = EXTENDED.rests(fmpq(1, 100), arb(1), fmpq(1))
    assert rests.back == {}
    assert rests.fall.keys() == rests.turn.keys() == {(0, 3), (0, 4)}


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
        ({"alpha_3": Affine(fmpq(-2))}, "above 1 and not 2, got 2"),
        ({"alpha_3": Affine(fmpq(-1))}, "above 1 and not 2, got 1"),
        ({"alpha_3": Affine(fmpq(-1, 2))}, "above 1 and not 2, got 1/2"),
    ],
)
def test_what_is_beside_the_theorem_is_refused(change: dict[str, Affine], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        replace(EXTENDED, **change)
