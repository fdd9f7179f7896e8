"""How plain data are written, and that the schema of a type fits what is written of it and nothing else."""

from __future__ import annotations

import enum
from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from html.parser import HTMLParser
from importlib import import_module
from pkgutil import walk_packages
from typing import Annotated, Any, ClassVar, Generic, Literal, NamedTuple, NotRequired, TypedDict, TypeVar

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from IPython.core.formatters import DisplayFormatter
from jsonschema import Draft202012Validator

import gspot_verified
from gspot_verified.numbers.balls import ShownBall
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.numbers.written import DEFINITIONS, PAIRS, ByName, Shown, Written, form, under
from gspot_verified.work.ranges import Range

Value = TypeVar("Value")


class Colour(enum.Enum):
    RED = "dark red"


class Size(ByName):
    LARGE = 7


class Pair(NamedTuple):
    first: fmpq
    second: Colour


class Two(NamedTuple, Generic[Value]):
    state: dict[str, Value]


class Optional(TypedDict):
    number: fmpq
    note: NotRequired[str]


@dataclass(frozen=True, slots=True)
class Inner(Written):
    written: ClassVar[str] = "kind value=number"
    kind: ClassVar[Literal["inner"]] = "inner"
    number: fmpq


@dataclass(frozen=True, slots=True)
class Outer(Written):
    written: ClassVar[str] = "inner number=inner.number either=other.number rows=pairs.state count=twice size"
    inner: Inner
    other: Inner | None
    size: int

    @property
    def pairs(self) -> Two[arb]:
        return Two({"x": arb(1)})

    def twice(self) -> int:
        return 2 * self.size


def fits(hint: Any, data: object) -> bool:
    return bool(Draft202012Validator({**form(hint).schema, "$defs": DEFINITIONS}).is_valid(data))


EXAMPLES: list[tuple[Any, object, object]] = [
    (fmpq, fmpq(-1, 2), "-1/2"),
    (Fraction, Fraction(10**5000, 3), str(fmpq(10**5000, 3))),
    (arb, arb(3), "[0x3, 0x3]p0"),
    (arb, arb("nan"), None),
    (Dyadic, Dyadic(1, 3, -2), "[0x1, 0x3]p-2"),
    (ShownBall | None, arb(1), "1.00000000000000"),
    (ShownBall | None, None, None),
    (fmpq | arb, fmpq(3), "3"),
    (fmpq | arb, arb(3), "[0x3, 0x3]p0"),
    (bool | None, True, True),
    (Annotated[int, fmpq], 5, "5"),
    (Colour, Colour.RED, "dark red"),
    (Size, Size.LARGE, "large"),
    (Literal["a", "b"], "b", "b"),
    (Annotated[str, ("a", "b")], "b", "b"),
    (Range, Range.parse("0..1", "tau"), "(0, 1)"),
    (tuple[fmpq, ...], (fmpq(1), fmpq(2)), ["1", "2"]),
    (tuple[fmpq, int], (fmpq(1), 2), ["1", 2]),
    (tuple[tuple[str, fmpq], ...], (("x", fmpq(1)),), {"x": "1"}),
    (Annotated[tuple[tuple[str, float], ...], PAIRS], (("x", 0.5),), [["x", 0.5]]),
    (dict[str, fmpq], {"x": fmpq(1)}, {"x": "1"}),
    (Pair, Pair(fmpq(1), Colour.RED), {"first": "1", "second": "dark red"}),
    (Optional, {"number": fmpq(1)}, {"number": "1"}),
    (Optional | Pair, {"number": fmpq(1), "note": ""}, {"number": "1", "note": ""}),
    (Inner, Inner(fmpq(1)), {"kind": "inner", "value": "1"}),
]


@pytest.mark.parametrize(("hint", "value", "data"), EXAMPLES, ids=map(str, range(len(EXAMPLES))))
def test_what_is_written_and_its_schema(hint: Any, value: object, data: object) -> None:
    assert form(hint).write(value) == data
    assert fits(hint, data)
    assert form(hint).fits(value)


@pytest.mark.parametrize(
    ("hint", "data"),
    [
        (fmpq, "1/0"),
        (fmpq, 0.5),
        (arb, "[0x1, 0x3]"),
        (int, "1"),
        (bool, 1),
        (Colour, "red"),
        (Literal["a", "b"], "c"),
        (Annotated[str, ("a", "b")], "c"),
        (tuple[fmpq, int], ["1"]),
        (tuple[fmpq, int], ["1", 2, 3]),
        (tuple[fmpq, ...], ["x"]),
        (tuple[tuple[str, fmpq], ...], {"x": 1}),
        (Optional, {"note": ""}),
        (Optional, {"number": "1", "further": 1}),
        (Pair, {"first": "1"}),
        (Inner, {"kind": "outer", "value": "1"}),
        (fmpq | None, ""),
    ],
)
def test_the_schema_refuses(hint: Any, data: object) -> None:
    assert not fits(hint, data)


def test_keys_follow_paths() -> None:
    inner = Inner(fmpq(1, 2))
    expected = {
        "inner": {"kind": "inner", "value": "1/2"},
        "number": "1/2",
        "either": None,
        "rows": {"x": "[0x1, 0x1]p0"},
        "count": 6,
        "size": 3,
    }
    assert Outer(inner, None, 3).to_json() == expected
    assert Outer(inner, inner, 3).to_json() == {**expected, "either": "1/2"}
    assert fits(Outer, expected)
    assert not fits(Outer, {**expected, "number": None})
    assert under("a", "x y=z.w") == "x=a.x y=a.z.w"


@dataclass(frozen=True)
class Wrong(Written):
    written: ClassVar[str] = "missing"


@pytest.mark.parametrize("hint", [object, complex, Wrong, Annotated[int, "a note"]])
def test_what_has_no_form_is_an_error(hint: Any) -> None:
    with pytest.raises(TypeError, match=r"no form of|no attribute 'missing'"):
        form(hint)


@given(st.fractions())
def test_a_rational_comes_back(value: Fraction) -> None:
    text = form(Fraction).write(value)
    assert Fraction(text) == value
    assert fits(fmpq, text)


def every(kind: type) -> Iterator[type]:
    for each in kind.__subclasses__():
        yield each
        yield from every(each)


def test_every_class_that_is_written_has_a_form() -> None:
    """A key that names no attribute, or an attribute of a type that nobody can write, is seen here."""
    for module in walk_packages(gspot_verified.__path__, "gspot_verified."):
        if not module.name.endswith("__main__"):
            import_module(module.name)
    found = [kind for kind in every(Written) if kind.__module__.startswith("gspot_verified.")]
    assert len(found) > 70
    for kind in found:
        Draft202012Validator.check_schema(form(kind).schema)


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
