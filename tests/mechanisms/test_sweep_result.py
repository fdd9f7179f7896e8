"""The texts of a sweep: brackets are rounded outward, neighbours of one answer are one stretch."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.sweep import sweep
from gspot_verified.mechanisms.sweep_piece import Kind
from gspot_verified.mechanisms.sweep_result import Crossing


@given(st.fractions(-10, 10), st.fractions(0, Fraction(1, 10**6)), st.sampled_from([1, -1]))
def test_a_bracket_is_shown_outward(lower: Fraction, width: Fraction, direction: int) -> None:
    upper = lower + width
    ends = [fmpq(end.numerator, end.denominator) for end in (lower, upper)]
    crossing = Crossing("beta - 3", *ends, direction, -direction, direction)
    text = crossing.text("k")
    assert text.startswith("beta passes 3 in k = [")
    assert text.endswith(", exactly once")
    shown = [Fraction(word) for word in text.partition("[")[2].partition("]")[0].split(", ")]
    assert shown[0] <= lower
    assert upper <= shown[1]
    assert shown[1] - shown[0] <= width + 2 * Fraction(1, 10**16)


def test_what_is_not_certain_is_not_called_once() -> None:
    for before, after in ((None, 1), (-1, None), (1, 1), (-1, -1), (1, -1)):
        crossing = Crossing("alpha_1", fmpq(0), fmpq(1), 1, before, after)
        assert not crossing.proved
        assert "at most once" in crossing.text("k")


def test_stretches_join_neighbours() -> None:
    result = sweep(shipped_mechanism("oscillator"), {"beta": "9/4..15/4:6"})
    stretches = result.stretches()
    assert (stretches[0][0], stretches[-1][1]) == (fmpq(9, 4), fmpq(15, 4))
    for (_, end, first), (begin, _, second) in pairwise(stretches):
        assert end == begin
        assert (first.kind, first.answer) != (second.kind, second.answer)
    settled = [piece.answer for _, _, piece in stretches if piece.kind is Kind.SETTLED]
    assert settled == [("III", 1, -1), ("III", -1, 1), ("none", None, None)]
    lines = str(result).splitlines()  # verdict, spot, stretches, crossings, and that u = -3/5
    assert len(lines) == 2 + 3 + 2 + 1
    assert lines[-1].startswith("  warning: u <= 0")


def test_json_holds_every_piece_without_its_tube() -> None:
    result = sweep(shipped_mechanism("oscillator"), {"beta": "9/4..11/4:2"})
    data = result.to_json()
    assert [piece["lower"] for piece in data["pieces"]] == [["9/4"], ["5/2"]]
    assert "tube" not in data["pieces"][0]
    assert data["verdict"]["outcome"] == "proved"
