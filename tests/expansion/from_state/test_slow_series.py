"""The slow part of the deviation (proofs/from_state.md, section 2), by routes that share no polynomial."""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import to_fmpq, to_fraction
from witnesses.slow_deviation import Dual, at, rates

from gspot_verified.expansion.from_state.slow_series import Contact, H, R, slow_series
from gspot_verified.expansion.series.regularisation import PAPER, Regularisation

NUMBERS = st.fractions(min_value=Fraction(1, 4), max_value=4, max_denominator=12)


@given(
    beta=st.fractions(min_value=Fraction(11, 10), max_value=5, max_denominator=12),
    springs=st.tuples(NUMBERS, NUMBERS, NUMBERS),
    order=st.integers(1, 4),
    h=NUMBERS,
    r=NUMBERS,
)
@settings(max_examples=40, deadline=None)
def test_what_the_polynomials_leave_in_the_equations(
    beta: Fraction, springs: tuple[Fraction, Fraction, Fraction], order: int, h: Fraction, r: Fraction
) -> None:
    """The equations (2) for V = L v, W = L p w, phi = L p f, by dual numbers in exact fractions."""
    contact = Regularisation.of(*springs)
    series = slow_series(to_fmpq(beta), Contact.of(contact), order)
    p, e = r * r, h * r**3
    root = Dual(r, -e / (2 * r))  # d/dT
    ratio = Dual(e) / root**3
    v, w, f = (at(one, ratio, root) for one in (series.v, series.w, series.f))
    L = Dual(Fraction(1), -(e / p) * ((beta - 1) + beta * w.value))
    V, W, phi = L * v, L * root**2 * w, L * root**2 * f
    right = rates(beta, springs, e, p, (L.value, V.value, W.value, phi.value))
    left = (L.slope, V.slope, W.slope, phi.slope)
    assert right[0] == left[0]
    scales = (r, 1, r)
    for k in range(3):
        found = at(series.residual[k], ratio, root).value
        assert found * e == scales[k] * (right[k + 1] - left[k + 1])


@pytest.mark.parametrize("beta", [fmpq(3, 2), fmpq(7, 3), fmpq(9, 2)])
def test_the_residual_has_the_order_that_was_asked(beta: fmpq) -> None:
    for order in (1, 3, 5):
        residual = slow_series(beta, Contact.of(PAPER), order).residual
        assert min(int(i) for one in residual for i, _ in one.to_dict()) == order


def theta_series(beta: Fraction, length: int) -> list[Fraction]:
    """c_k of x^beta sum c_k x^(-3k), x = -tau: -theta_xxx = x theta_x - beta theta.

    The power x^(beta - 3k) gives -3k c_k = -(q+3)(q+2)(q+1) c_(k-1) with q = beta - 3k.
    """
    found = [Fraction(1)]
    for k in range(1, length):
        q = beta - 3 * k
        found.append((q + 3) * (q + 2) * (q + 1) * found[-1] / (3 * k))
    return found


@pytest.mark.parametrize("beta", [Fraction(3, 2), Fraction(7, 3), Fraction(9, 2)])
def test_at_r_zero_it_is_the_series_of_theta(beta: Fraction) -> None:
    """1 + w = tau theta'/(beta theta), h^2 = kappa/x^3: both as series in 1/x^3."""
    length, kappa = 4, Fraction(1, 2)
    c = theta_series(beta, length)
    slopes = [value * (beta - 3 * k) / beta for k, value in enumerate(c)]
    quotient: list[Fraction] = []
    for k in range(length):
        quotient.append(slopes[k] - sum((quotient[j] * c[k - j] for j in range(k)), Fraction(0)))
    w = slow_series(to_fmpq(beta), Contact.of(PAPER), 2 * length - 1).w
    found = {int(i): to_fraction(value) for (i, n), value in w.to_dict().items() if n == 0}
    assert found == {2 * k: value / kappa**k for k, value in enumerate(quotient) if k and value}


def test_what_is_no_contact_or_no_order() -> None:
    with pytest.raises(ValueError, match="no damper"):
        Contact.of(Regularisation.of(1, 1, 0))
    with pytest.raises(ValueError, match="order"):
        slow_series(fmpq(3, 2), Contact.of(PAPER), 0)


@pytest.mark.parametrize("beta", [fmpq(3, 2), fmpq(7, 3)])
def test_what_the_fast_part_feeds_back(beta: fmpq) -> None:
    """(4): x_2 enters x_1, x_2, x_3 by r + beta h v, h r (beta - 1 + beta w), (l/g) r + beta h r^2 f; p' = -h r p."""
    series = slow_series(beta, Contact.of(PAPER), 3)
    first, second, third = series.coupling
    assert H * R * first == beta * H * series.v
    assert second - beta * series.w == beta - 1
    assert H * R * third == beta * H * R**2 * series.f
    assert series.w != 0 != series.f
    assert series.level_fall == 1
