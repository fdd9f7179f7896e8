"""Polynomials in several variables whose coefficients are known within rational bounds.

Proof page: ``proofs/from_state.md``, section 8, "In balls". A monomial that no sum or product makes does not occur:
which monomials there are does not depend on the coefficients. What is exact stays exact, so that exact terms cancel.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from flint import arb, fmpq, fmpq_mpoly, fmpq_mpoly_ctx, fmpz

from gspot_verified.numbers.balls import Exact, add_remainder, ball

_FINE = fmpz(2) ** 256  # coefficients with a bound are rounded to multiples of 1/_FINE: any number is right

Exponents = tuple[int, ...]


class BallPolynomial:
    """All polynomials whose coefficients differ from those of ``middle`` by at most those of ``radius``.

    Sums, products and derivatives hold those of all polynomials in both. Numbers and exact polynomials count too.

    >>> ring = fmpq_mpoly_ctx.get(("x", "y"), "lex")
    >>> x, y = ring.gens()
    >>> root = ball_polynomial(ring, {(1, 0): arb(2).sqrt(), (0, 1): fmpq(1, 3)})
    >>> (root * root - 2 * x * x).to_dict()[2, 0].contains(0), (root - y / 3).to_dict().keys()
    (True, dict_keys([(1, 0)]))
    """

    __slots__ = ("middle", "radius")

    def __init__(self, middle: fmpq_mpoly, radius: fmpq_mpoly) -> None:
        self.middle, self.radius = middle, radius

    def context(self) -> fmpq_mpoly_ctx:
        """That of the variables."""
        return self.middle.context()

    def to_dict(self) -> dict[Exponents, Exact]:
        """The coefficients that are not certainly 0: rational where they are exact."""
        bounds = self.radius.to_dict()
        exact = {key: value for key, value in self.middle.to_dict().items() if key not in bounds}
        middles = self.middle.to_dict()
        return exact | {
            key: add_remainder(ball(middles.get(key, fmpq(0))), ball(bound)) for key, bound in bounds.items()
        }

    def is_zero(self) -> bool:
        """Whether it is certainly 0."""
        return bool(self.middle.is_zero() and self.radius.is_zero())

    def only(self, kept: Callable[..., bool]) -> BallPolynomial:
        """The terms whose exponents it keeps; their coefficients become short, where they have a bound."""
        middle, radius = (
            {key: value for key, value in part.to_dict().items() if kept(*map(int, key))}
            for part in (self.middle, self.radius)
        )
        return _rounded(self.context(), middle, radius)

    def derivative(self, variable: int) -> BallPolynomial:
        """By the variable of this number."""
        return BallPolynomial(self.middle.derivative(variable), self.radius.derivative(variable))

    def __neg__(self) -> BallPolynomial:
        return BallPolynomial(-self.middle, self.radius)

    def __add__(self, other: Any) -> BallPolynomial:
        more = _as_ball(other, self.context())
        return BallPolynomial(self.middle + more.middle, self.radius + more.radius)

    __radd__ = __add__

    def __sub__(self, other: Any) -> BallPolynomial:
        more = _as_ball(other, self.context())
        return BallPolynomial(self.middle - more.middle, self.radius + more.radius)

    def __rsub__(self, other: Any) -> BallPolynomial:
        return _as_ball(other, self.context()) - self

    def __mul__(self, other: Any) -> BallPolynomial:
        more = _as_ball(other, self.context())
        middle = self.middle * more.middle
        if self.radius.is_zero() and more.radius.is_zero():
            return BallPolynomial(middle, self.radius)
        radius = _sizes(self.middle) * more.radius + self.radius * (_sizes(more.middle) + more.radius)
        return BallPolynomial(middle, radius)

    __rmul__ = __mul__

    def __pow__(self, exponent: int) -> BallPolynomial:
        power = _as_ball(fmpq(1), self.context())
        for _ in range(exponent):
            power = power * self
        return power

    def __truediv__(self, divisor: Any) -> BallPolynomial:
        """By a number, or by an exact monomial with the coefficient 1 that divides every term.

        :raises DomainError: it does not.
        :raises ValueError: the monomial has another coefficient.
        """
        if isinstance(divisor, arb | fmpq | fmpz | int):
            return self * (1 / (divisor if isinstance(divisor, arb) else fmpq(divisor)))
        if divisor.coeffs() != [1]:  # a negative one would turn a radius
            raise ValueError(f"expected a number, or a monomial with the coefficient 1, got {divisor}")
        return BallPolynomial(self.middle / divisor, self.radius / divisor)


def ball_polynomial(ring: fmpq_mpoly_ctx, terms: Mapping[Any, Exact]) -> BallPolynomial:
    """The polynomial with these coefficients.

    :raises ValueError: one is not finite.
    """
    middle, radius = dict[Exponents, fmpq](), dict[Exponents, fmpq]()
    for key, value in terms.items():
        middle[key], radius[key] = (value, fmpq(0)) if isinstance(value, fmpq) else _ends(value)
    return _rounded(ring, middle, radius)


def polynomial_of(ring: fmpq_mpoly_ctx, terms: Mapping[Any, Exact]) -> fmpq_mpoly | BallPolynomial:
    """The polynomial with these coefficients: an exact one, where all are exact."""
    exact = {key: value for key, value in terms.items() if isinstance(value, fmpq)}
    return ring.from_dict(exact) if len(exact) == len(terms) else ball_polynomial(ring, terms)


def constant(ring: fmpq_mpoly_ctx, value: Exact) -> fmpq_mpoly | BallPolynomial:
    """The number as a polynomial."""
    return polynomial_of(ring, {(0,) * ring.nvars(): value})


def _as_ball(value: Any, ring: fmpq_mpoly_ctx) -> BallPolynomial:
    if isinstance(value, BallPolynomial):
        return value
    if isinstance(value, arb):
        return ball_polynomial(ring, {(0,) * ring.nvars(): value})
    return BallPolynomial(value if isinstance(value, fmpq_mpoly) else ring.constant(value), ring.constant(0))


def _ends(value: arb) -> tuple[fmpq, fmpq]:
    """Middle and radius; exact."""
    if not value.is_finite():
        raise ValueError("a coefficient is not finite")
    return _rational(value.mid()), _rational(value.rad())


def _rational(value: arb) -> fmpq:
    mantissa, exponent = value.man_exp()
    return fmpq(mantissa) * fmpq(2) ** int(exponent)


def _sizes(polynomial: fmpq_mpoly) -> fmpq_mpoly:
    ring = polynomial.context()
    return ring.from_dict({key: abs(value) for key, value in polynomial.to_dict().items()})


def _rounded(ring: fmpq_mpoly_ctx, middle: dict[Exponents, fmpq], radius: Mapping[Exponents, fmpq]) -> BallPolynomial:
    """The polynomial, or a larger set, with short coefficients where the bound is not 0."""
    bounds = dict[Exponents, fmpq]()
    for key, bound in radius.items():
        if bound != 0:
            middle[key] = fmpq((middle.get(key, fmpq(0)) * _FINE).floor(), _FINE)
            bounds[key] = fmpq((bound * _FINE).ceil() + 1, _FINE)
    return BallPolynomial(ring.from_dict(middle), ring.from_dict(bounds))
