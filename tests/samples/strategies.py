"""Shared Hypothesis strategies, and the exact reading of flint's numbers that the tests compare by.

Containment is decided here on Python fractions read from ``man_exp`` integers, never by flint's own ``contains``,
which rounds its argument first. :func:`ends` insists on a finite ball: a NaN ball would contain everything.
"""

from __future__ import annotations

from fractions import Fraction

from flint import arb, fmpq
from hypothesis import strategies as st

MAX_TAU = 10**12
MAX_BETA = 10**4


def dyadic_fraction(mantissa: int, exponent: int) -> Fraction:
    """mantissa * 2^exponent."""
    return Fraction(mantissa << exponent) if exponent >= 0 else Fraction(mantissa, 1 << -exponent)


def point(exact_ball: arb) -> Fraction:
    """The number that an exact ball is."""
    mantissa, exponent = (int(part) for part in exact_ball.man_exp())
    assert abs(exponent) < 10**7, "too large for a fraction"
    return dyadic_fraction(mantissa, exponent)


def ends(value: arb) -> tuple[Fraction, Fraction]:
    """Both ends of a finite ball, exactly."""
    assert value.is_finite(), f"not finite: {value}"
    middle, radius = point(value.mid()), point(value.rad())
    assert radius >= 0
    return middle - radius, middle + radius


def holds(value: arb, number: Fraction | int) -> bool:
    """True when the finite ball contains the number."""
    lower, upper = ends(value)
    return lower <= number <= upper


def to_fmpq(number: Fraction | int) -> fmpq:
    """The same rational as flint's."""
    return fmpq(number.numerator, number.denominator)


def to_fraction(number: fmpq) -> Fraction:
    """The same rational as Python's."""
    return Fraction(int(number.p), int(number.q))


def make_ball(middle: tuple[int, int], radius: tuple[int, int] = (0, 0)) -> arb:
    """A ball from (mantissa, exponent) pairs; flint may round the radius up."""
    return arb(middle, radius)


def _near(center: int, gap: Fraction, sign: int) -> Fraction:
    return center + sign * gap


def near_integers(limit: int) -> st.SearchStrategy[Fraction]:
    """n +- 10^-k with k up to 300, and n +- 2^-k with k up to 1000, \\|n\\| < limit."""
    gaps = st.one_of(
        st.integers(1, 300).map(lambda k: Fraction(1, 10**k)), st.integers(1, 1000).map(lambda k: Fraction(1, 2**k))
    )
    return st.builds(_near, st.integers(-(limit - 1), limit - 1), gaps, st.sampled_from((-1, 1)))


def small_heights() -> st.SearchStrategy[Fraction]:
    """p/q with \\|p\\| <= 60 and q <= 12."""
    return st.builds(Fraction, st.integers(-60, 60), st.integers(1, 12))


def large_heights(limit: int) -> st.SearchStrategy[Fraction]:
    """limit * p/q with p and q of up to 200 digits, \\|p\\| <= q."""
    unit = st.integers(1, 10**200).flatmap(lambda q: st.integers(-q, q).map(lambda p: Fraction(p, q)))
    # The scale is a power of ten up to the limit, so that small values are as frequent as large ones.
    powers = st.integers(0, len(str(limit)) - 1).map(lambda k: Fraction(10**k))
    return st.builds(lambda share, scale: share * scale, unit, powers)


def rationals(limit: int = 10**12) -> st.SearchStrategy[Fraction]:
    """Exact rationals in [-limit, limit]: integers, near-integers, small heights, large heights."""
    return st.one_of(
        st.integers(-min(limit, 20), min(limit, 20)).map(Fraction),
        small_heights(),
        near_integers(min(limit, 50)),
        st.integers(-limit, limit).map(Fraction),
        near_integers(limit),
        large_heights(limit),
    )


def taus() -> st.SearchStrategy[Fraction]:
    """Rationals with \\|tau\\| <= 10^12, the ends included."""
    return st.one_of(st.sampled_from((Fraction(0), Fraction(MAX_TAU), Fraction(-MAX_TAU))), rationals(MAX_TAU))


def betas() -> st.SearchStrategy[Fraction]:
    """Rationals with \\|beta\\| <= 10^4, the ends included."""
    return st.one_of(st.sampled_from((Fraction(0), Fraction(MAX_BETA), Fraction(-MAX_BETA))), rationals(MAX_BETA))


_MANTISSAS = st.one_of(st.integers(-40, 40), st.integers(-(2**64), 2**64), st.integers(-(2**300), 2**300))
_RADIUS_MANTISSAS = st.one_of(st.integers(1, 9), st.integers(1, 2**30 - 1))


def exact_balls(exponents: int = 300) -> st.SearchStrategy[arb]:
    """Balls of radius 0."""
    return st.builds(lambda m, e: make_ball((m, e)), _MANTISSAS, st.integers(-exponents, exponents))


def precise_balls(exponents: int = 300) -> st.SearchStrategy[arb]:
    """Balls whose radius is between 2^-20 and 2^-320 of the midpoint; never zero inside."""

    def build(mantissa: int, exponent: int, radius: int, gap: int) -> arb:
        size = mantissa.bit_length()
        return make_ball((mantissa, exponent), (radius, exponent + size - radius.bit_length() - gap))

    mantissas = _MANTISSAS.filter(bool)
    return st.builds(build, mantissas, st.integers(-exponents, exponents), _RADIUS_MANTISSAS, st.integers(20, 320))


def wide_balls(exponents: int = 60) -> st.SearchStrategy[arb]:
    """Balls whose radius is comparable with the midpoint, or larger."""

    def build(mantissa: int, exponent: int, radius: int, gap: int) -> arb:
        size = mantissa.bit_length()
        return make_ball((mantissa, exponent), (radius, exponent + size - radius.bit_length() + gap))

    return st.builds(build, _MANTISSAS, st.integers(-exponents, exponents), _RADIUS_MANTISSAS, st.integers(-6, 12))


def special_balls() -> st.SearchStrategy[arb]:
    """Finite balls at which formulas tend to break: 0, units, [0, 1], symmetric ones, midpoint = radius."""
    table = (
        ((0, 0), (0, 0)),
        ((1, 0), (0, 0)),
        ((-1, 0), (0, 0)),
        ((1, -1), (1, -1)),
        ((-1, -1), (1, -1)),
        ((0, 0), (1, 0)),
        ((0, 0), (1, -200)),
        ((0, 0), (1, 200)),
        ((1, 0), (1, 0)),
        ((1, 0), (2**30 - 1, -30)),
        ((1, 0), (1, -2000)),
        ((2**2000 + 1, -2000), (0, 0)),
        ((1, 1100), (0, 0)),
        ((-1, -1100), (1, -1101)),
    )
    return st.sampled_from(table).map(lambda pair: make_ball(*pair))


def balls() -> st.SearchStrategy[arb]:
    """Finite balls of every kind."""
    return st.one_of(exact_balls(), precise_balls(), wide_balls(), special_balls())


def nonfinite_balls() -> st.SearchStrategy[arb]:
    """NaN, the infinities, and balls of infinite radius."""
    return st.sampled_from(("nan", "inf", "-inf", "0 +/- inf", "1 +/- inf", "inf +/- 1")).map(arb)


def numbers_in(value: arb) -> st.SearchStrategy[Fraction]:
    """Numbers of a finite ball, its ends included."""
    lower, upper = ends(value)
    shares = st.one_of(
        st.sampled_from((Fraction(0), Fraction(1), Fraction(1, 2))),
        st.integers(0, 2**64).map(lambda n: Fraction(n, 2**64)),
    )
    return shares.map(lambda share: lower + share * (upper - lower))


def balls_with_number(kind: st.SearchStrategy[arb] | None = None) -> st.SearchStrategy[tuple[arb, Fraction]]:
    """A finite ball and a number in it."""
    # No st.just(value): it asks for a hash, which an inexact ball refuses.
    return (kind or balls()).flatmap(lambda value: numbers_in(value).map(lambda number: (value, number)))


def precisions() -> st.SearchStrategy[int]:
    """Working precisions, small ones often."""
    return st.one_of(st.integers(2, 64), st.sampled_from((53, 64, 128, 333, 1000)))
