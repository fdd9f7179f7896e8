"""Tubes: Krawczyk's operator with parameters, against square roots and products in closed form.

Page: proofs/sweep.md, sections 1 to 3.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, arb_mat, fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Constant, Expression, Variable
from gspot_verified.mechanisms.sweep.sweep_links import same_zero
from gspot_verified.mechanisms.sweep.sweep_start import Origin, proved_tube
from gspot_verified.mechanisms.zeros.tube import Equations, OnTube, _turning, try_tube
from gspot_verified.numbers.balls import working_bits

X, PARAMETER = Variable(0), Variable(1)
ROOT = Equations(BoxProgram([X * X - PARAMETER, X * PARAMETER, PARAMETER / X], 2), 1)
"""x^2 = λ, with the further functions x λ and λ/x."""


def root_tube(lower: fmpq, upper: fmpq, sign: int = 1, equations: Equations = ROOT) -> OnTube | None:
    middle = (lower + upper) / 2
    start = (
        fmpq(*(sign * float(middle.p) ** 0.5 / float(middle.q) ** 0.5).as_integer_ratio()) if middle > 0 else fmpq(0)
    )
    slope = 1 / (2 * start) if start != 0 else fmpq(0)
    return proved_tube(equations, (lower,), (upper,), Origin((middle,), (start,), ((slope,),)))


def holds(value: arb, exact: arb) -> bool:
    return bool(value.is_finite() and value.contains(exact))


@given(
    st.fractions(Fraction(1, 2), 50, max_denominator=1000),
    st.fractions(0, Fraction(1, 3), max_denominator=1000),
    st.fractions(0, 1, max_denominator=1000),
    st.sampled_from([1, -1]),
)
def test_the_root_is_in_the_tube_with_its_functions(middle: Fraction, part: Fraction, at: Fraction, sign: int) -> None:
    lower, upper = (fmpq(end.numerator, end.denominator) for end in (middle * (1 - part), middle * (1 + part)))
    place = lower + (upper - lower) * fmpq(at.numerator, at.denominator)
    with working_bits(80):
        on = root_tube(lower, upper, sign)
        assert on is not None
        with working_bits(300):
            root = sign * arb(place).sqrt()
        assert on.tube.holds_at((place,), [root])
        assert not on.tube.holds_at((place,), [-root])
        with working_bits(120):
            assert holds(on.tube.zero_at((place,))[0], root)
            product, quotient = on.quantities
            assert holds(on.value(product), root * arb(place))
            assert holds(on.slopes(product)[0], 3 * root / 2)
            assert holds(on.value(quotient), root)
            assert holds(on.slopes(quotient)[0], 1 / (2 * root))
            assert holds(on.value(product - quotient), root * arb(place) - root)
            assert holds(on.slopes(product / quotient)[0], arb(1))


@pytest.mark.parametrize(("lower", "upper"), [(-1, 1), (0, 1), (-2, -1), (0, 0)])
def test_no_tube_where_there_is_none(lower: int, upper: int) -> None:
    with working_bits(80):
        assert root_tube(fmpq(lower), fmpq(upper)) is None


def test_widths_shrink_with_the_square_of_the_side() -> None:
    with working_bits(80):
        wide, narrow = root_tube(fmpq(1), fmpq(5, 4)), root_tube(fmpq(1), fmpq(33, 32))
        assert wide is not None
        assert narrow is not None
        assert wide.tube.found[0].rad() > 40 * narrow.tube.found[0].rad()


def test_two_parameters() -> None:
    """x = λ_0 λ_1, so that x - λ_0 λ_1 + λ_1 - λ_1 has the slopes λ_1 and λ_0."""
    first, second = Variable(1), Variable(2)
    cube = X * X * X
    equations = Equations(BoxProgram([cube + X - first * second, cube], 3), 1)
    lower, upper = (fmpq(1), fmpq(2)), (fmpq(9, 8), fmpq(17, 8))
    with working_bits(80):
        on = proved_tube(equations, lower, upper, Origin((fmpq(1), fmpq(2)), (fmpq(1),), ((fmpq(0), fmpq(0)),)))
        assert on is not None
        assert holds(on.tube.zero_at((fmpq(1), fmpq(2)))[0], arb(1))
        slopes = on.slopes(on.quantities[0])
        # x = 1 at (1, 2): (3 x^2 + 1) x' = λ_1 or λ_0, and (x^3)' = 3 x^2 x'.
        assert holds(slopes[0], arb(fmpq(3, 2)))
        assert holds(slopes[1], arb(fmpq(3, 4)))


def test_tubes_of_two_roots_are_not_the_same() -> None:
    with working_bits(80):
        first, second, other = root_tube(fmpq(1), fmpq(2)), root_tube(fmpq(2), fmpq(3)), root_tube(fmpq(2), fmpq(3), -1)
        assert first is not None
        assert second is not None
        assert other is not None
        assert same_zero(ROOT, first.tube, second.tube, (fmpq(2),))
        assert not same_zero(ROOT, first.tube, other.tube, (fmpq(2),))
        assert not same_zero(ROOT, other.tube, first.tube, (fmpq(2),))


def test_two_roots_close_by_are_told_apart() -> None:
    """(x - λ) (x - λ - d) with d = 2^-20: the tube around one root never holds the other."""
    end = fmpq(1, 2**27)
    gap = fmpq(1, 2**20)
    function: Expression = (X - PARAMETER) * (X - PARAMETER - Constant(gap))
    equations = Equations(BoxProgram([function], 2), 1)
    with working_bits(80):
        for start in (fmpq(0), gap):
            on = proved_tube(equations, (-end,), (end,), Origin((fmpq(0),), (start,), ((fmpq(1),),)))
            assert on is not None
            for place in (-end, end / 3, end):
                assert on.tube.holds_at((place,), [arb(place + start)])
                assert not on.tube.holds_at((place,), [arb(place + gap - start)])


def test_hypotheses_are_checked() -> None:
    lower, upper, centre, slope, width = (fmpq(1),), (fmpq(2),), arb(1), arb(0), arb(0, "0.5")
    with working_bits(80):
        with pytest.raises(ValueError, match="exact"):
            try_tube(ROOT, lower, upper, [arb(1, "0.1")], [[slope]], [width])
        with pytest.raises(ValueError, match="exact"):
            try_tube(ROOT, lower, upper, [centre], [[arb(0, 1)]], [width])
        with pytest.raises(ValueError, match="hold 0"):
            try_tube(ROOT, lower, upper, [centre], [[slope]], [arb(1, "0.5")])


def test_a_tube_that_is_too_narrow_is_not_proved() -> None:
    """x = sqrt(λ) leaves the constant 5/4 by more than 1/100 on [1, 2]."""
    with working_bits(80):
        attempt = try_tube(ROOT, (fmpq(1),), (fmpq(2),), [arb(1.25)], [[arb(0)]], [arb(0, "0.01")])
        assert attempt is not None
        assert attempt.proved is None


def test_no_information_proves_nothing() -> None:
    equations = Equations(BoxProgram([PARAMETER / X - X], 2), 1)
    with working_bits(80):
        assert try_tube(equations, (fmpq(1),), (fmpq(2),), [arb(0)], [[arb(0)]], [arb(0, 1)]) is None


@pytest.mark.parametrize("entry", ["0.5", "-0.5", "0.9"])
def test_slopes_hold_the_whole_geometric_series(entry: str) -> None:
    """z' = E z' - r has the solution -r/(1 - E), not the first terms of its series."""
    with working_bits(80):
        error = arb(entry)
        ((slope,),) = _turning(arb_mat([[error]]), arb_mat([[arb(1)]]), [arb(0, 1)], 1)
        assert holds(slope, -1 / (1 - error.mid()))


@pytest.mark.parametrize("error", [arb(1), arb(-2), arb(0, 1), arb("nan")])
def test_no_slopes_without_a_contraction(error: arb) -> None:
    with working_bits(80):
        ((slope,),) = _turning(arb_mat([[error]]), arb_mat([[arb(1)]]), [arb(0, 1)], 1)
        assert not slope.is_finite()
