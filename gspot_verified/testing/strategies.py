"""Hypothesis strategies for systems with a G-spot at which Theorem 1 holds, and for states near it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from flint import fmpq

from gspot_verified.expansion.series.system import System
from gspot_verified.functions.derivative import plus, times
from gspot_verified.functions.expressions import (
    Constant,
    Cosine,
    Exponential,
    Expression,
    Power,
    Product,
    Sine,
    Variable,
)
from gspot_verified.testing.examples import sheared

if TYPE_CHECKING:
    from hypothesis.strategies import DrawFn, SearchStrategy

_MAX_TERMS = 3  # of a drawn polynomial: small cases shrink and run fast
_RADIUS = fmpq(1, 16)  # of the states around the G-spot


def _strategies() -> Any:
    try:
        import hypothesis.strategies
    except ImportError as error:
        raise ImportError("the strategies of gspot_verified.testing need hypothesis: pip install hypothesis") from error
    return hypothesis.strategies


def rationals(most: int = 3, denominators: int = 3) -> SearchStrategy[fmpq]:
    """Small rationals."""
    st = _strategies()
    strategy: SearchStrategy[fmpq] = st.builds(fmpq, st.integers(-most, most), st.integers(1, denominators))
    return strategy


def polynomials(variables: list[int], constant: bool = False, lowest: int = 1) -> SearchStrategy[Expression]:
    """Polynomials of degree 2 or 3 in the components ``variables`` of the state, with few terms."""
    st = _strategies()

    def build(draw: DrawFn) -> Expression:
        terms: list[Expression] = []
        for _ in range(draw(st.integers(0, _MAX_TERMS)) if variables else 0):
            degree = draw(st.integers(lowest, 2))
            term: Expression = Constant(draw(rationals()))
            for _ in range(degree):
                term = times(term, Variable(draw(st.sampled_from(variables))))
            terms.append(term)
        if variables and draw(st.booleans()):
            base = Variable(draw(st.sampled_from(variables)))
            terms.append(Product(Constant(draw(rationals())), Power(base, fmpq(draw(st.integers(2, 3))))))
        if constant:
            terms.append(Constant(draw(rationals())))
        return plus(*terms)

    strategy: SearchStrategy[Expression] = st.composite(build)()
    return strategy


def systems(max_dimension: int = 6, analytic: bool = False) -> SearchStrategy[System]:
    """Systems with polynomial right sides (``analytic``: also sin, cos, exp and a root), a G-spot, and beta no integer.

    In the coordinates (y, v, p, b, ...) the structure of eqs. lagrangian1, lagrangian2 reads y' = v,
    v' = b + p lambda_N, p' = alpha_1, b' = alpha_2 - alpha_3 lambda_N, with any functions alpha_i and any other
    equations. Such a system is drawn, and then written in other coordinates.

    >>> from hypothesis import given, settings
    >>> from gspot_verified.testing import check_expansion
    >>> @settings(max_examples=3, database=None)
    ... @given(systems())
    ... def laws_hold(system):
    ...     check_expansion(system, 6)
    >>> laws_hold()
    """
    st = _strategies()

    def build(draw: DrawFn) -> System:
        dimension = draw(st.integers(4, max_dimension))
        everything = list(range(dimension))
        x = [Variable(i) for i in everything]
        alpha_1 = -abs(draw(rationals().filter(bool)))
        whole, denominator = draw(st.integers(0, 4)), draw(st.integers(2, 5))
        beta = whole + fmpq(draw(st.integers(1, denominator - 1)), denominator)
        first, second, third = (
            plus(Constant(value), draw(polynomials(everything)))
            for value in (alpha_1, draw(rationals()), alpha_1 * beta)
        )
        if analytic:
            first = plus(first, draw(_analytic(everything)))
        zero = Constant(fmpq(0))
        others = range(4, dimension)
        system = System(
            "drawn",
            F=(x[1], x[3], first, second, *(draw(polynomials(everything, constant=True)) for _ in others)),
            G=(zero, x[2], zero, -third, *(draw(polynomials(everything, constant=True)) for _ in others)),
            y=x[0],
            v=x[1],
            p=x[2],
            b=x[3],
            alpha_1=first,
            alpha_2=second,
            alpha_3=third,
            J=tuple(
                plus(x[i], draw(polynomials([0, 1, 2, 3])), draw(polynomials(everything, lowest=2))) for i in others
            ),
            point=(fmpq(0),) * dimension,
        )
        for _ in range(draw(st.integers(0, 2))):
            index = draw(st.sampled_from(everything))
            rest = [i for i in everything if i != index]
            shift = draw(_analytic(rest)) if analytic else draw(polynomials(rest, constant=True))
            system = sheared(system, index, shift)
        return system

    strategy: SearchStrategy[System] = st.composite(build)()
    return strategy


def _analytic(variables: list[int]) -> SearchStrategy[Expression]:
    """Functions that vanish at 0 and have rational power series there."""
    st = _strategies()

    def make(kind: int, factor: fmpq, i: int, j: int) -> Expression:
        inner = times(Constant(factor), Variable(i))
        one = Constant(fmpq(1))
        functions = (
            Sine(inner),
            plus(Cosine(inner), Constant(fmpq(-1))),
            plus(Exponential(inner), Constant(fmpq(-1))),
            plus(Power(plus(one, inner), fmpq(-1, 2)), Constant(fmpq(-1))),
        )
        return functions[kind] * plus(one, Variable(j))

    index = st.sampled_from(variables)
    strategy: SearchStrategy[Expression] = st.builds(make, st.integers(0, 3), rationals(), index, index)
    return strategy


def states(system: System, radius: fmpq = _RADIUS) -> SearchStrategy[tuple[fmpq, ...]]:
    """States whose components differ by at most ``radius`` from those of a rational G-spot."""
    st = _strategies()
    offset = st.integers(-64, 64).map(lambda step: radius * fmpq(step, 64))
    strategy: SearchStrategy[tuple[fmpq, ...]] = st.tuples(
        *(offset.map(lambda change, start=value: start + change) for value in system.point)
    )
    return strategy
