"""The fast solutions and their coefficients: the steps of proofs/fast_part.md, bounds above true values for all smaller
epsilon and all times they are for."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import mpmath
import pytest
from flint import acb, arb, fmpq
from hypothesis import example, given
from hypothesis import strategies as st
from samples.strategies import ends, to_fmpq
from witnesses.theta import contains_witness, to_fraction

from gspot_verified.compliant.fast import fast_part as fast_part_module
from gspot_verified.compliant.fast.decaying_coefficient import decaying_coefficient, real_saddle
from gspot_verified.compliant.fast.fast_coefficient import fast_coefficient, saddle
from gspot_verified.compliant.fast.fast_coefficient_bound import (
    decaying_coefficient_bound,
    oscillating_coefficient_bound,
    state_weight,
    unit_weight,
)
from gspot_verified.compliant.fast.fast_part import fast_bound_at, fast_part
from gspot_verified.compliant.fast.fast_path_bound import NAMES, decaying_bounds, oscillating_bounds
from gspot_verified.compliant.fast.fast_solutions import decaying, oscillating
from gspot_verified.compliant.fast.late_bound import late_bounds
from gspot_verified.compliant.fast.modulus_sum import PathPiece, modulus_sum
from gspot_verified.compliant.model.kernel import kernel
from gspot_verified.compliant.model.normal_form import Deviation
from gspot_verified.numbers.balls import working_bits

STATE = Deviation(fmpq(3, 2), fmpq(1, 100), fmpq(1, 2), fmpq(1), fmpq(-2, 3), fmpq(1, 5), fmpq(2))
SMALLER = (fmpq(1), fmpq(2, 3), fmpq(1, 4))


def number(value: fmpq) -> mpmath.mpf:
    return mpmath.mpf(int(value.p)) / int(value.q)


@pytest.mark.parametrize(("p", "epsilon"), [(fmpq(1, 2), fmpq(1, 5)), (fmpq(0), fmpq(1, 3)), (fmpq(-1), fmpq(1, 2))])
@pytest.mark.parametrize("beta", [fmpq(1, 2), fmpq(3), fmpq(13, 2)])
def test_fast_solutions_by_another_contour(beta: fmpq, p: fmpq, epsilon: fmpq) -> None:
    waves, height = oscillating(beta, epsilon, p, ("b",), 60)
    falls, depth = decaying(beta, epsilon, p, ("b",), 60)
    with mpmath.workdps(40):
        power, small, place = number(beta), number(epsilon), number(p)

        def weight(r, logarithm, log_r):
            cubic = (r - r**2 / 2 - r**3 / 3 - logarithm - place * r) / small
            return mpmath.exp(cubic - (power + 1) * log_r)

        def wave(r):
            return weight(r, mpmath.log(1 + r), mpmath.log(r))

        # Down from i + infinity e^(2 pi i/3) to i, straight to 1, along the axis to infinity.
        far = mpmath.mpc(0, 1) + 10 * mpmath.expjpi(mpmath.mpf(2) / 3)
        value = mpmath.quad(wave, [far, 2j * mpmath.expjpi(mpmath.mpf(1) / 6), 1j, 1, 2, 4, 10])

        def fall(r):
            return weight(r, mpmath.log(-1 - r), mpmath.log(-r))

        middle = mpmath.mpf(-4) / 3
        up = mpmath.quad(fall, [middle, middle + 1j, middle + mpmath.mpc(-2, 4), middle + mpmath.mpc(-6, 10)])
        # Q = -i (-up + conj(up)).
        other = -2 * mpmath.im(up)
        parts = [to_fraction(v) for v in (mpmath.re(value), mpmath.im(value), other)]
    with working_bits(200):
        wave_ball, fall_ball = waves[0] * height.exp(), falls[0] * depth.exp()
    for found, witness in zip((wave_ball.real, wave_ball.imag, fall_ball), parts, strict=True):
        assert contains_witness(found, witness, 12)


def test_any_admissible_corner_serves_and_no_other(monkeypatch: pytest.MonkeyPatch) -> None:
    """The path may bend at any point above the axis from which it goes on to the right of 0, or on the axis there."""
    arguments = fmpq(3, 2), fmpq(1, 5), fmpq(1, 2), ("b", "V"), 60

    def values(corner: acb) -> list[acb]:
        monkeypatch.setattr("gspot_verified.compliant.fast.fast_solutions._corner", lambda *_: corner)
        waves, height = oscillating(*arguments)
        with working_bits(120):
            return [wave * height.exp() for wave in waves]

    first, *others = [values(corner) for corner in (acb(0, 1), acb(fmpq(1, 3)), acb(fmpq(1, 2), 2), acb(-1, 1))]
    for other in others:
        for one, two in zip(first, other, strict=True):
            assert one.real.is_finite()
            assert two.real.is_finite()
            assert one.overlaps(two)
    for corner in (acb(-3, 1), acb(-1), acb(0), acb(1, -1), acb(fmpq(-1, 2), fmpq(1, 10))):
        assert not any(value.real.is_finite() or value.imag.is_finite() for value in values(corner))


@pytest.mark.parametrize("p", [fmpq(1, 3), fmpq(-1, 4)])
def test_the_decaying_coefficient_by_its_definition(p: fmpq) -> None:
    state = replace(STATE, p=p, epsilon=fmpq(1, 7))
    with mpmath.workdps(40):
        beta, small, place, b, V, Y, force = (
            number(v) for v in (state.beta, state.epsilon, p, state.b, state.V, state.Y, state.force)
        )

        def integrand(x):
            k = b - x * V + x**2 * (Y + x * force) / (1 - x)
            cubic = (x + x**2 / 2 - x**3 / 3 - place * x) / small
            return x ** (beta - 1) * (x - 1) ** (1 / small) * mpmath.exp(cubic) * k

        value = -beta / (2 * mpmath.pi) * mpmath.quad(integrand, [1, 1.5, 2, 3, 5, 12])
        witness = to_fraction(value)
    assert contains_witness(decaying_coefficient(state, 70), witness, 14)


def test_saddles() -> None:
    with working_bits(100):
        for p in (fmpq(1, 50), fmpq(1, 2), fmpq(40), fmpq(0), fmpq(-3)):
            least = real_saddle(p)
            assert least < -1
            assert (least**3 + 2 * least**2 + p * least + p).contains(0)
            if p > 0:
                top = saddle(p)
                assert top.imag > 0
                assert top.real < 0
                assert abs(2 + least + 2 * top.real) < arb(10) ** -20


@pytest.mark.parametrize("p", [fmpq(1, 10), pytest.param(fmpq(1, 2), marks=pytest.mark.slow), fmpq(3)])
@pytest.mark.parametrize("beta", [fmpq(1, 2), pytest.param(fmpq(5, 2), marks=pytest.mark.slow), fmpq(13, 2)])
def test_bounds_of_the_oscillating_solution(beta: fmpq, p: fmpq) -> None:
    largest = p * p / 10
    with working_bits(64):
        bounds = oscillating_bounds(arb(beta), p, arb(largest))
    for factor in SMALLER:
        epsilon = largest * factor
        for later in (p, p * 9 / 10, p / 2, p / 20):
            waves, height = oscillating(beta, epsilon, later, NAMES, 30)
            with working_bits(100):
                top = saddle(p)
                first = ((top * (1 - p - top / 2 - top * top / 3) - (1 + top).log()) / arb(epsilon)).real
                front = [arb(1), *[arb(epsilon * beta)] * 3]
                sizes = [abs(wave) * (height - first).exp() * f for wave, f in zip(waves, front, strict=True)]
            for name, bound, size in zip(NAMES, bounds, sizes, strict=True):
                assert size.is_finite()
                assert size < bound, name


def test_the_bound_of_the_oscillating_solution_is_near_it() -> None:
    beta, p, epsilon = fmpq(5, 2), fmpq(2), fmpq(1, 100)
    waves, height = oscillating(beta, epsilon, p, ("b",), 30)
    with working_bits(100):
        top = saddle(p)
        first = ((top * (1 - p - top / 2 - top * top / 3) - (1 + top).log()) / arb(epsilon)).real
        assert oscillating_bounds(arb(beta), p, arb(epsilon))[0] < fmpq(5, 4) * abs(waves[0]) * (height - first).exp()


@pytest.mark.parametrize("beta", [fmpq(1, 2), fmpq(5, 2)])
def test_bounds_of_the_decaying_solution(beta: fmpq) -> None:
    p, largest = fmpq(1, 2), fmpq(1, 10)
    with working_bits(64):
        bounds = decaying_bounds(arb(beta), p, arb(largest))
    for factor in SMALLER:
        epsilon = largest * factor
        for later in (p, fmpq(49, 100), fmpq(0), fmpq(-1, 3)):
            falls, height = decaying(beta, epsilon, later, NAMES, 30)
            with working_bits(100):
                corner = -real_saddle(p)
                first = -((corner - 1).log() + corner * (1 - p + corner / 2 - corner * corner / 3)) / epsilon
                drop = corner * (p - later) / epsilon
                front = [arb(1), *[arb(epsilon * beta)] * 3]
                for fall, f, bound in zip(falls, front, bounds, strict=True):
                    size = abs(fall) * (height - first + drop).exp() * f
                    assert size.is_finite()
                    assert size < bound
                    assert later != p or bound < 5 * size


@pytest.mark.parametrize("beta", [fmpq(1, 2), fmpq(5, 2), fmpq(13, 2)])
def test_bounds_of_the_coefficients(beta: fmpq) -> None:
    state = replace(STATE, beta=beta)
    with working_bits(64):
        weight, small = state_weight(kernel(state)), arb(state.epsilon)
        first = oscillating_coefficient_bound(weight, state.p, small)
        second = decaying_coefficient_bound(weight, state.p, small)
    for factor in SMALLER:
        smaller = replace(state, epsilon=state.epsilon * factor)
        fast, steady = fast_coefficient(smaller, 40), decaying_coefficient(smaller, 40)
        with working_bits(100):
            data, top, corner = kernel(smaller), saddle(state.p), -real_saddle(state.p)
            wave = data.exponent(top, (1 + top).log()).real
            fall = data.exponent(acb(-corner), acb((corner - 1).log())).real
            front = arb(2) * arb.pi() / beta
            for bound, size in ((first, abs(fast) * (-wave).exp()), (second, abs(steady) * (-fall).exp())):
                assert size.is_finite()
                assert size * front < bound
                assert factor < 1 or bound < 4 * size * front


@pytest.mark.parametrize("beta", [fmpq(1, 2), fmpq(3), fmpq(13, 2)])
@pytest.mark.parametrize("epsilon", [fmpq(2), fmpq(1, 100), fmpq(1, 5000)])
def test_bounds_after_the_g_spot(beta: fmpq, epsilon: fmpq) -> None:
    for p in (fmpq(0), fmpq(-1, 1000), fmpq(-1, 20)):
        waves, height = oscillating(beta, epsilon, p, NAMES, 30)
        with working_bits(64):
            bounds = late_bounds(beta, epsilon, -p / epsilon)
            front = [arb(1), *[arb(epsilon * beta)] * 3]
            for wave, f, bound in zip(waves, front, bounds, strict=True):
                size = abs(wave) * height.exp() * f
                assert size.is_finite()
                assert size < bound
    assert not late_bounds(beta, epsilon, fmpq(-1))[0].is_finite()


def test_a_path_that_rises_above_its_saddle_has_no_bound() -> None:
    def piece(curvature, height) -> PathPiece:
        return PathPiece(arb(1), lambda x: acb(height(x)), lambda x: acb(2 * x), lambda _: [arb(1)], curvature)

    with working_bits(64):
        assert not modulus_sum(piece(None, lambda x: x * x), arb(0), arb(1))[0].is_finite()
        assert modulus_sum(piece(None, lambda x: x * x), arb(2), arb(1))[0] < 1
        falling = PathPiece(arb(1), lambda x: acb(-x * x), lambda x: acb(-2 * x), lambda _: [arb(1)], lambda _: acb(-2))
        total = modulus_sum(falling, arb(0), arb(1))[0]
        assert total > arb(fmpq(7468, 10000))
        assert total < arb(fmpq(19, 25))
        flat = replace(falling, curvature=None)
        assert not modulus_sum(flat, arb(0), arb(1))[0].is_finite()


@pytest.mark.parametrize("p", [fmpq(1, 2), fmpq(2, 5), fmpq(1, 10), fmpq(0), fmpq(-1, 10)])
def test_the_fast_part_is_below_its_bound(p: fmpq) -> None:
    values, bounds = fast_part(STATE, p, NAMES, 40), fast_bound_at(STATE, p)
    for name in NAMES:
        assert values[name].is_finite()
        assert abs(values[name]) < bounds[name]


def _height(p: fmpq) -> mpmath.mpf:
    """Re g_p(r_+), by mpmath's own roots."""
    place = number(p)
    top = next(r for r in mpmath.polyroots([1, 2, place, place], maxsteps=200, extraprec=300) if r.imag > 0)
    return mpmath.re(top * (1 - place - top / 2 - top**2 / 3) - mpmath.log(1 + top))


@pytest.mark.parametrize("p", [fmpq(1, 10**6), fmpq(1, 50), fmpq(1, 2), fmpq(5, 2), fmpq(40)])
def test_the_height_of_the_saddle(p: fmpq) -> None:
    with mpmath.workdps(40), working_bits(120):
        assert contains_witness(fast_part_module._height(p), to_fraction(_height(p)), 12)


@given(st.fractions(Fraction(1, 10**6), 50, max_denominator=10**6), st.fractions(0, 1, max_denominator=300))
@example(Fraction(17), Fraction(1, 1))
@example(Fraction(1), Fraction(15, 17))
@example(Fraction(1), Fraction(31, 33))
@example(Fraction(1), Fraction(6, 7))
def test_a_level_lies_between_the_time_and_the_first_one(first: Fraction, share: Fraction) -> None:
    start, p = to_fmpq(first), to_fmpq(first * share)
    level = fast_part_module._level(start, p)
    assert p <= level <= start
    assert level - p <= start / 4 or p > start * 3 / 4
    if share < 1:
        assert start - level >= (start - p) / 2 or p <= start * 3 / 4
        assert level < start or p == 0 or p > start * 3 / 4


@pytest.mark.parametrize("paper", [False, True])
@pytest.mark.parametrize("p", [fmpq(1, 2), fmpq(12, 25), fmpq(1, 10), fmpq(0), fmpq(-1, 10)])
def test_the_bound_of_the_fast_part_is_that_of_the_page(p: fmpq, paper: bool) -> None:
    """Section 8: 2 B_c B_P e^(-(G(p_0) - G(p_1))/eps) + B_cQ B_Q e^(-|r_3|(T - T_0)), with 1/(eps beta) but in b.

    The data of the paper's runs: section 9, a factor eps and the weight s^(beta-2)."""
    epsilon = fmpq(1, 50)
    state = replace(STATE, epsilon=epsilon)
    if paper:
        state = replace(state, V=fmpq(0), Y=2 * state.b / state.p, Z=state.b / state.p)
    found = fast_bound_at(state, p)
    first, beta, small = state.p, state.beta, arb(epsilon)
    level = {fmpq(12, 25): first * fmpq(31, 32), fmpq(1, 10): first / 4}.get(p, p)
    with working_bits(64), mpmath.workdps(30):
        weight, front = state_weight(kernel(state)), number(beta) / (2 * mpmath.pi)
        if paper:
            weight = unit_weight(arb(beta))
            front *= number(epsilon) * abs(number(beta) - 1) * abs(number(state.b / first))
        swing = front * _top(oscillating_coefficient_bound(weight, first, small))
        fall = front * _top(decaying_coefficient_bound(weight, first, small))
        corner = min(mpmath.polyroots([1, 2, number(first), number(first)], extraprec=200), key=mpmath.re)
        steady = [fall * _top(bound) for bound in decaying_bounds(arb(beta), first, small)]
        drop = mpmath.exp(mpmath.re(corner) * number(first - max(p, fmpq(0))) / number(epsilon))
        if p > 0:
            swing *= mpmath.exp(-(_height(first) - _height(level)) / number(epsilon))
            waves = [_top(bound) for bound in oscillating_bounds(arb(beta), level, small)]
        else:
            swing *= mpmath.exp(-_height(first) / number(epsilon))
            waves = [_top(bound) for bound in late_bounds(beta, epsilon, -p / epsilon)]
        for name, wave, fallen in zip(NAMES, waves, steady, strict=True):
            page = (2 * swing * wave + fallen * drop) / (1 if name == "b" else number(epsilon * beta))
            assert page * (1 - mpmath.mpf("1e-15")) <= _top(found[name]) <= page * (1 + mpmath.mpf("1e-7"))


def _top(value: arb) -> mpmath.mpf:
    assert value.is_finite()
    upper = ends(value)[1]
    return mpmath.mpf(upper.numerator) / upper.denominator


def test_no_bound_before_the_state_or_after_the_g_spot() -> None:
    assert not fast_bound_at(STATE, fmpq(3, 5))["b"].is_finite()
    assert not fast_bound_at(replace(STATE, p=fmpq(-1)), fmpq(-2))["b"].is_finite()
