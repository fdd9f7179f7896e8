"""Flights of any shape: the first touch-down, or none; near-coincidence says nothing. Page: proofs/flight.md."""

from __future__ import annotations

from dataclasses import replace

import mpmath
import pytest
from flint import arb, fmpq

from gspot_verified.compliant.model.flight import ContactState, Flight
from gspot_verified.compliant.model.flight_pieces import _positive_from
from gspot_verified.compliant.motion.touch_down import flight_end
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome, Reason


def lifted(alpha_2: fmpq | int, b: fmpq | int, V: fmpq | int, Y: fmpq | int) -> ContactState:
    """A lift-off state at epsilon = 1: A = -alpha_2."""
    return ContactState(fmpq(5, 2), fmpq(1), fmpq(alpha_2), arb(-1), arb(b), arb(V), arb(Y), arb(0))


def first_root(alpha_2: float, b: float, V: float, Y: float) -> mpmath.mpf | None:
    """The first zero of the gap after 0 by small steps."""

    def gap(u: mpmath.mpf) -> mpmath.mpf:
        return V * u + b * u**2 / 2 + alpha_2 * u**3 / 6 + Y * (1 - mpmath.exp(-u))

    places = [mpmath.mpf(k) / 64 for k in range(1, 4000)]
    below = next((k for k, place in enumerate(places) if gap(place) < 0), None)
    return None if below is None else mpmath.findroot(gap, (places[below - 1], places[below]), solver="anderson")


FLIGHTS = [
    (1, -1, 1, 0), (1, -2, 1, 0), (1, fmpq(-5, 4), fmpq(1, 3), fmpq(1, 2)), (-1, 0, fmpq(-1, 4), fmpq(1, 2)),
    (0, 1, fmpq(-1, 2), 1), (0, 1, -3, 4), (2, -3, -1, 5), (1, -2, fmpq(5, 4), -1), (0, fmpq(-1, 8), -1, 2),
]  # fmt: skip


@pytest.mark.parametrize("numbers", FLIGHTS, ids=str)
def test_the_end_of_any_flight(numbers: tuple[fmpq | int, ...]) -> None:
    end = flight_end(lifted(*numbers), 60)
    assert end.verdict.outcome is Outcome.PROVED
    root = first_root(*(float(fmpq(number).p) / int(fmpq(number).q) for number in numbers))
    if root is None:
        assert end.verdict.statement == "the flight never ends"
        assert end.state is None
        return
    assert end.lower is not None
    assert end.upper is not None
    assert end.upper - end.lower < fmpq(1, 2**50)
    with working_bits(80):
        assert abs(arb(end.lower) - arb(mpmath.nstr(root, 25))) < arb("1e-13")


def test_a_gap_that_touches_0_is_undecided_and_its_neighbours_are_not() -> None:
    """h = u (u^2/6 - u + V): a double zero at V = 3/2, u = 3."""
    assert flight_end(lifted(1, -2, fmpq(3, 2), 0), 60).verdict.reason is Reason.BUDGET
    tiny = fmpq(1, 10**6)
    touched = flight_end(lifted(1, -2, fmpq(3, 2) - tiny, 0), 60)
    assert touched.upper is not None
    assert touched.upper < 3
    missed = flight_end(lifted(1, -2, fmpq(3, 2) + tiny, 0), 60)
    assert missed.verdict.statement == "the flight never ends"
    wide = replace(lifted(1, -2, 0, 0), V=arb(fmpq(3, 2), tiny))
    assert flight_end(wide, 60).verdict.reason is Reason.WIDE_INPUT


def test_each_sign_of_a_flight_that_goes_on_for_ever_is_asked_for() -> None:
    with working_bits(100):
        assert _positive_from(Flight(lifted(1, 0, 1, 0)), fmpq(1)) is not None
        for alpha_2, b, V, Y in (
            (fmpq(-1, 2**30), 3, 5, 0),  # A > 0
            (1, 0, 2, -3),  # the third derivative < 0
            (1, fmpq(-3, 2), 4, 0),  # the second < 0
            (1, 0, fmpq(-2, 3), 0),  # h' < 0
            (1, 0, fmpq(-1, 3), 0),  # h < 0
        ):
            assert _positive_from(Flight(lifted(alpha_2, b, V, Y)), fmpq(1)) is None
