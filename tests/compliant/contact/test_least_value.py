"""The least value on a half-line: against a scan, by cells that cover it, and for functions known in closed form.

Page: proofs/monotone.md, section 5.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import to_fmpq

from gspot_verified.compliant.contact import least_value as least_value_module
from gspot_verified.compliant.contact.least_value import LeastValue, halves, least_value, rising_from
from gspot_verified.compliant.slow.profile import Profile

START = fmpq(-10)


class _Square:
    """(tau - place)^2 + radius of a ball, in the place of a profile."""

    order = 2

    def __init__(self, place: fmpq | int, radius: fmpq | int = 0) -> None:
        self.place, self.radius = fmpq(place), fmpq(radius)

    def derivatives(self, tau: fmpq, orders: range, _: int) -> list[arb]:
        away = tau - self.place
        return [[arb(away * away, self.radius if away < 2 else 0), arb(2 * away), arb(2)][k] for k in orders]

    def value(self, tau: fmpq, digits: int) -> arb:
        return self.derivatives(tau, range(1), digits)[0]


def _found(profile: object, start: fmpq, digits: int = 6) -> LeastValue:
    found = least_value(profile, start, digits)  # type: ignore[arg-type]
    assert found is not None
    return found


@settings(max_examples=10, deadline=None)
@given(
    st.fractions(Fraction(1, 9), 12, max_denominator=9).filter(lambda b: b.denominator > 1),
    st.fractions(Fraction(1, 10), 1, max_denominator=20),
    st.fractions(-9, 6, max_denominator=7),
)
def test_the_least_value_is_below_a_scan_and_attained(beta: Fraction, root: Fraction, start: Fraction) -> None:
    profile = Profile.at_root(to_fmpq(beta), to_fmpq(root))
    found = _found(profile, to_fmpq(start))
    assert found.place >= to_fmpq(start)
    assert profile.value(found.place, 20) <= found.upper
    assert found.lower <= found.upper
    assert found.upper - found.lower <= abs(found.upper) * fmpq(1, 10**5)
    for k in range(25):
        assert profile.value(to_fmpq(start + Fraction(k * k, 20)), 12) >= found.lower


def test_the_least_value_rests_on_cells_that_cover_the_half_line(monkeypatch: pytest.MonkeyPatch) -> None:
    profile = Profile.at_root(fmpq(5, 2), fmpq(1, 2))
    found = _found(profile, START, 4)
    assert "cover [-10, inf]" in str(found.evidence)
    monkeypatch.setattr(least_value_module, "halves", lambda lower, upper: (halves(lower, upper)[0],))
    assert _found(profile, START, 4).evidence is None


@pytest.mark.parametrize("place", [fmpq(0), fmpq(1, 3), fmpq(5), fmpq(900)])
def test_the_least_value_of_a_square(place: fmpq) -> None:
    for start in (fmpq(0), place, place + 3):
        found = _found(_Square(place), start, 8)
        true = (max(start, place) - place) ** 2
        assert found.lower <= true <= found.upper
        assert found.upper - found.lower <= fmpq(1, 10**7) * (1 + true)
        assert found.evidence is not None
        assert f" [{start}, inf]" in str(found.evidence)


class _Cubic(_Square):
    """tau + ((tau - 2)^3 + 8)/64: f' > 0 everywhere, f'' > 0 from 2 on."""

    order = 3

    def derivatives(self, tau: fmpq, orders: range, _: int) -> list[arb]:
        away = arb(tau - 2)
        values = [tau + (away**3 + 8) / 64, 1 + 3 * away * away / 64, 3 * away / 32, arb(fmpq(3, 32))]
        return [values[k] for k in orders]


def test_a_least_value_that_is_reached_exactly_ends_the_search() -> None:
    """The cell [0, 3] has the lower bound 0, by its slope; that is the value at the start."""
    found = _found(_Cubic(2), fmpq(0))
    assert (found.lower, found.upper, found.place) == (0, 0, 0)
    assert "2 parts cover [0, inf]" in str(found.evidence)


def test_the_upper_bound_is_the_least_of_the_upper_ends() -> None:
    """Balls that are wide but at the start, 2 from the place of the least value: theirs do not replace it."""
    wide = _found(_Square(2, 100), fmpq(4))
    assert (wide.upper, wide.place) == (4, 4)
    wide = _found(_Far(), fmpq(0))
    assert wide.lower < wide.upper <= 9
    assert wide.place == 0


class _Far(_Square):
    """(tau - 3)^2, exact at 0 only."""

    def __init__(self) -> None:
        super().__init__(3)

    def derivatives(self, tau: fmpq, orders: range, digits: int) -> list[arb]:
        self.radius = fmpq(0 if tau == 0 else 10)
        return super().derivatives(tau, orders, digits)


@pytest.mark.parametrize("place", [5, 1000])
def test_where_it_rises(place: int) -> None:
    """Sought up to 10^4, and at the start wherever that is; a slope that is 0 does not count."""
    found = rising_from(_Square(place), fmpq(0), 10)  # type: ignore[arg-type]
    assert found is not None
    assert place < found[0] <= 2 * place
    assert rising_from(_Square(place), fmpq(place), 10)[0] > place  # type: ignore[arg-type,index]
    assert rising_from(_Square(20_000), fmpq(0), 10) is None  # type: ignore[arg-type]
    far = rising_from(_Square(place), fmpq(20_000), 10)  # type: ignore[arg-type]
    assert far is not None
    assert far[0] == 20_000
    assert rising_from(_Square(30_000), fmpq(20_000), 10) is None  # type: ignore[arg-type]
    assert least_value(_Square(30_000), fmpq(20_000), 10) is None  # type: ignore[arg-type]


def test_a_start_far_to_the_left_costs_few_points(monkeypatch: pytest.MonkeyPatch) -> None:
    """One point for each unit of tau took twenty minutes from -10^6 on."""
    square, seen = _Square(fmpq(1, 3)), []
    of_square = square.derivatives
    monkeypatch.setattr(square, "derivatives", lambda *given: seen.append(given) or of_square(*given))
    found = rising_from(square, fmpq(-(10**6)), 8)  # type: ignore[arg-type]
    assert found is not None
    assert fmpq(1, 3) < found[0] <= 2
    assert len(seen) < 100
