"""Other springs and dampers than the paper's: the original equations hold, by two routes."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.expansion.series.regularisation import PAPER, Regularisation
from gspot_verified.expansion.series.system import System
from gspot_verified.expansion.time_series import Table, time_series
from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.testing import check_expansion, extended_example

OTHERS = [Regularisation.of(*values) for values in ((2, 1, 1), (1, 3, "1/2"), ("5/7", "2/3", 0), (4, 4, 9))]


def with_springs(regularisation: Regularisation, chi: int | str = "2/3") -> System:
    return replace(extended_example(chi), regularisation=regularisation)


def added(*parts: tuple[fmpq, int, int, Table]) -> Table:
    """The sum of factor t^k epsilon^m table."""
    total: Table = {}
    for factor, k, m, table in parts:
        for (i, j), value in table.items():
            total[i + k, j + m] = total.get((i + k, j + m), fmpq(0)) + factor * value
    return total


def slope(table: Table) -> Table:
    return {(k - 1, m): k * value for (k, m), value in table.items() if k}


@pytest.mark.parametrize("name", ["k_1", "k_2", "c"])
def test_constants_given_by_hand_are_plain_and_exact(name: str) -> None:
    """Balls and floats passed, and the first sum with them was a bare TypeError."""
    given: dict[str, Any] = {"k_1": fmpq(2), "k_2": fmpq(3), "c": fmpq(1)}
    with pytest.raises(ValueError, match=f"{name} must be a rational number, got a ball"):
        Regularisation(**given | {name: arb("2.5", "0.1")})
    with pytest.raises(TypeError, match=f"{name}: a float is not taken as exact"):
        Regularisation(**given | {name: 2.5})
    made = Regularisation(**given | {name: 2})
    assert type(getattr(made, name)) is fmpq
    assert made == Regularisation.of(**given | {name: "2"})


@pytest.mark.parametrize("regularisation", OTHERS, ids=str)
def test_the_contact_equations_hold_as_the_user_wrote_them(regularisation: Regularisation) -> None:
    """c z' = -k_1 z - lambda and lambda = k_2 (z - y) times epsilon^2, coefficient by coefficient."""
    order = 12
    of = expand_system(with_springs(regularisation), order).in_time()
    r = regularisation
    damped = added((r.c, 0, 1, slope(of.z)), (r.k_1, 0, 0, of.z), (fmpq(1), 0, 2, of.lambda_n))
    pressed = added((fmpq(1), 0, 2, of.lambda_n), (-r.k_2, 0, 0, of.z), (r.k_2, 0, 0, of.y))
    assert of.lambda_n
    for table in (damped, pressed):
        assert all(value == 0 or 2 * k + 3 * m - 6 >= order for (k, m), value in table.items())


@pytest.mark.parametrize("regularisation", OTHERS, ids=str)
@pytest.mark.parametrize("chi", [0, "2/3"])
def test_every_law_of_the_expansion(regularisation: Regularisation, chi: int | str) -> None:
    """Both routes, the residual, the spaces of Theorem 1."""
    check_expansion(with_springs(regularisation, chi), 9)


def test_the_constants_change_the_terms() -> None:
    papers = time_series(extended_example(1), 9)
    for regularisation in OTHERS:
        assert time_series(with_springs(regularisation, 1), 9) != papers
    assert time_series(with_springs(PAPER, 1), 9) == papers


def test_the_model_system_in_closed_form() -> None:
    """alpha constant: lambda is alpha_2/(alpha_3 - alpha_1) = 2, z = -lambda/k_1, y = -(1/k_1 + 1/k_2) lambda."""
    found = time_series(with_springs(Regularisation.of(4, "2/3", 7), 0), 9)
    assert found.lambda_n == {(0, 0): fmpq(2)}
    assert found.z == {(0, 2): fmpq(-1, 2)}
    assert found.y == {(0, 2): fmpq(-7, 2)}


def test_the_leading_order_holds_the_compliance_alone() -> None:
    """Equal 1/k_1 + 1/k_2: the same b, y and lambda up to the first term with the damper."""
    first, second = (with_springs(Regularisation.of(*values)) for values in (("3/2", 3, 5), (2, 2, "1/9")))
    assert Regularisation.of("3/2", 3, 5).compliance == Regularisation.of(2, 2, "1/9").compliance
    a, b = (expand_system(system, 12) for system in (first, second))
    assert [term.coefficients() for term in a.b[:5]] == [term.coefficients() for term in b.b[:5]]
    assert [term.coefficients() for term in a.b] != [term.coefficients() for term in b.b]


@pytest.mark.parametrize("values", [(0, 1, 1), (1, -1, 1), (1, 1, "-1/9")])
def test_constants_that_are_refused(values: tuple[int | str, ...]) -> None:
    with pytest.raises(ValueError, match="needs k_1 > 0, k_2 > 0, c >= 0"):
        Regularisation.of(*values)
    with pytest.raises((TypeError, ValueError)):
        Regularisation.of(1.5, 1, 1)  # type: ignore[arg-type]
