"""The independent checker: its arithmetic against witnesses, what it accepts, its command line.

Page: proofs/check.md.
"""

from __future__ import annotations

import ast
import importlib.machinery
import importlib.util
import io
import math
import multiprocessing
import os
import random
import subprocess
import sys
from collections.abc import Callable
from fractions import Fraction
from itertools import combinations, islice, pairwise
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import mpmath
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from must_reject import mutate
from must_reject.mutate import GOOD, lines_of, text_of
from samples.strategies import ends, to_fmpq
from witnesses.theta import theta_witness

from gspot_verified.certificates.text import certificate_text
from gspot_verified.signs.cover.sign import sign as sign_on_ranges
from gspot_verified.signs.zeros.brackets import zeros_at
from gspot_verified.signs.zeros.zeros import zeros_on_range
from gspot_verified.theta_function.value.evaluate import evaluate

check = mutate.checker()
DIGITS = 120
ROUNDING = mpmath.mpf(10) ** -60  # of mpmath, in units of the last place of a model


LIMITS = check.Limits()
ENDLESS = check.Meter(LIMITS, 10**18)
NO_COLUMN = check.Column(Fraction(1), Fraction(2), 0, [])


def on_a_column(budget: int = 10**18, limits: check.Limits = LIMITS) -> check.ColumnCheck:
    return check.ColumnCheck(NO_COLUMN, limits, budget)


def local_at(low: Fraction, high: Fraction, bits: int) -> check.Local:
    return check.Local(low, high, bits, Fraction(0), ENDLESS)


def local(low: str, high: str, bits: int) -> check.Local:
    return local_at(Fraction(low), Fraction(high), bits)


def number(value: Fraction) -> mpmath.mpf:
    return mpmath.mpf(value.numerator) / value.denominator


def theta(tau: mpmath.mpf, b: mpmath.mpc) -> mpmath.mpc:
    """Theta for a complex parameter by three 1F2 of mpmath."""
    third, z = mpmath.mpf(1) / 3, tau**3 / 9
    front, g = (
        2 * mpmath.pi * mpmath.power(3, 2 * b / 3 - mpmath.mpf(1) / 2),
        [mpmath.rgamma((j - b) / 3) for j in range(3)],
    )
    return front * (
        g[1] * g[2] * mpmath.hyp1f2(-b / 3, third, 2 * third, z)
        + mpmath.cbrt(3) * g[0] * g[2] * tau * mpmath.hyp1f2((1 - b) / 3, 2 * third, 4 * third, z)
        + mpmath.cbrt(9) * g[0] * g[1] * tau**2 / 2 * mpmath.hyp1f2((2 - b) / 3, 4 * third, 5 * third, z)
    )


def coefficient(tau: mpmath.mpf, b: mpmath.mpc, k: int) -> mpmath.mpc:
    """F^(k)(tau)/k!."""
    return mpmath.rf(-b, k) * theta(tau, b - k) / mpmath.factorial(k)


def polynomial(model: check.Model, eta: mpmath.mpc) -> mpmath.mpc:
    return sum((m * eta**j for j, m in enumerate(model.m)), mpmath.mpf(0))


def points_of_the_disc(seed: int, number_of_points: int) -> list[mpmath.mpc]:
    source = random.Random(seed)
    inside = [source.uniform(0, 1) * mpmath.expjpi(source.uniform(0, 2)) for _ in range(number_of_points)]
    return [mpmath.mpc(1), mpmath.mpc(-1), mpmath.mpc(0, 1), mpmath.mpc(0), *inside]


COLUMNS = [
    ("-1", "-1/2", 60),
    ("3/4", "3/4", 90),
    ("2", "9/4", 70),
    ("35/3", "35/3", 100),
    ("11", "12", 90),
    ("49/2", "197/8", 120),
    ("-7/2", "-1", 60),
    ("0", "1/1000000000000000000000000000000", 80),
]


@pytest.mark.parametrize(("low", "high", "bits"), COLUMNS)
def test_models_hold_on_the_complex_disc(low: str, high: str, bits: int) -> None:
    """Values along τ, and local coefficients at a point, against mpmath at complex b."""
    model = local(low, high, bits)
    with mpmath.workdps(DIGITS):
        for i, eta in enumerate(points_of_the_disc(7, 3)):
            b = (model.centre + model.radius * eta) / model.unit
            unit = mpmath.mpf(2) ** model.p / mpmath.power(model.x, b)
            for tau, s in [
                (Fraction(-model.x), Fraction(1)),
                (Fraction(-3, 2), Fraction(1, 3)),
                (Fraction(3 * i), Fraction(2)),
            ]:
                for k, value in enumerate(
                    list(zip(range(7), model.recurrence(tau, s, model.values(tau, s)), strict=False))
                ):
                    exact = coefficient(number(tau), b, k) * number(s) ** k * unit
                    assert abs(polynomial(value[1], eta) - exact) <= value[1].error


@pytest.mark.parametrize(("low", "high", "bits"), COLUMNS)
def test_models_are_sharp_enough(low: str, high: str, bits: int) -> None:
    values = local(low, high, bits).values(Fraction(0), Fraction(1))
    assert max(value.norm() for value in values) > 2 ** (bits // 2 - 20) * max(value.error for value in values)


@given(
    st.fractions(-3, 12, max_denominator=1000),
    st.fractions(-5, 12, max_denominator=50).filter(lambda b: b.denominator > 1),
)
def test_ratio_agrees_with_evaluate(tau: Fraction, b: Fraction) -> None:
    """Theta(tau, b)/Theta(0, b), free of the checker's normalisation, in the library's balls."""
    model = local_at(b, b, 128)
    (top, *_), (bottom, *_) = (model.values(point, Fraction(1)) for point in (tau, Fraction(0)))
    ratio = evaluate(to_fmpq(tau), to_fmpq(b), digits=40).value / evaluate(0, to_fmpq(b), digits=40).value
    low, high = ends(ratio)
    assert bottom.error < abs(bottom.m[0])
    margin = Fraction(top.error * abs(bottom.m[0]) + bottom.error * abs(top.m[0]), bottom.m[0] ** 2) * 2
    assert low - margin <= Fraction(top.m[0], bottom.m[0]) <= high + margin


@given(st.fractions(-3, 8, max_denominator=100), st.fractions(-1, 6, max_denominator=30), st.integers(0, 40))
def test_signs_on_boxes_are_true(tau: Fraction, b: Fraction, width: int) -> None:
    checker = on_a_column(50_000_000)  # at an exact zero no accuracy is enough
    checker.bits = 90
    box = (b, b + Fraction(width, 200), tau, tau + Fraction(width, 100))
    for order in (0, 1, 2):
        try:
            sign = checker.sign(box, order, 2)
        except check.Rejected:
            return
        for where in (Fraction(0), Fraction(1, 2), Fraction(1)):
            t, c = tau + where * (box[3] - tau), b + where * (box[1] - b)
            factor = math.prod(-c + i for i in range(order))
            assert sign * factor * theta_witness(t, c - order) >= 0


def test_derivative_in_b_with_its_weight() -> None:
    """in_b bounds radius·2^16·unit times the derivative of F/x^b in b, plus v F/x^b."""
    model = local("2", "17/8", 90)
    a, h = model.values(Fraction(1, 8), Fraction(1))[0], mpmath.mpf(10) ** -30
    result, v = model.in_b(a), mpmath.mpf(round(math.log(model.x) * 2**16)) / 2**16
    with mpmath.workdps(DIGITS):
        for eta in (mpmath.mpf(-1) / 2, mpmath.mpf(0), mpmath.mpf(1) / 2):
            b, radius = (model.centre + model.radius * eta) / model.unit, mpmath.mpf(model.radius) / model.unit

            def scaled(c: mpmath.mpf) -> mpmath.mpf:
                return theta(mpmath.mpf(1) / 8, c) / mpmath.power(model.x, c) * mpmath.mpf(2) ** model.p

            exact = ((scaled(b + h) - scaled(b - h)) / (2 * h) + v * scaled(b)) * radius * 2**16 * model.unit
            assert abs(polynomial(result, eta) - exact) <= result.error


@given(st.lists(st.integers(-(10**6), 10**6), min_size=6, max_size=12), st.fractions(-1, 1, max_denominator=99))
def test_taylor_shift(coefficients: list[int], u: Fraction) -> None:
    p = 40
    for i, value in enumerate(check.moved([check.Model([c << p], 3) for c in coefficients], u, p, ENDLESS)):
        exact = sum(math.comb(k, i) * c * u ** (k - i) for k, c in enumerate(coefficients) if k >= i)
        assert abs(value.m[0] - exact * 2**p) <= value.error <= 2**34


@given(st.integers(-20, 20), st.integers(1, 4), st.integers(-30, 30))
def test_tail_lemma(point: int, s: int, b: int) -> None:
    """The error of the last coefficient bounds what is left out, for exact rational coefficients."""
    model = local_at(Fraction(b), Fraction(b), 60)
    start = [check.Model([value << model.p], 0) for value in (3, -2, 5)]
    series = model.expand(Fraction(point), Fraction(s), start)
    c = [Fraction(3), Fraction(-2), Fraction(5)]
    for k in range(len(series) + 60):
        c.append((point * s**2 * (k + 1) * c[k + 1] + s**3 * (k - b) * c[k]) / ((k + 1) * (k + 2) * (k + 3)))
    n = len(series)
    for k, value in enumerate(series):
        assert abs(value.m[0] - c[k] * 2**model.p) <= value.error
    for i in range(3):
        rest = sum(math.comb(k, i) * abs(c[k]) for k in range(n, len(c))) * 2**model.p
        known = abs(series[-1].m[0] - c[n - 1] * 2**model.p)
        assert math.comb(n - 1, i) * known + rest <= math.comb(n - 1, i) * series[-1].error


@given(st.fractions(-40, 40, max_denominator=9), st.fractions(0, 3, max_denominator=9), st.integers(-2, 60))
def test_the_hypothesis_of_the_tail_lemma(point: Fraction, s: Fraction, i: int) -> None:
    square, cube = check.tail_factors(point, s)
    assert square >= abs(point) * s**2
    assert cube >= s**3
    for b in (1, 5, 40):
        q = abs(point) * s**2 / ((i + 2) * (i + 3)) + (i + b) * s**3 / ((i + 1) * (i + 2) * (i + 3)) if i >= 0 else 1
        assert not check.tail_falls(square, cube, i, b) or q <= Fraction(1, 2)


def test_the_tail_lemma_at_its_limit() -> None:
    """2(a(i+1) + c(i+B)) = (i+1)(i+2)(i+3) holds, and one more does not: i = 1, 2(2a + c(1+B)) ≤ 24."""
    assert check.tail_falls(0, 3, 1, 3)
    assert check.tail_falls(6, 0, 1, 3)
    assert not check.tail_falls(7, 0, 1, 3)
    assert not check.tail_falls(0, 3, 1, 4)
    assert check.tail_falls(0, 0, 0, 1)
    assert not check.tail_falls(0, 0, -1, 1)


@pytest.mark.parametrize(("low", "high"), [("7/3", "7/3"), ("-7/2", "-7/2"), ("2", "3"), ("5", "5"), ("2", "17/8")])
def test_the_tail_lemma_is_asked_for_three_sums_at_once(low: str, high: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """B ≥ sup|b| + 2, because F'' has b - 2 in the place of b; i = n - 5, the least index of the three."""
    asked: list[tuple[int, int, int, int]] = []
    falls, model = check.tail_falls, local(low, high, 60)
    start = model.values(Fraction(-3), Fraction(3, 2))
    monkeypatch.setattr(check, "tail_falls", lambda *question: asked.append(question) or falls(*question))
    largest = Fraction(abs(model.centre) + model.radius, model.unit)
    series = model.expand(Fraction(-3), Fraction(3, 2), start)
    assert {(square, cube) for square, cube, _, _ in asked} == {(7, 4)}  # |τ| s² = 27/4, s³ = 27/8
    assert [i for _, _, i, _ in asked] == list(range(-4, len(series) - 4))
    assert all(largest + 2 <= b <= largest + 3 for *_, b in asked)


def test_an_operation_costs_200_products() -> None:
    meter = check.Meter(LIMITS, 10_000)
    meter.spend(1, 2)
    assert meter.left == 10_000 - 401
    meter.spend(9_599, 0)
    with pytest.raises(check.Rejected, match="the limit work"):
        meter.spend(1, 0)


def test_what_is_kept_for_one_disc_is_counted() -> None:
    """Three models for each anchor, and the series at the last two anchors: 4 bytes for 30 bits, at least."""
    model = local("2", "17/8", 60)
    assert model.bytes() >= sum(value.bytes() for values in model.anchors for value in values) > 300
    before = model.bytes()
    model.values(Fraction(0), Fraction(1))
    kept = [a for series, _ in model.kept_series.values() for one in series for a in one]
    anchors = [value for values in model.anchors for value in values]
    assert model.bytes() == sum(a.bytes() for a in [*kept, *anchors]) > before
    assert all(a.bytes() >= sum(length_of(*a.m, a.error)) * 4 for a in kept)


def test_discs_that_are_not_used_make_room(monkeypatch: pytest.MonkeyPatch) -> None:
    """All that are kept take at most half of the memory; the one that is asked for is the last to go."""
    sizes = iter([200_000, 250_000, 100_000, 600_000])

    def disc(*_: object) -> SimpleNamespace:
        size = next(sizes)
        return SimpleNamespace(bytes=lambda: size)

    monkeypatch.setattr(check, "Local", disc)
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

    def parts(part: tuple[Fraction, ...], *_: int) -> check.Enclosed:
        sizes = (part[1] - part[0], (part[3] - part[2]) / 4)
        small = sizes[0] * sizes[1] <= Fraction(1, 2**splits)
        if small:
            confirmed.append(part)
        in_b, in_tau = ((9, 1), (1, 9), (round(64 * sizes[0]), round(64 * sizes[1])))[["b", "tau", "both"].index(wide)]
        return check.Enclosed(7, 0 if small else in_tau, 0 if small else in_b, 0, (4, 20), 1)

    checker = on_a_column()
    checker.parts = parts  # type: ignore[method-assign]
    assert checker.sign(box, 0, splits) == 1
    assert len(confirmed) == 2**splits
    area = sum((high - low) * (end - start) for low, high, start, end in confirmed)
    assert area == 4, "they cover the box, since no two of them overlap"
    for one, other in combinations(confirmed, 2):
        assert one[1] <= other[0] or other[1] <= one[0] or one[3] <= other[2] or other[3] <= one[2]
    assert all(2 <= low < high <= 3 and -1 <= start < end <= 3 for low, high, start, end in confirmed)
    assert checker.sign(box, 0, splits - 1) == 0


@pytest.mark.parametrize("sign", [-1, 1])
def test_a_value_far_beyond_a_level_is_seen_at_the_first_accuracy(sign: int) -> None:
    """Neither more bits nor smaller boxes are asked for: the error is a small part of the value."""
    asked, b = [], Fraction(3, 2)

    def parts(*question: object) -> check.Enclosed:
        asked.append(question)
        return check.Enclosed(sign << 20, 1, 0, 10, (4, 20), 1)

    checker = on_a_column()
    checker.parts = parts  # type: ignore[method-assign]
    box = (b, b, Fraction(1), Fraction(2))
    assert not checker.within(box, Fraction(7), splits=4)  # |F| is near 4^b = 8
    assert len(asked) == 1
    assert checker.within(box, Fraction(9), splits=4)


class Known:
    """In the place of F on a disc: a series that is given, and what was asked for."""

    x, p = 6, 20

    def __init__(self, series: list[check.Model]) -> None:
        self.series, self.asked = series, []

    def values(self, point: Fraction, s: Fraction) -> list[check.Model]:
        self.asked.append((point, s))
        return self.series[:3]

    def expand(self, *question: object) -> list[check.Model]:
        assert question == (*self.asked[-1], self.series[:3])
        return self.series

    def recurrence(self, *question: object) -> list[check.Model]:
        assert question == (*self.asked[-1], self.series[:3])
        return self.series

    def in_b(self, a: check.Model) -> check.Model:
        return check.Model([7 * m for m in a.m], 7 * a.error)


BIG = st.integers(-(10**12), 10**12)
BIG_MODELS = st.builds(check.Model, st.lists(BIG, min_size=3, max_size=3), st.integers(0, 10**12))
NARROW, WIDE, EXACT = Fraction(1, 3 * 2**80), Fraction(1, 3), Fraction(1, 2)


@given(
    st.lists(BIG_MODELS, min_size=5, max_size=7), st.sampled_from([-1, 0, 1, 2]),
    st.sampled_from([Fraction(0), NARROW, WIDE, EXACT]), st.sampled_from([Fraction(0), NARROW, WIDE, EXACT]),
)  # fmt: skip
def test_the_sum_over_a_box_is_the_least_bound_of_its_terms(
    series: list[check.Model], order: int, in_b: Fraction, in_tau: Fraction
) -> None:
    """Σ C(k, i)|m_kj| 2^-j over all terms but the first, and Σ C(k, i) e_k: less than 1 more for each number."""
    checker, known = on_a_column(), Known(series)
    low, start = Fraction(5, 2), Fraction(9, 7)
    checker.local = lambda *_: known  # type: ignore[method-assign]
    part = checker.parts((low, low + in_b, start, start + in_tau), order, 64)
    i, factor = max(order, 0), 7 if order < 0 else 1
    terms = series[i:] if in_tau else series[i : i + 1]
    ((middle, s),) = known.asked
    assert abs(middle - start - in_tau / 2) <= Fraction(1, 2**64)
    assert middle == start or in_tau
    assert s == 1 if not in_tau else in_tau <= 2 * s <= in_tau + Fraction(2, 2**64)
    assert part.middle == factor * series[i].m[0]
    assert (part.unit, part.scale) == ((6, 20), s**i)
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


def test_the_left_tail_at_its_limit() -> None:
    """At b = 1/2 3x³ = |b(b - 1)(b - 2)| for x = 1/2: that is not enough, a little more is."""
    half = Fraction(1, 2)
    assert not on_a_column().left_holds(half, half, 0, half)
    assert on_a_column().left_holds(half, half, 0, half * (1 + Fraction(1, 2**20)))


@given(
    st.integers(0, 10**6), st.integers(0, 9), st.fractions(-9, 9, max_denominator=50),
    st.fractions(0, 3, max_denominator=50), st.integers(1, 9),
)  # fmt: skip
def test_the_bound_of_the_first_term_left_out(bound: int, n: int, b: Fraction, radius: Fraction, x: int) -> None:
    """T for N = n + 1 from T for N = n, in rationals; rounded up by less than 1."""
    unit = 2 * math.lcm(b.denominator, radius.denominator)
    found = check.next_bound(bound, n, int(b * unit), int(radius * unit), unit, x)
    factors = math.prod((abs(i - b) + radius for i in (3 * n, 3 * n + 1, 3 * n + 2)), start=Fraction(bound))
    assert found - 1 < factors / (3 * (n + 1) * x**3) <= found


@given(st.integers(0, 10**6), st.integers(1, 20), st.integers(1, 20), st.integers(1, 9))
def test_the_rests_of_the_enveloping_series(bound: int, n: int, reach: int, x: int) -> None:
    far, found = 3 * n + reach, check.rests(bound, n, reach, x)
    exact = (Fraction(bound), Fraction(bound * far, x), Fraction(bound * far * (far + 1), x**2))
    assert all(rest - 1 < value <= rest for value, rest in zip(exact, found, strict=True))


@pytest.mark.parametrize(
    ("low", "high"), [("7/3", "7/3"), ("-5/2", "-5/2"), ("21/4", "21/4"), ("7/3", "5/2"), ("1", "2")]
)
@pytest.mark.parametrize("x", [1, 2, 3])
def test_a_start_that_is_too_near_has_a_large_error(
    low: str, high: str, x: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """There what the enveloping series leaves out is most of the error, and at a point b it is seldom much less."""
    monkeypatch.setattr(check, "start_for", lambda *_: x)
    model = local(low, high, 60)
    with mpmath.workdps(DIGITS):
        for eta in points_of_the_disc(3, 3):
            b = (model.centre + model.radius * eta) / model.unit
            for k, value in enumerate(model.anchors[0]):
                exact = coefficient(mpmath.mpf(-x), b, k) * 2**k * mpmath.mpf(2) ** model.p / mpmath.power(x, b)
                assert abs(polynomial(value, eta) - exact) <= value.error


@given(st.integers(-(2**200), 2**200))
def test_the_length_of_an_integer_is_not_too_small(value: int) -> None:
    """A budget that counts too little is none."""
    assert max(1, Fraction(value.bit_length(), 30)) <= check.digits(value) <= value.bit_length() // 30 + 1


def assert_rounded(found: check.Model, exact: list[Fraction], error: Fraction) -> None:
    """The error holds what the exact model has, and less than 1 for each coefficient and for the error itself."""
    lost = sum(abs(a - b) for a, b in zip(exact, found.m, strict=True))
    assert lost + error <= found.error <= error + 1 + len(exact)


SMALL = st.integers(-3, 3) | st.integers(-(10**6), 10**6)
MODELS = st.builds(check.Model, st.lists(SMALL, min_size=4, max_size=4), st.integers(0, 9) | st.integers(0, 10**6))
RATIONALS = st.fractions(-6, 6, max_denominator=40)


@example(Fraction(0), Fraction(0), check.Model([-1] * 4, 44), 1, 45)
@given(RATIONALS, st.fractions(0, 2, max_denominator=40), MODELS, st.integers(-9, 30), st.sampled_from([1, 7, -6, 45]))
def test_a_linear_factor_in_rationals(b: Fraction, width: Fraction, a: check.Model, i: int, divisor: int) -> None:
    """(i - b) a/divisor for b = b_0 + R η: what is cut off is R |m_last|, and ‖i - b‖ = |i - b_0| + R."""
    model = small_local(b, b + width)
    middle, radius = b + width / 2, width
    exact = [((i - middle) * x - radius * y) / divisor for x, y in zip(a.m, [0, *a.m[:-1]], strict=True)]
    error = (abs(i - middle) + radius) * a.error + radius * abs(a.m[-1])
    assert_rounded(model.linear(a, i, divisor), exact, error / abs(divisor))


@example(
    Fraction(-1), Fraction(0), Fraction(0), Fraction(1), (check.Model([-1] * 4, 5),) + (check.Model([0] * 4, 0),) * 2
)
@given(
    RATIONALS, st.fractions(0, 2, max_denominator=40), RATIONALS, st.fractions(1, 5, max_denominator=7),
    st.tuples(MODELS, MODELS, MODELS),
)  # fmt: skip
def test_the_recurrence_in_rationals(
    b: Fraction, width: Fraction, point: Fraction, s: Fraction, start: tuple[check.Model, ...]
) -> None:
    model = small_local(b, b + width)
    middle, radius = b + width / 2, width
    found = list(islice(model.recurrence(point, s, start), 7))
    assert found[:3] == list(start)
    for k, (a, c) in enumerate(pairwise(found[:5])):
        one, zero = point * s**2 * (k + 1), s**3
        d = (k + 1) * (k + 2) * (k + 3)
        moved = [0, *a.m[:-1]]
        exact = [
            (one * y + zero * ((k - middle) * x - radius * z)) / d for x, y, z in zip(a.m, c.m, moved, strict=True)
        ]
        error = abs(one) * c.error + zero * ((abs(k - middle) + radius) * a.error + radius * abs(a.m[-1]))
        assert_rounded(found[k + 3], exact, error / d)


@example([check.Model([-1] * 4, 97)] * 4, Fraction(1, 99), 90)
@given(st.lists(MODELS, min_size=4, max_size=7), st.fractions(-1, 1, max_denominator=99), st.sampled_from([8, 40, 90]))
def test_the_taylor_shift_in_rationals(series: list[check.Model], u: Fraction, p: int) -> None:
    for i, value in enumerate(check.moved(series, u, p, ENDLESS)):
        weights = [math.comb(k, i) * u ** max(k - i, 0) for k in range(len(series))]
        exact = [sum(map(lambda w, m: w * m, weights, column)) for column in zip(*(a.m for a in series), strict=True)]
        lost = sum(abs(a - b) for a, b in zip(exact, value.m, strict=True))
        error = sum(abs(w) * a.error for w, a in zip(weights, series, strict=True))
        rounding = sum(math.comb(k, i) * k * a.norm() for k, a in enumerate(series)) / Fraction(2**p)
        assert lost + error <= value.error
        # The rounded powers of u may be larger than |u|^k by k units.
        assert value.error <= error + 2 * rounding + 1 + 4


@given(RATIONALS, st.fractions(0, 2, max_denominator=40), MODELS)
def test_the_derivative_in_b_in_integers(b: Fraction, width: Fraction, a: check.Model) -> None:
    """radius·v·2^16·unit... P + P' and ‖ε'‖ ≤ 2e: no rounding at all."""
    model = small_local(b, b + width)
    v, factor = round(math.log(model.x) * 2**16), model.unit * 2**16
    found = model.in_b(a)
    derivative = [j * m for j, m in enumerate(a.m)][1:]
    assert found.m == [factor * x + model.radius * v * y for x, y in zip([*derivative, 0], a.m, strict=True)]
    assert found.error == (2 * factor + model.radius * v) * a.error


@given(
    st.fractions(-1, 12, max_denominator=30),
    st.fractions(0, 1, max_denominator=30),
    st.fractions(0, 5, max_denominator=9),
)
def test_the_left_tail_in_rationals(low: Fraction, width: Fraction, x: Fraction) -> None:
    """tails.md, τ → -∞, written out."""
    n = math.floor(low)
    high = min(low + width, Fraction(n + 1))
    number = max(1, n // 3 + 1)
    product = math.prod(max(abs(low - i), abs(high - i)) for i in range(3 * number))
    holds = x > 0 and x ** (3 * number) * 3**number * math.factorial(number) > product
    assert on_a_column().left_holds(low, high, n, x) is bool(holds)


@pytest.mark.parametrize(
    ("low", "high", "growth"),
    [("7/3", "7/3", 1), ("2", "9/4", 5), ("2", "3", 5), ("-7/2", "-1", 125), ("40", "40", 1), ("-30", "-30", 1)],
)
def test_what_the_start_leaves_out(low: str, high: str, growth: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """g T for g = 5^⌈R⌉ and the N of the sum, 3N ≥ B + 1/2, is what goes into the errors."""
    asked: list[tuple[int, int, int, int]] = []
    left_out = [10**80, 2 * 10**80, 3 * 10**80]
    monkeypatch.setattr(check, "rests", lambda *arguments: asked.append(arguments) or left_out)
    model = local(low, high, 60)
    ((bound, n, reach, x),) = asked
    largest = Fraction(abs(model.centre) + model.radius, model.unit)
    assert x == model.x
    assert reach >= largest
    assert 3 * n >= largest + Fraction(1, 2)
    start = 1 << model.p
    for i in range(n):
        start = check.next_bound(start, i, model.centre, model.radius, model.unit, x)
    assert bound == growth * start
    assert [a.error // 10**79 for a in model.anchors[0]] == [10, 40, 60]


@pytest.mark.parametrize(("low", "high"), [("2", "9/4"), ("7/3", "3"), ("-5/2", "-1")])
@pytest.mark.parametrize("degree", [1, 2, 3])
def test_a_start_of_low_degree_has_what_it_lacks_in_its_error(
    low: str, high: str, degree: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(check, "degree_for", lambda *_: degree)
    model = local(low, high, 60)
    with mpmath.workdps(DIGITS):
        for eta in points_of_the_disc(5, 2):
            b = (model.centre + model.radius * eta) / model.unit
            for k, value in enumerate(model.anchors[0]):
                assert len(value.m) == degree
                exact = coefficient(mpmath.mpf(-model.x), b, k) * 2**k / mpmath.power(model.x, b)
                assert abs(polynomial(value, eta) - exact * mpmath.mpf(2) ** model.p) <= value.error


@pytest.mark.parametrize("x", [2, 4, 8])
@pytest.mark.parametrize("b", [0, 1, 2])
def test_a_start_without_rounding_is_exact(b: int, x: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """F(-x) = x^b for b = 0, 1, 2: no division of the sum leaves a rest, and at a point nothing depends on η."""
    monkeypatch.setattr(check, "start_for", lambda *_: x)
    monkeypatch.setattr(check, "degree_for", lambda *_: 3)
    model = local(str(b), str(b), 60)
    one = 1 << model.p
    exact = [Fraction(one), Fraction(-2 * b * one, x), Fraction(2 * b * (b - 1) * one, x**2)]
    assert [a.m for a in model.anchors[0]] == [[int(value), 0, 0] for value in exact]


def length_of(*values: int) -> list[Fraction]:
    return [Fraction(value.bit_length(), 30) for value in values]


@pytest.mark.parametrize("long", range(4))
def test_steps_are_counted_with_the_lengths_of_their_numbers(long: int) -> None:
    """Each long operand is seen: its products are taken from the budget before they are made."""
    huge = 10**900
    model = small_local(Fraction(1), Fraction(3, 2) + (Fraction(1, huge) if long == 0 else 0))
    model.meter = check.Meter(LIMITS, 10**18)
    a, i, divisor = check.Model([huge, huge], 0), huge if long == 1 else 3, huge if long == 2 else 3
    model.linear(a, i, divisor)
    n, r, d = i * model.unit - model.centre, model.radius, divisor * model.unit
    (one,) = length_of(huge)
    assert 10**18 - model.meter.left >= 2 * one * sum(length_of(n, r, d)) > 0
    model.meter = check.Meter(LIMITS, 10**18)
    point = Fraction(1, huge) if long == 2 else Fraction(huge if long == 1 else 3)
    start = [check.Model([huge, huge], 0)] * 3
    list(islice(model.recurrence(point, Fraction(1), start), 4))
    common = point.denominator * model.unit
    n, r, f, d = common // model.unit * model.centre, common // model.unit * model.radius, common * point, 6 * common
    assert 10**18 - model.meter.left >= 2 * one * sum(length_of(n, r, int(f), d)) / 2 > 0
    meter = check.Meter(LIMITS, 10**18)
    u, p = (
        (Fraction(1, 3), Fraction(1, huge), Fraction(huge - 1, huge), Fraction(2, 3))[long],
        3000 if long == 3 else 60,
    )
    check.moved(start * 2, u, p, meter)
    powers = 6 * Fraction(p, 30) * sum(length_of(u.numerator, u.denominator))
    assert 10**18 - meter.left >= powers + 3 * 6 * 2 * one * Fraction(p, 30) > 1_000


def small_local(low: Fraction, high: Fraction) -> check.Local:
    """Cheap to make: only its b and its degree are used."""
    model = object.__new__(check.Local)
    model.unit = 2 * math.lcm(low.denominator, high.denominator)
    model.centre, model.radius = int((low + high) / 2 * model.unit), int((high - low) * model.unit)
    model.x, model.meter = 6, ENDLESS
    return model


@given(st.lists(st.integers(-99, 99), min_size=1, max_size=6), st.integers(0, 99), st.fractions(-9, 9))
@example([-1] * 6, 44, Fraction(1, 45))
def test_models_are_rounded_into_their_error(m: list[int], error: int, factor: Fraction) -> None:
    product = check.Model(m, error).times(factor)
    assert_rounded(product, [factor * a for a in m], abs(factor) * error)
    for first in (0, 1):
        terms = sum(Fraction(abs(a), 2**j) for j, a in enumerate(m) if j >= first)
        assert 0 <= check.Model(m, error).spread(first) - terms <= len(m[first:])
    assert check.Model(m, error).norm() == sum(map(abs, m)) + error


@given(st.fractions(-9, 9), st.fractions(0, 3), st.integers(0, 40))
def test_boxes_are_rounded_outward(low: Fraction, width: Fraction, bits: int) -> None:
    start, end, wider = check.outward(low, low + width, bits)
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
        part = checker.parts(box, order, 64)
        x, p = part.unit
        with mpmath.workdps(60):
            exact = coefficient(number(tau), number(b), order) * mpmath.mpf(2) ** p / mpmath.power(x, number(b))
            distance = abs(exact * number(part.scale) - part.middle)
            slack = part.in_tau + part.in_b + part.error
            assert distance <= slack
            assert width != "0" or (part.in_tau == 0 and slack * 2**20 < 2**p * part.scale)


@settings(max_examples=12)
@given(LONG_POINTS, st.integers(0, 5))
def test_the_coefficients_at_a_long_point_are_those_at_this_point(tau: Fraction, order: int) -> None:
    """No tail is left out at a point, so the lemma for orders up to 2 is not asked; b is as long."""
    b = Fraction(22, 7) + Fraction(1, 10**35)
    part = on_a_column().parts((b, b, tau, tau), order, 64)
    x, p = part.unit
    with mpmath.workdps(60):
        exact = coefficient(number(tau), number(b), order) * mpmath.mpf(2) ** p / mpmath.power(x, number(b))
        assert abs(exact * number(part.scale) - part.middle) <= part.error


def test_on_a_box_no_order_beyond_2_is_known() -> None:
    box = (Fraction(5, 2), Fraction(5, 2), Fraction(1), Fraction(9, 8))
    assert on_a_column().parts(box, 2, 64).error
    with pytest.raises(check.Rejected, match="orders up to 2"):
        on_a_column().parts(box, 3, 64)


@pytest.mark.parametrize(
    ("point", "unit"), [("0", 1), ("1/9", 1), ("7/4", 1), ("2", 2), ("-7/2", 2), ("-4", 4), ("-63", 32)]
)
def test_the_scale_of_a_point(point: str, unit: int) -> None:
    """The largest power of 2 that is at most |τ|, and 1 near 0, to the power of the order."""
    b, tau = Fraction(5, 2), Fraction(point)
    assert [on_a_column().parts((b, b, tau, tau), k, 64).scale for k in (-1, 0, 1, 3)] == [1, 1, unit, unit**3]


@pytest.mark.parametrize("n", [2, 5, 9])
def test_a_tail_at_a_long_point(n: int) -> None:
    """All orders up to n are needed, at a point whose denominator is beyond every accuracy that is tried."""
    beta, point = n + Fraction(3, 2), str(n + 3 + Fraction(1, 10**2000))
    statement = {"beta": f"[{beta}, {beta}]", "kind": "sign", "sign": (-1) ** n, "tau": f"[{point}, inf)"}
    data = text_of(lines_of(statement, ([str(beta)] * 2, [["right", point, 0]])))
    assert check.check_text(data).startswith("dΘ/dτ " + "><"[n % 2])
    statement["sign"] *= -1
    with pytest.raises(check.Rejected, match="gives dΘ/dτ the sign"):
        check.check_text(text_of(lines_of(statement, ([str(beta)] * 2, [["right", point, 0]]))))


FAILURES = [
    IndexError, KeyError, RecursionError, ZeroDivisionError, OverflowError, MemoryError, AssertionError, RuntimeError,
    AttributeError, TypeError, UnicodeError, OSError, NotImplementedError,
]  # fmt: skip


@pytest.fixture
def broken(monkeypatch: pytest.MonkeyPatch) -> Callable[[type[Exception] | None], bytes]:
    """A certificate that is read with pieces that break whoever looks at them."""
    read = check.read_certificate

    def with_pieces(failure: type[Exception] | None) -> bytes:
        def broken_certificate(data: bytes, limits: check.Limits) -> tuple[int, Any, list[check.Column]]:
            version, statement, columns = read(data, limits)
            pieces = mutate.BreakingPieces(failure)
            return version, statement, [column._replace(pieces=pieces) for column in columns]

        monkeypatch.setattr(check, "read_certificate", broken_certificate)
        return text_of(GOOD["right"])

    return with_pieces


@pytest.mark.parametrize(
    ("failure", "workers"), [*((failure, "1") for failure in FAILURES), (IndexError, "2"), (MemoryError, "2")]
)
def test_whatever_breaks_is_no_proof(
    failure: type[Exception],
    workers: str,
    broken: Callable[[type[Exception] | None], bytes],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """One line that says so, and not the status of a certificate that is verified."""
    good = tmp_path / "good"
    good.write_bytes(broken(failure))
    assert check.main([str(good), "--workers", workers]) == 1
    written = capsys.readouterr()
    assert (written.out, written.err) == ("", f"REJECTED the check failed with {failure.__name__}\n")


def test_a_worker_that_is_killed_is_no_proof(broken: Callable[[type[Exception] | None], bytes]) -> None:
    with pytest.raises(check.Rejected, match="the check failed with BrokenProcessPool"):
        check.check_text(broken(None), workers=2)


@pytest.mark.parametrize("method", multiprocessing.get_all_start_methods())
def test_workers_begin_afresh_whatever_the_start_method_is(method: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """They know nothing of what was changed here, on each system and version of Python."""

    def breaks(*_: object) -> None:
        raise AssertionError

    monkeypatch.setattr(check.ColumnCheck, "parts", breaks)
    before = multiprocessing.get_start_method(allow_none=True)
    multiprocessing.set_start_method(method, force=True)
    try:
        assert check.check_text(text_of(GOOD["right"]), workers=2) == STATEMENTS["right"]
    finally:
        multiprocessing.set_start_method(before, force=True)


def test_a_file_too_large_for_the_memory_is_no_proof(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    good = tmp_path / "good"
    good.write_bytes(text_of(GOOD["right"]))

    def breaks(*_: object) -> bytes:
        raise MemoryError

    monkeypatch.setattr(check, "read_file", breaks)
    assert check.main([str(good)]) == 64
    assert capsys.readouterr().err.startswith("usage")


@pytest.mark.parametrize("wrong", range(4))
@pytest.mark.parametrize("sign", [0, -1])
def test_each_hypothesis_of_the_fold_is_checked(wrong: int, sign: int, monkeypatch: pytest.MonkeyPatch) -> None:
    checker, asked = on_a_column(), []

    def answer(box: tuple[Fraction, ...], order: int) -> int:
        asked.append((box, order))
        return sign if len(asked) == wrong + 1 else 1

    monkeypatch.setattr(checker, "sign", answer)
    low, high, start, end = box = (Fraction(2), Fraction(17, 8), Fraction(-1, 4), Fraction(1, 3))
    assert not checker.fold_holds(box)
    del asked[:]
    wrong = 9
    assert checker.fold_holds(box)
    assert asked == [((low, high, start, start), 0), ((low, high, end, end), 0), (box, 2), (box, -1)]


def test_the_derivative_in_b_of_a_narrow_fold_is_taken_on_a_wider_range(monkeypatch: pytest.MonkeyPatch) -> None:
    checker, asked = on_a_column(), []
    monkeypatch.setattr(checker, "sign", lambda box, order: asked.append((box, order)) or 1)
    low, high, start, end = Fraction(2), 2 + Fraction(1, 10**40), Fraction(-1, 4), Fraction(1, 3)
    assert checker.fold_holds((low, high, start, end))
    (low_b, high_b, *in_tau), order = asked[-1]
    assert (order, in_tau) == (-1, [start, end])
    assert low_b <= low < high < low_b + Fraction(1, 300) < high_b


@pytest.mark.parametrize(("low", "x", "holds"), [("-1", "2", True), ("-3/2", "2", False), ("-1/2", "0", False)])
def test_the_left_tail_needs_its_range(low: str, x: str, holds: bool) -> None:
    """b ≥ -1 and x > 0; with b in [-1, 0]: x³·3 > 1·2·3."""
    assert on_a_column().left_holds(Fraction(low), Fraction(0), -1, Fraction(x)) is holds


def test_the_last_coefficient_bounds_the_rest() -> None:
    model = local("2", "17/8", 60)
    start = model.values(Fraction(0), Fraction(2))
    series = model.expand(Fraction(0), Fraction(2), start)
    plain = list(islice(model.recurrence(Fraction(0), Fraction(2), start), len(series)))
    assert series[:-1] == plain[:-1]
    assert series[-1].error == plain[-1].error + 3 * max(a.norm() for a in plain[-3:])


@given(
    st.lists(st.integers(-(10**9), 10**9), min_size=6, max_size=6),
    st.integers(0, 10**6),
    st.integers(-5, 5),
    st.sampled_from([1, -1, 1j, -1j, 0.6 + 0.8j]),
)
def test_the_degree_that_is_cut_off_is_in_the_error(m: list[int], error: int, i: int, eta: complex) -> None:
    """Models of degree 1 lose much: linear and recurrence, with the largest ε there is, on the edge of the disc."""
    model = local("7/3", "3", 60)
    start = [check.Model(m[j : j + 2], error) for j in (0, 2, 4)]
    with mpmath.workdps(DIGITS):
        eta = mpmath.mpc(eta) / abs(mpmath.mpc(eta))
        b = (model.centre + model.radius * eta) / model.unit
        for phase in (1, -1, eta, -(eta**3)):
            c = [polynomial(a, eta) + error * phase for a in start]
            product = model.linear(start[0], i, 3)
            assert abs(polynomial(product, eta) - (i - b) * c[0] / 3) <= product.error + ROUNDING
            for k, a in enumerate(islice(model.recurrence(Fraction(-2), Fraction(3, 2), start), 12)):
                assert abs(polynomial(a, eta) - c[k]) <= a.error + ROUNDING
                top = -2 * mpmath.mpf(9) / 4 * (k + 1) * c[k + 1] + mpmath.mpf(27) / 8 * (k - b) * c[k]
                c.append(top / ((k + 1) * (k + 2) * (k + 3)))


def test_cauchy_estimate_in_b() -> None:
    """ε = e η^k has the derivative e k 2^(1-k) at η = 1/2: it is e for k = 1 and k = 2."""
    model = local("2", "17/8", 60)
    assert model.in_b(check.Model([0, 0, 0], 10**6)).error >= 2 * (model.unit << 16) * 10**6


@pytest.mark.parametrize(
    ("signs", "found"),
    [
        ([1, 1, -1], [1, 1, -1, -1]),
        ([1, 0, -1], [1, -1, -1]),
        ([1, 1, 0], [1, 1, -1]),
        ([-1, 0, -1], []),
        ([0, 1, -1], []),
        ([1, 0, 0], []),
        ([-1, -1, 0], []),
    ],
)
def test_open_signs_of_coefficients(signs: list[int], found: list[int], monkeypatch: pytest.MonkeyPatch) -> None:
    checker, zero = on_a_column(), Fraction(0)
    monkeypatch.setattr(checker, "sign", lambda _box, order, _splits: signs[order])
    assert checker.right_signs((zero, zero, zero, zero), 2) == found


@pytest.mark.parametrize(
    ("pieces", "found"),
    [
        ([("left", 1), ("sign", 1), ("sign", 1)], 0),
        ([("left", 1), ("monotone", -1), ("monotone", -1), ("sign", -1), ("sign", -1)], 1),
        ([("left", 1), ("monotone", 1), ("sign", 1)], 0),
        ([("left", 1), ("sign", -1)], "give F different signs where they meet"),
        ([("left", 1), ("monotone", 1), ("sign", -1)], "against the direction"),
        ([("left", 1), ("monotone", 1), ("monotone", -1), ("sign", 1)], "have two directions"),
        ([("monotone", 1), ("sign", 1)], "a piece monotone comes first"),
        ([("left", 1), ("monotone", 1)], "a piece monotone comes last"),
        ([("left", 1), ("hinge", 1)], "a piece hinge does not count zeros"),
    ],
)
def test_walk_through_the_pieces(
    pieces: list[tuple[str, int]], found: int | str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The rules that join the pieces, with pieces that are believed."""
    walk = [check.Piece(0, 1, kind, [], value) for kind, value in pieces]
    checker = check.ColumnCheck(check.Column(Fraction(1), Fraction(2), 0, walk), LIMITS, 0)
    monkeypatch.setattr(checker, "begin", lambda *_: None)
    monkeypatch.setattr(checker, "piece_sign", lambda piece: 0 if piece.kind == "monotone" else piece.value)
    if isinstance(found, int):
        assert check.number_of_zeros(checker) == found
    else:
        with pytest.raises(check.Rejected, match=found):
            check.number_of_zeros(checker)


STATEMENTS = {
    "iwc": "dΘ/dτ < 0 for every τ in (-inf, inf) and every β in (0, 1)",
    "iwc by theorem": "dΘ/dτ < 0 for every τ in (-inf, inf) and every β in (0, 1)",
    "negative beta": "dΘ/dτ > 0 for every τ in (-inf, inf) and every β in (-inf, 0)",
    "hinge": "dΘ/dτ < 0 for every τ in (-inf, 0) and every β in (1, 2)",
    "right": "dΘ/dτ > 0 for every τ in [4, inf) and every β in [5/4, 3/2]",
    "fold sign": "dΘ/dτ < 0 for every τ in (-inf, 1/2] and every β in (3, 49/16]",
    "integer": "dΘ/dτ < 0 at τ = 0 and at β = 4",
    "zero": "dΘ/dτ = 0 at τ = 0 and at β = 3",
    "zeros": "for every β in (1, 9/8] that is not an integer, dΘ/dτ has exactly N real zeros, all simple: "
    "N = 1 on (1, 2)",
    "fold": "for every β in (95/32, 49/16) that is not an integer, dΘ/dτ has exactly N real zeros, all simple: "
    "N = 2 on (2, 3), N = 1 on (3, 4)",
    "brackets": "dΘ/dτ at β = 7/3 has exactly 2 real zeros, all simple, one in each of the intervals: "
    "(-1203/5000, -481/2000), (2077/1000, 1039/500)",
}


@pytest.mark.parametrize("name", GOOD)
def test_statements(name: str) -> None:
    assert check.check_text(text_of(GOOD[name])) == STATEMENTS[name]


def assert_sign_at_integer(tau: Fraction, beta: int, sign: int) -> None:
    """This sign is verified, and the two others are rejected."""
    for claimed in (-1, 0, 1):
        statement = {"beta": f"[{beta}, {beta}]", "kind": "sign", "sign": claimed, "tau": f"[{tau}, {tau}]"}
        if claimed == sign:
            assert check.check_text(text_of(lines_of(statement)))
        else:
            with pytest.raises(check.Rejected, match="the sign at this integer β is"):
                check.check_text(text_of(lines_of(statement)))


@pytest.mark.parametrize("beta", range(14))
@pytest.mark.parametrize("tau", [Fraction(0), Fraction(-7, 3), Fraction(5, 2)])
def test_integer_beta(beta: int, tau: Fraction) -> None:
    exact = -beta * theta_witness(tau, Fraction(beta - 1))
    sign = 0 if tau == 0 and beta % 3 != 1 else (exact > 0) - (exact < 0)
    assert_sign_at_integer(tau, beta, sign)


def polynomial_at(tau: Fraction, n: int) -> Fraction:
    """Θ(τ, n) = n! [x^n] exp(x³/3 - τx): a sum, where the checker has a recurrence."""
    terms = [
        Fraction(math.factorial(n), math.factorial(n - 3 * j) * math.factorial(j) * 3**j) * (-tau) ** (n - 3 * j)
        for j in range(n // 3 + 1)
    ]
    return sum(terms, Fraction(0))


@pytest.mark.parametrize("beta", range(4, 15))
def test_integer_beta_on_both_sides_of_each_zero(beta: int) -> None:
    """Points that differ by 2^-40: a wrong factor in the recurrence moves a zero across one of them."""
    grid = [Fraction(k, 8) + Fraction(1, 97) for k in range(-10, 90)]
    zeros = 0
    for low, high in pairwise(grid):
        at_low = polynomial_at(low, beta - 1)
        if at_low * polynomial_at(high, beta - 1) > 0:
            continue
        left, right = low, high
        while right - left > Fraction(1, 2**40):
            middle = (left + right) / 2
            left, right = (middle, right) if polynomial_at(middle, beta - 1) * at_low > 0 else (left, middle)
        zeros += 1
        for tau in (left, right):
            assert_sign_at_integer(tau, beta, -1 if polynomial_at(tau, beta - 1) > 0 else 1)
    # Of the zeros at 0 one is on this grid, with a change of sign where their number is odd.
    assert zeros == (beta - 1) // 3 + ((beta - 1) % 3 == 1)


@pytest.mark.parametrize("width", [Fraction(1, 10**40), Fraction(1, 10**5)])
@pytest.mark.parametrize("side", [-1, 1])
def test_narrow_columns_next_to_a_fold(width: Fraction, side: int) -> None:
    low, high = sorted([Fraction(3), 3 + side * width])
    last = ["right", "1/2", 0] if side < 0 else ["right", "1/2", 1]
    between = ["monotone", "1/4", "1/2", 1] if side < 0 else ["sign", "1/4", "1/2", 1]
    pieces = [["left", "-3/8"], ["sign", "-3/8", "-1/4", 1], ["fold", "-1/4", "1/4"], between, last]
    counts = [[2, 2]] if side < 0 else [[3, 1]]
    statement = {"beta": f"({low}, {high})", "counts": counts, "kind": "zeros"}
    assert check.check_text(text_of(lines_of(statement, ([str(low), str(high)], pieces))))


def test_a_zero_very_close_to_tau_0() -> None:
    """At β = 2 + 10^-40 there is a zero next to τ = 0: F has signs on both sides of it."""
    beta = 2 + Fraction(1, 10**40)
    for tau, sign in [(Fraction(-1, 10**30), -1), (Fraction(1, 10**30), 1), (Fraction(0), 1)]:
        statement = {"beta": f"[{beta}, {beta}]", "kind": "sign", "sign": sign, "tau": f"[{tau}, {tau}]"}
        piece = ["sign", str(tau - Fraction(1, 10**45)), str(tau + Fraction(1, 10**45)), -sign]
        assert check.check_text(text_of(lines_of(statement, ([str(beta)] * 2, [piece]))))


@pytest.mark.parametrize(("tau", "beta"), [("-inf..inf", "0..1"), ("-2..-1", "0..3"), ("-inf..0", "1..2")])
def test_certificates_of_the_library_for_signs(tau: str, beta: str) -> None:
    result = sign_on_ranges(tau, beta)
    assert result.proved_statement is not None
    text = certificate_text(result.proved_statement, result.columns)
    assert check.check_text(text.encode()).startswith("dΘ/dτ < 0 for every τ")


@pytest.mark.parametrize(("beta", "digits"), [("7/3", 15), ("5/2", 100), ("29999999/10000000", 20), ("4001/1000", 30)])
def test_certificates_of_the_library_for_brackets(beta: str, digits: int) -> None:
    result = zeros_at(beta, digits)
    text = certificate_text(result.statement, [result.column])
    m = math.floor(Fraction(beta))
    number = m % 3 + m // 3
    words = "one real zero, simple, in (" if number == 1 else f"{number} real zeros, all simple, one in each "
    assert f"has exactly {words}" in check.check_text(text.encode())


def test_certificate_of_the_library_for_zeros() -> None:
    result = zeros_on_range("2..7/2")
    assert result.statement is not None
    text = certificate_text(result.statement, result.columns)
    assert check.check_text(text.encode()).endswith("N = 2 on (2, 3), N = 1 on (3, 4)")


def test_a_zero_that_is_exact_is_not_given_a_sign() -> None:
    limits = LIMITS._replace(bits=400)
    assert on_a_column(limits=limits).sign((Fraction(1), Fraction(1), Fraction(0), Fraction(0)), 0) == 0
    assert on_a_column(limits=limits).sign((Fraction(0), Fraction(1), Fraction(0), Fraction(0)), 0, 3) == 0


def test_a_large_beta() -> None:
    result = zeros_at("61/2", 15)
    text = certificate_text(result.statement, [result.column])
    assert "has exactly 10 real zeros" in check.check_text(text.encode())


def run(*arguments: str, encoding: str = "utf-8") -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-I", "-S", str(mutate.CHECKER), *arguments]
    environment = {"PYTHONIOENCODING": encoding} if encoding else {}
    options = [] if encoding else ["-X", "utf8"]
    command[1:1] = options
    return subprocess.run(command, capture_output=True, text=True, encoding="utf-8", check=False, env=environment)


def test_the_program_takes_the_words_after_its_name(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    good = tmp_path / "good"
    good.write_bytes(text_of(GOOD["integer"]))
    monkeypatch.setattr(sys, "argv", ["check.py", str(good)])
    loader = importlib.machinery.SourceFileLoader("__main__", str(mutate.CHECKER))
    spec = importlib.util.spec_from_loader("__main__", loader)
    assert spec is not None
    with pytest.raises(SystemExit) as ended:
        loader.exec_module(importlib.util.module_from_spec(spec))
    assert (ended.value.code, capsys.readouterr().out) == (0, f"VERIFIED {STATEMENTS['integer']}\n")


def test_command_line(tmp_path: Path) -> None:
    good, bad = tmp_path / "good", tmp_path / "bad"
    good.write_bytes(text_of(GOOD["iwc by theorem"]))
    bad.write_bytes(text_of(GOOD["iwc by theorem"])[:-1])
    result = run(str(good))
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout.splitlines()[0].startswith("VERIFIED d")
    columns = tmp_path / "columns"
    columns.write_bytes(text_of(GOOD["iwc"]))
    result = run(str(columns), "--workers", "2")
    assert (result.returncode, result.stdout, result.stderr) == (0, f"VERIFIED {STATEMENTS['iwc']}\n", "")
    result = run(str(bad))
    assert (result.returncode, result.stdout) == (1, "")
    assert result.stderr == "REJECTED the last line is not sha256 and a hash\n"
    for arguments in [(), (str(tmp_path / "none"),), (str(tmp_path),), (str(good), str(good))]:
        result = run(*arguments)
        assert (result.returncode, result.stdout) == (64, "")
        assert result.stderr.startswith("usage")


@pytest.mark.parametrize(
    ("options", "reason"),
    [
        (["--limit", "work"], "--limit needs a positive integer"),
        (["--limit", "work=0"], "--limit needs a positive integer"),
        (["--limit=work=-1"], "--limit needs a positive integer"),
        (["--limit", "speed=3"], "the limits are bytes, line,"),
        (["--limit", "3"], "the limits are bytes, line,"),
        (["--workers", "0"], "--workers needs a positive integer"),
        (["--workers", "work=2"], "the limits are bytes, line,"),
        (["--workers"], "--workers needs a positive integer"),
        (["--limit", "work"], "as NAME=NUMBER, not 'work'; the limits are bytes, line,"),
        (["--workers", "two"], "--workers needs a positive integer, not 'two'"),
        (["--help"], "the exit status is 0 for VERIFIED alone, 1 for REJECTED, else 64; the limits are bytes, line,"),
        (["--speed"], "there is no option --speed (a file of this name is ./--speed)"),
    ],
)
def test_options_that_are_none(
    options: list[str], reason: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    good = tmp_path / "good"
    good.write_bytes(text_of(GOOD["iwc by theorem"]))
    assert check.main([str(good), *options]) == 64
    written = capsys.readouterr()
    assert written.out == ""
    assert written.err.startswith("usage: python check.py")
    assert reason in written.err


def test_options(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A limit that is met is named with the option that raises it; workers do not change the answer."""
    good = tmp_path / "good"
    good.write_bytes(text_of(GOOD["right"]))
    assert check.main([str(good), "--limit", "tau=3"]) == 1
    assert "the limit tau=3 (raise it on purpose: --limit tau=NUMBER)" in capsys.readouterr().err
    lines = set()
    for workers in ("1", "2"):
        assert check.main(["--limit=tau=4", "--workers", workers, "--limit", "beta=2", str(good)]) == 0
        lines.add(capsys.readouterr().out)
    assert lines == {f"VERIFIED {STATEMENTS['right']}\n"}


def test_only_a_regular_file_of_bounded_length_is_read(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pipe, long = tmp_path / "pipe", tmp_path / "long"
    os.mkfifo(pipe)
    for name in (pipe, tmp_path, "/dev/zero"):
        assert check.main([str(name)]) == 64
        assert capsys.readouterr().err.startswith("usage")
    with long.open("wb") as file:
        file.truncate(10**12)  # with no block on the disk
    assert check.main([str(long)]) == 1
    assert "the limit bytes=20000000" in capsys.readouterr().err


def test_workers_find_the_same_fault() -> None:
    lines = mutate.copy.deepcopy(GOOD["iwc"])
    lines[1]["pieces"][1][3] = lines[2]["pieces"][1][3] = -1
    found = set()
    for workers in (1, 2):
        with pytest.raises(check.Rejected) as caught:
            check.check_text(text_of(lines), workers=workers)
        found.add(str(caught.value))
    assert len(found) == 1
    assert "of the column from β = 0: the sign is 1, not -1" in found.pop()


@pytest.mark.parametrize("encoding", ["ascii", "latin-1", "utf-8"])
def test_output_in_any_encoding(encoding: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file, raw = tmp_path / "good", io.BytesIO()
    file.write_bytes(text_of(GOOD["zero"]))
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(raw, encoding=encoding))
    assert check.main([str(file)]) == 0
    sys.stdout.flush()
    assert raw.getvalue().startswith(b"VERIFIED d")
    assert raw.getvalue().count(b"\n") == 1


def test_size_and_imports() -> None:
    """At most 1110 lines, standard library only, one float that stands for infinity."""
    text = mutate.CHECKER.read_text(encoding="utf-8")
    assert len(text.splitlines()) <= 1110
    tree = ast.parse(text)
    names = {alias.name for node in ast.walk(tree) if isinstance(node, ast.Import) for alias in node.names}
    names |= {node.module or "" for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
    assert {name.split(".")[0] for name in names} <= sys.stdlib_module_names
    assert not any(isinstance(node, ast.Assert) for node in ast.walk(tree))
