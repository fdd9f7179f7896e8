"""The real part of the oscillation's rate, and units of polynomials."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
from flint import arb, fmpq

from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.section_6 import section_6_relaxation as ledger
from gspot_verified.paper.section_6 import section_6_runs
from gspot_verified.paper.section_6.oscillator import ALGEBRA


@pytest.mark.parametrize("p", ["1/100", "1/16", "1/4", "1/2"])
def test_the_real_part(p: str) -> None:
    value = fmpq(*map(int, p.split("/")))
    found = ledger.real_part(arb(value))
    roots = np.roots([1, 2, float(value.p) / float(value.q), float(value.p) / float(value.q)])
    pair = [root.real for root in roots if abs(root.imag) > 1e-9]
    assert found is not None
    assert found.is_finite()
    assert all(abs(found.mid() - arb(real)) < found.rad() + 1e-9 for real in pair)
    assert found.rad() < arb(value) ** 3 / 500


def test_p_of_the_starts() -> None:
    """It is the rational number at which all roots are looked at, to its four decimals."""
    p = ledger.first_p()
    assert p.is_finite()
    assert p.rad() < 1e-20
    assert abs(p - arb(ledger.NEAR_P)) < 5e-5


def test_no_rate_without_a_sign_change() -> None:
    assert ledger.real_part(arb(0)) is None
    assert ledger.relaxation(None) is None
    assert ledger.relaxation(arb(1)) is None


@pytest.mark.parametrize(("value", "answer"), [("0.0009", True), ("0.0007", False), ("0.002", False)])
def test_about(value: str, answer: bool) -> None:
    assert ledger.lies_in(arb(value), ledger.ABOUT) is answer
    assert ledger.lies_in(arb("0.001", "0.0001"), ledger.ABOUT) is None


@pytest.mark.parametrize(
    ("second", "end", "outcome", "answer"),
    [
        (arb("0.14"), "G-spot", Outcome.PROVED, True),
        (arb("0.16"), "G-spot", Outcome.PROVED, False),
        (arb("0.15", "0.01"), "G-spot", Outcome.PROVED, None),
        (None, "G-spot", Outcome.PROVED, None),
        (arb("0.14"), "slip stops", Outcome.PROVED, None),
        (arb("0.14"), "G-spot", Outcome.UNDECIDED, None),
    ],
)
def test_both_starts_slip_for_a_tenth(
    monkeypatch: pytest.MonkeyPatch, second: arb | None, end: str, outcome: Outcome, answer: bool | None
) -> None:
    def path(name: str) -> SimpleNamespace:
        other = name == "6-second-start"
        verdict = SimpleNamespace(outcome=outcome if other else Outcome.PROVED)
        return SimpleNamespace(verdict=verdict, end=end if other else "G-spot", time=second if other else arb("0.11"))

    monkeypatch.setattr(section_6_runs, "slip", path)
    assert ledger.slips_for_a_tenth() is answer


def test_units_of_a_polynomial() -> None:
    assert ledger.has_unit(ALGEBRA.read("m1*l^2*om + 3*cphi"), (2, 1, 1))
    assert not ledger.has_unit(ALGEBRA.read("m1*l^2*om + m1*l"), (2, 1, 1))
    assert ledger.has_unit(ALGEBRA.constant(0), (5, 5, 5))
