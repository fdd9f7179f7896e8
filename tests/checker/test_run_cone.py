"""Contact for ever: the inequalities of the cones, formed a second time in rational numbers at single states.

Page: proofs/invariant_region.md. The format: proofs/run_certificate.md.
"""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

import pytest
from must_reject import runs

limits: Any = runs.part("limits")
intervals: Any = runs.part("intervals")
model: Any = runs.part("model")
run: Any = runs.part("run")
BITS = 400


def is_kept(of: dict[str, Fraction], eps: Fraction, at: dict[str, Fraction], cone: list[Fraction]) -> bool:
    """Theorems R1 and R4 with R2, at λ, W, G, D, q as they stand on the page."""
    k, kappa, gamma, zero = of["k_2"], of["k_1"] / of["damping"], 1 / of["damping"], Fraction(0)
    force, W, G, D, q, a, c = (*(at[name] for name in ("force", "W", "G", "D", "q")), cone[0], cone[-1])
    s, S = kappa + gamma * k, kappa * W + G
    alpha_3 = of["beta"] * of["alpha_1"]
    c0, c1 = eps * of["alpha_2"], eps * (of["alpha_1"] - alpha_3)
    h, load, A = max(c1 + max(c0, zero) / force, zero), max(-c1, zero), max(-c0, zero)
    M = D + s * force
    if not (of["alpha_1"] <= 0 and a > 0 and force > 0 and W >= 0 and G >= 0 and a * force <= D):
        return False
    if len(cone) == 1:
        return k * S >= a * (s + a) * force and k * q >= a * (s + a) + k * h / a
    inside = S > 0 and k * S >= a * M and kappa * G >= a * S and c * S <= D and c > 0 and a < kappa
    largest = max(q, (a * (s + a) + k * h / a) / k)
    bracket = k - c * (kappa + s) - c * c * largest - c * c * load / a
    return inside and (kappa - a) * c * (q - h / a) >= a * a and bracket >= 0 and bracket * S >= c * A


def said_of(of: dict[str, Fraction], eps: Fraction, at: dict[str, Fraction], cone: list[Fraction]) -> bool:
    """What the checker says of the state with these λ, W, G, D, q."""
    k, kappa, gamma = of["k_2"], of["k_1"] / of["damping"], 1 / of["damping"]
    Y = (k * at["W"] - (kappa + gamma * k) * at["force"] - at["D"]) / (kappa * k)
    exact = {"Y": Y, "V": -at["W"], "Z": Y + at["force"] / k, "b": at["q"] * at["force"] - at["G"], "T": Fraction(0)}
    start = {"b": "0", "p": str(-at["q"]), "v": "0", "y": "-1", "z": "0"}
    parameters = {name: str(value) for name, value in of.items()}
    scene = model.Scene(["compliant_contact", "lift_off"], str(eps), "1", parameters, start)
    numbers = intervals.Numbers(BITS, limits.Meter(limits.Limits(), 10**9))
    box = {name: numbers.interval(value) for name, value in exact.items()}
    try:
        rate = run.contact_for_ever(scene, model.System(scene, "slip"), box, numbers, [str(value) for value in cone])
    except limits.Rejected:
        return False
    assert rate == cone[0]
    return True


@pytest.mark.parametrize("count", [200, pytest.param(1500, marks=pytest.mark.slow)])
def test_the_inequalities_at_random_states(count: int) -> None:
    """Near the least q and the largest c, where every term counts; now and then a sign is wrong."""
    chance = random.Random(1)

    def between(low: float, high: float) -> Fraction:
        """Uniform in the logarithm, and short."""
        return Fraction(low * (high / low) ** chance.random()).limit_denominator(10**6)

    def sign(wrong: float = 0.02) -> int:
        return -1 if chance.random() < wrong else 1

    kept = {1: 0, 2: 0}
    for _ in range(count):
        of = {name: between(0.5, 2) for name in ("damping", "k_1", "k_2")}
        of |= {"alpha_1": -sign() * between(0.3, 2), "alpha_2": sign(0.5) * between(0.3, 2), "beta": between(0.2, 5)}
        k, kappa, s = of["k_2"], of["k_1"] / of["damping"], (of["k_1"] + of["k_2"]) / of["damping"]
        eps, a, slow = between(1e-3, 0.3), sign() * between(0.03, 1), chance.random() < 0.7
        c = sign() * between(0.3, 1.1) * k / (kappa + s)
        W, G = sign() * between(0.02, 2), sign() * between(0.02, 2)
        D = sign() * between(0.95, 3) * (abs(c) * abs(kappa * W + G) if slow else abs(a))
        least = a * a / abs(c * (kappa - a)) if slow else a * (s + a) / k
        q = between(0.9, 2) * abs(least) + between(0.3, 2) * eps / abs(a)
        at = {"force": sign() * between(0.03, 3), "W": W, "G": G, "D": D, "q": q}
        cone = [a, c] if slow else [a]
        expected = is_kept(of, eps, at, cone)
        assert said_of(of, eps, at, cone) == expected, (of, eps, at, cone)
        kept[len(cone)] += expected
    assert min(kept.values()) >= count / 75, kept


def test_only_slip_that_nothing_else_ends() -> None:
    lines = runs.stick()
    last = runs.phases(lines)[-1]
    lines[last]["cone"], lines[0]["statement"]["end"] = ["1/1000"], "for ever"
    assert runs.verdict(lines) == "REJECTED no cone in this phase of this scene"
