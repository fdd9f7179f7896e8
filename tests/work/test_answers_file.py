"""A table of answers as a file: whole or not at all, the same numbers in both forms."""

from __future__ import annotations

import importlib.util
from collections.abc import Iterator
from pathlib import Path

import pytest
from pyarrow import parquet

from gspot_verified.work.answers_file import require_writer, write_answers

HEAD = "x_lower,case,beta_lower,beta_upper\n"


@pytest.mark.parametrize("name", ["answers.csv", "answers.parquet"])
def test_whole_or_not_at_all(tmp_path: Path, name: str) -> None:
    place = tmp_path / name
    place.write_text("what was there before", encoding="utf-8")

    def broken() -> Iterator[str]:
        yield HEAD
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write_answers(place, broken())
    assert place.read_text(encoding="utf-8") == "what was there before"
    assert [each.name for each in tmp_path.iterdir()] == [name]


def test_bounds_are_doubles_bit_for_bit(tmp_path: Path) -> None:
    """What stands in ``texts`` is text though its name ends like a bound; a bound that is missing is null."""
    bounds = [(0.1, 0.1 + 2.0**-55), (-5e-324, 1.7976931348623157e308), (2.2250738585072011e-308, 1 / 3)]
    lines = [f"1/3,III,{low!r},{high!r}\n" for low, high in bounds]
    write_answers(tmp_path / "a.parquet", [HEAD, *lines, '"1,\n2",,,\n', "3,none,-inf,inf\n"], ["x_lower"])
    found = parquet.read_table(tmp_path / "a.parquet").to_pydict()
    lower, upper = ([pair[i] for pair in bounds] for i in (0, 1))
    assert found == {
        "x_lower": ["1/3", "1/3", "1/3", "1,\n2", "3"],
        "case": ["III", "III", "III", "", "none"],
        "beta_lower": [*lower, None, -float("inf")],
        "beta_upper": [*upper, None, float("inf")],
    }


def test_many_lines_and_none(tmp_path: Path) -> None:
    """More than a block that the reader looks through; and a table without a row."""
    count = 60_000
    lines = (f"{k},III,{k / 7!r},{k / 3!r}\n" for k in range(count))
    write_answers(tmp_path / "a.parquet", (line for part in ([HEAD], lines) for line in part), ["x_lower"])
    found = parquet.read_table(tmp_path / "a.parquet")
    assert parquet.ParquetFile(tmp_path / "a.parquet").num_row_groups > 1
    assert found["beta_lower"].to_pylist() == [k / 7 for k in range(count)]
    write_answers(tmp_path / "b.parquet", [HEAD])
    assert parquet.read_table(tmp_path / "b.parquet").num_rows == 0


def test_what_is_missing_is_said_before_the_work(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(importlib.util, "find_spec", lambda _: None)
    with pytest.raises(ValueError, match=r"--output: a\.parquet needs pyarrow"):
        require_writer("--output", Path("a.parquet"))
    require_writer("--output", Path("a.csv"))
    require_writer("--output", None)
