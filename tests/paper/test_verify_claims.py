"""verify(): the ledger from Python."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from gspot_verified import Outcome, verify
from gspot_verified.paper import verify as module
from gspot_verified.paper.verify import verify_claims


def test_named_claims_and_what_their_checks_name(tmp_path: Path) -> None:
    named, further = verify_claims(["S-iwc"])
    found = verify("S-iwc", cache=tmp_path)
    assert [entry.identifier for entry in found] == [entry.identifier for entry in named + further]
    assert found[0].verdict.outcome is Outcome.PROVED
    assert [entry.identifier for entry in verify("S-iwc", alone=True)] == ["S-iwc"]
    assert any(tmp_path.rglob("*"))


def test_no_claim_is_the_whole_paper(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = []
    monkeypatch.setattr(module, "verify_paper", lambda *arguments: asked.append(arguments) or [])
    assert verify() == []
    assert asked == [(None, None, None, None)]


def test_what_does_not_fit_is_refused() -> None:
    with pytest.raises(ValueError, match="alone: for named claims"):
        verify(alone=True)
    with ThreadPoolExecutor(1) as pool, pytest.raises(ValueError, match="executor: for the whole paper"):
        verify("S-iwc", executor=pool)
    with pytest.raises(ValueError, match="no entry of the ledger is named 'S-iw'"):
        verify("S-iw")
