"""Every refuted statement has its one-line reason and its consequence, and no other statement has one."""

import re

import pytest
from paper.refuted import REFUTED

from gspot_verified.paper.checks.consequences import _CONSEQUENCES, Reach, consequence
from gspot_verified.paper.checks.entry import Check, Rung, Section
from gspot_verified.paper.checks.paper import _places


def entry(identifier, agrees):
    checks = [Check(Rung.EXACT, what, agrees, "f") for what in ("one", "another")]
    return Section("Section 4").settled(identifier, "line 986", "x", "s", *checks)


def test_a_consequence_belongs_to_a_refuted_statement():
    assert entry("4-order", False).consequence == consequence("4-order")
    assert entry("4-order", True).consequence is None
    assert entry("no such", False).consequence is None
    assert entry("4-order", False).to_json()["consequence"]["reach"] == "none"


@pytest.mark.parametrize("identifier", sorted(_CONSEQUENCES))
def test_each_says_why(identifier):
    found = consequence(identifier)
    assert found.reach in Reach
    assert found.why.endswith(".")
    assert found.reason.endswith(".")
    assert found.reason != found.why
    assert "\n" not in found.reason
    assert 20 < len(found.reason) <= 100, "a line"
    assert found.table == "" or found.table.startswith("Table ")


def test_every_refuted_statement_has_its_reason_and_its_consequence_and_no_other_has():
    assert set(_CONSEQUENCES) == REFUTED


def test_the_cells_of_table_1_are_one_item():
    cells = {name: found.table for name, found in _CONSEQUENCES.items() if name.startswith("3-table-1")}
    assert len(cells) == 2
    assert set(cells.values()) == {"Table 1(a)"}
    assert {name for name, found in _CONSEQUENCES.items() if found.table} == set(cells)


def test_what_is_proved_of_all_series_says_which_series():
    """Theorems E3 and E5 are about series whose neighbours are at least 1 % apart."""
    reasons = [consequence(name).reason for name in _CONSEQUENCES if name.startswith("3-table-1")]
    assert len(reasons) == 2
    reasons = [reason for reason in reasons if "series" in reason]
    assert reasons
    assert all("1 % apart" in reason for reason in reasons)


def test_figures_and_tables_are_named_by_numbers_that_the_paper_prints():
    printed = {name for _, _, name in _places()}
    for identifier, found in _CONSEQUENCES.items():
        for name in re.findall(r"(?:Figure|Table|Theorem) \d+", f"{found.reason} {found.why}"):
            assert name in printed, (identifier, name)
