"""Sweeps against closed forms and against single classifications; what must stay undecided stays so.

Page: proofs/sweep.md, sections 2 to 5.
"""

from __future__ import annotations

import random
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.families import family

from gspot_verified import load
from gspot_verified.expansion.series.regularisation import NO_DAMPER, Regularisation
from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.shipped import shipped_mechanism, shipped_text
from gspot_verified.mechanisms.spots.classify import classify_g_spot
from gspot_verified.mechanisms.spots.g_spot import find_g_spot
from gspot_verified.mechanisms.sweep.sweep import sweep
from gspot_verified.mechanisms.sweep.sweep_piece import NUMBERS, Kind, SweepPiece
from gspot_verified.mechanisms.sweep.sweep_result import Sweep
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.signs.gamma.side import side
from gspot_verified.work.executors import executor

ROD = "falling rod of Génot and Brogliato"


def rational(value: Fraction | int) -> fmpq:
    return fmpq(Fraction(value).numerator, Fraction(value).denominator)


def covers(interval: Dyadic | None, value: Any) -> bool:
    """Containment of an mpmath number."""
    assert interval is not None
    lower, upper = (mpmath.mpf(end.numerator) / end.denominator for end in interval.endpoints())
    return bool(lower <= value <= upper)


def rod_by_hand(mu: Fraction) -> dict[str, Any]:
    """The rod with m = L = g = 1: l = 1/2, r^2 = 1/12, T = tan θ the smaller root of T^2 - 3 μ T + 4 = 0.

    p = 1 + 3 c^2 - 3 μ s c, b = -1 + s θ'^2/2, G_θ = 12 (μ s - c)/2, F_θ' = 0, u = X' - s θ'/2 with X' = 2.
    """
    friction = mpmath.mpf(mu.numerator) / mu.denominator
    tangent = (3 * friction - mpmath.sqrt(9 * friction**2 - 16)) / 2
    angle = mpmath.atan(tangent)
    s, c = mpmath.sin(angle), mpmath.cos(angle)
    speed = mpmath.sqrt(2 / s)
    first = (-6 * c * s - 3 * friction * (c**2 - s**2)) * speed
    second = c * speed**3 / 2
    third = -s * speed * 6 * (friction * s - c)
    return {
        "alpha_1": first, "alpha_2": second, "alpha_3": third, "beta": third / first,
        "mean_force": second / (third - first), "slip_velocity": 2 - s * speed / 2,
    }  # fmt: skip


def assert_tiles(result: Sweep) -> None:
    """On a line: the pieces follow each other from end to end."""
    (axis,) = result.axes
    assert result.pieces[0].lower == (axis.lower,)
    assert result.pieces[-1].upper == (axis.upper,)
    for first, second in zip(result.pieces, result.pieces[1:], strict=False):
        assert first.upper == second.lower
        assert first.lower < first.upper


@given(st.data())
@settings(max_examples=15, deadline=None)
def test_the_rod_against_its_closed_form(data: st.DataObject) -> None:
    lower = data.draw(st.fractions(Fraction(27, 20), 3, max_denominator=100))
    upper = lower + data.draw(st.fractions(Fraction(1, 100), 2, max_denominator=100))
    cells = data.draw(st.integers(1, 9))
    result = sweep(shipped_mechanism(ROD), {"mu": (lower, upper, cells)})
    assert_tiles(result)
    assert result.verdict.outcome is Outcome.PROVED
    with mpmath.workdps(50):
        boundary = 8 / (3 * mpmath.sqrt(3))
        for part in (0, 1, *data.draw(st.lists(st.fractions(0, 1, max_denominator=10**6), min_size=4, max_size=4))):
            mu = lower + (upper - lower) * Fraction(part)
            piece = result.at(mu=mu)
            for name, value in rod_by_hand(mu).items():
                if piece.number(name) is not None:
                    assert covers(piece.number(name), value), name
            if piece.kind is Kind.SETTLED:
                assert piece.case == ("II" if mpmath.mpf(mu.numerator) / mu.denominator > boundary else "none")


def test_the_rod_enters_case_ii_at_its_boundary() -> None:
    """μ = 8/(3 sqrt 3), where 27 μ^2 = 64."""
    result = sweep(shipped_mechanism(ROD), {"mu": "1.4..2:10"}, digits=14)
    (crossing,) = result.crossings
    assert crossing.quantity == "alpha_3 - alpha_1"
    assert crossing.proved
    assert 27 * crossing.lower**2 < 64 < 27 * crossing.upper**2
    assert crossing.upper - crossing.lower < fmpq(1, 10**13)
    assert [piece.case for _, _, piece in result.stretches() if piece.kind is Kind.SETTLED] == ["none", "II"]


@pytest.mark.parametrize("over", ["1.1..3.2:5", "3/2..5/2:2", "3/2..5/2:1", "1.9..3.1:12"])
def test_the_oscillator_switches_sides_at_integers(over: str) -> None:
    """Its parameter beta is β; integers lie inside cells and at their ends."""
    result = sweep(shipped_mechanism("oscillator"), {"beta": over})
    (axis,) = result.axes
    assert result.verdict.outcome is Outcome.PROVED
    theory = side(str(axis.lower), str(axis.upper))
    assert [crossing.quantity for crossing in result.crossings] == [f"beta - {n}" for n in theory.switches]
    for crossing, integer in zip(result.crossings, theory.switches, strict=True):
        assert crossing.proved
        assert crossing.lower < integer < crossing.upper
    for piece in result.pieces:
        inside = [
            part
            for part in theory.intervals
            if part.lower < Fraction(int(piece.middle[0].p), int(piece.middle[0].q)) < part.upper
        ]
        if piece.kind is Kind.SETTLED:
            assert (piece.case, piece.lift_off_sign, piece.impact_sign) == (
                "III", inside[0].lift_off_sign, inside[0].impact_sign,
            )  # fmt: skip
            assert not any(piece.holds([fmpq(n)]) for n in theory.switches)


@pytest.mark.parametrize("over", ["2..5/2:3", "3/2..2:3", "2..3:1"])
def test_an_integer_at_the_end_of_the_range_is_not_decided(over: str) -> None:
    result = sweep(shipped_mechanism("oscillator"), {"beta": over})
    assert result.verdict.outcome is Outcome.UNDECIDED
    for crossing in result.crossings:
        assert not crossing.proved
        assert crossing.upper - crossing.lower < fmpq(1, 10**11)
    for piece in result.pieces:
        assert piece.kind is not Kind.SETTLED or not (piece.holds([fmpq(2)]) or piece.holds([fmpq(3)]))


def test_an_integer_all_along_is_not_decided() -> None:
    """kappa does not change β = 2."""
    result = sweep(shipped_mechanism("oscillator", beta=2), {"kappa": "-1/2..1/2:4"})
    assert {(piece.kind, piece.unsure) for piece in result.pieces} == {(Kind.OPEN, ("beta - 2",))}
    assert result.verdict.outcome is Outcome.UNDECIDED


def classified(mechanism: Mechanism, **values: Fraction) -> tuple[list[arb], dict[str, Any], Any]:
    spot = find_g_spot(mechanism.with_parameters(**values))
    with working_bits(160):
        point = [arb(value) for value in spot.system.point]
    found = classify_g_spot(spot)
    return point, {name: getattr(found, name) for name in NUMBERS}, found


def assert_agrees(piece: SweepPiece, place: dict[str, Fraction], mechanism: Mechanism) -> None:
    """One classification at a point, by Newton's method and Krawczyk's test there, lies in the piece."""
    point, numbers, found = classified(mechanism, **place)
    tube = piece.tube()
    assert tube is not None
    with working_bits(160):
        assert tube.holds_at([rational(value) for value in place.values()], point)
        for name, value in numbers.items():
            interval = piece.number(name)
            if interval is not None and value is not None:
                exact = Dyadic.from_ball(arb(value))
                assert interval.contains_interval(exact), name
    if piece.kind is Kind.SETTLED:
        assert piece.answer == (found.case, found.lift_off_sign, found.impact_sign)


@pytest.mark.parametrize(
    ("name", "over"),
    [
        ("oscillator", {"beta": "1/2..4:6"}),
        ("oscillator", {"kappa": "-1..1:2"}),
        ("frictional impact oscillator, all parameters", {"c_psi": "1/4..1/2:3"}),
        ("frictional impact oscillator, all parameters", {"m_2": "9/10..11/10:2"}),
        (ROD, {"mu": "3/2..9:2"}),
        ("extended system", {"alpha_3": "-5..-1/2:3"}),
        ("oscillator", {"beta": "3/2..7/2:3", "kappa": "-1/2..1/2:2"}),
        (ROD, {"mu": "3/2..5/2:4", "g": "1/2..1:2"}),
    ],
)
def test_single_classifications_lie_in_the_pieces(name: str, over: dict[str, str]) -> None:
    mechanism = shipped_mechanism(name)
    result = sweep(mechanism, over)
    dice = random.Random(5)
    for piece in dice.sample(result.pieces, min(12, len(result.pieces))):
        assert piece.kind in (Kind.SETTLED, Kind.CROSSING, Kind.OPEN)
        part = [Fraction(dice.randrange(1001), 1000) for _ in piece.lower]
        place = {
            axis.name: Fraction(int(value.p), int(value.q))
            for axis, value in zip(
                result.axes,
                [low + (high - low) * rational(t) for low, high, t in zip(piece.lower, piece.upper, part, strict=True)],
                strict=True,
            )
        }
        assert_agrees(piece, place, mechanism)


def test_a_map_has_curves_of_crossings() -> None:
    result = sweep(shipped_mechanism("oscillator"), {"beta": "7/4..9/4:5", "kappa": "-1..1:3"})
    assert result.verdict.outcome is Outcome.PROVED
    area = fmpq(0)
    for piece in result.pieces:
        (left, low), (right, high) = piece.lower, piece.upper
        area += (right - left) * (high - low)
        if left <= 2 <= right:
            assert piece.kind is Kind.CROSSING
            assert piece.passing is not None
            assert (piece.passing.quantity, piece.passing.along, piece.passing.direction) == ("beta - 2", 0, 1)
        else:
            assert piece.kind is Kind.SETTLED
            assert piece.lift_off_sign == (-1 if right < 2 else 1)
    assert area == fmpq(1, 2) * 2


def test_without_a_damper_no_side_is_named() -> None:
    for name, over, case in ((ROD, {"mu": "2..2.1:1"}, "II"), ("oscillator", {"beta": "7/4..9/4:1"}, "III")):
        result = sweep(replace(shipped_mechanism(name), regularisation=Regularisation.of(1, 1, 0)), over)
        assert {(piece.kind, *piece.answer) for piece in result.pieces} == {(Kind.SETTLED, case, None, None)}
        assert f"Case {case}: no side: {NO_DAMPER}" in str(result)
        assert ": Case of the continued G-spot" in result.verdict.statement


def test_given_conditions_stand_in_the_statement(tmp_path: Path) -> None:
    """Without them "the continued G-spot" is one of infinitely many."""
    text = shipped_text("model system").replace('fixed = ["x", "u"]', 'conditions = ["x^2 + u^2 - 2", "x - u"]')
    (tmp_path / "model.toml").write_text(text.replace("\nx = 0\n", "\nx = 1\n"), encoding="utf-8")
    result = sweep(load(tmp_path / "model.toml"), {"alpha_3": "-9/5..-7/5:1"})
    assert ": Case and side of the continued G-spot with the given conditions J = 0 for every" in str(result)


def test_two_spots_close_by_are_not_mixed_up() -> None:
    """p = (q - k)(q - k - 1/1000): the sweep stays on q = k, though the other spot is near."""
    mechanism = family("(q - k)*(q - k - 1/1000)", "0", "0")
    result = sweep(mechanism, {"k": "-1/100..1/100:16"})
    held = 0
    for piece in result.pieces:
        tube = piece.tube()
        for value in (piece.lower[0], piece.upper[0]):
            if tube is not None and piece.kind is not Kind.OPEN:
                held += 1
                with working_bits(100):
                    spots = [[arb(0), arb(1), arb(0), arb(0), arb(value + gap), arb(0)] for gap in (0, fmpq(1, 1000))]
                    assert tube.holds_at((value,), spots[0])
                    assert not tube.holds_at((value,), spots[1])
    assert held == 2 * len(result.pieces)


def test_where_spots_cross_the_other_branch_is_not_taken() -> None:
    """p = q (q - k), from q = 0 at k = -1: behind the crossing at k = 0 nothing is claimed."""
    result = sweep(family("q*(q - k)", "0", "-1"), {"k": "-1..1:8"}, budget=30)
    assert result.verdict.outcome is Outcome.UNDECIDED
    for piece in result.pieces:
        if piece.lower[0] >= 0:
            assert piece.kind in (Kind.NO_TUBE, Kind.OPEN)
            assert piece.case is None
            if piece.kind is Kind.OPEN:
                assert piece.unsure == ("the continued spot",)


def test_without_a_mass_matrix_nothing_is_settled() -> None:
    result = sweep(shipped_mechanism(ROD), {"m": "-1..2:6"})
    for piece in result.pieces:
        if piece.lower[0] <= 0:
            assert piece.kind in (Kind.OPEN, Kind.NO_TUBE)
        if piece.lower[0] > fmpq(1, 2):
            assert piece.kind is Kind.SETTLED


def test_one_wide_cell() -> None:
    """μ from 1.4 to 1000 as one cell: it is divided until everything holds."""
    result = sweep(shipped_mechanism(ROD), {"mu": "1.4..1000:1"})
    assert_tiles(result)
    with mpmath.workdps(50):
        for mu in (Fraction(3, 2), Fraction(8), Fraction(200), Fraction(999)):
            piece = result.at(mu=mu)
            assert piece.case in ("none", "II", None)
            if piece.number("beta") is not None:
                assert covers(piece.number("beta"), rod_by_hand(mu)["beta"])


def test_the_same_for_any_number_of_workers() -> None:
    mechanism, over = shipped_mechanism("oscillator"), {"beta": "1/2..4:40", "kappa": "-1/2..1/2:2"}
    alone = sweep(mechanism, over)
    with executor(2) as pool:
        assert sweep(mechanism, over, executor=pool) == alone


def test_a_journal_goes_on_after_a_kill(tmp_path: Path) -> None:
    mechanism, over, path = shipped_mechanism(ROD), {"mu": "1.3..2:100"}, tmp_path / "journal"
    steps: list[tuple[int, int]] = []
    whole = sweep(mechanism, over, journal=path, progress=lambda done, of: steps.append((done, of)))
    assert steps[-1] == (100, 100)
    lines = path.read_text(encoding="utf-8").splitlines(keepends=True)
    assert len(lines) == 5
    path.write_text("".join(lines[:3]) + lines[3][:100], encoding="utf-8")
    assert sweep(mechanism, over, journal=path) == whole
    assert path.read_text(encoding="utf-8").splitlines(keepends=True) == lines
    with pytest.raises(ValueError, match="not a journal of this question"):
        sweep(mechanism, {"mu": "1.3..2:99"}, journal=path)


def test_csv_has_a_line_for_each_piece_with_outward_bounds() -> None:
    result = sweep(shipped_mechanism("oscillator"), {"beta": "9/4..11/4:3"})
    head, *lines = result.to_csv().splitlines()
    assert len(lines) == len(result.pieces) == 3
    row = dict(zip(head.split(","), lines[0].split(","), strict=True))
    assert (row["beta_lower_exact"], row["case"], row["lift_off_sign_of_C1"]) == ("9/4", "III", "1")
    number = result.pieces[0].number("mean_force")
    assert number is not None
    lower, upper = number.endpoints()
    assert Fraction(float(row["mean_force_lower"])) <= lower
    assert upper <= Fraction(float(row["mean_force_upper"]))


@pytest.mark.parametrize(
    ("over", "message"),
    [
        ({}, "one or two parameters"),
        ({"mu": "1..2", "m": "1..2", "g": "1..2"}, "one or two parameters"),
        ({"nu": "1..2"}, "no parameter 'nu'"),
        ({"mu": "2..1"}, "reversed"),
        ({"mu": "2"}, "below its upper end"),
        ({"mu": "1..inf"}, "finite"),
        ({"mu": "1..2:x"}, "lower..upper:cells"),
        ({"mu": "1..2:0"}, "number of cells"),
        ({"mu": ("1", "2", 2.5)}, "number of cells"),
        ({"mu": "1..2:10000000"}, "at most"),
    ],
)
def test_bad_ranges(over: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        sweep(shipped_mechanism(ROD), over)


def test_bad_input() -> None:
    rod = shipped_mechanism(ROD)
    with pytest.raises(MechanismError, match="float"):
        sweep(rod, {"mu": (1.4, 2)})  # type: ignore[dict-item]
    with pytest.raises(ValueError, match="digits"):
        sweep(rod, {"mu": "1.4..2"}, digits=0)
    with pytest.raises(ValueError, match="does not vary"):
        sweep(rod, {"mu": "1.4..2"}, start={"m": 1})
    with pytest.raises(ValueError, match="outside"):
        sweep(rod, {"mu": "1.4..2"}, start={"mu": 3})
    with pytest.raises(ValueError, match="G-spot"):
        sweep(rod, {"mu": "1..1.2"})
    with pytest.raises(MechanismError, match="without a value"):
        sweep(rod.with_parameters(g=None), {"mu": "1.4..2"})
    result = sweep(rod, {"mu": "1.4..2:2"})
    with pytest.raises(ValueError, match="needed"):
        result.at(mu=5)
    with pytest.raises(ValueError, match="needed"):
        result.at()
    with pytest.raises(TypeError, match="no truth value"):
        bool(result)


def test_negative_slip_is_swept_as_its_mirror_image() -> None:
    """The rod seen from behind is in the same Cases, with the same β; the result says that it was mirrored."""
    rod: dict[str, Any] = {
        "name": "rod", "coordinates": ["X", "Y", "theta"], "mass_matrix": [[1, 0, 0], [0, 1, 0], [0, 0, "1/3"]],
        "forces": [0, "-3/5", 0], "x": "X + cos(theta)", "y": "Y - sin(theta)", "mu": "mu", "parameters": {"mu": 2},
        "place": {"X": 0, "Y": "3/5", "theta": "2/3", "X_dot": 2, "Y_dot": "4/5", "theta_dot": 1},
        "search": True, "fixed": ["X", "X_dot"],
    }  # fmt: skip
    behind = rod | {"x": "X - cos(theta)", "slip": "negative", "place": rod["place"] | {"X_dot": -2}}
    one, other = (sweep(lagrangian(**given), {"mu": "3/2..2:5"}) for given in (rod, behind))
    assert one.notes == ()
    assert "mirrored" in other.notes[0]
    assert other.notes[0] in str(other)
    assert [piece.answer for piece in one.pieces] == [piece.answer for piece in other.pieces]
    for first, second in zip(one.pieces, other.pieces, strict=True):
        for name in ("beta", "mean_force", "slip_velocity"):
            number, its = first.number(name), second.number(name)
            assert (number is None) == (its is None)
            assert number is None or its is None or number.overlaps(its)
