"""Rounding of the checker of runs: outward, seen at rational numbers.

Page: proofs/run_certificate.md.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from must_reject import runs

from gspot_verified.numbers.balls import working_bits

BITS = 64
intervals: Any = runs.part("intervals")
limits: Any = runs.part("limits")
integers = st.integers(-(2**80), 2**80)
pairs = st.tuples(integers, integers).map(lambda ends: (min(ends), max(ends)))
points = st.fractions(0, 1, max_denominator=1000)


def numbers() -> Any:
    return intervals.Numbers(BITS, limits.Meter(limits.Limits(), 10**9))


def ball(q: Fraction) -> arb:
    return arb(fmpq(q.numerator, q.denominator))


def value(n: int) -> Fraction:
    return Fraction(n, 2**BITS)


def holds(found: tuple[int, int], exact: Fraction) -> bool:
    return value(found[0]) <= exact <= value(found[1])


def inside(a: tuple[int, int], share: Fraction) -> Fraction:
    return value(a[0]) + share * value(a[1] - a[0])


@given(st.integers(-(10**9), 10**9), st.integers(1, 10**9))
def test_up(n: int, d: int) -> None:
    assert intervals.up(n, d) - 1 < Fraction(n, d) <= intervals.up(n, d)


@given(st.integers(0, 10**30))
def test_root_up(n: int) -> None:
    root = intervals.root_up(n)
    assert (root - 1) ** 2 < n <= root**2 or root == n == 0


@given(st.fractions(), pairs, points)
def test_rationals(q: Fraction, a: tuple[int, int], share: Fraction) -> None:
    found = numbers().interval(q)
    assert holds(found, q)
    assert found[1] - found[0] <= 1
    assert holds(numbers().scaled(q, a), q * inside(a, share))


@given(pairs, points)
def test_reciprocal(a: tuple[int, int], share: Fraction) -> None:
    if a[0] <= 0:
        with pytest.raises(limits.Rejected, match="a divisor is not certainly positive"):
            numbers().reciprocal(a)
    else:
        assert holds(numbers().reciprocal(a), 1 / inside(a, share))
        low, high = numbers().reciprocal((a[0], a[0]))
        assert high - low <= 1


@given(st.fractions(-8, 8, max_denominator=10**6))
def test_sine_and_cosine(q: Fraction) -> None:
    with working_bits(200):
        for (low, high), exact in zip(numbers().sine_cosine(q), (ball(q).sin(), ball(q).cos()), strict=True):
            assert ball(value(low)) <= exact <= ball(value(high))
            assert high - low < 2**20


def test_sine_and_cosine_of_0_are_exact() -> None:
    assert numbers().sine_cosine(Fraction(0)) == ((0, 0), (2**BITS, 2**BITS))


@pytest.mark.parametrize("q", [Fraction(81, 10), Fraction(-9)])
def test_an_angle_that_is_large(q: Fraction) -> None:
    with pytest.raises(limits.Rejected, match="not within 8"):
        numbers().sine_cosine(q)


coefficients = st.lists(st.integers(-(2**70), 2**70), min_size=1, max_size=20)


@given(coefficients, coefficients)
def test_convolution(a: list[int], b: list[int]) -> None:
    """Against sums of products."""
    exact = [sum(a[i] * b[k - i] for i in range(len(a)) if 0 <= k - i < len(b)) for k in range(len(a) + len(b) - 1)]
    assert numbers().convolution(a, b) == exact


@pytest.mark.parametrize("count", [1, 2, 127, 128, 255, 256, 400])
def test_convolution_of_the_largest(count: int) -> None:
    """All coefficients as long as their length allows: none runs into the next one."""
    for sign in (1, -1):
        a, b = [2**64 - 1] * count, [sign * (2**63 - 1)] * count
        found = numbers().convolution(a, b)
        assert found[count - 1] == count * a[0] * b[0]
        assert found[0] == found[-1] == a[0] * b[0]


def test_work_of_a_convolution_is_paid() -> None:
    poor = intervals.Numbers(BITS, limits.Meter(limits.Limits(), 10**5))
    with pytest.raises(limits.Rejected, match="the limit work"):
        poor.convolution([2**400] * 100, [2**400] * 100)
    assert intervals.karatsuba(10, 35) == 4 * 100
    assert intervals.karatsuba(140, 140) == 3 * 70**2


@given(pairs, pairs, points, points)
def test_products(a: tuple[int, int], b: tuple[int, int], s: Fraction, t: Fraction) -> None:
    found = numbers().mul(a, b)
    assert holds(found, inside(a, s) * inside(b, t))
    corners = [value(x) * value(y) for x in a for y in b]
    assert value(found[0] + 1) > min(corners)
    assert value(found[1] - 1) < max(corners)


@given(st.lists(pairs, min_size=2, max_size=2), st.lists(pairs, min_size=2, max_size=2), points)
def test_matrices(row: list[tuple[int, int]], column: list[tuple[int, int]], share: Fraction) -> None:
    ((found,),) = numbers().product([row], [[entry] for entry in column])
    assert holds(
        found, sum((inside(a, share) * inside(b, 1 - share) for a, b in zip(row, column, strict=True)), Fraction(0))
    )
    highest = [[b for _, b in row]]
    (up,) = numbers().apply_up(highest, [abs(b) for _, b in column])
    exact = sum((value(a) * value(abs(b)) for a, (_, b) in zip(highest[0], column, strict=True)), Fraction(0))
    assert value(up - 1) < exact <= value(up)


@given(st.lists(integers, min_size=1, max_size=5), st.tuples(points, points), points)
def test_polynomials(c: list[int], ends: tuple[Fraction, Fraction], share: Fraction) -> None:
    a, b = sorted(int(end * 2**BITS) for end in ends)
    tau = inside((a, b), share)
    assert holds(numbers().on(c, (a, b)), sum((value(v) * tau**k for k, v in enumerate(c)), Fraction(0)))


@given(st.lists(st.lists(st.integers(-8, 8), min_size=3, max_size=3), min_size=3, max_size=3))
def test_inverse(rows: list[list[int]]) -> None:
    exact = [[entry << BITS for entry in row] for row in rows]
    (a, b, c), (d, e, f), (g, h, i) = rows
    if a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g) == 0:
        with pytest.raises(limits.Rejected, match="a basis is singular"):
            numbers().inverse(exact)
        return
    found = numbers().product(numbers().inverse(exact), [[(entry, entry) for entry in row] for row in exact])
    assert all(holds(entry, Fraction(i == j)) for i, row in enumerate(found) for j, entry in enumerate(row))


@given(st.fractions(), pairs, pairs, points)
def test_terms_and_lengths(q: Fraction, a: tuple[int, int], b: tuple[int, int], share: Fraction) -> None:
    assert holds(numbers().term(q, [a, b]), q * inside(a, share) * inside(b, share))
    assert value(numbers().length([a, b])) ** 2 >= inside(a, share) ** 2 + inside(b, share) ** 2


@pytest.mark.parametrize(
    ("pair", "found"),
    [([1, -BITS], 1), ([-1, -BITS], -1), ([1, BITS - 1], 2 ** (2 * BITS - 1)), ([3, 0], 3 * 2**BITS), ([0, BITS], 0),
     ([2**BITS - 1, 0], (2**BITS - 1) * 2**BITS), ([2 ** (2 * BITS) - 1, -BITS], 2 ** (2 * BITS) - 1)],
)  # fmt: skip
def test_numbers_are_read_exactly(pair: list[int], found: int) -> None:
    assert numbers().read(pair) == found


@pytest.mark.parametrize(
    ("pair", "why"),
    [
        (1, "is not a number"), (None, "is not a number"), ("12", "is not a number"), ({"1": 1}, "is not a number"),
        ([1], "is not a number"), ([1, 0, 0], "is not a number"), ([True, 0], "is not a number"),
        ([1, "0"], "is not a number"), ([1, -BITS - 1], "is not a number"), ([0, BITS + 1], "is not a number"),
        ([1, BITS], "too large"), ([2**BITS, 0], "too large"), ([2 ** (2 * BITS), -BITS], "too large"),
    ],
)  # fmt: skip
def test_numbers_that_are_none(pair: Any, why: str) -> None:
    with pytest.raises(limits.Rejected, match=why):
        numbers().read(pair)


def test_what_is_exact_stays_exact() -> None:
    exact, one = numbers(), 2**BITS
    assert exact.on([5], (one, one)) == (5, 5)
    assert exact.on([5, -3], (one // 3, one // 3)) == (4, 5)
    assert exact.product([[(3, 3), (one, one)]], [[(one, one)], [(-7, -7)]]) == [[(-4, -4)]]
    assert exact.reciprocal((1, one)) == (one, one**2)
    assert exact.length([(3, 3), (-4, 1)]) == 5
    assert exact.common_denominator([Fraction(1, 15), Fraction(3), Fraction(-5, 9)]) == 45
    assert exact.multiple(-3, [1, -2, 0]) == [-3, 6, 0]
    assert exact.apply_up([[one, 2 * one], [0, 1]], [3, 4]) == [11, 1]


def test_intervals_and_lengths() -> None:
    assert intervals.wider((-3, 5), 7) == (-10, 12)
    assert [intervals.size(ends) for ends in ((-3, 2), (-2, 3), (4, 5), (-5, -4))] == [3, 3, 5, 5]
    assert intervals.longest([7, -(2**299), 1]) == 300 // limits.DIGIT + 1
    assert intervals.longest([]) == 1


def test_a_divisor_of_0() -> None:
    with pytest.raises(limits.Rejected, match="a divisor is not certainly positive"):
        numbers().reciprocal((0, 1))


@pytest.mark.parametrize("q", [8, -8])
def test_the_largest_angle(q: int) -> None:
    assert len(numbers().sine_cosine(Fraction(q))) == 2


LONG = {
    "interval": (lambda n, v: n.interval(Fraction(v, v + 1)), 1),
    "reciprocal": (lambda n, v: n.reciprocal((v, v)), 0),
    "term": (lambda n, v: n.term(Fraction(v, v + 1), [(v, v)] * 3), 2),
    "on": (lambda n, v: n.on([v] * 9, (0, 1)), 1),
    "product": (lambda n, v: n.product([[(v, v)] * 2] * 2, [[(v, v)] * 2] * 2), 2),
    "inverse": (lambda n, v: n.inverse([[v, 1], [1, v]]), 2),
    "length": (lambda n, v: n.length([(v, v)] * 4), 2),
    "apply_up": (lambda n, v: n.apply_up([[v] * 3] * 2, [v] * 3), 2),
    "common_denominator": (lambda n, v: n.common_denominator([Fraction(1, v), Fraction(1, v + 1)]), 2),
    "multiple": (lambda n, v: n.multiple(v, [v] * 5), 2),
    "convolution": (lambda n, v: n.convolution([v] * 3, [v] * 3), 1),
}
"""Operations on numbers of a length, and how their work grows: with this power of the length."""


@pytest.mark.parametrize("name", LONG)
def test_work_grows_with_the_lengths(name: str) -> None:
    """From numbers of 1,000 digits of the processor to 4,000: four or sixteen times as much, and never nothing."""
    operation, power = LONG[name]
    paid = []
    for count in (1000, 4000):
        meter = limits.Meter(limits.Limits(), 10**12)
        operation(intervals.Numbers(BITS, meter), 1 << (30 * count))
        paid.append(10**12 - meter.left)
        assert paid[-1] > count
    assert paid[1] > paid[0] * 4**power * 3 // 4


def test_work_of_sines_grows_with_the_bits() -> None:
    paid = []
    for bits in (64, 512):
        meter = limits.Meter(limits.Limits(), 10**12)
        intervals.Numbers(bits, meter).sine_cosine(Fraction(1, 3))
        paid.append(10**12 - meter.left)
    assert paid[1] > 8 * paid[0] > 0
