"""Cells: what is known of a larger tube is used for its own zeros only; pieces cover the cell.

Page: proofs/sweep.md, sections 2 and 5.
"""

from __future__ import annotations

from itertools import pairwise

import pytest
from flint import arb, fmpq
from samples.families import family

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Constant, Variable
from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.spots.parametric_system import parametric_system
from gspot_verified.mechanisms.sweep import sweep_cell
from gspot_verified.mechanisms.sweep.sweep import sweep
from gspot_verified.mechanisms.sweep.sweep_bracket import Cut
from gspot_verified.mechanisms.sweep.sweep_cell import BOXES, BOXES_BEYOND, Cell, Examination, Known
from gspot_verified.mechanisms.sweep.sweep_findings import equations
from gspot_verified.mechanisms.sweep.sweep_piece import Kind
from gspot_verified.mechanisms.sweep.sweep_start import Origin, proved_tube
from gspot_verified.mechanisms.zeros.tube import Equations, OnTube, Tube
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome, Reason

ROOT = Equations(BoxProgram([Variable(0) * Variable(0) - Variable(1)], 2), 1)


def root(lower: fmpq, upper: fmpq, sign: int) -> Tube:
    on = proved_tube(ROOT, (lower,), (upper,), Origin((fmpq(1),), (fmpq(sign),), ((fmpq(sign, 2),),)))
    assert on is not None
    return on.tube


def test_signs_are_those_of_one_zero() -> None:
    """x^2 = λ: what is known of the positive root on [1, 2] says nothing of the negative one on a part."""
    with working_bits(80):
        known = Known().further(root(fmpq(1), fmpq(2), 1), "alpha_1", 1)
        assert known.signs == {"alpha_1": 1}
        assert known.concerns(root(fmpq(5, 4), fmpq(3, 2), 1))
        assert not known.concerns(root(fmpq(5, 4), fmpq(3, 2), -1))
        assert Known().concerns(root(fmpq(5, 4), fmpq(3, 2), -1))


def test_the_middle_of_the_part_is_asked_for() -> None:
    """Level on [0, 8] within 1, and rising with slope 1 on [6, 8]: they meet at 7, not to the left of 0."""

    def line(lower: int, upper: int, slope: int, width: str) -> Tube:
        ball = (arb(0, width),)
        return Tube((fmpq(lower),), (fmpq(upper),), (arb(0),), ((arb(slope),),), ball, ball)

    assert Known(line(0, 8, 0, "1")).concerns(line(6, 8, 1, "0.5"))
    assert not Known(line(0, 8, 0, "0.25")).concerns(line(6, 8, 1, "0.5"))


def cell_pieces(p: str, lower: fmpq, upper: fmpq, origin: Origin | None) -> list[tuple[fmpq, fmpq, Kind]]:
    system = parametric_system(family(p, "0"), ["k"], ["x", "u"])
    found = Examination(equations(system), 10).pieces(Cell((lower,), (upper,), origin))
    return [(piece.lower[0], piece.upper[0], piece.kind) for piece in found]


def test_pieces_cover_the_cell_up_to_a_fold_and_behind_it() -> None:
    """p = q^2 - k on [-1, 1] from q = 1: no tube for k <= 0, and the whole cell is covered."""
    start = Origin((fmpq(1),), (fmpq(0), fmpq(1), fmpq(0), fmpq(0), fmpq(1), fmpq(0)), ((fmpq(0),),) * 6)
    found = cell_pieces("q^2 - k", fmpq(-1), fmpq(1), start)
    assert (found[0][0], found[-1][1]) == (fmpq(-1), fmpq(1))
    for (_, end, _), (begin, _, _) in pairwise(found):
        assert end == begin
    for lower, upper, kind in found:
        assert lower < upper
        assert kind is Kind.NO_TUBE or lower > 0
    assert {kind for *_, kind in found} >= {Kind.NO_TUBE, Kind.SETTLED}


def test_a_cell_without_an_origin_is_left() -> None:
    assert cell_pieces("q - k", fmpq(0), fmpq(1), None) == [(fmpq(0), fmpq(1), Kind.NO_TUBE)]


@pytest.mark.parametrize("refused", [True, False])
def test_a_bracket_over_which_no_tube_is_proved_is_left(refused: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """q = sqrt(k): alpha_3 passes alpha_1 at k = 9/16; the pieces cover the cell in both cases."""

    def narrow(equations: Equations, lower: tuple[fmpq, ...], upper: tuple[fmpq, ...], near: Origin) -> OnTube | None:
        return (
            None if refused and 0 < upper[0] - lower[0] < fmpq(1, 10**6) else proved_tube(equations, lower, upper, near)
        )

    monkeypatch.setattr(sweep_cell, "proved_tube", narrow)
    start = Origin((fmpq(9, 16),), (fmpq(0), fmpq(1), fmpq(0), fmpq(0), fmpq(3, 4), fmpq(0)), ((fmpq(0),),) * 6)
    found = cell_pieces("q^2 - k", fmpq(1, 2), fmpq(11, 16), start)
    here = {kind for lower, upper, kind in found if lower <= fmpq(9, 16) <= upper}
    assert here == {Kind.NO_TUBE if refused else Kind.CROSSING}
    assert (found[0][0], found[-1][1]) == (fmpq(1, 2), fmpq(11, 16))
    for (_, end, _), (begin, _, _) in pairwise(found):
        assert end == begin


def test_a_quantity_with_one_sign_all_along_needs_no_bracket(monkeypatch: pytest.MonkeyPatch) -> None:
    """As alpha_3 - alpha_1 has on [9/16 + 1/64, 11/16]: its sign is known there, and no bracket is cut out."""
    monkeypatch.setattr(sweep_cell, "bracket", lambda *_: Cut(None, (1,), 1))
    start = Origin((fmpq(5, 8),), (fmpq(0), fmpq(1), fmpq(0), fmpq(0), fmpq(4, 5), fmpq(0)), ((fmpq(0),),) * 6)
    found = cell_pieces("q^2 - k", fmpq(37, 64), fmpq(11, 16), start)
    assert {kind for *_, kind in found} == {Kind.SETTLED}
    assert (found[0][0], found[-1][1]) == (fmpq(37, 64), fmpq(11, 16))


def test_next_to_a_singular_mass_matrix_the_boxes_of_a_cell_end(monkeypatch: pytest.MonkeyPatch) -> None:
    """det M = J - c^2 = 0 at c = -1/2: the tubes are ever shorter there, like the square of the distance."""
    body = lagrangian(
        "bent", ["X", "H", "th"], [[1, 0, 0], [0, 1, "c"], [0, "c", "1/4"]],
        [0, "-3/4", "1 - 7*th_dot/8 - 7*(th - 1)/4"], "X + 7*cos(th)/8", "H - 7*sin(th)/8 + cos(2*th)/8", "19/8",
        {"c": "-1/4"}, search=True, fixed=["X", "X_dot"],
        place={"X": 0, "X_dot": 2, "th": "1.3116", "th_dot": "0.67385", "H": "0.95435", "H_dot": "0.23459"},
    )  # fmt: skip
    examined, beyond = [], 64
    monkeypatch.setattr(sweep_cell, "BOXES_BEYOND", beyond)
    own = Examination._tube
    monkeypatch.setattr(Examination, "_tube", lambda *given: examined.append(given[2:4]) or own(*given))
    found = sweep(body, {"c": "-1/2..-1/4:1"})
    assert len(examined) <= BOXES + 2 * beyond + 32
    first, *others = found.pieces
    assert (first.lower[0], first.kind, first.unsure) == (fmpq(-1, 2), Kind.NO_TUBE, ("the boxes of the cell ended",))
    assert first.upper[0] < fmpq(-12, 25)
    assert {piece.kind for piece in others} == {Kind.SETTLED}
    assert (found.verdict.outcome, found.verdict.reason) == (Outcome.UNDECIDED, Reason.BUDGET)
    assert f"the boxes of the cell ended, {BOXES} and {BOXES_BEYOND} divided beyond" in found.verdict.detail
    assert "no continued spot was found: the boxes of the cell ended" in str(found)


@pytest.mark.parametrize("known", [fmpq(1, 32), fmpq(1, 2**20)])
def test_what_is_known_of_a_much_shorter_tube_is_no_guess(known: fmpq) -> None:
    """1/x = λ on [1, 17/16]: widths that are scaled from a tube of a millionth hold 0, where 1/x has no enclosure."""
    inverse = Equations(BoxProgram([Constant(fmpq(1)) / Variable(0) - Variable(1)], 2), 1)
    place = (fmpq(33, 32),)
    near = Origin(place, (fmpq(32, 33),), ((-(fmpq(32, 33) ** 2),),), (known,), (2.0**-10,))
    with working_bits(80):
        on = proved_tube(inverse, (fmpq(1),), (fmpq(17, 16),), near)
    assert on is not None
    assert on.tube.zero_at(place)[0].contains(fmpq(32, 33))
