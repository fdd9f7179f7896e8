"""The extended example system: Lie derivatives by two routes, and relations that other fields satisfy or not."""

from __future__ import annotations

import pytest
from flint import fmpq_mpoly

from gspot_verified.paper.section_2 import lagrangian
from gspot_verified.paper.section_2.lagrangian import ALGEBRA, PRINTED, _Flow


def parts(**changed: str) -> dict[str, fmpq_mpoly]:
    texts = {**PRINTED["2-lagrangian"], **{name: text + "+0*x1" for name, text in changed.items()}}
    return {name: ALGEBRA.read(text) for name, text in texts.items()}


@pytest.mark.parametrize("text", ["x1", "alpha1*x2", "3*chi*x6^2*x4 - x3*x5 + 7", "x1*x2*x3*x4*x5*x6*kplus^2"])
def test_both_routes_to_a_lie_derivative(text: str) -> None:
    function, flow = ALGEBRA.read(text), _Flow(parts())
    for letter, field in (("F", flow.drift), ("N", flow.normal)):
        wanted = lagrangian._lie(function, lagrangian._field(flow.parts, letter))
        assert flow.equal(flow.along(function, field), wanted).is_zero()
        assert not flow.equal(flow.along(function, field), wanted + 1).is_zero()


def test_a_velocity_that_slip_changes_keeps_p() -> None:
    """μ = 0 and G_N = (0, 0, 0, 1, 1, 0): p = 1, and L_G(2 (1 - x5)) is not 0."""
    relations = lagrangian._relations(parts(mu="0", N2="0", N4="1", N5="1", N6="0"))
    assert relations[-1].is_zero()
    changed = lagrangian._relations(parts(mu="0", N2="0", N4="x5", N5="1", N6="0"))
    assert not changed[-1].is_zero()
