"""Formulas along the solutions of the system: what is multiplied, and what is left out for the deviations."""

from __future__ import annotations

import pytest

from gspot_verified.paper.section_4.section_4_outer import ALGEBRA, along, field

FORCE = "alpha3*(z-y)"


@pytest.mark.parametrize(("free", "drift"), [(True, "alpha2"), (False, "0*t")])
def test_along_the_solutions(free: bool, drift: str) -> None:
    assert along(ALGEBRA.read("alpha2 - t*b1"), "b", free) == ALGEBRA.read(
        f"epsilon^4*(alpha2 - t*({drift} - {FORCE}))"
    )
    assert along(ALGEBRA.read("alpha2 - t*f1"), "f", free) == ALGEBRA.read(f"alpha2 - t*epsilon*({drift} - {FORCE})")
    assert along(ALGEBRA.read("f0"), "f", free) == along(ALGEBRA.read("g0"), "g", free) == ALGEBRA.read("b0")
    # b'' = -alpha3 (z' - y') with epsilon z' = -z - (z - y) and epsilon y' = v
    assert along(ALGEBRA.read("b2"), "b", free) == ALGEBRA.read("-epsilon^3*alpha3*(-2*z+y-v)")


def test_the_rate_of_the_middle_point() -> None:
    assert field(True)["v"] == field(False)["v"] == ALGEBRA.read("b0 + alpha1*t*(z-y)")
