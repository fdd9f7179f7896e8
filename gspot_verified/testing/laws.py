"""The laws of Theorem 1, checked on a system: what users run on their own mechanism."""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

from flint import arb, fmpq

from gspot_verified.expansion.residual import ResidualError, residual_bounds
from gspot_verified.expansion.series.recursion import space_of
from gspot_verified.expansion.series.spaces import SpacePolynomial
from gspot_verified.expansion.series.system import System
from gspot_verified.expansion.series.terms import NumberTerms, PolynomialTerms
from gspot_verified.expansion.time_series import compare_routes, time_series
from gspot_verified.expansion.trajectory import Trajectory
from gspot_verified.functions.derivative import lie_derivative, rewritten
from gspot_verified.functions.expressions import Constant, Expression
from gspot_verified.functions.power_series import SeriesOfFunctions
from gspot_verified.functions.rings import BALLS, RATIONALS
from gspot_verified.functions.symbols import RationalFunction, Symbols
from gspot_verified.mechanisms.expand import expand
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.numbers.balls import ball, working_bits
from gspot_verified.numbers.verdict import Outcome

_SAMPLES = 3  # points at which a law is compared
_BITS = 128  # of the values that are compared
_DISTANCES = (4, 12, 40)
_PARTS = 67  # of 1: a value of a symbol is so many of them; a prime, so that few denominators vanish
_FUNCTIONS = ("F", "G", "y", "v", "p", "b", "alpha_1", "alpha_2", "alpha_3", "J")  # of a system


def check_expansion(source: Mechanism | System, order: int, *, spot: int | None = None) -> Trajectory:
    """Check every law of Theorem 1 that can be checked on the first ``order`` orders, and return them.

    The orders are those of ``expand`` with the same arguments: of a mechanism at its G-spot, or at that of the number
    ``spot``, or of a system.

    - the functions are the Lie derivatives that the theorem assumes (at random points, for random values of symbols);
    - each term lies in its space;
    - the residual of the equations and conditions has no order below ``order`` (not where parameters are symbols);
    - p = P(xi), b = B(xi), y = Y(xi), v = V(xi) for all s;
    - the power series in (t, epsilon), found without the inner scale, has the same coefficients;
    - one more order changes none of the terms.

    In balls "the same" means that no two balls exclude each other; one that is not finite is the same as none.

    :raises AssertionError: a law fails; the message says which and where.
    :raises GSpotError: there is no G-spot at which Theorem 1 holds, at the place of the mechanism or system.
    :raises TypeError, ValueError: as ``expand``.

    >>> from gspot_verified import load
    >>> from gspot_verified.testing import extended_example
    >>> check_expansion(extended_example(chi=1), 7).z[6]
    SpacePolynomial.from_list(3, [6672/5, 0, 0, -368/5])
    >>> check_expansion(load("extended", chi=1), 7).z[6]
    SpacePolynomial.from_list(3, [6672/5, 0, 0, -368/5])
    """
    trajectory = expand(source, order, spot=spot)
    system = trajectory.system
    check_lie_derivatives(system)
    check_trajectory(trajectory)
    longer = expand(source, order + 1, spot=spot).terms()
    for name, terms in trajectory.terms().items():
        for n, term in enumerate(terms):
            _require(_same(term, longer[name][n]), system, f"{name}_{n} changes when one more order is asked for")
    return trajectory


def check_trajectory(trajectory: Trajectory) -> None:
    """The laws of :func:`check_expansion` that concern given terms.

    :raises AssertionError: a law fails.
    """
    system = trajectory.system
    check_spaces(trajectory)
    if isinstance(system.ring.number(0), fmpq | arb):
        try:
            residual_bounds(trajectory, 1, 1)
        except ResidualError as error:
            raise AssertionError(str(error)) from None
    check_synchronisation(trajectory)
    routes = compare_routes(trajectory.in_time(), time_series(system, trajectory.order))
    exact_numbers = not isinstance(system.ring.number(0), arb)
    bad = routes.outcome is Outcome.REFUTED or (exact_numbers and routes.outcome is Outcome.UNDECIDED)
    _require(not bad, system, str(routes))


def check_spaces(trajectory: Trajectory) -> None:
    """Each term has only powers of s that its space P_n of Theorem 1 has.

    :raises AssertionError: one has another, or is not finite.
    """
    for name, terms in trajectory.terms().items():
        variable = "xi" if name.startswith("xi") else name.removesuffix("_n")
        for n, term in enumerate(terms):
            space = space_of(variable, n)
            _require(_is_finite(term), trajectory.system, f"{name}_{n} is not finite, so nothing is compared with it")
            for k, value in enumerate(term.coefficients()):
                inside = k <= space and (space - k) % 3 == 0
                _require(
                    inside or trajectory.system.ring.is_zero(value),
                    trajectory.system,
                    f"{name}_{n} has a term in s^{k}, which P_{space} does not have",
                )


def check_synchronisation(trajectory: Trajectory) -> None:
    """p = P(xi), b = B(xi), y = Y(xi), v = V(xi) along the expansion, for all s.

    :raises AssertionError: an order differs: the functions are not Lie derivatives of each other as Sec. 5 assumes.
    """
    system, ring = trajectory.system, trajectory.system.ring
    pairs = (
        ("p", system.p, trajectory.p, 0),
        ("b", system.b, trajectory.b, 0),
        ("y", system.y, trajectory.y, 4),
        ("v", system.v, trajectory.v, 2),
    )
    terms = PolynomialTerms(ring)
    series = SeriesOfFunctions([function for _, function, _, _ in pairs], terms, ring)
    series.extend([terms.constant(value) for value in system.point])
    series.extend([terms.zero(1)] * len(system.point))
    for n in range(trajectory.order):
        series.extend([component[n] for component in trajectory.xi])
        for name, function, known, shift in pairs:
            expected = known[n - shift] if n >= shift else terms.zero(n)
            same = _same(series[function][n + 2], expected)
            _require(same, system, f"{name} and its function of xi differ at delta^{n + 2}: {series[function][n + 2]}")


def check_lie_derivatives(system: System, seed: int = 0) -> None:
    """The functions are Lie derivatives of each other, as Sec. 5 assumes: L_G y = 0, L_F y = v, and so on.

    Compared in balls at random points near the G-spot, with random rationals in the place of symbols.

    :raises AssertionError: two functions differ at a point; or at none of the points tried all have finite values, so
        that nothing was compared.
    """
    source = random.Random(seed)
    if isinstance(system.ring, Symbols):
        system = _with_numbers(system, system.ring, source)
    F, G, zero = system.F, system.G, Constant(fmpq(0))
    laws = (
        ("L_F y = v", lie_derivative(system.y, F), system.v),
        ("L_G y = 0", lie_derivative(system.y, G), zero),
        ("L_F v = b", lie_derivative(system.v, F), system.b),
        ("L_G v = p", lie_derivative(system.v, G), system.p),
        ("L_G p = 0", lie_derivative(system.p, G), zero),
        ("L_F p = alpha_1", lie_derivative(system.p, F), system.alpha_1),
        ("L_F b = alpha_2", lie_derivative(system.b, F), system.alpha_2),
        ("L_G b = -alpha_3", lie_derivative(system.b, G), -system.alpha_3),
    )
    compared = 0
    with working_bits(_BITS):
        for values in _near(system, [side for _, left, right in laws for side in (left, right)], source):
            compared += 1
            for name, left, right in laws:
                computed, wanted = values[left][0], values[right][0]
                _require(
                    not BALLS.is_nonzero(computed - wanted),
                    system,
                    f"{name} fails near the G-spot: {computed} is not {wanted}",
                )
    _require(compared > 0, system, "no point near the G-spot was found at which the functions are defined")


def _with_numbers(system: System, ring: Symbols, source: random.Random) -> System:
    """The system for random values of its symbols."""
    numbers = [fmpq(source.randint(1, 64), _PARTS) for _ in ring.names]

    def value(number: Any) -> Any:
        return number.at(numbers) if isinstance(number, RationalFunction) else number

    held = {name: getattr(system, name) for name in _FUNCTIONS}
    made = rewritten(
        [each for function in held.values() for each in (function if isinstance(function, tuple) else (function,))],
        lambda node: Constant(value(node.value)) if isinstance(node, Constant) else None,
    )
    functions: dict[str, Any] = {
        name: tuple(made[each] for each in function) if isinstance(function, tuple) else made[function]
        for name, function in held.items()
    }
    return replace(system, ring=RATIONALS, point=tuple(map(value, system.point)), **functions)


def _near(system: System, functions: Sequence[Expression], source: random.Random) -> Iterator[SeriesOfFunctions]:
    """The values of the functions at random points, closer to the G-spot where they are not defined or not finite."""
    for _ in range(_SAMPLES):
        steps = [fmpq(source.randint(-64, 64), 64) for _ in system.point]
        for exponent in _DISTANCES:
            values = SeriesOfFunctions(functions, NumberTerms(BALLS), BALLS)
            try:
                values.extend(
                    [ball(start) + arb(step / 2**exponent) for start, step in zip(system.point, steps, strict=True)]
                )
            except ValueError:
                continue
            if all(values[function][0].is_finite() for function in functions):
                yield values
                break


def _same(left: SpacePolynomial, right: SpacePolynomial) -> bool:
    """All coefficients are finite, and none differs for certain."""
    gap = left - right
    return _is_finite(gap) and not any(left.ring.is_nonzero(value) for value in gap.coefficients())


def _is_finite(term: SpacePolynomial) -> bool:
    return all(not isinstance(value, arb) or value.is_finite() for value in term.coefficients())


def _require(holds: bool, system: System, message: str) -> None:
    if not holds:
        raise AssertionError(f"{system.name}: {message}")
