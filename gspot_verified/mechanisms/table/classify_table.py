"""A mechanism for many values of its parameters: the Case and the side of each row's G-spot, proved row by row.

Everything symbolic is done once in each process: the conditions of a G-spot, and what is asked of it, are functions of
the state and of the parameters, compiled as for a sweep. A row is a sweep's box of one point: ``proofs/sweep.md``,
sections 1 to 4.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import partial
from itertools import chain
from pathlib import Path
from typing import Any, NamedTuple

from gspot_verified.expansion.series.regularisation import NO_DAMPER
from gspot_verified.mechanisms.derive.impossible import refuse_impossible
from gspot_verified.mechanisms.derive.to_system import counted_from_zero
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError, require_mechanism
from gspot_verified.mechanisms.sweep.sweep_cell import BITS
from gspot_verified.mechanisms.sweep.sweep_findings import HYPOTHESES, findings
from gspot_verified.mechanisms.sweep.sweep_first import first_spot, with_place_of
from gspot_verified.mechanisms.sweep.sweep_piece import NUMBERS, interval
from gspot_verified.mechanisms.sweep.sweep_trace import Choice, TubeTrace
from gspot_verified.mechanisms.sweep.sweep_work import compiled, read_line, whole_text
from gspot_verified.mechanisms.table.classified_row import ClassifiedRow
from gspot_verified.mechanisms.table.parameter_rows import ParameterRow, Row, parameter_rows
from gspot_verified.mechanisms.table.row_search import Start, is_sought, middle_of, searched
from gspot_verified.mechanisms.table.table_work import Kept, answered_rows
from gspot_verified.mechanisms.zeros.tube import Equations
from gspot_verified.numbers.balls import working_bits
from gspot_verified.work.journal_file import JournalFile

_PORTION = 64  # rows of one task, and of one line of the journal
_NOT_FOUND = "no G-spot was found from the place that the mechanism names"


@dataclass(frozen=True, slots=True)
class _Question:
    """What is asked of each row: the mechanism, its columns, and from where a G-spot is sought."""

    start: Start

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism, with its own values."""
        return self.start.mechanism

    @property
    def parameters(self) -> tuple[str, ...]:
        """The columns."""
        return self.start.parameters

    def header(self) -> dict[str, Any]:
        """What a journal's first line says."""
        return {
            "kind": "table 1",
            "mechanism": hashlib.sha256(whole_text(self.mechanism).encode()).hexdigest(),
            "parameters": list(self.parameters),
            "fixed": list(self.start.fixed),
        }

    def equations(self) -> Equations:
        """The conditions and quantities, compiled once in each process."""
        return compiled(self.mechanism, self.parameters, self.start.fixed)


class _Answer(NamedTuple):
    """What a portion of rows gave: it pickles."""

    rows: list[ClassifiedRow]
    digest: str
    choices: str


def classify_table(
    mechanism: Mechanism,
    table: str | Path | Iterable[Row],
    *,
    executor: Executor | None = None,
    journal: str | Path | None = None,
    progress: Callable[[int], None] | None = None,
) -> Iterator[ClassifiedRow]:
    """The Case and the side of the mechanism's G-spot for each row of parameter values, in their order, as they come.

    ``table``: a CSV file whose first line names parameters, with exact numbers ("0.1" means 1/10); or mappings from
    names to values. Other parameters keep their values. In each row the search begins at the place that the mechanism
    names, with the row's values in it, then at the mechanism's own G-spot; what is found is proved to be the only
    G-spot in a box. A row that is wrong, or a mechanism that cannot be, is refused alone. ``executor``: where rows are
    looked at; the result is the same for every one. ``journal``: a killed run goes on from this file; what it recalls
    is proved again. ``progress`` is told how many rows are done. Memory does not grow with the table.

    :raises GSpotError: the mechanism itself has no G-spot, or a degenerate one.
    :raises MechanismError: a column is no parameter, there is no row, or the mechanism is not complete.
    :raises ValueError: the journal is of another question, or the mechanism has several G-spots and names none.

    >>> from gspot_verified import load
    >>> rod = load("genot_brogliato_rod")
    >>> rows = classify_table(rod, [{"mu": "3/2", "L": 1}, {"mu": 2, "L": "1/3"}, {"mu": -1, "L": 1}])
    >>> [(row.outcome, row.case) for row in rows]
    [('settled', 'none'), ('settled', 'II'), ('refused', None)]
    """
    require_mechanism(mechanism)
    table_rows = parameter_rows(mechanism, table)
    first = first_spot(mechanism, None)
    with working_bits(BITS):
        start = Start(with_place_of(mechanism, first), table_rows.parameters, first.fixed, middle_of(first))
    question = _Question(start)
    again = partial(_proved_again, question)
    kept = None if journal is None else Kept(JournalFile(journal, question.header()), again, read_line)
    return answered_rows(table_rows.rows, _PORTION, partial(_examined, question), executor, progress, kept)


def _proved_again(question: _Question, rows: list[ParameterRow], line: str) -> _Answer:
    """Along the tubes of a journal's line; without them where other rows come out than those of its digest."""
    _, expected, known = read_line(line)
    answer = _examined(question, rows, known)
    return answer if answer.digest == expected else _examined(question, rows)


def _examined(question: _Question, rows: list[ParameterRow], known: list[list[Choice]] | None = None) -> _Answer:
    done, choices = [], []
    for row, tubes in zip(rows, chain(known or (), [[]] * len(rows)), strict=False):
        trace = TubeTrace(tubes)
        done.append(_row(question, row, trace))
        choices.append(trace.met)
    digest = hashlib.sha256("".join(row.to_csv() for row in done).encode()).hexdigest()
    return _Answer(done, digest, json.dumps(choices))


def _row(question: _Question, row: ParameterRow, trace: TubeTrace) -> ClassifiedRow:
    mechanism, values = question.mechanism, row.values
    if values is None:
        return _unknown(mechanism, row, "refused", row.wrong)
    try:
        refuse_impossible(mechanism.with_parameters(**dict(zip(question.parameters, values, strict=True))))
    except MechanismError as error:
        return _unknown(mechanism, row, "refused", str(error))
    with working_bits(BITS):
        equations = question.equations()
        search = partial(searched, equations, question.start, values)
        on = trace.tube(equations, values, values, search, partial(is_sought, question.start, values))
        if on is None:
            return _unknown(mechanism, row, "undecided", _NOT_FOUND)
        facts, point = (
            findings(on, {}, damped=mechanism.regularisation.c > 0),
            counted_from_zero(mechanism, on.tube.zero_at(values)),
        )
        known = facts.case, facts.lift_off_sign, facts.impact_sign
        case, lift_off, impact = (None, None, None) if set(HYPOTHESES) & set(facts.unsure) else known
        no_side = "" if mechanism.regularisation.c > 0 or case in (None, "none") else f"no side: {NO_DAMPER}"
        return ClassifiedRow(
            number=row.number,
            given=row.given,
            outcome="undecided" if facts.unsure else "settled",
            case=case,
            lift_off_sign=lift_off,
            impact_sign=impact,
            reason=f"not certain: {'; '.join(_said(name) for name in facts.unsure)}" if facts.unsure else no_side,
            numbers=tuple(zip(NUMBERS, facts.shown(), strict=True)),
            point=tuple(zip(mechanism.state, map(interval, point), strict=True)),
        )


def _unknown(mechanism: Mechanism, row: ParameterRow, outcome: str, reason: str) -> ClassifiedRow:
    return ClassifiedRow(
        number=row.number,
        given=row.given,
        outcome=outcome,
        case=None,
        lift_off_sign=None,
        impact_sign=None,
        reason=reason,
        numbers=tuple((name, None) for name in NUMBERS),
        point=tuple((word, None) for word in mechanism.state),
    )


def _said(name: str) -> str:
    """What is not certain, in words."""
    return f"the sign of {name}" if name.startswith(("alpha", "beta -")) else name
