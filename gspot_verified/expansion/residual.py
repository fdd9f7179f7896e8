"""How well the truncated expansion satisfies the equations, with an explicit constant: proofs/residual.md.

The polynomials of Theorem 1 are put into specialX to specialL and into the conditions at s = 0. Every order of delta
below M must vanish exactly; the rest is bounded by K delta^M for all |s| <= S and 0 <= delta <= D.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

from flint import arb, fmpq

from gspot_verified.expansion.majorants import Graded, graded_functions, rest_of_product, size_of
from gspot_verified.expansion.series.legend import InTwo, in_two, state_names
from gspot_verified.expansion.series.spaces import SpacePolynomial
from gspot_verified.expansion.series.terms import NumberTerms, PolynomialTerms
from gspot_verified.expansion.trajectory import Trajectory
from gspot_verified.functions.derivative import powers_as_products
from gspot_verified.functions.expressions import Expression, in_order
from gspot_verified.functions.power_series import SeriesOfFunctions, Terms
from gspot_verified.functions.rings import Ring
from gspot_verified.numbers.balls import Exact, ExactInput, ball_text, exact, nonfinite, working_bits
from gspot_verified.numbers.inner_text import inner_ends
from gspot_verified.numbers.short_text import short_text
from gspot_verified.numbers.verdict import NoTruthValue
from gspot_verified.numbers.written import Written

ONLY_RESIDUAL = (
    "a bound on what is left in the equations, and in the conditions at s = 0 (start) over delta^2; how far the "
    "mechanism's own trajectory is from the polynomials is not proved"
)
_ZERO = fmpq(0)  # where the conditions stand
_BITS = 128  # with which the constants are computed; less make them larger
_EXTRA = 8  # orders beyond M that are exact where nothing is asked: more make the constants less
_LARGEST = arb(2) ** 1_000_000  # of a constant that is stated: nothing is written of one beyond it
_LEAST_EXTRA = 4  # a hypothesis: N >= M + 4, proofs/residual.md


class ResidualError(ValueError):
    """The terms are not those of Theorem 1: an order of delta below M does not vanish in one of the equations."""


@dataclass(frozen=True)
class ResidualBounds(NoTruthValue, Written):
    """|residual| <= constants[name] delta^order for all |s| <= s and 0 <= delta <= delta.

    xi_1, ..., p, b, y, v, z, lambda_n name eqs. specialX to specialL; start_p, start_b, start_y, start_v, start_J_1,
    ... the conditions specialInitialFirst to Jbc, divided by delta^2. A constant that is not finite is no bound.
    """

    ask: ClassVar[str] = ".constants are bounds only where they are finite"
    meaning: ClassVar[str] = ONLY_RESIDUAL
    written: ClassVar[str] = "name order s delta meaning state=rows.state contact=rows.contact start"

    name: str
    order: int
    s: fmpq | arb
    delta: fmpq | arb
    constants: dict[str, arb]
    state: tuple[str, ...] = ()

    @property
    def rows(self) -> InTwo[arb]:
        """The constants of the equations."""
        components = sum(key.startswith("xi_") for key in self.constants)
        return in_two(self.constants, state_names(self.state, components))

    @property
    def start(self) -> dict[str, arb]:
        """The constants of the conditions at s = 0."""
        return {key[6:]: value for key, value in self.constants.items() if key.startswith("start_")}

    def __str__(self) -> str:
        box = f"|s| <= {_largest(self.s)}, 0 <= delta <= {_largest(self.delta)}"
        lines = [f"{self.name}: |residual| <= K delta^{self.order} for {box}, K ="]
        lines += [f"  {self._equation(key)}: {_bound(value)}" for key, value in self.constants.items()]
        return "\n".join([*lines, f"  {ONLY_RESIDUAL}"])

    @property
    def complete(self) -> bool:
        """Whether each equation and each condition has a bound."""
        return all(value.is_finite() for value in self.constants.values())

    def _equation(self, key: str) -> str:
        return f"equation of {self.state[int(key[3:]) - 1]}" if self.state and key.startswith("xi_") else key


def _bound(value: arb) -> str:
    return ball_text(value, 6) if value.is_finite() else "no bound"


def residual_bounds(trajectory: Trajectory, s: ExactInput, delta: ExactInput, extra: int = _EXTRA) -> ResidualBounds:
    """Constants K for the box |s| <= s, 0 <= delta <= delta.

    ``extra`` is the number of orders beyond M that are computed exactly; more give smaller constants.

    :raises ResidualError: an order below M does not vanish.
    :raises SymbolsError: the numbers of the system are symbols.
    :raises ValueError: s is negative, delta is not positive, or ``extra`` is less than 4.

    >>> from gspot_verified import expand
    >>> from gspot_verified.testing import extended_example
    >>> bounds = residual_bounds(expand(extended_example(chi=1), 6), s=1, delta="1/10")
    >>> print(bounds.constants["z"], bounds.constants["y"])
    48.0000000000000 0
    """
    box = exact(s, "s"), exact(delta, "delta")
    if type(extra) is not int or extra < _LEAST_EXTRA:
        raise ValueError(f"extra must be an int of at least {_LEAST_EXTRA}, got {extra!r}")
    trajectory.system.check_numbers("bounds")
    with working_bits(_BITS):
        if not arb(box[0]) >= 0:
            raise ValueError(f"s must not be negative, got {s}")
        if not arb(box[1]) > 0:
            raise ValueError(f"delta must be positive, got {delta}")
        checks = _Residual(trajectory, size_of(box[0]), size_of(box[1]), trajectory.order + extra)
        constants = {**checks.equations(), **checks.conditions()}
    return ResidualBounds(trajectory.system.name, trajectory.order, *box, constants, trajectory.system.state)


def _largest(value: Exact) -> str:
    """Up to which size the bounds are said to hold: for all numbers of a ball, so up to a decimal just below its upper
    end."""
    return str(value) if isinstance(value, fmpq) else short_text(inner_ends(value)[1])


def conditions_at(trajectory: Trajectory, s: fmpq, delta: fmpq) -> list[arb]:
    """Bounds of |p(xi) - delta^2 p~|, |b(xi) - delta^2 b~|, |y(xi) - delta^6 y~|, |v(xi) - delta^4 v~|, J(xi), over
    delta^(order + 2), xi = xi* + delta^2 xi~, for the polynomials of the expansion at ``s`` and 0 < delta <= ``delta``.

    :raises ResidualError: an order below does not vanish.
    """
    with working_bits(_BITS):
        return list(_Residual(trajectory, abs(arb(s)), arb(delta), trajectory.order + _EXTRA).conditions(s).values())


class _Residual:
    def __init__(self, trajectory: Trajectory, s: arb, delta: arb, end: int) -> None:
        self._of, self._system, self._ring = trajectory, trajectory.system, trajectory.system.ring
        self._s, self._delta, self._end, self._order = s, delta, end, trajectory.order
        self._zero = SpacePolynomial.zero(-1, self._ring)

    def equations(self) -> dict[str, arb]:
        """The constants of specialX to specialL."""
        system, of = self._system, self._of
        functions = _Functions(
            roots=[*system.F, *system.G, system.alpha_1, system.alpha_2, system.alpha_3],
            terms=PolynomialTerms(self._ring),
            ring=self._ring,
            state=lambda n: [terms[n] for terms in of.xi] if n < self._order else None,
            norm=lambda term: _norm(term, self._s),
            point=system.point,
            delta=self._delta,
            end=self._end,
        )
        known = {
            name: _padded(terms, self._end, self._zero)
            for name, terms in (("p", of.p), ("b", of.b), ("y", of.y), ("v", of.v), ("z", of.z), ("l", of.lambda_n))
        }
        p, b, y, v, z, force = known.values()
        force_norms, p_norms = (
            Graded(tuple(_norm(term, self._s) * self._delta**n for n, term in enumerate(terms)), arb(0))
            for terms in (force, p)
        )
        constants: dict[str, arb] = {}

        def settle(name: str, terms: Sequence[SpacePolynomial], rest: arb) -> None:
            constants[name] = self._constant(name, terms, rest, lambda term: _norm(term, self._s))

        for i, (drift, control) in enumerate(zip(system.F, system.G, strict=True)):
            slope = [term.derivative() for term in _padded(of.xi[i], self._end, self._zero)]
            moved = self._minus(slope, functions[drift], self._convolved(functions[control], force))
            rest = functions.graded(drift).rest + rest_of_product(functions.graded(control), force_norms)
            settle(f"xi_{i + 1}", moved, rest)
        slope_p = [term.derivative() for term in p]
        settle("p", self._minus(slope_p, functions[system.alpha_1]), functions.graded(system.alpha_1).rest)
        pushed = self._convolved(functions[system.alpha_3], force)
        slope_b = [term.derivative() + other for term, other in zip(b, pushed, strict=True)]
        rest = functions.graded(system.alpha_2).rest + rest_of_product(functions.graded(system.alpha_3), force_norms)
        settle("b", self._minus(slope_b, functions[system.alpha_2]), rest)
        settle("y", self._minus([term.derivative() for term in y], v), arb(0))
        slope_v = [term.derivative() for term in v]
        settle("v", self._minus(slope_v, b, self._convolved(p, force)), rest_of_product(p_norms, force_norms))
        slope_z = [self._zero, *(term.derivative() for term in z[:-1])]
        springs = system.regularisation
        first, second, damper = (self._ring.number(value) for value in (springs.k_1, springs.k_2, springs.c))
        slow = [a.scale(damper) + c.scale(first) + d for a, c, d in zip(slope_z, z, force, strict=True)]
        settle("z", slow, arb(0))
        pressed = [a + (d - c).scale(second) for a, c, d in zip(force, z, y, strict=True)]
        settle("lambda_n", pressed, arb(0))
        return constants

    def conditions(self, s: fmpq = _ZERO) -> dict[str, arb]:
        """The constants of the conditions at s = 0, or of the functions p, b, y, v, J elsewhere, divided by delta^2."""
        system, of, ring = self._system, self._of, self._ring
        zero, at = ring.number(0), ring.number(s)
        functions = _Functions(
            roots=list(system.conditions),
            terms=NumberTerms(ring),
            ring=ring,
            state=lambda n: [terms[n](at) for terms in of.xi] if n < self._order else None,
            norm=size_of,
            point=system.point,
            delta=self._delta,
            end=self._end + 2,
        )
        starts = [(of.p, 0), (of.b, 0), (of.y, 4), (of.v, 2), *[((), 0)] * len(system.J)]
        names = ["p", "b", "y", "v", *(f"J_{i + 1}" for i in range(len(system.J)))]
        constants = {}
        for name, condition, (terms, shift) in zip(names, system.conditions, starts, strict=True):
            wanted = _padded([zero] * shift + [term(at) for term in terms], self._end, zero)
            left = [value - other for value, other in zip(functions[condition][2:], wanted, strict=True)]
            rest = functions.graded(condition).rest / self._delta**2
            constants[f"start_{name}"] = self._constant(f"start_{name}", left, rest, size_of)
        if any(ring.is_nonzero(term.at_zero()) for term in of.p):
            raise ResidualError(f"{system.name}: p does not vanish at s = 0")
        return constants

    def _constant(self, name: str, terms: Sequence[Any], rest: arb, norm: Callable[[Any], arb]) -> arb:
        """The sum of the norms of the orders from M on over delta^M; the orders below M must vanish."""
        for n, term in enumerate(terms[: self._order]):
            values = term.coefficients() if isinstance(term, SpacePolynomial) else [term]
            for k, value in enumerate(values):
                if isinstance(value, arb) and not value.is_finite():
                    return nonfinite()
                if self._ring.is_nonzero(value):
                    raise ResidualError(
                        f"{self._system.name}: equation {name}: the coefficient of s^{k} delta^{n} is {value}, not 0"
                    )
        total = rest / self._delta**self._order
        for n, term in enumerate(terms[self._order :]):
            total = total + norm(term) * self._delta**n
        return total.upper() if total < _LARGEST else nonfinite()

    def _minus(self, first: Sequence[Any], *others: Sequence[Any]) -> list[Any]:
        left = list(first)
        for other in others:
            left = [a - c for a, c in zip(left, other, strict=True)]
        return left

    def _convolved(self, left: Sequence[SpacePolynomial], right: Sequence[SpacePolynomial]) -> list[SpacePolynomial]:
        terms = []
        for n in range(self._end):
            total = self._zero
            for k in range(n + 1):
                if not left[n - k].is_zero() and not right[k].is_zero():
                    total = total + left[n - k] * right[k]
            terms.append(total)
        return terms


class _Functions:
    """The terms of several functions of the truncated state below an order, and their bounds."""

    def __init__(
        self,
        roots: list[Expression],
        terms: Terms,
        ring: Ring,
        state: Callable[[int], list[Any] | None],
        norm: Callable[[Any], arb],
        point: Sequence[Any],
        delta: arb,
        end: int,
    ) -> None:
        self._graph = powers_as_products(roots)
        nodes = in_order([self._graph[root] for root in roots])
        self._series = SeriesOfFunctions(nodes, terms, ring)
        changes = [[arb(0)] * end for _ in point]
        for n in range(end):
            now = state(n - 2) if n >= 2 else None
            if n == 0:
                now = [terms.constant(value) for value in point]
            elif now is None:
                now = [terms.zero(n)] * len(point)
            else:
                for i, term in enumerate(now):
                    changes[i][n] = norm(term) * delta**n
            self._series.extend(now)
        norms = {node: tuple(norm(term) * delta**n for n, term in enumerate(self._series[node])) for node in nodes}
        starts = {node: terms.at_start(self._series[node][0]) for node in nodes}
        components = [_polynomial(values) for values in changes]
        self._bounds = graded_functions(nodes, norms, starts, components)

    def __getitem__(self, root: Expression) -> list[Any]:
        return self._series[self._graph[root]]

    def graded(self, root: Expression) -> Graded:
        """The norms of a function."""
        return self._bounds[self._graph[root]]


def _polynomial(values: Sequence[arb]) -> Callable[[arb], arb]:
    """The function r -> sum of values_n r^n."""

    def value(ratio: arb) -> arb:
        total = arb(0)
        for term in reversed(values):
            total = total * ratio + term
        return total

    return value


def _padded(terms: Sequence[Any], end: int, zero: Any) -> list[Any]:
    """``end`` terms, zero beyond the last."""
    return [*terms, *[zero] * (end - len(terms))]


def _norm(term: SpacePolynomial, s: arb) -> arb:
    total = arb(0)
    for value in reversed(term.coefficients()):
        total = total * s + size_of(value)
    return total
