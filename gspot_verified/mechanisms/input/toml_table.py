"""TOML tables that know where they stand: every error names the key; numbers with a point are exact."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from gspot_verified.mechanisms.formulas.names import nearest
from gspot_verified.mechanisms.input.mechanism import MechanismError

MAX_DIGITS = 100  # characters of a decimal number, with its exponent
MAX_EXPONENT = 100  # of ten: 1e999999999 would fill the memory
Number = str | int | Fraction
_FORMULA = 'a formula: a text or a number (a text for a fraction: "1/3")'
_EXPONENT = re.compile(r"[^eE]*[0-9](?:[eE]([+-]?[0-9_]+))?")


class Decimal(str):
    """A number with a point or an exponent, as the file has it."""


def toml_table(text: str) -> TomlTable:
    """The whole of a TOML text as a table.

    :raises MechanismError: it is no TOML.

    >>> toml_table("half = 0.5").formula("half")
    Fraction(1, 2)
    """
    try:
        table = tomllib.loads(text.removeprefix("\N{BYTE ORDER MARK}"), parse_float=Decimal)
    except (ValueError, RecursionError) as error:
        raise MechanismError(f"no TOML: {str(error)[:200] or 'nested too deeply'}") from None
    return TomlTable(table, "")


class TomlTable:
    """A TOML table that knows where it stands, and says it in every error."""

    def __init__(self, data: Mapping[str, Any], where: str) -> None:
        self._data, self._where = data, where

    def key(self, name: str) -> str:
        """The full name of a key of this table."""
        return f"{self._where}.{name}" if self._where else name

    def only(self, keys: Mapping[str, Sequence[str]], kind: str | None = None) -> None:
        """Refuses keys that this table does not have; ``kind`` is its name in ``keys`` where a file chooses its own."""
        names = keys[self._where if kind is None else kind]
        for name in self._data:
            if name not in names:
                raise MechanismError(
                    f'unknown key "{self.key(name[:60])}"{nearest(name, names)}; known here: {", ".join(names)}'
                )

    def has(self, name: str) -> bool:
        """Whether the key is there."""
        return name in self._data

    def is_text(self, name: str) -> bool:
        """Whether the key is there and a text."""
        return isinstance(self._data.get(name), str) and not isinstance(self._data[name], Decimal)

    def get(self, name: str, kind: type, what: str) -> Any:
        """The value of a key that must be there and of this kind."""
        if name not in self._data:
            raise MechanismError(f'key "{self.key(name)}" is missing')
        value = self._data[name]
        wrong = (isinstance(value, bool) and kind is not bool) or isinstance(value, Decimal)
        if not isinstance(value, kind) or wrong:
            raise MechanismError(f'key "{self.key(name)}" must be {what}, got {shown_value(value)}')
        return value

    def text(self, name: str) -> str:
        """A text."""
        text: str = self.get(name, str, "a text")
        return text

    def table(self, name: str) -> TomlTable:
        """A table; empty if it is missing."""
        return TomlTable(self.get(name, dict, "a table") if name in self._data else {}, self.key(name))

    def words(self, name: str) -> list[str]:
        """A list of names."""
        words = self.get(name, list, "a list of names")
        for item in words:
            if not isinstance(item, str) or isinstance(item, Decimal):
                raise MechanismError(f'key "{self.key(name)}" must be a list of names, got {shown_value(item)} in it')
        return list(words)

    def formula(self, name: str) -> Number:
        """A formula."""
        if name not in self._data:
            raise MechanismError(f'key "{self.key(name)}" is missing')
        return formula_value(self._data[name], self.key(name))

    def formulas(self, name: str) -> list[Number]:
        """A list of formulas."""
        return [formula_value(value, self.key(name)) for value in self.get(name, list, "a list of formulas")]

    def nested_formulas(self, name: str, depth: int) -> list[Any]:
        """A list of formulas and of further lists of them, ``depth`` lists within each other at most."""
        return _nested(self.get(name, list, "a list"), self.key(name), depth)

    def all_formulas(self) -> dict[str, Number]:
        """All keys, each a formula."""
        return {name: self.formula(name) for name in self._data}

    def names(self) -> list[str]:
        """The keys."""
        return list(self._data)


def formula_value(value: Any, key: str) -> Number:
    """A formula as it was given; a decimal as the rational number that it is."""
    if isinstance(value, Decimal):
        return _exact(value, key)
    if isinstance(value, bool) or not isinstance(value, str | int):
        raise MechanismError(f'key "{key}" must be {_FORMULA}, got {shown_value(value)}')
    return value


def _nested(values: list[Any], key: str, depth: int) -> list[Any]:
    return [
        _nested(value, key, depth - 1) if isinstance(value, list) and depth > 1 else formula_value(value, key)
        for value in values
    ]


def _exact(value: str, key: str) -> Fraction:
    match = _EXPONENT.fullmatch(value)
    if match is None:
        raise MechanismError(f'key "{key}" must be {_FORMULA}, got {shown_value(Decimal(value))}')
    exponent = match[1] or "0"
    if len(value) > MAX_DIGITS or len(exponent) > 6 or abs(int(exponent)) > MAX_EXPONENT:
        raise MechanismError(
            f'key "{key}": a number may have at most {MAX_DIGITS} digits and an exponent of {MAX_EXPONENT}, '
            f"got {shown_value(Decimal(value))}"
        )
    return Fraction(value)


def shown_value(value: Any) -> str:
    """The type and the value, for a message."""
    kind, text = ("float", str(value)) if isinstance(value, Decimal) else (type(value).__name__, repr(value))
    return f"{kind} {text if len(text) <= 40 else text[:37] + '...'}"
