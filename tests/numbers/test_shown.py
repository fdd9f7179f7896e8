"""A short line at a prompt, the text of ``print`` or a table of the fields in a notebook, both escaped."""

from __future__ import annotations

from dataclasses import dataclass, field
from html.parser import HTMLParser

import pytest
from hypothesis import given
from hypothesis import strategies as st
from IPython.core.formatters import DisplayFormatter

from gspot_verified.numbers.shown import Shown


@dataclass(frozen=True, slots=True)
class Text(Shown):
    text: str

    def __str__(self) -> str:
        return self.text


@dataclass(frozen=True)
class Table(Shown):
    word: object
    row: tuple[object, ...] = ()
    hidden: int = field(default=0, repr=False)


@dataclass(frozen=True)
class Derived(Table):
    more: int = 1


class Plain(Shown):
    pass


class Own(Shown):
    def __repr__(self) -> str:
        return "its own"


class Words(HTMLParser):
    """The tags and the text of a page."""

    def __init__(self) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.text = ""

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        assert attrs in ([], [("style", "font-family:monospace")])
        self.tags.append(tag)

    def handle_data(self, data: str) -> None:
        self.text += data


def read(value: Shown) -> Words:
    words = Words()
    words.feed(value._repr_html_() or "")
    words.close()
    return words


def test_the_first_line_of_the_text() -> None:
    assert repr(Text("all of it")) == "<Text: all of it>"
    assert repr(Text("the  first\nthe second\nthe third")) == "<Text: the first …>"
    assert str(Text("the first\nthe second")) == "the first\nthe second"


def test_the_fields_where_there_is_no_text() -> None:
    assert repr(Table("a", (1, 2))) == "Table(word='a', row=(1, 2))"
    assert str(Table("a")) == repr(Table("a"))
    assert repr(Derived("a", more=3)) == "Derived(word='a', row=(), more=3)"
    assert repr(Plain()) == "Plain()"
    assert repr(Own()) == "its own"


@pytest.mark.parametrize(
    "value",
    [Text("x" * 10**6), Text(" x" * 10**6 + "\ny"), Table("x" * 10**6), Table(tuple(range(10**6)) * 2), Table(10**4000),
     Table([["x" * 1000] * 1000] * 1000), Table(Table("x" * 1000), tuple(Text("y" * 1000) for _ in range(50)))],
    ids=range(7),
)  # fmt: skip
def test_the_line_is_short(value: Shown) -> None:
    assert 40 < len(repr(value)) <= 330
    assert "…" in repr(value) or "..." in repr(value)
    assert "\n" not in repr(value)


@given(st.text(alphabet=st.characters(exclude_categories=("Cs", "Cc"))))
def test_a_page_holds_the_text_and_no_tag_of_it(text: str) -> None:
    shown = read(Text(text))
    assert shown.tags == ["pre"]
    assert shown.text == text
    assert set(read(Table(text)).tags) == {"table", "caption", "tr", "th", "td"}


def test_a_table_has_a_row_for_each_field() -> None:
    table = read(Table("<script>", ("&",), hidden=5))
    assert table.tags == ["table", "caption", "tr", "th", "td", "tr", "th", "td"]
    assert table.text == "Tableword'<script>'row('&',)"


def test_the_display_of_ipython_takes_the_line_and_the_page() -> None:
    for value in (Text("1 < 2\nmore"), Table("a")):
        assert DisplayFormatter().format(value) == ({"text/plain": repr(value), "text/html": value._repr_html_()}, {})
