"""Between expressions and sympy, for the second route (:mod:`lie_derivatives`) and for formulas given in sympy."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from flint import fmpq

from gspot_verified.functions.expressions import Constant, Expression
from gspot_verified.functions.translation import Target, translated
from gspot_verified.mechanisms.formulas.formula import parse_formula
from gspot_verified.mechanisms.formulas.names import FormulaError
from gspot_verified.mechanisms.formulas.simplify import (
    constant,
    cosine_of,
    exponential_of,
    logarithm_of,
    power_of,
    product_of,
    sine_of,
    sum_of,
)
from gspot_verified.mechanisms.formulas.symbol import PI, Symbol


def to_sympy(expression: Expression, state: Sequence[str] = ()) -> Any:
    """The expression in sympy; ``state`` names the components of the state.

    >>> from gspot_verified.functions.expressions import Sine, Variable
    >>> to_sympy(Symbol("m") * Variable(0) + Sine(Variable(1)), ("x", "y"))
    m*x + sin(y)
    """
    import sympy

    def rational(value: fmpq) -> Any:
        return sympy.Rational(int(value.p), int(value.q))

    def constant_of(value: Any) -> Any:
        return rational(value) if isinstance(value, fmpq) else _symbol(Constant(value))

    translations = translated(
        [expression],
        Target(
            variable=lambda index: sympy.Symbol(state[index]),
            constant=constant_of,
            sum=lambda parts: sympy.Add(*parts),
            product=sympy.Mul,
            power=lambda base, exponent: base ** rational(exponent),
            function=lambda name, part: getattr(sympy, name)(part),
            other=_symbol,
        ),
    )
    return translations[0]


def _symbol(node: Expression) -> Any:
    import sympy

    if not isinstance(node, Symbol):
        raise TypeError(f"no sympy form of {type(node).__name__}")
    return sympy.pi if node.name == PI else sympy.Symbol(node.name)


def from_sympy(value: Any, names: Mapping[str, Expression]) -> Expression:
    """The sympy function as an expression; ``names`` gives the expression of each of its symbols.

    :raises FormulaError: an unknown symbol, a number that is not exact, or a function that formulas do not have.

    >>> import sympy
    >>> from gspot_verified.functions.expressions import Variable
    >>> from_sympy(sympy.Symbol("x") / 2, {"x": Variable(0)})
    Product(left=Constant(value=1/2), right=Variable(index=0))
    """
    import sympy

    made: dict[Any, Expression] = {}
    for node in sympy.postorder_traversal(value):
        if node not in made:
            made[node] = _one_from_sympy(node, made, names)
    return made[value]


def _one_from_sympy(node: Any, made: Mapping[Any, Expression], names: Mapping[str, Expression]) -> Expression:
    import sympy

    parts = [made[part] for part in node.args]
    if node.is_Rational:
        return constant(fmpq(int(node.p), int(node.q)))
    if node.is_Symbol and node.name in names:
        return names[node.name]
    if node is sympy.pi:
        return Symbol(PI)
    if node is sympy.E:
        return exponential_of(constant(1))
    if node.is_Add:
        return sum_of(*parts)
    if node.is_Mul:
        return product_of(*parts)
    if node.is_Pow and node.args[1].is_Rational:
        exponent = node.args[1]
        return power_of(parts[0], fmpq(int(exponent.p), int(exponent.q)))
    if isinstance(node, sympy.sin):
        return sine_of(*parts)
    if isinstance(node, sympy.cos):
        return cosine_of(*parts)
    if isinstance(node, sympy.tan):
        return product_of(sine_of(*parts), power_of(cosine_of(*parts), fmpq(-1)))
    if isinstance(node, sympy.exp):
        return exponential_of(*parts)
    if isinstance(node, sympy.log) and len(parts) == 1:
        return logarithm_of(*parts)
    if node.is_Symbol:
        raise FormulaError(f"unknown symbol {node.name[:40]!r}")
    raise FormulaError(f"not exact, or no function of formulas: {str(node)[:80]}")


def sympy_formula(text: str, names: Mapping[str, Any]) -> Any:
    """What :func:`formula.parse_formula` reads, in sympy; ``names`` gives the sympy expression of each name.

    >>> import sympy
    >>> sympy_formula("2*x^2 - 0.1*sin(x)", {"x": sympy.Symbol("x")})
    2*x**2 - sin(x)/10
    """
    import sympy

    expression = to_sympy(parse_formula(text, {name: Symbol(name) for name in names}))
    return expression.xreplace({sympy.Symbol(name): value for name, value in names.items()})
