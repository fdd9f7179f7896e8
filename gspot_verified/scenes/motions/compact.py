"""Equations with fewer operations: sums that differ by a rational factor are one, and equal factors meet across them.

Every expression is a rational number times a core; a sum's core has 1 as the factor of its first term. What is made
equals the function given wherever that is defined (x/x becomes 1).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from flint import fmpq

from gspot_verified.functions.derivative import ONE, ZERO
from gspot_verified.functions.expressions import (
    Constant,
    Expression,
    Power,
    Product,
    Sum,
    in_order,
)
from gspot_verified.scenes.equations.scaled_system import operations

_LONGEST_PRODUCT = 12  # bases of a product that is opened; a longer one counts as one base
Scaled = tuple[fmpq, Expression]


def compact(roots: Sequence[Expression]) -> dict[Expression, Expression]:
    """For each root the same function, all of them together with fewer operations if that was possible.

    >>> from gspot_verified.functions.expressions import Variable
    >>> x, y = Variable(0), Variable(1)
    >>> two, minus = Constant(fmpq(2)), Constant(fmpq(-1))
    >>> list(compact([Sum((two * x, two * y)) / Sum((minus * x, minus * y))]).values())
    [Constant(value=-2)]
    """
    made = _Compaction().all(roots)
    return made if operations(list(made.values())) < operations(roots) else {root: root for root in roots}


class _Compaction:
    def __init__(self) -> None:
        self._made: dict[Expression, Scaled] = {}
        self._rank: dict[Expression, int] = {}

    def all(self, roots: Sequence[Expression]) -> dict[Expression, Expression]:
        for node in in_order(roots):
            factor, core = self._one(node)
            self._rank.setdefault(core, len(self._rank))
            self._made[node] = factor, core
        return {root: _times(*self._made[root]) for root in roots}

    def _one(self, node: Expression) -> Scaled:
        match node:
            case Constant(fmpq() as value):
                return value, ONE
            case Sum(terms):
                return self._sum([self._made[term] for term in terms])
            case Product(left, right):
                (first, one), (second, other) = self._made[left], self._made[right]
                return (first * second, _product(one, other)) if first * second != 0 else (fmpq(0), ONE)
            case Power(base, exponent):
                factor, core = self._made[base]
                if exponent.q == 1 and factor != 0:
                    return factor ** int(exponent.p), _power(core, exponent)
                return fmpq(1), Power(_times(factor, core), exponent)
        if len(node.parts()) == 1:
            return fmpq(1), replace(node, argument=_times(*self._made[node.parts()[0]]))  # type: ignore[call-arg]
        return fmpq(1), node

    def _sum(self, terms: Sequence[Scaled]) -> Scaled:
        factors: dict[Expression, fmpq] = {}
        for factor, core in terms:
            factors[core] = factors.get(core, fmpq(0)) + factor
        kept = sorted(
            ((core, factor) for core, factor in factors.items() if factor != 0),
            key=lambda term: self._rank.get(term[0], -1),
        )
        if not kept:
            return fmpq(0), ONE
        first = kept[0][1]
        if len(kept) == 1:
            return first, kept[0][0]
        return first, Sum(tuple(_times(factor / first, core) for core, factor in kept))


def _times(factor: fmpq, core: Expression) -> Expression:
    if factor == 0:
        return ZERO
    if core is ONE:
        return Constant(factor)
    return core if factor == 1 else Product(Constant(factor), core)


def _power(core: Expression, exponent: fmpq) -> Expression:
    if core is ONE or exponent == 1:
        return core
    return ONE if exponent == 0 else Power(core, exponent)


def _product(left: Expression, right: Expression) -> Expression:
    """The product of two cores: kept as it is where no factor of the one is cancelled by one of the other."""
    if left is ONE or right is ONE:
        return right if left is ONE else left
    first, second = _factors(left), _factors(right)
    if not any(first[base] + second[base] == 0 for base in set(first) & set(second)):
        return Product(left, right)
    powers = {base: first.get(base, fmpq(0)) + second.get(base, fmpq(0)) for base in {**first, **second}}
    parts = [_power(base, exponent) for base, exponent in powers.items() if exponent != 0]
    product: Expression = ONE
    for part in parts:
        product = part if product is ONE else Product(product, part)
    return product


def _factors(core: Expression) -> Mapping[Expression, fmpq]:
    """The bases of a product with their exponents; a long product counts as one."""
    exponents: dict[Expression, fmpq] = {}
    waiting = [core]
    while waiting:
        node = waiting.pop()
        if isinstance(node, Product):
            waiting += [node.right, node.left]
            continue
        base, exponent = (node.base, node.exponent) if isinstance(node, Power) else (node, fmpq(1))
        exponents[base] = exponents.get(base, fmpq(0)) + exponent
        if len(exponents) > _LONGEST_PRODUCT:
            return {core: fmpq(1)}
    return exponents
