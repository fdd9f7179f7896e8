"""The whole ledger, run once for all tests that read it."""

from __future__ import annotations

import pytest

from gspot_verified.ledger.entry import Entry
from gspot_verified.ledger.verify import verify_paper


@pytest.fixture(scope="session")
def whole_ledger() -> list[Entry]:
    return verify_paper()
