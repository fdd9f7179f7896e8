"""Tests of what proofs/gamma_ratio.md states."""

from __future__ import annotations

from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.numbers.balls import relative_bits, working_bits
from gspot_verified.theta_function.gamma.gamma_ratio import _NUMERATOR, gamma_ratio


def _numerator(n: Fraction, y: Fraction) -> Fraction:
    return sum((c * n**i * y**j for i, row in enumerate(_NUMERATOR) for j, c in enumerate(row)), Fraction(0))


@given(st.integers(1, 60), st.integers(1, 60), st.sampled_from([64, 500, 2000, 7000]))
def test_equals_the_quotient_of_gamma_values(p: int, q: int, bits: int) -> None:
    y = fmpq(min(p, q), max(p, q))
    ratio = gamma_ratio(y, bits)
    with working_bits(bits + 100):
        quotient = arb.gamma_fmpq(y + fmpq(1, 3)) / arb.gamma_fmpq(y)
    assert relative_bits(ratio) >= bits
    assert relative_bits(quotient) >= bits
    assert ratio.contains(quotient)


@pytest.mark.parametrize("y", [0, -1, fmpq(3, 2)])
def test_outside_the_unit_interval(y: fmpq) -> None:
    with pytest.raises(ValueError, match="y must lie"):
        gamma_ratio(fmpq(y), 100)


def _ratio(k: Fraction, a: Fraction, b: Fraction, c: Fraction) -> Fraction:
    return (a + k) * (b + k) / ((c + k) * (1 + k))


@pytest.mark.parametrize("move", ["c", "a", "b"])
def test_certificates_of_the_proof_page(move: str) -> None:
    """F'(k) - F(k) = G(k+1) - G(k), divided by F(k): rational functions, compared at more points than degrees."""
    for k in range(6):
        for a, b, c in (
            (Fraction(-i, 3), Fraction(2, 7) - j, Fraction(5, 3) + m) for i in (1, 4) for j in (0, 2) for m in (1, 3)
        ):
            g = c - a - b
            step = _ratio(Fraction(k), a, b, c)
            if move == "c":
                changed, certificate = (c - a) * (c - b) / ((c + k) * g), [Fraction(i) / g for i in (k, k + 1)]
            else:
                moved = a if move == "a" else b
                changed = (c - moved) * (moved - 1) / ((moved - 1 + k) * g)
                certificate = [i * (c - 1 + i) / ((moved - 1 + i) * g) for i in (Fraction(k), Fraction(k + 1))]
            assert changed - 1 == certificate[1] * step - certificate[0]


def test_block_sum_of_the_proof_page() -> None:
    """R_n - R_(n+1) and F_(n+1)/F_n from the seven moves, against the closed forms, in exact rationals."""
    for y in (Fraction(p, 11) for p in range(1, 9)):
        for n in range(12):
            a, b, c, k = Fraction(-1, 3) - 2 * n, Fraction(2, 3) - y - n, Fraction(2, 3) + n, Fraction(3 * n)
            size, total = Fraction(1), Fraction(0)
            for move in ("c", "k", "a", "b", "k", "a", "k"):
                g = c - a - b
                if move == "k":
                    total += size
                    size *= _ratio(k, a, b, c)
                    k += 1
                elif move == "c":
                    total += size * k / g
                    size *= (c - a) * (c - b) / ((c + k) * g)
                    c += 1
                elif move == "a":
                    total += size * k * (c - 1 + k) / ((a - 1 + k) * g)
                    size *= (c - a) * (a - 1) / ((a - 1 + k) * g)
                    a -= 1
                else:
                    total += size * k * (c - 1 + k) / ((b - 1 + k) * g)
                    size *= (c - b) * (b - 1) / ((b - 1 + k) * g)
                    b -= 1
            d = (12 * n + 3 * y + 1) * (12 * n + 3 * y + 4) * (12 * n + 3 * y + 7) * (12 * n + 3 * y + 10)
            assert total == 9 * _numerator(Fraction(n), y) / (4 * (6 * n + 1) * (12 * n + 5) * d)
            rho = (
                -9
                * (2 * n + y)
                * (2 * n + y + 1)
                * (3 * n - 1)
                * (6 * n + 5 - 3 * y)
                * (6 * n + 2 - 3 * y)
                * (3 * n + 3 * y + 1)
                / (4 * (12 * n + 5) * (12 * n + 11) * d)
            )
            assert size == rho * Fraction(6 * n + 7, 6 * n + 1)
