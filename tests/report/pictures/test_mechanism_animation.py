"""The animation: well-formed, without a script; each attribute moves through the places of the shapes, in time."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

import numpy as np
import pytest

from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.report import plot
from gspot_verified.report.pictures import mechanism_animation as module
from gspot_verified.report.pictures.canvas import Picture
from gspot_verified.report.pictures.mechanism_animation import Film, chosen_rows, mechanism_animation
from gspot_verified.report.pictures.mechanism_shape import Shapes
from gspot_verified.scenes.effects.lift_off import LIFT_OFF
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.floats.whole_states import whole_states
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.run import SceneRun
from gspot_verified.scenes.scene.samples import Samples
from gspot_verified.scenes.scene.scene import SceneError

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
SVG = "{http://www.w3.org/2000/svg}"
SCENE = load_scene("rod", epsilon="1/100")


@pytest.fixture(scope="module")
def run() -> SceneRun:
    return float_run(SCENE, points=51)


@pytest.fixture(scope="module")
def animation(run: SceneRun) -> Picture:
    return mechanism_animation(SCENE, run)


@pytest.fixture(scope="module")
def tree(animation: Picture) -> Element:
    return ElementTree.fromstring(animation.svg)


@pytest.fixture(scope="module")
def film(run: SceneRun) -> Film:
    assert run.samples is not None
    assert SCENE.mechanism is not None
    rows, states = chosen_rows(run.samples), whole_states(SCENE, run.samples)
    shapes = Shapes(shift(SCENE.mechanism))
    return Film.of(run.samples, rows, [shapes.at(states[row]) for row in rows])


def moves(tree: Element) -> Iterator[tuple[Element, Element, list[float], list[str]]]:
    """Each element that moves, what moves it, when, and through which values."""
    for parent in tree.iter():
        for child in parent:
            if child.tag in (f"{SVG}animate", f"{SVG}animateTransform"):
                times = [float(part) for part in child.attrib["keyTimes"].split(";")]
                yield parent, child, times, child.attrib["values"].split(";")


def points(text: str) -> list[list[float]]:
    return [[float(part) for part in pair.split(",")] for pair in text.split()]


def test_it_is_well_formed_and_needs_nothing(animation: Picture, tree: Element) -> None:
    assert {node.tag.removeprefix(SVG) for node in tree.iter()} <= {
        "svg", "style", "title", "rect", "text", "g", "path", "polyline", "circle", "animate", "animateTransform",
    }  # fmt: skip
    assert "href" not in animation.svg
    assert "url(" not in animation.svg
    assert not [name for node in tree.iter() for name in node.attrib if name.startswith("on")]
    assert "nan" not in animation.svg
    assert animation.png.startswith(b"\x89PNG")


def test_times_are_as_browsers_want_them(tree: Element) -> None:
    """SMIL: as many as values, from 0, never falling; the last is 1 where values are joined by ways."""
    found = list(moves(tree))
    assert len(found) > 8
    for parent, child, times, values in found:
        assert len(times) == len(values)
        assert times[0] == 0
        assert times == sorted(times)
        assert times[-1] == 1 or child.attrib.get("calcMode") == "discrete"
        assert child.attrib["dur"] == "8s"
        if child.tag == f"{SVG}animate":
            assert parent.attrib[child.attrib["attributeName"]] == values[0]


def test_the_bodies_move_through_the_places_of_the_shapes(tree: Element, film: Film) -> None:
    """One similarity of the plane takes all of them to the picture: it is found from the first frame."""
    rod, *_ = tree.findall(f"{SVG}polyline")
    drawn = [points(text) for text in rod[0].attrib["values"].split(";")]
    places = [*film.shapes, film.shapes[-1]]
    (a, b), (c, d) = film.shapes[0].lines[0], drawn[0]
    scale = (d[0] - c[0]) / (b[0] - a[0])
    assert -scale == pytest.approx((d[1] - c[1]) / (b[1] - a[1]), rel=1e-2)
    assert len(drawn) == len(places)
    for shape, line in zip(places, drawn, strict=True):
        for place, point in zip(shape.lines[0], line, strict=True):
            assert point[0] == pytest.approx(c[0] + scale * (place[0] - a[0]), abs=0.4)
            assert point[1] == pytest.approx(c[1] - scale * (place[1] - a[1]), abs=0.4)
    assert np.ptp([line[1][0] for line in drawn]) > 50


def test_the_time_of_each_frame_is_that_of_its_row(tree: Element, film: Film, run: SceneRun) -> None:
    assert run.samples is not None
    rows = chosen_rows(run.samples)
    assert film.times == tuple(run.samples.columns["t"][rows])
    shares = [time / film.times[-1] * 7 / 8 for time in film.times]
    assert film.shares == pytest.approx(shares)
    (column,) = [parent for parent, child, _, _ in moves(tree) if child.tag == f"{SVG}animateTransform"]
    shown = [str(text.text) for text in column.findall(f"{SVG}text")]
    assert [float(text.removeprefix("t = ")) for text in shown] == pytest.approx(film.times, abs=5e-4)


def test_phases_are_named_and_coloured_while_they_last(tree: Element, film: Film, run: SceneRun) -> None:
    assert run.samples is not None
    lasting = dict.fromkeys(run.samples.phases)
    assert film.phases == tuple(lasting)
    for name in lasting:
        (text,) = [node for group in tree.findall(f"{SVG}g") for node in group if node.text == name]
        (group,) = [node for node in tree.findall(f"{SVG}g") if text in node]
        times, values = (group[0].attrib[key].split(";") for key in ("keyTimes", "values"))
        for share, shape_phase in zip(
            film.shares, (run.samples.phases[k] for k in chosen_rows(run.samples)), strict=True
        ):
            last = max(k for k, time in enumerate(times) if float(time) <= share + 1e-5)
            if abs(float(times[last]) - share) > 1e-4:  # at a change of phase both have a row
                assert (values[last] == "visible") == (shape_phase == name)
    bars = [node for node in tree.findall(f"{SVG}rect") if node.find(f"{SVG}title") is not None]
    assert [bar[0].text for bar in bars] == [name for name, _, _ in film.stretches]
    assert sum(float(bar.attrib["width"]) for bar in bars) == pytest.approx(680, abs=0.5)
    colours = {str(bar[0].text): bar.attrib["style"] for bar in bars}
    assert len(set(colours.values())) == len(lasting)


def test_what_it_says(animation: Picture, tree: Element, run: SceneRun) -> None:
    said = [str(node.text) for node in tree.iter(f"{SVG}text")]
    assert "falling rod in the scene rod, ε = 1/100" in said
    assert "From a run with floats, as rigid bodies: it shows, it proves nothing." in said
    assert any(f"{event.name} at t = " in line for event in run.events for line in said)
    assert "An animation shows, it proves nothing." in animation.caption
    assert f"a float run ({run.fate})" in animation.caption


def test_of_a_certified_run_the_middles_are_shown(run: SceneRun) -> None:
    """Up to the first row whose enclosure has no bounds."""
    assert run.samples is not None
    count = len(run.samples.phases)
    radii = {f"{name}_radius": np.full(count, 1e-9) for name in run.samples.columns}
    radii["y_radius"][30] = np.inf
    samples = Samples({**run.samples.columns, **radii}, run.samples.phases)
    assert len(module._known(samples).phases) == 30
    assert module._known(run.samples).phases == run.samples.phases
    drawn = mechanism_animation(SCENE, replace(run, strength="certified", samples=samples))
    assert "From the middles of certified enclosures" in drawn.svg
    assert drawn.svg.count("t = 0.") < mechanism_animation(SCENE, run).svg.count("t = 0.")


def test_a_belt_is_named() -> None:
    scene = load_scene("oscillator", epsilon="1/100")
    drawn = mechanism_animation(scene, float_run(scene, points=9))
    assert "the surface at rest though it moves" in drawn.svg
    assert "The surface moves, and is drawn at rest" in drawn.caption


def test_many_rows_become_so_many_frames_and_keep_the_ends_of_phases() -> None:
    times = np.linspace(0, 1, 5001) ** 3
    phases = (*["slip"] * 4000, *["flight"] * 1001)
    rows = chosen_rows(Samples({"t": times}, phases))
    assert {0, 3999, 4000, 5000} <= set(rows)
    assert 100 < len(rows) <= 125
    assert np.diff(times[rows]).max() < 1.5 / 120


@pytest.mark.parametrize("many", [0, 6])
def test_events_are_listed_shortly(run: SceneRun, many: int) -> None:
    event = replace(run.events[0], name=LIFT_OFF, lower=run.events[0].lower * 0 + 1)
    listed = module._events(replace(run, events=(event,) * many))
    assert listed == ("no event" if many == 0 else ", ".join(["lift-off at t = 1"] * 4) + ", and 2 more")


def test_what_cannot_be_animated(run: SceneRun) -> None:
    assert SCENE.mechanism is not None
    with pytest.raises(SceneError, match="no animation: the model system of the paper has no bodies"):
        plot.plot("animation", scene="fig-varsim1")
    with pytest.raises(SceneError, match="an animation needs a run with samples: give points"):
        mechanism_animation(SCENE, replace(run, samples=None))
    plain = replace(SCENE, mechanism=replace(SCENE.mechanism, drawing=None))
    with pytest.raises(MechanismError, match=r"falling rod: no picture: .* add a table \[drawing\]"):
        mechanism_animation(plain, run)


def test_by_its_name(tmp_path: Path, run: SceneRun, animation: Picture) -> None:
    drawn = plot.plot("animation", tmp_path / "rod.svg", scene=SCENE, run=run)
    assert drawn == animation
    assert drawn._repr_svg_() == animation.svg
    kept = (tmp_path / "rod.svg").read_text(encoding="utf-8")
    assert ElementTree.fromstring(kept).tag == f"{SVG}svg"
    assert "var(" not in kept
    assert "repeatCount" in kept


@pytest.mark.slow
@pytest.mark.skipif(CHROMIUM is None, reason="there is no Chromium here")
def test_a_browser_plays_it(tmp_path: Path, animation: Picture, film: Film) -> None:
    """Half-way between two frames the rod is half-way between their places; one phase is seen."""
    k = len(film.shares) // 3
    second = 8 * (film.shares[k] + film.shares[k + 1]) / 2
    script = (
        f"const s = document.querySelector('svg'); s.pauseAnimations(); s.setCurrentTime({second});"
        "const next = () => new Promise(requestAnimationFrame);"
        "onload = async () => { await next(); await next();"
        "const p = [...s.querySelector('polyline').animatedPoints].map(q => [q.x, q.y]);"
        "const seen = [...s.querySelectorAll('g > text[font-size=\"16\"]')].filter("
        "t => getComputedStyle(t).visibility == 'visible' && !t.textContent.startsWith('t =')).map(t => t.textContent);"
        "document.getElementById('found').textContent = JSON.stringify([p, seen]); }"
    )
    page = tmp_path / "page.html"
    page.write_text(f'<!DOCTYPE html>{animation.svg}<pre id="found"></pre><script>{script}</script>', encoding="utf-8")
    options = ["--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={tmp_path / 'profile'}", "--dump-dom"]
    options += ["--virtual-time-budget=600000", "--run-all-compositor-stages-before-draw"]
    for _ in range(20):  # a browser that is kept waiting ends its virtual time before it draws a frame: once more
        shown = subprocess.run(
            [str(CHROMIUM), *options, page.as_uri()], capture_output=True, text=True, check=True, timeout=120
        )
        (text,) = re.findall(r'<pre id="found">(.*?)</pre>', shown.stdout, re.S)
        if text:
            break
    line, seen = json.loads(text)
    tree = ElementTree.fromstring(animation.svg)
    values = tree.findall(f"{SVG}polyline")[0][0].attrib["values"].split(";")
    expected = (np.array(points(values[k])) + np.array(points(values[k + 1]))) / 2
    assert np.abs(np.array(line) - expected).max() < 0.1
    assert seen == [next(name for name, begin, end in film.stretches if begin <= film.shares[k] < end)]
