"""The box of Lemma 5 and what Theorems R5 and R6 ask of it, against the numbers of the page: none may be smaller.

Page: proofs/invariant_region.md, sections 5 to 7.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest
from flint import arb, fmpq

from gspot_verified.functions.expressions import Constant, Variable
from gspot_verified.numbers.balls import approximate, working_bits
from gspot_verified.scenes.certified.growth_cone import FastCone
from gspot_verified.scenes.certified.invariant_region import InvariantRegion
from gspot_verified.scenes.equations.scaled_system import CONTACT, PhaseEvent, ScaledSystem
from gspot_verified.scenes.motions.contact_form import ContactBounds, ContactForm
from gspot_verified.scenes.scene.file import load_scene

RATE = fmpq(1, 10)


def constant(numerator: int, denominator: int = 1) -> Constant:
    return Constant(fmpq(numerator, denominator))


def plain_system(rate: int = 3) -> ScaledSystem:
    """b' = 3 - 2 λ, V' = -1/10 - λ/5 and u = b at whose zero the phase ends: all bounds are numbers, on every box."""
    system = load_scene("fig-varsim1").system("slip")
    b, Y, _, Z = (Variable(i) for i in range(4))
    force = Z - Y
    moves, falls = constant(rate) + constant(-2) * force, constant(-1, 10) + constant(-1, 5) * force
    rates = (moves, system.right_hand_side[1], falls, system.right_hand_side[3])
    return replace(system, right_hand_side=rates, events=(PhaseEvent("slip stops", b, CONTACT),))


def region_of(system: ScaledSystem) -> InvariantRegion:
    return InvariantRegion(system)


def test_the_bounds_are_those_of_the_equations() -> None:
    """b' = 3 - 2 λ is the one slow rate, and that of the one function at whose zero the phase ends; H = 0."""
    with working_bits(64):
        found = ContactForm(plain_system()).bounds(BOX)
    assert abs(found.still + RATE) < 1e-15
    assert abs(found.slope + 2 * RATE) < 1e-15
    assert (found.constant, found.factor) == (0, 0)
    assert (found.rates, found.pushes) == ((3,), (-2,))
    assert (found.stops, found.stop_rates, found.stop_pushes) == ((1,), (3,), (-2,))
    assert found.are_finite()
    assert not replace(found, rates=(arb("nan"),)).are_finite()


class Spy:
    """A cone that is kept, and the boxes on which its bounds were asked for."""

    def __init__(self, region: InvariantRegion, monkeypatch: pytest.MonkeyPatch) -> None:
        self.rate = arb(RATE)
        self.boxes: list[list[arb]] = []
        form = region._form
        ask = form.bounds

        def bounds(box: list[arb]) -> ContactBounds:
            self.boxes.append(list(box))
            return ask(box)

        monkeypatch.setattr(form, "bounds", bounds)

    def is_kept(self, _: ContactBounds) -> bool:
        return True

    def is_kept_for_ever(self, _: ContactBounds) -> bool:
        return True


BOX = [arb(1), arb(-6), arb(-4), arb(-2), arb(700), arb(4)]
"""b, Y, V, Z, the clock and λ."""


def test_the_box_holds_all_that_the_lemma_asks_for(monkeypatch: pytest.MonkeyPatch) -> None:
    """T* = 2, I* = 5: b reaches 1 + 6 and 1 - 10, V = -4 - w with w = 2/10 + 5/5, Y = -6 - (4 + w) 2, the clock 702."""
    region = region_of(plain_system())
    with working_bits(64):
        spy = Spy(region, monkeypatch)
        found = region._kept_until(spy, list(BOX), arb(2), arb(9), lambda _: arb(5))
        assert found is not None
        assert found == 5
        last = spy.boxes[-1]
        w = fmpq(12, 10)
        corners = {0: (7, -9), 1: (-6, -6 - (4 + w) * 2), 2: (-4, -4 - w), 4: (700, 702), 5: (0, 9)}
        for i, values in corners.items():
            assert last[i].is_finite()
            for value in values:
                assert last[i].contains(arb(value)), (i, value)
        # and it is no box of all numbers: within a quarter or so of what is needed
        assert last[0].rad() < 11
        assert last[2].rad() < w
        assert last[1].rad() < (4 + w) * 2


def test_a_box_that_no_cone_keeps_is_none(monkeypatch: pytest.MonkeyPatch) -> None:
    region = region_of(plain_system())
    with working_bits(64):
        spy = Spy(region, monkeypatch)
        monkeypatch.setattr(spy, "is_kept", lambda _: False)
        assert region._kept_until(spy, list(BOX), arb(2), arb(9), lambda _: arb(5)) is None
        assert region._kept_until(spy, list(BOX), arb(2), arb(9), lambda _: arb("inf")) is None
        assert region._kept_until(spy, list(BOX), arb(2), arb(9), lambda _: None) is None


Asked = tuple[arb, arb, arb | None]


def asked_of(region: InvariantRegion, monkeypatch: pytest.MonkeyPatch, answer: arb | None) -> list[Asked]:
    """T*, λ* and I* of every box that is asked for."""
    found: list[Asked] = []
    form = region._form

    def kept_until(
        _: object, box: list[arb], time: arb, largest: arb, impulse: Callable[[ContactBounds], arb | None]
    ) -> arb | None:
        found.append((time, largest, impulse(form.bounds(box))))
        return answer

    monkeypatch.setattr(region, "_kept_until", kept_until)
    return found


@pytest.mark.parametrize("times", [8, 16])
def test_growth_by_a_factor_asks_for_its_time_and_impulse(monkeypatch: pytest.MonkeyPatch, times: int) -> None:
    """R5: λ* = N λ_0, T* = ln(N)/a, I* = λ*/a; a hair more is allowed, less is not."""
    region = region_of(plain_system())
    with working_bits(64):
        asked = asked_of(region, monkeypatch, arb(1))
        assert region._holds_until(FastCone(region._form, arb(RATE), arb(4)), list(BOX), times)
        ((time, largest, impulse),) = asked
        assert impulse is not None
        for value, least in (
            (time, arb(times).log() / RATE),
            (largest, arb(4 * times)),
            (impulse, 4 * times / arb(RATE)),
        ):
            assert value.is_finite()
            assert value.upper() >= least
            assert value < least * (1 + arb(2) ** -40)


@pytest.mark.parametrize(("rate", "gain"), [(3, 3), (-3, 0)])
def test_the_end_of_slip_asks_for_its_impulse(monkeypatch: pytest.MonkeyPatch, rate: int, gain: int) -> None:
    """R6: I* = (u_0 + max(rate, 0) T*)/μ with u_0 = 1, μ = 2; and T* is given only where ∫λ exceeds what is asked."""
    region = region_of(plain_system(rate))
    with working_bits(64):
        form = region._form
        bounds, cone = form.bounds(list(BOX)), FastCone(form, arb(RATE), arb(4))
        asked = asked_of(region, monkeypatch, arb(10) ** 6)
        assert region._until_stop(cone, list(BOX), bounds, 0) is None
        assert len(asked) > 1
        for time, _, impulse in asked:
            assert impulse is not None
            least = (1 + gain * time) / 2
            assert impulse.upper() >= least
            assert impulse < least * (1 + arb(2) ** -40)
        (first, *_) = asked
        spent = 4 * ((RATE * first[0]).exp() - 1) / RATE
        for factor, kept in ((fmpq(999, 1000), True), (fmpq(1001, 1000), False)):
            asked_of(region, monkeypatch, spent * factor)
            found = region._until_stop(cone, list(BOX), bounds, 0)
            assert (found is not None and bool(found == first[0])) is kept


@pytest.mark.parametrize(("alpha_1", "rises"), [("-1", True), ("0", True), ("1", False), ("1/1000000", False)])
def test_growth_for_ever_needs_a_q_that_does_not_fall(alpha_1: str, rises: bool) -> None:
    """q = -p and p' = α_1: with α_1 > 0 nothing is kept for ever (Theorem R2)."""
    scene = load_scene("fig-varsim1", alpha_1=alpha_1, b=-1)
    assert ContactForm(scene.system("slip")).constant_load is rises


def test_no_growth_for_ever_where_p_turns_back() -> None:
    """p = -1/5 at the state, and rises: λ_N grows by a factor only."""
    for alpha_1, clock, lasting in ((-1, 700, True), (1, -700, False)):
        scene = load_scene("fig-varsim1", alpha_1=alpha_1, b=-1)
        system = scene.system("slip")
        state = {"b": arb(-0.1), "Y": arb(-6), "V": arb(-4), "Z": arb(-2), "T": arb(clock)}
        with working_bits(128):
            found = InvariantRegion(system).growth(state)
        assert found is not None
        assert (found.until is None) is lasting
        assert approximate(found.rate) > 0


@pytest.mark.parametrize(("still", "slope"), [("[-3 +/- 1]", "-0.2"), ("-0.1", "[-3 +/- 1]")])
def test_the_largest_bounds_count(monkeypatch: pytest.MonkeyPatch, still: str, slope: str) -> None:
    """w = |F_0| T* + |q| I* with the largest |F_0| and |q| of the box: 8 + 1 or 1/5 + 20."""
    region = region_of(plain_system())
    with working_bits(64):
        spy = Spy(region, monkeypatch)
        ask = region._form.bounds
        monkeypatch.setattr(region._form, "bounds", lambda box: replace(ask(box), still=arb(still), slope=arb(slope)))
        assert region._kept_until(spy, list(BOX), arb(2), arb(9), lambda _: arb(5)) is not None
        w = fmpq(9) if slope == "-0.2" else fmpq(202, 10)
        assert spy.boxes[-1][2].contains(arb(-4 - w))
        assert spy.boxes[-1][1].contains(arb(-6 - (4 + w) * 2))


@pytest.mark.parametrize(
    ("limit", "expected"), [(7, None), (8, 8), (15, 8), (16, 16), (63, 16), (64, 64), (2**40, 2**40), (2**50, 2**40)]
)
def test_no_multiple_is_said_that_was_not_shown(
    monkeypatch: pytest.MonkeyPatch, limit: int, expected: int | None
) -> None:
    region = region_of(plain_system())
    monkeypatch.setattr(region, "_holds_until", lambda cone, box, times: bool(cone and box and times <= limit))
    assert region._most_times(FastCone(region._form, arb(RATE), arb(4)), list(BOX)) == expected
