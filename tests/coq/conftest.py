"""The script ``check_in_coq.py``, which is no part of a package."""

from __future__ import annotations

from types import ModuleType

import pytest
from coq.coq_terms import COQ, script_named


@pytest.fixture
def script(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The script as a module."""
    monkeypatch.syspath_prepend(str(COQ))
    return script_named("check_in_coq")
