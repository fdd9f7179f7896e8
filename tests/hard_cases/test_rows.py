"""Every row of the catalogue: the certified answer by a second route, and the double's right or wrong beside that."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from flint import arb, fmpq
from hard_cases.truths import TRUTHS, Truth, exact
from witnesses.theta import ends

from gspot_verified.expansion.trajectory import expand_in_balls
from gspot_verified.hard_cases import compliant_cases, expansion_cases
from gspot_verified.hard_cases.catalogue import families
from gspot_verified.hard_cases.hard_case import RIGHT_DIGITS, HardCase, near
from gspot_verified.mechanisms.expand import expand
from gspot_verified.mechanisms.shipped import shipped_system
from gspot_verified.numbers.balls import working_bits

ROWS = [(family, level) for family in families() for level in family.levels]
UNDECIDED = {("spots-meet", 120), ("fold-curve", 20)}
COSTLY = {"run", "fold-curve", "uniform"}
"""Whose levels between the first and the last are slow tests."""


def parameters() -> list[object]:
    found = []
    for family, level in ROWS:
        middle = family.name in COSTLY and level not in (family.levels[0], family.levels[-1])
        marks = [pytest.mark.slow] if middle else []
        found.append(pytest.param(family, level, marks=marks, id=f"{family.name}-{level}"))
    return found


def holds(certified: arb | fmpq | int, truth: Truth) -> bool:
    """Whether the certified answer is, contains or meets the truth."""
    if isinstance(certified, int):
        return certified == truth
    assert not isinstance(truth, int)
    lower, upper = ends(certified) if isinstance(certified, arb) else (exact(certified),) * 2
    first, last = truth if isinstance(truth, tuple) else (truth, truth)
    # The witnesses have 10^-25 of their own.
    spare = abs(last) / 10**25
    return lower - spare <= last and first <= upper + spare


def right(double: float | None, truth: Truth) -> bool:
    if double is None or not math.isfinite(double):
        return False
    if isinstance(truth, int):
        return double == truth
    value = truth[0] if isinstance(truth, tuple) else truth
    return abs(Fraction(double) - value) <= abs(value) / 10**RIGHT_DIGITS


@pytest.mark.parametrize(("family", "level"), parameters())
def test_row(family, level):
    row: HardCase = family.case(level)
    assert row.level == level
    assert row.seconds >= 0
    assert row.lost is None or row.lost >= 0
    if (family.name, level) in UNDECIDED:
        assert row.certified is None
        assert row.double_right is None
        return
    assert row.certified is not None, row.text
    if family.name == "high-order":
        return  # below
    truth = TRUTHS[family.name](level)
    assert holds(row.certified, truth), (row.text, truth)
    if isinstance(row.certified, arb):
        assert row.certified.is_finite()
    if row.double_text:
        assert row.double_right is right(row.double, truth)
    else:
        assert row.double_right is None


def test_every_family_has_a_second_route():
    names = {family.name for family in families()}
    assert names == {*TRUTHS, "high-order"}
    assert len(names) == len(families())


@pytest.mark.parametrize("name", ["side", "near-zero", "zeros-meet", "fold", "canard", "obstructed", "spots-gone"])
def test_the_usual_formula_loses_more_bits_than_a_double_has_at_last(name):
    """In balls, so that nothing here hangs on what a program in doubles happens to answer."""
    [family] = [family for family in families() if family.name == name]
    easy, hard = family.case(family.levels[0]), family.case(family.levels[-1])
    assert easy.lost is not None
    assert hard.lost is not None
    assert easy.lost < 53 < hard.lost


def test_high_orders():
    """Each coefficient of the exact recursion lies in a ball of the one in balls; the double is near it."""
    for order in (8, 16, 32):
        row = expansion_cases.high_order(order)
        system = shipped_system("extended", chi=1)
        exactly, balls = expand(system, order), expand_in_balls(system, order, 200)
        pairs = [
            (value, ball)
            for left, right_ in zip(exactly.lambda_n, balls.lambda_n, strict=True)
            for value, ball in zip(left.coefficients(), right_.coefficients(), strict=True)
        ]
        assert all(ball.is_finite() for _, ball in pairs)
        with working_bits(600):
            assert all(ball.overlaps(arb(value)) for value, ball in pairs)
        assert row.certified in [value for value, _ in pairs]
        assert row.double_right is right(row.double, exact(row.certified))


def test_the_work_of_a_row_does_not_depend_on_the_run():
    first, second = (compliant_cases.next_to_the_canard(60) for _ in range(2))
    assert (first.text, first.work, first.lost, first.condition) == (
        second.text, second.work, second.lost, second.condition,
    )  # fmt: skip


def test_the_size_of_the_deviation_scales_k():
    rows = [compliant_cases.tiny_deviation(k) for k in (10, 4000)]
    assert all(row.certified == rows[0].certified for row in rows)
    assert near(1, 3, -1) == fmpq(999, 1000)
