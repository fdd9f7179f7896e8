"""Contact for ever: the inequalities of the cones, formed a second time in rational numbers at single states.

Page: proofs/invariant_region.md. The format: proofs/run_certificate.md.
"""

from __future__ import annotations

import random
from fractions import Fraction
from types import SimpleNamespace
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
        near, S = between(0.98, 1.02), k * (of["k_1"] / of["damping"] * W + G)
        if chance.random() < 0.3:  # k S is near a (s + a) λ, or a M
            at["force"] = near * (S / a - D) / s if slow else near * S / (a * (s + a))
        elif slow and chance.random() < 0.5:  # the bracket of (4) is near 0
            slope, fast = eps * of["alpha_1"] * (1 - of["beta"]), a * (s + a) / k
            least = max(q, fast + max(slope, Fraction(0)) / a) + max(-slope, Fraction(0)) / a
            root = ((kappa + s) ** 2 + 4 * k * least) ** 0.5 - float(kappa + s)
            c = (near * Fraction(root / float(2 * least))).limit_denominator(10**6)
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


STILL = {"k_1": "1", "k_2": "1", "damping": "1", "alpha_1": "-1", "alpha_2": "-1", "beta": "1"}
KEPT = {"force": "1", "W": "1", "G": "1", "D": "1", "q": "4"}  # s = 2, kappa = 1, S = 2, h = 0


def judged(cone: list[str], parameters: dict[str, str] | None = None, **change: str) -> bool:
    of = {name: Fraction(value) for name, value in (STILL | (parameters or {})).items()}
    at = {name: Fraction(value) for name, value in (KEPT | change).items()}
    numbers = [Fraction(v) for v in cone]
    found = said_of(of, Fraction(1, 8), at, numbers)
    assert found == (min(numbers[0], at["force"]) > 0 and is_kept(of, Fraction(1, 8), at, numbers))
    return found


def test_the_border_of_the_first_cone() -> None:
    """k S = 2 at a = 1/2: a (s + a) λ = 5/4, which is 2 at λ = 8/5; G and W ≥ 0; q ≥ 5/4."""
    assert judged(["1/2"])
    assert judged(["1/2"], W="0", G="2")
    assert judged(["1/2"], W="2", G="0")
    assert not judged(["1/2"], W="4", G="-1/100")
    assert not judged(["1/2"], W="-1/100", G="4")
    assert judged(["1/2"], force="159/100")
    assert not judged(["1/2"], force="161/100")
    assert judged(["1/2"], q="126/100")
    assert not judged(["1/2"], q="124/100")
    assert not judged(["1/2"], D="49/100")


def test_the_bracket_holds_as_far_as_the_first_cone() -> None:
    """q = 3/10 rises to 9/16 before Theorem R1 takes over: 1 - 3c - 9/16 c² ≥ 0."""
    still = {"alpha_2": "0"}
    assert judged(["1/4", "5/16"], still, q="3/10")
    assert not judged(["1/4", "63/200"], still, q="3/10")


def test_a_force_of_0_and_a_rate_of_0() -> None:
    assert not judged(["1/2"], force="0")
    assert not judged(["0"])
    assert not judged(["0", "1/4"])


def test_the_load_does_not_fall() -> None:
    assert judged(["1/2"], {"alpha_1": "0"})
    assert not judged(["1/2"], {"alpha_1": "1/100"})


@pytest.mark.parametrize(("phase", "slides", "coupled"), [("flight", 0, 0), ("slip", 1, 0), ("slip", 0, 1)])
def test_each_condition_of_the_scene(phase: str, slides: int, coupled: int) -> None:
    scene, system = SimpleNamespace(slides=bool(slides), coupled=bool(coupled)), SimpleNamespace(phase=phase)
    with pytest.raises(limits.Rejected, match="no cone in this phase of this scene"):
        run.contact_for_ever(scene, system, {}, None, ["1/2"])


@pytest.mark.parametrize("name", ["Y", "V", "Z", "b"])
def test_the_inequalities_hold_on_the_whole_box(name: str) -> None:
    """About a state inside of the cone: a wide interval of one state leaves it, a narrow one does not."""
    scene = model.Scene(
        ["compliant_contact", "lift_off"], "1/8", "1", STILL, {"b": "3", "p": "-4", "v": "0", "y": "-1", "z": "0"}
    )
    exact = {"Y": -4, "V": -1, "Z": -3, "b": 3, "T": 0}  # λ = 1, W = 1, G = 1, D = 3
    numbers = intervals.Numbers(BITS, limits.Meter(limits.Limits(), 10**9))
    for width, kept in (Fraction(1, 100), True), (Fraction(9), False):
        box = {n: numbers.interval(Fraction(v)) for n, v in exact.items()}
        box[name] = intervals.wider(box[name], int(width * numbers.one))
        for cone in ["1/4"], ["1/4", "1/8"]:
            try:
                run.contact_for_ever(scene, model.System(scene, "slip"), box, numbers, cone)
                assert kept
            except limits.Rejected:
                assert not kept
