"""The contact force at leading order on a half-line: a certified epsilon_0 below which it stays positive (impact
without collision), or a certified bracket of the lift-off time.

Proof page: ``proofs/iwc.md``. "At leading order" is the paper's approximation; its error is not bounded here. What
holds for the compliant model is in ``compliant/contact/iwc.py``.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, TypeVar

from flint import arb, fmpq

from gspot_verified.leading_order.contact_force import (
    LEAST_TENS,
    ContactForce,
    below_threshold,
    contact_force,
    rational,
    rounded_down,
)
from gspot_verified.leading_order.force_over_balls import ForceOverBalls
from gspot_verified.leading_order.force_refutation import force_refutation
from gspot_verified.leading_order.lift_off import LiftOff, growth_table, lift_off
from gspot_verified.leading_order.stretches import Bracket, Stretches, minimum, stretches
from gspot_verified.numbers.balls import ExactInput, ball_text, hull, working_bits
from gspot_verified.numbers.evidence import at_most, less, theorem
from gspot_verified.numbers.short_text import decimal_text, short_text
from gspot_verified.numbers.verdict import NoTruthValue, Outcome, Verdict
from gspot_verified.numbers.written import Written
from gspot_verified.work.ranges import Range

MAX_DIGITS = 100  # a limit of input: ValueError beyond it
MAX_START = 10**6  # of |tau_start|; a limit of input: ValueError beyond it
PAPER_EPSILON = fmpq(1, 1000)  # of the paper's figures
BY_THEOREM = "the deviation of λ_N is > 0 for every real τ and every ε > 0: dΘ/dτ < 0 for 0 < β < 1 (proofs/signs.md)"
CAVEAT = '"at leading order" is the paper\'s approximation; its error is not bounded here'


@dataclass(frozen=True, slots=True)
class IwcAnswer(NoTruthValue, Written):
    """The verdict for one sign of C_1, and the numbers behind it.

    On the side C_1/Gamma(-beta) > 0: ``epsilon_0``, a number certainly below the largest possible one, which
    ``largest_epsilon`` encloses; both None when ``every_epsilon``. ``minimum``: where sign(C_1) dTheta/dtau is least
    on [start, infinity), and that value. On the other side: ``lift_off`` and the table ``growth``. ``whole_line``: the
    verdict, when proved, holds to the left of ``start`` as well.
    """

    written: ClassVar[str] = (
        "force start whole_line verdict minimum=minimum.value minimum_at=minimum.ends every_epsilon epsilon_0 "
        "largest_epsilon lift_off growth"
    )

    force: ContactForce | ForceOverBalls | None
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
        lines = [str(self.verdict), *([] if self.force is None else self.force.lines())]
        if self.minimum is not None:
            lower, upper = self.minimum.ends
            place = f"= {lower}" if lower == upper else f"in {decimal_text(lower, upper)}"
            value = ball_text(self.minimum.value)
            lines.append(f"  least value of sign(C1) dΘ/dτ on [{self.start}, inf): {value} at τ {place}")
        if self.largest_epsilon is not None:
            lines.append(f"  the largest ε0 possible at leading order: {ball_text(self.largest_epsilon)}")
        if self.lift_off is not None:
            lines.append(f"  {self.lift_off}")
        lines += [f"  {row}" for row in self.growth]
        if self.whole_line and not self.every_epsilon and self.verdict.outcome is Outcome.PROVED:
            what = "it holds" if self.lift_off is None else "λ_N > 0"
            lines.append(f"  {what} for every τ < {self.start} as well")
        return lines


@dataclass(frozen=True, slots=True)
class IwcResult(IwcAnswer):
    """The answer for one system."""

    force: ContactForce


Answer = TypeVar("Answer", bound=IwcAnswer)


@dataclass(frozen=True, slots=True)
class Question:
    """From when on, at which epsilon (None: for all small ones), and to how many digits."""

    start: fmpq
    epsilon: fmpq | None
    digits: int


def question(tau_start: ExactInput, epsilon: ExactInput | None, digits: int) -> Question:
    """The question in exact numbers.

    :raises TypeError: a float.
    :raises ValueError: |tau_start| > 10^6; epsilon <= 0; digits not in 1..100.
    """
    start = rational(tau_start, "tau_start")
    if abs(start) > MAX_START:
        raise ValueError(f"tau_start: expected |tau_start| <= {MAX_START}")
    small = None if epsilon is None else rational(epsilon, "epsilon")
    if small is not None and small <= 0:
        raise ValueError(f"epsilon: expected a number > 0, got {small}")
    if not 1 <= digits <= MAX_DIGITS:
        raise ValueError(f"digits must lie in 1..{MAX_DIGITS}")
    return Question(start, small, digits)


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

    >>> leading_order_iwc("3/2", c1=1).verdict.statement.split(": ")[1]
    'λ_N > 0 for every τ in [-10, inf) and every ε in (0, 0.17881880065137)'
    """
    force = contact_force(beta, alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3, c1=c1)
    asked = question(tau_start, epsilon, digits)
    if growth and (force.takes_impact or force.beta < 1):
        raise ValueError("growth: the table needs beta > 1 and the sign of C_1 with C_1/Gamma(-beta) < 0")
    if force.takes_impact:
        return _impact(force, asked)
    loss = lift_off(force, PAPER_EPSILON if asked.epsilon is None else asked.epsilon, asked.start, digits)
    rows = growth_table(force, asked.start) if growth else ()
    return IwcResult(force, asked.start, loss.whole_line, loss.verdict, lift_off=loss, growth=rows)


def _impact(force: ContactForce, asked: Question) -> IwcResult:
    shape = stretches(force.beta, force.direction, asked.start, asked.digits)
    least = minimum(shape)
    # lambda_N > 0 where the mean force and the least deviation are both >= 0, one of them > 0: dTheta/dtau < 0 for
    # beta < 1 by proofs/signs.md, without numbers.
    whole = force.beta < 1
    nowhere_less = at_most(0, force.mean) if whole else at_most(0, least.value.lower())
    if nowhere_less is not None:
        by = theorem("proofs/signs.md", less(force.beta, 1), nowhere_less) if whole else nowhere_less
        text = force_statement(None if whole else asked.start, asked.epsilon, None, force.system)
        verdict = Verdict.proved(text, by, BY_THEOREM if whole else "")
        return IwcResult(force, asked.start, whole, verdict, least, every_epsilon=True)
    return below_a_threshold(IwcResult, force, shape, asked)


def below_a_threshold(
    kind: type[Answer], force: ContactForce | ForceOverBalls, shape: Stretches, asked: Question
) -> Answer:
    """The answer where the force is positive below some epsilon_0 only."""
    least = minimum(shape)
    lower, upper = _log_bounds(force, least.value, asked.digits)
    epsilon_0 = rounded_down(lower, asked.digits)
    if asked.epsilon is not None:
        verdict = at_epsilon(force, shape, asked.epsilon, lower)
    elif epsilon_0 is None or (below := below_threshold(epsilon_0, lower)) is None:
        text = f"{force.system}: some ε0 > 0 with λ_N > 0 for every τ in [{asked.start}, inf) and every ε in (0, ε0)"
        verdict = Verdict.undecided(text, force.left_open, f"no ε0 above 10^{LEAST_TENS} was found")
    else:
        verdict = Verdict.proved(force_statement(asked.start, None, epsilon_0, force.system), below, _by_theorem(force))
    whole = shape.whole_line and bool(shape.critical)
    return kind(
        force, asked.start, whole, verdict, least, epsilon_0=epsilon_0, largest_epsilon=_exponential(lower, upper)
    )


def _log_bounds(force: ContactForce | ForceOverBalls, least: arb, digits: int) -> tuple[arb, arb]:
    """Of the logarithm of the largest epsilon_0; the upper one is not finite where the least value may be 0."""
    accuracy = 2 * digits
    return force.log_epsilon(least.lower(), accuracy).lower(), force.log_epsilon(least.upper(), accuracy).upper()


def _exponential(lower: arb, upper: arb) -> arb | None:
    if not (lower > 3 * LEAST_TENS and upper < -3 * LEAST_TENS):
        return None
    with working_bits(int(max(lower.bits(), upper.bits())) + 64):
        return hull([lower.exp(), upper.exp()])


def _by_theorem(force: ContactForce | ForceOverBalls) -> str:
    return BY_THEOREM if force.beta < 1 else ""


def force_statement(start: fmpq | None, epsilon: fmpq | None, bound: fmpq | None, system: str) -> str:
    """That the force of ``system`` is > 0 from ``start`` on (None: everywhere), at ``epsilon`` or below ``bound``."""
    tau = "every real τ" if start is None else f"every τ in [{start}, inf)"
    if epsilon is not None:
        return f"{system}: λ_N > 0 for {tau} at ε = {short_text(epsilon)}"
    return f"{system}: λ_N > 0 for {tau} and " + (
        "every ε > 0" if bound is None else f"every ε in (0, {short_text(bound)})"
    )


def at_epsilon(force: ContactForce | ForceOverBalls, shape: Stretches, epsilon: fmpq, lower: arb) -> Verdict:
    """Whether lambda_N > 0 on [start, infinity) at epsilon; ``lower`` is at most the logarithm of the largest
    epsilon_0 (of every system)."""
    start = shape.start.lower
    text = force_statement(start, epsilon, None, force.system)
    below = below_threshold(epsilon, lower)
    if below is not None:
        return Verdict.proved(text, below, _by_theorem(force))
    # The place of the least value first, as a heuristic: whichever serves is a witness.
    pieces = sorted([shape.start, *shape.critical], key=lambda piece: piece.value.mid())
    places = [(piece.lower + piece.upper) / 2 for piece in pieces]
    against = force_refutation(force, text, Range(start, None, True, False), places, epsilon)
    if against is not None:
        return against.verdict
    return Verdict.undecided(text, force.left_open, force.too_close)
