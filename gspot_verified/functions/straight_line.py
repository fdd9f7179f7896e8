"""A graph of expressions as straight-line code: every value once, and the partial derivatives beside it.

Values that are computed in the same way are one value, whether or not the graph shares them. Nothing is multiplied out
and no factor 0 is dropped: where a part of an expression is undefined, the whole is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import lru_cache
from types import CodeType
from typing import Any

from flint import arb, fmpq

from gspot_verified.functions.expressions import (
    Constant,
    Cosine,
    Exponential,
    Expression,
    Logarithm,
    Power,
    Product,
    Sine,
    Sum,
    Variable,
)
from gspot_verified.numbers.balls import current_bits

_KEPT_TEXTS = 256  # whose code is kept: the same equations are asked for again and again

Given = Mapping[int, arb | fmpq]
"""Numbers in the place of balls, which are known by their identity: of one code for many values of its parameters."""

Definition = tuple[str, tuple[Any, ...]]
"""An operation and its operands: names of values, or a sign and a name for each term of a sum."""


class Constants:
    """The constants of a code, with what is given in the place of some."""

    def __init__(self, code: StraightLine, given: Given | None = None) -> None:
        self.given = given or {}
        self._code = code
        self._balls: dict[int, list[arb]] = {}

    def numbers(self) -> list[arb | fmpq]:
        """As they stand in the code."""
        return [self.given.get(id(value), value) for value in self._code.constants]

    def balls(self) -> list[arb]:
        """As balls at the working precision, made once for each."""
        bits = current_bits()
        known = self._balls.get(bits)
        if known is None or len(known) < len(self._code.constants):
            known = self._balls[bits] = [arb(value) for value in self.numbers()]
        return known


class StraightLine:
    """Lines of code that grow as values are asked for. A value is known by its name."""

    def __init__(self) -> None:
        self.constants: list[Any] = []
        self._definitions: dict[str, Definition] = {}
        self._names: dict[Definition, str] = {}
        self._numbers: dict[str, fmpq] = {}
        self._slopes: dict[tuple[str, int], str | None] = {}

    def function(self, names: Sequence[str], result: str, operations: Mapping[str, Any]) -> Callable[..., Any]:
        """The function of variables and constants that gives ``result``. Its text holds names made here only."""
        given = [f"{name} = {name[0]}[{name[1:]}]" for name in self.needed(names) if name[0] in "xc"]
        return program("x, c", [*given, *self.lines(names), f"return {result}"], operations)

    def value(self, root: Expression) -> str:
        """The name of the value of an expression.

        :raises TypeError: an operation, or a constant, that has no enclosure.
        """
        made: dict[int, str] = {}
        waiting = [(root, False)]
        while waiting:
            node, ready = waiting.pop()
            if id(node) in made:
                continue
            if ready:
                made[id(node)] = self._operation(node, [made[id(part)] for part in node.parts()])
            else:
                waiting.append((node, True))
                waiting += [(part, False) for part in node.parts()]
        return made[id(root)]

    def slope(self, name: str, index: int) -> str | None:
        """The name of the partial derivative of a value; None when it does not depend on that component."""
        for inner in self.needed([name]):
            if (inner, index) not in self._slopes:
                self._slopes[inner, index] = self._slope(inner, index)
        return self._slopes[name, index]

    def number(self, name: str) -> fmpq | None:
        """The rational that a value is by its definition; None for every other value."""
        return self._numbers.get(name)

    def depends(self, name: str) -> frozenset[int]:
        """The components that a value depends on, or may depend on: cancellations are not seen."""
        return frozenset(int(inner[1:]) for inner in self.needed([name]) if inner[0] == "x")

    def definition(self, name: str) -> Definition:
        """The operation and the operands of a value."""
        return self._definitions[name]

    def needed(self, names: Iterable[str]) -> list[str]:
        """The names of all values that these are computed from, and their own, in an order to compute them."""
        ordered: dict[str, None] = {}
        waiting = [(name, False) for name in names]
        while waiting:
            name, ready = waiting.pop()
            if name in ordered:
                continue
            if ready:
                ordered[name] = None
            else:
                waiting.append((name, True))
                waiting += [(part, False) for part in self.operands(name)]
        return list(ordered)

    def lines(self, names: Iterable[str]) -> list[str]:
        """Python lines that compute these values from x0, x1, ... and the constants c0, c1, ..."""
        return [_line(name, *self._definitions[name]) for name in self.needed(names) if name[0] not in "xc"]

    def operands(self, name: str) -> Sequence[str]:
        """The names of the values that one value is computed from."""
        operation, operands = self._definitions[name]
        if operation == "sum":
            return [part for _, part in operands]
        if operation in ("variable", "constant"):
            return ()
        return operands[:1] if operation == "power" else operands

    def _named(self, operation: str, *operands: Any, name: str | None = None) -> str:
        definition = (operation, operands)
        value_name = self._names.get(definition)
        if value_name is None:
            value_name = self._names[definition] = name or f"v{len(self._names)}"
            self._definitions[value_name] = definition
        return value_name

    def constant(self, value: Any) -> str:
        """The name of a rational or a ball."""
        if isinstance(value, int | fmpq):
            value = fmpq(value)
            key: Any = value
        elif isinstance(value, arb):
            key = ("ball", id(value))  # balls have no certain equality; no integer is such a key
        else:
            raise TypeError(f"no enclosure of a constant of type {type(value).__name__}")
        if ("constant", (key,)) not in self._names:
            self.constants.append(value)
        name = self._named("constant", key, name=f"c{len(self.constants) - 1}")
        if isinstance(value, fmpq):
            self._numbers[name] = value
        return name

    def _operation(self, node: Expression, parts: Sequence[str]) -> str:
        match node:
            case Variable(index):
                return self._named("variable", index, name=f"x{index}")
            case Constant(value):
                return self.constant(value)
            case Sum():
                return self.total(parts)
            case Product():
                return self.product(*parts)
            case Power(_, exponent):
                return self.power(parts[0], exponent)
            case Sine():
                return self._named("sine", self._named("sine and cosine", *parts))
            case Cosine():
                return self._named("cosine", self._named("sine and cosine", *parts))
            case Exponential():
                return self._named("exponential", *parts)
            case Logarithm():
                return self._named("logarithm", *parts)
        raise TypeError(f"no enclosure of a {type(node).__name__}")

    def total(self, names: Iterable[str]) -> str:
        """A sum."""
        rest, terms = fmpq(0), []
        for name in names:
            operation, operands = self._definitions[name]
            if name in self._numbers:
                rest += self._numbers[name]
            else:
                terms.append((-1, operands[0]) if operation == "minus" else (1, name))
        if rest != 0 or not terms:
            terms.append((1, self.constant(rest)))
        if len(terms) == 1:
            return terms[0][1] if terms[0][0] == 1 else self._named("minus", terms[0][1])
        return self._named("sum", *sorted(terms, key=lambda term: (-term[0], term[1])))

    def product(self, left: str, right: str) -> str:
        """A product."""
        numbers = [self._numbers.get(name) for name in (left, right)]
        if numbers[0] is not None and numbers[1] is not None:
            return self.constant(numbers[0] * numbers[1])
        for number, other in zip(numbers, (right, left), strict=True):
            if number == 1:
                return other
            if number == -1:
                operation, operands = self._definitions[other]
                return str(operands[0]) if operation == "minus" else self._named("minus", other)
        return self._named("square", left) if left == right else self._named("product", *sorted((left, right)))

    def power(self, base: str, exponent: fmpq) -> str:
        """A rational power: by products for an integer exponent, by a root otherwise."""
        if exponent.q != 1:
            whole = fmpq(exponent.p // exponent.q)
            if exponent - whole != fmpq(1, 2):
                return self._named("power", base, exponent)
            root = self._named("root", base)
            return root if whole == 0 else self.product(self.power(base, whole), root)
        if exponent < 0:
            return self._named("reciprocal", self.power(base, -exponent))
        power = self.constant(1)
        for digit in f"{int(exponent.p):b}":
            power = self.product(power, power)
            if digit == "1":
                power = self.product(power, base)
        return power

    def _slope(self, name: str, index: int) -> str | None:
        """The rule of differentiation of one operation; the derivatives of its operands are known."""
        operation, operands = self._definitions[name]
        if operation == "variable":
            return self.constant(1) if operands[0] == index else None
        if operation == "constant":
            return None
        if operation == "sum":
            moving = [(sign, self._slopes[part, index]) for sign, part in operands]
            terms = [self.product(self.constant(sign), slope) for sign, slope in moving if slope is not None]
            return self.total(terms) if terms else None
        if operation == "product":
            pairs = [(self._slopes[a, index], b) for a, b in (operands, operands[::-1])]
            terms = [self.product(slope, other) for slope, other in pairs if slope is not None]
            return self.total(terms) if terms else None
        inner = self._slopes[operands[0], index]
        if inner is None or operation == "sine and cosine":
            return inner
        return self.product(self._outer_slope(name, operation, operands), inner)

    def _outer_slope(self, name: str, operation: str, operands: tuple[Any, ...]) -> str:
        base = operands[0]
        rules: dict[str, Callable[[], str]] = {
            "minus": lambda: self.constant(-1),
            "square": lambda: self.product(self.constant(2), base),
            "reciprocal": lambda: self._named("minus", self._named("square", name)),
            "root": lambda: self._named("reciprocal", self.product(self.constant(2), name)),
            "power": lambda: self.product(self.constant(operands[1]), self.power(base, operands[1] - 1)),
            "sine": lambda: self._named("cosine", base),
            "cosine": lambda: self._named("minus", self._named("sine", base)),
            "exponential": lambda: name,
            "logarithm": lambda: self._named("reciprocal", base),
        }
        return rules[operation]()


def _line(name: str, operation: str, operands: tuple[Any, ...]) -> str:
    match operation:
        case "sum":
            terms = [f"{'+' if sign == 1 else '-'} {part}" for sign, part in operands]
            return f"{name} = {' '.join(terms).removeprefix('+ ')}"
        case "product":
            return f"{name} = {operands[0]} * {operands[1]}"
        case "minus":
            return f"{name} = -{operands[0]}"
        case "reciprocal":
            return f"{name} = one / {operands[0]}"
        case "sine and cosine":
            return f"{name} = {operands[0]}.sin_cos()"
        case "sine":
            return f"{name} = {operands[0]}[0]"
        case "cosine":
            return f"{name} = {operands[0]}[1]"
        case "exponential":
            return f"{name} = {operands[0]}.exp()"
        case "power":
            return f"{name} = power({operands[0]}, {int(operands[1].p)}, {int(operands[1].q)})"
    return f"{name} = {operation}({operands[0]})"


def program(arguments: str, lines: Iterable[str], operations: Mapping[str, Any]) -> Callable[..., Any]:
    """The function with these lines, which may use the operations."""
    space = dict(operations)
    exec(_code("\n    ".join([f"def program({arguments}):", *lines])), space)
    made: Callable[..., Any] = space["program"]
    return made


@lru_cache(_KEPT_TEXTS)
def _code(text: str) -> CodeType:
    return compile(text, "<straight-line program>", "exec")
