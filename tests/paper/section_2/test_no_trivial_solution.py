"""That the extended example has no trivial solution rests on χ, α_1 and α_2, and on nothing else."""

from __future__ import annotations

import pytest

from gspot_verified.paper.section_2 import no_trivial_solution as ledger


@pytest.mark.parametrize("name", ledger.NOT_ZERO)
def test_each_hypothesis_is_used_in_both_routes(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    assert ledger.by_derivatives() is ledger.by_the_line() is True
    monkeypatch.setattr(ledger, "NOT_ZERO", tuple(other for other in ledger.NOT_ZERO if other != name))
    assert ledger.by_derivatives() is ledger.by_the_line() is None


@pytest.mark.parametrize(
    ("name", "text"),
    [("b", "alpha2 - alpha3*L + L*b"), ("b", "b - alpha3*L"), ("p", "alpha1 + alpha2 + chi*b")],
)
def test_other_equations_leave_it_open(monkeypatch: pytest.MonkeyPatch, name: str, text: str) -> None:
    monkeypatch.setitem(ledger.RATES, name, text)
    assert ledger.by_derivatives() is None


def test_where_p_is_0_so_is_b(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ledger, "BALANCE", "b + p*L + t")
    assert ledger.by_derivatives() is None


def test_a_product_of_what_is_not_zero() -> None:
    read = ledger.ALGEBRA.read
    assert ledger.is_not_zero(read("-3*chi^2*alpha1")) is True
    assert ledger.is_not_zero(read("chi*L")) is False
    assert ledger.is_not_zero(read("chi*L"), "L") is True
    assert ledger.is_not_zero(read("chi + alpha1")) is ledger.is_not_zero(read("0*chi")) is False
