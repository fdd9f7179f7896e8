"""The Taylor series at any centre.

Page: proofs/local_series.md.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, arb_poly, fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import holds, small_heights, to_fmpq, to_fraction

from gspot_verified import evaluate
from gspot_verified.numbers.balls import relative_bits, working_bits
from gspot_verified.theta_function.sums.local_series import REACH, LocalSeries, local_series, part_of_polynomial
from gspot_verified.theta_function.value.integer import polynomial_value


def _series(centre: fmpq, half_width: fmpq, beta: fmpq, length: int, bits: int = 200) -> LocalSeries:
    values = [evaluate(centre, beta, k, 60).value for k in range(3)]
    return local_series((values[0], values[1], values[2]), centre, half_width, beta, length, bits)


_CENTRES = st.builds(fmpq, st.integers(-80, 80), st.just(4))
_WIDTHS = st.sampled_from([fmpq(1, 8), fmpq(1, 2), fmpq(1)])
_PLACES = st.fractions(-1, 1, max_denominator=60).map(to_fmpq)


@given(_CENTRES, _WIDTHS, small_heights(), st.integers(3, 60), st.one_of(_PLACES, st.sampled_from([REACH, -REACH])))
def test_the_series_and_its_derivatives_contain_the_values(
    centre: fmpq, width: fmpq, beta: Fraction, length: int, s: fmpq
) -> None:
    b = to_fmpq(beta)
    series = _series(centre, width, b, length)
    tau = centre + width * s
    found = series.values_at(tau)
    if not series.ratio.is_finite():
        assert not any(value.is_finite() for value in found)
        return
    with working_bits(200):
        assert series.polynomial(arb(s)).overlaps(found[0])
    for k, value in enumerate(found):
        exact = evaluate(tau, b, k, 50).value
        assert value.is_finite()
        assert value.overlaps(exact)
        assert length < 50 or relative_bits(exact) < 100 or value.rad() < abs(series.polynomial[0]) * fmpq(1, 10**8)


@given(st.integers(0, 9), _CENTRES, _WIDTHS, _PLACES, st.integers(3, 12))
def test_polynomials_come_exactly(n: int, centre: fmpq, width: fmpq, s: fmpq, length: int) -> None:
    """What is cut off is known exactly here: every bound must hold it."""
    series = _series(centre, width, fmpq(n), length)
    if not series.ratio.is_finite():
        return
    tau = centre + width * s
    for k, value in enumerate(series.values_at(tau)):
        factor = fmpq(1)
        for j in range(k):
            factor *= j - n
        exact = factor * polynomial_value(tau, n - k) if n >= k else fmpq(0)
        assert holds(value, to_fraction(exact))


def test_the_bounds_are_those_of_the_page() -> None:
    """A second computation of m, q and the three rests, in fractions."""
    centre, width, beta, length = fmpq(7), fmpq(1, 2), fmpq(7, 3), 9
    series = _series(centre, width, beta, length)
    more = _series(centre, width, beta, length + 3)
    h = REACH * width
    q = (abs(centre) * h**2 + (1 + abs(beta) / length) * h**3) / ((length + 2) * (length + 3))
    with working_bits(200):
        m = max(float(abs(more.polynomial[k])) for k in range(length, length + 3)) * float(to_fraction(REACH)) ** (
            length + 2
        )
        q_float, last = float(to_fraction(q)), length + 2
        rest = 3 * m / (1 - q_float)
        assert abs(float(series.ratio) / q_float - 1) < 1e-12
        assert abs(float(series.largest) / m - 1) < 1e-9
        assert abs(float(series.polynomial[0].rad()) / rest - 1) < 1e-6
        first, second = (float(bound) for bound in series._rests())
        left = q_float / (1 - q_float)
        assert abs(first / (rest * (last + 3 * left)) - 1) < 1e-9
        page = last**2 + 6 * last * left + 9 * q_float * (1 + q_float) / (1 - q_float) ** 2
        assert abs(second / (rest * page) - 1) < 1e-9


@pytest.mark.parametrize(
    ("centre", "width", "length"), [(50, fmpq(4), 20), (0, fmpq(9), 12), (-50, fmpq(4), 20), (1, fmpq(1, 2), 2)]
)
def test_too_short_or_too_wide_is_not_finite(centre: int, width: fmpq, length: int) -> None:
    one = arb(1)
    series = local_series((one, one, one), fmpq(centre), width, fmpq(1, 2), length, 100)
    assert not series.polynomial(arb(0)).is_finite()


def test_outside_the_panel_nothing_is_said() -> None:
    series = _series(fmpq(1), fmpq(1, 2), fmpq(1, 2), 20)
    assert series.values_at(1 + REACH / 2)[0].is_finite()
    assert not any(value.is_finite() for value in series.values_at(1 + REACH / 2 + fmpq(1, 10**9)))
    assert isinstance(series.polynomial, arb_poly)


@given(
    st.lists(st.fractions(-9, 9, max_denominator=99), min_size=1, max_size=12),
    st.integers(1, 32),
    st.data(),
    st.integers(1, 14),
    st.one_of(_PLACES, st.sampled_from([REACH, -REACH])),
)
def test_a_part_contains_the_polynomial(
    coefficients: list[Fraction], pieces: int, data: st.DataObject, length: int, t: fmpq
) -> None:
    number = data.draw(st.integers(0, pieces - 1))
    s = (2 * number + 1 - pieces + t) / pieces
    assert abs(s) <= REACH
    with working_bits(120):
        part = part_of_polynomial(arb_poly([to_fmpq(a) for a in coefficients]), number, pieces, length, 120)
        value = part(arb(t))
    assert len(part) <= length
    assert holds(value, sum((a * to_fraction(s) ** k for k, a in enumerate(coefficients)), Fraction(0)))
    assert length < len(coefficients) or value.rad() < fmpq(1, 10**25)


@pytest.mark.parametrize(("number", "pieces", "length"), [(-1, 2, 3), (2, 2, 3), (0, 0, 3), (0, 1, 0)])
def test_there_is_no_such_part(number: int, pieces: int, length: int) -> None:
    with pytest.raises(ValueError, match="number: expected"):
        part_of_polynomial(arb_poly([1, 2]), number, pieces, length, 64)
