"""Counts of equations, and brackets that close."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import pytest

from gspot_verified.paper.checks import words
from gspot_verified.paper.checks.paper import citation
from gspot_verified.paper.section_5 import section_5_outer
from gspot_verified.paper.section_5 import section_5_sentences as ledger

PAPER = Path(__file__).resolve().parents[4] / "shared" / "paper.tex"


@pytest.mark.parametrize(("differential", "algebraic"), [(4, 1), (2, 3), (3, 3), (5, 0)])
def test_other_counts(monkeypatch: pytest.MonkeyPatch, differential: int, algebraic: int) -> None:
    counted = {"differential": differential, "algebraic": algebraic}
    monkeypatch.setitem(ledger.KINDS, "printed", counted)
    assert ledger.counted_by_derivatives("printed") is ledger.counted_by_the_order("printed") is False
    assert ledger.counted_by_derivatives("corrected") is ledger.counted_by_the_order("corrected") is True


TWICE, FACTOR, CAPTION = ledger.PLACES


@pytest.mark.parametrize(
    ("place", "old", "new", "answer"),
    [
        (TWICE, "{(2(\\beta-1)/3}", "{(2(\\beta-1))/3}", None),
        (TWICE, "nothing", "", False),
        (TWICE, "(2(\\beta-1)/3", "(2\\beta-1)/3", None),
        (TWICE, "{(2(\\beta-1)/3}", "{2(\\beta-1)/3}", True),
        (FACTOR, "nothing", "", False),
        (FACTOR, "right))+c", "right)+c", True),
        (FACTOR, "right))+c", "right)))+c", None),
        (CAPTION, "nothing", "", False),
        (CAPTION, "$b=p=0$.", "$b=p=0$).", True),
        (CAPTION, "$b=p=0$.", "$b=0$.", None),
    ],
)
def test_brackets(monkeypatch: pytest.MonkeyPatch, place: str, old: str, new: str, answer: bool | None) -> None:
    honest = ledger.quoted
    monkeypatch.setattr(ledger, "quoted", lambda label: honest(label).replace(old, new))
    assert ledger.brackets_close(place) is answer


def test_no_other_paragraph_of_the_paper_has_an_open_bracket() -> None:
    if not PAPER.is_file():
        pytest.skip("the paper's source is not at hand")
    lines = PAPER.read_text(encoding="utf-8").splitlines()
    walls = [0, *(n for n, line in enumerate(lines, 1) if not line.strip()), len(lines) + 1]
    paragraphs = [(first + 1, last - 1) for first, last in pairwise(walls)]
    texts = {span: "".join(lines[span[0] - 1 : span[1]]) for span in paragraphs}
    found = [span for span, text in texts.items() if text.count("(") != text.count(")")]
    cited = [(quoted.first, quoted.last) for quoted in citation(ledger.BRACKETS).quotations]
    assert len(found) == len(cited)
    assert all(a <= first and last <= b for (a, b), (first, last) in zip(found, cited, strict=True))


def test_differences(monkeypatch: pytest.MonkeyPatch) -> None:
    assert ledger.differences_are_linear() is ledger.differences_follow_one_by_one() is True
    monkeypatch.setitem(ledger.FUNCTIONS, "P", "a1 + 1")
    assert ledger.differences_are_linear() is ledger.differences_follow_one_by_one() is False


def printed(monkeypatch: pytest.MonkeyPatch, old: str, new: str) -> None:
    """The paper with other words."""
    honest = words.quoted
    monkeypatch.setattr(words, "quoted", lambda label: honest(label).replace(old, new))


@pytest.mark.parametrize(
    ("old", "new", "answers"),
    [
        ("nothing", "", (False, False)),
        (":= =r_{b,n}", ":=r_{b,n}", (True, False)),
        (r"P_\nu-3$", r"P_{\nu-3}$", (False, True)),
        (r"P_\nu-3$", r"P_{\nu-4}$", (False, False)),
        ("r_{b,n}", "r_n", (None, False)),
    ],
)
def test_misprints(
    monkeypatch: pytest.MonkeyPatch, old: str, new: str, answers: tuple[bool | None, bool | None]
) -> None:
    printed(monkeypatch, old, new)
    assert tuple(words.agree(ledger.SIGNS_AND_CLASSES, *places) for places in ledger.MISPRINTS.values()) == answers


def test_the_side_where_trajectories_come_from(monkeypatch: pytest.MonkeyPatch) -> None:
    checks = (ledger.ansatz_is_on_the_side, ledger.comes_to_the_g_spot_on_the_side)
    assert [check(form) for check in checks for form in ("printed", "corrected")] == [False, True] * 2
    printed(monkeypatch, "manifold for $p<0$.", "manifold for $p>0$.")
    assert [check("printed") for check in checks] == [True, True]
    printed(monkeypatch, "critical manifold for", "manifold for")
    assert [check("printed") for check in checks] == [None, None]


def test_the_ansatz_in_the_other_direction_of_time(monkeypatch: pytest.MonkeyPatch) -> None:
    printed(monkeypatch, r"\xi_0(-t)^r", r"\xi_0(t)^r")
    assert ledger.ansatz_is_on_the_side("printed") is True
    printed(monkeypatch, r"\xi_0(t)^r", r"\xi_0(|t|)^r")
    assert ledger.ansatz_is_on_the_side("printed") is None


def test_names_of_manifolds(monkeypatch: pytest.MonkeyPatch) -> None:
    names = ("critical", "slow", "other", None)
    assert [ledger.name_at_epsilon_0(word) for word in names] == [True, False, None, None]
    assert [ledger.name_near_by(word) for word in names] == [False, True, None, None]
    monkeypatch.setitem(section_5_outer.PRINTED["5-outer-system"], "v", "b + p*lam + p*y")
    assert ledger.name_at_epsilon_0("critical") is False
    monkeypatch.setitem(section_5_outer.PRINTED["5-outer-system"], "v", "b")
    assert ledger.has_others_near_by() is True
    monkeypatch.setitem(section_5_outer.PRINTED["5-outer-system"], "v", "b + q*lam")
    assert ledger.has_others_near_by() is None
