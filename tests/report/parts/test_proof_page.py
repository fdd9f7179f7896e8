"""Proof pages as HTML: every word of the page is there, and links lead to pages that exist."""

import html
import re

import pytest

from gspot_verified.report.parts.proof_page import PROOFS, linked_pages, page_title, proof_html, proof_pages, proof_text

PAGES = sorted(proof_pages())


def test_the_pages_are_those_of_the_folder():
    assert {f"{name}.md" for name in PAGES} | {"README.md"} == {path.name for path in PROOFS.glob("*.md")}


def words(text):
    return re.findall(r"[A-Za-z]{4,}", text)


@pytest.mark.parametrize("name", PAGES)
def test_no_word_is_lost(name):
    text = proof_text(name, proof_pages()[name])
    shown = html.unescape(re.sub(r"<[^>]*>", " ", proof_html(name, text, PAGES)))
    plain = re.sub(r"\]\([^)]*\)", "]", text)
    assert words(shown) == words(plain)


@pytest.mark.parametrize("name", PAGES)
def test_links_lead_to_pages(name):
    text = proof_text(name, proof_pages()[name])
    for link in re.findall(r'href="([^"]*)"', proof_html(name, text, PAGES)):
        assert link == "proofs.html" or link.removeprefix("proof-").removesuffix(".html") in PAGES
    assert set(linked_pages(text)) <= set(PAGES)
    assert page_title(text)


def test_another_version_of_a_page_is_not_shown():
    assert proof_text("signs", 64 * "0") is None
    assert proof_text("no_such_page", 64 * "0") is None
    assert proof_text("../README", "") is None


def test_markup_and_blocks():
    shown = proof_html("x", "# A <b>\n\n    x_1 <= 2\n\n```\na_1\n```\n\n```json\na_1\n```\n\n[t](other.md)\n", [])
    assert "<b>" not in shown
    assert '<div class="formulas"><i>x</i><sub>1</sub> ≤ 2</div>' in shown
    assert "<pre><code>a_1" in shown
    assert "href" not in shown
