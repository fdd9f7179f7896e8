"""The side of families near the expansion: what is run is a member of the family, and the text names it."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.numbers.balls import ball, working_bits
from gspot_verified.paper.section_5 import section_5_side as ledger
from gspot_verified.testing import extended_example
from gspot_verified.theta_function.theta import theta

BETA, CHI = fmpq(3, 2), 1


@pytest.mark.parametrize("delta", [fmpq(1, 50), fmpq(1, 200)])
@pytest.mark.parametrize("amount", ledger.AMOUNTS)
def test_a_member_starts_as_the_inner_solution(amount: fmpq, delta: fmpq) -> None:
    """b - b̄ = C_1 κ^-β ε^(2β/3) Θ(-κ) at t = -ε^(2/3), with 2 κ³ = 1; the other variables are the expansion's."""
    scene = ledger.member(amount, delta)
    assert scene.epsilon == delta**3
    assert (scene.parameters["beta"], scene.parameters["chi"]) == (BETA, CHI)
    mean = expand_system(extended_example(chi=CHI, alpha=(-1, -1, "-3/2")), 8).evaluate_in_time(-(delta**2), delta**3)
    with working_bits(96):
        kappa = arb(fmpq(1, 2)).root(3)
        expected = ball(amount) * kappa ** (-ball(BETA)) * ball(delta) ** 3 * theta(-kappa, BETA)
        assert abs(scene.start["b"] - mean["b"] - expected) < abs(expected) / 10**6
        assert abs(scene.start["p"] - mean["p"]) < arb(10) ** -20
        y, z = (scene.start[name] - mean[name] for name in "yz")
        assert abs(y - 2 * z) < arb(10) ** -20


def test_each_run_is_of_its_own_epsilon(monkeypatch: pytest.MonkeyPatch) -> None:
    """They are followed for the same scaled time, and the first event alone counts."""
    scenes: list[Any] = []
    event = ["lift-off", "touch-down"]

    def float_run(scene: Any, *_: Any) -> Any:
        scenes.append(scene)
        return SimpleNamespace(events=[SimpleNamespace(name=name) for name in event])

    monkeypatch.setattr(ledger, "float_run", float_run)
    assert ledger.float_runs_agree(fmpq(-1)) is True
    assert [scene.epsilon for scene in scenes] == [fmpq(1, 125_000), fmpq(1, 8_000_000)]
    assert {scene.until**3 / scene.epsilon**2 for scene in scenes} == {fmpq(25) ** 3}
    assert ledger.float_runs_agree(fmpq(1)) is False
    event.reverse()
    assert ledger.float_runs_agree(fmpq(-1)) is False
    event.clear()
    assert ledger.float_runs_agree(fmpq(-1)) is False


@pytest.mark.parametrize(
    ("name", "value", "step", "holds"),
    [
        ("WEIGHTS", (fmpq(1), fmpq(1, 2)), "barrier_is_positive", True),
        ("WEIGHTS", (fmpq(1), fmpq(1, 7)), "barrier_is_positive", True),
        ("WEIGHTS", (fmpq(1), fmpq(1, 8)), "barrier_is_positive", False),
        ("WEIGHTS", (fmpq(1), fmpq(5, 8)), "barrier_is_positive", False),
        ("WEIGHTS", (fmpq(7, 2), fmpq(1, 2)), "barrier_is_positive", False),
        ("DECAY", fmpq(1, 4), "barrier_is_positive", False),
        ("EXCESS", fmpq(0), "barrier_is_positive", False),
        ("CONE", (fmpq(1, 2), fmpq(3, 4)), "cone_is_kept", True),
        ("CONE", (fmpq(3, 4), fmpq(1, 2)), "cone_is_kept", False),
        ("CONE", (fmpq(1, 2), fmpq(1)), "cone_is_kept", False),
    ],
)
def test_the_steps_of_the_rule(monkeypatch: pytest.MonkeyPatch, name: str, value: Any, step: str, holds: bool) -> None:
    """proofs/papers_rule.md, Lemma R1 and section 6."""
    monkeypatch.setattr(ledger, name, value)
    assert getattr(ledger, step)() is holds


def test_the_rule_between_two_integers() -> None:
    """Γ(-β) < 0 for β in (2, 3): C_1 > 0 has the event of C_1/Γ(-β) < 0."""
    assert all(ledger.rule_is_the_printed_one(beta) for beta in ledger.RULE_BETAS)
    assert {int(beta.p // beta.q) for beta in ledger.RULE_BETAS} == set(range(1, 9))
    assert ledger.rule_is_the_printed_one(arb(2, fmpq(1, 2))) is None


def test_the_side_by_the_rule(monkeypatch: pytest.MonkeyPatch) -> None:
    """C_1/Γ(-3/2) > 0 for C_1 > 0."""
    assert [ledger.expected(fmpq(n)) for n in (-2, 2)] == ["lift-off", "impact without collision"]
    monkeypatch.setattr(ledger, "gamma_sign", lambda _: None)
    assert ledger.expected(fmpq(1)) is None


@pytest.mark.parametrize("side", ["lift-off", "impact"])
def test_what_is_proved_is_compared_with_the_rule(monkeypatch: pytest.MonkeyPatch, side: str) -> None:
    for outcome in ledger.Outcome:
        found = SimpleNamespace(side=side, verdict=SimpleNamespace(outcome=outcome), entered=None)
        monkeypatch.setattr(ledger, "side_of", lambda _, found=found: found)
        answers = [ledger.is_as_expected(fmpq(n)) for n in (-1, 1)]
        proved = [side == "lift-off", side == "impact"]
        assert answers == (proved if outcome is ledger.Outcome.PROVED else [None, None])
        assert ledger._latest(fmpq(1)) == "nothing is proved"


def test_the_statement_names_what_is_checked(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ledger, "float_runs_agree", lambda _: True)
    entry = ledger.ENTRIES["5-side"]()
    assert "χ = 1, β = 3/2, for every ε <= 1/125000 at once: all states whose scaled ξ" in entry.statement
    assert "λ_N + y/2 are within 1/1000 ε^(1/3)" in entry.statement
    assert "expansion of order 8" in entry.statement
    assert "past 10 times the mean force" in entry.statement
    assert "at ε = 1/125000 and 1/8000000" in entry.checks[1].what
