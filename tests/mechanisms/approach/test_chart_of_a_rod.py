"""An explicit epsilon_0 for a rod with a PD wrist, on both sides of beta = 2, beside runs of equations by hand."""

from __future__ import annotations

from pathlib import Path

import pytest
from flint import arb, fmpq

from gspot_verified.functions.box_program import BoxProgram
from gspot_verified.mechanisms.approach.chart_motion import with_chart
from gspot_verified.mechanisms.approach.mechanism_side import mechanism_side
from gspot_verified.mechanisms.load import load
from gspot_verified.mechanisms.own_state.own_state import with_own_state
from gspot_verified.mechanisms.spots.g_spot import find_g_spot
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome
from tests.witnesses.stiff_contact import fate
from tests.witnesses.stiff_rod import MECHANISM, StiffRod


@pytest.fixture
def file(tmp_path: Path) -> Path:
    place = tmp_path / "rod.toml"
    place.write_text(MECHANISM, encoding="utf-8")
    return place


def test_the_equations_by_hand_are_those_of_the_mechanism(file: Path) -> None:
    """theta'' and y'' = b + p lambda."""
    shifted = find_g_spot(load(file, kd="19/10"), 128)
    system, turned = shifted.system, shifted.mechanism.state.index("th_dot")
    with working_bits(128):
        box = [arb(value) + arb("0.01") * i for i, value in enumerate(system.point)]
        F, G, p, b = BoxProgram([system.F[turned], system.G[turned], system.p, system.b], len(box)).values(box)
        angle = box[turned - 3] + (arb(9) / 10 if abs(arb(system.point[turned - 3])) < arb("0.1") else 0)
        rod, force = StiffRod(fmpq(1, 7), fmpq(19, 10)), arb("1.7")
        turning, lifting = rod.acceleration(angle, box[turned], arb(0), force)
        assert abs(turning - F - G * force) < arb("1e-30")
        assert abs(lifting - b - p * force) < arb("1e-30")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("damping", "angle", "speed", "side", "least"),
    [
        (fmpq(1), "7/10", "16/5", "lift-off", fmpq(2, 10**8)),
        (fmpq(1), "7/10", "18/5", "impact", fmpq(1, 10**8)),
        (fmpq(19, 10), "7/10", "21/10", "lift-off", fmpq(6, 10**9)),
        (fmpq(19, 10), "17/20", "2", "impact", fmpq(1, 10**8)),
    ],
)
def test_both_sides(file: Path, damping: fmpq, angle: str, speed: str, side: str, least: fmpq) -> None:
    """Runs by hand from the start that is named, with the slip that is lost, and from the state itself, at epsilon_0
    and a tenth of it."""
    rod, state = load(file, kd=damping), {"X": 0, "X_dot": 5, "th": angle, "th_dot": speed}
    found = with_own_state(with_chart(mechanism_side(rod, state), rod), rod, state)
    explicit, own = found.explicit, found.own
    assert own is not None
    assert own.verdict.outcome is Outcome.PROVED, own
    assert own.side == side
    assert own.epsilon > fmpq(1, 10**9)
    assert explicit is not None
    assert explicit.verdict.outcome is Outcome.PROVED, explicit
    assert explicit.side == side
    assert explicit.epsilon > least
    assert explicit.way is not None
    _, theta, _, rate = (value.mid() for value in explicit.way.starts.states)
    for factor in (1, 10):
        with working_bits(200):
            contact = StiffRod(explicit.epsilon / factor, damping)
            starts = [
                contact.at_rest(theta, rate),
                contact.at_rest(*(arb(fmpq(*_two(text))) for text in (angle, speed))),
            ]
        for number, start in enumerate(starts):
            found_side, last = fate(contact, start, 200)
            assert found_side == side
            if number == 0:
                assert explicit.way.lost is not None
                with working_bits(200):
                    lost, most = slip_lost(start, last, explicit.epsilon / factor), arb(explicit.way.lost)
                    assert most / 2 < lost <= most


def slip_lost(first: list[arb], last: list[arb], epsilon: fmpq) -> arb:
    """By how much u = X' - sin(theta) theta' falls: X'' = -3 lambda/2, Y'' = lambda - 1481/100, Y' = v + cos(theta)
    theta', and the time from the mean of theta' at both ends."""
    time = 2 * (last[0] - first[0]) / (first[1] + last[1])
    rise, turn = (
        [epsilon * state[3] + state[0].cos() * state[1] for state in (first, last)],
        [state[0].sin() * state[1] for state in (first, last)],
    )
    return arb(3) / 2 * (rise[1] - rise[0] + arb(1481) / 100 * time) + turn[1] - turn[0]


def _two(text: str) -> tuple[int, int]:
    above, _, below = text.partition("/")
    return int(above), int(below or 1)
