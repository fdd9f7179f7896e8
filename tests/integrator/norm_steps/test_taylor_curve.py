"""The polynomial of a step: near the solution, exact on its grid, no longer than what is left."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.functions.expressions import Constant, Exponential, Sine, Variable
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.integrator.norm_steps import taylor_curve
from gspot_verified.integrator.norm_steps.taylor_curve import TaylorCurve, cauchy_plan, rounded
from gspot_verified.numbers.balls import working_bits

x, y = Variable(0), Variable(1)
OSCILLATOR = VectorField([y, -x])


@pytest.mark.parametrize("bits", [96, 192])
@pytest.mark.parametrize("rate", [fmpq(1), fmpq(1000), fmpq(1, 1000)])
def test_a_step_follows_the_solution(bits: int, rate: fmpq) -> None:
    """x = cos(rate t): the length is found for any rate, its last terms are rounding errors, and it is not short."""
    factor = Constant(rate)
    with working_bits(bits):
        curve = TaylorCurve(VectorField([factor * y, -(factor * x)]))
        lengths = []
        for _ in range(14):
            h, polynomials = curve.advance([arb(1), arb(0)], None, 0)
            lengths.append(float(h.mid()) * float(rate.p) / float(rate.q))
            assert curve.length == float(h.mid())
        assert all(p.degree() <= curve.order for p in polynomials)
        assert polynomials[0](arb(0)) == 1
        assert polynomials[1](arb(0)) == 0
        assert 1 < lengths[-1] < bits
        assert lengths[-1] < 1.1 * lengths[-2] < 1.3 * lengths[-1]
        angle = h * rate
        for tau in (arb(0.5), arb(1)):
            for p, value in zip(polynomials, ((tau * angle).cos(), -(tau * angle).sin()), strict=True):
                assert abs(p(tau) - value) < arb(2) ** (52 - bits)


def test_coefficients_are_made_once_where_lengths_grow_slowly(monkeypatch: pytest.MonkeyPatch) -> None:
    """p' = -p u, u' = -u: each step is up to a third longer than the one before, as a motion comes to rest."""
    with working_bits(192):
        curve = TaylorCurve(VectorField([-(x * y), -y]))
        made, lengths, state = 0, list[float](), [arb(1), arb(1)]
        coefficients = curve._recurrence.coefficients

        def counted(*given: Any) -> Any:
            nonlocal made
            made += 1
            return coefficients(*given)

        for _ in range(4):
            curve.advance(state, None, 0)
        monkeypatch.setattr(curve._recurrence, "coefficients", counted)
        for _ in range(8):
            h, polynomials = curve.advance(state, None, 0)
            state = [p(arb(1)).mid() for p in polynomials]
            lengths.append(float(h.mid()))
    assert all(before < after < 4 * before / 3 for before, after in pairwise(lengths[1:]))
    assert made == len(lengths)


def test_the_terms_of_a_step_are_not_much_larger_than_the_state() -> None:
    """At 700 bits the tail alone would allow steps of 18 with terms of 18^18/18! = 2^22: the sum would lose as many."""
    with working_bits(700):
        curve = TaylorCurve(OSCILLATOR)
        for _ in range(6):
            h, polynomials = curve.advance([arb(1), arb(0)], None, 0)
        assert 4 < h < 12
        for p in polynomials:
            assert all(abs(c) < 16 * h for c in p.coeffs())


def test_a_halved_step_and_one_that_is_left() -> None:
    with working_bits(96):
        curve = TaylorCurve(OSCILLATOR)
        for _ in range(10):
            h, _ = curve.advance([arb(1), arb(0)], None, 0)
        for halving in (1, 2, 3):
            half, _ = curve.advance([arb(1), arb(0)], None, halving)
            assert half < 0.51 * h
            assert half > 0.49 * h
            h = half
        for left in (4 * h, arb(3) * h, arb("2.01") * h):
            curve.length = 2 * float(h.mid())
            assert curve.advance([arb(1), arb(0)], left, 1)[0] == h
        curve.length = 2 * float(h.mid())
        left = arb("1.2") * h
        found, _ = curve.advance([arb(1), arb(0)], left, 1)
        assert 0.49 * left < found < 0.51 * left
        curve.length = 2 * float(h.mid())
        left = h / 2
        found, polynomials = curve.advance([arb(1), arb(0)], left, 1)
        assert found is left
        assert abs(polynomials[0](arb(1)) - left.cos()) < arb(2) ** -50


def test_the_grid_of_exact_states() -> None:
    """As many bits after the point as the largest component leaves, less 32 for rounding errors."""
    with working_bits(128):
        curve = TaylorCurve(OSCILLATOR)
        assert curve.order == 38
        assert curve.fraction_bits([arb(1), arb(0.25)]) == 96
        assert curve.fraction_bits([arb(0), arb(5)]) == 93
        assert curve.fraction_bits([arb(2) ** -40]) == 96
        state = [arb(1) / 3, arb(5, 1) / 7]
        exact = curve.exact(state)
        for value, one in zip(state, exact, strict=True):
            assert one.is_exact()
            assert (one * arb(2) ** 96).is_integer()
            assert abs(one - value.mid()) < arb(2) ** -95
    with working_bits(33):
        assert TaylorCurve(OSCILLATOR).order == 8


@pytest.mark.parametrize("length", [1.0, 0.3, 1e-9, 777.7, 2.0**-60])
def test_rounded_lengths_have_eight_bits(length: float) -> None:
    mantissa, _ = math.frexp(rounded(length))
    assert (mantissa * 2**8).is_integer()
    assert length * (1 - 2.0**-7) < rounded(length) <= length


def test_the_plan_for_what_series_leave_out() -> None:
    """Of a polynomial field the series ends; else the disc and length leave less than the last of the 96 - 32 bits of a
    coefficient, and not many terms more than that needs."""
    with working_bits(96):
        _, polynomials = TaylorCurve(OSCILLATOR).advance([arb(1), arb(0)], None, 0)
        degree = max(p.degree() for p in polynomials)
        assert cauchy_plan(OSCILLATOR, polynomials, arb(1)) == (2, degree + 1)
        square = VectorField([x * x])
        _, polynomials = TaylorCurve(square).advance([arb(1)], None, 0)
        assert cauchy_plan(square, polynomials, arb(1)) == (2, 2 * polynomials[0].degree() + 1)
        entire = VectorField([Exponential(-x)])
        curve = TaylorCurve(entire)
        for _ in range(6):
            h, polynomials = curve.advance([arb(1)], None, 0)
        for step in (h, h * arb(2) ** 60):
            disc, length = cauchy_plan(entire, polynomials, step)
            assert disc in (2, 3, 4, 5, 6, 8)
            assert polynomials[0].degree() < length < 200
            start, *rest = polynomials[0].coeffs()
            reach = sum((abs(c) * arb(disc) ** (k + 1) for k, c in enumerate(rest)), arb(0))
            left_out = step * (-(start - reach)).exp() * arb(disc) ** (1 - length)
            assert arb(2) ** -80 < left_out < arb(2) ** -64


def test_rounding_errors_that_a_stiff_spring_enlarges_do_not_shorten_the_steps() -> None:
    """x' = e v, v' = -k (sin x - sin y), y' = e w, w' = -v', y near x: errors of the last bit times k stand in all late
    terms whatever the length, so a length that aimed them below their level became shorter from step to step."""
    slow = Constant(fmpq(1, 10**7))
    pull = Constant(fmpq(10**8)) * (Sine(x) - Sine(y))
    with working_bits(192):
        curve = TaylorCurve(VectorField([slow * Variable(2), slow * Variable(3), -pull, pull]))
        state = [arb(fmpq(4, 10)), arb(fmpq(4, 10) + fmpq(1, 10**13)), arb(fmpq(1, 2)), arb(fmpq(1, 3))]
        lengths = []
        for _ in range(12):
            h, solution = curve.advance(state, None, 0)
            lengths.append(float(h.mid()))
            state = [p(arb(1)).mid() for p in solution]
    assert lengths[-1] > 0.8 * lengths[3]
    assert lengths[-1] > 0.05


@pytest.mark.parametrize(
    ("sizes", "noise"),
    [
        ([160 - 5 * k for k in range(30)], 10),  # a series that decays to its end
        ([160 - 5 * k for k in range(28)] + [17, 16] * 18, 18),  # errors of 17 bits
        ([160 - 5 * k for k in range(30)] + [8, 3] * 17, 10),
        ([160] * 64, 10),  # the series of a step as long as the radius
        ([160, 158, *range(150, 138, -1), *[139] * 40], 10),
    ],
)
def test_which_terms_are_rounding_errors(sizes: list[int], noise: int) -> None:
    assert taylor_curve._noise(sizes) == noise
