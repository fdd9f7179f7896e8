"""A figure of the second smooth trajectory of the motivating example: its distance from the trivial one at t = 0."""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.numbers.balls import certainly_less, float_bounds, working_bits
from gspot_verified.report.pictures.canvas import COLOURS, INK, STYLES, Picture, canvas, picture, styled

_EPSILONS = tuple(fmpq(k, 100) for k in range(12, 101, 2))
_POWERS = {1: "ε", 2: "ε²", 4: "ε⁴", 8: "ε⁸", 16: "ε¹⁶"}
_BITS = 100  # beyond what a picture shows


def distance(epsilon: fmpq) -> arb:
    """e^(-1/epsilon^2): b of the second trajectory at t = 0, where the trivial one has b = 0
    (proofs/smooth_trajectory.md, section 3)."""
    with working_bits(_BITS):
        return (-1 / arb(epsilon) ** 2).exp()


@styled
def second_trajectory_picture() -> Picture:
    """The distance beside powers of epsilon."""
    figure = canvas(4.2)
    axes = figure.add_subplot()
    at = [float(epsilon.p) / float(epsilon.q) for epsilon in _EPSILONS]
    distances = [distance(epsilon) for epsilon in _EPSILONS]
    for (power, words), colour, style in zip(_POWERS.items(), COLOURS, STYLES, strict=True):
        axes.semilogy(at, [epsilon**power for epsilon in at], color=colour, linestyle=style, label=words)
    axes.semilogy(
        at, [sum(float_bounds(value)) / 2 for value in distances], color=INK, label=r"$\exp(-1/\varepsilon^2)$"
    )
    axes.set(xlabel="ε", ylabel="distance in b at t = 0", xlim=(at[0], 1), ylim=(1e-31, 3))
    axes.legend(loc="lower right")
    below = sum(
        certainly_less(value, arb(epsilon) ** power) is True
        for epsilon, value in zip(_EPSILONS, distances, strict=True)
        for power in _POWERS
    )
    return picture(
        figure,
        "second_trajectory",
        "A second smooth trajectory, under every power of ε",
        f"Certified: enclosures of e^(−1/ε²), the distance in b of the second trajectory from the trivial one at "
        f"t = 0, at {len(_EPSILONS)} points ε = 3/25, 7/50, …, 1; at {below} of {len(_EPSILONS) * len(_POWERS)} places "
        "it is certainly below the drawn power of ε. That it is below every power once ε is small, with all "
        "derivatives, is the theorem of proofs/smooth_trajectory.md, not a finding of this figure. Only drawn: the "
        "lines between.",
        "Five straight-looking powers that bend down at the left, and one curve that falls below all of them.",
    )
