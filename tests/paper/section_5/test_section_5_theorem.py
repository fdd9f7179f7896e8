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
    assert ledger.unique_by_rank()
    assert {int(beta) for beta in tried if beta.denominator == 1} == {1, 2, 3, 4, 5}
    assert len({beta for beta in tried if beta.denominator != 1}) == 5
    for wrong in set(tried):  # noqa: B007
        assert ledger.unique_by_rank() is None


def test_an_integer_that_is_allowed_has_more_than_one_expansion(monkeypatch: pytest.MonkeyPatch) -> None:
    assert ledger.determined() is True
    assert ledger.unique_by_rank() is True
    monkeypatch.delitem(ledger.HYPOTHESES, "k - beta")
    assert ledger.determined() is False
    assert ledger.unique_by_rank() is False
    monkeypatch.setattr(ledger, "is_triangular", lambda: False)
    assert ledger.determined() is None


@pytest.mark.parametrize(
    ("stated", "before", "answer"),
    [
        ("M", {"x": 0}, True),
        ("M", {"x": 1}, None),
        ("M", {"x": 1, "y": 0}, True),
        ("M - 1", {"x": 0}, None),
        ("M + 1", {"x": 0}, False),
        ("M + 1", {"x": 1}, True),
        ("M + 1", {"x": 1, "y": 0}, False),
        ("2*M", {"x": 0}, False),
        ("M - n + 1", {"x": 0}, None),  # later for n > 0 only
    ],
)
def test_which_orders_feel_the_truncation(
    monkeypatch: pytest.MonkeyPatch, stated: str, before: dict[str, int], answer: bool | None
) -> None:
    monkeypatch.setattr(ledger, "RESIDUAL_ORDERS", {"equations": "M", "tried": stated})
    monkeypatch.setattr(ledger, "KNOWN_BEFORE", {"equations": {"x": 0}, "tried": before})
    assert ledger.orders_by_dependence() is answer


@pytest.mark.parametrize(
    ("begins", "answer"),
    [
        ([(2, 2), (4, 4)], True),
        ([(2, 2), (5, 4)], True),
        ([(3, 2), (5, 4)], None),
        ([(2, 2), (3, 4)], False),
        ([], None),
    ],
)
def test_residuals_that_begin_as_stated(begins: list[tuple[int, int]], answer: bool | None) -> None:
    assert ledger.begins_as_stated("equations", begins) is answer
    assert ledger.begins_as_stated("conditions", [(first + 2, terms) for first, terms in begins]) is answer


def test_the_conditions_of_truncated_sums() -> None:
    """y_0 is a constant that is not 0: at M = 4 the terms δ⁶ y_0 and δ⁶ v_2 are left, with the order M + 2."""
    for recursion in explicit.recursions(8):
        assert [ledger.conditions_begin(recursion, terms) for terms in (2, 4)] == [6, 6]
        at_rest, recursion.p[1] = recursion.p[1], recursion.y[0]
        assert ledger.conditions_begin(recursion, 4) == 1
        recursion.p[1], recursion.xi[0][4] = at_rest, recursion.y[0]
        assert ledger.conditions_begin(recursion, 4) == 2


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
        ("5-theorem-1", ledger, "rank_defect", lambda *_: 0, 1, None),
        ("5-theorem-1", explicit, "equations_hold", lambda found: found.system.name == "random 0", 2, None),
        ("5-theorem-1", explicit, "synchronised", lambda found: found.system.name == "random 0", 2, None),
        ("5-theorem-1-orders", ledger, "dependence", lambda: False, 0, None),
        ("5-theorem-1-orders", ledger, "residual_begins", lambda _, terms: min(terms, 4), 1, False),
    ],
)
def test_what_a_failing_step_does_to_its_check(
    identifier: str, target: Any, name: str, wrong: Any, position: int, answer: bool | None
) -> None:
    answers = answers_with(target, name, wrong, ledger.ENTRIES[identifier])
    assert answers == [answer if k == position else True for k in range(len(answers))]
