"""Where slip leads for many values of parameters and of the state: one row of a table after the other, each proved."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import lru_cache, partial
from itertools import chain, islice
from pathlib import Path
from typing import NamedTuple

from flint import arb

from gspot_verified.mechanisms.approach.approach import PRECISIONS
from gspot_verified.mechanisms.approach.approach_result import Approach
from gspot_verified.mechanisms.approach.mechanism_side import MechanismSide, side_from
from gspot_verified.mechanisms.approach.slip_state import StateInput
from gspot_verified.mechanisms.derive.impossible import refuse_impossible
from gspot_verified.mechanisms.derive.shared_derivation import shared_derivation, with_numbers
from gspot_verified.mechanisms.derive.to_system import Shifted, counted_from_zero, shift
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError, exact_rational, require_mechanism
from gspot_verified.mechanisms.sweep.sweep_piece import interval
from gspot_verified.mechanisms.table.approached_row import ApproachedRow
from gspot_verified.mechanisms.table.parameter_rows import ParameterRow, Row, parameter_rows
from gspot_verified.mechanisms.table.row_text import Numbers
from gspot_verified.mechanisms.table.table_work import answered_rows
from gspot_verified.numbers.balls import ExactInput, bits_for_digits, relative_bits, working_bits
from gspot_verified.numbers.verdict import Reason

_PORTION = 16  # rows of one task: each takes a tenth of a second or so
_PRECISIONS = (46, 64, *PRECISIONS)  # bits, tried in turn: the least is enough for many rows
_BITS_FOR_DIGITS = 1_000  # one more try, where digits are asked for
_MOST_DIGITS = 15  # that doubles hold
_NUMBERS = ("time", "alpha_1", "alpha_2", "alpha_3", "beta", "C1")


@dataclass(frozen=True, slots=True)
class _Question:
    """What is asked of each row: the mechanism, the parameters that are columns, the state as far as it is given."""

    mechanism: Mechanism
    parameters: tuple[str, ...]
    state: tuple[tuple[str, str], ...]
    surface: str | None
    digits: int | None

    @property
    def precisions(self) -> tuple[int, ...]:
        """In bits."""
        return _PRECISIONS if self.digits is None else (*_PRECISIONS, _BITS_FOR_DIGITS)

    @property
    def bits(self) -> int:
        """Of C_1 that are asked for; 0: its sign is enough."""
        return 0 if self.digits is None else bits_for_digits(self.digits)


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
    digits: int | None = None,
    only: tuple[int, int | None] | None = None,
    executor: Executor | None = None,
    progress: Callable[[int], None] | None = None,
) -> Iterator[ApproachedRow]:
    """What :func:`approach` and :func:`mechanism_side` prove for each row of values, in their order, as they come.

    ``table``: a CSV file whose first line names parameters and components of the state, with exact numbers ("0.1" means
    1/10), for components also formulas; or mappings from names to values. ``state``: components that are the same in
    all rows. A row that is wrong, a mechanism that cannot be, a state from which nothing slips is refused alone.
    ``executor``: where rows are looked at; the result is the same for every one. ``progress`` is told how many rows are
    done. Memory does not grow with the table.

    A row is settled with as few bits, and from a state as far from the G-spot, as its signs need: its numbers have few
    digits, often none of C_1, but certain bounds. ``digits``, 1 to 15: so many of C_1; a row that has fewer is
    undecided and says how many. ``only``: the first row and the last one (None: of the table), to do a long table in
    parts: nothing is kept of a killed run, as to prove a path again takes as long as to prove it first.

    :raises MechanismError: a column is no parameter and no component, there is no row, or the mechanism is not
        complete.
    :raises TypeError: ``digits`` is not an int.
    :raises ValueError: a component is a column and in ``state``; ``digits`` or ``only`` is out of range.

    >>> from gspot_verified import load
    >>> rows = approach_table(load("model system"), [{"b": "-2"}, {"b": "2"}], {"x": 0, "u": 3, "p": "1/2"})
    >>> [(row.outcome, row.end, row.side, row.small_epsilon_side) for row in rows]
    [('settled', 'G-spot', 'lift-off', 'lift-off'), ('refused', None, None, None)]
    """
    require_mechanism(mechanism)
    if digits is not None:
        bits_for_digits(digits)
        if digits > _MOST_DIGITS:
            raise ValueError(f"digits must lie in 1..{_MOST_DIGITS}, as many as doubles hold, got {digits}")
    table_rows = parameter_rows(mechanism, table, with_state=True)
    rows = table_rows.rows if only is None else _part(table_rows.rows, *only)
    given = {word: value if isinstance(value, str) else str(exact_rational(value, word))
             for word, value in (state or {}).items()}  # fmt: skip
    twice = next((word for word in table_rows.components if word in given), None)
    if twice is not None:
        raise ValueError(f"{twice}: the table has a column {twice}, and the state gives it too")
    surface = None if surface_velocity is None else str(exact_rational(surface_velocity, "surface_velocity"))
    question = _Question(mechanism, table_rows.parameters, tuple(given.items()), surface, digits)
    return answered_rows(rows, _PORTION, partial(_examined, question), executor, progress)


def _part(rows: Iterator[ParameterRow], first: int, last: int | None) -> Iterator[ParameterRow]:
    """The rows from the first to the last one.

    :raises ValueError: there is no such part.
    """
    if not (type(first) is int and type(last) in (int, type(None)) and first >= 1 and (last is None or first <= last)):
        raise ValueError(f"rows: expected two numbers 1 <= first <= last, got {first} and {last}")
    part = islice(rows, first - 1, last)
    begin = next(part, None)
    if begin is None:
        raise ValueError(f"rows: the table has no row {first}")
    return chain([begin], part)


def _examined(question: _Question, rows: list[ParameterRow]) -> _Answer:
    """Each row begins with the precision that was enough for the one before it in its portion, or the second one."""
    done: list[ApproachedRow] = []
    first = 0
    for row in rows:
        answer, bits = _row(question, row, question.precisions[first:])
        first = first if bits is None else min(question.precisions.index(bits), 1)
        done.append(answer)
    return _Answer(done)


def _row(question: _Question, row: ParameterRow, precisions: Sequence[int]) -> tuple[ApproachedRow, int | None]:
    """The answer, and with how many bits; None: nothing was followed."""
    if row.values is None:
        return _refused(question, row, row.wrong), None
    try:
        mechanism = question.mechanism.with_parameters(**dict(zip(question.parameters, row.values, strict=True)))
        found = _followed(question, mechanism, dict(question.state + row.state), precisions)
    except MechanismError as error:
        return _refused(question, row, str(error)), None
    slip = found.approach
    at_spot = slip.end == "G-spot"
    digits = None if slip.coefficient is None else _digits(slip.coefficient)
    few = at_spot and (digits or 0) < (question.digits or 0)
    settled = slip.exit_code == 0 and not few
    open_side = slip.side_reason if at_spot and slip.side is None else slip.verdict.detail
    reason = f"C1 has {digits or 0} digits, {question.digits} were asked for" if slip.exit_code == 0 else open_side
    answer = ApproachedRow(
        number=row.number,
        given=row.given,
        outcome="settled" if settled else "undecided",
        end=slip.end,
        case=slip.case,
        side=slip.side,
        small_epsilon_side=found.side,
        reason="" if settled else reason,
        small_epsilon_reason=found.verdict.detail if at_spot and found.side is None else "",
        warnings=slip.warnings,
        numbers=_numbers(slip),
        point=_point(mechanism, slip),
        digits=digits,
    )
    return answer, slip.bits


def _followed(question: _Question, mechanism: Mechanism, state: StateInput, precisions: Sequence[int]) -> MechanismSide:
    """By the functions that all rows share; where these leave something open, by those of the row alone."""

    def by(shifted: Shifted) -> MechanismSide:
        return side_from(
            shifted,
            state,
            surface_velocity=question.surface,
            precisions=precisions,
            coefficient_bits=question.bits,
        )

    shared = _with_numbers(question.mechanism, question.parameters, mechanism)
    if shared is not None:
        found = by(shared)
        slip = found.approach
        enough = slip.coefficient is None or not question.bits or relative_bits(slip.coefficient) >= question.bits
        if slip.exit_code == 0 and enough and (found.side is not None or found.verdict.reason is Reason.BEYOND):
            return found
    return by(_shifted(mechanism))


@lru_cache(1)
def _with_numbers(whole: Mechanism, parameters: tuple[str, ...], mechanism: Mechanism) -> Shifted | None:
    """The functions that all rows share, with the numbers of one; None: there are none.

    :raises MechanismError: it cannot be.
    """
    shared = _shared(whole, parameters) if parameters else None
    if shared is None:
        return None
    refuse_impossible(mechanism)
    return with_numbers(shared, mechanism)


_shared = lru_cache(1)(shared_derivation)


def _digits(coefficient: arb) -> int:
    """How many of its decimal digits are certain, as far as doubles hold them."""
    certain = relative_bits(coefficient)
    return next((k for k in range(_MOST_DIGITS, 0, -1) if bits_for_digits(k) <= certain), 0)


@lru_cache(1)
def _shifted(mechanism: Mechanism) -> Shifted:
    """Derived once for rows with the same parameters.

    :raises MechanismError: it cannot be.
    """
    refuse_impossible(mechanism)
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
