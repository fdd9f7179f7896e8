"""Lemma 1 of proofs/uniform.md against the equations themselves, in exact rationals; and what follows from it when a
set of deviations that does not shrink with delta is followed."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
from flint import arb, arb_mat, fmpq
from hypothesis import given
from hypothesis import strategies as st
from strategies import ends, to_fmpq, to_fraction
from uniform_witness import extended_motion

from gspot_verified.balls import working_bits
from gspot_verified.expansion.regularisation import Regularisation
from gspot_verified.expansion.trajectory import Trajectory, expand_system
from gspot_verified.testing import extended_example
from gspot_verified.uniform.equations import Coupling, DeviationEquations
from gspot_verified.uniform.piece import Rules
from gspot_verified.uniform.track import Track, track

CHI = Fraction(3, 2)
CONTACT = (Fraction(2), Fraction(3), Fraction(1, 2))
NAMES = ["xi_1", "xi_2", "xi_3", "xi_4", "xi_5", "xi_6", "p", "b", "y", "v"]
SMALL = st.fractions(-1, 1, max_denominator=20)


@functools.cache
def trajectory() -> Trajectory:
    system = extended_example(chi=to_fmpq(CHI))
    return expand_system(replace(system, regularisation=Regularisation.of(*map(to_fmpq, CONTACT))), 6)


def polynomials(s: Fraction, delta: Fraction, slope: bool) -> dict[str, Fraction]:
    """The truncated expansion, or its derivative by s."""
    found = {}
    for name, terms in trajectory().terms().items():
        total = Fraction(0)
        for n, term in enumerate(terms):
            used = term.derivative() if slope else term
            total += sum((to_fraction(c) * s**k for k, c in enumerate(used.coefficients())), Fraction(0)) * delta**n
        found[name] = total
    return found


def rates(x: dict[str, Fraction], delta: Fraction) -> dict[str, Fraction]:
    """specialX to specialZ for the extended example, by hand; xi = (x, u, y, v, p, b) over delta^2."""
    k_1, k_2, c = CONTACT
    force = k_2 * (x["z"] - x["y"])
    return {
        "xi_1": delta**2 * x["xi_2"], "xi_2": -force, "xi_3": delta**2 * x["xi_4"],
        "xi_4": delta**2 * x["xi_6"] + delta**2 * x["xi_5"] * force,
        "xi_5": -1 + CHI * delta**2 * x["xi_6"], "xi_6": -1 + Fraction(3, 2) * force,
        "p": -1 + CHI * delta**2 * x["xi_6"], "b": -1 + Fraction(3, 2) * force, "y": x["v"],
        "v": x["b"] + x["p"] * force, "z": (-k_1 * x["z"] - force) / (c * delta),
    }  # fmt: skip


def contains(ball: arb, value: Fraction) -> bool:
    assert ball.is_finite()
    lower, upper = ends(ball)
    return lower <= value <= upper


@given(st.fractions(-2, 2, max_denominator=9), st.integers(1, 30), st.lists(SMALL, min_size=11, max_size=11))
def test_lemma_1_on_the_extended_system(s: Fraction, part: int, moves: list[Fraction]) -> None:
    largest = fmpq(1, 10)
    delta = Fraction(1, 10) * Fraction(part, 30)
    k_1, k_2, c = CONTACT
    kappa, rate = k_1 * k_2 / (k_1 + k_2), (k_1 + k_2) / c
    hat, slope = polynomials(s, delta, False), polynomials(s, delta, True)
    e = dict(zip([*NAMES, "z"], moves, strict=True))
    true = rates({name: hat[name] + e[name] for name in e}, delta)
    on_hat = rates(hat, delta)
    residual = {name: slope[name] - on_hat[name] for name in e}
    force = k_2 * (e["z"] - e["y"])
    f = force + kappa * e["y"]
    with working_bits(128):
        equations = DeviationEquations(trajectory(), largest)
        place = arb(to_fmpq(s))
        found = equations.coupling(place, [arb(to_fmpq(e[name])) for name in NAMES])
        column = arb_mat([[arb(to_fmpq(e[name]))] for name in NAMES])
        right = (equations.limit(place) + found.matrix) * column + found.fast * arb(to_fmpq(f))
        for i, name in enumerate(NAMES):
            assert contains(right[i, 0], true[name] - on_hat[name]), name
        bounds, residual_z = equations.residual(abs(to_fmpq(s)))
    # specialZ as it stands: left minus right, times c delta.
    assert abs(residual["z"] * c * delta) <= ends(residual_z)[1] * delta**6
    assert all(abs(residual[name]) <= ends(one)[1] * delta**6 for name, one in zip(NAMES, bounds, strict=True))
    e_rate = {name: true[name] - slope[name] for name in e}
    f_rate = k_2 * (e_rate["z"] - e_rate["y"]) + kappa * e_rate["y"]
    lag = k_2 - kappa
    assert residual["y"] == 0
    assert f_rate == -rate / delta * f - lag * e["v"] - k_2 * residual["z"]
    assert contains(equations.rate, rate)
    assert contains(equations.lag, lag)
    assert contains(equations.kappa, kappa)
    assert contains(equations.damper, k_2 / c)


# Sets that do not shrink: mu = 0, about a deviation of size 1


def followed(chi: int, delta: fmpq, centre: Sequence[str], end: Any = 1, fast: int = 0) -> Track:
    with working_bits(96):
        equations = DeviationEquations(expand_system(extended_example(chi=chi), 8), delta)
        values = [arb(fmpq(*map(int, text.split("/")))).mid() for text in centre]
        return track(equations, fmpq(0), fmpq(-1), fmpq(end), values, [arb(0)] * 10, arb(fast))


def misses(found: Track, chi: int, delta: fmpq, centre: Sequence[float], fast: float = 0.0) -> list[str]:
    """The variables of a run by scipy from the centre that are outside of the set at the end."""
    assert found.is_whole
    hat, last = (
        {name: float(value.mid()) for name, value in found.equations.trajectory.evaluate(s, delta).items()}
        for s in (-1, found.end)
    )
    p, b, y, v = (hat[name] + move for name, move in zip("pbyv", centre[6:], strict=True))
    z = hat["z"] + centre[8] / 2 + fast
    small = int(delta.p) / int(delta.q)
    (true,) = extended_motion(chi, (-1.0, -1.0, -1.5), small, -1.0, [p, b, y, v, z], [float(int(found.end.p))])
    piece = found.pieces[-1]
    values = dict(zip("pbyv", piece.end_deviations[6:], strict=True))
    with working_bits(96):
        values["lambda_n"] = arb(0, piece.end_fast) - found.equations.kappa * piece.end_deviations[8]
    wrong = []
    for name, ball in values.items():
        lower, upper = ends(ball)
        if not float(lower) - 1e-8 <= true[name] - last[name] <= float(upper) + 1e-8:
            wrong.append(name)
    return wrong


CENTRE = ["0", "-1/4", "0", "0", "0", "1/3", "0", "1/3", "1", "-1/4"]
POINT = [0, -0.25, 0, 0, 0, 1 / 3, 0, 1 / 3, 1, -0.25]
STRONG = 40
PUSHED = ["0", "0", "0", "0", "0", "1", "0", "1", "0", "0"]
PUSH = [0.0, 0, 0, 0, 0, 1, 0, 1, 0, 0]


@pytest.mark.parametrize("delta", [fmpq(1, 128), fmpq(1, 400)])
def test_a_set_of_deviations_holds_the_true_ones(delta: fmpq) -> None:
    found = followed(1, fmpq(1, 128), CENTRE)
    assert misses(found, 1, delta, POINT) == []
    assert found.pieces[-1].end_deviations[8].rad() < 0.05


def test_strong_coupling_and_a_fast_start() -> None:
    assert misses(followed(STRONG, fmpq(1, 90), PUSHED, 0), STRONG, fmpq(1, 90), PUSH) == []
    nothing = ["0"] * 10
    assert misses(followed(1, fmpq(1, 32), nothing, 0, fast=1), 1, fmpq(1, 32), [0.0] * 10, fast=1.0) == []


class _NoForcing(Rules):
    def fed(self, drive: arb, residual_y: arb, residual_z: arb) -> arb:  # noqa: ARG002
        return arb(0)


class _NoInitial(Rules):
    def fast_start(self, state: Any, later: fmpq) -> arb:  # noqa: ARG002
        return arb(0)


def test_what_is_left_out_is_missed(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each part of inequality (c) is needed: without it the true solution is outside."""
    with monkeypatch.context() as patch:
        patch.setattr("gspot_verified.uniform.track.Rules", _NoForcing)
        assert "b" in misses(followed(1, fmpq(1, 128), CENTRE), 1, fmpq(1, 128), POINT)
    with monkeypatch.context() as patch:
        patch.setattr("gspot_verified.uniform.track.Rules", _NoInitial)
        assert "b" in misses(followed(1, fmpq(1, 32), ["0"] * 10, 0, fast=1), 1, fmpq(1, 32), [0.0] * 10, fast=1.0)
    whole = DeviationEquations.coupling

    def without_coupling(self: DeviationEquations, s: arb, deviations: Sequence[arb]) -> Coupling:
        return replace(whole(self, s, deviations), matrix=arb_mat(self.size, self.size))

    with monkeypatch.context() as patch:
        patch.setattr(DeviationEquations, "coupling", without_coupling)
        assert "p" in misses(followed(STRONG, fmpq(1, 90), PUSHED, 0), STRONG, fmpq(1, 90), PUSH)
