"""Packed intervals come back as they were, and are equal where the intervals are."""

from __future__ import annotations

import copy
import pickle

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.numbers.packed import PackedIntervals

NUMBERS = st.one_of(st.integers(), st.integers(-(2**90), 2**90), st.sampled_from([2**2100, -(2**2040), 2**2031 - 1]))


@st.composite
def intervals(draw: st.DrawFn) -> Dyadic:
    return Dyadic(*sorted((draw(NUMBERS), draw(NUMBERS))), draw(st.integers(-(10**20), 10**20)))


LISTS = st.lists(st.none() | intervals(), max_size=8)


@given(LISTS)
def test_what_is_packed_comes_back(given: list[Dyadic | None]) -> None:
    packed = PackedIntervals(given)
    assert [*packed] == given
    assert len(packed) == len(given)
    assert [packed[k] for k in range(len(given))] == given
    assert packed[-2:] == tuple(given[-2:])
    for again in (pickle.loads(pickle.dumps(packed)), copy.deepcopy(packed), PackedIntervals.of_bytes(packed.data)):
        assert again == packed
        assert hash(again) == hash(packed)


@given(LISTS, LISTS)
def test_equal_where_the_intervals_are(first: list[Dyadic | None], second: list[Dyadic | None]) -> None:
    assert (PackedIntervals(first) == PackedIntervals(second)) is (first == second)
    assert PackedIntervals(first) != tuple(first)


def test_few_bytes() -> None:
    """An interval of 80 bits: a fifth of what three Python integers in an object take, at most."""
    packed = PackedIntervals([Dyadic(2**80 + 1, 2**80 + 5, -80)] * 100)
    assert len(pickle.dumps(packed)) < 100 * 20
    with pytest.raises(IndexError):
        packed[100]
