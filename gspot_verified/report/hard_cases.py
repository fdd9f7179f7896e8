"""The hard cases as the report holds them: plain data, and the check that a file has their form."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from typing import Any

from gspot_verified.hard_cases.catalogue import Family, families, measured

NONE: dict[str, Any] = {"families": [], "summary": {"rows": 0, "decided": 0, "double_right": 0, "double_wrong": 0}}
"""A report without them."""

_TEXTS = ("name", "part", "title", "variable", "formula", "why", "instead", "work")
_ROW_TEXTS = ("asked", "double", "certified")
_NUMBERS = ("condition", "bits_lost")


def measurements() -> dict[str, Callable[[], dict[str, Any]]]:
    """What measures each family of the catalogue, in its order: together about ten seconds of processor time."""
    return {f"hard cases: {family.title}": partial(_measured, family) for family in families()}


def hard_cases(plain: Iterable[dict[str, Any]]) -> dict[str, Any]:
    """The families that were measured, as the report holds them."""
    kept = list(plain)
    return {"families": kept, "summary": _summary([row for family in kept for row in family["rows"]])}


def _measured(family: Family) -> dict[str, Any]:
    return measured(family).to_json()


def _summary(rows: Sequence[Mapping[str, Any]]) -> dict[str, int]:
    return {
        "rows": len(rows),
        "decided": sum(row["decided"] for row in rows),
        "double_right": sum(row["double_right"] is True for row in rows),
        "double_wrong": sum(row["double_right"] is False for row in rows),
    }


def check_hard_cases(value: object) -> None:
    """That it has the form that the page shows, and counts that agree with the rows.

    :raises ValueError: it has not.

    >>> check_hard_cases(NONE)
    """
    holder = _mapping(value, "hard_cases")
    families = _sequence(holder.get("families"), "hard_cases.families")
    rows = [row for number, family in enumerate(families) for row in _rows(family, f"hard_cases.families[{number}]")]
    summary = _summary(rows)
    if holder.get("summary") != summary:
        raise ValueError(f"hard_cases.summary: the file says {holder.get('summary')}, its rows give {summary}")


def _rows(value: object, where: str) -> list[Mapping[str, Any]]:
    family = _mapping(value, where)
    for key in _TEXTS:
        if not isinstance(family.get(key), str):
            raise ValueError(f"{where}: expected text under {key!r}")
    growth = _mapping(family.get("growth"), f"{where}.growth")
    if any(not _is_number(growth.get(key, "missing")) for key in ("work", "seconds")):
        raise ValueError(f"{where}.growth: expected numbers or null")
    rows = _sequence(family.get("rows"), f"{where}.rows")
    if not rows:
        raise ValueError(f"{where}.rows: expected one row at least")
    return [_row(row, f"{where}.rows[{number}]") for number, row in enumerate(rows)]


def _row(value: object, where: str) -> Mapping[str, Any]:
    row = _mapping(value, where)
    for key in _ROW_TEXTS:
        if not isinstance(row.get(key), str):
            raise ValueError(f"{where}: expected text under {key!r}")
    if any(type(row.get(key)) is not int for key in ("level", "work")) or not isinstance(row.get("decided"), bool):
        raise ValueError(f"{where}: expected integers for level and work, and whether it is decided")
    if type(row.get("seconds")) not in (int, float) or any(not _is_number(row.get(key, "")) for key in _NUMBERS):
        raise ValueError(f"{where}: expected a time, and numbers or null for {' and '.join(_NUMBERS)}")
    right = row.get("double_right", "")
    if not (right is None or isinstance(right, bool)) or (right is not None and not row["decided"]):
        raise ValueError(f"{where}.double_right: expected true, false or null; null where the case is undecided")
    return row


def _is_number(value: object) -> bool:
    return value is None or type(value) in (int, float)


def _mapping(value: object, where: str) -> Mapping[str, Any]:
    if not isinstance(value, Mapping):
        raise ValueError(f"{where}: expected an object, got {type(value).__name__}")
    return value


def _sequence(value: object, where: str) -> list[Any]:
    if not isinstance(value, list):
        raise ValueError(f"{where}: expected a list")
    return value
