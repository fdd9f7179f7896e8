"""The main job: every entry of the ledger, in the order of the paper."""

from __future__ import annotations

from collections.abc import Callable

from gspot_verified.ledger import appendix_a, cases, section_4_5
from gspot_verified.ledger.entry import Entry
from gspot_verified.verdict import Outcome

PARTS: dict[str, Callable[[], list[Entry]]] = {
    "Appendix A": appendix_a.entries,
    "Section 4.5, formulas and signs": section_4_5.entries,
    "Section 4.5, Cases I, II and III": cases.entries,
}


def verify_paper(progress: Callable[[str], None] | None = None) -> list[Entry]:
    """Run every check and return the entries; ``progress`` is told each part's name as it begins."""
    found: list[Entry] = []
    for part, entries in PARTS.items():
        if progress is not None:
            progress(part)
        found += entries()
    return found


def exit_code(entries: list[Entry]) -> int:
    """1 when a statement is refuted, else 2 when one is undecided, else 0."""
    outcomes = {entry.verdict.outcome for entry in entries}
    if Outcome.REFUTED in outcomes:
        return 1
    return 2 if Outcome.UNDECIDED in outcomes else 0
