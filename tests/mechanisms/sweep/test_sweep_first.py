"""The spot that a sweep begins with: by its number, or the only one; two spots that meet at a fold agree on it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from flint import fmpq
from samples.families import family

from gspot_verified.expansion.series.system import GSpotError
from gspot_verified.functions.expressions import Constant
from gspot_verified.mechanisms.formulas.symbol import Symbol
from gspot_verified.mechanisms.input.mechanism import Mechanism, Place
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.g_spot import GSpot
from gspot_verified.mechanisms.sweep import sweep_first
from gspot_verified.mechanisms.sweep.sweep import sweep
from gspot_verified.mechanisms.sweep.sweep_first import first_spot, with_place_of
from gspot_verified.mechanisms.sweep.sweep_piece import Kind


@pytest.fixture
def rod() -> Mechanism:
    """Without a place: four G-spots at mu = 2."""
    return replace(shipped_mechanism("genot_brogliato_rod"), place=Place())


def test_two_spots_meet_at_the_same_fold(rod: Mechanism) -> None:
    """Numbers 1 and 4 have the same sign of θ'; tan θ is the smaller and the larger root of T^2 - 3 μ T + 4."""
    first, fourth = (sweep(rod, {"mu": "1.3..2:14"}, spot=number) for number in (1, 4))
    for name in ("theta", "theta_dot", "Y"):
        points = [dict(result.folds[0].point)[name] for result in (first, fourth)]
        assert points[0].overlaps(points[1])
    assert first.folds[0].value.overlaps(fourth.folds[0].value)
    answers = [{piece.case for piece in result.pieces if piece.kind is Kind.SETTLED} for result in (first, fourth)]
    assert answers == [{"none", "II"}, {"none"}]
    for place in (fmpq(2), fmpq(3, 2)):
        tubes = [next(piece for piece in result.pieces if piece.holds([place])).tube() for result in (first, fourth)]
        assert tubes[0] is not None
        assert tubes[1] is not None
        assert not tubes[0].holds_at((place,), tubes[1].zero_at((place,)))


def test_several_spots_must_be_chosen_from(rod: Mechanism) -> None:
    with pytest.raises(ValueError, match=r"choose one by its number, spot=1(.|\n)*G-spot 4"):
        sweep(rod, {"mu": "1.4..2:3"})
    for number in (0, 5, True, "1"):
        with pytest.raises(ValueError, match=r"a number in 1\.\.4"):
            sweep(rod, {"mu": "1.4..2:3"}, spot=number)  # type: ignore[arg-type]


def test_a_number_is_of_the_list_also_where_the_mechanism_names_a_place() -> None:
    """At the place is the second of four; tan θ of the fourth is the larger root."""
    mechanism = shipped_mechanism("genot_brogliato_rod", mu=2)
    at_the_place, fourth = first_spot(mechanism, None), first_spot(mechanism, 4)
    theta = mechanism.state.index("theta")
    assert fourth.system.point[theta] > at_the_place.system.point[theta]


def test_the_only_spot_need_not_be_chosen() -> None:
    """p = q - k has one spot; the model system's x and u are free, and 0 where nothing is said."""
    mechanism = family("q - k", "0", "0")
    bare = replace(mechanism, place=Place(values=(), fixed=None))
    result = sweep(bare, {"k": "-1/4..1/4:4"})
    assert [piece.case for piece in result.pieces] == ["III"] * 4
    assert [piece.case for piece in sweep(mechanism, {"k": "-1/4..1/4:4"}).pieces] == ["III"] * 4
    assert result.spot["u"] == "0"
    assert result.warnings[0].startswith("u <= 0 at the G-spot on 4 pieces")


def test_where_there_is_none_the_proof_is_in_the_message(rod: Mechanism) -> None:
    """Below μ = 4/3 the rod has no G-spot: with a place and without."""
    for mechanism in (shipped_mechanism("genot_brogliato_rod"), rod):
        with pytest.raises(
            GSpotError, match=r" has no G-spot in the region \(refuted that there is one\): every angle theta"
        ):
            sweep(mechanism, {"mu": "1..1.2:3"})


def test_where_nothing_is_found_at_the_place_the_only_spot_is_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(_: Mechanism) -> GSpot:
        raise GSpotError("nothing found there")

    monkeypatch.setattr(sweep_first, "find_g_spot", fails)
    result = sweep(family("q - k", "0", "0"), {"k": "-1/4..1/4:2"})
    assert {piece.case for piece in result.pieces} == {"III"}
    with pytest.raises(ValueError, match=r"nothing found there: choose one(.|\n)*G-spot 4"):
        sweep(shipped_mechanism("genot_brogliato_rod"), {"mu": "1.4..2:3"})


@pytest.mark.parametrize(
    ("count", "complete", "taken"), [(1, True, True), (1, False, False), (2, True, False), (2, False, False)]
)
def test_the_only_spot_is_one_beside_which_there_is_certainly_none(
    monkeypatch: pytest.MonkeyPatch, rod: Mechanism, count: int, complete: bool, taken: bool
) -> None:
    """At a place that is not named nothing is looked for."""

    def asked(_: Mechanism) -> GSpot:
        raise AssertionError("there is no place")

    found = SimpleNamespace(spots=list(range(1, count + 1)), complete=complete, spot=lambda number: f"spot {number}")
    monkeypatch.setattr(sweep_first, "find_g_spot", asked)
    monkeypatch.setattr(sweep_first, "find_g_spots", lambda _: found)
    assert first_spot(rod, count) == f"spot {count}"  # type: ignore[comparison-overlap]
    if taken:
        assert first_spot(rod, None) == "spot 1"  # type: ignore[comparison-overlap]
    else:
        with pytest.raises(ValueError, match="choose one by its number"):
            first_spot(rod, None)


def test_what_the_place_lacks_is_that_of_the_spot() -> None:
    """An angle is counted from its reference; what is given stays, what is not fixed is left out."""
    mechanism = shipped_mechanism("rod")
    (angle,) = mechanism.angles
    words = mechanism.state
    point = [fmpq(k + 1, 3) for k in range(len(words))]
    others = [word for word in words if word != angle.coordinate]
    given = replace(mechanism, place=Place(values=((others[0], Constant(fmpq(7))),)))
    fixed = (others[0], others[1], angle.coordinate)
    spot: Any = SimpleNamespace(system=SimpleNamespace(point=point), fixed=fixed)
    number = {word: Constant(value) for word, value in zip(words, point, strict=True)}
    assert dict(with_place_of(given, spot).place.values) == {
        others[0]: Constant(fmpq(7)),
        others[1]: number[others[1]],
        angle.coordinate: Symbol(angle.name) + number[angle.coordinate],
    }


def test_a_journal_is_of_one_spot(rod: Mechanism, tmp_path: Path) -> None:
    path = tmp_path / "journal"
    sweep(rod, {"mu": "1.4..2:3"}, spot=2, journal=path)
    with pytest.raises(ValueError, match="not a journal of this question"):
        sweep(rod, {"mu": "1.4..2:3"}, spot=4, journal=path)
