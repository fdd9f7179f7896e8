"""The functions of Sec. 2 as expressions, from the fields or from a mass matrix and forces.

u = L_F x, v = L_F y, a = L_F u, b = L_F v, A = L_GT u, B = L_GN u = L_GT v, C = L_GN v, G = G_N - μ G_T,
p = C - μ B, α_1 = L_F p, α_2 = L_F b, α_3 = -L_G b. With a mass matrix M(q, t) and the gradients X, Y of x and y with
respect to q these are

    A = X^T M^-1 X,  B = X^T M^-1 Y,  C = Y^T M^-1 Y,  b = (second derivative of y along q') + Y^T M^-1 f,

so that nothing but b, a and the α's depends on velocities in any other way than the paper says, and the Lagrangian
character (eqs. lagrangian1, lagrangian2) holds by construction. From M^-1' = -M^-1 M' M^-1: with z = M^-1 Y,
α_1 = γ'^T z + ζ^T Y' - ζ^T M' z for γ = Y - μ X, ζ = M^-1 γ, where ' is the rate along q'; and
z'^T f = (Y' - M' z)^T M^-1 f.

Constraints φ(q, t) = 0 with multipliers ν: M q'' = f + Φ^T ν + ..., and φ'' = 0 gives Φ q'' = -(second derivative of φ
along q'). Both together are K (q'', -ν) = (f, -φ'' at q'' = 0) + (Y, 0) λ_N + (X, 0) λ_T with a symmetric K, M bordered
by Φ: the formulas above hold with K for M. Where M is positive definite and the rows of Φ are independent,
K = L D L^T has no vanishing pivot: the first are those of M, the others those of -Φ M^-1 Φ^T.

First the mechanism is prepared, and what must not depend on velocities is checked not to.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

from gspot_verified.functions.derivative import ONE, ZERO, partial_derivative
from gspot_verified.functions.expressions import Expression, Variable
from gspot_verified.mechanisms.derive.derived import Derived
from gspot_verified.mechanisms.derive.mass_inverse import MassInverse, SingularMatrixError
from gspot_verified.mechanisms.formulas.rewriting import along, simplified
from gspot_verified.mechanisms.formulas.simplify import minus, negative, product_of, sum_of
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
    first, y, mu, *rest = prepare(mechanism.formulas)
    rows = tuple(tuple(rest[i * n : (i + 1) * n]) for i in range(n))
    forces, constraints = tuple(rest[n * n : n * n + n]), tuple(rest[n * n + n :])
    glide = (*(Variable(n + i) for i in range(n)), *[ZERO] * n, *[ONE] * (m - 2 * n))
    x, u = (None, first) if mechanism.x is None else (first, along(glide, first))
    given = LagrangianInput(
        n=n, m=m, glide=glide, rows=rows, forces=forces, constraints=constraints, x=x, u=u, y=y, mu=mu
    )
    _check_velocities(mechanism.name, given)
    return given


def _check_velocities(name: str, given: LagrangianInput) -> None:
    velocities = set(range(given.n, 2 * given.n))

    def depend(functions: Sequence[Expression]) -> bool:
        return bool(variable_indices(functions) & velocities)

    if depend([given.y, *([] if given.x is None else [given.x])]):
        raise MechanismError(f"{name}: x and y must not depend on velocities")
    if depend(simplified(*(partial_derivative(given.u, i, given.m) for i in sorted(velocities)))):
        raise MechanismError(f"{name}: the slip velocity must be linear in the velocities")
    if depend(given.constraints):
        raise MechanismError(f"{name}: a constraint must not depend on velocities")
    if depend([entry for row in given.rows for entry in row]):
        raise MechanismError(f"{name}: the mass matrix must not depend on velocities")
    if depend([given.mu]):
        raise MechanismError(
            f"{name}: the friction coefficient must not depend on velocities: L_G p must vanish (Lagrangian "
            "character, Sec. 2, eq. lagrangian2), and where p = C - mu B = 0 with A C > B^2, a coefficient mu(u) gives "
            "L_G p = mu'(u) B (mu A - B) with B > 0 and mu A > B, so p' = alpha_1 + (L_G p) lambda_N would hold in "
            "the place of eq. gensys2; for simulate a coefficient that varies with |u| is a formula in slip_speed"
        )


Row = Sequence[Expression]


def derive_expressions(mechanism: Mechanism, prepare: Prepare) -> Derived[Expression]:
    """All functions of Sec. 2; ``prepare`` puts the parameters in and shifts the angles, before anything is derived.

    :raises MechanismError: the mass matrix is singular for every state, or something depends on velocities that
        must not.
    """
    if isinstance(mechanism.motion, Lagrangian):
        return _of_lagrangian(mechanism, mechanism.motion, prepare)
    return _of_fields(mechanism, prepare)


def _of_fields(mechanism: Mechanism, prepare: Prepare) -> Derived[Expression]:
    m = len(mechanism.state)
    first, y, mu, *rest = prepare(mechanism.formulas)
    F, G_T, G_N = tuple(rest[:m]), tuple(rest[m : 2 * m]), tuple(rest[2 * m :])
    G = tuple(minus(n, product_of(mu, t)) for n, t in zip(G_N, G_T, strict=True))
    x, u = (None, first) if mechanism.x is None else (first, along(F, first))
    v = along(F, y)
    a, b = along(F, u), along(F, v)
    A, B, C = along(G_T, u), along(G_N, u), along(G_N, v)
    p = along(G, v)
    alpha_1, alpha_2, alpha_3 = along(F, p), along(F, b), negative(along(G, b))
    return Derived(
        F=F, G_T=G_T, G_N=G_N, G=G, x=x, y=y, u=u, v=v, a=a, b=b, A=A, B=B, C=C, p=p,
        alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3, mu=mu, mass_matrix=None,
    )  # fmt: skip


def _of_lagrangian(mechanism: Mechanism, motion: Lagrangian, prepare: Prepare) -> Derived[Expression]:
    given = lagrangian_input(mechanism, motion, prepare)
    n, m, mu, constrained = given.n, given.m, given.mu, len(given.constraints)
    glide = given.glide
    rates = [along(glide, constraint) for constraint in given.constraints]
    gradients = [_gradient(constraint, range(n), m) for constraint in given.constraints]
    rows = [[*row, *(gradient[i] for gradient in gradients)] for i, row in enumerate(given.rows)]
    rows += [[*gradient, *[ZERO] * constrained] for gradient in gradients]
    try:
        inverse = MassInverse(rows)
    except SingularMatrixError as error:
        raise MechanismError(f"{mechanism.name}: {error}") from None
    still = [ZERO] * constrained
    X = [*_gradient(given.u, range(n, 2 * n), m), *still]
    Y = [*_gradient(given.y, range(n), m), *still]
    forces = [*given.forces, *(negative(along(glide, rate)) for rate in rates)]
    return _Motion(
        given, rows, inverse, forces, X, Y, [minus(b, product_of(mu, a)) for a, b in zip(X, Y, strict=True)]
    ).derived()


@dataclass(frozen=True)
class _Motion:
    """K (q'', -ν) = f + Y λ_N + X λ_T; K is M, or M bordered by the gradients of the constraints. γ = Y - μ X."""

    given: LagrangianInput
    rows: Sequence[Row]
    inverse: MassInverse
    forces: Row
    X: Row
    Y: Row
    gamma: Row

    def derived(self) -> Derived[Expression]:
        given, inverse, X, Y, gamma = self.given, self.inverse, self.X, self.Y, self.gamma
        n, glide, y, u = given.n, given.glide, given.y, given.u
        free, by_x, by_y, by_gamma = (inverse.times(right) for right in (self.forces, X, Y, gamma))
        nothing, still = [ZERO] * n, [ZERO] * (given.m - 2 * n)
        F = (*glide[:n], *free[:n], *glide[2 * n :])
        G_T, G_N, G = ((*nothing, *part[:n], *still) for part in (by_x, by_y, by_gamma))
        v = along(glide, y)
        u_rate, v_rate = along(glide, u), along(glide, v)
        A, B, C, p = (inverse.form(*pair) for pair in ((X, X), (X, Y), (Y, Y), (gamma, Y)))
        a, b = sum_of(u_rate, inverse.form(X, self.forces)), sum_of(v_rate, inverse.form(Y, self.forces))
        pull = [_dot([along(glide, entry) for entry in row], by_y) for row in self.rows]  # K' z
        Y_rate = [along(glide, part) for part in Y]
        gamma_rate = [along(glide, part) for part in gamma]
        alpha_1 = sum_of(_dot(gamma_rate, by_y), _dot(by_gamma, Y_rate), negative(_dot(by_gamma, pull)))
        bend = [minus(part, other) for part, other in zip(Y_rate, pull, strict=True)]
        alpha_2 = sum_of(along(F, v_rate), _dot(bend, free), _dot(by_y, [along(F, force) for force in self.forces]))
        alpha_3 = negative(sum_of(along(G, v_rate), _dot(by_y, [along(G, force) for force in self.forces])))
        return Derived(
            F=F,
            G_T=G_T,
            G_N=G_N,
            G=G,
            x=given.x,
            y=y,
            u=u,
            v=v,
            a=a,
            b=b,
            A=A,
            B=B,
            C=C,
            p=p,
            alpha_1=alpha_1,
            alpha_2=alpha_2,
            alpha_3=alpha_3,
            mu=given.mu,
            mass_matrix=given.rows,
        )


def _gradient(function: Expression, indices: Iterable[int], m: int) -> list[Expression]:
    return simplified(*(partial_derivative(function, i, m) for i in indices))


def _dot(left: Row, right: Row) -> Expression:
    return sum_of(*(product_of(a, b) for a, b in zip(left, right, strict=True)))
