"""The proof pages as Markdown shows them: no star of a formula is taken for emphasis."""

from __future__ import annotations

from pathlib import Path

import pytest
from markdown_it import MarkdownIt

PAGES = sorted((Path(__file__).resolve().parents[2] / "proofs").glob("*.md"))


def swallowed(text: str) -> list[str]:
    """What stands between two stars of formulas: emphasis that begins or ends inside a word."""
    found = []
    for token in MarkdownIt().parse(text):
        children = token.children or []
        for i, child in enumerate(children):
            if child.type == "em_open":
                end = next(j for j in range(i, len(children)) if children[j].type == "em_close")
                before = children[i - 1].content[-1:] if i else ""
                after = children[end + 1].content[:1] if end + 1 < len(children) else ""
                if before.isalnum() or after.isalnum():
                    found.append(children[i + 1].content)
    return found


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_no_formula_loses_its_stars(page: Path) -> None:
    assert swallowed(page.read_text(encoding="utf-8")) == []


def test_a_lost_star_is_seen() -> None:
    assert swallowed("rho = 9*2*2 here") == ["2"]
    assert swallowed("a *word* of α_1* and α_3* alone") == []
