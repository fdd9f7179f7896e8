"""From a state to its fate with analytic alphas (proofs/from_state.md, section 8), beside runs of the equations."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest
from flint import arb, fmpq

from gspot_verified.expansion.from_state.affine_side import (
    AffineSide,
    _level,
    _manifold,
    _prepared,
    _tube,
    affine_side,
)
from gspot_verified.expansion.from_state.affine_system import Affine, AffineSystem
from gspot_verified.expansion.from_state.affine_tube import AffineStart, AffineTube
from gspot_verified.expansion.from_state.analytic import Analytic
from gspot_verified.expansion.from_state.fast_growth import Growth
from gspot_verified.expansion.series.regularisation import PAPER
from gspot_verified.functions.expressions import Constant, Exponential, Expression, Power, Sine, Variable
from gspot_verified.numbers.balls import ball, working_bits
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Outcome
from tests.expansion.from_state.test_affine_hand_over_of_runs import arrives
from tests.witnesses.stiff_contact import State, StiffContact, fate

P, B, Y, V = (Variable(i) for i in range(4))
Function = Callable[..., arb]
"""Of p, b, y, v."""


def rational(*value: int) -> Expression:
    return Constant(fmpq(*value))


def analytic(function: Expression, order: int = 4) -> Analytic:
    return Analytic(function, order, "f")


BENT = AffineSystem(
    analytic(rational(-1) + B + Sine(P) * B + Power(rational(1) + P, fmpq(-1, 2)) * P * P),
    analytic(rational(-2) + Exponential(B) - P * B),
    analytic(rational(-3, 2) + Sine(P) * rational(2) + B * B),
    PAPER,
)  # beta = 3/2
IRRATIONAL = replace(
    BENT, alpha_3=analytic(rational(-1) * Power(rational(2), fmpq(1, 2)) + Sine(P) * rational(2) + B * B)
)  # beta = sqrt 2
MIXED = replace(
    BENT,
    alpha_1=analytic(rational(-1, 3) * Exponential(rational(1)) + B + Power(rational(1) + P, fmpq(-1, 2)) * P * P),
    alpha_3=analytic(rational(-1) * Power(rational(5), fmpq(1, 2)) + Sine(P) * rational(2)),
)  # beta = 3 sqrt(5)/e = 2.4678...
MOVING = AffineSystem(
    analytic(rational(-1) + B + V * rational(3) + Sine(P) * B + Y),
    analytic(rational(-2) + Exponential(B + V) - P * B),
    analytic(rational(-3, 2) + Sine(P + V * rational(2)) * rational(2) - Y * rational(5) + P * V),
    PAPER,
)  # beta = 3/2
STEEP = replace(BENT, alpha_3=analytic(rational(-5, 2) * Power(rational(1) + P * B, fmpq(-1))))
TRUE: list[Function] = [
    lambda p, b, *_: -1 + b + p.sin() * b + p * p / (1 + p).sqrt(),
    lambda p, b, *_: b.exp() - 2 - p * b,
    lambda p, b, *_: 2 * p.sin() - arb(fmpq(3, 2)) + b * b,
]
TRUE_IRRATIONAL: list[Function] = [*TRUE[:2], lambda p, b, *_: 2 * p.sin() - arb(2).sqrt() + b * b]
TRUE_MIXED: list[Function] = [
    lambda p, b, *_: b - arb(1).exp() / 3 + p * p / (1 + p).sqrt(), TRUE[1], lambda p, *_: 2 * p.sin() - arb(5).sqrt(),
]  # fmt: skip
TRUE_MOVING: list[Function] = [
    lambda p, b, y, v: -1 + b + 3 * v + p.sin() * b + y,
    lambda p, b, _, v: (b + v).exp() - 2 - p * b,
    lambda p, _, y, v: 2 * (p + 2 * v).sin() - arb(fmpq(3, 2)) - 5 * y + p * v,
]
TRUE_STEEP: list[Function] = [*TRUE[:2], lambda p, b, *_: -arb(fmpq(5, 2)) / (1 + p * b)]


class TrueContact(StiffContact):
    """The equations themselves; Newton's matrix is that of their affine parts, which is near enough."""

    def __init__(self, functions: list[Function], affine: list[list[fmpq]], epsilon: fmpq) -> None:
        super().__init__(affine, epsilon)
        self._functions = functions

    def rates(self, u: State) -> State:
        p, b, y, v, z = u
        first, second, third = (function(p, b, self._epsilon**2 * y, self._epsilon * v) for function in self._functions)
        force, e = z - y, self._epsilon
        return [first, second - third * force, v / e, (b + p * force) / e, (-z - force) / e]


AFFINE_PARTS = [[fmpq(-1), fmpq(0), fmpq(1)], [fmpq(-1), fmpq(0), fmpq(1)], [fmpq(-3, 2), fmpq(2), fmpq(0)]]
AFFINE_IRRATIONAL = [*AFFINE_PARTS[:2], [fmpq(-7071, 5000), fmpq(2), fmpq(0)]]
AFFINE_MIXED = [[fmpq(-9061, 10000), fmpq(0), fmpq(1)], AFFINE_PARTS[1], [fmpq(-2236, 1000), fmpq(2), fmpq(0)]]
AFFINE_STEEP = [*AFFINE_PARTS[:2], [fmpq(-5, 2), fmpq(0), fmpq(0)]]


def place_of(system: AffineSystem, p: fmpq, excess: fmpq) -> fmpq:
    """b at p with this L."""
    return p * (AffineStart(_manifold(system, 1), p, fmpq(0), fmpq(0)).excess - excess)


def near_place(system: AffineSystem, p: fmpq, excess: fmpq) -> fmpq:
    """A rational b with an L near this one."""
    with working_bits(128):
        exact = ball(AffineStart(_manifold(system, 1), p, fmpq(0), fmpq(0)).excess)
        return p * (fmpq((exact * 10**4).floor().unique_fmpz(), 10**4) - excess)


def corners(start: AffineStart) -> list[State]:
    """At rest, and the ends of V, W, phi within the stated shares."""
    p, size = arb(start.p), abs(ball(start.excess)).mid() * start.within
    rigid, root, states = -start.b / start.p, arb(start.p).sqrt(), list[State]()
    for first, second, third in ((0, 0, 0), (1, 1, 1), (-1, 1, -1), (1, -1, -1), (-1, -1, 1)):
        speed = first * root * size / arb("0.5").sqrt()  # kappa = l = 1/2, g = 2
        force = arb(rigid) + second * size
        phi = third * root * size * arb("0.5").sqrt() / 2
        height = (phi - force - speed / 4) * 2  # phi = lambda + kappa Y + (l/g) V
        states.append([p, arb(start.b), height, speed, height + force])
    return states


@pytest.mark.slow
@pytest.mark.parametrize("excess", [fmpq(1, 2), fmpq(-1, 2)])
def test_a_run_of_the_true_equations_arrives_in_the_set(excess: fmpq) -> None:
    """Near p = 4.6 epsilon^(2/3), from a corner of the starts."""
    p, delta = fmpq(1, 100), fmpq(1, 150)
    start = AffineStart(_manifold(BENT, 1), p, place_of(BENT, p, excess), fmpq(1, 100))
    with working_bits(200):
        one = next(_prepared(start))
        tube = _tube(start, one, delta**3)
        assert isinstance(tube, AffineTube), tube
        contact = TrueContact(TRUE, AFFINE_PARTS, delta**3)
        state = contact.run(corners(start)[1], lambda u: bool(u[0] < arb("4.6") * arb(delta) ** 2))
        found = arrives(one.start, tube, delta, [*state[:4], state[4] - state[2]])
    assert found.z < arb("0.05")


def test_an_alpha_with_a_pole_on_the_way_is_refused() -> None:
    """1/(100 p - 1) is analytic up to p = 1/100 only, and b must not reach 1/40."""
    p = fmpq(1, 100)
    for alpha_3 in (
        analytic(rational(3, 2) * Power(rational(100) * P - rational(1), fmpq(-1))),
        analytic(rational(3, 2) * Power(rational(40) * B - rational(1), fmpq(-1))),
    ):
        system = AffineSystem(Affine(fmpq(-1)), Affine(fmpq(-1)), alpha_3, PAPER)
        start = AffineStart(_manifold(system, 1), p, place_of(system, p, fmpq(1)), fmpq(1, 100))
        with working_bits(128):
            one = replace(next(iter(_prepared(start))), growth=Growth(fmpq(0), fmpq(1, 10), less(0, 1), 1, ""))
            found = _tube(start, one, fmpq(1, 10**9))
        assert isinstance(found, str)
        assert found.startswith("an alpha is not certainly analytic up to p = 1/100: ")


def test_a_large_rest_is_not_decided() -> None:
    """25 10^6 p^4, which the Taylor polynomial below order 4 does not have, and does below order 5."""
    p, delta = fmpq(1, 50), fmpq(1, 200)
    steep = rational(-1) + rational(25 * 10**6) * P * P * P * P
    for order, decided in ((4, False), (5, True)):
        system = AffineSystem(Affine(fmpq(-1)), analytic(steep, order), Affine(fmpq(-3, 2)), PAPER)
        start = AffineStart(_manifold(system, 1), p, place_of(system, p, fmpq(1)), fmpq(1, 100))
        with working_bits(128):
            assert isinstance(_tube(start, next(_prepared(start)), delta**3), AffineTube) is decided


def test_residuals_are_bounded_for_a_delta_near_the_range() -> None:
    affine = AffineSystem(Affine(fmpq(-1)), Affine(fmpq(-1)), Affine(fmpq(-3, 2)), PAPER)
    for most, level in ((fmpq(1, 8), 8), (fmpq(1, 63), 8), (fmpq(1, 64), 64), (fmpq(1, 511), 64), (fmpq(1, 600), 512)):
        assert _level(BENT, most) == fmpq(1, level)
        assert _level(affine, most) == fmpq(1, 8)
        assert _level(replace(affine, alpha_2=BENT.alpha_2), most) == fmpq(1, level)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("system", "p", "excess", "side", "least"),
    [
        (BENT, fmpq(1, 100), fmpq(1, 2), "lift-off", fmpq(1, 4 * 10**6)),
        (BENT, fmpq(1, 100), fmpq(-1, 2), "impact", fmpq(1, 4 * 10**6)),
        (STEEP, fmpq(1, 50), fmpq(1, 3), "impact", fmpq(1, 2 * 10**6)),
    ],
)
def test_the_side_is_that_of_runs_of_the_true_equations(
    system: AffineSystem, p: fmpq, excess: fmpq, side: str, least: fmpq
) -> None:
    found = affine_side(system, p, place_of(system, p, excess))
    assert found.verdict.outcome is Outcome.PROVED, found
    assert found.start.excess == excess
    assert found.side == side
    assert found.epsilon > least
    functions, affine = (TRUE, AFFINE_PARTS) if system is BENT else (TRUE_STEEP, AFFINE_STEEP)
    runs_end(found, functions, affine)


def runs_end(found: AffineSide, functions: list[Function], affine: list[list[fmpq]]) -> None:
    """Runs of the true equations from corners of the starts, at three epsilon."""
    for factor in (1, 2, 10):
        for start in corners(found.start)[:: 1 if factor == 1 else 2]:
            ended, last = fate(TrueContact(functions, affine, found.epsilon / factor), start, 20)
            assert ended == found.side
            assert last[0] < 0


@pytest.mark.slow
@pytest.mark.parametrize(
    ("system", "p", "excess", "side", "least", "functions", "affine"),
    [
        (IRRATIONAL, fmpq(1, 100), fmpq(1, 2), "lift-off", fmpq(1, 4 * 10**6), TRUE_IRRATIONAL, AFFINE_IRRATIONAL),
        (IRRATIONAL, fmpq(1, 100), fmpq(-1, 2), "impact", fmpq(1, 4 * 10**6), TRUE_IRRATIONAL, AFFINE_IRRATIONAL),
        (MIXED, fmpq(1, 50), fmpq(1, 3), "impact", fmpq(1, 2 * 10**6), TRUE_MIXED, AFFINE_MIXED),
        (MOVING, fmpq(1, 100), fmpq(1, 2), "lift-off", fmpq(1, 4 * 10**6), TRUE_MOVING, AFFINE_PARTS),
        (MOVING, fmpq(1, 100), fmpq(-1, 2), "impact", fmpq(1, 4 * 10**6), TRUE_MOVING, AFFINE_PARTS),
    ],
)
def test_other_systems_have_the_side_of_runs(
    system: AffineSystem,
    p: fmpq,
    excess: fmpq,
    side: str,
    least: fmpq,
    functions: list[Function],
    affine: list[list[fmpq]],
) -> None:
    found = affine_side(system, p, near_place(system, p, excess))
    assert found.verdict.outcome is Outcome.PROVED, found
    assert found.side == side
    assert found.epsilon > least
    runs_end(found, functions, affine)


def test_a_rational_system_has_the_same_tube_in_balls() -> None:
    """sqrt(2)^2 in the place of 2."""
    root = Power(rational(2), fmpq(1, 2))
    same = replace(BENT, alpha_3=analytic(rational(-3, 2) + root * root * Sine(P) + B * B))
    p, delta, tubes = fmpq(1, 100), fmpq(1, 150), list[AffineTube]()
    assert (BENT.is_exact, same.is_exact) == (True, False)
    for system in (BENT, same):
        start = AffineStart(_manifold(system, 1), p, place_of(BENT, p, fmpq(1, 2)), fmpq(1, 100))
        with working_bits(128):
            tube = _tube(start, next(_prepared(start)), delta**3)
        assert isinstance(tube, AffineTube), tube
        tubes.append(tube)
    exact, balls = tubes
    assert exact.barrier.keys() <= balls.barrier.keys()
    with working_bits(128):
        for key, value in balls.barrier.items():
            assert abs(value - exact.barrier.get(key, arb(0))) < (1 + value) * arb("1e-12")
        assert abs(balls.drift - exact.drift) < arb("1e-12")
