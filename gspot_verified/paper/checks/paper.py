"""The paper as it is printed: the number that each label of its source has in the PDF, and quoted lines of the source.

The data are read from the source by the tests (``tests/paper/paper_reader.py``), which compare them with it again.
"""

from __future__ import annotations

import json
import re
from dataclasses import dataclass
from functools import lru_cache
from importlib import resources
from typing import Any

from gspot_verified.numbers.written import Written

_SEPARATOR = r"(?:, | and | to |-|–)"


@dataclass(frozen=True, slots=True)
class Quotation(Written):
    """Lines ``first`` to ``last`` of the paper's source, exactly."""

    first: int
    last: int
    latex: str


@dataclass(frozen=True, slots=True)
class Citation:
    """What the label of an entry cites: numbers as printed ("" when there are none) and the lines."""

    printed: str = ""
    quotations: tuple[Quotation, ...] = ()


def citation(label: str) -> Citation:
    """The citation of an entry's label; an empty one for a label that the data do not hold.

    >>> citation("th:5, eq:blarge1").printed
    'Theorem 6, eq. (A.11)'
    >>> citation("eq:modelSysDistZY").quotations[0].first
    604
    """
    found = _data()["citations"].get(label)
    if found is None:
        return Citation()
    return Citation(found["printed"], tuple(Quotation(**quotation) for quotation in found["quotations"]))


def paper_hash() -> str:
    """The SHA-256 of the source that the numbers and the quoted lines are from.

    >>> len(paper_hash())
    64
    """
    digest: str = _data()["sha256"]
    return digest


def place(first: int, last: int) -> str:
    """Where lines of the source stand in the printed paper, by its own numbers: sections, displays, floats, theorems.

    Pages are not known: they differ between versions, and these numbers differ less.

    >>> place(1192, 1197), place(1161, 1161), place(734, 737)
    ('Sec. 4.3, eq. (55)', 'Sec. 4.3, after eq. (52)', 'Sec. 3.1, Figure 6')
    """
    before = [item for item in _places() if item[0] <= first]
    section = next((item for item in reversed(before) if _is_section(item[2])), None)
    found = [section[2].replace("Section", "Sec.")] if section else []
    inside = [name for start, end, name in _places() if start <= last and first <= end and not _is_section(name)]
    floats = [name for name in inside if not name.startswith("eq.")]
    equations = [name.removeprefix("eq. ") for name in inside if name.startswith("eq.")]
    if floats:
        found += floats
    elif equations:
        numbers = equations[0] if len(equations) == 1 else f"{equations[0]} to {equations[-1]}"
        found.append(f"{'eq.' if len(equations) == 1 else 'eqs.'} {numbers}")
    elif section:
        earlier = [name for start, _, name in before if start > section[0] and name.startswith("eq.")]
        found += [f"after {name}" for name in earlier[-1:]]
    return ", ".join(found)


def _is_section(name: str) -> bool:
    return name.startswith(("Section", "Appendix"))


@lru_cache(maxsize=1)
def _places() -> list[tuple[int, int, str]]:
    found = (text.split(" ", 2) for text in _data()["places"])
    return [(int(first), int(last), name) for first, last, name in found]


def printed_number(label: str) -> str | None:
    """What the PDF prints for a label of the source; ``None`` for an equation without a number.

    The theorems, the lemma and the corollary share one counter, so ``th:3`` is not Theorem 3.

    :raises KeyError: the source has no such label.

    >>> printed_number("th:3"), printed_number("eq:btau"), printed_number("eq:modelSysTEliminated")
    ('Theorem 4', 'eq. (A.1)', None)
    """
    number: str | None = _data()["numbers"][label]
    return number


def with_printed_numbers(text: str) -> str:
    """The text with labels of equations and theorems replaced by the numbers that the PDF prints.

    Every equation's label after "eq." or "eqs." is replaced, and every figure's after "fig."; without that only one
    that no word can be mistaken for. An equation without a number keeps its label, and so does a theorem in brackets,
    as in "Theorem 6 (th:5)".

    >>> with_printed_numbers("eqs. specialX to specialL, and modelSysDev times ε")
    'eqs. (70) to (76), and eq. (46) times ε'
    >>> with_printed_numbers("the condition of th:5, the runs of fig. varsim1")
    'the condition of Theorem 6, the runs of Figure 6'
    """
    text = _figure_pattern().sub(lambda match: _figures()[match[1]], text)
    for pattern in _patterns():
        text = pattern.sub(_numbered, text)
    return _theorem_pattern().sub(lambda match: str(printed_number(match[0])), text)


@lru_cache(maxsize=1)
def _data() -> dict[str, Any]:
    text = resources.files("gspot_verified.paper").joinpath("paper_source.json").read_text(encoding="utf-8")
    data: dict[str, Any] = json.loads(text)
    return data


@lru_cache(maxsize=1)
def _equations() -> dict[str, str]:
    """The number in brackets, by the label with and without what stands before its colon."""
    found: dict[str, str] = {}
    for label, number in _data()["numbers"].items():
        if number and number.startswith("eq."):
            found |= dict.fromkeys((label, label.partition(":")[2] or label), number.removeprefix("eq. "))
    return found


@lru_cache(maxsize=1)
def _figures() -> dict[str, str]:
    """The printed name, by the label without what stands before its colon."""
    numbers = _data()["numbers"].items()
    return {label.partition(":")[2]: number for label, number in numbers if (number or "").startswith("Figure")}


@lru_cache(maxsize=1)
def _figure_pattern() -> re.Pattern[str]:
    return re.compile(rf"\b[Ff]ig\. ({'|'.join(map(re.escape, _figures()))})(?!\w)")


@lru_cache(maxsize=1)
def _patterns() -> tuple[re.Pattern[str], re.Pattern[str]]:
    """Labels after "eq.", and bare labels with a colon, a digit, an underscore or an inner capital letter."""
    names = sorted(_equations(), key=len, reverse=True)
    bare = [name for name in names if re.search(r"[:\d_]|(?<=[a-z])[A-Z]", name)]
    pieces = ("|".join(map(re.escape, some)) for some in (names, bare))
    every, distinct = (rf"(?:{piece})(?![\w+]|:\w)" for piece in pieces)
    return (
        re.compile(rf"\b[Ee]qs?\. ({every}(?:{_SEPARATOR}{every})*)"),
        re.compile(rf"(?<![\w:-])({distinct}(?:{_SEPARATOR}{distinct})*)"),
    )


@lru_cache(maxsize=1)
def _theorem_pattern() -> re.Pattern[str]:
    labels = [label for label, number in _data()["numbers"].items() if re.match("Theorem|Lemma", number or "")]
    return re.compile(rf"(?<![\w:(-])(?:{'|'.join(map(re.escape, labels))})(?!\w)")


def _numbered(match: re.Match[str]) -> str:
    names = sorted(_equations(), key=len, reverse=True)
    found = re.sub("|".join(map(re.escape, names)), lambda name: _equations()[name[0]], match[1])
    front = "eqs." if found.count("(") > 1 else "eq."
    return f"{front[0].upper() if match[0].startswith('E') else front[0]}{front[1:]} {found}"
