"""The stated signs of Section 4.5: what is said to be tried is tried, and a step that fails leaves its check open.

Pages: proofs/signs.md, proofs/side_switching.md.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from flint import fmpq
from paper.bite import answers_with

from gspot_verified.paper.checks.closed_forms import rational
from gspot_verified.paper.section_4_5 import section_4_5_signs as ledger
from gspot_verified.signs.cover.tails import left_holds

GRID = {fmpq(n, 10) for n in range(1, 130)}


@pytest.fixture
def tried(monkeypatch: pytest.MonkeyPatch) -> list[tuple[Any, Any, int]]:
    """(tau, beta, derivative) of each value of Theta that a check asks for."""
    calls: list[tuple[Any, Any, int]] = []
    honest: Callable[..., Any] = ledger.evaluate

    def recorded(tau: Any, beta: Any, derivative: int = 0) -> Any:
        calls.append((tau, beta, derivative))
        return honest(tau, beta, derivative=derivative)

    monkeypatch.setattr(ledger, "evaluate", recorded)
    return calls


def test_the_sign_at_minus_infinity_is_tried_at_the_threshold_of_every_beta(tried: list[tuple[Any, Any, int]]) -> None:
    ledger.ENTRIES["S-minus-infinity"]()
    assert {(tau, derivative) for tau, _, derivative in tried} == {(-ledger._threshold(beta), 1) for beta in GRID}
    assert {beta for _, beta, _ in tried} == GRID


def test_a_threshold_is_the_least_integer_that_serves() -> None:
    found = {beta: ledger._threshold(beta) for beta in GRID}
    for beta, threshold in found.items():
        b = beta - 1
        assert threshold.q == 1
        assert left_holds(threshold, b, b, int(b.floor()))
        assert threshold == 1 or not left_holds(threshold - 1, b, b, int(b.floor()))
    assert max(found.values()) == 3


def test_the_sign_at_zero_is_tried_at_every_beta(tried: list[tuple[Any, Any, int]]) -> None:
    ledger.ENTRIES["S-zero"]()
    assert {(tau, derivative) for tau, _, derivative in tried} == {(0, 1)}
    assert {beta for _, beta, _ in tried} == {beta for beta in GRID if beta.q != 1} | set(range(1, 16))


def test_the_sign_at_infinity_is_tried_at_every_beta(tried: list[tuple[Any, Any, int]]) -> None:
    ledger.ENTRIES["S-plus-infinity"]()
    assert {(tau, derivative) for tau, _, derivative in tried} == {(60, 1)}
    assert {beta for _, beta, _ in tried} == {beta for beta in GRID if beta.q != 1}


def test_two_points_of_each_interval_are_tried(monkeypatch: pytest.MonkeyPatch) -> None:
    calls: list[fmpq] = []
    monkeypatch.setattr(ledger, "gamma_sign_by_ball", calls.append)
    assert ledger._signs_by_ball(ledger.CORRECTED["S-gamma-intervals"]) is None
    cells = [int(beta.floor()) for beta in set(calls)]
    assert sorted(cells) == sorted([*range(8), *range(8)])


def test_the_two_values_of_gamma_that_are_shown() -> None:
    findings = " ".join(check.finding for check in ledger.ENTRIES["S-gamma-intervals"]().checks)
    assert "Γ(-1/2) in [-3.54490" in findings  # -2 sqrt(pi)
    assert "Γ(-3/2) in [2.36327" in findings  # 4 sqrt(pi)/3


def test_the_coefficient_for_all_integers_is_needed_beside_the_values() -> None:
    answers = answers_with(ledger, "_coefficient_at_integers", lambda: rational(-1), ledger.ENTRIES["S-zero"])
    assert answers == [True, True, True, None]
