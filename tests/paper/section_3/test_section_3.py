"""The sides of the simulations: what is stated is what is checked, and each condition of an impact is."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.paper.section_3 import section_3

BETA = fmpq(3, 2)


def forces(*values: int) -> section_3.Forces:
    return lambda _: tuple(map(arb, values))


def test_the_statement_names_what_is_checked() -> None:
    entry = section_3.ENTRIES["3-sides"]()
    lower, higher = section_3.IMPACT["printed"]
    assert entry.statement == (
        f"At ε = {section_3.EPS}, of the starts ν = {', '.join(map(str, section_3.FACTORS))}, those with b(0) below "
        f"that of the trivial solution take an impact for β = {lower}, and those with b(0) above it for β = {higher}"
    )
    assert section_3.IMPACT["printed"] == {lower: -1, higher: 1}
    assert section_3.IMPACT["corrected"] == {lower: 1, higher: -1}
    assert f"until {section_3.END} after" in entry.checks[0].what
    assert [section_3.mean_force(beta) for beta in (lower, higher)] == [2, fmpq(2, 3)]


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
