"""What the paper's own words say: two places of it, held against each other.

The words are those of the quoted lines of an entry's label; where a pattern does not find them nothing is said.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from gspot_verified.paper.checks.entry import Check, Rung
from gspot_verified.paper.checks.paper import citation


class Place(NamedTuple):
    """A place of the paper: its name, and the pattern of the words there; the pattern's group is what is said."""

    name: str
    pattern: str


def quoted(label: str) -> str:
    """The quoted lines of a label as one line.

    >>> "The blue curves were" in quoted("lines 2224 to 2225 and 2247 to 2250")
    True
    """
    return " ".join(" ".join(quotation.latex.split()) for quotation in citation(label).quotations)


def said(label: str, place: Place) -> str | None:
    """What is said at a place among the quoted lines; ``None`` where the words are not there, or are there twice."""
    found = re.findall(place.pattern, quoted(label))
    return str(found[0]) if len(found) == 1 else None


def agree(label: str, first: Place, second: Place) -> bool | None:
    """Whether the two places say the same; ``None`` when one of them says nothing."""
    one, other = said(label, first), said(label, second)
    return None if one is None or other is None else one == other


def held_against(label: str, what: str, first: Place, second: Place) -> Check:
    """The check that two places say the same of one thing, with their words as its finding."""
    finding = f"{first.name}: {said(label, first)}; {second.name}: {said(label, second)}"
    return Rung.EXACT.check(what, agree(label, first, second), finding)
