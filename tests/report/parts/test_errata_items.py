"""The errata as items: by consequence, then as the paper goes, and one item for a table."""

from __future__ import annotations

from typing import Any

from gspot_verified.paper.checks.consequences import Reach, consequence
from gspot_verified.report.parts.errata_items import ORDER, TITLES, errata


def entry(identifier: str, lines: list[list[int]], outcome: str = "refuted", label: str = "a place") -> dict[str, Any]:
    found = consequence(identifier)
    return {
        "identifier": identifier, "lines": lines, "verdict": {"outcome": outcome}, "label": label, "printed": "",
        "consequence": found.to_json() if found else None,
    }  # fmt: skip


ENTRIES = [
    entry("4-order", [[986, 986]]),
    entry("3-table-1-one-series", [[844, 850]]),
    entry("S-gamma-intervals", [[1268, 1271]]),
    entry("4-inner-scaling-v", [[1192, 1197]]),
    entry("no such", []),
    entry("3-table-1-y-1_2", [[889, 896]]),
    entry("1-beta", [[379, 383]]),
    entry("A-leading", [[2459, 2459]], "proved"),
    entry("3-sides", [[781, 785]]),
]


def names(reach: Reach | None) -> list[list[str]]:
    return [[one["identifier"] for one in item.entries] for item in errata(ENTRIES)[reach]]


def test_the_order_is_that_of_the_consequence_and_then_of_the_paper() -> None:
    assert list(errata(ENTRIES)) == [*ORDER, None]
    assert ORDER == (Reach.CONCLUSION, Reach.LOCAL, Reach.NONE)
    assert names(Reach.CONCLUSION) == [["3-sides"], ["S-gamma-intervals"]]
    assert names(Reach.LOCAL) == [["1-beta"], ["3-table-1-one-series", "3-table-1-y-1_2"], ["4-inner-scaling-v"]]
    assert names(Reach.NONE) == [["4-order"]]
    assert names(None) == [["no such"]]
    assert set(TITLES) == {*Reach, None}


def test_what_is_not_refuted_is_no_erratum_and_a_reach_without_items_is_left_out() -> None:
    assert errata([entry("A-leading", [], "proved"), entry("4-order", [[986, 986]], "undecided")]) == {}
    assert list(errata([entry("1-beta", [[379, 383]])])) == [Reach.LOCAL]


def test_places_and_lines() -> None:
    local = errata(ENTRIES)[Reach.LOCAL]
    assert [item.places for item in local] == ["Sec. 1.4", "Table 1(a)", "Sec. 4.3, eq. (55)"]
    assert [item.lines for item in local] == ["379–383", "844–850, 889–896", "1192–1197"]
    [unknown] = errata(ENTRIES)[None]
    assert (unknown.places, unknown.lines) == ("a place", "")
    [order] = errata(ENTRIES)[Reach.NONE]
    assert order.lines == "986"
