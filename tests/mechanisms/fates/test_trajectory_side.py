"""The sign of C_1 of a set of states, where b + 2 p is the deviation exactly (proofs/fates.md, Theorem F2)."""

from __future__ import annotations

from dataclasses import replace

import pytest
from flint import arb, arb_mat

from gspot_verified.integrator.box_steps.error_set import ErrorSet
from gspot_verified.mechanisms.approach.capture import capture
from gspot_verified.mechanisms.approach.distinguished import FlowBounds
from gspot_verified.mechanisms.fates.trajectory_side import TrajectorySide, trajectory_side
from gspot_verified.numbers.balls import working_bits

from .test_parts import BITS, model

TURNED = ((1.0, 2.0), (-3.0, 0.5))
UNIT = ((1.0, 0.0), (0.0, 1.0))


def sign_of_set(
    side: TrajectorySide, middle: tuple[arb, arb], *, initial: tuple[float, float] = (0, 0),
    errors: tuple[float, float] = (0, 0), C: tuple[tuple[float, float], ...] = TURNED,
    Q: tuple[tuple[float, float], ...] = TURNED,
) -> int | None:  # fmt: skip
    plane, _ = model()
    radii = [arb_mat([[arb(0, r)] for r in sizes]) for sizes in (initial, errors)]
    states = ErrorSet(middle, arb_mat([list(row) for row in C]), radii[0], arb_mat([list(row) for row in Q]), radii[1])
    neighbourhood = capture(plane, [*states.enclosure(), arb(0)], None)
    found = None if neighbourhood is None else side.sign(states, neighbourhood)
    return None if found is None else found[0]


@pytest.mark.parametrize("which", ["initial", "errors"])
@pytest.mark.parametrize("column", [0, 1])
@pytest.mark.parametrize("sign", [1, -1])
def test_the_sign_is_certain_just_where_no_state_is_on_the_trajectory(which: str, column: int, sign: int) -> None:
    """The set m + C r or m + Q e, one coordinate of size s: b + 2 p moves by |2 C_1j + C_2j| s."""
    _, side = model()
    with working_bits(BITS):
        p = side.last / 4
        size = float(p) / 2**8
        reach = abs(2 * TURNED[0][column] + TURNED[1][column]) * size
        sizes = (size, 0.0) if column == 0 else (0.0, size)
        for factor, expected in ((1.02, sign), (0.98, None)):
            middle = (p, (-2 * p + sign * factor * reach).mid())
            found = sign_of_set(side, middle, **{which: sizes})  # type: ignore[arg-type]
            assert found == expected, (which, column, factor)


def test_every_state_must_have_a_p_up_to_the_last() -> None:
    _, known = model()
    with working_bits(BITS):
        side = replace(known, region=(arb(0, 1), arb(0, 1), known.region[-1]))  # far from its edge
        for below, size, expected in ((2.0**-7, 2.0**-8, 1), (2.0**-8, 2.0**-7, None), (2.0**-8, 2.0**-9, 1)):
            p = (side.last * (1 - below)).mid()
            middle = (p, (-p).mid())
            assert sign_of_set(side, middle, initial=(float(side.last) * size, 0), C=UNIT) == expected


def test_every_state_must_lie_in_the_region() -> None:
    """Its force -b/p, and the box in which it stays until the G-spot."""
    _, side = model()
    with working_bits(BITS):
        p = side.last / 4
        middle = (p, (-p).mid())  # the force is 1, that of the trajectory 2
        *sides, _ = side.region
        assert sign_of_set(side, middle) == 1
        assert sign_of_set(replace(side, region=(*sides, arb(2, "0.99"))), middle) is None
        assert sign_of_set(replace(side, region=(arb(0, float(p) / 2), *side.region[1:])), middle) is None


def test_the_rest_of_the_trajectory_counts() -> None:
    _, side = model()
    with working_bits(BITS):
        p = side.last / 4
        middle = (p, (-2 * p + p / 8).mid())
        power = p ** (side.order + 2)
        for share, expected in (("0.99", 1), ("1.01", None)):
            assert sign_of_set(replace(side, rest=arb(share) * (p / 8) / power), middle) == expected


@pytest.mark.parametrize(("share", "holds"), [("0.999", True), ("1.001", False)])
def test_how_far_slip_can_be_compared(monkeypatch: pytest.MonkeyPatch, share: str, holds: bool) -> None:
    """(D4): r σ_2 e^(σ_1 P) P < β_- - 1, here with σ_1 P = log 2 and σ_2 = 1."""
    plane, known = model()
    with working_bits(BITS):
        honest = FlowBounds.on(plane.flow.by_p(), known.region)
        assert honest is not None
        largest = arb(share) * honest.exponent.lower() / (2 * known.last)
        bounds = replace(honest, S_state=arb(2).log() / known.last, S_force=arb(1), R_state=largest)
        monkeypatch.setattr(FlowBounds, "on", lambda *_: bounds)
        place = [arb(0), arb(0)]
        side = trajectory_side(plane.flow, place, known.region, known.order, known.last, 4 * known.last, plane.p_and_b)
        assert (side is not None) is holds
