"""How the terms of an expansion are written: plain, in LaTeX, exactly for files."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from flint import arb, fmpq

from gspot_verified.functions.symbols import RationalFunction
from gspot_verified.numbers.balls import ball_text
from gspot_verified.numbers.dyadic import Dyadic

_GREEK = re.compile(r"\b(alpha|beta|chi|delta|epsilon|kappa|lambda|mu|phi|psi|theta)(?=\b|_)")
_LONG_EXPONENT = re.compile(r"\^(\d\d+)")


def exact_text(value: Any) -> str:
    """A rational as p/q; a ball as an exact dyadic interval."""
    return str(Dyadic.from_ball(value)) if isinstance(value, arb) else str(value)


def shown(value: Any) -> str:
    """A rational or a function of symbols as it is; a ball for people."""
    return ball_text(value) if isinstance(value, arb) else str(value)


@dataclass(frozen=True)
class Style:
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
            return ball_text(value)
        if not isinstance(value, fmpq):
            text = str(value)
            if self is LATEX:
                text = _LONG_EXPONENT.sub(r"^{\1}", _GREEK.sub(r"\\\1", text.replace("*", " ")))
            return f"({text})" if " " in str(value) or "/(" in text else text
        return str(value.p) if value.q == 1 else self.fraction.format(value.p, value.q)


PLAIN = Style("delta", "^{}", "{}/{}", "O({})")
LATEX = Style(r"\delta", "^{{{}}}", r"\frac{{{}}}{{{}}}", r"\mathcal{{O}}({})")


def polynomial_text(coefficients: Sequence[Any], style: Style) -> str:
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
    return parts[0] if len(parts) == 1 else f"({joined(parts)})"


def times_power(factor: str, style: Style, n: int) -> str:
    """The factor times delta^n."""
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


def joined(parts: Sequence[str]) -> str:
    """A sum; a leading minus of a part becomes a difference."""
    text = parts[0]
    for part in parts[1:]:
        text += f" - {part[1:]}" if part.startswith("-") else f" + {part}"
    return text
