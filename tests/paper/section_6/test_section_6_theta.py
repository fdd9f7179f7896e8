"""The expansion and the scaled Θ beside the simulations: each step asks for what it says, without a run."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb, fmpq

from gspot_verified.numbers.balls import approximate, ball, working_bits
from gspot_verified.paper.section_6 import section_6_theta as ledger
from gspot_verified.theta_function.theta import theta

BETA, EPSILON = fmpq(7, 3), fmpq(1, 10**6)


def run(t: Any, p: Any, b: Any) -> Any:
    return SimpleNamespace(samples=SimpleNamespace(columns={"t": list(t), "p": list(p), "b": list(b)}))


@pytest.mark.parametrize(
    ("t", "p", "zero"),
    [
        ([0, 1, 3, 7], [3, 2, -1, -2], 7 / 3),
        ([0, 1, 2, 4], [3, 2, 0, -1], 2),
        ([0, 1, 2, 4, 5, 6], [-1, 1, 2, -2, 3, -3], 3),
        ([0, 1, 2], [0, 1, -1], 3 / 2),
    ],
)
def test_time_is_counted_from_where_p_vanishes(t: Any, p: Any, zero: float) -> None:
    found = list(ledger.steps(run(t, p, range(5, 5 + len(t)))))
    assert [b for _, b in found] == list(range(5, 5 + len(t)))
    assert [round(approximate(time), 12) for time, _ in found] == [round(x - zero, 12) for x in t]


def test_a_run_that_does_not_pass_has_no_steps() -> None:
    assert list(ledger.steps(run([0, 1], [2, 1], [0, 0]))) == []
    assert list(ledger.steps(run([0, 1], [-2, -1], [0, 0]))) == []


@pytest.mark.parametrize("t", [fmpq(-1, 5000), fmpq(0), fmpq(1, 10_000), fmpq(1, 1000)])
def test_the_scaled_theta_in_balls(monkeypatch: pytest.MonkeyPatch, t: fmpq) -> None:
    monkeypatch.setattr(ledger, "amount", lambda: fmpq(-3, 2))
    with working_bits(96):
        kappa = (arb(fmpq(175, 816)) * ball(ledger.number("alpha_1", BETA, fmpq(0))) / arb(fmpq(-175, 408))).root(3)
        small = arb(EPSILON) ** arb(fmpq(2, 3))
        expected = arb(fmpq(-3, 2)) * kappa ** (-ball(BETA)) * small ** ball(BETA) * theta(kappa * t / small, BETA)
        assert expected.is_finite()
        assert abs(ledger.scaled_theta(t) - expected) < abs(expected) / 10**9


def test_c_1_has_4_decimals(monkeypatch: pytest.MonkeyPatch) -> None:
    for found, amount in ((arb("-59.56804"), fmpq(-595_680, 10_000)), (None, None)):
        monkeypatch.setattr(ledger, "slip", lambda name, found=found: SimpleNamespace(coefficient=found, name=name))
        assert ledger.amount() == amount


def followed(monkeypatch: pytest.MonkeyPatch, whole: bool = True) -> tuple[dict[fmpq, arb], dict[str, Any]]:
    """The ratios with a track and a slow deviation that are given: s + 2 ± 1/8 in each component but b, 10 there."""
    asked: dict[str, Any] = {}

    def track(_: Any, power: fmpq, first: fmpq, last: fmpq, middles: Any, radii: Any, outside: arb) -> Any:
        asked.update(power=power, first=first, last=last, middles=middles, radii=radii, outside=outside)
        ends = [SimpleNamespace(end=end, end_deviations=[arb(1), 10 + arb(end), arb(3)]) for end in (fmpq(0), fmpq(1))]
        return SimpleNamespace(is_whole=whole, pieces=ends)

    monkeypatch.setattr(ledger, "amount", lambda: fmpq(-3, 2))
    monkeypatch.setattr(ledger, "expansion", lambda order: order)

    def lagged(bound: arb, v: arb) -> tuple[arb, arb]:
        return bound, v

    monkeypatch.setattr(
        ledger,
        "DeviationEquations",
        lambda order, delta: SimpleNamespace(y=2, v=2, lagged=lagged, given=(order, delta)),
    )
    monkeypatch.setattr(ledger, "track", track)
    monkeypatch.setattr(ledger, "slow_deviation", lambda *given: (arb(2, "1/8") + given[3], arb(10), arb(7, "1/4")))
    return ledger.ratios.__wrapped__(), asked


def test_the_deviation_begins_with_its_whole_ball(monkeypatch: pytest.MonkeyPatch) -> None:
    found, asked = followed(monkeypatch)
    assert (asked["power"], asked["first"], asked["last"]) == (fmpq(8, 3), -1, 1)
    assert asked["middles"] == [1, 10, 7]
    assert all(radius >= least for radius, least in zip(asked["radii"], (arb("1/8"), arb(0), arb("1/4")), strict=True))
    force, v = asked["outside"]  # f = 0 at the start, and phi what the largest e_v makes of it
    assert force == 0
    assert v.contains(arb("7.25"))
    assert list(found) == [0, 1]
    assert found[fmpq(0)] == 1
    assert abs(10 * found[fmpq(1)] - 11) < arb("1e-12")


def test_no_ratio_without_a_track_or_a_coefficient(monkeypatch: pytest.MonkeyPatch) -> None:
    assert followed(monkeypatch, whole=False)[0] == {}
    monkeypatch.setattr(ledger, "amount", lambda: None)
    assert ledger.ratios.__wrapped__() == {}
    monkeypatch.setattr(ledger, "ratios", dict)
    assert ledger.fits() is None
    assert ledger.widest() == "it was not followed"


@pytest.mark.parametrize(
    ("ratio", "answer"),
    [("1.0199", True), ("0.9801", True), ("1.0201", False), ("0.9799", False), ("[1 +/- 0.03]", None)],
)
def test_within_2_per_cent(monkeypatch: pytest.MonkeyPatch, ratio: str, answer: bool | None) -> None:
    monkeypatch.setattr(ledger, "ratios", lambda: {fmpq(0): arb(1), fmpq(1): arb(ratio)})
    assert ledger.fits() is answer


@pytest.mark.parametrize(("share", "answer"), [(0.039, True), (-0.039, True), (0.041, False), (-0.041, False)])
def test_a_float_run_within_4_per_cent_of_the_largest_value_so_far(
    monkeypatch: pytest.MonkeyPatch, share: float, answer: bool
) -> None:
    """What comes before p = 0 or after 0.0011 does not count; Θ falls after 0.0005 here."""

    def scaled(t: fmpq) -> float:
        return 1 - abs(approximate(t) - 0.0005) / 0.001

    times = [k * 1e-4 for k in range(-3, 20)]
    values = [7 * t + scaled(fmpq(*t.as_integer_ratio())) for t in times]
    values = [b + (5 if t < 0 or t > 0.00111 else 0) for t, b in zip(times, values, strict=True)]
    values[13] += share  # t = 0.001
    found = run([t + 3 for t in times], [-t for t in times], values)
    monkeypatch.setattr(ledger, "simulated", lambda _: found)
    monkeypatch.setattr(ledger, "order_15", lambda t: 7 * approximate(t))
    monkeypatch.setattr(ledger, "scaled_theta", scaled)
    assert ledger.floats_fit() is answer


def test_with_a_smaller_epsilon_the_fit_is_closer(monkeypatch: pytest.MonkeyPatch) -> None:
    """As the note says."""
    monkeypatch.setattr(ledger, "DELTA", fmpq(1, 1000))
    ledger.ratios.cache_clear()
    try:
        found = ledger.ratios()
        assert len(found) == 17
        assert all(abs(ratio - 1) < fmpq(2, 1000) for ratio in found.values())
    finally:
        ledger.ratios.cache_clear()


def test_a_term_of_the_lower_order_alone_counts(monkeypatch: pytest.MonkeyPatch) -> None:
    tables = {ledger.ORDER: {(0, 0): fmpq(3)}, ledger.HIGHER: {(0, 1): fmpq(1)}}
    monkeypatch.setattr(
        ledger, "expansion", lambda order: SimpleNamespace(in_time=lambda: SimpleNamespace(b=tables[order]))
    )
    assert ledger.difference() == 3 + EPSILON


def test_the_difference_of_two_expansions(monkeypatch: pytest.MonkeyPatch) -> None:
    tables = {15: {(0, 1): fmpq(1), (3, 0): fmpq(2)}, 31: {(0, 1): fmpq(3, 2), (3, 0): fmpq(2), (2, 0): fmpq(-1)}}
    monkeypatch.setattr(
        ledger, "expansion", lambda order: SimpleNamespace(in_time=lambda: SimpleNamespace(b=tables[order]))
    )
    assert ledger.difference() == fmpq(1, 2) * EPSILON + ledger.DRAWN**2


@pytest.mark.parametrize(
    ("p", "b", "answer"),
    [
        ("0.0101", "-0.0101", True),
        ("0.0101", "0.0101", True),
        ("0.0099", "-0.0101", False),
        ("0.0101", "0.0099", False),
        ("[0.01 +/- 0.001]", "-0.0101", None),
    ],
)
def test_the_drawing_is_covered(monkeypatch: pytest.MonkeyPatch, p: str, b: str, answer: bool | None) -> None:
    values = {31: {"p": arb(p), "b": arb(0)}, 15: {"p": arb(0), "b": arb(b)}}
    evaluated = {
        order: SimpleNamespace(evaluate_in_time=lambda *_, value=value: value) for order, value in values.items()
    }
    monkeypatch.setattr(ledger, "expansion", evaluated.get)
    assert ledger.covers_the_drawing() is answer


def test_b_is_larger_where_the_stretch_begins() -> None:
    """Where the statement has its bound of |b|: at the end, the G-spot, it is 1.2e-8."""
    sizes = [abs(ledger.order_15(t)) for t in (ledger.DRAWN, fmpq(-1, 1000), fmpq(0))]
    assert sizes == sorted(sizes, reverse=True)
    assert sizes[0] > 0.01 > 1e-7 > sizes[-1] > 1e-8


def test_the_orders_where_p_is_1_100() -> None:
    """docs/scenes.md has these numbers."""
    t = fmpq(-22047, 10**6)
    low, high = (ledger.expansion(order).evaluate_in_time(t, EPSILON, 25) for order in (15, 31))
    assert all(abs(found["p"] - fmpq(1, 100)) < fmpq(1, 10**5) for found in (low, high))
    apart = abs(high["b"] - low["b"])
    assert apart < fmpq(4, 10**6)
    assert apart < abs(low["b"]) / 10**4
    for t, size in ((fmpq(-1, 1000), "2e-18"), (fmpq(1, 1000), "8e-19")):
        low, high = (ledger.expansion(order).evaluate_in_time(t, EPSILON, 40) for order in (15, 31))
        assert f"{approximate(abs(high['b'] - low['b'])):.0e}" == size


@pytest.mark.parametrize(
    ("low", "high", "answer"), [(4.9e-6, -4.9e-6, True), (5.1e-6, 0.0, False), (0.0, -5.1e-6, False)]
)
def test_a_float_run_near_both_orders(monkeypatch: pytest.MonkeyPatch, low: float, high: float, answer: bool) -> None:
    """Within half of the bound of each: so the two are within the bound of each other."""
    monkeypatch.setattr(ledger, "load_scene", lambda *_, **__: None)
    monkeypatch.setattr(ledger, "float_run", lambda *_: run([0, 1, 2], [2, 1, -1], [3, 3, 9]))
    monkeypatch.setattr(ledger, "order_15", lambda _: 3 + low)
    monkeypatch.setattr(ledger, "order_31", lambda _: 3 + high)
    assert ledger.floats_stay_near() is answer


def test_the_texts_name_what_is_followed(monkeypatch: pytest.MonkeyPatch) -> None:
    ends = [fmpq(k, 17) for k in range(-15, 18, 2)]
    monkeypatch.setattr(ledger, "ratios", lambda: dict.fromkeys(ends, arb(1)))
    for name in ("floats_fit", "floats_stay_near", "covers_the_drawing"):
        monkeypatch.setattr(ledger, name, lambda: True)
    monkeypatch.setattr(ledger, "difference", lambda: fmpq(1, 10**6))
    monkeypatch.setattr(ledger, "amount", lambda: fmpq(-60))
    fit, order = (ledger.ENTRIES[name]() for name in ("6-theta-fit", "6-order-15"))
    assert fit.statement.startswith(
        "The oscillator in positive slip, for every ε <= 1/1000000 at once: a deviation from the expansion"
    )
    assert "is the leading-order slow one with the C_1 of the second start, to 4 decimals" in fit.statement
    assert (
        "at t = -1 ε^(2/3), λ_N + y/2 as in the expansion, has a b that differs by less than 2 % from C_1"
        in fit.statement
    )
    assert fit.statement.endswith("at t/ε^(2/3) = -15/17, -13/17, ..., 1")
    assert "at ε = 1/1000000 (LSODA), up to t = 0.0011: within 4 % of" in fit.checks[1].what
    assert order.statement.startswith(
        "ε = 1/1000000, from p a little above 1/100 (order 31) to the G-spot: at equal t the b of the expansion of "
        "order 15 differs by less than 1/100000 from that of order 31, with |b| of order 15 above 1/100 where the "
        "stretch begins"
    )
