"""Fates of whole cells against exact solutions, float runs and forged journals (proofs/fates.md)."""

from __future__ import annotations

import json
import random
from collections import Counter
from dataclasses import replace
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from flint import arb, fmpq
from samples.model_texts import model_text
from scipy.integrate import solve_ivp

from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.approach.slip_state import StateError
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.fates.box_fate import Fate
from gspot_verified.mechanisms.fates.fate_piece import FatePiece
from gspot_verified.mechanisms.fates.fates import fates
from gspot_verified.mechanisms.fates.fates_result import Fates
from gspot_verified.mechanisms.fates.planar_flow import PlanarFlow
from gspot_verified.mechanisms.fates.prepared import _side
from gspot_verified.mechanisms.fates.reference import reference
from gspot_verified.mechanisms.fates.strip import strip
from gspot_verified.mechanisms.input.file import parse_mechanism
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.load import load
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.g_spot import place_in, prove_near
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome

BETA = 8 / 5
ALPHA_2_CHANGES_ITS_SIGN = model_text('"u", 0, "v", "b", -1, "-1 + 8*p"', "alpha_3", 'alpha_3 = "-8/5"')


@cache
def family() -> Mechanism:
    return parse_mechanism(ALPHA_2_CHANGES_ITS_SIGN)


@cache
def line_of_the_family() -> Fates:
    return fates(family(), {"x": 0, "u": "9/4", "p": "1/2"}, {"b": "-13/2..-1/8:48"})


def canard(p: float) -> float:
    """b on the distinguished trajectory: p db/dp = p - 8 p^2 + beta b has the polynomial solution."""
    return p / (1 - BETA) - 8 * p * p / (2 - BETA)


def exact_fate(p: float, b: float, u: float) -> Fate:
    """From b = canard + C p^beta and du/dp = -b/p, in closed form, on a fine grid."""
    c = (b - canard(p)) / p**BETA
    q = p * np.linspace(1, 0, 4001)[:-1]
    b_there = canard(q) + c * q**BETA  # type: ignore[arg-type]

    def integral(at: Any) -> Any:
        return at / (1 - BETA) - 4 * at**2 / (2 - BETA) + c * at**BETA / BETA

    u_there = u + integral(p) - integral(q)
    opens, sticks = (np.flatnonzero(event) for event in (b_there >= 0, u_there <= 0))
    first_open, first_stick = (found[0] if len(found) else len(q) for found in (opens, sticks))
    if first_open < first_stick:
        return Fate.LIFT_OFF
    if first_stick < first_open:
        return Fate.STOPS
    return Fate.ABOVE if c > 0 else Fate.BELOW


def inside(piece: FatePiece, chance: random.Random) -> list[float]:
    return [chance.uniform(float(low.p) / float(low.q), float(high.p) / float(high.q))
            for low, high in zip(piece.lower, piece.upper, strict=True)]  # fmt: skip


def compared(result: Fates, p: float | None, u: float) -> Counter[Fate]:
    """The fates of the pieces, each compared with exact ones of random states in it."""
    chance, seen = random.Random(29), Counter[Fate]()
    for piece in result.pieces:
        seen[piece.fate] += 1
        allowed = {Fate.BELOW, Fate.ABOVE} if piece.fate is Fate.SPOT else {piece.fate}
        for _ in range(6):
            values = inside(piece, chance)
            place = (p, values[0]) if p is not None else (values[0], values[1])
            assert piece.fate is Fate.UNDECIDED or exact_fate(*place, u) in allowed, piece
    return seen


def test_cells_of_a_line_against_the_exact_solution() -> None:
    seen = compared(line_of_the_family(), 0.5, 9 / 4)
    assert {Fate.ABOVE, Fate.STOPS, Fate.LIFT_OFF} <= set(seen), seen
    assert line_of_the_family().shares[Fate.UNDECIDED.value] < fmpq(1, 2)


@pytest.mark.slow
@pytest.mark.parametrize(("u", "expected"), [("50", {Fate.BELOW, Fate.ABOVE, Fate.LIFT_OFF}), ("9/4", {Fate.STOPS})])
def test_cells_of_a_map_against_the_exact_solution(u: str, expected: set[Fate]) -> None:
    result = fates(family(), {"x": 0, "u": u}, {"p": "3/8..1/2:16", "b": "-7..-1/16:40"})
    seen = compared(result, None, float(Fraction(u)))
    assert expected <= set(seen), seen


def test_no_cell_on_the_canard_has_a_sign() -> None:
    """C_1 = 0 on the distinguished trajectory: whatever cell holds a state of it, its sign is not certain."""
    assert line_of_the_family().at(b=fmpq(-5, 6) - 5).fate in (Fate.SPOT, Fate.UNDECIDED, Fate.STOPS)


@pytest.mark.slow
def test_no_cell_of_a_map_on_the_canard_has_a_sign() -> None:
    result = fates(family(), {"x": 0, "u": 50}, {"p": "1/8..1/4:4", "b": "-2..-1/4:14"})
    for k in range(40):
        p = fmpq(1, 8) + fmpq(k, 320)
        b = -5 * p / 3 - 20 * p * p
        assert result.at(p=p, b=b).fate in (Fate.SPOT, Fate.UNDECIDED)
    assert {Fate.BELOW, Fate.ABOVE} <= {piece.fate for piece in result.pieces}


def test_what_is_no_start() -> None:
    result = fates(family(), {"x": 0, "u": 2, "b": "1/4"}, {"p": (fmpq(-3, 8), fmpq(3, 8), 4)})
    assert [piece.fate for piece in result.pieces if piece.fate is not Fate.UNDECIDED] == [Fate.PAINLEVE, Fate.OPENS]
    result = fates(family(), {"x": 0, "u": -2, "b": 1}, {"p": "1/4..1/2:2"})
    assert {piece.fate for piece in result.pieces} == {Fate.NO_SLIP}
    assert result.verdict.outcome is Outcome.PROVED


ROD = """
format = 1
name = "rod"
[lagrangian]
coordinates = ["X", "Y", "theta"]
mass_matrix = [[1, 0, 0], [0, 1, 0], [0, 0, "MASS"]]
forces = [0, "-3/5", 0]
[angles.theta]
sine = "3/5"
cosine = "4/5"
[contact]
x = "X + cos(theta)"
y = "Y - sin(theta)"
mu = "MU"
[g_spot]
search = true
fixed = ["X", "X_dot"]
[g_spot.point]
X = 0
Y = "3/5"
theta = "theta_ref"
X_dot = 2
Y_dot = "4/5"
theta_dot = 1
"""


@pytest.mark.parametrize(
    ("mass", "mu", "theta_dot", "over", "what"),
    [
        # mu < -4, and B < 0: p = C - mu B < 0. Where B is small p > 0, and b > 0.
        ("1/3", "73/36 - 4*(theta - theta_ref)", "0", "11/5..12/5:2", "the friction coefficient mu may be"),
        ("1/3", "73/36 - 4*(theta - theta_ref)", "10", "31/10..314/100:2", "the friction coefficient mu may be"),
        # A moment of inertia that falls below 0 at theta = 0.98: then B < 0, p > 0, and b > 0.
        ("1/3 - (theta - theta_ref)", "73/36", "10", "11/10..6/5:2", "the mass matrix is not certainly positive"),
    ],
)
def test_p_and_b_mean_nothing_by_a_friction_or_a_mass_below_0(
    mass: str, mu: str, theta_dot: str, over: str, what: str
) -> None:
    """ "p < 0 (Painleve's paradox)" and "the contact opens at once" were proved of such starts."""
    mechanism = parse_mechanism(ROD.replace("MASS", mass).replace("MU", mu))
    result = fates(mechanism, {"X": 0, "X_dot": 30, "theta_dot": theta_dot}, {"theta": over})
    assert {piece.fate for piece in result.pieces} == {Fate.UNDECIDED}
    assert all(piece.why.startswith(what) for piece in result.pieces)


def test_slip_is_counted_from_the_velocity_of_the_surface() -> None:
    for u, surface, fate in ((2, 3, Fate.NO_SLIP), (2, 1, Fate.OPENS), (-2, -3, Fate.OPENS), (-2, -1, Fate.NO_SLIP)):
        result = fates(family(), {"x": 0, "u": u, "b": 1}, {"p": "1/4..1/2:2"}, surface_velocity=surface)
        assert {piece.fate for piece in result.pieces} == {fate}, (u, surface)


@pytest.mark.parametrize(
    ("share", "shown"),
    [(fmpq(1), "100"), (1 - fmpq(1, 10**6), "99.99"), (1 - fmpq(1, 10**40), "99.99"), (fmpq(2, 3), "66.66")],
)
def test_a_share_is_rounded_down(share: fmpq, shown: str) -> None:
    """A small part that is undecided, or lifts off, made the rest "100 %"."""
    result = fates(family(), {"x": 0, "u": 2, "b": "1/4"}, {"p": "-3/8..-1/8:1"})
    (piece,) = result.pieces
    cut = fmpq(-3, 8) + share / 4
    parts = [replace(piece, upper=(cut,)), replace(piece, lower=(cut,), fate=Fate.UNDECIDED)]
    text = str(replace(result, pieces=tuple(parts[: 1 + (share < 1)])))
    assert f"  {shown} %: p < 0 at the start" in text


@pytest.mark.parametrize(
    ("share", "shown"), [(fmpq(1, 10), "10"), (fmpq(2, 5), "40"), (fmpq(19, 32), "59.38"), (fmpq(1, 3), "33.34")]
)
def test_the_share_of_what_is_undecided_is_rounded_up(share: fmpq, shown: str) -> None:
    result = fates(family(), {"x": 0, "u": 2, "b": "1/4"}, {"p": "-3/8..-1/8:1"})
    (piece,) = result.pieces
    cut = fmpq(-1, 8) - share / 4
    parts = (replace(piece, upper=(cut,)), replace(piece, lower=(cut,), fate=Fate.UNDECIDED))
    assert f"  {shown} %: undecided" in str(replace(result, pieces=parts))


def test_a_cell_on_an_edge_of_the_starts_says_so() -> None:
    result = fates(family(), {"x": 0, "u": 2, "p": "1/4"}, {"b": "-1/8..1/8:1"})
    assert [piece.fate for piece in result.pieces] == [Fate.UNDECIDED]
    assert "the signs of p, b or the slip velocity differ" in result.pieces[0].why


def test_of_states_with_p_below_0_only_that_is_said() -> None:
    """With b = 1/4, p = -3/8 the force -b/p = 2/3 is positive: rigid bodies may slip in contact there, or lift off."""
    text = str(fates(family(), {"x": 0, "u": 2, "b": "1/4"}, {"p": "-3/8..-1/8:1"}))
    assert "100 %: p < 0 at the start (Painlevé's paradox): nothing more is said" in text


@pytest.mark.parametrize(
    ("state", "over", "error", "text"),
    [
        ({"x": 0, "u": 3}, {"q": "1..2"}, StateError, "'q' is no component"),
        ({"x": 0, "u": 3, "p": 1}, {"p": "1..2"}, StateError, "is given and varies"),
        ({"x": 0}, {"p": "1/4..1/2"}, StateError, "leave out two components"),
        ({"x": 0, "u": 3, "p": 0.5}, {"b": "-2..-1"}, MechanismError, "p"),
        ({"x": 0, "u": 3, "p": "1/2"}, {"b": "-1..-2"}, ValueError, "reversed"),
        ({"x": 0}, {"u": "1..2", "p": "1/4..1/2", "b": "-2..-1"}, ValueError, "one or two"),
        ({"x": 0, "u": 3, "p": "1/2"}, {"b": "-2..-1:0"}, ValueError, "at least|>= 1"),
    ],
)
def test_bad_input(state: Any, over: Any, error: type[Exception], text: str) -> None:
    with pytest.raises(error, match=text):
        fates(family(), state, over)


def test_of_several_solutions_of_the_contact_none_is_taken_in_silence() -> None:
    """y = Y - l sin(theta) = 0 holds for theta and for pi - theta: slip from there ends elsewhere."""
    rod = shipped_mechanism("rod with a wrist")
    with pytest.raises(StateError, match="may have several solutions in theta and theta_dot"):
        fates(rod, {"X": 0, "X_dot": 5, "Y_dot": 2}, {"Y": "0.71..0.7101"})
    with pytest.raises(StateError, match="may have several solutions in theta and Y_dot"):
        fates(rod, {"X": 0, "X_dot": 5, "theta_dot": 3}, {"Y": "0.71..0.7101"})


def test_a_flow_that_is_not_planar_is_refused() -> None:
    with pytest.raises(MechanismError, match="two components"):
        fates(shipped_mechanism("frictional impact oscillator"), {"phi": 0}, {"phi_dot": "-1..-1/2"})


def test_an_angle_with_a_reference_is_given_whole() -> None:
    """u = cos(phi) phi_dot is about -0.64 at phi = 0.272, and -0.24 at phi = phi_ref + 0.272."""
    planar = load("oscillator", beta="18/7")
    over = {"phi": "271/1000..273/1000:1", "phi_dot": "-66/100..-65/100:1"}
    found = fates(planar, {}, over, surface_velocity="-29/100")
    assert {piece.fate for piece in found.pieces} == {Fate.NO_SLIP}
    assert found.verdict.statement.endswith(
        ": no positive slip at the start, for every phi in [271/1000, 273/1000], phi_dot in [-33/50, -13/20], "
        "in contact on a surface with the velocity u = -29/100"
    )


def test_a_journal_goes_on_and_a_forged_one_changes_nothing(tmp_path: Path) -> None:
    path, over = tmp_path / "journal", {"p": "-1..1:41"}
    state: dict[str, Any] = {"x": 0, "u": 50, "b": 1}
    whole = fates(family(), state, over, journal=path, budget=3)
    lines = path.read_text().splitlines()
    path.write_text("\n".join(lines[:2]) + "\n" + lines[2][:5])  # killed within a line
    assert fates(family(), state, over, journal=path, budget=3).pieces == whole.pieces
    assert path.read_text().splitlines() == lines
    number, _, choices = json.loads(lines[1])
    forged = json.dumps([number, "0" * 64, "1" * len(choices)])
    path.write_text("\n".join([lines[0], forged, *lines[2:]]) + "\n")
    assert fates(family(), state, over, journal=path, budget=3).pieces == whole.pieces
    path.write_text("\n".join([lines[0], "[0, 1]"]) + "\n")
    with pytest.raises(ValueError, match="a line of the journal cannot be read"):
        fates(family(), state, over, journal=path)
    with pytest.raises(ValueError, match="not a journal of this question"):
        fates(family(), {**state, "u": 51}, over, journal=path)


def test_text_json_and_csv() -> None:
    result = line_of_the_family()
    assert sum(result.shares.values()) == 1
    # Friction may be too weak to hold what stops: then slip goes on the other way, and that is not asked.
    assert "slip stops before any G-spot (then stick, or slip the other way)" in str(result)
    rows = result.to_csv().splitlines()
    assert len(rows) == len(result.pieces) + 1
    assert rows[0].startswith("b_lower,b_lower_exact,")
    summary, pieces = result.in_parts()
    assert {**summary, "pieces": list(map(json.loads, pieces))} == result.to_json()
    assert "for starts at rest in the contact; epsilon_0, one for each state, is not" in summary["sides"]["rests_on"]
    for case, words in (("I", "Case I"), ("none", "no Case"), (None, "the Case is open")):
        sides = replace(result.sides, case=case, below=None, above=None, why="no rule")
        text = str(replace(result, sides=sides))
        assert f"  each G-spot that a piece is said to reach: {words}, beta = " in text
        nowhere = replace(result, sides=sides, pieces=tuple(replace(p, fate=Fate.UNDECIDED) for p in result.pieces))
        assert f"  the G-spot that was looked for: {words}, beta = " in str(nowhere)
        assert text.endswith("\n  no side for small epsilon: no rule")
        assert sides.to_json()["rests_on"] == ""
    with pytest.raises(ValueError, match="a rational in"):
        result.at(b=1)


def test_the_statement_says_what_the_pieces_say() -> None:
    """Where no piece has rigid slip, it does not speak of an end of it; nor of sides, where none is named."""
    below = fates(family(), {"x": 0, "u": 2, "b": "1/4"}, {"p": "-3/8..-1/8:2"})
    assert {piece.fate for piece in below.pieces} == {Fate.PAINLEVE}
    over = "for every p in [-3/8, -1/8], x = 0, u = 2, b = 1/4, in contact on a surface at rest"
    said = "p < 0 at the start (Painlevé's paradox): nothing more is said"
    assert below.verdict.statement == f"{below.name}: {said}, {over}"
    assert "side" not in str(below)
    (piece, *_), stops, lifts = below.pieces, Fate.STOPS, Fate.LIFT_OFF
    mixed = replace(below, pieces=(piece, replace(piece, fate=stops)))
    assert ": where rigid slip ends, or why it is not followed, for every p in" in mixed.verdict.statement
    ended = replace(below, pieces=(replace(piece, fate=lifts), replace(piece, fate=stops)))
    assert ": where rigid slip ends, for every p in" in ended.verdict.statement


def test_a_budget_divides_open_cells_further() -> None:
    state, over = {"x": 0, "u": 50, "b": 1}, {"p": "-3/8..3/4:3"}
    coarse, fine = (fates(family(), state, over, budget=budget) for budget in (0, 6))
    assert len(fine.pieces) == len(coarse.pieces) + 6
    left = [piece for piece in fine.pieces if piece.fate is Fate.UNDECIDED]
    assert all(piece.upper[0] - piece.lower[0] <= fmpq(3, 64) for piece in left)


def rod_run(th: float, rate: float, u: float) -> Fate | None:
    """The rod with a wrist in s, dt = p ds, by hand from Newton's law; None where the sign of C_1 is too close."""

    def parts(th: float, rate: float) -> tuple[float, float, float, float]:
        lever = np.cos(th) - 1.5 * np.sin(th)
        torque = -5 * (th - 0.9) - rate
        return lever, torque, 1 + 3 * np.cos(th) * lever, -14.81 - 3 * np.cos(th) * torque + np.sin(th) * rate**2

    def slope(_: float, state: Any) -> list[float]:
        th, rate, _slip = state
        lever, torque, p, b = parts(th, rate)
        turn = p * 3 * torque + b * 3 * lever
        return [p * rate, turn, 1.5 * b - np.sin(th) * turn - p * np.cos(th) * rate**2]

    def opens(_: float, state: Any) -> float:
        return parts(state[0], state[1])[3]

    def sticks(_: float, state: Any) -> float:
        return float(state[2])

    def ends(_: float, state: Any) -> float:
        return parts(state[0], state[1])[2] - 1e-7

    for event in (opens, sticks, ends):
        event.terminal = True  # type: ignore[attr-defined]
    run = solve_ivp(slope, (0, 50), [th, rate, u], "DOP853", events=(opens, sticks, ends), rtol=1e-12, atol=1e-14)
    if len(run.t_events[0]):
        return Fate.LIFT_OFF
    if len(run.t_events[1]):
        return Fate.STOPS
    _, _, p, b = parts(run.y[0, -1], run.y[1, -1])
    gap = 9.1375247793 - 72.260370218 * p + b / p  # the distinguished trajectory's force, minus -b/p
    return None if abs(gap) < 1e-6 else Fate.ABOVE if gap > 0 else Fate.BELOW


@pytest.mark.slow
def test_cells_of_the_rod_against_float_runs() -> None:
    """200 random states of the rod with a wrist, in certified cells, by scipy; X_dot is small, so that many stick."""
    over = {"theta": "7/10..17/20:12", "theta_dot": "5/2..18/5:12"}
    chance, seen = random.Random(4), Counter[Fate]()
    result = fates(shipped_mechanism("rod_with_wrist"), {"X": 0, "X_dot": "7/2"}, over)
    certain = [piece for piece in result.pieces if piece.fate in (Fate.BELOW, Fate.ABOVE, Fate.LIFT_OFF, Fate.STOPS)]
    for k in range(200):
        piece = certain[k % len(certain)]
        th, rate = inside(piece, chance)
        found = rod_run(th, rate, 3.5 - np.sin(th) * rate)
        assert found in (piece.fate, None), (piece, th, rate)
        seen[piece.fate] += found is not None
    assert sum(seen.values()) > 190
    assert len(seen) >= 2


def test_where_b_may_rise_through_0_nothing_presses() -> None:
    """alpha_2 in (0, 1) for p > 1/8, and b of either sign: lift-off is neither certain nor excluded."""
    with working_bits(53):
        shifted = shift(family())
        plane = PlanarFlow(shifted)
        side = _side(plane, plane.of_state(prove_near(shifted, place_in(shifted, BALLS), 53).system.point))
        assert side is not None
        below, middle, above = (reference(plane, 1, side, [arb("0.25"), arb(b)]) for b in ("-0.25", "0.125", "0.25"))
        assert below is not None
        assert middle is not None
        assert above is not None
        knots = [arb("0.24"), arb("0.2"), arb("0.14"), arb("0.12"), arb("0.1"), arb("0.08")]
        for part in strip(plane, below, above, side, knots).slices:
            assert part.box[1].contains(arb(0))
            assert (part.presses is not None) == (part.upper < 0.125)
            assert part.opens is None
        high = strip(plane, middle, above, side, knots).slices[0]
        assert high.presses is None
        assert high.opens is not None
