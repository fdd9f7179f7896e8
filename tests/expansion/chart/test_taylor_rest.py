"""Taylor polynomials by a chart and what they leave (proofs/chart.md, section 2), beside the closed form in mpmath."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import replace

import mpmath
import pytest
from flint import arb, fmpq
from mpmath import mpf

from gspot_verified.expansion.chart import taylor_rest
from gspot_verified.expansion.chart.chart import Chart
from gspot_verified.expansion.chart.cone import Cone
from gspot_verified.expansion.chart.radius import radius
from gspot_verified.expansion.chart.taylor_rest import NoTaylorError, taylor_rests
from gspot_verified.expansion.from_state.analytic import Analytic
from gspot_verified.expansion.from_state.slow_manifold import RING, H, L, R
from gspot_verified.functions.ball_polynomials import constant
from gspot_verified.functions.expressions import Constant, Exponential, Expression, Power, Sine, Variable
from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.g_spot import find_g_spot
from gspot_verified.numbers.balls import ball, working_bits
from tests.expansion.chart.folded import INVERSE, ONE, V, W, X, Y, folded
from tests.expansion.from_state.test_barrier_numbers import in_mpmath, number

P, B = Variable(0), Variable(1)
CONE = Cone(fmpq(0), fmpq(1, 50), fmpq(3), fmpq(1), fmpq(2), fmpq(1))
Value = Callable[..., mpf]
"""Of x, w, y, v."""


def rational(*value: int) -> Expression:
    return Constant(fmpq(*value))


FUNCTIONS: list[tuple[Expression, Value]] = [
    (Exponential(X + W) * rational(2) - rational(3), lambda x, w, *_: 2 * mpmath.exp(x + w) - 3),
    (Sine(W + V) + X * Y - ONE, lambda x, w, y, v: mpmath.sin(w + v) + x * y - 1),
    (rational(-1) * Power(ONE - rational(8) * X, fmpq(-1)) + Y, lambda x, _, y, __: -1 / (1 - 8 * x) + y),
]


def alphas(*functions: Expression) -> Chart:
    first, second, third = functions
    return Chart(folded(first, second, third))


CHART = alphas(*(function for function, _ in FUNCTIONS))


def closed(q: list[mpf]) -> list[mpf]:
    p, b, y, v = q
    x = (1 - mpmath.sqrt(1 - 4 * p)) / 2
    return [x, b / (1 + x), y, v]


@pytest.mark.parametrize("order", [2, 3, 4])
@pytest.mark.parametrize("which", [0, 1, 2])
def test_what_is_left_is_within_the_bound_and_not_far_below(which: int, order: int) -> None:
    function, value = FUNCTIONS[which]
    draw, alpha, closest = random.Random(2), Analytic(function, order, "f", CHART), mpf(0)
    assert alpha.moves
    assert alpha.is_exact
    with mpmath.workdps(40), working_bits(128):
        rest = taylor_rests(CHART, [function], CONE, order)[0]
        assert min(rest) == order
        terms = (constant(RING, alpha.value) + alpha.above((H, R, L, H * R * L**4))).to_dict()
        for _ in range(60):
            p = number(CONE.last) * draw.choice([mpf(1), mpf(1) / 3, mpf(1) / 20])
            force, height, speed = 3 + draw.uniform(-1, 1), 2 * draw.uniform(-1, 1), draw.uniform(-1, 1)
            q = [p, -force * p, height * p**3, speed * p**2]
            total = mpf(0)
            for (i, j, k), c in terms.items():  # v alone makes h r L^4
                times = int(k) // 4
                total += (
                    number(fmpq(c)) * q[0] ** (int(i) - times) * q[1] ** (int(j) - times)
                    * q[2] ** (int(k) % 4) * q[3] ** times
                )  # fmt: skip
            left = abs(value(*closed(q)) - total)
            bound = sum(in_mpmath(size) * p**n for n, size in rest.items())
            assert left <= bound
            closest = max(closest, left / bound)
    assert closest > mpf(1) / 10


def test_every_part_of_the_cone_counts(monkeypatch: pytest.MonkeyPatch) -> None:
    """The bound is one of all parts, so their order does not matter."""
    slabs, parts = Cone.slabs, taylor_rest.covered
    with working_bits(128):
        plain = taylor_rests(CHART, [function for function, _ in FUNCTIONS], CONE, 3)
        monkeypatch.setattr(Cone, "slabs", lambda cone, count: slabs(cone, count)[::-1])
        monkeypatch.setattr(taylor_rest, "covered", lambda chart, cone: (parts(chart, cone) or [])[::-1])
        assert taylor_rests(CHART, [function for function, _ in FUNCTIONS], CONE, 3) == plain


def test_the_polynomial_is_that_of_the_closed_form() -> None:
    """x put in as a function of p: no chart."""
    composed = Exponential(INVERSE + B * Power(ONE + INVERSE, fmpq(-1))) * rational(2) - rational(3)
    place = (R * R, -R * R * L, RING.constant(0), RING.constant(0))
    assert Analytic(FUNCTIONS[0][0], 4, "f", CHART).above(place) == Analytic(composed, 4, "f").above(place)


def test_in_balls_it_holds_the_exact_polynomial() -> None:
    with working_bits(200):
        system = replace(CHART.system, ring=BALLS, point=(arb(0),) * 4)
        chart, place = Chart(system), (R * R, -R * R * L, H**2, H)
        exact = Analytic(FUNCTIONS[1][0], 4, "f", CHART).above(place).to_dict()
        in_balls = Analytic(FUNCTIONS[1][0], 4, "f", chart)
        assert not in_balls.is_exact
        found = in_balls.above(place).to_dict()
        for key, coefficient in exact.items():
            assert ball(found[key]).contains(coefficient)
            assert ball(found[key]).rad() < arb("1e-40")
        for key in found.keys() - exact.keys():
            assert ball(found[key]).contains(0)


def test_a_cone_beyond_a_fold_or_a_pole_is_refused() -> None:
    thin = replace(CONE, beside=fmpq(0), height=fmpq(0), speed=fmpq(0))
    with working_bits(128):
        with pytest.raises(NoTaylorError, match="not certainly coordinates of the state up to p = 3/10"):
            taylor_rests(CHART, [X], replace(thin, last=fmpq(3, 10)), 4)
        taylor_rests(CHART, [FUNCTIONS[2][0]], replace(thin, last=fmpq(1, 20)), 4)
        with pytest.raises(NoTaylorError, match="base that may vanish"):
            taylor_rests(CHART, [FUNCTIONS[2][0]], replace(thin, last=fmpq(23, 200)), 4)  # its pole is p = 7/64


def test_a_dependent_spot_is_refused() -> None:
    same = Chart(replace(CHART.system, b=CHART.system.p))
    with working_bits(128), pytest.raises(NoTaylorError):
        taylor_rests(same, [X], CONE, 4)


def test_the_radius_is_about_that_of_the_nearest_pole() -> None:
    with working_bits(128):
        steep = rational(-3, 2) * Power(ONE - rational(8) * X, fmpq(-1))  # a pole at p = 7/64
        assert 0.08 < radius(alphas(rational(-1) + W, rational(-1), steep)) < 0.15
        oscillator = Chart(find_g_spot(shipped_mechanism("frictional impact oscillator")).system)
        assert 0.02 < radius(oscillator) < 0.05
