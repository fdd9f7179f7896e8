"""Section 6 and Appendix B: the borders of the cases, the rounding, and that both routes see each part."""

from __future__ import annotations

import pytest
from flint import fmpq
from paper.bite import answers_with

from gspot_verified.paper.numerics.oscillator_formulas import APPENDIX_B, PRINTED_NUMBERS
from gspot_verified.paper.section_6 import section_6 as ledger
from gspot_verified.paper.section_6.oscillator import PRINTED

HALF = fmpq(1, 2)


@pytest.mark.parametrize("alphas", [(-1, 0, -3), (-1, HALF, -3), (0, -1, -3), (HALF, -1, -3), (-1, -1, -1)])
def test_borders_are_not_in_case_iii(alphas: tuple[fmpq, fmpq, fmpq]) -> None:
    assert not ledger.in_case_iii(*map(fmpq, alphas))


@pytest.mark.parametrize(
    "alphas",
    [
        (0, -1, -3),  # an eigenvalue that is 0
        (HALF, -1, -3),
        (-1, 0, -3),  # no force
        (-3, 2, -1),  # the line is the strong direction
        (-1, -1, -1),  # there is no such line
    ],
)
def test_borders_are_not_approached_with_a_finite_force(alphas: tuple[fmpq, fmpq, fmpq]) -> None:
    assert not ledger.approached_with_finite_force(*map(fmpq, alphas))


def test_a_printed_decimal_and_half_its_last_digit() -> None:
    assert ledger.decimal("-0.4289") == (fmpq(-4289, 10**4), fmpq(1, 2 * 10**4))
    assert ledger.decimal("7") == (fmpq(7), HALF)


def test_the_number_of_nothing_is_zero() -> None:
    assert ledger._number(ledger.ALGEBRA.constant(0)) == 0
    assert ledger._number(ledger.ALGEBRA.read("3*m1*l - beta")) == fmpq(2, 3)


@pytest.mark.parametrize("name", PRINTED_NUMBERS)
def test_both_routes_round_each_value(name: str) -> None:
    value, half = ledger.decimal(PRINTED_NUMBERS[name])
    wrong = PRINTED_NUMBERS | {name: f"{float(value + 2 * half):.4f}"}
    assert answers_with(ledger, "PRINTED_NUMBERS", wrong, ledger.ENTRIES["6-decimals"]) == [False, False]


@pytest.mark.parametrize(("condition", "place"), [("in_case_iii", 0), ("approached_with_finite_force", 1)])
def test_each_route_asks_for_the_case(condition: str, place: int) -> None:
    answers = answers_with(ledger, condition, lambda *_: False, ledger.ENTRIES["6-decimals"])
    assert answers == [k != place for k in range(2)]


@pytest.mark.parametrize("part", ["M11", "M22", "f1", "f2", "QT1", "QT2", "QN1", "QN2"])
def test_both_routes_see_each_part_of_the_motion(monkeypatch: pytest.MonkeyPatch, part: str) -> None:
    monkeypatch.setitem(PRINTED, "6-motion", PRINTED["6-motion"] | {part: f"{PRINTED['6-motion'][part]} + m1*l"})
    assert [check.agrees for check in ledger.ENTRIES["6-motion"]().checks] == [False, False]


def test_what_is_said_of_alpha_1_and_of_the_line_with_a_parenthesis_too_many() -> None:
    for name in ("alpha_1", "alpha_2", "alpha_3"):
        what = ledger.ENTRIES[f"6-{name}"]().checks[1].what
        assert what.startswith("the slope in φ" if name == "alpha_1" else "y''' under a constant force")
    for name in APPENDIX_B:
        entry = ledger.ENTRIES[f"B-{name}"]()
        assert entry.label == f"lines {APPENDIX_B[name][0]}"
        assert ("parenthesis" in entry.note) is (name == "alpha_2")
