"""The simulations of the oscillator: what each step asks for and must refuse, without a simulation."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from flint import arb, fmpq
from scipy.integrate import solve_ivp

from gspot_verified.leading_order.contact_force import contact_force
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.paper.section_6 import section_6_runs as ledger
from gspot_verified.paper.section_6.section_6_runs import IMPACT, LIFT_OFF, TOUCH_DOWN
from gspot_verified.scenes.scene.run import RunEvent

FIRST, SECOND = "6-first-start", "6-second-start"


def path(coefficient: Any, end: str = "G-spot", outcome: Outcome = Outcome.PROVED) -> Any:
    """A path in rigid slip that ends so, with this C_1."""
    return SimpleNamespace(verdict=SimpleNamespace(outcome=outcome), end=end, coefficient=coefficient)


@pytest.mark.parametrize(
    ("found", "gamma", "first", "second"),
    [
        (path(arb(2)), 1, False, True),
        (path(arb(-2)), 1, True, False),
        (path(arb(2)), -1, True, False),
        (path(arb(-2)), -1, False, True),
        (path(arb(0, 1)), 1, None, None),
        (path(arb(2)), None, None, None),
        (path(None), 1, None, None),
        (path(arb(2), end="slip stops"), 1, None, None),
        (path(arb(2), outcome=Outcome.UNDECIDED), 1, None, None),
    ],
)
def test_the_side_of_a_start(
    monkeypatch: pytest.MonkeyPatch, found: Any, gamma: int | None, first: bool | None, second: bool | None
) -> None:
    monkeypatch.setattr(ledger, "slip", lambda _: found)
    monkeypatch.setattr(ledger, "gamma_sign", lambda beta: gamma if beta == fmpq(7, 3) else 0)
    assert ledger.takes(FIRST) is first
    assert ledger.takes(SECOND) is second


def test_the_side_of_a_start_for_small_epsilon(monkeypatch: pytest.MonkeyPatch) -> None:
    for side, first in (("lift-off", True), ("impact", False), (None, None)):
        monkeypatch.setattr(ledger, "in_the_limit", lambda _, side=side: SimpleNamespace(side=side))
        assert ledger.takes_in_the_limit(FIRST) is first
        assert ledger.takes_in_the_limit(SECOND) is (None if first is None else not first)


def test_a_start_without_force_comes_into_the_theorem(monkeypatch: pytest.MonkeyPatch) -> None:
    assert ledger.no_force_comes_in() is True
    wrong = {
        "RATES": ({"z": "-z"}, {"v": "b - p*(z - y)"}, {"y": "-v"}),
        "AT_REST": ({"phi": "z - y + y/2"}, {"force": "y"}, {"w": "b"}),
    }
    for table, changes in wrong.items():
        for change in changes:
            with monkeypatch.context() as patch:
                patch.setattr(ledger, table, {**getattr(ledger, table), **change})
                assert ledger.no_force_comes_in() is False


def test_without_it_the_start_is_open(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ledger, "no_force_comes_in", lambda: False)
    monkeypatch.setattr(ledger, "simulated", lambda _: simulation((IMPACT, 3)))
    assert ledger.ENTRIES[SECOND]().checks[1].agrees is None


@pytest.mark.parametrize("p", [0.06, 0.5, 2.0])
def test_a_start_without_force_in_numbers(p: float) -> None:
    """Fixed p, b = -1: λ > 0 and |X| < pΛ = 1 at once, as the page says."""

    def rates(_: float, state: Any) -> list[float]:
        y, v, z = state
        return [v, -1 + p * (z - y), -z - (z - y)]

    run = solve_ivp(rates, (0, 1), [0, 0, 0], rtol=1e-10, atol=1e-12, t_eval=np.linspace(0, 1, 21))
    y, v, z = run.y
    size = p * v**2 / 2 + (-1 + p * (z - y)) ** 2 + 8 * p * (z - y / 2 + v / 4) ** 2
    assert (z - y)[1:].min() > 0
    assert np.all(np.diff(size) < 0)
    assert size[0] == 1


def simulation(*events: tuple[str, Any], t: Any = (), p: Any = (), samples: bool = True) -> Any:
    """A float run with these events and these values of t and p."""
    return SimpleNamespace(
        events=[RunEvent(name, fmpq(time), fmpq(time)) for name, time in events],
        samples=SimpleNamespace(columns={"t": list(t), "p": list(p)}) if samples else None,
    )


def test_the_events_of_the_figure(monkeypatch: pytest.MonkeyPatch) -> None:
    figure = [(LIFT_OFF, 1), (TOUCH_DOWN, 2), (IMPACT, 3)]
    for events, first, second in ((figure, True, False), (figure[2:], False, True), (figure[:2], False, False)):
        monkeypatch.setattr(ledger, "simulated", lambda _, events=events: simulation(*events))
        assert (ledger.floats_show(FIRST), ledger.floats_show(SECOND)) == (first, second)


def test_the_bracket_at_leading_order_holds_the_zero_of_the_force(monkeypatch: pytest.MonkeyPatch) -> None:
    """With C_1 of one number both enclosures are of one zero of λ_N(τ), τ = κ t/ε^(2/3), κ³ = -α_1/2."""
    beta, epsilon, c1 = fmpq(7, 3), fmpq(1, 10**6), fmpq(1, 4)
    sign = -(ledger.gamma_sign(beta) or 0)
    monkeypatch.setattr(ledger, "slip", lambda _: path(arb(sign * c1)))
    found = ledger.leading_bracket()
    assert found is not None
    alpha_1, alpha_2 = (ledger.number(name, beta, fmpq(0)) for name in ("alpha_1", "alpha_2"))
    assert abs(arb(alpha_1) + arb("0.4289")) < arb("0.00005")
    assert abs(arb(alpha_2) + arb("1.8764")) < arb("0.00005")
    force = contact_force(beta, alpha_1=alpha_1, alpha_2=alpha_2, c1=sign * c1)
    with working_bits(96):
        rate = (arb(-alpha_1) / 2).root(3) / arb(epsilon) ** arb(fmpq(2, 3))
        for times in found:
            assert times.rad() < arb("1e-9")
            tau = times * rate
            low, high = (
                fmpq(mantissa) * fmpq(2) ** int(exponent)
                for mantissa, exponent in ((end.mid().man_exp()) for end in (tau.lower(), tau.upper()))
            )
            assert force.value(low - fmpq(1, 10**6), epsilon, 25) > 0
            assert force.value(high + fmpq(1, 10**6), epsilon, 25) < 0


@pytest.mark.parametrize("ends", [(None, None), (fmpq(1), None), (None, fmpq(1))])
def test_no_bracket_without_both_ends(monkeypatch: pytest.MonkeyPatch, ends: tuple[fmpq | None, ...]) -> None:
    monkeypatch.setattr(ledger, "slip", lambda _: path(arb(-1)))
    monkeypatch.setattr(ledger, "lift_off", lambda *_: SimpleNamespace(lower=ends[0], upper=ends[1]))
    assert ledger.leading_bracket() is None


def test_no_bracket_without_a_coefficient_or_with_another_alpha_3(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ledger, "slip", lambda _: path(None))
    assert ledger.leading_bracket() is None
    monkeypatch.setattr(ledger, "slip", lambda _: path(arb(-1)))
    monkeypatch.setattr(ledger, "contact_force", lambda *_, **__: SimpleNamespace(alpha_3=fmpq(-1)))
    assert ledger.leading_bracket() is None


def test_a_larger_coefficient_lifts_off_earlier(monkeypatch: pytest.MonkeyPatch) -> None:
    """The first time belongs to the upper end of the ball of C_1, which is negative here: the smaller size."""
    sign = -(ledger.gamma_sign(fmpq(7, 3)) or 0)
    times = []
    for size in ("0.2", "0.3"):
        monkeypatch.setattr(ledger, "slip", lambda _, size=size: path(sign * arb(size)))
        found = ledger.leading_bracket()
        assert found is not None
        times.append(found[0])
    monkeypatch.setattr(ledger, "slip", lambda _: path(arb(sign * fmpq(1, 4), fmpq(1, 20))))
    both = ledger.leading_bracket()
    assert both is not None
    assert times[1] < times[0]
    ordered = times if sign < 0 else times[::-1]
    for end, expected in zip(both, ordered, strict=True):
        assert abs(end - expected) < arb("1e-6")


@pytest.mark.parametrize(
    ("first", "last", "answer"),
    [
        ("0.00101", "0.00104", True),
        ("0.0010004", "0.0014999", True),
        ("0.0009995", "0.00102", None),
        ("0.00102", "0.0015005", None),
        ("0.0009", "0.0011", None),
        ("0.0008", "0.0009995", False),
        ("0.0015005", "0.0016", False),
        ("0.001", "0.00102", None),
    ],
)
def test_just_after(first: str, last: str, answer: bool | None) -> None:
    with working_bits(96):
        assert ledger.is_just_after(arb(first), arb(last)) is answer


def test_a_delay_that_is_just_after() -> None:
    found = [ledger.floats_are_just_after(fmpq(n, 10**7)) for n in (9995, 10000, 10005, 14995, 15000, 15005)]
    assert found == [False, False, True, True, False, False]
    assert ledger.floats_are_just_after(None) is None


@pytest.mark.parametrize(
    ("run", "delay"),
    [
        (simulation((LIFT_OFF, 5), t=[0, 1, 2, 4, 6], p=[3, 2, 1, -1, -2]), 2),  # p = 0 at t = 3
        (simulation((LIFT_OFF, 5), t=[0, 1, 3, 7], p=[3, 2, -1, -2]), fmpq(8, 3)),  # at t = 7/3
        (simulation((LIFT_OFF, 5), t=[0, 1, 2, 4], p=[3, 2, 0, -1]), 3),  # at a step
        (simulation((LIFT_OFF, 5), (TOUCH_DOWN, 6), t=[1, 2], p=[1, -1]), fmpq(7, 2)),
        (simulation((LIFT_OFF, 5), t=[0, 1], p=[-2, -1]), None),
        (simulation((LIFT_OFF, 5), t=[0, 1], p=[2, 1]), None),
        (simulation((LIFT_OFF, 5), t=[0, 1], p=[-1, 1]), None),
        (simulation((IMPACT, 5), t=[1, 2], p=[1, -1]), None),
        (simulation(t=[1, 2], p=[1, -1]), None),
        (simulation((LIFT_OFF, 5), samples=False), None),
    ],
)
def test_the_time_from_p_0_to_lift_off(monkeypatch: pytest.MonkeyPatch, run: Any, delay: Any) -> None:
    monkeypatch.setattr(ledger, "simulated", lambda _: run)
    found = ledger.simulated_delay()
    assert (found is None) is (delay is None)
    assert found is None or abs(found - delay) < fmpq(1, 10**12)


def test_a_start_at_rest_on_p_0_is_passed_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ledger, "simulated", lambda _: simulation((LIFT_OFF, 5), t=[0, 1, 2], p=[0, 1, -1]))
    assert ledger.simulated_delay() == fmpq(7, 2)


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("alpha_3", "0*beta"),
        ("alpha_3", "-beta"),
        ("alpha_1", "1 + 0*beta"),
        ("alpha_2", "kappa^2 - 1"),
        ("alpha_2", "-kappa - 1"),
        ("alpha_2", "beta - 1"),
        ("alpha_2", "(beta - 1)*kappa"),
    ],
)
def test_what_controls_the_sign(monkeypatch: pytest.MonkeyPatch, name: str, text: str) -> None:
    assert ledger.is_controlled()
    monkeypatch.setitem(ledger.ALPHAS, name, text)
    assert not ledger.is_controlled()


@pytest.mark.parametrize(
    ("alphas", "cases"),
    [
        ((-2, -1, -1), "I"),
        ((-2, 1, -1), "II"),
        ((-1, -1, -2), "III"),
        ((-1, 1, -2), ""),
        ((-2, 0, -1), ""),
        ((-1, 0, -2), ""),
        ((-1, -1, -1), ""),
        ((-1, 1, -1), ""),
        ((-1, -1, 0), ""),
        ((-1, 1, fmpq(1, 2)), ""),
        ((0, -1, -1), ""),
        ((fmpq(1, 2), -1, -1), ""),
    ],
)
def test_the_signs_of_the_cases(monkeypatch: pytest.MonkeyPatch, alphas: tuple[Any, ...], cases: str) -> None:
    values = dict(zip(("alpha_1", "alpha_2", "alpha_3"), map(fmpq, alphas), strict=True))
    monkeypatch.setattr(ledger, "number", lambda name, *_: values[name])
    assert [case for case in ("I", "II", "III") if ledger.belongs(case)] == ([cases] if cases else [])


def test_where_case_iii_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    assert ledger.ends_before_10_3()
    monkeypatch.setitem(ledger.ALPHAS, "alpha_2", "beta - 33333/10000 + kappa")
    assert ledger.ends_before_10_3()
    monkeypatch.setitem(ledger.ALPHAS, "alpha_2", "beta - 33334/10000 + kappa")
    assert not ledger.ends_before_10_3()
    monkeypatch.setitem(ledger.ALPHAS, "alpha_2", "beta - 3 - kappa")
    assert not ledger.ends_before_10_3()


def test_the_numbers_at_a_pair() -> None:
    assert ledger.number("alpha_3", fmpq(7, 3), fmpq(0)) == fmpq(7, 3) * ledger.number("alpha_1", fmpq(7, 3), fmpq(0))


def test_a_number_that_is_zero(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(ledger.ALPHAS, "alpha_1", "beta - 1 + kappa")
    assert ledger.number("alpha_1", fmpq(1), fmpq(0)) == 0
    assert ledger.number("alpha_1", fmpq(3), fmpq(2)) == 4


def test_the_entries_without_an_answer_are_open(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ledger, "in_the_limit", lambda _: SimpleNamespace(approach=path(None), side=None))
    monkeypatch.setattr(ledger, "simulated", lambda _: simulation((LIFT_OFF, 1), (TOUCH_DOWN, 2), (IMPACT, 3)))
    first, second = (ledger.ENTRIES[name]() for name in (FIRST, SECOND))
    assert [check.agrees for check in first.checks] == [None, None, True]
    assert [check.agrees for check in second.checks] == [None, None, False]
    assert "as ε → 0, there is a lift-off; for every ε up to some ε_0 > 0" in first.statement
    assert (
        "as ε → 0, there is an impact; for every ε up to an ε_0 > 0 that depends on a given force" in second.statement
    )
    assert first.statement.endswith("until p < 0, and then lose contact")
    assert "then have a force above the given one" in second.statement
    assert first.checks[-1].finding == "lift-off at t = 1, touch-down at t = 2, impact without collision from t = 3"
    entry = ledger.ENTRIES["6-lift-off-time"]()
    assert [check.agrees for check in entry.checks] == [None, None]
    assert [check.finding for check in entry.checks] == ["", ""]
