"""The model system of Section 2 at functions of time that do not solve it: what each equation leaves."""

from __future__ import annotations

import pytest

from gspot_verified.paper.section_4 import section_4_trivial as ledger
from gspot_verified.paper.section_4.section_4_outer import ALGEBRA, with_c


def test_each_equation_of_the_model_system_is_the_paper_s() -> None:
    values = {"p": "7+t", "b": "t^2", "y": "2*t^2", "v": "3*t", "z": "5*t^3"}
    force = "(5*t^3-2*t^2)"
    left = [
        "7",  # p(0)
        "1 - alpha1",
        f"epsilon^2*(2*t - alpha2) + alpha3*{force}",
        "4*t - 3*t",
        f"epsilon^2*(3 - t^2) - (7+t)*{force}",
        f"epsilon*15*t^2 + 5*t^3 + {force}",
    ]
    found = ledger.in_model_system({name: ALGEBRA.read(text) for name, text in values.items()})
    assert found == [with_c(ALGEBRA.read(text)) for text in left]


@pytest.mark.parametrize(
    ("table", "name", "text", "answers"),
    [
        ("2-trivial", "p", "-alpha1*t", [False, True]),
        ("2-trivial", "b", "-c*alpha1*t", [False, True]),
        ("2-trivial-zy", "z", "3*epsilon^2*c", [True, False]),
        ("2-trivial-zy", "y", "epsilon^2*c/2", [True, False]),
    ],
)
def test_each_route_to_the_trivial_signs_has_its_own_formulas(
    monkeypatch: pytest.MonkeyPatch, table: str, name: str, text: str, answers: list[bool]
) -> None:
    rows = ledger.PRINTED if table == "2-trivial" else ledger.CORRECTED
    monkeypatch.setitem(rows[table], name, text)
    assert [check.agrees for check in ledger.IN_CASE_I["3-case-I-trivial"]().checks] == answers
