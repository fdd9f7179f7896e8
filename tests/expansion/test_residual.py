"""The constants of the residual: against the residual itself, by mpmath; wrong terms are noticed.

Page: proofs/residual.md.
"""

from __future__ import annotations

import json
import math
import random
from dataclasses import replace
from typing import Any

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from witnesses.expressions import mp, value_of

from gspot_verified import expand, load
from gspot_verified.expansion.majorants import Graded, rest_of_product
from gspot_verified.expansion.residual import ResidualError, _Functions, _Residual, residual_bounds
from gspot_verified.expansion.series.spaces import SpacePolynomial
from gspot_verified.expansion.series.system import System
from gspot_verified.expansion.trajectory import Trajectory, expand_system
from gspot_verified.functions.expressions import (
    Constant,
    Cosine,
    Exponential,
    Expression,
    Power,
    Product,
    Sine,
    Sum,
    Variable,
)
from gspot_verified.functions.rings import BALLS
from gspot_verified.functions.symbols import Symbols
from gspot_verified.numbers.balls import working_bits
from gspot_verified.numbers.dyadic import Dyadic
from gspot_verified.testing import extended_example, sheared, systems

x = [Variable(i) for i in range(6)]
one = Constant(fmpq(1))


def summed(terms: tuple[SpacePolynomial, ...], s: Any, delta: Any, slope: bool = False) -> Any:
    total = mpmath.mpf(0)
    for n, term in enumerate(terms):
        for k, c in enumerate(term.coefficients()):
            total += mp(c) * delta**n * (k * s ** max(k - 1, 0) if slope else s**k)
    return total


def residual(of: Trajectory, s: Any, delta: Any) -> dict[str, Any]:
    """specialX to specialL and the conditions over delta^2, straight from the paper."""
    system = of.system
    scalars = ("p", "b", "y", "v", "z", "lambda_n")
    at = {name: summed(getattr(of, name), s, delta) for name in scalars}
    slope = {name: summed(getattr(of, name), s, delta, slope=True) for name in scalars}
    state, start = (
        [mp(c) + delta**2 * summed(t, where, delta) for c, t in zip(system.point, of.xi, strict=True)]
        for where in (s, mpmath.mpf(0))
    )
    force = at["lambda_n"]
    found = {
        f"xi_{i + 1}": summed(of.xi[i], s, delta, slope=True) - value_of(f, state) - value_of(g, state) * force
        for i, (f, g) in enumerate(zip(system.F, system.G, strict=True))
    }
    found["p"] = slope["p"] - value_of(system.alpha_1, state)
    found["b"] = slope["b"] - value_of(system.alpha_2, state) + value_of(system.alpha_3, state) * force
    found["y"] = slope["y"] - at["v"]
    found["v"] = slope["v"] - at["b"] - at["p"] * force
    found["z"] = delta * slope["z"] + at["z"] + force
    found["lambda_n"] = force - at["z"] + at["y"]
    for name, power in (("p", 2), ("b", 2), ("y", 6), ("v", 4)):
        own = delta**power * summed(getattr(of, name), mpmath.mpf(0), delta)
        found[f"start_{name}"] = (value_of(getattr(system, name), start) - own) / delta**2
    for i, condition in enumerate(system.J):
        found[f"start_J_{i + 1}"] = value_of(condition, start) / delta**2
    return found


def compare(of: Trajectory, s: fmpq, delta: fmpq, points: int = 6, seed: int = 1) -> dict[str, float]:
    """Check the bounds at random points and corners; the largest |residual|/(K delta^M) that was met, by equation."""
    bounds = residual_bounds(of, s, delta).constants
    source = random.Random(seed)
    places = [(s * fmpq(source.randint(-100, 100), 100), delta * fmpq(source.randint(1, 100), 100))
              for _ in range(points)] + [(s, delta), (-s, delta), (fmpq(0), delta)]  # fmt: skip
    reached = dict.fromkeys(bounds, 0.0)
    with mpmath.workdps(120):
        for place, small in places:
            found = residual(of, mp(place), mp(small))
            assert set(found) == set(bounds)
            for name, value in found.items():
                size = abs(value) / mp(small) ** of.order
                top = bounds[name]
                assert top.is_finite(), name
                mantissa, exponent = (int(part) for part in top.man_exp())
                limit = mpmath.ldexp(mpmath.mpf(mantissa), exponent)
                assert size <= limit + mpmath.mpf(10) ** -60, (name, place, small)
                if limit:
                    reached[name] = max(reached[name], float(size / limit))
    return reached


ANALYTIC = sheared(
    sheared(extended_example("1/2"), 5, Sine(x[2]) * x[1] + Exponential(x[0]) - one),
    3,
    Power(one + x[4], fmpq(-1, 2)) - one + Cosine(x[0] + x[4]) * x[1] + Power(x[4], fmpq(2)),
)


@pytest.mark.parametrize("order", [1, 2, 3, 4, 7, 12, 20])
@pytest.mark.parametrize("system", [extended_example(1), extended_example(0), ANALYTIC], ids=["chi", "zero", "sin"])
def test_the_residual_is_within_the_bound_and_not_far_below(system: System, order: int) -> None:
    reached = compare(expand_system(system, order), fmpq(1), fmpq(1, 20))
    assert all(ratio == 0 or ratio > 0.02 for ratio in reached.values()), reached


def test_a_residual_that_is_zero_has_the_constant_zero() -> None:
    constants = residual_bounds(expand_system(extended_example(0), 5), 3, 2).constants
    assert all(value == 0 for value in constants.values())


def test_a_polynomial_system_gets_its_exact_sum() -> None:
    """For chi = 1, M = 3: z' delta + z + lambda = z_2' delta^3 = -8 delta^3."""
    assert residual_bounds(expand_system(extended_example(1), 3), 5, 1).constants["z"] == 8


@settings(max_examples=25)
@given(systems(analytic=True), st.integers(1, 8))
def test_drawn_systems(system: System, order: int) -> None:
    compare(expand_system(system, order), fmpq(1, 2), fmpq(1, 8), points=2)


def test_more_exact_orders_never_hurt_much() -> None:
    trajectory = expand_system(ANALYTIC, 6)
    few, many = (residual_bounds(trajectory, 1, "1/10", extra=n).constants for n in (4, 20))
    for name, value in many.items():
        assert value <= few[name] * fmpq(1001, 1000), name


def test_a_power_whose_base_may_vanish_in_the_box_has_no_bound() -> None:
    trajectory = expand_system(sheared(extended_example(1), 3, Power(one + x[4], fmpq(-1)) - one), 4)
    assert residual_bounds(trajectory, 1, "1/10").constants["v"].is_finite()
    found = residual_bounds(trajectory, 100, 1)
    assert not found.constants["xi_4"].is_finite()
    assert found.to_json()["state"]["xi_4"] is None
    assert ": no bound\n" in str(found)
    assert residual_bounds(trajectory, 1, "1/10").complete
    assert not found.complete


def changed(of: Trajectory, name: str, n: int, element: SpacePolynomial) -> Trajectory:
    terms = list(getattr(of, name))
    terms[n] = terms[n] + element
    return replace(of, **{name: tuple(terms)})


@pytest.mark.parametrize("name", ["p", "b", "y", "v", "z", "lambda_n"])
@pytest.mark.parametrize("n", [0, 2, 6])
def test_a_wrong_coefficient_is_noticed(name: str, n: int) -> None:
    good = expand_system(extended_example(1), 8)
    space = getattr(good, name)[n].n
    element = SpacePolynomial.from_list(space, [0] * space + [fmpq(1, 10**30)]) if space >= 0 else None
    if element is None:
        return
    with pytest.raises(ResidualError, match="equation"):
        residual_bounds(changed(good, name, n, element), 1, "1/10")


def test_a_wrong_start_is_noticed() -> None:
    good = expand_system(extended_example(1), 8)
    component = list(good.xi[3])
    component[4] = component[4] + SpacePolynomial.from_list(3, [1])
    wrong = replace(good, xi=(*good.xi[:3], tuple(component), *good.xi[4:]))
    with pytest.raises(ResidualError):
        residual_bounds(wrong, 1, "1/10")


def later(terms: tuple[SpacePolynomial, ...], shift: fmpq) -> tuple[SpacePolynomial, ...]:
    """The terms of f(s + shift delta^4, delta): they lie in the same spaces."""
    found = []
    for n, own in enumerate(terms):
        total = [fmpq(0)] * max(own.n + 1, 0)
        for j in range(n // 4 + 1):
            for k, c in enumerate(terms[n - 4 * j].coefficients()):
                if k >= j:
                    total[k - j] += fmpq(c) * math.comb(k, j) * shift**j
        found.append(SpacePolynomial.from_list(own.n, total) if own.n >= 0 else own)
    return tuple(found)


def test_the_solution_at_a_later_time_is_another_one() -> None:
    """It solves every equation and starts on the same surfaces; only p = 0 at s = 0 says where the time begins."""
    y, v, p, b = x[:4]
    alpha_1, alpha_2, alpha_3 = Constant(fmpq(-1)), Constant(fmpq(-2)), Constant(fmpq(-3, 2))
    system = System(
        "four", (v, b, alpha_1, alpha_2), (Constant(fmpq(0)), p, Constant(fmpq(0)), Constant(fmpq(3, 2))),
        y, v, p, b, alpha_1, alpha_2, alpha_3, (), (fmpq(0),) * 4,
    )  # fmt: skip
    good = expand_system(system, 8)
    assert all(bound.is_finite() for bound in residual_bounds(good, 1, "1/10").constants.values())
    names = ("p", "b", "y", "v", "z", "lambda_n")
    moved = replace(
        good,
        xi=tuple(later(terms, fmpq(1, 3)) for terms in good.xi),
        **{name: later(getattr(good, name), fmpq(1, 3)) for name in names},
    )
    assert later(good.p, fmpq(0)) == good.p
    with pytest.raises(ResidualError, match="p does not vanish at s = 0"):
        residual_bounds(moved, 1, "1/10")


def test_balls() -> None:
    base = extended_example("1/3")
    system = replace(base, point=(arb(0),) * 6, ring=BALLS)
    exact, balls = (residual_bounds(expand_system(s, 7), 1, "1/10").constants for s in (base, system))
    for name, value in exact.items():
        assert balls[name] >= value
        assert balls[name] <= value * fmpq(101, 100) + fmpq(1, 10**6)


def test_text_and_json() -> None:
    found = residual_bounds(expand_system(extended_example(1), 6), "1/3", "0.1")
    assert str(found).startswith("extended example: |residual| <= K delta^6 for |s| <= 1/3, 0 <= delta <= 1/10, K =")
    data = json.loads(json.dumps(found.to_json()))
    assert (data["order"], data["s"], data["delta"]) == (6, "1/3", "1/10")
    texts = {name: str(Dyadic.from_ball(value)) for name, value in found.constants.items()}
    assert data["start"] == {name[6:]: text for name, text in texts.items() if name.startswith("start_")}
    written = [*data["start"].values(), *data["state"].values(), *data["contact"].values()]
    assert sorted(written) == sorted(texts.values())


def test_the_equations_bear_the_names_of_the_state() -> None:
    found = residual_bounds(expand_system(extended_example(chi=1), 6), s=1, delta="1/10")
    names = ("alpha", "beta", "gamma", "kappa", "mu", "nu")
    titles = [line.split(": ")[0].strip() for line in str(replace(found, state=names)).splitlines()[1:-1]]
    assert titles == [f"equation of {names[int(k[3:]) - 1]}" if k[:3] == "xi_" else k for k in found.constants]
    assert [title for title in titles if "equation" in title] == [f"equation of {name}" for name in names]
    titles = [line.split(": ")[0].strip() for line in str(replace(found, state=())).splitlines()[1:-1]]
    assert titles == list(found.constants)


def test_a_box_of_balls_is_written_as_exact_intervals() -> None:
    s, delta = arb("1", "0.01"), arb("0.1", "0.001")
    data = residual_bounds(expand_system(extended_example(1), 6), s, delta).to_json()
    assert (data["s"], data["delta"]) == (str(Dyadic.from_ball(s)), str(Dyadic.from_ball(delta)))


def test_a_box_of_balls_is_said_no_larger_than_it_is() -> None:
    """Rounded outward |s| <= 1.124 was said of a bound for |s| <= 1.1234567."""
    bounds = residual_bounds(expand_system(extended_example(1), 6), arb(1, "0.1234567"), arb("0.1", "0.01234567"))
    assert "for |s| <= 1.1234, 0 <= delta <= 0.11234, K =" in str(bounds)


@pytest.mark.parametrize("order", [3, 6])
def test_the_rest_of_a_condition_is_divided_by_delta_squared_and_by_delta_to_the_order(
    monkeypatch: pytest.MonkeyPatch, order: int
) -> None:
    """With a rest of 2^40, beside which nothing else counts."""
    monkeypatch.setattr(_Functions, "graded", lambda *_: Graded((), arb((1, 40))))
    found = residual_bounds(expand_system(extended_example(1), order), 1, "1/2").constants
    for name, value in found.items():
        if name.startswith("start_"):
            assert abs(value * fmpq(1, 2 ** (42 + order)) - 1) < fmpq(1, 10**6), name


def shifted(node: Expression, by: tuple[fmpq, ...]) -> Expression:
    """The function of u - by."""
    match node:
        case Variable(index):
            return node + Constant(-by[index])
        case Sum(terms):
            return Sum(tuple(shifted(term, by) for term in terms))
        case Product(left, right):
            return Product(shifted(left, by), shifted(right, by))
        case Power(base, exponent):
            return Power(shifted(base, by), exponent)
        case Sine(argument) | Cosine(argument) | Exponential(argument):
            return type(node)(shifted(argument, by))
    return node


def test_a_system_at_another_point_has_the_same_bounds() -> None:
    by = tuple(fmpq(k, 7) for k in range(1, 7))
    names = ("y", "v", "p", "b", "alpha_1", "alpha_2", "alpha_3")
    moved = replace(
        ANALYTIC,
        point=by,
        **{name: tuple(shifted(part, by) for part in getattr(ANALYTIC, name)) for name in ("F", "G", "J")},
        **{name: shifted(getattr(ANALYTIC, name), by) for name in names},
    )
    assert not any(ANALYTIC.point)
    here, there = (residual_bounds(expand_system(s, 5), 1, "1/10").constants for s in (ANALYTIC, moved))
    assert here.keys() == there.keys()
    for name, value in here.items():
        assert there[name].is_finite()
        assert value * fmpq(999, 1000) <= there[name] <= value * fmpq(1001, 1000), name


def test_a_box_of_one_moment() -> None:
    """s = 0 is a box, and its bounds are at most those of a wider one."""
    trajectory = expand_system(extended_example(1), 6)
    none, some = (residual_bounds(trajectory, s, "1/10").constants for s in (0, 1))
    assert all(none[name].is_finite() and none[name] <= some[name] for name in some)


@pytest.mark.parametrize(
    ("s", "delta", "extra", "error", "message"),
    [
        (-1, 1, 8, ValueError, "s must not be negative"),
        (1, 0, 8, ValueError, "delta must be positive"),
        (1, "-1/2", 8, ValueError, "delta must be positive"),
        (1, 1, 3, ValueError, "extra"),
        (1, 1, True, ValueError, "extra"),
        (1, 1, 8.0, ValueError, "extra must be an int"),
        (0.5, 1, 8, TypeError, "s: a float"),
        (1, 0.5, 8, TypeError, "delta: a float"),
    ],
)
def test_bad_arguments(s: Any, delta: Any, extra: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        residual_bounds(expand_system(extended_example(1), 2), s, delta, extra)


def test_symbols_have_no_bounds() -> None:
    ring = Symbols("chi")
    system = replace(extended_example(1), point=tuple(ring.number(0) for _ in range(6)), ring=ring)
    with pytest.raises(TypeError, match="bounds need numbers: put numbers in the place of the symbols"):
        residual_bounds(expand_system(system, 2), 1, 1)


@given(st.lists(st.integers(0, 5), min_size=1, max_size=6), st.data())
def test_the_rest_of_a_product(left: list[int], data: st.DataObject) -> None:
    size = len(left)
    right = data.draw(st.lists(st.integers(0, 5), min_size=size, max_size=size))
    a, b = data.draw(st.integers(0, 3)), data.draw(st.integers(0, 3))
    found = rest_of_product(Graded(tuple(map(arb, left)), arb(a)), Graded(tuple(map(arb, right)), arb(b)))
    expected = sum(u * w for i, u in enumerate(left) for j, w in enumerate(right) if i + j >= size)
    assert found == expected + a * (sum(right) + b) + sum(left) * b


@pytest.mark.parametrize("place", [0, 1])
def test_a_term_that_is_not_finite_does_not_vanish(place: int) -> None:
    """A ball that is not finite may hold 0, as one does that holds every number."""
    terms = [arb(0), arb(0)]
    terms[place] = arb("nan")
    with working_bits(64):
        of = expand_system(replace(extended_example("1/3"), point=(arb(0),) * 6, ring=BALLS), 4)
        bounds = _Residual(of, arb(1), arb("0.1"), of.order + 8)
        assert not bounds._constant("x", terms, arb(0), abs).is_finite()


def test_it_is_said_that_the_conditions_are_divided() -> None:
    """At delta > 1 the condition itself, here of y at delta = 100, is larger than its constant times delta^order."""
    rod = expand(load("rod"), 4)
    bounds = residual_bounds(rod, 1, 100)
    delta = fmpq(100)  # the expansion is at the G-spot itself for s = 0, where Y is 0
    y = sum((term.at_zero() * delta**n for n, term in enumerate(rod.y)), fmpq(0))
    assert abs(delta**6 * y) > 2 * bounds.start["y"] * delta**4
    assert "in the conditions at s = 0 (start) over delta^2" in str(bounds)
    assert "in the conditions at s = 0 (start) over delta^2" in bounds.to_json()["meaning"]


def test_a_constant_that_cannot_be_written_is_not_stated() -> None:
    """Of sines at a distance of 10^20 the bound has some 10^40 digits."""
    bounds = residual_bounds(expand(load("rod"), 4), 1, "1e10")
    assert not bounds.constants["p"].is_finite()
    assert bounds.to_json()["contact"]["p"] is None
    assert bounds.constants["v"] < 3
