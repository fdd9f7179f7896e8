"""``verify`` with names: what is printed of some entries, what came from the cache, what is refused."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from gspot_verified.cli import main
from gspot_verified.cli.ledger_output import claims_data, paper_data, print_claims, print_paper, what_was_run
from gspot_verified.paper.checks.entry import Check, Entry, Rung, Section
from gspot_verified.paper.claims import WHY, Standing, paper_claims
from gspot_verified.paper.verify import verify_claims
from gspot_verified.report.data import report_data


@pytest.fixture(scope="module")
def named() -> list[Entry]:
    return verify_claims(["S-iwc", "S-gamma-intervals"], alone=True)[0]


def run(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    code = main(list(arguments))
    captured = capsys.readouterr()
    return code, captured.out, captured.err


def test_named_claims_are_printed_in_full_and_the_second_time_from_the_cache(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    code, first, _ = run(capsys, "verify", "S-iwc", "--cache", str(tmp_path))
    assert code == 0
    assert first.startswith("proved             S-iwc: ")
    assert "  agrees: proofs/signs.md" in first
    assert "    by a proof page in proofs/" in first
    assert "run now: all 1" in first
    assert f"of 1 named: 1 proved, 0 refuted, 0 undecided; the paper makes {len(paper_claims())} claims" in first
    assert "the paper's claim, lines " in first
    code, second, _ = run(capsys, "verify", "S-iwc", "--cache", str(tmp_path))
    assert code == 0
    assert second.startswith("proved     cached  S-iwc: ")
    assert "run now: 0 of 1; cached from earlier runs on the same sources and versions: 1 of 1" in second
    code, third, _ = run(capsys, "verify", "S-iwc", "--cache", str(tmp_path), "--full")
    assert third == first


def test_the_exit_code_is_that_of_the_named_claims(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    code, output, _ = run(capsys, "verify", "S-gamma-intervals", "--cache", str(tmp_path), "--alone")
    assert code == 1
    assert output.startswith("refuted")
    assert "  corrected: " in output


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("S-iwcc",), "no entry of the ledger is named 'S-iwcc'; nearest: S-iwc"),
        (("S-iwc", "--output", "x"), "--output: the report is of the whole paper; name no claims"),
        (("--alone",), "--alone: for named claims"),
    ],
)
def test_bad_usage(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path, arguments: tuple[str, ...],
    message: str,
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    code, output, errors = run(capsys, "verify", *arguments)
    assert code == 64
    assert output == ""
    assert message in errors
    assert not list(tmp_path.iterdir())


def test_a_claim_of_the_paper_is_not_decided_by_a_part_of_its_entries(named: list[Entry]) -> None:
    rows = claims_data(named, [])["claims"]
    known = {"S-iwc", "S-gamma-intervals"}
    assert rows
    assert all(known & set(row["entries"]) for row in rows)
    parts = [row for row in rows if not set(row["entries"]) <= known]
    assert parts
    for row in parts:
        assert row["standing"] == ("refuted" if "S-gamma-intervals" in row["entries"] else "not run")
    assert {row["standing"] for row in rows if row not in parts} <= {"proved", "refuted"}


def test_the_data_hold_every_claim_of_the_paper(named: list[Entry]) -> None:
    data = json.loads(json.dumps(paper_data(named)))
    assert len(data["claims"]) == sum(data["standings"].values()) == len(paper_claims())
    assert {"premise", "not checkable", "undecided"} <= {row["standing"] for row in data["claims"]}


def test_a_condition_stands_wherever_its_claim_stands(capsys: pytest.CaptureFixture[str], named: list[Entry]) -> None:
    limited = [claim for claim in paper_claims() if claim.proved_as is not Standing.PROVED]
    entries = [replace(named[0], identifier=name) for name in {name for claim in limited for name in claim.entries}]
    print_claims(entries, [])
    lines = capsys.readouterr().out.splitlines()
    for data in (claims_data(entries, []), paper_data(entries)):
        rows = {(*row["lines"], row["claim"]): row for row in data["claims"]}
        for claim in limited:
            row = rows[claim.first, claim.last, claim.words]
            assert (row["standing"], row["why"]) == (claim.proved_as.value, claim.why)
    for claim in limited:
        head = f"the paper's claim, lines {claim.first} to {claim.last}: {claim.proved_as.value}: {claim.words}"
        assert lines[lines.index(head) + 1] == f"  {WHY[claim.proved_as]}: {claim.why}"
    assert {WHY[claim.proved_as] for claim in limited} == {"condition", "known now"}


def test_every_count_has_its_denominator(capsys: pytest.CaptureFixture[str], named: list[Entry]) -> None:
    print_paper(named)
    lines = capsys.readouterr().out.splitlines()
    assert lines[-6].startswith("proved: 1 of 2: 1 on ")
    assert lines[-5].startswith("refuted: 1 of 2: 1 on ")
    assert " of 2 rest on a proof page alone" in lines[-4]
    assert lines[-3].startswith(f"of the paper's {len(paper_claims())} claims: ")
    assert lines[-2] == "of 2 entries: 1 proved, 1 refuted, 0 undecided"
    assert lines[-1] == what_was_run(named) == "run now: all 2"


def report_file(folder: Path) -> Path:
    """A report.json with one refuted entry."""
    checks = [Check(Rung.EXACT, what, False, "f") for what in ("one", "another")]
    entry = Section("Section 4").settled("4-order", "line 986", "x", "third order", *checks, corrected="fourth order")
    path = folder / "report.json"
    path.write_text(json.dumps(report_data([entry], [])), encoding="utf-8")
    return path


def test_the_supplement_is_written_from_a_report_and_a_missing_latex_is_said(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    path = report_file(tmp_path)
    monkeypatch.setattr("gspot_verified.report.write.shutil.which", lambda _: None)
    code, output, errors = run(capsys, "report", str(path), "--supplement", str(tmp_path / "out"))
    assert code == 0
    assert output.splitlines() == [str(tmp_path / "out" / name) for name in ("errata.tex", "theorems.tex")]
    assert errors.count("there is no pdflatex on this machine") == 2
    assert not (tmp_path / "out" / "index.html").exists()
    code, output, _ = run(capsys, "report", str(path), "--supplement", str(tmp_path / "out"), "--json")
    found = json.loads(output)
    assert (code, len(found["files"]), len(found["warnings"])) == (0, 2, 2)


def test_a_supplement_needs_a_report_and_a_folder(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    code, _, errors = run(capsys, "report", str(tmp_path / "none.json"), "--supplement", str(tmp_path / "out"))
    assert (code, "there is no file" in errors) == (64, True)
    code, _, errors = run(capsys, "report", str(report_file(tmp_path)), "--supplement", str(tmp_path / "a" / "b"))
    assert (code, "there is no folder" in errors) == (64, True)
    code, _, errors = run(capsys, "report", "--check", str(tmp_path), "--supplement", str(tmp_path))
    assert (code, "--output and --supplement have no use with it" in errors) == (64, True)
