"""The norm of the fast part (proofs/from_own_state.md, section 2) beside matrices in floats."""

from __future__ import annotations

import math

import numpy as np
import pytest
from flint import arb, fmpq

from gspot_verified.expansion.chart.cone import rational_of
from gspot_verified.expansion.from_state.slow_series import Contact
from gspot_verified.mechanisms.own_state.fast_norm import FastNorm
from gspot_verified.numbers.balls import approximate, ball, working_bits

PAPER = Contact(fmpq(1, 2), fmpq(2), fmpq(1, 2))
OTHER = Contact(fmpq(6, 5), fmpq(5, 2), fmpq(4, 5))  # k_1 = 3, k_2 = 2, c = 2
Floats = np.ndarray[tuple[int, ...], np.dtype[np.float64]]


def frozen(contact: Contact, p: float) -> Floats:
    """The equations of (sqrt(kappa p) V, W, g sqrt(p/l) phi) at a fixed p, by a change of variables of those of V, W,
    phi: V' = W, W' = -kappa p V - g p phi, phi' = -g phi + (l/g) W."""
    kappa, g, lag = (approximate(value) for value in (contact.kappa, contact.rate, contact.lag))
    plain = np.array([[0, 1, 0], [-kappa * p, 0, -g * p], [0, lag / g, -g]])
    scale = np.diag([math.sqrt(kappa * p), 1, g * math.sqrt(p / lag)])
    return scale @ plain @ np.linalg.inv(scale)


def gram(contact: Contact, weight: float, p: float) -> Floats:
    kappa, g, lag = (approximate(value) for value in (contact.kappa, contact.rate, contact.lag))
    above, below = weight / 2 * lag * math.sqrt(p / kappa) / g, weight * math.sqrt(lag * p) / g
    return np.array([[1, above, 0], [above, 1, -below], [0, -below, 1]])


@pytest.mark.parametrize("contact", [PAPER, OTHER])
@pytest.mark.parametrize("weight", [fmpq(1), fmpq(1, 2), fmpq(1, 8)])
@pytest.mark.parametrize("p", [fmpq(1, 1000), fmpq(1, 20), fmpq(2, 5)])
def test_the_rate_is_one_of_the_frozen_equations(contact: Contact, weight: fmpq, p: fmpq) -> None:
    with working_bits(120):
        decay = FastNorm(contact, weight).decay(ball(p))
    assert decay is not None
    M, B = gram(contact, approximate(weight), approximate(p)), frozen(contact, approximate(p))
    rate, tilt = approximate(decay.rate), approximate(decay.tilt)
    falls = -np.linalg.eigvals(np.linalg.solve(M, (M @ B + B.T @ M) / 2)).real.max()
    assert rate < falls < 4 * rate
    assert np.linalg.norm(M - np.eye(3), 2) == pytest.approx(tilt, rel=1e-9)


def test_a_ball_of_p_is_about_all_of_it() -> None:
    """The rate is that of the least p, the tilt that of the largest."""
    with working_bits(120):
        whole = FastNorm(PAPER, fmpq(1)).decay(arb("0.15", "0.05"))
        first, last = (FastNorm(PAPER, fmpq(1)).decay(arb(word)) for word in ("0.1", "0.2"))
        assert whole is not None
        assert first is not None
        assert last is not None
        assert abs(whole.rate - first.rate) < arb("1e-8")
        assert abs(whole.tilt - last.tilt) < arb("1e-8")


@pytest.mark.parametrize(
    ("weight", "p"),
    [
        (fmpq(4), arb("0.01")),  # too much of x_3 is mixed in
        (fmpq(1), arb(20)),  # M is not positive definite
        (fmpq(1), arb(0, "0.001")),
        (fmpq(1), arb((1, -3), (1, -3))),  # [0, 1/4]
        (fmpq(1), arb("-0.1")),
        (fmpq(1), arb("nan")),
    ],
)
def test_what_is_not_certain_is_refused(weight: fmpq, p: arb) -> None:
    with working_bits(120):
        assert FastNorm(PAPER, weight).decay(p) is None


def test_a_smaller_weight_serves_a_larger_p() -> None:
    with working_bits(120):
        assert FastNorm(PAPER, fmpq(1)).decay(arb(8)) is None
        assert FastNorm(PAPER, fmpq(1, 8)).decay(arb(8)) is not None


def passes(contact: Contact, weight: float, p: float) -> bool:
    """The two conditions of the page in floats, from the matrices themselves."""
    M, B = gram(contact, weight, p), frozen(contact, p)
    q = approximate(contact.lag) * p / approximate(contact.rate)
    left = -(M @ B + B.T @ M) - 2 * weight / 5 * q * M
    return bool(np.linalg.eigvalsh(left).min() > 0 and np.linalg.norm(M - np.eye(3), 2) < 1)


@pytest.mark.parametrize(
    "contact", [PAPER, OTHER, Contact(fmpq(3), fmpq(1), fmpq(1, 4)), Contact(fmpq(1, 9), fmpq(3), fmpq(5))]
)
@pytest.mark.parametrize("weight", [fmpq(1), fmpq(1, 4)])
def test_it_is_refused_from_where_it_fails(contact: Contact, weight: fmpq) -> None:
    """The last p at which the conditions hold, by bisection in floats."""
    size, below, above = approximate(weight), 1e-6, 1e4
    assert passes(contact, size, below)
    assert not passes(contact, size, above)
    for _ in range(60):
        middle = math.sqrt(below * above)
        below, above = (middle, above) if passes(contact, size, middle) else (below, middle)
    with working_bits(120):
        assert FastNorm(contact, weight).decay(arb(below * 0.999999)) is not None
        assert FastNorm(contact, weight).decay(arb(above * 1.000001)) is None


def test_the_numbers_of_a_ball_are_bounds() -> None:
    with working_bits(120):
        decay = FastNorm(PAPER, fmpq(1)).decay(arb("0.15", "0.05"))
        assert decay is not None
        assert decay.tilt.is_exact()
        assert decay.rate.is_exact()
        assert decay.rate <= arb("0.1") / 20
        assert rational_of(decay.tilt) ** 2 >= fmpq(1, 32)
