"""The functions of Sec. 2 by sympy: a second route, independent of :mod:`derivation`, and proofs of identities.

u = L_F x, v = L_F y, a = L_F u, b = L_F v, A = L_GT u, B = L_GN u = L_GT v, C = L_GN v. In positive slip
λ_T = -μ λ_N, so G = G_N - μ G_T, p = C - μ B = L_G v, α_1 = L_F p, α_2 = L_F b, α_3 = -L_G b.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from gspot_verified.functions.expressions import Expression
from gspot_verified.mechanisms.derive.derived import Derived
from gspot_verified.mechanisms.formulas.in_sympy import to_sympy
from gspot_verified.mechanisms.input.mechanism import Lagrangian, Mechanism, MechanismError

MAX_OPERATIONS = 10_000  # of b and p in sympy; a fifth for u and v: a limit against endless derivatives


def lie_derivative(field: Sequence[Any], function: Any, state: Sequence[Any]) -> Any:
    """The derivative of the function along the field.

    >>> import sympy
    >>> y, v = sympy.symbols("y v")
    >>> lie_derivative((v, -1), y**2, (y, v))
    2*v*y
    """
    import sympy

    terms = [f * sympy.diff(function, s) for f, s in zip(field, state, strict=True) if f != 0 and function.has(s)]
    return sympy.Add(*terms)


def derive(mechanism: Mechanism, substitute: bool = True) -> Derived[Any]:
    """All functions of Sec. 2 in sympy; with ``substitute`` the values of the parameters are put in first.

    :raises MechanismError: the mass matrix is singular for every state, or the functions are too large.

    >>> from gspot_verified.mechanisms.input.given import lagrangian
    >>> drop = lagrangian("drop", ["x", "y"], [[2, 0], [0, 2]], [0, "-2*g"], "x", "y", "1/2", {"g": 1})
    >>> derived = derive(drop)
    >>> derived.v, derived.b, derived.p
    (y_dot, -1, 1/2)
    """
    read = Reader(mechanism, substitute)
    y, mu = read.all((mechanism.y, mechanism.mu))
    x = None if mechanism.x is None else read(mechanism.x)
    slip = None if mechanism.slip_velocity is None else read(mechanism.slip_velocity)
    state = mechanism.symbols
    motion = mechanism.motion
    rows: tuple[tuple[Any, ...], ...] | None = None
    if isinstance(motion, Lagrangian):
        rows = tuple(read.all(row) for row in motion.mass_matrix)
        F, G_T, G_N = _lagrangian_fields(mechanism, motion, rows, (x, slip, y), read)
    else:
        F, G_T, G_N = (read.all(vector) for vector in (motion.F, motion.G_T, motion.G_N))
    G = tuple(n - mu * t for n, t in zip(G_N, G_T, strict=True))
    u, v = slip if x is None else lie_derivative(F, x, state), lie_derivative(F, y, state)
    _limit(mechanism, MAX_OPERATIONS // 5, u=u, v=v)
    a, b = lie_derivative(F, u, state), lie_derivative(F, v, state)
    A, B, C = lie_derivative(G_T, u, state), lie_derivative(G_N, u, state), lie_derivative(G_N, v, state)
    p = lie_derivative(G, v, state)
    _limit(mechanism, MAX_OPERATIONS, b=b, p=p)
    alpha_1, alpha_2, alpha_3 = lie_derivative(F, p, state), lie_derivative(F, b, state), -lie_derivative(G, b, state)
    return Derived(
        F=F, G_T=G_T, G_N=G_N, G=G, x=x, y=y, u=u, v=v, a=a, b=b, A=A, B=B, C=C, p=p,
        alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3, mu=mu, mass_matrix=rows,
    )  # fmt: skip


class Reader:
    """The formulas of a mechanism in sympy, with the values of the parameters put in or not."""

    def __init__(self, mechanism: Mechanism, substitute: bool = True) -> None:
        import sympy

        values = mechanism.parameter_values() if substitute else {}
        self._state = mechanism.state
        self._values = {sympy.Symbol(name): to_sympy(value) for name, value in values.items()}

    def __call__(self, function: Expression) -> Any:
        """One function."""
        return to_sympy(function, self._state).xreplace(self._values)

    def all(self, functions: Sequence[Expression]) -> tuple[Any, ...]:
        """Several functions."""
        return tuple(self(function) for function in functions)


def _limit(mechanism: Mechanism, limit: int, **functions: Any) -> None:
    """Refuses functions whose next derivatives would take very long."""
    for letter, function in functions.items():
        if function.count_ops() > limit:
            raise MechanismError(f"{mechanism.name}: {letter} would have more than {limit} operations")


def _lagrangian_fields(
    mechanism: Mechanism, motion: Lagrangian, rows: Any, contact: tuple[Any, Any, Any], read: Reader
) -> tuple[tuple[Any, ...], tuple[Any, ...], tuple[Any, ...]]:
    """F, G_T, G_N of ξ = (q, q', t) from M, f, the constraints, and the directions of the contact forces."""
    import sympy

    x, slip, y = contact
    n = len(motion.coordinates)
    q, velocities, time = mechanism.symbols[:n], mechanism.symbols[n : 2 * n], mechanism.symbols[2 * n :]
    if ((sympy.S.Zero if x is None else x).free_symbols | y.free_symbols) & set(velocities):
        raise MechanismError(f"{mechanism.name}: x and y must not depend on velocities")
    zero, one = sympy.Integer(0), sympy.Integer(1)
    glide = (*velocities, *[zero] * n, *[one] * len(time))
    constraints = read.all(motion.constraints)
    gradients = [[sympy.diff(constraint, s) for s in q] for constraint in constraints]
    bordered = [[*row, *(gradient[i] for gradient in gradients)] for i, row in enumerate(rows)]
    bordered += [[*gradient, *[zero] * len(gradients)] for gradient in gradients]
    size = len(bordered)
    determinant = minor(bordered, range(size), range(size))
    if determinant == 0:
        raise MechanismError(f"{mechanism.name}: the mass matrix is singular")
    others = [[k for k in range(size) if k != i] for i in range(size)]
    inverse = {(i, j): (-1) ** (i + j) * minor(bordered, others[j], others[i]) for i in range(n) for j in range(size)}
    states = mechanism.symbols
    bends = [lie_derivative(glide, lie_derivative(glide, constraint, states), states) for constraint in constraints]

    def accelerations(right: Sequence[Any]) -> list[Any]:
        return [sympy.Add(*(inverse[i, j] * part for j, part in enumerate(right))) / determinant for i in range(n)]

    tangent = [sympy.diff(slip, s) for s in velocities] if x is None else [sympy.diff(x, s) for s in q]
    F = (*velocities, *accelerations([*read.all(motion.forces), *(-bend for bend in bends)]), *[one] * len(time))
    G_T = (*[zero] * n, *accelerations(tangent), *[zero] * len(time))
    G_N = (*[zero] * n, *accelerations([sympy.diff(y, s) for s in q]), *[zero] * len(time))
    return F, G_T, G_N


def minor(rows: Sequence[Sequence[Any]], over: Sequence[int], columns: Sequence[int]) -> Any:
    """The determinant of the chosen rows and columns, by Laplace's expansion and without multiplying out.

    >>> minor(((1, 2), (3, 4)), (0, 1), (0, 1))
    -2
    """
    import sympy

    if not over:
        return sympy.Integer(1)
    terms = []
    for k, column in enumerate(columns):
        entry = rows[over[0]][column]
        if entry != 0:
            rest = minor(rows, over[1:], [other for other in columns if other != column])
            terms.append((-1) ** k * entry * rest)
    return sympy.Add(*terms)


def lagrangian_conditions(mechanism: Mechanism, derived: Derived[Any]) -> dict[str, Any]:
    """What eqs. lagrangian1 and lagrangian2 say must vanish identically, by name."""
    state = mechanism.symbols
    checks = {
        f"L_{name} {letter}": lie_derivative(field, function, state)
        for name, field in (("GT", derived.G_T), ("GN", derived.G_N))
        for letter, function in (("x", derived.x), ("y", derived.y))
        if function is not None
    }
    if not isinstance(mechanism.motion, Lagrangian):  # there it is the symmetry of the mass matrix, which is checked
        checks["L_GN u - L_GT v"] = derived.B - lie_derivative(derived.G_T, derived.v, state)
    checks["L_G p"] = lie_derivative(derived.G, derived.p, state)
    return checks


def check_lagrangian_conditions(mechanism: Mechanism, derived: Derived[Any]) -> None:
    """Checks eqs. lagrangian1, lagrangian2 and B = L_GN u = L_GT v as identities in the state.

    :raises MechanismError: one of them is not the zero function, or was not shown to be.
    """
    for name, function in lagrangian_conditions(mechanism, derived).items():
        if not vanishes_identically(function):
            raise MechanismError(
                f"{mechanism.name}: {name} must vanish (Lagrangian character, Sec. 2, eqs. lagrangian1, lagrangian2), "
                f"it is {str(function)[:200]}"
            )


def vanishes_identically(function: Any) -> bool:
    """Whether the function is shown to be zero: a rational function of its symbols, sines, cosines and roots.

    True is a proof: the numerator is reduced by sin^2 + cos^2 = 1. False may also mean "not shown".

    >>> import sympy
    >>> x = sympy.Symbol("x")
    >>> vanishes_identically(1 / (1 + sympy.sin(x) ** 2) - 1 / (2 - sympy.cos(x) ** 2))
    True
    """
    import sympy

    if function == 0:
        return True
    angles = {node.args[0] for node in function.atoms(sympy.sin, sympy.cos, sympy.tan)}
    names = {angle: sympy.symbols(f"sine_{i} cosine_{i}", cls=sympy.Dummy) for i, angle in enumerate(angles)}
    table: dict[Any, Any] = {}
    for angle, (s, c) in names.items():
        table |= {sympy.sin(angle): s, sympy.cos(angle): c, sympy.tan(angle): s / c}
    numerator = sympy.expand(sympy.fraction(sympy.together(function.xreplace(table)))[0])
    for s, c in names.values():
        numerator = sympy.expand(sympy.rem(numerator, s**2 + c**2 - 1, s)) if numerator.has(s) else numerator
    return bool(numerator == 0)
