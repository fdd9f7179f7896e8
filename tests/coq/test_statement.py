"""The formal statements, proofs/coq/Statement.v: they speak of the Θ and of the counts that the library computes.

Each formula is read out of the text and evaluated at rational points; each single change of the text must be noticed.
"""

from __future__ import annotations

import math
import re

import pytest
from coq.coq_terms import Applied, evaluate_term, mutations, statement
from flint import arb, fmpq

from gspot_verified import evaluate, polynomial
from gspot_verified.numbers.balls import working_bits
from gspot_verified.signs.gamma.count_law import multiplicity_at_zero, negative_zeros, number_of_zeros, positive_zeros

BITS = 160
NO_SHIFT = fmpq(0)
POINTS = [(fmpq(-3, 2), fmpq(-7, 5)), (fmpq(2, 3), fmpq(1, 2)), (fmpq(-1, 3), fmpq(13, 4)), (fmpq(5, 4), fmpq(22, 7))]
"""(τ, β): β < 0, in (0, 1), and beyond; no integer."""


def clauses(text: str) -> list[str]:
    """The members of a conjunction."""
    parts = [part.strip() for part in text.split("/\\")]
    return [part[1:-1] if part.startswith("(forall") else part for part in parts]


DEFINITION = clauses(statement("is_Theta").partition(":=")[2])
EQUATION = DEFINITION[1].removeprefix("forall t,")
INITIAL_VALUES = DEFINITION[2:]


def names(tau: fmpq, beta: fmpq, shift: fmpq = NO_SHIFT) -> dict[str, object]:
    """What the names of is_Theta stand for at a point; with a shift, Θ is taken at another β: the wrong function."""

    def derivative(order: int, place: object) -> arb:
        assert place in (tau, 0)
        return evaluate(tau if place is tau else 0, beta + shift, derivative=order, digits=40).value

    return {
        "b": beta,
        "t": tau,
        "theta": Applied(1, lambda place: derivative(0, place)),
        "Derive": Applied(2, lambda _, place: derivative(1, place)),
        "Derive_n": Applied(3, lambda _, order, place: derivative(order, place)),
        "Gamma": Applied(1, lambda x: arb(x).gamma()),
        "Rpower": Applied(2, lambda x, y: arb(x) ** arb(y)),
    }


def known(text: str, tau: fmpq, beta: fmpq, shift: fmpq = NO_SHIFT) -> bool | None:
    """Whether an equation between terms holds at the point: False when it certainly fails."""
    left, right = text.split("=")
    functions = names(tau, beta, shift)
    functions["theta"] = Theta(functions["theta"])
    with working_bits(BITS):
        difference = arb(evaluate_term(left, functions)) - arb(evaluate_term(right, functions))
        if not difference.is_finite():
            return None
        if not difference.contains(0):
            return False
        return True if difference.rad() < arb(2) ** -80 else None


class Theta(Applied):
    """theta: applied to a place, or itself the argument of Derive and Derive_n."""

    def __init__(self, applied: Applied) -> None:
        super().__init__(applied.arity, applied.function)


def holds(text: str, shift: fmpq = NO_SHIFT) -> bool:
    """At every point."""
    return all(known(text, tau, beta, shift) is True for tau, beta in POINTS)


def fails(text: str, shift: fmpq = NO_SHIFT) -> bool:
    """With certainty, at some point, or it is no equation that can be read at all."""
    try:
        return any(known(text, tau, beta, shift) is False for tau, beta in POINTS)
    except (AssertionError, ValueError, TypeError, ZeroDivisionError):
        return True


def test_the_definition_has_five_clauses() -> None:
    assert len(DEFINITION) == 5
    assert DEFINITION[0] == "forall k t, (k <= 3)%nat -> ex_derive_n theta k t"
    assert [clause.split("=")[0].strip() for clause in INITIAL_VALUES] == [
        "theta 0", "Derive theta 0", "Derive_n theta 2 0",
    ]  # fmt: skip


@pytest.mark.parametrize("clause", [EQUATION, *INITIAL_VALUES])
def test_theta_as_computed_is_theta_as_stated(clause: str) -> None:
    assert holds(clause)


@pytest.mark.parametrize("clause", [EQUATION, *INITIAL_VALUES])
def test_another_function_is_not(clause: str) -> None:
    assert fails(clause, shift=fmpq(1, 7))


@pytest.mark.parametrize(
    ("clause", "mutated"),
    [(clause, mutated) for clause in (EQUATION, *INITIAL_VALUES) for mutated in mutations(clause)],
)
def test_every_change_of_the_text_is_noticed(clause: str, mutated: str) -> None:
    assert mutated != clause
    assert fails(mutated)


ENTIRE = clauses(statement("is_Theta_entire").partition(":=")[2])
INTEGERS = (-1, 0, 1, 2, 3, 6, 7)


def entire_value(clause: str, beta: fmpq) -> bool | None:
    """Whether an initial value in the entire form is the one that the library computes; False: certainly not."""
    left, right = clause.split("=")
    order = {"theta 0": 0, "Derive theta 0": 1, "Derive_n theta 2 0": 2}[left.strip()]
    with working_bits(BITS):
        functions = {
            "b": beta,
            "PI": arb.pi(),
            "Rpower": Applied(2, lambda x, y: arb(x) ** arb(y)),
            "recip_Gamma": Applied(1, lambda x: arb(x).rgamma()),
        }
        value = evaluate(0, beta, derivative=order, digits=40).value
        difference = value - arb(evaluate_term(right, functions, fmpq))
        if not difference.is_finite():
            return None
        if not difference.contains(0):
            return False
        return True if difference.rad() < arb(2) ** -80 else None


def entire_fails(clause: str) -> bool:
    """With certainty at some β, or it cannot be read."""
    try:
        return any(entire_value(clause, beta) is False for _, beta in POINTS)
    except (AssertionError, ValueError, TypeError, ZeroDivisionError, KeyError):
        return True


def test_the_entire_form_has_the_same_equation() -> None:
    assert ENTIRE[:2] == DEFINITION[:2]
    assert len(ENTIRE) == 5


@pytest.mark.parametrize("clause", ENTIRE[2:])
def test_the_entire_form_of_the_initial_values(clause: str) -> None:
    assert all(entire_value(clause, beta) is True for _, beta in POINTS)
    assert all(entire_value(clause, fmpq(n)) is True for n in INTEGERS)
    right = clause.index("=") + 1
    assert all(entire_fails(clause[:right] + mutated) for mutated in mutations(clause[right:]))


def formula(name: str, pattern: str) -> str:
    """The one formula of the statement that follows the pattern, up to )%nat."""
    found = re.findall(pattern + r" = (?:\()(.*?)\)%nat", statement(name))
    assert len(found) == 1, found
    return str(found[0])


COUNTS = {
    "count_law": ("length l", lambda m: number_of_zeros(fmpq(2 * m + 1, 2)), {}),
    "count_law_with_signs": ("length positive", lambda m: positive_zeros(fmpq(2 * m + 1, 2)), {}),
    "count_law_integer": ("length l", lambda m: positive_zeros(m + 1), {"n": 1}),
}
"""The formula in m (or in n = m + 1) and the library's count."""


def agrees(text: str, name: str) -> bool:
    _, count, shifts = COUNTS[name]
    values = [({"m": m} | {key: m + shift for key, shift in shifts.items()}, count(m)) for m in range(60)]
    try:
        return all(evaluate_term(text, known_names) == number for known_names, number in values)
    except (AssertionError, ZeroDivisionError):
        return False


@pytest.mark.parametrize("name", COUNTS)
def test_the_counts_are_those_of_the_library(name: str) -> None:
    text = formula(name, COUNTS[name][0])
    assert agrees(text, name)
    assert not any(agrees(mutated, name) for mutated in mutations(text))


def test_the_negative_zero() -> None:
    text = statement("count_law_with_signs")
    found = re.search(r"length negative = \(if Nat.eqb \((.*?)\) (\d) then (\d) else (\d)\)%nat", text)
    assert found
    for m in range(60):
        value = found[3] if evaluate_term(found[1], {"m": m}) == int(found[2]) else found[4]
        assert int(value) == negative_zeros(fmpq(2 * m + 1, 2))


def test_the_multiplicity_at_integers() -> None:
    text = statement("count_law_integer")
    found = re.search(r"match \((.*?)\)%nat with \| 0%nat => (.*?) \| 1%nat => (.*?) \| _ => (.*?) end", text)
    assert found
    assert [case.count("= 0") for case in found.groups()[1:]] == [0, 1, 2]
    assert [case.count("<> 0") for case in found.groups()[1:]] == [1, 1, 1]
    for n in range(1, 40):
        assert min(evaluate_term(found[1], {"n": n}), 2) == multiplicity_at_zero(n)


def closed_sum(text: str, n: int, tau: fmpq) -> fmpq:
    """The value of P_n(τ) as the text of `Poly` states it: the terms, and the last j."""
    found = re.fullmatch(r".*:= sum_f_R0 \(fun j => (.*)\) \((n / \d+)\)", text)
    assert found
    functions = {"fact": Applied(1, math.factorial), "INR": Applied(1, fmpq), "n": n, "t": tau}
    last = evaluate_term(found[2], functions)
    assert isinstance(last, int)
    return sum((evaluate_term(found[1], functions | {"j": j}) for j in range(last + 1)), fmpq(0))


def test_the_polynomials() -> None:
    text = statement("Poly")
    expected = {(n, tau): polynomial(n)(tau) for n in range(12) for tau in (fmpq(-5, 3), fmpq(7, 4))}

    def same(candidate: str) -> bool:
        try:
            return all(closed_sum(candidate, *key) == value for key, value in expected.items())
        except (AssertionError, ZeroDivisionError, ValueError, TypeError):
            return False

    assert same(text)
    head, body = text.split("sum_f_R0")
    survivors = [mutated for mutated in mutations(body) if same(f"{head}sum_f_R0{mutated}")]
    # The one change that changes nothing: n + j and n - j have one parity.
    assert [mutated for mutated in survivors if mutated != body.replace("n + j", "n - j")] == []
