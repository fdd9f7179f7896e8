"""The rows on sweeps: every one is there with a figure; nothing is asserted about times."""

from __future__ import annotations

import pytest

from gspot_verified.cost.benchmarks import mechanism


def test_every_row_has_a_figure(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(mechanism, "CASES", (("genot_brogliato_rod", {"mu": "1.3..1.6:3"}, 3),))
    monkeypatch.setattr(mechanism, "LONG_CASES", (("oscillator", {"beta": "9/4..5/2:2"}, 2),))
    monkeypatch.setattr(mechanism, "TABLE_ROWS", 3)
    monkeypatch.setattr(mechanism, "APPROACH_ROWS", 1)
    steps: list[str] = []
    short, both = mechanism.sweep_rows(progress=steps.append), mechanism.sweep_rows(full=True)
    assert (len(short), len(both)) == (4, 5)
    assert all(row.figure is not None and row.figure > 0 for row in (*short, *both))
    assert "genot_brogliato_rod over mu = 1.3..1.6:3" in steps[0]
    assert "pieces, proved" in both[1].note
    assert (both[2].note, "a table of 3 rods" in steps[-2]) == ("3 settled", True)
    assert ([row.note for row in both[3:]], "tables of one row" in steps[-1]) == (["1 settled", "1 settled"], True)


def test_the_cells_of_each_case_are_counted() -> None:
    for _, over, cells in (*mechanism.CASES, *mechanism.LONG_CASES):
        product = 1
        for ends in over.values():
            product *= int(ends.partition(":")[2])
        assert product == cells
