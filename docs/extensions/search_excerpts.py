"""Excerpts under the results of the search, also where the site is read from a disk.

Sphinx fetches each page that it found and cuts an excerpt out of it. A browser fetches nothing from a disk, so the
texts of all pages stand in one script. Only the page of the search loads it; it answers in the place of the fetch.
"""

from __future__ import annotations

import html
import json
from pathlib import Path
from typing import Any

from docutils import nodes

SCRIPT = "excerpts.js"
_ANSWER = """
(() => {
  const ask = window.fetch;
  window.fetch = (address, ...options) => {
    const page = PAGES[String(address).replace(/^(\\.\\/)+/, "").replace(/\\.html$/, "")];
    return page === undefined ? ask(address, ...options) : Promise.resolve({ text: () => Promise.resolve(page) });
  };
})();
"""


def page_text(page: nodes.document) -> str:
    """The words of a page as HTML that has nothing but its sections, each with the name that a link to it has."""
    return f'<div role="main">{"".join(_shown(part) for part in page.children)}</div>'


def _shown(part: nodes.Node) -> str:
    if isinstance(part, nodes.section):
        begin = "".join(f'<section id="{html.escape(name)}">' for name in part["ids"])
        return begin + "".join(_shown(child) for child in part.children) + "</section>" * len(part["ids"])
    if isinstance(part, nodes.comment | nodes.raw | nodes.target | nodes.substitution_definition):
        return ""
    return f"<p>{html.escape(_words(part))}</p>\n"


def _words(part: nodes.Node) -> str:
    """The text with a space between blocks, where ``astext`` has none."""
    return " ".join(part.astext().split())


def script(pages: dict[str, str]) -> str:
    """The whole script."""
    return f"const PAGES = {json.dumps(pages, ensure_ascii=False, sort_keys=True)};{_ANSWER}"


def write_script(app: Any, error: Exception | None) -> None:
    """After a build: the texts of all pages."""
    if error is None and app.builder.format == "html":
        pages = {name: page_text(app.env.get_doctree(name)) for name in sorted(app.env.found_docs)}
        (Path(app.outdir) / "_static" / SCRIPT).write_text(script(pages), encoding="utf-8")


def on_the_search_page(app: Any, pagename: str, _template: str, _context: Any, _page: Any) -> None:
    """The script is large: no other page loads it."""
    if pagename == "search":
        app.add_js_file(SCRIPT)


def setup(app: Any) -> dict[str, Any]:
    """Sphinx's hook."""
    app.connect("html-page-context", on_the_search_page)
    app.connect("build-finished", write_script)
    return {"version": "1", "parallel_read_safe": True}
