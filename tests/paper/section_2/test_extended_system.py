"""The extended example: its fields are those of Sec. 2 in positive slip; a coefficient that is no polynomial."""

from __future__ import annotations

from typing import Any

import pytest
from flint import fmpq

from gspot_verified.expansion.series.terms import NumberTerms
from gspot_verified.functions.power_series import SeriesOfFunctions
from gspot_verified.functions.rings import RATIONALS
from gspot_verified.functions.symbols import Symbols
from gspot_verified.paper.section_2 import extended_system, lagrangian

POINT = [fmpq(n, d) for n, d in ((2, 3), (5, 7), (11, 13), (17, 19), (23, 29), (31, 37))]
ALPHA = (fmpq(-3, 5), fmpq(-7, 2), fmpq(-9, 4))
CHI = fmpq(4, 11)


class Rational(Symbols):
    """The rational numbers in the place of a ring of symbols."""

    def __init__(self) -> None:
        super().__init__()

    def number(self, value: Any) -> Any:
        return fmpq(value)


def printed(name: str) -> fmpq:
    """A component of Sec. 2 at the point."""
    values = {f"x{i + 1}": value for i, value in enumerate(POINT)} | {"chi": CHI}
    values |= {f"alpha{i + 1}": value for i, value in enumerate(ALPHA)}
    algebra = lagrangian.ALGEBRA
    images = {key: algebra.constant(value) for key, value in values.items()}
    found = algebra.substitute(algebra.read(lagrangian.PRINTED["2-lagrangian"][name]), images)
    return fmpq(0) if found.is_zero() else found.leading_coefficient()


def test_the_fields_are_those_of_positive_slip() -> None:
    """F, and G_N - μ G_T with G_T = H/(2 (1 - x5))."""
    system = extended_system.extended(Rational(), CHI, *ALPHA)
    series = SeriesOfFunctions((*system.F, *system.G), NumberTerms(RATIONALS), RATIONALS)
    series.extend(POINT)
    slip = printed("mu") / (2 * (1 - POINT[4]))
    for i, (drift, control) in enumerate(zip(system.F, system.G, strict=True), start=1):
        assert series[drift][0] == printed(f"F{i}")
        assert series[control][0] == printed(f"N{i}") - slip * printed(f"H{i}")
    assert len(system.F) == len(system.point) == 6


def test_a_coefficient_that_is_no_polynomial_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    honest = extended_system.extended

    def changed(ring: Symbols, chi: Any, alpha_1: Any, alpha_2: Any, _: Any) -> Any:
        return honest(ring, chi, alpha_1, alpha_2, ring.symbol("chi") - ring.number(2))

    monkeypatch.setattr(extended_system, "extended", changed)
    with pytest.raises(ValueError, match="no polynomial"):
        extended_system.extended_terms.__wrapped__(3, True)
