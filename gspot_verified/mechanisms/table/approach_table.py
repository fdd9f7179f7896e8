"""Where slip leads for many values of parameters and of the state: one row of a table after the other, each proved."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import lru_cache, partial
from pathlib import Path
from typing import NamedTuple

from gspot_verified.mechanisms.approach.approach import PRECISIONS
from gspot_verified.mechanisms.approach.approach_result import Approach
from gspot_verified.mechanisms.approach.mechanism_side import side_from
from gspot_verified.mechanisms.approach.slip_state import StateInput
from gspot_verified.mechanisms.derive.impossible import refuse_impossible
from gspot_verified.mechanisms.derive.to_system import Shifted, counted_from_zero, shift
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError, exact_rational, require_mechanism
from gspot_verified.mechanisms.sweep.sweep_piece import interval
from gspot_verified.mechanisms.table.approached_row import ApproachedRow
from gspot_verified.mechanisms.table.parameter_rows import ParameterRow, Row, parameter_rows
from gspot_verified.mechanisms.table.row_text import Numbers
from gspot_verified.mechanisms.table.table_work import answered_rows
from gspot_verified.numbers.balls import ExactInput, working_bits

_PORTION = 16  # rows of one task: each takes a tenth of a second or so
_PRECISIONS = (64, *PRECISIONS)  # bits, tried in turn: most rows are settled by the first
_NUMBERS = ("time", "alpha_1", "alpha_2", "alpha_3", "beta", "C1")


@dataclass(frozen=True, slots=True)
class _Question:
    """What is asked of each row: the mechanism, the parameters that are columns, the state as far as it is given."""

    mechanism: Mechanism
    parameters: tuple[str, ...]
    state: tuple[tuple[str, str], ...]
    surface: str | None


class _Answer(NamedTuple):
    """What a portion of rows gave: it pickles. Nothing of it is kept."""

    rows: list[ApproachedRow]
    digest: str = ""
    choices: str = ""


def approach_table(
    mechanism: Mechanism,
    table: str | Path | Iterable[Row],
    state: StateInput | None = None,
    *,
    surface_velocity: ExactInput | None = None,
    executor: Executor | None = None,
    progress: Callable[[int], None] | None = None,
) -> Iterator[ApproachedRow]:
    """What :func:`approach` and :func:`mechanism_side` prove for each row of values, in their order, as they come.

    ``table``: a CSV file whose first line names parameters and components of the state, with exact numbers ("0.1" means
    1/10), for components also formulas; or mappings from names to values. ``state``: components that are the same in
    all rows. A row that is wrong, a mechanism that cannot be, a state from which nothing slips is refused alone.
    ``executor``: where rows are looked at; the result is the same for every one. ``progress`` is told how many rows are
    done. Memory does not grow with the table. Nothing is kept of a killed run: to prove a path again takes as long.
    A row is settled with as few bits as its answer needs, so its numbers may have few digits, which are certain; those
    of :func:`mechanism_side` have more.

    :raises MechanismError: a column is no parameter and no component, there is no row, or the mechanism is not
        complete.
    :raises ValueError: a component is a column and in ``state``.

    >>> from gspot_verified import load
    >>> rows = approach_table(load("model system"), [{"b": "-2"}, {"b": "2"}], {"x": 0, "u": 3, "p": "1/2"})
    >>> [(row.outcome, row.end, row.side, row.small_epsilon_side) for row in rows]
    [('settled', 'G-spot', 'lift-off', 'lift-off'), ('refused', None, None, None)]
    """
    require_mechanism(mechanism)
    table_rows = parameter_rows(mechanism, table, with_state=True)
    given = {word: value if isinstance(value, str) else str(exact_rational(value, word))
             for word, value in (state or {}).items()}  # fmt: skip
    twice = next((word for word in table_rows.components if word in given), None)
    if twice is not None:
        raise ValueError(f"{twice}: the table has a column {twice}, and the state gives it too")
    surface = None if surface_velocity is None else str(exact_rational(surface_velocity, "surface_velocity"))
    question = _Question(mechanism, table_rows.parameters, tuple(given.items()), surface)
    return answered_rows(table_rows.rows, _PORTION, partial(_examined, question), executor, progress)


def _examined(question: _Question, rows: list[ParameterRow]) -> _Answer:
    return _Answer([_row(question, row) for row in rows])


def _row(question: _Question, row: ParameterRow) -> ApproachedRow:
    if row.values is None:
        return _refused(question, row, row.wrong)
    try:
        mechanism = question.mechanism.with_parameters(**dict(zip(question.parameters, row.values, strict=True)))
        refuse_impossible(mechanism)
        found = side_from(
            _shifted(mechanism),
            dict(question.state + row.state),
            surface_velocity=question.surface,
            precisions=_PRECISIONS,
        )
    except MechanismError as error:
        return _refused(question, row, str(error))
    slip = found.approach
    settled = slip.exit_code == 0
    at_spot = slip.end == "G-spot"
    return ApproachedRow(
        number=row.number,
        given=row.given,
        outcome="settled" if settled else "undecided",
        end=slip.end,
        case=slip.case,
        side=slip.side,
        small_epsilon_side=found.side,
        reason="" if settled else slip.side_reason if at_spot else slip.verdict.detail,
        small_epsilon_reason=found.verdict.detail if at_spot and found.side is None else "",
        warnings=slip.warnings,
        numbers=_numbers(slip),
        point=_point(mechanism, slip),
    )


@lru_cache(1)
def _shifted(mechanism: Mechanism) -> Shifted:
    """Derived once for rows with the same parameters."""
    return shift(mechanism)


def _numbers(slip: Approach) -> Numbers:
    alphas = slip.alphas or (None, None, None)
    return tuple(zip(_NUMBERS, map(interval, (slip.time, *alphas, slip.beta, slip.coefficient)), strict=True))


def _point(mechanism: Mechanism, slip: Approach) -> Numbers:
    """The G-spot that is reached, an angle with its reference; nothing known where none is."""
    with working_bits(slip.bits):
        point = counted_from_zero(mechanism, slip.spot) if slip.spot else [None] * len(mechanism.state)
        return tuple(zip(mechanism.state, map(interval, point), strict=True))


def _refused(question: _Question, row: ParameterRow, reason: str) -> ApproachedRow:
    return ApproachedRow(
        number=row.number,
        given=row.given,
        outcome="refused",
        end=None,
        case=None,
        side=None,
        small_epsilon_side=None,
        reason=reason,
        small_epsilon_reason="",
        warnings=(),
        numbers=tuple((name, None) for name in _NUMBERS),
        point=tuple((word, None) for word in question.mechanism.state),
    )
