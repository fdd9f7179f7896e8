"""One entry of the ledger: a statement of the paper, the checks that were run on it, and the verdict."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import ClassVar, NamedTuple

from gspot_verified.numbers.evidence import answered, every, less
from gspot_verified.numbers.verdict import NoTruthValue, Outcome, Reason, Verdict
from gspot_verified.numbers.written import ByName, Written
from gspot_verified.paper.checks.consequences import Consequence, consequence
from gspot_verified.paper.checks.formal_proof import FormalProof
from gspot_verified.paper.checks.paper import Citation, citation, with_printed_numbers


class Rung(ByName):
    """What a check rests on, the strongest first: what it can settle and whom a reader must trust.

    >>> Rung.PAGE.settles, Rung.POINTS.settles, Rung.PAGE.short
    (True, False, 'proof page')
    """

    FORMAL = "a formal proof, checked by a proof assistant"
    EXACT = "an exact symbolic identity or a certificate that covers the whole claim"
    PAGE = "a proof page in proofs/: prose, its steps tested"
    BALLS = "balls that cover the whole stated set"
    POINTS = "points only: supports the claim, cannot prove it for all arguments"

    @property
    def settles(self) -> bool:
        """True when agreement on this rung alone decides the claim."""
        return self is not Rung.POINTS

    @property
    def short(self) -> str:
        """Two to six words for a table."""
        return _SHORT[self]

    def check(self, what: str, agrees: bool | None, finding: str = "") -> Check:
        """A check on this rung."""
        return Check(self, what, agrees, finding)


_SHORT = {
    Rung.FORMAL: "formal proof",
    Rung.EXACT: "exact identity or certificate",
    Rung.PAGE: "proof page",
    Rung.BALLS: "balls over the whole set",
    Rung.POINTS: "points only",
}


@dataclass(frozen=True, slots=True)
class Check(NoTruthValue, Written):
    """One route to the claim: what was done and what came out.

    ``agrees`` is True when the claim holds on everything this check covers, False when it certainly fails somewhere,
    None when the check could not tell.
    """

    ask: ClassVar[str] = ".agrees is True, False or None"

    rung: Rung
    what: str
    agrees: bool | None
    finding: str = ""


class Route(NamedTuple):
    """A way to a claim: what it rests on, what it is, and whether it was run here."""

    rung: str
    what: str
    run: bool


@dataclass(frozen=True, slots=True)
class Entry(NoTruthValue, Written):
    """A statement of the paper with its verdict.

    ``label`` is the paper's label or "line N" of its source; ``source`` the printed form, transcribed as short LaTeX;
    ``statement`` the claim in words; ``corrected`` the form that holds when the printed one is refuted, or the
    condition it needs. ``cited`` has the numbers that the PDF prints and the exact lines of the source. ``code`` is the
    file and the name of the function that made the entry, "" when it was not made by ``verify_paper``. ``formal`` names
    the formal theorems that are the claim (or contradict it) and says whether they were proved here. ``from_cache``:
    the checks were run earlier, on the same sources, and their result was kept.
    """

    definition: ClassVar[str] = "entry"
    written: ClassVar[str] = (
        "identifier label printed=cited.printed verbatim quotations=cited.quotations lines code from_cache formal "
        "routes section source statement checks verdict rung rests_on corrected note consequence"
    )

    identifier: str
    label: str
    section: str
    source: str
    statement: str
    checks: tuple[Check, ...]
    verdict: Verdict
    corrected: str = ""
    note: str = ""
    code: str = ""
    formal: FormalProof | None = None
    from_cache: bool = False

    @property
    def cited(self) -> Citation:
        """What the label cites: printed numbers and quoted lines; empty for a label that the data do not hold."""
        return citation(self.label)

    @property
    def verbatim(self) -> bool:
        """True when the paper's own lines stand beside the entry; else ``source`` is a transcription alone."""
        return bool(self.cited.quotations)

    @property
    def rests_on(self) -> tuple[Rung, ...]:
        """The rungs that carry the verdict, the strongest first; none for an undecided entry."""
        return carrying(self.verdict.outcome, self.checks)

    @property
    def rung(self) -> Rung | None:
        """The strongest rung that the verdict rests on; ``None`` for an undecided entry."""
        return next(iter(self.rests_on), None)

    @property
    def consequence(self) -> Consequence | None:
        """What follows from the error that a refuted entry shows, where it is recorded."""
        return consequence(self.identifier) if self.verdict.outcome is Outcome.REFUTED else None

    @property
    def routes(self) -> tuple[Route, ...]:
        """Each route to the claim: what it rests on, what it is, and whether it was run here."""
        found = [Route(check.rung.short, check.what, True) for check in self.checks]
        if self.formal is not None and not self.formal.run:
            found.append(Route(Rung.FORMAL.short, ", ".join(one.name for one in self.formal.theorems), False))
        return tuple(found)

    @property
    def lines(self) -> tuple[tuple[int, int], ...]:
        """First and last lines of the quotations in the paper's source."""
        return tuple((quotation.first, quotation.last) for quotation in self.cited.quotations)

    @property
    def page_alone(self) -> bool:
        """True when the verdict rests on a proof page and on nothing else: who doubts the page has no other check."""
        return self.rests_on == (Rung.PAGE,)


def carrying(outcome: Outcome, checks: Sequence[Check]) -> tuple[Rung, ...]:
    """The rungs of some checks that carry an outcome, the strongest first.

    A proved entry rests on the settling rungs whose checks agree; points carry nothing. A refuted one rests on the
    checks that fail, points too: one certain counterexample is enough, and its two derivations are two checks.
    """
    if outcome is Outcome.PROVED:
        found = {check.rung for check in checks if check.agrees is True and check.rung.settles}
    elif outcome is Outcome.REFUTED:
        found = {check.rung for check in checks if check.agrees is False}
    else:
        found = set()
    return tuple(rung for rung in Rung if rung in found)


Builders = Mapping[str, Callable[[], Entry]]
"""What makes each entry of a part of the paper, by the entry's identifier, in the order of the paper."""


def all_of(answers: Iterable[bool | None]) -> bool | None:
    """Conjunction of three-valued answers: False when one is False, True when all are True, else ``None``.

    ``None`` for no answers at all: a check that looked at nothing shows nothing. The first False ends the search.
    """
    found = set()
    for answer in answers:
        if answer is False:
            return False
        found.add(answer)
    return True if found == {True} else None


def same_sign(first: int | None, second: int | None) -> bool | None:
    """Whether two certified signs agree; ``None`` when one of them is not certain."""
    return None if first is None or second is None else first == second


def conclude(statement: str, checks: Sequence[Check], witness: str = "") -> Verdict:
    """The verdict that two or more checks support.

    - refuted: two different checks fail with certainty (two derivations of a counterexample), and none on a settling
      rung says that the claim holds;
    - proved: every check agrees, there are at least two different ones, and one is on a settling rung;
    - undecided: anything else, and the reason says which: checks that contradict each other, one failure alone, a
      check that could not tell, points alone, one check alone.
    """
    failures = [check for check in checks if check.agrees is False]
    settling = [check for check in checks if check.agrees is True and check.rung.settles]
    if failures and settling:
        detail = f"the checks contradict each other: {settling[0].what} agrees, {failures[0].what} fails"
        return Verdict.undecided(statement, Reason.CONTRADICTION, detail)
    if len({check.what for check in failures}) >= 2:
        first, second = failures[0], next(check for check in failures if check.what != failures[0].what)
        failed = answered(((check.what, check.agrees) for check in (first, second)), False)
        evidence = every([failed, less(1, len({first.what, second.what}))])
        witness = witness or first.finding or first.what
        return Verdict.refuted(statement, witness, evidence, second.finding or second.what)
    if failures:
        return Verdict.undecided(statement, Reason.ONE_FAILURE, f"one check fails: {failures[0].finding}")
    if any(check.agrees is None for check in checks):
        open_checks = "; ".join(check.what for check in checks if check.agrees is None)
        return Verdict.undecided(statement, Reason.BUDGET, f"could not tell: {open_checks}")
    different = {check.what for check in checks}
    if len(different) >= 2 and settling:
        agreed = answered(((check.what, check.agrees) for check in checks), True)
        evidence = every([agreed, less(1, len(different)), less(0, len(settling))])
        return Verdict.proved(statement, evidence, "; ".join(check.what for check in checks))
    if checks and not settling:
        return Verdict.undecided(statement, Reason.POINTS, "the checks at points alone prove nothing")
    detail = "there is one check alone" if checks else "there is no check"
    return Verdict.undecided(statement, Reason.NO_ROUTE, detail)


class Section(str):
    """A section of the paper, as its entries name it.

    >>> Section("Section 2").settled("2-x", "line 1", "x", "y", Rung.EXACT.check("z", None)).section
    'Section 2'
    """

    __slots__ = ()

    def settled(
        self,
        identifier: str,
        label: str,
        source: str,
        statement: str,
        *checks: Check,
        corrected: str = "",
        note: str = "",
    ) -> Entry:
        """An entry with the verdict that its checks support; labels of equations become printed numbers."""
        statement, corrected, note = (with_printed_numbers(text) for text in (statement, corrected, note))
        checks = tuple(
            replace(check, what=with_printed_numbers(check.what), finding=with_printed_numbers(check.finding))
            for check in checks
        )
        return Entry(
            identifier=identifier,
            label=label,
            section=str(self),
            source=source,
            statement=statement,
            checks=checks,
            verdict=conclude(statement, checks),
            corrected=corrected,
            note=note,
        )


def counts(entries: Sequence[Entry]) -> dict[str, int]:
    """How many entries have each outcome."""
    return {outcome.value: sum(e.verdict.outcome is outcome for e in entries) for outcome in Outcome}


def rung_counts(entries: Sequence[Entry]) -> dict[str, dict[str, int]]:
    """For proved and for refuted entries: how many rest on each rung, each entry counted at its strongest one."""
    return {
        outcome.value: {
            rung.name.lower(): sum(e.verdict.outcome is outcome and e.rung is rung for e in entries) for rung in Rung
        }
        for outcome in (Outcome.PROVED, Outcome.REFUTED)
    }
