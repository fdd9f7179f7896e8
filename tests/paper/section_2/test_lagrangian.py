"""The extended example system: Lie derivatives by two routes, and relations that other fields satisfy or not."""

from __future__ import annotations

import pytest
from flint import fmpq, fmpq_mpoly

from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.section_2 import lagrangian
from gspot_verified.paper.section_2.lagrangian import ALGEBRA, PRINTED, _Flow
from gspot_verified.paper.section_3.impact_to_lift_off import scene_of
from gspot_verified.scenes.floats.float_run import float_run


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


@pytest.mark.parametrize("mu", ["x5", "1 - x5 - d", "1 - x5^2", "x5 - 1"])
def test_a_friction_that_is_not_that_of_the_statement(monkeypatch: pytest.MonkeyPatch, mu: str) -> None:
    """μ = 1 - p: positive exactly for p < 1."""
    monkeypatch.setitem(PRINTED["2-extended"], "mu", mu)
    assert lagrangian.ENTRIES["2-extended"]().verdict.outcome is not Outcome.PROVED


@pytest.mark.parametrize(("name", "text"), [("H2", "5"), ("N4", "(2+x5)/2"), ("N2", "1/3")])
def test_a_field_with_another_third_scalar(name: str, text: str) -> None:
    """AC - B² is 2 (1 - p) times less than ``THIRD``."""
    third = ALGEBRA.read(lagrangian.THIRD)
    assert (lagrangian._third(parts()) - third).is_zero()
    assert not (lagrangian._third(parts(**{name: text})) - third).is_zero()


def test_where_the_printed_fields_are_defined() -> None:
    """At p = 1 G_T has the denominator 0, and beyond it μ < 0; the run of Figure 9 with χ = 1 gets there in flight."""
    at_1 = {"x5": ALGEBRA.constant(1)}
    assert ALGEBRA.substitute(lagrangian._DENOMINATOR, at_1).is_zero()
    assert ALGEBRA.substitute(ALGEBRA.read(PRINTED["2-extended"]["mu"]), {"x5": ALGEBRA.constant(2)}) == -1
    entries = {name: build() for name, build in lagrangian.ENTRIES.items()}
    assert entries["2-extended"].statement.startswith("For p < 1, ")
    third = ALGEBRA.read(lagrangian.THIRD)
    for p, value in ((fmpq(-1), -1), (fmpq(-1, 2), 0), (fmpq(0), 1)):
        assert ALGEBRA.substitute(third, {"x5": ALGEBRA.constant(p)}) == value
    for name in ("2-lagrangian", "2-quantities", "2-extended"):
        assert "At ξ_5 = 1 the printed G_T is not defined." in entries[name].note
    highest = max(float_run(scene_of(fmpq(1, 4))).samples.columns["p"])
    assert highest > 2
