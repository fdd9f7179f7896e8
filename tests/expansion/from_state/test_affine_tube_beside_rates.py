"""(15), (16) of proofs/from_state.md: the sums beside the page's terms, and beside rates from the raw equations."""

from __future__ import annotations

import random
from dataclasses import dataclass
from functools import cache

from flint import arb, arb_mat, fmpq, fmpq_mpoly

from gspot_verified.expansion.from_state.affine_system import Affine, AffineSystem, Rests
from gspot_verified.expansion.from_state.affine_tube import _Path, _Sums, tilted_drift
from gspot_verified.expansion.from_state.barrier import Monomials, value_of
from gspot_verified.expansion.from_state.fast_growth import Norm, Rectangle, fast_matrix
from gspot_verified.expansion.from_state.slow_series import Contact, R, change, slow_series
from gspot_verified.expansion.series.regularisation import PAPER, Regularisation
from gspot_verified.numbers.balls import ball, working_bits
from tests.expansion.from_state.test_affine_side import place_of, tube_at
from tests.expansion.from_state.test_affine_system import EXTENDED

THETA = fmpq(1, 10)


@dataclass
class Case:
    """A system, and one point (h, r) with L: the way from p_1 to the hand-over is this point alone."""

    system: AffineSystem
    norm: Norm
    h: fmpq
    r: fmpq
    excess: fmpq

    def value(self, polynomial: fmpq_mpoly) -> arb:
        terms = polynomial.to_dict().items()
        return sum((ball(value) * self.h ** int(i) * self.r ** int(n) for (i, n), value in terms), arb(0))

    def size(self, polynomial: fmpq_mpoly) -> arb:
        terms = polynomial.to_dict().items()
        return sum((abs(ball(value)) * self.h ** int(i) * self.r ** int(n) for (i, n), value in terms), arb(0))

    def at(self, terms: Monomials) -> arb:
        return value_of(terms, ball(self.h), ball(self.r))

    @property
    def rests(self) -> Rests:
        p = self.r**2
        return self.system.rests(p, abs(ball(self.excess)) * ball(p) ** ball(1 - self.system.beta), fmpq(1))

    @property
    def shares(self) -> tuple[arb, arb, arb] | None:
        return self.norm.shares(Rectangle(self.h, self.r))

    def sums(self) -> _Sums:
        shares = self.shares
        assert shares is not None
        return _Sums(self.norm, shares, self.rests, _Path(Rectangle(self.h, self.r), self.r**2, self.h * self.r**3))


@cache
def cases() -> list[Case]:
    draw, found = random.Random(5), list[Case]()

    def slope() -> fmpq:
        return fmpq(draw.randint(-40, 40), 20)

    while len(found) < 100:
        beta, a = fmpq(draw.randint(21, 39), 20), fmpq(draw.randint(1, 4), 2)
        if beta == 2:
            continue
        first, second = Affine(-a, slope(), slope()), Affine(-fmpq(draw.randint(2, 4), 2), slope(), slope())
        springs = draw.choice((PAPER, Regularisation.of(2, 3, "1/2")))
        system = AffineSystem(first, second, Affine(-a * beta, slope(), slope()), springs)
        norm = Norm(
            slow_series(beta, Contact.of(springs), draw.choice((1, 2, 4)), system.slopes), fmpq(8, 5), fmpq(1, 2)
        )
        for _ in range(5):
            h, r = fmpq(draw.randint(1, 100), draw.choice((500, 5000))), fmpq(draw.randint(1, 40), 200)
            excess = draw.choice((-1, 1)) * fmpq(draw.randint(1, 9), 10 ** draw.randint(0, 3)) * system.mean_force
            case = Case(system, norm, h, r, excess)
            if case.shares is not None and case.sums().fall < fmpq(9, 10):
                found.append(case)
    return found


def test_the_sums_are_those_of_the_page() -> None:
    """Term by term, written a second time."""
    with working_bits(128):
        for case in cases()[:30]:
            series, slopes, beta, p = case.norm.series, case.system.slopes, case.system.beta, case.r**2
            contact, rests, sums, shares = series.contact, case.rests, case.sums(), case.shares
            assert shares is not None
            c_v, c_w, c_f = shares
            stiff, last = ball(contact.kappa).sqrt(), ball(contact.rate) / ball(contact.lag).sqrt()
            v, w, f = case.size(series.v) / case.r, case.size(series.w), case.r * case.size(series.f)
            force, fall, back, turn = (case.at(one) for one in (rests.force, rests.fall, rests.back, rests.turn))
            own = [case.size(change(one)) / case.h for one in (series.v, R * R * series.w, R * R * series.f)]
            residual = [case.size(one) for one in series.residual]
            source = stiff * residual[0] + residual[1] + last * residual[2] + force + turn * w
            source += (stiff * v + w + last * f) * (force + back * w)
            source += fall * (stiff * own[0] / p + own[1] / case.r**3 + last * own[2] / p)
            _same(case.at(sums.source(arb(3) / 4)), source / (arb(3) / 4))
            m, n = (case.size(change(case.norm.matrix[i][i + 1])) / (case.h * case.r) for i in (0, 1))
            growth, largest = fmpq(1, 20), arb(1) / 5
            rate = growth + beta + ball(abs(slopes.fall) + abs(slopes.force)) * p
            rate += (beta + abs(slopes.back) * p + back) * (w + c_w * largest)
            rate += fall * (1 + m * c_v * c_w + n * c_w * c_f) + force + back * w
            rate += fall * (stiff * c_v + last * c_f) / 2 + c_w * (turn + back * (w + stiff * v + last * f))
            _same(sums.rate(growth, largest), rate)
            A = abs(ball(tilted_drift(case.system)))
            whole = ball(abs(slopes.fall)) * p + fall
            drift = force + (beta - 1) * fall + (beta * whole + abs(slopes.back) * p + back) * w + A * p * whole
            late = sum(  # what is left to the drift of beta w
                (beta * abs(ball(value)) * case.h ** int(i) * case.r ** int(k)
                 for (i, k), value in series.w.to_dict().items() if 3 * i <= k), arb(0),
            )  # fmt: skip
            _same(case.at(sums.drift(arb(3) / 4)), drift / (arb(3) / 4) + late)
            _same(sums.pushed(arb(3) / 4), (beta + abs(slopes.back) * p + back) * c_w / (arb(3) / 4))
            _same(sums.fall, whole)


def _same(found: arb, wanted: arb) -> None:
    assert abs(found - wanted) < arb("1e-20") * (1 + abs(wanted))


def test_z_and_c_change_by_no_more_than_the_sums_from_the_raw_equations() -> None:
    """-p dz/dp and p d log|C|/dp at random states, by the chain rule; in the place of Lemma 1 stands the growth of the
    very x, so that nothing but the terms of section 8 is left between the two sides."""
    draw, sharpest, sharpest_drift = random.Random(6), arb(-1), arb(0)
    with working_bits(160):
        for case in cases():
            z = fmpq(1, 10 ** draw.randint(0, 4))
            x = [fmpq(draw.randint(-100, 100), 100), fmpq(draw.randint(-100, 100), 100), fmpq(draw.randint(-9, 9), 500)]
            change_of_z, growth, change_of_c = raw_changes(case, z, x)
            sums, r, h = case.sums(), ball(case.r), ball(case.h)
            below = 1 - sums.fall
            above = (growth + THETA * r / h).max(arb(fmpq(-1, 2)))
            least = fmpq(int((above * 10**9).upper().ceil().unique_fmpz()), 10**9)
            rate, damping = sums.rate(least, ball(z)) / below, THETA / (1 + sums.fall)
            bound = (rate - damping * r / h) * z + case.at(sums.source(below))
            assert change_of_z <= bound
            if bound > 0:
                sharpest = sharpest.max(change_of_z / bound)
            moved = abs(
                change_of_c - case.system.beta * case.value(case.norm.series.w) - tilted_drift(case.system) * case.r**2
            )
            most = case.at(sums.drift(below)) + sums.pushed(below) * z
            assert moved <= most
            sharpest_drift = sharpest_drift.max(moved / most)
        assert sharpest > arb("0.6")
        assert sharpest_drift > arb("0.9")


def raw_changes(case: Case, z: fmpq, direction: list[fmpq]) -> tuple[arb, arb, arb]:
    """-p dz/dp, (growth of |x| by B and M')/(h r), p d log|C|/dp at the state with this z and direction of x."""
    system, series, springs = case.system, case.norm.series, case.system.regularisation
    contact, r, h, L = series.contact, ball(case.r), ball(case.h), ball(case.excess)
    p, e = r * r, h * r**3
    gram = arb_mat([[case.value(one) for one in row] for row in case.norm.matrix])
    field = arb_mat([[case.value(one) for one in row] for row in fast_matrix(series)])
    level = arb_mat([[case.value(change(one, series.slopes)) for one in row] for row in case.norm.matrix])
    x = arb_mat([[ball(one)] for one in direction])
    x = x * (z * p * abs(L) / (x.transpose() * gram * x)[0, 0].sqrt())
    square = (x.transpose() * gram * x)[0, 0]
    growth = (x.transpose() * (gram * field + field.transpose() * gram + level) * x)[0, 0] / (2 * square * h * r)
    v, w, f = (case.value(one) for one in (series.v, series.w, series.f))
    speed, along, fast = (
        e * system.tilt / contact.kappa + L * v + x[0, 0] / r,
        L * p * w + x[1, 0],
        L * p * f + x[2, 0] / r,
    )
    rigid = system.mean_force + system.tilt * p + L
    b, force = -p * rigid, rigid + along / p
    height = (fast - force - contact.lag / contact.rate * speed) / contact.kappa
    first, second, third = (
        one.value + one.by_p * p + one.by_b * b for one in (system.alpha_1, system.alpha_2, system.alpha_3)
    )
    p_rate, b_rate = e / system.a * first, e / system.a * (second - third * force)
    force_rate = springs.k_2 * ((-springs.k_1 * (height + force / springs.k_2) - force) / springs.c - speed)
    excess_rate = -b_rate / p + b * p_rate / p**2 - system.tilt * p_rate
    along_rate = b_rate + p_rate * force + p * force_rate
    fast_rate = force_rate + contact.kappa * speed + contact.lag / contact.rate * along
    r_rate, h_rate = p_rate / (2 * r), -fmpq(3, 2) * h * p_rate / p

    def rate_of(polynomial: fmpq_mpoly) -> arb:
        return case.value(polynomial.derivative(0)) * h_rate + case.value(polynomial.derivative(1)) * r_rate

    x_rate = arb_mat(
        [
            [r_rate * x[0, 0] / r + r * (along - excess_rate * v - L * rate_of(series.v))],
            [along_rate - excess_rate * p * w - L * rate_of(R * R * series.w)],
            [r_rate * x[2, 0] / r + r * (fast_rate - excess_rate * p * f - L * rate_of(R * R * series.f))],
        ]
    )
    turning = arb_mat([[rate_of(one) for one in row] for row in case.norm.matrix])
    norm_rate = ((x_rate.transpose() * gram * x)[0, 0] * 2 + (x.transpose() * turning * x)[0, 0]) / (2 * square)
    change_of_z = -p * z * (norm_rate - p_rate / p - excess_rate / L) / p_rate
    return change_of_z, growth, p * excess_rate / (L * p_rate) + 1 - ball(system.beta)


def test_the_fall_of_p_enters_the_rate_the_damping_and_the_sources() -> None:
    """theta' = theta/(1 + pi-bar), and Z pays sources and a rate over 1 - pi-bar, on the way to the hand-over."""
    delta, excess = fmpq(1, 20000), fmpq(1, 2)
    with working_bits(128):
        given, tube = tube_at(delta, excess)
        assert given.b == place_of(excess)
        last = fmpq(4) * delta**2  # p where h = 1/8
        norm = Norm(slow_series(EXTENDED.beta, Contact.of(PAPER), 4, EXTENDED.slopes), fmpq(8, 5), fmpq(12, 25))
        rests, slopes = EXTENDED.rests(given.p, abs(given.coefficient), fmpq(3, 2)), EXTENDED.slopes
        fall = ball(abs(slopes.fall) * given.p) + value_of(rests.fall, arb(1), ball(given.p).sqrt())
        _same(tube.damping * (1 + fall), ball(THETA))
        whole = _Sums(norm, tube.shares, rests, _Path(tube.rectangle, given.p, delta**3))
        _same(tube.rate * (1 - fall), whole.rate(fmpq(1, 20), ball(fmpq(1, 10))))
        for p in (given.p, given.p / 10, 40 * last, 4 * last, last):
            root = fmpq(int((ball(p).sqrt() * 2**60).mid().floor().unique_fmpz()), 2**60)
            h = delta**3 / root**3
            path = _Path(Rectangle(h, root), root**2, delta**3)
            sums = _Sums(norm, tube.shares, rests, path)
            place = Case(EXTENDED, norm, h, root, excess)
            paid = sum(
                (
                    (fmpq(3 * i - n, 2) - tube.rate + tube.damping * root / h) * place.at({(i, n): value})
                    for (i, n), value in tube.barrier.items()
                ),
                arb(0),
            )
            assert paid > place.at(sums.source(1 - fall)) * arb("0.9999999")
