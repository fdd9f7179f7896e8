"""Values of F on boxes: the errors and the scale that come with them, more bits, smaller boxes.

Page: proofs/check.md.
"""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import combinations
from types import SimpleNamespace

import mpmath
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from must_reject import mutate
from samples.checker_models import (
    LIMITS,
    coefficient,
    number,
    on_a_column,
    theta,
)
from witnesses.theta import theta_witness

check = mutate.checker()


@given(st.fractions(-3, 8, max_denominator=100), st.fractions(-1, 6, max_denominator=30), st.integers(0, 40))
def test_signs_on_boxes_are_true(tau: Fraction, b: Fraction, width: int) -> None:
    checker = on_a_column(50_000_000)  # at an exact zero no accuracy is enough
    checker.bits = 90
    box = (b, b + Fraction(width, 200), tau, tau + Fraction(width, 100))
    for order in (0, 1, 2):
        try:
            sign = checker.sign(box, order, 2)
        except check.limits.Rejected:
            return
        for where in (Fraction(0), Fraction(1, 2), Fraction(1)):
            t, c = tau + where * (box[3] - tau), b + where * (box[1] - b)
            factor = math.prod(-c + i for i in range(order))
            assert sign * factor * theta_witness(t, c - order) >= 0


def test_discs_that_are_not_used_make_room(monkeypatch: pytest.MonkeyPatch) -> None:
    """All that are kept take at most half of the memory; the one that is asked for is the last to go."""
    sizes = iter([200_000, 250_000, 100_000, 600_000])

    def disc(*_: object) -> SimpleNamespace:
        size = next(sizes)
        return SimpleNamespace(bytes=lambda: size)

    monkeypatch.setattr(check.theta, "Local", disc)
    checker, zero = on_a_column(limits=LIMITS._replace(memory=1)), Fraction(0)
    one, _ = (checker.local(zero, zero, bits, zero) for bits in (64, 96))
    assert checker.local(zero, zero, 64, zero) is one
    three = checker.local(zero, zero, 144, zero)
    assert list(checker.locals.values()) == [one, three]
    four = checker.local(zero, zero, 216, zero)
    assert list(checker.locals.values()) == [four]


@given(st.sampled_from(["b", "tau", "both"]), st.integers(1, 4))
def test_the_parts_of_a_box_that_is_cut_are_the_whole(wide: str, splits: int) -> None:
    """Only boxes of one part in 2^splits are certain; those that were confirmed lie side by side and cover the box."""
    box, confirmed = (Fraction(2), Fraction(3), Fraction(-1), Fraction(3)), []

    def parts(part: tuple[Fraction, ...], *_: int) -> check.theta.Value:
        sizes = (part[1] - part[0], (part[3] - part[2]) / 4)
        small = sizes[0] * sizes[1] <= Fraction(1, 2**splits)
        if small:
            confirmed.append(part)
        in_b, in_tau = ((9, 1), (1, 9), (round(64 * sizes[0]), round(64 * sizes[1])))[["b", "tau", "both"].index(wide)]
        return check.theta.Value(
            7, 0 if small else in_tau, 0 if small else in_b, 0, check.theta.Scale(4, 20, Fraction(1))
        )

    checker = on_a_column()
    checker.value = parts  # type: ignore[method-assign]
    assert checker.sign(box, 0, splits) == 1
    assert len(confirmed) == 2**splits
    area = sum((high - low) * (end - start) for low, high, start, end in confirmed)
    assert area == 4, "they cover the box, since no two of them overlap"
    for one, other in combinations(confirmed, 2):
        assert one[1] <= other[0] or other[1] <= one[0] or one[3] <= other[2] or other[3] <= one[2]
    assert all(2 <= low < high <= 3 and -1 <= start < end <= 3 for low, high, start, end in confirmed)
    assert checker.sign(box, 0, splits - 1) == 0


class Known:
    """In the place of F on a disc: a series that is given, and what was asked for."""

    x, p, radius = 6, 20, 3

    def __init__(self, series: list[check.theta.Model]) -> None:
        self.series, self.asked = series, []

    def values(self, point: Fraction, s: Fraction) -> list[check.theta.Model]:
        self.asked.append((point, s))
        return self.series[:3]

    def expand(self, *question: object) -> list[check.theta.Model]:
        assert question == (*self.asked[-1], self.series[:3])
        return self.series

    def recurrence(self, *question: object) -> list[check.theta.Model]:
        assert question == (*self.asked[-1], self.series[:3])
        return self.series

    def in_b(self, a: check.theta.Model) -> check.theta.Model:
        return check.theta.Model([7 * m for m in a.m], 7 * a.error)


BIG = st.integers(-(10**12), 10**12)
BIG_MODELS = st.builds(check.theta.Model, st.lists(BIG, min_size=3, max_size=3), st.integers(0, 10**12))
NARROW, WIDE, EXACT = Fraction(1, 3 * 2**80), Fraction(1, 3), Fraction(1, 2)


@given(
    st.lists(BIG_MODELS, min_size=5, max_size=7), st.sampled_from([-1, 0, 1, 2]),
    st.sampled_from([Fraction(0), NARROW, WIDE, EXACT]), st.sampled_from([Fraction(0), NARROW, WIDE, EXACT]),
)  # fmt: skip
def test_the_sum_over_a_box_is_the_least_bound_of_its_terms(
    series: list[check.theta.Model], order: int, in_b: Fraction, in_tau: Fraction
) -> None:
    """Σ C(k, i)|m_kj| 2^-j over all terms but the first, and Σ C(k, i) e_k: less than 1 more for each number."""
    checker, known = on_a_column(), Known(series)
    low, start = Fraction(5, 2), Fraction(9, 7)
    checker.local = lambda *_: known  # type: ignore[method-assign]
    part = checker.value((low, low + in_b, start, start + in_tau), order, 64)
    i, factor = max(order, 0), 7 if order < 0 else 1
    terms = series[i:] if in_tau else series[i : i + 1]
    ((middle, s),) = known.asked
    assert abs(middle - start - in_tau / 2) <= Fraction(1, 2**64)
    assert middle == start or in_tau
    assert s == 1 if not in_tau else in_tau <= 2 * s <= in_tau + Fraction(2, 2**64)
    assert part.middle == factor * series[i].m[0]
    assert part.scale == (6, 20, s**i if order >= 0 else known.radius << 16)
    error = factor * sum(math.comb(k, i) * a.error for k, a in enumerate(terms, i))
    by_tau = factor * sum(
        math.comb(k, i) * Fraction(abs(m), 2**j) for k, a in enumerate(terms[1:], i + 1) for j, m in enumerate(a.m)
    )
    by_b = factor * sum(Fraction(abs(m), 2**j) for j, m in enumerate(series[i].m) if j)
    # What the width adds is an error where the box is wider by rounding only.
    exact = [0, 0, error]
    exact[2 if in_tau == NARROW else 0] += by_tau
    exact[2 if in_b == NARROW else 1] += by_b
    for found, least in zip((part.in_tau, part.in_b, part.error), exact, strict=True):
        assert least <= found <= least + 3 * sum(math.comb(k, i) for k in range(i, i + len(terms)))


@given(st.fractions(-9, 9), st.fractions(0, 3), st.integers(0, 40))
def test_boxes_are_rounded_outward(low: Fraction, width: Fraction, bits: int) -> None:
    start, end, wider = check.theta.outward(low, low + width, bits)
    assert start <= low <= low + width <= end
    if not width:
        assert (start, end, wider) == (low, low, False), "a point is not rounded"
        return
    assert max(start.denominator, end.denominator) <= 2**bits
    assert wider == (end - start > 2 * width)
    assert end - start <= width + Fraction(2, 2**bits)


LONG_POINTS = st.builds(
    lambda tau, k: tau + Fraction(k, 10**40 + 9), st.fractions(-3, 12, max_denominator=9), st.integers(0, 5)
)


@settings(max_examples=12)
@given(
    LONG_POINTS,
    st.sampled_from(["5/2", "-1/3", "22/7"]),
    st.sampled_from(["0", "1/1000", "1/100000000000000000000000000"]),
)
@example(Fraction(17, 10) + Fraction(3, 10**31), "7/2", "0")
@example(Fraction(17, 10) + Fraction(3, 10**31), "7/2", "1/10000000000000000000000000000000")
def test_parts_are_in_the_unit_and_the_scale_that_they_tell(tau: Fraction, parameter: str, width: str) -> None:
    """F^(k)/k! by the middle, the scale and what is not known, against 1F2; at points and on boxes, short and long."""
    b, checker = Fraction(parameter), on_a_column()
    box = (b, b, tau, tau + Fraction(width))
    for order in (0, 1, 2):
        part = checker.value(box, order, 64)
        x, p, scale = part.scale
        with mpmath.workdps(60):
            exact = coefficient(number(tau), number(b), order) * mpmath.mpf(2) ** p / mpmath.power(x, number(b))
            distance = abs(exact * number(scale) - part.middle)
            slack = part.in_tau + part.in_b + part.error
            assert distance <= slack
            assert width != "0" or (part.in_tau == 0 and slack * 2**20 < 2**p * scale)


@settings(max_examples=12)
@given(LONG_POINTS, st.integers(0, 5))
def test_the_coefficients_at_a_long_point_are_those_at_this_point(tau: Fraction, order: int) -> None:
    """No tail is left out at a point, so the lemma for orders up to 2 is not asked; b is as long."""
    b = Fraction(22, 7) + Fraction(1, 10**35)
    part = on_a_column().value((b, b, tau, tau), order, 64)
    x, p, scale = part.scale
    with mpmath.workdps(60):
        exact = coefficient(number(tau), number(b), order) * mpmath.mpf(2) ** p / mpmath.power(x, number(b))
        assert abs(exact * number(scale) - part.middle) <= part.error


def test_on_a_box_no_order_beyond_2_is_known() -> None:
    box = (Fraction(5, 2), Fraction(5, 2), Fraction(1), Fraction(9, 8))
    assert on_a_column().value(box, 2, 64).error
    with pytest.raises(check.limits.Rejected, match="orders up to 2"):
        on_a_column().value(box, 3, 64)


@pytest.mark.parametrize(
    ("point", "unit"), [("0", 1), ("1/9", 1), ("7/4", 1), ("2", 2), ("-7/2", 2), ("-4", 4), ("-63", 32)]
)
def test_the_scale_of_a_point(point: str, unit: int) -> None:
    """The largest power of 2 that is at most |τ|, and 1 near 0, to the power of the order."""
    b, tau = Fraction(5, 2), Fraction(point)
    assert [on_a_column().value((b, b, tau, tau), k, 64).scale.s for k in (0, 1, 3)] == [1, unit, unit**3]


def test_a_zero_that_is_exact_is_not_given_a_sign() -> None:
    limits = LIMITS._replace(bits=400)
    assert on_a_column(limits=limits).sign((Fraction(1), Fraction(1), Fraction(0), Fraction(0)), 0) == 0
    assert on_a_column(limits=limits).sign((Fraction(0), Fraction(1), Fraction(0), Fraction(0)), 0, 3) == 0


RATIONALS = st.fractions(-9, 9, max_denominator=9)
SIZES = st.fractions(0, 9, max_denominator=9)
SCALES = st.builds(check.theta.Scale, st.just(6), st.just(20), st.fractions(1, 9, max_denominator=4))
VALUES = st.builds(check.theta.Value, RATIONALS, SIZES, SIZES, SIZES, SCALES)


@given(VALUES, RATIONALS, RATIONALS, st.fractions(-1, 1))
def test_what_a_value_holds_its_multiples_and_sums_hold(
    value: check.theta.Value, factor: Fraction, middle: Fraction, place: Fraction
) -> None:
    """A number anywhere in it, and the same in another one: λ v is in λ V, v + w in V + W, v/s in V without its s."""
    other = value._replace(middle=middle)
    number, second = (one.middle + place * one.slack() for one in (value, other))
    assert value.low() <= number <= value.high()
    assert value.slack() == value.in_tau + value.in_b + value.error
    for found, exact in (
        (value.times(factor), factor * number),
        (value.plus(other), number + second),
        (value.unscaled(), number / value.scale.s),
    ):
        assert found.low() <= exact <= found.high()
    assert value.times(factor).slack() == abs(factor) * value.slack()
    assert value.plus(other).slack() == 2 * value.slack()
    assert value.times(factor).scale == value.plus(other).scale == value.scale
    assert value.unscaled().scale == (6, 20, 1)
    assert value.sign() == (number > 0) - (number < 0) or value.sign() == 0
    assert value.sign() or value.low() <= 0 <= value.high()


@pytest.mark.parametrize("wrong", [(7, 20, 1), (6, 21, 1), (6, 20, 2)])
def test_values_of_two_scales_are_not_added(wrong: tuple[int, int, int]) -> None:
    one, other = (check.theta.Value(1, 0, 0, 0, check.theta.Scale(*scale)) for scale in ((6, 20, 1), wrong))
    assert one.plus(one).middle == 2
    with pytest.raises(check.limits.Rejected, match="different scales"):
        one.plus(other)


@pytest.mark.parametrize(("tau", "parameter", "width"), [("-7/3", "5/2", "0"), ("5", "22/7", "1/99")])
def test_the_derivative_in_b_is_in_the_scale_that_it_tells(tau: str, parameter: str, width: str) -> None:
    """∂F/∂b + w F, w = v - log x, against difference quotients of 1F2."""
    b, h, tau = Fraction(parameter), mpmath.mpf(10) ** -20, Fraction(tau)
    part = on_a_column().value((b, b + Fraction(1, 512), tau, tau + Fraction(width)), -1, 64)
    x, p, scale = part.scale
    with mpmath.workdps(60):
        t, c = number(tau), number(b)
        weight = mpmath.mpf(round(math.log(x) * 2**16)) / 2**16 - mpmath.log(x)
        exact = (theta(t, c + h) - theta(t, c - h)) / (2 * h) + weight * theta(t, c)
        distance = abs(exact * mpmath.mpf(2) ** p / mpmath.power(x, c) * number(scale) - part.middle)
    assert distance <= part.slack() < abs(part.middle), "it is known up to less than itself"


def test_at_one_b_there_is_no_derivative_in_b() -> None:
    b, tau = Fraction(5, 2), Fraction(1)
    with pytest.raises(check.limits.Rejected, match="no derivative in b"):
        on_a_column().value((b, b, tau, 2 * tau), -1, 64)


@pytest.mark.parametrize(
    ("value", "blurred"), [((1, 2, 2, 1), True), ((1, 3, 2, 1), False), ((9, 0, 0, 0), True), ((0, 0, 1, 0), False)]
)
def test_an_error_asks_for_more_bits_and_a_width_for_smaller_boxes(value: tuple[int, ...], blurred: bool) -> None:
    assert check.theta.Value(*value, check.theta.Scale(6, 20, Fraction(1))).is_blurred() is blurred


def test_the_accuracy_that_answered_is_kept() -> None:
    """It is raised up to the first one that is not below the limit. Without a value nothing is tried again."""
    checker, asked = on_a_column(), []
    box = (Fraction(2), Fraction(3), Fraction(0), Fraction(1))

    def ask(part: object, bits: int) -> tuple[int, check.theta.Value]:
        asked.append((part, bits))
        sharp = check.theta.Value(0, 0, 0, 1, check.theta.Scale(6, 20, Fraction(1)))
        return (-1 if bits >= limit else 0), sharp

    limit = 10**9
    assert checker.settle(ask, box) == 0
    assert [bits for _, bits in asked][:3] == [64, 96, 144]
    assert asked[-2][1] < checker.limits.bits <= asked[-1][1]
    del asked[:]
    limit = 100
    assert checker.settle(ask, box) == -1
    assert checker.bits == 144
    del asked[:]
    assert checker.settle(lambda *question: (asked.append(question) or 0, None), box) == 0
    assert asked == [(box, 144)]
