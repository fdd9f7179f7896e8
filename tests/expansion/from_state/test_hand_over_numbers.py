"""The hand-over of proofs/from_state.md, (12) and (13), by the page's formulas in mpmath: every corner lies in the set,
and the set is no larger than they need."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from itertools import product
from typing import Any

import mpmath
import pytest
from flint import arb, fmpq
from mpmath import mpf

from gspot_verified.expansion.from_state.barrier import Start, Tube
from gspot_verified.expansion.from_state.fast_growth import Rectangle
from gspot_verified.expansion.from_state.hand_over import Beside, HandOver, carried, evaluated, framed, hand_over_set
from gspot_verified.expansion.from_state.passage import model_system
from gspot_verified.expansion.from_state.slow_series import Contact, H, R, SlowSeries, slow_series, terms_of
from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.numbers.balls import hull, working_bits
from gspot_verified.numbers.evidence import less

BETA, A, FAR, DELTA = fmpq(7, 3), fmpq(1, 2), fmpq(9, 2), fmpq(1, 20)
H_1 = fmpq(4, 27)  # (a S^3)^(-1/2): the tube ends where the set is handed over
SPRINGS = Regularisation.of(2, 3, "1/2")
with mpmath.workdps(50):
    KAPPA, LAG = mpf(6) / 5, mpf(9) / 50  # kappa, l/g
SERIES = slow_series(BETA, Contact.of(SPRINGS), 3)
OTHER = replace(SERIES, v=-2 * SERIES.v, f=20 * H)  # any polynomials are right: here f and -v are large
SHARES = (arb("1.25"), arb("1.5"), arb("0.75"))
with mpmath.workdps(50):
    SIZE = (mpf(9) / 4) ** (mpf(4) / 3)  # (a S)^(beta - 1)
ROOT = mpf(3) / 2  # sqrt(a S)


@pytest.fixture(autouse=True)
def _digits() -> Iterator[None]:
    with mpmath.workdps(50), working_bits(160):
        yield


def tube(z: str, h: fmpq = H_1, e: fmpq = A * DELTA**3) -> Tube:
    """A tube with Z = z (h/h_1)^2 and no layer."""
    evidence = less(0, 1)
    assert evidence is not None
    start = Start(fmpq(4, 9), e, arb(0), 1, fmpq(1, 2))
    barrier = {(2, 0): arb(z) / arb(h) ** 2}
    return Tube(start, Rectangle(h, fmpq(2, 3)), fmpq(1), barrier, arb(1), fmpq(1, 5), SHARES, BETA, evidence)


@cache
def equations() -> DeviationEquations:
    with working_bits(160):
        trajectory = expand_system(model_system(-A, fmpq(-3), -A * BETA, SPRINGS), 10)
        return DeviationEquations(trajectory, DELTA)


def handed(z: str, c_1: str, series: SlowSeries = SERIES) -> HandOver:
    return hand_over_set(equations(), tube(z), series, arb(c_1), FAR)


def number(value: fmpq) -> mpf:
    return mpf(int(value.p)) / int(value.q)


def in_mpmath(value: arb) -> mpf:
    mantissa, exponent = value.mid().man_exp()
    return mpf(int(mantissa)) * mpf(2) ** int(exponent)


def ends(value: arb) -> tuple[mpf, mpf]:
    return in_mpmath(value.lower()), in_mpmath(value.upper())


def summed(polynomial: Any, h: mpf, r: mpf) -> mpf:
    return sum((number(c) * h**i * r**n for (i, n), c in terms_of(polynomial).items()), mpf(0))


def corner(
    c: mpf, z: mpf, delta: mpf, signs: tuple[int, int, int], series: SlowSeries = SERIES
) -> tuple[list[mpf], mpf]:
    """(13): e over delta^mu, and phi, for this C(S); |x_1|, |x_2|, |x_3| are as large as z allows."""
    h, r = number(H_1), ROOT * delta
    first, second, third = (sign * in_mpmath(share) * z for sign, share in zip(signs, SHARES, strict=True))
    l = -c * SIZE  # noqa: E741 - the page's name
    v, w, f = (summed(one, h, r) for one in (series.v, series.w, series.f))
    e_b, e_v = -(ROOT**2) * l, l * (v / delta + first * ROOT)
    fast = l * (r**2 * f - LAG * v + (third - LAG * first) * r)
    e_y = (fast - l * (1 + w + second)) / KAPPA
    return [mpf(0), e_b, delta**4 * e_y, delta**2 * e_v, mpf(0), e_b, e_y, e_v], fast + LAG * delta * e_v


@pytest.mark.parametrize("series", [SERIES, OTHER], ids=["the slow part", "any polynomials"])
@pytest.mark.parametrize("c_1", ["-0.75", "0.5"])
def test_every_corner_lies_in_the_set_and_some_at_its_edge(c_1: str, series: SlowSeries) -> None:
    found = handed("0.05", c_1, series)
    z = in_mpmath(found.z)
    assert abs(z - mpf("0.05")) < mpf(10) ** -40
    column = [in_mpmath(found.frame[i, 5]) for i in range(8)]
    assert all(found.frame[i, j] == int(i == j) for i in range(8) for j in range(8) if j != 5)
    radii, reached, fast = [in_mpmath(one) for one in found.radii], [mpf(0)] * 8, mpf(0)
    deltas = [number(DELTA) * share for share in (mpf(1), mpf(1) / 2, mpf(10) ** -9)]
    for c, delta, *signs in product(ends(found.coefficient), deltas, *[(1, -1)] * 3):
        e, f = corner(c, z, delta, (signs[0], signs[1], signs[2]), series)
        share = e[5] / column[5]
        u = [one - share * column[i] if i != 5 else share - 1 for i, one in enumerate(e)]
        reached = [max(old, abs(one)) for old, one in zip(reached, u, strict=True)]
        fast = max(fast, abs(f))
    assert [int(one.is_exact()) for one in found.radii] == [1] * 8
    assert [in_mpmath(one) for one in found.centre] == [0, 0, 0, 0, 0, 1, 0, 0]
    most = mpf("1.02" if series is SERIES else "1.05")
    for i in range(8):
        assert reached[i] <= radii[i] + mpf(10) ** -40
        assert radii[i] <= most * reached[i] + mpf(10) ** -40
    assert found.fast.is_exact()
    assert fast <= in_mpmath(found.fast) <= most * fast
    assert all(radii[i] < part * abs(column[i]) for i, part in ((5, 0.03), (6, 0.2), (7, 0.5)))


@pytest.mark.parametrize("c_1", ["-0.7", "0.3", "-0.55", "0.9"])
def test_with_few_bits_the_slow_vector_lies_in_the_set_too(c_1: str) -> None:
    """Without a fast part little but the rounding of the frame is left."""
    with working_bits(24):
        found = handed("0", c_1)
    column = [in_mpmath(found.frame[i, 5]) for i in range(8)]
    for c in ends(found.coefficient):
        for delta in (number(DELTA), mpf(10) ** -9):
            e, fast = corner(c, mpf(0), delta, (1, 1, 1))
            for i, radius in enumerate(found.radii):
                u = e[5] / column[5] - 1 if i == 5 else e[i] - e[5] / column[5] * column[i]
                assert abs(u) <= in_mpmath(radius) + mpf(10) ** -40
            assert abs(fast) <= in_mpmath(found.fast)


def test_with_few_bits_the_start_is_not_lost() -> None:
    """w = h from h_1 = e_0/p_1^(3/2) to h = 0: log C_1 moves by 2 beta h_1/3."""
    series = replace(SERIES, w=H)
    for k in range(3, 20):
        start = replace(tube("0").start, p=fmpq(k, 7), e=fmpq(1, 5 * k))
        one = replace(tube("0"), barrier={}, start=start, rate=arb(-(10**4)))
        with working_bits(8):
            found = carried(one, series, arb(0), arb("0.0625"))
        moved = 2 * number(BETA) / 3 * number(start.e) / number(start.p) ** mpf("1.5")
        assert ends(found)[0] <= 0 < moved <= ends(found)[1]


def test_the_coefficient_is_carried_to_the_hand_over() -> None:
    moved = carried(tube("0.05"), SERIES, arb(H_1), hull([arb(0), arb(fmpq(3, 40))]))
    for c_1 in ("-0.75", "0.5"):
        for one, other in zip(ends(handed("0.05", c_1).coefficient / arb(c_1)), ends(moved), strict=True):
            assert abs(one - mpmath.exp(other)) < mpf(10) ** -6
    assert ends(moved)[1] > mpf("0.05")


def test_what_the_slow_part_and_the_tube_do_to_the_coefficient() -> None:
    """(12) at every e up to e_0, and its ends."""
    series = replace(SERIES, w=fmpq(1, 3) * H**2 + fmpq(3, 7) * H * R)
    one, p = replace(tube("0"), barrier={}), mpf(4) / 9
    h, r = arb("0.125"), arb("0.0625")
    terms = {(2, 0): (mpf(1) / 3, mpf(3)), (1, 1): (mpf(3) / 7, mpf(1))}
    largest = number(A * DELTA**3) / p ** mpf("1.5")

    def moved(nearest: mpf, r: mpf) -> mpf:
        return -number(BETA) * sum(
            c / growth * (mpf("0.125") ** i * r**n - nearest**i * mpmath.sqrt(p) ** n)
            for (i, n), (c, growth) in terms.items()
        )

    low, high = ends(carried(one, series, h, r))
    wanted = moved(mpf(0), mpf("0.0625")), moved(largest, mpf("0.0625"))
    assert wanted[0] < wanted[1]
    slack = wanted[1] - wanted[0]  # a ball around 0 comes of a square of one
    assert slack > mpf(10) ** -9
    assert wanted[0] - slack < low <= wanted[0]
    assert high >= wanted[1] > high - slack / 1000
    # with a tube, r in a ball
    wide = replace(one, barrier={(1, 1): arb("0.5")})
    low, high = ends(carried(wide, series, h, arb("0.0625", "0.03125")))
    drift = in_mpmath(wide.drift(arb("0.09375")))
    assert drift > mpf("0.001")
    wanted = moved(mpf(0), mpf("0.09375")) - drift, moved(largest, mpf("0.03125")) + drift
    assert wanted[0] - slack < low <= wanted[0]
    assert high >= wanted[1] > high - slack


def test_the_slow_part_moves_it_by_its_own_integral() -> None:
    """(7): p d log|C|/dp = beta w, by quadrature along one e."""
    e, p_1 = number(A * DELTA**3), mpf(4) / 9
    p = number(A * FAR * DELTA**2)
    moved = mpmath.quad(lambda t: number(BETA) * summed(SERIES.w, e / mpmath.exp(1.5 * t), mpmath.exp(t / 2)),
                        mpmath.linspace(mpmath.log(p_1), mpmath.log(p), 9))  # fmt: skip
    found = carried(tube("0"), SERIES, arb(H_1), arb(fmpq(3, 40)))
    low, high = ends(found)
    assert low - mpf(10) ** -25 <= moved <= high + mpf(10) ** -25
    assert high - low < abs(moved) / 100


def test_a_slow_part_that_grows_to_the_spot_is_refused() -> None:
    """E = 0 and E < 0."""
    for w in (H * R**3, H * R**4):
        with pytest.raises(ArithmeticError, match="in w"):
            carried(tube("0"), replace(SERIES, w=w), arb(H_1), arb("0.1"))
    assert carried(tube("0"), replace(SERIES, w=H * R**2), arb(H_1), arb("0.1")).is_finite()


def test_the_value_of_a_polynomial() -> None:
    value = evaluated(fmpq(2, 3) * H**2 * R**3 + fmpq(5, 7) * R + fmpq(1, 9), arb("0.25"), arb("0.75"))
    assert value.contains(fmpq(2, 3) * fmpq(1, 16) * fmpq(27, 64) + fmpq(5, 7) * fmpq(3, 4) + fmpq(1, 9))
    assert value.rad() < arb("1e-40")


def test_the_tube_must_reach_the_hand_over_and_this_epsilon() -> None:
    """Equality is enough, a bit less is not."""
    bit = 1 - fmpq(1, 10**12)
    assert hand_over_set(equations(), tube("0.05"), SERIES, arb(1), FAR).z.is_finite()
    for short in (tube("0.05", h=H_1 * bit), tube("0.05", e=A * DELTA**3 * bit)):
        with pytest.raises(ValueError, match="ends before"):
            hand_over_set(equations(), short, SERIES, arb(1), FAR)


BESIDE = ("0.05", "0.4", "0.3", "0.2", "0.01", "0.02", "0.03", "0.04")  # b, y, v, phi, and the state


@pytest.mark.parametrize("c_1", ["-0.75", "0.5"])
@pytest.mark.parametrize("bits", [160, 24])
def test_what_the_reference_differs_by_is_added_with_any_sign(c_1: str, bits: int) -> None:
    """(17): a reference beside Theorem 1 moves the corners; each bound is attained by some signs."""
    reached, fast, most = [mpf(0)] * 8, mpf(0), mpf("1.06")
    for signs in product((1, -1), repeat=8):
        more = [arb(value) * sign for value, sign in zip(BESIDE, signs, strict=True)]
        own = [in_mpmath(one) for one in more]
        with working_bits(bits):
            beside = Beside(more[0], more[1], more[2], more[3], (more[4], more[5], more[6], more[7]))
            one, root = equations(), arb("1.5")
            h, r = -one.alpha_1 / root**3, root * one.small
            slow = tuple(evaluated(part, h, r) for part in (SERIES.v, SERIES.v / R, SERIES.w, SERIES.f))
            found = framed(one, SERIES.beta, slow, SHARES, arb("0.015625"), arb(c_1), root**2, beside)
        column = [in_mpmath(found.frame[i, 5]) for i in range(8)]
        radii = [in_mpmath(one) for one in found.radii]
        for x in ((1, 1, 1), (-1, -1, -1), (1, -1, 1)):
            e, phi = corner(mpf(c_1), mpf(1) / 64, number(DELTA), (x[0], x[1], x[2]))
            square = number(DELTA) ** 2
            factors = (mpf(0), own[0], square**2 * own[1], square * own[2], mpf(0), own[0], own[1], own[2])
            e = [one + part for one, part in zip(e, factors, strict=True)]
            for i in range(4):
                e[i] += own[4 + i]
            share = e[5] / column[5]
            u = [abs(one - share * column[i]) if i != 5 else abs(share - 1) for i, one in enumerate(e)]
            assert all(one <= radius + mpf(10) ** -40 for one, radius in zip(u, radii, strict=True))
            assert abs(phi + own[3]) <= in_mpmath(found.fast)
            reached = [max(old, one) for old, one in zip(reached, u, strict=True)]
            fast = max(fast, abs(phi + own[3]))
    for i in (0, 1, 2, 3, 5, 6, 7):
        assert radii[i] <= most * reached[i], i
    assert in_mpmath(found.fast) <= most * fast


def test_the_bound_is_taken_at_the_largest_r() -> None:
    one = replace(tube("0.05"), barrier={(2, 1): arb(1)})
    found = hand_over_set(equations(), one, SERIES, arb(1), FAR)
    wanted = number(H_1) ** 2 * ROOT * number(DELTA)
    assert wanted <= in_mpmath(found.z) < wanted * (1 + mpf(10) ** -8)
