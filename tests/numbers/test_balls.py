"""The ground: exact inputs in, enclosures out, precision restored, nothing certain that is not."""

from __future__ import annotations

import decimal
import functools
import itertools
import math
import random
import re
import threading
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from flint import acb, arb, arf, ctx, fmpq, fmpz
from hypothesis import assume, given
from hypothesis import strategies as st
from mpmath.libmp import from_man_exp
from samples.strategies import (
    balls,
    balls_with_number,
    ends,
    exact_balls,
    holds,
    nonfinite_balls,
    precise_balls,
    precisions,
    rationals,
    small_heights,
    to_fmpq,
    to_fraction,
    wide_balls,
)

from gspot_verified.numbers import balls as ground
from gspot_verified.numbers.balls import (
    MAX_DIGITS,
    MAX_WORKING_BITS,
    add_remainder,
    approximate,
    ball,
    ball_text,
    bits_for_digits,
    certainly_at_most,
    certainly_less,
    current_bits,
    digits_for_bits,
    exact,
    float_bounds,
    hull,
    is_exact,
    nonfinite,
    relative_bits,
    rounded_text,
    series_length,
    shrink_to_bits,
    sign_of,
    to_mpmath,
    working_bits,
)
from gspot_verified.theta_function.gamma.reciprocal_gamma import reciprocal_gamma_series

# exact


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (5, 5),
        (0, 0),
        (-(10**400), -(10**400)),
        (Fraction(-7, 3), Fraction(-7, 3)),
        (fmpq(7, 3), Fraction(7, 3)),
        (fmpz(-4), -4),
        (np.int64(-7), -7),
        (np.uint8(255), 255),
        (np.int32(3), 3),
        ("0.1", Fraction(1, 10)),
        ("-50", -50),
        ("+3", 3),
        ("7/3", Fraction(7, 3)),
        ("-2/6", Fraction(-1, 3)),
        ("+2/6", Fraction(1, 3)),
        ("0/5", 0),
        ("-0", 0),
        ("-0.0", 0),
        ("007", 7),
        (".5", Fraction(1, 2)),
        ("5.", 5),
        ("-.25", Fraction(-1, 4)),
        ("1e3", 1000),
        ("1E-3", Fraction(1, 1000)),
        ("-1.5e+2", -150),
        ("12.50e-1", Fraction(5, 4)),
        ("0e5", 0),
        ("  0.1\n", Fraction(1, 10)),
        ("0.30000000000000000000000000000000000000001", Fraction(3 * 10**40 + 1, 10**41)),
        ("1e100000", 10**100_000),
        ("1e-100000", Fraction(1, 10**100_000)),
    ],
    ids=lambda value: repr(value)[:30] if isinstance(value, str) else type(value).__name__,
)
def test_exact_accepts(value: ground.ExactInput, expected: Fraction | int) -> None:
    result = exact(value, "tau")
    assert isinstance(result, fmpq)
    assert to_fraction(result) == expected


def test_a_decimal_string_is_the_decimal() -> None:
    assert exact("0.1", "tau") == fmpq(1, 10)
    assert exact("0.1", "tau") != to_fmpq(Fraction(0.1))
    assert exact(Fraction(0.1), "tau") == fmpq(3602879701896397, 2**55)


def test_long_strings_of_digits_are_read_whole() -> None:
    assert exact("7" * 5000, "tau") == fmpq((10**5000 - 1) // 9 * 7)
    assert exact("0." + "0" * 5000 + "1", "tau") == fmpq(1, 10**5001)
    assert exact("1/1" + "0" * 5000, "tau") == fmpq(1, 10**5000)


@pytest.mark.parametrize(
    "value",
    [0.1, 1.0, float("nan"), float("inf"), np.float64(0.1), np.float64("nan")],
    ids=repr,
)
def test_exact_refuses_floats_and_says_what_to_write(value: float) -> None:
    with pytest.raises(TypeError, match=r"^tau: a float is not taken as exact; write Fraction\(") as caught:
        exact(value, "tau")
    assert repr(float(value)) in str(caught.value)


@pytest.mark.parametrize(
    "value",
    [
        True, False, np.bool_(True), np.float32(0.5), np.float16(0.5), decimal.Decimal("0.1"), 1j, 1 + 0j,
        np.complex128(1), None, [1], (1, 2), {1}, b"1", bytearray(b"1"), np.array([1, 2]), np.array(1.5), object(),
        acb(1), arf(1), mpmath.mpc(1), int, range(3),
    ],
    ids=lambda value: f"{type(value).__name__}",
)  # fmt: skip
def test_exact_refuses_other_types(value: object) -> None:
    with pytest.raises(TypeError, match=r"^beta: "):
        exact(value, "beta")  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "text",
    [
        "abc", "", " ", ".", "-", "+", "-.", "e5", ".e5", "1e", "1e+", "1e1.5", "1/0", "0/0", "-1/00", "1/", "/2",
        "1/2/3", "1.5/2", "1/2.5", "1/-2", "1 / 2", "1/ 2", "--1", "+-1", "1 2", "1\n2", "1..2", "1.2.3",
        "1e999999999", "1e-999999999", "1e100001", "1e-100001", "1e9999999999", "1e" + "9" * 100_000,
        "inf", "-inf", "Infinity", "nan", "NaN", "0x10", "0b1", "1_000", "1__0", "_1", "1_", "1,5", "1'000", "1d5",
        "١٢", "１２", "٣.٥", "1/٢", "1e٢", "½", "−−1", "²", "1\x00", "\x001", "1j", "0.1f", "[1 +/- 2]", "1 +/- 2",
        "9" * 2_000_001, "x" * 3_000_000, "0." + "0" * 2_000_000, "1/" + "7" * 2_000_000, "１" * 100_000,
    ],
    ids=lambda text: repr(text[:20]),
)  # fmt: skip
def test_exact_refuses_bad_text(text: str) -> None:
    with pytest.raises(ValueError, match=r"^beta: ") as caught:
        exact(text, "beta")
    assert len(str(caught.value)) < 200


@given(nonfinite_balls())
def test_exact_refuses_nonfinite_balls(value: arb) -> None:
    with pytest.raises(ValueError, match=r"^tau: .*finite"):
        exact(value, "tau")


class LyingNumber(fmpq):
    """A rational number that says that it is anything else."""

    def __lt__(self, other: object) -> bool:
        return True

    __gt__ = __le__ = __ge__ = __lt__

    def __eq__(self, other: object) -> bool:
        return True

    def __hash__(self) -> int:
        return 1

    def __str__(self) -> str:
        return "777"


class LyingBall(arb):
    """A ball that says that it is finite, exact and less than any other."""

    def is_finite(self) -> bool:
        return True

    def is_exact(self) -> bool:
        return True

    def __lt__(self, other: object) -> bool:
        return True


def test_exact_takes_no_word_of_a_subclass() -> None:
    found = exact(LyingNumber(-1, 2), "tau")
    assert type(found) is fmpq
    assert (str(found), found < -1) == ("-1/2", False)
    wide = exact(LyingBall(2, 1), "tau")
    assert type(wide) is arb
    assert (wide.is_exact(), wide < 1) == (False, False)
    assert exact(LyingBall(2), "tau") == fmpq(2)
    with pytest.raises(ValueError, match="must be finite"):
        exact(LyingBall("nan"), "tau")


@given(balls(), precisions())
def test_exact_passes_a_ball_through_unrounded(value: arb, bits: int) -> None:
    with working_bits(bits):
        found = exact(value, "tau")
    if value.is_exact():
        assert isinstance(found, fmpq)
        assert to_fraction(found) == ends(value)[0]
    else:
        assert found is value


@pytest.mark.parametrize("exponent", [40_000, -40_000, 0, 1, -1])
def test_exact_reads_an_exact_ball_up_to_the_last_exponent(exponent: int) -> None:
    found = exact(arb((3, exponent)), "tau")
    assert isinstance(found, fmpq)
    assert found == fmpq(3) * fmpq(2) ** exponent
    for beyond in (40_001, -40_001):
        assert isinstance(exact(arb((3, beyond)), "tau"), arb)


def test_a_long_word_is_shortened_in_the_message() -> None:
    for word, shown in (("x" * 40, "x" * 40), ("x" * 41, "x" * 37 + "..."), ("y", "y")):
        with pytest.raises(ValueError, match="expected a number") as caught:
            exact(word, "tau")
        assert str(caught.value).endswith(f"got {shown!r}")


def test_the_longest_number() -> None:
    assert exact("0" * 1_999_999 + "7", "tau") == 7
    with pytest.raises(ValueError, match="at most 2000000 characters"):
        exact("0" * 2_000_001, "tau")


def test_exact_keeps_an_exact_ball_whose_rational_would_fill_the_memory() -> None:
    for exponent in (10**6, -(10**6), 2**70, -(2**70)):
        value = arb((1, exponent))
        assert exact(value, "tau") is value


@given(rationals(), precisions())
def test_exact_is_exact_at_any_precision(number: Fraction, bits: int) -> None:
    with working_bits(bits):
        for form in (number, to_fmpq(number), f"{number.numerator}/{number.denominator}", str(number), f" {number} "):
            assert to_fraction(exact(form, "tau")) == number


@given(st.from_regex(re.compile(r"[+-]?[0-9]{1,40}(\.[0-9]{0,40})?([eE][+-]?[0-9]{1,3})?", re.ASCII), fullmatch=True))
def test_decimal_strings_mean_what_python_means(text: str) -> None:
    assert to_fraction(exact(text, "tau")) == Fraction(text)


@given(st.one_of(st.text(max_size=12), st.text("0123456789+-./eE _", max_size=12)))
def test_any_text_is_a_number_or_a_clear_error(text: str) -> None:
    try:
        value = exact(text, "tau")
    except ValueError as error:
        message = str(error)
    else:
        message = "tau: "
        assert to_fraction(value) == Fraction(text)
    assert message.startswith("tau: ")


@given(st.one_of(rationals().map(to_fmpq), balls()))
def test_is_exact(value: ground.Exact) -> None:
    lower, upper = (0, 0) if isinstance(value, fmpq) else ends(value)
    assert is_exact(value) == (lower == upper)


# digits


@pytest.mark.parametrize("digits", [0, -1, -(10**30), MAX_DIGITS + 1, 10**9, 2**70])
def test_digits_out_of_range(digits: int) -> None:
    with pytest.raises(ValueError, match=r"digits must lie in 1\.\.1000000"):
        bits_for_digits(digits)


@pytest.mark.parametrize(
    "digits", [2.5, 15.0, True, False, "15", None, np.float64(3), Fraction(3), float("nan"), 3j, [3]], ids=repr
)
def test_digits_of_another_type(digits: object) -> None:
    with pytest.raises(TypeError, match="digits must be an int"):
        bits_for_digits(digits)  # type: ignore[arg-type]


@pytest.mark.parametrize("digits", [1, 2, 15, 16, 50, 100, 1000, 30_103, 100_000])
def test_bits_stand_for_the_digits(digits: int) -> None:
    bits = bits_for_digits(digits)
    assert 10**digits <= 2**bits < 8 * 10**digits
    assert bits_for_digits(np.int64(digits)) == bits  # type: ignore[arg-type]
    assert type(bits) is int


@pytest.mark.parametrize("bits", [1, 3, 4, 10, 53, 64, 1_000, 100_000])
def test_digits_stand_for_the_bits(bits: int) -> None:
    digits = digits_for_bits(bits)
    assert 10 ** (digits - 1) < 2**bits <= 10**digits
    assert type(digits) is int


def test_the_largest_number_of_digits() -> None:
    assert 3_321_928 < bits_for_digits(MAX_DIGITS) < 3_321_932


# working_bits


@pytest.mark.parametrize("bits", [1, 0, -5, MAX_WORKING_BITS + 1, 10**12, -(2**70)])
def test_working_bits_out_of_range(bits: int) -> None:
    with pytest.raises(ValueError, match="bits must lie in"):
        working_bits(bits)


def test_the_last_precision_that_is_allowed() -> None:
    working_bits(64_000_000)
    with pytest.raises(ValueError, match=r"2\.\.64000000"):
        working_bits(64_000_001)


@pytest.mark.parametrize("bits", ["53", None, 60.7, 64.0, float("nan"), np.float64(64), Fraction(64), [64]], ids=repr)
def test_working_bits_of_another_type(bits: object) -> None:
    """flint truncates a float silently."""
    before = current_bits()
    with pytest.raises((TypeError, ValueError)), working_bits(bits):  # type: ignore[arg-type]
        pass
    assert current_bits() == before


@pytest.mark.parametrize("bits", [2, 53, 200, 10_000])
def test_working_bits_sets_and_restores(bits: int) -> None:
    before = current_bits()
    with working_bits(bits):
        assert current_bits() == bits
    assert current_bits() == before


def test_working_bits_restores_after_an_exception() -> None:
    before = current_bits()
    with pytest.raises(ZeroDivisionError), working_bits(200), working_bits(300):
        raise ZeroDivisionError
    assert current_bits() == before
    with pytest.raises(KeyboardInterrupt), working_bits(200):
        raise KeyboardInterrupt
    assert current_bits() == before


def test_working_bits_after_an_exception_leaves_the_lock_free() -> None:
    with pytest.raises(ZeroDivisionError), working_bits(200):
        raise ZeroDivisionError
    reached: list[int] = []

    def enter() -> None:
        with working_bits(77):
            reached.append(current_bits())

    thread = threading.Thread(target=enter, daemon=True)
    thread.start()
    thread.join(60)
    assert reached == [77]


@given(st.lists(st.integers(2, 3000), min_size=1, max_size=8), st.booleans())
def test_working_bits_nests(precisions_wanted: list[int], fails: bool) -> None:
    before = current_bits()

    def descend(rest: list[int]) -> None:
        if not rest:
            if fails:
                raise RuntimeError("deep inside")
            return
        outer = current_bits()
        with working_bits(rest[0]):
            assert current_bits() == rest[0]
            try:
                descend(rest[1:])
            finally:
                assert current_bits() == rest[0]
        assert current_bits() == outer

    if fails:
        with pytest.raises(RuntimeError):
            descend(precisions_wanted)
    else:
        descend(precisions_wanted)
    assert current_bits() == before


def test_the_same_object_can_be_entered_again() -> None:
    before = current_bits()
    scope = working_bits(150)
    with scope:
        with working_bits(70):
            with scope:
                assert current_bits() == 150
                with scope:
                    assert current_bits() == 150
            assert current_bits() == 70
        assert current_bits() == 150
    assert current_bits() == before
    with scope:
        assert current_bits() == 150
    assert current_bits() == before


def test_threads_get_the_precision_they_asked_for() -> None:
    def compute(bits: int) -> tuple[int, tuple[int, int], tuple[int, int]]:
        with working_bits(bits):
            asked = current_bits()
            value = (arb(2).sqrt() + arb.pi()).exp()
            with working_bits(bits + 64):
                value = value * arb(3).log()
            value += arb(1) / 7
        middle, radius = value.mid().man_exp(), value.rad().man_exp()
        return asked, (int(middle[0]), int(middle[1])), (int(radius[0]), int(radius[1]))

    before = current_bits()
    jobs = [30 + 17 * (j % 23) for j in range(400)]
    random.Random(1).shuffle(jobs)
    alone = {bits: compute(bits) for bits in set(jobs)}
    with ThreadPoolExecutor(8) as pool:
        results = list(pool.map(compute, jobs))
    assert results == [alone[bits] for bits in jobs]
    assert [asked for asked, _, _ in results] == jobs
    assert current_bits() == before


def test_threads_may_share_one_scope() -> None:
    before = current_bits()
    shared = working_bits(111)

    def enter(_: int) -> int:
        with shared, shared:
            return current_bits()

    with ThreadPoolExecutor(8) as pool:
        assert set(pool.map(enter, range(200))) == {111}
    assert current_bits() == before


# Enclosures


@given(rationals(), precisions())
def test_ball_contains_the_rational(number: Fraction, bits: int) -> None:
    with working_bits(bits):
        value = ball(to_fmpq(number))
    assert holds(value, number)
    lower, upper = ends(value)
    assert upper - lower <= abs(number) * Fraction(8, 2**bits)


@given(balls_with_number(), precisions())
def test_ball_contains_the_ball(pair: tuple[arb, Fraction], bits: int) -> None:
    value, number = pair
    with working_bits(bits):
        assert holds(ball(value), number)


@given(balls_with_number(), st.integers(-10, 500))
def test_shrink_to_bits_is_outward_and_short(pair: tuple[arb, Fraction], bits: int) -> None:
    value, number = pair
    before = current_bits()
    shrunk = shrink_to_bits(value, bits)
    assert current_bits() == before
    assert holds(shrunk, number)
    assert shrunk.bits() <= max(bits, 30)
    (lower, upper), (first, last) = ends(value), ends(shrunk)
    largest = max(abs(lower), abs(upper))
    assert last - first <= (upper - lower) * (1 + Fraction(1, 2**20)) + largest * Fraction(4, 2 ** max(bits, 30))


@pytest.mark.parametrize("bits", [2, 30, 31, 100, 200])
def test_a_long_midpoint_is_cut_to_the_bits_asked_for(bits: int) -> None:
    with working_bits(500):
        root = arb(2).sqrt()
    with working_bits(1000):
        shrunk = shrink_to_bits(root, bits)
        assert shrunk.contains(root)
        assert shrunk.mid().bits() <= max(bits, 30)
        assert shrunk.rel_accuracy_bits() >= max(bits, 30) - 2


def test_ball_rounds_to_the_precision_in_force() -> None:
    with working_bits(500):
        root = arb(2).sqrt()
    with working_bits(40):
        rounded = ball(root)
        assert rounded.mid().bits() <= 40
        assert rounded.contains(root)


@given(nonfinite_balls())
def test_nothing_makes_a_nonfinite_ball_finite(value: arb) -> None:
    assert not shrink_to_bits(value, 53).is_finite()
    assert not ball(value).is_finite()
    assert not add_remainder(value, arb(1)).is_finite()
    assert not add_remainder(arb(1), value).is_finite()
    assert not add_remainder(arb(0), -value).is_finite()
    assert relative_bits(value) < 0
    assert float_bounds(value) == (-math.inf, math.inf)
    assert ball_text(value) == "[no information]"


def test_nonfinite_carries_no_information() -> None:
    value = nonfinite()
    assert not value.is_finite()
    assert sign_of(value) is None
    assert certainly_less(value, arb(1)) is None
    assert certainly_less(arb(1), value) is None


@given(balls_with_number(), balls_with_number(), precisions(), st.booleans())
def test_add_remainder_contains_value_plus_any_smaller_remainder(
    pair: tuple[arb, Fraction], bounding: tuple[arb, Fraction], bits: int, negative: bool
) -> None:
    (value, number), (bound, remainder) = pair, bounding
    with working_bits(bits):
        widened = add_remainder(value, bound)
    assert holds(widened, number + (-remainder if negative else remainder))
    assert holds(widened, number)


@given(balls_with_number(), precisions())
def test_add_remainder_covers_the_largest_number_of_the_bound(pair: tuple[arb, Fraction], bits: int) -> None:
    bound, _ = pair
    lower, upper = ends(bound)
    with working_bits(bits):
        widened = add_remainder(arb(0), bound)
    for number in (lower, upper, -lower, -upper):
        assert holds(widened, number)


def test_add_remainder_of_zero_changes_nothing() -> None:
    assert ends(add_remainder(arb(3), arb(0))) == (3, 3)


# Certain comparisons


@given(balls())
def test_sign_of_is_the_sign_of_every_number(value: arb) -> None:
    lower, upper = ends(value)
    expected = 1 if lower > 0 else -1 if upper < 0 else 0 if lower == upper == 0 else None
    assert sign_of(value) == expected


@pytest.mark.parametrize("text", ["nan", "0 +/- inf", "1 +/- inf", "-1 +/- inf", "nan +/- inf"])
def test_sign_of_is_never_certain_without_information(text: str) -> None:
    assert sign_of(arb(text)) is None
    assert sign_of(-arb(text)) is None


@given(balls(), balls(), precisions())
def test_certainly_less(left: arb, right: arb, bits: int) -> None:
    (a, b), (c, d) = ends(left), ends(right)
    with working_bits(bits):
        answer = certainly_less(left, right)
        weak = certainly_at_most(left, right)
    assert answer is (True if b < c else False if a >= d else None)
    assert weak is (True if b <= c else False if a > d else None)


def test_balls_that_touch_are_compared_exactly() -> None:
    low, high = arb((1, -1), (1, -1)), arb((3, -1), (1, -1))  # [0, 1] and [1, 2]
    assert certainly_less(low, high) is None
    assert certainly_less(high, low) is False
    assert certainly_at_most(low, high) is True
    assert certainly_at_most(high, low) is None


@given(balls())
def test_certainly_less_than_itself_only_when_it_is_one_number(value: arb) -> None:
    assert certainly_less(value, value) is (False if value.is_exact() else None)
    assert certainly_at_most(value, value) is (True if value.is_exact() else None)


@given(st.sampled_from(("nan", "0 +/- inf", "1 +/- inf", "-1 +/- inf")).map(arb), balls())
def test_certainly_less_is_never_certain_without_information(value: arb, other: arb) -> None:
    for compare in (certainly_less, certainly_at_most):
        assert compare(value, other) is None
        assert compare(other, value) is None


@given(balls())
def test_relative_bits(value: arb) -> None:
    bits = relative_bits(value)
    lower, upper = ends(value)
    if lower == upper:
        assert bits == MAX_WORKING_BITS
        return
    assume(abs(bits) < 10**5)
    assert (upper - lower) / 2 <= max(abs(lower), abs(upper)) * Fraction(2) ** -bits


@given(balls())
def test_relative_bits_of_a_ball_around_zero(value: arb) -> None:
    lower, upper = ends(value)
    assume(lower <= 0 <= upper and lower != upper)
    assert relative_bits(value) <= 0


@given(precise_balls())
def test_relative_bits_is_not_modest(value: arb) -> None:
    lower, upper = ends(value)
    assert (upper - lower) / 2 >= max(abs(lower), abs(upper)) * Fraction(2) ** (-relative_bits(value) - 3)


# Floats out


@given(balls())
def test_float_bounds_enclose(value: arb) -> None:
    before = current_bits()
    lower, upper = float_bounds(value)
    first, last = ends(value)
    assert lower < upper
    assert lower == -math.inf or Fraction(lower) <= first
    assert upper == math.inf or last <= Fraction(upper)
    assert current_bits() == before


@given(rationals(), st.integers(0, 40))
def test_float_bounds_are_tight(number: Fraction, gap: int) -> None:
    assume(abs(number) > Fraction(1, 10**290) or number == 0)
    with working_bits(200):
        value = arb(to_fmpq(number)) + arb(0, arb(to_fmpq(abs(number) / 2**gap)))
    lower, upper = float_bounds(value)
    first, last = ends(value)
    slack = max(abs(first), abs(last)) * Fraction(1, 2**50) + Fraction(1, 2**1070)
    assert first - slack <= Fraction(lower)
    assert Fraction(upper) <= last + slack


@pytest.mark.parametrize("exponent", [1023, 1024, 1025, 2000, 2**40, 2**70])
@pytest.mark.parametrize("sign", [1, -1])
def test_float_bounds_of_numbers_beyond_floats(exponent: int, sign: int) -> None:
    lower, upper = float_bounds(arb((sign, exponent)))
    small, large = (lower, upper) if sign > 0 else (-upper, -lower)
    assert large == math.inf or Fraction(large) >= 2**exponent
    assert Fraction(small) < 2 ** min(exponent, 1100)
    assert small > 1e300


@pytest.mark.parametrize("exponent", [-1022, -1073, -1074, -1075, -1100, -5000, -(2**70)])
@pytest.mark.parametrize("sign", [1, -1])
def test_float_bounds_of_tiny_numbers(exponent: int, sign: int) -> None:
    lower, upper = float_bounds(arb((sign, exponent)))
    small, large = (lower, upper) if sign > 0 else (-upper, -lower)
    assert Fraction(small) <= Fraction(1, 2 ** min(-exponent, 10**4)) or small <= 0
    assert large > 0
    assert exponent < -1074 or Fraction(large) >= Fraction(1, 2**-exponent)


def test_float_bounds_of_a_ball_across_the_limits() -> None:
    assert float_bounds(arb((0, 0), (1, 3000))) == (-math.inf, math.inf)
    lower, upper = float_bounds(arb((0, 0), (1, -3000)))
    assert lower < 0 < upper


@given(rationals())
def test_approximate_is_near(number: Fraction) -> None:
    assert approximate(to_fmpq(number)) == number.numerator / number.denominator


def test_approximate_never_fails() -> None:
    assert approximate(fmpq(10**400)) == math.inf
    assert approximate(fmpq(-(10**400))) == -math.inf
    assert approximate(fmpq(1, 10**400)) == 0
    assert approximate(fmpq(10**400 + 1, 10**400)) == 1
    assert approximate(arb((1, 2**70))) == math.inf
    assert approximate(arb((3, -1), (1, 0))) == 1.5


# 1/Gamma as a power series


@functools.lru_cache
def reciprocal_gamma_derivatives(at: Fraction) -> list[Fraction]:
    """The Taylor coefficients 0 .. 39 of 1/Gamma to 10^-50, by the trapezoidal rule on the unit circle."""
    points = 192
    with mpmath.workprec(400):
        circle = [mpmath.expjpi(mpmath.mpf(2 * j) / points) for j in range(points)]
        values = [mpmath.rgamma(mpmath.mpf(at.numerator) / at.denominator + z) for z in circle]
        sums = [mpmath.fsum(v * circle[-k * j % points] for j, v in enumerate(values)) for k in range(40)]
        return [mpf_fraction(mpmath.re(total) / points) for total in sums]


def mpf_fraction(number: mpmath.mpf) -> Fraction:
    sign, mantissa, exponent, _ = number._mpf_
    return (-1) ** sign * Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


_ARGUMENTS = [
    Fraction(1, 3),
    Fraction(0),
    Fraction(-3),
    Fraction(5),
    Fraction(-17, 3),
    Fraction(-2) + Fraction(1, 10**9),
]


@pytest.mark.parametrize("argument", _ARGUMENTS)
def test_reciprocal_gamma_series(argument: Fraction) -> None:
    expected = reciprocal_gamma_derivatives(argument)
    for length, slope in itertools.product(range(1, 41), (Fraction(1), Fraction(-1, 7), Fraction(0))):
        with working_bits(160):
            values = reciprocal_gamma_series(arb(to_fmpq(argument)), arb(to_fmpq(slope)), length)
        assert len(values) == length
        for i, value in enumerate(values):
            lower, upper = ends(value)
            assert lower - Fraction(1, 10**50) <= expected[i] * slope**i <= upper + Fraction(1, 10**50)
            assert upper - lower < Fraction(1, 10**30)


@given(small_heights(), st.integers(1, 20), st.integers(2, 60))
def test_reciprocal_gamma_series_of_a_wide_argument(argument: Fraction, length: int, bits: int) -> None:
    with working_bits(bits):
        wide = reciprocal_gamma_series(arb(to_fmpq(argument), fmpq(1, 16)), arb(fmpq(1), fmpq(1, 16)), length)
    with working_bits(200):
        for shift, slope in itertools.product((fmpq(-1, 16), fmpq(0), fmpq(1, 16)), (fmpq(15, 16), fmpq(17, 16))):
            inner = reciprocal_gamma_series(arb(to_fmpq(argument) + shift), arb(slope), length)
            for outside, inside in zip(wide, inner, strict=True):
                # At few bits flint may give up; it must not be wrong.
                assert not outside.is_finite() or outside.overlaps(inside)


def test_reciprocal_gamma_series_has_every_coefficient_that_was_asked() -> None:
    """flint leaves out zeros at the end: of a constant, and of the one coefficient at a pole."""
    assert [str(v) for v in reciprocal_gamma_series(arb(1), arb(0), 3)] == ["1.00000000000000", "0", "0"]
    assert [v.is_zero() for v in reciprocal_gamma_series(arb(-2), arb(0), 3)] == [True] * 3
    assert [v.is_zero() for v in reciprocal_gamma_series(arb(-2), arb(1), 1)] == [True]


def test_reciprocal_gamma_series_restores_the_cap() -> None:
    before = ctx.cap
    for cap in (3, 10, 50):
        ctx.cap = cap
        try:
            assert len(reciprocal_gamma_series(arb(1) / 3, arb(1), 24)) == 24
            assert ctx.cap == cap
            with pytest.raises(TypeError):
                reciprocal_gamma_series("1/3", object(), 24)  # type: ignore[arg-type]
            assert ctx.cap == cap
            assert reciprocal_gamma_series(arb(1), arb(1), 0) == []
            with pytest.raises(ValueError, match="length must be"):
                reciprocal_gamma_series(arb(1), arb(1), -1)
            assert ctx.cap == cap
        finally:
            ctx.cap = before


# Text


_NUMBER = r"-?[0-9]+(?:\.[0-9]*)?(?:e[+-]?[0-9]+)?"


def printed_interval(text: str) -> tuple[Fraction, Fraction]:
    """What the text says, read by its decimals."""
    if match := re.fullmatch(rf"\[({_NUMBER}) \+/- ({_NUMBER})\]", text):
        middle, radius = Fraction(match[1]), Fraction(match[2])
        return middle - radius, middle + radius
    if match := re.fullmatch(rf"\[\+/- ({_NUMBER})\]", text):
        return -Fraction(match[1]), Fraction(match[1])
    if match := re.fullmatch(rf"\[({_NUMBER}), ({_NUMBER})\]", text):
        return Fraction(match[1]), Fraction(match[2])
    assert re.fullmatch(_NUMBER, text), f"unreadable: {text!r}"
    return Fraction(text), Fraction(text)


@given(balls(), st.integers(1, 40), precisions())
def test_the_printed_interval_contains_the_ball(value: arb, digits: int, bits: int) -> None:
    with working_bits(bits):
        text = ball_text(value, digits)
    lower, upper = printed_interval(text)
    first, last = ends(value)
    assert lower <= first
    assert last <= upper


@given(wide_balls(), precisions())
def test_wide_balls_print_as_ends_that_are_near(value: arb, bits: int) -> None:
    lower, upper = ends(value)
    with working_bits(bits):
        text = ball_text(value)
    assume("," in text)
    first, last = printed_interval(text)
    slack = max(abs(lower), abs(upper)) * Fraction(11, 1000)
    assert lower - slack <= first
    assert last <= upper + slack


@given(st.one_of(precise_balls(), exact_balls()), st.integers(1, 30))
def test_narrow_balls_print_their_digits(value: arb, digits: int) -> None:
    lower, upper = ends(value)
    first, last = printed_interval(ball_text(value, digits))
    # flint drops digits that are not certain: up to a factor of 10, twice.
    assert last - first <= 30 * (upper - lower) + abs(upper) * Fraction(4, 10 ** (digits - 1))


@pytest.mark.parametrize("exponent", [2**40, -(2**40), 2**70])
def test_text_of_huge_exponents_is_short(exponent: int) -> None:
    for value in (arb((1, exponent)), arb((3, exponent), (1, exponent)), arb((3, exponent), (1, exponent - 30))):
        assert 0 < len(ball_text(value)) < 200


def test_text_examples() -> None:
    assert ball_text(arb(0)) == "0"
    assert ball_text(arb(3), 5) == "3.0000"
    assert ball_text(arb((0, 0), (1, 0)), 5) == "[-1.01, 1.01]"


@pytest.mark.parametrize("text", ["−50", "−7/3", "−0.1", "−1.5e3", "2e−3", " −4 "])
def test_the_typeset_minus_is_a_minus(text: str) -> None:
    assert exact(text, "tau") == exact(text.replace("−", "-"), "tau")


@pytest.mark.parametrize("text", ["–50", "—50", "‐5", "1−2", "−−1", "−", "7/−3"])
def test_other_dashes_and_a_minus_elsewhere_are_not_numbers(text: str) -> None:
    with pytest.raises(ValueError, match="tau: expected a number"):
        exact(text, "tau")


@given(precise_balls(), precisions(), st.integers(1, 60))
def test_the_text_does_not_depend_on_the_precision_in_force(value: arb, bits: int, digits: int) -> None:
    text = ball_text(value, digits)
    with working_bits(bits):
        assert ball_text(value, digits) == text


@pytest.mark.parametrize("rounding", [decimal.ROUND_HALF_EVEN, decimal.ROUND_UP, decimal.ROUND_DOWN])
def test_the_text_does_not_depend_on_the_users_decimals(rounding: str) -> None:
    value = arb("0.0347", "0.0333")
    texts = ball_text(value), rounded_text(12.3456, -1), rounded_text(12.3456, 1), rounded_text(-1234567.5, 1, 6)
    assert texts == ("[0.00139, 0.0681]", "12.3", "12.4", "-1.23456e+6")
    with decimal.localcontext(decimal.Context(prec=1, rounding=rounding, Emax=1, Emin=-1)):
        assert texts == (
            ball_text(value), rounded_text(12.3456, -1), rounded_text(12.3456, 1), rounded_text(-1234567.5, 1, 6)
        )  # fmt: skip


def test_fifteen_digits_when_nothing_is_said() -> None:
    with working_bits(200):
        assert ball_text(arb(1) / 3).startswith("[0.333333333333333 +/- ")


def test_the_length_of_series_is_restored() -> None:
    before = ctx.cap
    with series_length(5):
        with pytest.raises(ZeroDivisionError), series_length(7):
            print(1 // (ctx.cap - 7))
        assert ctx.cap == 5
    assert ctx.cap == before


@pytest.mark.parametrize("length", [-1, 2.5, True, "3", 10**9])
def test_a_length_that_is_none(length: object) -> None:
    with pytest.raises(ValueError, match="length must be an int in"):
        series_length(length)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (arb(2, 1), "[0.999, 3.01]"),
        (arb(-2, 1), "[-3.01, -0.999]"),
        (arb((5, -1), (5, -1)), "[-4.95e-324, 5.01]"),
        (arb((-5, -1), (5, -1)), "[-5.01, 4.95e-324]"),
    ],
)
def test_wide_balls_show_both_ends_on_either_side_of_zero(value: arb, text: str) -> None:
    assert ball_text(value) == text


@pytest.mark.parametrize(
    "value",
    [
        arb(0, (1, 2000)),
        arb((1, 2000), (1, 2000)),
        arb((-1, 2000), (1, 2000)),
        arb(0, (1, -1200)),
        arb((1, -1200), (1, -1200)),
    ],
    ids=["both ends beyond floats", "the upper end", "the lower end", "tiny", "tiny and positive"],
)
def test_ends_that_no_float_shows_are_written_as_midpoint_and_radius(value: arb) -> None:
    with working_bits(64):
        text = ball_text(value)
        assert "inf" not in text.lower()
        assert arb(text).contains(value)
        assert arb(text).rad() < 8 * value.rad()


def test_a_hull_holds_every_part_and_what_lies_between() -> None:
    parts = [arb(1), arb(-3), arb(5, "0.5"), arb(2)]
    for turned in (parts, parts[::-1]):
        found = hull(iter(turned))
        assert found.is_finite()
        assert all(found.contains(part) for part in (*parts, arb(4)))
    assert not hull([arb(1), arb(2)]).contains(arb(5))


def test_a_hull_with_a_part_of_which_nothing_is_known_says_nothing() -> None:
    assert not hull([arb(1), arb.nan(), arb(2)]).is_finite()


def test_a_hull_of_no_parts_is_refused() -> None:
    with pytest.raises(TypeError, match="empty"):
        hull([])


@given(st.integers(-(2**200), 2**200), st.integers(-300, 300))
def test_numbers_of_mpmath_are_exact(mantissa: int, exponent: int) -> None:
    value = Fraction(mantissa) * Fraction(2) ** exponent
    number = mpmath.mp.make_mpf(from_man_exp(mantissa, exponent))
    assert exact(number, "tau") == fmpq(value.numerator, value.denominator)


@given(st.fractions(max_denominator=99), st.fractions(min_value=0, max_denominator=99))
def test_an_interval_of_mpmath_becomes_a_ball_around_it_and_back(lower: Fraction, width: Fraction) -> None:
    """Through a ball and back the interval can only grow: both ways round outward."""
    upper = lower + width
    ends_of_it = [mpmath.mpf(end.numerator) / end.denominator for end in (lower, upper)]
    interval = mpmath.iv.mpf(ends_of_it)
    value = exact(interval, "tau")
    with working_bits(200):
        value = arb(value)
        assert value.is_finite()
        back = to_mpmath(value)
    assert interval in back


def test_what_of_mpmath_is_refused() -> None:
    for value in (mpmath.mpc(1, 2), mpmath.pi, mpmath.matrix([1])):
        with pytest.raises(TypeError, match="of mpmath an mpf or an iv"):
            exact(value, "tau")
    for value in (mpmath.inf, mpmath.nan, mpmath.mpf("1e50000"), mpmath.iv.mpf(["-inf", 1])):
        with pytest.raises(ValueError, match="tau: the"):
            exact(value, "tau")
    with pytest.raises(ValueError, match="finite"):
        to_mpmath(arb.nan())
