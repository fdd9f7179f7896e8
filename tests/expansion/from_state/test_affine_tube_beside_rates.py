"""(15), (16) of proofs/from_state.md: the sums beside rates from the raw equations."""

from __future__ import annotations

import random
from dataclasses import replace

import pytest
from flint import arb, arb_mat, fmpq, fmpq_mpoly

from gspot_verified.expansion.from_state.affine_system import Affine, AffineSystem
from gspot_verified.expansion.from_state.affine_tube import ExcessBounds, Sums, _Path
from gspot_verified.expansion.from_state.analytic import Analytic
from gspot_verified.expansion.from_state.barrier import value_of
from gspot_verified.expansion.from_state.fast_growth import Norm, Rectangle, fast_matrix
from gspot_verified.expansion.from_state.slow_manifold import Cut, slow_manifold
from gspot_verified.expansion.from_state.slow_series import change
from gspot_verified.expansion.series.regularisation import PAPER, Regularisation
from gspot_verified.functions.expressions import Constant, Power, Sum, Variable
from gspot_verified.numbers.balls import ball, working_bits
from tests.expansion.from_state.test_affine_side import RATIO, tube_at
from tests.expansion.from_state.test_slow_manifold import Rates, at

THETA = fmpq(1, 10)
P, B, Y, V = (Variable(i) for i in range(4))


def states(count: int, kind: str) -> list[Rates]:
    """States of random systems, the fast deviation 10^-4 to 1 times p L; "bent": the alphas are cubic functions, of
    which the slow manifold knows the affine parts; "moving": y and v occur, too, and z is below 1."""
    draw, found = random.Random(5), list[Rates]()

    def slope() -> fmpq:
        return fmpq(draw.randint(-40, 40), 20)

    def alpha(value: fmpq) -> Affine | Analytic:
        affine = Affine(value, slope(), slope())
        if kind == "affine":
            return affine
        if kind == "moving":
            y, v = Constant(1000 * slope()) * Y, Constant(200 * slope()) * V
            squares = Constant(200 * slope()) * V * P, Constant(100 * slope()) * V * V
            return Analytic(Sum((affine.expression, y, v, *squares)), 4, "a function that moves")
        more = [Constant(slope()) * Power(P, fmpq(j)) * Power(B, fmpq(k)) for j, k in ((2, 0), (1, 1), (0, 2), (2, 1))]
        return Analytic(Sum((affine.expression, *more)), 2, "a cubic function")

    while len(found) < count:
        beta, a = fmpq(draw.randint(21, 79), 20), fmpq(draw.randint(1, 4), 2)
        if beta.q == 1:
            continue
        first, second = alpha(-a), alpha(-fmpq(draw.randint(2, 4), 2))
        springs = draw.choice((PAPER, Regularisation.of(2, 3, "1/2")))
        system = AffineSystem(first, second, alpha(-a * beta), springs)
        cut = Cut(draw.choice((2, 4)), fmpq(draw.choice((1, 3, 5))), 2 * beta - 2)
        manifold = slow_manifold(system, cut)
        for _ in range(5):
            h, r = fmpq(draw.randint(1, 100), draw.choice((500, 5000))), fmpq(draw.randint(1, 40), 200)
            excess = draw.choice((-1, 1)) * fmpq(draw.randint(1, 9), 10 ** draw.randint(0, 3)) * system.mean_force
            size = abs(excess) * r**2 / 10 ** draw.randint(int(kind == "moving"), 4)
            x = [size * fmpq(draw.randint(-100, 100), 100), size * fmpq(draw.randint(-100, 100), 100)]
            found.append(Rates(manifold, h, r, excess, (x[0], x[1], size * fmpq(draw.randint(-9, 9), 500))))
    return found


def sums_at(state: Rates, norm: Norm) -> tuple[Sums, ExcessBounds] | None:
    """The way from p_1 to the hand-over is this point alone, and L is known."""
    rectangle = Rectangle(state.h, state.r)
    shares, root = norm.shares(rectangle), ball(state.r)
    if shares is None:
        return None
    size = abs(ball(state.L)) / root ** ball(state.manifold.mu)
    excess = ExcessBounds.around(state.manifold.mu, size.upper(), size.lower())
    path = _Path(rectangle, state.r**2, state.h * state.r**3)
    sums = Sums(norm, state.manifold, shares, excess, path, state.r**2)
    return (sums, excess) if sums.fall < fmpq(9, 10) else None


def compared(kind: str) -> tuple[int, bool, arb, arb]:
    """How many states, whether all are below their bounds, and the largest shares of these that are reached.

    -p dz/dp and p d log|C|/dp by the chain rule; in the place of Lemma 1 stands the growth of the very x, so that
    nothing but the terms of section 8 is left between the two sides."""
    sharpest, sharpest_drift, count = arb(-1), arb(0), 0
    below = True
    with working_bits(160):
        for state in states(300, kind):
            norm = Norm(state.manifold, fmpq(8, 5), fmpq(1, 2))
            known = sums_at(state, norm)
            if known is None or not any(state.x):
                continue
            count += 1
            sums, h, r, p = known[0], ball(state.h), ball(state.r), ball(state.r**2)

            def level(entries: list[list[fmpq_mpoly]], state: Rates = state) -> arb_mat:
                return arb_mat([[ball(at(one, state.h, state.r)) for one in row] for row in entries])

            gram, field, turn = level(norm.matrix), level(fast_matrix(state.manifold)), norm.matrix
            fall = state.manifold.level_fall
            moving = level([[fall * change(one) for one in row] for row in turn])
            x, rate = (arb_mat([[ball(one)] for one in column]) for column in (state.x, state.x_rate))
            square = (x.transpose() * gram * x)[0, 0]
            z = square.sqrt() / (p * abs(ball(state.L)))
            grown = (x.transpose() * (gram * field + field.transpose() * gram + moving) * x)[0, 0]
            growth = grown / (2 * square * h * r)
            by_h, by_r = (level([[one.derivative(k) for one in row] for row in norm.matrix]) for k in (0, 1))
            true = by_h * ball(state.h_rate) + by_r * ball(state.r_rate)
            whole = (rate.transpose() * gram * x)[0, 0] * 2 + (x.transpose() * true * x)[0, 0]
            log_rate = whole / (2 * square) - ball(state.p) / p - ball(state.L_rate) / ball(state.L)
            changed = -p * z * log_rate / ball(state.p)
            rate_bound = sums.rate(growth + THETA * r / h, z.upper())
            bound = (rate_bound - THETA / (1 + sums.fall) * r / h) * z + value_of(sums.source, h, r)
            below = below and bool(changed <= bound)
            if bound > 0:
                sharpest = sharpest.max(changed / bound)
            creep = p * ball(state.L_rate) / (ball(state.L) * ball(state.p)) + 1 - ball(state.manifold.beta)
            moved = abs(creep - ball(state.at(state.manifold.drift)))
            most = value_of(sums.stray, h, r) + sums.pushed * z
            below = below and bool(moved <= most)
            sharpest_drift = sharpest_drift.max(moved / most)
    return count, below, sharpest, sharpest_drift


@pytest.mark.parametrize(("kind", "least"), [("affine", "0.6"), ("bent", "0.4"), ("moving", "0.2")])
def test_z_and_c_change_by_no_more_than_the_sums_from_the_raw_equations(kind: str, least: str) -> None:
    count, below, sharpest, sharpest_drift = compared(kind)
    assert count > 150
    assert below
    assert sharpest > arb(least)
    assert sharpest_drift > arb("0.9")


def test_without_what_the_polynomials_leave_the_sums_are_too_small(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Analytic, "rest", lambda *_: {})
    assert not compared("bent")[1]


def shares_of_moved_alphas() -> list[arb]:
    """How far A_1 and A_3 are from their polynomials with y, v of the slow manifold, over their bounds."""
    found = list[arb]()
    with working_bits(160):
        for state in states(150, "moving"):
            known = sums_at(state, Norm(state.manifold, fmpq(8, 5), fmpq(1, 2)))
            if known is None:
                continue
            left, manifold, a = known[0]._left, state.manifold, state.manifold.system.a
            for bounds, own, true in (
                (left.fall, manifold.fall, -state.alphas[0] / a),
                (left.back, manifold.back, -state.alphas[2] / a),
            ):
                found.append(abs(ball(true - state.at(own))) / value_of(bounds, ball(state.h), ball(state.r)))
    return found


def test_what_moves_y_and_v_moves_the_alphas_within_the_bound(monkeypatch: pytest.MonkeyPatch) -> None:
    shares = shares_of_moved_alphas()
    assert len(shares) > 100
    assert all(share <= 1 for share in shares)
    assert any(share > arb("0.02") for share in shares)
    monkeypatch.setattr(Analytic, "moved", lambda *_: ({}, {}))
    assert not all(share <= 1 for share in shares_of_moved_alphas())


def test_the_barrier_pays_every_source_on_the_way() -> None:
    """-p dZ/dp >= (Gamma - theta' r/h) Z + F' along the path of the extended system."""
    delta = fmpq(1, 1000)
    with working_bits(128):
        given, tube = tube_at(delta, fmpq(1, 2))
        norm = Norm(given.manifold, fmpq(8, 5), fmpq(12, 25))
        sums = Sums(norm, given.manifold, tube.shares, tube.excess, _Path(tube.rectangle, given.p, delta**3), given.p)
        assert tube.rate >= sums.rate(ball(fmpq(1, 20)), ball(fmpq(1, 10)))
        assert tube.damping <= (ball(THETA) / (1 + sums.fall)).upper()
        source = sums.source
        for p in (given.p, given.p / 10, fmpq(40) * delta**2, fmpq(16) * delta**2, fmpq(4) * delta**2):
            root = ball(p).sqrt()
            h = delta**3 / root**3
            paid = sum(
                ((fmpq(3 * i - n) / 2 - tube.rate + tube.damping * root / h) * value_of({(i, n): value}, h, root)
                 for (i, n), value in tube.barrier.items()), arb(0),
            )  # fmt: skip
            assert paid > value_of(source, h, root) * arb("0.9999999")
        assert tube.excess.largest > tube.excess.least * RATIO
        assert replace(tube, barrier={}).bound(arb(fmpq(1, 9)), arb(0)) < tube.bound(arb(fmpq(1, 9)), arb(fmpq(1, 99)))
