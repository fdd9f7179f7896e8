"""The command ``sweep --from``: output, files, exit codes (proofs/fates.md)."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import pytest

from gspot_verified.cli import main

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
    assert main([*WORDS, "--over", "p=-1/2..1/2:3", "--json"]) == 2
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
