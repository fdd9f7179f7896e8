"""Which G-spots the page describes: the file's own, and all others that are in a Case."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from gspot_verified import MechanismReport
from gspot_verified.mechanisms.shipped import shipped_text
from gspot_verified.mechanisms.spots.classify import classify_g_spot
from gspot_verified.mechanisms.spots.classify_all import classify_all
from gspot_verified.mechanisms.spots.g_spot import GSpot, find_g_spot
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.report.mechanism import report as module
from gspot_verified.report.mechanism.report import report_on
from gspot_verified.report.mechanism.subject import ReportPart, Source, Subject


@pytest.fixture
def described(monkeypatch: pytest.MonkeyPatch) -> Callable[[str], MechanismReport]:
    """The report without its long parts."""

    def only_the_class(subject: Subject, choose: bool, _: object) -> tuple[ReportPart, ...]:
        return (ReportPart("What it is", None, f"{subject.classified} {choose}"),)

    monkeypatch.setattr(module, "_parts", only_the_class)
    return lambda text: report_on(Source("mechanism.toml", text, {}), [], None, None, lambda _: None)


def test_the_own_g_spot_comes_first_and_the_others_have_files(described: Callable[[str], MechanismReport]) -> None:
    report = described(shipped_text("oscillator"))
    assert [spot.file for spot in report.spots] == ["mechanism.toml", "g-spot-2.toml"]
    assert [spot.classification.case for spot in report.spots] == ["III", "III"]
    assert [name for name, _ in report.files] == ["mechanism.toml", "g-spot-2.toml"]
    assert report.hashes.keys() == {"mechanism.toml", "g-spot-2.toml"}
    second = Source("g-spot-2.toml", dict(report.files)["g-spot-2.toml"].decode(), {})
    assert classify_g_spot(find_g_spot(second.mechanism)).to_json() == report.spots[1].classification.to_json()
    assert "exactly 6 G-spots" in report.search.text
    assert len(classify_all(second.mechanism).spots) == 6


@pytest.mark.parametrize(("name", "own"), [("rod", True), ("falling_rod_lower_friction", True), ("model", True)])
def test_a_g_spot_is_not_described_twice(described: Callable[[str], MechanismReport], name: str, own: bool) -> None:
    assert [spot.file == "mechanism.toml" for spot in described(shipped_text(name)).spots] == [own]


def test_without_a_place_in_the_file(described: Callable[[str], MechanismReport]) -> None:
    report = described(shipped_text("rod").partition("[g_spot]")[0])
    assert [spot.file for spot in report.spots] == ["g-spot-1.toml"]
    assert report.spots[0].classification.case == "II"


def test_a_place_in_the_file_that_is_no_g_spot_is_named(described: Callable[[str], MechanismReport]) -> None:
    report = described(shipped_text("model").replace("\np = 0", '\np = "1/10"'))
    assert [spot.file for spot in report.spots] == ["g-spot-1.toml"]
    assert "the file's own place is not described: model system: not a G-spot: p = 1/10 must be 0" in report.search.text
    assert "own place" not in described(shipped_text("model")).search.text


def test_where_no_file_can_be_made_the_page_says_so(
    described: Callable[[str], MechanismReport], monkeypatch: pytest.MonkeyPatch
) -> None:
    def refused(*_: object) -> tuple[Source, GSpot]:
        raise ValueError("the reason")

    monkeypatch.setattr(module, "_in_a_file", refused)
    report = described(shipped_text("rod").partition("[g_spot]")[0])
    what, further = report.spots[0].parts
    assert what.outcome is not None
    assert (further.outcome, further.text) == (None, "left out: the reason")
    assert report.exit_code == 0


def test_an_open_case_is_undecided(exact: Subject) -> None:
    part = module._classification(replace(exact.classified, case=None, reason="balls"), "a command")
    assert part.outcome is Outcome.UNDECIDED
    assert module._classification(exact.classified, "a command").outcome is Outcome.PROVED
