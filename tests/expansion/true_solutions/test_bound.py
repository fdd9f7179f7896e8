"""True solutions near the truncated expansion: against runs by scipy and the exact solution of the linear model.

Page: proofs/uniform.md.
"""

from __future__ import annotations

import json
from dataclasses import replace
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import pytest
from flint import arb, fmpq
from samples.strategies import ends
from witnesses.true_solutions import extended_motion, oscillator_motion, oscillator_start

from gspot_verified.compliant.slow.slow_solution import slow_value
from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.expansion.trajectory import Trajectory, expand_system
from gspot_verified.expansion.true_solutions import bound as module
from gspot_verified.expansion.true_solutions.bound import UniformBound, _contact, _largest, uniform_bound
from gspot_verified.expansion.true_solutions.equations import DeviationEquations
from gspot_verified.functions.symbols import Symbols
from gspot_verified.mechanisms.expand import expand
from gspot_verified.mechanisms.shipped import shipped_mechanism
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.testing import extended_example

ALPHA = (-1.0, -1.0, -1.5)


def holds(ball: arb, value: float, slack: float = 0.0) -> bool:
    assert ball.is_finite()
    lower, upper = ends(ball)
    return bool(lower - Fraction(slack) <= Fraction(value) <= upper + Fraction(slack))


def expanded(trajectory: Trajectory, s: Any, delta: Any) -> dict[str, float]:
    return {name: float(value.mid()) for name, value in trajectory.evaluate(s, delta, 25).items()}


@pytest.fixture(scope="module")
def extended() -> UniformBound:
    return uniform_bound(expand_system(extended_example(chi=1), 6), -3, 2, "1/20", within=0)


def test_the_statement_has_every_condition_of_the_corollary() -> None:
    """Corollary 1: slip is positive, and lambda + kappa y is within the distance too, kappa = k_1 k_2/(k_1 + k_2)."""
    system = replace(extended_example(chi=1), regularisation=Regularisation(k_1=fmpq(1), k_2=fmpq(4), c=fmpq(1)))
    statement = uniform_bound(expand_system(system, 4), "-1/8", "1/8", "1/50").verdict.statement
    assert "as long as slip is positive" in statement
    assert "each component of the scaled state, p, b, y, v, and lambda_n + 4/5 y" in statement


@pytest.mark.parametrize("delta", [fmpq(1, 20), fmpq(1, 33), fmpq(1, 80)])
def test_the_extended_system_stays_within_the_bound(extended: UniformBound, delta: fmpq) -> None:
    assert extended.verdict.outcome is Outcome.PROVED
    assert extended.contact.outcome is Outcome.PROVED
    start = expanded(extended.trajectory, -3, delta)
    small = int(delta.p) / int(delta.q)
    places = [fmpq(-5, 2), fmpq(-1), fmpq(0), fmpq(1), fmpq(2)]
    state = [start[name] for name in "pbyvz"]
    motion = extended_motion(1.0, ALPHA, small, -3.0, state, [int(s.p) / int(s.q) for s in places])
    for s, true in zip(places, motion, strict=True):
        found = extended.at(s, delta)
        assert all(holds(found[name], true[name], 1e-9) for name in true)
        centre = expanded(extended.trajectory, s, delta)
        moved = {name: abs(true[name] - centre[name]) / small**6 for name in true}
        if s > -2:  # the bound is no better than needed, and not worse by more than a factor 60
            assert all(float(extended.at(s, delta)[name].rad()) / small**6 < 60 * moved[name] for name in "byv")


def test_the_residual_is_needed(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without it the bound would be 0, and the true solution is not on the polynomials."""
    monkeypatch.setattr(
        DeviationEquations,
        "residual",
        lambda self, reach: ([arb(0)] * self.size, arb(0)),  # noqa: ARG005
    )
    trajectory = expand_system(extended_example(chi=1), 6)
    wrong = uniform_bound(trajectory, -3, 2, "1/20", within=0)
    start = expanded(trajectory, -3, fmpq(1, 20))
    (true,) = extended_motion(1.0, ALPHA, 0.05, -3.0, [start[name] for name in "pbyvz"], [2.0])
    assert not holds(wrong.at(2, "1/20")["y"], true["y"], 1e-9)


@pytest.mark.parametrize("delta", [fmpq(1, 25), fmpq(1, 50)])
def test_the_oscillator_stays_within_the_bound(delta: fmpq) -> None:
    """From a state of the mechanism itself: p, b, y, v, z as in the expansion, phi and phi_dot found from p and b."""
    trajectory = expand(shipped_mechanism("oscillator"), 6)
    small = int(delta.p) / int(delta.q)
    start = expanded(trajectory, -2, delta)
    phi, phi_dot = oscillator_start(small, start["p"], start["b"], start["v"])
    state = [phi, phi_dot, start["y"], start["v"], start["z"]]
    places = [fmpq(-2), fmpq(-1), fmpq(0), fmpq(1), fmpq(2)]
    motion = oscillator_motion(small, -2.0, state, [int(s.p) / int(s.q) for s in places])
    near = max(abs(motion[0][name] - start[name]) for name in motion[0]) / small**6
    bound = uniform_bound(trajectory, -2, 2, delta, within=Fraction(1.01 * near).limit_denominator(1000))
    assert bound.verdict.outcome is bound.contact.outcome is Outcome.PROVED
    for s, true in zip(places, motion, strict=True):
        found = bound.at(s, delta)
        assert all(holds(found[name], true[name], 1e-9) for name in true)


@pytest.mark.parametrize("delta", [fmpq(1, 10), fmpq(1, 20)])
def test_the_exact_slow_solution_of_the_linear_model_is_inside(delta: fmpq) -> None:
    """chi = 0: the expansion is exact, and deviations follow the exact solution at every epsilon."""
    bound = uniform_bound(expand_system(extended_example(chi=0), 4), -3, 2, delta, within=1)
    assert bound.verdict.outcome is Outcome.PROVED
    beta, epsilon = fmpq(3, 2), delta**3

    def slow(s: fmpq) -> dict[str, arb]:
        time = s / delta
        b, *slopes = (slow_value(time, beta, epsilon, k, 10).value for k in range(4))
        force, force_1, force_2 = (slope / (epsilon * beta) for slope in slopes)
        v = -force_2 - 2 * force_1 - b + epsilon * time * force
        y = -force_1 - 2 * force - v
        return {"b": b / delta**2, "v": v / delta, "y": y, "lambda_n": force, "f": force + y / 2}

    start = slow(fmpq(-3))
    size = max(abs(value).upper() for value in start.values())
    for s in (fmpq(0), fmpq(2)):
        (stretch,) = [one for one in bound.stretches if one.start < s <= one.end]
        now = slow(s)
        assert all(abs(now[name]) / size < stretch.constants[name] for name in ("b", "v", "y", "lambda_n"))


def test_a_wider_start_gives_wider_constants(extended: UniformBound) -> None:
    wider = uniform_bound(extended.trajectory, -3, 2, "1/20", within=1000)
    assert all(wider.constants[name] > extended.constants[name] for name in extended.constants)
    assert all(one.constants["b"] >= 1000 for one in wider.stretches[:1])


@pytest.mark.parametrize(("system", "delta"), [("extended", "1/5"), ("oscillator", "1/5")])
def test_too_large_a_delta_is_undecided(system: str, delta: str) -> None:
    source = shipped_mechanism("oscillator") if system == "oscillator" else extended_example(chi=1)
    bound = uniform_bound(expand(source, 8), -3, 3, delta)
    assert bound.verdict.outcome is bound.contact.outcome is Outcome.UNDECIDED
    assert "a smaller delta" in bound.verdict.detail
    with pytest.raises(ValueError, match="lies outside of what is proved"):
        bound.at(3, delta)
    assert bound.to_json()["verdict"]["outcome"] == "undecided"
    json.dumps(bound.to_json())


def test_a_force_that_pulls_is_no_contact() -> None:
    """Case I: the mean force is negative, so the bound is true of the equations, and contact is not."""
    bound = uniform_bound(expand_system(extended_example(chi=1, alpha=(-1, -1, "-1/2")), 6), -1, 1, "1/50")
    assert bound.verdict.outcome is Outcome.PROVED
    assert bound.contact.outcome is Outcome.UNDECIDED


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((1, 1, "1/20"), "start must be less than end"),
        ((0, 1, 0), "delta must be positive"),
        ((0, 1, "1/20", -1), "within must not be negative"),
        ((0, 1, arb(1, 0.5)), "delta must be a rational number"),
    ],
)
def test_bad_input(arguments: tuple[Any, ...], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        uniform_bound(expand_system(extended_example(chi=1), 4), *arguments)


def test_symbols_and_a_missing_damper() -> None:
    from dataclasses import replace

    from gspot_verified.expansion.series.regularisation import Regularisation

    rigid = replace(extended_example(chi=1), regularisation=Regularisation.of(1, 1, 0))
    with pytest.raises(ValueError, match="no damper"):
        uniform_bound(expand_system(rigid, 4), 0, 1, "1/20")
    symbolic = shipped_mechanism("extended system").with_parameters(chi=None)
    assert isinstance(expand(symbolic, 3).system.ring, Symbols)
    with pytest.raises(TypeError, match="need numbers"):
        uniform_bound(expand(symbolic, 3), 0, 1, "1/20")
    with pytest.raises(ValueError, match="delta must lie in"):
        uniform_bound(expand_system(extended_example(chi=0), 2), 0, 1, "1/20").at(0, "1/10")


def test_contact_is_concluded_from_the_least_force_at_every_delta() -> None:
    """lambda-hat + delta^M times the deviation, delta in (0, 1]: on each piece, and only for a whole run."""

    def outcome(*pieces: tuple[float, float], whole: bool = True) -> Outcome:
        equations = SimpleNamespace(small=arb(0).union(arb(1)), trajectory=SimpleNamespace(order=2))
        rows = tuple(SimpleNamespace(mean=arb(mean), force=arb(force)) for mean, force in pieces)
        found: Any = SimpleNamespace(is_whole=whole, pieces=rows, equations=equations)
        return _contact(found, fmpq(1)).outcome

    assert outcome((1, 1.5)) is outcome((1, -0.5)) is outcome((1, 1.5), (3, -2)) is Outcome.PROVED
    for pieces in ([(1, -2)], [(-1, 2)], [(1, 1.5), (1, -1.5)], [(1, -1.5), (1, 1.5)]):
        assert outcome(*pieces) is Outcome.UNDECIDED
    assert outcome((1, 1.5), whole=False) is Outcome.UNDECIDED


def test_one_piece_its_constants_and_the_places_that_are_refused() -> None:
    trajectory = expand_system(extended_example(chi=1), 4)
    found = uniform_bound(trajectory, 0, "1/50", "1/50")
    assert len(found.stretches) == 1
    assert found.within == 1
    assert set(found.constants) == set(found.stretches[0].constants) == set(trajectory.terms())
    table = found.to_json()
    assert table["contact"].keys() == table["stretches"][0]["contact"].keys() != set()
    for place, delta in ((arb(0, 1), "1/60"), (0, arb(1, 1) / 100)):
        with pytest.raises(ValueError, match="must be rational"):
            found.at(place, delta)


def test_where_a_run_fails_is_said() -> None:
    found = uniform_bound(expand_system(extended_example(chi=1), 8), -3, 3, "1/5")
    assert found.verdict.outcome is Outcome.UNDECIDED
    reached = found.stretches[-1].end if found.stretches else found.start
    assert f"fails from s = {reached} on" in found.verdict.detail


def test_how_far_it_was_proved_stands_in_the_text_where_it_is_not_the_whole(extended: UniformBound) -> None:
    reached = extended.stretches[-1].end
    assert len(extended.stretches) > 2
    assert "up to s" not in str(extended)
    assert f"  up to s = {reached}:" in str(replace(extended, end=extended.end + 1)).splitlines()
    assert "up to s" not in str(replace(extended, stretches=(), constants={}))


def test_the_constant_of_the_whole_is_the_largest_of_the_pieces(extended: UniformBound) -> None:
    assert _largest([arb(1), arb(5), arb(2)]) == 5
    for name, constant in extended.constants.items():
        assert all(one.constants[name] <= constant for one in extended.stretches)


def test_the_start_of_phi_holds_that_of_f(monkeypatch: pytest.MonkeyPatch) -> None:
    """Corollary 1: phi_0 = (1 + (l/g) delta_0) E, here l/g = 1/4."""

    class Begun(Exception):
        pass

    def begin(*arguments: Any) -> Any:
        _, radii, fast = arguments[4:7]
        assert all(radius == 3 for radius in radii)
        assert Fraction(3 * 81, 80) <= ends(fast)[1] <= Fraction(3 * 81, 80) * (1 + Fraction(1, 10**9))
        raise Begun

    monkeypatch.setattr(module, "track", begin)
    with pytest.raises(Begun):
        uniform_bound(expand(extended_example(chi=1), 6), -1, 1, "1/20", within=3)
