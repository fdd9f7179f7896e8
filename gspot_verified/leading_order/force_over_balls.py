"""The paper's contact force at leading order for every alpha_1, alpha_2, alpha_3 in balls at once.

Proof page: ``proofs/iwc.md``, section 6. For rational alphas: :mod:`gspot_verified.leading_order.contact_force`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from flint import arb, fmpq

from gspot_verified.leading_order.contact_force import (
    LEADING,
    MAX_BETA,
    SCALED_TIME,
    ContactForce,
    case_and_side,
    rational,
)
from gspot_verified.leading_order.stretches_over_ball import SlopeOverBall
from gspot_verified.numbers.balls import ExactInput, ball, ball_text, bits_for_digits, exact, sign_of, working_bits
from gspot_verified.numbers.short_text import short_text
from gspot_verified.numbers.verdict import NoTruthValue, Reason
from gspot_verified.numbers.written import Written
from gspot_verified.signs.gamma.side import gamma_sign

FOR_ALL = "for all α1, α2, α3 in the balls"
_GUARD_BITS = 64  # bits beyond those asked for, lost on the way; any number is right


class OpenHypothesis(ArithmeticError):
    """The balls are too wide: a hypothesis holds for some numbers in them, and perhaps not for others."""


@dataclass(frozen=True, slots=True)
class ForceOverBalls(NoTruthValue, Written):
    """All systems whose alphas lie in three balls, and one C_1; beta is a ball that contains every alpha_3/alpha_1.

    Every ball that a method returns contains the value of each of these systems. Make it with
    :func:`force_over_balls`, which checks the hypotheses for all of them.
    """

    ask: ClassVar[str] = ".takes_impact says which side it is"
    left_open: ClassVar[Reason] = Reason.WIDE_INPUT
    """Why a comparison is open: the balls are too wide."""
    too_close: ClassVar[str] = "ε is not below the ε0 of all of them, nor above"
    written: ClassVar[str] = ContactForce.written

    beta: arb
    alpha_1: arb
    alpha_2: arb
    alpha_3: arb
    c1: fmpq
    side: int
    """The sign of Gamma(-beta), one for the whole ball."""

    @property
    def numbers(self) -> str:
        """The systems and the trajectory, as a statement names them."""
        balls = {"β": self.beta, "α1": self.alpha_1, "α2": self.alpha_2, "α3": self.alpha_3}
        shown = ", ".join(f"{name} = {ball_text(value)}" for name, value in balls.items())
        # "For all numbers in the balls" is not said of those that are written: these are wider.
        return f"{shown} (balls rounded outward), C1 = {short_text(self.c1)}"

    @property
    def system(self) -> str:
        """How a statement at leading order begins."""
        return f"{LEADING}, {FOR_ALL}, {self.numbers}"

    @property
    def direction(self) -> int:
        """The sign of C_1."""
        return 1 if self.c1 > 0 else -1

    @property
    def takes_impact(self) -> bool:
        """Whether C_1/Gamma(-beta) > 0."""
        return self.direction == self.side

    @property
    def case(self) -> str | None:
        """The paper's Case, "none" where alpha_2 = 0; None where the sign of alpha_2 is open."""
        if self.beta > 1:
            return "III"
        sign = sign_of(self.alpha_2)
        return None if sign is None else {-1: "I", 0: "none", 1: "II"}[sign]

    def mean(self, digits: int = 15) -> arb:
        """alpha_2/(alpha_3 - alpha_1) = alpha_2/(alpha_1 (beta - 1))."""
        with working_bits(_bits(digits)):
            return self.alpha_2 / (self.alpha_3 - self.alpha_1)

    def exponent(self, digits: int = 15) -> arb:
        """The power p = (2 beta - 2)/3 of epsilon in the deviation; its sign is certain."""
        with working_bits(_bits(digits)):
            return (2 * self.beta - 2) / 3

    def amplitude(self, digits: int = 15) -> arb:
        """A = (|C_1|/|alpha_3|) kappa^(1-beta) > 0, kappa^3 = -alpha_1/2."""
        with working_bits(_bits(digits)):
            return abs(self.c1) / -self.alpha_3 * ((-self.alpha_1 / 2).log() * (1 - self.beta) / 3).exp()

    def level(self, epsilon: fmpq, digits: int = 15) -> arb:
        """L = mean/(A epsilon^p): lambda_N has the sign of direction dTheta/dtau + L."""
        with working_bits(_bits(digits) + int(epsilon.height_bits())):
            power = (arb(epsilon).log() * self.exponent(digits)).exp()
            return self.mean(digits) / (self.amplitude(digits) * power)

    def log_epsilon(self, slope: arb, digits: int = 15) -> arb:
        """The logarithm of the epsilon with mean + A epsilon^p slope = 0; not finite where both may have one sign."""
        with working_bits(_bits(digits)):
            return (-self.mean(digits) / (self.amplitude(digits) * slope)).log() / self.exponent(digits)

    def value(self, tau: fmpq, epsilon: fmpq, digits: int = 15) -> arb:
        """lambda_N at one point, at leading order."""
        slope = SlopeOverBall(self.beta, abs(tau), digits).enclosure(tau, tau, 1)
        with working_bits(_bits(digits) + int(epsilon.height_bits())):
            power = (arb(epsilon).log() * self.exponent(digits)).exp()
            return self.mean(digits) + self.direction * self.amplitude(digits) * power * slope

    def lines(self) -> list[str]:
        """The systems and the side."""
        side = case_and_side(self.case, self.numbers, self.takes_impact)
        return [side, f"  κ^3 = -α1/2, {SCALED_TIME}"]


def force_over_balls(
    alpha_1: ExactInput, alpha_2: ExactInput, alpha_3: ExactInput, c1: ExactInput | None = None
) -> ForceOverBalls:
    """All systems with their alphas in these balls (or numbers).

    C_1 left out: 1 or -1 with C_1/Gamma(-beta) > 0.

    :raises OpenHypothesis: for some numbers in the balls, perhaps, alpha_1 or alpha_3 is not negative, beta is an
        integer or not in (0, 100], or beta > 1 and alpha_2 is not negative.
    :raises ValueError: C_1 = 0.

    >>> from flint import arb
    >>> force_over_balls(-1, -1, arb("-2.5", "1e-9")).takes_impact
    True
    """
    first, second, third = (
        exact(value, name) for value, name in ((alpha_1, "alpha_1"), (alpha_2, "alpha_2"), (alpha_3, "alpha_3"))
    )
    with working_bits(_input_bits(first, second, third)):
        one, two, three = ball(first), ball(second), ball(third)
        for name, value in (("alpha_1", one), ("alpha_3", three)):
            if not value < 0:
                raise OpenHypothesis(f"{name}: it is not certainly < 0")
        beta = three / one
        if not 0 < beta <= MAX_BETA:
            raise OpenHypothesis(f"beta: it is not certainly in (0, {MAX_BETA}]")
        side = gamma_sign(beta)
        if not side:
            raise OpenHypothesis("beta: its ball holds an integer, where the side of the contact changes")
        if beta > 1 and not two < 0:
            raise OpenHypothesis("alpha_2: Case III (beta > 1) needs a number < 0, and it is not certainly so")
    charge = fmpq(side) if c1 is None else rational(c1, "c1")
    if charge == 0:
        raise ValueError("c1: at C_1 = 0 the trajectory is the canard itself, and its force is the mean force")
    return ForceOverBalls(beta, one, two, three, charge, side)


def _input_bits(*values: fmpq | arb) -> int:
    sizes = [int(value.height_bits() if isinstance(value, fmpq) else value.bits()) for value in values]
    return max(256, *sizes) + _GUARD_BITS


def _bits(digits: int) -> int:
    return bits_for_digits(digits) + 2 * _GUARD_BITS
