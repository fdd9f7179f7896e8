"""A run is a chain of pieces that cover the interval, each from the state in which the one before ended.

Page: proofs/uniform.md.
"""

from __future__ import annotations

import functools
import itertools
from dataclasses import replace
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.expansion.true_solutions import track as module
from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.expansion.true_solutions.frames import identity
from gspot_verified.expansion.true_solutions.piece import Deviations, Rules, TrackPiece
from gspot_verified.expansion.true_solutions.track import Track, track
from gspot_verified.numbers.balls import working_bits
from gspot_verified.testing import extended_example


@functools.cache
def equations() -> DeviationEquations:
    system = replace(extended_example(chi=1), regularisation=Regularisation.of(2, 3, 1))
    with working_bits(96):
        return DeviationEquations(expand_system(system, 4), fmpq(1, 200))


CENTRE = [arb(0)] * 8 + [arb(1), arb(0)]
RADII = [arb((k + 1, -8)) for k in range(10)]


def recorded(monkeypatch: pytest.MonkeyPatch, fails_from: int = 10**6) -> tuple[Track, list[Any]]:
    calls: list[Any] = []
    whole = module.advance

    def advance(rules: Rules, state: Deviations, start: fmpq, end: fmpq) -> TrackPiece | None:
        found = None if len(calls) >= fails_from else whole(rules, state, start, end)
        calls.append((rules, state, start, end, found))
        return found

    monkeypatch.setattr(module, "advance", advance)
    with working_bits(96):
        return track(equations(), fmpq(3), fmpq(-1, 2), fmpq(1, 3), CENTRE, RADII, arb(5)), calls


def test_the_pieces_are_a_chain_from_the_start_to_the_end(monkeypatch: pytest.MonkeyPatch) -> None:
    found, calls = recorded(monkeypatch)
    assert found.is_whole
    assert len(calls) == len(found.pieces) > 3
    assert (calls[0][2], calls[-1][3], found.end, found.power) == (fmpq(-1, 2), fmpq(1, 3), fmpq(1, 3), fmpq(3))
    first = calls[0][1]
    assert (first.centre, first.radii, first.initial) == (tuple(CENTRE), tuple(RADII), arb(5))
    assert (first.elapsed, first.forced, first.turned) == (fmpq(0), arb(0), identity(10))
    for before, after in itertools.pairwise(calls):
        assert before[3] == after[2] > before[2]
        assert after[1] is before[4].at_end
    assert [call[4] for call in calls] == list(found.pieces)


@pytest.mark.parametrize("fails_from", [0, 1, 3])
def test_a_run_that_ends_before_is_not_whole(fails_from: int, monkeypatch: pytest.MonkeyPatch) -> None:
    found, calls = recorded(monkeypatch, fails_from)
    assert not found.is_whole
    assert (len(found.pieces), len(calls)) == (fails_from, fails_from + 1)


def test_the_deviation_of_z() -> None:
    """z = y + lambda/k_2, k_2 = 3."""
    with working_bits(96):
        found = track(equations(), fmpq(3), fmpq(-1, 2), fmpq(-1, 4), CENTRE, RADII, arb(5))
        piece = found.pieces[0]
        z = found.z_deviation(piece)
        page = piece.force.mid() / 3 + piece.deviations[8].mid()
        assert z.contains(page)
        assert abs(z.mid() - page) < arb(10) ** -9
        assert abs(z.rad() - piece.force.rad() / 3 - piece.deviations[8].rad()) < arb(10) ** -6
        for lost in (arb("nan"), arb("inf")):
            assert not found.z_deviation(replace(piece, force=lost)).is_finite()


def test_a_set_in_a_frame_is_the_same_set() -> None:
    """e = 2u, with half the centre and radii: the same enclosures up to rounding; another frame, another set."""
    with working_bits(96):
        plain = track(equations(), fmpq(3), fmpq(-1, 2), fmpq(-1, 4), CENTRE, RADII, arb(5))
        half = [value / 2 for value in CENTRE], [value / 2 for value in RADII], arb(5)
        framed = track(equations(), fmpq(3), fmpq(-1, 2), fmpq(-1, 4), *half, frame=2 * identity(10))
        other = track(equations(), fmpq(3), fmpq(-1, 2), fmpq(-1, 4), *half)
        ends = [found.pieces[-1].end_deviations[8] for found in (plain, framed, other)]
        assert abs(ends[0].mid() - ends[1].mid()) < arb("1e-3")
        assert abs(ends[0].rad() - ends[1].rad()) < arb("0.1") * ends[0].rad()
        assert abs(ends[0].mid() - ends[2].mid()) > arb("0.3")
