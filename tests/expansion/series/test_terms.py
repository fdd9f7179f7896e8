"""Sums of fractions on one denominator, against fmpq_poly; products by blocks (proofs/expansion.md)."""

from __future__ import annotations

import random

import pytest
from flint import fmpq, fmpq_poly, fmpz, fmpz_poly
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.expansion.series import terms
from gspot_verified.expansion.series.spaces import SpacePolynomial
from gspot_verified.expansion.series.terms import BlockConvolution, sum_of_fractions
from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.functions.convolution import Series, Weights
from gspot_verified.mechanisms.shipped import shipped_system

fractions = st.tuples(st.lists(st.integers(-9, 9), max_size=4).map(fmpz_poly), st.integers(1, 40).map(fmpz))


@given(st.lists(fractions, max_size=6))
def test_the_sum_on_the_least_common_multiple(summands: list[tuple[fmpz_poly, fmpz]]) -> None:
    expected, common = fmpq_poly([]), fmpz(1)
    for above, below in summands:
        expected += fmpq_poly(above, below)
        common = common.lcm(below)
    numerator, denominator = sum_of_fractions(iter(summands))
    assert fmpq_poly(numerator, denominator) == expected
    assert denominator == common


# Products of series by blocks of orders: against the plain sums in fmpq_poly, and against the same recursion without.


WEIGHTS: tuple[Weights | None, ...] = (
    None,
    (fmpq(-1), fmpq(-1)),
    (fmpq(1), fmpq(0)),
    (fmpq(0), fmpq(-2, 3)),
    (fmpq(1, 2), fmpq(-1)),
)


def small_blocks(patch: pytest.MonkeyPatch, length: int = 6, start: int = 12) -> None:
    patch.setattr(terms, "_LENGTH", length)
    patch.setattr(terms, "_FROM", start)


def random_term(n: int, c: int, draw: random.Random) -> SpacePolynomial:
    """An element with exponents of the class c, of any degree up to n."""
    first = (c - n) % 3
    index = first + 3 * draw.randrange(-1, n // 3 + 1)
    if index < 0:
        return SpacePolynomial.zero(-1)
    values = [fmpq(0)] * (index + 1)
    for k in range(first, index + 1, 3):
        values[k] = fmpq(draw.randint(-9, 9), draw.choice((1, 2, 3, 5, 2 * n + 1)))
    return SpacePolynomial.from_list(index, list(values))


def plain(term: SpacePolynomial) -> fmpq_poly:
    return fmpq_poly(term.coefficients())


def plain_sum(left: Series, right: Series, n: int, weights: Weights | None) -> fmpq_poly:
    a, b = weights or (fmpq(0), fmpq(0))
    total = fmpq_poly([])
    for j in range(n + 1):
        if j < len(left.terms) and n - j < len(right.terms):
            weight = fmpq(1) if weights is None else a * j + b * (n - j)
            total += plain(left.terms[j]) * plain(right.terms[n - j]) * weight
    return total


@given(st.integers(0, 2), st.integers(0, 2), st.integers(0, 10**6), st.sampled_from(WEIGHTS), st.booleans())
def test_every_order_is_the_plain_sum(c: int, d: int, seed: int, weights: Weights | None, square: bool) -> None:
    """Terms come one order at a time; the right one of order n comes after the sum of order n."""
    draw = random.Random(seed)
    left = Series(SpacePolynomial.is_zero)
    right = left if square else Series(SpacePolynomial.is_zero)
    gaps = [draw.random() < 0.3 for _ in range(4)]
    with pytest.MonkeyPatch.context() as patch:
        small_blocks(patch)
        product = BlockConvolution(left, right, weights)
        for n in range(31):
            empty = gaps[n // 6 % 4] and n > 1
            left.append(SpacePolynomial.zero(-1) if empty else random_term(n, c, draw))
            assert plain(product(n)) == plain_sum(left, right, n, weights), n
            if not square:
                right.append(random_term(n, d, draw))
        assert square or plain(product(30)) == plain_sum(left, right, 30, weights)


def test_the_blocks_in_use() -> None:
    """With the lengths of the package: orders 108 to 111 take from the rows 5 and 6."""
    draw = random.Random(5)
    left, right = Series(SpacePolynomial.is_zero), Series(SpacePolynomial.is_zero)
    for n in range(112):
        left.append(random_term(n, 1, draw))
        right.append(random_term(n, 2, draw))
    product = BlockConvolution(left, right, (fmpq(1, 2), fmpq(-1)))
    for n in (0, 71, 72, 89, 90, 107, 108, 111):
        assert plain(product(n)) == plain_sum(left, right, n, (fmpq(1, 2), fmpq(-1))), n


def test_what_is_forgotten_is_made_again(monkeypatch: pytest.MonkeyPatch) -> None:
    small_blocks(monkeypatch)
    draw = random.Random(1)
    series = Series(SpacePolynomial.is_zero)
    product = BlockConvolution(series, series)
    for n in range(26):
        series.append(random_term(n, 0, draw))
        product(n)
    for n in range(25, 15, -1):
        series.drop_last()
        product.forget(n)
    for n in range(16, 26):
        series.append(random_term(n, 0, draw))
        assert plain(product(n)) == plain_sum(series, series, n, None), n


def test_unknown_terms_and_terms_in_a_wrong_class_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    small_blocks(monkeypatch)
    left, right = Series(SpacePolynomial.is_zero), Series(SpacePolynomial.is_zero)
    product = BlockConvolution(left, right)
    with pytest.raises(ValueError, match="below order 1 must be known"):
        product(1)
    for n in range(24):
        smallest = -n % 3
        for series in (left, right):
            series.append(SpacePolynomial.from_list(smallest, [0] * smallest + [n + 1]))
    assert plain(product(23)) == plain_sum(left, right, 23, None)
    product.forget(0)
    right.terms[7] = right.nonzero[7] = SpacePolynomial.from_list(0, [1])  # 0 + 7 is not 0 mod 3
    with pytest.raises(ValueError, match="no place at order 7"):
        product(7)
    with pytest.raises(ValueError, match="an element of P_0 has no place at order 7"):
        product(18)


def test_expansions_with_blocks_and_without(monkeypatch: pytest.MonkeyPatch) -> None:
    """Sines, cosines and powers of both kinds of weights, exact to the last digit."""
    system = shipped_system("oscillator")
    without = expand_system(system, 30).terms()
    small_blocks(monkeypatch)
    assert expand_system(system, 30).terms() == without
