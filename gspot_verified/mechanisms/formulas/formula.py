"""Text to an expression, with a parser of our own: a formula from a stranger can run no code.

Numbers are exact (``"0.1"`` is 1/10). Names of Latin or Greek letters come from a given table; ``pi`` is always known.
Operators: ``+ - * /``, and ``**`` or ``^`` with an integer or half-integer exponent. Functions: sin, cos, tan, exp,
log (natural), sqrt. Length, depth and powers are limited.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import NoReturn

from flint import fmpq

from gspot_verified.functions.derivative import ZERO
from gspot_verified.functions.expressions import Expression
from gspot_verified.mechanisms.formulas.names import FUNCTIONS, LETTERS, FormulaError, nearest, normal_name
from gspot_verified.mechanisms.formulas.simplify import (
    NoNumberError,
    constant,
    cosine_of,
    exponential_of,
    logarithm_of,
    power_of,
    product_of,
    rational_value,
    sine_of,
    sum_of,
)
from gspot_verified.mechanisms.formulas.symbol import PI, Symbol

MAX_LENGTH = 10_000  # characters; this and the next four: limits against hostile input
MAX_DEPTH = 50  # open brackets and powers, far below Python's own limit of recursion
MAX_POWER = 64  # of an exponent, and of the product of nested ones
MAX_NESTED_FUNCTIONS = 6  # derivatives of nested functions grow fast
MAX_DIGITS = 100  # characters of one number

_TOKEN = re.compile(
    rf"\s*(?:(?P<number>[0-9]+(?:\.[0-9]*)?|\.[0-9]+)|(?P<name>[{LETTERS}_][{LETTERS}0-9_]*)"
    r"|(?P<operator>\*\*|[-+*/^()]))"
)
_WORD = re.compile(rf"(?<![{LETTERS}0-9_.])[{LETTERS}][{LETTERS}0-9_]{{0,39}}")


@dataclass(frozen=True, slots=True)
class _Part:
    """An expression, how high its powers nest (a power multiplies this by its exponent), and how deep its functions."""

    value: Expression
    power: int = 1
    functions: int = 0


def parse_formula(text: str, names: Mapping[str, Expression]) -> Expression:
    """The expression that the text says; ``names`` gives the expression of each name.

    :raises TypeError: not a text.
    :raises FormulaError: not a formula of the small language above, an unknown name, or beyond a limit.

    >>> from gspot_verified.functions.expressions import Variable
    >>> parse_formula("x^2 - x*x + 0.1", {"x": Variable(0)})
    Constant(value=1/10)
    >>> parse_formula("exec(1)", {})
    Traceback (most recent call last):
    ...
    gspot_verified.mechanisms.formulas.names.FormulaError: unknown name 'exec' at character 1 of "exec(1)"
    """
    if not isinstance(text, str):
        raise TypeError(f"a formula must be a text, got {type(text).__name__}")
    if len(text) > MAX_LENGTH:
        raise FormulaError(f"a formula may have at most {MAX_LENGTH} characters, got {len(text)}")
    return _Parser(normal_name(text), names).whole()


class _Parser:
    """Precedence climbing: sums of products of signed powers of atoms."""

    def __init__(self, text: str, names: Mapping[str, Expression]) -> None:
        self._text, self._names, self._depth = text, names, 0
        self._tokens: list[tuple[str, str, int]] = []
        self._next = 0
        place = 0
        end = len(text.rstrip())
        while place < end:
            match = _TOKEN.match(text, place)
            if match is None:
                place += len(text[place:]) - len(text[place:].lstrip())
                self._refuse(f"unexpected {text[place]!r}", place)
            kind = str(match.lastgroup)
            start = match.start(kind)
            if kind == "name":
                self._check_name(match[kind], start)
            self._tokens.append((kind, match[kind], start))
            place = match.end()

    def _check_name(self, name: str, place: int) -> None:
        if not self._known(name):
            known = ", ".join(sorted(self._names)[:30])
            more = ", ..." if len(self._names) > 30 else ""
            rest = dict.fromkeys(_WORD.findall(self._text, place + len(name)))
            others = [word for word in rest if not self._known(word) and word != name][:10]
            hint = nearest(name, [*self._names, *FUNCTIONS, PI])
            hint += f"; also unknown: {', '.join(others)}" if others else ""
            hint += f"; known here: {known}{more}" if known else ""
            self._refuse(f"unknown name {name[:40]!r}", place, hint)

    def _known(self, name: str) -> bool:
        return name in FUNCTIONS or name == PI or name in self._names

    def _refuse(self, problem: str, place: int, hint: str = "") -> NoReturn:
        shown = self._text if len(self._text) <= 60 else self._text[:57] + "..."
        raise FormulaError(f'{problem} at character {place + 1} of "{shown}"{hint}')

    def _peek(self) -> str:
        return self._tokens[self._next][1] if self._next < len(self._tokens) else ""

    def _place(self) -> int:
        return self._tokens[self._next][2] if self._next < len(self._tokens) else len(self._text)

    def whole(self) -> Expression:
        try:
            part = self._sum()
        except NoNumberError as error:
            self._refuse(str(error), self._place())
        if self._next < len(self._tokens):
            self._refuse(f"unexpected {self._peek()[:40]!r}", self._place())
        return part.value

    def _sum(self) -> _Part:
        self._depth += 1
        if self._depth > MAX_DEPTH:
            self._refuse(f"nested deeper than {MAX_DEPTH}", self._place())
        parts = [self._product()]
        terms = [parts[0].value]
        while self._peek() in ("+", "-"):
            negative = self._advance() == "-"
            parts.append(self._product())
            terms.append(_minus(parts[-1].value) if negative else parts[-1].value)
        self._depth -= 1
        return _joined(sum_of(*terms) if len(terms) > 1 else terms[0], parts)

    def _product(self) -> _Part:
        parts = [self._signed()]
        factors = [parts[0].value]
        while self._peek() in ("*", "/"):
            place = self._place()
            divide = self._advance() == "/"
            parts.append(self._signed())
            factors.append(self._to_power(parts[-1].value, fmpq(-1), place) if divide else parts[-1].value)
        return _joined(product_of(*factors) if len(factors) > 1 else factors[0], parts)

    def _signed(self) -> _Part:
        negative = False
        while self._peek() in ("+", "-"):
            negative = negative != (self._advance() == "-")
        part = self._power()
        return _Part(_minus(part.value), part.power, part.functions) if negative else part

    def _power(self) -> _Part:
        base = self._atom()
        if self._peek() not in ("**", "^"):
            return base
        place = self._place()
        self._advance()
        self._depth += 1
        if self._depth > MAX_DEPTH:
            self._refuse(f"nested deeper than {MAX_DEPTH}", place)
        exponent = rational_value(self._signed().value)
        self._depth -= 1
        if exponent is None or exponent.q > 2 or abs(exponent) > MAX_POWER:
            self._refuse(f"an exponent must be an integer or half-integer within +-{MAX_POWER}", place)
        return self._raised(base, exponent, place)

    def _raised(self, base: _Part, exponent: fmpq, place: int) -> _Part:
        height = base.power * max(1, abs(int(exponent.p)))
        if height > MAX_POWER:
            self._refuse(f"powers may nest to at most {MAX_POWER}", place)
        return _Part(self._to_power(base.value, exponent, place), height, base.functions)

    def _to_power(self, base: Expression, exponent: fmpq, place: int) -> Expression:
        if base is ZERO and exponent < 0:
            self._refuse("division by zero", place)
        return power_of(base, exponent)

    def _atom(self) -> _Part:
        place = self._place()
        if self._next >= len(self._tokens):
            self._refuse("the formula ends where a number, a name or '(' must follow", place)
        kind, text, _ = self._tokens[self._next]
        if kind == "number":
            self._next += 1
            if len(text) > MAX_DIGITS:
                self._refuse(f"a number may have at most {MAX_DIGITS} digits", place)
            digits, _, decimals = text.partition(".")
            return _Part(constant(fmpq(int(digits + decimals), 10 ** len(decimals))))
        if kind == "name":
            self._next += 1
            if text in FUNCTIONS:
                return self._function(text, place)
            return _Part(Symbol(PI) if text == PI else self._names[text])
        if text != "(":
            self._refuse(f"unexpected {text!r}", place)
        return self._parenthesis()

    def _function(self, name: str, place: int) -> _Part:
        if self._peek() != "(":
            self._refuse(f"{name} needs '('", place)
        argument = self._parenthesis()
        if name == "sqrt":
            return self._raised(argument, fmpq(1, 2), place)
        if argument.functions >= MAX_NESTED_FUNCTIONS:
            self._refuse(f"functions nested deeper than {MAX_NESTED_FUNCTIONS}", place)
        return _Part(_apply(name, argument.value), argument.power, argument.functions + 1)

    def _parenthesis(self) -> _Part:
        self._advance()
        part = self._sum()
        if self._peek() != ")":
            self._refuse("')' is missing", self._place())
        self._advance()
        return part

    def _advance(self) -> str:
        self._next += 1
        return self._tokens[self._next - 1][1]


def _minus(value: Expression) -> Expression:
    return product_of(constant(-1), value)


def _apply(name: str, argument: Expression) -> Expression:
    match name:
        case "sin":
            return sine_of(argument)
        case "cos":
            return cosine_of(argument)
        case "tan":
            return product_of(sine_of(argument), power_of(cosine_of(argument), fmpq(-1)))
        case "log":
            return logarithm_of(argument)
        case _:
            return exponential_of(argument)


def _joined(value: Expression, parts: list[_Part]) -> _Part:
    return _Part(value, max(part.power for part in parts), max(part.functions for part in parts))
