"""The Airy form at β = 1/2, in numbers: a solution, and smaller than (-τ)^(1/2).

Page: proofs/oscillating_solutions.md.
"""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from gspot_verified.numbers.balls import working_bits
from gspot_verified.paper.section_4 import section_4_oscillating as ledger


def airy_form(tau: arb) -> arb:
    c = (arb(1) / 4).root(3)
    ai, ai_slope, bi, bi_slope = (c * tau).airy()
    return tau * ai * bi - 4 * c**2 * ai_slope * bi_slope


@pytest.mark.parametrize("x", [10, 40, 160, 640, 10000])
def test_the_airy_form_is_of_order_one_over_x(x: int) -> None:
    with working_bits(300):
        value = airy_form(arb(-x))
        assert value.is_finite()
        assert abs(value) * x < arb("0.3")


def test_the_airy_form_solves_the_equation_and_is_not_zero() -> None:
    with working_bits(400):
        step, tau = arb(2) ** -40, arb(fmpq(-7, 3))
        at = {k: airy_form(tau + k * step) for k in range(-2, 3)}
        first = (at[1] - at[-1]) / (2 * step)
        third = (at[2] - 2 * at[1] + 2 * at[-1] - at[-2]) / (2 * step**3)
        residual = third - tau * first + at[0] / 2
        assert residual.is_finite()
        assert abs(residual) < arb(2) ** -70
        assert abs(at[0]) > arb("0.001")


def test_the_identities_hold_and_need_the_constant() -> None:
    assert ledger.airy_solves()
    assert ledger.airy_leading_term_cancels()
    assert ledger.smaller_than_the_power()
    assert not ledger.modulo_constant(ledger.ALGEBRA.read("4*c^3 - 2")).is_zero()
    assert ledger.modulo_constant(ledger.ALGEBRA.read("8*c^4*u + c^2")) == ledger.ALGEBRA.read("2*c*u + c^2")


def test_the_steps_on_what_determines_theta(monkeypatch: pytest.MonkeyPatch) -> None:
    """Section 2 of the page: the corrected form of the entry."""
    assert ledger.next_term_is_smaller()
    assert ledger.parts_of_the_determinant()
    assert ledger.sines_do_not_cancel()
    with monkeypatch.context() as patch:
        patch.setitem(ledger.POWERS, "oscillating", "-beta/2 - 9/4")  # one term more would be needed
        assert not ledger.next_term_is_smaller()
    with monkeypatch.context() as patch:
        patch.setitem(ledger.SMALL, "real 2", "1")
        assert not ledger.parts_of_the_determinant()
    monkeypatch.setattr(ledger, "SINES", ("sine", *ledger.SINES[1:]))
    assert not ledger.sines_do_not_cancel()
    entry = ledger.ENTRIES["4-behaves-like"]()
    assert entry.checks[0].agrees is None
    assert entry.corrected.startswith("for β > -1/2 not an integer")


@pytest.mark.parametrize("beta", [fmpq(1, 2), fmpq(7, 5), fmpq(-1, 3), fmpq(10, 3)])
def test_the_determinant_of_the_page(beta: fmpq) -> None:
    with working_bits(200):
        root, three = arb(3).sqrt(), arb(3).root(3)
        gamma = [arb((3 - j + beta) / 3).gamma() for j in range(3)]
        outer = [arb((j - beta) / 3).rgamma() for j in range(3)]
        rows = [
            [3 * gamma[0], 6 * outer[0], arb(0)],
            [-(three**2) * gamma[1], -(three**2) * outer[1], three**2 * root * outer[1]],
            [three * gamma[2], -three * outer[2], -three * root * outer[2]],
        ]
        (a, b, c), (d, e, f), (g, h, i) = rows
        determinant = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
        product = outer[0] * outer[1] * outer[2]
        stated = -54 * root * arb.pi() * product / (arb.pi() * arb(beta)).sin()
        assert stated.is_finite()
        assert not stated.contains(0)
        assert abs(determinant - stated) < arb("1e-40")
