"""The fold at one epsilon: seen values, the exact one at epsilon = 32, the number of zeros on both sides, bad input.

Page: proofs/finite_epsilon_zeros.md.
"""

from __future__ import annotations

import inspect

import pytest
from flint import arb, fmpq

from gspot_verified.compliant.zeros import fold_point as fold_point_module
from gspot_verified.compliant.zeros.fold_column import fold_parts
from gspot_verified.compliant.zeros.fold_point import _convexity, _is_positive, fold_point
from gspot_verified.compliant.zeros.zero_count import slow_zeros
from gspot_verified.numbers.balls import exact, working_bits


@pytest.mark.parametrize(
    ("epsilon", "beta_f"),
    [
        ("1e-6", "5.9999625"), ("1e-3", "5.9961939"), ("1e-2", "5.982103"), (".1", "5.916976"), ("1", "5.670239"),
        ("4", "5.398791"), ("100", "4.840875"), ("500", "4.682690"),
    ],
)  # fmt: skip
def test_seen_values(epsilon: str, beta_f: str) -> None:
    found = fold_point(epsilon, 9)
    assert found is not None
    assert 0 < found.upper - found.lower <= fmpq(1, 10**9)
    seen = exact(beta_f, "seen")
    assert abs(found.lower - seen) < fmpq(6, 10 ** (1 + len(beta_f.split(".")[1])))


@pytest.mark.parametrize("epsilon", ["1e-4", "1", "3"])
def test_the_curve_from_9(epsilon: str) -> None:
    found = fold_point(epsilon, 9, meeting=9)
    assert found is not None
    assert fmpq(6) < found.lower < found.upper < 9
    before, after = (slow_zeros(end, epsilon, digits=2).number for end in (found.lower, found.upper))
    assert before is not None
    assert after == before - 2


@pytest.mark.parametrize(("epsilon", "beta"), [("1.52778830963922", 8), ("17.554869316376667", 7)])
def test_the_curve_from_9_passes_integers_where_the_polynomial_has_a_double_zero(epsilon: str, beta: int) -> None:
    found = fold_point(epsilon, 6, meeting=9)
    assert found is not None
    assert abs(found.lower - beta) < fmpq(1, 10**5)


@pytest.mark.parametrize("epsilon", ["1e-4", "3", "60"])
def test_two_zeros_less_beyond(epsilon: str) -> None:
    found = fold_point(epsilon, 12)
    assert found is not None
    before, after = (slow_zeros(end, epsilon, digits=2).number for end in (found.lower, found.upper))
    assert before is not None
    assert after == before - 2


def test_the_fold_at_epsilon_32_is_at_5() -> None:
    """F_4 has its double zero there: no bracket can be shown to lie on one side of it."""
    found = fold_point(32, 9)
    assert found is not None
    assert found.lower < 5 < found.upper


def test_more_digits_lie_inside() -> None:
    coarse, fine = fold_point("1/7", 6), fold_point("1/7", 30)
    assert coarse is not None
    assert fine is not None
    assert coarse.lower <= fine.lower < fine.upper <= coarse.upper
    assert fine.upper - fine.lower <= fmpq(1, 10**30)


@pytest.mark.parametrize(
    ("epsilon", "digits", "message"),
    [(0, 8, "epsilon"), (501, 8, "epsilon"), (arb(1, 1), 8, "one exact"), (1, 0, "digits"), (1, 41, "digits")],
)
def test_refused(epsilon: object, digits: int, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        fold_point(epsilon, digits)  # type: ignore[arg-type]


def test_only_the_curves_from_6_and_9() -> None:
    with pytest.raises(ValueError, match="meeting"):
        fold_point(1, 8, meeting=12)


class _Curvatures:
    """Gives one value of G''/2 for each interval, one after the other."""

    def __init__(self, values: list[arb]) -> None:
        self._values = iter(values)

    def coefficients(self, *_: object) -> list[arb]:
        return [arb(0), arb(0), next(self._values)]


@pytest.mark.parametrize("least", [0, 1, 2])
def test_the_convexity_is_below_all_parts(least: int) -> None:
    """Curvatures that floats do not tell apart: the bound is below each of them."""
    begin, end = fmpq(1, 100), fmpq(2, 100)
    with working_bits(128):
        values = [1 + arb((1, -90))] * len(fold_parts(begin, end))
        values[least] = arb(1)
        found = _convexity(_Curvatures(values), begin, end)  # type: ignore[arg-type]
        assert found > 0
        assert all(found <= value for value in values)


def test_the_least_epsilon_is_within_the_range(monkeypatch: pytest.MonkeyPatch) -> None:
    """10^-9 is looked at, and what is below it is refused; eight digits unless others are asked for."""

    class LookedAt(Exception):
        pass

    def search(*_: object) -> None:
        raise LookedAt

    monkeypatch.setattr(fold_point_module, "_search", search)
    with pytest.raises(LookedAt):
        fold_point("1e-9")
    with pytest.raises(ValueError, match="epsilon"):
        fold_point("0.999e-9")
    assert inspect.signature(fold_point).parameters["digits"].default == 8


def _parabola(monkeypatch: pytest.MonkeyPatch, least: fmpq, place: fmpq, curvature: arb) -> None:
    """least + curvature (tau - place)^2 in the place of the slow solution."""

    def jet(tau: fmpq, *_: object) -> list[arb]:
        away = arb(tau - place)
        return [least + curvature * away * away, 2 * curvature * away, curvature]

    monkeypatch.setattr(fold_point_module, "slow_jet", jet)


@pytest.mark.parametrize("curvature", [fmpq(1, 100), fmpq(1, 10), fmpq(10)])
def test_positive_is_said_of_the_whole_interval(monkeypatch: pytest.MonkeyPatch, curvature: fmpq) -> None:
    """A parabola whose minimum is not where Newton begins: its sign there decides, however flat it is."""
    for least, answer in ((fmpq(1, 10**6), True), (fmpq(-1, 10**6), False)):
        _parabola(monkeypatch, least, fmpq(1, 3), arb(curvature))
        assert _is_positive(fmpq(4), fmpq(1), (fmpq(-1), fmpq(1)), arb(curvature), 64) is answer
    # A lower bound of the curvature that is too small by a share 2^-20 still suffices; one that is far too small not.
    _parabola(monkeypatch, fmpq(1, 10**6), fmpq(0), arb(curvature))
    assert _is_positive(fmpq(4), fmpq(1), (fmpq(-1), fmpq(1)), arb(curvature) * (1 - arb((1, -20))), 64) is True


def test_a_minimum_outside_the_interval_and_one_that_is_not_found_leave_the_sign_open(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    interval = (fmpq(-1), fmpq(1))
    _parabola(monkeypatch, fmpq(-1), fmpq(3), arb(1))
    assert _is_positive(fmpq(4), fmpq(1), interval, arb(1), 64) is None
    _parabola(monkeypatch, fmpq(0), fmpq(0), arb(1))
    assert _is_positive(fmpq(4), fmpq(1), interval, arb(1), 64) is None
    # G'' is not known there: no Newton step can be made.
    _parabola(monkeypatch, fmpq(1, 100), fmpq(1, 2), arb(1, 2))
    assert _is_positive(fmpq(4), fmpq(1), interval, arb(fmpq(1, 1000)), 64) is None
