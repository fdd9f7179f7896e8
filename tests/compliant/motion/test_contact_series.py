"""The motion from any state by power series: against exact polynomials, an independent integration, and its own laws.

Page: proofs/contact_series.md.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import ends, holds, to_fmpq
from witnesses.contact import moved
from witnesses.slow_solution import on_the_slow_manifold
from witnesses.theta import contains_witness, to_fraction

from gspot_verified.compliant.model.normal_form import Deviation, compliant_model, compliant_state, deviation
from gspot_verified.compliant.motion.compliant_force import SlowMotions
from gspot_verified.compliant.motion.compliant_force import force as compliant_force
from gspot_verified.compliant.motion.contact_series import (
    MAX_WORK,
    _cell,
    _is_rate,
    _rest,
    carried,
    series_cells,
    series_rate,
    series_work,
)
from gspot_verified.numbers.balls import relative_bits, working_bits

NAMES = ("b", "force", "V", "Z")
STATE = Deviation(fmpq(5, 2), fmpq(1, 10), fmpq(-1, 4), fmpq(1), fmpq(-2), fmpq(3), fmpq(1, 2))
STARTS = [
    STATE,
    replace(STATE, p=fmpq(0)),
    replace(STATE, beta=fmpq(1, 2), epsilon=fmpq(3), p=fmpq(-7)),
    replace(STATE, epsilon=fmpq(1, 10**6), p=fmpq(-1, 2)),
    replace(STATE, p=fmpq(1, 2)),
]


def number(value: fmpq) -> mpmath.mpf:
    return mpmath.mpf(int(value.p)) / int(value.q)


def by_odefun(state: Deviation, duration: fmpq) -> dict[str, Fraction]:
    """The contact equations as they stand, integrated by mpmath's Taylor method."""
    with mpmath.workdps(40):
        epsilon, beta, p = number(state.epsilon), number(state.beta), number(state.p)

        def slope(s, x):
            b, V, Y, Z = x
            force = Z - Y
            return [epsilon * beta * force, b + (p - epsilon * s) * force, V, -Z - force]

        start = [number(value) for value in (state.b, state.V, state.Y, state.Z)]
        b, V, Y, Z = mpmath.odefun(slope, 0, start, tol=mpmath.mpf(10) ** -32)(number(duration))
        return {name: to_fraction(value) for name, value in zip(NAMES, (b, Z - Y, V, Z), strict=True)}


@pytest.mark.parametrize("state", STARTS)
@pytest.mark.parametrize("duration", [fmpq(1, 3), fmpq(4)])
def test_an_independent_integration(state: Deviation, duration: fmpq) -> None:
    expected = by_odefun(state, duration)
    found = carried(state, duration, 80)
    for name in NAMES:
        assert relative_bits(found[name]) > 60, name
        assert contains_witness(found[name], expected[name], 25), name


@pytest.mark.parametrize("beta", [2, 3, 4, 7])
@pytest.mark.parametrize("place", [Fraction(0), Fraction(-1, 8), Fraction(1, 8)])
def test_the_polynomial_solutions_exactly(beta: int, place: Fraction) -> None:
    epsilon = Fraction(1, 20)
    first = on_the_slow_manifold(beta, epsilon, place)
    for later in (Fraction(1, 100), Fraction(1), Fraction(6)):
        expected = on_the_slow_manifold(beta, epsilon, place - epsilon * later)
        found = carried(first, to_fmpq(later), 100)
        for name in NAMES:
            value = getattr(expected, name)
            assert found[name].is_finite()
            assert holds(found[name], Fraction(int(value.p), int(value.q))), (name, later)
            with working_bits(200):
                assert abs(found[name] - value) < arb(2) ** -60 * (1 + abs(arb(value)))


numbers = st.fractions(-3, 3, max_denominator=20)


@settings(max_examples=25)
@given(*(numbers,) * 9, st.fractions(0, 5, max_denominator=7))
def test_linear_in_the_state(factor, p, b1, b2, V1, V2, Y1, Y2, Z, duration) -> None:
    def at(b, V, Y, z):
        state = replace(STATE, p=to_fmpq(p), b=to_fmpq(b), V=to_fmpq(V), Y=to_fmpq(Y), Z=to_fmpq(z))
        return carried(state, to_fmpq(duration), 80)

    one, two = at(b1, V1, Y1, Z), at(b2, V2, Y2, -Z)
    both = at(b1 + factor * b2, V1 + factor * V2, Y1 + factor * Y2, Z - factor * Z)
    for name in NAMES:
        with working_bits(200):
            rest = both[name] - one[name] - to_fmpq(factor) * two[name]
            assert rest.contains(0)
            assert abs(rest) < arb(2) ** -30


@pytest.mark.parametrize("state", STARTS)
def test_a_later_state_of_the_same_motion_gives_the_same_motion(state: Deviation) -> None:
    early, late = fmpq(3, 2), fmpq(5, 2)
    there, final = carried(state, early, 200), carried(state, early + late, 200)
    middles = {}
    for name in NAMES:
        lower, upper = ends(there[name])
        middles[name] = to_fmpq((lower + upper) / 2)
    again = replace(
        state,
        p=state.p - state.epsilon * early,
        b=middles["b"],
        V=middles["V"],
        Y=middles["Z"] - middles["force"],
        Z=middles["Z"],
    )
    found = carried(again, late, 200)
    for name in NAMES:
        with working_bits(300):
            assert found[name].is_finite()
            assert abs(found[name] - final[name]) < arb(2) ** -120


@pytest.mark.parametrize("number_of_terms", [8, 12, 20])
@pytest.mark.parametrize("state", STARTS)
def test_the_rest_of_a_cell_bounds_what_the_terms_leave_out(
    state: Deviation, number_of_terms: int, monkeypatch
) -> None:
    monkeypatch.setattr("gspot_verified.compliant.motion.contact_series._terms", lambda *_: number_of_terms)
    with working_bits(200):
        values = [arb(value) for value in (state.b, state.V, state.Y, state.Z)]
        h = fmpq(1, 2)
        cell = _cell(state, values, fmpq(0), h, series_rate(state, h), 200)
    assert cell.variables[2].degree() <= number_of_terms
    for x in (fmpq(1, 3), fmpq(1)):
        exact = carried_exactly(state, h * x)
        with working_bits(200):
            for poly, rest, value in zip(cell.variables, cell.rests, exact, strict=True):
                assert rest.is_finite()
                assert abs(poly(arb(x)) - value) <= rest


def carried_exactly(state: Deviation, duration: fmpq) -> list[arb]:
    with mpmath.workdps(60), working_bits(200):
        start = [number(value) for value in (state.b, state.V, state.Y, state.Z)]
        found, _ = moved(start, *(number(v) for v in (state.p, state.beta, state.epsilon, duration)), steps=4)
        return [arb(to_fmpq(to_fraction(value))) for value in found]


def test_the_remainder_is_that_of_the_page() -> None:
    # m is the largest of |b|/(1/2), |V|/3, |Y|, |Z| over the last two rows; theta = 1/4: 2 m theta/(1 - theta) = 2m/3.
    weights = (fmpq(1, 2), fmpq(3), fmpq(1), fmpq(1))
    zeros, nines, peaks = [arb(0)] * 4, [arb(9)] * 4, [arb(-1), arb(6), arb(2), arb(-2)]
    with working_bits(100):
        for k in range(4):
            peak = [peaks[k] if j == k else arb(0) for j in range(4)]
            for rows in ([nines, peak, zeros], [nines, zeros, peak]):
                found = _rest(rows, weights, fmpq(1, 4))
                assert abs(found - fmpq(4, 3)) < arb(2) ** -25
                assert found.upper() >= fmpq(4, 3)
    assert not _rest(rows, weights, fmpq(1)).is_finite()


def test_the_rate_satisfies_the_three_hypotheses_at_both_ends() -> None:
    for state in [*STARTS, replace(STATE, epsilon=fmpq(10**6), beta=fmpq(100)), replace(STATE, p=fmpq(-1000))]:
        for duration in (fmpq(0), fmpq(1), fmpq(1000)):
            rate = series_rate(state, duration)
            assert rate >= 3
            assert rate**2 >= 4 * abs(state.p)
            assert rate**2 >= 4 * abs(state.p - state.epsilon * duration)
            assert rate**3 >= 4 * state.epsilon * state.beta


def test_a_cell_answers_on_itself_only() -> None:
    (cell,) = series_cells(STATE, fmpq(1), 1, 60)
    assert cell.at(arb(0))[2].contains(3)
    for x in (arb(-1), arb(2), arb(1, 1)):
        assert not any(value.is_finite() for value in cell.at(x))


@pytest.mark.parametrize(("beta", "epsilon"), [("3/2", "1/10"), ("1/2", "1"), ("13/2", "1/40"), ("5/2", "1/1000")])
def test_the_series_agrees_with_the_exact_coefficients(beta: str, epsilon: str) -> None:
    """p > 0: the contour integrals of the fast part and the series share no formula."""
    model = compliant_model(beta, epsilon)
    small = model.epsilon
    state = compliant_state("1/2", "-2/3", small**2 * fmpq(-5, 2), small / 7, -(small**2))
    hats = deviation(model, state)
    for duration in (fmpq(1), fmpq(12)):
        found = compliant_force(model, state, -state.p + small * duration, digits=16)
        assert found.reached
        assert not found.by_series
        series = carried(hats, duration, 80)
        with working_bits(200):
            force = series["force"] + model.mean_force
            assert relative_bits(force) > 60
            assert found.force.overlaps(force)
            assert found.z.overlaps(small**2 * (series["Z"] - model.mean_force))
            assert found.v.overlaps(small * series["V"])


@pytest.mark.parametrize("p", ["0", "-1/10", "-2"])
def test_the_force_from_a_state_at_or_after_the_g_spot(p: str) -> None:
    model = compliant_model(alpha_1=-2, alpha_2="-1/3", alpha_3=-3, epsilon="1/50")
    small = model.epsilon
    state = compliant_state(p, "-1/3", -2 * small**2, small / 7, -(small**2))
    start = state.p / model.alpha_1
    first = compliant_force(model, state, start, digits=30)
    assert first.reached
    assert first.by_series
    assert first.force.contains(1)
    assert holds(first.y, Fraction(str(state.y)))
    found = compliant_force(model, state, start + fmpq(1, 20), digits=20)
    assert found.reached
    # |alpha_1| = 2: T = |alpha_1| t/(epsilon |alpha_1|), and the force of the paper is 4 times that of the normal form.
    expected = by_odefun(deviation(model, state), fmpq(1, 20) / small)
    force = 4 * expected["force"] + Fraction(str(model.mean_force))
    assert contains_witness(found.force, force, 18)
    assert str(found).splitlines()[1] == "  by the power series about the initial state"
    assert found.to_json()["slow"] is None


def test_a_slow_motion_met_after_the_g_spot_goes_on() -> None:
    model = compliant_model("5/2", "1/20")
    there = compliant_force(model, SlowMotions(fmpq(2)), "1/10", digits=60)
    middles = {}
    for name in "byvz":
        lower, upper = ends(getattr(there, name))
        middles[name] = to_fmpq((lower + upper) / 2)
    state = compliant_state("-1/10", **middles)
    later = compliant_force(model, state, "3/10", digits=20)
    expected = compliant_force(model, SlowMotions(fmpq(2)), "3/10", digits=20)
    assert later.by_series
    assert not expected.by_series
    with working_bits(200):
        assert abs(later.force - expected.force) < arb(10) ** -18 * abs(expected.force)


def test_beyond_the_reach_the_message_says_so() -> None:
    model = compliant_model("5/2", "1e-6")
    small = model.epsilon
    state = compliant_state(0, 1, -(small**2), 0, small**2)
    with pytest.raises(ValueError, match="t: 1 is too long after an initial state with p <= 0"):
        compliant_force(model, state, 1)
    assert series_work(deviation(model, state), fmpq(3000)) < MAX_WORK


@pytest.mark.parametrize(
    ("rate", "size", "product", "holds"),
    [
        (fmpq(3), fmpq(0), fmpq(1), True),
        (fmpq(299, 100), fmpq(0), fmpq(1), False),
        (fmpq(4), fmpq(4), fmpq(1), True),
        (fmpq(4), fmpq(4001, 1000), fmpq(1), False),
        (fmpq(4), fmpq(0), fmpq(16), True),
        (fmpq(4), fmpq(0), fmpq(16001, 1000), False),
    ],
)
def test_each_hypothesis_of_the_rate(rate: fmpq, size: fmpq, product: fmpq, holds: bool) -> None:
    """L >= 3, L^2 >= 4 |p| and L^3 >= 4 epsilon beta, at equality and next to it."""
    state = Deviation(product * 2, fmpq(1, 2), fmpq(0), fmpq(1), fmpq(1), fmpq(1), fmpq(1))
    assert _is_rate(rate, size, state) is holds


def test_the_rest_of_each_variable_has_its_weight() -> None:
    """2 epsilon beta R/L, L R, R, R; and each holds what a longer series adds, at the end of the cell."""
    state = Deviation(fmpq(5), fmpq(1, 3), fmpq(1, 2), fmpq(1), fmpq(-2), fmpq(3), fmpq(1, 2))
    with working_bits(200):
        values = [arb(value) for value in (state.b, state.V, state.Y, state.Z)]
        few, many = (_cell(state, values, fmpq(0), fmpq(1, 4), fmpq(3), bits) for bits in (1, 150))
        b, V, Y, Z = few.rests
        for ratio, weight in ((b / Y, fmpq(10, 9)), (V / Y, fmpq(3)), (Z / Y, fmpq(1))):
            assert abs(ratio - weight) < 1e-7
        for short, long, rest in zip(few.variables, many.variables, few.rests, strict=True):
            assert 0 < rest < 10
            assert abs(long(arb(1)) - short(arb(1))) < rest


def test_a_time_before_the_state_has_no_values() -> None:
    assert not any(value.is_finite() for value in carried(STATE, fmpq(-1, 10), 60).values())
