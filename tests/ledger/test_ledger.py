"""The ledger decides every entry, detects changed formulas, and never proves from nothing."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from ledger.refuted import REFUTED

from gspot_verified import Outcome, Verdict
from gspot_verified.ledger.entry import Check, Entry, Rung, all_of, conclude, counts, rung_counts, same_sign, settled
from gspot_verified.ledger.verify import PARTS, exit_code, verify_paper

_PROOFS = Path(__file__).resolve().parents[2] / "proofs"


@pytest.fixture(scope="module")
def entries() -> list[Entry]:
    return verify_paper()


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
    assert sorted(parts) == [f"Section {n}" for n in range(1, 7)]
    assert any("Appendix A" in part for part in PARTS)
    assert any("Appendix B" in part for part in PARTS)
    for path, times in (("README.md", 1), ("CHANGELOG.md", 1), ("gspot_verified/cli/paper_commands.py", 0)):
        text = " ".join((_PROOFS.parent / path).read_text(encoding="utf-8").split())
        stated = re.findall(r"(\d+) statements, (\d+) proved, (\d+) refuted", text)
        assert [list(row) for row in stated] == [numbers] * times, path
        assert text.count("Sections 1 to 6 and Appendices A and B") == 1, path


def test_no_answers_are_no_agreement() -> None:
    assert all_of([]) is None


@pytest.mark.parametrize(
    ("answers", "outcome"),
    [
        ([(Rung.PAGE, True), (Rung.POINTS, True)], Outcome.PROVED),
        ([(Rung.EXACT, True), (Rung.BALLS, True)], Outcome.PROVED),
        ([(Rung.PAGE, True)], Outcome.UNDECIDED),
        ([(Rung.POINTS, True), (Rung.POINTS, True)], Outcome.UNDECIDED),
        ([(Rung.PAGE, True), (Rung.POINTS, None)], Outcome.UNDECIDED),
        ([(Rung.PAGE, True), (Rung.POINTS, False)], Outcome.UNDECIDED),
        ([(Rung.EXACT, False), (Rung.BALLS, False)], Outcome.REFUTED),
        ([(Rung.POINTS, False), (Rung.POINTS, False)], Outcome.REFUTED),
        ([(Rung.EXACT, False), (Rung.BALLS, None)], Outcome.UNDECIDED),
        ([(Rung.PAGE, True), (Rung.POINTS, False), (Rung.POINTS, False)], Outcome.UNDECIDED),
        ([(Rung.POINTS, True), (Rung.EXACT, False), (Rung.BALLS, False)], Outcome.REFUTED),
        ([], Outcome.UNDECIDED),
    ],
)
def test_conclusions(answers: list[tuple[Rung, bool | None]], outcome: Outcome) -> None:
    checks = [Check(rung, f"check {n}", agrees, "a finding") for n, (rung, agrees) in enumerate(answers)]
    assert conclude("a statement", checks).outcome is outcome


def test_one_check_stated_twice_is_one_check() -> None:
    for agrees in (True, False):
        assert conclude("a statement", [Check(Rung.EXACT, "a", agrees, "f")] * 2).outcome is Outcome.UNDECIDED


def test_a_failure_without_a_finding_names_its_check() -> None:
    verdict = conclude("a statement", [Check(Rung.EXACT, what, False) for what in ("first", "second")])
    assert (verdict.witness, verdict.detail) == ("first", "second")


@pytest.mark.parametrize(
    ("answers", "rests_on", "alone"),
    [
        ([(Rung.POINTS, True), (Rung.PAGE, True)], (Rung.PAGE,), True),
        ([(Rung.BALLS, True), (Rung.PAGE, True)], (Rung.PAGE, Rung.BALLS), False),
        ([(Rung.EXACT, True), (Rung.POINTS, True)], (Rung.EXACT,), False),
        ([(Rung.PAGE, True), (Rung.FORMAL, True)], (Rung.FORMAL, Rung.PAGE), False),
        ([(Rung.POINTS, False), (Rung.EXACT, False)], (Rung.EXACT, Rung.POINTS), False),
        ([(Rung.POINTS, False), (Rung.POINTS, False), (Rung.PAGE, None)], (Rung.POINTS,), False),
        ([(Rung.PAGE, False), (Rung.PAGE, False)], (Rung.PAGE,), True),
        ([(Rung.PAGE, True), (Rung.POINTS, None)], (), False),
    ],
)
def test_what_a_verdict_rests_on(
    answers: list[tuple[Rung, bool | None]], rests_on: tuple[Rung, ...], alone: bool
) -> None:
    checks = [Check(rung, f"check {n}", agrees, "a finding") for n, (rung, agrees) in enumerate(answers)]
    entry = settled("Section", "identifier", "label", "source", "statement", *checks)
    assert entry.rests_on == rests_on
    assert entry.rung is (rests_on[0] if rests_on else None)
    assert entry.page_alone is alone
    assert entry.to_json()["rests_on"] == [rung.name.lower() for rung in rests_on]


def test_no_proved_entry_rests_on_points_and_every_decided_one_on_something(entries: list[Entry]) -> None:
    table = rung_counts(entries)
    assert table["proved"]["points"] == 0
    for outcome, row in table.items():
        assert sum(row.values()) == counts(entries)[outcome]
    assert all(Rung.POINTS not in e.rests_on for e in entries if e.verdict.outcome is Outcome.PROVED)


def test_three_valued_helpers() -> None:
    assert all_of([True, None]) is None
    assert all_of([None, False]) is False
    assert same_sign(1, None) is None
    assert same_sign(1, -1) is False
    assert isinstance(conclude("s", []), Verdict)
