"""From pieces to statements: the walk, integer β, certificates of the library.

Page: proofs/check.md.
"""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import pairwise

import pytest
from must_reject import mutate
from must_reject.mutate import GOOD, lines_of, text_of
from samples.checker_models import (
    LIMITS,
    STATEMENTS,
)
from witnesses.theta import theta_witness

from gspot_verified.certificates.text import certificate_text
from gspot_verified.signs.cover.sign import sign as sign_on_ranges
from gspot_verified.signs.zeros.brackets import zeros_at
from gspot_verified.signs.zeros.zeros import zeros_on_range

check = mutate.checker()


@pytest.mark.parametrize(
    ("pieces", "found"),
    [
        ([("left", 1), ("sign", 1), ("sign", 1)], 0),
        ([("left", 1), ("monotone", -1), ("monotone", -1), ("sign", -1), ("sign", -1)], 1),
        ([("left", 1), ("monotone", 1), ("sign", 1)], 0),
        ([("left", 1), ("sign", -1)], "give F different signs where they meet"),
        ([("left", 1), ("monotone", 1), ("sign", -1)], "against the direction"),
        ([("left", 1), ("monotone", 1), ("monotone", -1), ("sign", 1)], "have two directions"),
        ([("monotone", 1), ("sign", 1)], "a piece monotone comes first"),
        ([("left", 1), ("monotone", 1)], "a piece monotone comes last"),
        ([("left", 1), ("hinge", 1)], "a piece hinge does not count zeros"),
    ],
)
def test_walk_through_the_pieces(
    pieces: list[tuple[str, int]], found: int | str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The rules that join the pieces, with pieces that are believed."""
    walk = [check.pieces.Piece(0, 1, kind, [], value) for kind, value in pieces]
    checker = check.pieces.ColumnCheck(check.pieces.Column(Fraction(1), Fraction(2), 0, walk), LIMITS, 0)
    monkeypatch.setattr(checker, "begin", lambda *_: None)
    monkeypatch.setattr(checker, "piece_sign", lambda piece: 0 if piece.kind == "monotone" else piece.value)
    if isinstance(found, int):
        assert check.statements.number_of_zeros(checker) == found
    else:
        with pytest.raises(check.limits.Rejected, match=found):
            check.statements.number_of_zeros(checker)


@pytest.mark.parametrize("name", GOOD)
def test_statements(name: str) -> None:
    assert check.main.check_text(text_of(GOOD[name])) == STATEMENTS[name]


def assert_sign_at_integer(tau: Fraction, beta: int, sign: int) -> None:
    """This sign is verified, and the two others are rejected."""
    for claimed in (-1, 0, 1):
        statement = {"beta": f"[{beta}, {beta}]", "kind": "sign", "sign": claimed, "tau": f"[{tau}, {tau}]"}
        if claimed == sign:
            assert check.main.check_text(text_of(lines_of(statement)))
        else:
            with pytest.raises(check.limits.Rejected, match="the sign at this integer β is"):
                check.main.check_text(text_of(lines_of(statement)))


@pytest.mark.parametrize("beta", range(14))
@pytest.mark.parametrize("tau", [Fraction(0), Fraction(-7, 3), Fraction(5, 2)])
def test_integer_beta(beta: int, tau: Fraction) -> None:
    exact = -beta * theta_witness(tau, Fraction(beta - 1))
    sign = 0 if tau == 0 and beta % 3 != 1 else (exact > 0) - (exact < 0)
    assert_sign_at_integer(tau, beta, sign)


def polynomial_at(tau: Fraction, n: int) -> Fraction:
    """Θ(τ, n) = n! [x^n] exp(x³/3 - τx): a sum, where the checker has a recurrence."""
    terms = [
        Fraction(math.factorial(n), math.factorial(n - 3 * j) * math.factorial(j) * 3**j) * (-tau) ** (n - 3 * j)
        for j in range(n // 3 + 1)
    ]
    return sum(terms, Fraction(0))


@pytest.mark.parametrize("beta", range(4, 15))
def test_integer_beta_on_both_sides_of_each_zero(beta: int) -> None:
    """Points that differ by 2^-40: a wrong factor in the recurrence moves a zero across one of them."""
    grid = [Fraction(k, 8) + Fraction(1, 97) for k in range(-10, 90)]
    zeros = 0
    for low, high in pairwise(grid):
        at_low = polynomial_at(low, beta - 1)
        if at_low * polynomial_at(high, beta - 1) > 0:
            continue
        left, right = low, high
        while right - left > Fraction(1, 2**40):
            middle = (left + right) / 2
            left, right = (middle, right) if polynomial_at(middle, beta - 1) * at_low > 0 else (left, middle)
        zeros += 1
        for tau in (left, right):
            assert_sign_at_integer(tau, beta, -1 if polynomial_at(tau, beta - 1) > 0 else 1)
    # Of the zeros at 0 one is on this grid, with a change of sign where their number is odd.
    assert zeros == (beta - 1) // 3 + ((beta - 1) % 3 == 1)


@pytest.mark.parametrize("width", [Fraction(1, 10**40), Fraction(1, 10**5)])
@pytest.mark.parametrize("side", [-1, 1])
def test_narrow_columns_next_to_a_fold(width: Fraction, side: int) -> None:
    low, high = sorted([Fraction(3), 3 + side * width])
    last = ["right", "1/2", 0] if side < 0 else ["right", "1/2", 1]
    between = ["monotone", "1/4", "1/2", 1] if side < 0 else ["sign", "1/4", "1/2", 1]
    pieces = [["left", "-3/8"], ["sign", "-3/8", "-1/4", 1], ["fold", "-1/4", "1/4"], between, last]
    counts = [[2, 2]] if side < 0 else [[3, 1]]
    statement = {"beta": f"({low}, {high})", "counts": counts, "kind": "zeros"}
    assert check.main.check_text(text_of(lines_of(statement, ([str(low), str(high)], pieces))))


def test_a_zero_very_close_to_tau_0() -> None:
    """At β = 2 + 10^-40 there is a zero next to τ = 0: F has signs on both sides of it."""
    beta = 2 + Fraction(1, 10**40)
    for tau, sign in [(Fraction(-1, 10**30), -1), (Fraction(1, 10**30), 1), (Fraction(0), 1)]:
        statement = {"beta": f"[{beta}, {beta}]", "kind": "sign", "sign": sign, "tau": f"[{tau}, {tau}]"}
        piece = ["sign", str(tau - Fraction(1, 10**45)), str(tau + Fraction(1, 10**45)), -sign]
        assert check.main.check_text(text_of(lines_of(statement, ([str(beta)] * 2, [piece]))))


@pytest.mark.parametrize(("tau", "beta"), [("-inf..inf", "0..1"), ("-2..-1", "0..3"), ("-inf..0", "1..2")])
def test_certificates_of_the_library_for_signs(tau: str, beta: str) -> None:
    result = sign_on_ranges(tau, beta)
    assert result.proved_statement is not None
    text = certificate_text(result.proved_statement, result.columns)
    assert check.main.check_text(text.encode()).startswith("dΘ/dτ < 0 for every τ")


@pytest.mark.parametrize(
    ("beta", "digits"), [("7/3", 15), ("5/2", 100), ("3/2", 15), ("29999999/10000000", 20), ("4001/1000", 30)]
)
def test_certificates_of_the_library_for_brackets(beta: str, digits: int) -> None:
    result = zeros_at(beta, digits)
    text = certificate_text(result.statement, [result.column])
    m = math.floor(Fraction(beta))
    number = m % 3 + m // 3
    words = "one real zero, simple, in (" if number == 1 else f"{number} real zeros, all simple, one in each "
    assert f"has exactly {words}" in check.main.check_text(text.encode())


def test_certificate_of_the_library_for_zeros() -> None:
    result = zeros_on_range("2..7/2")
    assert result.statement is not None
    text = certificate_text(result.statement, result.columns)
    assert check.main.check_text(text.encode()).endswith("N = 2 on (2, 3), N = 1 on (3, 4)")


def test_a_large_beta() -> None:
    result = zeros_at("61/2", 15)
    text = certificate_text(result.statement, [result.column])
    assert "has exactly 10 real zeros" in check.main.check_text(text.encode())


def test_a_number_of_zeros_at_one_beta() -> None:
    header, *_, column = mutate.copy.deepcopy(GOOD["zeros"])
    header["statement"]["beta"] = "[9/8, 9/8]"
    lines = [header, column | {"beta": ["9/8", "9/8"]}]
    text = check.main.check_text(text_of(lines))
    assert text == "at β = 9/8, dΘ/dτ has exactly N real zeros, all simple: N = 1 on (1, 2)"


def test_at_an_integer_beta_a_range_needs_columns() -> None:
    """At its left end dΘ/dτ < 0, at its right end not: the value at one end proves nothing."""
    statement = {"beta": "[4, 4]", "kind": "sign", "sign": -1, "tau": "[0, 9]"}
    with pytest.raises(check.limits.Rejected, match="columns do not cover"):
        check.main.check_text(text_of(lines_of(statement)))
    statement["tau"] = "[0, 0]"
    assert check.main.check_text(text_of(lines_of(statement)))
