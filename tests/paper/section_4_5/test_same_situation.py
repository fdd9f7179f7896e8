"""The side of the impact in Case III: two routes to the sign at τ = 0."""

from __future__ import annotations

import pytest
from flint import fmpq

from gspot_verified.paper.section_4_5 import same_situation as ledger


@pytest.mark.parametrize(
    ("beta", "positive"), [("3/2", False), ("5/2", False), ("7/2", False), ("9/2", True), ("13/2", True), ("1/2", True)]
)
def test_the_initial_value_has_the_sign_of_the_enclosure(
    monkeypatch: pytest.MonkeyPatch, beta: str, positive: bool
) -> None:
    monkeypatch.setattr(ledger, "BETA", fmpq(*map(int, beta.split("/"))))
    assert ledger.is_so_by_the_initial_value() is ledger.is_so_at_zero() is not positive


def test_an_uncertain_sign_is_open(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ledger, "sign_of", lambda _: None)
    assert ledger.is_so_by_the_initial_value() is None
