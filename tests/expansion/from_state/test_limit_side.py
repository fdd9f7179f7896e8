"""The side by the sign of C_1 for small epsilon: Theorem R beside Theorem Q, and beside the sign of Gamma(-beta).

Pages: proofs/papers_rule.md, proofs/from_state.md.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import to_fmpq
from witnesses.slow_deviation import end_of_contact
from witnesses.theorem_q import side_by_enclosures

from gspot_verified.expansion.from_state.limit_side import limit_side, rule_of
from gspot_verified.expansion.series.regularisation import PAPER
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.inner_text import inner_text
from gspot_verified.numbers.verdict import Outcome, Reason
from gspot_verified.signs.gamma.side import gamma_sign


@pytest.mark.parametrize(
    "beta",
    [
        "3/2",
        *(
            pytest.param(beta, marks=pytest.mark.slow)
            for beta in ("11/10", "7/4", "7/3", "5/2", "29/10", "31/10", "7/2")
        ),
    ],
)
def test_it_is_the_papers_rule(beta: str) -> None:
    """C_1/Gamma(-beta) > 0: impact."""
    found = limit_side(beta)
    assert found.verdict.outcome is Outcome.PROVED
    assert found.side == side_by_enclosures(beta) == {1: "impact", -1: "lift-off"}[gamma_sign(found.beta)]
    first = "lambda_N exceeds Lambda" if found.side == "impact" else "it is lost"
    words = found.verdict.statement
    assert first in words.split(" if C_1 > 0")[0]
    assert words.index("every force Lambda,") < words.index("there is an epsilon_0"), "one epsilon_0 for each force"


@pytest.mark.slow
def test_for_another_contact() -> None:
    for beta, contact, side in (("3/2", (2, 1, "1/2"), "impact"), ("7/3", (1, 3, 1), "lift-off")):
        assert limit_side(beta, contact=contact).side == side_by_enclosures(beta, contact) == side


@given(integer=st.integers(1, 60), part=st.fractions(min_value=0, max_value=1, max_denominator=10**6))
def test_every_beta_between_two_integers(integer: int, part: Fraction) -> None:
    """Also in a ball: all that matters is which integers are next to it."""
    if part in (0, 1):
        with pytest.raises(ValueError, match="no integer"):
            limit_side(integer + part if integer + part > 1 else 2)
        return
    beta = to_fmpq(integer + part)
    found = limit_side(beta)
    assert found.side == {1: "impact", -1: "lift-off"}[gamma_sign(beta)]
    assert found.verdict.outcome is Outcome.PROVED
    with working_bits(64):
        root = arb(beta) + arb(0, "1e-9")
    assert limit_side(root).side == found.side
    assert f"beta in {inner_text(root)} and " in limit_side(root).verdict.statement
    assert f"beta = {beta} and " in found.verdict.statement
    assert "(1, 1, 1)" in found.verdict.statement


def test_the_ball_that_is_named_holds_no_other_number() -> None:
    """By its usual text [2.0 +/- 0.0400] the statement would be false: at 199/100 the sides change."""
    with working_bits(64):
        found = limit_side(arb("2.02", "0.01999999"))
    assert found.verdict.outcome is Outcome.PROVED
    assert " beta in [2.00001, 2.03999] and " in found.verdict.statement
    assert limit_side("199/100").side != found.side


def test_a_ball_with_an_integer_is_undecided() -> None:
    for wide in (arb(2, "1e-9"), arb("2.5", "0.5")):
        found = limit_side(wide)
        assert found.side is None
        assert found.verdict.outcome is Outcome.UNDECIDED
        assert found.verdict.reason is Reason.WIDE_INPUT


@pytest.mark.parametrize(
    ("beta", "p", "epsilon"),
    [
        (fmpq(3, 2), 0.3, 1e-4),
        *(pytest.param(beta, 0.1, 2e-5, marks=pytest.mark.slow) for beta in (fmpq(7, 3), fmpq(5, 2))),
    ],
)
def test_a_mechanism_whose_coefficients_vary_takes_that_side(beta: fmpq, p: float, epsilon: float) -> None:
    """Float runs of a nonlinear mechanism with m = 4: a force below the mean one is C_1 > 0."""
    ratio = int(beta.p) / int(beta.q)
    mean = 1 / (ratio - 1)
    below, above = (end_of_contact(ratio, epsilon, p, share * mean, 40 * mean) for share in (0.3, 2.0))
    assert {below, above} == {"impact", "lift-off"}
    assert below == limit_side(beta).side


def test_the_sentence_names_the_fast_part_of_the_starts() -> None:
    """Theorem Q needs |X| < p Lambda = -b in the limit: a start that oscillates more may lift off at once."""
    statement = limit_side("3/2", contact=(1, 3, 2)).verdict.statement
    assert "y/epsilon^2, v/epsilon, lambda_N bounded" in statement
    fast = "the limsup of (kappa p (v/epsilon)^2 + (b + p lambda_N)^2 + (g^2/l) p fast^2)/b^2 below 1, "
    assert fast in statement
    assert "fast = lambda_N + kappa y/epsilon^2 + (l/g) v/epsilon, kappa = 3/4, g = 2, l = 9/4" in statement


def test_the_second_way_is_open_where_theorem_b_does_not_hold() -> None:
    """With starts at a delta that is too large."""
    assert "Theorem B" in side_by_enclosures("3/2", deltas=(fmpq(1, 30),))


@pytest.mark.parametrize(("beta", "message"), [("1/2", "above 1"), ("2", "no integer"), ("1", "above 1")])
def test_bad_input(beta: str, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        limit_side(beta)
    with pytest.raises(ValueError, match="damper"):
        limit_side("3/2", contact=(1, 1, 0))
    for low in (arb(1), arb(1, "0.1")):
        with pytest.raises(ValueError, match="above 1"):
            limit_side(low)
    for large in ("1000000000001/2", arb((1, 2**70)), arb("inf")):
        with pytest.raises(ValueError, match=r"at most 1000000|beta"):
            limit_side(large)
    for none in (arb((1, 2**70)), arb(2), arb("0.5")):
        assert rule_of(none, PAPER) is None
    assert rule_of(arb("nan"), PAPER) is None
