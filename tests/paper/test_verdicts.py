"""Each entry of the ledger by itself: its verdict, and that every check of it could tell."""

from __future__ import annotations

import pytest
from paper.refuted import REFUTED
from paper.tables import TABLES, table

from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.cache import Cache
from gspot_verified.paper.verify import PARTS, verify_claims

IDENTIFIERS = [identifier for part in PARTS.values() for identifier in part]
PART_OF = {identifier: name for name in TABLES for identifier in table(name).TEETH}


@pytest.mark.parametrize(
    "identifier", [pytest.param(i, id=i, marks=pytest.mark.part(PART_OF.get(i, i))) for i in IDENTIFIERS]
)
def test_the_verdict_and_every_check(identifier: str, ledger_cache: Cache) -> None:
    [entry], _ = verify_claims([identifier], cache=ledger_cache, alone=True)
    assert entry.identifier == identifier
    assert entry.verdict.outcome is (Outcome.REFUTED if identifier in REFUTED else Outcome.PROVED)
    answers = [check.agrees for check in entry.checks]
    if identifier in REFUTED:
        assert answers.count(False) >= 2
        assert None not in answers
    else:
        assert set(answers) == {True}
