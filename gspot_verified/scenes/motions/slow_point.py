"""A point next to the slow manifold of slip, from its expansion in epsilon. Heuristic: any start is a start.

On the manifold Y, V, Z follow the slow states. With t = epsilon T, along a motion on it

    V = epsilon Y',   lambda = (epsilon V' - b)/p,   Z = -(lambda + c epsilon Z')/k_1,   Y = Z - lambda/k_2

(' = d/dt; eqs. compliant1 to compl2 with Y' = V, V' = b + p lambda in the fast time). Started from the equilibrium of
the fast variables, V = 0, lambda = -b/p, these four and the rates of the slow states are put into each other as Taylor
polynomials in t. The term of t^j epsilon^k needs those of t^(j+1) epsilon^(k-1) and t^(j-1) epsilon^k: degree N and
2 N + 2 rounds give all orders up to epsilon^N at t = 0. The expansion diverges as a rule; N is raised as long as it
helps.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from flint import arb, arb_series, fmpq

from gspot_verified.functions.derivative import ONE, ZERO
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.integrator.field.no_series import NoSeriesError
from gspot_verified.leading_order.contact_force import rational
from gspot_verified.numbers.balls import approximate, series_length, working_bits
from gspot_verified.scenes.equations.motion import SceneError
from gspot_verified.scenes.equations.scaled_system import ScaledSystem

_BITS = 400  # of the Taylor polynomials
_HIGHEST = 24  # order in epsilon, against endless work
_DIGITS = 25  # significant ones of the point
_NO_MANIFOLD = (
    "start: no slow manifold of slip there: it needs p > 0, where it attracts, and b < 0, so that its force -b/p pushes"
)
_SMALL = 1e-22  # relative change from which on more orders are not seen in the digits kept


@dataclass(frozen=True)
class SlowPoint:
    """Y, V, Z of the point, exact decimals; ``order`` in epsilon; ``last``: the relative change by the last order that
    helped, a measure of the distance from the manifold and no bound."""

    Y: fmpq
    V: fmpq
    Z: fmpq
    order: int
    last: float

    def unscaled(self, epsilon: fmpq) -> dict[str, fmpq]:
        """y, v, z."""
        return {"y": epsilon**2 * self.Y, "v": epsilon * self.V, "z": epsilon**2 * self.Z}

    def __str__(self) -> str:
        return (
            f"start on slip: an exact point next to its slow manifold, from the expansion to epsilon^{self.order}; "
            f"its distance from the manifold is not bounded (the last order changed it by {self.last:.0e} of itself)"
        )


def slow_point(
    system: ScaledSystem, start: Mapping[str, fmpq | arb], epsilon: fmpq, constants: Mapping[str, fmpq]
) -> SlowPoint:
    """The point over the slow states of ``start``.

    ``system``: the equations of slip; ``constants``: k_1, k_2, damping.

    :raises SceneError: p is not positive there, or b not negative, so that there is no slow manifold that attracts and
        pushes; or epsilon is too large for its expansion.
    """
    with working_bits(_BITS):
        expansion = _Expansion(system, start, epsilon, constants)
        best, order, last = expansion.fast(0), 0, 1.0
        for n in range(2, _HIGHEST + 1, 2):
            try:
                found = expansion.fast(n)
            except SceneError:
                break
            change = max(approximate(abs(new - old)) for new, old in zip(found, best, strict=True))
            change /= max(approximate(abs(value)) for value in found)
            if not change < last:
                break
            best, order, last = found, n, change
            if change < _SMALL:
                break
        if order == 0:
            raise SceneError(f"start: epsilon = {epsilon} is too large for the slow manifold's expansion there")
        Y, V, Z = (rational(value.mid().str(_DIGITS, radius=False), "start") for value in best)
    return SlowPoint(Y, V, Z, order, last)


class _Expansion:
    """The Taylor polynomials of all states and of the force along a motion on the manifold, of rising degree."""

    def __init__(
        self, system: ScaledSystem, start: Mapping[str, fmpq | arb], epsilon: fmpq, constants: Mapping[str, fmpq]
    ) -> None:
        self._epsilon, self._names = arb(epsilon), system.states
        self._k_1, self._k_2, self._c = (arb(constants[name]) for name in ("k_1", "k_2", "damping"))
        functions = dict(zip(self._names, system.right_hand_side, strict=True))
        functions |= {"Y": system.shown("b"), "V": system.shown("p"), "Z": ZERO}
        self._field = VectorField([*functions.values(), ONE])
        self._curves = {name: [arb(start[name])] for name in self._names}
        self._curves |= {name: [arb(0)] for name in "YVZ"}

    def fast(self, degree: int) -> tuple[arb, arb, arb]:
        """Y, V, Z at t = 0 with all orders up to epsilon^degree, and some of those above it."""
        length = degree + 1
        with series_length(length):
            for _ in range(length + 1 if degree else 1):
                self._round(length)
        return self._curves["Y"][0], self._curves["V"][0], self._curves["Z"][0]

    def _round(self, length: int) -> None:
        small, curves = self._epsilon, self._curves
        series = [arb_series(curves[name], length) for name in self._names]
        try:
            found = self._field.series([*series, arb_series([0, 1 / small], length)])
            values = dict(zip(self._names, found[:-1], strict=True))
            b, p, V = values["Y"], values["V"], arb_series(_rate(curves["Y"], small), length)
            force = (arb_series(_rate(V.coeffs(), small), length) - b) / p
        except (NoSeriesError, ZeroDivisionError, ValueError):
            raise SceneError(_NO_MANIFOLD) from None
        if not (p.coeffs()[:1] and p.coeffs()[0] > 0 and force.coeffs()[:1] and force.coeffs()[0] > 0):
            raise SceneError(_NO_MANIFOLD)
        Z = (arb_series(_rate(curves["Z"], small), length) * self._c + force) / -self._k_1
        for name, rate in values.items():
            if name not in "YVZ":
                curves[name] = [curves[name][0], *(term / (small * (j + 1)) for j, term in enumerate(rate.coeffs()))]
        curves |= {"Y": (Z - force / self._k_2).coeffs(), "V": V.coeffs(), "Z": Z.coeffs()}
        for name, terms in curves.items():
            curves[name] = [term.mid() for term in terms[:length]] or [arb(0)]


def _rate(terms: list[arb], small: arb) -> list[arb]:
    """epsilon d/dt of a polynomial in t."""
    return [small * j * term for j, term in enumerate(terms)][1:]
