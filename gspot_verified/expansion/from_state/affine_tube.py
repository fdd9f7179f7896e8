"""Theorem B': the bound of the fast deviation where the alpha_i are affine in p and b, for all epsilon at once.

Proof page: ``proofs/from_state.md``, section 8. Every hypothesis is compared in :func:`affine_tube`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from flint import arb, fmpq, fmpq_mpoly

from gspot_verified.expansion.from_state.affine_system import AffineSystem, Rests
from gspot_verified.expansion.from_state.barrier import (
    Exponents,
    Monomials,
    Start,
    added,
    layer,
    layer_integral,
    paid,
    source,
    start_bound,
    times,
    value_of,
)
from gspot_verified.expansion.from_state.fast_growth import Growth, Norm, Rectangle
from gspot_verified.expansion.from_state.slow_series import H, R, SlowSeries, change, terms_of
from gspot_verified.numbers.balls import add_remainder, ball, hull
from gspot_verified.numbers.evidence import every, less
from gspot_verified.numbers.verdict import Evidence

_P: Exponents = (fmpq(0), fmpq(2))


@dataclass(frozen=True)
class AffineStart:
    """The states at p with \\|lambda_N + b/p\\|, ... within their shares of \\|L\\|, b given, for e <= ``e``."""

    system: AffineSystem
    p: fmpq
    b: fmpq
    within: fmpq

    @property
    def excess(self) -> fmpq:
        """L = -b/p - the reference force at p."""
        return -self.b / self.p - self.system.mean_force - self.system.tilt * self.p

    @property
    def coefficient(self) -> arb:
        """C = -L p^(1 - beta) at the start."""
        return -ball(self.excess) * ball(self.p) ** ball(1 - self.system.beta)

    def size(self, series: SlowSeries, e: fmpq) -> arb:
        """z at the start, for every e up to this one."""
        root = ball(self.p).sqrt() * ball(series.contact.kappa).sqrt()
        shift = ball(e) * abs(self.system.tilt) / (root * abs(ball(self.excess)))
        return (start_bound(series, self.p, e, self.within) + shift).upper()


@dataclass(frozen=True)
class AffineTube:
    """z <= Z + I, 0 < h <= ``rectangle.h``, p <= p_1, for every e up to ``start.e``; names as in ``barrier.Tube``."""

    start: Start
    rectangle: Rectangle
    barrier: Monomials
    rate: arb
    damping: arb
    shares: tuple[arb, arb, arb]
    drift: arb
    evidence: Evidence

    def bound(self, h: arb, r: arb) -> arb:
        """Z + I at this h <= ``rectangle.h``, where r is at most this one, for every e up to ``start.e``."""
        last = layer(self.start, h, self.rate, self.damping)
        return (value_of(self.barrier, ball(self.rectangle.h), r) + last).upper()


def affine_tube(
    given: AffineStart, norm: Norm, growth: Growth, rectangle: Rectangle, e: fmpq, largest: fmpq, ratio: fmpq
) -> AffineTube | str:
    """Theorem B' with z_max = ``largest`` and nu = ``ratio``, or the inequality that fails.

    :raises ValueError: p_1 is not at most the rectangle's r^2, e not positive, or the norm is for other slopes.
    """
    series, system = norm.series, given.system
    if not (0 < given.p <= rectangle.r**2 and e > 0):
        raise ValueError("p_1 must be at most r^2 of the rectangle, and e positive")
    if series.slopes != system.slopes or series.beta != system.beta:
        raise ValueError("the slow series is that of another system")
    if growth.evidence is None:
        return f"Lemma 1 with the rate {growth.rate} and the damping {growth.damping}: {growth.where}"
    shares = norm.shares(rectangle)
    if shares is None:
        return "the norm is not certainly positive definite"
    path, rests = _Path(rectangle, given.p, e), system.rests(given.p, abs(given.coefficient), ratio)
    if any(n < 0 for _, n in rests.force):
        return f"beta = {system.beta} is above 3: a reference of first order in p does not do"
    sums = _Sums(norm, shares, rests, path)
    below = 1 - sums.fall
    if less(0, below) is None:
        return f"p does not certainly fall up to p = {given.p}"
    rate = sums.rate(growth.rate, ball(largest)) / below
    damping = (ball(growth.damping) / (1 + sums.fall)).lower()
    barrier = paid(sums.source(below), rate, damping)
    if isinstance(barrier, str):
        return barrier
    side = 1 if given.excess > 0 else -1
    start = Start(given.p, e, given.size(series, e), side, abs(given.excess) / system.mean_force)
    highest, moved = path.largest(barrier), ball(largest) * shares[1]
    first, last = start.z, layer(start, ball(rectangle.h), rate, damping)
    drift = path.integral(sums.drift(below))
    pushed = sums.pushed(below)
    drift += pushed * (path.integral(barrier) + layer_integral(start, rectangle, rate, damping))
    slow = path.integral(sums.slow_drift())
    above, under = path.largest(_positive(series.w, 1)), path.largest(_positive(series.w, -1))
    tilted = ball(abs(system.tilt) * given.p)
    excess = ball(ratio * abs(given.excess))
    conditions = {
        "the hand-over lies before the start": less(e**2, rectangle.h**2 * given.p**3),
        "the layer falls with epsilon": less(2 * rate / 3, damping * ball(given.p**2 / (2 * e))),
        f"the barrier {_shown(highest)} + {_shown(first)} at the start stays below {largest}": less(
            highest + first, ball(largest)
        ),
        f"the barrier {_shown(highest)} + {_shown(last)} at the hand-over stays below {largest}": less(
            highest + last, ball(largest)
        ),
        f"log C_1 moves by {_shown(drift + slow)}, less than log {ratio}": less(drift + slow, ball(ratio).log()),
    }
    if side > 0:
        conditions["the force stays positive"] = every((less(under + moved, 1), less(tilted, ball(system.mean_force))))
    else:
        conditions["the force stays positive"] = less(tilted + excess * (1 + above + moved), ball(system.mean_force))
    failed = [name for name, shown in conditions.items() if shown is None]
    evidence = every([growth.evidence, *conditions.values()])
    if evidence is None:
        return "not certain: " + "; ".join(failed)
    return AffineTube(
        start, rectangle, barrier, rate=rate, damping=damping, shares=shares, drift=drift, evidence=evidence
    )


def carried(given: AffineStart, tube: AffineTube, series: SlowSeries, h: arb, r: arb) -> arb:
    """log of C at (h, r) over C at p_1; (16)."""
    start, system = tube.start, given.system
    nearest = hull([arb(0), (ball(start.e) / ball(start.p) ** ball(fmpq(3, 2))).upper()])
    largest = ball(start.p).sqrt()
    total = ball(tilted_drift(system)) * (r**2 - ball(start.p))
    for (i, n), value in terms_of(series.w).items():
        growth = fmpq(3 * i - n, 2)
        if growth > 0:
            total -= series.beta * ball(value / growth) * (h**i * r**n - nearest**i * largest**n)
    return add_remainder(total, tube.drift)


def tilted_drift(system: AffineSystem) -> fmpq:
    """A: p d log \\|C\\|/dp = A p + ..."""
    return system.slopes.force - (system.beta - 1) * system.slopes.fall


class _Path:
    """The curves h = e p^(-3/2) from p_1 to h = h_1, for all e up to one: largest values, integrals dp/p."""

    def __init__(self, rectangle: Rectangle, p: fmpq, e: fmpq) -> None:
        self._h, self._r = ball(rectangle.h), ball(p).sqrt()
        self._first = ball(e) / self._r**3
        self._last = (ball(e) / self._h).root(3)  # r where h = h_1

    def ends(self, key: Exponents) -> tuple[arb, arb]:
        """The monomial at p_1 and at the hand-over, for the largest e."""
        i, n = key
        return self._first**i * self._r**n, self._h**i * self._last**n

    def largest(self, terms: Mapping[Exponents, arb]) -> arb:
        """A bound of the sum: the log of a monomial is linear in log p."""
        total = arb(0)
        for key, value in terms.items():
            first, last = self.ends(key)
            total += value * first.max(last)
        return total.upper()

    def integral(self, terms: Mapping[Exponents, arb]) -> arb:
        """A bound of the integral of the sum: where it rises to one end, the value there over the rate."""
        total = arb(0)
        for (i, n), value in terms.items():
            growth = fmpq(3 * i - n) / 2
            if growth < 0:
                total += value * self.ends((i, n))[0] / -growth
                continue
            least = min(n, 3 * fmpq(i) - 1)
            total += value * self._r ** (n - least) * self.ends((i, least))[1] / (fmpq(3 * i - least) / 2)
        return total.upper()


class _Sums:
    """The sums of (15), (16): monomials with upper bounds, at most their values on the way."""

    def __init__(self, norm: Norm, shares: tuple[arb, arb, arb], rests: Rests, path: _Path) -> None:
        series = norm.series
        self._series, self._norm, self._rests, self._path, self._shares = series, norm, rests, path, shares
        contact, slopes = series.contact, series.slopes
        self._lengths = (ball(contact.kappa).sqrt(), arb(1), ball(contact.rate) / ball(contact.lag).sqrt())
        self._w, self._v, self._f = (_sizes(one) for one in (series.w, series.v / R, R * series.f))
        self._beta, self._slopes = series.beta, slopes
        self._fall = {_P: ball(abs(slopes.fall))}
        added(self._fall, rests.fall, 1)
        self._back = {_P: ball(abs(slopes.back))}
        added(self._back, rests.back, 1)
        self.fall = path.largest(self._fall)

    def rate(self, growth: fmpq, largest: arb) -> arb:
        """The bracket of (15) in front of z."""
        path, rests, (first, second, third) = self._path, self._rests, self._shares
        at = path.largest
        back, w = self._beta + at(self._back), at(self._w)
        free = at(rests.force) + at(rests.back) * w
        own = at(rests.fall) / 2 * (self._lengths[0] * first + self._lengths[2] * third)
        mixed = second * (
            at(rests.turn) + at(rests.back) * (w + self._lengths[0] * at(self._v) + self._lengths[2] * at(self._f))
        )
        slopes = self._slopes
        slow = path.largest({_P: ball(abs(slopes.fall) + abs(slopes.force))}) + back * w
        return (
            ball(growth + self._beta) + slow + back * second * largest
            + at(rests.fall) * (1 + self._norm_change()) + free + own + mixed
        ).upper()  # fmt: skip

    def _norm_change(self) -> arb:
        """|x^T M' x|/(2 h r |x|^2) of the level system."""
        (first, second, third), gram = self._shares, self._norm.matrix
        parts = (gram[0][1], first * second), (gram[1][2], second * third)
        return sum(
            (self._path.largest(_sizes(change(entry) / (H * R))) * share for entry, share in parts), arb(0)
        ).upper()

    def source(self, below: arb) -> Monomials:
        """The sum without z of (15), over 1 - pi."""
        series, rests = self._series, self._rests
        free: Monomials = dict(rests.force)
        added(free, times(rests.back, self._w), 1)
        total: Monomials = {}
        added(total, source(series), 1)
        added(total, times(rests.turn, self._w), 1)
        added(total, rests.force, 1)
        changes = (
            change(series.v) / (H * R * R),
            change(R * R * series.w) / (H * R**3),
            change(R * R * series.f) / (H * R * R),
        )
        for length, part, moved in zip(self._lengths, (self._v, self._w, self._f), changes, strict=True):
            added(total, times(part, free), length)
            added(total, times(rests.fall, _sizes(moved)), length)
        divided: Monomials = {}
        added(divided, total, 1 / below)
        return divided

    def drift(self, below: arb) -> Monomials:
        """The sum without z of (16): what is beside beta w + A p."""
        slopes, rests, beta = self._slopes, self._rests, self._beta
        total: Monomials = dict(rests.force)
        added(total, rests.fall, beta - 1)
        added(total, times(self._fall, self._w), beta)
        added(total, times(self._back, self._w), 1)
        added(total, times({_P: ball(abs(slopes.force - (beta - 1) * slopes.fall))}, self._fall), 1)
        divided: Monomials = {}
        added(divided, total, 1 / below)
        added(divided, {key: value for key, value in self._w.items() if not 3 * key[0] > key[1]}, beta)
        return divided

    def pushed(self, below: arb) -> arb:
        """What stands in front of z in (16)."""
        return ((self._beta + self._path.largest(self._back)) * self._shares[1] / below).upper()

    def slow_drift(self) -> Monomials:
        """beta |w| + |A| p."""
        total: Monomials = {_P: ball(abs(self._slopes.force - (self._beta - 1) * self._slopes.fall))}
        added(total, self._w, self._beta)
        return total


def _sizes(polynomial: fmpq_mpoly) -> Monomials:
    return {key: ball(abs(value)) for key, value in terms_of(polynomial).items()}


def _positive(polynomial: fmpq_mpoly, sign: int) -> Monomials:
    return {key: ball(sign * value) for key, value in terms_of(polynomial).items() if sign * value > 0}


def _shown(value: arb) -> str:
    return value.str(3, radius=False)
