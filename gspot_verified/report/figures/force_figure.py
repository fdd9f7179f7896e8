"""Figures of the compliant model: the slow force at several epsilon above leading order, and the exact epsilon_0."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction

from flint import arb, fmpq

from gspot_verified.compliant.contact.slow_manifold import exact_epsilon_0
from gspot_verified.compliant.slow.grid import scale
from gspot_verified.compliant.slow.slow_solution import slow_value
from gspot_verified.leading_order.iwc import leading_order_iwc
from gspot_verified.numbers.balls import approximate, ball, working_bits
from gspot_verified.report.pictures.canvas import (
    BLUE,
    COLOURS,
    INK,
    STYLES,
    VERMILION,
    Picture,
    canvas,
    picture,
    styled,
)
from gspot_verified.theta_function.value.evaluate import evaluate

START = fmpq(-10)  # where the statements begin: the default of the command iwc
DIGITS = 4  # of the exact epsilon_0: more than a picture shows
START_DIGITS = 6
"""Where floor(beta) is odd the start decides: that is quickly found, and the two epsilon_0 are close to each other."""
LAST = 7  # end of the range of beta
BETAS = tuple(fmpq(k, 8) for k in range(10, 8 * LAST) if k % 8)


@dataclass(frozen=True, slots=True)
class ThresholdPoint:
    """Enclosures of the largest epsilon_0 at leading order and of the exact one on tau >= -10; |C_1| = 1, alpha_1 =
    alpha_2 = -1."""

    beta: fmpq
    leading: arb
    lower: fmpq
    upper: fmpq

    @property
    def ratio(self) -> float:
        """Exact over leading order."""
        return approximate(arb(self.lower) / self.leading)


def threshold_points(betas: Iterable[fmpq] = BETAS) -> tuple[ThresholdPoint, ...]:
    """The thresholds where both ends are found; beta in (1, 13), not an integer.

    >>> [point.ratio > 1 for point in threshold_points([fmpq(3, 2), fmpq(21, 4)])]
    [True, False]
    """
    points = []
    for beta in betas:
        leading = leading_order_iwc(beta, tau_start=START)
        digits = START_DIGITS if int(beta.floor()) % 2 else DIGITS
        exact, largest = exact_epsilon_0(leading, digits)[0], leading.largest_epsilon
        if largest is not None and exact is not None and exact.lower is not None and exact.upper is not None:
            points.append(ThresholdPoint(beta, largest, exact.lower, exact.upper))
    return tuple(points)


def threshold_picture(points: Sequence[ThresholdPoint]) -> Picture:
    """The two epsilon_0 and their quotient, from :func:`threshold_points`.

    :raises ValueError: no points.
    """
    if not points:
        raise ValueError("there are no points to draw")
    return styled(lambda: _draw(points))()


def _draw(points: Sequence[ThresholdPoint]) -> Picture:
    figure = canvas(5.4)
    upper, lower = figure.subplots(2, 1, sharex=True, height_ratios=(3, 2))
    at = [approximate(point.beta) for point in points]
    exact, leading = [approximate(p.lower) for p in points], [approximate(p.leading) for p in points]
    upper.plot(at, leading, "o", color=INK, markerfacecolor="none", label="leading order")
    upper.plot(at, exact, ".", color=VERMILION, label="compliant model, slow manifold")
    upper.set(yscale="log", ylabel="ε₀")
    upper.legend(loc="upper right")
    lower.axhline(1, color=INK, linewidth=0.8)
    lower.plot(at, [point.ratio for point in points], ".", color=BLUE)
    lower.axvline(5, color=INK, linewidth=0.7, linestyle=":")
    lower.set(xlabel="β", ylabel="exact ε₀ / leading order", xlim=(1, None))
    above = sum(bool(arb(point.lower) >= point.leading) for point in points)
    below = sum(bool(arb(point.upper) < point.leading) for point in points)
    return picture(
        figure,
        "thresholds",
        "Below which ε the contact holds for every τ ≥ −10, against β",
        f"Certified: at {len(points)} values of β the exact ε₀ of the compliant model on its slow manifold lies above "
        f"the dot by at most {_percent(points)} % (|C₁| = 1, C₁/Γ(−β) > 0, α₁ = α₂ = −1). By these numbers it is "
        f"not smaller than at leading order at {above} of them, and smaller at {below}; the dotted line is "
        "β = 5, up to which Theorem C (proofs/monotone.md) says that it is not. Where ⌊β⌋ is odd the start τ = −10 "
        "decides, where it is even a minimum inside. Not shown: other β.",
        "Groups of dots between the integers; the quotient is next to 1 for odd ⌊β⌋ and about 1.1 for even ⌊β⌋.",
    )


def _percent(points: Sequence[ThresholdPoint]) -> str:
    """The largest relative width of the enclosures in percent, rounded up to two decimals."""
    hundredths = max(int((10_000 * (point.upper / point.lower - 1)).ceil()) for point in points)
    return f"{hundredths // 100}.{hundredths % 100:02d}"


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
        "The deviation of the force on the slow manifold, β = 5/2, C₁/Γ(−β) > 0, at finite ε",
        f"Certified: enclosures at {len(points)} points τ = −3, …, 2 for each ε; at {above} of {number} of them the "
        "value, in units in which leading order is Θ, lies above it, as Theorem C says for every τ and ε on this side "
        "(proofs/monotone.md; α₁ = −1, else ε|α₁| in the place of ε). The shaded band is the range that its two sides "
        "leave. Only drawn: the lines between the points.",
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
