"""Captions of Sec. 3: the starts of each panel, closed systems, Cases."""

from __future__ import annotations

import pytest
from flint import fmpq

from gspot_verified.paper.section_3 import section_3_captions as ledger


@pytest.mark.parametrize(("panel", "nu", "value"), [("a", 1, "-1"), ("b", 1, "-1"), ("c", 2, "-2/3"), ("a", 4, "-4")])
def test_starts(panel: str, nu: int, value: str) -> None:
    numerator, _, denominator = value.partition("/")
    assert ledger.first_b(panel, fmpq(nu)) == fmpq(int(numerator), int(denominator or 1))
    assert ledger.trivial_is_a_run(panel) is (panel != "a")


def test_closed_systems() -> None:
    assert ledger.is_closed("modelsys5") is True
    assert ledger.is_closed("modelsys4") is False
    assert ledger.is_closed("modelsys1") is True
    assert ledger.has_all_starts("modelsys1") is False


@pytest.mark.parametrize(("panel", "case"), [("a", "III"), ("b", "I"), ("c", "II")])
def test_other_cases(monkeypatch: pytest.MonkeyPatch, panel: str, case: str) -> None:
    assert ledger.is_in_case(panel) is ledger.force_is_that_of_the_case(panel) is True
    monkeypatch.setitem(ledger.CASES, panel, case)
    assert ledger.is_in_case(panel) is ledger.force_is_that_of_the_case(panel) is False
