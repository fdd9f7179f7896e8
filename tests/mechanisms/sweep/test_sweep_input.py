"""What is asked of a sweep: its axes, and the place at which it begins."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from flint import fmpq

from gspot_verified.mechanisms.input.file import parse_mechanism
from gspot_verified.mechanisms.input.mechanism import MechanismError
from gspot_verified.mechanisms.shipped import shipped_mechanism, shipped_text
from gspot_verified.mechanisms.sweep import sweep as module
from gspot_verified.mechanisms.sweep import sweep_grid
from gspot_verified.mechanisms.sweep.sweep import sweep
from gspot_verified.mechanisms.sweep.sweep_grid import Axis

ROD = shipped_mechanism("falling rod of Génot and Brogliato")
AXIS = Axis("mu", fmpq(7, 5), fmpq(2), 10)


@pytest.mark.parametrize(
    ("given", "ends"),
    [
        ("7/5..2", (fmpq(7, 5), fmpq(2), None)),
        ("1.4..2:10", (fmpq(7, 5), fmpq(2), 10)),
        ((1, 2), (fmpq(1), fmpq(2), None)),
        (("7/5", 2, 10), (fmpq(7, 5), fmpq(2), 10)),
    ],
)
def test_the_ends_of_a_range(given: Any, ends: tuple[fmpq, fmpq, int | None]) -> None:
    assert sweep_grid._ends("mu", given) == ends


def test_the_cells_of_all_axes_together_are_bounded() -> None:
    """10^6 of them are allowed."""
    assert [axis.cells for axis in module._axes(ROD, {"mu": "1.4..2:1000", "m": "1..2:1000"})] == [1000, 1000]
    with pytest.raises(ValueError, match="at most 1000000 cells, got 1001000"):
        module._axes(ROD, {"mu": "1.4..2:1000", "m": "1..2:1001"})


@pytest.mark.parametrize(
    ("own", "given", "place"),
    [
        ("3/2", {}, "3/2"),
        ("1", {}, "7/5"),
        ("3", {}, "2"),
        (None, {}, "17/10"),
        ("3/2", {"mu": "7/5"}, "7/5"),
        ("3/2", {"mu": "2"}, "2"),
        ("3/2", {"mu": "8/5"}, "8/5"),
        ("3/2", {"mu": "201/100"}, None),
        ("3/2", {"mu": "139/100"}, None),
    ],
)
def test_where_a_sweep_begins(own: str | None, given: dict[str, str], place: str | None) -> None:
    """Its own value or the nearest of the range, the middle where there is none, or what is given."""
    mechanism = ROD.with_parameters(mu=own)
    if place is None:
        with pytest.raises(ValueError, match=r"lies outside of 7/5\.\.2"):
            module._start(mechanism, [AXIS], given)
    else:
        assert module._start(mechanism, [AXIS], given) == (fmpq(*map(int, place.split("/"))),)


def test_one_digit_is_enough_and_folds_belong_to_one_axis(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[int] = []
    monkeypatch.setattr(module, "with_folds", lambda *given: (asked.append(given[-1]), (given[3], []))[1])
    sweep(ROD, {"mu": "1.4..2:2"}, digits=1)
    assert asked == [1]
    sweep(ROD, {"mu": "1.4..2:1", "m": "1..2:1"})
    assert asked == [1]


@pytest.mark.parametrize(
    ("word", "value"),
    [
        ("positive", "(beta - 3)^2 - 1"),
        ("nonnegative", "(beta - 3)^2 - 1"),
        ("negative", "1 - (beta - 3)^2"),
        ("nonpositive", "1 - (beta - 3)^2"),
        ("nonzero", "(beta - 3)^2 - 1/4"),
        ("integer", "2*beta"),
    ],
)
def test_what_formulas_assume_of_a_parameter_that_follows_holds_between_the_ends(word: str, value: str) -> None:
    """At 1, 3/2 and 5, where the mechanism is asked, it holds; in the middle it does not. From 9/2 on the signs do."""
    text = shipped_text("frictional impact oscillator").replace("kappa = 0", f'kappa = "{value}"')
    text = text.replace('beta = "7/3"', "beta = 5")
    mechanism = replace(parse_mechanism(text), assumed=(("kappa", word), ("mu", "positive")))
    said = rf"symbol kappa is assumed {word}; its value may not be, for beta in \[1, 5\]"
    with pytest.raises(MechanismError, match=said):
        module._axes(mechanism, {"beta": "1..5"})
    with pytest.raises(MechanismError, match=said + r", k_phi in \[1, 2\]"):
        module._axes(mechanism, {"beta": "1..5", "k_phi": "1..2"})
    if word != "integer":
        assert [axis.lower for axis in module._axes(mechanism, {"beta": "9/2..5"})] == [fmpq(9, 2)]
    assert len(module._axes(mechanism, {"k_phi": "1..2"})) == 1


def test_what_formulas_assume_of_a_parameter_that_varies_holds_at_the_ends() -> None:
    mechanism = replace(shipped_mechanism("frictional impact oscillator"), assumed=(("beta", "positive"),))
    assert len(module._axes(mechanism, {"beta": "1..2"})) == 1
    with pytest.raises(MechanismError, match="symbol beta is assumed positive; its value is -1"):
        module._axes(mechanism, {"beta": "-1..2"})
