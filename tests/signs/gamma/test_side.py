"""Tests of what proofs/side_switching.md states."""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import near_integers, small_heights

from gspot_verified import gamma_sign, side
from gspot_verified.signs.gamma.side import MAX_BETA, SignInterval, gamma_sign_by_ball


@given(st.one_of(small_heights(), near_integers(400)))
def test_sign_by_parity_equals_the_sign_of_the_enclosure(beta: Fraction) -> None:
    parity, ball = gamma_sign(beta), gamma_sign_by_ball(beta)
    assert parity is not None
    assert ball == parity


@pytest.mark.parametrize(("beta", "sign"), [("-1/2", 1), ("1/2", -1), ("3/2", 1), ("5/2", -1), (0, 0), (7, 0), (-4, 1)])
def test_known_signs(beta: str, sign: int) -> None:
    assert gamma_sign(beta) == sign


def test_balls() -> None:
    assert gamma_sign(arb(fmpq(1, 2), fmpq(1, 4))) == -1
    assert gamma_sign(arb(1, fmpq(1, 4))) is None
    assert gamma_sign_by_ball(arb(1, fmpq(1, 4))) is None
    assert gamma_sign(arb(-5, 4)) == 1
    with pytest.raises(ValueError, match="finite"):
        gamma_sign(arb("nan"))


def test_an_exact_ball_of_many_bits_next_to_a_pole() -> None:
    assert gamma_sign(arb((3 * 2**1000 + 1, -1000))) == 1
    assert gamma_sign(arb((3 * 2**1000 - 1, -1000))) == -1


@given(st.fractions(-3, 30, max_denominator=40), st.fractions(0, 20, max_denominator=40))
def test_pieces_cover_the_range_and_alternate(lower: Fraction, width: Fraction) -> None:
    upper = lower + width
    found = side(lower, upper)
    assert not found.undecided
    assert found.integers == tuple(n for n in range(32 + 20) if lower <= n <= upper)
    ends = [lower, *(Fraction(n) for n in found.integers), upper]
    assert sum((i.upper - i.lower for i in found.intervals), Fraction(0)) == width
    for interval in found.intervals:
        assert interval.lower in ends
        assert interval.upper in ends
        if interval.lower < interval.upper:
            middle = (interval.lower + interval.upper) / 2
            assert gamma_sign_by_ball(middle) == interval.sign
        assert interval.lower_closed == (interval.lower == lower and gamma_sign(lower) != 0)
        assert interval.upper_closed == (interval.upper == upper and gamma_sign(upper) != 0)
        # Paper, Sec. 4.5: both signs of C_1 occur for beta > 1 only; for 0 < beta < 1 only C_1 < 0 does as eps -> 0.
        case_iii, some_case = interval.lower >= 1, interval.lower >= 0
        assert interval.lift_off_sign == (-interval.sign if case_iii else None)
        assert interval.impact_sign == (interval.sign if case_iii else -1 if some_case else None)
    for first, second in zip(found.intervals, found.intervals[1:], strict=False):
        assert first.upper == second.lower
        if second.upper > 0:
            assert first.sign == -second.sign or first.upper < 0


def test_ball_endpoints_list_the_integers_they_cannot_decide() -> None:
    found = side(arb(1, fmpq(1, 8)), arb(fmpq(7, 2), fmpq(1, 8)))
    assert found.undecided == (1,)
    assert found.integers == (2, 3)
    assert "undecided" in str(found)


def test_degenerate_ranges() -> None:
    assert side(2, 2).intervals == ()
    assert side(2, 2).integers == (2,)
    assert len(side("1/2", "1/2").intervals) == 1


def test_overlapping_ball_endpoints_are_not_a_reversed_range() -> None:
    found = side(arb(1, fmpq(1, 2)), arb(1, fmpq(1, 4)))
    assert found.undecided == (1,)


def test_many_integers_are_quick_and_too_many_are_refused() -> None:
    assert len(side(0, 99_999).integers) == 100_000
    with pytest.raises(ValueError, match="split"):
        side(0, 200_000)


@pytest.mark.parametrize(
    ("lower", "upper", "error", "message"),
    [
        (5, 1, ValueError, "reversed"),
        (0.5, 1, TypeError, "lower: a float"),
        (0, "abc", ValueError, "upper: expected a number"),
        (0, 10**7, ValueError, "upper: "),
        (arb("-inf"), 3, ValueError, "lower: the ball must be finite"),
    ],
)
def test_bad_input(lower: object, upper: object, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        side(lower, upper)  # type: ignore[arg-type]


def test_json() -> None:
    data = side("1/2", 2).to_json()
    assert data["integers"] == [1, 2]
    assert data["intervals"][0] == {
        "lower": "1/2", "upper": "1", "lower_closed": True, "upper_closed": False, "sign": -1,
        "lift_off_sign_of_C1": None, "impact_sign_of_C1": -1,
    }  # fmt: skip
    assert data["intervals"][1]["lift_off_sign_of_C1"] == -1
    assert data["intervals"][1]["impact_sign_of_C1"] == 1
    assert data["side_switches_at"] == [2]


# Ends of ranges, limits and words of the side table that no other test looks at.


def test_limits_of_beta_belong_to_the_domain() -> None:
    tiny = fmpq(1, 10**9)
    for end in (MAX_BETA, -MAX_BETA):
        assert gamma_sign(end) == (0 if end > 0 else 1)
        assert gamma_sign(arb(end)) == gamma_sign(end)
        beyond = end + tiny if end > 0 else end - tiny
        for value in (beyond, arb(end, tiny)):
            with pytest.raises(ValueError, match="must be at most"):
                gamma_sign(value)
            with pytest.raises(ValueError, match="at most"):
                gamma_sign_by_ball(value)
    assert gamma_sign(MAX_BETA - tiny) == 1
    assert gamma_sign(arb(MAX_BETA - 1, fmpq(1, 2))) is None


def test_number_of_integers_at_its_limit() -> None:
    assert len(side(0, 100_000).integers) == 100_001
    with pytest.raises(ValueError, match="more than 100000"):
        side(0, 100_001)
    assert len(side(800_000, 800_003).integers) == 4  # it is the number of them that counts


@pytest.mark.parametrize(
    ("lower", "upper", "expected"),
    [
        ("-2", "-1", [("-2", "-1", True, True, 1)]),
        ("-1", "0", [("-1", "0", True, False, 1)]),
        ("0", "1/2", [("0", "1/2", False, True, -1)]),
        ("0", "1", [("0", "1", False, False, -1)]),
        ("-1/2", "1/2", [("-1/2", "0", True, False, 1), ("0", "1/2", False, True, -1)]),
        ("1", "2", [("1", "2", False, False, 1)]),
        ("3/2", "3/2", [("3/2", "3/2", True, True, 1)]),
        ("3", "3", []),
        ("-3", "-3", [("-3", "-3", True, True, 1)]),
    ],
)
def test_ends_and_signs(lower: str, upper: str, expected: list[tuple[str, str, bool, bool, int]]) -> None:
    found = side(lower, upper)
    assert list(found.intervals) == [SignInterval(Fraction(a), Fraction(b), c, d, s) for a, b, c, d, s in expected]
    whole = range(int(Fraction(upper)) + 1)
    assert found.integers == tuple(n for n in whole if Fraction(lower) <= n <= Fraction(upper))
    assert found.undecided == ()


def test_words() -> None:
    no_case = "no side: the Cases I, II and III have β > 0"
    assert str(side("-2", "-1")) == f"[-2, -1]: Γ(-β) > 0; {no_case}"
    assert str(side("-1", "0")) == f"[-1, 0): Γ(-β) > 0; {no_case}\nΓ(-β) has a pole at β = 0"
    assert str(side("0", "1/2")) == (
        "(0, 1/2]: Γ(-β) < 0; Cases I and II, by the paper's rule as ε → 0: C1 < 0 takes an IWC, no other sign occurs\n"
        "Γ(-β) has a pole at β = 0"
    )
    assert str(side("3/2", 3)) == (
        "[3/2, 2): Γ(-β) > 0; Case III, by the paper's rule as ε → 0: C1 < 0 lifts off, C1 > 0 takes an IWC\n"
        "(2, 3): Γ(-β) < 0; Case III, by the paper's rule as ε → 0: C1 > 0 lifts off, C1 < 0 takes an IWC\n"
        "Γ(-β) has a pole at β = 2, 3\nin Case III the side switches at β = 2, 3"
    )
    found = side(arb(1, fmpq(1, 8)), "5/4")
    assert str(found).splitlines()[-1] == "undecided (an endpoint's ball holds it): β = 1"
    assert "switches" not in str(found)


def test_a_side_is_stated_only_where_the_theory_gives_one() -> None:
    signs = [i["lift_off_sign_of_C1"] for i in side("-1/2", "3/2").to_json()["intervals"]]
    assert signs == [None, None, -1]
    impacts = [i["impact_sign_of_C1"] for i in side("-1/2", "3/2").to_json()["intervals"]]
    assert impacts == [None, -1, 1]
    assert side("-1/2", "3/2").to_json()["side_switches_at"] == []
    assert side("-2", "-1").to_json()["intervals"][0]["lift_off_sign_of_C1"] is None


def test_poles_at_the_ends_of_balls() -> None:
    found = side(arb(1, fmpq(1, 8)), arb(fmpq(7, 2), fmpq(3, 4)))
    assert found.undecided == (1, 3, 4)
    assert found.integers == (2,)
    assert 0 <= Fraction(7, 8) - found.intervals[0].lower < Fraction(1, 10**6)
    assert 0 <= found.intervals[-1].upper - Fraction(17, 4) < Fraction(1, 10**6)
    assert side(arb(fmpq(1, 2), fmpq(3, 4)), 2).undecided == (0, 1)
    assert side(arb(fmpq(1, 2), fmpq(3, 4)), 2).integers == (2,)


def test_balls_that_touch_a_pole() -> None:
    assert gamma_sign(arb(fmpq(1, 2), fmpq(1, 2))) is None
    assert gamma_sign(arb(fmpq(3, 2), fmpq(1, 4))) == 1
    assert gamma_sign(arb(fmpq(-1, 2), fmpq(1, 2))) is None
    assert gamma_sign(arb(fmpq(-1, 2), fmpq(1, 4))) == 1
    assert gamma_sign(arb(fmpq(5, 2), fmpq(1, 2))) is None


def test_a_ball_end_with_a_tiny_exponent() -> None:
    assert gamma_sign(arb((1, -99_000), (1, -99_010))) == -1
    assert gamma_sign(arb((1, -99_990), (1, -100_000))) == -1
    for beyond in (-100_001, -200_000):
        with pytest.raises(ValueError, match="exponent below"):
            gamma_sign(arb((1, beyond + 10), (1, beyond)))


def test_a_ball_that_ends_exactly_at_a_pole() -> None:
    for ball in (arb((1, -1), (1, -1)), arb((3, -2), (1, -2)), arb((-1, -1), (1, -1))):
        assert gamma_sign(ball) is None
    found = side(arb((1, -1), (1, -1)), arb((5, -1), (1, -1)))
    assert (found.undecided, found.integers) == ((0, 3), (1, 2))


def test_ends_of_more_digits_than_cpython_prints() -> None:
    """CPython refuses to turn integers of more than 4,300 digits into text."""
    end = "1/3" + "0" * 5000
    found = side(end, 1)
    assert str(found).startswith(f"[{end}, 1): Γ(-β) < 0")
    assert found.to_json()["intervals"][0]["lower"] == end


@pytest.mark.parametrize("beta", ["1/2", 3, "-5/2"])
def test_one_beta(beta: int | str) -> None:
    assert str(side(beta)) == str(side(beta, beta))
