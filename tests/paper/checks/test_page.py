"""A check on a proof page holds when its steps do; no check of the ledger carries a typed answer."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

from gspot_verified.paper.checks.entry import Check, Entry, Rung
from gspot_verified.paper.checks.page import Page, joined

ROOT = Path(__file__).resolve().parents[3]
LEDGER = ROOT / "gspot_verified" / "paper"


def holds() -> bool:
    return True


def fails_here() -> bool:
    return False


def cannot_tell() -> None:
    return None


def test_all_steps_must_hold() -> None:
    assert Page("signs", (holds,)).refutation("a", "b") == Check(Rung.PAGE, "proofs/signs.md: a", False, "b")
    for step in (fails_here, cannot_tell):
        page = Page("signs", (holds, step))
        words = "steps that do not hold: " + step.__name__.replace("_", " ")
        for found in (page.refutation("a", "b"), page.carries(Check(Rung.EXACT, "a", False, "c"))):
            assert found == Check(Rung.PAGE, "proofs/signs.md: a", None, words)


@pytest.mark.parametrize("agrees", [True, False, None])
def test_a_comparison_keeps_its_answer_on_the_rung_of_the_page(agrees: bool | None) -> None:
    found = Page("signs", (holds,)).carries(Check(Rung.EXACT, "a", agrees, "c"))
    assert found == Check(Rung.PAGE, "proofs/signs.md: a", agrees, "c")


def test_a_page_without_steps_is_refused() -> None:
    with pytest.raises(ValueError, match=r"proofs/signs\.md: a page without a step"):
        Page("signs", ())


def calls(tree: ast.Module, name: str) -> Iterator[ast.Call]:
    """The calls of a function or a class by its name."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == name:
            yield node


def typed_answers(source: str) -> list[int]:
    """The lines of checks whose answer is a constant."""
    found = []
    for call in calls(ast.parse(source), "Check"):
        answers = [*call.args[2:3], *(word.value for word in call.keywords if word.arg == "agrees")]
        found += [call.lineno for answer in answers if isinstance(answer, ast.Constant)]
    return found


def test_a_typed_answer_is_found() -> None:
    assert typed_answers('Check(Rung.PAGE, "a", True)') == [1]
    assert typed_answers('\nCheck(Rung.EXACT, "a", agrees=False, finding="b")') == [2]
    assert typed_answers('Check(Rung.EXACT, "a", found is None, "b")') == []


@pytest.mark.parametrize("path", sorted(LEDGER.rglob("*.py")), ids=lambda path: path.stem)
def test_no_answer_is_typed_and_pages_come_with_their_steps(path: Path) -> None:
    source = path.read_text(encoding="utf-8")
    assert typed_answers(source) == []
    if path.stem not in ("entry", "page"):
        attributes = [node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Attribute)]
        assert not [node.lineno for node in attributes if node.attr == "PAGE"]
    steps = [call.args[1] for call in calls(ast.parse(source), "Page")]
    assert not [step.lineno for step in steps if any(isinstance(node, ast.Lambda) for node in ast.walk(step))]


def test_every_check_on_the_rung_of_a_page_names_a_page_that_is_there(whole_ledger: list[Entry]) -> None:
    pages = [check.what for entry in whole_ledger for check in entry.checks if check.rung is Rung.PAGE]
    assert pages
    for what in pages:
        path, separator, _ = what.partition(": ")
        assert separator
        assert (ROOT / path).is_file(), what


def test_checks_are_joined_on_one_rung_alone() -> None:
    true, false = (Check(Rung.PAGE, f"proofs/negative.md: {word}", word == "yes", word) for word in ("yes", "no"))
    assert joined(true, true).agrees is True
    assert (joined(true, false).agrees, joined(true, false).finding) == (False, "no")
    with pytest.raises(ValueError, match="checks on pages"):
        joined(true, Check(Rung.POINTS, "some points", True))
