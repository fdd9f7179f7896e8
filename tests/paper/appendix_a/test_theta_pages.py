"""The steps of the pages on Θ notice another statement of the page.

Pages: proofs/connection.md, proofs/initial_values.md, proofs/laplace.md, proofs/negative.md, proofs/positive.md.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from flint import acb, arb, fmpq, fmpq_poly

from gspot_verified.numbers.balls import working_bits
from gspot_verified.paper.appendix_a import theta_pages as ledger
from gspot_verified.paper.checks.formulas import evaluate_text
from gspot_verified.paper.checks.page import Page
from gspot_verified.theta_function.gamma.initial_values import initial_values
from gspot_verified.theta_function.value.evaluate import evaluate

PAGES = {name: page for name, page in vars(ledger).items() if isinstance(page, Page)}
BETAS = (fmpq(-7, 3), fmpq(1, 2), fmpq(22, 5))


@pytest.mark.parametrize("name", list(PAGES))
def test_every_step_holds(name: str) -> None:
    assert all(step() is True for step in PAGES[name].steps)


def doubled(text: str) -> str:
    return f"2*({text})"


def from_another_start(k: int) -> fmpq_poly:
    """c_k of a solution of the recurrence of proofs/asymptotic_coefficients.md from k = 2 on, with g_0 = 1, g_1 = 0."""
    beta, g = fmpq_poly([0, 1]), [fmpq_poly([1]), fmpq_poly([0])]
    for n in range(2, k + 1):
        m, below = (-beta / 3 - fmpq(1, 2) - n + shift for shift in (1, 2))
        first, second = (27 * m**2 - 9 * m - 1) / 4, 3 * below * (3 * below - 2) * (3 * below - 4) / 8
        g.append((first * g[n - 1] + second * g[n - 2]) / (3 * n))
    return g[k] * fmpq(2, 3) ** k


def at_another_beta(text: str) -> str:
    return text.replace("beta", "(beta+1)")


@pytest.mark.parametrize(
    ("name", "change", "step"),
    [
        ("MOMENT", doubled, "moments_obey_the_equation"),
        ("MOMENT", lambda text: f"(1+k)*({text})", "moments_obey_the_equation"),
        ("MOMENT", at_another_beta, "moments_obey_the_equation"),
        ("MOMENT", lambda text: f"3*({text})*(1+beta)", "moments_move_with_beta"),
        ("POWER", doubled, "powers_solve_the_equation"),
        ("POWER", lambda text: f"(1+k)*({text})", "powers_solve_the_equation"),
        ("POWER", lambda text: f"(1+beta)*({text})", "powers_move_with_beta"),
        ("INTEGER_POLYNOMIAL", doubled, "polynomial_solves_the_equation"),
        ("INTEGER_POLYNOMIAL", lambda text: f"(1+m)*({text})", "polynomial_solves_the_equation"),
        ("SADDLE", lambda text: f"tau*{text}", "saddle_has_the_exponents_of_the_equation"),
        ("SADDLE", lambda text: text.replace("2*lam/3", "lam/3"), "saddle_has_the_exponents_of_the_equation"),
        ("SADDLE", lambda text: text.replace("-3*k/2", "-k"), "saddle_has_the_exponents_of_the_equation"),
        (
            "_orders",
            lambda orders: lambda: orders() | {3: ledger._ALGEBRA.constant(1)},
            "saddle_has_the_exponents_of_the_equation",
        ),
        ("coefficient_by_inversion", lambda _: from_another_start, "saddle_obeys_the_recurrence"),
        ("coefficient_by_inversion", lambda c: lambda k: c(k) + (k == 7), "saddle_obeys_the_recurrence"),
        ("coefficient_by_inversion", lambda c: lambda k: c(k) * 2**k, "saddle_obeys_the_recurrence"),
    ],
)
def test_another_statement_is_noticed(
    monkeypatch: pytest.MonkeyPatch, name: str, change: Callable[[Any], Any], step: str
) -> None:
    monkeypatch.setattr(ledger, name, change(getattr(ledger, name)))
    assert getattr(ledger, step)() is False


def test_an_equation_with_another_term_has_other_orders() -> None:
    orders = ledger._orders()
    assert sorted(orders) == [0, 1, 2]
    # proofs/asymptotic_coefficients.md: A_0 and A_1 at m = 2 and β = 0.
    values = {k: value.leading_coefficient() for k, value in orders.items()}
    assert values[0] == fmpq(27, 8)
    at_two = {k: ledger._ALGEBRA.substitute(v, {"m": ledger._ALGEBRA.constant(2)}) for k, v in orders.items()}
    assert at_two[0] == ledger._ALGEBRA.constant(fmpq(6 * 4 * 2, 8))
    assert at_two[1] == ledger._ALGEBRA.constant(fmpq(27 * 4 - 18 - 1, 4))


@pytest.mark.parametrize("beta", BETAS)
def test_the_moments_are_the_derivatives_at_0(beta: fmpq) -> None:
    for k, value in enumerate(initial_values(beta, 128)):
        found = evaluate_text(ledger.MOMENT, {"k": fmpq(k), "beta": beta}, 128).real
        assert found.is_finite()
        assert found.overlaps(value)


@pytest.mark.parametrize("beta", BETAS)
def test_the_powers_enclose_the_function(beta: fmpq) -> None:
    values: dict[str, fmpq | arb | acb] = {"x": fmpq(20), "beta": beta}
    terms = [evaluate_text(ledger.POWER, {**values, "k": fmpq(k)}, 128).real for k in range(5)]
    with working_bits(128):
        error = abs(evaluate(-20, beta, digits=25).value - sum(terms[:4], arb(0)))
        assert error < abs(terms[4]) * fmpq(1001, 1000)
