"""Theorem A' (``proofs/paper_runs.md``): its steps against values of the compliant force, and its hypotheses."""

from __future__ import annotations

from itertools import pairwise
from types import SimpleNamespace

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.fast.fast_part import fast_part
from gspot_verified.compliant.fast.fast_solutions import oscillating
from gspot_verified.compliant.model.normal_form import compliant_model, compliant_state, deviation
from gspot_verified.compliant.motion.compliant_force import force
from gspot_verified.compliant.slow.slow_coefficient import slow_coefficient
from gspot_verified.compliant.slow.slow_solution import slow_value
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.numerics import paper_runs
from gspot_verified.paper.numerics.paper_runs import (
    CANDIDATES,
    START,
    least_share,
    margin_up_to,
    paper_run,
    sizes_up_to,
)
from gspot_verified.paper.numerics.paper_state import paper_state

BETAS = (fmpq(1, 2), fmpq(3, 2), fmpq(5, 2))
FACTORS = (fmpq(1, 4), fmpq(1, 2), fmpq(1), fmpq(2), fmpq(4))
FATES = {
    fmpq(1, 2): ("impact",) * 5,
    fmpq(3, 2): ("impact", "impact", "trivial", "lift-off", "lift-off"),
    fmpq(5, 2): ("lift-off", "lift-off", "trivial", "impact", "impact"),
}


def run(beta: fmpq, nu: fmpq, epsilon: fmpq):
    model = compliant_model(beta, epsilon)
    b = -nu * START * abs(model.mean_force)
    y = 2 * b * epsilon**2 / START
    return model, compliant_state(START, b, y, 0, y / 2)


@pytest.mark.parametrize("beta", BETAS)
def test_the_fifteen_runs(beta: fmpq) -> None:
    for nu, fate in zip(FACTORS, FATES[beta], strict=True):
        found = paper_run(beta, nu)
        assert found.fate == fate
        assert found.verdict.outcome is Outcome.PROVED
        if fate != "trivial":
            assert found.epsilon_0 >= (fmpq(1, 100) if beta < 2 else fmpq(1, 500))
            assert found.margin > 0


@pytest.mark.parametrize("beta", BETAS)
def test_the_force_stays_above_the_margin(beta: fmpq) -> None:
    for nu, fate in zip(FACTORS, FATES[beta], strict=True):
        if fate == "trivial" or (fate == "lift-off" and nu > 2):
            continue
        largest = paper_run(beta, nu).epsilon_0
        margin = margin_up_to(beta, nu, largest)
        for epsilon in (largest, largest / 3)[: 2 if nu == FACTORS[0] else 1]:
            model, state = run(beta, nu, epsilon)
            for place in (START, START / 2, fmpq(0), -epsilon if fate == "impact" else START / 10):
                value = force(model, state, -place, digits=6).force
                assert value > margin * abs(model.mean_force)


def test_the_share_of_the_start_in_the_force() -> None:
    beta, largest = BETAS[0], fmpq(1, 100)
    least = least_share(beta, largest)
    assert least is not None
    assert 0 < least < 1
    for alpha_2, nu in ((fmpq(1), fmpq(2)), (fmpq(3), fmpq(99, 100)), (fmpq(-1), fmpq(4))):
        model = compliant_model(beta, largest / 3, alpha_2=alpha_2)
        state = paper_state(model, nu)
        first = deviation(model, state).force
        for place in (START, START / 3, fmpq(0), -largest / 3):
            share = (force(model, state, -place, digits=6).force - model.mean_force) / first
            assert share > least
    assert least_share(BETAS[1], largest) is None
    assert least_share(beta, fmpq(1, 2)) is None
    with working_bits(64):
        margin = margin_up_to(beta, fmpq(4), largest)
        assert margin is not None
        assert (5 * least - 1).overlaps(margin)


@pytest.mark.parametrize("beta", BETAS)
def test_the_fast_part_is_below_its_size(beta: fmpq) -> None:
    largest = fmpq(1, 500)
    with working_bits(64):
        sizes = sizes_up_to(beta, largest)
    assert sizes is not None
    for epsilon in (largest, largest / 2):
        hats = deviation(*run(beta, fmpq(2), epsilon))
        for p in (START, START * 99 / 100, START / 3, fmpq(0)):
            value = fast_part(hats, p, ("force",), 30)["force"]
            assert value.is_finite()
            assert abs(value / hats.force) < sizes.fast


@pytest.mark.parametrize("beta", BETAS)
def test_slow_and_fast_parts_are_one_at_the_start(beta: fmpq) -> None:
    hats = deviation(*run(beta, fmpq(4), fmpq(1, 100)))
    with working_bits(120):
        # C = epsilon (b/p) H, and the slow force is -(C/epsilon) F_b.
        slow = (
            -slow_coefficient(hats, 90) / hats.epsilon * slow_value(hats.time, beta - 1, hats.epsilon, digits=25).value
        )
        assert slow / hats.force > 0
        total = slow + fast_part(hats, START, ("force",), 90)["force"]
        assert abs(total - hats.force) < arb(10) ** -18


@pytest.mark.parametrize("c", [fmpq(-1, 2), fmpq(-9, 10), fmpq(-1, 10)])
def test_the_oscillating_solution_after_the_g_spot(c: fmpq) -> None:
    # |P_+^(c)(T)| <= 2.31 Gamma(-c) F_c(T): weight r^(-c-1) is that of beta = c + 1 with the multiplier r.
    for epsilon in (fmpq(1), fmpq(1, 100)):
        for p in (fmpq(0), fmpq(-1, 20)):
            waves, height = oscillating(c + 1, epsilon, p, ("force",), 40)
            with working_bits(80):
                size = abs(waves[0]) * height.exp() * epsilon * (c + 1)
                slow = slow_value(-p / epsilon, c, epsilon, digits=15).value
                assert size < fmpq(231, 100) * arb(-c).gamma() * slow


def test_the_bounds_fall_with_epsilon() -> None:
    for beta in BETAS:
        with working_bits(64):
            found = [sizes_up_to(beta, largest) for largest in CANDIDATES]
        kept = [sizes for sizes in found if sizes is not None]
        assert len(kept) >= 9
        for first, second in pairwise(kept):
            assert second.fast < first.fast
            assert second.ratio < first.ratio


def test_where_no_proof_is_found() -> None:
    assert margin_up_to(fmpq(5, 2), fmpq(2), fmpq(1, 10)) is None
    assert paper_run(fmpq(3, 2), fmpq(1000)).verdict.outcome is Outcome.UNDECIDED
    with pytest.raises(ValueError, match="no integer"):
        paper_run(fmpq(2), fmpq(1))
    with pytest.raises(TypeError, match="verdict"):
        bool(paper_run(fmpq(1, 2), fmpq(1)))


def test_the_share_is_that_of_the_page(monkeypatch: pytest.MonkeyPatch) -> None:
    """w = min(1 - 2 Φ, (1 - κ)(1 - Φ) - q) of given sizes; without κ < 1, Φ < 1/2 or β < 1 there is none."""
    beta, largest, unknown = fmpq(1, 2), fmpq(1, 100), arb(fmpq(1, 2), fmpq(1, 10))

    def share(ratio: arb, fast: arb, late: arb) -> arb | None:
        sizes = SimpleNamespace(ratio=ratio, fast=fast, late=late)
        monkeypatch.setattr(paper_runs, "sizes_up_to", lambda *_: sizes)
        assert paper_runs.least_share(fmpq(1), largest) is None
        return paper_runs.least_share(beta, largest)

    for ratio, fast, late, expected in (
        (1, 2, 3, 0.42),
        (4, 1, 2, 0.34),
        (2, 3, 1, 0.4),
        (2, 4, 1, 0.2),
        (1, 1, 3, 0.51),
    ):
        value = share(*(arb(fmpq(x, 10)) for x in (ratio, fast, late)))
        assert value is not None
        assert abs(value - arb(expected)) < arb(10) ** -12
    small = arb(fmpq(1, 10))
    for ratio, fast in (
        (arb(1), small),
        (arb(3) / 2, small),
        (small, arb(1) / 2),
        (small, arb(3) / 4),
        (small, unknown),
    ):
        assert share(ratio, fast, small) is None
    assert share(arb("nan"), small, small) is None
    monkeypatch.setattr(paper_runs, "sizes_up_to", lambda *_: None)
    assert paper_runs.least_share(beta, largest) is None
