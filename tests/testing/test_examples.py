"""Other units and other coordinates give the same trajectory, described otherwise; chi = 0 gives the trivial one."""

from __future__ import annotations

import builtins
import sys
from typing import Any

import pytest
from flint import fmpq
from hypothesis import given, settings
from hypothesis import strategies as st

from gspot_verified.expansion.series.system import System
from gspot_verified.expansion.series.terms import PolynomialTerms
from gspot_verified.expansion.time_series import time_series
from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.functions.expressions import Constant, Cosine, Exponential, Power, Sine, Variable
from gspot_verified.functions.power_series import SeriesOfFunctions
from gspot_verified.functions.rings import RATIONALS
from gspot_verified.testing import (
    check_expansion,
    extended_example,
    in_units,
    polynomials,
    rationals,
    sheared,
    states,
    systems,
)

ORDER = 8
SCALARS = ("p", "b", "y", "v", "z", "lambda_n")
units = st.fractions("1/4", 5, max_denominator=4).map(lambda q: fmpq(q.numerator, q.denominator))


@settings(max_examples=25)
@given(systems(), units, units)
def test_units(system: System, tau: fmpq, length: fmpq) -> None:
    """t = tau t', epsilon = tau epsilon', y = length y': the coefficient of t^k epsilon^m is divided by tau^(k+m)."""
    changed = in_units(system, tau, length)
    check_expansion(changed, 5)
    first, second = expand_system(system, ORDER).in_time(), expand_system(changed, ORDER).in_time()
    speed, force = length / tau, length / tau**2
    unit = {"p": fmpq(1), "b": force, "y": length, "v": speed, "z": length, "lambda_n": force}
    for name, table in first.tables().items():
        factor = unit.get(name, fmpq(1))
        assert second.tables()[name] == {(k, m): c * tau ** (k + m) / factor for (k, m), c in table.items()}, name


def test_beta_has_no_unit() -> None:
    first, second = extended_example(1).check(), in_units(extended_example(1), "2/3", 5).check()
    assert first[2] / first[0] == second[2] / second[0]


@given(systems(), st.data())
def test_coordinates(system: System, data: st.DataObject) -> None:
    """xi_i + q(xi) in the place of xi_i: all scalars stay, xi is mapped term by term."""
    dimension = len(system.point)
    index = data.draw(st.integers(0, dimension - 1))
    shift = data.draw(polynomials([i for i in range(dimension) if i != index], constant=True))
    changed = sheared(system, index, shift)
    compare_coordinates(system, changed, index, shift)


def compare_coordinates(system: System, changed: System, index: int, shift: Any) -> None:
    first, second = expand_system(system, ORDER), expand_system(changed, ORDER)
    for name in SCALARS:
        assert getattr(first, name) == getattr(second, name), name
    terms = PolynomialTerms(RATIONALS)
    forward = Variable(index) + shift
    series = SeriesOfFunctions([forward], terms, RATIONALS)
    series.extend([terms.constant(value) for value in system.point])
    series.extend([terms.zero(1)] * len(system.point))
    for n in range(ORDER):
        series.extend([row[n] for row in first.xi])
        for i in range(len(system.point)):
            expected = series[forward][n + 2] if i == index else first.xi[i][n]
            assert second.xi[i][n] == expected, (i, n)


def test_coordinates_with_transcendental_functions() -> None:
    system = extended_example("3/2")
    shift = Sine(Variable(2)) * Cosine(Variable(1)) + Exponential(Variable(4)) * Power(
        Constant(fmpq(4)) + Variable(5), fmpq(1, 2)
    )
    compare_coordinates(system, sheared(system, 0, shift), 0, shift)


@given(rationals().filter(bool), rationals(), st.sampled_from([fmpq(1, 2), fmpq(5, 3), fmpq(7, 2)]))
def test_the_trivial_solution(a: fmpq, alpha_2: fmpq, beta: fmpq) -> None:
    """chi = 0; paper, modelSysDistP to modelSysDistV: p = alpha_1 t, b = alpha_2/(1 - beta) t, lambda constant."""
    alpha_1 = -abs(a)
    alpha_3 = beta * alpha_1
    series = time_series(extended_example(0, (alpha_1, alpha_2, alpha_3)), 14)
    slope = alpha_2 / (1 - beta)
    assert slope == alpha_1 * alpha_2 / (alpha_1 - alpha_3)
    force = (alpha_2 - slope) / alpha_3

    def table(key: tuple[int, int], value: fmpq) -> dict[tuple[int, int], fmpq]:
        return {key: value} if value != 0 else {}

    assert series.p == table((1, 0), alpha_1)
    assert series.b == table((1, 0), slope)
    assert series.lambda_n == table((0, 0), force)
    assert series.z == table((0, 2), -force)
    assert series.y == table((0, 2), -2 * force)
    assert series.v == {}


def test_chi_scales_with_the_weight() -> None:
    """The term of order n of p and b at chi is that at 1 times chi^(n/2) for even n: b grows with chi."""
    one, three = expand_system(extended_example(1), 7), expand_system(extended_example(3), 7)
    for n in (0, 2, 4, 6):
        assert three.p[n] == one.p[n].scale(fmpq(3) ** (n // 2))
        assert three.b[n] == one.b[n].scale(fmpq(3) ** (n // 2))


@settings(max_examples=20)
@given(systems(), st.data())
def test_states_are_near_the_g_spot(system: System, data: st.DataObject) -> None:
    state = data.draw(states(system, fmpq(1, 8)))
    assert len(state) == len(system.point)
    assert all(abs(value - start) <= fmpq(1, 8) for value, start in zip(state, system.point, strict=True))


@settings(max_examples=20)
@given(systems(max_dimension=7))
def test_drawn_systems_meet_the_hypotheses(system: System) -> None:
    alpha_1, _, alpha_3 = system.check()
    assert alpha_1 < 0
    assert (alpha_3 / alpha_1).q != 1
    assert 4 <= len(system.point) <= 7


def test_without_hypothesis(monkeypatch: pytest.MonkeyPatch) -> None:
    honest = builtins.__import__

    def missing(name: str, *rest: Any) -> Any:
        if name.startswith("hypothesis"):
            raise ImportError(name)
        return honest(name, *rest)

    monkeypatch.setattr(builtins, "__import__", missing)
    for name in [name for name in sys.modules if name.split(".")[0] == "hypothesis"]:
        monkeypatch.delitem(sys.modules, name)
    with pytest.raises(ImportError, match="need hypothesis: pip install hypothesis"):
        systems()
    assert check_expansion(extended_example(1), 3).order == 3
