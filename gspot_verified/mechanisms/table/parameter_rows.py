"""Rows of parameter values: from a CSV file, or from mappings; what is wrong in one row is said of that row."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass
from itertools import chain, zip_longest
from pathlib import Path

from flint import fmpq

from gspot_verified.mechanisms.formulas.names import nearest
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError, exact_rational
from gspot_verified.numbers.balls import ExactInput
from gspot_verified.numbers.counted import counted

Row = Mapping[str, ExactInput]


@dataclass(frozen=True, slots=True)
class ParameterRow:
    """One row: its number from 1, the values as they were given, and as exact numbers; or what is wrong with it.

    ``state``: the components of the state that it gives, as texts; ``values`` are those of the parameters.
    """

    number: int
    given: tuple[tuple[str, str], ...]
    values: tuple[fmpq, ...] | None
    wrong: str = ""
    state: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True)
class ParameterRows:
    """The rows of a table, to be gone through once; its columns are ``parameters`` and ``components`` of the state."""

    parameters: tuple[str, ...]
    rows: Iterator[ParameterRow]
    components: tuple[str, ...] = ()

    @property
    def names(self) -> tuple[str, ...]:
        """Of all columns."""
        return *self.parameters, *self.components


def parameter_rows(mechanism: Mechanism, table: str | Path | Iterable[Row], with_state: bool = False) -> ParameterRows:
    """The rows of a CSV file whose first line names the parameters, or of mappings, the first of which names them.

    ``with_state``: components of the state may stand there too.

    :raises MechanismError: no row, a column that is no parameter of the mechanism, or one that is there twice.
    :raises OSError: the file cannot be read.
    """
    state = frozenset(mechanism.state)
    if isinstance(table, str | Path):
        lines = _lines(Path(table))
        names = _checked(mechanism, next(lines, []), str(table), with_state)
        rows = _of_lines(names, state, lines)
    else:
        mappings = iter(table)
        first = next(mappings, None)
        names = _checked(mechanism, list(first or ()), "the table", with_state)
        rows = _of_mappings(names, state, mappings if first is None else chain([first], mappings))
    first_row = next(rows, None)
    if first_row is None:
        raise MechanismError("the table has no row")
    parameters = tuple(name for name in names if name not in state)
    return ParameterRows(parameters, chain([first_row], rows), tuple(name for name in names if name in state))


def _lines(path: Path) -> Iterator[list[str]]:
    with path.open(encoding="utf-8-sig", newline="") as file:
        try:
            yield from csv.reader(file, strict=True)
        except (csv.Error, UnicodeDecodeError) as error:
            raise MechanismError(f"{path} is no CSV file: {error}") from None


def _checked(mechanism: Mechanism, header: Sequence[str], where: str, with_state: bool) -> tuple[str, ...]:
    names = tuple(name.strip() for name in header)
    known = [*dict(mechanism.parameters), *(mechanism.state if with_state else ())]
    what, all_of_them = (
        ("parameter or component", "parameters or components") if with_state else ("parameter", "parameters")
    )
    if not any(names):
        raise MechanismError(f"{where}: the first line must name {all_of_them} of {mechanism.name}: {', '.join(known)}")
    for k, name in enumerate(names):
        if name not in known:
            raise MechanismError(
                f"{where}: column {k + 1}: {mechanism.name} has no {what} {name[:60]!r}{nearest(name, known)}; "
                f"it has: {', '.join(known) or 'none'}"
            )
        if name in names[:k]:
            raise MechanismError(f"{where}: column {k + 1}: {name} is there twice")
    return names


def _of_lines(names: Sequence[str], state: Set[str], lines: Iterator[list[str]]) -> Iterator[ParameterRow]:
    for number, fields in enumerate((line for line in lines if line), 1):
        if len(fields) == len(names):
            yield _read(number, names, state, fields)
        else:
            wrong = f"{counted(len(fields), 'value')}, {len(names)} are needed: {', '.join(names)}"
            yield ParameterRow(number, tuple(zip_longest(names, fields[: len(names)], fillvalue="")), None, wrong)


def _of_mappings(names: Sequence[str], state: Set[str], mappings: Iterable[Row]) -> Iterator[ParameterRow]:
    for number, given in enumerate(mappings, 1):
        if set(given) == set(names):
            yield _read(number, names, state, [given[name] for name in names])
        else:
            wrong = f"values of {', '.join(given) or 'nothing'}; those of {', '.join(names)} are needed"
            yield ParameterRow(number, tuple((name, str(given.get(name, ""))) for name in names), None, wrong)


def _read(number: int, names: Sequence[str], state: Set[str], fields: Sequence[ExactInput]) -> ParameterRow:
    given = tuple((name, str(field).strip()) for name, field in zip(names, fields, strict=True))
    start, values = [], []
    try:
        for name, field in zip(names, fields, strict=True):
            if name in state:  # a text may be a formula: it is read with the mechanism of the row
                start.append((name, field.strip() if isinstance(field, str) else str(exact_rational(field, name))))
            else:
                values.append(exact_rational(field, name))
    except MechanismError as error:
        return ParameterRow(number, given, None, str(error))
    return ParameterRow(number, given, tuple(values), "", tuple(start))
