"""Each bound is the number that its proof page states, computed a second time from the page with mpmath, and each
hypothesis is refused where the page's fails.

A containment test cannot see a bound that is a little too small while the true error is far smaller.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import product

import mpmath
import pytest
from flint import acb, arb, fmpq
from mpmath import mpf
from samples.strategies import ends, to_fraction

from gspot_verified.compliant.fast.fast_bound import FastBound, _from_minus_one, _to_infinity, fast_bound
from gspot_verified.compliant.fast.fast_coefficient import FastPath, fast_coefficient, saddle
from gspot_verified.compliant.model.kernel import kernel
from gspot_verified.compliant.model.normal_form import Deviation
from gspot_verified.compliant.slow.epsilon_series import epsilon_remainder
from gspot_verified.compliant.slow.grid import _half_phi, _half_phi_at
from gspot_verified.compliant.slow.slow_coefficient import cubic_coefficients, cubic_quotient
from gspot_verified.compliant.slow.slow_integral import TrapezoidPlan, slow_moments, tangent_bound
from gspot_verified.numbers.balls import working_bits

STATE = Deviation(fmpq(5, 2), fmpq(1, 4), fmpq(1, 2), fmpq(1), fmpq(-2), fmpq(3), fmpq(1, 2))


@pytest.fixture(autouse=True)
def _many_digits() -> Iterator[None]:
    with mpmath.workdps(60):
        yield


def _m(value: Fraction | fmpq | int) -> mpf:
    number = to_fraction(value) if isinstance(value, fmpq) else Fraction(value)
    return mpf(number.numerator) / number.denominator


def _ends(value: arb) -> tuple[mpf, mpf]:
    lower, upper = ends(value)
    return _m(lower), _m(upper)


def _radius(value: arb) -> mpf:
    lower, upper = _ends(value)
    return (upper - lower) / 2


def _is_the_bound(value: arb, page: mpf, tolerance: str = "1e-7") -> bool:
    """The upper end is the page's bound: not below it, and above by rounding only (a radius has 30 bits)."""
    upper = _ends(value)[1]
    return page * (1 - mpf("1e-15")) <= upper <= page * (1 + mpf(tolerance))


def _cubic(x: mpf, eta: mpf) -> mpf:
    return (x - x**2 / 2 - x**3 / 3 - mpmath.log1p(x)) / (2 * eta**3)


def _eta(epsilon: fmpq) -> mpf:
    return mpmath.cbrt(_m(epsilon) / 2)


def _slope(rho: mpf, tau: mpf, eta: mpf, c3: mpf) -> mpf:
    x = eta * rho
    return tau - c3 * rho**2 * (x + 2) / (2 * (1 + x))


def _tangents(tau: mpf, b: mpf, eta: mpf, angle: mpf, rising: mpf, falling: mpf) -> mpf:
    """Section 4 of slow_integral.md: e^P (1/s_1 + 1/s_2), P where the tangents meet."""
    c1, c3 = mpmath.cos(angle), mpmath.cos(3 * angle)
    k = [(-b - 1) * mpmath.log(r) + r * tau * c1 + c3 * _cubic(eta * r, eta) for r in (rising, falling)]
    s = [(-b - 1) / r + _slope(r, tau * c1, eta, c3) for r in (rising, falling)]
    meeting = (k[1] - s[1] * falling - k[0] + s[0] * rising) / (s[0] - s[1])
    return mpmath.exp(k[0] + s[0] * (meeting - rising)) * (1 / s[0] - 1 / s[1])


_PLANS = [
    # Most of the radius is, in turn, the left end (E rising; E falling), the right end, the step.
    (fmpq(1), TrapezoidPlan(fmpq(1, 40), -120, 120, fmpq(1, 4), fmpq(1, 4), fmpq(3), 400)),
    (fmpq(-2), TrapezoidPlan(fmpq(1, 40), -120, 120, fmpq(1, 4), fmpq(1, 8), fmpq(3), 400)),
    (fmpq(1, 10), TrapezoidPlan(fmpq(1, 40), -40, 120, fmpq(1, 4), fmpq(1, 8), fmpq(3), 400)),
    (fmpq(1), TrapezoidPlan(fmpq(1, 40), -2000, 50, fmpq(1, 4), fmpq(1, 4), fmpq(3), 400)),
    (fmpq(1), TrapezoidPlan(fmpq(1, 2), -200, 9, fmpq(1, 3), fmpq(1, 4), fmpq(4), 400)),
]


@pytest.mark.parametrize("case", range(len(_PLANS)))
@pytest.mark.parametrize("b", [fmpq(-3, 2), fmpq(-3)])
@pytest.mark.parametrize("epsilon", [fmpq(2), fmpq(1, 1000)])
def test_radius_of_the_trapezoidal_rule(case: int, b: fmpq, epsilon: fmpq) -> None:
    tau, plan = _PLANS[case]
    t, s, eta = _m(tau), _m(plan.step), _eta(epsilon)
    values = slow_moments(arb(tau), b, epsilon, 3, plan)
    for j, value in enumerate(values):
        c = _m(b) - j
        first, last = mpmath.exp(s * plan.first), mpmath.exp(s * plan.last)
        rising = _slope(first, t, eta, mpf(1)) >= 0
        growth = _cubic(eta * first, eta) + first * t if rising else max(mpf(0), first * t)
        left = mpmath.exp(growth - c * s * (plan.first - 1)) / (1 - mpmath.exp(c * s))
        m = c - last * _slope(last, t, eta, mpf(1))
        right = mpmath.exp(_cubic(eta * last, eta) + last * t - c * s * plan.last - m * s) / (1 - mpmath.exp(-m * s))
        shifted = _tangents(t, c, eta, *(_m(v) for v in (plan.angle, plan.rising, plan.falling)))
        disc = 2 * shifted / (mpmath.exp(2 * mpmath.pi * _m(plan.angle) / s) - 1)
        page = s * (left + right) + disc
        assert page * (1 - mpf("1e-15")) <= _radius(value) <= page * (1 + mpf("1e-7"))


def test_the_trapezoidal_rule_is_finite_exactly_where_its_hypotheses_hold() -> None:
    good = TrapezoidPlan(fmpq(1, 20), -200, 60, fmpq(1, 4), fmpq(1, 4), fmpq(3), 200)
    assert slow_moments(arb(1), fmpq(-3, 2), fmpq(1), 1, good)[0].is_finite()
    assert slow_moments(arb(1), fmpq(-1), fmpq(1), 1, good)[0].is_finite()
    bad = [
        replace(good, step=fmpq(0)),
        replace(good, angle=fmpq(0)),
        replace(good, angle=fmpq(-1, 4)),
        replace(good, angle=fmpq(11, 21)),  # just above pi/6
        replace(good, first=60),
        replace(good, last=-20),  # the integrand still rises at the last node
        replace(good, rising=fmpq(3), falling=fmpq(4)),
        replace(good, falling=fmpq(1, 2)),
        replace(good, rising=fmpq(3), falling=fmpq(1, 4)),
        replace(good, rising=fmpq(-1, 4)),
    ]
    for plan in bad:
        assert not slow_moments(arb(1), fmpq(-3, 2), fmpq(1), 1, plan)[0].is_finite(), plan
    assert not slow_moments(arb(1), fmpq(-9, 10), fmpq(1), 1, good)[0].is_finite()
    assert not slow_moments(arb(1), arb(-1, fmpq(1, 100)), fmpq(1), 1, good)[0].is_finite()
    for epsilon in (fmpq(0), fmpq(-1), arb(0, 1)):
        assert not slow_moments(arb(1), fmpq(-3, 2), epsilon, 1, good)[0].is_finite()


def test_the_rest_beyond_the_last_node_wants_a_falling_integrand_not_a_falling_exponential_alone() -> None:
    """rho^14 e^E rises at rho = 2.2, where E already falls: the geometric series would have a ratio above 1."""
    good = TrapezoidPlan(fmpq(1, 20), -200, 60, fmpq(1, 4), fmpq(1, 4), fmpq(6), 200)
    assert slow_moments(arb(1), fmpq(-15), fmpq(1), 1, good)[0].is_finite()
    rho, eta = mpmath.exp(mpf(4) / 5), _eta(fmpq(1))
    assert -15 < rho * _slope(rho, mpf(1), eta, mpf(1)) < 0
    assert not slow_moments(arb(1), fmpq(-15), fmpq(1), 1, replace(good, last=16))[0].is_finite()
    assert slow_moments(arb(1), fmpq(-3, 2), fmpq(1), 1, replace(good, last=16))[0].is_finite()


def test_the_trapezoidal_rule_contains_the_integral() -> None:
    tau, epsilon, b = fmpq(1, 2), fmpq(1, 3), fmpq(-3, 2)
    plan = TrapezoidPlan(fmpq(1, 20), -600, 80, fmpq(1, 4), fmpq(1, 4), fmpq(3), 200)
    eta = _eta(epsilon)
    with mpmath.workdps(30):
        for j, value in enumerate(slow_moments(arb(tau), b, epsilon, 3, plan)):
            power = j - _m(b) - 1
            true = mpmath.quad(
                lambda r, n=power: r**n * mpmath.exp(r / 2 + _cubic(eta * r, eta)), [mpf("1e-20"), 1, 2, 4, 8, 16, 32]
            )
            lower, upper = _ends(value)
            assert lower - mpf("1e-15") < true < upper + mpf("1e-15")
            assert upper - lower < mpf("1e-8")


def test_the_tangent_bound_is_refused_without_its_hypotheses() -> None:
    def bound(b: fmpq, angle: fmpq, rising: fmpq, falling: fmpq) -> arb:
        return tangent_bound(*(arb(v) for v in (fmpq(1), b, fmpq(1, 5), angle, rising, falling)))

    good = (fmpq(-2), fmpq(1, 4), fmpq(1, 2), fmpq(20))
    assert bound(*good).is_finite()
    for k, value in ((0, fmpq(-99, 100)), (0, fmpq(0)), (1, fmpq(53, 100)), (2, fmpq(0)), (2, fmpq(10)), (3, fmpq(1))):
        assert not bound(*good[:k], value, *good[k + 1 :]).is_finite()
    assert bound(fmpq(-1), *good[1:]).is_finite()
    assert not bound(*good[:2], good[3], good[2]).is_finite()
    # tau = -1, so that only cos(3 angle) < 0 speaks against the second angle: there the integral diverges.
    for angle, allowed in ((fmpq(52, 100), True), (fmpq(53, 100), False)):
        value = tangent_bound(*(arb(v) for v in (fmpq(-1), fmpq(-2), fmpq(1, 5), angle, fmpq(1, 2), fmpq(3))))
        assert value.is_finite() is allowed


@pytest.mark.parametrize("angle", [fmpq(0), fmpq(1, 4), fmpq(1, 2)])
@pytest.mark.parametrize("b", [fmpq(-2), fmpq(-15, 2)])
def test_tangent_bound_is_the_one_of_the_page_and_above_the_integral(angle: fmpq, b: fmpq) -> None:
    tau, eta, rising, falling = fmpq(1), fmpq(1, 5), fmpq(1, 2), fmpq(20)
    with working_bits(200):
        value = tangent_bound(*(arb(v) for v in (tau, b, eta, angle, rising, falling)))
    t, power, small, a = (_m(v) for v in (tau, b, eta, angle))
    assert _is_the_bound(value, _tangents(t, power, small, a, _m(rising), _m(falling)))
    c1, c3 = mpmath.cos(a), mpmath.cos(3 * a)
    with mpmath.workdps(20):
        true = mpmath.quad(
            lambda r: r ** (-power - 1) * mpmath.exp(r * t * c1 + c3 * _cubic(small * r, small)),
            [mpf("1e-6"), 1, 2, 4, 8, 16, 32],
        )
    assert true < _ends(value)[0]


@pytest.mark.parametrize("terms", [1, 3, 6])
@pytest.mark.parametrize("b", [fmpq(-1, 2), fmpq(7, 3)])
def test_remainder_of_the_series_in_eta(terms: int, b: fmpq) -> None:
    tau, eta = fmpq(1, 2), fmpq(1, 10)
    places = [(fmpq(1, 2), fmpq(4) + m) for m in range(terms)]
    value = epsilon_remainder(arb(tau), b, arb(eta), terms, [(arb(r), arb(f)) for r, f in places])
    # The coefficients of e^h once more: e^(sum h_j x^j y^(j+3)) by powers of h, in exact fractions.
    coefficients = _exponential(terms)
    total = mpf(0)
    for m, (rising, falling) in enumerate(places, 1):
        bound = _tangents(_m(tau), _m(b) - terms - 3 * m, _m(eta), mpf(0), _m(rising), _m(falling))
        total += abs(_m(coefficients[m])) * bound
    assert _is_the_bound(value, _m(eta) ** terms * abs(mpmath.rgamma(-_m(b))) * total)


def _exponential(order: int) -> dict[int, Fraction]:
    """c_(order, m) as the coefficient of x^order in h^m/m!, h = sum_j h_j x^j."""
    h = [Fraction(0)] + [Fraction((-1) ** (j + 1), 2 * (j + 3)) for j in range(1, order + 1)]
    found, power, factorial = {}, [Fraction(1)] + [Fraction(0)] * order, 1
    for m in range(1, order + 1):
        power = [sum((power[i] * h[k - i] for i in range(k + 1)), Fraction(0)) for k in range(order + 1)]
        factorial *= m
        found[m] = power[order] / factorial
    return found


def test_the_series_in_eta_is_refused_without_its_hypotheses() -> None:
    place = (arb(1), arb(4))
    good = epsilon_remainder(arb(0), fmpq(1, 2), arb(fmpq(1, 10)), 2, [place, place])
    assert good.is_finite()
    for tau, b, eta, terms, places in (
        (arb(0), fmpq(1, 2), arb(0), 2, [place, place]),
        (arb(0), fmpq(1, 2), arb(-1), 2, [place, place]),
        (arb(0), fmpq(1, 2), arb(0, 1), 2, [place, place]),
        (arb(0), fmpq(5), arb(fmpq(1, 10)), 2, [place, place]),
        (arb(0), fmpq(1, 2), arb(fmpq(1, 10)), 2, [place]),
        (arb(0), fmpq(1, 2), arb(fmpq(1, 10)), 2, [place, (arb(4), arb(1))]),
    ):
        assert not epsilon_remainder(tau, b, eta, terms, places).is_finite()


@pytest.mark.parametrize("length", [1, 2, 7])
def test_rest_of_the_series_of_phi(length: int) -> None:
    x = fmpq(1, 20)
    with working_bits(400):
        value = _half_phi_at(arb(x), *_half_phi(length, 400))
    page = _m(x) ** length / (2 * (length + 3))
    assert page * (1 - mpf("1e-15")) <= _radius(value) <= page * (1 + mpf("1e-7"))


@pytest.mark.parametrize("length", [1, 2, 7])
def test_rest_of_the_series_of_the_cubic_quotient(length: int) -> None:
    """|x|^n/((n + 3)(1 - |x|)) in both parts, and none where |x| may reach 1/2."""
    x = fmpq(1, 20)
    with working_bits(400):
        series = cubic_coefficients(length)
        value = cubic_quotient(acb(0, x), series)
        assert not cubic_quotient(acb(0, fmpq(1, 2)), series).real.is_finite()
    page = _m(x) ** length / ((length + 3) * (1 - _m(x)))
    for part in (value.real, value.imag):
        assert page * (1 - mpf("1e-15")) <= _radius(part) <= page * (1 + mpf("1e-7"))


def _path(state: Deviation, bits: int = 20) -> FastPath:
    return FastPath(kernel(state), saddle(state.p), bits)


def test_both_ends_of_the_fast_path_are_those_of_the_page() -> None:
    beta, eps, p = (_m(v) for v in (STATE.beta, STATE.epsilon, STATE.p))
    size = sum(abs(_m(v)) for v in (STATE.b, STATE.V, STATE.Y, STATE.force))
    top = next(r for r in mpmath.polyroots([1, 2, p, p], maxsteps=200, extraprec=200) if r.imag > 0)
    with working_bits(200):
        path = _path(STATE)
        before, beyond, height = path.before(arb(-6)), path.beyond(arb(9)), path.height
    shift = _ends(height)[0]
    growth = mpf(5) / 4 * (abs(p - 1) + mpf(55) / 48) / eps
    page = mpf(5) / 4
    front = page ** max(beta - 1, 0) * (mpf(4) / 3) ** max(1 - beta, 0) * 4 * size * eps
    assert _is_the_bound(before, front * mpmath.exp(growth + (mpmath.log(abs(1 + top)) - 6) / eps - shift))
    s, reach, n = top + mpmath.expjpi(mpf(1) / 3) * 9, mpf(9), 3 + max(beta - 1, mpf(0))
    slope = reach**2 - (2 * abs(top) + 1) * reach - (abs(top) ** 2 + abs(top) + 2 + p)
    exponent = ((mpmath.log(1 + s) + s * (p - 1 + s / 2 + s * s / 3)) / eps).real - shift
    rest = size * (abs(top) + reach) ** n * mpmath.exp(exponent) / (slope / eps - n / reach)
    assert _is_the_bound(beyond, rest)


def test_the_ends_of_the_fast_path_are_refused_without_their_hypotheses() -> None:
    with working_bits(100):
        path = _path(STATE)
        assert path.before(arb(-2)).is_finite()
        assert not path.before(arb(-1)).is_finite()  # |1 + s| > 1/4
        border = (1 / (4 * abs(1 + path.top))).log()
        assert path.before(border - arb((1, -60))).is_finite()
        assert not path.before(border + arb((1, -60))).is_finite()
        assert path.beyond(arb(9)).is_finite()
        for last in (0, 1, 2):
            assert not path.beyond(arb(last)).is_finite()
        slow = replace(STATE, epsilon=fmpq(1000))
        assert not _path(slow).beyond(arb(5)).is_finite()  # the power still wins over the exponential


@pytest.mark.parametrize("beta", [fmpq(1, 2), fmpq(13, 2)])
@pytest.mark.parametrize("p", [fmpq(1, 3), fmpq(1), fmpq(5)])
def test_the_rate_is_above_the_exponent_on_the_whole_path(beta: fmpq, p: fmpq) -> None:
    state = replace(STATE, beta=beta, p=p)
    rate = fast_bound(state, fmpq(1, 50)).rate
    lower = _ends(rate)[0]
    m = _m(p)
    top = next(r for r in mpmath.polyroots([1, 2, m, m], maxsteps=200, extraprec=200) if r.imag > 0)
    places = [-1 + (1 + top) * mpf(k) / 200 for k in range(1, 201)]
    places += [top + mpmath.expjpi(mpf(1) / 3) * mpf(k) / 20 for k in range(200)]
    highest = max((mpmath.log(1 + s) + s * (m - 1 + s / 2 + s * s / 3)).real for s in places)
    assert highest <= lower < highest + mpf("0.02")


@pytest.mark.parametrize("p", [fmpq(1, 3), fmpq(50)])
def test_the_rate_of_each_box_is_above_the_exponent_at_its_ends(p: fmpq) -> None:
    """Both pieces in 400 boxes, the finer the nearer to the saddle; for p = 50 most of |P(s)| is p |1 + s|."""
    m = _m(p)
    top = next(r for r in mpmath.polyroots([1, 2, m, m], maxsteps=200, extraprec=200) if r.imag > 0)
    with working_bits(64):
        path = _path(replace(STATE, p=p, epsilon=fmpq(1, 50)), 64)
        first, last = path.first(), path.last()
        pieces = [
            (list(_from_minus_one(path.data, path.top, first)), first, lambda u: (1 + top) * mpmath.exp(u) - 1),
            (list(_to_infinity(path.data, path.top, last)), last, lambda x: top + mpmath.expjpi(mpf(1) / 3) * x),
        ]
    for boxes, far, place in pieces:
        places = [place(_ends(far)[0] * mpf(k) ** 2 / 400**2) for k in range(401)]
        values = [(mpmath.log(1 + s) + s * (m - 1 + s / 2 + s * s / 3)).real for s in places]
        assert len(boxes) == 400
        for box, *both in zip(boxes, values, values[1:], strict=False):
            assert max(both) <= _ends(box.rate)[0] <= max(both) + 2 * abs(both[0] - both[1]) + mpf("2e-6")


def test_the_fast_bound_is_refused_without_its_hypotheses(monkeypatch: pytest.MonkeyPatch) -> None:
    assert fast_bound(STATE, fmpq(1, 50)).size.is_finite()
    for state, largest in product((STATE, replace(STATE, p=fmpq(0)), replace(STATE, p=fmpq(-1))), (1, 0, -1)):
        allowed = state.p > 0 and largest > 0
        assert fast_bound(state, fmpq(largest)).size.is_finite() is allowed
    bound = FastBound(fmpq(1, 50), arb(1), arb(-1))
    assert bound.at(fmpq(1, 50)).is_finite()
    for epsilon in (fmpq(1, 49), fmpq(0), fmpq(-1)):
        assert not bound.at(epsilon).is_finite()
    # The boxes begin where |1 + s| <= 1/4, but the bound of Re E before them is still above Re E on the boxes.
    monkeypatch.setattr(FastPath, "first", lambda self: arb(fmpq(-3, 2)) - (1 + self.top).log().real)
    with working_bits(64):
        path = _path(replace(STATE, epsilon=fmpq(1, 50)))
        assert path.before(path.first()).is_finite()
    assert not fast_bound(STATE, fmpq(1, 50)).size.is_finite()


def test_the_fast_coefficient_wants_p_positive() -> None:
    for p in (fmpq(0), fmpq(-1)):
        assert not fast_coefficient(replace(STATE, p=p), 30).is_finite()
