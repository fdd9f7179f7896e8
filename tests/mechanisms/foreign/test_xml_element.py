"""XML that knows where it stands: exact numbers, limits, and errors that name the element."""

from __future__ import annotations

from pathlib import Path

import pytest
import sympy

from gspot_verified.mechanisms.foreign.xml_element import MAX_BYTES, MAX_DEPTH, XmlElement, exact_number, xml_root
from gspot_verified.mechanisms.input.mechanism import MechanismError

TEXT = '<a version="2"><b name="one" size="1e-1 .5 -3."/><b/><c/><d/></a>'


def root(text: str = TEXT, *without: str) -> XmlElement:
    return xml_root(text, "a", without)


def test_numbers_are_exact() -> None:
    first, second = root().children("b")
    assert first.numbers("size", 3) == [sympy.Rational(1, 10), sympy.Rational(1, 2), -3]
    assert second.number("size", "0.25") == sympy.Rational(1, 4)
    assert (first.has("size"), second.has("size")) == (True, False)


@pytest.mark.parametrize("word", ["nan", "inf", "1,5", "0x10", "1e1000", "", "one", "1_0e", "1/0", "9" * 200])
def test_what_is_no_number_is_refused(word: str) -> None:
    with pytest.raises(MechanismError, match=r"mass: .*is no decimal number of usual size"):
        exact_number(word, "mass")


def test_a_number_may_be_as_long_as_in_other_files() -> None:
    assert exact_number("9" * 100, "mass") == 10**100 - 1
    assert exact_number("1e100", "mass") == exact_number("+1.E+100", "mass") == 10**100
    for word in ("9" * 101, "1e101", "1e-101"):
        with pytest.raises(MechanismError, match="usual size"):
            exact_number(word, "mass")


def test_errors_name_the_element() -> None:
    first, second = root().children("b")
    assert (first.where, second.where) == ("text: b 'one'", "text: b")
    with pytest.raises(MechanismError, match="text: b 'one': size: 2 numbers are needed, got 3"):
        first.numbers("size", 2)
    with pytest.raises(MechanismError, match="text: b: the attribute 'name' is missing"):
        second.text("name")
    with pytest.raises(MechanismError, match="text: 2 elements b, one is needed"):
        root().one("b")
    with pytest.raises(MechanismError, match="b 'one': the attribute 'size' is not known; did you mean 'sizes'"):
        first.only_attributes(("name", "sizes"))
    first.only_attributes(("name", "size"))


def test_one_element_or_none() -> None:
    found = root().one("c")
    assert found is not None
    assert found.tag == "c"
    assert root().one("e") is None


def test_unknown_elements_are_refused_or_left_out_on_purpose() -> None:
    root().only(("b", "c"), ("d",), {})
    with pytest.raises(MechanismError, match=r"text: the element 'd' is a spring; without=\('d',\)"):
        root().only(("b", "c"), (), {"d": "is a spring"})
    with pytest.raises(MechanismError, match="the element 'd' is not known; did you mean 'dd'"):
        root().only(("b", "c"), ("dd",), {})
    left = root(TEXT, "d")
    left.only(("b", "c"), (), {})
    assert left.left_out == {"d"}
    assert next(left.children("b")).left_out is left.left_out


def test_defaults_stand_behind_what_is_given() -> None:
    first = next(root().children("b")).with_defaults({"size": "1", "color": "red"})
    assert first.attributes == {"name": "one", "size": "1e-1 .5 -3.", "color": "red"}
    assert first.where == "text: b 'one'"


def test_a_file_and_a_text_are_the_same(tmp_path: Path) -> None:
    file = tmp_path / "a.xml"
    file.write_text("\N{BYTE ORDER MARK}" + TEXT, encoding="utf-8")
    for source in (file, str(file)):
        assert next(xml_root(source, "a", ()).children("b")).where == f"{file}: b 'one'"
    assert root("  \n" + TEXT).where == "text"


def test_limits(tmp_path: Path) -> None:
    deep = "<a>" * MAX_DEPTH + "</a>" * MAX_DEPTH
    assert root(deep).tag == "a"
    with pytest.raises(MechanismError, match="deeper than 60"):
        root(f"<a>{deep}</a>")
    with pytest.raises(MechanismError, match="longer than"):
        root("<a>" + " " * MAX_BYTES + "</a>")
    large = tmp_path / "large.xml"
    large.write_bytes(b"<a>" + b" " * MAX_BYTES + b"</a>")
    with pytest.raises(MechanismError, match="larger than"):
        xml_root(large, "a", ())


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("<a", "no XML"),
        ("<a></b>", "no XML"),
        ("<b/>", "the root must be <a>, got <b>"),
        ('<!DOCTYPE a [<!ENTITY x "y">]><a>&x;</a>', "document type or entities"),
        ("<a>\0</a>", "no XML"),
    ],
)
def test_what_is_no_such_xml_is_refused(text: str, message: str) -> None:
    with pytest.raises(MechanismError, match=message):
        root(text)


def test_a_path_that_cannot_be_read(tmp_path: Path) -> None:
    for source in (tmp_path, tmp_path / "none", "none\0", ""):
        with pytest.raises(MechanismError, match="cannot be read"):
            xml_root(source, "a", ())
