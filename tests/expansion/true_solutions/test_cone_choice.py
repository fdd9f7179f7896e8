"""Candidates for the cone: the deviation at s_1 lies in each of them. Page: proofs/uniform.md, Theorem U2."""

from __future__ import annotations

from dataclasses import replace

import pytest
from flint import arb, fmpq

from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.expansion.true_solutions.bound import BITS
from gspot_verified.expansion.true_solutions.cone_choice import cones
from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.expansion.true_solutions.growth import EntryDeviation, needed_p, needed_state, phi_of, ranges_of
from gspot_verified.numbers.balls import working_bits
from gspot_verified.testing import extended_example

ENTRY = EntryDeviation(
    1, fmpq(-1), fmpq(2), arb(2, 0.01), arb(4, 0.01), arb(10, 0.01), arb("1.9"), (arb(1),) * 6, arb("0.01"), arb("0.01")
)
TOP, POWER = arb(6), fmpq(1)


@pytest.fixture(scope="module")
def equations() -> DeviationEquations:
    with working_bits(BITS):
        return DeviationEquations(expand_system(extended_example(chi=1, alpha=(-2, -1, "-3")), 10), fmpq(1, 1000))


@pytest.mark.parametrize(
    "changes",
    [{}, {"N": arb(40, 0.01)}, {"N": arb(40, 0.01), "q": arb("0.01")}, {"V": arb(4, 0.5)}, {"p": arb(3)}],
    ids=["plain", "steep", "hardly pressed", "wide", "turned"],
)
def test_the_deviation_lies_in_each_cone(equations: DeviationEquations, changes: dict[str, arb]) -> None:
    """(G0), (G5) and what (G4) needs of C at least, with little room; the rates fall from the first one to the last."""
    with working_bits(BITS):
        entry = replace(ENTRY, **changes)
        found = list(cones(equations, entry, POWER, TOP))
        assert len(found) > 10
        least = entry.Y.lower()
        for cone in found:
            assert cone.top == TOP
            assert entry.V - cone.a * entry.Y > 0
            assert entry.N - cone.c * entry.V > 0
            assert cone.B * entry.Y - entry.V > 0
            assert cone.C * entry.V - entry.N > 0
            assert cone.a < cone.c < arb("1.4") * cone.a
            assert cone.C < cone.B
            ranges = ranges_of(equations, entry, POWER, cone)
            assert ranges is not None
            q_last = (entry.q + ranges.alpha_1.abs_upper() * (ranges.last - arb(entry.place))).upper()
            largest = (equations.kappa * q_last).sqrt()
            assert largest < cone.C
            room = ((entry.N / entry.V).upper() * arb("1.06")).max(arb("1.2") * largest)
            assert room > cone.C
            assert all(bound * least > value for bound, value in zip(cone.A, entry.state, strict=True))
            needed = needed_state(equations, ranges, cone, phi_of(equations, entry, ranges))
            assert all(bound > value for bound, value in zip(cone.A, needed, strict=True))
            assert cone.A_p * least > entry.p
            least_p = needed_p(equations, ranges, cone)
            assert cone.A_p > least_p
            assert cone.A_p < arb("1.3") * (entry.p / least).upper().max(least_p)
        rates = [float(cone.a.mid()) for cone in found]
        steepest = float((entry.V.lower() / entry.Y.upper()).mid())
        assert rates == sorted(rates, reverse=True)
        assert 0.9 * steepest < rates[0] < steepest
        assert rates[-1] < 0.4 * steepest


def test_no_cone_where_a_sign_is_not_certain(equations: DeviationEquations) -> None:
    with working_bits(BITS):
        for name in ("Y", "V", "N", "q"):
            for value in (arb(0, 1), arb(-1), arb("nan"), arb(0)):
                assert list(cones(equations, replace(ENTRY, **{name: value}), POWER, TOP)) == []


def test_no_cone_is_steeper_than_the_deviation(equations: DeviationEquations) -> None:
    """N/V = 1: no cone with c < N/V has a rate above 1, while V/Y = 2 would allow it."""
    with working_bits(BITS):
        found = list(cones(equations, replace(ENTRY, N=arb(4, 0.01)), POWER, TOP))
        assert found
        assert all(cone.c < 1 for cone in found)


def test_ranges_that_are_not_finite_give_no_cone(equations: DeviationEquations) -> None:
    with working_bits(BITS):
        assert list(cones(equations, ENTRY, POWER, arb("nan"))) == []
        assert list(cones(equations, ENTRY, POWER, arb(0))) == []
