"""The two ends of the tau-axis: where the sign of F = Theta(., b) is settled for good.

Proof page: ``proofs/tails.md``.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from flint import arb, fmpq

from gspot_verified.numbers.balls import sign_of


def left_holds(x: fmpq, lower: fmpq, upper: fmpq, n: int) -> bool:
    """Whether x^(3N) 3^N N! > prod over i < 3N of max(|lower - i|, |upper - i|), N = max(1, floor(n/3) + 1).

    Then Theta(tau, b) > 0 for every tau <= -x and b in [lower, upper], a part of [n, n+1]. Exact.

    :raises ValueError: the range of b is not in the cell, or n < -1, or x <= 0.

    >>> left_holds(fmpq(81, 64), fmpq(-1), fmpq(0), -1), left_holds(fmpq(5, 4), fmpq(-1), fmpq(0), -1)
    (True, False)
    """
    if n < -1 or not n <= lower <= upper <= n + 1 or x <= 0:
        raise ValueError("expected n >= -1, n <= lower <= upper <= n + 1 and x > 0")
    terms = max(1, n // 3 + 1)
    product = fmpq(1)
    for i in range(3 * terms):
        product *= max(abs(lower - i), abs(upper - i))
    return bool(x ** (3 * terms) * 3**terms * math.factorial(terms) > product)


def left_threshold(lower: fmpq, upper: fmpq, n: int, denominator: int = 8) -> fmpq:
    """The least x = j/denominator with ``left_holds``."""
    step = 1
    while not left_holds(fmpq(step, denominator), lower, upper, n):
        step *= 2
    least = step // 2
    while step - least > 1:
        middle = (step + least) // 2
        if left_holds(fmpq(middle, denominator), lower, upper, n):
            step = middle
        else:
            least = middle
    return fmpq(step, denominator)


def right_changes(coefficients: Sequence[arb], lower: fmpq, upper: fmpq, n: int) -> int | None:
    """The number of changes of sign in c_0, ..., c_n, then (-1)^(n+1); None if it is not certain.

    The coefficients c_k = F^(k)(T)/k! are enclosed for every b in [lower, upper]. A sign may be open between two
    certain signs that differ: whatever it is, there is one change.

    :raises ValueError: the range of b is not in [n, n+1], or n < 0, or there are not n + 1 coefficients.
    """
    if n < 0 or not n <= lower <= upper <= n + 1 or len(coefficients) != n + 1:
        raise ValueError("expected n >= 0, a range of b inside [n, n + 1] and n + 1 coefficients")
    return changes_of_sign([*map(sign_of, coefficients), -1 if n % 2 == 0 else 1])


def changes_of_sign(signs: Sequence[int | None]) -> int | None:
    """The number of changes of sign, or None when an open sign (None or 0) makes it uncertain.

    >>> changes_of_sign([1, None, -1]), changes_of_sign([1, None, 1]), changes_of_sign([None, 1])
    (1, None, None)
    """
    changes, before, is_open = 0, 0, False
    for sign in signs:
        if not sign:
            if is_open or not before:
                return None
            is_open = True
            continue
        if is_open and sign == before:
            return None
        changes += bool(before) and sign != before
        before, is_open = sign, False
    return None if is_open else changes
