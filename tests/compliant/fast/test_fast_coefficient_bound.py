"""The bounds of c_+ and c_Q for every smaller epsilon: both ends of the path are the numbers of proofs/fast_part.md,
section 6, computed a second time; what lies between is the integrand; and the sums are above the true integrals.

The ends are a trillionth of the whole where they are used: a containment test cannot see them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from typing import Any

import mpmath
import pytest
from flint import acb, arb, fmpq
from mpmath import mpc, mpf
from samples.strategies import ends, to_fraction

from gspot_verified.compliant.fast import fast_coefficient_bound as module
from gspot_verified.compliant.fast.decaying_coefficient import decaying_coefficient, real_saddle
from gspot_verified.compliant.fast.fast_coefficient import fast_coefficient, saddle
from gspot_verified.compliant.fast.fast_coefficient_bound import (
    Weight,
    decaying_coefficient_bound,
    oscillating_coefficient_bound,
    state_weight,
    unit_weight,
)
from gspot_verified.compliant.fast.modulus_sum import PathPiece
from gspot_verified.compliant.model.kernel import kernel
from gspot_verified.compliant.model.normal_form import Deviation
from gspot_verified.numbers.balls import working_bits

STATE = Deviation(fmpq(5, 2), fmpq(1, 4), fmpq(1, 2), fmpq(1), fmpq(-2), fmpq(3), fmpq(1, 2))
SIZE = mpf(1) + 2 + 3 + mpf(5) / 2  # |b| + |V| + |Y| + |Z - Y|
POWERS = [fmpq(3, 2), fmpq(0), fmpq(-1, 2), fmpq(7)]


@pytest.fixture(autouse=True)
def _many_digits() -> Iterator[None]:
    with mpmath.workdps(50):
        yield


def m(value: fmpq | Fraction) -> mpf:
    number = to_fraction(value) if isinstance(value, fmpq) else value
    return mpf(number.numerator) / number.denominator


def upper(value: arb) -> mpf:
    assert value.is_finite()
    return m(ends(value)[1])


def is_the_bound(value: arb, page: mpf) -> bool:
    return bool(page * (1 - mpf("1e-15")) <= upper(value) <= page * (1 + mpf("1e-7")))


def weight(power: fmpq) -> Weight:
    return replace(state_weight(kernel(STATE)), power=arb(power))


def energy(s: mpc, p: fmpq) -> mpf:
    """Re E, E = -psi(s) + p s."""
    return mpmath.log(abs(1 + s)) + (s * (m(p) - 1 + s / 2 + s * s / 3)).real


def page_before(power: fmpq, radius: mpf, p: fmpq, height: mpf, largest: mpf) -> mpf:
    """Towards -1, |1 + s| <= radius <= 1/4."""
    growth = mpf(5) / 4 * (abs(m(p) - 1) + mpf(55) / 48) + mpmath.log(radius)
    front = (mpf(5) / 4) ** max(m(power), 0) * (mpf(4) / 3) ** max(-m(power), 0)
    return 2 * SIZE * front * largest * mpmath.exp((growth - height) / largest)


def page_beyond(power: fmpq, c: mpc, direction: mpc, reach: mpf, p: fmpq, height: mpf, largest: mpf) -> mpf:
    n, size = 3 + max(m(power), 0), abs(c)
    slope = reach**2 - (2 * size + 1) * reach - (size**2 + size + 2 + abs(m(p)))
    excess = energy(c + direction * reach, p) - height
    return SIZE * (size + reach) ** n * mpmath.exp(excess / largest) / (slope / largest - n / reach)


def ball(value: mpf) -> arb:
    """The number itself; it has few bits here."""
    number = Fraction(*map(int, mpmath.libmp.to_rational(value._mpf_)))
    found = arb(fmpq(number.numerator, number.denominator))
    assert found.is_exact()
    return found


@pytest.mark.parametrize("power", POWERS)
@pytest.mark.parametrize("p", [fmpq(1, 2), fmpq(3)])
def test_the_end_towards_minus_one(power: fmpq, p: fmpq) -> None:
    with working_bits(200):
        start, depth, height, largest = acb(fmpq(3, 8), fmpq(1, 2)), arb(2), arb(fmpq(3, 2)), arb(fmpq(1, 8))
        found = module._before(weight(power), start, arb(p), depth, height, largest)
    page = page_before(power, mpf(5) / 8 * mpmath.exp(-2), p, mpf(3) / 2, mpf(1) / 8)
    assert is_the_bound(found, page)


def test_the_end_towards_minus_one_has_its_hypotheses() -> None:
    def finite(radius: fmpq, height: arb) -> bool:
        value = module._before(weight(fmpq(1)), acb(radius), arb(1), arb(0), height, arb(1))
        return bool(value.is_finite())

    tiny = fmpq(1, 2**40)
    with working_bits(200):
        assert finite(fmpq(1, 4), arb(9))
        assert not finite(fmpq(1, 4) + tiny, arb(9))
        edge = arb(fmpq(275, 192)) - arb(4).log()  # the largest Re E on |1 + s| <= 1/4
        assert finite(fmpq(1, 4), edge + tiny)
        assert not finite(fmpq(1, 4), edge - tiny)


@pytest.mark.parametrize("power", POWERS)
@pytest.mark.parametrize("p", [fmpq(1, 2), fmpq(-3)])
def test_the_end_towards_infinity(power: fmpq, p: fmpq) -> None:
    with working_bits(200):
        direction = acb(arb(fmpq(1, 2)), arb(3).sqrt() / 2)
        found = module._beyond(
            weight(power), acb(fmpq(-1, 4), fmpq(1, 2)), direction, arb(8), p, arb(-1), arb(fmpq(1, 4))
        )
    turn = mpmath.expjpi(mpf(1) / 3)
    assert is_the_bound(found, page_beyond(power, mpc(-0.25, 0.5), turn, mpf(8), p, mpf(-1), mpf(1) / 4))


def test_the_end_towards_infinity_has_its_hypotheses() -> None:
    """D > 0, D/epsilon > n/R, |1 + s| >= 1, |s| >= 1, and Re E <= M."""

    def finite(corner: acb, reach: fmpq, p: fmpq, height: arb, largest: fmpq, power: int = 1) -> bool:
        value = module._beyond(weight(fmpq(power)), corner, acb(-1), arb(reach), p, height, arb(largest))
        return bool(value.is_finite())

    tiny, high, one = fmpq(1, 2**40), arb(10**4), acb(-1)
    with working_bits(200):
        # D = R^2 - 3 R - 4 - |p|: 6 at R = 5, p = 0
        assert finite(one, fmpq(5), fmpq(6) - tiny, high, fmpq(1, 10**20))
        assert not finite(one, fmpq(5), fmpq(6) + tiny, high, fmpq(1, 10**20))
        assert not finite(one, fmpq(5), fmpq(-6) - tiny, high, fmpq(1, 10**20))
        assert finite(one, fmpq(5), fmpq(0), high, fmpq(30, 4) - tiny)  # n = 4
        assert not finite(one, fmpq(5), fmpq(0), high, fmpq(30, 4) + tiny)
        assert finite(one, fmpq(5), fmpq(0), high, fmpq(30, 3) - tiny, -9)
        assert not finite(one, fmpq(5), fmpq(0), high, fmpq(30, 3) + tiny, -9)
        edge = arb(5).log() - 6 * (fmpq(-1) - 3 + 12)  # Re E at s = -6
        assert finite(one, fmpq(5), fmpq(0), edge + tiny, fmpq(1))
        assert not finite(one, fmpq(5), fmpq(0), edge - tiny, fmpq(1))


def sums(
    monkeypatch: pytest.MonkeyPatch, call: Callable[[], arb], depth: int, without: str
) -> tuple[arb, list[tuple[PathPiece, arb]]]:
    """What is left when the boxes and one of the ends give nothing, and the pieces that the boxes were laid on."""
    seen: list[tuple[PathPiece, arb]] = []

    def nothing(piece: PathPiece, height: arb, _: arb) -> list[arb]:
        seen.append((piece, height))
        return [arb(0)]

    with monkeypatch.context() as patch:
        patch.setattr(module, "modulus_sum", nothing)
        patch.setattr(module, "_depth", lambda _: arb(depth))
        patch.setattr(module, without, lambda *_: arb(0))
        return call(), seen


def top_of(p: fmpq) -> mpc:
    roots = mpmath.polyroots([1, 2, m(p), m(p)], maxsteps=200, extraprec=200)
    return next(r for r in roots if r.imag > mpf("1e-20"))


def check_piece(piece: PathPiece, place: Callable[[mpf], mpc], p: fmpq, power: fmpq, length: mpf) -> None:
    """E, E', E'' and the front at two points, by mpmath's derivatives of the page's formulas."""
    assert abs(upper(piece.length) - length) < mpf("1e-12")
    assert piece.curvature is not None

    def exponent(x: mpf) -> mpc:
        s = place(x)
        return s * (m(p) - 1 + s / 2 + s * s / 3) + mpmath.log(abs(1 + s))

    b, V, Y, Z = (m(getattr(STATE, name)) for name in "bVYZ")
    for x in (mpf(0), mpf(1) / 2, length / 2):
        s = place(x)
        k = b + s * V + s * s * (Y - s * (Z - Y)) / (1 + s)
        front = abs(s) ** m(power) * abs(k) * abs(mpmath.diff(place, x))
        found = [piece.exponent(ball(x)).real, piece.slope(ball(x)).real, piece.curvature(ball(x)).real]
        pages = [mpmath.diff(lambda y: exponent(y).real, x, n) for n in range(3)]
        for value, page in zip([*found, *piece.fronts(ball(x))], [*pages, front], strict=True):
            assert value.is_finite()
            assert abs(m(ends(value)[0]) - page) < mpf("1e-12") * (1 + abs(page))
            assert abs(m(ends(value)[1]) - page) < mpf("1e-12") * (1 + abs(page))


@pytest.mark.parametrize("power", [fmpq(3, 2), fmpq(-1, 2)])
@pytest.mark.parametrize(("p", "depth"), [(fmpq(1, 2), 4), (fmpq(3), 8)])
def test_the_path_of_the_oscillating_coefficient(
    power: fmpq, p: fmpq, depth: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    def call() -> arb:
        return oscillating_coefficient_bound(weight(power), p, arb(fmpq(1, 8)))

    with working_bits(200):
        late, pieces = sums(monkeypatch, call, depth, "_before")
        early, _ = sums(monkeypatch, call, depth, "_beyond")
        top, turn = top_of(p), mpmath.expjpi(mpf(1) / 3)
        height, reach = energy(top, p), 3 * abs(top) + 4 + 2 * mpmath.sqrt(m(p))
        assert is_the_bound(early, page_before(power, abs(1 + top) * mpmath.exp(-depth), p, height, mpf(1) / 8))
        assert is_the_bound(late, page_beyond(power, top, turn, reach, p, height, mpf(1) / 8))
        (inner, first), (outer, second) = pieces
        assert abs(upper(first) - height) + abs(upper(second) - height) < mpf("1e-30")
        check_piece(inner, lambda x: (1 + top) * mpmath.exp(-x) - 1, p, power, mpf(depth))
        check_piece(outer, lambda x: top + turn * x, p, power, reach)


@pytest.mark.parametrize("power", [fmpq(3, 2), fmpq(-1, 2)])
@pytest.mark.parametrize(("p", "depth"), [(fmpq(1, 2), 4), (fmpq(3), 8), (fmpq(-2), 4)])
def test_the_path_of_the_decaying_coefficient(
    power: fmpq, p: fmpq, depth: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    def call() -> arb:
        return decaying_coefficient_bound(weight(power), p, arb(fmpq(1, 8)))

    with working_bits(200):
        late, pieces = sums(monkeypatch, call, depth, "_before")
        early, _ = sums(monkeypatch, call, depth, "_beyond")
        roots = mpmath.polyroots([1, 2, m(p), m(p)], maxsteps=200, extraprec=200)
        corner = -min(r.real for r in roots if abs(r.imag) < mpf("1e-20"))
        height = energy(mpc(-corner), p)
        (inner, first), (outer, second) = pieces
        assert abs(upper(first) - height) + abs(upper(second) - height) < mpf("1e-30")
        last = upper(outer.length)
        check_piece(inner, lambda x: -1 - (corner - 1) * mpmath.exp(-x), p, power, mpf(depth))
        check_piece(outer, lambda x: -1 - (corner - 1) * mpmath.exp(x), p, power, last)
        end = (corner - 1) * mpmath.exp(last)  # the tail begins where the boxes end
        assert is_the_bound(early, page_before(power, (corner - 1) * mpmath.exp(-depth), p, height, mpf(1) / 8))
        assert is_the_bound(late, page_beyond(power, mpc(-1), mpc(-1), end, p, height, mpf(1) / 8))


def test_the_weights() -> None:
    """|k| <= B |s|^3 for |s|, |1 + s| >= 1, and |(1 + s) k| <= 2 B for |1 + s| <= 1/4."""
    with working_bits(100):
        data = kernel(STATE)
        for one, power in ((state_weight(data), fmpq(3, 2)), (unit_weight(data.beta), fmpq(1, 2))):
            assert one.power == arb(power)
            for k in range(24):
                turn: Any = acb(0, 2 * arb.pi() * k / 24).exp()
                for length in (fmpq(1), fmpq(3, 2), fmpq(4)):
                    s = turn * length
                    if abs(1 + s) >= 1:
                        assert abs(one.polynomial(s, 1 + s) / (1 + s)) <= one.size * length**3 * (1 + arb((1, -80)))
                assert abs(one.polynomial(turn / 4 - 1, turn / 4)) <= 2 * one.size
    assert unit_weight(arb(fmpq(5, 2))).polynomial(acb(3), acb(7)) == 7


@pytest.mark.parametrize("beta", [fmpq(1, 2), fmpq(5, 2), fmpq(13, 2)])
def test_bounds_of_the_coefficients(beta: fmpq) -> None:
    state = Deviation(beta, fmpq(1, 100), fmpq(1, 2), fmpq(1), fmpq(-2, 3), fmpq(1, 5), fmpq(2))
    with working_bits(64):
        one, small = state_weight(kernel(state)), arb(state.epsilon)
        first = oscillating_coefficient_bound(one, state.p, small)
        second = decaying_coefficient_bound(one, state.p, small)
    for factor in (fmpq(1), fmpq(2, 3), fmpq(1, 4)):
        smaller = replace(state, epsilon=state.epsilon * factor)
        fast, steady = fast_coefficient(smaller, 40), decaying_coefficient(smaller, 40)
        with working_bits(100):
            data, top, corner = kernel(smaller), saddle(state.p), -real_saddle(state.p)
            wave = data.exponent(top, (1 + top).log()).real
            fall = data.exponent(acb(-corner), acb((corner - 1).log())).real
            front = arb(2) * arb.pi() / beta
            for bound, size in ((first, abs(fast) * (-wave).exp()), (second, abs(steady) * (-fall).exp())):
                assert size.is_finite()
                assert size * front < bound
                assert factor < 1 or bound < 4 * size * front
