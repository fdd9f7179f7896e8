"""False statements are not verified, whatever their certificates say."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from must_reject.forged import FORGED, LONG, sign
from must_reject.mutate import checker
from witnesses.theta import theta_witness

check = checker()


@pytest.mark.parametrize("name", FORGED)
def test_a_false_statement_is_not_verified(name: str) -> None:
    with pytest.raises(check.limits.Rejected):
        check.main.check_text(FORGED[name])


def one_piece(
    kind: str, place: Fraction, width: Fraction, value: int
) -> tuple[list[Any], Fraction | None, Fraction | None]:
    """The piece, where it begins and where it ends."""
    if kind == "left":
        return ["left", str(place)], None, place
    if kind == "right":
        return ["right", str(place), 0], place, None
    if kind == "sign":
        return ["sign", str(place), str(place + width), value], place, place + width
    low, high = {"hinge before 0": (-width, 0), "hinge after 0": (0, width), "fold": (-width, width)}[kind]
    return [kind.split()[0], str(low), str(high)], Fraction(low), Fraction(high)


@example("sign", 1, (0, 8), Fraction(0), Fraction(1, 8), Fraction(1, LONG), 1, 1)
@example("hinge before 0", 1, (0, 2), Fraction(0), Fraction(1, 4), Fraction(0), 1, -1)
@example("fold", 2, (7, 8), Fraction(0), Fraction(1, 4), Fraction(0), 1, -1)
@example("fold", 3, (0, 1), Fraction(0), Fraction(1, 4), Fraction(0), 1, -1)
@given(
    st.sampled_from(["left", "right", "sign", "sign", "hinge before 0", "hinge after 0", "fold"]),
    st.integers(0, 7),
    st.tuples(st.integers(0, 8), st.integers(0, 8)).map(sorted),
    st.fractions(-2, 4, max_denominator=8),
    st.sampled_from([Fraction(1, 2), Fraction(1, 4), Fraction(1, 16), Fraction(1, 7 * LONG)]),
    st.sampled_from([Fraction(0), Fraction(1, LONG), Fraction(-1, 3 * LONG), Fraction(1, 10**1000)]),
    st.sampled_from([1, -1]),
    st.sampled_from([1, -1]),
)
@settings(max_examples=40)
def test_what_is_verified_is_true(
    kind: str, cell: int, eighths: Any, place: Fraction, width: Fraction, shift: Fraction, value: int, claimed: int
) -> None:
    """A sign by one piece with long ends: if the checker says yes, the values at the ends and between agree."""
    low, high = (cell + Fraction(k, 8) for k in eighths)
    piece, start, end = one_piece(kind, place + shift, width, value)
    tau = f"({'-inf' if start is None else start}, {'inf' if end is None else end})"
    beta = f"[{low}, {high}]"
    try:
        assert check.main.check_text(
            sign(beta, tau, claimed, ([str(low), str(high)], [piece])), check.limits.Limits(work=1)
        )
    except check.limits.Rejected:
        return
    first = end - 5 if start is None else start
    last = first + 5 if end is None else end
    for where in (Fraction(1, 1000), Fraction(1, 2), Fraction(999, 1000)):
        for b in (low, (low + high) / 2, high):
            exact = -b * theta_witness(first + where * (last - first), b - 1)
            assert math.copysign(1, exact) == claimed
