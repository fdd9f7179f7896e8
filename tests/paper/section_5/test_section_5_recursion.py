"""Steps of Theorem 1's recursion: what only one value of k would show, and what the extended example shows."""

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


WRONG = {
    "P": "2*p1", "r_p": "-a1n", "B": "b1 - alpha3*l0", "r_b": "2*a2n - S", "Y": "y1 - 2*v0",
    "V": "v1 - b0 - alpha3*s*l0", "r_v": "2*S", "Z": "z0 - l0", "r_z": "-q1", "L": "l0 - z0 - y0", "p_0": "alpha3*s",
    "b left": "n - k - 1", "b last": "n", "v left": "n - k + 1", "v right": "k/2", "v first": "1 + 0*k", "v last": "n",
}  # fmt: skip


@pytest.mark.parametrize("part", ["", *WRONG])
def test_the_example_sees_a_wrong_term_of_each_equation(part: str) -> None:
    """Without the two other routes, which share the terms that are no sums."""
    texts = ledger.PRINTED["5-orders"] | ({part: WRONG[part]} if part else {})
    found = ledger.orders_of_the_example({name: ledger.ALGEBRA.read(text) for name, text in texts.items()})
    assert any(not value.is_zero() for value in found) is bool(part)


WRONG_RATE = {
    "right side": "fn - S", "left": "n - k - 1", "right": "n", "first": "1 + 0*k", "last": "n - 1",
}  # fmt: skip


@pytest.mark.parametrize("part", ["", *WRONG_RATE])
def test_the_example_sees_a_wrong_term_of_the_rate_of_the_state(part: str) -> None:
    """Without the two other routes, which share the terms that are no sums; "right" is the printed misprint."""
    texts = ledger.PRINTED["5-xinprime"] | ledger.CORRECTED["5-xinprime"]
    texts |= {part: WRONG_RATE[part]} if part else {}
    found = ledger.rates_of_the_example({name: ledger.ALGEBRA.read(text) for name, text in texts.items()})
    assert any(not value.is_zero() for value in found) is bool(part)
