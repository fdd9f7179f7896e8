"""c_+ by another contour, with each piece of the path of its own weight; what is accurate, what is refused.

Page: proofs/first_integrals.md, section 4. Both ends of the path: test_bounds_match_their_pages.py, test_sharpness.py.
"""

from __future__ import annotations

from dataclasses import replace

import mpmath
import pytest
from flint import fmpq
from witnesses.theta import contains_witness, to_fraction

from gspot_verified.compliant.fast.fast_coefficient import fast_coefficient
from gspot_verified.compliant.model.normal_form import Deviation

STATE = Deviation(fmpq(5, 2), fmpq(1, 4), fmpq(1, 2), fmpq(1), fmpq(-2, 3), fmpq(3), fmpq(1, 2))


def number(value: fmpq) -> mpmath.mpf:
    return mpmath.mpf(int(value.p)) / int(value.q)


@pytest.mark.parametrize(
    ("beta", "p", "epsilon"),
    [
        (fmpq(1, 2), fmpq(1, 2), fmpq(1, 4)),
        (fmpq(5, 2), fmpq(3), fmpq(2)),
        (fmpq(5, 2), fmpq(1, 20), fmpq(1, 60)),
        (fmpq(13, 2), fmpq(1, 2), fmpq(1, 4)),
    ],
)
def test_by_another_contour(beta: fmpq, p: fmpq, epsilon: fmpq) -> None:
    """From -1 straight to a point above the axis that is not the saddle, on to infinity e^(i pi/4)."""
    state = replace(STATE, beta=beta, p=p, epsilon=epsilon)
    found = fast_coefficient(state, 70)
    with mpmath.workdps(35):
        power, small, place, b, V, Y, force = (
            number(v) for v in (beta, epsilon, p, state.b, state.V, state.Y, state.force)
        )

        def weight(s: mpmath.mpc) -> mpmath.mpc:
            k = b + s * V + s**2 * (Y - s * force) / (1 + s)
            exponent = mpmath.log(1 + s) + s * (place - 1 + s / 2 + s**2 / 3)
            return s ** (power - 1) * mpmath.exp(exponent / small) * k

        corner, way = mpmath.mpc("0.1", 1), mpmath.expjpi(mpmath.mpf(1) / 4)
        ends = [-1, mpmath.mpc(-0.5, 0.4), corner, corner + way, corner + 3 * way, corner + 9 * way]
        value = -power / (2j * mpmath.pi) * mpmath.quad(weight, ends, maxdegree=9)
        parts = [to_fraction(part) for part in (mpmath.re(value), mpmath.im(value))]
    for ball, witness in zip((found.real, found.imag), parts, strict=True):
        assert contains_witness(ball, witness, 14)


@pytest.mark.parametrize("bits", [40, 120])
def test_it_is_as_accurate_as_asked_for_at_small_epsilon(bits: int) -> None:
    found = fast_coefficient(replace(STATE, epsilon=fmpq(1, 500)), bits)
    assert found.real.is_finite()
    assert max(found.real.rel_accuracy_bits(), found.imag.rel_accuracy_bits()) > bits - 16


def test_before_the_g_spot_only() -> None:
    for p in (fmpq(0), fmpq(-1)):
        found = fast_coefficient(replace(STATE, p=p), 30)
        assert not found.real.is_finite()
        assert not found.imag.is_finite()
