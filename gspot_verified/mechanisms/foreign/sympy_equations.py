"""M(q, t) q'' = f(q, q', t) + contact forces, and constraints, from what sympy.physics.mechanics has formed.

LagrangesMethod says M q'' - f = (multipliers of its constraints); these constraints are carried on.

KanesMethod says M_u u' = f_u for generalised speeds u with q' = N(q, t) u + n(q, t). Its equations are those of q,
multiplied by N^T: M_u = N^T M N. With W = N^-1, u = W (q' - n), a contact force Y λ in the equations of q is N^T Y λ in
those of u, so that

    M = W^T M_u W,    f = W^T (f_u - M_u (the rate of W (q' - n) at q'' = 0)).
"""

from __future__ import annotations

import copy
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from gspot_verified.mechanisms.foreign.exact_formulas import ExactFormulas
from gspot_verified.mechanisms.input.mechanism import MechanismError


@dataclass(frozen=True)
class SympyEquations:
    """The equations in sympy's dynamic symbols, without floats.

    ``speeds`` gives the generalised speeds that are not q' by q, q', t; ``kinematics`` gives q' by them.

    ``residual`` are the equations as they were formed, each 0 along a free motion; ``loads`` is the matrix that takes
    generalised forces on q to their right sides. In them ``unknowns`` are linear: u' or q'', and the multipliers.
    ``accelerations`` is q'' by the unknowns.
    """

    coordinates: tuple[Any, ...]
    mass_matrix: Any
    forces: Any
    constraints: tuple[Any, ...]
    speeds: dict[Any, Any]
    kinematics: dict[Any, Any]
    residual: tuple[Any, ...]
    loads: Any
    unknowns: tuple[Any, ...]
    accelerations: tuple[Any, ...]


def time_symbol() -> Any:
    """The time of all dynamic symbols."""
    from sympy.physics.mechanics import dynamicsymbols

    return dynamicsymbols._t


def sympy_equations(
    name: str, method: Any, exact: ExactFormulas, coordinates: Sequence[Any] | None = None
) -> SympyEquations:
    """The equations of a LagrangesMethod, a KanesMethod, a System, or a pair (M, f) of the ``coordinates``.

    ``exact`` sees to floats first, before anything is computed with them.

    :raises MechanismError: something else, or equations that a mechanism here cannot have; the message names what.
    """
    from sympy.physics.mechanics import KanesMethod, LagrangesMethod

    if isinstance(method, tuple) and len(method) == 2:
        if coordinates is None:
            raise MechanismError(f"{name}: for a pair (mass matrix, forces) give coordinates=[q1(t), ...]")
        return _of_pair(name, method, exact, list(coordinates))
    if coordinates is not None:
        raise MechanismError(f"{name}: coordinates= is for a pair (mass matrix, forces); the method has its own")
    method = getattr(method, "eom_method", None) or method
    if isinstance(method, LagrangesMethod):
        return _of_lagrange(name, method, exact)
    if isinstance(method, KanesMethod):
        return _of_kane(name, method, exact)
    if hasattr(method, "form_eoms"):
        raise MechanismError(f"{name}: the {type(method).__name__} has no equations yet: call form_eoms() first")
    raise MechanismError(
        f"{name}: a LagrangesMethod, a KanesMethod or a pair (mass matrix, forces) is needed, got "
        f"{type(method).__name__}"
    )


def _rates(q: Any) -> tuple[Any, Any]:
    """q' and q''."""
    return q.diff(time_symbol()), q.diff(time_symbol(), 2)


def _matrix(exact: ExactFormulas, values: Any, where: str) -> Any:
    import sympy

    return sympy.Matrix(exact.matrix(values, where))


def _column(exact: ExactFormulas, values: Any, where: str) -> Any:
    import sympy

    return sympy.Matrix(exact.vector(values, where))


def _of_pair(name: str, pair: tuple[Any, Any], exact: ExactFormulas, coordinates: list[Any]) -> SympyEquations:
    import sympy

    q = sympy.Matrix(coordinates)
    M, f = _matrix(exact, pair[0], "mass matrix"), _column(exact, pair[1], "force")
    if M.shape[0] != len(q) or f.shape[0] != len(q):
        raise MechanismError(
            f"{name}: {len(q)} coordinates, a mass matrix of {M.shape[0]} rows and {f.shape[0]} forces: as many are "
            "needed"
        )
    return _by_coordinates(name, q, M, f, (), tuple(M * _rates(q)[1] - f))


def _of_lagrange(name: str, method: Any, exact: ExactFormulas) -> SympyEquations:
    import sympy

    formed = copy.copy(method)  # the user's own stays as it is
    if formed.eom is None:
        formed.form_lagranges_equations()
    n = len(formed.q)
    holonomic = tuple(getattr(formed, "_hol_coneqs", ()))
    if len(holonomic) != len(formed.coneqs):
        raise MechanismError(
            f"{name}: {len(formed.coneqs) - len(holonomic)} of the constraints are nonholonomic (nonhol_coneqs): "
            "constraints of a mechanism are functions of q and t that vanish (hol_coneqs)"
        )
    moving = next((formula for formula in holonomic if formula.has(*_rates(formed.q)[0])), None)
    if moving is not None:
        raise MechanismError(f"{name}: hol_coneqs: a constraint must not depend on velocities, {moving} does")
    M, f = _matrix(exact, formed.mass_matrix[:, :n], "mass matrix"), _column(exact, formed.forcing, "force")
    constraints = tuple(exact(formula, f"constraint {i + 1}") for i, formula in enumerate(holonomic))
    residual = tuple(_column(exact, formed.eom, "equation of motion"))
    return _by_coordinates(name, sympy.Matrix(formed.q), M, f, constraints, residual, tuple(formed.lam_vec))


def _by_coordinates(
    name: str,
    q: Any,
    M: Any,
    f: Any,
    constraints: tuple[Any, ...],
    residual: tuple[Any, ...],
    multipliers: tuple[Any, ...] = (),
) -> SympyEquations:
    import sympy

    second = _rates(q)[1]
    if set(second) & (M.atoms(sympy.Derivative) | f.atoms(sympy.Derivative)):
        raise MechanismError(f"{name}: the equations of motion are not linear in the accelerations")
    bends = tuple(constraint.diff(time_symbol(), 2) for constraint in constraints)
    return SympyEquations(
        coordinates=tuple(q),
        mass_matrix=M,
        forces=f,
        constraints=constraints,
        speeds={},
        kinematics={},
        residual=(*residual, *bends),
        loads=sympy.eye(len(q)).col_join(sympy.zeros(len(bends), len(q))),
        unknowns=(*second, *multipliers),
        accelerations=tuple(second),
    )


def _of_kane(name: str, method: Any, exact: ExactFormulas) -> SympyEquations:
    import sympy

    _refuse_dependent(name, method)
    formed = copy.copy(method)
    if not formed._fr or not formed._frstar:  # as sympy itself asks
        if not formed.bodies:
            raise MechanismError(
                f"{name}: the KanesMethod has no equations yet: call kanes_equations(bodies, loads) first"
            )
        formed.kanes_equations()
    M_u, f_u = formed.mass_matrix, formed.forcing
    M_u, f_u = _matrix(exact, M_u, "mass matrix"), _column(exact, f_u, "force")
    q, u = sympy.Matrix(formed.q), sympy.Matrix(formed.u)
    velocities, second = _rates(q)
    by_speeds = _column(exact, [formed.kindiffdict()[velocity] for velocity in velocities], "velocity")
    N = by_speeds.jacobian(u)
    n = by_speeds.xreplace(dict.fromkeys(u, sympy.Integer(0)))
    W = _inverse(name, N)
    speeds = W * (velocities - n)
    at_rest = dict.fromkeys(second, sympy.Integer(0))
    drift = speeds.diff(time_symbol()).doit().xreplace(at_rest)
    given = dict(zip(u, speeds, strict=True))
    M_q = W.T * M_u.xreplace(given) * W
    f_q = (W.T * (f_u.xreplace(given) - M_u.xreplace(given) * drift)).expand()  # so that what cancels is gone
    if set(second) & (M_q.atoms(sympy.Derivative) | f_q.atoms(sympy.Derivative)):
        raise MechanismError(f"{name}: the equations of motion are not linear in the accelerations")
    rates = u.diff(time_symbol())
    along = dict(zip(velocities, by_speeds, strict=True))
    return SympyEquations(
        coordinates=tuple(q),
        mass_matrix=M_q,
        forces=f_q,
        constraints=(),
        speeds=given,
        kinematics=along,
        residual=tuple(M_u * rates - f_u),
        loads=N.T,
        unknowns=tuple(rates),
        accelerations=tuple(by_speeds.diff(time_symbol()).doit().xreplace(along)),
    )


def _refuse_dependent(name: str, method: Any) -> None:
    """Kane's equations with dependent coordinates or speeds are those of the independent ones alone."""
    for attribute, what in (("_qdep", "dependent coordinates"), ("_udep", "dependent speeds")):
        if len(getattr(method, attribute)):
            raise MechanismError(
                f"{name}: the KanesMethod has {what} (configuration_constraints, velocity_constraints): give the "
                "constraints to a LagrangesMethod as hol_coneqs, or leave the dependent coordinates out"
            )
    if len(method.q) != len(method.u):
        raise MechanismError(
            f"{name}: the KanesMethod has {len(method.q)} coordinates and {len(method.u)} speeds: as many are needed"
        )


def _inverse(name: str, N: Any) -> Any:
    """W with u = W (q' - n)."""
    import sympy

    if sympy.eye(N.shape[0]) == N:
        return N
    determinant = sympy.simplify(N.det(method="berkowitz"))
    if determinant == 0:
        raise MechanismError(
            f"{name}: the generalised speeds do not determine the velocities: u = W q' with no inverse"
        )
    return sympy.simplify(N.adjugate() / determinant)
