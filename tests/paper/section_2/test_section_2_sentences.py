"""Sentences of Sec. 2: which variables enter, and the signs near p = 0, also at numbers."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.paper.checks.identities import Route
from gspot_verified.paper.section_2 import section_2_sentences as ledger

_POSITIVE = st.fractions(min_value="1/50", max_value=50)


@given(_POSITIVE, _POSITIVE, _POSITIVE)
def test_signs_where_p_is_0(a: float, b: float, excess: float) -> None:
    """For A, B > 0 and C with A C - B² = excess > 0, μ = C/B."""
    c = (b**2 + excess) / a
    mu = c / b
    assert c + mu * b > 0
    assert b - mu * a < 0 < b + mu * a


@pytest.mark.parametrize(
    ("answers", "one", "contrary"),
    [((True, False), True, False), ((False, False), False, True), ((True, None), None, None), ((), None, None)],
)
def test_three_values(answers: tuple[bool | None, ...], one: bool | None, contrary: bool | None) -> None:
    assert ledger.one_of(answers) is one
    assert ledger.denied(ledger.one_of(answers)) is contrary


@pytest.mark.parametrize(("name", "rates", "answer"), [("b", "p", True), ("u", "x", True), ("u", "pbyvz", False)])
def test_what_enters(name: str, rates: str, answer: bool) -> None:
    assert ledger.enters(name, rates) is answer


def test_p_and_b_are_coupled_both_ways_by_chi() -> None:
    """As the note of 2-coupling says: without χ nothing acts on p, and p acts on v for every χ."""
    assert ledger.rate_of_p_is_constant() is True
    assert ledger.enters("b", "p") is True
    assert ledger.enters("p", "v") is True
    assert "b for χ other than 0, and p stands in the rate of v" in ledger.ENTRIES["2-coupling"]().note


def test_without_chi_nothing_is_brought(monkeypatch: pytest.MonkeyPatch) -> None:
    assert ledger.chi_brings("b") is True
    monkeypatch.setitem(ledger.EXTENDED, "p", "alpha1")
    assert ledger.chi_brings("u") is None
    assert ledger.chi_couples_b_to_p() is False


@given(_POSITIVE, _POSITIVE, st.fractions(min_value=-1, max_value=1))
def test_a_force_of_the_cone_is_a_sum_of_two(friction: float, normal: float, part: float) -> None:
    """By numbers: λ⁺ and λ⁻ from λ_T, and back."""
    tangential = part * friction * normal
    forward = (friction * normal - tangential) / (2 * friction)
    backward = normal - forward
    assert 0 <= forward <= normal
    assert friction * (backward - forward) == tangential
    assert (forward == normal) is (part == -1)
    assert (forward == 0) is (part == 1)


@pytest.mark.parametrize("route", [ledger.by_replacing, ledger.by_the_two_slips])
@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("p", "2*alpha1 + chi*b"), ("p", "alpha1 + chi*y"), ("p", "alpha1"), ("b", "alpha2 + c*alpha3*lam"),
        ("b", "alpha2 - alpha3*lam"), ("b", "alpha2 - c^2*alpha3*lam"), ("y", "v + p"), ("v", "b + p*lam"),
        ("v", "b + p*c*lam + q*c*lam"), ("v", "p*c*lam + q*(1 - c)*lam"), ("z", "-z"),
    ],
)  # fmt: skip
def test_other_equations_of_the_extended_example(route: Route, name: str, text: str) -> None:
    parts = {key: ledger.ALGEBRA.read(value) for key, value in ledger.EXTENDED.items()}
    assert all(value.is_zero() for value in route(parts))
    assert not all(value.is_zero() for value in route({**parts, name: ledger.ALGEBRA.read(text)}))


@pytest.mark.parametrize(("name", "term"), [("b", "alpha2*lam"), ("b", "p*lam"), ("v", "2*p*lam")])
def test_a_term_that_is_not_there_is_not_replaced(monkeypatch: pytest.MonkeyPatch, name: str, term: str) -> None:
    monkeypatch.setitem(ledger.REPLACED, name, (term, ledger.REPLACED[name][1]))
    parts = {key: ledger.ALGEBRA.read(value) for key, value in ledger.EXTENDED.items()}
    assert not all(value.is_zero() for value in ledger.by_replacing(parts))


def test_without_a_normal_force_the_share_is_free() -> None:
    """λ_T does not depend on c for λ_N = 0: the statement leaves it out."""
    at_0 = {"lam": ledger.ALGEBRA.constant(0)}
    shares = [ledger.ALGEBRA.substitute(ledger.ALGEBRA.read(text), at_0) for text in ledger.SHARES.values()]
    assert all(share.is_zero() for share in shares)
    assert "λ_N > 0" in ledger.ENTRIES["2-two-forces"]().statement


def test_two_forces() -> None:
    assert ledger.shares_make_the_force() is ledger.cone_is_spanned() is True


@pytest.mark.parametrize(
    ("target", "name", "text"),
    [
        ("SHARES", "lm", "c*lam"),
        ("SHARES", "lp", "(1 - c)*lam"),
        ("EDGES", "lm", "-mu"),
        ("EDGES", "lp", "mu"),
        ("EDGES", "lp", "-2*mu"),
    ],
)
def test_other_shares_and_edges_do_not_make_the_force(
    monkeypatch: pytest.MonkeyPatch, target: str, name: str, text: str
) -> None:
    monkeypatch.setitem(getattr(ledger, target), name, text)
    assert False in (ledger.shares_make_the_force(), ledger.cone_is_spanned())
