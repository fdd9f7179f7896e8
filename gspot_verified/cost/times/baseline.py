"""What a user would do without this package: the paper's formulas with FLINT's 1F2, or with mpmath's.

Initial values by t01-t03 as printed, then Theta = sum over j = 0, 1, 2 of Theta^(j)(0) tau^j/j! times the 1F2 number j
of Theorem 4 (th:3). A derivative is taken by Theta' = -beta Theta(beta - 1), which spares the alternative a product
rule.
"""

from __future__ import annotations

import math
import time
from dataclasses import dataclass
from typing import Any

from flint import arb, fmpq

from gspot_verified.numbers.balls import bits_for_digits, relative_bits, working_bits
from gspot_verified.theta_function.gamma.initial_values import paper_initial_values

LOWER = (
    (fmpq(1, 3), fmpq(2, 3)),
    (fmpq(2, 3), fmpq(4, 3)),
    (fmpq(4, 3), fmpq(5, 3)),
)
"""The lower parameters of the three 1F2; the upper one is (j - beta)/3, the argument tau^3/9."""

MAX_BITS = 1 << 20  # a limit against endless work
_GUARD_BITS = 16  # above the goal, as the first try; the accuracy is read off the ball
_GUARD_DIGITS = 10  # mpmath's own answer has no bound: these make its digits right as a rule


@dataclass(frozen=True, slots=True)
class Answer:
    """An enclosure from FLINT's 1F2, the working bits that gave it, and the time of each attempt."""

    value: arb
    bits: int
    seconds: tuple[float, ...]

    @property
    def attempts(self) -> int:
        """How many precisions were tried."""
        return len(self.seconds)


def flint_theta(
    tau: fmpq, beta: fmpq, derivative: int = 0, digits: int = 15, max_bits: int = MAX_BITS
) -> Answer | None:
    """d^k Theta/dtau^k with relative accuracy 10^-digits by three calls of FLINT's 1F2, or ``None``.

    Starts 16 bits above the goal and doubles the working precision until the accuracy is met. ``None`` when it would
    need more than ``max_bits``, or where the printed initial values are not defined. ``max_bits`` is also the budget of
    terms: FLINT ends a 1F2 series whose number of terms is out of proportion to the precision, and answers NaN.

    >>> answer = flint_theta(fmpq(7, 3), fmpq(1, 2))
    >>> answer.attempts, answer.value.is_finite()
    (1, True)
    """
    goal = bits_for_digits(digits)
    factor, shifted = _factor(beta, derivative), beta - derivative
    if shifted.q == 1 and shifted >= 0:  # the printed initial values are 0/0 there, and only there
        return None
    bits = goal + _GUARD_BITS
    seconds: tuple[float, ...] = ()
    while bits <= max_bits:
        start = time.perf_counter()
        value = flint_attempt(tau, shifted, bits)
        seconds = (*seconds, time.perf_counter() - start)
        if relative_bits(value) >= goal:
            with working_bits(bits):
                return Answer(value * factor, bits, seconds)
        bits *= 2
    return None


def flint_attempt(tau: fmpq, beta: fmpq, bits: int) -> arb:
    """One evaluation at one working precision; possibly wide, or not finite."""
    values = paper_initial_values(beta, bits)
    with working_bits(bits):
        point, argument, total = arb(tau), arb(tau**3 / 9), arb(0)
        for j in range(3):
            term = argument.hypgeom([arb((j - beta) / 3)], [arb(b) for b in LOWER[j]])
            total += values[j] * term * point**j / (1 + (j > 1))
        return total


def _factor(beta: fmpq, derivative: int) -> fmpq:
    factor = fmpq(1)
    for j in range(derivative):
        factor *= j - beta
    return factor


def mpmath_theta(
    tau: fmpq, beta: fmpq, derivative: int = 0, digits: int = 15, max_terms: int | None = None
) -> Any | None:
    """The same by mpmath's hyp1f2 with 10 guard digits: an ``mpf`` without any bound, or ``None``.

    mpmath raises its precision where its own estimate sees cancellation inside one 1F2; nothing says how many digits of
    the sum are right. ``None`` when it gives up, or ends its budget of ``max_terms`` terms, or at a pole of Gamma.
    """
    import mpmath  # type: ignore[import-untyped]

    factor, shifted = _factor(beta, derivative), beta - derivative
    options = {} if max_terms is None else {"maxterms": max_terms}
    with mpmath.workdps(digits + _GUARD_DIGITS):
        try:
            value = mpmath_sum(mpmath.mp, tau, shifted, options)
            return value * int(factor.p) / int(factor.q)
        except (mpmath.mp.NoConvergence, ValueError, ZeroDivisionError, OverflowError):
            return None


def mpmath_sum(mp: Any, tau: fmpq, beta: fmpq, options: dict[str, int]) -> Any:
    """The three terms at the precision that ``mp`` has.

    :raises ValueError: beta is an integer >= 0.
    """

    def number(value: fmpq) -> Any:
        return mp.mpf(int(value.p)) / int(value.q)

    point, argument, parameter = number(tau), number(tau**3 / 9), number(beta)
    outer, total = mp.rgamma(-parameter), mp.mpf(0)
    if not outer:
        raise ValueError("the printed initial values are 0/0 at an integer beta >= 0")
    for j in range(3):
        initial = mp.gamma((j - parameter) / 3) * outer / mp.mpf(3) ** ((3 - j + parameter) / 3)
        lower = [number(b) for b in LOWER[j]]
        total += initial * mp.hyp1f2((j - parameter) / 3, *lower, argument, **options) * point**j / (1 + (j > 1))
    return total


def right_digits(value: Any, reference: arb, digits: int) -> int:
    """How many decimal digits of ``value`` (``mpf``, ``arb`` or decimal text) certainly agree with ``reference``.

    Counted from the relative distance, up to ``digits``; 0 when nothing is certain. ``reference`` must be finite.
    """
    with working_bits(bits_for_digits(digits) + 64):
        distance = (_as_ball(value) - reference) / reference
        size = distance.abs_upper()
        if not size.is_finite():
            return 0
        if size < arb(10) ** -digits:
            return digits
        return max(0, min(digits, math.floor(float(-size.log().mid() / arb(10).log().mid()))))


def _as_ball(value: Any) -> arb:
    if isinstance(value, arb | str):
        return arb(value)
    mantissa, exponent = value.man_exp  # of the absolute value
    size = arb((int(mantissa), int(exponent)))
    return -size if value < 0 else size
