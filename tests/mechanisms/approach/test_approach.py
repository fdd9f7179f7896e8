"""From a state to the verdict: closed forms of the model, mpmath's integration for the others, hard cases.

Pages: proofs/approach.md, proofs/validated_step.md.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from importlib.resources import files
from typing import Any

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.model_texts import model_text
from samples.strategies import to_fmpq

from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.mechanisms.approach.approach import approach
from gspot_verified.mechanisms.approach.approach_result import IMPACT, LIFT_OFF, Approach
from gspot_verified.mechanisms.approach.mechanism_side import mechanism_side
from gspot_verified.mechanisms.approach.slip_state import StateError
from gspot_verified.mechanisms.expand import expand
from gspot_verified.mechanisms.input.file import parse_mechanism
from gspot_verified.mechanisms.input.mechanism import Mechanism, MechanismError
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.signs.gamma.side import gamma_sign

OSCILLATOR = shipped_mechanism("frictional impact oscillator")
MODEL = shipped_mechanism("model system")
EXTENDED = shipped_mechanism("extended system")
ROD = shipped_mechanism("falling rod")


def model(alpha_1: str, alpha_2: str, alpha_3: str) -> Mechanism:
    return MODEL.with_parameters(alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3)


def from_model(mechanism: Mechanism, p: str, b: str, u: str = "100") -> Approach:
    return approach(mechanism, {"x": 0, "u": u, "p": p, "b": b})


def finite(value: arb | None) -> arb:
    assert value is not None
    assert value.is_finite()
    return value


def close(value: arb, expected: mpmath.mpf, relative: float) -> None:
    """The ball lies within this relative distance of a number that is only approximate."""
    middle = mpmath.mpf(finite(value).mid().str(40, radius=False))
    assert value.rad() < abs(float(expected)) * relative
    assert abs(middle - expected) < abs(expected) * relative


# The model system: closed form


@pytest.mark.parametrize(
    ("alphas", "p", "b", "relative"),
    [
        (("-1", "-1", "-3/2"), "1/2", "-1/4", "1e-6"),
        (("-1", "-1", "-3/2"), "1/2", "-2", "1e-6"),
        (("-2", "-1", "-5"), "1/3", "-1/10", "1e-6"),
        (("-1/2", "-1/3", "-7/4"), "1/4", "-1/5", "1e-6"),
        (("-1", "-1", "-15/2"), "1/4", "-1/5", "1e-4"),
        (("-1", "-1", "-1/2"), "1/2", "-1/2", "1e-3"),
        (("-2", "1", "-1"), "1/2", "-1", "1e-3"),
        (("-1", "-1", "-7/8"), "1/2", "-1/2", "0.2"),
    ],
)
def test_the_model_in_closed_form(alphas: tuple[str, str, str], p: str, b: str, relative: str) -> None:
    """b = b_bar + C_1 (-t)^β with b_bar = α_2 p/(α_1 - α_3) for every p, and t = -p/|α_1|."""
    first, second, third = (fmpq(*map(int, (text + "/1").split("/")[:2])) for text in alphas)
    start_p, start_b = (fmpq(*map(int, (text + "/1").split("/")[:2])) for text in (p, b))
    found = from_model(model(*alphas), p, b)
    assert found.end == "G-spot"
    assert found.verdict.outcome is Outcome.PROVED
    beta = third / first
    with working_bits(600):
        exact = (start_b - second * start_p / (first - third)) * (arb(-first) / start_p) ** arb(beta)
        assert finite(found.coefficient).contains(exact)
        assert found.coefficient.rad() < abs(exact) * arb(relative)
        assert finite(found.time).contains(start_p / -first)
        assert finite(found.beta).contains(beta)
    if beta < 1:
        assert found.case in ("I", "II")
        assert found.side == IMPACT
        assert found.coefficient < 0
    else:
        assert found.case == "III"
        lifts = (1 if exact > 0 else -1) == -(gamma_sign(beta) or 0)
        assert found.side == (LIFT_OFF if lifts else IMPACT)
    assert found.exit_code == 0


@settings(max_examples=3, deadline=None)
@given(
    st.fractions(Fraction(11, 10), 5, max_denominator=12).filter(lambda beta: beta.denominator > 1),
    st.fractions(Fraction(1, 4), 3, max_denominator=8),
    st.fractions(Fraction(1, 8), Fraction(3, 4), max_denominator=16),
    st.fractions(Fraction(1, 8), 4, max_denominator=16),
)
def test_the_model_at_random(beta: Fraction, rate: Fraction, p: Fraction, ratio: Fraction) -> None:
    """b is a multiple of b_bar: one side or the other, and C_1 in closed form."""
    mechanism = MODEL.with_parameters(alpha_1=-rate, alpha_2=-1, alpha_3=-beta * rate)
    middle = -p / (rate * (beta - 1))
    found = approach(mechanism, {"x": 0, "u": 10**6, "p": p, "b": middle * ratio})
    assert found.end == "G-spot"
    with working_bits(600):
        factor = (arb(to_fmpq(rate)) / to_fmpq(p)) ** arb(to_fmpq(beta))
        assert finite(found.coefficient).contains(arb(to_fmpq(middle * (ratio - 1))) * factor)
    if ratio == 1:
        assert found.side is None
    else:
        sign = 1 if ratio < 1 else -1
        assert found.side == (IMPACT if sign == gamma_sign(to_fmpq(beta)) else LIFT_OFF)


def test_lift_off_in_case_two_in_closed_form() -> None:
    """λ = 1 + (λ_0 - 1)(p/p_0)^(-1/2) with α = (-2, 1, -1): from λ_0 = 1/2 it vanishes at p_0/4."""
    found = from_model(model("-2", "1", "-1"), "1/2", "-1/4")
    assert found.end == "lift-off"
    assert found.side is None
    assert found.coefficient is None
    assert finite(found.time).contains(fmpq(3, 16))
    assert found.time.rad() < 1e-30
    with working_bits(160):
        assert arb(dict(found.place)["p"]).contains(fmpq(1, 8))
    assert "lift-off before any G-spot" in str(found)


BRAKED = parse_mechanism(model_text('"u", -1, "v", "b", 1, 1', "-1"))
"""u' = -1 - λ_N and, along slip, b/p = p/2 - c/p: from p = 1/2, b = -1/4 it lifts off with u smaller by 1/4."""


def test_lift_off_is_not_first_where_slip_may_have_stopped() -> None:
    """Slip stops before the lift-off on a surface of the velocity 1/100, and not before on one of -1/100."""
    state = {"x": 0, "u": "1/4", "p": "1/2", "b": "-1/4"}
    assert approach(BRAKED, state, surface_velocity="1/100").end == "slip stops"
    assert approach(BRAKED, state, surface_velocity="-1/100").end == "lift-off"
    found = approach(BRAKED, state, surface_velocity=arb(0, "1/64"))
    assert found.end is None
    assert found.verdict.outcome is Outcome.UNDECIDED


def test_a_ball_of_surface_velocities_is_written_no_wider_than_it_is() -> None:
    """u comes down to 4/3 at the G-spot. Rounded outward the velocities reached up to 1.3334, where slip stops."""
    model, state = shipped_mechanism("model"), {"x": 0, "u": 3, "p": "1/2", "b": "-2"}
    found = approach(model, state, surface_velocity=arb("1.3", "0.033332"))
    assert (found.end, found.surface_velocity) == ("G-spot", "[1.26667, 1.33333]")
    assert "on a surface with the velocity u in [1.26667, 1.33333]" in str(found)
    assert approach(model, state, surface_velocity="1.3334").end == "slip stops"
    side = mechanism_side(model, state, surface_velocity=arb("1.3", "0.033332"))
    assert " on a surface with the velocity u in [1.26667, 1.33333]: for every family" in side.verdict.statement
    exact = approach(model, state, surface_velocity=arb("1.25"))
    assert exact.on_surface == "on a surface with the velocity u = 5/4"


def test_the_least_slip_holds_up_to_the_event() -> None:
    """u falls to -5/4 at the lift-off: a surface a little faster than that is one on which slip stops before."""
    state = {"x": 0, "u": -1, "p": "1/2", "b": "-1/4"}
    found = approach(BRAKED, state)
    assert found.end == "lift-off"
    assert finite(found.least_slip) <= fmpq(-5, 4)
    assert finite(found.least_slip) > fmpq(-13, 10)
    assert approach(BRAKED, state, surface_velocity=finite(found.least_slip) - fmpq(1, 1000)).end == "lift-off"
    assert approach(BRAKED, state, surface_velocity="-1249/1000").end == "slip stops"


def test_the_least_slip_of_a_path_that_stops_is_the_surfaces_velocity() -> None:
    found = approach(BRAKED, {"x": 0, "u": "6/25", "p": "1/2", "b": "-1/4"})
    assert found.end == "slip stops"
    assert abs(finite(found.least_slip)) < fmpq(1, 10**12)


@pytest.mark.parametrize(
    ("friction", "end"),
    [("73/36 + (theta - theta_ref + 1/20)", "slip stops"), ("73/36 + 10*(theta - theta_ref + 1/20)", None)],
)
def test_friction_is_not_negative_on_the_way(friction: str, end: str | None) -> None:
    """mu is 73/36 at the start; where it falls below 0 on the way nothing is proved."""
    text = files("gspot_verified.mechanisms").joinpath("data/falling_rod.toml").read_text(encoding="utf-8")
    rod = parse_mechanism(text.replace('mu = "mu"', f'mu = "{friction}"'))
    found = approach(rod, {"X": 0, "X_dot": 2, "theta": "theta_ref - 1/20", "theta_dot": "-1/2"})
    assert found.end == end
    if end is None:
        assert "friction" in found.side_reason


def test_where_slip_stops_in_closed_form() -> None:
    """du/dt = -λ: u = 1 - 2 t - (4/3)(p_0^(3/2) - p^(3/2))/p_0^(1/2), p = 1/2 - t."""
    found = from_model(MODEL, "1/2", "-2", "1")
    assert found.end == "slip stops"
    time = finite(found.time)
    with working_bits(160):
        p, half = arb(fmpq(1, 2)) - time, arb(fmpq(1, 2))
        slip = 1 - 2 * time - arb(fmpq(4, 3)) * (half * half.sqrt() - p * p.sqrt()) / half.sqrt()
        assert slip.contains(0)
        assert time.rad() < 1e-30


@pytest.mark.parametrize("offset", ["1e-10", "-1e-30"])
def test_next_to_the_distinguished_trajectory(offset: str) -> None:
    """C_1 of 10^-30 has a certain sign; more than 160 bits are taken where they are needed."""
    number = Fraction(-1) + Fraction(offset)
    found = approach(MODEL, {"x": 0, "u": 100, "p": "1/2", "b": number})
    sign = 1 if offset[0] != "-" else -1
    assert finite(found.coefficient) * sign > 0
    assert found.side == (IMPACT if sign > 0 else LIFT_OFF)  # 1/Γ(-3/2) > 0
    with working_bits(600):
        exact = arb(fmpq(sign, 10 ** int(offset.split("-")[-1]))) * arb(2) ** arb(fmpq(3, 2))
        assert found.coefficient.contains(exact)


def test_on_the_distinguished_trajectory() -> None:
    found = from_model(MODEL, "1/2", "-1")
    assert found.end == "G-spot"
    assert found.verdict.outcome is Outcome.PROVED
    assert finite(found.coefficient).contains(0)
    assert found.coefficient.rad() < 1e-30
    assert found.side is None
    assert "too close to the distinguished trajectory" in found.side_reason
    assert found.exit_code == 2
    assert found.bits > 160


def test_an_integer_beta_has_no_side() -> None:
    found = from_model(model("-1", "-1", "-2"), "1/2", "-1/2")
    assert found.end == "G-spot"
    assert found.side is None
    assert "integer" in found.side_reason


def test_the_separatrix_of_case_two_is_undecided() -> None:
    """α = (-2, 1, -1), λ = 1 for ever: neither lift-off nor a force that grows can be proved."""
    found = approach(model("-2", "1", "-1"), {"x": 0, "u": 100, "p": "1/2", "b": "-1/2"}, max_steps=40)
    assert found.end is None
    assert found.verdict.outcome is Outcome.UNDECIDED
    assert found.exit_code == 2


def test_slip_and_p_vanish_together() -> None:
    """From b = -1, u = 1 slip would stop exactly at the G-spot."""
    found = from_model(MODEL, "1/2", "-1", "1")
    assert found.end is None
    assert found.verdict.outcome is Outcome.UNDECIDED
    assert "surface's velocity just where p vanishes" in str(found)


def test_the_time_of_lift_off_is_known() -> None:
    """The contact force falls all the way: the bracket is one of a single instant."""
    steep = shipped_mechanism("frictional impact oscillator", beta="15/2")
    found = approach(steep, {"phi": "phi_ref + 1/10", "phi_dot": "-9/10"})
    assert found.end == "lift-off"
    assert finite(found.time).rad() < 1e-25


# The paper's starts, and second routes by mpmath


def deviation(
    mechanism: Mechanism, beta: mpmath.mpf, at: list[tuple[mpmath.mpf, mpmath.mpf]], alpha_1: mpmath.mpf
) -> mpmath.mpf:
    """C_1 from (p, b) at two small p, against the expansion of Theorem 1 at ε = 0; its error O(p) is extrapolated."""
    series = expand(mechanism, 21).in_time()

    def polynomial(table: dict[tuple[int, int], Any]) -> list[mpmath.mpf]:
        row = {k: value for (k, m), value in table.items() if m == 0}
        return [mpmath.mpf(int(row[k].p)) / int(row[k].q) if k in row else mpmath.mpf(0) for k in range(max(row) + 1)]

    p_of_t, b_of_t = polynomial(series.p)[::-1], polynomial(series.b)[::-1]
    values = []
    for p, b in at:
        t = mpmath.findroot(lambda t, p=p: mpmath.polyval(p_of_t, t) - p, p / alpha_1)
        values.append((b - mpmath.polyval(b_of_t, t)) * (-alpha_1 / p) ** beta)
    ratio = at[0][0] / at[1][0]
    return (ratio * values[1] - values[0]) / (ratio - 1)


def oscillator_slip(state: list[mpmath.mpf]) -> tuple[mpmath.mpf, mpmath.mpf, list[mpmath.mpf]]:
    """p, b and dξ/dt = F - G b/p of the oscillator of Sec. 6 at β = 7/3, κ = 0, from its equations of motion."""
    phi, psi, phi_dot, psi_dot = state
    s, c = mpmath.sin(phi), mpmath.cos(phi)
    beta, mu = mpmath.mpf(7) / 3, mpmath.mpf(25) / 12
    phi_0 = mpmath.acos(mpmath.mpf(3) / 5) + mpmath.mpf(49) / 20 - 7 * beta / 12
    c_psi = 25 * (18 - 7 * beta) / 108
    f = (-(phi - phi_0) - s, -c_psi * psi_dot - 2 - c * phi_dot**2)
    g = (-mu * c + s, mpmath.mpf(1))
    determinant = 2 - s * s

    def accelerations(r: tuple[mpmath.mpf, mpmath.mpf]) -> tuple[mpmath.mpf, mpmath.mpf]:
        return (2 * r[0] - s * r[1]) / determinant, (r[1] - s * r[0]) / determinant

    F, G = accelerations(f), accelerations(g)
    b = F[1] + s * F[0] + c * phi_dot**2
    p = G[1] + s * G[0]
    del psi
    return p, b, [phi_dot, psi_dot, F[0] - G[0] * b / p, F[1] - G[1] * b / p]


def along_p(
    slip: Callable[[list[mpmath.mpf]], tuple[mpmath.mpf, mpmath.mpf, list[mpmath.mpf]]],
    start: list[mpmath.mpf], small: list[str], rate: Callable[[list[mpmath.mpf]], mpmath.mpf],
) -> list[tuple[mpmath.mpf, mpmath.mpf]]:  # fmt: skip
    """(p, b) where p has these values: integration with log p as the time, ``rate`` being dp/dt."""
    p_0 = slip(start)[0]

    def field(_: mpmath.mpf, state: list[mpmath.mpf]) -> list[mpmath.mpf]:
        p, _, velocity = slip(state)
        return [-p * v / rate(state) for v in velocity]  # d/dσ with p = p_0 exp(-σ)

    solution = mpmath.odefun(field, 0, start)
    found = []
    for text in small:
        state = solution(mpmath.log(p_0 / mpmath.mpf(text)))
        p, b, _ = slip(list(state))
        found.append((p, b))
    return found


@pytest.mark.parametrize(
    ("phi_dot", "side"), [("-9/10", LIFT_OFF), pytest.param("-1/2", IMPACT, marks=pytest.mark.slow)]
)
def test_the_two_starts_of_the_paper(phi_dot: str, side: str) -> None:
    """Sec. 6.2: the first start lifts off, the second takes an impact; C_1 by an integration in mpmath."""
    found = approach(OSCILLATOR, {"phi": "phi_ref + 1/10", "phi_dot": phi_dot})
    assert found.end == "G-spot"
    assert found.case == "III"
    assert found.side == side
    assert found.solved == ("psi", "psi_dot")
    with mpmath.workdps(16):
        phi = mpmath.acos(mpmath.mpf(3) / 5) + mpmath.mpf(1) / 10
        velocity = mpmath.mpf(phi_dot.split("/")[0]) / int(phi_dot.split("/")[1])
        start = [phi, mpmath.cos(phi) - 1, velocity, -mpmath.sin(phi) * velocity]

        def rate(state: list[mpmath.mpf]) -> mpmath.mpf:
            """dp/dt = p'(φ) φ', p = (1 + s² - ... )/(2 - s²) differentiated numerically."""
            h = mpmath.mpf(10) ** -6
            ahead, behind = (oscillator_slip([state[0] + e, *state[1:]])[0] for e in (h, -h))
            return (ahead - behind) / (2 * h) * state[2]

        points = along_p(oscillator_slip, start, ["4e-4", "2e-4"], rate)
        alpha_1 = -mpmath.mpf(175) / 408
        close(finite(found.coefficient), deviation(OSCILLATOR, mpmath.mpf(7) / 3, points, alpha_1), 5e-3)


@pytest.mark.parametrize("b", ["-1/2", "-1/4"])
def test_the_extended_system_by_mpmath(b: str) -> None:
    found = approach(EXTENDED, {"x": 0, "u": 3, "p": "1/4", "b": b})
    assert found.end == "G-spot"

    def slip(state: list[mpmath.mpf]) -> tuple[mpmath.mpf, mpmath.mpf, list[mpmath.mpf]]:
        """χ = 1, α = (-1, -1, -3/2): dp/dt = -1 + b, db/dt = -1 + 3/2 λ."""
        p, value = state
        return p, value, [-1 + value, -1 - mpmath.mpf(3) / 2 * value / p]

    with mpmath.workdps(25):
        start = [mpmath.mpf(1) / 4, mpmath.mpf(b.split("/")[0]) / int(b.split("/")[1])]
        points = along_p(slip, start, ["2e-4", "1e-4"], lambda state: -1 + state[1])
        close(finite(found.coefficient), deviation(EXTENDED, mpmath.mpf(3) / 2, points, mpmath.mpf(-1)), 1e-3)


def test_the_rod_by_mpmath() -> None:
    """Case II: b/p^β at a tiny p, from the rod's own two equations for θ."""
    found = approach(ROD, {"X": 0, "X_dot": 2, "theta": "theta_ref - 1/20", "theta_dot": "1/2"})
    assert found.case == "II"
    assert found.side == IMPACT
    with mpmath.workdps(20):
        mu, g = mpmath.mpf(73) / 36, mpmath.mpf(3) / 5

        def scalars(theta: mpmath.mpf, omega: mpmath.mpf) -> tuple[mpmath.mpf, mpmath.mpf, mpmath.mpf]:
            s, c = mpmath.sin(theta), mpmath.cos(theta)
            turn = -3 * c + 3 * mu * s
            return 1 - c * turn, -g + s * omega**2, turn

        def field(_: mpmath.mpf, state: list[mpmath.mpf]) -> list[mpmath.mpf]:
            p, b, turn = scalars(*state)
            return [p * state[1], -b * turn]

        start = [mpmath.asin(mpmath.mpf(3) / 5) - mpmath.mpf(1) / 20, mpmath.mpf(1) / 2]
        p, b, _ = scalars(*mpmath.odefun(field, 0, start)(7))
        first, third = mpmath.mpf(-55) / 12, mpmath.mpf(-3) / 2
        close(finite(found.coefficient), b * (-first / p) ** (third / first), 1e-2)


# Which surface


def test_the_oscillator_needs_a_moving_surface() -> None:
    state = {"phi": "phi_ref + 1/10", "phi_dot": "-1/2"}
    found = approach(OSCILLATOR, state)
    assert found.surface_velocity is None
    assert finite(found.least_slip) < arb("-0.6")  # u = -3/5 at the G-spot: the bound holds up to there
    assert "on a surface that moves with a velocity below " in str(found)
    moving = approach(OSCILLATOR, state, surface_velocity=-1)
    assert moving.side == IMPACT
    assert moving.warnings == ()
    slow = approach(OSCILLATOR, state, surface_velocity="-1/2")
    assert slow.end == "slip stops"
    with pytest.raises(StateError, match="no positive slip: u = "):
        approach(OSCILLATOR, state, surface_velocity=0)


# What is refused


@pytest.mark.parametrize(
    ("state", "message"),
    [
        ({"x": 0, "u": 1, "p": "-1/2", "b": -1}, "p = -0.5.* is not certainly positive"),
        ({"x": 0, "u": 1, "p": 0, "b": -1}, "p = 0 is not certainly positive"),
        ({"x": 0, "u": 1, "p": "1/2", "b": 1}, "b = 1.* is not certainly negative"),
        ({"x": 0, "u": 1, "p": "1/2", "b": 0}, "b = 0 is not certainly negative"),
        ({"x": 0, "u": 0, "p": "1/2", "b": -1}, "no positive slip: u = 0"),
        ({"x": 0, "u": 1, "p": "1/2", "b": -1, "w": 1}, "'w' is no component of the state; it has: x, u, y, v, p, b"),
        ({"x": 0, "u": 1, "p": "1/2"}, "missing: y, v, b"),
        ({"x": 0, "u": 1, "p": "1/2", "b": -1, "y": 0}, "missing: v"),
        ({"x": 0, "u": 1, "p": "1/2", "b": -1, "y": "1/10", "v": 0}, r"not on the contact: y = \[0.1"),
        ({"x": 0, "u": 1, "p": "1/2", "b": -1, "y": 0, "v": "1e-50"}, "not on the contact: v = "),
        ({"x": 0, "u": 1, "y": 0, "v": 0}, "do not certainly determine p and b"),
        ({"x": 0, "u": 1, "p": 0.5, "b": -1}, "[^p]: p: a float is not taken as exact"),
        ({"x": 0, "u": 1, "p": "1/0", "b": -1}, "p: "),
        ({"x": 0, "u": 1, "p": "b", "b": -1}, "p: unknown name 'b'"),
    ],
)  # fmt: skip
def test_states_that_are_refused(state: dict[str, Any], message: str) -> None:
    with pytest.raises(StateError, match=message):
        approach(MODEL, state)


def test_a_start_without_an_inertia_is_refused() -> None:
    """Its fields divide by 1 - p."""
    with pytest.raises(MechanismError, match="model system: what gives inertia and friction has no value at the start"):
        approach(MODEL, {"x": 0, "u": 1, "p": 1, "b": -1})


def test_a_mechanism_without_a_value_is_refused() -> None:
    with pytest.raises(MechanismError, match="without a value: chi"):
        approach(EXTENDED.with_parameters(chi=None), {"x": 0, "u": 1, "p": "1/2", "b": -1})


def test_a_full_state_on_the_contact() -> None:
    found = approach(MODEL, {"x": 0, "u": 9, "y": 0, "v": 0, "p": "1/2", "b": -2})
    assert found.solved == ()
    assert found.end == "G-spot"


def test_without_a_damper_no_side_is_named() -> None:
    """As ε → 0 nothing is damped: an oscillation of the contact stays, and can lose it."""
    damped = model("-1", "-1", "-7/2")
    assert from_model(damped, "1/2", "-1/10").side is not None
    found = from_model(replace(damped, regularisation=Regularisation.of(1, 1, 0)), "1/2", "-1/10")
    assert found.verdict.outcome is Outcome.PROVED
    assert (found.side, found.side_reason) == (None, "the contact has no damper (c = 0): nothing is damped")
    assert (found.coefficient is None, "the side is" in found.rests_on) == (False, False)
    assert (found.fast_exponent, "oscillation" in str(found)) == (None, False)
