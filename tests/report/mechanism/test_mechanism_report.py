"""The report on a mechanism: what it states is what the commands that it names print, and never more."""

from __future__ import annotations

import hashlib
import json
import re
import shlex
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest
from flint import fmpq

from gspot_verified import MechanismReport, check, mechanism_report
from gspot_verified.cli import main
from gspot_verified.mechanisms.shipped import shipped_text
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.report.certificates import CheckedCertificate
from gspot_verified.report.mechanism.mechanism_report import mechanism_page, write_pages
from gspot_verified.report.mechanism.report import ReportedSpot
from gspot_verified.report.mechanism.subject import ReportPart, Subject
from gspot_verified.report.pictures.canvas import Picture

pytestmark = pytest.mark.slow
STATE = {"x": "0", "u": "1", "p": "1/4", "b": "-2/5"}


@pytest.fixture(scope="module")
def model() -> MechanismReport:
    """The model system, beta = 3/2: everything is exact."""
    return mechanism_report("model", states=[STATE])


@pytest.fixture(scope="module")
def written(model: MechanismReport, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("out") / "report"
    assert write_pages(model, folder) == folder / "mechanism.html"
    return folder


def outcomes(report: MechanismReport) -> dict[str, str | None]:
    return {part.title: part.outcome.value if part.outcome else None for part in report.parts}


def test_every_kind_of_part_is_there(model: MechanismReport) -> None:
    found = outcomes(model)
    assert {
        "All G-spots",
        "What it is",
        "The distinguished trajectory",
        "The contact force with C1 = 1, the side of the impact",
        "The contact force with C1 = -1, the side of the lift-off",
        "True solutions with C1 = 1, the side of the impact",
        "True solutions with C1 = -1, the side of the lift-off",
        "The zeros of dΘ/dτ, to which the deviation of the force is proportional at leading order",
        "The exact side rule of the compliant model with these α",
        "Slip from the given state 1",
    } <= set(found)
    assert found["All G-spots"] == "proved"
    assert found["Slip from the given state 1"] == "proved"
    assert sum(part.picture is not None for part in model.parts) == 3
    assert set(found.values()) == {"proved", None}
    assert model.exit_code == 0


def test_certificates_are_those_of_the_folder_and_the_checker_verifies_them(
    model: MechanismReport, written: Path
) -> None:
    names = ["g-spot-1-impact.cert", "g-spot-1-lift-off.cert", "g-spot-1-zeros.cert"]
    assert [file.name for file in model.certificates] == names
    page = (written / "mechanism.html").read_text(encoding="utf-8")
    for file in model.certificates:
        result = check(written / file.name)
        assert file.verified is result.verified is True
        assert file.said == result.text.splitlines()[-1]
        assert hashlib.sha256((written / file.name).read_bytes()).hexdigest() == file.sha256
        assert page.count(file.sha256) == 2
    assert "independent checker" in page


def test_the_mechanism_s_file_is_beside_the_page_with_its_hash(model: MechanismReport, written: Path) -> None:
    content = (written / "mechanism.toml").read_bytes()
    assert content == shipped_text("model").encode()
    digest = hashlib.sha256(content).hexdigest()
    assert model.hashes["mechanism.toml"] == digest
    assert (written / "mechanism.html").read_text(encoding="utf-8").count(digest) == 2
    data = json.loads((written / "mechanism.json").read_text(encoding="utf-8"))
    assert data["sha256"] == model.hashes
    assert data["exit_code"] == model.exit_code
    assert set(data["sha256"]) | {"mechanism.html", "mechanism.json"} == {file.name for file in written.iterdir()}


def test_the_page_loads_nothing_and_names_no_file_that_is_not_there(written: Path) -> None:
    page = (written / "mechanism.html").read_text(encoding="utf-8")
    sources = re.findall(r'\ssrc="([^"]*)"', page)
    assert len(sources) == 3
    assert all(source.startswith("data:image/svg+xml;base64,") for source in sources)
    assert "<script" not in page
    assert "<link" not in page
    for target in re.findall(r'href="([^"]*)"', page):
        there = f'id="{target[1:]}"' in page if target.startswith("#") else (written / target).is_file()
        assert there, target


def test_two_runs_give_the_same_bytes(written: Path, tmp_path: Path) -> None:
    again = tmp_path / "again"
    mechanism_report("model", again, states=[STATE])
    assert {file.name for file in again.iterdir()} == {file.name for file in written.iterdir()}
    for file in written.iterdir():
        assert (again / file.name).read_bytes() == file.read_bytes(), file.name


def test_every_command_of_the_page_works(
    model: MechanismReport, written: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(written)
    before = {file.name: file.read_bytes() for file in written.iterdir()}
    for part in model.parts:
        for command in part.commands:
            words = shlex.split(command)
            if words[0] == "python":
                assert subprocess.run([sys.executable, *words[1:]], check=False).returncode == 0, command
            else:
                assert main(words[1:]) == 0, command
    assert capsys.readouterr().out
    after = {file.name: file.read_bytes() for file in written.iterdir()}
    assert {name: after[name] for name in before} == before
    assert set(after) - set(before) == {"expansion.svg", "phase-plane.svg", "force.svg"}


@pytest.mark.parametrize("name", ["genot_brogliato_rod", "falling_rod_lower_friction"])
def test_a_rod(name: str, tmp_path: Path) -> None:
    """In balls and in Case II; in no Case."""
    report = mechanism_report(name, tmp_path / "out")
    assert report.exit_code == 0
    case = report.spots[0].classification.case
    assert case == {"genot_brogliato_rod": "II", "falling_rod_lower_friction": "none"}[name]
    assert len(report.certificates) == (case == "II")
    page = (tmp_path / "out" / "mechanism.html").read_text(encoding="utf-8")
    assert ("True solutions" in page) is False


def test_a_folder_that_is_missing_is_refused_before_the_work(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(FileNotFoundError, match="there is no folder"):
        mechanism_report("model", tmp_path / "missing" / "out")
    with pytest.raises(NotADirectoryError, match="is a file"):
        mechanism_report("model", tmp_path / "file")


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
    assert data["schema"] == "gspot-verified/mechanism-report/2"
    assert data["sha256"].keys() == {"mechanism.toml", "good.cert"}
    assert data["spots"][0]["parts"][0]["outcome"] == "proved"
    first = {file.name: file.read_bytes() for file in place.parent.iterdir()}
    write_pages(made, tmp_path / "out")
    assert {file.name: file.read_bytes() for file in place.parent.iterdir()} == first
