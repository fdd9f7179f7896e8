"""Theta at one beta, prepared for many values of tau that come one by one.

Proof page: ``proofs/local_series.md``.
"""

from __future__ import annotations

from flint import arb, arb_poly, fmpq

from gspot_verified.numbers.balls import ExactInput, bits_for_digits, exact, working_bits
from gspot_verified.theta_function.arrays.panels import FARTHEST, is_tame, panel
from gspot_verified.theta_function.value.evaluate import evaluate
from gspot_verified.theta_function.value.routes import checked_arguments

_GUARD = 10  # bits beyond those asked for, lost on the way; any number is right


class PreparedTheta:
    """tau -> an enclosure of d^k Theta/dtau^k (tau, beta) with relative accuracy 10^-digits, for |tau| <= reach.

    One Taylor series for each half unit of tau is made beforehand; a value then costs one polynomial. Where it does not
    reach the accuracy (next to a zero), and for balls,
    :func:`gspot_verified.theta_function.value.evaluate.evaluate` is asked.

    :param beta: |beta| <= 100, exact and of small height.
    :param digits: 1..300.
    :param reach: an int, 1..64.
    :raises TypeError: a float argument.
    :raises ValueError: an argument outside its domain, here or in a call.

    >>> prepared = PreparedTheta("7/3", digits=30, reach=2)
    >>> prepared("-3/2").overlaps(evaluate("-3/2", "7/3", digits=30).value)
    True
    """

    __slots__ = ("_beta", "_derivative", "_digits", "_goal", "_panels", "_reach", "_scope")

    def __init__(self, beta: ExactInput, digits: int = 15, reach: int = 10, derivative: int = 0) -> None:
        _, parameter = checked_arguments(0, beta, derivative)
        if not (isinstance(parameter, fmpq) and is_tame(parameter)):
            raise ValueError("beta: expected a number of small height with |beta| <= 100")
        if type(reach) is not int or not 1 <= reach <= FARTHEST:
            raise ValueError(f"reach must be an int in 1..{FARTHEST}, got {reach!r}")
        self._goal = bits_for_digits(digits)
        if digits > _MOST_DIGITS:
            raise ValueError(f"digits must lie in 1..{_MOST_DIGITS}, got {digits}")
        self._beta, self._digits, self._reach, self._derivative = parameter, digits, reach, derivative
        self._scope = working_bits(self._goal + _GUARD)
        self._panels: list[arb_poly] = [
            panel(parameter, derivative, half >> 1, half & 1, 2, self._goal + _GUARD).polynomial
            for half in range(-2 * reach, 2 * reach)
        ]

    def __call__(self, tau: ExactInput) -> arb:
        """The enclosure at ``tau``."""
        point = tau if type(tau) is fmpq else exact(tau, "tau")
        if type(point) is fmpq:
            last = 2 * self._reach
            half = int(2 * point.p // point.q)  # the panel [half/2, (half + 1)/2]
            if not -last <= half < last:
                if point != self._reach:
                    raise ValueError(f"tau: prepared for |tau| <= {self._reach}")
                half -= 1
            with self._scope:
                value = self._panels[half + last](arb(4 * point - (2 * half + 1)))
            if value.rel_accuracy_bits() >= self._goal:
                return value
        return evaluate(point, self._beta, self._derivative, self._digits).value


_MOST_DIGITS = 300  # a limit of input: ValueError beyond it
