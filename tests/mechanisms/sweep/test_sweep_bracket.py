"""Brackets of a monotone quantity: x - a along x^2 = λ, whose zero is λ = a^2.

Page: proofs/sweep.md, section 4.
"""

from __future__ import annotations

import pytest
from flint import fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Constant, Expression, Variable
from gspot_verified.mechanisms.sweep import sweep_bracket
from gspot_verified.mechanisms.sweep.sweep_bracket import Cut, bracket
from gspot_verified.mechanisms.sweep.sweep_start import Origin, proved_tube
from gspot_verified.mechanisms.zeros.tube import Equations, OnTube, Quantity
from gspot_verified.numbers.balls import working_bits

X, PARAMETER = Variable(0), Variable(1)
LOWER, UPPER = fmpq(1), fmpq(2)


def first(on: OnTube) -> Quantity:
    return on.quantities[0]


def cut(quantity: Expression, digits: int = 10) -> Cut | None:
    """On λ in [1, 2], where x lies in [1, 1.42]."""
    equations = Equations(BoxProgram([X * X - PARAMETER, quantity], 2), 1)
    with working_bits(80):
        on = proved_tube(equations, (LOWER,), (UPPER,), Origin((fmpq(3, 2),), (fmpq(5, 4),), ((fmpq(2, 5),),)))
        assert on is not None
        return bracket(equations, on, first, digits)


def number(value: fmpq) -> Expression:
    return Constant(value)


@pytest.mark.parametrize("digits", [1, 3, 10, 15])
@pytest.mark.parametrize("sign", [1, -1])
def test_a_zero_inside(digits: int, sign: int) -> None:
    found = cut(number(fmpq(sign)) * (X - number(fmpq(5, 4))), digits)
    assert found is not None
    assert found.ends is not None
    assert found.ends[0] < fmpq(25, 16) < found.ends[1]
    assert found.ends[1] - found.ends[0] < 3 * fmpq(1, 10**digits)
    assert (found.direction, found.signs, found.before, found.after) == (sign, (-sign, sign), -sign, sign)


@pytest.mark.parametrize(("shift", "sign"), [(fmpq(-1, 2), 1), (fmpq(-3), -1)])
def test_one_sign_all_along(shift: fmpq, sign: int) -> None:
    for factor in (1, -1):
        found = cut(number(fmpq(factor)) * (X + number(shift)))
        assert found is not None
        assert found.ends is None
        assert found.signs == (sign * factor,)


def test_a_zero_at_an_end_is_left_open_there() -> None:
    found = cut(X - number(fmpq(1)))
    assert found is not None
    assert found.ends is not None
    assert found.ends[0] == LOWER
    assert (found.before, found.after, found.signs) == (None, 1, (-1, 1))


def test_ends_whose_signs_are_not_certain_are_refused() -> None:
    """A bracket of 10^-40 at 80 bits: the balls at its ends hold 0."""
    assert cut(X - number(fmpq(5, 4)), digits=40) is None


@pytest.mark.parametrize(
    "quantity",
    [
        (X - number(fmpq(5, 4))) * (X - number(fmpq(5, 4))),
        X * X - PARAMETER,
        number(fmpq(1)) / (X - number(fmpq(5, 4))),
    ],
)
def test_what_is_not_certainly_monotone_is_not_cut(quantity: Expression) -> None:
    assert cut(quantity) is None


@pytest.mark.parametrize(
    ("ends", "right"),
    [
        ((fmpq(3, 2), fmpq(7, 4)), True),
        ((fmpq(13, 8), fmpq(7, 4)), False),
        ((fmpq(5, 4), fmpq(3, 2)), False),
        ((LOWER, fmpq(7, 4)), True),
        ((fmpq(3, 2), UPPER), True),
        ((LOWER, fmpq(3, 2)), False),
        ((fmpq(13, 8), UPPER), False),
    ],
)
def test_a_bracket_holds_the_zero_whatever_was_guessed(
    ends: tuple[fmpq, fmpq], right: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The zero is 25/16, between 3/2 and 13/8. Where to look for it is a free choice."""
    monkeypatch.setattr(sweep_bracket, "_ends", lambda *_: ends)
    found = cut(X - number(fmpq(5, 4)))
    assert found == (Cut(ends, (-1, 1), 1, -1, 1) if right else None)


def test_where_nothing_was_guessed_nothing_is_cut(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sweep_bracket, "_ends", lambda *_: None)
    assert cut(X - number(fmpq(5, 4))) is None
    assert cut(X - number(fmpq(1, 2))) == Cut(None, (1,), 1)
