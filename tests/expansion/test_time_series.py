"""The second route: the series in (t, epsilon) from the original equations."""

from __future__ import annotations

from dataclasses import replace

import pytest
from flint import arb, fmpq

from gspot_verified.expansion import time_series as module
from gspot_verified.expansion.series.system import GSpotError
from gspot_verified.expansion.time_series import TimeSeries, compare_routes, time_series
from gspot_verified.expansion.trajectory import expand_system
from gspot_verified.functions.rings import BALLS
from gspot_verified.numbers.verdict import Outcome
from gspot_verified.testing import extended_example


def test_the_printed_z_in_time() -> None:
    """Paper, end of Sec. 5: z = epsilon^2 (-2 - 8 t - 24 t^2 - 368/5 t^3 + (8 + 48 t) epsilon + 6672/5 epsilon^2)."""
    assert time_series(extended_example(1), 7).z == {
        (0, 2): -2, (1, 2): -8, (2, 2): -24, (3, 2): fmpq(-368, 5), (0, 3): 8, (1, 3): 48, (0, 4): fmpq(6672, 5)
    }  # fmt: skip


@pytest.mark.parametrize("order", [1, 2, 3, 4, 5, 6, 7, 12, 25])
@pytest.mark.parametrize("chi", [0, 1, "-2/3"])
def test_both_routes_agree(order: int, chi: int | str) -> None:
    system = extended_example(chi)
    first, second = expand_system(system, order).in_time(), time_series(system, order)
    assert first == second
    assert compare_routes(first, second).outcome is Outcome.PROVED


def test_both_routes_agree_where_products_go_by_blocks() -> None:
    system = extended_example(1)
    assert expand_system(system, 95).in_time() == time_series(system, 95)


def residuals(series: TimeSeries, chi: fmpq) -> dict[str, dict[tuple[int, int], fmpq]]:
    """genSysP to genSysLN for the extended example, coefficient by coefficient, by plain dictionaries."""

    def slope(table: dict[tuple[int, int], fmpq]) -> dict[tuple[int, int], fmpq]:
        return {(k - 1, m): k * value for (k, m), value in table.items() if k}

    def times(left: dict[tuple[int, int], fmpq], right: dict[tuple[int, int], fmpq]) -> dict[tuple[int, int], fmpq]:
        total: dict[tuple[int, int], fmpq] = {}
        for (k, m), a in left.items():
            for (i, j), c in right.items():
                total[k + i, m + j] = total.get((k + i, m + j), fmpq(0)) + a * c
        return total

    def combine(*parts: tuple[fmpq, dict[tuple[int, int], fmpq]]) -> dict[tuple[int, int], fmpq]:
        total: dict[tuple[int, int], fmpq] = {}
        for factor, table in parts:
            for key, value in table.items():
                total[key] = total.get(key, fmpq(0)) + factor * value
        return total

    one, eps, eps2 = {(0, 0): fmpq(1)}, {(0, 1): fmpq(1)}, {(0, 2): fmpq(1)}
    plus, minus = fmpq(1), fmpq(-1)
    of = series
    return {
        "p": combine((plus, slope(of.p)), (plus, one), (-chi, of.b)),
        "b": combine((plus, slope(of.b)), (plus, one), (fmpq(-3, 2), of.lambda_n)),
        "y": combine((plus, slope(of.y)), (minus, of.v)),
        "v": combine((plus, slope(of.v)), (minus, of.b), (minus, times(of.p, of.lambda_n))),
        "z": combine((plus, times(eps, slope(of.z))), (plus, of.z), (plus, times(eps2, of.lambda_n))),
        "lambda": combine((plus, times(eps2, of.lambda_n)), (minus, of.z), (plus, of.y)),
    }


@pytest.mark.parametrize("order", [1, 5, 12])
def test_the_original_equations_hold(order: int) -> None:
    chi = fmpq(2, 3)
    factors = {"p": 0, "b": 0, "y": 4, "v": 2, "z": 6, "lambda": 6}
    for name, table in residuals(time_series(extended_example(chi), order), chi).items():
        for (k, m), value in table.items():
            assert value == 0 or 2 * k + 3 * m - factors[name] >= order, (name, k, m)


def test_a_difference_is_named() -> None:
    series = time_series(extended_example(1), 8)
    wrong = replace(series, b={**series.b, (1, 0): fmpq(3)})
    verdict = compare_routes(series, wrong)
    assert verdict.outcome is Outcome.REFUTED
    assert verdict.witness == "b: the coefficient of t^1 epsilon^0 is 2 and 3"
    missing = replace(series, z={key: value for key, value in series.z.items() if key != (0, 3)})
    assert compare_routes(series, missing).outcome is Outcome.REFUTED
    assert compare_routes(missing, series).outcome is Outcome.REFUTED
    assert compare_routes(series, time_series(extended_example(1), 9)).outcome is Outcome.REFUTED


def test_every_coefficient_is_compared_as_evidence(monkeypatch: pytest.MonkeyPatch) -> None:
    series = time_series(extended_example(1), 8)
    verdict = compare_routes(series, series)
    assert verdict.evidence is not None
    assert f"{len(verdict.evidence.facts) - 2} coefficients" == verdict.detail
    monkeypatch.setattr(module, "differ", lambda *_: None)  # what differs is then not told from what is the same
    assert compare_routes(series, replace(series, b={**series.b, (1, 0): fmpq(3)})).outcome is Outcome.UNDECIDED
    monkeypatch.setattr(module, "equal", lambda *_: None)
    assert compare_routes(series, series).outcome is Outcome.UNDECIDED


def test_balls_that_overlap_prove_nothing() -> None:
    base = extended_example("1/3")
    system = replace(base, point=(arb(0),) * 6, ring=BALLS)
    first, second = expand_system(system, 10).in_time(), time_series(system, 10)
    assert compare_routes(first, second).outcome is Outcome.UNDECIDED
    exact = time_series(base, 10)
    for name, table in second.tables().items():
        for key, value in table.items():
            number = exact.tables()[name].get(key, fmpq(0))
            assert (value * int(number.q)).contains(int(number.p)), (name, key)


def test_hypotheses() -> None:
    with pytest.raises(GSpotError, match="integer 2"):
        time_series(extended_example(1, alpha=(-1, -1, -2)), 9)
    with pytest.raises(GSpotError, match="alpha_1"):
        time_series(extended_example(1, alpha=(1, -1, -2)), 9)
    base = extended_example(1)
    with pytest.raises(GSpotError, match="singular"):
        time_series(replace(base, J=(base.J[0], base.J[0])), 9)
