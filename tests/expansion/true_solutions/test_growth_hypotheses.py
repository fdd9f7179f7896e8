"""Theorem U2 of proofs/uniform.md a second time, in exact fractions: each hypothesis, and each term of it, is refused
2^-20 beyond the place where it becomes an equality, and accepted as much before it.

A run that is accepted cannot see a term that is left out while the hypothesis holds by a wide margin.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb, fmpq
from samples.strategies import ends, to_fmpq

from gspot_verified.expansion.true_solutions import growth
from gspot_verified.expansion.true_solutions.growth import DeviationCone, EntryDeviation, Ranges, grows
from gspot_verified.numbers.balls import working_bits

BITS = 256
NEAR = Fraction(1, 2**20)


@dataclass(frozen=True)
class Numbers:
    """What Theorem U2 speaks of, for a state of two components; Y, V, N, q, alpha_1, alpha_3 and the force are known up
    to ``spread``, a power of two or 0."""

    spread: Fraction = Fraction(1, 2**10)
    kappa: Fraction = Fraction(1, 2)
    lag: Fraction = Fraction(1, 2)
    damper: Fraction = Fraction(3, 4)
    rate: Fraction = Fraction(2)
    least_rate: Fraction = Fraction(7, 4)
    delta: Fraction = Fraction(1, 64)
    order: int = 20
    mu: Fraction = Fraction(1)
    begin: Fraction = Fraction(-1)
    place: Fraction = Fraction(2)
    last: Fraction = Fraction(6)
    Y: Fraction = Fraction(1)
    V: Fraction = Fraction(1)
    N: Fraction = Fraction(5, 4)
    q: Fraction = Fraction(4)
    state_1: Fraction = Fraction(1, 16)
    state_2: Fraction = Fraction(1, 32)
    p: Fraction = Fraction(1, 1024)
    fast: Fraction = Fraction(1, 1024)
    a: Fraction = Fraction(1, 2)
    c: Fraction = Fraction(3, 4)
    B: Fraction = Fraction(4)
    C: Fraction = Fraction(3)
    A_1: Fraction = Fraction(1)
    A_2: Fraction = Fraction(3, 4)
    A_p: Fraction = Fraction(1, 128)
    top: Fraction = Fraction(6)
    drift_11: Fraction = Fraction(1)
    drift_12: Fraction = Fraction(2)
    drift_21: Fraction = Fraction(3)
    drift_22: Fraction = Fraction(4)
    control_1: Fraction = Fraction(1, 2)
    control_2: Fraction = Fraction(1, 4)
    bend_1: Fraction = Fraction(1)
    bend_2: Fraction = Fraction(1, 2)
    push_1: Fraction = Fraction(1)
    push_2: Fraction = Fraction(2)
    alpha_1: Fraction = Fraction(-9, 8)
    alpha_3: Fraction = Fraction(-9, 8)
    force: Fraction = Fraction(2)
    eta_1: Fraction = Fraction(1, 256)
    eta_2: Fraction = Fraction(1, 256)
    eta_p: Fraction = Fraction(1, 1024)
    eta_b: Fraction = Fraction(1, 256)
    eta_y: Fraction = Fraction(1, 8)
    eta_v: Fraction = Fraction(1, 256)
    eta_z: Fraction = Fraction(1, 1024)


def hypotheses(n: Numbers) -> dict[str, Fraction]:
    """Each inequality of the page, left side minus right side; those that follow from others are left out."""
    Y_1, V_1, q_1 = n.Y - n.spread, n.V - n.spread, n.q - n.spread
    alpha_1, alpha_3, force = abs(n.alpha_1) + n.spread, abs(n.alpha_3) + n.spread, abs(n.force) + n.spread
    k_plus, k_minus = (max(0, sign * (n.alpha_1 - n.alpha_3) + 2 * n.spread) for sign in (1, -1))
    q_last = n.q + n.spread + alpha_1 * (n.last - n.place)
    phi = max(n.fast / V_1, (n.delta * n.lag * (1 + n.eta_y) + n.damper * n.eta_z) / n.rate)
    pi = q_last * phi + force * n.A_p / n.a + n.eta_v
    nu = alpha_3 * phi + n.delta**2 * (n.push_1 * n.A_1 + n.push_2 * n.A_2) / n.a + n.eta_b
    slaved = n.kappa / n.a + phi
    first = n.delta**2 * (n.drift_11 * n.A_1 + n.drift_12 * n.A_2) / n.a + n.control_1 * slaved + n.eta_1
    second = n.delta**2 * (n.drift_21 * n.A_1 + n.drift_22 * n.A_2) / n.a + n.control_2 * slaved + n.eta_2
    bent = n.delta**2 * (n.bend_1 * n.A_1 + n.bend_2 * n.A_2) / n.a + n.eta_p
    sigma = n.mu / (n.a * n.last)
    return {
        "G0 aY < V": V_1 - n.a * (n.Y + n.spread),
        "G0 V < BY": n.B * Y_1 - (n.V + n.spread),
        "G0 cV < N": n.N - n.spread - n.c * (n.V + n.spread),
        "G0 N < CV": n.C * V_1 - (n.N + n.spread),
        "G1": n.c - n.a - pi,
        "G2": n.kappa * (q_1 - k_plus / n.a) - nu - n.c * (n.c + q_1 * phi + force * n.A_p / n.a + n.eta_v),
        "G3": n.B - n.C - pi,
        "G4": n.C * (n.C - pi) - n.kappa * (q_last + k_minus / n.a) - nu,
        "G5 e_1": n.A_1 * Y_1 - n.state_1,
        "G5 e_2": n.A_2 * Y_1 - n.state_2,
        "G5 e_p": n.A_p * Y_1 - n.p,
        "G5 A_1": n.A_1 - first,
        "G5 A_2": n.A_2 - second,
        "G5 A_p": n.A_p - bent,
        "G6": -(n.alpha_1 + n.spread),
        "G7 sigma": 1 - sigma,
        "G7 order": n.order - n.mu - 1 - (Fraction(n.order, 2) + 1) * sigma,
        "G7 q": q_last - alpha_1 * n.mu / n.a,
        "G7 fast": n.least_rate * (n.place - n.begin) - n.delta,
        "G7 force": n.kappa - phi * n.B,
    }


def point(value: Fraction) -> arb:
    found = arb(to_fmpq(value))
    assert found.is_exact()
    return found


def concluded(n: Numbers, monkeypatch: pytest.MonkeyPatch) -> arb | None:
    """What :func:`grows` says, the bars being those of ``n``."""

    def wide(value: Fraction) -> arb:
        return arb(point(value), (1, 1 - n.spread.denominator.bit_length())) if n.spread else point(value)

    equations: Any = SimpleNamespace(
        dimension=2, p=2, b=3, y=4, v=5, trajectory=SimpleNamespace(order=n.order), delta=point(n.delta),
        kappa=point(n.kappa), lag=point(n.lag), damper=point(n.damper), rate=point(n.rate),
        least_rate=point(n.least_rate),
    )  # fmt: skip
    entry = EntryDeviation(
        1, to_fmpq(n.begin), to_fmpq(n.place), wide(n.Y), wide(n.V), wide(n.N), wide(n.q),
        (point(n.state_1), point(n.state_2)), point(n.p), point(n.fast),
    )  # fmt: skip
    cone = DeviationCone(*map(point, (n.a, n.c, n.B, n.C)), (point(n.A_1), point(n.A_2)), point(n.A_p), point(n.top))
    found = Ranges(
        point(n.last),
        (),
        [[point(n.drift_11), point(n.drift_12)], [point(n.drift_21), point(n.drift_22)]],
        [point(n.control_1), point(n.control_2)],
        [point(n.bend_1), point(n.bend_2)],
        [point(n.push_1), point(n.push_2)],
        wide(n.alpha_1), wide(n.alpha_3), wide(n.force),
        [point(value) for value in (n.eta_1, n.eta_2, n.eta_p, n.eta_b, n.eta_y, n.eta_v)],
        point(n.eta_z),
    )  # fmt: skip
    monkeypatch.setattr(growth, "ranges_of", lambda *_: found)
    grown = grows(equations, entry, to_fmpq(n.mu), cone)
    return None if grown is None else grown[0]


BASE = Numbers()
FAST = replace(BASE, fast=Fraction(1, 64))
ROOM_IN_G2 = replace(BASE, q=Fraction(6), C=Fraction(21, 8))
# For a hypothesis: the numbers it is met with, the ones that change, and how far to go until it is violated.
EDGES: list[tuple[str, Numbers, str, Fraction]] = [
    ("G0 aY < V", BASE, "Y", Fraction(3)),
    ("G0 V < BY", BASE, "Y", Fraction(1, 8)),
    ("G0 cV < N", BASE, "N", Fraction(1, 2)),
    ("G0 cV < N", replace(BASE, V=Fraction(2), N=Fraction(5, 2)), "N", Fraction(1, 2)),
    ("G0 N < CV", BASE, "N", Fraction(4)),
    ("G1", BASE, "a", Fraction(3, 4)),
    ("G1", BASE, "fast", Fraction(1)),
    ("G1", replace(BASE, B=Fraction(40), C=Fraction(30)), "q", Fraction(60)),
    ("G1", BASE, "lag", Fraction(20)),
    ("G1", BASE, "damper", Fraction(200)),
    ("G1", BASE, "eta_y", Fraction(20)),
    ("G1", BASE, "eta_z", Fraction(1)),
    ("G1", BASE, "eta_v", Fraction(1)),
    ("G1", BASE, "force", Fraction(40)),
    ("G1", BASE, "force", Fraction(-40)),
    ("G1", BASE, "A_p", Fraction(1)),
    ("G2", BASE, "q", Fraction(1)),
    ("G2", BASE, "alpha_3", Fraction(-4)),
    ("G2", replace(BASE, N=Fraction(5, 2)), "c", Fraction(2)),
    ("G2", BASE, "push_1", Fraction(10**4)),
    ("G2", BASE, "push_2", Fraction(10**4)),
    ("G2", BASE, "eta_b", Fraction(3)),
    ("G2", replace(BASE, N=Fraction(9, 4), c=Fraction(5, 4)), "eta_v", Fraction(2)),
    ("G2", replace(BASE, N=Fraction(9, 4), c=Fraction(5, 4)), "force", Fraction(100)),
    ("G2", replace(BASE, alpha_1=Fraction(-2), alpha_3=Fraction(-1)), "q", Fraction(1)),
    ("G3", BASE, "B", Fraction(2)),
    ("G4", BASE, "C", Fraction(2)),
    ("G4", BASE, "last", Fraction(20)),
    ("G4", ROOM_IN_G2, "alpha_3", Fraction(2)),
    ("G4", ROOM_IN_G2, "push_1", Fraction(10**4)),
    ("G4", ROOM_IN_G2, "eta_b", Fraction(3)),
    ("G5 e_1", BASE, "state_1", Fraction(2)),
    ("G5 e_2", BASE, "state_2", Fraction(2)),
    ("G5 e_p", BASE, "p", Fraction(1)),
    ("G5 A_1", BASE, "drift_11", Fraction(10**4)),
    ("G5 A_1", BASE, "drift_12", Fraction(10**4)),
    ("G5 A_1", BASE, "control_1", Fraction(2)),
    ("G5 A_1", BASE, "eta_1", Fraction(2)),
    ("G5 A_1", FAST, "eta_1", Fraction(2)),
    ("G5 A_2", BASE, "drift_21", Fraction(10**4)),
    ("G5 A_2", BASE, "drift_22", Fraction(10**4)),
    ("G5 A_2", BASE, "control_2", Fraction(2)),
    ("G5 A_2", BASE, "eta_2", Fraction(2)),
    ("G5 A_p", BASE, "bend_1", Fraction(10**3)),
    ("G5 A_p", BASE, "bend_2", Fraction(10**3)),
    ("G5 A_p", BASE, "eta_p", Fraction(1)),
    ("G6", replace(BASE, q=Fraction(6), C=Fraction(7, 2)), "alpha_1", Fraction(1)),
    ("G7 sigma", BASE, "mu", Fraction(4)),
    ("G7 order", replace(BASE, order=6), "mu", Fraction(5, 2)),
    ("G7 q", replace(BASE, place=Fraction(5), last=Fraction(9), order=40), "mu", Fraction(17, 4)),
    ("G7 fast", BASE, "begin", Fraction(3)),
    ("G7 force", BASE, "B", Fraction(200)),
]  # fmt: skip


def edge(name: str, start: Numbers, field: str, far: Fraction) -> tuple[Numbers, Numbers]:
    """Numbers 2^-20 before and beyond the place on the way to ``far`` where the hypothesis becomes an equality."""
    inside, outside = getattr(start, field), far
    assert hypotheses(start)[name] > 0 >= hypotheses(replace(start, **{field: far}))[name]
    length = outside - inside
    while abs(outside - inside) > NEAR * abs(length) / 8:
        middle = (inside + outside) / 2
        inside, outside = (
            (middle, outside) if hypotheses(replace(start, **{field: middle}))[name] > 0 else (inside, middle)
        )
    return replace(start, **{field: inside - NEAR * length}), replace(start, **{field: outside + NEAR * length})


@pytest.mark.parametrize(("name", "start", "field", "far"), EDGES, ids=[f"{one[0]}, {one[2]}" for one in EDGES])
def test_each_hypothesis_decides_at_its_equality(
    name: str, start: Numbers, field: str, far: Fraction, monkeypatch: pytest.MonkeyPatch
) -> None:
    before, beyond = edge(name, start, field, far)
    assert all(value > 0 for value in hypotheses(before).values())
    assert [key for key, value in hypotheses(beyond).items() if value <= 0] == [name]
    with working_bits(BITS):
        assert concluded(before, monkeypatch) is not None
        assert concluded(beyond, monkeypatch) is None


POINT = replace(BASE, spread=Fraction(0))
# With exact numbers: the hypothesis, what it is met with, and a number in which it is linear.
EQUALITIES: list[tuple[str, Numbers, str]] = [
    ("G0 aY < V", POINT, "Y"),
    ("G0 V < BY", POINT, "Y"),
    ("G0 cV < N", POINT, "N"),
    ("G0 N < CV", POINT, "N"),
    ("G1", POINT, "eta_v"),
    ("G2", POINT, "eta_b"),
    ("G3", POINT, "B"),
    ("G4", replace(POINT, q=Fraction(6), C=Fraction(21, 8)), "eta_b"),
    ("G5 e_1", POINT, "state_1"),
    ("G5 e_2", POINT, "state_2"),
    ("G5 e_p", POINT, "p"),
    ("G5 A_1", POINT, "eta_1"),
    ("G5 A_2", POINT, "eta_2"),
    ("G5 A_p", POINT, "eta_p"),
    ("G6", replace(POINT, q=Fraction(6), C=Fraction(7, 2)), "alpha_1"),
    ("G7 sigma", POINT, "mu"),
    ("G7 order", replace(POINT, order=6, last=Fraction(8)), "mu"),
    ("G7 q", replace(POINT, place=Fraction(5), last=Fraction(9), order=40, alpha_1=Fraction(-1)), "mu"),
    ("G7 fast", POINT, "begin"),
    ("G7 force", replace(POINT, B=Fraction(64), fast=Fraction(7, 1024)), "fast"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "start", "field"), EQUALITIES, ids=[one[0] for one in EQUALITIES])
def test_no_hypothesis_holds_with_equality(
    name: str, start: Numbers, field: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    place, margin, far = getattr(start, field), hypotheses(start)[name], Fraction(1, 2**40)
    slope = (hypotheses(replace(start, **{field: place + far}))[name] - margin) / far
    equal = replace(start, **{field: place - margin / slope})
    assert margin > 0
    assert [(key, value) for key, value in hypotheses(equal).items() if value <= 0] == [(name, 0)]
    with working_bits(BITS):
        assert concluded(start, monkeypatch) is not None
        assert concluded(equal, monkeypatch) is None


def test_phi_is_rounded_upwards() -> None:
    equations: Any = SimpleNamespace(delta=arb(fmpq(1, 3)), lag=arb(1), y=0, damper=arb(1), rate=arb(3))
    for bits in range(2, 40):
        with working_bits(bits):
            found: Any = SimpleNamespace(eta=[arb(0)], eta_z=arb(fmpq(1, 7)))
            entry: Any = SimpleNamespace(fast=arb(0), V=arb(1))
            assert ends(growth.phi_of(equations, entry, found))[1] >= Fraction(10, 63)


@pytest.mark.parametrize("n", [BASE, FAST])
def test_the_force_that_is_reached_is_the_one_of_the_page(n: Numbers, monkeypatch: pytest.MonkeyPatch) -> None:
    n = replace(n, c=Fraction(7, 8), N=Fraction(3, 2))
    phi = max(n.fast / (n.V - n.spread), (n.delta * n.lag * (1 + n.eta_y) + n.damper * n.eta_z) / n.rate)
    page = (n.kappa - phi * n.B) * n.top
    with working_bits(BITS):
        found = concluded(n, monkeypatch)
        assert found is not None
        lower, upper = ends(found)
    assert page * (1 - Fraction(1, 2**60)) <= lower <= upper <= page
