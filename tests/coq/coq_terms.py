"""Arithmetic in the Coq files, read and evaluated: what the files of statements in proofs/coq/ state, as numbers.

A term is read as Coq reads it: application binds tightest, then ^, then a leading minus, then * and /, then + and -
(for natural numbers / and mod are those of integers, and n mod m stands on the level of * and /).
"""

from __future__ import annotations

import importlib.util
import re
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

COQ = Path(__file__).resolve().parents[2] / "proofs" / "coq"
STATEMENTS = [
    COQ / f"{name}.v"
    for name in (
        "Statement",
        "StatementModels",
        "StatementCompliant",
        "StatementFlight",
        "StatementStep",
        "StatementApproach",
        "StatementPassage",
        "StatementCertificate",
        "StatementChecker",
        "StatementForce",
        "StatementRun",
    )
]
"""In the order in which each one uses those before it."""
TOKEN = re.compile(r"\s*(?:(\d+)|([A-Za-z_][\w']*(?:\.[A-Za-z_]\w*)*)|(.))")

Names = Mapping[str, Any]
"""What a name stands for: a number, or a function with the number of its arguments as attribute of :class:`Applied`."""


def script_named(name: str) -> ModuleType:
    """A script of the folder of proofs, which is no package, as a module of its own."""
    spec = importlib.util.spec_from_file_location(name, COQ / f"{name}.py")
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def without_comments(text: str) -> str:
    """The text as the script that compiles the proofs reads it."""
    return str(script_named("source_rules").code(text))


@cache
def stated() -> str:
    """The files of statements without comments."""
    return without_comments("\n".join(file.read_text(encoding="utf-8") for file in STATEMENTS))


class Applied:
    """A function of Coq with a fixed number of arguments, which are terms."""

    def __init__(self, arity: int, function: Callable[..., Any]) -> None:
        self.arity = arity
        self.function = function


def statement(name: str, text: str | None = None) -> str:
    """The body of the one definition of this name in the files of statements, without comments, on one line."""
    text = stated() if text is None else without_comments(text)
    pattern = rf"^(?:Definition|Fixpoint) {re.escape(name)}(?![\w'])(.*?)\.\n(?=\n|$)"
    found = re.findall(pattern, text, re.MULTILINE | re.DOTALL)
    assert len(found) == 1, f"{len(found)} definitions of {name} in the files of statements"
    return " ".join(found[0].split())


class Reader:
    """One term, evaluated while it is read; ``scalar`` makes a numeral into a number of the kind that is wanted."""

    def __init__(self, text: str, names: Names, scalar: Callable[[int], Any]) -> None:
        self.tokens = [match.group(match.lastindex or 0) for match in TOKEN.finditer(text.strip()) if match.lastindex]
        self.place = 0
        self.names = names
        self.scalar = scalar

    def next(self) -> str:
        return self.tokens[self.place] if self.place < len(self.tokens) else ""

    def take(self) -> str:
        token = self.next()
        self.place += 1
        return token

    def sum(self) -> Any:
        value = self.product()
        while self.next() in ("+", "-"):
            value = value + self.product() if self.take() == "+" else value - self.product()
        return value

    def product(self) -> Any:
        value = self.signed()
        while self.next() in ("*", "/", "mod"):
            operator, other = self.take(), self.signed()
            if operator == "*":
                value = value * other
            elif operator == "mod":
                value = value % other
            else:
                value = value // other if isinstance(value, int) and isinstance(other, int) else value / other
        return value

    def signed(self) -> Any:
        if self.next() == "-":
            self.take()
            return -self.signed()
        return self.power()

    def power(self) -> Any:
        base = self.application()
        if self.next() == "^":
            self.take()
            return base ** self.power()
        return base

    def application(self) -> Any:
        value = self.atom()
        if not isinstance(value, Applied):
            return value
        return value.function(*(self.atom() for _ in range(value.arity)))

    def atom(self) -> Any:
        token = self.take()
        if token == "(":
            value = self.sum()
            assert self.take() == ")", "an open parenthesis"
            return value
        if token.isdecimal():
            return self.scalar(int(token))
        assert token in self.names, f"unknown: {token!r}"
        return self.names[token]


def evaluate_term(text: str, names: Names, scalar: Callable[[int], Any] = int) -> Any:
    """The value of a term; every token must belong to it."""
    reader = Reader(text, names, scalar)
    value = reader.sum()
    assert not reader.next(), f"left over: {reader.tokens[reader.place :]}"
    return value


def mutations(text: str) -> list[str]:
    """The text with one number raised by one, one sign or operation changed, or one leading minus left out."""
    found = []
    for match in re.finditer(r"\d+|[-+*/]|mod", text):
        token, before, after = match[0], text[: match.start()], text[match.end() :]
        if token.isdecimal():
            found.append(f"{before}{int(token) + 1}{after}")
        elif token == "-" and before.rstrip()[-1:] in ("", "(", "=", ","):
            found.append(before + after)
        else:
            found.append(before + {"+": "-", "-": "+", "*": "/", "/": "*", "mod": "/"}[token] + after)
    return found
