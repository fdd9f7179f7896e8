"""The glossary of the report as a page of the site: the terms are those of the report, none is written here."""

from __future__ import annotations

import re
from collections.abc import Iterator

from gspot_verified.paper.checks.entry import Rung
from gspot_verified.report.parts.glossary import Term, glossary
from gspot_verified.report.parts.latex import latex_formula

_HEAD = """# Glossary

The words of the paper, of this site and of the report that `gspot-verified verify` writes ("this report" below).
Under each stands where the paper has it; a formula is set from that place of its source. A word without a place is
not of the paper. [The theory on one page](theory.md) shows how they hang together.
"""
_MARKS = re.compile(r"([\\`*_\[\]<>|~$])")


def glossary_page() -> str:
    """The page in Markdown; ``#glossary-KEY`` is the place of a term."""
    return "\n".join([_HEAD, *(line for term in glossary() for line in _entry(term))])


def plain(text: str) -> str:
    """Text of which Markdown makes nothing else."""
    return _MARKS.sub(r"\\\1", text)


def title(term: Term) -> str:
    """The term's title; titles are not typeset, so that indices are small figures."""
    return re.sub(r"_(\d)", lambda index: chr(ord("₀") + int(index[1])), term.title)


def _entry(term: Term) -> Iterator[str]:
    yield f"(glossary-{term.key})="
    yield f"## {plain(title(term))}\n"
    yield plain(term.meaning) + "\n"
    if term.printed is not None:
        yield f"```{{raw}} html\n<div>{latex_formula(term.printed.formula, display=True)}</div>\n```\n"
    if term.key == "rung":
        yield from (f"1. {plain(rung.short)}: {plain(rung.value)}" for rung in Rung)
        yield ""
    if term.cited:
        yield f"In the paper: {plain(', '.join(term.cited))}.\n"
    if term.pages:
        yield "Proofs: " + ", ".join(f"[{page}](proofs/{page}.md)" for page in term.pages) + ".\n"
