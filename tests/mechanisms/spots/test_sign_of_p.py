"""The sign of p where there is contact: page proofs/sign_of_p.md."""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.functions.expressions import Constant, Expression, Variable
from gspot_verified.mechanisms.input.given import lagrangian
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.mechanisms.spots.all_g_spots import find_g_spots
from gspot_verified.mechanisms.spots.sign_of_p import sign_of_p
from gspot_verified.mechanisms.zeros import all_zeros
from gspot_verified.numbers.evidence import equal, less
from gspot_verified.numbers.verdict import Evidence, Outcome

Q, W = Variable(0), Variable(1)


def number(value: int | fmpq) -> Expression:
    return Constant(fmpq(value))


def program(p: Expression, *others: Expression) -> BoxProgram:
    return BoxProgram([p, *others], 2)


def hold(box: tuple[arb, ...]) -> Evidence | str:
    """Hypotheses that hold everywhere."""
    return equal(len(box), len(box)) or ""


def coupled(mu: str) -> Mechanism:
    """p = (1 + mu c)/(1 - c^2) with c = -(2 + cos(phi))/4 in [-3/4, -1/4]: p < 0 in every state only for mu > 4."""
    c = "-(2 + cos(phi))/4"
    rows = [[1, c, 0], [c, 1, 0], [0, 0, 1]]
    return lagrangian("coupled", ["q", "r", "phi"], rows, [0, "-1 + sin(phi)/9", 0], "q", "r", mu)


@pytest.mark.parametrize(("mu", "sign"), [("17/4", -1), ("5/4", 1), (0, 1), (100, -1)])
def test_a_friction_so_high_that_p_is_negative_everywhere(mu: str, sign: int) -> None:
    found = find_g_spots(coupled(mu))
    assert found.verdict.outcome is Outcome.REFUTED
    assert found.sign_of_p is not None
    assert found.sign_of_p.sign == sign
    assert ("paradox proper" in str(found)) == ("p < 0 everywhere" in str(found)) == (sign < 0)
    assert ("p > 0 everywhere" in str(found)) == (sign > 0)
    assert found.verdict.detail == str(found.sign_of_p)
    assert found.verdict.against is not None
    assert set(found.sign_of_p.shown.facts) <= set(found.verdict.against.facts)


@pytest.mark.parametrize(
    ("mass", "mu"), [("-2 - sin(q)", "1/2"), ("2 + sin(q)", "-3 - sin(q)"), ("1/2 + sin(q)", "1/2"), ("1", "sin(q)")]
)
def test_nothing_is_said_of_what_is_no_mechanism_in_some_state(mass: str, mu: str) -> None:
    """C = 1/mass and B = 0, so p = C < 0 where the mass is negative: no paradox. Nor is one where mu < 0."""
    found = find_g_spots(lagrangian("no mechanism", ["q", "r"], [["1", 0], [0, mass]], [0, "-1"], "q", "r", mu))
    assert found.sign_of_p is None
    assert "everywhere" not in str(found)


def test_a_mass_that_depends_on_a_component_that_p_does_not_see() -> None:
    """The mass of s has no part in p; it is positive for |s| < 2 only."""
    rows = [[1, 0, 0], [0, 1, 0], [0, 0, "4 - s^2"]]
    body = lagrangian("aside", ["q", "r", "s"], rows, [0, "-1", 0], "q", "r", "1/2")
    assert find_g_spots(body).sign_of_p is None
    for reach, sign in ((1, 1), (3, None)):
        found = find_g_spots(body, {"s": (-reach, reach)})
        assert found.verdict.outcome is Outcome.REFUTED
        assert (None if found.sign_of_p is None else found.sign_of_p.sign) == sign


@pytest.mark.parametrize(("mu", "sign"), [("4 - q", None), ("2 + cos(q/2)", None), ("2 + cos(2*q)", 1)])
def test_friction_that_does_not_repeat_with_the_turns_of_p(mu: str, sign: int | None) -> None:
    """B = 0, so p does not see mu, and one turn of q is searched: there mu >= 0, and 4 - q < 0 later."""
    rows = [[1, 0], [0, "2 + sin(q)"]]
    found = find_g_spots(lagrangian("wound", ["q", "r"], rows, [0, "-1"], "q", "r", mu))
    assert found.periods == (("q", 1),)
    assert (None if found.sign_of_p is None else found.sign_of_p.sign) == sign


def test_nothing_is_said_where_there_are_g_spots() -> None:
    assert find_g_spots(shipped_mechanism("rod")).sign_of_p is None


def test_nothing_is_said_where_p_vanishes_and_b_does_not() -> None:
    """Between mu = 4/3 and 4 p has zeros; b = (-1 + sin(phi)/9) C is negative: no G-spot, and both signs of p."""
    found = find_g_spots(coupled("2"))
    assert found.verdict.outcome is Outcome.REFUTED
    assert found.sign_of_p is None
    assert "everywhere" not in str(found)


def test_in_a_box_the_sign_is_that_of_the_box() -> None:
    """The rod at mu = 2: p < 0 just where T^2 - 6 T + 4 < 0, T = tan(theta): between 0.7640 and 5.2360."""
    rod = shipped_mechanism("genot_brogliato_rod")
    for box, sign in (((Fraction(7, 10), Fraction(13, 10)), -1), ((Fraction(-1), Fraction(1, 2)), 1)):
        found = find_g_spots(rod, {"theta": box})
        assert found.sign_of_p is not None
        assert found.sign_of_p.sign == sign
    assert find_g_spots(rod, {"theta": (1, 2), "theta_dot": (100, 101)}).sign_of_p is None


@given(st.fractions(-3, 3, max_denominator=9), st.fractions(-3, 3, max_denominator=9))
def test_a_quadratic_with_no_zero_and_one_with_zeros(middle: Fraction, least: Fraction) -> None:
    """p = (q - middle)^2 + least on [-3, 3]: its sign is known by hand."""
    shifted = Q - number(fmpq(middle.numerator, middle.denominator))
    p = shifted * shifted + number(fmpq(least.numerator, least.denominator))
    largest = max((3 - middle) ** 2, (3 + middle) ** 2) + least
    found = sign_of_p(program(p), [arb(0, 3), arb(0)], hold, budget=60)
    if least > 0 or largest < 0:
        assert found is not None
        assert found.sign == (1 if least > 0 else -1)
    else:
        assert found is None


def test_what_is_not_in_contact_does_not_count() -> None:
    """p = q, contact where q^2 = 4: of the two places one may lie in the box."""
    contact = Q * Q - number(4)
    for lower, upper, sign in ((-1, 3, 1), (-3, 1, -1), (-3, 3, None), (-1, 1, None)):
        side = arb((lower + upper) / 2, (upper - lower) / 2)
        found = sign_of_p(program(Q, contact), [side, arb(0)], hold)
        assert (None if found is None else found.sign) == sign


def test_a_zero_of_p_a_budget_and_what_is_not_finite_leave_it_open() -> None:
    assert sign_of_p(program(number(0)), [arb(0, 1), arb(0)], hold) is None
    assert sign_of_p(program(Q * Q), [arb(0, 1), arb(0)], hold, budget=60) is None
    wide = Q * Q - Q + number(fmpq(1, 3))
    assert sign_of_p(program(wide), [arb(0, 2), arb(0)], hold, budget=2) is None
    assert sign_of_p(program(wide), [arb(0, 2), arb(0)], hold) is not None
    assert sign_of_p(program(number(1) / Q), [arb(0, 1), arb(0)], hold, budget=60) is None
    assert sign_of_p(BoxProgram([number(1) / Q], 2, ()), [], hold) is None
    constant = sign_of_p(BoxProgram([number(-2)], 2, ()), [], hold)
    assert constant is not None
    assert constant.sign == -1


def test_the_hypotheses_are_asked_where_there_is_contact_alone() -> None:
    """p = 1, contact where q^2 = 4; what is supposed holds for q < 0, or for q > 1."""
    contact, sides = Q * Q - number(4), [arb("0.5", "2.5"), arb(0)]
    one = program(number(1), contact)
    assert sign_of_p(one, sides, lambda box: less(box[0], 0) or "q < 0") is None
    assert sign_of_p(one, sides, lambda box: less(1, box[0]) or "q > 1") is None
    found = sign_of_p(one, [arb("1", "2"), arb(0)], lambda box: less(1, box[0]) or "q > 1")
    assert found is not None
    assert any(fact.startswith("1 < ") for fact in found.shown.facts)


def test_a_part_that_gets_lost_leaves_no_evidence(monkeypatch: pytest.MonkeyPatch) -> None:
    """p = q - 1 on [-3, 3] with the upper half forgotten would be negative everywhere."""
    whole = all_zeros.halves
    monkeypatch.setattr("gspot_verified.mechanisms.spots.sign_of_p.halves", lambda box, j: whole(box, j)[1:])
    assert sign_of_p(program(Q - number(1)), [arb(0, 3), arb(0)], hold) is None
