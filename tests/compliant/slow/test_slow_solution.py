"""The slow solution against its definition, exact polynomials, its equation, its limit, and itself by two routes.

Pages: proofs/epsilon_series.md, proofs/exact_solution.md, proofs/slow_integral.md.
"""

from __future__ import annotations

from fractions import Fraction

import mpmath
import numpy as np
import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import ends, holds, to_fmpq
from witnesses.slow_solution import continued, defining_integral, polynomial_value
from witnesses.theta import contains_witness, to_fraction

from gspot_verified import theta
from gspot_verified.compliant.slow.grid import scale
from gspot_verified.compliant.slow.routes import ROUTES
from gspot_verified.compliant.slow.slow_solution import slow_solution, slow_value
from gspot_verified.numbers.balls import bits_for_digits, working_bits

EPSILONS = [Fraction(10), Fraction(1, 7), Fraction(1, 1000), Fraction(1, 10**300)]
FURTHER_EPSILONS = [Fraction(1), Fraction(1, 10**9)]


def scaled_time(tau: Fraction, epsilon: Fraction) -> Fraction:
    """A rational T with T (epsilon/2)^(1/3) near tau."""
    with working_bits(300):
        quotient = (arb(to_fmpq(tau)) / scale(to_fmpq(epsilon))).mid()
    mantissa, exponent = (int(part) for part in quotient.man_exp())
    return Fraction(mantissa) * Fraction(2) ** exponent


@pytest.mark.parametrize(
    "epsilon", [*EPSILONS, *(pytest.param(epsilon, marks=pytest.mark.slow) for epsilon in FURTHER_EPSILONS)], ids=str
)
@pytest.mark.parametrize("b", [Fraction(-1, 2), pytest.param(Fraction(-7, 3), marks=pytest.mark.slow), Fraction(-6)])
@pytest.mark.parametrize("tau", [Fraction(-5), pytest.param(Fraction(0), marks=pytest.mark.slow), Fraction(4)])
def test_against_the_definition(tau: Fraction, b: Fraction, epsilon: Fraction) -> None:
    time = scaled_time(tau, epsilon)
    found = slow_value(to_fmpq(time), to_fmpq(b), to_fmpq(epsilon), digits=25)
    assert found.reached
    if epsilon > Fraction(1, 10**20):  # beyond, the witness would need thousands of digits
        witness = to_fraction(defining_integral(time, b, epsilon))
        assert contains_witness(found.value, witness, 22)


@pytest.mark.parametrize("n", range(13))
@pytest.mark.parametrize("epsilon", [Fraction(32), Fraction(1, 3), Fraction(1, 10**6)])
def test_integer_b_is_a_polynomial(n: int, epsilon: Fraction) -> None:
    for time in (Fraction(-3, 2), Fraction(0), Fraction(1, 2), Fraction(20)):
        found = slow_value(to_fmpq(time), n, to_fmpq(epsilon), digits=30).value
        exact = polynomial_value(time, n, epsilon)
        assert holds(found, exact)
        lower, upper = ends(found)
        assert upper - lower <= max(abs(exact), Fraction(1)) / 10**25


@given(
    st.fractions(Fraction(-40), Fraction(25), max_denominator=50),
    st.fractions(Fraction(-4), Fraction(13), max_denominator=9),
    st.integers(7, 200),
    st.integers(1, 60),
)
@settings(max_examples=40)
def test_two_routes_agree(tau: Fraction, b: Fraction, tens: int, digits: int) -> None:
    epsilon = fmpq(10) ** -tens
    time = to_fmpq(scaled_time(tau, Fraction(1, 10**tens)))
    first, second = (
        ROUTES[name](time, to_fmpq(b), epsilon, bits_for_digits(digits)) for name in ("integral", "series")
    )
    assert first.is_finite()
    if second.is_finite():
        assert first.overlaps(second)
    else:
        assert tens < 20  # many digits at a not so small epsilon: the series diverges


@pytest.mark.parametrize("n", [0, 1, 2, 3, 4, 7, 20])
@pytest.mark.parametrize("epsilon", [fmpq(50), fmpq(1, 1000)])
def test_polynomials_and_the_integral_agree(n: int, epsilon: fmpq) -> None:
    for time in (fmpq(-7, 2), fmpq(0), fmpq(3)):
        first, second = (ROUTES[name](time, fmpq(n), epsilon, 200) for name in ("polynomial", "integral"))
        assert first.is_finite()
        assert second.is_finite()
        assert first.overlaps(second)


def test_the_route_of_polynomials_knows_nothing_elsewhere() -> None:
    for b in (fmpq(1, 2), fmpq(-1), arb(2), arb(2, 1)):
        assert not ROUTES["polynomial"](fmpq(1), b, fmpq(1), 60).is_finite()


@pytest.mark.parametrize("epsilon", [Fraction(3), Fraction(1, 20), Fraction(1, 300)], ids=str)
@pytest.mark.parametrize("b", [Fraction(1, 2), Fraction(13, 3), Fraction(15, 2)])
def test_it_solves_the_equation_of_fourth_order(b: Fraction, epsilon: Fraction) -> None:
    time, step = Fraction(-2), Fraction(3)
    with mpmath.workdps(80):
        numbers = [mpmath.mpf(v.numerator) / v.denominator for v in (time, b, epsilon, step)]
        start = [_middle(slow_value(to_fmpq(time), to_fmpq(b), to_fmpq(epsilon), k, digits=70).value) for k in range(4)]
        witness = continued(start, numbers[0], numbers[1], numbers[2], numbers[3])
    found = slow_value(to_fmpq(time + step), to_fmpq(b), to_fmpq(epsilon), digits=30).value
    assert contains_witness(found, to_fraction(witness), 25)


def _middle(value: arb) -> mpmath.mpf:
    lower, upper = ends(value)
    middle = (lower + upper) / 2
    return mpmath.mpf(middle.numerator) / middle.denominator


@pytest.mark.parametrize("b", ["-1/3", "1/2", "7/2", "15/2"])
@pytest.mark.parametrize("tau", [-3, 0, 2])
def test_the_limit_is_theta(b: str, tau: int) -> None:
    epsilon = fmpq(10) ** -240
    time = to_fmpq(scaled_time(Fraction(tau), Fraction(1, 10**240)))
    with working_bits(200):
        scaled = slow_value(time, b, epsilon, digits=40).value * scale(epsilon) ** arb(_rational(b))
    difference = abs(scaled - theta(tau, b, digits=40))
    assert difference < fmpq(1, 10**15)


def _rational(text: str) -> fmpq:
    numerator, _, denominator = text.partition("/")
    return fmpq(int(numerator), int(denominator or 1))


def test_the_route_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    """Powers of eta at small epsilon, if they serve; else the integral; a polynomial at an integer b."""
    assert slow_value(0, "1/2", "1e-60").route == "series"
    assert slow_value(0, "1/2", "1").route == "integral"
    assert slow_value(0, 2, "1e-60").route == "polynomial"
    monkeypatch.setitem(ROUTES, "series", lambda *_: arb("nan"))
    found = slow_value(0, "1/2", "1e-60")
    assert (found.route, found.reached) == ("integral", True)


@pytest.mark.parametrize("b", [fmpq(-200), fmpq(200)])
def test_the_largest_parameters_are_within_the_range(b: fmpq) -> None:
    assert slow_value(1, b, 1, digits=3).reached
    with pytest.raises(ValueError, match="b: the library covers"):
        slow_value(1, b * fmpq(201, 200), 1, digits=3)


def test_derivatives_are_shifts() -> None:
    first = slow_value("1/3", "5/2", "1/50", 1, digits=20).value
    with working_bits(100):
        assert first.overlaps(arb(fmpq(-5, 2)) * slow_value("1/3", "3/2", "1/50", digits=20).value)
    assert slow_value(1, 2, "1/50", 3).value == 0


def test_wide_balls_contain_their_points() -> None:
    with working_bits(80):
        epsilon, time, b = arb(fmpq(1, 100), fmpq(1, 10**6)), arb(2, fmpq(1, 10**5)), arb(fmpq(5, 2), fmpq(1, 10**6))
    found = slow_value(time, b, epsilon, digits=10)
    assert found.value.is_finite()
    assert not found.reached
    assert found.reason is not None
    for shift in (-1, 0, 1):
        exact = slow_value(
            2 + fmpq(shift, 2 * 10**5), fmpq(5, 2) + fmpq(shift, 2 * 10**6), fmpq(1, 100) + fmpq(shift, 2 * 10**6)
        )
        assert found.value.overlaps(exact.value)


@pytest.mark.parametrize(
    ("time", "b", "epsilon"),
    [
        ("1e6", "1/2", 1),
        ("1e5", "7/2", "1e-3"),
        ("-5e299", "5/2", "1e-300"),
        (5, "25/2", "1/10"),
        (1, 120, "1e-3"),
        (0, -150, 10),
        (0, "61/10", 10**6),
        ("13/10", "13/10", 10**6),
        (10**5, 13, "206/329"),
        ("-1e300", 200, "1e-298"),
        (10**6, "5/2", 2),
    ],
)
def test_far_out_the_accuracy_is_reached(time: str, b: str, epsilon: str) -> None:
    for digits in (15, 50, 200):
        assert slow_value(time, b, epsilon, digits=digits).reached


def test_arrays() -> None:
    found = slow_solution(np.array([0.0, 0.5]), 2, "1/10")
    assert found.shape == (2,)
    assert holds(found[1], Fraction(1, 4))
    with pytest.raises(ValueError, match="finite"):
        slow_solution(np.array([np.nan]), 2, "1/10")


@pytest.mark.parametrize(
    ("arguments", "options", "error", "message"),
    [
        ((0.5, 1, 1), {}, TypeError, "T: a float"),
        ((0, 1, 0), {}, ValueError, "epsilon: expected"),
        ((0, 1, "-1/10"), {}, ValueError, "epsilon: expected"),
        ((0, 1, fmpq(10) ** -301), {}, ValueError, "epsilon: expected"),
        ((0, 201, 1), {}, ValueError, r"\|b\| <= 200"),
        ((10**9, 1, 1), {}, ValueError, "T: expected"),
        ((10**6 + fmpq(1, 10**100), 1, 2), {}, ValueError, "T: expected"),
        ((-(10**300) - fmpq(1, 10**9), 1, 1), {}, ValueError, "T: expected"),
        ((0, 1, 1), {"digits": 0}, ValueError, "digits"),
        ((0, 1, 1), {"digits": 1001}, ValueError, "digits"),
        ((0, 1, 1), {"derivative": -1}, ValueError, "derivative"),
        ((0, 1, 1), {"derivative": True}, TypeError, "derivative"),
        ((arb.nan(), 1, 1), {}, ValueError, "finite"),
    ],
)
def test_bad_input_is_refused(arguments: tuple, options: dict, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        slow_value(*arguments, **options)
