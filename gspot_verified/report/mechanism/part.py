"""One part of the page on a mechanism: a result with its verdict, or the reason why nothing is stated."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any, ClassVar

from gspot_verified.numbers.verdict import NoTruthValue, Outcome, Verdict
from gspot_verified.numbers.written import Written
from gspot_verified.report.certificates import CheckedCertificate
from gspot_verified.report.pictures.canvas import Picture
from gspot_verified.signs.zeros.slope_at import UndecidedError
from gspot_verified.theta_function.value.routes import BudgetError


@dataclass(frozen=True, slots=True)
class ReportPart(NoTruthValue, Written):
    """``text`` is what the result prints, ``data`` its JSON; ``commands`` give the same again, in the report's folder.

    ``outcome`` is None where nothing is stated: ``text`` then says why, or it is a picture or a table of numbers.
    """

    ask: ClassVar[str] = ".outcome is Outcome.PROVED, REFUTED, UNDECIDED, or None: nothing is stated"
    written: ClassVar[str] = "title outcome text commands picture certificates data"

    title: str
    outcome: Outcome | None
    text: str
    commands: tuple[str, ...] = ()
    picture: Picture | None = None
    certificates: tuple[CheckedCertificate, ...] = ()
    data: Any = None


def attempted(title: str, make: Callable[[], ReportPart]) -> ReportPart:
    """What ``make`` gives; where a hypothesis fails or a budget ends, a part that says so."""
    try:
        return make()
    except (UndecidedError, BudgetError) as error:
        return ReportPart(title, Outcome.UNDECIDED, f"undecided: {error}")
    except ValueError as error:
        return ReportPart(title, None, f"nothing is stated: {error}")


def outcome_of(verdicts: Iterable[Verdict]) -> Outcome:
    """Proved when all are; refuted when one is; else undecided.

    >>> outcome_of([]).value
    'undecided'
    """
    outcomes = {verdict.outcome for verdict in verdicts}
    if Outcome.REFUTED in outcomes:
        return Outcome.REFUTED
    return Outcome.PROVED if outcomes == {Outcome.PROVED} else Outcome.UNDECIDED
