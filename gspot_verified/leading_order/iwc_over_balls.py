"""The contact force at leading order for every alpha_1, alpha_2, alpha_3 in balls: one epsilon_0 for all of these
systems, or one bracket that holds the lift-off time of each.

Proof page: ``proofs/iwc.md``, section 6.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from flint import arb, fmpq

from gspot_verified.leading_order.contact_force import LEAST_TENS, below_threshold, rational, rounded_down
from gspot_verified.leading_order.force_over_balls import ForceOverBalls, OpenHypothesis, force_over_balls
from gspot_verified.leading_order.iwc import CAVEAT, MAX_DIGITS, MAX_START, PAPER_EPSILON, IwcResult, force_statement
from gspot_verified.leading_order.lift_off import LEADING, LiftOff
from gspot_verified.leading_order.stretches import Bracket, NotAbove, Stretches, first_crossing, minimum
from gspot_verified.leading_order.stretches_over_ball import SlopeOverBall, stretches_over_ball
from gspot_verified.numbers.balls import ExactInput, ball_text, hull, working_bits
from gspot_verified.numbers.evidence import at_most, every, less, theorem
from gspot_verified.numbers.short_text import decimal_text, short_text
from gspot_verified.numbers.verdict import ASK_VERDICT, NoTruthValue, Outcome, Reason, Verdict
from gspot_verified.numbers.written import Written
from gspot_verified.signs.cover.refutation import Failure, Refutation, refutation
from gspot_verified.signs.zeros.slope_at import UndecidedError
from gspot_verified.work.ranges import Range

FOR_ALL = "for all α1, α2, α3 in the balls"
_SYSTEM = f"{LEADING}, {FOR_ALL}"
_BY_THEOREM = "the deviation of λ_N is > 0 for every real τ and every ε > 0: dΘ/dτ < 0 for 0 < β < 1 (proofs/signs.md)"


@dataclass(frozen=True, slots=True)
class IwcOverBalls(NoTruthValue, Written):
    """The verdict for all systems with their alphas in the balls, and the numbers behind it.

    The attributes are those of :class:`leading_order.iwc.IwcResult`. ``epsilon_0`` is certainly below the
    largest possible one of every system, ``largest_epsilon`` and ``minimum`` contain theirs; ``minimum`` also says
    where. ``force`` is None when the balls are too wide to say what they are about.
    """

    ask: ClassVar[str] = ASK_VERDICT
    written: ClassVar[str] = IwcResult.written
    growth: ClassVar[tuple[LiftOff, ...]] = ()

    force: ForceOverBalls | None
    start: fmpq
    whole_line: bool
    verdict: Verdict
    minimum: Bracket | None = None
    every_epsilon: bool = False
    epsilon_0: fmpq | None = None
    largest_epsilon: arb | None = None
    lift_off: LiftOff | None = None

    def __str__(self) -> str:
        return "\n".join([*self.lines(), f"  {CAVEAT}"])

    def lines(self) -> list[str]:
        """The lines of the text without the last one, which says what "at leading order" leaves open."""
        lines, force = [str(self.verdict)], self.force
        if force is not None:
            case = "no Case, between I and II" if force.case == "none" else f"Case {force.case}"
            side = "> 0, λ_N → +∞" if force.takes_impact else "< 0, λ_N → -∞"
            balls = {"β": force.beta, "α1": force.alpha_1, "α2": force.alpha_2, "α3": force.alpha_3}
            shown = ", ".join(f"{name} = {ball_text(value)}" for name, value in balls.items())
            lines.append(f"  {case}: {shown}, C1 = {short_text(force.c1)}: the side C1/Γ(-β) {side}")
        if self.minimum is not None:
            place = decimal_text(self.minimum.lower, self.minimum.upper)
            value = ball_text(self.minimum.value)
            lines.append(f"  least value of sign(C1) dΘ/dτ on [{self.start}, inf): {value} at τ in {place}")
        if self.largest_epsilon is not None:
            lines.append(f"  the largest ε0 possible: {ball_text(self.largest_epsilon)}")
        if self.lift_off is not None:
            lines.append(f"  {self.lift_off}")
        if self.whole_line and not self.every_epsilon and self.verdict.outcome is Outcome.PROVED:
            lines.append(f"  it holds for every τ < {self.start} as well")
        return lines


def iwc_over_balls(
    alpha_1: ExactInput,
    alpha_2: ExactInput,
    alpha_3: ExactInput,
    *,
    c1: ExactInput | None = None,
    tau_start: ExactInput = -10,
    epsilon: ExactInput | None = None,
    digits: int = 15,
) -> IwcOverBalls:
    """Whether the contact holds on [tau_start, infinity) at leading order for all alphas in the balls.

    As :func:`gspot_verified.leading_order.iwc.leading_order_iwc`, with balls. Where the balls are too wide
    the verdict is undecided and says what is open.

    :raises TypeError: a float.
    :raises ValueError: C_1 = 0; |tau_start| > 10^6; epsilon <= 0; digits not in 1..100.

    >>> iwc_over_balls(-1, -1, arb("-1.5", "1e-9"), digits=6).verdict.statement
    'at leading order, for all α1, α2, α3 in the balls, λ_N > 0 for every τ in [-10, inf) and every ε in (0, 0.178818)'
    """
    start = rational(tau_start, "tau_start")
    if abs(start) > MAX_START:
        raise ValueError(f"tau_start: expected |tau_start| <= {MAX_START}")
    small = None if epsilon is None else rational(epsilon, "epsilon")
    if small is not None and small <= 0:
        raise ValueError(f"epsilon: expected a number > 0, got {small}")
    if not 1 <= digits <= MAX_DIGITS:
        raise ValueError(f"digits must lie in 1..{MAX_DIGITS}")
    text = f"{_SYSTEM}, the sign of λ_N on [{start}, inf)"
    try:
        force = force_over_balls(alpha_1, alpha_2, alpha_3, c1)
    except OpenHypothesis as error:
        return IwcOverBalls(None, start, False, Verdict.undecided(text, Reason.WIDE_INPUT, str(error)))
    by = theorem("proofs/signs.md", less(force.beta, 1), at_most(0, force.mean())) if force.takes_impact else None
    if by is not None:
        verdict = Verdict.proved(force_statement(None, small, None, _SYSTEM), by, _BY_THEOREM)
        return IwcOverBalls(force, start, True, verdict, every_epsilon=True)
    try:
        shape = stretches_over_ball(force.beta, force.direction, start, digits)
    except UndecidedError as error:
        return IwcOverBalls(force, start, False, Verdict.undecided(text, Reason.WIDE_INPUT, str(error)))
    if not all(piece.value.is_finite() for piece in (shape.start, *shape.critical)):
        detail = "dΘ/dτ at the start or at a critical point has no finite ball"
        return IwcOverBalls(force, start, False, Verdict.undecided(text, Reason.WIDE_INPUT, detail))
    if force.takes_impact:
        return _impact(force, shape, small, digits)
    return _lift_off(force, shape, PAPER_EPSILON if small is None else small, digits)


def _impact(force: ForceOverBalls, shape: Stretches, epsilon: fmpq | None, digits: int) -> IwcOverBalls:
    start, least = shape.start.lower, minimum(shape)
    nowhere_less = every([less(1, force.beta), at_most(0, least.value.lower())])
    if nowhere_less is not None:
        verdict = Verdict.proved(force_statement(start, epsilon, None, _SYSTEM), nowhere_less)
        return IwcOverBalls(force, start, False, verdict, least, every_epsilon=True)
    whole = shape.whole_line and bool(shape.critical)
    lower = force.log_epsilon(least.value.lower(), 2 * digits).lower()
    upper = force.log_epsilon(least.value.upper(), 2 * digits).upper()
    size = None
    if lower > 3 * LEAST_TENS and upper < -3 * LEAST_TENS:
        with working_bits(int(max(lower.bits(), upper.bits())) + 64):
            size = hull([lower.exp(), upper.exp()])
    epsilon_0 = rounded_down(lower, digits)
    if epsilon is not None:
        verdict = _at_epsilon(force, shape, epsilon, lower)
    elif epsilon_0 is None or (below := below_threshold(epsilon_0, lower)) is None:
        text = f"{_SYSTEM}, some ε0 > 0 with λ_N > 0 for every τ in [{start}, inf) and every ε in (0, ε0)"
        verdict = Verdict.undecided(text, Reason.WIDE_INPUT, f"no ε0 above 10^{LEAST_TENS} serves all of them")
    else:
        detail = _BY_THEOREM if force.beta < 1 else ""
        verdict = Verdict.proved(force_statement(start, None, epsilon_0, _SYSTEM), below, detail)
    return IwcOverBalls(
        force=force,
        start=start,
        whole_line=whole,
        verdict=verdict,
        minimum=least,
        every_epsilon=False,
        epsilon_0=epsilon_0,
        largest_epsilon=size,
    )


def _at_epsilon(force: ForceOverBalls, shape: Stretches, epsilon: fmpq, lower: arb) -> Verdict:
    """``lower`` is at most the logarithm of the largest epsilon_0 of every system."""
    text = force_statement(shape.start.lower, epsilon, None, _SYSTEM)
    below = below_threshold(epsilon, lower)
    if below is not None:
        return Verdict.proved(text, below)
    # The lowest place first, as a heuristic: whichever serves is a witness.
    pieces = sorted([shape.start, *shape.critical], key=lambda piece: piece.value.mid())
    against = _refutation(force, text, shape.start.lower, [(p.lower + p.upper) / 2 for p in pieces], epsilon)
    if against is not None:
        return against.verdict
    return Verdict.undecided(text, Reason.WIDE_INPUT, "ε is not below the ε0 of all of them, nor above")


def _refutation(force: ForceOverBalls, text: str, start: fmpq, places: list[fmpq], epsilon: fmpq) -> Refutation | None:
    """By a place where lambda_N < 0 for every system of the balls."""
    slope = SlopeOverBall(force.beta, max(abs(place) for place in places), 40)
    level = force.level(epsilon, 40)

    def failure(tau: fmpq) -> Failure:
        with working_bits(256):
            value = force.direction * slope.enclosure(tau, tau, 1) + level
        return f"λ_N < 0 {FOR_ALL}", less(value, 0)

    return refutation(text, {"τ": Range(start, None, True, False)}, ((tau,) for tau in places), failure)


def _lift_off(force: ForceOverBalls, shape: Stretches, epsilon: fmpq, digits: int) -> IwcOverBalls:
    start, where = shape.start.lower, f"{_SYSTEM}, at ε = {short_text(epsilon)}"
    crossing, verdict = None, None
    try:
        crossing = first_crossing(shape, lambda places: force.level(epsilon, places), digits)
    except NotAbove:
        against = _refutation(force, f"{where}, λ_N > 0 at τ = {start}", start, [start], epsilon)
        verdict = None if against is None else against.verdict
    if crossing is None:
        if verdict is None:
            detail = "a least or greatest value of λ_N is > 0 for some of them, perhaps, and < 0 for others"
            text = f"{where}, the first zero of λ_N on [{start}, inf)"
            verdict = Verdict.undecided(text, Reason.WIDE_INPUT, detail)
        nothing = LiftOff(epsilon, None, None, None, None, False, verdict)
        return IwcOverBalls(force, start, False, verdict, lift_off=nothing)
    lower, upper, number = crossing.lower, crossing.upper, crossing.number
    text = f"{where}, λ_N > 0 on [{start}, τ_lo) and λ_N changes sign at τ_lo, τ_lo in ({decimal_text(lower, upper)})"
    verdict = Verdict.proved(
        text, crossing.evidence, "" if number is None else f"zeros of λ_N on [{start}, inf): {number}"
    )
    ratio = None
    if force.beta > 1 and epsilon < 1:
        with working_bits(128):
            ratio = hull([arb(lower), arb(upper)]) / ((force.beta - 1) * -arb(epsilon).log()) ** arb(fmpq(2, 3))
    time = LiftOff(epsilon, lower, upper, number, ratio, shape.whole_line, verdict)
    return IwcOverBalls(force, start, shape.whole_line, verdict, lift_off=time)
