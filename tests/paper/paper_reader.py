"""The numbers that LaTeX prints, read from a paper's source: equations, theorems, sections, figures, tables.

A small reader of LaTeX's counters, with no LaTeX at hand: rows of aligned displays, ``\\nonumber``, ``\\notag``,
``\\tag``, starred environments, ``subequations``, theorem counters that share, ``\\appendix``, ``\\numberwithin``,
captions, macros that stand for ``\\begin{...}`` and ``\\end{...}``. Lines are counted from 1.
"""

from __future__ import annotations

import re
from collections import defaultdict
from dataclasses import dataclass, field

SINGLE = {"equation", "multline"}
ROWS = {"align", "alignat", "flalign", "gather", "eqnarray"}
FLOATS = {"figure", "table"}
_BODY = r"\begin{document}"
_TOKEN = re.compile(
    r"""\\(?P<open>begin|end)\s*\{(?P<environment>[A-Za-z]+)(?P<star>\*?)\}
      | \\(?P<sectioning>section|subsection|subsubsection)(?P<unnumbered>\*?)\s*[\[{]
      | \\(?P<appendix>appendix)\b
      | \\numberwithin\{(?P<counter>\w+)\}\{(?P<within>\w+)\}
      | \\label\s*\{(?P<label>[^}]*)\}
      | \\(?P<silent>nonumber|notag)\b
      | \\tag\*?\s*\{(?P<tag>[^}]*)\}
      | \\(?P<caption>caption)\b
      | (?P<row>\\\\)
      | (?P<dollars>\$\$|\\\[|\\\])
      | \\[{}$%&] | (?P<brace>[{}])
    """,
    re.VERBOSE,
)


@dataclass
class Numbered:
    """Something with a number, a label, or both: ``number`` is None where LaTeX prints none."""

    kind: str
    number: str | None
    label: str | None
    first: int
    last: int


@dataclass(frozen=True)
class Span:
    """The first and the last line of a display, or of one row of it."""

    first: int
    last: int


@dataclass
class Document:
    """What the reader found, in the order of the source."""

    lines: list[str]
    numbered: list[Numbered] = field(default_factory=list)
    displays: list[Span] = field(default_factory=list)
    rows: list[Span] = field(default_factory=list)

    def labelled(self, label: str) -> Numbered:
        """The object that carries a label.

        :raises KeyError: no label, or more than one, has this name.
        """
        found = [item for item in self.numbered if item.label == label]
        if len(found) != 1:
            raise KeyError(f"{label}: {len(found)} labels")
        return found[0]


def read(text: str) -> Document:
    """Read a whole source."""
    return _Reader(text).document


class _Counters:
    """LaTeX's counters, as ``\\newtheorem``, ``\\numberwithin`` and ``\\appendix`` set them up."""

    def __init__(self) -> None:
        self.within: dict[str, str] = {}
        self._values: dict[str, int] = defaultdict(int)
        self._appendix = False

    def begin_appendix(self) -> None:
        self._appendix = True
        self._values["section"] = 0

    def reset(self, counter: str) -> None:
        self._values[counter] = 0

    def step(self, counter: str) -> str:
        """One more, and what it prints."""
        self._values[counter] += 1
        for other, parent in {"subsection": "section", "subsubsection": "subsection", **self.within}.items():
            if parent == counter:
                self._values[other] = 0
        return self._printed(counter)

    def _printed(self, counter: str) -> str:
        value = self._values[counter]
        if counter == "section":
            return chr(ord("A") + value - 1) if self._appendix else str(value)
        if counter == "subequation":
            return chr(ord("a") + value - 1)
        parent = {"subsection": "section", "subsubsection": "subsection", **self.within}.get(counter)
        return f"{self._printed(parent)}.{value}" if parent else str(value)


@dataclass
class _Row:
    first: int
    silent: bool = False
    tag: str | None = None
    labels: list[str] = field(default_factory=list)


@dataclass
class _Display:
    name: str
    starred: bool
    first: int
    row: _Row
    depth: int = 0


class _Reader:
    def __init__(self, text: str) -> None:
        self.document = Document(text.split("\n"))
        self._text = _with_environments(re.sub(r"(?<!\\)((?:\\\\)*)%.*", r"\1", text))
        self._counters = _Counters()
        self._theorems: dict[str, tuple[str, str]] = {}  # environment: title, counter
        self._open: list[Numbered] = []  # the section, and the theorem, figure or table inside it
        self._display: _Display | None = None
        self._parent: str | None = None  # the equation number that subequations share
        pattern = r"\\newtheorem\{(\w+)\}(?:\[(\w+)\])?\{([^}]*)\}(?:\[(\w+)\])?"
        for name, shared, title, within in re.findall(pattern, self._text):
            self._theorems[name] = (title, shared or name)
            if within:
                self._counters.within[name] = within
        for token in _TOKEN.finditer(self._text, max(self._text.find(_BODY), 0)):
            self._take(token)

    def _line(self, position: int) -> int:
        return self._text.count("\n", 0, position) + 1

    def _take(self, token: re.Match[str]) -> None:
        found = token.groupdict()
        if found["open"]:
            name, starred = found["environment"], bool(found["star"])
            (self._begin if found["open"] == "begin" else self._end)(name, starred, token)
        elif found["dollars"]:
            (self._begin_display if self._display is None else self._end_display)("$$", True, token)
        elif found["label"] is not None:
            self._label(found["label"])
        elif self._display is not None:
            self._in_display(self._display, found, token)
        elif found["sectioning"] and not found["unnumbered"]:
            self._open = []
            self._add("section", self._counters.step(found["sectioning"]), self._line(token.start()))
        elif found["appendix"]:
            self._counters.begin_appendix()
        elif found["counter"]:
            self._counters.within[found["counter"]] = found["within"]
        elif found["caption"]:
            self._open[-1].number = self._counters.step(self._open[-1].kind)

    def _add(self, kind: str, number: str | None, line: int) -> None:
        self._open.append(Numbered(kind, number, None, line, line))
        self.document.numbered.append(self._open[-1])

    def _label(self, name: str) -> None:
        if self._display is not None:
            self._display.row.labels.append(name)
        elif self._open[-1].label is None:
            self._open[-1].label = name
        else:
            raise ValueError(f"{name}: a second label of one object, or the label of a list item, is not read")

    def _begin(self, name: str, starred: bool, token: re.Match[str]) -> None:
        line = self._line(token.start())
        if self._display is not None:
            self._display.depth += 1
        elif name in SINGLE | ROWS:
            self._begin_display(name, starred, token)
        elif name == "subequations":
            self._parent = self._counters.step("equation")
            self._counters.reset("subequation")
            self._add("equation", self._parent, line)
        elif name in FLOATS:
            self._add(name, None, line)
        elif name in self._theorems:
            title, counter = self._theorems[name]
            self._add(title, self._counters.step(counter), line)

    def _end(self, name: str, starred: bool, token: re.Match[str]) -> None:
        if self._display is not None:
            if self._display.depth:
                self._display.depth -= 1
            else:
                self._end_display(name, starred, token)
        elif name == "subequations":
            self._parent = None
            self._open.pop().last = self._line(token.start())
        elif name in FLOATS or name in self._theorems:
            self._open.pop().last = self._line(token.start())

    def _begin_display(self, name: str, starred: bool, token: re.Match[str]) -> None:
        self._display = _Display(name, starred, self._line(token.start()), self._row_after(token))

    def _row_after(self, token: re.Match[str]) -> _Row:
        following = re.compile(r"\S").search(self._text, token.end())
        return _Row(self._line(following.start() if following else token.end()))

    def _in_display(self, display: _Display, found: dict[str, str | None], token: re.Match[str]) -> None:
        if found["silent"]:
            display.row.silent = True
        elif found["tag"] is not None:
            display.row.tag = found["tag"]
        elif found["brace"]:
            display.depth += 1 if found["brace"] == "{" else -1
        elif found["row"] and display.depth == 0 and display.name in ROWS:
            self._end_row(display, Span(display.row.first, self._line(token.start())))
            display.row = self._row_after(token)

    def _end_display(self, name: str, starred: bool, token: re.Match[str]) -> None:
        display = self._display
        assert display is not None
        if (name, starred) != (display.name, display.starred):
            raise ValueError(f"line {self._line(token.start())}: {display.name} is ended as {name}")
        whole = Span(display.first, self._line(token.start()))
        last = self._line(len(self._text[: token.start()].rstrip()) - 1)
        self._end_row(display, Span(display.row.first, last) if name in ROWS else whole)
        self.document.displays.append(whole)
        self._display = None

    def _end_row(self, display: _Display, span: Span) -> None:
        row = display.row
        number = row.tag if row.tag is not None or row.silent or display.starred else self._next_equation()
        if display.name in ROWS:
            self.document.rows.append(span)
        for label in row.labels or ([None] if number is not None else []):
            self.document.numbered.append(Numbered("equation", number, label, span.first, span.last))

    def _next_equation(self) -> str:
        if self._parent is None:
            return self._counters.step("equation")
        return self._parent + self._counters.step("subequation")


def _with_environments(text: str) -> str:
    """The text with each macro that stands for the begin or the end of an environment written out."""
    place = max(text.find(_BODY), 0)
    head, body = text[:place], text[place:]
    for name, meaning in re.findall(r"\\newcommand\{\\(\w+)\}\{(\\(?:begin|end)\{\w+\*?\})\}", head):
        body = re.sub(rf"\\{name}(?![A-Za-z])", lambda _, meaning=meaning: meaning, body)
    return head + body
