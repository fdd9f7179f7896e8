"""Theorem B' of proofs/from_state.md, section 8, number by number: its sums in mpmath, with any polynomials in the
place of the slow manifold, and each inequality on both sides of its edge."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

import mpmath
import pytest
from flint import arb, fmpq
from mpmath import mpf

from gspot_verified.expansion.chart.cone import Cone
from gspot_verified.expansion.from_state.affine_system import Affine, AffineSystem
from gspot_verified.expansion.from_state.affine_tube import (
    AffineStart,
    AffineTube,
    _Path,
    affine_tube,
    carried,
    power_of,
)
from gspot_verified.expansion.from_state.barrier import Monomials, layer, layer_integral, paid
from gspot_verified.expansion.from_state.fast_growth import Growth, Norm, Rectangle
from gspot_verified.expansion.from_state.slow_manifold import RING, Cut, L, SlowManifold
from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.numbers.balls import hull, working_bits
from gspot_verified.numbers.evidence import less
from tests.expansion.from_state.test_barrier_numbers import agrees, in_mpmath, number, rational

Triples = dict[tuple[int, int, int], fmpq]
Terms = dict[tuple[fmpq, fmpq], mpf]
FINE = 192
SPRINGS = Regularisation.of(2, 3, "1/2")  # kappa = 6/5, g = 10, l = 9/5
P, E, H_1, RATIO, LARGEST = fmpq(1, 25), fmpq(1, 2000), fmpq(1, 2), fmpq(3, 2), fmpq(2, 5)
GROWTH, DAMPING, EXCESS, WITHIN = fmpq(-5, 2), fmpq(3), fmpq(1, 3), fmpq(1, 100)
RECTANGLE = Rectangle(H_1, fmpq(1, 4))
# at p_1: r = 1/5, h = 1/16; at the hand-over of e = E: r = 1/10, h = 1/2
SYSTEM = AffineSystem(Affine(fmpq(-3, 4)), Affine(fmpq(-7, 6)), Affine(fmpq(-7, 4)), SPRINGS)  # beta = 7/3, mu = 8/3
BETA, MU, MEAN = fmpq(7, 3), fmpq(8, 3), fmpq(7, 6)
FORCE: Triples = {(0, 0, 0): MEAN, (0, 2, 0): fmpq(1, 9), (0, 4, 0): fmpq(-2)}
LATE = FORCE | {(2, 4, 0): fmpq(5)}  # the excess at the start is a ball, and balls round their radii
U: Triples = {(0, 2, 0): fmpq(1, 70), (0, 0, 1): fmpq(2, 70), (1, 1, 1): fmpq(-3, 50), (1, 2, 2): fmpq(1, 80)}
W: Triples = {
    (2, 4, 0): fmpq(1, 50), (2, 0, 1): fmpq(-1, 30), (2, 3, 1): fmpq(1, 20), (2, 2, 2): fmpq(1, 40),
}  # fmt: skip
F: Triples = {(2, 0, 1): fmpq(-1, 90), (2, 1, 1): fmpq(1, 40), (2, 2, 3): fmpq(1, 60)}
FALL: Triples = {(0, 0, 0): fmpq(1), (0, 2, 0): fmpq(1, 10), (2, 4, 0): fmpq(-1, 60), (0, 2, 1): fmpq(-1, 5)}
BACK: Triples = {(0, 0, 0): BETA, (0, 2, 0): fmpq(-1, 4), (0, 2, 1): fmpq(1, 3)}
SLOW: Triples = {
    (0, 6, 0): fmpq(1, 150), (0, 0, 1): BETA - 1, (0, 2, 1): fmpq(1, 7), (2, 0, 1): fmpq(-1, 8), (0, 2, 2): fmpq(-1, 9),
}  # fmt: skip
DRIFT: Triples = {
    (0, 2, 0): fmpq(1, 11), (2, 0, 0): fmpq(-1, 13), (1, 3, 0): fmpq(1, 90), (0, 2, 1): fmpq(-1, 17),
}  # fmt: skip
RESIDUAL: tuple[Triples, Triples, Triples] = (
    {(2, 0, 1): fmpq(-1, 900), (0, 7, 0): fmpq(1, 50)},
    {(2, 0, 1): fmpq(1, 700), (1, 3, 2): fmpq(-1, 1100)},
    {(3, 1, 1): fmpq(1, 1300)},
)


Rests = tuple[fmpq, fmpq, fmpq]
NONE = fmpq(0)
NO_REST: Rests = (NONE, NONE, NONE)
ONE: Triples = {(0, 0, 0): fmpq(1)}
REST: Rests = (fmpq(30), fmpq(50), fmpq(20))


@dataclass(frozen=True)
class Bent(Affine):
    """It leaves ``left`` r^8."""

    left: fmpq = NONE
    asked: list[Any] = field(default_factory=list, compare=False)

    def rest(self, reach: Cone) -> Monomials:
        assert reach.height == reach.speed == 0
        self.asked.append((reach.last, arb(reach.beside)))
        return {(0, 8): arb(self.left)} if self.left else {}


def bent(rests: Rests) -> AffineSystem:
    first, second, third = (
        Bent(one.value, left=left)
        for one, left in zip((SYSTEM.alpha_1, SYSTEM.alpha_2, SYSTEM.alpha_3), rests, strict=True)
    )
    return AffineSystem(first, second, third, SPRINGS)


@pytest.fixture(autouse=True)
def _digits() -> Any:
    with mpmath.workdps(50), working_bits(FINE):
        yield


def manifold(**changes: Any) -> SlowManifold:
    """Polynomials that have all kinds of terms; nothing that the theorem compares rests on their being right."""
    terms = {
        "force": FORCE, "u": U, "w": W, "f": F, "fall": FALL, "back": BACK, "slow": SLOW, "drift": DRIFT,
    } | changes  # fmt: skip
    residual = tuple(RING.from_dict(one) for one in terms.pop("residual", RESIDUAL))
    system = terms.pop("system", SYSTEM)
    made = {name: RING.from_dict(one) for name, one in terms.items()}
    slow, steady = made.pop("slow"), system.beta - 1
    stray = slow - (steady + made["drift"]) * made["fall"] * L
    cut = Cut(4, fmpq(8), 2 * steady)
    return SlowManifold(system, cut, residual=residual, faster=slow - steady * L, stray=stray, **made)


def granted(rate: fmpq = GROWTH, damping: fmpq = DAMPING) -> Growth:
    """Lemma 1 for granted: Theorem B' rests on the numbers alone."""
    return Growth(rate, damping, less(0, 1), 1, "")


def still_force(force: Triples = FORCE) -> fmpq:
    """At h = 0."""
    return sum((c * P ** (n // 2) for (i, n, _), c in force.items() if i == 0), fmpq(0))


def start(excess: fmpq = EXCESS, within: fmpq = WITHIN, **changes: Any) -> AffineStart:
    force = changes.get("force", FORCE)
    return AffineStart(manifold(**changes), P, -P * (still_force(force) + excess), within)


def test_a_quotient_is_what_b_over_p_is_known_by() -> None:
    """The same b in a wide ball, with -b/p in a narrow one: the excess is that of the narrow one."""
    exact = start()
    with working_bits(128):
        narrow = arb(exact.force) + arb(0, "1e-9")
        wide = replace(exact, b=-P * arb(exact.force) + arb(0, "0.01"))
        known = replace(wide, quotient=narrow)
        assert wide.force.contains(narrow)
        assert known.force is narrow
        assert abs(known.excess - arb(EXCESS)) < arb("1e-8")
        assert arb(wide.excess).rad() > arb("1e-3")


def found(
    given: AffineStart | None = None,
    growth: Growth | None = None,
    e: fmpq = E,
    largest: fmpq = LARGEST,
    ratio: fmpq = RATIO,
) -> AffineTube | str:
    given = given or start()
    norm = Norm(given.manifold, fmpq(1), fmpq(1, 2))
    return affine_tube(given, norm, growth or granted(), RECTANGLE, e, largest, ratio)


def good(given: AffineStart | None = None, **changes: Any) -> AffineTube:
    tried = found(given, **changes)
    assert isinstance(tried, AffineTube), tried
    return tried


class Page:
    """The letters and sums of section 8 for one start."""

    def __init__(
        self,
        excess: fmpq = EXCESS,
        e: fmpq = E,
        ratio: fmpq = RATIO,
        largest: fmpq = LARGEST,
        by_e: int = 0,
        rests: Rests = NO_REST,
    ) -> None:
        self.root, self.last = mpmath.sqrt(mpf(6) / 5), 10 / mpmath.sqrt(mpf(9) / 5)
        self.p, self.e, self.ratio, self.largest = number(P), number(e), number(ratio), number(largest)
        late = by_e * (self.e / self.p ** mpf("1.5")) ** 2 * self.p**2
        self.excess, self.size, self.least_size = number(excess), abs(number(excess)) + late, abs(number(excess)) - late
        unit = self.p ** (1 - number(BETA))
        self.most, self.least = self.ratio * self.size * unit, self.least_size * unit / self.ratio
        m, n = number(BETA - fmpq(1, 2)) / 2 * number(H_1), number(RECTANGLE.r)
        d = 1 - m**2 / (mpf(6) / 5) - n**2 * mpf(9) / 5 / 100
        self.c_v, self.c_w, self.c_phi = (1 / mpmath.sqrt(x * d) for x in (mpf(6) / 5, 1, 100 / (mpf(9) / 5)))
        one = {key: c for key, c in FALL.items() if key != (0, 0, 0)}
        # (18): eta_1, eta_2, eta_3 over r^8
        self.eta = tuple(number(left) * 4 / 3 for left in rests)
        self.force = self.sup(self.over(plus(FORCE, {(0, 0, 1): fmpq(1)}), 0))
        self.driven = self.eta[1] + (self.eta[0] + self.eta[2]) * self.force
        self.pi = self.sup(self.over(one, 0)) + self.sup(self.left(self.eta[0]))
        self.back = self.sup(self.over(BACK, 0)) + self.sup(self.left(self.eta[2]))
        self.below = 1 - self.pi

    def over(self, terms: Triples, power: int, sign: int = 0) -> Terms:
        total: Terms = {}
        for (i, n, k), c in terms.items():
            if k == power and c * sign < 0:
                continue
            size = self.most ** (k - power) if k > power else self.least ** (k - power)
            key = fmpq(i), n + (k - power) * MU
            total[key] = total.get(key, mpf(0)) + abs(number(c)) * size
        return total

    def left(self, size: mpf, terms: Triples = ONE, power: int = 0) -> Terms:
        """What is left times a polynomial, over L^power."""
        return {(i, n + 8): size * value for (i, n), value in self.over(terms, power).items() if size}

    def slow_left(self, *terms: Triples, power: int) -> Terms:
        """eta_S = eta_rho + eta_1 E force + eta_3 w, times polynomials."""
        total: Terms = {}
        for one in terms:
            for size, parts in ((self.driven, ONE), (self.eta[0], level(FORCE)), (self.eta[2], W)):
                for (i, n), value in self.over(parts, 0).items():
                    for (j, m), other in self.left(size, one, power).items():
                        total[i + j, n + m] = total.get((i + j, n + m), mpf(0)) + value * other
        return total

    def ends(self, key: Any) -> tuple[mpf, mpf]:
        i, n = number(fmpq(key[0])), number(fmpq(key[1]))
        last = mpmath.cbrt(self.e / number(H_1))
        return (self.e / self.p ** mpf("1.5")) ** i * mpmath.sqrt(self.p) ** n, number(H_1) ** i * last**n

    def sup(self, terms: Terms) -> mpf:
        return sum((value * max(self.ends(key)) for key, value in terms.items()), mpf(0))

    def integral(self, terms: Terms) -> mpf:
        """dp/p from p_S to p_1; n' = min(n, 3i - 1) where the monomial does not fall to the spot."""
        total = mpf(0)
        for (i, n), value in terms.items():
            if 3 * i < n:
                total += value * self.ends((i, n))[0] / (number(n - 3 * i) / 2)
            else:
                least = min(fmpq(n), fmpq(3 * i - 1))
                side = mpmath.sqrt(self.p) ** number(n - least) * self.ends((i, least))[1]
                total += value * side / (number(3 * i - least) / 2)
        return total

    def rate(self, growth: fmpq = GROWTH) -> mpf:
        def turning(terms: Triples) -> Terms:
            return self.over({key: c for key, c in terms.items() if key[2]}, 0)

        with_l = {key: c for key, c in FALL.items() if key[2]}
        # E m, E n: m = (1/2)(l/g) r - (1/2)(beta - 1/2) h, n = -r
        of_m = self.sup({(fmpq(0), fmpq(1)): mpf(9) / 200}) + self.sup(
            {(fmpq(1), fmpq(0)): 3 * number(BETA - fmpq(1, 2)) / 4}
        )
        of_n = self.sup({(fmpq(0), fmpq(1)): mpf(1) / 2})
        own = (self.root * self.c_v + self.last * self.c_phi) / 2 + of_m * self.c_v * self.c_w
        changed = self.sup(self.over(with_l, 0)) + self.sup(self.left(self.eta[0]))
        whole = changed * (own + of_n * self.c_w * self.c_phi)
        by_l = [{(i, n, k - 1): c * k for (i, n, k), c in one.items() if k} for one in (U, W, F)]
        fed = [multiplied(BACK, one) for one in by_l]
        fed = [shifted(fed[0], 1, 0), plus(plus(BACK, FALL, -1), fed[1]), shifted(fed[2], 0, 1)]
        for length, one in zip((self.root, mpf(1), self.last), fed, strict=True):
            whole += length * self.c_w * self.sup(turning(one))
        eta_1, _, eta_3 = self.eta
        lefts = (
            self.left(eta_3, shifted(by_l[0], 1, 0)),
            self.left(eta_3, by_l[1]),
            self.left(eta_3, shifted(by_l[2], 0, 1)),
        )
        for length, one in zip((self.root, mpf(1), self.last), lefts, strict=True):
            whole += length * self.c_w * self.sup(one)
        whole += self.c_w * (self.sup(self.left(eta_1)) + self.sup(self.left(eta_3)))
        whole += self.sup(self.slow_left(ONE, power=1))
        slow = {key: c for key, c in SLOW.items() if key != (0, 0, 1)}
        whole += (
            number(growth) + number(BETA) - 1 + self.sup(self.over(slow, 1, 1)) + self.back * self.c_w * self.largest
        )
        return 1 + max(whole / self.below, whole / (1 + self.pi))

    def source(self) -> Terms:
        total: Terms = {}
        for length, one in zip((self.root, mpf(1), self.last), RESIDUAL, strict=True):
            for key, c in self.over(one, 1).items():
                total[key] = total.get(key, mpf(0)) + length * c / self.below
        eta_1, _, eta_3 = self.eta
        by_l = [{(i, n, k - 1): c * k for (i, n, k), c in terms.items() if k} for terms in (U, W, F)]
        more = [
            (self.root, 1, 0, eta_1, U), (self.root, 1, 0, eta_1, level(U)),
            (mpf(1), 0, 0, self.driven, ONE), (mpf(1), 0, 0, eta_3, W),
            (mpf(1), 0, 0, eta_1, level(W)), (self.last, 0, 1, eta_1, F),
            (self.last, 0, 1, eta_1, level(F)),
        ]  # fmt: skip
        added = [(length, self.left(size, shifted(one, h, r), 1)) for length, h, r, size, one in more]
        for length, h, r, one in ((self.root, 1, 0, by_l[0]), (mpf(1), 0, 0, by_l[1]), (self.last, 0, 1, by_l[2])):
            added.append((length, self.slow_left(shifted(one, h, r), power=1)))
        for length, terms in added:
            for key, c in terms.items():
                total[key] = total.get(key, mpf(0)) + length * c / self.below
        return total

    def drift(self, barrier: mpf, after: mpf) -> mpf:
        """The integral of (16), z's own integrals given."""
        kept = plus({(0, 0, 0): BETA - 1}, DRIFT)
        rest = plus(SLOW, shifted(multiplied(kept, FALL), 0, 0, 1), -1)
        left = self.integral(self.slow_left(ONE, power=1)) + self.integral(self.left(self.eta[0], kept))
        return (self.integral(self.over(rest, 1)) + left + self.back * self.c_w * (barrier + after)) / self.below

    def slow(self) -> mpf:
        return self.integral(self.over(DRIFT, 0))

    def at_start(self, within: mpf) -> mpf:
        root = mpmath.sqrt(self.p)
        h, total = self.e / root**3, 3 * within * abs(self.excess) / self.least_size
        for length, one in ((self.root, shifted(U, 1, 0)), (mpf(1), W), (self.last, shifted(F, 0, 1))):
            for (i, n, k), c in one.items():
                size = self.size ** (k - 1) if k > 1 else self.least_size ** (k - 1)
                total += length * abs(number(c)) * h**i * root**n * size
        return total

    def tilted(self, force: Triples = FORCE) -> mpf:
        off = plus({key: c for key, c in force.items() if key != (0, 0, 0)}, {k: c for k, c in W.items() if not k[2]})
        return self.sup(self.over(off, 0))

    def turned(self, sign: int) -> mpf:
        return self.sup(self.over({key: c for key, c in W.items() if key[2]}, 1, sign))


def plus(first: Triples, second: Triples, factor: int = 1) -> Triples:
    total = dict(first)
    for key, c in second.items():
        total[key] = total.get(key, fmpq(0)) + factor * c
    return {key: c for key, c in total.items() if c}


def multiplied(first: Triples, second: Triples) -> Triples:
    total: Triples = {}
    for (i, n, k), c in first.items():
        total = plus(total, {(i + j, n + m, k + q): c * d for (j, m, q), d in second.items()})
    return total


def level(terms: Triples) -> Triples:
    """E = (3/2) h d/dh - (1/2) r d/dr."""
    return {(i, n, k): c * fmpq(3 * i - n, 2) for (i, n, k), c in terms.items() if 3 * i != n}


def shifted(terms: Triples, h: int, r: int, excess: int = 0) -> Triples:
    return {(i + h, n + r, k + excess): c for (i, n, k), c in terms.items()}


def by_monomial(terms: Any) -> dict[tuple[fmpq, fmpq], arb]:
    return {(fmpq(i), fmpq(n)): value for (i, n), value in terms.items()}


def damping_of(page: Page, damping: fmpq = DAMPING) -> mpf:
    return number(damping) / (1 + page.pi)


def barrier_of(page: Page, rate: mpf, damping: mpf) -> Terms:
    wanted = paid({key: arb(rational(x)) for key, x in page.source().items()}, arb(rational(rate)), rational(damping))
    assert isinstance(wanted, dict), wanted
    return {key: in_mpmath(value) for key, value in by_monomial(wanted).items()}


@pytest.mark.parametrize(
    ("excess", "rests"),
    [
        (fmpq(1, 3), NO_REST), (fmpq(-1, 4), NO_REST), (fmpq(1, 3), REST), (fmpq(-1, 4), REST),
        (fmpq(1, 3), (fmpq(60), fmpq(0), fmpq(0))), (fmpq(1, 3), (fmpq(0), fmpq(90), fmpq(0))),
        (fmpq(1, 3), (fmpq(0), fmpq(0), fmpq(60))),
    ],
)  # fmt: skip
def test_the_numbers_are_those_of_the_page(excess: fmpq, rests: Rests) -> None:
    given = start(excess) if rests is NO_REST else start(excess, system=bent(rests))
    page, one = Page(excess, rests=rests), good(given)
    assert agrees(one.rate.upper(), page.rate())
    assert abs(in_mpmath(one.damping) - damping_of(page)) < mpf(10) ** -40
    assert agrees(one.start.z, page.at_start(mpf(1) / 100))
    assert (one.start.p, one.start.e, one.start.side, one.rectangle) == (P, E, 1 if excess > 0 else -1, RECTANGLE)
    assert [agrees(x, y) for x, y in zip(one.shares, (page.c_v, page.c_w, page.c_phi), strict=True)] == [True] * 3
    assert one.excess.low == MU
    assert agrees(one.excess.largest, page.most)
    assert abs(in_mpmath(one.excess.least) - page.least) < mpf(10) ** -40
    wanted, barrier = barrier_of(page, page.rate(), damping_of(page)), by_monomial(one.barrier)
    assert barrier.keys() == wanted.keys()
    assert all(abs(in_mpmath(barrier[key]) - x) < mpf(10) ** -35 * x for key, x in wanted.items())
    after = in_mpmath(layer_integral(one.start, RECTANGLE, one.rate, one.damping))
    drift = page.drift(page.integral(wanted), after)
    level = page.integral({(fmpq(1), fmpq(3)): mpf(1) / 90})  # h r^3 is the same all along
    assert after > drift / 1000
    assert level > drift / 10**4
    assert abs(in_mpmath(one.drift) - drift - level) < mpf(10) ** -30 * drift
    # (10), and Z at h_1
    h, r = arb(fmpq(1, 3)), arb(fmpq(2, 11))
    steady = sum((x * mpf("0.5") ** number(i) * (mpf(2) / 11) ** number(n) for (i, n), x in wanted.items()), mpf(0))
    last = in_mpmath(layer(one.start, h, one.rate, one.damping))
    assert last > steady / 1000
    assert abs(in_mpmath(one.bound(h, r)) - steady - last) < mpf(10) ** -30
    assert one.bound(h, r).is_exact()


@pytest.mark.parametrize("excess", [fmpq(1, 3), fmpq(-1, 4)])
def test_what_the_polynomials_leave_is_asked_for_the_whole_way(excess: fmpq) -> None:
    """p up to p_1, |Lambda| up to the sum of the largest |reference| and |L|."""
    system = bent(REST)
    good(start(excess, system=system))
    for one in (system.alpha_1, system.alpha_2, system.alpha_3):
        assert isinstance(one, Bent)
        ((p, force),) = one.asked
        assert p == P
        assert agrees(force, Page(excess, rests=REST).force)


def test_the_excess_may_depend_on_epsilon() -> None:
    page, one = Page(by_e=5), good(start(force=LATE))
    for found, wanted in (
        (one.rate, page.rate()), (one.start.z, page.at_start(mpf(1) / 100)), (one.excess.largest, page.most),
        (-one.excess.least, -page.least),
    ):  # fmt: skip
        assert wanted <= in_mpmath(found) < wanted + abs(wanted) * mpf(10) ** -6
    assert page.size > page.least_size * mpf("1.0001")


NEAR = fmpq(1, 10**30)
SIDES = ((1 + NEAR, True), (1 - NEAR, False))  # beyond the edge, and just within it
FORCED = "the force stays positive"


def test_p_must_fall() -> None:
    """sup |A_1 - 1| < 1."""
    for factor, refused in (*SIDES, (fmpq(1), True)):
        given = start(fall={(0, 0, 0): fmpq(1), (0, 2, 0): factor / P})
        assert (str(found(given)) == "p does not certainly fall up to p = 1/25") is refused


def test_the_hand_over_must_lie_after_the_start() -> None:
    edge = H_1 * fmpq(1, 125)
    for e, refused in ((edge, True), (edge * (1 - NEAR), False)):
        assert ("the hand-over lies before the start" in str(found(e=e))) is refused


def test_the_layer_must_fall_with_epsilon() -> None:
    """theta' p_1^2/(2 e_0) > 2 Gamma/3, theta' = theta/(1 + pi)."""
    page = Page()
    edge = rational(2 * page.rate() / 3 * 2 * page.e / page.p**2 * (1 + page.pi))
    for factor, refused in SIDES:
        assert ("the layer falls with epsilon" in str(found(growth=granted(damping=edge / factor)))) is refused


@pytest.mark.parametrize("damping", [fmpq(3), fmpq(1, 2)])
def test_the_barrier_must_stay_below_z_max(damping: fmpq) -> None:
    """sup Z + z_0, and sup Z + I(p_S): with little damping the second is the larger."""
    page = Page()
    barrier = page.sup(barrier_of(page, page.rate(), damping_of(page, damping)))
    one = replace(good().start, z=arb(1))
    last = in_mpmath(layer(one, arb(H_1), arb(rational(page.rate())), arb(rational(damping_of(page, damping)))))
    assert (last > 1) is (damping < 1)
    z = (page.largest - barrier) / max(mpf(1), last)
    within = (z - page.at_start(mpf(0))) / 3 * page.least_size / abs(page.excess)
    assert within > 0
    for factor, refused in SIDES:
        text = str(found(start(within=rational(within) * factor), growth=granted(damping=damping)))
        assert (f"at the {'start' if damping > 1 else 'hand-over'} stays below 2/5" in text) is refused


def test_the_coefficient_must_stay_within_its_factor() -> None:
    """The integral of |D| and of (16) is less than log nu."""
    one = good()

    def beyond(ratio: mpf) -> mpf:
        page = Page(ratio=rational(ratio))
        barrier = barrier_of(page, page.rate(), damping_of(page))
        after = layer_integral(one.start, RECTANGLE, arb(rational(page.rate())), arb(rational(damping_of(page))))
        return page.drift(page.integral(barrier), in_mpmath(after)) + page.slow() - mpmath.log(ratio)

    edge = rational(mpmath.findroot(beyond, (mpf("1.05"), mpf("1.2")), solver="anderson", tol=mpf(10) ** -45))
    assert 1 < edge < RATIO
    for ratio, refused in ((edge * (1 - NEAR), True), (edge * (1 + NEAR), False)):
        assert ("log C_1 moves by" in str(found(ratio=ratio))) is refused


def test_on_the_slow_manifold_alone_it_must_stay_within_its_factor() -> None:
    edge = mpmath.findroot(
        lambda ratio: Page(ratio=rational(ratio)).slow() - mpmath.log(ratio), mpf("1.02"), tol=mpf(10) ** -45
    )
    for factor, refused in ((1 - NEAR, True), (1 + NEAR, False)):
        assert ("on the slow manifold" in str(found(ratio=rational(edge) * factor))) is refused


@pytest.mark.parametrize("sign", [1, -1])
def test_the_reference_must_stay_positive(sign: int) -> None:
    """sup |reference + w at L = 0 - mean| < mean; the excess at the start is given."""
    rest = Page().tilted({key: c for key, c in FORCE.items() if key != (0, 2, 0)})
    edge = rational((number(MEAN) - rest) / number(P))
    for factor, refused in SIDES:
        assert (FORCED in str(found(start(force=FORCE | {(0, 2, 0): sign * edge * factor})))) is refused


def test_a_positive_deviation_must_not_turn() -> None:
    """The negative part of (w - w at L = 0)/L + c_W z_max < 1."""
    page = Page()
    edge = rational((1 - page.turned(-1)) / page.c_w)
    for factor, refused in SIDES:
        assert (FORCED in str(found(growth=granted(fmpq(-9)), largest=edge * factor))) is refused


def test_a_negative_deviation_must_be_smaller_than_the_force() -> None:
    """sup |reference - mean| + nu |L| (1 + the positive part of w/L + c_W z_max) < mean."""
    page = Page(fmpq(-1, 4))
    beyond = page.ratio * page.size * (1 + page.turned(1) + page.c_w * page.largest)
    rest = page.tilted({key: c for key, c in FORCE.items() if key != (0, 2, 0)})
    edge = rational((number(MEAN) - beyond - rest) / page.p)
    for sign in (1, -1):
        for factor, refused in SIDES:
            given = start(fmpq(-1, 4), force=FORCE | {(0, 2, 0): sign * edge * factor})
            assert (FORCED in str(found(given))) is refused


def test_each_reason_is_said() -> None:
    given = start(force=FORCE | {(0, 2, 0): 2 * MEAN / P})
    both = str(found(given, granted(fmpq(-9)), e=H_1 * fmpq(1, 125)))
    assert both.startswith("not certain: the hand-over lies before the start; ")
    assert f"; {FORCED}" in both


def test_the_start_is_in_the_rectangle_and_epsilon_is_positive() -> None:
    given = start()
    norm = Norm(given.manifold, fmpq(1), fmpq(1, 2))
    for p, e in ((RECTANGLE.r**2 + NEAR, E), (fmpq(0), E), (-P, E), (P, fmpq(0)), (P, fmpq(-1))):
        with pytest.raises(ValueError, match="p_1 must be at most"):
            affine_tube(replace(given, p=p), norm, granted(), RECTANGLE, e, LARGEST, RATIO)
    edge = Rectangle(H_1, fmpq(1, 5))
    assert isinstance(affine_tube(given, norm, granted(), edge, E, LARGEST, RATIO), AffineTube)
    other = Norm(manifold(back=BACK | {(0, 2, 0): fmpq(1)}), fmpq(1), fmpq(1, 2))
    with pytest.raises(ValueError, match="another slow manifold"):
        affine_tube(given, other, granted(), RECTANGLE, E, LARGEST, RATIO)
    with pytest.raises(ValueError, match="z_max must be at most 1"):
        affine_tube(given, norm, granted(), RECTANGLE, E, 1 + NEAR, RATIO)


def test_what_else_is_refused() -> None:
    given = start()
    norm = Norm(given.manifold, fmpq(1), fmpq(1, 2))
    wide = Rectangle(fmpq(9), fmpq(1, 4))
    assert affine_tube(given, norm, granted(), wide, E, LARGEST, RATIO) == "the norm is not certainly positive definite"
    unshown = replace(granted(), evidence=None, where="there")
    assert found(growth=unshown) == "Lemma 1 with the rate -5/2 and the damping 3: there"
    late = 5 * (E / fmpq(1, 125)) ** 2 * P**2
    for factor, refused in ((fmpq(1), True), (1 + fmpq(1, 100), False)):
        text = str(found(start(late * factor, force=LATE), ratio=fmpq(10)))
        assert (text == "the excess at the start is not certainly of one sign") is refused
    unpaid = start(residual=({(0, 0, 1): fmpq(1, 9)}, {}, {}))
    assert "is not paid" in str(found(unpaid))
    growing = start(residual=({(1, 2, 0): fmpq(1, 9)}, {}, {}))  # r^(2 - mu) does not grow with epsilon
    assert "not paid" in str(found(growing)) or "stays below" in str(found(growing))


def test_with_few_bits_a_bound_is_no_smaller() -> None:
    given, place = start(), (arb(fmpq(1, 4)), arb(fmpq(1, 8)))
    fine = good(given)
    wanted = fine.bound(*place)
    for bits in range(16, 50):
        with working_bits(bits):
            coarse = good(given)
            assert coarse.rate.upper() >= fine.rate.lower()
            assert coarse.damping <= fine.damping
            assert coarse.drift.upper() >= fine.drift.lower()
            assert coarse.start.z >= fine.start.z
            assert coarse.excess.largest >= fine.excess.largest
            assert coarse.excess.least <= fine.excess.least
            assert all(coarse.barrier[key] >= value for key, value in fine.barrier.items())
            assert coarse.bound(*place) >= wanted


def test_what_the_slow_manifold_does_to_the_coefficient() -> None:
    """The integral of D: exact without L, with L^k between its least and largest, for every e up to e_0."""
    for excess in (fmpq(1, 3), fmpq(-1, 4)):
        given, page = start(excess), Page(excess)
        one = replace(good(given), drift=arb(0))
        h, r, sign = mpf(1) / 3, mpf(1) / 8, 1 if excess > 0 else -1

        def wanted(first: mpf, size: mpf, r: mpf = r, page: Page = page, h: mpf = h, sign: int = sign) -> mpf:
            total = mpf(0)
            for (i, n, k), c in DRIFT.items():
                power = number(n + k * MU)
                if power != 3 * i:
                    change = h**i * r**power - first**i * mpmath.sqrt(page.p) ** power
                    total += 2 * number(c) / (power - 3 * i) * (sign * size) ** k * change
            return total

        firsts = mpf(0), page.e / page.p ** mpf("1.5")
        values = [wanted(first, size) for first in firsts for size in (page.least, page.most)]
        value = carried(given, one, arb(fmpq(1, 3)), arb(fmpq(1, 8)))
        low, high = in_mpmath(value.lower()), in_mpmath(value.upper())
        assert low <= min(values) < max(values) <= high
        assert high - low < 3 * (max(values) - min(values))
        around = carried(given, replace(one, drift=arb("0.25")), arb(fmpq(1, 3)), arb(fmpq(1, 8)))
        assert abs(in_mpmath(around.lower()) - low + mpf("0.25")) < mpf(10) ** -8
        assert abs(in_mpmath(around.upper()) - high - mpf("0.25")) < mpf(10) ** -8
        both = carried(given, one, arb(fmpq(1, 3)), hull([arb(0), arb(fmpq(1, 7))]))
        for place in (mpf(0), mpf(1) / 7):
            assert in_mpmath(both.lower()) <= wanted(mpf(0), page.most, place) <= in_mpmath(both.upper())


def test_a_power_of_what_may_be_zero() -> None:
    found = power_of(hull([arb(0), arb(4)]), fmpq(3, 2))
    assert found.contains(arb(0))
    assert found.contains(arb(8))
    assert found < 9
    assert power_of(arb(4), fmpq(0)) == 1


def test_the_path_is_bounded_for_every_smaller_e() -> None:
    """Largest values and integrals of r^(1/2), h r^3, h^2 r, h^2 r^7 for e = E and less."""
    path = _Path(RECTANGLE, P, E)
    for key in ((0, fmpq(1, 2)), (1, 3), (2, 1), (2, 7)):
        most, whole = in_mpmath(path.largest({key: arb(3)})), in_mpmath(path.integral({key: arb(3)}))
        reached, gathered = mpf(0), mpf(0)
        for share in (mpf(1), mpf("0.1"), mpf("0.001")):
            e = number(E) * share
            last = (e / number(H_1)) ** (mpf(2) / 3)

            def value(p: mpf, e: mpf = e, key: Any = key) -> mpf:
                return 3 * (e / p ** mpf("1.5")) ** key[0] * mpmath.sqrt(p) ** number(fmpq(key[1]))

            reached = max(reached, value(last), value(number(P)))
            gathered = max(
                gathered, mpmath.quad(lambda x: value(mpmath.exp(x)), [mpmath.log(last), mpmath.log(number(P))])
            )
        assert reached <= most * (1 + mpf(10) ** -30)
        assert most <= reached * (1 + mpf(10) ** -30)
        assert gathered <= whole < 8 * gathered


def test_the_excess_at_the_start() -> None:
    """L_0 is that of the reference at epsilon = 0; for epsilon > 0 the reference is another by 5 h^2 r^4."""
    given = start(fmpq(-1, 4), force=LATE)
    assert given.excess == fmpq(-1, 4)
    e = fmpq(1, 700)
    late = 5 * (e / fmpq(1, 125)) ** 2 * P**2
    near = given.excess_up_to(e)
    assert near.lower() <= -fmpq(1, 4) - late
    assert near.upper() >= -fmpq(1, 4) + late
    assert near.rad() < late * fmpq(1001, 1000)
    scale = 1 / number(P) ** (mpf(4) / 3)  # C = -L p^(1 - beta)
    assert abs(in_mpmath(given.coefficient(fmpq(1, 10**30))) - scale / 4) < mpf(10) ** -30
    assert given.coefficient(e) > 0 > start().coefficient(e)
