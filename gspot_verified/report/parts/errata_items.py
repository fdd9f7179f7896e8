"""The errata: refuted entries as items, those that change a conclusion first, and one item for the cells of one table.

Works on the entries of a ``report.json``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.checks.consequences import Reach
from gspot_verified.paper.checks.paper import place

ORDER = (Reach.CONCLUSION, Reach.LOCAL, Reach.NONE)
TITLES = {
    Reach.CONCLUSION: "Errors that change a conclusion",
    Reach.LOCAL: "Local errors: what is printed there is wrong, and no conclusion changes",
    Reach.NONE: "Misprints and slips without a consequence",
    None: "Errors whose consequence is not recorded",
}


@dataclass(frozen=True)
class Item:
    """One erratum: entries that are about one place, or about cells of one table."""

    entries: tuple[Mapping[str, Any], ...]
    table: str = ""

    @property
    def places(self) -> str:
        """Where the reader finds it: the table, or each place of the quoted lines once."""
        return self.table or "; ".join(dict.fromkeys(where for entry in self.entries for where in places_of(entry)))

    @property
    def lines(self) -> str:
        """The quoted lines of the source."""
        found = sorted({tuple(lines) for entry in self.entries for lines in entry["lines"]})
        return ", ".join(str(first) if first == last else f"{first}–{last}" for first, last in found)


def errata(entries: Sequence[Mapping[str, Any]]) -> dict[Reach | None, list[Item]]:
    """The refuted entries as items, by how far they reach, in the order of the paper; reaches without an item left out.

    >>> errata([])
    {}
    """
    refuted = [entry for entry in entries if entry["verdict"]["outcome"] == Outcome.REFUTED.value]
    refuted.sort(key=lambda entry: entry["lines"][0] if entry["lines"] else [0, 0])
    found: dict[Reach | None, dict[str, list[Mapping[str, Any]]]] = {reach: {} for reach in (*ORDER, None)}
    for entry in refuted:
        reading = entry["consequence"] or {"reach": None, "table": ""}
        reach = Reach(reading["reach"]) if reading["reach"] is not None else None
        found[reach].setdefault(reading["table"] or f"entry {entry['identifier']}", []).append(entry)
    return {
        reach: [Item(tuple(group), _table(group)) for group in groups.values()]
        for reach, groups in found.items()
        if groups
    }


def _table(group: Sequence[Mapping[str, Any]]) -> str:
    reading = group[0]["consequence"]
    return str(reading["table"]) if reading else ""


def places_of(entry: Mapping[str, Any]) -> list[str]:
    """Where the quoted lines of an entry stand in the paper; its label where it quotes none."""
    return [place(first, last) for first, last in entry["lines"]] or [entry["printed"] or entry["label"]]
