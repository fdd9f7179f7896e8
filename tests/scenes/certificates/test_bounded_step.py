"""Steps as a certificate holds them: what is written is on the grid, and the checker accepts it.

Page: proofs/run_certificate.md, section 2.
"""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import pairwise

import pytest
from flint import arb
from hypothesis import given
from hypothesis import strategies as st
from must_reject import runs

from gspot_verified.scenes.certificates.bounded_step import grid, majorant_nodes, pair


@pytest.mark.parametrize(
    ("value", "bits", "found"), [(arb(3) / 4, 1, 1), (-arb(3) / 4, 1, -2), (arb(5), 3, 40), (arb(5), -1, 2)]
)
def test_the_grid(value: arb, bits: int, found: int) -> None:
    assert grid(value, bits) == found


def test_pairs_are_exact() -> None:
    assert pair(arb(3) / 8) == [3, -3]
    assert pair(arb(0)) == [0, 0]


def test_what_is_written_is_accepted() -> None:
    """With u exactly 0 in flight: a polynomial without coefficients."""
    assert runs.verdict(runs.stick()).startswith("VERIFIED")


shares = st.floats(0, 1)


@given(
    st.lists(st.lists(shares, min_size=3, max_size=3), min_size=3, max_size=3),
    st.lists(st.floats(-300, 3), min_size=3, max_size=3),
    st.lists(shares, min_size=3, max_size=3),
    st.lists(shares, min_size=3, max_size=3),
)
def test_the_inequality(rows: list[list[float]], diagonal: list[float], start: list[float], push: list[float]) -> None:
    rates = [[diagonal[i] if i == j else rows[i][j] for j in range(3)] for i in range(3)]
    nodes = majorant_nodes(rates, start, push, 1e-20)
    assert nodes is not None
    assert all(w >= value for w, value in zip(nodes[0], start, strict=True))
    assert all(w >= 1e-20 for node in nodes for w in node)
    count = len(nodes) - 1
    for v, w in pairwise([[Fraction(value) for value in node] for node in nodes]):
        for i in range(3):
            driven = [sum(Fraction(a) * x for a, x in zip(rates[i], node, strict=True)) for node in (v, w)]
            assert count * (w[i] - v[i]) >= max(driven) + Fraction(push[i])


@given(st.floats(-30, 3), st.floats(1e-6, 1))
def test_near_the_exponential(rate: float, start: float) -> None:
    nodes = majorant_nodes([[rate]], [start], [0.0], 1e-30)
    assert nodes is not None
    assert start * math.exp(rate) <= nodes[-1][0]
    if rate > 0:
        assert nodes[-1][0] <= 1.3 * start * math.exp(rate)


def test_none_for_a_growth_that_is_too_fast() -> None:
    assert majorant_nodes([[1000.0]], [1.0], [0.0], 1e-20) is None
    assert majorant_nodes([[1.0]], [math.inf], [0.0], 1e-20) is None
