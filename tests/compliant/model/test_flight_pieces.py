"""Flights of any shape: the first touch-down, or none; near-coincidence says nothing. Page: proofs/flight.md."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import mpmath
import pytest
from flint import arb, fmpq

from gspot_verified.compliant.model import flight_pieces
from gspot_verified.compliant.model.flight import ContactState, Flight
from gspot_verified.compliant.model.flight_pieces import Landing, _positive, _positive_from, landing
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


def test_the_second_derivative_holds_what_is_left_of_y() -> None:
    """h'' = b - A u - Y e^-u at u = 1, A = -1: 2^-20 before and beyond 0, for either sign of Y."""
    near = fmpq(1, 2**20)
    with working_bits(100):
        for Y in (fmpq(2), fmpq(-1, 2)):
            edge = arb(Y) * arb(-1).exp() - 1
            for move, good in ((near, True), (-near, False)):
                start = replace(lifted(1, 0, 10, Y), b=edge + move)
                assert (_positive_from(Flight(start), fmpq(1)) is not None) is good


NEAR = fmpq(1, 2**20)


@pytest.mark.parametrize(
    ("rate", "middle", "begin", "end", "good"),
    [
        (arb(0, 1), 1 + NEAR, -1, -1, True),  # by the mean value: half the piece is 1
        (arb(0, 1), 1 - NEAR, -1, -1, False),
        (arb(-2, "1.9375"), 0, -1, NEAR, True),  # it falls, to a positive end
        (arb(-2, "1.9375"), 0, 1, -NEAR, False),
        (arb(-2, 2), 0, -1, 1, False),
        (arb(2, "1.9375"), 0, NEAR, -1, True),  # it rises, from a positive end
        (arb(2, "1.9375"), 0, -NEAR, 1, False),
        (arb(2, 2), 0, 1, -1, False),
    ],
)
def test_a_piece_is_positive_for_three_reasons(
    rate: arb, middle: fmpq | int, begin: fmpq | int, end: fmpq | int, good: bool
) -> None:
    values = {2: middle, 1: begin, 3: end}
    flight: Any = SimpleNamespace(gap=lambda u: arb(values[int(float(u))]))
    assert (_positive(flight, fmpq(1), fmpq(3), rate) is not None) is good


def test_ends_without_their_signs_are_no_landing() -> None:
    flight = Flight(lifted(1, -2, fmpq(5, 4), -1))
    with working_bits(100):
        honest = landing(flight, lambda _, begin, end: (begin, end))
        assert isinstance(honest, Landing)
        lower, upper = honest.lower, honest.upper
        assert lower is not None
        assert upper is not None
        assert landing(flight, lambda *given: (given[1], given[1])) is Reason.WIDE_INPUT
        assert landing(flight, lambda *given: (given[2], given[2])) is Reason.WIDE_INPUT


def test_why_nothing_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without a piece: the work, unless the state is wide and h has no sign there."""
    for name in ("_MOST_PIECES", "_DOUBLINGS"):
        monkeypatch.setattr(flight_pieces, name, 0)

    def reason(b: int, radius: fmpq) -> object:
        start = replace(lifted(1, b, 1, 0), V=arb(1, radius))
        with working_bits(100):
            return landing(Flight(start), lambda _, begin, end: (begin, end))

    assert [reason(0, fmpq(0)), reason(0, fmpq(1, 8)), reason(-2, fmpq(1, 2))] == [
        Reason.BUDGET,
        Reason.BUDGET,
        Reason.WIDE_INPUT,
    ]


@pytest.mark.parametrize(
    ("alpha_2", "b", "Y", "statement"),
    [
        (fmpq(-1, 8), 1, 0, "exactly one touch-down, with h' < 0"),
        (0, fmpq(-1, 8), fmpq(-1, 2), "exactly one touch-down, with h' < 0"),
        (0, 0, 0, "the flight never ends"),
        (fmpq(-1, 8), 1, fmpq(1, 8), "the first touch-down, with h' < 0"),
        (fmpq(1, 64), fmpq(-3), 0, "the first touch-down, with h' < 0"),
    ],
)
def test_which_theorem_speaks(alpha_2: fmpq | int, b: fmpq | int, Y: fmpq | int, statement: str) -> None:
    assert flight_end(lifted(alpha_2, b, 1, Y), 60).verdict.statement == statement


def test_the_bracket_holds_the_touch_down_of_every_state() -> None:
    """h = V u - u^3, its sign at u = 1 not certain: V = 1 +- 1/10 lands between 0.9486 and 1.0488."""
    end = flight_end(replace(lifted(-6, 0, 1, 0), V=arb(1, fmpq(1, 10))), 60)
    assert end.lower is not None
    assert end.upper is not None
    assert fmpq(93, 100) < end.lower < fmpq(9487, 10**4)
    assert fmpq(10488, 10**4) < end.upper < fmpq(107, 100)
