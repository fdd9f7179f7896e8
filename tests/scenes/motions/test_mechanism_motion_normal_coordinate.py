"""Which components y and v take the place of: linear with a rational factor, the first pair that works, and back."""

from __future__ import annotations

import pytest
from flint import fmpq

from gspot_verified.functions.expressions import Constant, Expression, Variable
from gspot_verified.scenes.floats.float_function import float_function
from gspot_verified.scenes.motions.mechanism_motion import NormalCoordinate, free_slope

q, h, w, s = (Variable(i) for i in range(4))


def number(value: int) -> Constant:
    return Constant(fmpq(value))


def made(y: Expression, v: Expression) -> NormalCoordinate:
    found = NormalCoordinate.of(y, v, 4)
    assert found is not None
    return found


def test_the_pair_and_its_factors() -> None:
    found = made(q * q + number(3) * h, h * q + number(-2) * s)
    assert (found.place, found.velocity, found.slope, found.rate_slope) == (1, 3, 3, -2)


def test_the_components_are_those_that_give_y_and_v() -> None:
    """y = q^2 + 3 h and v = q h - 2 s, solved for h and s at a point and put in again."""
    found = made(q * q + number(3) * h, h * q + number(-2) * s)
    y, v = Constant(fmpq(1, 7)), Constant(fmpq(5, 3))
    solved = found.solved(y, v)
    place, velocity = float_function([solved[h], solved[s]])([0.5, 99.0, -1.0, 99.0])
    assert place == pytest.approx((1 / 7 - 0.25) / 3)
    assert velocity == pytest.approx((5 / 3 - 0.5 * place) / -2)


@pytest.mark.parametrize(
    ("y", "v"),
    [
        (h * h, s),  # y is not linear
        (q * h, s),  # its factor is not constant
        (h, s * s),
        (h + s, s),  # y depends on the velocity
        (h, h),  # one component for both
        (number(3), s),
        (h, number(3)),
    ],
)
def test_contacts_without_a_free_translation_have_none(y: Expression, v: Expression) -> None:
    assert NormalCoordinate.of(y, v, 4) is None


def test_the_first_pair_that_works_is_taken() -> None:
    """v = h + s: not h, which y takes; v = q + s: q comes first."""
    assert made(h, h + s).velocity == 3
    assert made(h, q + s).velocity == 0
    assert made(h + w, s).place == 1


def test_a_slope_is_a_rational_number_other_than_zero() -> None:
    assert free_slope(number(3) * h + q, 1, 4) == 3
    assert free_slope(number(3) * h + q, 2, 4) is None
    assert free_slope(h * q, 1, 4) is None
