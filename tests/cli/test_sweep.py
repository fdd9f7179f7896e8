"""The command ``sweep``: output, files, exit codes, what a kill leaves behind; maps over states (proofs/fates.md)."""

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
    assert lines[0] == "... 4 of 4 cells"
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


# The command ``sweep --from``: output, files, exit codes (proofs/fates.md).


WORDS = ["sweep", "model", "--from", "x=0,u=2,b=1"]  # b > 0: nothing slips, so that no orbit is needed


def test_a_line_with_table_picture_and_json(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    table, picture = tmp_path / "table.csv", tmp_path / "picture.svg"
    files = ["--csv", str(table), "--picture", str(picture), "--journal", str(tmp_path / "journal")]
    assert main([*WORDS, "--over", "p=1/4..1/2:4", *files]) == 0
    shown = capsys.readouterr()
    assert "opens at once" in shown.out
    assert "4 of 4 cells" in shown.err
    rows = list(csv.DictReader(io.StringIO(table.read_text(encoding="utf-8"))))
    assert {row["fate"] for row in rows} == {"opens at once"}
    assert picture.read_bytes().startswith(b"<?xml")
    assert main([*WORDS, "--over", "p=-2/5..2/5:3", "--json"]) == 2
    data = json.loads(capsys.readouterr().out)
    assert [piece["fate"] for piece in data["pieces"]] == ["p < 0", "undecided", "opens at once"]
    assert data["verdict"]["outcome"] == "undecided"


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["--over", "q=1..2"], "is no component"),
        (["--over", "p=1/4..1/2", "--start", "p=1/3"], "says nothing with --from"),
        (["--over", "p=1/4..1/2", "--digits", "3"], "says nothing with --from"),
        (["--over", "p=1/2..1/4"], "reversed"),
        (["--over", "p=1/4..1/2", "--surface-velocity", "fast"], "surface_velocity"),
    ],
)
def test_bad_input(words: list[str], text: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*WORDS, *words]) == 64
    assert text in capsys.readouterr().err


def test_a_surface_velocity_needs_a_state(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["sweep", "oscillator", "--over", "beta=9/4..11/4:1", "--surface-velocity", "1"]) == 64
    assert "--from" in capsys.readouterr().err
