"""Rational functions of symbols (chi, alpha_1, ...) as a ring for expansions, exact."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx


class RationalFunction:
    """A quotient of two polynomials in the symbols, in lowest terms with a denominator of leading coefficient 1."""

    __slots__ = ("denominator", "numerator")

    def __init__(self, numerator: fmpq_mpoly, denominator: fmpq_mpoly) -> None:
        if denominator.is_zero():
            raise ZeroDivisionError("a rational function with the denominator 0")
        if not denominator.is_constant():
            common = numerator.gcd(denominator)
            numerator, denominator = numerator // common, denominator // common
        leading = denominator.leading_coefficient()
        self.numerator, self.denominator = numerator / leading, denominator / leading

    def __add__(self, other: RationalFunction) -> RationalFunction:
        if self.denominator == other.denominator:
            return RationalFunction(self.numerator + other.numerator, self.denominator)
        numerator = self.numerator * other.denominator + other.numerator * self.denominator
        return RationalFunction(numerator, self.denominator * other.denominator)

    def __neg__(self) -> RationalFunction:
        return RationalFunction(-self.numerator, self.denominator)

    def __sub__(self, other: RationalFunction) -> RationalFunction:
        return self + (-other)

    def __mul__(self, other: RationalFunction) -> RationalFunction:
        return RationalFunction(self.numerator * other.numerator, self.denominator * other.denominator)

    def __truediv__(self, other: RationalFunction) -> RationalFunction:
        return RationalFunction(self.numerator * other.denominator, self.denominator * other.numerator)

    def __pow__(self, exponent: int) -> RationalFunction:
        if exponent < 0:
            return RationalFunction(self.denominator**-exponent, self.numerator**-exponent)
        return RationalFunction(self.numerator**exponent, self.denominator**exponent)

    def __eq__(self, other: object) -> bool:
        if isinstance(other, RationalFunction):
            return bool(self.numerator == other.numerator and self.denominator == other.denominator)
        if isinstance(other, int | fmpq):
            return bool(self.numerator == other * self.denominator)
        return NotImplemented

    def __hash__(self) -> int:
        return hash(str(self))

    def constant(self) -> fmpq | None:
        """The rational number that it is, or None."""
        if not (self.numerator.is_constant() and self.denominator.is_constant()):
            return None
        return self.numerator.leading_coefficient() if not self.numerator.is_zero() else fmpq(0)

    def at(self, values: Sequence[fmpq]) -> fmpq:
        """Its value where the symbols have these values.

        :raises ZeroDivisionError: the denominator vanishes there.

        >>> ring = Symbols("chi")
        >>> (ring.symbol("chi") / (ring.symbol("chi") + ring.number(1))).at([fmpq(3)])
        3/4
        """
        return self.numerator(*values) / self.denominator(*values)

    def __str__(self) -> str:
        if self.denominator.is_one():
            return str(self.numerator)
        return f"({self.numerator})/({self.denominator})"

    __repr__ = __str__


class SymbolPolynomial:
    """A polynomial in one variable with rational functions as coefficients."""

    __slots__ = ("_coefficients",)

    def __init__(self, coefficients: Sequence[RationalFunction]) -> None:
        kept = list(coefficients)
        while kept and kept[-1].numerator.is_zero():
            kept.pop()
        self._coefficients = kept

    def length(self) -> int:
        """One more than the degree; 0 for zero."""
        return len(self._coefficients)

    def coeffs(self) -> list[RationalFunction]:
        """The coefficients, the constant one first."""
        return list(self._coefficients)

    def __add__(self, other: SymbolPolynomial) -> SymbolPolynomial:
        short, long = sorted((self._coefficients, other._coefficients), key=len)
        return SymbolPolynomial([a + b for a, b in zip(short, long, strict=False)] + long[len(short) :])

    def __neg__(self) -> SymbolPolynomial:
        return SymbolPolynomial([-value for value in self._coefficients])

    def __mul__(self, other: SymbolPolynomial | RationalFunction) -> SymbolPolynomial:
        if isinstance(other, RationalFunction):
            return SymbolPolynomial([value * other for value in self._coefficients])
        if not self._coefficients or not other._coefficients:
            return SymbolPolynomial([])
        total: list[RationalFunction | None] = [None] * (self.length() + other.length() - 1)
        for i, a in enumerate(self._coefficients):
            for j, b in enumerate(other._coefficients):
                before = total[i + j]
                total[i + j] = a * b if before is None else before + a * b
        return SymbolPolynomial([value for value in total if value is not None])

    def __eq__(self, other: object) -> bool:
        return isinstance(other, SymbolPolynomial) and self._coefficients == other._coefficients

    __hash__ = None  # type: ignore[assignment]


class Symbols:
    """Rational functions of the named symbols. Symbols are generic: what is not identically zero counts as nonzero.

    >>> ring = Symbols("chi")
    >>> chi = ring.symbol("chi")
    >>> (chi * chi - ring.number(1)) / (chi - ring.number(1))
    chi + 1
    """

    def __init__(self, *names: str) -> None:
        self._context = fmpq_mpoly_ctx.get(names, "degrevlex")
        self._generators = dict(zip(names, self._context.gens(), strict=True))
        self._one = self._context.constant(1)

    @property
    def names(self) -> tuple[str, ...]:
        """The symbols, in the order in which values of them are given."""
        return tuple(self._generators)

    def symbol(self, name: str) -> RationalFunction:
        """A symbol as a number of the ring."""
        return RationalFunction(self._generators[name], self._one)

    def number(self, value: Any) -> RationalFunction:
        """A rational, or a rational function as it is."""
        if isinstance(value, RationalFunction):
            return value
        return RationalFunction(self._context.constant(fmpq(value)), self._one)

    def polynomial(self, coefficients: Sequence[RationalFunction]) -> SymbolPolynomial:
        """A polynomial with rational functions as coefficients."""
        return SymbolPolynomial(coefficients)

    def is_zero(self, value: RationalFunction) -> bool:
        """Whether it is identically zero."""
        return bool(value.numerator.is_zero())

    def is_nonzero(self, value: RationalFunction) -> bool:
        """Whether it is not identically zero."""
        return not value.numerator.is_zero()

    def is_negative(self, value: RationalFunction) -> bool:
        """The sign of a constant; for a symbol the hypothesis is taken as given."""
        constant = value.constant()
        return constant is None or bool(constant < 0)

    def sine_cosine(self, value: RationalFunction) -> tuple[RationalFunction, RationalFunction]:
        """Only at 0.

        :raises ValueError: elsewhere.
        """
        self._must_vanish(value)
        return self.number(0), self.number(1)

    def exponential(self, value: RationalFunction) -> RationalFunction:
        """Only at 0.

        :raises ValueError: elsewhere.
        """
        self._must_vanish(value)
        return self.number(1)

    def logarithm(self, value: RationalFunction) -> RationalFunction:
        """Only at 1.

        :raises ValueError: elsewhere.
        """
        self._must_vanish(value - self.number(1))
        return self.number(0)

    def power(self, value: RationalFunction, exponent: fmpq) -> RationalFunction:
        """An integer power of what is not zero.

        :raises ValueError: the base is 0 or the exponent no integer.
        """
        if exponent.q != 1 or self.is_zero(value):
            raise ValueError("with symbols only integer powers of nonzero bases have a power series")
        return value ** int(exponent.p)

    def _must_vanish(self, value: RationalFunction) -> None:
        if not self.is_zero(value):
            raise ValueError(
                "with symbols the argument of sin, cos and exp must vanish at the point of expansion, that of log be 1"
            )
