"""A measurement as a file: written whole, read with every part checked; its parts, as they are finished."""

from __future__ import annotations

import json
import os
import re
import sys
import types
from dataclasses import asdict, fields, is_dataclass
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Any, get_args, get_origin, get_type_hints

from gspot_verified.cost.measurement.measurement import KINDS, Measurement, Part
from gspot_verified.work.journal_file import JournalFile


class KeptParts:
    """The parts in a file: of one size, on one machine, by one state of the sources and of the programs beside them.

    :raises ValueError: the file belongs to another run, or a part in it is damaged.
    :raises OSError: the file cannot be opened.
    """

    def __init__(self, path: Path, question: dict[str, Any]) -> None:
        self._journal = JournalFile(path, question)
        self._parts: dict[str, Part] = {}
        for number, line in enumerate(self._journal.lines, 2):
            try:
                part = part_of(json.loads(line))
            except ValueError as error:
                raise ValueError(f"{path}: line {number}: {error}; remove it and those after it") from None
            self._parts[part.key] = part

    def find(self, key: str) -> Part | None:
        """The part, if it was finished before."""
        return self._parts.get(key)

    def keep(self, part: Part) -> None:
        """Add a part; it is in the file when this returns."""
        self._journal.add(asdict(part))
        self._parts[part.key] = part

    def remove(self) -> None:
        """Remove the file: the whole measurement is written."""
        self._journal.path.unlink(missing_ok=True)
        self._journal.close()


SCHEMA = "gspot-verified/cost/2"
"""Also the schema of ``gspot-verified cost --json``."""
_MAX_BYTES = 20_000_000  # far more than a measurement: a limit against hostile input
_KEY = re.compile(r"[a-z][a-z-]{0,40}")
_NO_TEXT = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f\ud800-\udfff\ufffe\uffff]")
_FAR = 1e15  # of a place or a number of seconds, and the inverse of the least: a limit against hostile input
_LARGEST = 2**63  # of a number of bytes or repeats: a limit against hostile input
_WIDTH = 160  # of a line, as a rule
_DATE = re.compile(r"\d{4}-\d{2}-\d{2}")


def written(measurement: Measurement) -> str:
    """The text of the file: a point stands in one line."""
    return _laid_out({**measurement.to_json(), "schema": SCHEMA}) + "\n"


def _laid_out(data: Any, front: str = "\n") -> str:
    line = json.dumps(data, sort_keys=True, ensure_ascii=False, allow_nan=False)
    if len(front) + len(line) <= _WIDTH or not data or not isinstance(data, list | dict):
        return line
    pairs = isinstance(data, dict)
    rows = [(f"{json.dumps(key)}: ", data[key]) for key in sorted(data)] if pairs else [("", each) for each in data]
    inner = ",".join(f"{front} {key}{_laid_out(each, front + ' ')}" for key, each in rows)
    return f"{{{inner}{front}}}" if pairs else f"[{inner}{front}]"


def save(measurement: Measurement, path: Path) -> None:
    """Write the file; a file that is there is replaced when the new one is whole.

    :raises OSError: it cannot be written.
    """
    draft = path.with_name(path.name + ".part")
    try:
        with draft.open("w", encoding="utf-8") as file:
            file.write(written(measurement))
            file.flush()
            os.fsync(file.fileno())
        draft.replace(path)
    finally:
        draft.unlink(missing_ok=True)


def load(path: Path) -> Measurement:
    """The measurement of a file.

    :raises ValueError: no measurement of this schema; the message names the file and the place in it.
    :raises OSError: the file cannot be read.
    """
    if path.stat().st_size > _MAX_BYTES:
        raise ValueError(f"{path}: larger than {_MAX_BYTES} bytes, so it is not a measurement")
    try:
        return parsed(path.read_text(encoding="utf-8"))
    except UnicodeDecodeError:
        raise ValueError(f"{path}: not UTF-8 text") from None
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from error


def recorded() -> Measurement:
    """The measurement that comes with the package."""
    text = resources.files("gspot_verified.cost.measurement").joinpath("recorded.json").read_text(encoding="utf-8")
    return parsed(text)


def parsed(text: str) -> Measurement:
    """The measurement of a text.

    :raises ValueError: not JSON, another schema, a part missing, of another type or out of range.

    >>> parsed('{"schema": "other"}')
    Traceback (most recent call last):
    ...
    ValueError: schema: expected 'gspot-verified/cost/2', got 'other'
    """
    try:
        data = json.loads(text, parse_constant=_no_constant)
    except RecursionError:
        raise ValueError("nested too deeply") from None
    if not isinstance(data, dict):
        raise ValueError("expected an object")
    if data.get("schema") != SCHEMA:
        raise ValueError(f"schema: expected {SCHEMA!r}, got {data.get('schema')!r}")
    data.pop("schema")
    if isinstance(data.get("versions"), dict):
        data["versions"] = [list(pair) for pair in sorted(data["versions"].items())]
    measurement: Measurement = _object(Measurement, data, "measurement")
    _check(measurement)
    return measurement


def part_of(data: object) -> Part:
    """One part from its plain data.

    :raises ValueError: it is not of that form, or out of range; the message names the place.
    """
    part: Part = _object(Part, data, "part")
    _check_part(part)
    return part


def _no_constant(name: str) -> float:
    raise ValueError(f"{name} is not a number")


def _check(measurement: Measurement) -> None:
    if not _DATE.fullmatch(measurement.date):
        raise ValueError(f"measurement.date: expected YYYY-MM-DD, got {measurement.date!r}")
    keys = [part.key for part in measurement.parts]
    if len(set(keys)) != len(keys) or not all(map(_KEY.fullmatch, keys)):
        raise ValueError(f"parts: expected different keys of small letters and -, got {keys}")
    for part in measurement.parts:
        _check_part(part)


def _check_part(part: Part) -> None:
    if any(not 0 <= share.part <= 1 for share in part.shares):
        raise ValueError(f"{part.key}: a share is not in 0..1")
    if part.limit is not None and not (part.limit.seconds > 0 and part.limit.took > 0):
        raise ValueError(f"{part.key}: the limit is not positive")
    if not all(1 / _FAR <= seconds <= _FAR for _, seconds in part.targets):
        raise ValueError(f"{part.key}: a target is not positive, or out of range")
    for route in part.routes:
        if route.kind not in KINDS:
            raise ValueError(f"{part.key}: {route.name}: expected one of {', '.join(KINDS)}, got {route.kind!r}")
        for point in route.points:
            in_range = all(1 / _FAR <= x <= _FAR for x in (point.place, point.best, point.median))
            if not (in_range and point.best <= point.median and point.repeats > 0):
                raise ValueError(f"{part.key}: {route.name}: {point} is no measurement")


@cache
def _hints(kind: type) -> dict[str, Any]:
    return get_type_hints(kind)


def _object(kind: Any, data: object, where: str) -> Any:
    if not isinstance(data, dict):
        raise ValueError(f"{where}: expected an object, got {type(data).__name__}")
    names = [field.name for field in fields(kind)]
    if sorted(data) != sorted(names):
        raise ValueError(
            f"{where}: expected the keys {', '.join(sorted(names))}, got {', '.join(sorted(map(str, data)))}"
        )
    return kind(**{name: _value(_hints(kind)[name], data[name], f"{where}.{name}") for name in names})


def _value(kind: Any, data: object, where: str) -> Any:
    if is_dataclass(kind):
        return _object(kind, data, where)
    if isinstance(kind, types.UnionType):
        [other] = [part for part in get_args(kind) if part is not type(None)]
        return None if data is None else _value(other, data, where)
    if get_origin(kind) is tuple:
        return _sequence(get_args(kind), data, where)
    if kind is float and isinstance(data, int | float) and not isinstance(data, bool):
        if not abs(data) <= sys.float_info.max:  # exact for integers of any length, too
            raise ValueError(f"{where}: not finite")
        return float(data)
    if type(data) is not kind:
        raise ValueError(f"{where}: expected {kind.__name__}, got {data!r:.60}")
    if isinstance(data, str) and _NO_TEXT.search(data):
        raise ValueError(f"{where}: no text: it holds a character that no page can show")
    if kind is int and not 0 <= data <= _LARGEST:  # type: ignore[operator]
        raise ValueError(f"{where}: out of range")
    return data


def _sequence(kinds: tuple[Any, ...], data: object, where: str) -> tuple[Any, ...]:
    if not isinstance(data, list):
        raise ValueError(f"{where}: expected a list, got {type(data).__name__}")
    if kinds[-1] is Ellipsis:
        kinds = (kinds[0],) * len(data)
    if len(kinds) != len(data):
        raise ValueError(f"{where}: expected {len(kinds)} entries, got {len(data)}")
    return tuple(_value(kind, entry, f"{where}[{i}]") for i, (kind, entry) in enumerate(zip(kinds, data, strict=True)))
