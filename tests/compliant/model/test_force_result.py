"""What the text of a force says: its parts or that they are not known apart, all variables, what was not reached."""

from __future__ import annotations

from dataclasses import replace

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.model.force_result import CompliantForce
from gspot_verified.compliant.model.normal_form import compliant_model
from gspot_verified.numbers.verdict import Reason

FOUND = CompliantForce(
    compliant_model("5/2", "1/10", alpha_1=-2), fmpq(1, 4), *map(arb, (1, 2, 3, 4, 5, 6, 7)), False, 6, True
)


def test_the_text_holds_the_parts_and_all_variables() -> None:
    head, parts, *variables = str(FOUND).splitlines()
    assert head == "λ_N = 1.00000 at t = 1/4, p = -1/2"
    assert parts == "  slow part and mean force 6.00000, fast part = 7.0000"
    assert variables == ["  b = 2.00000", "  y = 3.00000", "  v = 4.00000", "  z = 5.00000"]


def test_the_text_says_how_the_fast_part_entered() -> None:
    assert "fast part bounded by 7.0000" in str(replace(FOUND, fast_by_bound=True))
    by_series = str(replace(FOUND, by_series=True)).splitlines()
    assert by_series[1] == "  by the power series about the initial state"
    assert len(by_series) == 6


def test_the_text_ends_with_what_was_not_reached() -> None:
    assert str(replace(FOUND, reached=False, reason=Reason.BUDGET)) == f"{FOUND}\n  {Reason.BUDGET.value}"


def test_it_has_no_truth_value() -> None:
    with pytest.raises(TypeError, match="reached"):
        bool(FOUND)
