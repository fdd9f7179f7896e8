"""The checker's models: their arithmetic, F on a disc, against witnesses and in rationals.

Page: proofs/check.md.
"""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import islice, pairwise

import mpmath
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from must_reject import mutate
from samples.checker_models import (
    DIGITS,
    ENDLESS,
    LIMITS,
    assert_rounded,
    coefficient,
    length_of,
    local,
    local_at,
    number,
    points_of_the_disc,
    polynomial,
    small_local,
    theta,
)
from samples.strategies import ends, to_fmpq

from gspot_verified.theta_function.value.evaluate import evaluate

check = mutate.checker()

ROUNDING = mpmath.mpf(10) ** -60  # of mpmath, in units of the last place of a model
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
    for i, value in enumerate(check.theta.moved([check.theta.Model([c << p], 3) for c in coefficients], u, p, ENDLESS)):
        exact = sum(math.comb(k, i) * c * u ** (k - i) for k, c in enumerate(coefficients) if k >= i)
        assert abs(value.m[0] - exact * 2**p) <= value.error <= 2**34


@given(st.integers(-20, 20), st.integers(1, 4), st.integers(-30, 30))
def test_tail_lemma(point: int, s: int, b: int) -> None:
    """The error of the last coefficient bounds what is left out, for exact rational coefficients."""
    model = local_at(Fraction(b), Fraction(b), 60)
    start = [check.theta.Model([value << model.p], 0) for value in (3, -2, 5)]
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
    square, cube = check.theta.tail_factors(point, s)
    assert square >= abs(point) * s**2
    assert cube >= s**3
    for b in (1, 5, 40):
        q = abs(point) * s**2 / ((i + 2) * (i + 3)) + (i + b) * s**3 / ((i + 1) * (i + 2) * (i + 3)) if i >= 0 else 1
        assert not check.theta.tail_falls(square, cube, i, b) or q <= Fraction(1, 2)


def test_the_tail_lemma_at_its_limit() -> None:
    """2(a(i+1) + c(i+B)) = (i+1)(i+2)(i+3) holds, and one more does not: i = 1, 2(2a + c(1+B)) ≤ 24."""
    assert check.theta.tail_falls(0, 3, 1, 3)
    assert check.theta.tail_falls(6, 0, 1, 3)
    assert not check.theta.tail_falls(7, 0, 1, 3)
    assert not check.theta.tail_falls(0, 3, 1, 4)
    assert check.theta.tail_falls(0, 0, 0, 1)
    assert not check.theta.tail_falls(0, 0, -1, 1)


@pytest.mark.parametrize(("low", "high"), [("7/3", "7/3"), ("-7/2", "-7/2"), ("2", "3"), ("5", "5"), ("2", "17/8")])
def test_the_tail_lemma_is_asked_for_three_sums_at_once(low: str, high: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """B ≥ sup|b| + 2, because F'' has b - 2 in the place of b; i = n - 5, the least index of the three."""
    asked: list[tuple[int, int, int, int]] = []
    falls, model = check.theta.tail_falls, local(low, high, 60)
    start = model.values(Fraction(-3), Fraction(3, 2))
    monkeypatch.setattr(check.theta, "tail_falls", lambda *question: asked.append(question) or falls(*question))
    largest = Fraction(abs(model.centre) + model.radius, model.unit)
    series = model.expand(Fraction(-3), Fraction(3, 2), start)
    assert {(square, cube) for square, cube, _, _ in asked} == {(7, 4)}  # |τ| s² = 27/4, s³ = 27/8
    assert [i for _, _, i, _ in asked] == list(range(-4, len(series) - 4))
    assert all(largest + 2 <= b <= largest + 3 for *_, b in asked)


@pytest.mark.parametrize("before", [Fraction(1, 10**9), Fraction(2), Fraction(5)])
def test_nothing_is_known_before_the_start(before: Fraction) -> None:
    """A disc begins at -x. An index below 0 would be that of another anchor, counted from the last one."""
    model = local("7/3", "7/3", 60)
    model.values(Fraction(0), Fraction(1))
    assert [a.m for a in model.values(Fraction(-model.x), check.theta.STEP)] == [a.m for a in model.anchors[0]]
    with pytest.raises(check.limits.Rejected, match="τ before the start"):
        model.values(-model.x - before, Fraction(1))


def test_a_disc_that_begins_after_the_place_is_refused() -> None:
    """The key of a disc holds the start for b = 0; for a large b the start may lie between two places with one key."""
    theta = check.theta.Theta(LIMITS, 10**12)
    low = high = Fraction(401, 2)
    first = theta.local(low, high, 64, Fraction(-50))
    assert first is theta.local(low, high, 64, Fraction(-60))
    assert 50 <= first.x < 60
    with pytest.raises(check.limits.Rejected, match="τ before the start"):
        theta.value((low, high, Fraction(-60), Fraction(-60)), 0, 64)


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


@given(
    st.integers(0, 10**6), st.integers(0, 9), st.fractions(-9, 9, max_denominator=50),
    st.fractions(0, 3, max_denominator=50), st.integers(1, 9),
)  # fmt: skip
def test_the_bound_of_the_first_term_left_out(bound: int, n: int, b: Fraction, radius: Fraction, x: int) -> None:
    """T for N = n + 1 from T for N = n, in rationals; rounded up by less than 1."""
    unit = 2 * math.lcm(b.denominator, radius.denominator)
    found = check.theta.next_bound(bound, n, int(b * unit), int(radius * unit), unit, x, ENDLESS)
    factors = math.prod((abs(i - b) + radius for i in (3 * n, 3 * n + 1, 3 * n + 2)), start=Fraction(bound))
    assert found - 1 < factors / (3 * (n + 1) * x**3) <= found


@given(st.integers(0, 10**6), st.integers(1, 20), st.integers(1, 20), st.integers(1, 9))
def test_the_rests_of_the_enveloping_series(bound: int, n: int, reach: int, x: int) -> None:
    far, found = 3 * n + reach, check.theta.rests(bound, n, reach, x)
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
    monkeypatch.setattr(check.theta, "start_for", lambda *_: x)
    model = local(low, high, 60)
    with mpmath.workdps(DIGITS):
        for eta in points_of_the_disc(3, 3):
            b = (model.centre + model.radius * eta) / model.unit
            for k, value in enumerate(model.anchors[0]):
                exact = coefficient(mpmath.mpf(-x), b, k) * 2**k * mpmath.mpf(2) ** model.p / mpmath.power(x, b)
                assert abs(polynomial(value, eta) - exact) <= value.error


SMALL = st.integers(-3, 3) | st.integers(-(10**6), 10**6)
MODELS = st.builds(
    check.theta.Model, st.lists(SMALL, min_size=4, max_size=4), st.integers(0, 9) | st.integers(0, 10**6)
)
RATIONALS = st.fractions(-6, 6, max_denominator=40)


@example(Fraction(0), Fraction(0), check.theta.Model([-1] * 4, 44), 1, 45)
@given(RATIONALS, st.fractions(0, 2, max_denominator=40), MODELS, st.integers(-9, 30), st.sampled_from([1, 7, -6, 45]))
def test_a_linear_factor_in_rationals(b: Fraction, width: Fraction, a: check.theta.Model, i: int, divisor: int) -> None:
    """(i - b) a/divisor for b = b_0 + R η: what is cut off is R |m_last|, and ‖i - b‖ = |i - b_0| + R."""
    model = small_local(b, b + width)
    middle, radius = b + width / 2, width
    exact = [((i - middle) * x - radius * y) / divisor for x, y in zip(a.m, [0, *a.m[:-1]], strict=True)]
    error = (abs(i - middle) + radius) * a.error + radius * abs(a.m[-1])
    assert_rounded(model.linear(a, i, divisor), exact, error / abs(divisor))


@example(
    Fraction(-1),
    Fraction(0),
    Fraction(0),
    Fraction(1),
    (check.theta.Model([-1] * 4, 5),) + (check.theta.Model([0] * 4, 0),) * 2,
)
@given(
    RATIONALS, st.fractions(0, 2, max_denominator=40), RATIONALS, st.fractions(1, 5, max_denominator=7),
    st.tuples(MODELS, MODELS, MODELS),
)  # fmt: skip
def test_the_recurrence_in_rationals(
    b: Fraction, width: Fraction, point: Fraction, s: Fraction, start: tuple[check.theta.Model, ...]
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


@example([check.theta.Model([-1] * 4, 97)] * 4, Fraction(1, 99), 90)
@given(st.lists(MODELS, min_size=4, max_size=7), st.fractions(-1, 1, max_denominator=99), st.sampled_from([8, 40, 90]))
def test_the_taylor_shift_in_rationals(series: list[check.theta.Model], u: Fraction, p: int) -> None:
    for i, value in enumerate(check.theta.moved(series, u, p, ENDLESS)):
        weights = [math.comb(k, i) * u ** max(k - i, 0) for k in range(len(series))]
        exact = [sum(map(lambda w, m: w * m, weights, column)) for column in zip(*(a.m for a in series), strict=True)]
        lost = sum(abs(a - b) for a, b in zip(exact, value.m, strict=True))
        error = sum(abs(w) * a.error for w, a in zip(weights, series, strict=True))
        rounding = sum(math.comb(k, i) * k * a.norm() for k, a in enumerate(series)) / Fraction(2**p)
        assert lost + error <= value.error
        # The rounded powers of u may be larger than |u|^k by k units.
        assert value.error <= error + 2 * rounding + 1 + 4


@given(st.fractions(-1, 1, max_denominator=99), st.integers(1, 30), st.integers(0, 90))
@example(Fraction(-98, 99), 30, 3)
def test_powers_are_rounded_by_less_than_their_exponent(u: Fraction, length: int, p: int) -> None:
    powers = check.theta.rounded_powers(u, length, p, ENDLESS)
    assert len(powers) == length
    assert all(abs(value - u**k * 2**p) <= k for k, value in enumerate(powers))


WEIGHTS = st.lists(st.tuples(st.integers(-(10**6), 10**6), st.integers(0, 10**3)), min_size=3, max_size=3)


@given(st.lists(MODELS, min_size=3, max_size=3), st.lists(WEIGHTS, min_size=1, max_size=3), st.sampled_from([0, 8, 40]))
def test_weights_that_are_not_exact_add_to_the_error(
    models: list[check.theta.Model], rows: list[list[tuple[int, int]]], p: int
) -> None:
    given_rows = [([w for w, _ in row], [t for _, t in row]) for row in rows]
    for row, found in zip(rows, check.theta.weighted(given_rows, models, p, ENDLESS), strict=True):
        exact = [
            Fraction(sum(w * m for (w, _), m in zip(row, column, strict=True)), 2**p)
            for column in zip(*(a.m for a in models), strict=True)
        ]
        error = sum(abs(w) * a.error + t * a.norm() for (w, t), a in zip(row, models, strict=True))
        assert_rounded(found, exact, Fraction(error, 2**p))


@given(RATIONALS, st.fractions(0, 2, max_denominator=40), MODELS)
def test_the_derivative_in_b_in_integers(b: Fraction, width: Fraction, a: check.theta.Model) -> None:
    """radius·v·2^16·unit... P + P' and ‖ε'‖ ≤ 2e: no rounding at all."""
    model = small_local(b, b + width)
    v, factor = round(math.log(model.x) * 2**16), model.unit * 2**16
    found = model.in_b(a)
    derivative = [j * m for j, m in enumerate(a.m)][1:]
    assert found.m == [factor * x + model.radius * v * y for x, y in zip([*derivative, 0], a.m, strict=True)]
    assert found.error == (2 * factor + model.radius * v) * a.error


@pytest.mark.parametrize(
    ("low", "high", "growth"),
    [("7/3", "7/3", 1), ("2", "9/4", 5), ("2", "3", 5), ("-7/2", "-1", 125), ("40", "40", 1), ("-30", "-30", 1)],
)
def test_what_the_start_leaves_out(low: str, high: str, growth: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """g T for g = 5^⌈R⌉ and the N of the sum, 3N ≥ B + 1/2, is what goes into the errors."""
    asked: list[tuple[int, int, int, int]] = []
    left_out = [10**80, 2 * 10**80, 3 * 10**80]
    monkeypatch.setattr(check.theta, "rests", lambda *arguments: asked.append(arguments) or left_out)
    model = local(low, high, 60)
    ((bound, n, reach, x),) = asked
    largest = Fraction(abs(model.centre) + model.radius, model.unit)
    assert x == model.x
    assert reach >= largest
    assert 3 * n >= largest + Fraction(1, 2)
    start = 1 << model.p
    for i in range(n):
        start = check.theta.next_bound(start, i, model.centre, model.radius, model.unit, x, ENDLESS)
    assert bound == growth * start
    assert [a.error // 10**79 for a in model.anchors[0]] == [10, 40, 60]


@pytest.mark.parametrize(("low", "high"), [("2", "9/4"), ("7/3", "3"), ("-5/2", "-1")])
@pytest.mark.parametrize("degree", [1, 2, 3])
def test_a_start_of_low_degree_has_what_it_lacks_in_its_error(
    low: str, high: str, degree: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(check.theta, "degree_for", lambda *_: degree)
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
    monkeypatch.setattr(check.theta, "start_for", lambda *_: x)
    monkeypatch.setattr(check.theta, "degree_for", lambda *_: 3)
    model = local(str(b), str(b), 60)
    one = 1 << model.p
    exact = [Fraction(one), Fraction(-2 * b * one, x), Fraction(2 * b * (b - 1) * one, x**2)]
    assert [a.m for a in model.anchors[0]] == [[int(value), 0, 0] for value in exact]


@pytest.mark.parametrize("long", range(4))
def test_steps_are_counted_with_the_lengths_of_their_numbers(long: int) -> None:
    """Each long operand is seen: its products are taken from the budget before they are made."""
    huge = 10**900
    model = small_local(Fraction(1), Fraction(3, 2) + (Fraction(1, huge) if long == 0 else 0))
    model.meter = check.limits.Meter(LIMITS, 10**18)
    a, i, divisor = check.theta.Model([huge, huge], 0), huge if long == 1 else 3, huge if long == 2 else 3
    model.linear(a, i, divisor)
    n, r, d = i * model.unit - model.centre, model.radius, divisor * model.unit
    (one,) = length_of(huge)
    assert 10**18 - model.meter.left >= 2 * one * sum(length_of(n, r, d)) > 0
    model.meter = check.limits.Meter(LIMITS, 10**18)
    point = Fraction(1, huge) if long == 2 else Fraction(huge if long == 1 else 3)
    start = [check.theta.Model([huge, huge], 0)] * 3
    list(islice(model.recurrence(point, Fraction(1), start), 4))
    common = point.denominator * model.unit
    n, r, f, d = common // model.unit * model.centre, common // model.unit * model.radius, common * point, 6 * common
    assert 10**18 - model.meter.left >= 2 * one * sum(length_of(n, r, int(f), d)) / 2 > 0
    meter = check.limits.Meter(LIMITS, 10**18)
    u, p = (
        (Fraction(1, 3), Fraction(1, huge), Fraction(huge - 1, huge), Fraction(2, 3))[long],
        3000 if long == 3 else 60,
    )
    check.theta.moved(start * 2, u, p, meter)
    powers = 6 * Fraction(p, 30) * sum(length_of(u.numerator, u.denominator))
    assert 10**18 - meter.left >= powers + 3 * 6 * 2 * one * Fraction(p, 30) > 1_000


@given(st.lists(st.integers(-99, 99), min_size=1, max_size=6), st.integers(0, 99), st.fractions(-9, 9))
@example([-1] * 6, 44, Fraction(1, 45))
def test_models_are_rounded_into_their_error(m: list[int], error: int, factor: Fraction) -> None:
    product = check.theta.times(check.theta.Model(m, error), factor, ENDLESS)
    assert_rounded(product, [factor * a for a in m], abs(factor) * error)
    for first in (0, 1):
        terms = sum(Fraction(abs(a), 2**j) for j, a in enumerate(m) if j >= first)
        assert 0 <= check.theta.Model(m, error).spread(first) - terms <= len(m[first:])
    assert check.theta.Model(m, error).norm() == sum(map(abs, m)) + error


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
    start = [check.theta.Model(m[j : j + 2], error) for j in (0, 2, 4)]
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
    assert model.in_b(check.theta.Model([0, 0, 0], 10**6)).error >= 2 * (model.unit << 16) * 10**6
