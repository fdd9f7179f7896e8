"""How results are written as plain data (JSON), and the schema of that, both read off the type hints.

One :class:`Form` for each type: an exact rational is its text, a ball its exact interval, a table of pairs an object.
So what is written and the schema of it cannot differ. Beside it how results are shown at a prompt and in a notebook.
"""

from __future__ import annotations

import enum
import html
import json
import sys
import textwrap
import types
import typing
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass
from fractions import Fraction
from functools import cache, cached_property, reduce
from operator import or_
from reprlib import Repr
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Generic, Literal, Union, get_args, get_origin

from gspot_verified.numbers.dyadic import Dyadic

if TYPE_CHECKING:
    from flint import acb, arb


_LONGEST = 300  # characters of a line
_PRE = '<pre style="font-family:monospace">'  # Jupyter would set it in the letters of a text, and columns would shift

_short = Repr()
_short.maxstring = _short.maxother = _short.maxlong = 40  # characters of a value


class Shown:
    """Base of what is shown by a short line, and in a notebook by its text, or a table of its fields.

    The text of ``str``, where a class has one, stays as long as it is.

    >>> from gspot_verified import side
    >>> side(1, 2)
    <SideSwitching: (1, 2): Γ(-β) > 0; Case III, by the paper's rule as ε → 0: C1 < 0 lifts off, C1 > 0 takes an IWC …>
    """

    __slots__ = ()

    def __init_subclass__(cls) -> None:
        """The line of this class stands before ``dataclass`` would write one that holds everything."""
        super().__init_subclass__()
        if "__repr__" not in vars(cls):
            cls.__repr__ = Shown.__repr__  # type: ignore[method-assign]

    def __repr__(self) -> str:
        name = type(self).__name__
        if not _has_text(self):
            return f"{name}({_cut(', '.join(f'{key}={value}' for key, value in _fields(self)))})"
        first, *further = str(self).split("\n", 1)
        return f"<{name}: {_cut(' '.join(first.split()))}{' …' if further else ''}>"

    def _repr_html_(self) -> str | None:
        if _has_text(self):
            return f"{_PRE}{html.escape(str(self))}</pre>"
        rows = (f"<tr><th>{key}</th><td>{html.escape(value)}</td></tr>" for key, value in _fields(self))
        return f"<table><caption>{type(self).__name__}</caption>{''.join(rows)}</table>"


def _has_text(value: Shown) -> bool:
    return type(value).__str__ is not object.__str__


def _fields(value: Shown) -> list[tuple[str, str]]:
    """The names and short texts of the fields, of a dataclass."""
    if not is_dataclass(value):
        return []
    return [(each.name, _short.repr(getattr(value, each.name))) for each in fields(value) if each.repr]


def _cut(line: str) -> str:
    return line if len(line) <= _LONGEST else f"{line[: _LONGEST - 1]}…"


Schema = dict[str, Any]
_NOTES = "__annotations__"
DEFINITIONS: dict[str, Schema] = {
    "rational": {"type": "string", "description": "p or p/q", "pattern": "^-?[0-9]+(/[1-9][0-9]*)?$"},
    "enclosure": {
        "type": "string",
        "description": "0, or [a, b]p e: the closed interval from a 2^e to b 2^e, a and b hexadecimal integers",
        "pattern": r"^(0|\[-?0x[0-9a-f]+, -?0x[0-9a-f]+\]p-?[0-9]+)$",
    },
}
"""The schemas that others refer to by name."""


class ByName(enum.Enum):
    """Base of enumerations whose values are sentences or numbers: written by the name, in small letters."""


PAIRS = "a list of pairs, not an object"
"""``Annotated[tuple[tuple[str, X], ...], PAIRS]``: written as it is."""


class Written(Shown):
    """Base of what is written as plain data: ``written`` names the keys, "key" or "key=attribute"; empty: all fields.

    >>> from gspot_verified.numbers.verdict import Reason, Verdict
    >>> Verdict.written
    'outcome statement witness reason detail remaining'
    >>> Verdict.undecided("x < 1", Reason.BUDGET).to_json()["reason"]
    'budget'
    """

    __slots__ = ()
    written: ClassVar[str] = ""
    definition: ClassVar[str] = ""
    """The name of its schema, where many refer to it."""

    def to_json(self) -> dict[str, Any]:
        """Plain data for ``json.dumps``: exact rationals as text, balls as exact intervals (null: not finite)."""
        kind: Any = type(self)
        data: dict[str, Any] = form(kind).write(self)
        return data


@dataclass(frozen=True, slots=True)
class Form:
    """How the values of one type are written, the schema of what is written, and what such a value is."""

    write: Callable[[Any], Any]
    schema: Schema
    fits: Callable[[Any], bool]


def _instance(*kinds: type) -> Callable[[Any], bool]:
    return lambda value: isinstance(value, kinds)


def _enclosure(value: arb) -> str | None:
    return str(Dyadic.from_ball(value)) if value.is_finite() else None


def _complex_enclosure(value: acb) -> dict[str, str | None] | None:
    return {"real": _enclosure(value.real), "imaginary": _enclosure(value.imag)} if value.is_finite() else None


def _same(value: Any) -> Any:
    return value


_RATIONAL, _ENCLOSURE, _NULL = {"$ref": "#/$defs/rational"}, {"$ref": "#/$defs/enclosure"}, {"type": "null"}
_COMPLEX_ENCLOSURE: Schema = {
    "type": "object",
    "additionalProperties": False,
    "required": ["imaginary", "real"],
    "properties": {"real": _ENCLOSURE, "imaginary": _ENCLOSURE},
}


@cache
def _leaves() -> dict[Any, Form]:
    from flint import acb, arb, fmpq  # here alone: a command that prints no numbers loads no arithmetic

    return {
        type(None): Form(_same, _NULL, _instance(type(None))),
        bool: Form(_same, {"type": "boolean"}, _instance(bool)),
        int: Form(_same, {"type": "integer"}, _instance(int)),
        float: Form(_same, {"type": "number"}, _instance(float, int)),
        str: Form(_same, {"type": "string"}, _instance(str)),
        fmpq: Form(str, _RATIONAL, _instance(fmpq)),
        # By FLINT: CPython refuses to print integers of more than 4,300 digits.
        Fraction: Form(lambda value: str(fmpq(value.numerator, value.denominator)), _RATIONAL, _instance(Fraction)),
        Dyadic: Form(str, _ENCLOSURE, _instance(Dyadic)),
        arb: Form(_enclosure, {"anyOf": [_ENCLOSURE, _NULL]}, _instance(arb)),
        acb: Form(_complex_enclosure, {"anyOf": [_COMPLEX_ENCLOSURE, _NULL]}, _instance(acb)),
        Any: Form(_same, {}, _instance(object)),
    }


@cache
def form(hint: Any) -> Form:
    """The form of a type.

    :raises TypeError: nothing says how it is written.
    """
    if hint in (leaves := _leaves()):
        return leaves[hint]
    origin, arguments = get_origin(hint), get_args(hint)
    if origin is typing.NotRequired:
        return form(arguments[0])
    if origin is Annotated:
        return _annotated(arguments[0], arguments[1])
    if origin is Literal:
        return Form(_same, {"enum": [*arguments]}, arguments.__contains__)
    if origin in (Union, types.UnionType):
        return _union([form(each) for each in arguments])
    if origin is not None and issubclass(origin, Mapping):
        inner = form(arguments[1])
        return _table(inner, dict.items, _instance(origin))
    if origin is not None and issubclass(origin, Sequence):
        return _sequence(origin, arguments)
    if typing.is_typeddict(hint):
        hints = typing.get_type_hints(hint, include_extras=True)
        required = frozenset(key for key, each in hints.items() if get_origin(each) is not typing.NotRequired)
        return _items({key: form(each) for key, each in hints.items()}, required)
    if isinstance(hint, type) and issubclass(hint, enum.Enum):
        words = {each: each.name.lower() if issubclass(hint, ByName) else each.value for each in hint}
        return Form(words.__getitem__, {"enum": [*words.values()]}, _instance(hint))
    if isinstance(hint, type) and issubclass(hint, tuple):
        return _attributes({key: (key, form(_hint(hint, key))) for key in getattr(hint, "_fields", ())}, hint)
    if isinstance(hint, type) and hasattr(hint, "to_json"):
        return _record(hint)
    if isinstance(hint, type) and hint is not object and "__str__" in vars(hint):
        return Form(str, {"type": "string"}, _instance(hint))
    if isinstance(hint, type) and is_dataclass(hint):
        return _record(hint)
    raise TypeError(f"no form of {hint}")


def _annotated(hint: Any, note: object) -> Form:
    """One of some values; pairs as they are; what becomes another type; what a function of it writes."""
    if isinstance(note, tuple):
        return Form(_same, {"enum": [*note]}, note.__contains__)
    if note == PAIRS:
        return _array(form(get_args(hint)[0]), tuple)
    if not callable(note):
        raise TypeError(f"no form of {hint} with the note {note!r}")
    written = form(note if isinstance(note, type) else typing.get_type_hints(note)["return"])
    return Form(lambda value: written.write(note(value)), written.schema, form(hint).fits)


def _union(members: list[Form]) -> Form:
    def write(value: Any) -> Any:
        return next(each for each in members if each.fits(value)).write(value)

    parts = [part for each in members for part in each.schema.get("anyOf", [each.schema])]
    schemas = [part for k, part in enumerate(parts) if part not in parts[:k]]
    schema = {"anyOf": schemas} if len(schemas) > 1 else schemas[0]
    return Form(write, schema, lambda value: any(each.fits(value) for each in members))


def _array(inner: Form, kind: type) -> Form:
    schema = {"type": "array", "items": inner.schema}
    return Form(lambda value: [inner.write(each) for each in value], schema, _instance(kind))


def _sequence(origin: type, arguments: tuple[Any, ...]) -> Form:
    """A list, an object from pairs that begin with a text, or a tuple of fixed length."""
    if len(arguments) == 1 or arguments[1] is Ellipsis:
        pair = get_args(arguments[0])
        if get_origin(arguments[0]) is tuple and len(pair) == 2 and pair[0] is str:
            return _table(form(pair[1]), _same, _instance(origin))
        return _array(form(arguments[0]), origin)
    parts = [form(each) for each in arguments]
    schema = {"type": "array", "prefixItems": [part.schema for part in parts], "minItems": len(parts), "items": False}

    def write(value: Any) -> list[Any]:
        return [part.write(each) for part, each in zip(parts, value, strict=True)]

    return Form(write, schema, _instance(origin))


def _table(inner: Form, items: Callable[[Any], Any], fits: Callable[[Any], bool]) -> Form:
    schema = {"type": "object", "additionalProperties": inner.schema}
    return Form(lambda value: {key: inner.write(each) for key, each in items(value)}, schema, fits)


def _object_schema(keys: Mapping[str, Form], required: typing.Collection[str]) -> Schema:
    properties = {key: each.schema for key, each in keys.items()}
    return {"type": "object", "additionalProperties": False, "required": sorted(required), "properties": properties}


def _items(keys: Mapping[str, Form], required: frozenset[str]) -> Form:
    """A dictionary with fixed keys."""
    return Form(
        lambda value: {key: keys[key].write(each) for key, each in value.items()},
        _object_schema(keys, required),
        lambda value: isinstance(value, dict) and required <= value.keys() <= keys.keys(),
    )


def _attributes(keys: Mapping[str, tuple[str, Form]], kind: type) -> Form:
    """An object with fixed keys, each from an attribute."""
    return Form(
        lambda value: {key: each.write(_attribute(value, name)) for key, (name, each) in keys.items()},
        _object_schema({key: each for key, (_, each) in keys.items()}, keys),
        _instance(kind),
    )


def _attribute(value: Any, path: str) -> Any:
    """The attribute, property or answer of the method; after a dot, one of it, or None where there is none."""
    for name in path.split("."):
        value = None if value is None else getattr(value, name)
        value = value() if callable(value) else value
    return value


def _record(kind: type) -> Form:
    if getattr(kind, "to_json", Written.to_json) is not Written.to_json:  # it writes itself; the hint says what
        return Form(lambda value: value.to_json(), form(_hint(kind, "to_json")).schema, _instance(kind))
    words = (getattr(kind, "written", "") or " ".join(field.name for field in fields(kind))).split()
    names = {key: name or key for key, _, name in (word.partition("=") for word in words)}
    made = _attributes({key: (name, form(_hint(kind, name))) for key, name in names.items()}, kind)
    if not (definition := getattr(kind, "definition", "")):
        return made
    DEFINITIONS[definition] = made.schema
    return Form(made.write, {"$ref": f"#/$defs/{definition}"}, made.fits)


def _hint(kind: Any, path: str) -> Any:
    """The type of what :func:`_attribute` finds."""
    if get_origin(kind) in (Union, types.UnionType):
        return reduce(or_, [None if each is type(None) else _hint(each, path) for each in get_args(kind)])
    if isinstance(get_origin(kind), type) and issubclass(get_origin(kind), Generic):
        return _hint(get_origin(kind), path)[get_args(kind)]
    name, _, further = path.partition(".")
    if name == "__len__":
        return int
    owner = next((each for each in kind.__mro__ if name in vars(each) or name in vars(each).get(_NOTES, ())), None)
    if owner is None:
        raise TypeError(f"{kind.__name__} has no attribute {name!r}")
    attribute = owner.__dict__.get(name)
    if isinstance(attribute, property | cached_property):
        attribute = attribute.fget if isinstance(attribute, property) else attribute.func
    if isinstance(attribute, types.FunctionType):
        place, note = attribute.__globals__, attribute.__annotations__["return"]
    else:
        place, note = vars(sys.modules[owner.__module__]), vars(owner)[_NOTES][name]
    asked = type("Asked", (), {_NOTES: {name: note}})
    hint = typing.get_type_hints(asked, place, include_extras=True)[name]
    if get_origin(hint) is ClassVar:
        (hint,) = get_args(hint)
    return _hint(hint, further) if further else hint


def rows_text(rows: Iterable[Any]) -> str:
    """Entries of a list in an object, as JSON.

    >>> rows_text([1, "a"])
    '    1,\\n    "a"'
    """
    texts = (json.dumps(row, ensure_ascii=False, indent=2, sort_keys=True) for row in rows)
    return ",\n".join(textwrap.indent(text, "    ") for text in texts)


def under(name: str, written: str) -> str:
    """The same keys, each from an attribute of ``name``.

    >>> under("force", "beta C1=c1")
    'beta=force.beta C1=force.c1'
    """
    words = (word.partition("=") for word in written.split())
    return " ".join(f"{key}={name}.{path or key}" for key, _, path in words)
