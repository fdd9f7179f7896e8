"""The search finds a text for each page and each section, in a site that is read from a disk."""

from __future__ import annotations

import json

from docutils import nodes
from docutils.core import publish_doctree
from search_excerpts import page_text, script

SOURCE = """
Title
=====

Words of ``code`` & more.

.. raw:: html

   <b>not these</b>

Part
----

One <tag> of the part.

Deeper
~~~~~~

The end.
"""


def doctree() -> nodes.document:
    return publish_doctree(SOURCE, settings_overrides={"doctitle_xform": False})


def test_sections_nest_with_the_names_of_their_links() -> None:
    text = page_text(doctree())
    assert text.startswith('<div role="main"><section id="title"><p>Title</p>')
    part = text[text.index('<section id="part">') :]
    assert "<p>One &lt;tag&gt; of the part.</p>" in part
    assert '<section id="deeper"><p>Deeper</p>\n<p>The end.</p>\n</section></section></section></div>' in part


def test_what_is_not_read_is_left_out() -> None:
    text = page_text(doctree())
    assert "Words of code &amp; more." in text
    assert "not these" not in text


def test_the_script_holds_the_pages_whole() -> None:
    pages = {"b": "λ </script> \" '", "a/c": page_text(doctree())}
    text = script(pages)
    held, _ = json.JSONDecoder().raw_decode(text.removeprefix("const PAGES = "))
    assert held == pages
    assert "window.fetch = " in text
