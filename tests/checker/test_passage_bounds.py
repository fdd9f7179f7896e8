"""The checker of Theorem B: its charts, its norm, its barrier and the units of its end, each alone.

Page: proofs/from_state.md, sections 3, 4 and 10.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from checker.test_passage import check, parts, passage, put, said
from hypothesis import assume, given
from hypothesis import strategies as st

H, R, ONE = passage.H, passage.R, passage.number(1)
SUM = R * (R + H)


def held(N: list[list[Any]], steep: bool, reach: Fraction, other: Fraction) -> bool:
    meter = check.limits.Meter(check.limits.Limits(), 10**9)
    try:
        passage.check_chart(passage.Numbers(passage.BITS, meter), N, steep, reach, other)
    except check.limits.Rejected as reason:
        if "Lemma 1" not in str(reason):
            raise
        return False
    return True


def diagonal(first: Any, second: Any, last: Any = ONE) -> list[list[Any]]:
    zero = passage.NOTHING
    return [[first, zero, zero], [zero, second, zero], [zero, zero, last]]


@pytest.mark.parametrize("place", [0, 1])
def test_each_chart_sees_what_is_negative_in_it_alone(place: int) -> None:
    """r(4r - h) is negative for h > 4r alone, r(4h - r) for r > 4h alone: in the charts r = uh and h = ur."""
    four = passage.number(4)
    for entry, seen in ((R * (four * R - H), False), (R * (four * H - R), True)):
        N = diagonal(*((entry, SUM) if place == 0 else (SUM, entry)))
        assert [held(N, steep, Fraction(1), Fraction(1)) for steep in (True, False)] == [not seen, seen]


def test_two_negative_entries_are_not_a_positive_minor() -> None:
    assert held(diagonal(SUM, SUM), True, Fraction(1), Fraction(1))
    assert not held(diagonal(-SUM, -SUM), True, Fraction(1), Fraction(1))
    assert not held(diagonal(SUM, SUM, -ONE), True, Fraction(1), Fraction(1))


def test_a_minor_that_vanishes_is_not_positive() -> None:
    """[[r², r²], [r², r²]] has the minors r² and 0."""
    N = diagonal(R * R, R * R)
    N[0][1] = N[1][0] = R * R
    assert not held(N, True, Fraction(1), Fraction(1))


@pytest.mark.parametrize(("entry", "steep"), [(H * H, False), (R, False), (R, True)])
def test_an_entry_that_a_chart_would_divide_with_a_rest_is_refused(entry: Any, steep: bool) -> None:
    with pytest.raises(check.limits.Rejected, match="N has the monomial"):
        passage.scaled(entry, steep, 2)


def test_only_what_lies_outside_of_the_rectangle_is_left_out() -> None:
    """The chart h = us reaches beyond h ≤ other: there nothing is asked, on the edge and within it is."""
    edge = passage.number(Fraction(1, 4))
    beyond = R * R * (passage.number(Fraction(3, 10)) - H)  # negative for h > 3/10 alone
    assert held(diagonal(beyond, SUM), True, Fraction(1), Fraction(1, 4))
    assert not held(diagonal(R * R * (edge - H), SUM), True, Fraction(1), Fraction(3, 10))
    assert not held(diagonal(-SUM, SUM), True, Fraction(1), Fraction(1, 4))


@pytest.mark.parametrize("tenths", [1, 9])
def test_no_part_of_a_box_that_is_halved_is_lost(tenths: int) -> None:
    """s - 1/10, 9/10 - s, u - 1/10, 9/10 - u as an entry of the block, in the chart h = us, r = s: each is negative in
    one part of the first box, of one side of it."""
    level, sign = passage.number(Fraction(tenths, 10)), passage.number(1 if tenths == 1 else -1)
    for entry in (sign * R * R * (R - level), sign * R * (H - level * R)):
        assert not held(diagonal(entry, SUM), True, Fraction(1), Fraction(1))
    for entry in (sign * H * R * (H - level), sign * R * (R - level * H)):  # r = us, h = s: over h²u
        assert not held(diagonal(entry, SUM), False, Fraction(1), Fraction(1))


def test_side_entries_count_by_their_squares() -> None:
    """[[r², 0, x], [0, r², 0], [x, 0, 1]], x = cr, is positive for c² < 1 alone; with hr for r² in the other chart."""
    for c, good in ((Fraction(9, 10), True), (Fraction(11, 10), False)):
        x = passage.number(c) * R
        N = diagonal(R * R, R * R)
        N[0][2] = N[2][0] = x
        assert held(N, True, Fraction(1), Fraction(1)) is good
        N = diagonal(H * R, H * R)
        N[1][2] = N[2][1] = x
        assert held(N, False, Fraction(1), Fraction(1)) is (c * c < 1)


@pytest.mark.parametrize(("h", "r"), [("1/8", "1/1000000"), ("1/1000000", "3/4"), ("1/8", "3/4")])
def test_the_share_bounds_the_second_entry_and_is_attained_at_the_edges(h: str, r: str) -> None:
    start, _, norm = parts()
    norm = norm._replace(h=Fraction(h), r=Fraction(r))
    share, largest = float(norm.share(start)), 0.0
    for x in (0.0, 0.5, 1.0):
        for y in (0.0, 0.5, 1.0):
            places = {"h": x * float(norm.h), "r": y * float(norm.r)}
            M = [
                [sum(float(c) * np.prod([places[k] for k in key]) for key, c in entry.items()) for entry in row]
                for row in norm.matrix(start)
            ]
            largest = max(largest, float(np.sqrt(np.linalg.inv(np.array(M, dtype=float))[1, 1])))
    assert largest <= share * (1 + 1e-12)
    if "1/1000000" in (h, r):
        assert largest >= share * (1 - 1e-5)


@given(
    st.integers(1, 6),
    st.integers(0, 9),
    st.fractions(min_value=Fraction(1, 10), max_value=9),
    st.fractions(min_value=Fraction(1, 20), max_value=2),
)
def test_the_barrier_of_any_source_is_an_upper_solution(i: int, n: int, rate: Fraction, damping: Fraction) -> None:
    """-p dZ/dp - (Γ - θr/h)Z ≥ h^i r^n, with deficits paid by further steps; or it is refused."""
    try:
        Z = passage.barrier({(i, n): Fraction(1)}, rate, damping)
    except check.limits.Rejected:
        assume(False)
    for h in (Fraction(1, 100), Fraction(1, 3), Fraction(1)):
        for r in (Fraction(1, 100), Fraction(1, 3), Fraction(1)):
            paid = sum((Fraction(3 * j - m, 2) - rate + damping * r / h) * c * h**j * r**m for (j, m), c in Z.items())
            assert paid >= h**i * r**n


def test_a_deficit_is_paid_once_and_no_more() -> None:
    """Γ = 3, θ = 1/2: h r² has E = 1/2 and costs 2 h² r, whose E = 5/2 leaves a deficit of 1: 2 h³."""
    found = passage.barrier({(1, 2): Fraction(1)}, Fraction(3), Fraction(1, 2))
    assert found == {(2, 1): Fraction(2), (3, 0): Fraction(2)}


def test_a_negative_excess_is_kept_below_the_mean_force_with_the_fast_part() -> None:
    """|L|(1 + sup w⁺ + W*) < λ̄: with half of W* it would hold."""
    start, slow, norm = parts()
    rising = passage.at(passage.monomials(slow.w), norm.h, norm.r, 1)
    moved = norm.share(start) * Fraction(1, 30)
    for share, reason in ((Fraction(1, 2), "the force is not certainly positive"), (Fraction(11, 10), "")):
        excess = -start.mean / (1 + rising + share * moved)
        b = (-start.p * (start.mean + excess)).limit_denominator(10**9)
        if reason:
            with pytest.raises(check.limits.Rejected, match=reason):
                said(put(0, b=str(b)))
        else:
            assert f"b = {b} with" in said(put(0, b=str(b)))


def test_the_end_is_measured_in_the_units_of_the_system() -> None:
    """α twice as large and ε half as large leave e = aε: p = Saε^(2/3) has a smaller S for the same h."""
    twice = put(0, alpha=["-2", "-2", "-3"], epsilon="1/8000", scaled="159/50")
    assert "λ > 0 down to p = 159/25 ε^(2/3)" in said(twice)
    for scaled, reason in (("317/100", "ends beyond the rectangle"), ("150", "would end before its start")):
        with pytest.raises(check.limits.Rejected, match=reason):
            said(put(0, alpha=["-2", "-2", "-3"], epsilon="1/8000", scaled=scaled))
