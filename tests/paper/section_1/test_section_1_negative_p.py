"""The sizes of an impact without collision: the formulas against an impact that is followed impulse by impulse."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.section_1 import section_1_negative_p as ledger

POSITIVE = st.fractions(Fraction(1, 2), 3, max_denominator=8)
_STEPS = 4000


def values(inertia: Fraction, coupling: Fraction, gram: Fraction, x: Fraction) -> dict[str, Fraction]:
    """A, B, C, μ and p = -x < 0 with AC - B² = gram."""
    c = (gram + coupling**2) / inertia
    return {"A": inertia, "B": coupling, "C": c, "mu": (c + x) / coupling, "p": -x}


def size(name: str, known: dict[str, Fraction], u: Fraction, r: Fraction) -> Fraction:
    """A formula of the ledger at these numbers."""
    top, bottom = (eval(text.replace("^", "**"), {}, {**known, "u": u, "r": r}) for text in ledger.SIZES[name])
    return Fraction(top) / Fraction(bottom)


def followed(known: dict[str, Fraction], u: float, r: float, energetic: bool) -> tuple[float, float]:
    """The lowest v and v at the end of a rigid impact with Coulomb friction, in small steps of the normal impulse."""
    a, b, c, mu = (float(known[name]) for name in ("A", "B", "C", "mu"))
    step = u / (mu * a - b) / _STEPS
    v = lowest = impulse = work = 0.0
    while True:  # compression
        friction = -mu if u > 0 else -b / a
        u, v = max(u + (b + a * friction) * step, 0.0), v + (c + b * friction) * step
        if v >= 0:
            break
        lowest, impulse, work = min(lowest, v), impulse + step, work - v * step
    rising, gained, back = c - b * b / a, 0.0, 0.0
    v = 0.0
    while back < r * impulse if not energetic else gained < r * r * work:
        v, back = v + rising * step, back + step
        gained += v * step
    return lowest, v


@settings(max_examples=15)
@given(POSITIVE, POSITIVE, POSITIVE, POSITIVE, POSITIVE, st.fractions(Fraction(1, 4), 1, max_denominator=4))
def test_the_sizes_are_those_of_an_impact_that_is_followed(
    inertia: Fraction, coupling: Fraction, gram: Fraction, x: Fraction, u: Fraction, r: Fraction
) -> None:
    known = values(inertia, coupling, gram, x)
    for energetic in (False, True):
        lowest, end = followed(known, float(u), float(r), energetic)
        expected = size("energetic", known, u, r) if energetic else size("Poisson", known, u, r) ** 2
        assert lowest == pytest.approx(float(size("lowest", known, u, r)), rel=0.01)
        assert end**2 == pytest.approx(float(expected), rel=0.03)


@given(POSITIVE, POSITIVE, POSITIVE, POSITIVE, POSITIVE, POSITIVE)
def test_near_the_g_spot_one_law_keeps_the_velocity_and_the_other_does_not(
    inertia: Fraction, coupling: Fraction, gram: Fraction, x: Fraction, u: Fraction, r: Fraction
) -> None:
    """By Poisson's law v stays above the bound for every p; by the energetic law v² falls below any number."""
    for scale in (Fraction(1), Fraction(1, 10**6)):
        known = values(inertia, coupling, gram, x * scale)
        top, bottom = (eval(text, {}, {**known, "u": u, "r": r}) for text in ledger.LEAST)
        assert size("Poisson", known, u, r) > Fraction(top) / Fraction(bottom) > 0
    far, near = (size("energetic", values(inertia, coupling, gram, x * s), u, r) for s in (1, Fraction(1, 10**6)))
    assert 0 < near < far / 1000


def test_the_entry_needs_the_paradox(monkeypatch: pytest.MonkeyPatch) -> None:
    assert ledger.ENTRIES["1-impact-sizes"]().verdict.outcome is Outcome.PROVED
    monkeypatch.setitem(ledger.PARADOX, "p", "x")
    assert ledger.ENTRIES["1-impact-sizes"]().verdict.outcome is not Outcome.PROVED
