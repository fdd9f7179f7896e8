"""The states of Case II beyond the strong stable manifold: both proofs that they lift off see each part."""

from __future__ import annotations

import pytest

from gspot_verified.paper.section_1 import section_1_cases
from gspot_verified.paper.section_4_5 import strong_direction as ledger

BUILD = ledger.ENTRIES["1-case-II-beyond"]


def answers() -> list[bool | None]:
    return [check.agrees for check in BUILD().checks]


def test_states_with_c_1_positive_lift_off() -> None:
    assert answers() == [True, True]


@pytest.mark.parametrize(
    ("name", "value", "found"),
    [
        ("distance", "(alpha1 - alpha3)*b - alpha2*p", [None, None]),  # C_1 < 0: the G-spot is reached
        ("distance", "2*(alpha2*p - (alpha1 - alpha3)*b)", [None, None]),
        ("distance", "alpha2*p - alpha1*b", [None, None]),
        ("u K", "-n*u", [True, None]),
        ("u K", "0*n", [True, None]),  # on the line
    ],
)
def test_another_side(monkeypatch: pytest.MonkeyPatch, name: str, value: str, found: list[bool | None]) -> None:
    monkeypatch.setitem(ledger.BEYOND, name, value)
    assert answers() == found


@pytest.mark.parametrize(
    ("rates", "found"),
    [
        ({"p": "alpha1*p + b"}, [None, None]),
        ({"p": "2*alpha1*p"}, [None, None]),
        ({"b": "2*alpha2*p + alpha3*b"}, [None, None]),
        ({"b": "alpha2*p + 2*alpha3*b"}, [None, None]),
    ],
)
def test_other_equations(monkeypatch: pytest.MonkeyPatch, rates: dict[str, str], found: list[bool | None]) -> None:
    for module in (ledger, section_1_cases):
        monkeypatch.setattr(module, "RATES", {**module.RATES, **rates})
    assert answers() == found


@pytest.mark.parametrize(
    "case",
    [
        {"alpha1": "u-w"},  # the distance shrinks
        {"alpha1": "-w"},  # α_1 = α_3
        {"alpha1": "-2*u-w"},  # u is not α_3 - α_1
    ],
)
def test_other_signs(monkeypatch: pytest.MonkeyPatch, case: dict[str, str]) -> None:
    monkeypatch.setitem(section_1_cases.CASES, "1-case-II", {**section_1_cases.CASES["1-case-II"], **case})
    assert answers()[1] is None
    assert answers()[0] is (True if "2" in case["alpha1"] else None)


def test_p_that_comes_to_zero(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ledger, "RATES", {**section_1_cases.RATES, "p": "alpha1*p + alpha2"})
    assert answers() == [None, True]
