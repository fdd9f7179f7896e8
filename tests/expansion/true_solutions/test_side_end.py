"""Corollary 2 of proofs/uniform.md: what is asked for at the end of a piece, 2^-20 before and beyond the place where it
becomes an equality; and ranges of delta put together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb, fmpq
from samples.cones import cone_of
from samples.strategies import ends

from gspot_verified.expansion.true_solutions import side_end
from gspot_verified.expansion.true_solutions.growth import DeviationCone, EntryDeviation
from gspot_verified.expansion.true_solutions.side_end import (
    SideEnd,
    first_end,
    first_entered,
    joined,
    latest_at,
    proved_so_far,
)
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.evidence import less

ZERO, ONE, NEAR = fmpq(0), fmpq(1), fmpq(1, 2**20)
SHOWN = less(0, 1)
assert SHOWN is not None
START, FACTOR = fmpq(-1), fmpq(10)
MEAN, KAPPA, DELTA, LEAST = arb(3), arb(2), fmpq(1, 4), fmpq(1, 8)
WIDE = arb(17, 1)  # Y at s_1
CONE = DeviationCone(arb(5), arb(6), arb(7), arb(8), (), arb(9), arb(64))


@dataclass(frozen=True)
class Piece:
    """From one s to another; lambda_N lies in ``mean`` + [0, 1/16] ``force``: mu = 2."""

    start: fmpq
    end: fmpq
    mean: fmpq = ONE
    force: fmpq = ZERO

    @property
    def states(self) -> tuple[arb, arb]:
        """Any balls."""
        return arb(self.start), arb(self.end, 1)


PIECES = (Piece(fmpq(-1), fmpq(0)), Piece(fmpq(0), fmpq(1, 2)), Piece(fmpq(1, 2), fmpq(2)))


@dataclass(frozen=True)
class Run:
    """Pieces, the sides of the entries at their ends (0: none), and for each cone what the deviation and the force at
    Y_max are; None: the cone does not hold."""

    side: int = -1
    pieces: tuple[Piece, ...] = PIECES
    sides: tuple[int, ...] | None = None
    cones: tuple[tuple[fmpq, arb] | None, ...] = ((fmpq(4), arb(3)),)

    def found(self, monkeypatch: pytest.MonkeyPatch) -> SideEnd | None:
        """What :func:`first_end` answers."""
        sides = (0, self.side, self.side) if self.sides is None else self.sides
        listed = [replace(CONE, top=arb(64 * 2**k)) for k in range(len(self.cones))]

        def answer(cone: DeviationCone) -> tuple[fmpq, arb] | None:
            return self.cones[listed.index(cone)]

        def entry_of(_: Any, index: int) -> EntryDeviation | None:
            side, one = sides[index], arb(1)
            place = self.pieces[index].end
            return EntryDeviation(side, START, place, WIDE, one, one, one, (), one, one) if side else None

        def grows(*given: Any) -> Any:
            found = answer(given[-1])
            return None if found is None else (arb(found[0]), less(fmpq(22, 7), 4))

        def ranges_of(*given: Any) -> Any:
            found = answer(given[-1])
            return SimpleNamespace(force=arb(3) if found is None else found[1], state=(arb(20), arb(-30)))

        for name, stand_in in (("entry_of", entry_of), ("grows", grows), ("ranges_of", ranges_of)):
            monkeypatch.setattr(side_end, name, stand_in)
        monkeypatch.setattr(side_end, "cones", lambda *_: iter(listed))
        equations = SimpleNamespace(delta=arb(DELTA), exact_delta=DELTA, least=LEAST, kappa=KAPPA, mean_force=MEAN)
        tracked: Any = SimpleNamespace(equations=equations, power=fmpq(2), pieces=self.pieces)
        with working_bits(256):
            return first_end(tracked, START, FACTOR)


@pytest.mark.parametrize("side", [-1, 1])
def test_an_end_is_stated_with_what_it_rests_on(side: int, monkeypatch: pytest.MonkeyPatch) -> None:
    found = Run(side, cones=(None, (fmpq(40), arb(3)), None)).found(monkeypatch)
    assert found is not None
    assert (found.least, found.most, found.side, found.entered) == (LEAST, DELTA, side, fmpq(1, 2))
    assert found.cone.a == CONE.a
    (ratio, _), (least, _) = ends(found.ratio), ends(WIDE)
    assert 128 <= ratio * least < 128 + Fraction(1, 2**200)
    assert found.force == (40 if side < 0 else 30)
    states = [*(piece.states for piece in PIECES[:2]), (arb(20), arb(-30))]  # up to s_1 = 1/2, and those of the cone
    assert len(found.states) == 2
    for box, values in zip(found.states, zip(*states, strict=True), strict=True):
        assert all(map(box.contains, values))
        assert not box.contains(arb(50))
    before, again, whole, grown, *ended = found.evidence.facts
    assert before == again == "0 < 1.00000"
    assert whole == "2 parts cover [-1, 1/2]"
    assert grown == "22/7 < 4"
    assert ended == (["3.00000 < 40.0000"] if side < 0 else ["0 < 3.00000", "30.0000 < 43.0000"])


@pytest.mark.parametrize(
    ("side", "force", "edge"),
    [
        (-1, arb(3, "0.25"), fmpq(13, 4)),  # e_lambda exceeds the force there
        (1, arb(3, "0.25"), fmpq(109, 4)),  # the force there and e_lambda exceed 10 times the mean force
    ],
)
def test_the_deviation_is_large_enough_only(side: int, force: arb, edge: fmpq, monkeypatch: pytest.MonkeyPatch) -> None:
    assert Run(side, cones=((edge + NEAR, force),)).found(monkeypatch) is not None
    assert Run(side, cones=((edge - NEAR, force),)).found(monkeypatch) is None


def test_before_an_impact_the_force_does_not_vanish(monkeypatch: pytest.MonkeyPatch) -> None:
    for least, good in ((NEAR, True), (-NEAR, False)):
        force = arb(fmpq(1, 4) + least, "0.25")
        assert (Run(1, cones=((fmpq(1000), force),)).found(monkeypatch) is not None) is good


@pytest.mark.parametrize("at", [0, 1, 2])
@pytest.mark.parametrize(
    ("mean", "force", "good"),
    [
        (fmpq(1), -16 + NEAR, True),
        (fmpq(1), -16 - NEAR, False),
        (NEAR, fmpq(1000), True),
        (-NEAR, fmpq(1000), False),
    ],
)
def test_contact_is_kept_in_every_piece_up_to_the_end(
    at: int, mean: fmpq, force: fmpq, good: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    pieces = tuple(replace(piece, mean=mean, force=force) if k == at else piece for k, piece in enumerate(PIECES))
    assert (Run(pieces=pieces, sides=(0, 0, 1), cones=((fmpq(40), arb(3)),)).found(monkeypatch) is not None) is good
    early = Run(pieces=pieces).found(monkeypatch)
    assert (early is not None) is (good or at == 2)


def test_the_first_end_counts_and_there_may_be_none(monkeypatch: pytest.MonkeyPatch) -> None:
    for sides, entered in (((-1, -1, -1), fmpq(0)), ((0, 0, -1), fmpq(2))):
        found = Run(sides=sides).found(monkeypatch)
        assert found is not None
        assert found.entered == entered
    assert Run(sides=(0, 0, 0)).found(monkeypatch) is None
    assert Run(cones=()).found(monkeypatch) is None
    assert Run(cones=(None, None)).found(monkeypatch) is None


def test_what_comes_after_the_end_fills_no_gap_before_it(monkeypatch: pytest.MonkeyPatch) -> None:
    late = (PIECES[0], PIECES[2], PIECES[1])
    assert Run(pieces=late, sides=(0, -1, 0)).found(monkeypatch) is None
    assert Run(pieces=PIECES[1:], sides=(0, -1)).found(monkeypatch) is None


def end(least: fmpq, most: fmpq, side: int = 1) -> SideEnd:
    """A range in which it happens by s = 2 + log(3/delta^mu)/5."""
    assert SHOWN is not None
    return SideEnd(least, most, side, fmpq(2), cone_of(5), arb(3), arb(5), (), SHOWN)


def test_only_ranges_that_cover_all_on_one_side_are_joined() -> None:
    whole = [end(fmpq(0), fmpq(1, 4)), end(fmpq(1, 4), fmpq(1, 2))]
    assert joined(whole, fmpq(1, 2)) is not None
    assert proved_so_far(whole) == "; it is proved up to epsilon = 1/8"
    wrong = [
        [],
        whole[:1],
        whole[1:],
        [whole[0], end(fmpq(1, 4) + fmpq(1, 10**9), fmpq(1, 2))],
        [end(fmpq(1, 10**9), fmpq(1, 4)), whole[1]],
        [whole[0], replace(whole[1], side=-1)],
    ]
    for one in wrong:
        assert joined(one, fmpq(1, 2)) is None
    for one in (wrong[0], wrong[2], wrong[-1]):
        assert proved_so_far(one) == ""


def test_the_first_place_of_all_ranges() -> None:
    def entered(*places: int) -> Sequence[SideEnd]:
        return [replace(end(fmpq(0), fmpq(1)), entered=fmpq(place)) for place in places]

    assert first_entered([]) is None
    assert [first_entered(entered(*places)) for places in ((3,), (3, 2, 4), (2, 3))] == [3, 2, 2]


def test_the_time_by_which_it_has_happened() -> None:
    """mu = 3/2, delta = 1/4: 2 + log(3*8)/5; of two ranges the one in which delta lies, ends included."""
    ranges = [end(fmpq(0), fmpq(1, 4)), replace(end(fmpq(1, 4), fmpq(1, 2)), entered=fmpq(7))]
    with working_bits(128):
        lower, upper = ends(latest_at(ranges, fmpq(1, 64), fmpq(3, 2)))
        exact = 2 + arb(24).log() / 5
        assert lower <= Fraction(upper) < lower + Fraction(1, 2**60)
        assert exact <= arb(fmpq(upper.numerator, upper.denominator)) < exact + arb(2) ** -60
        assert latest_at(ranges, fmpq(1, 8), fmpq(3, 2)) > 7


@pytest.mark.parametrize("least", [fmpq(0), fmpq(1, 4)])
def test_no_time_where_nothing_is_proved(least: fmpq) -> None:
    ranges = [end(least, fmpq(1, 2))]
    assert latest_at(ranges, fmpq(1, 64), fmpq(1)).is_finite()
    for epsilon in (fmpq(0), fmpq(1, 7), fmpq(-1), *([fmpq(1, 65)] if least > 0 else [])):
        with pytest.raises(ValueError, match="nothing is proved"):
            latest_at(ranges, epsilon, fmpq(1))
