"""Spaces of polynomials by indices and by monomials say the same."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.paper.section_5 import section_5_recursion
from gspot_verified.paper.section_5 import section_5_right_sides as ledger


@given(st.integers(-12, 12), st.integers(-12, 12))
def test_one_space_in_another(inner: int, outer: int) -> None:
    """The claim by indices is that of the monomials of all orders, even and odd."""
    shifts = range(0, 60, 2)
    inside = all(ledger.monomials((inner, 0), n) <= ledger.monomials((outer, 0), n) for n in shifts)
    assert inside is ledger.is_part_of(inner, outer)


@pytest.mark.parametrize("name", ["r_b", "r_v", "r", "r_xi"])
def test_smaller_spaces_do_not_hold_them(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    assert ledger.by_indices(name) is ledger.by_monomials(name) is ledger.in_systems(name) is True
    even, odd = ledger.CLAIMED[name]
    for smaller in ((even - 3, odd), (even, odd - 3), (even + 1, odd)):
        with monkeypatch.context() as patch:
            patch.setitem(ledger.CLAIMED, name, smaller)
            assert ledger.by_indices(name) is ledger.by_monomials(name) is ledger.in_systems(name) is False


def test_monomials() -> None:
    assert ledger.monomials((1, -3), 4) == {3, 0}
    assert ledger.monomials((1, -3), 3) == set()
    assert ledger.monomials((0, -4), -1) == set()
    assert ledger.monomials((0, -1), 4) == {2}


@pytest.mark.parametrize(
    ("name", "text"),
    [("specialV", "v1 - (b0 + p*lam + z0)"), ("specialB", "delta*b1 - (a2 - a3*lam)"), ("specialY", "y1 - v0 - z1")],
)
def test_another_fast_equation_is_seen(monkeypatch: pytest.MonkeyPatch, name: str, text: str) -> None:
    assert ledger.others_are_slow() is True
    monkeypatch.setitem(section_5_recursion.PRINTED["5-inner-system"], name, text)
    assert ledger.others_are_slow() is False
    assert [check.agrees for check in ledger.ENTRIES["5-inner-slow"]().checks] == [False, False]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("specialX", "xi1 - (f + 2*g*lam)"),
        ("specialPP", "p1 + a1"),
        ("specialB", "b1 - (a2 + a3*lam)"),
        ("specialY", "y1 - 2*v0"),
        ("specialV", "v1 - (b0 + p*lam + z0)"),
    ],
)
def test_another_slow_system_is_not_the_printed_one(monkeypatch: pytest.MonkeyPatch, name: str, text: str) -> None:
    assert ledger.is_the_slow_system() is ledger.by_forces_of_rest() is True
    monkeypatch.setitem(ledger.PRINTED["5-inner-slow"], name, text)
    assert ledger.is_the_slow_system() is ledger.by_forces_of_rest() is False


def test_a_slow_system_without_one_of_its_equations(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delitem(ledger.PRINTED["5-inner-slow"], "specialPP")
    assert ledger.is_the_slow_system() is False


@given(*(st.tuples(st.integers(0, 4), st.integers(0, 4)) for _ in range(2)))
def test_the_highest_power_of_a_product_is_that_of_its_monomials(first: ledger.Pair, second: ledger.Pair) -> None:
    for parity, indices in enumerate(ledger.product_of(first, second)):
        n = 8 + parity
        found = [max(ledger.monomials(first, k)) + max(ledger.monomials(second, n - k)) - n // 2 for k in range(n + 1)]
        assert sorted(set(found)) == sorted(set(indices))


def test_no_other_equation_shows_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    system = section_5_recursion.PRINTED["5-inner-system"]
    monkeypatch.setitem(section_5_recursion.PRINTED, "5-inner-system", {name: system[name] for name in ledger.FAST})
    assert ledger.others_are_slow() is False
