"""The contact force at leading order on a half-line: a certified epsilon_0 below which it stays positive (impact
without collision), or a certified bracket of the lift-off time.

Proof page: ``proofs/iwc.md``. "At leading order" is the paper's approximation; its error is not bounded here. What
holds for the compliant model is in ``compliant/contact/iwc.py``.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from flint import arb, fmpq

from gspot_verified.leading_order.contact_force import (
    LEAST_TENS,
    ContactForce,
    below_threshold,
    contact_force,
    rational,
    rounded_down,
)
from gspot_verified.leading_order.force_refutation import force_refutation
from gspot_verified.leading_order.lift_off import LEADING, LiftOff, growth_table, lift_off
from gspot_verified.leading_order.stretches import Bracket, Stretches, minimum, stretches
from gspot_verified.numbers.balls import ExactInput, ball_text, hull, working_bits
from gspot_verified.numbers.evidence import at_most, less, theorem
from gspot_verified.numbers.short_text import decimal_text, short_text
from gspot_verified.numbers.verdict import ASK_VERDICT, NoTruthValue, Outcome, Reason, Verdict
from gspot_verified.numbers.written import Written
from gspot_verified.work.ranges import Range

MAX_DIGITS = 100  # a limit of input: ValueError beyond it
MAX_START = 10**6  # of |tau_start|; a limit of input: ValueError beyond it
PAPER_EPSILON = fmpq(1, 1000)  # of the paper's figures
CAVEAT = '"at leading order" is the paper\'s approximation; its error is not bounded here'


@dataclass(frozen=True, slots=True)
class IwcResult(NoTruthValue, Written):
    """The verdict for one system and one sign of C_1, and the numbers behind it.

    On the side C_1/Gamma(-beta) > 0: ``epsilon_0``, a number certainly below the largest possible one, which
    ``largest_epsilon`` encloses; both None when ``every_epsilon``. ``minimum``: where sign(C_1) dTheta/dtau is least
    on [start, infinity), and that value. On the other side: ``lift_off`` and the table ``growth``. ``whole_line``: the
    verdict, when proved, holds to the left of ``start`` as well.
    """

    ask: ClassVar[str] = ASK_VERDICT
    written: ClassVar[str] = (
        "force start whole_line verdict minimum=minimum.value minimum_at=minimum.ends every_epsilon epsilon_0 "
        "largest_epsilon lift_off growth"
    )

    force: ContactForce
    start: fmpq
    whole_line: bool
    verdict: Verdict
    minimum: Bracket | None = None
    every_epsilon: bool = False
    epsilon_0: fmpq | None = None
    largest_epsilon: arb | None = None
    lift_off: LiftOff | None = None
    growth: tuple[LiftOff, ...] = ()

    def __str__(self) -> str:
        return "\n".join([*self.lines(), f"  {CAVEAT}"])

    def lines(self) -> list[str]:
        """The lines of the text without the last one, which says what "at leading order" leaves open."""
        force = self.force
        case = "no Case, between I and II" if force.case == "none" else f"Case {force.case}"
        side = "> 0, λ_N → +∞" if force.takes_impact else "< 0, λ_N → -∞"
        lines = [
            str(self.verdict),
            f"  {case}: β = {force.beta}, α1 = {short_text(force.alpha_1)}, α2 = {short_text(force.alpha_2)}, "
            f"α3 = {short_text(force.alpha_3)}, C1 = {short_text(force.c1)}: the side C1/Γ(-β) {side}",
            f"  λ_N = {short_text(force.mean)} - (C1/α3) κ^(1-β) ε^({force.exponent}) dΘ/dτ, "
            f"κ^3 = {short_text(-force.alpha_1 / 2)}",
        ]
        if self.minimum is not None:
            place = _place(self.minimum)
            value = ball_text(self.minimum.value, 15)
            lines.append(f"  least value of sign(C1) dΘ/dτ on [{self.start}, inf): {value} at τ = {place}")
        if self.largest_epsilon is not None:
            lines.append(f"  the largest ε0 possible: {ball_text(self.largest_epsilon, 15)}")
        if self.lift_off is not None:
            lines.append(f"  {self.lift_off}")
        lines += [f"  {row}" for row in self.growth]
        if self.whole_line and not self.every_epsilon and self.verdict.outcome is Outcome.PROVED:
            lines.append(f"  it holds for every τ < {self.start} as well")
        return lines


def leading_order_iwc(
    beta: ExactInput | None = None,
    *,
    alpha_1: ExactInput | None = None,
    alpha_2: ExactInput = -1,
    alpha_3: ExactInput | None = None,
    c1: ExactInput | None = None,
    tau_start: ExactInput = -10,
    epsilon: ExactInput | None = None,
    digits: int = 15,
    growth: bool = False,
) -> IwcResult:
    """Whether the contact holds on [tau_start, infinity) at leading order, for all small epsilon, or when it lifts off.

    On the side C_1/Gamma(-beta) > 0: epsilon_0, or with ``epsilon`` the answer at that epsilon. On the other side: the
    lift-off time at ``epsilon`` (1/1000 by default, as in the paper's figures), to ``digits`` decimals, and with
    ``growth`` a table for epsilon = 10^-10 ... 10^-10000. beta, the alphas and C_1: see :func:`contact_force`.

    :raises TypeError: a float.
    :raises ValueError: an argument out of range: see :func:`contact_force`; |tau_start| > 10^6; epsilon <= 0; digits
        not in 1..100; ``growth`` on the side that does not lift off, or with beta < 1.

    >>> leading_order_iwc("3/2", c1=1).verdict.statement
    'at leading order, λ_N > 0 for every τ in [-10, inf) and every ε in (0, 0.17881880065137)'
    """
    force = contact_force(beta, alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3, c1=c1)
    start = rational(tau_start, "tau_start")
    if abs(start) > MAX_START:
        raise ValueError(f"tau_start: expected |tau_start| <= {MAX_START}")
    small = None if epsilon is None else rational(epsilon, "epsilon")
    if small is not None and small <= 0:
        raise ValueError(f"epsilon: expected a number > 0, got {small}")
    if not 1 <= digits <= MAX_DIGITS:
        raise ValueError(f"digits must lie in 1..{MAX_DIGITS}")
    if growth and (force.takes_impact or force.beta < 1):
        raise ValueError("growth: the table needs beta > 1 and the sign of C_1 with C_1/Gamma(-beta) < 0")
    if force.takes_impact:
        return _impact(force, start, small, digits)
    loss = lift_off(force, PAPER_EPSILON if small is None else small, start, digits)
    rows = growth_table(force, start) if growth else ()
    return IwcResult(force, start, loss.whole_line, loss.verdict, lift_off=loss, growth=rows)


def _impact(force: ContactForce, start: fmpq, epsilon: fmpq | None, digits: int) -> IwcResult:
    shape = stretches(force.beta, force.direction, start, digits)
    least = minimum(shape)
    # lambda_N > 0 where the mean force and the least deviation are both >= 0, one of them > 0: dTheta/dtau < 0 for
    # beta < 1 by proofs/signs.md, without numbers.
    whole = force.beta < 1
    nowhere_less = at_most(0, force.mean) if whole else at_most(0, least.value.lower())
    if nowhere_less is not None:
        by = theorem("proofs/signs.md", less(force.beta, 1), nowhere_less) if whole else nowhere_less
        verdict = Verdict.proved(force_statement(None if whole else start, epsilon, None), by, _by_theorem(force))
        return IwcResult(force, start, whole, verdict, least, every_epsilon=True)
    whole = shape.whole_line and bool(shape.critical)
    log_lower, log_upper = _log_bounds(force, least.value, digits)
    size = None if log_upper is None else _exponential(log_lower, log_upper)
    epsilon_0 = rounded_down(log_lower, digits)
    if epsilon is not None:
        verdict = at_epsilon(force, shape, epsilon, log_lower)
    elif epsilon_0 is None or (below := below_threshold(epsilon_0, log_lower)) is None:
        text = f"{LEADING}, some ε0 > 0 with λ_N > 0 for every τ in [{start}, inf) and every ε in (0, ε0)"
        verdict = Verdict.undecided(text, Reason.BUDGET, f"no ε0 above 10^{LEAST_TENS} was found")
    else:
        verdict = Verdict.proved(force_statement(start, None, epsilon_0), below, _by_theorem(force))
    return IwcResult(
        force=force,
        start=start,
        whole_line=whole,
        verdict=verdict,
        minimum=least,
        every_epsilon=False,
        epsilon_0=epsilon_0,
        largest_epsilon=size,
    )


def _by_theorem(force: ContactForce) -> str:
    if force.beta > 1:
        return ""
    return "the deviation of λ_N is > 0 for every real τ and every ε > 0: dΘ/dτ < 0 for 0 < β < 1 (proofs/signs.md)"


def force_statement(start: fmpq | None, epsilon: fmpq | None, bound: fmpq | None, system: str = LEADING) -> str:
    """That the force of ``system`` is > 0 from ``start`` on (None: everywhere), at ``epsilon`` or below ``bound``."""
    tau = "every real τ" if start is None else f"every τ in [{start}, inf)"
    if epsilon is not None:
        return f"{system}, λ_N > 0 for {tau} at ε = {short_text(epsilon)}"
    return f"{system}, λ_N > 0 for {tau} and " + (
        "every ε > 0" if bound is None else f"every ε in (0, {short_text(bound)})"
    )


def _log_bounds(force: ContactForce, least: arb, digits: int) -> tuple[arb, arb | None]:
    """Bounds of the logarithm of the largest epsilon_0; no upper one where the least value may be 0."""
    accuracy = 2 * digits
    lower = force.log_epsilon(least.lower(), accuracy).lower()
    same_sign = least.upper() < 0 or least.lower() > 0
    return lower, force.log_epsilon(least.upper(), accuracy).upper() if same_sign else None


def _exponential(lower: arb, upper: arb) -> arb | None:
    if not (lower > 3 * LEAST_TENS and upper < -3 * LEAST_TENS):
        return None
    with working_bits(int(max(lower.bits(), upper.bits())) + 64):
        return hull([lower.exp(), upper.exp()])


def at_epsilon(force: ContactForce, shape: Stretches, epsilon: fmpq, lower: arb) -> Verdict:
    """Whether lambda_N > 0 on [start, infinity) at epsilon; ``lower`` is at most the logarithm of the largest
    epsilon_0."""
    start = shape.start.lower
    text = force_statement(start, epsilon, None)
    below = below_threshold(epsilon, lower)
    if below is not None:
        return Verdict.proved(text, below, _by_theorem(force))
    # The place of the least value first, as a heuristic: whichever serves is a witness.
    pieces = sorted([shape.start, *shape.critical], key=lambda piece: piece.value.mid())
    places = [(piece.lower + piece.upper) / 2 for piece in pieces]
    against = force_refutation(force, text, Range(start, None, True, False), places, epsilon)
    if against is not None:
        return against.verdict
    return Verdict.undecided(text, Reason.BUDGET, "ε is too close to the largest ε0; ask for more digits")


def _place(least: Bracket) -> str:
    return str(least.lower) if least.lower == least.upper else decimal_text(least.lower, least.upper)
