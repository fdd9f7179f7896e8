"""The model system of Section 2 at functions of time that do not solve it: what each equation leaves."""

from __future__ import annotations

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
