"""Sums, products and powers of expressions in a form in which equal terms meet and cancel.

Equal terms of a sum are added, equal factors of a product are multiplied, rational numbers are computed. What is made
equals the function given wherever that is defined (x/x becomes 1). No product of sums is multiplied out, except
by a number. Short sums inside sums are opened; long ones stay, so that shared parts stay shared.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from math import isqrt

from flint import fmpq

from gspot_verified.functions.derivative import ONE, ZERO
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
from gspot_verified.mechanisms.formulas.symbol import Symbol

MAX_NUMBER_BITS = 20_000  # numerator and denominator together: a limit against powers of powers
_OPENED = 12  # terms or factors: longer sums and products count as one, any number is correct


class NoNumberError(ValueError):
    """A part of a formula without variables is no number that is worked with."""


class NumberTooLargeError(NoNumberError):
    """A rational number in a formula has too many digits."""


class NotRealError(NoNumberError):
    """A root or a logarithm of a number that has no real one: a power of the root may be real again."""


def constant(value: fmpq | int) -> Constant:
    """A rational number as an expression.

    :raises NumberTooLargeError: it has more than 20000 bits.
    """
    number = fmpq(value)
    if int(number.p).bit_length() + int(number.q).bit_length() > MAX_NUMBER_BITS:
        raise NumberTooLargeError(f"a number grows beyond {MAX_NUMBER_BITS} bits")
    return Constant(number)


def rational_value(expression: Expression) -> fmpq | None:
    """The rational number that the expression is, or None."""
    return expression.value if isinstance(expression, Constant) and isinstance(expression.value, fmpq) else None


def split(expression: Expression) -> tuple[fmpq, Expression]:
    """A rational factor and the rest."""
    value = rational_value(expression)
    if value is not None:
        return value, ONE
    if isinstance(expression, Product):
        value = rational_value(expression.left)
        if value is not None:
            return value, expression.right
    return fmpq(1), expression


def sum_of(*terms: Expression) -> Expression:
    """The sum, equal terms collected; components of the state first, the number last.

    >>> x, y = Variable(0), Variable(1)
    >>> sum_of(y, x, product_of(constant(-1), y)) == x
    True
    """
    collected: dict[frozenset[tuple[Expression, str]], tuple[fmpq, Expression]] = {}
    for coefficient, rest in _opened(terms):
        key = frozenset((base, str(exponent)) for base, exponent in _factors(rest).items())
        before, first = collected.get(key, (fmpq(0), rest))
        collected[key] = before + coefficient, first
    kept = [(c, rest) for c, rest in collected.values() if c != 0]
    made = [_scaled(c, rest) for c, rest in sorted(kept, key=lambda term: _rank(term[1]))]
    if not made:
        return ZERO
    return made[0] if len(made) == 1 else Sum(tuple(made))


def _opened(terms: Iterable[Expression]) -> list[tuple[fmpq, Expression]]:
    opened = []
    for term in terms:
        coefficient, rest = split(term)
        if isinstance(rest, Sum) and len(rest.terms) <= _OPENED:
            opened += [(coefficient * inner, part) for inner, part in map(split, rest.terms)]
        else:
            opened.append((coefficient, rest))
    return opened


def _rank(rest: Expression) -> tuple[int, int, str]:
    """The order of a sum's terms, so that angles such as a - b and b - a are recognised; other terms stay in theirs."""
    match rest:
        case Variable(index):
            return 0, index, ""
        case Symbol(name):
            return 1, 0, name
    return (3 if rest is ONE else 2), 0, ""


def product_of(*factors: Expression) -> Expression:
    """The product, equal factors collected, the rational factor in front; a number times a short sum is distributed.

    >>> x, y = Variable(0), Variable(1)
    >>> product_of(sum_of(x, y), power_of(sum_of(x, y), fmpq(-1)))
    Constant(value=1)
    """
    coefficient = fmpq(1)
    parts: list[Expression] = []
    for factor in factors:
        number, rest = split(factor)
        coefficient *= number
        if rest is not ONE:
            parts.append(rest)
    if coefficient == 0:
        return ZERO
    split_parts = [_factors(part) for part in parts]
    bases = [base for part in split_parts for base in part]
    if len(set(bases)) == len(bases):  # nothing meets: keep the parts as they are, they may be shared
        return _scaled(coefficient, _balanced(parts))
    powers: dict[Expression, fmpq] = {}
    for part in split_parts:
        for base, exponent in part.items():
            powers[base] = powers.get(base, fmpq(0)) + exponent
    return _scaled_product(coefficient, powers)


def _scaled_product(coefficient: fmpq, powers: Mapping[Expression, fmpq]) -> Expression:
    """The product of powers; a base that is a number (a root of one) is computed if it can be."""
    parts = []
    for base, exponent in powers.items():
        number, rest = split(power_of(base, exponent))
        coefficient *= number
        if rest is not ONE:
            parts.append(rest)
    return _scaled(coefficient, _balanced(parts))


def _balanced(parts: Sequence[Expression]) -> Expression:
    while len(parts) > 1:
        pairs = [Product(parts[i], parts[i + 1]) for i in range(0, len(parts) - 1, 2)]
        parts = [*pairs, *parts[len(pairs) * 2 :]]
    return parts[0] if parts else ONE


def _scaled(coefficient: fmpq, rest: Expression) -> Expression:
    if rest is ONE:
        return constant(coefficient)
    if coefficient == 1:
        return rest
    if isinstance(rest, Sum) and len(rest.terms) <= _OPENED:
        return Sum(tuple(_scaled(coefficient * inner, part) for inner, part in map(split, rest.terms)))
    return Product(constant(coefficient), rest)


def _factors(expression: Expression) -> dict[Expression, fmpq]:
    """The bases of a product with their exponents; a long product counts as one base."""
    exponents: dict[Expression, fmpq] = {}
    waiting = [expression]
    while waiting:
        node = waiting.pop()
        if isinstance(node, Product):
            waiting += [node.right, node.left]
        elif node is not ONE:
            base, exponent = (node.base, node.exponent) if isinstance(node, Power) else (node, fmpq(1))
            exponents[base] = exponents.get(base, fmpq(0)) + exponent
        if len(exponents) > _OPENED:
            return {expression: fmpq(1)}
    return exponents


def power_of(base: Expression, exponent: fmpq) -> Expression:
    """The power; an integer power of a product or a power is one of its factors.

    :raises ZeroDivisionError: a negative power of 0.
    :raises NumberTooLargeError: a number that becomes too large.
    :raises NotRealError: a root of a negative number.

    >>> power_of(product_of(constant(3), Variable(0)), fmpq(2))
    Product(left=Constant(value=9), right=Power(base=Variable(index=0), exponent=2))
    """
    if exponent == 0:
        return ONE
    if exponent == 1:
        return base
    number, rest = split(base)
    if rest is ONE:
        return _number_power(number, exponent)
    if exponent.q != 1:
        return Power(base, exponent)
    powers = {inner: power * exponent for inner, power in _factors(rest).items()}
    front = _number_power(number, exponent)
    if set(powers) == {rest}:
        return product_of(front, Power(rest, exponent))
    return product_of(front, *(power_of(inner, power) for inner, power in powers.items()))


def _number_power(number: fmpq, exponent: fmpq) -> Expression:
    """A power of a number: computed when it is rational, a node otherwise.

    >>> _number_power(fmpq(-1), fmpq(1, 2))
    Traceback (most recent call last):
    ...
    gspot_verified.mechanisms.formulas.simplify.NotRealError: a root of the negative number -1
    """
    if number == 0:
        if exponent < 0:
            raise ZeroDivisionError("division by zero")
        return ZERO
    size = max(int(number.p).bit_length(), int(number.q).bit_length())
    if (size - 1) * abs(int(exponent.p)) > MAX_NUMBER_BITS:
        raise NumberTooLargeError(f"a number grows beyond {MAX_NUMBER_BITS} bits")
    if exponent.q == 1:
        return constant(number ** int(exponent.p))
    if number < 0:
        raise NotRealError(f"a root of the negative number {number}")
    if exponent.q == 2:
        parts = [int(number.p), int(number.q)]
        roots = [isqrt(part) for part in parts]
        if all(root * root == part for root, part in zip(roots, parts, strict=True)):
            return constant(fmpq(roots[0], roots[1]) ** int(exponent.p))
    return Power(constant(number), exponent)


def sine_of(argument: Expression) -> Expression:
    """The sine, of an argument whose leading term is positive.

    >>> sine_of(-Variable(0))
    Product(left=Constant(value=-1), right=Sine(argument=Variable(index=0)))
    """
    if argument is ZERO:
        return ZERO
    if _leads_with_minus(argument):
        return product_of(constant(-1), Sine(product_of(constant(-1), argument)))
    return Sine(argument)


def cosine_of(argument: Expression) -> Expression:
    """The cosine, of an argument whose leading term is positive."""
    if argument is ZERO:
        return ONE
    return Cosine(product_of(constant(-1), argument) if _leads_with_minus(argument) else argument)


def exponential_of(argument: Expression) -> Expression:
    """The exponential."""
    return ONE if argument is ZERO else Exponential(argument)


def logarithm_of(argument: Expression) -> Expression:
    """The natural logarithm.

    :raises NotRealError: of a number that is not positive.
    """
    value = rational_value(argument)
    if value is not None and value <= 0:
        raise NotRealError(f"the logarithm of {value}")
    return ZERO if argument is ONE else Logarithm(argument)


def _leads_with_minus(argument: Expression) -> bool:
    first = argument.terms[0] if isinstance(argument, Sum) else argument
    return split(first)[0] < 0


def negative(value: Expression) -> Expression:
    """Minus the value."""
    return product_of(constant(-1), value)


def minus(left: Expression, right: Expression) -> Expression:
    """The difference."""
    return sum_of(left, negative(right))
