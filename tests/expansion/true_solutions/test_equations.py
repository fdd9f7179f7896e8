"""Lemma 1 of proofs/uniform.md against the equations themselves, in exact rationals; and what follows from it when a
set of deviations that does not shrink with delta is followed."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
from flint import arb, arb_mat, arb_poly, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from samples.strategies import ends, to_fmpq, to_fraction
from samples.uniform_systems import varying_example
from witnesses.true_solutions import extended_motion

from gspot_verified.expansion.residual import residual_bounds
from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.expansion.trajectory import Trajectory, expand_system
from gspot_verified.expansion.true_solutions.equations import Coupling, DeviationEquations
from gspot_verified.expansion.true_solutions.piece import Rules
from gspot_verified.expansion.true_solutions.track import Track, track
from gspot_verified.numbers.balls import working_bits
from gspot_verified.testing import extended_example

CHI = Fraction(3, 2)
CONTACT = (Fraction(2), Fraction(3), Fraction(1, 2))
NAMES = ["xi_1", "xi_2", "xi_3", "xi_4", "xi_5", "xi_6", "p", "b", "y", "v"]
NOTHING = fmpq(0)
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
    lag = k_2 - kappa
    phi = f + lag / rate * delta * e["v"]
    p = hat["p"] + e["p"]
    with working_bits(128):
        for most, least in ((largest, fmpq(0)), (largest, to_fmpq(delta)), (to_fmpq(delta), to_fmpq(delta))):
            equations = DeviationEquations(trajectory(), most, least)
            place = arb(to_fmpq(s))
            found = equations.coupling(place, [arb(to_fmpq(e[name])) for name in NAMES])
            column = arb_mat([[arb(to_fmpq(e[name]))] for name in NAMES])
            right = (equations.limit(place) + found.matrix) * column + found.fast * arb(to_fmpq(phi))
            for i, name in enumerate(NAMES):
                assert contains(right[i, 0], true[name] - on_hat[name]), name
            assert contains(found.p, p)
            assert equations.lagged(arb(to_fmpq(abs(f))), arb(to_fmpq(e["v"]))) >= arb(to_fmpq(abs(phi)))
        bounds, residual_z = equations.residual(abs(to_fmpq(s)))
    # specialZ as it stands: left minus right, times c delta.
    assert abs(residual["z"] * c * delta) <= ends(residual_z)[1] * delta**6
    assert all(abs(residual[name]) <= ends(one)[1] * delta**6 for name, one in zip(NAMES, bounds, strict=True))
    e_rate = {name: true[name] - slope[name] for name in e}
    f_rate = k_2 * (e_rate["z"] - e_rate["y"]) + kappa * e_rate["y"]
    assert residual["y"] == 0
    assert f_rate == -rate / delta * f - lag * e["v"] - k_2 * residual["z"]
    # (2'), the second equation
    turn = e["b"] + hat["lambda_n"] * e["p"] - kappa * p * e["y"] - lag / rate * delta * p * e["v"] - residual["v"]
    assert delta * (f_rate + lag / rate * delta * e_rate["v"]) == (
        -(rate - lag / rate * delta**2 * p) * phi + lag / rate * delta**2 * turn - k_2 / c * (residual["z"] * c * delta)
    )
    assert contains(equations.rate, rate)
    assert contains(equations.share, lag / rate)
    assert contains(equations.least_rate, rate * 15 / 16)
    assert contains(equations.lag, lag)
    assert contains(equations.kappa, kappa)
    assert contains(equations.damper, k_2 / c)


def varying(delta: fmpq) -> DeviationEquations:
    with working_bits(128):
        return DeviationEquations(expand_system(varying_example(fmpq(3, 2)), 6), delta)


@given(st.integers(0, 4), st.lists(SMALL, min_size=10, max_size=10), st.lists(SMALL, min_size=10, max_size=10))
@settings(max_examples=12)
def test_the_coefficients_hold_those_at_every_smaller_delta(
    part: int, sizes: list[Fraction], moves: list[Fraction]
) -> None:
    """A at delta = part/4 delta_0 and at a state of the tube, from the formulas of the page by hand."""
    largest, s = fmpq(1, 8), Fraction(-1, 2)
    delta = to_fraction(largest) * part / 4
    equations = varying(largest)
    tube = [abs(size) for size in sizes]
    inside = {name: move * size for name, move, size in zip(NAMES, moves, tube, strict=True)}
    hat = {
        name: sum(
            (
                to_fraction(c) * s**k * delta**n
                for n, term in enumerate(terms)
                for k, c in enumerate(term.coefficients())
            ),
            Fraction(0),
        )
        for name, terms in equations.trajectory.terms().items()
    }
    x = [delta**2 * (hat[f"xi_{i + 1}"] + inside[f"xi_{i + 1}"]) for i in range(6)]
    force, p = hat["lambda_n"], hat["p"] + inside["p"]
    kappa, chi, alpha_3 = Fraction(1, 2), Fraction(3, 2), Fraction(-3, 2) + 3 * x[3]
    page = [[Fraction(0)] * 10 for _ in range(10)]
    control = [0, -1, 0, x[4], 0, -alpha_3]
    slopes = {
        (0, 1): 1, (2, 3): 1, (3, 5): 1, (3, 4): force, (4, 5): chi, (4, 3): 2 * x[3], (5, 0): 2, (5, 3): 5 - 3 * force,
        (6, 5): chi, (6, 3): 2 * x[3], (7, 0): 2, (7, 3): 5 - 3 * force,
    }  # fmt: skip
    for (i, j), slope in slopes.items():
        page[i][j] = delta**2 * slope
    for i, value in enumerate(control):
        page[i][8] = -kappa * value
    page[7][8], page[8][9], page[9][7], page[9][6], page[9][8] = (
        kappa * alpha_3,
        Fraction(1),
        Fraction(1),
        force,
        -kappa * p,
    )
    fast = [*control, 0, -alpha_3, 0, p]
    for row, value in zip(page, fast, strict=True):
        row[9] -= Fraction(1, 4) * delta * value  # what phi puts there
    with working_bits(128):
        found = equations.coupling(arb(to_fmpq(s)), [arb(to_fmpq(size)) for size in tube])
        matrix = (equations.limit(arb(to_fmpq(s))) + found.matrix).table()
        states = equations.states(arb(to_fmpq(s)), [arb(to_fmpq(size)) for size in tube])
    assert all(map(contains, states, x))  # xi* = 0; at smaller deviations too
    assert all(state.abs_upper() < 12 * arb(largest) ** 2 for state in states)
    for i in range(10):
        for j in range(10):
            assert contains(matrix[i][j], page[i][j]), (i, j)
            if not page[i][j] and not slopes.get((i, j)) and j not in (8,):
                assert matrix[i][j].contains(0)
                assert matrix[i][j].rad() < 1
    assert all(contains(ball, Fraction(value)) for ball, value in zip(found.fast.entries(), fast, strict=True))
    assert contains(found.force, force)
    for i, j in slopes:  # no wider than delta_0^2 times what the slope can be
        assert matrix[i][j].abs_upper() < 12 * arb(largest) ** 2


@pytest.mark.parametrize("first", [0, 1, 2, 3])
@pytest.mark.parametrize("name", ["xi_4", "p", "lambda_n", "b"])
def test_the_norm_is_the_sum_over_monomials(name: str, first: int) -> None:
    equations, reach = varying(fmpq(1, 8)), fmpq(5, 2)
    page = sum(
        (
            abs(to_fraction(c)) * Fraction(5, 2) ** k * Fraction(1, 8) ** n
            for n, term in enumerate(equations.trajectory.terms()[name])
            for k, c in enumerate(term.coefficients())
            if n >= first
        ),
        Fraction(0),
    )
    with working_bits(128):
        found = equations.norm(name, arb(reach), first)
    assert page <= ends(found)[1] <= page * (1 + Fraction(1, 10**20))
    if first == 0:
        with working_bits(128):
            assert equations.norm(name, arb(reach)) == found
    with working_bits(8):
        assert ends(equations.norm(name, arb(reach), first))[1] >= page


def test_a_residual_is_taken_on_the_next_quarter(monkeypatch: pytest.MonkeyPatch) -> None:
    """Never on a shorter interval of s; and each is computed once."""
    equations, asked = varying(fmpq(1, 8)), list[fmpq]()
    whole = residual_bounds

    def counted(of: Trajectory, s: fmpq, delta: fmpq) -> Any:
        asked.append(s)
        return whole(of, s, delta)

    monkeypatch.setattr("gspot_verified.expansion.true_solutions.equations.residual_bounds", counted)
    with working_bits(128):
        for reach in (fmpq(1), fmpq(3, 4) + fmpq(1, 2**40), fmpq(1, 2), fmpq(1, 100)):
            equations.residual(reach)
        assert asked == [fmpq(1), fmpq(1, 2), fmpq(1, 4)]
        wide = arb(1, (1, -2))
        assert equations.residual_below(wide) == equations.residual(fmpq(5, 4))
        assert asked[3:] == [fmpq(5, 4)]
        equations.residual_below(arb(0))
        assert min(asked) > 0
        for none in (arb("inf"), arb("nan"), arb(0, "inf")):
            bounds, of_z = equations.residual_below(none)
            assert len(bounds) == equations.size
            assert not any(value.is_finite() for value in (*bounds, of_z))
    bounds, of_z = equations.residual(fmpq(1))
    constants = whole(equations.trajectory, fmpq(1), fmpq(1, 8)).constants
    assert [*bounds, of_z] == [constants[name] for name in (*NAMES, "z")]


# Sets that do not shrink: mu = 0, about a deviation of size 1


def followed(chi: int, delta: fmpq, centre: Sequence[str], end: Any = 1, fast: int = 0, least: fmpq = NOTHING) -> Track:
    """Of all delta from ``least``; the fast part is phi."""
    with working_bits(96):
        equations = DeviationEquations(expand_system(extended_example(chi=chi), 8), delta, least)
        values = [arb(fmpq(*map(int, text.split("/")))).mid() for text in centre]
        return track(equations, fmpq(0), fmpq(-1), fmpq(end), values, [arb(0)] * 10, arb(fast))


def misses(found: Track, chi: int, delta: fmpq, centre: Sequence[float], fast: float = 0.0) -> list[str]:
    """The variables of a run by scipy from the centre, with this phi, that are outside of the set at the end."""
    assert found.is_whole
    hat, last = (
        {name: float(value.mid()) for name, value in found.equations.trajectory.evaluate(s, delta).items()}
        for s in (-1, found.end)
    )
    p, b, y, v = (hat[name] + move for name, move in zip("pbyv", centre[6:], strict=True))
    small = int(delta.p) / int(delta.q)
    z = hat["z"] + centre[8] / 2 + fast - small / 4 * centre[9]
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
    found = followed(1, fmpq(1, 128), CENTRE, least=delta / 2)
    assert misses(found, 1, delta, POINT) == []
    assert found.pieces[-1].end_deviations[8].rad() < 0.05


def test_strong_coupling_and_a_fast_start() -> None:
    assert misses(followed(STRONG, fmpq(1, 90), PUSHED, 0), STRONG, fmpq(1, 90), PUSH) == []
    nothing = ["0"] * 10
    assert misses(followed(1, fmpq(1, 32), nothing, 0, fast=1), 1, fmpq(1, 32), [0.0] * 10, fast=1.0) == []


class _NoInitial(Rules):
    def fast_start(self, state: Any, later: fmpq) -> arb:  # noqa: ARG002
        return arb(0)


def test_what_is_left_out_is_missed(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without a part of (c) the true solution is outside; what drives phi is compared in ``test_piece.py``."""
    with monkeypatch.context() as patch:
        patch.setattr("gspot_verified.expansion.true_solutions.track.Rules", _NoInitial)
        assert "b" in misses(followed(1, fmpq(1, 32), ["0"] * 10, 0, fast=1), 1, fmpq(1, 32), [0.0] * 10, fast=1.0)
    whole = DeviationEquations.coupling

    def without_coupling(self: DeviationEquations, s: arb, deviations: Sequence[arb]) -> Coupling:
        return replace(whole(self, s, deviations), matrix=arb_mat(self.size, self.size))

    with monkeypatch.context() as patch:
        patch.setattr(DeviationEquations, "coupling", without_coupling)
        assert "p" in misses(followed(STRONG, fmpq(1, 90), PUSHED, 0), STRONG, fmpq(1, 90), PUSH)


@pytest.mark.parametrize("step", [fmpq(1, 4), fmpq(3)])
def test_what_is_linear_in_s_has_its_slope(step: fmpq) -> None:
    """A_0 by differences, with alpha_1 = -3: all of the motion rests on its derivative."""
    with working_bits(128):
        system = extended_example(chi=1, alpha=(-3, -1, "-9/2"))
        equations = DeviationEquations(expand_system(system, 4), fmpq(1, 8), fmpq(1, 16))
        change = (equations.limit(1 + arb(step)) - equations.limit(arb(1))) / arb(step)
        slope = equations.limit_slope()
        for found, wanted in zip(change.entries(), slope.entries(), strict=True):
            assert found.overlaps(wanted)
            assert (found - wanted).abs_upper() < arb(2) ** -100
        assert slope[9, 8] == arb(fmpq(3, 2))  # -kappa alpha_1


def test_every_term_of_the_force_but_the_mean_turns_p() -> None:
    """Entry (v, p) of A - A_0 is lambda_N minus the mean force, its first order included (0 in the examples)."""
    with working_bits(128):
        equations = DeviationEquations(trajectory(), fmpq(1, 8))
        equations._terms["lambda_n"] = [arb_poly([c]) for c in (1, 16, 64, 0, 0, 0, 0)]
        found = equations.coupling(arb(1), [arb(0)] * 10).matrix[9, 6]
    assert (ends(found)[0] <= 0, contains(found, Fraction(3)), ends(found)[1] < 3 + Fraction(1, 2**20)) == (True,) * 3
