"""Whether the contact holds: what is proved at leading order, and what is proved about the compliant model itself.

Proof page: ``proofs/monotone.md``.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal

from gspot_verified.compliant.contact.slow_lift_off import SlowLiftOff, slow_lift_off
from gspot_verified.compliant.contact.slow_manifold import ABOVE, SlowManifold, impact
from gspot_verified.compliant.contact.threshold import MAX_BETA_OF_THEOREM
from gspot_verified.compliant.slow.profile import SLOW, in_range
from gspot_verified.leading_order.contact_force import rational
from gspot_verified.leading_order.force_over_balls import FOR_ALL
from gspot_verified.leading_order.iwc import CAVEAT, IwcResult, force_statement, leading_order_iwc
from gspot_verified.leading_order.iwc_over_balls import IwcOverBalls
from gspot_verified.leading_order.iwc_over_balls import iwc_over_balls as leading_order_over_balls
from gspot_verified.numbers.balls import ExactInput
from gspot_verified.numbers.evidence import less, theorem
from gspot_verified.numbers.verdict import NoTruthValue, Verdict
from gspot_verified.numbers.written import Written, under

BALLS_CAVEAT = f"{CAVEAT}; the bounds for the compliant model are made for one rational β, and the alphas are balls"
CONSTANT_ALPHAS = "α is constant, that of the G-spot: nothing is stated about the mechanism away from it"


@dataclass(frozen=True, slots=True)
class StatementOf(NoTruthValue, Written):
    """What is stated about one of the two systems."""

    written: ClassVar[str] = f"system {under('verdict', Verdict.written)}"

    system: Literal["leading order", "slow manifold"]
    verdict: Verdict


@dataclass(frozen=True, slots=True)
class CompliantIwc(NoTruthValue, Written):
    """The result of :func:`compliant_iwc`: the statement at leading order and, where a theorem covers it, the one about
    the compliant model on its slow manifold: ``slow`` where C_1/Gamma(-beta) > 0, ``lift_off`` on the other side.
    ``of_mechanism``: the alphas are those of a mechanism at its G-spot."""

    written: ClassVar[str] = "verdict leading_order=leading slow_manifold=slow slow_lift_off=lift_off statements caveat"

    leading: IwcResult | IwcOverBalls
    slow: SlowManifold | None = None
    lift_off: SlowLiftOff | None = None
    of_mechanism: bool = False

    @property
    def compliant(self) -> SlowManifold | SlowLiftOff | None:
        """What is stated about the compliant model; None where nothing is."""
        return self.lift_off if self.slow is None else self.slow

    @property
    def verdict(self) -> Verdict:
        """That of the compliant model where there is one, else that at leading order."""
        return self.leading.verdict if self.compliant is None else self.compliant.verdict

    @property
    def statements(self) -> tuple[StatementOf, ...]:
        """What is stated, each with its system and its verdict."""
        stated = [StatementOf("leading order", self.leading.verdict)]
        if self.compliant is not None:
            stated.append(StatementOf("slow manifold", self.compliant.verdict))
        if self.lift_off is not None and self.lift_off.uniform is not None:
            stated.append(StatementOf("slow manifold", self.lift_off.uniform))
        return tuple(stated)

    @property
    def caveat(self) -> str | None:
        """What is not stated; None where a theorem covers it."""
        texts = [CONSTANT_ALPHAS] if self.of_mechanism else []
        if self.compliant is None:
            texts.append(BALLS_CAVEAT if isinstance(self.leading, IwcOverBalls) else CAVEAT)
        return "; ".join(texts) or None

    def __str__(self) -> str:
        lines = [*self.leading.lines(), *(() if self.compliant is None else self.compliant.lines())]
        return "\n".join(lines if self.caveat is None else [*lines, f"  {self.caveat}"])


def compliant_iwc(
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
) -> CompliantIwc:
    """Whether the contact holds on [tau_start, infinity), or when it lifts off: at leading order, and for the compliant
    model on its slow manifold.

    Arguments and errors: :func:`gspot_verified.leading_order.iwc.leading_order_iwc`.

    On the side C_1/Gamma(-beta) > 0, for 0 < beta < 5, every epsilon_0 at leading order is one for the compliant model
    (Theorem C of the page), and the exact epsilon_0 is found, for 5 < beta < 13 by cells of epsilon (six digits, some
    seconds). On the other side the lift-off time of the compliant model is bracketed at epsilon, and compared with that
    at leading order for every smaller epsilon (1 < beta < 5).

    >>> compliant_iwc("5/2").verdict.statement.split(": ")[1]
    'λ_N > 0 for every τ in [-10, inf) and every ε in (0, 0.894881353)'
    """
    leading = leading_order_iwc(
        beta, alpha_1=alpha_1, alpha_2=alpha_2, alpha_3=alpha_3, c1=c1, tau_start=tau_start, epsilon=epsilon,
        digits=digits, growth=growth,
    )  # fmt: skip
    force, at = leading.force, None if epsilon is None else rational(epsilon, "epsilon")
    if force.takes_impact:
        return CompliantIwc(leading, impact(leading, at, digits))
    if leading.lift_off is not None and in_range(force, leading.lift_off.epsilon):
        return CompliantIwc(leading, lift_off=slow_lift_off(force, leading.lift_off, leading.start, digits))
    return CompliantIwc(leading)


def iwc_over_balls(
    alpha_1: ExactInput,
    alpha_2: ExactInput,
    alpha_3: ExactInput,
    *,
    c1: ExactInput | None = None,
    tau_start: ExactInput = -10,
    epsilon: ExactInput | None = None,
    digits: int = 15,
) -> CompliantIwc:
    """The same for all alphas in balls at once: :func:`gspot_verified.leading_order.iwc_over_balls.iwc_over_balls`.

    For 0 < beta < 5 a proved epsilon_0 holds for the compliant model too (Theorem C compares the forces of each
    system); the exact epsilon_0, the compliant lift-off time and beta > 5 need one rational beta, as their bounds are
    made for one.
    """
    leading = leading_order_over_balls(
        alpha_1, alpha_2, alpha_3, c1=c1, tau_start=tau_start, epsilon=epsilon, digits=digits
    )
    force = leading.force
    if force is None or not force.takes_impact:
        return CompliantIwc(leading)
    above = theorem("proofs/monotone.md", less(force.beta, MAX_BETA_OF_THEOREM), leading.verdict.evidence)
    if above is None:
        return CompliantIwc(leading)
    everywhere = leading.every_epsilon and leading.whole_line
    start = None if everywhere else leading.start
    at = None if epsilon is None else rational(epsilon, "epsilon")
    text = force_statement(start, at, leading.epsilon_0, f"{SLOW}, {FOR_ALL}, {force.numbers}")
    return CompliantIwc(leading, SlowManifold(Verdict.proved(text, above, ABOVE), start, leading.whole_line))
