"""A mechanism with a mass matrix, prepared; what must not depend on velocities is checked not to."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from gspot_verified.functions.derivative import ONE, ZERO, partial_derivative
from gspot_verified.functions.expressions import Expression, Variable
from gspot_verified.mechanisms.formulas.rewriting import along, simplified
from gspot_verified.mechanisms.formulas.symbol import variable_indices
from gspot_verified.mechanisms.input.mechanism import Lagrangian, Mechanism, MechanismError

Prepare = Callable[[Sequence[Expression]], list[Expression]]


@dataclass(frozen=True)
class LagrangianInput:
    """n coordinates, m components of the state (q, q', and t where it is explicit), and the functions of them.

    ``glide`` is (q', 0, 1): the rate of a function of q and t along it is the rate in time.
    """

    n: int
    m: int
    glide: tuple[Expression, ...]
    rows: tuple[tuple[Expression, ...], ...]
    forces: tuple[Expression, ...]
    constraints: tuple[Expression, ...]
    x: Expression | None
    u: Expression
    y: Expression
    mu: Expression


def lagrangian_input(mechanism: Mechanism, motion: Lagrangian, prepare: Prepare) -> LagrangianInput:
    """The functions after ``prepare``.

    :raises MechanismError: x, y, a constraint, the mass matrix or the friction coefficient depends on velocities, or
        the slip velocity does so not linearly.
    """
    n, m = len(motion.coordinates), len(mechanism.state)
    entries = [entry for row in motion.mass_matrix for entry in row]
    slip = mechanism.slip_velocity if mechanism.x is None else mechanism.x
    assert slip is not None
    first, y, mu, *rest = prepare([slip, mechanism.y, mechanism.mu, *entries, *motion.forces, *motion.constraints])
    rows = tuple(tuple(rest[i * n : (i + 1) * n]) for i in range(n))
    forces, constraints = tuple(rest[n * n : n * n + n]), tuple(rest[n * n + n :])
    glide = (*(Variable(n + i) for i in range(n)), *[ZERO] * n, *[ONE] * (m - 2 * n))
    x, u = (None, first) if mechanism.x is None else (first, along(glide, first))
    found = LagrangianInput(
        n=n, m=m, glide=glide, rows=rows, forces=forces, constraints=constraints, x=x, u=u, y=y, mu=mu
    )
    _check_velocities(mechanism.name, found)
    return found


def _check_velocities(name: str, found: LagrangianInput) -> None:
    velocities = set(range(found.n, 2 * found.n))

    def depend(functions: Sequence[Expression]) -> bool:
        return bool(variable_indices(functions) & velocities)

    if depend([found.y, *([] if found.x is None else [found.x])]):
        raise MechanismError(f"{name}: x and y must not depend on velocities")
    if depend(simplified(*(partial_derivative(found.u, i, found.m) for i in sorted(velocities)))):
        raise MechanismError(f"{name}: the slip velocity must be linear in the velocities")
    if depend(found.constraints):
        raise MechanismError(f"{name}: a constraint must not depend on velocities")
    if depend([entry for row in found.rows for entry in row]):
        raise MechanismError(f"{name}: the mass matrix must not depend on velocities")
    if depend([found.mu]):
        raise MechanismError(
            f"{name}: the friction coefficient must not depend on velocities: L_G p must vanish (Lagrangian "
            "character, Sec. 2, eq. lagrangian2), and where p = C - mu B = 0 with A C > B^2, a coefficient mu(u) gives "
            "L_G p = mu'(u) B (mu A - B) with B > 0 and mu A > B, so p' = alpha_1 + (L_G p) lambda_N would hold in "
            "the place of eq. gensys2"
        )
