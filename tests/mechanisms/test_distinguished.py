"""Theorem A3 of the page: λ on the distinguished trajectory against the paper's expansion, and hypotheses that fail.

Page: proofs/approach.md.
"""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from gspot_verified.balls import add_remainder, working_bits
from gspot_verified.integrator.field import VectorField
from gspot_verified.mechanisms.distinguished import Distinguished, Region, force_at, taylor_in_p
from gspot_verified.mechanisms.expand import expand
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.slip_flow import SlipFlow
from gspot_verified.mechanisms.to_system import shift

EXTENDED = shipped_mechanism("extended system")


def parts(order: int, radius: str = "0") -> tuple[VectorField, Distinguished]:
    field = SlipFlow.of(shift(EXTENDED)).by_p()
    spot = [arb(0), arb(1), arb(0), arb(0), arb(0), arb(0)]
    found = taylor_in_p(field, [add_remainder(value, arb(radius)) for value in spot], order)
    assert found is not None
    return field, found


def region(field: VectorField, radius: str = "0.05") -> Region:
    box = [arb(value, radius) for value in (0, 1, 0, 0, 0, 0)]
    found = Region.on(field, [*box, arb(2, "0.5")])
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
        assert force_at(field, found, arb(0), disc, good) is None
        assert force_at(field, found, arb(0, 1), disc, good) is None
        assert force_at(field, found, p, arb(100), good) is None  # 1/α_1 has a pole on such a disc
        small = Region.on(field, [*(arb(v, "1e-5") for v in (0, 1, 0, 0, 0, 0)), arb(2, "1e-5")])
        assert small is not None
        assert force_at(field, found, p, disc, small) is None


def test_an_integer_beta_has_no_polynomial() -> None:
    with working_bits(100):
        field = SlipFlow.of(shift(EXTENDED.with_parameters(alpha_3=-3))).by_p()
        spot = [arb(0), arb(1), arb(0), arb(0), arb(0), arb(0)]
        assert taylor_in_p(field, spot, 1) is not None
        assert taylor_in_p(field, spot, 2) is None  # 2 - (β - 1) = 0
