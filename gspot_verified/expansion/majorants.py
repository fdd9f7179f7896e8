"""Bounds on the norms of power series in (s, delta): proofs/residual.md.

The norm of f = sum of f_n(s) delta^n is |f| = sum of |c_(n,k)| S^k D^n, where f_n = sum of c_(n,k) s^k. It bounds
|f(s, delta)| for |s| <= S, |delta| <= D, and |f g| <= |f| |g|. A :class:`Graded` keeps the norms of the terms below an
order N and a bound on all the rest.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from flint import arb, fmpq

from gspot_verified.functions.expressions import (
    Constant,
    Cosine,
    Exponential,
    Expression,
    FunctionOfOne,
    Logarithm,
    Power,
    Product,
    Sine,
    Sum,
    Variable,
)
from gspot_verified.numbers.balls import hull, nonfinite

# Any choice is correct: the best of them is taken.
_RATIOS = tuple(fmpq(n, 8) for n in (9, 10, 12, 16, 20, 24, 32, 48, 64, 96, 128, 256, 512, 1024, 4096, 16384))


@dataclass(frozen=True)
class Graded:
    """``below[n]`` bounds the norm of the term of order n, delta^n included; ``rest`` that of all orders from N on."""

    below: tuple[arb, ...]
    rest: arb

    def total(self) -> arb:
        """A bound on the norm."""
        return _sum(self.below) + self.rest


def rest_of_product(left: Graded, right: Graded) -> arb:
    """A bound on the orders >= N of a product: the pairs i + j >= N with i, j < N, and all pairs with a rest."""
    ends = [arb(0)]
    for value in reversed(right.below):
        ends.append(ends[-1] + value)
    # ends[i] is the sum of right.below[N - i:], so i + j >= N for every j in it.
    pairs = _sum([value * ends[i] for i, value in enumerate(left.below)])
    return pairs + left.rest * right.total() + _sum(left.below) * right.rest


def graded_functions(
    nodes: Sequence[Expression],
    norms: dict[Expression, tuple[arb, ...]],
    starts: dict[Expression, Any],
    components: Sequence[Callable[[arb], arb]],
) -> dict[Expression, Graded]:
    """All functions of a graph without natural powers, parts before wholes.

    ``norms`` holds the norms of the terms below N, delta^n included, ``starts`` the numbers of order 0, and
    ``components[i](r)`` bounds the orders >= 1 of component i at r D in place of D; it has no order >= N.
    """
    order = len(norms[nodes[0]])
    enlarged = [(ratio, _changes(nodes, starts, components, arb(ratio))) for ratio in _ratios(nodes)]
    graded: dict[Expression, Graded] = {}
    for node in nodes:
        match node:
            case Constant() | Variable():
                rest = arb(0)
            case Sum(terms):
                rest = _sum([graded[part].rest for part in terms])
            case Product(left, right):
                rest = rest_of_product(graded[left], graded[right])
            case _:
                rest = _least([changes[node] / arb(ratio) ** order for ratio, changes in enlarged])
        graded[node] = Graded(norms[node], rest)
    return graded


def _ratios(nodes: Sequence[Expression]) -> tuple[fmpq, ...]:
    return _RATIOS if any(isinstance(node, Power | FunctionOfOne) for node in nodes) else ()


def _changes(
    nodes: Sequence[Expression],
    starts: dict[Expression, Any],
    components: Sequence[Callable[[arb], arb]],
    ratio: arb,
) -> dict[Expression, arb]:
    """Bounds on the norm of f - f_0 at ``ratio`` D; a bound that is not finite where there is none."""
    changes: dict[Expression, arb] = {}
    for node in nodes:
        match node:
            case Constant():
                change = arb(0)
            case Variable(index):
                change = components[index](ratio)
            case Sum(terms):
                change = _sum([changes[part] for part in terms])
            case Product(left, right):
                a, b = changes[left], changes[right]
                change = size_of(starts[left]) * b + a * size_of(starts[right]) + a * b
            case Power(base, exponent):
                change = _power_change(arb(starts[base]), changes[base], exponent)
            case Exponential(argument):
                change = size_of(arb(starts[argument]).exp()) * changes[argument].expm1()
            case Logarithm(argument):
                change = _logarithm_change(arb(starts[argument]), changes[argument])
            case Sine(argument) | Cosine(argument):
                change = _rotation_change(arb(starts[argument]), changes[argument], isinstance(node, Sine))
            case _:
                raise TypeError(f"no bound for {type(node).__name__}")
        changes[node] = change
    return changes


def _power_change(start: arb, change: arb, exponent: fmpq) -> arb:
    """|u_0|^r ((1 - x)^(-|r|) - 1) with x = |u - u_0| / |u_0| < 1."""
    least = start.abs_lower()
    if not least > 0:
        return nonfinite()
    x = (change / least).upper()
    if not x < 1:
        return nonfinite()
    size = arb(abs(exponent))
    both = least ** arb(exponent)
    both = hull([both, start.abs_upper() ** arb(exponent)])
    return both.abs_upper() * ((-size * (1 - x).log()).expm1())


def _logarithm_change(start: arb, change: arb) -> arb:
    """-log(1 - x) with x = |u - u_0| / |u_0| < 1."""
    least = start.lower()
    if not least > 0:
        return nonfinite()
    x = (change / least).upper()
    return -((1 - x).log()) if x < 1 else nonfinite()


def _rotation_change(start: arb, change: arb, is_sine: bool) -> arb:
    """|sin u_0| (cosh h - 1) + |cos u_0| sinh h for the sine, the roles exchanged for the cosine."""
    own, other = (start.sin(), start.cos()) if is_sine else (start.cos(), start.sin())
    return size_of(own) * (change.cosh() - 1) + size_of(other) * change.sinh()


def size_of(value: Any) -> arb:
    """An upper bound of |value|."""
    return arb(value).abs_upper()


def _sum(values: Sequence[arb]) -> arb:
    total = arb(0)
    for value in values:
        total = total + value
    return total


def _least(bounds: Sequence[arb]) -> arb:
    """The least of several upper bounds; not finite when none is finite."""
    best = nonfinite()
    for bound in bounds:
        upper = bound.upper()
        if upper.is_finite() and (not best.is_finite() or upper < best):
            best = upper
    return best
