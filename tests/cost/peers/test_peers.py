"""The rows beside peers and limits: what they contain, never how long anything took."""

from __future__ import annotations

import json
from fractions import Fraction

import numpy as np
import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st
from samples.strategies import small_heights, to_fmpq

from gspot_verified import evaluate, theta_of_floats
from gspot_verified.cli import main
from gspot_verified.cost.benchmarks import theta as benchmark
from gspot_verified.cost.peers import peers
from gspot_verified.cost.peers.peers import entire_form
from gspot_verified.cost.times import limits
from gspot_verified.cost.times.baseline import flint_attempt
from gspot_verified.numbers.balls import bits_for_digits, relative_bits


def test_the_ode_solver_gives_the_same_function() -> None:
    tau = np.sort(np.random.default_rng(3).uniform(-3.0, 3.0, 50))
    ours = theta_of_floats(tau, "7/3")
    assert np.abs(peers.ode_values(tau, fmpq(7, 3)) - ours.midpoint).max() < 1e-9
    right = peers.ode_values(tau[tau > 0], fmpq(7, 3))
    assert np.abs(right - ours.midpoint[tau > 0]).max() < 1e-9


def test_the_precision_of_the_peer_suffices() -> None:
    for tau, beta in ((fmpq(1), fmpq(7, 3)), (fmpq(-10), fmpq(7, 3)), (fmpq(1), fmpq(2))):
        bits = peers.sufficient_bits(tau, beta, 16)
        assert bits is not None
        assert relative_bits(entire_form(tau, beta, bits)) >= bits_for_digits(16)
    assert peers.sufficient_bits(fmpq(-(10**6)), fmpq(7, 3), 16) is None


@given(st.fractions(-9, 9, max_denominator=40), small_heights())
def test_the_entire_form_is_theta(tau: Fraction, beta: Fraction) -> None:
    """Also at the integers, where the printed initial values are 0/0; elsewhere beside these."""
    value = entire_form(to_fmpq(tau), to_fmpq(beta), 200)
    assert value.is_finite()
    assert value.overlaps(evaluate(tau, beta, digits=40).value)
    if beta.denominator > 1:
        assert value.overlaps(flint_attempt(to_fmpq(tau), to_fmpq(beta), 200))


def test_rows() -> None:
    rows = [
        *peers.one_value((fmpq(7, 3),), (fmpq(1),), (16,)),
        *peers.many_values(300, (2.0,)),
        *limits.many_digits((1_000,)),
        *limits.memory_traffic(1_000),
    ]
    assert [row.case for row in rows] == [
        "one value", "many values", *["short arrays"] * 2, *["many values"] * 2, *["limit"] * 4,
    ]  # fmt: skip
    assert all(row.figure is not None and row.figure > 0 for row in rows)
    assert all(row.met in (True, False) for row in rows)
    assert "DOP853, uncertified" in rows[1].note


def test_far_rows_are_against_minus_50() -> None:
    rows = list(peers.far_values((400,)))
    assert len(rows) == 4 * len(peers.BETAS)
    assert rows[0].asked.startswith("Θ τ=10^6")


def test_the_command(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    for module, name in (
        (peers, "one_value"),
        (peers, "first_calls"),
        (peers, "far_values"),
        (peers, "many_values"),
        (limits, "many_digits"),
    ):
        monkeypatch.setattr(module, name, lambda: iter(()))
    monkeypatch.setattr(limits, "memory_traffic", lambda: iter(()))
    monkeypatch.setattr(benchmark, "_external", lambda _: iter(()))
    assert main(["cost", "theta", "--peers", "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["rows"] == []
    assert any("shortest" in remark for remark in data["remarks"])
    assert main(["cost", "sign", "--peers"]) == 64
    assert "--peers" in capsys.readouterr().err
