"""The set that is handed over with affine alphas (proofs/from_state.md, section 8), beside its definitions."""

from __future__ import annotations

import pytest
from flint import arb, arb_mat, fmpq

from gspot_verified.expansion.from_state.affine_hand_over import affine_hand_over
from gspot_verified.expansion.from_state.affine_tube import AffineStart, AffineTube
from gspot_verified.expansion.from_state.hand_over import HandOver
from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.numbers.balls import ball, working_bits
from tests.expansion.from_state.test_affine_side import place_of, run_to, tube_at


def deviations(equations: DeviationEquations, beta: fmpq, s: fmpq, state: list[arb]) -> tuple[list[arb], arb]:
    """e and phi over delta^mu of (p, b, Y, V, lambda_N) at s, by the definitions of uniform.md."""
    p, b, y, v, force = state
    delta = equations.delta
    scaled = [p / delta**2, b / delta**2, delta**4 * y, delta * v, p / delta**2, b / delta**2, y, v / delta, force]
    names = ("xi_1", "xi_2", "xi_3", "xi_4", "p", "b", "y", "v", "lambda_n")
    unit = delta ** ball(2 - 2 * beta)
    off = [(value - equations.expansion(name, ball(s))) * unit for value, name in zip(scaled, names, strict=True)]
    return off[:8], off[8] + equations.kappa * off[6] + equations.share * delta * off[7]


def coordinates(found: HandOver, e: list[arb]) -> list[arb]:
    """How far each coordinate lies from the centre."""
    u = (found.frame.inv() * arb_mat([[value] for value in e])).entries()
    return [abs(value - centre) for value, centre in zip(u, found.centre, strict=True)]


def arrives(given: AffineStart, tube: AffineTube, delta: fmpq, state: list[arb]) -> HandOver:
    """The set of the tube at the s where p~ is that of the state, (p, b, Y, V, lambda_N), which lies in it."""
    system, p = given.manifold.system, state[0]
    equations = DeviationEquations(expand_system(system.system(), 10), delta, delta)
    s = -p / equations.delta**2
    for _ in range(9):  # p = delta^2 p~ at s, where p~ = -s + ...
        s = (s + equations.expansion("p", s) - p / equations.delta**2).mid()
    place = -fmpq(int((s * 2**150).floor().unique_fmpz()), 2**150)
    found = affine_hand_over(equations, given, tube, place)
    assert isinstance(found, HandOver), found
    off, phi = deviations(equations, system.beta, -place, state)
    distances = coordinates(found, off)
    for distance, radius in zip(distances, found.radii, strict=True):
        assert distance <= radius + arb("1e-30")
    assert abs(phi) < found.fast
    assert found.radii[equations.b] < arb("0.05")
    return found


@pytest.mark.parametrize("excess", [fmpq(1, 2), fmpq(-1, 2)])
@pytest.mark.parametrize("delta", [fmpq(1, 150), fmpq(1, 2000)])
def test_a_run_arrives_in_the_set(delta: fmpq, excess: fmpq) -> None:
    with working_bits(200):
        given, tube = tube_at(delta, excess)
        p, b, y, v, z = run_to(delta, excess)
        arrives(given, tube, delta, [p, b, y, v, z - y])
    assert place_of(excess) == given.b
