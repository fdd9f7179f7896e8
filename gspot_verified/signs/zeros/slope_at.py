"""dTheta/dtau at one beta > 0 at many points: certain signs, and the step of Newton's method.

Near 0 both come from Theta carried along tau (``proofs/carried_series.md``); elsewhere, and where that leaves a sign
open, by evaluation.
"""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.numbers.balls import approximate, bits_for_digits, sign_of, working_bits
from gspot_verified.theta_function.boxes.carried import CarriedTheta
from gspot_verified.theta_function.value.evaluate import evaluate

_MOST_CARRIED_DIGITS = 50  # beyond them the series near 0 cost more than the values
_SPARE_BITS = 24  # bits beyond those asked for, lost on the way; any number is right


class UndecidedError(ArithmeticError):
    """The zeros were not bracketed; nothing is said about them."""


class SlopeAt:
    """dTheta/dtau(., beta) for |tau| <= reach, and less well beyond; zeros are wanted to ``digits`` decimals."""

    def __init__(self, beta: fmpq, reach: fmpq, digits: int) -> None:
        self.beta = beta
        self._reach = reach
        self._carried: CarriedTheta | None = None
        if digits <= _MOST_CARRIED_DIGITS:
            self._carried = CarriedTheta(beta - 1, fmpq(0), reach, bits_for_digits(digits) + _SPARE_BITS)

    @property
    def is_carried(self) -> bool:
        """Whether all digits that are wanted come from the series near 0, where a value costs little."""
        return self._carried is not None

    def sign(self, tau: fmpq) -> int:
        """1 or -1, certainly.

        :raises UndecidedError: the sign stays open, or it is 0.
        """
        if self._carried is not None and abs(tau) <= self._reach:
            # dTheta/dtau = -beta Theta(., beta - 1): proofs/identities.md.
            sign = sign_of(self._carried.values(tau)[0][0])
            if sign:
                return -sign
        sign = sign_of(evaluate(tau, self.beta, derivative=1, digits=2).value)
        if not sign:
            raise UndecidedError(f"the sign of dΘ/dτ at τ = {approximate(tau)} is open")
        return sign

    def newton(self, tau: fmpq, digits: int) -> arb:
        """tau minus the quotient of dTheta/dtau and its derivative, to about ``digits`` digits: a guess at a zero."""
        if self._carried is not None and abs(tau) <= self._reach:
            value, slope, _ = self._carried.values(tau)
            with working_bits(self._carried.bits):
                return arb(tau) - value[0] / slope[0]
        with working_bits(bits_for_digits(2 * digits) + 32):
            step = (
                evaluate(tau, self.beta, derivative=1, digits=digits).value
                / evaluate(tau, self.beta, derivative=2, digits=digits).value
            )
            return arb(tau) - step
