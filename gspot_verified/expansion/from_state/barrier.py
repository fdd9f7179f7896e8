"""Theorem B: a bound of the fast deviation of the model system for all epsilon at once, between p_1 and the hand-over.

Proof page: ``proofs/from_state.md``, section 4. Sums of monomials A h^i r^n with upper bounds of A >= 0; every
hypothesis is compared in :func:`tube`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from flint import arb, fmpq, fmpq_mpoly

from gspot_verified.expansion.from_state.fast_growth import Growth, Norm, Rectangle
from gspot_verified.expansion.from_state.slow_series import R, SlowSeries, terms_of
from gspot_verified.numbers.balls import Exact, ball
from gspot_verified.numbers.evidence import every, less
from gspot_verified.numbers.verdict import Evidence

Exponents = tuple[int | fmpq, int | fmpq]
Monomials = dict[Exponents, arb]
"""Upper bounds of the coefficients of h^i r^n."""
_ROOM = fmpq(1, 4)
"""A source is paid at once when its own growth is larger than the rate by so much: any number from 0 on is right."""


@dataclass(frozen=True)
class Start:
    """p = ``p`` = p_1, e <= ``e``, z <= ``z``, L of the sign ``side``, \\|L\\| <= ``share`` times the mean force."""

    p: Exact
    e: fmpq
    z: arb
    side: int
    share: Exact


@dataclass(frozen=True)
class Tube:
    """z <= Z + I, 0 < h <= ``rectangle.h``, p <= p_1, for every e up to ``start.e``.

    ``rate`` is Gamma, ``share`` c_w, ``largest`` z_max, ``drift(r)`` bounds what Z and I do to log C_1 until r.
    """

    start: Start
    rectangle: Rectangle
    largest: fmpq
    barrier: Monomials
    rate: arb
    damping: fmpq
    shares: tuple[arb, arb, arb]
    beta: fmpq
    evidence: Evidence

    def bound(self, h: arb, r: arb) -> arb:
        """Z + I at this h <= ``rectangle.h``, where r is at most this one, for every e up to ``start.e``."""
        return (value_of(self.barrier, ball(self.rectangle.h), r) + self.layer(h)).upper()

    def layer(self, h: arb) -> arb:
        """I at this h, for every e up to ``start.e``."""
        return layer(self.start, h, self.rate, self.damping)

    def drift(self, r: arb) -> arb:
        """The integral of beta c_w (Z + I) dp/p from p_1 to h = ``rectangle.h``, where r is at most this one."""
        largest = ball(self.rectangle.r)
        total = layer_integral(self.start, self.rectangle, self.rate, self.damping)
        for (i, n), value in self.barrier.items():
            least = min(n, 3 * i - 1)
            total += (
                value * largest ** (n - least) * ball(self.rectangle.h) ** i * r**least / ball(fmpq(3 * i - least, 2))
            )
        return (self.beta * self.shares[1] * total).upper()


def tube(norm: Norm[SlowSeries], growth: Growth, rectangle: Rectangle, start: Start, largest: fmpq) -> Tube | str:
    """Theorem B with z_max = ``largest``, or the inequality that fails.

    :raises ValueError: p_1 is not at most the rectangle's r^2, or e not positive.
    """
    series = norm.series
    beta = series.beta
    if not (0 < start.p <= rectangle.r**2 and start.e > 0):
        raise ValueError("p_1 must be at most r^2 of the rectangle, and e positive")
    if growth.evidence is None:
        return f"Lemma 1 with the rate {growth.rate} and the damping {growth.damping}: {growth.where}"
    shares = norm.shares(rectangle)
    if shares is None:
        return "the norm is not certainly positive definite"
    above, below = extent(series.w, rectangle, 1), extent(series.w, rectangle, -1)
    rate = (growth.rate + beta + beta * above + beta * shares[1] * ball(largest)).upper()
    barrier = paid(source(series), rate, growth.damping)
    if isinstance(barrier, str):
        return barrier
    highest = value_of(barrier, ball(rectangle.h), ball(rectangle.r))
    first, last = start.z, layer(start, ball(rectangle.h), rate, growth.damping)
    moved = ball(largest) * shares[1]
    conditions = {
        "the hand-over lies before the start": less(start.e**2, rectangle.h**2 * start.p**3),
        "the layer falls with epsilon": less(2 * rate / 3, ball(growth.damping * start.p**2 / (2 * start.e))),
        f"the barrier {_shown(highest)} + {_shown(first)} at the start stays below {largest}": less(
            highest + first, ball(largest)
        ),
        f"the barrier {_shown(highest)} + {_shown(last)} at the hand-over stays below {largest}": less(
            highest + last, ball(largest)
        ),
    }
    if start.side > 0:
        conditions["the force stays positive"] = less(below + moved, 1)
    else:
        conditions["the deviation falls with p"] = less(beta * (below + moved), ball(beta - 1))
        conditions["the force stays positive"] = less(ball(start.share) * (1 + above + moved), 1)
    failed = [name for name, shown in conditions.items() if shown is None]
    evidence = every([growth.evidence, *conditions.values()])
    if evidence is None:
        return "not certain: " + "; ".join(failed)
    return Tube(
        start=start,
        rectangle=rectangle,
        largest=largest,
        barrier=barrier,
        rate=rate,
        damping=growth.damping,
        shares=shares,
        beta=beta,
        evidence=evidence,
    )


def start_bound(series: SlowSeries, p: fmpq, e: fmpq, within: fmpq) -> arb:
    """z at p_1 = ``p`` of the states within the stated shares, for every e up to this one, (8)."""
    contact, root = series.contact, ball(p).sqrt()
    h = ball(e) / root**3
    lengths = (ball(contact.kappa).sqrt(), arb(1), root * ball(contact.rate) / ball(contact.lag).sqrt())
    total = 3 * ball(within)
    for length, polynomial in zip(lengths, (series.v / R, series.w, series.f), strict=True):
        sizes: Monomials = {key: ball(abs(value)) for key, value in terms_of(polynomial).items()}
        total += length * value_of(sizes, h, root)
    return total.upper()


def source(series: SlowSeries) -> Monomials:
    """\\|R\\|_M/(e \\|L\\|), monomial by monomial: \\|R\\|_M <= sum of \\|R_i\\| sqrt(M_ii)."""
    contact = series.contact
    lengths = (ball(contact.kappa).sqrt(), arb(1), ball(contact.rate) / ball(contact.lag).sqrt())
    total: Monomials = {}
    for length, polynomial in zip(lengths, series.residual, strict=True):
        for key, value in terms_of(polynomial).items():
            total[key] = (total.get(key, arb(0)) + length * abs(value)).upper()
    return total


def paid(source: Mapping[Exponents, arb], rate: arb, damping: fmpq | arb) -> Monomials | str:
    """Z of (9), or the monomial that cannot be paid; a deficit is paid with what the source has of its monomial."""
    total: Monomials = {}
    by_power: dict[int | fmpq, Monomials] = {}
    for key, value in source.items():
        by_power.setdefault(key[0], {})[key] = value
    while by_power:
        i = min(by_power)
        for (_, n), value in by_power.pop(i).items():
            own = fmpq(3 * i - n) / 2
            if own > rate + _ROOM or (n < 1 and own > rate):
                added(total, {(i, n): value}, 1 / (own - rate))
                continue
            if n < 1:
                return (
                    f"what is left of the source is not paid: at h^{i} r^{n} the growth {own} is below {_shown(rate)}"
                )
            raised: Monomials = {(i + 1, n - 1): (value / damping).upper()}
            added(total, raised, 1)
            if own + 2 >= rate:
                continue
            added(by_power.setdefault(i + 1, {}), raised, rate - own - 2)
    return total


def layer(start: Start, h: arb, rate: arb, damping: fmpq | arb) -> arb:
    """I at this h for e = ``start.e``, (10); it falls with e when a condition of Theorem B holds."""
    last = place_of(start, h)
    decay = ball(damping) * (ball(start.p) ** 2 - last**2) / (2 * ball(start.e))
    return (start.z * ((ball(start.p) / last).log() * rate - decay).exp()).upper()


def layer_integral(start: Start, rectangle: Rectangle, rate: arb, damping: fmpq | arb) -> arb:
    """The integral of I dp/p from p_1 to h = ``rectangle.h``, for every e up to ``start.e``, (11); not finite where
    the page's conditions are not certain."""
    last = place_of(start, ball(rectangle.h))
    length = (ball(start.p) / last).log().max(arb(fmpq(2, 3)))
    decay = ball(damping) * (ball(start.p) ** 2 - last**2) / (2 * ball(start.e) * length)
    if decay > rate:
        return (start.z / (decay - rate)).upper()
    return arb.pos_inf()


def place_of(start: Start, h: arb) -> arb:
    """p at this h for e = ``start.e``."""
    return (ball(start.e) / h) ** ball(fmpq(2, 3))


def extent(polynomial: fmpq_mpoly, rectangle: Rectangle, sign: int) -> arb:
    """sup of max(sign times the polynomial, 0) on the rectangle, from above, term by term."""
    terms: Monomials = {key: ball(sign * value) for key, value in terms_of(polynomial).items() if sign * value > 0}
    return value_of(terms, ball(rectangle.h), ball(rectangle.r))


def value_of(terms: Mapping[Exponents, arb], h: arb, r: arb) -> arb:
    """The sum of A h^i r^n."""
    return sum((value * h**i * r**n for (i, n), value in terms.items()), arb(0)).upper()


def added(total: Monomials, more: Mapping[Exponents, arb], factor: arb | fmpq | int) -> None:
    """``factor`` times ``more`` is added to ``total``."""
    for key, value in more.items():
        total[key] = (total.get(key, arb(0)) + value * factor).upper()


def times(first: Mapping[Exponents, arb], second: Mapping[Exponents, arb]) -> Monomials:
    """The product of two sums of monomials."""
    total: Monomials = {}
    for (i, n), value in first.items():
        added(total, {(i + j, n + m): value * other for (j, m), other in second.items()}, 1)
    return total


def _shown(value: arb) -> str:
    return value.str(3, radius=False)
