"""The contact force at leading order for every alpha_1, alpha_2, alpha_3 in balls: one epsilon_0 for all of these
systems, or one bracket that holds the lift-off time of each.

Proof page: ``proofs/iwc.md``, section 6.
"""

from __future__ import annotations

from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.leading_order.contact_force import LEADING
from gspot_verified.leading_order.force_over_balls import FOR_ALL, ForceOverBalls, OpenHypothesis, force_over_balls
from gspot_verified.leading_order.force_refutation import force_refutation
from gspot_verified.leading_order.iwc import (
    BY_THEOREM,
    PAPER_EPSILON,
    IwcAnswer,
    Question,
    below_a_threshold,
    force_statement,
    question,
)
from gspot_verified.leading_order.lift_off import LiftOff
from gspot_verified.leading_order.stretches import NotAbove, Stretches, first_crossing, minimum
from gspot_verified.leading_order.stretches_over_ball import stretches_over_ball
from gspot_verified.numbers.balls import ExactInput, hull, working_bits
from gspot_verified.numbers.evidence import at_most, every, less, theorem
from gspot_verified.numbers.short_text import decimal_text, short_text
from gspot_verified.numbers.verdict import Reason, Verdict
from gspot_verified.signs.zeros.slope_at import UndecidedError
from gspot_verified.work.ranges import Range


@dataclass(frozen=True, slots=True)
class IwcOverBalls(IwcAnswer):
    """The answer for all systems with their alphas in the balls.

    ``epsilon_0`` is certainly below the largest possible one of every system, ``largest_epsilon`` and ``minimum``
    contain theirs; ``minimum`` also says where. ``force`` is None when the balls are too wide to say what they are
    about.
    """

    force: ForceOverBalls | None


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

    >>> iwc_over_balls(-1, -1, arb("-1.5", "1e-9"), digits=6).verdict.statement.split(": ")[1]
    'λ_N > 0 for every τ in [-10, inf) and every ε in (0, 0.178818)'
    """
    asked = question(tau_start, epsilon, digits)
    start = asked.start
    text = f"{LEADING}, {FOR_ALL}, the sign of λ_N on [{start}, inf)"
    try:
        force = force_over_balls(alpha_1, alpha_2, alpha_3, c1)
    except OpenHypothesis as error:
        return IwcOverBalls(None, start, False, Verdict.undecided(text, Reason.WIDE_INPUT, str(error)))
    by = theorem("proofs/signs.md", less(force.beta, 1), at_most(0, force.mean())) if force.takes_impact else None
    if by is not None:
        verdict = Verdict.proved(force_statement(None, asked.epsilon, None, force.system), by, BY_THEOREM)
        return IwcOverBalls(force, start, True, verdict, every_epsilon=True)
    try:
        shape = stretches_over_ball(force.beta, force.direction, start, digits)
    except UndecidedError as error:
        return IwcOverBalls(force, start, False, Verdict.undecided(text, Reason.WIDE_INPUT, str(error)))
    if not all(piece.value.is_finite() for piece in (shape.start, *shape.critical)):
        detail = "dΘ/dτ at the start or at a critical point has no finite ball"
        return IwcOverBalls(force, start, False, Verdict.undecided(text, Reason.WIDE_INPUT, detail))
    if force.takes_impact:
        return _impact(force, shape, asked)
    return _lift_off(force, shape, PAPER_EPSILON if asked.epsilon is None else asked.epsilon, digits)


def _impact(force: ForceOverBalls, shape: Stretches, asked: Question) -> IwcOverBalls:
    least = minimum(shape)
    nowhere_less = every([less(1, force.beta), at_most(0, least.value.lower())])
    if nowhere_less is not None:
        verdict = Verdict.proved(force_statement(asked.start, asked.epsilon, None, force.system), nowhere_less)
        return IwcOverBalls(force, asked.start, False, verdict, least, every_epsilon=True)
    return below_a_threshold(IwcOverBalls, force, shape, asked)


def _lift_off(force: ForceOverBalls, shape: Stretches, epsilon: fmpq, digits: int) -> IwcOverBalls:
    start, where = shape.start.lower, f"{force.system}, at ε = {short_text(epsilon)}"
    crossing, verdict = None, None
    try:
        crossing = first_crossing(shape, lambda places: force.level(epsilon, places), digits)
    except NotAbove:
        asked = Range(start, None, True, False)
        against = force_refutation(force, f"{where}: λ_N > 0 at τ = {start}", asked, [start], epsilon)
        verdict = None if against is None else against.verdict
    if crossing is None:
        if verdict is None:
            detail = "a least or greatest value of λ_N is > 0 for some of them, perhaps, and < 0 for others"
            text = f"{where}: the first zero of λ_N on [{start}, inf)"
            verdict = Verdict.undecided(text, Reason.WIDE_INPUT, detail)
        nothing = LiftOff(epsilon, None, None, None, None, False, verdict)
        return IwcOverBalls(force, start, False, verdict, lift_off=nothing)
    lower, upper, number = crossing.lower, crossing.upper, crossing.number
    text = f"{where}: λ_N > 0 on [{start}, τ_LO) and λ_N changes sign at τ_LO, τ_LO in ({decimal_text(lower, upper)})"
    verdict = Verdict.proved(
        text, crossing.evidence, "" if number is None else f"zeros of λ_N on [{start}, inf): {number}"
    )
    ratio = None
    if force.beta > 1 and epsilon < 1:
        with working_bits(128):
            ratio = hull([arb(lower), arb(upper)]) / ((force.beta - 1) * -arb(epsilon).log()) ** arb(fmpq(2, 3))
    time = LiftOff(epsilon, lower, upper, number, ratio, shape.whole_line, verdict)
    return IwcOverBalls(force, start, shape.whole_line, verdict, lift_off=time)
