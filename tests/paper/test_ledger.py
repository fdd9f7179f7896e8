"""The ledger decides every entry, detects changed formulas, and never proves from nothing."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from paper.refuted import REFUTED

from gspot_verified import Outcome
from gspot_verified.paper.checks.entry import Entry, Rung, counts, rung_counts
from gspot_verified.paper.verify import PARTS, exit_code

_PROOFS = Path(__file__).resolve().parents[2] / "proofs"
WHOLE_ON_EACH = {
    *("2-restitution-not-fixed", "3-flight-persists", "S-iwc", "5-lemma-orders", "5-theorem-1-spaces"),
    *("A-cancellation", "3-table-1-theory-b", "3-table-1-theory-v", "3-table-1-theory-y"),
}
"""Proved entries with checks on two or more settling rungs, read: the check on the strongest one covers all of the
statement. A check that covers a part of it stands within the check of the whole, or supports it as points do."""


@pytest.fixture(scope="module")
def entries(whole_ledger: list[Entry]) -> list[Entry]:
    return whole_ledger


def test_every_entry_is_decided_and_only_the_known_misprints_are_refuted(entries: list[Entry]) -> None:
    assert {e.identifier for e in entries if e.verdict.outcome is Outcome.REFUTED} == REFUTED
    assert all(e.verdict.outcome is not Outcome.UNDECIDED for e in entries)
    assert [e.identifier for e in entries] == [identifier for part in PARTS.values() for identifier in part]
    assert len({e.identifier for e in entries}) == len(entries)


def test_every_entry_has_two_routes_and_every_refuted_one_a_corrected_form(entries: list[Entry]) -> None:
    for entry in entries:
        assert len(entry.checks) >= 2
        if entry.verdict.outcome is Outcome.REFUTED:
            assert entry.corrected
            assert entry.consequence is not None, (
                f"{entry.identifier}: say in consequences.py how far the error reaches"
            )
            assert sum(check.agrees is False for check in entry.checks) >= 2
        else:
            assert all(check.agrees is True for check in entry.checks)
            assert any(check.rung.settles for check in entry.checks)


def test_every_labelled_formula_of_the_appendix_has_an_entry(entries: list[Entry]) -> None:
    labels = " ".join(entry.label for entry in entries)
    wanted = ["th:3", "th:4", "th:5", "eq:btau", "eq:hdef", "eq:eier", "eq:cisdef", "eq:tlarge", "eq:dTheta_sign"]
    wanted += [f"eq:bsmall{i}" for i in (1, 2, 3)] + [f"eq:blarge{i}" for i in (1, 2, 3)]
    for label in [*wanted, "eq:t01", "eq:t02", "eq:t03"]:
        assert label in labels, label


def test_every_proof_page_that_is_named_exists(entries: list[Entry]) -> None:
    for entry in entries:
        for check in entry.checks:
            for page in re.findall(r"proofs/(\w+\.md)", check.what):
                assert (_PROOFS / page).is_file(), page
            if check.rung is Rung.PAGE:
                assert check.what.startswith("proofs/")


def test_exit_code_and_counts(entries: list[Entry]) -> None:
    assert exit_code(entries) == 1
    assert counts(entries) == {"proved": len(entries) - len(REFUTED), "refuted": len(REFUTED), "undecided": 0}
    proved = [e for e in entries if e.verdict.outcome is Outcome.PROVED]
    assert exit_code(proved) == 0


def test_the_texts_state_the_counts_and_the_sections_of_the_ledger(entries: list[Entry]) -> None:
    found = counts(entries)
    assert found["undecided"] == 0
    numbers = [str(len(entries)), str(found["proved"]), str(found["refuted"])]
    parts = {match[0] for part in PARTS if (match := re.match(r"Section \d", part))}
    assert sorted(parts) == [f"Section {n}" for n in range(1, 8)]
    assert any("Appendix A" in part for part in PARTS)
    assert any("Appendix B" in part for part in PARTS)
    for path, times in (("README.md", 1), ("gspot_verified/cli/commands/paper_commands.py", 0)):
        text = " ".join((_PROOFS.parent / path).read_text(encoding="utf-8").split())
        stated = re.findall(r"(\d+) statements, (\d+) proved, (\d+) refuted", text)
        assert [list(row) for row in stated] == [numbers] * times, path
        assert text.count("Sections 1 to 7 and Appendices A and B") == 1, path


def test_no_proved_entry_rests_on_points_and_every_decided_one_on_something(entries: list[Entry]) -> None:
    table = rung_counts(entries)
    assert table["proved"]["points"] == 0
    for outcome, row in table.items():
        assert sum(row.values()) == counts(entries)[outcome]
    assert all(Rung.POINTS not in e.rests_on for e in entries if e.verdict.outcome is Outcome.PROVED)


def test_the_strongest_rung_of_an_entry_carries_all_of_it(entries: list[Entry]) -> None:
    """As far as a reader has seen: a new entry on two rungs must be read for it."""
    proved = [entry for entry in entries if entry.verdict.outcome is Outcome.PROVED]
    assert {entry.identifier for entry in proved if len(entry.rests_on) > 1} == WHOLE_ON_EACH
