"""The bars, the entry and phi of Theorem U2, a second time from proofs/uniform.md in exact fractions.

For a system in which every bar has a value of its own: the extended example with alpha_2 and alpha_3 that vary.
"""

from __future__ import annotations

import functools
from dataclasses import replace
from fractions import Fraction

import mpmath
import pytest
from flint import arb, fmpq
from strategies import ends, to_fmpq, to_fraction

from gspot_verified.balls import working_bits
from gspot_verified.expansion.derivative import plus, times
from gspot_verified.expansion.expressions import Constant, Variable
from gspot_verified.expansion.residual import residual_bounds
from gspot_verified.expansion.trajectory import Trajectory, expand_system
from gspot_verified.testing import extended_example
from gspot_verified.uniform.equations import DeviationEquations
from gspot_verified.uniform.growth import Cone, Entry, Ranges, entry_of, ranges_of
from gspot_verified.uniform.track import Track, track

BITS = 128
DELTA = Fraction(1, 64)
MU = Fraction(3, 2)
CHI = Fraction(3, 4)
SLACK = Fraction(1, 10**7)  # a radius has 30 bits


@functools.cache
def trajectory() -> Trajectory:
    system = extended_example(chi=to_fmpq(CHI))
    x = [Variable(i) for i in range(6)]
    second = plus(Constant(fmpq(-1)), times(Constant(fmpq(2)), x[0]))
    rising = times(Constant(fmpq(3)), x[3])
    third, control = plus(Constant(fmpq(-3, 2)), rising), plus(Constant(fmpq(3, 2)), times(Constant(fmpq(-1)), rising))
    drifts, controls = (*system.F[:5], second), (*system.G[:5], control)
    return expand_system(replace(system, F=drifts, G=controls, alpha_2=second, alpha_3=third), 6)


def entry(place: fmpq = fmpq(2)) -> Entry:
    return Entry(
        1, fmpq(-1), place, arb(1, (1, -3)), arb(2, (1, -3)), arb(2), arb(4), (arb(1),) * 6, arb(1), arb((1, -3))
    )


CONE = Cone(arb((1, -1)), arb(1), arb(4), arb(3), tuple(map(arb, (2, 3, 5, 7, 11, 13))), arb(17), arb(6))


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


@pytest.fixture(scope="module")
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
    drift = {(0, 1): 1, (2, 3): 1, (3, 5): 1, (3, 4): force, (4, 5): CHI, (5, 0): 2, (5, 3): 3 * force}
    for i in range(6):
        for j in range(6):
            assert is_bound(found.drift[i][j], Fraction(drift.get((i, j), 0))), (i, j)
    control = (Fraction(0), Fraction(1), Fraction(0), radii[4], Fraction(0), Fraction(3, 2) + 3 * radii[3])
    assert all(map(is_bound, found.control, control))
    assert all(map(is_bound, found.bend, map(Fraction, (0, 0, 0, 0, 0, CHI))))
    assert all(map(is_bound, found.push, map(Fraction, (2, 0, 0, 3 * force, 0, 0))))
    for ball, middle, radius in (
        (found.alpha_1, Fraction(-1), CHI * radii[5]),
        (found.alpha_3, Fraction(-3, 2), 3 * radii[3]),
        (found.force, mean, wobble),
    ):
        assert is_bound(ball - arb(to_fmpq(middle)), radius)


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

        def finite(one: Entry, cone: Cone = CONE) -> bool:
            return ranges_of(equations, one, to_fmpq(MU), cone) is not None

        assert finite(entry())
        assert finite(entry(fmpq(0)))
        assert not finite(entry(fmpq(-1, 2**20)))
        assert not finite(replace(entry(), Y=arb(1, 1)))
        assert not finite(replace(entry(), V=arb(1, 1)))
        assert not finite(entry(), replace(CONE, a=arb(0)))
        assert not finite(entry(), replace(CONE, a=arb(-1)))
        reached = arb((7, -3)) * arb((1, -9))  # Y_1 delta^mu
        assert not finite(entry(), replace(CONE, top=reached))
        assert finite(entry(), replace(CONE, top=reached * (1 + arb((1, -20)))))


@functools.cache
def followed(sign: int) -> Track:
    with working_bits(BITS):
        equations = DeviationEquations(trajectory(), fmpq(1, 200))
        centre = [arb(0)] * 8 + [arb(sign), arb((sign, -1))]
        return track(equations, fmpq(1), fmpq(0), fmpq(1), centre, [arb((1, -4))] * 10, arb((1, -4)))


@pytest.mark.parametrize("sign", [1, -1])
def test_the_entry_holds_the_deviation_at_the_end_of_its_piece(sign: int) -> None:
    """Y, V, N, q at every corner of the set, for large and small delta."""
    found = followed(sign)
    assert found.is_whole
    piece = found.pieces[-1]
    with working_bits(BITS):
        one = entry_of(found, len(found.pieces) - 1)
    assert one is not None
    assert (one.side, one.begin, one.place) == (-sign, fmpq(0), fmpq(1))
    corners = [ends(value) for value in piece.end_deviations]
    kappa, (p, b, y, v) = Fraction(1, 2), corners[6:]
    for delta in (Fraction(1, 200), Fraction(1, 10**6)):
        hat = sum(
            (to_fraction(value) * delta**n for n, term in enumerate(trajectory().p) for value in term.coefficients()),
            Fraction(0),
        )  # at s = 1
        for e_p in p:
            q = -(hat + delta * e_p)
            assert ends(one.q)[0] <= q <= ends(one.q)[1]
            for e_y, e_b in ((e_y, e_b) for e_y in y for e_b in b):
                N = kappa * q * sign * e_y + sign * e_b
                assert ends(one.N)[0] <= N <= ends(one.N)[1]
    for ball, values in ((one.Y, y), (one.V, v)):
        assert all(ends(ball)[0] <= sign * value <= ends(ball)[1] for value in values)
    for bound, values in zip((*one.state, one.p), corners[:7], strict=True):
        assert all(abs(value) <= ends(bound)[1] for value in values)
    assert one.fast == piece.end_fast
    width = float(ends(one.N)[1] - ends(one.N)[0])
    assert width < 1.1 * float((b[1] - b[0]) + (y[1] - y[0])) + 0.1


def test_a_deviation_without_a_certain_sign_is_no_entry() -> None:
    found = followed(1)
    piece = found.pieces[-1]
    unclear = replace(piece, end_deviations=(*piece.end_deviations[:8], arb(0, 1), piece.end_deviations[9]))
    assert entry_of(replace(found, pieces=(unclear,)), 0) is None
