from __future__ import annotations

from fractions import Fraction

import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.signs.cover.cuts import middle, middle_from_integers


def exact(value: Fraction) -> fmpq:
    return fmpq(value.numerator, value.denominator)


@given(st.integers(0, 30), st.fractions(0, 1), st.fractions(0, 1))
def test_a_cut_is_inside(n: int, one: Fraction, two: Fraction) -> None:
    lower, upper = n + exact(min(one, two)), n + exact(max(one, two))
    if lower < upper:
        assert lower < middle(lower, upper) < upper
        assert lower < middle_from_integers(lower, upper) < upper


@given(st.integers(1, 300), st.integers(0, 300))
def test_both_sides_of_an_integer_are_alike(k: int, further: int) -> None:
    near, far = (fmpq(0) if not further else fmpq(1, 2 ** (k + further))), fmpq(1, 2**k)
    right, left = middle_from_integers(5 + near, 5 + far), middle_from_integers(5 - far, 5 - near)
    if k > 1:  # (5, 11/2) and (9/2, 5) have two nearest integers
        assert right - 5 == 5 - left


@pytest.mark.parametrize("exponent", [2, 4, 64, 1000])
def test_few_cuts_reach_a_short_distance(exponent: int) -> None:
    """Halving would need as many cuts as the exponent says."""
    far, cuts = fmpq(1, 4), 0
    while far > fmpq(1, 2**exponent):
        far = middle_from_integers(fmpq(7), 7 + far) - 7
        cuts += 1
    assert cuts <= exponent.bit_length()
    lower, upper = fmpq(7) + fmpq(1, 2**exponent), fmpq(29, 4)
    cuts = 0
    while upper - 7 >= 4 * (lower - 7):
        upper = middle_from_integers(lower, upper)
        cuts += 1
    assert cuts <= exponent.bit_length()


def test_a_range_that_is_never_settled_keeps_short_ends() -> None:
    """A cut doubles the length of an end; that must come to an end."""
    far = fmpq(1, 4)
    for _ in range(40):
        far = middle_from_integers(fmpq(7), 7 + far) - 7
    assert int(far.q).bit_length() < 5000


@pytest.mark.parametrize(
    ("lower", "upper", "cut"),
    [
        ("3", "49/16", "769/256"), ("13/4", "7/2", "27/8"), ("47/16", "3", "767/256"), ("3", "4", "7/2"),
        ("769/256", "49/16", "193/64"), ("3", "7/2", "13/4"), ("25/8", "4", "57/16"),
        ("3", "13/4", "49/16"), ("15/4", "4", "63/16"), ("49/16", "13/4", "25/8"),
    ],
)  # fmt: skip
def test_cuts(lower: str, upper: str, cut: str) -> None:
    ends = [exact(Fraction(end)) for end in (lower, upper)]
    assert middle_from_integers(*ends) == exact(Fraction(cut))
