"""The three outcomes of a check, kept apart: proved, refuted with a witness, undecided with a reason."""

from __future__ import annotations

import enum
from dataclasses import dataclass, field
from typing import ClassVar, NoReturn

from gspot_verified.numbers.counted import counted
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.numbers.written import ByName, Shown, Written


class Outcome(enum.Enum):
    """What a check found. Undecided is neither of the other two and never counts as passed."""

    PROVED = "proved"
    REFUTED = "refuted"
    UNDECIDED = "undecided"


class Reason(ByName):
    """Why a check stayed undecided."""

    BUDGET = "the stated budget ended before the question was settled"
    WIDE_INPUT = "the input balls are too wide: different numbers in them may have different answers"
    HYPOTHESIS = "a hypothesis of the bound could not be verified"
    BEYOND = "no proof is sought there: it is beyond what the method covers"
    NO_ROUTE = "no second route is at hand, so the first one stands alone"
    CONTRADICTION = "two checks of the same statement contradict each other"
    ONE_FAILURE = "one check fails; a refutation needs a second derivation of the counterexample"
    POINTS = "checks at points support the statement, they cannot prove it for all arguments"
    FLOATS = "a float run proves nothing"


class NoTruthValue(Shown):
    """Base of the result types: ``bool`` of one raises TypeError, and the message says what to ask instead.

    Without it ``if result:`` would be true for a result that proves nothing.

    >>> class Answer(NoTruthValue):
    ...     ask = ".agrees is True, False or None"
    >>> bool(Answer())
    Traceback (most recent call last):
    ...
    TypeError: Answer has no truth value: .agrees is True, False or None
    """

    __slots__ = ()
    ask: ClassVar[str] = ".verdict.outcome is Outcome.PROVED, REFUTED or UNDECIDED"
    """What to ask instead; it begins with the name of an attribute, after a dot."""

    def __bool__(self) -> NoReturn:
        raise TypeError(f"{type(self).__name__} has no truth value: {self.ask}")


_EXIT_CODES = {Outcome.PROVED: 0, Outcome.REFUTED: 1, Outcome.UNDECIDED: 2}


class Evidence:
    """Certain facts, in words made from the values that :mod:`gspot_verified.numbers.evidence` compared.

    :raises TypeError: made by hand.
    """

    __slots__ = ("facts",)
    facts: tuple[str, ...]

    def __init__(self) -> None:
        raise TypeError(
            "evidence is made by a comparison: less, at_most, equal, differ, inside, signed, cover, every, theorem"
        )

    @classmethod
    def _of_facts(cls, facts: tuple[str, ...]) -> Evidence:
        evidence = object.__new__(cls)
        object.__setattr__(evidence, "facts", facts)
        return evidence

    def __setattr__(self, name: str, value: object) -> NoReturn:
        raise AttributeError("evidence does not change")

    def __reduce__(self) -> tuple[object, tuple[tuple[str, ...]]]:
        return Evidence._of_facts, (self.facts,)

    def __str__(self) -> str:
        return "; ".join(self.facts)


@dataclass(frozen=True, slots=True)
class Verdict(Written):
    """The outcome for one statement.

    ``evidence`` is what was compared for a proved one, ``against`` for a refuted one: what contradicts a statement is
    never handed on as what shows it. ``witness`` says where a refuted statement fails, ``reason`` why an undecided one
    is open, ``remaining`` which boxes (tuples of intervals) are left.

    :raises ValueError: proved or refuted without evidence, refuted without a witness, or undecided without a reason.

    >>> from gspot_verified import sign
    >>> verdict = sign("0", "1/2").verdict
    >>> print(verdict)
    proved: dΘ/dτ < 0 at τ = 0 and at β = 1/2
    >>> bool(verdict)
    Traceback (most recent call last):
    ...
    TypeError: a verdict has three outcomes; compare .outcome with Outcome.PROVED, REFUTED or UNDECIDED
    """

    definition: ClassVar[str] = "verdict"
    written: ClassVar[str] = "outcome statement witness reason detail remaining"

    outcome: Outcome
    statement: str
    witness: str | None = None
    reason: Reason | None = None
    detail: str = ""
    remaining: tuple[tuple[Dyadic, ...], ...] = ()
    evidence: Evidence | None = field(default=None, compare=False, repr=False)
    against: Evidence | None = field(default=None, compare=False, repr=False)

    def __post_init__(self) -> None:
        if self.outcome is Outcome.REFUTED and not self.witness:
            raise ValueError("a refuted statement needs a witness")
        if self.outcome is Outcome.UNDECIDED and self.reason is None:
            raise ValueError("an undecided statement needs a reason")
        for outcome, given in ((Outcome.PROVED, self.evidence), (Outcome.REFUTED, self.against)):
            if self.outcome is outcome and not isinstance(given, Evidence):
                needed = "needs evidence: values that were compared (gspot_verified.numbers.evidence)"
                raise ValueError(f"a {outcome.value} statement {needed}")
            if self.outcome is not outcome and given is not None:
                raise ValueError(f"only a {outcome.value} statement has this evidence, not a {self.outcome.value} one")

    @classmethod
    def proved(cls, statement: str, evidence: Evidence | None, detail: str = "") -> Verdict:
        """The statement holds by the evidence.

        :raises ValueError: there is none.
        """
        return cls(Outcome.PROVED, statement, detail=detail, evidence=evidence)

    @classmethod
    def refuted(cls, statement: str, witness: str, evidence: Evidence | None, detail: str = "") -> Verdict:
        """The statement fails at ``witness`` by the evidence: what was compared there.

        :raises ValueError: there is none, or no witness.
        """
        return cls(Outcome.REFUTED, statement, witness=witness, detail=detail, against=evidence)

    @classmethod
    def undecided(
        cls,
        statement: str,
        reason: Reason,
        detail: str = "",
        remaining: tuple[tuple[Dyadic, ...], ...] = (),
    ) -> Verdict:
        """Neither was shown."""
        return cls(Outcome.UNDECIDED, statement, reason=reason, detail=detail, remaining=remaining)

    def __bool__(self) -> NoReturn:
        raise TypeError("a verdict has three outcomes; compare .outcome with Outcome.PROVED, REFUTED or UNDECIDED")

    @property
    def exit_code(self) -> int:
        """0 proved, 1 refuted, 2 undecided: what the command line returns."""
        return _EXIT_CODES[self.outcome]

    def __str__(self) -> str:
        text = f"{self.outcome.value}: {self.statement}"
        if self.witness:
            text += f"\n  witness: {self.witness}"
        if self.reason:
            text += f"\n  reason: {self.reason.value}"
        if self.detail:
            text += f"\n  {self.detail}"
        if self.remaining:
            text += f"\n  {counted(len(self.remaining), 'box', 'boxes')} left"
        return text
