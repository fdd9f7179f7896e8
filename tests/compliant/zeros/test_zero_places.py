"""Enclosures of the zeros of the slow solution: each holds its zero, also where a sign stays open.

Page: proofs/finite_epsilon_zeros.md.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import pytest
from flint import acb, arb, fmpq
from samples.strategies import ends, to_fraction

from gspot_verified.compliant.slow.grid import scale
from gspot_verified.compliant.slow.slow_jet import slow_jet
from gspot_verified.compliant.zeros import zero_places as module
from gspot_verified.compliant.zeros.zero_count import slow_zeros
from gspot_verified.compliant.zeros.zero_places import polynomial_places, zero_places
from gspot_verified.numbers.balls import working_bits
from gspot_verified.signs.cover.pieces import Column, ColumnPiece, Kind

BETA, EPSILON = fmpq(5, 2), fmpq(1, 10)
Sign = Callable[[fmpq, fmpq, fmpq, int], int | None]


def changes_sign(place: arb, beta: fmpq, epsilon: fmpq) -> bool:
    """Whether the slow solution has different certain signs a little outside of the ball of T."""
    with working_bits(200):
        lower, upper = ((arb(fmpq(end.numerator, end.denominator)) * scale(epsilon)).mid() for end in ends(place))
        pair = []
        for tau in (lower - arb((1, -20)), upper + arb((1, -20))):
            mantissa, exponent = tau.man_exp()
            exact = fmpq(mantissa) * fmpq(2) ** int(exponent)
            pair.append(slow_jet(exact, beta - 1, epsilon, 1, 120)[0])
    return bool((pair[0] < 0 and pair[1] > 0) or (pair[0] > 0 and pair[1] < 0))


@pytest.mark.parametrize(("beta", "epsilon"), [("5/2", "1/10"), ("5.95", "1/100"), ("3/2", "2"), ("9/2", "1/3")])
def test_each_ball_holds_a_change_of_sign(beta: str, epsilon: str) -> None:
    found = slow_zeros(beta, epsilon, digits=8)
    assert len(found.places) == found.number
    for place in found.places:
        assert changes_sign(place, found.beta, found.epsilon)
    middles = [sum(ends(place), Fraction(0)) for place in found.places]
    assert middles == sorted(middles)


def opened(honest: Sign, where: Callable[[fmpq], bool]) -> Sign:
    """The signs, open at some places."""
    return lambda beta, epsilon, tau, digits: None if where(tau) else honest(beta, epsilon, tau, digits)


def test_an_open_sign_widens_a_ball_and_loses_no_zero(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever signs are open: at the ends of a bracket, or on the way into the right tail."""
    found = slow_zeros(BETA, EPSILON, digits=8)
    column, honest = found.column, module._sign
    assert column is not None
    assert found.number == 2
    with working_bits(100):
        zeros = [sum(ends(place * scale(EPSILON)), Fraction(0)) / 2 for place in found.places]
    tubes = column.tubes()
    last = column.pieces[-1]
    assert last.kind is Kind.RIGHT
    cases: list[Callable[[fmpq], bool]] = [lambda tau: tau in [end for tube in tubes for end in tube]]
    cases += [lambda _: True, lambda tau: to_fraction(tau) > zeros[-1]]
    cases += [lambda tau, z=z: abs(to_fraction(tau) - z) < 1 for z in zeros]  # type: ignore[misc]
    for where in cases:
        monkeypatch.setattr(module, "_sign", opened(honest, where))
        places = zero_places(BETA, EPSILON, column, 8)
        assert len(places) >= len(tubes)
        for place, true in zip(places, found.places, strict=False):
            assert place.contains(true.mid())


# beta, epsilon, and where a tail may begin that holds the last zero; in the last case the sign at 1 is that of infinity
TAILS = [
    ("3/2", "1/10", fmpq(-1)),
    ("5/2", "1/10", fmpq(0)),
    ("2.001", "1/10", fmpq(2)),
    ("5.2", "1/1000", fmpq(2)),
]


@pytest.mark.parametrize(("beta", "epsilon", "start"), TAILS)
@pytest.mark.parametrize("open_sign", [False, True])
def test_a_zero_in_the_right_tail_is_not_jumped_over(
    beta: str, epsilon: str, start: fmpq, open_sign: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The search goes outward by powers of two; a sign that stays open behind the zero must not move it on."""
    found = slow_zeros(beta, epsilon, digits=6)
    assert found.column is not None
    before = ColumnPiece(Kind.SIGN, start - 1, start, 1)
    pieces = (ColumnPiece(Kind.LEFT, None, start - 1), before, ColumnPiece(Kind.RIGHT, start, None, 1))
    column = Column(found.beta, found.beta, pieces)
    with working_bits(100):
        zero = sum(ends(found.places[-1] * scale(found.epsilon)), Fraction(0)) / 2
    assert to_fraction(start) < zero
    first = max(2 * start, fmpq(1))
    while to_fraction(first) < zero:
        first *= 2
    if open_sign:
        monkeypatch.setattr(module, "_sign", opened(module._sign, lambda tau: tau == first))
    (place,) = zero_places(found.beta, found.epsilon, column, 20)
    assert place.contains(found.places[-1].mid()) or place.overlaps(found.places[-1])
    with working_bits(100):
        assert (place * scale(found.epsilon)).rad() < arb(10) ** -20
    assert changes_sign(place, found.beta, found.epsilon)


def test_the_places_of_a_polynomial_are_its_real_zeros_in_order() -> None:
    """F_3 = 4/epsilon - T^3, F_2 = T^2; F_4 has two, one or none."""
    (cube,) = polynomial_places(3, fmpq(1, 2), 20)
    assert cube.contains(2)
    (square,) = polynomial_places(2, fmpq(1, 2), 20)
    assert square.contains(0)
    low, high = polynomial_places(4, fmpq(1), 20)
    assert low < high
    assert all(ball.rad() < arb(10) ** -20 for ball in (cube, low, high))
    assert polynomial_places(4, fmpq(40), 20) == []


def polynomial_with(*roots: arb) -> Any:
    """What has these roots and one that is not real."""
    return lambda *_: SimpleNamespace(complex_roots=lambda: [*((acb(root), 1) for root in roots), (acb(0, 1), 1)])


def test_zeros_come_in_order_also_where_floats_see_no_difference(monkeypatch: pytest.MonkeyPatch) -> None:
    with working_bits(200):
        roots = [arb(2), 1 + arb((1, -80)), arb(1)]
    monkeypatch.setattr(module, "force_polynomial", polynomial_with(*roots))
    found = polynomial_places(3, fmpq(1), 40)
    assert len(found) == 3
    assert found[0] < found[1] < found[2]


def test_zeros_that_are_not_apart_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "force_polynomial", polynomial_with(arb(1), arb(1, "0.1")))
    with pytest.raises(ArithmeticError, match="not isolated"):
        polynomial_places(3, fmpq(1), 5)
