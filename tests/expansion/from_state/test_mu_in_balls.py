"""What proofs/from_state.md, section 8, "In balls", does where mu, or a coefficient, is in a ball: by hand."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import nullcontext
from dataclasses import replace
from types import SimpleNamespace

import pytest
from flint import arb, arb_poly, fmpq, fmpq_poly

from gspot_verified.expansion.from_state.affine_hand_over import _beside, _in_delta, _over
from gspot_verified.expansion.from_state.affine_tube import AffineStart, ExcessBounds, affine_tube
from gspot_verified.expansion.from_state.barrier import value_of
from gspot_verified.expansion.from_state.fast_growth import Growth, Norm, Rectangle
from gspot_verified.expansion.from_state.slow_manifold import RING, Cut, H, L, R, slow_manifold
from gspot_verified.expansion.series.regularisation import PAPER
from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.functions.ball_polynomials import ball_polynomial
from gspot_verified.numbers.balls import ball, working_bits
from gspot_verified.numbers.evidence import less
from tests.expansion.from_state.test_affine_hand_over import DELTA, STEEP, equations
from tests.expansion.from_state.test_slow_manifold_in_balls import in_balls

WIDE = arb(1, 0.125)
"""mu."""
ENDS = (fmpq(7, 8), fmpq(1), fmpq(9, 8))
LARGEST, LEAST = arb(3), arb(2)


@pytest.fixture(autouse=True)
def _bits() -> Iterator[None]:
    with working_bits(192):
        yield


def test_exponents_hold_mu() -> None:
    excess = ExcessBounds.around(WIDE, LARGEST, LEAST)
    assert excess.low <= ENDS[0]
    assert ENDS[-1] <= excess.high
    assert excess.high - excess.low < fmpq(1, 4) + fmpq(1, 2**25)


@pytest.mark.parametrize("mu", ENDS)
@pytest.mark.parametrize("r", [fmpq(1, 10), fmpq(1, 2), fmpq(1)])
def test_powers_of_the_excess_are_bounded_for_every_mu(mu: fmpq, r: fmpq) -> None:
    """h^2 r^5 L^k over L^m at the largest and at the least size of L."""
    excess = ExcessBounds.around(WIDE, LARGEST, LEAST)
    h = arb(fmpq(1, 3))
    for power, over in ((1, 0), (2, 0), (0, 1), (0, 2), (3, 1), (1, 1)):
        bound = value_of(excess.of(H**2 * R**5 * L**power, over), h, ball(r))
        for size in (LARGEST, LEAST):
            value = h**2 * ball(r) ** 5 * (size * ball(r) ** ball(mu)) ** (power - over)
            assert not value > bound
            assert bound.is_finite()


def test_where_mu_is_a_ball_p_is_at_most_1() -> None:
    """r^mu lies between r^low and r^high there; beyond 1 the other way round."""
    manifold = slow_manifold(in_balls(PAPER), Cut(1, fmpq(1), fmpq(83, 100)))
    norm, growth = Norm(manifold, fmpq(1), fmpq(1, 2)), Growth(fmpq(1), fmpq(1), less(0, 1), 1, "")
    rectangle = Rectangle(fmpq(1, 9), fmpq(2))
    for p, refused in ((fmpq(1), False), (1 + fmpq(1, 10**9), True)):
        given = AffineStart(manifold, p, fmpq(-1), fmpq(1, 100))
        with pytest.raises(ValueError, match="at most 1 where beta") if refused else nullcontext():
            affine_tube(given, norm, growth, rectangle, fmpq(1, 10**9), fmpq(1, 2), fmpq(2))


def test_what_is_below_mu_is_left_out_only_where_it_may_vanish() -> None:
    one, around_0 = equations(STEEP), arb(0, fmpq(1, 10**30))
    for power, least in ((fmpq(3), arb(2)), (arb("2.99999", 1e-6), 2 * ball(DELTA) ** ball(fmpq(11, 10**6)))):
        value = _over(one, arb_poly([around_0, 0, around_0, 2]), power)
        assert value is not None
        assert least.lower() <= value.rad() < arb("2.00002")
    for other in (arb(1, 0.5), arb("nan"), arb.pos_inf()):
        assert _over(one, arb_poly([around_0, other, 0, 2]), fmpq(3)) is None
        assert _over(one, arb_poly([other, 0, 0, 2]), arb(2, 0.5)) is None


def test_what_is_not_certainly_below_mu_is_not_left_out() -> None:
    """The order 3 where mu may be 3: nothing is said."""
    one = equations(STEEP)
    assert _over(one, arb_poly([0, 0, 0, arb(0, fmpq(1, 10**30))]), arb(3, fmpq(1, 10**6))) is None


def test_a_number_that_is_not_finite_gives_no_bound() -> None:
    found = _over(equations(STEEP), arb_poly([0, 0, 0, arb("nan")]), fmpq(3))
    assert found is None or not found.is_finite()


def test_negative_powers_of_p_are_left_out_only_where_they_may_vanish() -> None:
    """h^2 r^4 = e^2/p."""
    p = fmpq_poly([0, 0, 1])
    for value, left_out in ((arb(0, fmpq(1, 10**20)), True), (arb(1, 0.5), False)):
        found = _in_delta(ball_polynomial(RING, {(2, 4, 0): value, (0, 2, 0): arb(1, 0.25)}), p, fmpq(1))
        assert (found is not None) is left_out
        if left_out:
            assert found[2].contains(arb(1, 0.25))


def test_the_hypotheses_of_lemma_t_are_asked() -> None:
    """All else as it was where they hold: order 3, mu = 0.83, Theorem 1 to order 8."""
    system = in_balls(PAPER, fmpq(1, 10**40))
    found = DeviationEquations(expand_system(system.system(), 8), DELTA)
    manifold = slow_manifold(system, Cut(3, fmpq(5), fmpq(83, 100)))
    assert _beside(found, manifold, fmpq(5)) is not None
    for cut in (
        replace(manifold.cut, order=0),
        replace(manifold.cut, weight=fmpq(4, 10), mu=fmpq(4, 10)),
    ):
        assert _beside(found, replace(manifold, cut=cut), fmpq(5)) is None
    enough = replace(manifold.cut, order=1, weight=fmpq(43, 100), mu=fmpq(4, 10))
    assert _beside(found, replace(manifold, cut=enough), fmpq(5)) is not None
    theorem_1 = found.trajectory
    for order in (1, 2):
        found.trajectory = SimpleNamespace(order=order, terms=theorem_1.terms)  # type: ignore[assignment]
        assert (_beside(found, manifold, fmpq(5)) is None) is (order == 1)


def test_delta_is_what_the_bounds_are_for() -> None:
    assert equations(STEEP).exact_delta == DELTA
