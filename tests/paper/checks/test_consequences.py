"""Every refuted statement has its consequence, and no other statement has one."""

import pytest

from gspot_verified.paper.checks.consequences import _CONSEQUENCES, Reach, consequence
from gspot_verified.paper.checks.entry import Check, Rung, settled


def entry(identifier, agrees):
    checks = [Check(Rung.EXACT, what, agrees, "f") for what in ("one", "another")]
    return settled("Section 4", identifier, "line 986", "x", "s", *checks)


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
