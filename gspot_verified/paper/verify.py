"""The main job: every entry of the ledger, in the order of the paper."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from dataclasses import replace
from functools import partial
from pathlib import Path

from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.appendix_a import appendix_a
from gspot_verified.paper.cache import Cache
from gspot_verified.paper.checks.entry import Builders, Entry
from gspot_verified.paper.checks.formal_proof import ProofRun, run_proofs
from gspot_verified.paper.checks.formal_routes import with_formal_proof
from gspot_verified.paper.dependencies import dependencies
from gspot_verified.paper.section_1 import (
    section_1_alpha_signs,
    section_1_cases,
    section_1_mass_matrix,
    section_1_negative_p,
    section_1_open_sets,
    section_1_outcomes,
    section_1_rigid,
    section_1_rod,
    section_1_sentences,
)
from gspot_verified.paper.section_2 import (
    general_system,
    lagrangian,
    no_trivial_solution,
    section_2_contact,
    section_2_restitution,
    section_2_sentences,
)
from gspot_verified.paper.section_3 import (
    after_lift_off,
    flight_in_case_ii,
    impact_to_lift_off,
    section_3,
    section_3_captions,
    section_3_sentences,
    section_3_smoothness,
    table_1,
    varsim1,
    varsim2,
)
from gspot_verified.paper.section_4 import (
    section_4_fast,
    section_4_inner,
    section_4_matching,
    section_4_oscillating,
    section_4_outer,
    section_4_reference,
    section_4_slow,
    section_4_trivial,
    section_4_unique,
)
from gspot_verified.paper.section_4_5 import cases, compliant_model, same_situation, section_4_5, strong_direction
from gspot_verified.paper.section_5 import (
    example,
    section_5_ansatz,
    section_5_count,
    section_5_matching,
    section_5_outer,
    section_5_recursion,
    section_5_right_sides,
    section_5_sentences,
    section_5_side,
    section_5_smoothest,
    section_5_spaces,
    section_5_theorem,
)
from gspot_verified.paper.section_6 import (
    section_6,
    section_6_relaxation,
    section_6_runs,
    section_6_sentences,
    section_6_theta,
    section_7,
)
from gspot_verified.work.executors import InProcessExecutor, as_they_end

PARTS: dict[str, Builders] = {
    "Section 1, the mass matrix": section_1_mass_matrix.ENTRIES,
    "Section 1, rigid slip": section_1_rigid.ENTRIES,
    "Section 1, negative p": section_1_negative_p.ENTRIES,
    "Section 1, signs of the α's": section_1_alpha_signs.ENTRIES,
    "Section 1, Cases I, II and III": section_1_cases.ENTRIES,
    "Section 1, the ratio β": section_4_slow.RATIO_ENTRIES,
    "Section 1, outcomes of rigid slip": section_1_outcomes.ENTRIES,
    "Section 1, open sets of states": section_1_open_sets.ENTRIES,
    "Section 1, the falling rod": section_1_rod.ENTRIES,
    "Section 1, sentences": section_1_sentences.ENTRIES,
    "Section 2, the general system": general_system.ENTRIES,
    "Section 2, the surface": section_2_contact.ENTRIES,
    "Section 2, coefficients of restitution": section_2_restitution.ENTRIES,
    "Section 2, the motivating example": section_4_trivial.ENTRIES,
    "Section 2, the extended example": lagrangian.ENTRIES,
    "Section 2, no trivial solution": no_trivial_solution.ENTRIES,
    "Section 2, sentences": section_2_sentences.ENTRIES,
    "Section 3, sides of the simulations": section_3.ENTRIES,
    "Section 3, the runs of the simulations": varsim1.ENTRIES,
    "Section 3, the trivial solution in Case I": section_4_trivial.IN_CASE_I,
    "Section 3, sentences on the simulations": section_3_sentences.ENTRIES,
    "Section 3, captions and panels": section_3_captions.ENTRIES,
    "Section 3, smoothness": section_3_smoothness.ENTRIES,
    "Section 3, Table 1": table_1.ENTRIES,
    "Section 3, the flight in Case II": flight_in_case_ii.ENTRIES,
    "Section 3, after lift-off": after_lift_off.ENTRIES,
    "Section 3, the runs of the extended system": varsim2.ENTRIES,
    "Section 3, from an impact to lift-off": impact_to_lift_off.ENTRIES,
    "Section 4, elimination and deviations": section_4_outer.ENTRIES,
    "Section 4, a reference": section_4_reference.ENTRIES,
    "Section 4.1, the distinguished trajectory": section_4_unique.ENTRIES,
    "Section 4, fast system": section_4_fast.ENTRIES,
    "Section 4, slow system": section_4_slow.ENTRIES,
    "Section 4, inner scale": section_4_inner.ENTRIES,
    "Section 4.4, oscillating solutions": section_4_oscillating.ENTRIES,
    "Section 4.4, matching": section_4_matching.ENTRIES,
    "Section 4.5, formulas and signs": section_4_5.ENTRIES,
    "Section 4.5, the strong direction": strong_direction.ENTRIES,
    "Section 4.5, Cases I, II and III": cases.ENTRIES,
    "Section 4.5, the side of the impact": same_situation.ENTRIES,
    "Section 4.5, the compliant model itself": compliant_model.ENTRIES,
    "Section 5, the count of conditions": section_5_count.ENTRIES,
    "Section 5, the recursion": section_5_recursion.ENTRIES,
    "Section 5, right-hand sides": section_5_right_sides.ENTRIES,
    "Section 5, sentences": section_5_sentences.ENTRIES,
    "Section 5, the smoothest graph": section_5_smoothest.ENTRIES,
    "Section 5, Theorem 1": section_5_theorem.ENTRIES,
    "Section 5, the spaces of Theorem 1": section_5_spaces.ENTRIES,
    "Section 5, the example": example.ENTRIES,
    "Section 5, outer system": section_5_outer.ENTRIES,
    "Section 5, the ansatz near the G-spot": section_5_ansatz.ENTRIES,
    "Section 5, matching": section_5_matching.ENTRIES,
    "Section 5, the side for all small ε": section_5_side.ENTRIES,
    "Section 6 and Appendix B, the oscillator": section_6.ENTRIES,
    "Section 6, Cases and simulations": section_6_runs.ENTRIES,
    "Section 6, the expansion and Θ": section_6_theta.ENTRIES,
    "Section 6, relaxation and units": section_6_relaxation.ENTRIES,
    "Section 6, sentences": section_6_sentences.ENTRIES,
    "Section 7, after the first flight": section_7.ENTRIES,
    "Appendix A": appendix_a.ENTRIES,
}


LONGEST = (
    "3-after-lift-off",
    "6-second-start",
    "6-first-start",
    "3-case-II-starts",
    "3-impact-to-lift-off",
    "3-impact-to-stick",
    "7-lift-off-again",
    "3-sides",
)
"""The entries of a second and more, the longest first: they begin first, so that no worker is left with one at the
end. A choice of order, nothing else."""


def verify_paper(
    progress: Callable[[str], None] | None = None,
    cache: Cache | None = None,
    proofs: ProofRun | None = None,
    pool: Executor | None = None,
) -> list[Entry]:
    """The entries of every part, in the order of the paper; ``progress`` is told each part's name when it is done.

    With a cache, results of the same sources are taken from it, and new ones are kept there, each as it is found.
    ``proofs``: the formal proofs that :func:`run_proofs` has run; without them no entry has the rung "formal".
    ``pool``: where entries are found; the same ones come from every executor.

    :raises RuntimeError: an entry could not be found; the message has its name.
    """
    found: dict[str, Entry] = {}
    waiting = {identifier: part for part, builders in PARTS.items() for identifier in builders}
    total = len(waiting)

    def done(identifier: str, entry: Entry) -> None:
        found[identifier] = with_formal_proof(entry, proofs or ProofRun())
        part = waiting.pop(identifier)
        if progress is not None and part not in waiting.values():
            progress(f"{part}: done, {len(found)} of {total} entries")

    for identifier in list(waiting):
        if (entry := _recalled(identifier, cache)) is not None:
            done(identifier, entry)
    order = [*(name for name in LONGEST if name in waiting), *(name for name in waiting if name not in LONGEST)]
    calls = {identifier: partial(built, waiting[identifier], identifier) for identifier in order}
    for identifier, entry in as_they_end(pool or InProcessExecutor(), calls):
        _keep(identifier, entry, cache)
        done(identifier, entry)
    return [found[identifier] for builders in PARTS.values() for identifier in builders]


def built(part: str, identifier: str) -> Entry:
    """The entry of this part and name, by its checks."""
    build = PARTS[part][identifier]
    return replace(build(), code=code_of(build))


def verify_claims(
    identifiers: Sequence[str],
    progress: Callable[[str], None] | None = None,
    cache: Cache | None = None,
    alone: bool = False,
    proofs: ProofRun | None = None,
) -> tuple[list[Entry], list[Entry]]:
    """The named entries, in their order, and then those that their checks name, those that theirs name, and so on.

    An entry's verdict is drawn from its own checks alone. But who doubts a claim doubts what it is checked by too.
    ``alone`` leaves the further ones out.

    :raises ValueError: no entry has that name; the message has the nearest names.
    """
    builders = {identifier: part for part, builders in PARTS.items() for identifier in builders}
    for identifier in identifiers:
        if identifier not in builders:
            near = difflib.get_close_matches(identifier, builders, 4, 0.5)
            hint = f"; nearest: {', '.join(near)}" if near else ""
            raise ValueError(f"no entry of the ledger is named {identifier[:60]!r}{hint}")
    asked = list(dict.fromkeys(identifiers))
    found: dict[str, Entry] = {}
    waiting = asked[::-1]
    while waiting:
        identifier = waiting.pop()
        if identifier in found:
            continue
        if progress is not None:
            progress(identifier)
        found[identifier] = _made(identifier, builders[identifier], cache, proofs)
        if not alone:
            waiting += dependencies(found[identifier], list(builders)).entries[::-1]
    named = [found[identifier] for identifier in asked]
    return named, [entry for identifier, entry in found.items() if identifier not in asked]


def verify(
    *claims: str,
    alone: bool = False,
    formal: bool = False,
    cache: Path | None = None,
    progress: Callable[[str], None] | None = None,
    executor: Executor | None = None,
) -> list[Entry]:
    """The paper claim by claim: the entries of the ledger, each with its verdict and its checks.

    :param claims: identifiers of entries; none: the whole paper, some minutes. The named ones come first, then those
        that their checks name; those are left out with ``alone``.
    :param formal: run the formal proofs of proofs/coq too, with Coq: minutes.
    :param cache: a folder that keeps results under the hash of all sources; left out, nothing is kept.
    :param progress: is told what is done.
    :param executor: where the entries of the whole paper are found.
    :raises ValueError: no entry has that name, or an argument is for the other kind of question.

    >>> from gspot_verified import verify
    >>> [entry.verdict.outcome.name for entry in verify("S-iwc", alone=True)]
    ['PROVED']
    """
    if alone and not claims:
        raise ValueError("alone: for named claims")
    if claims and executor is not None:
        raise ValueError("executor: for the whole paper; name no claims")
    kept = None if cache is None else Cache(cache)
    proofs = run_proofs() if formal else None
    if not claims:
        return verify_paper(progress, kept, proofs, executor)
    named, further = verify_claims(claims, progress, kept, alone, proofs)
    return named + further


def _made(identifier: str, part: str, cache: Cache | None, proofs: ProofRun | None) -> Entry:
    """The entry, from the cache or by its checks. Formal proofs are never kept: they are run now, or were not."""
    entry = _recalled(identifier, cache)
    if entry is None:
        entry = built(part, identifier)
        _keep(identifier, entry, cache)
    return with_formal_proof(entry, proofs or ProofRun())


def _recalled(identifier: str, cache: Cache | None) -> Entry | None:
    return cache.recall(identifier) if cache is not None else None


def _keep(identifier: str, entry: Entry, cache: Cache | None) -> None:
    if cache is not None and entry.identifier == identifier:
        cache.keep(entry)


def code_of(build: Callable[[], Entry]) -> str:
    """The file, as seen from the root of the project, and the name of the function that makes an entry.

    >>> code_of(section_3.ENTRIES["3-sides"])
    'gspot_verified/paper/section_3/section_3.py:_sides'
    """
    function = build.func if isinstance(build, partial) else build
    return f"{function.__module__.replace('.', '/')}.py:{function.__qualname__}"


def exit_code(entries: list[Entry]) -> int:
    """1 when a statement is refuted, else 2 when one is undecided, else 0."""
    outcomes = {entry.verdict.outcome for entry in entries}
    if Outcome.REFUTED in outcomes:
        return 1
    return 2 if Outcome.UNDECIDED in outcomes else 0
