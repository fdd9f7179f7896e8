"""What a mechanism's G-spot satisfies, as functions of the state and of some of its parameters."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from gspot_verified.functions.expressions import Expression, Logarithm, Power, Sum, Variable, in_order
from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.derive.to_system import Shifted, shift
from gspot_verified.mechanisms.formulas.rewriting import replaced
from gspot_verified.mechanisms.formulas.symbol import Symbol, symbol_names, variable_indices
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.spots.g_spot import shifted_conditions, symbolic_place
from gspot_verified.numbers.balls import working_bits

_CONSTANT_BITS = 320  # far more than a sweep works with, so that constants are not what makes balls wide


@dataclass(frozen=True)
class ParametricSystem:
    """Functions of (ξ, λ): the state ξ (components 0, ..., m - 1, angles from their references), then the parameters.

    ``conditions`` are p, b, y, v, J, which vanish at a G-spot; ``matrix`` must be positive definite there (the mass
    matrix; or A, B, B, C where none is given) and ``friction`` not negative. ``slip`` is u. ``domain`` has a value
    where all formulas of these parameters have one: what is derived from them may have lost a divisor or a root.
    """

    name: str
    state: tuple[str, ...]
    parameters: tuple[str, ...]
    conditions: tuple[Expression, ...]
    alpha_1: Expression
    alpha_2: Expression
    alpha_3: Expression
    slip: Expression
    matrix: tuple[tuple[Expression, ...], ...]
    friction: Expression
    domain: Expression

    @property
    def dimension(self) -> int:
        """The number of components of the state."""
        return len(self.state)


def parametric_system(mechanism: Mechanism, parameters: Sequence[str], fixed: Sequence[str] = ()) -> ParametricSystem:
    """The functions with these parameters as further variables; all others have the mechanism's values.

    ``fixed`` names the components that keep the value of the mechanism's place, where it gives no conditions J.

    :raises MechanismError: no such parameter, or another one has no value; or the Lagrangian character is violated.

    >>> from gspot_verified.mechanisms.shipped import shipped_mechanism
    >>> rod = parametric_system(shipped_mechanism("genot_brogliato_rod"), ["mu"], ["X", "X_dot"])
    >>> rod.friction, len(rod.conditions)
    (Variable(index=6), 6)
    """
    free = mechanism.with_parameters(**dict.fromkeys(parameters))
    missing = [name for name, value in free.parameters if value is None and name not in parameters]
    if missing:
        raise MechanismError(f"{mechanism.name}: parameters without a value: {', '.join(missing)}")
    shifted = shift(free, free=True)
    f = shifted.functions
    conditions = [f.p, f.b, f.y, f.v, *_extra_conditions(shifted, fixed)]
    scalars = [f.alpha_1, f.alpha_2, f.alpha_3, f.u, f.mu, Sum(tuple(partial_functions(free, parameters)))]
    with working_bits(_CONSTANT_BITS):
        own_variables = {name: Variable(len(mechanism.state) + j) for j, name in enumerate(parameters)}
        expressions = shifted.expressions(
            [*conditions, *scalars, *(entry for row in f.inertia for entry in row)], BALLS, own_variables
        )
    own, (first, second, third, slip, friction, domain, *entries) = (
        expressions[: len(conditions)],
        expressions[len(conditions) :],
    )
    size = len(f.inertia)
    matrix = tuple(tuple(entries[i * size : (i + 1) * size]) for i in range(size))
    return ParametricSystem(
        name=mechanism.name,
        state=mechanism.state,
        parameters=tuple(parameters),
        conditions=tuple(own),
        alpha_1=first,
        alpha_2=second,
        alpha_3=third,
        slip=slip,
        matrix=matrix,
        friction=friction,
        domain=domain,
    )


def partial_functions(free: Mechanism, parameters: Sequence[str]) -> list[Expression]:
    """The divisors (as inverses), roots and logarithms of these parameters alone in the formulas, as they stand there.

    >>> from gspot_verified.mechanisms.shipped import shipped_mechanism
    >>> oscillator = shipped_mechanism("frictional_impact_oscillator_all_parameters")
    >>> partial_functions(oscillator.with_parameters(g=None), ["g"])
    []
    """
    table: dict[Expression, Expression] = {Symbol(name): value for name, value in free.parameter_values().items()}
    formulas = [value for _, value in free.parameters if value is not None]
    found: list[Expression] = []
    for node in in_order([*formulas, *free.formulas]):
        if not isinstance(node, Power | Logarithm) or (isinstance(node, Power) and node.is_natural):
            continue
        (argument,) = replaced(node.parts(), table)
        if symbol_names([argument]) & {*parameters} and not variable_indices([argument]):
            found.append(Power(argument, node.exponent) if isinstance(node, Power) else Logarithm(argument))
    return found


def _extra_conditions(shifted: Shifted, fixed: Sequence[str]) -> list[Expression]:
    """The m - 4 conditions J as functions of the shifted state and the parameters."""
    mechanism = shifted.mechanism
    given = mechanism.place.conditions
    wanted = len(mechanism.state) - 4
    if given is not None:
        conditions = shifted_conditions(shifted)
    else:
        place = symbolic_place(shifted)
        own = [Variable(mechanism.state.index(word)) - place[word] for word in fixed]
        conditions = [*shifted.constraints, *own]
    if len(conditions) != wanted:
        raise MechanismError(f"{mechanism.name}: {wanted} conditions J are needed, got {len(conditions)}")
    return conditions
