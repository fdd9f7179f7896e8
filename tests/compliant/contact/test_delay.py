"""How much earlier the slow manifold lifts off: the numbers of the page, and each hypothesis by itself.

Page: proofs/monotone.md, sections 8 and 9.
"""

from __future__ import annotations

import mpmath
import pytest
from flint import arb, fmpq
from samples.strategies import ends

from gspot_verified.compliant.contact.delay import lead, uniform_constant
from gspot_verified.compliant.slow.profile import Profile

ETA = fmpq(1, 20)


def _number(value: arb) -> mpmath.mpf:
    assert value.is_finite()
    top = ends(value)[1]
    return mpmath.mpf(top.numerator) / top.denominator


def derivative(beta: fmpq, root: fmpq, tau: fmpq, order: int) -> mpmath.mpf:
    return _number(Profile.at_root(beta, root).derivatives(tau, range(order, order + 1), 20)[0])


@pytest.mark.parametrize("beta", [fmpq(3, 2), fmpq(7, 2), fmpq(9, 2)])
def test_the_lead_is_that_of_the_page(beta: fmpq) -> None:
    """(eta/8) f^(4)(y; eta)/f_0'(x)."""
    x, y = fmpq(4), fmpq(5)
    found = lead(Profile.at_root(beta, ETA), x, y)
    assert found is not None
    with mpmath.workdps(25):
        page = mpmath.mpf(1) / 160 * derivative(beta, ETA, y, 4) / derivative(beta, fmpq(0), x, 1)
        assert page * (1 - mpmath.mpf("1e-13")) <= _number(found) <= page * (1 + mpmath.mpf("1e-10"))


def test_the_lead_is_refused_without_its_hypotheses() -> None:
    """1 < beta < 5, and f_0' positive and increasing: at 7/2 f_0' < 0 for tau near 1, f_0'' < 0 near -3."""
    assert lead(Profile.at_root(fmpq(21, 4), ETA), fmpq(8), fmpq(9)) is None
    assert lead(Profile.at_root(fmpq(1, 2), ETA), fmpq(8), fmpq(9)) is None
    wave = Profile.at_root(fmpq(7, 2), ETA)
    assert lead(wave, fmpq(1), fmpq(5)) is None
    assert lead(wave, fmpq(-3), fmpq(5)) is None
    assert Profile.leading_order(fmpq(7, 2)).derivatives(fmpq(-3), range(1, 2), 10)[0] > 0
    # For 1 < beta < 2, n = 1: the second derivative is asked for as well.
    assert lead(Profile.at_root(fmpq(3, 2), ETA), fmpq(-20), fmpq(5)) is not None


@pytest.mark.parametrize(("beta", "asked"), [(fmpq(3, 2), 2), (fmpq(7, 2), 3), (fmpq(9, 2), 4)])
def test_the_lead_asks_for_every_derivative(monkeypatch: pytest.MonkeyPatch, beta: fmpq, asked: int) -> None:
    """f_0^(k)(x) > 0 for 1 <= k <= max(n, 2), each of them."""
    profile = Profile.at_root(beta, ETA)

    class Leading:
        negative = 0

        def derivatives(self, _: fmpq, orders: range, __: int) -> list[arb]:
            return [arb(-1 if k == self.negative else 1) for k in orders]

    leading = Leading()
    monkeypatch.setattr(Profile, "leading_order", lambda _: leading)
    for leading.negative in range(1, asked + 2):
        assert (lead(profile, fmpq(4), fmpq(5)) is None) is (leading.negative <= asked)


@pytest.mark.parametrize("beta", [fmpq(3, 2), fmpq(7, 2)])
def test_the_constant_for_all_smaller_epsilon(beta: fmpq) -> None:
    """e^S (1 + max(0, 1 - b) x^(-3/2)), S = (eta/8) m(y_2, eta)^4."""
    x, first, second = fmpq(5), fmpq(6), fmpq(7)
    found = uniform_constant(Profile.at_root(beta, ETA), x, (first, second))
    assert found is not None
    with mpmath.workdps(25):
        b, eta, tau = mpmath.mpf(int(beta.p)) / int(beta.q) - 1, mpmath.mpf(1) / 20, mpmath.mpf(7)
        m = eta * tau / 2 + mpmath.sqrt((eta * tau) ** 2 / 4 + tau + eta * (6 - b) + (5 - b) / mpmath.sqrt(tau))
        page = mpmath.exp(eta / 8 * m**4) * (1 + max(mpmath.mpf(0), 1 - b) * mpmath.mpf(5) ** mpmath.mpf(-1.5))
        assert page * (1 - mpmath.mpf("1e-15")) <= _number(found[0]) <= page * (1 + mpmath.mpf("1e-12"))
        # The mean of rho^4, by quadrature: the statement about m at eta and tau.
        weight = lambda r, k: r ** (3 - b + k) * mpmath.exp(_exponent(r, tau, eta))  # noqa: E731
        mean = mpmath.quad(lambda r: weight(r, 4), [0, 2, 4, 8]) / mpmath.quad(lambda r: weight(r, 0), [0, 2, 4, 8])
        assert mean <= m**4


def _exponent(r: mpmath.mpf, tau: mpmath.mpf, eta: mpmath.mpf) -> mpmath.mpf:
    x = eta * r
    return (x - x**2 / 2 - x**3 / 3 - mpmath.log1p(x)) / (2 * eta**3) + r * tau


@pytest.mark.parametrize(
    ("beta", "x", "leading"),
    [
        (fmpq(5), fmpq(5), (fmpq(6), fmpq(7))),  # b < 4
        (fmpq(1), fmpq(5), (fmpq(6), fmpq(7))),  # b > 0
        (fmpq(3, 2), fmpq(1), (fmpq(6), fmpq(7))),  # x > 1
        (fmpq(3, 2), fmpq(5), (fmpq(49, 10), fmpq(7))),  # x <= y_1
        (fmpq(3, 2), fmpq(11, 10), (fmpq(6), fmpq(7))),  # 2 x^(3/2) >= 5 - b
        (fmpq(7, 2), fmpq(11, 5), (fmpq(6), fmpq(7))),  # f_0(x) > 0
        (fmpq(7, 2), fmpq(5, 2), (fmpq(6), fmpq(7))),  # f_0'' <= sqrt(x) f_0'
        (fmpq(9, 2), fmpq(5), (fmpq(5), fmpq(7))),  # y_1 f_0' > 4 b f_0
        (fmpq(9, 2), fmpq(5), (fmpq(5), fmpq(9))),  # which y_2 fulfils: 4 b f_0/f_0' is 8.03 at y_1
    ],
)
def test_each_hypothesis_of_the_constant(beta: fmpq, x: fmpq, leading: tuple[fmpq, fmpq]) -> None:
    if beta.q == 1:
        assert uniform_constant(Profile(beta, 2 * ETA**3, ETA), x, leading) is None
    else:
        assert uniform_constant(Profile.at_root(beta, ETA), x, leading) is None
