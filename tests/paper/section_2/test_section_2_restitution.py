"""The coefficient of restitution: what each step asks for, and what the texts say of it."""

from __future__ import annotations

import pytest
from flint import fmpq
from flint.utils.flint_exceptions import DomainError

from gspot_verified import Outcome
from gspot_verified.paper.section_2 import section_2_restitution as ledger


@pytest.mark.parametrize(
    ("powers", "answer"),
    [
        ({}, False),  # e is one number below 1
        ({"k_1": -1}, False),  # ζ is fixed: at most ζ in the limit
        ({"k_1": -3, "c": -1}, False),
        ({"k_2": 1}, None),
        ({"k_1": -1, "c": -1}, None),
        ({"k_1": 1, "k_2": 1}, True),
        ({"k_1": -2, "c": -1}, None),  # ζ → 0, ρ/ζ² fixed
        ({"k_1": 1, "k_2": 1, "c": fmpq(1, 2)}, False),
        ({"k_1": -1, "c": 1}, True),
    ],
)
def test_where_a_bound_of_the_loss_tends_to_0(powers: dict[str, int], answer: bool | None) -> None:
    assert ledger.loss_vanishes({name: fmpq(power) for name, power in powers.items()}) is answer


@pytest.mark.parametrize("power", [-2, 0])
def test_a_limit_that_is_not_elastic_is_refuted(monkeypatch: pytest.MonkeyPatch, power: int) -> None:
    monkeypatch.setitem(ledger.ELASTIC, "k_1 → ∞", {"k_1": fmpq(power)})
    assert ledger.ENTRIES["2-restitution-elastic"]().verdict.outcome is Outcome.REFUTED


@pytest.mark.parametrize(
    ("powers", "answer"), [((-1, 1), True), ((1, 1), False), ((-1, -1), False), ((0, 1), None), ((-1, 0), None)]
)
def test_where_the_coefficient_tends_to_0(
    monkeypatch: pytest.MonkeyPatch, powers: tuple[int, int], answer: bool | None
) -> None:
    """With k_1 = k_2 = n, or 1/n, it tends to 1."""
    monkeypatch.setattr(ledger, "INELASTIC", dict(zip(("k_1", "k_2"), powers, strict=True)))
    assert ledger.bound_vanishes() is answer


@pytest.mark.parametrize("height", [fmpq(3, 5), fmpq(8, 11), fmpq(19, 25), fmpq(1)])
def test_a_number_between(monkeypatch: pytest.MonkeyPatch, height: fmpq) -> None:
    """sin 4 = -0.7568."""
    assert ledger.numbers()
    monkeypatch.setattr(ledger, "HEIGHT", height)
    assert not ledger.numbers()


@pytest.mark.parametrize(
    ("step", "name", "wrong"),
    [
        ("energy_falls", "z", "-rho*z + (z - y)"),
        ("energy_falls", "v", "zeta*(z + y)"),
        ("loss_is_work", "v", "zeta*z"),
        ("loss_is_work", "y", "v"),
        ("one_turn", "z", "-rho*z - 2*(z - y)"),
        ("one_turn", "y", "2*zeta*v"),
        ("lag", "z", "-z - (z - y)"),
        ("lag", "y", "-zeta*v"),
        ("creeps", "v", "z - y"),
        ("creeps", "z", "rho*z - (z - y)"),
    ],
)
def test_each_identity_is_of_this_motion(monkeypatch: pytest.MonkeyPatch, step: str, name: str, wrong: str) -> None:
    identity = getattr(ledger, step)
    assert identity()
    monkeypatch.setitem(ledger.MOTION, name, wrong)
    assert not identity()


def test_the_places_of_a_limit() -> None:
    """ρ = k_1/k_2 and ζ = c sqrt(p/k_2), with p = 1."""
    assert ledger.at({"k_1": fmpq(2)}, 3) == (9, 1)
    assert ledger.at({"k_2": fmpq(-2)}, 3) == (9, 3)
    assert ledger.at({"c": fmpq(-1)}, 8) == (1, fmpq(1, 8))
    assert ledger.at({"k_1": fmpq(1), "k_2": fmpq(4), "c": fmpq(3)}, 2) == (fmpq(1, 8), 2)


def test_the_rational_root() -> None:
    assert ledger.root(fmpq(9, 16)) == fmpq(3, 4)
    for number in (fmpq(2), fmpq(1, 3), fmpq(9, 17)):
        with pytest.raises(DomainError, match="not a square"):
            ledger.root(number)


def test_the_texts_name_what_is_enclosed() -> None:
    lossy = ledger.ENTRIES["2-restitution-inelastic"]().checks[-1].what
    assert "for c = p = 1, k_1 = 1/k_2 = 1/16 and 1/64: e falls" in lossy
    statement = ledger.ENTRIES["2-restitution-not-fixed"]().statement
    assert "k_1 = 1/400, k_2 = c = 1" in statement
    assert "is below 1/2 for p = 1/25 and above 9/10 for p = 10000" in statement
    assert "p = C - μB depends on the mechanism" in ledger.ENTRIES["2-restitution-not-fixed"]().note


@pytest.mark.parametrize(
    ("apart", "answers"),
    [
        ((fmpq(9, 20), fmpq(9, 10)), [True, None]),  # the bound of Theorem Q3 is 0.4506
        ((fmpq(1, 2), fmpq(24, 25)), [True, None]),
        ((fmpq(1, 100), fmpq(9, 10)), [False, None]),
    ],
)
def test_the_two_routes_to_a_coefficient_that_is_not_fixed(
    monkeypatch: pytest.MonkeyPatch, apart: tuple[fmpq, fmpq], answers: list[bool | None]
) -> None:
    assert [ledger.they_differ(), ledger.the_bounds_differ()] == [True, True]
    monkeypatch.setattr(ledger, "APART", apart)
    assert [ledger.they_differ(), ledger.the_bounds_differ()] == answers


def test_each_statement_names_the_start() -> None:
    """A surface that is still deformed holds energy: proofs/restitution.md begins at rest."""
    statements = [build().statement for build in ledger.ENTRIES.values()]
    assert len(statements) == 4
    assert all("λ_N the only force, y = z = 0 at its start" in statement for statement in statements)
