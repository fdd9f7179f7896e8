"""What the sign of C_1 means at a mechanism's G-spot: lift-off or impact without collision, for small epsilon.

Proof page: ``proofs/papers_rule.md``, Theorem R; its hypotheses at the G-spot are compared here.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from gspot_verified.expansion.from_state.limit_side import OTHER, rule_of
from gspot_verified.expansion.series.regularisation import NO_DAMPER
from gspot_verified.functions.rings import BALLS
from gspot_verified.mechanisms.approach.mechanism_side import active_components, independent
from gspot_verified.mechanisms.approach.slip_flow import SlipFlow, SlipNumbers
from gspot_verified.mechanisms.derive.to_system import shift
from gspot_verified.mechanisms.input.mechanism import Mechanism
from gspot_verified.mechanisms.spots.classify import case_of
from gspot_verified.mechanisms.spots.g_spot import DEFAULT_BITS, place_in, prove_near
from gspot_verified.numbers.balls import ShownBall, working_bits
from gspot_verified.numbers.evidence import every, less
from gspot_verified.numbers.verdict import Evidence, NoTruthValue
from gspot_verified.numbers.written import Written

_RESTS_ON = (
    "sides rest on proofs/papers_rule.md, Theorem R, for starts at rest in the contact; epsilon_0, one for each state, "
    "is not computed"
)


@dataclass(frozen=True)
class SpotSides(NoTruthValue, Written):
    """The G-spot's Case and beta, and what follows C_1 < 0 and C_1 > 0 there: "lift-off" or "impact" (without
    collision), for every epsilon below some epsilon_0 > 0 that belongs to the start and is not computed; None: open,
    ``why`` says what is missing. The start is at rest in the contact: v = 0, lambda_N = -b/p, y = -epsilon^2
    lambda_N/kappa, or next to it as Theorem R says."""

    ask: ClassVar[str] = ".below and .above are the sides by the sign of C_1"
    written: ClassVar[str] = "case beta below above why rests_on"

    case: str | None
    beta: ShownBall
    below: str | None
    above: str | None
    why: str
    evidence: Evidence | None

    @property
    def rests_on(self) -> str:
        """Of which starts and which epsilon the sides hold; empty where there are none."""
        return "" if self.why else _RESTS_ON


def spot_sides(mechanism: Mechanism) -> SpotSides:
    """Theorem R's hypotheses at the G-spot at the mechanism's place.

    :raises GSpotError: there is none.
    """
    with working_bits(DEFAULT_BITS):
        shifted = shift(mechanism)
        spot = prove_near(shifted, place_in(shifted, BALLS), DEFAULT_BITS)
        place = spot.system.point
        flow = SlipFlow.of(shifted)
        numbers = SlipNumbers(flow)
        star = numbers.on(place)
        alphas = (star.alpha_1, star.alpha_2, star.alpha_3)
        beta = star.alpha_3 / star.alpha_1
        case, why = case_of(*alphas)
        if case != "III":
            reason = f"Theorem R is about Case III: {why if case in (None, 'none') else f'Case {case}'}"
            return SpotSides(case, beta, None, None, reason, None)
        if not mechanism.regularisation.c > 0:
            return SpotSides(case, beta, None, None, NO_DAMPER, None)
        rule = rule_of(beta, mechanism.regularisation)
        if rule is None:
            return SpotSides(case, beta, None, None, "beta is, or may be, an integer", None)
        regular = independent(numbers, active_components(flow), place)
        shown = every([spot.shown, rule[1], regular, *(less(each, 0) for each in alphas)])
        if shown is None:
            return SpotSides(case, beta, None, None, "p, b, y, v may be dependent at the G-spot", None)
        return SpotSides(case, beta, OTHER[rule[0]], rule[0], "", shown)
