"""Exact intervals: what they hold, how they travel, what their parser refuses."""

from __future__ import annotations

import copy
import dataclasses
import json
import pickle
from fractions import Fraction

import numpy as np
import pytest
from flint import arb, fmpz
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import balls, dyadic_fraction, ends, nonfinite_balls, numbers_in, point, precisions

from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.dyadic import Dyadic

_INTEGERS = st.one_of(st.integers(-8, 8), st.integers(-(2**70), 2**70), st.integers(-(2**400), 2**400))


def dyadics(exponents: int = 200) -> st.SearchStrategy[Dyadic]:
    return st.builds(
        lambda first, second, exponent: Dyadic(min(first, second), max(first, second), exponent),
        _INTEGERS,
        _INTEGERS,
        st.integers(-exponents, exponents),
    )


def small_dyadics() -> st.SearchStrategy[Dyadic]:
    """A small set, so that equal ends and inclusions are frequent."""
    side = st.integers(-4, 4)
    return st.builds(
        lambda first, second, e: Dyadic(min(first, second), max(first, second), e), side, side, st.integers(-2, 2)
    )


def span(interval: Dyadic) -> tuple[Fraction, Fraction]:
    """The ends by this test's own arithmetic."""
    return dyadic_fraction(interval.lower, interval.exponent), dyadic_fraction(interval.upper, interval.exponent)


# Construction


@given(_INTEGERS, _INTEGERS, st.integers(-200, 200))
def test_construction_keeps_the_value_and_is_canonical(first: int, second: int, exponent: int) -> None:
    lower, upper = min(first, second), max(first, second)
    interval = Dyadic(lower, upper, exponent)
    assert span(interval) == (dyadic_fraction(lower, exponent), dyadic_fraction(upper, exponent))
    assert interval.endpoints() == span(interval)
    assert interval.lower % 2 or interval.upper % 2 or interval == Dyadic(0, 0, 0)


@given(dyadics(), st.integers(0, 300))
def test_equal_intervals_are_equal_objects(interval: Dyadic, shift: int) -> None:
    scaled = Dyadic(interval.lower << shift, interval.upper << shift, interval.exponent - shift)
    assert scaled == interval
    assert hash(scaled) == hash(interval)
    assert str(scaled) == str(interval)
    assert len({scaled, interval}) == 1


@given(small_dyadics(), small_dyadics())
def test_equality_is_equality_of_sets(first: Dyadic, second: Dyadic) -> None:
    assert (first == second) == (span(first) == span(second))
    assert (str(first) == str(second)) == (first == second)


def test_zero_has_one_form() -> None:
    assert Dyadic(0, 0, 999) == Dyadic(0, 0) == Dyadic(0, 0, -(10**9))
    assert str(Dyadic(0, 0, 5)) == "0"


@pytest.mark.parametrize(
    "fields",
    [(1.0, 2, 0), (1, 2.0, 0), (1, 2, 0.0), (True, 2, 0), (0, True, 0), (0, 1, False), (np.int64(1), 2, 0),
     (fmpz(1), 2, 0), ("1", 2, 0), (None, 2, 0), (Fraction(1), 2, 0)],
)  # fmt: skip
def test_fields_are_ints(fields: tuple[object, ...]) -> None:
    with pytest.raises(TypeError, match="must be an int"):
        Dyadic(*fields)  # type: ignore[arg-type]


@pytest.mark.parametrize("fields", [(1, 0, 0), (2**400, -(2**400), 5), (0, -1, -3)])
def test_reversed_is_refused(fields: tuple[int, int, int]) -> None:
    with pytest.raises(ValueError, match="reversed"):
        Dyadic(*fields)


@pytest.mark.parametrize("exponent", [10**24 + 1, -(10**24) - 1, 2**90, -(2**90)])
def test_exponents_are_bounded(exponent: int) -> None:
    with pytest.raises(ValueError, match="exponent"):
        Dyadic(1, 3, exponent)


def test_the_bound_is_on_the_canonical_exponent() -> None:
    with pytest.raises(ValueError, match="exponent"):
        Dyadic(4, 8, 10**24 - 1)
    assert Dyadic(4, 8, 10**24 - 2).exponent == 10**24


@pytest.mark.parametrize("exponent", [10**7 + 1, -(10**7) - 1, 10**8])
def test_no_fraction_that_does_not_fit(exponent: int) -> None:
    interval = Dyadic(1, 3, exponent)
    with pytest.raises(ValueError, match="exponent"):
        interval.endpoints()
    with pytest.raises(ValueError, match="exponent"):
        interval.contains(1)
    assert interval.sign() == 1


@pytest.mark.parametrize("exponent", [10**7, -(10**7)])
def test_the_last_fraction_that_fits(exponent: int) -> None:
    lower, upper = Dyadic(1, 3, exponent).endpoints()
    assert upper == 3 * lower
    assert max(lower.numerator, lower.denominator) == 1 << 10**7


def test_frozen() -> None:
    with pytest.raises(dataclasses.FrozenInstanceError):
        Dyadic(1, 2).lower = 0  # type: ignore[misc]


# Travel


@given(dyadics())
def test_pickle_and_copy(interval: Dyadic) -> None:
    for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
        assert pickle.loads(pickle.dumps(interval, protocol)) == interval
    assert copy.copy(interval) == copy.deepcopy(interval) == interval
    assert Dyadic(**json.loads(json.dumps(dataclasses.asdict(interval)))) == interval


@given(dyadics(10**6))
def test_text_round_trip(interval: Dyadic) -> None:
    text = str(interval)
    assert Dyadic.parse(text) == interval
    assert str(Dyadic.parse(text)) == text
    assert "\n" not in text


def test_long_texts_round_trip() -> None:
    interval = Dyadic(-(2**200_000) + 1, 2**200_001, -7)
    assert Dyadic.parse(str(interval)) == interval


@pytest.mark.parametrize(
    "text",
    [
        "[0x2, 0x4]p0",  # both even
        "[0x0, 0x0]p0",  # zero has a text of its own
        "[-0x0, 0x1]p0",
        "[0x01, 0x3]p0",
        "[0x1, 0x3]p-0",
        "[0x1, 0x3]p+1",
        "[0x1, 0x3]p01",
        "[0X1, 0x3]p0",
        "[0xA, 0xb]p0",
        "[+0x1, 0x3]p0",
        "[0x1,0x3]p0",
        "[0x1,  0x3]p0",
        " [0x1, 0x3]p0",
        "[0x1, 0x3]p0 ",
        "[0x1, 0x3]p0\n",
        "[0x1, 0x3]p0\x00",
        "[0x1, 0x3]",
        "[0x1, 0x3]p",
        "[0x1, 0x3]p1.0",
        "[0x1, 0x3]p1e3",
        "[0x1, 0x3]p0x1",
        "[0x1_0, 0x31]p0",
        "[0x, 0x3]p0",
        "[1, 3]p0",
        "[0x1]p0",
        "[0x1, 0x3, 0x5]p0",
        "(0x1, 0x3]p0",
        "[0x3, 0x1]p0",  # reversed
        "[0x1, 0x3]p9999999999999999999999999",
        "[0x1, 0x3]p-9999999999999999999999999",
        "[0x1, 0x3]p1000000000000000000000001",
        "[0x1, 0x3]p99999999999999999999999999",
        "[0x1, 0x3]p" + "9" * 100_000,
        "[0x1, 0x3]p\u0661",
        "[0x\u0661, 0x3]p0",
        "[\uff10\uff58\uff11, 0x3]p0",
        "[\u22120x1, 0x3]p0",
        "[nan, nan]p0",
        "[-inf, inf]p0",
        "[0.1, 0.2]",
        "[0.333 +/- 1e-3]",
        "",
        "p0",
        "[" * 100_000,
        "__import__('os')",
    ],
    ids=lambda text: repr(text[:40]),
)
def test_parse_refuses(text: str) -> None:
    with pytest.raises(ValueError) as caught:  # noqa: PT011 - which message depends on the text
        Dyadic.parse(text)
    assert len(str(caught.value)) < 200


@given(st.text(max_size=30))
def test_parse_refuses_any_text_that_str_does_not_make(text: str) -> None:
    try:
        interval = Dyadic.parse(text)
    except ValueError:
        return
    assert str(interval) == text


@given(dyadics(), st.integers(0, 40), st.sampled_from("0123456789abcdefx-+[], p\n_ "))
def test_a_changed_character_is_refused_or_changes_the_value(interval: Dyadic, place: int, character: str) -> None:
    text = str(interval)
    place %= len(text)
    changed = text[:place] + character + text[place + 1 :]
    try:
        other = Dyadic.parse(changed)
    except ValueError:
        return
    assert (other == interval) == (changed == text)


@pytest.mark.parametrize("thing", [None, 5, b"[0x1, 0x3]p0", ["[0x1, 0x3]p0"]])
def test_parse_wants_text(thing: object) -> None:
    with pytest.raises(TypeError):
        Dyadic.parse(thing)  # type: ignore[arg-type]


# Balls


@given(balls(), precisions())
def test_from_ball_is_exact_at_any_precision(value: arb, bits: int) -> None:
    with working_bits(bits):
        assert span(Dyadic.from_ball(value)) == ends(value)


@given(nonfinite_balls())
def test_from_ball_wants_a_finite_ball(value: arb) -> None:
    with pytest.raises(ValueError, match="the ball must be finite"):
        Dyadic.from_ball(value)


@pytest.mark.parametrize(
    ("middle", "radius"),
    [((1, 2**90), (1, 0)), ((1, 2**90), (1, -(2**90))), ((1, -(2**90)), (1, 2**90))],
)
def test_from_ball_refuses_ends_that_no_exponent_reaches(middle: tuple[int, int], radius: tuple[int, int]) -> None:
    with pytest.raises(ValueError, match="exponent must lie within"):
        Dyadic.from_ball(arb(middle, radius))


def test_ends_are_exact_up_to_the_limit_and_outward_beyond() -> None:
    far = 10**7
    assert Dyadic.from_ball(arb((1, 0), (1, -far))) == Dyadic(2**far - 1, 2**far + 1, -far)
    assert Dyadic.from_ball(arb((1, far), (1, 0))) == Dyadic(2**far - 1, 2**far + 1, 0)
    assert Dyadic.from_ball(arb((1, 0), (1, -far - 1))) == Dyadic(2**1000 - 1, 2**1000 + 1, -1000)
    assert Dyadic.from_ball(arb((1, far + 1), (1, 0))) == Dyadic(2**1000 - 1, 2**1000 + 1, far - 999)
    assert Dyadic.from_ball(arb((1, 0), (1, far + 1))) == Dyadic(-(2**1000), 2**1000 + 1, far - 999)


@pytest.mark.parametrize(("middle", "radius"), [((1, 10**7), (1, 0)), ((1, 0), (1, 10**7)), ((1, -(10**7)), (1, 0))])
def test_from_ball_takes_the_last_ends_that_fit(middle: tuple[int, int], radius: tuple[int, int]) -> None:
    interval = Dyadic.from_ball(arb(middle, radius))
    least = min(middle[1], radius[1])
    sides = middle[0] << (middle[1] - least), radius[0] << (radius[1] - least)
    assert interval == Dyadic(sides[0] - sides[1], sides[0] + sides[1], least)


@pytest.mark.parametrize("exponent", [2**90, -(2**90), 10**24 + 1])
def test_from_ball_refuses_huge_exponents(exponent: int) -> None:
    for value in (arb((1, exponent)), arb((0, 0), (1, exponent)), arb((3, exponent), (1, exponent))):
        with pytest.raises(ValueError, match="exponent"):
            Dyadic.from_ball(value)


@given(dyadics(), precisions())
def test_to_ball_contains(interval: Dyadic, bits: int) -> None:
    with working_bits(bits):
        lower, upper = ends(interval.to_ball())
    first, last = span(interval)
    assert lower <= first
    assert last <= upper
    # Not much wider: flint rounds the radius up to 30 bits.
    assert upper - lower <= (last - first) * (1 + Fraction(1, 2**28))


@given(dyadics().filter(lambda d: (d.upper - d.lower).bit_length() <= 29), precisions())
def test_to_ball_is_equal_when_the_radius_fits(interval: Dyadic, bits: int) -> None:
    with working_bits(bits):
        assert ends(interval.to_ball()) == span(interval)


@given(balls())
def test_ball_round_trip_contains(value: arb) -> None:
    lower, upper = ends(Dyadic.from_ball(value).to_ball())
    first, last = ends(value)
    assert lower <= first
    assert last <= upper


@given(_INTEGERS, st.integers(-200, 200))
def test_points_round_trip(number: int, exponent: int) -> None:
    interval = Dyadic(number, number, exponent)
    value = interval.to_ball()
    assert value.is_exact()
    assert point(value) == dyadic_fraction(number, exponent)
    assert Dyadic.from_ball(value) == interval


# Decisions


@given(dyadics(), st.data())
def test_contains_its_numbers_and_no_other(interval: Dyadic, data: st.DataObject) -> None:
    lower, upper = span(interval)
    gap = Fraction(1, 10**300)
    for inside in (lower, upper, (lower + upper) / 2, (2 * lower + upper) / 3):
        assert interval.contains(inside)
    for outside in (lower - gap, upper + gap, lower - 1, upper + 1):
        assert not interval.contains(outside)
    number = data.draw(numbers_in(interval.to_ball()))
    assert interval.contains(number) == (lower <= number <= upper)


def test_contains_is_not_fooled_by_nan() -> None:
    assert not Dyadic(-1, 1).contains(float("nan"))  # type: ignore[arg-type]


@given(dyadics(), dyadics())
def test_inclusion_and_overlap_are_exact(first: Dyadic, second: Dyadic) -> None:
    (a, b), (c, d) = span(first), span(second)
    assert first.contains_interval(second) == (a <= c and d <= b)
    assert first.overlaps(second) == (max(a, c) <= min(b, d))


@given(small_dyadics(), small_dyadics(), small_dyadics())
def test_inclusion_is_an_order(first: Dyadic, second: Dyadic, third: Dyadic) -> None:
    assert first.contains_interval(first)
    if first.contains_interval(second) and second.contains_interval(first):
        assert first == second
    if first.contains_interval(second) and second.contains_interval(third):
        assert first.contains_interval(third)


@given(small_dyadics(), small_dyadics())
def test_overlap_is_symmetric_and_follows_from_inclusion(first: Dyadic, second: Dyadic) -> None:
    assert first.overlaps(first)
    assert first.overlaps(second) == second.overlaps(first)
    if first.contains_interval(second):
        assert first.overlaps(second)
    # Closed intervals overlap exactly when an end of one lies in the other.
    assert first.overlaps(second) == any(
        big.contains(end) for big, small in ((first, second), (second, first)) for end in small.endpoints()
    )


def test_a_shared_end_is_an_overlap() -> None:
    assert Dyadic(0, 1).overlaps(Dyadic(1, 2))
    assert not Dyadic(0, 1).overlaps(Dyadic(2**300 + 1, 2**301, -300))


@given(st.one_of(dyadics(), small_dyadics()))
def test_sign(interval: Dyadic) -> None:
    lower, upper = span(interval)
    expected = 1 if lower > 0 else -1 if upper < 0 else 0 if lower == upper == 0 else None
    assert interval.sign() == expected


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize(
    ("middle", "radius"),
    [
        ((3, 0), (1, -(10**9))),
        ((2**70 + 1, 5), (7, -(10**8))),
        ((3, -(10**9)), (1, 5)),
        ((2**80 + 1, -(10**8)), (3, 0)),
    ],
)
def test_a_ball_whose_parts_are_far_apart_is_rounded_outward(
    sign: int, middle: tuple[int, int], radius: tuple[int, int]
) -> None:
    """It was refused; its exact ends would need 10^8 bits and more."""
    ball = arb((sign * middle[0], middle[1]), radius)
    found = Dyadic.from_ball(ball)
    assert found.lower.bit_length() < 2_000
    lower, upper = found.endpoints()
    # The tiny part counts as 0 here: it moves an end by less than 2^-(10^7).
    centre, width = (Fraction(m) * Fraction(2) ** e if e > -1000 else Fraction(0) for m, e in (middle, radius))
    gaps = sign * centre - width - lower, upper - sign * centre - width
    unit = Fraction(2) ** (max(middle[1], radius[1]) - 1000)
    assert all(0 <= gap <= 2 * unit for gap in gaps)
    assert sum(gaps) > 0
    assert Dyadic.parse(str(found)) == found
