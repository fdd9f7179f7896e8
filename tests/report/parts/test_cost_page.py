"""The page on cost: what a measurement says is on it, labelled as recorded; the figures are SVG in two themes."""

from __future__ import annotations

import html
import json
import re
import xml.etree.ElementTree as ElementTree
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import pytest

import gspot_verified
from gspot_verified.cli import main
from gspot_verified.cost.measurement.file import recorded, save
from gspot_verified.cost.measurement.measurement import (
    CERTIFIED,
    FILES,
    NO_BOUND,
    Measurement,
    Part,
    Point,
    Route,
    files_key,
)
from gspot_verified.report.data import report_data
from gspot_verified.report.parts.cost_page import (
    GONE,
    cost_chart,
    cost_figures,
    file_of_module,
    shown_measurement,
    spread,
)
from gspot_verified.report.site import pages

PACKAGE = Path(gspot_verified.__file__).parent


def part(*routes: Route) -> Part:
    return Part("key", "Title", "Question", "digits D", "D", routes)


def route(name: str, kind: str = CERTIFIED, panel: str = "") -> Route:
    points = tuple(Point(place, f"{place:g} <digits>", best, best, 1) for place, best in ((1.0, 1e-5), (100.0, 2.0)))
    return Route(name, kind, points, panel=panel)


@pytest.fixture(scope="module")
def page() -> str:
    return pages(report_data([], [], []))["cost.html"]


def test_the_page_says_that_it_was_recorded(page: str) -> None:
    found = recorded()
    assert f"Recorded on {found.date}, not measured when this page was written" in page
    assert found.machine in page
    assert "gspot-verified report --cost cost.json" in page
    for name, version in found.versions:
        assert f"<dt>{name}</dt><dd>{version}</dd>" in page


OTHER_FILES = "These times are of other files of this package than those of this version"


@pytest.mark.parametrize("files", [files_key(), "0" * 16, None])
def test_a_record_of_other_files_is_said_to_be_one(files: str | None) -> None:
    """The record that comes with the package, as if it were of today's files, of others, and of files not named."""
    rest = tuple(pair for pair in recorded().versions if pair[0] != FILES)
    measured = replace(recorded(), versions=(*rest, *([] if files is None else [(FILES, files)])))
    assert measured.of_other_files is (files != files_key())
    page = pages(report_data([], [], []), measurement=measured)["cost.html"]
    assert (OTHER_FILES in page) is measured.of_other_files


def test_the_page_compares_the_record_that_comes_with_the_package(page: str) -> None:
    assert (OTHER_FILES in page) is (dict(recorded().versions).get(FILES) != files_key())


def test_every_part_has_a_figure_a_table_and_its_limit(page: str) -> None:
    for item in recorded().parts:
        assert f'<h2 id="{item.key}">' in page
        assert f'src="figures/cost-{item.key}.svg"' in page
    assert page.count("<h3>The limit</h3>") == sum(item.limit is not None for item in recorded().parts) > 0
    assert page.count("<h3>Where the time goes</h3>") == sum(bool(item.shares) for item in recorded().parts) > 0


def test_where_the_time_goes_names_files_that_exist(page: str) -> None:
    """A record keeps the names that the modules had when it was made."""
    shares = [html.unescape(part) for part in re.findall(r"<h3>Where the time goes</h3>\s*<p>(.*?)</p>", page, re.S)]
    assert len(shares) == sum(bool(item.shares) for item in recorded().parts)
    files = re.findall(r"<code>(.*?)</code>", " ".join(shares))
    assert len(files) > 15
    assert [name for name in files if not (PACKAGE / name).is_file()] == []
    modules = {share.words for item in recorded().parts for share in item.shares if "." in share.words}
    gone = {name for name in modules if not list(PACKAGE.rglob(f"{name.rpartition('.')[2]}.py"))}
    assert [name for name in gone if name in page] == []
    assert any(GONE in part for part in shares) is bool(gone)


@pytest.mark.parametrize(
    ("module", "file"),
    [
        ("theta_function.choice", "theta_function/value/choice.py"),
        ("balls", "numbers/balls.py"),
        ("expansion.box_program", "functions/box_program.py"),
        ("expansion.packed_orders", GONE),
        ("numpy", "numpy"),
        ("all the rest", "all the rest"),
    ],
)
def test_a_measured_module_is_named_by_its_file(module: str, file: str) -> None:
    assert file_of_module(module) == file


def test_wrong_answers_are_marked_in_words(page: str) -> None:
    wrong = sum(answer.wrong(said) for answer in recorded().answers for said in (answer.doubles, answer.mpmath))
    assert len(re.findall(r'<strong class="wrong">[^<]+</strong>, wrong', page)) == wrong >= 8


def test_figures_are_well_formed_and_have_two_themes() -> None:
    figures = cost_figures(recorded())
    assert set(figures) == {f"cost-{item.key}" for item in recorded().parts}
    for svg in figures.values():
        ElementTree.fromstring(svg)
        assert "prefers-color-scheme:dark" in svg
        assert "#0072b2;" not in svg.split("</style>")[1]


def test_routes_without_a_bound_differ_by_more_than_colour() -> None:
    svg = cost_chart(part(route("sure"), route("cheap", NO_BOUND)))
    assert len(re.findall(r"<polyline[^>]*stroke-dasharray", svg)) == 1
    assert svg.count("<polyline") == 2
    assert all(f">{name}</text>" in svg for name in ("sure", "cheap"))
    assert "1 &lt;digits&gt;" in svg


def test_panels_are_drawn_below_one_another_on_the_same_scales() -> None:
    one, two = (cost_chart(part(*routes)) for routes in ([route("a")], [route("a", panel="x"), route("a", panel="y")]))
    heights = [float(re.findall(r'viewBox="0 0 \S+ (\S+)"', svg)[0]) for svg in (one, two)]
    assert heights[1] > heights[0]
    assert len(re.findall(r">x</text>|>y</text>", two)) == 2
    first, second = re.findall(r'points="([^"]+)"', two)
    assert [pair.split(",")[0] for pair in first.split()] == [pair.split(",")[0] for pair in second.split()]


def test_a_part_without_points_has_no_figure() -> None:
    empty = part(Route("absent", NO_BOUND, (), note="not installed"))
    assert cost_chart(empty) == ""
    shown = shown_measurement(replace(recorded(), parts=(empty,)))
    assert shown["parts"][0]["figure"] is None


def test_targets_are_drawn_in_their_panel() -> None:
    svg = cost_chart(replace(part(route("a", panel="x"), route("a", panel="y")), targets=(("y", 0.15),)))
    assert svg.count("y, dotted: the aim of 0.15 s for certified runs") == 1
    assert svg.count("stroke-dasharray:2 3") == 1


def test_names_do_not_overlap() -> None:
    found = spread([50, 51, 52, 99], 14, 0, 100)
    assert all(after - before >= 14 for before, after in pairwise(found))
    assert max(found) <= 100


def test_the_report_shows_a_file_that_is_given(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    source, folder = tmp_path / "report.json", tmp_path / "pages"
    source.write_text(json.dumps(report_data([], [], [])), encoding="utf-8")
    other: Measurement = replace(recorded(), date="2001-02-03", parts=recorded().parts[:1])
    save(other, tmp_path / "mine.json")
    assert main(["report", str(source), "--output", str(folder), "--cost", str(tmp_path / "mine.json")]) == 0
    assert "2001-02-03" in (folder / "cost.html").read_text(encoding="utf-8")
    assert [path.name for path in (folder / "figures").iterdir()] == ["cost-theta.svg"]
    # The file lies beside the pages, and the pages that are written again from there show it.
    (folder / "report.json").write_text(source.read_text(encoding="utf-8"), encoding="utf-8")
    assert main(["report", str(folder / "report.json"), "--output", str(folder)]) == 0
    assert "2001-02-03" in (folder / "cost.html").read_text(encoding="utf-8")
    capsys.readouterr()
    (tmp_path / "bad.json").write_text("{}", encoding="utf-8")
    assert main(["report", str(source), "--output", str(folder), "--cost", str(tmp_path / "bad.json")]) == 64
    assert "schema: expected" in capsys.readouterr().err
    assert main(["report", str(source), "--output", str(folder), "--cost", str(tmp_path / "none.json")]) == 64
    assert main(["report", "--check", str(folder), "--cost", str(tmp_path / "mine.json")]) == 64
