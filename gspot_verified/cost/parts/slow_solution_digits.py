"""The part on finite epsilon: the slow solution of the compliant model, digits against time."""

from __future__ import annotations

import math
import warnings
from functools import partial
from typing import Any

from flint import arb, fmpq

from gspot_verified.compliant.slow.slow_plan import steps_from_below, trapezoid_plan
from gspot_verified.compliant.slow.slow_solution import slow_value
from gspot_verified.cost.measurement.contest import Blueprint, Call, TimedRoute, best_time
from gspot_verified.cost.measurement.measurement import CERTIFIED, NO_BOUND, Limit
from gspot_verified.cost.parts.theta_digits import right_decimals
from gspot_verified.cost.times.baseline import right_digits
from gspot_verified.numbers.balls import approximate, bits_for_digits, working_bits

B = fmpq(-1, 2)  # below 0, as the integral that defines F_b needs
_EPSILONS = {"ε = 10⁻³": fmpq(1, 10**3), "ε = 10⁻¹²": fmpq(1, 10**12)}  # by the names of the panels
_DIGITS, _MORE = (15, 50, 100, 200), (500, 1_000)  # more in full
_FEW, _FEW_MORE = (15, 50), (100, 200)  # fewer digits: mpmath is slower
_LAST = 12  # x^2 where the integral is cut off: the integrand is about exp(-2 x^6)


def _ours(epsilon: fmpq, digits: int) -> Call:
    return partial(slow_value, 0, B, epsilon, 0, digits)


def by_mpmath(epsilon: fmpq, digits: int) -> Any:
    """The integral that defines F_b(0; epsilon), b = -1/2, by mpmath's quadrature, r = (3 epsilon)^(1/3) x^2."""
    import mpmath  # type: ignore[import-untyped]

    with mpmath.workdps(digits + 15):
        small = mpmath.mpf(int(epsilon.p)) / int(epsilon.q)
        unit = mpmath.cbrt(3 * small)

        def integrand(x: Any) -> Any:
            r = unit * x * x
            return 2 * mpmath.sqrt(unit) * mpmath.exp((r - r**2 / 2 - r**3 / 3 - mpmath.log1p(r)) / small)

        ends = [0, 1, 2, 3, mpmath.sqrt(_LAST)]
        return mpmath.quad(integrand, ends) * mpmath.rgamma(mpmath.mpf(1) / 2)


def by_scipy(epsilon: fmpq, tolerance: float) -> float:
    """The same in doubles by scipy's ``quad``."""
    from scipy.integrate import quad

    small = approximate(epsilon)
    unit = (3 * small) ** (1 / 3)

    def integrand(x: float) -> float:
        r = unit * x * x
        return 2 * math.sqrt(unit) * math.exp((r - r**2 / 2 - r**3 / 3 - math.log1p(r)) / small)

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # that rounding errors are seen: a plain user sees it, the clock does not
        value: float = quad(integrand, 0, math.sqrt(_LAST), epsabs=0.0, epsrel=tolerance)[0]
    return value / math.gamma(0.5)


def _contestants() -> tuple[TimedRoute, ...]:
    routes = []
    for panel, epsilon in _EPSILONS.items():
        routes += [_library(panel, epsilon), _mpmath(panel, epsilon), _scipy(panel, epsilon)]
    return tuple(routes)


def _library(panel: str, epsilon: fmpq) -> TimedRoute:
    return TimedRoute(
        "this library", CERTIFIED, _DIGITS, partial(_ours, epsilon), _MORE, panel=panel, exponent=2.5,
        place=lambda digits, value: float(digits) if value.reached else None,
        theory="about D nodes of the trapezoidal rule or D terms, each an exponential or a product of D digits",
    )  # fmt: skip


def _mpmath(panel: str, epsilon: fmpq) -> TimedRoute:
    def place(digits: int, value: Any) -> float | None:
        return right_digits(value, slow_value(0, B, epsilon, 0, digits + 5).value, digits) or None

    return TimedRoute(
        "mpmath quad", NO_BOUND, _FEW, lambda digits: partial(by_mpmath, epsilon, digits), _FEW_MORE,
        place=place, panel=panel,
    )  # fmt: skip


def _scipy(panel: str, epsilon: fmpq) -> TimedRoute:
    def place(_: float, value: float) -> float | None:
        return right_decimals(value, approximate(slow_value(0, B, epsilon, 0, 20).value))

    return TimedRoute(
        "scipy quad", NO_BOUND, (1e-3, 1e-8, 1e-13), lambda tolerance: partial(by_scipy, epsilon, tolerance),
        place=place, words=lambda tolerance: f"tolerance {tolerance:g}", panel=panel,
    )  # fmt: skip


def _limit(_: bool) -> Limit:
    epsilon, digits = _EPSILONS["ε = 10⁻³"], _DIGITS[-1]
    goal, b, eta = bits_for_digits(digits), approximate(B), approximate(epsilon / 2) ** (1 / 3)
    plan = trapezoid_plan(0.0, b - steps_from_below(b, 0.0, goal, eta), eta, 4, goal)
    nodes = plan.last - plan.first + 1
    with working_bits(plan.bits):
        argument = arb(fmpq(-7, 3))

    def exponentials() -> None:
        with working_bits(plan.bits):
            for _ in range(nodes):
                argument.exp()

    words = f"one exponential of {plan.bits} bits at each of the {nodes} nodes of the trapezoidal rule"
    return Limit(
        f"ε = 10⁻³, {digits} digits", words, best_time(exponentials, 3, fresh=False), best_time(_ours(epsilon, digits))
    )


FINITE_EPSILON = Blueprint(
    key="finite-epsilon",
    title="The compliant model at finite ε",
    question="The slow solution F_b(0; ε) of the compliant model, b = −1/2, to D digits, as the first call.",
    axis="digits D",
    symbol="D",
    contestants=_contestants,
    profiled=lambda _: ("ε = 10⁻³, 200 digits", _ours(_EPSILONS["ε = 10⁻³"], 200)),
    limit=_limit,
    remarks=(
        "mpmath and scipy integrate up to a fixed end, chosen by hand; the library bounds what is left out. At "
        "ε = 10⁻¹² doubles lose digits in ψ(r)/ε: the terms of ψ cancel.",
    ),
)
