"""Counts of equations, and brackets that close."""

from __future__ import annotations

import pytest

from gspot_verified.paper.checks import words
from gspot_verified.paper.section_5 import section_5_outer
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
    checks = (ledger.ansatz_is_on_the_side, ledger.manifold_attracts_on_the_side)
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
