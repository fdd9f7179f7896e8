"""Certificates of the contact force: what is found is verified, what is made wrong is rejected with its message."""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any

import pytest
from flint import arb, fmpq
from must_reject.mutate import checker, mutated, put_piece, state, text_of
from samples.strategies import to_fmpq

from gspot_verified.compliant.slow.slow_solution import slow_value
from gspot_verified.compliant.zeros.force_certificate import (
    ForceCertificate,
    LiftOffStatement,
    NotProvable,
    _level,
    check_ratio,
    force_certificate,
    iwc_certificate,
    lift_off_certificate,
)
from gspot_verified.leading_order.contact_force import contact_force
from gspot_verified.leading_order.iwc import leading_order_iwc
from gspot_verified.numbers.balls import working_bits

check = checker()
BETAS = ("3/2", "7/3", "5/2", "7/2", "9/2")


def lines(certificate: ForceCertificate) -> list[Any]:
    return [json.loads(line) for line in certificate.text().splitlines()[:-1]]


FORCE = force_certificate(contact_force("9/2"), fmpq(-3), fmpq(1, 10))
LIFT_OFF = lift_off_certificate(contact_force("5/2", c1=1), fmpq(28, 5), fmpq(1, 1000))


@pytest.mark.parametrize("beta", BETAS)
def test_force_up_to_nearly_the_largest_epsilon(beta: str) -> None:
    force = contact_force(beta)
    largest = leading_order_iwc(beta, tau_start=-2).epsilon_0
    assert largest is not None
    found = force_certificate(force, fmpq(-2), largest * fmpq(9, 10))
    text = check.main.check_text(found.text().encode())
    assert text.startswith("on the slow manifold of the compliant model with α = (-1, -1, ")
    assert "κ^3 = 1/2, λ > 0 for every τ in [-2, inf) and every ε in (0, " in text
    with pytest.raises(NotProvable):
        force_certificate(force, fmpq(-2), largest * fmpq(11, 10))


@pytest.mark.parametrize("beta", BETAS)
def test_lift_off_is_certified_just_beyond_the_leading_order_time(beta: str) -> None:
    charge = -contact_force(beta).c1
    force = contact_force(beta, c1=charge)
    leading = leading_order_iwc(beta, c1=charge)
    time = leading.lift_off
    assert time is not None
    assert time.upper is not None
    beside = iwc_certificate(leading).statement
    assert isinstance(beside, LiftOffStatement)
    assert (1000 * beside.tau).q == 1
    assert time.upper < beside.tau <= time.upper + fmpq(1, 1000)
    found = lift_off_certificate(force, time.upper + fmpq(1, 1000), fmpq(1, 1000))
    assert "λ < 0 at τ = " in check.main.check_text(found.text().encode())
    with pytest.raises(NotProvable):
        lift_off_certificate(force, time.upper - fmpq(1, 1000), fmpq(1, 1000))


def test_of_earlier_times_nothing_is_stated() -> None:
    """For an even floor(beta) lambda falls without bound to the left: there is no contact that could be lost."""
    found = lift_off_certificate(contact_force("5/2", c1=1), fmpq(-10), fmpq(1))
    assert check.main.check_text(found.text().encode()).endswith("κ^3 = 1/2, λ < 0 at τ = -10 for every ε ≥ 1")


@pytest.mark.parametrize("charge", ["-1e400", "1e-400", "-1e-400"])
def test_numbers_that_no_double_holds(charge: str) -> None:
    found = iwc_certificate(leading_order_iwc("5/2", c1=charge))
    assert check.main.check_text(found.text().encode()).startswith("on the slow manifold of the compliant model")


def test_the_statements_are_true_of_the_compliant_model() -> None:
    """Theorem C's conclusion at points, by the exact solution at finite epsilon: no formula of the checker."""
    for epsilon in (fmpq(1, 10), fmpq(1, 50), fmpq(1, 10**6)):
        for place in (fmpq(-3), fmpq(0), fmpq(2), fmpq(5)):
            # lambda = mean + A eps^p beta s G_b with s = (-1)^4: G_b > Theta and the level bounds it from below.
            value = slow_value(_time(place, epsilon), fmpq(7, 2), epsilon).value
            assert value > -FORCE.statement.level * _unit(epsilon)


def _time(tau: fmpq, epsilon: fmpq) -> fmpq:
    size = (float(epsilon.p) / float(epsilon.q) / 2) ** (1 / 3)
    return tau * fmpq(*(1 / size).as_integer_ratio())


def _unit(epsilon: fmpq) -> fmpq:
    """eta^(-b), a little rounded up."""
    size = (float(epsilon.p) / float(epsilon.q) / 2) ** (1 / 3)
    return fmpq(*(size**-3.5 * (1 + 1e-9)).as_integer_ratio())


@pytest.mark.parametrize(("name", "certificate"), [("force", FORCE), ("lift_off", LIFT_OFF)])
def test_the_ones_that_are_made_wrong_below_are_good(name: str, certificate: ForceCertificate) -> None:
    assert check.main.check_text(text_of(lines(certificate)))
    assert lines(certificate)[0]["version"] == 2
    assert lines(certificate)[0]["statement"]["kind"] == name


WRONG_FORCE = [
    ("a larger epsilon", state(epsilon="2/5"), "the deviation exceeds the mean force"),
    ("a larger level", state(level="1000"), "the deviation exceeds the mean force"),
    ("a smaller level", state(level="1/1000"), "is not confirmed"),
    ("a level of 0", state(level="0"), "ε or the level is not positive"),
    ("a negative epsilon", state(epsilon="-1/10"), "ε or the level is not positive"),
    ("the other side", state(c1="1"), "C_1/Γ(-β) is not positive"),
    ("no charge", state(c1="0"), "C_1 = 0"),
    ("a positive alpha", state(alpha=["-1", "1", "-9/2"]), "one of the α is not negative"),
    ("two alphas", state(alpha=["-1", "-1"]), "not a list of three numbers"),
    ("another beta", state(alpha=["-1", "-1", "-7/2"]), "C_1/Γ(-β) is not positive"),
    ("beta beyond 5", state(alpha=["-1", "-1", "-13/2"]), "β is not in (1, 5)"),
    ("an integer beta", state(alpha=["-1", "-1", "-4"]), "an integer"),
    ("a longer range", state(tau="[-4, inf)"), "the pieces do not cover the whole range"),
    ("a closed infinity", state(tau="[-3, inf]"), "closed at infinity"),
    ("lift-off instead", state(kind="lift_off"), "is not a rational number"),
    ("a sign instead", state(kind="sign"), "unknown kind"),
    ("a level called a sign", put_piece(1, 0, "sign", "-3", "5", 1), ""),
    ("a monotone piece", put_piece(1, 0, "monotone", "-3", "-5/2", 1), ""),
    ("a tail with a zero", lambda found: found[1]["pieces"][-1].__setitem__(2, 1), "does not bound the force"),
    ("a tail too early", lambda found: found[1].update(pieces=[["right", "-3", 0]]), "4 changes of sign"),
    ("one level for all", lambda found: found[1].update(pieces=[["level", "-3", "50"]]), ""),
    ("version 1", lambda found: found[0].update(version=1), "the hypotheses are not the pages"),
    ("version 3", lambda found: found[0].update(version=3), "the hypotheses are not the pages"),
    ("version 4", lambda found: found[0].update(version=4), "the pages are not those of a run"),
    ("version 8", lambda found: found[0].update(version=8), "the version is 8"),
    ("two columns", lambda found: found.append(found[1]), ""),
    ("a wider column", lambda found: found[1].update(beta=["17/4", "19/4"]), "there is not one column, the point β"),
    ("a column up to β", lambda found: found[1].update(beta=["17/4", "9/2"]), "there is not one column, the point β"),
    ("a key more", state(more="1"), "has not the keys"),
]
WRONG_LIFT_OFF = [
    ("a smaller epsilon", state(epsilon="1/2000"), "the mean force exceeds the deviation"),
    ("a smaller level", state(level="1/1000"), "the mean force exceeds the deviation"),
    ("a larger level", state(level="1000"), "F beyond the level is not confirmed"),
    ("an earlier time", lambda found: _move(found, "11/2"), "F beyond the level is not confirmed"),
    ("a time without a piece", state(tau="11/2"), "the pieces do not cover the whole range"),
    ("the other side", state(c1="-1"), "C_1/Γ(-β) is not negative"),
    ("a range", state(tau="[5, 6]"), "is not a rational number"),
    ("a piece sign", put_piece(1, 0, "sign", "28/5", "33/5", 1), "there is not one piece level"),
    ("force instead", state(kind="force"), "is not a range"),
    ("a wider column", lambda found: found[1].update(beta=["9/4", "11/4"]), "there is not one column, the point β"),
]


def _move(found: list[Any], tau: str) -> None:
    found[0]["statement"]["tau"] = tau
    found[1]["pieces"] = [["level", tau, str(Fraction(tau) + 1)]]


@pytest.mark.parametrize(("name", "mutation", "message"), WRONG_FORCE, ids=[name for name, *_ in WRONG_FORCE])
def test_wrong_certificates_of_the_force_are_rejected(name: str, mutation: Any, message: str) -> None:
    assert name
    with pytest.raises(check.limits.Rejected) as raised:
        check.main.check_text(mutated(lines(FORCE), mutation))
    assert message in str(raised.value)


@pytest.mark.parametrize(("name", "mutation", "message"), WRONG_LIFT_OFF, ids=[name for name, *_ in WRONG_LIFT_OFF])
def test_wrong_certificates_of_lift_off_are_rejected(name: str, mutation: Any, message: str) -> None:
    assert name
    with pytest.raises(check.limits.Rejected) as raised:
        check.main.check_text(mutated(lines(LIFT_OFF), mutation))
    assert message in str(raised.value)


def test_the_betas_of_a_certificate_are_asked_before_the_work() -> None:
    tiny = fmpq(1, 10**30)
    for beta in (1 + tiny, fmpq(5, 2), 5 - tiny):
        check_ratio(beta)
    for beta in (fmpq(-1), fmpq(1, 2), fmpq(1), fmpq(5), fmpq(11, 2)):
        with pytest.raises(ValueError, match="1 < beta < 5"):
            check_ratio(beta)


@pytest.mark.parametrize("beta", ["1/2", "11/2"])
def test_other_betas_are_refused(beta: str) -> None:
    with pytest.raises(ValueError, match="1 < beta < 5"):
        force_certificate(contact_force(beta), fmpq(-1), fmpq(1, 100))


@pytest.mark.parametrize("beta", ["3/2", "9/2"])
@pytest.mark.parametrize("epsilon", ["1/1000", "1e-20", "3", "1e-400"])
def test_the_level_is_rounded_away_from_what_would_prove_more(beta: str, epsilon: str) -> None:
    """Down for the force, up for lift-off; twelve digits."""
    force = contact_force(beta)
    small = to_fmpq(Fraction(epsilon))
    with working_bits(200):
        exact = force.level(small, 40) / force.beta
        below, above = _level(force, small, -1), _level(force, small, 1)
        assert 0 < below < exact < above
        assert above - below < exact * arb(10) ** -11


def test_the_whole_line() -> None:
    found = force_certificate(contact_force("5/2"), None, fmpq(4, 5))
    assert "λ > 0 for every τ in (-inf, inf) and every ε in (0, 4/5]" in check.main.check_text(found.text().encode())
    with pytest.raises(ValueError, match="floor"):
        force_certificate(contact_force("7/2"), None, fmpq(1, 1000))


def test_the_other_side_is_refused() -> None:
    with pytest.raises(ValueError, match="other side"):
        force_certificate(contact_force("5/2", c1=1), fmpq(-1), fmpq(1, 100))
    with pytest.raises(ValueError, match="other side"):
        lift_off_certificate(contact_force("5/2", c1=-1), fmpq(6), fmpq(1, 100))


@pytest.mark.parametrize(
    ("value", "b", "level", "sign"),
    [
        # value 4^b/2^p against the level, with x = 4: 3 * 4^(3/2) = 24.
        (3, Fraction(3, 2), Fraction(24), 0),
        (3, Fraction(3, 2), Fraction(2399, 100), 1),
        (3, Fraction(3, 2), Fraction(2401, 100), -1),
        (0, Fraction(3, 2), Fraction(1, 10**9), -1),
        (5, Fraction(1, 3), Fraction(5 * 1587401051968, 10**12), 1),
        (5, Fraction(1, 3), Fraction(5 * 1587401051969, 10**12), -1),
    ],
)
def test_sizes_are_compared_exactly(value: int, b: Fraction, level: Fraction, sign: int) -> None:
    scale, meter = check.theta.Scale(4, 20, Fraction(1)), check.limits.Meter(check.limits.Limits(), 10**12)
    assert check.force.compared(value << 20, scale, b, level, meter) == sign


def test_the_size_of_a_derivative_is_not_compared() -> None:
    meter = check.limits.Meter(check.limits.Limits(), 10**12)
    with pytest.raises(check.limits.Rejected, match="the size of a derivative"):
        check.force.compared(1, check.theta.Scale(4, 20, Fraction(2)), Fraction(3, 2), Fraction(1), meter)


@pytest.mark.parametrize(("epsilon", "sign"), [("47/100", -1), ("12/25", 1)])
def test_the_mean_force_is_compared_exactly(epsilon: str, sign: int) -> None:
    # alpha = (-1, -1, -5/2), C_1 = -1, level 1: A eps^p beta/mean = (3/2)(2 eps^2)^(1/2) is 1 at eps = sqrt(2)/3.
    system = check.force.System([Fraction(-1), Fraction(-1), Fraction(-5, 2)], Fraction(-1), Fraction(5, 2))
    assert system.compared(Fraction(epsilon), Fraction(1), check.limits.Meter(check.limits.Limits(), 10**12)) == sign


def test_a_deviation_that_is_the_mean_force_is_neither_above_nor_below() -> None:
    """(|C_1/α_3| β level (α_3 - α_1)/α_2)^6 (2 ε²/-α_1)^3 = (level/2)^6 ε^6, and 1 at level 2, ε 1."""
    system = check.force.System([Fraction(-2), Fraction(-1), Fraction(-5)], Fraction(1, 3), Fraction(5, 2))
    meter, little = check.limits.Meter(check.limits.Limits(), 10**12), Fraction(1, 10**9)
    found = [system.compared(1 + k * little, Fraction(2), meter) for k in (-1, 0, 1)]
    assert found == [-1, 0, 1]


def test_a_piece_of_the_other_sign_does_not_bound_the_force() -> None:
    """F < 0 next to its minimum at tau = 2.27: the piece is true, and the force is not positive by it."""
    found = lines(FORCE)
    pieces = found[1]["pieces"]
    place = next(
        i for i, p in enumerate(pieces) if p[0] == "level" and Fraction(p[1]) <= Fraction(9, 4) < Fraction(p[2])
    )
    pieces[place] = ["sign", *pieces[place][1:], -1]
    with pytest.raises(check.limits.Rejected, match="gives F the other sign"):
        check.main.check_text(text_of(found))


class Known(check.pieces.ColumnCheck):
    """Middle 10, 3 from tau, 2 from b, error 1, in units of x^b/2^p."""

    unit = (1, 0)

    def value(self, *_: Any) -> check.theta.Value:
        return check.theta.Value(10, 3, 2, 1, check.theta.Scale(*self.unit, Fraction(1)))


@pytest.mark.parametrize(
    ("unit", "value"), [((1, 0), 1), ((9, 0), 27), ((1, 3), Fraction(1, 8)), ((16, 10), Fraction(1, 16))]
)
def test_every_part_of_the_width_counts(unit: tuple[int, int], value: Fraction) -> None:
    """At b = 3/2 the unit x^b/2^p is the one that comes with the parts; a part in 10^9 is seen."""
    limits, little = check.limits.Limits(), Fraction(1, 10**9)
    column = Known(check.pieces.Column(Fraction(5, 2), Fraction(5, 2), 0, []), limits, 10**12)
    column.unit = unit
    box = (Fraction(3, 2), Fraction(3, 2), Fraction(0), Fraction(1))
    assert check.force.within(column, box, 16 * value, 0)
    assert not check.force.within(column, box, 16 * value - little, 0)
    assert check.force.beyond(column, Fraction(3, 2), Fraction(0), 4 * value, 1)
    assert not check.force.beyond(column, Fraction(3, 2), Fraction(0), 4 * value + little, 1)
    assert not check.force.beyond(column, Fraction(3, 2), Fraction(0), little, -1)


class Asked(check.pieces.ColumnCheck):
    """What parts answers, one after the other, the last one for ever."""

    def value(self, *question: Any) -> check.theta.Value:
        self.asked.append(question)
        return check.theta.Value(
            *self.answers[min(len(self.asked), len(self.answers)) - 1], check.theta.Scale(1, 0, Fraction(1))
        )


def within(level: str, splits: int, *answers: tuple[int, int, int, int]) -> tuple[bool, int]:
    """Whether |F| ≤ level is confirmed on [0, 1] at b = 3/2, and how many boxes were looked at."""
    column = Asked(check.pieces.Column(Fraction(5, 2), Fraction(5, 2), 0, []), check.limits.Limits(), 10**12)
    column.answers, column.asked = answers, []
    box = (Fraction(3, 2), Fraction(3, 2), Fraction(0), Fraction(1))
    return check.force.within(column, box, Fraction(level), splits), len(column.asked)


@pytest.mark.parametrize("splits", range(5))
def test_a_level_is_tried_on_halves_as_often_as_is_allowed(splits: int) -> None:
    """Of a box that stays open the first half is looked at, and so on; no other after it has failed."""
    assert within("20", splits, (10, 30, 0, 1)) == (False, splits + 1)
    assert within("20", splits, (10, 30, 0, 1), (10, 9, 0, 1)) == ((True, 3) if splits else (False, 1))


def test_a_level_that_a_sharper_ball_may_keep_is_tried_again() -> None:
    """-1 ± (2 + 30): that it is beyond 1/2 is open, so the halves are looked at; an error asks for more bits."""
    assert within("1/2", 1, (1, 30, 0, 2), (0, 0, 0, 0)) == (True, 3)
    assert within("1/2", 1, (-1, 30, 0, 2), (0, 0, 0, 0)) == (True, 3)
    assert within("8", 1, (10, 30, 0, 1), (0, 0, 0, 0)) == (False, 1)
    assert within("8", 1, (-10, 0, 0, 1), (0, 0, 0, 0)) == (False, 1)
    assert within("11", 0, (-10, 0, 0, 1)) == (True, 1)
    assert within("5", 0, (1, 0, 0, 10), (1, 0, 0, 3)) == (True, 2)
    answer, tried = within("5", 0, (1, 0, 0, 10))
    assert not answer
    assert 5 < tried < 20


def test_the_comparison_with_the_mean_force_is_paid_before_it_is_done() -> None:
    """(...)^(3n) (2 ε²/-α_1)^h with β - 1 = h/n = 3/2."""
    system = check.force.System([Fraction(-1), Fraction(-1), Fraction(-5, 2)], Fraction(-1), Fraction(5, 2))
    for epsilon, level, least in (
        (Fraction(1, 10**900), Fraction(1), 3 * check.limits.digits(10**1800)),
        (Fraction(1), Fraction(1, 10**900), 6 * check.limits.digits(10**900)),
    ):
        meter = check.limits.Meter(check.limits.Limits(), 10**12)
        system.compared(epsilon, level, meter)
        assert least**2 <= 10**12 - meter.left <= (least + 99) ** 2 + 10**4


@pytest.mark.parametrize("entries", [{"level": "0"}, {"level": "-1"}, {"epsilon": "0"}, {"epsilon": "-1"}])
@pytest.mark.parametrize("text", [FORCE, LIFT_OFF])
def test_what_must_be_positive(text: str, entries: dict[str, str]) -> None:
    with pytest.raises(check.limits.Rejected, match="ε or the level is not positive"):
        check.main.check_text(mutated(lines(text), state(**entries)))
