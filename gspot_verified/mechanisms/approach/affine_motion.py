"""Mechanisms whose alpha_1, alpha_2, alpha_3 depend on p, b, y, v alone, and their explicit epsilon_0 from a state.

Proof page: ``proofs/from_state.md``, section 8. That they are such functions is an identity of rational functions of
the components and of the roots, sines, cosines, exponentials and logarithms that occur.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from gspot_verified.expansion.from_state.affine_side import affine_side
from gspot_verified.expansion.from_state.affine_system import Affine, AffineSystem, holds_integer
from gspot_verified.expansion.from_state.analytic import Analytic
from gspot_verified.functions.expressions import (
    Constant,
    Expression,
    FunctionOfOne,
    Power,
    Product,
    Sum,
    Variable,
    in_order,
)
from gspot_verified.functions.translation import Target, translated
from gspot_verified.mechanisms.approach.mechanism_side import MechanismSide
from gspot_verified.mechanisms.approach.slip_state import StateInput
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.formulas.rewriting import replaced
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.spot_conditions import components_of
from gspot_verified.numbers.balls import exact

_ORDER = 4  # of what a Taylor polynomial of an alpha leaves: any from 2 on is right


def with_explicit(found: MechanismSide, mechanism: Mechanism, start: StateInput) -> MechanismSide:
    """The same with ``explicit``, where the alphas are functions of p, b, y, v that are analytic at the G-spot, and
    these are components, p and b given by the state as rational numbers."""
    if found.side is None:
        return found
    try:
        known = affine_system_of(mechanism)
        if known is None or not all(name in start for name in known[0]):
            return found
        side = affine_side(known[1], *(exact(start[name], name) for name in known[0]))
    except ValueError:  # a formula, or beside the theorem: nothing is said
        return found
    return replace(found, explicit=side)


def affine_system_of(mechanism: Mechanism) -> tuple[tuple[str, str], AffineSystem] | None:
    """The names of p and b among the components, and the alphas as functions of p, b, y, v; None if they are not. y and
    v must be components where an alpha depends on them.

    An angle with a reference is none of them: its value in a state is not the one that the functions count.

    :raises ValueError: an alpha is not analytic at p = b = 0.
    """
    functions = shift(mechanism).functions
    alphas = functions.alpha_1, functions.alpha_2, functions.alpha_3
    fractions = _fractions((functions.p, functions.b, functions.y, functions.v, *alphas), len(mechanism.state))
    if fractions is None:
        return None
    generators = fractions.variables
    places = [generators.index(one) if one in generators else None for one in fractions.polynomials[:4]]
    p, b, y, v = places
    if p is None or b is None:
        return None
    first, second, third = (fractions.of_state(k, p, b, y, v) for k in (4, 5, 6))
    if first is None or second is None or third is None:
        return None
    if not (first.value < 0 and second.value < 0 and third.value < first.value):
        return None
    if holds_integer(third.value / first.value):  # beta is an integer: the reference has a logarithm
        return None
    names = mechanism.state[p], mechanism.state[b]
    if any(angle.coordinate in names for angle in mechanism.angles):
        return None
    return names, AffineSystem(first, second, third, mechanism.regularisation)


@dataclass(frozen=True)
class _Fractions:
    """Functions as quotients in lowest terms of polynomials in the components and in ``atoms``, one after the other."""

    variables: tuple[fmpq_mpoly, ...]
    atoms: tuple[Expression, ...]
    quotients: tuple[tuple[fmpq_mpoly, fmpq_mpoly], ...]

    @property
    def polynomials(self) -> list[fmpq_mpoly | None]:
        """Those that are polynomials."""
        return [above / below.leading_coefficient() if below.is_constant() else None for above, below in self.quotients]

    def of_state(self, number: int, p: int, b: int, y: int | None, v: int | None) -> Affine | Analytic | None:
        """The function as one of p, b, y, v, which are these components; None if it depends, or may depend, on
        others."""
        above, below = self.quotients[number]
        known = {place: k for k, place in enumerate((p, b, y, v)) if place is not None}
        table: dict[Expression, Expression] = {Variable(place): Variable(k) for place, k in known.items()}
        components: list[Expression] = [Variable(i) for i in range(len(self.variables))]
        generators = [*components, *self.atoms]
        used = [i for i, power in enumerate(zip(above.degrees(), below.degrees(), strict=True)) if any(power)]
        if any(components_of(generators[i]) - set(known) for i in used):
            return None
        affine = _affine(self.polynomials[number], p, b)
        if affine is not None:
            return affine
        quotient = _expression(above, generators) / _expression(below, generators)
        (function,) = replaced([quotient], table)
        return Analytic(function, _ORDER, translated([function], _WORDS)[0])


def _affine(polynomial: fmpq_mpoly | None, p: int, b: int) -> Affine | None:
    if polynomial is None:
        return None
    terms = polynomial.to_dict()
    keys = [tuple(int(i == place) for i in range(polynomial.context().nvars())) for place in (-1, p, b)]
    value, by_p, by_b = (terms.pop(key, fmpq(0)) for key in keys)
    return None if terms else Affine(fmpq(value), fmpq(by_p), fmpq(by_b))


def _expression(polynomial: fmpq_mpoly, generators: Sequence[Expression]) -> Expression:
    terms = list[Expression]()
    for exponents, value in polynomial.to_dict().items():
        term: Expression = Constant(fmpq(value))
        for base, exponent in zip(generators, exponents, strict=True):
            if exponent:
                term = term * Power(base, fmpq(int(exponent)))
        terms.append(term)
    return Sum(tuple(terms))


_NAMES = ("p", "b", "y", "v")
_WORDS = Target(
    variable=_NAMES.__getitem__,
    constant=lambda value: f"({value})" if value < 0 or value.q != 1 else str(value),
    sum=lambda parts: f"({' + '.join(parts)})",
    product="{}*{}".format,
    power=lambda base, exponent: f"{base if base in _NAMES else f'({base})'}^({exponent})",
    function="{}({})".format,
)


def _fractions(functions: Sequence[Expression], dimension: int) -> _Fractions | None:
    """The functions as quotients; None if one holds what is no number, or divides by zero."""
    nodes = in_order(functions)
    atoms = [node for node in nodes if isinstance(node, FunctionOfOne) or _is_root(node)]
    names = (*(f"x{i}" for i in range(dimension)), *(f"f{i}" for i in range(len(atoms))))
    ring = fmpq_mpoly_ctx.get(names, Ordering.lex)
    generators, one = ring.gens(), ring.constant(1)
    own = dict(zip(atoms, generators[dimension:], strict=True))
    made: dict[Expression, tuple[fmpq_mpoly, fmpq_mpoly]] = {}
    for node in nodes:
        quotient = (own[node], one) if node in own else _quotient(node, made, generators, one)
        if quotient is None:
            return None
        made[node] = quotient
    return _Fractions(generators[:dimension], tuple(atoms), tuple(_reduced(*made[one]) for one in functions))


def _is_root(node: Expression) -> bool:
    return isinstance(node, Power) and node.exponent.q != 1


def _quotient(
    node: Expression,
    made: Mapping[Expression, tuple[fmpq_mpoly, fmpq_mpoly]],
    generators: Sequence[fmpq_mpoly],
    one: fmpq_mpoly,
) -> tuple[fmpq_mpoly, fmpq_mpoly] | None:
    match node:
        case Constant(value) if isinstance(value, fmpq):
            return one * value, one
        case Variable(index):
            return generators[index], one
        case Sum(terms):
            above, below = 0 * one, one
            for term in terms:
                other, divisor = made[term]
                above, below = above * divisor + other * below, below * divisor
            return above, below
        case Product(left, right):
            return made[left][0] * made[right][0], made[left][1] * made[right][1]
        case Power(base, exponent):
            above, below = made[base] if exponent >= 0 else made[base][::-1]
            return None if below.is_zero() else (above ** abs(int(exponent)), below ** abs(int(exponent)))
        case _:
            return None


def _reduced(above: fmpq_mpoly, below: fmpq_mpoly) -> tuple[fmpq_mpoly, fmpq_mpoly]:
    common = above.gcd(below)
    return above // common, below // common
