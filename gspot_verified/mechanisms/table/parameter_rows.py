"""Rows of parameter values: from a CSV file, or from mappings; what is wrong in one row is said of that row."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Iterator, Mapping, Sequence
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
    """One row: its number from 1, the values as they were given, and as exact numbers; or what is wrong with it."""

    number: int
    given: tuple[tuple[str, str], ...]
    values: tuple[fmpq, ...] | None
    wrong: str = ""


@dataclass(frozen=True)
class ParameterRows:
    """The rows of a table, to be gone through once; ``parameters`` are its columns."""

    parameters: tuple[str, ...]
    rows: Iterator[ParameterRow]


def parameter_rows(mechanism: Mechanism, table: str | Path | Iterable[Row]) -> ParameterRows:
    """The rows of a CSV file whose first line names the parameters, or of mappings, the first of which names them.

    :raises MechanismError: no row, a column that is no parameter of the mechanism, or one that is there twice.
    :raises OSError: the file cannot be read.
    """
    if isinstance(table, str | Path):
        lines = _lines(Path(table))
        parameters = _checked(mechanism, next(lines, []), str(table))
        rows = _of_lines(parameters, lines)
    else:
        mappings = iter(table)
        first = next(mappings, None)
        parameters = _checked(mechanism, list(first or ()), "the table")
        rows = _of_mappings(parameters, mappings if first is None else chain([first], mappings))
    first_row = next(rows, None)
    if first_row is None:
        raise MechanismError("the table has no row")
    return ParameterRows(parameters, chain([first_row], rows))


def _lines(path: Path) -> Iterator[list[str]]:
    with path.open(encoding="utf-8-sig", newline="") as file:
        try:
            yield from csv.reader(file, strict=True)
        except (csv.Error, UnicodeDecodeError) as error:
            raise MechanismError(f"{path} is no CSV file: {error}") from None


def _checked(mechanism: Mechanism, header: Sequence[str], where: str) -> tuple[str, ...]:
    names = tuple(name.strip() for name in header)
    known = dict(mechanism.parameters)
    if not any(names):
        raise MechanismError(f"{where}: the first line must name parameters of {mechanism.name}: {', '.join(known)}")
    for k, name in enumerate(names):
        if name not in known:
            raise MechanismError(
                f"{where}: column {k + 1}: {mechanism.name} has no parameter {name[:60]!r}{nearest(name, known)}; "
                f"it has: {', '.join(known) or 'none'}"
            )
        if name in names[:k]:
            raise MechanismError(f"{where}: column {k + 1}: {name} is there twice")
    return names


def _of_lines(parameters: Sequence[str], lines: Iterator[list[str]]) -> Iterator[ParameterRow]:
    for number, fields in enumerate((line for line in lines if line), 1):
        if len(fields) == len(parameters):
            yield _read(number, parameters, fields)
        else:
            wrong = f"{counted(len(fields), 'value')}, {len(parameters)} are needed: {', '.join(parameters)}"
            yield ParameterRow(
                number, tuple(zip_longest(parameters, fields[: len(parameters)], fillvalue="")), None, wrong
            )


def _of_mappings(parameters: Sequence[str], mappings: Iterable[Row]) -> Iterator[ParameterRow]:
    for number, given in enumerate(mappings, 1):
        if set(given) == set(parameters):
            yield _read(number, parameters, [given[name] for name in parameters])
        else:
            wrong = f"values of {', '.join(given) or 'nothing'}; those of {', '.join(parameters)} are needed"
            yield ParameterRow(number, tuple((name, str(given.get(name, ""))) for name in parameters), None, wrong)


def _read(number: int, parameters: Sequence[str], fields: Sequence[ExactInput]) -> ParameterRow:
    given = tuple((name, str(field).strip()) for name, field in zip(parameters, fields, strict=True))
    try:
        values = tuple(exact_rational(field, name) for name, field in zip(parameters, fields, strict=True))
    except MechanismError as error:
        return ParameterRow(number, given, None, str(error))
    return ParameterRow(number, given, values)
