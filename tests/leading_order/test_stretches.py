"""Critical points, least values and crossings of sign * dTheta/dtau, against point values on a scan.

Page: proofs/iwc.md.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import ends, to_fmpq

from gspot_verified import evaluate, gamma_sign
from gspot_verified.leading_order.contact_force import contact_force
from gspot_verified.leading_order.stretches import (
    Bracket,
    NotAbove,
    Stretches,
    _below,
    _height,
    first_crossing,
    minimum,
    narrowed,
    stretches,
)
from gspot_verified.numbers.balls import sign_of, working_bits
from gspot_verified.signs.gamma.count_law import number_of_zeros
from gspot_verified.signs.zeros.brackets import zeros_at

BETAS = ("3/2", "7/3", "29/10", "7/2", "9/2", "27/5", "13/2", "23/3", "101/100", "399/100")


@pytest.mark.parametrize("beta", BETAS)
def test_the_minimum_is_below_a_scan_and_close_to_it(beta: str) -> None:
    force = contact_force(beta)
    least = minimum(stretches(force.beta, force.direction, fmpq(-4)))
    scan = [force.direction * evaluate(fmpq(k, 50), beta, derivative=1, digits=20).value for k in range(-200, 300)]
    assert all(least.value.upper() <= value.upper() + fmpq(1, 10**9) for value in scan)
    lowest = min(scan, key=lambda value: value.mid())
    assert abs(lowest - least.value) < (1 + abs(least.value)) * fmpq(1, 100)
    assert least.value.rad() < (1 + abs(least.value)) * fmpq(1, 10**12)


@pytest.mark.parametrize("beta", [*BETAS, "25/2"])
def test_critical_points_are_as_many_as_the_theorem_says(beta: str) -> None:
    force = contact_force(beta)
    found = stretches(force.beta, 1, fmpq(-10))
    assert len(found.critical) == number_of_zeros(force.beta - 1)
    for first, second in zip(found.critical, found.critical[1:], strict=False):
        assert first.upper < second.lower
    for bracket in found.critical:
        ends = [evaluate(tau, beta, derivative=2, digits=5).value for tau in (bracket.lower, bracket.upper)]
        assert ends[0] * ends[1] < 0
        assert bracket.value.contains(
            evaluate((bracket.lower + bracket.upper) / 2, beta, derivative=1, digits=40).value
        )


def test_a_start_inside_the_bracket_of_a_critical_point() -> None:
    beta = fmpq(5, 2)
    lower, upper = ((b.lower, b.upper) for b in stretches(beta, -1, fmpq(-10)).critical).__next__()
    inside = stretches(beta, -1, (lower + upper) / 2)
    assert len(inside.critical) == 1
    assert not inside.whole_line
    assert minimum(inside).value.overlaps(minimum(stretches(beta, -1, fmpq(-10))).value)
    beyond = stretches(beta, -1, upper)
    assert beyond.critical == ()


def value_at(tau: fmpq, beta: fmpq, sign: int) -> arb:
    """sign * dTheta/dtau at a point."""
    with working_bits(300):
        return sign * evaluate(tau, beta, derivative=1, digits=40).value


@pytest.mark.parametrize("digits", [1, 2, 15])
@pytest.mark.parametrize("beta", [fmpq(5, 2), fmpq(7, 2), fmpq(9, 2), fmpq(23, 4), fmpq(15, 2)])
def test_no_bracket_leaves_the_half_line(beta: fmpq, digits: int) -> None:
    """Starts at, in and next to the brackets: what is said of the least value is true, and of the place too."""
    sign = gamma_sign(beta) or 0
    critical = [(lower + upper) / 2 for lower, upper in zeros_at(beta - 1, 30).brackets]
    for lower, upper in zeros_at(beta - 1, digits).brackets:
        width = upper - lower
        for share in (fmpq(-1, 100), fmpq(0), fmpq(1, 10), fmpq(1, 2), fmpq(9, 10), fmpq(1), fmpq(101, 100)):
            start = lower + share * width
            found = stretches(beta, sign, start, digits)
            places = [start, *(tau for tau in critical if tau > start)]
            assert all(start <= bracket.lower < bracket.upper for bracket in found.critical)
            # Every critical point beyond the start is in a bracket.
            assert all(any(b.lower <= tau <= b.upper for b in found.critical) for tau in places[1:])
            least = minimum(found)
            values = [value_at(tau, beta, sign) for tau in places]
            smallest = min(values, key=lambda value: value.mid())
            lowest, highest = ends(least.value)
            assert lowest <= ends(smallest)[1]
            assert ends(smallest)[0] <= highest
            place = places[values.index(smallest)] if smallest in values else start
            assert start <= least.lower <= place <= least.upper


def test_the_least_value_counts_a_critical_point_in_the_first_bracket() -> None:
    """The start is in a bracket of width 1/10, just before the critical point, where the value is less."""
    beta = fmpq(5, 2)
    ((lower, upper),) = zeros_at(beta - 1, 1).brackets
    ((first, last),) = zeros_at(beta - 1, 30).brackets
    start = (lower + first) / 2
    assert lower < start < first < last < upper
    at_start, at_critical = value_at(start, beta, -1), value_at(first, beta, -1)
    assert at_critical < at_start
    found = minimum(stretches(beta, -1, start, 1))
    assert ends(found.value)[0] < ends(at_critical)[0]
    assert found.lower <= first
    assert last <= found.upper


def test_where_the_least_value_is_attained_may_stay_open() -> None:
    """Two brackets whose balls overlap: the place is an interval that holds both."""
    start = Bracket(fmpq(0), fmpq(0), arb(5))
    first, second, third = (
        Bracket(fmpq(k), fmpq(k) + fmpq(1, 2), value) for k, value in ((1, arb(1, 1)), (2, arb(7)), (3, arb(2, 1)))
    )
    both = minimum(Stretches(fmpq(5, 2), -1, start, (first, second, third), False))
    assert (both.lower, both.upper) == (1, fmpq(7, 2))
    assert ends(both.value)[0] <= 0 <= 2 <= ends(both.value)[1] < 3
    one = minimum(Stretches(fmpq(5, 2), -1, start, (first, second), False))
    assert (one.lower, one.upper) == (1, fmpq(3, 2))
    alone = minimum(Stretches(fmpq(5, 2), -1, start, (second,), False))
    assert (alone.lower, alone.upper) == (0, 0)


@pytest.mark.parametrize("beta", [fmpq(1, 2), fmpq(3, 2), fmpq(5, 2), fmpq(7, 2), fmpq(9, 2), fmpq(11, 2)])
@pytest.mark.parametrize("sign", [1, -1])
def test_both_ends_of_the_line(beta: fmpq, sign: int) -> None:
    """``rises`` and ``whole_line`` against values far out."""
    found = stretches(beta, sign, fmpq(-5))
    far = value_at(fmpq(300), beta, sign)
    assert found.rises == bool(far > 10**6)
    assert found.rises != bool(far < -(10**6))
    left = [value_at(fmpq(-(5**k)), beta, sign) for k in range(1, 9)]
    decreasing = all(b > a for a, b in pairwise(left)) and bool(left[-1] > 100)
    assert found.whole_line is decreasing


def test_the_whole_line_needs_a_start_before_all_brackets() -> None:
    ((lower, upper),) = zeros_at(fmpq(3, 2), 15).brackets
    assert stretches(fmpq(5, 2), -1, lower).whole_line
    assert not stretches(fmpq(5, 2), -1, lower + (upper - lower) / 10**6).whole_line
    assert not stretches(fmpq(5, 2), -1, upper).whole_line


def test_hypotheses() -> None:
    for beta in (fmpq(0), fmpq(-1, 2), fmpq(1), fmpq(3)):
        with pytest.raises(ValueError, match="beta"):
            stretches(beta, 1, fmpq(0))
    with pytest.raises(ValueError, match="sign"):
        stretches(fmpq(1, 2), 0, fmpq(0))
    with pytest.raises(ValueError, match="no least value"):
        minimum(stretches(fmpq(5, 2), 1, fmpq(0)))
    with pytest.raises(ValueError, match="need not fall"):
        first_crossing(stretches(fmpq(5, 2), -1, fmpq(0)), lambda _: arb(1))


@pytest.mark.parametrize(("beta", "sign"), [(fmpq(7, 2), -1), (fmpq(9, 2), 1), (fmpq(11, 2), -1), (fmpq(13, 2), 1)])
@pytest.mark.parametrize("start", [fmpq(-3), fmpq(0), fmpq(7, 5)])
def test_first_crossing_against_a_scan(beta: fmpq, sign: int, start: fmpq) -> None:
    found = stretches(beta, sign, start)
    grid = [start + fmpq(k, 64) for k in range(64 * 9)]
    scan = [value_at(tau, beta, sign) for tau in grid]
    heights = sorted({int(-bracket.value.mid().floor().unique_fmpz()) for bracket in found.critical})
    levels = {h + k for h in heights for k in (-3, 0, 3)} | {0, 1}
    for level in levels:
        above = [value + level > 0 for value in scan]
        if not above[0]:
            with pytest.raises(NotAbove):
                first_crossing(found, lambda _, level=level: arb(level))  # type: ignore[misc]
            continue
        crossing = first_crossing(found, lambda _, level=level: arb(level), 6)  # type: ignore[misc]
        assert crossing is not None
        assert value_at(crossing.lower, beta, sign) + level > 0 > value_at(crossing.upper, beta, sign) + level
        assert 0 < crossing.upper - crossing.lower <= fmpq(1, 10**6)
        changes = [i for i, (a, b) in enumerate(pairwise(above)) if a != b]
        if len(changes) % 2:  # the scan reaches beyond the last one
            assert grid[changes[0]] <= crossing.upper
            assert crossing.lower <= grid[changes[0] + 1]
            assert crossing.number == len(changes)


def test_uncertain_levels_stay_open() -> None:
    found = stretches(fmpq(7, 2), -1, fmpq(-3))
    assert first_crossing(found, lambda _: arb(0, 1000)) is None
    assert first_crossing(found, lambda _: arb.nan()) is None
    with pytest.raises(NotAbove):
        first_crossing(found, lambda _: arb(-(10**9)))
    assert narrowed(lambda _: None, fmpq(0), fmpq(1), 3) == (0, 1)


@pytest.mark.parametrize("ends", [(0, 1), (9, 10), (10, 0)], ids=["both above", "both below", "turned round"])
def test_ends_without_their_signs_are_no_crossing(monkeypatch: pytest.MonkeyPatch, ends: tuple[int, int]) -> None:
    """The signs at the ends are compared once more, as evidence: what the bisection says is not enough."""
    found = stretches(fmpq(1, 2), 1, fmpq(-3))
    crossing = first_crossing(found, lambda _: arb(2), 3)
    assert crossing is not None
    assert len(crossing.evidence.facts) == 4  # at the start, at both ends, and once more at the start for the number
    assert 1 < crossing.lower < crossing.upper < 9
    wrong = (fmpq(ends[0]), fmpq(ends[1]))
    monkeypatch.setattr("gspot_verified.leading_order.stretches.narrowed", lambda *_: wrong)
    assert first_crossing(found, lambda _: arb(2), 3) is None


def test_an_open_sign_beyond_the_crossing_leaves_the_number_open() -> None:
    """-dTheta/dtau falls through 5 before its first critical point; a later value is not told from 5."""
    beta = fmpq(7, 2)
    found = stretches(beta, -1, fmpq(-3))
    start, (first, *_) = found.start, found.critical
    assert first.value < 5 < start.value
    unsure = Bracket(first.upper + 1, first.upper + 2, arb(5, 10))
    crossing = first_crossing(Stretches(beta, -1, start, (first, unsure), False), lambda _: arb(-5), 5)
    assert crossing is not None
    assert crossing.number is None
    exact_zero = Bracket(first.upper + 1, first.upper + 2, arb(5))
    crossing = first_crossing(Stretches(beta, -1, start, (first, exact_zero), False), lambda _: arb(-5), 5)
    assert crossing is not None
    assert crossing.number is None


def test_an_open_sign_before_the_crossing_leaves_it_open() -> None:
    beta = fmpq(7, 2)
    found = stretches(beta, -1, fmpq(-3))
    first = found.critical[0]
    unsure = Bracket(first.lower, first.upper, arb(5, 10))
    assert first_crossing(found, lambda _: arb(-5), 5) is not None
    assert (
        first_crossing(Stretches(beta, -1, found.start, (unsure, *found.critical[1:]), False), lambda _: arb(-5), 5)
        is None
    )


def test_a_crossing_close_to_the_start_with_fifteen_decimals_and_with_two() -> None:
    """Its lower end is the start itself, above the level, where the last critical value lies below it."""
    found = stretches(fmpq(7, 2), -1, fmpq(-3))
    level = arb(fmpq(1, 10**4)) - found.start.value.mid()
    assert found.critical[-1].value + level < 0
    close, fine = first_crossing(found, lambda _: level, 2), first_crossing(found, lambda _: level)
    assert close is not None
    assert close.lower == -3
    assert fine is not None
    assert fine.upper - fine.lower == fmpq(1, 10**15)
    assert close.lower < fine.lower < fine.upper < close.upper


@given(st.fractions(-5, 5, max_denominator=30), st.integers(0, 6))
def test_narrowed_keeps_the_crossing(root: Fraction, digits: int) -> None:
    target = to_fmpq(root)
    lower, upper = narrowed(lambda tau: tau > target, fmpq(-17, 3), fmpq(19, 3), digits)
    assert lower <= target < upper
    assert upper - lower <= fmpq(1, 10**digits)


@pytest.mark.parametrize("start", [-10, -3])
@pytest.mark.parametrize("height", [fmpq(1, 2), fmpq(2), fmpq(40)])
def test_a_crossing_lies_between_a_point_above_and_a_point_below(start: int, height: fmpq) -> None:
    """0 < β < 1: dΘ/dτ falls from 0 to -infinity, so each level below its value at the start is crossed once."""
    beta = fmpq(1, 2)

    def level(_: int) -> arb:
        return arb(height)

    found = first_crossing(stretches(beta, 1, fmpq(start)), level, 8)
    assert found is not None
    assert found.number == 1
    assert start <= found.lower < found.upper <= found.lower + fmpq(1, 10**8)
    for tau, side in ((found.lower, 1), (found.upper, -1)):
        value = evaluate(tau, beta, derivative=1, digits=30).value + level(0)
        assert sign_of(value) == side


def test_a_crossing_far_to_the_right_and_one_too_far(monkeypatch: pytest.MonkeyPatch) -> None:
    """0 < β < 1: dΘ/dτ falls like -exp(2/3 τ^(3/2)), so the level 10^3000 is crossed near τ = 475."""
    found = stretches(fmpq(1, 2), 1, fmpq(-3))
    with working_bits(64):
        height = arb(10) ** 3000
    crossing = first_crossing(found, lambda _: height, 3)
    assert crossing is not None
    assert 400 < crossing.lower < crossing.upper < 500
    monkeypatch.setattr("gspot_verified.leading_order.stretches._MAX_TAU", fmpq(100))
    assert first_crossing(found, lambda _: height, 3) is None


@pytest.mark.parametrize(
    ("lower", "upper", "root", "expected"),
    [
        (fmpq(0), fmpq(15, 100), fmpq(12, 100), (fmpq(1, 10), fmpq(15, 100))),
        (fmpq(1, 100), fmpq(12, 100), fmpq(5, 100), (fmpq(1, 100), fmpq(1, 10))),
        (fmpq(1, 100), fmpq(12, 100), fmpq(11, 100), (fmpq(1, 10), fmpq(12, 100))),
    ],
)
def test_ends_beside_the_grid_are_kept(lower: fmpq, upper: fmpq, root: fmpq, expected: tuple[fmpq, fmpq]) -> None:
    assert narrowed(lambda tau: tau > root, lower, upper, 1) == expected


@pytest.mark.parametrize("tries", [1, 2, 3, 4])
@pytest.mark.parametrize("side", [1, -1])
def test_what_a_coarse_ball_leaves_open_is_asked_again_of_finer_ones(tries: int, side: int) -> None:
    """The level is 1 away from the function's value, and known well enough at the ``tries``-th accuracy only."""
    tau, found = fmpq(1, 3), stretches(fmpq(7, 2), -1, fmpq(-3))
    value = value_at(tau, found.beta, found.sign).mid()
    asked: list[int] = []

    def level(digits: int) -> arb:
        asked.append(digits)
        with working_bits(200):
            return arb(side) - value + arb(0, fmpq(1, 2) if len(asked) >= tries else 2)

    answer = _below(_height(found, level, 8))(tau)
    assert answer is (None if tries > 3 else side < 0)
    assert len(asked) == min(tries, 3)
    assert asked == sorted(set(asked))
    assert asked[0] > 8


def test_a_value_that_is_exactly_the_level_is_not_below_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("gspot_verified.leading_order.stretches.sign_of", lambda _: 0)
    assert _below(_height(stretches(fmpq(7, 2), -1, fmpq(-3)), lambda _: arb(1), 8))(fmpq(0)) is None
