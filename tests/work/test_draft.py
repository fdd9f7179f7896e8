"""A draft takes its place whole, or not at all, and under no name that another run or the user has."""

from __future__ import annotations

from pathlib import Path

import pytest

from gspot_verified.work.draft import draft


def test_two_at_once_do_not_share_a_file(tmp_path: Path) -> None:
    place, other = tmp_path / "a.csv", tmp_path / "a.csv.part"
    other.write_text("the user's")
    with draft(place) as first, draft(place) as second:
        first.write_text("first")
        second.write_text("second")
    assert place.read_text() == "first"  # the outer one comes last
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.csv", "a.csv.part"]
    assert other.read_text() == "the user's"


def test_what_was_there_stays_where_the_work_fails(tmp_path: Path) -> None:
    place = tmp_path / "a.csv"
    place.write_text("before")

    def broken() -> None:
        with draft(place) as unfinished:
            unfinished.write_text("half")
            raise ValueError("broken")

    with pytest.raises(ValueError, match="broken"):
        broken()
    assert [path.read_text() for path in tmp_path.iterdir()] == ["before"]
