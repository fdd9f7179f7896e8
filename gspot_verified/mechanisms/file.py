"""Read a mechanism from a TOML file.

A file has these parts (numbers are integers or texts such as "7/3" or "0.1"; a float is refused)::

    format = 1
    name = "falling rod"

    [parameters]                 # in any formula; a value may use other parameters
    m = 1
    mu = "73/36"

    [angles.theta]               # optional: makes theta_ref known by exact rationals, sine^2 + cosine^2 = 1
    sine = "3/5"
    cosine = "4/5"

    [lagrangian]                 # M(q) q'' = f(q, q') + contact forces; velocities are <coordinate>_dot
    coordinates = ["X", "Y", "theta"]
    mass_matrix = [["m", 0, 0], [0, "m", 0], [0, 0, "m*l^2/3"]]
    forces = [0, "-m*g", 0]
    # time = "t"                 # optional: makes time a component of the state

    [contact]
    x = "X + l*cos(theta)"
    y = "Y - l*sin(theta)"
    mu = "mu"

    [g_spot]                     # a value for each component of the state, in parameters and reference angles
    search = false               # true: the values start Newton's method
    # fixed = ["X", "X_dot"]     # optional: m - 4 components that keep their values
    # conditions = ["X"]         # or: m - 4 functions J of the state that vanish

    [g_spot.point]
    X = 0

Instead of ``[lagrangian]`` a file may have ``[fields]`` with ``state``, ``F``, ``G_T``, ``G_N``. Formulas are read by
:mod:`gspot_verified.mechanisms.formula`: they can run no code.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from gspot_verified.mechanisms.given import from_fields, lagrangian
from gspot_verified.mechanisms.mechanism import Mechanism, MechanismError

MAX_BYTES = 200_000
_FORMULA = 'a formula: a text or an integer (write 0.1 as "0.1")'


def read_mechanism(path: str | Path) -> Mechanism:
    """The mechanism that a TOML file describes.

    :raises MechanismError: the file cannot be read, or a part is missing or wrong; the message names the key.
    """
    try:
        with Path(path).open("rb") as stream:
            data = stream.read(MAX_BYTES + 1)
    except OSError as error:
        raise MechanismError(f"{path}: cannot be read: {error.strerror or error}") from None
    if len(data) > MAX_BYTES:
        raise MechanismError(f"{path}: larger than {MAX_BYTES} bytes")
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError:
        raise MechanismError(f"{path}: not UTF-8 text") from None
    try:
        return parse_mechanism(text)
    except MechanismError as error:
        raise MechanismError(f"{path}: {error}") from None


def parse_mechanism(text: str) -> Mechanism:
    """The mechanism that a TOML text describes.

    :raises MechanismError: a part is missing or wrong; the message names the key.

    >>> parse_mechanism("format = 1")
    Traceback (most recent call last):
    ...
    gspot_verified.mechanisms.mechanism.MechanismError: key "name" is missing
    """
    if len(text) > MAX_BYTES:
        raise MechanismError(f"the text is longer than {MAX_BYTES} characters")
    try:
        table = tomllib.loads(text)
    except (ValueError, RecursionError) as error:
        raise MechanismError(f"no TOML: {str(error)[:200] or 'nested too deeply'}") from None
    return _mechanism(_Table(table, ""))


class _Table:
    """A TOML table that knows where it stands, and says it in every error."""

    def __init__(self, data: Mapping[str, Any], where: str) -> None:
        self._data, self._where = data, where

    def key(self, name: str) -> str:
        return f"{self._where}.{name}" if self._where else name

    def only(self, *names: str) -> None:
        for name in self._data:
            if name not in names:
                raise MechanismError(f'unknown key "{self.key(name[:60])}"; known here: {", ".join(names)}')

    def has(self, name: str) -> bool:
        return name in self._data

    def get(self, name: str, kind: type, what: str) -> Any:
        if name not in self._data:
            raise MechanismError(f'key "{self.key(name)}" is missing')
        value = self._data[name]
        if not isinstance(value, kind) or (isinstance(value, bool) and kind is not bool):
            raise MechanismError(f'key "{self.key(name)}" must be {what}, got {_shown(value)}')
        return value

    def text(self, name: str) -> str:
        found: str = self.get(name, str, "a text")
        return found

    def table(self, name: str) -> _Table:
        return _Table(self.get(name, dict, "a table") if name in self._data else {}, self.key(name))

    def words(self, name: str) -> list[str]:
        found = self.get(name, list, "a list of names")
        for item in found:
            if not isinstance(item, str):
                raise MechanismError(f'key "{self.key(name)}" must be a list of names, got {_shown(item)} in it')
        return list(found)

    def formula(self, name: str) -> str | int:
        if name not in self._data:
            raise MechanismError(f'key "{self.key(name)}" is missing')
        return _formula(self._data[name], self.key(name))

    def formulas(self, name: str) -> list[str | int]:
        return [_formula(value, self.key(name)) for value in self.get(name, list, "a list of formulas")]

    def all_formulas(self) -> dict[str, str | int]:
        return {name: self.formula(name) for name in self._data}

    def names(self) -> list[str]:
        return list(self._data)


def _formula(value: Any, key: str) -> str | int:
    if isinstance(value, bool) or not isinstance(value, str | int):
        raise MechanismError(f'key "{key}" must be {_FORMULA}, got {_shown(value)}')
    return value


def _shown(value: Any) -> str:
    text = repr(value)
    return f"{type(value).__name__} {text if len(text) <= 40 else text[:37] + '...'}"


def _mechanism(top: _Table) -> Mechanism:
    top.only("format", "name", "parameters", "angles", "lagrangian", "fields", "contact", "g_spot", "note")
    name = top.text("name")
    if not name.strip() or not name.isprintable():
        raise MechanismError('key "name" must be one line of visible text')
    if top.get("format", int, "1") != 1:
        raise MechanismError('key "format" must be 1')
    if top.has("note"):
        top.text("note")
    contact = top.table("contact")
    contact.only("x", "y", "mu")
    spot = top.table("g_spot")
    spot.only("search", "fixed", "conditions", "point")
    common: dict[str, Any] = {
        "name": name[:80],
        "x": contact.formula("x"),
        "y": contact.formula("y"),
        "mu": contact.formula("mu"),
        "parameters": top.table("parameters").all_formulas(),
        "angles": _angles(top.table("angles")),
        "place": spot.table("point").all_formulas(),
        "search": spot.get("search", bool, "true or false") if spot.has("search") else False,
    }
    if spot.has("fixed") and spot.has("conditions"):
        raise MechanismError('table "g_spot": fixed or conditions, not both')
    if spot.has("fixed"):
        common["fixed"] = spot.words("fixed")
    if spot.has("conditions"):
        common["conditions"] = spot.formulas("conditions")
    if top.has("lagrangian") == top.has("fields"):
        raise MechanismError('exactly one of the tables "lagrangian" and "fields" is needed')
    if top.has("fields"):
        return _by_fields(top.table("fields"), common)
    return _by_lagrangian(top.table("lagrangian"), common)


def _angles(table: _Table) -> dict[str, tuple[Any, Any]]:
    found = {}
    for name in table.names():
        angle = table.table(name)
        angle.only("sine", "cosine")
        found[name] = (angle.formula("sine"), angle.formula("cosine"))
    return found


def _by_fields(table: _Table, common: dict[str, Any]) -> Mechanism:
    table.only("state", "F", "G_T", "G_N")
    return from_fields(
        state=table.words("state"),
        F=table.formulas("F"),
        G_T=table.formulas("G_T"),
        G_N=table.formulas("G_N"),
        **common,
    )


def _by_lagrangian(table: _Table, common: dict[str, Any]) -> Mechanism:
    table.only("coordinates", "mass_matrix", "forces", "time")
    rows = table.get("mass_matrix", list, "a list of rows")
    for row in rows:
        if not isinstance(row, list):
            raise MechanismError(f'key "{table.key("mass_matrix")}" must be a list of rows, got {_shown(row)} in it')
    matrix = [[_formula(entry, table.key("mass_matrix")) for entry in row] for row in rows]
    return lagrangian(
        coordinates=table.words("coordinates"),
        mass_matrix=matrix,
        forces=table.formulas("forces"),
        time=table.text("time") if table.has("time") else None,
        **common,
    )
