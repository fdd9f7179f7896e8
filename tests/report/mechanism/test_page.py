"""The page shows each part with its outcome, escapes every text, and loads nothing."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from pathlib import Path

import pytest
from flint import fmpq

from gspot_verified import MechanismReport
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.report.certificates import CheckedCertificate
from gspot_verified.report.mechanism.page import mechanism_page, write_pages
from gspot_verified.report.mechanism.part import ReportPart
from gspot_verified.report.mechanism.report import ReportedSpot
from gspot_verified.report.mechanism.subject import Subject
from gspot_verified.report.pictures.canvas import Picture

GOOD = CheckedCertificate("good.cert", 64 * "a", True, "VERIFIED the statement", b"one")
BAD = CheckedCertificate("bad.cert", 64 * "b", False, "REJECTED <b>cover</b>", b"two")
PICTURE = Picture("plane", "The plane", "A caption with <i>", 'curves & "lines"', "<svg></svg>", b"")


def report(subject: Subject, *parts: ReportPart) -> MechanismReport:
    spot = ReportedSpot(1, "mechanism.toml", subject.classified, parts)
    search = ReportPart("All G-spots", Outcome.PROVED, "proved: one", ("gspot-verified classify mechanism.toml",))
    return MechanismReport(
        name="a <b>rod</b>",
        settings=(("mu", "2"),),
        files=(("mechanism.toml", b"format = 1"),),
        search=search,
        spots=(spot,),
        runs=(),
        command="gspot-verified report",
    )


@pytest.mark.parametrize(
    ("outcome", "code"), [(None, 0), (Outcome.PROVED, 0), (Outcome.REFUTED, 1), (Outcome.UNDECIDED, 2)]
)
def test_each_outcome_is_shown_as_it_is(exact: Subject, outcome: Outcome | None, code: int) -> None:
    made = report(exact, ReportPart("A part", outcome, "what it says"))
    assert made.exit_code == code
    shown = mechanism_page(made).partition("A part")[2].partition("</article>")[0]
    badges = re.findall(r'class="badge (\w+)"', shown)
    assert badges == ([outcome.value] if outcome else [])
    assert "what it says" in shown


def test_refuted_and_undecided_together_are_refuted(exact: Subject) -> None:
    parts = [ReportPart("P", outcome, "") for outcome in (Outcome.UNDECIDED, Outcome.REFUTED)]
    assert report(exact, *parts).exit_code == 1


def test_a_rejected_certificate_is_shown_and_is_exit_code_1(exact: Subject) -> None:
    made = report(exact, ReportPart("A part", Outcome.PROVED, "text", certificates=(GOOD, BAD)))
    assert made.exit_code == 1
    page = mechanism_page(made)
    assert page.count('<span class="badge refuted">rejected</span>') == 2
    assert "REJECTED &lt;b&gt;cover&lt;/b&gt;" in page
    assert replace(made, spots=()).exit_code == 0


@pytest.mark.parametrize(("velocity", "warned"), [(-1, "u &lt; 0"), (0, "u = 0"), (1, "")])
def test_the_summary_says_where_the_sides_do_not_apply(exact: Subject, velocity: int, warned: str) -> None:
    told = replace(exact.classified, slip_velocity=fmpq(velocity))
    summary = mechanism_page(report(replace(exact, classified=told))).partition("Summary")[2].partition("<article")[0]
    assert ("no positive slip on a surface at rest" in summary) is bool(warned)
    assert warned in summary


def test_texts_are_escaped_and_nothing_is_loaded(exact: Subject) -> None:
    part = ReportPart("<script>", None, PICTURE.caption, ("gspot-verified '<x>'",), PICTURE)
    page = mechanism_page(report(exact, part))
    assert "<script" not in page
    assert "<x>" not in page
    assert "a &lt;b&gt;rod&lt;/b&gt;" in page
    assert 'alt="curves &amp; &#34;lines&#34;"' in page
    assert re.findall(r'\ssrc="([^,"]*),', page) == ["data:image/svg+xml;base64"]
    assert "default-src 'none'" in page
    assert "@import" not in page
    assert "url(" not in page


def test_the_files_beside_the_page(exact: Subject, tmp_path: Path) -> None:
    made = report(exact, ReportPart("A part", Outcome.PROVED, "text", certificates=(GOOD,)))
    place = write_pages(made, tmp_path / "out")
    assert {file.name for file in place.parent.iterdir()} == {
        "mechanism.html", "mechanism.json", "mechanism.toml", "good.cert"
    }  # fmt: skip
    data = json.loads((place.parent / "mechanism.json").read_text(encoding="utf-8"))
    assert data["schema"] == "gspot-verified/mechanism-report/1"
    assert data["sha256"].keys() == {"mechanism.toml", "good.cert"}
    assert data["spots"][0]["parts"][0]["outcome"] == "proved"
    first = {file.name: file.read_bytes() for file in place.parent.iterdir()}
    write_pages(made, tmp_path / "out")
    assert {file.name: file.read_bytes() for file in place.parent.iterdir()} == first
