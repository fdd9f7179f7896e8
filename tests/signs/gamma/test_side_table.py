"""Ends of ranges, limits and words of the side table that no other test looks at."""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq

from gspot_verified import gamma_sign, side
from gspot_verified.signs.gamma.side import MAX_BETA, SignInterval, gamma_sign_by_ball


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
        "(0, 1/2]: Γ(-β) < 0; Cases I and II: C1 < 0 takes an IWC, and as ε → 0 no other sign occurs\n"
        "Γ(-β) has a pole at β = 0"
    )
    assert str(side("3/2", 3)) == (
        "[3/2, 2): Γ(-β) > 0; Case III: C1 < 0 lifts off, C1 > 0 takes an IWC\n"
        "(2, 3): Γ(-β) < 0; Case III: C1 > 0 lifts off, C1 < 0 takes an IWC\n"
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
