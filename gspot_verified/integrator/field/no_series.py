"""The one error that means: no Taylor series here, choose another step."""

from __future__ import annotations


class NoSeriesError(ArithmeticError):
    """The right-hand side has no Taylor series at a state, or none in the numbers at hand.

    A divisor may vanish, the base of a root or a logarithm may not be positive, or a component is so large that no
    bits are left after the point. A run takes a shorter step, or ends with a reason; any other error is a fault.
    """
