"""The set that is handed over at s = -S (proofs/from_state.md, section 5), beside direct integration."""

from __future__ import annotations

import numpy as np
import pytest
from flint import arb, arb_mat, fmpq
from witnesses.slow_deviation import motion

from gspot_verified.expansion.from_state.barrier import Start, Tube, start_bound, tube
from gspot_verified.expansion.from_state.fast_growth import Norm, Rectangle, fast_growth
from gspot_verified.expansion.from_state.hand_over import HandOver, hand_over_set
from gspot_verified.expansion.from_state.passage import model_system
from gspot_verified.expansion.from_state.slow_series import Contact, SlowSeries, slow_series
from gspot_verified.expansion.series.regularisation import PAPER
from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.expansion.true_solutions.slow_deviation import slow_deviation
from gspot_verified.numbers.balls import approximate, working_bits

BITS = 128
BETA, HALF, FAR = fmpq(5, 2), fmpq(1, 2), fmpq(4)
GIVEN: dict[fmpq, tuple[DeviationEquations, Tube, SlowSeries]] = {}


def given_for(delta: fmpq) -> tuple[DeviationEquations, Tube, SlowSeries]:
    with working_bits(BITS):
        if delta not in GIVEN:
            series = slow_series(BETA, Contact.of(PAPER), 5)
            norm, rectangle = Norm(series, fmpq(1), HALF), Rectangle(fmpq(1, 8), fmpq(7072, 10000))
            growth = fast_growth(norm, rectangle, fmpq(7, 10), fmpq(1, 20))
            start = Start(HALF, delta**3, start_bound(series, HALF, delta**3, fmpq(0)), 1, fmpq(1))
            found = tube(norm, growth, rectangle, start, fmpq(1, 30))
            assert isinstance(found, Tube), found
            trajectory = expand_system(model_system(fmpq(-1), fmpq(-1), -BETA, PAPER), 10)
            GIVEN[delta] = DeviationEquations(trajectory, delta), found, series
        return GIVEN[delta]


def handed(delta: fmpq) -> HandOver:
    with working_bits(BITS):
        return hand_over_set(*given_for(delta), -(arb(HALF) ** arb(fmpq(-3, 2))), FAR)


@pytest.mark.parametrize("smaller", [1.0, 1.7])
def test_motions_from_the_start_arrive_in_the_set(smaller: float) -> None:
    """The state at rest with L = 1, at epsilon_0 and below; coordinates u in the frame, and phi."""
    bound, found = fmpq(1, 12), handed(fmpq(1, 12))
    delta = approximate(bound) / smaller
    p = 4 * delta**2
    L, V, W, phi = motion(2.5, delta**3, 0.5, (1.0, 0.0, 0.0, 0.0), [p])[0]
    unit = delta ** -(2 * 2.5 - 2)  # e of b, y, v over delta^mu
    fast = phi - V / 4
    e_b, e_lambda, e_v = -p * L / delta**2 * unit, (L + W / p) * unit, V / delta * unit
    e_y = 2 * (fast * unit - e_lambda)
    e = [0.0, e_b, delta**4 * e_y, delta**2 * e_v, 0.0, e_b, e_y, e_v]
    with working_bits(BITS):
        u = [approximate(one) for one in (found.frame.inv() * arb_mat([[arb(value)] for value in e])).entries()]
        frame = approximate(found.frame[5, 5])
    centre, radii = [approximate(one) for one in found.centre], [approximate(one) for one in found.radii]
    for value, middle, radius in zip(u, centre, radii, strict=True):
        assert abs(value - middle) <= radius + 1e-7 * abs(frame)
    assert abs(phi) * unit <= approximate(found.fast)
    c_1 = -L * p**-1.5
    assert abs(c_1 - approximate(found.coefficient)) <= float(found.coefficient.rad()) + 1e-7
    # the set is small beside what it holds
    assert radii[5] < 0.03
    assert radii[6] < 0.1 * abs(e_y)
    assert radii[7] < 0.1 * abs(e_v)


def test_the_slow_column_is_that_of_theta() -> None:
    """As delta tends to 0: (theta, theta', theta'') at tau = -kappa_Theta S, by the paper's slow deviation."""
    found = handed(fmpq(1, 200))
    equations, _, _ = given_for(fmpq(1, 200))
    with working_bits(BITS):
        theirs = [approximate(one * found.coefficient) for one in slow_deviation(equations, BETA, fmpq(1), -FAR)]
        ours = [approximate(found.frame[i, 5]) for i in range(8)]
    for i in (1, 5, 6, 7):
        assert np.isclose(ours[i], theirs[i], rtol=0.03)


def test_what_is_left_for_small_delta_is_the_fast_part() -> None:
    """z/sqrt(d) in e_lambda, z sqrt(aS)/sqrt(kappa d) in e_v, of the page's (13)."""
    found = handed(fmpq(1, 10**6))
    size, z = abs(approximate(found.coefficient)) * 8, approximate(found.z)
    assert 1.0 < approximate(found.radii[6]) / (size * 2 * z) < 1.1
    assert 1.414 < approximate(found.radii[7]) / (size * 2 * z) < 1.55


def test_the_tube_must_reach_the_hand_over() -> None:
    equations, found, series = given_for(fmpq(1, 12))
    with working_bits(BITS):
        with pytest.raises(ValueError, match="ends before"):
            hand_over_set(equations, found, series, arb(-1), fmpq(3))
        larger = DeviationEquations(equations.trajectory, fmpq(1, 11))
        with pytest.raises(ValueError, match="ends before"):
            hand_over_set(larger, found, series, arb(-1), FAR)
