"""Taylor coefficients of one solution by the recurrences of power series, in integers. Heuristic: nothing is bounded.

Fixed point: an integer n stands for n/2^F. Coefficients that vanish at this precision are not multiplied.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from copy import copy
from math import isqrt
from operator import mul
from typing import Any

from flint import arb, fmpq

from gspot_verified.functions.expressions import Expression
from gspot_verified.functions.straight_line import Constants, Given, StraightLine, program
from gspot_verified.integrator.field.no_series import NoSeriesError
from gspot_verified.numbers.balls import working_bits

_GUARD_BITS = 16  # for one function's value at the start

Coefficients = list[list[int]]


class TaylorRecurrence:
    """The Taylor coefficients of the solutions of dx/dt = f(x), compiled once for f.

    :raises TypeError: an operation, or a constant, that has no enclosure.

    >>> from gspot_verified.functions.expressions import Variable
    >>> oscillator = TaylorRecurrence([Variable(1), -Variable(0)])
    >>> [c / 2**10 for c in oscillator.coefficients([2**10, 0], 2**10, 3, 10)[0]]
    [1.0, 0.0, -0.5, 0.0]
    """

    def __init__(self, functions: Sequence[Expression]) -> None:
        self._code = StraightLine()
        self._roots = [self._code.value(function) for function in functions]
        self._program = self._compiled()
        self._constants = Constants(self._code)
        self._fixed: dict[int, list[int]] = {}

    def at(self, given: Given) -> TaylorRecurrence:
        """The same, compiled once for both, with numbers in the place of some constants that are balls."""
        if not given:
            return self
        other = copy(self)
        other._constants, other._fixed = Constants(self._code, given), {}
        return other

    def coefficients(self, start: Sequence[int], step: int, order: int, fraction_bits: int) -> Coefficients:
        """x_k h^k for k = 0..order, by component, from the start x_0 and the length h.

        :raises NoSeriesError: a divisor vanishes at the start, the base of a root, a power or a logarithm is not
            positive there, or the state is so large that no bits are left after the point.
        """
        if fraction_bits < 0:
            raise NoSeriesError("no bits are left after the point")
        known = self._fixed.get(fraction_bits)
        if known is None:
            known = self._fixed[fraction_bits] = [fixed(value, fraction_bits) for value in self._constants.numbers()]
        try:
            coefficients: Coefficients = self._program(list(start), known, order, step, fraction_bits)
        except (ZeroDivisionError, ValueError) as error:  # a divisor, or the argument of an integer square root
            raise NoSeriesError(f"at the start: {error}") from error
        return coefficients

    def _compiled(self) -> Callable[..., Any]:
        names = [name for name in self._code.needed(self._roots) if name[0] != "c"]
        states = [f"x{i}" for i in range(len(self._roots))]
        values = [name for name in names if name not in states]
        lines = [f"{name}, l{name} = [x[{i}]], 0" for i, name in enumerate(states)]
        lines += [f"{name}, l{name} = [], 0" for name in values]
        lines += [f"rates_{name}, sines_{name}, cosines_{name} = [], [], []" for name in values if self._turns(name)]
        for i in range(len(self._code.constants)):
            lines += [f"c{i} = c[{i}]", f"series_c{i}, lseries_c{i} = [c{i}] + [0] * order, 0"]
        lines.append("for k in range(order):")
        for name in values:
            lines.append(f"    t = {self._coefficient(name)}")
            lines += [f"    {name}.append(t)", f"    if t: l{name} = k"]
        for name, root in zip(states, self._roots, strict=True):
            lines.append(f"    t = step * {_term(root)} // ((k + 1) << F)")
            lines += [f"    {name}.append(t)", f"    if t: l{name} = k + 1"]
        lines.append(f"return [{', '.join(states)}]")
        operations = {
            "convolution": _convolution, "squared": _squared, "weighted": _weighted, "turned": _turned,
            "first_of": _first, "isqrt": isqrt,
        }  # fmt: skip
        return program("x, c, order, step, F", lines, operations)

    def _turns(self, name: str) -> bool:
        return self._code.definition(name)[0] == "sine and cosine"

    def _coefficient(self, name: str) -> str:
        """Python text for the coefficient k of a value."""
        operation, operands = self._code.definition(name)
        u = operands[0]
        if operation not in ("sum", "minus", "product") and u[0] == "c":
            u = f"series_{u}"
        match operation:
            case "sum":
                return " ".join(f"{'+' if sign == 1 else '-'} {_term(part)}" for sign, part in operands)
            case "minus":
                return f"-{_term(u)}"
            case "product":
                left, right = operands
                if "c" in (left[0], right[0]):
                    alone = "" if left[0] != right[0] else " if k == 0 else 0"
                    return f"(({_term(left, True)} * {_term(right, True)}) >> F){alone}"
                return f"convolution({left}, l{left}, {right}, l{right}, k) >> F"
            case "square":
                return f"squared({u}, l{u}, k) >> F"
            case "reciprocal":
                rest = f"-(convolution({u}, l{u}, [*{name}, 0], k, k) * {name}[0]) >> (2 * F)"
                return f"{rest} if k else (1 << (2 * F)) // {u}[0]"
            case "root":
                rest = f"(({u}[k] << F) - convolution([*{name}, 0], k, [*{name}, 0], k, k)) // (2 * {name}[0])"
                return f"{rest} if k else isqrt({u}[0] << F)"
            case "power":
                p, q = int(operands[1].p), int(operands[1].q)
                rest = f"weighted({u}, {name}, k, {p}, {q}) // ({q} * k * {u}[0])"
                return f"{rest} if k else first_of('power', {u}[0], F, {p}, {q})"
            case "exponential":
                return f"weighted({u}, {name}, k) // (k << F) if k else first_of('exp', {u}[0], F)"
            case "logarithm":
                rest = f"((({u}[k] * k) << F) - weighted([*{name}, 0], {u}, k)) // (k * {u}[0])"
                return f"{rest} if k else first_of('log', {u}[0], F)"
            case "sine and cosine":
                return f"turned({u}, k, F, rates_{name}, sines_{name}, cosines_{name})"
            case "sine" | "cosine":
                return f"{u}[k][{0 if operation == 'sine' else 1}]"
        raise TypeError(f"no recurrence of {operation}")


def fixed(value: arb | fmpq, fraction_bits: int) -> int:
    """An integer next to value * 2^fraction_bits.

    :raises NoSeriesError: the value is not finite.
    """
    if isinstance(value, fmpq):
        return (int(value.p) << fraction_bits) // int(value.q)
    if not value.is_finite():
        raise NoSeriesError("a value is not finite")
    mantissa, exponent = value.mid().man_exp()
    shift = int(exponent) + fraction_bits
    return int(mantissa) << shift if shift >= 0 else int(mantissa) >> -shift


def _term(name: str, factor: bool = False) -> str:
    """The coefficient k of a value that is known; a constant is a factor, or has the coefficient 0 only."""
    if name[0] == "c":
        return name if factor else f"({name} if k == 0 else 0)"
    return f"{name}[k]"


def _convolution(a: list[int], last_a: int, b: list[int], last_b: int, k: int) -> int:
    """The sum of a_j b_(k-j), where a and b vanish after their last coefficients."""
    if last_a >= k <= last_b:
        return sum(map(mul, a, b[k::-1]))
    low, high = max(0, k - last_b), min(k, last_a)
    return sum(map(mul, a[low : high + 1], b[k - high : k - low + 1][::-1])) if low <= high else 0


def _squared(a: list[int], last: int, k: int) -> int:
    """The sum of a_j a_(k-j): each product of two different factors once."""
    half = (k + 1) // 2
    low = max(0, k - last)
    twice = 2 * sum(map(mul, a[low:half], a[k - low : k - half : -1])) if low < half else 0
    return twice if k % 2 else twice + a[half] * a[half]


def _turned(
    angle: list[int], k: int, fraction_bits: int, rates: list[int], sines: list[int], cosines: list[int]
) -> tuple[int, int]:
    """The coefficients k of the sine and the cosine of a series: s' = u' c, c' = -u' s; ``rates`` are those of u'."""
    if k == 0:
        pair = _first("sin", angle[0], fraction_bits), _first("cos", angle[0], fraction_bits)
    else:
        rates.append(k * angle[k])
        unit = k << fraction_bits
        pair = sum(map(mul, rates, cosines[::-1])) // unit, -(sum(map(mul, rates, sines[::-1])) // unit)
    sines.append(pair[0])
    cosines.append(pair[1])
    return pair


def _weighted(a: list[int], b: list[int], k: int, p: int = 1, q: int = 0) -> int:
    """The sum of (p j - q (k - j)) a_j b_(k-j) over j = 1..k."""
    return sum((p * j - q * (k - j)) * a[j] * b[k - j] for j in range(1, k + 1))


def _first(operation: str, base: int, fraction_bits: int, *more: int) -> int:
    """The value of a function at the start."""
    with working_bits(2 * fraction_bits + abs(base).bit_length() + _GUARD_BITS):
        start = arb(base) * arb((1, -fraction_bits))
        if not (operation in ("sin", "cos", "exp") or start > 0):
            raise NoSeriesError(f"no {operation} of {start.str(5)}")
        match operation:
            case "power":
                value = (start.log() * more[0] / more[1]).exp()
            case "exp":
                value = start.exp()
            case "log":
                value = start.log()
            case "sin":
                value = start.sin()
            case _:
                value = start.cos()
        return fixed(value, fraction_bits)
