"""The roots of the fast system: the sign conditions, one by one."""

from __future__ import annotations

import pytest
from flint import fmpq, fmpq_poly

from gspot_verified import Outcome
from gspot_verified.paper.section_4 import section_4_fast as ledger
from gspot_verified.paper.section_4.section_4_outer import ALGEBRA


def outcome(identifier: str) -> Outcome:
    return ledger.ENTRIES[identifier]().verdict.outcome


@pytest.mark.parametrize(
    ("cubic", "saddle"),
    [
        ("lam^3 + 2*lam^2 + p*lam + 3*p", None),  # 2 p - 3 p < 0: unstable for p > 0
        ("lam^3 + 2*lam^2 - p*lam + p", Outcome.UNDECIDED),
        ("lam^3 + 2*lam^2 + p*lam - p", Outcome.UNDECIDED),
        ("lam^3 - 2*lam^2 + p*lam + p", Outcome.UNDECIDED),
    ],
)
def test_other_cubics_have_other_roots(monkeypatch: pytest.MonkeyPatch, cubic: str, saddle: Outcome | None) -> None:
    monkeypatch.setattr(ledger, "CUBIC", cubic)
    monkeypatch.setattr(ledger, "_is_the_factor", lambda: True)
    assert outcome("4-stable") is Outcome.REFUTED
    if saddle is not None:
        assert outcome("4-saddle") is saddle


@pytest.mark.parametrize("identifier", ["4-stable", "4-saddle"])
def test_the_cubic_must_be_the_factor_of_the_characteristic_polynomial(
    monkeypatch: pytest.MonkeyPatch, identifier: str
) -> None:
    monkeypatch.setattr(ledger, "CUBIC", "lam^3 + 2*lam^2 + p*lam + p/2")  # the same signs
    assert outcome(identifier) is Outcome.UNDECIDED


def test_three_negative_roots_are_no_saddle(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ledger, "CUBIC", "lam^3 + 6*lam^2 + 11*lam + 6")  # -1, -2, -3
    monkeypatch.setattr(ledger, "_is_the_factor", lambda: True)
    assert [check.agrees for check in ledger.ENTRIES["4-saddle"]().checks] == [False, False]


def test_the_sign_of_the_whole_cubic_decides_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """The roots of -f are those of f; a negative coefficient of λ² leaves one or three positive roots."""
    monkeypatch.setattr(ledger, "_is_the_factor", lambda: True)
    monkeypatch.setattr(ledger, "CUBIC", "-lam^3 - 6*lam^2 - 11*lam - 6")
    assert [check.agrees for check in ledger.ENTRIES["4-stable"]().checks] == [None, None]
    monkeypatch.setattr(ledger, "CUBIC", "lam^3 - 2*lam^2 - lam + p*2")
    assert ledger.ENTRIES["4-saddle"]().checks[0].agrees is not True


@pytest.mark.parametrize("p", [-7, -1, 2, 5])
def test_the_sturm_chain_is_made_of_remainders_with_the_sign_turned(p: int) -> None:
    images = {"p": ALGEBRA.constant(p)}
    numbers = [[ALGEBRA.substitute(value, images) for value in row] for row in ledger.sturm_chain()]
    chain = [fmpq_poly([fmpq(0) if v.is_zero() else v.leading_coefficient() for v in row]) for row in numbers]
    assert chain[0] == fmpq_poly([p, p, 2, 1])
    assert chain[1] == chain[0].derivative()
    assert [row.degree() for row in chain] == [3, 2, 1, 0]
    for before, divisor, found in zip(chain, chain[1:], chain[2:], strict=False):
        ratio = found[found.degree()] / -(before % divisor)[found.degree()]
        assert ratio > 0
        assert found == -ratio * (before % divisor)


def test_the_matrix_of_the_fast_system() -> None:
    rows = ["lam 0*p 0*p 0*p", "0*p lam -1+0*p 0*p", "-1+0*p p lam -p", "0*p -1+0*p 0*p lam+2"]
    assert ledger.fast_matrix() == [[ALGEBRA.read(text) for text in row.split()] for row in rows]


def test_roots_of_the_cubic_by_enclosures() -> None:
    for p in (-100, -3, -1, 1, 5, 300):
        roots = [root.real for root, _ in fmpq_poly([p, p, 2, 1]).complex_roots()]
        positive = sum(bool(root > 0) for root in roots)
        assert positive == (1 if p < 0 else 0)
        assert all(bool(root > 0) or bool(root < 0) for root in roots)


def test_the_sums_of_two_roots() -> None:
    """1 + 2, 1 + 3, 2 + 3 for (λ - 1)(λ - 2)(λ - 3); the polynomial that 4-stable names for the printed cubic."""
    sums = ledger.sums_of_two_roots(*(ALGEBRA.constant(n) for n in (-6, 11, -6)))
    assert sums == ALGEBRA.read("(lam-3)*(lam-4)*(lam-5)")
    p = ALGEBRA.read("p")
    assert ledger.sums_of_two_roots(p, p, ALGEBRA.constant(2)) == ALGEBRA.read("lam^3 + 4*lam^2 + (4+p)*lam + p")


def test_complex_roots_are_not_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    """(λ + 1)(λ² + 1): one root below 0."""
    rows = [[1, 1, 1, 1], [1, 2, 3], [-2, -1], [-1]]
    chain = [[ALGEBRA.constant(value) for value in row] for row in rows]
    monkeypatch.setattr(ledger, "sturm_chain", lambda: chain)
    assert ledger.roots_for_negative_p() == (1, 0)
