"""The force at leading order: what its checks at points must refuse, and what they are asked for."""

from __future__ import annotations

from typing import Any

import pytest
from flint import fmpq
from paper.bite import answers_with

from gspot_verified.paper.checks.closed_forms import rational
from gspot_verified.paper.section_4_5 import section_4_5 as ledger

BETAS = (fmpq(1, 2), fmpq(3, 2), fmpq(7, 3))
FORCE = ledger.PRINTED["S-deviation-force"]["force"]


@pytest.mark.parametrize("beta", BETAS)
@pytest.mark.parametrize("factor", ["1", "(1+10^(-11))", "(1-10^(-11))", "(-1)"])
def test_a_difference_quotient_notices_a_small_factor(monkeypatch: pytest.MonkeyPatch, beta: fmpq, factor: str) -> None:
    monkeypatch.setitem(ledger.PRINTED, "S-deviation-force", {"force": f"{factor}*({FORCE})"})
    assert ledger._difference_quotient(beta) is (factor == "1")


def test_every_stated_beta_is_tried(monkeypatch: pytest.MonkeyPatch) -> None:
    for wrong in BETAS:
        answers = answers_with(
            ledger, "_difference_quotient", lambda beta, wrong=wrong: beta != wrong, ledger.ENTRIES["S-deviation-force"]
        )
        assert answers == [True, True, False]
    tried: list[Any] = []
    monkeypatch.setattr(ledger, "_is_large", tried.append)
    assert ledger.ENTRIES["S-dominance"]().checks[2].agrees is None
    assert set(tried) == {fmpq(n, 10) for n in range(1, 130) if n != 10}


@pytest.mark.parametrize(
    ("exponent", "beta", "answer"),
    [
        ("beta-1", fmpq(1, 2), True),
        ("beta-1", fmpq(3, 2), True),
        ("1-beta", fmpq(1, 2), False),
        ("1-beta", fmpq(3, 2), False),
        ("-1/40+0*beta", fmpq(1, 2), True),  # 10^(6/40) = 1.41...
        ("0*beta", fmpq(3, 2), True),  # exactly 1 is not above 1
        ("0*beta", fmpq(1, 2), False),
        ("-1+0*beta", fmpq(1), False),  # at 1 no size is stated
    ],
)
def test_what_is_large(monkeypatch: pytest.MonkeyPatch, exponent: str, beta: fmpq, answer: bool) -> None:
    monkeypatch.setitem(ledger.PRINTED, "S-dominance", {"exponent": exponent})
    assert ledger._is_large(beta) is answer


def test_a_ball_that_cannot_tell_refutes_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ledger, "certainly_less", lambda *_: None)
    for beta in BETAS:
        assert ledger._is_large(beta) is None
        assert ledger._difference_quotient(beta) is None


def test_the_linear_time_is_needed() -> None:
    answers = answers_with(ledger, "_linear_in_time", lambda: rational(2), ledger.ENTRIES["S-deviation-force"])
    assert answers == [False, True, True]


def test_the_example_shows_both_forms() -> None:
    findings = [check.finding for check in ledger.ENTRIES["S-mean-force"]().checks]
    # At α = (-1, -1, -3/2): b = c α_1 t with c = -2, so α_3 λ = α_2 - 2 = -3 gives λ = 2.
    assert all(text.endswith("the equations give 2, the printed form -2") for text in findings)


def test_the_size_is_tried_at_the_stated_epsilon(monkeypatch: pytest.MonkeyPatch) -> None:
    honest, tried = ledger.evaluate_text, []

    def recorded(text: str, values: Any, bits: int) -> Any:
        tried.append(values["epsilon"])
        return honest(text, values, bits)

    monkeypatch.setattr(ledger, "evaluate_text", recorded)
    ledger._is_large(fmpq(1, 2))
    assert tried == [fmpq(1, 10**6)]
