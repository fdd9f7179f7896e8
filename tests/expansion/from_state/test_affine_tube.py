"""Theorem B' of proofs/from_state.md, section 8, number by number: (14), (15), (16) in mpmath, with slopes of both
signs and any polynomials in the place of the slow part, and each inequality on both sides of its edge."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import mpmath
import pytest
from flint import arb, fmpq, fmpq_mpoly
from mpmath import mpf

from gspot_verified.expansion.from_state.affine_system import Affine, AffineSystem
from gspot_verified.expansion.from_state.affine_tube import (
    AffineStart,
    AffineTube,
    _Path,
    _Sums,
    affine_tube,
    carried,
    tilted_drift,
)
from gspot_verified.expansion.from_state.barrier import layer, layer_integral, paid
from gspot_verified.expansion.from_state.fast_growth import Growth, Norm, Rectangle
from gspot_verified.expansion.from_state.slow_series import Contact, H, R, slow_series, terms_of
from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.numbers.balls import hull, working_bits
from gspot_verified.numbers.evidence import less
from tests.expansion.from_state.test_barrier_numbers import agrees, in_mpmath, number, rational

FINE = 192
SPRINGS = Regularisation.of(2, 3, "1/2")
CONTACT = Contact.of(SPRINGS)  # kappa = 6/5, g = 10, l = 9/5
with mpmath.workdps(50):
    LENGTHS = mpmath.sqrt(mpf(6) / 5), mpf(1), 10 / mpmath.sqrt(mpf(9) / 5)  # of x_1, x_2, x_3 in the norm
P, E, H_1, RATIO, LARGEST = fmpq(1, 25), fmpq(1, 2000), fmpq(1, 2), fmpq(3, 2), fmpq(2, 5)
GROWTH, DAMPING, EXCESS, WITHIN = fmpq(-5, 2), fmpq(3), fmpq(1, 3), fmpq(1, 100)
RECTANGLE = Rectangle(H_1, fmpq(1, 4))
# at p_1: r = 1/5, h = 1/16; at the hand-over of e = E: r = 1/10, h = 1/2
SYSTEM = AffineSystem(
    Affine(fmpq(-3, 4), fmpq(1, 5), fmpq(1, 40)),
    Affine(fmpq(-7, 6), fmpq(-2, 9), fmpq(1, 30)),
    Affine(fmpq(-7, 4), fmpq(3, 8), fmpq(-1, 20)),
    SPRINGS,
)  # beta = 7/3
Terms = dict[tuple[Any, Any], mpf]


@pytest.fixture(autouse=True)
def _digits() -> Any:
    with mpmath.workdps(50), working_bits(FINE):
        yield


def norm_of(system: AffineSystem) -> Norm:
    """v is divisible by h r, as Lemma 0 says; w has monomials that rise and that fall with p, and one that is level."""
    slow = replace(
        slow_series(system.beta, CONTACT, 3, system.slopes),
        v=fmpq(2, 70) * H * R - fmpq(3, 50) * H**2 * R**2,
        w=fmpq(-1, 30) * H**2
        + fmpq(2, 50) * H * R**4
        + fmpq(3, 70) * H * R**3
        + fmpq(1, 60) * H * R**2
        + fmpq(1, 20) * H**2 * R**3,
        f=fmpq(1, 40) * H * R - fmpq(1, 90) * H**2,
        residual=(-fmpq(1, 900) * H**2, fmpq(1, 700) * H**2 - fmpq(1, 1100) * H * R**3, fmpq(1, 1300) * H**3 * R),
    )
    return Norm(slow, fmpq(1), fmpq(1, 2))


def granted(rate: fmpq = GROWTH, damping: fmpq = DAMPING) -> Growth:
    """Lemma 1 for granted: Theorem B' rests on the numbers alone."""
    return Growth(rate, damping, less(0, 1), 1, "")


def start(system: AffineSystem = SYSTEM, excess: fmpq = EXCESS, within: fmpq = WITHIN) -> AffineStart:
    return AffineStart(system, P, -P * (system.mean_force + system.tilt * P + excess), within)


def found(
    given: AffineStart | None = None,
    growth: Growth | None = None,
    e: fmpq = E,
    largest: fmpq = LARGEST,
    ratio: fmpq = RATIO,
) -> AffineTube | str:
    given = given or start()
    return affine_tube(given, norm_of(given.system), growth or granted(), RECTANGLE, e, largest, ratio)


def good(given: AffineStart | None = None, **changes: Any) -> AffineTube:
    tried = found(given, **changes)
    assert isinstance(tried, AffineTube), tried
    return tried


def sizes(polynomial: fmpq_mpoly) -> Terms:
    return {key: abs(number(c)) for key, c in terms_of(polynomial).items()}


def plus(*parts: tuple[Any, Mapping[Any, mpf]]) -> Terms:
    total: Terms = {}
    for factor, terms in parts:
        for key, value in terms.items():
            total[key] = total.get(key, mpf(0)) + factor * value
    return total


def product(first: Terms, second: Terms) -> Terms:
    return plus(*((1, {(i + j, n + m): x * y}) for (i, n), x in first.items() for (j, m), y in second.items()))


def moved(terms: Any, over_h: int, over_r: int) -> Terms:
    """|F'_0| over h^. r^.: (h^i r^n)'_0 = ((3 i - n)/2) h^(i+1) r^(n+1)."""
    return {
        (i + 1 - over_h, n + 1 - over_r): abs(number(c) * (3 * i - n)) / 2 for (i, n), c in terms.items() if 3 * i != n
    }


class Page:
    """The letters and sums of section 8 for one start."""

    def __init__(self, given: AffineStart, e: fmpq = E, ratio: fmpq = RATIO, largest: fmpq = LARGEST) -> None:
        system, series = given.system, norm_of(given.system).series
        (a_1, a_1p, a_1b), (a_2, a_2p, a_2b), (a_3, a_3p, a_3b) = (
            (number(one.value), number(one.by_p), number(one.by_b))
            for one in (system.alpha_1, system.alpha_2, system.alpha_3)
        )
        self.p, self.e, self.largest = number(P), number(e), number(largest)
        a, self.beta = -a_1, a_3 / a_1
        self.force = a_2 / (a_3 - a_1)
        d_1, d_2, d_3 = a_1p - self.force * a_1b, a_2p - self.force * a_2b, a_3p - self.force * a_3b
        c, c_b = d_1 - d_3, a_1b - a_3b
        b_rho = a_2b + self.force * c_b
        self.tilt = -(d_2 + self.force * c) / (a * (self.beta - 2))
        fall, sigma, back = -d_1 / a, (c - b_rho) / a, -d_3 / a
        self.excess = -number(given.b) / self.p - self.force - self.tilt * self.p
        self.constant = abs(self.excess) * self.p ** (1 - self.beta)
        self.a = sigma - (self.beta - 1) * fall
        nu, t = number(ratio), abs(self.tilt)
        by_l, by_p, by_r = (0, 2 * system.beta), (0, fmpq(4)), (0, 6 - 2 * system.beta)
        free = t * (abs(c - b_rho) + abs(d_1) + self.p * t * (abs(c_b) + abs(a_1b)))
        linear = {by_l: nu * self.constant / a, by_p: t / a}
        self.s = plus(
            (1, {by_r: free * nu / self.constant / a, by_p: (2 * abs(c_b) + abs(a_1b)) * t / a}),
            (1, {by_l: abs(c_b) * nu * self.constant / a}),
        )
        self.pi, self.b_hat, self.o_hat = (plus((abs(x), linear)) for x in (a_1b, a_3b, c_b))
        square: Terms = {(0, fmpq(2)): mpf(1)}
        self.pi_bar, self.back = (
            plus((abs(fall), square), (1, self.pi)),
            plus((abs(back), square), (1, self.b_hat)),
        )
        self.below = 1 - self.sup(self.pi_bar)
        self.square, self.fall_1, self.sigma_1 = square, abs(fall), abs(sigma)
        self.w, self.v = sizes(series.w), sizes(series.v)
        self.v_r, self.f_r = (
            {(i, n + k): x for (i, n), x in sizes(f).items()} for f, k in ((series.v, -1), (series.f, 1))
        )
        self.series = series
        m, n = (self.beta - mpf(1) / 2) / 2 * number(H_1), number(RECTANGLE.r)
        d = 1 - m**2 / (mpf(6) / 5) - n**2 * mpf(9) / 5 / 100
        self.c_v, self.c_w, self.c_phi = (1 / mpmath.sqrt(x * d) for x in (mpf(6) / 5, 1, 100 / (mpf(9) / 5)))

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
                total += value * self.ends((i, n))[0] / (number(fmpq(n - 3 * i)) / 2)
            else:
                least = min(fmpq(n), fmpq(3 * i - 1))
                total += (
                    value * mpmath.sqrt(self.p) ** number(n - least) * self.ends((i, least))[1]
                    / (number(3 * i - least) / 2)
                )  # fmt: skip
        return total

    def rate(self, growth: fmpq = GROWTH) -> mpf:
        sup, root, third = self.sup, LENGTHS[0], LENGTHS[2]
        # m' = k_2 (l/g) r' - (beta - 1/2)/2 h', n' = -k_1 r', over h r
        of_m = sup({(0, 1): mpf(9) / 200}) + sup({(1, 0): 3 * (self.beta - mpf(1) / 2) / 4})
        of_n = sup({(0, 1): mpf(1) / 2})
        turned = of_m * self.c_v * self.c_w + of_n * self.c_w * self.c_phi
        wide = sup(self.w) + root * sup(self.v_r) + third * sup(self.f_r)
        own = (root * self.c_v + third * self.c_phi) / 2
        return (
            number(growth) + self.beta + (self.fall_1 + self.sigma_1) * self.p
            + (self.beta + sup(self.back)) * (sup(self.w) + self.c_w * self.largest)
            + sup(self.pi) * (1 + turned) + sup(self.s) + sup(self.b_hat) * sup(self.w) + sup(self.pi) * own
            + self.c_w * (sup(self.o_hat) + sup(self.b_hat) * wide)
        ) / self.below  # fmt: skip

    def source(self) -> Terms:
        series = self.series
        residual = plus(*((x, sizes(one)) for x, one in zip(LENGTHS, series.residual, strict=True)))
        square, slow = ({(i, n + 2): c for (i, n), c in terms_of(one).items()} for one in (series.w, series.f))
        beside = plus((1, self.s), (1, product(self.b_hat, self.w)))
        whole = plus(
            (1, residual), (1, self.s), (1, product(self.o_hat, self.w)),
            (LENGTHS[0], product(self.v_r, beside)), (1, product(self.w, beside)),
            (LENGTHS[2], product(self.f_r, beside)),
            (LENGTHS[0], product(self.pi, moved(terms_of(series.v), 1, 2))), (1, product(self.pi, moved(square, 1, 3))),
            (LENGTHS[2], product(self.pi, moved(slow, 1, 2))),
        )  # fmt: skip
        return plus((1 / self.below, whole))

    def drift(self, barrier: mpf, layer: mpf) -> mpf:
        """The integral of (16), z's own integrals given."""
        share = (self.beta + self.sup(self.back)) * self.c_w / self.below
        terms = plus(
            (1, self.s), (self.beta - 1, self.pi), (self.beta, product(self.pi_bar, self.w)),
            (1, product(self.back, self.w)), (abs(self.a), product(self.square, self.pi_bar)),
        )  # fmt: skip
        falling = {key: value for key, value in self.w.items() if 3 * key[0] <= key[1]}
        return self.integral(plus((1 / self.below, terms), (self.beta, falling))) + share * (barrier + layer)

    def slow(self) -> mpf:
        return self.integral(plus((self.beta, self.w), (abs(self.a), self.square)))

    def at_start(self, within: mpf) -> mpf:
        root = mpmath.sqrt(self.p)
        h = self.e / root**3
        parts = (sum((x * h**i * root**n for (i, n), x in one.items()), mpf(0)) for one in (self.v_r, self.w, self.f_r))
        slow = sum((x * y for x, y in zip(LENGTHS, parts, strict=True)), mpf(0))
        return 3 * within + slow + self.e * abs(self.tilt) / (LENGTHS[0] * root * abs(self.excess))


def by_monomial(terms: Mapping[Any, arb]) -> dict[tuple[fmpq, fmpq], arb]:
    return {(fmpq(i), fmpq(n)): value for (i, n), value in terms.items()}


def barrier_of(page: Page, rate: mpf, damping: mpf) -> dict[tuple[fmpq, fmpq], mpf]:
    wanted = paid({key: arb(rational(x)) for key, x in page.source().items()}, arb(rational(rate)), rational(damping))
    assert isinstance(wanted, dict), wanted
    return {key: in_mpmath(value) for key, value in by_monomial(wanted).items()}


@pytest.mark.parametrize("excess", [fmpq(1, 3), fmpq(-1, 4)])
def test_the_numbers_are_those_of_the_page(excess: fmpq) -> None:
    given = start(excess=excess)
    page, one = Page(given), good(given)
    assert agrees(one.rate.upper(), page.rate())
    assert abs(in_mpmath(one.damping) - 3 / (2 - page.below)) < mpf(10) ** -40
    assert agrees(one.start.z, page.at_start(mpf(1) / 100))
    assert (one.start.p, one.start.e, one.start.side, one.rectangle) == (P, E, 1 if excess > 0 else -1, RECTANGLE)
    assert one.start.share == abs(excess) / SYSTEM.mean_force
    assert [agrees(x, y) for x, y in zip(one.shares, (page.c_v, page.c_w, page.c_phi), strict=True)] == [True] * 3
    wanted, barrier = barrier_of(page, page.rate(), 3 / (2 - page.below)), by_monomial(one.barrier)
    assert barrier.keys() == wanted.keys()
    assert all(abs(in_mpmath(barrier[key]) - x) < mpf(10) ** -35 * x for key, x in wanted.items())
    after = in_mpmath(layer_integral(one.start, RECTANGLE, one.rate, one.damping))
    drift = page.drift(page.integral(dict(wanted)), after)
    assert after > drift / 1000
    assert abs(in_mpmath(one.drift) - drift) < mpf(10) ** -30 * drift
    # (10), and Z at h_1
    h, r = arb(fmpq(1, 3)), arb(fmpq(2, 11))
    steady = sum((x * mpf("0.5") ** number(i) * (mpf(2) / 11) ** number(n) for (i, n), x in wanted.items()), mpf(0))
    last = in_mpmath(layer(one.start, h, one.rate, one.damping))
    assert last > steady / 1000
    assert abs(in_mpmath(one.bound(h, r)) - steady - last) < mpf(10) ** -30
    assert one.bound(h, r).is_exact()


NEAR = fmpq(1, 10**30)
SIDES = ((1 + NEAR, True), (1 - NEAR, False))  # beyond the edge, and just within it


def test_p_must_fall() -> None:
    """|w_1| p + pi < 1."""
    level = replace(SYSTEM, alpha_1=Affine(fmpq(-3, 4)), alpha_2=Affine(fmpq(-1)), alpha_3=Affine(fmpq(-7, 4)))
    for sign in (1, -1):
        for factor, refused in (*SIDES, (fmpq(1), True)):
            system = replace(level, alpha_1=Affine(fmpq(-3, 4), sign * fmpq(3, 4) / P * factor))
            assert (str(found(start(system))) == "p does not certainly fall up to p = 1/25") is refused


def test_the_hand_over_must_lie_after_the_start() -> None:
    edge = H_1 * fmpq(1, 125)
    for e, refused in ((edge, True), (edge * (1 - NEAR), False)):
        assert ("the hand-over lies before the start" in str(found(e=e))) is refused


def test_the_layer_must_fall_with_epsilon() -> None:
    """theta' p_1^2/(2 e_0) > 2 Gamma/3, theta' = theta/(1 + pi)."""
    page = Page(start())
    edge = rational(2 * page.rate() / 3 * 2 * page.e / page.p**2 * (2 - page.below))
    for factor, refused in SIDES:
        text = str(found(growth=granted(damping=edge / factor)))
        assert ("the layer falls with epsilon" in text) is refused


@pytest.mark.parametrize("damping", [fmpq(3), fmpq(1, 2)])
def test_the_barrier_must_stay_below_z_max(damping: fmpq) -> None:
    """sup Z + z_0, and sup Z + I(p_S): with little damping the second is the larger."""
    page = Page(start())
    barrier = page.sup(dict(barrier_of(page, page.rate(), number(damping) / (2 - page.below))))
    one = replace(good().start, z=arb(1))
    last = in_mpmath(layer(one, arb(H_1), arb(rational(page.rate())), arb(damping / rational(2 - page.below))))
    assert (last > 1) is (damping < 1)
    z = (page.largest - barrier) / max(mpf(1), last)
    within = (z - page.at_start(mpf(0))) / 3
    assert within > 0
    for factor, refused in SIDES:
        text = str(found(start(within=rational(within) * factor), growth=granted(damping=damping)))
        assert (f"at the {'start' if damping > 1 else 'hand-over'} stays below 2/5" in text) is refused


def test_the_coefficient_must_stay_within_its_factor() -> None:
    """The integral of beta |w| + |A| p and of (16) is less than log nu."""
    given = start()

    def excess(ratio: mpf) -> mpf:
        page = Page(given, ratio=rational(ratio))
        one = good()
        barrier = barrier_of(page, page.rate(), 3 / (2 - page.below))
        after = layer_integral(one.start, RECTANGLE, arb(rational(page.rate())), arb(rational(3 / (2 - page.below))))
        return page.drift(page.integral(dict(barrier)), in_mpmath(after)) + page.slow() - mpmath.log(ratio)

    edge = rational(mpmath.findroot(excess, (mpf("1.05"), mpf("1.2")), solver="anderson", tol=mpf(10) ** -45))
    assert 1 < edge < RATIO
    for ratio, refused in ((edge * (1 - NEAR), True), (edge * (1 + NEAR), False)):
        assert ("log C_1 moves by" in str(found(ratio=ratio))) is refused


def tilted(tilt: fmpq) -> AffineSystem:
    """The same with this Lambda_1: the slopes do not depend on how alpha_2 changes with p."""
    least = replace(SYSTEM, alpha_2=replace(SYSTEM.alpha_2, by_p=fmpq(0)))
    by_p = (tilt - least.tilt) * -(SYSTEM.a * (SYSTEM.beta - 2))
    return replace(SYSTEM, alpha_2=replace(SYSTEM.alpha_2, by_p=by_p))


FORCE = "the force stays positive"


@pytest.mark.parametrize("sign", [1, -1])
def test_the_tilt_must_be_smaller_than_the_force(sign: int) -> None:
    """|Lambda_1| p_1 < the mean force."""
    for factor, refused in (*SIDES, (fmpq(1), True)):
        system = tilted(sign * factor * SYSTEM.mean_force / P)
        assert abs(system.tilt) * P == factor * SYSTEM.mean_force
        assert (FORCE in str(found(start(system)))) is refused


def test_a_positive_deviation_must_not_turn() -> None:
    """sup w^- + c_W z_max < 1."""
    page = Page(start())
    below = page.sup({key: -number(c) for key, c in terms_of(page.series.w).items() if c < 0})
    edge = rational((1 - below) / page.c_w)
    for factor, refused in SIDES:
        assert (FORCE in str(found(growth=granted(fmpq(-5)), largest=edge * factor))) is refused


def test_a_negative_deviation_must_be_smaller_than_the_force() -> None:
    """|Lambda_1| p_1 + nu |L| (1 + sup w^+ + c_W z_max) < the mean force."""
    page = Page(start())
    above = page.sup({key: number(c) for key, c in terms_of(page.series.w).items() if c > 0})
    beyond = number(RATIO) / 4 * (1 + above + page.c_w * page.largest)
    for sign in (1, -1):
        edge = rational((page.force - beyond) / page.p)
        for factor, refused in SIDES:
            assert (FORCE in str(found(start(tilted(sign * edge * factor), excess=fmpq(-1, 4))))) is refused


def test_each_reason_is_said() -> None:
    both = str(found(start(tilted(2 * SYSTEM.mean_force / P)), granted(fmpq(-5)), e=H_1 * fmpq(1, 125)))
    assert both.startswith("not certain: the hand-over lies before the start; ")
    assert f"; {FORCE}" in both


def test_the_start_is_in_the_rectangle_and_epsilon_is_positive() -> None:
    norm, growth = norm_of(SYSTEM), granted()
    for p, e in ((RECTANGLE.r**2 + NEAR, E), (fmpq(0), E), (-P, E), (P, fmpq(0)), (P, fmpq(-1))):
        with pytest.raises(ValueError, match="p_1 must be at most"):
            affine_tube(replace(start(), p=p), norm, growth, RECTANGLE, e, LARGEST, RATIO)
    edge = Rectangle(H_1, fmpq(1, 5))
    assert isinstance(affine_tube(start(), norm, growth, edge, E, LARGEST, RATIO), AffineTube)


def test_the_slow_series_is_that_of_the_system() -> None:
    norm = norm_of(SYSTEM)
    for change in ({"slopes": replace(norm.series.slopes, turn=fmpq(0))}, {"beta": fmpq(9, 4)}):
        other = replace(norm, series=replace(norm.series, **change))
        with pytest.raises(ValueError, match="another system"):
            affine_tube(start(), other, granted(), RECTANGLE, E, LARGEST, RATIO)


def test_what_else_is_refused() -> None:
    norm = norm_of(SYSTEM)
    assert affine_tube(start(), norm, granted(), Rectangle(fmpq(9), fmpq(1, 4)), E, LARGEST, RATIO) == (
        "the norm is not certainly positive definite"
    )
    unshown = replace(granted(), evidence=None, where="there")
    assert found(growth=unshown) == "Lemma 1 with the rate -5/2 and the damping 3: there"
    for beta, text in ((fmpq(7, 2), "beta = 7/2 is above 3"), (fmpq(3), "is not paid"), (fmpq(14, 5), "is not paid")):
        system = replace(SYSTEM, alpha_3=replace(SYSTEM.alpha_3, value=beta * SYSTEM.alpha_1.value))
        assert text in str(found(start(system)))


def test_with_few_bits_a_bound_is_no_smaller() -> None:
    given, place = start(), (arb(fmpq(1, 4)), arb(fmpq(1, 8)))
    fine = good(given)
    wanted = fine.bound(*place)
    for bits in range(14, 50):
        with working_bits(bits):
            coarse = good(given)
            assert coarse.rate.upper() >= fine.rate.lower()
            assert coarse.damping <= fine.damping
            assert coarse.drift.upper() >= fine.drift.lower()
            assert coarse.start.z >= fine.start.z
            assert all(coarse.barrier[key] >= value for key, value in fine.barrier.items())
            assert coarse.bound(*place) >= wanted
            same = replace(fine, barrier={(1, 0): arb(1)}, rate=arb(0), start=replace(fine.start, z=arb((1, -90))))
            assert same.bound(*place) > fmpq(1, 2)  # where the sum of two bounds is rounded, too


def test_with_few_bits_each_sum_is_no_smaller() -> None:
    given, terms = start(), {(2, 0): arb("1.5"), (1, 3): arb("0.375"), (0, fmpq(8, 3)): arb("0.625")}
    coefficient = abs(given.coefficient).upper()

    def sums(path: _Path) -> list[arb]:
        rests = SYSTEM.rests(P, coefficient, RATIO)
        one = _Sums(norm_of(SYSTEM), (arb("0.875"), arb("1.125"), arb("0.25")), rests, path)
        return [path.largest(terms), path.integral(terms), one._norm_change(), one.pushed(arb("0.625"))]

    fine = sums(_Path(RECTANGLE, P, E))
    assert all(value.is_exact() for value in fine)
    for bits in range(6, 50):
        with working_bits(bits):
            coarse = sums(_Path(RECTANGLE, P, E))
        assert all(more >= value for more, value in zip(coarse, fine, strict=True))


def test_with_few_bits_the_start_is_not_lost() -> None:
    """w = h from h = e_0/p_1^(3/2) to h = 0: log C moves by 2 beta h/3, and by A (0 - p_1)."""
    for k in range(1, 12):
        given = start()
        level = AffineSystem(*(Affine(one.value) for one in (SYSTEM.alpha_1, SYSTEM.alpha_2, SYSTEM.alpha_3)), SPRINGS)
        one = replace(good(given), drift=arb(0))
        one = replace(one, start=replace(one.start, p=fmpq(k, 17), e=fmpq(1, 19 * k)))
        series = replace(norm_of(level).series, w=H)
        moved = 2 * number(SYSTEM.beta) / 3 * number(one.start.e) / number(one.start.p) ** mpf("1.5")
        for bits in (8, 11, 60):
            with working_bits(bits):
                value = carried(replace(given, system=level), one, series, arb(0), arb("0.0625"))
            assert in_mpmath(value.lower()) <= 0 < moved <= in_mpmath(value.upper())
        assert in_mpmath(value.upper()) < moved * (1 + mpf(10) ** -6)
        assert in_mpmath(value.lower()) > -moved * mpf(10) ** -6


def test_what_the_slow_part_and_the_tilt_do_to_the_coefficient() -> None:
    """(16): beta w by the monomials that fall with p, A p, and the drift around it; at every e up to e_0."""
    given, page = start(), Page(start())
    one = replace(good(given), drift=arb(0))
    assert abs(number(tilted_drift(SYSTEM)) - page.a) < mpf(10) ** -45
    series = norm_of(SYSTEM).series
    h, r = mpf(1) / 3, mpf(1) / 8

    def wanted(first: mpf, r: mpf = r) -> mpf:
        total = page.a * (r**2 - page.p)
        for (i, n), c in terms_of(series.w).items():
            if 3 * i > n:
                rise = mpf(3 * i - n) / 2
                total -= page.beta * number(c) / rise * (h**i * r**n - first**i * mpmath.sqrt(page.p) ** n)
        return total

    value = carried(given, one, series, arb(fmpq(1, 3)), arb(fmpq(1, 8)))
    ends = sorted((wanted(mpf(0)), wanted(page.e / page.p ** mpf("1.5"))))
    slack = ends[1] - ends[0]
    assert slack > mpf(10) ** -6
    low, high = in_mpmath(value.lower()), in_mpmath(value.upper())
    assert low <= ends[0] < ends[1] <= high
    assert high - low < 4 * slack  # the square of a ball around half its length is twice as wide
    around = carried(given, replace(one, drift=arb("0.25")), series, arb(fmpq(1, 3)), arb(fmpq(1, 8)))
    assert abs(in_mpmath(around.lower()) - low + mpf("0.25")) < mpf(10) ** -8
    assert abs(in_mpmath(around.upper()) - high - mpf("0.25")) < mpf(10) ** -8
    early = replace(one, start=replace(one.start, e=fmpq(1, 10**20)))
    sharp = carried(given, early, series, arb(fmpq(1, 3)), arb(fmpq(1, 8)))
    assert in_mpmath(sharp.rad()) < mpf(10) ** -15
    assert abs(in_mpmath(sharp) - wanted(mpf(0))) < mpf(10) ** -15
    # r in a ball
    both = carried(given, one, series, arb(fmpq(1, 3)), hull([arb(fmpq(1, 8)), arb(fmpq(1, 7))]))
    assert in_mpmath(both.lower()) <= min(ends[0], wanted(mpf(0), mpf(1) / 7))
    assert in_mpmath(both.upper()) >= max(ends[1], wanted(mpf(0), mpf(1) / 7))


@pytest.mark.parametrize("tilt", [fmpq(3), fmpq(-3)])
def test_the_tilt_counts_in_the_start(tilt: fmpq) -> None:
    given = start(tilted(tilt))
    assert agrees(given.size(norm_of(given.system).series, E), Page(given).at_start(mpf(1) / 100))
    assert number(E) * 3 / (LENGTHS[0] * mpf("0.2") / 3) > mpf(10) ** -3


def test_the_start_of_the_tube() -> None:
    given = start(excess=fmpq(-1, 4))
    assert given.excess == fmpq(-1, 4)
    wanted = mpf(1) / 4 * mpf(1) / number(P) ** (mpf(4) / 3)  # C = -L p^(1 - beta)
    assert abs(in_mpmath(given.coefficient) - wanted) < mpf(10) ** -40 * wanted
    assert start().coefficient < 0
