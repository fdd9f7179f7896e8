"""From a state to its fate with affine alphas (proofs/from_state.md, section 8), beside runs in high precision."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest
from flint import arb, fmpq

from gspot_verified.expansion.from_state.affine_side import AffineSide, affine_side
from gspot_verified.expansion.from_state.affine_system import Affine, AffineSystem
from gspot_verified.expansion.from_state.affine_tube import AffineStart, AffineTube, affine_tube
from gspot_verified.expansion.from_state.fast_growth import Norm, Rectangle, fast_growth
from gspot_verified.expansion.from_state.slow_series import Contact, slow_series
from gspot_verified.expansion.series.regularisation import PAPER
from gspot_verified.numbers.balls import ball, working_bits
from gspot_verified.numbers.verdict import Outcome
from tests.expansion.from_state.test_affine_system import EXTENDED
from tests.witnesses.stiff_contact import StiffContact, at_rest, fate

P, TENTH, RATIO = fmpq(1, 100), fmpq(1, 10), fmpq(3, 2)
ALPHAS = [[fmpq(-1), fmpq(0), fmpq(1)], [fmpq(-1), fmpq(0), fmpq(0)], [fmpq(-3, 2), fmpq(0), fmpq(0)]]


def place_of(excess: fmpq, p: fmpq = P) -> fmpq:
    """b at p with this L."""
    return -p * (EXTENDED.mean_force + EXTENDED.tilt * p + excess)


@cache
def found_from(excess: fmpq) -> AffineSide:
    return affine_side(EXTENDED, P, place_of(excess))


@pytest.mark.slow
@pytest.mark.parametrize(("excess", "side"), [(fmpq(1, 2), "lift-off"), (fmpq(-1, 2), "impact")])
def test_the_side_is_that_of_runs_at_several_epsilon(excess: fmpq, side: str) -> None:
    found = found_from(excess)
    assert found.verdict.outcome is Outcome.PROVED
    assert found.side == side
    assert found.epsilon > fmpq(1, 10**13)
    for factor in (1, 10, 1000):
        ended, last = fate(StiffContact(ALPHAS, found.epsilon / factor), at_rest(P, found.start.b), 20)
        assert ended == side
        assert last[0] < 0


@cache
def tube_at(delta: fmpq, excess: fmpq) -> tuple[AffineStart, AffineTube]:
    series = slow_series(EXTENDED.beta, Contact.of(PAPER), 4, EXTENDED.slopes)
    norm, start = Norm(series, fmpq(8, 5), fmpq(12, 25)), AffineStart(EXTENDED, P, place_of(excess), fmpq(1, 100))
    rectangle = Rectangle(fmpq(1, 8), fmpq(1, 10))
    growth = fast_growth(norm, rectangle, fmpq(1, 20), fmpq(1, 10))
    tube = affine_tube(start, norm, growth, rectangle, delta**3, fmpq(1, 10), fmpq(3, 2))
    assert isinstance(tube, AffineTube), tube
    return start, tube


@cache
def run_to(delta: fmpq, excess: fmpq) -> list[arb]:
    """(p, b, Y, V, Z) at the first step with p < 4.6 epsilon^(2/3)."""
    contact = StiffContact(ALPHAS, delta**3)
    return contact.run(at_rest(P, place_of(excess)), lambda u: bool(u[0] < arb("4.6") * arb(delta) ** 2))


@pytest.mark.parametrize("excess", [fmpq(1, 2), fmpq(-1, 2)])
def test_a_run_stays_in_the_tube_and_c_1_moves_as_said(excess: fmpq) -> None:
    """At p = 4 epsilon^(2/3): |x_2| = |W - p w L| <= c_W z p |L|, and C within the drift of its carried value."""
    delta = fmpq(1, 20000)
    with working_bits(128):
        start, tube = tube_at(delta, excess)
        p, b, y, _, z = run_to(delta, excess)
        series = slow_series(EXTENDED.beta, Contact.of(PAPER), 4, EXTENDED.slopes)
        off = -b / p - EXTENDED.mean_force - EXTENDED.tilt * p
        h, r = arb(delta**3) / p ** arb("1.5"), p.sqrt()
        w = sum((ball(value) * h**i * r**n for (i, n), value in series.w.to_dict().items()), arb(0))
        beyond = abs((b + p * (z - y)) / p - w * off) / abs(off)
        assert beyond < tube.shares[1] * tube.bound(h, r)
        assert beyond > tube.shares[1] * tube.bound(h, r) / 10**5
        moved = (-off * p ** arb("-0.5") / start.coefficient).log()
        # A = -5: p d log C/dp = beta w - 5 p + ...; w = (1/2) h^2 + ...
        slow = -5 * (p - arb(P)) - fmpq(3, 2) * arb(1) / 2 * h**2 / 3
        assert abs(moved - slow) < tube.drift + arb("0.005")
        assert abs(moved) > arb("0.01")


def test_a_tube_needs_each_of_its_inequalities() -> None:
    """Larger epsilon, a start farther away, a smaller factor: each is refused with its reason."""
    series = slow_series(EXTENDED.beta, Contact.of(PAPER), 4, EXTENDED.slopes)
    norm, rectangle = Norm(series, fmpq(8, 5), fmpq(12, 25)), Rectangle(fmpq(1, 8), fmpq(1, 10))
    growth = fast_growth(norm, rectangle, fmpq(1, 20), fmpq(1, 10))

    def tried(excess: fmpq, e: fmpq, largest: fmpq = TENTH, ratio: fmpq = RATIO) -> AffineTube | str:
        return affine_tube(
            AffineStart(EXTENDED, P, place_of(excess), fmpq(1, 100)), norm, growth, rectangle, e, largest, ratio
        )

    small, half = fmpq(1, 20000) ** 3, fmpq(1, 2)
    with working_bits(128):
        assert isinstance(tried(half, small), AffineTube)
        assert "barrier" in str(tried(half, small, fmpq(1, 100)))
        assert "the layer falls" in str(tried(half, fmpq(1, 2000)))
        assert isinstance(tried(half, fmpq(1, 1000)), str)  # the hand-over lies before the start
        assert "log C_1 moves" in str(tried(half, small, ratio=fmpq(101, 100)))
        assert "the force stays positive" in str(tried(fmpq(-3, 2), small))
        level = slow_series(EXTENDED.beta, Contact.of(PAPER), 4)
        with pytest.raises(ValueError, match="another system"):
            affine_tube(
                AffineStart(EXTENDED, P, place_of(half), half),
                replace(norm, series=level),
                growth,
                rectangle,
                small,
                half,
                half,
            )


def test_from_far_away_it_is_undecided_and_says_why() -> None:
    found = affine_side(EXTENDED, "1/5", place_of(fmpq(1, 2), fmpq(1, 5)))
    assert found.side is None
    assert found.verdict.outcome is Outcome.UNDECIDED
    assert "Theorem B'" in found.verdict.detail


@pytest.mark.slow
def test_without_slopes_it_is_the_model_system() -> None:
    """epsilon_0 of both lie within a factor of 3: the same theorem with other free choices."""
    level = AffineSystem(Affine(fmpq(-1)), Affine(fmpq(-1)), Affine(fmpq(-3, 2)), PAPER)
    found = affine_side(level, "1/2", -2)
    assert found.side == "lift-off"
    assert fmpq(64, 185193) / 3 < found.epsilon < fmpq(64, 185193) * 3
