"""The period of a function of the state in one of its components, read off its graph.

Where a component stands in sines and cosines of rational multiples of it only, the function is periodic.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import gcd, lcm

from flint import fmpq

from gspot_verified.functions.expressions import Expression
from gspot_verified.functions.straight_line import StraightLine


def period_factor(functions: Sequence[Expression], index: int) -> fmpq | None:
    """A rational r such that all the functions have the period 2 pi r in this component; None when none is seen.

    None also when no function depends on the component. r > 0 need not give the least period.

    >>> from gspot_verified.functions.expressions import Constant, Cosine, Sine, Variable
    >>> x = Variable(0)
    >>> period_factor([Sine(Constant(fmpq(1, 2)) * x), Cosine(x) * x], 0) is None
    True
    >>> period_factor([Sine(Constant(fmpq(1, 2)) * x), Cosine(x)], 0)
    2
    """
    code = StraightLine()
    rates: list[fmpq] = []
    for function in functions:
        function_rates = _rates(code, code.value(function), index)
        if function_rates is None:
            return None
        rates += function_rates
    if not rates:
        return None
    # All rates are integer multiples of ``common``, so 2 pi/common is a period.
    denominator = lcm(*(int(rate.q) for rate in rates))
    numerator = gcd(*(int(rate.p) * denominator // int(rate.q) for rate in rates))
    return fmpq(denominator, numerator) if numerator else None


def _rates(code: StraightLine, root: str, index: int) -> list[fmpq] | None:
    """The rates of the component in the arguments of sines and cosines; None when it also stands elsewhere.

    A value is either independent of the component, or affine in it with a rational slope, or periodic in it.
    """
    affine: dict[str, fmpq] = {}
    rates: list[fmpq] = []
    for name in code.needed([root]):
        operation, _ = code.definition(name)
        inner = [part for part in code.operands(name) if part in affine]
        slope_name = code.slope(name, index)
        if operation == "variable":
            if slope_name is not None:
                affine[name] = fmpq(1)
        elif operation == "sine and cosine":
            rates += [affine[part] for part in inner]
        elif inner:
            slope = code.number(slope_name) if slope_name is not None else None
            if slope is None:
                return None
            affine[name] = slope
    return None if root in affine else rates
