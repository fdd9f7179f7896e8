"""Sentences of Sec. 6: the belt, the damper, the Cases, with other values beside the printed ones."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from flint import fmpq_mpoly

from gspot_verified.paper.section_6 import section_6_sentences as ledger

RATES = (ledger.by_the_place, ledger.by_the_friction)


@pytest.mark.parametrize("rate", RATES)
@pytest.mark.parametrize(
    ("name", "belt", "spot", "starts"),
    [
        ("moving", "-3/5*l*om - lam", True, True),
        ("moving", "-3/5*l*om + lam", False, None),  # slower: it slips backwards at the G-spot
        ("moving", "-1/2*l*om - lam", None, True),  # which lam is not known
        ("moving", "-2/5*l*om - lam", None, None),
        ("moving", "-1/4*l*om", False, False),
        ("moving", "-2/5*l*om", False, None),
        ("at rest", "0*l", True, True),
        ("at rest", "-l*om", False, False),
        ("at rest", "-1/2*l*om", True, False),
    ],
)
def test_belts(
    monkeypatch: pytest.MonkeyPatch,
    rate: Callable[[], fmpq_mpoly],
    name: str,
    belt: str,
    spot: bool | None,
    starts: bool | None,
) -> None:
    monkeypatch.setitem(ledger.BELT, name, belt)
    assert ledger.slips_at_the_g_spot(rate(), name) is spot
    assert ledger.slips_at_the_starts(rate(), name) is starts


@pytest.mark.parametrize(
    ("side", "betas", "answer"),
    [
        ("below", "18/7 - lam", True),
        ("below", "18/7 + lam", False),
        ("below", "lam", False),
        ("above", "18/7 + lam", True),
        ("above", "17/7 + lam", False),
    ],
)
def test_the_damper_below_and_above(monkeypatch: pytest.MonkeyPatch, side: str, betas: str, answer: bool) -> None:
    monkeypatch.setitem(ledger.BETAS, side, betas)
    assert ledger.damps_up_to_the_highest() is answer


@pytest.mark.parametrize(
    ("constant", "answer"),
    [("18 - 7*beta", True), ("17 - 7*beta", False), ("18 - 49/18*beta^2", False), ("7*beta - 18", False)],
)
def test_the_damper_falls_through_zero(monkeypatch: pytest.MonkeyPatch, constant: str, answer: bool) -> None:
    monkeypatch.setitem(ledger.oscillator.PARAMETERS, "cpsi", constant)
    assert ledger.falls_through_zero() is answer


def test_cases() -> None:
    assert ledger.has_a_case() is True
    assert ledger.has_a_case_by_its_coefficients() is True


@pytest.mark.parametrize(("name", "wrong"), [("alpha_1", "beta"), ("alpha_3", "-1 - beta"), ("alpha_3", "beta - 3")])
def test_a_case_asks_for_the_signs_and_the_ratio(monkeypatch: pytest.MonkeyPatch, name: str, wrong: str) -> None:
    monkeypatch.setitem(ledger.section_6_runs.ALPHAS, name, wrong)
    assert ledger.has_a_case() is False
    assert ledger.has_a_case_by_its_coefficients() is False


@pytest.mark.parametrize(
    ("part", "number"),
    [
        ("damps_up_to_the_highest", 0),
        ("has_a_case", 0),
        ("falls_through_zero", 1),
        ("has_a_case_by_its_coefficients", 1),
    ],
)
def test_each_check_on_beta_asks_for_the_damper_and_a_case(
    monkeypatch: pytest.MonkeyPatch, part: str, number: int
) -> None:
    assert [check.agrees for check in ledger.ENTRIES["6-any-beta"]().checks] == [True, True]
    monkeypatch.setattr(ledger, part, lambda: False)
    assert ledger.ENTRIES["6-any-beta"]().checks[number].agrees is False


@pytest.mark.parametrize(
    ("alpha_2", "answer"),
    [
        ("beta^2 - 7", True),
        ("beta^2 - 6", False),  # 18/7 squared is 6.6
        ("beta^2 - beta", False),
        ("3 - beta^2", False),
        ("-beta^2 - 1", False),  # negative, but not seen by its ends
    ],
)
def test_alpha_2_is_negative_up_to_the_highest(monkeypatch: pytest.MonkeyPatch, alpha_2: str, answer: bool) -> None:
    monkeypatch.setitem(ledger.section_6_runs.ALPHAS, "alpha_2", f"{alpha_2} + kappa")
    assert ledger.has_a_case() is answer
    assert ledger.has_a_case_by_its_coefficients() is (answer or alpha_2 == "-beta^2 - 1")
