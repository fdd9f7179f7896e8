"""A figure of the compliant model: the exact epsilon_0 against beta, beside the one at leading order."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from flint import fmpq

from gspot_verified.compliant.contact.slow_manifold import exact_epsilon_0
from gspot_verified.leading_order.iwc import leading_order_iwc
from gspot_verified.numbers.balls import approximate
from gspot_verified.report.pictures.canvas import BLUE, INK, VERMILION, Picture, canvas, picture, styled

START = fmpq(-10)  # where the statements begin: the default of the command iwc
DIGITS = 4  # of the exact epsilon_0: more than a picture shows
START_DIGITS = 6
"""Where floor(beta) is odd the start decides: that is quickly found, and the two epsilon_0 are close to each other."""
LAST = 7  # end of the range of beta
BETAS = tuple(fmpq(k, 8) for k in range(10, 8 * LAST) if k % 8)


@dataclass(frozen=True, slots=True)
class ThresholdPoint:
    """epsilon_0 at leading order, and an enclosure of the exact one on tau >= -10; |C_1| = 1, alpha_1 = alpha_2 =
    -1."""

    beta: fmpq
    leading: fmpq
    lower: fmpq
    upper: fmpq

    @property
    def ratio(self) -> float:
        """Exact over leading order."""
        return approximate(self.lower / self.leading)


def threshold_points(betas: Iterable[fmpq] = BETAS) -> tuple[ThresholdPoint, ...]:
    """The thresholds where both ends are found; beta in (1, 13), not an integer.

    >>> [point.ratio > 1 for point in threshold_points([fmpq(3, 2), fmpq(21, 4)])]
    [True, False]
    """
    points = []
    for beta in betas:
        leading = leading_order_iwc(beta, tau_start=START)
        digits = START_DIGITS if int(beta.floor()) % 2 else DIGITS
        exact = exact_epsilon_0(leading, digits)[0]
        if leading.epsilon_0 is not None and exact is not None and exact.lower is not None and exact.upper is not None:
            points.append(ThresholdPoint(beta, leading.epsilon_0, exact.lower, exact.upper))
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
    above = sum(point.lower >= point.leading for point in points)
    below = sum(point.upper < point.leading for point in points)
    return picture(
        figure,
        "thresholds",
        "Below which ε the contact holds for every τ ≥ −10, against β",
        f"Certified: at {len(points)} values of β the exact ε₀ of the compliant model on its slow manifold lies above "
        f"the dot by at most {_percent(points)} % (|C₁| = 1, C₁/Γ(−β) > 0, α₁ = α₂ = −1). It is certainly not "
        f"smaller than at leading order at {above} of them, and certainly smaller at {below}; the dotted line is "
        "β = 5, up to which Theorem C (proofs/monotone.md) says that it is not. Where ⌊β⌋ is odd the start τ = −10 "
        "decides, where it is even a minimum inside. Not shown: other β.",
        "Groups of dots between the integers; the quotient is next to 1 for odd ⌊β⌋ and about 1.1 for even ⌊β⌋.",
    )


def _percent(points: Sequence[ThresholdPoint]) -> str:
    """The largest relative width of the enclosures in percent, rounded up to two decimals."""
    hundredths = max(int((10_000 * (point.upper / point.lower - 1)).ceil()) for point in points)
    return f"{hundredths // 100}.{hundredths % 100:02d}"
