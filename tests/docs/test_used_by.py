"""The table of proof pages names the files that cite each page, and what a page names is there."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest
import used_by

ROOT = Path(__file__).resolve().parents[2]
PAGES = sorted(page for page in used_by.PROOFS.glob("*.md") if page != used_by.LIST)


def gone(text: str) -> list[str]:
    """The files in the paragraph "Used by" that are not there."""
    paragraph = next((part for part in text.split("\n\n") if part.startswith("Used by ")), "")
    named = re.findall(r"`((?:[\w-]+/)+(?:[\w-]+\.py)?)`", paragraph)
    return [name for name in named if not any((place / name).exists() for place in (ROOT, ROOT / "gspot_verified"))]


def test_the_column_is_what_the_citations_say() -> None:
    text = used_by.LIST.read_text(encoding="utf-8")
    assert used_by.with_column(text, used_by.used_by()) == text, "run: python docs/extensions/used_by.py"


def test_every_page_is_cited() -> None:
    assert [page for page, files in used_by.used_by().items() if not files] == []


def test_the_column_follows_the_citations() -> None:
    row = "| [tails.md](tails.md) | a sign | `old.py` |\n"
    assert (
        used_by.with_column(row, {"tails": ["new.py", "b.py"]})
        == "| [tails.md](tails.md) | a sign | `new.py`, `b.py` |\n"
    )


def test_what_counts_as_a_citation() -> None:
    def cited(source: str) -> list[str]:
        return sorted(used_by.cited(ast.parse(source)))

    assert cited('def f():\n    """By ``proofs/tails.md``."""\n') == ["tails"]
    assert cited('"""By ``proofs/tails.md``."""\ncheck = Page("signs", ()).check("it")\n') == ["signs", "tails"]
    assert cited('# proofs/tails.md\nx = "proofs/tails.md"\n') == []


def test_who_imports_a_page_rests_on_it() -> None:
    assert list(used_by.constants(ast.parse('LEFT = Page("signs", ())\nother = page("tails")\n'))) == [
        ("LEFT", "signs")
    ]
    assert "paper/section_4_5/cases.py" in used_by.used_by()["signs"]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_what_a_page_names_is_there(page: Path) -> None:
    assert gone(page.read_text(encoding="utf-8")) == [], f"{page.name}, Used by: moved? give the new place"


def test_what_is_gone_is_seen() -> None:
    assert gone("# x\n\nUsed by `numbers/balls.py`, `numbers/gone.py` (`f`).\n\n`no/such.py`") == ["numbers/gone.py"]
