"""Cases I, II and III in rigid slip, and the strong direction: what each step must refuse."""

from __future__ import annotations

from typing import Any

import pytest
from flint import fmpq_mpoly

from gspot_verified.paper.section_1 import section_1_cases as ledger
from gspot_verified.paper.section_1 import section_1_outcomes
from gspot_verified.paper.section_3 import section_3_sentences
from gspot_verified.paper.section_4 import section_4_trivial
from gspot_verified.paper.section_4_5 import cases, strong_direction

STEPS = (ledger.solves, ledger.stays_and_ends, ledger.force_moves)
RATES = {"p": "alpha1*p", "b": "alpha2*p + alpha3*b"}


def read(text: str) -> fmpq_mpoly:
    return ledger.ALGEBRA.read(text)


@pytest.mark.parametrize(
    ("case", "images"),
    [
        ("1-case-I", section_4_trivial.CASE_I),
        ("1-case-II", section_4_trivial.IN_CONTACT["II"]),
        ("1-case-III", section_4_trivial.IN_CONTACT["III"]),
        ("1-case-II", section_3_sentences.CASE_II_SIGNS),
        ("1-case-III", cases.CASE_III),
    ],
)
def test_a_case_has_the_same_signs_and_order_wherever_it_is_written(case: str, images: dict[str, str]) -> None:
    """u, w, ... are positive: other letters for them change no sign."""
    letters = str.maketrans({"x": "m", "y": "m"})
    here = {f"alpha{n}": (images.get(f"alpha{n}") or images[f"alpha_{n}"]).translate(letters) for n in (1, 2, 3)}
    assert section_1_outcomes.ordered(here) == section_1_outcomes.ordered(ledger.CASES[case]) is not None


def test_beta_of_case_iii_is_the_ratio_of_its_rates() -> None:
    case = {name: read(text) for name, text in cases.CASE_III.items() if name in ("beta", "alpha1", "alpha3")}
    assert case["beta"] * case["alpha1"] == case["alpha3"]


@pytest.mark.parametrize("name", ledger.CASES)
def test_every_step_holds_in_every_case(name: str) -> None:
    assert [step(name) for step in STEPS] == [True, True, True]
    assert ledger.reaches(ledger.CASES[name]) is True
    assert ledger.is_stable(name) is True


@pytest.mark.parametrize("name", ledger.CASES)
@pytest.mark.parametrize(
    ("rates", "solves", "moves"),
    [
        ({"p": "2*alpha1*p"}, False, False),
        ({"b": "alpha2*p + alpha3*b + (b-c*p)"}, False, False),  # the same on the line b = c p alone
        ({"b": "2*alpha2*p + alpha3*b"}, False, False),
    ],
)
def test_other_equations(
    monkeypatch: pytest.MonkeyPatch, name: str, rates: dict[str, str], solves: bool, moves: bool
) -> None:
    monkeypatch.setattr(ledger, "RATES", RATES | rates)
    assert ledger.solves(name) is solves
    assert ledger.force_moves(name) is moves


@pytest.mark.parametrize(
    ("name", "case", "start", "steps"),
    [
        ("1-case-I", {"alpha2": "m"}, None, [True, False, False]),
        ("1-case-I", {"alpha1": "u-w"}, None, [False, False, False]),
        ("1-case-I", {}, "n*u", [True, False, True]),
        ("1-case-II", {"alpha2": "2*m"}, None, [True, False, False]),
        ("1-case-II", {}, "-n*u", [True, False, False]),
        ("1-case-II", {}, "-m*q", [True, False, False]),  # on the line itself
        ("1-case-III", {"alpha2": "m"}, None, [True, False, False]),
        ("1-case-III", {"alpha2": "-2*m"}, None, [True, True, False]),
        ("1-case-III", {"alpha3": "u-w"}, None, [False, False, False]),
        ("1-case-III", {"alpha3": "-2*u-w"}, None, [True, False, False]),  # u is |α_3 - α_1|
        ("1-case-III", {}, "n*u", [True, False, True]),
    ],
)
def test_other_signs(
    monkeypatch: pytest.MonkeyPatch, name: str, case: dict[str, str], start: str | None, steps: list[bool]
) -> None:
    monkeypatch.setitem(ledger.CASES, name, {**ledger.CASES[name], **case})
    monkeypatch.setitem(ledger.START, name, start or ledger.START[name])
    assert [step(name) for step in STEPS] == steps


@pytest.mark.parametrize(
    ("alpha1", "alpha3", "answer"),
    [
        ("-w", "-u", True),
        ("w", "-u", False),
        ("-w", "u", False),
        ("u-w", "-u", False),
        ("0*u", "-u", False),
        ("-w", "0*u", False),
        ("w", "u", False),  # the determinant is positive
    ],
)
def test_the_g_spot_is_reached_for_two_negative_rates_only(
    monkeypatch: pytest.MonkeyPatch, alpha1: str, alpha3: str, answer: bool
) -> None:
    assert ledger.reaches({"alpha1": alpha1, "alpha3": alpha3}) is answer
    monkeypatch.setitem(ledger.CASES, "1-case-I", {"alpha1": alpha1, "alpha2": "-m", "alpha3": alpha3})
    assert ledger.is_stable("1-case-I") is answer


@pytest.mark.parametrize(
    ("name", "top", "bottom", "answer"),
    [
        ("1-case-I", "1+x", "1+0*x", True),
        ("1-case-I", "1+x", "-1+0*x", False),
        ("1-case-I", "1-x", "1+0*x", False),
        ("1-case-I", "1+0*x", "1+0*x", False),  # a force that does not grow
        ("1-case-III", "n + m*q*x", "1+x", True),
        ("1-case-III", "n + m*q*x", "1-x", False),
        ("1-case-III", "n + m*q*x", "1+2*x", False),  # half the force in the end
        ("1-case-III", "n + 2*m*q*x", "1+x", False),
    ],
)
def test_a_force_that_stays_positive_and_ends_as_stated(
    monkeypatch: pytest.MonkeyPatch, name: str, top: str, bottom: str, answer: bool
) -> None:
    monkeypatch.setattr(ledger, "force_over_line", lambda _: (read(top), read(bottom)))
    assert ledger.stays_and_ends(name) is answer


def test_the_force_over_the_line_by_hand() -> None:
    """Case I: b/p = (c q + (b(0) - c q) E)/q with E = 1 + x, u c = m, u b(0) = -n u; Case III: E = 1/(1 + x)."""
    assert ledger.force_over_line("1-case-I") == (read("n*u + (n*u + m*q)*x"), read("1+0*x"))
    assert ledger.force_over_line("1-case-III") == (read("n*u + m*q*x"), read("1+x"))
    assert ledger.slope_of_the_force() == read("-alpha2*p^2 - alpha3*b*p + alpha1*b*p")


def answers(build: Any) -> list[bool | None]:
    return [check.agrees for check in build().checks]


@pytest.mark.parametrize("name", ledger.CASES)
def test_what_a_case_says(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    entry = ledger.ENTRIES[name]()
    assert ("infty" in entry.source) is ("∞" in entry.statement) is ledger.GROWS[name]
    assert bool(entry.note) is (name == "1-case-III")
    for step, found in (("reaches", [False, True]), ("is_stable", [True, False])):
        with monkeypatch.context() as patch:
            patch.setattr(ledger, step, lambda _: False)
            assert answers(ledger.ENTRIES[name]) == found


STRONG = strong_direction.ENTRIES["1-strong-stable"]


@pytest.mark.parametrize(
    ("direction", "rates", "found"),
    [
        ({}, {}, [True, True]),
        ({"b": "2*alpha2"}, {}, [None, None]),
        ({"p": "alpha1 - 2*alpha3"}, {}, [None, None]),
        ({"b": "0*alpha2"}, {}, [None, None]),
        ({}, {"b": "alpha2*p + 2*alpha3*b"}, [None, None]),
        ({}, {"p": "2*alpha1*p"}, [None, None]),
        ({}, {"p": "alpha1*p + b"}, [None, None]),
        ({}, {"p": "alpha3*p", "b": "alpha3*b"}, [None, True]),  # every line is then one of α_3
        ({"p": "0*p", "b": "0*p"}, {}, [None, None]),  # no direction
    ],
)
def test_both_routes_to_the_strong_direction_see_each_part(
    monkeypatch: pytest.MonkeyPatch, direction: dict[str, str], rates: dict[str, str], found: list[bool | None]
) -> None:
    monkeypatch.setattr(strong_direction, "DIRECTION", {**strong_direction.DIRECTION, **direction})
    monkeypatch.setattr(strong_direction, "RATES", RATES | rates)
    assert answers(STRONG) == found
