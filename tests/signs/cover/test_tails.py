"""Tests of what proofs/signs.md and proofs/tails.md state."""

from __future__ import annotations

import itertools
import math
from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from samples.piece_samples import sign_of_f
from samples.strategies import to_fmpq

from gspot_verified.signs.cover.column_models import ColumnModels
from gspot_verified.signs.cover.tails import changes_of_sign, left_holds, left_threshold, right_changes


@st.composite
def part_of_a_cell(draw: st.DrawFn, first: int = -1, last: int = 30) -> tuple[int, Fraction, Fraction]:
    n = draw(st.integers(first, last))
    shares = sorted(draw(st.lists(st.fractions(0, 1, max_denominator=40), min_size=2, max_size=2)))
    return n, n + shares[0], n + shares[1]


@given(part_of_a_cell(), st.fractions(Fraction(1, 50), 40, max_denominator=50))
def test_the_left_inequality_in_fractions(cell: tuple[int, Fraction, Fraction], x: Fraction) -> None:
    n, lower, upper = cell
    terms = max(1, math.floor(Fraction(n, 3)) + 1)
    assert 3 * terms >= n + 1
    size = math.prod((max(abs(lower - i), abs(upper - i)) for i in range(3 * terms)), start=Fraction(1))
    holds = x ** (3 * terms) * 3**terms * math.factorial(terms) > size
    assert left_holds(to_fmpq(x), to_fmpq(lower), to_fmpq(upper), n) == holds


@settings(max_examples=25)
@given(part_of_a_cell(last=20), st.integers(1, 16), st.fractions(0, 50, max_denominator=20), st.integers(0, 8))
def test_left_of_the_threshold_f_is_positive(
    cell: tuple[int, Fraction, Fraction], denominator: int, beyond: Fraction, share: int
) -> None:
    n, lower, upper = cell
    x = left_threshold(to_fmpq(lower), to_fmpq(upper), n, denominator)
    assert left_holds(x, to_fmpq(lower), to_fmpq(upper), n)
    if x > fmpq(1, denominator):
        assert not left_holds(x - fmpq(1, denominator), to_fmpq(lower), to_fmpq(upper), n)
    b = to_fmpq(lower + (upper - lower) * Fraction(share, 8))
    assert sign_of_f(-x, b) == 1
    assert sign_of_f(-x - to_fmpq(beyond), b) == 1


@pytest.mark.parametrize(
    ("x", "lower", "upper", "n"),
    [(1, 0, 1, -1), (1, -2, -1, -2), (0, 0, 1, 0), (-1, 0, 1, 0), (1, 1, 0, 0), (1, fmpq(1, 2), fmpq(3, 2), 0)],
)
def test_left_refuses_what_the_page_does_not_cover(x: int, lower: fmpq, upper: fmpq, n: int) -> None:
    with pytest.raises(ValueError, match="expected n >= -1"):
        left_holds(fmpq(x), fmpq(lower), fmpq(upper), n)


def plain_changes(signs: tuple[int, ...]) -> int:
    """Changes of sign with zeros left out."""
    rest = [sign for sign in signs if sign]
    return sum(a != b for a, b in itertools.pairwise(rest))


@pytest.mark.parametrize("length", range(1, 7))
def test_changes_equal_those_of_every_completion(length: int) -> None:
    for signs in itertools.product((-1, None, 1), repeat=length):
        found = changes_of_sign(signs)
        completions = itertools.product(*([sign] if sign else [-1, 0, 1] for sign in signs))
        counts = {plain_changes(completion) for completion in completions}
        if found is not None:
            assert counts == {found}
            assert signs[0]
        elif None not in signs:
            pytest.fail(f"no open sign, no answer: {signs}")
        assert found == changes_of_sign([sign or 0 for sign in signs])


@settings(max_examples=25)
@given(part_of_a_cell(first=0, last=9), st.fractions(0, 9, max_denominator=8), st.integers(0, 8))
def test_right_changes_against_values_of_the_derivatives(
    cell: tuple[int, Fraction, Fraction], tau: Fraction, share: int
) -> None:
    n, lower, upper = cell
    found = ColumnModels(to_fmpq(lower), to_fmpq(upper), fmpq(9)).changes(to_fmpq(tau), n)
    assume(found is not None)
    b = to_fmpq(lower + (upper - lower) * Fraction(share, 8))
    signs = [sign_of_f(to_fmpq(tau), b, k) or 0 for k in range(n + 1)]
    assert signs[0]
    assert plain_changes((*signs, (-1) ** (n + 1))) == found
    # What the page concludes, at points far beyond T.
    beyond = [sign_of_f(to_fmpq(tau + Fraction(k, 4)), b) for k in range(0, 100, 7)]
    if found < 2 and n < b:
        assert plain_changes(tuple(sign or 0 for sign in beyond)) <= found
    if found == 0:
        assert set(beyond) == {(-1) ** (n + 1)}


def test_right_needs_a_range_inside_the_cell() -> None:
    for n in (-1, 0, 1):
        with pytest.raises(ValueError, match="inside"):
            right_changes([arb(1)] * (n + 1), fmpq(1, 2), fmpq(3, 2), n)
    # A coefficient too few or too many is another question.
    for count in (2, 4):
        with pytest.raises(ValueError, match="n \\+ 1 coefficients"):
            right_changes([arb(1)] * count, fmpq(2), fmpq(3), 2)
    assert right_changes([arb(1), arb(0, 1), arb(-1)], fmpq(2), fmpq(3), 2) == 1
    assert right_changes([arb(1), arb(0, 1), arb(1)], fmpq(2), fmpq(3), 2) is None


@pytest.mark.parametrize("n", range(1, 8))
def test_next_to_the_integer_from_above_one_zero_is_far_out(n: int) -> None:
    # A column that touches b = n from above never has v = 0.
    above = ColumnModels(fmpq(n), n + fmpq(1, 16), fmpq(12))
    assert all(above.changes(fmpq(k), n) != 0 for k in range(1, 12))
    assert ColumnModels(n - fmpq(1, 2**13), fmpq(n), fmpq(12)).changes(fmpq(8), n - 1) == 0
