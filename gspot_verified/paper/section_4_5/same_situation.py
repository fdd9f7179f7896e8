"""Ledger of Section 4.5: the side of the impact in Case III, held against Cases I and II."""

from __future__ import annotations

from flint import arb, fmpq

from gspot_verified.numbers.balls import sign_of, working_bits
from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section
from gspot_verified.paper.checks.formulas import mended
from gspot_verified.paper.section_4_5.section_4_5_signs import PRINTED as SIGNS
from gspot_verified.signs.gamma.side import gamma_sign
from gspot_verified.theta_function.value.evaluate import evaluate

BETA = fmpq(3, 2)
"""In Case III, and β < 4."""
FORCE = {"printed": {"far left": 1, "zero": 1}, "corrected": {"far left": -1, "zero": -1}}
"""The signs of the deviation of λ_N; as printed those of Cases I and II."""


def sign_of_the_coefficient() -> int | None:
    """C_1 on the side of the impact: the sign of Γ(-β); in Cases I and II it is negative."""
    return gamma_sign(BETA)


def is_so_far_left(form: str) -> bool | None:
    """Whether C_1 dΘ/dτ has the stated sign for τ large and negative, where dΘ/dτ < 0."""
    found = sign_of_the_coefficient()
    return None if found is None else found * int(SIGNS["S-minus-infinity"]["sign"]) == FORCE[form]["far left"]


def is_so_at_zero(form: str) -> bool | None:
    """The same at τ = 0, with an enclosure of dΘ/dτ."""
    slope, found = sign_of(evaluate(0, BETA, derivative=1).value), sign_of_the_coefficient()
    return None if slope is None or found is None else found * slope == FORCE[form]["zero"]


def is_so_by_the_initial_value(form: str) -> bool | None:
    """The same by eq. t02: C_1/Γ(-β) > 0 on this side, so C_1 times dΘ/dτ at 0 has the sign of Γ((1-β)/3)."""
    with working_bits(64):
        found = sign_of(arb((1 - BETA) / 3).gamma())
    return None if found is None else found == FORCE[form]["zero"]


def _same_situation() -> Entry:
    forms = ("printed", "corrected")
    return Section("Section 4.5").settled(
        "S-same-situation",
        "lines 1304 to 1305",
        r"\text{for the other sign of }C_1\Gamma(-\beta)\text{ we are in the same situation as above}",
        "Case III on the side of the impact is in the situation of Cases I and II: the deviation of λ_N is positive "
        "at τ → -∞, 0 and ∞",
        Rung.EXACT.check(
            f"β = {BETA}, τ → -∞: C_1 has the sign of Γ(-β), and dΘ/dτ < 0 (S-minus-infinity)",
            mended(*map(is_so_far_left, forms)),
            "C_1 > 0, so the deviation of λ_N is negative there",
        ),
        Rung.BALLS.check(
            f"β = {BETA}, τ = 0: an enclosure of dΘ/dτ",
            mended(*map(is_so_at_zero, forms)),
            "dΘ/dτ < 0 there, so the deviation of λ_N is negative and that of y positive",
        ),
        Rung.BALLS.check(
            f"β = {BETA}, τ = 0: Γ((1-β)/3), of which C_1 dΘ/dτ has the sign by the initial value",
            mended(*map(is_so_by_the_initial_value, forms)),
            "it is negative, so the deviation of λ_N is negative and that of y positive",
        ),
        corrected="An impact occurs, for another reason: from a given τ_0 on, for small ε, the mean force, which is "
        "positive, dominates until the deviation is large, and that is positive (S-iwc-case-III). On this side y\u0302 "
        f"is positive at s = 0 for β = {BETA}; in Cases I and II it is negative",
        note="At τ = 0 the sign is that of Γ((1-β)/3) on this side: negative for every β in (1, 4).",
    )


ENTRIES: Builders = {"S-same-situation": _same_situation}
"""The side of the impact in Case III."""
