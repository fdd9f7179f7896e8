"""The catalogue: every family (``families.toml``) at every level, and how work and time grow."""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from importlib import resources
from typing import ClassVar

from gspot_verified.cost.times.growth import fitted_exponent
from gspot_verified.cost.times.rows import seconds_text
from gspot_verified.hard_cases import (
    compliant_cases,
    expansion_cases,
    fold_cases,
    mechanism_cases,
    sign_cases,
    theta_cases,
)
from gspot_verified.hard_cases.hard_case import Case, HardCase
from gspot_verified.numbers.counted import done_of
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written, under

CASES: dict[str, Case] = {
    **theta_cases.CASES,
    **sign_cases.CASES,
    **expansion_cases.CASES,
    **compliant_cases.CASES,
    **fold_cases.CASES,
    **mechanism_cases.CASES,
}


@dataclass(frozen=True, slots=True)
class Family(Written):
    """Questions that get harder with a number: ``variable`` says what it is, ``work`` what is counted.

    ``part`` is the package that answers. ``formula`` is the usual formula (LaTeX), ``why`` says what is hard in it and
    ``instead`` what the library does.
    """

    written: ClassVar[str] = "name part title variable formula why instead work"

    name: str
    part: str
    title: str
    variable: str
    formula: str
    why: str
    instead: str
    work: str
    levels: tuple[int, ...]

    @property
    def case(self) -> Case:
        """The function that asks the question."""
        return CASES[self.name]


@lru_cache(maxsize=1)
def families() -> tuple[Family, ...]:
    """Every family, in the order of the catalogue.

    >>> {"side", "canard", "spots-meet"} <= {family.name for family in families()}
    True
    """
    text = resources.files("gspot_verified.hard_cases").joinpath("families.toml").read_text(encoding="utf-8")
    return tuple(Family(**{**row, "levels": tuple(row["levels"])}) for row in tomllib.loads(text)["families"])


_QUESTION = (("question", "condition", "bits lost", "work", "time"), (59, 9, 9, 5, 8))
_ANSWERS = (("", "double precision", "certified"), (5, 24, 0))
"""The lines of each case: the words above, and characters of the columns."""
WIDTH, _NARROWEST = 100, 60  # of the table
_MARKS = {True: "right", False: "WRONG", None: "-"}


@dataclass(frozen=True, slots=True)
class Measured(NoTruthValue, Written):
    """A family at its levels."""

    ask: ClassVar[str] = ".cases holds the rows, each with .certified and .double_right"
    written: ClassVar[str] = f"{under('family', Family.written)} growth rows=cases"

    family: Family
    cases: tuple[HardCase, ...]

    @property
    def decided(self) -> tuple[HardCase, ...]:
        """The rows with an answer."""
        return tuple(case for case in self.cases if case.certified is not None)

    @property
    def growth(self) -> dict[str, float | None]:
        """Work and time of the decided rows grow like these powers of the level; None with fewer than two levels."""
        return {
            "work": fitted_exponent([(case.level, case.work) for case in self.decided]),
            "seconds": fitted_exponent([(case.level, case.seconds) for case in self.decided]),
        }


@dataclass(frozen=True, slots=True)
class Catalogue(NoTruthValue, Written):
    """Every family that was asked for."""

    ask: ClassVar[str] = ".families holds what was measured, .summary() counts it"
    written: ClassVar[str] = "families summary"

    families: tuple[Measured, ...]

    def summary(self) -> dict[str, int]:
        """How many rows there are, are decided, and have a right, a wrong or no answer in double precision."""
        cases = [case for family in self.families for case in family.cases]
        return {
            "rows": len(cases),
            "decided": sum(case.certified is not None for case in cases),
            "double_right": sum(case.double_right is True for case in cases),
            "double_wrong": sum(case.double_right is False for case in cases),
        }

    def __str__(self) -> str:
        return self.table()

    def table(self, width: int = WIDTH) -> str:
        """The text in so many columns, 60 at least: what is longer ends in "…"; all of it is in ``to_json``."""
        blocks = [_lines(_QUESTION[0], _ANSWERS[0]), *map(_block, self.families)]
        text = "\n\n".join([*blocks, summary_text(self.summary())])
        return "\n".join(_cut(line, max(width, _NARROWEST)) for line in text.split("\n"))


def measure_hard_cases(names: Sequence[str] = (), progress: Callable[[str], None] = lambda _: None) -> Catalogue:
    """The families of these names, all if none: about ten seconds of processor time.

    The command is ``hard-cases``; that word is the subpackage here.

    :raises ValueError: no family has that name.

    >>> family = measure_hard_cases(["fold"]).families[0]
    >>> [(case.certified, case.double) for case in family.cases]
    [(2, 2.0), (2, 2.0), (2, 2.0), (2, 0.0), (2, 0.0)]
    """
    known = {family.name: family for family in families()}
    for name in names:
        if name not in known:
            raise ValueError(f"no family of hard cases is named {name[:40]!r}; there are: {', '.join(known)}")
    results: list[Measured] = []
    asked = [known[name] for name in dict.fromkeys(names)] or families()
    for family in asked:
        progress(f"{family.title}; {done_of(len(results), len(asked), 'family', 'families')} done")
        results.append(measured(family))
    return Catalogue(tuple(results))


def measured(family: Family) -> Measured:
    """The family at each of its levels, now."""
    return Measured(family, tuple(map(family.case, family.levels)))


def summary_text(summary: dict[str, int]) -> str:
    """The counts with their denominators.

    >>> summary_text({"rows": 9, "decided": 8, "double_right": 3, "double_wrong": 5})
    'of 9 cases: 8 decided, 1 undecided; double precision: 3 right, 5 wrong, 1 not compared'
    """
    rows, decided = summary["rows"], summary["decided"]
    right, wrong = summary["double_right"], summary["double_wrong"]
    return (
        f"of {rows} cases: {decided} decided, {rows - decided} undecided; "
        f"double precision: {right} right, {wrong} wrong, {rows - right - wrong} not compared"
    )


def _block(measurement: Measured) -> str:
    family = measurement.family
    lines = [f"{family.title} ({family.name}; {family.part}): {family.variable}"]
    lines += [_row(case) for case in measurement.cases]
    grown = [f"{word} like (level)^{power:.2f}" for word, power in _powers(measurement) if power is not None]
    return "\n".join([*lines, *([f"  {', '.join(grown)}"] if grown else [])])


def _powers(measurement: Measured) -> list[tuple[str, float | None]]:
    growth = measurement.growth
    return [(measurement.family.work, growth["work"]), ("time", growth["seconds"])]


def _row(case: HardCase) -> str:
    """The question, and below it what was found."""
    condition = "-" if case.condition is None else f"10^{case.condition:.1f}"
    lost = "-" if case.lost is None else str(case.lost)
    question = (case.asked, condition, lost, str(case.work), seconds_text(case.seconds))
    return _lines(question, (_MARKS[case.double_right], case.double_text or "-", case.text))


def _lines(question: Sequence[str], answers: Sequence[str]) -> str:
    """Two lines; a question or an answer that is too long for its line has one of its own."""
    first, second = f"  {_aligned(question, _QUESTION[1])}", f"      {_aligned(answers, _ANSWERS[1])}"
    if len(first) > WIDTH:
        first = f"  {question[0]}\n  {_aligned(('', *question[1:]), _QUESTION[1])}"
    if len(second) > WIDTH:
        second = f"      {_aligned((*answers[:2], ''), _ANSWERS[1])}\n      {_aligned(('', answers[2]), (5, 0))}"
    return f"{first}\n{second}"


def _aligned(cells: Sequence[str], widths: Sequence[int]) -> str:
    return "  ".join(cell.ljust(width) for cell, width in zip(cells, widths, strict=True)).rstrip()


def _cut(line: str, width: int) -> str:
    return line if len(line) <= width else line[: width - 1] + "…"
