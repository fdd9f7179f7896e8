"""The eight combinations of signs: examples that do not show one of them refute nothing."""

from __future__ import annotations

from typing import Any

import pytest

from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.section_1 import section_1_alpha_signs as ledger


@pytest.mark.parametrize(("name", "wrong"), [("RATES", ledger.RATES[:1]), ("SHAPES", ledger.SHAPES[:1])])
def test_examples_that_miss_a_combination_leave_it_open(monkeypatch: pytest.MonkeyPatch, name: str, wrong: Any) -> None:
    monkeypatch.setattr(ledger, name, wrong)
    monkeypatch.setattr(ledger, "EXAMPLE_VALUES", (1, 2))
    entry = ledger.ENTRIES["1-alpha-signs"]()
    assert [check.agrees for check in entry.checks] == [None, None]
    assert entry.verdict.outcome is Outcome.UNDECIDED
