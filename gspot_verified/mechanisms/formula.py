"""Text to a symbolic expression, with a parser of our own: a formula from a stranger can run no code.

Numbers are exact (``"0.1"`` is 1/10). Names come from a given table. Operators: ``+ - * /``, and ``**`` or ``^`` with
an integer or half-integer exponent. Functions: sin, cos, tan, exp, sqrt. Length, depth and powers are limited.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, NoReturn

MAX_LENGTH = 10_000
MAX_DEPTH = 50
MAX_POWER = 64
MAX_NESTED_FUNCTIONS = 6
MAX_DIGITS = 100
_MAX_NUMBER_BITS = 20_000
FUNCTIONS = ("sin", "cos", "tan", "exp", "sqrt")

_TOKEN = re.compile(
    r"\s*(?:(?P<number>[0-9]+(?:\.[0-9]*)?|\.[0-9]+)|(?P<name>[A-Za-z_][A-Za-z0-9_]*)|(?P<operator>\*\*|[-+*/^()]))"
)
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,39}")


class FormulaError(ValueError):
    """The text is no formula; the message shows where."""


@dataclass(frozen=True, slots=True)
class _Part:
    """An expression, how high its powers nest (a power multiplies this by its exponent), and how deep its functions."""

    value: Any
    power: int = 1
    functions: int = 0


def check_name(name: str) -> str:
    """The name itself, if it can stand in a formula.

    :raises FormulaError: it is no name, or it is a function's.

    >>> check_name("theta_dot")
    'theta_dot'
    """
    if not isinstance(name, str) or not _NAME.fullmatch(name):
        raise FormulaError(
            f"{str(name)[:50]!r} is no name: letters, digits and _, a letter first, at most 40 characters"
        )
    if name in FUNCTIONS:
        raise FormulaError(f"{name!r} is a function and cannot be a name")
    return name


def parse_formula(text: str, names: Mapping[str, Any]) -> Any:
    """The sympy expression that the text says; ``names`` gives the expression of each name.

    :raises TypeError: not a text.
    :raises FormulaError: not a formula of the small language above, an unknown name, or beyond a limit.

    >>> import sympy
    >>> parse_formula("2*x^2 - 0.1*sin(x)", {"x": sympy.Symbol("x")})
    2*x**2 - sin(x)/10
    >>> parse_formula("__import__('os')", {})
    Traceback (most recent call last):
    ...
    gspot_verified.mechanisms.formula.FormulaError: unknown name '__import__' at character 1 of "__import__('os')"
    """
    if not isinstance(text, str):
        raise TypeError(f"a formula must be a text, got {type(text).__name__}")
    if len(text) > MAX_LENGTH:
        raise FormulaError(f"a formula may have at most {MAX_LENGTH} characters, got {len(text)}")
    return _Parser(text.replace("\N{MINUS SIGN}", "-"), names).whole()


class _Parser:
    """Precedence climbing: sums of products of signed powers of atoms."""

    def __init__(self, text: str, names: Mapping[str, Any]) -> None:
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
        if name not in FUNCTIONS and name not in self._names:
            known = ", ".join(sorted(self._names)[:30])
            hint = f"; known here: {known}" if known else ""
            self._refuse(f"unknown name {name[:40]!r}", place, hint)

    def _refuse(self, problem: str, place: int, hint: str = "") -> NoReturn:
        shown = self._text if len(self._text) <= 60 else self._text[:57] + "..."
        raise FormulaError(f'{problem} at character {place + 1} of "{shown}"{hint}')

    def _peek(self) -> str:
        return self._tokens[self._next][1] if self._next < len(self._tokens) else ""

    def _place(self) -> int:
        return self._tokens[self._next][2] if self._next < len(self._tokens) else len(self._text)

    def whole(self) -> Any:
        part = self._sum()
        if self._next < len(self._tokens):
            self._refuse(f"unexpected {self._peek()[:40]!r}", self._place())
        return part.value

    def _sum(self) -> _Part:
        from sympy import Add

        self._depth += 1
        if self._depth > MAX_DEPTH:
            self._refuse(f"nested deeper than {MAX_DEPTH}", self._place())
        parts = [self._product()]
        terms = [parts[0].value]
        while self._peek() in ("+", "-"):
            negative = self._advance() == "-"
            parts.append(self._product())
            terms.append(-parts[-1].value if negative else parts[-1].value)
        self._depth -= 1
        return self._joined(Add(*terms) if len(terms) > 1 else terms[0], parts)

    def _product(self) -> _Part:
        from sympy import Mul

        parts = [self._signed()]
        factors = [parts[0].value]
        while self._peek() in ("*", "/"):
            place = self._place()
            divide = self._advance() == "/"
            parts.append(self._signed())
            if divide and parts[-1].value.is_zero:
                self._refuse("division by zero", place)
            factors.append(1 / parts[-1].value if divide else parts[-1].value)
        return self._joined(Mul(*factors) if len(factors) > 1 else factors[0], parts)

    def _signed(self) -> _Part:
        negative = False
        while self._peek() in ("+", "-"):
            negative ^= self._advance() == "-"
        part = self._power()
        return _Part(-part.value, part.power, part.functions) if negative else part

    def _power(self) -> _Part:
        base = self._atom()
        if self._peek() not in ("**", "^"):
            return base
        place = self._place()
        self._advance()
        self._depth += 1
        if self._depth > MAX_DEPTH:
            self._refuse(f"nested deeper than {MAX_DEPTH}", place)
        exponent = self._signed().value
        self._depth -= 1
        if not exponent.is_Rational or exponent.q > 2 or abs(exponent) > MAX_POWER:
            self._refuse(f"an exponent must be an integer or half-integer within +-{MAX_POWER}", place)
        return self._raised(base, exponent, place)

    def _raised(self, base: _Part, exponent: Any, place: int) -> _Part:
        height = base.power * max(1, abs(int(exponent.p)))
        if height > MAX_POWER:
            self._refuse(f"powers may nest to at most {MAX_POWER}", place)
        if base.value.is_zero and exponent < 0:
            self._refuse("division by zero", place)
        return self._joined(base.value**exponent, [_Part(base.value, height, base.functions)])

    def _atom(self) -> _Part:
        from sympy import Rational

        place = self._place()
        if self._next >= len(self._tokens):
            self._refuse("the formula ends where a number, a name or '(' must follow", place)
        kind, text, _ = self._tokens[self._next]
        if kind == "number":
            self._next += 1
            if len(text) > MAX_DIGITS:
                self._refuse(f"a number may have at most {MAX_DIGITS} digits", place)
            digits, _, decimals = text.partition(".")
            return _Part(Rational(int(digits + decimals), 10 ** len(decimals)))
        if kind == "name":
            self._next += 1
            return self._function(text, place) if text in FUNCTIONS else _Part(self._names[text])
        if text != "(":
            self._refuse(f"unexpected {text!r}", place)
        return self._parenthesis()

    def _function(self, name: str, place: int) -> _Part:
        import sympy

        if self._peek() != "(":
            self._refuse(f"{name} needs '('", place)
        argument = self._parenthesis()
        if name == "sqrt":
            return self._raised(argument, sympy.Rational(1, 2), place)
        function = {"sin": sympy.sin, "cos": sympy.cos, "tan": sympy.tan, "exp": sympy.exp}[name]
        if argument.functions >= MAX_NESTED_FUNCTIONS:
            self._refuse(f"functions nested deeper than {MAX_NESTED_FUNCTIONS}", place)
        return self._joined(function(argument.value), [_Part(argument.value, argument.power, argument.functions + 1)])

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

    def _joined(self, value: Any, parts: list[_Part]) -> _Part:
        number = value.as_coeff_Mul()[0]
        if number.is_Rational and int(number.p).bit_length() + int(number.q).bit_length() > _MAX_NUMBER_BITS:
            self._refuse(f"a number grows beyond {_MAX_NUMBER_BITS} bits", self._place())
        return _Part(value, max(part.power for part in parts), max(part.functions for part in parts))
