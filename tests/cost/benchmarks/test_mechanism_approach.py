"""The rows on approaches: every one is there with a figure; nothing is asserted about times."""

from __future__ import annotations

import pytest

from gspot_verified.cost.benchmarks import mechanism


def test_every_row_has_a_figure(monkeypatch: pytest.MonkeyPatch) -> None:
    cases = (("model", {"x": "0", "u": "3", "p": "1/2", "b": "-2"}),)
    assert {name for name, _ in mechanism.CASES} == {"oscillator", "extended", "rod"}
    monkeypatch.setattr(mechanism, "CASES", cases)
    steps: list[str] = []
    (row,) = mechanism.approach_rows(steps.append)
    assert row.figure is not None
    assert row.figure > 0
    assert row.note == "G-spot, lift-off, 160 bits"
    assert "approach of model from x = 0" in steps[0]
