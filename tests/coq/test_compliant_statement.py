"""The formal statements on the series in η, proofs/coq/StatementCompliant.v: the library computes the same sums.

Each formula is read out of the text and evaluated; each single change of the text must be noticed.
Proof page: proofs/epsilon_series.md.
"""

from __future__ import annotations

import re
from functools import cache

import pytest
from coq.coq_terms import Applied, evaluate_term, mutations, statement
from flint import arb, fmpq

from gspot_verified.compliant.contact.lower_polynomial import lower_terms
from gspot_verified.compliant.slow.epsilon_series import epsilon_sum, series_coefficients
from gspot_verified.numbers.balls import working_bits

ORDERS = 7
RECURRENCE = re.compile(r"\(k m : nat\) : R := match k, m with \| O, O => (.*) \| S j, S i => (.*) \| _, _ => (.*) end")
UNREADABLE = (AssertionError, ValueError, TypeError, ZeroDivisionError, KeyError)


def coefficient(text: str) -> Applied:
    """c_(k,m) by the recurrence of this text."""
    found = RECURRENCE.fullmatch(text)
    assert found
    first, step, other = found.groups()

    @cache
    def value(k: int, m: int) -> fmpq:
        if k == m == 0:
            return fmpq(evaluate_term(first, {}))
        if k == 0 or m == 0:
            return fmpq(evaluate_term(other, {}))
        names = {
            "j": k - 1,
            "i": m - 1,
            "k": k,
            "m": m,
            "INR": Applied(1, fmpq),
            "series_coefficient": Applied(2, value),
        }
        return fmpq(evaluate_term(step, names, fmpq))

    return Applied(2, value)


def library(k: int, m: int) -> fmpq:
    """The library's c_(k,m)."""
    if k == 0 or m == 0 or m > k:
        return fmpq(1 if k == m == 0 else 0)
    return series_coefficients(k)[m - 1]


def same_coefficients(text: str) -> bool:
    try:
        value = coefficient(text).function
        return all(value(k, m) == library(k, m) for k in range(ORDERS) for m in range(ORDERS))
    except UNREADABLE:
        return False


def test_the_coefficients_are_those_of_the_library() -> None:
    text = statement("series_coefficient")
    assert same_coefficients(text)
    assert not any(same_coefficients(mutated) for mutated in mutations(text))


def let(name: str, what: str) -> str:
    """The formula that a statement introduces with ``let what := ... in``."""
    found = re.findall(rf"let {what} := (.*?) in ", statement(name))
    assert len(found) == 1, found
    return str(found[0])


DERIVATIVES = [arb(j**3 + 7 * j + 11) for j in range(6 * ORDERS)]
ETA = fmpq(3, 7)


def order(text: str, k: int) -> arb:
    """The term of order k as the text of ``order`` has it, on numbers in place of the derivatives of Θ."""
    found = re.fullmatch(r"eta \^ k \* sum_first \(fun m => (.*)\) \(S k\)", text)
    assert found
    names = {"k": k, "n": 0, "t": 0, "theta": 0, "series_coefficient": Applied(2, library)}
    names["Derive_n"] = Applied(3, lambda _theta, index, _t: DERIVATIVES[index])
    return arb(ETA**k) * sum((evaluate_term(found[1], names | {"m": m}) for m in range(k + 1)), arb(0))


def test_the_orders_of_theorem_b_are_those_of_the_library() -> None:
    text = let("series_in_eta", r"order k")

    def same(candidate: str) -> bool:
        with working_bits(128):
            sums = [epsilon_sum(DERIVATIVES, arb(ETA), terms) for terms in range(1, ORDERS + 1)]
            try:
                total = arb(0)
                for k, expected in enumerate(sums):
                    total += order(candidate, k)
                    if not (total.is_finite() and (total - expected).contains(0) and (total - expected).rad() < 1e-20):
                        return False
            except (*UNREADABLE, IndexError):
                return False
            return True

    assert same(text)
    head, body = text.split("sum_first", 1)
    assert not any(same(f"{head}sum_first{mutated}") for mutated in mutations(body))


@pytest.mark.parametrize("b", [fmpq(1, 2), fmpq(9, 2), fmpq(13, 2), fmpq(15, 2), fmpq(23, 2), fmpq(25, 2), fmpq(41, 3)])
def test_the_polynomial_of_the_library_is_one_of_theorem_c(b: fmpq) -> None:
    text = statement("monotone_beyond_polynomial")
    whole, each = re.findall(r"b < (.*?) ->", text)
    terms = lower_terms(b)
    last = {term.order - term.power: term.power for term in terms}
    count = len(last)
    last = {difference // 3: power for difference, power in last.items()}
    assert sorted(last) == list(range(1, count + 1))
    names = {"n": 0, "M": count, "INR": Applied(1, fmpq), "K": Applied(1, last.__getitem__)}
    assert b < evaluate_term(whole, names)
    for m, power in last.items():
        assert "Nat.Odd (K m - m)" in text
        assert (power - m) % 2 == 1
        assert b < evaluate_term(each.removesuffix(")"), names | {"m": m})
        held = [term for term in terms if term.order - term.power == 3 * m]
        assert [term.power for term in held] == list(range(m, power + 1))
        assert all(library(k, m) == 0 for k in range(m))
        assert all(term.coefficient == library(term.power, m) for term in held)
    assert let("monotone_beyond_polynomial", "part eta m").startswith(
        "sum_first (fun k => series_coefficient k m * eta ^ k * Derive_n theta (n + k + 3 * m) t) (S (K m))"
    )
    assert (
        "sum_first (fun k => series_coefficient k m * eta ^ k * Derive_n theta (k + 3 * m) tau) (S (K m))"
        in statement("corrected_theta")
    )
    # The force is the first derivative: what n = 0 asks of M and K at beta = b + 1 is what Theorem C asks at b.
    enough = re.findall(r"beta < (.*?)(?: /\\|$)", statement("enough_terms"))
    assert evaluate_term(enough[0], names) == evaluate_term(whole, names) + 1
    assert all(
        evaluate_term(enough[1], names | {"m": m}) == evaluate_term(each.removesuffix(")"), names | {"m": m}) + 1
        for m in last
    )
