"""What a verdict follows from: its checks, their rungs, and what none of them decides."""

from __future__ import annotations

from dataclasses import replace

import pytest

from gspot_verified import Outcome, Verdict
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Reason
from gspot_verified.paper.checks import entry as module
from gspot_verified.paper.checks.consequences import consequence
from gspot_verified.paper.checks.entry import (
    Check,
    Entry,
    Rung,
    Section,
    all_of,
    conclude,
    counts,
    rung_counts,
    same_sign,
)
from gspot_verified.paper.checks.formal_proof import FormalProof, Theorem


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


def test_the_answers_of_the_checks_are_the_evidence(monkeypatch: pytest.MonkeyPatch) -> None:
    """They are asked once more where the verdict is made: without them, nobody concludes."""
    for rung, agrees, facts in (
        (Rung.PAGE, True, "a: it holds; b: it holds; 1 < 2; 0 < 2"),
        (Rung.POINTS, False, "a: it fails; b: it fails; 1 < 2"),
    ):
        checks = [Check(rung, what, agrees, "a finding") for what in ("a", "b")]
        found = conclude("a statement", checks)
        assert str(found.evidence or found.against) == facts
        with monkeypatch.context() as patch:
            patch.setattr(module, "answered", lambda *_: None)
            with pytest.raises(ValueError, match="needs evidence"):
                conclude("a statement", checks)


@pytest.mark.parametrize(
    ("answers", "reason"),
    [
        ([(Rung.EXACT, True), (Rung.BALLS, False)], Reason.CONTRADICTION),
        ([(Rung.PAGE, True), (Rung.POINTS, False), (Rung.POINTS, False)], Reason.CONTRADICTION),
        ([(Rung.EXACT, False)], Reason.ONE_FAILURE),
        ([(Rung.POINTS, True), (Rung.EXACT, False)], Reason.ONE_FAILURE),
        ([(Rung.EXACT, False), (Rung.BALLS, None)], Reason.ONE_FAILURE),
        ([(Rung.EXACT, None), (Rung.POINTS, True)], Reason.BUDGET),
        ([(Rung.POINTS, True)], Reason.POINTS),
        ([(Rung.POINTS, True), (Rung.POINTS, True)], Reason.POINTS),
        ([(Rung.EXACT, True)], Reason.NO_ROUTE),
        ([], Reason.NO_ROUTE),
    ],
)
def test_an_open_entry_has_its_true_reason(answers: list[tuple[Rung, bool | None]], reason: Reason) -> None:
    checks = [Check(rung, f"check {n}", agrees, "f") for n, (rung, agrees) in enumerate(answers)]
    assert conclude("a statement", checks).reason is reason


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
    entry = Section("Section").settled("identifier", "label", "source", "statement", *checks)
    assert entry.rests_on == rests_on
    assert entry.rung is (rests_on[0] if rests_on else None)
    assert entry.page_alone is alone
    assert entry.to_json()["rests_on"] == [rung.name.lower() for rung in rests_on]


def test_three_valued_helpers() -> None:
    assert all_of([True, None]) is None
    assert all_of([None, False]) is False
    assert same_sign(1, None) is None
    assert same_sign(1, -1) is False
    assert isinstance(conclude("s", []), Verdict)


def toy(*answers: tuple[Rung, bool | None], **texts: str) -> Entry:
    """An entry whose checks give these answers."""
    checks = [Check(rung, f"check {n}", agrees, f"finding {n}") for n, (rung, agrees) in enumerate(answers)]
    return Section("Section").settled("identifier", "line 1", "x", "statement", *checks, **texts)


PROVED = toy((Rung.EXACT, True), (Rung.POINTS, True))
REFUTED = toy((Rung.POINTS, False), (Rung.BALLS, False))
OPEN = toy((Rung.EXACT, True))


def test_three_answers_are_kept_apart() -> None:
    assert all_of([True]) is all_of([True, True]) is True
    assert all_of([None]) is all_of([None, None]) is None
    assert all_of([True, False]) is all_of([False]) is False
    assert same_sign(1, 1) is same_sign(0, 0) is True
    assert same_sign(None, 1) is same_sign(None, None) is None
    assert same_sign(0, 1) is False


def test_only_points_do_not_settle_and_each_rung_has_a_name() -> None:
    assert [rung for rung in Rung if not rung.settles] == [Rung.POINTS]
    assert len({rung.short for rung in Rung}) == len(Rung)


def test_counts() -> None:
    entries = [PROVED, PROVED, REFUTED, OPEN]
    assert counts(entries) == {"proved": 2, "refuted": 1, "undecided": 1}
    nothing = dict.fromkeys(("formal", "exact", "page", "balls", "points"), 0)
    assert rung_counts(entries) == {"proved": nothing | {"exact": 2}, "refuted": nothing | {"balls": 1}}


def test_what_a_verdict_says() -> None:
    assert (REFUTED.verdict.witness, REFUTED.verdict.detail) == ("finding 0", "finding 1")
    assert conclude("s", REFUTED.checks, "a witness").witness == "a witness"
    assert PROVED.verdict.detail == "check 0; check 1"
    assert OPEN.verdict.detail == "there is one check alone"
    assert conclude("s", []).detail == "there is no check"
    points = toy((Rung.POINTS, True), (Rung.POINTS, True))
    assert "points alone" in points.verdict.detail
    both = toy((Rung.EXACT, True), (Rung.BALLS, False))
    assert both.verdict.detail == "the checks contradict each other: check 0 agrees, check 1 fails"
    assert toy((Rung.EXACT, False)).verdict.detail == "one check fails: finding 0"
    unsure = toy((Rung.EXACT, None), (Rung.BALLS, True), (Rung.BALLS, None))
    assert unsure.verdict.detail == "could not tell: check 0; check 2"


def test_the_second_derivation_is_another_check() -> None:
    checks = [Check(Rung.EXACT, what, False, finding) for what, finding in (("a", "1"), ("a", "2"), ("b", "3"))]
    assert (conclude("s", checks).witness, conclude("s", checks).detail) == ("1", "3")


def test_labels_in_texts_become_printed_numbers_and_json_says_all() -> None:
    entry = toy((Rung.PAGE, True), (Rung.POINTS, True), corrected="c", note="n")
    found = entry.to_json()
    assert found["checks"][0] == {"rung": "page", "what": "check 0", "agrees": True, "finding": "finding 0"}
    assert (found["rung"], found["corrected"], found["note"]) == ("page", "c", "n")
    assert OPEN.to_json()["rung"] is None
    for value in (entry, entry.checks[0]):
        with pytest.raises(TypeError):
            bool(value)


def test_an_entry_is_verbatim_when_the_lines_of_the_paper_stand_beside_it() -> None:
    assert not toy((Rung.PAGE, True)).verbatim


def test_only_checks_that_agree_or_fail_carry_a_verdict() -> None:
    checks = (Check(Rung.EXACT, "a", None), Check(Rung.PAGE, "b", True))
    entry = Entry("identifier", "line 1", "Section", "x", "s", checks, Verdict.proved("s", less(0, 1), "by hand"))
    assert entry.rests_on == (Rung.PAGE,)
    assert toy((Rung.EXACT, False)).rests_on == ()
    assert toy((Rung.EXACT, False)).rung is None


def test_what_follows_from_an_error_is_said_of_a_refuted_entry_alone() -> None:
    refuted, proved = (replace(entry, identifier="4-order") for entry in (REFUTED, PROVED))
    found = consequence("4-order")
    assert found is not None
    assert (refuted.consequence, refuted.to_json()["consequence"]) == (found, found.to_json())
    assert (proved.consequence, proved.to_json()["consequence"]) == (None, None)
    assert REFUTED.consequence is None  # none is recorded


@pytest.mark.parametrize("run", [True, False])
def test_a_formal_proof_that_was_not_run_is_a_route_and_one_that_was_is_among_the_checks(run: bool) -> None:
    proof = FormalProof((Theorem("first", "a text", "a file"), Theorem("second", "another", "a file")), run, "state")
    entry = replace(PROVED, formal=proof)
    ran = [("exact identity or certificate", "check 0", True), ("points only", "check 1", True)]
    assert list(entry.routes) == [*ran, *([] if run else [("formal proof", "first, second", False)])]
    assert entry.to_json()["routes"] == [dict(zip(("rung", "what", "run"), row, strict=True)) for row in entry.routes]
    assert entry.to_json()["formal"] == proof.to_json()
    assert list(PROVED.routes) == ran
    assert PROVED.to_json()["formal"] is None
