"""The rings of numbers: exact where they say so, enclosures elsewhere, refusals at the rest."""

from __future__ import annotations

import pytest
from flint import arb, arb_poly, fmpq, fmpq_poly
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import holds, to_fraction

from gspot_verified.functions.linear import inverse, solve_from_above
from gspot_verified.functions.rings import BALLS, RATIONALS
from gspot_verified.functions.symbols import Symbols


def test_rational_functions_at_rational_values() -> None:
    assert RATIONALS.sine_cosine(fmpq(0)) == (0, 1)
    assert RATIONALS.exponential(fmpq(0)) == 1
    assert RATIONALS.logarithm(fmpq(1)) == 0
    for function in (RATIONALS.sine_cosine, RATIONALS.exponential, RATIONALS.logarithm):
        with pytest.raises(ValueError, match="use balls"):
            function(fmpq(1, 2))


@pytest.mark.parametrize(
    ("base", "exponent", "expected"),
    [
        (fmpq(4, 9), fmpq(1, 2), fmpq(2, 3)),
        (fmpq(4, 9), fmpq(-3, 2), fmpq(27, 8)),
        (fmpq(-2, 3), fmpq(-3), fmpq(-27, 8)),
        (fmpq(10**60), fmpq(1, 3), fmpq(10**20)),
        (fmpq(7**35, 2**70), fmpq(2, 35), fmpq(49, 16)),
        (fmpq(1), fmpq(5, 7), fmpq(1)),
    ],
)
def test_rational_powers(base: fmpq, exponent: fmpq, expected: fmpq) -> None:
    assert RATIONALS.power(base, exponent) == expected


@pytest.mark.parametrize("base", [fmpq(2), fmpq(-4), fmpq(4, 3), fmpq(10**60 + 1)])
def test_roots_that_are_not_rational(base: fmpq) -> None:
    with pytest.raises(ValueError, match="not rational"):
        RATIONALS.power(base, fmpq(1, 2))


def test_a_base_that_may_vanish() -> None:
    with pytest.raises(ValueError, match="vanish"):
        RATIONALS.power(fmpq(0), fmpq(1, 2))
    with pytest.raises(ValueError, match="vanish"):
        BALLS.power(arb(0, 1), fmpq(-1))
    with pytest.raises(ValueError, match="vanish"):
        BALLS.power(arb(-4), fmpq(1, 2))
    assert BALLS.power(arb(-2), fmpq(-3)) == arb(-1) / 8


def test_zero_nonzero_negative() -> None:
    wide = arb(0, 1)
    assert (BALLS.is_zero(wide), BALLS.is_nonzero(wide), BALLS.is_negative(wide)) == (False, False, False)
    assert (BALLS.is_zero(arb(0)), BALLS.is_nonzero(arb(0))) == (True, False)
    assert (BALLS.is_nonzero(arb(-2)), BALLS.is_negative(arb(-2))) == (True, True)
    assert not BALLS.is_negative(arb.nan())
    assert not BALLS.is_nonzero(arb.nan())
    assert (RATIONALS.is_zero(fmpq(0)), RATIONALS.is_nonzero(fmpq(0)), RATIONALS.is_negative(fmpq(-1))) == (
        True,
        False,
        True,
    )


def test_balls_enclose() -> None:
    sine, cosine = BALLS.sine_cosine(arb(fmpq(1, 3)))
    assert (sine * sine + cosine * cosine).contains(1)
    assert (BALLS.exponential(arb(2)) * BALLS.exponential(arb(-2))).contains(1)
    assert (BALLS.power(arb(3), fmpq(1, 3)) ** 3).contains(3)


def test_symbols() -> None:
    ring = Symbols("a", "b")
    a, b = ring.symbol("a"), ring.symbol("b")
    assert (a * a - b * b) / (a + b) == a - b
    assert ring.is_zero((a + b) * (a - b) - a * a + b * b)
    assert ring.power(a, fmpq(-2)) * a * a == ring.number(1)
    for bad in (lambda: ring.power(a, fmpq(1, 2)), lambda: ring.exponential(a), lambda: ring.sine_cosine(a)):
        with pytest.raises(ValueError, match="symbols"):
            bad()


def test_inverse() -> None:
    matrix = [[fmpq(0), fmpq(2), fmpq(1)], [fmpq(1), fmpq(1, 3), fmpq(0)], [fmpq(-1), fmpq(5), fmpq(7)]]
    found = inverse(matrix, RATIONALS)
    product = [[sum((a * c for a, c in zip(row, column, strict=True)), fmpq(0)) for column in zip(*found, strict=True)]
               for row in matrix]  # fmt: skip
    assert product == [[int(i == j) for j in range(3)] for i in range(3)]
    balls = inverse([[arb(value) for value in row] for row in matrix], BALLS)
    assert all(ball.contains(value) for row, other in zip(balls, found, strict=True)
               for ball, value in zip(row, other, strict=True))  # fmt: skip


@pytest.mark.parametrize("last", [fmpq(4), fmpq(4) + 0])
def test_singular(last: fmpq) -> None:
    with pytest.raises(ZeroDivisionError):
        inverse([[fmpq(1), fmpq(2)], [fmpq(2), last]], RATIONALS)
    with pytest.raises(ZeroDivisionError):
        inverse([[arb(1), arb(2)], [arb(2), arb(4, 1)]], BALLS)


def test_logarithms() -> None:
    ring = Symbols("k")
    assert ring.logarithm(ring.number(1)) == 0
    with pytest.raises(ValueError, match="of log be 1"):
        ring.logarithm(ring.symbol("k"))
    assert BALLS.logarithm(arb(2)).overlaps(arb.const_log2())
    for value in (arb(0), arb(-1), arb(1, 2)):
        with pytest.raises(ValueError, match="may not be positive"):
            BALLS.logarithm(value)


numbers = st.fractions(-9, 9, max_denominator=12).map(lambda value: fmpq(value.numerator, value.denominator))
nonzero = numbers.filter(lambda value: value != 0)


@given(st.lists(st.tuples(nonzero, numbers), min_size=1, max_size=6), st.lists(numbers, max_size=6))
def test_two_diagonals(diagonals: list[tuple[fmpq, fmpq]], right: list[fmpq]) -> None:
    """Exact and in balls, with the equations as the judge."""
    size = len(diagonals)
    right = right[:size]
    diagonal, above = (list(values) for values in zip(*diagonals, strict=True))
    found = solve_from_above(fmpq_poly(right), diagonal, above, RATIONALS)
    assert found.length() <= size
    for i in range(size):
        rest = above[i] * found[i + 1] if i + 1 < size else 0
        assert diagonal[i] * found[i] + rest == (right[i] if i < len(right) else 0)
    balls = [[arb(value) for value in values] for values in (right, diagonal, above)]
    enclosed = solve_from_above(arb_poly(balls[0]), balls[1], balls[2], BALLS)
    for i in range(size):
        assert enclosed[i].is_finite()
        assert holds(enclosed[i], to_fraction(found[i]))


def test_two_diagonals_with_symbols() -> None:
    ring = Symbols("chi")
    chi, one = ring.symbol("chi"), ring.number(1)
    found = solve_from_above(ring.polynomial([one]), [chi, chi + one], [one, chi], ring)
    assert found.coeffs() == [one / chi]
    found = solve_from_above(ring.polynomial([one, chi]), [chi, chi], [one, chi], ring)
    assert found.coeffs() == [ring.number(0), one]
