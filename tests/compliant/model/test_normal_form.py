"""The normal form against the paper's own equations, in exact rationals.

Page: proofs/exact_solution.md.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import to_fmpq

from gspot_verified.compliant.model.normal_form import compliant_model, compliant_state, deviation

positive = st.fractions(Fraction(1, 20), Fraction(20), max_denominator=20)
anything = st.fractions(Fraction(-9), Fraction(9), max_denominator=20)


@given(positive, anything, positive, positive, anything, anything, anything, anything, positive)
def test_deviations_move_as_the_paper_s_equations_say(first, second, third, small, p, b, y, v, gap) -> None:
    if first == third or third > 100 * first:
        return
    alpha = [to_fmpq(-first), to_fmpq(second), to_fmpq(-third)]
    epsilon = to_fmpq(small)
    model = compliant_model(epsilon=epsilon, alpha_1=alpha[0], alpha_2=alpha[1], alpha_3=alpha[2])
    state = compliant_state(*map(to_fmpq, (p, b, y, v, y + gap)))
    # The paper's right-hand side at the state, and the hats of the state a small time later, to first order.
    force = (state.z - state.y) / epsilon**2
    rates = (
        alpha[0],
        alpha[1] - alpha[2] * force,
        state.v,
        state.b + state.p * force,
        -(state.z + epsilon**2 * force) / epsilon,
    )
    step = fmpq(1, 10**3)
    now = deviation(model, state)
    moved = [
        value + step * rate for value, rate in zip((state.p, state.b, state.y, state.v, state.z), rates, strict=True)
    ]
    if moved[4] <= moved[2]:
        return
    later = deviation(model, compliant_state(*moved))
    # In the normal form T advances by step |alpha_1|/epsilon' = step/epsilon.
    unit = step / epsilon
    hats = {
        "b": now.epsilon * now.beta * now.force,
        "Y": now.V,
        "V": now.b + now.p * now.force,
        "Z": -now.Z - now.force,
        "p": -now.epsilon,
    }
    for name, rate in hats.items():
        difference = getattr(later, name) - getattr(now, name) - unit * rate
        assert difference == 0, name


def test_trivial_solution_has_no_deviation() -> None:
    model = compliant_model("7/3", "1/10", alpha_1=-2, alpha_2=-3)
    mean = model.mean_force
    state = compliant_state("1/2", -mean / 2, -2 * mean / 100, 0, -mean / 100)
    found = deviation(model, state)
    assert [found.b, found.V, found.Y, found.Z, found.force] == [0] * 5


@pytest.mark.parametrize(
    ("arguments", "options", "message"),
    [
        ((), {}, "give beta or alpha_3"),
        ((1,), {}, "other than 1"),
        ((-1,), {}, "expected a number < 0"),
        ((2,), {"alpha_1": 1}, "alpha_1: expected"),
        ((2,), {"alpha_3": -3}, "beta: 2 was given"),
        ((2, 0), {}, "epsilon: expected"),
        ((2, "1e-301"), {}, "epsilon: expected"),
        ((2, 10**6 + 1), {}, "epsilon: expected"),
        ((2, 10**5 + 1), {"alpha_1": -10}, "epsilon: expected"),
        ((200,), {}, "expected a number in"),
    ],
)
def test_bad_models_are_refused(arguments, options, message) -> None:
    with pytest.raises(ValueError, match=message):
        compliant_model(*arguments, **options)


def test_the_range_of_epsilon_holds_its_ends_and_is_one_of_the_normal_form() -> None:
    assert compliant_model(2, 10**6).scaled_epsilon == compliant_model(2, 10**5, alpha_1=-10).scaled_epsilon == 10**6
    assert compliant_model(2, "1e-300").scaled_epsilon == fmpq(10) ** -300


def test_time_runs_against_p() -> None:
    """p falls at the rate epsilon in the time of the normal form, and T = 0 is p = 0."""
    model = compliant_model("7/3", "1/10")
    early, late = (deviation(model, compliant_state(p, 0, -1, 0, 0)) for p in ("1/2", "-1/5"))
    assert (early.time, late.time) == (-5, 2)


def test_no_contact_is_refused() -> None:
    with pytest.raises(ValueError, match="in contact y < z"):
        compliant_state(1, 0, 1, 0, 1)
    with pytest.raises(TypeError, match="a float"):
        compliant_state(0.5, 0, 0, 0, 1)
