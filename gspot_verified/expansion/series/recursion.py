"""The recursion of Theorem 1's proof, steps 1 to 4, one function for each step.

Paper, Sec. 5, eqs. p_nprime to xi_iteraction; page: proofs/expansion.md. All terms are exact, in
the spaces P_n; membership is checked.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from gspot_verified.expansion.series.spaces import SpacePolynomial
from gspot_verified.expansion.series.system import GSpotError, System
from gspot_verified.expansion.series.terms import NumberTerms, PolynomialTerms
from gspot_verified.functions.convolution import Series
from gspot_verified.functions.linear import inverse, solve_from_above
from gspot_verified.functions.power_series import SeriesOfFunctions

_SHIFTS = {"p": (1, -3), "b": (1, -3), "xi": (1, -3), "y": (0, -1), "z": (0, -1), "v": (-1, -2), "lambda": (0, -4)}
"""For n = 2 nu the space is P_(nu + first), for n = 2 nu + 1 it is P_(nu + second); Theorem 1."""


def space_of(variable: str, n: int) -> int:
    """The index of the space of the term of order n of a scaled variable, by Theorem 1."""
    even, odd = _SHIFTS[variable]
    return n // 2 + (odd if n % 2 else even)


class ObstructedOrderError(GSpotError):
    """beta is an integer: the equation for one coefficient of b has no solution, or no unique one."""


@dataclass
class Recursion:
    """The terms found so far; :meth:`advance` adds one order.

    :raises GSpotError: the system has no G-spot at its point at which Theorem 1 holds, or the Jacobian is singular.
    """

    system: System
    alpha: tuple[Any, Any, Any] = field(init=False)
    p: list[SpacePolynomial] = field(init=False)
    b: list[SpacePolynomial] = field(default_factory=list)
    y: list[SpacePolynomial] = field(default_factory=list)
    v: list[SpacePolynomial] = field(default_factory=list)
    z: list[SpacePolynomial] = field(default_factory=list)
    lambda_n: list[SpacePolynomial] = field(init=False)
    xi: list[list[SpacePolynomial]] = field(default_factory=list)

    def __post_init__(self) -> None:
        system = self.system
        self.alpha = system.check()
        self._inverse = self._inverse_jacobian()
        functions = (*system.F, *system.G, system.alpha_1, system.alpha_2, system.alpha_3)
        terms = PolynomialTerms(system.ring)
        self._functions = SeriesOfFunctions(functions, terms, system.ring)
        self._conditions = SeriesOfFunctions(system.conditions, NumberTerms(system.ring), system.ring)
        # The lists of terms, which grow with each order.
        self._drift = [self._functions[function] for function in system.F]
        self._alpha_1, self._alpha_2 = self._functions[system.alpha_1], self._functions[system.alpha_2]
        self._p, self._force = Series(terms.is_zero), Series(terms.is_zero)
        self.p, self.lambda_n = self._p.terms, self._force.terms
        self._p_force = terms.convolution(self._p, self._force)
        self._alpha_3_force = terms.convolution(self._functions.series(system.alpha_3), self._force)
        self._control_force = [terms.convolution(self._functions.series(g), self._force) for g in system.G]
        self._at_start = [self._conditions[condition] for condition in system.conditions]
        zero = system.ring.number(0)
        self._conditions.extend(list(system.point))
        self._conditions.extend([zero] * len(system.point))

    def advance(self) -> None:
        """Find the terms of the next order.

        :raises ObstructedOrderError: beta is an integer that this order meets.
        """
        n = len(self.p)
        self._extend_functions(n)
        self._step_1(n)
        r_b, r = self._step_2_right_sides(n)
        self.b.append(self._step_2_solve(r))
        self._step_3(n, r_b)
        self._step_4(n)

    @property
    def _compliance(self) -> tuple[Any, Any]:
        """h and gamma/kappa_1 of :mod:`regularisation`: 2 and 1 in the paper."""
        ring, regularisation = self.system.ring, self.system.regularisation
        return ring.number(regularisation.compliance), ring.number(regularisation.delay)

    def _zero(self, variable: str, n: int) -> SpacePolynomial:
        return SpacePolynomial.zero(space_of(variable, n), self.system.ring)

    def _extend_functions(self, n: int) -> None:
        """F_n, G_n, alpha_n depend on xi_k for k <= n - 2 (Lemma thm:expansion): xi = xi* + delta^2 xi~."""
        terms = PolynomialTerms(self.system.ring)
        if n == 0:
            state = [terms.constant(value) for value in self.system.point]
        elif n == 1:
            state = [terms.zero(1)] * len(self.system.point)
        else:
            state = self.xi[n - 2]
        self._functions.extend(state)

    def _step_1(self, n: int) -> None:
        """p_n' = alpha_1n, p_n(0) = 0."""
        self._p.append(self._alpha_1[n].integral().in_space(space_of("p", n)))

    def _step_2_right_sides(self, n: int) -> tuple[SpacePolynomial, SpacePolynomial]:
        """r_(b,n) of specialBn and r_n of third-order_b; the products lack the term with lambda_n, not known yet."""
        alpha_1, _, alpha_3 = self.alpha
        r_b = self._alpha_2[n] - self._alpha_3_force(n)
        r_v = self._p_force(n)
        s = SpacePolynomial.from_list(1, [0, 1], self.system.ring)
        compliance, delay = self._compliance
        before = self.z[n - 1] if n else self._zero("z", 0)
        right = r_b.derivative().derivative().scale(compliance)
        right = right + before.derivative().derivative().derivative().scale(alpha_3 * delay)
        return r_b, right + (s * r_b).scale(alpha_1) + r_v.scale(alpha_3)

    def _step_2_solve(self, right: SpacePolynomial) -> SpacePolynomial:
        """h b''' + alpha_1 s b' - alpha_3 b = r, from the highest power down; h = 2 in the paper.

        The coefficient of s^k gives (k alpha_1 - alpha_3) c_k + h (k+1)(k+2)(k+3) c_(k+3) = r_k.
        """
        ring = self.system.ring
        alpha_1, _, alpha_3 = self.alpha
        compliance, _ = self._compliance
        order = len(self.p) - 1
        space = space_of("b", order)
        # Every exponent of the space: where the factor is 0 the coefficient is free even when the right side is 0.
        exponents = range(space % 3, space + 1, 3)
        factors = [ring.number(k) * alpha_1 - alpha_3 for k in exponents]
        for k, factor in zip(exponents, factors, strict=True):
            if not ring.is_nonzero(factor):
                raise ObstructedOrderError(
                    f"{self.system.name}: beta = alpha_3/alpha_1 is, or may be, the integer {k}: the coefficient of "
                    f"s^{k} at order {order} of delta is obstructed, there is no unique expansion"
                )
        couplings = [ring.number((k + 1) * (k + 2) * (k + 3)) * compliance for k in exponents]
        coefficients = solve_from_above(right.in_space(space).cubic, factors, couplings, ring)
        return SpacePolynomial(space, coefficients, ring)

    def _step_3(self, n: int, r_b: SpacePolynomial) -> None:
        """y_n, v_n, z_n, lambda_n from b_n."""
        alpha_3 = self.alpha[2]
        ring = self.system.ring
        compliance, delay = self._compliance
        before = self.z[n - 1].derivative().scale(delay) if n else SpacePolynomial.zero(0, ring)
        force = (r_b - self.b[n].derivative()).scale(ring.number(1) / alpha_3)
        y = force.scale(-compliance) - before
        self._force.append(force.in_space(space_of("lambda", n)))
        self.y.append(y.in_space(space_of("y", n)))
        self.v.append(y.derivative().in_space(space_of("v", n)))
        first_spring = ring.number(1 / self.system.regularisation.k_1)
        self.z.append((force.scale(-first_spring) - before).in_space(space_of("z", n)))

    def _step_4(self, n: int) -> None:
        """xi_n: integrate F_n + sum of G_(n-k) lambda_k; the constants from the conditions at s = 0."""
        slopes = [
            drift[n] + control_force(n) for drift, control_force in zip(self._drift, self._control_force, strict=True)
        ]
        constants = self._constants(n)
        space = space_of("xi", n)
        ring = self.system.ring
        terms = []
        for slope, constant in zip(slopes, constants, strict=True):
            values = [] if ring.is_zero(constant) else [constant]
            # A constant that is not zero outside its space P_n would contradict Theorem 1: in_space raises.
            start = SpacePolynomial(0, ring.polynomial(values), ring)
            terms.append((slope.integral().in_space(space) + start).in_space(space))
        self.xi.append(terms)

    def _inverse_jacobian(self) -> list[list[Any]]:
        try:
            return inverse(self.system.jacobian(), self.system.ring)
        except ZeroDivisionError:
            raise GSpotError(
                f"{self.system.name}: the Jacobian of (p, b, y, v, J) at the G-spot is singular "
                "(eq. genSysGSpotNonSing): the G-spot is not isolated, or the extra conditions J do not fix it"
            ) from None

    def _applied(self, row: list[Any], right: list[Any]) -> Any:
        """A row of the inverse times the right side."""
        ring = self.system.ring
        total = ring.number(0)
        for factor, value in zip(row, right, strict=True):
            if not ring.is_zero(factor) and not ring.is_zero(value):
                total = total + factor * value
        return total

    def _constants(self, n: int) -> list[Any]:
        """xi_n(0) from p, b, y, v, J at s = 0, order n + 2 of delta (eqs. specialInitialFirst to Jbc)."""
        zero = self.system.ring.number(0)
        self._conditions.extend([zero] * len(self.system.point))
        rest = [terms[n + 2] for terms in self._at_start]
        wanted = [
            self.p[n].at_zero(),
            self.b[n].at_zero(),
            self.y[n - 4].at_zero() if n >= 4 else zero,
            self.v[n - 2].at_zero() if n >= 2 else zero,
            *[zero] * len(self.system.J),
        ]
        right = [w - r for w, r in zip(wanted, rest, strict=True)]
        constants = [self._applied(row, right) for row in self._inverse]
        self._conditions.drop_last()
        self._conditions.extend(constants)
        return constants
