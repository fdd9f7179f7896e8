"""Evidence: made by certain comparisons alone, and never from what is not finite, not certain, or not there."""

from __future__ import annotations

import pickle
from collections.abc import Sequence
from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import to_fmpq

from gspot_verified.numbers import evidence
from gspot_verified.numbers.evidence import (
    Box,
    Ends,
    answered,
    at_most,
    cover,
    cover_by_boxes,
    differ,
    equal,
    every,
    in_interior,
    inside,
    less,
    signed,
    theorem,
)
from gspot_verified.numbers.verdict import Evidence

WIDE, NAN, HUGE = arb(0, 1), arb.nan(), arb.pos_inf()
SOME = less(1, 2)
ENDS = st.fractions(-2, 2, max_denominator=3)


def test_comparisons() -> None:
    assert str(less(fmpq(1, 3), arb(1))) == "1/3 < 1.00000"
    assert str(at_most(1, fmpq(1))) == "1 <= 1"
    assert less(1, 1) is None
    assert at_most(2, 1) is None
    assert less(arb(-2), WIDE) is not None
    assert at_most(arb(-1), arb((1, -1), (1, -1))) is not None


@pytest.mark.parametrize("value", [WIDE, NAN, HUGE, -HUGE])
def test_what_is_not_certain_or_not_finite_is_no_evidence(value: arb) -> None:
    for compare in (less, at_most):
        assert compare(0, value) is None
        assert compare(value, 0) is None
        assert compare(value, value) is None
    assert signed(value) is None


def test_infinity_is_above_all_numbers_and_no_evidence() -> None:
    assert bool(arb(0) < HUGE)
    assert less(0, HUGE) is None


def test_signs() -> None:
    signs = [found[0] for value in (arb(2), arb(-2), arb(0)) if (found := signed(value)) is not None]
    assert signs == [1, -1, 0]
    zero = signed(arb(0))
    assert zero is not None
    assert str(zero[1]) == "0 = 0"


def test_equality_is_of_exact_numbers() -> None:
    assert str(equal(fmpq(2, 4), fmpq(1, 2))) == "1/2 = 1/2"
    assert equal(0, 1) is None


def test_numbers_that_differ() -> None:
    assert str(differ(fmpq(1, 2), 0)) == "1/2 != 0"
    assert str(differ(arb(1), arb(2))) == "1.00000 != 2.00000"
    assert differ(fmpq(2, 4), fmpq(1, 2)) is None
    assert differ(WIDE, 1) is None
    assert differ(NAN, 1) is None
    assert differ(HUGE, 1) is None


def test_answers_of_checks() -> None:
    assert str(answered([("one", True), ("two", True)], True)) == "one: it holds; two: it holds"
    assert str(answered([("one", False)], False)) == "one: it fails"
    for wanted in (True, False):
        assert answered([], wanted) is None
        for other in (None, not wanted, int(wanted)):
            assert answered([("one", wanted), ("two", other)], wanted) is None
    assert equal(arb("1", "0.1"), arb("1", "0.1")) is None
    assert equal(HUGE, HUGE) is None
    assert [found[0] for number in (fmpq(1), fmpq(-1), 0) if (found := signed(number)) is not None] == [1, -1, 0]


def test_containment() -> None:
    unit = arb((1, -1), (1, -1))
    assert inside(arb(0), unit) is not None
    assert in_interior(arb(0), unit) is None
    assert in_interior(arb("0.5"), unit) is not None
    assert inside(arb(2), unit) is None
    assert inside(unit, arb(0)) is None
    for outer in (NAN, arb(0, float("inf"))):  # they contain everything
        assert inside(arb(0), outer) is None
        assert in_interior(arb(0), outer) is None


def test_by_hand() -> None:
    with pytest.raises(TypeError, match="made by a comparison"):
        Evidence()
    assert SOME is not None
    with pytest.raises(AttributeError, match="does not change"):
        SOME.facts = ("0 < 0",)
    assert pickle.loads(pickle.dumps(SOME)).facts == SOME.facts


def test_all_or_none() -> None:
    assert str(every([SOME, at_most(0, 1)])) == "1 < 2; 0 <= 1"
    assert every([SOME, less(2, 1), SOME]) is None
    assert every([]) is None
    assert str(theorem("proofs/flight.md", SOME)) == "proofs/flight.md: 1 < 2"
    assert theorem("proofs/flight.md", SOME, None) is None
    assert theorem("proofs/flight.md") is None


def closed(ends: Ends, point: fmpq) -> bool:
    lower, upper = ends
    return (lower is None or lower <= point) and (upper is None or point <= upper)


@given(st.lists(st.tuples(st.none() | ENDS, st.none() | ENDS), max_size=5), st.none() | ENDS, st.none() | ENDS)
def test_a_cover_leaves_no_point_out(
    parts: list[tuple[Fraction | None, Fraction | None]], first: Fraction | None, last: Fraction | None
) -> None:
    """By the points of a grid finer than the ends: the gaps between ends are seen there."""
    exact = [tuple(None if end is None else to_fmpq(end) for end in part) for part in parts]
    listed: list[Ends] = [(a, b) for a, b in exact if a is None or b is None or a <= b]
    if first is not None and last is not None and first > last:
        first, last = last, first
    whole = (None if first is None else to_fmpq(first), None if last is None else to_fmpq(last))
    grid = [point for k in range(-50, 51) if closed(whole, point := fmpq(k, 12))]
    covered = all(any(closed(part, point) for part in listed) for point in grid)
    assert (cover(listed, whole) is not None) is covered


SIDE = st.integers(0, 3)
BOX = st.tuples(SIDE, SIDE, SIDE, SIDE)


@given(st.lists(BOX, max_size=7), BOX)
def test_boxes_cover_where_they_leave_no_point_out(parts: list[tuple[int, ...]], whole: tuple[int, ...]) -> None:
    """By the points of a grid that is finer than the ends."""

    def box(ends: tuple[int, ...]) -> tuple[tuple[fmpq, fmpq], tuple[fmpq, fmpq]]:
        first, second, third, fourth = map(fmpq, ends)
        return (min(first, second), min(third, fourth)), (max(first, second), max(third, fourth))

    boxes, asked = list(map(box, parts)), box(whole)
    grid = [(fmpq(i, 2), fmpq(j, 2)) for i in range(7) for j in range(7)]

    def holds(ends: tuple[tuple[fmpq, ...], tuple[fmpq, ...]], point: tuple[fmpq, ...]) -> bool:
        return all(low <= value <= high for low, value, high in zip(ends[0], point, ends[1], strict=True))

    inside = [point for point in grid if holds(asked, point)]
    covered = all(any(holds(part, point) for part in boxes) for point in inside)
    assert (cover_by_boxes(boxes, asked) is not None) is covered


@pytest.mark.parametrize("left_out", [None, *range(12)])
def test_slab_after_slab_every_box_is_needed(left_out: int | None) -> None:
    """Twelve squares in three columns, in their order, the second column first, and backwards."""
    squares = [((fmpq(i), fmpq(j)), (fmpq(i + 1), fmpq(j + 1))) for i in range(3) for j in range(4)]
    boxes = [square for number, square in enumerate(squares) if number != left_out]
    whole = (fmpq(0), fmpq(0)), (fmpq(3), fmpq(4))
    for order in (boxes, [*boxes[4:], *boxes[:4]], boxes[::-1]):
        assert (cover_by_boxes(order, whole) is not None) is (left_out is None)
        assert (cover_by_boxes(iter(order), whole) is not None) is (left_out is None)


def test_no_more_than_some_slabs_are_looked_at_together(monkeypatch: pytest.MonkeyPatch) -> None:
    """Also where a slab begins with a box that is divided along the first component."""
    columns, rows, half = 12, 10, fmpq(1, 2)
    boxes = []
    for i in map(fmpq, range(columns)):
        boxes += [((i, fmpq(0)), (i + half, fmpq(1))), ((i + half, fmpq(0)), (i + 1, fmpq(1)))]
        boxes += [((i, fmpq(j)), (i + 1, fmpq(j + 1))) for j in range(1, rows)]
    sizes, own = list[int](), evidence._covers

    def counted(parts: Sequence[Box], whole: Box) -> bool:
        sizes.append(len(parts))
        return own(parts, whole)

    monkeypatch.setattr(evidence, "_covers", counted)
    whole = (fmpq(0), fmpq(0)), (fmpq(columns), fmpq(rows))
    assert cover_by_boxes(boxes, whole) is not None
    assert max(sizes) == rows + 1
    for left_out in range(len(boxes)):
        assert cover_by_boxes(boxes[:left_out] + boxes[left_out + 1 :], whole) is None


def test_a_whole_without_width_is_covered_where_its_side_is() -> None:
    """Its slabs have no width either: what follows the box that covers it does not matter."""
    line = (fmpq(1), fmpq(0)), (fmpq(1), fmpq(1))
    halves = [((fmpq(1), fmpq(k, 2)), (fmpq(1), fmpq(k + 1, 2))) for k in range(2)]
    for boxes in (halves, [line, *halves], [*halves, line]):
        assert cover_by_boxes(boxes, line) is not None
    assert cover_by_boxes(halves[:1], line) is None
    assert cover_by_boxes([], line) is None


def test_of_no_dimension_nothing_is_covered() -> None:
    assert cover_by_boxes([], ((), ())) is None


@pytest.mark.parametrize("beyond", [(fmpq(2), fmpq(3)), (fmpq(2), None), (fmpq(-2), fmpq(-1)), (None, fmpq(-1))])
def test_what_lies_beyond_the_whole_is_no_gap(beyond: Ends) -> None:
    assert cover([(fmpq(0), fmpq(1)), beyond], (fmpq(0), fmpq(1))) is not None


@pytest.mark.parametrize(
    ("parts", "whole"),
    [
        ([], (fmpq(0), fmpq(0))),
        ([(fmpq(-1), fmpq(-1, 2))], (fmpq(0), fmpq(0))),
        ([(fmpq(0), fmpq(1, 2)), (fmpq(1, 2) + fmpq(1, 10**30), fmpq(1))], (fmpq(0), fmpq(1))),
        ([(fmpq(0), fmpq(1))], (None, fmpq(1))),
        ([(None, fmpq(1))], (None, None)),
    ],
)
def test_a_gap_however_small(parts: list[Ends], whole: Ends) -> None:
    assert cover(parts, whole) is None


@pytest.mark.parametrize(
    ("whole", "shown"),
    [
        ((None, None), "one part covers [-inf, inf]"),
        ((fmpq(1, 2), None), "one part covers [1/2, inf]"),
        ((None, fmpq(-1, 3)), "one part covers [-inf, -1/3]"),
        ((fmpq(0), fmpq(1)), "one part covers [0, 1]"),
    ],
)
def test_a_cover_names_the_ends(whole: Ends, shown: str) -> None:
    assert str(cover([(None, None)], whole)) == shown
