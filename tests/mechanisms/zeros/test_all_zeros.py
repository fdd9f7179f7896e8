"""Branch and prune: all zeros of functions with known zeros; seams, corners, double zeros, budgets.

proofs/all_g_spots.md, section 3.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import ends, holds, to_fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Constant, Cosine, Expression, Power, Product, Sine, Variable
from gspot_verified.mechanisms.zeros import all_zeros
from gspot_verified.mechanisms.zeros.all_zeros import Budget, Zeros, ZeroSearch
from gspot_verified.numbers.balls import working_bits

X, Y = Variable(0), Variable(1)


def c(value: int | Fraction) -> Constant:
    return Constant(to_fmpq(Fraction(value)))


def search(functions: list[Expression], box: list[arb], budget: int = 20_000, turns: bool = False) -> Zeros:
    with working_bits(100):
        periods = [2 * arb.pi() if turns else None for _ in box]
        program = BoxProgram(functions, len(box), list(range(len(box))))
        return ZeroSearch(program, [arb(0)] * len(box), periods).run(box, Budget(budget))


def with_roots(roots: list[Fraction]) -> Expression:
    function: Expression = c(1)
    for root in roots:
        function = Product(function, X - c(root))
    return function


@settings(deadline=None, max_examples=40)
@given(st.sets(st.fractions(-1, 1, max_denominator=40), min_size=1, max_size=5))
def test_all_roots_of_a_polynomial(roots: set[Fraction]) -> None:
    found = search([with_roots(sorted(roots))], [arb(0, 1)])
    assert not found.left
    assert len(found.zeros) == len(roots)
    for root in roots:
        assert sum(holds(zero.enclosure[0], root) for zero in found.zeros) == 1


@settings(deadline=None, max_examples=20)
@given(
    st.sets(st.fractions(0, 1, max_denominator=12), min_size=1, max_size=3),
    st.sets(st.fractions(0, 1, max_denominator=12), min_size=1, max_size=3),
    st.integers(-3, 3),
)
def test_a_grid_of_zeros_in_two_variables(first: set[Fraction], second: set[Fraction], skew: int) -> None:
    """Also on the edges and corners of the box [0, 1]^2, where 0 and 1 are among the roots."""
    one = with_roots(sorted(first))
    other: Expression = c(1)
    for root in second:
        other = Product(other, Y - c(root))
    found = search([one, other + c(skew) * one], [arb(fmpq(1, 2), 0.5), arb(fmpq(1, 2), 0.5)])
    assert not found.left
    expected = [(x, y) for x in first for y in second]
    assert len(found.zeros) == len(expected)
    for x, y in expected:
        assert sum(holds(z.enclosure[0], x) and holds(z.enclosure[1], y) for z in found.zeros) == 1


@pytest.mark.parametrize("gap", [10, 20, 40, 80, 140])
def test_nearly_equal_zeros_are_two(gap: int) -> None:
    found = search([X * X - Constant(fmpq(1, 2**gap))], [arb(0, 1)])
    assert not found.left
    assert len(found.zeros) == 2
    signs = sorted(1 if zero.enclosure[0] > 0 else -1 for zero in found.zeros)
    assert signs == [-1, 1]


@pytest.mark.parametrize("gap", [10, 20, 40, 80, 140])
def test_zeros_that_nearly_exist_are_none(gap: int) -> None:
    found = search([X * X + Constant(fmpq(1, 2**gap))], [arb(0, 1)])
    assert not found.left
    assert not found.zeros


def test_a_double_zero_is_left() -> None:
    for root in (Fraction(0), Fraction(1, 3), Fraction(1)):
        found = search([Power(X - c(root), fmpq(2))], [arb(0, 1)])
        assert not found.zeros
        assert found.left
        assert any(holds(box[0], root) for box in found.left)
        assert all(box[0].rad() < 1e-20 for box in found.left)


def test_a_zero_at_the_seam_is_one() -> None:
    for function in (Sine(X), Sine(X) * (c(2) + Cosine(X)), Cosine(c(Fraction(1)) * X) + c(Fraction(1, 3))):
        found = search([function], [arb(0, arb.pi().upper())], turns=True)
        assert not found.left
        assert len(found.zeros) == 2  # sin: 0 and pi, which is -pi
    double = search([Cosine(X) + c(1)], [arb(0, arb.pi().upper())], turns=True)
    assert not double.zeros
    assert double.left


def test_two_angles_at_the_corner_of_the_square() -> None:
    side = arb(0, arb.pi().upper())
    found = search([Sine(X) + Sine(Y) * c(2), Sine(Y)], [side, side], turns=True)
    assert not found.left
    assert len(found.zeros) == 4


def test_a_function_that_vanishes_everywhere_has_no_proved_zero_and_stays_open() -> None:
    found = search([Sine(X) * Sine(X) + Cosine(X) * Cosine(X) - c(1)], [arb(0, 1)])
    assert not found.zeros
    assert found.stopped
    sides = sorted(ends(box[0]) for box in found.left)
    assert sides[0][0] <= -1
    reached = sides[0][1]
    for lower, upper in sides:
        assert lower <= reached  # no gap
        reached = max(reached, upper)
    assert reached >= 1


@pytest.mark.parametrize("budget", [1, 2, 3, 5, 9])
def test_a_small_budget_never_loses_a_zero(budget: int) -> None:
    roots = [Fraction(-1), Fraction(-1, 2), Fraction(1, 3), Fraction(1)]
    found = search([with_roots(roots)], [arb(0, 1)], budget)
    for root in roots:
        known = any(holds(zero.enclosure[0], root) for zero in found.zeros)
        assert known or any(holds(box[0], root) for box in found.left)


def test_more_conditions_than_unknowns() -> None:
    assert not search([X, X - c(1)], [arb(0, 2)]).left
    found = search([X, Product(X, X - c(1))], [arb(0, 2)])
    assert not found.zeros
    assert any(holds(box[0], 0) for box in found.left)


def test_where_a_function_is_undefined_nothing_is_excluded() -> None:
    found = search([Power(X, fmpq(1, 2)) - c(1)], [arb(0, 4)])
    assert len(found.zeros) == 1
    assert holds(found.zeros[0].enclosure[0], 1)
    assert any(holds(box[0], -2) for box in found.left)
    assert any(holds(box[0], 0) for box in found.left)
    assert not any(holds(box[0], 1) for box in found.left)


def test_a_curve_of_zeros_is_said_before_the_budget_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(all_zeros, "_MANY", 20)
    found = search([Sine(X) - Sine(Y), X - Y], [arb(0, 1), arb(0, 1)])
    assert found.stopped == "zeros may form a curve: more than 20 small boxes could not be settled"
    assert len(found.left) >= 20


def test_every_box_that_is_looked_at_counts() -> None:
    """x = 1/3 is proved in the whole box [-1, 1], and x + 2 is excluded there; at a budget of 1 that is enough."""
    for function, zeros in ((X - c(Fraction(1, 3)), 1), (X + c(2), 0)):
        budget = Budget(1)
        found = ZeroSearch(BoxProgram([function], 1), [arb(0)], [None]).run([arb(0, 1)], budget)
        assert (len(found.zeros), found.left, found.stopped, budget.boxes) == (zeros, [], "", 0)


def test_the_evidence_counts_every_box_and_every_zero() -> None:
    roots = [Fraction(-1, 2), Fraction(1, 3), Fraction(1, 2)]
    found = search([with_roots(roots)], [arb(0, 1)])
    assert found.evidence is not None
    facts = found.evidence.facts
    assert facts[0] == f"{len(found.settled)} = {len(found.halved) + 1}"
    assert len(found.halved) > 1
    assert any("!=" in fact for fact in facts)
    assert sum("2 boxes cover" in fact for fact in facts) == len(found.halved)
    assert sum("lies in the interior of" in fact for fact in facts) == sum(len(zero.regions) for zero in found.zeros)
    for wrong in (
        replace(found, settled=found.settled[1:]),
        replace(found, halved=found.halved[1:]),
        replace(found, halved=[None, *found.halved[1:]]),
        replace(found, left=[(arb(0),)]),
        replace(found, zeros=[replace(found.zeros[0], shown=[])]),
        replace(found, zeros=[replace(found.zeros[0], shown=[None])]),
    ):
        assert wrong.evidence is None


@pytest.mark.parametrize("keep", [(0,), (1,), (0, 0), (1, 1), (), (0, 1, 1)], ids=str)
def test_a_half_that_is_left_out_leaves_no_evidence(keep: tuple[int, ...], monkeypatch: pytest.MonkeyPatch) -> None:
    """One half forgotten, both, or one taken twice: zeros are missing, and nothing says that these are all."""
    whole = ZeroSearch._halves
    function = [X * X * (X * X + c(1)) - c(Fraction(1, 4))]
    assert search(function, [arb(0, 1)]).evidence is not None

    def some(self: ZeroSearch, box: all_zeros.Box) -> list[all_zeros.Box]:
        halves = whole(self, box)
        return [halves[k] for k in keep]

    monkeypatch.setattr(ZeroSearch, "_halves", some)
    assert search(function, [arb(0, 1)], budget=500).evidence is None


def test_halves_that_do_not_cover_their_box_leave_no_evidence(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each half a little too short: between them is a gap, in which no zero would be seen."""
    whole = ZeroSearch._halves

    def shorter(self: ZeroSearch, box: all_zeros.Box) -> list[all_zeros.Box]:
        return [tuple(side.mid() + (side - side.mid()) * arb("0.999") for side in half) for half in whole(self, box)]

    monkeypatch.setattr(ZeroSearch, "_halves", shorter)
    found = search([with_roots([Fraction(-1, 2), Fraction(1, 2)])], [arb(0, 1)])
    assert len(found.zeros) == 2
    assert found.evidence is None


def test_zeros_that_may_be_one_are_not_called_two(monkeypatch: pytest.MonkeyPatch) -> None:
    """A zero that cannot be told from those known is not counted, and its box is left."""
    two = [with_roots([Fraction(-1, 2), Fraction(1, 2)])]
    monkeypatch.setattr(ZeroSearch, "_apart", lambda *_: None)
    found = search(two, [arb(0, 1)], budget=200)
    assert len(found.zeros) == 1
    assert found.left


def test_a_box_without_zeros_is_excluded_by_the_operator() -> None:
    """x + y = 3/2 and x - y = 3/2 meet at (3/2, 0): each vanishes in [-1, 1]^2, but not both."""
    budget = Budget(1)
    program = BoxProgram([X + Y - c(Fraction(3, 2)), X - Y - c(Fraction(3, 2))], 2)
    found = ZeroSearch(program, [arb(0)] * 2, [None] * 2).run([arb(0, 1), arb(0, 1)], budget)
    assert (found.zeros, found.left, found.stopped, budget.boxes) == ([], [], "", 0)


@settings(deadline=None, max_examples=25)
@given(
    st.sets(st.fractions(-1, 1, max_denominator=30), min_size=1, max_size=5),
    st.fractions(-1, 1, max_denominator=30),
    st.sampled_from([-1, 1]),
)
def test_with_an_objective_the_zeros_at_which_it_is_largest_are_found(
    roots: set[Fraction], centre: Fraction, sign: int
) -> None:
    """sign (x - centre)^2, which two zeros may share; a zero may be left out only where it is certainly less."""
    distance = X - c(centre)
    with working_bits(100):
        wanted = BoxProgram([c(sign) * (distance * distance)], 1, [0])
        program = BoxProgram([with_roots(sorted(roots))], 1, [0])
        found = ZeroSearch(program, [arb(0)], [None], wanted).run([arb(0, 1)], Budget(20_000))
    assert not found.left
    assert found.evidence is not None
    values = {root: sign * (root - centre) ** 2 for root in roots}
    best = max(values.values())
    for root, value in values.items():
        count = sum(holds(zero.enclosure[0], root) for zero in found.zeros)
        assert count == 1 if value == best else count <= 1


def test_with_an_objective_boxes_below_a_known_zero_are_dropped_unsearched() -> None:
    """sin on [0, 100 pi] with the objective -x: the zeros far to the right cost next to nothing."""
    with working_bits(100):
        program, wanted = BoxProgram([Sine(X)], 1, [0]), BoxProgram([c(-1) * X], 1, [0])
        counts = []
        for objective in (None, wanted):
            budget = Budget(20_000)
            found = ZeroSearch(program, [arb(0)], [None], objective).run([arb("157", "158")], budget)
            assert not found.left
            assert found.evidence is not None
            counts.append((len(found.zeros), 20_000 - budget.boxes))
    assert any(zero.enclosure[0].contains(0) for zero in found.zeros)
    (every_zero, all_boxes), (few, boxes) = counts
    assert every_zero == 101
    assert few <= 101
    assert boxes < all_boxes


def test_without_an_objective_value_yet_no_box_is_below_it() -> None:
    with working_bits(100):
        state = [arb(0, 1)]
        one = BoxProgram([X], 1, [0])
        assert ZeroSearch(one, [arb(0)], [None], one)._below(state) is None
        made = ZeroSearch(one, [arb(0)], [None], one)
        for reached, below in (("1.5", True), ("1", False), ("0.5", False)):
            made._reached = arb(reached)
            assert (made._below(state) is not None) is below
        assert ZeroSearch(one, [arb(0)], [None])._below(state) is None


@given(st.fractions(-20, 20, max_denominator=50), st.fractions(-20, 20, max_denominator=50), st.integers(-9, 9))
def test_a_box_is_found_again_any_number_of_periods_away(place: Fraction, period: Fraction, turns: int) -> None:
    if period == 0:
        return
    with working_bits(100):
        one = ZeroSearch(BoxProgram([Sine(X)], 1, [0]), [arb(0)], [arb(to_fmpq(period))])
        side, small = arb(to_fmpq(place)), arb(0, arb(to_fmpq(abs(period) / 8)))
        target = side + turns * arb(to_fmpq(period)) + small
        assert one.lies_in([side], [target]) is not None
        assert one._apart([side], [target]) is None
        beside = target + arb(to_fmpq(period / 2))
        assert one.lies_in([side], [beside]) is None
        assert one._apart([side], [beside]) is not None
