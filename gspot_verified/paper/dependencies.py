"""What an entry rests on and what it names besides. Read from its texts, which readers see too."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from gspot_verified.numbers.written import Written
from gspot_verified.paper.checks.entry import Entry


@dataclass(frozen=True, slots=True)
class Dependencies(Written):
    """Proof pages, certificates (in ``proofs/``) and entries that the checks name; entries named elsewhere."""

    pages: tuple[str, ...]
    certificates: tuple[str, ...]
    entries: tuple[str, ...]
    see_also: tuple[str, ...]


def dependencies(entry: Entry, identifiers: Sequence[str]) -> Dependencies:
    """What the entry's checks name, and which of the given identifiers its condition and its note name besides.

    >>> from gspot_verified.paper.checks.entry import Check, Rung, Section
    >>> check = Check(Rung.PAGE, "proofs/signs.md: as in S-zero", True)
    >>> found = dependencies(Section("Section 1").settled("1-beta", "line 1", "x", "y", check), ["1-beta", "S-zero"])
    >>> found.pages, found.entries, found.see_also
    (('signs',), ('S-zero',), ())
    """
    checked = "\n".join(f"{check.what} {check.finding}" for check in entry.checks)
    entries = _named(checked, entry.identifier, identifiers)
    besides = _named(f"{entry.corrected} {entry.note}", entry.identifier, identifiers)
    return Dependencies(
        _each_once(re.findall(r"\b(\w+)\.md\b", checked)),
        _each_once(re.findall(r"\b(\w+\.cert)\b", checked)),
        entries,
        tuple(name for name in besides if name not in entries),
    )


def _named(text: str, own: str, identifiers: Sequence[str]) -> tuple[str, ...]:
    others = [name for name in identifiers if name != own]
    pattern = rf"(?<![\w-])(?:{'|'.join(map(re.escape, others))})(?![\w-])"
    return _each_once(re.findall(pattern, text)) if others else ()


def _each_once(names: Sequence[str]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(names))
