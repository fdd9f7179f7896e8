"""5,000 seeded random cases over (beta, tau, width, accuracy): the evaluator against another route, and inclusion."""

from __future__ import annotations

import random

import pytest
from flint import arb, fmpq

from gspot_verified import evaluate, theta_by
from gspot_verified.numbers.balls import bits_for_digits, relative_bits
from gspot_verified.theta_function.value.routes import ROUTES

_CHUNKS, _CASES = 20, 250


def _beta(source: random.Random) -> fmpq:
    kind = source.random()
    if kind < 0.35:
        return fmpq(source.randint(-400, 400), source.choice((1, 2, 3, 7, 10)))
    if kind < 0.6:
        gap = fmpq(source.choice((-1, 1)), 10 ** source.choice((3, 10, 30, 300)))
        return fmpq(source.randint(-10, 14)) + gap
    if kind < 0.7:
        return fmpq(source.randint(-9_999, 9_999)) + fmpq(source.randint(0, 9), 10)
    return fmpq(source.randint(-50, 130), 10)


def _tau(source: random.Random) -> fmpq:
    sign = source.choice((-1, 1))
    if source.random() < 0.6:
        return fmpq(sign * source.randint(0, 2_000), source.choice((7, 10, 100)))
    return fmpq(sign * int(10 ** source.uniform(0, 15)), 1000)


def _witness(tau: fmpq, beta: fmpq, digits: int, used: str, source: random.Random) -> arb | None:
    """A second enclosure by a route that the evaluator did not use."""
    names = [name for name in ROUTES if name != used]
    source.shuffle(names)
    for name in names:
        if name in ("taylor", "splitting") and (abs(tau) > 150 or abs(beta) > 2_000):
            continue
        if name == "laplace" and (abs(tau) > 500 or abs(beta) > 60):
            continue
        value = theta_by(name, tau, beta, digits=digits)
        if value.is_finite():
            return value
    return None


@pytest.mark.parametrize(
    "chunk", [pytest.param(k, marks=[pytest.mark.slow] if k >= _CHUNKS // 2 else []) for k in range(_CHUNKS)]
)
def test_random_cases(chunk: int) -> None:
    source = random.Random(f"theta-{chunk}")
    compared = 0
    for _ in range(_CASES):
        tau, beta, digits = _tau(source), _beta(source), source.choice((1, 3, 15, 30, 50, 100))
        result = evaluate(tau, beta, digits=digits)
        case = f"tau = {tau}, beta = {beta}, digits = {digits}, route = {result.route}"
        assert result.reached, case
        assert relative_bits(result.value) >= bits_for_digits(digits), case
        witness = _witness(tau, beta, digits, result.route, source)
        if witness is not None:
            compared += 1
            assert witness.overlaps(result.value), case
        if source.random() < 0.3 and abs(tau) < 10**11 and abs(beta) < 9_000:
            _check_inclusion(tau, beta, source, case)
    assert compared > _CASES // 2


def _check_inclusion(tau: fmpq, beta: fmpq, source: random.Random, case: str) -> None:
    tau_radius, beta_radius = (source.choice((fmpq(0), fmpq(1, 2), fmpq(1, 1000), fmpq(1, 10**15))) for _ in range(2))
    if tau_radius == 0 and beta_radius == 0:
        return
    wide = evaluate(arb(tau, tau_radius), arb(beta, beta_radius)).value
    shares = [fmpq(source.randint(-100, 100), 100) for _ in range(2)]
    inside = evaluate(tau + shares[0] * tau_radius, beta + shares[1] * beta_radius, digits=40).value
    assert wide.is_finite(), case
    assert wide.contains(inside.mid()) or wide.overlaps(inside), case
