"""The spaces of Theorem 1: the shifts against sets of powers, and what each step of the induction must refuse.

Page: proofs/expansion.md, sections 1 and 4.
"""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from paper.bite import answers_with

from gspot_verified.paper.section_5 import explicit_expansions as explicit
from gspot_verified.paper.section_5 import section_5_spaces as ledger
from gspot_verified.paper.section_5.explicit_expansions import LEMMA, SPACES

SHIFTS = st.tuples(st.integers(-5, 5), st.integers(-5, 5))
LATE = (30, 31)
"""Orders of both parities that are late enough for every shift above."""


def powers(index: int) -> set[int]:
    """The powers of s in P_index."""
    return set(range(index % 3, index + 1, 3))


def index_of(shift: tuple[int, int], order: int) -> int:
    return order // 2 + shift[order % 2]


def case(order: int, index: int) -> tuple[int, int]:
    return order % 2, index - order // 2


@given(SHIFTS, SHIFTS)
def test_a_product_of_two_terms(left: tuple[int, int], right: tuple[int, int]) -> None:
    found = {case(i + j, index_of(left, i) + index_of(right, j)) for i in LATE for j in LATE}
    assert set(ledger.times(left, right)) == found


@given(SHIFTS, st.integers(-3, 3), st.integers(-4, 4))
def test_more_powers_of_s_from_other_orders(shift: tuple[int, int], by: int, later: int) -> None:
    found = {case(order, index_of(shift, order - later) + by) for order in LATE}
    assert set(ledger.moved(shift, by, later)) == found


@given(st.lists(st.tuples(st.integers(0, 1), st.integers(-9, 9)), max_size=3), SHIFTS)
def test_a_case_lies_in_a_space_when_its_powers_do(cases: list[tuple[int, int]], target: tuple[int, int]) -> None:
    order = LATE[0]
    inside = all(powers(order // 2 + index) <= powers(order // 2 + target[parity]) for parity, index in cases)
    assert ledger.lies_in(cases, target) is inside


WRONG_SPACES: list[tuple[str, dict[str, tuple[int, int]]]] = [
    ("p_n", {"p": (0, -4)}),
    ("r_b and r_xi", {"lambda_n": (0, -3)}),
    ("r_v", {"p": (2, -3)}),
    ("r_n", {"z": (3, 3)}),  # three derivatives of z
    ("r_n", {"b": (-2, -3)}),  # s times a function
    ("lambda_n", {"b": (-1, -9)}),
    ("lambda_n", {"f": (4, -4)}),
    ("y_n, z_n", {"z": (3, 5)}),  # the derivative of z, in the space of y
    ("y_n, z_n", {"lambda_n": (0, -3)}),
    ("y_n, z_n", {"z": (-6, -7)}),  # lambda, in the space of z alone
    ("v_n", {"v": (-2, -2)}),
    ("xi_n", {"xi": (0, -3)}),
    ("xi_n(0)", {"f": (4, -4)}),
    ("xi_n(0)", {"y": (1, -7)}),
    ("xi_n(0)", {"v": (8, 1)}),
    ("xi_n(0)", {"b": (-1, -9)}),
    ("xi_n(0)", {"p": (-1, -9)}),
]


def with_spaces(patch: pytest.MonkeyPatch, wrong: dict[str, tuple[int, int]]) -> None:
    for name, shift in wrong.items():
        patch.setitem(LEMMA if name == "f" else SPACES, name, shift)


@pytest.mark.parametrize(("step", "wrong"), WRONG_SPACES)
def test_each_part_of_a_step_is_needed(
    monkeypatch: pytest.MonkeyPatch, step: str, wrong: dict[str, tuple[int, int]]
) -> None:
    assert all(ledger.steps().values())
    with_spaces(monkeypatch, wrong)
    assert ledger.steps()[step] is False


ONE_BEFORE_FOUR = dict.fromkeys(("p", "b", "xi"), (-5, 0)) | {"f": (-6, -1), "lambda_n": (-6, -1)}
"""Powers 1, 3, 4, 5, ... of epsilon: not closed under addition, as 1 + 1 = 2 is missing."""


@pytest.mark.parametrize(
    ("route", "wrong"),
    [
        ("lemma_by_induction", {"f": (6, -4)}),  # a product has more powers than the space of f
        ("lemma_by_induction", {"f": (-3, -4), "xi": (-5, -6)}),  # f has no constants
        ("lemma_by_induction", {"xi": (4, -3)}),
        ("lemma_by_powers_of_epsilon", {"xi": (2, 3)}),  # powers that are no integers
        ("lemma_by_powers_of_epsilon", {"f": (-9, -4), "xi": (-8, -3)}),  # f has no constants
        ("lemma_by_powers_of_epsilon", {"xi": (1, 0)}),  # epsilon^1, which f may not have
        ("lemma_by_powers_of_epsilon", {"xi": (1, -6)}),  # f is allowed powers that do not occur
        ("lemma_by_powers_of_epsilon", {"f": (0, -1)}),  # epsilon^1 in f
        ("steps_in_powers_of_epsilon", {"xi": (2, 3)}),
        ("steps_in_powers_of_epsilon", {"p": (1, -6)}),
        ("steps_in_powers_of_epsilon", {"y": (-6, -1)}),
        ("steps_in_powers_of_epsilon", ONE_BEFORE_FOUR | {"y": (-3, -1), "z": (-3, -1), "v": (-4, -2)}),
        ("steps_in_powers_of_epsilon", ONE_BEFORE_FOUR | {"f": (0, -4)}),
    ],
)
def test_each_part_of_a_route_is_needed(
    monkeypatch: pytest.MonkeyPatch, route: str, wrong: dict[str, tuple[int, int]]
) -> None:
    assert getattr(ledger, route)() is True
    with_spaces(monkeypatch, wrong)
    assert getattr(ledger, route)() is False


@pytest.mark.parametrize(
    ("wrong", "answers"),
    [
        ("n - 1", [False, False, False]),
        ("n - 3", [False, False, False]),
        ("2*n - k - 4", [False, False, False]),  # right for one factor, wrong for more
        ("0*n - 2", [False, False, False]),
    ],
)
def test_another_highest_term_is_refuted_by_each_route(
    monkeypatch: pytest.MonkeyPatch, wrong: str, answers: list[bool]
) -> None:
    assert ledger.dependence() is True
    monkeypatch.setitem(ledger.LOWEST, "highest k", wrong)
    assert ledger.dependence() is False
    assert [check.agrees for check in ledger.ENTRIES["5-lemma-orders"]().checks] == answers


def test_terms_beyond_the_highest_must_have_negative_orders(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ledger, "LOWEST", {"highest k": "1/2*n", "order of xi_k": "2*k"})
    assert ledger.dependence() is False


def test_the_quartic_by_its_orders(monkeypatch: pytest.MonkeyPatch) -> None:
    assert ledger.wrong_in_a_quartic() == []
    monkeypatch.setitem(ledger.LOWEST, "highest k", "n - 1")
    assert ledger.wrong_in_a_quartic(4) == [1, 2, 3]
    monkeypatch.setitem(ledger.LOWEST, "highest k", "1/2*n - 1")
    assert ledger.wrong_in_a_quartic(5) == [0 + 3, 4]
    monkeypatch.setattr(explicit, "highest_in_a_quartic", lambda _: {2: 0, 3: -1})
    monkeypatch.setitem(ledger.LOWEST, "highest k", "n - 2")
    assert ledger.wrong_in_a_quartic(4) == [3]


@pytest.mark.parametrize(
    ("identifier", "target", "name", "wrong", "position"),
    [
        ("5-lemma-orders", ledger, "scaling_is_that_of_xi", lambda: False, 0),
        ("5-lemma", ledger, "lemma_by_induction", lambda: False, 0),
        ("5-lemma", ledger, "lemma_by_powers_of_epsilon", lambda: False, 1),
        ("5-theorem-1-spaces", ledger, "dependence", lambda: False, 0),
        ("5-theorem-1-spaces", ledger, "lemma_by_induction", lambda: False, 0),
        ("5-theorem-1-spaces", ledger, "lemma_by_powers_of_epsilon", lambda: False, 0),
        ("5-theorem-1-spaces", ledger, "steps", lambda: {"one": True, "another": False}, 0),
        ("5-theorem-1-spaces", ledger, "steps_in_powers_of_epsilon", lambda: False, 1),
    ],
)
def test_a_step_that_fails_leaves_its_check_open(
    identifier: str, target: Any, name: str, wrong: Any, position: int
) -> None:
    answers = answers_with(target, name, wrong, ledger.ENTRIES[identifier])
    assert answers == [None if k == position else True for k in range(len(answers))]


@pytest.mark.parametrize(
    ("identifier", "target", "name", "wrong", "position"),
    [
        ("5-lemma", ledger, "outside_by_induction", lambda: True, 0),
        ("5-lemma", ledger, "outside_by_powers_of_epsilon", lambda: True, 1),
        ("5-lemma", explicit, "lemma_on_functions", lambda: False, 3),
        ("5-initial-values", ledger, "step_4_in_systems", lambda: False, 1),
        ("5-corollary", ledger, "corollary_exponents", lambda name: name != "z", 0),
        ("5-corollary", ledger, "printed_exponents", lambda parity: parity == 0, 0),
        ("5-corollary", ledger, "corollary_powers", lambda name: name != "z", 1),
        ("5-corollary", ledger, "printed_powers", lambda parity: parity == 0, 1),
        ("5-corollary", ledger, "example_in_t_and_epsilon", lambda: False, 2),
    ],
)
def test_a_counterexample_fails_its_check(identifier: str, target: Any, name: str, wrong: Any, position: int) -> None:
    answers = answers_with(target, name, wrong, ledger.ENTRIES[identifier])
    assert answers == [k != position for k in range(len(answers))]


@pytest.mark.parametrize(
    ("route", "wrong", "outside"),
    [
        ("outside_by_induction", {"f": (6, -4)}, False),  # a wider space than the lemma's holds what the lemma's holds
        ("outside_by_induction", {"f": (-3, -4), "xi": (-5, -6)}, True),  # a constant
        ("outside_by_induction", {"xi": (4, -3)}, True),
        ("outside_by_induction", {"f": (3, -1), "xi": (4, 0)}, True),  # the product of two
        ("outside_by_powers_of_epsilon", {"xi": (2, 3)}, None),
        ("outside_by_powers_of_epsilon", {"f": (-9, -4), "xi": (-8, -3)}, True),
        ("outside_by_powers_of_epsilon", {"xi": (1, 0)}, True),
        ("outside_by_powers_of_epsilon", {"xi": (1, -6)}, False),
        ("outside_by_powers_of_epsilon", ONE_BEFORE_FOUR | {"f": (0, -1), "xi": (-5, 0)}, False),
    ],
)
def test_what_is_a_counterexample_to_the_lemma(
    monkeypatch: pytest.MonkeyPatch, route: str, wrong: dict[str, tuple[int, int]], outside: bool | None
) -> None:
    assert getattr(ledger, route)() is False
    with_spaces(monkeypatch, wrong)
    assert getattr(ledger, route)() is outside


def test_a_lemma_without_a_counterexample_is_open() -> None:
    assert [ledger.unless(outside, holds) for outside in (None, True, False) for holds in (True, False)] == [
        *(None, None),
        *(False, False),
        *(True, None),
    ]


def test_the_steps_are_named() -> None:
    (what,) = [check.what for check in ledger.ENTRIES["5-theorem-1-spaces"]().checks if "induction" in check.what]
    assert what == "proofs/expansion.md: section 4, the steps of the induction, each for every ν at once: " + ", ".join(
        ledger.steps()
    )


@pytest.mark.parametrize(
    ("row", "place", "holds"),
    [
        ([0, 1], (1, 0), True),  # p: s^1 delta^(0 + 2) is t
        ([0, 1], (1, 1), False),  # its series has another power of epsilon
        ([1], (0, 0), False),  # s^0 delta^2: no integer power
        ([0, 0, 0, 0, 1], (4, -2), False),  # s^4 delta^2: a negative power
    ],
)
def test_a_term_of_the_example_must_be_one_of_its_series(
    monkeypatch: pytest.MonkeyPatch, row: list[int], place: tuple[int, int], holds: bool
) -> None:
    with_chi = {key: [] for key in "byvz"} | {"p": [row]}
    monkeypatch.setattr(ledger, "extended_terms", lambda _, chi: with_chi if chi else {})
    monkeypatch.setattr(ledger, "example_series", lambda _: {name: {place: 1} for name in "pbyvz"})
    assert ledger.example_in_t_and_epsilon() is holds
