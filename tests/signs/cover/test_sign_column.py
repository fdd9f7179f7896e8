from __future__ import annotations

from fractions import Fraction

import pytest
from flint import fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.piece_samples import assert_column, sign_of_f
from samples.strategies import to_fmpq

from gspot_verified.signs.cover.pieces import Column, Kind
from gspot_verified.signs.cover.sign_column import SignQuestion, _SignSearch, sign_column
from gspot_verified.work.ranges import Range


def ask(tau: str, beta: str, sign: int, by_theorem: bool = False) -> SignQuestion:
    return SignQuestion(Range.parse(tau, "tau"), Range.parse(beta, "beta"), sign, by_theorem)


def column_of(tau: str, beta: str, sign: int) -> Column:
    """The column over the whole of beta, checked at random points."""
    question = ask(tau, beta, sign)
    assert question.beta.upper is not None
    found = sign_column(question, question.beta.lower, question.beta.upper)
    assert isinstance(found, Column), found
    assert_column(found, question.tau.lower, question.tau.upper)
    assert Kind.MONOTONE not in {piece.kind for piece in found.pieces}
    return found


@pytest.mark.parametrize(
    ("tau", "beta", "sign", "kinds"),
    [
        ("-inf..inf", "0..1", 1, {Kind.LEFT, Kind.SIGN, Kind.TAYLOR}),
        ("-inf..inf", "-3..-2", 1, {Kind.LAPLACE}),
        ("-inf..inf", "-inf..0", 1, {Kind.LAPLACE}),
        ("-inf..0", "31/16..2", 1, {Kind.LEFT, Kind.HINGE}),
        ("-inf..0", "3..49/16", 1, {Kind.LEFT, Kind.SIGN, Kind.FOLD}),
        ("-1..1", "3..49/16", 1, None),
        ("-1/100..1/100", "3..49/16", 1, {Kind.FOLD}),
        ("[0..1/2]", "3..49/16", 1, None),
        ("0..1", "[2..33/16]", -1, {Kind.SIGN, Kind.HINGE}),
        ("[-1..0]", "[15/8..2)", 1, None),
        ("0", "15/8..2", 1, {Kind.HINGE}),
        ("0", "3..49/16", 1, {Kind.FOLD}),
        ("0", "[5/2..11/4]", -1, {Kind.SIGN}),
        ("1", "[5/2..41/16]", -1, {Kind.SIGN}),
        ("8..inf", "[5/2..11/4]", 1, {Kind.RIGHT}),
        ("-inf..-20", "[5/2..11/4]", 1, {Kind.LEFT}),
        ("5/2..inf", "[5/2..11/4]", 1, None),
        ("-inf..inf", "4", 1, None),
        ("10..20", "9/2", 1, None),
    ],
)
def test_columns(tau: str, beta: str, sign: int, kinds: set[Kind] | None) -> None:
    if beta == "4":  # the polynomial Theta(., 3) = 2 - tau^3 has both signs
        assert not isinstance(sign_column(ask(tau, beta, sign), fmpq(4), fmpq(4)), Column)
        return
    if beta == "9/2":
        sign = sign_of_f(fmpq(15), fmpq(7, 2)) or 0
    found = column_of(tau, beta, sign)
    if kinds is not None:
        assert {piece.kind for piece in found.pieces} == kinds


@pytest.mark.parametrize(
    ("tau", "beta", "sign"),
    [
        ("[-1..0]", "[15/8..2]", 1),  # F(0, 1) = 0
        ("[0..1]", "[2..33/16]", -1),  # F(0, 1) = 0
        ("(-1..0]", "[3..49/16]", 1),  # the double zero
        ("[0..1)", "[3..49/16]", 1),
        ("-1..1", "[3..49/16]", 1),
        ("0", "[3..49/16]", 1),
        ("-1..1", "47/16..3", 1),  # two zeros for b < 2
        ("-1..1", "[2..33/16]", -1),
        ("0..1", "[2..33/16]", 1),
    ],
)
def test_no_column_where_the_statement_fails(tau: str, beta: str, sign: int) -> None:
    question = ask(tau, beta, sign)
    assert question.beta.upper is not None
    assert not isinstance(sign_column(question, question.beta.lower, question.beta.upper), Column)


def test_by_theorem_is_one_piece() -> None:
    question = ask("-inf..inf", "0..1", 1, by_theorem=True)
    found = sign_column(question, fmpq(0), fmpq(1))
    assert isinstance(found, Column)
    assert [piece.kind for piece in found.pieces] == [Kind.LAPLACE]


@pytest.mark.parametrize(
    ("tau", "lower", "upper"), [("3..4", None, 0), ("-inf..3", -2, -1), ("-inf..inf", None, -5), ("7..inf", 0, 1)]
)
def test_witnesses_lie_inside_and_have_the_other_sign(tau: str, lower: int | None, upper: int) -> None:
    question = ask(tau, f"{'-inf' if lower is None else lower}..{upper}", -1, by_theorem=True)
    found = sign_column(question, None if lower is None else fmpq(lower), fmpq(upper))
    assert isinstance(found, tuple)
    assert question.tau.contains(found[0])
    assert question.beta.contains(found[1])
    assert sign_of_f(found[0], found[1] - 1) == 1


@settings(max_examples=25)
@given(
    st.fractions(-4, 8, max_denominator=16),
    st.fractions(0, 2, max_denominator=16),
    st.integers(0, 5),
    st.fractions(0, 1, max_denominator=16),
    st.fractions(0, Fraction(1, 4), max_denominator=16),
    st.sampled_from((-1, 1)),
)
def test_random_questions(t: Fraction, height: Fraction, m: int, share: Fraction, width: Fraction, sign: int) -> None:
    lower = m + share
    upper = min(lower + width, Fraction(m + 1))
    tau = Range(to_fmpq(t), to_fmpq(t + height), True, True)
    beta = Range(to_fmpq(lower), to_fmpq(upper), True, True)
    found = sign_column(SignQuestion(tau, beta, sign), to_fmpq(lower), to_fmpq(upper))
    if isinstance(found, Column):
        assert_column(found, tau.lower, tau.upper)
        for i in range(5):
            for j in range(5):
                b = to_fmpq(lower + (upper - lower) * Fraction(i, 4)) - 1
                assert sign_of_f(to_fmpq(t + height * Fraction(j, 4)), b) == sign
    elif found is not None:
        assert tau.contains(found[0])
        assert beta.contains(found[1])
        assert sign_of_f(found[0], found[1] - 1) == -sign


@pytest.mark.parametrize(
    ("tau", "beta", "sign"),
    [
        # F falls on [-1/2, 0], is positive in the middle, and F(0, b) < 0 for b in (1, 2): its zero is next to 0.
        ("-1/2..0", "2.01..2.02", 1),
        # F falls on [0, 1/2] from F(0, b) > 0 through a zero next to 0, b below 1.
        ("0..1/2", "1.98..1.99", -1),
    ],
)
def test_a_hinge_needs_the_sign_at_zero(tau: str, beta: str, sign: int) -> None:
    """The slope has the direction that a hinge wants, and the centre the wanted sign; only F(0, b) is against it."""
    question = SignQuestion(Range.parse(tau, "tau"), Range.parse(beta, "beta"), sign)
    lower, upper = question.beta.lower, question.beta.upper
    assert lower is not None
    assert upper is not None
    found = sign_column(question, lower, upper)
    # A point against it, or nothing: never a column.
    assert found is None or (isinstance(found, tuple) and sign_of_f(found[0], found[1] - 1) == -sign)


@pytest.mark.parametrize(
    ("tau", "beta", "sign", "place", "direction"),
    [("-inf..0", "31/16..2", 1, (fmpq(-1, 2), fmpq(0)), -1), ("0..1", "[2..33/16]", -1, (fmpq(0), fmpq(1, 2)), -1)],
)
def test_a_hinge_needs_the_direction(
    monkeypatch: pytest.MonkeyPatch, tau: str, beta: str, sign: int, place: tuple[fmpq, fmpq], direction: int
) -> None:
    """F falls to F(0, b) = 0 from the left, or from it to the right; else it does not have the sign."""
    question = ask(tau, beta, sign)
    assert question.beta.lower is not None
    assert question.beta.upper is not None
    search = _SignSearch(question, question.beta.lower, question.beta.upper, None)
    for answer in (1, -1, 0, None):
        monkeypatch.setattr(search.models, "sign", lambda *_, answer=answer: answer)
        assert search._hinge(*place) is (answer == direction)
    assert not search._hinge(fmpq(-1, 2), fmpq(1, 2))


def test_what_lies_between_0_and_the_range_does_not_count() -> None:
    """Around beta = 4.8 F has a zero at 0.16 and the next one at 2.4."""
    column_of("1/4..3/2", "4.79..4.8", -1)
    assert isinstance(sign_column(ask("0..3/2", "4.79..4.8", -1), fmpq(479, 100), fmpq(48, 10)), tuple)
