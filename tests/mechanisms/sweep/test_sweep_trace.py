"""Choices of tubes: the same tube is proved again, bit for bit; all else that a journal may hold changes nothing."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Variable
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.sweep import sweep_start, sweep_trace
from gspot_verified.mechanisms.sweep.sweep import sweep
from gspot_verified.mechanisms.sweep.sweep_start import Origin, proved_tube
from gspot_verified.mechanisms.sweep.sweep_trace import Choice, TubeTrace, read_choice
from gspot_verified.mechanisms.zeros.tube import Equations, OnTube

ROOT = Equations(BoxProgram([Variable(0) * Variable(0) - Variable(1)], 2), 1)
BOX = (fmpq(1),), (fmpq(5, 4),)
START = Origin((fmpq(1),), (fmpq(1),), ((fmpq(1, 2),),))


def search() -> OnTube | None:
    return proved_tube(ROOT, *BOX, START)


def never() -> OnTube | None:
    raise AssertionError("the choice was enough")


def test_a_tube_is_proved_again_from_its_choice() -> None:
    first = TubeTrace()
    found = first.tube(ROOT, *BOX, search)
    assert found is not None
    second = TubeTrace([read_choice(json.loads(json.dumps(choice))) for choice in first.met])
    again = second.tube(ROOT, *BOX, never)
    assert again is not None
    for own, other in zip(found.tube.within + found.tube.found, again.tube.within + again.tube.found, strict=True):
        assert (own.mid().man_exp(), own.rad().man_exp()) == (other.mid().man_exp(), other.rad().man_exp())
    assert second.met == first.met


WRONG: list[Choice] = [
    ((), (), ()),
    (((1, 0),), (((1, -1),),), ((1, -300),)),  # too narrow for a zero
    (((5, 0),), (((1, -1),),), ((1, -2),)),  # no zero there
    (((1, 4000),), (((1, 4000),),), ((1, 4000),)),
    (((1, 0), (1, 0)), (((1, -1),),), ((1, -2),)),
    (((1, 0),), (((1, -1), (1, 0)),), ((1, -2),)),
    (((0, 0),), (((0, 0),),), ((0, 0),)),
]


@pytest.mark.parametrize("wrong", WRONG)
def test_a_choice_that_proves_nothing_is_sought_anew(wrong: Choice) -> None:
    trace, plain = TubeTrace([wrong]), TubeTrace()
    found, expected = trace.tube(ROOT, *BOX, search), plain.tube(ROOT, *BOX, search)
    assert found is not None
    assert expected is not None
    assert trace.met == plain.met


def test_no_tube_is_a_choice_too() -> None:
    trace = TubeTrace([None])
    assert trace.tube(ROOT, *BOX, never) is None
    assert trace.tube(ROOT, *BOX, search) is not None


def test_a_search_in_vain_is_noted() -> None:
    trace = TubeTrace()
    assert trace.tube(ROOT, *BOX, lambda: None) is None
    assert trace.met == [None]


@pytest.mark.parametrize(
    "place", [[1.5, 0], [1, 2.0], [True, 0], ["1", 0], [2**4000, 0], [-(2**4000), 0], [1, 4001], [1, -4001]]
)
def test_what_is_no_number_of_a_journal(place: list[Any]) -> None:
    assert read_choice([[[-(2**3999), -4000]], [[[1, 4000]]], [[0, 0]]]) is not None
    for data in ([[place], [[[1, 0]]], [[1, 0]]], [[[1, 0]], [[place]], [[1, 0]]], [[[1, 0]], [[[1, 0]]], [place]]):
        with pytest.raises(ValueError, match="a number"):
            read_choice(data)


@given(st.floats(2.0**-60, 2.0**60) | st.floats(0, 1))
def test_a_radius_comes_back(radius: float) -> None:
    for ball in (arb(0, radius), arb(0, arb(radius).sqrt()), arb(0, (3, -5))):
        mantissa, exponent = (int(part) for part in ball.rad().man_exp())
        assert sweep_trace._around_zero(mantissa, exponent).rad().man_exp() == ball.rad().man_exp()


MECHANISM = shipped_mechanism("falling rod of Génot and Brogliato")
OVER = {"mu": "1.5..1.7:3"}


def forgeries() -> dict[str, Callable[[list[Any]], list[Any]]]:
    def tubes(change: Callable[[Any], Any]) -> Callable[[list[Any]], list[Any]]:
        return lambda line: [line[0], line[1], [[change(tube) for tube in cell] for cell in line[2]]]

    return {
        "another digest": lambda line: [line[0], "0" * 64, line[2]],
        "another portion": lambda line: [line[0] + 1, *line[1:]],
        "no cells": lambda line: [line[0], line[1], []],
        "more cells": lambda line: [line[0], line[1], [*line[2], *line[2]]],
        "cells in another order": lambda line: [line[0], line[1], line[2][::-1]],
        "no tubes": tubes(lambda _: None),
        "other centres": tubes(lambda tube: tube and [[[1, 0]] * len(tube[0]), *tube[1:]]),
        "other slopes": tubes(lambda tube: tube and [tube[0], [[[7, 3]]] * len(tube[1]), tube[2]]),
        "wider": tubes(lambda tube: tube and [*tube[:2], [[m, e + 4] for m, e in tube[2]]]),
        "far too wide": tubes(lambda tube: tube and [*tube[:2], [[m, e + 900] for m, e in tube[2]]]),
    }


@pytest.mark.parametrize("name", forgeries())
def test_a_forged_journal_changes_no_piece(name: str, tmp_path: Path) -> None:
    path = tmp_path / "journal"
    whole = sweep(MECHANISM, OVER, journal=path)
    header, *lines = path.read_text().splitlines()
    forged = [json.dumps(forgeries()[name](json.loads(line))) for line in lines]
    path.write_text("\n".join([header, *forged]) + "\n")
    assert sweep(MECHANISM, OVER, journal=path) == whole
    assert sweep(MECHANISM, OVER, journal=path) == whole


def test_a_journal_saves_the_tries_that_failed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path, tries = tmp_path / "journal", []
    real = sweep_start.try_tube

    def counted(*given: Any) -> Any:
        tries.append(given)
        return real(*given)

    monkeypatch.setattr(sweep_start, "try_tube", counted)
    monkeypatch.setattr(sweep_trace, "try_tube", counted)
    whole = sweep(MECHANISM, OVER, journal=path)
    first = len(tries)
    tries.clear()
    assert sweep(MECHANISM, OVER, journal=path) == whole
    assert 0 < len(tries) < first
