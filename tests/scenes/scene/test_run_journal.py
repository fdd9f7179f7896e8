"""A journal of pieces: kept in order, refused where a line is none, and of one question."""

from __future__ import annotations

from pathlib import Path

import pytest
from flint import fmpq

from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.run_journal import RunJournal, question

SCENE = load_scene("fig-varsim1", epsilon="1/50")


def test_pieces_are_kept_in_order(tmp_path: Path) -> None:
    kept = tmp_path / "journal"
    first = RunJournal(kept, {"question": 1})
    assert first.pieces == []
    for number in range(3):
        first.add({"piece": number})
    del first  # its lock
    assert RunJournal(kept, {"question": 1}).pieces == [{"piece": number} for number in range(3)]
    whole = kept.read_text()
    for line in ("{]", "[" * 100_000):
        kept.write_text(f"{whole}{line}\n")
        with pytest.raises(ValueError, match=f"^{kept}: a line of the journal cannot be read: "):
            RunJournal(kept, {"question": 1})
    with pytest.raises(ValueError, match="is not a journal of this question"):
        RunJournal(kept, {"question": 2})


def test_every_part_of_a_run_tells_it_from_another() -> None:
    """The equations, the start, the end, the force at which it stops, and what else is asked."""
    from dataclasses import replace

    asked = {"method": "Radau"}
    found = question(SCENE, asked)
    assert question(load_scene("fig-varsim1", epsilon="1/50"), asked) == found
    assert found["method"] == "Radau"
    others = (
        SCENE.with_settings(epsilon="1/51"),
        SCENE.with_settings(nu=3),
        SCENE.with_settings(until="1/3"),
        SCENE.with_settings(beta="5/2"),
        SCENE.with_settings(k_2=2),
        replace(SCENE, stop_at_force=fmpq(7)),
        replace(SCENE, name="another"),
    )
    questions = [question(other, asked) for other in others] + [question(SCENE, {"method": "BDF"}), found]
    assert all(one != other for i, one in enumerate(questions) for other in questions[:i])
