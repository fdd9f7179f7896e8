"""Sentences of Sec. 6: the belt, the damper, the Cases, with other values beside the printed ones."""

from __future__ import annotations

import pytest

from gspot_verified.paper.section_6 import section_6_sentences as ledger


@pytest.mark.parametrize(
    ("belt", "spot", "starts"),
    [("0*l", False, False), ("-l*om", True, True), ("-2/5*l*om", False, None), ("-11/20*l*om", False, True)],
)
def test_belts(monkeypatch: pytest.MonkeyPatch, belt: str, spot: bool | None, starts: bool | None) -> None:
    monkeypatch.setitem(ledger.BELT, "printed", belt)
    assert ledger.slips_forwards_at_the_g_spot("printed") is spot
    assert ledger.slips_forwards_at_the_starts("printed") is starts


@pytest.mark.parametrize(("betas", "answer"), [("lam", False), ("18/7 - lam", True), ("18/7 + lam", False)])
def test_dampers(monkeypatch: pytest.MonkeyPatch, betas: str, answer: bool) -> None:
    monkeypatch.setitem(ledger.BETAS, "printed", betas)
    assert ledger.damps("printed") is answer


def test_cases() -> None:
    assert ledger.has_a_case("printed") is False
    assert ledger.has_a_case("corrected") is True


@pytest.mark.parametrize(
    ("alpha_2", "answer"),
    [
        ("beta^2 - 7", True),
        ("beta^2 - 6", False),  # 18/7 squared is 6.6
        ("beta^2 - beta", False),
        ("3 - beta^2", False),
        ("-beta^2 - 1", False),  # negative, but not seen by its ends
    ],
)
def test_alpha_2_is_negative_up_to_the_highest(monkeypatch: pytest.MonkeyPatch, alpha_2: str, answer: bool) -> None:
    monkeypatch.setitem(ledger.section_6_runs.ALPHAS, "alpha_2", f"{alpha_2} + kappa")
    assert ledger.has_a_case("corrected") is answer
