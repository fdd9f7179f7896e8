"""The explicit systems of Theorem 1 and its lemma: each question answers no when it must."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from flint import fmpq, fmpq_poly

from gspot_verified.expansion.series.spaces import SpacePolynomial
from gspot_verified.paper.section_5 import explicit_expansions as explicit

ONE, ZERO = fmpq_poly([1]), fmpq_poly([])


@pytest.mark.parametrize("row", range(2))
@pytest.mark.parametrize("place", range(2))
def test_a_residual_or_a_start_that_is_not_zero(monkeypatch: pytest.MonkeyPatch, row: int, place: int) -> None:
    at_rest = SpacePolynomial.from_list(3, [fmpq(0), fmpq(0), fmpq(0), fmpq(7)])
    moved = SpacePolynomial.from_list(3, [fmpq(2), fmpq(0), fmpq(0), fmpq(7)])
    rests = [[ZERO, ZERO], [ZERO, ZERO]]
    monkeypatch.setattr(explicit, "residuals", lambda *_: rests)
    recursion: Any = SimpleNamespace(p=[at_rest, at_rest])
    assert explicit.equations_hold(recursion)
    recursion.p[place] = moved
    assert not explicit.equations_hold(recursion)
    recursion.p[place] = at_rest
    rests[row][place] = ONE
    assert not explicit.equations_hold(recursion)


def test_the_residuals_are_taken_of_all_terms() -> None:
    (recursion, *_) = explicit.recursions(6)
    for n in range(6):
        if any(recursion.b[n].coefficients()):
            honest = recursion.b[n]
            recursion.b[n] = honest + honest
            assert not explicit.equations_hold(recursion)
            recursion.b[n] = honest
    assert explicit.equations_hold(recursion)


def test_the_quartic_needs_the_scale_of_xi() -> None:
    for scale in (1, 2, 3):
        assert explicit.highest_in_a_quartic(6, scale) == {n: n - scale for n in range(scale, 6)}


def test_terms_outside_their_spaces() -> None:
    rows = [explicit.rows_of(recursion) for recursion in explicit.recursions(10)]
    assert {name for name, _ in rows[0]} == set(explicit.SPACES)
    assert [explicit.outside_their_spaces(row) for row in rows] == [[], [], []]
    wrong = [("p", [[0, 1], [1]]), ("lambda_n", [[1], [], [0, 0, 1]]), ("v", [[], [], [2], [0, 1]])]
    assert explicit.outside_their_spaces(wrong) == ["p of the order 1", "lambda_n of the order 2", "v of the order 3"]


@pytest.mark.parametrize("order", [2, 8, 9])
def test_a_wrong_slope_in_the_last_term_is_noticed(monkeypatch: pytest.MonkeyPatch, order: int) -> None:
    honest, calls = explicit._series, []

    def series(functions: Any, rows: Any, orders: int) -> Any:
        found = honest(functions, rows, orders)
        calls.append(found)
        if len(calls) == 1:
            return found
        wrong = {f: [found[f][n] for n in range(orders)] for f in functions}
        wrong[functions[-1]][order] = wrong[functions[-1]][order] + wrong[functions[-1]][order]
        return wrong

    assert explicit.lemma_on_functions()
    monkeypatch.setattr(explicit, "_series", series)
    assert not explicit.lemma_on_functions()
