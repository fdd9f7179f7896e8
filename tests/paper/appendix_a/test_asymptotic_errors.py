"""The errors of the printed asymptotic formulas: just inside what is allowed, just outside, and what no ball can tell.

The function is replaced by its printed approximation plus a known multiple of the first omitted term.
"""

from __future__ import annotations

from collections.abc import Callable

import pytest
from flint import arb, fmpq

from gspot_verified.numbers.balls import working_bits
from gspot_verified.paper.appendix_a import asymptotic_errors as errors
from gspot_verified.paper.appendix_a import hypergeometric as printed

BITS = 512
BETA = fmpq(2, 3)
SMALL_X = fmpq(2)  # the terms and 1 are of one size
Function = Callable[[fmpq], arb]
"""The known multiple of what is omitted, to the value of the function."""


def _small(j: int, x: fmpq) -> Function:
    h, e = printed.h_terms(x, BETA, 10, BITS), printed.e_terms(x, BETA, 5, BITS)
    algebraic, outer, real, imaginary = (
        printed.value_of(printed.SMALL[f"{name} {j}"], BETA, BITS) for name in ("h", "e", "real", "imaginary")
    )
    with working_bits(BITS):
        total = e[0] + e[1] + e[2] + e[3]
        value = algebraic * sum(h[:9], arb(0)) + outer * (real * total.real + imaginary * total.imag)
        omitted = abs(algebraic * h[9]) + 2 * abs(outer * e[4])
    return lambda part: value + part * omitted


def _sum(terms: list[arb], factor: arb) -> Function:
    with working_bits(BITS):
        return lambda part: factor * (sum(terms[:-1], arb(0)) + part * abs(terms[-1]))


@pytest.mark.parametrize("j", range(3))
def test_th4(monkeypatch: pytest.MonkeyPatch, j: int) -> None:
    function = _small(j, SMALL_X)
    for part, answer in [(fmpq(199, 100), True), (fmpq(201, 100), False), (fmpq(-199, 100), True), (fmpq(-3), False)]:
        with working_bits(BITS):
            value = function(part)
        monkeypatch.setattr(printed, "fundamental_solution", lambda *_, value=value: value)
        assert errors.small_error_within(j, SMALL_X, BETA) is answer


@pytest.mark.parametrize("j", range(3))
def test_th5(monkeypatch: pytest.MonkeyPatch, j: int) -> None:
    factor = printed.value_of(printed.LARGE[f"factor {j}"], BETA, BITS)
    function = _sum(printed.e_1_terms(SMALL_X, BETA, 5, BITS), factor)
    for part, answer in [(fmpq(199, 100), True), (fmpq(201, 100), False), (fmpq(-199, 100), True)]:
        with working_bits(BITS):
            value = function(part)
        monkeypatch.setattr(printed, "fundamental_solution", lambda *_, value=value: value)
        assert errors.large_error_within(j, SMALL_X, BETA) is answer


def test_tlarge(monkeypatch: pytest.MonkeyPatch) -> None:
    factor = printed.value_of(printed.THETA["large front"], BETA, BITS)
    function = _sum(printed.e_1_terms(SMALL_X, BETA, 5, BITS), factor)
    for part, answer in [(fmpq(199, 100), True), (fmpq(201, 100), False), (fmpq(-199, 100), True)]:
        with working_bits(BITS):
            value = function(part)
        monkeypatch.setattr(errors, "theta_by", lambda *_, value=value, **__: value)
        assert errors.theta_error_within(SMALL_X, BETA) is answer


def test_the_power_series_and_its_leading_term(monkeypatch: pytest.MonkeyPatch) -> None:
    scale = printed.value_of(printed.THETA["small front"], BETA, BITS)
    function = _sum(printed.h_terms(SMALL_X, BETA, 4, BITS), scale)
    for part, answer in [(fmpq(99, 100), True), (fmpq(101, 100), False), (fmpq(-99, 100), True)]:
        with working_bits(BITS):
            value = function(part)
        monkeypatch.setattr(errors, "theta_by", lambda *_, value=value, **__: value)
        assert errors.power_series_within(SMALL_X, BETA) is answer
    monkeypatch.setattr(errors, "theta_by", lambda *_, **__: function(fmpq(0)))
    for text, answer in [("x^beta*(1+1/10^39)", False), ("x^beta*(1-1/10^39)", False), ("x^beta*(1+1/10^41)", True)]:
        monkeypatch.setitem(printed.THETA, "small leading", text)
        assert errors.power_series_within(SMALL_X, BETA) is answer


def test_the_functions_themselves() -> None:
    assert errors.small_error_within(1, fmpq(30), BETA) is True
    assert errors.power_series_within(fmpq(30), BETA) is True
    assert errors.large_error_within(2, fmpq(30), BETA) is True
    assert errors.theta_error_within(fmpq(40), BETA) is True


@pytest.mark.parametrize(
    ("error", "answer"),
    [(arb(0, 1), True), (arb("3/2"), None), (arb(3), False), (arb.nan(), None), (arb("+inf"), None)],
)
def test_what_a_ball_can_tell(error: arb, answer: bool | None) -> None:
    assert errors._within(error, arb("1.5", "0.5") if error == arb("3/2") else arb("1.5")) is answer
