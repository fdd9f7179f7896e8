"""The paper's contact force at leading order, lambda_N = mean + deviation, as exact data and balls (Sec. 4.5).

Proof page: ``proofs/iwc.md``, section 1.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from flint import arb, fmpq

from gspot_verified.numbers.balls import ExactInput, approximate, bits_for_digits, exact, working_bits
from gspot_verified.numbers.evidence import less
from gspot_verified.numbers.short_text import short_text
from gspot_verified.numbers.verdict import Evidence, NoTruthValue, Reason
from gspot_verified.numbers.written import Written
from gspot_verified.signs.gamma.side import gamma_sign
from gspot_verified.theta_function.value.evaluate import evaluate

LEADING = "at leading order"
SCALED_TIME = "τ = κ t ε^(-2/3), p = α1 t"
MAX_BETA = 100  # a limit of input: ValueError beyond it
LEAST_TENS = -100_000  # decimal exponent of the least epsilon_0 that is written down
_MOST_TENS = 100  # decimal exponent at which epsilon_0 is cut off
_GUARD_BITS = 64  # bits beyond those asked for, lost on the way; any number is right


@dataclass(frozen=True, slots=True)
class ContactForce(NoTruthValue, Written):
    """One system and one trajectory: lambda_N(tau, epsilon) = mean - (C_1/alpha_3) kappa^(1-beta) epsilon^p
    dTheta/dtau.

    Here mean = alpha_2/(alpha_3 - alpha_1), kappa^3 = -alpha_1/2, beta = alpha_3/alpha_1, p = (2 beta - 2)/3. Make it
    with :func:`contact_force`, which checks the hypotheses.
    """

    ask: ClassVar[str] = ".takes_impact says which side it is"
    left_open: ClassVar[Reason] = Reason.BUDGET
    """Why a comparison is open: more digits would settle it."""
    too_close: ClassVar[str] = "ε is too close to the largest ε0; ask for more digits"
    written: ClassVar[str] = (
        "beta alpha_1 alpha_2 alpha_3 C1=c1 case mean_force=mean tends_to_plus_infinity=takes_impact"
    )

    beta: fmpq
    alpha_1: fmpq
    alpha_2: fmpq
    alpha_3: fmpq
    c1: fmpq

    @property
    def numbers(self) -> str:
        """The numbers of the system and the trajectory, as a statement names them."""
        alphas = ", ".join(f"α{i} = {short_text(alpha)}" for i, alpha in enumerate(self.alphas, 1))
        return f"β = {self.beta}, {alphas}, C1 = {short_text(self.c1)}"

    @property
    def system(self) -> str:
        """How a statement at leading order begins."""
        return of_system(LEADING, self)

    @property
    def alphas(self) -> tuple[fmpq, fmpq, fmpq]:
        """alpha_1, alpha_2, alpha_3."""
        return self.alpha_1, self.alpha_2, self.alpha_3

    @property
    def mean(self) -> fmpq:
        """The force on the distinguished trajectory (the paper's line 1250 has the other sign, line 284 this one)."""
        return self.alpha_2 / (self.alpha_3 - self.alpha_1)

    @property
    def exponent(self) -> fmpq:
        """The power p of epsilon in the deviation."""
        return (2 * self.beta - 2) / 3

    @property
    def direction(self) -> int:
        """The sign of C_1: the deviation has the sign of direction * dTheta/dtau, because alpha_3 < 0."""
        return 1 if self.c1 > 0 else -1

    @property
    def takes_impact(self) -> bool:
        """Whether C_1/Gamma(-beta) > 0: then the force tends to +infinity as tau does, otherwise to -infinity."""
        return self.direction == gamma_sign(self.beta)

    @property
    def case(self) -> str:
        """The paper's Case, as :func:`gspot_verified.classify` names it: "I", "II", "III", "none" (alpha_2 = 0)."""
        if self.beta > 1:
            return "III"
        return "I" if self.alpha_2 < 0 else "II" if self.alpha_2 > 0 else "none"

    def amplitude(self, digits: int = 15) -> arb:
        """A = (|C_1|/|alpha_3|) kappa^(1-beta) > 0: lambda_N = mean + A epsilon^p direction dTheta/dtau."""
        with working_bits(self._bits(digits)):
            return arb(abs(self.c1 / self.alpha_3)) * arb(-self.alpha_1 / 2) ** arb((1 - self.beta) / 3)

    def level(self, epsilon: fmpq, digits: int = 15) -> arb:
        """L with: lambda_N has the sign of direction dTheta/dtau + L; L = mean/(A epsilon^p)."""
        with working_bits(self._bits(digits)):
            return arb(self.mean) / (self.amplitude(digits) * arb(epsilon) ** arb(self.exponent))

    def log_epsilon(self, slope: arb, digits: int = 15) -> arb:
        """The logarithm of the epsilon at which mean + A epsilon^p slope = 0; slope and mean have opposite signs."""
        with working_bits(self._bits(digits)):
            return (arb(-self.mean) / (self.amplitude(digits) * slope)).log() / arb(self.exponent)

    def lines(self) -> list[str]:
        """The system, the side, and the formula of the force."""
        return [
            case_and_side(self.case, self.numbers, self.takes_impact),
            f"  at leading order λ_N = {short_text(self.mean)} - (C1/α3) κ^(1-β) ε^({self.exponent}) dΘ/dτ, "
            f"κ^3 = {short_text(-self.alpha_1 / 2)}, {SCALED_TIME}",
        ]

    def value(self, tau: ExactInput, epsilon: ExactInput, digits: int = 15) -> arb:
        """lambda_N at one point, at leading order.

        >>> bool(contact_force("7/3").value(0, "1/1000") > fmpq(74, 100))
        True
        """
        small = rational(epsilon, "epsilon")
        if small <= 0:
            raise ValueError(f"epsilon: expected a number > 0, got {small}")
        slope = evaluate(tau, self.beta, derivative=1, digits=digits + 5).value
        with working_bits(self._bits(digits)):
            size = self.amplitude(digits) * arb(small) ** arb(self.exponent)
            return arb(self.mean) + self.direction * size * slope

    def _bits(self, digits: int) -> int:
        """Powers cost as many bits as their exponents have."""
        return bits_for_digits(digits) + _GUARD_BITS + int(self.exponent.height_bits())


def contact_force(
    beta: ExactInput | None = None,
    *,
    alpha_1: ExactInput | None = None,
    alpha_2: ExactInput = -1,
    alpha_3: ExactInput | None = None,
    c1: ExactInput | None = None,
) -> ContactForce:
    """The system from beta, or from the alphas, or from both when they agree.

    What is left out: alpha_1 = -1 as in the paper's figures, alpha_3 = beta alpha_1 (alpha_1 = alpha_3/beta when
    alpha_3 is given), C_1 = 1 or -1 with C_1/Gamma(-beta) > 0.

    :raises ValueError: beta and the alphas disagree; alpha_1 or alpha_3 is not negative; beta is an integer or not in
        (0, 100]; beta > 1 and alpha_2 is not negative; C_1 = 0; an argument is a ball.

    >>> contact_force("7/3").alpha_3, contact_force(alpha_3="-3/2").beta, contact_force("3/2", alpha_3=-3).alpha_1
    (-7/3, 3/2, -2)
    >>> contact_force(2, alpha_1=-1, alpha_3=-3)
    Traceback (most recent call last):
    ...
    ValueError: beta: 2 was given, but alpha_3/alpha_1 = 3
    """
    given = None if beta is None else rational(beta, "beta")
    first = None if alpha_1 is None else rational(alpha_1, "alpha_1")
    third = None if alpha_3 is None else rational(alpha_3, "alpha_3")
    for name, value in (("alpha_1", first), ("alpha_3", third)):
        if value is not None and value >= 0:
            raise ValueError(f"{name}: expected a number < 0, got {value}")
    if given is not None and given <= 0:
        raise ValueError(f"beta: expected a number in (0, {MAX_BETA}], got {given}")
    if third is None:
        if given is None:
            raise ValueError("beta: give beta, or alpha_3 (with alpha_1, -1 by default)")
        first = fmpq(-1) if first is None else first
        third = given * first
    elif first is None:
        first = fmpq(-1) if given is None else third / given
    parameter = third / first
    if given is not None and given != parameter:
        raise ValueError(f"beta: {given} was given, but alpha_3/alpha_1 = {parameter}")
    if parameter > MAX_BETA or parameter.q == 1:
        raise ValueError(f"beta: expected a number in (0, {MAX_BETA}] that is not an integer, got {parameter}")
    second = rational(alpha_2, "alpha_2")
    if parameter > 1 and second >= 0:
        raise ValueError(f"alpha_2: Case III (beta > 1) needs a number < 0, got {second}")
    charge = fmpq(gamma_sign(parameter) or 0) if c1 is None else rational(c1, "c1")
    if charge == 0:
        raise ValueError("c1: at C_1 = 0 the trajectory is the canard itself, and its force is the mean force")
    return ContactForce(parameter, first, second, third, charge)


def case_and_side(case: str | None, numbers: str, takes_impact: bool) -> str:
    """The Case (None: open, as the sign of alpha_2), the numbers, the side of C_1."""
    open_words = {None: "the sign of α2 is open, and with it the Case", "none": "no Case, between I and II"}
    words = open_words.get(case, f"Case {case}")
    side = "> 0, λ_N → +∞" if takes_impact else "< 0, λ_N → -∞"
    return f"  {words}: {numbers}: the side C1/Γ(-β) {side}"


def of_system(model: str, force: ContactForce) -> str:
    """How a statement about ``model`` with the numbers of ``force`` begins."""
    return f"{model} with {force.numbers}"


def rational(value: ExactInput, name: str) -> fmpq:
    """The input as a rational.

    :raises ValueError: a ball.
    """
    number = exact(value, name)
    if not isinstance(number, fmpq):
        raise ValueError(f"{name}: expected one exact number, got a ball")
    return number


def below_threshold(epsilon: fmpq, lower: arb) -> Evidence | None:
    """That epsilon is below every epsilon_0 whose logarithm is at least ``lower``; None where that is not certain."""
    with working_bits(int(lower.bits()) + int(epsilon.height_bits()) + 64):  # epsilon may be as near as it has digits
        return less(arb(epsilon).log(), lower)


def rounded_down(logarithm: arb, digits: int) -> fmpq | None:
    """A decimal fraction of ``digits`` digits, at most e^logarithm, cut off at 10^100; None unless e^logarithm is
    certainly at least 10^-100000.

    >>> with working_bits(64):
    ...     rounded_down(arb(fmpq(1, 3)).log(), 4), rounded_down(arb(-10**6), 4), rounded_down(arb(10**6), 4) > 1
    (3333/10000, None, True)
    """
    if not logarithm.is_finite():
        return None
    with working_bits(int(logarithm.bits()) + 4 * digits + 64):
        least = logarithm.lower()  # the exponential of a wide ball reaches below 0
        tens = (least / arb(10).log()).lower()
        if not tens >= LEAST_TENS:
            return None
        if tens > _MOST_TENS:
            return fmpq(10) ** _MOST_TENS
        shift = digits - 1 - math.floor(approximate(tens))
        mantissa = (least + shift * arb(10).log()).exp().lower().floor().unique_fmpz()
        assert mantissa is not None  # the floor of an exact number of fewer digits than the working precision has
        return fmpq(mantissa) * fmpq(10) ** -shift
