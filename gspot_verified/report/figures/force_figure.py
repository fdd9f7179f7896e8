"""A figure of the compliant model: the slow force at several epsilon above leading order, and the bound between."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from flint import arb, fmpq

from gspot_verified.compliant.slow.grid import scale
from gspot_verified.compliant.slow.slow_solution import slow_value
from gspot_verified.numbers.balls import ball, working_bits
from gspot_verified.report.pictures.canvas import COLOURS, INK, STYLES, Picture, canvas, picture, styled
from gspot_verified.theta_function.value.evaluate import evaluate

_B = fmpq(3, 2)  # beta - 1 of the drawn curves
_EPSILONS = (fmpq(1), fmpq(1, 10), fmpq(1, 1000))  # from far to close to leading order
_TUBE_EPSILON = fmpq(1, 100)  # where excess and bound are drawn
_BITS = 100  # beyond what a picture shows; any is correct


@dataclass(frozen=True, slots=True)
class ForceCurve:
    """s G_b(tau; eta) at points of tau, s = sign Gamma(-b), in balls, and whether each lies above leading order."""

    at: list[float]
    values: list[arb]
    above: list[bool]

    @property
    def middle(self) -> list[float]:
        """Floats inside the balls, for drawing."""
        return [float(value.mid()) for value in self.values]


def grid(first: int, last: int, parts: int) -> list[Fraction]:
    """Points of tau."""
    return [Fraction(k, parts) for k in range(first * parts, last * parts + 1)]


def force_curve(b: fmpq, epsilon: fmpq, points: Sequence[Fraction]) -> ForceCurve:
    """The scaled slow force eta^b s F_b(T; epsilon) at T = tau/eta, for 0 < b < 4 not an integer.

    T is a rational next to tau/eta; leading order is taken at eta T, so that both are compared at one point.
    """
    sign = -1 if int(b.floor()) % 2 == 0 else 1
    values, above = [], []
    for point in points:
        with working_bits(_BITS):
            eta = scale(epsilon)
            time = (arb(fmpq(point.numerator, point.denominator)) / eta).mid()
            tau = eta * time
        slow = slow_value(time, b, epsilon, digits=20).value
        leading = evaluate(tau, b, digits=20).value
        with working_bits(_BITS):
            value = sign * slow * eta ** ball(b)
            values.append(value)
            above.append(bool(value > sign * leading))
    return ForceCurve([float(point) for point in points], values, above)


@styled
def force_picture() -> Picture:
    """The slow force at three epsilon above leading order, and the excess with its bound at a fourth."""
    figure = canvas(5.6)
    upper, lower = figure.subplots(2, 1, sharex=True, height_ratios=(2, 1))
    points = grid(-3, 2, 12)
    curves = [force_curve(_B, epsilon, points) for epsilon in _EPSILONS]
    leading = [float(evaluate(fmpq(p.numerator, p.denominator), _B, digits=15).value.mid()) for p in points]
    upper.plot([float(p) for p in points], leading, color=INK, label="leading order, Θ(τ, 3/2)")
    for curve, epsilon, colour, style in zip(curves, _EPSILONS, COLOURS, STYLES[1:], strict=False):
        upper.plot(curve.at, curve.middle, color=colour, linestyle=style, label=f"ε = {epsilon}")
    upper.axhline(0, color=INK, linewidth=0.7)
    upper.set(ylabel="scaled deviation of the force")
    upper.legend(loc="upper center")
    tube = force_curve(_B, _TUBE_EPSILON, points)
    excess, bound = _tube(points)
    lower.fill_between(tube.at, 0, bound, color=COLOURS[3], alpha=0.25, linewidth=0, label="between the two bounds")
    lower.plot(tube.at, excess, color=COLOURS[3], label=f"excess over leading order at ε = {_TUBE_EPSILON}")
    lower.set(xlabel="τ", ylabel="excess", xlim=(-3, 2))
    lower.legend(loc="upper left")
    above = sum(sum(curve.above) for curve in [*curves, tube])
    number = len(points) * (len(curves) + 1)
    return picture(
        figure,
        "force",
        "The contact force on the slow manifold, β = 5/2, at finite ε",
        f"Certified: enclosures at {len(points)} points τ = −3, …, 2 for each ε; at {above} of {number} of them the "
        "value lies above leading order, as Theorem C says for every τ and ε (proofs/monotone.md). The shaded band is "
        "the range that its two sides leave. Only drawn: the lines between the points.",
        "Curves with one minimum each, higher for larger epsilon; below, a small positive excess inside a band.",
    )


def _tube(points: Sequence[Fraction]) -> tuple[list[float], list[float]]:
    """G_b - Theta and its upper bound (eta/8) (-b)_4 G_(b-4), s = 1 for b = 3/2."""
    factor = -_B * (1 - _B) * (2 - _B) * (3 - _B)
    excess, bound = [], []
    for point in points:
        with working_bits(_BITS):
            eta = scale(_TUBE_EPSILON)
            time = (arb(fmpq(point.numerator, point.denominator)) / eta).mid()
            tau = eta * time
        slow = slow_value(time, _B, _TUBE_EPSILON, digits=20).value
        rest = slow_value(time, _B - 4, _TUBE_EPSILON, digits=15).value
        with working_bits(_BITS):
            excess.append(float((slow * eta ** ball(_B) - evaluate(tau, _B, digits=20).value).mid()))
            bound.append(float((eta / 8 * factor * rest * eta ** ball(_B - 4)).mid()))
    return excess, bound
