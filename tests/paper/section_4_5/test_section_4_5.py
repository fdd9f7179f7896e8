"""Section 4.5 of the ledger: the forms are what the reader sees, and a check that cannot tell says so.

Pages: proofs/side_switching.md, proofs/signs.md.
"""

from __future__ import annotations

from typing import Any

import pytest
from flint import fmpq
from paper.bite import answers_with

from gspot_verified import Outcome
from gspot_verified.paper.checks import gamma_cells
from gspot_verified.paper.checks.closed_forms import rational
from gspot_verified.paper.checks.entry import Entry, Rung
from gspot_verified.paper.checks.formulas import closed_form
from gspot_verified.paper.section_4_5 import cases, lift_off, section_4_5, section_4_5_signs
from gspot_verified.paper.section_4_5 import section_4_5 as ledger
from gspot_verified.signs.cover.sign import sign as sign_on_ranges
from gspot_verified.signs.gamma.side import gamma_sign_by_ball


def entry(identifier: str) -> Entry:
    return {**section_4_5.ENTRIES, **cases.ENTRIES}[identifier]()


def test_the_corrected_form_that_is_shown_is_the_one_that_is_checked(monkeypatch: pytest.MonkeyPatch) -> None:
    assert entry("S-mean-force").corrected.startswith("α_2/(α_3-α_1)")
    monkeypatch.setitem(section_4_5.CORRECTED["S-mean-force"], "force", "alpha2/(alpha1-alpha3)")
    wrong = entry("S-mean-force")
    assert wrong.corrected.startswith("α_2/(α_1-α_3)")
    assert wrong.verdict.outcome is Outcome.UNDECIDED


def test_a_factor_that_is_1_at_nine_points_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    factor = "(1+(beta-2)*(beta-4)*(beta-5)*(2*beta-1)*(2*beta-3)*(3*beta-7))"
    force = section_4_5.PRINTED["S-deviation-force"]
    monkeypatch.setitem(force, "force", f"{factor}*({force['force']})")
    failures = [check for check in entry("S-deviation-force").checks if check.agrees is False]
    assert [check.rung for check in failures] == [Rung.EXACT, Rung.EXACT]


def test_a_ball_that_cannot_tell_refutes_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(section_4_5_signs, "gamma_sign_by_ball", lambda *_: None)
    assert entry("S-gamma-intervals").verdict.outcome is Outcome.UNDECIDED


def test_a_cover_without_budget_proves_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    without_budget = sign_on_ranges("-inf..inf", "0..1", budget=0)
    monkeypatch.setattr(cases, "sign_on_ranges", lambda *_: without_budget)
    assert entry("S-iwc").verdict.outcome is Outcome.UNDECIDED


def test_threshold_of_the_sign_at_minus_infinity() -> None:
    # beta = 3/2: b = 1/2, N = 1, |(-b)_3|/3 = (1/2)(1/2)(3/2)/3 = 1/8, so T = 1 serves.
    assert section_4_5_signs._threshold(fmpq(3, 2)) == 1
    assert section_4_5_signs._threshold(fmpq(1, 2)) == 1


def test_brackets_need_a_certain_change_of_sign() -> None:
    bracket = lift_off._bracket(fmpq(99, 2), 10, None)
    assert not bracket.closer_than_before


def test_five_values_of_beta_are_points() -> None:
    rungs = {identifier: {c.rung for c in entry(identifier).checks} for identifier in ("S-iwc-case-III", "S-switching")}
    assert rungs == {"S-iwc-case-III": {Rung.PAGE, Rung.POINTS}, "S-switching": {Rung.EXACT, Rung.POINTS}}


@pytest.mark.parametrize("m", range(-1, 12))
def test_sign_of_gamma_on_a_cell(m: int) -> None:
    sign = gamma_cells.sign_on_cell(rational(m)).sign()
    assert sign == gamma_sign_by_ball(m + fmpq(1, 3)) == gamma_sign_by_ball(m + fmpq(2, 3))


def test_intervals_that_are_not_cells() -> None:
    lower = closed_form("2*n-2")
    found = [gamma_cells.is_cell(lower, closed_form(upper)) for upper in ("2*n-1", "2*n", "n", "2*n-3/2")]
    assert [form.factor.constant() for form in found] == [1, -1, 0, 0]


# The force at leading order: what its checks at points must refuse, and what they are asked for.


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


def test_a_ball_of_the_force_that_cannot_tell_refutes_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
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
