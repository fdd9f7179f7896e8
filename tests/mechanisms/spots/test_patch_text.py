"""A patch of G-spots as it is written: it is said of every number of the intervals in the text."""

from __future__ import annotations

import re
from fractions import Fraction

import pytest
from flint import arb, fmpq
from mechanisms.spots.test_all_g_spots import free_rod, polynomial

from gspot_verified.mechanisms.spots import all_g_spots
from gspot_verified.mechanisms.spots.all_g_spots import _Search, find_g_spots
from gspot_verified.mechanisms.spots.g_spot_list import Patch
from gspot_verified.numbers.balls import exact

Written = dict[str, tuple[fmpq, fmpq]]


def patch_of(p: str, b: str) -> Patch:
    found = find_g_spots(polynomial(p, b, ("w", "s", "r"))).patch
    assert found is not None
    return found


def written(sides: tuple[tuple[str, str], ...]) -> Written:
    """The intervals of a text."""
    intervals = {}
    for word, text in sides:
        low, high = (exact(number, word) for number in re.findall(r"-?\d[\d./]*", text))
        assert isinstance(low, fmpq)
        assert isinstance(high, fmpq)
        intervals[word] = low, high
    return intervals


def within(value: fmpq, side: tuple[fmpq, fmpq]) -> bool:
    return bool(side[0] <= value <= side[1])


def test_over_both_ends_of_the_written_interval_there_is_a_spot_in_the_written_box() -> None:
    """w = s^2: rounded outward the interval of s held an s whose square was not in that of w."""
    found = patch_of("w^2 + s^2 + r^2 - 1", "w - s^2")
    over, box = written(found.parameters), written(found.box)
    assert (set(over), set(box)) == ({"s"}, {"w", "r"})
    for s in over["s"]:
        assert within(s * s, box["w"])
        rest = 1 - s * s - s**4
        assert any(within(fmpq(sign), box["r"]) for sign in (1, -1))
        least, most = sorted(end * end for end in box["r"])
        assert least <= rest <= most


def test_a_component_that_was_solved_for_before_is_named() -> None:
    """p = w^2 - 1 has two zeros: over each r there are two spots with s in the interval, one for each w."""
    found = patch_of("w^2 - 1", "s^2 + r^2 - 1")
    over, box = written(found.parameters), written(found.box)
    (parameter,) = over
    assert set(box) == {"w", "s", "r"} - {parameter}
    assert sum(within(fmpq(w), box["w"]) for w in (1, -1)) == 1
    (solved,) = {"s", "r"} - {parameter}
    for end in over[parameter]:
        root = arb(1 - end * end).sqrt()
        low, high = box[solved]
        assert sum(bool(low < sign * root) and bool(sign * root < high) for sign in (1, -1)) == 1
    assert f"for all {parameter} in " in str(found)
    assert " exactly one with w in [" in str(found)


def test_the_value_of_a_component_that_no_condition_holds_is_named() -> None:
    found = find_g_spots(polynomial("w^2 + s^2 + r^2 - 1", "w - s^2", ("w", "s", "r"), fixed=False)).patch
    assert found is not None
    assert dict(found.free) == {"x": "0", "u": "0"}
    assert str(found).endswith(", where x = 0, u = 0")


def test_a_patch_over_velocities_names_the_angle() -> None:
    """b holds both X_dot and theta_dot: a curve of spots over each angle at which p = 0, of which there are four."""
    found = find_g_spots(free_rod(Fraction(2), "-1 - X_dot"), budget=3000).patch
    assert found is not None
    assert "theta" in dict(found.box)
    assert "theta" not in dict(found.parameters)


def test_a_box_that_was_not_compared_gives_no_patch(monkeypatch: pytest.MonkeyPatch) -> None:
    """That what is written lies in what was checked; that the solution of the stages before is the only one there."""
    functions = polynomial("w^2 - 1", "s^2 + r^2 - 1", ("w", "s", "r"))
    with monkeypatch.context() as patched:
        patched.setattr(all_g_spots, "in_inner_interval", lambda *_: None)
        assert find_g_spots(functions).patch is None
    with monkeypatch.context() as patched:
        patched.setattr(_Search, "_is", lambda *_: None)
        assert find_g_spots(functions).patch is None
    with monkeypatch.context() as patched:  # a box is found, and not compared
        patched.setattr(_Search, "_is", lambda *_: None)
        wider = arb(0, "0.001")
        patched.setattr(_Search, "_alone", lambda _, before: {i: x + wider for i, x in before.values.items()})
        assert find_g_spots(functions).patch is None
