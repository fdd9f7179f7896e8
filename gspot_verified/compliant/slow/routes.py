"""The routes to the slow solution G_b(tau; eta): each chooses its plan and calls its bound.

Every route returns a valid enclosure or a ball that is not finite. None of them raises precision by itself.
"""

from __future__ import annotations

from collections.abc import Callable

from flint import arb, fmpq

from gspot_verified.compliant.slow.epsilon_series import epsilon_series
from gspot_verified.compliant.slow.grid import scale
from gspot_verified.compliant.slow.recurrence import climbed
from gspot_verified.compliant.slow.series_plan import series_plan
from gspot_verified.compliant.slow.slow_integral import slow_moments
from gspot_verified.compliant.slow.slow_plan import bits_lost, steps_from_below, trapezoid_plan
from gspot_verified.numbers.balls import Exact, approximate, digits_for_bits, nonfinite, working_bits
from gspot_verified.theta_function.gamma.reciprocal_gamma import reciprocal_gamma
from gspot_verified.theta_function.value.evaluate import evaluate

_ORDER = 4  # consecutive b that the recurrence in b begins with: proofs/slow_integral.md

Route = Callable[[Exact, Exact, Exact, int], arb]
"""From T, b, epsilon and the bits wanted to an enclosure of G_b(eta T; eta)."""


def integral(time: Exact, b: Exact, epsilon: Exact, goal: int) -> arb:
    """The trapezoidal rule for four consecutive b - n <= -1, and the recurrence from there up to b."""
    place, eta = approximate_scaled(time, epsilon)
    steps = steps_from_below(approximate(b), place, goal, eta)
    base = b - steps
    lost = bits_lost(approximate(b), place, eta, steps)
    plan = trapezoid_plan(place, approximate(base), eta, _ORDER, goal + lost)
    with working_bits(plan.bits):
        exact_eta = scale(epsilon)
        tau = exact_eta * time
        moments = slow_moments(tau, base, epsilon, _ORDER, plan)
        lowest = [value * reciprocal_gamma(j - base, plan.bits) for j, value in enumerate(moments)]
        return climbed(lowest, b, steps, tau, exact_eta)[0]


def series(time: Exact, b: Exact, epsilon: Exact, goal: int) -> arb:
    """The series in eta on Theta, Theta' and Theta'' at tau = eta T."""
    place, eta = approximate_scaled(time, epsilon)
    plan = series_plan(place, approximate(b), eta, goal)
    if plan is None:
        return nonfinite()
    with working_bits(plan.bits + 32):
        exact_eta = scale(epsilon)
        tau = exact_eta * time
    digits = digits_for_bits(plan.bits)
    first = [evaluate(tau, b, derivative=j, digits=digits).value for j in range(3)]
    places = [(arb(rising), arb(falling)) for rising, falling in plan.places]
    return epsilon_series(first, tau, b, exact_eta, places, plan.bits)


def polynomial(time: Exact, b: Exact, epsilon: Exact, goal: int) -> arb:
    """b = 0, 1, 2, ...: the recurrence from G_0 = 1 alone, because the factors of what stands below G_0 vanish."""
    if not (isinstance(b, fmpq) and b.q == 1 and b >= 0):
        return nonfinite()
    steps = int(b.p)
    with working_bits(goal + 8 * steps + 32):
        eta = scale(epsilon)
        return climbed([arb(1), arb(0), arb(0), arb(0)], b, steps, eta * time, eta)[0]


def approximate_scaled(time: Exact, epsilon: Exact) -> tuple[float, float]:
    """tau and eta as floats, for heuristics."""
    eta = (approximate(epsilon) / 2) ** (1 / 3)
    return eta * approximate(time), eta


ROUTES: dict[str, Route] = {"integral": integral, "series": series, "polynomial": polynomial}
