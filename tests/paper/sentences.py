"""The sentences of a paper: prose, captions, items of lists, tables and displays, with the lines where they stand.

A sentence goes on through the displays that it holds. It ends at a full stop (a question mark, an exclamation mark)
before a capital letter, at a display that ends with a full stop or has no mark of its own before a capital letter, at
an empty line, and where an environment, an item, a caption or a heading begins or ends. Headings are no sentences.

``sentences.tsv`` keeps them: lines, mark, sum, first words. The mark says that a sentence is in a row of
``claims.toml``, or why it makes no claim. List them, each with its rows, and write the file again with its marks:
``PYTHONPATH=.:tests python -m paper.sentences ../shared/paper.tex``
"""

from __future__ import annotations

import re
import sys
import zlib
from bisect import bisect_right
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

from gspot_verified.paper.claims import PaperClaim, paper_claims

_NAMES = r"(?:equation|align|eqnarray|multline|gather)\*?"
_DISPLAY = re.compile(rf"\\begin\{{({_NAMES}|tabular)\}}.*?\\end\{{\1\}}|\$\$.*?\$\$", re.DOTALL)
_INLINE = re.compile(r"(?<!\\)\$[^$]*\$")
_BRACES = r"\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\}"
_SILENT = re.compile(
    rf"""\\label\s*\{{[^}}]*\}} | \\(?:small|med|big)skip\b | \\newpage\b | \\appendix\b | \\maketitle\b
       | \\cline{_BRACES} | \\numberwithin{_BRACES}{_BRACES}
       | \\(?:title|author|date|section|subsection|subsubsection)\*?{_BRACES}
       | \\bibliography(?:style)?{_BRACES} | \\includegraphics(?:\[[^\]]*\])?{_BRACES} | \\hspace{_BRACES}
    """,
    re.VERBOSE,
)
_WALL = re.compile(r"\\(?:begin|end)\{\w+\*?\}(?:\[[^\]]*\])?|\\item\b(?:\[[^\]]*\])?|\\caption\b|\\paragraph\*?")
_STOP = re.compile(r"[.?!][)}'\"]*(?=\s+[A-Z\\`(\"$\x01\x02]|\s*$)")
_SHORT = re.compile(r"(?:\b(?:Figs?|Secs?|Eqs?|Ch|cf|vs|al|i\.e|e\.g)|\b[A-Z])$")
_PLAIN = re.compile(r"\\[A-Za-z]+\*?|[^\w.,;:()=+-]+")


@dataclass(frozen=True)
class Sentence:
    """The lines that are for the most part of this sentence, its first words, and a sum over all of it."""

    first: int
    last: int
    words: str
    sum: str


def sentences(paper: str) -> list[Sentence]:
    """All sentences between the begin and the end of the document.

    >>> [(s.first, s.last, s.words) for s in sentences("A is, e.g. small (see Fig. 2).\\n$$ x=1. $$\\nSo it is.")]
    [(1, 1, 'A is, e.g. small'), (2, 2, 'x=1.'), (3, 3, 'So it is.')]
    """
    text = _silenced(paper)
    return _owned(text, _spans(text))


def _blank(match: re.Match[str]) -> str:
    """As many characters, of which the line breaks alone are left."""
    return re.sub(r"[^\n]", " ", match[0])


def _silenced(paper: str) -> str:
    """The text with what is no part of a sentence blanked, place for place, and each macro of a display written out."""
    text = re.sub(r"(?<!\\)%.*", _blank, paper)
    start, end = text.find(r"\begin{document}"), text.find(r"\end{document}")
    if start >= 0:
        text = re.sub(r"[^\n]", " ", text[:start]) + text[start : end if end >= 0 else None]
    text = re.sub(r"\\beq(?![A-Za-z])", r"$$  ", re.sub(r"\\eeq(?![A-Za-z])", r"  $$", text))
    return _SILENT.sub(_blank, text)


def _spans(text: str) -> list[tuple[int, int]]:
    """Where each sentence begins and ends."""
    displays = [match.span() for match in _DISPLAY.finditer(text)]
    masked = _DISPLAY.sub(lambda match: re.sub(r"[^\n]", "\x02", match[0]).replace("\n", "\x02"), text)
    masked = _INLINE.sub(lambda match: "\x01" * len(match[0]), masked)
    masked = _WALL.sub(lambda match: match[0].replace(".", " "), masked)
    cuts = {0, len(text)}
    for match in (*_WALL.finditer(masked), *re.finditer(r"\n[ \t]*\n", masked)):
        cuts |= {match.start(), match.end()}
    for match in _STOP.finditer(masked):
        if not _SHORT.search(masked, max(match.start() - 12, 0), match.start()):
            cuts.add(match.end())
    for (_, end), following in pairwise([*displays, (len(text), len(text))]):
        after = masked[end : following[0]]
        inside = re.sub(r"\\end\{[^}]*\}$|\$\$$", "", text[:end].rstrip()).rstrip()
        stops = inside.endswith((".", r".\end{array}")) or (re.match(r"\s*[A-Z]", after) and not inside.endswith(","))
        if stops or not after.strip():
            cuts.add(end)
    found = []
    for start, end in pairwise(sorted(cuts)):
        piece = _WALL.sub("", masked[start:end])
        if re.search(r"[A-Za-z\x02]{2}", re.sub(r"\\[A-Za-z]+\*?", "", piece)):
            found.append((start, end))
    return found


def _owned(text: str, spans: list[tuple[int, int]]) -> list[Sentence]:
    """The sentences: each line belongs to the one with the most characters on it; a short one keeps its longest."""
    starts = [0, *(match.end() for match in re.finditer("\n", text)), len(text) + 1]
    share: dict[int, Counter[int]] = {}
    for number, (start, end) in enumerate(spans):
        for line in range(bisect_right(starts, start), bisect_right(starts, end - 1) + 1):
            piece = text[max(start, starts[line - 1]) : min(end, starts[line])]
            if piece.strip():
                share.setdefault(line, Counter())[number] = len(piece.strip())
    lines: dict[int, list[int]] = {}
    for line, counts in share.items():
        lines.setdefault(counts.most_common(1)[0][0], []).append(line)
    found = []
    for number, (start, end) in enumerate(spans):
        own = lines.get(number) or [max(share, key=lambda line: share[line][number])]
        whole = " ".join(_WALL.sub(" ", text[start:end]).split())
        words = " ".join(_PLAIN.sub(" ", whole).split()[:4])[:30].rstrip()
        found.append(Sentence(min(own), max(own), words, f"{zlib.crc32(whole.encode()):08x}"))
    return found


IN_A_ROW = "claim"
CLASSES = {
    "announcement": "says what is done elsewhere in the paper",
    "assumption": "what is assumed",
    "definition": "a definition, a choice, or a requirement",
    "method": "how a computation was made",
    "motivation": "why something is asked or done",
    "notation": "what a sign stands for",
    "opinion": "a judgement that nothing can decide",
    "question": "a question",
    "citation": "what other works say or do, with no claim about the system",
    "heading": "a title in the line",
    "thanks": "an acknowledgement",
}
"""Why a sentence makes no claim."""
DATA = Path(__file__).with_name("sentences.tsv")


def marked(text: str) -> list[tuple[Sentence, str]]:
    """The sentences as they are kept, each with ``IN_A_ROW`` or its class."""
    rows = [line.split("\t") for line in text.splitlines()]
    return [(Sentence(int(first), int(last), words, found), mark) for first, last, mark, found, words in rows]


def text_of(rows: Iterable[tuple[Sentence, str]]) -> str:
    """The text of the data file."""
    return "".join(f"{s.first}\t{s.last}\t{mark}\t{s.sum}\t{s.words}\n" for s, mark in rows)


def rows_of(sentence: Sentence, claims: Iterable[PaperClaim]) -> list[PaperClaim]:
    """The rows that hold a line of the sentence."""
    return [claim for claim in claims if claim.first <= sentence.last and sentence.first <= claim.last]


if __name__ == "__main__":
    _kept = {(sentence.sum, sentence.words): mark for sentence, mark in marked(DATA.read_text(encoding="utf-8"))}
    _found = sentences(Path(sys.argv[1]).read_text(encoding="utf-8"))
    _rows = [(sentence, _kept.get((sentence.sum, sentence.words), IN_A_ROW)) for sentence in _found]
    DATA.write_text(text_of(_rows), encoding="utf-8")
    for _sentence, _mark in _rows:
        _in = ", ".join(f"{claim.first}-{claim.last}" for claim in rows_of(_sentence, paper_claims()))
        print(
            _sentence.first, _sentence.last, _mark if _mark != IN_A_ROW else _in or "NO ROW", _sentence.words, sep="\t"
        )
