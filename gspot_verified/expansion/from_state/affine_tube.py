"""Theorem B': the bound of the fast deviation where the alphas are functions of the state, for all epsilon at once.

Proof page: ``proofs/from_state.md``, section 8. Every hypothesis is compared in :func:`affine_tube`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from flint import arb, fmpq

from gspot_verified.expansion.chart.cone import Cone, rational_of
from gspot_verified.expansion.chart.taylor_rest import NoTaylorError
from gspot_verified.expansion.from_state.analytic import Polynomial
from gspot_verified.expansion.from_state.barrier import (
    Exponents,
    Monomials,
    Start,
    added,
    layer,
    layer_integral,
    paid,
    times,
    value_of,
)
from gspot_verified.expansion.from_state.fast_growth import Growth, Norm, Rectangle
from gspot_verified.expansion.from_state.passage import rounded_up
from gspot_verified.expansion.from_state.slow_manifold import (
    RING,
    H,
    L,
    R,
    SlowManifold,
    excess_terms,
    height,
    level,
    moving,
    still,
    still_terms,
)
from gspot_verified.expansion.from_state.slow_series import H as LEVEL_H
from gspot_verified.expansion.from_state.slow_series import R as LEVEL_R
from gspot_verified.expansion.from_state.slow_series import change, terms_of
from gspot_verified.functions.ball_polynomials import constant, polynomial_of
from gspot_verified.numbers.balls import Exact, add_remainder, ball, hull
from gspot_verified.numbers.evidence import differ, every, less
from gspot_verified.numbers.verdict import Evidence

_COARSE = 4  # bounds of y, v, b on the way are rounded to multiples of 1/_COARSE
_FINE = 2**100  # exponents that hold mu are rounded to multiples of 1/_FINE


@dataclass(frozen=True)
class AffineStart:
    """The states at p with \\|lambda_N + b/p\\|, ... within their shares of \\|L\\|, b given; all p and b of balls, of
    them those alone for which -b/p lies in ``quotient``, if it is given."""

    manifold: SlowManifold
    p: Exact
    b: Exact
    within: fmpq
    quotient: arb | None = None

    @property
    def force(self) -> Exact:
        """-b/p."""
        return -self.b / self.p if self.quotient is None else self.quotient

    @property
    def excess(self) -> Exact:
        """L_0 = -b/p - the reference force at epsilon = 0."""
        left = {n // 2: value for (i, n), value in still_terms(self.manifold.force).items() if i == 0}
        rigid: Exact = self.force
        for power, value in left.items():
            rigid = rigid - value * self.p**power
        return rigid

    def excess_up_to(self, e: fmpq) -> arb:
        """L for every e up to this one."""
        terms = still_terms(self.manifold.force).items()
        late: Monomials = {key: abs(ball(value)).upper() for key, value in terms if key[0] > 0}
        root = ball(self.p).sqrt()
        return add_remainder(ball(self.excess), value_of(late, ball(e) / root**3, root))

    def coefficient(self, e: fmpq) -> arb:
        """C = -L p^(1 - beta) at the start, for every e up to this one."""
        return -self.excess_up_to(e) * ball(self.p) ** (1 - ball(self.manifold.beta))

    def size(self, e: fmpq) -> arb:
        """z at the start, for every e up to this one."""
        manifold, root, excess = self.manifold, ball(self.p).sqrt(), abs(self.excess_up_to(e))
        bounds = ExcessBounds(fmpq(0), fmpq(0), excess.upper(), excess.lower())
        total = 3 * ball(self.within) * abs(ball(self.excess)) / excess
        for length, one in zip(lengths(manifold), (H * manifold.u, manifold.w, R * manifold.f), strict=True):
            total += length * value_of(bounds.of(one, 1), ball(e) / root**3, root)
        return total.upper()


@dataclass(frozen=True)
class ExcessBounds:
    """``least`` r^high <= \\|L\\| <= ``largest`` r^low, where low <= mu <= high."""

    low: fmpq
    high: fmpq
    largest: arb
    least: arb

    @classmethod
    def around(cls, mu: Exact, largest: arb, least: arb) -> ExcessBounds:
        """``least`` r^mu <= \\|L\\| <= ``largest`` r^mu; where mu is a ball r is at most 1."""
        if isinstance(mu, fmpq):
            return cls(mu, mu, largest, least)
        return cls(-rounded_up(-mu, _FINE), rounded_up(mu, _FINE), largest, least)

    def of(self, polynomial: Polynomial, over: int = 0, side: int = 0) -> Monomials:
        """Bounds of the terms of the polynomial over L^over, where one may have both signs; but with a ``side`` those
        free of L count only if they have its sign."""
        total: Monomials = {}
        for (i, n, k), value in excess_terms(polynomial).items():
            power = k - over
            if power == 0 and value * side < 0:
                continue
            size, exponent = (self.largest, self.low) if power > 0 else (self.least, self.high)
            key = (i, n + power * exponent) if power else (i, n)
            added(total, {key: size**power}, abs(ball(value)).upper())
        return total


@dataclass(frozen=True)
class AffineTube:
    """z <= Z + I, 0 < h <= ``rectangle.h``, p <= p_1, for every e up to ``start.e``; names as in ``barrier.Tube``.

    ``drift`` is what log C moves by at most besides the integral of D; ``cone`` holds p, b, y, v.
    """

    start: Start
    rectangle: Rectangle
    barrier: Monomials
    rate: arb
    damping: arb
    shares: tuple[arb, arb, arb]
    drift: arb
    excess: ExcessBounds
    cone: Cone
    evidence: Evidence

    def bound(self, h: arb, r: arb) -> arb:
        """Z + I at this h <= ``rectangle.h``, where r is at most this one, for every e up to ``start.e``."""
        last = layer(self.start, h, self.rate, self.damping)
        return (value_of(self.barrier, ball(self.rectangle.h), r) + last).upper()


def affine_tube(
    given: AffineStart,
    norm: Norm[SlowManifold],
    growth: Growth,
    rectangle: Rectangle,
    e: fmpq,
    largest: fmpq,
    ratio: fmpq,
    known: dict[fmpq, Sums] | None = None,
) -> AffineTube | str:
    """Theorem B' with z_max = ``largest`` and nu = ``ratio``, or the inequality that fails.

    ``known`` keeps, by nu, the sums that are the same for each z_max; all else must be the same in every call with it.

    :raises ValueError: p_1 is not at most the rectangle's r^2, e not positive, or the norm is for another manifold.
    """
    manifold, mean = given.manifold, ball(given.manifold.system.mean_force)
    if not (0 < given.p <= rectangle.r**2 and e > 0):
        raise ValueError("p_1 must be at most r^2 of the rectangle, and e positive")
    if norm.series != manifold:
        raise ValueError("the norm is for another slow manifold")
    if not largest <= 1:
        raise ValueError("z_max must be at most 1")
    if not (isinstance(manifold.mu, fmpq) or given.p <= 1):
        raise ValueError("p_1 must be at most 1 where beta is a ball")
    if growth.evidence is None:
        return f"Lemma 1 with the rate {growth.rate} and the damping {growth.damping}: {growth.where}"
    shares = norm.shares(rectangle)
    if shares is None:
        return "the norm is not certainly positive definite"
    first = abs(given.coefficient(e))
    if less(0, first) is None:
        return "the excess at the start is not certainly of one sign"
    excess = ExcessBounds.around(manifold.mu, (first * ratio).upper(), (first / ratio).lower())
    known = {} if known is None else known
    if ratio not in known:
        try:
            known[ratio] = Sums(norm, manifold, shares, excess, _Path(rectangle, given.p, e), given.p)
        except NoTaylorError as error:
            return f"an alpha is not certainly analytic up to p = {given.p}: {error}"
    sums = known[ratio]
    slow, below = sums.path.integral(sums.drift), 1 - sums.fall
    if less(0, below) is None:
        return f"p does not certainly fall up to p = {given.p}"
    if less(slow, ball(ratio).log()) is None:
        return f"log C_1 moves by {_shown(slow)} on the slow manifold, not certainly less than log {ratio}"
    rate, damping = sums.rate(ball(growth.rate), ball(largest)), (growth.damping / (1 + sums.fall)).lower()
    barrier = paid(sums.source, rate, damping)
    if isinstance(barrier, str):
        return barrier
    side = 1 if given.excess > 0 else -1
    share = abs(ball(given.excess)) / mean
    start = Start(given.p, e, given.size(e), side, share)
    highest, last = sums.path.largest(barrier), layer(start, ball(rectangle.h), rate, damping)
    fast = sums.path.integral(barrier) + layer_integral(start, rectangle, rate, damping)
    drift = (sums.path.integral(sums.stray) + sums.pushed * fast).upper()
    tilted = sums.path.largest(
        excess.of(manifold.force + still(manifold.w) - constant(RING, manifold.system.mean_force))
    )
    moved = sums.turned(-side) + ball(largest) * shares[1]
    conditions = {
        "the hand-over lies before the start": less(e**2, rectangle.h**2 * given.p**3),
        "the layer falls with epsilon": less(2 * rate / 3, damping * ball(given.p**2 / (2 * e))),
        f"the barrier {_shown(highest)} + {_shown(start.z)} at the start stays below {largest}": less(
            highest + start.z, ball(largest)
        ),
        f"the barrier {_shown(highest)} + {_shown(last)} at the hand-over stays below {largest}": less(
            highest + last, ball(largest)
        ),
        f"log C_1 moves by {_shown(drift + slow)}, less than log {ratio}": less(drift + slow, ball(ratio).log()),
    }
    if side > 0:
        conditions["the force stays positive"] = every((less(moved, 1), less(tilted, mean)))
    else:
        reached = ratio * abs(given.excess_up_to(e)) * (1 + moved)
        conditions["the force stays positive"] = less(tilted + reached, mean)
    failed = [name for name, shown in conditions.items() if shown is None]
    evidence = every([growth.evidence, *conditions.values()])
    if evidence is None:
        return "not certain: " + "; ".join(failed)
    whole = (drift + sums.path.integral(excess.of(_steady(manifold)))).upper()
    return AffineTube(
        start,
        rectangle,
        barrier,
        rate,
        damping=damping,
        shares=shares,
        drift=whole,
        excess=excess,
        cone=sums.cone,
        evidence=evidence,
    )


def carried(given: AffineStart, tube: AffineTube, h: arb, r: arb) -> arb:
    """log of C at (h, r) over C at p_1; (16)."""
    start, manifold = tube.start, given.manifold
    nearest = hull([arb(0), (ball(start.e) / ball(start.p) ** ball(fmpq(3, 2))).upper()])
    far, total = ball(start.p).sqrt(), arb(0)
    for (i, n, k), value in excess_terms(manifold.drift).items():
        power = n + k * manifold.mu
        if differ(power, fmpq(3 * i)):
            size = (start.side * hull([tube.excess.least, tube.excess.largest])) ** k
            moved = h**i * power_of(r, power) - nearest**i * power_of(far, power)
            total += ball(2 * value) / ball(power - 3 * i) * size * moved
    return add_remainder(total, tube.drift)


def _steady(manifold: SlowManifold) -> Polynomial:
    """The monomials h^i r^n L^k of D with n + k mu = 3 i, or where it may be so."""
    terms = excess_terms(manifold.drift).items()
    kept = {(i, n, k): value for (i, n, k), value in terms if not differ(n + k * manifold.mu, fmpq(3 * i))}
    return polynomial_of(RING, kept)


def power_of(r: arb, exponent: Exact) -> arb:
    """r^exponent for r >= 0 in a ball that may hold 0, exponent >= 0."""
    return hull([end ** ball(exponent) if end > 0 else arb(0) for end in (r.lower(), r.upper())])


def lengths(manifold: SlowManifold) -> tuple[arb, arb, arb]:
    """sqrt(M_ii)."""
    contact = manifold.contact
    return ball(contact.kappa).sqrt(), arb(1), ball(contact.rate) / ball(contact.lag).sqrt()


class _Left:
    """(18): sums of what the polynomials of the alphas leave, ``left`` over a, in all that holds an alpha."""

    def __init__(self, manifold: SlowManifold, excess: ExcessBounds, left: list[Monomials], force: arb) -> None:
        first, second, third = left
        u, w, f = manifold.u, manifold.w, manifold.f
        self._excess, self.fall, self.back = excess, first, third
        driven = _sum(second, times(_sum(first, third), {(0, 0): force}))
        self._slow = _sum(driven, times(first, excess.of(level(manifold.force))), times(third, excess.of(w)))
        self.slow_over = self._over(self._slow, RING.constant(1))
        self.feeding = (
            times(third, excess.of(H * u.derivative(2))),
            _sum(first, third, times(third, excess.of(w.derivative(2)))),
            times(third, excess.of(R * f.derivative(2))),
        )
        self.residual = (
            _sum(self._over(first, H * u, H * level(u)), self._over(self._slow, H * u.derivative(2))),
            _sum(
                self._over(driven, RING.constant(1)),
                self._over(third, w),
                self._over(first, level(w)),
                self._over(self._slow, w.derivative(2)),
            ),
            _sum(self._over(first, R * f, R * level(f)), self._over(self._slow, R * f.derivative(2))),
        )
        self.drift = _sum(self.slow_over, times(first, excess.of(constant(RING, manifold.beta - 1) + manifold.drift)))

    def _over(self, left: Monomials, *polynomials: Polynomial) -> Monomials:
        """``left`` times the sizes of the polynomials over |L|."""
        return _sum(*(times(left, self._excess.of(one, 1)) for one in polynomials))


def _sum(*parts: Mapping[Exponents, arb]) -> Monomials:
    total: Monomials = {}
    for one in parts:
        added(total, one, 1)
    return total


class _Path:
    """The curves h = e p^(-3/2) from p_1 to h = h_1, for all e up to one: largest values, integrals dp/p."""

    def __init__(self, rectangle: Rectangle, p: Exact, e: fmpq) -> None:
        self._h, self._r = ball(rectangle.h), ball(p).sqrt()
        self._first = ball(e) / self._r**3
        self._last = (ball(e) / self._h).root(3)  # r where h = h_1

    def ends(self, key: Exponents) -> tuple[arb, arb]:
        """The monomial at p_1 and at the hand-over, for the largest e; not finite where it does not grow with e."""
        i, n = key
        if n < 0:
            return arb.pos_inf(), arb.pos_inf()
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


class Sums:
    """The sums of (15), (16): upper bounds on the way.

    :raises NoTaylorError: an alpha is not certainly analytic there.
    """

    def __init__(
        self,
        norm: Norm[SlowManifold],
        manifold: SlowManifold,
        shares: tuple[arb, arb, arb],
        excess: ExcessBounds,
        path: _Path,
        p: Exact,
    ) -> None:
        self.path, self._norm, self._manifold, self._shares, self._excess = path, norm, manifold, shares, excess
        system = manifold.system
        self.force = path.largest(excess.of(manifold.force + L))
        alphas = system.alpha_1, system.alpha_2, system.alpha_3
        self.cone = reach = self._reach(p)
        per: Monomials = {(0, 0): ball(1 / system.a).upper()}
        left = [times(_sum(one.rest(reach), self._moved(one.moved(reach))), per) for one in alphas]
        self._left = _Left(manifold, excess, left, self.force)
        self.fall = path.largest(_sum(excess.of(manifold.fall - 1), self._left.fall))
        self.back = path.largest(_sum(excess.of(manifold.back), self._left.back))
        self.drift = excess.of(manifold.drift)
        self._below = 1 - self.fall

    def _reach(self, p: Exact) -> Cone:
        """Where p, b, y, v are on the way; with a chart in round numbers: what is made for one cone serves the next."""
        system, last = self._manifold.system, p if isinstance(p, fmpq) else rounded_up(p.upper())
        sizes = self.force, self._height, self._speed
        if not all(size.is_finite() for size in sizes):
            raise NoTaylorError("y, v or b/p is not certainly bounded")
        if system.chart is None:
            force, height, speed = (rational_of(size) for size in sizes)
            return Cone(fmpq(0), last, fmpq(0), force, height, speed)
        beside = self.path.largest(self._excess.of(self._manifold.force - constant(RING, system.mean_force) + L))
        height, speed = (rounded_up(size, _COARSE) for size in sizes[1:])
        return Cone(fmpq(0), last, system.mean_force, rounded_up(beside, _COARSE), height, speed)

    @cached_property
    def _unsteady(self) -> tuple[Monomials, Monomials]:
        """Bounds of what Y and V differ by from the slow manifold, while z is at most 1."""
        contact, (first, second, third) = self._manifold.contact, self._shares
        lag = ball(contact.lag / contact.rate)
        size = self._excess.of(L)
        upwards: Monomials = {(0, 0): second, (0, 1): (third + lag * first).upper()}
        return times(times(upwards, {(0, 0): ball(1 / contact.kappa).upper()}), size), times({(0, 1): first}, size)

    @cached_property
    def _height(self) -> arb:
        """\\|y\\| <= this p^3: y = h^2 p^3 Y/a^2."""
        manifold = self._manifold
        if not manifold.system.moves:
            return arb(0)
        slow = self._excess.of(height(manifold.system, (manifold.force, manifold.u, manifold.w, manifold.f)))
        per: Monomials = {(2, 0): (1 / ball(manifold.system.a) ** 2).upper()}
        return self.path.largest(times(_sum(slow, self._unsteady[0]), per))

    @cached_property
    def _speed(self) -> arb:
        """\\|v\\| <= this p^2: v = h r^3 V/a, and V = h r u on the slow manifold."""
        manifold = self._manifold
        if not manifold.system.moves:
            return arb(0)
        per = ball(1 / manifold.system.a).upper()
        slow = times(self._excess.of(manifold.u), {(2, 0): per})
        beside: Monomials = {(i + 1, n - 1): value * per for (i, n), value in self._unsteady[1].items()}
        return self.path.largest(_sum(slow, beside))

    def _moved(self, slopes: tuple[Monomials, Monomials]) -> Monomials:
        """What the fast part of y and v changes in an alpha, where its slopes by them are these."""
        by_y, by_v = slopes
        per = ball(1 / self._manifold.system.a).upper()
        y = times(self._unsteady[0], {(2, 6): (per * per).upper()})
        v = times(self._unsteady[1], {(1, 3): per})
        return _sum(times(by_y, y), times(by_v, v))

    def rate(self, growth: arb, largest: arb) -> arb:
        """Gamma of (15)."""
        manifold = self._manifold
        steady = ball(manifold.beta - 1)
        whole = growth + self._changed_matrix + steady + self._slow + self.back * self._shares[1] * largest
        return (1 + (whole / self._below).max(whole / (1 + self.fall))).upper()

    @cached_property
    def _slow(self) -> arb:
        """The part of (S - (beta - 1) L)/L above 0."""
        return self.path.largest(_sum(self._excess.of(self._manifold.faster, 1, 1), self._left.slow_over))

    @cached_property
    def _changed_matrix(self) -> arb:
        """omega: what the terms with L, and what the polynomials leave, add to the matrix and to M'."""
        manifold, (first, second, third), gram = self._manifold, self._shares, self._norm.matrix
        root, one, last = lengths(manifold)
        norm_change = arb(0)
        for entry, share in ((gram[0][1], first * second), (gram[1][2], second * third)):
            moved = change(entry) / (LEVEL_H * LEVEL_R)
            norm_change += share * self.path.largest({key: ball(abs(value)) for key, value in terms_of(moved).items()})
        total = self._changed(manifold.fall, self._left.fall) * ((root * first + last * third) / 2 + norm_change)
        for length, fed, left in zip((root, one, last), manifold.feeding, self._left.feeding, strict=True):
            total += length * second * self._changed(fed, left)
        return total.upper()

    def _changed(self, polynomial: Polynomial, left: Monomials) -> arb:
        return self.path.largest(_sum(self._excess.of(moving(polynomial)), left))

    @cached_property
    def source(self) -> Monomials:
        """F'."""
        total: Monomials = {}
        manifold = self._manifold
        for length, one, left in zip(lengths(manifold), manifold.residual, self._left.residual, strict=True):
            added(total, _sum(self._excess.of(one, 1), left), length / self._below)
        return total

    @cached_property
    def stray(self) -> Monomials:
        """The sum without z of (16)."""
        manifold, total = self._manifold, dict[Exponents, arb]()
        added(total, _sum(self._excess.of(manifold.stray, 1), self._left.drift), 1 / self._below)
        return total

    @property
    def pushed(self) -> arb:
        """What stands in front of z in (16)."""
        return (self.back * self._shares[1] / self._below).upper()

    def turned(self, side: int) -> arb:
        """(w - w at L = 0)/L, the part of this sign."""
        w = self._manifold.w
        return self.path.largest(self._excess.of(moving(w), 1, side))


def _shown(value: arb) -> str:
    return value.str(3, radius=False)
