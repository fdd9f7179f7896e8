"""What an entry's label cites: the printed numbers, and the exact lines of the source.

A label names the source's own labels (with or without "eq:"), ranges of them ("specialX to specialL") and lines
("line 380", "lines 664 to 702", "lines 1253 and 1284", "lines 2031-2041, 2063-2071"). What stands in brackets, plain
words, and "of th:1" cite nothing.

Write the data of the ledger again: ``PYTHONPATH=.:tests python -m paper.paper_citations ../shared/paper.tex``
"""

from __future__ import annotations

import hashlib
import json
import re
import sys
from collections.abc import Iterable
from itertools import groupby
from pathlib import Path
from typing import Any

from paper.paper_reader import Document, Numbered, Span, read

DATA = Path(__file__).resolve().parents[2] / "gspot_verified" / "paper" / "paper_source.json"
_RANGE = r"(\d+)(?:(?: to |-)(\d+))?"
_LINES = re.compile(r"lines? (\d+(?:(?: to |-|, | and )\d+)*)")
_SENTENCE_END = re.compile(r"(?<!Fig)(?<!Eq)(?<!Eqs)(?<!Sec)(?<!e\.g)(?<!i\.e)[.!?][)}]*(?=\s|$)")
_BOUNDARY = re.compile(r"\s*$|\s*\\(begin|end|item|section|subsection|label)\b")


def source_data(paper: str, labels: Iterable[str]) -> dict[str, Any]:
    """The data that the package ships: every printed number, and the citation of each entry's label."""
    document = read(paper)
    numbers = {item.label: name_of(item) for item in document.numbered if item.label}
    return {
        "sha256": hashlib.sha256(paper.encode()).hexdigest(),
        "numbers": numbers,
        "places": [
            f"{item.first} {item.last} {name}" for item in document.numbered if (name := name_of(item)) is not None
        ],
        "citations": {label: citation(document, label) for label in sorted(set(labels))},
    }


def citation(document: Document, label: str) -> dict[str, Any]:
    """The printed numbers of an entry's label, and the quoted lines.

    :raises ValueError: a word of the label that is no plain word is no label of the source either.
    """
    items, spans = _read_label(document, label)
    found = [*items, *(item for span in spans for item in _numbered_in(document, span))]
    cited = [Span(item.first, item.last) for item in items if item.kind != "section"]
    quoted = _merged([*_without_containers(items, cited), *(extended(document, span) for span in spans)])
    lines = document.lines
    return {
        "printed": printed_numbers(found),
        "quotations": [
            {"first": span.first, "last": span.last, "latex": "\n".join(lines[span.first - 1 : span.last])}
            for span in quoted
        ],
    }


def _read_label(document: Document, label: str) -> tuple[list[Numbered], list[Span]]:
    names = {key: item for item in document.numbered if item.label for key in (item.label, item.label.split(":")[-1])}
    text = re.sub(r"\([^)]*\)| of \S+", "", label)
    spans = []
    for numbers in _LINES.findall(text):
        spans += [Span(int(first), int(last or first)) for first, last in re.findall(_RANGE, numbers)]
    items: list[Numbered] = []
    to = False
    for word in re.findall(r"[^\s,;]+", _LINES.sub("", text)):
        word = word.rstrip(".")
        if word in names:
            if to:
                start, end = document.numbered.index(items[-1]), document.numbered.index(names[word])
                items += [item for item in document.numbered[start + 1 : end] if item.kind == "equation"]
            items.append(names[word])
        elif not re.fullmatch("[a-z]+", word):
            raise ValueError(f"{label!r}: {word!r} is no label of the source")
        to = word == "to"
    return items, spans


def name_of(item: Numbered) -> str | None:
    """An object as the printed paper names it; None where it has no number."""
    if item.number is None:
        return None
    if item.kind == "equation":
        return f"eq. ({item.number})"
    words = {"figure": "Figure", "table": "Table", "section": "Section" if item.number[0].isdigit() else "Appendix"}
    return f"{words.get(item.kind, item.kind)} {item.number}"


def printed_numbers(items: Iterable[Numbered]) -> str:
    """The names of some objects, neighbouring equations as a range.

    >>> printed_numbers(Numbered("equation", f"A.{n}", None, n, n) for n in (5, 1, 2, 3))
    'eqs. (A.1) to (A.3) and (A.5)'
    """
    found = {name: item for item in items if (name := name_of(item)) is not None}
    equations = sorted((item for item in found.values() if item.kind == "equation"), key=lambda item: item.first)
    others = [name for name, item in found.items() if item.kind != "equation"]
    ranges = []
    for _, run in groupby(enumerate(equations), lambda pair: _place(pair[1])[1] - pair[0]):
        members = [f"({item.number})" for _, item in run]
        ranges += [f"{members[0]} to {members[-1]}"] if len(members) > 2 else members
    if ranges:
        front, last = ", ".join(ranges[:-1]), ranges[-1]
        others.append(("eq. " if len(equations) == 1 else "eqs. ") + (f"{front} and {last}" if front else last))
    return ", ".join(others)


def _place(item: Numbered) -> tuple[str, int]:
    head, _, number = (item.number or "").rpartition(".")
    return head, int(number)


def _numbered_in(document: Document, span: Span) -> list[Numbered]:
    """The numbered rows that the lines touch, and the theorems that begin in them."""
    rows = [i for i in document.numbered if i.kind == "equation" and i.first <= span.last and span.first <= i.last]
    theorems = [i for i in document.numbered if i.kind[0].isupper() and span.first <= i.first <= span.last]
    return theorems + rows


def _without_containers(items: list[Numbered], cited: list[Span]) -> list[Span]:
    """Without a theorem that holds another cited equation: the equation alone is quoted."""
    return [
        span
        for item, span in zip((i for i in items if i.kind != "section"), cited, strict=True)
        if item.kind == "equation" or not any(_inside(other, span) for other in cited if other != span)
    ]


def _inside(inner: Span, outer: Span) -> bool:
    return outer.first <= inner.first and inner.last <= outer.last


def _merged(spans: Iterable[Span]) -> list[Span]:
    """Sorted, and joined where they overlap or touch."""
    found: list[Span] = []
    for span in sorted(spans, key=lambda span: (span.first, span.last)):
        if found and span.first <= found[-1].last + 1:
            found[-1] = Span(found[-1].first, max(found[-1].last, span.last))
        else:
            found.append(span)
    return found


def extended(document: Document, span: Span) -> Span:
    """The lines with the rest of the row, the display or the sentence that they cut."""
    for pieces in (document.rows, document.displays):
        ends = [next((p for p in pieces if p.first <= line <= p.last), None) for line in (span.first, span.last)]
        whole = _display(document, span.first)
        if ends[0] and ends[1] and whole == _display(document, span.last):
            return Span(ends[0].first, ends[1].last)
    first, last = _display(document, span.first), _display(document, span.last)
    return Span(
        first.first if first else _sentence_start(document, span.first),
        last.last if last else _sentence_end(document, span.last),
    )


def _display(document: Document, line: int) -> Span | None:
    return next((display for display in document.displays if display.first <= line <= display.last), None)


def _sentence_start(document: Document, line: int) -> int:
    def starts(at: int) -> bool:
        before, here = document.lines[at - 2], document.lines[at - 1]
        if _BOUNDARY.match(before) or _display(document, at - 1) or here.lstrip().startswith(r"\item"):
            return True
        ends = [match.end() for match in _SENTENCE_END.finditer(here.rstrip())]
        inside = at < line and any(end < len(here.rstrip()) for end in ends)
        return inside or any(match.end() == len(before.rstrip()) for match in _SENTENCE_END.finditer(before.rstrip()))

    return next(at for at in range(line, 0, -1) if starts(at))


def _sentence_end(document: Document, line: int) -> int:
    def ends(at: int) -> bool:
        here, after = document.lines[at - 1].rstrip(), document.lines[at]
        if _BOUNDARY.match(after) or _display(document, at + 1):
            return True
        found = [match.end() for match in _SENTENCE_END.finditer(here)]
        return any(end == len(here) for end in found) or (at > line and bool(found))

    return next(at for at in range(line, len(document.lines)) if ends(at))


def text_of(data: dict[str, Any]) -> str:
    """The data file's text: a number, a place, a citation stands in one line."""
    parts = [f" {json.dumps(name)}: {_lines_of(part)}" for name, part in data.items()]
    return "{\n" + ",\n".join(parts) + "\n}\n"


def _lines_of(part: Any) -> str:
    def line(data: Any) -> str:
        return json.dumps(data, ensure_ascii=False)

    if isinstance(part, dict):
        return "{\n" + ",\n".join(f"  {line(key)}: {line(each)}" for key, each in part.items()) + "\n }"
    return "[\n" + ",\n".join(f"  {line(each)}" for each in part) + "\n ]" if isinstance(part, list) else line(part)


if __name__ == "__main__":
    from gspot_verified.paper.verify import verify_paper

    _paper = Path(sys.argv[1]).read_text(encoding="utf-8")
    DATA.write_text(text_of(source_data(_paper, [entry.label for entry in verify_paper()])), encoding="utf-8")
