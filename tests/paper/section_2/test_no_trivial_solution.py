"""That the extended example has no trivial solution rests on χ, α_1 and α_2, and on nothing else."""

from __future__ import annotations

import pytest
from flint import fmpq

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


def test_the_state_of_rest_has_no_p_of_0() -> None:
    """b = -α_1/χ, λ_N = α_2/α_3, p = α_1 α_3/(χ α_2), at numbers."""
    values = {"chi": fmpq(2), "alpha1": fmpq(-3), "alpha2": fmpq(-5), "alpha3": fmpq(7)}
    chi, first, second, third = values.values()
    values |= {"b": -first / chi, "L": second / third, "p": first * third / (chi * second)}
    images = {name: ledger.ALGEBRA.constant(value) for name, value in values.items()}
    texts = (*ledger.RATES.values(), ledger.BALANCE)
    assert all(ledger.ALGEBRA.substitute(ledger.ALGEBRA.read(text), images).is_zero() for text in texts)
    assert values["p"] != 0
