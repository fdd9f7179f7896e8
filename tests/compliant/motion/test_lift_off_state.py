"""The state at lift-off: units, the a-priori enclosure against the motion, brackets that are too long.

Page: proofs/flight.md.
"""

from __future__ import annotations

from dataclasses import replace

import mpmath
import pytest
from flint import arb, fmpq
from witnesses.contact import moved
from witnesses.flight import lift_off_by_series
from witnesses.theta import contains_witness, to_fraction

from gspot_verified.compliant.model.flight import ContactState
from gspot_verified.compliant.model.normal_form import compliant_model, compliant_state
from gspot_verified.compliant.motion import lift_off_state as module
from gspot_verified.compliant.motion.compliant_force import force
from gspot_verified.compliant.motion.lift_off_state import contact_state, lift_off_state
from gspot_verified.numbers.balls import working_bits

NAMES = ("b", "V", "Y")


def test_units_of_the_normal_form() -> None:
    """The same motion with alpha_1 = -2 in place of -1: t' = 2 t."""
    models = [
        compliant_model("3/2", small, alpha_1=a, alpha_2=b) for small, a, b in (("1/50", -1, -1), ("1/100", -2, -8))
    ]
    starts = [
        compliant_state("1/2", -2, fmpq(-4, 2500), "1/10", fmpq(-2, 2500)),
        compliant_state("1/2", -8, fmpq(-4, 2500), "1/5", fmpq(-2, 2500)),
    ]
    times = [fmpq(-1, 4), fmpq(-1, 8)]
    first, second = (
        contact_state(force(model, start, time, 20), 100)
        for model, start, time in zip(models, starts, times, strict=True)
    )
    assert (first.epsilon, first.alpha_2, first.beta) == (second.epsilon, second.alpha_2, second.beta)
    for name in ("p", "b", "V", "Y", "force"):
        value, other = getattr(first, name), getattr(second, name)
        assert abs(value - other) < arb("1e-15") * (1 + abs(value))


@pytest.mark.parametrize(
    ("beta", "nu", "data"), [("1.5", "2", (fmpq(3, 2), fmpq(-2))), ("2.5", "0.5", (fmpq(5, 2), fmpq(-1, 6)))]
)
def test_the_state_of_the_paper_runs(beta: str, nu: str, data: tuple[fmpq, fmpq]) -> None:
    p, values = lift_off_by_series(beta, nu, "0.001")
    exact = to_fraction(p)
    power, b = data
    model = compliant_model(power, "1/1000")
    square = model.epsilon**2
    start = compliant_state("1/2", b, 4 * b * square, 0, 2 * b * square)
    before = fmpq(int(-exact * 10**22) - 3, 10**22)
    there = contact_state(force(model, start, before, 30), 160)
    found = lift_off_state(there, fmpq(10, 10**22) * 1000, 160)
    assert found.force.is_zero()
    for name, value in zip(NAMES, values, strict=True):
        ball = getattr(found, name)
        assert ball.rad() < 1e-17
        assert contains_witness(ball, to_fraction(value), 30)
    assert contains_witness(found.p, exact, 30)


STATE = ContactState(fmpq(3, 2), fmpq(1, 10), fmpq(-1), *(arb(fmpq(n, 8)) for n in (-2, 3, 5, -4, 1)))


@pytest.mark.parametrize("duration", [fmpq(0), fmpq(1, 100), fmpq(1, 10)])
def test_the_enclosure_holds_the_motion_over_the_whole_bracket(duration: fmpq) -> None:
    found = lift_off_state(STATE, duration, 120)
    with mpmath.workdps(30):
        mean, p = mpmath.mpf(-1) / (1 - mpmath.mpf(3) / 2), mpmath.mpf(-1) / 4
        start = [mpmath.mpf(3) / 8 + p * mean, mpmath.mpf(5) / 8, mpmath.mpf(-1) / 2 + 2 * mean,
                 mpmath.mpf(-3) / 8 + mean]  # fmt: skip
        for part in range(5):
            time = mpmath.mpf(int(duration.p)) / int(duration.q) * part / 4
            (b, V, _, Z), after = moved(start, p, mpmath.mpf(3) / 2, mpmath.mpf(1) / 10, time, 4)
            for name, value in (("b", b - after * mean), ("V", V), ("Y", Z - mean), ("p", after)):
                assert getattr(found, name).is_finite()
                assert contains_witness(getattr(found, name), to_fraction(value), 25)


def test_a_long_bracket_and_no_information_are_not_finite() -> None:
    assert not lift_off_state(STATE, fmpq(4), 120).b.is_finite()
    assert not lift_off_state(replace(STATE, V=arb("nan")), fmpq(1, 100), 120).V.is_finite()
    with working_bits(60):
        assert lift_off_state(STATE, fmpq(1, 10), 60).V.is_finite()


def test_the_equations_of_the_contact_phase() -> None:
    """b' = epsilon (alpha_2 + beta lambda), V' = b + p lambda, Y' = V, Z' = -Z - lambda, lambda = Z - Y: by hand."""
    state = replace(STATE, alpha_2=fmpq(-3), epsilon=fmpq(1, 4))
    found = module._rates(state, *(arb(value) for value in (-2, 7, 5, 3, 11)))
    assert [value.str() for value in found] == [arb(value).str() for value in (fmpq(9, 4), -9, 5, -19)]


@pytest.mark.parametrize("index", range(4))
@pytest.mark.parametrize("sign", [1, -1])
def test_no_variable_may_leave_the_box(index: int, sign: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """The radius is twice the way at the starting rate: a rate on the box that is three times as large is too much."""
    for factor, holds in ((fmpq(19, 10), True), (fmpq(3), False)):
        rates = [[arb(1)] * 4, [sign * arb(factor if k == index else 1) for k in range(4)]]
        monkeypatch.setattr(module, "_rates", lambda *_, left=rates: left.pop(0))
        found = lift_off_state(STATE, fmpq(1, 16), 120)
        assert all(getattr(found, name).is_finite() is holds for name in NAMES)


def test_the_box_is_around_the_state_and_p_runs_through_the_bracket() -> None:
    found = lift_off_state(STATE, fmpq(1, 16), 120)
    for name, value in (("b", fmpq(3, 8)), ("V", fmpq(5, 8)), ("Y", fmpq(-3, 8)), ("p", fmpq(-1, 4))):
        assert getattr(found, name).contains(arb(value))
    assert found.p.contains(arb(fmpq(-1, 4) - fmpq(1, 160)))
    assert found.p.rad() < arb(fmpq(1, 300))
