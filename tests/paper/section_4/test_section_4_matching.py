"""The powers of ε and the table of Section 4.4."""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq

from gspot_verified import Outcome
from gspot_verified.numbers.balls import working_bits
from gspot_verified.paper.section_4 import section_4_matching as ledger
from gspot_verified.theta_function.theta import theta


def outcome(identifier: str) -> Outcome:
    return ledger.ENTRIES[identifier]().verdict.outcome


@pytest.mark.parametrize("row", range(len(ledger.TABLE)))
def test_another_decimal_in_the_table_is_refuted(monkeypatch: pytest.MonkeyPatch, row: int) -> None:
    table = list(ledger.TABLE)
    text, name, beta = table[row]
    table[row] = (text[:-1] + str((int(text[-1]) + 1) % 10), name, beta)
    monkeypatch.setattr(ledger, "TABLE", tuple(table))
    assert outcome("4-table") is Outcome.REFUTED
    assert [check.agrees for check in ledger.ENTRIES["4-table"]().checks] == [False, False]


def test_the_table_has_four_rows_at_three_beta() -> None:
    betas = (fmpq(1, 2), fmpq(3, 2), fmpq(5, 2))
    assert [row[1:] for row in ledger.TABLE] == [(name, beta) for name in "bvyt" for beta in betas]


@pytest.mark.parametrize(("exponent", "agrees"), [("0.345", True), ("0.255", True), ("0.355", False), ("0.245", False)])
def test_half_a_unit_of_the_printed_decimal(monkeypatch: pytest.MonkeyPatch, exponent: str, agrees: bool) -> None:
    value = fmpq(*Fraction(exponent).as_integer_ratio())
    monkeypatch.setattr(ledger, "TABLE", (("0.3", "b", value * fmpq(3, 2)),))
    assert [check.agrees for check in ledger.ENTRIES["4-table"]().checks] == [agrees, agrees]


@pytest.mark.parametrize("beta", [fmpq(1, 2), fmpq(3, 2), fmpq(7, 3)])
def test_the_powers_agree_in_numbers(beta: fmpq) -> None:
    texts = {name: ledger.ALGEBRA.read(text) for name, text in ledger.PRINTED["4-matching"].items()}
    with working_bits(200):
        kappa, epsilon, s, power = arb(fmpq(3, 7)), arb(fmpq(1, 1000)), arb(-5), arb(beta)
        outer = (-(epsilon ** arb(fmpq(2, 3))) * s) ** power
        inner = kappa**-power * epsilon ** (2 * power / 3) * (-kappa * s) ** power
        assert abs(inner / outer - 1) < arb("1e-50")
        logs = {"K": kappa.log(), "E": epsilon.log(), "S": (-s).log(), "beta": power}
        total = arb(0)
        for exponents, number in ledger._inner(texts).terms():
            term = arb(number)
            for name, exponent in zip(ledger.ALGEBRA.symbols, exponents, strict=True):
                if exponent:
                    term *= logs[name] ** int(exponent)
            total += term
        assert abs(total - inner.log()) < arb("1e-50")


def test_the_powers_bound_the_deviations_and_are_not_their_sizes_everywhere() -> None:
    """At β = 2 the inner solution is τ^2: b and b', and with it y, z and λ_N, are 0 at s = 0, and b'' is not."""
    entry = ledger.ENTRIES["4-exponents"]()
    assert [theta(0, 2, derivative=k).is_zero() for k in range(3)] == [True, True, False]
    assert theta(fmpq(1, 2), 2).contains(fmpq(1, 4))
    assert "at most of the sizes" in entry.statement
    assert "at β = 2, Θ = τ^2, those of b, y, z and λ_N are at s = 0" in entry.note
