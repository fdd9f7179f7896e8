"""Panels around zeros: the error against exact fractions, and where the panels lie.

Page: proofs/float_horner.md, statement F5.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from flint import arb, arb_poly, fmpq
from hypothesis import example, given
from hypothesis import strategies as st

from gspot_verified import theta, theta_of_floats
from gspot_verified.theta_function.arrays import batch
from gspot_verified.theta_function.arrays.float_horner import accepted, float_polynomial, horner, near_bounds
from gspot_verified.theta_function.arrays.kept_panels import ZERO_PANEL, KeptPanels
from gspot_verified.theta_function.arrays.panels import FARTHEST, PER_FINE_CELL

_U, _REACH = Fraction(1, 2**53), Fraction(1025, 1024)
_CENTRE, _INVERSE = 2.9853, float(int(ZERO_PANEL.q))


@given(
    st.floats(-1e-16, 1e-16),
    st.lists(st.floats(-2, 2), min_size=1, max_size=12),
    st.lists(st.floats(-1, 1), min_size=1, max_size=6),
)
@example(0.0, [1.0], [0.0, 2.0**-40])
@example(-1e-17, [1.0], [2.0**-44, 1e-300])
@example(1e-16, [1.0, -1.0] * 6, [1.0, -1.0, 3e-12])
def test_the_value_is_within_a_bound_that_falls_with_the_distance(
    constant: float, others: list[float], places: list[float]
) -> None:
    """The bound is that of the page, a little rounded up, and the exact value lies in it."""
    polynomial = float_polynomial(arb_poly([arb(constant), *map(arb, others), arb(1)]))
    table, index = np.array(polynomial.coefficients)[:, None], np.zeros(len(places), dtype=np.intp)
    points = np.array([_CENTRE + place / _INVERSE for place in places])
    values = np.empty(len(points))
    sizes = horner(points, index, np.array([_CENTRE]), np.array([_INVERSE]), table, values)
    assert accepted(sizes).all()
    bounds = near_bounds(sizes, np.array([polynomial.constant]), np.array([polynomial.slope]))
    own = [Fraction(c) for c in polynomial.coefficients]
    slope = sum((3 * k + 1) * _U * abs(c) * _REACH ** (k - 1) for k, c in enumerate(own) if k)
    for point, value, bound, size in zip(
        points.tolist(), values.tolist(), bounds.tolist(), sizes.tolist(), strict=True
    ):
        s = (Fraction(point) - Fraction(_CENTRE)) * int(_INVERSE)
        exact = sum(c * s**k for k, c in enumerate(own))
        assert abs(exact - Fraction(value)) <= bound
        page = _U * abs(own[0]) + Fraction(size) * slope
        assert page <= bound
        assert bound <= page * (1 + Fraction(1, 2**26)) + Fraction(1, 2**800)


def test_radii_of_the_coefficients_count() -> None:
    """That of the first one everywhere, the others with the distance."""
    exact = float_polynomial(arb_poly([arb(0), arb(1), arb(1)]))
    wide = float_polynomial(arb_poly([arb(0, 1e-20), arb(1, 1e-10), arb(1, 1e-8)]))
    assert wide.constant - exact.constant >= 1e-20
    assert wide.slope - exact.slope >= (1e-10 + 1e-8) * (1 - 1e-5)


def test_zeros_in_the_unit_interval_beside_have_their_panels() -> None:
    """beta = 7/3 has a zero a little below 3, nearer to the first fine panel above 3 than its panel is wide."""
    kept = KeptPanels(fmpq(7, 3), 0)
    above = kept.zero_panel(3, 0)
    below = kept.zero_panel(2, PER_FINE_CELL - 1)
    assert above.centre == below.centre
    assert 2.9 < above.centre < 3
    near = [theta(fmpq(*math.nextafter(above.centre, way).as_integer_ratio()), "7/3", digits=30) for way in (0, 9)]
    assert near[0] * near[1] < 0
    assert abs(above.polynomial.coefficients[0]) < 1e-15
    assert above.polynomial.constant < 1e-30


def test_a_panel_without_a_zero_is_as_correct() -> None:
    kept = KeptPanels(fmpq(7, 3), 0)
    place = (5 + FARTHEST) * PER_FINE_CELL + 3
    around = kept.zero_panels(np.array([place]))
    assert 5 <= around.centres[0] <= 6
    assert kept.zero_panels(np.array([place])) is around
    assert kept.zero_panels(np.array([place + 1])) is not around
    value = theta(fmpq(*around.centres[0].as_integer_ratio()), "7/3", digits=30)
    assert abs(value - arb(around.table[0][0])) <= arb(around.constants[0])


@pytest.mark.parametrize(("beta", "derivative"), [("7/3", 0), ("41/10", 0), ("5/2", 1)])
def test_points_next_to_zeros_need_no_pairs_of_doubles(
    beta: str, derivative: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nor balls; each value is within its radius, 10^-15 of it."""
    left: list[int] = []
    real = batch._in_pairs_of_doubles

    def noted(points: Any, missed: Any, *more: Any) -> Any:
        left.append(len(missed))
        return real(points, missed, *more)

    monkeypatch.setattr(batch, "_in_pairs_of_doubles", noted)
    numbers, parameter = fmpq(*map(int, beta.split("/"))), beta
    kept = batch.kept_panels(int(numbers.p), int(numbers.q), derivative)
    spread = np.linspace(-10, 10, 40_000)
    theta_of_floats(spread, parameter, derivative)
    centres = [one.centre for one in kept._zeros.values()]
    assert centres
    next_to = np.array([c + d for c in centres for e in range(-40, -5) for d in (2.0**e, -(2.0**e))])
    left.clear()
    found = theta_of_floats(np.concatenate([spread, next_to]), parameter, derivative)
    assert left[-1] <= 0.02 * len(next_to)
    assert (found.radius <= 1e-15 * np.abs(found.midpoint)).all()
    for point, middle, radius in list(
        zip(next_to, found.midpoint[-len(next_to) :], found.radius[-len(next_to) :], strict=True)
    )[::7]:
        exact = theta(fmpq(*float(point).as_integer_ratio()), parameter, derivative, digits=40)
        assert abs(exact - arb(float(middle))) <= arb(float(radius))
