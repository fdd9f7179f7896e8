"""What a verdict rests on: values that were compared, boxes that cover. Each function makes its comparison itself.

They answer None where the comparison is not certain, or a ball is not finite; so the comparison that decides is the
evidence that is handed over, and a conclusion without one cannot be written.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise

from flint import arb, fmpq

from gspot_verified.numbers.balls import ball_text
from gspot_verified.numbers.counted import counted
from gspot_verified.numbers.verdict import Evidence

Number = int | fmpq | arb
Ends = tuple[fmpq | None, fmpq | None]
"""The ends of an interval; None for one without end on that side."""
Box = tuple[Sequence[fmpq], Sequence[fmpq]]
"""The lower ends of a box and its upper ends."""


def less(left: Number, right: Number) -> Evidence | None:
    """left < right for every pair of numbers in the balls.

    >>> print(less(1, arb("1.5", "0.1")), less(1, arb(1, "0.1")))
    1 < [1.39, 1.61] None
    """
    return Evidence._of_facts((f"{_text(left)} < {_text(right)}",)) if _finite(left, right) and left < right else None


def at_most(left: Number, right: Number) -> Evidence | None:
    """left <= right for every pair of numbers in the balls."""
    return Evidence._of_facts((f"{_text(left)} <= {_text(right)}",)) if _finite(left, right) and left <= right else None


def equal(left: int | fmpq, right: int | fmpq) -> Evidence | None:
    """Two exact numbers are the same."""
    return Evidence._of_facts((f"{_text(left)} = {_text(right)}",)) if _finite(left, right) and left == right else None


def differ(left: Number, right: Number) -> Evidence | None:
    """No number of the one is one of the other: exact numbers that are not the same, or balls apart.

    >>> print(differ(1, fmpq(1, 2)), differ(1, arb("1.5", "0.1")), differ(1, arb(1, "0.1")))
    1 != 1/2 1 != [1.39, 1.61] None
    """
    shown = _finite(left, right) and left != right
    return Evidence._of_facts((f"{_text(left)} != {_text(right)}",)) if shown else None


def inside(part: arb, whole: arb) -> Evidence | None:
    """Every number of the one ball is one of the other; the ends may coincide."""
    shown = _finite(part, whole) and whole.contains(part)
    return Evidence._of_facts((f"{_text(part)} lies in {_text(whole)}",)) if shown else None


def in_interior(part: arb, whole: arb) -> Evidence | None:
    """The same, and no end is reached.

    >>> in_interior(arb(1), arb(1, 1)) is not None, in_interior(arb(1, 1), arb(1, 1))
    (True, None)
    """
    shown = _finite(part, whole) and whole.contains_interior(part)
    return Evidence._of_facts((f"{_text(part)} lies in the interior of {_text(whole)}",)) if shown else None


def signed(value: Number) -> tuple[int, Evidence] | None:
    """1, -1, or 0 when every number in the ball has that sign, with the comparison.

    >>> print(signed(arb(0, 1)), *signed(arb(-2)))
    None -1 -2.00000 < 0
    """
    is_zero = value.is_zero() if isinstance(value, arb) else value == 0
    zero = Evidence._of_facts(("0 = 0",)) if is_zero else None
    for sign, shown in ((1, less(0, value)), (-1, less(value, 0)), (0, zero)):
        if shown is not None:
            return sign, shown
    return None


def cover(parts: Iterable[Ends], whole: Ends) -> Evidence | None:
    """The closed intervals leave nothing of the whole out, by their exact ends; in any order, they may overlap.

    >>> half = fmpq(1, 2)
    >>> print(cover([(half, fmpq(1)), (None, half)], (None, fmpq(1))), cover([(half, None)], (fmpq(0), fmpq(1))))
    2 parts cover [-inf, 1] None
    """
    lower, upper = whole
    reached, number = lower, 0
    for first, last in sorted(parts, key=lambda ends: (ends[0] is not None, ends[0] or fmpq(0))):
        if number and upper is not None and reached is not None and upper <= reached:
            break  # what follows lies beyond
        if reached is not None and last is not None and last < reached:
            continue
        if first is not None and (reached is None or first > reached):
            return None
        number, reached = number + 1, last
        if last is None:
            break
    if number == 0 or (reached is not None and (upper is None or reached < upper)):
        return None
    begin, end = "-inf" if lower is None else str(lower), "inf" if upper is None else str(upper)
    return Evidence._of_facts((f"{_covering(counted(number, 'part'))} [{begin}, {end}]",))


def _covering(parts: str) -> str:
    return f"{parts} covers" if parts.startswith("one ") else f"{parts} cover"


def cover_by_boxes(parts: Iterable[Box], whole: Box) -> Evidence | None:
    """The same for closed boxes in one or more dimensions.

    Memory holds all of them; where they come slab after slab along the first component, those of one slab.

    >>> zero, half, one = fmpq(0), fmpq(1, 2), fmpq(1)
    >>> parts = [((zero, zero), (half, one)), ((half, zero), (one, one))]
    >>> print(cover_by_boxes(parts, ((zero, zero), (one, one))), cover_by_boxes(parts[:1], ((zero, zero), (one, one))))
    2 boxes cover [0, 1] x [0, 1] None
    """
    if not whole[0]:
        return None
    (lower, *low), (upper, *high) = whole
    count, tried, reached, waiting = 0, 0, lower, list[Box]()
    far = lower  # where the first component of those that wait ends
    for first, last in parts:
        # One that begins there may stand beside others of its slab: what was tried in vain waits for as many again.
        if reached < far <= first[0] and len(waiting) >= 2 * tried:
            if _covers(waiting, ((reached, *low), (far, *high))):
                reached, waiting = far, []
            tried = len(waiting)
        waiting.append((first, last))
        count += 1
        if far < last[0]:
            far = last[0]
    if not (lower < reached and upper <= reached) and not _covers(waiting, ((reached, *low), (upper, *high))):
        return None
    sides = " x ".join(f"[{first}, {last}]" for first, last in zip(*whole, strict=True))
    return Evidence._of_facts((f"{_covering(counted(count, 'box', 'boxes'))} {sides}",))


def _covers(parts: Sequence[Box], whole: Box) -> bool:
    """Between neighbouring ends in the first component, the parts that reach over them cover the other components."""
    (lower, *low), (upper, *high) = whole
    if not low:
        return cover([(first[0], last[0]) for first, last in parts], (lower, upper)) is not None
    ends = {end for first, last in parts for end in (first[0], last[0]) if lower < end < upper}
    cuts = sorted({lower, upper, *ends})
    waiting = sorted(parts, key=lambda part: part[0][0], reverse=True)
    reaching: list[
        Box
    ] = []  # those that begin before: one that does not reach over this pair reaches over no later one
    for begin, end in pairwise(cuts) if lower < upper else [(lower, upper)]:
        while waiting and waiting[-1][0][0] <= begin:
            reaching.append(waiting.pop())
        reaching = [part for part in reaching if end <= part[1][0]]
        if not _covers([(p[1:], q[1:]) for p, q in reaching], (low, high)):
            return False
    return True


def every(parts: Iterable[Evidence | None]) -> Evidence | None:
    """All of them; None where one is missing, or there is none."""
    facts: list[str] = []
    for part in parts:
        if part is None:
            return None
        facts += part.facts
    return Evidence._of_facts(tuple(facts)) if facts else None


def answered(answers: Iterable[tuple[str, bool | None]], wanted: bool) -> Evidence | None:
    """Every check, by its name, gave the answer that is wanted; None where one did not, or could not tell, or there is
    none.

    >>> print(answered([("by hand", True)], True), answered([("by hand", True), ("by sympy", None)], True))
    by hand: it holds None
    """
    given = list(answers)
    if not given or any(answer is not wanted for _, answer in given):
        return None
    return Evidence._of_facts(tuple(f"{name}: it {'holds' if wanted else 'fails'}" for name, _ in given))


def theorem(page: str, *hypotheses: Evidence | None) -> Evidence | None:
    """What a proof page shows under hypotheses that were checked; None where one was not, or there is none."""
    checked = every(hypotheses)
    return None if checked is None else Evidence._of_facts((f"{page}: {checked}",))


def _finite(*values: Number) -> bool:
    return all(not isinstance(value, arb) or value.is_finite() for value in values)


def _text(value: Number) -> str:
    return ball_text(value, 6) if isinstance(value, arb) else str(value)
