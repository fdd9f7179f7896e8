from __future__ import annotations

import json

import pytest

from gspot_verified.cost.times.rows import Row, Target, figure_text, grouped, seconds_text, table

FAST = Target("cold", 0.005, "s")
SPEED = Target("baseline / cold", 8.0, at_most=False)


@pytest.mark.parametrize(
    ("target", "figure", "met", "outcome"),
    [
        (FAST, 0.005, True, "met"),
        (FAST, 0.006, False, "missed by 1.20 x"),
        (SPEED, 8.0, True, "met"),
        (SPEED, 4.0, False, "missed by 2.00 x"),
        (SPEED, None, None, "not measured"),
    ],
)
def test_outcomes(target: Target, figure: float | None, met: bool | None, outcome: str) -> None:
    row = Row("case", "asked", target, figure)
    assert row.met is met
    assert row.outcome == outcome
    assert (row.badness <= 1) is (met is True)


@pytest.mark.parametrize(
    ("seconds", "text"),
    [(None, "-"), (0.0, "0 µs"), (4.56e-6, "4.56 µs"), (0.0123, "12.3 ms"), (98.76, "98.8 s"), (1234.5, "1234 s")],
)  # fmt: skip
def test_times_in_words(seconds: float | None, text: str) -> None:
    assert seconds_text(seconds) == text


def test_figures_and_targets_in_words() -> None:
    assert figure_text(1.2345, "x") == "1.23 x"
    assert figure_text(None, "x") == "-"
    assert (str(FAST), str(SPEED)) == ("cold <= 5 ms", "baseline / cold >= 8 x")


def test_the_table_is_aligned_and_has_blocks_and_notes() -> None:
    rows = [
        Row("first", "Θ at 1", FAST, 0.001, 0.001, 0.0005, 0.1, 2.0),
        Row("first", "Θ at a longer place", FAST, 0.02, 0.02, note="why"),
        Row("second", "Θ", SPEED, None),
    ]
    lines = table(rows).splitlines()
    assert lines.count("first") == lines.count("second") == 1
    assert lines[lines.index("first") + 3] == "      why"
    shown = [lines[0], *(line for line in lines if "<=" in line or ">=" in line)]
    assert len(shown) == 4
    assert len({line.index(cell) for line, cell in zip(shown[1:3], ("met", "missed"), strict=True)}) == 1
    assert "not measured" in shown[3]
    assert all(line == line.rstrip() for line in lines)


def test_large_groups_show_the_worst_and_the_missed() -> None:
    group = [Row("many", str(k), FAST, 0.001 * k) for k in range(1, 8)]
    assert [row.asked for row in grouped(group)] == ["6", "7"]
    good = [Row("many", str(k), FAST, 0.0001 * k) for k in range(1, 8)]
    assert [row.asked for row in grouped(good)] == ["7"]
    assert grouped(group[:5]) == group[:5]


def test_a_row_without_a_figure_is_shown() -> None:
    rows = [Row("many", str(k), FAST, None if k == 3 else 0.001) for k in range(8)]
    assert [row.asked for row in grouped(rows)] == ["3"]


def test_rows_are_json() -> None:
    data = json.loads(json.dumps(Row("case", "asked", SPEED, 4.0, 1.0, note="n").to_json()))
    assert data["target"] == "baseline / cold >= 8 x"
    assert (data["met"], data["outcome"], data["cold"], data["warm"]) == (False, "missed by 2.00 x", 1.0, None)
