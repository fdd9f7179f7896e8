"""The command ``sweep``: output, files, exit codes, and what a kill leaves behind."""

from __future__ import annotations

import csv
import io
import json
import re
from pathlib import Path

import pytest
from killed import killed_after

from gspot_verified import load, sweep
from gspot_verified.cli import main


def test_a_line(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    table, picture = tmp_path / "table.csv", tmp_path / "picture.svg"
    code = main(
        ["sweep", "genot_brogliato_rod", "--over", "mu=1.3..1.6:6", "--csv", str(table), "--picture", str(picture)]
    )
    shown = capsys.readouterr()
    assert code == 0
    assert "exactly once" in shown.out
    assert "fold at mu = [1.333333333333" in shown.out
    assert "6 of 6 cells" in shown.err
    rows = list(csv.DictReader(io.StringIO(table.read_text(encoding="utf-8"))))
    assert (rows[0]["mu_lower_exact"], rows[-1]["mu_upper_exact"]) == ("13/10", "8/5")
    assert {row["kind"] for row in rows} == {"settled", "crossing", "fold", "beyond a fold"}
    assert picture.read_bytes().startswith(b"<?xml")


def test_the_summary_comes_before_the_pieces(capsys: pytest.CaptureFixture[str]) -> None:
    """What is printed piece by piece is the plain data of the result, and its list comes last."""
    assert main(["sweep", "oscillator", "--over", "beta=9/4..11/4:3", "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    result = sweep(load("oscillator"), {"beta": "9/4..11/4:3"})
    assert data == {**result.to_json(), "schema": data["schema"]}
    assert len(data["pieces"]) >= 3
    assert [*data][-1] == "pieces"
    assert "".join(result.csv_lines()) == result.to_csv()


def test_a_map_with_settings_and_start(capsys: pytest.CaptureFixture[str]) -> None:
    arguments = ["sweep", "oscillator", "--over", "beta=9/4..11/4:2", "--over", "mu=2..25/12:2", "--set", "kappa=1/10"]
    assert main([*arguments, "--start", "mu=25/12", "--budget", "0", "--json"]) in (0, 2)
    data = json.loads(capsys.readouterr().out)
    assert data["start"] == {"beta": "7/3", "mu": "25/12"}
    assert [parameter["cells"] for parameter in data["parameters"]] == [2, 2]


def test_undecided_is_exit_code_2(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["sweep", "oscillator", "--over", "beta=2..5/2:2"]) == 2
    assert "at most once" in capsys.readouterr().out


def test_a_coarse_map_refines_itself_and_a_budget_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    words = ["sweep", "genot_brogliato_rod", "--over", "mu=1.5..1.6:2", "--over", "g=1/2..1:2"]
    assert main(words) == 0
    lines = capsys.readouterr().err.splitlines()
    assert lines[0] == "... 4 of 4 cells, undecided pieces among them"
    assert len(lines) < 5
    done = re.fullmatch(r"\.\.\. ([0-9]+) of ([0-9]+) cells, undecided pieces among them", lines[-1])
    assert done is not None
    assert done[1] == done[2]
    assert main([*words, "--budget", "1"]) == 2
    assert "the budget of one divided piece ended" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--over", "mu"], "name=value"),
        (["--over", "mu=1.4..2", "--over", "mu=1.4..2"], "given twice"),
        (["--over", "nu=1..2"], "no parameter"),
        (["--over", "mu=1.4..2", "--csv", "/nowhere/table.csv"], "no folder"),
        (["--over", "mu=1.4..2", "--picture", "picture.gif"], "allowed"),
        (["--over", "mu=1.4..2", "--start", "mu=7"], "outside"),
        (["--over", "mu=1.4..2", "--workers", "0"], "workers"),
        (["--over", "mu=1.4..2", "--set", "mu=3/2"], "--set mu: it varies by --over; --start mu=... says where"),
        (["--over", "mu=1.4..2", "--budget=-1"], "budget must be an int >= 0"),
        ([], "--over"),
    ],
)
def test_wrong_usage(capsys: pytest.CaptureFixture[str], arguments: list[str], message: str) -> None:
    assert main(["sweep", "genot_brogliato_rod", *arguments]) == 64
    assert message in capsys.readouterr().err


def test_a_killed_run_goes_on(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """SIGKILL in the middle; the second run gives what an undisturbed one gives, and does not start anew."""
    journal = tmp_path / "journal"
    words = ["sweep", "oscillator", "--over", "beta=1/2..4:100", "--json"]
    noted = [*words, "--journal", str(journal)]
    kept = killed_after(2, f"from gspot_verified.cli import main; main({noted!r})", journal)
    code = main(noted)
    again = capsys.readouterr().out
    assert journal.read_bytes().startswith(kept)
    assert journal.read_bytes().count(b"\n") > kept.count(b"\n")
    assert main(words) == code == 0
    assert capsys.readouterr().out == again


def test_a_table_beside_a_journal_of_any_name(tmp_path: Path) -> None:
    table, journal = tmp_path / "table.csv", tmp_path / "table.csv.part"
    words = ["sweep", "genot_brogliato_rod", "--over", "mu=1.5..1.6:1", "--csv", str(table), "--journal", str(journal)]
    assert main(words) == 0
    assert journal.read_text(encoding="utf-8").startswith('{"journal"')
    assert table.read_text(encoding="utf-8").startswith("mu_lower,")


def test_no_two_columns_have_one_name(tmp_path: Path) -> None:
    """The oscillator has a parameter beta, and beta is a number of the G-spot, too."""
    table = tmp_path / "table.csv"
    assert main(["sweep", "oscillator", "--over", "beta=9/4..5/2:1", "--csv", str(table)]) == 0
    head = table.read_text(encoding="utf-8").splitlines()[0].split(",")
    assert len(set(head)) == len(head)
    assert {"beta_lower", "spot_beta_lower"} <= set(head)
