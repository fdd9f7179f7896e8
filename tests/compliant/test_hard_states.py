"""States where the side is hard to tell: exactly on the slow manifold, and with slow and fast parts that cancel."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest
from flint import arb, fmpq
from samples.strategies import ends, holds
from witnesses.slow_solution import on_the_slow_manifold

from gspot_verified.compliant.model.normal_form import Deviation, compliant_model, compliant_state
from gspot_verified.compliant.side.side_rule import coefficients, side_rule
from gspot_verified.numbers.balls import sign_of, working_bits
from gspot_verified.numbers.verdict import Outcome


@pytest.mark.parametrize("beta", [2, 3, 4, 7])
@pytest.mark.parametrize("epsilon", [Fraction(3), Fraction(1, 20), Fraction(1, 1000)])
def test_states_exactly_on_the_slow_manifold(beta: int, epsilon: Fraction) -> None:
    slow, fast, side = coefficients(on_the_slow_manifold(beta, epsilon, Fraction(1, 2)), 60)
    assert holds(slow, 1)
    for ball in (fast.real, fast.imag, side):
        assert holds(ball, 0)
    assert sign_of(side) is None


def test_a_state_exactly_on_the_slow_manifold_is_undecided() -> None:
    hats = on_the_slow_manifold(3, Fraction(1, 20), Fraction(1, 2))
    model = compliant_model(3, "1/20", alpha_2=0)
    square = hats.epsilon**2
    y, z = hats.Y * square, hats.Z * square
    sign = 1 if z > y else -1
    state = compliant_state(hats.p, sign * hats.b, sign * y, sign * hats.V * hats.epsilon, sign * z)
    found = side_rule(model, state, digits=5)
    assert found.verdict.outcome is Outcome.UNDECIDED
    assert "no side follows from K = 0, as on the canard and, at an integer β, on the whole slow" in str(found.verdict)
    assert found.paper_differs is None  # the rule has no side at an integer beta


@pytest.mark.parametrize("beta", [fmpq(5, 2), fmpq(13, 2)])
@pytest.mark.parametrize("gap", [200, 400])
def test_slow_and_fast_parts_that_cancel(beta: fmpq, gap: int) -> None:
    """Hats b and Y so that K is 2^-gap of its parts: no sign from few bits, the right one from many."""
    base = Deviation(beta, fmpq(1, 50), fmpq(1, 2), fmpq(1), fmpq(0), fmpq(0), fmpq(0))
    other = replace(base, b=fmpq(0), Y=fmpq(1), Z=fmpq(1))
    one, two = (coefficients(state, 600)[2] for state in (base, other))
    with working_bits(600):
        scaled = _middle(-one / two * arb(2) ** gap)
    share = fmpq(scaled.numerator // scaled.denominator, 1) / fmpq(2) ** gap
    with working_bits(700):
        sides = {step: one + (share + fmpq(step) / fmpq(2) ** gap) * two for step in (-1, 2)}
    for step, expected in sides.items():
        state = replace(base, Y=share + fmpq(step) / fmpq(2) ** gap)
        state = replace(state, Z=state.Y)
        assert sign_of(coefficients(state, 60)[2]) is None
        assert sign_of(coefficients(state, gap + 80)[2]) == sign_of(expected) is not None


def _middle(value: arb) -> Fraction:
    lower, upper = ends(value)
    return (lower + upper) / 2
