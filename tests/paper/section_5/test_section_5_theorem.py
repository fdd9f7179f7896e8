"""Theorem 1: what its steps must refuse, the matrix of its equations, and which orders the residual knows.

Page: proofs/expansion.md, section 3.
"""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from flint import fmpq, fmpq_poly
from paper.bite import answers_with

from gspot_verified.paper.section_5 import explicit_expansions as explicit
from gspot_verified.paper.section_5 import section_5_theorem as ledger

ALPHA_1 = fmpq(-3, 7)


def test_a_divisor_that_is_zero_is_not_justified(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ledger, "divisors", lambda: {"x": ledger.ALGEBRA.constant(0)})
    assert ledger.unjustified() == ["x: 0"]


@pytest.mark.parametrize(
    "image",
    [
        "(k*alpha1 - alpha3)*u3 + 2*k*(k-1)*(k-2)*u0 + u0*u3",  # more than multiples of the two powers
        "(k*alpha1 - alpha3)*u3 + 2*(k+1)*(k-1)*(k-2)*u0",  # a power s^(-3) for k = 0
        "(k*alpha1 - alpha3)*u3 + 2*k*(k+1)*(k-2)*u0",
        "(k*alpha1 - alpha3)*u3 + 2*k*(k-1)*(k+1)*u0",
    ],
)
def test_an_operator_that_is_not_triangular(monkeypatch: pytest.MonkeyPatch, image: str) -> None:
    assert ledger.is_triangular()
    monkeypatch.setitem(ledger.CORRECTED["5-monomial"], "image", image)
    assert not ledger.is_triangular()


@pytest.mark.parametrize("beta", [1, 2, 3, 4, 5])
def test_what_the_matrix_takes_to_zero_solves_the_equations(beta: int) -> None:
    """Eqs. specialBn to specialLn without their right sides, as polynomials."""
    alpha_3, degree = beta * ALPHA_1, 5
    matrix = ledger.homogeneous(degree, ALPHA_1, alpha_3)
    assert matrix.nrows() == matrix.ncols() == 5 * degree
    reduced, rank = matrix.rref()
    assert rank == 5 * degree - 1
    leading = [next(k for k in range(5 * degree) if reduced[i, k] != 0) for i in range(rank)]
    (free,) = set(range(5 * degree)) - set(leading)
    solution = [fmpq(0)] * (5 * degree)
    solution[free] = fmpq(1)
    for i, k in enumerate(leading):
        solution[k] = -reduced[i, free]
    parts = []
    for length in (degree + 1, degree, degree, degree, degree - 1):
        parts.append(fmpq_poly(solution[:length]))
        solution = solution[length:]
    b, force, y, z, v = parts
    s = fmpq_poly([0, 1])
    assert b.degree() == beta
    assert b.derivative() + alpha_3 * force == 0
    assert y.derivative() == v
    assert v.derivative() - b - ALPHA_1 * s * force == 0
    assert z + force == 0
    assert force - z + y == 0
    assert 2 * b.derivative().derivative().derivative() + ALPHA_1 * s * b.derivative() - alpha_3 * b == 0


def test_every_beta_is_tried_and_one_wrong_rank_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    tried = []

    def defect(degree: int, alpha_1: fmpq, alpha_3: fmpq) -> int:
        beta = alpha_3 / alpha_1
        assert degree == 5
        assert 0 < beta < 6
        tried.append(beta)
        return int(beta.denominator == 1) if beta != wrong else 2

    wrong = fmpq(-1)
    monkeypatch.setattr(ledger, "rank_defect", defect)
    assert ledger.unique_only_off_integers()
    assert {int(beta) for beta in tried if beta.denominator == 1} == {1, 2, 3, 4, 5}
    assert len({beta for beta in tried if beta.denominator != 1}) == 5
    for wrong in set(tried):  # noqa: B007
        assert not ledger.unique_only_off_integers()


@pytest.mark.parametrize(
    ("stated", "before", "felt", "first"),
    [
        ("M", {"x": 0}, False, True),
        ("M", {"x": 1}, False, False),
        ("M", {"x": 1, "y": 0}, False, True),
        ("M - 1", {"x": 0}, False, False),
        ("M + 1", {"x": 0}, True, False),
        ("M + 1", {"x": 1}, False, True),
        ("M + 1", {"x": 1, "y": 0}, True, True),
        ("2*M", {"x": 0}, True, False),
        ("M - n + 1", {"x": 0}, True, False),  # enough for n > 0 only
    ],
)
def test_which_orders_feel_the_truncation(
    monkeypatch: pytest.MonkeyPatch, stated: str, before: dict[str, int], felt: bool, first: bool
) -> None:
    monkeypatch.setattr(ledger, "RESIDUAL_ORDERS", {"equations": "M", "tried": stated})
    monkeypatch.setattr(ledger, "KNOWN_BEFORE", {"equations": {"x": 0}, "tried": before})
    assert ledger.felt_by_truncation("tried") is felt
    assert ledger.stated_is_first("tried") is first
    assert ledger.truncation_is_felt_at_the_stated_orders() is (first and not felt)


def changed_orders(name: str, order: int) -> set[tuple[int, int]]:
    """(equation, order of the residual) where a change of one term is noticed, in a nonlinear system."""
    (recursion,) = [found for found in explicit.recursions() if found.system.name == "random 1"]
    orders = len(recursion.p)

    def term(value: Any) -> SimpleNamespace:
        return SimpleNamespace(coefficients=lambda: [*value.coefficients(), *[fmpq(0)] * 20, fmpq(1)])

    terms: dict[str, list[Any]] = {key: list(getattr(recursion, key)) for key in explicit.SPACES}
    old = terms[name][order]
    terms[name][order] = [term(part) for part in old] if name == "xi" else term(old)
    changed = explicit.residuals(SimpleNamespace(system=recursion.system, **terms), orders, orders)  # type: ignore[arg-type]
    return {(k, n) for n, row in enumerate(changed) for k, value in enumerate(row) if value != 0}


def test_the_residual_of_an_order_knows_the_terms_that_the_table_says() -> None:
    order, functions = 3, (0, 1)  # the rows of p' and b', where functions of xi stand
    known = {name: min(n for _, n in changed_orders(name, order)) - order for name in explicit.SPACES}
    (deformation,) = [k for k, n in changed_orders("z", order) if n == order + 1]
    assert (deformation, order) in changed_orders("z", order)
    known["z of delta z'"] = 1
    known["xi in f"] = min(n for k, n in changed_orders("xi", order) if k in functions) - order
    assert known == ledger.KNOWN_BEFORE["equations"]


@pytest.mark.parametrize(
    ("identifier", "target", "name", "wrong", "position", "answer"),
    [
        ("5-theorem-1", ledger, "dependence", lambda: False, 0, None),
        ("5-theorem-1", ledger, "is_triangular", lambda: False, 0, None),
        ("5-theorem-1", ledger, "divisors_are_justified", lambda: False, 0, None),
        ("5-theorem-1", ledger, "unique_only_off_integers", lambda: False, 1, None),
        ("5-theorem-1", explicit, "equations_hold", lambda found: found.system.name == "random 0", 2, None),
        ("5-theorem-1", explicit, "synchronised", lambda found: found.system.name == "random 0", 2, None),
        ("5-theorem-1-orders", ledger, "dependence", lambda: False, 0, None),
        ("5-theorem-1-orders", ledger, "truncation_is_felt_at_the_stated_orders", lambda: False, 0, None),
        ("5-theorem-1-orders", ledger, "residual_begins", lambda _, terms: min(terms, 4), 1, False),
    ],
)
def test_what_a_failing_step_does_to_its_check(
    identifier: str, target: Any, name: str, wrong: Any, position: int, answer: bool | None
) -> None:
    answers = answers_with(target, name, wrong, ledger.ENTRIES[identifier])
    assert answers == [answer if k == position else True for k in range(len(answers))]
