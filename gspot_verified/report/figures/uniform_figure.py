"""A figure of Theorem U1: how far true solutions are from the truncated expansion, piece by piece of s."""

from __future__ import annotations

from flint import fmpq

from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.expansion.true_solutions.bound import UniformBound, uniform_bound
from gspot_verified.numbers.balls import approximate, float_bounds
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.report.pictures.canvas import COLOURS, LAMBDA_N, STYLES, Picture, canvas, picture, styled
from gspot_verified.testing import extended_example

_ORDER = 6  # terms of the expansion: enough for pieces that are not too short
_START, _END, _DELTA = fmpq(-3), fmpq(2), fmpq(1, 20)  # of s and of delta: as in the example of uniform_bound
_SHOWN = {"p": "p", "b": "b", "y": "y", "v": "v", "lambda_n": LAMBDA_N}


def drawn_bound() -> UniformBound:
    """The bound of the figure: the extended example with χ = 1."""
    return uniform_bound(expand_system(extended_example(chi=1), _ORDER), _START, _END, _DELTA)


def _typed(words: str) -> str:
    """A verdict in the letters and signs of a caption."""
    for plain, typed in (("delta", "δ"), ("<=", "≤"), ("-", "−")):
        words = words.replace(plain, typed)
    return words


@styled
def uniform_picture() -> Picture:
    """The constants K of five variables on the pieces of s."""
    figure = canvas(4.2)
    axes = figure.add_subplot()
    bound = drawn_bound()
    edges = [approximate(one.start) for one in bound.stretches] + [approximate(bound.stretches[-1].end)]
    for (name, words), colour, style in zip(_SHOWN.items(), COLOURS, STYLES, strict=True):
        sizes = [float_bounds(one.constants[name])[1] for one in bound.stretches]
        axes.stairs(sizes, edges, baseline=None, color=colour, linestyle=style, linewidth=1.7, label=words)
    axes.set(
        yscale="log",
        xlabel="s",
        ylabel=rf"$K$: within $K\,\delta^{{{_ORDER}}}$ of the expansion",
        xlim=(edges[0], edges[-1]),
    )
    axes.legend(loc="upper left", ncols=len(_SHOWN))
    proved = bound.verdict.outcome is Outcome.PROVED
    finding = f"Certified: {bound.verdict.statement}" if proved else f"Not proved to the end: {bound.verdict.detail}"
    return picture(
        figure,
        "uniform",
        "How far true solutions are from the expansion, for all small ε at once",
        f"{_typed(finding)}. K is drawn for the scaled variables of the extended example with χ = 1, on "
        f"each of {len(bound.stretches)} pieces of s, rounded upwards; δ = ε^(1/3). The bound is by Theorem U1 "
        "(proofs/uniform.md), in contact and in positive slip.",
        "Five staircases that rise with s on a logarithmic scale.",
    )
