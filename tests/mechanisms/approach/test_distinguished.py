"""Theorem A3 of the page: λ on the distinguished trajectory against the paper's expansion, and hypotheses that fail.

Page: proofs/approach.md.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest
from flint import arb, arb_poly, fmpq
from samples.strategies import ends, holds

from gspot_verified.functions.expressions import Constant, Variable
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.mechanisms.approach.distinguished import (
    Distinguished,
    FlowBounds,
    _bounds,
    force_at,
    force_rest,
    shared_taylor_in_p,
    taylor_in_p,
)
from gspot_verified.mechanisms.approach.slip_flow import SlipFlow
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.expand import expand
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.numbers.balls import add_remainder, working_bits

EXTENDED = shipped_mechanism("extended system")


def parts(order: int, radius: str = "0") -> tuple[VectorField, Distinguished]:
    field = SlipFlow.of(shift(EXTENDED)).by_p()
    spot = [arb(0), arb(1), arb(0), arb(0), arb(0), arb(0)]
    found = taylor_in_p(field, [add_remainder(value, arb(radius)) for value in spot], order)
    assert found is not None
    return field, found


def region(field: VectorField, radius: str = "0.05") -> FlowBounds:
    box = [arb(value, radius) for value in (0, 1, 0, 0, 0, 0)]
    found = FlowBounds.on(field, [*box, arb(2, "0.5")])
    assert found is not None
    return found


def exact_force(p: fmpq) -> arb:
    """-b/p with b as a function of p from the series of Theorem 1 in t at ε = 0, inverted by Newton's method."""
    series = expand(EXTENDED, 41).in_time()
    tables = [{k: value for (k, m), value in table.items() if m == 0} for table in (series.p, series.b)]

    def value(table: dict[int, fmpq], t: arb) -> arb:
        return sum((arb(c) * t**k if k else arb(c) for k, c in table.items()), arb(0))

    t = arb(-p)
    for _ in range(12):
        slope = sum((arb(c) * k * (t ** (k - 1) if k > 1 else 1) for k, c in tables[0].items() if k), arb(0))
        t = (t - (value(tables[0], t) - p) / slope).mid()
    return -value(tables[1], t) / p


@pytest.mark.parametrize("order", [3, 6, 10])
def test_against_the_expansion_of_theorem_1(order: int) -> None:
    """χ = 1, β = 3/2; the expansion of degree 19 in t leaves about p^19."""
    with working_bits(200):
        field, found = parts(order)
        value = force_at(field, found, arb(fmpq(1, 1000)), arb(fmpq(1, 50)), region(field))
        assert value is not None
        assert value.is_finite()
        true = exact_force(fmpq(1, 1000))
        assert value.contains(true.mid()) or value.overlaps(add_remainder(true, arb("1e-40")))
        assert value.rad() < arb("0.05") * arb(20) ** -order


def test_the_first_coefficients() -> None:
    """b = -2 p + c p² + ...: b = 2 t + 6 t² + ..., p = -t + t² + ... give λ = -b/p = 2 - 8 t... in p."""
    with working_bits(100):
        _, found = parts(2)
        t_of_p = (fmpq(-1), fmpq(1))  # t = -p + p² + O(p³)
        second = 2 * t_of_p[1] + 6 * t_of_p[0] ** 2  # b = 2 t + 6 t² = -2 p + 8 p²
        assert found.force.coeffs()[0].contains(2)
        assert found.force.coeffs()[1].contains(-second)
        assert all(value.is_finite() for value in found.force.coeffs())


def test_hypotheses_that_fail() -> None:
    with working_bits(120):
        field, found = parts(6)
        good = region(field)
        p, disc = arb(fmpq(1, 1000)), arb(fmpq(1, 50))
        assert force_at(field, found, p, disc, good) is not None
        assert force_at(field, found, disc, p, good) is None
        assert force_at(field, found, disc, disc, good) is None
        assert force_at(field, found, arb(0), disc, good) is None
        assert force_rest(field, found, arb(0), disc, good) is None
        assert force_at(field, found, arb(0, 1), disc, good) is None
        assert force_at(field, found, p, arb(100), good) is None  # 1/α_1 has a pole on such a disc
        small = FlowBounds.on(field, [*(arb(v, "1e-5") for v in (0, 1, 0, 0, 0, 0)), arb(2, "1e-5")])
        assert small is not None
        assert force_at(field, found, p, disc, small) is None


def test_an_integer_beta_has_no_polynomial() -> None:
    with working_bits(100):
        field = SlipFlow.of(shift(EXTENDED.with_parameters(alpha_3=-3))).by_p()
        spot = [arb(0), arb(1), arb(0), arb(0), arb(0), arb(0)]
        assert taylor_in_p(field, spot, 1) is not None
        assert taylor_in_p(field, spot, 2) is None  # 2 - (β - 1) = 0


def test_narrow_enclosures_of_one_point_share_a_polynomial_that_holds_for_each() -> None:
    """A wide one has its own; and one of another point."""
    with working_bits(100):
        field = SlipFlow.of(shift(EXTENDED)).by_p()
        spot = [arb(0), arb(1), arb(0), arb(0), arb(0), arb(0)]
        first, second = ([add_remainder(value, arb((1, -k))) for value in spot] for k in (90, 95))
        found = shared_taylor_in_p(field, first, 4)
        assert found is not None
        assert shared_taylor_in_p(field, second, 4) is found
        exact = taylor_in_p(field, spot, 4)
        assert exact is not None
        for shared, own in zip((*found.state, found.force), (*exact.state, exact.force), strict=True):
            for k in range(5):
                assert shared[k].contains(own[k])
                assert shared[k].rad() < 2.0**-50
        other = shared_taylor_in_p(field, [spot[0], arb(2), *spot[2:]], 4)
        assert other is not None
        assert other is not found
        assert other.state[1][0].contains(2)
        wide = [add_remainder(value, arb((1, -60))) for value in spot]
        own_of_wide, again = shared_taylor_in_p(field, wide, 4), taylor_in_p(field, wide, 4)
        assert own_of_wide is not None
        assert again is not None
        assert str(own_of_wide.force) == str(again.force)
        assert shared_taylor_in_p(field, wide, 4) is not own_of_wide


FLAT = VectorField([Constant(fmpq(-3)), Constant(fmpq(2)), Constant(fmpq(-5))])
"""S = (-3, 2) and R = -5 everywhere."""


def by_hand(**change: arb) -> tuple[Distinguished, FlowBounds, Fraction, Fraction]:
    """n = 2, p_1 = 1/4, Q = 1, σ_1 = 1/2, σ_2 = 1/3, r = 2, β - 1 = 1: κ = 2; and H, E of Theorem A3."""
    found = Distinguished((arb_poly([1, 2]), arb_poly([0])), arb_poly([4, -8, 16]), arb(1), 2)
    box = (arb("1.25", 1), arb(0, 1), arb(3, 2))
    values = {"S_state": arb("0.5"), "S_force": arb(fmpq(1, 3)), "R_state": arb(2), "exponent": arb(1)} | change
    last, geometric = Fraction(1, 4), Fraction(4, 3)
    d_S, d_R = 3 * geometric, 5 * geometric
    free = 1 - Fraction(1, 2) * last / 4 - Fraction(1, 3) * 2 * last / (4 * 2)
    H = (Fraction(1, 3) * d_R * last / (4 * 2) + d_S / 3) / free
    return found, FlowBounds(box, (), **values), H, (2 * H + d_R) / 2


def test_theorem_a3_by_hand() -> None:
    with working_bits(80):
        found, good, _, E = by_hand()
        value = force_at(FLAT, found, arb("0.25"), arb(1), good)
        assert value is not None
        middle, rest = Fraction(4 - 2 + 1), E / 64
        low, high = ends(value)
        assert middle - rest * (1 + Fraction(1, 10**6)) < low <= middle - rest
        assert middle + rest <= high < middle + rest * (1 + Fraction(1, 10**6))


def test_theorem_a3_with_an_exponent_next_to_an_order() -> None:
    """β - 1 = 11/4, n = 2: κ = 1/4 > 0 is all that is asked."""
    with working_bits(80):
        found, good, *_ = by_hand(exponent=arb("2.75"), S_force=arb("0.01"))
        assert force_rest(FLAT, found, arb("0.25"), arb(1), replace(good, box=(arb(0, 10**6),) * 3)) is not None


def test_theorem_a3_with_a_smaller_disc() -> None:
    """Q = 1/2: d_S = 3 · 4 · 2 and d_R = 5 · 8 · 2, as p_1/Q = 1/2."""
    with working_bits(80):
        found, good, *_ = by_hand()
        wide = replace(good, box=(arb(1, 9), arb(0, 9), arb(3, 90)))
        value = force_at(FLAT, found, arb("0.25"), arb("0.5"), wide)
        assert value is not None
        free = 1 - Fraction(1, 32) - Fraction(1, 48)
        H = (Fraction(1, 3) * 80 * Fraction(1, 4) / 8 + 8) / free
        rest = (2 * H + 80) / 2 / 64
        assert rest <= ends(value)[1] - 3 < rest * (1 + Fraction(1, 10**6))


@pytest.mark.parametrize(
    "change",
    [
        {"exponent": arb(3)},  # κ = 0
        {"exponent": arb(3, 1)},
        {"exponent": arb(4)},
        {"S_state": arb(16)},  # f < 0
        {"S_force": arb(16)},
        {"R_state": arb(96)},
        {"S_state": arb("nan")},
    ],
)
def test_theorem_a3_needs_its_hypotheses(change: dict[str, arb]) -> None:
    with working_bits(80):
        found, bad, *_ = by_hand(**change)
        assert force_at(FLAT, found, arb("0.25"), arb(1), bad) is None
        wide = replace(bad, box=(arb(0, 10**6),) * 3)
        assert force_at(FLAT, found, arb("0.25"), arb(1), wide) is None


def test_the_widened_polynomials_lie_in_the_interior() -> None:
    """1 + 2 p is in [1, 3/2] and 4 - 8 p + 16 p² (as a ball) in [2, 5]; they are widened by H/64 and E/64."""
    with working_bits(80):
        found, good, H, E = by_hand()
        narrow, own = H / 64, E / 64
        fits = [(Fraction(1) - narrow, Fraction(3, 2) + narrow), (-narrow, narrow), (2 - own, 5 + own)]
        for scale, there in ((Fraction(101, 100), True), (Fraction(99, 100), False)):
            for k in range(3):
                box = list(good.box)
                for j, (low, high) in enumerate(fits):
                    factor = scale if j == k else Fraction(2)
                    radius = (high - low) / 2 * factor
                    middle = (high + low) / 2
                    box[j] = arb(fmpq(middle.numerator, middle.denominator)) + arb(
                        0, arb(fmpq(radius.numerator, radius.denominator))
                    )
                value = force_at(FLAT, found, arb("0.25"), arb(1), replace(good, box=tuple(box)))
                assert (value is not None) is there, (k, scale)


def test_the_disc_counts_all_terms_but_the_first_with_their_absolute_values() -> None:
    """S = ξ_0 = 1 - 2 p + 3 p² on |p| <= 1/2: |S| <= 1 + 1 + 3/4; R = λ = -4 + p: |R| <= 9/2."""
    with working_bits(80):
        field = VectorField([Variable(0), Variable(1)])
        found = Distinguished((arb_poly([1, -2, 3]),), arb_poly([-4, 1]), arb(1), 2)
        bounds = _bounds(field, found, arb("0.5"))
        assert bounds is not None
        for bound, exact in zip(bounds, (Fraction(11, 4), Fraction(9, 2)), strict=True):
            assert exact <= ends(bound)[1] < exact * Fraction(3, 2)  # the disc stands in a square
        assert _bounds(VectorField([Constant(fmpq(1)) / Variable(0), Variable(1)]), found, arb("0.5")) is None
        nothing = _bounds(field, replace(found, state=(arb_poly([]),)), arb("0.5"))
        assert nothing is not None
        assert nothing[0] == 0


def test_a_region_bounds_norms() -> None:
    """S = (x y + λ, 3 λ - y), R = 2 λ - x²/2 + y on |x| <= 1, |y| <= 2, λ in [0, 1]."""
    x, y, force = (Variable(i) for i in range(3))
    three, two, half = (Constant(fmpq(*value)) for value in ((3, 1), (2, 1), (1, 2)))
    minus = Constant(fmpq(-1))
    field = VectorField([x * y + force, three * force + minus * y, two * force + minus * half * x * x + y])
    with working_bits(80):
        found = FlowBounds.on(field, [arb(0, 1), arb(0, 2), arb("0.5", "0.5")])
        assert found is not None
        for bound, exact in ((found.S_state, 3), (found.S_force, 3), (found.R_state, 2)):
            assert exact <= ends(bound)[1] < exact * Fraction(1000001, 1000000)
        assert holds(found.exponent, 2)
        for side, reach in zip(found.S, (3, 5), strict=True):
            assert holds(side, reach) or holds(side, -reach)
        assert FlowBounds.on(VectorField([x / y, y, force]), [arb(0, 1), arb(0, 2), arb(0)]) is None


def test_the_bounds_are_those_of_the_whole_box() -> None:
    """S = x lambda^2 and R = x^2 for |x| <= 2 and 1 <= lambda <= 3: |S_x| <= 9, |S_lambda| <= 12, |R_x| <= 4."""
    x, force = Variable(0), Variable(1)
    found = FlowBounds.on(VectorField([x * force * force, x * x]), [arb(0, 2), arb(2, 1)])
    assert found is not None
    for bound, least in ((found.S_state, 9), (found.S_force, 12), (found.R_state, 4)):
        assert bound.is_finite()
        assert bound >= least
