"""Theorems 2 and 4 of the page: C_1 read off early, where the bound is wide, contains C_1 read off late.

Page: proofs/approach.md.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any, cast

import pytest
from flint import arb, arb_poly, fmpq
from samples.strategies import ends, holds, to_fmpq

from gspot_verified.integrator.box_steps.integrate import Run
from gspot_verified.integrator.field.field import VectorField
from gspot_verified.mechanisms.approach import deviation_coefficient
from gspot_verified.mechanisms.approach.approach import approach
from gspot_verified.mechanisms.approach.capture import Capture, capture
from gspot_verified.mechanisms.approach.deviation_coefficient import coefficient_above_one, coefficient_below_one
from gspot_verified.mechanisms.approach.distinguished import Distinguished, FlowBounds
from gspot_verified.mechanisms.approach.slip_flow import Numbers, SlipFlow, SlipNumbers
from gspot_verified.mechanisms.approach.slip_state import slip_state
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Evidence

SHOWN = Evidence._of_facts(("for the test",))
STARTS: list[tuple[str, dict[str, Any]]] = [
    ("extended", {"x": 0, "u": 3, "p": "1/4", "b": "-1/2"}),
    ("oscillator", {"phi": "phi_ref + 1/10", "phi_dot": "-9/10"}),
    ("oscillator", {"phi": "phi_ref + 1/10", "phi_dot": "-1/2"}),
    ("rod", {"X": 0, "X_dot": 2, "theta": "theta_ref - 1/20", "theta_dot": "1/2"}),
]


@pytest.mark.parametrize(
    ("name", "state"), [pytest.param(*start, marks=pytest.mark.slow if start is STARTS[2] else []) for start in STARTS]
)
def test_early_bounds_contain_the_late_value(name: str, state: dict[str, Any]) -> None:
    mechanism = shipped_mechanism(name)
    accurate = approach(mechanism, state).coefficient
    assert accurate is not None
    assert accurate.is_finite()
    found: list[arb] = []
    with working_bits(160):
        flow = SlipFlow.of(shift(mechanism))
        numbers, by_p = SlipNumbers(flow), flow.by_p()
        run = Run(flow.desingularised(), [*slip_state(shift(mechanism), state).box, arb(0)], max_steps=26)
        caught: list[tuple[list[arb], Capture]] = []
        for segment in run:
            states = segment.after.enclosure()
            held = capture(numbers, states, None)
            if held is not None:
                caught.append((states, held))
        place = caught[-1][1].box
        for states, held in caught:
            if held.numbers.alpha_3 > held.numbers.alpha_1:
                value = coefficient_below_one(numbers, states, held, place)
            else:
                p = numbers.on(states).p
                value = coefficient_above_one(numbers, by_p, states, held, place, 8, (4 * p.upper()).max(arb(2) ** -9))
            if value is not None:
                found.append(value)
        assert len(found) >= 5
        for value in found:
            assert value.is_finite()
            assert value.overlaps(accurate)
        narrow = [value for value in found if value.rad() < abs(accurate) * arb("1e-2")]
        assert len(narrow) >= 2
        assert any(value.rad() > 10 * narrow[-1].rad() for value in found)


def test_hypotheses_that_fail() -> None:
    """Theorem 2 asks for α_3 < α_1 on the neighbourhood, and for a disc that is larger than p."""
    mechanism = shipped_mechanism("rod")
    with working_bits(120):
        flow = SlipFlow.of(shift(mechanism))
        numbers = SlipNumbers(flow)
        run = Run(flow.desingularised(), [*slip_state(shift(mechanism), STARTS[3][1]).box, arb(0)], max_steps=12)
        states = [segment.after.enclosure() for segment in run][-1]
        held = capture(numbers, states, None)
        assert held is not None
        assert coefficient_above_one(numbers, flow.by_p(), states, held, held.box, 5, arb(1) / 64) is None
        model = SlipFlow.of(shift(shipped_mechanism("model")))
        own = SlipNumbers(model)
        at = [arb(0), arb(5), arb(0), arb(0), arb(1) / 64, arb(-1) / 16]
        inside = capture(own, at, None)
        assert inside is not None
        assert coefficient_above_one(own, model.by_p(), at, inside, inside.box, 5, arb(1) / 128) is None
        assert coefficient_below_one(own, at, inside, inside.box) is None


STATES, PLACE, BOX = [arb(1)], [arb(2)], (arb(2, 3), arb(0, 1))


class Made:
    """Numbers as a test wants them: at the states (p = 1/4, b = -1/2, so λ = 2), at the place, and β's slopes."""

    def __init__(self, star: tuple[Fraction, Fraction], slopes: list[arb]) -> None:
        self.star, self.slopes = star, slopes
        self.asked: list[list[arb]] = []

    def on(self, box: Sequence[arb]) -> Numbers:
        first, third = self.star if box is PLACE else (Fraction(-7), Fraction(-7))
        return numbers_of(arb(to_fmpq(first)), arb(-9), arb(to_fmpq(third)))

    def beta_slopes(self, box: Sequence[arb]) -> list[arb]:
        self.asked.append(list(box))
        return self.slopes


def numbers_of(first: arb, second: arb, third: arb) -> Numbers:
    F, G = (arb(1, 1), arb(-3, 2)), (arb(-2, 1), arb("0.5"))
    return Numbers(arb("0.25"), arb("-0.5"), arb(5), first, second, third, F, G)


def caught(first: arb, second: arb, third: arb) -> Capture:
    """a_1 = 2, a_3 = 1/2, B = 1/8."""
    return Capture(BOX, (), numbers_of(first, second, third), arb(1), arb("0.125"), arb(2), arb("0.5"), SHOWN)


def test_theorem_a4_by_hand() -> None:
    """α_1 in [-3, -2], α_2 in [-3/2, 1/2], α_3 in [-1, -1/2], f = 5, g = 3, Λ = 1/32 + 1/64; α_1* = -9, α_3* = -9/2.

    d = 1, d' = 1 - (1/2)/2 = 3/4, A_2 = 3/2, λ_1 = 2: ω = 1/(3/4) (3/2)/2 + 3 · 3/64 (5/16 + 6 (1/8 + 3/32)).
    """
    made = Made((Fraction(-9), Fraction(-9, 2)), [arb(fmpq(1, 64), fmpq(1, 64)), arb(fmpq(-1, 128), fmpq(1, 128))])
    held = caught(arb("-2.5", "0.5"), arb("-0.5", 1), arb("-0.75", "0.25"))
    omega = Fraction(1) + Fraction(9, 64) * (Fraction(5, 16) + 6 * Fraction(7, 32))
    with working_bits(80):
        value = coefficient_below_one(cast(SlipNumbers, made), STATES, held, PLACE)
    assert value is not None
    assert made.asked == [list(BOX)]
    middle = -0.5 * 9**0.5 * 0.25**-0.5
    assert holds(value, Fraction(middle))
    assert holds(value, Fraction(middle * math.exp(-omega)))
    assert float(ends(value)[0]) == pytest.approx(middle * math.exp(omega), rel=1e-6)
    assert ends(value)[0] <= Fraction(middle * math.exp(omega) * (1 - 1e-12))


@pytest.mark.parametrize(
    ("first", "second", "third"),
    [
        (arb(-2), arb(-1), arb(-2)),  # the force does not grow
        (arb(-2), arb(-1), arb(-2, "0.1")),
        (arb(-2), arb(3), arb("-0.5")),  # d = 3/2, and α_2/λ_1 = 3/2
        (arb("nan"), arb(-1), arb(-1)),
    ],
)
def test_theorem_a4_needs_a_force_that_grows(first: arb, second: arb, third: arb) -> None:
    assert (
        coefficient_below_one(
            cast(SlipNumbers, Made((Fraction(-2), Fraction(-1)), [arb(0)])), STATES, caught(first, second, third), PLACE
        )
        is None
    )


def above(
    monkeypatch: pytest.MonkeyPatch, exponent: arb, third: arb, middle: arb | None = None
) -> tuple[arb | None, Made, list[list[arb]]]:
    """Theorem A2 with σ_1 = 2, σ_2 = 3, r = 1/16, |S| = (1/2, 1/4), Λ = (1/8, 1/2), λ̄ = 3/2 at p_1, α* = (-4, -8)."""
    regions: list[list[arb]] = []
    made = Made((Fraction(-4), Fraction(-8)), [arb("-0.125"), arb("0.5")])

    class Given:
        @staticmethod
        def on(_: VectorField, box: list[arb]) -> FlowBounds:
            regions.append(box)
            return FlowBounds(tuple(box), (arb("-0.5"), arb("0.25")), arb(2), arb(3), arb(1) / 16, exponent)

    trajectory = Distinguished((arb_poly([5, 8]), arb_poly([0])), arb_poly([1, 4]), arb(1), 3)
    monkeypatch.setattr(deviation_coefficient, "FlowBounds", Given)
    monkeypatch.setattr(deviation_coefficient, "force_at", lambda *_: arb("1.5") if middle is None else middle)
    field = cast(VectorField, None)
    held = caught(arb(-2), arb(-1), third)
    value = coefficient_above_one(cast(SlipNumbers, made), field, STATES, held, PLACE, 3, arb(1), lambda *_: trajectory)
    return value, made, regions


def test_theorem_a2_by_hand(monkeypatch: pytest.MonkeyPatch) -> None:
    """L = 1/16 + 1/8, c = 3 e^(1/2), ω = (3/16 + c/16)/4; e = 2 - 3/2 and C_1 = -4^2 e (1/4)^(-1) e^(±ω)."""
    with working_bits(80):
        value, made, ((*state, force),) = above(monkeypatch, arb(1), arb(-3))
    assert value is not None
    omega = (3 / 16 + 3 * math.exp(0.5) / 16) / 4
    assert holds(value, -32)
    assert holds(value, Fraction(-32 * math.exp(-omega)))
    assert float(ends(value)[0]) == pytest.approx(-32 * math.exp(omega), rel=1e-6)
    # D: the neighbourhood [-1, 5] × [-1, 1] with the trajectory's [5, 7] × 0, and the force between 2, 1 and [1, 2].
    assert made.asked == [state]
    for side, low, high in ((state[0], -1, 7), (state[1], -1, 1), (force, 1, 2)):
        assert holds(side, low)
        assert holds(side, high)


def test_theorem_a2_follows_the_force_to_its_goal(monkeypatch: pytest.MonkeyPatch) -> None:
    """D holds hull(λ_1, α_2/(α_3 - α_1)) = [2, 4]: α_2 = -1 and α_3 - α_1 = -1/4, so λ moves up to values next to 4."""
    with working_bits(80):
        value, _, ((*_, force),) = above(monkeypatch, arb(1), arb("-2.25"))
    assert value is not None
    assert holds(force, 2)
    assert holds(force, 4)


def test_theorem_a2_needs_its_hypotheses(monkeypatch: pytest.MonkeyPatch) -> None:
    """r c p_1 = 3 e^(1/2)/64 = 0.0773 must be less than β - 1, and α_3 less than α_1 = -2."""
    for exponent, third, there in (
        (arb("0.078"), arb(-3), True),
        (arb("0.077"), arb(-3), False),
        (arb("0.078", "0.001"), arb(-3), False),
        (arb(1), arb(-2), False),
        (arb(1), arb(-2, "0.1"), False),
        (arb(1), arb(-1), False),
    ):
        with working_bits(80):
            assert (above(monkeypatch, exponent, third)[0] is not None) is there
    with working_bits(80):
        assert above(monkeypatch, arb(1), arb(-3), arb("nan"))[0] is None
