"""``classify --table``: a CSV file of answers, whole or not at all."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest
from killed import killed_after

from gspot_verified import approach_table, classify_table, load
from gspot_verified.cli import main
from gspot_verified.mechanisms.shipped import shipped_text

WORDS = ["classify", "genot_brogliato_rod", "--table"]


def table(tmp_path: Path, text: str = "mu,L\n3/2,1\n2,1/3\n-1,1\n") -> Path:
    path = tmp_path / "table.csv"
    path.write_text(text, encoding="utf-8")
    return path


def test_a_line_for_each_row(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    given, output = table(tmp_path), tmp_path / "answers.csv"
    assert main([*WORDS, str(given), "--output", str(output)]) == 2
    assert capsys.readouterr().out.splitlines() == [
        "falling rod of Génot and Brogliato: 3 rows",
        "  one row: refused",
        "  one row: settled, Case II",
        "  one row: settled, no Case",
    ]
    rows = list(classify_table(load("genot_brogliato_rod"), given))
    assert output.read_text(encoding="utf-8") == rows[0].csv_head() + "".join(row.to_csv() for row in rows)
    read = csv.DictReader(output.read_text(encoding="utf-8").splitlines())
    assert [row["outcome"] for row in read] == ["settled", "settled", "refused"]
    assert not [*tmp_path.glob("*.part")]


def test_parquet_holds_what_csv_holds(tmp_path: Path) -> None:
    """A parameter named like a bound is text, as it was given; numbers are those of the file, bit for bit."""
    from pyarrow import parquet

    given = table(tmp_path)
    for suffix in ("csv", "parquet"):
        assert main([*WORDS, str(given), "--output", str(tmp_path / f"answers.{suffix}")]) == 2
    rows = list(csv.DictReader((tmp_path / "answers.csv").read_text(encoding="utf-8").splitlines()))
    columns = parquet.read_table(tmp_path / "answers.parquet").to_pydict()
    assert [row["L"] for row in rows] == columns["L"] == ["1", "1/3", "1"]
    for name, values in columns.items():
        assert [("" if value is None else value) for value in values] == [
            float(row[name]) if name.endswith(("_lower", "_upper")) and row[name] else row[name] for row in rows
        ]


def test_a_component_named_like_a_bound_is_text_in_parquet(tmp_path: Path) -> None:
    """As doubles a fraction could not be read, after all rows were done, and a long decimal would be rounded."""
    from pyarrow import parquet

    text = (
        shipped_text("model_system").replace('"x", "u", "y"', '"x", "u_lower", "y"').replace('["u", 0', '["u_lower", 0')
    )
    text = text.replace('fixed = ["x", "u"]', 'fixed = ["x", "u_lower"]').replace("\nu = 1", "\nu_lower = 1")
    (tmp_path / "own.toml").write_text(text, encoding="utf-8")
    values = ["30/10", "3.00000000000000000001"]
    given = table(tmp_path, "u_lower,p,b\n" + "".join(f"{value},1/2,-2\n" for value in values))
    words = ["approach", str(tmp_path / "own.toml"), "--table", str(given), "--from", "x=0", "--output"]
    assert main([*words, str(tmp_path / "answers.parquet")]) == 0
    assert parquet.read_table(tmp_path / "answers.parquet").to_pydict()["u_lower"] == values


def test_all_settled_with_settings(tmp_path: Path) -> None:
    given, output = table(tmp_path, "L\n1\n2\n"), tmp_path / "answers.csv"
    assert main([*WORDS, str(given), "--output", str(output), "--set", "mu=8/5"]) == 0


def test_a_killed_run_goes_on(tmp_path: Path) -> None:
    given = table(tmp_path, "mu\n" + "".join(f"{k}/100\n" for k in range(140, 240)))
    output, journal = tmp_path / "answers.csv", tmp_path / "journal"
    words = [*WORDS, str(given), "--output", str(output), "--journal", str(journal)]
    output.write_text("what was there before", encoding="utf-8")
    killed_after(1, f"from gspot_verified.cli import main; main({words!r})", journal)
    assert output.read_text(encoding="utf-8") == "what was there before"
    assert main(words) == 0
    assert len(output.read_text(encoding="utf-8").splitlines()) == 101


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ([], "--table needs --output"),
        (["--output", "missing/answers.csv"], "--output: there is no folder missing"),
        (["--output", "table.csv"], "--output and --table name the same file"),
        (["--output", "answers.csv", "--all"], "--all: not with --table"),
        (["--output", "answers.csv", "--set", "mu=3"], "--set mu: the table has a column mu"),
        (["--output", "answers.csv", "--json"], "--json: not with --table"),
        (["--output", "answers.csv", "--workers", "0"], "workers must be an int"),
    ],
)
def test_bad_input(
    words: list[str], message: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    before = table(tmp_path).read_bytes()
    assert main([*WORDS, "table.csv", *words]) == 64
    assert message in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["table.csv"]
    assert (tmp_path / "table.csv").read_bytes() == before


@pytest.mark.parametrize("words", [["--output", "x.csv"], ["--workers", "2"], ["--journal", "x"]])
def test_what_belongs_to_a_table_is_not_left_aside(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*WORDS[:2], *words]) == 64
    assert f"{words[0]}: only with --table" in capsys.readouterr().err


def test_a_wrong_table(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    given, output = table(tmp_path, "nu\n1\n"), tmp_path / "answers.csv"
    assert main([*WORDS, str(given), "--output", str(output)]) == 64
    assert "column 1: falling rod of Génot and Brogliato has no parameter 'nu'" in capsys.readouterr().err
    assert not output.exists()
    assert main([*WORDS, str(tmp_path / "missing.csv"), "--output", str(output)]) == 64


def test_what_is_read_is_not_replaced(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Neither the mechanism's file, nor a table that has the name a draft of the answers once had."""
    own, given = tmp_path / "own.toml", tmp_path / "answers.csv.part"
    own.write_text(shipped_text("genot_brogliato_rod"), encoding="utf-8")
    given.write_text("mu\n2\n", encoding="utf-8")
    words = ["classify", str(own), "--table", str(given), "--output"]
    assert main([*words, str(own)]) == 64
    assert "is what the command reads" in capsys.readouterr().err
    assert main([*words, str(tmp_path / "answers.csv")]) == 0
    assert given.read_text(encoding="utf-8") == "mu\n2\n"
    assert own.read_text(encoding="utf-8") == shipped_text("genot_brogliato_rod")


def test_slip_from_each_row(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    """``approach --table``: what all rows share stands in --from; the same lines as in Python."""
    given, output = table(tmp_path, "b,p\n-2,1/2\n2,1/2\n"), tmp_path / "answers.csv"
    words = ["approach", "model", "--table", str(given), "--output", str(output)]
    assert main([*words, "--from", "x=0,u=3"]) == 2
    assert capsys.readouterr().out.splitlines() == [
        "model system: 2 rows",
        "  one row: refused",
        "  one row: settled, G-spot, lift-off",
    ]
    rows = list(approach_table(load("model system"), given, {"x": 0, "u": 3}))
    assert output.read_text(encoding="utf-8") == rows[0].csv_head() + "".join(row.to_csv() for row in rows)
    whole = table(tmp_path, "x,u,b,p\n0,3,-2,1/2\n")
    assert main([*words[:3], str(whole), *words[4:]]) == 0
    for more, message in (
        (["--spot", "1"], "--spot: not with --table"),
        (["--json"], "--json: not with --table"),
        (["--from", "x=1"], "x: the table has a column x"),
        (["--set", "alpha_3=2", "--set", "nu=1"], "nu"),
    ):
        assert main([*words, *more]) == 64
        assert message in capsys.readouterr().err
    three = table(tmp_path, "b,p\n-2,1/2\n-3,1/2\n-4,1/2\n")
    assert main([*words[:3], str(three), *words[4:], "--from", "x=0,u=9", "--rows", "2:", "--digits", "3"]) == 0
    read = list(csv.DictReader(output.read_text(encoding="utf-8").splitlines()))
    assert [row["b"] for row in read] == ["-3", "-4"]
    assert all(int(row["C1_digits"]) >= 3 for row in read)
    for part in ("2", "a:b", "-1:2", ":", "3:2", "0:1", "7:"):
        assert main([*words, "--from", "x=0,u=3", "--rows", part]) == 64
        assert "rows: " in capsys.readouterr().err
    for more in (["--rows", "1:2"], ["--digits", "3"]):
        assert main(["approach", "model", "--from", "x=0", *more]) == 64
        assert f"{more[0]}: only with --table" in capsys.readouterr().err
    assert main(["approach", "model"]) == 64
    assert "give the state with --from, or states with --table" in capsys.readouterr().err
    assert main(["approach", "model", "--from", "x=0", "--workers", "2"]) == 64
    assert "--workers: only with --table" in capsys.readouterr().err
