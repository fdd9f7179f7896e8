"""Words of the paper are compared only where each pattern finds them once."""

from __future__ import annotations

import pytest

from gspot_verified.paper.checks import words
from gspot_verified.paper.checks.words import Place, agree, held_against, quoted, said

LABEL = "lines 2224 to 2225 and 2247 to 2250"
ONE = Place("one", r"The (\w+) curves were")
OTHER = Place("other", r"whereas the (\w+) curves")
NOWHERE = Place("nowhere", r"the (\w+) surfaces")
TWICE = Place("twice", r"The (red|blue) curve")


def test_what_is_said() -> None:
    assert said(LABEL, ONE) == "blue"
    assert said(LABEL, OTHER) == "red"
    assert said(LABEL, NOWHERE) is None
    assert said(LABEL, TWICE) is None
    assert said("no such label", ONE) is None


def test_quoted_lines_are_one_line() -> None:
    assert "\n" not in quoted(LABEL)
    assert quoted("no such label") == ""


@pytest.mark.parametrize(
    ("first", "second", "answer"), [(ONE, ONE, True), (ONE, OTHER, False), (ONE, NOWHERE, None), (TWICE, ONE, None)]
)
def test_two_places(first: Place, second: Place, answer: bool | None) -> None:
    assert agree(LABEL, first, second) is answer
    check = held_against(LABEL, "the colour", first, second)
    assert check.agrees is answer
    assert first.name in check.finding
    assert second.name in check.finding


def test_mended_words_agree(monkeypatch: pytest.MonkeyPatch) -> None:
    honest = words.quoted
    monkeypatch.setattr(words, "quoted", lambda label: honest(label).replace("the red curves", "the blue curves"))
    assert agree(LABEL, ONE, OTHER) is True
