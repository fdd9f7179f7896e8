"""The functions of Sec. 2 as expressions, from the fields or from a mass matrix and forces.

u = L_F x, v = L_F y, a = L_F u, b = L_F v, A = L_GT u, B = L_GN u = L_GT v, C = L_GN v, G = G_N - μ G_T,
p = C - μ B, α_1 = L_F p, α_2 = L_F b, α_3 = -L_G b. With a mass matrix M(q, t) and the gradients X, Y of x and y with
respect to q these are

    A = X^T M^-1 X,  B = X^T M^-1 Y,  C = Y^T M^-1 Y,  b = (second derivative of y along q') + Y^T M^-1 f,

so that nothing but b, a and the α's depends on velocities in any other way than the paper says, and the Lagrangian
character (eqs. lagrangian1, lagrangian2) holds by construction. From M^-1' = -M^-1 M' M^-1: with z = M^-1 Y,
α_1 = γ'^T z + ζ^T Y' - ζ^T M' z for γ = Y - μ X, ζ = M^-1 γ, where ' is the rate along q'; and
z'^T f = (Y' - M' z)^T M^-1 f.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from gspot_verified.expansion.derivative import ONE, ZERO, lie_derivative, partial_derivative
from gspot_verified.expansion.expressions import Expression, Variable
from gspot_verified.mechanisms.derived import Derived
from gspot_verified.mechanisms.mass_inverse import MassInverse, SingularMatrixError
from gspot_verified.mechanisms.mechanism import Fields, Lagrangian, Mechanism, MechanismError
from gspot_verified.mechanisms.simplify import constant, product_of, simplified, sum_of
from gspot_verified.mechanisms.symbol import variable_indices

Row = Sequence[Expression]
Prepare = Callable[[Sequence[Expression]], list[Expression]]


def derive_expressions(mechanism: Mechanism, prepare: Prepare) -> Derived[Expression]:
    """All functions of Sec. 2; ``prepare`` puts the parameters in and shifts the angles, before anything is derived.

    :raises MechanismError: the mass matrix is singular for every state, or something depends on velocities that
        must not.
    """
    if isinstance(mechanism.motion, Lagrangian):
        return _of_lagrangian(mechanism, mechanism.motion, prepare)
    return _of_fields(mechanism, mechanism.motion, prepare)


def _of_fields(mechanism: Mechanism, motion: Fields, prepare: Prepare) -> Derived[Expression]:
    m = len(mechanism.state)
    x, y, mu, *rest = prepare([mechanism.x, mechanism.y, mechanism.mu, *motion.F, *motion.G_T, *motion.G_N])
    F, G_T, G_N = tuple(rest[:m]), tuple(rest[m : 2 * m]), tuple(rest[2 * m :])
    G = tuple(_minus(n, product_of(mu, t)) for n, t in zip(G_N, G_T, strict=True))
    u, v = along(F, x), along(F, y)
    a, b = along(F, u), along(F, v)
    A, B, C = along(G_T, u), along(G_N, u), along(G_N, v)
    p = along(G, v)
    alpha = along(F, p), along(F, b), _negative(along(G, b))
    return Derived(F, G_T, G_N, G, x, y, u, v, a, b, A, B, C, p, *alpha, mu, None)


def _of_lagrangian(mechanism: Mechanism, motion: Lagrangian, prepare: Prepare) -> Derived[Expression]:
    n = len(motion.coordinates)
    entries = [entry for row in motion.mass_matrix for entry in row]
    x, y, mu, *rest = prepare([mechanism.x, mechanism.y, mechanism.mu, *entries, *motion.forces])
    rows = tuple(tuple(rest[i * n : (i + 1) * n]) for i in range(n))
    forces = rest[n * n :]
    _check_velocities(mechanism, n, x, y, mu, rows)
    try:
        inverse = MassInverse(rows)
    except SingularMatrixError as error:
        raise MechanismError(f"{mechanism.name}: {error}") from None
    return _Motion(n, len(mechanism.state), rows, inverse, forces, x, y, mu).derived()


def _check_velocities(
    mechanism: Mechanism, n: int, x: Expression, y: Expression, mu: Expression, rows: Sequence[Row]
) -> None:
    velocities = set(range(n, 2 * n))
    if variable_indices([x, y]) & velocities:
        raise MechanismError(f"{mechanism.name}: x and y must not depend on velocities")
    if variable_indices([entry for row in rows for entry in row]) & velocities:
        raise MechanismError(f"{mechanism.name}: the mass matrix must not depend on velocities")
    if variable_indices([mu]) & velocities:
        raise MechanismError(
            f"{mechanism.name}: the friction coefficient must not depend on velocities: L_G p must vanish (Lagrangian "
            "character, Sec. 2, eq. lagrangian2), and where p = C - mu B = 0 with A C > B^2, a coefficient mu(u) gives "
            "L_G p = mu'(u) B (mu A - B) with B > 0 and mu A > B, so p' = alpha_1 + (L_G p) lambda_N would hold in "
            "the place of eq. gensys2"
        )


@dataclass(frozen=True)
class _Motion:
    """M q'' = f + Y λ_N + X λ_T; n coordinates, m components of the state (q, q', and t where it is explicit)."""

    n: int
    m: int
    rows: Sequence[Row]
    inverse: MassInverse
    forces: Row
    x: Expression
    y: Expression
    mu: Expression

    def derived(self) -> Derived[Expression]:
        n, inverse, mu = self.n, self.inverse, self.mu
        X, Y = self._gradient(self.x), self._gradient(self.y)
        gamma = [_minus(part, product_of(mu, other)) for part, other in zip(Y, X, strict=True)]
        free, by_x, by_y, by_gamma = (inverse.times(right) for right in (self.forces, X, Y, gamma))
        velocities = [Variable(n + i) for i in range(n)]
        nothing = [ZERO] * n
        time = [ONE] * (self.m - 2 * n)
        still = [ZERO] * len(time)
        F, glide = (*velocities, *free, *time), (*velocities, *nothing, *time)
        G_T, G_N, G = ((*nothing, *part, *still) for part in (by_x, by_y, by_gamma))
        u, v = along(glide, self.x), along(glide, self.y)
        u_rate, v_rate = along(glide, u), along(glide, v)
        A, B, C, p = (inverse.form(*pair) for pair in ((X, X), (X, Y), (Y, Y), (gamma, Y)))
        a, b = sum_of(u_rate, inverse.form(X, self.forces)), sum_of(v_rate, inverse.form(Y, self.forces))
        mass_rate = [[along(glide, entry) for entry in row] for row in self.rows]
        pull = [_dot(row, by_y) for row in mass_rate]  # M' z
        Y_rate = [along(glide, part) for part in Y]
        gamma_rate = [along(glide, part) for part in gamma]
        alpha_1 = sum_of(_dot(gamma_rate, by_y), _dot(by_gamma, Y_rate), _negative(_dot(by_gamma, pull)))
        bend = [_minus(part, other) for part, other in zip(Y_rate, pull, strict=True)]
        alpha_2 = sum_of(along(F, v_rate), _dot(bend, free), _dot(by_y, [along(F, force) for force in self.forces]))
        alpha_3 = _negative(sum_of(along(G, v_rate), _dot(by_y, [along(G, force) for force in self.forces])))
        rows = tuple(tuple(row) for row in self.rows)
        return Derived(F, G_T, G_N, G, self.x, self.y, u, v, a, b, A, B, C, p, alpha_1, alpha_2, alpha_3, mu, rows)

    def _gradient(self, function: Expression) -> list[Expression]:
        return simplified(*(partial_derivative(function, i, self.m) for i in range(self.n)))


def along(field: Row, function: Expression) -> Expression:
    """The Lie derivative, simplified.

    >>> along([Variable(1), constant(-1)], Variable(0))
    Variable(index=1)
    """
    (found,) = simplified(lie_derivative(function, field))
    return found


def _dot(left: Row, right: Row) -> Expression:
    return sum_of(*(product_of(a, b) for a, b in zip(left, right, strict=True)))


def _negative(value: Expression) -> Expression:
    return product_of(constant(-1), value)


def _minus(left: Expression, right: Expression) -> Expression:
    return sum_of(left, _negative(right))
