"""Polynomials with balls as coefficients hold those of all polynomials in them: proofs/from_state.md, section 8."""

from __future__ import annotations

import random
from typing import Any

import pytest
from flint import Ordering, arb, fmpq, fmpq_mpoly, fmpq_mpoly_ctx, fmpz
from flint.utils.flint_exceptions import DomainError

from gspot_verified.functions.ball_polynomials import BallPolynomial, ball_polynomial, constant, polynomial_of
from gspot_verified.numbers.balls import ball, working_bits

RING = fmpq_mpoly_ctx.get(("x", "y"), Ordering.lex)
X, Y = RING.gens()
Terms = dict[tuple[int, int], fmpq]


def holds(found: BallPolynomial, exact: fmpq_mpoly) -> bool:
    """Every coefficient, also those that are 0."""
    values, wanted = found.to_dict(), exact.to_dict()
    return all(ball(values.get(key, fmpq(0))).contains(wanted.get(key, fmpq(0))) for key in {*values, *wanted})


def drawn(draw: random.Random, count: int) -> tuple[fmpq_mpoly, BallPolynomial]:
    """A polynomial, and one with balls around its coefficients, of which some are exact."""
    exact, wide = Terms(), dict[tuple[int, int], Any]()
    for _ in range(count):
        key, value = (draw.randint(0, 3), draw.randint(0, 3)), fmpq(draw.randint(-99, 99), draw.randint(1, 9))
        exact[key] = value
        shift = fmpq(draw.randint(-9, 9), 10**4)
        wide[key] = value if draw.random() < 0.3 else arb(value + shift, abs(shift) + fmpq(1, 10**9))
    return RING.from_dict(exact), ball_polynomial(RING, wide)


def test_what_is_made_of_polynomials_holds_what_is_made_of_those_in_them() -> None:
    draw = random.Random(5)
    with working_bits(128):
        for _ in range(100):
            (a, first), (b, second) = drawn(draw, 5), drawn(draw, 4)
            number = fmpq(draw.randint(1, 9), 7)
            about = arb(number, "1e-9")
            for found, exact in (
                (first + second, a + b), (first - second, a - b), (first * second, a * b), (-first, -a),
                (first + b, a + b), (b + first, a + b), (first - b, a - b), (b - first, b - a), (b * first, a * b),
                (first * number, a * number), (number - first, number - a), (first / number, a / number),
                (first / 3, a / 3), (first * about, a * number), (first / about, a / number),
                (about * first, a * number), (first**3, a**3), (first**0, a**0), ((first * X * Y) / X, a * Y),
                (first.derivative(0), a.derivative(0)), (first.derivative(1), a.derivative(1)),
                ((first * second).only(lambda i, j: i + j < 4),
                 RING.from_dict({key: value for key, value in (a * b).to_dict().items() if sum(map(int, key)) < 4})),
            ):  # fmt: skip
                assert holds(found, exact)


def test_a_bound_is_no_larger_than_rounding_needs() -> None:
    """(2 +- 1/8) x times (3 +- 1/4) x, and what one of them is exact in."""
    first, second = ball_polynomial(RING, {(1, 0): arb(2, 0.125)}), ball_polynomial(RING, {(1, 0): arb(3, 0.25)})
    ((_, radius),) = (first * second).radius.to_dict().items()
    assert 0 <= radius - (fmpq(2, 4) + fmpq(3, 8) + fmpq(1, 32)) < fmpq(1, 10**8)
    assert (first * second).middle == 6 * X**2
    rounded = ball_polynomial(RING, {(0, 0): arb(2).sqrt()}).only(lambda *_: True)
    assert 0 < rounded.radius.to_dict()[0, 0] < fmpq(1, 2**50)
    assert abs(rounded.middle.to_dict()[0, 0] ** 2 - 2) < fmpq(1, 2**48)


def test_exact_terms_cancel_and_others_do_not() -> None:
    third, root = fmpq(1, 3), arb(2).sqrt()
    one = ball_polynomial(RING, {(0, 1): third, (1, 0): root})
    assert set((one - third * Y).to_dict()) == {(1, 0)}
    assert set((one - one).to_dict()) == {(1, 0)}
    assert ball((one - one).to_dict()[1, 0]).contains(0)
    assert not (one - one).is_zero()
    assert (one - one).only(lambda i, _: i == 0).is_zero()
    assert one.to_dict()[0, 1] == third


def test_numbers_are_exact_polynomials_where_they_are_exact() -> None:
    assert constant(RING, fmpq(2, 3)) == RING.constant(fmpq(2, 3))
    assert isinstance(constant(RING, arb(2)), BallPolynomial)
    assert polynomial_of(RING, {(1, 1): fmpq(2)}) == 2 * X * Y
    assert isinstance(polynomial_of(RING, {(1, 1): fmpq(2), (0, 0): arb(1, 0.5)}), BallPolynomial)


@pytest.mark.parametrize("divisor", [-3, fmpz(-3), fmpq(-3), arb(-3)])
def test_a_radius_over_a_negative_number_is_positive(divisor: Any) -> None:
    found = ball_polynomial(RING, {(1, 0): arb(2, 0.125)}) / divisor
    ((_, radius),) = found.radius.to_dict().items()
    assert fmpq(1, 24) <= radius < fmpq(1, 23)
    assert abs(found.middle.to_dict()[1, 0] + fmpq(2, 3)) < fmpq(1, 10**8)


def test_what_is_no_polynomial_is_an_error() -> None:
    one = ball_polynomial(RING, {(1, 0): arb(1, 0.5), (0, 1): fmpq(1)})
    with pytest.raises(DomainError):
        one / X
    with pytest.raises(ValueError, match="coefficient 1"):
        one * X / (-X)
    with pytest.raises(ValueError, match="not finite"):
        ball_polynomial(RING, {(0, 0): arb("nan")})
    with pytest.raises(ValueError, match="not finite"):
        one / arb(0)
