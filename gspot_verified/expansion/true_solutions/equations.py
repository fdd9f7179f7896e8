"""The equations of the deviation from the truncated expansion, on a piece of s and for all delta of a range.

Proof page: ``proofs/uniform.md``, Lemma 1: e' = A e + B phi - R, where e holds the deviations of xi, p, b, y, v and
phi = e_lambda + kappa e_y + (l/g) delta e_v is fast.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, arb_mat, arb_poly, fmpq

from gspot_verified.expansion.residual import conditions_at, residual_bounds
from gspot_verified.expansion.trajectory import Trajectory
from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.numbers.balls import add_remainder, ball, hull, nonfinite

_NOTHING = fmpq(0)  # the least delta where all of (0, delta_0] is meant
_KEPT = fmpq(15, 16)  # of g, as g_-: any number that (b) of Theorem U1 allows is correct
_LEVELS = 4  # of s in a unit: constants of the residual are shared up to the next one


@dataclass(frozen=True)
class Coupling:
    """On one piece: ``matrix`` encloses A - A_0, ``fast`` the column B, ``force`` the expansion's lambda_N, ``p``
    p~."""

    matrix: arb_mat
    fast: arb_mat
    force: arb
    p: arb


def measured_in(trajectory: Trajectory) -> str:
    """The variables in which a solution is near the expansion at the start: those of Corollaries 1 and 2."""
    springs = trajectory.system.regularisation
    kappa = springs.k_1 * springs.k_2 / (springs.k_1 + springs.k_2)
    return f"each component of the scaled state, p, b, y, v, and lambda_n + {kappa} y"


class Residuals:
    """Bounds on the residuals of a trajectory for all delta up to one, each computed once."""

    def __init__(self, trajectory: Trajectory, delta: fmpq) -> None:
        self.trajectory, self.delta = trajectory, delta
        self._known: dict[fmpq, dict[str, arb]] = {}
        self._at: dict[fmpq, list[arb]] = {}

    def constants(self, reach: fmpq) -> dict[str, arb]:
        """Bounds on |R| delta^-M for |s| <= reach."""
        level = fmpq((reach * _LEVELS).ceil(), _LEVELS)
        if level not in self._known:
            self._known[level] = residual_bounds(self.trajectory, level, self.delta).constants
        return self._known[level]

    def conditions(self, s: fmpq) -> list[arb]:
        """Bounds of p, b, y, v, J of the expansion's state minus the expansions of p, b, y, v, over delta^(M + 2)."""
        if s not in self._at:
            self._at[s] = conditions_at(self.trajectory, s, self.delta)
        return self._at[s]


class DeviationEquations:
    """Lemma 1 for a trajectory and all delta > 0 from ``least`` to ``delta``. Components: xi_1, ..., xi_m, p, b, y, v.

    ``residuals`` are those of a larger delta, when they do: their bounds hold for every smaller one.

    :raises ValueError: the contact has no damper, so that nothing is fast.
    """

    def __init__(
        self, trajectory: Trajectory, delta: fmpq, least: fmpq = _NOTHING, residuals: Residuals | None = None
    ) -> None:
        system = trajectory.system
        springs = system.regularisation
        if not springs.c > 0:
            raise ValueError("the contact has no damper (c = 0): there is no fast equation")
        self.trajectory, self.delta = trajectory, ball(delta)
        self.least, self.exact_delta = least, delta
        self.small = hull([self.delta, ball(least)])
        self.middle = self.small.mid()
        self.dimension = len(system.point)
        self.size = self.dimension + 4
        self.p, self.b, self.y, self.v = range(self.dimension, self.size)
        self.kappa = arb(springs.k_1 * springs.k_2 / (springs.k_1 + springs.k_2))
        self.rate = arb((springs.k_1 + springs.k_2) / springs.c)
        self.least_rate = self.rate * _KEPT
        self.lag = arb(springs.k_2) - self.kappa
        self.share = self.lag / self.rate  # of e_v in phi, over delta
        self.damper = arb(springs.k_2 / springs.c)
        self.point = [ball(value) for value in system.point]
        self._functions = BoxProgram(
            [*system.F, *system.G, system.alpha_1, system.alpha_2, system.alpha_3], len(self.point)
        )
        values = self._functions.values(self.point)
        self.control = values[self.dimension : 2 * self.dimension]
        self.alpha_1, _, self.alpha_3 = values[2 * self.dimension :]
        self.mean_force = ball(trajectory.lambda_n[0].at_zero())
        self._terms = {
            name: [arb_poly([ball(value) for value in term.coefficients()]) for term in terms]
            for name, terms in trajectory.terms().items()
        }
        self.residuals = Residuals(trajectory, delta) if residuals is None else residuals
        if not delta <= self.residuals.delta:
            raise ValueError("the residuals are bounded for a smaller delta only")

    def limit(self, s: arb) -> arb_mat:
        """A_0(s): A at delta = 0, but for what phi puts into column v, which is taken at the middle delta."""
        rows = [[arb(0)] * self.size for _ in range(self.size)]
        for i, value in enumerate(self.control):
            rows[i][self.y] = -self.kappa * value
        rows[self.b][self.y] = self.kappa * self.alpha_3
        rows[self.y][self.v] = rows[self.v][self.b] = arb(1)
        rows[self.v][self.p] = self.mean_force
        rows[self.v][self.y] = -self.kappa * self.alpha_1 * s
        for row, value in zip(rows, self._limit_fast(s), strict=True):
            row[self.v] = row[self.v] - self.share * self.middle * value
        return arb_mat(rows)

    def _limit_fast(self, s: arb) -> list[arb]:
        """B_0(s): the column B at delta = 0."""
        return [*self.control, arb(0), -self.alpha_3, arb(0), self.alpha_1 * s]

    def limit_slope(self) -> arb_mat:
        """The derivative of A_0 by s."""
        rows = [[arb(0)] * self.size for _ in range(self.size)]
        rows[self.v][self.y] = -self.kappa * self.alpha_1
        rows[self.v][self.v] = -self.share * self.middle * self.alpha_1
        return arb_mat(rows)

    def expansion(self, name: str, s: arb, first: int = 0) -> arb:
        """The truncated expansion of a variable, terms from ``first`` on, for all delta of the range."""
        total = arb(0)
        for term in reversed(self._terms[name][first:]):
            total = total * self.small + term(s)
        return total * self.small**first

    def states(self, s: arb, deviations: Sequence[arb]) -> list[arb]:
        """The states for |e_i| <= |deviations_i| (those of xi matter): what bounds e at delta_0 does at each delta."""
        square, tube = self.small * self.small, _around_zero(deviations)
        return [value + square * (self.expansion(f"xi_{i + 1}", s) + tube[i]) for i, value in enumerate(self.point)]

    def coupling(self, s: arb, deviations: Sequence[arb]) -> Coupling:
        """The coefficients for |e_i| <= |deviations_i| (those of xi and p matter)."""
        m, square = self.dimension, self.small * self.small
        tube = _around_zero(deviations)
        values, slopes = self._functions.gradients(self.states(s, deviations))
        drifts, controls, (first, second, third) = slopes[:m], slopes[m : 2 * m], slopes[2 * m :]
        control, alpha_3 = values[m : 2 * m], values[2 * m + 2]
        force = self.expansion("lambda_n", s)
        bend = self.expansion("p", s, 1) + tube[self.p]
        rows = [[arb(0)] * self.size for _ in range(self.size)]
        for i in range(m):
            for j in range(m):
                rows[i][j] = square * (drifts[i][j] + force * controls[i][j])
            rows[i][self.y] = -self.kappa * (control[i] - self.control[i])
        for j in range(m):
            rows[self.p][j] = square * first[j]
            rows[self.b][j] = square * (second[j] - force * third[j])
        rows[self.b][self.y] = self.kappa * (alpha_3 - self.alpha_3)
        rows[self.v][self.p] = self.expansion("lambda_n", s, 1)
        rows[self.v][self.y] = -self.kappa * bend
        p = self.alpha_1 * s + bend
        fast = [*control, arb(0), -alpha_3, arb(0), p]
        for row, value, limit in zip(rows, fast, self._limit_fast(s), strict=True):
            row[self.v] = -self.share * (self.small * (value - limit) + (self.small - self.middle) * limit)
        return Coupling(arb_mat(rows), arb_mat([[value] for value in fast]), force, p)

    def lagged(self, bound: arb, v: arb) -> arb:
        """A bound on |phi| where |f| <= bound, or on |f| where |phi| <= bound: they differ by (l/g) delta e_v."""
        return (bound + self.share * self.delta * v.abs_upper()).upper()

    def norm(self, name: str, reach: arb, first: int = 0) -> arb:
        """A bound on the terms from ``first`` on, monomial by monomial, for |s| <= reach and delta <= delta_0."""
        total = arb(0)
        for term in reversed(self._terms[name][first:]):
            size = arb(0)
            for value in reversed(term.coeffs()):
                size = size * reach + value.abs_upper()
            total = total * self.delta + size
        return (total * self.delta**first).upper()

    def functions(self, state: Sequence[arb]) -> tuple[list[arb], list[list[arb]]]:
        """F, G, alpha_1, alpha_2, alpha_3 and their slopes on a box of states."""
        return self._functions.gradients(state)

    def residual_below(self, reach: arb) -> tuple[list[arb], arb]:
        """As :meth:`residual`, for a ball; not finite where the ball is not."""
        levels = (reach.upper() * _LEVELS).ceil().unique_fmpz()
        if levels is None:
            return [nonfinite()] * self.size, nonfinite()
        return self.residual(fmpq(levels if levels > 0 else 1, _LEVELS))

    def residual(self, reach: fmpq) -> tuple[list[arb], arb]:
        """Bounds on |R| delta^-M for |s| <= reach: those of e, and that of the equation of z."""
        constants = self.residuals.constants(reach)
        names = [*(f"xi_{i + 1}" for i in range(self.dimension)), "p", "b", "y", "v"]
        return [constants[name] for name in names], constants["z"]


def _around_zero(deviations: Sequence[arb]) -> list[arb]:
    return [add_remainder(arb(0), value.abs_upper()) for value in deviations]
