"""Elements of an XML file that know where they stand: numbers are exact, and what is not known is refused by name."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

from gspot_verified.mechanisms.formulas.names import nearest
from gspot_verified.mechanisms.input.file import read_text
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.input.toml_table import MAX_DIGITS, MAX_EXPONENT

MAX_BYTES = 1_000_000  # of a file: a limit against hostile input
MAX_DEPTH = 60  # of elements in one another: likewise
_DECIMAL = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE]([+-]?[0-9]{1,6}))?")


class XmlElement:
    """An element; ``where`` names it in messages. ``without`` are the tags that are left out on purpose.

    ``left_out`` collects, over the whole file, what was left out.
    """

    def __init__(self, element: ElementTree.Element, where: str, without: Sequence[str], left_out: set[str]) -> None:
        self._element, self.where = element, where
        self._without, self.left_out = without, left_out

    @property
    def tag(self) -> str:
        """The word of the element."""
        return str(self._element.tag)

    @property
    def attributes(self) -> dict[str, str]:
        """The attributes as they stand."""
        return dict(self._element.attrib)

    def with_defaults(self, attributes: Mapping[str, str]) -> XmlElement:
        """The same element with these attributes where it has none of its own."""
        element = ElementTree.Element(self._element.tag, {**attributes, **self._element.attrib})
        return XmlElement(element, self.where, self._without, self.left_out)

    def refuse(self, problem: str) -> MechanismError:
        """The error that names the element."""
        return MechanismError(f"{self.where}: {problem}")

    def children(self, *tags: str) -> Iterator[XmlElement]:
        """The elements inside with one of the tags."""
        for child in self._element:
            if child.tag in tags:
                name = child.get("name")
                words = f"{child.tag} {name[:60]!r}" if name else str(child.tag)
                yield XmlElement(child, f"{self.where}: {words}", self._without, self.left_out)

    def one(self, tag: str) -> XmlElement | None:
        """The only element of this tag inside, if there is one.

        :raises MechanismError: there are more.
        """
        found = list(self.children(tag))
        if len(found) > 1:
            raise self.refuse(f"{len(found)} elements {tag}, one is needed")
        return found[0] if found else None

    def only(self, taken: Sequence[str], ignored: Sequence[str], reasons: dict[str, str]) -> None:
        """Refuse elements inside that are neither taken nor without effect, unless they are left out on purpose."""
        for child in self._element:
            tag = str(child.tag)
            if tag in taken or tag in ignored:
                continue
            if tag in self._without:
                self.left_out.add(tag)
                continue
            known = (*taken, *ignored)
            reason = reasons.get(tag, f"is not known{nearest(tag, known)}")
            raise self.refuse(f"the element {tag[:40]!r} {reason}; without=({tag[:40]!r},) leaves it out on purpose")

    def only_attributes(self, names: Sequence[str]) -> None:
        """Refuse other attributes: what they say is not known."""
        for word in self._element.attrib:
            if word not in names:
                raise self.refuse(f"the attribute {word[:40]!r} is not known{nearest(word, names)}")

    def has(self, name: str) -> bool:
        """Whether the attribute is there."""
        return name in self._element.attrib

    def text(self, name: str, default: str | None = None) -> str:
        """An attribute.

        :raises MechanismError: it is missing.
        """
        value = self._element.get(name, default)
        if value is None:
            raise self.refuse(f"the attribute {name!r} is missing")
        return str(value)

    def numbers(self, name: str, count: int, default: str | None = None) -> list[Any]:
        """An attribute of so many numbers, exact, in sympy.

        :raises MechanismError: it is missing, or other.
        """
        words = self.text(name, default).split()
        if len(words) != count:
            raise self.refuse(f"{name}: {count} numbers are needed, got {len(words)}")
        return [exact_number(word, f"{self.where}: {name}") for word in words]

    def number(self, name: str, default: str | None = None) -> Any:
        """An attribute that is one number."""
        return self.numbers(name, 1, default)[0]


def exact_number(word: str, where: str) -> Any:
    """The rational that a decimal is.

    :raises MechanismError: it is none, or too long.

    >>> exact_number("1e-3", "mass")
    1/1000
    """
    import sympy

    match = _DECIMAL.fullmatch(word)
    if match is None or len(word) > MAX_DIGITS or abs(int(match[1] or 0)) > MAX_EXPONENT:
        raise MechanismError(f"{where}: {word[:40]!r} is no decimal number of usual size")
    return sympy.Rational(str(Fraction(word)))


def xml_root(source: str | Path, tag: str, without: Sequence[str]) -> XmlElement:
    """The root of a file, or of a text that begins with ``<``.

    :raises MechanismError: it cannot be read, is no XML, has another root, or declares entities.
    """
    is_text = isinstance(source, str) and source.lstrip().startswith("<")
    text = str(source) if is_text else read_text(source, MAX_BYTES)
    where = "text" if is_text else str(source)
    if len(text) > MAX_BYTES:
        raise MechanismError(f"{where}: longer than {MAX_BYTES} characters")
    if "<!DOCTYPE" in text or "<!ENTITY" in text:
        raise MechanismError(f"{where}: a document type or entities are not read")
    try:
        element = ElementTree.fromstring(text)
    except (ElementTree.ParseError, ValueError) as error:
        raise MechanismError(f"{where}: no XML: {error}") from None
    if element.tag != tag:
        raise MechanismError(f"{where}: the root must be <{tag}>, got <{str(element.tag)[:40]}>")
    if _depth(element) > MAX_DEPTH:
        raise MechanismError(f"{where}: elements stand in one another deeper than {MAX_DEPTH}")
    return XmlElement(element, where, without, set())


def _depth(root: ElementTree.Element) -> int:
    depth, row = 0, [root]
    while row:
        depth, row = depth + 1, [child for element in row for child in element]
    return depth
