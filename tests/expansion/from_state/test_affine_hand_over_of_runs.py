"""The set that is handed over with affine alphas (proofs/from_state.md, section 8), beside its definitions."""

from __future__ import annotations

import pytest
from flint import arb, arb_mat, fmpq

from gspot_verified.expansion.from_state.affine_hand_over import affine_hand_over
from gspot_verified.expansion.from_state.affine_system import AffineSystem
from gspot_verified.expansion.from_state.affine_tube import AffineStart, AffineTube
from gspot_verified.expansion.from_state.barrier import Start
from gspot_verified.expansion.from_state.fast_growth import Rectangle
from gspot_verified.expansion.from_state.hand_over import HandOver, evaluated
from gspot_verified.expansion.from_state.slow_series import Contact, slow_series
from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.numbers.balls import ball, working_bits
from gspot_verified.numbers.evidence import less
from tests.expansion.from_state.test_affine_side import P, place_of, run_to, tube_at
from tests.expansion.from_state.test_affine_system import BENT, EXTENDED

DELTA, FAR = fmpq(1, 20000), fmpq(4)


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


@pytest.mark.parametrize("system", [EXTENDED, BENT])
@pytest.mark.parametrize("excess", [fmpq(1, 10**6), fmpq(-1, 2)])
def test_a_state_without_a_fast_part_lies_at_the_end_of_the_set(system: AffineSystem, excess: fmpq) -> None:
    """z = 0: b, y, v, phi are those of the slow series beside the reference; what is left is what the reference
    differs by from Theorem 1, which decides alone for a small L."""
    delta = fmpq(1, 100)
    with working_bits(200):
        equations = DeviationEquations(expand_system(system.system(), 10), delta, delta)
        given = AffineStart(system, fmpq(1, 50), -fmpq(1, 50) * (system.mean_force + system.tilt / 50 + excess), P)
        series, e = slow_series(system.beta, Contact.of(system.regularisation), 4, system.slopes), system.a * delta**3
        start = Start(given.p, e, arb(0), 1, fmpq(0))
        thin, evidence = Rectangle(fmpq(1), fmpq(1)), less(0, 1)
        assert evidence is not None
        tube = AffineTube(start, thin, {}, arb(1), arb(1), (arb(1), arb(1), arb(1)), arb(0), evidence)
        found = affine_hand_over(equations, given, tube, series, FAR)
        assert isinstance(found, HandOver), found
        p = (equations.expansion("p", ball(-FAR)) * equations.delta**2).mid()
        root = p.sqrt()
        h = ball(e) / (p * root)
        L = -found.coefficient.mid() * p ** ball(system.beta - 1)
        v, w, f = (evaluated(one, h, root) for one in (series.v, series.w, series.f))
        rigid = system.mean_force + system.tilt * p + L
        contact = series.contact
        force, moving, fast = rigid + L * w, ball(e) * system.tilt / contact.kappa + L * v, L * p * f
        height = (fast - force - contact.lag / contact.rate * moving) / contact.kappa
        off, phi = deviations(equations, system.beta, -FAR, [p, -p * rigid, height, moving, force])
        for i, (distance, radius) in enumerate(zip(coordinates(found, off), found.radii, strict=True)):
            assert distance <= radius * arb("1.0001") + arb("1e-40")
            # in y and v parts of the reference cancel, whose sizes are added
            assert i in (equations.y, equations.v) or radius <= distance * arb("1.1") + arb("1e-40")
        assert abs(phi) < found.fast * arb("1.0001")
        assert found.fast < 2 * abs(phi)


@pytest.mark.parametrize("excess", [fmpq(1, 2), fmpq(-1, 2)])
def test_a_run_arrives_in_the_set(excess: fmpq) -> None:
    with working_bits(200):
        given, tube = tube_at(DELTA, excess)
        p, b, y, v, z = run_to(DELTA, excess)
        equations = DeviationEquations(expand_system(EXTENDED.system(), 10), DELTA, DELTA)
        s = -p / equations.delta**2
        for _ in range(9):  # p = delta^2 p~ at s, where p~ = -s + ...
            s = (s + equations.expansion("p", s) - p / equations.delta**2).mid()
        place = -fmpq(int((s * 2**150).floor().unique_fmpz()), 2**150)
        series = slow_series(EXTENDED.beta, Contact.of(EXTENDED.regularisation), 4, EXTENDED.slopes)
        found = affine_hand_over(equations, given, tube, series, place)
        assert isinstance(found, HandOver), found
        off, phi = deviations(equations, EXTENDED.beta, -place, [p, b, y, v, z - y])
        distances = coordinates(found, off)
        for distance, radius in zip(distances, found.radii, strict=True):
            assert distance <= radius + arb("1e-30")
        assert abs(phi) < found.fast
        assert found.radii[equations.b] < arb("0.5")
    assert place_of(excess) == given.b
