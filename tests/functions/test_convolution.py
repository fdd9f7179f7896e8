"""Products of series term by term, over every ring, and what a series keeps."""

from __future__ import annotations

import pytest
from flint import arb, fmpq
from samples.strategies import holds, to_fraction

from gspot_verified.expansion.series.terms import NumberTerms
from gspot_verified.functions.convolution import Series, TermByTerm
from gspot_verified.functions.rings import BALLS, RATIONALS

LEFT, RIGHT = [fmpq(2), fmpq(0), fmpq(-1, 3), fmpq(5)], [fmpq(1), fmpq(1, 2), fmpq(7)]


def series_of(values: list[fmpq]) -> Series:
    series = Series(RATIONALS.is_zero)
    for value in values:
        series.append(value)
    return series


def test_a_series_knows_which_terms_vanish() -> None:
    series = series_of(LEFT)
    assert series.terms == LEFT
    assert series.nonzero == {0: 2, 2: fmpq(-1, 3), 3: 5}
    for count in (3, 2, 1):
        series.drop_last()
        assert series.terms == LEFT[:count]
        assert list(series.nonzero) == [n for n in (0, 2) if n < count]
    series.append(fmpq(4))
    assert series.nonzero == {0: 2, 1: 4}


@pytest.mark.parametrize("weights", [None, (fmpq(1), fmpq(0)), (fmpq(1, 2), fmpq(-1))])
def test_numbers(weights: tuple[fmpq, fmpq] | None) -> None:
    """Order 3 lacks the product with the right term of order 3, which is not known."""
    a, b = weights or (0, 0)
    product = TermByTerm(series_of(LEFT), series_of(RIGHT), NumberTerms(RATIONALS), RATIONALS, weights)
    balls = []
    for values in (LEFT, RIGHT):
        balls.append(Series(BALLS.is_zero))
        for value in values:
            balls[-1].append(arb(value))
    enclosed = TermByTerm(balls[0], balls[1], NumberTerms(BALLS), BALLS, weights)
    for n in range(4):
        expected = sum(
            (
                (1 if weights is None else a * j + b * (n - j)) * LEFT[j] * RIGHT[n - j]
                for j in range(n + 1)
                if n - j < 3
            ),
            start=fmpq(0),
        )
        assert product(n) == expected
        assert holds(enclosed(n), to_fraction(expected))
