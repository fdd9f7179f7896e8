"""The figure of the count law."""

from __future__ import annotations

import re

from gspot_verified.report.figures import count_law_figure


def test_the_bars_are_those_of_the_law(monkeypatch) -> None:
    drawn = {}
    original = count_law_figure.picture

    def kept(figure, *texts):
        [axes] = figure.axes
        drawn["bars"] = [[bar.get_height() for bar in container] for container in axes.containers]
        drawn["dots"] = list(axes.lines[0].get_ydata())
        return original(figure, *texts)

    monkeypatch.setattr(count_law_figure, "picture", kept)
    found = count_law_figure.count_law_picture()
    positive, negative = drawn["bars"]
    assert positive == [0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4]
    assert negative == [0, 0, 1] * 4
    # β = n, n - 1 = 3s + r: s positive zeros, and τ = 0 for r > 0.
    assert drawn["dots"] == [0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4]
    assert re.search(r"12\W open intervals|12 open intervals", found.caption)
