"""Each bound of an integral along a path is the number that its page states, computed a second time with mpmath, and is
not far above the integral of the modulus; each hypothesis is refused where the page's fails.

Pages: proofs/fast_part.md, proofs/first_integrals.md (section 5), proofs/finite_epsilon_zeros.md (section 5).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from typing import Any

import mpmath
import pytest
from flint import acb, arb, fmpq
from mpmath import mpf
from samples.strategies import ends

from gspot_verified.compliant.fast import fast_path_bound, late_bound
from gspot_verified.compliant.fast.decaying_coefficient import _before, _beyond, _exponent
from gspot_verified.compliant.fast.fast_bound import fast_bound
from gspot_verified.compliant.fast.fast_path_bound import _arc, _ray, _tail, decaying_bounds, oscillating_bounds
from gspot_verified.compliant.fast.fast_solutions import Ray
from gspot_verified.compliant.fast.late_bound import late_bounds
from gspot_verified.compliant.fast.modulus_sum import PathPiece, modulus_sum
from gspot_verified.compliant.model.kernel import kernel
from gspot_verified.compliant.model.normal_form import Deviation
from gspot_verified.compliant.patches import slow_majorant
from gspot_verified.compliant.patches.slow_majorant import ComplexNeighbourhood
from gspot_verified.compliant.slow.slow_solution import slow_value
from gspot_verified.numbers.balls import working_bits

STATE = Deviation(fmpq(5, 2), fmpq(1, 4), fmpq(1, 2), fmpq(1), fmpq(-2), fmpq(3), fmpq(1, 2))


@pytest.fixture(autouse=True)
def _precise() -> Iterator[None]:
    with mpmath.workdps(30), working_bits(120):
        yield


def _m(value: fmpq) -> mpf:
    return mpf(int(value.p)) / int(value.q)


def _number(value: Fraction) -> mpf:
    return mpf(value.numerator) / value.denominator


def _upper(value: arb) -> mpf:
    assert value.is_finite()
    return _number(ends(value)[1])


def _is_the_bound(value: arb, page: mpf, tolerance: str = "1e-12") -> bool:
    return page * (1 - mpf("1e-15")) <= _upper(value) <= page * (1 + mpf(tolerance))


# Section 1 of fast_part.md: both ends of the integral of c_Q.


@pytest.mark.parametrize("beta", [fmpq(5, 2), fmpq(1, 2)])
def test_both_ends_of_the_decaying_coefficient(beta: fmpq) -> None:
    data, height = kernel(replace(STATE, beta=beta)), arb(-2)
    eps, p, power = _m(STATE.epsilon), _m(STATE.p), _m(beta)
    size = sum(abs(_m(value)) for value in (STATE.b, STATE.V, STATE.Y, STATE.force))

    def exponent(x: mpf) -> mpf:
        return (mpmath.log(x - 1) + x * (1 - p + x / 2 - x * x / 3)) / eps + 2

    growth = mpf(5) / 4 * (abs(1 - p) + mpf(5) / 8)
    front = (mpf(5) / 4) ** max(power - 1, 0) * 4 * size
    assert _is_the_bound(_before(data, arb(-2), height), front * mpmath.exp((growth - 2) / eps + 2) * eps)
    assert not _before(data, arb(-1), height).is_finite()  # x > 5/4
    X, n = 1 + mpmath.exp(mpf(1)), 3 + max(power - 1, mpf(0))
    rate = (X**2 - X - 2 - p) / eps - n / X
    assert _is_the_bound(_beyond(data, arb(1), height), size * X**n * mpmath.exp(exponent(X)) / rate)
    true = mpmath.quad(lambda x: size * x**n * mpmath.exp(exponent(x)), [X, X + 1, X + 3, X + 10])
    assert true < _upper(_beyond(data, arb(1), height)) < 2 * true
    assert not _beyond(data, arb(fmpq(1, 10)), height).is_finite()  # X^2 - X - 2 < |p|
    wide = kernel(replace(STATE, beta=beta, epsilon=fmpq(10)))
    assert not _beyond(wide, arb(1), height).is_finite()  # the power still wins


def test_the_exponent_of_the_decaying_coefficient() -> None:
    found = _exponent(kernel(STATE), arb(3), arb(2).log())
    page = (mpmath.log(2) + 3 + mpf(9) / 2 - 9 - mpf(3) / 2) / _m(STATE.epsilon)
    assert _is_the_bound(-found, -page)


# Section 3: sums over boxes.


def _piece(
    length: fmpq, exponent: Callable[[arb], arb], slope: Callable[[arb], arb], bend: arb | None = None
) -> PathPiece:
    return PathPiece(
        arb(length),
        lambda x: acb(exponent(x)),
        lambda x: acb(slope(x)),
        lambda x: [arb(1), 1 + x],
        None if bend is None else lambda _: acb(bend),
    )


def test_a_sum_over_boxes_is_near_the_integral() -> None:
    """int_0^2 e^(-x^2/2 epsilon) (1, 1 + x) dx by the error function; the exponent is 0 at the saddle x = 0."""
    eps = mpf(1) / 10
    gauss = mpmath.sqrt(mpmath.pi * eps / 2) * mpmath.erf(2 / mpmath.sqrt(2 * eps))
    true = [gauss, gauss + eps * (1 - mpmath.exp(-2 / eps))]
    fall = _piece(fmpq(2), lambda x: -x * x / 2, lambda x: -x, arb(-1))
    for bound, value in zip(modulus_sum(fall, arb(0), arb(fmpq(1, 10))), true, strict=True):
        assert value < _upper(bound) < value * mpf("1.03")
    # A curvature that is too flat is a bound as well: only next to the saddle it is taken.
    flat = replace(fall, curvature=lambda _: acb(fmpq(-1, 2)))
    for bound, value in zip(modulus_sum(flat, arb(0), arb(fmpq(1, 10))), true, strict=True):
        assert value < _upper(bound) < value * mpf("1.05")


def test_a_sum_over_boxes_without_its_hypothesis() -> None:
    """Re E <= top must be certain: not at a saddle without its curvature, nor where the path rises above it."""
    quarter = arb(fmpq(1, 4))
    without = _piece(fmpq(2), lambda x: -x * x / 2, lambda x: -x)
    rising = _piece(fmpq(2), lambda x: x - 1, lambda _: arb(1))
    rounded = _piece(fmpq(2), lambda x: -x * x / 2, lambda x: -x, arb(1))
    for piece in (without, rising, rounded):
        assert not any(bound.is_finite() for bound in modulus_sum(piece, arb(0), quarter))
    assert all(bound.is_finite() for bound in modulus_sum(without, quarter, quarter))
    # Where E' is not known the curvature at the saddle is enough, and no better than its own bound.
    unknown = _piece(fmpq(2), lambda x: -x * x / 2, lambda _: arb("nan"), arb(-1))
    known = _piece(fmpq(2), lambda x: -x * x / 2, lambda x: -x, arb(-1))
    for bound, less in zip(*(modulus_sum(piece, arb(0), quarter) for piece in (unknown, known)), strict=True):
        assert _upper(less) <= _upper(bound) < 2 * _upper(less)


# Section 4: the pieces of the path of P_+, and the tails.


def _same(value: acb, other: acb, tolerance: float = 1e-8) -> bool:
    return value.is_finite() and other.is_finite() and bool(abs(value - other) < tolerance)


@pytest.mark.parametrize(
    "made",
    [
        lambda: _arc(arb(fmpq(3, 2)), arb(fmpq(1, 3))),
        lambda: _ray(arb(1), acb(-1, 2), acb(-1, 1), arb(2), arb(fmpq(1, 2)), fmpq(1, 2), saddle_at_start=True),
        lambda: _ray(arb(1), acb(fmpq(1, 3)), acb(1), arb(2), arb(0), fmpq(0), saddle_at_start=True),
    ],
    ids=["circle", "ray", "axis"],
)
def test_slope_and_curvature_of_a_piece_are_derivatives(made: Callable[[], PathPiece]) -> None:
    piece, small = made(), arb((1, -30))
    assert piece.length > 0
    for k in (1, 2, 5):
        x = piece.length * k / 6
        assert _same((piece.exponent(x + small) - piece.exponent(x - small)) / (2 * small), piece.slope(x))
        if piece.curvature is not None:
            assert _same((piece.slope(x + small) - piece.slope(x - small)) / (2 * small), piece.curvature(x))


@pytest.mark.parametrize(("beta", "p"), [(fmpq(3, 2), fmpq(5)), (fmpq(1, 2), fmpq(1, 2))])
def test_the_bounds_of_the_waves_are_near_the_integral_along_the_path(beta: fmpq, p: fmpq) -> None:
    """Pieces one after the other, each with |r|^(-beta-1) |multiplier|, by quadrature."""
    largest, power, m = fmpq(1, 2), _m(beta), _m(p)
    found = oscillating_bounds(arb(beta), p, arb(largest))
    top = next(r for r in mpmath.polyroots([1, 2, m, m], maxsteps=200, extraprec=200) if r.imag > 0)
    turn = top.imag + top.real

    def exponent(r: Any, at: mpf) -> mpf:
        return (r - r**2 / 2 - r**3 / 3 - mpmath.log(1 + r) - at * r).real

    height = exponent(top, m)
    inner = min(turn / 2, mpmath.cbrt(height) if height > 0 else mpf(0), mpf(1) / 2)
    fronts: list[Callable[[Any], mpf]] = [
        lambda r: abs(r) ** (-power - 1),
        lambda r: abs(r) ** -power,
        lambda r: abs(r) ** -power / abs(1 + r),
        lambda r: abs(r) ** (1 - power) * abs(1 + 1 / (1 + r)),
    ]
    rays = [
        (top, mpmath.expjpi(mpf(2) / 3), mpf(8), m),
        (top, mpmath.expjpi(mpf(-1) / 4), -top.real * mpmath.sqrt(2), m),
        (mpmath.mpc(0, turn), mpmath.mpc(0, -1), turn - inner, mpf(0)),
        (mpmath.mpc(inner), mpf(1), mpf(8), mpf(0)),
    ]
    for bound, front in zip(found, fronts, strict=True):
        with mpmath.workdps(12):

            def weight(r: Any, at: mpf, front: Callable[[Any], mpf] = front) -> mpf:
                return front(r) * mpmath.exp((exponent(r, at) - height) / _m(largest))

            true = sum(
                mpmath.quad(lambda x: weight(corner + way * x, at), [0, end / 4, end])  # noqa: B023
                for corner, way, end, at in rays
            )
            true += mpmath.quad(lambda x: inner * weight(inner * mpmath.expjpi(x / 2), 0), [0, 1]) * mpmath.pi / 2
        assert true < _upper(bound) < true * mpf("1.08")


def _tail_of_the_page(corner: Any, way: Any, reach: mpf, p: mpf, height: mpf, largest: mpf) -> mpf:
    """Section 2: 2 (|c| + R) e^((Re E(R) - M)/eps) / (D(R)/eps - 1/R)."""
    size, end = abs(corner), corner + way * reach
    D = reach**2 - (2 * size + 1) * reach - (size**2 + size + 2 + p)
    excess = (end - end**2 / 2 - end**3 / 3 - mpmath.log(abs(1 + end)) - p * end).real - height
    return 2 * (size + reach) * mpmath.exp(excess / largest) / (D / largest - 1 / reach)


def test_the_tail_of_a_ray_is_that_of_the_page() -> None:
    way = mpmath.expjpi(mpf(2) / 3)
    page = _tail_of_the_page(mpmath.mpc(-1, 2) / 2, way, mpf(6), mpf(1) / 2, mpf(1), mpf(1) / 3)

    def tail(reach: fmpq, height: fmpq, largest: fmpq, p: fmpq) -> list[arb]:
        left = acb(arb(fmpq(-1, 2)), arb(3).sqrt() / 2)
        return _tail(acb(fmpq(-1, 2), fmpq(1)), left, arb(reach), arb(p), arb(height), arb(largest))

    for bound in tail(fmpq(6), fmpq(1), fmpq(1, 3), fmpq(1, 2)):
        assert _is_the_bound(bound, page)
    refused = [
        (fmpq(3), fmpq(1), fmpq(1, 3), fmpq(1, 2)),  # R < |c| + 2
        (fmpq(6), fmpq(-1000), fmpq(1, 3), fmpq(1, 2)),  # Re E(R) > M
        (fmpq(6), fmpq(1), fmpq(1000), fmpq(1, 2)),  # the power still wins
        (fmpq(6), fmpq(1), fmpq(1, 3), fmpq(30)),  # D(R) < 0
    ]
    for case in refused:
        assert not any(bound.is_finite() for bound in tail(*case)), case


@pytest.mark.parametrize("decaying", [False, True])
def test_the_tail_of_a_fast_solution_is_that_of_the_page(decaying: bool) -> None:
    """Section 2, with Re d^3 = 1 and 1/2; it is refused where a hypothesis fails."""
    epsilon, p, height, reach = fmpq(1, 3), fmpq(1, 2), fmpq(1), fmpq(12)
    for angle, cube in ((fmpq(2, 3), 1), (fmpq(-1, 9), mpf(1) / 2)):
        corner, way = mpmath.mpc(-1, 2) / 2, mpmath.expjpi(_m(angle))
        size, end = abs(corner), corner + way * 12
        D = cube * 144 - (2 * size + 1) * 12 - (size**2 + size + 2 + mpf(1) / 2)
        value = (end - end**2 / 2 - end**3 / 3 - mpmath.log(abs(1 + end)) - end / 2).real * 3
        page = 2 * (size + 12) * mpmath.exp(value - 1) / (3 * D - mpf(1) / 12)
        ray = Ray(
            arb(1), arb(epsilon), arb(p), acb(fmpq(-1, 2), 1), acb(0, arb.pi() * angle).exp(), arb(height), decaying
        )
        assert _is_the_bound(ray._beyond(arb(reach)), page)
        assert not ray._beyond(arb(fmpq(31, 10))).is_finite()  # R < |c| + 2
        assert not replace(ray, p=arb(200))._beyond(arb(reach)).is_finite()  # D(R) < 0
        assert not replace(ray, epsilon=arb(10**4))._beyond(arb(reach)).is_finite()  # the divisor
        for direction in (acb(1, 0), acb(0, arb.pi() / 3).exp(), acb(0, arb.pi() / 6).exp()):
            assert replace(ray, direction=direction)._beyond(arb(reach)).is_finite() is (direction.real == 1)


def test_both_tails_of_the_waves_and_that_of_the_decaying_solution_are_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without the pieces before them; at an epsilon so large that a tail is no small number."""
    monkeypatch.setattr(fast_path_bound, "modulus_sum", lambda *_: [arb(0)] * 4)
    p, largest = mpf(5), mpf(10)
    roots = mpmath.polyroots([1, 2, p, p], maxsteps=200, extraprec=200)
    top, corner = next(r for r in roots if r.imag > 0), next(r.real for r in roots if r.imag == 0)
    left = mpmath.expjpi(mpf(2) / 3)

    def exponent(r: Any) -> mpf:
        return (r * (1 - p - r / 2 - r**2 / 3) - mpmath.log(abs(1 + r))).real

    height = exponent(top)
    inner = min((top.imag + top.real) / 2, mpmath.cbrt(height), mpf(1) / 2)
    reach = 2 * abs(top) + 4 + mpmath.sqrt(p)
    waves = [
        _tail_of_the_page(top, left, reach, p, height, largest),
        _tail_of_the_page(inner, mpf(1), reach, mpf(0), height, largest),
    ]
    assert min(waves) > max(waves) / 1000
    for bound in oscillating_bounds(arb(1), fmpq(5), arb(10)):
        assert _is_the_bound(bound, sum(waves))
    reach = 2 * abs(corner) + 4 + mpmath.sqrt(p)
    for bound in decaying_bounds(arb(1), fmpq(5), arb(10)):
        assert _is_the_bound(bound, 2 * _tail_of_the_page(corner, left, reach, p, exponent(corner), largest))


# Section 5 of first_integrals.md.


@pytest.mark.parametrize("beta", [fmpq(1, 2), fmpq(5, 2)])
def test_the_bound_of_the_fast_coefficient_is_near_the_integral_of_the_modulus(beta: fmpq) -> None:
    state, largest = replace(STATE, beta=beta), fmpq(1, 4)
    found = fast_bound(state, largest)
    p, eps = _m(state.p), _m(largest)
    b, V, Y, force = (_m(value) for value in (state.b, state.V, state.Y, state.force))
    top = next(r for r in mpmath.polyroots([1, 2, p, p], maxsteps=200, extraprec=200) if r.imag > 0)

    def weight(s: Any) -> mpf:
        modulus = abs(s) ** (_m(beta) - 1) * abs(b + s * V + s * s * (Y - s * force) / (1 + s))
        return modulus * mpmath.exp((mpmath.log(1 + s) + s * (p - 1 + s / 2 + s * s / 3)).real / eps)

    way = mpmath.expjpi(mpf(1) / 3)
    with mpmath.workdps(12):
        true = mpmath.quad(lambda x: abs(1 + top) * weight(-1 + (1 + top) * x), [0, mpf(1) / 2, 1])
        true += mpmath.quad(lambda x: weight(top + way * x), [0, 1, 2, 5])
    true *= _m(beta) / (2 * mpmath.pi)
    assert true < _upper(found.size) < true * mpf("1.1")


# Section 7 of fast_part.md.


@pytest.mark.parametrize("beta", [fmpq(1, 2), fmpq(5, 2)])
@pytest.mark.parametrize("time", [fmpq(0), fmpq(40)])
def test_the_bounds_after_the_g_spot(beta: fmpq, time: fmpq) -> None:
    epsilon = fmpq(1, 100)
    delta = _number(ends(late_bound._radius(epsilon, time))[1])
    eps, T = _m(epsilon), _m(time)
    for found, j, m in zip(late_bounds(beta, epsilon, time), (0, 1, 1, 2), (1, 1, mpf(4) / 3, mpf(7) / 3), strict=True):
        a = j - _m(beta) - 1
        spread = (max(a, mpf(0)) + 1) / 3
        ray = delta ** min(a, mpf(0)) / 3 * (10 * eps / 3) ** spread * mpmath.gamma(spread)
        circle = 2 * mpmath.pi / 3 * delta ** (a + 1) * mpmath.exp(3 * delta**3 / (4 * eps) + delta * T)
        n = max(0, int(mpmath.ceil(-a)))
        slow = slow_value(time, -(j - beta + n), epsilon, digits=12).value
        axis = delta**-n * mpmath.gamma(a + n + 1) * _number(ends(slow)[1])
        assert _is_the_bound(found, m * (ray + circle + axis), "1e-5")


def test_the_bounds_after_the_g_spot_are_refused_without_their_hypotheses() -> None:
    late = (fmpq(5, 2), fmpq(1, 100), fmpq(1), 0, fmpq(1))
    assert late_bound._late(*late, arb(fmpq(1, 4))).is_finite()
    for radius in (fmpq(26, 100), fmpq(0), fmpq(-1, 10)):
        assert not late_bound._late(*late, arb(radius)).is_finite()
    assert not any(bound.is_finite() for bound in late_bounds(fmpq(5, 2), fmpq(1, 100), fmpq(-1, 10**6)))


# Section 5 of finite_epsilon_zeros.md.


def _slow_integral(x: mpf, tau: mpf, eta: mpf, start: mpf | int = 0) -> mpf:
    """int rho^(x - 1) e^(-rho^3/3 + rho tau + h)."""

    def exponent(r: mpf) -> mpf:
        y = eta * r
        cubic = -(r**3) / 3 if eta == 0 else (y - y**2 / 2 - y**3 / 3 - mpmath.log1p(y)) / (2 * eta**3)
        return cubic + r * tau

    with mpmath.workdps(15):
        return mpmath.quad(lambda r: r ** (x - 1) * mpmath.exp(exponent(r)), [start, 1, 2, 4, 8, 20])


@pytest.mark.parametrize("tau", [fmpq(-8), fmpq(2)])
def test_the_integral_over_a_region_covers_both_ends(tau: fmpq) -> None:
    """For tau << 0 it falls with the exponent, for tau > 0 it rises: each end of the region, with its distance."""
    region = ComplexNeighbourhood(fmpq(-1, 2), fmpq(1, 2), fmpq(3, 2), fmpq(1, 5), tau)
    bound = _upper(region.integral(4))
    true = [_slow_integral(mpf(x), _m(tau), mpf(1) / 5) for x in (2, 6)]
    assert max(true) < bound < 3 * max(true)
    assert true[0] / true[1] > 10 or true[1] / true[0] > 10
    assert not region.integral(2).is_finite()
    assert replace(region, distance=fmpq(1, 4)).integral(2).is_finite()


@pytest.mark.parametrize(("lower", "upper"), [(fmpq(1, 4), fmpq(3, 4)), (fmpq(-1, 2), fmpq(-1, 4))])
def test_the_bound_of_the_coefficients_is_that_of_the_page(lower: fmpq, upper: fmpq) -> None:
    """Γ(1+x) c^(k-x) e^(π|y|) U + |rΓ(-z)| c^(k-x-p) I_p, over the region; every factor at its larger end."""
    region = ComplexNeighbourhood(lower, upper, fmpq(1, 4), fmpq(9, 4), fmpq(1, 2))
    c, d = mpf(2) / 5, mpf(1) / 4
    x = [_m(lower) - d, _m(upper) + d]
    X = mpf(9) / 10
    U = mpmath.exp(c**3 / 3 + c / 2 + c**3 / 2 * X / (4 * (1 - X)))
    assert _is_the_bound(slow_majorant._on_circle(region, fmpq(2, 5)), U)
    gamma = max(mpmath.gamma(1 + end) for end in x)
    reciprocal = gamma * mpmath.cosh(mpmath.pi * d) / mpmath.pi
    for k, bound in enumerate(slow_majorant.slow_majorant(region, 4)):
        if k - x[1] >= 2:
            page = reciprocal * _upper(region.integral(k))
        else:
            p = max(2, int(mpmath.ceil(k - x[0])))
            beyond = max(c ** (k - end - p) for end in x) * _upper(
                slow_majorant._bound(region.tau, fmpq(-p), region.eta)
            )
            around = gamma * mpmath.exp(mpmath.pi * d) * U * max(c ** (k - end) for end in x)
            page = around + reciprocal * beyond
        assert _is_the_bound(bound, page / mpmath.factorial(k), "1e-8")


def test_the_coefficients_are_not_bounded_near_the_pole() -> None:
    region = ComplexNeighbourhood(fmpq(-3, 4), fmpq(0), fmpq(1, 8), fmpq(1, 10), fmpq(1))
    assert all(bound.is_finite() for bound in slow_majorant.slow_majorant(region, 3))
    assert all(bound.is_finite() for bound in slow_majorant.epsilon_difference(region, 2, 3))
    for distance in (fmpq(1, 4), fmpq(3, 4)):  # at the pole; beyond it, where Gamma(1 + Re z) is finite once more
        near = replace(region, distance=distance)
        assert not any(bound.is_finite() for bound in slow_majorant.epsilon_difference(near, 2, 3))
        assert not any(bound.is_finite() for bound in slow_majorant.slow_majorant(near, 3))
