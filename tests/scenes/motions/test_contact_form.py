"""The form of the contact is read off the equations, and equations of another form are refused, one by one.

Page: proofs/invariant_region.md, section 1.
"""

from __future__ import annotations

from dataclasses import replace

import pytest
from flint import arb, fmpq

from gspot_verified.functions.expressions import Constant, Expression, Variable
from gspot_verified.numbers.balls import working_bits
from gspot_verified.scenes.equations.scaled_system import CONTACT, PhaseEvent, ScaledSystem
from gspot_verified.scenes.equations.terms import FLIGHT
from gspot_verified.scenes.motions.contact_form import ContactForm, NotOfThisForm

b, Y, V, Z, clock = (Variable(i) for i in range(5))
STATES = ("b", "Y", "V", "Z")


def number(numerator: int, denominator: int = 1) -> Constant:
    return Constant(fmpq(numerator, denominator))


K = number(3)
FORCE = K * (Z - Y)
MOVES, FALLS = number(1) + number(-2) * FORCE, b + number(-1, 5) * FORCE
RELAXES = number(-1, 2) * Z + number(-1, 4) * FORCE


def system(
    *,
    force: Expression = FORCE,
    moves: Expression = MOVES,
    closes: Expression = V,
    falls: Expression = FALLS,
    relaxes: Expression = RELAXES,
    stop: Expression = b,
) -> ScaledSystem:
    """k = 3, kappa = 1/2, gamma = 1/4, F = b - λ/5, b' = 1 - 2 λ, and a phase that ends at b = 0."""
    events = (PhaseEvent("lift-off", FORCE, FLIGHT), PhaseEvent("slip stops", stop, CONTACT))
    return ScaledSystem("slip", STATES, (moves, closes, falls, relaxes), events, (("lambda_N", force),))


def test_the_constants_of_the_contact() -> None:
    form = ContactForm(system())
    assert (form.k, form.kappa, form.gamma, form.s) == (3, fmpq(1, 2), fmpq(1, 4), fmpq(5, 4))
    assert (form.slow, form.size, (form.Y, form.V, form.Z)) == ([0], 4, (1, 2, 3))
    assert form.affine
    assert form.constant_load


def test_the_enclosures_are_those_of_the_equations() -> None:
    """F = b - λ/5; H = dF/dT with λ standing still = b' = 1 - 2 λ; the stop b with its rate."""
    form = ContactForm(system())
    with working_bits(80):
        box = [arb(7), arb(-1), arb(2), arb(0), arb(1), arb(3)]
        found = form.bounds(box)
        assert abs(form.acceleration(box) - fmpq(32, 5)) < 1e-15
        assert abs(found.slope + fmpq(1, 5)) < 1e-15
    assert (found.still, found.constant, found.factor) == (7, 1, -2)
    assert (found.rates, found.pushes) == ((1,), (-2,))
    assert (found.stops, found.stop_rates, found.stop_pushes) == ((7,), (1,), (-2,))


@pytest.mark.parametrize(
    ("falls", "moves", "affine", "constant_load"),
    [
        (b + number(-1, 5) * FORCE, number(1) + FORCE, True, True),
        # q = -∂F/∂λ = clock/5 rises; so does it not fall. -clock/5 falls: no constant load.
        (b + number(-1, 5) * clock * FORCE, number(1), True, True),
        (b + number(1, 5) * clock * FORCE, number(1), True, False),
        (b + number(-1, 5) * clock * clock * FORCE, number(1), True, False),  # q rises at no constant rate
        # H = b' is no constant, or not affine in λ.
        (b + number(-1, 5) * FORCE, b, True, False),
        (b + number(-1, 5) * FORCE, b * FORCE, True, False),
        (b + number(-1, 5) * FORCE * FORCE, number(1), False, False),
        (b + number(-1, 5) * FORCE, FORCE * FORCE, False, False),
    ],
)
def test_which_loads_are_constant(falls: Expression, moves: Expression, affine: bool, constant_load: bool) -> None:
    form = ContactForm(system(falls=falls, moves=moves))
    assert (form.affine, form.constant_load) == (affine, constant_load)


@pytest.mark.parametrize(
    "changed",
    [
        {"force": number(-3) * (Z - Y)},
        {"force": FORCE + number(1)},
        {"force": FORCE + b},
        {"force": number(3) * Z + number(-2) * Y},
        {"force": FORCE + number(2) * clock},
        {"force": FORCE * FORCE},
        {"closes": V + b},
        {"closes": number(2) * V},
        {"relaxes": number(1, 2) * Z + number(-1, 4) * FORCE},
        {"relaxes": number(-1, 4) * FORCE},
        {"relaxes": number(-1, 2) * Z + number(1, 100) * FORCE},
        {"relaxes": number(-1, 2) * Z},
        {"relaxes": number(-1, 2) * Z + number(-1, 4) * FORCE + number(1)},
        {"relaxes": number(-1, 2) * Z + number(-1, 4) * FORCE + b},
        {"relaxes": number(-1, 2) * Z + number(-1, 4) * FORCE + clock},
        {"relaxes": number(-1, 2) * Z * Z + number(-1, 4) * FORCE},
        {"moves": Z},
        {"moves": number(2) * Z - Y},
        {"falls": b + Z},
        {"stop": Z},
    ],
)
def test_equations_of_another_form_are_refused(changed: dict[str, Expression]) -> None:
    with pytest.raises(NotOfThisForm):
        ContactForm(system(**changed))


def test_a_multiple_of_the_gap_is_a_multiple_of_the_force() -> None:
    """b' = 2 Z - 2 Y is 2 λ/3, and F = b - 2 (Z - Y) is b - 2 λ/3."""
    form = ContactForm(system(moves=number(2) * Z + number(-2) * Y, falls=b + number(-2) * (Z - Y)))
    with working_bits(80):
        found = form.bounds([arb(7), arb(-1), arb(2), arb(0), arb(1), arb(3)])
        assert abs(found.pushes[0] - fmpq(2, 3)) < 1e-15
        assert abs(found.slope + fmpq(2, 3)) < 1e-15
    assert found.rates == (0,)
    assert found.still == 7


def test_bounds_are_finite_only_where_all_that_is_needed_is() -> None:
    form = ContactForm(system())
    box = [arb(7), arb(-1), arb(2), arb(0), arb(1), arb(3)]
    assert form.bounds(box).are_finite()
    assert not form.bounds([arb("nan"), *box[1:]]).are_finite()


def test_a_system_has_one_rate_for_each_state() -> None:
    made = system()
    with pytest.raises(ValueError, match="4 states, 3 rates"):
        replace(made, right_hand_side=made.right_hand_side[:3])
