r"""Formulas of the paper's LaTeX as texts in FLINT's notation: read by a program, to be compared with the typed ones.

A formula is a list of tokens. The reader is told what its names stand for: ``{r"\frac{d\hat b}{dt}": "b1"}`` reads a
derivative as one symbol. What it is not told it refuses.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

_TOKEN = re.compile(r"\\\\|\\[A-Za-z]+|\\.|\d+|[A-Za-z]|\S")
_ACCENTS = {r"\hat", r"\bar", r"\tilde", r"\dot", r"\ddot"}
_LAYOUT = {r"\left", r"\right", r"\nonumber", r"\,", r"\:", r"\;", r"\!", "&", "$", r"\beq", r"\eeq"}
_SPACES = {r"\quad", r"\qquad", r"\\", ",", ".", r"\ "}
_RELATIONS = {"=", r"\sim", r"\in", "<", ">"}
_OPENING = {"(": ")", "[": "]", "{": "}"}


def tokens(latex: str) -> list[str]:
    """The tokens without layout, comments and labels; an accent has braces, and a one-digit exponent too."""
    text = re.sub(r"(?<!\\)%.*|\\(?:left|right)\.", "", latex)
    text = re.sub(r"\\(?:label|begin|end|mbox|text)\s*\{[^}]*\}(?:\{[lcr|]*\})?", " ", text)
    text = re.sub(r":\s*=", "=", text)
    found: list[str] = []
    waiting = [token for token in _TOKEN.findall(text) if token not in _LAYOUT]
    while waiting:
        token = waiting.pop(0)
        found.append(token)
        if token in _ACCENTS and waiting and waiting[0] != "{":
            found += ["{", waiting.pop(0), "}"]
    return found


def pieces(latex: str) -> list[list[str]]:
    """The equations of some lines: parts at the top level between commas, wide spaces and ends of rows."""
    return _split(tokens(latex), _SPACES)


def sides(equation: list[str]) -> list[list[str]]:
    """What stands on the sides of the relations of one equation."""
    return _split(equation, _RELATIONS)


def _split(found: Iterable[str], at: set[str]) -> list[list[str]]:
    parts: list[list[str]] = [[]]
    depth = 0
    for token in found:
        depth += (token in _OPENING) - (token in _OPENING.values())
        if token in at and depth == 0:
            parts.append([])
        elif token != r"\\":
            parts[-1].append(token)
    return [part for part in parts if part]


def formula(found: list[str], names: Mapping[str, str]) -> tuple[str, list[str]]:
    """The text of a formula, and those in its terms O(...), which count as 0.

    :raises ValueError: a token that is neither arithmetic nor in the names.
    """
    reader = _Reader(_named(found, names))
    text = reader.sum()
    if reader.rest:
        raise ValueError(f"not read: {' '.join(reader.rest)}")
    return text, reader.orders


class Sides:
    """The sides of one equation, each read when it is asked for."""

    def __init__(self, parts: list[list[str]], names: Mapping[str, str]) -> None:
        self._parts, self._names = parts, names

    def __getitem__(self, k: int) -> str:
        return formula(self._parts[k], self._names)[0]

    def orders(self, k: int) -> list[str]:
        """What stands in the terms O(...) of a side."""
        return formula(self._parts[k], self._names)[1]


def _named(found: list[str], names: Mapping[str, str]) -> list[str]:
    """Tokens with symbols in place of names, the longest name first; a symbol begins with a mark."""
    keys = sorted(((tokens(key), symbol) for key, symbol in names.items()), key=lambda pair: -len(pair[0]))
    named, at = [], 0
    while at < len(found):
        key, symbol = next(((k, s) for k, s in keys if found[at : at + len(k)] == k), ([], ""))
        named.append(f"@{symbol}" if key else found[at])
        at += len(key) or 1
    return named


class _Reader:
    """Sums, products without a sign, fractions, powers, roots, Γ, factorials, O(...)."""

    def __init__(self, rest: list[str]) -> None:
        self.rest = rest
        self.orders: list[str] = []

    def _next(self) -> str:
        return self.rest[0] if self.rest else ""

    def _take(self, wanted: str = "") -> str:
        if not self.rest or (wanted and self.rest[0] != wanted):
            raise ValueError(f"{wanted or 'a token'} is missing before: {' '.join(self.rest)}")
        return self.rest.pop(0)

    def sum(self) -> str:
        text = ""
        while self.rest and (not text or self._next() in "+-"):
            sign = self._take() if self._next() in ("+", "-") else "+"
            text += (sign if text or sign == "-" else "") + self._product()
        return f"({text})"

    def _product(self) -> str:
        text = self._factor()
        while self.rest and self._next() not in (*"+-", *_OPENING.values()):
            operation = "/" if self._next() == "/" else "*"
            if operation == "/":
                self._take()
            text += operation + self._factor()
        return text

    def _group(self) -> str:
        opening = self._take()
        if opening not in _OPENING:
            return self._symbol(opening)
        text = self.sum()
        self._take(_OPENING[opening])
        return text

    def _factor(self) -> str:
        token = self._next()
        if token == r"\frac":
            self._take()
            above = self._group()
            text = f"({above}/{self._group()})"
        elif token == r"\mathcal":
            del self.rest[:4]
            self.orders.append(self._group())
            text = "0"
        elif token in (r"\Gamma", r"\sqrt", r"\exp"):
            self._take()
            name = {r"\Gamma": "Gamma", r"\sqrt": "sqrt", r"\exp": "e^"}[token]
            text = f"{name}{self._group()}" if token != r"\exp" else f"(e^{self._group()})"
        else:
            text = self._group()
        if self._next() == "!":
            self._take()
            text = f"fac({text})"
        if self._next() == "^":
            self._take()
            text = f"({text}^{self._group()})"
        return text

    def _symbol(self, token: str) -> str:
        if token.startswith("@"):
            return f"({token[1:]})" if re.search(r"\W", token) else token[1:]
        if token.isdigit():
            return token
        raise ValueError(f"{token} is not in the names")
