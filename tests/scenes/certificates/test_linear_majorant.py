"""Piecewise linear bounds: the inequality of Theorem N1' in rational numbers, and bounds of exponentials.

Page: proofs/run_certificate.md.
"""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import pairwise

from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.scenes.certificates.linear_majorant import majorant_nodes

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
