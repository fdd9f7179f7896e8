"""Counts of equations, and brackets that close."""

from __future__ import annotations

import pytest

from gspot_verified.paper.section_5 import section_5_sentences as ledger


@pytest.mark.parametrize(("differential", "algebraic"), [(4, 1), (2, 3), (3, 3), (5, 0)])
def test_other_counts(monkeypatch: pytest.MonkeyPatch, differential: int, algebraic: int) -> None:
    counted = {"differential": differential, "algebraic": algebraic}
    monkeypatch.setitem(ledger.KINDS, "printed", counted)
    assert ledger.counted_by_derivatives("printed") is ledger.counted_by_the_order("printed") is False
    assert ledger.counted_by_derivatives("corrected") is ledger.counted_by_the_order("corrected") is True


@pytest.mark.parametrize(
    ("old", "new", "answer"),
    [
        ("{(2(\\beta-1)/3}", "{(2(\\beta-1))/3}", None),
        ("nothing", "", False),
        ("(2(\\beta-1)/3", "(2\\beta-1)/3", None),
    ],
)
def test_brackets(monkeypatch: pytest.MonkeyPatch, old: str, new: str, answer: bool | None) -> None:
    honest = ledger.quoted
    monkeypatch.setattr(ledger, "quoted", lambda label: honest(label).replace(old, new))
    assert ledger.brackets_close("lines 2054 and 2056") is answer


def test_the_other_printed_bracket() -> None:
    assert ledger.brackets_close("line 2538") is False


def test_differences(monkeypatch: pytest.MonkeyPatch) -> None:
    assert ledger.differences_are_linear() is ledger.differences_follow_one_by_one() is True
    monkeypatch.setitem(ledger.FUNCTIONS, "P", "a1 + 1")
    assert ledger.differences_are_linear() is ledger.differences_follow_one_by_one() is False
