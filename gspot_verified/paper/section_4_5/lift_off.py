"""Certified brackets of the lift-off time at leading order, for the growth law of Section 4.5."""

from __future__ import annotations

from dataclasses import dataclass

from flint import arb, fmpq

from gspot_verified.leading_order.stretches import narrowed
from gspot_verified.numbers.balls import ball_text, hull, working_bits
from gspot_verified.paper.checks.formulas import rational_value
from gspot_verified.paper.section_4_5.section_4_5 import PRINTED as FORCE
from gspot_verified.theta_function.value.evaluate import evaluate

PRINTED: dict[str, dict[str, str]] = {"S-growth": {"power": "2/3", "rate": "beta-1"}}
"""The lift-off time is (rate ln(1/epsilon))^power; the paper prints the power, the rate is added here."""
_EXPONENTS = (10, 100, 1_000, 10_000)


@dataclass(frozen=True, slots=True)
class GrowthBracket:
    """At epsilon = 10^-exponent: a zero of lambda_N lies in [lower, upper], and its ratio to the law in ``ratio``.

    ``closer_than_before``: the ratio is certainly nearer to 1 than at the previous epsilon.
    """

    beta: fmpq
    exponent: int
    lower: fmpq
    upper: fmpq
    ratio: arb
    closer_than_before: bool

    def __str__(self) -> str:
        return f"β = {self.beta}, ε = 1e-{self.exponent}: ratio {ball_text(self.ratio, 4)}"


def growth_brackets(betas: tuple[fmpq, ...] = (fmpq(3, 2), fmpq(5, 2))) -> list[GrowthBracket]:
    """Brackets for epsilon = 10^-10 .. 10^-10000 with C_1/Gamma(-beta) < 0 and the constant in front of Theta'
    equal to 1.

    There ln |dTheta/dtau| = ((2 beta - 2)/3) ln(1/epsilon). Beyond tau = 2, where the search begins, dTheta/dtau has
    the sign of 1/Gamma(-beta) for these beta (S-plus-infinity).
    """
    found = []
    for beta in betas:
        before: arb | None = None
        for exponent in _EXPONENTS:
            bracket = _bracket(beta, exponent, before)
            before = bracket.ratio
            found.append(bracket)
    return found


def _bracket(beta: fmpq, exponent: int, before: arb | None) -> GrowthBracket:
    growth = PRINTED["S-growth"]
    with working_bits(128):
        large = exponent * arb(10).log()
        goal = rational_value(FORCE["S-dominance"]["exponent"], beta=beta) * large
        law = (rational_value(growth["rate"], beta=beta) * large) ** arb(rational_value(growth["power"]))
    lower, upper = fmpq(2), fmpq(4 * exponent + 40)
    # Without a certain change of sign between the ends nothing is bracketed.
    bracketed = _above(lower, beta, goal) is False and _above(upper, beta, goal) is True
    if bracketed:
        lower, upper = narrowed(lambda tau: _above(tau, beta, goal), lower, upper, 3)
    with working_bits(128):
        ratio = hull([arb(lower), arb(upper)]) / law
        closer = bracketed and (before is None or bool(abs(ratio - 1) < abs(before - 1)))
    return GrowthBracket(beta, exponent, lower, upper, ratio, closer)


def _above(tau: fmpq, beta: fmpq, goal: arb) -> bool | None:
    """Whether ln |dTheta/dtau| > goal at tau, certainly."""
    slope = abs(evaluate(tau, beta, derivative=1, digits=20).value)
    if not slope > 0:
        return None
    with working_bits(128):
        difference = slope.log() - goal
    return True if difference > 0 else False if difference < 0 else None
