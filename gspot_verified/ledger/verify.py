"""The main job: every entry of the ledger, in the order of the paper."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial

from gspot_verified.ledger import (
    after_lift_off,
    appendix_a,
    cases,
    compliant_model,
    example,
    general_system,
    lagrangian,
    section_1_cases,
    section_1_rigid,
    section_2_contact,
    section_3,
    section_3_sentences,
    section_3_smoothness,
    section_4_5,
    section_4_fast,
    section_4_inner,
    section_4_matching,
    section_4_oscillating,
    section_4_outer,
    section_4_slow,
    section_4_trivial,
    section_4_unique,
    section_5_ansatz,
    section_5_count,
    section_5_matching,
    section_5_outer,
    section_5_recursion,
    section_5_spaces,
    section_5_theorem,
    section_6,
    section_6_runs,
    strong_direction,
    table_1,
    varsim1,
    varsim2,
)
from gspot_verified.ledger.entry import Builders, Entry
from gspot_verified.ledger.formal_routes import with_formal_proof
from gspot_verified.verdict import Outcome

PARTS: dict[str, Builders] = {
    "Section 1, rigid slip": section_1_rigid.ENTRIES,
    "Section 1, Cases I, II and III": section_1_cases.ENTRIES,
    "Section 1, the ratio β": section_4_slow.RATIO_ENTRIES,
    "Section 2, the general system": general_system.ENTRIES,
    "Section 2, the surface": section_2_contact.ENTRIES,
    "Section 2, the motivating example": section_4_trivial.ENTRIES,
    "Section 2, the extended example": lagrangian.ENTRIES,
    "Section 3, sides of the simulations": section_3.ENTRIES,
    "Section 3, the runs of the simulations": varsim1.ENTRIES,
    "Section 3, sentences on the simulations": section_3_sentences.ENTRIES,
    "Section 3, smoothness": section_3_smoothness.ENTRIES,
    "Section 3, Table 1": table_1.ENTRIES,
    "Section 3, after lift-off": after_lift_off.ENTRIES,
    "Section 3, the runs of the extended system": varsim2.ENTRIES,
    "Section 4, elimination and deviations": section_4_outer.ENTRIES,
    "Section 4.1, the distinguished trajectory": section_4_unique.ENTRIES,
    "Section 4, fast system": section_4_fast.ENTRIES,
    "Section 4, slow system": section_4_slow.ENTRIES,
    "Section 4, inner scale": section_4_inner.ENTRIES,
    "Section 4.4, oscillating solutions": section_4_oscillating.ENTRIES,
    "Section 4.4, matching": section_4_matching.ENTRIES,
    "Section 4.5, formulas and signs": section_4_5.ENTRIES,
    "Section 4.5, the strong direction": strong_direction.ENTRIES,
    "Section 4.5, Cases I, II and III": cases.ENTRIES,
    "Section 4.5, the compliant model itself": compliant_model.ENTRIES,
    "Section 5, the count of conditions": section_5_count.ENTRIES,
    "Section 5, the recursion": section_5_recursion.ENTRIES,
    "Section 5, Theorem 1": section_5_theorem.ENTRIES,
    "Section 5, the spaces of Theorem 1": section_5_spaces.ENTRIES,
    "Section 5, the example": example.ENTRIES,
    "Section 5, outer system": section_5_outer.ENTRIES,
    "Section 5, the ansatz near the G-spot": section_5_ansatz.ENTRIES,
    "Section 5, matching": section_5_matching.ENTRIES,
    "Section 6 and Appendix B, the oscillator": section_6.ENTRIES,
    "Section 6, Cases and simulations": section_6_runs.ENTRIES,
    "Appendix A": appendix_a.ENTRIES,
}


def verify_paper(progress: Callable[[str], None] | None = None) -> list[Entry]:
    """Run every check and return the entries; ``progress`` is told each part's name as it begins."""
    found: list[Entry] = []
    for part, builders in PARTS.items():
        if progress is not None:
            progress(part)
        found += [with_formal_proof(replace(build(), code=code_of(build))) for build in builders.values()]
    return found


def code_of(build: Callable[[], Entry]) -> str:
    """The file, as seen from the root of the project, and the name of the function that makes an entry.

    >>> code_of(section_3.ENTRIES["3-sides"])
    'gspot_verified/ledger/section_3.py:_sides'
    """
    function = build.func if isinstance(build, partial) else build
    return f"{function.__module__.replace('.', '/')}.py:{function.__qualname__}"


def exit_code(entries: list[Entry]) -> int:
    """1 when a statement is refuted, else 2 when one is undecided, else 0."""
    outcomes = {entry.verdict.outcome for entry in entries}
    if Outcome.REFUTED in outcomes:
        return 1
    return 2 if Outcome.UNDECIDED in outcomes else 0
