"""Theorem O (proofs/from_own_state.md) beside float runs of the model system in contact, by another method."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest
from flint import arb, fmpq

from gspot_verified.expansion.from_state.slow_series import Contact
from gspot_verified.functions.expressions import Constant, Variable
from gspot_verified.mechanisms.approach.slip_flow import ClosedFlow, SlipFlow
from gspot_verified.mechanisms.approach.slip_state import slip_state
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.load import load
from gspot_verified.mechanisms.own_state.compliant_tube import (
    CompliantEquations,
    CompliantTube,
    OwnStarts,
    _Fast,
    _fast,
    _moved,
    _place,
    _Reached,
    compliant_tube,
)
from gspot_verified.mechanisms.own_state.fast_norm import FastNorm
from gspot_verified.mechanisms.own_state.rigid_way import WayPart, rigid_way
from gspot_verified.numbers.balls import approximate, working_bits
from gspot_verified.numbers.evidence import less

DIRECTIONS = [(0.3, 0.0, 1.0), (1.9, 0.2, -1.0), (3.4, -0.4, 0.0), (5.0, 1.2, 1.0), (0.0, 1.5707, -1.0)]
STARTS, EPSILON = OwnStarts(fmpq(1), fmpq(1, 4)), fmpq(1, 2000)
FIRST, LAST = 0.5, 0.25  # p
WEIGHT = fmpq(1)
SHOWN = less(0, 1)
assert SHOWN is not None
BITS = 208


@cache
def known() -> tuple[SlipFlow, tuple[arb, ...], list[WayPart]]:
    """Slip of the model system from p = 1/2, b = -2 to p = 1/4."""
    with working_bits(BITS):
        shifted = shift(load("model system"))
        flow = SlipFlow.of(shifted)
        start = slip_state(shifted, {"x": 0, "u": 3, "p": "1/2", "b": "-2"}).box
        way = rigid_way(flow, start, arb("0.25", "0.01"), 100)
        assert way is not None
        return flow, start, way


def tube(
    epsilon: fmpq = EPSILON, starts: OwnStarts = STARTS, way: list[WayPart] | None = None, weight: fmpq = WEIGHT
) -> CompliantTube | str:
    flow, start, parts = known()
    contact = Contact.of(load("model system").regularisation)
    with working_bits(BITS):
        return compliant_tube(
            CompliantEquations(flow), FastNorm(contact, weight), start, parts if way is None else way, starts, epsilon
        )


@cache
def run(epsilon: float, end: float, start: tuple[float, ...]) -> np.ndarray[Any, np.dtype[np.float64]]:
    """(b, y/epsilon^2, v/epsilon, z/epsilon^2, x, u) at the time ``end``; p falls by 1 in a unit of time."""
    from scipy.integrate import solve_ivp

    def rates(time: float, state: Any) -> list[float]:
        b, Y, V, Z, _, u = state
        force = Z - Y
        return [
            -1 + 1.5 * force,
            V / epsilon,
            (b + (start[-1] - time) * force) / epsilon,
            (-Z - force) / epsilon,
            u,
            -force,
        ]

    found = solve_ivp(rates, (0, end), start[:-1], method="DOP853", rtol=1e-10, atol=1e-13)
    return np.asarray(found.y[:, -1])


def start_at(angle: float, turn: float, off: float, share: float) -> tuple[float, ...]:
    """A start with |X| = ``share`` |b| in the direction of the two angles, each component off by ``off``."""
    p, b = FIRST + off, -2 + off
    size = -b * share
    V = size * math.cos(angle) * math.cos(turn) / math.sqrt(p / 2)
    W, phi = size * math.sin(angle) * math.cos(turn), size * math.sin(turn) / (2 * math.sqrt(2 * p))
    force = (W - b) / p
    Y = 2 * (phi - force - V / 4)
    return b, Y, V, Y + force, off, 3 - off, p


NAMES = ("x", "u", "p", "b", "-b/p", "fast", "y", "v")


def used(found: CompliantTube, share: float, angle: float, turn: float, off: float, parts: int) -> dict[str, float]:
    """Which part of its bound each number has at the end of a run."""
    end, epsilon = approximate(known()[2][parts - 1].until), approximate(found.epsilon)
    first = start_at(angle, turn, off * epsilon * 0.999, share)
    b, Y, V, Z, x, u = run(epsilon, end, first)
    p, force = first[-1] - end, Z - Y
    own = x, u, p, b, -b / p, epsilon**2 * Y, epsilon * V
    fast = max(abs(math.sqrt(p / 2) * V), abs(b + p * force), abs(2 * math.sqrt(2 * p) * (force + Y / 2 + V / 4)))
    places, states = found.place, found.states
    balls = states[0], states[1], states[4], states[5], found.force, places[2], places[3]
    shares = [
        abs(one - approximate(ball.mid())) / approximate(ball.rad()) for one, ball in zip(own, balls, strict=True)
    ]
    return dict(zip(NAMES, [*shares[:5], fast / approximate(found.fast), *shares[5:]], strict=True))


@pytest.mark.parametrize(("angle", "turn", "off"), [(0.3, 0.0, 1), (1.9, 0.2, -1), (5.0, 1.2, 1), (0.0, 1.5707, -1)])
def test_runs_of_the_compliant_model_lie_in_the_tube(angle: float, turn: float, off: int) -> None:
    _, _, way = known()
    for parts in (2, len(way)):
        found = tube(way=way[:parts])
        assert isinstance(found, CompliantTube)
        shares = used(found, 0.25, angle, turn, off, parts)
        assert max(shares.values()) < 1, shares
        assert shares["x"] > 0.35
        assert shares["p"] > 0.99
        assert shares["-b/p"] > 0.1


def test_the_fast_part_falls_from_what_it_was() -> None:
    """After the first part of the way the largest share of the bound that a run needs is not small."""
    found = tube(way=known()[2][:1])
    assert isinstance(found, CompliantTube)
    assert max(used(found, 0.25, angle, turn, 0, 1)["fast"] for angle, turn, _ in DIRECTIONS) > 0.3


@pytest.mark.parametrize("off", [1, -1])
def test_without_a_fast_part_the_bounds_are_sharp(off: int) -> None:
    found = tube(starts=OwnStarts(fmpq(1), fmpq(1, 10**6)))
    assert isinstance(found, CompliantTube)
    shares = used(found, 1e-6, 0.0, 0.0, off, len(known()[2]))
    assert max(shares.values()) < 1, shares
    assert all(
        shares[name] > least
        for name, least in {"x": 0.6, "u": 0.25, "p": 0.99, "b": 0.4, "-b/p": 0.6, "fast": 0.7}.items()
    )


def test_a_smaller_epsilon_has_smaller_bounds() -> None:
    large, small = tube(), tube(EPSILON / 10)
    assert isinstance(large, CompliantTube)
    assert isinstance(small, CompliantTube)
    assert small.fast < large.fast
    assert all(one.rad() < other.rad() / 5 for one, other in zip(small.states[:2], large.states[:2], strict=True))
    for one, other in zip(small.boxes, large.boxes, strict=True):
        assert all(map(arb.contains, other, one))


def test_every_state_of_the_way_lies_in_the_boxes() -> None:
    found = tube()
    assert isinstance(found, CompliantTube)
    for part, box in zip(known()[2], found.boxes, strict=True):
        assert all(map(arb.contains_interior, box, part.states))


@pytest.mark.parametrize(
    ("changes", "why"),
    [
        ({"epsilon": fmpq(1, 50)}, "epsilon times the growth"),
        ({"starts": OwnStarts(fmpq(1), fmpq(1))}, "contact: |b + p lambda| <= "),
        ({"starts": OwnStarts(fmpq(1000), fmpq(1, 4))}, "the norm of the fast part does not certainly fall at p = "),
        ({"starts": OwnStarts(fmpq(500), fmpq(1, 4))}, "not certain"),
        ({"weight": fmpq(8)}, "the norm of the fast part does not certainly fall at p = "),
    ],
)
def test_what_is_not_certain_is_told(changes: dict[str, Any], why: str) -> None:
    found = tube(**changes)
    assert isinstance(found, str)
    assert why in found


@pytest.mark.parametrize(
    "changes",
    [{"states": (arb("nan"),) * 6}, {"duration": arb(-1)}, {"duration": arb(0, 1)}],
)
def test_a_part_that_says_too_little_is_refused(changes: dict[str, Any]) -> None:
    first, *others = known()[2]
    assert isinstance(tube(way=[replace(first, **changes), *others]), str)


def test_the_largest_share_is_nearly_reached() -> None:
    """With a share of 0.7 of |b| contact is shown, with 0.72 it is not: the norm is not the Euclidean one."""
    assert isinstance(tube(starts=OwnStarts(fmpq(1), fmpq(7, 10))), CompliantTube)
    assert isinstance(tube(starts=OwnStarts(fmpq(1), fmpq(18, 25))), str)


@pytest.mark.parametrize(
    "changes",
    [
        {"epsilon": fmpq(0)},
        {"starts": OwnStarts(fmpq(0), fmpq(1, 4))},
        {"starts": OwnStarts(fmpq(1), fmpq(-1, 4))},
        {"way": []},
    ],
)
def test_arguments_that_mean_nothing(changes: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match="must be positive"):
        tube(**changes)


POINT = (0.25, 3.0, 0.0, 0.0, 0.5, -2.0, 0.5, 4.0)  # x, u, y, v, p, b; p and Lambda beside them


def rates_of(x: np.ndarray[Any, np.dtype[np.float64]]) -> np.ndarray[Any, np.dtype[np.float64]]:
    _, u, _, v, p, b, beside, force = x
    rho = -1 + (-1 + 1.5) * force
    return np.array([u, -force, v, b + p * force, -1, -1 + 1.5 * force, -1, -rho / beside])


def kick_of(x: np.ndarray[Any, np.dtype[np.float64]]) -> np.ndarray[Any, np.dtype[np.float64]]:
    p, beside = x[4], x[6]
    return np.array([0, -1 / beside, 0, p / beside, 0, 1.5 / beside, 0, -1.5 / beside**2])


def slopes_of(function: Any, x: np.ndarray[Any, np.dtype[np.float64]]) -> np.ndarray[Any, np.dtype[np.float64]]:
    steps = np.eye(8) * 1e-5
    return np.array([(function(x + step) - function(x - step)) / 2e-5 for step in steps]).T


def test_the_numbers_of_a_part_are_those_of_the_page() -> None:
    """At a point, all terms of one size, by finite differences of equations by hand."""
    x, epsilon, time = np.array(POINT), 1e-4, 0.02
    first, decayed, driven, eta = 0.3, 1e-4, 2e7, np.arange(1, 9) * 1e-3
    tilt, kappa, p = math.sqrt(0.5 / 32 + 0.5 / 8), 0.5, 0.5
    rate, c = p / 4 / 10, 1 / math.sqrt(1 - tilt)
    left = first * math.exp(-decayed / epsilon)
    largest = c * (left + epsilon**2 * driven)
    after = decayed + rate * time
    last = c * (first * math.exp(-after / epsilon) + epsilon**2 * driven)
    psi, root = 2.0, math.sqrt(kappa * p)  # rho/p = (-1 + 2)/(1/2)
    still = epsilon**2 * psi / kappa
    J, k, turn = slopes_of(rates_of, x), kick_of(x), slopes_of(kick_of, x)
    with working_bits(BITS):
        flow, _, _ = known()
        equations, norm = CompliantEquations(flow), FastNorm(Contact.of(load("model system").regularisation), WEIGHT)
        box = [arb(one) for one in POINT]
        before = _Reached([arb(one) for one in eta], [], arb(first), arb(decayed), arb(driven), arb(0), SHOWN)
        fast = _fast(equations, norm, box, before, arb(time), arb(epsilon))
        assert isinstance(fast, _Fast)
        end, ends, whole = _moved(equations, box, before, fast, arb(time))
        drive = _fast(equations, norm, box, replace(before, driven=arb(0)), arb(time), arb(epsilon))
        assert isinstance(drive, _Fast)
    travelled = epsilon / root * c * (left * min(epsilon / rate, time) + epsilon**2 * driven * time) + still * time
    for one, wanted in (
        (fast.push, largest),
        (fast.last, last),
        (fast.decayed, after),
        (fast.driven, driven),
        (fast.speed, epsilon / root * largest + still),
        (fast.last_speed, epsilon / root * last + still),
        (fast.travelled, travelled),
        (drive.driven, math.sqrt(p / kappa) * abs(-J[-1] @ rates_of(x)) / rate),
    ):
        assert approximate(one) == pytest.approx(wanted, rel=1e-6)
    N = np.abs(J)
    np.fill_diagonal(N, np.diag(J))
    drift = np.abs(J @ k - turn @ rates_of(x)) + largest * np.abs(turn @ k)
    grown, upwards = exponential(N * time), exponential(np.maximum(N, 0) * time)
    moved, most = grown @ eta + upwards @ (drift * travelled), upwards @ (eta + drift * travelled)
    for ours, theirs in (
        (end, moved),
        (ends, moved + np.abs(k) * approximate(fast.last_speed)),
        (whole, most + np.abs(k) * approximate(fast.speed)),
    ):
        assert [approximate(one) for one in ours] == pytest.approx(list(theirs), rel=1e-6)


def exponential(matrix: np.ndarray[Any, np.dtype[np.float64]]) -> np.ndarray[Any, np.dtype[np.float64]]:
    from scipy.linalg import expm

    return np.asarray(expm(matrix))


@pytest.mark.parametrize(("factor", "passed"), [(0.999, True), (1.001, False)])
def test_the_decay_must_exceed_the_growth(factor: float, passed: bool) -> None:
    """epsilon times gamma of the page, at a point, beside the rate."""
    tilt, p, kappa, rate = math.sqrt(0.5 / 32 + 0.5 / 8), 0.5, 0.5, 0.5 / 4 / 10
    x = np.array(POINT)
    turn = abs(slopes_of(rates_of, x)[-1] @ kick_of(x)) * p / math.sqrt(kappa * p)
    still, more = ((1 + tilt) * max(1.0, 1.0) + tilt / (4 * p)) / (1 - tilt), (1 + tilt) * turn / (1 - tilt)
    epsilon = (-still + math.sqrt(still**2 + 4 * more * rate)) / (2 * more) * factor
    with working_bits(BITS):
        flow, _, _ = known()
        before = _Reached([], [], arb("1e-9"), arb(0), arb(0), arb(0), SHOWN)
        norm = FastNorm(Contact.of(load("model system").regularisation), WEIGHT)
        found = _fast(CompliantEquations(flow), norm, [arb(one) for one in POINT], before, arb("1e-9"), arb(epsilon))
    assert isinstance(found, _Fast) == passed, found


def test_a_duration_in_a_ball_is_the_longest_of_it() -> None:
    """The integral of |v|, where it is the duration that bounds it."""
    with working_bits(BITS):
        flow, _, _ = known()
        norm, epsilon = FastNorm(Contact.of(load("model system").regularisation), WEIGHT), arb("1e-4")
        before = _Reached([], [], arb("0.3"), arb(0), arb(0), arb(0), SHOWN)
        travelled = []
        for time in (arb("0.004", "0.002"), arb("0.006")):
            fast = _fast(CompliantEquations(flow), norm, [arb(one) for one in POINT], before, time, epsilon)
            assert isinstance(fast, _Fast)
            travelled.append(fast.travelled)
        assert travelled[0] >= travelled[1]


def test_what_the_kick_itself_turns_counts() -> None:
    """A flow whose G changes along G, at a point, by hand: G = (x1^2, x0), p = x0, alpha_3 = -3 x0."""
    one, first, second = Constant(fmpq(1)), Variable(0), Variable(1)
    flow = ClosedFlow(
        F=(first * second, one), G=(second * second, first), p=first, b=second, alpha_1=-one, alpha_2=-second,
        alpha_3=Constant(fmpq(-3)) * first,
    )  # fmt: skip
    x0, x1, p, force, push, travelled = 0.5, -2.0, 0.5, 4.0, 0.7, 0.01
    rho = -x1 + (-1 + 3 * x0) * force
    values = np.array([x0 * x1 + x1**2 * force, 1 + x0 * force, -1, -rho / p])
    J = np.array([
        [x1, x0 + 2 * x1 * force, 0, x1**2],
        [force, 0, 0, x0],
        [0, 0, 0, 0],
        [-3 * force / p, 1 / p, rho / p**2, -(-1 + 3 * x0) / p],
    ])  # fmt: skip
    k = np.array([x1**2 / p, x0 / p, 0, -3 * x0 / p**2])
    turn = np.array([
        [0, 2 * x1 / p, -(x1**2) / p**2, 0], [1 / p, 0, -x0 / p**2, 0], [0, 0, 0, 0], [-3 / p**2, 0, 6 * x0 / p**3, 0],
    ])  # fmt: skip
    drift = np.abs(J @ k - turn @ values) + push * np.abs(turn @ k)
    with working_bits(BITS):
        fast = _Fast(
            travelled=arb(travelled), speed=arb("0.1"), last_speed=arb("0.2"), push=arb(push), last=arb(0),
            decayed=arb(0), driven=arb(0), evidence=SHOWN,
        )  # fmt: skip
        before = _Reached([arb(0)] * 4, [], arb(0), arb(0), arb(0), arb(0), SHOWN)
        end, ends, most = _moved(
            CompliantEquations(flow), [arb(x0), arb(x1), arb(p), arb(force)], before, fast, arb("1e-20")
        )
        assert [approximate(value) for value in end] == pytest.approx(list(drift * travelled), rel=1e-7, abs=1e-7)
        for ours, speed in ((ends, 0.2), (most, 0.1)):
            wanted = drift * travelled + speed * np.abs(k)
            assert [approximate(value) for value in ours] == pytest.approx(list(wanted), rel=1e-7, abs=1e-7)
    assert np.abs(turn @ k).max() > 1


def test_the_place_at_the_end() -> None:
    """(6) of the page, p = 1/2 and Lambda = 4, in floats."""
    epsilon, fast, kappa, g, lag, p, force = 1e-3, 0.03, 0.5, 2.0, 0.5, 0.5, 4.0
    norm = FastNorm(Contact.of(load("model system").regularisation), WEIGHT)
    with working_bits(BITS):
        place = _place(norm, arb(p), arb(force), arb(fast), arb(epsilon))
    V, phi = fast / math.sqrt(kappa * p), fast * math.sqrt(lag / p) / g
    assert (place[0], place[1]) == (arb(p), arb(-2))
    assert approximate(place[3].rad()) == pytest.approx(epsilon * V)
    assert approximate(place[2].rad()) == pytest.approx(epsilon**2 / kappa * (phi + force + fast / p + lag / g * V))
    assert place[2].mid() == place[3].mid() == 0
