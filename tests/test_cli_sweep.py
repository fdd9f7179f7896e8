"""The command ``sweep``: output, files, exit codes, and what a kill leaves behind."""

from __future__ import annotations

import csv
import io
import json
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

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


def test_a_map_with_settings_and_start(capsys: pytest.CaptureFixture[str]) -> None:
    arguments = ["sweep", "oscillator", "--over", "beta=9/4..11/4:2", "--over", "mu=2..25/12:2", "--set", "kappa=1/10"]
    assert main([*arguments, "--start", "mu=25/12", "--json"]) in (0, 2)
    data = json.loads(capsys.readouterr().out)
    assert data["start"] == {"beta": "7/3", "mu": "25/12"}
    assert [parameter["cells"] for parameter in data["parameters"]] == [2, 2]


def test_undecided_is_exit_code_2(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["sweep", "oscillator", "--over", "beta=2..5/2:2"]) == 2
    assert "at most once" in capsys.readouterr().out


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
        ([], "--over"),
    ],
)
def test_wrong_usage(capsys: pytest.CaptureFixture[str], arguments: list[str], message: str) -> None:
    assert main(["sweep", "genot_brogliato_rod", *arguments]) == 64
    assert message in capsys.readouterr().err


def test_a_killed_run_goes_on(tmp_path: Path) -> None:
    """SIGKILL in the middle; the second run gives what an undisturbed one gives, and does not start anew."""
    journal = tmp_path / "journal"
    command = [sys.executable, "-m", "gspot_verified", "sweep", "oscillator", "--over", "beta=1/2..4:600", "--json"]
    with subprocess.Popen([*command, "--journal", str(journal)], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as run:
        while run.poll() is None and (not journal.exists() or journal.read_bytes().count(b"\n") < 3):
            time.sleep(0.01)
        assert run.poll() is None, "it was done before it could be killed"
        run.send_signal(signal.SIGKILL)
    kept = journal.read_bytes()
    whole = kept[: kept.rfind(b"\n") + 1]
    again = subprocess.run([*command, "--journal", str(journal)], capture_output=True, text=True, check=True)
    assert journal.read_bytes().startswith(whole)
    assert again.stdout == subprocess.run(command, capture_output=True, text=True, check=True).stdout
