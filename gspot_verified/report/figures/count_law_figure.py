"""A figure of the count law: how many real zeros dTheta/dtau has for every beta up to 12."""

from __future__ import annotations

from flint import fmpq

from gspot_verified.report.pictures.canvas import BLUE, INK, ORANGE, Picture, canvas, picture, styled
from gspot_verified.signs.gamma.count_law import negative_zeros, number_of_zeros, positive_zeros

_LAST = 12  # end of the range of beta


@styled
def count_law_picture() -> Picture:
    """The positive and the negative zeros on each open interval between integers, and all zeros at the integers."""
    figure = canvas(3.4)
    axes = figure.add_subplot()
    middles = [fmpq(2 * m + 1, 2) for m in range(_LAST)]
    at = [float(beta.p) / float(beta.q) for beta in middles]
    positive, negative = [positive_zeros(b) for b in middles], [negative_zeros(b) for b in middles]
    axes.bar(at, positive, width=0.94, color=BLUE, alpha=0.8, label="τ > 0")
    axes.bar(at, negative, width=0.94, bottom=positive, color=ORANGE, alpha=0.8, hatch="//", label="τ < 0")
    integers = range(1, _LAST + 1)
    axes.plot(integers, [number_of_zeros(n) for n in integers], "o", color=INK, label="β an integer: all, τ = 0 too")
    axes.set(xlabel="β", ylabel="real zeros of dΘ/dτ", xlim=(0, _LAST + 0.3), xticks=range(_LAST + 1))
    axes.set_yticks(range(max(map(sum, zip(positive, negative, strict=True))) + 2))
    axes.legend(loc="upper left", ncols=3)
    return picture(
        figure,
        "count_law",
        "The count law: how many real zeros dΘ/dτ has",
        f"Certified: the number for every β in (0, {_LAST}], by the count law (proofs/count_law.md). It is the same on "
        f"each of the {_LAST} open intervals between integers (bars; all zeros are simple there); at the integers "
        "different zeros are counted once each (dots). On (0, 1) there are none. Not shown: larger β, for which the "
        "law holds, too.",
        "Bars that grow by one at beta = 1, 4, 7, 10, with one more in each third interval, for a negative zero.",
    )
