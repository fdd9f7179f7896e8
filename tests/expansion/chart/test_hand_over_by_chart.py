"""A tube and its hand-over by a chart (proofs/chart.md, sections 3, 4), beside the same system in p, b, y, v."""

from __future__ import annotations

import random
import re
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cache

import pytest
from flint import arb, arb_mat, fmpq
from samples.cones import cone_of

from gspot_verified.expansion.chart.chart import Chart
from gspot_verified.expansion.from_state.affine_hand_over import _slopes, affine_hand_over
from gspot_verified.expansion.from_state.affine_side import (
    _box_text,
    _manifold,
    _Passed,
    _prepared,
    _tube,
    _way,
    affine_side,
    states_text,
)
from gspot_verified.expansion.from_state.affine_system import Affine, AffineSystem
from gspot_verified.expansion.from_state.affine_tube import AffineStart, AffineTube
from gspot_verified.expansion.from_state.hand_over import HandOver
from gspot_verified.expansion.residual import conditions_at
from gspot_verified.expansion.series.regularisation import PAPER
from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.expansion.true_solutions.side_end import SideEnd
from gspot_verified.functions.expressions import Constant, Expression
from gspot_verified.numbers.balls import add_remainder, ball, working_bits
from gspot_verified.numbers.evidence import less
from tests.expansion.chart.folded import B, P, charted, folded

HALF, DELTA, PLACE = fmpq(1, 2), fmpq(1, 400), fmpq(5)
PLACE_OF_PLAN = fmpq(4)
START = fmpq(1, 200)
SHOWN = less(0, 1)
assert SHOWN is not None
END, LATER = (
    SideEnd(fmpq(0), DELTA, 1, fmpq(1), cone_of(1), arb(2), arb(3), tuple(arb(k + more) for k in range(4)), SHOWN)
    for more in (0, 5)
)


def rational(*value: int) -> Expression:
    return Constant(fmpq(*value))


PLAIN = AffineSystem(Affine(fmpq(-1), fmpq(0), fmpq(1)), Affine(fmpq(-1), fmpq(1)), Affine(fmpq(-3, 2), fmpq(2)), PAPER)
BY_CHART = charted(folded(rational(-1) + B, rational(-1) + P, rational(-3, 2) + P * rational(2)))


def start_of(system: AffineSystem, excess: fmpq) -> AffineStart:
    manifold = _manifold(system, 1)
    rigid = AffineStart(manifold, START, fmpq(0), fmpq(0)).excess
    return AffineStart(manifold, START, START * (rigid - excess), fmpq(1, 100))


@cache
def handed(name: str) -> tuple[AffineStart, AffineTube, DeviationEquations, HandOver]:
    system = {"plain": PLAIN, "chart": BY_CHART}[name]
    with working_bits(128):
        start = start_of(system, HALF)
        one = next(_prepared(start))
        tube = _tube(start, one, DELTA**3)
        assert isinstance(tube, AffineTube), tube
        assert one.plan.place == PLACE_OF_PLAN
        equations = DeviationEquations(expand_system(system.system(), 10), DELTA, DELTA)
        found = affine_hand_over(equations, one.start, tube, one.plan.place)
        assert isinstance(found, HandOver), found
        return start, tube, equations, found


def test_the_box_at_the_hand_over_holds_the_state_of_the_expansion_for_every_smaller_delta(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    start, tube, equations, _ = handed("chart")
    asked: list[Sequence[arb]] = []
    monkeypatch.setattr(Chart, "region", lambda _, place: asked.append(place))
    with working_bits(128):
        scaled = -equations.alpha_1 * ball(PLACE_OF_PLAN)
        assert _slopes(equations, start.manifold, tube, scaled, PLACE_OF_PLAN) is None
        for side, name, power in zip(asked[0], ("p", "b", "y", "v"), (2, 2, 6, 4), strict=True):
            assert side.contains(arb(0, equations.norm(name, ball(PLACE_OF_PLAN)) * equations.delta**power))


def test_the_excess_and_the_tube_are_the_same() -> None:
    """What the chart adds is the rest of the Taylor polynomials, which are exact in the other system."""
    (plain, one, _, _), (chart, other, _, _) = handed("plain"), handed("chart")
    assert plain.excess == chart.excess == HALF
    assert plain.b == chart.b
    with working_bits(128):
        for key, value in one.barrier.items():
            assert other.barrier[key] >= value * arb("0.999")
        places = ball(one.rectangle.h), arb("0.01")
        assert one.bound(*places) <= other.bound(*places) * arb("1.001")
        assert other.bound(*places) < 2 * one.bound(*places)


def test_states_of_the_set_lie_in_that_of_the_chart() -> None:
    """Deviations of b, y, v in the set, carried over by the closed form of the state; some reach far into it."""
    start, _, equations, found = handed("chart")
    draw, nearest = random.Random(4), arb(0)
    with working_bits(128):
        delta, s, inverse = equations.delta, ball(-PLACE_OF_PLAN), found.frame.inv()
        unit = delta ** ball(start.manifold.mu)
        p, b, y, v = (equations.expansion(name, s).mid() for name in ("p", "b", "y", "v"))
        curved = [equations.expansion(f"xi_{i + 1}", s).mid() for i in range(4)]
        for _ in range(60):
            ends = [draw.choice([-1, 1, draw.uniform(-1, 1)]) for _ in found.radii]
            u = [c + r * end for c, r, end in zip(found.centre, found.radii, ends, strict=True)]
            _, off_b, off_y, off_v = (found.frame * arb_mat([[value] for value in u])).entries()[4:]
            x = (1 - (1 - 4 * delta**2 * p).sqrt()) / 2
            state = [
                x / delta**2,
                (b + unit * off_b) / (1 + x),
                delta**4 * (y + unit * off_y),
                delta**2 * (v + unit * off_v),
            ]
            off = [(value - own) / unit for value, own in zip(state, curved, strict=True)]
            own = (inverse * arb_mat([[value] for value in [*off, arb(0), off_b, off_y, off_v]])).entries()
            for i in range(4):
                far = abs(own[i].mid() - found.centre[i])
                assert far <= found.radii[i]
                nearest = nearest.max(far / found.radii[i])
        assert nearest > arb("0.2")
        assert found.radii[equations.b] < arb("0.1")


def test_p_b_y_v_of_the_expansions_state_are_near_their_expansions() -> None:
    """At s = -5, by putting the polynomials in; one order fewer is no bound."""
    trajectory = expand_system(BY_CHART.system(), 8)
    bounds = conditions_at(trajectory, -PLACE, DELTA)
    with working_bits(200):
        for small in (DELTA, DELTA / 3):
            terms = {
                name: sum((ball(t(-PLACE)) * ball(small) ** n for n, t in enumerate(one)), arb(0))
                for name, one in trajectory.terms().items()
            }
            x, w, y, v = (ball(small) ** 2 * terms[f"xi_{i + 1}"] for i in range(4))
            d = ball(small)
            wanted = [d**2 * terms["p"], d**2 * terms["b"], d**6 * terms["y"], d**4 * terms["v"]]
            for value, other, bound in zip([x - x * x, (1 + x) * w, y, v], wanted, bounds, strict=True):
                assert abs(value - other) <= bound * d**10
        assert all(bound.is_finite() for bound in bounds)
        assert abs((x - x * x) - wanted[0]) * 1000 > bounds[0] * d**10


def test_a_start_in_balls_holds_each_of_its_starts() -> None:
    with working_bits(128):
        exact = handed("chart")[0]
        wide = replace(exact, p=ball(exact.p) * arb(1, "1e-8"), b=ball(exact.b) * arb(1, "1e-8"))
        assert ball(wide.excess).contains(exact.excess)
        assert wide.size(DELTA**3) >= exact.size(DELTA**3)
        one = next(_prepared(wide))
        tube = _tube(wide, one, DELTA**3)
        assert isinstance(tube, AffineTube), tube
        assert tube.cone.last >= exact.p
        thin = handed("chart")[1]
        for key, value in thin.barrier.items():
            assert tube.barrier[key] >= value * arb("0.999999")
        far = replace(exact, b=ball(exact.b) * arb(1, "0.5"))
        refused = _tube(far, next(_prepared(far)), DELTA**3)
        assert refused == "the excess at the start is not certainly of one sign"


def test_the_starts_are_states_of_the_chart() -> None:
    start, tube, _, _ = handed("chart")
    with working_bits(128):
        chart = BY_CHART.chart
        assert chart is not None
        way = _way(start, chart, [_Passed(tube.cone, arb(2)), _Passed(tube.cone, arb(3))], [END, LATER])
        assert way is not None
        p, b = ball(start.p), ball(start.b)
        x = (1 - (1 - 4 * p).sqrt()) / 2
        for side, value in zip(way.starts.states, (x, b / (1 + x), arb(0), arb(0)), strict=True):
            assert side.contains(value.mid())
            assert side.rad() < arb("1e-5")
        assert way.cone == tube.cone
        assert way.later == 3
        assert all(box.contains(k) and box.contains(k + 5) for k, box in enumerate(way.after))
        beyond = replace(start, p=fmpq(3, 10), b=fmpq(-3, 5))
        assert _way(beyond, chart, [_Passed(tube.cone, arb(2))], [END]) is None


def test_the_starts_that_are_written_are_among_those_of_the_proof() -> None:
    """p, b, L and the state: as written they are no wider than the balls, by whose text they were up to six times."""
    start, tube, _, _ = handed("chart")
    with working_bits(128):
        chart = BY_CHART.chart
        assert chart is not None
        p, b = (add_remainder(ball(value), abs(ball(value)) * arb((1, -20))) for value in (start.p, start.b))
        quotient = add_remainder(ball(start.force), ball(start.force) * arb((1, -22)))
        wide = replace(start, p=p, b=b, quotient=quotient)
        way = _way(wide, chart, [_Passed(tube.cone, arb(2))], [END])
        assert way is not None
        text = f"{states_text(wide)}; {_box_text(chart, way.starts)}"
        written = [[Fraction(end) for end in pair] for pair in re.findall(r" in \[([^,]+), ([^\]]+)\]", f" {text}")]
        balls = [p, b, quotient, ball(wide.excess), *way.starts.around]
        assert len(written) == len(balls)
        for (lower, upper), value in zip(written, balls, strict=True):
            for end in (lower, upper):
                assert value.contains(ball(fmpq(end.numerator, end.denominator)).mid())
            assert ball(fmpq(upper.numerator, upper.denominator)) - ball(
                fmpq(lower.numerator, lower.denominator)
            ) > value.rad() * arb("1.9")
        assert all(map(arb.contains_interior, way.starts.around, way.starts.states))


@pytest.mark.slow
@pytest.mark.parametrize(("excess", "side"), [(HALF, "lift-off"), (-HALF, "impact")])
def test_the_side_is_that_of_the_plain_system(excess: fmpq, side: str) -> None:
    found = [affine_side(system, START, start_of(system, excess).b) for system in (PLAIN, BY_CHART)]
    plain, by_chart = found
    assert (plain.side, by_chart.side) == (side, side)
    assert plain.epsilon / 8 < by_chart.epsilon <= plain.epsilon * 8
    assert plain.way is None
    assert by_chart.way is not None
    assert " and the state in x in [0.00" in by_chart.verdict.statement
