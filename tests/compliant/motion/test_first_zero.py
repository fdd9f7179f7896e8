"""The force over intervals, and lift-off times of the paper's runs against an independent table.

Page: proofs/force_range.md.
"""

from __future__ import annotations

from fractions import Fraction
from functools import partial
from types import SimpleNamespace
from typing import Any

import mpmath
import pytest
from flint import arb, fmpq
from samples.strategies import ends
from witnesses.contact import moved

from gspot_verified.compliant.model.normal_form import compliant_model, compliant_state, deviation
from gspot_verified.compliant.motion import first_zero as first_zero_module
from gspot_verified.compliant.motion.compliant_force import SlowMotions, contact_motion
from gspot_verified.compliant.motion.compliant_force import force as compliant_force
from gspot_verified.compliant.motion.first_zero import (
    _bracket,
    _cut,
    _outward,
    _unit,
    _value,
    contact_lasts,
    first_zero,
)
from gspot_verified.compliant.motion.force_range import ForceRange, slow_range
from gspot_verified.compliant.motion.rough_zero import rough_zero
from gspot_verified.compliant.slow.slow_solution import slow_value
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.verdict import Outcome

# Lift-off times since the start at p = 1/2, for eps = 10^-3, 10^-6, 10^-9, 10^-12, found by another program.
TABLE = {
    ("3/2", "2"): (
        ".535370832662700301659732",
        ".500548837355422272183459",
        ".500006988019767490965852",
        ".500000082754602407000762",
    ),
    ("3/2", "4"): (
        ".524925091036306656552931",
        ".500465122085727140530454",
        ".500006311710702095781418",
        ".500000076801645855363627",
    ),
    ("5/2", "1/4"): (
        ".566288663127946608647371",
        ".501047427789443215991558",
        ".500013493956241256774775",
        ".500000161432240000284593",
    ),
    ("5/2", "1/2"): (
        ".568845686360494714312932",
        ".501066324919790725019573",
        ".500013657100146048265918",
        ".500000162907481763779018",
    ),
}
CASES = [(*key, f"1e-{3 * k + 3}", value) for key, row in TABLE.items() for k, value in enumerate(row)]


def paper_run(beta: str, nu: str, epsilon: str):
    model = compliant_model(beta, epsilon)
    numerator, _, denominator = nu.partition("/")
    p, small = fmpq(1, 2), model.epsilon
    b = -fmpq(int(numerator), int(denominator or 1)) * p * abs(model.mean_force)
    return model, compliant_state(p, b, 2 * small**2 * b / p, 0, small**2 * b / p)


@pytest.mark.parametrize(("beta", "nu", "epsilon", "printed"), CASES)
def test_lift_off_times_of_the_paper_s_runs(beta: str, nu: str, epsilon: str, printed: str) -> None:
    model, state = paper_run(beta, nu, epsilon)
    found = first_zero(model, state)
    assert found.verdict.outcome is Outcome.PROVED
    assert found.lower is not None
    assert found.upper is not None
    unit = Fraction(1, 2 * 10**24)
    lower, upper = (Fraction(int(v.p), int(v.q)) for v in (found.lower - found.start, found.upper - found.start))
    assert lower - unit <= Fraction(printed) <= upper + unit
    with working_bits(64):
        width = (arb(model.epsilon) / 2).root(3) ** 2 * 2 * arb(10) ** -25
        assert arb(found.upper - found.lower) < 2 * width


def test_the_force_changes_sign_there_by_the_equations_of_motion() -> None:
    model, state = paper_run("3/2", "2", "1e-3")
    found = first_zero(model, state, digits=22)
    assert found.verdict.outcome is Outcome.PROVED
    hats = deviation(model, state)
    with mpmath.workdps(50):
        number = lambda v: mpmath.mpf(int(v.p)) / int(v.q)  # noqa: E731
        for place, sign in ((found.lower, 1), (found.upper, -1)):
            duration = number((place - found.start) / model.epsilon)
            start = [number(v) for v in (hats.b, hats.V, hats.Y, hats.Z)]
            (_, _, Y, Z), _ = moved(start, number(hats.p), number(hats.beta), number(model.epsilon), duration, 800)
            assert (Z - Y + number(model.mean_force)) * sign > 0


@pytest.mark.parametrize("order", [0, 1, 2])
@pytest.mark.parametrize("beta", [fmpq(1, 2), fmpq(3), fmpq(9, 2)])
def test_the_slow_part_over_an_interval_holds_its_values(beta: fmpq, order: int) -> None:
    epsilon = fmpq(1, 30)
    for first, last in ((fmpq(-20), fmpq(-19)), (fmpq(-1), fmpq(2)), (fmpq(3), fmpq(4))):
        found = slow_range(beta, epsilon, first, last, order)
        assert found.is_finite()
        for k in range(5):
            inside = slow_value(first + (last - first) * k / 4, beta, epsilon, order, 20).value
            assert ends(found)[0] <= ends(inside)[0]
            assert ends(inside)[1] <= ends(found)[1]
        narrow = slow_range(beta, epsilon, first, first + (last - first) / 1000, order)
        assert narrow.rad() < found.rad() / 100 + arb(10) ** -12


@pytest.mark.parametrize("beta", [fmpq(2), fmpq(3), fmpq(4)])
def test_the_slow_part_over_an_interval_ends_with_its_last_value(beta: fmpq) -> None:
    """A polynomial whose derivatives are all > 0 or all < 0 there: Taylor's formula is exact at the far end."""
    epsilon, first, last = fmpq(1, 30), fmpq(500), fmpq(600)
    found = slow_range(beta, epsilon, first, last, 0)
    true = [slow_value(place, beta, epsilon, digits=20).value for place in (first, last)]
    sign = 1 if beta.p % 2 == 0 else -1
    assert all(sign * slow_value(first, beta, epsilon, k, 20).value > 0 for k in range(1, int(beta.p) + 1))
    with working_bits(100):
        end, width = found.upper() if sign > 0 else found.lower(), abs(true[1] - true[0])
        assert 0 <= sign * (end - true[1]) + width / 10**12 < width / 10**6
        assert abs(found.mid() - true[0]) <= found.rad()


def test_the_fast_part_is_bounded_where_it_is_largest() -> None:
    """Before the G-spot it falls with time; after it the bound of section 7 is the one at the later end."""
    model, state = paper_run("5/2", "1/2", "1/100")
    motion = contact_motion(model, state)
    force = ForceRange(motion, motion.coefficient(60))
    for first, last, place in ((-3, -1, -3), (-2, 0, -2), (0, 2, 2), (1, 4, 4)):
        over, there = force._fast(fmpq(first), fmpq(last)), force._fast(fmpq(place), fmpq(place))
        assert over.is_finite()
        assert over == there
        for other in range(first, last + 1):
            assert force._fast(fmpq(other), fmpq(other)) <= over
    assert force._fast(fmpq(1), fmpq(1)) < force._fast(fmpq(4), fmpq(4))


def test_the_force_over_an_interval_holds_its_values() -> None:
    model, state = paper_run("5/2", "1/2", "1/100")
    motion = contact_motion(model, state)
    force = ForceRange(motion, motion.coefficient(60))
    for first, last in ((fmpq(-50), fmpq(-49)), (fmpq(-10), fmpq(0)), (fmpq(0), fmpq(3))):
        over, slope = force.over(first, last), force.slope(first, last)
        for k in range(4):
            time = (first + (last - first) * k / 3) * model.epsilon
            value = compliant_force(model, state, time)
            assert over.contains(value.force)
            step = fmpq(1, 10**7)
            following = compliant_force(model, state, time + step * model.epsilon, digits=25)
            with working_bits(100):
                change = (following.force - compliant_force(model, state, time, digits=25).force) / step
                assert slope.overlaps(change)
    assert not force.over(fmpq(-1), fmpq(1)).is_finite()


def test_contact_lasts() -> None:
    model, state = paper_run("5/2", "1/2", "1e-6")
    assert contact_lasts(model, state, "1e-3").outcome is Outcome.PROVED
    assert contact_lasts(model, state, "11e-4").outcome is Outcome.UNDECIDED
    with pytest.raises(ValueError, match="before the initial state"):
        contact_lasts(model, state, -1)


def test_contact_lasts_by_intervals_that_cover_the_time(monkeypatch: pytest.MonkeyPatch) -> None:
    model, state = paper_run("5/2", "1/2", "1e-6")
    assert "covers [-500000, -400000]" in str(contact_lasts(model, state, "-2/5").evidence)
    monkeypatch.setattr(first_zero_module, "less", lambda *_: None)  # nothing is certain
    assert contact_lasts(model, state, "-2/5").outcome is Outcome.UNDECIDED


def test_a_bracket_that_is_rounded_inward_is_none(monkeypatch: pytest.MonkeyPatch) -> None:
    model, state = paper_run("5/2", "1/2", "1e-6")
    assert first_zero(model, state, digits=6).verdict.outcome is Outcome.PROVED
    monkeypatch.setattr(first_zero_module, "_outward", lambda lower, upper: (upper, lower))
    found = first_zero(model, state, digits=6, budget=30)
    assert (found.verdict.outcome, found.lower, found.upper) == (Outcome.UNDECIDED, None, None)


@pytest.mark.parametrize("width", [fmpq(10, 10**6), fmpq(105, 10**7), fmpq(99, 10**6)])
def test_a_bracket_is_rounded_to_one_digit_beyond_its_width(width: fmpq) -> None:
    for first in (fmpq(1, 3), fmpq(-1, 3), fmpq(0), fmpq(1, 7) * 10**5):
        lower, upper = _outward(first, first + width)
        assert lower <= first
        assert first + width <= upper
        for end, inside in ((lower, first), (upper, first + width)):
            assert (end * 10**6).q == 1
            assert abs(end - inside) < fmpq(1, 10**6)


def test_the_width_of_a_bracket_is_the_one_asked_for() -> None:
    """In units of (epsilon/2)^(-1/3): on each side the half of it from the zero."""
    for epsilon, alpha_1 in (("1e-6", -1), ("2e-12", -1), ("1e-6", -8)):
        model = compliant_model(alpha_1=alpha_1, alpha_2=-1, alpha_3=fmpq(5 * alpha_1, 2), epsilon=epsilon)
        motion = contact_motion(model, compliant_state(1, 1, 0, 0, 1))
        with working_bits(100):
            assert (arb(_unit(motion)) ** 3 * model.scaled_epsilon / 2 - 1).abs_upper() < arb(10) ** -14
    model, state = paper_run("5/2", "1/2", "1e-6")
    motion, width = contact_motion(model, state), fmpq(1, 10**5)
    rough = rough_zero(ForceRange(motion, motion.coefficient(60)), fmpq(-(10**6), 2), _unit(motion))
    assert rough is not None
    found = _bracket(motion, (rough - 1, rough, rough + 1), width, 8)
    narrow = _bracket(motion, (rough - 1, rough, rough + 1), width / 10**6, 14)
    assert found is not None
    assert narrow is not None
    assert found.upper - found.lower == width
    assert found.lower + width * 49 / 100 < narrow.lower < narrow.upper < found.upper - width * 49 / 100


@pytest.mark.parametrize("epsilon", ["1e-3", pytest.param("1/9000", marks=pytest.mark.slow)])
def test_a_bracket_by_one_power_series_has_the_signs_of_the_two_parts(epsilon: str) -> None:
    """At 1/1000 it begins with the series from the state, at 1/9000 with the parts themselves."""
    motion = contact_motion(*paper_run("5/2", "1/2", epsilon))
    assert motion.state is not None
    unit = _unit(motion)
    rough = rough_zero(ForceRange(motion, motion.coefficient(60)), motion.state.time, unit)
    assert rough is not None
    found = _bracket(motion, (rough - unit / 16, rough, rough + unit / 16), unit / 10**9, 9)
    assert found is not None
    assert found.upper - found.lower == unit / 10**9
    assert _value(motion, found.lower, 60) > 0 > _value(motion, found.upper, 60)


def test_a_slope_that_is_not_negative_gives_no_bracket(monkeypatch: pytest.MonkeyPatch) -> None:
    model, state = paper_run("5/2", "1/2", "1e-6")
    monkeypatch.setattr(ForceRange, "slope", lambda *_: arb(-1, 2))
    assert first_zero(model, state, digits=6, budget=30).verdict.outcome is Outcome.UNDECIDED


def test_a_run_that_never_lifts_off_has_no_bracket() -> None:
    found = first_zero(*paper_run("3/2", "1/2", "1e-6"))
    assert found.verdict.outcome is Outcome.UNDECIDED
    assert found.lower is None
    with pytest.raises(ValueError, match="digits"):
        first_zero(*paper_run("3/2", "1/2", "1e-6"), digits=0)


def test_the_slow_manifold_needs_no_state() -> None:
    model = compliant_model("5/2", "1/100")
    motion = contact_motion(model, SlowMotions(fmpq(1)))
    value = ForceRange(motion, motion.coefficient(60)).over(fmpq(-5), fmpq(-4))
    assert value.contains(compliant_force(model, SlowMotions(fmpq(1)), fmpq(-9, 200)).force)


@pytest.mark.parametrize("unit", [fmpq(1, 3), fmpq(1), fmpq(10) ** 33])
@pytest.mark.parametrize("begin", [fmpq(-1, 7), fmpq(-17), fmpq(-257, 16), -(fmpq(10) ** 40), -(fmpq(10) ** 100)])
def test_an_interval_is_cut_inside(begin: fmpq, unit: fmpq) -> None:
    for end in (begin / 2, begin / 15, begin / 17, begin / 10**9, fmpq(0), -begin):
        assert begin < _cut(begin, end, unit) < end


def test_a_long_interval_before_the_g_spot_needs_few_cuts() -> None:
    begin, unit, parts = -(fmpq(10) ** 100), fmpq(10) ** 33, 0
    end = fmpq(0)
    while end - begin > unit:
        end, parts = _cut(begin, end, unit), parts + 1
        if -begin <= 16 * -end:
            break
    assert parts < 10


@pytest.mark.parametrize(("beta", "nu", "p"), [("3/2", "2", "1/2"), ("3/2", "2", "-1/4")])
def test_the_first_zero_does_not_depend_on_the_units(beta: str, nu: str, p: str) -> None:
    """alpha_1 = -2 with sigma = 1/2: the same motion, times in halves, by exact_solution.md, section 1."""
    numerator, _, denominator = beta.partition("/")
    power, sigma, small = fmpq(int(numerator), int(denominator)), fmpq(1, 2), fmpq(1, 10**6)
    model = compliant_model(alpha_1=-2, alpha_2=-8, alpha_3=-2 * power, epsilon=small * sigma)
    normal = compliant_model(alpha_1=-1, alpha_2=-1, alpha_3=-power, epsilon=small)
    state = paper_run(beta, nu, "1e-6")[1]
    if p == "-1/4":
        mean = normal.mean_force
        state = compliant_state(p, mean * fmpq(1, 8), -2 * small**2 * mean, small * mean, -fmpq(7, 4) * small**2 * mean)
    scaled = compliant_state(state.p, state.b / sigma**2, state.y, state.v / sigma, state.z)
    one, two = first_zero(normal, state, 8), first_zero(model, scaled, 8)
    assert one.verdict.outcome is two.verdict.outcome is Outcome.PROVED
    assert one.lower is not None
    assert one.upper is not None
    assert two.lower is not None
    assert two.upper is not None
    assert two.start == one.start * sigma
    assert max(one.lower * sigma, two.lower) <= min(one.upper * sigma, two.upper)
    assert two.upper - two.lower < fmpq(1, 10**8)
    if p == "-1/4":
        before = two.start + (two.lower - two.start) * fmpq(99, 100)
        assert contact_lasts(model, scaled, before).outcome is Outcome.PROVED
        assert contact_lasts(model, scaled, two.upper).outcome is Outcome.UNDECIDED


@pytest.mark.parametrize("speed", ["1/100", "1/50"])
def test_a_start_shortly_before_the_lift_off(speed: str) -> None:
    """The margin about the zero would reach back before the start."""
    model, state = compliant_model("3/2", "1/1000"), compliant_state("1/100", -1, "-4e-6", speed, "-2e-6")
    found = first_zero(model, state, digits=6)
    assert found.verdict.outcome is Outcome.PROVED
    assert found.lower is not None
    assert found.upper is not None
    assert state.p / model.alpha_1 < found.lower < found.upper < state.p / model.alpha_1 + model.epsilon * 2


@pytest.mark.parametrize(("first", "last"), [("-1", "1/2"), ("0", "1/2"), ("1/4", "1/2"), ("-1", "-1/2"), ("-1", "2")])
def test_times_before_and_after_the_g_spot_are_covered(first: str, last: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """No piece holds both; with a force that is positive on short pieces only, all of the time is covered."""
    monkeypatch.setattr(first_zero_module, "_unit", lambda _: fmpq(1))
    asked: list[tuple[fmpq, fmpq]] = []

    def over(begin: fmpq, end: fmpq) -> arb:
        asked.append((begin, end))
        return arb(1) if end - begin < fmpq(1, 3) else arb(0, 1)

    force: Any = SimpleNamespace(motion=None, over=over, near=lambda _: 1.0)
    begin, end = (fmpq(*map(int, text.split("/"))) for text in (first, last))
    found = first_zero_module._positive(force, begin, end)
    assert found is not None
    assert f" [{begin}, {end}]" in str(found)
    assert all(one >= 0 or other <= 0 for one, other in asked)
    for place in (begin, end):
        force.over = partial(_open_at, place)
        monkeypatch.setattr(first_zero_module, "_MOST_PIECES", 50)
        assert first_zero_module._positive(force, begin, end) is None


def _open_at(place: fmpq, begin: fmpq, end: fmpq) -> arb:
    return arb(0, 1) if begin <= place <= end else arb(1)
