"""How rigid slip ends, for each sign of α_1 and α_3; against motions in floats."""

from __future__ import annotations

from itertools import product

import pytest

from gspot_verified.paper.section_1 import section_1_outcomes as ledger


@pytest.mark.parametrize(
    ("first", "third", "apart", "end"),
    [
        (1, -1, True, ledger.LEAVES),
        (1, 1, False, ledger.LEAVES),
        (-1, 1, True, ledger.LEAVES),
        (-1, 1, False, ledger.G_SPOT),
        (-1, -1, True, ledger.G_SPOT),
        (-1, 0, True, None),
        (-1, 0, False, ledger.G_SPOT),
        (0, -1, True, None),
        (0, -1, False, None),
        (0, 1, True, ledger.LEAVES),
    ],
)
def test_ends(first: int, third: int, apart: bool, end: str | None) -> None:
    assert ledger.end_of(first, third, apart) == end


@pytest.mark.parametrize(("first", "third"), list(product((1, -1), repeat=2)))
@pytest.mark.parametrize("second", [1, -1])
def test_ends_of_motions(first: int, second: int, third: int) -> None:
    """By Euler's method: what neither lifts off nor leaves is near the G-spot, where the rule says so."""
    p, b, step = 1.0, -3.0, 1e-3
    for _ in range(12_000):
        p, b = p + step * first * p, b + step * (second * p + 2 * third * b)
        if b >= 0 or p - b > 1e3:
            break
    end = "lift-off" if b >= 0 else ledger.LEAVES if p - b > 1e3 else ledger.G_SPOT
    slope = second / (first - 2 * third)
    assert end in ("lift-off", ledger.end_of(first, third, apart=abs(-3.0 - slope) > 1e-9))


def test_the_fourth_combination_alone_lifts_off(monkeypatch: pytest.MonkeyPatch) -> None:
    assert ledger.fourth_lifts_off() is ledger.fourth_goes_above() is True
    for other in ({"alpha2": "-m"}, {"alpha1": "-w", "alpha3": "-w+u"}):
        with monkeypatch.context() as patch:
            for name, text in other.items():
                patch.setitem(ledger.FOURTH, name, text)
            assert ledger.fourth_lifts_off() is False
            assert ledger.fourth_goes_above() is False or "alpha3" in other


@pytest.mark.parametrize(
    ("place", "motion", "holds"),
    [
        (0, {"p": "q*E", "b": "K + q*E"}, True),
        (0, {"p": "q*E", "b": "q*E"}, False),  # a motion to the G-spot
        (0, {"p": "q*E", "b": "K + 2*q*E"}, False),
        (1, {"p": "q*E", "b": "K*E - q"}, False),
    ],
)
def test_motions_that_end_at_another_point(
    monkeypatch: pytest.MonkeyPatch, place: int, motion: dict[str, str], holds: bool
) -> None:
    rests = list(ledger.RESTS)
    rests[place] = (rests[place][0], motion)
    monkeypatch.setattr(ledger, "RESTS", tuple(rests))
    assert ledger.others_end_elsewhere() is holds


def test_unstable_slip_in_no_case_comes_to_the_g_spot(monkeypatch: pytest.MonkeyPatch) -> None:
    """In t, by Euler's method: p rises to 0 at the rate α_1, b falls with it, and the force is positive."""
    assert ledger.unstable_slip_reaches_it() is True
    p, b, step = -1.0, 1.5, 1e-5
    while p < -1e-3:
        force = -b / p
        assert force > 0
        p, b = p + step, b + step * (1 - 2 * force)
    assert 0 < b < 2e-3
    alphas, motion = ledger.UNSTABLE
    for wrong in ({"alpha3": -2}, {"alpha2": -1}, {"alpha1": -1}):
        monkeypatch.setattr(ledger, "UNSTABLE", ({**alphas, **wrong}, motion))
        assert ledger.unstable_slip_reaches_it() is False
