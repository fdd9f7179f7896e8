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


@pytest.mark.parametrize(
    ("step", "table", "name", "wrong"),
    [
        ("force_needs_positive_b", None, "ACCELERATION", "2*b + p*l"),
        ("force_needs_positive_b", None, "ACCELERATION", "b + l"),
        ("flight_leaves", None, "FLIGHT", "1/2*b*s^2 + b*s"),  # not from rest
        ("compresses_in_slip", "RATES", "u", "mu*A"),
        ("compresses_in_slip", "RATES", "v", "mu*B"),
        ("impulses_of_the_compression", "STICK", "v", "C*P + A*T"),
        ("decompresses_in_stick", "STICK", "u", "A*T + C*P"),
        ("sizes_along_the_path", "RATES", "v", "C + mu*B"),
        ("sizes_by_the_whole_impulse", "STICK", "v", "C*P + A*T"),
    ],
)
def test_each_part_of_a_step_is_needed(
    monkeypatch: pytest.MonkeyPatch, step: str, table: str | None, name: str, wrong: str
) -> None:
    assert getattr(ledger, step)() is True
    if table is None:
        monkeypatch.setattr(ledger, name, wrong)
    else:
        monkeypatch.setitem(getattr(ledger, table), name, wrong)
    assert getattr(ledger, step)() is False


def test_motions_that_are_open_leave_the_answer_open(monkeypatch: pytest.MonkeyPatch) -> None:
    assert ledger.motions_as_claimed() is True
    for closed in (1, -1):
        with monkeypatch.context() as patch:
            patch.setattr(ledger, "motions", lambda sign, closed=closed: [0, 1] if sign == closed else None)
            assert ledger.motions_as_claimed() is None


@pytest.mark.parametrize(
    ("name", "pair"),
    [
        ("lowest", ("p*u + u", "mu*A - B")),  # does not vanish at p = 0
        ("energetic", ("r^2*B*u^2", "A*(mu*A - B)")),
        ("Poisson", ("r*B*u", "mu*A - B")),
    ],
)
def test_sizes_that_do_not_behave_so_near_the_g_spot(
    monkeypatch: pytest.MonkeyPatch, name: str, pair: tuple[str, str]
) -> None:
    assert ledger.sizes_near_the_g_spot() is True
    monkeypatch.setitem(ledger.SIZES, name, pair)
    assert ledger.sizes_near_the_g_spot() is False


@pytest.mark.parametrize("name", list(ledger.SIZES))
def test_each_size_is_compared_on_both_routes(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    top, bottom = ledger.SIZES[name]
    monkeypatch.setitem(ledger.SIZES, name, (f"2*({top})", bottom))
    assert ledger.sizes_along_the_path() is ledger.sizes_by_the_whole_impulse() is False


def test_a_flight_that_rises_for_either_sign_of_b_is_another_one(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ledger, "ACCELERATION", "b^2 + p*l")
    monkeypatch.setattr(ledger, "FLIGHT", "1/2*b^2*s^2")
    assert ledger.flight_leaves() is False


def test_positive_symbols_are_put_in_where_the_degree_is_1() -> None:
    a, b, d = (ledger.ALGEBRA.symbols[name] for name in "ABD")
    assert ledger.with_positive_symbols(a) == (b**2 + d) * b
    assert ledger.with_positive_symbols(a**2).is_zero()
    assert ledger.with_positive_symbols(b) == b**2 * ledger.ALGEBRA.symbols["C"]


def test_the_lowest_velocity_is_found_on_the_second_route_too(monkeypatch: pytest.MonkeyPatch) -> None:
    """With twice the lowest v the work is twice as large, and the end by the energetic law agrees with it."""
    for name in ("lowest", "energetic"):
        top, bottom = ledger.SIZES[name]
        monkeypatch.setitem(ledger.SIZES, name, (f"2*({top})", bottom))
    assert ledger.sizes_by_the_whole_impulse() is False


@pytest.mark.parametrize(("factor", "under"), [("p", "p"), ("1", "-1"), ("1", "x")])
def test_a_limit_is_open_where_the_denominator_is_not_positive_at_the_g_spot(
    monkeypatch: pytest.MonkeyPatch, factor: str, under: str
) -> None:
    assert ledger.quotient_has_the_limit() is True
    top, bottom = ledger.SIZES["energetic"]
    monkeypatch.setitem(ledger.SIZES, "energetic", (f"{factor}*({top})", f"{under}*({bottom})"))
    assert ledger.quotient_has_the_limit() is None
