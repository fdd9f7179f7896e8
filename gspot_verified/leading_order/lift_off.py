"""The first zero of the contact force at leading order on a half-line: a certified bracket of the lift-off time.

Proof page: ``proofs/iwc.md``, section 4.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from flint import arb, fmpq

from gspot_verified.leading_order.contact_force import ContactForce
from gspot_verified.leading_order.force_refutation import force_refutation
from gspot_verified.leading_order.stretches import NotAbove, first_crossing, stretches
from gspot_verified.numbers.balls import ball_text, hull, working_bits
from gspot_verified.numbers.short_text import decimal_text, short_text
from gspot_verified.numbers.verdict import NoTruthValue, Reason, Verdict
from gspot_verified.numbers.written import Written
from gspot_verified.work.ranges import Range

GROWTH_EXPONENTS = (10, 100, 1_000, 10_000)
_GROWTH_DIGITS = 3  # of the times in a table
_CRITICAL_DIGITS = 15  # of the critical points, at least: values there settle signs


@dataclass(frozen=True, slots=True)
class LiftOff(NoTruthValue, Written):
    """lambda_N > 0 on [start, lower], and it has one zero, with a change of sign, in the open interval (lower, upper).

    ``number`` counts the zeros on [start, infinity); ``ratio`` is the time over ((beta-1) ln(1/epsilon))^(2/3), for
    beta > 1 and epsilon < 1; ``whole_line``: lambda_N > 0 to the left of the start as well. Without a proof both ends
    are None and the verdict says why.
    """

    written: ClassVar[str] = "epsilon bracket zeros=number ratio verdict"

    epsilon: fmpq
    lower: fmpq | None
    upper: fmpq | None
    number: int | None
    ratio: arb | None
    whole_line: bool
    verdict: Verdict

    @property
    def bracket(self) -> tuple[fmpq, fmpq] | None:
        """Both ends, where they are known."""
        return None if self.lower is None or self.upper is None else (self.lower, self.upper)

    def __str__(self) -> str:
        where = f"ε = {short_text(self.epsilon)}, at leading order:"
        if self.lower is None or self.upper is None:
            return f"{where} {self.verdict.outcome.value}"
        ratio = "" if self.ratio is None else f", over ((β-1) ln(1/ε))^(2/3): {ball_text(self.ratio, 4)}"
        return f"{where} lift-off in {decimal_text(self.lower, self.upper)}{ratio}"


def lift_off(force: ContactForce, epsilon: fmpq, start: fmpq, digits: int = 15) -> LiftOff:
    """The first zero of lambda_N on [start, infinity), where C_1/Gamma(-beta) < 0.

    :raises ValueError: C_1/Gamma(-beta) > 0.

    >>> from gspot_verified.leading_order.contact_force import contact_force
    >>> print(lift_off(contact_force("3/2", c1=-1), fmpq(1, 1000), fmpq(-10), 6))
    ε = 0.001, at leading order: lift-off in 3.590583..3.590584, over ((β-1) ln(1/ε))^(2/3): [1.571 +/- 4.26e-4]
    """
    where = f"{force.system}, at ε = {short_text(epsilon)}"
    least = max(digits, _CRITICAL_DIGITS)
    for accuracy in (least, 4 * least):
        shape = stretches(force.beta, force.direction, start, accuracy)
        try:
            crossing = first_crossing(shape, lambda places: force.level(epsilon, places), digits)
        except NotAbove:
            text = f"{where}: λ_N > 0 at τ = {start}"
            against = force_refutation(force, text, Range(start, start, True, True), [start], epsilon)
            if against is not None:
                return LiftOff(epsilon, None, None, None, None, False, against.verdict)
            crossing = None
        if crossing is not None:
            break
    if crossing is None:
        text = f"{where}: the first zero of λ_N on [{start}, inf)"
        verdict = Verdict.undecided(text, Reason.BUDGET, "a least or greatest value of λ_N is too close to 0")
        return LiftOff(epsilon, None, None, None, None, False, verdict)
    lower, upper, number = crossing.lower, crossing.upper, crossing.number
    text = f"{where}: λ_N > 0 on [{start}, τ_LO) and λ_N changes sign at τ_LO, τ_LO in ({decimal_text(lower, upper)})"
    count = "" if number is None else f"zeros of λ_N on [{start}, inf): {number}"
    ratio = None
    if force.beta > 1 and epsilon < 1:
        with working_bits(128):
            law = (arb(force.beta - 1) * -arb(epsilon).log()) ** arb(fmpq(2, 3))
            ratio = hull([arb(lower), arb(upper)]) / law
    proved = Verdict.proved(text, crossing.evidence, count)
    return LiftOff(epsilon, lower, upper, number, ratio, shape.whole_line, proved)


def growth_table(force: ContactForce, start: fmpq) -> tuple[LiftOff, ...]:
    """The lift-off times for epsilon = 10^-10 ... 10^-10000, to three decimals."""
    return tuple(lift_off(force, fmpq(10) ** -exponent, start, _GROWTH_DIGITS) for exponent in GROWTH_EXPONENTS)
