"""Lift-off or impact without collision for small epsilon, for every mechanism of Case III and a given beta.

Proof page: ``proofs/papers_rule.md``, Theorem R.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from flint import arb, fmpq, fmpz

from gspot_verified.expansion.from_state.slow_series import Contact, contact_text
from gspot_verified.expansion.series.regularisation import Regularisation
from gspot_verified.numbers.balls import ExactInput, exact
from gspot_verified.numbers.evidence import less, theorem
from gspot_verified.numbers.inner_text import inner_text
from gspot_verified.numbers.verdict import Evidence, NoTruthValue, Reason, Verdict
from gspot_verified.numbers.written import Written
from gspot_verified.signs.gamma.side import MAX_BETA

OTHER = {"lift-off": "impact", "impact": "lift-off"}


@dataclass(frozen=True)
class LimitSide(NoTruthValue, Written):
    """What follows C_1 > 0 for every mechanism of Case III with this beta and this contact, for small epsilon.

    ``side``: "lift-off" or "impact" (without collision) for C_1 > 0, the other one for C_1 < 0, or None: undecided.
    "For small epsilon": there is an epsilon_0 > 0 for every start (and every force that an impact is to exceed); how
    large it is is not said, nor that an impact is completed.
    """

    written: ClassVar[str] = "beta k_1=regularisation.k_1 k_2=regularisation.k_2 c=regularisation.c side verdict"

    beta: fmpq | arb
    regularisation: Regularisation
    side: str | None
    verdict: Verdict

    def __str__(self) -> str:
        return str(self.verdict)


def limit_side(beta: ExactInput, contact: tuple[ExactInput, ExactInput, ExactInput] = (1, 1, 1)) -> LimitSide:
    """Lift-off or impact by the sign of C_1, for every mechanism of Case III, as epsilon tends to 0.

    ``beta`` may be a ball: then for every number in it. ``contact`` is (k_1, k_2, c). The starts lie at any distance
    from the G-spot on the way of a rigid slip motion into it; no slow manifold is assumed.

    :raises ValueError: beta is not certainly above 1, an integer, or above 10^6; the contact is none with a damper.

    >>> limit_side("3/2").side, limit_side("5/2").side
    ('impact', 'lift-off')
    """
    number, springs = exact(beta, "beta"), Regularisation.of(*contact)
    if not number > 1 or (isinstance(number, fmpq) and number.q == 1):
        raise ValueError(f"beta must be above 1 and no integer, got {number}")
    if not number <= MAX_BETA:
        raise ValueError(f"beta must be at most {MAX_BETA}")
    statement, rule = _statement(number, springs), rule_of(number, springs)  # ValueError without a damper
    if rule is None:
        why, text = "the ball of beta holds an integer, or may hold one", "lift-off or impact by the sign of C_1"
        return LimitSide(number, springs, None, Verdict.undecided(f"{statement} {text}", Reason.WIDE_INPUT, why))
    side, evidence = rule
    fates = {"lift-off": "it is lost", "impact": "lambda_N exceeds Lambda without it being lost"}
    by_sign = f"{statement} {fates[side]} if C_1 > 0, {fates[OTHER[side]]} if C_1 < 0"
    return LimitSide(number, springs, side, Verdict.proved(by_sign, evidence))


def rule_of(beta: fmpq | arb, springs: Regularisation) -> tuple[str, Evidence] | None:
    """The side of C_1 > 0 by Theorem R, that of Gamma(-beta) > 0 being "impact"; None where it is not certain that beta
    lies between two integers from 1 on, or that the contact has a damper."""
    if not beta <= MAX_BETA:  # its integer part may be too long to be written
        return None
    below = fmpz(beta.p // beta.q) if isinstance(beta, fmpq) else beta.floor().unique_fmpz()
    if below is None:
        return None
    shown = theorem(
        "proofs/papers_rule.md, Theorem R",
        *(less(1, beta), less(fmpq(below), beta), less(beta, fmpq(below) + 1)),
        *(less(0, number) for number in (springs.k_1, springs.k_2, springs.c)),
    )
    # n < beta < n + 1: Gamma(-beta) has the sign of (-1)^(n + 1)
    return None if shown is None else ("impact" if int(below) % 2 else "lift-off", shown)


def _statement(beta: fmpq | arb, springs: Regularisation) -> str:
    number = f"in {inner_text(beta)}" if isinstance(beta, arb) else f"= {beta}"
    return (
        "for every mechanism of Case III with analytic functions, p, b, y, v independent at its G-spot, "
        f"beta {number} and {contact_text(springs)}, and every family of starts in contact that tends to a state of "
        "a rigid slip motion into a G-spot with C_1 != 0, with y/epsilon^2, v/epsilon, lambda_N bounded and the limsup "
        "of (kappa p (v/epsilon)^2 + (b + p lambda_N)^2 + (g^2/l) p fast^2)/b^2 below 1, "
        f"{Contact.of(springs).fast_text}, and every force Lambda, there is an epsilon_0 > 0 such that for every "
        "0 < epsilon <= epsilon_0, as long as slip is positive, contact lasts until p < 0, and then"
    )
