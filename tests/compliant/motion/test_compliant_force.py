"""The motion in contact: the initial state comes back, the equations of motion hold on both sides of the G-spot."""

from __future__ import annotations

import json
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from flint import arb, fmpq
from samples.strategies import ends
from witnesses.contact import moved
from witnesses.theta import contains_witness, to_fraction

from gspot_verified.compliant.model.force_result import CompliantForce
from gspot_verified.compliant.model.normal_form import compliant_model, compliant_state, deviation
from gspot_verified.compliant.motion.compliant_force import SlowMotions, force
from gspot_verified.compliant.motion.contact_series import carried
from gspot_verified.leading_order.contact_force import contact_force
from gspot_verified.numbers.balls import relative_bits, working_bits
from gspot_verified.numbers.verdict import Reason

MODELS = [("3/2", "1/10"), ("1/2", "1"), ("13/2", "1/40"), (3, "1/20"), ("5/2", "1/1000")]
NAMES = ("force", "b", "y", "v", "z")


def some_state(model):
    small = model.epsilon
    return compliant_state("1/2", "-2/3", small**2 * fmpq(-5, 2), small / 7, -(small**2))


def number(value: fmpq) -> mpmath.mpf:
    return mpmath.mpf(int(value.p)) / int(value.q)


def expected(model, state, duration: fmpq) -> tuple[fmpq, dict[str, Fraction]]:
    """Force, b, y, v, z after the time ``duration`` from the power series of the equations of motion, in the paper's
    units."""
    hats = deviation(model, state)
    sigma, small = model.sigma, model.scaled_epsilon
    with mpmath.workdps(60):
        start = [number(value) for value in (hats.b, hats.V, hats.Y, hats.Z)]
        steps = max(40, int(duration / model.epsilon) * 4)
        (b, V, Y, Z), p = moved(
            start, number(hats.p), number(hats.beta), number(small), number(duration / model.epsilon), steps
        )
        mean, unit, eps = number(model.mean_force), number(sigma), number(small)
        values = {
            "force": (Z - Y) / unit**2 + mean,
            "b": b / unit**2 - p * mean,
            "y": eps**2 * (Y - 2 * mean * unit**2),
            "v": eps * V / unit,
            "z": eps**2 * (Z - mean * unit**2),
        }
        return state.p + model.alpha_1 * duration, {name: to_fraction(value) for name, value in values.items()}


def check(found: CompliantForce, values: dict[str, Fraction]) -> None:
    assert found.reached
    for name in NAMES:
        assert contains_witness(getattr(found, name), values[name], 13), name
        assert relative_bits(getattr(found, name)) > 40, name


@pytest.mark.parametrize(("beta", "epsilon"), MODELS)
def test_the_initial_state_comes_back(beta, epsilon) -> None:
    model = compliant_model(beta, epsilon)
    state = some_state(model)
    found = force(model, state, "-1/2", digits=20)
    exact = {"force": (state.z - state.y) / model.epsilon**2, "b": state.b, "y": state.y, "v": state.v, "z": state.z}
    check(found, {name: Fraction(int(value.p), int(value.q)) for name, value in exact.items()})


@pytest.mark.parametrize(("beta", "epsilon"), MODELS)
@pytest.mark.parametrize("duration", [fmpq(2), fmpq(9)])
def test_it_solves_the_equations_of_motion(beta, epsilon, duration: fmpq) -> None:
    model = compliant_model(beta, epsilon)
    state = some_state(model)
    p, values = expected(model, state, duration * model.epsilon)
    found = force(model, state, -p, digits=16)
    assert found.p == p
    check(found, values)


@pytest.mark.parametrize("alpha_2", ["-1", "2/3"])
def test_units_of_the_paper(alpha_2: str) -> None:
    model = compliant_model(alpha_1="-3", alpha_2=alpha_2, alpha_3="-7/2", epsilon="1/50")
    state = some_state(model)
    p, values = expected(model, state, fmpq(1, 20))
    check(force(model, state, -p / 3), values)
    # b-dot = alpha_2 - alpha_3 lambda and y-dot = v, by differences.
    time, step = fmpq(-1, 9), fmpq(1, 10**9)
    before, here, after = (force(model, state, time + k * step, digits=40) for k in (-1, 0, 1))
    with working_bits(200):
        change = (after.b - before.b) / (2 * step) - (arb(model.alpha_2) - model.alpha_3 * here.force)
        speed = (after.y - before.y) / (2 * step) - here.v
        assert abs(change) < arb(10) ** -12
        assert abs(speed) < arb(10) ** -12 * abs(here.v)
        # lambda = (z - y)/epsilon^2
        assert (here.force - (here.z - here.y) / model.epsilon**2).contains(0)


@pytest.mark.parametrize("epsilon", ["1e-5", "1e-12", "1e-100", "1e-300"])
def test_small_epsilon_needs_the_fast_part_only_as_a_bound(epsilon: str) -> None:
    model = compliant_model("5/2", epsilon)
    small, p = model.epsilon, fmpq(1, 2)
    b = -2 * p * abs(model.mean_force)
    state = compliant_state(p, b, 2 * small**2 * b / p, 0, small**2 * b / p)
    found = force(model, state, "-1/4", digits=25)
    assert found.reached
    assert found.fast_by_bound
    # At leading order lambda-hat falls like p^(3/2): 4/3 - 2/3 = 2/3 of it is left at p = 1/4.
    with working_bits(100):
        rough = fmpq(2, 3) * (1 + arb(fmpq(1, 2)) ** fmpq(3, 2))
        assert abs(found.force - rough) < 200 * arb(small) + arb(10) ** -20
    # At the start nothing is gained by the bound: the power series about the state serves there.
    start = force(model, state, "-1/2")
    assert start.reached
    assert start.by_series
    assert contains_witness(start.force, Fraction(4, 3), 14)


def test_between_the_series_and_the_bound_the_result_says_what_it_did_not_reach() -> None:
    model = compliant_model("5/2", "1e-300")
    small = model.epsilon
    state = compliant_state("1/2", "-2/3", small**2 * fmpq(-5, 2), small / 7, -(small**2))
    found = force(model, state, fmpq(-1, 2) + 4000 * small)
    assert not found.reached
    assert found.reason is Reason.BUDGET
    assert force(model, state, fmpq(-1, 2) + 20_000 * small).reached


@pytest.mark.parametrize(("epsilon", "late"), [("1e-6", 1200), ("1e-12", 1500)])
def test_first_instants_at_small_epsilon(epsilon: str, late: int) -> None:
    """The bound of the fast part and the power series overlap where both serve, and join without a gap."""
    model = compliant_model("5/2", epsilon)
    state = some_state(model)
    for duration, by_series in ((1, True), (100, True), (450, True), (late, False)):
        found = force(model, state, fmpq(-1, 2) + duration * model.epsilon)
        assert found.reached
        assert found.by_series is by_series
        if duration == 1:
            _, values = expected(model, state, model.epsilon)
            check(found, values)
    series = carried(deviation(model, state), fmpq(late), 400)
    with working_bits(400):
        assert relative_bits(series["force"]) > 50
        assert found.force.overlaps(series["force"] + model.mean_force)


def test_from_a_state_at_or_after_the_g_spot_for_some_time() -> None:
    """By the power series alone: soon after the state it serves, long after it the time is refused."""
    model = compliant_model("5/2", "1/10")
    small = model.epsilon
    for p in ("0", "-1/10"):
        state = compliant_state(p, "-1/3", -2 * small**2, small / 7, -(small**2))
        found = force(model, state, -state.p + 2 * small)
        assert found.by_series
        check(found, expected(model, state, 2 * small)[1])
        with pytest.raises(ValueError, match="too long after an initial state"):
            force(model, state, 10_000)


@pytest.mark.parametrize("alpha_1", [-1, -3])
def test_the_force_is_the_sum_of_its_parts(alpha_1: int) -> None:
    model = compliant_model("5/2", "1/10", alpha_1=alpha_1)
    found = force(model, some_state(model), "1/50", digits=20)
    assert not found.by_series
    assert not found.fast_by_bound
    with working_bits(100):
        assert abs(found.slow + found.fast - found.force) < arb(10) ** -18
        assert abs(found.fast) > arb(10) ** -6


def test_where_the_quadrature_does_not_serve_the_series_does(monkeypatch: pytest.MonkeyPatch) -> None:
    model = compliant_model("5/2", "1/10")
    state = some_state(model)
    honest = force(model, state, "-1/4")
    monkeypatch.setattr(
        "gspot_verified.compliant.motion.compliant_force.fast_part",
        lambda _, __, names, ___: dict.fromkeys(names, arb(0, 1)),
    )
    found = force(model, state, "-1/4")
    assert (honest.by_series, found.by_series, found.reached) == (False, True, True)
    assert found.force.overlaps(honest.force)


def test_the_slow_manifold_is_near_leading_order_and_solves_the_equations() -> None:
    model = compliant_model("7/3", "1e-60", alpha_1=-2)
    found = force(model, SlowMotions(fmpq(3)), fmpq(10) ** -41, digits=20)
    # kappa^3 = -alpha_1/2 = 1, so tau = t/eps^(2/3).
    tau = fmpq(1, 10)
    leading = contact_force("7/3", alpha_1=-2, c1=3).value(tau, "1e-60", digits=20)
    assert found.reached
    assert abs(found.force - leading) < arb(10) ** -17
    assert found.fast.is_zero()


def test_slow_motion_between_two_times() -> None:
    model = compliant_model("5/2", "1/20")
    first = force(model, SlowMotions(fmpq(2)), "-1/4", digits=60)
    values = {}
    for name in "byvz":
        lower, upper = ends(getattr(first, name))
        middle = (lower + upper) / 2
        values[name] = fmpq(middle.numerator, middle.denominator)
    state = compliant_state("1/4", *(values[name] for name in "byvz"))
    second = force(model, SlowMotions(fmpq(2)), "1/8", digits=20)
    p, later = expected(model, state, fmpq(3, 8))
    assert second.p == p
    check(second, later)
    # From a slow state the fast part is 0 up to the rounding of the state.
    again = force(model, state, "1/8", digits=20)
    assert abs(again.fast) < arb(10) ** -25
    assert again.force.overlaps(second.force)


def test_arrays() -> None:
    model = compliant_model("5/2", "1/100")
    times = np.array([[-0.25, 0.0], [0.125, 0.25]])
    found = force(model, SlowMotions(fmpq(1)), times)
    assert found.shape == (2, 2)
    assert found[1, 0].overlaps(force(model, SlowMotions(fmpq(1)), fmpq(1, 8)).force)
    with pytest.raises(ValueError, match="finite"):
        force(model, SlowMotions(fmpq(1)), np.array([np.nan]))


def test_bad_input() -> None:
    model = compliant_model("5/2", "1/100")
    state = some_state(model)
    with pytest.raises(ValueError, match="before the initial state"):
        force(model, state, "-3/4")
    with pytest.raises(TypeError, match="float"):
        force(model, state, 0.5)
    with pytest.raises(ValueError, match="digits"):
        force(model, state, 0, digits=0)
    with pytest.raises(ValueError, match="too long after an initial state with p <= 0"):
        force(compliant_model("5/2", "1e-9"), compliant_state("-1/2", 1, -1, 0, 1), 1)
    with pytest.raises(TypeError, match="reached"):
        bool(force(model, SlowMotions(fmpq(1)), 0))


def test_json() -> None:
    model = compliant_model("5/2", "1/100")
    data = json.loads(json.dumps(force(model, SlowMotions(fmpq(1)), "1/10").to_json()))
    assert data["reached"] is True
    assert data["p"] == "-1/10"
    assert data["force"].startswith("[")
