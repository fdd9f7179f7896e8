"""What the page on units says of ε, by routes that share no formula with it."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from gspot_verified import compliant_model, compliant_state, force
from gspot_verified.compliant.model.force_result import CompliantForce
from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.testing import extended_example

RATIONALS = st.fractions(min_value="1/7", max_value=7, max_denominator=7)

# A contact in SI units (N/m, N s/m), α's, a state p, b, y, v, z in contact, a time in s after p = 0.
STIFFNESS, DAMPING = Fraction(10**6), Fraction(500)
ALPHAS = (Fraction(-200), Fraction(-100), Fraction(-500))
START = (Fraction(1, 2), Fraction(-1), Fraction(-4, 10**6), Fraction(1, 1000), Fraction(-2, 10**6))
TIME = Fraction(1, 500)


def in_units(time_unit: Fraction) -> tuple[CompliantForce, Fraction]:
    """The library's contact force with the mass unit c²/k and ε = c/(kT), and what 1 of it is in N."""
    mass, epsilon = DAMPING**2 / STIFFNESS, DAMPING / (STIFFNESS * time_unit)
    first, second, third = ALPHAS
    model = compliant_model(
        epsilon=epsilon,
        alpha_1=first * mass * time_unit,
        alpha_2=second * time_unit**3,
        alpha_3=third * mass * time_unit,
    )
    p, b, y, v, z = START
    state = compliant_state(p * mass, b * time_unit**2, y, v * time_unit, z)
    return force(model, state, TIME / time_unit), mass / time_unit**2


def test_the_force_in_newton_does_not_depend_on_the_unit_of_time() -> None:
    texts = []
    for time_unit in (Fraction(1), Fraction(1, 1000), Fraction(7, 3)):
        found, newton = in_units(time_unit)
        texts.append(found.force * fmpq(newton.numerator, newton.denominator))
    assert all(text.is_finite() and text.rel_accuracy_bits() > 30 for text in texts)
    assert all(text.overlaps(texts[0]) for text in texts)


def test_it_is_the_force_of_the_springs_and_the_damper() -> None:
    """The equations in SI units as they stand, c ż = −kz − λ, λ = k(z − y), by a float solver."""
    k, c = float(STIFFNESS), float(DAMPING)
    first, second, third = map(float, ALPHAS)

    def rates(_: float, state: list[float]) -> list[float]:
        p, b, y, v, z = state
        pressed = k * (z - y)
        return [first, second - third * pressed, v, b + p * pressed, (-k * z - pressed) / c]

    before = START[0] / ALPHAS[0]
    run = solve_ivp(
        rates, (float(before), float(TIME)), list(map(float, START)), method="Radau", rtol=1e-10, atol=1e-14
    )
    _, _, y, _, z = run.y[:, -1]
    found, newton = in_units(Fraction(1))
    assert k * (z - y) == pytest.approx(float(found.force.mid()) * float(newton), rel=1e-6)


@given(stiffness=RATIONALS, damping=RATIONALS, alpha=RATIONALS, time_unit=RATIONALS)
def test_the_one_number_of_the_model(
    stiffness: Fraction, damping: Fraction, alpha: Fraction, time_unit: Fraction
) -> None:
    """ε̂ = |α_1| c³/k², in every unit of time; half of it is the cube of the delay over the time scale."""
    mass = damping**2 / stiffness
    model = compliant_model("5/2", damping / (stiffness * time_unit), alpha_1=-alpha * mass * time_unit)
    scaled = Fraction(int(model.scaled_epsilon.p), int(model.scaled_epsilon.q))
    assert scaled == alpha * damping**3 / stiffness**2
    cube_of_time = (1 / stiffness + 1 / stiffness) / alpha
    assert scaled / 2 == (damping / stiffness) ** 3 / cube_of_time


@pytest.mark.parametrize("factor", [fmpq(2), fmpq(1, 3)])
def test_another_epsilon_for_the_same_contact(factor: fmpq) -> None:
    """k_1, k_2, c times r², r², r and ε times r: the coefficient of ε^m is divided by r^m, exactly."""
    system = extended_example("2/3")
    one = Regularisation.of(2, "5/3", "1/2")
    other = Regularisation(one.k_1 * factor**2, one.k_2 * factor**2, one.c * factor)
    before, after = (expand_system(replace(system, regularisation=r), 12).in_time() for r in (one, other))
    powers = set()
    for name in ("p", "b", "y", "v", "z", "lambda_n"):
        table, changed = getattr(before, name), getattr(after, name)
        assert set(table) == set(changed)
        for (k, m), value in table.items():
            assert changed[k, m] * factor**m == value
            powers.add(m)
    assert {0, 2, 3} <= powers
