"""The benchmark of expansions on small orders: figures and texts, never times."""

from __future__ import annotations

import json

import pytest
from flint import fmpq

from gspot_verified.cost.benchmarks import expand
from gspot_verified.cost.peers.sympy_expansion import sympy_extended
from gspot_verified.expansion.series.recursion import Recursion
from gspot_verified.mechanisms.shipped import shipped_system


def test_sympy_and_the_recursion_give_the_same_terms() -> None:
    for chi in (0, 1, 2):
        recursion = Recursion(shipped_system("extended", chi=chi))
        for theirs in sympy_extended(7, chi):
            recursion.advance()
            ours = [fmpq(c) for c in recursion.b[-1].coefficients()] or [fmpq(0)]
            assert [fmpq(c.numerator, c.denominator) for c in theirs] == ours


def test_the_fit_finds_the_exponent_it_was_given() -> None:
    import math

    for sigma in (0.0, 1 / 3, 1.0):
        sizes = tuple(expand.Size(n, 1, sigma * math.lgamma(n + 1) + 0.7 * n - 2) for n in (60, 72, 84))
        assert expand.fitted_exponent(sizes) == pytest.approx(sigma, abs=1e-9)
    assert "convergent" in expand.growth_text(0.0)


def test_sizes() -> None:
    recursion = Recursion(shipped_system("extended"))
    for _ in range(14):
        recursion.advance()
    (size,) = expand.coefficient_sizes(recursion)
    values = [value for value in recursion.b[12].coefficients() if value != 0]
    assert (size.order, size.bits) == (12, max(int(value.height_bits()) for value in values))


def test_a_small_run(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(expand, "_EXTENDED", ((6, 10.0),))
    monkeypatch.setattr(expand, "_OSCILLATOR", ((3, 10.0),))
    monkeypatch.setattr(expand, "_CURVE_ORDERS", {"extended": (2, 5), "oscillator": (2, 3)})
    monkeypatch.setattr(expand, "_SYMPY_ORDER", 4)
    said: list[str] = []
    result = expand.run(False, said.append)
    assert [row.asked for row in result.rows][-1] == "extended system, order 4"
    assert "b_n equal" in result.rows[-1].note
    assert [[order for order, _ in curve.points] for curve in result.curves] == [[2, 5], [2, 3]]
    assert "Gevrey" in str(result)
    assert json.loads(json.dumps(result.to_json()))["exponent"] == result.exponent
    assert said
