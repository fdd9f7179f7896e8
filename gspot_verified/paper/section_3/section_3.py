"""Ledger of Section 3: which initial values lift off in the printed simulations, and which take an impact."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from flint import arb, fmpq

from gspot_verified.numbers.balls import ball_text, certainly_less, working_bits
from gspot_verified.paper.checks.entry import Builders, Check, Entry, Rung, Section, all_of
from gspot_verified.paper.section_3.contact_motion import BITS, force_by_single_equation, force_by_system

EPS = fmpq(1, 1000)
END = fmpq(7, 100)
"""Time after the G-spot at which the contact formula is evaluated."""
FACTORS = (fmpq(1, 4), fmpq(1, 2), fmpq(2), fmpq(4))
"""The simulated ν without the trivial solution ν = 1."""
MODERATE = 20
"""λ_N below this is no impact: its values on the trivial solution are 2 and 2/3."""
IMPACT = {"printed": {fmpq(3, 2): -1, fmpq(5, 2): 1}, "corrected": {fmpq(3, 2): 1, fmpq(5, 2): -1}}
"""By β, panels (b) and (c): the sign of b(0) minus that of the trivial solution for which an impact is taken."""

Forces = Callable[[fmpq], tuple[arb, ...]]


def mean_force(beta: fmpq) -> fmpq:
    """λ_N on the trivial solution, α_2/(α_3 - α_1)."""
    return 1 / (beta - 1)


def by_steps(beta: fmpq) -> tuple[arb, ...]:
    """The deviation of λ_N for ν = 2 at all steps until END, by the system."""
    return force_by_system(beta, EPS, END)


def at_the_end(beta: fmpq) -> tuple[arb, ...]:
    """The deviation of λ_N for ν = 2 at END, by the single equation."""
    return (force_by_single_equation(beta, EPS, END),)


def holds(impact: Mapping[fmpq, int], forces: Forces) -> bool | None:
    """Whether the stated side keeps a positive λ_N and the other side loses it, never above MODERATE."""
    answers: list[bool | None] = []
    for beta, side in impact.items():
        found = forces(beta)
        for factor in FACTORS:
            # b(0) is negative: a larger ν is a lower b(0).
            takes_impact = (1 if factor < 1 else -1) == side
            with working_bits(BITS):
                values = [arb(mean_force(beta)) + arb(factor - 1) * value for value in found]
                if takes_impact:
                    answers += [certainly_less(arb(0), value) for value in values]
                else:
                    answers += [certainly_less(value, arb(MODERATE)) for value in values]
                    answers.append(certainly_less(values[-1], arb(0)))
    return all_of(answers)


def _check(what: str, forces: Forces) -> Check:
    agrees = holds(IMPACT["printed"], forces)
    if agrees is False and holds(IMPACT["corrected"], forces) is not True:
        agrees = None
    with working_bits(BITS):
        force = arb(mean_force(fmpq(3, 2))) + forces(fmpq(3, 2))[-1]
        above = force.ceil().unique_fmpz()
    pull = f"a force below {above}" if above is not None else f"the force {ball_text(force, 8)}"
    finding = (
        f"β = 3/2, ν = 2 (a lower b(0)): at t = {END} after the G-spot contact would need {pull}: it has lifted off"
    )
    return Rung.BALLS.check(what, agrees, finding)


def _sides() -> Entry:
    return Section("Section 3").settled(
        "3-sides",
        "lines 782 to 785",
        r"\text{lower } b(0) \text{ take an impact in panel (b)},\ \text{higher } b(0) \text{ in panel (c)}",
        "At ε = 1/1000, of the starts ν = 1/4, 1/2, 2, 4, those with b(0) below that of the trivial solution take an "
        "impact without a lift-off before it for β = 3/2, and those with b(0) above it for β = 5/2",
        _check(
            "proofs/contact_motion.md, section 1: λ_N from the system, in steps of 3/100 until 7/100 after", by_steps
        ),
        _check("proofs/contact_motion.md, section 2: λ_N from modelSysDev, one series at the G-spot", at_the_end),
        corrected="β = 3/2: those above it take an impact, those below lift off first; β = 5/2: the other way round. "
        "The sentence is right for |b(0)|, as all b(0) are negative",
        note="That the others take an impact, for every ε up to 1/100 or 1/500: 3-varsim1b-1_4, 3-varsim1b-1_2, "
        "3-varsim1c-2, 3-varsim1c-4. The runs that lift off take an impact afterwards: 3-after-lift-off. For ε → 0 "
        "this is the side of Sec. 4.5: an impact for C_1/Γ(-β) > 0, Γ(-3/2) > 0 > Γ(-5/2).",
    )


ENTRIES: Builders = {"3-sides": _sides}
"""The sentence on panels (b) and (c)."""
