"""Samples, and the table of what was judged."""

from __future__ import annotations

from pathlib import Path

import pytest
from mutants.__main__ import ROOT, _sample
from mutants.judged import Judged, outdated, read_judged, write_judged
from mutants.operators import mutants_of
from mutants.test_mutants import STRONG, WEAK, run


def test_a_larger_sample_holds_a_smaller_one_and_other_lines_may_change(tmp_path: Path) -> None:
    def sample(source: str, size: int | None, seed: int) -> list[str]:
        (tmp_path / "x.py").write_text(source)
        return [mutant.after for mutant in _sample(mutants_of(tmp_path, "x.py"), size, seed)]

    lines = [f"a = {k}" for k in range(20)]
    whole, large, small = (sample("\n".join(lines), size, 3) for size in (None, 9, 4))
    assert (len(whole), len(large), len(small)) == (20, 9, 4)
    assert whole == sample("\n".join(lines), 50, 3)
    assert set(small) < set(large)
    assert large != sample("\n".join(lines), 9, 4)
    other = [line for line in lines if line.replace(line[4:], str(int(line[4:]) + 1)) not in small]
    assert set(sample("\n".join([*lines[:3], "b()", *lines[3:]]), 5, 3)) >= set(small) - {"pass"}
    assert set(sample("\n".join(other), 30, 3)).isdisjoint(small)


ROW = Judged(None, 0, 9, 6, 2, 1)


def test_the_table_of_what_was_judged_reads_back(tmp_path: Path) -> None:
    path, rows = tmp_path / "judged.toml", {"b.py": Judged(3, 7, 9, 1, 2, 4), "a.py": ROW}
    assert read_judged(path) == {}
    write_judged(path, rows)
    assert read_judged(path) == rows
    assert path.read_text().index('"a.py"') < path.read_text().index('"b.py"')
    path.write_text(path.read_text().replace("killed = 6", "killed = 5"))
    with pytest.raises(ValueError, match="not all"):
        read_judged(path)


def test_a_row_is_held_against_its_file() -> None:
    assert outdated("a.py", ROW, ROW.mutants) == []
    for found in (ROW.mutants - 1, ROW.mutants + 1, 0):
        (text,) = outdated("a.py", ROW, found)
        assert text == f"judged.toml states 9 mutants, the file has {found}; judge it again with --record: a.py"


def test_a_smaller_sample_replaces_no_larger_one() -> None:
    three, four = Judged(3, 0, 9, 1, 2, 4), Judged(4, 1, 9, 1, 3, 4)
    assert ROW.holds(four)
    assert four.holds(three)
    assert not three.holds(three)
    assert not three.holds(four)
    assert not four.holds(ROW)
    assert not ROW.holds(ROW)


def test_the_committed_table_reads() -> None:
    """Each row is of a file that stands: whole, or a sample of at least 15, of 10 outside of the ledger."""
    for file, row in read_judged(ROOT / "tests" / "mutants" / "judged.toml").items():
        assert (ROOT / file).is_file()
        assert row.sample is None or row.sample >= (15 if file.startswith("gspot_verified/paper/section_") else 10)


@pytest.mark.slow
def test_what_was_judged_is_recorded_and_run_again(tmp_path: Path) -> None:
    table = tmp_path / "tests" / "mutants" / "judged.toml"
    code, text = run(tmp_path, STRONG, options="--stated")
    assert code == 1
    assert "is not in judged.toml: package/source.py" in text
    assert run(tmp_path, WEAK, options="--record")[0] == 1  # a survivor that is not argued
    assert not table.exists()
    assert run(tmp_path, STRONG, options="--record --sample 5 --seed 2")[0] == 0
    assert read_judged(table) == {"package/source.py": Judged(5, 2, 7, 5, 0, 0)}
    code, text = run(tmp_path, STRONG, options="--stated")
    assert code == 0
    assert "7 mutants, 5 killed" in text
    assert run(tmp_path, STRONG, options="--record --sample 7 --seed 2")[0] == 0
    assert run(tmp_path, STRONG, options="--record --sample 3")[0] == 0
    assert read_judged(table) == {"package/source.py": Judged(None, 0, 7, 7, 0, 0)}


@pytest.mark.slow
def test_a_test_reaches_what_an_earlier_one_has_left_in_a_cache(tmp_path: Path) -> None:
    """The first test fills the cache and asks too little; the second one must be shown the mutant, too."""
    source = "from functools import cache\n\n@cache\ndef pair():\n    return [1, 2 + 3]\n"
    tests = (
        "from package.source import pair\n\ndef test_first():\n    assert pair()[0] == 1\n\n"
        "def test_second():\n    assert pair()[1] == 5\n"
    )
    code, text = run(tmp_path, tests, "", source)
    assert code == 0, text
