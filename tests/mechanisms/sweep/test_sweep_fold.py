"""Folds: the classical rod's at mu = 4/3, and others in closed form; where there is none, none is proved.

Page: proofs/sweep.md, section 6.
"""

from __future__ import annotations

import json
from dataclasses import replace
from fractions import Fraction
from typing import Any

import mpmath
import pytest
from flint import arb, fmpq
from samples.families import family

from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.parametric_system import parametric_system
from gspot_verified.mechanisms.sweep import sweep_fold
from gspot_verified.mechanisms.sweep.sweep import sweep
from gspot_verified.mechanisms.sweep.sweep_findings import equations
from gspot_verified.mechanisms.sweep.sweep_fold import (
    Fold,
    _as_far_as_both,
    _on_curve,
    _other_end,
    _widened,
    fold_next_to,
    turned,
    with_folds,
    without_gaps,
)
from gspot_verified.mechanisms.sweep.sweep_grid import Axis, Grid
from gspot_verified.mechanisms.sweep.sweep_piece import Kind, SweepPiece, TubeRecord
from gspot_verified.mechanisms.sweep.sweep_pieces import PieceStore, packed
from gspot_verified.mechanisms.sweep.sweep_result import _inner
from gspot_verified.mechanisms.sweep.sweep_start import Origin, proved_tube
from gspot_verified.mechanisms.zeros.tube import OnTube, Tube
from gspot_verified.numbers.balls import approximate, working_bits
from gspot_verified.numbers.dyadic import Dyadic

ROD = "falling rod of Génot and Brogliato"


@pytest.mark.parametrize("over", ["1.2..2:16", "4/3..2:7", "1.3..1.4:1", "4/3..1.34:1"])
def test_the_rod_has_its_fold_at_four_thirds(over: str) -> None:
    """tan θ = 2 there, and θ' = 5^(1/4) (L = g = 1)."""
    result = sweep(shipped_mechanism(ROD), {"mu": over})
    (fold,) = result.folds
    assert fold.value.contains(Fraction(4, 3))
    lower, upper = fold.value.endpoints()
    assert upper - lower < Fraction(1, 10**15)
    assert fold.opens == 1
    point = dict(fold.point)
    with mpmath.workdps(40):
        for word, expected in (("theta", mpmath.atan(2)), ("theta_dot", mpmath.mpf(5) ** 0.25)):
            ends = [mpmath.mpf(end.numerator) / end.denominator for end in point[word].endpoints()]
            assert ends[0] < expected < ends[1]
            assert ends[1] - ends[0] < 1e-11


def test_an_angle_at_a_fold_is_counted_from_zero() -> None:
    """The rod's file counts its angle from one with the sine 3/5: at the fold tan θ = 2, not tan (θ - θ_ref)."""
    (fold,) = sweep(shipped_mechanism("rod"), {"mu": "1.3..2.1:4"}).folds
    assert dict(fold.point)["theta"].contains(Fraction(11071487177940905, 10**16))  # atan 2, to 16 digits
    assert "theta = [1.1071487177" in str(fold)


def test_the_pieces_behind_the_fold_say_so_and_no_more() -> None:
    result = sweep(shipped_mechanism(ROD), {"mu": "1.2..1.5:6"})
    first, second = result.pieces[:2]
    assert (first.kind, second.kind) == (Kind.BEYOND, Kind.FOLD)
    assert first.lower == (fmpq(6, 5),)
    assert first.upper == second.lower
    assert second.holds([fmpq(4, 3)]) or first.holds([fmpq(4, 3)])
    assert first.case is second.case is None
    assert all(piece.lower[0] > fmpq(4, 3) for piece in result.pieces[2:])
    assert result.at(mu="1.3").kind is Kind.BEYOND


def test_what_a_text_says_of_a_range_holds_in_all_of_it() -> None:
    """Its ends are rounded: "no more" up to 1.3333333333333334 would hold of values above the fold at 4/3, too."""
    result = sweep(shipped_mechanism(ROD), {"mu": "1.2..2:16"})
    lines = str(result).splitlines()
    (gone,) = [line for line in lines if "the continued spot is no more" in line]
    assert gone.startswith("  mu in [6/5, 1.3333333333333333]: ")
    settled = [range_ for *range_, piece in result.stretches() if piece.kind is Kind.SETTLED]
    shown = [line.partition(" in [")[2].partition("]")[0].split(", ") for line in lines if "Case" in line][-2:]
    assert len(settled) == len(shown)
    for (lower, upper), (left, right) in zip(settled, shown, strict=True):
        assert lower <= fmpq(Fraction(left).numerator, Fraction(left).denominator)
        assert fmpq(Fraction(right).numerator, Fraction(right).denominator) <= upper


def test_a_fold_says_how_far_the_two_spots_were_followed() -> None:
    """Without an end, "for larger mu" would be a statement on all of them."""
    found = sweep(shipped_mechanism("genot_brogliato_rod"), {"mu": "6/5..2:4"})
    (fold,) = found.folds
    assert f"they are there for larger mu, as far as {fold.reach}; " in str(fold)
    assert fold.reach < 2
    said = "of the continued G-spot with X, X_dot fixed, or that it is no more, for every mu in [6/5, 2], except"
    assert said in found.verdict.statement


def test_a_range_too_short_to_be_rounded_inward_is_exact() -> None:
    third = fmpq(1, 3)
    assert _inner(third, third + fmpq(1, 10**16)) == f"[1/3, {third + fmpq(1, 10**16)}]"
    assert _inner(third + fmpq(1, 10**13), fmpq(2, 3) + fmpq(1, 10**13)) == "[0.3333333333334334, 0.6666666666667666]"


@pytest.mark.parametrize(
    ("p", "start", "over", "opens", "value", "q"),
    [
        ("q^2 - k", "1", "-1/2..1:5", 1, 0, 0),
        ("q^2 - k", "-1", "-1/3..1:5", 1, 0, 0),
        ("q^2 + k - 2", "1", "1/2..3:7", -1, 2, 0),
        ("q^2 - 2*q + 1/3 - k", "3", "-1..2:4", 1, Fraction(-2, 3), 1),
    ],
)
def test_folds_of_parabolas(p: str, start: str, over: str, opens: int, value: Fraction, q: int) -> None:
    result = sweep(family(p, start), {"k": over})
    (fold,) = result.folds
    assert fold.opens == opens
    assert fold.value.contains(value)
    assert dict(fold.point)["q"].contains(q)
    for piece in result.pieces:
        there = (piece.lower[0] > fmpq(Fraction(value).numerator, Fraction(value).denominator)) == (opens > 0)
        if piece.kind in (Kind.SETTLED, Kind.CROSSING, Kind.OPEN):
            assert there


@pytest.mark.parametrize(
    ("p", "start", "over"),
    [
        ("q^3 - k", "1", "-1..1:4"),  # an inflection: the branch goes on, f_ξ is singular at k = 0
        ("q*(q - k)", "0", "-1..1:3"),  # two branches cross
        ("q^3 - k*q", "0", "-1..1:3"),  # a pitchfork
        ("(q^2 - k)^2", "1", "-1..1:2"),  # never regular
    ],
)
def test_what_is_no_fold_is_not_called_one(p: str, start: str, over: str) -> None:
    if p.startswith("("):
        with pytest.raises(ValueError, match=r"degenerate|no G-spot"):
            sweep(family(p, start), {"k": over})
        return
    result = sweep(family(p, start), {"k": over})
    assert result.folds == ()
    assert result.verdict.exit_code == 2
    assert not any(piece.kind in (Kind.FOLD, Kind.BEYOND) for piece in result.pieces)
    at_zero = [piece for piece in result.pieces if piece.holds([fmpq(0)])]
    assert {piece.kind for piece in at_zero} <= {Kind.NO_TUBE, Kind.OPEN}


def test_sides_accumulate_at_a_fold() -> None:
    """q = sqrt(k): beta = 3/(4 sqrt(k)) passes every integer before the fold at k = 0; what is said is right."""
    result = sweep(family("q^2 - k", "1"), {"k": "-1/10..1:11"}, digits=8)
    (fold,) = result.folds
    assert fold.value.contains(0)
    known = {crossing.quantity: crossing for crossing in result.crossings}
    for n in (2, 3, 4):
        crossing = known[f"beta - {n}"]
        assert crossing.proved
        assert crossing.lower < fmpq(9, 16 * n * n) < crossing.upper
    assert known["alpha_3 - alpha_1"].lower < fmpq(9, 16) < known["alpha_3 - alpha_1"].upper
    for piece in result.pieces:
        if piece.kind is not Kind.SETTLED:
            continue
        for value in (piece.lower[0], piece.middle[0], piece.upper[0]):
            beta_squared = fmpq(9, 16) / value
            if piece.case == "I":
                assert beta_squared < 1
            else:
                n = next(n for n in range(1, 10**6) if (n + 1) ** 2 > beta_squared)
                assert piece.case == "III"
                assert n >= 1
                assert piece.lift_off_sign == (-1 if n % 2 else 1)


def test_a_spot_must_lie_on_the_curve_with_its_tangent() -> None:
    """p = q^2 - k as a curve over q: (x, u, y, v, b) = (0, 1, 0, 0, 0), k = q^2, and the tangent (0, ..., 0, 2 q)."""
    system = parametric_system(family("q^2 - k", "1"), ["k"], ["x", "u"])
    curve = turned(system, 4)

    def known(k: arb, slope: arb, u: int = 1) -> list[arb]:
        return [arb(0), arb(u), arb(0), arb(0), arb(0), k, *[arb(0)] * 5, slope]

    start = Origin((fmpq(0),), tuple(fmpq(int(i == 1)) for i in range(12)), (*[(fmpq(0),)] * 11, (fmpq(2),)))
    with working_bits(80):
        on = proved_tube(curve, (fmpq(-1, 8),), (fmpq(1, 8),), start)
        assert on is not None
        tube = _widened(curve, on).tube
        q = arb("0.1")
        assert _on_curve(tube, q, known(q * q, 2 * q))
        assert not _on_curve(tube, q, known(q * q, -2 * q))
        assert not _on_curve(tube, q, known(q * q + 1, 2 * q))
        assert not _on_curve(tube, q, known(q * q, 2 * q, u=2))
        assert not _on_curve(tube, arb("0.2"), known(arb("0.04"), arb("0.4")))
        assert not _on_curve(tube, arb("nan"), known(q * q, 2 * q))


def test_the_direction_of_the_curve_is_not_that_of_the_tubes_line(monkeypatch: pytest.MonkeyPatch) -> None:
    """q = sqrt(k) on [1/8, 1/4]: the curve folds at k = 0, however its derivative is split between line and rest."""
    system = parametric_system(family("q^2 - k", "1"), ["k"], ["x", "u"])
    centre = tuple(map(arb, (0, 1, 0, 0, "0.4375", 0)))
    wide = tuple(arb(0, "0.125") for _ in centre)
    level = Tube((fmpq(1, 8),), (fmpq(1, 4),), centre, tuple((arb(0),) for _ in centre), wide, wide)
    elsewhere = replace(level, centre=tuple(-value for value in centre))
    calls = []

    def bent(*given: Any) -> OnTube | None:
        calls.append(given)
        on = proved_tube(*given)
        if on is None or len(calls) > 1:
            return on
        slopes = tuple((slope - 1,) for (slope,) in on.tube.slopes)
        return replace(on, tube=replace(on.tube, slopes=slopes), turning=[[turn + 1] for (turn,) in on.turning])

    monkeypatch.setattr(sweep_fold, "proved_tube", bent)
    with working_bits(80):
        fold = fold_next_to(system, equations(system), level, fmpq(1, 8), 8)
        calls.clear()
        assert fold_next_to(system, equations(system), elsewhere, fmpq(1, 8), 8) is None
    assert fold is not None
    assert fold.value.contains(0)
    assert (fold.opens, fold.reach) == (1, fmpq(1, 8))


def test_both_spots_are_there_as_far_as_the_fold_says() -> None:
    """k(q) = e^q - q - 1 - e^(-20 (q + 8/5))/1000 has its largest value for q < 0, 0.91, near q = -1.78: the one spot
    is there up to k = 1.19 and beyond, the other is not. Only the one was asked how far it goes."""
    p = "exp(q) - q - 1 - exp(-20*(q + 8/5))/1000 - k"
    mechanism = family(p, "11/10")
    system = parametric_system(mechanism, ["k"], ["x", "u"])
    end = fmpq(119, 100)
    with working_bits(80):
        rate = fmpq(1, 2)  # nearly dq/dk there
        centre = tuple(fmpq(1) if i == 1 else fmpq(0) for i in range(4))
        near = Origin((end,), (*centre, fmpq(109, 100), fmpq(0)), (*[(fmpq(0),)] * 4, (rate,), (fmpq(0),)))
        last = proved_tube(equations(system), (end,), (end + fmpq(1, 100),), near)
        assert last is not None
        fold = fold_next_to(system, equations(system), last.tube, end, 8)
    assert fold is not None
    assert fold.value.contains(0) or abs(approximate(fold.value.to_ball())) < 1e-10
    assert fold.opens == 1
    assert fmpq(1, 2) < fold.reach < fmpq(9, 10)


@pytest.mark.parametrize(("bounds", "opens", "other", "reach"), [
    ((-1, 1), 1, arb(3, 1), fmpq(2)),
    ((-1, 1), 1, arb(30, 1), fmpq(8)),
    ((-1, 1), -1, arb(-3, 1), fmpq(-2)),
    ((-1, 1), -1, arb(-30, 1), fmpq(-8)),
    ((-1, 1), 1, arb(1, 1), None),
    ((-1, 1), -1, arb(0, 1), None),
])  # fmt: skip
def test_the_reach_is_that_of_both(bounds: tuple[int, int], opens: int, other: arb, reach: fmpq | None) -> None:
    known = Fold("k", Dyadic(*bounds, -2), opens, fmpq(8 * opens), ())
    found = _as_far_as_both(known, other)
    if reach is None:
        assert found is None
    else:
        assert found is not None
        assert abs(found.reach - reach) < fmpq(1, 1000)
        assert found.reach * opens <= reach * opens


def test_the_other_end_is_across_the_fold_and_on_the_curve(monkeypatch: pytest.MonkeyPatch) -> None:
    """k = q^2 on [-1/8, 1/8]: entered at q = 1/10 the other end is q = -1/8, and entered at -1/10 it is 1/8."""
    curve = turned(parametric_system(family("q^2 - k", "1"), ["k"], ["x", "u"]), 4)
    start = Origin((fmpq(0),), tuple(fmpq(int(i == 1)) for i in range(12)), (*[(fmpq(0),)] * 11, (fmpq(2),)))
    fold = (fmpq(-1, 1000), fmpq(1, 1000))
    with working_bits(80):
        on = proved_tube(curve, (fmpq(-1, 8),), (fmpq(1, 8),), start)
        assert on is not None
        for q, slope in ((arb("0.1"), fmpq(-1, 4)), (arb("-0.1"), fmpq(1, 4))):
            end = _other_end(curve, on, q, fold)
            assert end is not None
            assert abs(end[5] - fmpq(1, 64)) < 1e-12
            assert abs(end[11] - slope) < 1e-12
        for q in (arb(0), arb(0, "0.01"), arb("0.1", "0.2"), arb("nan")):
            assert _other_end(curve, on, q, fold) is None
        away = replace(on, tube=replace(on.tube, centre=tuple(value + 1 for value in on.tube.centre)))
        monkeypatch.setattr(sweep_fold, "proved_tube", lambda *_: away)
        assert _other_end(curve, on, arb("0.1"), fold) is None


@pytest.mark.parametrize("size", [0.0, 1.0])
def test_no_fold_hangs_on_the_component_that_is_followed(monkeypatch: pytest.MonkeyPatch, size: float) -> None:
    """The component is chosen by floats; another one gives the same fold, or none."""
    monkeypatch.setattr("gspot_verified.mechanisms.sweep.sweep_fold.approximate", lambda _: size)
    for fold in sweep(family("q^2 + k - 2", "1"), {"k": "1/2..3:7"}).folds:
        assert fold.opens == -1
        assert fold.value.contains(2)


# The ends of a continued spot on a line: what lies behind a fold says so, and no more. Page: proofs/sweep.md.


SYSTEM = parametric_system(family("q^2 - k", "1"), ["k"], ["x", "u"])
Plain = list[tuple[int | fmpq, int | fmpq, Kind]]


def piece(lower: int, upper: int, kind: Kind = Kind.SETTLED) -> SweepPiece:
    box = (fmpq(lower),), (fmpq(upper),)
    tube = Tube(*box, (arb(lower),), ((arb(0),),), (arb(0, 1),), (arb(0, 1),))
    return SweepPiece(*box, kind, record=None if kind is Kind.NO_TUBE else TubeRecord.of(tube))


LINE = [
    piece(-1, 0, Kind.OPEN), piece(0, 1, Kind.NO_TUBE), piece(1, 2, Kind.OPEN), piece(2, 3), piece(3, 4), piece(4, 5),
    piece(5, 6), piece(6, 7),
]  # fmt: skip


def stored(line: list[SweepPiece]) -> PieceStore:
    store = PieceStore(Grid((Axis("k", fmpq(-1), fmpq(7), 1),)))
    store.add(packed([line]))
    return store


def folded(line: list[SweepPiece], own: list[int]) -> tuple[list[SweepPiece], list[Fold]]:
    store = stored(line)
    mine = [number in own for number in range(len(line))]
    order, folds = with_folds(SYSTEM, equations(SYSTEM), store, range(len(line)), mine, 7)
    return [store[number] for number in order], folds


def after(folds: dict[int, Fold], own: list[int], monkeypatch: pytest.MonkeyPatch) -> tuple[Plain, list[Fold]]:
    """The line's pieces when behind these ends there are these folds; which tube is asked for is checked."""

    def given(system: Any, _: Any, tube: Tube, end: fmpq, digits: int) -> Fold | None:
        assert (system, digits) == (SYSTEM, 7)
        assert end in (tube.lower[0], tube.upper[0])
        assert tube.lower[0] == LINE[min(own) if end == LINE[min(own)].lower[0] else max(own)].lower[0]
        return folds.get(int(end.p))

    monkeypatch.setattr(sweep_fold, "fold_next_to", given)
    pieces, found = folded(LINE, own)
    return [(one.lower[0], one.upper[0], one.kind) for one in pieces], found


def fold(lower: int, upper: int, opens: int, reach: int) -> Fold:
    """Between these quarters."""
    return Fold("k", Dyadic(lower, upper, -2), opens, fmpq(reach), ())


OWN: Plain = [(2, 3, Kind.SETTLED), (3, 4, Kind.SETTLED)]
BEFORE: Plain = [(-1, 0, Kind.OPEN), (0, 1, Kind.NO_TUBE), (1, 2, Kind.OPEN)]
AFTER: Plain = [(4, 5, Kind.SETTLED), (5, 6, Kind.SETTLED), (6, 7, Kind.SETTLED)]


def test_no_fold_leaves_the_pieces_as_they_are(monkeypatch: pytest.MonkeyPatch) -> None:
    assert after({}, [3, 4], monkeypatch) == ([*BEFORE, *OWN, *AFTER], [])
    assert after({2: fold(6, 7, 1, 2)}, [], monkeypatch) == ([*BEFORE, *OWN, *AFTER], [])


def test_before_a_fold_that_opens_upwards_there_is_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """The spots meet in [3/2, 7/4]: below 3/2 there is none of the two, between it and the tube they may or may not."""
    known = fold(6, 7, 1, 2)
    pieces, folds = after({2: known}, [3, 4], monkeypatch)
    assert pieces == [(-1, fmpq(3, 2), Kind.BEYOND), (fmpq(3, 2), 2, Kind.FOLD), *OWN, *AFTER]
    assert folds == [known]


def test_behind_a_fold_that_opens_downwards_there_is_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    known = fold(17, 18, -1, 4)
    pieces, folds = after({4: known}, [3, 4], monkeypatch)
    assert pieces == [*BEFORE, *OWN, (4, fmpq(9, 2), Kind.FOLD), (fmpq(9, 2), 7, Kind.BEYOND)]
    assert folds == [known]


def test_both_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    low, high = fold(6, 7, 1, 2), fold(17, 18, -1, 4)
    pieces, folds = after({2: low, 4: high}, [3, 4], monkeypatch)
    assert [kind for *_, kind in pieces] == [Kind.BEYOND, Kind.FOLD, Kind.SETTLED, Kind.SETTLED, Kind.FOLD, Kind.BEYOND]
    assert folds == [low, high]


def test_a_fold_that_opens_to_the_other_side_is_another_one(monkeypatch: pytest.MonkeyPatch) -> None:
    wrong = {2: fold(6, 7, -1, 2), 4: fold(17, 18, 1, 4)}
    assert after(wrong, [3, 4], monkeypatch) == ([*BEFORE, *OWN, *AFTER], [])


@pytest.mark.parametrize(("low", "high"), [(-8, 3), (-4, 2), (-12, -8), (8, 9)])
def test_a_fold_at_an_end_of_the_range_leaves_no_piece_behind_it(
    low: int, high: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The range is [-1, 2]: the fold is said to be in it, and no piece is empty."""
    pieces, _ = after({2: fold(low, high, 1, 2)}, [3, 4], monkeypatch)
    assert pieces == [(-1, 2, Kind.FOLD), *OWN, *AFTER]


@pytest.mark.parametrize("opens", [1, -1])
def test_an_end_of_the_line_has_nothing_behind_it(opens: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sweep_fold, "fold_next_to", lambda *_: fold(6, 7, opens, 2))
    line = [piece(0, 1), piece(1, 2)]
    assert folded(line, [0, 1]) == (line, [])


def test_a_piece_without_a_tube_has_no_fold_next_to_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sweep_fold, "fold_next_to", lambda *_: fold(6, 7, 1, 2))
    line = [piece(0, 1), piece(1, 2, Kind.NO_TUBE), piece(2, 3)]
    assert folded(line, [1]) == (line, [])


def test_neighbours_without_a_tube_are_one_piece() -> None:
    none, settled = Kind.NO_TUBE, Kind.SETTLED
    kinds = [settled, none, none, none, Kind.OPEN, Kind.OPEN, none, none, settled, settled, none]
    store = stored([piece(i, i + 1, kind) for i, kind in enumerate(kinds)])
    found = [store[number] for number in without_gaps(store, range(len(kinds)))]
    assert [(one.lower[0], one.upper[0], one.kind) for one in found] == [
        (0, 1, settled), (1, 4, none), (4, 5, Kind.OPEN), (5, 6, Kind.OPEN), (6, 8, none), (8, 9, settled),
        (9, 10, settled), (10, 11, none),
    ]  # fmt: skip
    assert json.loads(json.dumps([one.to_json() for one in found]))
