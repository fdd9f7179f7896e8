"""Complex inputs: read exactly, or refused with the name of the argument."""

from __future__ import annotations

import re
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest
from flint import acb, arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import ends, holds, small_heights, to_fmpq

from gspot_verified.numbers.balls import add_remainder, ball_text, nonfinite, relative_bits, working_bits
from gspot_verified.numbers.complex_numbers import (
    ExactComplex,
    complex_ball,
    exact_complex,
    is_complex,
    is_point,
    is_real,
    middle,
)


@pytest.mark.parametrize(
    ("text", "real", "imaginary"),
    [
        ("1+2i", "1", "2"),
        ("3/2+5/7j", "3/2", "5/7"),
        ("-3/2-5/7i", "-3/2", "-5/7"),
        ("i", "0", "1"),
        ("-j", "0", "-1"),
        ("+2i", "0", "2"),
        ("12i", "0", "12"),
        ("1+i", "1", "1"),
        ("  1 - 2.5e-3 i ", "1", "-1/400"),
        ("1e+2i", "0", "100"),
        ("1e-1-2E3j", "1/10", "-2000"),
        ("1+-2i", "1", "-2"),
        ("1 + -2/3i", "1", "-2/3"),
        ("\N{MINUS SIGN}1\N{MINUS SIGN}.5i", "-1", "-1/2"),
        ("0i", "0", "0"),
    ],
)
def test_texts(text: str, real: str, imaginary: str) -> None:
    assert is_complex(text)
    assert exact_complex(text, "tau") == (fmpq(*_parts(real)), fmpq(*_parts(imaginary)))


def _parts(text: str) -> tuple[int, int]:
    number = Fraction(text)
    return number.numerator, number.denominator


@given(small_heights(), small_heights(), st.sampled_from("ij"))
def test_a_text_made_of_two_numbers_is_read_as_they_are(real: Fraction, imaginary: Fraction, unit: str) -> None:
    expected = (to_fmpq(real), to_fmpq(imaginary))
    assert exact_complex(f"{real}+{imaginary}{unit}", "tau") == expected
    sign = "-" if imaginary < 0 else "+"
    assert exact_complex(f"{real} {sign} {abs(imaginary)}{unit}", "tau") == expected


@pytest.mark.parametrize(
    "text",
    ["nani", "infi", "-infj", "2ii", "1+2i+3i", "2i+1i", "1--2i", "1++2i", "1-+2i", "1..2i", "x+2i", "1+2xi", "i/2i"],
)
def test_other_texts_are_refused(text: str) -> None:
    with pytest.raises(ValueError, match=r"^tau: expected a"):
        exact_complex(text, "tau")


@pytest.mark.parametrize(("text", "why"), [("1/0+i", "zero"), ("1+1/0i", "zero"), ("1e999999i", "exponent")])
def test_what_is_no_number_in_a_part_is_refused_as_a_real_one_is(text: str, why: str) -> None:
    with pytest.raises(ValueError, match=f"^tau: .*{why}"):
        exact_complex(text, "tau")


def test_a_long_text_is_shown_in_part() -> None:
    with pytest.raises(ValueError, match=r"got 'x.{36}...'$"):
        exact_complex("x" * 100_000 + "i", "tau")
    for length, shown in ((40, "x" * 39 + "i"), (41, "x" * 37 + "...")):
        with pytest.raises(ValueError, match=rf"got '{re.escape(shown)}'$"):
            exact_complex("x" * (length - 1) + "i", "tau")


@pytest.mark.parametrize("value", [1, "1/2", "-50", "0.1", "", arb(1), fmpq(1), Fraction(1, 2), 0.5, None, (1, 2),
                                   mpmath.mpf(1), mpmath.iv.mpf(1)])  # fmt: skip
def test_other_inputs_are_not_complex(value: object) -> None:
    assert not is_complex(value)


@pytest.mark.parametrize("value", [acb(0.5, -2), mpmath.mpc(0.5, -2), mpmath.iv.mpc(0.5, -2)])
def test_numbers_of_flint_and_mpmath_are_taken_exactly(value: Any) -> None:
    assert is_complex(value)
    assert exact_complex(value, "tau") == (fmpq(1, 2), fmpq(-2))


def test_rectangles_keep_their_parts() -> None:
    wide = exact_complex(acb(arb(1, fmpq(1, 4)), 2), "tau")
    assert isinstance(wide.real, arb)
    assert ends(wide.real)[0] <= Fraction(3, 4)
    assert wide.imaginary == fmpq(2)
    interval = exact_complex(mpmath.iv.mpc([1, 2], [3, 4]), "tau")
    for part, lower in zip(interval, (1, 3), strict=True):
        assert isinstance(part, arb)
        assert holds(part, lower)
        assert holds(part, lower + 1)
    assert not is_point(wide)
    assert not is_point(exact_complex(acb(2, arb(1, 1)), "tau"))
    assert is_point(exact_complex("1+2i", "tau"))


@pytest.mark.parametrize("value", [0.1 + 2j, np.complex128(0.1 + 2j)])
def test_a_python_complex_is_refused_as_a_float_is(value: complex) -> None:
    assert is_complex(value)
    with pytest.raises(TypeError, match=r'^tau: .*write acb\(0\.1, 2\.0\) .* or "0\.1\+2\.0i"'):
        exact_complex(value, "tau")
    with pytest.raises(TypeError, match=r'"0\.1-2\.0i"'):
        exact_complex(0.1 - 2j, "tau")


@pytest.mark.parametrize("bad", [float("nan"), float("inf"), float("-inf")])
def test_what_is_not_finite_is_refused(bad: float) -> None:
    for value in (acb(arb(bad), 1), acb(1, arb(bad)), mpmath.mpc(bad, 1), mpmath.mpc(1, bad)):
        with pytest.raises(ValueError, match=r"^tau: the .* must be finite"):
            exact_complex(value, "tau")


def test_two_exact_parts_are_taken_as_they_are() -> None:
    value = ExactComplex(fmpq(1, 3), arb(0, 1))
    assert is_complex(value)
    assert exact_complex(value, "tau") is value


def test_what_is_real() -> None:
    assert is_real(exact_complex("3/2+0i", "tau"))
    assert is_real(exact_complex(acb(3), "tau"))
    assert not is_real(exact_complex("3/2+1e-500i", "tau"))
    assert not is_real(exact_complex(acb(3, arb(0, 1)), "tau"))


@given(small_heights(), small_heights(), st.integers(2, 200))
def test_a_ball_holds_its_number(real: Fraction, imaginary: Fraction, bits: int) -> None:
    with working_bits(bits):
        value = complex_ball(ExactComplex(to_fmpq(real), to_fmpq(imaginary)))
    assert holds(value.real, real)
    assert holds(value.imag, imaginary)


@pytest.mark.parametrize(
    ("value", "radius"),
    [
        (ExactComplex(arb(1, 3), arb(2, 4)), 5),
        (ExactComplex(arb(1, 3), fmpq(1, 3)), 3),
        (ExactComplex(fmpq(1, 3), arb(1, 4)), 4),
        (ExactComplex(fmpq(1, 3), fmpq(1, 3)), 0),
    ],
)
def test_the_middle_of_a_rectangle_and_its_reach(value: ExactComplex, radius: int) -> None:
    point, reach = middle(value)
    assert is_point(point)
    for part, center in zip(value, point, strict=True):
        assert center == part if isinstance(part, fmpq) else center == part.mid()
    lower, upper = ends(reach)
    assert radius <= lower <= upper <= radius + Fraction(1, 10**6)


def test_the_reach_of_a_rectangle_is_rounded_up() -> None:
    for numerator in range(1, 40):
        radius = Fraction(numerator, 2**20)
        lower, _ = ends(middle(ExactComplex(arb(1, to_fmpq(radius)), arb(2, to_fmpq(radius))))[1])
        assert lower**2 >= 2 * radius**2


def test_a_remainder_widens_both_parts() -> None:
    for bound in (arb(-3), acb(0, 3), arb(2, 1)):
        wide = add_remainder(acb(1, 10), bound)
        for part, center in ((wide.real, 1), (wide.imag, 10)):
            assert holds(part, center - 3)
            assert holds(part, center + 3)
            assert not holds(part, center + 4)
    assert not add_remainder(acb(1, 1), nonfinite()).is_finite()


@given(st.integers(-40, 40), st.integers(-40, 40), st.integers(0, 50), st.integers(0, 50))
def test_certain_bits_are_those_of_the_larger_part(real: int, imaginary: int, first: int, second: int) -> None:
    """Every number of the rectangle is nearer to its midpoint than sqrt(2) 2^-bits of the midpoint's size."""
    value = acb(arb(real, arb((1, -first))), arb(imaginary, arb((1, -second))))
    bits = relative_bits(value)
    square = Fraction(1, 4**first) + Fraction(1, 4**second)
    assert square <= 2 * Fraction(1, 4) ** bits * (real**2 + imaginary**2) if bits > 0 else True
    if real or imaginary:
        assert bits >= min(first, second) - 8 + (max(abs(real), abs(imaginary)).bit_length())


def test_the_text_of_a_complex_ball() -> None:
    with working_bits(60):
        assert ball_text(acb(arb(1) / 3, arb(0, "0.3")), 5) == "[0.33333 +/- 3.34e-6] + [-0.301, 0.301]i"
    assert ball_text(acb(nonfinite(), 1)) == "[no information] + 1.00000000000000i"
