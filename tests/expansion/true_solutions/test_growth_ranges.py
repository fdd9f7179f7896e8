"""The bars, the entry and phi of Theorem U2, a second time from proofs/uniform.md in exact fractions.

For a system in which every bar has a value of its own: the extended example with alpha_2 and alpha_3 that vary.
"""

from __future__ import annotations

import functools
from dataclasses import replace
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import mpmath
import pytest
from flint import arb, arb_poly, fmpq
from samples.strategies import ends, to_fmpq, to_fraction
from samples.uniform_systems import varying_example

from gspot_verified.expansion.residual import residual_bounds
from gspot_verified.expansion.trajectory import Trajectory, expand_system
from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.expansion.true_solutions.growth import DeviationCone, EntryDeviation, Ranges, entry_of, ranges_of
from gspot_verified.expansion.true_solutions.track import Track
from gspot_verified.numbers.balls import working_bits

BITS = 128
DELTA = Fraction(1, 64)
MU = Fraction(3, 2)
CHI = Fraction(3, 4)
SLACK = Fraction(1, 10**7)  # a radius has 30 bits


@functools.cache
def trajectory() -> Trajectory:
    return expand_system(varying_example(to_fmpq(CHI)), 6)


START = fmpq(2)


def entry(place: fmpq = START) -> EntryDeviation:
    return EntryDeviation(
        1, fmpq(-1), place, arb(1, (1, -3)), arb(2, (1, -3)), arb(2), arb(4), (arb(1),) * 6, arb(1), arb((1, -3))
    )


CONE = DeviationCone(arb((1, -1)), arb(1), arb(4), arb(3), tuple(map(arb, (2, 3, 5, 7, 11, 13))), arb(17), arb(6))


def norm(name: str, reach: Fraction, first: int = 0) -> Fraction:
    """The sum over monomials of |c| reach^k delta^n, n >= first."""
    return sum(
        (
            abs(to_fraction(value)) * reach**k * DELTA**n
            for n, term in enumerate(trajectory().terms()[name])
            for k, value in enumerate(term.coefficients())
            if n >= first
        ),
        Fraction(0),
    )


def is_bound(value: arb, page: Fraction) -> bool:
    """The largest modulus in the ball is the page's, but for rounding."""
    assert value.is_finite()
    top = max(abs(end) for end in ends(value))
    return page <= top * (1 + SLACK / 10**8) and top <= page * (1 + SLACK) + Fraction(1, 2**100)


@pytest.fixture
def found() -> Ranges:
    with working_bits(BITS):
        equations = DeviationEquations(trajectory(), to_fmpq(DELTA))
        ranges = ranges_of(equations, entry(), to_fmpq(MU), CONE)
    assert ranges is not None
    return ranges


def test_the_last_s_is_when_the_slowest_growth_has_reached_the_end(found: Ranges) -> None:
    with mpmath.workdps(40):
        page = 2 + mpmath.log(6 / (mpmath.mpf("0.875") * mpmath.mpf(1) / 64**1.5)) / mpmath.mpf("0.5")
        last = mpmath.mpf(ends(found.last)[1].numerator) / ends(found.last)[1].denominator
        assert page * (1 - mpmath.mpf("1e-15")) <= last <= page * (1 + mpmath.mpf("1e-12"))


def test_the_bars_are_those_of_the_page(found: Ranges) -> None:
    last = ends(found.last)[1]
    radii = [DELTA**2 * (norm(f"xi_{i + 1}", last) + (2, 3, 5, 7, 11, 13)[i] * 6) for i in range(6)]
    mean = to_fraction(trajectory().lambda_n[0].at_zero())
    wobble = norm("lambda_n", last, 1)
    force = abs(mean) + wobble
    turned = max(abs(5 - 3 * (mean + wobble)), abs(5 - 3 * (mean - wobble)))  # lambda enters with the sign of -alpha_3
    bend = {5: CHI, 3: 2 * radii[3]}
    drift = {(0, 1): 1, (2, 3): 1, (3, 5): 1, (3, 4): force, (4, 5): CHI, (4, 3): bend[3], (5, 0): 2, (5, 3): turned}
    for i in range(6):
        for j in range(6):
            assert is_bound(found.drift[i][j], Fraction(drift.get((i, j), 0))), (i, j)
    control = (Fraction(0), Fraction(1), Fraction(0), radii[4], Fraction(0), Fraction(3, 2) + 3 * radii[3])
    push = map(Fraction, (2, 0, 0, turned, 0, 0))
    for values, pages in (
        (found.control, control),
        (found.bend, (bend.get(j, 0) for j in range(6))),
        (found.push, push),
    ):
        assert all(is_bound(value, Fraction(page)) for value, page in zip(values, pages, strict=True))
    every = [*found.control, *found.bend, *found.push, *(value for row in found.drift for value in row)]
    assert all(ends(value)[0] >= 0 for value in every)  # so that nothing cancels in a sum of them
    for ball, middle, radius in (
        (found.alpha_1, Fraction(-1), CHI * radii[5] + radii[3] ** 2),
        (found.alpha_3, Fraction(-3, 2), 3 * radii[3]),
        (found.force, mean, wobble),
    ):
        assert is_bound(ball - arb(to_fmpq(middle)), radius)


def test_all_terms_of_the_force_but_the_mean_are_in_its_bar() -> None:
    with working_bits(BITS):
        equations = DeviationEquations(trajectory(), to_fmpq(DELTA))
        equations._terms["lambda_n"][1] = arb_poly([fmpq(1, 2)])
        found = ranges_of(equations, entry(), to_fmpq(MU), CONE)
    assert found is not None
    mean = to_fraction(trajectory().lambda_n[0].at_zero())
    assert is_bound(found.force - arb(to_fmpq(mean)), norm("lambda_n", ends(found.last)[1], 1) + DELTA / 2)


@pytest.mark.parametrize("bits", [8, 9, 10, 11, 12])
def test_the_bars_are_rounded_outwards(bits: int) -> None:
    """At a few bits: S is not before the page's, and the ranges hold those for this S."""
    with working_bits(bits):
        equations = DeviationEquations(trajectory(), to_fmpq(DELTA))
        found = ranges_of(equations, entry(), to_fmpq(MU), CONE)
    assert found is not None
    last = ends(found.last)[1]
    with mpmath.workdps(40):
        page = 2 + mpmath.log(6 / (mpmath.mpf("0.875") * mpmath.mpf(1) / 64**1.5)) / mpmath.mpf("0.5")
        assert mpmath.mpf(last.numerator) / last.denominator >= page
    radii = [DELTA**2 * (norm(f"xi_{i + 1}", last) + (2, 3, 5, 7, 11, 13)[i] * 6) for i in range(6)]
    mean, wobble = to_fraction(trajectory().lambda_n[0].at_zero()), norm("lambda_n", last, 1)
    for ball, middle, radius in (
        (found.alpha_1, Fraction(-1), CHI * radii[5]),
        (found.alpha_3, Fraction(-3, 2), 3 * radii[3]),
        (found.force, mean, wobble),
    ):
        assert ends(ball)[0] <= middle - radius
        assert ends(ball)[1] >= middle + radius


def test_the_residuals_are_measured_by_the_deviation(found: Ranges) -> None:
    """eta = delta^(M - mu) rho(S)/V_1; the table of residuals is made for multiples of 1/4."""
    last = ends(found.last)[1]
    levels = [to_fmpq(last), fmpq(-(-last.numerator * 4 // last.denominator), 4)]
    least, most = (residual_bounds(trajectory(), level, to_fmpq(DELTA)).constants for level in levels)
    names = [*(f"xi_{i + 1}" for i in range(6)), "p", "b", "y", "v", "z"]
    factor = mpmath.mpf(64) ** mpmath.mpf("-4.5") / mpmath.mpf("1.875")
    for name, ball in zip(names, [*found.eta, found.eta_z], strict=True):
        top = float(ends(ball)[1])
        low, high = (float(ends(constants[name])[1]) * float(factor) for constants in (least, most))
        assert low * (1 - 1e-12) <= top <= high * (1 + 1e-7)
    assert all(found.eta[i] > 0 for i in (3, 6, 7, 9))
    assert found.eta[8] == 0  # R_y = 0: Y' = V


def test_no_bars_without_their_hypotheses() -> None:
    """|s| <= S holds all s of interest only if s_1 >= 0; Y_1, V_1, a > 0, and Y_max is not reached yet."""
    with working_bits(BITS):
        equations = DeviationEquations(trajectory(), to_fmpq(DELTA))

        def finite(one: EntryDeviation, cone: DeviationCone = CONE) -> bool:
            return ranges_of(equations, one, to_fmpq(MU), cone) is not None

        assert finite(entry())
        assert finite(entry(fmpq(0)))
        assert not finite(entry(fmpq(-1, 2**20)))
        for none in (arb(0), arb(1, 1), arb(-1)):
            assert not finite(replace(entry(), Y=none))
            assert not finite(replace(entry(), V=none))
        assert finite(replace(entry(), V=arb((1, -4))))
        assert not finite(entry(), replace(CONE, A=(*CONE.A[:5], arb("inf"))))
        assert not finite(entry(), replace(CONE, a=arb(0)))
        assert not finite(entry(), replace(CONE, a=arb(-1)))
        reached = arb((7, -3)) * arb((1, -9))  # Y_1 delta^mu
        assert not finite(entry(), replace(CONE, top=reached))
        assert finite(entry(), replace(CONE, top=reached * (1 + arb((1, -20)))))


def ended(sign: int, place: fmpq, e_y: arb, power: int = 2) -> Track:
    """A run whose last piece ends at ``place`` with given deviations: wide, and about no zero; p_1 = 1/2."""
    e = (arb(3, (1, -2)), *[arb(0)] * 4, arb(-5), arb(-7, (1, -3)), arb(2, (1, -4)), e_y, arb(-2 * sign, (1, -3)))
    piece: Any = SimpleNamespace(start=fmpq(-1), end=place, end_deviations=e, end_fast=arb(11))
    first: Any = SimpleNamespace(start=fmpq(-2))
    with working_bits(BITS):
        equations = DeviationEquations(trajectory(), fmpq(1, 4))
        equations._terms["p"][1] = arb_poly([fmpq(1, 2)])
        return Track(equations, fmpq(power), place, (first, piece))


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("place", [fmpq(3, 2), fmpq(4)])
@pytest.mark.parametrize("power", [2, 8])
def test_the_entry_holds_the_deviation_at_the_end_of_its_piece(sign: int, place: fmpq, power: int) -> None:
    """Y, V, N, q at every corner of the set, for every delta up to delta_0; and they are no wider than that."""
    run = ended(sign, place, arb(-4 * sign, (1, -2)), power)
    with working_bits(BITS):
        one = entry_of(run, 1)
    assert one is not None
    assert (one.side, one.begin, one.place, one.fast) == (sign, fmpq(-2), place, arb(11))
    for ball, middle, radius in ((one.Y, 4, Fraction(1, 4)), (one.V, 2, Fraction(1, 8))):
        assert is_bound(ball - middle, radius)
        assert is_bound(ball, middle + radius)
    assert all(map(is_bound, (*one.state, one.p), map(Fraction, (3.25, 0, 0, 0, 0, 5, 7.125))))
    assert all(ends(value)[0] >= 0 for value in (*one.state, one.p))
    s = to_fraction(place)
    places, products = [], []
    for delta in (Fraction(0), Fraction(1, 100), Fraction(1, 8), Fraction(1, 4)):
        hat = sum(
            (
                to_fraction(value) * s**k * delta**n
                for n, term in enumerate(trajectory().p)
                for k, value in enumerate(term.coefficients())
            ),
            delta / 2,
        )
        for e_p in (Fraction(-57, 8), Fraction(-55, 8)):
            q = -(hat + delta**power * e_p)
            places.append(q)
            products += [
                q * Y / 2 - sign * e_b
                for Y in (Fraction(15, 4), Fraction(17, 4))
                for e_b in (Fraction(31, 16), Fraction(33, 16))
            ]
    for ball, values in ((one.q, places), (one.N, products)):
        lower, upper = ends(ball)
        assert min(values) - 5 <= lower <= min(values)
        assert max(values) <= upper <= max(values) + 5


@pytest.mark.parametrize("e_y", [arb(0, 1), arb(1, 1), arb(-1, 1), arb(0)])
def test_a_deviation_without_a_certain_sign_is_no_entry(e_y: arb) -> None:
    assert entry_of(ended(1, fmpq(4), e_y), 1) is None


def test_a_deviation_near_0_has_a_sign() -> None:
    for sign in (1, -1):
        one = entry_of(ended(sign, fmpq(4), arb(-sign, (1, -1)) / 8), 1)
        assert one is not None
        assert one.side == sign
