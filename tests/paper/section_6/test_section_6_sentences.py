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
