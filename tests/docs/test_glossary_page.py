"""The site's glossary is the report's: every term, whole, with its place; no second list."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from glossary_page import glossary_page, plain, title
from markdown_it import MarkdownIt

from gspot_verified.paper.checks.entry import Rung
from gspot_verified.report.parts.glossary import glossary

ROOT = Path(__file__).resolve().parents[2]
PAGE = glossary_page()


def test_every_term_stands_once_at_its_place() -> None:
    assert re.findall(r"^\(glossary-([\w-]+)\)=$", PAGE, re.MULTILINE) == [term.key for term in glossary()]
    assert PAGE.count("\n## ") == len(glossary())
    assert PAGE.count("<math") == sum(term.printed is not None for term in glossary())


def test_every_meaning_is_read_as_it_is_written() -> None:
    """Through Markdown, which takes nothing in it for markup."""
    shown = MarkdownIt().render(PAGE)
    words = re.sub(r"<[^>]*>", "", shown).replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&")
    for term in glossary():
        assert term.meaning in words.replace("&quot;", '"')
        assert title(term) in words
    assert all(rung.value in words for rung in Rung)


@pytest.mark.parametrize("text", ["*a* _b_", "`c`", "[d](e)", "<f>", "a | b", "~g~", r"h\i", "c_+ and c_−"])
def test_plain_text_stays(text: str) -> None:
    shown = MarkdownIt().enable("table").render(plain(text))
    assert shown.replace("&lt;", "<").replace("&gt;", ">") == f"<p>{text}</p>\n"


def test_titles_have_no_marks_of_indices() -> None:
    titles = {term.key: title(term) for term in glossary()}
    assert (titles["alphas"], titles["c1"], titles["epsilon-0"]) == ("α₁, α₂, α₃", "C₁", "ε₀")
    assert not any("_" in one for one in titles.values())


def test_links_to_terms_and_to_proof_pages_lead_somewhere() -> None:
    keys = {term.key for term in glossary()}
    for page in sorted((ROOT / "docs").glob("*.md")):
        assert set(re.findall(r"\(#glossary-([\w-]+)\)", page.read_text(encoding="utf-8"))) <= keys, page.name
    linked = set(re.findall(r"\(proofs/(\w+)\.md\)", PAGE))
    assert linked == {page for term in glossary() for page in term.pages}
    assert all((ROOT / "proofs" / f"{name}.md").exists() for name in linked)
