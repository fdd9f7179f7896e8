from __future__ import annotations

import io
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import numpy as np
from matplotlib import image

from gspot_verified.report.figures import figures
from gspot_verified.work.executors import as_they_end, executor

NAMES = ["atlas", "theta", "slope", "routes", "sides", "series", "force"]
OF_WHAT_IS_NEW = ["count_law", "second_trajectory", "side_map", "uniform"]


def test_the_figures_have_texts(pictures):
    assert [picture.name for picture in pictures] == NAMES + OF_WHAT_IS_NEW
    for picture in pictures:
        assert "Certified:" in picture.caption
        assert "nan" not in (picture.title + picture.caption + picture.alternative).lower().split()


def test_figures_are_finite_and_not_empty(pictures):
    for picture in pictures:
        assert len(ElementTree.fromstring(picture.svg).findall(".//{*}path")) > 20
        for path in re.findall(r'\bd="([^"]*)"', picture.svg):
            assert not re.search(r"nan|inf", path)
        pixels = image.imread(io.BytesIO(picture.png))
        assert pixels.shape[1] > 1000
        assert len(np.unique(pixels[::7, ::7].reshape(-1, pixels.shape[2]), axis=0)) > 50


def test_a_fresh_process_draws_the_same_bytes(pictures):
    with executor(2) as pool:
        drawn = dict(as_they_end(pool, {"theta": figures.theta_picture, "sides": figures.sides_picture}))
    assert (drawn["theta"], drawn["sides"]) == (pictures[1], pictures[4])


def test_captions_count_what_was_certified(pictures):
    captions = {picture.name: picture.caption for picture in pictures}
    assert "685 of 685 have 12 significant digits" in captions["theta"]
    assert "all 360 boxes lie below 0" in captions["slope"]
    assert "certain at 164 of 164 points" in captions["series"]
    assert "at 244 of 244 of them the value lies above leading order" in captions["force"]


def test_slope_caption_says_so_when_a_box_is_not_settled(monkeypatch):
    monkeypatch.setattr(figures, "slope_boxes", lambda _, first, last: original("3/2", first, last))
    caption = figures.slope_picture().caption
    assert "of 360 boxes lie below 0; for the others the sign is not settled here" in caption
    assert "at every τ" not in caption


original = figures.slope_boxes


def test_importing_the_report_loads_no_matplotlib():
    code = "import sys, gspot_verified.report; sys.exit('matplotlib' in sys.modules or 'jinja2' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_the_bars_are_those_of_the_law(monkeypatch) -> None:
    drawn = {}
    original = figures.picture

    def kept(figure, *texts):
        [axes] = figure.axes
        drawn["bars"] = [[bar.get_height() for bar in container] for container in axes.containers]
        drawn["dots"] = list(axes.lines[0].get_ydata())
        return original(figure, *texts)

    monkeypatch.setattr(figures, "picture", kept)
    found = figures.count_law_picture()
    positive, negative = drawn["bars"]
    assert positive == [0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4]
    assert negative == [0, 0, 1] * 4
    # β = n, n - 1 = 3s + r: s positive zeros, and τ = 0 for r > 0.
    assert drawn["dots"] == [0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4]
    assert re.search(r"12\W open intervals|12 open intervals", found.caption)
