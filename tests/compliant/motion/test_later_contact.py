"""The contact after a touch-down from balls: lost, lasting, and what balls leave open. Page: proofs/flight.md."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import mpmath
import pytest
from flint import arb, arb_poly, fmpq
from samples.strategies import ends
from witnesses.contact import moved

from gspot_verified.compliant.model.flight import ContactState
from gspot_verified.compliant.motion.contact_series import SeriesCell
from gspot_verified.compliant.motion.later_contact import LaterContact, TouchDown, _Course, later_contact
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Reason

BETA, SMALL, P, AT_ONCE = fmpq(5, 2), fmpq(1, 100), fmpq(-1, 8), fmpq(0)
MEAN = fmpq(2, 3)  # alpha_2/(1 - beta), alpha_2 = -1


def landed(b: fmpq, V: fmpq, Y: fmpq) -> ContactState:
    """A touch-down: the force is 0."""
    return ContactState(BETA, SMALL, fmpq(-1), arb(P), arb(b), arb(V), arb(Y), arb(0))


def force_at(state: ContactState, time: fmpq) -> mpmath.mpf:
    """lambda by the equations."""

    def number(value: fmpq | arb) -> mpmath.mpf:
        if isinstance(value, fmpq):
            return mpmath.mpf(int(value.p)) / int(value.q)
        mantissa, exponent = value.mid().man_exp()
        return mpmath.ldexp(mpmath.mpf(int(mantissa)), int(exponent))

    p, mean = number(state.p), number(MEAN)
    Y = number(state.Y)
    hats = [number(state.b) + p * mean, number(state.V), Y + 2 * mean, Y + mean]
    (_, _, Y, Z), _ = moved(hats, p, number(BETA), number(SMALL), number(time), steps=max(1, int(time * 8)))
    return Z - Y + mean


def followed(state: ContactState, duration: fmpq = AT_ONCE, budget: int = 300) -> LaterContact | Reason:
    p = P - SMALL * duration
    return later_contact(TouchDown(state, duration, p), MEAN, 20, 120, budget)


LOST = landed(fmpq(1, 2), fmpq(-1, 4), fmpq(-1, 4))
LASTING = landed(fmpq(-1, 2), fmpq(-1), fmpq(-1, 4))


def test_a_contact_that_is_lost_has_its_zero_in_the_bracket() -> None:
    found = followed(LOST)
    assert isinstance(found, LaterContact)
    assert found.lasts is None
    assert found.upper - found.lower < fmpq(1, 10**20)
    with mpmath.workdps(50):
        assert force_at(LOST, found.lower) > 0 > force_at(LOST, found.upper)
        assert all(force_at(LOST, found.lower * share / 10) > 0 for share in range(1, 10))
    assert found.state.force.contains(0) or found.state.force > 0
    assert found.state.p.overlaps(arb(fmpq(-1, 8) - SMALL * found.lower))


def test_a_contact_that_lasts_is_in_a_set_at_the_end() -> None:
    found = followed(LASTING)
    assert isinstance(found, LaterContact)
    assert found.lasts is not None
    assert found.lower == found.upper
    with mpmath.workdps(30):
        forces = [force_at(LASTING, found.lower + k) for k in range(4)]
    assert forces[0] > 0
    assert forces == sorted(forces)
    middle = found.state.force.mid()
    assert abs(float(middle) - float(forces[0])) < 1e-9


@pytest.mark.parametrize("state", [LOST, LASTING])
def test_a_bracket_of_the_touch_down_covers_each_instant_in_it(state: ContactState) -> None:
    """The motion of each instant of landing: its zero lies in the one bracket."""
    duration = fmpq(1, 10**9)
    found = followed(state, duration)
    assert isinstance(found, LaterContact)
    assert (found.lasts is None) is (state is LOST)
    if state is LOST:
        with mpmath.workdps(40):
            assert force_at(state, found.lower + duration) > 0 or force_at(state, found.lower) > 0
            assert force_at(state, found.upper + duration) < 0


def test_balls_that_hold_both_answers_leave_it_open() -> None:
    """Between the two states there is one whose contact is neither lost nor kept within the work: the ball holds it."""
    wide = replace(LOST, b=arb(0, fmpq(3, 4)), V=arb(fmpq(-5, 8), fmpq(1, 2)))
    assert followed(wide) is Reason.WIDE_INPUT


def test_a_force_that_may_fall_at_once_leaves_it_open() -> None:
    """At the touch-down d lambda/dT = -Y - V, 2^-40 beside 0."""
    tiny = fmpq(1, 2**40)
    assert followed(landed(fmpq(1, 2), fmpq(1, 4), fmpq(-1, 4))) is Reason.WIDE_INPUT
    assert followed(landed(fmpq(1, 2), fmpq(1, 4) + tiny, fmpq(-1, 4))) is Reason.WIDE_INPUT
    assert isinstance(followed(landed(fmpq(-1, 2), fmpq(1, 4) - tiny, fmpq(-1, 4))), LaterContact)


def test_work_that_ends_leaves_it_open() -> None:
    assert followed(LOST, budget=1) is Reason.BUDGET


def test_the_sum_of_four_motions_has_the_sizes_of_its_balls_in_its_rests() -> None:
    """Each rest times |x_j|, whatever the sign of x_j, and all of them added."""
    hats = [arb(-2, "0.5"), arb(3), arb(5), arb(-7)]
    shown = less(0, 1)
    assert shown is not None
    course = _Course(LOST, P, MEAN, hats, shown, 64)
    parts = [
        SeriesCell(
            fmpq(5), fmpq(2), tuple(arb_poly([0] * k + [10**j]) for k in range(4)), tuple(arb(10**j) for _ in range(4))
        )
        for j in range(4)
    ]
    with working_bits(64):
        found = course._sum(parts)
    assert (found.first, found.width) == (5, 2)
    for k, (poly, rest) in enumerate(zip(found.variables, found.rests, strict=True)):
        assert poly.degree() == k
        lower, upper = ends(poly[k])
        assert abs(lower + 6472 + Fraction(1, 2)) + abs(upper + 6472 - Fraction(1, 2)) < Fraction(1, 2**20)
        assert abs(ends(rest)[1] - (7532 + Fraction(1, 2))) < Fraction(1, 2**20)
        assert ends(rest)[0] >= 7531
