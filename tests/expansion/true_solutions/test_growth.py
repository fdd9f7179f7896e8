"""Lift-off or impact for every epsilon up to epsilon_0: against runs by scipy and the paper's rule; and each hypothesis
of Theorem U2 is asked for.

Page: proofs/uniform.md.
"""

from __future__ import annotations

import json
import math
from dataclasses import replace
from fractions import Fraction
from functools import cache
from typing import Any

import pytest
from flint import arb, fmpq
from samples.cones import cone_of
from samples.strategies import ends
from witnesses.true_solutions import extended_motion

from gspot_verified.expansion.trajectory import Trajectory, expand_system
from gspot_verified.expansion.true_solutions import side, side_end
from gspot_verified.expansion.true_solutions.bound import BITS
from gspot_verified.expansion.true_solutions.cone_choice import cones
from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.expansion.true_solutions.growth import DeviationCone, EntryDeviation, entry_of, grows
from gspot_verified.expansion.true_solutions.side import UniformSide, uniform_side
from gspot_verified.expansion.true_solutions.side_end import SideEnd
from gspot_verified.expansion.true_solutions.slow_deviation import slow_deviation
from gspot_verified.expansion.true_solutions.track import Track, track
from gspot_verified.mechanisms.expand import expand
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.numbers.balls import ball, working_bits
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.verdict import Outcome, Reason, Verdict
from gspot_verified.scenes.floats.float_run import float_run
from gspot_verified.scenes.scene.file import load_scene
from gspot_verified.scenes.scene.run import IMPACT
from gspot_verified.scenes.scene.scene import Scene
from gspot_verified.signs.gamma.side import gamma_sign
from gspot_verified.testing import extended_example

SHOWN = less(0, 1)
assert SHOWN is not None


def extended(beta: str) -> Trajectory:
    return expand_system(extended_example(chi=1, alpha=(-1, -1, f"-{beta}")), 10)


@cache
def side_of(beta: str, c_1: int, largest: str | fmpq) -> UniformSide:
    return uniform_side(extended(beta), c_1, largest)


def number(value: fmpq) -> float:
    return int(value.p) / int(value.q)


def run(found: UniformSide, delta: fmpq, places: list[float]) -> list[dict[str, float]]:
    """The motion from the middle of the family, a little off, by scipy."""
    small, mu = number(delta), 2 * number(found.beta) - 2
    start = {name: float(value.mid()) for name, value in found.trajectory.evaluate(found.start, delta, 20).items()}
    moves = dict(zip("pbyv", (float(value.mid()) for value in found.deviation[6:]), strict=True))
    p, b, y, v = (start[name] + small**mu * (moves[name] + 9e-4) for name in "pbyv")
    z = start["z"] + small**mu * (moves["y"] + 9e-4) / 2
    alpha = (-1.0, -1.0, -number(found.beta))
    return extended_motion(1.0, alpha, small, number(found.start), [p, b, y, v, z], places)


@pytest.mark.parametrize(
    ("beta", "largest", "c_1"),
    [
        ("3/2", fmpq(1, 50), -1),
        ("5/2", fmpq(1, 100), -1),
        pytest.param("3/2", fmpq(1, 30), -1, marks=pytest.mark.slow),
        pytest.param("3/2", fmpq(1, 30), 1, marks=pytest.mark.slow),
        pytest.param("5/2", fmpq(1, 25), -1, marks=pytest.mark.slow),
        pytest.param("5/2", fmpq(1, 25), 1, marks=pytest.mark.slow),
    ],
)
def test_the_extended_system_takes_the_proved_side(beta: str, largest: fmpq, c_1: int) -> None:
    found = side_of(beta, c_1, largest)
    assert found.verdict.outcome is Outcome.PROVED
    sign = gamma_sign(beta)  # of Gamma(-beta)
    assert sign is not None
    assert found.side == ("lift-off" if c_1 * sign < 0 else "impact")
    assert found.entered is not None
    for delta in (largest, largest / 3):
        last = float(ends(found.latest(delta))[1])
        if found.side == "lift-off":
            places = [number(found.entered) * k / 20 for k in range(-10, 21)]
            assert all(one["lambda_n"] > 0 for one in run(found, delta, places))
        first, reach = number(found.entered), 2.0
        while True:  # no further than needed: afterwards the force of the contact equations is out of all bounds
            places = [min(first + reach * k / 40, last) for k in range(41)]
            forces = [one["lambda_n"] for one in run(found, delta, places)]
            decided = [k for k, value in enumerate(forces) if value < 0 or value > float(found.ends[0].force.mid())]
            if decided or places[-1] == last:
                break
            reach *= 1.5
        assert decided
        assert bool(forces[decided[0]] < 0) is (found.side == "lift-off")


@pytest.mark.parametrize(("c_1", "side"), [(1, "lift-off"), (-1, "impact")])
def test_the_oscillator_of_the_paper(c_1: int, side: str) -> None:
    """Every epsilon <= 10^-6, the paper's among them; C_1 > 0 lifts off, as Gamma(-7/3) < 0.

    Float runs of the oscillator on its contact, from a state of the family, take that side before the latest s.
    """
    found = uniform_side(expand(shipped_mechanism("oscillator"), 10), c_1, "1/100")
    assert (found.side, found.epsilon) == (side, fmpq(1, 10**6))
    assert json.loads(json.dumps(found.to_json()))["side"] == side
    assert ("contact is lost" in str(found)) is (side == "lift-off")
    for delta in (found.delta, found.delta / 2):
        run = float_run(state_of_the_family(found, delta), "LSODA", 1e-9)
        assert run.events[0].name == {"lift-off": "lift-off", "impact": IMPACT}[side]
        assert found.entered is not None
        last = ends(found.latest(delta))[1]
        assert found.entered < run.events[0].lower / delta**2 + found.start < fmpq(*last.as_integer_ratio())


def state_of_the_family(found: UniformSide, delta: fmpq) -> Scene:
    """The oscillator at the middle of the family, in its own units; that it lies in the family is asserted."""
    names = [*(f"xi_{i}" for i in range(1, 5)), *"pbyv"]
    moves = dict(zip(names, found.deviation, strict=True))
    moves["z"] = moves["y"] / 2
    with working_bits(BITS):
        values = found.trajectory.evaluate(found.start, delta, 20)
        size = ball(delta) ** ball(2 * (found.beta - 1))
        units = {name: ball(delta) ** {"y": 6, "z": 6, "v": 4}.get(name, 2) for name in moves}
        middles = {name: (values[name] + size * moves[name]) * units[name] for name in moves}
        at = {name: fmpq(*float(value.mid()).as_integer_ratio()) for name, value in middles.items()}
        unit = float((size * units["p"]).mid()) * float(int(found.within.p) / int(found.within.q))
    phi, phi_dot = math.acos(0.6) + number(at["xi_1"]), -1 + number(at["xi_3"])
    # psi and psi_dot follow from y and v
    assert abs(number(at["y"]) - 1 + math.cos(phi) - (-0.4 + number(at["xi_2"]))) < unit
    assert abs(number(at["v"]) - math.sin(phi) * phi_dot - (0.8 + number(at["xi_4"]))) < unit
    scene = load_scene(
        "oscillator", epsilon=delta**3, until=30 * delta**2, phi=f"phi_ref + {at['xi_1']}", phi_dot=at["xi_3"] - 1,
        **{name: at[name] for name in "yvz"},
    )  # fmt: skip
    first = float_run(scene.with_settings(until=delta**4), "LSODA", 1e-9).samples
    assert first is not None
    for name in "pb":
        assert abs(float(first.columns[name][0]) - number(at[name])) < unit
    return replace(scene, stop_at_force=fmpq(10))


def test_smaller_epsilon_takes_longer() -> None:
    found = side_of("3/2", -1, "1/50")
    assert ends(found.latest("1/1000"))[0] > ends(found.latest("1/50"))[1]
    with pytest.raises(ValueError, match="delta must lie in"):
        found.latest("1/49")


def test_the_time_at_a_delta_is_that_of_the_page() -> None:
    """beta = 3/2, so mu = 1: s = 2 + log(3/delta)/5."""
    ends_of = (SideEnd(fmpq(0), fmpq(1, 4), -1, fmpq(2), cone_of(5), arb(3), arb(0), (), SHOWN),)
    undecided = Verdict.undecided("words", Reason.BUDGET, "why")
    empty: Any = None
    numbers = fmpq(-1), fmpq(3, 2), fmpq(-1), fmpq(1, 4), fmpq(0)
    found = UniformSide(empty, *numbers, (), "lift-off", ends_of, undecided)
    for place in (8, 100):
        assert math.isclose(float(found.latest(fmpq(1, place))), 2 + math.log(3 * place) / 5, rel_tol=1e-14)


def test_undecided_has_no_side_and_names_no_place_where_it_happens() -> None:
    found = side_of("3/2", 1, "1/10")
    assert "after s" not in str(found)
    assert (found.verdict.outcome, found.side, found.entered) == (Outcome.UNDECIDED, None, None)
    with pytest.raises(ValueError, match="nothing is proved"):
        found.latest("1/10")
    assert found.to_json()["side"] is None


@pytest.mark.parametrize(("c_1", "delta"), [(-1, "1/50"), (1, "1/50"), (1, "1/10")])
def test_the_statement_says_that_slip_is_assumed(c_1: int, delta: str) -> None:
    assert "as long as slip is positive" in side_of("3/2", c_1, delta).verdict.statement


def test_the_statement_names_what_is_near() -> None:
    """Corollary 2 asks for |f| <= r delta^mu, too, f = lambda + kappa y less that of the expansion."""
    statement = side_of("3/2", 1, "1/50").verdict.statement
    assert "each component of the scaled state, p, b, y, v, and lambda_n + 1/2 y" in statement
    assert "which is 0 in the slow deviation" in statement


def test_the_radii_hold_the_slow_deviation_and_the_tube(monkeypatch: pytest.MonkeyPatch) -> None:
    """The run begins at the midpoints: the ball of the slow deviation counts, as ``within`` does."""

    class Begun(Exception):
        pass

    def begin(*arguments: Any) -> Track:
        middles, radii, fast = arguments[4:7]
        assert all(value.is_exact() for value in middles)
        assert all(Fraction(3, 4) <= ends(radius)[0] <= Fraction(4, 5) for radius in radii)
        # |phi| <= |f| + (l/g) delta |e_v| = 1/4 + 1/4 1/50 (3/2 + 1/4)
        assert Fraction(25875, 100000) <= ends(fast)[1] <= Fraction(25876, 100000)
        raise Begun

    def wide(equations: DeviationEquations, *_: Any) -> list[arb]:
        return [arb(1, "0.5")] * (equations.dimension + 4)

    monkeypatch.setattr(side, "slow_deviation", wide)
    monkeypatch.setattr(side, "track", begin)
    with pytest.raises(Begun):
        uniform_side(extended("3/2"), 1, "1/50", within="1/4")


def test_a_family_that_holds_both_sides_is_undecided() -> None:
    assert uniform_side(extended("3/2"), 1, "1/100", within=2).side is None


def test_the_force_that_an_impact_exceeds_is_written_exactly() -> None:
    """6.67, as it was rounded, is above 10/3 times the mean force 2."""
    statement = uniform_side(extended("3/2"), 1, "1/50", force="10/3").verdict.statement
    assert statement.endswith("until it exceeds 20/3; p < 0 there")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"c_1": 0}, "C_1 must not be 0"),
        ({"delta": 0}, "delta must be positive"),
        ({"start": 100}, "start must be less than"),
        ({"within": -1}, "within must not be negative"),
        ({"force": 1}, "force must exceed 1"),
    ],
)
def test_bad_input(arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        uniform_side(extended("3/2"), **{"c_1": 1, "delta": "1/50", **arguments})


def test_case_i_is_not_covered() -> None:
    with pytest.raises(ValueError, match="beta must be rational, above 1"):
        uniform_side(extended("1/2"), 1, "1/50")


@pytest.mark.parametrize(("beta", "good"), [("2", True), ("201/100", False)])
def test_beta_is_at_most_one_and_half_the_order(beta: str, good: bool) -> None:
    short = expand_system(extended_example(chi=1, alpha=(-1, -1, f"-{beta}")), 2)
    if good:
        assert uniform_side(short, 1, "1/10").beta == 2
    else:
        with pytest.raises(ValueError, match=r"at most 1 \+ order/2, got 201/100"):
            uniform_side(short, 1, "1/10")


# Each hypothesis of Theorem U2


def test_a_side_rests_on_every_piece_before_it(monkeypatch: pytest.MonkeyPatch) -> None:
    assert "parts cover [-1, " in str(side_of("3/2", -1, "1/50").verdict.evidence)
    monkeypatch.setattr(side_end, "cover", lambda *_: None)
    assert uniform_side(extended("3/2"), -1, "1/50").side is None


@pytest.mark.slow
def test_a_piece_that_is_left_out_or_a_comparison_that_is_not_certain_decides_no_side(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    arguments = (extended("3/2"), -1, "1/50")
    assert "parts cover [-1, " in str(uniform_side(*arguments).verdict.evidence)
    honest = side.track
    for kept in (slice(1, None), slice(0, None, 2)):

        def shorter(*given: Any, kept: slice = kept) -> Track:
            found = honest(*given)
            return replace(found, pieces=found.pieces[kept])

        with monkeypatch.context() as patch:
            patch.setattr(side, "track", shorter)
            assert uniform_side(*arguments).side is None
    monkeypatch.setattr(side_end, "less", lambda *_: None)
    assert uniform_side(*arguments).verdict.outcome is Outcome.UNDECIDED


@pytest.fixture(scope="module")
def accepted() -> tuple[DeviationEquations, EntryDeviation, DeviationCone]:
    with working_bits(BITS):
        equations = DeviationEquations(extended("3/2"), fmpq(1, 100))
        centre = slow_deviation(equations, fmpq(3, 2), fmpq(-1), fmpq(-1))
        middles, radii = [value.mid() for value in centre], [ball(fmpq(1, 1000))] * 10
        found = track(equations, fmpq(1), fmpq(-1), fmpq(2), middles, radii, radii[0])
        entry = entry_of(found, len(found.pieces) - 1)
        assert entry is not None
        for cone in cones(equations, entry, fmpq(1), arb(6)):
            if grows(equations, entry, fmpq(1), cone) is not None:
                return equations, entry, cone
    raise AssertionError("no cone")


CHANGES: dict[str, Any] = {
    "G0 a": lambda cone: replace(cone, a=3 * cone.a, c=3 * cone.c),
    "G0 B": lambda cone: replace(cone, B=cone.a),
    "G0 C": lambda cone: replace(cone, C=cone.c),
    "G1": lambda cone: replace(cone, c=cone.a),
    "G2": lambda cone: replace(cone, a=cone.a / 4),
    "G3": lambda cone: replace(cone, B=cone.C),
    "G4": lambda cone: replace(cone, C=3 * cone.C / 10),
    "G5 state": lambda cone: replace(cone, A=(*cone.A[:5], cone.A[5] / 20)),
    "G5 p": lambda cone: replace(cone, A_p=cone.A_p / 100),
    "G6, G7 box": lambda cone: replace(cone, top=cone.top * 10**6),
}


@pytest.mark.parametrize("change", CHANGES)
def test_a_cone_that_violates_a_hypothesis_proves_nothing(
    accepted: tuple[DeviationEquations, EntryDeviation, DeviationCone], change: str
) -> None:
    equations, entry, cone = accepted
    with working_bits(BITS):
        assert grows(equations, entry, fmpq(1), cone) is not None
        assert grows(equations, entry, fmpq(1), CHANGES[change](cone)) is None


def test_the_cone_that_violates_g4_satisfies_the_conditions_on_c_before_it(
    accepted: tuple[DeviationEquations, EntryDeviation, DeviationCone],
) -> None:
    """(G0) and (G3), the others that name C: so (G4) is what rejects it."""
    _, entry, cone = accepted
    with working_bits(BITS):
        smaller = CHANGES["G4"](cone).C
        assert smaller * entry.V - entry.N > 0
        assert smaller < cone.C


def test_an_entry_that_violates_a_hypothesis_proves_nothing(
    accepted: tuple[DeviationEquations, EntryDeviation, DeviationCone],
) -> None:
    equations, entry, cone = accepted
    wrong = (
        replace(entry, q=entry.q / 3),  # (G2): before the cone opens
        replace(entry, fast=entry.fast * 300),  # f is no longer small
        replace(entry, Y=arb(0, 1)),
        replace(entry, begin=entry.place),
        replace(entry, N=-entry.N),
        replace(entry, p=arb(1)),
    )
    with working_bits(BITS):
        assert all(grows(equations, one, fmpq(1), cone) is None for one in wrong)
        assert grows(equations, entry, fmpq(9), cone) is None  # (G7): M - mu - 1 <= 0
