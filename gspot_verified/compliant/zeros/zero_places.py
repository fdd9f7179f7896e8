"""Enclosures of the real zeros T of the slow solution, one for each; that there are no others is shown elsewhere.

Proof page: ``proofs/finite_epsilon_zeros.md``, sections 2 and 3.
"""

from __future__ import annotations

from functools import cmp_to_key
from typing import Any

from flint import arb, fmpq

from gspot_verified.compliant.slow.force_polynomial import force_polynomial
from gspot_verified.compliant.slow.grid import scale
from gspot_verified.compliant.slow.slow_jet import slow_jet
from gspot_verified.leading_order.stretches import narrowed
from gspot_verified.numbers.balls import bits_for_digits, hull, sign_of, working_bits
from gspot_verified.signs.cover.pieces import Column, Kind, cell_of

_MAX_TAIL = 10**6  # tau beyond which the zero in the right tail is left out
_SPARE_BITS = 48  # bits beyond those asked for, lost on the way; any number is right
_TRIES = 3  # each with twice the bits; then a wider ball


def zero_places(beta: fmpq, epsilon: fmpq, column: Column, digits: int) -> list[arb]:
    """One ball of T for each zero that the pieces show, in order.

    In tau = (epsilon/2)^(1/3) T its width is at most 10^-digits; more where a sign stayed open, up to the whole piece.
    The zero in the right tail is left out when it is beyond tau = 10^6.
    """
    brackets = list(column.tubes())
    last = column.pieces[-1]
    if last.kind is Kind.RIGHT and last.mark == 1 and last.lower is not None:
        final = -1 if cell_of(beta, beta) % 2 == 0 else 1
        lower, upper = last.lower, max(2 * last.lower, fmpq(1))
        while upper <= _MAX_TAIL and (sign := _sign(beta, epsilon, upper, digits)) != final:
            lower, upper = (upper if sign else lower), 2 * upper  # where it stays open the zero may be on either side
        brackets += [(lower, upper)] if upper <= _MAX_TAIL else []
    return [_place(beta, epsilon, lower, upper, digits) for lower, upper in brackets]


def _place(beta: fmpq, epsilon: fmpq, lower: fmpq, upper: fmpq, digits: int) -> arb:
    after = _sign(beta, epsilon, upper, digits)

    def beyond(tau: fmpq) -> bool | None:
        sign = _sign(beta, epsilon, tau, digits)
        return sign == after if sign and after else None

    left, right = narrowed(beyond, lower, upper, digits)
    with working_bits(bits_for_digits(digits) + _SPARE_BITS):
        return hull([arb(left), arb(right)]) / scale(epsilon)


def _sign(beta: fmpq, epsilon: fmpq, tau: fmpq, digits: int) -> int | None:
    for attempt in range(_TRIES):
        bits = (bits_for_digits(digits) + _SPARE_BITS) * 2**attempt
        if sign := sign_of(slow_jet(tau, beta - 1, epsilon, 1, bits)[0]):
            return sign
    return None


def polynomial_places(n: int, epsilon: fmpq, digits: int) -> list[arb]:
    """One ball of T for each distinct real zero of F_n, by FLINT's certified isolation of all complex zeros."""
    with working_bits(bits_for_digits(digits) + _SPARE_BITS):
        pairs: Any = force_polynomial(n, epsilon).complex_roots()  # (root, multiplicity); its annotation is wrong
        roots = [root for root, _ in pairs]
        # Zeros of a real polynomial that are real are returned with the imaginary part 0.
        return sorted((root.real for root in roots if root.imag.is_zero()), key=cmp_to_key(_order))


def _order(left: arb, right: arb) -> int:
    """-1 or 1 for two isolated zeros, by a certain comparison.

    :raises ArithmeticError: they overlap.
    """
    sign = sign_of(left - right)
    if not sign:
        raise ArithmeticError("two zeros of a polynomial were not isolated; please report this")
    return sign
