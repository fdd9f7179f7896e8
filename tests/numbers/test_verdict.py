"""Verdicts: three outcomes that cannot be mistaken for one another."""

from __future__ import annotations

import dataclasses
import json
import pickle
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Outcome, Reason, Verdict

BOXES = ((Dyadic(-1, 3, -2), Dyadic(5, 5)), (Dyadic(0, 1, 0), Dyadic(1, 2, 70)))

ONE_TWO = less(1, 2)

VERDICTS = (
    Verdict.proved("a < b", ONE_TWO),
    Verdict.proved("a < b", ONE_TWO, "by balls"),
    Verdict.refuted("a < b", "a = 2, b = 1", ONE_TWO),
    Verdict.refuted("a < b", "a = 2, b = 1", ONE_TWO, "two derivations"),
    *(Verdict.undecided("a < b", reason, "so far", BOXES) for reason in Reason),
    Verdict.undecided("a < b", Reason.BUDGET),
)


@pytest.mark.parametrize("verdict", VERDICTS, ids=str)
def test_a_verdict_is_no_truth_value(verdict: Verdict) -> None:
    with pytest.raises(TypeError, match="three outcomes"):
        bool(verdict)
    with pytest.raises(TypeError, match="three outcomes"):
        assert verdict
    with pytest.raises(TypeError, match="three outcomes"):
        all([verdict])
    with pytest.raises(TypeError, match="three outcomes"):
        any([verdict])
    with pytest.raises(TypeError, match="three outcomes"):
        print(not verdict)


@pytest.mark.parametrize("witness", [None, ""])
def test_refuted_needs_a_witness(witness: str | None) -> None:
    with pytest.raises(ValueError, match="witness"):
        Verdict(Outcome.REFUTED, "a < b", witness=witness, against=ONE_TWO)
    with pytest.raises(ValueError, match="witness"):
        Verdict.refuted("a < b", witness, ONE_TWO)  # type: ignore[arg-type]


@pytest.mark.parametrize("evidence", [None, "a < b", True, 1])
def test_proved_needs_evidence(evidence: Any) -> None:
    with pytest.raises(ValueError, match="evidence"):
        Verdict(Outcome.PROVED, "a < b", evidence=evidence)
    with pytest.raises(ValueError, match="evidence"):
        Verdict.proved("a < b", evidence)
    with pytest.raises(ValueError, match="evidence"):
        dataclasses.replace(Verdict.undecided("a < b", Reason.BUDGET), outcome=Outcome.PROVED)


def test_the_evidence_of_a_verdict() -> None:
    assert str(Verdict.proved("a < b", ONE_TWO).evidence) == "1 < 2"
    assert str(pickle.loads(pickle.dumps(Verdict.proved("a < b", ONE_TWO))).evidence) == "1 < 2"
    assert str(Verdict.refuted("b < a", "a = 1, b = 2", ONE_TWO).against) == "1 < 2"
    assert Verdict.undecided("a < b", Reason.BUDGET).evidence is None


@pytest.mark.parametrize("evidence", [None, "a < b", True, 1])
def test_refuted_needs_evidence(evidence: Any) -> None:
    with pytest.raises(ValueError, match="a refuted statement needs evidence"):
        Verdict(Outcome.REFUTED, "a < b", witness="a = 2", against=evidence)
    with pytest.raises(ValueError, match="a refuted statement needs evidence"):
        Verdict.refuted("a < b", "a = 2", evidence)
    with pytest.raises(ValueError, match="a refuted statement needs evidence"):
        dataclasses.replace(Verdict.undecided("a < b", Reason.BUDGET), outcome=Outcome.REFUTED, witness="a = 2")


def test_what_contradicts_a_statement_is_never_what_shows_it() -> None:
    """A verdict that rests on another one asks for its evidence: there is none where that one was refuted or open."""
    assert Verdict.refuted("a < b", "a = 2", ONE_TWO).evidence is None
    assert Verdict.proved("a < b", ONE_TWO).against is None
    for outcome, words in ((Outcome.REFUTED, {"witness": "w"}), (Outcome.UNDECIDED, {"reason": Reason.BUDGET})):
        with pytest.raises(ValueError, match="only a proved statement"):
            Verdict(outcome, "a < b", evidence=ONE_TWO, **words)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="only a refuted statement"):
        Verdict(Outcome.PROVED, "a < b", evidence=ONE_TWO, against=ONE_TWO)


def test_undecided_needs_a_reason() -> None:
    with pytest.raises(ValueError, match="reason"):
        Verdict(Outcome.UNDECIDED, "a < b")
    with pytest.raises(ValueError, match="reason"):
        Verdict.undecided("a < b", None)  # type: ignore[arg-type]


def test_no_route_around_the_checks() -> None:
    with pytest.raises(ValueError, match="witness"):
        dataclasses.replace(Verdict.proved("a < b", ONE_TWO), outcome=Outcome.REFUTED)
    with pytest.raises(ValueError, match="reason"):
        dataclasses.replace(Verdict.proved("a < b", ONE_TWO), outcome=Outcome.UNDECIDED)


def test_exit_codes() -> None:
    assert Verdict.proved("s", ONE_TWO).exit_code == 0
    assert Verdict.refuted("s", "w", ONE_TWO).exit_code == 1
    assert {Verdict.undecided("s", reason).exit_code for reason in Reason} == {2}
    assert len({verdict.exit_code for verdict in VERDICTS}) == 3


def test_the_outcomes_are_distinct_from_each_other() -> None:
    assert len(Outcome) == len({outcome.value for outcome in Outcome}) == 3
    assert Outcome.UNDECIDED not in (Outcome.PROVED, Outcome.REFUTED)
    # Enum members are truthy by default: nothing may rest on that, and every reason can be told apart.
    assert len(Reason) == len({reason.value for reason in Reason}) == len({reason.name for reason in Reason})


def test_frozen_hashable_equal() -> None:
    verdict = Verdict.undecided("s", Reason.BUDGET, remaining=BOXES)
    with pytest.raises(dataclasses.FrozenInstanceError):
        verdict.outcome = Outcome.PROVED  # type: ignore[misc]
    with pytest.raises((AttributeError, TypeError)):
        verdict.other = 1  # type: ignore[attr-defined]
    same = Verdict.undecided("s", Reason.BUDGET, remaining=tuple(tuple(box) for box in BOXES))
    assert verdict == same
    assert hash(verdict) == hash(same)
    assert verdict != Verdict.undecided("s", Reason.WIDE_INPUT, remaining=BOXES)
    assert len(set(VERDICTS)) == len(VERDICTS)


@pytest.mark.parametrize("verdict", VERDICTS, ids=str)
def test_pickle(verdict: Verdict) -> None:
    assert pickle.loads(pickle.dumps(verdict)) == verdict


@pytest.mark.parametrize("verdict", VERDICTS, ids=str)
def test_json_round_trip(verdict: Verdict) -> None:
    data = json.loads(json.dumps(verdict.to_json(), allow_nan=False))
    assert data == verdict.to_json()
    assert set(data) == {"outcome", "statement", "witness", "reason", "detail", "remaining"}
    rebuilt = Verdict(
        Outcome(data["outcome"]),
        data["statement"],
        data["witness"],
        Reason[data["reason"].upper()] if data["reason"] else None,
        data["detail"],
        tuple(tuple(Dyadic.parse(side) for side in box) for box in data["remaining"]),
        verdict.evidence,  # these two are no part of the text
        verdict.against,
    )
    assert rebuilt == verdict


def test_the_words_of_the_json() -> None:
    """What a script that reads the reports compares with."""
    words = {reason: Verdict.undecided("s", reason).to_json()["reason"] for reason in Reason}
    assert words == {
        Reason.BUDGET: "budget", Reason.WIDE_INPUT: "wide_input", Reason.HYPOTHESIS: "hypothesis",
        Reason.BEYOND: "beyond", Reason.NO_ROUTE: "no_route",
        Reason.CONTRADICTION: "contradiction", Reason.ONE_FAILURE: "one_failure", Reason.POINTS: "points",
        Reason.FLOATS: "floats",
    }  # fmt: skip


@given(st.text(max_size=40), st.text(min_size=1, max_size=40), st.text(max_size=40))
def test_json_keeps_any_text(statement: str, witness: str, detail: str) -> None:
    data = json.loads(json.dumps(Verdict.refuted(statement, witness, ONE_TWO, detail).to_json()))
    assert (data["outcome"], data["statement"], data["witness"], data["detail"]) == (
        "refuted", statement, witness, detail,
    )  # fmt: skip


def test_text_says_everything() -> None:
    text = str(Verdict.refuted("a < b", "a = 2", ONE_TWO, "twice"))
    assert text.splitlines()[0] == "refuted: a < b"
    assert "a = 2" in text
    assert "twice" in text
    text = str(Verdict.undecided("a < b", Reason.WIDE_INPUT, "half way", BOXES))
    assert text.startswith("undecided: a < b")
    assert Reason.WIDE_INPUT.value in text
    assert "half way" in text
    assert "2 boxes left" in text
    assert "proved" not in text
    assert str(Verdict.proved("a < b", ONE_TWO)) == "proved: a < b"


def test_html_is_escaped() -> None:
    page = Verdict.refuted("a < b & c", "<script>alert(1)</script>", ONE_TWO)._repr_html_()
    assert "<script>" not in page
    assert "a &lt; b &amp; c" in page
    assert page.startswith("<pre ")
