"""What the checker of approaches derives and bounds, each beside a computation that shares no code with it.

Page: proofs/approach_certificate.md, sections 1 and 3.
"""

from __future__ import annotations

import copy
import json
import math
import random
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from flint import arb, fmpq
from must_reject import mutate
from samples.checker_models import at_balls
from scipy.integrate import solve_ivp

from gspot_verified.mechanisms.approach.slip_flow import SlipFlow, SlipNumbers
from gspot_verified.mechanisms.approach.slip_state import slip_state
from gspot_verified.mechanisms.derive.to_system import angle_ball, shift
from gspot_verified.mechanisms.load import load
from gspot_verified.numbers.balls import working_bits
from gspot_verified.scenes.certificates.polynomial_mechanism import PolynomialMechanism

check = mutate.checker()
approach, intervals, limits, model = check.approach, check.intervals, check.limits, check.model
LINES = [
    json.loads(line)
    for line in mutate.CHECKER.with_name("approach_rod.cert").read_text(encoding="utf-8").splitlines()[:-1]
]
DATA = "gspot_verified/mechanisms/data/"
MECHANISMS = ["rod", "oscillator", f"{DATA}genot_brogliato_rod.toml", f"{DATA}falling_rod_lower_friction.toml"]
MECHANISMS += [f"{DATA}gallery/{name}.toml" for name in ("ladder", "rod_with_wrist", "compass_biped")]


def meter() -> Any:
    return limits.Meter(limits.Limits(), 10**12)


@pytest.mark.parametrize("name", MECHANISMS)
def test_every_function_is_that_of_the_library(name: str) -> None:
    """At random states on the contact: p, b, u, the α's, F, G and X, of the library from expressions of all states."""
    mechanism = load(mutate.CHECKER.parents[1] / name if "/" in name else name)
    shifted, chance = shift(mechanism), random.Random(7)
    polynomials = PolynomialMechanism(shifted.mechanism)
    slip = approach.Slip(check.mechanism.Mechanism(polynomials.given), Fraction(1, 3), meter())
    words = {place: word for word, place in polynomials.place.items()}
    angles = {angle.coordinate: angle for angle in mechanism.angles}
    with working_bits(200):
        for _ in range(3):
            own = {each: Fraction(chance.randint(-9, 9), 8) for each in slip.own}
            given = {
                words.get(each, each): f"{words[each]}_ref + {value}" if words.get(each) in angles else str(value)
                for each, value in own.items()
            }
            box = slip_state(shifted, given).box
            numbers = SlipNumbers(SlipFlow.of(shifted)).on(box)
            at = {each: arb(fmpq(value.numerator, value.denominator)) for each, value in own.items()}
            for q in slip.angles:
                whole = at[polynomials.place[q]] + (angle_ball(angles[q]) if q in angles else 0)
                at |= {f"sin({q})": whole.sin(), f"cos({q})": whole.cos()}
            if slip.inverse:
                at["1/det M"] = 1 / at_balls(slip.minors[-1], at)
            of = {each: at_balls(function, at) for each, function in slip.of.items()}
            expected = [numbers.p, numbers.b, numbers.u, numbers.alpha_1, numbers.alpha_2, numbers.alpha_3]
            for each, value in zip(("p", "b", "u", "α_1", "α_2", "α_3"), expected, strict=True):
                assert_same(of[each], value)
            for each in slip.own:
                k = mechanism.state.index(words.get(each, each))
                F, G = (at_balls(rates.get(each, model.Polynomial()), at) for rates in (slip.F, slip.G))
                assert_same(F, numbers.F[k])
                assert_same(G, numbers.G[k])
                assert_same(at_balls(slip.rates[each], at), numbers.p * numbers.F[k] - numbers.b * numbers.G[k])
            for q in slip.angles:
                speed = of["p"] * at.get(f"{q}_dot", arb(0))
                assert_same(at_balls(slip.rates[f"sin({q})"], at), speed * at[f"cos({q})"])
                assert_same(at_balls(slip.rates[f"cos({q})"], at), -speed * at[f"sin({q})"])
            assert_same(at_balls(slip.rates["t"], at), of["p"])
            assert_same(at_balls(slip.slope, at), of["u"] - fmpq(1, 3))
            assert_same(at_balls(slip.events["b ≥ 0"].function, at), -of["b"])
            along = at_balls(slip.events["b ≥ 0"].rate, at)
            assert_same(along, -(of["α_2"] * of["p"] + of["α_3"] * of["b"]))
            if slip.inverse:  # wD = 1 is kept
                rate = sum(
                    (at_balls(slip.minors[-1].by(n), at) * at_balls(slip.rates[n], at) for n in slip.states), arb(0)
                )
                assert_same(at_balls(slip.rates["1/det M"], at), -(at["1/det M"] ** 2) * rate)


def assert_same(one: arb, two: arb) -> None:
    assert one.is_finite()
    assert abs(one - two) < arb(2) ** -120


def test_the_jacobian_is_that_of_the_rates() -> None:
    slip = approach.Slip(check.mechanism.Mechanism(LINES[0]["statement"]["mechanism"]), None, meter())
    assert slip.names == sorted(slip.names)
    assert [*slip.states, "t"] == sorted([*slip.states, "t"], key=lambda name: (name == "t", name))
    assert slip.slope is None
    assert set(slip.events) == {"b ≥ 0"}
    for i, row in zip(slip.names, slip.jacobian, strict=True):
        for j, entry in zip(slip.names, row, strict=True):
            assert entry == slip.rates[i].by(j)


def test_the_start_is_on_the_circle_and_its_box_is_narrow() -> None:
    given = LINES[0]["statement"]
    slip = approach.Slip(check.mechanism.Mechanism(given["mechanism"]), None, meter())
    numbers = intervals.Numbers(128, meter())
    box = slip.first_box({name: Fraction(value) for name, value in given["start"].items()}, numbers)
    assert set(box) == set(slip.names)
    angle = math.asin(0.6) - 0.1
    exact = {"sin(theta)": math.sin(angle), "cos(theta)": math.cos(angle), "theta_dot": 0.9, "X_dot": 2, "X": 0, "t": 0}
    for name, value in (exact | {"(theta-theta_ref)": -0.1}).items():
        low, high = (end / numbers.one for end in box[name])
        assert low - 1e-15 <= value <= high + 1e-15
        assert box[name][1] - box[name][0] <= 64


@pytest.mark.parametrize("name", ["oscillator", f"{DATA}gallery/compass_biped.toml"])
def test_the_start_has_the_inverse_of_the_determinant(name: str) -> None:
    polynomials = PolynomialMechanism(shift(load(mutate.CHECKER.parents[1] / name if "/" in name else name)).mechanism)
    slip = approach.Slip(check.mechanism.Mechanism(polynomials.given), None, meter())
    slip.of["p"] = model.number(1)
    numbers = intervals.Numbers(128, meter())
    box = slip.first_box({each: Fraction(k, 7) for k, each in enumerate(slip.own)}, numbers)
    assert len(slip.minors) == len(polynomials.coordinates)
    with working_bits(200):
        values = {each: arb(side[0]) / numbers.one for each, side in box.items()}
        assert abs(at_balls(slip.minors[-1], values) * values["1/det M"] - 1) < arb(2) ** -100


# ---------------------------------------------------------------------------------------------------------------------
# The end: Theorem A5 on numbers of our own.
# ---------------------------------------------------------------------------------------------------------------------

ONE = 2**64


def in_units(value: Any) -> int:
    return int(Fraction(value) * ONE)


def stub(**changes: Any) -> Any:
    """One state x with p = 1/8 - x/64, b = -1/4, α = (-2, 1/2, -1), F = 3, G = -5, u - u_s = 7 + x at x = 0."""
    given: dict[str, Any] = {"p": "1/8", "b": "-1/4", "α_1": -2, "α_2": "1/2", "α_3": -1, "F": 3, "G": -5} | changes
    number = {name: model.number(Fraction(value)) for name, value in given.items()}
    x = model.state("x")
    number["p"] = number["p"] - model.number(Fraction(1, 64)) * x
    of = {name: value for name, value in number.items() if name not in "FG"}
    return SimpleNamespace(of=of, F={"x": number["F"]}, G={"x": number["G"]}, states=["x"],
                           slope=model.number(Fraction(changes.get("slope", 7))) + x)  # fmt: skip


# P = 1/16, B = 1/4 + 1/32 = 9/32, ρ = 3/16 + 45/32 = 51/32; λ_1 = 2, α_3 - α_1 = 1.
RHO = Fraction(51, 32)


def end(slip: Any, low: Fraction = -RHO - 1, high: Fraction = RHO + 1) -> Any:
    at, box = {"x": (0, 0)}, {"x": (in_units(low), in_units(high))}
    return approach.captured(slip, at, box, intervals.Numbers(64, meter()))


def refused(slip: Any, **sides: Fraction) -> str:
    with pytest.raises(limits.Rejected) as found:
        end(slip, **sides)
    return str(found.value)


UNIT = Fraction(1, ONE)


def test_the_reach_is_that_of_the_page() -> None:
    found = end(stub())
    assert found.time == in_units(Fraction(1, 16))
    assert found.place == {"x": (-in_units(RHO), in_units(RHO))}
    assert found.sign == -1


def test_the_reach_lies_in_the_interior() -> None:
    assert end(stub(), low=-RHO - UNIT, high=RHO + UNIT)
    assert refused(stub(), low=-RHO) == "x may leave the neighbourhood"
    assert refused(stub(), high=RHO) == "x may leave the neighbourhood"


@pytest.mark.parametrize("sign", [1, -1])
def test_sizes_count_not_signs(sign: int) -> None:
    """F, G with other signs, and α_2 = -1/2: the same reach."""
    assert end(stub(F=3 * sign, G=5 * sign)).place == end(stub()).place
    assert end(stub(α_2="-1/2")).place == end(stub()).place


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"α_1": 0}, "α_1 and α_3 are not certainly negative"),
        ({"α_1": "1/9"}, "α_1 and α_3 are not certainly negative"),
        ({"α_3": 0}, "α_1 and α_3 are not certainly negative"),
        ({"α_3": "1/9"}, "α_1 and α_3 are not certainly negative"),
        ({"p": 0}, "b is not certainly negative"),
        ({"b": 0}, "b is not certainly negative"),
        ({"b": "1/4"}, "b is not certainly negative"),
        ({"slope": 0}, "slip is not certainly positive"),
        ({"slope": RHO + 1}, "slip is not certainly positive"),
    ],
)
def test_each_sign_is_asked(change: dict[str, Any], reason: str) -> None:
    assert reason in refused(stub(**change))


def test_slip_is_asked_on_the_whole_neighbourhood() -> None:
    assert end(stub(slope=RHO + 1 + UNIT))


def test_the_force_stays_positive_where_it_rises() -> None:
    """dλ_1 > α_2 > 0 with d = α_3 - α_1 = 1/4 and λ_1 = 2; or α_2 < 0."""
    wide = {"low": Fraction(-20), "high": Fraction(20)}
    steep = {"slope": 30, "α_1": "-5/4"}
    assert refused(stub(**steep, α_2="1/2"), **wide) == "λ_N > 0 is not certain in the neighbourhood"
    assert end(stub(**steep, α_2=Fraction(1, 2) - UNIT), **wide).sign == -1
    assert end(stub(**steep, α_2=-UNIT), **wide).sign == -1
    # α_3 < α_1, or both the same: α_2 < 0 alone helps, and nothing is said of C_1.
    for first in ("-1", "-3/4"):
        slower = {"slope": 30, "α_1": first}
        assert refused(stub(**slower, α_2=0), **wide) == "λ_N > 0 is not certain in the neighbourhood"
        assert end(stub(**slower, α_2=-UNIT), **wide).sign == 0


def test_the_ends_of_the_states_count() -> None:
    """p, b and the reach from a box of states: the largest p, the smallest and the largest |b|."""
    slip = stub()
    slip.of["b"] = slip.of["b"] + model.number(Fraction(1, 16)) * model.state("x")
    at = {"x": (in_units(-1), in_units(1))}
    box = {"x": (in_units(-9), in_units(9))}
    slip.slope = None
    found = approach.captured(slip, at, box, intervals.Numbers(64, meter()))
    time = (Fraction(1, 8) + Fraction(1, 64)) / 2
    reach = 3 * time + 5 * (Fraction(1, 4) + Fraction(1, 16) + time / 2)
    assert found.time == in_units(time)
    assert found.place == {"x": (in_units(-1 - reach), in_units(1 + reach))}
    # λ_1 = (3/16)/(9/64) = 4/3, d = 1.
    slip.of["α_2"] = model.number(Fraction(4, 3))
    with pytest.raises(limits.Rejected, match="λ_N > 0"):
        approach.captured(slip, at, {"x": (in_units(-99), in_units(99))}, intervals.Numbers(64, meter()))
    slip.of["α_2"] = model.number(Fraction(4, 3) - 4 * UNIT)
    assert approach.captured(slip, at, {"x": (in_units(-99), in_units(99))}, intervals.Numbers(64, meter())).sign == -1


# ---------------------------------------------------------------------------------------------------------------------
# The side: Theorem A6 on numbers of our own.
# ---------------------------------------------------------------------------------------------------------------------


def side_of(force: Fraction, width: Fraction = Fraction(1, 2**40), **changes: Any) -> int:
    """From x = 0 with p = 1/16 and b = -force/16: α = (-1, -1 - x, -3/2 + x/8), F = 1, G = 0; |x| ≤ width on N.

    Then ℓ = (1 + x)/(1/2 - x/8) is 2, it rises by 5/2 with x, and κ = 1/2: the bound mp/κ is 5/16.
    """
    x, number = model.state("x"), model.number
    given = {"p": Fraction(1, 16), "b": -force / 16, "α_1": Fraction(-1), "F": Fraction(1), "G": Fraction(0)} | changes
    of = {name: number(value) for name, value in given.items() if name not in "FG"}
    of |= {"α_2": number(-1) - x, "α_3": number(Fraction(-3, 2)) + number(Fraction(1, 8)) * x} | {
        name: number(value) for name, value in changes.items() if name in ("α_2", "α_3")
    }
    slip = SimpleNamespace(of=of, F={"x": number(given["F"])}, G={"x": number(given["G"])}, states=["x"])
    box = {"x": (in_units(-width), in_units(width))}
    return int(approach.side(slip, {"x": (0, 0)}, box, intervals.Numbers(64, meter())))


NEAR = Fraction(1, 2**30)


@pytest.mark.parametrize("sign", [1, -1])
def test_the_side_is_certain_from_the_bound_of_the_page_on(sign: int) -> None:
    assert side_of(2 + sign * (Fraction(5, 16) + NEAR)) == -sign
    assert side_of(2 + sign * (Fraction(5, 16) - NEAR)) == 0


def test_the_force_pushes_the_limit() -> None:
    """F = 0, G = 1: ℓ' = 5λ/2 with the largest λ between -b/p and ℓ; the bound is 5λ/16."""
    for force, expected in (("3", -1), ("32/11", 0), ("33/11", -1), ("31/11", 0)):
        assert side_of(Fraction(force), F=Fraction(0), G=Fraction(1)) == expected  # 2 + 5λ/16 < λ from 32/11 on
    for force, expected in (("22/16", 0), ("11/8", 0), ("21/16", 1)):
        assert side_of(Fraction(force), F=Fraction(0), G=Fraction(1)) == expected  # the largest is ℓ = 2: 5/8


def test_the_least_limit_counts() -> None:
    """ℓ = 2 + 2x and ℓ' = 2(λ - 59/20), p = 15/32, λ - ℓ = 19/10: m = 29/10 from λ = 3/2 on the wide N is too much."""
    force, p = Fraction(39, 10), Fraction(15, 32)
    given = {"α_3": Fraction(-3, 2), "p": p, "b": -force * p, "F": Fraction(-59, 20), "G": Fraction(1)}
    assert side_of(force, Fraction(1, 4), **given) == 0
    assert side_of(force, Fraction(1, 2**20), **given) == -1


def test_all_of_the_neighbourhood_counts() -> None:
    assert side_of(2 + Fraction(6, 16), width=Fraction(1, 64)) == -1
    assert side_of(2 + Fraction(6, 16), width=Fraction(1, 2)) == 0


@pytest.mark.parametrize(
    "changes",
    [
        {"α_3": Fraction(-1)},  # β = 1
        {"α_3": Fraction(-1, 2)},
        {"α_3": Fraction(-2)},  # β = 2
        {"α_3": Fraction(-3)},
        {"p": Fraction(0)},
        {"p": Fraction(-1, 16)},
    ],
)
def test_no_side_without_its_hypotheses(changes: dict[str, Any]) -> None:
    assert side_of(Fraction(200), **changes) == 0


def test_a_side_for_beta_just_between() -> None:
    assert side_of(Fraction(2000), α_3=Fraction(-1) - Fraction(1, 64)) == -1
    assert side_of(Fraction(2000), α_3=Fraction(-2) + Fraction(1, 64)) == -1


def test_what_is_claimed_holds_what_was_found() -> None:
    numbers = intervals.Numbers(64, meter())
    found = (in_units("1/4"), in_units("1/2"))
    assert approach.holds(["1/4", "1/2"], found, numbers, "x") == "x in [0.25, 0.5]"
    for claim in (["1/4", str(Fraction(1, 2) - UNIT / 3)], [str(Fraction(1, 4) + UNIT / 3), "1/2"]):
        with pytest.raises(limits.Rejected, match="x may lie outside of the range"):
            approach.holds(claim, found, numbers, "x")
    assert approach.negative((3, 5)) == (-5, -3)


def test_the_shipped_rod_beside_scipy() -> None:
    """Rigid slip of the rod in its own time, from formulas by hand: with c = cos θ, s = sin θ the centre's height is s,
    v̇ = Ÿ - c θ̈ + s θ̇², 3 times the inertia is 1."""
    mu, g = 73 / 36, 0.6

    def parts(theta: float, rate: float) -> tuple[float, float]:
        c, s = math.cos(theta), math.sin(theta)
        return 1 + 3 * c * (c - mu * s), -g + s * rate**2

    def field(_: float, state: np.ndarray) -> list[float]:
        theta, rate, _X, speed = state
        p, b = parts(theta, rate)
        force = -b / p
        return [rate, -3 * (math.cos(theta) - mu * math.sin(theta)) * force, speed, -mu * force]

    def near(_: float, state: np.ndarray) -> float:
        return parts(state[0], state[1])[0] - 1e-7

    near.terminal = True  # type: ignore[attr-defined]
    start = [math.asin(0.6) - 0.1, 0.9, 0.0, 2.0]
    run = solve_ivp(field, (0, 1), start, "LSODA", rtol=1e-12, atol=1e-13, events=near)
    time, (theta, rate, X, speed) = run.t_events[0][0], run.y_events[0][0]
    statement = LINES[0]["statement"]
    p = parts(theta, rate)[0]
    assert abs(time + p / 4.5833333 - float(Fraction(statement["time"]))) < 1e-8
    ends = {"(theta-theta_ref)": theta - math.asin(0.6), "theta_dot": rate, "X": X, "X_dot": speed}
    for name, value in ends.items():
        low, high = map(float, map(Fraction, statement["place"][name]))
        assert low - 1e-2 * (name.endswith("dot")) - 1e-7 <= value <= high + 1e-2 * name.endswith("dot") + 1e-7
        # Near the G-spot λ is like p^(β-1): velocities still move by about p^β there.
    alphas = [tuple(map(Fraction, pair)) for pair in statement["alpha"]]
    assert alphas[0][0] < Fraction(-55, 12) < alphas[0][1]  # at the G-spot sin θ = 3/5, θ̇ = 1
    assert alphas[1][0] < Fraction(4, 5) < alphas[1][1]
    assert alphas[2][0] < Fraction(-3, 2) < alphas[2][1]


# ---------------------------------------------------------------------------------------------------------------------
# Hostile files.
# ---------------------------------------------------------------------------------------------------------------------


def hostile(**given: Any) -> str:
    lines = copy.deepcopy(LINES)
    lines[0]["statement"]["mechanism"] |= given
    with pytest.raises(limits.Rejected) as found:
        check.main.check_text(mutate.text_of(lines))
    return str(found.value)


def test_many_terms_end_soon(monkeypatch: pytest.MonkeyPatch) -> None:
    """Formulas within their limits, with Lie derivatives of very many terms: paid before they are made."""
    n = range(4)
    names = ["sin(a)", "cos(a)", "sin(e)", "cos(e)", "sin(c)", "cos(c)"]
    force = " + ".join(f"{i + 2}/41*{names[i % 6]}*{names[i // 6]}*{'aec'[i % 3]}_dot*e_dot" for i in range(24))
    rows = [["2" if i == j else f"1/9*{names[2 * min(i, j) + 1]}" for j in n] for i in n]
    given = {"angles": {}, "coordinates": ["a", "e", "c", "d"], "forces": [force] * 4, "mass_matrix": rows,
             "x": "1*sin(a) + 1*sin(e)", "y": "1*d + 1*cos(a) + 1*cos(e) + 1*cos(c)"}  # fmt: skip
    amounts = mutate.work_of(check, monkeypatch)
    reason = hostile(**given)
    assert "the limit work" in reason or "too many terms" in reason or "too high a degree" in reason
    assert sum(amounts) < 4 * 10**9
