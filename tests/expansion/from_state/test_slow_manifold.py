"""The slow manifold of proofs/from_state.md, section 8, in exact rationals beside the raw equations."""

from __future__ import annotations

import random
from dataclasses import dataclass, replace

import pytest
from flint import fmpq, fmpq_mpoly

from gspot_verified.expansion.from_state.affine_system import Affine, AffineSystem, Alpha
from gspot_verified.expansion.from_state.analytic import Analytic
from gspot_verified.expansion.from_state.fast_growth import fast_matrix
from gspot_verified.expansion.from_state.slow_manifold import (
    Cut,
    H,
    L,
    R,
    SlowManifold,
    excess_terms,
    slow_manifold,
    still,
    still_terms,
)
from gspot_verified.expansion.from_state.slow_series import slow_series, terms_of
from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.expansion.series.terms import NumberTerms
from gspot_verified.functions.expressions import Constant, Expression, Variable
from gspot_verified.functions.power_series import SeriesOfFunctions
from gspot_verified.functions.rings import RATIONALS
from tests.expansion.from_state.test_affine_system import BENT, EXTENDED, STEEPER

SYSTEMS = (EXTENDED, BENT, STEEPER)


def manifold_of(system: AffineSystem, order: int = 4, weight: int = 5) -> SlowManifold:
    return slow_manifold(system, Cut(order, fmpq(weight), 2 * system.beta - 2))


def value_at(function: Expression, *state: fmpq) -> fmpq:
    """A rational function of the state."""
    series = SeriesOfFunctions([function], NumberTerms(RATIONALS), RATIONALS)
    series.extend(list(state))
    return fmpq(series[function][0])


def at(polynomial: fmpq_mpoly, *place: fmpq) -> fmpq:
    total = fmpq(0)
    for powers, value in polynomial.to_dict().items():
        for power, base in zip(powers, place, strict=True):
            value = value * base ** int(power)
        total += value
    return total


@dataclass
class Rates:
    """All rates by T at a state with this x, by the chain rule from those of p, b, y, v, z; nothing is left out."""

    manifold: SlowManifold
    h: fmpq
    r: fmpq
    L: fmpq
    x: tuple[fmpq, fmpq, fmpq]

    def __post_init__(self) -> None:
        system = self.manifold.system
        contact, springs, p = self.manifold.contact, system.regularisation, self.r**2
        parts = H * R * self.manifold.u, R**2 * self.manifold.w, R**2 * self.manifold.f
        beside = self.x[0] / self.r, self.x[1], self.x[2] / self.r
        speed, along, phi = (self.at(one) + more for one, more in zip(parts, beside, strict=True))
        rigid = self.at(self.manifold.force) + self.L
        b, force, epsilon = -p * rigid, rigid + along / p, self.h * self.r**3 / system.a
        height = (phi - force - contact.lag / contact.rate * speed) / contact.kappa
        assert along == b + p * force
        alphas = system.alpha_1, system.alpha_2, system.alpha_3
        whole = p, b, epsilon**2 * height, epsilon * speed
        self.alphas = [value_at(one.expression, *whole) for one in alphas]
        self.p = epsilon * self.alphas[0]
        b_rate = epsilon * (self.alphas[1] - self.alphas[2] * force)
        z = height + force / springs.k_2
        force_rate = springs.k_2 * ((-springs.k_1 * z - force) / springs.c - speed)
        self.r_rate, self.h_rate = self.p / (2 * self.r), -fmpq(3, 2) * self.h * self.p / p
        self.L_rate = fmpq(0)
        self.L_rate = -b_rate / p + b * self.p / p**2 - self.of(self.manifold.force)
        off = (
            along - self.of(parts[0]),
            b_rate + self.p * force + p * force_rate - self.of(parts[1]),
            force_rate + contact.kappa * speed + contact.lag / contact.rate * along - self.of(parts[2]),
        )
        turned = self.r_rate / self.r
        self.x_rate = (
            turned * self.x[0] + self.r * off[0], off[1], turned * self.x[2] + self.r * off[2],
        )  # fmt: skip

    def at(self, polynomial: fmpq_mpoly) -> fmpq:
        return at(polynomial, self.h, self.r, self.L)

    def of(self, polynomial: fmpq_mpoly) -> fmpq:
        """The rate of a polynomial."""
        rates = self.h_rate, self.r_rate, self.L_rate
        return sum((self.at(polynomial.derivative(k)) * rate for k, rate in enumerate(rates)), fmpq(0))

    def matrix(self) -> list[list[fmpq]]:
        """B of the page."""
        contact, h, r = self.manifold.contact, self.h, self.r
        first, second, third = (self.at(one) * h * r for one in self.manifold.feeding)
        rest = -h * r * self.at(self.manifold.fall) / 2
        return [
            [rest, r + first, fmpq(0)],
            [-contact.kappa * r, second, -contact.rate * r],
            [fmpq(0), contact.lag / contact.rate * r + third, rest - contact.rate],
        ]


def with_motion(alpha: Alpha, *slopes: fmpq) -> Analytic:
    """With y, v and p v."""
    p, y, v = Variable(0), Variable(2), Variable(3)
    terms: list[Expression] = [y, v, p * v]
    function = alpha.expression
    for slope, term in zip(slopes, terms, strict=True):
        function = function + Constant(slope) * term
    return Analytic(function, 4, "f")


def drawn(manifold: SlowManifold, count: int) -> list[Rates]:
    draw = random.Random(4)

    def number() -> fmpq:
        return fmpq(draw.randint(-9, 9), draw.randint(5, 20))

    return [
        Rates(
            manifold, abs(number()) + fmpq(1, 99), abs(number()) + fmpq(1, 99), number(), (number(), number(), number())
        )
        for _ in range(count)
    ]


@pytest.mark.parametrize("system", SYSTEMS)
def test_the_fast_deviation_obeys_its_equations_exactly(system: AffineSystem) -> None:
    """x' = B x + e (F_1, F_2, F_3), p' = -h r A_1 p, L' = -h r (S + A_3 x_2/p); not only near the spot."""
    manifold = manifold_of(system)
    for state in drawn(manifold, 20):
        unit, p = state.h * state.r, state.r**2
        fall, back = state.at(manifold.fall), state.at(manifold.back)
        assert (fall, back) == (-state.alphas[0] / system.a, -state.alphas[2] / system.a)
        assert state.p == -unit * fall * p
        assert state.L_rate == -unit * (state.at(manifold.slow) + back * state.x[1] / p)
        for row, residual, rate in zip(state.matrix(), manifold.residual, state.x_rate, strict=True):
            whole = sum((one * x for one, x in zip(row, state.x, strict=True)), unit * p * state.at(residual))
            assert rate == whole


MOVING = [
    replace(
        system,
        alpha_1=with_motion(system.alpha_1, fmpq(3), fmpq(-1, 2), fmpq(2)),
        alpha_2=with_motion(system.alpha_2, fmpq(-1, 3), fmpq(1), fmpq(1, 5)),
        alpha_3=with_motion(system.alpha_3, fmpq(2), fmpq(4), fmpq(-3)),
    )
    for system in (EXTENDED, STEEPER)
]


@pytest.mark.parametrize("system", MOVING)
def test_with_y_and_v_it_is_exact_where_x_is_0(system: AffineSystem) -> None:
    """y = epsilon^2 Y, v = epsilon V are put into the alphas; the rates are the true ones."""
    manifold = manifold_of(system)
    assert system.moves
    for drawn_state in drawn(manifold, 20):
        state = replace(drawn_state, x=(fmpq(0),) * 3)
        unit, p = state.h * state.r, state.r**2
        assert state.at(manifold.fall) == -state.alphas[0] / system.a
        assert state.at(manifold.back) == -state.alphas[2] / system.a
        assert state.L_rate == -unit * state.at(manifold.slow)
        assert state.x_rate == tuple(unit * p * state.at(one) for one in manifold.residual)


@pytest.mark.parametrize("system", [*SYSTEMS, *MOVING])
def test_only_what_was_cut_is_left(system: AffineSystem) -> None:
    """In the residuals over L, in S at L = 0, and in S - (beta - 1 + D) A_1 L."""
    order, weight = 4, 5
    manifold = manifold_of(system, order, weight)
    drift = manifold.slow - still(manifold.slow) - (manifold.beta - 1 + manifold.drift) * manifold.fall * L
    for one in (*manifold.residual, still(manifold.slow), drift):
        terms = excess_terms(one)
        assert terms
        for i, n, k in terms:
            assert i >= order or n + (k - 1) * manifold.mu > weight
            assert n + (k - 1) * manifold.mu >= 0
    for one in (manifold.force, manifold.u, manifold.w, manifold.f):
        assert all(i <= order and n + (k - 1) * manifold.mu <= weight for i, n, k in excess_terms(one))
    assert all(i >= 2 for one in (manifold.w, manifold.f) for i, _, _ in excess_terms(one))
    assert manifold.force == still(manifold.force)


@pytest.mark.parametrize("system", SYSTEMS)
def test_the_reference_holds_whole_powers_of_p_and_e(system: AffineSystem) -> None:
    manifold = manifold_of(system)
    for one in (manifold.force, H * R * manifold.u, manifold.w, manifold.f):
        assert all((n - 3 * i) % 2 == 0 for i, n in still_terms(one))
    assert any(i for i, _ in still_terms(manifold.force))


def test_the_reference_of_the_extended_system() -> None:
    """chi = 1, beta = 3/2: rigid slip has lambda_N = 2 - 8 p + 32 p^2 + ..., and e^2/p = h^2 r^4."""
    manifold = manifold_of(EXTENDED, weight=4)
    assert manifold.force == 2 - 8 * R**2 + 32 * R**4 + 96 * H**2 * R**4
    # -b/p on the rigid slow trajectory: p db/dp = p (alpha_2 - alpha_3 force)/alpha_1 with b = -p force
    force = [still_terms(manifold_of(EXTENDED, weight=12).force).get((0, 2 * k), fmpq(0)) for k in range(6)]
    b = [fmpq(0), *(-one for one in force)]
    beta = EXTENDED.beta
    for k in range(1, 6):
        # alpha_1 b' = alpha_2 + alpha_3 b/p, order p^(k-1): alpha_1 = -1 + b
        left = -k * b[k] + sum((b[j] * (k - j) * b[k - j] for j in range(1, k)), fmpq(0))
        assert left == -fmpq(int(k == 1)) - beta * b[k]


def test_without_slopes_it_is_the_model_system() -> None:
    level = AffineSystem(Affine(fmpq(-4, 5)), Affine(fmpq(-7, 6)), Affine(fmpq(-2)), Regularisation.of(2, 3, "1/2"))
    manifold = manifold_of(level, 4, 40)
    series = slow_series(level.beta, manifold.contact, 4)
    assert manifold.force == level.mean_force
    for found, wanted in zip((H * R * manifold.u, manifold.w, manifold.f), (series.v, series.w, series.f), strict=True):
        assert excess_terms(found) == {(i, n, 1): value for (i, n), value in terms_of(wanted).items()}
    for found, wanted in zip(manifold.residual, series.residual, strict=True):
        assert excess_terms(found) == {(i, n, 1): value for (i, n), value in terms_of(wanted).items()}
    assert fast_matrix(manifold) == fast_matrix(series)
    assert manifold.drift * L == level.beta * manifold.w


@pytest.mark.parametrize("system", SYSTEMS)
def test_the_level_part_is_that_at_no_excess(system: AffineSystem) -> None:
    manifold = manifold_of(system)
    for found, wanted in zip(
        (*manifold.coupling, manifold.level_fall), (*manifold.feeding, manifold.fall), strict=True
    ):
        place = fmpq(2, 7), fmpq(3, 5)
        assert at(found, *place) == at(wanted, *place, fmpq(0))
        assert at(found, *place) != 0


def test_what_is_kept_is_a_matter_of_order_and_weight() -> None:
    cut = Cut(2, fmpq(3), fmpq(1, 2))
    everything = (1 + H + H**2 + H**3) * (1 + R**2 + R**3 + R**4) * (1 + L + L**2 + L**3)
    kept = excess_terms(cut.of(everything)).keys()
    assert kept == {(i, n, k) for i in range(3) for n in (0, 2, 3, 4) for k in range(4) if n + fmpq(k - 1, 2) <= 3}
    assert excess_terms(cut.of(everything, 1)).keys() == {key for key in kept if key[0] < 2}


def test_an_iteration_without_end_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Cut, "rounds", 3)
    with pytest.raises(ArithmeticError, match="should vanish"):
        manifold_of(EXTENDED)
