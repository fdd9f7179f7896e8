"""Mechanisms whose alpha_1, alpha_2, alpha_3 are affine in p and b, and their explicit epsilon_0 from a state.

Proof page: ``proofs/from_state.md``, section 8. That they are affine is an identity of rational functions.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from gspot_verified.expansion.from_state.affine_side import affine_side
from gspot_verified.expansion.from_state.affine_system import Affine, AffineSystem
from gspot_verified.functions.expressions import (
    Constant,
    Expression,
    Power,
    Product,
    Sum,
    Variable,
    in_order,
)
from gspot_verified.mechanisms.approach.mechanism_side import MechanismSide
from gspot_verified.mechanisms.approach.slip_state import StateInput
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.numbers.balls import exact


def with_explicit(found: MechanismSide, mechanism: Mechanism, start: StateInput) -> MechanismSide:
    """The same with ``explicit``, where the alphas are affine in p and b, which are components that the state gives as
    rational numbers."""
    if found.side is None:
        return found
    affine = affine_system_of(mechanism)
    if affine is None:
        return found
    names, system = affine
    if not all(name in start for name in names):
        return found
    try:
        side = affine_side(system, *(exact(start[name], name) for name in names))
    except ValueError:  # a formula, or beside the theorem: nothing is said
        return found
    return replace(found, explicit=side)


def affine_system_of(mechanism: Mechanism) -> tuple[tuple[str, str], AffineSystem] | None:
    """The names of p and b among the components, and the alphas as affine functions of them; None if they are not.

    An angle with a reference is none of them: its value in a state is not the one that the functions count.
    """
    functions = shift(mechanism).functions
    wanted = (functions.p, functions.b, functions.alpha_1, functions.alpha_2, functions.alpha_3)
    polynomials = _polynomials(wanted, len(mechanism.state))
    if polynomials is None:
        return None
    generators = polynomials[0].context().gens()
    places = [generators.index(one) for one in polynomials[:2] if one in generators]
    if len(places) != 2:
        return None
    affine = [_affine(one, places[0], places[1]) for one in polynomials[2:]]
    first, second, third = affine
    if first is None or second is None or third is None:
        return None
    if not (first.value < 0 and second.value < 0 and third.value < first.value):
        return None
    if (third.value / first.value).q == 1:  # beta is an integer: the reference has a logarithm
        return None
    names = mechanism.state[places[0]], mechanism.state[places[1]]
    if any(angle.coordinate in names for angle in mechanism.angles):
        return None
    return names, AffineSystem(first, second, third, mechanism.regularisation)


def _affine(polynomial: fmpq_mpoly, p: int, b: int) -> Affine | None:
    terms = polynomial.to_dict()
    keys = [tuple(int(i == place) for i in range(polynomial.context().nvars())) for place in (-1, p, b)]
    value, by_p, by_b = (terms.pop(key, fmpq(0)) for key in keys)
    return None if terms else Affine(fmpq(value), fmpq(by_p), fmpq(by_b))


def _polynomials(functions: Sequence[Expression], dimension: int) -> list[fmpq_mpoly] | None:
    """The functions as polynomials of the state with rational coefficients; None if one is not."""
    ring = fmpq_mpoly_ctx.get(tuple(f"x{i}" for i in range(dimension)), Ordering.lex)
    one = ring.constant(1)
    made: dict[Expression, tuple[fmpq_mpoly, fmpq_mpoly]] = {}
    for node in in_order(functions):
        match node:
            case Constant(value) if isinstance(value, fmpq):
                made[node] = (ring.constant(value), one)
            case Variable(index):
                made[node] = (ring.gens()[index], one)
            case Sum(terms):
                above, below = ring.constant(0), one
                for term in terms:
                    other, divisor = made[term]
                    above, below = above * divisor + other * below, below * divisor
                made[node] = (above, below)
            case Product(left, right):
                made[node] = (made[left][0] * made[right][0], made[left][1] * made[right][1])
            case Power(base, exponent) if exponent.q == 1:
                above, below = made[base] if exponent >= 0 else made[base][::-1]
                if below.is_zero():
                    return None
                made[node] = (above ** abs(int(exponent)), below ** abs(int(exponent)))
            case _:
                return None
    divided = [divmod(made[function][0], made[function][1]) for function in functions]
    return [quotient for quotient, _ in divided] if all(rest.is_zero() for _, rest in divided) else None
