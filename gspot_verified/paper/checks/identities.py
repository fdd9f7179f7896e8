"""Printed formulas as exact polynomials, and checks of a formula by a route that must give zero.

A formula is a text in the notation of FLINT. Functions enter by their derivatives: b0, b1, b2 are b, b', b''.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from gspot_verified.paper.checks.entry import Check, Rung

Parts = Mapping[str, fmpq_mpoly]
Route = Callable[[Parts], Sequence[fmpq_mpoly]]
"""From the formulas of a claim, by name, to polynomials that are all zero exactly when the claim holds."""

_GREEK = {"alpha": "α_", "beta": "β", "delta": "δ", "epsilon": "ε", "lam": "λ", "chi": "χ", "kappa": "κ"} | {
    "Gamma": "Γ",
    "pi": "π",
    "tau": "τ",
}


class Algebra:
    """Polynomials over the rationals in named symbols.

    >>> algebra = Algebra("s b0 b1 b2")
    >>> total = algebra.jets("s", "b")
    >>> str(algebra.derivative(algebra.read("s*b0"), total))
    's*b1 + b0'
    """

    def __init__(self, names: str) -> None:
        self._context = fmpq_mpoly_ctx.get(names.split(), "degrevlex")
        self.symbols = dict(zip(self._context.names(), self._context.gens(), strict=True))

    def read(self, text: str) -> fmpq_mpoly:
        """The polynomial that a text in the symbols says."""
        return fmpq_mpoly(text, self._context)

    def constant(self, value: int | fmpq) -> fmpq_mpoly:
        """A rational number as a polynomial."""
        return self._context.constant(value)

    def bring(self, value: fmpq_mpoly) -> fmpq_mpoly:
        """A polynomial in fewer symbols, made elsewhere, as one in these symbols."""
        return value.project_to_context(self._context)

    def substitute(self, value: fmpq_mpoly, images: Mapping[str, fmpq_mpoly]) -> fmpq_mpoly:
        """The polynomial with polynomials in place of some symbols, all at once."""
        return value.compose(*(images.get(name, symbol) for name, symbol in self.symbols.items()))

    def derivative(self, value: fmpq_mpoly, images: Mapping[str, fmpq_mpoly], times: int = 1) -> fmpq_mpoly:
        """The derivation with the stated images of the symbols (others: 0), applied ``times`` times."""
        for _ in range(times):
            value = sum(
                (value.derivative(name) * image for name, image in images.items()), start=self._context.constant(0)
            )
        return value

    def jets(self, time: str, *functions: str) -> dict[str, fmpq_mpoly]:
        """The total derivative: time to 1, and each of f0, f1, ... to the next one."""
        images = {time: self.constant(1)}
        for name in functions:
            order = 0
            while f"{name}{order + 1}" in self.symbols:
                images[f"{name}{order}"] = self.symbols[f"{name}{order + 1}"]
                order += 1
        return images

    def coefficients(self, value: fmpq_mpoly, name: str) -> dict[int, fmpq_mpoly]:
        """The coefficients of the powers of one symbol that occur."""
        place = list(self.symbols).index(name)
        found: dict[int, dict[tuple[int, ...], fmpq]] = {}
        for exponents, number in value.terms():
            rest = (*exponents[:place], 0, *exponents[place + 1 :])
            found.setdefault(int(exponents[place]), {})[rest] = number
        return {power: self._context.from_dict(terms) for power, terms in found.items()}

    def coefficient_of(self, value: fmpq_mpoly, name: str, power: int) -> fmpq_mpoly:
        """The coefficient of one power of one symbol."""
        return self.coefficients(value, name).get(power, self.constant(0))

    def replaced(self, value: fmpq_mpoly, function: str, images: Sequence[fmpq_mpoly], free: fmpq_mpoly) -> fmpq_mpoly:
        """A polynomial of degree at most 1 in f0, f1, ...: f_k becomes images[k], terms without f times ``free``."""
        names = [f"{function}{k}" for k in range(len(images))]
        zero = {name: self.constant(0) for name in names}
        total = self.substitute(value, zero) * free
        for name, image in zip(names, images, strict=True):
            total += self.substitute(value.derivative(name), zero) * image
        return total

    def determinant(self, rows: Sequence[Sequence[fmpq_mpoly]]) -> fmpq_mpoly:
        """Laplace's expansion by the first row."""
        if not rows:
            return self.constant(1)
        total = self.constant(0)
        for j, value in enumerate(rows[0]):
            minor = [[*row[:j], *row[j + 1 :]] for row in rows[1:]]
            total += (-1) ** j * value * self.determinant(minor)
        return total


@dataclass(frozen=True)
class Claim:
    """Formulas as printed, and in the corrected form where the printed one fails."""

    algebra: Algebra
    printed: Mapping[str, str]
    corrected: Mapping[str, str] = field(default_factory=dict)

    def check(self, what: str, route: Route, rung: Rung = Rung.EXACT, fault: str = "") -> Check:
        """Whether the route gives zero. A failure needs the corrected form, if there is one, to give zero.

        :param fault: what a failure means, in words; ``{left}`` stands for what the printed form leaves.
        """
        return Check(rung, what, *self._answer(route, fault))

    def _answer(self, route: Route, fault: str) -> tuple[bool | None, str]:
        left = self._first_failure(route, self.printed)
        if left is None:
            return None, "nothing was checked"
        if left == "":
            return True, ""
        fixed = self._first_failure(route, {**self.printed, **self.corrected})
        if self.corrected and fixed != "":
            return None, f"printed: {left}; corrected: {fixed}"
        if fault:
            return False, fault.replace("{left}", left)
        holds = "; the corrected form gives 0" if self.corrected else ""
        return False, f"the printed form leaves {left} instead of 0{holds}"

    def _first_failure(self, route: Route, texts: Mapping[str, str]) -> str | None:
        found = route({name: self.algebra.read(text) for name, text in texts.items()})
        wrong = [value for value in found if not value.is_zero()]
        return readable(wrong[0]) if wrong else "" if found else None


def in_greek(text: str) -> str:
    """A formula with Greek letters in place of their names."""
    for name, letter in _GREEK.items():
        text = re.sub(rf"\b{name}(?=\d|\b)", letter, text)
    return text


def in_latex(text: str) -> str:
    """A formula as LaTeX, with a space for each sign of multiplication.

    >>> print(in_latex("(2*beta+4*beta*lam)/3"))
    (2 \\beta+4 \\beta \\lambda)/3
    """
    named = re.sub(rf"\b({'|'.join(_GREEK)})(?=\d|\b)", r"\\\1", text)
    return named.replace(r"\lam", r"\lambda").replace("*", " ")


def readable(value: fmpq_mpoly) -> str:
    """A polynomial as text with Greek letters, cut when it is long."""
    text = in_greek(str(value))
    return text if len(text) <= 160 else f"{text[:150]} ... ({len(value.to_dict())} terms)"


def rising_signs(value: fmpq_mpoly) -> bool:
    """Whether all coefficients are positive: then the polynomial is positive for positive symbols."""
    numbers = list(value.to_dict().values())
    return bool(numbers) and all(number > 0 for number in numbers)
