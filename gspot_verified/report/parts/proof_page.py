"""The proof pages of ``proofs/`` as HTML, their formulas typeset."""

from __future__ import annotations

import hashlib
import html
import re
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from gspot_verified.report.parts.formulas import formula, typeset

if TYPE_CHECKING:
    from markdown_it.token import Token

PROOFS = Path(__file__).resolve().parents[3] / "proofs"
"""The folder of the repository; an installed package has none."""

_OF_CODE = ("certificate", "check")  # what stands in blocks there is text of files, no formula
_LINK = re.compile(r"([\w-]+)\.md(#[\w-]*)?")


def proof_pages() -> dict[str, str]:
    """The SHA-256 of each proof page, by name; empty where the repository's folder is not there."""
    pages = sorted(PROOFS.glob("*.md")) if PROOFS.is_dir() else []
    return {page.stem: hashlib.sha256(page.read_bytes()).hexdigest() for page in pages if page.stem != "README"}


def proof_text(name: str, digest: str) -> str | None:
    """The text of a page, if the one that is here is the one that was meant.

    >>> proof_text("majorant", "another") is None
    True
    """
    path = PROOFS / f"{name}.md"
    content = path.read_bytes() if path.is_file() else b""
    return content.decode("utf-8") if hashlib.sha256(content).hexdigest() == digest else None


def linked_pages(text: str) -> list[str]:
    """The pages that a page links to, in order, each once.

    >>> linked_pages("by [signs.md](signs.md) and [tails.md](tails.md#x), [again](signs.md)")
    ['signs', 'tails']
    """
    return list(dict.fromkeys(name for name, _ in re.findall(rf"\]\({_LINK.pattern}\)", text) if name != "README"))


def page_title(text: str) -> str:
    """The first heading of a page."""
    return next((line.lstrip("# ") for line in text.splitlines() if line.startswith("#")), "")


def proof_html(name: str, text: str, known: Sequence[str]) -> str:
    """The page as HTML; links to pages that are not known lose their target."""
    from markdown_it import MarkdownIt

    reader = MarkdownIt("commonmark", {"html": False}).enable("table")
    renderer: Any = reader.renderer

    def words(tokens: Sequence[Token], index: int, *_: Any) -> str:
        return typeset(tokens[index].content)

    def block(tokens: Sequence[Token], index: int, *_: Any) -> str:
        content = tokens[index].content
        if name in _OF_CODE or tokens[index].info.strip():
            return f"<pre><code>{html.escape(content, quote=False)}</code></pre>\n"
        lines = "\n".join(formula(line) for line in content.rstrip("\n").splitlines())
        return f'<div class="formulas">{lines}</div>\n'

    renderer.rules.update({"text": words, "fence": block, "code_block": block})
    tokens = reader.parse(text)
    for token in tokens:
        _relink(token.children or [], known)
    shown: str = renderer.render(tokens, reader.options, {})
    return re.sub(r"<table>.*?</table>", r'<div class="scroll">\g<0></div>', shown, flags=re.DOTALL)


def _relink(tokens: list[Token], known: Sequence[str]) -> None:
    for token in tokens:
        if token.type == "link_open":
            match = _LINK.fullmatch(str(token.attrs["href"]))
            if match and match[1] in known:
                token.attrs["href"] = f"proof-{match[1]}.html"
            elif match and match[1] == "README":
                token.attrs["href"] = "proofs.html"
            else:
                token.attrs = {"class": "no-target"}
