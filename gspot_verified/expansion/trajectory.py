"""The distinguished trajectory of Theorem 1 up to a given order, as a frozen result."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from flint import arb, fmpq

from gspot_verified.balls import ExactInput, ball, bits_for_digits, exact, working_bits
from gspot_verified.dyadic import Dyadic
from gspot_verified.expansion.recursion import Recursion
from gspot_verified.expansion.spaces import SpacePolynomial
from gspot_verified.expansion.symbols import RationalFunction
from gspot_verified.expansion.system import System
from gspot_verified.expansion.time_series import DELTA_FACTORS, Table, TimeSeries

MAX_ORDER = 2000
_GUARD_BITS = 30
_SCALARS = ("p", "b", "y", "v", "z", "lambda_n")

_GREEK = re.compile(r"\b(alpha|beta|chi|delta|epsilon|kappa|lambda|mu|phi|psi|theta)(?=\b|_)")
_LONG_EXPONENT = re.compile(r"\^(\d\d+)")

Terms = tuple[SpacePolynomial, ...]


@dataclass(frozen=True)
class Trajectory:
    """The terms of orders 0..order-1 of delta of the scaled variables; paper, th:1.

    ``p[n]`` is p_n(s), a polynomial in the space that the theorem states; ``xi[i][n]`` is the term of component i.
    """

    system: System
    order: int
    xi: tuple[Terms, ...]
    p: Terms
    b: Terms
    y: Terms
    v: Terms
    z: Terms
    lambda_n: Terms

    def terms(self) -> dict[str, Terms]:
        """All terms by name: xi_1, xi_2, ..., p, b, y, v, z, lambda_n."""
        named = {f"xi_{i + 1}": terms for i, terms in enumerate(self.xi)}
        return {**named, **{name: getattr(self, name) for name in _SCALARS}}

    def in_time(self) -> TimeSeries:
        """The unscaled variables xi - xi*, p, b, y, v, z, lambda_N as polynomials in t and epsilon.

        Paper, Corollary of th:1: delta^n s^k is t^k epsilon^((n - 2 k)/3), times the scale of the variable.
        """
        tables = {name: self._table(getattr(self, name), DELTA_FACTORS[name]) for name in _SCALARS}
        components = tuple(self._table(terms, DELTA_FACTORS["xi"]) for terms in self.xi)
        return TimeSeries(order=self.order, xi=components, **tables)

    def _table(self, terms: Terms, factor: int) -> Table:
        table: Table = {}
        for n, term in enumerate(terms):
            for k, value in enumerate(term.coefficients()):
                if self.system.ring.is_zero(value):
                    continue
                power, rest = divmod(n + factor - 2 * k, 3)
                if rest or power < 0:
                    raise ArithmeticError(f"s^{k} delta^{n} has no counterpart t^{k} epsilon^m")
                table[k, power] = value
        return table

    def evaluate(self, s: ExactInput, delta: ExactInput, digits: int = 15) -> dict[str, arb]:
        """Balls around the scaled variables of the truncated expansion at (s, delta).

        This is the value of the polynomials, not of the true trajectory: the terms from delta^order on are left out.
        For rational arguments and terms it is accurate to ``digits`` digits.

        :raises TypeError: the numbers of the system are symbols.

        >>> from gspot_verified.testing import extended_example
        >>> value = expand(extended_example(chi=1), 8).evaluate(s=1, delta="1/10")
        >>> value["p"]
        [-0.989893000000000 +/- 3e-20]
        """
        place, scale = exact(s, "s"), exact(delta, "delta")
        self._needs_numbers()
        with working_bits(bits_for_digits(digits) + _GUARD_BITS):
            at, step = (_number(value, self._is_rational) for value in (place, scale))
            return {name: _ball(_horner([t(at) for t in terms], step)) for name, terms in self.terms().items()}

    def evaluate_in_time(self, t: ExactInput, epsilon: ExactInput, digits: int = 15) -> dict[str, arb]:
        """Balls around the unscaled variables of the truncated expansion at (t, epsilon); xi minus xi*.

        This is the value of the polynomials of :meth:`in_time`, not of the true trajectory.
        """
        time, small = exact(t, "t"), exact(epsilon, "epsilon")
        self._needs_numbers()
        with working_bits(bits_for_digits(digits) + _GUARD_BITS):
            at, step = (_number(value, self._is_rational) for value in (time, small))
            return {name: _ball(_bivariate(table, at, step)) for name, table in self.in_time().tables().items()}

    def _needs_numbers(self) -> None:
        if not isinstance(self.system.ring.number(0), fmpq | arb):
            raise TypeError("a value needs numbers: put numbers in the place of the symbols")

    @property
    def _is_rational(self) -> bool:
        return isinstance(self.system.ring.number(0), fmpq)

    def __str__(self) -> str:
        lines = [f"{self.system.name}: the scaled variables to the order {self.order} of delta"]
        lines += [f"  {name} = {self._text(terms, _PLAIN)}" for name, terms in self.terms().items()]
        return "\n".join(lines)

    def to_latex(self) -> str:
        r"""An ``align*`` environment with one line for each scaled variable."""
        lines = [
            rf"  {_latex_name(name)}(s,\delta) &= {self._text(terms, _LATEX)}" for name, terms in self.terms().items()
        ]
        return "\\begin{align*}\n" + " \\\\\n".join(lines) + "\n\\end{align*}"

    def _text(self, terms: Terms, style: _Style) -> str:
        parts = []
        for n, term in enumerate(terms):
            if not term.is_zero():
                parts.append(_times_power(_polynomial(term.coefficients(), style), style, n))
        parts.append(style.rest.format(style.power(style.delta, self.order)))
        return _joined(parts)

    def to_json(self) -> dict[str, Any]:
        """Plain data for ``json.dumps``: per variable and order the coefficients of s^0, s^1, ... as exact text."""
        return {
            "system": self.system.name,
            "order": self.order,
            "terms": {
                name: [[_exact_text(value) for value in term.coefficients()] for term in terms]
                for name, terms in self.terms().items()
            },
        }


def expand(system: System, order: int, progress: Callable[[int, int], None] | None = None) -> Trajectory:
    """The terms of orders 0..order-1 of the distinguished trajectory; ``progress`` is told (orders done, orders).

    :raises TypeError: ``order`` is not an int.
    :raises ValueError: it is not in 1..2000.
    :raises GSpotError: a hypothesis of Theorem 1 fails at the point.

    >>> from gspot_verified.testing import extended_example
    >>> trajectory = expand(extended_example(chi=1), 7)
    >>> print(str(trajectory).splitlines()[7])
      p = -s + s^2 delta^2 + 2 s^3 delta^4 + (3 s^4 - 96 s) delta^6 + O(delta^7)
    >>> trajectory.in_time().z[0, 4]
    6672/5
    """
    if type(order) is not int:
        raise TypeError(f"order must be an int, got {type(order).__name__}")
    if not 1 <= order <= MAX_ORDER:
        raise ValueError(f"order must lie in 1..{MAX_ORDER}, got {order}")
    if not isinstance(system, System):
        raise TypeError(f"system must be a System, got {type(system).__name__}")
    recursion = Recursion(system)
    for n in range(order):
        recursion.advance()
        if progress is not None:
            progress(n + 1, order)
    scalars = {name: tuple(getattr(recursion, name)) for name in _SCALARS}
    return Trajectory(system, order, tuple(zip(*recursion.xi, strict=True)), **scalars)


def _number(value: Any, keep: bool) -> Any:
    return value if keep or isinstance(value, arb) else ball(value)


def _ball(value: Any) -> arb:
    return ball(value)


def _horner(values: Sequence[Any], at: Any) -> Any:
    total = values[-1]
    for value in reversed(values[:-1]):
        total = total * at + value
    return total


def _bivariate(table: Table, t: Any, epsilon: Any) -> Any:
    layers: dict[int, list[Any]] = {}
    for (k, m), value in table.items():
        row = layers.setdefault(m, [])
        row += [0] * (k + 1 - len(row))
        row[k] = value
    total: Any = fmpq(0)
    for m in range(max(layers, default=-1), -1, -1):
        total = total * epsilon + (_horner(layers[m], t) if m in layers else 0)
    return total


def _exact_text(value: Any) -> str:
    """A rational as p/q; a ball as an exact dyadic interval."""
    return str(Dyadic.from_ball(value)) if isinstance(value, arb) else str(value)


@dataclass(frozen=True)
class _Style:
    """How powers and fractions are written."""

    delta: str
    exponent: str
    fraction: str
    rest: str

    def power(self, base: str, exponent: int) -> str:
        """base^exponent, without an exponent 1."""
        return base if exponent == 1 else base + self.exponent.format(exponent)

    def number(self, value: Any) -> str:
        """A rational that is not negative, a ball or a function of symbols."""
        if isinstance(value, arb):
            return str(value)
        if not isinstance(value, fmpq):
            text = str(value)
            if self is _LATEX:
                text = _LONG_EXPONENT.sub(r"^{\1}", _GREEK.sub(r"\\\1", text.replace("*", " ")))
            return f"({text})" if " " in str(value) or "/(" in text else text
        return str(value.p) if value.q == 1 else self.fraction.format(value.p, value.q)


_PLAIN = _Style("delta", "^{}", "{}/{}", "O({})")
_LATEX = _Style(r"\delta", "^{{{}}}", r"\frac{{{}}}{{{}}}", r"\mathcal{{O}}({})")


def _latex_name(name: str) -> str:
    if name.startswith("xi_"):
        return rf"\tilde{{\xi}}_{{{name[3:]}}}"
    return r"\tilde{\lambda}" if name == "lambda_n" else rf"\tilde{{{name}}}"


def _polynomial(coefficients: Sequence[Any], style: _Style) -> str:
    """Highest power first, as the paper prints them; several terms stand in parentheses."""
    parts = []
    for k in range(len(coefficients) - 1, -1, -1):
        value = coefficients[k]
        if value == 0:
            continue
        if isinstance(value, RationalFunction):
            constant = value.constant()
            value = value if constant is None else constant
        negative = isinstance(value, fmpq) and bool(value < 0)
        size = style.number(-value if negative else value)
        if k:
            power = style.power("s", k)
            size = power if size == "1" else f"{size} {power}"
        parts.append(f"-{size}" if negative else size)
    return parts[0] if len(parts) == 1 else f"({_joined(parts)})"


def _times_power(factor: str, style: _Style, n: int) -> str:
    if n == 0:
        return factor[1:-1] if _is_enclosed(factor) else factor
    power = style.power(style.delta, n)
    return {"1": power, "-1": f"-{power}"}.get(factor, f"{factor} {power}")


def _is_enclosed(text: str) -> bool:
    """Whether the first parenthesis closes at the very end."""
    depth = 0
    for i, letter in enumerate(text):
        depth += (letter == "(") - (letter == ")")
        if depth == 0:
            return letter == ")" and i == len(text) - 1
    return False


def _joined(parts: Sequence[str]) -> str:
    text = parts[0]
    for part in parts[1:]:
        text += f" - {part[1:]}" if part.startswith("-") else f" + {part}"
    return text
