"""The contact force near the initial state by its power series: where it is positive, and its first zero.

Page: proofs/contact_series.md, section 4.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import mpmath
import pytest
from flint import arb, arb_poly, fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import ends, to_fmpq
from witnesses.contact import moved

from gspot_verified.compliant.model.normal_form import compliant_model, compliant_state, deviation
from gspot_verified.compliant.motion import first_zero as first_zero_module
from gspot_verified.compliant.motion.compliant_force import force
from gspot_verified.compliant.motion.contact_series import SeriesCell, series_cells
from gspot_verified.compliant.motion.first_zero import contact_lasts, first_zero
from gspot_verified.compliant.motion.zero_by_series import (
    Piece,
    Shown,
    _range,
    bracket,
    not_positive,
    positive_by_series,
    zero_by_series,
)
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.numerics.paper_state import paper_state

EPSILONS = ["1/10", "1/1000", "1e-6", "1e-9"]


def motion(epsilon: str, p: str = "-1/10", b: str = "1/3"):
    model = compliant_model("5/2", epsilon)
    small = model.epsilon
    return model, compliant_state(p, b, -2 * small**2, small / 7, -(small**2))


def force_by_equations(model, state, time: fmpq) -> mpmath.mpf:
    hats = deviation(model, state)
    duration = (time - state.p / model.alpha_1) / model.epsilon
    with mpmath.workdps(50):
        numbers = [
            mpmath.mpf(int(v.p)) / int(v.q)
            for v in (hats.b, hats.V, hats.Y, hats.Z, hats.p, hats.beta, hats.epsilon, duration, model.mean_force)
        ]
        (_, _, Y, Z), _ = moved(numbers[:4], *numbers[4:8], steps=int(duration * 4) + 4)
        return Z - Y + numbers[8]


@pytest.mark.parametrize(("p", "b"), [("0", "1/3"), ("-1/10", "1/3"), ("-3", "4")])
@pytest.mark.parametrize("epsilon", EPSILONS)
def test_the_first_zero_from_a_state_at_or_after_the_g_spot(epsilon: str, p: str, b: str) -> None:
    model, state = motion(epsilon, p, b)
    found = first_zero(model, state)
    assert found.verdict.outcome is Outcome.PROVED
    assert found.lower is not None
    assert found.upper is not None
    assert found.start < found.lower < found.upper
    with working_bits(64):
        width = (arb(model.epsilon) / 2).root(3) ** 2 * 2 * arb(10) ** -25
        assert arb(found.upper - found.lower) < 2 * width
    assert force_by_equations(model, state, found.lower) > 0 > force_by_equations(model, state, found.upper)
    # It is the first one: the force is positive at times before it, and the certificate of that agrees.
    for share in (fmpq(1, 4), fmpq(1, 2), fmpq(3, 4), fmpq(99, 100)):
        assert force_by_equations(model, state, found.start + share * (found.lower - found.start)) > 0
    assert contact_lasts(model, state, found.lower).outcome is Outcome.PROVED
    assert contact_lasts(model, state, found.upper).outcome is Outcome.UNDECIDED
    assert force(model, state, found.lower, digits=3).force > 0


def test_a_force_that_grows_has_no_bracket_and_lasts() -> None:
    model, state = motion("1/1000", b="-1/3")
    found = first_zero(model, state)
    assert found.verdict.outcome is Outcome.UNDECIDED
    assert contact_lasts(model, state, "1/5").outcome is Outcome.PROVED
    beyond = contact_lasts(model, state, 10)
    assert beyond.outcome is Outcome.UNDECIDED
    assert "the power series within its budget of 3000" in beyond.detail


def test_the_second_zero_is_not_taken_for_the_first() -> None:
    """A force that falls to 0, is negative, and rises again: the bracket is that of the fall."""
    model = compliant_model("5/2", "1/10")
    small = model.epsilon
    state = compliant_state("-1/10", "-1/3", -2 * small**2, 3 * small, -(small**2))
    found = first_zero(model, state)
    assert found.lower is not None
    assert found.upper is not None
    assert force_by_equations(model, state, found.lower) > 0 > force_by_equations(model, state, found.upper)
    assert force_by_equations(model, state, found.start + 50 * (found.upper - found.start)) > 0
    assert positive_by_series(deviation(model, state), model.mean_force, fmpq(60)) is None


@pytest.mark.parametrize(
    "until",
    [
        "-499999/1000000",
        pytest.param("-49/100", marks=pytest.mark.slow),
        pytest.param("-1/4", marks=pytest.mark.slow),
        "1/10000",
    ],
)
def test_the_first_instants_at_small_epsilon(until: str) -> None:
    """The bound of the fast part is too large at the start, p > 0: the series joins the two."""
    model = compliant_model("5/2", "1e-6")
    small = model.epsilon
    state = compliant_state("1/2", "-2/3", small**2 * fmpq(-5, 2), small / 7, -(small**2))
    assert contact_lasts(model, state, until).outcome is Outcome.PROVED


def test_a_loss_of_contact_in_the_first_instants_is_seen() -> None:
    model = compliant_model("5/2", "1e-6")
    small = model.epsilon
    state = compliant_state("1/2", "-2/3", small**2 * fmpq(-5, 2), 3 * small, -(small**2))
    assert force_by_equations(model, state, fmpq(-1, 2) + 2 * small) < 0
    assert contact_lasts(model, state, "-1/4").outcome is Outcome.UNDECIDED


coefficients = st.lists(st.fractions(-5, 5, max_denominator=9), max_size=6)


@given(coefficients, st.fractions(0, 1, max_denominator=16), st.fractions(0, 1, max_denominator=16), st.fractions(0, 1))
def test_the_range_of_a_polynomial_holds_its_values(found: list[Fraction], one: Fraction, two: Fraction, u) -> None:
    left, right = min(one, two), max(one, two)
    x = left + (right - left) * u
    value = sum((c * x**k for k, c in enumerate(found)), Fraction(0))
    with working_bits(100):
        box = _range(arb_poly([to_fmpq(c) for c in found]), arb(fmpq(1, 8)), to_fmpq(left), to_fmpq(right))
        lower, upper = ends(box)
        assert lower <= value - Fraction(1, 8)
        assert upper >= value + Fraction(1, 8)


def test_the_rests_enter_with_their_factors() -> None:
    model, state = motion("1/10")
    (cell,) = series_cells(deviation(model, state), fmpq(1), 1, 80)
    wide = type(cell)(cell.first, cell.width, cell.variables, (arb(64), arb(16), arb(4), arb(1)))
    narrow = type(cell)(cell.first, cell.width, cell.variables, (arb(0),) * 4)
    for name, rest in (("force", 5), ("slope", 16 + 2 + 4)):
        one, two = (getattr(Piece(c, fmpq(0), fmpq(0), fmpq(1)), name)() for c in (wide, narrow))
        with working_bits(80):
            assert abs(one.rad() - two.rad() - rest) < fmpq(1, 1000)


def test_without_a_certain_sign_at_an_end_there_is_no_bracket() -> None:
    model, state = motion("1/10")
    hats = deviation(model, state)
    assert zero_by_series(hats, model.mean_force, fmpq(1, 10**6), 80) is not None
    assert zero_by_series(hats, model.mean_force, fmpq(1, 10**400), 80) is None


@pytest.mark.slow
def test_before_the_g_spot_both_routes_to_the_first_zero_agree() -> None:
    """The slow part with a bound of the fast one, and the power series: brackets of one zero."""
    model = compliant_model("3/2", "1/1000")
    state = paper_state(model, 2)
    arguments = first_zero_module.contact_motion(model, state), state.p / model.alpha_1, "the first zero", 12
    by_range = first_zero_module._by_force_range(*arguments, 3_000)
    by_series = first_zero_module._by_series(*arguments, 1_800)
    assert by_range is not None
    assert by_series is not None
    for found in (by_range, by_series):
        assert found.lower is not None
        assert found.upper is not None
        assert found.lower < found.upper
    assert by_range.lower is not None
    assert by_range.upper is not None
    assert by_series.lower is not None
    assert by_series.upper is not None
    assert by_range.lower < by_series.upper
    assert by_series.lower < by_range.upper


def test_a_state_far_from_the_slow_manifold_has_its_first_zero_by_the_series() -> None:
    """p > 0, and the bound of the fast part shows nothing; the force by the equations has the signs."""
    model = compliant_model("5/2", "1/20")
    small = model.epsilon
    state = compliant_state("4/5", "-8/5", -fmpq(16, 5) * small**2, 0, -fmpq(8, 5) * small**2)
    found = first_zero(model, state, digits=12)
    assert found.lower is not None
    assert found.upper is not None
    assert force_by_equations(model, state, found.lower) > 0 > force_by_equations(model, state, found.upper)
    short = first_zero(model, state, digits=12, budget=3)
    assert short.verdict.outcome is Outcome.UNDECIDED
    assert "its budget of 3 " in short.verdict.detail


def test_a_cell_that_is_left_out_shows_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """The pieces must cover the time from the state on, by their exact ends."""
    model, state = motion("1/10")
    hats = deviation(model, state)
    found = zero_by_series(hats, model.mean_force, fmpq(1, 10**6), 80)
    assert found is not None
    shown = positive_by_series(hats, model.mean_force, found.lower)
    assert shown is not None
    assert f"cover [0, {found.lower}]" in str(shown)
    assert f"cover [0, {found.lower}]" in str(found.evidence)

    def without_the_first(*arguments: Any) -> Iterator[SeriesCell]:
        cells = series_cells(*arguments)
        next(cells)
        yield from cells

    monkeypatch.setattr("gspot_verified.compliant.motion.zero_by_series.series_cells", without_the_first)
    assert positive_by_series(hats, model.mean_force, found.lower) is None
    assert zero_by_series(hats, model.mean_force, fmpq(1, 10**6), 80) is None


@pytest.mark.parametrize("claimed", [1, -1])
def test_a_sign_that_is_claimed_and_not_there_is_no_bracket(monkeypatch: pytest.MonkeyPatch, claimed: int) -> None:
    """The bisection goes the wrong way: then one end has not its sign, and it is compared once more as evidence."""
    model, state = motion("1/10")
    monkeypatch.setattr("gspot_verified.compliant.motion.zero_by_series.sign_of", lambda _: claimed)
    assert zero_by_series(deviation(model, state), model.mean_force, fmpq(1, 10**6), 80) is None


def test_at_the_state_itself_the_force_is_compared() -> None:
    model, state = motion("1/10")
    hats = deviation(model, state)
    assert positive_by_series(hats, model.mean_force, fmpq(0)) is not None
    assert positive_by_series(hats, -hats.force, fmpq(0)) is None


@pytest.mark.parametrize("ends", [(fmpq(0), fmpq(1)), (fmpq(1, 4), fmpq(1, 3))])
def test_halves_join_in_the_middle(ends: tuple[fmpq, fmpq]) -> None:
    model, state = motion("1/10")
    cell = next(iter(series_cells(deviation(model, state), fmpq(1, 3), 1, 128)))
    left, right = Piece(cell, fmpq(2), *ends).halves()
    assert (left.left, right.right, left.mean, right.mean) == (*ends, 2, 2)
    assert left.right == right.left == sum(ends) / 2


def test_the_slope_of_a_piece_is_that_of_the_force() -> None:
    """d lambda/dT = -(2 Z - Y + V): the difference quotient of the force, and little else over a short piece."""
    model, state = motion("1/10")
    cell = next(iter(series_cells(deviation(model, state), fmpq(1, 3), 1, 128)))
    with working_bits(200):
        piece = Piece(cell, model.mean_force, fmpq(1, 2), fmpq(1, 2) + fmpq(1, 2**20))
        ahead, behind = (cell.at(arb(x)) for x in (piece.right, piece.left))
        quotient = (ahead[3] - ahead[2] - behind[3] + behind[2]) / (cell.width * (piece.right - piece.left))
        slope = piece.slope()
        assert slope.is_finite()
        assert slope.overlaps(quotient)
        assert abs(slope - quotient) < 1e-4
        whole = Piece(cell, model.mean_force, fmpq(0), fmpq(1)).slope()
        assert whole.contains(slope.mid())


@pytest.mark.parametrize("width", [fmpq(1, 10**6), fmpq(1, 10**9)])
def test_the_bracket_is_as_wide_as_asked(width: fmpq) -> None:
    """Halved until it is not wider: then it is wider than half of it. The width is a time, whatever the cell."""
    model, state = motion("1/10", "-40", "60")  # cells of length 1/4
    found = zero_by_series(deviation(model, state), model.mean_force, width, 128)
    assert found is not None
    assert width / 2 < found.upper - found.lower <= width


# The searches on cells made by hand: lambda = Z and its slope are given apart (Y = 0, V = -slope - 2 Z)

NEAR = fmpq(1, 2**20)


def cell_of(force: list[fmpq | int], slope: fmpq, first: int = 0) -> SeriesCell:
    """One cell of width 1; the force by its coefficients, a constant slope."""
    Z = arb_poly([arb(value) for value in force])
    return SeriesCell(fmpq(first), fmpq(1), (arb_poly([]), -2 * Z - arb(slope), arb_poly([]), Z), (arb(0),) * 4)


def searched(cells: list[SeriesCell], rising: bool = False) -> tuple[Piece | None, Shown]:
    shown = Shown()
    return not_positive(cells, fmpq(0), 64, shown, rising=rising), shown


def test_a_force_that_rises_from_0_is_positive_on_the_first_piece_only() -> None:
    found, shown = searched([cell_of([0, 1], NEAR)], rising=True)
    assert (found, shown.pieces) == (None, [(fmpq(0), fmpq(1))])
    for rising, slope, first in ((False, NEAR, 0), (True, fmpq(0), 0), (True, NEAR, 1)):
        found, shown = searched([cell_of([0, 1], slope, first)], rising)
        assert found is not None
        assert (found.left, found.right, shown.pieces) == (0, fmpq(1, 2**24), [])


def test_a_force_that_only_reaches_0_is_cut_to_the_end() -> None:
    """A piece is a place of a zero where the force falls and is certainly negative at its right end."""
    found, _ = searched([cell_of([1, -2], fmpq(-2))])
    assert found is not None
    assert (found.left, found.right) == (0, 1)
    found, shown = searched([cell_of([1, -1], fmpq(-1))])
    assert found is not None
    assert (found.right, found.right - found.left) == (1, fmpq(1, 2**24))
    assert shown.pieces[0] == (0, fmpq(1, 2))


@pytest.mark.parametrize(("slope", "good"), [(-NEAR, True), (fmpq(0), False), (NEAR, False), (fmpq(1, 2), False)])
def test_a_bracket_asks_that_the_force_falls_on_all_of_its_piece(slope: fmpq, good: bool) -> None:
    piece = Piece(cell_of([fmpq(1, 3), -1], slope), fmpq(0), fmpq(0), fmpq(1))
    found = bracket(piece, NEAR, 64, Shown())
    assert (found is not None) is good
    if found is not None:
        assert found.lower < fmpq(1, 3) < found.upper <= found.lower + NEAR
