"""The desingularised slip flow keeps what it must keep, at random points.

Page: proofs/approach.md, section 1.
"""

from __future__ import annotations

import random
from collections.abc import Sequence

import pytest
from flint import arb

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.mechanisms.approach.slip_flow import SlipFlow, SlipNumbers
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.numbers.balls import working_bits


@pytest.mark.parametrize("name", ["model", "extended", "oscillator", "rod"])
def test_derivatives_along_the_flow(name: str) -> None:
    """y' = p v, v' = 0, p' = α_1 p, b' = α_2 p + α_3 b, by the chain rule with gradients in balls; t' = p."""
    chance = random.Random(name)
    with working_bits(200):
        flow = SlipFlow.of(shift(shipped_mechanism(name)))
        field, numbers = flow.desingularised(), SlipNumbers(flow)
        scalars = BoxProgram([flow.y, flow.v, flow.p, flow.b], flow.dimension)
        assert field.dimension == flow.dimension + 1
        for _ in range(5):
            point = [arb(chance.randint(-40, 40)) / 100 for _ in range(flow.dimension)]
            velocity = field.on_box([*point, arb(0)])[0]
            values, rows = scalars.gradients(point)
            at = numbers.on(point)
            expected = (
                at.p * values[1],
                arb(0),
                at.alpha_1 * at.p,
                at.alpha_2 * at.p + at.alpha_3 * at.b,
            )
            for row, want in zip(rows, expected, strict=True):
                found = sum((a * b for a, b in zip(row, velocity, strict=False)), arb(0))
                assert found.is_finite()
                assert want.is_finite()
                assert (found - want).contains(0)
                assert (found - want).rad() < 1e-40
            assert (velocity[-1] - at.p).contains(0)


@pytest.mark.parametrize("name", ["extended", "oscillator", "rod"])
def test_by_p_is_the_same_flow(name: str) -> None:
    """(S, R) against the flow in s: dξ/dp = (dξ/ds)/(α_1 p), and dλ/ds = -α_2 + (α_3 - α_1) λ with λ = -b/p."""
    chance = random.Random(name)
    with working_bits(200):
        flow = SlipFlow.of(shift(shipped_mechanism(name)))
        numbers = SlipNumbers(flow)
        for _ in range(5):
            point = [arb(chance.randint(1, 40)) / 100 for _ in range(flow.dimension)]
            at = numbers.on(point)
            velocity = flow.desingularised().on_box([*point, arb(0)])[0]
            S_and_R = flow.by_p().on_box([*point, at.force])[0]
            for found, speed in zip(S_and_R, velocity[:-1], strict=False):
                assert (found - speed / (at.alpha_1 * at.p)).contains(0)
                assert found.is_finite()
            change = -at.alpha_2 + (at.alpha_3 - at.alpha_1) * at.force
            assert (S_and_R[-1] - change / at.alpha_1).contains(0)
            assert S_and_R[-1].is_finite()


def same(found: Sequence[arb], own: Sequence[arb]) -> None:
    for one, other in zip(found, own, strict=True):
        assert one.overlaps(other)
        assert one.rad() < 1e-20
        assert other.rad() < 1e-20


def test_what_the_numbers_are_called() -> None:
    """Each against the function of its name, and the gradients of p, b, y, v."""
    with working_bits(100):
        flow = SlipFlow.of(shift(shipped_mechanism("oscillator")))
        numbers, size = SlipNumbers(flow), flow.dimension
        point = [arb(k + 1) / 10 for k in range(size)]
        at = numbers.on([*point, arb("nan")])
        names = ("p", "b", "u", "alpha_1", "alpha_2", "alpha_3")
        functions = [*flow.F, *flow.G, *(getattr(flow, name) for name in names)]
        same([*at.F, *at.G, *(getattr(at, name) for name in names)], BoxProgram(functions, size).values(point))
        assert len(at.F) == len(at.G) == size
        conditions = BoxProgram([flow.p, flow.b, flow.y, flow.v], size)
        same(numbers.conditions(point), conditions.values(point))
        for row, own in zip(numbers.condition_rows(point), conditions.gradients(point)[1], strict=True):
            same(row, own)
        same(numbers.beta_slopes(point), BoxProgram([flow.alpha_3 / flow.alpha_1], size).gradients(point)[1][0])
        assert (at.force * at.p + at.b).contains(0)
