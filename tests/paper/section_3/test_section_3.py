"""The sides of the simulations: what is stated is what is checked, and each condition of an impact is."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.motion.run import ONE_FLIGHT
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.claims import paper_claims
from gspot_verified.paper.section_3 import after_lift_off, section_3, varsim1

BETA = fmpq(3, 2)


def forces(*values: int) -> section_3.Forces:
    return lambda _: tuple(map(arb, values))


def test_the_statement_names_what_is_checked() -> None:
    entry = section_3.ENTRIES["3-sides"]()
    lower, higher = section_3.IMPACT["printed"]
    assert entry.statement == (
        f"At ε = {section_3.EPS}, of the starts ν = {', '.join(map(str, section_3.FACTORS))}, those with b(0) below "
        f"that of the trivial solution take an impact without a lift-off before it for β = {lower}, and those with "
        f"b(0) above it for β = {higher}"
    )
    assert section_3.IMPACT["printed"] == {lower: -1, higher: 1}
    assert section_3.IMPACT["corrected"] == {lower: 1, higher: -1}
    assert f"until {section_3.END} after" in entry.checks[0].what
    assert [section_3.mean_force(beta) for beta in (lower, higher)] == [2, fmpq(2, 3)]


def test_the_corrected_sides_are_the_proved_fates() -> None:
    """That a start takes an impact is no part of the checks: the note names the entries that show it."""
    note = section_3.ENTRIES["3-sides"]().note
    for beta, side in section_3.IMPACT["corrected"].items():
        for nu in section_3.FACTORS:
            takes_impact = (1 if nu < 1 else -1) == side
            assert varsim1.FATES[beta][nu] == (varsim1.IMPACT if takes_impact else varsim1.LIFT_OFF)
            assert (varsim1.identifier(beta, nu) in note) is takes_impact


def test_an_impact_after_a_lift_off_is_not_meant() -> None:
    """With it the refuted sentence would be true: the starts that it names lift off, and take an impact then."""
    for beta, side in section_3.IMPACT["printed"].items():
        nu = fmpq(2) if side < 0 else fmpq(1, 2)
        run = after_lift_off.run_of(beta, nu, section_3.EPS)
        assert (run.verdict.outcome, run.verdict.statement) == (Outcome.PROVED, ONE_FLIGHT)
        assert "an impact" in ONE_FLIGHT
    entry = section_3.ENTRIES["3-sides"]()
    assert "without a lift-off before it" in entry.statement
    assert "lift off first" in entry.corrected
    (claim,) = (claim for claim in paper_claims() if "3-sides" in claim.entries)
    assert "without a lift-off before it" in claim.words


@pytest.mark.parametrize(
    ("factor", "found", "answer"),
    [
        (fmpq(2), forces(1, 5), True),  # b(0) below that of the trivial solution
        (fmpq(3, 2), forces(1, 5), True),
        (fmpq(2), forces(-3, 5), False),  # λ_N = 2 - 3 on the way
        (fmpq(2), forces(1, -3), False),
        (fmpq(1, 2), forces(1, 5), True),  # λ_N = 2 - 5/2 at the end
        (fmpq(9, 10), forces(1, 25), True),
        (fmpq(1, 2), forces(1, 3), False),
        (fmpq(1, 2), forces(-35, 5), True),  # λ_N = 2 + 35/2
        (fmpq(1, 2), forces(-37, 5), False),
    ],
)
def test_who_takes_an_impact(
    monkeypatch: pytest.MonkeyPatch, factor: fmpq, found: section_3.Forces, answer: bool
) -> None:
    monkeypatch.setattr(section_3, "FACTORS", (factor,))
    assert section_3.holds({BETA: -1}, found) is answer
    if answer:
        assert section_3.holds({BETA: 1}, found) is False


def test_what_the_balls_cannot_tell_is_open(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(section_3, "FACTORS", (fmpq(2),))
    assert section_3.holds({BETA: -1}, lambda _: (arb(0, 3),)) is None
    assert section_3.holds({BETA: -1}, lambda _: (arb.nan(),)) is None
    assert section_3.holds({}, forces(1)) is None


@pytest.mark.parametrize(
    ("printed", "corrected", "answer"), [(False, True, False), (False, False, None), (True, False, True)]
)
def test_the_check_needs_the_corrected_form(
    monkeypatch: pytest.MonkeyPatch, printed: bool, corrected: bool, answer: bool | None
) -> None:
    def holds(impact: Mapping[fmpq, int], _: Any) -> bool:
        return printed if impact is section_3.IMPACT["printed"] else corrected

    monkeypatch.setattr(section_3, "holds", holds)
    check = section_3._check("a", lambda beta: (arb(0), arb(beta)))
    assert check.agrees is answer
    assert "would need a force below 4: it has lifted off" in check.finding
