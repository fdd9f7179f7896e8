"""Steps of Theorem 1's recursion: what only one value of k would show."""

from __future__ import annotations

import pytest

from gspot_verified.paper.section_5 import section_5_recursion as ledger


@pytest.mark.parametrize("target", ["u0", "u3"])
def test_seven_values_of_k_are_not_enough_for_a_higher_degree(monkeypatch: pytest.MonkeyPatch, target: str) -> None:
    """A term of degree 7 in k that vanishes at k = 0, ..., 6: the route by values must refuse it by its degree."""
    vanishing = "*".join(f"(k-{k})" for k in range(7))
    wrong = f"{ledger.CORRECTED['5-monomial']['image']} + {vanishing}*{target}"
    monkeypatch.setitem(ledger.CORRECTED, "5-monomial", {"image": wrong})
    assert [check.agrees for check in ledger.ENTRIES["5-monomial"]().checks] == [None, None]
