"""The rows on states: every one is there with a figure; nothing is asserted about times."""

from __future__ import annotations

from math import prod

import pytest

from gspot_verified.cost.benchmarks import mechanism_states


def test_every_row_has_a_figure(monkeypatch: pytest.MonkeyPatch) -> None:
    cases = (("model", {"x": "0", "u": "3", "p": "1/2", "b": "-2"}),)
    assert {name for name, _ in mechanism_states.CASES} == {"oscillator", "extended", "rod"}
    monkeypatch.setattr(mechanism_states, "CASES", cases)
    fixed = {"x": "0", "u": "3", "p": "1/2"}
    monkeypatch.setattr(mechanism_states, "FATES", (("model", fixed, {"b": "-5/2..-3/2:2"}, 2),))
    monkeypatch.setattr(mechanism_states, "LONG_FATES", (("model", fixed, {"b": "-5/2..-2:1"}, 1),))
    steps: list[str] = []
    rows = mechanism_states.state_rows(progress=steps.append)
    assert all(row.figure is not None and row.figure > 0 for row in rows)
    assert [(row.case, row.note) for row in rows] == [
        ("approach", "G-spot, lift-off, 160 bits"),
        ("verdict", "lift-off, proved"),
        ("fates", "1 pieces, proved"),
    ]
    assert [step.split(" from")[0] for step in steps] == ["approach of model", "verdict of model", "fates of model"]
    assert "approach of model from x = 0" in steps[0]
    assert len(mechanism_states.state_rows(full=True)) == 4


def test_the_cells_of_each_range_are_counted() -> None:
    for _, _, over, cells in (*mechanism_states.FATES, *mechanism_states.LONG_FATES):
        assert prod(int(ends.partition(":")[2]) for ends in over.values()) == cells
